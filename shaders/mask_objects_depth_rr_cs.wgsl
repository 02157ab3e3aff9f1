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
    var phi_527_: bool;
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
    var phi_895_: bool;
    var phi_897_: lt_mask_Reprojection;
    var phi_898_: lt_mask_Reprojection;
    var phi_899_: lt_mask_Reprojection;
    var phi_900_: bool;
    var phi_901_: bool;
    var phi_902_: lt_mask_Reprojection;
    var phi_903_: lt_mask_Reprojection;
    var phi_904_: lt_mask_Reprojection;
    var phi_905_: bool;
    var phi_906_: bool;
    var phi_958_: bool;
    var phi_962_: f32;
    var phi_966_: lt_mask_Reprojection;
    var phi_967_: bool;
    var phi_979_: bool;
    var phi_980_: bool;
    var phi_981_: bool;
    var phi_982_: lt_mask_Reprojection;
    var phi_983_: bool;
    var phi_987_: bool;
    var phi_988_: lt_mask_Reprojection;
    var phi_1031_: u32;
    var phi_1050_: u32;
    var phi_1058_: u32;
    var phi_1059_: u32;
    var phi_1060_: bool;
    var phi_1061_: u32;
    var phi_1062_: bool;
    var phi_1063_: bool;
    var phi_1064_: u32;
    var phi_1065_: bool;
    var phi_1066_: bool;
    var phi_1070_: bool;
    var phi_1074_: u32;
    var phi_1079_: bool;
    var phi_1101_: u32;
    var phi_1103_: u32;
    var phi_1106_: lt_mask_Neighbourhood;
    var phi_1118_: bool;
    var phi_1119_: bool;
    var phi_1128_: u32;
    var phi_1129_: u32;
    var phi_1189_: vec2<i32>;
    var phi_1209_: vec2<i32>;
    var phi_1236_: u32;
    var phi_1255_: u32;
    var phi_1263_: u32;
    var phi_1289_: bool;
    var phi_1290_: bool;
    var phi_1291_: bool;
    var phi_1292_: bool;
    var phi_1293_: bool;
    var phi_1294_: bool;
    var phi_1295_: bool;
    var phi_1300_: bool;
    var phi_1301_: bool;
    var phi_1302_: bool;
    var phi_1303_: bool;
    var phi_1304_: bool;
    var phi_1305_: bool;
    var phi_1306_: bool;
    var phi_1307_: bool;
    var phi_1308_: bool;
    var phi_1323_: bool;
    var phi_1324_: bool;
    var phi_1331_: bool;
    var phi_1332_: bool;
    var phi_1333_: bool;
    var phi_1334_: bool;
    var phi_1335_: bool;
    var phi_1339_: bool;
    var phi_1340_: bool;
    var phi_1341_: bool;
    var phi_1345_: bool;
    var phi_1346_: bool;
    var phi_1350_: bool;
    var phi_1351_: bool;
    var phi_1369_: bool;
    var phi_1370_: bool;
    var phi_1371_: bool;
    var phi_1104_: u32;
    var phi_1107_: lt_mask_Neighbourhood;
    var phi_1374_: lt_mask_Neighbourhood;
    var phi_1375_: lt_mask_Neighbourhood;
    var phi_1376_: lt_mask_Neighbourhood;
    var phi_1408_: bool;
    var phi_1409_: bool;
    var phi_1431_: bool;
    var phi_1432_: bool;
    var phi_1433_: bool;
    var phi_1437_: bool;
    var phi_1459_: bool;
    var phi_1460_: bool;
    var phi_1473_: bool;
    var phi_1474_: bool;
    var phi_1475_: bool;
    var phi_1482_: u32;
    var phi_1483_: u32;
    var phi_1484_: u32;
    var phi_1485_: u32;
    var phi_1486_: u32;
    var phi_1487_: u32;
    var phi_1488_: u32;
    var phi_1500_: bool;
    var phi_1501_: bool;
    var phi_1502_: bool;
    var phi_1503_: bool;
    var phi_1507_: bool;
    var phi_1513_: bool;
    var phi_1521_: u32;
    var phi_1526_: u32;
    var phi_1535_: u32;
    var phi_1540_: u32;
    var phi_1544_: u32;
    var phi_1545_: u32;
    var phi_1546_: u32;
    var phi_1550_: f32;
    var phi_1552_: mask_Masked;
    var phi_1624_: bool;
    var phi_1625_: bool;
    var phi_1626_: bool;
    var phi_1627_: bool;
    var phi_1631_: bool;
    var phi_1659_: f32;
    var phi_1662_: bool;
    var phi_1663_: u32;
    var phi_1674_: u32;
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
            phi_1552_ = mask_Masked(_e274.unnamed.visibility, 0u, false);
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
                phi_527_ = false;
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
                phi_527_ = _e329;
            }
            let _e331 = phi_527_;
            if _e331 {
                phi_902_ = lt_mask_Reprojection(_e301.pixel, _e301.is_valid, false);
                phi_903_ = lt_mask_Reprojection();
                phi_904_ = lt_mask_Reprojection();
                phi_905_ = true;
                phi_906_ = false;
            } else {
                let _e333 = samples.member[_e82.shift].position;
                let _e337 = p.member.previous.eye;
                let _e339 = (_e116.x - _e337.x);
                let _e341 = (_e116.y - _e337.y);
                let _e343 = (_e116.z - _e337.z);
                let _e345 = p.member.previous.forward;
                let _e353 = (((_e339 * _e345.x) + (_e341 * _e345.y)) + (_e343 * _e345.z));
                let _e355 = p.member.previous.right;
                let _e365 = p.member.previous.right;
                let _e380 = p.member.previous.up;
                let _e390 = p.member.previous.up;
                let _e405 = p.member.current.eye;
                let _e408 = (_e333.x - _e405.x);
                let _e411 = (_e333.y - _e405.y);
                let _e414 = (_e333.z - _e405.z);
                let _e416 = p.member.current.forward;
                let _e424 = (((_e408 * _e416.x) + (_e411 * _e416.y)) + (_e414 * _e416.z));
                let _e426 = p.member.current.right;
                let _e436 = p.member.current.right;
                let _e451 = p.member.current.up;
                let _e461 = p.member.current.up;
                let _e480 = p.member.current.size[0u];
                let _e482 = (((((((_e339 * _e355.x) + (_e341 * _e355.y)) + (_e343 * _e355.z)) / ((((_e365.x * _e365.x) + (_e365.y * _e365.y)) + (_e365.z * _e365.z)) * _e353)) - ((((_e408 * _e426.x) + (_e411 * _e426.y)) + (_e414 * _e426.z)) / ((((_e436.x * _e436.x) + (_e436.y * _e436.y)) + (_e436.z * _e436.z)) * _e424))) * 0.5f) * f32(_e480));
                let _e486 = p.member.current.size[1u];
                let _e488 = (((((((_e339 * _e380.x) + (_e341 * _e380.y)) + (_e343 * _e380.z)) / ((((_e390.x * _e390.x) + (_e390.y * _e390.y)) + (_e390.z * _e390.z)) * _e353)) - ((((_e408 * _e451.x) + (_e411 * _e451.y)) + (_e414 * _e451.z)) / ((((_e461.x * _e461.x) + (_e461.y * _e461.y)) + (_e461.z * _e461.z)) * _e424))) * -0.5f) * f32(_e486));
                let _e492 = p.member.current.grid[0u];
                let _e494 = p.member.current.grid[1u];
                let _e514 = p.member.current.size[0u];
                let _e516 = p.member.current.size[1u];
                let _e518 = ((f32(_e61.x) + ((f32((_e61.y & (_e494 - 1u))) + 0.5f) / f32(_e494))) + _e482);
                if (_e518 > -8388608f) {
                    let _e530 = f32(select(0i, select(select(i32(_e518), i32(-2147483648), (_e518 < bitcast<f32>(3472883712u))), 2147483647i, (_e518 > bitcast<f32>(1325400063u))), (_e518 == _e518)));
                    if (_e530 > _e518) {
                        phi_735_ = 1f;
                    } else {
                        phi_735_ = 0f;
                    }
                    let _e533 = phi_735_;
                    if (_e518 < 8388608f) {
                        phi_740_ = (_e530 - _e533);
                        phi_741_ = false;
                    } else {
                        phi_740_ = f32();
                        phi_741_ = true;
                    }
                    let _e536 = phi_740_;
                    let _e538 = phi_741_;
                    phi_742_ = _e536;
                    phi_743_ = _e538;
                } else {
                    phi_742_ = f32();
                    phi_743_ = true;
                }
                let _e540 = phi_742_;
                let _e542 = phi_743_;
                if _e542 {
                    phi_747_ = _e518;
                } else {
                    phi_747_ = _e540;
                }
                let _e544 = phi_747_;
                let _e545 = ((f32(_e61.y) + ((f32((_e61.x & (_e492 - 1u))) + 0.5f) / f32(_e492))) + _e488);
                if (_e545 > -8388608f) {
                    let _e557 = f32(select(0i, select(select(i32(_e545), i32(-2147483648), (_e545 < bitcast<f32>(3472883712u))), 2147483647i, (_e545 > bitcast<f32>(1325400063u))), (_e545 == _e545)));
                    if (_e557 > _e545) {
                        phi_768_ = 1f;
                    } else {
                        phi_768_ = 0f;
                    }
                    let _e560 = phi_768_;
                    if (_e545 < 8388608f) {
                        phi_773_ = (_e557 - _e560);
                        phi_774_ = false;
                    } else {
                        phi_773_ = f32();
                        phi_774_ = true;
                    }
                    let _e563 = phi_773_;
                    let _e565 = phi_774_;
                    phi_775_ = _e563;
                    phi_776_ = _e565;
                } else {
                    phi_775_ = f32();
                    phi_776_ = true;
                }
                let _e567 = phi_775_;
                let _e569 = phi_776_;
                if _e569 {
                    phi_780_ = _e545;
                } else {
                    phi_780_ = _e567;
                }
                let _e571 = phi_780_;
                if (_e544 >= 0f) {
                    if (_e571 >= 0f) {
                        if (_e544 < f32(_e514)) {
                            let _e577 = (_e571 < f32(_e516));
                            if (_e482 == 0f) {
                                phi_801_ = (_e488 == 0f);
                            } else {
                                phi_801_ = false;
                            }
                            let _e581 = phi_801_;
                            if _e577 {
                                phi_820_ = vec2<u32>(select(select(u32(_e544), 0u, (_e544 < bitcast<f32>(0u))), 4294967295u, (_e544 > bitcast<f32>(1333788671u))), select(select(u32(_e571), 0u, (_e571 < bitcast<f32>(0u))), 4294967295u, (_e571 > bitcast<f32>(1333788671u))));
                                phi_821_ = false;
                            } else {
                                phi_820_ = vec2<u32>();
                                phi_821_ = true;
                            }
                            let _e598 = phi_820_;
                            let _e600 = phi_821_;
                            phi_822_ = _e581;
                            phi_823_ = _e577;
                            phi_824_ = _e598;
                            phi_825_ = _e581;
                            phi_826_ = _e577;
                            phi_827_ = false;
                            phi_828_ = _e600;
                        } else {
                            phi_822_ = bool();
                            phi_823_ = bool();
                            phi_824_ = vec2<u32>();
                            phi_825_ = bool();
                            phi_826_ = bool();
                            phi_827_ = true;
                            phi_828_ = false;
                        }
                        let _e602 = phi_822_;
                        let _e604 = phi_823_;
                        let _e606 = phi_824_;
                        let _e608 = phi_825_;
                        let _e610 = phi_826_;
                        let _e612 = phi_827_;
                        let _e614 = phi_828_;
                        phi_829_ = _e602;
                        phi_830_ = _e604;
                        phi_831_ = _e606;
                        phi_832_ = _e608;
                        phi_833_ = _e610;
                        phi_834_ = _e612;
                        phi_835_ = _e614;
                    } else {
                        phi_829_ = bool();
                        phi_830_ = bool();
                        phi_831_ = vec2<u32>();
                        phi_832_ = bool();
                        phi_833_ = bool();
                        phi_834_ = true;
                        phi_835_ = false;
                    }
                    let _e616 = phi_829_;
                    let _e618 = phi_830_;
                    let _e620 = phi_831_;
                    let _e622 = phi_832_;
                    let _e624 = phi_833_;
                    let _e626 = phi_834_;
                    let _e628 = phi_835_;
                    phi_836_ = _e616;
                    phi_837_ = _e618;
                    phi_838_ = _e620;
                    phi_839_ = _e622;
                    phi_840_ = _e624;
                    phi_841_ = _e626;
                    phi_842_ = _e628;
                } else {
                    phi_836_ = bool();
                    phi_837_ = bool();
                    phi_838_ = vec2<u32>();
                    phi_839_ = bool();
                    phi_840_ = bool();
                    phi_841_ = true;
                    phi_842_ = false;
                }
                let _e630 = phi_836_;
                let _e632 = phi_837_;
                let _e634 = phi_838_;
                let _e636 = phi_839_;
                let _e638 = phi_840_;
                let _e640 = phi_841_;
                let _e642 = phi_842_;
                if _e640 {
                    if (_e482 == 0f) {
                        phi_851_ = (_e488 == 0f);
                    } else {
                        phi_851_ = false;
                    }
                    let _e646 = phi_851_;
                    phi_852_ = _e646;
                    phi_853_ = false;
                    phi_854_ = true;
                } else {
                    phi_852_ = _e636;
                    phi_853_ = _e638;
                    phi_854_ = _e642;
                }
                let _e648 = phi_852_;
                let _e650 = phi_853_;
                let _e652 = phi_854_;
                if _e652 {
                    phi_858_ = _e648;
                    phi_859_ = _e650;
                    phi_860_ = vec2<u32>(_e61.x, _e61.y);
                } else {
                    phi_858_ = _e630;
                    phi_859_ = _e632;
                    phi_860_ = _e634;
                }
                let _e654 = phi_858_;
                let _e656 = phi_859_;
                let _e658 = phi_860_;
                let _e668 = lt_mask_Reprojection(vec2<u32>(_e658.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
                let _e675 = lt_mask_Reprojection(vec2<u32>(_e668.pixel.x, _e658.y), _e668.is_valid, _e668.has_moved);
                let _e679 = lt_mask_Reprojection(_e675.pixel, _e656, _e675.has_moved);
                let _e683 = lt_mask_Reprojection(_e679.pixel, _e679.is_valid, !(_e654));
                if _e656 {
                    let _e686 = p.member.previous.eye;
                    let _e694 = p.member.previous.forward;
                    let _e703 = (((((_e116.x - _e686.x) * _e694.x) + ((_e116.y - _e686.y) * _e694.y)) + ((_e116.z - _e686.z) * _e694.z)) > 0f);
                    let _e707 = lt_mask_Reprojection(_e683.pixel, _e703, _e683.has_moved);
                    if _e703 {
                        phi_895_ = false;
                    } else {
                        phi_895_ = true;
                    }
                    let _e709 = phi_895_;
                    phi_897_ = _e707;
                    phi_898_ = _e707;
                    phi_899_ = lt_mask_Reprojection();
                    phi_900_ = _e703;
                    phi_901_ = _e709;
                } else {
                    phi_897_ = lt_mask_Reprojection();
                    phi_898_ = lt_mask_Reprojection();
                    phi_899_ = lt_mask_Reprojection(_e683.pixel, false, _e683.has_moved);
                    phi_900_ = false;
                    phi_901_ = false;
                }
                let _e715 = phi_897_;
                let _e717 = phi_898_;
                let _e719 = phi_899_;
                let _e721 = phi_900_;
                let _e723 = phi_901_;
                phi_902_ = _e715;
                phi_903_ = _e717;
                phi_904_ = _e719;
                phi_905_ = _e721;
                phi_906_ = _e723;
            }
            let _e725 = phi_902_;
            let _e727 = phi_903_;
            let _e729 = phi_904_;
            let _e731 = phi_905_;
            let _e733 = phi_906_;
            if _e731 {
                let _e736 = p.member.previous.eye;
                let _e744 = p.member.previous.forward;
                let _e752 = ((((_e116.x - _e736.x) * _e744.x) + ((_e116.y - _e736.y) * _e744.y)) + ((_e116.z - _e736.z) * _e744.z));
                let _e758 = ((_e725.pixel.y * _e113) + _e725.pixel.x);
                if (_e758 < arrayLength((&last_depths.member))) {
                } else {
                    return;
                }
                let _e762 = last_depths.member[(0u + _e758)];
                let _e764 = p.member.depth_tolerance;
                let _e767 = abs(_e752);
                let _e768 = abs(_e762);
                if ((bitcast<u32>(_e768) & 2147483647u) > 2139095040u) {
                    phi_958_ = true;
                } else {
                    let _e772 = (_e768 > _e767);
                    if _e772 {
                    }
                    phi_958_ = _e772;
                }
                let _e774 = phi_958_;
                if _e774 {
                    phi_962_ = _e768;
                } else {
                    phi_962_ = _e767;
                }
                let _e776 = phi_962_;
                phi_966_ = lt_mask_Reprojection(_e725.pixel, (abs((_e752 - _e762)) <= (_e764 * _e776)), _e725.has_moved);
                phi_967_ = true;
            } else {
                phi_966_ = _e727;
                phi_967_ = _e733;
            }
            let _e784 = phi_966_;
            let _e786 = phi_967_;
            if _e786 {
                if _e784.is_valid {
                    let _e789 = p.member.flags;
                    phi_979_ = ((_e789 & 1u) != 0u);
                    phi_980_ = false;
                } else {
                    phi_979_ = bool();
                    phi_980_ = true;
                }
                let _e793 = phi_979_;
                let _e795 = phi_980_;
                phi_981_ = _e793;
                phi_982_ = _e784;
                phi_983_ = _e795;
            } else {
                phi_981_ = bool();
                phi_982_ = _e729;
                phi_983_ = true;
            }
            let _e797 = phi_981_;
            let _e799 = phi_982_;
            let _e801 = phi_983_;
            if _e801 {
                phi_987_ = false;
                phi_988_ = _e799;
            } else {
                phi_987_ = _e797;
                phi_988_ = _e784;
            }
            let _e803 = phi_987_;
            let _e805 = phi_988_;
            let _e809 = lt_mask_Reprojection(_e805.pixel, _e803, _e805.has_moved);
            let _e811 = p.member.flags;
            let _e813 = ((_e811 & 2u) != 0u);
            let _e815 = p.member.flags;
            if ((_e815 & 4u) == 0u) {
                phi_1064_ = u32();
                phi_1065_ = true;
                phi_1066_ = false;
            } else {
                if _e803 {
                    if !(_e809.has_moved) {
                        let _e826 = ((((_e61.y * _e113) + _e61.x) * _e109.words) + _e109.light.word);
                        if (_e109.light.shift > 29u) {
                            let _e830 = (_e826 + 1u);
                            if (_e830 < _e67) {
                            } else {
                                return;
                            }
                            let _e834 = last_bits.member[(0u + _e830)];
                            phi_1031_ = _e834;
                        } else {
                            phi_1031_ = 0u;
                        }
                        let _e836 = phi_1031_;
                        if (_e826 < _e67) {
                        } else {
                            return;
                        }
                        let _e842 = last_bits.member[(0u + _e826)];
                        let _e845 = (_e842 >> bitcast<u32>((_e109.light.shift & 31u)));
                        if (_e109.light.shift > 29u) {
                            phi_1050_ = (_e845 | (_e836 << bitcast<u32>(((32u - _e109.light.shift) & 31u))));
                        } else {
                            phi_1050_ = _e845;
                        }
                        let _e853 = phi_1050_;
                        if ((_e853 & 2u) == 0u) {
                            phi_1058_ = (_e853 & 1u);
                        } else {
                            phi_1058_ = (_e853 & 7u);
                        }
                        let _e859 = phi_1058_;
                        phi_1059_ = _e859;
                        phi_1060_ = false;
                    } else {
                        phi_1059_ = u32();
                        phi_1060_ = true;
                    }
                    let _e861 = phi_1059_;
                    let _e863 = phi_1060_;
                    phi_1061_ = _e861;
                    phi_1062_ = false;
                    phi_1063_ = _e863;
                } else {
                    phi_1061_ = u32();
                    phi_1062_ = true;
                    phi_1063_ = false;
                }
                let _e865 = phi_1061_;
                let _e867 = phi_1062_;
                let _e869 = phi_1063_;
                phi_1064_ = _e865;
                phi_1065_ = _e867;
                phi_1066_ = _e869;
            }
            let _e871 = phi_1064_;
            let _e873 = phi_1065_;
            let _e875 = phi_1066_;
            if _e873 {
                phi_1070_ = true;
            } else {
                phi_1070_ = _e875;
            }
            let _e877 = phi_1070_;
            if _e877 {
                phi_1074_ = 0u;
            } else {
                phi_1074_ = _e871;
            }
            let _e879 = phi_1074_;
            let _e880 = lt_mask_Neighbourhood(false, true);
            if _e283 {
                phi_1079_ = _e813;
            } else {
                phi_1079_ = false;
            }
            let _e882 = phi_1079_;
            if _e882 {
                if _e803 {
                    if ((_e879 & 2u) != 0u) {
                        phi_1374_ = _e880;
                    } else {
                        let _e886 = p.member.expansion;
                        if _e809.has_moved {
                            let _e889 = p.member.moving_pattern;
                            phi_1101_ = _e889;
                        } else {
                            let _e891 = p.member.still_pattern;
                            phi_1101_ = _e891;
                        }
                        let _e893 = phi_1101_;
                        phi_1103_ = 0u;
                        phi_1106_ = _e880;
                        loop {
                            let _e895 = phi_1103_;
                            let _e897 = phi_1106_;
                            local_1 = _e897;
                            if (1u <= _e893) {
                                if (_e893 <= 4u) {
                                    phi_1118_ = false;
                                } else {
                                    phi_1118_ = true;
                                }
                                let _e901 = phi_1118_;
                                phi_1119_ = _e901;
                            } else {
                                phi_1119_ = true;
                            }
                            let _e903 = phi_1119_;
                            if _e903 {
                                switch bitcast<i32>(_e893) {
                                    case 5: {
                                        phi_1128_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_1128_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_1128_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_1128_ = 9u;
                                        break;
                                    }
                                }
                                let _e906 = phi_1128_;
                                phi_1129_ = _e906;
                            } else {
                                phi_1129_ = 5u;
                            }
                            let _e908 = phi_1129_;
                            let _e909 = (_e895 < _e908);
                            if _e909 {
                                let _e915 = p.member.frame;
                                let _e919 = p.member.current.size[0u];
                                let _e921 = p.member.current.size[1u];
                                switch bitcast<i32>(_e893) {
                                    case 1: {
                                        let _e931 = lt_mask_pattern_plus(_e895);
                                        phi_1209_ = vec2<i32>(_e931.x, _e931.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e935 = lt_mask_pattern_cross(_e895);
                                        phi_1209_ = vec2<i32>(_e935.x, _e935.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e941 = lt_mask_pattern_plus_or_cross(_e895, ((_e809.pixel.x + _e809.pixel.y) & 1u));
                                        phi_1209_ = vec2<i32>(_e941.x, _e941.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e946 = lt_mask_pattern_plus_or_cross(_e895, (_e915 & 1u));
                                        phi_1209_ = vec2<i32>(_e946.x, _e946.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e915 & 3u)) {
                                            case 0: {
                                                phi_1189_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_1189_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_1189_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_1189_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e957 = phi_1189_;
                                        phi_1209_ = (_e957 + vec2<i32>(bitcast<i32>((_e895 & 1u)), bitcast<i32>(((_e895 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_1209_ = vec2<i32>((bitcast<i32>((_e895 % 5u)) - 2i), (bitcast<i32>(((_e895 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e974 = lt_mask_pattern_diamond(_e895);
                                        phi_1209_ = vec2<i32>(_e974.x, _e974.y);
                                        break;
                                    }
                                    default: {
                                        phi_1209_ = vec2<i32>((bitcast<i32>((_e895 % 3u)) - 1i), (bitcast<i32>(((_e895 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e979 = phi_1209_;
                                let _e982 = lt_mask_pattern_step_clamped(_e809.pixel.x, _e979.x, _e919);
                                let _e983 = lt_mask_pattern_step_clamped(_e809.pixel.y, _e979.y, _e921);
                                let _e990 = ((((_e983 * _e113) + _e982) * _e109.words) + _e109.light.word);
                                if (_e109.light.shift > 29u) {
                                    let _e994 = (_e990 + 1u);
                                    if (_e994 < _e67) {
                                    } else {
                                        return;
                                    }
                                    let _e998 = last_bits.member[(0u + _e994)];
                                    phi_1236_ = _e998;
                                } else {
                                    phi_1236_ = 0u;
                                }
                                let _e1000 = phi_1236_;
                                if (_e990 < _e67) {
                                } else {
                                    return;
                                }
                                let _e1006 = last_bits.member[(0u + _e990)];
                                let _e1009 = (_e1006 >> bitcast<u32>((_e109.light.shift & 31u)));
                                if (_e109.light.shift > 29u) {
                                    phi_1255_ = (_e1009 | (_e1000 << bitcast<u32>(((32u - _e109.light.shift) & 31u))));
                                } else {
                                    phi_1255_ = _e1009;
                                }
                                let _e1017 = phi_1255_;
                                if ((_e1017 & 2u) == 0u) {
                                    phi_1263_ = (_e1017 & 1u);
                                } else {
                                    phi_1263_ = (_e1017 & 7u);
                                }
                                let _e1023 = phi_1263_;
                                if _e897.any_expands {
                                    phi_1351_ = true;
                                } else {
                                    if ((_e1023 & 2u) != 0u) {
                                        let _e1030 = (((_e1023 & 4u) != 0u) != _e279);
                                        switch bitcast<i32>(_e886) {
                                            case 1: {
                                                phi_1291_ = bool();
                                                phi_1292_ = false;
                                                phi_1293_ = true;
                                                phi_1294_ = false;
                                                phi_1295_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e1030 {
                                                    phi_1289_ = (((_e1023 & 4u) != 0u) != ((_e1023 & 1u) != 0u));
                                                    phi_1290_ = false;
                                                } else {
                                                    phi_1289_ = bool();
                                                    phi_1290_ = true;
                                                }
                                                let _e1038 = phi_1289_;
                                                let _e1040 = phi_1290_;
                                                phi_1291_ = _e1038;
                                                phi_1292_ = false;
                                                phi_1293_ = false;
                                                phi_1294_ = _e1040;
                                                phi_1295_ = _e1030;
                                                break;
                                            }
                                            default: {
                                                phi_1291_ = bool();
                                                phi_1292_ = true;
                                                phi_1293_ = false;
                                                phi_1294_ = false;
                                                phi_1295_ = false;
                                                break;
                                            }
                                        }
                                        let _e1042 = phi_1291_;
                                        let _e1044 = phi_1292_;
                                        let _e1046 = phi_1293_;
                                        let _e1048 = phi_1294_;
                                        let _e1050 = phi_1295_;
                                        phi_1303_ = _e1030;
                                        phi_1304_ = _e1042;
                                        phi_1305_ = _e1044;
                                        phi_1306_ = _e1046;
                                        phi_1307_ = _e1048;
                                        phi_1308_ = _e1050;
                                    } else {
                                        switch bitcast<i32>(_e886) {
                                            case 1: {
                                                phi_1300_ = false;
                                                phi_1301_ = true;
                                                phi_1302_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_1300_ = false;
                                                phi_1301_ = false;
                                                phi_1302_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_1300_ = true;
                                                phi_1301_ = false;
                                                phi_1302_ = false;
                                                break;
                                            }
                                        }
                                        let _e1053 = phi_1300_;
                                        let _e1055 = phi_1301_;
                                        let _e1057 = phi_1302_;
                                        phi_1303_ = false;
                                        phi_1304_ = bool();
                                        phi_1305_ = _e1053;
                                        phi_1306_ = _e1055;
                                        phi_1307_ = _e1057;
                                        phi_1308_ = false;
                                    }
                                    let _e1059 = phi_1303_;
                                    let _e1061 = phi_1304_;
                                    let _e1063 = phi_1305_;
                                    let _e1065 = phi_1306_;
                                    let _e1067 = phi_1307_;
                                    let _e1069 = phi_1308_;
                                    if _e1063 {
                                        if ((_e1023 & 2u) != 0u) {
                                            if (((_e1023 & 4u) != 0u) != _e279) {
                                                phi_1323_ = false;
                                            } else {
                                                phi_1323_ = true;
                                            }
                                            let _e1076 = phi_1323_;
                                            phi_1324_ = _e1076;
                                        } else {
                                            phi_1324_ = true;
                                        }
                                        let _e1078 = phi_1324_;
                                        if _e1078 {
                                            phi_1331_ = (((_e1023 & 1u) != 0u) != _e279);
                                        } else {
                                            phi_1331_ = true;
                                        }
                                        let _e1083 = phi_1331_;
                                        phi_1332_ = _e1083;
                                        phi_1333_ = false;
                                        phi_1334_ = false;
                                        phi_1335_ = false;
                                    } else {
                                        phi_1332_ = bool();
                                        phi_1333_ = _e1065;
                                        phi_1334_ = _e1067;
                                        phi_1335_ = _e1069;
                                    }
                                    let _e1085 = phi_1332_;
                                    let _e1087 = phi_1333_;
                                    let _e1089 = phi_1334_;
                                    let _e1091 = phi_1335_;
                                    if _e1087 {
                                        phi_1339_ = _e1059;
                                        phi_1340_ = false;
                                        phi_1341_ = false;
                                    } else {
                                        phi_1339_ = _e1085;
                                        phi_1340_ = _e1089;
                                        phi_1341_ = _e1091;
                                    }
                                    let _e1093 = phi_1339_;
                                    let _e1095 = phi_1340_;
                                    let _e1097 = phi_1341_;
                                    if _e1095 {
                                        phi_1345_ = false;
                                        phi_1346_ = true;
                                    } else {
                                        phi_1345_ = _e1061;
                                        phi_1346_ = _e1097;
                                    }
                                    let _e1099 = phi_1345_;
                                    let _e1101 = phi_1346_;
                                    if _e1101 {
                                        phi_1350_ = _e1099;
                                    } else {
                                        phi_1350_ = _e1093;
                                    }
                                    let _e1103 = phi_1350_;
                                    phi_1351_ = _e1103;
                                }
                                let _e1105 = phi_1351_;
                                if _e897.all_remove {
                                    if (((_e1023 & 1u) != 0u) == _e279) {
                                        if ((_e1023 & 2u) != 0u) {
                                            phi_1369_ = (((_e1023 & 4u) != 0u) == _e279);
                                        } else {
                                            phi_1369_ = true;
                                        }
                                        let _e1115 = phi_1369_;
                                        phi_1370_ = _e1115;
                                    } else {
                                        phi_1370_ = false;
                                    }
                                    let _e1117 = phi_1370_;
                                    phi_1371_ = _e1117;
                                } else {
                                    phi_1371_ = false;
                                }
                                let _e1119 = phi_1371_;
                                phi_1104_ = (_e895 + 1u);
                                phi_1107_ = lt_mask_Neighbourhood(_e1105, _e1119);
                            } else {
                                phi_1104_ = u32();
                                phi_1107_ = lt_mask_Neighbourhood();
                            }
                            let _e1123 = phi_1104_;
                            let _e1125 = phi_1107_;
                            continue;
                            continuing {
                                phi_1103_ = _e1123;
                                phi_1106_ = _e1125;
                                break if !(_e909);
                            }
                        }
                        let _e1501 = local_1;
                        phi_1374_ = _e1501;
                    }
                    let _e1128 = phi_1374_;
                    phi_1375_ = _e1128;
                } else {
                    phi_1375_ = _e880;
                }
                let _e1130 = phi_1375_;
                phi_1376_ = _e1130;
            } else {
                phi_1376_ = _e880;
            }
            let _e1132 = phi_1376_;
            let _e1135 = p.member.frame;
            let _e1137 = p.member.refresh;
            if (_e1137 == 0u) {
                phi_1409_ = false;
            } else {
                if (_e1137 == 0u) {
                    return;
                }
                let _e1146 = ((_e61.x + (_e61.y * (((_e1137 * 5u) / 8u) | 1u))) + (_e1135 % _e1137));
                if (_e1137 == 0u) {
                    phi_1408_ = (_e1146 == 0u);
                } else {
                    if (_e1137 == 0u) {
                        return;
                    }
                    phi_1408_ = ((_e1146 % _e1137) == 0u);
                }
                let _e1153 = phi_1408_;
                phi_1409_ = _e1153;
            }
            let _e1155 = phi_1409_;
            if _e803 {
                if _e1155 {
                    phi_1431_ = bool();
                } else {
                    phi_1431_ = ((_e879 & 2u) != 0u);
                }
                let _e1161 = phi_1431_;
                phi_1432_ = _e1161;
                phi_1433_ = _e1155;
            } else {
                phi_1432_ = bool();
                phi_1433_ = true;
            }
            let _e1163 = phi_1432_;
            let _e1165 = phi_1433_;
            if _e1165 {
                phi_1437_ = false;
            } else {
                phi_1437_ = _e1163;
            }
            let _e1167 = phi_1437_;
            if _e1167 {
                phi_1488_ = 7u;
            } else {
                if (_e121 != 0.5f) {
                    if _e803 {
                        if _e1155 {
                            phi_1485_ = 6u;
                        } else {
                            if _e283 {
                                phi_1460_ = true;
                            } else {
                                if _e1132.any_expands {
                                    phi_1459_ = false;
                                } else {
                                    phi_1459_ = true;
                                }
                                let _e1169 = phi_1459_;
                                phi_1460_ = _e1169;
                            }
                            let _e1171 = phi_1460_;
                            if _e1171 {
                                if _e283 {
                                    if _e813 {
                                        if _e1132.all_remove {
                                            phi_1473_ = false;
                                        } else {
                                            phi_1473_ = true;
                                        }
                                        let _e1173 = phi_1473_;
                                        phi_1474_ = _e1173;
                                    } else {
                                        phi_1474_ = true;
                                    }
                                    let _e1175 = phi_1474_;
                                    phi_1475_ = _e1175;
                                } else {
                                    phi_1475_ = true;
                                }
                                let _e1177 = phi_1475_;
                                if _e1177 {
                                    if _e283 {
                                        phi_1482_ = 1u;
                                    } else {
                                        phi_1482_ = 0u;
                                    }
                                    let _e1179 = phi_1482_;
                                    phi_1483_ = _e1179;
                                } else {
                                    phi_1483_ = 5u;
                                }
                                let _e1181 = phi_1483_;
                                phi_1484_ = _e1181;
                            } else {
                                phi_1484_ = 4u;
                            }
                            let _e1183 = phi_1484_;
                            phi_1485_ = _e1183;
                        }
                        let _e1185 = phi_1485_;
                        phi_1486_ = _e1185;
                    } else {
                        phi_1486_ = 3u;
                    }
                    let _e1187 = phi_1486_;
                    phi_1487_ = _e1187;
                } else {
                    phi_1487_ = 2u;
                }
                let _e1189 = phi_1487_;
                phi_1488_ = _e1189;
            }
            let _e1191 = phi_1488_;
            if !((_e1191 == 0u)) {
                if !((_e1191 == 5u)) {
                    phi_1500_ = !(_e1167);
                    phi_1501_ = false;
                } else {
                    phi_1500_ = bool();
                    phi_1501_ = true;
                }
                let _e1198 = phi_1500_;
                let _e1200 = phi_1501_;
                phi_1502_ = _e1198;
                phi_1503_ = _e1200;
            } else {
                phi_1502_ = bool();
                phi_1503_ = true;
            }
            let _e1202 = phi_1502_;
            let _e1204 = phi_1503_;
            if _e1204 {
                phi_1507_ = false;
            } else {
                phi_1507_ = _e1202;
            }
            let _e1206 = phi_1507_;
            if _e1167 {
                phi_1513_ = ((_e879 & 4u) != 0u);
            } else {
                phi_1513_ = _e279;
            }
            let _e1210 = phi_1513_;
            if _e1206 {
                if _e279 {
                    phi_1521_ = (2u | 1u);
                } else {
                    phi_1521_ = 2u;
                }
                let _e1213 = phi_1521_;
                if false {
                    phi_1526_ = (_e1213 | 4u);
                } else {
                    phi_1526_ = _e1213;
                }
                let _e1216 = phi_1526_;
                phi_1546_ = _e1216;
            } else {
                if (_e1191 == 7u) {
                    if _e279 {
                        phi_1535_ = (2u | 1u);
                    } else {
                        phi_1535_ = 2u;
                    }
                    let _e1220 = phi_1535_;
                    if _e1210 {
                        phi_1540_ = (_e1220 | 4u);
                    } else {
                        phi_1540_ = _e1220;
                    }
                    let _e1223 = phi_1540_;
                    phi_1545_ = _e1223;
                } else {
                    if _e279 {
                        phi_1544_ = 1u;
                    } else {
                        phi_1544_ = 0u;
                    }
                    let _e1225 = phi_1544_;
                    phi_1545_ = _e1225;
                }
                let _e1227 = phi_1545_;
                phi_1546_ = _e1227;
            }
            let _e1229 = phi_1546_;
            if _e1210 {
                phi_1550_ = 0f;
            } else {
                phi_1550_ = 1f;
            }
            let _e1231 = phi_1550_;
            phi_1552_ = mask_Masked(_e1231, _e1229, _e1206);
        }
        let _e1234 = phi_1552_;
        visibility.member[_e82.shift] = _e1234.visibility;
        let _e1239 = p.member.light.number;
        let _e1240 = (_e1239 * 3u);
        let _e1242 = (_e1240 % 32u);
        let _e1244 = p.member.light.mask_words;
        let _e1246 = ((_e82.shift * _e1244) + (_e1240 / 32u));
        let _e1248 = bits.member[_e1246];
        bits.member[_e1246] = ((_e1248 & ~((7u << bitcast<u32>((_e1242 & 31u))))) | (_e1234.bits << bitcast<u32>((_e1242 & 31u))));
        if (_e1242 > 29u) {
            let _e1263 = bits.member[(_e1246 + 1u)];
            let _e1265 = (32u - _e1242);
            bits.member[(_e1246 + 1u)] = ((_e1263 & ~((7u >> bitcast<u32>((_e1265 & 31u))))) | (_e1234.bits >> bitcast<u32>((_e1265 & 31u))));
        }
        let _e1280 = samples.member[_e82.shift].normal[0u];
        let _e1282 = global[0u];
        if (_e1280 == _e1282) {
            let _e1285 = samples.member[_e82.shift].normal[1u];
            let _e1287 = global[1u];
            if (_e1285 == _e1287) {
                let _e1290 = samples.member[_e82.shift].normal[2u];
                let _e1292 = global[2u];
                phi_1624_ = (_e1290 == _e1292);
                phi_1625_ = false;
            } else {
                phi_1624_ = bool();
                phi_1625_ = true;
            }
            let _e1295 = phi_1624_;
            let _e1297 = phi_1625_;
            phi_1626_ = _e1295;
            phi_1627_ = _e1297;
        } else {
            phi_1626_ = bool();
            phi_1627_ = true;
        }
        let _e1299 = phi_1626_;
        let _e1301 = phi_1627_;
        if _e1301 {
            phi_1631_ = false;
        } else {
            phi_1631_ = _e1299;
        }
        let _e1303 = phi_1631_;
        if !(_e1303) {
            let _e1306 = samples.member[_e82.shift].position;
            let _e1308 = p.member.current.eye;
            let _e1319 = p.member.current.forward;
            phi_1659_ = ((((_e1306.x - _e1308.x) * _e1319.x) + ((_e1306.y - _e1308.y) * _e1319.y)) + ((_e1306.z - _e1308.z) * _e1319.z));
        } else {
            phi_1659_ = 0f;
        }
        let _e1329 = phi_1659_;
        depths.member[_e82.shift] = _e1329;
        phi_1662_ = _e1234.needs_ray;
        phi_1663_ = _e82.shift;
    } else {
        phi_1662_ = false;
        phi_1663_ = 0u;
    }
    let _e1333 = phi_1662_;
    let _e1335 = phi_1663_;
    if (_e62 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1333 {
        let _e1339 = atomicAdd((&shared_[0u]), 1u);
        phi_1674_ = _e1339;
    } else {
        phi_1674_ = 0u;
    }
    let _e1341 = phi_1674_;
    workgroupBarrier();
    if (_e62 == 0u) {
        let _e1345 = atomicLoad((&shared_[0u]));
        let _e1346 = atomicAdd((&list.member[3u]), _e1345);
        atomicStore((&shared_[1u]), _e1346);
    }
    workgroupBarrier();
    if _e1333 {
        let _e1349 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1349) + _e1341)]), _e1335);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_depth_rr_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
