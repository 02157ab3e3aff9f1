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
    var phi_926_: bool;
    var phi_937_: bool;
    var phi_938_: bool;
    var phi_939_: bool;
    var phi_940_: bool;
    var phi_941_: bool;
    var phi_942_: bool;
    var phi_946_: bool;
    var phi_951_: bool;
    var phi_966_: u32;
    var phi_968_: u32;
    var phi_971_: lt_mask_Neighbourhood;
    var phi_983_: bool;
    var phi_984_: bool;
    var phi_993_: u32;
    var phi_994_: u32;
    var phi_1054_: vec2<i32>;
    var phi_1074_: vec2<i32>;
    var phi_1101_: u32;
    var phi_1120_: u32;
    var phi_1128_: u32;
    var phi_1145_: bool;
    var phi_1146_: bool;
    var phi_1153_: bool;
    var phi_1154_: bool;
    var phi_1172_: bool;
    var phi_1173_: bool;
    var phi_1174_: bool;
    var phi_969_: u32;
    var phi_972_: lt_mask_Neighbourhood;
    var phi_1177_: lt_mask_Neighbourhood;
    var phi_1178_: lt_mask_Neighbourhood;
    var phi_1210_: bool;
    var phi_1211_: bool;
    var phi_1240_: bool;
    var phi_1241_: bool;
    var phi_1254_: bool;
    var phi_1255_: bool;
    var phi_1256_: bool;
    var phi_1263_: u32;
    var phi_1264_: u32;
    var phi_1265_: u32;
    var phi_1266_: u32;
    var phi_1267_: u32;
    var phi_1268_: u32;
    var phi_1276_: bool;
    var phi_1284_: u32;
    var phi_1289_: u32;
    var phi_1293_: u32;
    var phi_1294_: u32;
    var phi_1298_: f32;
    var phi_1300_: mask_Masked;
    var phi_1372_: bool;
    var phi_1373_: bool;
    var phi_1374_: bool;
    var phi_1375_: bool;
    var phi_1379_: bool;
    var phi_1407_: f32;
    var phi_1410_: bool;
    var phi_1411_: u32;
    var phi_1422_: u32;
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
            phi_1300_ = mask_Masked(_e268.unnamed.visibility, 0u, false);
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
            if _e720.has_moved {
                let _e727 = p.member.flags;
                phi_926_ = ((_e727 & 4u) == 0u);
            } else {
                phi_926_ = false;
            }
            let _e731 = phi_926_;
            if ((_e722 & 2u) != 0u) {
                if false {
                    phi_939_ = bool();
                    phi_940_ = true;
                } else {
                    if true {
                        phi_937_ = !(_e731);
                        phi_938_ = false;
                    } else {
                        phi_937_ = bool();
                        phi_938_ = true;
                    }
                    let _e734 = phi_937_;
                    let _e736 = phi_938_;
                    phi_939_ = _e734;
                    phi_940_ = _e736;
                }
                let _e738 = phi_939_;
                let _e740 = phi_940_;
                phi_941_ = _e738;
                phi_942_ = _e740;
            } else {
                phi_941_ = bool();
                phi_942_ = true;
            }
            let _e742 = phi_941_;
            let _e744 = phi_942_;
            if _e744 {
                phi_946_ = false;
            } else {
                phi_946_ = _e742;
            }
            let _e746 = phi_946_;
            let _e747 = lt_mask_Neighbourhood(false, true);
            if _e277 {
                phi_951_ = _e746;
            } else {
                phi_951_ = true;
            }
            let _e749 = phi_951_;
            if _e749 {
                if _e714 {
                    if _e720.has_moved {
                        let _e752 = p.member.moving_pattern;
                        phi_966_ = _e752;
                    } else {
                        let _e754 = p.member.still_pattern;
                        phi_966_ = _e754;
                    }
                    let _e756 = phi_966_;
                    phi_968_ = 0u;
                    phi_971_ = _e747;
                    loop {
                        let _e758 = phi_968_;
                        let _e760 = phi_971_;
                        local_1 = _e760;
                        if (1u <= _e756) {
                            if (_e756 <= 4u) {
                                phi_983_ = false;
                            } else {
                                phi_983_ = true;
                            }
                            let _e764 = phi_983_;
                            phi_984_ = _e764;
                        } else {
                            phi_984_ = true;
                        }
                        let _e766 = phi_984_;
                        if _e766 {
                            switch bitcast<i32>(_e756) {
                                case 5: {
                                    phi_993_ = 4u;
                                    break;
                                }
                                case 6: {
                                    phi_993_ = 25u;
                                    break;
                                }
                                case 7: {
                                    phi_993_ = 13u;
                                    break;
                                }
                                default: {
                                    phi_993_ = 9u;
                                    break;
                                }
                            }
                            let _e769 = phi_993_;
                            phi_994_ = _e769;
                        } else {
                            phi_994_ = 5u;
                        }
                        let _e771 = phi_994_;
                        let _e772 = (_e758 < _e771);
                        if _e772 {
                            let _e778 = p.member.frame;
                            let _e782 = p.member.current.size[0u];
                            let _e784 = p.member.current.size[1u];
                            switch bitcast<i32>(_e756) {
                                case 1: {
                                    let _e794 = lt_mask_pattern_plus(_e758);
                                    phi_1074_ = vec2<i32>(_e794.x, _e794.y);
                                    break;
                                }
                                case 2: {
                                    let _e798 = lt_mask_pattern_cross(_e758);
                                    phi_1074_ = vec2<i32>(_e798.x, _e798.y);
                                    break;
                                }
                                case 3: {
                                    let _e804 = lt_mask_pattern_plus_or_cross(_e758, ((_e720.pixel.x + _e720.pixel.y) & 1u));
                                    phi_1074_ = vec2<i32>(_e804.x, _e804.y);
                                    break;
                                }
                                case 4: {
                                    let _e809 = lt_mask_pattern_plus_or_cross(_e758, (_e778 & 1u));
                                    phi_1074_ = vec2<i32>(_e809.x, _e809.y);
                                    break;
                                }
                                case 5: {
                                    switch bitcast<i32>((_e778 & 3u)) {
                                        case 0: {
                                            phi_1054_ = vec2(-1i);
                                            break;
                                        }
                                        case 1: {
                                            phi_1054_ = vec2(0i);
                                            break;
                                        }
                                        case 2: {
                                            phi_1054_ = vec2<i32>(0i, -1i);
                                            break;
                                        }
                                        default: {
                                            phi_1054_ = vec2<i32>(-1i, 0i);
                                            break;
                                        }
                                    }
                                    let _e820 = phi_1054_;
                                    phi_1074_ = (_e820 + vec2<i32>(bitcast<i32>((_e758 & 1u)), bitcast<i32>(((_e758 >> bitcast<u32>(1i)) & 1u))));
                                    break;
                                }
                                case 6: {
                                    phi_1074_ = vec2<i32>((bitcast<i32>((_e758 % 5u)) - 2i), (bitcast<i32>(((_e758 / 5u) % 5u)) - 2i));
                                    break;
                                }
                                case 7: {
                                    let _e837 = lt_mask_pattern_diamond(_e758);
                                    phi_1074_ = vec2<i32>(_e837.x, _e837.y);
                                    break;
                                }
                                default: {
                                    phi_1074_ = vec2<i32>((bitcast<i32>((_e758 % 3u)) - 1i), (bitcast<i32>(((_e758 / 3u) % 3u)) - 1i));
                                    break;
                                }
                            }
                            let _e842 = phi_1074_;
                            let _e845 = lt_mask_pattern_step_clamped(_e720.pixel.x, _e842.x, _e782);
                            let _e846 = lt_mask_pattern_step_clamped(_e720.pixel.y, _e842.y, _e784);
                            let _e853 = ((((_e846 * _e110) + _e845) * _e106.words) + _e106.light.word);
                            if (_e106.light.shift > 29u) {
                                let _e857 = (_e853 + 1u);
                                if (_e857 < _e65) {
                                } else {
                                    return;
                                }
                                let _e861 = last_bits.member[(0u + _e857)];
                                phi_1101_ = _e861;
                            } else {
                                phi_1101_ = 0u;
                            }
                            let _e863 = phi_1101_;
                            if (_e853 < _e65) {
                            } else {
                                return;
                            }
                            let _e869 = last_bits.member[(0u + _e853)];
                            let _e872 = (_e869 >> bitcast<u32>((_e106.light.shift & 31u)));
                            if (_e106.light.shift > 29u) {
                                phi_1120_ = (_e872 | (_e863 << bitcast<u32>(((32u - _e106.light.shift) & 31u))));
                            } else {
                                phi_1120_ = _e872;
                            }
                            let _e880 = phi_1120_;
                            if ((_e880 & 2u) == 0u) {
                                phi_1128_ = (_e880 & 1u);
                            } else {
                                phi_1128_ = (_e880 & 7u);
                            }
                            let _e886 = phi_1128_;
                            if _e760.any_expands {
                                phi_1154_ = true;
                            } else {
                                if ((_e886 & 2u) != 0u) {
                                    if (((_e886 & 4u) != 0u) != _e273) {
                                        phi_1145_ = false;
                                    } else {
                                        phi_1145_ = true;
                                    }
                                    let _e895 = phi_1145_;
                                    phi_1146_ = _e895;
                                } else {
                                    phi_1146_ = true;
                                }
                                let _e897 = phi_1146_;
                                if _e897 {
                                    phi_1153_ = (((_e886 & 1u) != 0u) != _e273);
                                } else {
                                    phi_1153_ = true;
                                }
                                let _e902 = phi_1153_;
                                phi_1154_ = _e902;
                            }
                            let _e904 = phi_1154_;
                            if _e760.all_remove {
                                if (((_e886 & 1u) != 0u) == _e273) {
                                    if ((_e886 & 2u) != 0u) {
                                        phi_1172_ = (((_e886 & 4u) != 0u) == _e273);
                                    } else {
                                        phi_1172_ = true;
                                    }
                                    let _e914 = phi_1172_;
                                    phi_1173_ = _e914;
                                } else {
                                    phi_1173_ = false;
                                }
                                let _e916 = phi_1173_;
                                phi_1174_ = _e916;
                            } else {
                                phi_1174_ = false;
                            }
                            let _e918 = phi_1174_;
                            phi_969_ = (_e758 + 1u);
                            phi_972_ = lt_mask_Neighbourhood(_e904, _e918);
                        } else {
                            phi_969_ = u32();
                            phi_972_ = lt_mask_Neighbourhood();
                        }
                        let _e922 = phi_969_;
                        let _e924 = phi_972_;
                        continue;
                        continuing {
                            phi_968_ = _e922;
                            phi_971_ = _e924;
                            break if !(_e772);
                        }
                    }
                    let _e1216 = local_1;
                    phi_1177_ = _e1216;
                } else {
                    phi_1177_ = _e747;
                }
                let _e927 = phi_1177_;
                phi_1178_ = _e927;
            } else {
                phi_1178_ = _e747;
            }
            let _e929 = phi_1178_;
            let _e932 = p.member.frame;
            let _e934 = p.member.refresh;
            if (_e934 == 0u) {
                phi_1211_ = false;
            } else {
                if (_e934 == 0u) {
                    return;
                }
                let _e943 = ((_e59.x + (_e59.y * (((_e934 * 5u) / 8u) | 1u))) + (_e932 % _e934));
                if (_e934 == 0u) {
                    phi_1210_ = (_e943 == 0u);
                } else {
                    if (_e934 == 0u) {
                        return;
                    }
                    phi_1210_ = ((_e943 % _e934) == 0u);
                }
                let _e950 = phi_1210_;
                phi_1211_ = _e950;
            }
            let _e952 = phi_1211_;
            if (_e115 != 0.5f) {
                if _e714 {
                    if _e952 {
                        phi_1266_ = 6u;
                    } else {
                        if _e277 {
                            phi_1241_ = true;
                        } else {
                            if _e929.any_expands {
                                phi_1240_ = false;
                            } else {
                                phi_1240_ = true;
                            }
                            let _e956 = phi_1240_;
                            phi_1241_ = _e956;
                        }
                        let _e958 = phi_1241_;
                        if _e958 {
                            if _e277 {
                                if _e746 {
                                    if _e929.all_remove {
                                        phi_1254_ = false;
                                    } else {
                                        phi_1254_ = true;
                                    }
                                    let _e960 = phi_1254_;
                                    phi_1255_ = _e960;
                                } else {
                                    phi_1255_ = true;
                                }
                                let _e962 = phi_1255_;
                                phi_1256_ = _e962;
                            } else {
                                phi_1256_ = true;
                            }
                            let _e964 = phi_1256_;
                            if _e964 {
                                if _e277 {
                                    phi_1263_ = 1u;
                                } else {
                                    phi_1263_ = 0u;
                                }
                                let _e966 = phi_1263_;
                                phi_1264_ = _e966;
                            } else {
                                phi_1264_ = 5u;
                            }
                            let _e968 = phi_1264_;
                            phi_1265_ = _e968;
                        } else {
                            phi_1265_ = 4u;
                        }
                        let _e970 = phi_1265_;
                        phi_1266_ = _e970;
                    }
                    let _e972 = phi_1266_;
                    phi_1267_ = _e972;
                } else {
                    phi_1267_ = 3u;
                }
                let _e974 = phi_1267_;
                phi_1268_ = _e974;
            } else {
                phi_1268_ = 2u;
            }
            let _e976 = phi_1268_;
            if !((_e976 == 0u)) {
                phi_1276_ = !((_e976 == 5u));
            } else {
                phi_1276_ = false;
            }
            let _e982 = phi_1276_;
            if _e982 {
                if _e273 {
                    phi_1284_ = (2u | 1u);
                } else {
                    phi_1284_ = 2u;
                }
                let _e985 = phi_1284_;
                if false {
                    phi_1289_ = (_e985 | 4u);
                } else {
                    phi_1289_ = _e985;
                }
                let _e988 = phi_1289_;
                phi_1294_ = _e988;
            } else {
                if _e273 {
                    phi_1293_ = 1u;
                } else {
                    phi_1293_ = 0u;
                }
                let _e990 = phi_1293_;
                phi_1294_ = _e990;
            }
            let _e992 = phi_1294_;
            if _e273 {
                phi_1298_ = 0f;
            } else {
                phi_1298_ = 1f;
            }
            let _e994 = phi_1298_;
            phi_1300_ = mask_Masked(_e994, _e992, _e982);
        }
        let _e997 = phi_1300_;
        visibility.member[_e79.shift] = _e997.visibility;
        let _e1002 = p.member.light.number;
        let _e1003 = (_e1002 * 3u);
        let _e1005 = (_e1003 % 32u);
        let _e1007 = p.member.light.mask_words;
        let _e1009 = ((_e79.shift * _e1007) + (_e1003 / 32u));
        let _e1011 = bits.member[_e1009];
        bits.member[_e1009] = ((_e1011 & ~((7u << bitcast<u32>((_e1005 & 31u))))) | (_e997.bits << bitcast<u32>((_e1005 & 31u))));
        if (_e1005 > 29u) {
            let _e1026 = bits.member[(_e1009 + 1u)];
            let _e1028 = (32u - _e1005);
            bits.member[(_e1009 + 1u)] = ((_e1026 & ~((7u >> bitcast<u32>((_e1028 & 31u))))) | (_e997.bits >> bitcast<u32>((_e1028 & 31u))));
        }
        let _e1043 = samples.member[_e79.shift].normal[0u];
        let _e1045 = global[0u];
        if (_e1043 == _e1045) {
            let _e1048 = samples.member[_e79.shift].normal[1u];
            let _e1050 = global[1u];
            if (_e1048 == _e1050) {
                let _e1053 = samples.member[_e79.shift].normal[2u];
                let _e1055 = global[2u];
                phi_1372_ = (_e1053 == _e1055);
                phi_1373_ = false;
            } else {
                phi_1372_ = bool();
                phi_1373_ = true;
            }
            let _e1058 = phi_1372_;
            let _e1060 = phi_1373_;
            phi_1374_ = _e1058;
            phi_1375_ = _e1060;
        } else {
            phi_1374_ = bool();
            phi_1375_ = true;
        }
        let _e1062 = phi_1374_;
        let _e1064 = phi_1375_;
        if _e1064 {
            phi_1379_ = false;
        } else {
            phi_1379_ = _e1062;
        }
        let _e1066 = phi_1379_;
        if !(_e1066) {
            let _e1069 = samples.member[_e79.shift].position;
            let _e1071 = p.member.current.eye;
            let _e1082 = p.member.current.forward;
            phi_1407_ = ((((_e1069.x - _e1071.x) * _e1082.x) + ((_e1069.y - _e1071.y) * _e1082.y)) + ((_e1069.z - _e1071.z) * _e1082.z));
        } else {
            phi_1407_ = 0f;
        }
        let _e1092 = phi_1407_;
        depths.member[_e79.shift] = _e1092;
        phi_1410_ = _e997.needs_ray;
        phi_1411_ = _e79.shift;
    } else {
        phi_1410_ = false;
        phi_1411_ = 0u;
    }
    let _e1096 = phi_1410_;
    let _e1098 = phi_1411_;
    if (_e60 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1096 {
        let _e1102 = atomicAdd((&shared_[0u]), 1u);
        phi_1422_ = _e1102;
    } else {
        phi_1422_ = 0u;
    }
    let _e1104 = phi_1422_;
    workgroupBarrier();
    if (_e60 == 0u) {
        let _e1108 = atomicLoad((&shared_[0u]));
        let _e1109 = atomicAdd((&list.member[3u]), _e1108);
        atomicStore((&shared_[1u]), _e1109);
    }
    workgroupBarrier();
    if _e1096 {
        let _e1112 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1112) + _e1104)]), _e1098);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_depth_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
