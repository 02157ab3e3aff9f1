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
@group(0) @binding(6) 
var<storage> last_depths: type_21;
@group(0) @binding(7) 
var<storage, read_write> depths: type_21;

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
        let _e72 = phi_177_;
        let _e74 = phi_178_;
        phi_179_ = _e72;
        phi_180_ = _e74;
    } else {
        phi_179_ = lt_mask_LightPlace();
        phi_180_ = true;
    }
    let _e76 = phi_179_;
    let _e78 = phi_180_;
    if _e78 {
        phi_185_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_185_ = _e76;
    }
    let _e83 = phi_185_;
    return lt_mask_LightPlace(_e83.word, _e83.shift);
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
    let _e68 = phi_203_;
    return vec2<i32>(_e68.x, _e68.y);
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
    let _e68 = phi_221_;
    return vec2<i32>(_e68.x, _e68.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_240_: vec2<i32>;

    if (param_6 == 0u) {
        let _e62 = lt_mask_pattern_plus(param_5);
        phi_240_ = vec2<i32>(_e62.x, _e62.y);
    } else {
        let _e66 = lt_mask_pattern_cross(param_5);
        phi_240_ = vec2<i32>(_e66.x, _e66.y);
    }
    let _e71 = phi_240_;
    return vec2<i32>(_e71.x, _e71.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_265_: vec2<i32>;

    let _e60 = (param_7 % 13u);
    switch bitcast<i32>(_e60) {
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
            phi_265_ = vec2<i32>((bitcast<i32>((_e60 % 3u)) - 1i), (bitcast<i32>(((_e60 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e75 = phi_265_;
    return vec2<i32>(_e75.x, _e75.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_286_: u32;
    var phi_287_: u32;

    let _e63 = (bitcast<i32>(param_8) + param_9);
    if (_e63 < 0i) {
        phi_287_ = 0u;
    } else {
        if (_e63 >= bitcast<i32>(param_10)) {
            phi_286_ = (param_10 - 1u);
        } else {
            phi_286_ = bitcast<u32>(_e63);
        }
        let _e70 = phi_286_;
        phi_287_ = _e70;
    }
    let _e72 = phi_287_;
    return _e72;
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
    var phi_688_: f32;
    var phi_693_: f32;
    var phi_694_: bool;
    var phi_695_: f32;
    var phi_696_: bool;
    var phi_700_: f32;
    var phi_721_: f32;
    var phi_726_: f32;
    var phi_727_: bool;
    var phi_728_: f32;
    var phi_729_: bool;
    var phi_733_: f32;
    var phi_754_: bool;
    var phi_773_: vec2<u32>;
    var phi_774_: bool;
    var phi_775_: bool;
    var phi_776_: bool;
    var phi_777_: vec2<u32>;
    var phi_778_: bool;
    var phi_779_: bool;
    var phi_780_: bool;
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
    var phi_804_: bool;
    var phi_805_: bool;
    var phi_806_: bool;
    var phi_807_: bool;
    var phi_811_: bool;
    var phi_812_: bool;
    var phi_813_: vec2<u32>;
    var phi_902_: bool;
    var phi_906_: f32;
    var phi_910_: lt_mask_Reprojection;
    var phi_919_: bool;
    var phi_920_: bool;
    var phi_922_: bool;
    var phi_923_: lt_mask_Reprojection;
    var phi_924_: lt_mask_Reprojection;
    var phi_925_: bool;
    var phi_929_: bool;
    var phi_930_: lt_mask_Reprojection;
    var phi_936_: bool;
    var phi_958_: u32;
    var phi_960_: u32;
    var phi_963_: lt_mask_Neighbourhood;
    var phi_975_: bool;
    var phi_976_: bool;
    var phi_985_: u32;
    var phi_986_: u32;
    var phi_1046_: vec2<i32>;
    var phi_1066_: vec2<i32>;
    var phi_1093_: u32;
    var phi_1112_: u32;
    var phi_1120_: u32;
    var phi_1146_: bool;
    var phi_1147_: bool;
    var phi_1148_: bool;
    var phi_1149_: bool;
    var phi_1150_: bool;
    var phi_1151_: bool;
    var phi_1152_: bool;
    var phi_1157_: bool;
    var phi_1158_: bool;
    var phi_1159_: bool;
    var phi_1160_: bool;
    var phi_1161_: bool;
    var phi_1162_: bool;
    var phi_1163_: bool;
    var phi_1164_: bool;
    var phi_1165_: bool;
    var phi_1180_: bool;
    var phi_1181_: bool;
    var phi_1188_: bool;
    var phi_1189_: bool;
    var phi_1190_: bool;
    var phi_1191_: bool;
    var phi_1192_: bool;
    var phi_1196_: bool;
    var phi_1197_: bool;
    var phi_1198_: bool;
    var phi_1202_: bool;
    var phi_1203_: bool;
    var phi_1207_: bool;
    var phi_1208_: bool;
    var phi_1226_: bool;
    var phi_1227_: bool;
    var phi_1228_: bool;
    var phi_961_: u32;
    var phi_964_: lt_mask_Neighbourhood;
    var phi_1231_: lt_mask_Neighbourhood;
    var phi_1232_: lt_mask_Neighbourhood;
    var phi_1233_: lt_mask_Neighbourhood;
    var phi_1265_: bool;
    var phi_1266_: bool;
    var phi_1288_: bool;
    var phi_1289_: bool;
    var phi_1290_: bool;
    var phi_1294_: bool;
    var phi_1316_: bool;
    var phi_1317_: bool;
    var phi_1330_: bool;
    var phi_1331_: bool;
    var phi_1332_: bool;
    var phi_1339_: u32;
    var phi_1340_: u32;
    var phi_1341_: u32;
    var phi_1342_: u32;
    var phi_1343_: u32;
    var phi_1344_: u32;
    var phi_1345_: u32;
    var phi_1357_: bool;
    var phi_1358_: bool;
    var phi_1359_: bool;
    var phi_1360_: bool;
    var phi_1364_: bool;
    var phi_1370_: bool;
    var phi_1378_: u32;
    var phi_1383_: u32;
    var phi_1392_: u32;
    var phi_1397_: u32;
    var phi_1401_: u32;
    var phi_1402_: u32;
    var phi_1403_: u32;
    var phi_1407_: f32;
    var phi_1409_: mask_Masked;
    var phi_1481_: bool;
    var phi_1482_: bool;
    var phi_1483_: bool;
    var phi_1484_: bool;
    var phi_1488_: bool;
    var phi_1516_: f32;
    var phi_1519_: bool;
    var phi_1520_: u32;
    var phi_1531_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e59 = id_1;
    let _e60 = local_2;
    let _e65 = arrayLength((&last_bits.member));
    let _e76 = p.member.current.size[0u];
    let _e78 = p.member.current.size[1u];
    let _e79 = lt_shaders_entry_pixel_index(_e59, _e76, _e78);
    if (bitcast<i32>(_e79.word) != 0i) {
        let _e86 = p.member.light.number;
        let _e87 = (_e86 * 3u);
        let _e91 = p.member.light.mask_words;
        let _e97 = mask_BitsPlace(lt_mask_LightPlace((_e87 / 32u), mask_BitsPlace().light.shift), mask_BitsPlace().words);
        let _e103 = mask_BitsPlace(lt_mask_LightPlace(_e97.light.word, (_e87 % 32u)), _e97.words);
        let _e106 = mask_BitsPlace(_e103.light, _e91);
        let _e110 = p.member.current.size[0u];
        let _e113 = samples.member[_e79.shift].position;
        let _e115 = visibility.member[_e79.shift];
        let _e121 = samples.member[_e79.shift].normal[0u];
        let _e123 = global[0u];
        if (_e121 == _e123) {
            let _e126 = samples.member[_e79.shift].normal[1u];
            let _e128 = global[1u];
            if (_e126 == _e128) {
                let _e131 = samples.member[_e79.shift].normal[2u];
                let _e133 = global[2u];
                phi_364_ = (_e131 == _e133);
                phi_365_ = false;
            } else {
                phi_364_ = bool();
                phi_365_ = true;
            }
            let _e136 = phi_364_;
            let _e138 = phi_365_;
            phi_366_ = _e136;
            phi_367_ = _e138;
        } else {
            phi_366_ = bool();
            phi_367_ = true;
        }
        let _e140 = phi_366_;
        let _e142 = phi_367_;
        if _e142 {
            phi_371_ = false;
        } else {
            phi_371_ = _e140;
        }
        let _e144 = phi_371_;
        if !(_e144) {
            let _e147 = samples.member[_e79.shift].position;
            let _e149 = p.member.light.place;
            let _e155 = p.member.light.place[3u];
            let _e162 = (_e149.x - (_e147.x * _e155));
            let _e163 = (_e149.y - (_e147.y * _e155));
            let _e164 = (_e149.z - (_e147.z * _e155));
            let _e166 = samples.member[_e79.shift].normal;
            if ((((_e166.x * _e162) + (_e166.y * _e163)) + (_e166.z * _e164)) > 0f) {
                let _e180 = (((_e162 * _e162) + (_e163 * _e163)) + (_e164 * _e164));
                let _e182 = p.member.light.axis;
                let _e194 = p.member.light.place[3u];
                if (_e194 == 0f) {
                    phi_442_ = true;
                } else {
                    let _e197 = p.member.light.range_squared;
                    if (_e180 <= _e197) {
                        let _e200 = p.member.light.cos_outer;
                        phi_441_ = (-((((_e162 * _e182.x) + (_e163 * _e182.y)) + (_e164 * _e182.z))) >= (_e200 * sqrt(_e180)));
                    } else {
                        phi_441_ = false;
                    }
                    let _e205 = phi_441_;
                    phi_442_ = _e205;
                }
                let _e207 = phi_442_;
                if _e207 {
                    let _e209 = samples.member[_e79.shift].flags;
                    let _e217 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e223 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e217.unnamed.visibility, false), _e217.unnamed_1);
                    phi_453_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e223.unnamed, ((_e209 & 1u) == 0u));
                    phi_454_ = false;
                } else {
                    phi_453_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_454_ = true;
                }
                let _e228 = phi_453_;
                let _e230 = phi_454_;
                phi_455_ = _e228;
                phi_456_ = _e230;
            } else {
                phi_455_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_456_ = true;
            }
            let _e232 = phi_455_;
            let _e234 = phi_456_;
            if _e234 {
                let _e240 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e246 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e240.unnamed.visibility, false), _e240.unnamed_1);
                phi_463_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e246.unnamed, true);
            } else {
                phi_463_ = _e232;
            }
            let _e251 = phi_463_;
            phi_467_ = _e251;
        } else {
            let _e257 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e263 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e257.unnamed.visibility, false), _e257.unnamed_1);
            phi_467_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e263.unnamed, true);
        }
        let _e268 = phi_467_;
        if _e268.unnamed_1 {
            phi_1409_ = mask_Masked(_e268.unnamed.visibility, 0u, false);
        } else {
            let _e273 = (_e115 < 0.5f);
            if (_e115 > 0f) {
                phi_480_ = (_e115 < 1f);
            } else {
                phi_480_ = false;
            }
            let _e277 = phi_480_;
            let _e279 = samples.member[_e79.shift].position;
            let _e283 = p.member.previous.eye;
            let _e286 = (_e113.x - _e283.x);
            let _e289 = (_e113.y - _e283.y);
            let _e292 = (_e113.z - _e283.z);
            let _e294 = p.member.previous.forward;
            let _e302 = (((_e286 * _e294.x) + (_e289 * _e294.y)) + (_e292 * _e294.z));
            let _e304 = p.member.previous.right;
            let _e314 = p.member.previous.right;
            let _e329 = p.member.previous.up;
            let _e339 = p.member.previous.up;
            let _e354 = p.member.current.eye;
            let _e357 = (_e279.x - _e354.x);
            let _e360 = (_e279.y - _e354.y);
            let _e363 = (_e279.z - _e354.z);
            let _e365 = p.member.current.forward;
            let _e373 = (((_e357 * _e365.x) + (_e360 * _e365.y)) + (_e363 * _e365.z));
            let _e375 = p.member.current.right;
            let _e385 = p.member.current.right;
            let _e400 = p.member.current.up;
            let _e410 = p.member.current.up;
            let _e429 = p.member.current.size[0u];
            let _e431 = (((((((_e286 * _e304.x) + (_e289 * _e304.y)) + (_e292 * _e304.z)) / ((((_e314.x * _e314.x) + (_e314.y * _e314.y)) + (_e314.z * _e314.z)) * _e302)) - ((((_e357 * _e375.x) + (_e360 * _e375.y)) + (_e363 * _e375.z)) / ((((_e385.x * _e385.x) + (_e385.y * _e385.y)) + (_e385.z * _e385.z)) * _e373))) * 0.5f) * f32(_e429));
            let _e435 = p.member.current.size[1u];
            let _e437 = (((((((_e286 * _e329.x) + (_e289 * _e329.y)) + (_e292 * _e329.z)) / ((((_e339.x * _e339.x) + (_e339.y * _e339.y)) + (_e339.z * _e339.z)) * _e302)) - ((((_e357 * _e400.x) + (_e360 * _e400.y)) + (_e363 * _e400.z)) / ((((_e410.x * _e410.x) + (_e410.y * _e410.y)) + (_e410.z * _e410.z)) * _e373))) * -0.5f) * f32(_e435));
            let _e441 = p.member.current.grid[0u];
            let _e443 = p.member.current.grid[1u];
            let _e463 = p.member.current.size[0u];
            let _e465 = p.member.current.size[1u];
            let _e467 = ((f32(_e59.x) + ((f32((_e59.y & (_e443 - 1u))) + 0.5f) / f32(_e443))) + _e431);
            if (_e467 > -8388608f) {
                let _e479 = f32(select(0i, select(select(i32(_e467), i32(-2147483648), (_e467 < bitcast<f32>(3472883712u))), 2147483647i, (_e467 > bitcast<f32>(1325400063u))), (_e467 == _e467)));
                if (_e479 > _e467) {
                    phi_688_ = 1f;
                } else {
                    phi_688_ = 0f;
                }
                let _e482 = phi_688_;
                if (_e467 < 8388608f) {
                    phi_693_ = (_e479 - _e482);
                    phi_694_ = false;
                } else {
                    phi_693_ = f32();
                    phi_694_ = true;
                }
                let _e485 = phi_693_;
                let _e487 = phi_694_;
                phi_695_ = _e485;
                phi_696_ = _e487;
            } else {
                phi_695_ = f32();
                phi_696_ = true;
            }
            let _e489 = phi_695_;
            let _e491 = phi_696_;
            if _e491 {
                phi_700_ = _e467;
            } else {
                phi_700_ = _e489;
            }
            let _e493 = phi_700_;
            let _e494 = ((f32(_e59.y) + ((f32((_e59.x & (_e441 - 1u))) + 0.5f) / f32(_e441))) + _e437);
            if (_e494 > -8388608f) {
                let _e506 = f32(select(0i, select(select(i32(_e494), i32(-2147483648), (_e494 < bitcast<f32>(3472883712u))), 2147483647i, (_e494 > bitcast<f32>(1325400063u))), (_e494 == _e494)));
                if (_e506 > _e494) {
                    phi_721_ = 1f;
                } else {
                    phi_721_ = 0f;
                }
                let _e509 = phi_721_;
                if (_e494 < 8388608f) {
                    phi_726_ = (_e506 - _e509);
                    phi_727_ = false;
                } else {
                    phi_726_ = f32();
                    phi_727_ = true;
                }
                let _e512 = phi_726_;
                let _e514 = phi_727_;
                phi_728_ = _e512;
                phi_729_ = _e514;
            } else {
                phi_728_ = f32();
                phi_729_ = true;
            }
            let _e516 = phi_728_;
            let _e518 = phi_729_;
            if _e518 {
                phi_733_ = _e494;
            } else {
                phi_733_ = _e516;
            }
            let _e520 = phi_733_;
            if (_e493 >= 0f) {
                if (_e520 >= 0f) {
                    if (_e493 < f32(_e463)) {
                        let _e526 = (_e520 < f32(_e465));
                        if (_e431 == 0f) {
                            phi_754_ = (_e437 == 0f);
                        } else {
                            phi_754_ = false;
                        }
                        let _e530 = phi_754_;
                        if _e526 {
                            phi_773_ = vec2<u32>(select(select(u32(_e493), 0u, (_e493 < bitcast<f32>(0u))), 4294967295u, (_e493 > bitcast<f32>(1333788671u))), select(select(u32(_e520), 0u, (_e520 < bitcast<f32>(0u))), 4294967295u, (_e520 > bitcast<f32>(1333788671u))));
                            phi_774_ = false;
                        } else {
                            phi_773_ = vec2<u32>();
                            phi_774_ = true;
                        }
                        let _e547 = phi_773_;
                        let _e549 = phi_774_;
                        phi_775_ = _e530;
                        phi_776_ = _e526;
                        phi_777_ = _e547;
                        phi_778_ = _e530;
                        phi_779_ = _e526;
                        phi_780_ = false;
                        phi_781_ = _e549;
                    } else {
                        phi_775_ = bool();
                        phi_776_ = bool();
                        phi_777_ = vec2<u32>();
                        phi_778_ = bool();
                        phi_779_ = bool();
                        phi_780_ = true;
                        phi_781_ = false;
                    }
                    let _e551 = phi_775_;
                    let _e553 = phi_776_;
                    let _e555 = phi_777_;
                    let _e557 = phi_778_;
                    let _e559 = phi_779_;
                    let _e561 = phi_780_;
                    let _e563 = phi_781_;
                    phi_782_ = _e551;
                    phi_783_ = _e553;
                    phi_784_ = _e555;
                    phi_785_ = _e557;
                    phi_786_ = _e559;
                    phi_787_ = _e561;
                    phi_788_ = _e563;
                } else {
                    phi_782_ = bool();
                    phi_783_ = bool();
                    phi_784_ = vec2<u32>();
                    phi_785_ = bool();
                    phi_786_ = bool();
                    phi_787_ = true;
                    phi_788_ = false;
                }
                let _e565 = phi_782_;
                let _e567 = phi_783_;
                let _e569 = phi_784_;
                let _e571 = phi_785_;
                let _e573 = phi_786_;
                let _e575 = phi_787_;
                let _e577 = phi_788_;
                phi_789_ = _e565;
                phi_790_ = _e567;
                phi_791_ = _e569;
                phi_792_ = _e571;
                phi_793_ = _e573;
                phi_794_ = _e575;
                phi_795_ = _e577;
            } else {
                phi_789_ = bool();
                phi_790_ = bool();
                phi_791_ = vec2<u32>();
                phi_792_ = bool();
                phi_793_ = bool();
                phi_794_ = true;
                phi_795_ = false;
            }
            let _e579 = phi_789_;
            let _e581 = phi_790_;
            let _e583 = phi_791_;
            let _e585 = phi_792_;
            let _e587 = phi_793_;
            let _e589 = phi_794_;
            let _e591 = phi_795_;
            if _e589 {
                if (_e431 == 0f) {
                    phi_804_ = (_e437 == 0f);
                } else {
                    phi_804_ = false;
                }
                let _e595 = phi_804_;
                phi_805_ = _e595;
                phi_806_ = false;
                phi_807_ = true;
            } else {
                phi_805_ = _e585;
                phi_806_ = _e587;
                phi_807_ = _e591;
            }
            let _e597 = phi_805_;
            let _e599 = phi_806_;
            let _e601 = phi_807_;
            if _e601 {
                phi_811_ = _e597;
                phi_812_ = _e599;
                phi_813_ = vec2<u32>(_e59.x, _e59.y);
            } else {
                phi_811_ = _e579;
                phi_812_ = _e581;
                phi_813_ = _e583;
            }
            let _e603 = phi_811_;
            let _e605 = phi_812_;
            let _e607 = phi_813_;
            let _e617 = lt_mask_Reprojection(vec2<u32>(_e607.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e624 = lt_mask_Reprojection(vec2<u32>(_e617.pixel.x, _e607.y), _e617.is_valid, _e617.has_moved);
            let _e628 = lt_mask_Reprojection(_e624.pixel, _e605, _e624.has_moved);
            let _e632 = lt_mask_Reprojection(_e628.pixel, _e628.is_valid, !(_e603));
            if _e605 {
                let _e635 = p.member.previous.eye;
                let _e646 = p.member.previous.forward;
                let _e655 = (((((_e113.x - _e635.x) * _e646.x) + ((_e113.y - _e635.y) * _e646.y)) + ((_e113.z - _e635.z) * _e646.z)) > 0f);
                let _e659 = lt_mask_Reprojection(_e632.pixel, _e655, _e632.has_moved);
                if _e655 {
                    let _e662 = p.member.previous.eye;
                    let _e673 = p.member.previous.forward;
                    let _e681 = ((((_e113.x - _e662.x) * _e673.x) + ((_e113.y - _e662.y) * _e673.y)) + ((_e113.z - _e662.z) * _e673.z));
                    let _e683 = ((_e607.y * _e110) + _e607.x);
                    if (_e683 < arrayLength((&last_depths.member))) {
                    } else {
                        return;
                    }
                    let _e687 = last_depths.member[(0u + _e683)];
                    let _e689 = p.member.depth_tolerance;
                    let _e692 = abs(_e681);
                    let _e693 = abs(_e687);
                    if ((bitcast<u32>(_e693) & 2147483647u) > 2139095040u) {
                        phi_902_ = true;
                    } else {
                        let _e697 = (_e693 > _e692);
                        if _e697 {
                        }
                        phi_902_ = _e697;
                    }
                    let _e699 = phi_902_;
                    if _e699 {
                        phi_906_ = _e693;
                    } else {
                        phi_906_ = _e692;
                    }
                    let _e701 = phi_906_;
                    phi_910_ = lt_mask_Reprojection(_e659.pixel, (abs((_e681 - _e687)) <= (_e689 * _e701)), _e659.has_moved);
                } else {
                    phi_910_ = _e659;
                }
                let _e709 = phi_910_;
                if _e709.is_valid {
                    let _e712 = p.member.flags;
                    phi_919_ = ((_e712 & 1u) != 0u);
                    phi_920_ = false;
                } else {
                    phi_919_ = bool();
                    phi_920_ = true;
                }
                let _e716 = phi_919_;
                let _e718 = phi_920_;
                phi_922_ = _e716;
                phi_923_ = _e709;
                phi_924_ = _e709;
                phi_925_ = _e718;
            } else {
                phi_922_ = bool();
                phi_923_ = lt_mask_Reprojection();
                phi_924_ = lt_mask_Reprojection(_e632.pixel, false, _e632.has_moved);
                phi_925_ = true;
            }
            let _e724 = phi_922_;
            let _e726 = phi_923_;
            let _e728 = phi_924_;
            let _e730 = phi_925_;
            if _e730 {
                phi_929_ = false;
                phi_930_ = _e728;
            } else {
                phi_929_ = _e724;
                phi_930_ = _e726;
            }
            let _e732 = phi_929_;
            let _e734 = phi_930_;
            let _e738 = lt_mask_Reprojection(_e734.pixel, _e732, _e734.has_moved);
            let _e739 = lt_mask_Neighbourhood(false, true);
            if _e277 {
                phi_936_ = false;
            } else {
                phi_936_ = true;
            }
            let _e741 = phi_936_;
            if _e741 {
                if _e732 {
                    if ((0u & 2u) != 0u) {
                        phi_1231_ = _e739;
                    } else {
                        let _e745 = p.member.expansion;
                        if _e738.has_moved {
                            let _e748 = p.member.moving_pattern;
                            phi_958_ = _e748;
                        } else {
                            let _e750 = p.member.still_pattern;
                            phi_958_ = _e750;
                        }
                        let _e752 = phi_958_;
                        phi_960_ = 0u;
                        phi_963_ = _e739;
                        loop {
                            let _e754 = phi_960_;
                            let _e756 = phi_963_;
                            local_1 = _e756;
                            if (1u <= _e752) {
                                if (_e752 <= 4u) {
                                    phi_975_ = false;
                                } else {
                                    phi_975_ = true;
                                }
                                let _e760 = phi_975_;
                                phi_976_ = _e760;
                            } else {
                                phi_976_ = true;
                            }
                            let _e762 = phi_976_;
                            if _e762 {
                                switch bitcast<i32>(_e752) {
                                    case 5: {
                                        phi_985_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_985_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_985_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_985_ = 9u;
                                        break;
                                    }
                                }
                                let _e765 = phi_985_;
                                phi_986_ = _e765;
                            } else {
                                phi_986_ = 5u;
                            }
                            let _e767 = phi_986_;
                            let _e768 = (_e754 < _e767);
                            if _e768 {
                                let _e774 = p.member.frame;
                                let _e778 = p.member.current.size[0u];
                                let _e780 = p.member.current.size[1u];
                                switch bitcast<i32>(_e752) {
                                    case 1: {
                                        let _e790 = lt_mask_pattern_plus(_e754);
                                        phi_1066_ = vec2<i32>(_e790.x, _e790.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e794 = lt_mask_pattern_cross(_e754);
                                        phi_1066_ = vec2<i32>(_e794.x, _e794.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e800 = lt_mask_pattern_plus_or_cross(_e754, ((_e738.pixel.x + _e738.pixel.y) & 1u));
                                        phi_1066_ = vec2<i32>(_e800.x, _e800.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e805 = lt_mask_pattern_plus_or_cross(_e754, (_e774 & 1u));
                                        phi_1066_ = vec2<i32>(_e805.x, _e805.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e774 & 3u)) {
                                            case 0: {
                                                phi_1046_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_1046_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_1046_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_1046_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e816 = phi_1046_;
                                        phi_1066_ = (_e816 + vec2<i32>(bitcast<i32>((_e754 & 1u)), bitcast<i32>(((_e754 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_1066_ = vec2<i32>((bitcast<i32>((_e754 % 5u)) - 2i), (bitcast<i32>(((_e754 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e833 = lt_mask_pattern_diamond(_e754);
                                        phi_1066_ = vec2<i32>(_e833.x, _e833.y);
                                        break;
                                    }
                                    default: {
                                        phi_1066_ = vec2<i32>((bitcast<i32>((_e754 % 3u)) - 1i), (bitcast<i32>(((_e754 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e838 = phi_1066_;
                                let _e841 = lt_mask_pattern_step_clamped(_e738.pixel.x, _e838.x, _e778);
                                let _e842 = lt_mask_pattern_step_clamped(_e738.pixel.y, _e838.y, _e780);
                                let _e849 = ((((_e842 * _e110) + _e841) * _e106.words) + _e106.light.word);
                                if (_e106.light.shift > 29u) {
                                    let _e853 = (_e849 + 1u);
                                    if (_e853 < _e65) {
                                    } else {
                                        return;
                                    }
                                    let _e857 = last_bits.member[(0u + _e853)];
                                    phi_1093_ = _e857;
                                } else {
                                    phi_1093_ = 0u;
                                }
                                let _e859 = phi_1093_;
                                if (_e849 < _e65) {
                                } else {
                                    return;
                                }
                                let _e865 = last_bits.member[(0u + _e849)];
                                let _e868 = (_e865 >> bitcast<u32>((_e106.light.shift & 31u)));
                                if (_e106.light.shift > 29u) {
                                    phi_1112_ = (_e868 | (_e859 << bitcast<u32>(((32u - _e106.light.shift) & 31u))));
                                } else {
                                    phi_1112_ = _e868;
                                }
                                let _e876 = phi_1112_;
                                if ((_e876 & 2u) == 0u) {
                                    phi_1120_ = (_e876 & 1u);
                                } else {
                                    phi_1120_ = (_e876 & 7u);
                                }
                                let _e882 = phi_1120_;
                                if _e756.any_expands {
                                    phi_1208_ = true;
                                } else {
                                    if ((_e882 & 2u) != 0u) {
                                        let _e889 = (((_e882 & 4u) != 0u) != _e273);
                                        switch bitcast<i32>(_e745) {
                                            case 1: {
                                                phi_1148_ = bool();
                                                phi_1149_ = false;
                                                phi_1150_ = true;
                                                phi_1151_ = false;
                                                phi_1152_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e889 {
                                                    phi_1146_ = (((_e882 & 4u) != 0u) != ((_e882 & 1u) != 0u));
                                                    phi_1147_ = false;
                                                } else {
                                                    phi_1146_ = bool();
                                                    phi_1147_ = true;
                                                }
                                                let _e897 = phi_1146_;
                                                let _e899 = phi_1147_;
                                                phi_1148_ = _e897;
                                                phi_1149_ = false;
                                                phi_1150_ = false;
                                                phi_1151_ = _e899;
                                                phi_1152_ = _e889;
                                                break;
                                            }
                                            default: {
                                                phi_1148_ = bool();
                                                phi_1149_ = true;
                                                phi_1150_ = false;
                                                phi_1151_ = false;
                                                phi_1152_ = false;
                                                break;
                                            }
                                        }
                                        let _e901 = phi_1148_;
                                        let _e903 = phi_1149_;
                                        let _e905 = phi_1150_;
                                        let _e907 = phi_1151_;
                                        let _e909 = phi_1152_;
                                        phi_1160_ = _e889;
                                        phi_1161_ = _e901;
                                        phi_1162_ = _e903;
                                        phi_1163_ = _e905;
                                        phi_1164_ = _e907;
                                        phi_1165_ = _e909;
                                    } else {
                                        switch bitcast<i32>(_e745) {
                                            case 1: {
                                                phi_1157_ = false;
                                                phi_1158_ = true;
                                                phi_1159_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_1157_ = false;
                                                phi_1158_ = false;
                                                phi_1159_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_1157_ = true;
                                                phi_1158_ = false;
                                                phi_1159_ = false;
                                                break;
                                            }
                                        }
                                        let _e912 = phi_1157_;
                                        let _e914 = phi_1158_;
                                        let _e916 = phi_1159_;
                                        phi_1160_ = false;
                                        phi_1161_ = bool();
                                        phi_1162_ = _e912;
                                        phi_1163_ = _e914;
                                        phi_1164_ = _e916;
                                        phi_1165_ = false;
                                    }
                                    let _e918 = phi_1160_;
                                    let _e920 = phi_1161_;
                                    let _e922 = phi_1162_;
                                    let _e924 = phi_1163_;
                                    let _e926 = phi_1164_;
                                    let _e928 = phi_1165_;
                                    if _e922 {
                                        if ((_e882 & 2u) != 0u) {
                                            if (((_e882 & 4u) != 0u) != _e273) {
                                                phi_1180_ = false;
                                            } else {
                                                phi_1180_ = true;
                                            }
                                            let _e935 = phi_1180_;
                                            phi_1181_ = _e935;
                                        } else {
                                            phi_1181_ = true;
                                        }
                                        let _e937 = phi_1181_;
                                        if _e937 {
                                            phi_1188_ = (((_e882 & 1u) != 0u) != _e273);
                                        } else {
                                            phi_1188_ = true;
                                        }
                                        let _e942 = phi_1188_;
                                        phi_1189_ = _e942;
                                        phi_1190_ = false;
                                        phi_1191_ = false;
                                        phi_1192_ = false;
                                    } else {
                                        phi_1189_ = bool();
                                        phi_1190_ = _e924;
                                        phi_1191_ = _e926;
                                        phi_1192_ = _e928;
                                    }
                                    let _e944 = phi_1189_;
                                    let _e946 = phi_1190_;
                                    let _e948 = phi_1191_;
                                    let _e950 = phi_1192_;
                                    if _e946 {
                                        phi_1196_ = _e918;
                                        phi_1197_ = false;
                                        phi_1198_ = false;
                                    } else {
                                        phi_1196_ = _e944;
                                        phi_1197_ = _e948;
                                        phi_1198_ = _e950;
                                    }
                                    let _e952 = phi_1196_;
                                    let _e954 = phi_1197_;
                                    let _e956 = phi_1198_;
                                    if _e954 {
                                        phi_1202_ = false;
                                        phi_1203_ = true;
                                    } else {
                                        phi_1202_ = _e920;
                                        phi_1203_ = _e956;
                                    }
                                    let _e958 = phi_1202_;
                                    let _e960 = phi_1203_;
                                    if _e960 {
                                        phi_1207_ = _e958;
                                    } else {
                                        phi_1207_ = _e952;
                                    }
                                    let _e962 = phi_1207_;
                                    phi_1208_ = _e962;
                                }
                                let _e964 = phi_1208_;
                                if _e756.all_remove {
                                    if (((_e882 & 1u) != 0u) == _e273) {
                                        if ((_e882 & 2u) != 0u) {
                                            phi_1226_ = (((_e882 & 4u) != 0u) == _e273);
                                        } else {
                                            phi_1226_ = true;
                                        }
                                        let _e974 = phi_1226_;
                                        phi_1227_ = _e974;
                                    } else {
                                        phi_1227_ = false;
                                    }
                                    let _e976 = phi_1227_;
                                    phi_1228_ = _e976;
                                } else {
                                    phi_1228_ = false;
                                }
                                let _e978 = phi_1228_;
                                phi_961_ = (_e754 + 1u);
                                phi_964_ = lt_mask_Neighbourhood(_e964, _e978);
                            } else {
                                phi_961_ = u32();
                                phi_964_ = lt_mask_Neighbourhood();
                            }
                            let _e982 = phi_961_;
                            let _e984 = phi_964_;
                            continue;
                            continuing {
                                phi_960_ = _e982;
                                phi_963_ = _e984;
                                break if !(_e768);
                            }
                        }
                        let _e1330 = local_1;
                        phi_1231_ = _e1330;
                    }
                    let _e987 = phi_1231_;
                    phi_1232_ = _e987;
                } else {
                    phi_1232_ = _e739;
                }
                let _e989 = phi_1232_;
                phi_1233_ = _e989;
            } else {
                phi_1233_ = _e739;
            }
            let _e991 = phi_1233_;
            let _e994 = p.member.frame;
            let _e996 = p.member.refresh;
            if (_e996 == 0u) {
                phi_1266_ = false;
            } else {
                if (_e996 == 0u) {
                    return;
                }
                let _e1005 = ((_e59.x + (_e59.y * (((_e996 * 5u) / 8u) | 1u))) + (_e994 % _e996));
                if (_e996 == 0u) {
                    phi_1265_ = (_e1005 == 0u);
                } else {
                    if (_e996 == 0u) {
                        return;
                    }
                    phi_1265_ = ((_e1005 % _e996) == 0u);
                }
                let _e1012 = phi_1265_;
                phi_1266_ = _e1012;
            }
            let _e1014 = phi_1266_;
            if _e732 {
                if _e1014 {
                    phi_1288_ = bool();
                } else {
                    phi_1288_ = ((0u & 2u) != 0u);
                }
                let _e1020 = phi_1288_;
                phi_1289_ = _e1020;
                phi_1290_ = _e1014;
            } else {
                phi_1289_ = bool();
                phi_1290_ = true;
            }
            let _e1022 = phi_1289_;
            let _e1024 = phi_1290_;
            if _e1024 {
                phi_1294_ = false;
            } else {
                phi_1294_ = _e1022;
            }
            let _e1026 = phi_1294_;
            if _e1026 {
                phi_1345_ = 7u;
            } else {
                if (_e115 != 0.5f) {
                    if _e732 {
                        if _e1014 {
                            phi_1342_ = 6u;
                        } else {
                            if _e277 {
                                phi_1317_ = true;
                            } else {
                                if _e991.any_expands {
                                    phi_1316_ = false;
                                } else {
                                    phi_1316_ = true;
                                }
                                let _e1028 = phi_1316_;
                                phi_1317_ = _e1028;
                            }
                            let _e1030 = phi_1317_;
                            if _e1030 {
                                if _e277 {
                                    if false {
                                        if _e991.all_remove {
                                            phi_1330_ = false;
                                        } else {
                                            phi_1330_ = true;
                                        }
                                        let _e1032 = phi_1330_;
                                        phi_1331_ = _e1032;
                                    } else {
                                        phi_1331_ = true;
                                    }
                                    let _e1034 = phi_1331_;
                                    phi_1332_ = _e1034;
                                } else {
                                    phi_1332_ = true;
                                }
                                let _e1036 = phi_1332_;
                                if _e1036 {
                                    if _e277 {
                                        phi_1339_ = 1u;
                                    } else {
                                        phi_1339_ = 0u;
                                    }
                                    let _e1038 = phi_1339_;
                                    phi_1340_ = _e1038;
                                } else {
                                    phi_1340_ = 5u;
                                }
                                let _e1040 = phi_1340_;
                                phi_1341_ = _e1040;
                            } else {
                                phi_1341_ = 4u;
                            }
                            let _e1042 = phi_1341_;
                            phi_1342_ = _e1042;
                        }
                        let _e1044 = phi_1342_;
                        phi_1343_ = _e1044;
                    } else {
                        phi_1343_ = 3u;
                    }
                    let _e1046 = phi_1343_;
                    phi_1344_ = _e1046;
                } else {
                    phi_1344_ = 2u;
                }
                let _e1048 = phi_1344_;
                phi_1345_ = _e1048;
            }
            let _e1050 = phi_1345_;
            if !((_e1050 == 0u)) {
                if !((_e1050 == 5u)) {
                    phi_1357_ = !(_e1026);
                    phi_1358_ = false;
                } else {
                    phi_1357_ = bool();
                    phi_1358_ = true;
                }
                let _e1057 = phi_1357_;
                let _e1059 = phi_1358_;
                phi_1359_ = _e1057;
                phi_1360_ = _e1059;
            } else {
                phi_1359_ = bool();
                phi_1360_ = true;
            }
            let _e1061 = phi_1359_;
            let _e1063 = phi_1360_;
            if _e1063 {
                phi_1364_ = false;
            } else {
                phi_1364_ = _e1061;
            }
            let _e1065 = phi_1364_;
            if _e1026 {
                phi_1370_ = ((0u & 4u) != 0u);
            } else {
                phi_1370_ = _e273;
            }
            let _e1069 = phi_1370_;
            if _e1065 {
                if _e273 {
                    phi_1378_ = (2u | 1u);
                } else {
                    phi_1378_ = 2u;
                }
                let _e1072 = phi_1378_;
                if false {
                    phi_1383_ = (_e1072 | 4u);
                } else {
                    phi_1383_ = _e1072;
                }
                let _e1075 = phi_1383_;
                phi_1403_ = _e1075;
            } else {
                if (_e1050 == 7u) {
                    if _e273 {
                        phi_1392_ = (2u | 1u);
                    } else {
                        phi_1392_ = 2u;
                    }
                    let _e1079 = phi_1392_;
                    if _e1069 {
                        phi_1397_ = (_e1079 | 4u);
                    } else {
                        phi_1397_ = _e1079;
                    }
                    let _e1082 = phi_1397_;
                    phi_1402_ = _e1082;
                } else {
                    if _e273 {
                        phi_1401_ = 1u;
                    } else {
                        phi_1401_ = 0u;
                    }
                    let _e1084 = phi_1401_;
                    phi_1402_ = _e1084;
                }
                let _e1086 = phi_1402_;
                phi_1403_ = _e1086;
            }
            let _e1088 = phi_1403_;
            if _e1069 {
                phi_1407_ = 0f;
            } else {
                phi_1407_ = 1f;
            }
            let _e1090 = phi_1407_;
            phi_1409_ = mask_Masked(_e1090, _e1088, _e1065);
        }
        let _e1093 = phi_1409_;
        visibility.member[_e79.shift] = _e1093.visibility;
        let _e1098 = p.member.light.number;
        let _e1099 = (_e1098 * 3u);
        let _e1101 = (_e1099 % 32u);
        let _e1103 = p.member.light.mask_words;
        let _e1105 = ((_e79.shift * _e1103) + (_e1099 / 32u));
        let _e1107 = bits.member[_e1105];
        bits.member[_e1105] = ((_e1107 & ~((7u << bitcast<u32>((_e1101 & 31u))))) | (_e1093.bits << bitcast<u32>((_e1101 & 31u))));
        if (_e1101 > 29u) {
            let _e1122 = bits.member[(_e1105 + 1u)];
            let _e1124 = (32u - _e1101);
            bits.member[(_e1105 + 1u)] = ((_e1122 & ~((7u >> bitcast<u32>((_e1124 & 31u))))) | (_e1093.bits >> bitcast<u32>((_e1124 & 31u))));
        }
        let _e1139 = samples.member[_e79.shift].normal[0u];
        let _e1141 = global[0u];
        if (_e1139 == _e1141) {
            let _e1144 = samples.member[_e79.shift].normal[1u];
            let _e1146 = global[1u];
            if (_e1144 == _e1146) {
                let _e1149 = samples.member[_e79.shift].normal[2u];
                let _e1151 = global[2u];
                phi_1481_ = (_e1149 == _e1151);
                phi_1482_ = false;
            } else {
                phi_1481_ = bool();
                phi_1482_ = true;
            }
            let _e1154 = phi_1481_;
            let _e1156 = phi_1482_;
            phi_1483_ = _e1154;
            phi_1484_ = _e1156;
        } else {
            phi_1483_ = bool();
            phi_1484_ = true;
        }
        let _e1158 = phi_1483_;
        let _e1160 = phi_1484_;
        if _e1160 {
            phi_1488_ = false;
        } else {
            phi_1488_ = _e1158;
        }
        let _e1162 = phi_1488_;
        if !(_e1162) {
            let _e1165 = samples.member[_e79.shift].position;
            let _e1167 = p.member.current.eye;
            let _e1178 = p.member.current.forward;
            phi_1516_ = ((((_e1165.x - _e1167.x) * _e1178.x) + ((_e1165.y - _e1167.y) * _e1178.y)) + ((_e1165.z - _e1167.z) * _e1178.z));
        } else {
            phi_1516_ = 0f;
        }
        let _e1188 = phi_1516_;
        depths.member[_e79.shift] = _e1188;
        phi_1519_ = _e1093.needs_ray;
        phi_1520_ = _e79.shift;
    } else {
        phi_1519_ = false;
        phi_1520_ = 0u;
    }
    let _e1192 = phi_1519_;
    let _e1194 = phi_1520_;
    if (_e60 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1192 {
        let _e1198 = atomicAdd((&shared_[0u]), 1u);
        phi_1531_ = _e1198;
    } else {
        phi_1531_ = 0u;
    }
    let _e1200 = phi_1531_;
    workgroupBarrier();
    if (_e60 == 0u) {
        let _e1204 = atomicLoad((&shared_[0u]));
        let _e1205 = atomicAdd((&list.member[3u]), _e1204);
        atomicStore((&shared_[1u]), _e1205);
    }
    workgroupBarrier();
    if _e1192 {
        let _e1208 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1208) + _e1200)]), _e1194);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_depth_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
