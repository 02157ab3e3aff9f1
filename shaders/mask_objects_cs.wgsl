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
var<storage> past: type_44;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_177_: lt_mask_LightPlace;
    var phi_178_: bool;
    var phi_179_: lt_mask_LightPlace;
    var phi_180_: bool;
    var phi_185_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_177_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_178_ = false;
        } else {
            phi_177_ = lt_mask_LightPlace();
            phi_178_ = true;
        }
        let _e68 = phi_177_;
        let _e70 = phi_178_;
        phi_179_ = _e68;
        phi_180_ = _e70;
    } else {
        phi_179_ = lt_mask_LightPlace();
        phi_180_ = true;
    }
    let _e72 = phi_179_;
    let _e74 = phi_180_;
    if _e74 {
        phi_185_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_185_ = _e72;
    }
    let _e79 = phi_185_;
    return lt_mask_LightPlace(_e79.word, _e79.shift);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_203_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_203_ = vec2(0i);
            break;
        }
        case 1: {
            phi_203_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_203_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_203_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_203_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e64 = phi_203_;
    return vec2<i32>(_e64.x, _e64.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_221_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_221_ = vec2(0i);
            break;
        }
        case 1: {
            phi_221_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_221_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_221_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_221_ = vec2(1i);
            break;
        }
    }
    let _e64 = phi_221_;
    return vec2<i32>(_e64.x, _e64.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_240_: vec2<i32>;

    if (param_6 == 0u) {
        let _e58 = lt_mask_pattern_plus(param_5);
        phi_240_ = vec2<i32>(_e58.x, _e58.y);
    } else {
        let _e62 = lt_mask_pattern_cross(param_5);
        phi_240_ = vec2<i32>(_e62.x, _e62.y);
    }
    let _e67 = phi_240_;
    return vec2<i32>(_e67.x, _e67.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_265_: vec2<i32>;

    let _e56 = (param_7 % 13u);
    switch bitcast<i32>(_e56) {
        case 9: {
            phi_265_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_265_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_265_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_265_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_265_ = vec2<i32>((bitcast<i32>((_e56 % 3u)) - 1i), (bitcast<i32>(((_e56 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e71 = phi_265_;
    return vec2<i32>(_e71.x, _e71.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_286_: u32;
    var phi_287_: u32;

    let _e59 = (bitcast<i32>(param_8) + param_9);
    if (_e59 < 0i) {
        phi_287_ = 0u;
    } else {
        if (_e59 >= bitcast<i32>(param_10)) {
            phi_286_ = (param_10 - 1u);
        } else {
            phi_286_ = bitcast<u32>(_e59);
        }
        let _e66 = phi_286_;
        phi_287_ = _e66;
    }
    let _e68 = phi_287_;
    return _e68;
}

fn function_() {
    var phi_363_: bool;
    var phi_364_: bool;
    var phi_365_: bool;
    var phi_366_: bool;
    var phi_370_: bool;
    var phi_440_: bool;
    var phi_441_: bool;
    var phi_452_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_453_: bool;
    var phi_454_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_455_: bool;
    var phi_462_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_466_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_479_: bool;
    var phi_684_: f32;
    var phi_689_: f32;
    var phi_690_: bool;
    var phi_691_: f32;
    var phi_692_: bool;
    var phi_696_: f32;
    var phi_717_: f32;
    var phi_722_: f32;
    var phi_723_: bool;
    var phi_724_: f32;
    var phi_725_: bool;
    var phi_729_: f32;
    var phi_750_: bool;
    var phi_769_: vec2<u32>;
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
    var phi_785_: bool;
    var phi_786_: bool;
    var phi_787_: vec2<u32>;
    var phi_788_: bool;
    var phi_789_: bool;
    var phi_790_: bool;
    var phi_791_: bool;
    var phi_800_: bool;
    var phi_801_: bool;
    var phi_802_: bool;
    var phi_803_: bool;
    var phi_807_: bool;
    var phi_808_: bool;
    var phi_809_: vec2<u32>;
    var phi_848_: bool;
    var phi_849_: bool;
    var phi_851_: bool;
    var phi_852_: lt_mask_Reprojection;
    var phi_853_: lt_mask_Reprojection;
    var phi_854_: bool;
    var phi_858_: bool;
    var phi_859_: lt_mask_Reprojection;
    var phi_900_: u32;
    var phi_919_: u32;
    var phi_927_: u32;
    var phi_928_: u32;
    var phi_929_: bool;
    var phi_930_: u32;
    var phi_931_: bool;
    var phi_932_: bool;
    var phi_933_: u32;
    var phi_934_: bool;
    var phi_935_: bool;
    var phi_939_: bool;
    var phi_943_: u32;
    var phi_948_: bool;
    var phi_970_: u32;
    var phi_972_: u32;
    var phi_975_: lt_mask_Neighbourhood;
    var phi_987_: bool;
    var phi_988_: bool;
    var phi_997_: u32;
    var phi_998_: u32;
    var phi_1058_: vec2<i32>;
    var phi_1078_: vec2<i32>;
    var phi_1103_: u32;
    var phi_1122_: u32;
    var phi_1130_: u32;
    var phi_1156_: bool;
    var phi_1157_: bool;
    var phi_1158_: bool;
    var phi_1159_: bool;
    var phi_1160_: bool;
    var phi_1161_: bool;
    var phi_1162_: bool;
    var phi_1167_: bool;
    var phi_1168_: bool;
    var phi_1169_: bool;
    var phi_1170_: bool;
    var phi_1171_: bool;
    var phi_1172_: bool;
    var phi_1173_: bool;
    var phi_1174_: bool;
    var phi_1175_: bool;
    var phi_1190_: bool;
    var phi_1191_: bool;
    var phi_1198_: bool;
    var phi_1199_: bool;
    var phi_1200_: bool;
    var phi_1201_: bool;
    var phi_1202_: bool;
    var phi_1206_: bool;
    var phi_1207_: bool;
    var phi_1208_: bool;
    var phi_1212_: bool;
    var phi_1213_: bool;
    var phi_1217_: bool;
    var phi_1218_: bool;
    var phi_1236_: bool;
    var phi_1237_: bool;
    var phi_1238_: bool;
    var phi_973_: u32;
    var phi_976_: lt_mask_Neighbourhood;
    var phi_1241_: lt_mask_Neighbourhood;
    var phi_1242_: lt_mask_Neighbourhood;
    var phi_1243_: lt_mask_Neighbourhood;
    var phi_1275_: bool;
    var phi_1276_: bool;
    var phi_1298_: bool;
    var phi_1299_: bool;
    var phi_1300_: bool;
    var phi_1304_: bool;
    var phi_1326_: bool;
    var phi_1327_: bool;
    var phi_1340_: bool;
    var phi_1341_: bool;
    var phi_1342_: bool;
    var phi_1349_: u32;
    var phi_1350_: u32;
    var phi_1351_: u32;
    var phi_1352_: u32;
    var phi_1353_: u32;
    var phi_1354_: u32;
    var phi_1355_: u32;
    var phi_1367_: bool;
    var phi_1368_: bool;
    var phi_1369_: bool;
    var phi_1370_: bool;
    var phi_1374_: bool;
    var phi_1380_: bool;
    var phi_1388_: u32;
    var phi_1393_: u32;
    var phi_1402_: u32;
    var phi_1407_: u32;
    var phi_1411_: u32;
    var phi_1412_: u32;
    var phi_1413_: u32;
    var phi_1417_: f32;
    var phi_1419_: mask_Masked;
    var phi_1469_: bool;
    var phi_1470_: u32;
    var phi_1481_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e55 = id_1;
    let _e56 = local_2;
    let _e61 = arrayLength((&last_bits.member));
    let _e69 = p.member.current.size[0u];
    let _e71 = p.member.current.size[1u];
    let _e72 = lt_shaders_entry_pixel_index(_e55, _e69, _e71);
    if (bitcast<i32>(_e72.word) != 0i) {
        let _e79 = p.member.light.number;
        let _e80 = (_e79 * 3u);
        let _e81 = (_e80 / 32u);
        let _e82 = (_e80 % 32u);
        let _e84 = p.member.light.mask_words;
        let _e88 = p.member.current.size[0u];
        let _e91 = past.member[_e72.shift];
        let _e96 = visibility.member[_e72.shift];
        let _e102 = samples.member[_e72.shift].normal[0u];
        let _e104 = global[0u];
        if (_e102 == _e104) {
            let _e107 = samples.member[_e72.shift].normal[1u];
            let _e109 = global[1u];
            if (_e107 == _e109) {
                let _e112 = samples.member[_e72.shift].normal[2u];
                let _e114 = global[2u];
                phi_363_ = (_e112 == _e114);
                phi_364_ = false;
            } else {
                phi_363_ = bool();
                phi_364_ = true;
            }
            let _e117 = phi_363_;
            let _e119 = phi_364_;
            phi_365_ = _e117;
            phi_366_ = _e119;
        } else {
            phi_365_ = bool();
            phi_366_ = true;
        }
        let _e121 = phi_365_;
        let _e123 = phi_366_;
        if _e123 {
            phi_370_ = false;
        } else {
            phi_370_ = _e121;
        }
        let _e125 = phi_370_;
        if !(_e125) {
            let _e128 = samples.member[_e72.shift].position;
            let _e130 = p.member.light.place;
            let _e136 = p.member.light.place[3u];
            let _e143 = (_e130.x - (_e128.x * _e136));
            let _e144 = (_e130.y - (_e128.y * _e136));
            let _e145 = (_e130.z - (_e128.z * _e136));
            let _e147 = samples.member[_e72.shift].normal;
            if ((((_e147.x * _e143) + (_e147.y * _e144)) + (_e147.z * _e145)) > 0f) {
                let _e161 = (((_e143 * _e143) + (_e144 * _e144)) + (_e145 * _e145));
                let _e163 = p.member.light.axis;
                let _e175 = p.member.light.place[3u];
                if (_e175 == 0f) {
                    phi_441_ = true;
                } else {
                    let _e178 = p.member.light.range_squared;
                    if (_e161 <= _e178) {
                        let _e181 = p.member.light.cos_outer;
                        phi_440_ = (-((((_e143 * _e163.x) + (_e144 * _e163.y)) + (_e145 * _e163.z))) >= (_e181 * sqrt(_e161)));
                    } else {
                        phi_440_ = false;
                    }
                    let _e186 = phi_440_;
                    phi_441_ = _e186;
                }
                let _e188 = phi_441_;
                if _e188 {
                    let _e190 = samples.member[_e72.shift].flags;
                    let _e198 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e204 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e198.unnamed.visibility, false), _e198.unnamed_1);
                    phi_452_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e204.unnamed, ((_e190 & 1u) == 0u));
                    phi_453_ = false;
                } else {
                    phi_452_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_453_ = true;
                }
                let _e209 = phi_452_;
                let _e211 = phi_453_;
                phi_454_ = _e209;
                phi_455_ = _e211;
            } else {
                phi_454_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_455_ = true;
            }
            let _e213 = phi_454_;
            let _e215 = phi_455_;
            if _e215 {
                let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e227 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e221.unnamed.visibility, false), _e221.unnamed_1);
                phi_462_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e227.unnamed, true);
            } else {
                phi_462_ = _e213;
            }
            let _e232 = phi_462_;
            phi_466_ = _e232;
        } else {
            let _e238 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e244 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e238.unnamed.visibility, false), _e238.unnamed_1);
            phi_466_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e244.unnamed, true);
        }
        let _e249 = phi_466_;
        if _e249.unnamed_1 {
            phi_1419_ = mask_Masked(_e249.unnamed.visibility, 0u, false);
        } else {
            let _e254 = (_e96 < 0.5f);
            if (_e96 > 0f) {
                phi_479_ = (_e96 < 1f);
            } else {
                phi_479_ = false;
            }
            let _e258 = phi_479_;
            let _e260 = samples.member[_e72.shift].position;
            let _e264 = p.member.previous.eye;
            let _e266 = (_e91.x - _e264.x);
            let _e268 = (_e91.y - _e264.y);
            let _e270 = (_e91.z - _e264.z);
            let _e272 = p.member.previous.forward;
            let _e280 = (((_e266 * _e272.x) + (_e268 * _e272.y)) + (_e270 * _e272.z));
            let _e282 = p.member.previous.right;
            let _e292 = p.member.previous.right;
            let _e307 = p.member.previous.up;
            let _e317 = p.member.previous.up;
            let _e332 = p.member.current.eye;
            let _e335 = (_e260.x - _e332.x);
            let _e338 = (_e260.y - _e332.y);
            let _e341 = (_e260.z - _e332.z);
            let _e343 = p.member.current.forward;
            let _e351 = (((_e335 * _e343.x) + (_e338 * _e343.y)) + (_e341 * _e343.z));
            let _e353 = p.member.current.right;
            let _e363 = p.member.current.right;
            let _e378 = p.member.current.up;
            let _e388 = p.member.current.up;
            let _e407 = p.member.current.size[0u];
            let _e409 = (((((((_e266 * _e282.x) + (_e268 * _e282.y)) + (_e270 * _e282.z)) / ((((_e292.x * _e292.x) + (_e292.y * _e292.y)) + (_e292.z * _e292.z)) * _e280)) - ((((_e335 * _e353.x) + (_e338 * _e353.y)) + (_e341 * _e353.z)) / ((((_e363.x * _e363.x) + (_e363.y * _e363.y)) + (_e363.z * _e363.z)) * _e351))) * 0.5f) * f32(_e407));
            let _e413 = p.member.current.size[1u];
            let _e415 = (((((((_e266 * _e307.x) + (_e268 * _e307.y)) + (_e270 * _e307.z)) / ((((_e317.x * _e317.x) + (_e317.y * _e317.y)) + (_e317.z * _e317.z)) * _e280)) - ((((_e335 * _e378.x) + (_e338 * _e378.y)) + (_e341 * _e378.z)) / ((((_e388.x * _e388.x) + (_e388.y * _e388.y)) + (_e388.z * _e388.z)) * _e351))) * -0.5f) * f32(_e413));
            let _e419 = p.member.current.grid[0u];
            let _e421 = p.member.current.grid[1u];
            let _e441 = p.member.current.size[0u];
            let _e443 = p.member.current.size[1u];
            let _e445 = ((f32(_e55.x) + ((f32((_e55.y & (_e421 - 1u))) + 0.5f) / f32(_e421))) + _e409);
            if (_e445 > -8388608f) {
                let _e457 = f32(select(0i, select(select(i32(_e445), i32(-2147483648), (_e445 < bitcast<f32>(3472883712u))), 2147483647i, (_e445 > bitcast<f32>(1325400063u))), (_e445 == _e445)));
                if (_e457 > _e445) {
                    phi_684_ = 1f;
                } else {
                    phi_684_ = 0f;
                }
                let _e460 = phi_684_;
                if (_e445 < 8388608f) {
                    phi_689_ = (_e457 - _e460);
                    phi_690_ = false;
                } else {
                    phi_689_ = f32();
                    phi_690_ = true;
                }
                let _e463 = phi_689_;
                let _e465 = phi_690_;
                phi_691_ = _e463;
                phi_692_ = _e465;
            } else {
                phi_691_ = f32();
                phi_692_ = true;
            }
            let _e467 = phi_691_;
            let _e469 = phi_692_;
            if _e469 {
                phi_696_ = _e445;
            } else {
                phi_696_ = _e467;
            }
            let _e471 = phi_696_;
            let _e472 = ((f32(_e55.y) + ((f32((_e55.x & (_e419 - 1u))) + 0.5f) / f32(_e419))) + _e415);
            if (_e472 > -8388608f) {
                let _e484 = f32(select(0i, select(select(i32(_e472), i32(-2147483648), (_e472 < bitcast<f32>(3472883712u))), 2147483647i, (_e472 > bitcast<f32>(1325400063u))), (_e472 == _e472)));
                if (_e484 > _e472) {
                    phi_717_ = 1f;
                } else {
                    phi_717_ = 0f;
                }
                let _e487 = phi_717_;
                if (_e472 < 8388608f) {
                    phi_722_ = (_e484 - _e487);
                    phi_723_ = false;
                } else {
                    phi_722_ = f32();
                    phi_723_ = true;
                }
                let _e490 = phi_722_;
                let _e492 = phi_723_;
                phi_724_ = _e490;
                phi_725_ = _e492;
            } else {
                phi_724_ = f32();
                phi_725_ = true;
            }
            let _e494 = phi_724_;
            let _e496 = phi_725_;
            if _e496 {
                phi_729_ = _e472;
            } else {
                phi_729_ = _e494;
            }
            let _e498 = phi_729_;
            if (_e471 >= 0f) {
                if (_e498 >= 0f) {
                    if (_e471 < f32(_e441)) {
                        let _e504 = (_e498 < f32(_e443));
                        if (_e409 == 0f) {
                            phi_750_ = (_e415 == 0f);
                        } else {
                            phi_750_ = false;
                        }
                        let _e508 = phi_750_;
                        if _e504 {
                            phi_769_ = vec2<u32>(select(select(u32(_e471), 0u, (_e471 < bitcast<f32>(0u))), 4294967295u, (_e471 > bitcast<f32>(1333788671u))), select(select(u32(_e498), 0u, (_e498 < bitcast<f32>(0u))), 4294967295u, (_e498 > bitcast<f32>(1333788671u))));
                            phi_770_ = false;
                        } else {
                            phi_769_ = vec2<u32>();
                            phi_770_ = true;
                        }
                        let _e525 = phi_769_;
                        let _e527 = phi_770_;
                        phi_771_ = _e508;
                        phi_772_ = _e504;
                        phi_773_ = _e525;
                        phi_774_ = _e508;
                        phi_775_ = _e504;
                        phi_776_ = false;
                        phi_777_ = _e527;
                    } else {
                        phi_771_ = bool();
                        phi_772_ = bool();
                        phi_773_ = vec2<u32>();
                        phi_774_ = bool();
                        phi_775_ = bool();
                        phi_776_ = true;
                        phi_777_ = false;
                    }
                    let _e529 = phi_771_;
                    let _e531 = phi_772_;
                    let _e533 = phi_773_;
                    let _e535 = phi_774_;
                    let _e537 = phi_775_;
                    let _e539 = phi_776_;
                    let _e541 = phi_777_;
                    phi_778_ = _e529;
                    phi_779_ = _e531;
                    phi_780_ = _e533;
                    phi_781_ = _e535;
                    phi_782_ = _e537;
                    phi_783_ = _e539;
                    phi_784_ = _e541;
                } else {
                    phi_778_ = bool();
                    phi_779_ = bool();
                    phi_780_ = vec2<u32>();
                    phi_781_ = bool();
                    phi_782_ = bool();
                    phi_783_ = true;
                    phi_784_ = false;
                }
                let _e543 = phi_778_;
                let _e545 = phi_779_;
                let _e547 = phi_780_;
                let _e549 = phi_781_;
                let _e551 = phi_782_;
                let _e553 = phi_783_;
                let _e555 = phi_784_;
                phi_785_ = _e543;
                phi_786_ = _e545;
                phi_787_ = _e547;
                phi_788_ = _e549;
                phi_789_ = _e551;
                phi_790_ = _e553;
                phi_791_ = _e555;
            } else {
                phi_785_ = bool();
                phi_786_ = bool();
                phi_787_ = vec2<u32>();
                phi_788_ = bool();
                phi_789_ = bool();
                phi_790_ = true;
                phi_791_ = false;
            }
            let _e557 = phi_785_;
            let _e559 = phi_786_;
            let _e561 = phi_787_;
            let _e563 = phi_788_;
            let _e565 = phi_789_;
            let _e567 = phi_790_;
            let _e569 = phi_791_;
            if _e567 {
                if (_e409 == 0f) {
                    phi_800_ = (_e415 == 0f);
                } else {
                    phi_800_ = false;
                }
                let _e573 = phi_800_;
                phi_801_ = _e573;
                phi_802_ = false;
                phi_803_ = true;
            } else {
                phi_801_ = _e563;
                phi_802_ = _e565;
                phi_803_ = _e569;
            }
            let _e575 = phi_801_;
            let _e577 = phi_802_;
            let _e579 = phi_803_;
            if _e579 {
                phi_807_ = _e575;
                phi_808_ = _e577;
                phi_809_ = vec2<u32>(_e55.x, _e55.y);
            } else {
                phi_807_ = _e557;
                phi_808_ = _e559;
                phi_809_ = _e561;
            }
            let _e581 = phi_807_;
            let _e583 = phi_808_;
            let _e585 = phi_809_;
            let _e595 = lt_mask_Reprojection(vec2<u32>(_e585.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e602 = lt_mask_Reprojection(vec2<u32>(_e595.pixel.x, _e585.y), _e595.is_valid, _e595.has_moved);
            let _e606 = lt_mask_Reprojection(_e602.pixel, _e583, _e602.has_moved);
            let _e610 = lt_mask_Reprojection(_e606.pixel, _e606.is_valid, !(_e581));
            if _e583 {
                let _e613 = p.member.previous.eye;
                let _e621 = p.member.previous.forward;
                let _e630 = (((((_e91.x - _e613.x) * _e621.x) + ((_e91.y - _e613.y) * _e621.y)) + ((_e91.z - _e613.z) * _e621.z)) > 0f);
                let _e634 = lt_mask_Reprojection(_e610.pixel, _e630, _e610.has_moved);
                if _e630 {
                    let _e636 = p.member.flags;
                    phi_848_ = ((_e636 & 1u) != 0u);
                    phi_849_ = false;
                } else {
                    phi_848_ = bool();
                    phi_849_ = true;
                }
                let _e640 = phi_848_;
                let _e642 = phi_849_;
                phi_851_ = _e640;
                phi_852_ = _e634;
                phi_853_ = _e634;
                phi_854_ = _e642;
            } else {
                phi_851_ = bool();
                phi_852_ = lt_mask_Reprojection();
                phi_853_ = lt_mask_Reprojection(_e610.pixel, false, _e610.has_moved);
                phi_854_ = true;
            }
            let _e648 = phi_851_;
            let _e650 = phi_852_;
            let _e652 = phi_853_;
            let _e654 = phi_854_;
            if _e654 {
                phi_858_ = false;
                phi_859_ = _e652;
            } else {
                phi_858_ = _e648;
                phi_859_ = _e650;
            }
            let _e656 = phi_858_;
            let _e658 = phi_859_;
            let _e662 = lt_mask_Reprojection(_e658.pixel, _e656, _e658.has_moved);
            let _e664 = p.member.flags;
            let _e666 = ((_e664 & 2u) != 0u);
            let _e668 = p.member.flags;
            if ((_e668 & 4u) == 0u) {
                phi_933_ = u32();
                phi_934_ = true;
                phi_935_ = false;
            } else {
                if _e656 {
                    if !(_e662.has_moved) {
                        let _e676 = ((((_e55.y * _e88) + _e55.x) * _e84) + _e81);
                        if (_e82 > 29u) {
                            let _e678 = (_e676 + 1u);
                            if (_e678 < _e61) {
                            } else {
                                return;
                            }
                            let _e682 = last_bits.member[(0u + _e678)];
                            phi_900_ = _e682;
                        } else {
                            phi_900_ = 0u;
                        }
                        let _e684 = phi_900_;
                        if (_e676 < _e61) {
                        } else {
                            return;
                        }
                        let _e688 = last_bits.member[(0u + _e676)];
                        let _e691 = (_e688 >> bitcast<u32>((_e82 & 31u)));
                        if (_e82 > 29u) {
                            phi_919_ = (_e691 | (_e684 << bitcast<u32>(((32u - _e82) & 31u))));
                        } else {
                            phi_919_ = _e691;
                        }
                        let _e699 = phi_919_;
                        if ((_e699 & 2u) == 0u) {
                            phi_927_ = (_e699 & 1u);
                        } else {
                            phi_927_ = (_e699 & 7u);
                        }
                        let _e705 = phi_927_;
                        phi_928_ = _e705;
                        phi_929_ = false;
                    } else {
                        phi_928_ = u32();
                        phi_929_ = true;
                    }
                    let _e707 = phi_928_;
                    let _e709 = phi_929_;
                    phi_930_ = _e707;
                    phi_931_ = false;
                    phi_932_ = _e709;
                } else {
                    phi_930_ = u32();
                    phi_931_ = true;
                    phi_932_ = false;
                }
                let _e711 = phi_930_;
                let _e713 = phi_931_;
                let _e715 = phi_932_;
                phi_933_ = _e711;
                phi_934_ = _e713;
                phi_935_ = _e715;
            }
            let _e717 = phi_933_;
            let _e719 = phi_934_;
            let _e721 = phi_935_;
            if _e719 {
                phi_939_ = true;
            } else {
                phi_939_ = _e721;
            }
            let _e723 = phi_939_;
            if _e723 {
                phi_943_ = 0u;
            } else {
                phi_943_ = _e717;
            }
            let _e725 = phi_943_;
            let _e726 = lt_mask_Neighbourhood(false, true);
            if _e258 {
                phi_948_ = _e666;
            } else {
                phi_948_ = true;
            }
            let _e728 = phi_948_;
            if _e728 {
                if _e656 {
                    if ((_e725 & 2u) != 0u) {
                        phi_1241_ = _e726;
                    } else {
                        let _e732 = p.member.expansion;
                        if _e662.has_moved {
                            let _e735 = p.member.moving_pattern;
                            phi_970_ = _e735;
                        } else {
                            let _e737 = p.member.still_pattern;
                            phi_970_ = _e737;
                        }
                        let _e739 = phi_970_;
                        phi_972_ = 0u;
                        phi_975_ = _e726;
                        loop {
                            let _e741 = phi_972_;
                            let _e743 = phi_975_;
                            local_1 = _e743;
                            if (1u <= _e739) {
                                if (_e739 <= 4u) {
                                    phi_987_ = false;
                                } else {
                                    phi_987_ = true;
                                }
                                let _e747 = phi_987_;
                                phi_988_ = _e747;
                            } else {
                                phi_988_ = true;
                            }
                            let _e749 = phi_988_;
                            if _e749 {
                                switch bitcast<i32>(_e739) {
                                    case 5: {
                                        phi_997_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_997_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_997_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_997_ = 9u;
                                        break;
                                    }
                                }
                                let _e752 = phi_997_;
                                phi_998_ = _e752;
                            } else {
                                phi_998_ = 5u;
                            }
                            let _e754 = phi_998_;
                            let _e755 = (_e741 < _e754);
                            if _e755 {
                                let _e761 = p.member.frame;
                                let _e765 = p.member.current.size[0u];
                                let _e767 = p.member.current.size[1u];
                                switch bitcast<i32>(_e739) {
                                    case 1: {
                                        let _e777 = lt_mask_pattern_plus(_e741);
                                        phi_1078_ = vec2<i32>(_e777.x, _e777.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e781 = lt_mask_pattern_cross(_e741);
                                        phi_1078_ = vec2<i32>(_e781.x, _e781.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e787 = lt_mask_pattern_plus_or_cross(_e741, ((_e662.pixel.x + _e662.pixel.y) & 1u));
                                        phi_1078_ = vec2<i32>(_e787.x, _e787.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e792 = lt_mask_pattern_plus_or_cross(_e741, (_e761 & 1u));
                                        phi_1078_ = vec2<i32>(_e792.x, _e792.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e761 & 3u)) {
                                            case 0: {
                                                phi_1058_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_1058_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_1058_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_1058_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e803 = phi_1058_;
                                        phi_1078_ = (_e803 + vec2<i32>(bitcast<i32>((_e741 & 1u)), bitcast<i32>(((_e741 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_1078_ = vec2<i32>((bitcast<i32>((_e741 % 5u)) - 2i), (bitcast<i32>(((_e741 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e820 = lt_mask_pattern_diamond(_e741);
                                        phi_1078_ = vec2<i32>(_e820.x, _e820.y);
                                        break;
                                    }
                                    default: {
                                        phi_1078_ = vec2<i32>((bitcast<i32>((_e741 % 3u)) - 1i), (bitcast<i32>(((_e741 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e825 = phi_1078_;
                                let _e828 = lt_mask_pattern_step_clamped(_e662.pixel.x, _e825.x, _e765);
                                let _e829 = lt_mask_pattern_step_clamped(_e662.pixel.y, _e825.y, _e767);
                                let _e833 = ((((_e829 * _e88) + _e828) * _e84) + _e81);
                                if (_e82 > 29u) {
                                    let _e835 = (_e833 + 1u);
                                    if (_e835 < _e61) {
                                    } else {
                                        return;
                                    }
                                    let _e839 = last_bits.member[(0u + _e835)];
                                    phi_1103_ = _e839;
                                } else {
                                    phi_1103_ = 0u;
                                }
                                let _e841 = phi_1103_;
                                if (_e833 < _e61) {
                                } else {
                                    return;
                                }
                                let _e845 = last_bits.member[(0u + _e833)];
                                let _e848 = (_e845 >> bitcast<u32>((_e82 & 31u)));
                                if (_e82 > 29u) {
                                    phi_1122_ = (_e848 | (_e841 << bitcast<u32>(((32u - _e82) & 31u))));
                                } else {
                                    phi_1122_ = _e848;
                                }
                                let _e856 = phi_1122_;
                                if ((_e856 & 2u) == 0u) {
                                    phi_1130_ = (_e856 & 1u);
                                } else {
                                    phi_1130_ = (_e856 & 7u);
                                }
                                let _e862 = phi_1130_;
                                if _e743.any_expands {
                                    phi_1218_ = true;
                                } else {
                                    if ((_e862 & 2u) != 0u) {
                                        let _e869 = (((_e862 & 4u) != 0u) != _e254);
                                        switch bitcast<i32>(_e732) {
                                            case 1: {
                                                phi_1158_ = bool();
                                                phi_1159_ = false;
                                                phi_1160_ = true;
                                                phi_1161_ = false;
                                                phi_1162_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e869 {
                                                    phi_1156_ = (((_e862 & 4u) != 0u) != ((_e862 & 1u) != 0u));
                                                    phi_1157_ = false;
                                                } else {
                                                    phi_1156_ = bool();
                                                    phi_1157_ = true;
                                                }
                                                let _e877 = phi_1156_;
                                                let _e879 = phi_1157_;
                                                phi_1158_ = _e877;
                                                phi_1159_ = false;
                                                phi_1160_ = false;
                                                phi_1161_ = _e879;
                                                phi_1162_ = _e869;
                                                break;
                                            }
                                            default: {
                                                phi_1158_ = bool();
                                                phi_1159_ = true;
                                                phi_1160_ = false;
                                                phi_1161_ = false;
                                                phi_1162_ = false;
                                                break;
                                            }
                                        }
                                        let _e881 = phi_1158_;
                                        let _e883 = phi_1159_;
                                        let _e885 = phi_1160_;
                                        let _e887 = phi_1161_;
                                        let _e889 = phi_1162_;
                                        phi_1170_ = _e869;
                                        phi_1171_ = _e881;
                                        phi_1172_ = _e883;
                                        phi_1173_ = _e885;
                                        phi_1174_ = _e887;
                                        phi_1175_ = _e889;
                                    } else {
                                        switch bitcast<i32>(_e732) {
                                            case 1: {
                                                phi_1167_ = false;
                                                phi_1168_ = true;
                                                phi_1169_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_1167_ = false;
                                                phi_1168_ = false;
                                                phi_1169_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_1167_ = true;
                                                phi_1168_ = false;
                                                phi_1169_ = false;
                                                break;
                                            }
                                        }
                                        let _e892 = phi_1167_;
                                        let _e894 = phi_1168_;
                                        let _e896 = phi_1169_;
                                        phi_1170_ = false;
                                        phi_1171_ = bool();
                                        phi_1172_ = _e892;
                                        phi_1173_ = _e894;
                                        phi_1174_ = _e896;
                                        phi_1175_ = false;
                                    }
                                    let _e898 = phi_1170_;
                                    let _e900 = phi_1171_;
                                    let _e902 = phi_1172_;
                                    let _e904 = phi_1173_;
                                    let _e906 = phi_1174_;
                                    let _e908 = phi_1175_;
                                    if _e902 {
                                        if ((_e862 & 2u) != 0u) {
                                            if (((_e862 & 4u) != 0u) != _e254) {
                                                phi_1190_ = false;
                                            } else {
                                                phi_1190_ = true;
                                            }
                                            let _e915 = phi_1190_;
                                            phi_1191_ = _e915;
                                        } else {
                                            phi_1191_ = true;
                                        }
                                        let _e917 = phi_1191_;
                                        if _e917 {
                                            phi_1198_ = (((_e862 & 1u) != 0u) != _e254);
                                        } else {
                                            phi_1198_ = true;
                                        }
                                        let _e922 = phi_1198_;
                                        phi_1199_ = _e922;
                                        phi_1200_ = false;
                                        phi_1201_ = false;
                                        phi_1202_ = false;
                                    } else {
                                        phi_1199_ = bool();
                                        phi_1200_ = _e904;
                                        phi_1201_ = _e906;
                                        phi_1202_ = _e908;
                                    }
                                    let _e924 = phi_1199_;
                                    let _e926 = phi_1200_;
                                    let _e928 = phi_1201_;
                                    let _e930 = phi_1202_;
                                    if _e926 {
                                        phi_1206_ = _e898;
                                        phi_1207_ = false;
                                        phi_1208_ = false;
                                    } else {
                                        phi_1206_ = _e924;
                                        phi_1207_ = _e928;
                                        phi_1208_ = _e930;
                                    }
                                    let _e932 = phi_1206_;
                                    let _e934 = phi_1207_;
                                    let _e936 = phi_1208_;
                                    if _e934 {
                                        phi_1212_ = false;
                                        phi_1213_ = true;
                                    } else {
                                        phi_1212_ = _e900;
                                        phi_1213_ = _e936;
                                    }
                                    let _e938 = phi_1212_;
                                    let _e940 = phi_1213_;
                                    if _e940 {
                                        phi_1217_ = _e938;
                                    } else {
                                        phi_1217_ = _e932;
                                    }
                                    let _e942 = phi_1217_;
                                    phi_1218_ = _e942;
                                }
                                let _e944 = phi_1218_;
                                if _e743.all_remove {
                                    if (((_e862 & 1u) != 0u) == _e254) {
                                        if ((_e862 & 2u) != 0u) {
                                            phi_1236_ = (((_e862 & 4u) != 0u) == _e254);
                                        } else {
                                            phi_1236_ = true;
                                        }
                                        let _e954 = phi_1236_;
                                        phi_1237_ = _e954;
                                    } else {
                                        phi_1237_ = false;
                                    }
                                    let _e956 = phi_1237_;
                                    phi_1238_ = _e956;
                                } else {
                                    phi_1238_ = false;
                                }
                                let _e958 = phi_1238_;
                                phi_973_ = (_e741 + 1u);
                                phi_976_ = lt_mask_Neighbourhood(_e944, _e958);
                            } else {
                                phi_973_ = u32();
                                phi_976_ = lt_mask_Neighbourhood();
                            }
                            let _e962 = phi_973_;
                            let _e964 = phi_976_;
                            continue;
                            continuing {
                                phi_972_ = _e962;
                                phi_975_ = _e964;
                                break if !(_e755);
                            }
                        }
                        let _e1266 = local_1;
                        phi_1241_ = _e1266;
                    }
                    let _e967 = phi_1241_;
                    phi_1242_ = _e967;
                } else {
                    phi_1242_ = _e726;
                }
                let _e969 = phi_1242_;
                phi_1243_ = _e969;
            } else {
                phi_1243_ = _e726;
            }
            let _e971 = phi_1243_;
            let _e974 = p.member.frame;
            let _e976 = p.member.refresh;
            if (_e976 == 0u) {
                phi_1276_ = false;
            } else {
                if (_e976 == 0u) {
                    return;
                }
                let _e985 = ((_e55.x + (_e55.y * (((_e976 * 5u) / 8u) | 1u))) + (_e974 % _e976));
                if (_e976 == 0u) {
                    phi_1275_ = (_e985 == 0u);
                } else {
                    if (_e976 == 0u) {
                        return;
                    }
                    phi_1275_ = ((_e985 % _e976) == 0u);
                }
                let _e992 = phi_1275_;
                phi_1276_ = _e992;
            }
            let _e994 = phi_1276_;
            if _e656 {
                if _e994 {
                    phi_1298_ = bool();
                } else {
                    phi_1298_ = ((_e725 & 2u) != 0u);
                }
                let _e1000 = phi_1298_;
                phi_1299_ = _e1000;
                phi_1300_ = _e994;
            } else {
                phi_1299_ = bool();
                phi_1300_ = true;
            }
            let _e1002 = phi_1299_;
            let _e1004 = phi_1300_;
            if _e1004 {
                phi_1304_ = false;
            } else {
                phi_1304_ = _e1002;
            }
            let _e1006 = phi_1304_;
            if _e1006 {
                phi_1355_ = 7u;
            } else {
                if (_e96 != 0.5f) {
                    if _e656 {
                        if _e994 {
                            phi_1352_ = 6u;
                        } else {
                            if _e258 {
                                phi_1327_ = true;
                            } else {
                                if _e971.any_expands {
                                    phi_1326_ = false;
                                } else {
                                    phi_1326_ = true;
                                }
                                let _e1008 = phi_1326_;
                                phi_1327_ = _e1008;
                            }
                            let _e1010 = phi_1327_;
                            if _e1010 {
                                if _e258 {
                                    if _e666 {
                                        if _e971.all_remove {
                                            phi_1340_ = false;
                                        } else {
                                            phi_1340_ = true;
                                        }
                                        let _e1012 = phi_1340_;
                                        phi_1341_ = _e1012;
                                    } else {
                                        phi_1341_ = true;
                                    }
                                    let _e1014 = phi_1341_;
                                    phi_1342_ = _e1014;
                                } else {
                                    phi_1342_ = true;
                                }
                                let _e1016 = phi_1342_;
                                if _e1016 {
                                    if _e258 {
                                        phi_1349_ = 1u;
                                    } else {
                                        phi_1349_ = 0u;
                                    }
                                    let _e1018 = phi_1349_;
                                    phi_1350_ = _e1018;
                                } else {
                                    phi_1350_ = 5u;
                                }
                                let _e1020 = phi_1350_;
                                phi_1351_ = _e1020;
                            } else {
                                phi_1351_ = 4u;
                            }
                            let _e1022 = phi_1351_;
                            phi_1352_ = _e1022;
                        }
                        let _e1024 = phi_1352_;
                        phi_1353_ = _e1024;
                    } else {
                        phi_1353_ = 3u;
                    }
                    let _e1026 = phi_1353_;
                    phi_1354_ = _e1026;
                } else {
                    phi_1354_ = 2u;
                }
                let _e1028 = phi_1354_;
                phi_1355_ = _e1028;
            }
            let _e1030 = phi_1355_;
            if !((_e1030 == 0u)) {
                if !((_e1030 == 5u)) {
                    phi_1367_ = !(_e1006);
                    phi_1368_ = false;
                } else {
                    phi_1367_ = bool();
                    phi_1368_ = true;
                }
                let _e1037 = phi_1367_;
                let _e1039 = phi_1368_;
                phi_1369_ = _e1037;
                phi_1370_ = _e1039;
            } else {
                phi_1369_ = bool();
                phi_1370_ = true;
            }
            let _e1041 = phi_1369_;
            let _e1043 = phi_1370_;
            if _e1043 {
                phi_1374_ = false;
            } else {
                phi_1374_ = _e1041;
            }
            let _e1045 = phi_1374_;
            if _e1006 {
                phi_1380_ = ((_e725 & 4u) != 0u);
            } else {
                phi_1380_ = _e254;
            }
            let _e1049 = phi_1380_;
            if _e1045 {
                if _e254 {
                    phi_1388_ = (2u | 1u);
                } else {
                    phi_1388_ = 2u;
                }
                let _e1052 = phi_1388_;
                if false {
                    phi_1393_ = (_e1052 | 4u);
                } else {
                    phi_1393_ = _e1052;
                }
                let _e1055 = phi_1393_;
                phi_1413_ = _e1055;
            } else {
                if (_e1030 == 7u) {
                    if _e254 {
                        phi_1402_ = (2u | 1u);
                    } else {
                        phi_1402_ = 2u;
                    }
                    let _e1059 = phi_1402_;
                    if _e1049 {
                        phi_1407_ = (_e1059 | 4u);
                    } else {
                        phi_1407_ = _e1059;
                    }
                    let _e1062 = phi_1407_;
                    phi_1412_ = _e1062;
                } else {
                    if _e254 {
                        phi_1411_ = 1u;
                    } else {
                        phi_1411_ = 0u;
                    }
                    let _e1064 = phi_1411_;
                    phi_1412_ = _e1064;
                }
                let _e1066 = phi_1412_;
                phi_1413_ = _e1066;
            }
            let _e1068 = phi_1413_;
            if _e1049 {
                phi_1417_ = 0f;
            } else {
                phi_1417_ = 1f;
            }
            let _e1070 = phi_1417_;
            phi_1419_ = mask_Masked(_e1070, _e1068, _e1045);
        }
        let _e1073 = phi_1419_;
        visibility.member[_e72.shift] = _e1073.visibility;
        let _e1078 = p.member.light.number;
        let _e1079 = (_e1078 * 3u);
        let _e1081 = (_e1079 % 32u);
        let _e1083 = p.member.light.mask_words;
        let _e1085 = ((_e72.shift * _e1083) + (_e1079 / 32u));
        let _e1087 = bits.member[_e1085];
        bits.member[_e1085] = ((_e1087 & ~((7u << bitcast<u32>((_e1081 & 31u))))) | (_e1073.bits << bitcast<u32>((_e1081 & 31u))));
        if (_e1081 > 29u) {
            let _e1102 = bits.member[(_e1085 + 1u)];
            let _e1104 = (32u - _e1081);
            bits.member[(_e1085 + 1u)] = ((_e1102 & ~((7u >> bitcast<u32>((_e1104 & 31u))))) | (_e1073.bits >> bitcast<u32>((_e1104 & 31u))));
        }
        phi_1469_ = _e1073.needs_ray;
        phi_1470_ = _e72.shift;
    } else {
        phi_1469_ = false;
        phi_1470_ = 0u;
    }
    let _e1118 = phi_1469_;
    let _e1120 = phi_1470_;
    if (_e56 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1118 {
        let _e1124 = atomicAdd((&shared_[0u]), 1u);
        phi_1481_ = _e1124;
    } else {
        phi_1481_ = 0u;
    }
    let _e1126 = phi_1481_;
    workgroupBarrier();
    if (_e56 == 0u) {
        let _e1130 = atomicLoad((&shared_[0u]));
        let _e1131 = atomicAdd((&list.member[3u]), _e1130);
        atomicStore((&shared_[1u]), _e1131);
    }
    workgroupBarrier();
    if _e1118 {
        let _e1134 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1134) + _e1126)]), _e1120);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
