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
    var phi_955_: u32;
    var phi_974_: u32;
    var phi_982_: u32;
    var phi_983_: u32;
    var phi_984_: bool;
    var phi_985_: u32;
    var phi_986_: bool;
    var phi_987_: bool;
    var phi_988_: u32;
    var phi_989_: bool;
    var phi_990_: bool;
    var phi_994_: bool;
    var phi_998_: u32;
    var phi_1003_: bool;
    var phi_1025_: u32;
    var phi_1027_: u32;
    var phi_1030_: lt_mask_Neighbourhood;
    var phi_1042_: bool;
    var phi_1043_: bool;
    var phi_1052_: u32;
    var phi_1053_: u32;
    var phi_1113_: vec2<i32>;
    var phi_1133_: vec2<i32>;
    var phi_1160_: u32;
    var phi_1179_: u32;
    var phi_1187_: u32;
    var phi_1213_: bool;
    var phi_1214_: bool;
    var phi_1215_: bool;
    var phi_1216_: bool;
    var phi_1217_: bool;
    var phi_1218_: bool;
    var phi_1219_: bool;
    var phi_1224_: bool;
    var phi_1225_: bool;
    var phi_1226_: bool;
    var phi_1227_: bool;
    var phi_1228_: bool;
    var phi_1229_: bool;
    var phi_1230_: bool;
    var phi_1231_: bool;
    var phi_1232_: bool;
    var phi_1247_: bool;
    var phi_1248_: bool;
    var phi_1255_: bool;
    var phi_1256_: bool;
    var phi_1257_: bool;
    var phi_1258_: bool;
    var phi_1259_: bool;
    var phi_1263_: bool;
    var phi_1264_: bool;
    var phi_1265_: bool;
    var phi_1269_: bool;
    var phi_1270_: bool;
    var phi_1274_: bool;
    var phi_1275_: bool;
    var phi_1293_: bool;
    var phi_1294_: bool;
    var phi_1295_: bool;
    var phi_1028_: u32;
    var phi_1031_: lt_mask_Neighbourhood;
    var phi_1298_: lt_mask_Neighbourhood;
    var phi_1299_: lt_mask_Neighbourhood;
    var phi_1300_: lt_mask_Neighbourhood;
    var phi_1332_: bool;
    var phi_1333_: bool;
    var phi_1355_: bool;
    var phi_1356_: bool;
    var phi_1357_: bool;
    var phi_1361_: bool;
    var phi_1383_: bool;
    var phi_1384_: bool;
    var phi_1397_: bool;
    var phi_1398_: bool;
    var phi_1399_: bool;
    var phi_1406_: u32;
    var phi_1407_: u32;
    var phi_1408_: u32;
    var phi_1409_: u32;
    var phi_1410_: u32;
    var phi_1411_: u32;
    var phi_1412_: u32;
    var phi_1424_: bool;
    var phi_1425_: bool;
    var phi_1426_: bool;
    var phi_1427_: bool;
    var phi_1431_: bool;
    var phi_1437_: bool;
    var phi_1445_: u32;
    var phi_1450_: u32;
    var phi_1459_: u32;
    var phi_1464_: u32;
    var phi_1468_: u32;
    var phi_1469_: u32;
    var phi_1470_: u32;
    var phi_1474_: f32;
    var phi_1476_: mask_Masked;
    var phi_1548_: bool;
    var phi_1549_: bool;
    var phi_1550_: bool;
    var phi_1551_: bool;
    var phi_1555_: bool;
    var phi_1583_: f32;
    var phi_1586_: bool;
    var phi_1587_: u32;
    var phi_1598_: u32;
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
            phi_1476_ = mask_Masked(_e268.unnamed.visibility, 0u, false);
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
            let _e722 = p.member.flags;
            let _e724 = ((_e722 & 2u) != 0u);
            let _e726 = p.member.flags;
            if ((_e726 & 4u) == 0u) {
                phi_988_ = u32();
                phi_989_ = true;
                phi_990_ = false;
            } else {
                if _e714 {
                    if !(_e720.has_moved) {
                        let _e737 = ((((_e59.y * _e110) + _e59.x) * _e106.words) + _e106.light.word);
                        if (_e106.light.shift > 29u) {
                            let _e741 = (_e737 + 1u);
                            if (_e741 < _e65) {
                            } else {
                                return;
                            }
                            let _e745 = last_bits.member[(0u + _e741)];
                            phi_955_ = _e745;
                        } else {
                            phi_955_ = 0u;
                        }
                        let _e747 = phi_955_;
                        if (_e737 < _e65) {
                        } else {
                            return;
                        }
                        let _e753 = last_bits.member[(0u + _e737)];
                        let _e756 = (_e753 >> bitcast<u32>((_e106.light.shift & 31u)));
                        if (_e106.light.shift > 29u) {
                            phi_974_ = (_e756 | (_e747 << bitcast<u32>(((32u - _e106.light.shift) & 31u))));
                        } else {
                            phi_974_ = _e756;
                        }
                        let _e764 = phi_974_;
                        if ((_e764 & 2u) == 0u) {
                            phi_982_ = (_e764 & 1u);
                        } else {
                            phi_982_ = (_e764 & 7u);
                        }
                        let _e770 = phi_982_;
                        phi_983_ = _e770;
                        phi_984_ = false;
                    } else {
                        phi_983_ = u32();
                        phi_984_ = true;
                    }
                    let _e772 = phi_983_;
                    let _e774 = phi_984_;
                    phi_985_ = _e772;
                    phi_986_ = false;
                    phi_987_ = _e774;
                } else {
                    phi_985_ = u32();
                    phi_986_ = true;
                    phi_987_ = false;
                }
                let _e776 = phi_985_;
                let _e778 = phi_986_;
                let _e780 = phi_987_;
                phi_988_ = _e776;
                phi_989_ = _e778;
                phi_990_ = _e780;
            }
            let _e782 = phi_988_;
            let _e784 = phi_989_;
            let _e786 = phi_990_;
            if _e784 {
                phi_994_ = true;
            } else {
                phi_994_ = _e786;
            }
            let _e788 = phi_994_;
            if _e788 {
                phi_998_ = 0u;
            } else {
                phi_998_ = _e782;
            }
            let _e790 = phi_998_;
            let _e791 = lt_mask_Neighbourhood(false, true);
            if _e277 {
                phi_1003_ = _e724;
            } else {
                phi_1003_ = true;
            }
            let _e793 = phi_1003_;
            if _e793 {
                if _e714 {
                    if ((_e790 & 2u) != 0u) {
                        phi_1298_ = _e791;
                    } else {
                        let _e797 = p.member.expansion;
                        if _e720.has_moved {
                            let _e800 = p.member.moving_pattern;
                            phi_1025_ = _e800;
                        } else {
                            let _e802 = p.member.still_pattern;
                            phi_1025_ = _e802;
                        }
                        let _e804 = phi_1025_;
                        phi_1027_ = 0u;
                        phi_1030_ = _e791;
                        loop {
                            let _e806 = phi_1027_;
                            let _e808 = phi_1030_;
                            local_1 = _e808;
                            if (1u <= _e804) {
                                if (_e804 <= 4u) {
                                    phi_1042_ = false;
                                } else {
                                    phi_1042_ = true;
                                }
                                let _e812 = phi_1042_;
                                phi_1043_ = _e812;
                            } else {
                                phi_1043_ = true;
                            }
                            let _e814 = phi_1043_;
                            if _e814 {
                                switch bitcast<i32>(_e804) {
                                    case 5: {
                                        phi_1052_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_1052_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_1052_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_1052_ = 9u;
                                        break;
                                    }
                                }
                                let _e817 = phi_1052_;
                                phi_1053_ = _e817;
                            } else {
                                phi_1053_ = 5u;
                            }
                            let _e819 = phi_1053_;
                            let _e820 = (_e806 < _e819);
                            if _e820 {
                                let _e826 = p.member.frame;
                                let _e830 = p.member.current.size[0u];
                                let _e832 = p.member.current.size[1u];
                                switch bitcast<i32>(_e804) {
                                    case 1: {
                                        let _e842 = lt_mask_pattern_plus(_e806);
                                        phi_1133_ = vec2<i32>(_e842.x, _e842.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e846 = lt_mask_pattern_cross(_e806);
                                        phi_1133_ = vec2<i32>(_e846.x, _e846.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e852 = lt_mask_pattern_plus_or_cross(_e806, ((_e720.pixel.x + _e720.pixel.y) & 1u));
                                        phi_1133_ = vec2<i32>(_e852.x, _e852.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e857 = lt_mask_pattern_plus_or_cross(_e806, (_e826 & 1u));
                                        phi_1133_ = vec2<i32>(_e857.x, _e857.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e826 & 3u)) {
                                            case 0: {
                                                phi_1113_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_1113_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_1113_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_1113_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e868 = phi_1113_;
                                        phi_1133_ = (_e868 + vec2<i32>(bitcast<i32>((_e806 & 1u)), bitcast<i32>(((_e806 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_1133_ = vec2<i32>((bitcast<i32>((_e806 % 5u)) - 2i), (bitcast<i32>(((_e806 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e885 = lt_mask_pattern_diamond(_e806);
                                        phi_1133_ = vec2<i32>(_e885.x, _e885.y);
                                        break;
                                    }
                                    default: {
                                        phi_1133_ = vec2<i32>((bitcast<i32>((_e806 % 3u)) - 1i), (bitcast<i32>(((_e806 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e890 = phi_1133_;
                                let _e893 = lt_mask_pattern_step_clamped(_e720.pixel.x, _e890.x, _e830);
                                let _e894 = lt_mask_pattern_step_clamped(_e720.pixel.y, _e890.y, _e832);
                                let _e901 = ((((_e894 * _e110) + _e893) * _e106.words) + _e106.light.word);
                                if (_e106.light.shift > 29u) {
                                    let _e905 = (_e901 + 1u);
                                    if (_e905 < _e65) {
                                    } else {
                                        return;
                                    }
                                    let _e909 = last_bits.member[(0u + _e905)];
                                    phi_1160_ = _e909;
                                } else {
                                    phi_1160_ = 0u;
                                }
                                let _e911 = phi_1160_;
                                if (_e901 < _e65) {
                                } else {
                                    return;
                                }
                                let _e917 = last_bits.member[(0u + _e901)];
                                let _e920 = (_e917 >> bitcast<u32>((_e106.light.shift & 31u)));
                                if (_e106.light.shift > 29u) {
                                    phi_1179_ = (_e920 | (_e911 << bitcast<u32>(((32u - _e106.light.shift) & 31u))));
                                } else {
                                    phi_1179_ = _e920;
                                }
                                let _e928 = phi_1179_;
                                if ((_e928 & 2u) == 0u) {
                                    phi_1187_ = (_e928 & 1u);
                                } else {
                                    phi_1187_ = (_e928 & 7u);
                                }
                                let _e934 = phi_1187_;
                                if _e808.any_expands {
                                    phi_1275_ = true;
                                } else {
                                    if ((_e934 & 2u) != 0u) {
                                        let _e941 = (((_e934 & 4u) != 0u) != _e273);
                                        switch bitcast<i32>(_e797) {
                                            case 1: {
                                                phi_1215_ = bool();
                                                phi_1216_ = false;
                                                phi_1217_ = true;
                                                phi_1218_ = false;
                                                phi_1219_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e941 {
                                                    phi_1213_ = (((_e934 & 4u) != 0u) != ((_e934 & 1u) != 0u));
                                                    phi_1214_ = false;
                                                } else {
                                                    phi_1213_ = bool();
                                                    phi_1214_ = true;
                                                }
                                                let _e949 = phi_1213_;
                                                let _e951 = phi_1214_;
                                                phi_1215_ = _e949;
                                                phi_1216_ = false;
                                                phi_1217_ = false;
                                                phi_1218_ = _e951;
                                                phi_1219_ = _e941;
                                                break;
                                            }
                                            default: {
                                                phi_1215_ = bool();
                                                phi_1216_ = true;
                                                phi_1217_ = false;
                                                phi_1218_ = false;
                                                phi_1219_ = false;
                                                break;
                                            }
                                        }
                                        let _e953 = phi_1215_;
                                        let _e955 = phi_1216_;
                                        let _e957 = phi_1217_;
                                        let _e959 = phi_1218_;
                                        let _e961 = phi_1219_;
                                        phi_1227_ = _e941;
                                        phi_1228_ = _e953;
                                        phi_1229_ = _e955;
                                        phi_1230_ = _e957;
                                        phi_1231_ = _e959;
                                        phi_1232_ = _e961;
                                    } else {
                                        switch bitcast<i32>(_e797) {
                                            case 1: {
                                                phi_1224_ = false;
                                                phi_1225_ = true;
                                                phi_1226_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_1224_ = false;
                                                phi_1225_ = false;
                                                phi_1226_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_1224_ = true;
                                                phi_1225_ = false;
                                                phi_1226_ = false;
                                                break;
                                            }
                                        }
                                        let _e964 = phi_1224_;
                                        let _e966 = phi_1225_;
                                        let _e968 = phi_1226_;
                                        phi_1227_ = false;
                                        phi_1228_ = bool();
                                        phi_1229_ = _e964;
                                        phi_1230_ = _e966;
                                        phi_1231_ = _e968;
                                        phi_1232_ = false;
                                    }
                                    let _e970 = phi_1227_;
                                    let _e972 = phi_1228_;
                                    let _e974 = phi_1229_;
                                    let _e976 = phi_1230_;
                                    let _e978 = phi_1231_;
                                    let _e980 = phi_1232_;
                                    if _e974 {
                                        if ((_e934 & 2u) != 0u) {
                                            if (((_e934 & 4u) != 0u) != _e273) {
                                                phi_1247_ = false;
                                            } else {
                                                phi_1247_ = true;
                                            }
                                            let _e987 = phi_1247_;
                                            phi_1248_ = _e987;
                                        } else {
                                            phi_1248_ = true;
                                        }
                                        let _e989 = phi_1248_;
                                        if _e989 {
                                            phi_1255_ = (((_e934 & 1u) != 0u) != _e273);
                                        } else {
                                            phi_1255_ = true;
                                        }
                                        let _e994 = phi_1255_;
                                        phi_1256_ = _e994;
                                        phi_1257_ = false;
                                        phi_1258_ = false;
                                        phi_1259_ = false;
                                    } else {
                                        phi_1256_ = bool();
                                        phi_1257_ = _e976;
                                        phi_1258_ = _e978;
                                        phi_1259_ = _e980;
                                    }
                                    let _e996 = phi_1256_;
                                    let _e998 = phi_1257_;
                                    let _e1000 = phi_1258_;
                                    let _e1002 = phi_1259_;
                                    if _e998 {
                                        phi_1263_ = _e970;
                                        phi_1264_ = false;
                                        phi_1265_ = false;
                                    } else {
                                        phi_1263_ = _e996;
                                        phi_1264_ = _e1000;
                                        phi_1265_ = _e1002;
                                    }
                                    let _e1004 = phi_1263_;
                                    let _e1006 = phi_1264_;
                                    let _e1008 = phi_1265_;
                                    if _e1006 {
                                        phi_1269_ = false;
                                        phi_1270_ = true;
                                    } else {
                                        phi_1269_ = _e972;
                                        phi_1270_ = _e1008;
                                    }
                                    let _e1010 = phi_1269_;
                                    let _e1012 = phi_1270_;
                                    if _e1012 {
                                        phi_1274_ = _e1010;
                                    } else {
                                        phi_1274_ = _e1004;
                                    }
                                    let _e1014 = phi_1274_;
                                    phi_1275_ = _e1014;
                                }
                                let _e1016 = phi_1275_;
                                if _e808.all_remove {
                                    if (((_e934 & 1u) != 0u) == _e273) {
                                        if ((_e934 & 2u) != 0u) {
                                            phi_1293_ = (((_e934 & 4u) != 0u) == _e273);
                                        } else {
                                            phi_1293_ = true;
                                        }
                                        let _e1026 = phi_1293_;
                                        phi_1294_ = _e1026;
                                    } else {
                                        phi_1294_ = false;
                                    }
                                    let _e1028 = phi_1294_;
                                    phi_1295_ = _e1028;
                                } else {
                                    phi_1295_ = false;
                                }
                                let _e1030 = phi_1295_;
                                phi_1028_ = (_e806 + 1u);
                                phi_1031_ = lt_mask_Neighbourhood(_e1016, _e1030);
                            } else {
                                phi_1028_ = u32();
                                phi_1031_ = lt_mask_Neighbourhood();
                            }
                            let _e1034 = phi_1028_;
                            let _e1036 = phi_1031_;
                            continue;
                            continuing {
                                phi_1027_ = _e1034;
                                phi_1030_ = _e1036;
                                break if !(_e820);
                            }
                        }
                        let _e1395 = local_1;
                        phi_1298_ = _e1395;
                    }
                    let _e1039 = phi_1298_;
                    phi_1299_ = _e1039;
                } else {
                    phi_1299_ = _e791;
                }
                let _e1041 = phi_1299_;
                phi_1300_ = _e1041;
            } else {
                phi_1300_ = _e791;
            }
            let _e1043 = phi_1300_;
            let _e1046 = p.member.frame;
            let _e1048 = p.member.refresh;
            if (_e1048 == 0u) {
                phi_1333_ = false;
            } else {
                if (_e1048 == 0u) {
                    return;
                }
                let _e1057 = ((_e59.x + (_e59.y * (((_e1048 * 5u) / 8u) | 1u))) + (_e1046 % _e1048));
                if (_e1048 == 0u) {
                    phi_1332_ = (_e1057 == 0u);
                } else {
                    if (_e1048 == 0u) {
                        return;
                    }
                    phi_1332_ = ((_e1057 % _e1048) == 0u);
                }
                let _e1064 = phi_1332_;
                phi_1333_ = _e1064;
            }
            let _e1066 = phi_1333_;
            if _e714 {
                if _e1066 {
                    phi_1355_ = bool();
                } else {
                    phi_1355_ = ((_e790 & 2u) != 0u);
                }
                let _e1072 = phi_1355_;
                phi_1356_ = _e1072;
                phi_1357_ = _e1066;
            } else {
                phi_1356_ = bool();
                phi_1357_ = true;
            }
            let _e1074 = phi_1356_;
            let _e1076 = phi_1357_;
            if _e1076 {
                phi_1361_ = false;
            } else {
                phi_1361_ = _e1074;
            }
            let _e1078 = phi_1361_;
            if _e1078 {
                phi_1412_ = 7u;
            } else {
                if (_e115 != 0.5f) {
                    if _e714 {
                        if _e1066 {
                            phi_1409_ = 6u;
                        } else {
                            if _e277 {
                                phi_1384_ = true;
                            } else {
                                if _e1043.any_expands {
                                    phi_1383_ = false;
                                } else {
                                    phi_1383_ = true;
                                }
                                let _e1080 = phi_1383_;
                                phi_1384_ = _e1080;
                            }
                            let _e1082 = phi_1384_;
                            if _e1082 {
                                if _e277 {
                                    if _e724 {
                                        if _e1043.all_remove {
                                            phi_1397_ = false;
                                        } else {
                                            phi_1397_ = true;
                                        }
                                        let _e1084 = phi_1397_;
                                        phi_1398_ = _e1084;
                                    } else {
                                        phi_1398_ = true;
                                    }
                                    let _e1086 = phi_1398_;
                                    phi_1399_ = _e1086;
                                } else {
                                    phi_1399_ = true;
                                }
                                let _e1088 = phi_1399_;
                                if _e1088 {
                                    if _e277 {
                                        phi_1406_ = 1u;
                                    } else {
                                        phi_1406_ = 0u;
                                    }
                                    let _e1090 = phi_1406_;
                                    phi_1407_ = _e1090;
                                } else {
                                    phi_1407_ = 5u;
                                }
                                let _e1092 = phi_1407_;
                                phi_1408_ = _e1092;
                            } else {
                                phi_1408_ = 4u;
                            }
                            let _e1094 = phi_1408_;
                            phi_1409_ = _e1094;
                        }
                        let _e1096 = phi_1409_;
                        phi_1410_ = _e1096;
                    } else {
                        phi_1410_ = 3u;
                    }
                    let _e1098 = phi_1410_;
                    phi_1411_ = _e1098;
                } else {
                    phi_1411_ = 2u;
                }
                let _e1100 = phi_1411_;
                phi_1412_ = _e1100;
            }
            let _e1102 = phi_1412_;
            if !((_e1102 == 0u)) {
                if !((_e1102 == 5u)) {
                    phi_1424_ = !(_e1078);
                    phi_1425_ = false;
                } else {
                    phi_1424_ = bool();
                    phi_1425_ = true;
                }
                let _e1109 = phi_1424_;
                let _e1111 = phi_1425_;
                phi_1426_ = _e1109;
                phi_1427_ = _e1111;
            } else {
                phi_1426_ = bool();
                phi_1427_ = true;
            }
            let _e1113 = phi_1426_;
            let _e1115 = phi_1427_;
            if _e1115 {
                phi_1431_ = false;
            } else {
                phi_1431_ = _e1113;
            }
            let _e1117 = phi_1431_;
            if _e1078 {
                phi_1437_ = ((_e790 & 4u) != 0u);
            } else {
                phi_1437_ = _e273;
            }
            let _e1121 = phi_1437_;
            if _e1117 {
                if _e273 {
                    phi_1445_ = (2u | 1u);
                } else {
                    phi_1445_ = 2u;
                }
                let _e1124 = phi_1445_;
                if false {
                    phi_1450_ = (_e1124 | 4u);
                } else {
                    phi_1450_ = _e1124;
                }
                let _e1127 = phi_1450_;
                phi_1470_ = _e1127;
            } else {
                if (_e1102 == 7u) {
                    if _e273 {
                        phi_1459_ = (2u | 1u);
                    } else {
                        phi_1459_ = 2u;
                    }
                    let _e1131 = phi_1459_;
                    if _e1121 {
                        phi_1464_ = (_e1131 | 4u);
                    } else {
                        phi_1464_ = _e1131;
                    }
                    let _e1134 = phi_1464_;
                    phi_1469_ = _e1134;
                } else {
                    if _e273 {
                        phi_1468_ = 1u;
                    } else {
                        phi_1468_ = 0u;
                    }
                    let _e1136 = phi_1468_;
                    phi_1469_ = _e1136;
                }
                let _e1138 = phi_1469_;
                phi_1470_ = _e1138;
            }
            let _e1140 = phi_1470_;
            if _e1121 {
                phi_1474_ = 0f;
            } else {
                phi_1474_ = 1f;
            }
            let _e1142 = phi_1474_;
            phi_1476_ = mask_Masked(_e1142, _e1140, _e1117);
        }
        let _e1145 = phi_1476_;
        visibility.member[_e79.shift] = _e1145.visibility;
        let _e1150 = p.member.light.number;
        let _e1151 = (_e1150 * 3u);
        let _e1153 = (_e1151 % 32u);
        let _e1155 = p.member.light.mask_words;
        let _e1157 = ((_e79.shift * _e1155) + (_e1151 / 32u));
        let _e1159 = bits.member[_e1157];
        bits.member[_e1157] = ((_e1159 & ~((7u << bitcast<u32>((_e1153 & 31u))))) | (_e1145.bits << bitcast<u32>((_e1153 & 31u))));
        if (_e1153 > 29u) {
            let _e1174 = bits.member[(_e1157 + 1u)];
            let _e1176 = (32u - _e1153);
            bits.member[(_e1157 + 1u)] = ((_e1174 & ~((7u >> bitcast<u32>((_e1176 & 31u))))) | (_e1145.bits >> bitcast<u32>((_e1176 & 31u))));
        }
        let _e1191 = samples.member[_e79.shift].normal[0u];
        let _e1193 = global[0u];
        if (_e1191 == _e1193) {
            let _e1196 = samples.member[_e79.shift].normal[1u];
            let _e1198 = global[1u];
            if (_e1196 == _e1198) {
                let _e1201 = samples.member[_e79.shift].normal[2u];
                let _e1203 = global[2u];
                phi_1548_ = (_e1201 == _e1203);
                phi_1549_ = false;
            } else {
                phi_1548_ = bool();
                phi_1549_ = true;
            }
            let _e1206 = phi_1548_;
            let _e1208 = phi_1549_;
            phi_1550_ = _e1206;
            phi_1551_ = _e1208;
        } else {
            phi_1550_ = bool();
            phi_1551_ = true;
        }
        let _e1210 = phi_1550_;
        let _e1212 = phi_1551_;
        if _e1212 {
            phi_1555_ = false;
        } else {
            phi_1555_ = _e1210;
        }
        let _e1214 = phi_1555_;
        if !(_e1214) {
            let _e1217 = samples.member[_e79.shift].position;
            let _e1219 = p.member.current.eye;
            let _e1230 = p.member.current.forward;
            phi_1583_ = ((((_e1217.x - _e1219.x) * _e1230.x) + ((_e1217.y - _e1219.y) * _e1230.y)) + ((_e1217.z - _e1219.z) * _e1230.z));
        } else {
            phi_1583_ = 0f;
        }
        let _e1240 = phi_1583_;
        depths.member[_e79.shift] = _e1240;
        phi_1586_ = _e1145.needs_ray;
        phi_1587_ = _e79.shift;
    } else {
        phi_1586_ = false;
        phi_1587_ = 0u;
    }
    let _e1244 = phi_1586_;
    let _e1246 = phi_1587_;
    if (_e60 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1244 {
        let _e1250 = atomicAdd((&shared_[0u]), 1u);
        phi_1598_ = _e1250;
    } else {
        phi_1598_ = 0u;
    }
    let _e1252 = phi_1598_;
    workgroupBarrier();
    if (_e60 == 0u) {
        let _e1256 = atomicLoad((&shared_[0u]));
        let _e1257 = atomicAdd((&list.member[3u]), _e1256);
        atomicStore((&shared_[1u]), _e1257);
    }
    workgroupBarrier();
    if _e1244 {
        let _e1260 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1260) + _e1252)]), _e1246);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_depth_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
