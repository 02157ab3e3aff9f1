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
    var phi_1119_: bool;
    var phi_1120_: bool;
    var phi_1127_: bool;
    var phi_1128_: bool;
    var phi_1146_: bool;
    var phi_1147_: bool;
    var phi_1148_: bool;
    var phi_943_: u32;
    var phi_946_: lt_mask_Neighbourhood;
    var phi_1151_: lt_mask_Neighbourhood;
    var phi_1152_: lt_mask_Neighbourhood;
    var phi_1153_: lt_mask_Neighbourhood;
    var phi_1185_: bool;
    var phi_1186_: bool;
    var phi_1215_: bool;
    var phi_1216_: bool;
    var phi_1229_: bool;
    var phi_1230_: bool;
    var phi_1231_: bool;
    var phi_1238_: u32;
    var phi_1239_: u32;
    var phi_1240_: u32;
    var phi_1241_: u32;
    var phi_1242_: u32;
    var phi_1243_: u32;
    var phi_1251_: bool;
    var phi_1259_: u32;
    var phi_1264_: u32;
    var phi_1268_: u32;
    var phi_1269_: u32;
    var phi_1273_: f32;
    var phi_1275_: mask_Masked;
    var phi_1347_: bool;
    var phi_1348_: bool;
    var phi_1349_: bool;
    var phi_1350_: bool;
    var phi_1354_: bool;
    var phi_1382_: f32;
    var phi_1385_: bool;
    var phi_1386_: u32;
    var phi_1397_: u32;
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
            phi_1275_ = mask_Masked(_e268.unnamed.visibility, 0u, false);
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
            if _e720.has_moved {
            }
            let _e726 = lt_mask_Neighbourhood(false, true);
            if _e277 {
                phi_1153_ = _e726;
            } else {
                if true {
                    if _e714 {
                        if _e720.has_moved {
                            let _e729 = p.member.moving_pattern;
                            phi_940_ = _e729;
                        } else {
                            let _e731 = p.member.still_pattern;
                            phi_940_ = _e731;
                        }
                        let _e733 = phi_940_;
                        phi_942_ = 0u;
                        phi_945_ = _e726;
                        loop {
                            let _e735 = phi_942_;
                            let _e737 = phi_945_;
                            local_1 = _e737;
                            if (1u <= _e733) {
                                if (_e733 <= 4u) {
                                    phi_957_ = false;
                                } else {
                                    phi_957_ = true;
                                }
                                let _e741 = phi_957_;
                                phi_958_ = _e741;
                            } else {
                                phi_958_ = true;
                            }
                            let _e743 = phi_958_;
                            if _e743 {
                                switch bitcast<i32>(_e733) {
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
                                let _e746 = phi_967_;
                                phi_968_ = _e746;
                            } else {
                                phi_968_ = 5u;
                            }
                            let _e748 = phi_968_;
                            let _e749 = (_e735 < _e748);
                            if _e749 {
                                let _e755 = p.member.frame;
                                let _e759 = p.member.current.size[0u];
                                let _e761 = p.member.current.size[1u];
                                switch bitcast<i32>(_e733) {
                                    case 1: {
                                        let _e771 = lt_mask_pattern_plus(_e735);
                                        phi_1048_ = vec2<i32>(_e771.x, _e771.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e775 = lt_mask_pattern_cross(_e735);
                                        phi_1048_ = vec2<i32>(_e775.x, _e775.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e781 = lt_mask_pattern_plus_or_cross(_e735, ((_e720.pixel.x + _e720.pixel.y) & 1u));
                                        phi_1048_ = vec2<i32>(_e781.x, _e781.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e786 = lt_mask_pattern_plus_or_cross(_e735, (_e755 & 1u));
                                        phi_1048_ = vec2<i32>(_e786.x, _e786.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e755 & 3u)) {
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
                                        let _e797 = phi_1028_;
                                        phi_1048_ = (_e797 + vec2<i32>(bitcast<i32>((_e735 & 1u)), bitcast<i32>(((_e735 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_1048_ = vec2<i32>((bitcast<i32>((_e735 % 5u)) - 2i), (bitcast<i32>(((_e735 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e814 = lt_mask_pattern_diamond(_e735);
                                        phi_1048_ = vec2<i32>(_e814.x, _e814.y);
                                        break;
                                    }
                                    default: {
                                        phi_1048_ = vec2<i32>((bitcast<i32>((_e735 % 3u)) - 1i), (bitcast<i32>(((_e735 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e819 = phi_1048_;
                                let _e822 = lt_mask_pattern_step_clamped(_e720.pixel.x, _e819.x, _e759);
                                let _e823 = lt_mask_pattern_step_clamped(_e720.pixel.y, _e819.y, _e761);
                                let _e830 = ((((_e823 * _e110) + _e822) * _e106.words) + _e106.light.word);
                                if (_e106.light.shift > 29u) {
                                    let _e834 = (_e830 + 1u);
                                    if (_e834 < _e65) {
                                    } else {
                                        return;
                                    }
                                    let _e838 = last_bits.member[(0u + _e834)];
                                    phi_1075_ = _e838;
                                } else {
                                    phi_1075_ = 0u;
                                }
                                let _e840 = phi_1075_;
                                if (_e830 < _e65) {
                                } else {
                                    return;
                                }
                                let _e846 = last_bits.member[(0u + _e830)];
                                let _e849 = (_e846 >> bitcast<u32>((_e106.light.shift & 31u)));
                                if (_e106.light.shift > 29u) {
                                    phi_1094_ = (_e849 | (_e840 << bitcast<u32>(((32u - _e106.light.shift) & 31u))));
                                } else {
                                    phi_1094_ = _e849;
                                }
                                let _e857 = phi_1094_;
                                if ((_e857 & 2u) == 0u) {
                                    phi_1102_ = (_e857 & 1u);
                                } else {
                                    phi_1102_ = (_e857 & 7u);
                                }
                                let _e863 = phi_1102_;
                                if _e737.any_expands {
                                    phi_1128_ = true;
                                } else {
                                    if ((_e863 & 2u) != 0u) {
                                        if (((_e863 & 4u) != 0u) != _e273) {
                                            phi_1119_ = false;
                                        } else {
                                            phi_1119_ = true;
                                        }
                                        let _e872 = phi_1119_;
                                        phi_1120_ = _e872;
                                    } else {
                                        phi_1120_ = true;
                                    }
                                    let _e874 = phi_1120_;
                                    if _e874 {
                                        phi_1127_ = (((_e863 & 1u) != 0u) != _e273);
                                    } else {
                                        phi_1127_ = true;
                                    }
                                    let _e879 = phi_1127_;
                                    phi_1128_ = _e879;
                                }
                                let _e881 = phi_1128_;
                                if _e737.all_remove {
                                    if (((_e863 & 1u) != 0u) == _e273) {
                                        if ((_e863 & 2u) != 0u) {
                                            phi_1146_ = (((_e863 & 4u) != 0u) == _e273);
                                        } else {
                                            phi_1146_ = true;
                                        }
                                        let _e891 = phi_1146_;
                                        phi_1147_ = _e891;
                                    } else {
                                        phi_1147_ = false;
                                    }
                                    let _e893 = phi_1147_;
                                    phi_1148_ = _e893;
                                } else {
                                    phi_1148_ = false;
                                }
                                let _e895 = phi_1148_;
                                phi_943_ = (_e735 + 1u);
                                phi_946_ = lt_mask_Neighbourhood(_e881, _e895);
                            } else {
                                phi_943_ = u32();
                                phi_946_ = lt_mask_Neighbourhood();
                            }
                            let _e899 = phi_943_;
                            let _e901 = phi_946_;
                            continue;
                            continuing {
                                phi_942_ = _e899;
                                phi_945_ = _e901;
                                break if !(_e749);
                            }
                        }
                        let _e1186 = local_1;
                        phi_1151_ = _e1186;
                    } else {
                        phi_1151_ = _e726;
                    }
                    let _e904 = phi_1151_;
                    phi_1152_ = _e904;
                } else {
                    phi_1152_ = _e726;
                }
                let _e906 = phi_1152_;
                phi_1153_ = _e906;
            }
            let _e908 = phi_1153_;
            let _e911 = p.member.frame;
            let _e913 = p.member.refresh;
            if (_e913 == 0u) {
                phi_1186_ = false;
            } else {
                if (_e913 == 0u) {
                    return;
                }
                let _e922 = ((_e59.x + (_e59.y * (((_e913 * 5u) / 8u) | 1u))) + (_e911 % _e913));
                if (_e913 == 0u) {
                    phi_1185_ = (_e922 == 0u);
                } else {
                    if (_e913 == 0u) {
                        return;
                    }
                    phi_1185_ = ((_e922 % _e913) == 0u);
                }
                let _e929 = phi_1185_;
                phi_1186_ = _e929;
            }
            let _e931 = phi_1186_;
            if (_e115 != 0.5f) {
                if _e714 {
                    if _e931 {
                        phi_1241_ = 6u;
                    } else {
                        if _e277 {
                            phi_1216_ = true;
                        } else {
                            if _e908.any_expands {
                                phi_1215_ = false;
                            } else {
                                phi_1215_ = true;
                            }
                            let _e935 = phi_1215_;
                            phi_1216_ = _e935;
                        }
                        let _e937 = phi_1216_;
                        if _e937 {
                            if _e277 {
                                if false {
                                    if _e908.all_remove {
                                        phi_1229_ = false;
                                    } else {
                                        phi_1229_ = true;
                                    }
                                    let _e939 = phi_1229_;
                                    phi_1230_ = _e939;
                                } else {
                                    phi_1230_ = true;
                                }
                                let _e941 = phi_1230_;
                                phi_1231_ = _e941;
                            } else {
                                phi_1231_ = true;
                            }
                            let _e943 = phi_1231_;
                            if _e943 {
                                if _e277 {
                                    phi_1238_ = 1u;
                                } else {
                                    phi_1238_ = 0u;
                                }
                                let _e945 = phi_1238_;
                                phi_1239_ = _e945;
                            } else {
                                phi_1239_ = 5u;
                            }
                            let _e947 = phi_1239_;
                            phi_1240_ = _e947;
                        } else {
                            phi_1240_ = 4u;
                        }
                        let _e949 = phi_1240_;
                        phi_1241_ = _e949;
                    }
                    let _e951 = phi_1241_;
                    phi_1242_ = _e951;
                } else {
                    phi_1242_ = 3u;
                }
                let _e953 = phi_1242_;
                phi_1243_ = _e953;
            } else {
                phi_1243_ = 2u;
            }
            let _e955 = phi_1243_;
            if !((_e955 == 0u)) {
                phi_1251_ = !((_e955 == 5u));
            } else {
                phi_1251_ = false;
            }
            let _e961 = phi_1251_;
            if _e961 {
                if _e273 {
                    phi_1259_ = (2u | 1u);
                } else {
                    phi_1259_ = 2u;
                }
                let _e964 = phi_1259_;
                if false {
                    phi_1264_ = (_e964 | 4u);
                } else {
                    phi_1264_ = _e964;
                }
                let _e967 = phi_1264_;
                phi_1269_ = _e967;
            } else {
                if _e273 {
                    phi_1268_ = 1u;
                } else {
                    phi_1268_ = 0u;
                }
                let _e969 = phi_1268_;
                phi_1269_ = _e969;
            }
            let _e971 = phi_1269_;
            if _e273 {
                phi_1273_ = 0f;
            } else {
                phi_1273_ = 1f;
            }
            let _e973 = phi_1273_;
            phi_1275_ = mask_Masked(_e973, _e971, _e961);
        }
        let _e976 = phi_1275_;
        visibility.member[_e79.shift] = _e976.visibility;
        let _e981 = p.member.light.number;
        let _e982 = (_e981 * 3u);
        let _e984 = (_e982 % 32u);
        let _e986 = p.member.light.mask_words;
        let _e988 = ((_e79.shift * _e986) + (_e982 / 32u));
        let _e990 = bits.member[_e988];
        bits.member[_e988] = ((_e990 & ~((7u << bitcast<u32>((_e984 & 31u))))) | (_e976.bits << bitcast<u32>((_e984 & 31u))));
        if (_e984 > 29u) {
            let _e1005 = bits.member[(_e988 + 1u)];
            let _e1007 = (32u - _e984);
            bits.member[(_e988 + 1u)] = ((_e1005 & ~((7u >> bitcast<u32>((_e1007 & 31u))))) | (_e976.bits >> bitcast<u32>((_e1007 & 31u))));
        }
        let _e1022 = samples.member[_e79.shift].normal[0u];
        let _e1024 = global[0u];
        if (_e1022 == _e1024) {
            let _e1027 = samples.member[_e79.shift].normal[1u];
            let _e1029 = global[1u];
            if (_e1027 == _e1029) {
                let _e1032 = samples.member[_e79.shift].normal[2u];
                let _e1034 = global[2u];
                phi_1347_ = (_e1032 == _e1034);
                phi_1348_ = false;
            } else {
                phi_1347_ = bool();
                phi_1348_ = true;
            }
            let _e1037 = phi_1347_;
            let _e1039 = phi_1348_;
            phi_1349_ = _e1037;
            phi_1350_ = _e1039;
        } else {
            phi_1349_ = bool();
            phi_1350_ = true;
        }
        let _e1041 = phi_1349_;
        let _e1043 = phi_1350_;
        if _e1043 {
            phi_1354_ = false;
        } else {
            phi_1354_ = _e1041;
        }
        let _e1045 = phi_1354_;
        if !(_e1045) {
            let _e1048 = samples.member[_e79.shift].position;
            let _e1050 = p.member.current.eye;
            let _e1061 = p.member.current.forward;
            phi_1382_ = ((((_e1048.x - _e1050.x) * _e1061.x) + ((_e1048.y - _e1050.y) * _e1061.y)) + ((_e1048.z - _e1050.z) * _e1061.z));
        } else {
            phi_1382_ = 0f;
        }
        let _e1071 = phi_1382_;
        depths.member[_e79.shift] = _e1071;
        phi_1385_ = _e976.needs_ray;
        phi_1386_ = _e79.shift;
    } else {
        phi_1385_ = false;
        phi_1386_ = 0u;
    }
    let _e1075 = phi_1385_;
    let _e1077 = phi_1386_;
    if (_e60 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1075 {
        let _e1081 = atomicAdd((&shared_[0u]), 1u);
        phi_1397_ = _e1081;
    } else {
        phi_1397_ = 0u;
    }
    let _e1083 = phi_1397_;
    workgroupBarrier();
    if (_e60 == 0u) {
        let _e1087 = atomicLoad((&shared_[0u]));
        let _e1088 = atomicAdd((&list.member[3u]), _e1087);
        atomicStore((&shared_[1u]), _e1088);
    }
    workgroupBarrier();
    if _e1075 {
        let _e1091 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1091) + _e1083)]), _e1077);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_depth_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
