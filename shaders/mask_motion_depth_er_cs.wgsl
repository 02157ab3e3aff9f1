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
    var phi_996_: bool;
    var phi_1018_: u32;
    var phi_1020_: u32;
    var phi_1023_: lt_mask_Neighbourhood;
    var phi_1035_: bool;
    var phi_1036_: bool;
    var phi_1045_: u32;
    var phi_1046_: u32;
    var phi_1106_: vec2<i32>;
    var phi_1126_: vec2<i32>;
    var phi_1153_: u32;
    var phi_1172_: u32;
    var phi_1180_: u32;
    var phi_1206_: bool;
    var phi_1207_: bool;
    var phi_1208_: bool;
    var phi_1209_: bool;
    var phi_1210_: bool;
    var phi_1211_: bool;
    var phi_1212_: bool;
    var phi_1217_: bool;
    var phi_1218_: bool;
    var phi_1219_: bool;
    var phi_1220_: bool;
    var phi_1221_: bool;
    var phi_1222_: bool;
    var phi_1223_: bool;
    var phi_1224_: bool;
    var phi_1225_: bool;
    var phi_1240_: bool;
    var phi_1241_: bool;
    var phi_1248_: bool;
    var phi_1249_: bool;
    var phi_1250_: bool;
    var phi_1251_: bool;
    var phi_1252_: bool;
    var phi_1256_: bool;
    var phi_1257_: bool;
    var phi_1258_: bool;
    var phi_1262_: bool;
    var phi_1263_: bool;
    var phi_1267_: bool;
    var phi_1268_: bool;
    var phi_1286_: bool;
    var phi_1287_: bool;
    var phi_1288_: bool;
    var phi_1021_: u32;
    var phi_1024_: lt_mask_Neighbourhood;
    var phi_1291_: lt_mask_Neighbourhood;
    var phi_1292_: lt_mask_Neighbourhood;
    var phi_1293_: lt_mask_Neighbourhood;
    var phi_1325_: bool;
    var phi_1326_: bool;
    var phi_1348_: bool;
    var phi_1349_: bool;
    var phi_1350_: bool;
    var phi_1354_: bool;
    var phi_1376_: bool;
    var phi_1377_: bool;
    var phi_1390_: bool;
    var phi_1391_: bool;
    var phi_1392_: bool;
    var phi_1399_: u32;
    var phi_1400_: u32;
    var phi_1401_: u32;
    var phi_1402_: u32;
    var phi_1403_: u32;
    var phi_1404_: u32;
    var phi_1405_: u32;
    var phi_1417_: bool;
    var phi_1418_: bool;
    var phi_1419_: bool;
    var phi_1420_: bool;
    var phi_1424_: bool;
    var phi_1430_: bool;
    var phi_1438_: u32;
    var phi_1443_: u32;
    var phi_1452_: u32;
    var phi_1457_: u32;
    var phi_1461_: u32;
    var phi_1462_: u32;
    var phi_1463_: u32;
    var phi_1467_: f32;
    var phi_1469_: mask_Masked;
    var phi_1541_: bool;
    var phi_1542_: bool;
    var phi_1543_: bool;
    var phi_1544_: bool;
    var phi_1548_: bool;
    var phi_1576_: f32;
    var phi_1579_: bool;
    var phi_1580_: u32;
    var phi_1591_: u32;
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
            phi_1469_ = mask_Masked(_e269.unnamed.visibility, 0u, false);
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
            let _e817 = lt_mask_Neighbourhood(false, true);
            if _e278 {
                phi_996_ = false;
            } else {
                phi_996_ = true;
            }
            let _e819 = phi_996_;
            if _e819 {
                if _e810 {
                    if ((0u & 2u) != 0u) {
                        phi_1291_ = _e817;
                    } else {
                        let _e823 = p.member.expansion;
                        if _e816.has_moved {
                            let _e826 = p.member.moving_pattern;
                            phi_1018_ = _e826;
                        } else {
                            let _e828 = p.member.still_pattern;
                            phi_1018_ = _e828;
                        }
                        let _e830 = phi_1018_;
                        phi_1020_ = 0u;
                        phi_1023_ = _e817;
                        loop {
                            let _e832 = phi_1020_;
                            let _e834 = phi_1023_;
                            local_1 = _e834;
                            if (1u <= _e830) {
                                if (_e830 <= 4u) {
                                    phi_1035_ = false;
                                } else {
                                    phi_1035_ = true;
                                }
                                let _e838 = phi_1035_;
                                phi_1036_ = _e838;
                            } else {
                                phi_1036_ = true;
                            }
                            let _e840 = phi_1036_;
                            if _e840 {
                                switch bitcast<i32>(_e830) {
                                    case 5: {
                                        phi_1045_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_1045_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_1045_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_1045_ = 9u;
                                        break;
                                    }
                                }
                                let _e843 = phi_1045_;
                                phi_1046_ = _e843;
                            } else {
                                phi_1046_ = 5u;
                            }
                            let _e845 = phi_1046_;
                            let _e846 = (_e832 < _e845);
                            if _e846 {
                                let _e852 = p.member.frame;
                                let _e856 = p.member.current.size[0u];
                                let _e858 = p.member.current.size[1u];
                                switch bitcast<i32>(_e830) {
                                    case 1: {
                                        let _e868 = lt_mask_pattern_plus(_e832);
                                        phi_1126_ = vec2<i32>(_e868.x, _e868.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e872 = lt_mask_pattern_cross(_e832);
                                        phi_1126_ = vec2<i32>(_e872.x, _e872.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e878 = lt_mask_pattern_plus_or_cross(_e832, ((_e816.pixel.x + _e816.pixel.y) & 1u));
                                        phi_1126_ = vec2<i32>(_e878.x, _e878.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e883 = lt_mask_pattern_plus_or_cross(_e832, (_e852 & 1u));
                                        phi_1126_ = vec2<i32>(_e883.x, _e883.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e852 & 3u)) {
                                            case 0: {
                                                phi_1106_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_1106_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_1106_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_1106_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e894 = phi_1106_;
                                        phi_1126_ = (_e894 + vec2<i32>(bitcast<i32>((_e832 & 1u)), bitcast<i32>(((_e832 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_1126_ = vec2<i32>((bitcast<i32>((_e832 % 5u)) - 2i), (bitcast<i32>(((_e832 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e911 = lt_mask_pattern_diamond(_e832);
                                        phi_1126_ = vec2<i32>(_e911.x, _e911.y);
                                        break;
                                    }
                                    default: {
                                        phi_1126_ = vec2<i32>((bitcast<i32>((_e832 % 3u)) - 1i), (bitcast<i32>(((_e832 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e916 = phi_1126_;
                                let _e919 = lt_mask_pattern_step_clamped(_e816.pixel.x, _e916.x, _e856);
                                let _e920 = lt_mask_pattern_step_clamped(_e816.pixel.y, _e916.y, _e858);
                                let _e927 = ((((_e920 * _e111) + _e919) * _e107.words) + _e107.light.word);
                                if (_e107.light.shift > 29u) {
                                    let _e931 = (_e927 + 1u);
                                    if (_e931 < _e66) {
                                    } else {
                                        return;
                                    }
                                    let _e935 = last_bits.member[(0u + _e931)];
                                    phi_1153_ = _e935;
                                } else {
                                    phi_1153_ = 0u;
                                }
                                let _e937 = phi_1153_;
                                if (_e927 < _e66) {
                                } else {
                                    return;
                                }
                                let _e943 = last_bits.member[(0u + _e927)];
                                let _e946 = (_e943 >> bitcast<u32>((_e107.light.shift & 31u)));
                                if (_e107.light.shift > 29u) {
                                    phi_1172_ = (_e946 | (_e937 << bitcast<u32>(((32u - _e107.light.shift) & 31u))));
                                } else {
                                    phi_1172_ = _e946;
                                }
                                let _e954 = phi_1172_;
                                if ((_e954 & 2u) == 0u) {
                                    phi_1180_ = (_e954 & 1u);
                                } else {
                                    phi_1180_ = (_e954 & 7u);
                                }
                                let _e960 = phi_1180_;
                                if _e834.any_expands {
                                    phi_1268_ = true;
                                } else {
                                    if ((_e960 & 2u) != 0u) {
                                        let _e967 = (((_e960 & 4u) != 0u) != _e274);
                                        switch bitcast<i32>(_e823) {
                                            case 1: {
                                                phi_1208_ = bool();
                                                phi_1209_ = false;
                                                phi_1210_ = true;
                                                phi_1211_ = false;
                                                phi_1212_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e967 {
                                                    phi_1206_ = (((_e960 & 4u) != 0u) != ((_e960 & 1u) != 0u));
                                                    phi_1207_ = false;
                                                } else {
                                                    phi_1206_ = bool();
                                                    phi_1207_ = true;
                                                }
                                                let _e975 = phi_1206_;
                                                let _e977 = phi_1207_;
                                                phi_1208_ = _e975;
                                                phi_1209_ = false;
                                                phi_1210_ = false;
                                                phi_1211_ = _e977;
                                                phi_1212_ = _e967;
                                                break;
                                            }
                                            default: {
                                                phi_1208_ = bool();
                                                phi_1209_ = true;
                                                phi_1210_ = false;
                                                phi_1211_ = false;
                                                phi_1212_ = false;
                                                break;
                                            }
                                        }
                                        let _e979 = phi_1208_;
                                        let _e981 = phi_1209_;
                                        let _e983 = phi_1210_;
                                        let _e985 = phi_1211_;
                                        let _e987 = phi_1212_;
                                        phi_1220_ = _e967;
                                        phi_1221_ = _e979;
                                        phi_1222_ = _e981;
                                        phi_1223_ = _e983;
                                        phi_1224_ = _e985;
                                        phi_1225_ = _e987;
                                    } else {
                                        switch bitcast<i32>(_e823) {
                                            case 1: {
                                                phi_1217_ = false;
                                                phi_1218_ = true;
                                                phi_1219_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_1217_ = false;
                                                phi_1218_ = false;
                                                phi_1219_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_1217_ = true;
                                                phi_1218_ = false;
                                                phi_1219_ = false;
                                                break;
                                            }
                                        }
                                        let _e990 = phi_1217_;
                                        let _e992 = phi_1218_;
                                        let _e994 = phi_1219_;
                                        phi_1220_ = false;
                                        phi_1221_ = bool();
                                        phi_1222_ = _e990;
                                        phi_1223_ = _e992;
                                        phi_1224_ = _e994;
                                        phi_1225_ = false;
                                    }
                                    let _e996 = phi_1220_;
                                    let _e998 = phi_1221_;
                                    let _e1000 = phi_1222_;
                                    let _e1002 = phi_1223_;
                                    let _e1004 = phi_1224_;
                                    let _e1006 = phi_1225_;
                                    if _e1000 {
                                        if ((_e960 & 2u) != 0u) {
                                            if (((_e960 & 4u) != 0u) != _e274) {
                                                phi_1240_ = false;
                                            } else {
                                                phi_1240_ = true;
                                            }
                                            let _e1013 = phi_1240_;
                                            phi_1241_ = _e1013;
                                        } else {
                                            phi_1241_ = true;
                                        }
                                        let _e1015 = phi_1241_;
                                        if _e1015 {
                                            phi_1248_ = (((_e960 & 1u) != 0u) != _e274);
                                        } else {
                                            phi_1248_ = true;
                                        }
                                        let _e1020 = phi_1248_;
                                        phi_1249_ = _e1020;
                                        phi_1250_ = false;
                                        phi_1251_ = false;
                                        phi_1252_ = false;
                                    } else {
                                        phi_1249_ = bool();
                                        phi_1250_ = _e1002;
                                        phi_1251_ = _e1004;
                                        phi_1252_ = _e1006;
                                    }
                                    let _e1022 = phi_1249_;
                                    let _e1024 = phi_1250_;
                                    let _e1026 = phi_1251_;
                                    let _e1028 = phi_1252_;
                                    if _e1024 {
                                        phi_1256_ = _e996;
                                        phi_1257_ = false;
                                        phi_1258_ = false;
                                    } else {
                                        phi_1256_ = _e1022;
                                        phi_1257_ = _e1026;
                                        phi_1258_ = _e1028;
                                    }
                                    let _e1030 = phi_1256_;
                                    let _e1032 = phi_1257_;
                                    let _e1034 = phi_1258_;
                                    if _e1032 {
                                        phi_1262_ = false;
                                        phi_1263_ = true;
                                    } else {
                                        phi_1262_ = _e998;
                                        phi_1263_ = _e1034;
                                    }
                                    let _e1036 = phi_1262_;
                                    let _e1038 = phi_1263_;
                                    if _e1038 {
                                        phi_1267_ = _e1036;
                                    } else {
                                        phi_1267_ = _e1030;
                                    }
                                    let _e1040 = phi_1267_;
                                    phi_1268_ = _e1040;
                                }
                                let _e1042 = phi_1268_;
                                if _e834.all_remove {
                                    if (((_e960 & 1u) != 0u) == _e274) {
                                        if ((_e960 & 2u) != 0u) {
                                            phi_1286_ = (((_e960 & 4u) != 0u) == _e274);
                                        } else {
                                            phi_1286_ = true;
                                        }
                                        let _e1052 = phi_1286_;
                                        phi_1287_ = _e1052;
                                    } else {
                                        phi_1287_ = false;
                                    }
                                    let _e1054 = phi_1287_;
                                    phi_1288_ = _e1054;
                                } else {
                                    phi_1288_ = false;
                                }
                                let _e1056 = phi_1288_;
                                phi_1021_ = (_e832 + 1u);
                                phi_1024_ = lt_mask_Neighbourhood(_e1042, _e1056);
                            } else {
                                phi_1021_ = u32();
                                phi_1024_ = lt_mask_Neighbourhood();
                            }
                            let _e1060 = phi_1021_;
                            let _e1062 = phi_1024_;
                            continue;
                            continuing {
                                phi_1020_ = _e1060;
                                phi_1023_ = _e1062;
                                break if !(_e846);
                            }
                        }
                        let _e1425 = local_1;
                        phi_1291_ = _e1425;
                    }
                    let _e1065 = phi_1291_;
                    phi_1292_ = _e1065;
                } else {
                    phi_1292_ = _e817;
                }
                let _e1067 = phi_1292_;
                phi_1293_ = _e1067;
            } else {
                phi_1293_ = _e817;
            }
            let _e1069 = phi_1293_;
            let _e1072 = p.member.frame;
            let _e1074 = p.member.refresh;
            if (_e1074 == 0u) {
                phi_1326_ = false;
            } else {
                if (_e1074 == 0u) {
                    return;
                }
                let _e1083 = ((_e60.x + (_e60.y * (((_e1074 * 5u) / 8u) | 1u))) + (_e1072 % _e1074));
                if (_e1074 == 0u) {
                    phi_1325_ = (_e1083 == 0u);
                } else {
                    if (_e1074 == 0u) {
                        return;
                    }
                    phi_1325_ = ((_e1083 % _e1074) == 0u);
                }
                let _e1090 = phi_1325_;
                phi_1326_ = _e1090;
            }
            let _e1092 = phi_1326_;
            if _e810 {
                if _e1092 {
                    phi_1348_ = bool();
                } else {
                    phi_1348_ = ((0u & 2u) != 0u);
                }
                let _e1098 = phi_1348_;
                phi_1349_ = _e1098;
                phi_1350_ = _e1092;
            } else {
                phi_1349_ = bool();
                phi_1350_ = true;
            }
            let _e1100 = phi_1349_;
            let _e1102 = phi_1350_;
            if _e1102 {
                phi_1354_ = false;
            } else {
                phi_1354_ = _e1100;
            }
            let _e1104 = phi_1354_;
            if _e1104 {
                phi_1405_ = 7u;
            } else {
                if (_e116 != 0.5f) {
                    if _e810 {
                        if _e1092 {
                            phi_1402_ = 6u;
                        } else {
                            if _e278 {
                                phi_1377_ = true;
                            } else {
                                if _e1069.any_expands {
                                    phi_1376_ = false;
                                } else {
                                    phi_1376_ = true;
                                }
                                let _e1106 = phi_1376_;
                                phi_1377_ = _e1106;
                            }
                            let _e1108 = phi_1377_;
                            if _e1108 {
                                if _e278 {
                                    if false {
                                        if _e1069.all_remove {
                                            phi_1390_ = false;
                                        } else {
                                            phi_1390_ = true;
                                        }
                                        let _e1110 = phi_1390_;
                                        phi_1391_ = _e1110;
                                    } else {
                                        phi_1391_ = true;
                                    }
                                    let _e1112 = phi_1391_;
                                    phi_1392_ = _e1112;
                                } else {
                                    phi_1392_ = true;
                                }
                                let _e1114 = phi_1392_;
                                if _e1114 {
                                    if _e278 {
                                        phi_1399_ = 1u;
                                    } else {
                                        phi_1399_ = 0u;
                                    }
                                    let _e1116 = phi_1399_;
                                    phi_1400_ = _e1116;
                                } else {
                                    phi_1400_ = 5u;
                                }
                                let _e1118 = phi_1400_;
                                phi_1401_ = _e1118;
                            } else {
                                phi_1401_ = 4u;
                            }
                            let _e1120 = phi_1401_;
                            phi_1402_ = _e1120;
                        }
                        let _e1122 = phi_1402_;
                        phi_1403_ = _e1122;
                    } else {
                        phi_1403_ = 3u;
                    }
                    let _e1124 = phi_1403_;
                    phi_1404_ = _e1124;
                } else {
                    phi_1404_ = 2u;
                }
                let _e1126 = phi_1404_;
                phi_1405_ = _e1126;
            }
            let _e1128 = phi_1405_;
            if !((_e1128 == 0u)) {
                if !((_e1128 == 5u)) {
                    phi_1417_ = !(_e1104);
                    phi_1418_ = false;
                } else {
                    phi_1417_ = bool();
                    phi_1418_ = true;
                }
                let _e1135 = phi_1417_;
                let _e1137 = phi_1418_;
                phi_1419_ = _e1135;
                phi_1420_ = _e1137;
            } else {
                phi_1419_ = bool();
                phi_1420_ = true;
            }
            let _e1139 = phi_1419_;
            let _e1141 = phi_1420_;
            if _e1141 {
                phi_1424_ = false;
            } else {
                phi_1424_ = _e1139;
            }
            let _e1143 = phi_1424_;
            if _e1104 {
                phi_1430_ = ((0u & 4u) != 0u);
            } else {
                phi_1430_ = _e274;
            }
            let _e1147 = phi_1430_;
            if _e1143 {
                if _e274 {
                    phi_1438_ = (2u | 1u);
                } else {
                    phi_1438_ = 2u;
                }
                let _e1150 = phi_1438_;
                if false {
                    phi_1443_ = (_e1150 | 4u);
                } else {
                    phi_1443_ = _e1150;
                }
                let _e1153 = phi_1443_;
                phi_1463_ = _e1153;
            } else {
                if (_e1128 == 7u) {
                    if _e274 {
                        phi_1452_ = (2u | 1u);
                    } else {
                        phi_1452_ = 2u;
                    }
                    let _e1157 = phi_1452_;
                    if _e1147 {
                        phi_1457_ = (_e1157 | 4u);
                    } else {
                        phi_1457_ = _e1157;
                    }
                    let _e1160 = phi_1457_;
                    phi_1462_ = _e1160;
                } else {
                    if _e274 {
                        phi_1461_ = 1u;
                    } else {
                        phi_1461_ = 0u;
                    }
                    let _e1162 = phi_1461_;
                    phi_1462_ = _e1162;
                }
                let _e1164 = phi_1462_;
                phi_1463_ = _e1164;
            }
            let _e1166 = phi_1463_;
            if _e1147 {
                phi_1467_ = 0f;
            } else {
                phi_1467_ = 1f;
            }
            let _e1168 = phi_1467_;
            phi_1469_ = mask_Masked(_e1168, _e1166, _e1143);
        }
        let _e1171 = phi_1469_;
        visibility.member[_e80.shift] = _e1171.visibility;
        let _e1176 = p.member.light.number;
        let _e1177 = (_e1176 * 3u);
        let _e1179 = (_e1177 % 32u);
        let _e1181 = p.member.light.mask_words;
        let _e1183 = ((_e80.shift * _e1181) + (_e1177 / 32u));
        let _e1185 = bits.member[_e1183];
        bits.member[_e1183] = ((_e1185 & ~((7u << bitcast<u32>((_e1179 & 31u))))) | (_e1171.bits << bitcast<u32>((_e1179 & 31u))));
        if (_e1179 > 29u) {
            let _e1200 = bits.member[(_e1183 + 1u)];
            let _e1202 = (32u - _e1179);
            bits.member[(_e1183 + 1u)] = ((_e1200 & ~((7u >> bitcast<u32>((_e1202 & 31u))))) | (_e1171.bits >> bitcast<u32>((_e1202 & 31u))));
        }
        let _e1217 = samples.member[_e80.shift].normal[0u];
        let _e1219 = global[0u];
        if (_e1217 == _e1219) {
            let _e1222 = samples.member[_e80.shift].normal[1u];
            let _e1224 = global[1u];
            if (_e1222 == _e1224) {
                let _e1227 = samples.member[_e80.shift].normal[2u];
                let _e1229 = global[2u];
                phi_1541_ = (_e1227 == _e1229);
                phi_1542_ = false;
            } else {
                phi_1541_ = bool();
                phi_1542_ = true;
            }
            let _e1232 = phi_1541_;
            let _e1234 = phi_1542_;
            phi_1543_ = _e1232;
            phi_1544_ = _e1234;
        } else {
            phi_1543_ = bool();
            phi_1544_ = true;
        }
        let _e1236 = phi_1543_;
        let _e1238 = phi_1544_;
        if _e1238 {
            phi_1548_ = false;
        } else {
            phi_1548_ = _e1236;
        }
        let _e1240 = phi_1548_;
        if !(_e1240) {
            let _e1243 = samples.member[_e80.shift].position;
            let _e1245 = p.member.current.eye;
            let _e1256 = p.member.current.forward;
            phi_1576_ = ((((_e1243.x - _e1245.x) * _e1256.x) + ((_e1243.y - _e1245.y) * _e1256.y)) + ((_e1243.z - _e1245.z) * _e1256.z));
        } else {
            phi_1576_ = 0f;
        }
        let _e1266 = phi_1576_;
        depths.member[_e80.shift] = _e1266;
        phi_1579_ = _e1171.needs_ray;
        phi_1580_ = _e80.shift;
    } else {
        phi_1579_ = false;
        phi_1580_ = 0u;
    }
    let _e1270 = phi_1579_;
    let _e1272 = phi_1580_;
    if (_e61 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1270 {
        let _e1276 = atomicAdd((&shared_[0u]), 1u);
        phi_1591_ = _e1276;
    } else {
        phi_1591_ = 0u;
    }
    let _e1278 = phi_1591_;
    workgroupBarrier();
    if (_e61 == 0u) {
        let _e1282 = atomicLoad((&shared_[0u]));
        let _e1283 = atomicAdd((&list.member[3u]), _e1282);
        atomicStore((&shared_[1u]), _e1283);
    }
    workgroupBarrier();
    if _e1270 {
        let _e1286 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1286) + _e1278)]), _e1272);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_depth_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
