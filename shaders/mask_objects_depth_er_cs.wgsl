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
    var phi_994_: bool;
    var phi_1016_: u32;
    var phi_1018_: u32;
    var phi_1021_: lt_mask_Neighbourhood;
    var phi_1033_: bool;
    var phi_1034_: bool;
    var phi_1043_: u32;
    var phi_1044_: u32;
    var phi_1104_: vec2<i32>;
    var phi_1124_: vec2<i32>;
    var phi_1151_: u32;
    var phi_1170_: u32;
    var phi_1178_: u32;
    var phi_1204_: bool;
    var phi_1205_: bool;
    var phi_1206_: bool;
    var phi_1207_: bool;
    var phi_1208_: bool;
    var phi_1209_: bool;
    var phi_1210_: bool;
    var phi_1215_: bool;
    var phi_1216_: bool;
    var phi_1217_: bool;
    var phi_1218_: bool;
    var phi_1219_: bool;
    var phi_1220_: bool;
    var phi_1221_: bool;
    var phi_1222_: bool;
    var phi_1223_: bool;
    var phi_1238_: bool;
    var phi_1239_: bool;
    var phi_1246_: bool;
    var phi_1247_: bool;
    var phi_1248_: bool;
    var phi_1249_: bool;
    var phi_1250_: bool;
    var phi_1254_: bool;
    var phi_1255_: bool;
    var phi_1256_: bool;
    var phi_1260_: bool;
    var phi_1261_: bool;
    var phi_1265_: bool;
    var phi_1266_: bool;
    var phi_1284_: bool;
    var phi_1285_: bool;
    var phi_1286_: bool;
    var phi_1019_: u32;
    var phi_1022_: lt_mask_Neighbourhood;
    var phi_1289_: lt_mask_Neighbourhood;
    var phi_1290_: lt_mask_Neighbourhood;
    var phi_1291_: lt_mask_Neighbourhood;
    var phi_1323_: bool;
    var phi_1324_: bool;
    var phi_1346_: bool;
    var phi_1347_: bool;
    var phi_1348_: bool;
    var phi_1352_: bool;
    var phi_1374_: bool;
    var phi_1375_: bool;
    var phi_1388_: bool;
    var phi_1389_: bool;
    var phi_1390_: bool;
    var phi_1397_: u32;
    var phi_1398_: u32;
    var phi_1399_: u32;
    var phi_1400_: u32;
    var phi_1401_: u32;
    var phi_1402_: u32;
    var phi_1403_: u32;
    var phi_1415_: bool;
    var phi_1416_: bool;
    var phi_1417_: bool;
    var phi_1418_: bool;
    var phi_1422_: bool;
    var phi_1428_: bool;
    var phi_1436_: u32;
    var phi_1441_: u32;
    var phi_1450_: u32;
    var phi_1455_: u32;
    var phi_1459_: u32;
    var phi_1460_: u32;
    var phi_1461_: u32;
    var phi_1465_: f32;
    var phi_1467_: mask_Masked;
    var phi_1539_: bool;
    var phi_1540_: bool;
    var phi_1541_: bool;
    var phi_1542_: bool;
    var phi_1546_: bool;
    var phi_1574_: f32;
    var phi_1577_: bool;
    var phi_1578_: u32;
    var phi_1589_: u32;
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
            phi_1467_ = mask_Masked(_e274.unnamed.visibility, 0u, false);
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
            let _e810 = lt_mask_Neighbourhood(false, true);
            if _e283 {
                phi_994_ = false;
            } else {
                phi_994_ = true;
            }
            let _e812 = phi_994_;
            if _e812 {
                if _e803 {
                    if ((0u & 2u) != 0u) {
                        phi_1289_ = _e810;
                    } else {
                        let _e816 = p.member.expansion;
                        if _e809.has_moved {
                            let _e819 = p.member.moving_pattern;
                            phi_1016_ = _e819;
                        } else {
                            let _e821 = p.member.still_pattern;
                            phi_1016_ = _e821;
                        }
                        let _e823 = phi_1016_;
                        phi_1018_ = 0u;
                        phi_1021_ = _e810;
                        loop {
                            let _e825 = phi_1018_;
                            let _e827 = phi_1021_;
                            local_1 = _e827;
                            if (1u <= _e823) {
                                if (_e823 <= 4u) {
                                    phi_1033_ = false;
                                } else {
                                    phi_1033_ = true;
                                }
                                let _e831 = phi_1033_;
                                phi_1034_ = _e831;
                            } else {
                                phi_1034_ = true;
                            }
                            let _e833 = phi_1034_;
                            if _e833 {
                                switch bitcast<i32>(_e823) {
                                    case 5: {
                                        phi_1043_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_1043_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_1043_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_1043_ = 9u;
                                        break;
                                    }
                                }
                                let _e836 = phi_1043_;
                                phi_1044_ = _e836;
                            } else {
                                phi_1044_ = 5u;
                            }
                            let _e838 = phi_1044_;
                            let _e839 = (_e825 < _e838);
                            if _e839 {
                                let _e845 = p.member.frame;
                                let _e849 = p.member.current.size[0u];
                                let _e851 = p.member.current.size[1u];
                                switch bitcast<i32>(_e823) {
                                    case 1: {
                                        let _e861 = lt_mask_pattern_plus(_e825);
                                        phi_1124_ = vec2<i32>(_e861.x, _e861.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e865 = lt_mask_pattern_cross(_e825);
                                        phi_1124_ = vec2<i32>(_e865.x, _e865.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e871 = lt_mask_pattern_plus_or_cross(_e825, ((_e809.pixel.x + _e809.pixel.y) & 1u));
                                        phi_1124_ = vec2<i32>(_e871.x, _e871.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e876 = lt_mask_pattern_plus_or_cross(_e825, (_e845 & 1u));
                                        phi_1124_ = vec2<i32>(_e876.x, _e876.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e845 & 3u)) {
                                            case 0: {
                                                phi_1104_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_1104_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_1104_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_1104_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e887 = phi_1104_;
                                        phi_1124_ = (_e887 + vec2<i32>(bitcast<i32>((_e825 & 1u)), bitcast<i32>(((_e825 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_1124_ = vec2<i32>((bitcast<i32>((_e825 % 5u)) - 2i), (bitcast<i32>(((_e825 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e904 = lt_mask_pattern_diamond(_e825);
                                        phi_1124_ = vec2<i32>(_e904.x, _e904.y);
                                        break;
                                    }
                                    default: {
                                        phi_1124_ = vec2<i32>((bitcast<i32>((_e825 % 3u)) - 1i), (bitcast<i32>(((_e825 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e909 = phi_1124_;
                                let _e912 = lt_mask_pattern_step_clamped(_e809.pixel.x, _e909.x, _e849);
                                let _e913 = lt_mask_pattern_step_clamped(_e809.pixel.y, _e909.y, _e851);
                                let _e920 = ((((_e913 * _e113) + _e912) * _e109.words) + _e109.light.word);
                                if (_e109.light.shift > 29u) {
                                    let _e924 = (_e920 + 1u);
                                    if (_e924 < _e67) {
                                    } else {
                                        return;
                                    }
                                    let _e928 = last_bits.member[(0u + _e924)];
                                    phi_1151_ = _e928;
                                } else {
                                    phi_1151_ = 0u;
                                }
                                let _e930 = phi_1151_;
                                if (_e920 < _e67) {
                                } else {
                                    return;
                                }
                                let _e936 = last_bits.member[(0u + _e920)];
                                let _e939 = (_e936 >> bitcast<u32>((_e109.light.shift & 31u)));
                                if (_e109.light.shift > 29u) {
                                    phi_1170_ = (_e939 | (_e930 << bitcast<u32>(((32u - _e109.light.shift) & 31u))));
                                } else {
                                    phi_1170_ = _e939;
                                }
                                let _e947 = phi_1170_;
                                if ((_e947 & 2u) == 0u) {
                                    phi_1178_ = (_e947 & 1u);
                                } else {
                                    phi_1178_ = (_e947 & 7u);
                                }
                                let _e953 = phi_1178_;
                                if _e827.any_expands {
                                    phi_1266_ = true;
                                } else {
                                    if ((_e953 & 2u) != 0u) {
                                        let _e960 = (((_e953 & 4u) != 0u) != _e279);
                                        switch bitcast<i32>(_e816) {
                                            case 1: {
                                                phi_1206_ = bool();
                                                phi_1207_ = false;
                                                phi_1208_ = true;
                                                phi_1209_ = false;
                                                phi_1210_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e960 {
                                                    phi_1204_ = (((_e953 & 4u) != 0u) != ((_e953 & 1u) != 0u));
                                                    phi_1205_ = false;
                                                } else {
                                                    phi_1204_ = bool();
                                                    phi_1205_ = true;
                                                }
                                                let _e968 = phi_1204_;
                                                let _e970 = phi_1205_;
                                                phi_1206_ = _e968;
                                                phi_1207_ = false;
                                                phi_1208_ = false;
                                                phi_1209_ = _e970;
                                                phi_1210_ = _e960;
                                                break;
                                            }
                                            default: {
                                                phi_1206_ = bool();
                                                phi_1207_ = true;
                                                phi_1208_ = false;
                                                phi_1209_ = false;
                                                phi_1210_ = false;
                                                break;
                                            }
                                        }
                                        let _e972 = phi_1206_;
                                        let _e974 = phi_1207_;
                                        let _e976 = phi_1208_;
                                        let _e978 = phi_1209_;
                                        let _e980 = phi_1210_;
                                        phi_1218_ = _e960;
                                        phi_1219_ = _e972;
                                        phi_1220_ = _e974;
                                        phi_1221_ = _e976;
                                        phi_1222_ = _e978;
                                        phi_1223_ = _e980;
                                    } else {
                                        switch bitcast<i32>(_e816) {
                                            case 1: {
                                                phi_1215_ = false;
                                                phi_1216_ = true;
                                                phi_1217_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_1215_ = false;
                                                phi_1216_ = false;
                                                phi_1217_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_1215_ = true;
                                                phi_1216_ = false;
                                                phi_1217_ = false;
                                                break;
                                            }
                                        }
                                        let _e983 = phi_1215_;
                                        let _e985 = phi_1216_;
                                        let _e987 = phi_1217_;
                                        phi_1218_ = false;
                                        phi_1219_ = bool();
                                        phi_1220_ = _e983;
                                        phi_1221_ = _e985;
                                        phi_1222_ = _e987;
                                        phi_1223_ = false;
                                    }
                                    let _e989 = phi_1218_;
                                    let _e991 = phi_1219_;
                                    let _e993 = phi_1220_;
                                    let _e995 = phi_1221_;
                                    let _e997 = phi_1222_;
                                    let _e999 = phi_1223_;
                                    if _e993 {
                                        if ((_e953 & 2u) != 0u) {
                                            if (((_e953 & 4u) != 0u) != _e279) {
                                                phi_1238_ = false;
                                            } else {
                                                phi_1238_ = true;
                                            }
                                            let _e1006 = phi_1238_;
                                            phi_1239_ = _e1006;
                                        } else {
                                            phi_1239_ = true;
                                        }
                                        let _e1008 = phi_1239_;
                                        if _e1008 {
                                            phi_1246_ = (((_e953 & 1u) != 0u) != _e279);
                                        } else {
                                            phi_1246_ = true;
                                        }
                                        let _e1013 = phi_1246_;
                                        phi_1247_ = _e1013;
                                        phi_1248_ = false;
                                        phi_1249_ = false;
                                        phi_1250_ = false;
                                    } else {
                                        phi_1247_ = bool();
                                        phi_1248_ = _e995;
                                        phi_1249_ = _e997;
                                        phi_1250_ = _e999;
                                    }
                                    let _e1015 = phi_1247_;
                                    let _e1017 = phi_1248_;
                                    let _e1019 = phi_1249_;
                                    let _e1021 = phi_1250_;
                                    if _e1017 {
                                        phi_1254_ = _e989;
                                        phi_1255_ = false;
                                        phi_1256_ = false;
                                    } else {
                                        phi_1254_ = _e1015;
                                        phi_1255_ = _e1019;
                                        phi_1256_ = _e1021;
                                    }
                                    let _e1023 = phi_1254_;
                                    let _e1025 = phi_1255_;
                                    let _e1027 = phi_1256_;
                                    if _e1025 {
                                        phi_1260_ = false;
                                        phi_1261_ = true;
                                    } else {
                                        phi_1260_ = _e991;
                                        phi_1261_ = _e1027;
                                    }
                                    let _e1029 = phi_1260_;
                                    let _e1031 = phi_1261_;
                                    if _e1031 {
                                        phi_1265_ = _e1029;
                                    } else {
                                        phi_1265_ = _e1023;
                                    }
                                    let _e1033 = phi_1265_;
                                    phi_1266_ = _e1033;
                                }
                                let _e1035 = phi_1266_;
                                if _e827.all_remove {
                                    if (((_e953 & 1u) != 0u) == _e279) {
                                        if ((_e953 & 2u) != 0u) {
                                            phi_1284_ = (((_e953 & 4u) != 0u) == _e279);
                                        } else {
                                            phi_1284_ = true;
                                        }
                                        let _e1045 = phi_1284_;
                                        phi_1285_ = _e1045;
                                    } else {
                                        phi_1285_ = false;
                                    }
                                    let _e1047 = phi_1285_;
                                    phi_1286_ = _e1047;
                                } else {
                                    phi_1286_ = false;
                                }
                                let _e1049 = phi_1286_;
                                phi_1019_ = (_e825 + 1u);
                                phi_1022_ = lt_mask_Neighbourhood(_e1035, _e1049);
                            } else {
                                phi_1019_ = u32();
                                phi_1022_ = lt_mask_Neighbourhood();
                            }
                            let _e1053 = phi_1019_;
                            let _e1055 = phi_1022_;
                            continue;
                            continuing {
                                phi_1018_ = _e1053;
                                phi_1021_ = _e1055;
                                break if !(_e839);
                            }
                        }
                        let _e1418 = local_1;
                        phi_1289_ = _e1418;
                    }
                    let _e1058 = phi_1289_;
                    phi_1290_ = _e1058;
                } else {
                    phi_1290_ = _e810;
                }
                let _e1060 = phi_1290_;
                phi_1291_ = _e1060;
            } else {
                phi_1291_ = _e810;
            }
            let _e1062 = phi_1291_;
            let _e1065 = p.member.frame;
            let _e1067 = p.member.refresh;
            if (_e1067 == 0u) {
                phi_1324_ = false;
            } else {
                if (_e1067 == 0u) {
                    return;
                }
                let _e1076 = ((_e61.x + (_e61.y * (((_e1067 * 5u) / 8u) | 1u))) + (_e1065 % _e1067));
                if (_e1067 == 0u) {
                    phi_1323_ = (_e1076 == 0u);
                } else {
                    if (_e1067 == 0u) {
                        return;
                    }
                    phi_1323_ = ((_e1076 % _e1067) == 0u);
                }
                let _e1083 = phi_1323_;
                phi_1324_ = _e1083;
            }
            let _e1085 = phi_1324_;
            if _e803 {
                if _e1085 {
                    phi_1346_ = bool();
                } else {
                    phi_1346_ = ((0u & 2u) != 0u);
                }
                let _e1091 = phi_1346_;
                phi_1347_ = _e1091;
                phi_1348_ = _e1085;
            } else {
                phi_1347_ = bool();
                phi_1348_ = true;
            }
            let _e1093 = phi_1347_;
            let _e1095 = phi_1348_;
            if _e1095 {
                phi_1352_ = false;
            } else {
                phi_1352_ = _e1093;
            }
            let _e1097 = phi_1352_;
            if _e1097 {
                phi_1403_ = 7u;
            } else {
                if (_e121 != 0.5f) {
                    if _e803 {
                        if _e1085 {
                            phi_1400_ = 6u;
                        } else {
                            if _e283 {
                                phi_1375_ = true;
                            } else {
                                if _e1062.any_expands {
                                    phi_1374_ = false;
                                } else {
                                    phi_1374_ = true;
                                }
                                let _e1099 = phi_1374_;
                                phi_1375_ = _e1099;
                            }
                            let _e1101 = phi_1375_;
                            if _e1101 {
                                if _e283 {
                                    if false {
                                        if _e1062.all_remove {
                                            phi_1388_ = false;
                                        } else {
                                            phi_1388_ = true;
                                        }
                                        let _e1103 = phi_1388_;
                                        phi_1389_ = _e1103;
                                    } else {
                                        phi_1389_ = true;
                                    }
                                    let _e1105 = phi_1389_;
                                    phi_1390_ = _e1105;
                                } else {
                                    phi_1390_ = true;
                                }
                                let _e1107 = phi_1390_;
                                if _e1107 {
                                    if _e283 {
                                        phi_1397_ = 1u;
                                    } else {
                                        phi_1397_ = 0u;
                                    }
                                    let _e1109 = phi_1397_;
                                    phi_1398_ = _e1109;
                                } else {
                                    phi_1398_ = 5u;
                                }
                                let _e1111 = phi_1398_;
                                phi_1399_ = _e1111;
                            } else {
                                phi_1399_ = 4u;
                            }
                            let _e1113 = phi_1399_;
                            phi_1400_ = _e1113;
                        }
                        let _e1115 = phi_1400_;
                        phi_1401_ = _e1115;
                    } else {
                        phi_1401_ = 3u;
                    }
                    let _e1117 = phi_1401_;
                    phi_1402_ = _e1117;
                } else {
                    phi_1402_ = 2u;
                }
                let _e1119 = phi_1402_;
                phi_1403_ = _e1119;
            }
            let _e1121 = phi_1403_;
            if !((_e1121 == 0u)) {
                if !((_e1121 == 5u)) {
                    phi_1415_ = !(_e1097);
                    phi_1416_ = false;
                } else {
                    phi_1415_ = bool();
                    phi_1416_ = true;
                }
                let _e1128 = phi_1415_;
                let _e1130 = phi_1416_;
                phi_1417_ = _e1128;
                phi_1418_ = _e1130;
            } else {
                phi_1417_ = bool();
                phi_1418_ = true;
            }
            let _e1132 = phi_1417_;
            let _e1134 = phi_1418_;
            if _e1134 {
                phi_1422_ = false;
            } else {
                phi_1422_ = _e1132;
            }
            let _e1136 = phi_1422_;
            if _e1097 {
                phi_1428_ = ((0u & 4u) != 0u);
            } else {
                phi_1428_ = _e279;
            }
            let _e1140 = phi_1428_;
            if _e1136 {
                if _e279 {
                    phi_1436_ = (2u | 1u);
                } else {
                    phi_1436_ = 2u;
                }
                let _e1143 = phi_1436_;
                if false {
                    phi_1441_ = (_e1143 | 4u);
                } else {
                    phi_1441_ = _e1143;
                }
                let _e1146 = phi_1441_;
                phi_1461_ = _e1146;
            } else {
                if (_e1121 == 7u) {
                    if _e279 {
                        phi_1450_ = (2u | 1u);
                    } else {
                        phi_1450_ = 2u;
                    }
                    let _e1150 = phi_1450_;
                    if _e1140 {
                        phi_1455_ = (_e1150 | 4u);
                    } else {
                        phi_1455_ = _e1150;
                    }
                    let _e1153 = phi_1455_;
                    phi_1460_ = _e1153;
                } else {
                    if _e279 {
                        phi_1459_ = 1u;
                    } else {
                        phi_1459_ = 0u;
                    }
                    let _e1155 = phi_1459_;
                    phi_1460_ = _e1155;
                }
                let _e1157 = phi_1460_;
                phi_1461_ = _e1157;
            }
            let _e1159 = phi_1461_;
            if _e1140 {
                phi_1465_ = 0f;
            } else {
                phi_1465_ = 1f;
            }
            let _e1161 = phi_1465_;
            phi_1467_ = mask_Masked(_e1161, _e1159, _e1136);
        }
        let _e1164 = phi_1467_;
        visibility.member[_e82.shift] = _e1164.visibility;
        let _e1169 = p.member.light.number;
        let _e1170 = (_e1169 * 3u);
        let _e1172 = (_e1170 % 32u);
        let _e1174 = p.member.light.mask_words;
        let _e1176 = ((_e82.shift * _e1174) + (_e1170 / 32u));
        let _e1178 = bits.member[_e1176];
        bits.member[_e1176] = ((_e1178 & ~((7u << bitcast<u32>((_e1172 & 31u))))) | (_e1164.bits << bitcast<u32>((_e1172 & 31u))));
        if (_e1172 > 29u) {
            let _e1193 = bits.member[(_e1176 + 1u)];
            let _e1195 = (32u - _e1172);
            bits.member[(_e1176 + 1u)] = ((_e1193 & ~((7u >> bitcast<u32>((_e1195 & 31u))))) | (_e1164.bits >> bitcast<u32>((_e1195 & 31u))));
        }
        let _e1210 = samples.member[_e82.shift].normal[0u];
        let _e1212 = global[0u];
        if (_e1210 == _e1212) {
            let _e1215 = samples.member[_e82.shift].normal[1u];
            let _e1217 = global[1u];
            if (_e1215 == _e1217) {
                let _e1220 = samples.member[_e82.shift].normal[2u];
                let _e1222 = global[2u];
                phi_1539_ = (_e1220 == _e1222);
                phi_1540_ = false;
            } else {
                phi_1539_ = bool();
                phi_1540_ = true;
            }
            let _e1225 = phi_1539_;
            let _e1227 = phi_1540_;
            phi_1541_ = _e1225;
            phi_1542_ = _e1227;
        } else {
            phi_1541_ = bool();
            phi_1542_ = true;
        }
        let _e1229 = phi_1541_;
        let _e1231 = phi_1542_;
        if _e1231 {
            phi_1546_ = false;
        } else {
            phi_1546_ = _e1229;
        }
        let _e1233 = phi_1546_;
        if !(_e1233) {
            let _e1236 = samples.member[_e82.shift].position;
            let _e1238 = p.member.current.eye;
            let _e1249 = p.member.current.forward;
            phi_1574_ = ((((_e1236.x - _e1238.x) * _e1249.x) + ((_e1236.y - _e1238.y) * _e1249.y)) + ((_e1236.z - _e1238.z) * _e1249.z));
        } else {
            phi_1574_ = 0f;
        }
        let _e1259 = phi_1574_;
        depths.member[_e82.shift] = _e1259;
        phi_1577_ = _e1164.needs_ray;
        phi_1578_ = _e82.shift;
    } else {
        phi_1577_ = false;
        phi_1578_ = 0u;
    }
    let _e1263 = phi_1577_;
    let _e1265 = phi_1578_;
    if (_e62 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1263 {
        let _e1269 = atomicAdd((&shared_[0u]), 1u);
        phi_1589_ = _e1269;
    } else {
        phi_1589_ = 0u;
    }
    let _e1271 = phi_1589_;
    workgroupBarrier();
    if (_e62 == 0u) {
        let _e1275 = atomicLoad((&shared_[0u]));
        let _e1276 = atomicAdd((&list.member[3u]), _e1275);
        atomicStore((&shared_[1u]), _e1276);
    }
    workgroupBarrier();
    if _e1263 {
        let _e1279 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1279) + _e1271)]), _e1265);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_depth_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
