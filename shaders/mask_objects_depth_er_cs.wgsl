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
    var phi_919_: bool;
    var phi_941_: u32;
    var phi_943_: u32;
    var phi_946_: lt_mask_Neighbourhood;
    var phi_958_: bool;
    var phi_959_: bool;
    var phi_968_: u32;
    var phi_969_: u32;
    var phi_1029_: vec2<i32>;
    var phi_1049_: vec2<i32>;
    var phi_1076_: u32;
    var phi_1095_: u32;
    var phi_1103_: u32;
    var phi_1129_: bool;
    var phi_1130_: bool;
    var phi_1131_: bool;
    var phi_1132_: bool;
    var phi_1133_: bool;
    var phi_1134_: bool;
    var phi_1135_: bool;
    var phi_1140_: bool;
    var phi_1141_: bool;
    var phi_1142_: bool;
    var phi_1143_: bool;
    var phi_1144_: bool;
    var phi_1145_: bool;
    var phi_1146_: bool;
    var phi_1147_: bool;
    var phi_1148_: bool;
    var phi_1163_: bool;
    var phi_1164_: bool;
    var phi_1171_: bool;
    var phi_1172_: bool;
    var phi_1173_: bool;
    var phi_1174_: bool;
    var phi_1175_: bool;
    var phi_1179_: bool;
    var phi_1180_: bool;
    var phi_1181_: bool;
    var phi_1185_: bool;
    var phi_1186_: bool;
    var phi_1190_: bool;
    var phi_1191_: bool;
    var phi_1209_: bool;
    var phi_1210_: bool;
    var phi_1211_: bool;
    var phi_944_: u32;
    var phi_947_: lt_mask_Neighbourhood;
    var phi_1214_: lt_mask_Neighbourhood;
    var phi_1215_: lt_mask_Neighbourhood;
    var phi_1216_: lt_mask_Neighbourhood;
    var phi_1248_: bool;
    var phi_1249_: bool;
    var phi_1271_: bool;
    var phi_1272_: bool;
    var phi_1273_: bool;
    var phi_1277_: bool;
    var phi_1299_: bool;
    var phi_1300_: bool;
    var phi_1313_: bool;
    var phi_1314_: bool;
    var phi_1315_: bool;
    var phi_1322_: u32;
    var phi_1323_: u32;
    var phi_1324_: u32;
    var phi_1325_: u32;
    var phi_1326_: u32;
    var phi_1327_: u32;
    var phi_1328_: u32;
    var phi_1340_: bool;
    var phi_1341_: bool;
    var phi_1342_: bool;
    var phi_1343_: bool;
    var phi_1347_: bool;
    var phi_1353_: bool;
    var phi_1361_: u32;
    var phi_1366_: u32;
    var phi_1375_: u32;
    var phi_1380_: u32;
    var phi_1384_: u32;
    var phi_1385_: u32;
    var phi_1386_: u32;
    var phi_1390_: f32;
    var phi_1392_: mask_Masked;
    var phi_1464_: bool;
    var phi_1465_: bool;
    var phi_1466_: bool;
    var phi_1467_: bool;
    var phi_1471_: bool;
    var phi_1499_: f32;
    var phi_1502_: bool;
    var phi_1503_: u32;
    var phi_1514_: u32;
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
            phi_1392_ = mask_Masked(_e273.unnamed.visibility, 0u, false);
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
            let _e717 = lt_mask_Neighbourhood(false, true);
            if _e282 {
                phi_919_ = false;
            } else {
                phi_919_ = true;
            }
            let _e719 = phi_919_;
            if _e719 {
                if _e710 {
                    if ((0u & 2u) != 0u) {
                        phi_1214_ = _e717;
                    } else {
                        let _e723 = p.member.expansion;
                        if _e716.has_moved {
                            let _e726 = p.member.moving_pattern;
                            phi_941_ = _e726;
                        } else {
                            let _e728 = p.member.still_pattern;
                            phi_941_ = _e728;
                        }
                        let _e730 = phi_941_;
                        phi_943_ = 0u;
                        phi_946_ = _e717;
                        loop {
                            let _e732 = phi_943_;
                            let _e734 = phi_946_;
                            local_1 = _e734;
                            if (1u <= _e730) {
                                if (_e730 <= 4u) {
                                    phi_958_ = false;
                                } else {
                                    phi_958_ = true;
                                }
                                let _e738 = phi_958_;
                                phi_959_ = _e738;
                            } else {
                                phi_959_ = true;
                            }
                            let _e740 = phi_959_;
                            if _e740 {
                                switch bitcast<i32>(_e730) {
                                    case 5: {
                                        phi_968_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_968_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_968_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_968_ = 9u;
                                        break;
                                    }
                                }
                                let _e743 = phi_968_;
                                phi_969_ = _e743;
                            } else {
                                phi_969_ = 5u;
                            }
                            let _e745 = phi_969_;
                            let _e746 = (_e732 < _e745);
                            if _e746 {
                                let _e752 = p.member.frame;
                                let _e756 = p.member.current.size[0u];
                                let _e758 = p.member.current.size[1u];
                                switch bitcast<i32>(_e730) {
                                    case 1: {
                                        let _e768 = lt_mask_pattern_plus(_e732);
                                        phi_1049_ = vec2<i32>(_e768.x, _e768.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e772 = lt_mask_pattern_cross(_e732);
                                        phi_1049_ = vec2<i32>(_e772.x, _e772.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e778 = lt_mask_pattern_plus_or_cross(_e732, ((_e716.pixel.x + _e716.pixel.y) & 1u));
                                        phi_1049_ = vec2<i32>(_e778.x, _e778.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e783 = lt_mask_pattern_plus_or_cross(_e732, (_e752 & 1u));
                                        phi_1049_ = vec2<i32>(_e783.x, _e783.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e752 & 3u)) {
                                            case 0: {
                                                phi_1029_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_1029_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_1029_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_1029_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e794 = phi_1029_;
                                        phi_1049_ = (_e794 + vec2<i32>(bitcast<i32>((_e732 & 1u)), bitcast<i32>(((_e732 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_1049_ = vec2<i32>((bitcast<i32>((_e732 % 5u)) - 2i), (bitcast<i32>(((_e732 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e811 = lt_mask_pattern_diamond(_e732);
                                        phi_1049_ = vec2<i32>(_e811.x, _e811.y);
                                        break;
                                    }
                                    default: {
                                        phi_1049_ = vec2<i32>((bitcast<i32>((_e732 % 3u)) - 1i), (bitcast<i32>(((_e732 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e816 = phi_1049_;
                                let _e819 = lt_mask_pattern_step_clamped(_e716.pixel.x, _e816.x, _e756);
                                let _e820 = lt_mask_pattern_step_clamped(_e716.pixel.y, _e816.y, _e758);
                                let _e827 = ((((_e820 * _e112) + _e819) * _e108.words) + _e108.light.word);
                                if (_e108.light.shift > 29u) {
                                    let _e831 = (_e827 + 1u);
                                    if (_e831 < _e66) {
                                    } else {
                                        return;
                                    }
                                    let _e835 = last_bits.member[(0u + _e831)];
                                    phi_1076_ = _e835;
                                } else {
                                    phi_1076_ = 0u;
                                }
                                let _e837 = phi_1076_;
                                if (_e827 < _e66) {
                                } else {
                                    return;
                                }
                                let _e843 = last_bits.member[(0u + _e827)];
                                let _e846 = (_e843 >> bitcast<u32>((_e108.light.shift & 31u)));
                                if (_e108.light.shift > 29u) {
                                    phi_1095_ = (_e846 | (_e837 << bitcast<u32>(((32u - _e108.light.shift) & 31u))));
                                } else {
                                    phi_1095_ = _e846;
                                }
                                let _e854 = phi_1095_;
                                if ((_e854 & 2u) == 0u) {
                                    phi_1103_ = (_e854 & 1u);
                                } else {
                                    phi_1103_ = (_e854 & 7u);
                                }
                                let _e860 = phi_1103_;
                                if _e734.any_expands {
                                    phi_1191_ = true;
                                } else {
                                    if ((_e860 & 2u) != 0u) {
                                        let _e867 = (((_e860 & 4u) != 0u) != _e278);
                                        switch bitcast<i32>(_e723) {
                                            case 1: {
                                                phi_1131_ = bool();
                                                phi_1132_ = false;
                                                phi_1133_ = true;
                                                phi_1134_ = false;
                                                phi_1135_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e867 {
                                                    phi_1129_ = (((_e860 & 4u) != 0u) != ((_e860 & 1u) != 0u));
                                                    phi_1130_ = false;
                                                } else {
                                                    phi_1129_ = bool();
                                                    phi_1130_ = true;
                                                }
                                                let _e875 = phi_1129_;
                                                let _e877 = phi_1130_;
                                                phi_1131_ = _e875;
                                                phi_1132_ = false;
                                                phi_1133_ = false;
                                                phi_1134_ = _e877;
                                                phi_1135_ = _e867;
                                                break;
                                            }
                                            default: {
                                                phi_1131_ = bool();
                                                phi_1132_ = true;
                                                phi_1133_ = false;
                                                phi_1134_ = false;
                                                phi_1135_ = false;
                                                break;
                                            }
                                        }
                                        let _e879 = phi_1131_;
                                        let _e881 = phi_1132_;
                                        let _e883 = phi_1133_;
                                        let _e885 = phi_1134_;
                                        let _e887 = phi_1135_;
                                        phi_1143_ = _e867;
                                        phi_1144_ = _e879;
                                        phi_1145_ = _e881;
                                        phi_1146_ = _e883;
                                        phi_1147_ = _e885;
                                        phi_1148_ = _e887;
                                    } else {
                                        switch bitcast<i32>(_e723) {
                                            case 1: {
                                                phi_1140_ = false;
                                                phi_1141_ = true;
                                                phi_1142_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_1140_ = false;
                                                phi_1141_ = false;
                                                phi_1142_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_1140_ = true;
                                                phi_1141_ = false;
                                                phi_1142_ = false;
                                                break;
                                            }
                                        }
                                        let _e890 = phi_1140_;
                                        let _e892 = phi_1141_;
                                        let _e894 = phi_1142_;
                                        phi_1143_ = false;
                                        phi_1144_ = bool();
                                        phi_1145_ = _e890;
                                        phi_1146_ = _e892;
                                        phi_1147_ = _e894;
                                        phi_1148_ = false;
                                    }
                                    let _e896 = phi_1143_;
                                    let _e898 = phi_1144_;
                                    let _e900 = phi_1145_;
                                    let _e902 = phi_1146_;
                                    let _e904 = phi_1147_;
                                    let _e906 = phi_1148_;
                                    if _e900 {
                                        if ((_e860 & 2u) != 0u) {
                                            if (((_e860 & 4u) != 0u) != _e278) {
                                                phi_1163_ = false;
                                            } else {
                                                phi_1163_ = true;
                                            }
                                            let _e913 = phi_1163_;
                                            phi_1164_ = _e913;
                                        } else {
                                            phi_1164_ = true;
                                        }
                                        let _e915 = phi_1164_;
                                        if _e915 {
                                            phi_1171_ = (((_e860 & 1u) != 0u) != _e278);
                                        } else {
                                            phi_1171_ = true;
                                        }
                                        let _e920 = phi_1171_;
                                        phi_1172_ = _e920;
                                        phi_1173_ = false;
                                        phi_1174_ = false;
                                        phi_1175_ = false;
                                    } else {
                                        phi_1172_ = bool();
                                        phi_1173_ = _e902;
                                        phi_1174_ = _e904;
                                        phi_1175_ = _e906;
                                    }
                                    let _e922 = phi_1172_;
                                    let _e924 = phi_1173_;
                                    let _e926 = phi_1174_;
                                    let _e928 = phi_1175_;
                                    if _e924 {
                                        phi_1179_ = _e896;
                                        phi_1180_ = false;
                                        phi_1181_ = false;
                                    } else {
                                        phi_1179_ = _e922;
                                        phi_1180_ = _e926;
                                        phi_1181_ = _e928;
                                    }
                                    let _e930 = phi_1179_;
                                    let _e932 = phi_1180_;
                                    let _e934 = phi_1181_;
                                    if _e932 {
                                        phi_1185_ = false;
                                        phi_1186_ = true;
                                    } else {
                                        phi_1185_ = _e898;
                                        phi_1186_ = _e934;
                                    }
                                    let _e936 = phi_1185_;
                                    let _e938 = phi_1186_;
                                    if _e938 {
                                        phi_1190_ = _e936;
                                    } else {
                                        phi_1190_ = _e930;
                                    }
                                    let _e940 = phi_1190_;
                                    phi_1191_ = _e940;
                                }
                                let _e942 = phi_1191_;
                                if _e734.all_remove {
                                    if (((_e860 & 1u) != 0u) == _e278) {
                                        if ((_e860 & 2u) != 0u) {
                                            phi_1209_ = (((_e860 & 4u) != 0u) == _e278);
                                        } else {
                                            phi_1209_ = true;
                                        }
                                        let _e952 = phi_1209_;
                                        phi_1210_ = _e952;
                                    } else {
                                        phi_1210_ = false;
                                    }
                                    let _e954 = phi_1210_;
                                    phi_1211_ = _e954;
                                } else {
                                    phi_1211_ = false;
                                }
                                let _e956 = phi_1211_;
                                phi_944_ = (_e732 + 1u);
                                phi_947_ = lt_mask_Neighbourhood(_e942, _e956);
                            } else {
                                phi_944_ = u32();
                                phi_947_ = lt_mask_Neighbourhood();
                            }
                            let _e960 = phi_944_;
                            let _e962 = phi_947_;
                            continue;
                            continuing {
                                phi_943_ = _e960;
                                phi_946_ = _e962;
                                break if !(_e746);
                            }
                        }
                        let _e1308 = local_1;
                        phi_1214_ = _e1308;
                    }
                    let _e965 = phi_1214_;
                    phi_1215_ = _e965;
                } else {
                    phi_1215_ = _e717;
                }
                let _e967 = phi_1215_;
                phi_1216_ = _e967;
            } else {
                phi_1216_ = _e717;
            }
            let _e969 = phi_1216_;
            let _e972 = p.member.frame;
            let _e974 = p.member.refresh;
            if (_e974 == 0u) {
                phi_1249_ = false;
            } else {
                if (_e974 == 0u) {
                    return;
                }
                let _e983 = ((_e60.x + (_e60.y * (((_e974 * 5u) / 8u) | 1u))) + (_e972 % _e974));
                if (_e974 == 0u) {
                    phi_1248_ = (_e983 == 0u);
                } else {
                    if (_e974 == 0u) {
                        return;
                    }
                    phi_1248_ = ((_e983 % _e974) == 0u);
                }
                let _e990 = phi_1248_;
                phi_1249_ = _e990;
            }
            let _e992 = phi_1249_;
            if _e710 {
                if _e992 {
                    phi_1271_ = bool();
                } else {
                    phi_1271_ = ((0u & 2u) != 0u);
                }
                let _e998 = phi_1271_;
                phi_1272_ = _e998;
                phi_1273_ = _e992;
            } else {
                phi_1272_ = bool();
                phi_1273_ = true;
            }
            let _e1000 = phi_1272_;
            let _e1002 = phi_1273_;
            if _e1002 {
                phi_1277_ = false;
            } else {
                phi_1277_ = _e1000;
            }
            let _e1004 = phi_1277_;
            if _e1004 {
                phi_1328_ = 7u;
            } else {
                if (_e120 != 0.5f) {
                    if _e710 {
                        if _e992 {
                            phi_1325_ = 6u;
                        } else {
                            if _e282 {
                                phi_1300_ = true;
                            } else {
                                if _e969.any_expands {
                                    phi_1299_ = false;
                                } else {
                                    phi_1299_ = true;
                                }
                                let _e1006 = phi_1299_;
                                phi_1300_ = _e1006;
                            }
                            let _e1008 = phi_1300_;
                            if _e1008 {
                                if _e282 {
                                    if false {
                                        if _e969.all_remove {
                                            phi_1313_ = false;
                                        } else {
                                            phi_1313_ = true;
                                        }
                                        let _e1010 = phi_1313_;
                                        phi_1314_ = _e1010;
                                    } else {
                                        phi_1314_ = true;
                                    }
                                    let _e1012 = phi_1314_;
                                    phi_1315_ = _e1012;
                                } else {
                                    phi_1315_ = true;
                                }
                                let _e1014 = phi_1315_;
                                if _e1014 {
                                    if _e282 {
                                        phi_1322_ = 1u;
                                    } else {
                                        phi_1322_ = 0u;
                                    }
                                    let _e1016 = phi_1322_;
                                    phi_1323_ = _e1016;
                                } else {
                                    phi_1323_ = 5u;
                                }
                                let _e1018 = phi_1323_;
                                phi_1324_ = _e1018;
                            } else {
                                phi_1324_ = 4u;
                            }
                            let _e1020 = phi_1324_;
                            phi_1325_ = _e1020;
                        }
                        let _e1022 = phi_1325_;
                        phi_1326_ = _e1022;
                    } else {
                        phi_1326_ = 3u;
                    }
                    let _e1024 = phi_1326_;
                    phi_1327_ = _e1024;
                } else {
                    phi_1327_ = 2u;
                }
                let _e1026 = phi_1327_;
                phi_1328_ = _e1026;
            }
            let _e1028 = phi_1328_;
            if !((_e1028 == 0u)) {
                if !((_e1028 == 5u)) {
                    phi_1340_ = !(_e1004);
                    phi_1341_ = false;
                } else {
                    phi_1340_ = bool();
                    phi_1341_ = true;
                }
                let _e1035 = phi_1340_;
                let _e1037 = phi_1341_;
                phi_1342_ = _e1035;
                phi_1343_ = _e1037;
            } else {
                phi_1342_ = bool();
                phi_1343_ = true;
            }
            let _e1039 = phi_1342_;
            let _e1041 = phi_1343_;
            if _e1041 {
                phi_1347_ = false;
            } else {
                phi_1347_ = _e1039;
            }
            let _e1043 = phi_1347_;
            if _e1004 {
                phi_1353_ = ((0u & 4u) != 0u);
            } else {
                phi_1353_ = _e278;
            }
            let _e1047 = phi_1353_;
            if _e1043 {
                if _e278 {
                    phi_1361_ = (2u | 1u);
                } else {
                    phi_1361_ = 2u;
                }
                let _e1050 = phi_1361_;
                if false {
                    phi_1366_ = (_e1050 | 4u);
                } else {
                    phi_1366_ = _e1050;
                }
                let _e1053 = phi_1366_;
                phi_1386_ = _e1053;
            } else {
                if (_e1028 == 7u) {
                    if _e278 {
                        phi_1375_ = (2u | 1u);
                    } else {
                        phi_1375_ = 2u;
                    }
                    let _e1057 = phi_1375_;
                    if _e1047 {
                        phi_1380_ = (_e1057 | 4u);
                    } else {
                        phi_1380_ = _e1057;
                    }
                    let _e1060 = phi_1380_;
                    phi_1385_ = _e1060;
                } else {
                    if _e278 {
                        phi_1384_ = 1u;
                    } else {
                        phi_1384_ = 0u;
                    }
                    let _e1062 = phi_1384_;
                    phi_1385_ = _e1062;
                }
                let _e1064 = phi_1385_;
                phi_1386_ = _e1064;
            }
            let _e1066 = phi_1386_;
            if _e1047 {
                phi_1390_ = 0f;
            } else {
                phi_1390_ = 1f;
            }
            let _e1068 = phi_1390_;
            phi_1392_ = mask_Masked(_e1068, _e1066, _e1043);
        }
        let _e1071 = phi_1392_;
        visibility.member[_e81.shift] = _e1071.visibility;
        let _e1076 = p.member.light.number;
        let _e1077 = (_e1076 * 3u);
        let _e1079 = (_e1077 % 32u);
        let _e1081 = p.member.light.mask_words;
        let _e1083 = ((_e81.shift * _e1081) + (_e1077 / 32u));
        let _e1085 = bits.member[_e1083];
        bits.member[_e1083] = ((_e1085 & ~((7u << bitcast<u32>((_e1079 & 31u))))) | (_e1071.bits << bitcast<u32>((_e1079 & 31u))));
        if (_e1079 > 29u) {
            let _e1100 = bits.member[(_e1083 + 1u)];
            let _e1102 = (32u - _e1079);
            bits.member[(_e1083 + 1u)] = ((_e1100 & ~((7u >> bitcast<u32>((_e1102 & 31u))))) | (_e1071.bits >> bitcast<u32>((_e1102 & 31u))));
        }
        let _e1117 = samples.member[_e81.shift].normal[0u];
        let _e1119 = global[0u];
        if (_e1117 == _e1119) {
            let _e1122 = samples.member[_e81.shift].normal[1u];
            let _e1124 = global[1u];
            if (_e1122 == _e1124) {
                let _e1127 = samples.member[_e81.shift].normal[2u];
                let _e1129 = global[2u];
                phi_1464_ = (_e1127 == _e1129);
                phi_1465_ = false;
            } else {
                phi_1464_ = bool();
                phi_1465_ = true;
            }
            let _e1132 = phi_1464_;
            let _e1134 = phi_1465_;
            phi_1466_ = _e1132;
            phi_1467_ = _e1134;
        } else {
            phi_1466_ = bool();
            phi_1467_ = true;
        }
        let _e1136 = phi_1466_;
        let _e1138 = phi_1467_;
        if _e1138 {
            phi_1471_ = false;
        } else {
            phi_1471_ = _e1136;
        }
        let _e1140 = phi_1471_;
        if !(_e1140) {
            let _e1143 = samples.member[_e81.shift].position;
            let _e1145 = p.member.current.eye;
            let _e1156 = p.member.current.forward;
            phi_1499_ = ((((_e1143.x - _e1145.x) * _e1156.x) + ((_e1143.y - _e1145.y) * _e1156.y)) + ((_e1143.z - _e1145.z) * _e1156.z));
        } else {
            phi_1499_ = 0f;
        }
        let _e1166 = phi_1499_;
        depths.member[_e81.shift] = _e1166;
        phi_1502_ = _e1071.needs_ray;
        phi_1503_ = _e81.shift;
    } else {
        phi_1502_ = false;
        phi_1503_ = 0u;
    }
    let _e1170 = phi_1502_;
    let _e1172 = phi_1503_;
    if (_e61 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1170 {
        let _e1176 = atomicAdd((&shared_[0u]), 1u);
        phi_1514_ = _e1176;
    } else {
        phi_1514_ = 0u;
    }
    let _e1178 = phi_1514_;
    workgroupBarrier();
    if (_e61 == 0u) {
        let _e1182 = atomicLoad((&shared_[0u]));
        let _e1183 = atomicAdd((&list.member[3u]), _e1182);
        atomicStore((&shared_[1u]), _e1183);
    }
    workgroupBarrier();
    if _e1170 {
        let _e1186 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1186) + _e1178)]), _e1172);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_depth_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
