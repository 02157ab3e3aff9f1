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
    var phi_937_: bool;
    var phi_959_: u32;
    var phi_961_: u32;
    var phi_964_: lt_mask_Neighbourhood;
    var phi_976_: bool;
    var phi_977_: bool;
    var phi_986_: u32;
    var phi_987_: u32;
    var phi_1047_: vec2<i32>;
    var phi_1067_: vec2<i32>;
    var phi_1094_: u32;
    var phi_1113_: u32;
    var phi_1121_: u32;
    var phi_1147_: bool;
    var phi_1148_: bool;
    var phi_1149_: bool;
    var phi_1150_: bool;
    var phi_1151_: bool;
    var phi_1152_: bool;
    var phi_1153_: bool;
    var phi_1158_: bool;
    var phi_1159_: bool;
    var phi_1160_: bool;
    var phi_1161_: bool;
    var phi_1162_: bool;
    var phi_1163_: bool;
    var phi_1164_: bool;
    var phi_1165_: bool;
    var phi_1166_: bool;
    var phi_1181_: bool;
    var phi_1182_: bool;
    var phi_1189_: bool;
    var phi_1190_: bool;
    var phi_1191_: bool;
    var phi_1192_: bool;
    var phi_1193_: bool;
    var phi_1197_: bool;
    var phi_1198_: bool;
    var phi_1199_: bool;
    var phi_1203_: bool;
    var phi_1204_: bool;
    var phi_1208_: bool;
    var phi_1209_: bool;
    var phi_1227_: bool;
    var phi_1228_: bool;
    var phi_1229_: bool;
    var phi_962_: u32;
    var phi_965_: lt_mask_Neighbourhood;
    var phi_1232_: lt_mask_Neighbourhood;
    var phi_1233_: lt_mask_Neighbourhood;
    var phi_1234_: lt_mask_Neighbourhood;
    var phi_1266_: bool;
    var phi_1267_: bool;
    var phi_1289_: bool;
    var phi_1290_: bool;
    var phi_1291_: bool;
    var phi_1295_: bool;
    var phi_1317_: bool;
    var phi_1318_: bool;
    var phi_1331_: bool;
    var phi_1332_: bool;
    var phi_1333_: bool;
    var phi_1340_: u32;
    var phi_1341_: u32;
    var phi_1342_: u32;
    var phi_1343_: u32;
    var phi_1344_: u32;
    var phi_1345_: u32;
    var phi_1346_: u32;
    var phi_1358_: bool;
    var phi_1359_: bool;
    var phi_1360_: bool;
    var phi_1361_: bool;
    var phi_1365_: bool;
    var phi_1371_: bool;
    var phi_1379_: u32;
    var phi_1384_: u32;
    var phi_1393_: u32;
    var phi_1398_: u32;
    var phi_1402_: u32;
    var phi_1403_: u32;
    var phi_1404_: u32;
    var phi_1408_: f32;
    var phi_1410_: mask_Masked;
    var phi_1482_: bool;
    var phi_1483_: bool;
    var phi_1484_: bool;
    var phi_1485_: bool;
    var phi_1489_: bool;
    var phi_1517_: f32;
    var phi_1520_: bool;
    var phi_1521_: u32;
    var phi_1532_: u32;
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
            phi_1410_ = mask_Masked(_e273.unnamed.visibility, 0u, false);
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
            let _e735 = lt_mask_Neighbourhood(false, true);
            if _e282 {
                phi_937_ = false;
            } else {
                phi_937_ = true;
            }
            let _e737 = phi_937_;
            if _e737 {
                if _e728 {
                    if ((0u & 2u) != 0u) {
                        phi_1232_ = _e735;
                    } else {
                        let _e741 = p.member.expansion;
                        if _e734.has_moved {
                            let _e744 = p.member.moving_pattern;
                            phi_959_ = _e744;
                        } else {
                            let _e746 = p.member.still_pattern;
                            phi_959_ = _e746;
                        }
                        let _e748 = phi_959_;
                        phi_961_ = 0u;
                        phi_964_ = _e735;
                        loop {
                            let _e750 = phi_961_;
                            let _e752 = phi_964_;
                            local_1 = _e752;
                            if (1u <= _e748) {
                                if (_e748 <= 4u) {
                                    phi_976_ = false;
                                } else {
                                    phi_976_ = true;
                                }
                                let _e756 = phi_976_;
                                phi_977_ = _e756;
                            } else {
                                phi_977_ = true;
                            }
                            let _e758 = phi_977_;
                            if _e758 {
                                switch bitcast<i32>(_e748) {
                                    case 5: {
                                        phi_986_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_986_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_986_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_986_ = 9u;
                                        break;
                                    }
                                }
                                let _e761 = phi_986_;
                                phi_987_ = _e761;
                            } else {
                                phi_987_ = 5u;
                            }
                            let _e763 = phi_987_;
                            let _e764 = (_e750 < _e763);
                            if _e764 {
                                let _e770 = p.member.frame;
                                let _e774 = p.member.current.size[0u];
                                let _e776 = p.member.current.size[1u];
                                switch bitcast<i32>(_e748) {
                                    case 1: {
                                        let _e786 = lt_mask_pattern_plus(_e750);
                                        phi_1067_ = vec2<i32>(_e786.x, _e786.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e790 = lt_mask_pattern_cross(_e750);
                                        phi_1067_ = vec2<i32>(_e790.x, _e790.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e796 = lt_mask_pattern_plus_or_cross(_e750, ((_e734.pixel.x + _e734.pixel.y) & 1u));
                                        phi_1067_ = vec2<i32>(_e796.x, _e796.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e801 = lt_mask_pattern_plus_or_cross(_e750, (_e770 & 1u));
                                        phi_1067_ = vec2<i32>(_e801.x, _e801.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e770 & 3u)) {
                                            case 0: {
                                                phi_1047_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_1047_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_1047_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_1047_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e812 = phi_1047_;
                                        phi_1067_ = (_e812 + vec2<i32>(bitcast<i32>((_e750 & 1u)), bitcast<i32>(((_e750 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_1067_ = vec2<i32>((bitcast<i32>((_e750 % 5u)) - 2i), (bitcast<i32>(((_e750 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e829 = lt_mask_pattern_diamond(_e750);
                                        phi_1067_ = vec2<i32>(_e829.x, _e829.y);
                                        break;
                                    }
                                    default: {
                                        phi_1067_ = vec2<i32>((bitcast<i32>((_e750 % 3u)) - 1i), (bitcast<i32>(((_e750 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e834 = phi_1067_;
                                let _e837 = lt_mask_pattern_step_clamped(_e734.pixel.x, _e834.x, _e774);
                                let _e838 = lt_mask_pattern_step_clamped(_e734.pixel.y, _e834.y, _e776);
                                let _e845 = ((((_e838 * _e112) + _e837) * _e108.words) + _e108.light.word);
                                if (_e108.light.shift > 29u) {
                                    let _e849 = (_e845 + 1u);
                                    if (_e849 < _e66) {
                                    } else {
                                        return;
                                    }
                                    let _e853 = last_bits.member[(0u + _e849)];
                                    phi_1094_ = _e853;
                                } else {
                                    phi_1094_ = 0u;
                                }
                                let _e855 = phi_1094_;
                                if (_e845 < _e66) {
                                } else {
                                    return;
                                }
                                let _e861 = last_bits.member[(0u + _e845)];
                                let _e864 = (_e861 >> bitcast<u32>((_e108.light.shift & 31u)));
                                if (_e108.light.shift > 29u) {
                                    phi_1113_ = (_e864 | (_e855 << bitcast<u32>(((32u - _e108.light.shift) & 31u))));
                                } else {
                                    phi_1113_ = _e864;
                                }
                                let _e872 = phi_1113_;
                                if ((_e872 & 2u) == 0u) {
                                    phi_1121_ = (_e872 & 1u);
                                } else {
                                    phi_1121_ = (_e872 & 7u);
                                }
                                let _e878 = phi_1121_;
                                if _e752.any_expands {
                                    phi_1209_ = true;
                                } else {
                                    if ((_e878 & 2u) != 0u) {
                                        let _e885 = (((_e878 & 4u) != 0u) != _e278);
                                        switch bitcast<i32>(_e741) {
                                            case 1: {
                                                phi_1149_ = bool();
                                                phi_1150_ = false;
                                                phi_1151_ = true;
                                                phi_1152_ = false;
                                                phi_1153_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e885 {
                                                    phi_1147_ = (((_e878 & 4u) != 0u) != ((_e878 & 1u) != 0u));
                                                    phi_1148_ = false;
                                                } else {
                                                    phi_1147_ = bool();
                                                    phi_1148_ = true;
                                                }
                                                let _e893 = phi_1147_;
                                                let _e895 = phi_1148_;
                                                phi_1149_ = _e893;
                                                phi_1150_ = false;
                                                phi_1151_ = false;
                                                phi_1152_ = _e895;
                                                phi_1153_ = _e885;
                                                break;
                                            }
                                            default: {
                                                phi_1149_ = bool();
                                                phi_1150_ = true;
                                                phi_1151_ = false;
                                                phi_1152_ = false;
                                                phi_1153_ = false;
                                                break;
                                            }
                                        }
                                        let _e897 = phi_1149_;
                                        let _e899 = phi_1150_;
                                        let _e901 = phi_1151_;
                                        let _e903 = phi_1152_;
                                        let _e905 = phi_1153_;
                                        phi_1161_ = _e885;
                                        phi_1162_ = _e897;
                                        phi_1163_ = _e899;
                                        phi_1164_ = _e901;
                                        phi_1165_ = _e903;
                                        phi_1166_ = _e905;
                                    } else {
                                        switch bitcast<i32>(_e741) {
                                            case 1: {
                                                phi_1158_ = false;
                                                phi_1159_ = true;
                                                phi_1160_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_1158_ = false;
                                                phi_1159_ = false;
                                                phi_1160_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_1158_ = true;
                                                phi_1159_ = false;
                                                phi_1160_ = false;
                                                break;
                                            }
                                        }
                                        let _e908 = phi_1158_;
                                        let _e910 = phi_1159_;
                                        let _e912 = phi_1160_;
                                        phi_1161_ = false;
                                        phi_1162_ = bool();
                                        phi_1163_ = _e908;
                                        phi_1164_ = _e910;
                                        phi_1165_ = _e912;
                                        phi_1166_ = false;
                                    }
                                    let _e914 = phi_1161_;
                                    let _e916 = phi_1162_;
                                    let _e918 = phi_1163_;
                                    let _e920 = phi_1164_;
                                    let _e922 = phi_1165_;
                                    let _e924 = phi_1166_;
                                    if _e918 {
                                        if ((_e878 & 2u) != 0u) {
                                            if (((_e878 & 4u) != 0u) != _e278) {
                                                phi_1181_ = false;
                                            } else {
                                                phi_1181_ = true;
                                            }
                                            let _e931 = phi_1181_;
                                            phi_1182_ = _e931;
                                        } else {
                                            phi_1182_ = true;
                                        }
                                        let _e933 = phi_1182_;
                                        if _e933 {
                                            phi_1189_ = (((_e878 & 1u) != 0u) != _e278);
                                        } else {
                                            phi_1189_ = true;
                                        }
                                        let _e938 = phi_1189_;
                                        phi_1190_ = _e938;
                                        phi_1191_ = false;
                                        phi_1192_ = false;
                                        phi_1193_ = false;
                                    } else {
                                        phi_1190_ = bool();
                                        phi_1191_ = _e920;
                                        phi_1192_ = _e922;
                                        phi_1193_ = _e924;
                                    }
                                    let _e940 = phi_1190_;
                                    let _e942 = phi_1191_;
                                    let _e944 = phi_1192_;
                                    let _e946 = phi_1193_;
                                    if _e942 {
                                        phi_1197_ = _e914;
                                        phi_1198_ = false;
                                        phi_1199_ = false;
                                    } else {
                                        phi_1197_ = _e940;
                                        phi_1198_ = _e944;
                                        phi_1199_ = _e946;
                                    }
                                    let _e948 = phi_1197_;
                                    let _e950 = phi_1198_;
                                    let _e952 = phi_1199_;
                                    if _e950 {
                                        phi_1203_ = false;
                                        phi_1204_ = true;
                                    } else {
                                        phi_1203_ = _e916;
                                        phi_1204_ = _e952;
                                    }
                                    let _e954 = phi_1203_;
                                    let _e956 = phi_1204_;
                                    if _e956 {
                                        phi_1208_ = _e954;
                                    } else {
                                        phi_1208_ = _e948;
                                    }
                                    let _e958 = phi_1208_;
                                    phi_1209_ = _e958;
                                }
                                let _e960 = phi_1209_;
                                if _e752.all_remove {
                                    if (((_e878 & 1u) != 0u) == _e278) {
                                        if ((_e878 & 2u) != 0u) {
                                            phi_1227_ = (((_e878 & 4u) != 0u) == _e278);
                                        } else {
                                            phi_1227_ = true;
                                        }
                                        let _e970 = phi_1227_;
                                        phi_1228_ = _e970;
                                    } else {
                                        phi_1228_ = false;
                                    }
                                    let _e972 = phi_1228_;
                                    phi_1229_ = _e972;
                                } else {
                                    phi_1229_ = false;
                                }
                                let _e974 = phi_1229_;
                                phi_962_ = (_e750 + 1u);
                                phi_965_ = lt_mask_Neighbourhood(_e960, _e974);
                            } else {
                                phi_962_ = u32();
                                phi_965_ = lt_mask_Neighbourhood();
                            }
                            let _e978 = phi_962_;
                            let _e980 = phi_965_;
                            continue;
                            continuing {
                                phi_961_ = _e978;
                                phi_964_ = _e980;
                                break if !(_e764);
                            }
                        }
                        let _e1326 = local_1;
                        phi_1232_ = _e1326;
                    }
                    let _e983 = phi_1232_;
                    phi_1233_ = _e983;
                } else {
                    phi_1233_ = _e735;
                }
                let _e985 = phi_1233_;
                phi_1234_ = _e985;
            } else {
                phi_1234_ = _e735;
            }
            let _e987 = phi_1234_;
            let _e990 = p.member.frame;
            let _e992 = p.member.refresh;
            if (_e992 == 0u) {
                phi_1267_ = false;
            } else {
                if (_e992 == 0u) {
                    return;
                }
                let _e1001 = ((_e60.x + (_e60.y * (((_e992 * 5u) / 8u) | 1u))) + (_e990 % _e992));
                if (_e992 == 0u) {
                    phi_1266_ = (_e1001 == 0u);
                } else {
                    if (_e992 == 0u) {
                        return;
                    }
                    phi_1266_ = ((_e1001 % _e992) == 0u);
                }
                let _e1008 = phi_1266_;
                phi_1267_ = _e1008;
            }
            let _e1010 = phi_1267_;
            if _e728 {
                if _e1010 {
                    phi_1289_ = bool();
                } else {
                    phi_1289_ = ((0u & 2u) != 0u);
                }
                let _e1016 = phi_1289_;
                phi_1290_ = _e1016;
                phi_1291_ = _e1010;
            } else {
                phi_1290_ = bool();
                phi_1291_ = true;
            }
            let _e1018 = phi_1290_;
            let _e1020 = phi_1291_;
            if _e1020 {
                phi_1295_ = false;
            } else {
                phi_1295_ = _e1018;
            }
            let _e1022 = phi_1295_;
            if _e1022 {
                phi_1346_ = 7u;
            } else {
                if (_e120 != 0.5f) {
                    if _e728 {
                        if _e1010 {
                            phi_1343_ = 6u;
                        } else {
                            if _e282 {
                                phi_1318_ = true;
                            } else {
                                if _e987.any_expands {
                                    phi_1317_ = false;
                                } else {
                                    phi_1317_ = true;
                                }
                                let _e1024 = phi_1317_;
                                phi_1318_ = _e1024;
                            }
                            let _e1026 = phi_1318_;
                            if _e1026 {
                                if _e282 {
                                    if false {
                                        if _e987.all_remove {
                                            phi_1331_ = false;
                                        } else {
                                            phi_1331_ = true;
                                        }
                                        let _e1028 = phi_1331_;
                                        phi_1332_ = _e1028;
                                    } else {
                                        phi_1332_ = true;
                                    }
                                    let _e1030 = phi_1332_;
                                    phi_1333_ = _e1030;
                                } else {
                                    phi_1333_ = true;
                                }
                                let _e1032 = phi_1333_;
                                if _e1032 {
                                    if _e282 {
                                        phi_1340_ = 1u;
                                    } else {
                                        phi_1340_ = 0u;
                                    }
                                    let _e1034 = phi_1340_;
                                    phi_1341_ = _e1034;
                                } else {
                                    phi_1341_ = 5u;
                                }
                                let _e1036 = phi_1341_;
                                phi_1342_ = _e1036;
                            } else {
                                phi_1342_ = 4u;
                            }
                            let _e1038 = phi_1342_;
                            phi_1343_ = _e1038;
                        }
                        let _e1040 = phi_1343_;
                        phi_1344_ = _e1040;
                    } else {
                        phi_1344_ = 3u;
                    }
                    let _e1042 = phi_1344_;
                    phi_1345_ = _e1042;
                } else {
                    phi_1345_ = 2u;
                }
                let _e1044 = phi_1345_;
                phi_1346_ = _e1044;
            }
            let _e1046 = phi_1346_;
            if !((_e1046 == 0u)) {
                if !((_e1046 == 5u)) {
                    phi_1358_ = !(_e1022);
                    phi_1359_ = false;
                } else {
                    phi_1358_ = bool();
                    phi_1359_ = true;
                }
                let _e1053 = phi_1358_;
                let _e1055 = phi_1359_;
                phi_1360_ = _e1053;
                phi_1361_ = _e1055;
            } else {
                phi_1360_ = bool();
                phi_1361_ = true;
            }
            let _e1057 = phi_1360_;
            let _e1059 = phi_1361_;
            if _e1059 {
                phi_1365_ = false;
            } else {
                phi_1365_ = _e1057;
            }
            let _e1061 = phi_1365_;
            if _e1022 {
                phi_1371_ = ((0u & 4u) != 0u);
            } else {
                phi_1371_ = _e278;
            }
            let _e1065 = phi_1371_;
            if _e1061 {
                if _e278 {
                    phi_1379_ = (2u | 1u);
                } else {
                    phi_1379_ = 2u;
                }
                let _e1068 = phi_1379_;
                if false {
                    phi_1384_ = (_e1068 | 4u);
                } else {
                    phi_1384_ = _e1068;
                }
                let _e1071 = phi_1384_;
                phi_1404_ = _e1071;
            } else {
                if (_e1046 == 7u) {
                    if _e278 {
                        phi_1393_ = (2u | 1u);
                    } else {
                        phi_1393_ = 2u;
                    }
                    let _e1075 = phi_1393_;
                    if _e1065 {
                        phi_1398_ = (_e1075 | 4u);
                    } else {
                        phi_1398_ = _e1075;
                    }
                    let _e1078 = phi_1398_;
                    phi_1403_ = _e1078;
                } else {
                    if _e278 {
                        phi_1402_ = 1u;
                    } else {
                        phi_1402_ = 0u;
                    }
                    let _e1080 = phi_1402_;
                    phi_1403_ = _e1080;
                }
                let _e1082 = phi_1403_;
                phi_1404_ = _e1082;
            }
            let _e1084 = phi_1404_;
            if _e1065 {
                phi_1408_ = 0f;
            } else {
                phi_1408_ = 1f;
            }
            let _e1086 = phi_1408_;
            phi_1410_ = mask_Masked(_e1086, _e1084, _e1061);
        }
        let _e1089 = phi_1410_;
        visibility.member[_e81.shift] = _e1089.visibility;
        let _e1094 = p.member.light.number;
        let _e1095 = (_e1094 * 3u);
        let _e1097 = (_e1095 % 32u);
        let _e1099 = p.member.light.mask_words;
        let _e1101 = ((_e81.shift * _e1099) + (_e1095 / 32u));
        let _e1103 = bits.member[_e1101];
        bits.member[_e1101] = ((_e1103 & ~((7u << bitcast<u32>((_e1097 & 31u))))) | (_e1089.bits << bitcast<u32>((_e1097 & 31u))));
        if (_e1097 > 29u) {
            let _e1118 = bits.member[(_e1101 + 1u)];
            let _e1120 = (32u - _e1097);
            bits.member[(_e1101 + 1u)] = ((_e1118 & ~((7u >> bitcast<u32>((_e1120 & 31u))))) | (_e1089.bits >> bitcast<u32>((_e1120 & 31u))));
        }
        let _e1135 = samples.member[_e81.shift].normal[0u];
        let _e1137 = global[0u];
        if (_e1135 == _e1137) {
            let _e1140 = samples.member[_e81.shift].normal[1u];
            let _e1142 = global[1u];
            if (_e1140 == _e1142) {
                let _e1145 = samples.member[_e81.shift].normal[2u];
                let _e1147 = global[2u];
                phi_1482_ = (_e1145 == _e1147);
                phi_1483_ = false;
            } else {
                phi_1482_ = bool();
                phi_1483_ = true;
            }
            let _e1150 = phi_1482_;
            let _e1152 = phi_1483_;
            phi_1484_ = _e1150;
            phi_1485_ = _e1152;
        } else {
            phi_1484_ = bool();
            phi_1485_ = true;
        }
        let _e1154 = phi_1484_;
        let _e1156 = phi_1485_;
        if _e1156 {
            phi_1489_ = false;
        } else {
            phi_1489_ = _e1154;
        }
        let _e1158 = phi_1489_;
        if !(_e1158) {
            let _e1161 = samples.member[_e81.shift].position;
            let _e1163 = p.member.current.eye;
            let _e1174 = p.member.current.forward;
            phi_1517_ = ((((_e1161.x - _e1163.x) * _e1174.x) + ((_e1161.y - _e1163.y) * _e1174.y)) + ((_e1161.z - _e1163.z) * _e1174.z));
        } else {
            phi_1517_ = 0f;
        }
        let _e1184 = phi_1517_;
        depths.member[_e81.shift] = _e1184;
        phi_1520_ = _e1089.needs_ray;
        phi_1521_ = _e81.shift;
    } else {
        phi_1520_ = false;
        phi_1521_ = 0u;
    }
    let _e1188 = phi_1520_;
    let _e1190 = phi_1521_;
    if (_e61 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1188 {
        let _e1194 = atomicAdd((&shared_[0u]), 1u);
        phi_1532_ = _e1194;
    } else {
        phi_1532_ = 0u;
    }
    let _e1196 = phi_1532_;
    workgroupBarrier();
    if (_e61 == 0u) {
        let _e1200 = atomicLoad((&shared_[0u]));
        let _e1201 = atomicAdd((&list.member[3u]), _e1200);
        atomicStore((&shared_[1u]), _e1201);
    }
    workgroupBarrier();
    if _e1188 {
        let _e1204 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1204) + _e1196)]), _e1190);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_depth_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
