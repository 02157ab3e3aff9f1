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
    var phi_523_: bool;
    var phi_524_: bool;
    var phi_735_: f32;
    var phi_740_: f32;
    var phi_741_: bool;
    var phi_742_: f32;
    var phi_743_: bool;
    var phi_747_: f32;
    var phi_768_: f32;
    var phi_773_: f32;
    var phi_774_: bool;
    var phi_775_: f32;
    var phi_776_: bool;
    var phi_780_: f32;
    var phi_801_: bool;
    var phi_820_: vec2<u32>;
    var phi_821_: bool;
    var phi_822_: bool;
    var phi_823_: bool;
    var phi_824_: vec2<u32>;
    var phi_825_: bool;
    var phi_826_: bool;
    var phi_827_: bool;
    var phi_828_: bool;
    var phi_829_: bool;
    var phi_830_: bool;
    var phi_831_: vec2<u32>;
    var phi_832_: bool;
    var phi_833_: bool;
    var phi_834_: bool;
    var phi_835_: bool;
    var phi_836_: bool;
    var phi_837_: bool;
    var phi_838_: vec2<u32>;
    var phi_839_: bool;
    var phi_840_: bool;
    var phi_841_: bool;
    var phi_842_: bool;
    var phi_851_: bool;
    var phi_852_: bool;
    var phi_853_: bool;
    var phi_854_: bool;
    var phi_858_: bool;
    var phi_859_: bool;
    var phi_860_: vec2<u32>;
    var phi_898_: bool;
    var phi_900_: lt_mask_Reprojection;
    var phi_901_: lt_mask_Reprojection;
    var phi_902_: lt_mask_Reprojection;
    var phi_903_: bool;
    var phi_904_: bool;
    var phi_905_: lt_mask_Reprojection;
    var phi_906_: lt_mask_Reprojection;
    var phi_907_: lt_mask_Reprojection;
    var phi_908_: bool;
    var phi_909_: bool;
    var phi_964_: bool;
    var phi_968_: f32;
    var phi_972_: lt_mask_Reprojection;
    var phi_973_: bool;
    var phi_985_: bool;
    var phi_986_: bool;
    var phi_987_: bool;
    var phi_988_: lt_mask_Reprojection;
    var phi_989_: bool;
    var phi_993_: bool;
    var phi_994_: lt_mask_Reprojection;
    var phi_1037_: u32;
    var phi_1056_: u32;
    var phi_1064_: u32;
    var phi_1065_: u32;
    var phi_1066_: bool;
    var phi_1067_: u32;
    var phi_1068_: bool;
    var phi_1069_: bool;
    var phi_1070_: u32;
    var phi_1071_: bool;
    var phi_1072_: bool;
    var phi_1076_: bool;
    var phi_1080_: u32;
    var phi_1085_: bool;
    var phi_1107_: u32;
    var phi_1109_: u32;
    var phi_1112_: lt_mask_Neighbourhood;
    var phi_1124_: bool;
    var phi_1125_: bool;
    var phi_1134_: u32;
    var phi_1135_: u32;
    var phi_1195_: vec2<i32>;
    var phi_1215_: vec2<i32>;
    var phi_1242_: u32;
    var phi_1261_: u32;
    var phi_1269_: u32;
    var phi_1295_: bool;
    var phi_1296_: bool;
    var phi_1297_: bool;
    var phi_1298_: bool;
    var phi_1299_: bool;
    var phi_1300_: bool;
    var phi_1301_: bool;
    var phi_1306_: bool;
    var phi_1307_: bool;
    var phi_1308_: bool;
    var phi_1309_: bool;
    var phi_1310_: bool;
    var phi_1311_: bool;
    var phi_1312_: bool;
    var phi_1313_: bool;
    var phi_1314_: bool;
    var phi_1329_: bool;
    var phi_1330_: bool;
    var phi_1337_: bool;
    var phi_1338_: bool;
    var phi_1339_: bool;
    var phi_1340_: bool;
    var phi_1341_: bool;
    var phi_1345_: bool;
    var phi_1346_: bool;
    var phi_1347_: bool;
    var phi_1351_: bool;
    var phi_1352_: bool;
    var phi_1356_: bool;
    var phi_1357_: bool;
    var phi_1375_: bool;
    var phi_1376_: bool;
    var phi_1377_: bool;
    var phi_1110_: u32;
    var phi_1113_: lt_mask_Neighbourhood;
    var phi_1380_: lt_mask_Neighbourhood;
    var phi_1381_: lt_mask_Neighbourhood;
    var phi_1382_: lt_mask_Neighbourhood;
    var phi_1414_: bool;
    var phi_1415_: bool;
    var phi_1437_: bool;
    var phi_1438_: bool;
    var phi_1439_: bool;
    var phi_1443_: bool;
    var phi_1465_: bool;
    var phi_1466_: bool;
    var phi_1479_: bool;
    var phi_1480_: bool;
    var phi_1481_: bool;
    var phi_1488_: u32;
    var phi_1489_: u32;
    var phi_1490_: u32;
    var phi_1491_: u32;
    var phi_1492_: u32;
    var phi_1493_: u32;
    var phi_1494_: u32;
    var phi_1506_: bool;
    var phi_1507_: bool;
    var phi_1508_: bool;
    var phi_1509_: bool;
    var phi_1513_: bool;
    var phi_1519_: bool;
    var phi_1527_: u32;
    var phi_1532_: u32;
    var phi_1541_: u32;
    var phi_1546_: u32;
    var phi_1550_: u32;
    var phi_1551_: u32;
    var phi_1552_: u32;
    var phi_1556_: f32;
    var phi_1558_: mask_Masked;
    var phi_1630_: bool;
    var phi_1631_: bool;
    var phi_1632_: bool;
    var phi_1633_: bool;
    var phi_1637_: bool;
    var phi_1665_: f32;
    var phi_1668_: bool;
    var phi_1669_: u32;
    var phi_1680_: u32;
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
            phi_1558_ = mask_Masked(_e269.unnamed.visibility, 0u, false);
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
                phi_524_ = true;
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
                if _e327 {
                    phi_523_ = false;
                } else {
                    phi_523_ = true;
                }
                let _e329 = phi_523_;
                phi_524_ = _e329;
            }
            let _e331 = phi_524_;
            if _e331 {
                let _e333 = samples.member[_e80.shift].position;
                let _e337 = p.member.previous.eye;
                let _e340 = (_e114.x - _e337.x);
                let _e343 = (_e114.y - _e337.y);
                let _e346 = (_e114.z - _e337.z);
                let _e348 = p.member.previous.forward;
                let _e356 = (((_e340 * _e348.x) + (_e343 * _e348.y)) + (_e346 * _e348.z));
                let _e358 = p.member.previous.right;
                let _e368 = p.member.previous.right;
                let _e383 = p.member.previous.up;
                let _e393 = p.member.previous.up;
                let _e408 = p.member.current.eye;
                let _e411 = (_e333.x - _e408.x);
                let _e414 = (_e333.y - _e408.y);
                let _e417 = (_e333.z - _e408.z);
                let _e419 = p.member.current.forward;
                let _e427 = (((_e411 * _e419.x) + (_e414 * _e419.y)) + (_e417 * _e419.z));
                let _e429 = p.member.current.right;
                let _e439 = p.member.current.right;
                let _e454 = p.member.current.up;
                let _e464 = p.member.current.up;
                let _e483 = p.member.current.size[0u];
                let _e485 = (((((((_e340 * _e358.x) + (_e343 * _e358.y)) + (_e346 * _e358.z)) / ((((_e368.x * _e368.x) + (_e368.y * _e368.y)) + (_e368.z * _e368.z)) * _e356)) - ((((_e411 * _e429.x) + (_e414 * _e429.y)) + (_e417 * _e429.z)) / ((((_e439.x * _e439.x) + (_e439.y * _e439.y)) + (_e439.z * _e439.z)) * _e427))) * 0.5f) * f32(_e483));
                let _e489 = p.member.current.size[1u];
                let _e491 = (((((((_e340 * _e383.x) + (_e343 * _e383.y)) + (_e346 * _e383.z)) / ((((_e393.x * _e393.x) + (_e393.y * _e393.y)) + (_e393.z * _e393.z)) * _e356)) - ((((_e411 * _e454.x) + (_e414 * _e454.y)) + (_e417 * _e454.z)) / ((((_e464.x * _e464.x) + (_e464.y * _e464.y)) + (_e464.z * _e464.z)) * _e427))) * -0.5f) * f32(_e489));
                let _e495 = p.member.current.grid[0u];
                let _e497 = p.member.current.grid[1u];
                let _e517 = p.member.current.size[0u];
                let _e519 = p.member.current.size[1u];
                let _e521 = ((f32(_e60.x) + ((f32((_e60.y & (_e497 - 1u))) + 0.5f) / f32(_e497))) + _e485);
                if (_e521 > -8388608f) {
                    let _e533 = f32(select(0i, select(select(i32(_e521), i32(-2147483648), (_e521 < bitcast<f32>(3472883712u))), 2147483647i, (_e521 > bitcast<f32>(1325400063u))), (_e521 == _e521)));
                    if (_e533 > _e521) {
                        phi_735_ = 1f;
                    } else {
                        phi_735_ = 0f;
                    }
                    let _e536 = phi_735_;
                    if (_e521 < 8388608f) {
                        phi_740_ = (_e533 - _e536);
                        phi_741_ = false;
                    } else {
                        phi_740_ = f32();
                        phi_741_ = true;
                    }
                    let _e539 = phi_740_;
                    let _e541 = phi_741_;
                    phi_742_ = _e539;
                    phi_743_ = _e541;
                } else {
                    phi_742_ = f32();
                    phi_743_ = true;
                }
                let _e543 = phi_742_;
                let _e545 = phi_743_;
                if _e545 {
                    phi_747_ = _e521;
                } else {
                    phi_747_ = _e543;
                }
                let _e547 = phi_747_;
                let _e548 = ((f32(_e60.y) + ((f32((_e60.x & (_e495 - 1u))) + 0.5f) / f32(_e495))) + _e491);
                if (_e548 > -8388608f) {
                    let _e560 = f32(select(0i, select(select(i32(_e548), i32(-2147483648), (_e548 < bitcast<f32>(3472883712u))), 2147483647i, (_e548 > bitcast<f32>(1325400063u))), (_e548 == _e548)));
                    if (_e560 > _e548) {
                        phi_768_ = 1f;
                    } else {
                        phi_768_ = 0f;
                    }
                    let _e563 = phi_768_;
                    if (_e548 < 8388608f) {
                        phi_773_ = (_e560 - _e563);
                        phi_774_ = false;
                    } else {
                        phi_773_ = f32();
                        phi_774_ = true;
                    }
                    let _e566 = phi_773_;
                    let _e568 = phi_774_;
                    phi_775_ = _e566;
                    phi_776_ = _e568;
                } else {
                    phi_775_ = f32();
                    phi_776_ = true;
                }
                let _e570 = phi_775_;
                let _e572 = phi_776_;
                if _e572 {
                    phi_780_ = _e548;
                } else {
                    phi_780_ = _e570;
                }
                let _e574 = phi_780_;
                if (_e547 >= 0f) {
                    if (_e574 >= 0f) {
                        if (_e547 < f32(_e517)) {
                            let _e580 = (_e574 < f32(_e519));
                            if (_e485 == 0f) {
                                phi_801_ = (_e491 == 0f);
                            } else {
                                phi_801_ = false;
                            }
                            let _e584 = phi_801_;
                            if _e580 {
                                phi_820_ = vec2<u32>(select(select(u32(_e547), 0u, (_e547 < bitcast<f32>(0u))), 4294967295u, (_e547 > bitcast<f32>(1333788671u))), select(select(u32(_e574), 0u, (_e574 < bitcast<f32>(0u))), 4294967295u, (_e574 > bitcast<f32>(1333788671u))));
                                phi_821_ = false;
                            } else {
                                phi_820_ = vec2<u32>();
                                phi_821_ = true;
                            }
                            let _e601 = phi_820_;
                            let _e603 = phi_821_;
                            phi_822_ = _e584;
                            phi_823_ = _e580;
                            phi_824_ = _e601;
                            phi_825_ = _e584;
                            phi_826_ = _e580;
                            phi_827_ = false;
                            phi_828_ = _e603;
                        } else {
                            phi_822_ = bool();
                            phi_823_ = bool();
                            phi_824_ = vec2<u32>();
                            phi_825_ = bool();
                            phi_826_ = bool();
                            phi_827_ = true;
                            phi_828_ = false;
                        }
                        let _e605 = phi_822_;
                        let _e607 = phi_823_;
                        let _e609 = phi_824_;
                        let _e611 = phi_825_;
                        let _e613 = phi_826_;
                        let _e615 = phi_827_;
                        let _e617 = phi_828_;
                        phi_829_ = _e605;
                        phi_830_ = _e607;
                        phi_831_ = _e609;
                        phi_832_ = _e611;
                        phi_833_ = _e613;
                        phi_834_ = _e615;
                        phi_835_ = _e617;
                    } else {
                        phi_829_ = bool();
                        phi_830_ = bool();
                        phi_831_ = vec2<u32>();
                        phi_832_ = bool();
                        phi_833_ = bool();
                        phi_834_ = true;
                        phi_835_ = false;
                    }
                    let _e619 = phi_829_;
                    let _e621 = phi_830_;
                    let _e623 = phi_831_;
                    let _e625 = phi_832_;
                    let _e627 = phi_833_;
                    let _e629 = phi_834_;
                    let _e631 = phi_835_;
                    phi_836_ = _e619;
                    phi_837_ = _e621;
                    phi_838_ = _e623;
                    phi_839_ = _e625;
                    phi_840_ = _e627;
                    phi_841_ = _e629;
                    phi_842_ = _e631;
                } else {
                    phi_836_ = bool();
                    phi_837_ = bool();
                    phi_838_ = vec2<u32>();
                    phi_839_ = bool();
                    phi_840_ = bool();
                    phi_841_ = true;
                    phi_842_ = false;
                }
                let _e633 = phi_836_;
                let _e635 = phi_837_;
                let _e637 = phi_838_;
                let _e639 = phi_839_;
                let _e641 = phi_840_;
                let _e643 = phi_841_;
                let _e645 = phi_842_;
                if _e643 {
                    if (_e485 == 0f) {
                        phi_851_ = (_e491 == 0f);
                    } else {
                        phi_851_ = false;
                    }
                    let _e649 = phi_851_;
                    phi_852_ = _e649;
                    phi_853_ = false;
                    phi_854_ = true;
                } else {
                    phi_852_ = _e639;
                    phi_853_ = _e641;
                    phi_854_ = _e645;
                }
                let _e651 = phi_852_;
                let _e653 = phi_853_;
                let _e655 = phi_854_;
                if _e655 {
                    phi_858_ = _e651;
                    phi_859_ = _e653;
                    phi_860_ = vec2<u32>(_e60.x, _e60.y);
                } else {
                    phi_858_ = _e633;
                    phi_859_ = _e635;
                    phi_860_ = _e637;
                }
                let _e657 = phi_858_;
                let _e659 = phi_859_;
                let _e661 = phi_860_;
                let _e671 = lt_mask_Reprojection(vec2<u32>(_e661.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
                let _e678 = lt_mask_Reprojection(vec2<u32>(_e671.pixel.x, _e661.y), _e671.is_valid, _e671.has_moved);
                let _e682 = lt_mask_Reprojection(_e678.pixel, _e659, _e678.has_moved);
                let _e686 = lt_mask_Reprojection(_e682.pixel, _e682.is_valid, !(_e657));
                if _e659 {
                    let _e689 = p.member.previous.eye;
                    let _e700 = p.member.previous.forward;
                    let _e709 = (((((_e114.x - _e689.x) * _e700.x) + ((_e114.y - _e689.y) * _e700.y)) + ((_e114.z - _e689.z) * _e700.z)) > 0f);
                    let _e713 = lt_mask_Reprojection(_e686.pixel, _e709, _e686.has_moved);
                    if _e709 {
                        phi_898_ = false;
                    } else {
                        phi_898_ = true;
                    }
                    let _e715 = phi_898_;
                    phi_900_ = _e713;
                    phi_901_ = _e713;
                    phi_902_ = lt_mask_Reprojection();
                    phi_903_ = _e709;
                    phi_904_ = _e715;
                } else {
                    phi_900_ = lt_mask_Reprojection();
                    phi_901_ = lt_mask_Reprojection();
                    phi_902_ = lt_mask_Reprojection(_e686.pixel, false, _e686.has_moved);
                    phi_903_ = false;
                    phi_904_ = false;
                }
                let _e721 = phi_900_;
                let _e723 = phi_901_;
                let _e725 = phi_902_;
                let _e727 = phi_903_;
                let _e729 = phi_904_;
                phi_905_ = _e721;
                phi_906_ = _e723;
                phi_907_ = _e725;
                phi_908_ = _e727;
                phi_909_ = _e729;
            } else {
                phi_905_ = lt_mask_Reprojection(_e296.pixel, _e296.is_valid, false);
                phi_906_ = lt_mask_Reprojection();
                phi_907_ = lt_mask_Reprojection();
                phi_908_ = true;
                phi_909_ = false;
            }
            let _e731 = phi_905_;
            let _e733 = phi_906_;
            let _e735 = phi_907_;
            let _e737 = phi_908_;
            let _e739 = phi_909_;
            if _e737 {
                let _e742 = p.member.previous.eye;
                let _e753 = p.member.previous.forward;
                let _e761 = ((((_e114.x - _e742.x) * _e753.x) + ((_e114.y - _e742.y) * _e753.y)) + ((_e114.z - _e742.z) * _e753.z));
                let _e767 = ((_e731.pixel.y * _e111) + _e731.pixel.x);
                if (_e767 < arrayLength((&last_depths.member))) {
                } else {
                    return;
                }
                let _e771 = last_depths.member[(0u + _e767)];
                let _e773 = p.member.depth_tolerance;
                let _e776 = abs(_e761);
                let _e777 = abs(_e771);
                if ((bitcast<u32>(_e777) & 2147483647u) > 2139095040u) {
                    phi_964_ = true;
                } else {
                    let _e781 = (_e777 > _e776);
                    if _e781 {
                    }
                    phi_964_ = _e781;
                }
                let _e783 = phi_964_;
                if _e783 {
                    phi_968_ = _e777;
                } else {
                    phi_968_ = _e776;
                }
                let _e785 = phi_968_;
                phi_972_ = lt_mask_Reprojection(_e731.pixel, (abs((_e761 - _e771)) <= (_e773 * _e785)), _e731.has_moved);
                phi_973_ = true;
            } else {
                phi_972_ = _e733;
                phi_973_ = _e739;
            }
            let _e793 = phi_972_;
            let _e795 = phi_973_;
            if _e795 {
                if _e793.is_valid {
                    let _e798 = p.member.flags;
                    phi_985_ = ((_e798 & 1u) != 0u);
                    phi_986_ = false;
                } else {
                    phi_985_ = bool();
                    phi_986_ = true;
                }
                let _e802 = phi_985_;
                let _e804 = phi_986_;
                phi_987_ = _e802;
                phi_988_ = _e793;
                phi_989_ = _e804;
            } else {
                phi_987_ = bool();
                phi_988_ = _e735;
                phi_989_ = true;
            }
            let _e806 = phi_987_;
            let _e808 = phi_988_;
            let _e810 = phi_989_;
            if _e810 {
                phi_993_ = false;
                phi_994_ = _e808;
            } else {
                phi_993_ = _e806;
                phi_994_ = _e793;
            }
            let _e812 = phi_993_;
            let _e814 = phi_994_;
            let _e818 = lt_mask_Reprojection(_e814.pixel, _e812, _e814.has_moved);
            let _e820 = p.member.flags;
            let _e822 = ((_e820 & 2u) != 0u);
            let _e824 = p.member.flags;
            if ((_e824 & 4u) == 0u) {
                phi_1070_ = u32();
                phi_1071_ = true;
                phi_1072_ = false;
            } else {
                if _e812 {
                    if !(_e818.has_moved) {
                        let _e835 = ((((_e60.y * _e111) + _e60.x) * _e107.words) + _e107.light.word);
                        if (_e107.light.shift > 29u) {
                            let _e839 = (_e835 + 1u);
                            if (_e839 < _e66) {
                            } else {
                                return;
                            }
                            let _e843 = last_bits.member[(0u + _e839)];
                            phi_1037_ = _e843;
                        } else {
                            phi_1037_ = 0u;
                        }
                        let _e845 = phi_1037_;
                        if (_e835 < _e66) {
                        } else {
                            return;
                        }
                        let _e851 = last_bits.member[(0u + _e835)];
                        let _e854 = (_e851 >> bitcast<u32>((_e107.light.shift & 31u)));
                        if (_e107.light.shift > 29u) {
                            phi_1056_ = (_e854 | (_e845 << bitcast<u32>(((32u - _e107.light.shift) & 31u))));
                        } else {
                            phi_1056_ = _e854;
                        }
                        let _e862 = phi_1056_;
                        if ((_e862 & 2u) == 0u) {
                            phi_1064_ = (_e862 & 1u);
                        } else {
                            phi_1064_ = (_e862 & 7u);
                        }
                        let _e868 = phi_1064_;
                        phi_1065_ = _e868;
                        phi_1066_ = false;
                    } else {
                        phi_1065_ = u32();
                        phi_1066_ = true;
                    }
                    let _e870 = phi_1065_;
                    let _e872 = phi_1066_;
                    phi_1067_ = _e870;
                    phi_1068_ = false;
                    phi_1069_ = _e872;
                } else {
                    phi_1067_ = u32();
                    phi_1068_ = true;
                    phi_1069_ = false;
                }
                let _e874 = phi_1067_;
                let _e876 = phi_1068_;
                let _e878 = phi_1069_;
                phi_1070_ = _e874;
                phi_1071_ = _e876;
                phi_1072_ = _e878;
            }
            let _e880 = phi_1070_;
            let _e882 = phi_1071_;
            let _e884 = phi_1072_;
            if _e882 {
                phi_1076_ = true;
            } else {
                phi_1076_ = _e884;
            }
            let _e886 = phi_1076_;
            if _e886 {
                phi_1080_ = 0u;
            } else {
                phi_1080_ = _e880;
            }
            let _e888 = phi_1080_;
            let _e889 = lt_mask_Neighbourhood(false, true);
            if _e278 {
                phi_1085_ = _e822;
            } else {
                phi_1085_ = true;
            }
            let _e891 = phi_1085_;
            if _e891 {
                if _e812 {
                    if ((_e888 & 2u) != 0u) {
                        phi_1380_ = _e889;
                    } else {
                        let _e895 = p.member.expansion;
                        if _e818.has_moved {
                            let _e898 = p.member.moving_pattern;
                            phi_1107_ = _e898;
                        } else {
                            let _e900 = p.member.still_pattern;
                            phi_1107_ = _e900;
                        }
                        let _e902 = phi_1107_;
                        phi_1109_ = 0u;
                        phi_1112_ = _e889;
                        loop {
                            let _e904 = phi_1109_;
                            let _e906 = phi_1112_;
                            local_1 = _e906;
                            if (1u <= _e902) {
                                if (_e902 <= 4u) {
                                    phi_1124_ = false;
                                } else {
                                    phi_1124_ = true;
                                }
                                let _e910 = phi_1124_;
                                phi_1125_ = _e910;
                            } else {
                                phi_1125_ = true;
                            }
                            let _e912 = phi_1125_;
                            if _e912 {
                                switch bitcast<i32>(_e902) {
                                    case 5: {
                                        phi_1134_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_1134_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_1134_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_1134_ = 9u;
                                        break;
                                    }
                                }
                                let _e915 = phi_1134_;
                                phi_1135_ = _e915;
                            } else {
                                phi_1135_ = 5u;
                            }
                            let _e917 = phi_1135_;
                            let _e918 = (_e904 < _e917);
                            if _e918 {
                                let _e924 = p.member.frame;
                                let _e928 = p.member.current.size[0u];
                                let _e930 = p.member.current.size[1u];
                                switch bitcast<i32>(_e902) {
                                    case 1: {
                                        let _e940 = lt_mask_pattern_plus(_e904);
                                        phi_1215_ = vec2<i32>(_e940.x, _e940.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e944 = lt_mask_pattern_cross(_e904);
                                        phi_1215_ = vec2<i32>(_e944.x, _e944.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e950 = lt_mask_pattern_plus_or_cross(_e904, ((_e818.pixel.x + _e818.pixel.y) & 1u));
                                        phi_1215_ = vec2<i32>(_e950.x, _e950.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e955 = lt_mask_pattern_plus_or_cross(_e904, (_e924 & 1u));
                                        phi_1215_ = vec2<i32>(_e955.x, _e955.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e924 & 3u)) {
                                            case 0: {
                                                phi_1195_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_1195_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_1195_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_1195_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e966 = phi_1195_;
                                        phi_1215_ = (_e966 + vec2<i32>(bitcast<i32>((_e904 & 1u)), bitcast<i32>(((_e904 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_1215_ = vec2<i32>((bitcast<i32>((_e904 % 5u)) - 2i), (bitcast<i32>(((_e904 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e983 = lt_mask_pattern_diamond(_e904);
                                        phi_1215_ = vec2<i32>(_e983.x, _e983.y);
                                        break;
                                    }
                                    default: {
                                        phi_1215_ = vec2<i32>((bitcast<i32>((_e904 % 3u)) - 1i), (bitcast<i32>(((_e904 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e988 = phi_1215_;
                                let _e991 = lt_mask_pattern_step_clamped(_e818.pixel.x, _e988.x, _e928);
                                let _e992 = lt_mask_pattern_step_clamped(_e818.pixel.y, _e988.y, _e930);
                                let _e999 = ((((_e992 * _e111) + _e991) * _e107.words) + _e107.light.word);
                                if (_e107.light.shift > 29u) {
                                    let _e1003 = (_e999 + 1u);
                                    if (_e1003 < _e66) {
                                    } else {
                                        return;
                                    }
                                    let _e1007 = last_bits.member[(0u + _e1003)];
                                    phi_1242_ = _e1007;
                                } else {
                                    phi_1242_ = 0u;
                                }
                                let _e1009 = phi_1242_;
                                if (_e999 < _e66) {
                                } else {
                                    return;
                                }
                                let _e1015 = last_bits.member[(0u + _e999)];
                                let _e1018 = (_e1015 >> bitcast<u32>((_e107.light.shift & 31u)));
                                if (_e107.light.shift > 29u) {
                                    phi_1261_ = (_e1018 | (_e1009 << bitcast<u32>(((32u - _e107.light.shift) & 31u))));
                                } else {
                                    phi_1261_ = _e1018;
                                }
                                let _e1026 = phi_1261_;
                                if ((_e1026 & 2u) == 0u) {
                                    phi_1269_ = (_e1026 & 1u);
                                } else {
                                    phi_1269_ = (_e1026 & 7u);
                                }
                                let _e1032 = phi_1269_;
                                if _e906.any_expands {
                                    phi_1357_ = true;
                                } else {
                                    if ((_e1032 & 2u) != 0u) {
                                        let _e1039 = (((_e1032 & 4u) != 0u) != _e274);
                                        switch bitcast<i32>(_e895) {
                                            case 1: {
                                                phi_1297_ = bool();
                                                phi_1298_ = false;
                                                phi_1299_ = true;
                                                phi_1300_ = false;
                                                phi_1301_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e1039 {
                                                    phi_1295_ = (((_e1032 & 4u) != 0u) != ((_e1032 & 1u) != 0u));
                                                    phi_1296_ = false;
                                                } else {
                                                    phi_1295_ = bool();
                                                    phi_1296_ = true;
                                                }
                                                let _e1047 = phi_1295_;
                                                let _e1049 = phi_1296_;
                                                phi_1297_ = _e1047;
                                                phi_1298_ = false;
                                                phi_1299_ = false;
                                                phi_1300_ = _e1049;
                                                phi_1301_ = _e1039;
                                                break;
                                            }
                                            default: {
                                                phi_1297_ = bool();
                                                phi_1298_ = true;
                                                phi_1299_ = false;
                                                phi_1300_ = false;
                                                phi_1301_ = false;
                                                break;
                                            }
                                        }
                                        let _e1051 = phi_1297_;
                                        let _e1053 = phi_1298_;
                                        let _e1055 = phi_1299_;
                                        let _e1057 = phi_1300_;
                                        let _e1059 = phi_1301_;
                                        phi_1309_ = _e1039;
                                        phi_1310_ = _e1051;
                                        phi_1311_ = _e1053;
                                        phi_1312_ = _e1055;
                                        phi_1313_ = _e1057;
                                        phi_1314_ = _e1059;
                                    } else {
                                        switch bitcast<i32>(_e895) {
                                            case 1: {
                                                phi_1306_ = false;
                                                phi_1307_ = true;
                                                phi_1308_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_1306_ = false;
                                                phi_1307_ = false;
                                                phi_1308_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_1306_ = true;
                                                phi_1307_ = false;
                                                phi_1308_ = false;
                                                break;
                                            }
                                        }
                                        let _e1062 = phi_1306_;
                                        let _e1064 = phi_1307_;
                                        let _e1066 = phi_1308_;
                                        phi_1309_ = false;
                                        phi_1310_ = bool();
                                        phi_1311_ = _e1062;
                                        phi_1312_ = _e1064;
                                        phi_1313_ = _e1066;
                                        phi_1314_ = false;
                                    }
                                    let _e1068 = phi_1309_;
                                    let _e1070 = phi_1310_;
                                    let _e1072 = phi_1311_;
                                    let _e1074 = phi_1312_;
                                    let _e1076 = phi_1313_;
                                    let _e1078 = phi_1314_;
                                    if _e1072 {
                                        if ((_e1032 & 2u) != 0u) {
                                            if (((_e1032 & 4u) != 0u) != _e274) {
                                                phi_1329_ = false;
                                            } else {
                                                phi_1329_ = true;
                                            }
                                            let _e1085 = phi_1329_;
                                            phi_1330_ = _e1085;
                                        } else {
                                            phi_1330_ = true;
                                        }
                                        let _e1087 = phi_1330_;
                                        if _e1087 {
                                            phi_1337_ = (((_e1032 & 1u) != 0u) != _e274);
                                        } else {
                                            phi_1337_ = true;
                                        }
                                        let _e1092 = phi_1337_;
                                        phi_1338_ = _e1092;
                                        phi_1339_ = false;
                                        phi_1340_ = false;
                                        phi_1341_ = false;
                                    } else {
                                        phi_1338_ = bool();
                                        phi_1339_ = _e1074;
                                        phi_1340_ = _e1076;
                                        phi_1341_ = _e1078;
                                    }
                                    let _e1094 = phi_1338_;
                                    let _e1096 = phi_1339_;
                                    let _e1098 = phi_1340_;
                                    let _e1100 = phi_1341_;
                                    if _e1096 {
                                        phi_1345_ = _e1068;
                                        phi_1346_ = false;
                                        phi_1347_ = false;
                                    } else {
                                        phi_1345_ = _e1094;
                                        phi_1346_ = _e1098;
                                        phi_1347_ = _e1100;
                                    }
                                    let _e1102 = phi_1345_;
                                    let _e1104 = phi_1346_;
                                    let _e1106 = phi_1347_;
                                    if _e1104 {
                                        phi_1351_ = false;
                                        phi_1352_ = true;
                                    } else {
                                        phi_1351_ = _e1070;
                                        phi_1352_ = _e1106;
                                    }
                                    let _e1108 = phi_1351_;
                                    let _e1110 = phi_1352_;
                                    if _e1110 {
                                        phi_1356_ = _e1108;
                                    } else {
                                        phi_1356_ = _e1102;
                                    }
                                    let _e1112 = phi_1356_;
                                    phi_1357_ = _e1112;
                                }
                                let _e1114 = phi_1357_;
                                if _e906.all_remove {
                                    if (((_e1032 & 1u) != 0u) == _e274) {
                                        if ((_e1032 & 2u) != 0u) {
                                            phi_1375_ = (((_e1032 & 4u) != 0u) == _e274);
                                        } else {
                                            phi_1375_ = true;
                                        }
                                        let _e1124 = phi_1375_;
                                        phi_1376_ = _e1124;
                                    } else {
                                        phi_1376_ = false;
                                    }
                                    let _e1126 = phi_1376_;
                                    phi_1377_ = _e1126;
                                } else {
                                    phi_1377_ = false;
                                }
                                let _e1128 = phi_1377_;
                                phi_1110_ = (_e904 + 1u);
                                phi_1113_ = lt_mask_Neighbourhood(_e1114, _e1128);
                            } else {
                                phi_1110_ = u32();
                                phi_1113_ = lt_mask_Neighbourhood();
                            }
                            let _e1132 = phi_1110_;
                            let _e1134 = phi_1113_;
                            continue;
                            continuing {
                                phi_1109_ = _e1132;
                                phi_1112_ = _e1134;
                                break if !(_e918);
                            }
                        }
                        let _e1511 = local_1;
                        phi_1380_ = _e1511;
                    }
                    let _e1137 = phi_1380_;
                    phi_1381_ = _e1137;
                } else {
                    phi_1381_ = _e889;
                }
                let _e1139 = phi_1381_;
                phi_1382_ = _e1139;
            } else {
                phi_1382_ = _e889;
            }
            let _e1141 = phi_1382_;
            let _e1144 = p.member.frame;
            let _e1146 = p.member.refresh;
            if (_e1146 == 0u) {
                phi_1415_ = false;
            } else {
                if (_e1146 == 0u) {
                    return;
                }
                let _e1155 = ((_e60.x + (_e60.y * (((_e1146 * 5u) / 8u) | 1u))) + (_e1144 % _e1146));
                if (_e1146 == 0u) {
                    phi_1414_ = (_e1155 == 0u);
                } else {
                    if (_e1146 == 0u) {
                        return;
                    }
                    phi_1414_ = ((_e1155 % _e1146) == 0u);
                }
                let _e1162 = phi_1414_;
                phi_1415_ = _e1162;
            }
            let _e1164 = phi_1415_;
            if _e812 {
                if _e1164 {
                    phi_1437_ = bool();
                } else {
                    phi_1437_ = ((_e888 & 2u) != 0u);
                }
                let _e1170 = phi_1437_;
                phi_1438_ = _e1170;
                phi_1439_ = _e1164;
            } else {
                phi_1438_ = bool();
                phi_1439_ = true;
            }
            let _e1172 = phi_1438_;
            let _e1174 = phi_1439_;
            if _e1174 {
                phi_1443_ = false;
            } else {
                phi_1443_ = _e1172;
            }
            let _e1176 = phi_1443_;
            if _e1176 {
                phi_1494_ = 7u;
            } else {
                if (_e116 != 0.5f) {
                    if _e812 {
                        if _e1164 {
                            phi_1491_ = 6u;
                        } else {
                            if _e278 {
                                phi_1466_ = true;
                            } else {
                                if _e1141.any_expands {
                                    phi_1465_ = false;
                                } else {
                                    phi_1465_ = true;
                                }
                                let _e1178 = phi_1465_;
                                phi_1466_ = _e1178;
                            }
                            let _e1180 = phi_1466_;
                            if _e1180 {
                                if _e278 {
                                    if _e822 {
                                        if _e1141.all_remove {
                                            phi_1479_ = false;
                                        } else {
                                            phi_1479_ = true;
                                        }
                                        let _e1182 = phi_1479_;
                                        phi_1480_ = _e1182;
                                    } else {
                                        phi_1480_ = true;
                                    }
                                    let _e1184 = phi_1480_;
                                    phi_1481_ = _e1184;
                                } else {
                                    phi_1481_ = true;
                                }
                                let _e1186 = phi_1481_;
                                if _e1186 {
                                    if _e278 {
                                        phi_1488_ = 1u;
                                    } else {
                                        phi_1488_ = 0u;
                                    }
                                    let _e1188 = phi_1488_;
                                    phi_1489_ = _e1188;
                                } else {
                                    phi_1489_ = 5u;
                                }
                                let _e1190 = phi_1489_;
                                phi_1490_ = _e1190;
                            } else {
                                phi_1490_ = 4u;
                            }
                            let _e1192 = phi_1490_;
                            phi_1491_ = _e1192;
                        }
                        let _e1194 = phi_1491_;
                        phi_1492_ = _e1194;
                    } else {
                        phi_1492_ = 3u;
                    }
                    let _e1196 = phi_1492_;
                    phi_1493_ = _e1196;
                } else {
                    phi_1493_ = 2u;
                }
                let _e1198 = phi_1493_;
                phi_1494_ = _e1198;
            }
            let _e1200 = phi_1494_;
            if !((_e1200 == 0u)) {
                if !((_e1200 == 5u)) {
                    phi_1506_ = !(_e1176);
                    phi_1507_ = false;
                } else {
                    phi_1506_ = bool();
                    phi_1507_ = true;
                }
                let _e1207 = phi_1506_;
                let _e1209 = phi_1507_;
                phi_1508_ = _e1207;
                phi_1509_ = _e1209;
            } else {
                phi_1508_ = bool();
                phi_1509_ = true;
            }
            let _e1211 = phi_1508_;
            let _e1213 = phi_1509_;
            if _e1213 {
                phi_1513_ = false;
            } else {
                phi_1513_ = _e1211;
            }
            let _e1215 = phi_1513_;
            if _e1176 {
                phi_1519_ = ((_e888 & 4u) != 0u);
            } else {
                phi_1519_ = _e274;
            }
            let _e1219 = phi_1519_;
            if _e1215 {
                if _e274 {
                    phi_1527_ = (2u | 1u);
                } else {
                    phi_1527_ = 2u;
                }
                let _e1222 = phi_1527_;
                if false {
                    phi_1532_ = (_e1222 | 4u);
                } else {
                    phi_1532_ = _e1222;
                }
                let _e1225 = phi_1532_;
                phi_1552_ = _e1225;
            } else {
                if (_e1200 == 7u) {
                    if _e274 {
                        phi_1541_ = (2u | 1u);
                    } else {
                        phi_1541_ = 2u;
                    }
                    let _e1229 = phi_1541_;
                    if _e1219 {
                        phi_1546_ = (_e1229 | 4u);
                    } else {
                        phi_1546_ = _e1229;
                    }
                    let _e1232 = phi_1546_;
                    phi_1551_ = _e1232;
                } else {
                    if _e274 {
                        phi_1550_ = 1u;
                    } else {
                        phi_1550_ = 0u;
                    }
                    let _e1234 = phi_1550_;
                    phi_1551_ = _e1234;
                }
                let _e1236 = phi_1551_;
                phi_1552_ = _e1236;
            }
            let _e1238 = phi_1552_;
            if _e1219 {
                phi_1556_ = 0f;
            } else {
                phi_1556_ = 1f;
            }
            let _e1240 = phi_1556_;
            phi_1558_ = mask_Masked(_e1240, _e1238, _e1215);
        }
        let _e1243 = phi_1558_;
        visibility.member[_e80.shift] = _e1243.visibility;
        let _e1248 = p.member.light.number;
        let _e1249 = (_e1248 * 3u);
        let _e1251 = (_e1249 % 32u);
        let _e1253 = p.member.light.mask_words;
        let _e1255 = ((_e80.shift * _e1253) + (_e1249 / 32u));
        let _e1257 = bits.member[_e1255];
        bits.member[_e1255] = ((_e1257 & ~((7u << bitcast<u32>((_e1251 & 31u))))) | (_e1243.bits << bitcast<u32>((_e1251 & 31u))));
        if (_e1251 > 29u) {
            let _e1272 = bits.member[(_e1255 + 1u)];
            let _e1274 = (32u - _e1251);
            bits.member[(_e1255 + 1u)] = ((_e1272 & ~((7u >> bitcast<u32>((_e1274 & 31u))))) | (_e1243.bits >> bitcast<u32>((_e1274 & 31u))));
        }
        let _e1289 = samples.member[_e80.shift].normal[0u];
        let _e1291 = global[0u];
        if (_e1289 == _e1291) {
            let _e1294 = samples.member[_e80.shift].normal[1u];
            let _e1296 = global[1u];
            if (_e1294 == _e1296) {
                let _e1299 = samples.member[_e80.shift].normal[2u];
                let _e1301 = global[2u];
                phi_1630_ = (_e1299 == _e1301);
                phi_1631_ = false;
            } else {
                phi_1630_ = bool();
                phi_1631_ = true;
            }
            let _e1304 = phi_1630_;
            let _e1306 = phi_1631_;
            phi_1632_ = _e1304;
            phi_1633_ = _e1306;
        } else {
            phi_1632_ = bool();
            phi_1633_ = true;
        }
        let _e1308 = phi_1632_;
        let _e1310 = phi_1633_;
        if _e1310 {
            phi_1637_ = false;
        } else {
            phi_1637_ = _e1308;
        }
        let _e1312 = phi_1637_;
        if !(_e1312) {
            let _e1315 = samples.member[_e80.shift].position;
            let _e1317 = p.member.current.eye;
            let _e1328 = p.member.current.forward;
            phi_1665_ = ((((_e1315.x - _e1317.x) * _e1328.x) + ((_e1315.y - _e1317.y) * _e1328.y)) + ((_e1315.z - _e1317.z) * _e1328.z));
        } else {
            phi_1665_ = 0f;
        }
        let _e1338 = phi_1665_;
        depths.member[_e80.shift] = _e1338;
        phi_1668_ = _e1243.needs_ray;
        phi_1669_ = _e80.shift;
    } else {
        phi_1668_ = false;
        phi_1669_ = 0u;
    }
    let _e1342 = phi_1668_;
    let _e1344 = phi_1669_;
    if (_e61 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1342 {
        let _e1348 = atomicAdd((&shared_[0u]), 1u);
        phi_1680_ = _e1348;
    } else {
        phi_1680_ = 0u;
    }
    let _e1350 = phi_1680_;
    workgroupBarrier();
    if (_e61 == 0u) {
        let _e1354 = atomicLoad((&shared_[0u]));
        let _e1355 = atomicAdd((&list.member[3u]), _e1354);
        atomicStore((&shared_[1u]), _e1355);
    }
    workgroupBarrier();
    if _e1342 {
        let _e1358 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1358) + _e1350)]), _e1344);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_depth_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
