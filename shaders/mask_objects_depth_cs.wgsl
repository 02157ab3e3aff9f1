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
    var phi_182_: lt_mask_LightPlace;
    var phi_183_: bool;
    var phi_184_: lt_mask_LightPlace;
    var phi_185_: bool;
    var phi_190_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_182_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_183_ = false;
        } else {
            phi_182_ = lt_mask_LightPlace();
            phi_183_ = true;
        }
        let _e73 = phi_182_;
        let _e75 = phi_183_;
        phi_184_ = _e73;
        phi_185_ = _e75;
    } else {
        phi_184_ = lt_mask_LightPlace();
        phi_185_ = true;
    }
    let _e77 = phi_184_;
    let _e79 = phi_185_;
    if _e79 {
        phi_190_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_190_ = _e77;
    }
    let _e84 = phi_190_;
    return lt_mask_LightPlace(_e84.word, _e84.shift);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_208_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_208_ = vec2(0i);
            break;
        }
        case 1: {
            phi_208_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_208_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_208_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_208_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e69 = phi_208_;
    return vec2<i32>(_e69.x, _e69.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_226_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_226_ = vec2(0i);
            break;
        }
        case 1: {
            phi_226_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_226_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_226_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_226_ = vec2(1i);
            break;
        }
    }
    let _e69 = phi_226_;
    return vec2<i32>(_e69.x, _e69.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_245_: vec2<i32>;

    if (param_6 == 0u) {
        let _e63 = lt_mask_pattern_plus(param_5);
        phi_245_ = vec2<i32>(_e63.x, _e63.y);
    } else {
        let _e67 = lt_mask_pattern_cross(param_5);
        phi_245_ = vec2<i32>(_e67.x, _e67.y);
    }
    let _e72 = phi_245_;
    return vec2<i32>(_e72.x, _e72.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_270_: vec2<i32>;

    let _e61 = (param_7 % 13u);
    switch bitcast<i32>(_e61) {
        case 9: {
            phi_270_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_270_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_270_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_270_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_270_ = vec2<i32>((bitcast<i32>((_e61 % 3u)) - 1i), (bitcast<i32>(((_e61 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e76 = phi_270_;
    return vec2<i32>(_e76.x, _e76.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_291_: u32;
    var phi_292_: u32;

    let _e64 = (bitcast<i32>(param_8) + param_9);
    if (_e64 < 0i) {
        phi_292_ = 0u;
    } else {
        if (_e64 >= bitcast<i32>(param_10)) {
            phi_291_ = (param_10 - 1u);
        } else {
            phi_291_ = bitcast<u32>(_e64);
        }
        let _e71 = phi_291_;
        phi_292_ = _e71;
    }
    let _e73 = phi_292_;
    return _e73;
}

fn function_() {
    var phi_373_: bool;
    var phi_374_: bool;
    var phi_375_: bool;
    var phi_376_: bool;
    var phi_380_: bool;
    var phi_450_: bool;
    var phi_451_: bool;
    var phi_462_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_463_: bool;
    var phi_464_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_465_: bool;
    var phi_472_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_476_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_489_: bool;
    var phi_675_: f32;
    var phi_680_: f32;
    var phi_681_: bool;
    var phi_682_: f32;
    var phi_683_: bool;
    var phi_687_: f32;
    var phi_710_: f32;
    var phi_715_: f32;
    var phi_716_: bool;
    var phi_717_: f32;
    var phi_718_: bool;
    var phi_722_: f32;
    var phi_743_: bool;
    var phi_762_: vec2<u32>;
    var phi_763_: bool;
    var phi_764_: bool;
    var phi_765_: bool;
    var phi_766_: vec2<u32>;
    var phi_767_: bool;
    var phi_768_: bool;
    var phi_769_: bool;
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
    var phi_793_: bool;
    var phi_794_: bool;
    var phi_795_: bool;
    var phi_796_: bool;
    var phi_800_: bool;
    var phi_801_: bool;
    var phi_802_: vec2<u32>;
    var phi_885_: bool;
    var phi_889_: f32;
    var phi_893_: lt_mask_Reprojection;
    var phi_902_: bool;
    var phi_903_: bool;
    var phi_905_: bool;
    var phi_906_: lt_mask_Reprojection;
    var phi_907_: lt_mask_Reprojection;
    var phi_908_: bool;
    var phi_912_: bool;
    var phi_913_: lt_mask_Reprojection;
    var phi_956_: u32;
    var phi_975_: u32;
    var phi_983_: u32;
    var phi_984_: u32;
    var phi_985_: bool;
    var phi_986_: u32;
    var phi_987_: bool;
    var phi_988_: bool;
    var phi_989_: u32;
    var phi_990_: bool;
    var phi_991_: bool;
    var phi_995_: bool;
    var phi_999_: u32;
    var phi_1004_: bool;
    var phi_1026_: u32;
    var phi_1028_: u32;
    var phi_1031_: lt_mask_Neighbourhood;
    var phi_1043_: bool;
    var phi_1044_: bool;
    var phi_1053_: u32;
    var phi_1054_: u32;
    var phi_1114_: vec2<i32>;
    var phi_1134_: vec2<i32>;
    var phi_1161_: u32;
    var phi_1180_: u32;
    var phi_1188_: u32;
    var phi_1214_: bool;
    var phi_1215_: bool;
    var phi_1216_: bool;
    var phi_1217_: bool;
    var phi_1218_: bool;
    var phi_1219_: bool;
    var phi_1220_: bool;
    var phi_1225_: bool;
    var phi_1226_: bool;
    var phi_1227_: bool;
    var phi_1228_: bool;
    var phi_1229_: bool;
    var phi_1230_: bool;
    var phi_1231_: bool;
    var phi_1232_: bool;
    var phi_1233_: bool;
    var phi_1248_: bool;
    var phi_1249_: bool;
    var phi_1256_: bool;
    var phi_1257_: bool;
    var phi_1258_: bool;
    var phi_1259_: bool;
    var phi_1260_: bool;
    var phi_1264_: bool;
    var phi_1265_: bool;
    var phi_1266_: bool;
    var phi_1270_: bool;
    var phi_1271_: bool;
    var phi_1275_: bool;
    var phi_1276_: bool;
    var phi_1294_: bool;
    var phi_1295_: bool;
    var phi_1296_: bool;
    var phi_1029_: u32;
    var phi_1032_: lt_mask_Neighbourhood;
    var phi_1299_: lt_mask_Neighbourhood;
    var phi_1300_: lt_mask_Neighbourhood;
    var phi_1301_: lt_mask_Neighbourhood;
    var phi_1333_: bool;
    var phi_1334_: bool;
    var phi_1356_: bool;
    var phi_1357_: bool;
    var phi_1358_: bool;
    var phi_1362_: bool;
    var phi_1384_: bool;
    var phi_1385_: bool;
    var phi_1398_: bool;
    var phi_1399_: bool;
    var phi_1400_: bool;
    var phi_1407_: u32;
    var phi_1408_: u32;
    var phi_1409_: u32;
    var phi_1410_: u32;
    var phi_1411_: u32;
    var phi_1412_: u32;
    var phi_1413_: u32;
    var phi_1425_: bool;
    var phi_1426_: bool;
    var phi_1427_: bool;
    var phi_1428_: bool;
    var phi_1432_: bool;
    var phi_1438_: bool;
    var phi_1446_: u32;
    var phi_1451_: u32;
    var phi_1460_: u32;
    var phi_1465_: u32;
    var phi_1469_: u32;
    var phi_1470_: u32;
    var phi_1471_: u32;
    var phi_1475_: f32;
    var phi_1477_: mask_Masked;
    var phi_1549_: bool;
    var phi_1550_: bool;
    var phi_1551_: bool;
    var phi_1552_: bool;
    var phi_1556_: bool;
    var phi_1584_: f32;
    var phi_1587_: bool;
    var phi_1588_: u32;
    var phi_1599_: u32;
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
                phi_373_ = (_e136 == _e138);
                phi_374_ = false;
            } else {
                phi_373_ = bool();
                phi_374_ = true;
            }
            let _e141 = phi_373_;
            let _e143 = phi_374_;
            phi_375_ = _e141;
            phi_376_ = _e143;
        } else {
            phi_375_ = bool();
            phi_376_ = true;
        }
        let _e145 = phi_375_;
        let _e147 = phi_376_;
        if _e147 {
            phi_380_ = false;
        } else {
            phi_380_ = _e145;
        }
        let _e149 = phi_380_;
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
                    phi_451_ = true;
                } else {
                    let _e202 = p.member.light.range_squared;
                    if (_e185 <= _e202) {
                        let _e205 = p.member.light.cos_outer;
                        phi_450_ = (-((((_e167 * _e187.x) + (_e168 * _e187.y)) + (_e169 * _e187.z))) >= (_e205 * sqrt(_e185)));
                    } else {
                        phi_450_ = false;
                    }
                    let _e210 = phi_450_;
                    phi_451_ = _e210;
                }
                let _e212 = phi_451_;
                if _e212 {
                    let _e214 = samples.member[_e81.shift].flags;
                    let _e222 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e228 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e222.unnamed.visibility, false), _e222.unnamed_1);
                    phi_462_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e228.unnamed, ((_e214 & 1u) == 0u));
                    phi_463_ = false;
                } else {
                    phi_462_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_463_ = true;
                }
                let _e233 = phi_462_;
                let _e235 = phi_463_;
                phi_464_ = _e233;
                phi_465_ = _e235;
            } else {
                phi_464_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_465_ = true;
            }
            let _e237 = phi_464_;
            let _e239 = phi_465_;
            if _e239 {
                let _e245 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e251 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e245.unnamed.visibility, false), _e245.unnamed_1);
                phi_472_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e251.unnamed, true);
            } else {
                phi_472_ = _e237;
            }
            let _e256 = phi_472_;
            phi_476_ = _e256;
        } else {
            let _e262 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e268 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e262.unnamed.visibility, false), _e262.unnamed_1);
            phi_476_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e268.unnamed, true);
        }
        let _e273 = phi_476_;
        if _e273.unnamed_1 {
            phi_1477_ = mask_Masked(_e273.unnamed.visibility, 0u, false);
        } else {
            let _e278 = (_e120 < 0.5f);
            if (_e120 > 0f) {
                phi_489_ = (_e120 < 1f);
            } else {
                phi_489_ = false;
            }
            let _e282 = phi_489_;
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
            let _e443 = p.member.current.size[0u];
            let _e445 = p.member.current.size[1u];
            let _e449 = ((f32(_e60.x) + 0.5f) + _e433);
            if (_e449 > -8388608f) {
                let _e461 = f32(select(0i, select(select(i32(_e449), i32(-2147483648), (_e449 < bitcast<f32>(3472883712u))), 2147483647i, (_e449 > bitcast<f32>(1325400063u))), (_e449 == _e449)));
                if (_e461 > _e449) {
                    phi_675_ = 1f;
                } else {
                    phi_675_ = 0f;
                }
                let _e464 = phi_675_;
                if (_e449 < 8388608f) {
                    phi_680_ = (_e461 - _e464);
                    phi_681_ = false;
                } else {
                    phi_680_ = f32();
                    phi_681_ = true;
                }
                let _e467 = phi_680_;
                let _e469 = phi_681_;
                phi_682_ = _e467;
                phi_683_ = _e469;
            } else {
                phi_682_ = f32();
                phi_683_ = true;
            }
            let _e471 = phi_682_;
            let _e473 = phi_683_;
            if _e473 {
                phi_687_ = _e449;
            } else {
                phi_687_ = _e471;
            }
            let _e475 = phi_687_;
            let _e478 = ((f32(_e60.y) + 0.5f) + _e439);
            if (_e478 > -8388608f) {
                let _e490 = f32(select(0i, select(select(i32(_e478), i32(-2147483648), (_e478 < bitcast<f32>(3472883712u))), 2147483647i, (_e478 > bitcast<f32>(1325400063u))), (_e478 == _e478)));
                if (_e490 > _e478) {
                    phi_710_ = 1f;
                } else {
                    phi_710_ = 0f;
                }
                let _e493 = phi_710_;
                if (_e478 < 8388608f) {
                    phi_715_ = (_e490 - _e493);
                    phi_716_ = false;
                } else {
                    phi_715_ = f32();
                    phi_716_ = true;
                }
                let _e496 = phi_715_;
                let _e498 = phi_716_;
                phi_717_ = _e496;
                phi_718_ = _e498;
            } else {
                phi_717_ = f32();
                phi_718_ = true;
            }
            let _e500 = phi_717_;
            let _e502 = phi_718_;
            if _e502 {
                phi_722_ = _e478;
            } else {
                phi_722_ = _e500;
            }
            let _e504 = phi_722_;
            if (_e475 >= 0f) {
                if (_e504 >= 0f) {
                    if (_e475 < f32(_e443)) {
                        let _e510 = (_e504 < f32(_e445));
                        if (_e433 == 0f) {
                            phi_743_ = (_e439 == 0f);
                        } else {
                            phi_743_ = false;
                        }
                        let _e514 = phi_743_;
                        if _e510 {
                            phi_762_ = vec2<u32>(select(select(u32(_e475), 0u, (_e475 < bitcast<f32>(0u))), 4294967295u, (_e475 > bitcast<f32>(1333788671u))), select(select(u32(_e504), 0u, (_e504 < bitcast<f32>(0u))), 4294967295u, (_e504 > bitcast<f32>(1333788671u))));
                            phi_763_ = false;
                        } else {
                            phi_762_ = vec2<u32>();
                            phi_763_ = true;
                        }
                        let _e531 = phi_762_;
                        let _e533 = phi_763_;
                        phi_764_ = _e514;
                        phi_765_ = _e510;
                        phi_766_ = _e531;
                        phi_767_ = _e514;
                        phi_768_ = _e510;
                        phi_769_ = false;
                        phi_770_ = _e533;
                    } else {
                        phi_764_ = bool();
                        phi_765_ = bool();
                        phi_766_ = vec2<u32>();
                        phi_767_ = bool();
                        phi_768_ = bool();
                        phi_769_ = true;
                        phi_770_ = false;
                    }
                    let _e535 = phi_764_;
                    let _e537 = phi_765_;
                    let _e539 = phi_766_;
                    let _e541 = phi_767_;
                    let _e543 = phi_768_;
                    let _e545 = phi_769_;
                    let _e547 = phi_770_;
                    phi_771_ = _e535;
                    phi_772_ = _e537;
                    phi_773_ = _e539;
                    phi_774_ = _e541;
                    phi_775_ = _e543;
                    phi_776_ = _e545;
                    phi_777_ = _e547;
                } else {
                    phi_771_ = bool();
                    phi_772_ = bool();
                    phi_773_ = vec2<u32>();
                    phi_774_ = bool();
                    phi_775_ = bool();
                    phi_776_ = true;
                    phi_777_ = false;
                }
                let _e549 = phi_771_;
                let _e551 = phi_772_;
                let _e553 = phi_773_;
                let _e555 = phi_774_;
                let _e557 = phi_775_;
                let _e559 = phi_776_;
                let _e561 = phi_777_;
                phi_778_ = _e549;
                phi_779_ = _e551;
                phi_780_ = _e553;
                phi_781_ = _e555;
                phi_782_ = _e557;
                phi_783_ = _e559;
                phi_784_ = _e561;
            } else {
                phi_778_ = bool();
                phi_779_ = bool();
                phi_780_ = vec2<u32>();
                phi_781_ = bool();
                phi_782_ = bool();
                phi_783_ = true;
                phi_784_ = false;
            }
            let _e563 = phi_778_;
            let _e565 = phi_779_;
            let _e567 = phi_780_;
            let _e569 = phi_781_;
            let _e571 = phi_782_;
            let _e573 = phi_783_;
            let _e575 = phi_784_;
            if _e573 {
                if (_e433 == 0f) {
                    phi_793_ = (_e439 == 0f);
                } else {
                    phi_793_ = false;
                }
                let _e579 = phi_793_;
                phi_794_ = _e579;
                phi_795_ = false;
                phi_796_ = true;
            } else {
                phi_794_ = _e569;
                phi_795_ = _e571;
                phi_796_ = _e575;
            }
            let _e581 = phi_794_;
            let _e583 = phi_795_;
            let _e585 = phi_796_;
            if _e585 {
                phi_800_ = _e581;
                phi_801_ = _e583;
                phi_802_ = vec2<u32>(_e60.x, _e60.y);
            } else {
                phi_800_ = _e563;
                phi_801_ = _e565;
                phi_802_ = _e567;
            }
            let _e587 = phi_800_;
            let _e589 = phi_801_;
            let _e591 = phi_802_;
            let _e601 = lt_mask_Reprojection(vec2<u32>(_e591.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e608 = lt_mask_Reprojection(vec2<u32>(_e601.pixel.x, _e591.y), _e601.is_valid, _e601.has_moved);
            let _e612 = lt_mask_Reprojection(_e608.pixel, _e589, _e608.has_moved);
            let _e616 = lt_mask_Reprojection(_e612.pixel, _e612.is_valid, !(_e587));
            if _e589 {
                let _e619 = p.member.previous.eye;
                let _e627 = p.member.previous.forward;
                let _e636 = (((((_e115.x - _e619.x) * _e627.x) + ((_e115.y - _e619.y) * _e627.y)) + ((_e115.z - _e619.z) * _e627.z)) > 0f);
                let _e640 = lt_mask_Reprojection(_e616.pixel, _e636, _e616.has_moved);
                if _e636 {
                    let _e643 = p.member.previous.eye;
                    let _e651 = p.member.previous.forward;
                    let _e659 = ((((_e115.x - _e643.x) * _e651.x) + ((_e115.y - _e643.y) * _e651.y)) + ((_e115.z - _e643.z) * _e651.z));
                    let _e661 = ((_e591.y * _e112) + _e591.x);
                    if (_e661 < arrayLength((&last_depths.member))) {
                    } else {
                        return;
                    }
                    let _e665 = last_depths.member[(0u + _e661)];
                    let _e667 = p.member.depth_tolerance;
                    let _e670 = abs(_e659);
                    let _e671 = abs(_e665);
                    if ((bitcast<u32>(_e671) & 2147483647u) > 2139095040u) {
                        phi_885_ = true;
                    } else {
                        let _e675 = (_e671 > _e670);
                        if _e675 {
                        }
                        phi_885_ = _e675;
                    }
                    let _e677 = phi_885_;
                    if _e677 {
                        phi_889_ = _e671;
                    } else {
                        phi_889_ = _e670;
                    }
                    let _e679 = phi_889_;
                    phi_893_ = lt_mask_Reprojection(_e640.pixel, (abs((_e659 - _e665)) <= (_e667 * _e679)), _e640.has_moved);
                } else {
                    phi_893_ = _e640;
                }
                let _e687 = phi_893_;
                if _e687.is_valid {
                    let _e690 = p.member.flags;
                    phi_902_ = ((_e690 & 1u) != 0u);
                    phi_903_ = false;
                } else {
                    phi_902_ = bool();
                    phi_903_ = true;
                }
                let _e694 = phi_902_;
                let _e696 = phi_903_;
                phi_905_ = _e694;
                phi_906_ = _e687;
                phi_907_ = _e687;
                phi_908_ = _e696;
            } else {
                phi_905_ = bool();
                phi_906_ = lt_mask_Reprojection();
                phi_907_ = lt_mask_Reprojection(_e616.pixel, false, _e616.has_moved);
                phi_908_ = true;
            }
            let _e702 = phi_905_;
            let _e704 = phi_906_;
            let _e706 = phi_907_;
            let _e708 = phi_908_;
            if _e708 {
                phi_912_ = false;
                phi_913_ = _e706;
            } else {
                phi_912_ = _e702;
                phi_913_ = _e704;
            }
            let _e710 = phi_912_;
            let _e712 = phi_913_;
            let _e716 = lt_mask_Reprojection(_e712.pixel, _e710, _e712.has_moved);
            let _e718 = p.member.flags;
            let _e720 = ((_e718 & 2u) != 0u);
            let _e722 = p.member.flags;
            if ((_e722 & 4u) == 0u) {
                phi_989_ = u32();
                phi_990_ = true;
                phi_991_ = false;
            } else {
                if _e710 {
                    if !(_e716.has_moved) {
                        let _e733 = ((((_e60.y * _e112) + _e60.x) * _e108.words) + _e108.light.word);
                        if (_e108.light.shift > 29u) {
                            let _e737 = (_e733 + 1u);
                            if (_e737 < _e66) {
                            } else {
                                return;
                            }
                            let _e741 = last_bits.member[(0u + _e737)];
                            phi_956_ = _e741;
                        } else {
                            phi_956_ = 0u;
                        }
                        let _e743 = phi_956_;
                        if (_e733 < _e66) {
                        } else {
                            return;
                        }
                        let _e749 = last_bits.member[(0u + _e733)];
                        let _e752 = (_e749 >> bitcast<u32>((_e108.light.shift & 31u)));
                        if (_e108.light.shift > 29u) {
                            phi_975_ = (_e752 | (_e743 << bitcast<u32>(((32u - _e108.light.shift) & 31u))));
                        } else {
                            phi_975_ = _e752;
                        }
                        let _e760 = phi_975_;
                        if ((_e760 & 2u) == 0u) {
                            phi_983_ = (_e760 & 1u);
                        } else {
                            phi_983_ = (_e760 & 7u);
                        }
                        let _e766 = phi_983_;
                        phi_984_ = _e766;
                        phi_985_ = false;
                    } else {
                        phi_984_ = u32();
                        phi_985_ = true;
                    }
                    let _e768 = phi_984_;
                    let _e770 = phi_985_;
                    phi_986_ = _e768;
                    phi_987_ = false;
                    phi_988_ = _e770;
                } else {
                    phi_986_ = u32();
                    phi_987_ = true;
                    phi_988_ = false;
                }
                let _e772 = phi_986_;
                let _e774 = phi_987_;
                let _e776 = phi_988_;
                phi_989_ = _e772;
                phi_990_ = _e774;
                phi_991_ = _e776;
            }
            let _e778 = phi_989_;
            let _e780 = phi_990_;
            let _e782 = phi_991_;
            if _e780 {
                phi_995_ = true;
            } else {
                phi_995_ = _e782;
            }
            let _e784 = phi_995_;
            if _e784 {
                phi_999_ = 0u;
            } else {
                phi_999_ = _e778;
            }
            let _e786 = phi_999_;
            let _e787 = lt_mask_Neighbourhood(false, true);
            if _e282 {
                phi_1004_ = _e720;
            } else {
                phi_1004_ = true;
            }
            let _e789 = phi_1004_;
            if _e789 {
                if _e710 {
                    if ((_e786 & 2u) != 0u) {
                        phi_1299_ = _e787;
                    } else {
                        let _e793 = p.member.expansion;
                        if _e716.has_moved {
                            let _e796 = p.member.moving_pattern;
                            phi_1026_ = _e796;
                        } else {
                            let _e798 = p.member.still_pattern;
                            phi_1026_ = _e798;
                        }
                        let _e800 = phi_1026_;
                        phi_1028_ = 0u;
                        phi_1031_ = _e787;
                        loop {
                            let _e802 = phi_1028_;
                            let _e804 = phi_1031_;
                            local_1 = _e804;
                            if (1u <= _e800) {
                                if (_e800 <= 4u) {
                                    phi_1043_ = false;
                                } else {
                                    phi_1043_ = true;
                                }
                                let _e808 = phi_1043_;
                                phi_1044_ = _e808;
                            } else {
                                phi_1044_ = true;
                            }
                            let _e810 = phi_1044_;
                            if _e810 {
                                switch bitcast<i32>(_e800) {
                                    case 5: {
                                        phi_1053_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_1053_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_1053_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_1053_ = 9u;
                                        break;
                                    }
                                }
                                let _e813 = phi_1053_;
                                phi_1054_ = _e813;
                            } else {
                                phi_1054_ = 5u;
                            }
                            let _e815 = phi_1054_;
                            let _e816 = (_e802 < _e815);
                            if _e816 {
                                let _e822 = p.member.frame;
                                let _e826 = p.member.current.size[0u];
                                let _e828 = p.member.current.size[1u];
                                switch bitcast<i32>(_e800) {
                                    case 1: {
                                        let _e838 = lt_mask_pattern_plus(_e802);
                                        phi_1134_ = vec2<i32>(_e838.x, _e838.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e842 = lt_mask_pattern_cross(_e802);
                                        phi_1134_ = vec2<i32>(_e842.x, _e842.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e848 = lt_mask_pattern_plus_or_cross(_e802, ((_e716.pixel.x + _e716.pixel.y) & 1u));
                                        phi_1134_ = vec2<i32>(_e848.x, _e848.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e853 = lt_mask_pattern_plus_or_cross(_e802, (_e822 & 1u));
                                        phi_1134_ = vec2<i32>(_e853.x, _e853.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e822 & 3u)) {
                                            case 0: {
                                                phi_1114_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_1114_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_1114_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_1114_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e864 = phi_1114_;
                                        phi_1134_ = (_e864 + vec2<i32>(bitcast<i32>((_e802 & 1u)), bitcast<i32>(((_e802 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_1134_ = vec2<i32>((bitcast<i32>((_e802 % 5u)) - 2i), (bitcast<i32>(((_e802 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e881 = lt_mask_pattern_diamond(_e802);
                                        phi_1134_ = vec2<i32>(_e881.x, _e881.y);
                                        break;
                                    }
                                    default: {
                                        phi_1134_ = vec2<i32>((bitcast<i32>((_e802 % 3u)) - 1i), (bitcast<i32>(((_e802 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e886 = phi_1134_;
                                let _e889 = lt_mask_pattern_step_clamped(_e716.pixel.x, _e886.x, _e826);
                                let _e890 = lt_mask_pattern_step_clamped(_e716.pixel.y, _e886.y, _e828);
                                let _e897 = ((((_e890 * _e112) + _e889) * _e108.words) + _e108.light.word);
                                if (_e108.light.shift > 29u) {
                                    let _e901 = (_e897 + 1u);
                                    if (_e901 < _e66) {
                                    } else {
                                        return;
                                    }
                                    let _e905 = last_bits.member[(0u + _e901)];
                                    phi_1161_ = _e905;
                                } else {
                                    phi_1161_ = 0u;
                                }
                                let _e907 = phi_1161_;
                                if (_e897 < _e66) {
                                } else {
                                    return;
                                }
                                let _e913 = last_bits.member[(0u + _e897)];
                                let _e916 = (_e913 >> bitcast<u32>((_e108.light.shift & 31u)));
                                if (_e108.light.shift > 29u) {
                                    phi_1180_ = (_e916 | (_e907 << bitcast<u32>(((32u - _e108.light.shift) & 31u))));
                                } else {
                                    phi_1180_ = _e916;
                                }
                                let _e924 = phi_1180_;
                                if ((_e924 & 2u) == 0u) {
                                    phi_1188_ = (_e924 & 1u);
                                } else {
                                    phi_1188_ = (_e924 & 7u);
                                }
                                let _e930 = phi_1188_;
                                if _e804.any_expands {
                                    phi_1276_ = true;
                                } else {
                                    if ((_e930 & 2u) != 0u) {
                                        let _e937 = (((_e930 & 4u) != 0u) != _e278);
                                        switch bitcast<i32>(_e793) {
                                            case 1: {
                                                phi_1216_ = bool();
                                                phi_1217_ = false;
                                                phi_1218_ = true;
                                                phi_1219_ = false;
                                                phi_1220_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e937 {
                                                    phi_1214_ = (((_e930 & 4u) != 0u) != ((_e930 & 1u) != 0u));
                                                    phi_1215_ = false;
                                                } else {
                                                    phi_1214_ = bool();
                                                    phi_1215_ = true;
                                                }
                                                let _e945 = phi_1214_;
                                                let _e947 = phi_1215_;
                                                phi_1216_ = _e945;
                                                phi_1217_ = false;
                                                phi_1218_ = false;
                                                phi_1219_ = _e947;
                                                phi_1220_ = _e937;
                                                break;
                                            }
                                            default: {
                                                phi_1216_ = bool();
                                                phi_1217_ = true;
                                                phi_1218_ = false;
                                                phi_1219_ = false;
                                                phi_1220_ = false;
                                                break;
                                            }
                                        }
                                        let _e949 = phi_1216_;
                                        let _e951 = phi_1217_;
                                        let _e953 = phi_1218_;
                                        let _e955 = phi_1219_;
                                        let _e957 = phi_1220_;
                                        phi_1228_ = _e937;
                                        phi_1229_ = _e949;
                                        phi_1230_ = _e951;
                                        phi_1231_ = _e953;
                                        phi_1232_ = _e955;
                                        phi_1233_ = _e957;
                                    } else {
                                        switch bitcast<i32>(_e793) {
                                            case 1: {
                                                phi_1225_ = false;
                                                phi_1226_ = true;
                                                phi_1227_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_1225_ = false;
                                                phi_1226_ = false;
                                                phi_1227_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_1225_ = true;
                                                phi_1226_ = false;
                                                phi_1227_ = false;
                                                break;
                                            }
                                        }
                                        let _e960 = phi_1225_;
                                        let _e962 = phi_1226_;
                                        let _e964 = phi_1227_;
                                        phi_1228_ = false;
                                        phi_1229_ = bool();
                                        phi_1230_ = _e960;
                                        phi_1231_ = _e962;
                                        phi_1232_ = _e964;
                                        phi_1233_ = false;
                                    }
                                    let _e966 = phi_1228_;
                                    let _e968 = phi_1229_;
                                    let _e970 = phi_1230_;
                                    let _e972 = phi_1231_;
                                    let _e974 = phi_1232_;
                                    let _e976 = phi_1233_;
                                    if _e970 {
                                        if ((_e930 & 2u) != 0u) {
                                            if (((_e930 & 4u) != 0u) != _e278) {
                                                phi_1248_ = false;
                                            } else {
                                                phi_1248_ = true;
                                            }
                                            let _e983 = phi_1248_;
                                            phi_1249_ = _e983;
                                        } else {
                                            phi_1249_ = true;
                                        }
                                        let _e985 = phi_1249_;
                                        if _e985 {
                                            phi_1256_ = (((_e930 & 1u) != 0u) != _e278);
                                        } else {
                                            phi_1256_ = true;
                                        }
                                        let _e990 = phi_1256_;
                                        phi_1257_ = _e990;
                                        phi_1258_ = false;
                                        phi_1259_ = false;
                                        phi_1260_ = false;
                                    } else {
                                        phi_1257_ = bool();
                                        phi_1258_ = _e972;
                                        phi_1259_ = _e974;
                                        phi_1260_ = _e976;
                                    }
                                    let _e992 = phi_1257_;
                                    let _e994 = phi_1258_;
                                    let _e996 = phi_1259_;
                                    let _e998 = phi_1260_;
                                    if _e994 {
                                        phi_1264_ = _e966;
                                        phi_1265_ = false;
                                        phi_1266_ = false;
                                    } else {
                                        phi_1264_ = _e992;
                                        phi_1265_ = _e996;
                                        phi_1266_ = _e998;
                                    }
                                    let _e1000 = phi_1264_;
                                    let _e1002 = phi_1265_;
                                    let _e1004 = phi_1266_;
                                    if _e1002 {
                                        phi_1270_ = false;
                                        phi_1271_ = true;
                                    } else {
                                        phi_1270_ = _e968;
                                        phi_1271_ = _e1004;
                                    }
                                    let _e1006 = phi_1270_;
                                    let _e1008 = phi_1271_;
                                    if _e1008 {
                                        phi_1275_ = _e1006;
                                    } else {
                                        phi_1275_ = _e1000;
                                    }
                                    let _e1010 = phi_1275_;
                                    phi_1276_ = _e1010;
                                }
                                let _e1012 = phi_1276_;
                                if _e804.all_remove {
                                    if (((_e930 & 1u) != 0u) == _e278) {
                                        if ((_e930 & 2u) != 0u) {
                                            phi_1294_ = (((_e930 & 4u) != 0u) == _e278);
                                        } else {
                                            phi_1294_ = true;
                                        }
                                        let _e1022 = phi_1294_;
                                        phi_1295_ = _e1022;
                                    } else {
                                        phi_1295_ = false;
                                    }
                                    let _e1024 = phi_1295_;
                                    phi_1296_ = _e1024;
                                } else {
                                    phi_1296_ = false;
                                }
                                let _e1026 = phi_1296_;
                                phi_1029_ = (_e802 + 1u);
                                phi_1032_ = lt_mask_Neighbourhood(_e1012, _e1026);
                            } else {
                                phi_1029_ = u32();
                                phi_1032_ = lt_mask_Neighbourhood();
                            }
                            let _e1030 = phi_1029_;
                            let _e1032 = phi_1032_;
                            continue;
                            continuing {
                                phi_1028_ = _e1030;
                                phi_1031_ = _e1032;
                                break if !(_e816);
                            }
                        }
                        let _e1391 = local_1;
                        phi_1299_ = _e1391;
                    }
                    let _e1035 = phi_1299_;
                    phi_1300_ = _e1035;
                } else {
                    phi_1300_ = _e787;
                }
                let _e1037 = phi_1300_;
                phi_1301_ = _e1037;
            } else {
                phi_1301_ = _e787;
            }
            let _e1039 = phi_1301_;
            let _e1042 = p.member.frame;
            let _e1044 = p.member.refresh;
            if (_e1044 == 0u) {
                phi_1334_ = false;
            } else {
                if (_e1044 == 0u) {
                    return;
                }
                let _e1053 = ((_e60.x + (_e60.y * (((_e1044 * 5u) / 8u) | 1u))) + (_e1042 % _e1044));
                if (_e1044 == 0u) {
                    phi_1333_ = (_e1053 == 0u);
                } else {
                    if (_e1044 == 0u) {
                        return;
                    }
                    phi_1333_ = ((_e1053 % _e1044) == 0u);
                }
                let _e1060 = phi_1333_;
                phi_1334_ = _e1060;
            }
            let _e1062 = phi_1334_;
            if _e710 {
                if _e1062 {
                    phi_1356_ = bool();
                } else {
                    phi_1356_ = ((_e786 & 2u) != 0u);
                }
                let _e1068 = phi_1356_;
                phi_1357_ = _e1068;
                phi_1358_ = _e1062;
            } else {
                phi_1357_ = bool();
                phi_1358_ = true;
            }
            let _e1070 = phi_1357_;
            let _e1072 = phi_1358_;
            if _e1072 {
                phi_1362_ = false;
            } else {
                phi_1362_ = _e1070;
            }
            let _e1074 = phi_1362_;
            if _e1074 {
                phi_1413_ = 7u;
            } else {
                if (_e120 != 0.5f) {
                    if _e710 {
                        if _e1062 {
                            phi_1410_ = 6u;
                        } else {
                            if _e282 {
                                phi_1385_ = true;
                            } else {
                                if _e1039.any_expands {
                                    phi_1384_ = false;
                                } else {
                                    phi_1384_ = true;
                                }
                                let _e1076 = phi_1384_;
                                phi_1385_ = _e1076;
                            }
                            let _e1078 = phi_1385_;
                            if _e1078 {
                                if _e282 {
                                    if _e720 {
                                        if _e1039.all_remove {
                                            phi_1398_ = false;
                                        } else {
                                            phi_1398_ = true;
                                        }
                                        let _e1080 = phi_1398_;
                                        phi_1399_ = _e1080;
                                    } else {
                                        phi_1399_ = true;
                                    }
                                    let _e1082 = phi_1399_;
                                    phi_1400_ = _e1082;
                                } else {
                                    phi_1400_ = true;
                                }
                                let _e1084 = phi_1400_;
                                if _e1084 {
                                    if _e282 {
                                        phi_1407_ = 1u;
                                    } else {
                                        phi_1407_ = 0u;
                                    }
                                    let _e1086 = phi_1407_;
                                    phi_1408_ = _e1086;
                                } else {
                                    phi_1408_ = 5u;
                                }
                                let _e1088 = phi_1408_;
                                phi_1409_ = _e1088;
                            } else {
                                phi_1409_ = 4u;
                            }
                            let _e1090 = phi_1409_;
                            phi_1410_ = _e1090;
                        }
                        let _e1092 = phi_1410_;
                        phi_1411_ = _e1092;
                    } else {
                        phi_1411_ = 3u;
                    }
                    let _e1094 = phi_1411_;
                    phi_1412_ = _e1094;
                } else {
                    phi_1412_ = 2u;
                }
                let _e1096 = phi_1412_;
                phi_1413_ = _e1096;
            }
            let _e1098 = phi_1413_;
            if !((_e1098 == 0u)) {
                if !((_e1098 == 5u)) {
                    phi_1425_ = !(_e1074);
                    phi_1426_ = false;
                } else {
                    phi_1425_ = bool();
                    phi_1426_ = true;
                }
                let _e1105 = phi_1425_;
                let _e1107 = phi_1426_;
                phi_1427_ = _e1105;
                phi_1428_ = _e1107;
            } else {
                phi_1427_ = bool();
                phi_1428_ = true;
            }
            let _e1109 = phi_1427_;
            let _e1111 = phi_1428_;
            if _e1111 {
                phi_1432_ = false;
            } else {
                phi_1432_ = _e1109;
            }
            let _e1113 = phi_1432_;
            if _e1074 {
                phi_1438_ = ((_e786 & 4u) != 0u);
            } else {
                phi_1438_ = _e278;
            }
            let _e1117 = phi_1438_;
            if _e1113 {
                if _e278 {
                    phi_1446_ = (2u | 1u);
                } else {
                    phi_1446_ = 2u;
                }
                let _e1120 = phi_1446_;
                if false {
                    phi_1451_ = (_e1120 | 4u);
                } else {
                    phi_1451_ = _e1120;
                }
                let _e1123 = phi_1451_;
                phi_1471_ = _e1123;
            } else {
                if (_e1098 == 7u) {
                    if _e278 {
                        phi_1460_ = (2u | 1u);
                    } else {
                        phi_1460_ = 2u;
                    }
                    let _e1127 = phi_1460_;
                    if _e1117 {
                        phi_1465_ = (_e1127 | 4u);
                    } else {
                        phi_1465_ = _e1127;
                    }
                    let _e1130 = phi_1465_;
                    phi_1470_ = _e1130;
                } else {
                    if _e278 {
                        phi_1469_ = 1u;
                    } else {
                        phi_1469_ = 0u;
                    }
                    let _e1132 = phi_1469_;
                    phi_1470_ = _e1132;
                }
                let _e1134 = phi_1470_;
                phi_1471_ = _e1134;
            }
            let _e1136 = phi_1471_;
            if _e1117 {
                phi_1475_ = 0f;
            } else {
                phi_1475_ = 1f;
            }
            let _e1138 = phi_1475_;
            phi_1477_ = mask_Masked(_e1138, _e1136, _e1113);
        }
        let _e1141 = phi_1477_;
        visibility.member[_e81.shift] = _e1141.visibility;
        let _e1146 = p.member.light.number;
        let _e1147 = (_e1146 * 3u);
        let _e1149 = (_e1147 % 32u);
        let _e1151 = p.member.light.mask_words;
        let _e1153 = ((_e81.shift * _e1151) + (_e1147 / 32u));
        let _e1155 = bits.member[_e1153];
        bits.member[_e1153] = ((_e1155 & ~((7u << bitcast<u32>((_e1149 & 31u))))) | (_e1141.bits << bitcast<u32>((_e1149 & 31u))));
        if (_e1149 > 29u) {
            let _e1170 = bits.member[(_e1153 + 1u)];
            let _e1172 = (32u - _e1149);
            bits.member[(_e1153 + 1u)] = ((_e1170 & ~((7u >> bitcast<u32>((_e1172 & 31u))))) | (_e1141.bits >> bitcast<u32>((_e1172 & 31u))));
        }
        let _e1187 = samples.member[_e81.shift].normal[0u];
        let _e1189 = global[0u];
        if (_e1187 == _e1189) {
            let _e1192 = samples.member[_e81.shift].normal[1u];
            let _e1194 = global[1u];
            if (_e1192 == _e1194) {
                let _e1197 = samples.member[_e81.shift].normal[2u];
                let _e1199 = global[2u];
                phi_1549_ = (_e1197 == _e1199);
                phi_1550_ = false;
            } else {
                phi_1549_ = bool();
                phi_1550_ = true;
            }
            let _e1202 = phi_1549_;
            let _e1204 = phi_1550_;
            phi_1551_ = _e1202;
            phi_1552_ = _e1204;
        } else {
            phi_1551_ = bool();
            phi_1552_ = true;
        }
        let _e1206 = phi_1551_;
        let _e1208 = phi_1552_;
        if _e1208 {
            phi_1556_ = false;
        } else {
            phi_1556_ = _e1206;
        }
        let _e1210 = phi_1556_;
        if !(_e1210) {
            let _e1213 = samples.member[_e81.shift].position;
            let _e1215 = p.member.current.eye;
            let _e1226 = p.member.current.forward;
            phi_1584_ = ((((_e1213.x - _e1215.x) * _e1226.x) + ((_e1213.y - _e1215.y) * _e1226.y)) + ((_e1213.z - _e1215.z) * _e1226.z));
        } else {
            phi_1584_ = 0f;
        }
        let _e1236 = phi_1584_;
        depths.member[_e81.shift] = _e1236;
        phi_1587_ = _e1141.needs_ray;
        phi_1588_ = _e81.shift;
    } else {
        phi_1587_ = false;
        phi_1588_ = 0u;
    }
    let _e1240 = phi_1587_;
    let _e1242 = phi_1588_;
    if (_e61 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1240 {
        let _e1246 = atomicAdd((&shared_[0u]), 1u);
        phi_1599_ = _e1246;
    } else {
        phi_1599_ = 0u;
    }
    let _e1248 = phi_1599_;
    workgroupBarrier();
    if (_e61 == 0u) {
        let _e1252 = atomicLoad((&shared_[0u]));
        let _e1253 = atomicAdd((&list.member[3u]), _e1252);
        atomicStore((&shared_[1u]), _e1253);
    }
    workgroupBarrier();
    if _e1240 {
        let _e1256 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1256) + _e1248)]), _e1242);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_depth_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
