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
    var phi_896_: u32;
    var phi_915_: u32;
    var phi_923_: u32;
    var phi_924_: u32;
    var phi_925_: bool;
    var phi_926_: u32;
    var phi_927_: bool;
    var phi_928_: bool;
    var phi_929_: u32;
    var phi_930_: bool;
    var phi_931_: bool;
    var phi_935_: bool;
    var phi_939_: u32;
    var phi_944_: bool;
    var phi_966_: u32;
    var phi_968_: u32;
    var phi_971_: lt_mask_Neighbourhood;
    var phi_983_: bool;
    var phi_984_: bool;
    var phi_993_: u32;
    var phi_994_: u32;
    var phi_1054_: vec2<i32>;
    var phi_1074_: vec2<i32>;
    var phi_1099_: u32;
    var phi_1118_: u32;
    var phi_1126_: u32;
    var phi_1152_: bool;
    var phi_1153_: bool;
    var phi_1154_: bool;
    var phi_1155_: bool;
    var phi_1156_: bool;
    var phi_1157_: bool;
    var phi_1158_: bool;
    var phi_1163_: bool;
    var phi_1164_: bool;
    var phi_1165_: bool;
    var phi_1166_: bool;
    var phi_1167_: bool;
    var phi_1168_: bool;
    var phi_1169_: bool;
    var phi_1170_: bool;
    var phi_1171_: bool;
    var phi_1186_: bool;
    var phi_1187_: bool;
    var phi_1194_: bool;
    var phi_1195_: bool;
    var phi_1196_: bool;
    var phi_1197_: bool;
    var phi_1198_: bool;
    var phi_1202_: bool;
    var phi_1203_: bool;
    var phi_1204_: bool;
    var phi_1208_: bool;
    var phi_1209_: bool;
    var phi_1213_: bool;
    var phi_1214_: bool;
    var phi_1232_: bool;
    var phi_1233_: bool;
    var phi_1234_: bool;
    var phi_969_: u32;
    var phi_972_: lt_mask_Neighbourhood;
    var phi_1237_: lt_mask_Neighbourhood;
    var phi_1238_: lt_mask_Neighbourhood;
    var phi_1239_: lt_mask_Neighbourhood;
    var phi_1271_: bool;
    var phi_1272_: bool;
    var phi_1294_: bool;
    var phi_1295_: bool;
    var phi_1296_: bool;
    var phi_1300_: bool;
    var phi_1322_: bool;
    var phi_1323_: bool;
    var phi_1336_: bool;
    var phi_1337_: bool;
    var phi_1338_: bool;
    var phi_1345_: u32;
    var phi_1346_: u32;
    var phi_1347_: u32;
    var phi_1348_: u32;
    var phi_1349_: u32;
    var phi_1350_: u32;
    var phi_1351_: u32;
    var phi_1363_: bool;
    var phi_1364_: bool;
    var phi_1365_: bool;
    var phi_1366_: bool;
    var phi_1370_: bool;
    var phi_1376_: bool;
    var phi_1384_: u32;
    var phi_1389_: u32;
    var phi_1398_: u32;
    var phi_1403_: u32;
    var phi_1407_: u32;
    var phi_1408_: u32;
    var phi_1409_: u32;
    var phi_1413_: f32;
    var phi_1415_: mask_Masked;
    var phi_1465_: bool;
    var phi_1466_: u32;
    var phi_1477_: u32;
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
        let _e79 = (_e78 / 32u);
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
            phi_1415_ = mask_Masked(_e244.unnamed.visibility, 0u, false);
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
            let _e667 = ((_e665 & 2u) != 0u);
            let _e669 = p.member.flags;
            if ((_e669 & 4u) == 0u) {
                phi_929_ = u32();
                phi_930_ = true;
                phi_931_ = false;
            } else {
                if _e657 {
                    if !(_e663.has_moved) {
                        let _e677 = ((((_e54.y * _e86) + _e54.x) * _e82) + _e79);
                        if (_e80 > 29u) {
                            let _e679 = (_e677 + 1u);
                            if (_e679 < _e60) {
                            } else {
                                return;
                            }
                            let _e683 = last_bits.member[(0u + _e679)];
                            phi_896_ = _e683;
                        } else {
                            phi_896_ = 0u;
                        }
                        let _e685 = phi_896_;
                        if (_e677 < _e60) {
                        } else {
                            return;
                        }
                        let _e689 = last_bits.member[(0u + _e677)];
                        let _e692 = (_e689 >> bitcast<u32>((_e80 & 31u)));
                        if (_e80 > 29u) {
                            phi_915_ = (_e692 | (_e685 << bitcast<u32>(((32u - _e80) & 31u))));
                        } else {
                            phi_915_ = _e692;
                        }
                        let _e700 = phi_915_;
                        if ((_e700 & 2u) == 0u) {
                            phi_923_ = (_e700 & 1u);
                        } else {
                            phi_923_ = (_e700 & 7u);
                        }
                        let _e706 = phi_923_;
                        phi_924_ = _e706;
                        phi_925_ = false;
                    } else {
                        phi_924_ = u32();
                        phi_925_ = true;
                    }
                    let _e708 = phi_924_;
                    let _e710 = phi_925_;
                    phi_926_ = _e708;
                    phi_927_ = false;
                    phi_928_ = _e710;
                } else {
                    phi_926_ = u32();
                    phi_927_ = true;
                    phi_928_ = false;
                }
                let _e712 = phi_926_;
                let _e714 = phi_927_;
                let _e716 = phi_928_;
                phi_929_ = _e712;
                phi_930_ = _e714;
                phi_931_ = _e716;
            }
            let _e718 = phi_929_;
            let _e720 = phi_930_;
            let _e722 = phi_931_;
            if _e720 {
                phi_935_ = true;
            } else {
                phi_935_ = _e722;
            }
            let _e724 = phi_935_;
            if _e724 {
                phi_939_ = 0u;
            } else {
                phi_939_ = _e718;
            }
            let _e726 = phi_939_;
            let _e727 = lt_mask_Neighbourhood(false, true);
            if _e253 {
                phi_944_ = _e667;
            } else {
                phi_944_ = false;
            }
            let _e729 = phi_944_;
            if _e729 {
                if _e657 {
                    if ((_e726 & 2u) != 0u) {
                        phi_1237_ = _e727;
                    } else {
                        let _e733 = p.member.expansion;
                        if _e663.has_moved {
                            let _e736 = p.member.moving_pattern;
                            phi_966_ = _e736;
                        } else {
                            let _e738 = p.member.still_pattern;
                            phi_966_ = _e738;
                        }
                        let _e740 = phi_966_;
                        phi_968_ = 0u;
                        phi_971_ = _e727;
                        loop {
                            let _e742 = phi_968_;
                            let _e744 = phi_971_;
                            local_1 = _e744;
                            if (1u <= _e740) {
                                if (_e740 <= 4u) {
                                    phi_983_ = false;
                                } else {
                                    phi_983_ = true;
                                }
                                let _e748 = phi_983_;
                                phi_984_ = _e748;
                            } else {
                                phi_984_ = true;
                            }
                            let _e750 = phi_984_;
                            if _e750 {
                                switch bitcast<i32>(_e740) {
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
                                let _e753 = phi_993_;
                                phi_994_ = _e753;
                            } else {
                                phi_994_ = 5u;
                            }
                            let _e755 = phi_994_;
                            let _e756 = (_e742 < _e755);
                            if _e756 {
                                let _e762 = p.member.frame;
                                let _e766 = p.member.current.size[0u];
                                let _e768 = p.member.current.size[1u];
                                switch bitcast<i32>(_e740) {
                                    case 1: {
                                        let _e778 = lt_mask_pattern_plus(_e742);
                                        phi_1074_ = vec2<i32>(_e778.x, _e778.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e782 = lt_mask_pattern_cross(_e742);
                                        phi_1074_ = vec2<i32>(_e782.x, _e782.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e788 = lt_mask_pattern_plus_or_cross(_e742, ((_e663.pixel.x + _e663.pixel.y) & 1u));
                                        phi_1074_ = vec2<i32>(_e788.x, _e788.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e793 = lt_mask_pattern_plus_or_cross(_e742, (_e762 & 1u));
                                        phi_1074_ = vec2<i32>(_e793.x, _e793.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e762 & 3u)) {
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
                                        let _e804 = phi_1054_;
                                        phi_1074_ = (_e804 + vec2<i32>(bitcast<i32>((_e742 & 1u)), bitcast<i32>(((_e742 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_1074_ = vec2<i32>((bitcast<i32>((_e742 % 5u)) - 2i), (bitcast<i32>(((_e742 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e821 = lt_mask_pattern_diamond(_e742);
                                        phi_1074_ = vec2<i32>(_e821.x, _e821.y);
                                        break;
                                    }
                                    default: {
                                        phi_1074_ = vec2<i32>((bitcast<i32>((_e742 % 3u)) - 1i), (bitcast<i32>(((_e742 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e826 = phi_1074_;
                                let _e829 = lt_mask_pattern_step_clamped(_e663.pixel.x, _e826.x, _e766);
                                let _e830 = lt_mask_pattern_step_clamped(_e663.pixel.y, _e826.y, _e768);
                                let _e834 = ((((_e830 * _e86) + _e829) * _e82) + _e79);
                                if (_e80 > 29u) {
                                    let _e836 = (_e834 + 1u);
                                    if (_e836 < _e60) {
                                    } else {
                                        return;
                                    }
                                    let _e840 = last_bits.member[(0u + _e836)];
                                    phi_1099_ = _e840;
                                } else {
                                    phi_1099_ = 0u;
                                }
                                let _e842 = phi_1099_;
                                if (_e834 < _e60) {
                                } else {
                                    return;
                                }
                                let _e846 = last_bits.member[(0u + _e834)];
                                let _e849 = (_e846 >> bitcast<u32>((_e80 & 31u)));
                                if (_e80 > 29u) {
                                    phi_1118_ = (_e849 | (_e842 << bitcast<u32>(((32u - _e80) & 31u))));
                                } else {
                                    phi_1118_ = _e849;
                                }
                                let _e857 = phi_1118_;
                                if ((_e857 & 2u) == 0u) {
                                    phi_1126_ = (_e857 & 1u);
                                } else {
                                    phi_1126_ = (_e857 & 7u);
                                }
                                let _e863 = phi_1126_;
                                if _e744.any_expands {
                                    phi_1214_ = true;
                                } else {
                                    if ((_e863 & 2u) != 0u) {
                                        let _e870 = (((_e863 & 4u) != 0u) != _e249);
                                        switch bitcast<i32>(_e733) {
                                            case 1: {
                                                phi_1154_ = bool();
                                                phi_1155_ = false;
                                                phi_1156_ = true;
                                                phi_1157_ = false;
                                                phi_1158_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e870 {
                                                    phi_1152_ = (((_e863 & 4u) != 0u) != ((_e863 & 1u) != 0u));
                                                    phi_1153_ = false;
                                                } else {
                                                    phi_1152_ = bool();
                                                    phi_1153_ = true;
                                                }
                                                let _e878 = phi_1152_;
                                                let _e880 = phi_1153_;
                                                phi_1154_ = _e878;
                                                phi_1155_ = false;
                                                phi_1156_ = false;
                                                phi_1157_ = _e880;
                                                phi_1158_ = _e870;
                                                break;
                                            }
                                            default: {
                                                phi_1154_ = bool();
                                                phi_1155_ = true;
                                                phi_1156_ = false;
                                                phi_1157_ = false;
                                                phi_1158_ = false;
                                                break;
                                            }
                                        }
                                        let _e882 = phi_1154_;
                                        let _e884 = phi_1155_;
                                        let _e886 = phi_1156_;
                                        let _e888 = phi_1157_;
                                        let _e890 = phi_1158_;
                                        phi_1166_ = _e870;
                                        phi_1167_ = _e882;
                                        phi_1168_ = _e884;
                                        phi_1169_ = _e886;
                                        phi_1170_ = _e888;
                                        phi_1171_ = _e890;
                                    } else {
                                        switch bitcast<i32>(_e733) {
                                            case 1: {
                                                phi_1163_ = false;
                                                phi_1164_ = true;
                                                phi_1165_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_1163_ = false;
                                                phi_1164_ = false;
                                                phi_1165_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_1163_ = true;
                                                phi_1164_ = false;
                                                phi_1165_ = false;
                                                break;
                                            }
                                        }
                                        let _e893 = phi_1163_;
                                        let _e895 = phi_1164_;
                                        let _e897 = phi_1165_;
                                        phi_1166_ = false;
                                        phi_1167_ = bool();
                                        phi_1168_ = _e893;
                                        phi_1169_ = _e895;
                                        phi_1170_ = _e897;
                                        phi_1171_ = false;
                                    }
                                    let _e899 = phi_1166_;
                                    let _e901 = phi_1167_;
                                    let _e903 = phi_1168_;
                                    let _e905 = phi_1169_;
                                    let _e907 = phi_1170_;
                                    let _e909 = phi_1171_;
                                    if _e903 {
                                        if ((_e863 & 2u) != 0u) {
                                            if (((_e863 & 4u) != 0u) != _e249) {
                                                phi_1186_ = false;
                                            } else {
                                                phi_1186_ = true;
                                            }
                                            let _e916 = phi_1186_;
                                            phi_1187_ = _e916;
                                        } else {
                                            phi_1187_ = true;
                                        }
                                        let _e918 = phi_1187_;
                                        if _e918 {
                                            phi_1194_ = (((_e863 & 1u) != 0u) != _e249);
                                        } else {
                                            phi_1194_ = true;
                                        }
                                        let _e923 = phi_1194_;
                                        phi_1195_ = _e923;
                                        phi_1196_ = false;
                                        phi_1197_ = false;
                                        phi_1198_ = false;
                                    } else {
                                        phi_1195_ = bool();
                                        phi_1196_ = _e905;
                                        phi_1197_ = _e907;
                                        phi_1198_ = _e909;
                                    }
                                    let _e925 = phi_1195_;
                                    let _e927 = phi_1196_;
                                    let _e929 = phi_1197_;
                                    let _e931 = phi_1198_;
                                    if _e927 {
                                        phi_1202_ = _e899;
                                        phi_1203_ = false;
                                        phi_1204_ = false;
                                    } else {
                                        phi_1202_ = _e925;
                                        phi_1203_ = _e929;
                                        phi_1204_ = _e931;
                                    }
                                    let _e933 = phi_1202_;
                                    let _e935 = phi_1203_;
                                    let _e937 = phi_1204_;
                                    if _e935 {
                                        phi_1208_ = false;
                                        phi_1209_ = true;
                                    } else {
                                        phi_1208_ = _e901;
                                        phi_1209_ = _e937;
                                    }
                                    let _e939 = phi_1208_;
                                    let _e941 = phi_1209_;
                                    if _e941 {
                                        phi_1213_ = _e939;
                                    } else {
                                        phi_1213_ = _e933;
                                    }
                                    let _e943 = phi_1213_;
                                    phi_1214_ = _e943;
                                }
                                let _e945 = phi_1214_;
                                if _e744.all_remove {
                                    if (((_e863 & 1u) != 0u) == _e249) {
                                        if ((_e863 & 2u) != 0u) {
                                            phi_1232_ = (((_e863 & 4u) != 0u) == _e249);
                                        } else {
                                            phi_1232_ = true;
                                        }
                                        let _e955 = phi_1232_;
                                        phi_1233_ = _e955;
                                    } else {
                                        phi_1233_ = false;
                                    }
                                    let _e957 = phi_1233_;
                                    phi_1234_ = _e957;
                                } else {
                                    phi_1234_ = false;
                                }
                                let _e959 = phi_1234_;
                                phi_969_ = (_e742 + 1u);
                                phi_972_ = lt_mask_Neighbourhood(_e945, _e959);
                            } else {
                                phi_969_ = u32();
                                phi_972_ = lt_mask_Neighbourhood();
                            }
                            let _e963 = phi_969_;
                            let _e965 = phi_972_;
                            continue;
                            continuing {
                                phi_968_ = _e963;
                                phi_971_ = _e965;
                                break if !(_e756);
                            }
                        }
                        let _e1267 = local_1;
                        phi_1237_ = _e1267;
                    }
                    let _e968 = phi_1237_;
                    phi_1238_ = _e968;
                } else {
                    phi_1238_ = _e727;
                }
                let _e970 = phi_1238_;
                phi_1239_ = _e970;
            } else {
                phi_1239_ = _e727;
            }
            let _e972 = phi_1239_;
            let _e975 = p.member.frame;
            let _e977 = p.member.refresh;
            if (_e977 == 0u) {
                phi_1272_ = false;
            } else {
                if (_e977 == 0u) {
                    return;
                }
                let _e986 = ((_e54.x + (_e54.y * (((_e977 * 5u) / 8u) | 1u))) + (_e975 % _e977));
                if (_e977 == 0u) {
                    phi_1271_ = (_e986 == 0u);
                } else {
                    if (_e977 == 0u) {
                        return;
                    }
                    phi_1271_ = ((_e986 % _e977) == 0u);
                }
                let _e993 = phi_1271_;
                phi_1272_ = _e993;
            }
            let _e995 = phi_1272_;
            if _e657 {
                if _e995 {
                    phi_1294_ = bool();
                } else {
                    phi_1294_ = ((_e726 & 2u) != 0u);
                }
                let _e1001 = phi_1294_;
                phi_1295_ = _e1001;
                phi_1296_ = _e995;
            } else {
                phi_1295_ = bool();
                phi_1296_ = true;
            }
            let _e1003 = phi_1295_;
            let _e1005 = phi_1296_;
            if _e1005 {
                phi_1300_ = false;
            } else {
                phi_1300_ = _e1003;
            }
            let _e1007 = phi_1300_;
            if _e1007 {
                phi_1351_ = 7u;
            } else {
                if (_e91 != 0.5f) {
                    if _e657 {
                        if _e995 {
                            phi_1348_ = 6u;
                        } else {
                            if _e253 {
                                phi_1323_ = true;
                            } else {
                                if _e972.any_expands {
                                    phi_1322_ = false;
                                } else {
                                    phi_1322_ = true;
                                }
                                let _e1009 = phi_1322_;
                                phi_1323_ = _e1009;
                            }
                            let _e1011 = phi_1323_;
                            if _e1011 {
                                if _e253 {
                                    if _e667 {
                                        if _e972.all_remove {
                                            phi_1336_ = false;
                                        } else {
                                            phi_1336_ = true;
                                        }
                                        let _e1013 = phi_1336_;
                                        phi_1337_ = _e1013;
                                    } else {
                                        phi_1337_ = true;
                                    }
                                    let _e1015 = phi_1337_;
                                    phi_1338_ = _e1015;
                                } else {
                                    phi_1338_ = true;
                                }
                                let _e1017 = phi_1338_;
                                if _e1017 {
                                    if _e253 {
                                        phi_1345_ = 1u;
                                    } else {
                                        phi_1345_ = 0u;
                                    }
                                    let _e1019 = phi_1345_;
                                    phi_1346_ = _e1019;
                                } else {
                                    phi_1346_ = 5u;
                                }
                                let _e1021 = phi_1346_;
                                phi_1347_ = _e1021;
                            } else {
                                phi_1347_ = 4u;
                            }
                            let _e1023 = phi_1347_;
                            phi_1348_ = _e1023;
                        }
                        let _e1025 = phi_1348_;
                        phi_1349_ = _e1025;
                    } else {
                        phi_1349_ = 3u;
                    }
                    let _e1027 = phi_1349_;
                    phi_1350_ = _e1027;
                } else {
                    phi_1350_ = 2u;
                }
                let _e1029 = phi_1350_;
                phi_1351_ = _e1029;
            }
            let _e1031 = phi_1351_;
            if !((_e1031 == 0u)) {
                if !((_e1031 == 5u)) {
                    phi_1363_ = !(_e1007);
                    phi_1364_ = false;
                } else {
                    phi_1363_ = bool();
                    phi_1364_ = true;
                }
                let _e1038 = phi_1363_;
                let _e1040 = phi_1364_;
                phi_1365_ = _e1038;
                phi_1366_ = _e1040;
            } else {
                phi_1365_ = bool();
                phi_1366_ = true;
            }
            let _e1042 = phi_1365_;
            let _e1044 = phi_1366_;
            if _e1044 {
                phi_1370_ = false;
            } else {
                phi_1370_ = _e1042;
            }
            let _e1046 = phi_1370_;
            if _e1007 {
                phi_1376_ = ((_e726 & 4u) != 0u);
            } else {
                phi_1376_ = _e249;
            }
            let _e1050 = phi_1376_;
            if _e1046 {
                if _e249 {
                    phi_1384_ = (2u | 1u);
                } else {
                    phi_1384_ = 2u;
                }
                let _e1053 = phi_1384_;
                if false {
                    phi_1389_ = (_e1053 | 4u);
                } else {
                    phi_1389_ = _e1053;
                }
                let _e1056 = phi_1389_;
                phi_1409_ = _e1056;
            } else {
                if (_e1031 == 7u) {
                    if _e249 {
                        phi_1398_ = (2u | 1u);
                    } else {
                        phi_1398_ = 2u;
                    }
                    let _e1060 = phi_1398_;
                    if _e1050 {
                        phi_1403_ = (_e1060 | 4u);
                    } else {
                        phi_1403_ = _e1060;
                    }
                    let _e1063 = phi_1403_;
                    phi_1408_ = _e1063;
                } else {
                    if _e249 {
                        phi_1407_ = 1u;
                    } else {
                        phi_1407_ = 0u;
                    }
                    let _e1065 = phi_1407_;
                    phi_1408_ = _e1065;
                }
                let _e1067 = phi_1408_;
                phi_1409_ = _e1067;
            }
            let _e1069 = phi_1409_;
            if _e1050 {
                phi_1413_ = 0f;
            } else {
                phi_1413_ = 1f;
            }
            let _e1071 = phi_1413_;
            phi_1415_ = mask_Masked(_e1071, _e1069, _e1046);
        }
        let _e1074 = phi_1415_;
        visibility.member[_e70.shift] = _e1074.visibility;
        let _e1079 = p.member.light.number;
        let _e1080 = (_e1079 * 3u);
        let _e1082 = (_e1080 % 32u);
        let _e1084 = p.member.light.mask_words;
        let _e1086 = ((_e70.shift * _e1084) + (_e1080 / 32u));
        let _e1088 = bits.member[_e1086];
        bits.member[_e1086] = ((_e1088 & ~((7u << bitcast<u32>((_e1082 & 31u))))) | (_e1074.bits << bitcast<u32>((_e1082 & 31u))));
        if (_e1082 > 29u) {
            let _e1103 = bits.member[(_e1086 + 1u)];
            let _e1105 = (32u - _e1082);
            bits.member[(_e1086 + 1u)] = ((_e1103 & ~((7u >> bitcast<u32>((_e1105 & 31u))))) | (_e1074.bits >> bitcast<u32>((_e1105 & 31u))));
        }
        phi_1465_ = _e1074.needs_ray;
        phi_1466_ = _e70.shift;
    } else {
        phi_1465_ = false;
        phi_1466_ = 0u;
    }
    let _e1119 = phi_1465_;
    let _e1121 = phi_1466_;
    if (_e55 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1119 {
        let _e1125 = atomicAdd((&shared_[0u]), 1u);
        phi_1477_ = _e1125;
    } else {
        phi_1477_ = 0u;
    }
    let _e1127 = phi_1477_;
    workgroupBarrier();
    if (_e55 == 0u) {
        let _e1131 = atomicLoad((&shared_[0u]));
        let _e1132 = atomicAdd((&list.member[3u]), _e1131);
        atomicStore((&shared_[1u]), _e1132);
    }
    workgroupBarrier();
    if _e1119 {
        let _e1135 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1135) + _e1127)]), _e1121);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_rr_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
