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

struct mask_BitsPlace {
    light: lt_mask_LightPlace,
    words: u32,
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
var<storage> last_depths: type_21;
@group(0) @binding(7) 
var<storage, read_write> depths: type_21;
@group(0) @binding(8) 
var<storage> past: type_44;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_183_: lt_mask_LightPlace;
    var phi_184_: bool;
    var phi_185_: lt_mask_LightPlace;
    var phi_186_: bool;
    var phi_191_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_183_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_184_ = false;
        } else {
            phi_183_ = lt_mask_LightPlace();
            phi_184_ = true;
        }
        let _e73 = phi_183_;
        let _e75 = phi_184_;
        phi_185_ = _e73;
        phi_186_ = _e75;
    } else {
        phi_185_ = lt_mask_LightPlace();
        phi_186_ = true;
    }
    let _e77 = phi_185_;
    let _e79 = phi_186_;
    if _e79 {
        phi_191_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_191_ = _e77;
    }
    let _e84 = phi_191_;
    return lt_mask_LightPlace(_e84.word, _e84.shift);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_209_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_209_ = vec2(0i);
            break;
        }
        case 1: {
            phi_209_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_209_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_209_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_209_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e69 = phi_209_;
    return vec2<i32>(_e69.x, _e69.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_227_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_227_ = vec2(0i);
            break;
        }
        case 1: {
            phi_227_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_227_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_227_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_227_ = vec2(1i);
            break;
        }
    }
    let _e69 = phi_227_;
    return vec2<i32>(_e69.x, _e69.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_246_: vec2<i32>;

    if (param_6 == 0u) {
        let _e63 = lt_mask_pattern_plus(param_5);
        phi_246_ = vec2<i32>(_e63.x, _e63.y);
    } else {
        let _e67 = lt_mask_pattern_cross(param_5);
        phi_246_ = vec2<i32>(_e67.x, _e67.y);
    }
    let _e72 = phi_246_;
    return vec2<i32>(_e72.x, _e72.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_271_: vec2<i32>;

    let _e61 = (param_7 % 13u);
    switch bitcast<i32>(_e61) {
        case 9: {
            phi_271_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_271_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_271_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_271_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_271_ = vec2<i32>((bitcast<i32>((_e61 % 3u)) - 1i), (bitcast<i32>(((_e61 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e76 = phi_271_;
    return vec2<i32>(_e76.x, _e76.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_292_: u32;
    var phi_293_: u32;

    let _e64 = (bitcast<i32>(param_8) + param_9);
    if (_e64 < 0i) {
        phi_293_ = 0u;
    } else {
        if (_e64 >= bitcast<i32>(param_10)) {
            phi_292_ = (param_10 - 1u);
        } else {
            phi_292_ = bitcast<u32>(_e64);
        }
        let _e71 = phi_292_;
        phi_293_ = _e71;
    }
    let _e73 = phi_293_;
    return _e73;
}

fn function_() {
    var phi_374_: bool;
    var phi_375_: bool;
    var phi_376_: bool;
    var phi_377_: bool;
    var phi_381_: bool;
    var phi_451_: bool;
    var phi_452_: bool;
    var phi_463_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_464_: bool;
    var phi_465_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_466_: bool;
    var phi_473_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_477_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_490_: bool;
    var phi_695_: f32;
    var phi_700_: f32;
    var phi_701_: bool;
    var phi_702_: f32;
    var phi_703_: bool;
    var phi_707_: f32;
    var phi_728_: f32;
    var phi_733_: f32;
    var phi_734_: bool;
    var phi_735_: f32;
    var phi_736_: bool;
    var phi_740_: f32;
    var phi_761_: bool;
    var phi_780_: vec2<u32>;
    var phi_781_: bool;
    var phi_782_: bool;
    var phi_783_: bool;
    var phi_784_: vec2<u32>;
    var phi_785_: bool;
    var phi_786_: bool;
    var phi_787_: bool;
    var phi_788_: bool;
    var phi_789_: bool;
    var phi_790_: bool;
    var phi_791_: vec2<u32>;
    var phi_792_: bool;
    var phi_793_: bool;
    var phi_794_: bool;
    var phi_795_: bool;
    var phi_796_: bool;
    var phi_797_: bool;
    var phi_798_: vec2<u32>;
    var phi_799_: bool;
    var phi_800_: bool;
    var phi_801_: bool;
    var phi_802_: bool;
    var phi_811_: bool;
    var phi_812_: bool;
    var phi_813_: bool;
    var phi_814_: bool;
    var phi_818_: bool;
    var phi_819_: bool;
    var phi_820_: vec2<u32>;
    var phi_903_: bool;
    var phi_907_: f32;
    var phi_911_: lt_mask_Reprojection;
    var phi_920_: bool;
    var phi_921_: bool;
    var phi_923_: bool;
    var phi_924_: lt_mask_Reprojection;
    var phi_925_: lt_mask_Reprojection;
    var phi_926_: bool;
    var phi_930_: bool;
    var phi_931_: lt_mask_Reprojection;
    var phi_974_: u32;
    var phi_993_: u32;
    var phi_1001_: u32;
    var phi_1002_: u32;
    var phi_1003_: bool;
    var phi_1004_: u32;
    var phi_1005_: bool;
    var phi_1006_: bool;
    var phi_1007_: u32;
    var phi_1008_: bool;
    var phi_1009_: bool;
    var phi_1013_: bool;
    var phi_1017_: u32;
    var phi_1022_: bool;
    var phi_1044_: u32;
    var phi_1046_: u32;
    var phi_1049_: lt_mask_Neighbourhood;
    var phi_1061_: bool;
    var phi_1062_: bool;
    var phi_1071_: u32;
    var phi_1072_: u32;
    var phi_1132_: vec2<i32>;
    var phi_1152_: vec2<i32>;
    var phi_1179_: u32;
    var phi_1198_: u32;
    var phi_1206_: u32;
    var phi_1232_: bool;
    var phi_1233_: bool;
    var phi_1234_: bool;
    var phi_1235_: bool;
    var phi_1236_: bool;
    var phi_1237_: bool;
    var phi_1238_: bool;
    var phi_1243_: bool;
    var phi_1244_: bool;
    var phi_1245_: bool;
    var phi_1246_: bool;
    var phi_1247_: bool;
    var phi_1248_: bool;
    var phi_1249_: bool;
    var phi_1250_: bool;
    var phi_1251_: bool;
    var phi_1266_: bool;
    var phi_1267_: bool;
    var phi_1274_: bool;
    var phi_1275_: bool;
    var phi_1276_: bool;
    var phi_1277_: bool;
    var phi_1278_: bool;
    var phi_1282_: bool;
    var phi_1283_: bool;
    var phi_1284_: bool;
    var phi_1288_: bool;
    var phi_1289_: bool;
    var phi_1293_: bool;
    var phi_1294_: bool;
    var phi_1312_: bool;
    var phi_1313_: bool;
    var phi_1314_: bool;
    var phi_1047_: u32;
    var phi_1050_: lt_mask_Neighbourhood;
    var phi_1317_: lt_mask_Neighbourhood;
    var phi_1318_: lt_mask_Neighbourhood;
    var phi_1319_: lt_mask_Neighbourhood;
    var phi_1351_: bool;
    var phi_1352_: bool;
    var phi_1374_: bool;
    var phi_1375_: bool;
    var phi_1376_: bool;
    var phi_1380_: bool;
    var phi_1402_: bool;
    var phi_1403_: bool;
    var phi_1416_: bool;
    var phi_1417_: bool;
    var phi_1418_: bool;
    var phi_1425_: u32;
    var phi_1426_: u32;
    var phi_1427_: u32;
    var phi_1428_: u32;
    var phi_1429_: u32;
    var phi_1430_: u32;
    var phi_1431_: u32;
    var phi_1443_: bool;
    var phi_1444_: bool;
    var phi_1445_: bool;
    var phi_1446_: bool;
    var phi_1450_: bool;
    var phi_1456_: bool;
    var phi_1464_: u32;
    var phi_1469_: u32;
    var phi_1478_: u32;
    var phi_1483_: u32;
    var phi_1487_: u32;
    var phi_1488_: u32;
    var phi_1489_: u32;
    var phi_1493_: f32;
    var phi_1495_: mask_Masked;
    var phi_1567_: bool;
    var phi_1568_: bool;
    var phi_1569_: bool;
    var phi_1570_: bool;
    var phi_1574_: bool;
    var phi_1602_: f32;
    var phi_1605_: bool;
    var phi_1606_: u32;
    var phi_1617_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e60 = id_1;
    let _e61 = local_2;
    let _e66 = arrayLength((&last_bits.member));
    let _e78 = p.member.current.size[0u];
    let _e80 = p.member.current.size[1u];
    let _e81 = lt_shaders_entry_pixel_index(_e60, _e78, _e80);
    if (bitcast<i32>(_e81.word) != 0i) {
        let _e88 = p.member.light.number;
        let _e89 = (_e88 * 3u);
        let _e93 = p.member.light.mask_words;
        let _e99 = mask_BitsPlace(lt_mask_LightPlace((_e89 / 32u), mask_BitsPlace().light.shift), mask_BitsPlace().words);
        let _e105 = mask_BitsPlace(lt_mask_LightPlace(_e99.light.word, (_e89 % 32u)), _e99.words);
        let _e108 = mask_BitsPlace(_e105.light, _e93);
        let _e112 = p.member.current.size[0u];
        let _e115 = past.member[_e81.shift];
        let _e120 = visibility.member[_e81.shift];
        let _e126 = samples.member[_e81.shift].normal[0u];
        let _e128 = global[0u];
        if (_e126 == _e128) {
            let _e131 = samples.member[_e81.shift].normal[1u];
            let _e133 = global[1u];
            if (_e131 == _e133) {
                let _e136 = samples.member[_e81.shift].normal[2u];
                let _e138 = global[2u];
                phi_374_ = (_e136 == _e138);
                phi_375_ = false;
            } else {
                phi_374_ = bool();
                phi_375_ = true;
            }
            let _e141 = phi_374_;
            let _e143 = phi_375_;
            phi_376_ = _e141;
            phi_377_ = _e143;
        } else {
            phi_376_ = bool();
            phi_377_ = true;
        }
        let _e145 = phi_376_;
        let _e147 = phi_377_;
        if _e147 {
            phi_381_ = false;
        } else {
            phi_381_ = _e145;
        }
        let _e149 = phi_381_;
        if !(_e149) {
            let _e152 = samples.member[_e81.shift].position;
            let _e154 = p.member.light.place;
            let _e160 = p.member.light.place[3u];
            let _e167 = (_e154.x - (_e152.x * _e160));
            let _e168 = (_e154.y - (_e152.y * _e160));
            let _e169 = (_e154.z - (_e152.z * _e160));
            let _e171 = samples.member[_e81.shift].normal;
            if ((((_e171.x * _e167) + (_e171.y * _e168)) + (_e171.z * _e169)) > 0f) {
                let _e185 = (((_e167 * _e167) + (_e168 * _e168)) + (_e169 * _e169));
                let _e187 = p.member.light.axis;
                let _e199 = p.member.light.place[3u];
                if (_e199 == 0f) {
                    phi_452_ = true;
                } else {
                    let _e202 = p.member.light.range_squared;
                    if (_e185 <= _e202) {
                        let _e205 = p.member.light.cos_outer;
                        phi_451_ = (-((((_e167 * _e187.x) + (_e168 * _e187.y)) + (_e169 * _e187.z))) >= (_e205 * sqrt(_e185)));
                    } else {
                        phi_451_ = false;
                    }
                    let _e210 = phi_451_;
                    phi_452_ = _e210;
                }
                let _e212 = phi_452_;
                if _e212 {
                    let _e214 = samples.member[_e81.shift].flags;
                    let _e222 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e228 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e222.unnamed.visibility, false), _e222.unnamed_1);
                    phi_463_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e228.unnamed, ((_e214 & 1u) == 0u));
                    phi_464_ = false;
                } else {
                    phi_463_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_464_ = true;
                }
                let _e233 = phi_463_;
                let _e235 = phi_464_;
                phi_465_ = _e233;
                phi_466_ = _e235;
            } else {
                phi_465_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_466_ = true;
            }
            let _e237 = phi_465_;
            let _e239 = phi_466_;
            if _e239 {
                let _e245 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e251 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e245.unnamed.visibility, false), _e245.unnamed_1);
                phi_473_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e251.unnamed, true);
            } else {
                phi_473_ = _e237;
            }
            let _e256 = phi_473_;
            phi_477_ = _e256;
        } else {
            let _e262 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e268 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e262.unnamed.visibility, false), _e262.unnamed_1);
            phi_477_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e268.unnamed, true);
        }
        let _e273 = phi_477_;
        if _e273.unnamed_1 {
            phi_1495_ = mask_Masked(_e273.unnamed.visibility, 0u, false);
        } else {
            let _e278 = (_e120 < 0.5f);
            if (_e120 > 0f) {
                phi_490_ = (_e120 < 1f);
            } else {
                phi_490_ = false;
            }
            let _e282 = phi_490_;
            let _e284 = samples.member[_e81.shift].position;
            let _e288 = p.member.previous.eye;
            let _e290 = (_e115.x - _e288.x);
            let _e292 = (_e115.y - _e288.y);
            let _e294 = (_e115.z - _e288.z);
            let _e296 = p.member.previous.forward;
            let _e304 = (((_e290 * _e296.x) + (_e292 * _e296.y)) + (_e294 * _e296.z));
            let _e306 = p.member.previous.right;
            let _e316 = p.member.previous.right;
            let _e331 = p.member.previous.up;
            let _e341 = p.member.previous.up;
            let _e356 = p.member.current.eye;
            let _e359 = (_e284.x - _e356.x);
            let _e362 = (_e284.y - _e356.y);
            let _e365 = (_e284.z - _e356.z);
            let _e367 = p.member.current.forward;
            let _e375 = (((_e359 * _e367.x) + (_e362 * _e367.y)) + (_e365 * _e367.z));
            let _e377 = p.member.current.right;
            let _e387 = p.member.current.right;
            let _e402 = p.member.current.up;
            let _e412 = p.member.current.up;
            let _e431 = p.member.current.size[0u];
            let _e433 = (((((((_e290 * _e306.x) + (_e292 * _e306.y)) + (_e294 * _e306.z)) / ((((_e316.x * _e316.x) + (_e316.y * _e316.y)) + (_e316.z * _e316.z)) * _e304)) - ((((_e359 * _e377.x) + (_e362 * _e377.y)) + (_e365 * _e377.z)) / ((((_e387.x * _e387.x) + (_e387.y * _e387.y)) + (_e387.z * _e387.z)) * _e375))) * 0.5f) * f32(_e431));
            let _e437 = p.member.current.size[1u];
            let _e439 = (((((((_e290 * _e331.x) + (_e292 * _e331.y)) + (_e294 * _e331.z)) / ((((_e341.x * _e341.x) + (_e341.y * _e341.y)) + (_e341.z * _e341.z)) * _e304)) - ((((_e359 * _e402.x) + (_e362 * _e402.y)) + (_e365 * _e402.z)) / ((((_e412.x * _e412.x) + (_e412.y * _e412.y)) + (_e412.z * _e412.z)) * _e375))) * -0.5f) * f32(_e437));
            let _e443 = p.member.current.grid[0u];
            let _e445 = p.member.current.grid[1u];
            let _e465 = p.member.current.size[0u];
            let _e467 = p.member.current.size[1u];
            let _e469 = ((f32(_e60.x) + ((f32((_e60.y & (_e445 - 1u))) + 0.5f) / f32(_e445))) + _e433);
            if (_e469 > -8388608f) {
                let _e481 = f32(select(0i, select(select(i32(_e469), i32(-2147483648), (_e469 < bitcast<f32>(3472883712u))), 2147483647i, (_e469 > bitcast<f32>(1325400063u))), (_e469 == _e469)));
                if (_e481 > _e469) {
                    phi_695_ = 1f;
                } else {
                    phi_695_ = 0f;
                }
                let _e484 = phi_695_;
                if (_e469 < 8388608f) {
                    phi_700_ = (_e481 - _e484);
                    phi_701_ = false;
                } else {
                    phi_700_ = f32();
                    phi_701_ = true;
                }
                let _e487 = phi_700_;
                let _e489 = phi_701_;
                phi_702_ = _e487;
                phi_703_ = _e489;
            } else {
                phi_702_ = f32();
                phi_703_ = true;
            }
            let _e491 = phi_702_;
            let _e493 = phi_703_;
            if _e493 {
                phi_707_ = _e469;
            } else {
                phi_707_ = _e491;
            }
            let _e495 = phi_707_;
            let _e496 = ((f32(_e60.y) + ((f32((_e60.x & (_e443 - 1u))) + 0.5f) / f32(_e443))) + _e439);
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
            if (_e495 >= 0f) {
                if (_e522 >= 0f) {
                    if (_e495 < f32(_e465)) {
                        let _e528 = (_e522 < f32(_e467));
                        if (_e433 == 0f) {
                            phi_761_ = (_e439 == 0f);
                        } else {
                            phi_761_ = false;
                        }
                        let _e532 = phi_761_;
                        if _e528 {
                            phi_780_ = vec2<u32>(select(select(u32(_e495), 0u, (_e495 < bitcast<f32>(0u))), 4294967295u, (_e495 > bitcast<f32>(1333788671u))), select(select(u32(_e522), 0u, (_e522 < bitcast<f32>(0u))), 4294967295u, (_e522 > bitcast<f32>(1333788671u))));
                            phi_781_ = false;
                        } else {
                            phi_780_ = vec2<u32>();
                            phi_781_ = true;
                        }
                        let _e549 = phi_780_;
                        let _e551 = phi_781_;
                        phi_782_ = _e532;
                        phi_783_ = _e528;
                        phi_784_ = _e549;
                        phi_785_ = _e532;
                        phi_786_ = _e528;
                        phi_787_ = false;
                        phi_788_ = _e551;
                    } else {
                        phi_782_ = bool();
                        phi_783_ = bool();
                        phi_784_ = vec2<u32>();
                        phi_785_ = bool();
                        phi_786_ = bool();
                        phi_787_ = true;
                        phi_788_ = false;
                    }
                    let _e553 = phi_782_;
                    let _e555 = phi_783_;
                    let _e557 = phi_784_;
                    let _e559 = phi_785_;
                    let _e561 = phi_786_;
                    let _e563 = phi_787_;
                    let _e565 = phi_788_;
                    phi_789_ = _e553;
                    phi_790_ = _e555;
                    phi_791_ = _e557;
                    phi_792_ = _e559;
                    phi_793_ = _e561;
                    phi_794_ = _e563;
                    phi_795_ = _e565;
                } else {
                    phi_789_ = bool();
                    phi_790_ = bool();
                    phi_791_ = vec2<u32>();
                    phi_792_ = bool();
                    phi_793_ = bool();
                    phi_794_ = true;
                    phi_795_ = false;
                }
                let _e567 = phi_789_;
                let _e569 = phi_790_;
                let _e571 = phi_791_;
                let _e573 = phi_792_;
                let _e575 = phi_793_;
                let _e577 = phi_794_;
                let _e579 = phi_795_;
                phi_796_ = _e567;
                phi_797_ = _e569;
                phi_798_ = _e571;
                phi_799_ = _e573;
                phi_800_ = _e575;
                phi_801_ = _e577;
                phi_802_ = _e579;
            } else {
                phi_796_ = bool();
                phi_797_ = bool();
                phi_798_ = vec2<u32>();
                phi_799_ = bool();
                phi_800_ = bool();
                phi_801_ = true;
                phi_802_ = false;
            }
            let _e581 = phi_796_;
            let _e583 = phi_797_;
            let _e585 = phi_798_;
            let _e587 = phi_799_;
            let _e589 = phi_800_;
            let _e591 = phi_801_;
            let _e593 = phi_802_;
            if _e591 {
                if (_e433 == 0f) {
                    phi_811_ = (_e439 == 0f);
                } else {
                    phi_811_ = false;
                }
                let _e597 = phi_811_;
                phi_812_ = _e597;
                phi_813_ = false;
                phi_814_ = true;
            } else {
                phi_812_ = _e587;
                phi_813_ = _e589;
                phi_814_ = _e593;
            }
            let _e599 = phi_812_;
            let _e601 = phi_813_;
            let _e603 = phi_814_;
            if _e603 {
                phi_818_ = _e599;
                phi_819_ = _e601;
                phi_820_ = vec2<u32>(_e60.x, _e60.y);
            } else {
                phi_818_ = _e581;
                phi_819_ = _e583;
                phi_820_ = _e585;
            }
            let _e605 = phi_818_;
            let _e607 = phi_819_;
            let _e609 = phi_820_;
            let _e619 = lt_mask_Reprojection(vec2<u32>(_e609.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e626 = lt_mask_Reprojection(vec2<u32>(_e619.pixel.x, _e609.y), _e619.is_valid, _e619.has_moved);
            let _e630 = lt_mask_Reprojection(_e626.pixel, _e607, _e626.has_moved);
            let _e634 = lt_mask_Reprojection(_e630.pixel, _e630.is_valid, !(_e605));
            if _e607 {
                let _e637 = p.member.previous.eye;
                let _e645 = p.member.previous.forward;
                let _e654 = (((((_e115.x - _e637.x) * _e645.x) + ((_e115.y - _e637.y) * _e645.y)) + ((_e115.z - _e637.z) * _e645.z)) > 0f);
                let _e658 = lt_mask_Reprojection(_e634.pixel, _e654, _e634.has_moved);
                if _e654 {
                    let _e661 = p.member.previous.eye;
                    let _e669 = p.member.previous.forward;
                    let _e677 = ((((_e115.x - _e661.x) * _e669.x) + ((_e115.y - _e661.y) * _e669.y)) + ((_e115.z - _e661.z) * _e669.z));
                    let _e679 = ((_e609.y * _e112) + _e609.x);
                    if (_e679 < arrayLength((&last_depths.member))) {
                    } else {
                        return;
                    }
                    let _e683 = last_depths.member[(0u + _e679)];
                    let _e685 = p.member.depth_tolerance;
                    let _e688 = abs(_e677);
                    let _e689 = abs(_e683);
                    if ((bitcast<u32>(_e689) & 2147483647u) > 2139095040u) {
                        phi_903_ = true;
                    } else {
                        let _e693 = (_e689 > _e688);
                        if _e693 {
                        }
                        phi_903_ = _e693;
                    }
                    let _e695 = phi_903_;
                    if _e695 {
                        phi_907_ = _e689;
                    } else {
                        phi_907_ = _e688;
                    }
                    let _e697 = phi_907_;
                    phi_911_ = lt_mask_Reprojection(_e658.pixel, (abs((_e677 - _e683)) <= (_e685 * _e697)), _e658.has_moved);
                } else {
                    phi_911_ = _e658;
                }
                let _e705 = phi_911_;
                if _e705.is_valid {
                    let _e708 = p.member.flags;
                    phi_920_ = ((_e708 & 1u) != 0u);
                    phi_921_ = false;
                } else {
                    phi_920_ = bool();
                    phi_921_ = true;
                }
                let _e712 = phi_920_;
                let _e714 = phi_921_;
                phi_923_ = _e712;
                phi_924_ = _e705;
                phi_925_ = _e705;
                phi_926_ = _e714;
            } else {
                phi_923_ = bool();
                phi_924_ = lt_mask_Reprojection();
                phi_925_ = lt_mask_Reprojection(_e634.pixel, false, _e634.has_moved);
                phi_926_ = true;
            }
            let _e720 = phi_923_;
            let _e722 = phi_924_;
            let _e724 = phi_925_;
            let _e726 = phi_926_;
            if _e726 {
                phi_930_ = false;
                phi_931_ = _e724;
            } else {
                phi_930_ = _e720;
                phi_931_ = _e722;
            }
            let _e728 = phi_930_;
            let _e730 = phi_931_;
            let _e734 = lt_mask_Reprojection(_e730.pixel, _e728, _e730.has_moved);
            let _e736 = p.member.flags;
            let _e738 = ((_e736 & 2u) != 0u);
            let _e740 = p.member.flags;
            if ((_e740 & 4u) == 0u) {
                phi_1007_ = u32();
                phi_1008_ = true;
                phi_1009_ = false;
            } else {
                if _e728 {
                    if !(_e734.has_moved) {
                        let _e751 = ((((_e60.y * _e112) + _e60.x) * _e108.words) + _e108.light.word);
                        if (_e108.light.shift > 29u) {
                            let _e755 = (_e751 + 1u);
                            if (_e755 < _e66) {
                            } else {
                                return;
                            }
                            let _e759 = last_bits.member[(0u + _e755)];
                            phi_974_ = _e759;
                        } else {
                            phi_974_ = 0u;
                        }
                        let _e761 = phi_974_;
                        if (_e751 < _e66) {
                        } else {
                            return;
                        }
                        let _e767 = last_bits.member[(0u + _e751)];
                        let _e770 = (_e767 >> bitcast<u32>((_e108.light.shift & 31u)));
                        if (_e108.light.shift > 29u) {
                            phi_993_ = (_e770 | (_e761 << bitcast<u32>(((32u - _e108.light.shift) & 31u))));
                        } else {
                            phi_993_ = _e770;
                        }
                        let _e778 = phi_993_;
                        if ((_e778 & 2u) == 0u) {
                            phi_1001_ = (_e778 & 1u);
                        } else {
                            phi_1001_ = (_e778 & 7u);
                        }
                        let _e784 = phi_1001_;
                        phi_1002_ = _e784;
                        phi_1003_ = false;
                    } else {
                        phi_1002_ = u32();
                        phi_1003_ = true;
                    }
                    let _e786 = phi_1002_;
                    let _e788 = phi_1003_;
                    phi_1004_ = _e786;
                    phi_1005_ = false;
                    phi_1006_ = _e788;
                } else {
                    phi_1004_ = u32();
                    phi_1005_ = true;
                    phi_1006_ = false;
                }
                let _e790 = phi_1004_;
                let _e792 = phi_1005_;
                let _e794 = phi_1006_;
                phi_1007_ = _e790;
                phi_1008_ = _e792;
                phi_1009_ = _e794;
            }
            let _e796 = phi_1007_;
            let _e798 = phi_1008_;
            let _e800 = phi_1009_;
            if _e798 {
                phi_1013_ = true;
            } else {
                phi_1013_ = _e800;
            }
            let _e802 = phi_1013_;
            if _e802 {
                phi_1017_ = 0u;
            } else {
                phi_1017_ = _e796;
            }
            let _e804 = phi_1017_;
            let _e805 = lt_mask_Neighbourhood(false, true);
            if _e282 {
                phi_1022_ = _e738;
            } else {
                phi_1022_ = false;
            }
            let _e807 = phi_1022_;
            if _e807 {
                if _e728 {
                    if ((_e804 & 2u) != 0u) {
                        phi_1317_ = _e805;
                    } else {
                        let _e811 = p.member.expansion;
                        if _e734.has_moved {
                            let _e814 = p.member.moving_pattern;
                            phi_1044_ = _e814;
                        } else {
                            let _e816 = p.member.still_pattern;
                            phi_1044_ = _e816;
                        }
                        let _e818 = phi_1044_;
                        phi_1046_ = 0u;
                        phi_1049_ = _e805;
                        loop {
                            let _e820 = phi_1046_;
                            let _e822 = phi_1049_;
                            local_1 = _e822;
                            if (1u <= _e818) {
                                if (_e818 <= 4u) {
                                    phi_1061_ = false;
                                } else {
                                    phi_1061_ = true;
                                }
                                let _e826 = phi_1061_;
                                phi_1062_ = _e826;
                            } else {
                                phi_1062_ = true;
                            }
                            let _e828 = phi_1062_;
                            if _e828 {
                                switch bitcast<i32>(_e818) {
                                    case 5: {
                                        phi_1071_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_1071_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_1071_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_1071_ = 9u;
                                        break;
                                    }
                                }
                                let _e831 = phi_1071_;
                                phi_1072_ = _e831;
                            } else {
                                phi_1072_ = 5u;
                            }
                            let _e833 = phi_1072_;
                            let _e834 = (_e820 < _e833);
                            if _e834 {
                                let _e840 = p.member.frame;
                                let _e844 = p.member.current.size[0u];
                                let _e846 = p.member.current.size[1u];
                                switch bitcast<i32>(_e818) {
                                    case 1: {
                                        let _e856 = lt_mask_pattern_plus(_e820);
                                        phi_1152_ = vec2<i32>(_e856.x, _e856.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e860 = lt_mask_pattern_cross(_e820);
                                        phi_1152_ = vec2<i32>(_e860.x, _e860.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e866 = lt_mask_pattern_plus_or_cross(_e820, ((_e734.pixel.x + _e734.pixel.y) & 1u));
                                        phi_1152_ = vec2<i32>(_e866.x, _e866.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e871 = lt_mask_pattern_plus_or_cross(_e820, (_e840 & 1u));
                                        phi_1152_ = vec2<i32>(_e871.x, _e871.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e840 & 3u)) {
                                            case 0: {
                                                phi_1132_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_1132_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_1132_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_1132_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e882 = phi_1132_;
                                        phi_1152_ = (_e882 + vec2<i32>(bitcast<i32>((_e820 & 1u)), bitcast<i32>(((_e820 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_1152_ = vec2<i32>((bitcast<i32>((_e820 % 5u)) - 2i), (bitcast<i32>(((_e820 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e899 = lt_mask_pattern_diamond(_e820);
                                        phi_1152_ = vec2<i32>(_e899.x, _e899.y);
                                        break;
                                    }
                                    default: {
                                        phi_1152_ = vec2<i32>((bitcast<i32>((_e820 % 3u)) - 1i), (bitcast<i32>(((_e820 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e904 = phi_1152_;
                                let _e907 = lt_mask_pattern_step_clamped(_e734.pixel.x, _e904.x, _e844);
                                let _e908 = lt_mask_pattern_step_clamped(_e734.pixel.y, _e904.y, _e846);
                                let _e915 = ((((_e908 * _e112) + _e907) * _e108.words) + _e108.light.word);
                                if (_e108.light.shift > 29u) {
                                    let _e919 = (_e915 + 1u);
                                    if (_e919 < _e66) {
                                    } else {
                                        return;
                                    }
                                    let _e923 = last_bits.member[(0u + _e919)];
                                    phi_1179_ = _e923;
                                } else {
                                    phi_1179_ = 0u;
                                }
                                let _e925 = phi_1179_;
                                if (_e915 < _e66) {
                                } else {
                                    return;
                                }
                                let _e931 = last_bits.member[(0u + _e915)];
                                let _e934 = (_e931 >> bitcast<u32>((_e108.light.shift & 31u)));
                                if (_e108.light.shift > 29u) {
                                    phi_1198_ = (_e934 | (_e925 << bitcast<u32>(((32u - _e108.light.shift) & 31u))));
                                } else {
                                    phi_1198_ = _e934;
                                }
                                let _e942 = phi_1198_;
                                if ((_e942 & 2u) == 0u) {
                                    phi_1206_ = (_e942 & 1u);
                                } else {
                                    phi_1206_ = (_e942 & 7u);
                                }
                                let _e948 = phi_1206_;
                                if _e822.any_expands {
                                    phi_1294_ = true;
                                } else {
                                    if ((_e948 & 2u) != 0u) {
                                        let _e955 = (((_e948 & 4u) != 0u) != _e278);
                                        switch bitcast<i32>(_e811) {
                                            case 1: {
                                                phi_1234_ = bool();
                                                phi_1235_ = false;
                                                phi_1236_ = true;
                                                phi_1237_ = false;
                                                phi_1238_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e955 {
                                                    phi_1232_ = (((_e948 & 4u) != 0u) != ((_e948 & 1u) != 0u));
                                                    phi_1233_ = false;
                                                } else {
                                                    phi_1232_ = bool();
                                                    phi_1233_ = true;
                                                }
                                                let _e963 = phi_1232_;
                                                let _e965 = phi_1233_;
                                                phi_1234_ = _e963;
                                                phi_1235_ = false;
                                                phi_1236_ = false;
                                                phi_1237_ = _e965;
                                                phi_1238_ = _e955;
                                                break;
                                            }
                                            default: {
                                                phi_1234_ = bool();
                                                phi_1235_ = true;
                                                phi_1236_ = false;
                                                phi_1237_ = false;
                                                phi_1238_ = false;
                                                break;
                                            }
                                        }
                                        let _e967 = phi_1234_;
                                        let _e969 = phi_1235_;
                                        let _e971 = phi_1236_;
                                        let _e973 = phi_1237_;
                                        let _e975 = phi_1238_;
                                        phi_1246_ = _e955;
                                        phi_1247_ = _e967;
                                        phi_1248_ = _e969;
                                        phi_1249_ = _e971;
                                        phi_1250_ = _e973;
                                        phi_1251_ = _e975;
                                    } else {
                                        switch bitcast<i32>(_e811) {
                                            case 1: {
                                                phi_1243_ = false;
                                                phi_1244_ = true;
                                                phi_1245_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_1243_ = false;
                                                phi_1244_ = false;
                                                phi_1245_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_1243_ = true;
                                                phi_1244_ = false;
                                                phi_1245_ = false;
                                                break;
                                            }
                                        }
                                        let _e978 = phi_1243_;
                                        let _e980 = phi_1244_;
                                        let _e982 = phi_1245_;
                                        phi_1246_ = false;
                                        phi_1247_ = bool();
                                        phi_1248_ = _e978;
                                        phi_1249_ = _e980;
                                        phi_1250_ = _e982;
                                        phi_1251_ = false;
                                    }
                                    let _e984 = phi_1246_;
                                    let _e986 = phi_1247_;
                                    let _e988 = phi_1248_;
                                    let _e990 = phi_1249_;
                                    let _e992 = phi_1250_;
                                    let _e994 = phi_1251_;
                                    if _e988 {
                                        if ((_e948 & 2u) != 0u) {
                                            if (((_e948 & 4u) != 0u) != _e278) {
                                                phi_1266_ = false;
                                            } else {
                                                phi_1266_ = true;
                                            }
                                            let _e1001 = phi_1266_;
                                            phi_1267_ = _e1001;
                                        } else {
                                            phi_1267_ = true;
                                        }
                                        let _e1003 = phi_1267_;
                                        if _e1003 {
                                            phi_1274_ = (((_e948 & 1u) != 0u) != _e278);
                                        } else {
                                            phi_1274_ = true;
                                        }
                                        let _e1008 = phi_1274_;
                                        phi_1275_ = _e1008;
                                        phi_1276_ = false;
                                        phi_1277_ = false;
                                        phi_1278_ = false;
                                    } else {
                                        phi_1275_ = bool();
                                        phi_1276_ = _e990;
                                        phi_1277_ = _e992;
                                        phi_1278_ = _e994;
                                    }
                                    let _e1010 = phi_1275_;
                                    let _e1012 = phi_1276_;
                                    let _e1014 = phi_1277_;
                                    let _e1016 = phi_1278_;
                                    if _e1012 {
                                        phi_1282_ = _e984;
                                        phi_1283_ = false;
                                        phi_1284_ = false;
                                    } else {
                                        phi_1282_ = _e1010;
                                        phi_1283_ = _e1014;
                                        phi_1284_ = _e1016;
                                    }
                                    let _e1018 = phi_1282_;
                                    let _e1020 = phi_1283_;
                                    let _e1022 = phi_1284_;
                                    if _e1020 {
                                        phi_1288_ = false;
                                        phi_1289_ = true;
                                    } else {
                                        phi_1288_ = _e986;
                                        phi_1289_ = _e1022;
                                    }
                                    let _e1024 = phi_1288_;
                                    let _e1026 = phi_1289_;
                                    if _e1026 {
                                        phi_1293_ = _e1024;
                                    } else {
                                        phi_1293_ = _e1018;
                                    }
                                    let _e1028 = phi_1293_;
                                    phi_1294_ = _e1028;
                                }
                                let _e1030 = phi_1294_;
                                if _e822.all_remove {
                                    if (((_e948 & 1u) != 0u) == _e278) {
                                        if ((_e948 & 2u) != 0u) {
                                            phi_1312_ = (((_e948 & 4u) != 0u) == _e278);
                                        } else {
                                            phi_1312_ = true;
                                        }
                                        let _e1040 = phi_1312_;
                                        phi_1313_ = _e1040;
                                    } else {
                                        phi_1313_ = false;
                                    }
                                    let _e1042 = phi_1313_;
                                    phi_1314_ = _e1042;
                                } else {
                                    phi_1314_ = false;
                                }
                                let _e1044 = phi_1314_;
                                phi_1047_ = (_e820 + 1u);
                                phi_1050_ = lt_mask_Neighbourhood(_e1030, _e1044);
                            } else {
                                phi_1047_ = u32();
                                phi_1050_ = lt_mask_Neighbourhood();
                            }
                            let _e1048 = phi_1047_;
                            let _e1050 = phi_1050_;
                            continue;
                            continuing {
                                phi_1046_ = _e1048;
                                phi_1049_ = _e1050;
                                break if !(_e834);
                            }
                        }
                        let _e1409 = local_1;
                        phi_1317_ = _e1409;
                    }
                    let _e1053 = phi_1317_;
                    phi_1318_ = _e1053;
                } else {
                    phi_1318_ = _e805;
                }
                let _e1055 = phi_1318_;
                phi_1319_ = _e1055;
            } else {
                phi_1319_ = _e805;
            }
            let _e1057 = phi_1319_;
            let _e1060 = p.member.frame;
            let _e1062 = p.member.refresh;
            if (_e1062 == 0u) {
                phi_1352_ = false;
            } else {
                if (_e1062 == 0u) {
                    return;
                }
                let _e1071 = ((_e60.x + (_e60.y * (((_e1062 * 5u) / 8u) | 1u))) + (_e1060 % _e1062));
                if (_e1062 == 0u) {
                    phi_1351_ = (_e1071 == 0u);
                } else {
                    if (_e1062 == 0u) {
                        return;
                    }
                    phi_1351_ = ((_e1071 % _e1062) == 0u);
                }
                let _e1078 = phi_1351_;
                phi_1352_ = _e1078;
            }
            let _e1080 = phi_1352_;
            if _e728 {
                if _e1080 {
                    phi_1374_ = bool();
                } else {
                    phi_1374_ = ((_e804 & 2u) != 0u);
                }
                let _e1086 = phi_1374_;
                phi_1375_ = _e1086;
                phi_1376_ = _e1080;
            } else {
                phi_1375_ = bool();
                phi_1376_ = true;
            }
            let _e1088 = phi_1375_;
            let _e1090 = phi_1376_;
            if _e1090 {
                phi_1380_ = false;
            } else {
                phi_1380_ = _e1088;
            }
            let _e1092 = phi_1380_;
            if _e1092 {
                phi_1431_ = 7u;
            } else {
                if (_e120 != 0.5f) {
                    if _e728 {
                        if _e1080 {
                            phi_1428_ = 6u;
                        } else {
                            if _e282 {
                                phi_1403_ = true;
                            } else {
                                if _e1057.any_expands {
                                    phi_1402_ = false;
                                } else {
                                    phi_1402_ = true;
                                }
                                let _e1094 = phi_1402_;
                                phi_1403_ = _e1094;
                            }
                            let _e1096 = phi_1403_;
                            if _e1096 {
                                if _e282 {
                                    if _e738 {
                                        if _e1057.all_remove {
                                            phi_1416_ = false;
                                        } else {
                                            phi_1416_ = true;
                                        }
                                        let _e1098 = phi_1416_;
                                        phi_1417_ = _e1098;
                                    } else {
                                        phi_1417_ = true;
                                    }
                                    let _e1100 = phi_1417_;
                                    phi_1418_ = _e1100;
                                } else {
                                    phi_1418_ = true;
                                }
                                let _e1102 = phi_1418_;
                                if _e1102 {
                                    if _e282 {
                                        phi_1425_ = 1u;
                                    } else {
                                        phi_1425_ = 0u;
                                    }
                                    let _e1104 = phi_1425_;
                                    phi_1426_ = _e1104;
                                } else {
                                    phi_1426_ = 5u;
                                }
                                let _e1106 = phi_1426_;
                                phi_1427_ = _e1106;
                            } else {
                                phi_1427_ = 4u;
                            }
                            let _e1108 = phi_1427_;
                            phi_1428_ = _e1108;
                        }
                        let _e1110 = phi_1428_;
                        phi_1429_ = _e1110;
                    } else {
                        phi_1429_ = 3u;
                    }
                    let _e1112 = phi_1429_;
                    phi_1430_ = _e1112;
                } else {
                    phi_1430_ = 2u;
                }
                let _e1114 = phi_1430_;
                phi_1431_ = _e1114;
            }
            let _e1116 = phi_1431_;
            if !((_e1116 == 0u)) {
                if !((_e1116 == 5u)) {
                    phi_1443_ = !(_e1092);
                    phi_1444_ = false;
                } else {
                    phi_1443_ = bool();
                    phi_1444_ = true;
                }
                let _e1123 = phi_1443_;
                let _e1125 = phi_1444_;
                phi_1445_ = _e1123;
                phi_1446_ = _e1125;
            } else {
                phi_1445_ = bool();
                phi_1446_ = true;
            }
            let _e1127 = phi_1445_;
            let _e1129 = phi_1446_;
            if _e1129 {
                phi_1450_ = false;
            } else {
                phi_1450_ = _e1127;
            }
            let _e1131 = phi_1450_;
            if _e1092 {
                phi_1456_ = ((_e804 & 4u) != 0u);
            } else {
                phi_1456_ = _e278;
            }
            let _e1135 = phi_1456_;
            if _e1131 {
                if _e278 {
                    phi_1464_ = (2u | 1u);
                } else {
                    phi_1464_ = 2u;
                }
                let _e1138 = phi_1464_;
                if false {
                    phi_1469_ = (_e1138 | 4u);
                } else {
                    phi_1469_ = _e1138;
                }
                let _e1141 = phi_1469_;
                phi_1489_ = _e1141;
            } else {
                if (_e1116 == 7u) {
                    if _e278 {
                        phi_1478_ = (2u | 1u);
                    } else {
                        phi_1478_ = 2u;
                    }
                    let _e1145 = phi_1478_;
                    if _e1135 {
                        phi_1483_ = (_e1145 | 4u);
                    } else {
                        phi_1483_ = _e1145;
                    }
                    let _e1148 = phi_1483_;
                    phi_1488_ = _e1148;
                } else {
                    if _e278 {
                        phi_1487_ = 1u;
                    } else {
                        phi_1487_ = 0u;
                    }
                    let _e1150 = phi_1487_;
                    phi_1488_ = _e1150;
                }
                let _e1152 = phi_1488_;
                phi_1489_ = _e1152;
            }
            let _e1154 = phi_1489_;
            if _e1135 {
                phi_1493_ = 0f;
            } else {
                phi_1493_ = 1f;
            }
            let _e1156 = phi_1493_;
            phi_1495_ = mask_Masked(_e1156, _e1154, _e1131);
        }
        let _e1159 = phi_1495_;
        visibility.member[_e81.shift] = _e1159.visibility;
        let _e1164 = p.member.light.number;
        let _e1165 = (_e1164 * 3u);
        let _e1167 = (_e1165 % 32u);
        let _e1169 = p.member.light.mask_words;
        let _e1171 = ((_e81.shift * _e1169) + (_e1165 / 32u));
        let _e1173 = bits.member[_e1171];
        bits.member[_e1171] = ((_e1173 & ~((7u << bitcast<u32>((_e1167 & 31u))))) | (_e1159.bits << bitcast<u32>((_e1167 & 31u))));
        if (_e1167 > 29u) {
            let _e1188 = bits.member[(_e1171 + 1u)];
            let _e1190 = (32u - _e1167);
            bits.member[(_e1171 + 1u)] = ((_e1188 & ~((7u >> bitcast<u32>((_e1190 & 31u))))) | (_e1159.bits >> bitcast<u32>((_e1190 & 31u))));
        }
        let _e1205 = samples.member[_e81.shift].normal[0u];
        let _e1207 = global[0u];
        if (_e1205 == _e1207) {
            let _e1210 = samples.member[_e81.shift].normal[1u];
            let _e1212 = global[1u];
            if (_e1210 == _e1212) {
                let _e1215 = samples.member[_e81.shift].normal[2u];
                let _e1217 = global[2u];
                phi_1567_ = (_e1215 == _e1217);
                phi_1568_ = false;
            } else {
                phi_1567_ = bool();
                phi_1568_ = true;
            }
            let _e1220 = phi_1567_;
            let _e1222 = phi_1568_;
            phi_1569_ = _e1220;
            phi_1570_ = _e1222;
        } else {
            phi_1569_ = bool();
            phi_1570_ = true;
        }
        let _e1224 = phi_1569_;
        let _e1226 = phi_1570_;
        if _e1226 {
            phi_1574_ = false;
        } else {
            phi_1574_ = _e1224;
        }
        let _e1228 = phi_1574_;
        if !(_e1228) {
            let _e1231 = samples.member[_e81.shift].position;
            let _e1233 = p.member.current.eye;
            let _e1244 = p.member.current.forward;
            phi_1602_ = ((((_e1231.x - _e1233.x) * _e1244.x) + ((_e1231.y - _e1233.y) * _e1244.y)) + ((_e1231.z - _e1233.z) * _e1244.z));
        } else {
            phi_1602_ = 0f;
        }
        let _e1254 = phi_1602_;
        depths.member[_e81.shift] = _e1254;
        phi_1605_ = _e1159.needs_ray;
        phi_1606_ = _e81.shift;
    } else {
        phi_1605_ = false;
        phi_1606_ = 0u;
    }
    let _e1258 = phi_1605_;
    let _e1260 = phi_1606_;
    if (_e61 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1258 {
        let _e1264 = atomicAdd((&shared_[0u]), 1u);
        phi_1617_ = _e1264;
    } else {
        phi_1617_ = 0u;
    }
    let _e1266 = phi_1617_;
    workgroupBarrier();
    if (_e61 == 0u) {
        let _e1270 = atomicLoad((&shared_[0u]));
        let _e1271 = atomicAdd((&list.member[3u]), _e1270);
        atomicStore((&shared_[1u]), _e1271);
    }
    workgroupBarrier();
    if _e1258 {
        let _e1274 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1274) + _e1266)]), _e1260);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_depth_rr_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
