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
    var phi_171_: lt_mask_LightPlace;
    var phi_172_: bool;
    var phi_173_: lt_mask_LightPlace;
    var phi_174_: bool;
    var phi_179_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_171_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_172_ = false;
        } else {
            phi_171_ = lt_mask_LightPlace();
            phi_172_ = true;
        }
        let _e67 = phi_171_;
        let _e69 = phi_172_;
        phi_173_ = _e67;
        phi_174_ = _e69;
    } else {
        phi_173_ = lt_mask_LightPlace();
        phi_174_ = true;
    }
    let _e71 = phi_173_;
    let _e73 = phi_174_;
    if _e73 {
        phi_179_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_179_ = _e71;
    }
    let _e78 = phi_179_;
    return lt_mask_LightPlace(_e78.word, _e78.shift);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_197_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_197_ = vec2(0i);
            break;
        }
        case 1: {
            phi_197_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_197_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_197_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_197_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e63 = phi_197_;
    return vec2<i32>(_e63.x, _e63.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_215_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_215_ = vec2(0i);
            break;
        }
        case 1: {
            phi_215_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_215_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_215_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_215_ = vec2(1i);
            break;
        }
    }
    let _e63 = phi_215_;
    return vec2<i32>(_e63.x, _e63.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_234_: vec2<i32>;

    if (param_6 == 0u) {
        let _e57 = lt_mask_pattern_plus(param_5);
        phi_234_ = vec2<i32>(_e57.x, _e57.y);
    } else {
        let _e61 = lt_mask_pattern_cross(param_5);
        phi_234_ = vec2<i32>(_e61.x, _e61.y);
    }
    let _e66 = phi_234_;
    return vec2<i32>(_e66.x, _e66.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_259_: vec2<i32>;

    let _e55 = (param_7 % 13u);
    switch bitcast<i32>(_e55) {
        case 9: {
            phi_259_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_259_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_259_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_259_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_259_ = vec2<i32>((bitcast<i32>((_e55 % 3u)) - 1i), (bitcast<i32>(((_e55 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e70 = phi_259_;
    return vec2<i32>(_e70.x, _e70.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_280_: u32;
    var phi_281_: u32;

    let _e58 = (bitcast<i32>(param_8) + param_9);
    if (_e58 < 0i) {
        phi_281_ = 0u;
    } else {
        if (_e58 >= bitcast<i32>(param_10)) {
            phi_280_ = (param_10 - 1u);
        } else {
            phi_280_ = bitcast<u32>(_e58);
        }
        let _e65 = phi_280_;
        phi_281_ = _e65;
    }
    let _e67 = phi_281_;
    return _e67;
}

fn function_() {
    var phi_353_: bool;
    var phi_354_: bool;
    var phi_355_: bool;
    var phi_356_: bool;
    var phi_360_: bool;
    var phi_430_: bool;
    var phi_431_: bool;
    var phi_442_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_443_: bool;
    var phi_444_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_445_: bool;
    var phi_452_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_456_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_469_: bool;
    var phi_677_: f32;
    var phi_682_: f32;
    var phi_683_: bool;
    var phi_684_: f32;
    var phi_685_: bool;
    var phi_689_: f32;
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
    var phi_844_: bool;
    var phi_845_: bool;
    var phi_847_: bool;
    var phi_848_: lt_mask_Reprojection;
    var phi_849_: lt_mask_Reprojection;
    var phi_850_: bool;
    var phi_854_: bool;
    var phi_855_: lt_mask_Reprojection;
    var phi_861_: bool;
    var phi_883_: u32;
    var phi_885_: u32;
    var phi_888_: lt_mask_Neighbourhood;
    var phi_900_: bool;
    var phi_901_: bool;
    var phi_910_: u32;
    var phi_911_: u32;
    var phi_971_: vec2<i32>;
    var phi_991_: vec2<i32>;
    var phi_1016_: u32;
    var phi_1035_: u32;
    var phi_1043_: u32;
    var phi_1069_: bool;
    var phi_1070_: bool;
    var phi_1071_: bool;
    var phi_1072_: bool;
    var phi_1073_: bool;
    var phi_1074_: bool;
    var phi_1075_: bool;
    var phi_1080_: bool;
    var phi_1081_: bool;
    var phi_1082_: bool;
    var phi_1083_: bool;
    var phi_1084_: bool;
    var phi_1085_: bool;
    var phi_1086_: bool;
    var phi_1087_: bool;
    var phi_1088_: bool;
    var phi_1103_: bool;
    var phi_1104_: bool;
    var phi_1111_: bool;
    var phi_1112_: bool;
    var phi_1113_: bool;
    var phi_1114_: bool;
    var phi_1115_: bool;
    var phi_1119_: bool;
    var phi_1120_: bool;
    var phi_1121_: bool;
    var phi_1125_: bool;
    var phi_1126_: bool;
    var phi_1130_: bool;
    var phi_1131_: bool;
    var phi_1149_: bool;
    var phi_1150_: bool;
    var phi_1151_: bool;
    var phi_886_: u32;
    var phi_889_: lt_mask_Neighbourhood;
    var phi_1154_: lt_mask_Neighbourhood;
    var phi_1155_: lt_mask_Neighbourhood;
    var phi_1156_: lt_mask_Neighbourhood;
    var phi_1188_: bool;
    var phi_1189_: bool;
    var phi_1211_: bool;
    var phi_1212_: bool;
    var phi_1213_: bool;
    var phi_1217_: bool;
    var phi_1239_: bool;
    var phi_1240_: bool;
    var phi_1253_: bool;
    var phi_1254_: bool;
    var phi_1255_: bool;
    var phi_1262_: u32;
    var phi_1263_: u32;
    var phi_1264_: u32;
    var phi_1265_: u32;
    var phi_1266_: u32;
    var phi_1267_: u32;
    var phi_1268_: u32;
    var phi_1280_: bool;
    var phi_1281_: bool;
    var phi_1282_: bool;
    var phi_1283_: bool;
    var phi_1287_: bool;
    var phi_1293_: bool;
    var phi_1301_: u32;
    var phi_1306_: u32;
    var phi_1315_: u32;
    var phi_1320_: u32;
    var phi_1324_: u32;
    var phi_1325_: u32;
    var phi_1326_: u32;
    var phi_1330_: f32;
    var phi_1332_: mask_Masked;
    var phi_1382_: bool;
    var phi_1383_: u32;
    var phi_1394_: u32;
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
                phi_353_ = (_e107 == _e109);
                phi_354_ = false;
            } else {
                phi_353_ = bool();
                phi_354_ = true;
            }
            let _e112 = phi_353_;
            let _e114 = phi_354_;
            phi_355_ = _e112;
            phi_356_ = _e114;
        } else {
            phi_355_ = bool();
            phi_356_ = true;
        }
        let _e116 = phi_355_;
        let _e118 = phi_356_;
        if _e118 {
            phi_360_ = false;
        } else {
            phi_360_ = _e116;
        }
        let _e120 = phi_360_;
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
                    phi_431_ = true;
                } else {
                    let _e173 = p.member.light.range_squared;
                    if (_e156 <= _e173) {
                        let _e176 = p.member.light.cos_outer;
                        phi_430_ = (-((((_e138 * _e158.x) + (_e139 * _e158.y)) + (_e140 * _e158.z))) >= (_e176 * sqrt(_e156)));
                    } else {
                        phi_430_ = false;
                    }
                    let _e181 = phi_430_;
                    phi_431_ = _e181;
                }
                let _e183 = phi_431_;
                if _e183 {
                    let _e185 = samples.member[_e70.shift].flags;
                    let _e193 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e199 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e193.unnamed.visibility, false), _e193.unnamed_1);
                    phi_442_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e199.unnamed, ((_e185 & 1u) == 0u));
                    phi_443_ = false;
                } else {
                    phi_442_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_443_ = true;
                }
                let _e204 = phi_442_;
                let _e206 = phi_443_;
                phi_444_ = _e204;
                phi_445_ = _e206;
            } else {
                phi_444_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_445_ = true;
            }
            let _e208 = phi_444_;
            let _e210 = phi_445_;
            if _e210 {
                let _e216 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e222 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e216.unnamed.visibility, false), _e216.unnamed_1);
                phi_452_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e222.unnamed, true);
            } else {
                phi_452_ = _e208;
            }
            let _e227 = phi_452_;
            phi_456_ = _e227;
        } else {
            let _e233 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e239 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e233.unnamed.visibility, false), _e233.unnamed_1);
            phi_456_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e239.unnamed, true);
        }
        let _e244 = phi_456_;
        if _e244.unnamed_1 {
            phi_1332_ = mask_Masked(_e244.unnamed.visibility, 0u, false);
        } else {
            let _e249 = (_e91 < 0.5f);
            if (_e91 > 0f) {
                phi_469_ = (_e91 < 1f);
            } else {
                phi_469_ = false;
            }
            let _e253 = phi_469_;
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
            let _e417 = p.member.current.grid[0u];
            let _e419 = p.member.current.grid[1u];
            let _e439 = p.member.current.size[0u];
            let _e441 = p.member.current.size[1u];
            let _e443 = ((f32(_e54.x) + ((f32((_e54.y & (_e419 - 1u))) + 0.5f) / f32(_e419))) + _e407);
            if (_e443 > -8388608f) {
                let _e455 = f32(select(0i, select(select(i32(_e443), i32(-2147483648), (_e443 < bitcast<f32>(3472883712u))), 2147483647i, (_e443 > bitcast<f32>(1325400063u))), (_e443 == _e443)));
                if (_e455 > _e443) {
                    phi_677_ = 1f;
                } else {
                    phi_677_ = 0f;
                }
                let _e458 = phi_677_;
                if (_e443 < 8388608f) {
                    phi_682_ = (_e455 - _e458);
                    phi_683_ = false;
                } else {
                    phi_682_ = f32();
                    phi_683_ = true;
                }
                let _e461 = phi_682_;
                let _e463 = phi_683_;
                phi_684_ = _e461;
                phi_685_ = _e463;
            } else {
                phi_684_ = f32();
                phi_685_ = true;
            }
            let _e465 = phi_684_;
            let _e467 = phi_685_;
            if _e467 {
                phi_689_ = _e443;
            } else {
                phi_689_ = _e465;
            }
            let _e469 = phi_689_;
            let _e470 = ((f32(_e54.y) + ((f32((_e54.x & (_e417 - 1u))) + 0.5f) / f32(_e417))) + _e413);
            if (_e470 > -8388608f) {
                let _e482 = f32(select(0i, select(select(i32(_e470), i32(-2147483648), (_e470 < bitcast<f32>(3472883712u))), 2147483647i, (_e470 > bitcast<f32>(1325400063u))), (_e470 == _e470)));
                if (_e482 > _e470) {
                    phi_710_ = 1f;
                } else {
                    phi_710_ = 0f;
                }
                let _e485 = phi_710_;
                if (_e470 < 8388608f) {
                    phi_715_ = (_e482 - _e485);
                    phi_716_ = false;
                } else {
                    phi_715_ = f32();
                    phi_716_ = true;
                }
                let _e488 = phi_715_;
                let _e490 = phi_716_;
                phi_717_ = _e488;
                phi_718_ = _e490;
            } else {
                phi_717_ = f32();
                phi_718_ = true;
            }
            let _e492 = phi_717_;
            let _e494 = phi_718_;
            if _e494 {
                phi_722_ = _e470;
            } else {
                phi_722_ = _e492;
            }
            let _e496 = phi_722_;
            if (_e469 >= 0f) {
                if (_e496 >= 0f) {
                    if (_e469 < f32(_e439)) {
                        let _e502 = (_e496 < f32(_e441));
                        if (_e407 == 0f) {
                            phi_743_ = (_e413 == 0f);
                        } else {
                            phi_743_ = false;
                        }
                        let _e506 = phi_743_;
                        if _e502 {
                            phi_762_ = vec2<u32>(select(select(u32(_e469), 0u, (_e469 < bitcast<f32>(0u))), 4294967295u, (_e469 > bitcast<f32>(1333788671u))), select(select(u32(_e496), 0u, (_e496 < bitcast<f32>(0u))), 4294967295u, (_e496 > bitcast<f32>(1333788671u))));
                            phi_763_ = false;
                        } else {
                            phi_762_ = vec2<u32>();
                            phi_763_ = true;
                        }
                        let _e523 = phi_762_;
                        let _e525 = phi_763_;
                        phi_764_ = _e506;
                        phi_765_ = _e502;
                        phi_766_ = _e523;
                        phi_767_ = _e506;
                        phi_768_ = _e502;
                        phi_769_ = false;
                        phi_770_ = _e525;
                    } else {
                        phi_764_ = bool();
                        phi_765_ = bool();
                        phi_766_ = vec2<u32>();
                        phi_767_ = bool();
                        phi_768_ = bool();
                        phi_769_ = true;
                        phi_770_ = false;
                    }
                    let _e527 = phi_764_;
                    let _e529 = phi_765_;
                    let _e531 = phi_766_;
                    let _e533 = phi_767_;
                    let _e535 = phi_768_;
                    let _e537 = phi_769_;
                    let _e539 = phi_770_;
                    phi_771_ = _e527;
                    phi_772_ = _e529;
                    phi_773_ = _e531;
                    phi_774_ = _e533;
                    phi_775_ = _e535;
                    phi_776_ = _e537;
                    phi_777_ = _e539;
                } else {
                    phi_771_ = bool();
                    phi_772_ = bool();
                    phi_773_ = vec2<u32>();
                    phi_774_ = bool();
                    phi_775_ = bool();
                    phi_776_ = true;
                    phi_777_ = false;
                }
                let _e541 = phi_771_;
                let _e543 = phi_772_;
                let _e545 = phi_773_;
                let _e547 = phi_774_;
                let _e549 = phi_775_;
                let _e551 = phi_776_;
                let _e553 = phi_777_;
                phi_778_ = _e541;
                phi_779_ = _e543;
                phi_780_ = _e545;
                phi_781_ = _e547;
                phi_782_ = _e549;
                phi_783_ = _e551;
                phi_784_ = _e553;
            } else {
                phi_778_ = bool();
                phi_779_ = bool();
                phi_780_ = vec2<u32>();
                phi_781_ = bool();
                phi_782_ = bool();
                phi_783_ = true;
                phi_784_ = false;
            }
            let _e555 = phi_778_;
            let _e557 = phi_779_;
            let _e559 = phi_780_;
            let _e561 = phi_781_;
            let _e563 = phi_782_;
            let _e565 = phi_783_;
            let _e567 = phi_784_;
            if _e565 {
                if (_e407 == 0f) {
                    phi_793_ = (_e413 == 0f);
                } else {
                    phi_793_ = false;
                }
                let _e571 = phi_793_;
                phi_794_ = _e571;
                phi_795_ = false;
                phi_796_ = true;
            } else {
                phi_794_ = _e561;
                phi_795_ = _e563;
                phi_796_ = _e567;
            }
            let _e573 = phi_794_;
            let _e575 = phi_795_;
            let _e577 = phi_796_;
            if _e577 {
                phi_800_ = _e573;
                phi_801_ = _e575;
                phi_802_ = vec2<u32>(_e54.x, _e54.y);
            } else {
                phi_800_ = _e555;
                phi_801_ = _e557;
                phi_802_ = _e559;
            }
            let _e579 = phi_800_;
            let _e581 = phi_801_;
            let _e583 = phi_802_;
            let _e593 = lt_mask_Reprojection(vec2<u32>(_e583.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e600 = lt_mask_Reprojection(vec2<u32>(_e593.pixel.x, _e583.y), _e593.is_valid, _e593.has_moved);
            let _e604 = lt_mask_Reprojection(_e600.pixel, _e581, _e600.has_moved);
            let _e608 = lt_mask_Reprojection(_e604.pixel, _e604.is_valid, !(_e579));
            if _e581 {
                let _e611 = p.member.previous.eye;
                let _e622 = p.member.previous.forward;
                let _e631 = (((((_e89.x - _e611.x) * _e622.x) + ((_e89.y - _e611.y) * _e622.y)) + ((_e89.z - _e611.z) * _e622.z)) > 0f);
                let _e635 = lt_mask_Reprojection(_e608.pixel, _e631, _e608.has_moved);
                if _e631 {
                    let _e637 = p.member.flags;
                    phi_844_ = ((_e637 & 1u) != 0u);
                    phi_845_ = false;
                } else {
                    phi_844_ = bool();
                    phi_845_ = true;
                }
                let _e641 = phi_844_;
                let _e643 = phi_845_;
                phi_847_ = _e641;
                phi_848_ = _e635;
                phi_849_ = _e635;
                phi_850_ = _e643;
            } else {
                phi_847_ = bool();
                phi_848_ = lt_mask_Reprojection();
                phi_849_ = lt_mask_Reprojection(_e608.pixel, false, _e608.has_moved);
                phi_850_ = true;
            }
            let _e649 = phi_847_;
            let _e651 = phi_848_;
            let _e653 = phi_849_;
            let _e655 = phi_850_;
            if _e655 {
                phi_854_ = false;
                phi_855_ = _e653;
            } else {
                phi_854_ = _e649;
                phi_855_ = _e651;
            }
            let _e657 = phi_854_;
            let _e659 = phi_855_;
            let _e663 = lt_mask_Reprojection(_e659.pixel, _e657, _e659.has_moved);
            let _e664 = lt_mask_Neighbourhood(false, true);
            if _e253 {
                phi_861_ = false;
            } else {
                phi_861_ = true;
            }
            let _e666 = phi_861_;
            if _e666 {
                if _e657 {
                    if ((0u & 2u) != 0u) {
                        phi_1154_ = _e664;
                    } else {
                        let _e670 = p.member.expansion;
                        if _e663.has_moved {
                            let _e673 = p.member.moving_pattern;
                            phi_883_ = _e673;
                        } else {
                            let _e675 = p.member.still_pattern;
                            phi_883_ = _e675;
                        }
                        let _e677 = phi_883_;
                        phi_885_ = 0u;
                        phi_888_ = _e664;
                        loop {
                            let _e679 = phi_885_;
                            let _e681 = phi_888_;
                            local_1 = _e681;
                            if (1u <= _e677) {
                                if (_e677 <= 4u) {
                                    phi_900_ = false;
                                } else {
                                    phi_900_ = true;
                                }
                                let _e685 = phi_900_;
                                phi_901_ = _e685;
                            } else {
                                phi_901_ = true;
                            }
                            let _e687 = phi_901_;
                            if _e687 {
                                switch bitcast<i32>(_e677) {
                                    case 5: {
                                        phi_910_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_910_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_910_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_910_ = 9u;
                                        break;
                                    }
                                }
                                let _e690 = phi_910_;
                                phi_911_ = _e690;
                            } else {
                                phi_911_ = 5u;
                            }
                            let _e692 = phi_911_;
                            let _e693 = (_e679 < _e692);
                            if _e693 {
                                let _e699 = p.member.frame;
                                let _e703 = p.member.current.size[0u];
                                let _e705 = p.member.current.size[1u];
                                switch bitcast<i32>(_e677) {
                                    case 1: {
                                        let _e715 = lt_mask_pattern_plus(_e679);
                                        phi_991_ = vec2<i32>(_e715.x, _e715.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e719 = lt_mask_pattern_cross(_e679);
                                        phi_991_ = vec2<i32>(_e719.x, _e719.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e725 = lt_mask_pattern_plus_or_cross(_e679, ((_e663.pixel.x + _e663.pixel.y) & 1u));
                                        phi_991_ = vec2<i32>(_e725.x, _e725.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e730 = lt_mask_pattern_plus_or_cross(_e679, (_e699 & 1u));
                                        phi_991_ = vec2<i32>(_e730.x, _e730.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e699 & 3u)) {
                                            case 0: {
                                                phi_971_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_971_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_971_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_971_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e741 = phi_971_;
                                        phi_991_ = (_e741 + vec2<i32>(bitcast<i32>((_e679 & 1u)), bitcast<i32>(((_e679 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_991_ = vec2<i32>((bitcast<i32>((_e679 % 5u)) - 2i), (bitcast<i32>(((_e679 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e758 = lt_mask_pattern_diamond(_e679);
                                        phi_991_ = vec2<i32>(_e758.x, _e758.y);
                                        break;
                                    }
                                    default: {
                                        phi_991_ = vec2<i32>((bitcast<i32>((_e679 % 3u)) - 1i), (bitcast<i32>(((_e679 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e763 = phi_991_;
                                let _e766 = lt_mask_pattern_step_clamped(_e663.pixel.x, _e763.x, _e703);
                                let _e767 = lt_mask_pattern_step_clamped(_e663.pixel.y, _e763.y, _e705);
                                let _e771 = ((((_e767 * _e86) + _e766) * _e82) + (_e78 / 32u));
                                if (_e80 > 29u) {
                                    let _e773 = (_e771 + 1u);
                                    if (_e773 < _e60) {
                                    } else {
                                        return;
                                    }
                                    let _e777 = last_bits.member[(0u + _e773)];
                                    phi_1016_ = _e777;
                                } else {
                                    phi_1016_ = 0u;
                                }
                                let _e779 = phi_1016_;
                                if (_e771 < _e60) {
                                } else {
                                    return;
                                }
                                let _e783 = last_bits.member[(0u + _e771)];
                                let _e786 = (_e783 >> bitcast<u32>((_e80 & 31u)));
                                if (_e80 > 29u) {
                                    phi_1035_ = (_e786 | (_e779 << bitcast<u32>(((32u - _e80) & 31u))));
                                } else {
                                    phi_1035_ = _e786;
                                }
                                let _e794 = phi_1035_;
                                if ((_e794 & 2u) == 0u) {
                                    phi_1043_ = (_e794 & 1u);
                                } else {
                                    phi_1043_ = (_e794 & 7u);
                                }
                                let _e800 = phi_1043_;
                                if _e681.any_expands {
                                    phi_1131_ = true;
                                } else {
                                    if ((_e800 & 2u) != 0u) {
                                        let _e807 = (((_e800 & 4u) != 0u) != _e249);
                                        switch bitcast<i32>(_e670) {
                                            case 1: {
                                                phi_1071_ = bool();
                                                phi_1072_ = false;
                                                phi_1073_ = true;
                                                phi_1074_ = false;
                                                phi_1075_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e807 {
                                                    phi_1069_ = (((_e800 & 4u) != 0u) != ((_e800 & 1u) != 0u));
                                                    phi_1070_ = false;
                                                } else {
                                                    phi_1069_ = bool();
                                                    phi_1070_ = true;
                                                }
                                                let _e815 = phi_1069_;
                                                let _e817 = phi_1070_;
                                                phi_1071_ = _e815;
                                                phi_1072_ = false;
                                                phi_1073_ = false;
                                                phi_1074_ = _e817;
                                                phi_1075_ = _e807;
                                                break;
                                            }
                                            default: {
                                                phi_1071_ = bool();
                                                phi_1072_ = true;
                                                phi_1073_ = false;
                                                phi_1074_ = false;
                                                phi_1075_ = false;
                                                break;
                                            }
                                        }
                                        let _e819 = phi_1071_;
                                        let _e821 = phi_1072_;
                                        let _e823 = phi_1073_;
                                        let _e825 = phi_1074_;
                                        let _e827 = phi_1075_;
                                        phi_1083_ = _e807;
                                        phi_1084_ = _e819;
                                        phi_1085_ = _e821;
                                        phi_1086_ = _e823;
                                        phi_1087_ = _e825;
                                        phi_1088_ = _e827;
                                    } else {
                                        switch bitcast<i32>(_e670) {
                                            case 1: {
                                                phi_1080_ = false;
                                                phi_1081_ = true;
                                                phi_1082_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_1080_ = false;
                                                phi_1081_ = false;
                                                phi_1082_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_1080_ = true;
                                                phi_1081_ = false;
                                                phi_1082_ = false;
                                                break;
                                            }
                                        }
                                        let _e830 = phi_1080_;
                                        let _e832 = phi_1081_;
                                        let _e834 = phi_1082_;
                                        phi_1083_ = false;
                                        phi_1084_ = bool();
                                        phi_1085_ = _e830;
                                        phi_1086_ = _e832;
                                        phi_1087_ = _e834;
                                        phi_1088_ = false;
                                    }
                                    let _e836 = phi_1083_;
                                    let _e838 = phi_1084_;
                                    let _e840 = phi_1085_;
                                    let _e842 = phi_1086_;
                                    let _e844 = phi_1087_;
                                    let _e846 = phi_1088_;
                                    if _e840 {
                                        if ((_e800 & 2u) != 0u) {
                                            if (((_e800 & 4u) != 0u) != _e249) {
                                                phi_1103_ = false;
                                            } else {
                                                phi_1103_ = true;
                                            }
                                            let _e853 = phi_1103_;
                                            phi_1104_ = _e853;
                                        } else {
                                            phi_1104_ = true;
                                        }
                                        let _e855 = phi_1104_;
                                        if _e855 {
                                            phi_1111_ = (((_e800 & 1u) != 0u) != _e249);
                                        } else {
                                            phi_1111_ = true;
                                        }
                                        let _e860 = phi_1111_;
                                        phi_1112_ = _e860;
                                        phi_1113_ = false;
                                        phi_1114_ = false;
                                        phi_1115_ = false;
                                    } else {
                                        phi_1112_ = bool();
                                        phi_1113_ = _e842;
                                        phi_1114_ = _e844;
                                        phi_1115_ = _e846;
                                    }
                                    let _e862 = phi_1112_;
                                    let _e864 = phi_1113_;
                                    let _e866 = phi_1114_;
                                    let _e868 = phi_1115_;
                                    if _e864 {
                                        phi_1119_ = _e836;
                                        phi_1120_ = false;
                                        phi_1121_ = false;
                                    } else {
                                        phi_1119_ = _e862;
                                        phi_1120_ = _e866;
                                        phi_1121_ = _e868;
                                    }
                                    let _e870 = phi_1119_;
                                    let _e872 = phi_1120_;
                                    let _e874 = phi_1121_;
                                    if _e872 {
                                        phi_1125_ = false;
                                        phi_1126_ = true;
                                    } else {
                                        phi_1125_ = _e838;
                                        phi_1126_ = _e874;
                                    }
                                    let _e876 = phi_1125_;
                                    let _e878 = phi_1126_;
                                    if _e878 {
                                        phi_1130_ = _e876;
                                    } else {
                                        phi_1130_ = _e870;
                                    }
                                    let _e880 = phi_1130_;
                                    phi_1131_ = _e880;
                                }
                                let _e882 = phi_1131_;
                                if _e681.all_remove {
                                    if (((_e800 & 1u) != 0u) == _e249) {
                                        if ((_e800 & 2u) != 0u) {
                                            phi_1149_ = (((_e800 & 4u) != 0u) == _e249);
                                        } else {
                                            phi_1149_ = true;
                                        }
                                        let _e892 = phi_1149_;
                                        phi_1150_ = _e892;
                                    } else {
                                        phi_1150_ = false;
                                    }
                                    let _e894 = phi_1150_;
                                    phi_1151_ = _e894;
                                } else {
                                    phi_1151_ = false;
                                }
                                let _e896 = phi_1151_;
                                phi_886_ = (_e679 + 1u);
                                phi_889_ = lt_mask_Neighbourhood(_e882, _e896);
                            } else {
                                phi_886_ = u32();
                                phi_889_ = lt_mask_Neighbourhood();
                            }
                            let _e900 = phi_886_;
                            let _e902 = phi_889_;
                            continue;
                            continuing {
                                phi_885_ = _e900;
                                phi_888_ = _e902;
                                break if !(_e693);
                            }
                        }
                        let _e1191 = local_1;
                        phi_1154_ = _e1191;
                    }
                    let _e905 = phi_1154_;
                    phi_1155_ = _e905;
                } else {
                    phi_1155_ = _e664;
                }
                let _e907 = phi_1155_;
                phi_1156_ = _e907;
            } else {
                phi_1156_ = _e664;
            }
            let _e909 = phi_1156_;
            let _e912 = p.member.frame;
            let _e914 = p.member.refresh;
            if (_e914 == 0u) {
                phi_1189_ = false;
            } else {
                if (_e914 == 0u) {
                    return;
                }
                let _e923 = ((_e54.x + (_e54.y * (((_e914 * 5u) / 8u) | 1u))) + (_e912 % _e914));
                if (_e914 == 0u) {
                    phi_1188_ = (_e923 == 0u);
                } else {
                    if (_e914 == 0u) {
                        return;
                    }
                    phi_1188_ = ((_e923 % _e914) == 0u);
                }
                let _e930 = phi_1188_;
                phi_1189_ = _e930;
            }
            let _e932 = phi_1189_;
            if _e657 {
                if _e932 {
                    phi_1211_ = bool();
                } else {
                    phi_1211_ = ((0u & 2u) != 0u);
                }
                let _e938 = phi_1211_;
                phi_1212_ = _e938;
                phi_1213_ = _e932;
            } else {
                phi_1212_ = bool();
                phi_1213_ = true;
            }
            let _e940 = phi_1212_;
            let _e942 = phi_1213_;
            if _e942 {
                phi_1217_ = false;
            } else {
                phi_1217_ = _e940;
            }
            let _e944 = phi_1217_;
            if _e944 {
                phi_1268_ = 7u;
            } else {
                if (_e91 != 0.5f) {
                    if _e657 {
                        if _e932 {
                            phi_1265_ = 6u;
                        } else {
                            if _e253 {
                                phi_1240_ = true;
                            } else {
                                if _e909.any_expands {
                                    phi_1239_ = false;
                                } else {
                                    phi_1239_ = true;
                                }
                                let _e946 = phi_1239_;
                                phi_1240_ = _e946;
                            }
                            let _e948 = phi_1240_;
                            if _e948 {
                                if _e253 {
                                    if false {
                                        if _e909.all_remove {
                                            phi_1253_ = false;
                                        } else {
                                            phi_1253_ = true;
                                        }
                                        let _e950 = phi_1253_;
                                        phi_1254_ = _e950;
                                    } else {
                                        phi_1254_ = true;
                                    }
                                    let _e952 = phi_1254_;
                                    phi_1255_ = _e952;
                                } else {
                                    phi_1255_ = true;
                                }
                                let _e954 = phi_1255_;
                                if _e954 {
                                    if _e253 {
                                        phi_1262_ = 1u;
                                    } else {
                                        phi_1262_ = 0u;
                                    }
                                    let _e956 = phi_1262_;
                                    phi_1263_ = _e956;
                                } else {
                                    phi_1263_ = 5u;
                                }
                                let _e958 = phi_1263_;
                                phi_1264_ = _e958;
                            } else {
                                phi_1264_ = 4u;
                            }
                            let _e960 = phi_1264_;
                            phi_1265_ = _e960;
                        }
                        let _e962 = phi_1265_;
                        phi_1266_ = _e962;
                    } else {
                        phi_1266_ = 3u;
                    }
                    let _e964 = phi_1266_;
                    phi_1267_ = _e964;
                } else {
                    phi_1267_ = 2u;
                }
                let _e966 = phi_1267_;
                phi_1268_ = _e966;
            }
            let _e968 = phi_1268_;
            if !((_e968 == 0u)) {
                if !((_e968 == 5u)) {
                    phi_1280_ = !(_e944);
                    phi_1281_ = false;
                } else {
                    phi_1280_ = bool();
                    phi_1281_ = true;
                }
                let _e975 = phi_1280_;
                let _e977 = phi_1281_;
                phi_1282_ = _e975;
                phi_1283_ = _e977;
            } else {
                phi_1282_ = bool();
                phi_1283_ = true;
            }
            let _e979 = phi_1282_;
            let _e981 = phi_1283_;
            if _e981 {
                phi_1287_ = false;
            } else {
                phi_1287_ = _e979;
            }
            let _e983 = phi_1287_;
            if _e944 {
                phi_1293_ = ((0u & 4u) != 0u);
            } else {
                phi_1293_ = _e249;
            }
            let _e987 = phi_1293_;
            if _e983 {
                if _e249 {
                    phi_1301_ = (2u | 1u);
                } else {
                    phi_1301_ = 2u;
                }
                let _e990 = phi_1301_;
                if false {
                    phi_1306_ = (_e990 | 4u);
                } else {
                    phi_1306_ = _e990;
                }
                let _e993 = phi_1306_;
                phi_1326_ = _e993;
            } else {
                if (_e968 == 7u) {
                    if _e249 {
                        phi_1315_ = (2u | 1u);
                    } else {
                        phi_1315_ = 2u;
                    }
                    let _e997 = phi_1315_;
                    if _e987 {
                        phi_1320_ = (_e997 | 4u);
                    } else {
                        phi_1320_ = _e997;
                    }
                    let _e1000 = phi_1320_;
                    phi_1325_ = _e1000;
                } else {
                    if _e249 {
                        phi_1324_ = 1u;
                    } else {
                        phi_1324_ = 0u;
                    }
                    let _e1002 = phi_1324_;
                    phi_1325_ = _e1002;
                }
                let _e1004 = phi_1325_;
                phi_1326_ = _e1004;
            }
            let _e1006 = phi_1326_;
            if _e987 {
                phi_1330_ = 0f;
            } else {
                phi_1330_ = 1f;
            }
            let _e1008 = phi_1330_;
            phi_1332_ = mask_Masked(_e1008, _e1006, _e983);
        }
        let _e1011 = phi_1332_;
        visibility.member[_e70.shift] = _e1011.visibility;
        let _e1016 = p.member.light.number;
        let _e1017 = (_e1016 * 3u);
        let _e1019 = (_e1017 % 32u);
        let _e1021 = p.member.light.mask_words;
        let _e1023 = ((_e70.shift * _e1021) + (_e1017 / 32u));
        let _e1025 = bits.member[_e1023];
        bits.member[_e1023] = ((_e1025 & ~((7u << bitcast<u32>((_e1019 & 31u))))) | (_e1011.bits << bitcast<u32>((_e1019 & 31u))));
        if (_e1019 > 29u) {
            let _e1040 = bits.member[(_e1023 + 1u)];
            let _e1042 = (32u - _e1019);
            bits.member[(_e1023 + 1u)] = ((_e1040 & ~((7u >> bitcast<u32>((_e1042 & 31u))))) | (_e1011.bits >> bitcast<u32>((_e1042 & 31u))));
        }
        phi_1382_ = _e1011.needs_ray;
        phi_1383_ = _e70.shift;
    } else {
        phi_1382_ = false;
        phi_1383_ = 0u;
    }
    let _e1056 = phi_1382_;
    let _e1058 = phi_1383_;
    if (_e55 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1056 {
        let _e1062 = atomicAdd((&shared_[0u]), 1u);
        phi_1394_ = _e1062;
    } else {
        phi_1394_ = 0u;
    }
    let _e1064 = phi_1394_;
    workgroupBarrier();
    if (_e55 == 0u) {
        let _e1068 = atomicLoad((&shared_[0u]));
        let _e1069 = atomicAdd((&list.member[3u]), _e1068);
        atomicStore((&shared_[1u]), _e1069);
    }
    workgroupBarrier();
    if _e1056 {
        let _e1072 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1072) + _e1064)]), _e1058);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
