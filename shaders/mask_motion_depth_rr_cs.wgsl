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
    var phi_973_: u32;
    var phi_992_: u32;
    var phi_1000_: u32;
    var phi_1001_: u32;
    var phi_1002_: bool;
    var phi_1003_: u32;
    var phi_1004_: bool;
    var phi_1005_: bool;
    var phi_1006_: u32;
    var phi_1007_: bool;
    var phi_1008_: bool;
    var phi_1012_: bool;
    var phi_1016_: u32;
    var phi_1021_: bool;
    var phi_1043_: u32;
    var phi_1045_: u32;
    var phi_1048_: lt_mask_Neighbourhood;
    var phi_1060_: bool;
    var phi_1061_: bool;
    var phi_1070_: u32;
    var phi_1071_: u32;
    var phi_1131_: vec2<i32>;
    var phi_1151_: vec2<i32>;
    var phi_1178_: u32;
    var phi_1197_: u32;
    var phi_1205_: u32;
    var phi_1231_: bool;
    var phi_1232_: bool;
    var phi_1233_: bool;
    var phi_1234_: bool;
    var phi_1235_: bool;
    var phi_1236_: bool;
    var phi_1237_: bool;
    var phi_1242_: bool;
    var phi_1243_: bool;
    var phi_1244_: bool;
    var phi_1245_: bool;
    var phi_1246_: bool;
    var phi_1247_: bool;
    var phi_1248_: bool;
    var phi_1249_: bool;
    var phi_1250_: bool;
    var phi_1265_: bool;
    var phi_1266_: bool;
    var phi_1273_: bool;
    var phi_1274_: bool;
    var phi_1275_: bool;
    var phi_1276_: bool;
    var phi_1277_: bool;
    var phi_1281_: bool;
    var phi_1282_: bool;
    var phi_1283_: bool;
    var phi_1287_: bool;
    var phi_1288_: bool;
    var phi_1292_: bool;
    var phi_1293_: bool;
    var phi_1311_: bool;
    var phi_1312_: bool;
    var phi_1313_: bool;
    var phi_1046_: u32;
    var phi_1049_: lt_mask_Neighbourhood;
    var phi_1316_: lt_mask_Neighbourhood;
    var phi_1317_: lt_mask_Neighbourhood;
    var phi_1318_: lt_mask_Neighbourhood;
    var phi_1350_: bool;
    var phi_1351_: bool;
    var phi_1373_: bool;
    var phi_1374_: bool;
    var phi_1375_: bool;
    var phi_1379_: bool;
    var phi_1401_: bool;
    var phi_1402_: bool;
    var phi_1415_: bool;
    var phi_1416_: bool;
    var phi_1417_: bool;
    var phi_1424_: u32;
    var phi_1425_: u32;
    var phi_1426_: u32;
    var phi_1427_: u32;
    var phi_1428_: u32;
    var phi_1429_: u32;
    var phi_1430_: u32;
    var phi_1442_: bool;
    var phi_1443_: bool;
    var phi_1444_: bool;
    var phi_1445_: bool;
    var phi_1449_: bool;
    var phi_1455_: bool;
    var phi_1463_: u32;
    var phi_1468_: u32;
    var phi_1477_: u32;
    var phi_1482_: u32;
    var phi_1486_: u32;
    var phi_1487_: u32;
    var phi_1488_: u32;
    var phi_1492_: f32;
    var phi_1494_: mask_Masked;
    var phi_1566_: bool;
    var phi_1567_: bool;
    var phi_1568_: bool;
    var phi_1569_: bool;
    var phi_1573_: bool;
    var phi_1601_: f32;
    var phi_1604_: bool;
    var phi_1605_: u32;
    var phi_1616_: u32;
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
            phi_1494_ = mask_Masked(_e268.unnamed.visibility, 0u, false);
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
            let _e740 = p.member.flags;
            let _e742 = ((_e740 & 2u) != 0u);
            let _e744 = p.member.flags;
            if ((_e744 & 4u) == 0u) {
                phi_1006_ = u32();
                phi_1007_ = true;
                phi_1008_ = false;
            } else {
                if _e732 {
                    if !(_e738.has_moved) {
                        let _e755 = ((((_e59.y * _e110) + _e59.x) * _e106.words) + _e106.light.word);
                        if (_e106.light.shift > 29u) {
                            let _e759 = (_e755 + 1u);
                            if (_e759 < _e65) {
                            } else {
                                return;
                            }
                            let _e763 = last_bits.member[(0u + _e759)];
                            phi_973_ = _e763;
                        } else {
                            phi_973_ = 0u;
                        }
                        let _e765 = phi_973_;
                        if (_e755 < _e65) {
                        } else {
                            return;
                        }
                        let _e771 = last_bits.member[(0u + _e755)];
                        let _e774 = (_e771 >> bitcast<u32>((_e106.light.shift & 31u)));
                        if (_e106.light.shift > 29u) {
                            phi_992_ = (_e774 | (_e765 << bitcast<u32>(((32u - _e106.light.shift) & 31u))));
                        } else {
                            phi_992_ = _e774;
                        }
                        let _e782 = phi_992_;
                        if ((_e782 & 2u) == 0u) {
                            phi_1000_ = (_e782 & 1u);
                        } else {
                            phi_1000_ = (_e782 & 7u);
                        }
                        let _e788 = phi_1000_;
                        phi_1001_ = _e788;
                        phi_1002_ = false;
                    } else {
                        phi_1001_ = u32();
                        phi_1002_ = true;
                    }
                    let _e790 = phi_1001_;
                    let _e792 = phi_1002_;
                    phi_1003_ = _e790;
                    phi_1004_ = false;
                    phi_1005_ = _e792;
                } else {
                    phi_1003_ = u32();
                    phi_1004_ = true;
                    phi_1005_ = false;
                }
                let _e794 = phi_1003_;
                let _e796 = phi_1004_;
                let _e798 = phi_1005_;
                phi_1006_ = _e794;
                phi_1007_ = _e796;
                phi_1008_ = _e798;
            }
            let _e800 = phi_1006_;
            let _e802 = phi_1007_;
            let _e804 = phi_1008_;
            if _e802 {
                phi_1012_ = true;
            } else {
                phi_1012_ = _e804;
            }
            let _e806 = phi_1012_;
            if _e806 {
                phi_1016_ = 0u;
            } else {
                phi_1016_ = _e800;
            }
            let _e808 = phi_1016_;
            let _e809 = lt_mask_Neighbourhood(false, true);
            if _e277 {
                phi_1021_ = _e742;
            } else {
                phi_1021_ = false;
            }
            let _e811 = phi_1021_;
            if _e811 {
                if _e732 {
                    if ((_e808 & 2u) != 0u) {
                        phi_1316_ = _e809;
                    } else {
                        let _e815 = p.member.expansion;
                        if _e738.has_moved {
                            let _e818 = p.member.moving_pattern;
                            phi_1043_ = _e818;
                        } else {
                            let _e820 = p.member.still_pattern;
                            phi_1043_ = _e820;
                        }
                        let _e822 = phi_1043_;
                        phi_1045_ = 0u;
                        phi_1048_ = _e809;
                        loop {
                            let _e824 = phi_1045_;
                            let _e826 = phi_1048_;
                            local_1 = _e826;
                            if (1u <= _e822) {
                                if (_e822 <= 4u) {
                                    phi_1060_ = false;
                                } else {
                                    phi_1060_ = true;
                                }
                                let _e830 = phi_1060_;
                                phi_1061_ = _e830;
                            } else {
                                phi_1061_ = true;
                            }
                            let _e832 = phi_1061_;
                            if _e832 {
                                switch bitcast<i32>(_e822) {
                                    case 5: {
                                        phi_1070_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_1070_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_1070_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_1070_ = 9u;
                                        break;
                                    }
                                }
                                let _e835 = phi_1070_;
                                phi_1071_ = _e835;
                            } else {
                                phi_1071_ = 5u;
                            }
                            let _e837 = phi_1071_;
                            let _e838 = (_e824 < _e837);
                            if _e838 {
                                let _e844 = p.member.frame;
                                let _e848 = p.member.current.size[0u];
                                let _e850 = p.member.current.size[1u];
                                switch bitcast<i32>(_e822) {
                                    case 1: {
                                        let _e860 = lt_mask_pattern_plus(_e824);
                                        phi_1151_ = vec2<i32>(_e860.x, _e860.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e864 = lt_mask_pattern_cross(_e824);
                                        phi_1151_ = vec2<i32>(_e864.x, _e864.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e870 = lt_mask_pattern_plus_or_cross(_e824, ((_e738.pixel.x + _e738.pixel.y) & 1u));
                                        phi_1151_ = vec2<i32>(_e870.x, _e870.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e875 = lt_mask_pattern_plus_or_cross(_e824, (_e844 & 1u));
                                        phi_1151_ = vec2<i32>(_e875.x, _e875.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e844 & 3u)) {
                                            case 0: {
                                                phi_1131_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_1131_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_1131_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_1131_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e886 = phi_1131_;
                                        phi_1151_ = (_e886 + vec2<i32>(bitcast<i32>((_e824 & 1u)), bitcast<i32>(((_e824 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_1151_ = vec2<i32>((bitcast<i32>((_e824 % 5u)) - 2i), (bitcast<i32>(((_e824 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e903 = lt_mask_pattern_diamond(_e824);
                                        phi_1151_ = vec2<i32>(_e903.x, _e903.y);
                                        break;
                                    }
                                    default: {
                                        phi_1151_ = vec2<i32>((bitcast<i32>((_e824 % 3u)) - 1i), (bitcast<i32>(((_e824 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e908 = phi_1151_;
                                let _e911 = lt_mask_pattern_step_clamped(_e738.pixel.x, _e908.x, _e848);
                                let _e912 = lt_mask_pattern_step_clamped(_e738.pixel.y, _e908.y, _e850);
                                let _e919 = ((((_e912 * _e110) + _e911) * _e106.words) + _e106.light.word);
                                if (_e106.light.shift > 29u) {
                                    let _e923 = (_e919 + 1u);
                                    if (_e923 < _e65) {
                                    } else {
                                        return;
                                    }
                                    let _e927 = last_bits.member[(0u + _e923)];
                                    phi_1178_ = _e927;
                                } else {
                                    phi_1178_ = 0u;
                                }
                                let _e929 = phi_1178_;
                                if (_e919 < _e65) {
                                } else {
                                    return;
                                }
                                let _e935 = last_bits.member[(0u + _e919)];
                                let _e938 = (_e935 >> bitcast<u32>((_e106.light.shift & 31u)));
                                if (_e106.light.shift > 29u) {
                                    phi_1197_ = (_e938 | (_e929 << bitcast<u32>(((32u - _e106.light.shift) & 31u))));
                                } else {
                                    phi_1197_ = _e938;
                                }
                                let _e946 = phi_1197_;
                                if ((_e946 & 2u) == 0u) {
                                    phi_1205_ = (_e946 & 1u);
                                } else {
                                    phi_1205_ = (_e946 & 7u);
                                }
                                let _e952 = phi_1205_;
                                if _e826.any_expands {
                                    phi_1293_ = true;
                                } else {
                                    if ((_e952 & 2u) != 0u) {
                                        let _e959 = (((_e952 & 4u) != 0u) != _e273);
                                        switch bitcast<i32>(_e815) {
                                            case 1: {
                                                phi_1233_ = bool();
                                                phi_1234_ = false;
                                                phi_1235_ = true;
                                                phi_1236_ = false;
                                                phi_1237_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e959 {
                                                    phi_1231_ = (((_e952 & 4u) != 0u) != ((_e952 & 1u) != 0u));
                                                    phi_1232_ = false;
                                                } else {
                                                    phi_1231_ = bool();
                                                    phi_1232_ = true;
                                                }
                                                let _e967 = phi_1231_;
                                                let _e969 = phi_1232_;
                                                phi_1233_ = _e967;
                                                phi_1234_ = false;
                                                phi_1235_ = false;
                                                phi_1236_ = _e969;
                                                phi_1237_ = _e959;
                                                break;
                                            }
                                            default: {
                                                phi_1233_ = bool();
                                                phi_1234_ = true;
                                                phi_1235_ = false;
                                                phi_1236_ = false;
                                                phi_1237_ = false;
                                                break;
                                            }
                                        }
                                        let _e971 = phi_1233_;
                                        let _e973 = phi_1234_;
                                        let _e975 = phi_1235_;
                                        let _e977 = phi_1236_;
                                        let _e979 = phi_1237_;
                                        phi_1245_ = _e959;
                                        phi_1246_ = _e971;
                                        phi_1247_ = _e973;
                                        phi_1248_ = _e975;
                                        phi_1249_ = _e977;
                                        phi_1250_ = _e979;
                                    } else {
                                        switch bitcast<i32>(_e815) {
                                            case 1: {
                                                phi_1242_ = false;
                                                phi_1243_ = true;
                                                phi_1244_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_1242_ = false;
                                                phi_1243_ = false;
                                                phi_1244_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_1242_ = true;
                                                phi_1243_ = false;
                                                phi_1244_ = false;
                                                break;
                                            }
                                        }
                                        let _e982 = phi_1242_;
                                        let _e984 = phi_1243_;
                                        let _e986 = phi_1244_;
                                        phi_1245_ = false;
                                        phi_1246_ = bool();
                                        phi_1247_ = _e982;
                                        phi_1248_ = _e984;
                                        phi_1249_ = _e986;
                                        phi_1250_ = false;
                                    }
                                    let _e988 = phi_1245_;
                                    let _e990 = phi_1246_;
                                    let _e992 = phi_1247_;
                                    let _e994 = phi_1248_;
                                    let _e996 = phi_1249_;
                                    let _e998 = phi_1250_;
                                    if _e992 {
                                        if ((_e952 & 2u) != 0u) {
                                            if (((_e952 & 4u) != 0u) != _e273) {
                                                phi_1265_ = false;
                                            } else {
                                                phi_1265_ = true;
                                            }
                                            let _e1005 = phi_1265_;
                                            phi_1266_ = _e1005;
                                        } else {
                                            phi_1266_ = true;
                                        }
                                        let _e1007 = phi_1266_;
                                        if _e1007 {
                                            phi_1273_ = (((_e952 & 1u) != 0u) != _e273);
                                        } else {
                                            phi_1273_ = true;
                                        }
                                        let _e1012 = phi_1273_;
                                        phi_1274_ = _e1012;
                                        phi_1275_ = false;
                                        phi_1276_ = false;
                                        phi_1277_ = false;
                                    } else {
                                        phi_1274_ = bool();
                                        phi_1275_ = _e994;
                                        phi_1276_ = _e996;
                                        phi_1277_ = _e998;
                                    }
                                    let _e1014 = phi_1274_;
                                    let _e1016 = phi_1275_;
                                    let _e1018 = phi_1276_;
                                    let _e1020 = phi_1277_;
                                    if _e1016 {
                                        phi_1281_ = _e988;
                                        phi_1282_ = false;
                                        phi_1283_ = false;
                                    } else {
                                        phi_1281_ = _e1014;
                                        phi_1282_ = _e1018;
                                        phi_1283_ = _e1020;
                                    }
                                    let _e1022 = phi_1281_;
                                    let _e1024 = phi_1282_;
                                    let _e1026 = phi_1283_;
                                    if _e1024 {
                                        phi_1287_ = false;
                                        phi_1288_ = true;
                                    } else {
                                        phi_1287_ = _e990;
                                        phi_1288_ = _e1026;
                                    }
                                    let _e1028 = phi_1287_;
                                    let _e1030 = phi_1288_;
                                    if _e1030 {
                                        phi_1292_ = _e1028;
                                    } else {
                                        phi_1292_ = _e1022;
                                    }
                                    let _e1032 = phi_1292_;
                                    phi_1293_ = _e1032;
                                }
                                let _e1034 = phi_1293_;
                                if _e826.all_remove {
                                    if (((_e952 & 1u) != 0u) == _e273) {
                                        if ((_e952 & 2u) != 0u) {
                                            phi_1311_ = (((_e952 & 4u) != 0u) == _e273);
                                        } else {
                                            phi_1311_ = true;
                                        }
                                        let _e1044 = phi_1311_;
                                        phi_1312_ = _e1044;
                                    } else {
                                        phi_1312_ = false;
                                    }
                                    let _e1046 = phi_1312_;
                                    phi_1313_ = _e1046;
                                } else {
                                    phi_1313_ = false;
                                }
                                let _e1048 = phi_1313_;
                                phi_1046_ = (_e824 + 1u);
                                phi_1049_ = lt_mask_Neighbourhood(_e1034, _e1048);
                            } else {
                                phi_1046_ = u32();
                                phi_1049_ = lt_mask_Neighbourhood();
                            }
                            let _e1052 = phi_1046_;
                            let _e1054 = phi_1049_;
                            continue;
                            continuing {
                                phi_1045_ = _e1052;
                                phi_1048_ = _e1054;
                                break if !(_e838);
                            }
                        }
                        let _e1413 = local_1;
                        phi_1316_ = _e1413;
                    }
                    let _e1057 = phi_1316_;
                    phi_1317_ = _e1057;
                } else {
                    phi_1317_ = _e809;
                }
                let _e1059 = phi_1317_;
                phi_1318_ = _e1059;
            } else {
                phi_1318_ = _e809;
            }
            let _e1061 = phi_1318_;
            let _e1064 = p.member.frame;
            let _e1066 = p.member.refresh;
            if (_e1066 == 0u) {
                phi_1351_ = false;
            } else {
                if (_e1066 == 0u) {
                    return;
                }
                let _e1075 = ((_e59.x + (_e59.y * (((_e1066 * 5u) / 8u) | 1u))) + (_e1064 % _e1066));
                if (_e1066 == 0u) {
                    phi_1350_ = (_e1075 == 0u);
                } else {
                    if (_e1066 == 0u) {
                        return;
                    }
                    phi_1350_ = ((_e1075 % _e1066) == 0u);
                }
                let _e1082 = phi_1350_;
                phi_1351_ = _e1082;
            }
            let _e1084 = phi_1351_;
            if _e732 {
                if _e1084 {
                    phi_1373_ = bool();
                } else {
                    phi_1373_ = ((_e808 & 2u) != 0u);
                }
                let _e1090 = phi_1373_;
                phi_1374_ = _e1090;
                phi_1375_ = _e1084;
            } else {
                phi_1374_ = bool();
                phi_1375_ = true;
            }
            let _e1092 = phi_1374_;
            let _e1094 = phi_1375_;
            if _e1094 {
                phi_1379_ = false;
            } else {
                phi_1379_ = _e1092;
            }
            let _e1096 = phi_1379_;
            if _e1096 {
                phi_1430_ = 7u;
            } else {
                if (_e115 != 0.5f) {
                    if _e732 {
                        if _e1084 {
                            phi_1427_ = 6u;
                        } else {
                            if _e277 {
                                phi_1402_ = true;
                            } else {
                                if _e1061.any_expands {
                                    phi_1401_ = false;
                                } else {
                                    phi_1401_ = true;
                                }
                                let _e1098 = phi_1401_;
                                phi_1402_ = _e1098;
                            }
                            let _e1100 = phi_1402_;
                            if _e1100 {
                                if _e277 {
                                    if _e742 {
                                        if _e1061.all_remove {
                                            phi_1415_ = false;
                                        } else {
                                            phi_1415_ = true;
                                        }
                                        let _e1102 = phi_1415_;
                                        phi_1416_ = _e1102;
                                    } else {
                                        phi_1416_ = true;
                                    }
                                    let _e1104 = phi_1416_;
                                    phi_1417_ = _e1104;
                                } else {
                                    phi_1417_ = true;
                                }
                                let _e1106 = phi_1417_;
                                if _e1106 {
                                    if _e277 {
                                        phi_1424_ = 1u;
                                    } else {
                                        phi_1424_ = 0u;
                                    }
                                    let _e1108 = phi_1424_;
                                    phi_1425_ = _e1108;
                                } else {
                                    phi_1425_ = 5u;
                                }
                                let _e1110 = phi_1425_;
                                phi_1426_ = _e1110;
                            } else {
                                phi_1426_ = 4u;
                            }
                            let _e1112 = phi_1426_;
                            phi_1427_ = _e1112;
                        }
                        let _e1114 = phi_1427_;
                        phi_1428_ = _e1114;
                    } else {
                        phi_1428_ = 3u;
                    }
                    let _e1116 = phi_1428_;
                    phi_1429_ = _e1116;
                } else {
                    phi_1429_ = 2u;
                }
                let _e1118 = phi_1429_;
                phi_1430_ = _e1118;
            }
            let _e1120 = phi_1430_;
            if !((_e1120 == 0u)) {
                if !((_e1120 == 5u)) {
                    phi_1442_ = !(_e1096);
                    phi_1443_ = false;
                } else {
                    phi_1442_ = bool();
                    phi_1443_ = true;
                }
                let _e1127 = phi_1442_;
                let _e1129 = phi_1443_;
                phi_1444_ = _e1127;
                phi_1445_ = _e1129;
            } else {
                phi_1444_ = bool();
                phi_1445_ = true;
            }
            let _e1131 = phi_1444_;
            let _e1133 = phi_1445_;
            if _e1133 {
                phi_1449_ = false;
            } else {
                phi_1449_ = _e1131;
            }
            let _e1135 = phi_1449_;
            if _e1096 {
                phi_1455_ = ((_e808 & 4u) != 0u);
            } else {
                phi_1455_ = _e273;
            }
            let _e1139 = phi_1455_;
            if _e1135 {
                if _e273 {
                    phi_1463_ = (2u | 1u);
                } else {
                    phi_1463_ = 2u;
                }
                let _e1142 = phi_1463_;
                if false {
                    phi_1468_ = (_e1142 | 4u);
                } else {
                    phi_1468_ = _e1142;
                }
                let _e1145 = phi_1468_;
                phi_1488_ = _e1145;
            } else {
                if (_e1120 == 7u) {
                    if _e273 {
                        phi_1477_ = (2u | 1u);
                    } else {
                        phi_1477_ = 2u;
                    }
                    let _e1149 = phi_1477_;
                    if _e1139 {
                        phi_1482_ = (_e1149 | 4u);
                    } else {
                        phi_1482_ = _e1149;
                    }
                    let _e1152 = phi_1482_;
                    phi_1487_ = _e1152;
                } else {
                    if _e273 {
                        phi_1486_ = 1u;
                    } else {
                        phi_1486_ = 0u;
                    }
                    let _e1154 = phi_1486_;
                    phi_1487_ = _e1154;
                }
                let _e1156 = phi_1487_;
                phi_1488_ = _e1156;
            }
            let _e1158 = phi_1488_;
            if _e1139 {
                phi_1492_ = 0f;
            } else {
                phi_1492_ = 1f;
            }
            let _e1160 = phi_1492_;
            phi_1494_ = mask_Masked(_e1160, _e1158, _e1135);
        }
        let _e1163 = phi_1494_;
        visibility.member[_e79.shift] = _e1163.visibility;
        let _e1168 = p.member.light.number;
        let _e1169 = (_e1168 * 3u);
        let _e1171 = (_e1169 % 32u);
        let _e1173 = p.member.light.mask_words;
        let _e1175 = ((_e79.shift * _e1173) + (_e1169 / 32u));
        let _e1177 = bits.member[_e1175];
        bits.member[_e1175] = ((_e1177 & ~((7u << bitcast<u32>((_e1171 & 31u))))) | (_e1163.bits << bitcast<u32>((_e1171 & 31u))));
        if (_e1171 > 29u) {
            let _e1192 = bits.member[(_e1175 + 1u)];
            let _e1194 = (32u - _e1171);
            bits.member[(_e1175 + 1u)] = ((_e1192 & ~((7u >> bitcast<u32>((_e1194 & 31u))))) | (_e1163.bits >> bitcast<u32>((_e1194 & 31u))));
        }
        let _e1209 = samples.member[_e79.shift].normal[0u];
        let _e1211 = global[0u];
        if (_e1209 == _e1211) {
            let _e1214 = samples.member[_e79.shift].normal[1u];
            let _e1216 = global[1u];
            if (_e1214 == _e1216) {
                let _e1219 = samples.member[_e79.shift].normal[2u];
                let _e1221 = global[2u];
                phi_1566_ = (_e1219 == _e1221);
                phi_1567_ = false;
            } else {
                phi_1566_ = bool();
                phi_1567_ = true;
            }
            let _e1224 = phi_1566_;
            let _e1226 = phi_1567_;
            phi_1568_ = _e1224;
            phi_1569_ = _e1226;
        } else {
            phi_1568_ = bool();
            phi_1569_ = true;
        }
        let _e1228 = phi_1568_;
        let _e1230 = phi_1569_;
        if _e1230 {
            phi_1573_ = false;
        } else {
            phi_1573_ = _e1228;
        }
        let _e1232 = phi_1573_;
        if !(_e1232) {
            let _e1235 = samples.member[_e79.shift].position;
            let _e1237 = p.member.current.eye;
            let _e1248 = p.member.current.forward;
            phi_1601_ = ((((_e1235.x - _e1237.x) * _e1248.x) + ((_e1235.y - _e1237.y) * _e1248.y)) + ((_e1235.z - _e1237.z) * _e1248.z));
        } else {
            phi_1601_ = 0f;
        }
        let _e1258 = phi_1601_;
        depths.member[_e79.shift] = _e1258;
        phi_1604_ = _e1163.needs_ray;
        phi_1605_ = _e79.shift;
    } else {
        phi_1604_ = false;
        phi_1605_ = 0u;
    }
    let _e1262 = phi_1604_;
    let _e1264 = phi_1605_;
    if (_e60 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1262 {
        let _e1268 = atomicAdd((&shared_[0u]), 1u);
        phi_1616_ = _e1268;
    } else {
        phi_1616_ = 0u;
    }
    let _e1270 = phi_1616_;
    workgroupBarrier();
    if (_e60 == 0u) {
        let _e1274 = atomicLoad((&shared_[0u]));
        let _e1275 = atomicAdd((&list.member[3u]), _e1274);
        atomicStore((&shared_[1u]), _e1275);
    }
    workgroupBarrier();
    if _e1262 {
        let _e1278 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1278) + _e1270)]), _e1264);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_depth_rr_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
