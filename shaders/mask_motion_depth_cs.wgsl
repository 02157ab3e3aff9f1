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
    var phi_944_: bool;
    var phi_955_: bool;
    var phi_956_: bool;
    var phi_957_: bool;
    var phi_958_: bool;
    var phi_959_: bool;
    var phi_960_: bool;
    var phi_964_: bool;
    var phi_969_: bool;
    var phi_984_: u32;
    var phi_986_: u32;
    var phi_989_: lt_mask_Neighbourhood;
    var phi_1001_: bool;
    var phi_1002_: bool;
    var phi_1011_: u32;
    var phi_1012_: u32;
    var phi_1072_: vec2<i32>;
    var phi_1092_: vec2<i32>;
    var phi_1119_: u32;
    var phi_1138_: u32;
    var phi_1146_: u32;
    var phi_1163_: bool;
    var phi_1164_: bool;
    var phi_1171_: bool;
    var phi_1172_: bool;
    var phi_1190_: bool;
    var phi_1191_: bool;
    var phi_1192_: bool;
    var phi_987_: u32;
    var phi_990_: lt_mask_Neighbourhood;
    var phi_1195_: lt_mask_Neighbourhood;
    var phi_1196_: lt_mask_Neighbourhood;
    var phi_1228_: bool;
    var phi_1229_: bool;
    var phi_1258_: bool;
    var phi_1259_: bool;
    var phi_1272_: bool;
    var phi_1273_: bool;
    var phi_1274_: bool;
    var phi_1281_: u32;
    var phi_1282_: u32;
    var phi_1283_: u32;
    var phi_1284_: u32;
    var phi_1285_: u32;
    var phi_1286_: u32;
    var phi_1294_: bool;
    var phi_1302_: u32;
    var phi_1307_: u32;
    var phi_1311_: u32;
    var phi_1312_: u32;
    var phi_1316_: f32;
    var phi_1318_: mask_Masked;
    var phi_1390_: bool;
    var phi_1391_: bool;
    var phi_1392_: bool;
    var phi_1393_: bool;
    var phi_1397_: bool;
    var phi_1425_: f32;
    var phi_1428_: bool;
    var phi_1429_: u32;
    var phi_1440_: u32;
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
            phi_1318_ = mask_Masked(_e268.unnamed.visibility, 0u, false);
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
            if _e738.has_moved {
                let _e745 = p.member.flags;
                phi_944_ = ((_e745 & 4u) == 0u);
            } else {
                phi_944_ = false;
            }
            let _e749 = phi_944_;
            if ((_e740 & 2u) != 0u) {
                if false {
                    phi_957_ = bool();
                    phi_958_ = true;
                } else {
                    if true {
                        phi_955_ = !(_e749);
                        phi_956_ = false;
                    } else {
                        phi_955_ = bool();
                        phi_956_ = true;
                    }
                    let _e752 = phi_955_;
                    let _e754 = phi_956_;
                    phi_957_ = _e752;
                    phi_958_ = _e754;
                }
                let _e756 = phi_957_;
                let _e758 = phi_958_;
                phi_959_ = _e756;
                phi_960_ = _e758;
            } else {
                phi_959_ = bool();
                phi_960_ = true;
            }
            let _e760 = phi_959_;
            let _e762 = phi_960_;
            if _e762 {
                phi_964_ = false;
            } else {
                phi_964_ = _e760;
            }
            let _e764 = phi_964_;
            let _e765 = lt_mask_Neighbourhood(false, true);
            if _e277 {
                phi_969_ = _e764;
            } else {
                phi_969_ = true;
            }
            let _e767 = phi_969_;
            if _e767 {
                if _e732 {
                    if _e738.has_moved {
                        let _e770 = p.member.moving_pattern;
                        phi_984_ = _e770;
                    } else {
                        let _e772 = p.member.still_pattern;
                        phi_984_ = _e772;
                    }
                    let _e774 = phi_984_;
                    phi_986_ = 0u;
                    phi_989_ = _e765;
                    loop {
                        let _e776 = phi_986_;
                        let _e778 = phi_989_;
                        local_1 = _e778;
                        if (1u <= _e774) {
                            if (_e774 <= 4u) {
                                phi_1001_ = false;
                            } else {
                                phi_1001_ = true;
                            }
                            let _e782 = phi_1001_;
                            phi_1002_ = _e782;
                        } else {
                            phi_1002_ = true;
                        }
                        let _e784 = phi_1002_;
                        if _e784 {
                            switch bitcast<i32>(_e774) {
                                case 5: {
                                    phi_1011_ = 4u;
                                    break;
                                }
                                case 6: {
                                    phi_1011_ = 25u;
                                    break;
                                }
                                case 7: {
                                    phi_1011_ = 13u;
                                    break;
                                }
                                default: {
                                    phi_1011_ = 9u;
                                    break;
                                }
                            }
                            let _e787 = phi_1011_;
                            phi_1012_ = _e787;
                        } else {
                            phi_1012_ = 5u;
                        }
                        let _e789 = phi_1012_;
                        let _e790 = (_e776 < _e789);
                        if _e790 {
                            let _e796 = p.member.frame;
                            let _e800 = p.member.current.size[0u];
                            let _e802 = p.member.current.size[1u];
                            switch bitcast<i32>(_e774) {
                                case 1: {
                                    let _e812 = lt_mask_pattern_plus(_e776);
                                    phi_1092_ = vec2<i32>(_e812.x, _e812.y);
                                    break;
                                }
                                case 2: {
                                    let _e816 = lt_mask_pattern_cross(_e776);
                                    phi_1092_ = vec2<i32>(_e816.x, _e816.y);
                                    break;
                                }
                                case 3: {
                                    let _e822 = lt_mask_pattern_plus_or_cross(_e776, ((_e738.pixel.x + _e738.pixel.y) & 1u));
                                    phi_1092_ = vec2<i32>(_e822.x, _e822.y);
                                    break;
                                }
                                case 4: {
                                    let _e827 = lt_mask_pattern_plus_or_cross(_e776, (_e796 & 1u));
                                    phi_1092_ = vec2<i32>(_e827.x, _e827.y);
                                    break;
                                }
                                case 5: {
                                    switch bitcast<i32>((_e796 & 3u)) {
                                        case 0: {
                                            phi_1072_ = vec2(-1i);
                                            break;
                                        }
                                        case 1: {
                                            phi_1072_ = vec2(0i);
                                            break;
                                        }
                                        case 2: {
                                            phi_1072_ = vec2<i32>(0i, -1i);
                                            break;
                                        }
                                        default: {
                                            phi_1072_ = vec2<i32>(-1i, 0i);
                                            break;
                                        }
                                    }
                                    let _e838 = phi_1072_;
                                    phi_1092_ = (_e838 + vec2<i32>(bitcast<i32>((_e776 & 1u)), bitcast<i32>(((_e776 >> bitcast<u32>(1i)) & 1u))));
                                    break;
                                }
                                case 6: {
                                    phi_1092_ = vec2<i32>((bitcast<i32>((_e776 % 5u)) - 2i), (bitcast<i32>(((_e776 / 5u) % 5u)) - 2i));
                                    break;
                                }
                                case 7: {
                                    let _e855 = lt_mask_pattern_diamond(_e776);
                                    phi_1092_ = vec2<i32>(_e855.x, _e855.y);
                                    break;
                                }
                                default: {
                                    phi_1092_ = vec2<i32>((bitcast<i32>((_e776 % 3u)) - 1i), (bitcast<i32>(((_e776 / 3u) % 3u)) - 1i));
                                    break;
                                }
                            }
                            let _e860 = phi_1092_;
                            let _e863 = lt_mask_pattern_step_clamped(_e738.pixel.x, _e860.x, _e800);
                            let _e864 = lt_mask_pattern_step_clamped(_e738.pixel.y, _e860.y, _e802);
                            let _e871 = ((((_e864 * _e110) + _e863) * _e106.words) + _e106.light.word);
                            if (_e106.light.shift > 29u) {
                                let _e875 = (_e871 + 1u);
                                if (_e875 < _e65) {
                                } else {
                                    return;
                                }
                                let _e879 = last_bits.member[(0u + _e875)];
                                phi_1119_ = _e879;
                            } else {
                                phi_1119_ = 0u;
                            }
                            let _e881 = phi_1119_;
                            if (_e871 < _e65) {
                            } else {
                                return;
                            }
                            let _e887 = last_bits.member[(0u + _e871)];
                            let _e890 = (_e887 >> bitcast<u32>((_e106.light.shift & 31u)));
                            if (_e106.light.shift > 29u) {
                                phi_1138_ = (_e890 | (_e881 << bitcast<u32>(((32u - _e106.light.shift) & 31u))));
                            } else {
                                phi_1138_ = _e890;
                            }
                            let _e898 = phi_1138_;
                            if ((_e898 & 2u) == 0u) {
                                phi_1146_ = (_e898 & 1u);
                            } else {
                                phi_1146_ = (_e898 & 7u);
                            }
                            let _e904 = phi_1146_;
                            if _e778.any_expands {
                                phi_1172_ = true;
                            } else {
                                if ((_e904 & 2u) != 0u) {
                                    if (((_e904 & 4u) != 0u) != _e273) {
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
                                    phi_1171_ = (((_e904 & 1u) != 0u) != _e273);
                                } else {
                                    phi_1171_ = true;
                                }
                                let _e920 = phi_1171_;
                                phi_1172_ = _e920;
                            }
                            let _e922 = phi_1172_;
                            if _e778.all_remove {
                                if (((_e904 & 1u) != 0u) == _e273) {
                                    if ((_e904 & 2u) != 0u) {
                                        phi_1190_ = (((_e904 & 4u) != 0u) == _e273);
                                    } else {
                                        phi_1190_ = true;
                                    }
                                    let _e932 = phi_1190_;
                                    phi_1191_ = _e932;
                                } else {
                                    phi_1191_ = false;
                                }
                                let _e934 = phi_1191_;
                                phi_1192_ = _e934;
                            } else {
                                phi_1192_ = false;
                            }
                            let _e936 = phi_1192_;
                            phi_987_ = (_e776 + 1u);
                            phi_990_ = lt_mask_Neighbourhood(_e922, _e936);
                        } else {
                            phi_987_ = u32();
                            phi_990_ = lt_mask_Neighbourhood();
                        }
                        let _e940 = phi_987_;
                        let _e942 = phi_990_;
                        continue;
                        continuing {
                            phi_986_ = _e940;
                            phi_989_ = _e942;
                            break if !(_e790);
                        }
                    }
                    let _e1234 = local_1;
                    phi_1195_ = _e1234;
                } else {
                    phi_1195_ = _e765;
                }
                let _e945 = phi_1195_;
                phi_1196_ = _e945;
            } else {
                phi_1196_ = _e765;
            }
            let _e947 = phi_1196_;
            let _e950 = p.member.frame;
            let _e952 = p.member.refresh;
            if (_e952 == 0u) {
                phi_1229_ = false;
            } else {
                if (_e952 == 0u) {
                    return;
                }
                let _e961 = ((_e59.x + (_e59.y * (((_e952 * 5u) / 8u) | 1u))) + (_e950 % _e952));
                if (_e952 == 0u) {
                    phi_1228_ = (_e961 == 0u);
                } else {
                    if (_e952 == 0u) {
                        return;
                    }
                    phi_1228_ = ((_e961 % _e952) == 0u);
                }
                let _e968 = phi_1228_;
                phi_1229_ = _e968;
            }
            let _e970 = phi_1229_;
            if (_e115 != 0.5f) {
                if _e732 {
                    if _e970 {
                        phi_1284_ = 6u;
                    } else {
                        if _e277 {
                            phi_1259_ = true;
                        } else {
                            if _e947.any_expands {
                                phi_1258_ = false;
                            } else {
                                phi_1258_ = true;
                            }
                            let _e974 = phi_1258_;
                            phi_1259_ = _e974;
                        }
                        let _e976 = phi_1259_;
                        if _e976 {
                            if _e277 {
                                if _e764 {
                                    if _e947.all_remove {
                                        phi_1272_ = false;
                                    } else {
                                        phi_1272_ = true;
                                    }
                                    let _e978 = phi_1272_;
                                    phi_1273_ = _e978;
                                } else {
                                    phi_1273_ = true;
                                }
                                let _e980 = phi_1273_;
                                phi_1274_ = _e980;
                            } else {
                                phi_1274_ = true;
                            }
                            let _e982 = phi_1274_;
                            if _e982 {
                                if _e277 {
                                    phi_1281_ = 1u;
                                } else {
                                    phi_1281_ = 0u;
                                }
                                let _e984 = phi_1281_;
                                phi_1282_ = _e984;
                            } else {
                                phi_1282_ = 5u;
                            }
                            let _e986 = phi_1282_;
                            phi_1283_ = _e986;
                        } else {
                            phi_1283_ = 4u;
                        }
                        let _e988 = phi_1283_;
                        phi_1284_ = _e988;
                    }
                    let _e990 = phi_1284_;
                    phi_1285_ = _e990;
                } else {
                    phi_1285_ = 3u;
                }
                let _e992 = phi_1285_;
                phi_1286_ = _e992;
            } else {
                phi_1286_ = 2u;
            }
            let _e994 = phi_1286_;
            if !((_e994 == 0u)) {
                phi_1294_ = !((_e994 == 5u));
            } else {
                phi_1294_ = false;
            }
            let _e1000 = phi_1294_;
            if _e1000 {
                if _e273 {
                    phi_1302_ = (2u | 1u);
                } else {
                    phi_1302_ = 2u;
                }
                let _e1003 = phi_1302_;
                if false {
                    phi_1307_ = (_e1003 | 4u);
                } else {
                    phi_1307_ = _e1003;
                }
                let _e1006 = phi_1307_;
                phi_1312_ = _e1006;
            } else {
                if _e273 {
                    phi_1311_ = 1u;
                } else {
                    phi_1311_ = 0u;
                }
                let _e1008 = phi_1311_;
                phi_1312_ = _e1008;
            }
            let _e1010 = phi_1312_;
            if _e273 {
                phi_1316_ = 0f;
            } else {
                phi_1316_ = 1f;
            }
            let _e1012 = phi_1316_;
            phi_1318_ = mask_Masked(_e1012, _e1010, _e1000);
        }
        let _e1015 = phi_1318_;
        visibility.member[_e79.shift] = _e1015.visibility;
        let _e1020 = p.member.light.number;
        let _e1021 = (_e1020 * 3u);
        let _e1023 = (_e1021 % 32u);
        let _e1025 = p.member.light.mask_words;
        let _e1027 = ((_e79.shift * _e1025) + (_e1021 / 32u));
        let _e1029 = bits.member[_e1027];
        bits.member[_e1027] = ((_e1029 & ~((7u << bitcast<u32>((_e1023 & 31u))))) | (_e1015.bits << bitcast<u32>((_e1023 & 31u))));
        if (_e1023 > 29u) {
            let _e1044 = bits.member[(_e1027 + 1u)];
            let _e1046 = (32u - _e1023);
            bits.member[(_e1027 + 1u)] = ((_e1044 & ~((7u >> bitcast<u32>((_e1046 & 31u))))) | (_e1015.bits >> bitcast<u32>((_e1046 & 31u))));
        }
        let _e1061 = samples.member[_e79.shift].normal[0u];
        let _e1063 = global[0u];
        if (_e1061 == _e1063) {
            let _e1066 = samples.member[_e79.shift].normal[1u];
            let _e1068 = global[1u];
            if (_e1066 == _e1068) {
                let _e1071 = samples.member[_e79.shift].normal[2u];
                let _e1073 = global[2u];
                phi_1390_ = (_e1071 == _e1073);
                phi_1391_ = false;
            } else {
                phi_1390_ = bool();
                phi_1391_ = true;
            }
            let _e1076 = phi_1390_;
            let _e1078 = phi_1391_;
            phi_1392_ = _e1076;
            phi_1393_ = _e1078;
        } else {
            phi_1392_ = bool();
            phi_1393_ = true;
        }
        let _e1080 = phi_1392_;
        let _e1082 = phi_1393_;
        if _e1082 {
            phi_1397_ = false;
        } else {
            phi_1397_ = _e1080;
        }
        let _e1084 = phi_1397_;
        if !(_e1084) {
            let _e1087 = samples.member[_e79.shift].position;
            let _e1089 = p.member.current.eye;
            let _e1100 = p.member.current.forward;
            phi_1425_ = ((((_e1087.x - _e1089.x) * _e1100.x) + ((_e1087.y - _e1089.y) * _e1100.y)) + ((_e1087.z - _e1089.z) * _e1100.z));
        } else {
            phi_1425_ = 0f;
        }
        let _e1110 = phi_1425_;
        depths.member[_e79.shift] = _e1110;
        phi_1428_ = _e1015.needs_ray;
        phi_1429_ = _e79.shift;
    } else {
        phi_1428_ = false;
        phi_1429_ = 0u;
    }
    let _e1114 = phi_1428_;
    let _e1116 = phi_1429_;
    if (_e60 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1114 {
        let _e1120 = atomicAdd((&shared_[0u]), 1u);
        phi_1440_ = _e1120;
    } else {
        phi_1440_ = 0u;
    }
    let _e1122 = phi_1440_;
    workgroupBarrier();
    if (_e60 == 0u) {
        let _e1126 = atomicLoad((&shared_[0u]));
        let _e1127 = atomicAdd((&list.member[3u]), _e1126);
        atomicStore((&shared_[1u]), _e1127);
    }
    workgroupBarrier();
    if _e1114 {
        let _e1130 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1130) + _e1122)]), _e1116);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_depth_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
