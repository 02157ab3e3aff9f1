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
    var phi_1035_: u32;
    var phi_1054_: u32;
    var phi_1062_: u32;
    var phi_1063_: u32;
    var phi_1064_: bool;
    var phi_1065_: u32;
    var phi_1066_: bool;
    var phi_1067_: bool;
    var phi_1068_: u32;
    var phi_1069_: bool;
    var phi_1070_: bool;
    var phi_1074_: bool;
    var phi_1078_: u32;
    var phi_1083_: bool;
    var phi_1105_: u32;
    var phi_1107_: u32;
    var phi_1110_: lt_mask_Neighbourhood;
    var phi_1122_: bool;
    var phi_1123_: bool;
    var phi_1132_: u32;
    var phi_1133_: u32;
    var phi_1193_: vec2<i32>;
    var phi_1213_: vec2<i32>;
    var phi_1240_: u32;
    var phi_1259_: u32;
    var phi_1267_: u32;
    var phi_1293_: bool;
    var phi_1294_: bool;
    var phi_1295_: bool;
    var phi_1296_: bool;
    var phi_1297_: bool;
    var phi_1298_: bool;
    var phi_1299_: bool;
    var phi_1304_: bool;
    var phi_1305_: bool;
    var phi_1306_: bool;
    var phi_1307_: bool;
    var phi_1308_: bool;
    var phi_1309_: bool;
    var phi_1310_: bool;
    var phi_1311_: bool;
    var phi_1312_: bool;
    var phi_1327_: bool;
    var phi_1328_: bool;
    var phi_1335_: bool;
    var phi_1336_: bool;
    var phi_1337_: bool;
    var phi_1338_: bool;
    var phi_1339_: bool;
    var phi_1343_: bool;
    var phi_1344_: bool;
    var phi_1345_: bool;
    var phi_1349_: bool;
    var phi_1350_: bool;
    var phi_1354_: bool;
    var phi_1355_: bool;
    var phi_1373_: bool;
    var phi_1374_: bool;
    var phi_1375_: bool;
    var phi_1108_: u32;
    var phi_1111_: lt_mask_Neighbourhood;
    var phi_1378_: lt_mask_Neighbourhood;
    var phi_1379_: lt_mask_Neighbourhood;
    var phi_1380_: lt_mask_Neighbourhood;
    var phi_1412_: bool;
    var phi_1413_: bool;
    var phi_1435_: bool;
    var phi_1436_: bool;
    var phi_1437_: bool;
    var phi_1441_: bool;
    var phi_1463_: bool;
    var phi_1464_: bool;
    var phi_1477_: bool;
    var phi_1478_: bool;
    var phi_1479_: bool;
    var phi_1486_: u32;
    var phi_1487_: u32;
    var phi_1488_: u32;
    var phi_1489_: u32;
    var phi_1490_: u32;
    var phi_1491_: u32;
    var phi_1492_: u32;
    var phi_1504_: bool;
    var phi_1505_: bool;
    var phi_1506_: bool;
    var phi_1507_: bool;
    var phi_1511_: bool;
    var phi_1517_: bool;
    var phi_1525_: u32;
    var phi_1530_: u32;
    var phi_1539_: u32;
    var phi_1544_: u32;
    var phi_1548_: u32;
    var phi_1549_: u32;
    var phi_1550_: u32;
    var phi_1554_: f32;
    var phi_1556_: mask_Masked;
    var phi_1628_: bool;
    var phi_1629_: bool;
    var phi_1630_: bool;
    var phi_1631_: bool;
    var phi_1635_: bool;
    var phi_1663_: f32;
    var phi_1666_: bool;
    var phi_1667_: u32;
    var phi_1678_: u32;
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
            phi_1556_ = mask_Masked(_e274.unnamed.visibility, 0u, false);
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
            let _e813 = p.member.flags;
            let _e815 = ((_e813 & 2u) != 0u);
            let _e817 = p.member.flags;
            if ((_e817 & 4u) == 0u) {
                phi_1068_ = u32();
                phi_1069_ = true;
                phi_1070_ = false;
            } else {
                if _e805 {
                    if !(_e811.has_moved) {
                        let _e828 = ((((_e61.y * _e113) + _e61.x) * _e109.words) + _e109.light.word);
                        if (_e109.light.shift > 29u) {
                            let _e832 = (_e828 + 1u);
                            if (_e832 < _e67) {
                            } else {
                                return;
                            }
                            let _e836 = last_bits.member[(0u + _e832)];
                            phi_1035_ = _e836;
                        } else {
                            phi_1035_ = 0u;
                        }
                        let _e838 = phi_1035_;
                        if (_e828 < _e67) {
                        } else {
                            return;
                        }
                        let _e844 = last_bits.member[(0u + _e828)];
                        let _e847 = (_e844 >> bitcast<u32>((_e109.light.shift & 31u)));
                        if (_e109.light.shift > 29u) {
                            phi_1054_ = (_e847 | (_e838 << bitcast<u32>(((32u - _e109.light.shift) & 31u))));
                        } else {
                            phi_1054_ = _e847;
                        }
                        let _e855 = phi_1054_;
                        if ((_e855 & 2u) == 0u) {
                            phi_1062_ = (_e855 & 1u);
                        } else {
                            phi_1062_ = (_e855 & 7u);
                        }
                        let _e861 = phi_1062_;
                        phi_1063_ = _e861;
                        phi_1064_ = false;
                    } else {
                        phi_1063_ = u32();
                        phi_1064_ = true;
                    }
                    let _e863 = phi_1063_;
                    let _e865 = phi_1064_;
                    phi_1065_ = _e863;
                    phi_1066_ = false;
                    phi_1067_ = _e865;
                } else {
                    phi_1065_ = u32();
                    phi_1066_ = true;
                    phi_1067_ = false;
                }
                let _e867 = phi_1065_;
                let _e869 = phi_1066_;
                let _e871 = phi_1067_;
                phi_1068_ = _e867;
                phi_1069_ = _e869;
                phi_1070_ = _e871;
            }
            let _e873 = phi_1068_;
            let _e875 = phi_1069_;
            let _e877 = phi_1070_;
            if _e875 {
                phi_1074_ = true;
            } else {
                phi_1074_ = _e877;
            }
            let _e879 = phi_1074_;
            if _e879 {
                phi_1078_ = 0u;
            } else {
                phi_1078_ = _e873;
            }
            let _e881 = phi_1078_;
            let _e882 = lt_mask_Neighbourhood(false, true);
            if _e283 {
                phi_1083_ = _e815;
            } else {
                phi_1083_ = true;
            }
            let _e884 = phi_1083_;
            if _e884 {
                if _e805 {
                    if ((_e881 & 2u) != 0u) {
                        phi_1378_ = _e882;
                    } else {
                        let _e888 = p.member.expansion;
                        if _e811.has_moved {
                            let _e891 = p.member.moving_pattern;
                            phi_1105_ = _e891;
                        } else {
                            let _e893 = p.member.still_pattern;
                            phi_1105_ = _e893;
                        }
                        let _e895 = phi_1105_;
                        phi_1107_ = 0u;
                        phi_1110_ = _e882;
                        loop {
                            let _e897 = phi_1107_;
                            let _e899 = phi_1110_;
                            local_1 = _e899;
                            if (1u <= _e895) {
                                if (_e895 <= 4u) {
                                    phi_1122_ = false;
                                } else {
                                    phi_1122_ = true;
                                }
                                let _e903 = phi_1122_;
                                phi_1123_ = _e903;
                            } else {
                                phi_1123_ = true;
                            }
                            let _e905 = phi_1123_;
                            if _e905 {
                                switch bitcast<i32>(_e895) {
                                    case 5: {
                                        phi_1132_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_1132_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_1132_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_1132_ = 9u;
                                        break;
                                    }
                                }
                                let _e908 = phi_1132_;
                                phi_1133_ = _e908;
                            } else {
                                phi_1133_ = 5u;
                            }
                            let _e910 = phi_1133_;
                            let _e911 = (_e897 < _e910);
                            if _e911 {
                                let _e917 = p.member.frame;
                                let _e921 = p.member.current.size[0u];
                                let _e923 = p.member.current.size[1u];
                                switch bitcast<i32>(_e895) {
                                    case 1: {
                                        let _e933 = lt_mask_pattern_plus(_e897);
                                        phi_1213_ = vec2<i32>(_e933.x, _e933.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e937 = lt_mask_pattern_cross(_e897);
                                        phi_1213_ = vec2<i32>(_e937.x, _e937.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e943 = lt_mask_pattern_plus_or_cross(_e897, ((_e811.pixel.x + _e811.pixel.y) & 1u));
                                        phi_1213_ = vec2<i32>(_e943.x, _e943.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e948 = lt_mask_pattern_plus_or_cross(_e897, (_e917 & 1u));
                                        phi_1213_ = vec2<i32>(_e948.x, _e948.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e917 & 3u)) {
                                            case 0: {
                                                phi_1193_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_1193_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_1193_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_1193_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e959 = phi_1193_;
                                        phi_1213_ = (_e959 + vec2<i32>(bitcast<i32>((_e897 & 1u)), bitcast<i32>(((_e897 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_1213_ = vec2<i32>((bitcast<i32>((_e897 % 5u)) - 2i), (bitcast<i32>(((_e897 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e976 = lt_mask_pattern_diamond(_e897);
                                        phi_1213_ = vec2<i32>(_e976.x, _e976.y);
                                        break;
                                    }
                                    default: {
                                        phi_1213_ = vec2<i32>((bitcast<i32>((_e897 % 3u)) - 1i), (bitcast<i32>(((_e897 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e981 = phi_1213_;
                                let _e984 = lt_mask_pattern_step_clamped(_e811.pixel.x, _e981.x, _e921);
                                let _e985 = lt_mask_pattern_step_clamped(_e811.pixel.y, _e981.y, _e923);
                                let _e992 = ((((_e985 * _e113) + _e984) * _e109.words) + _e109.light.word);
                                if (_e109.light.shift > 29u) {
                                    let _e996 = (_e992 + 1u);
                                    if (_e996 < _e67) {
                                    } else {
                                        return;
                                    }
                                    let _e1000 = last_bits.member[(0u + _e996)];
                                    phi_1240_ = _e1000;
                                } else {
                                    phi_1240_ = 0u;
                                }
                                let _e1002 = phi_1240_;
                                if (_e992 < _e67) {
                                } else {
                                    return;
                                }
                                let _e1008 = last_bits.member[(0u + _e992)];
                                let _e1011 = (_e1008 >> bitcast<u32>((_e109.light.shift & 31u)));
                                if (_e109.light.shift > 29u) {
                                    phi_1259_ = (_e1011 | (_e1002 << bitcast<u32>(((32u - _e109.light.shift) & 31u))));
                                } else {
                                    phi_1259_ = _e1011;
                                }
                                let _e1019 = phi_1259_;
                                if ((_e1019 & 2u) == 0u) {
                                    phi_1267_ = (_e1019 & 1u);
                                } else {
                                    phi_1267_ = (_e1019 & 7u);
                                }
                                let _e1025 = phi_1267_;
                                if _e899.any_expands {
                                    phi_1355_ = true;
                                } else {
                                    if ((_e1025 & 2u) != 0u) {
                                        let _e1032 = (((_e1025 & 4u) != 0u) != _e279);
                                        switch bitcast<i32>(_e888) {
                                            case 1: {
                                                phi_1295_ = bool();
                                                phi_1296_ = false;
                                                phi_1297_ = true;
                                                phi_1298_ = false;
                                                phi_1299_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e1032 {
                                                    phi_1293_ = (((_e1025 & 4u) != 0u) != ((_e1025 & 1u) != 0u));
                                                    phi_1294_ = false;
                                                } else {
                                                    phi_1293_ = bool();
                                                    phi_1294_ = true;
                                                }
                                                let _e1040 = phi_1293_;
                                                let _e1042 = phi_1294_;
                                                phi_1295_ = _e1040;
                                                phi_1296_ = false;
                                                phi_1297_ = false;
                                                phi_1298_ = _e1042;
                                                phi_1299_ = _e1032;
                                                break;
                                            }
                                            default: {
                                                phi_1295_ = bool();
                                                phi_1296_ = true;
                                                phi_1297_ = false;
                                                phi_1298_ = false;
                                                phi_1299_ = false;
                                                break;
                                            }
                                        }
                                        let _e1044 = phi_1295_;
                                        let _e1046 = phi_1296_;
                                        let _e1048 = phi_1297_;
                                        let _e1050 = phi_1298_;
                                        let _e1052 = phi_1299_;
                                        phi_1307_ = _e1032;
                                        phi_1308_ = _e1044;
                                        phi_1309_ = _e1046;
                                        phi_1310_ = _e1048;
                                        phi_1311_ = _e1050;
                                        phi_1312_ = _e1052;
                                    } else {
                                        switch bitcast<i32>(_e888) {
                                            case 1: {
                                                phi_1304_ = false;
                                                phi_1305_ = true;
                                                phi_1306_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_1304_ = false;
                                                phi_1305_ = false;
                                                phi_1306_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_1304_ = true;
                                                phi_1305_ = false;
                                                phi_1306_ = false;
                                                break;
                                            }
                                        }
                                        let _e1055 = phi_1304_;
                                        let _e1057 = phi_1305_;
                                        let _e1059 = phi_1306_;
                                        phi_1307_ = false;
                                        phi_1308_ = bool();
                                        phi_1309_ = _e1055;
                                        phi_1310_ = _e1057;
                                        phi_1311_ = _e1059;
                                        phi_1312_ = false;
                                    }
                                    let _e1061 = phi_1307_;
                                    let _e1063 = phi_1308_;
                                    let _e1065 = phi_1309_;
                                    let _e1067 = phi_1310_;
                                    let _e1069 = phi_1311_;
                                    let _e1071 = phi_1312_;
                                    if _e1065 {
                                        if ((_e1025 & 2u) != 0u) {
                                            if (((_e1025 & 4u) != 0u) != _e279) {
                                                phi_1327_ = false;
                                            } else {
                                                phi_1327_ = true;
                                            }
                                            let _e1078 = phi_1327_;
                                            phi_1328_ = _e1078;
                                        } else {
                                            phi_1328_ = true;
                                        }
                                        let _e1080 = phi_1328_;
                                        if _e1080 {
                                            phi_1335_ = (((_e1025 & 1u) != 0u) != _e279);
                                        } else {
                                            phi_1335_ = true;
                                        }
                                        let _e1085 = phi_1335_;
                                        phi_1336_ = _e1085;
                                        phi_1337_ = false;
                                        phi_1338_ = false;
                                        phi_1339_ = false;
                                    } else {
                                        phi_1336_ = bool();
                                        phi_1337_ = _e1067;
                                        phi_1338_ = _e1069;
                                        phi_1339_ = _e1071;
                                    }
                                    let _e1087 = phi_1336_;
                                    let _e1089 = phi_1337_;
                                    let _e1091 = phi_1338_;
                                    let _e1093 = phi_1339_;
                                    if _e1089 {
                                        phi_1343_ = _e1061;
                                        phi_1344_ = false;
                                        phi_1345_ = false;
                                    } else {
                                        phi_1343_ = _e1087;
                                        phi_1344_ = _e1091;
                                        phi_1345_ = _e1093;
                                    }
                                    let _e1095 = phi_1343_;
                                    let _e1097 = phi_1344_;
                                    let _e1099 = phi_1345_;
                                    if _e1097 {
                                        phi_1349_ = false;
                                        phi_1350_ = true;
                                    } else {
                                        phi_1349_ = _e1063;
                                        phi_1350_ = _e1099;
                                    }
                                    let _e1101 = phi_1349_;
                                    let _e1103 = phi_1350_;
                                    if _e1103 {
                                        phi_1354_ = _e1101;
                                    } else {
                                        phi_1354_ = _e1095;
                                    }
                                    let _e1105 = phi_1354_;
                                    phi_1355_ = _e1105;
                                }
                                let _e1107 = phi_1355_;
                                if _e899.all_remove {
                                    if (((_e1025 & 1u) != 0u) == _e279) {
                                        if ((_e1025 & 2u) != 0u) {
                                            phi_1373_ = (((_e1025 & 4u) != 0u) == _e279);
                                        } else {
                                            phi_1373_ = true;
                                        }
                                        let _e1117 = phi_1373_;
                                        phi_1374_ = _e1117;
                                    } else {
                                        phi_1374_ = false;
                                    }
                                    let _e1119 = phi_1374_;
                                    phi_1375_ = _e1119;
                                } else {
                                    phi_1375_ = false;
                                }
                                let _e1121 = phi_1375_;
                                phi_1108_ = (_e897 + 1u);
                                phi_1111_ = lt_mask_Neighbourhood(_e1107, _e1121);
                            } else {
                                phi_1108_ = u32();
                                phi_1111_ = lt_mask_Neighbourhood();
                            }
                            let _e1125 = phi_1108_;
                            let _e1127 = phi_1111_;
                            continue;
                            continuing {
                                phi_1107_ = _e1125;
                                phi_1110_ = _e1127;
                                break if !(_e911);
                            }
                        }
                        let _e1504 = local_1;
                        phi_1378_ = _e1504;
                    }
                    let _e1130 = phi_1378_;
                    phi_1379_ = _e1130;
                } else {
                    phi_1379_ = _e882;
                }
                let _e1132 = phi_1379_;
                phi_1380_ = _e1132;
            } else {
                phi_1380_ = _e882;
            }
            let _e1134 = phi_1380_;
            let _e1137 = p.member.frame;
            let _e1139 = p.member.refresh;
            if (_e1139 == 0u) {
                phi_1413_ = false;
            } else {
                if (_e1139 == 0u) {
                    return;
                }
                let _e1148 = ((_e61.x + (_e61.y * (((_e1139 * 5u) / 8u) | 1u))) + (_e1137 % _e1139));
                if (_e1139 == 0u) {
                    phi_1412_ = (_e1148 == 0u);
                } else {
                    if (_e1139 == 0u) {
                        return;
                    }
                    phi_1412_ = ((_e1148 % _e1139) == 0u);
                }
                let _e1155 = phi_1412_;
                phi_1413_ = _e1155;
            }
            let _e1157 = phi_1413_;
            if _e805 {
                if _e1157 {
                    phi_1435_ = bool();
                } else {
                    phi_1435_ = ((_e881 & 2u) != 0u);
                }
                let _e1163 = phi_1435_;
                phi_1436_ = _e1163;
                phi_1437_ = _e1157;
            } else {
                phi_1436_ = bool();
                phi_1437_ = true;
            }
            let _e1165 = phi_1436_;
            let _e1167 = phi_1437_;
            if _e1167 {
                phi_1441_ = false;
            } else {
                phi_1441_ = _e1165;
            }
            let _e1169 = phi_1441_;
            if _e1169 {
                phi_1492_ = 7u;
            } else {
                if (_e121 != 0.5f) {
                    if _e805 {
                        if _e1157 {
                            phi_1489_ = 6u;
                        } else {
                            if _e283 {
                                phi_1464_ = true;
                            } else {
                                if _e1134.any_expands {
                                    phi_1463_ = false;
                                } else {
                                    phi_1463_ = true;
                                }
                                let _e1171 = phi_1463_;
                                phi_1464_ = _e1171;
                            }
                            let _e1173 = phi_1464_;
                            if _e1173 {
                                if _e283 {
                                    if _e815 {
                                        if _e1134.all_remove {
                                            phi_1477_ = false;
                                        } else {
                                            phi_1477_ = true;
                                        }
                                        let _e1175 = phi_1477_;
                                        phi_1478_ = _e1175;
                                    } else {
                                        phi_1478_ = true;
                                    }
                                    let _e1177 = phi_1478_;
                                    phi_1479_ = _e1177;
                                } else {
                                    phi_1479_ = true;
                                }
                                let _e1179 = phi_1479_;
                                if _e1179 {
                                    if _e283 {
                                        phi_1486_ = 1u;
                                    } else {
                                        phi_1486_ = 0u;
                                    }
                                    let _e1181 = phi_1486_;
                                    phi_1487_ = _e1181;
                                } else {
                                    phi_1487_ = 5u;
                                }
                                let _e1183 = phi_1487_;
                                phi_1488_ = _e1183;
                            } else {
                                phi_1488_ = 4u;
                            }
                            let _e1185 = phi_1488_;
                            phi_1489_ = _e1185;
                        }
                        let _e1187 = phi_1489_;
                        phi_1490_ = _e1187;
                    } else {
                        phi_1490_ = 3u;
                    }
                    let _e1189 = phi_1490_;
                    phi_1491_ = _e1189;
                } else {
                    phi_1491_ = 2u;
                }
                let _e1191 = phi_1491_;
                phi_1492_ = _e1191;
            }
            let _e1193 = phi_1492_;
            if !((_e1193 == 0u)) {
                if !((_e1193 == 5u)) {
                    phi_1504_ = !(_e1169);
                    phi_1505_ = false;
                } else {
                    phi_1504_ = bool();
                    phi_1505_ = true;
                }
                let _e1200 = phi_1504_;
                let _e1202 = phi_1505_;
                phi_1506_ = _e1200;
                phi_1507_ = _e1202;
            } else {
                phi_1506_ = bool();
                phi_1507_ = true;
            }
            let _e1204 = phi_1506_;
            let _e1206 = phi_1507_;
            if _e1206 {
                phi_1511_ = false;
            } else {
                phi_1511_ = _e1204;
            }
            let _e1208 = phi_1511_;
            if _e1169 {
                phi_1517_ = ((_e881 & 4u) != 0u);
            } else {
                phi_1517_ = _e279;
            }
            let _e1212 = phi_1517_;
            if _e1208 {
                if _e279 {
                    phi_1525_ = (2u | 1u);
                } else {
                    phi_1525_ = 2u;
                }
                let _e1215 = phi_1525_;
                if false {
                    phi_1530_ = (_e1215 | 4u);
                } else {
                    phi_1530_ = _e1215;
                }
                let _e1218 = phi_1530_;
                phi_1550_ = _e1218;
            } else {
                if (_e1193 == 7u) {
                    if _e279 {
                        phi_1539_ = (2u | 1u);
                    } else {
                        phi_1539_ = 2u;
                    }
                    let _e1222 = phi_1539_;
                    if _e1212 {
                        phi_1544_ = (_e1222 | 4u);
                    } else {
                        phi_1544_ = _e1222;
                    }
                    let _e1225 = phi_1544_;
                    phi_1549_ = _e1225;
                } else {
                    if _e279 {
                        phi_1548_ = 1u;
                    } else {
                        phi_1548_ = 0u;
                    }
                    let _e1227 = phi_1548_;
                    phi_1549_ = _e1227;
                }
                let _e1229 = phi_1549_;
                phi_1550_ = _e1229;
            }
            let _e1231 = phi_1550_;
            if _e1212 {
                phi_1554_ = 0f;
            } else {
                phi_1554_ = 1f;
            }
            let _e1233 = phi_1554_;
            phi_1556_ = mask_Masked(_e1233, _e1231, _e1208);
        }
        let _e1236 = phi_1556_;
        visibility.member[_e82.shift] = _e1236.visibility;
        let _e1241 = p.member.light.number;
        let _e1242 = (_e1241 * 3u);
        let _e1244 = (_e1242 % 32u);
        let _e1246 = p.member.light.mask_words;
        let _e1248 = ((_e82.shift * _e1246) + (_e1242 / 32u));
        let _e1250 = bits.member[_e1248];
        bits.member[_e1248] = ((_e1250 & ~((7u << bitcast<u32>((_e1244 & 31u))))) | (_e1236.bits << bitcast<u32>((_e1244 & 31u))));
        if (_e1244 > 29u) {
            let _e1265 = bits.member[(_e1248 + 1u)];
            let _e1267 = (32u - _e1244);
            bits.member[(_e1248 + 1u)] = ((_e1265 & ~((7u >> bitcast<u32>((_e1267 & 31u))))) | (_e1236.bits >> bitcast<u32>((_e1267 & 31u))));
        }
        let _e1282 = samples.member[_e82.shift].normal[0u];
        let _e1284 = global[0u];
        if (_e1282 == _e1284) {
            let _e1287 = samples.member[_e82.shift].normal[1u];
            let _e1289 = global[1u];
            if (_e1287 == _e1289) {
                let _e1292 = samples.member[_e82.shift].normal[2u];
                let _e1294 = global[2u];
                phi_1628_ = (_e1292 == _e1294);
                phi_1629_ = false;
            } else {
                phi_1628_ = bool();
                phi_1629_ = true;
            }
            let _e1297 = phi_1628_;
            let _e1299 = phi_1629_;
            phi_1630_ = _e1297;
            phi_1631_ = _e1299;
        } else {
            phi_1630_ = bool();
            phi_1631_ = true;
        }
        let _e1301 = phi_1630_;
        let _e1303 = phi_1631_;
        if _e1303 {
            phi_1635_ = false;
        } else {
            phi_1635_ = _e1301;
        }
        let _e1305 = phi_1635_;
        if !(_e1305) {
            let _e1308 = samples.member[_e82.shift].position;
            let _e1310 = p.member.current.eye;
            let _e1321 = p.member.current.forward;
            phi_1663_ = ((((_e1308.x - _e1310.x) * _e1321.x) + ((_e1308.y - _e1310.y) * _e1321.y)) + ((_e1308.z - _e1310.z) * _e1321.z));
        } else {
            phi_1663_ = 0f;
        }
        let _e1331 = phi_1663_;
        depths.member[_e82.shift] = _e1331;
        phi_1666_ = _e1236.needs_ray;
        phi_1667_ = _e82.shift;
    } else {
        phi_1666_ = false;
        phi_1667_ = 0u;
    }
    let _e1335 = phi_1666_;
    let _e1337 = phi_1667_;
    if (_e62 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1335 {
        let _e1341 = atomicAdd((&shared_[0u]), 1u);
        phi_1678_ = _e1341;
    } else {
        phi_1678_ = 0u;
    }
    let _e1343 = phi_1678_;
    workgroupBarrier();
    if (_e62 == 0u) {
        let _e1347 = atomicLoad((&shared_[0u]));
        let _e1348 = atomicAdd((&list.member[3u]), _e1347);
        atomicStore((&shared_[1u]), _e1348);
    }
    workgroupBarrier();
    if _e1335 {
        let _e1351 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1351) + _e1343)]), _e1337);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_depth_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
