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
    pad0_: u32,
    pad1_: u32,
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
    var phi_1138_: bool;
    var phi_1139_: bool;
    var phi_1146_: bool;
    var phi_1147_: bool;
    var phi_1165_: bool;
    var phi_1166_: bool;
    var phi_1167_: bool;
    var phi_962_: u32;
    var phi_965_: lt_mask_Neighbourhood;
    var phi_1170_: lt_mask_Neighbourhood;
    var phi_1171_: lt_mask_Neighbourhood;
    var phi_1172_: lt_mask_Neighbourhood;
    var phi_1204_: bool;
    var phi_1205_: bool;
    var phi_1234_: bool;
    var phi_1235_: bool;
    var phi_1248_: bool;
    var phi_1249_: bool;
    var phi_1250_: bool;
    var phi_1257_: u32;
    var phi_1258_: u32;
    var phi_1259_: u32;
    var phi_1260_: u32;
    var phi_1261_: u32;
    var phi_1262_: u32;
    var phi_1270_: bool;
    var phi_1278_: u32;
    var phi_1283_: u32;
    var phi_1287_: u32;
    var phi_1288_: u32;
    var phi_1292_: f32;
    var phi_1294_: mask_Masked;
    var phi_1366_: bool;
    var phi_1367_: bool;
    var phi_1368_: bool;
    var phi_1369_: bool;
    var phi_1373_: bool;
    var phi_1401_: f32;
    var phi_1404_: bool;
    var phi_1405_: u32;
    var phi_1416_: u32;
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
            phi_1294_ = mask_Masked(_e273.unnamed.visibility, 0u, false);
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
            if _e734.has_moved {
            }
            let _e740 = lt_mask_Neighbourhood(false, true);
            if _e282 {
                phi_1172_ = _e740;
            } else {
                if true {
                    if _e728 {
                        if _e734.has_moved {
                            let _e743 = p.member.moving_pattern;
                            phi_959_ = _e743;
                        } else {
                            let _e745 = p.member.still_pattern;
                            phi_959_ = _e745;
                        }
                        let _e747 = phi_959_;
                        phi_961_ = 0u;
                        phi_964_ = _e740;
                        loop {
                            let _e749 = phi_961_;
                            let _e751 = phi_964_;
                            local_1 = _e751;
                            if (1u <= _e747) {
                                if (_e747 <= 4u) {
                                    phi_976_ = false;
                                } else {
                                    phi_976_ = true;
                                }
                                let _e755 = phi_976_;
                                phi_977_ = _e755;
                            } else {
                                phi_977_ = true;
                            }
                            let _e757 = phi_977_;
                            if _e757 {
                                switch bitcast<i32>(_e747) {
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
                                let _e760 = phi_986_;
                                phi_987_ = _e760;
                            } else {
                                phi_987_ = 5u;
                            }
                            let _e762 = phi_987_;
                            let _e763 = (_e749 < _e762);
                            if _e763 {
                                let _e769 = p.member.frame;
                                let _e773 = p.member.current.size[0u];
                                let _e775 = p.member.current.size[1u];
                                switch bitcast<i32>(_e747) {
                                    case 1: {
                                        let _e785 = lt_mask_pattern_plus(_e749);
                                        phi_1067_ = vec2<i32>(_e785.x, _e785.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e789 = lt_mask_pattern_cross(_e749);
                                        phi_1067_ = vec2<i32>(_e789.x, _e789.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e795 = lt_mask_pattern_plus_or_cross(_e749, ((_e734.pixel.x + _e734.pixel.y) & 1u));
                                        phi_1067_ = vec2<i32>(_e795.x, _e795.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e800 = lt_mask_pattern_plus_or_cross(_e749, (_e769 & 1u));
                                        phi_1067_ = vec2<i32>(_e800.x, _e800.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e769 & 3u)) {
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
                                        let _e811 = phi_1047_;
                                        phi_1067_ = (_e811 + vec2<i32>(bitcast<i32>((_e749 & 1u)), bitcast<i32>(((_e749 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_1067_ = vec2<i32>((bitcast<i32>((_e749 % 5u)) - 2i), (bitcast<i32>(((_e749 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e828 = lt_mask_pattern_diamond(_e749);
                                        phi_1067_ = vec2<i32>(_e828.x, _e828.y);
                                        break;
                                    }
                                    default: {
                                        phi_1067_ = vec2<i32>((bitcast<i32>((_e749 % 3u)) - 1i), (bitcast<i32>(((_e749 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e833 = phi_1067_;
                                let _e836 = lt_mask_pattern_step_clamped(_e734.pixel.x, _e833.x, _e773);
                                let _e837 = lt_mask_pattern_step_clamped(_e734.pixel.y, _e833.y, _e775);
                                let _e844 = ((((_e837 * _e112) + _e836) * _e108.words) + _e108.light.word);
                                if (_e108.light.shift > 29u) {
                                    let _e848 = (_e844 + 1u);
                                    if (_e848 < _e66) {
                                    } else {
                                        return;
                                    }
                                    let _e852 = last_bits.member[(0u + _e848)];
                                    phi_1094_ = _e852;
                                } else {
                                    phi_1094_ = 0u;
                                }
                                let _e854 = phi_1094_;
                                if (_e844 < _e66) {
                                } else {
                                    return;
                                }
                                let _e860 = last_bits.member[(0u + _e844)];
                                let _e863 = (_e860 >> bitcast<u32>((_e108.light.shift & 31u)));
                                if (_e108.light.shift > 29u) {
                                    phi_1113_ = (_e863 | (_e854 << bitcast<u32>(((32u - _e108.light.shift) & 31u))));
                                } else {
                                    phi_1113_ = _e863;
                                }
                                let _e871 = phi_1113_;
                                if ((_e871 & 2u) == 0u) {
                                    phi_1121_ = (_e871 & 1u);
                                } else {
                                    phi_1121_ = (_e871 & 7u);
                                }
                                let _e877 = phi_1121_;
                                if _e751.any_expands {
                                    phi_1147_ = true;
                                } else {
                                    if ((_e877 & 2u) != 0u) {
                                        if (((_e877 & 4u) != 0u) != _e278) {
                                            phi_1138_ = false;
                                        } else {
                                            phi_1138_ = true;
                                        }
                                        let _e886 = phi_1138_;
                                        phi_1139_ = _e886;
                                    } else {
                                        phi_1139_ = true;
                                    }
                                    let _e888 = phi_1139_;
                                    if _e888 {
                                        phi_1146_ = (((_e877 & 1u) != 0u) != _e278);
                                    } else {
                                        phi_1146_ = true;
                                    }
                                    let _e893 = phi_1146_;
                                    phi_1147_ = _e893;
                                }
                                let _e895 = phi_1147_;
                                if _e751.all_remove {
                                    if (((_e877 & 1u) != 0u) == _e278) {
                                        if ((_e877 & 2u) != 0u) {
                                            phi_1165_ = (((_e877 & 4u) != 0u) == _e278);
                                        } else {
                                            phi_1165_ = true;
                                        }
                                        let _e905 = phi_1165_;
                                        phi_1166_ = _e905;
                                    } else {
                                        phi_1166_ = false;
                                    }
                                    let _e907 = phi_1166_;
                                    phi_1167_ = _e907;
                                } else {
                                    phi_1167_ = false;
                                }
                                let _e909 = phi_1167_;
                                phi_962_ = (_e749 + 1u);
                                phi_965_ = lt_mask_Neighbourhood(_e895, _e909);
                            } else {
                                phi_962_ = u32();
                                phi_965_ = lt_mask_Neighbourhood();
                            }
                            let _e913 = phi_962_;
                            let _e915 = phi_965_;
                            continue;
                            continuing {
                                phi_961_ = _e913;
                                phi_964_ = _e915;
                                break if !(_e763);
                            }
                        }
                        let _e1200 = local_1;
                        phi_1170_ = _e1200;
                    } else {
                        phi_1170_ = _e740;
                    }
                    let _e918 = phi_1170_;
                    phi_1171_ = _e918;
                } else {
                    phi_1171_ = _e740;
                }
                let _e920 = phi_1171_;
                phi_1172_ = _e920;
            }
            let _e922 = phi_1172_;
            let _e925 = p.member.frame;
            let _e927 = p.member.refresh;
            if (_e927 == 0u) {
                phi_1205_ = false;
            } else {
                if (_e927 == 0u) {
                    return;
                }
                let _e936 = ((_e60.x + (_e60.y * (((_e927 * 5u) / 8u) | 1u))) + (_e925 % _e927));
                if (_e927 == 0u) {
                    phi_1204_ = (_e936 == 0u);
                } else {
                    if (_e927 == 0u) {
                        return;
                    }
                    phi_1204_ = ((_e936 % _e927) == 0u);
                }
                let _e943 = phi_1204_;
                phi_1205_ = _e943;
            }
            let _e945 = phi_1205_;
            if (_e120 != 0.5f) {
                if _e728 {
                    if _e945 {
                        phi_1260_ = 6u;
                    } else {
                        if _e282 {
                            phi_1235_ = true;
                        } else {
                            if _e922.any_expands {
                                phi_1234_ = false;
                            } else {
                                phi_1234_ = true;
                            }
                            let _e949 = phi_1234_;
                            phi_1235_ = _e949;
                        }
                        let _e951 = phi_1235_;
                        if _e951 {
                            if _e282 {
                                if false {
                                    if _e922.all_remove {
                                        phi_1248_ = false;
                                    } else {
                                        phi_1248_ = true;
                                    }
                                    let _e953 = phi_1248_;
                                    phi_1249_ = _e953;
                                } else {
                                    phi_1249_ = true;
                                }
                                let _e955 = phi_1249_;
                                phi_1250_ = _e955;
                            } else {
                                phi_1250_ = true;
                            }
                            let _e957 = phi_1250_;
                            if _e957 {
                                if _e282 {
                                    phi_1257_ = 1u;
                                } else {
                                    phi_1257_ = 0u;
                                }
                                let _e959 = phi_1257_;
                                phi_1258_ = _e959;
                            } else {
                                phi_1258_ = 5u;
                            }
                            let _e961 = phi_1258_;
                            phi_1259_ = _e961;
                        } else {
                            phi_1259_ = 4u;
                        }
                        let _e963 = phi_1259_;
                        phi_1260_ = _e963;
                    }
                    let _e965 = phi_1260_;
                    phi_1261_ = _e965;
                } else {
                    phi_1261_ = 3u;
                }
                let _e967 = phi_1261_;
                phi_1262_ = _e967;
            } else {
                phi_1262_ = 2u;
            }
            let _e969 = phi_1262_;
            if !((_e969 == 0u)) {
                phi_1270_ = !((_e969 == 5u));
            } else {
                phi_1270_ = false;
            }
            let _e975 = phi_1270_;
            if _e975 {
                if _e278 {
                    phi_1278_ = (2u | 1u);
                } else {
                    phi_1278_ = 2u;
                }
                let _e978 = phi_1278_;
                if false {
                    phi_1283_ = (_e978 | 4u);
                } else {
                    phi_1283_ = _e978;
                }
                let _e981 = phi_1283_;
                phi_1288_ = _e981;
            } else {
                if _e278 {
                    phi_1287_ = 1u;
                } else {
                    phi_1287_ = 0u;
                }
                let _e983 = phi_1287_;
                phi_1288_ = _e983;
            }
            let _e985 = phi_1288_;
            if _e278 {
                phi_1292_ = 0f;
            } else {
                phi_1292_ = 1f;
            }
            let _e987 = phi_1292_;
            phi_1294_ = mask_Masked(_e987, _e985, _e975);
        }
        let _e990 = phi_1294_;
        visibility.member[_e81.shift] = _e990.visibility;
        let _e995 = p.member.light.number;
        let _e996 = (_e995 * 3u);
        let _e998 = (_e996 % 32u);
        let _e1000 = p.member.light.mask_words;
        let _e1002 = ((_e81.shift * _e1000) + (_e996 / 32u));
        let _e1004 = bits.member[_e1002];
        bits.member[_e1002] = ((_e1004 & ~((7u << bitcast<u32>((_e998 & 31u))))) | (_e990.bits << bitcast<u32>((_e998 & 31u))));
        if (_e998 > 29u) {
            let _e1019 = bits.member[(_e1002 + 1u)];
            let _e1021 = (32u - _e998);
            bits.member[(_e1002 + 1u)] = ((_e1019 & ~((7u >> bitcast<u32>((_e1021 & 31u))))) | (_e990.bits >> bitcast<u32>((_e1021 & 31u))));
        }
        let _e1036 = samples.member[_e81.shift].normal[0u];
        let _e1038 = global[0u];
        if (_e1036 == _e1038) {
            let _e1041 = samples.member[_e81.shift].normal[1u];
            let _e1043 = global[1u];
            if (_e1041 == _e1043) {
                let _e1046 = samples.member[_e81.shift].normal[2u];
                let _e1048 = global[2u];
                phi_1366_ = (_e1046 == _e1048);
                phi_1367_ = false;
            } else {
                phi_1366_ = bool();
                phi_1367_ = true;
            }
            let _e1051 = phi_1366_;
            let _e1053 = phi_1367_;
            phi_1368_ = _e1051;
            phi_1369_ = _e1053;
        } else {
            phi_1368_ = bool();
            phi_1369_ = true;
        }
        let _e1055 = phi_1368_;
        let _e1057 = phi_1369_;
        if _e1057 {
            phi_1373_ = false;
        } else {
            phi_1373_ = _e1055;
        }
        let _e1059 = phi_1373_;
        if !(_e1059) {
            let _e1062 = samples.member[_e81.shift].position;
            let _e1064 = p.member.current.eye;
            let _e1075 = p.member.current.forward;
            phi_1401_ = ((((_e1062.x - _e1064.x) * _e1075.x) + ((_e1062.y - _e1064.y) * _e1075.y)) + ((_e1062.z - _e1064.z) * _e1075.z));
        } else {
            phi_1401_ = 0f;
        }
        let _e1085 = phi_1401_;
        depths.member[_e81.shift] = _e1085;
        phi_1404_ = _e990.needs_ray;
        phi_1405_ = _e81.shift;
    } else {
        phi_1404_ = false;
        phi_1405_ = 0u;
    }
    let _e1089 = phi_1404_;
    let _e1091 = phi_1405_;
    if (_e61 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1089 {
        let _e1095 = atomicAdd((&shared_[0u]), 1u);
        phi_1416_ = _e1095;
    } else {
        phi_1416_ = 0u;
    }
    let _e1097 = phi_1416_;
    workgroupBarrier();
    if (_e61 == 0u) {
        let _e1101 = atomicLoad((&shared_[0u]));
        let _e1102 = atomicAdd((&list.member[3u]), _e1101);
        atomicStore((&shared_[1u]), _e1102);
    }
    workgroupBarrier();
    if _e1089 {
        let _e1105 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1105) + _e1097)]), _e1091);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_depth_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
