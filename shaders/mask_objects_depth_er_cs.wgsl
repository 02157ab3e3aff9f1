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
    member: array<vec4<f32>>,
}

struct type_49 {
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
var<storage, read_write> list: type_49;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(6) 
var<storage> last_depths: type_21;
@group(0) @binding(7) 
var<storage, read_write> depths: type_21;
@group(0) @binding(8) 
var<storage> past: type_44;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_184_: lt_mask_LightPlace;
    var phi_185_: bool;
    var phi_186_: lt_mask_LightPlace;
    var phi_187_: bool;
    var phi_192_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_184_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_185_ = false;
        } else {
            phi_184_ = lt_mask_LightPlace();
            phi_185_ = true;
        }
        let _e74 = phi_184_;
        let _e76 = phi_185_;
        phi_186_ = _e74;
        phi_187_ = _e76;
    } else {
        phi_186_ = lt_mask_LightPlace();
        phi_187_ = true;
    }
    let _e78 = phi_186_;
    let _e80 = phi_187_;
    if _e80 {
        phi_192_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_192_ = _e78;
    }
    let _e85 = phi_192_;
    return lt_mask_LightPlace(_e85.word, _e85.shift);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_210_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_210_ = vec2(0i);
            break;
        }
        case 1: {
            phi_210_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_210_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_210_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_210_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e70 = phi_210_;
    return vec2<i32>(_e70.x, _e70.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_228_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_228_ = vec2(0i);
            break;
        }
        case 1: {
            phi_228_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_228_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_228_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_228_ = vec2(1i);
            break;
        }
    }
    let _e70 = phi_228_;
    return vec2<i32>(_e70.x, _e70.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_247_: vec2<i32>;

    if (param_6 == 0u) {
        let _e64 = lt_mask_pattern_plus(param_5);
        phi_247_ = vec2<i32>(_e64.x, _e64.y);
    } else {
        let _e68 = lt_mask_pattern_cross(param_5);
        phi_247_ = vec2<i32>(_e68.x, _e68.y);
    }
    let _e73 = phi_247_;
    return vec2<i32>(_e73.x, _e73.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_272_: vec2<i32>;

    let _e62 = (param_7 % 13u);
    switch bitcast<i32>(_e62) {
        case 9: {
            phi_272_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_272_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_272_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_272_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_272_ = vec2<i32>((bitcast<i32>((_e62 % 3u)) - 1i), (bitcast<i32>(((_e62 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e77 = phi_272_;
    return vec2<i32>(_e77.x, _e77.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_293_: u32;
    var phi_294_: u32;

    let _e65 = (bitcast<i32>(param_8) + param_9);
    if (_e65 < 0i) {
        phi_294_ = 0u;
    } else {
        if (_e65 >= bitcast<i32>(param_10)) {
            phi_293_ = (param_10 - 1u);
        } else {
            phi_293_ = bitcast<u32>(_e65);
        }
        let _e72 = phi_293_;
        phi_294_ = _e72;
    }
    let _e74 = phi_294_;
    return _e74;
}

fn function_() {
    var phi_375_: bool;
    var phi_376_: bool;
    var phi_377_: bool;
    var phi_378_: bool;
    var phi_382_: bool;
    var phi_452_: bool;
    var phi_453_: bool;
    var phi_464_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_465_: bool;
    var phi_466_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_467_: bool;
    var phi_474_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_478_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_491_: bool;
    var phi_519_: bool;
    var phi_520_: bool;
    var phi_521_: bool;
    var phi_522_: bool;
    var phi_526_: bool;
    var phi_530_: bool;
    var phi_531_: bool;
    var phi_739_: f32;
    var phi_744_: f32;
    var phi_745_: bool;
    var phi_746_: f32;
    var phi_747_: bool;
    var phi_751_: f32;
    var phi_772_: f32;
    var phi_777_: f32;
    var phi_778_: bool;
    var phi_779_: f32;
    var phi_780_: bool;
    var phi_784_: f32;
    var phi_805_: bool;
    var phi_824_: vec2<u32>;
    var phi_825_: bool;
    var phi_826_: bool;
    var phi_827_: bool;
    var phi_828_: vec2<u32>;
    var phi_829_: bool;
    var phi_830_: bool;
    var phi_831_: bool;
    var phi_832_: bool;
    var phi_833_: bool;
    var phi_834_: bool;
    var phi_835_: vec2<u32>;
    var phi_836_: bool;
    var phi_837_: bool;
    var phi_838_: bool;
    var phi_839_: bool;
    var phi_840_: bool;
    var phi_841_: bool;
    var phi_842_: vec2<u32>;
    var phi_843_: bool;
    var phi_844_: bool;
    var phi_845_: bool;
    var phi_846_: bool;
    var phi_855_: bool;
    var phi_856_: bool;
    var phi_857_: bool;
    var phi_858_: bool;
    var phi_862_: bool;
    var phi_863_: bool;
    var phi_864_: vec2<u32>;
    var phi_899_: bool;
    var phi_901_: lt_mask_Reprojection;
    var phi_902_: lt_mask_Reprojection;
    var phi_903_: lt_mask_Reprojection;
    var phi_904_: bool;
    var phi_905_: bool;
    var phi_906_: lt_mask_Reprojection;
    var phi_907_: lt_mask_Reprojection;
    var phi_908_: lt_mask_Reprojection;
    var phi_909_: bool;
    var phi_910_: bool;
    var phi_962_: bool;
    var phi_966_: f32;
    var phi_970_: lt_mask_Reprojection;
    var phi_971_: bool;
    var phi_983_: bool;
    var phi_984_: bool;
    var phi_985_: bool;
    var phi_986_: lt_mask_Reprojection;
    var phi_987_: bool;
    var phi_991_: bool;
    var phi_992_: lt_mask_Reprojection;
    var phi_998_: bool;
    var phi_1020_: u32;
    var phi_1022_: u32;
    var phi_1025_: lt_mask_Neighbourhood;
    var phi_1037_: bool;
    var phi_1038_: bool;
    var phi_1047_: u32;
    var phi_1048_: u32;
    var phi_1108_: vec2<i32>;
    var phi_1128_: vec2<i32>;
    var phi_1155_: u32;
    var phi_1174_: u32;
    var phi_1182_: u32;
    var phi_1208_: bool;
    var phi_1209_: bool;
    var phi_1210_: bool;
    var phi_1211_: bool;
    var phi_1212_: bool;
    var phi_1213_: bool;
    var phi_1214_: bool;
    var phi_1219_: bool;
    var phi_1220_: bool;
    var phi_1221_: bool;
    var phi_1222_: bool;
    var phi_1223_: bool;
    var phi_1224_: bool;
    var phi_1225_: bool;
    var phi_1226_: bool;
    var phi_1227_: bool;
    var phi_1242_: bool;
    var phi_1243_: bool;
    var phi_1250_: bool;
    var phi_1251_: bool;
    var phi_1252_: bool;
    var phi_1253_: bool;
    var phi_1254_: bool;
    var phi_1258_: bool;
    var phi_1259_: bool;
    var phi_1260_: bool;
    var phi_1264_: bool;
    var phi_1265_: bool;
    var phi_1269_: bool;
    var phi_1270_: bool;
    var phi_1288_: bool;
    var phi_1289_: bool;
    var phi_1290_: bool;
    var phi_1023_: u32;
    var phi_1026_: lt_mask_Neighbourhood;
    var phi_1293_: lt_mask_Neighbourhood;
    var phi_1294_: lt_mask_Neighbourhood;
    var phi_1295_: lt_mask_Neighbourhood;
    var phi_1327_: bool;
    var phi_1328_: bool;
    var phi_1350_: bool;
    var phi_1351_: bool;
    var phi_1352_: bool;
    var phi_1356_: bool;
    var phi_1378_: bool;
    var phi_1379_: bool;
    var phi_1392_: bool;
    var phi_1393_: bool;
    var phi_1394_: bool;
    var phi_1401_: u32;
    var phi_1402_: u32;
    var phi_1403_: u32;
    var phi_1404_: u32;
    var phi_1405_: u32;
    var phi_1406_: u32;
    var phi_1407_: u32;
    var phi_1419_: bool;
    var phi_1420_: bool;
    var phi_1421_: bool;
    var phi_1422_: bool;
    var phi_1426_: bool;
    var phi_1432_: bool;
    var phi_1440_: u32;
    var phi_1445_: u32;
    var phi_1454_: u32;
    var phi_1459_: u32;
    var phi_1463_: u32;
    var phi_1464_: u32;
    var phi_1465_: u32;
    var phi_1469_: f32;
    var phi_1471_: mask_Masked;
    var phi_1543_: bool;
    var phi_1544_: bool;
    var phi_1545_: bool;
    var phi_1546_: bool;
    var phi_1550_: bool;
    var phi_1578_: f32;
    var phi_1581_: bool;
    var phi_1582_: u32;
    var phi_1593_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e61 = id_1;
    let _e62 = local_2;
    let _e67 = arrayLength((&last_bits.member));
    let _e79 = p.member.current.size[0u];
    let _e81 = p.member.current.size[1u];
    let _e82 = lt_shaders_entry_pixel_index(_e61, _e79, _e81);
    if (bitcast<i32>(_e82.word) != 0i) {
        let _e89 = p.member.light.number;
        let _e90 = (_e89 * 3u);
        let _e94 = p.member.light.mask_words;
        let _e100 = mask_BitsPlace(lt_mask_LightPlace((_e90 / 32u), mask_BitsPlace().light.shift), mask_BitsPlace().words);
        let _e106 = mask_BitsPlace(lt_mask_LightPlace(_e100.light.word, (_e90 % 32u)), _e100.words);
        let _e109 = mask_BitsPlace(_e106.light, _e94);
        let _e113 = p.member.current.size[0u];
        let _e116 = past.member[_e82.shift];
        let _e121 = visibility.member[_e82.shift];
        let _e127 = samples.member[_e82.shift].normal[0u];
        let _e129 = global[0u];
        if (_e127 == _e129) {
            let _e132 = samples.member[_e82.shift].normal[1u];
            let _e134 = global[1u];
            if (_e132 == _e134) {
                let _e137 = samples.member[_e82.shift].normal[2u];
                let _e139 = global[2u];
                phi_375_ = (_e137 == _e139);
                phi_376_ = false;
            } else {
                phi_375_ = bool();
                phi_376_ = true;
            }
            let _e142 = phi_375_;
            let _e144 = phi_376_;
            phi_377_ = _e142;
            phi_378_ = _e144;
        } else {
            phi_377_ = bool();
            phi_378_ = true;
        }
        let _e146 = phi_377_;
        let _e148 = phi_378_;
        if _e148 {
            phi_382_ = false;
        } else {
            phi_382_ = _e146;
        }
        let _e150 = phi_382_;
        if !(_e150) {
            let _e153 = samples.member[_e82.shift].position;
            let _e155 = p.member.light.place;
            let _e161 = p.member.light.place[3u];
            let _e168 = (_e155.x - (_e153.x * _e161));
            let _e169 = (_e155.y - (_e153.y * _e161));
            let _e170 = (_e155.z - (_e153.z * _e161));
            let _e172 = samples.member[_e82.shift].normal;
            if ((((_e172.x * _e168) + (_e172.y * _e169)) + (_e172.z * _e170)) > 0f) {
                let _e186 = (((_e168 * _e168) + (_e169 * _e169)) + (_e170 * _e170));
                let _e188 = p.member.light.axis;
                let _e200 = p.member.light.place[3u];
                if (_e200 == 0f) {
                    phi_453_ = true;
                } else {
                    let _e203 = p.member.light.range_squared;
                    if (_e186 <= _e203) {
                        let _e206 = p.member.light.cos_outer;
                        phi_452_ = (-((((_e168 * _e188.x) + (_e169 * _e188.y)) + (_e170 * _e188.z))) >= (_e206 * sqrt(_e186)));
                    } else {
                        phi_452_ = false;
                    }
                    let _e211 = phi_452_;
                    phi_453_ = _e211;
                }
                let _e213 = phi_453_;
                if _e213 {
                    let _e215 = samples.member[_e82.shift].flags;
                    let _e223 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e229 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e223.unnamed.visibility, false), _e223.unnamed_1);
                    phi_464_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e229.unnamed, ((_e215 & 1u) == 0u));
                    phi_465_ = false;
                } else {
                    phi_464_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_465_ = true;
                }
                let _e234 = phi_464_;
                let _e236 = phi_465_;
                phi_466_ = _e234;
                phi_467_ = _e236;
            } else {
                phi_466_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_467_ = true;
            }
            let _e238 = phi_466_;
            let _e240 = phi_467_;
            if _e240 {
                let _e246 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e252 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e246.unnamed.visibility, false), _e246.unnamed_1);
                phi_474_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e252.unnamed, true);
            } else {
                phi_474_ = _e238;
            }
            let _e257 = phi_474_;
            phi_478_ = _e257;
        } else {
            let _e263 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e269 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e263.unnamed.visibility, false), _e263.unnamed_1);
            phi_478_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e269.unnamed, true);
        }
        let _e274 = phi_478_;
        if _e274.unnamed_1 {
            phi_1471_ = mask_Masked(_e274.unnamed.visibility, 0u, false);
        } else {
            let _e279 = (_e121 < 0.5f);
            if (_e121 > 0f) {
                phi_491_ = (_e121 < 1f);
            } else {
                phi_491_ = false;
            }
            let _e283 = phi_491_;
            let _e290 = lt_mask_Reprojection(vec2<u32>(_e61.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e297 = lt_mask_Reprojection(vec2<u32>(_e290.pixel.x, _e61.y), _e290.is_valid, _e290.has_moved);
            let _e301 = lt_mask_Reprojection(_e297.pixel, true, _e297.has_moved);
            let _e307 = p.member.flags;
            if ((_e307 & 16u) == 0u) {
                phi_531_ = true;
            } else {
                let _e312 = samples.member[_e82.shift].position[0u];
                if (_e116.x == _e312) {
                    let _e315 = samples.member[_e82.shift].position[1u];
                    if (_e116.y == _e315) {
                        let _e318 = samples.member[_e82.shift].position[2u];
                        phi_519_ = (_e116.z == _e318);
                        phi_520_ = false;
                    } else {
                        phi_519_ = bool();
                        phi_520_ = true;
                    }
                    let _e321 = phi_519_;
                    let _e323 = phi_520_;
                    phi_521_ = _e321;
                    phi_522_ = _e323;
                } else {
                    phi_521_ = bool();
                    phi_522_ = true;
                }
                let _e325 = phi_521_;
                let _e327 = phi_522_;
                if _e327 {
                    phi_526_ = false;
                } else {
                    phi_526_ = _e325;
                }
                let _e329 = phi_526_;
                if _e329 {
                    phi_530_ = false;
                } else {
                    phi_530_ = true;
                }
                let _e331 = phi_530_;
                phi_531_ = _e331;
            }
            let _e333 = phi_531_;
            if _e333 {
                let _e335 = samples.member[_e82.shift].position;
                let _e339 = p.member.previous.eye;
                let _e341 = (_e116.x - _e339.x);
                let _e343 = (_e116.y - _e339.y);
                let _e345 = (_e116.z - _e339.z);
                let _e347 = p.member.previous.forward;
                let _e355 = (((_e341 * _e347.x) + (_e343 * _e347.y)) + (_e345 * _e347.z));
                let _e357 = p.member.previous.right;
                let _e367 = p.member.previous.right;
                let _e382 = p.member.previous.up;
                let _e392 = p.member.previous.up;
                let _e407 = p.member.current.eye;
                let _e410 = (_e335.x - _e407.x);
                let _e413 = (_e335.y - _e407.y);
                let _e416 = (_e335.z - _e407.z);
                let _e418 = p.member.current.forward;
                let _e426 = (((_e410 * _e418.x) + (_e413 * _e418.y)) + (_e416 * _e418.z));
                let _e428 = p.member.current.right;
                let _e438 = p.member.current.right;
                let _e453 = p.member.current.up;
                let _e463 = p.member.current.up;
                let _e482 = p.member.current.size[0u];
                let _e484 = (((((((_e341 * _e357.x) + (_e343 * _e357.y)) + (_e345 * _e357.z)) / ((((_e367.x * _e367.x) + (_e367.y * _e367.y)) + (_e367.z * _e367.z)) * _e355)) - ((((_e410 * _e428.x) + (_e413 * _e428.y)) + (_e416 * _e428.z)) / ((((_e438.x * _e438.x) + (_e438.y * _e438.y)) + (_e438.z * _e438.z)) * _e426))) * 0.5f) * f32(_e482));
                let _e488 = p.member.current.size[1u];
                let _e490 = (((((((_e341 * _e382.x) + (_e343 * _e382.y)) + (_e345 * _e382.z)) / ((((_e392.x * _e392.x) + (_e392.y * _e392.y)) + (_e392.z * _e392.z)) * _e355)) - ((((_e410 * _e453.x) + (_e413 * _e453.y)) + (_e416 * _e453.z)) / ((((_e463.x * _e463.x) + (_e463.y * _e463.y)) + (_e463.z * _e463.z)) * _e426))) * -0.5f) * f32(_e488));
                let _e494 = p.member.current.grid[0u];
                let _e496 = p.member.current.grid[1u];
                let _e516 = p.member.current.size[0u];
                let _e518 = p.member.current.size[1u];
                let _e520 = ((f32(_e61.x) + ((f32((_e61.y & (_e496 - 1u))) + 0.5f) / f32(_e496))) + _e484);
                if (_e520 > -8388608f) {
                    let _e532 = f32(select(0i, select(select(i32(_e520), i32(-2147483648), (_e520 < bitcast<f32>(3472883712u))), 2147483647i, (_e520 > bitcast<f32>(1325400063u))), (_e520 == _e520)));
                    if (_e532 > _e520) {
                        phi_739_ = 1f;
                    } else {
                        phi_739_ = 0f;
                    }
                    let _e535 = phi_739_;
                    if (_e520 < 8388608f) {
                        phi_744_ = (_e532 - _e535);
                        phi_745_ = false;
                    } else {
                        phi_744_ = f32();
                        phi_745_ = true;
                    }
                    let _e538 = phi_744_;
                    let _e540 = phi_745_;
                    phi_746_ = _e538;
                    phi_747_ = _e540;
                } else {
                    phi_746_ = f32();
                    phi_747_ = true;
                }
                let _e542 = phi_746_;
                let _e544 = phi_747_;
                if _e544 {
                    phi_751_ = _e520;
                } else {
                    phi_751_ = _e542;
                }
                let _e546 = phi_751_;
                let _e547 = ((f32(_e61.y) + ((f32((_e61.x & (_e494 - 1u))) + 0.5f) / f32(_e494))) + _e490);
                if (_e547 > -8388608f) {
                    let _e559 = f32(select(0i, select(select(i32(_e547), i32(-2147483648), (_e547 < bitcast<f32>(3472883712u))), 2147483647i, (_e547 > bitcast<f32>(1325400063u))), (_e547 == _e547)));
                    if (_e559 > _e547) {
                        phi_772_ = 1f;
                    } else {
                        phi_772_ = 0f;
                    }
                    let _e562 = phi_772_;
                    if (_e547 < 8388608f) {
                        phi_777_ = (_e559 - _e562);
                        phi_778_ = false;
                    } else {
                        phi_777_ = f32();
                        phi_778_ = true;
                    }
                    let _e565 = phi_777_;
                    let _e567 = phi_778_;
                    phi_779_ = _e565;
                    phi_780_ = _e567;
                } else {
                    phi_779_ = f32();
                    phi_780_ = true;
                }
                let _e569 = phi_779_;
                let _e571 = phi_780_;
                if _e571 {
                    phi_784_ = _e547;
                } else {
                    phi_784_ = _e569;
                }
                let _e573 = phi_784_;
                if (_e546 >= 0f) {
                    if (_e573 >= 0f) {
                        if (_e546 < f32(_e516)) {
                            let _e579 = (_e573 < f32(_e518));
                            if (_e484 == 0f) {
                                phi_805_ = (_e490 == 0f);
                            } else {
                                phi_805_ = false;
                            }
                            let _e583 = phi_805_;
                            if _e579 {
                                phi_824_ = vec2<u32>(select(select(u32(_e546), 0u, (_e546 < bitcast<f32>(0u))), 4294967295u, (_e546 > bitcast<f32>(1333788671u))), select(select(u32(_e573), 0u, (_e573 < bitcast<f32>(0u))), 4294967295u, (_e573 > bitcast<f32>(1333788671u))));
                                phi_825_ = false;
                            } else {
                                phi_824_ = vec2<u32>();
                                phi_825_ = true;
                            }
                            let _e600 = phi_824_;
                            let _e602 = phi_825_;
                            phi_826_ = _e583;
                            phi_827_ = _e579;
                            phi_828_ = _e600;
                            phi_829_ = _e583;
                            phi_830_ = _e579;
                            phi_831_ = false;
                            phi_832_ = _e602;
                        } else {
                            phi_826_ = bool();
                            phi_827_ = bool();
                            phi_828_ = vec2<u32>();
                            phi_829_ = bool();
                            phi_830_ = bool();
                            phi_831_ = true;
                            phi_832_ = false;
                        }
                        let _e604 = phi_826_;
                        let _e606 = phi_827_;
                        let _e608 = phi_828_;
                        let _e610 = phi_829_;
                        let _e612 = phi_830_;
                        let _e614 = phi_831_;
                        let _e616 = phi_832_;
                        phi_833_ = _e604;
                        phi_834_ = _e606;
                        phi_835_ = _e608;
                        phi_836_ = _e610;
                        phi_837_ = _e612;
                        phi_838_ = _e614;
                        phi_839_ = _e616;
                    } else {
                        phi_833_ = bool();
                        phi_834_ = bool();
                        phi_835_ = vec2<u32>();
                        phi_836_ = bool();
                        phi_837_ = bool();
                        phi_838_ = true;
                        phi_839_ = false;
                    }
                    let _e618 = phi_833_;
                    let _e620 = phi_834_;
                    let _e622 = phi_835_;
                    let _e624 = phi_836_;
                    let _e626 = phi_837_;
                    let _e628 = phi_838_;
                    let _e630 = phi_839_;
                    phi_840_ = _e618;
                    phi_841_ = _e620;
                    phi_842_ = _e622;
                    phi_843_ = _e624;
                    phi_844_ = _e626;
                    phi_845_ = _e628;
                    phi_846_ = _e630;
                } else {
                    phi_840_ = bool();
                    phi_841_ = bool();
                    phi_842_ = vec2<u32>();
                    phi_843_ = bool();
                    phi_844_ = bool();
                    phi_845_ = true;
                    phi_846_ = false;
                }
                let _e632 = phi_840_;
                let _e634 = phi_841_;
                let _e636 = phi_842_;
                let _e638 = phi_843_;
                let _e640 = phi_844_;
                let _e642 = phi_845_;
                let _e644 = phi_846_;
                if _e642 {
                    if (_e484 == 0f) {
                        phi_855_ = (_e490 == 0f);
                    } else {
                        phi_855_ = false;
                    }
                    let _e648 = phi_855_;
                    phi_856_ = _e648;
                    phi_857_ = false;
                    phi_858_ = true;
                } else {
                    phi_856_ = _e638;
                    phi_857_ = _e640;
                    phi_858_ = _e644;
                }
                let _e650 = phi_856_;
                let _e652 = phi_857_;
                let _e654 = phi_858_;
                if _e654 {
                    phi_862_ = _e650;
                    phi_863_ = _e652;
                    phi_864_ = vec2<u32>(_e61.x, _e61.y);
                } else {
                    phi_862_ = _e632;
                    phi_863_ = _e634;
                    phi_864_ = _e636;
                }
                let _e656 = phi_862_;
                let _e658 = phi_863_;
                let _e660 = phi_864_;
                let _e670 = lt_mask_Reprojection(vec2<u32>(_e660.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
                let _e677 = lt_mask_Reprojection(vec2<u32>(_e670.pixel.x, _e660.y), _e670.is_valid, _e670.has_moved);
                let _e681 = lt_mask_Reprojection(_e677.pixel, _e658, _e677.has_moved);
                let _e685 = lt_mask_Reprojection(_e681.pixel, _e681.is_valid, !(_e656));
                if _e658 {
                    let _e688 = p.member.previous.eye;
                    let _e696 = p.member.previous.forward;
                    let _e705 = (((((_e116.x - _e688.x) * _e696.x) + ((_e116.y - _e688.y) * _e696.y)) + ((_e116.z - _e688.z) * _e696.z)) > 0f);
                    let _e709 = lt_mask_Reprojection(_e685.pixel, _e705, _e685.has_moved);
                    if _e705 {
                        phi_899_ = false;
                    } else {
                        phi_899_ = true;
                    }
                    let _e711 = phi_899_;
                    phi_901_ = _e709;
                    phi_902_ = _e709;
                    phi_903_ = lt_mask_Reprojection();
                    phi_904_ = _e705;
                    phi_905_ = _e711;
                } else {
                    phi_901_ = lt_mask_Reprojection();
                    phi_902_ = lt_mask_Reprojection();
                    phi_903_ = lt_mask_Reprojection(_e685.pixel, false, _e685.has_moved);
                    phi_904_ = false;
                    phi_905_ = false;
                }
                let _e717 = phi_901_;
                let _e719 = phi_902_;
                let _e721 = phi_903_;
                let _e723 = phi_904_;
                let _e725 = phi_905_;
                phi_906_ = _e717;
                phi_907_ = _e719;
                phi_908_ = _e721;
                phi_909_ = _e723;
                phi_910_ = _e725;
            } else {
                phi_906_ = lt_mask_Reprojection(_e301.pixel, _e301.is_valid, false);
                phi_907_ = lt_mask_Reprojection();
                phi_908_ = lt_mask_Reprojection();
                phi_909_ = true;
                phi_910_ = false;
            }
            let _e727 = phi_906_;
            let _e729 = phi_907_;
            let _e731 = phi_908_;
            let _e733 = phi_909_;
            let _e735 = phi_910_;
            if _e733 {
                let _e738 = p.member.previous.eye;
                let _e746 = p.member.previous.forward;
                let _e754 = ((((_e116.x - _e738.x) * _e746.x) + ((_e116.y - _e738.y) * _e746.y)) + ((_e116.z - _e738.z) * _e746.z));
                let _e760 = ((_e727.pixel.y * _e113) + _e727.pixel.x);
                if (_e760 < arrayLength((&last_depths.member))) {
                } else {
                    return;
                }
                let _e764 = last_depths.member[(0u + _e760)];
                let _e766 = p.member.depth_tolerance;
                let _e769 = abs(_e754);
                let _e770 = abs(_e764);
                if ((bitcast<u32>(_e770) & 2147483647u) > 2139095040u) {
                    phi_962_ = true;
                } else {
                    let _e774 = (_e770 > _e769);
                    if _e774 {
                    }
                    phi_962_ = _e774;
                }
                let _e776 = phi_962_;
                if _e776 {
                    phi_966_ = _e770;
                } else {
                    phi_966_ = _e769;
                }
                let _e778 = phi_966_;
                phi_970_ = lt_mask_Reprojection(_e727.pixel, (abs((_e754 - _e764)) <= (_e766 * _e778)), _e727.has_moved);
                phi_971_ = true;
            } else {
                phi_970_ = _e729;
                phi_971_ = _e735;
            }
            let _e786 = phi_970_;
            let _e788 = phi_971_;
            if _e788 {
                if _e786.is_valid {
                    let _e791 = p.member.flags;
                    phi_983_ = ((_e791 & 1u) != 0u);
                    phi_984_ = false;
                } else {
                    phi_983_ = bool();
                    phi_984_ = true;
                }
                let _e795 = phi_983_;
                let _e797 = phi_984_;
                phi_985_ = _e795;
                phi_986_ = _e786;
                phi_987_ = _e797;
            } else {
                phi_985_ = bool();
                phi_986_ = _e731;
                phi_987_ = true;
            }
            let _e799 = phi_985_;
            let _e801 = phi_986_;
            let _e803 = phi_987_;
            if _e803 {
                phi_991_ = false;
                phi_992_ = _e801;
            } else {
                phi_991_ = _e799;
                phi_992_ = _e786;
            }
            let _e805 = phi_991_;
            let _e807 = phi_992_;
            let _e811 = lt_mask_Reprojection(_e807.pixel, _e805, _e807.has_moved);
            let _e812 = lt_mask_Neighbourhood(false, true);
            if _e283 {
                phi_998_ = false;
            } else {
                phi_998_ = true;
            }
            let _e814 = phi_998_;
            if _e814 {
                if _e805 {
                    if ((0u & 2u) != 0u) {
                        phi_1293_ = _e812;
                    } else {
                        let _e818 = p.member.expansion;
                        if _e811.has_moved {
                            let _e821 = p.member.moving_pattern;
                            phi_1020_ = _e821;
                        } else {
                            let _e823 = p.member.still_pattern;
                            phi_1020_ = _e823;
                        }
                        let _e825 = phi_1020_;
                        phi_1022_ = 0u;
                        phi_1025_ = _e812;
                        loop {
                            let _e827 = phi_1022_;
                            let _e829 = phi_1025_;
                            local_1 = _e829;
                            if (1u <= _e825) {
                                if (_e825 <= 4u) {
                                    phi_1037_ = false;
                                } else {
                                    phi_1037_ = true;
                                }
                                let _e833 = phi_1037_;
                                phi_1038_ = _e833;
                            } else {
                                phi_1038_ = true;
                            }
                            let _e835 = phi_1038_;
                            if _e835 {
                                switch bitcast<i32>(_e825) {
                                    case 5: {
                                        phi_1047_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_1047_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_1047_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_1047_ = 9u;
                                        break;
                                    }
                                }
                                let _e838 = phi_1047_;
                                phi_1048_ = _e838;
                            } else {
                                phi_1048_ = 5u;
                            }
                            let _e840 = phi_1048_;
                            let _e841 = (_e827 < _e840);
                            if _e841 {
                                let _e847 = p.member.frame;
                                let _e851 = p.member.current.size[0u];
                                let _e853 = p.member.current.size[1u];
                                switch bitcast<i32>(_e825) {
                                    case 1: {
                                        let _e863 = lt_mask_pattern_plus(_e827);
                                        phi_1128_ = vec2<i32>(_e863.x, _e863.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e867 = lt_mask_pattern_cross(_e827);
                                        phi_1128_ = vec2<i32>(_e867.x, _e867.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e873 = lt_mask_pattern_plus_or_cross(_e827, ((_e811.pixel.x + _e811.pixel.y) & 1u));
                                        phi_1128_ = vec2<i32>(_e873.x, _e873.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e878 = lt_mask_pattern_plus_or_cross(_e827, (_e847 & 1u));
                                        phi_1128_ = vec2<i32>(_e878.x, _e878.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e847 & 3u)) {
                                            case 0: {
                                                phi_1108_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_1108_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_1108_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_1108_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e889 = phi_1108_;
                                        phi_1128_ = (_e889 + vec2<i32>(bitcast<i32>((_e827 & 1u)), bitcast<i32>(((_e827 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_1128_ = vec2<i32>((bitcast<i32>((_e827 % 5u)) - 2i), (bitcast<i32>(((_e827 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e906 = lt_mask_pattern_diamond(_e827);
                                        phi_1128_ = vec2<i32>(_e906.x, _e906.y);
                                        break;
                                    }
                                    default: {
                                        phi_1128_ = vec2<i32>((bitcast<i32>((_e827 % 3u)) - 1i), (bitcast<i32>(((_e827 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e911 = phi_1128_;
                                let _e914 = lt_mask_pattern_step_clamped(_e811.pixel.x, _e911.x, _e851);
                                let _e915 = lt_mask_pattern_step_clamped(_e811.pixel.y, _e911.y, _e853);
                                let _e922 = ((((_e915 * _e113) + _e914) * _e109.words) + _e109.light.word);
                                if (_e109.light.shift > 29u) {
                                    let _e926 = (_e922 + 1u);
                                    if (_e926 < _e67) {
                                    } else {
                                        return;
                                    }
                                    let _e930 = last_bits.member[(0u + _e926)];
                                    phi_1155_ = _e930;
                                } else {
                                    phi_1155_ = 0u;
                                }
                                let _e932 = phi_1155_;
                                if (_e922 < _e67) {
                                } else {
                                    return;
                                }
                                let _e938 = last_bits.member[(0u + _e922)];
                                let _e941 = (_e938 >> bitcast<u32>((_e109.light.shift & 31u)));
                                if (_e109.light.shift > 29u) {
                                    phi_1174_ = (_e941 | (_e932 << bitcast<u32>(((32u - _e109.light.shift) & 31u))));
                                } else {
                                    phi_1174_ = _e941;
                                }
                                let _e949 = phi_1174_;
                                if ((_e949 & 2u) == 0u) {
                                    phi_1182_ = (_e949 & 1u);
                                } else {
                                    phi_1182_ = (_e949 & 7u);
                                }
                                let _e955 = phi_1182_;
                                if _e829.any_expands {
                                    phi_1270_ = true;
                                } else {
                                    if ((_e955 & 2u) != 0u) {
                                        let _e962 = (((_e955 & 4u) != 0u) != _e279);
                                        switch bitcast<i32>(_e818) {
                                            case 1: {
                                                phi_1210_ = bool();
                                                phi_1211_ = false;
                                                phi_1212_ = true;
                                                phi_1213_ = false;
                                                phi_1214_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e962 {
                                                    phi_1208_ = (((_e955 & 4u) != 0u) != ((_e955 & 1u) != 0u));
                                                    phi_1209_ = false;
                                                } else {
                                                    phi_1208_ = bool();
                                                    phi_1209_ = true;
                                                }
                                                let _e970 = phi_1208_;
                                                let _e972 = phi_1209_;
                                                phi_1210_ = _e970;
                                                phi_1211_ = false;
                                                phi_1212_ = false;
                                                phi_1213_ = _e972;
                                                phi_1214_ = _e962;
                                                break;
                                            }
                                            default: {
                                                phi_1210_ = bool();
                                                phi_1211_ = true;
                                                phi_1212_ = false;
                                                phi_1213_ = false;
                                                phi_1214_ = false;
                                                break;
                                            }
                                        }
                                        let _e974 = phi_1210_;
                                        let _e976 = phi_1211_;
                                        let _e978 = phi_1212_;
                                        let _e980 = phi_1213_;
                                        let _e982 = phi_1214_;
                                        phi_1222_ = _e962;
                                        phi_1223_ = _e974;
                                        phi_1224_ = _e976;
                                        phi_1225_ = _e978;
                                        phi_1226_ = _e980;
                                        phi_1227_ = _e982;
                                    } else {
                                        switch bitcast<i32>(_e818) {
                                            case 1: {
                                                phi_1219_ = false;
                                                phi_1220_ = true;
                                                phi_1221_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_1219_ = false;
                                                phi_1220_ = false;
                                                phi_1221_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_1219_ = true;
                                                phi_1220_ = false;
                                                phi_1221_ = false;
                                                break;
                                            }
                                        }
                                        let _e985 = phi_1219_;
                                        let _e987 = phi_1220_;
                                        let _e989 = phi_1221_;
                                        phi_1222_ = false;
                                        phi_1223_ = bool();
                                        phi_1224_ = _e985;
                                        phi_1225_ = _e987;
                                        phi_1226_ = _e989;
                                        phi_1227_ = false;
                                    }
                                    let _e991 = phi_1222_;
                                    let _e993 = phi_1223_;
                                    let _e995 = phi_1224_;
                                    let _e997 = phi_1225_;
                                    let _e999 = phi_1226_;
                                    let _e1001 = phi_1227_;
                                    if _e995 {
                                        if ((_e955 & 2u) != 0u) {
                                            if (((_e955 & 4u) != 0u) != _e279) {
                                                phi_1242_ = false;
                                            } else {
                                                phi_1242_ = true;
                                            }
                                            let _e1008 = phi_1242_;
                                            phi_1243_ = _e1008;
                                        } else {
                                            phi_1243_ = true;
                                        }
                                        let _e1010 = phi_1243_;
                                        if _e1010 {
                                            phi_1250_ = (((_e955 & 1u) != 0u) != _e279);
                                        } else {
                                            phi_1250_ = true;
                                        }
                                        let _e1015 = phi_1250_;
                                        phi_1251_ = _e1015;
                                        phi_1252_ = false;
                                        phi_1253_ = false;
                                        phi_1254_ = false;
                                    } else {
                                        phi_1251_ = bool();
                                        phi_1252_ = _e997;
                                        phi_1253_ = _e999;
                                        phi_1254_ = _e1001;
                                    }
                                    let _e1017 = phi_1251_;
                                    let _e1019 = phi_1252_;
                                    let _e1021 = phi_1253_;
                                    let _e1023 = phi_1254_;
                                    if _e1019 {
                                        phi_1258_ = _e991;
                                        phi_1259_ = false;
                                        phi_1260_ = false;
                                    } else {
                                        phi_1258_ = _e1017;
                                        phi_1259_ = _e1021;
                                        phi_1260_ = _e1023;
                                    }
                                    let _e1025 = phi_1258_;
                                    let _e1027 = phi_1259_;
                                    let _e1029 = phi_1260_;
                                    if _e1027 {
                                        phi_1264_ = false;
                                        phi_1265_ = true;
                                    } else {
                                        phi_1264_ = _e993;
                                        phi_1265_ = _e1029;
                                    }
                                    let _e1031 = phi_1264_;
                                    let _e1033 = phi_1265_;
                                    if _e1033 {
                                        phi_1269_ = _e1031;
                                    } else {
                                        phi_1269_ = _e1025;
                                    }
                                    let _e1035 = phi_1269_;
                                    phi_1270_ = _e1035;
                                }
                                let _e1037 = phi_1270_;
                                if _e829.all_remove {
                                    if (((_e955 & 1u) != 0u) == _e279) {
                                        if ((_e955 & 2u) != 0u) {
                                            phi_1288_ = (((_e955 & 4u) != 0u) == _e279);
                                        } else {
                                            phi_1288_ = true;
                                        }
                                        let _e1047 = phi_1288_;
                                        phi_1289_ = _e1047;
                                    } else {
                                        phi_1289_ = false;
                                    }
                                    let _e1049 = phi_1289_;
                                    phi_1290_ = _e1049;
                                } else {
                                    phi_1290_ = false;
                                }
                                let _e1051 = phi_1290_;
                                phi_1023_ = (_e827 + 1u);
                                phi_1026_ = lt_mask_Neighbourhood(_e1037, _e1051);
                            } else {
                                phi_1023_ = u32();
                                phi_1026_ = lt_mask_Neighbourhood();
                            }
                            let _e1055 = phi_1023_;
                            let _e1057 = phi_1026_;
                            continue;
                            continuing {
                                phi_1022_ = _e1055;
                                phi_1025_ = _e1057;
                                break if !(_e841);
                            }
                        }
                        let _e1421 = local_1;
                        phi_1293_ = _e1421;
                    }
                    let _e1060 = phi_1293_;
                    phi_1294_ = _e1060;
                } else {
                    phi_1294_ = _e812;
                }
                let _e1062 = phi_1294_;
                phi_1295_ = _e1062;
            } else {
                phi_1295_ = _e812;
            }
            let _e1064 = phi_1295_;
            let _e1067 = p.member.frame;
            let _e1069 = p.member.refresh;
            if (_e1069 == 0u) {
                phi_1328_ = false;
            } else {
                if (_e1069 == 0u) {
                    return;
                }
                let _e1078 = ((_e61.x + (_e61.y * (((_e1069 * 5u) / 8u) | 1u))) + (_e1067 % _e1069));
                if (_e1069 == 0u) {
                    phi_1327_ = (_e1078 == 0u);
                } else {
                    if (_e1069 == 0u) {
                        return;
                    }
                    phi_1327_ = ((_e1078 % _e1069) == 0u);
                }
                let _e1085 = phi_1327_;
                phi_1328_ = _e1085;
            }
            let _e1087 = phi_1328_;
            if _e805 {
                if _e1087 {
                    phi_1350_ = bool();
                } else {
                    phi_1350_ = ((0u & 2u) != 0u);
                }
                let _e1093 = phi_1350_;
                phi_1351_ = _e1093;
                phi_1352_ = _e1087;
            } else {
                phi_1351_ = bool();
                phi_1352_ = true;
            }
            let _e1095 = phi_1351_;
            let _e1097 = phi_1352_;
            if _e1097 {
                phi_1356_ = false;
            } else {
                phi_1356_ = _e1095;
            }
            let _e1099 = phi_1356_;
            if _e1099 {
                phi_1407_ = 7u;
            } else {
                if (_e121 != 0.5f) {
                    if _e805 {
                        if _e1087 {
                            phi_1404_ = 6u;
                        } else {
                            if _e283 {
                                phi_1379_ = true;
                            } else {
                                if _e1064.any_expands {
                                    phi_1378_ = false;
                                } else {
                                    phi_1378_ = true;
                                }
                                let _e1101 = phi_1378_;
                                phi_1379_ = _e1101;
                            }
                            let _e1103 = phi_1379_;
                            if _e1103 {
                                if _e283 {
                                    if false {
                                        if _e1064.all_remove {
                                            phi_1392_ = false;
                                        } else {
                                            phi_1392_ = true;
                                        }
                                        let _e1105 = phi_1392_;
                                        phi_1393_ = _e1105;
                                    } else {
                                        phi_1393_ = true;
                                    }
                                    let _e1107 = phi_1393_;
                                    phi_1394_ = _e1107;
                                } else {
                                    phi_1394_ = true;
                                }
                                let _e1109 = phi_1394_;
                                if _e1109 {
                                    if _e283 {
                                        phi_1401_ = 1u;
                                    } else {
                                        phi_1401_ = 0u;
                                    }
                                    let _e1111 = phi_1401_;
                                    phi_1402_ = _e1111;
                                } else {
                                    phi_1402_ = 5u;
                                }
                                let _e1113 = phi_1402_;
                                phi_1403_ = _e1113;
                            } else {
                                phi_1403_ = 4u;
                            }
                            let _e1115 = phi_1403_;
                            phi_1404_ = _e1115;
                        }
                        let _e1117 = phi_1404_;
                        phi_1405_ = _e1117;
                    } else {
                        phi_1405_ = 3u;
                    }
                    let _e1119 = phi_1405_;
                    phi_1406_ = _e1119;
                } else {
                    phi_1406_ = 2u;
                }
                let _e1121 = phi_1406_;
                phi_1407_ = _e1121;
            }
            let _e1123 = phi_1407_;
            if !((_e1123 == 0u)) {
                if !((_e1123 == 5u)) {
                    phi_1419_ = !(_e1099);
                    phi_1420_ = false;
                } else {
                    phi_1419_ = bool();
                    phi_1420_ = true;
                }
                let _e1130 = phi_1419_;
                let _e1132 = phi_1420_;
                phi_1421_ = _e1130;
                phi_1422_ = _e1132;
            } else {
                phi_1421_ = bool();
                phi_1422_ = true;
            }
            let _e1134 = phi_1421_;
            let _e1136 = phi_1422_;
            if _e1136 {
                phi_1426_ = false;
            } else {
                phi_1426_ = _e1134;
            }
            let _e1138 = phi_1426_;
            if _e1099 {
                phi_1432_ = ((0u & 4u) != 0u);
            } else {
                phi_1432_ = _e279;
            }
            let _e1142 = phi_1432_;
            if _e1138 {
                if _e279 {
                    phi_1440_ = (2u | 1u);
                } else {
                    phi_1440_ = 2u;
                }
                let _e1145 = phi_1440_;
                if false {
                    phi_1445_ = (_e1145 | 4u);
                } else {
                    phi_1445_ = _e1145;
                }
                let _e1148 = phi_1445_;
                phi_1465_ = _e1148;
            } else {
                if (_e1123 == 7u) {
                    if _e279 {
                        phi_1454_ = (2u | 1u);
                    } else {
                        phi_1454_ = 2u;
                    }
                    let _e1152 = phi_1454_;
                    if _e1142 {
                        phi_1459_ = (_e1152 | 4u);
                    } else {
                        phi_1459_ = _e1152;
                    }
                    let _e1155 = phi_1459_;
                    phi_1464_ = _e1155;
                } else {
                    if _e279 {
                        phi_1463_ = 1u;
                    } else {
                        phi_1463_ = 0u;
                    }
                    let _e1157 = phi_1463_;
                    phi_1464_ = _e1157;
                }
                let _e1159 = phi_1464_;
                phi_1465_ = _e1159;
            }
            let _e1161 = phi_1465_;
            if _e1142 {
                phi_1469_ = 0f;
            } else {
                phi_1469_ = 1f;
            }
            let _e1163 = phi_1469_;
            phi_1471_ = mask_Masked(_e1163, _e1161, _e1138);
        }
        let _e1166 = phi_1471_;
        visibility.member[_e82.shift] = _e1166.visibility;
        let _e1171 = p.member.light.number;
        let _e1172 = (_e1171 * 3u);
        let _e1174 = (_e1172 % 32u);
        let _e1176 = p.member.light.mask_words;
        let _e1178 = ((_e82.shift * _e1176) + (_e1172 / 32u));
        let _e1180 = bits.member[_e1178];
        bits.member[_e1178] = ((_e1180 & ~((7u << bitcast<u32>((_e1174 & 31u))))) | (_e1166.bits << bitcast<u32>((_e1174 & 31u))));
        if (_e1174 > 29u) {
            let _e1195 = bits.member[(_e1178 + 1u)];
            let _e1197 = (32u - _e1174);
            bits.member[(_e1178 + 1u)] = ((_e1195 & ~((7u >> bitcast<u32>((_e1197 & 31u))))) | (_e1166.bits >> bitcast<u32>((_e1197 & 31u))));
        }
        let _e1212 = samples.member[_e82.shift].normal[0u];
        let _e1214 = global[0u];
        if (_e1212 == _e1214) {
            let _e1217 = samples.member[_e82.shift].normal[1u];
            let _e1219 = global[1u];
            if (_e1217 == _e1219) {
                let _e1222 = samples.member[_e82.shift].normal[2u];
                let _e1224 = global[2u];
                phi_1543_ = (_e1222 == _e1224);
                phi_1544_ = false;
            } else {
                phi_1543_ = bool();
                phi_1544_ = true;
            }
            let _e1227 = phi_1543_;
            let _e1229 = phi_1544_;
            phi_1545_ = _e1227;
            phi_1546_ = _e1229;
        } else {
            phi_1545_ = bool();
            phi_1546_ = true;
        }
        let _e1231 = phi_1545_;
        let _e1233 = phi_1546_;
        if _e1233 {
            phi_1550_ = false;
        } else {
            phi_1550_ = _e1231;
        }
        let _e1235 = phi_1550_;
        if !(_e1235) {
            let _e1238 = samples.member[_e82.shift].position;
            let _e1240 = p.member.current.eye;
            let _e1251 = p.member.current.forward;
            phi_1578_ = ((((_e1238.x - _e1240.x) * _e1251.x) + ((_e1238.y - _e1240.y) * _e1251.y)) + ((_e1238.z - _e1240.z) * _e1251.z));
        } else {
            phi_1578_ = 0f;
        }
        let _e1261 = phi_1578_;
        depths.member[_e82.shift] = _e1261;
        phi_1581_ = _e1166.needs_ray;
        phi_1582_ = _e82.shift;
    } else {
        phi_1581_ = false;
        phi_1582_ = 0u;
    }
    let _e1265 = phi_1581_;
    let _e1267 = phi_1582_;
    if (_e62 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1265 {
        let _e1271 = atomicAdd((&shared_[0u]), 1u);
        phi_1593_ = _e1271;
    } else {
        phi_1593_ = 0u;
    }
    let _e1273 = phi_1593_;
    workgroupBarrier();
    if (_e62 == 0u) {
        let _e1277 = atomicLoad((&shared_[0u]));
        let _e1278 = atomicAdd((&list.member[3u]), _e1277);
        atomicStore((&shared_[1u]), _e1278);
    }
    workgroupBarrier();
    if _e1265 {
        let _e1281 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1281) + _e1273)]), _e1267);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_depth_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
