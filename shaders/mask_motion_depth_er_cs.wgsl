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
    var phi_176_: lt_mask_LightPlace;
    var phi_177_: bool;
    var phi_178_: lt_mask_LightPlace;
    var phi_179_: bool;
    var phi_184_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_176_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_177_ = false;
        } else {
            phi_176_ = lt_mask_LightPlace();
            phi_177_ = true;
        }
        let _e72 = phi_176_;
        let _e74 = phi_177_;
        phi_178_ = _e72;
        phi_179_ = _e74;
    } else {
        phi_178_ = lt_mask_LightPlace();
        phi_179_ = true;
    }
    let _e76 = phi_178_;
    let _e78 = phi_179_;
    if _e78 {
        phi_184_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_184_ = _e76;
    }
    let _e83 = phi_184_;
    return lt_mask_LightPlace(_e83.word, _e83.shift);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_202_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_202_ = vec2(0i);
            break;
        }
        case 1: {
            phi_202_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_202_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_202_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_202_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e68 = phi_202_;
    return vec2<i32>(_e68.x, _e68.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_220_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_220_ = vec2(0i);
            break;
        }
        case 1: {
            phi_220_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_220_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_220_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_220_ = vec2(1i);
            break;
        }
    }
    let _e68 = phi_220_;
    return vec2<i32>(_e68.x, _e68.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_239_: vec2<i32>;

    if (param_6 == 0u) {
        let _e62 = lt_mask_pattern_plus(param_5);
        phi_239_ = vec2<i32>(_e62.x, _e62.y);
    } else {
        let _e66 = lt_mask_pattern_cross(param_5);
        phi_239_ = vec2<i32>(_e66.x, _e66.y);
    }
    let _e71 = phi_239_;
    return vec2<i32>(_e71.x, _e71.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_264_: vec2<i32>;

    let _e60 = (param_7 % 13u);
    switch bitcast<i32>(_e60) {
        case 9: {
            phi_264_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_264_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_264_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_264_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_264_ = vec2<i32>((bitcast<i32>((_e60 % 3u)) - 1i), (bitcast<i32>(((_e60 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e75 = phi_264_;
    return vec2<i32>(_e75.x, _e75.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_285_: u32;
    var phi_286_: u32;

    let _e63 = (bitcast<i32>(param_8) + param_9);
    if (_e63 < 0i) {
        phi_286_ = 0u;
    } else {
        if (_e63 >= bitcast<i32>(param_10)) {
            phi_285_ = (param_10 - 1u);
        } else {
            phi_285_ = bitcast<u32>(_e63);
        }
        let _e70 = phi_285_;
        phi_286_ = _e70;
    }
    let _e72 = phi_286_;
    return _e72;
}

fn function_() {
    var phi_363_: bool;
    var phi_364_: bool;
    var phi_365_: bool;
    var phi_366_: bool;
    var phi_370_: bool;
    var phi_440_: bool;
    var phi_441_: bool;
    var phi_452_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_453_: bool;
    var phi_454_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_455_: bool;
    var phi_462_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_466_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_479_: bool;
    var phi_668_: f32;
    var phi_673_: f32;
    var phi_674_: bool;
    var phi_675_: f32;
    var phi_676_: bool;
    var phi_680_: f32;
    var phi_703_: f32;
    var phi_708_: f32;
    var phi_709_: bool;
    var phi_710_: f32;
    var phi_711_: bool;
    var phi_715_: f32;
    var phi_736_: bool;
    var phi_755_: vec2<u32>;
    var phi_756_: bool;
    var phi_757_: bool;
    var phi_758_: bool;
    var phi_759_: vec2<u32>;
    var phi_760_: bool;
    var phi_761_: bool;
    var phi_762_: bool;
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
    var phi_786_: bool;
    var phi_787_: bool;
    var phi_788_: bool;
    var phi_789_: bool;
    var phi_793_: bool;
    var phi_794_: bool;
    var phi_795_: vec2<u32>;
    var phi_884_: bool;
    var phi_888_: f32;
    var phi_892_: lt_mask_Reprojection;
    var phi_901_: bool;
    var phi_902_: bool;
    var phi_904_: bool;
    var phi_905_: lt_mask_Reprojection;
    var phi_906_: lt_mask_Reprojection;
    var phi_907_: bool;
    var phi_911_: bool;
    var phi_912_: lt_mask_Reprojection;
    var phi_918_: bool;
    var phi_940_: u32;
    var phi_942_: u32;
    var phi_945_: lt_mask_Neighbourhood;
    var phi_957_: bool;
    var phi_958_: bool;
    var phi_967_: u32;
    var phi_968_: u32;
    var phi_1028_: vec2<i32>;
    var phi_1048_: vec2<i32>;
    var phi_1075_: u32;
    var phi_1094_: u32;
    var phi_1102_: u32;
    var phi_1128_: bool;
    var phi_1129_: bool;
    var phi_1130_: bool;
    var phi_1131_: bool;
    var phi_1132_: bool;
    var phi_1133_: bool;
    var phi_1134_: bool;
    var phi_1139_: bool;
    var phi_1140_: bool;
    var phi_1141_: bool;
    var phi_1142_: bool;
    var phi_1143_: bool;
    var phi_1144_: bool;
    var phi_1145_: bool;
    var phi_1146_: bool;
    var phi_1147_: bool;
    var phi_1162_: bool;
    var phi_1163_: bool;
    var phi_1170_: bool;
    var phi_1171_: bool;
    var phi_1172_: bool;
    var phi_1173_: bool;
    var phi_1174_: bool;
    var phi_1178_: bool;
    var phi_1179_: bool;
    var phi_1180_: bool;
    var phi_1184_: bool;
    var phi_1185_: bool;
    var phi_1189_: bool;
    var phi_1190_: bool;
    var phi_1208_: bool;
    var phi_1209_: bool;
    var phi_1210_: bool;
    var phi_943_: u32;
    var phi_946_: lt_mask_Neighbourhood;
    var phi_1213_: lt_mask_Neighbourhood;
    var phi_1214_: lt_mask_Neighbourhood;
    var phi_1215_: lt_mask_Neighbourhood;
    var phi_1247_: bool;
    var phi_1248_: bool;
    var phi_1270_: bool;
    var phi_1271_: bool;
    var phi_1272_: bool;
    var phi_1276_: bool;
    var phi_1298_: bool;
    var phi_1299_: bool;
    var phi_1312_: bool;
    var phi_1313_: bool;
    var phi_1314_: bool;
    var phi_1321_: u32;
    var phi_1322_: u32;
    var phi_1323_: u32;
    var phi_1324_: u32;
    var phi_1325_: u32;
    var phi_1326_: u32;
    var phi_1327_: u32;
    var phi_1339_: bool;
    var phi_1340_: bool;
    var phi_1341_: bool;
    var phi_1342_: bool;
    var phi_1346_: bool;
    var phi_1352_: bool;
    var phi_1360_: u32;
    var phi_1365_: u32;
    var phi_1374_: u32;
    var phi_1379_: u32;
    var phi_1383_: u32;
    var phi_1384_: u32;
    var phi_1385_: u32;
    var phi_1389_: f32;
    var phi_1391_: mask_Masked;
    var phi_1463_: bool;
    var phi_1464_: bool;
    var phi_1465_: bool;
    var phi_1466_: bool;
    var phi_1470_: bool;
    var phi_1498_: f32;
    var phi_1501_: bool;
    var phi_1502_: u32;
    var phi_1513_: u32;
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
                phi_363_ = (_e131 == _e133);
                phi_364_ = false;
            } else {
                phi_363_ = bool();
                phi_364_ = true;
            }
            let _e136 = phi_363_;
            let _e138 = phi_364_;
            phi_365_ = _e136;
            phi_366_ = _e138;
        } else {
            phi_365_ = bool();
            phi_366_ = true;
        }
        let _e140 = phi_365_;
        let _e142 = phi_366_;
        if _e142 {
            phi_370_ = false;
        } else {
            phi_370_ = _e140;
        }
        let _e144 = phi_370_;
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
                    phi_441_ = true;
                } else {
                    let _e197 = p.member.light.range_squared;
                    if (_e180 <= _e197) {
                        let _e200 = p.member.light.cos_outer;
                        phi_440_ = (-((((_e162 * _e182.x) + (_e163 * _e182.y)) + (_e164 * _e182.z))) >= (_e200 * sqrt(_e180)));
                    } else {
                        phi_440_ = false;
                    }
                    let _e205 = phi_440_;
                    phi_441_ = _e205;
                }
                let _e207 = phi_441_;
                if _e207 {
                    let _e209 = samples.member[_e79.shift].flags;
                    let _e217 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e223 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e217.unnamed.visibility, false), _e217.unnamed_1);
                    phi_452_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e223.unnamed, ((_e209 & 1u) == 0u));
                    phi_453_ = false;
                } else {
                    phi_452_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_453_ = true;
                }
                let _e228 = phi_452_;
                let _e230 = phi_453_;
                phi_454_ = _e228;
                phi_455_ = _e230;
            } else {
                phi_454_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_455_ = true;
            }
            let _e232 = phi_454_;
            let _e234 = phi_455_;
            if _e234 {
                let _e240 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e246 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e240.unnamed.visibility, false), _e240.unnamed_1);
                phi_462_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e246.unnamed, true);
            } else {
                phi_462_ = _e232;
            }
            let _e251 = phi_462_;
            phi_466_ = _e251;
        } else {
            let _e257 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e263 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e257.unnamed.visibility, false), _e257.unnamed_1);
            phi_466_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e263.unnamed, true);
        }
        let _e268 = phi_466_;
        if _e268.unnamed_1 {
            phi_1391_ = mask_Masked(_e268.unnamed.visibility, 0u, false);
        } else {
            let _e273 = (_e115 < 0.5f);
            if (_e115 > 0f) {
                phi_479_ = (_e115 < 1f);
            } else {
                phi_479_ = false;
            }
            let _e277 = phi_479_;
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
            let _e441 = p.member.current.size[0u];
            let _e443 = p.member.current.size[1u];
            let _e447 = ((f32(_e59.x) + 0.5f) + _e431);
            if (_e447 > -8388608f) {
                let _e459 = f32(select(0i, select(select(i32(_e447), i32(-2147483648), (_e447 < bitcast<f32>(3472883712u))), 2147483647i, (_e447 > bitcast<f32>(1325400063u))), (_e447 == _e447)));
                if (_e459 > _e447) {
                    phi_668_ = 1f;
                } else {
                    phi_668_ = 0f;
                }
                let _e462 = phi_668_;
                if (_e447 < 8388608f) {
                    phi_673_ = (_e459 - _e462);
                    phi_674_ = false;
                } else {
                    phi_673_ = f32();
                    phi_674_ = true;
                }
                let _e465 = phi_673_;
                let _e467 = phi_674_;
                phi_675_ = _e465;
                phi_676_ = _e467;
            } else {
                phi_675_ = f32();
                phi_676_ = true;
            }
            let _e469 = phi_675_;
            let _e471 = phi_676_;
            if _e471 {
                phi_680_ = _e447;
            } else {
                phi_680_ = _e469;
            }
            let _e473 = phi_680_;
            let _e476 = ((f32(_e59.y) + 0.5f) + _e437);
            if (_e476 > -8388608f) {
                let _e488 = f32(select(0i, select(select(i32(_e476), i32(-2147483648), (_e476 < bitcast<f32>(3472883712u))), 2147483647i, (_e476 > bitcast<f32>(1325400063u))), (_e476 == _e476)));
                if (_e488 > _e476) {
                    phi_703_ = 1f;
                } else {
                    phi_703_ = 0f;
                }
                let _e491 = phi_703_;
                if (_e476 < 8388608f) {
                    phi_708_ = (_e488 - _e491);
                    phi_709_ = false;
                } else {
                    phi_708_ = f32();
                    phi_709_ = true;
                }
                let _e494 = phi_708_;
                let _e496 = phi_709_;
                phi_710_ = _e494;
                phi_711_ = _e496;
            } else {
                phi_710_ = f32();
                phi_711_ = true;
            }
            let _e498 = phi_710_;
            let _e500 = phi_711_;
            if _e500 {
                phi_715_ = _e476;
            } else {
                phi_715_ = _e498;
            }
            let _e502 = phi_715_;
            if (_e473 >= 0f) {
                if (_e502 >= 0f) {
                    if (_e473 < f32(_e441)) {
                        let _e508 = (_e502 < f32(_e443));
                        if (_e431 == 0f) {
                            phi_736_ = (_e437 == 0f);
                        } else {
                            phi_736_ = false;
                        }
                        let _e512 = phi_736_;
                        if _e508 {
                            phi_755_ = vec2<u32>(select(select(u32(_e473), 0u, (_e473 < bitcast<f32>(0u))), 4294967295u, (_e473 > bitcast<f32>(1333788671u))), select(select(u32(_e502), 0u, (_e502 < bitcast<f32>(0u))), 4294967295u, (_e502 > bitcast<f32>(1333788671u))));
                            phi_756_ = false;
                        } else {
                            phi_755_ = vec2<u32>();
                            phi_756_ = true;
                        }
                        let _e529 = phi_755_;
                        let _e531 = phi_756_;
                        phi_757_ = _e512;
                        phi_758_ = _e508;
                        phi_759_ = _e529;
                        phi_760_ = _e512;
                        phi_761_ = _e508;
                        phi_762_ = false;
                        phi_763_ = _e531;
                    } else {
                        phi_757_ = bool();
                        phi_758_ = bool();
                        phi_759_ = vec2<u32>();
                        phi_760_ = bool();
                        phi_761_ = bool();
                        phi_762_ = true;
                        phi_763_ = false;
                    }
                    let _e533 = phi_757_;
                    let _e535 = phi_758_;
                    let _e537 = phi_759_;
                    let _e539 = phi_760_;
                    let _e541 = phi_761_;
                    let _e543 = phi_762_;
                    let _e545 = phi_763_;
                    phi_764_ = _e533;
                    phi_765_ = _e535;
                    phi_766_ = _e537;
                    phi_767_ = _e539;
                    phi_768_ = _e541;
                    phi_769_ = _e543;
                    phi_770_ = _e545;
                } else {
                    phi_764_ = bool();
                    phi_765_ = bool();
                    phi_766_ = vec2<u32>();
                    phi_767_ = bool();
                    phi_768_ = bool();
                    phi_769_ = true;
                    phi_770_ = false;
                }
                let _e547 = phi_764_;
                let _e549 = phi_765_;
                let _e551 = phi_766_;
                let _e553 = phi_767_;
                let _e555 = phi_768_;
                let _e557 = phi_769_;
                let _e559 = phi_770_;
                phi_771_ = _e547;
                phi_772_ = _e549;
                phi_773_ = _e551;
                phi_774_ = _e553;
                phi_775_ = _e555;
                phi_776_ = _e557;
                phi_777_ = _e559;
            } else {
                phi_771_ = bool();
                phi_772_ = bool();
                phi_773_ = vec2<u32>();
                phi_774_ = bool();
                phi_775_ = bool();
                phi_776_ = true;
                phi_777_ = false;
            }
            let _e561 = phi_771_;
            let _e563 = phi_772_;
            let _e565 = phi_773_;
            let _e567 = phi_774_;
            let _e569 = phi_775_;
            let _e571 = phi_776_;
            let _e573 = phi_777_;
            if _e571 {
                if (_e431 == 0f) {
                    phi_786_ = (_e437 == 0f);
                } else {
                    phi_786_ = false;
                }
                let _e577 = phi_786_;
                phi_787_ = _e577;
                phi_788_ = false;
                phi_789_ = true;
            } else {
                phi_787_ = _e567;
                phi_788_ = _e569;
                phi_789_ = _e573;
            }
            let _e579 = phi_787_;
            let _e581 = phi_788_;
            let _e583 = phi_789_;
            if _e583 {
                phi_793_ = _e579;
                phi_794_ = _e581;
                phi_795_ = vec2<u32>(_e59.x, _e59.y);
            } else {
                phi_793_ = _e561;
                phi_794_ = _e563;
                phi_795_ = _e565;
            }
            let _e585 = phi_793_;
            let _e587 = phi_794_;
            let _e589 = phi_795_;
            let _e599 = lt_mask_Reprojection(vec2<u32>(_e589.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e606 = lt_mask_Reprojection(vec2<u32>(_e599.pixel.x, _e589.y), _e599.is_valid, _e599.has_moved);
            let _e610 = lt_mask_Reprojection(_e606.pixel, _e587, _e606.has_moved);
            let _e614 = lt_mask_Reprojection(_e610.pixel, _e610.is_valid, !(_e585));
            if _e587 {
                let _e617 = p.member.previous.eye;
                let _e628 = p.member.previous.forward;
                let _e637 = (((((_e113.x - _e617.x) * _e628.x) + ((_e113.y - _e617.y) * _e628.y)) + ((_e113.z - _e617.z) * _e628.z)) > 0f);
                let _e641 = lt_mask_Reprojection(_e614.pixel, _e637, _e614.has_moved);
                if _e637 {
                    let _e644 = p.member.previous.eye;
                    let _e655 = p.member.previous.forward;
                    let _e663 = ((((_e113.x - _e644.x) * _e655.x) + ((_e113.y - _e644.y) * _e655.y)) + ((_e113.z - _e644.z) * _e655.z));
                    let _e665 = ((_e589.y * _e110) + _e589.x);
                    if (_e665 < arrayLength((&last_depths.member))) {
                    } else {
                        return;
                    }
                    let _e669 = last_depths.member[(0u + _e665)];
                    let _e671 = p.member.depth_tolerance;
                    let _e674 = abs(_e663);
                    let _e675 = abs(_e669);
                    if ((bitcast<u32>(_e675) & 2147483647u) > 2139095040u) {
                        phi_884_ = true;
                    } else {
                        let _e679 = (_e675 > _e674);
                        if _e679 {
                        }
                        phi_884_ = _e679;
                    }
                    let _e681 = phi_884_;
                    if _e681 {
                        phi_888_ = _e675;
                    } else {
                        phi_888_ = _e674;
                    }
                    let _e683 = phi_888_;
                    phi_892_ = lt_mask_Reprojection(_e641.pixel, (abs((_e663 - _e669)) <= (_e671 * _e683)), _e641.has_moved);
                } else {
                    phi_892_ = _e641;
                }
                let _e691 = phi_892_;
                if _e691.is_valid {
                    let _e694 = p.member.flags;
                    phi_901_ = ((_e694 & 1u) != 0u);
                    phi_902_ = false;
                } else {
                    phi_901_ = bool();
                    phi_902_ = true;
                }
                let _e698 = phi_901_;
                let _e700 = phi_902_;
                phi_904_ = _e698;
                phi_905_ = _e691;
                phi_906_ = _e691;
                phi_907_ = _e700;
            } else {
                phi_904_ = bool();
                phi_905_ = lt_mask_Reprojection();
                phi_906_ = lt_mask_Reprojection(_e614.pixel, false, _e614.has_moved);
                phi_907_ = true;
            }
            let _e706 = phi_904_;
            let _e708 = phi_905_;
            let _e710 = phi_906_;
            let _e712 = phi_907_;
            if _e712 {
                phi_911_ = false;
                phi_912_ = _e710;
            } else {
                phi_911_ = _e706;
                phi_912_ = _e708;
            }
            let _e714 = phi_911_;
            let _e716 = phi_912_;
            let _e720 = lt_mask_Reprojection(_e716.pixel, _e714, _e716.has_moved);
            let _e721 = lt_mask_Neighbourhood(false, true);
            if _e277 {
                phi_918_ = false;
            } else {
                phi_918_ = true;
            }
            let _e723 = phi_918_;
            if _e723 {
                if _e714 {
                    if ((0u & 2u) != 0u) {
                        phi_1213_ = _e721;
                    } else {
                        let _e727 = p.member.expansion;
                        if _e720.has_moved {
                            let _e730 = p.member.moving_pattern;
                            phi_940_ = _e730;
                        } else {
                            let _e732 = p.member.still_pattern;
                            phi_940_ = _e732;
                        }
                        let _e734 = phi_940_;
                        phi_942_ = 0u;
                        phi_945_ = _e721;
                        loop {
                            let _e736 = phi_942_;
                            let _e738 = phi_945_;
                            local_1 = _e738;
                            if (1u <= _e734) {
                                if (_e734 <= 4u) {
                                    phi_957_ = false;
                                } else {
                                    phi_957_ = true;
                                }
                                let _e742 = phi_957_;
                                phi_958_ = _e742;
                            } else {
                                phi_958_ = true;
                            }
                            let _e744 = phi_958_;
                            if _e744 {
                                switch bitcast<i32>(_e734) {
                                    case 5: {
                                        phi_967_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_967_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_967_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_967_ = 9u;
                                        break;
                                    }
                                }
                                let _e747 = phi_967_;
                                phi_968_ = _e747;
                            } else {
                                phi_968_ = 5u;
                            }
                            let _e749 = phi_968_;
                            let _e750 = (_e736 < _e749);
                            if _e750 {
                                let _e756 = p.member.frame;
                                let _e760 = p.member.current.size[0u];
                                let _e762 = p.member.current.size[1u];
                                switch bitcast<i32>(_e734) {
                                    case 1: {
                                        let _e772 = lt_mask_pattern_plus(_e736);
                                        phi_1048_ = vec2<i32>(_e772.x, _e772.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e776 = lt_mask_pattern_cross(_e736);
                                        phi_1048_ = vec2<i32>(_e776.x, _e776.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e782 = lt_mask_pattern_plus_or_cross(_e736, ((_e720.pixel.x + _e720.pixel.y) & 1u));
                                        phi_1048_ = vec2<i32>(_e782.x, _e782.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e787 = lt_mask_pattern_plus_or_cross(_e736, (_e756 & 1u));
                                        phi_1048_ = vec2<i32>(_e787.x, _e787.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e756 & 3u)) {
                                            case 0: {
                                                phi_1028_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_1028_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_1028_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_1028_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e798 = phi_1028_;
                                        phi_1048_ = (_e798 + vec2<i32>(bitcast<i32>((_e736 & 1u)), bitcast<i32>(((_e736 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_1048_ = vec2<i32>((bitcast<i32>((_e736 % 5u)) - 2i), (bitcast<i32>(((_e736 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e815 = lt_mask_pattern_diamond(_e736);
                                        phi_1048_ = vec2<i32>(_e815.x, _e815.y);
                                        break;
                                    }
                                    default: {
                                        phi_1048_ = vec2<i32>((bitcast<i32>((_e736 % 3u)) - 1i), (bitcast<i32>(((_e736 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e820 = phi_1048_;
                                let _e823 = lt_mask_pattern_step_clamped(_e720.pixel.x, _e820.x, _e760);
                                let _e824 = lt_mask_pattern_step_clamped(_e720.pixel.y, _e820.y, _e762);
                                let _e831 = ((((_e824 * _e110) + _e823) * _e106.words) + _e106.light.word);
                                if (_e106.light.shift > 29u) {
                                    let _e835 = (_e831 + 1u);
                                    if (_e835 < _e65) {
                                    } else {
                                        return;
                                    }
                                    let _e839 = last_bits.member[(0u + _e835)];
                                    phi_1075_ = _e839;
                                } else {
                                    phi_1075_ = 0u;
                                }
                                let _e841 = phi_1075_;
                                if (_e831 < _e65) {
                                } else {
                                    return;
                                }
                                let _e847 = last_bits.member[(0u + _e831)];
                                let _e850 = (_e847 >> bitcast<u32>((_e106.light.shift & 31u)));
                                if (_e106.light.shift > 29u) {
                                    phi_1094_ = (_e850 | (_e841 << bitcast<u32>(((32u - _e106.light.shift) & 31u))));
                                } else {
                                    phi_1094_ = _e850;
                                }
                                let _e858 = phi_1094_;
                                if ((_e858 & 2u) == 0u) {
                                    phi_1102_ = (_e858 & 1u);
                                } else {
                                    phi_1102_ = (_e858 & 7u);
                                }
                                let _e864 = phi_1102_;
                                if _e738.any_expands {
                                    phi_1190_ = true;
                                } else {
                                    if ((_e864 & 2u) != 0u) {
                                        let _e871 = (((_e864 & 4u) != 0u) != _e273);
                                        switch bitcast<i32>(_e727) {
                                            case 1: {
                                                phi_1130_ = bool();
                                                phi_1131_ = false;
                                                phi_1132_ = true;
                                                phi_1133_ = false;
                                                phi_1134_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e871 {
                                                    phi_1128_ = (((_e864 & 4u) != 0u) != ((_e864 & 1u) != 0u));
                                                    phi_1129_ = false;
                                                } else {
                                                    phi_1128_ = bool();
                                                    phi_1129_ = true;
                                                }
                                                let _e879 = phi_1128_;
                                                let _e881 = phi_1129_;
                                                phi_1130_ = _e879;
                                                phi_1131_ = false;
                                                phi_1132_ = false;
                                                phi_1133_ = _e881;
                                                phi_1134_ = _e871;
                                                break;
                                            }
                                            default: {
                                                phi_1130_ = bool();
                                                phi_1131_ = true;
                                                phi_1132_ = false;
                                                phi_1133_ = false;
                                                phi_1134_ = false;
                                                break;
                                            }
                                        }
                                        let _e883 = phi_1130_;
                                        let _e885 = phi_1131_;
                                        let _e887 = phi_1132_;
                                        let _e889 = phi_1133_;
                                        let _e891 = phi_1134_;
                                        phi_1142_ = _e871;
                                        phi_1143_ = _e883;
                                        phi_1144_ = _e885;
                                        phi_1145_ = _e887;
                                        phi_1146_ = _e889;
                                        phi_1147_ = _e891;
                                    } else {
                                        switch bitcast<i32>(_e727) {
                                            case 1: {
                                                phi_1139_ = false;
                                                phi_1140_ = true;
                                                phi_1141_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_1139_ = false;
                                                phi_1140_ = false;
                                                phi_1141_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_1139_ = true;
                                                phi_1140_ = false;
                                                phi_1141_ = false;
                                                break;
                                            }
                                        }
                                        let _e894 = phi_1139_;
                                        let _e896 = phi_1140_;
                                        let _e898 = phi_1141_;
                                        phi_1142_ = false;
                                        phi_1143_ = bool();
                                        phi_1144_ = _e894;
                                        phi_1145_ = _e896;
                                        phi_1146_ = _e898;
                                        phi_1147_ = false;
                                    }
                                    let _e900 = phi_1142_;
                                    let _e902 = phi_1143_;
                                    let _e904 = phi_1144_;
                                    let _e906 = phi_1145_;
                                    let _e908 = phi_1146_;
                                    let _e910 = phi_1147_;
                                    if _e904 {
                                        if ((_e864 & 2u) != 0u) {
                                            if (((_e864 & 4u) != 0u) != _e273) {
                                                phi_1162_ = false;
                                            } else {
                                                phi_1162_ = true;
                                            }
                                            let _e917 = phi_1162_;
                                            phi_1163_ = _e917;
                                        } else {
                                            phi_1163_ = true;
                                        }
                                        let _e919 = phi_1163_;
                                        if _e919 {
                                            phi_1170_ = (((_e864 & 1u) != 0u) != _e273);
                                        } else {
                                            phi_1170_ = true;
                                        }
                                        let _e924 = phi_1170_;
                                        phi_1171_ = _e924;
                                        phi_1172_ = false;
                                        phi_1173_ = false;
                                        phi_1174_ = false;
                                    } else {
                                        phi_1171_ = bool();
                                        phi_1172_ = _e906;
                                        phi_1173_ = _e908;
                                        phi_1174_ = _e910;
                                    }
                                    let _e926 = phi_1171_;
                                    let _e928 = phi_1172_;
                                    let _e930 = phi_1173_;
                                    let _e932 = phi_1174_;
                                    if _e928 {
                                        phi_1178_ = _e900;
                                        phi_1179_ = false;
                                        phi_1180_ = false;
                                    } else {
                                        phi_1178_ = _e926;
                                        phi_1179_ = _e930;
                                        phi_1180_ = _e932;
                                    }
                                    let _e934 = phi_1178_;
                                    let _e936 = phi_1179_;
                                    let _e938 = phi_1180_;
                                    if _e936 {
                                        phi_1184_ = false;
                                        phi_1185_ = true;
                                    } else {
                                        phi_1184_ = _e902;
                                        phi_1185_ = _e938;
                                    }
                                    let _e940 = phi_1184_;
                                    let _e942 = phi_1185_;
                                    if _e942 {
                                        phi_1189_ = _e940;
                                    } else {
                                        phi_1189_ = _e934;
                                    }
                                    let _e944 = phi_1189_;
                                    phi_1190_ = _e944;
                                }
                                let _e946 = phi_1190_;
                                if _e738.all_remove {
                                    if (((_e864 & 1u) != 0u) == _e273) {
                                        if ((_e864 & 2u) != 0u) {
                                            phi_1208_ = (((_e864 & 4u) != 0u) == _e273);
                                        } else {
                                            phi_1208_ = true;
                                        }
                                        let _e956 = phi_1208_;
                                        phi_1209_ = _e956;
                                    } else {
                                        phi_1209_ = false;
                                    }
                                    let _e958 = phi_1209_;
                                    phi_1210_ = _e958;
                                } else {
                                    phi_1210_ = false;
                                }
                                let _e960 = phi_1210_;
                                phi_943_ = (_e736 + 1u);
                                phi_946_ = lt_mask_Neighbourhood(_e946, _e960);
                            } else {
                                phi_943_ = u32();
                                phi_946_ = lt_mask_Neighbourhood();
                            }
                            let _e964 = phi_943_;
                            let _e966 = phi_946_;
                            continue;
                            continuing {
                                phi_942_ = _e964;
                                phi_945_ = _e966;
                                break if !(_e750);
                            }
                        }
                        let _e1312 = local_1;
                        phi_1213_ = _e1312;
                    }
                    let _e969 = phi_1213_;
                    phi_1214_ = _e969;
                } else {
                    phi_1214_ = _e721;
                }
                let _e971 = phi_1214_;
                phi_1215_ = _e971;
            } else {
                phi_1215_ = _e721;
            }
            let _e973 = phi_1215_;
            let _e976 = p.member.frame;
            let _e978 = p.member.refresh;
            if (_e978 == 0u) {
                phi_1248_ = false;
            } else {
                if (_e978 == 0u) {
                    return;
                }
                let _e987 = ((_e59.x + (_e59.y * (((_e978 * 5u) / 8u) | 1u))) + (_e976 % _e978));
                if (_e978 == 0u) {
                    phi_1247_ = (_e987 == 0u);
                } else {
                    if (_e978 == 0u) {
                        return;
                    }
                    phi_1247_ = ((_e987 % _e978) == 0u);
                }
                let _e994 = phi_1247_;
                phi_1248_ = _e994;
            }
            let _e996 = phi_1248_;
            if _e714 {
                if _e996 {
                    phi_1270_ = bool();
                } else {
                    phi_1270_ = ((0u & 2u) != 0u);
                }
                let _e1002 = phi_1270_;
                phi_1271_ = _e1002;
                phi_1272_ = _e996;
            } else {
                phi_1271_ = bool();
                phi_1272_ = true;
            }
            let _e1004 = phi_1271_;
            let _e1006 = phi_1272_;
            if _e1006 {
                phi_1276_ = false;
            } else {
                phi_1276_ = _e1004;
            }
            let _e1008 = phi_1276_;
            if _e1008 {
                phi_1327_ = 7u;
            } else {
                if (_e115 != 0.5f) {
                    if _e714 {
                        if _e996 {
                            phi_1324_ = 6u;
                        } else {
                            if _e277 {
                                phi_1299_ = true;
                            } else {
                                if _e973.any_expands {
                                    phi_1298_ = false;
                                } else {
                                    phi_1298_ = true;
                                }
                                let _e1010 = phi_1298_;
                                phi_1299_ = _e1010;
                            }
                            let _e1012 = phi_1299_;
                            if _e1012 {
                                if _e277 {
                                    if false {
                                        if _e973.all_remove {
                                            phi_1312_ = false;
                                        } else {
                                            phi_1312_ = true;
                                        }
                                        let _e1014 = phi_1312_;
                                        phi_1313_ = _e1014;
                                    } else {
                                        phi_1313_ = true;
                                    }
                                    let _e1016 = phi_1313_;
                                    phi_1314_ = _e1016;
                                } else {
                                    phi_1314_ = true;
                                }
                                let _e1018 = phi_1314_;
                                if _e1018 {
                                    if _e277 {
                                        phi_1321_ = 1u;
                                    } else {
                                        phi_1321_ = 0u;
                                    }
                                    let _e1020 = phi_1321_;
                                    phi_1322_ = _e1020;
                                } else {
                                    phi_1322_ = 5u;
                                }
                                let _e1022 = phi_1322_;
                                phi_1323_ = _e1022;
                            } else {
                                phi_1323_ = 4u;
                            }
                            let _e1024 = phi_1323_;
                            phi_1324_ = _e1024;
                        }
                        let _e1026 = phi_1324_;
                        phi_1325_ = _e1026;
                    } else {
                        phi_1325_ = 3u;
                    }
                    let _e1028 = phi_1325_;
                    phi_1326_ = _e1028;
                } else {
                    phi_1326_ = 2u;
                }
                let _e1030 = phi_1326_;
                phi_1327_ = _e1030;
            }
            let _e1032 = phi_1327_;
            if !((_e1032 == 0u)) {
                if !((_e1032 == 5u)) {
                    phi_1339_ = !(_e1008);
                    phi_1340_ = false;
                } else {
                    phi_1339_ = bool();
                    phi_1340_ = true;
                }
                let _e1039 = phi_1339_;
                let _e1041 = phi_1340_;
                phi_1341_ = _e1039;
                phi_1342_ = _e1041;
            } else {
                phi_1341_ = bool();
                phi_1342_ = true;
            }
            let _e1043 = phi_1341_;
            let _e1045 = phi_1342_;
            if _e1045 {
                phi_1346_ = false;
            } else {
                phi_1346_ = _e1043;
            }
            let _e1047 = phi_1346_;
            if _e1008 {
                phi_1352_ = ((0u & 4u) != 0u);
            } else {
                phi_1352_ = _e273;
            }
            let _e1051 = phi_1352_;
            if _e1047 {
                if _e273 {
                    phi_1360_ = (2u | 1u);
                } else {
                    phi_1360_ = 2u;
                }
                let _e1054 = phi_1360_;
                if false {
                    phi_1365_ = (_e1054 | 4u);
                } else {
                    phi_1365_ = _e1054;
                }
                let _e1057 = phi_1365_;
                phi_1385_ = _e1057;
            } else {
                if (_e1032 == 7u) {
                    if _e273 {
                        phi_1374_ = (2u | 1u);
                    } else {
                        phi_1374_ = 2u;
                    }
                    let _e1061 = phi_1374_;
                    if _e1051 {
                        phi_1379_ = (_e1061 | 4u);
                    } else {
                        phi_1379_ = _e1061;
                    }
                    let _e1064 = phi_1379_;
                    phi_1384_ = _e1064;
                } else {
                    if _e273 {
                        phi_1383_ = 1u;
                    } else {
                        phi_1383_ = 0u;
                    }
                    let _e1066 = phi_1383_;
                    phi_1384_ = _e1066;
                }
                let _e1068 = phi_1384_;
                phi_1385_ = _e1068;
            }
            let _e1070 = phi_1385_;
            if _e1051 {
                phi_1389_ = 0f;
            } else {
                phi_1389_ = 1f;
            }
            let _e1072 = phi_1389_;
            phi_1391_ = mask_Masked(_e1072, _e1070, _e1047);
        }
        let _e1075 = phi_1391_;
        visibility.member[_e79.shift] = _e1075.visibility;
        let _e1080 = p.member.light.number;
        let _e1081 = (_e1080 * 3u);
        let _e1083 = (_e1081 % 32u);
        let _e1085 = p.member.light.mask_words;
        let _e1087 = ((_e79.shift * _e1085) + (_e1081 / 32u));
        let _e1089 = bits.member[_e1087];
        bits.member[_e1087] = ((_e1089 & ~((7u << bitcast<u32>((_e1083 & 31u))))) | (_e1075.bits << bitcast<u32>((_e1083 & 31u))));
        if (_e1083 > 29u) {
            let _e1104 = bits.member[(_e1087 + 1u)];
            let _e1106 = (32u - _e1083);
            bits.member[(_e1087 + 1u)] = ((_e1104 & ~((7u >> bitcast<u32>((_e1106 & 31u))))) | (_e1075.bits >> bitcast<u32>((_e1106 & 31u))));
        }
        let _e1121 = samples.member[_e79.shift].normal[0u];
        let _e1123 = global[0u];
        if (_e1121 == _e1123) {
            let _e1126 = samples.member[_e79.shift].normal[1u];
            let _e1128 = global[1u];
            if (_e1126 == _e1128) {
                let _e1131 = samples.member[_e79.shift].normal[2u];
                let _e1133 = global[2u];
                phi_1463_ = (_e1131 == _e1133);
                phi_1464_ = false;
            } else {
                phi_1463_ = bool();
                phi_1464_ = true;
            }
            let _e1136 = phi_1463_;
            let _e1138 = phi_1464_;
            phi_1465_ = _e1136;
            phi_1466_ = _e1138;
        } else {
            phi_1465_ = bool();
            phi_1466_ = true;
        }
        let _e1140 = phi_1465_;
        let _e1142 = phi_1466_;
        if _e1142 {
            phi_1470_ = false;
        } else {
            phi_1470_ = _e1140;
        }
        let _e1144 = phi_1470_;
        if !(_e1144) {
            let _e1147 = samples.member[_e79.shift].position;
            let _e1149 = p.member.current.eye;
            let _e1160 = p.member.current.forward;
            phi_1498_ = ((((_e1147.x - _e1149.x) * _e1160.x) + ((_e1147.y - _e1149.y) * _e1160.y)) + ((_e1147.z - _e1149.z) * _e1160.z));
        } else {
            phi_1498_ = 0f;
        }
        let _e1170 = phi_1498_;
        depths.member[_e79.shift] = _e1170;
        phi_1501_ = _e1075.needs_ray;
        phi_1502_ = _e79.shift;
    } else {
        phi_1501_ = false;
        phi_1502_ = 0u;
    }
    let _e1174 = phi_1501_;
    let _e1176 = phi_1502_;
    if (_e60 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1174 {
        let _e1180 = atomicAdd((&shared_[0u]), 1u);
        phi_1513_ = _e1180;
    } else {
        phi_1513_ = 0u;
    }
    let _e1182 = phi_1513_;
    workgroupBarrier();
    if (_e60 == 0u) {
        let _e1186 = atomicLoad((&shared_[0u]));
        let _e1187 = atomicAdd((&list.member[3u]), _e1186);
        atomicStore((&shared_[1u]), _e1187);
    }
    workgroupBarrier();
    if _e1174 {
        let _e1190 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1190) + _e1182)]), _e1176);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_depth_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
