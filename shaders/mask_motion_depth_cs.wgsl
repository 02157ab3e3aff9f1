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
    var phi_178_: lt_mask_LightPlace;
    var phi_179_: bool;
    var phi_180_: lt_mask_LightPlace;
    var phi_181_: bool;
    var phi_186_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_178_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_179_ = false;
        } else {
            phi_178_ = lt_mask_LightPlace();
            phi_179_ = true;
        }
        let _e73 = phi_178_;
        let _e75 = phi_179_;
        phi_180_ = _e73;
        phi_181_ = _e75;
    } else {
        phi_180_ = lt_mask_LightPlace();
        phi_181_ = true;
    }
    let _e77 = phi_180_;
    let _e79 = phi_181_;
    if _e79 {
        phi_186_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_186_ = _e77;
    }
    let _e84 = phi_186_;
    return lt_mask_LightPlace(_e84.word, _e84.shift);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_204_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_204_ = vec2(0i);
            break;
        }
        case 1: {
            phi_204_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_204_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_204_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_204_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e69 = phi_204_;
    return vec2<i32>(_e69.x, _e69.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_222_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_222_ = vec2(0i);
            break;
        }
        case 1: {
            phi_222_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_222_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_222_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_222_ = vec2(1i);
            break;
        }
    }
    let _e69 = phi_222_;
    return vec2<i32>(_e69.x, _e69.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_241_: vec2<i32>;

    if (param_6 == 0u) {
        let _e63 = lt_mask_pattern_plus(param_5);
        phi_241_ = vec2<i32>(_e63.x, _e63.y);
    } else {
        let _e67 = lt_mask_pattern_cross(param_5);
        phi_241_ = vec2<i32>(_e67.x, _e67.y);
    }
    let _e72 = phi_241_;
    return vec2<i32>(_e72.x, _e72.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_266_: vec2<i32>;

    let _e61 = (param_7 % 13u);
    switch bitcast<i32>(_e61) {
        case 9: {
            phi_266_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_266_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_266_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_266_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_266_ = vec2<i32>((bitcast<i32>((_e61 % 3u)) - 1i), (bitcast<i32>(((_e61 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e76 = phi_266_;
    return vec2<i32>(_e76.x, _e76.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_287_: u32;
    var phi_288_: u32;

    let _e64 = (bitcast<i32>(param_8) + param_9);
    if (_e64 < 0i) {
        phi_288_ = 0u;
    } else {
        if (_e64 >= bitcast<i32>(param_10)) {
            phi_287_ = (param_10 - 1u);
        } else {
            phi_287_ = bitcast<u32>(_e64);
        }
        let _e71 = phi_287_;
        phi_288_ = _e71;
    }
    let _e73 = phi_288_;
    return _e73;
}

fn function_() {
    var phi_365_: bool;
    var phi_366_: bool;
    var phi_367_: bool;
    var phi_368_: bool;
    var phi_372_: bool;
    var phi_442_: bool;
    var phi_443_: bool;
    var phi_454_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_455_: bool;
    var phi_456_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_457_: bool;
    var phi_464_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_468_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_481_: bool;
    var phi_512_: bool;
    var phi_513_: bool;
    var phi_514_: bool;
    var phi_515_: bool;
    var phi_519_: bool;
    var phi_520_: bool;
    var phi_731_: f32;
    var phi_736_: f32;
    var phi_737_: bool;
    var phi_738_: f32;
    var phi_739_: bool;
    var phi_743_: f32;
    var phi_764_: f32;
    var phi_769_: f32;
    var phi_770_: bool;
    var phi_771_: f32;
    var phi_772_: bool;
    var phi_776_: f32;
    var phi_797_: bool;
    var phi_816_: vec2<u32>;
    var phi_817_: bool;
    var phi_818_: bool;
    var phi_819_: bool;
    var phi_820_: vec2<u32>;
    var phi_821_: bool;
    var phi_822_: bool;
    var phi_823_: bool;
    var phi_824_: bool;
    var phi_825_: bool;
    var phi_826_: bool;
    var phi_827_: vec2<u32>;
    var phi_828_: bool;
    var phi_829_: bool;
    var phi_830_: bool;
    var phi_831_: bool;
    var phi_832_: bool;
    var phi_833_: bool;
    var phi_834_: vec2<u32>;
    var phi_835_: bool;
    var phi_836_: bool;
    var phi_837_: bool;
    var phi_838_: bool;
    var phi_847_: bool;
    var phi_848_: bool;
    var phi_849_: bool;
    var phi_850_: bool;
    var phi_854_: bool;
    var phi_855_: bool;
    var phi_856_: vec2<u32>;
    var phi_894_: bool;
    var phi_896_: lt_mask_Reprojection;
    var phi_897_: lt_mask_Reprojection;
    var phi_898_: lt_mask_Reprojection;
    var phi_899_: bool;
    var phi_900_: bool;
    var phi_901_: lt_mask_Reprojection;
    var phi_902_: lt_mask_Reprojection;
    var phi_903_: lt_mask_Reprojection;
    var phi_904_: bool;
    var phi_905_: bool;
    var phi_960_: bool;
    var phi_964_: f32;
    var phi_968_: lt_mask_Reprojection;
    var phi_969_: bool;
    var phi_981_: bool;
    var phi_982_: bool;
    var phi_983_: bool;
    var phi_984_: lt_mask_Reprojection;
    var phi_985_: bool;
    var phi_989_: bool;
    var phi_990_: lt_mask_Reprojection;
    var phi_1033_: u32;
    var phi_1052_: u32;
    var phi_1060_: u32;
    var phi_1061_: u32;
    var phi_1062_: bool;
    var phi_1063_: u32;
    var phi_1064_: bool;
    var phi_1065_: bool;
    var phi_1066_: u32;
    var phi_1067_: bool;
    var phi_1068_: bool;
    var phi_1072_: bool;
    var phi_1076_: u32;
    var phi_1081_: bool;
    var phi_1103_: u32;
    var phi_1105_: u32;
    var phi_1108_: lt_mask_Neighbourhood;
    var phi_1120_: bool;
    var phi_1121_: bool;
    var phi_1130_: u32;
    var phi_1131_: u32;
    var phi_1191_: vec2<i32>;
    var phi_1211_: vec2<i32>;
    var phi_1238_: u32;
    var phi_1257_: u32;
    var phi_1265_: u32;
    var phi_1291_: bool;
    var phi_1292_: bool;
    var phi_1293_: bool;
    var phi_1294_: bool;
    var phi_1295_: bool;
    var phi_1296_: bool;
    var phi_1297_: bool;
    var phi_1302_: bool;
    var phi_1303_: bool;
    var phi_1304_: bool;
    var phi_1305_: bool;
    var phi_1306_: bool;
    var phi_1307_: bool;
    var phi_1308_: bool;
    var phi_1309_: bool;
    var phi_1310_: bool;
    var phi_1325_: bool;
    var phi_1326_: bool;
    var phi_1333_: bool;
    var phi_1334_: bool;
    var phi_1335_: bool;
    var phi_1336_: bool;
    var phi_1337_: bool;
    var phi_1341_: bool;
    var phi_1342_: bool;
    var phi_1343_: bool;
    var phi_1347_: bool;
    var phi_1348_: bool;
    var phi_1352_: bool;
    var phi_1353_: bool;
    var phi_1371_: bool;
    var phi_1372_: bool;
    var phi_1373_: bool;
    var phi_1106_: u32;
    var phi_1109_: lt_mask_Neighbourhood;
    var phi_1376_: lt_mask_Neighbourhood;
    var phi_1377_: lt_mask_Neighbourhood;
    var phi_1378_: lt_mask_Neighbourhood;
    var phi_1410_: bool;
    var phi_1411_: bool;
    var phi_1433_: bool;
    var phi_1434_: bool;
    var phi_1435_: bool;
    var phi_1439_: bool;
    var phi_1461_: bool;
    var phi_1462_: bool;
    var phi_1475_: bool;
    var phi_1476_: bool;
    var phi_1477_: bool;
    var phi_1484_: u32;
    var phi_1485_: u32;
    var phi_1486_: u32;
    var phi_1487_: u32;
    var phi_1488_: u32;
    var phi_1489_: u32;
    var phi_1490_: u32;
    var phi_1502_: bool;
    var phi_1503_: bool;
    var phi_1504_: bool;
    var phi_1505_: bool;
    var phi_1509_: bool;
    var phi_1515_: bool;
    var phi_1523_: u32;
    var phi_1528_: u32;
    var phi_1537_: u32;
    var phi_1542_: u32;
    var phi_1546_: u32;
    var phi_1547_: u32;
    var phi_1548_: u32;
    var phi_1552_: f32;
    var phi_1554_: mask_Masked;
    var phi_1626_: bool;
    var phi_1627_: bool;
    var phi_1628_: bool;
    var phi_1629_: bool;
    var phi_1633_: bool;
    var phi_1661_: f32;
    var phi_1664_: bool;
    var phi_1665_: u32;
    var phi_1676_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e60 = id_1;
    let _e61 = local_2;
    let _e66 = arrayLength((&last_bits.member));
    let _e77 = p.member.current.size[0u];
    let _e79 = p.member.current.size[1u];
    let _e80 = lt_shaders_entry_pixel_index(_e60, _e77, _e79);
    if (bitcast<i32>(_e80.word) != 0i) {
        let _e87 = p.member.light.number;
        let _e88 = (_e87 * 3u);
        let _e92 = p.member.light.mask_words;
        let _e98 = mask_BitsPlace(lt_mask_LightPlace((_e88 / 32u), mask_BitsPlace().light.shift), mask_BitsPlace().words);
        let _e104 = mask_BitsPlace(lt_mask_LightPlace(_e98.light.word, (_e88 % 32u)), _e98.words);
        let _e107 = mask_BitsPlace(_e104.light, _e92);
        let _e111 = p.member.current.size[0u];
        let _e114 = samples.member[_e80.shift].position;
        let _e116 = visibility.member[_e80.shift];
        let _e122 = samples.member[_e80.shift].normal[0u];
        let _e124 = global[0u];
        if (_e122 == _e124) {
            let _e127 = samples.member[_e80.shift].normal[1u];
            let _e129 = global[1u];
            if (_e127 == _e129) {
                let _e132 = samples.member[_e80.shift].normal[2u];
                let _e134 = global[2u];
                phi_365_ = (_e132 == _e134);
                phi_366_ = false;
            } else {
                phi_365_ = bool();
                phi_366_ = true;
            }
            let _e137 = phi_365_;
            let _e139 = phi_366_;
            phi_367_ = _e137;
            phi_368_ = _e139;
        } else {
            phi_367_ = bool();
            phi_368_ = true;
        }
        let _e141 = phi_367_;
        let _e143 = phi_368_;
        if _e143 {
            phi_372_ = false;
        } else {
            phi_372_ = _e141;
        }
        let _e145 = phi_372_;
        if !(_e145) {
            let _e148 = samples.member[_e80.shift].position;
            let _e150 = p.member.light.place;
            let _e156 = p.member.light.place[3u];
            let _e163 = (_e150.x - (_e148.x * _e156));
            let _e164 = (_e150.y - (_e148.y * _e156));
            let _e165 = (_e150.z - (_e148.z * _e156));
            let _e167 = samples.member[_e80.shift].normal;
            if ((((_e167.x * _e163) + (_e167.y * _e164)) + (_e167.z * _e165)) > 0f) {
                let _e181 = (((_e163 * _e163) + (_e164 * _e164)) + (_e165 * _e165));
                let _e183 = p.member.light.axis;
                let _e195 = p.member.light.place[3u];
                if (_e195 == 0f) {
                    phi_443_ = true;
                } else {
                    let _e198 = p.member.light.range_squared;
                    if (_e181 <= _e198) {
                        let _e201 = p.member.light.cos_outer;
                        phi_442_ = (-((((_e163 * _e183.x) + (_e164 * _e183.y)) + (_e165 * _e183.z))) >= (_e201 * sqrt(_e181)));
                    } else {
                        phi_442_ = false;
                    }
                    let _e206 = phi_442_;
                    phi_443_ = _e206;
                }
                let _e208 = phi_443_;
                if _e208 {
                    let _e210 = samples.member[_e80.shift].flags;
                    let _e218 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e224 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e218.unnamed.visibility, false), _e218.unnamed_1);
                    phi_454_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e224.unnamed, ((_e210 & 1u) == 0u));
                    phi_455_ = false;
                } else {
                    phi_454_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_455_ = true;
                }
                let _e229 = phi_454_;
                let _e231 = phi_455_;
                phi_456_ = _e229;
                phi_457_ = _e231;
            } else {
                phi_456_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_457_ = true;
            }
            let _e233 = phi_456_;
            let _e235 = phi_457_;
            if _e235 {
                let _e241 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e247 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e241.unnamed.visibility, false), _e241.unnamed_1);
                phi_464_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e247.unnamed, true);
            } else {
                phi_464_ = _e233;
            }
            let _e252 = phi_464_;
            phi_468_ = _e252;
        } else {
            let _e258 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e264 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e258.unnamed.visibility, false), _e258.unnamed_1);
            phi_468_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e264.unnamed, true);
        }
        let _e269 = phi_468_;
        if _e269.unnamed_1 {
            phi_1554_ = mask_Masked(_e269.unnamed.visibility, 0u, false);
        } else {
            let _e274 = (_e116 < 0.5f);
            if (_e116 > 0f) {
                phi_481_ = (_e116 < 1f);
            } else {
                phi_481_ = false;
            }
            let _e278 = phi_481_;
            let _e285 = lt_mask_Reprojection(vec2<u32>(_e60.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e292 = lt_mask_Reprojection(vec2<u32>(_e285.pixel.x, _e60.y), _e285.is_valid, _e285.has_moved);
            let _e296 = lt_mask_Reprojection(_e292.pixel, true, _e292.has_moved);
            let _e302 = p.member.flags;
            if ((_e302 & 16u) == 0u) {
                phi_520_ = false;
            } else {
                let _e308 = samples.member[_e80.shift].position[0u];
                if (_e114.x == _e308) {
                    let _e312 = samples.member[_e80.shift].position[1u];
                    if (_e114.y == _e312) {
                        let _e316 = samples.member[_e80.shift].position[2u];
                        phi_512_ = (_e114.z == _e316);
                        phi_513_ = false;
                    } else {
                        phi_512_ = bool();
                        phi_513_ = true;
                    }
                    let _e319 = phi_512_;
                    let _e321 = phi_513_;
                    phi_514_ = _e319;
                    phi_515_ = _e321;
                } else {
                    phi_514_ = bool();
                    phi_515_ = true;
                }
                let _e323 = phi_514_;
                let _e325 = phi_515_;
                if _e325 {
                    phi_519_ = false;
                } else {
                    phi_519_ = _e323;
                }
                let _e327 = phi_519_;
                phi_520_ = _e327;
            }
            let _e329 = phi_520_;
            if _e329 {
                phi_901_ = lt_mask_Reprojection(_e296.pixel, _e296.is_valid, false);
                phi_902_ = lt_mask_Reprojection();
                phi_903_ = lt_mask_Reprojection();
                phi_904_ = true;
                phi_905_ = false;
            } else {
                let _e331 = samples.member[_e80.shift].position;
                let _e335 = p.member.previous.eye;
                let _e338 = (_e114.x - _e335.x);
                let _e341 = (_e114.y - _e335.y);
                let _e344 = (_e114.z - _e335.z);
                let _e346 = p.member.previous.forward;
                let _e354 = (((_e338 * _e346.x) + (_e341 * _e346.y)) + (_e344 * _e346.z));
                let _e356 = p.member.previous.right;
                let _e366 = p.member.previous.right;
                let _e381 = p.member.previous.up;
                let _e391 = p.member.previous.up;
                let _e406 = p.member.current.eye;
                let _e409 = (_e331.x - _e406.x);
                let _e412 = (_e331.y - _e406.y);
                let _e415 = (_e331.z - _e406.z);
                let _e417 = p.member.current.forward;
                let _e425 = (((_e409 * _e417.x) + (_e412 * _e417.y)) + (_e415 * _e417.z));
                let _e427 = p.member.current.right;
                let _e437 = p.member.current.right;
                let _e452 = p.member.current.up;
                let _e462 = p.member.current.up;
                let _e481 = p.member.current.size[0u];
                let _e483 = (((((((_e338 * _e356.x) + (_e341 * _e356.y)) + (_e344 * _e356.z)) / ((((_e366.x * _e366.x) + (_e366.y * _e366.y)) + (_e366.z * _e366.z)) * _e354)) - ((((_e409 * _e427.x) + (_e412 * _e427.y)) + (_e415 * _e427.z)) / ((((_e437.x * _e437.x) + (_e437.y * _e437.y)) + (_e437.z * _e437.z)) * _e425))) * 0.5f) * f32(_e481));
                let _e487 = p.member.current.size[1u];
                let _e489 = (((((((_e338 * _e381.x) + (_e341 * _e381.y)) + (_e344 * _e381.z)) / ((((_e391.x * _e391.x) + (_e391.y * _e391.y)) + (_e391.z * _e391.z)) * _e354)) - ((((_e409 * _e452.x) + (_e412 * _e452.y)) + (_e415 * _e452.z)) / ((((_e462.x * _e462.x) + (_e462.y * _e462.y)) + (_e462.z * _e462.z)) * _e425))) * -0.5f) * f32(_e487));
                let _e493 = p.member.current.grid[0u];
                let _e495 = p.member.current.grid[1u];
                let _e515 = p.member.current.size[0u];
                let _e517 = p.member.current.size[1u];
                let _e519 = ((f32(_e60.x) + ((f32((_e60.y & (_e495 - 1u))) + 0.5f) / f32(_e495))) + _e483);
                if (_e519 > -8388608f) {
                    let _e531 = f32(select(0i, select(select(i32(_e519), i32(-2147483648), (_e519 < bitcast<f32>(3472883712u))), 2147483647i, (_e519 > bitcast<f32>(1325400063u))), (_e519 == _e519)));
                    if (_e531 > _e519) {
                        phi_731_ = 1f;
                    } else {
                        phi_731_ = 0f;
                    }
                    let _e534 = phi_731_;
                    if (_e519 < 8388608f) {
                        phi_736_ = (_e531 - _e534);
                        phi_737_ = false;
                    } else {
                        phi_736_ = f32();
                        phi_737_ = true;
                    }
                    let _e537 = phi_736_;
                    let _e539 = phi_737_;
                    phi_738_ = _e537;
                    phi_739_ = _e539;
                } else {
                    phi_738_ = f32();
                    phi_739_ = true;
                }
                let _e541 = phi_738_;
                let _e543 = phi_739_;
                if _e543 {
                    phi_743_ = _e519;
                } else {
                    phi_743_ = _e541;
                }
                let _e545 = phi_743_;
                let _e546 = ((f32(_e60.y) + ((f32((_e60.x & (_e493 - 1u))) + 0.5f) / f32(_e493))) + _e489);
                if (_e546 > -8388608f) {
                    let _e558 = f32(select(0i, select(select(i32(_e546), i32(-2147483648), (_e546 < bitcast<f32>(3472883712u))), 2147483647i, (_e546 > bitcast<f32>(1325400063u))), (_e546 == _e546)));
                    if (_e558 > _e546) {
                        phi_764_ = 1f;
                    } else {
                        phi_764_ = 0f;
                    }
                    let _e561 = phi_764_;
                    if (_e546 < 8388608f) {
                        phi_769_ = (_e558 - _e561);
                        phi_770_ = false;
                    } else {
                        phi_769_ = f32();
                        phi_770_ = true;
                    }
                    let _e564 = phi_769_;
                    let _e566 = phi_770_;
                    phi_771_ = _e564;
                    phi_772_ = _e566;
                } else {
                    phi_771_ = f32();
                    phi_772_ = true;
                }
                let _e568 = phi_771_;
                let _e570 = phi_772_;
                if _e570 {
                    phi_776_ = _e546;
                } else {
                    phi_776_ = _e568;
                }
                let _e572 = phi_776_;
                if (_e545 >= 0f) {
                    if (_e572 >= 0f) {
                        if (_e545 < f32(_e515)) {
                            let _e578 = (_e572 < f32(_e517));
                            if (_e483 == 0f) {
                                phi_797_ = (_e489 == 0f);
                            } else {
                                phi_797_ = false;
                            }
                            let _e582 = phi_797_;
                            if _e578 {
                                phi_816_ = vec2<u32>(select(select(u32(_e545), 0u, (_e545 < bitcast<f32>(0u))), 4294967295u, (_e545 > bitcast<f32>(1333788671u))), select(select(u32(_e572), 0u, (_e572 < bitcast<f32>(0u))), 4294967295u, (_e572 > bitcast<f32>(1333788671u))));
                                phi_817_ = false;
                            } else {
                                phi_816_ = vec2<u32>();
                                phi_817_ = true;
                            }
                            let _e599 = phi_816_;
                            let _e601 = phi_817_;
                            phi_818_ = _e582;
                            phi_819_ = _e578;
                            phi_820_ = _e599;
                            phi_821_ = _e582;
                            phi_822_ = _e578;
                            phi_823_ = false;
                            phi_824_ = _e601;
                        } else {
                            phi_818_ = bool();
                            phi_819_ = bool();
                            phi_820_ = vec2<u32>();
                            phi_821_ = bool();
                            phi_822_ = bool();
                            phi_823_ = true;
                            phi_824_ = false;
                        }
                        let _e603 = phi_818_;
                        let _e605 = phi_819_;
                        let _e607 = phi_820_;
                        let _e609 = phi_821_;
                        let _e611 = phi_822_;
                        let _e613 = phi_823_;
                        let _e615 = phi_824_;
                        phi_825_ = _e603;
                        phi_826_ = _e605;
                        phi_827_ = _e607;
                        phi_828_ = _e609;
                        phi_829_ = _e611;
                        phi_830_ = _e613;
                        phi_831_ = _e615;
                    } else {
                        phi_825_ = bool();
                        phi_826_ = bool();
                        phi_827_ = vec2<u32>();
                        phi_828_ = bool();
                        phi_829_ = bool();
                        phi_830_ = true;
                        phi_831_ = false;
                    }
                    let _e617 = phi_825_;
                    let _e619 = phi_826_;
                    let _e621 = phi_827_;
                    let _e623 = phi_828_;
                    let _e625 = phi_829_;
                    let _e627 = phi_830_;
                    let _e629 = phi_831_;
                    phi_832_ = _e617;
                    phi_833_ = _e619;
                    phi_834_ = _e621;
                    phi_835_ = _e623;
                    phi_836_ = _e625;
                    phi_837_ = _e627;
                    phi_838_ = _e629;
                } else {
                    phi_832_ = bool();
                    phi_833_ = bool();
                    phi_834_ = vec2<u32>();
                    phi_835_ = bool();
                    phi_836_ = bool();
                    phi_837_ = true;
                    phi_838_ = false;
                }
                let _e631 = phi_832_;
                let _e633 = phi_833_;
                let _e635 = phi_834_;
                let _e637 = phi_835_;
                let _e639 = phi_836_;
                let _e641 = phi_837_;
                let _e643 = phi_838_;
                if _e641 {
                    if (_e483 == 0f) {
                        phi_847_ = (_e489 == 0f);
                    } else {
                        phi_847_ = false;
                    }
                    let _e647 = phi_847_;
                    phi_848_ = _e647;
                    phi_849_ = false;
                    phi_850_ = true;
                } else {
                    phi_848_ = _e637;
                    phi_849_ = _e639;
                    phi_850_ = _e643;
                }
                let _e649 = phi_848_;
                let _e651 = phi_849_;
                let _e653 = phi_850_;
                if _e653 {
                    phi_854_ = _e649;
                    phi_855_ = _e651;
                    phi_856_ = vec2<u32>(_e60.x, _e60.y);
                } else {
                    phi_854_ = _e631;
                    phi_855_ = _e633;
                    phi_856_ = _e635;
                }
                let _e655 = phi_854_;
                let _e657 = phi_855_;
                let _e659 = phi_856_;
                let _e669 = lt_mask_Reprojection(vec2<u32>(_e659.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
                let _e676 = lt_mask_Reprojection(vec2<u32>(_e669.pixel.x, _e659.y), _e669.is_valid, _e669.has_moved);
                let _e680 = lt_mask_Reprojection(_e676.pixel, _e657, _e676.has_moved);
                let _e684 = lt_mask_Reprojection(_e680.pixel, _e680.is_valid, !(_e655));
                if _e657 {
                    let _e687 = p.member.previous.eye;
                    let _e698 = p.member.previous.forward;
                    let _e707 = (((((_e114.x - _e687.x) * _e698.x) + ((_e114.y - _e687.y) * _e698.y)) + ((_e114.z - _e687.z) * _e698.z)) > 0f);
                    let _e711 = lt_mask_Reprojection(_e684.pixel, _e707, _e684.has_moved);
                    if _e707 {
                        phi_894_ = false;
                    } else {
                        phi_894_ = true;
                    }
                    let _e713 = phi_894_;
                    phi_896_ = _e711;
                    phi_897_ = _e711;
                    phi_898_ = lt_mask_Reprojection();
                    phi_899_ = _e707;
                    phi_900_ = _e713;
                } else {
                    phi_896_ = lt_mask_Reprojection();
                    phi_897_ = lt_mask_Reprojection();
                    phi_898_ = lt_mask_Reprojection(_e684.pixel, false, _e684.has_moved);
                    phi_899_ = false;
                    phi_900_ = false;
                }
                let _e719 = phi_896_;
                let _e721 = phi_897_;
                let _e723 = phi_898_;
                let _e725 = phi_899_;
                let _e727 = phi_900_;
                phi_901_ = _e719;
                phi_902_ = _e721;
                phi_903_ = _e723;
                phi_904_ = _e725;
                phi_905_ = _e727;
            }
            let _e729 = phi_901_;
            let _e731 = phi_902_;
            let _e733 = phi_903_;
            let _e735 = phi_904_;
            let _e737 = phi_905_;
            if _e735 {
                let _e740 = p.member.previous.eye;
                let _e751 = p.member.previous.forward;
                let _e759 = ((((_e114.x - _e740.x) * _e751.x) + ((_e114.y - _e740.y) * _e751.y)) + ((_e114.z - _e740.z) * _e751.z));
                let _e765 = ((_e729.pixel.y * _e111) + _e729.pixel.x);
                if (_e765 < arrayLength((&last_depths.member))) {
                } else {
                    return;
                }
                let _e769 = last_depths.member[(0u + _e765)];
                let _e771 = p.member.depth_tolerance;
                let _e774 = abs(_e759);
                let _e775 = abs(_e769);
                if ((bitcast<u32>(_e775) & 2147483647u) > 2139095040u) {
                    phi_960_ = true;
                } else {
                    let _e779 = (_e775 > _e774);
                    if _e779 {
                    }
                    phi_960_ = _e779;
                }
                let _e781 = phi_960_;
                if _e781 {
                    phi_964_ = _e775;
                } else {
                    phi_964_ = _e774;
                }
                let _e783 = phi_964_;
                phi_968_ = lt_mask_Reprojection(_e729.pixel, (abs((_e759 - _e769)) <= (_e771 * _e783)), _e729.has_moved);
                phi_969_ = true;
            } else {
                phi_968_ = _e731;
                phi_969_ = _e737;
            }
            let _e791 = phi_968_;
            let _e793 = phi_969_;
            if _e793 {
                if _e791.is_valid {
                    let _e796 = p.member.flags;
                    phi_981_ = ((_e796 & 1u) != 0u);
                    phi_982_ = false;
                } else {
                    phi_981_ = bool();
                    phi_982_ = true;
                }
                let _e800 = phi_981_;
                let _e802 = phi_982_;
                phi_983_ = _e800;
                phi_984_ = _e791;
                phi_985_ = _e802;
            } else {
                phi_983_ = bool();
                phi_984_ = _e733;
                phi_985_ = true;
            }
            let _e804 = phi_983_;
            let _e806 = phi_984_;
            let _e808 = phi_985_;
            if _e808 {
                phi_989_ = false;
                phi_990_ = _e806;
            } else {
                phi_989_ = _e804;
                phi_990_ = _e791;
            }
            let _e810 = phi_989_;
            let _e812 = phi_990_;
            let _e816 = lt_mask_Reprojection(_e812.pixel, _e810, _e812.has_moved);
            let _e818 = p.member.flags;
            let _e820 = ((_e818 & 2u) != 0u);
            let _e822 = p.member.flags;
            if ((_e822 & 4u) == 0u) {
                phi_1066_ = u32();
                phi_1067_ = true;
                phi_1068_ = false;
            } else {
                if _e810 {
                    if !(_e816.has_moved) {
                        let _e833 = ((((_e60.y * _e111) + _e60.x) * _e107.words) + _e107.light.word);
                        if (_e107.light.shift > 29u) {
                            let _e837 = (_e833 + 1u);
                            if (_e837 < _e66) {
                            } else {
                                return;
                            }
                            let _e841 = last_bits.member[(0u + _e837)];
                            phi_1033_ = _e841;
                        } else {
                            phi_1033_ = 0u;
                        }
                        let _e843 = phi_1033_;
                        if (_e833 < _e66) {
                        } else {
                            return;
                        }
                        let _e849 = last_bits.member[(0u + _e833)];
                        let _e852 = (_e849 >> bitcast<u32>((_e107.light.shift & 31u)));
                        if (_e107.light.shift > 29u) {
                            phi_1052_ = (_e852 | (_e843 << bitcast<u32>(((32u - _e107.light.shift) & 31u))));
                        } else {
                            phi_1052_ = _e852;
                        }
                        let _e860 = phi_1052_;
                        if ((_e860 & 2u) == 0u) {
                            phi_1060_ = (_e860 & 1u);
                        } else {
                            phi_1060_ = (_e860 & 7u);
                        }
                        let _e866 = phi_1060_;
                        phi_1061_ = _e866;
                        phi_1062_ = false;
                    } else {
                        phi_1061_ = u32();
                        phi_1062_ = true;
                    }
                    let _e868 = phi_1061_;
                    let _e870 = phi_1062_;
                    phi_1063_ = _e868;
                    phi_1064_ = false;
                    phi_1065_ = _e870;
                } else {
                    phi_1063_ = u32();
                    phi_1064_ = true;
                    phi_1065_ = false;
                }
                let _e872 = phi_1063_;
                let _e874 = phi_1064_;
                let _e876 = phi_1065_;
                phi_1066_ = _e872;
                phi_1067_ = _e874;
                phi_1068_ = _e876;
            }
            let _e878 = phi_1066_;
            let _e880 = phi_1067_;
            let _e882 = phi_1068_;
            if _e880 {
                phi_1072_ = true;
            } else {
                phi_1072_ = _e882;
            }
            let _e884 = phi_1072_;
            if _e884 {
                phi_1076_ = 0u;
            } else {
                phi_1076_ = _e878;
            }
            let _e886 = phi_1076_;
            let _e887 = lt_mask_Neighbourhood(false, true);
            if _e278 {
                phi_1081_ = _e820;
            } else {
                phi_1081_ = true;
            }
            let _e889 = phi_1081_;
            if _e889 {
                if _e810 {
                    if ((_e886 & 2u) != 0u) {
                        phi_1376_ = _e887;
                    } else {
                        let _e893 = p.member.expansion;
                        if _e816.has_moved {
                            let _e896 = p.member.moving_pattern;
                            phi_1103_ = _e896;
                        } else {
                            let _e898 = p.member.still_pattern;
                            phi_1103_ = _e898;
                        }
                        let _e900 = phi_1103_;
                        phi_1105_ = 0u;
                        phi_1108_ = _e887;
                        loop {
                            let _e902 = phi_1105_;
                            let _e904 = phi_1108_;
                            local_1 = _e904;
                            if (1u <= _e900) {
                                if (_e900 <= 4u) {
                                    phi_1120_ = false;
                                } else {
                                    phi_1120_ = true;
                                }
                                let _e908 = phi_1120_;
                                phi_1121_ = _e908;
                            } else {
                                phi_1121_ = true;
                            }
                            let _e910 = phi_1121_;
                            if _e910 {
                                switch bitcast<i32>(_e900) {
                                    case 5: {
                                        phi_1130_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_1130_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_1130_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_1130_ = 9u;
                                        break;
                                    }
                                }
                                let _e913 = phi_1130_;
                                phi_1131_ = _e913;
                            } else {
                                phi_1131_ = 5u;
                            }
                            let _e915 = phi_1131_;
                            let _e916 = (_e902 < _e915);
                            if _e916 {
                                let _e922 = p.member.frame;
                                let _e926 = p.member.current.size[0u];
                                let _e928 = p.member.current.size[1u];
                                switch bitcast<i32>(_e900) {
                                    case 1: {
                                        let _e938 = lt_mask_pattern_plus(_e902);
                                        phi_1211_ = vec2<i32>(_e938.x, _e938.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e942 = lt_mask_pattern_cross(_e902);
                                        phi_1211_ = vec2<i32>(_e942.x, _e942.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e948 = lt_mask_pattern_plus_or_cross(_e902, ((_e816.pixel.x + _e816.pixel.y) & 1u));
                                        phi_1211_ = vec2<i32>(_e948.x, _e948.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e953 = lt_mask_pattern_plus_or_cross(_e902, (_e922 & 1u));
                                        phi_1211_ = vec2<i32>(_e953.x, _e953.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e922 & 3u)) {
                                            case 0: {
                                                phi_1191_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_1191_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_1191_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_1191_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e964 = phi_1191_;
                                        phi_1211_ = (_e964 + vec2<i32>(bitcast<i32>((_e902 & 1u)), bitcast<i32>(((_e902 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_1211_ = vec2<i32>((bitcast<i32>((_e902 % 5u)) - 2i), (bitcast<i32>(((_e902 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e981 = lt_mask_pattern_diamond(_e902);
                                        phi_1211_ = vec2<i32>(_e981.x, _e981.y);
                                        break;
                                    }
                                    default: {
                                        phi_1211_ = vec2<i32>((bitcast<i32>((_e902 % 3u)) - 1i), (bitcast<i32>(((_e902 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e986 = phi_1211_;
                                let _e989 = lt_mask_pattern_step_clamped(_e816.pixel.x, _e986.x, _e926);
                                let _e990 = lt_mask_pattern_step_clamped(_e816.pixel.y, _e986.y, _e928);
                                let _e997 = ((((_e990 * _e111) + _e989) * _e107.words) + _e107.light.word);
                                if (_e107.light.shift > 29u) {
                                    let _e1001 = (_e997 + 1u);
                                    if (_e1001 < _e66) {
                                    } else {
                                        return;
                                    }
                                    let _e1005 = last_bits.member[(0u + _e1001)];
                                    phi_1238_ = _e1005;
                                } else {
                                    phi_1238_ = 0u;
                                }
                                let _e1007 = phi_1238_;
                                if (_e997 < _e66) {
                                } else {
                                    return;
                                }
                                let _e1013 = last_bits.member[(0u + _e997)];
                                let _e1016 = (_e1013 >> bitcast<u32>((_e107.light.shift & 31u)));
                                if (_e107.light.shift > 29u) {
                                    phi_1257_ = (_e1016 | (_e1007 << bitcast<u32>(((32u - _e107.light.shift) & 31u))));
                                } else {
                                    phi_1257_ = _e1016;
                                }
                                let _e1024 = phi_1257_;
                                if ((_e1024 & 2u) == 0u) {
                                    phi_1265_ = (_e1024 & 1u);
                                } else {
                                    phi_1265_ = (_e1024 & 7u);
                                }
                                let _e1030 = phi_1265_;
                                if _e904.any_expands {
                                    phi_1353_ = true;
                                } else {
                                    if ((_e1030 & 2u) != 0u) {
                                        let _e1037 = (((_e1030 & 4u) != 0u) != _e274);
                                        switch bitcast<i32>(_e893) {
                                            case 1: {
                                                phi_1293_ = bool();
                                                phi_1294_ = false;
                                                phi_1295_ = true;
                                                phi_1296_ = false;
                                                phi_1297_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e1037 {
                                                    phi_1291_ = (((_e1030 & 4u) != 0u) != ((_e1030 & 1u) != 0u));
                                                    phi_1292_ = false;
                                                } else {
                                                    phi_1291_ = bool();
                                                    phi_1292_ = true;
                                                }
                                                let _e1045 = phi_1291_;
                                                let _e1047 = phi_1292_;
                                                phi_1293_ = _e1045;
                                                phi_1294_ = false;
                                                phi_1295_ = false;
                                                phi_1296_ = _e1047;
                                                phi_1297_ = _e1037;
                                                break;
                                            }
                                            default: {
                                                phi_1293_ = bool();
                                                phi_1294_ = true;
                                                phi_1295_ = false;
                                                phi_1296_ = false;
                                                phi_1297_ = false;
                                                break;
                                            }
                                        }
                                        let _e1049 = phi_1293_;
                                        let _e1051 = phi_1294_;
                                        let _e1053 = phi_1295_;
                                        let _e1055 = phi_1296_;
                                        let _e1057 = phi_1297_;
                                        phi_1305_ = _e1037;
                                        phi_1306_ = _e1049;
                                        phi_1307_ = _e1051;
                                        phi_1308_ = _e1053;
                                        phi_1309_ = _e1055;
                                        phi_1310_ = _e1057;
                                    } else {
                                        switch bitcast<i32>(_e893) {
                                            case 1: {
                                                phi_1302_ = false;
                                                phi_1303_ = true;
                                                phi_1304_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_1302_ = false;
                                                phi_1303_ = false;
                                                phi_1304_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_1302_ = true;
                                                phi_1303_ = false;
                                                phi_1304_ = false;
                                                break;
                                            }
                                        }
                                        let _e1060 = phi_1302_;
                                        let _e1062 = phi_1303_;
                                        let _e1064 = phi_1304_;
                                        phi_1305_ = false;
                                        phi_1306_ = bool();
                                        phi_1307_ = _e1060;
                                        phi_1308_ = _e1062;
                                        phi_1309_ = _e1064;
                                        phi_1310_ = false;
                                    }
                                    let _e1066 = phi_1305_;
                                    let _e1068 = phi_1306_;
                                    let _e1070 = phi_1307_;
                                    let _e1072 = phi_1308_;
                                    let _e1074 = phi_1309_;
                                    let _e1076 = phi_1310_;
                                    if _e1070 {
                                        if ((_e1030 & 2u) != 0u) {
                                            if (((_e1030 & 4u) != 0u) != _e274) {
                                                phi_1325_ = false;
                                            } else {
                                                phi_1325_ = true;
                                            }
                                            let _e1083 = phi_1325_;
                                            phi_1326_ = _e1083;
                                        } else {
                                            phi_1326_ = true;
                                        }
                                        let _e1085 = phi_1326_;
                                        if _e1085 {
                                            phi_1333_ = (((_e1030 & 1u) != 0u) != _e274);
                                        } else {
                                            phi_1333_ = true;
                                        }
                                        let _e1090 = phi_1333_;
                                        phi_1334_ = _e1090;
                                        phi_1335_ = false;
                                        phi_1336_ = false;
                                        phi_1337_ = false;
                                    } else {
                                        phi_1334_ = bool();
                                        phi_1335_ = _e1072;
                                        phi_1336_ = _e1074;
                                        phi_1337_ = _e1076;
                                    }
                                    let _e1092 = phi_1334_;
                                    let _e1094 = phi_1335_;
                                    let _e1096 = phi_1336_;
                                    let _e1098 = phi_1337_;
                                    if _e1094 {
                                        phi_1341_ = _e1066;
                                        phi_1342_ = false;
                                        phi_1343_ = false;
                                    } else {
                                        phi_1341_ = _e1092;
                                        phi_1342_ = _e1096;
                                        phi_1343_ = _e1098;
                                    }
                                    let _e1100 = phi_1341_;
                                    let _e1102 = phi_1342_;
                                    let _e1104 = phi_1343_;
                                    if _e1102 {
                                        phi_1347_ = false;
                                        phi_1348_ = true;
                                    } else {
                                        phi_1347_ = _e1068;
                                        phi_1348_ = _e1104;
                                    }
                                    let _e1106 = phi_1347_;
                                    let _e1108 = phi_1348_;
                                    if _e1108 {
                                        phi_1352_ = _e1106;
                                    } else {
                                        phi_1352_ = _e1100;
                                    }
                                    let _e1110 = phi_1352_;
                                    phi_1353_ = _e1110;
                                }
                                let _e1112 = phi_1353_;
                                if _e904.all_remove {
                                    if (((_e1030 & 1u) != 0u) == _e274) {
                                        if ((_e1030 & 2u) != 0u) {
                                            phi_1371_ = (((_e1030 & 4u) != 0u) == _e274);
                                        } else {
                                            phi_1371_ = true;
                                        }
                                        let _e1122 = phi_1371_;
                                        phi_1372_ = _e1122;
                                    } else {
                                        phi_1372_ = false;
                                    }
                                    let _e1124 = phi_1372_;
                                    phi_1373_ = _e1124;
                                } else {
                                    phi_1373_ = false;
                                }
                                let _e1126 = phi_1373_;
                                phi_1106_ = (_e902 + 1u);
                                phi_1109_ = lt_mask_Neighbourhood(_e1112, _e1126);
                            } else {
                                phi_1106_ = u32();
                                phi_1109_ = lt_mask_Neighbourhood();
                            }
                            let _e1130 = phi_1106_;
                            let _e1132 = phi_1109_;
                            continue;
                            continuing {
                                phi_1105_ = _e1130;
                                phi_1108_ = _e1132;
                                break if !(_e916);
                            }
                        }
                        let _e1508 = local_1;
                        phi_1376_ = _e1508;
                    }
                    let _e1135 = phi_1376_;
                    phi_1377_ = _e1135;
                } else {
                    phi_1377_ = _e887;
                }
                let _e1137 = phi_1377_;
                phi_1378_ = _e1137;
            } else {
                phi_1378_ = _e887;
            }
            let _e1139 = phi_1378_;
            let _e1142 = p.member.frame;
            let _e1144 = p.member.refresh;
            if (_e1144 == 0u) {
                phi_1411_ = false;
            } else {
                if (_e1144 == 0u) {
                    return;
                }
                let _e1153 = ((_e60.x + (_e60.y * (((_e1144 * 5u) / 8u) | 1u))) + (_e1142 % _e1144));
                if (_e1144 == 0u) {
                    phi_1410_ = (_e1153 == 0u);
                } else {
                    if (_e1144 == 0u) {
                        return;
                    }
                    phi_1410_ = ((_e1153 % _e1144) == 0u);
                }
                let _e1160 = phi_1410_;
                phi_1411_ = _e1160;
            }
            let _e1162 = phi_1411_;
            if _e810 {
                if _e1162 {
                    phi_1433_ = bool();
                } else {
                    phi_1433_ = ((_e886 & 2u) != 0u);
                }
                let _e1168 = phi_1433_;
                phi_1434_ = _e1168;
                phi_1435_ = _e1162;
            } else {
                phi_1434_ = bool();
                phi_1435_ = true;
            }
            let _e1170 = phi_1434_;
            let _e1172 = phi_1435_;
            if _e1172 {
                phi_1439_ = false;
            } else {
                phi_1439_ = _e1170;
            }
            let _e1174 = phi_1439_;
            if _e1174 {
                phi_1490_ = 7u;
            } else {
                if (_e116 != 0.5f) {
                    if _e810 {
                        if _e1162 {
                            phi_1487_ = 6u;
                        } else {
                            if _e278 {
                                phi_1462_ = true;
                            } else {
                                if _e1139.any_expands {
                                    phi_1461_ = false;
                                } else {
                                    phi_1461_ = true;
                                }
                                let _e1176 = phi_1461_;
                                phi_1462_ = _e1176;
                            }
                            let _e1178 = phi_1462_;
                            if _e1178 {
                                if _e278 {
                                    if _e820 {
                                        if _e1139.all_remove {
                                            phi_1475_ = false;
                                        } else {
                                            phi_1475_ = true;
                                        }
                                        let _e1180 = phi_1475_;
                                        phi_1476_ = _e1180;
                                    } else {
                                        phi_1476_ = true;
                                    }
                                    let _e1182 = phi_1476_;
                                    phi_1477_ = _e1182;
                                } else {
                                    phi_1477_ = true;
                                }
                                let _e1184 = phi_1477_;
                                if _e1184 {
                                    if _e278 {
                                        phi_1484_ = 1u;
                                    } else {
                                        phi_1484_ = 0u;
                                    }
                                    let _e1186 = phi_1484_;
                                    phi_1485_ = _e1186;
                                } else {
                                    phi_1485_ = 5u;
                                }
                                let _e1188 = phi_1485_;
                                phi_1486_ = _e1188;
                            } else {
                                phi_1486_ = 4u;
                            }
                            let _e1190 = phi_1486_;
                            phi_1487_ = _e1190;
                        }
                        let _e1192 = phi_1487_;
                        phi_1488_ = _e1192;
                    } else {
                        phi_1488_ = 3u;
                    }
                    let _e1194 = phi_1488_;
                    phi_1489_ = _e1194;
                } else {
                    phi_1489_ = 2u;
                }
                let _e1196 = phi_1489_;
                phi_1490_ = _e1196;
            }
            let _e1198 = phi_1490_;
            if !((_e1198 == 0u)) {
                if !((_e1198 == 5u)) {
                    phi_1502_ = !(_e1174);
                    phi_1503_ = false;
                } else {
                    phi_1502_ = bool();
                    phi_1503_ = true;
                }
                let _e1205 = phi_1502_;
                let _e1207 = phi_1503_;
                phi_1504_ = _e1205;
                phi_1505_ = _e1207;
            } else {
                phi_1504_ = bool();
                phi_1505_ = true;
            }
            let _e1209 = phi_1504_;
            let _e1211 = phi_1505_;
            if _e1211 {
                phi_1509_ = false;
            } else {
                phi_1509_ = _e1209;
            }
            let _e1213 = phi_1509_;
            if _e1174 {
                phi_1515_ = ((_e886 & 4u) != 0u);
            } else {
                phi_1515_ = _e274;
            }
            let _e1217 = phi_1515_;
            if _e1213 {
                if _e274 {
                    phi_1523_ = (2u | 1u);
                } else {
                    phi_1523_ = 2u;
                }
                let _e1220 = phi_1523_;
                if false {
                    phi_1528_ = (_e1220 | 4u);
                } else {
                    phi_1528_ = _e1220;
                }
                let _e1223 = phi_1528_;
                phi_1548_ = _e1223;
            } else {
                if (_e1198 == 7u) {
                    if _e274 {
                        phi_1537_ = (2u | 1u);
                    } else {
                        phi_1537_ = 2u;
                    }
                    let _e1227 = phi_1537_;
                    if _e1217 {
                        phi_1542_ = (_e1227 | 4u);
                    } else {
                        phi_1542_ = _e1227;
                    }
                    let _e1230 = phi_1542_;
                    phi_1547_ = _e1230;
                } else {
                    if _e274 {
                        phi_1546_ = 1u;
                    } else {
                        phi_1546_ = 0u;
                    }
                    let _e1232 = phi_1546_;
                    phi_1547_ = _e1232;
                }
                let _e1234 = phi_1547_;
                phi_1548_ = _e1234;
            }
            let _e1236 = phi_1548_;
            if _e1217 {
                phi_1552_ = 0f;
            } else {
                phi_1552_ = 1f;
            }
            let _e1238 = phi_1552_;
            phi_1554_ = mask_Masked(_e1238, _e1236, _e1213);
        }
        let _e1241 = phi_1554_;
        visibility.member[_e80.shift] = _e1241.visibility;
        let _e1246 = p.member.light.number;
        let _e1247 = (_e1246 * 3u);
        let _e1249 = (_e1247 % 32u);
        let _e1251 = p.member.light.mask_words;
        let _e1253 = ((_e80.shift * _e1251) + (_e1247 / 32u));
        let _e1255 = bits.member[_e1253];
        bits.member[_e1253] = ((_e1255 & ~((7u << bitcast<u32>((_e1249 & 31u))))) | (_e1241.bits << bitcast<u32>((_e1249 & 31u))));
        if (_e1249 > 29u) {
            let _e1270 = bits.member[(_e1253 + 1u)];
            let _e1272 = (32u - _e1249);
            bits.member[(_e1253 + 1u)] = ((_e1270 & ~((7u >> bitcast<u32>((_e1272 & 31u))))) | (_e1241.bits >> bitcast<u32>((_e1272 & 31u))));
        }
        let _e1287 = samples.member[_e80.shift].normal[0u];
        let _e1289 = global[0u];
        if (_e1287 == _e1289) {
            let _e1292 = samples.member[_e80.shift].normal[1u];
            let _e1294 = global[1u];
            if (_e1292 == _e1294) {
                let _e1297 = samples.member[_e80.shift].normal[2u];
                let _e1299 = global[2u];
                phi_1626_ = (_e1297 == _e1299);
                phi_1627_ = false;
            } else {
                phi_1626_ = bool();
                phi_1627_ = true;
            }
            let _e1302 = phi_1626_;
            let _e1304 = phi_1627_;
            phi_1628_ = _e1302;
            phi_1629_ = _e1304;
        } else {
            phi_1628_ = bool();
            phi_1629_ = true;
        }
        let _e1306 = phi_1628_;
        let _e1308 = phi_1629_;
        if _e1308 {
            phi_1633_ = false;
        } else {
            phi_1633_ = _e1306;
        }
        let _e1310 = phi_1633_;
        if !(_e1310) {
            let _e1313 = samples.member[_e80.shift].position;
            let _e1315 = p.member.current.eye;
            let _e1326 = p.member.current.forward;
            phi_1661_ = ((((_e1313.x - _e1315.x) * _e1326.x) + ((_e1313.y - _e1315.y) * _e1326.y)) + ((_e1313.z - _e1315.z) * _e1326.z));
        } else {
            phi_1661_ = 0f;
        }
        let _e1336 = phi_1661_;
        depths.member[_e80.shift] = _e1336;
        phi_1664_ = _e1241.needs_ray;
        phi_1665_ = _e80.shift;
    } else {
        phi_1664_ = false;
        phi_1665_ = 0u;
    }
    let _e1340 = phi_1664_;
    let _e1342 = phi_1665_;
    if (_e61 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1340 {
        let _e1346 = atomicAdd((&shared_[0u]), 1u);
        phi_1676_ = _e1346;
    } else {
        phi_1676_ = 0u;
    }
    let _e1348 = phi_1676_;
    workgroupBarrier();
    if (_e61 == 0u) {
        let _e1352 = atomicLoad((&shared_[0u]));
        let _e1353 = atomicAdd((&list.member[3u]), _e1352);
        atomicStore((&shared_[1u]), _e1353);
    }
    workgroupBarrier();
    if _e1340 {
        let _e1356 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1356) + _e1348)]), _e1342);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_depth_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
