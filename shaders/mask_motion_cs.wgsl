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

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_170_: lt_mask_LightPlace;
    var phi_171_: bool;
    var phi_172_: lt_mask_LightPlace;
    var phi_173_: bool;
    var phi_178_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_170_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_171_ = false;
        } else {
            phi_170_ = lt_mask_LightPlace();
            phi_171_ = true;
        }
        let _e67 = phi_170_;
        let _e69 = phi_171_;
        phi_172_ = _e67;
        phi_173_ = _e69;
    } else {
        phi_172_ = lt_mask_LightPlace();
        phi_173_ = true;
    }
    let _e71 = phi_172_;
    let _e73 = phi_173_;
    if _e73 {
        phi_178_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_178_ = _e71;
    }
    let _e78 = phi_178_;
    return lt_mask_LightPlace(_e78.word, _e78.shift);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_196_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_196_ = vec2(0i);
            break;
        }
        case 1: {
            phi_196_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_196_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_196_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_196_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e63 = phi_196_;
    return vec2<i32>(_e63.x, _e63.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_214_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_214_ = vec2(0i);
            break;
        }
        case 1: {
            phi_214_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_214_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_214_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_214_ = vec2(1i);
            break;
        }
    }
    let _e63 = phi_214_;
    return vec2<i32>(_e63.x, _e63.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_233_: vec2<i32>;

    if (param_6 == 0u) {
        let _e57 = lt_mask_pattern_plus(param_5);
        phi_233_ = vec2<i32>(_e57.x, _e57.y);
    } else {
        let _e61 = lt_mask_pattern_cross(param_5);
        phi_233_ = vec2<i32>(_e61.x, _e61.y);
    }
    let _e66 = phi_233_;
    return vec2<i32>(_e66.x, _e66.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_258_: vec2<i32>;

    let _e55 = (param_7 % 13u);
    switch bitcast<i32>(_e55) {
        case 9: {
            phi_258_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_258_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_258_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_258_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_258_ = vec2<i32>((bitcast<i32>((_e55 % 3u)) - 1i), (bitcast<i32>(((_e55 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e70 = phi_258_;
    return vec2<i32>(_e70.x, _e70.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_279_: u32;
    var phi_280_: u32;

    let _e58 = (bitcast<i32>(param_8) + param_9);
    if (_e58 < 0i) {
        phi_280_ = 0u;
    } else {
        if (_e58 >= bitcast<i32>(param_10)) {
            phi_279_ = (param_10 - 1u);
        } else {
            phi_279_ = bitcast<u32>(_e58);
        }
        let _e65 = phi_279_;
        phi_280_ = _e65;
    }
    let _e67 = phi_280_;
    return _e67;
}

fn function_() {
    var phi_352_: bool;
    var phi_353_: bool;
    var phi_354_: bool;
    var phi_355_: bool;
    var phi_359_: bool;
    var phi_429_: bool;
    var phi_430_: bool;
    var phi_441_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_442_: bool;
    var phi_443_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_444_: bool;
    var phi_451_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_455_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_468_: bool;
    var phi_657_: f32;
    var phi_662_: f32;
    var phi_663_: bool;
    var phi_664_: f32;
    var phi_665_: bool;
    var phi_669_: f32;
    var phi_692_: f32;
    var phi_697_: f32;
    var phi_698_: bool;
    var phi_699_: f32;
    var phi_700_: bool;
    var phi_704_: f32;
    var phi_725_: bool;
    var phi_744_: vec2<u32>;
    var phi_745_: bool;
    var phi_746_: bool;
    var phi_747_: bool;
    var phi_748_: vec2<u32>;
    var phi_749_: bool;
    var phi_750_: bool;
    var phi_751_: bool;
    var phi_752_: bool;
    var phi_753_: bool;
    var phi_754_: bool;
    var phi_755_: vec2<u32>;
    var phi_756_: bool;
    var phi_757_: bool;
    var phi_758_: bool;
    var phi_759_: bool;
    var phi_760_: bool;
    var phi_761_: bool;
    var phi_762_: vec2<u32>;
    var phi_763_: bool;
    var phi_764_: bool;
    var phi_765_: bool;
    var phi_766_: bool;
    var phi_775_: bool;
    var phi_776_: bool;
    var phi_777_: bool;
    var phi_778_: bool;
    var phi_782_: bool;
    var phi_783_: bool;
    var phi_784_: vec2<u32>;
    var phi_826_: bool;
    var phi_827_: bool;
    var phi_829_: bool;
    var phi_830_: lt_mask_Reprojection;
    var phi_831_: lt_mask_Reprojection;
    var phi_832_: bool;
    var phi_836_: bool;
    var phi_837_: lt_mask_Reprojection;
    var phi_851_: bool;
    var phi_862_: bool;
    var phi_863_: bool;
    var phi_864_: bool;
    var phi_865_: bool;
    var phi_866_: bool;
    var phi_867_: bool;
    var phi_871_: bool;
    var phi_876_: bool;
    var phi_891_: u32;
    var phi_893_: u32;
    var phi_896_: lt_mask_Neighbourhood;
    var phi_908_: bool;
    var phi_909_: bool;
    var phi_918_: u32;
    var phi_919_: u32;
    var phi_979_: vec2<i32>;
    var phi_999_: vec2<i32>;
    var phi_1024_: u32;
    var phi_1043_: u32;
    var phi_1051_: u32;
    var phi_1068_: bool;
    var phi_1069_: bool;
    var phi_1076_: bool;
    var phi_1077_: bool;
    var phi_1095_: bool;
    var phi_1096_: bool;
    var phi_1097_: bool;
    var phi_894_: u32;
    var phi_897_: lt_mask_Neighbourhood;
    var phi_1100_: lt_mask_Neighbourhood;
    var phi_1101_: lt_mask_Neighbourhood;
    var phi_1133_: bool;
    var phi_1134_: bool;
    var phi_1163_: bool;
    var phi_1164_: bool;
    var phi_1177_: bool;
    var phi_1178_: bool;
    var phi_1179_: bool;
    var phi_1186_: u32;
    var phi_1187_: u32;
    var phi_1188_: u32;
    var phi_1189_: u32;
    var phi_1190_: u32;
    var phi_1191_: u32;
    var phi_1199_: bool;
    var phi_1207_: u32;
    var phi_1212_: u32;
    var phi_1216_: u32;
    var phi_1217_: u32;
    var phi_1221_: f32;
    var phi_1223_: mask_Masked;
    var phi_1273_: bool;
    var phi_1274_: u32;
    var phi_1285_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e54 = id_1;
    let _e55 = local_2;
    let _e60 = arrayLength((&last_bits.member));
    let _e67 = p.member.current.size[0u];
    let _e69 = p.member.current.size[1u];
    let _e70 = lt_shaders_entry_pixel_index(_e54, _e67, _e69);
    if (bitcast<i32>(_e70.word) != 0i) {
        let _e77 = p.member.light.number;
        let _e78 = (_e77 * 3u);
        let _e80 = (_e78 % 32u);
        let _e82 = p.member.light.mask_words;
        let _e86 = p.member.current.size[0u];
        let _e89 = samples.member[_e70.shift].position;
        let _e91 = visibility.member[_e70.shift];
        let _e97 = samples.member[_e70.shift].normal[0u];
        let _e99 = global[0u];
        if (_e97 == _e99) {
            let _e102 = samples.member[_e70.shift].normal[1u];
            let _e104 = global[1u];
            if (_e102 == _e104) {
                let _e107 = samples.member[_e70.shift].normal[2u];
                let _e109 = global[2u];
                phi_352_ = (_e107 == _e109);
                phi_353_ = false;
            } else {
                phi_352_ = bool();
                phi_353_ = true;
            }
            let _e112 = phi_352_;
            let _e114 = phi_353_;
            phi_354_ = _e112;
            phi_355_ = _e114;
        } else {
            phi_354_ = bool();
            phi_355_ = true;
        }
        let _e116 = phi_354_;
        let _e118 = phi_355_;
        if _e118 {
            phi_359_ = false;
        } else {
            phi_359_ = _e116;
        }
        let _e120 = phi_359_;
        if !(_e120) {
            let _e123 = samples.member[_e70.shift].position;
            let _e125 = p.member.light.place;
            let _e131 = p.member.light.place[3u];
            let _e138 = (_e125.x - (_e123.x * _e131));
            let _e139 = (_e125.y - (_e123.y * _e131));
            let _e140 = (_e125.z - (_e123.z * _e131));
            let _e142 = samples.member[_e70.shift].normal;
            if ((((_e142.x * _e138) + (_e142.y * _e139)) + (_e142.z * _e140)) > 0f) {
                let _e156 = (((_e138 * _e138) + (_e139 * _e139)) + (_e140 * _e140));
                let _e158 = p.member.light.axis;
                let _e170 = p.member.light.place[3u];
                if (_e170 == 0f) {
                    phi_430_ = true;
                } else {
                    let _e173 = p.member.light.range_squared;
                    if (_e156 <= _e173) {
                        let _e176 = p.member.light.cos_outer;
                        phi_429_ = (-((((_e138 * _e158.x) + (_e139 * _e158.y)) + (_e140 * _e158.z))) >= (_e176 * sqrt(_e156)));
                    } else {
                        phi_429_ = false;
                    }
                    let _e181 = phi_429_;
                    phi_430_ = _e181;
                }
                let _e183 = phi_430_;
                if _e183 {
                    let _e185 = samples.member[_e70.shift].flags;
                    let _e193 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e199 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e193.unnamed.visibility, false), _e193.unnamed_1);
                    phi_441_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e199.unnamed, ((_e185 & 1u) == 0u));
                    phi_442_ = false;
                } else {
                    phi_441_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_442_ = true;
                }
                let _e204 = phi_441_;
                let _e206 = phi_442_;
                phi_443_ = _e204;
                phi_444_ = _e206;
            } else {
                phi_443_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_444_ = true;
            }
            let _e208 = phi_443_;
            let _e210 = phi_444_;
            if _e210 {
                let _e216 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e222 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e216.unnamed.visibility, false), _e216.unnamed_1);
                phi_451_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e222.unnamed, true);
            } else {
                phi_451_ = _e208;
            }
            let _e227 = phi_451_;
            phi_455_ = _e227;
        } else {
            let _e233 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e239 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e233.unnamed.visibility, false), _e233.unnamed_1);
            phi_455_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e239.unnamed, true);
        }
        let _e244 = phi_455_;
        if _e244.unnamed_1 {
            phi_1223_ = mask_Masked(_e244.unnamed.visibility, 0u, false);
        } else {
            let _e249 = (_e91 < 0.5f);
            if (_e91 > 0f) {
                phi_468_ = (_e91 < 1f);
            } else {
                phi_468_ = false;
            }
            let _e253 = phi_468_;
            let _e255 = samples.member[_e70.shift].position;
            let _e259 = p.member.previous.eye;
            let _e262 = (_e89.x - _e259.x);
            let _e265 = (_e89.y - _e259.y);
            let _e268 = (_e89.z - _e259.z);
            let _e270 = p.member.previous.forward;
            let _e278 = (((_e262 * _e270.x) + (_e265 * _e270.y)) + (_e268 * _e270.z));
            let _e280 = p.member.previous.right;
            let _e290 = p.member.previous.right;
            let _e305 = p.member.previous.up;
            let _e315 = p.member.previous.up;
            let _e330 = p.member.current.eye;
            let _e333 = (_e255.x - _e330.x);
            let _e336 = (_e255.y - _e330.y);
            let _e339 = (_e255.z - _e330.z);
            let _e341 = p.member.current.forward;
            let _e349 = (((_e333 * _e341.x) + (_e336 * _e341.y)) + (_e339 * _e341.z));
            let _e351 = p.member.current.right;
            let _e361 = p.member.current.right;
            let _e376 = p.member.current.up;
            let _e386 = p.member.current.up;
            let _e405 = p.member.current.size[0u];
            let _e407 = (((((((_e262 * _e280.x) + (_e265 * _e280.y)) + (_e268 * _e280.z)) / ((((_e290.x * _e290.x) + (_e290.y * _e290.y)) + (_e290.z * _e290.z)) * _e278)) - ((((_e333 * _e351.x) + (_e336 * _e351.y)) + (_e339 * _e351.z)) / ((((_e361.x * _e361.x) + (_e361.y * _e361.y)) + (_e361.z * _e361.z)) * _e349))) * 0.5f) * f32(_e405));
            let _e411 = p.member.current.size[1u];
            let _e413 = (((((((_e262 * _e305.x) + (_e265 * _e305.y)) + (_e268 * _e305.z)) / ((((_e315.x * _e315.x) + (_e315.y * _e315.y)) + (_e315.z * _e315.z)) * _e278)) - ((((_e333 * _e376.x) + (_e336 * _e376.y)) + (_e339 * _e376.z)) / ((((_e386.x * _e386.x) + (_e386.y * _e386.y)) + (_e386.z * _e386.z)) * _e349))) * -0.5f) * f32(_e411));
            let _e417 = p.member.current.size[0u];
            let _e419 = p.member.current.size[1u];
            let _e423 = ((f32(_e54.x) + 0.5f) + _e407);
            if (_e423 > -8388608f) {
                let _e435 = f32(select(0i, select(select(i32(_e423), i32(-2147483648), (_e423 < bitcast<f32>(3472883712u))), 2147483647i, (_e423 > bitcast<f32>(1325400063u))), (_e423 == _e423)));
                if (_e435 > _e423) {
                    phi_657_ = 1f;
                } else {
                    phi_657_ = 0f;
                }
                let _e438 = phi_657_;
                if (_e423 < 8388608f) {
                    phi_662_ = (_e435 - _e438);
                    phi_663_ = false;
                } else {
                    phi_662_ = f32();
                    phi_663_ = true;
                }
                let _e441 = phi_662_;
                let _e443 = phi_663_;
                phi_664_ = _e441;
                phi_665_ = _e443;
            } else {
                phi_664_ = f32();
                phi_665_ = true;
            }
            let _e445 = phi_664_;
            let _e447 = phi_665_;
            if _e447 {
                phi_669_ = _e423;
            } else {
                phi_669_ = _e445;
            }
            let _e449 = phi_669_;
            let _e452 = ((f32(_e54.y) + 0.5f) + _e413);
            if (_e452 > -8388608f) {
                let _e464 = f32(select(0i, select(select(i32(_e452), i32(-2147483648), (_e452 < bitcast<f32>(3472883712u))), 2147483647i, (_e452 > bitcast<f32>(1325400063u))), (_e452 == _e452)));
                if (_e464 > _e452) {
                    phi_692_ = 1f;
                } else {
                    phi_692_ = 0f;
                }
                let _e467 = phi_692_;
                if (_e452 < 8388608f) {
                    phi_697_ = (_e464 - _e467);
                    phi_698_ = false;
                } else {
                    phi_697_ = f32();
                    phi_698_ = true;
                }
                let _e470 = phi_697_;
                let _e472 = phi_698_;
                phi_699_ = _e470;
                phi_700_ = _e472;
            } else {
                phi_699_ = f32();
                phi_700_ = true;
            }
            let _e474 = phi_699_;
            let _e476 = phi_700_;
            if _e476 {
                phi_704_ = _e452;
            } else {
                phi_704_ = _e474;
            }
            let _e478 = phi_704_;
            if (_e449 >= 0f) {
                if (_e478 >= 0f) {
                    if (_e449 < f32(_e417)) {
                        let _e484 = (_e478 < f32(_e419));
                        if (_e407 == 0f) {
                            phi_725_ = (_e413 == 0f);
                        } else {
                            phi_725_ = false;
                        }
                        let _e488 = phi_725_;
                        if _e484 {
                            phi_744_ = vec2<u32>(select(select(u32(_e449), 0u, (_e449 < bitcast<f32>(0u))), 4294967295u, (_e449 > bitcast<f32>(1333788671u))), select(select(u32(_e478), 0u, (_e478 < bitcast<f32>(0u))), 4294967295u, (_e478 > bitcast<f32>(1333788671u))));
                            phi_745_ = false;
                        } else {
                            phi_744_ = vec2<u32>();
                            phi_745_ = true;
                        }
                        let _e505 = phi_744_;
                        let _e507 = phi_745_;
                        phi_746_ = _e488;
                        phi_747_ = _e484;
                        phi_748_ = _e505;
                        phi_749_ = _e488;
                        phi_750_ = _e484;
                        phi_751_ = false;
                        phi_752_ = _e507;
                    } else {
                        phi_746_ = bool();
                        phi_747_ = bool();
                        phi_748_ = vec2<u32>();
                        phi_749_ = bool();
                        phi_750_ = bool();
                        phi_751_ = true;
                        phi_752_ = false;
                    }
                    let _e509 = phi_746_;
                    let _e511 = phi_747_;
                    let _e513 = phi_748_;
                    let _e515 = phi_749_;
                    let _e517 = phi_750_;
                    let _e519 = phi_751_;
                    let _e521 = phi_752_;
                    phi_753_ = _e509;
                    phi_754_ = _e511;
                    phi_755_ = _e513;
                    phi_756_ = _e515;
                    phi_757_ = _e517;
                    phi_758_ = _e519;
                    phi_759_ = _e521;
                } else {
                    phi_753_ = bool();
                    phi_754_ = bool();
                    phi_755_ = vec2<u32>();
                    phi_756_ = bool();
                    phi_757_ = bool();
                    phi_758_ = true;
                    phi_759_ = false;
                }
                let _e523 = phi_753_;
                let _e525 = phi_754_;
                let _e527 = phi_755_;
                let _e529 = phi_756_;
                let _e531 = phi_757_;
                let _e533 = phi_758_;
                let _e535 = phi_759_;
                phi_760_ = _e523;
                phi_761_ = _e525;
                phi_762_ = _e527;
                phi_763_ = _e529;
                phi_764_ = _e531;
                phi_765_ = _e533;
                phi_766_ = _e535;
            } else {
                phi_760_ = bool();
                phi_761_ = bool();
                phi_762_ = vec2<u32>();
                phi_763_ = bool();
                phi_764_ = bool();
                phi_765_ = true;
                phi_766_ = false;
            }
            let _e537 = phi_760_;
            let _e539 = phi_761_;
            let _e541 = phi_762_;
            let _e543 = phi_763_;
            let _e545 = phi_764_;
            let _e547 = phi_765_;
            let _e549 = phi_766_;
            if _e547 {
                if (_e407 == 0f) {
                    phi_775_ = (_e413 == 0f);
                } else {
                    phi_775_ = false;
                }
                let _e553 = phi_775_;
                phi_776_ = _e553;
                phi_777_ = false;
                phi_778_ = true;
            } else {
                phi_776_ = _e543;
                phi_777_ = _e545;
                phi_778_ = _e549;
            }
            let _e555 = phi_776_;
            let _e557 = phi_777_;
            let _e559 = phi_778_;
            if _e559 {
                phi_782_ = _e555;
                phi_783_ = _e557;
                phi_784_ = vec2<u32>(_e54.x, _e54.y);
            } else {
                phi_782_ = _e537;
                phi_783_ = _e539;
                phi_784_ = _e541;
            }
            let _e561 = phi_782_;
            let _e563 = phi_783_;
            let _e565 = phi_784_;
            let _e575 = lt_mask_Reprojection(vec2<u32>(_e565.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e582 = lt_mask_Reprojection(vec2<u32>(_e575.pixel.x, _e565.y), _e575.is_valid, _e575.has_moved);
            let _e586 = lt_mask_Reprojection(_e582.pixel, _e563, _e582.has_moved);
            let _e590 = lt_mask_Reprojection(_e586.pixel, _e586.is_valid, !(_e561));
            if _e563 {
                let _e593 = p.member.previous.eye;
                let _e604 = p.member.previous.forward;
                let _e613 = (((((_e89.x - _e593.x) * _e604.x) + ((_e89.y - _e593.y) * _e604.y)) + ((_e89.z - _e593.z) * _e604.z)) > 0f);
                let _e617 = lt_mask_Reprojection(_e590.pixel, _e613, _e590.has_moved);
                if _e613 {
                    let _e619 = p.member.flags;
                    phi_826_ = ((_e619 & 1u) != 0u);
                    phi_827_ = false;
                } else {
                    phi_826_ = bool();
                    phi_827_ = true;
                }
                let _e623 = phi_826_;
                let _e625 = phi_827_;
                phi_829_ = _e623;
                phi_830_ = _e617;
                phi_831_ = _e617;
                phi_832_ = _e625;
            } else {
                phi_829_ = bool();
                phi_830_ = lt_mask_Reprojection();
                phi_831_ = lt_mask_Reprojection(_e590.pixel, false, _e590.has_moved);
                phi_832_ = true;
            }
            let _e631 = phi_829_;
            let _e633 = phi_830_;
            let _e635 = phi_831_;
            let _e637 = phi_832_;
            if _e637 {
                phi_836_ = false;
                phi_837_ = _e635;
            } else {
                phi_836_ = _e631;
                phi_837_ = _e633;
            }
            let _e639 = phi_836_;
            let _e641 = phi_837_;
            let _e645 = lt_mask_Reprojection(_e641.pixel, _e639, _e641.has_moved);
            let _e647 = p.member.flags;
            if _e645.has_moved {
                let _e652 = p.member.flags;
                phi_851_ = ((_e652 & 4u) == 0u);
            } else {
                phi_851_ = false;
            }
            let _e656 = phi_851_;
            if ((_e647 & 2u) != 0u) {
                if false {
                    phi_864_ = bool();
                    phi_865_ = true;
                } else {
                    if true {
                        phi_862_ = !(_e656);
                        phi_863_ = false;
                    } else {
                        phi_862_ = bool();
                        phi_863_ = true;
                    }
                    let _e659 = phi_862_;
                    let _e661 = phi_863_;
                    phi_864_ = _e659;
                    phi_865_ = _e661;
                }
                let _e663 = phi_864_;
                let _e665 = phi_865_;
                phi_866_ = _e663;
                phi_867_ = _e665;
            } else {
                phi_866_ = bool();
                phi_867_ = true;
            }
            let _e667 = phi_866_;
            let _e669 = phi_867_;
            if _e669 {
                phi_871_ = false;
            } else {
                phi_871_ = _e667;
            }
            let _e671 = phi_871_;
            let _e672 = lt_mask_Neighbourhood(false, true);
            if _e253 {
                phi_876_ = _e671;
            } else {
                phi_876_ = true;
            }
            let _e674 = phi_876_;
            if _e674 {
                if _e639 {
                    if _e645.has_moved {
                        let _e677 = p.member.moving_pattern;
                        phi_891_ = _e677;
                    } else {
                        let _e679 = p.member.still_pattern;
                        phi_891_ = _e679;
                    }
                    let _e681 = phi_891_;
                    phi_893_ = 0u;
                    phi_896_ = _e672;
                    loop {
                        let _e683 = phi_893_;
                        let _e685 = phi_896_;
                        local_1 = _e685;
                        if (1u <= _e681) {
                            if (_e681 <= 4u) {
                                phi_908_ = false;
                            } else {
                                phi_908_ = true;
                            }
                            let _e689 = phi_908_;
                            phi_909_ = _e689;
                        } else {
                            phi_909_ = true;
                        }
                        let _e691 = phi_909_;
                        if _e691 {
                            switch bitcast<i32>(_e681) {
                                case 5: {
                                    phi_918_ = 4u;
                                    break;
                                }
                                case 6: {
                                    phi_918_ = 25u;
                                    break;
                                }
                                case 7: {
                                    phi_918_ = 13u;
                                    break;
                                }
                                default: {
                                    phi_918_ = 9u;
                                    break;
                                }
                            }
                            let _e694 = phi_918_;
                            phi_919_ = _e694;
                        } else {
                            phi_919_ = 5u;
                        }
                        let _e696 = phi_919_;
                        let _e697 = (_e683 < _e696);
                        if _e697 {
                            let _e703 = p.member.frame;
                            let _e707 = p.member.current.size[0u];
                            let _e709 = p.member.current.size[1u];
                            switch bitcast<i32>(_e681) {
                                case 1: {
                                    let _e719 = lt_mask_pattern_plus(_e683);
                                    phi_999_ = vec2<i32>(_e719.x, _e719.y);
                                    break;
                                }
                                case 2: {
                                    let _e723 = lt_mask_pattern_cross(_e683);
                                    phi_999_ = vec2<i32>(_e723.x, _e723.y);
                                    break;
                                }
                                case 3: {
                                    let _e729 = lt_mask_pattern_plus_or_cross(_e683, ((_e645.pixel.x + _e645.pixel.y) & 1u));
                                    phi_999_ = vec2<i32>(_e729.x, _e729.y);
                                    break;
                                }
                                case 4: {
                                    let _e734 = lt_mask_pattern_plus_or_cross(_e683, (_e703 & 1u));
                                    phi_999_ = vec2<i32>(_e734.x, _e734.y);
                                    break;
                                }
                                case 5: {
                                    switch bitcast<i32>((_e703 & 3u)) {
                                        case 0: {
                                            phi_979_ = vec2(-1i);
                                            break;
                                        }
                                        case 1: {
                                            phi_979_ = vec2(0i);
                                            break;
                                        }
                                        case 2: {
                                            phi_979_ = vec2<i32>(0i, -1i);
                                            break;
                                        }
                                        default: {
                                            phi_979_ = vec2<i32>(-1i, 0i);
                                            break;
                                        }
                                    }
                                    let _e745 = phi_979_;
                                    phi_999_ = (_e745 + vec2<i32>(bitcast<i32>((_e683 & 1u)), bitcast<i32>(((_e683 >> bitcast<u32>(1i)) & 1u))));
                                    break;
                                }
                                case 6: {
                                    phi_999_ = vec2<i32>((bitcast<i32>((_e683 % 5u)) - 2i), (bitcast<i32>(((_e683 / 5u) % 5u)) - 2i));
                                    break;
                                }
                                case 7: {
                                    let _e762 = lt_mask_pattern_diamond(_e683);
                                    phi_999_ = vec2<i32>(_e762.x, _e762.y);
                                    break;
                                }
                                default: {
                                    phi_999_ = vec2<i32>((bitcast<i32>((_e683 % 3u)) - 1i), (bitcast<i32>(((_e683 / 3u) % 3u)) - 1i));
                                    break;
                                }
                            }
                            let _e767 = phi_999_;
                            let _e770 = lt_mask_pattern_step_clamped(_e645.pixel.x, _e767.x, _e707);
                            let _e771 = lt_mask_pattern_step_clamped(_e645.pixel.y, _e767.y, _e709);
                            let _e775 = ((((_e771 * _e86) + _e770) * _e82) + (_e78 / 32u));
                            if (_e80 > 29u) {
                                let _e777 = (_e775 + 1u);
                                if (_e777 < _e60) {
                                } else {
                                    return;
                                }
                                let _e781 = last_bits.member[(0u + _e777)];
                                phi_1024_ = _e781;
                            } else {
                                phi_1024_ = 0u;
                            }
                            let _e783 = phi_1024_;
                            if (_e775 < _e60) {
                            } else {
                                return;
                            }
                            let _e787 = last_bits.member[(0u + _e775)];
                            let _e790 = (_e787 >> bitcast<u32>((_e80 & 31u)));
                            if (_e80 > 29u) {
                                phi_1043_ = (_e790 | (_e783 << bitcast<u32>(((32u - _e80) & 31u))));
                            } else {
                                phi_1043_ = _e790;
                            }
                            let _e798 = phi_1043_;
                            if ((_e798 & 2u) == 0u) {
                                phi_1051_ = (_e798 & 1u);
                            } else {
                                phi_1051_ = (_e798 & 7u);
                            }
                            let _e804 = phi_1051_;
                            if _e685.any_expands {
                                phi_1077_ = true;
                            } else {
                                if ((_e804 & 2u) != 0u) {
                                    if (((_e804 & 4u) != 0u) != _e249) {
                                        phi_1068_ = false;
                                    } else {
                                        phi_1068_ = true;
                                    }
                                    let _e813 = phi_1068_;
                                    phi_1069_ = _e813;
                                } else {
                                    phi_1069_ = true;
                                }
                                let _e815 = phi_1069_;
                                if _e815 {
                                    phi_1076_ = (((_e804 & 1u) != 0u) != _e249);
                                } else {
                                    phi_1076_ = true;
                                }
                                let _e820 = phi_1076_;
                                phi_1077_ = _e820;
                            }
                            let _e822 = phi_1077_;
                            if _e685.all_remove {
                                if (((_e804 & 1u) != 0u) == _e249) {
                                    if ((_e804 & 2u) != 0u) {
                                        phi_1095_ = (((_e804 & 4u) != 0u) == _e249);
                                    } else {
                                        phi_1095_ = true;
                                    }
                                    let _e832 = phi_1095_;
                                    phi_1096_ = _e832;
                                } else {
                                    phi_1096_ = false;
                                }
                                let _e834 = phi_1096_;
                                phi_1097_ = _e834;
                            } else {
                                phi_1097_ = false;
                            }
                            let _e836 = phi_1097_;
                            phi_894_ = (_e683 + 1u);
                            phi_897_ = lt_mask_Neighbourhood(_e822, _e836);
                        } else {
                            phi_894_ = u32();
                            phi_897_ = lt_mask_Neighbourhood();
                        }
                        let _e840 = phi_894_;
                        let _e842 = phi_897_;
                        continue;
                        continuing {
                            phi_893_ = _e840;
                            phi_896_ = _e842;
                            break if !(_e697);
                        }
                    }
                    let _e1077 = local_1;
                    phi_1100_ = _e1077;
                } else {
                    phi_1100_ = _e672;
                }
                let _e845 = phi_1100_;
                phi_1101_ = _e845;
            } else {
                phi_1101_ = _e672;
            }
            let _e847 = phi_1101_;
            let _e850 = p.member.frame;
            let _e852 = p.member.refresh;
            if (_e852 == 0u) {
                phi_1134_ = false;
            } else {
                if (_e852 == 0u) {
                    return;
                }
                let _e861 = ((_e54.x + (_e54.y * (((_e852 * 5u) / 8u) | 1u))) + (_e850 % _e852));
                if (_e852 == 0u) {
                    phi_1133_ = (_e861 == 0u);
                } else {
                    if (_e852 == 0u) {
                        return;
                    }
                    phi_1133_ = ((_e861 % _e852) == 0u);
                }
                let _e868 = phi_1133_;
                phi_1134_ = _e868;
            }
            let _e870 = phi_1134_;
            if (_e91 != 0.5f) {
                if _e639 {
                    if _e870 {
                        phi_1189_ = 6u;
                    } else {
                        if _e253 {
                            phi_1164_ = true;
                        } else {
                            if _e847.any_expands {
                                phi_1163_ = false;
                            } else {
                                phi_1163_ = true;
                            }
                            let _e874 = phi_1163_;
                            phi_1164_ = _e874;
                        }
                        let _e876 = phi_1164_;
                        if _e876 {
                            if _e253 {
                                if _e671 {
                                    if _e847.all_remove {
                                        phi_1177_ = false;
                                    } else {
                                        phi_1177_ = true;
                                    }
                                    let _e878 = phi_1177_;
                                    phi_1178_ = _e878;
                                } else {
                                    phi_1178_ = true;
                                }
                                let _e880 = phi_1178_;
                                phi_1179_ = _e880;
                            } else {
                                phi_1179_ = true;
                            }
                            let _e882 = phi_1179_;
                            if _e882 {
                                if _e253 {
                                    phi_1186_ = 1u;
                                } else {
                                    phi_1186_ = 0u;
                                }
                                let _e884 = phi_1186_;
                                phi_1187_ = _e884;
                            } else {
                                phi_1187_ = 5u;
                            }
                            let _e886 = phi_1187_;
                            phi_1188_ = _e886;
                        } else {
                            phi_1188_ = 4u;
                        }
                        let _e888 = phi_1188_;
                        phi_1189_ = _e888;
                    }
                    let _e890 = phi_1189_;
                    phi_1190_ = _e890;
                } else {
                    phi_1190_ = 3u;
                }
                let _e892 = phi_1190_;
                phi_1191_ = _e892;
            } else {
                phi_1191_ = 2u;
            }
            let _e894 = phi_1191_;
            if !((_e894 == 0u)) {
                phi_1199_ = !((_e894 == 5u));
            } else {
                phi_1199_ = false;
            }
            let _e900 = phi_1199_;
            if _e900 {
                if _e249 {
                    phi_1207_ = (2u | 1u);
                } else {
                    phi_1207_ = 2u;
                }
                let _e903 = phi_1207_;
                if false {
                    phi_1212_ = (_e903 | 4u);
                } else {
                    phi_1212_ = _e903;
                }
                let _e906 = phi_1212_;
                phi_1217_ = _e906;
            } else {
                if _e249 {
                    phi_1216_ = 1u;
                } else {
                    phi_1216_ = 0u;
                }
                let _e908 = phi_1216_;
                phi_1217_ = _e908;
            }
            let _e910 = phi_1217_;
            if _e249 {
                phi_1221_ = 0f;
            } else {
                phi_1221_ = 1f;
            }
            let _e912 = phi_1221_;
            phi_1223_ = mask_Masked(_e912, _e910, _e900);
        }
        let _e915 = phi_1223_;
        visibility.member[_e70.shift] = _e915.visibility;
        let _e920 = p.member.light.number;
        let _e921 = (_e920 * 3u);
        let _e923 = (_e921 % 32u);
        let _e925 = p.member.light.mask_words;
        let _e927 = ((_e70.shift * _e925) + (_e921 / 32u));
        let _e929 = bits.member[_e927];
        bits.member[_e927] = ((_e929 & ~((7u << bitcast<u32>((_e923 & 31u))))) | (_e915.bits << bitcast<u32>((_e923 & 31u))));
        if (_e923 > 29u) {
            let _e944 = bits.member[(_e927 + 1u)];
            let _e946 = (32u - _e923);
            bits.member[(_e927 + 1u)] = ((_e944 & ~((7u >> bitcast<u32>((_e946 & 31u))))) | (_e915.bits >> bitcast<u32>((_e946 & 31u))));
        }
        phi_1273_ = _e915.needs_ray;
        phi_1274_ = _e70.shift;
    } else {
        phi_1273_ = false;
        phi_1274_ = 0u;
    }
    let _e960 = phi_1273_;
    let _e962 = phi_1274_;
    if (_e55 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e960 {
        let _e966 = atomicAdd((&shared_[0u]), 1u);
        phi_1285_ = _e966;
    } else {
        phi_1285_ = 0u;
    }
    let _e968 = phi_1285_;
    workgroupBarrier();
    if (_e55 == 0u) {
        let _e972 = atomicLoad((&shared_[0u]));
        let _e973 = atomicAdd((&list.member[3u]), _e972);
        atomicStore((&shared_[1u]), _e973);
    }
    workgroupBarrier();
    if _e960 {
        let _e976 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e976) + _e968)]), _e962);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
