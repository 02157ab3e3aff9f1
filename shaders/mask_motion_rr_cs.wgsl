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
    var phi_869_: bool;
    var phi_880_: bool;
    var phi_881_: bool;
    var phi_882_: bool;
    var phi_883_: bool;
    var phi_884_: bool;
    var phi_885_: bool;
    var phi_889_: bool;
    var phi_894_: bool;
    var phi_909_: u32;
    var phi_911_: u32;
    var phi_914_: lt_mask_Neighbourhood;
    var phi_926_: bool;
    var phi_927_: bool;
    var phi_936_: u32;
    var phi_937_: u32;
    var phi_997_: vec2<i32>;
    var phi_1017_: vec2<i32>;
    var phi_1042_: u32;
    var phi_1061_: u32;
    var phi_1069_: u32;
    var phi_1086_: bool;
    var phi_1087_: bool;
    var phi_1094_: bool;
    var phi_1095_: bool;
    var phi_1113_: bool;
    var phi_1114_: bool;
    var phi_1115_: bool;
    var phi_912_: u32;
    var phi_915_: lt_mask_Neighbourhood;
    var phi_1118_: lt_mask_Neighbourhood;
    var phi_1119_: lt_mask_Neighbourhood;
    var phi_1151_: bool;
    var phi_1152_: bool;
    var phi_1181_: bool;
    var phi_1182_: bool;
    var phi_1195_: bool;
    var phi_1196_: bool;
    var phi_1197_: bool;
    var phi_1204_: u32;
    var phi_1205_: u32;
    var phi_1206_: u32;
    var phi_1207_: u32;
    var phi_1208_: u32;
    var phi_1209_: u32;
    var phi_1217_: bool;
    var phi_1225_: u32;
    var phi_1230_: u32;
    var phi_1234_: u32;
    var phi_1235_: u32;
    var phi_1239_: f32;
    var phi_1241_: mask_Masked;
    var phi_1291_: bool;
    var phi_1292_: u32;
    var phi_1303_: u32;
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
            phi_1241_ = mask_Masked(_e244.unnamed.visibility, 0u, false);
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
            let _e665 = p.member.flags;
            if _e663.has_moved {
                let _e670 = p.member.flags;
                phi_869_ = ((_e670 & 4u) == 0u);
            } else {
                phi_869_ = false;
            }
            let _e674 = phi_869_;
            if ((_e665 & 2u) != 0u) {
                if false {
                    phi_882_ = bool();
                    phi_883_ = true;
                } else {
                    if true {
                        phi_880_ = !(_e674);
                        phi_881_ = false;
                    } else {
                        phi_880_ = bool();
                        phi_881_ = true;
                    }
                    let _e677 = phi_880_;
                    let _e679 = phi_881_;
                    phi_882_ = _e677;
                    phi_883_ = _e679;
                }
                let _e681 = phi_882_;
                let _e683 = phi_883_;
                phi_884_ = _e681;
                phi_885_ = _e683;
            } else {
                phi_884_ = bool();
                phi_885_ = true;
            }
            let _e685 = phi_884_;
            let _e687 = phi_885_;
            if _e687 {
                phi_889_ = false;
            } else {
                phi_889_ = _e685;
            }
            let _e689 = phi_889_;
            let _e690 = lt_mask_Neighbourhood(false, true);
            if _e253 {
                phi_894_ = _e689;
            } else {
                phi_894_ = false;
            }
            let _e692 = phi_894_;
            if _e692 {
                if _e657 {
                    if _e663.has_moved {
                        let _e695 = p.member.moving_pattern;
                        phi_909_ = _e695;
                    } else {
                        let _e697 = p.member.still_pattern;
                        phi_909_ = _e697;
                    }
                    let _e699 = phi_909_;
                    phi_911_ = 0u;
                    phi_914_ = _e690;
                    loop {
                        let _e701 = phi_911_;
                        let _e703 = phi_914_;
                        local_1 = _e703;
                        if (1u <= _e699) {
                            if (_e699 <= 4u) {
                                phi_926_ = false;
                            } else {
                                phi_926_ = true;
                            }
                            let _e707 = phi_926_;
                            phi_927_ = _e707;
                        } else {
                            phi_927_ = true;
                        }
                        let _e709 = phi_927_;
                        if _e709 {
                            switch bitcast<i32>(_e699) {
                                case 5: {
                                    phi_936_ = 4u;
                                    break;
                                }
                                case 6: {
                                    phi_936_ = 25u;
                                    break;
                                }
                                case 7: {
                                    phi_936_ = 13u;
                                    break;
                                }
                                default: {
                                    phi_936_ = 9u;
                                    break;
                                }
                            }
                            let _e712 = phi_936_;
                            phi_937_ = _e712;
                        } else {
                            phi_937_ = 5u;
                        }
                        let _e714 = phi_937_;
                        let _e715 = (_e701 < _e714);
                        if _e715 {
                            let _e721 = p.member.frame;
                            let _e725 = p.member.current.size[0u];
                            let _e727 = p.member.current.size[1u];
                            switch bitcast<i32>(_e699) {
                                case 1: {
                                    let _e737 = lt_mask_pattern_plus(_e701);
                                    phi_1017_ = vec2<i32>(_e737.x, _e737.y);
                                    break;
                                }
                                case 2: {
                                    let _e741 = lt_mask_pattern_cross(_e701);
                                    phi_1017_ = vec2<i32>(_e741.x, _e741.y);
                                    break;
                                }
                                case 3: {
                                    let _e747 = lt_mask_pattern_plus_or_cross(_e701, ((_e663.pixel.x + _e663.pixel.y) & 1u));
                                    phi_1017_ = vec2<i32>(_e747.x, _e747.y);
                                    break;
                                }
                                case 4: {
                                    let _e752 = lt_mask_pattern_plus_or_cross(_e701, (_e721 & 1u));
                                    phi_1017_ = vec2<i32>(_e752.x, _e752.y);
                                    break;
                                }
                                case 5: {
                                    switch bitcast<i32>((_e721 & 3u)) {
                                        case 0: {
                                            phi_997_ = vec2(-1i);
                                            break;
                                        }
                                        case 1: {
                                            phi_997_ = vec2(0i);
                                            break;
                                        }
                                        case 2: {
                                            phi_997_ = vec2<i32>(0i, -1i);
                                            break;
                                        }
                                        default: {
                                            phi_997_ = vec2<i32>(-1i, 0i);
                                            break;
                                        }
                                    }
                                    let _e763 = phi_997_;
                                    phi_1017_ = (_e763 + vec2<i32>(bitcast<i32>((_e701 & 1u)), bitcast<i32>(((_e701 >> bitcast<u32>(1i)) & 1u))));
                                    break;
                                }
                                case 6: {
                                    phi_1017_ = vec2<i32>((bitcast<i32>((_e701 % 5u)) - 2i), (bitcast<i32>(((_e701 / 5u) % 5u)) - 2i));
                                    break;
                                }
                                case 7: {
                                    let _e780 = lt_mask_pattern_diamond(_e701);
                                    phi_1017_ = vec2<i32>(_e780.x, _e780.y);
                                    break;
                                }
                                default: {
                                    phi_1017_ = vec2<i32>((bitcast<i32>((_e701 % 3u)) - 1i), (bitcast<i32>(((_e701 / 3u) % 3u)) - 1i));
                                    break;
                                }
                            }
                            let _e785 = phi_1017_;
                            let _e788 = lt_mask_pattern_step_clamped(_e663.pixel.x, _e785.x, _e725);
                            let _e789 = lt_mask_pattern_step_clamped(_e663.pixel.y, _e785.y, _e727);
                            let _e793 = ((((_e789 * _e86) + _e788) * _e82) + (_e78 / 32u));
                            if (_e80 > 29u) {
                                let _e795 = (_e793 + 1u);
                                if (_e795 < _e60) {
                                } else {
                                    return;
                                }
                                let _e799 = last_bits.member[(0u + _e795)];
                                phi_1042_ = _e799;
                            } else {
                                phi_1042_ = 0u;
                            }
                            let _e801 = phi_1042_;
                            if (_e793 < _e60) {
                            } else {
                                return;
                            }
                            let _e805 = last_bits.member[(0u + _e793)];
                            let _e808 = (_e805 >> bitcast<u32>((_e80 & 31u)));
                            if (_e80 > 29u) {
                                phi_1061_ = (_e808 | (_e801 << bitcast<u32>(((32u - _e80) & 31u))));
                            } else {
                                phi_1061_ = _e808;
                            }
                            let _e816 = phi_1061_;
                            if ((_e816 & 2u) == 0u) {
                                phi_1069_ = (_e816 & 1u);
                            } else {
                                phi_1069_ = (_e816 & 7u);
                            }
                            let _e822 = phi_1069_;
                            if _e703.any_expands {
                                phi_1095_ = true;
                            } else {
                                if ((_e822 & 2u) != 0u) {
                                    if (((_e822 & 4u) != 0u) != _e249) {
                                        phi_1086_ = false;
                                    } else {
                                        phi_1086_ = true;
                                    }
                                    let _e831 = phi_1086_;
                                    phi_1087_ = _e831;
                                } else {
                                    phi_1087_ = true;
                                }
                                let _e833 = phi_1087_;
                                if _e833 {
                                    phi_1094_ = (((_e822 & 1u) != 0u) != _e249);
                                } else {
                                    phi_1094_ = true;
                                }
                                let _e838 = phi_1094_;
                                phi_1095_ = _e838;
                            }
                            let _e840 = phi_1095_;
                            if _e703.all_remove {
                                if (((_e822 & 1u) != 0u) == _e249) {
                                    if ((_e822 & 2u) != 0u) {
                                        phi_1113_ = (((_e822 & 4u) != 0u) == _e249);
                                    } else {
                                        phi_1113_ = true;
                                    }
                                    let _e850 = phi_1113_;
                                    phi_1114_ = _e850;
                                } else {
                                    phi_1114_ = false;
                                }
                                let _e852 = phi_1114_;
                                phi_1115_ = _e852;
                            } else {
                                phi_1115_ = false;
                            }
                            let _e854 = phi_1115_;
                            phi_912_ = (_e701 + 1u);
                            phi_915_ = lt_mask_Neighbourhood(_e840, _e854);
                        } else {
                            phi_912_ = u32();
                            phi_915_ = lt_mask_Neighbourhood();
                        }
                        let _e858 = phi_912_;
                        let _e860 = phi_915_;
                        continue;
                        continuing {
                            phi_911_ = _e858;
                            phi_914_ = _e860;
                            break if !(_e715);
                        }
                    }
                    let _e1095 = local_1;
                    phi_1118_ = _e1095;
                } else {
                    phi_1118_ = _e690;
                }
                let _e863 = phi_1118_;
                phi_1119_ = _e863;
            } else {
                phi_1119_ = _e690;
            }
            let _e865 = phi_1119_;
            let _e868 = p.member.frame;
            let _e870 = p.member.refresh;
            if (_e870 == 0u) {
                phi_1152_ = false;
            } else {
                if (_e870 == 0u) {
                    return;
                }
                let _e879 = ((_e54.x + (_e54.y * (((_e870 * 5u) / 8u) | 1u))) + (_e868 % _e870));
                if (_e870 == 0u) {
                    phi_1151_ = (_e879 == 0u);
                } else {
                    if (_e870 == 0u) {
                        return;
                    }
                    phi_1151_ = ((_e879 % _e870) == 0u);
                }
                let _e886 = phi_1151_;
                phi_1152_ = _e886;
            }
            let _e888 = phi_1152_;
            if (_e91 != 0.5f) {
                if _e657 {
                    if _e888 {
                        phi_1207_ = 6u;
                    } else {
                        if _e253 {
                            phi_1182_ = true;
                        } else {
                            if _e865.any_expands {
                                phi_1181_ = false;
                            } else {
                                phi_1181_ = true;
                            }
                            let _e892 = phi_1181_;
                            phi_1182_ = _e892;
                        }
                        let _e894 = phi_1182_;
                        if _e894 {
                            if _e253 {
                                if _e689 {
                                    if _e865.all_remove {
                                        phi_1195_ = false;
                                    } else {
                                        phi_1195_ = true;
                                    }
                                    let _e896 = phi_1195_;
                                    phi_1196_ = _e896;
                                } else {
                                    phi_1196_ = true;
                                }
                                let _e898 = phi_1196_;
                                phi_1197_ = _e898;
                            } else {
                                phi_1197_ = true;
                            }
                            let _e900 = phi_1197_;
                            if _e900 {
                                if _e253 {
                                    phi_1204_ = 1u;
                                } else {
                                    phi_1204_ = 0u;
                                }
                                let _e902 = phi_1204_;
                                phi_1205_ = _e902;
                            } else {
                                phi_1205_ = 5u;
                            }
                            let _e904 = phi_1205_;
                            phi_1206_ = _e904;
                        } else {
                            phi_1206_ = 4u;
                        }
                        let _e906 = phi_1206_;
                        phi_1207_ = _e906;
                    }
                    let _e908 = phi_1207_;
                    phi_1208_ = _e908;
                } else {
                    phi_1208_ = 3u;
                }
                let _e910 = phi_1208_;
                phi_1209_ = _e910;
            } else {
                phi_1209_ = 2u;
            }
            let _e912 = phi_1209_;
            if !((_e912 == 0u)) {
                phi_1217_ = !((_e912 == 5u));
            } else {
                phi_1217_ = false;
            }
            let _e918 = phi_1217_;
            if _e918 {
                if _e249 {
                    phi_1225_ = (2u | 1u);
                } else {
                    phi_1225_ = 2u;
                }
                let _e921 = phi_1225_;
                if false {
                    phi_1230_ = (_e921 | 4u);
                } else {
                    phi_1230_ = _e921;
                }
                let _e924 = phi_1230_;
                phi_1235_ = _e924;
            } else {
                if _e249 {
                    phi_1234_ = 1u;
                } else {
                    phi_1234_ = 0u;
                }
                let _e926 = phi_1234_;
                phi_1235_ = _e926;
            }
            let _e928 = phi_1235_;
            if _e249 {
                phi_1239_ = 0f;
            } else {
                phi_1239_ = 1f;
            }
            let _e930 = phi_1239_;
            phi_1241_ = mask_Masked(_e930, _e928, _e918);
        }
        let _e933 = phi_1241_;
        visibility.member[_e70.shift] = _e933.visibility;
        let _e938 = p.member.light.number;
        let _e939 = (_e938 * 3u);
        let _e941 = (_e939 % 32u);
        let _e943 = p.member.light.mask_words;
        let _e945 = ((_e70.shift * _e943) + (_e939 / 32u));
        let _e947 = bits.member[_e945];
        bits.member[_e945] = ((_e947 & ~((7u << bitcast<u32>((_e941 & 31u))))) | (_e933.bits << bitcast<u32>((_e941 & 31u))));
        if (_e941 > 29u) {
            let _e962 = bits.member[(_e945 + 1u)];
            let _e964 = (32u - _e941);
            bits.member[(_e945 + 1u)] = ((_e962 & ~((7u >> bitcast<u32>((_e964 & 31u))))) | (_e933.bits >> bitcast<u32>((_e964 & 31u))));
        }
        phi_1291_ = _e933.needs_ray;
        phi_1292_ = _e70.shift;
    } else {
        phi_1291_ = false;
        phi_1292_ = 0u;
    }
    let _e978 = phi_1291_;
    let _e980 = phi_1292_;
    if (_e55 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e978 {
        let _e984 = atomicAdd((&shared_[0u]), 1u);
        phi_1303_ = _e984;
    } else {
        phi_1303_ = 0u;
    }
    let _e986 = phi_1303_;
    workgroupBarrier();
    if (_e55 == 0u) {
        let _e990 = atomicLoad((&shared_[0u]));
        let _e991 = atomicAdd((&list.member[3u]), _e990);
        atomicStore((&shared_[1u]), _e991);
    }
    workgroupBarrier();
    if _e978 {
        let _e994 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e994) + _e986)]), _e980);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_rr_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
