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
        let _e69 = phi_178_;
        let _e71 = phi_179_;
        phi_180_ = _e69;
        phi_181_ = _e71;
    } else {
        phi_180_ = lt_mask_LightPlace();
        phi_181_ = true;
    }
    let _e73 = phi_180_;
    let _e75 = phi_181_;
    if _e75 {
        phi_186_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_186_ = _e73;
    }
    let _e80 = phi_186_;
    return lt_mask_LightPlace(_e80.word, _e80.shift);
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
    let _e65 = phi_204_;
    return vec2<i32>(_e65.x, _e65.y);
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
    let _e65 = phi_222_;
    return vec2<i32>(_e65.x, _e65.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_241_: vec2<i32>;

    if (param_6 == 0u) {
        let _e59 = lt_mask_pattern_plus(param_5);
        phi_241_ = vec2<i32>(_e59.x, _e59.y);
    } else {
        let _e63 = lt_mask_pattern_cross(param_5);
        phi_241_ = vec2<i32>(_e63.x, _e63.y);
    }
    let _e68 = phi_241_;
    return vec2<i32>(_e68.x, _e68.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_266_: vec2<i32>;

    let _e57 = (param_7 % 13u);
    switch bitcast<i32>(_e57) {
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
            phi_266_ = vec2<i32>((bitcast<i32>((_e57 % 3u)) - 1i), (bitcast<i32>(((_e57 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e72 = phi_266_;
    return vec2<i32>(_e72.x, _e72.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_287_: u32;
    var phi_288_: u32;

    let _e60 = (bitcast<i32>(param_8) + param_9);
    if (_e60 < 0i) {
        phi_288_ = 0u;
    } else {
        if (_e60 >= bitcast<i32>(param_10)) {
            phi_287_ = (param_10 - 1u);
        } else {
            phi_287_ = bitcast<u32>(_e60);
        }
        let _e67 = phi_287_;
        phi_288_ = _e67;
    }
    let _e69 = phi_288_;
    return _e69;
}

fn function_() {
    var phi_364_: bool;
    var phi_365_: bool;
    var phi_366_: bool;
    var phi_367_: bool;
    var phi_371_: bool;
    var phi_441_: bool;
    var phi_442_: bool;
    var phi_453_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_454_: bool;
    var phi_455_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_456_: bool;
    var phi_463_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_467_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_480_: bool;
    var phi_508_: bool;
    var phi_509_: bool;
    var phi_510_: bool;
    var phi_511_: bool;
    var phi_515_: bool;
    var phi_516_: bool;
    var phi_724_: f32;
    var phi_729_: f32;
    var phi_730_: bool;
    var phi_731_: f32;
    var phi_732_: bool;
    var phi_736_: f32;
    var phi_757_: f32;
    var phi_762_: f32;
    var phi_763_: bool;
    var phi_764_: f32;
    var phi_765_: bool;
    var phi_769_: f32;
    var phi_790_: bool;
    var phi_809_: vec2<u32>;
    var phi_810_: bool;
    var phi_811_: bool;
    var phi_812_: bool;
    var phi_813_: vec2<u32>;
    var phi_814_: bool;
    var phi_815_: bool;
    var phi_816_: bool;
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
    var phi_840_: bool;
    var phi_841_: bool;
    var phi_842_: bool;
    var phi_843_: bool;
    var phi_847_: bool;
    var phi_848_: bool;
    var phi_849_: vec2<u32>;
    var phi_884_: bool;
    var phi_886_: lt_mask_Reprojection;
    var phi_887_: lt_mask_Reprojection;
    var phi_888_: bool;
    var phi_892_: bool;
    var phi_893_: lt_mask_Reprojection;
    var phi_894_: lt_mask_Reprojection;
    var phi_895_: bool;
    var phi_903_: bool;
    var phi_904_: lt_mask_Reprojection;
    var phi_945_: u32;
    var phi_964_: u32;
    var phi_972_: u32;
    var phi_973_: u32;
    var phi_974_: bool;
    var phi_975_: u32;
    var phi_976_: bool;
    var phi_977_: bool;
    var phi_978_: u32;
    var phi_979_: bool;
    var phi_980_: bool;
    var phi_984_: bool;
    var phi_988_: u32;
    var phi_993_: bool;
    var phi_1015_: u32;
    var phi_1017_: u32;
    var phi_1020_: lt_mask_Neighbourhood;
    var phi_1032_: bool;
    var phi_1033_: bool;
    var phi_1042_: u32;
    var phi_1043_: u32;
    var phi_1103_: vec2<i32>;
    var phi_1123_: vec2<i32>;
    var phi_1148_: u32;
    var phi_1167_: u32;
    var phi_1175_: u32;
    var phi_1201_: bool;
    var phi_1202_: bool;
    var phi_1203_: bool;
    var phi_1204_: bool;
    var phi_1205_: bool;
    var phi_1206_: bool;
    var phi_1207_: bool;
    var phi_1212_: bool;
    var phi_1213_: bool;
    var phi_1214_: bool;
    var phi_1215_: bool;
    var phi_1216_: bool;
    var phi_1217_: bool;
    var phi_1218_: bool;
    var phi_1219_: bool;
    var phi_1220_: bool;
    var phi_1235_: bool;
    var phi_1236_: bool;
    var phi_1243_: bool;
    var phi_1244_: bool;
    var phi_1245_: bool;
    var phi_1246_: bool;
    var phi_1247_: bool;
    var phi_1251_: bool;
    var phi_1252_: bool;
    var phi_1253_: bool;
    var phi_1257_: bool;
    var phi_1258_: bool;
    var phi_1262_: bool;
    var phi_1263_: bool;
    var phi_1281_: bool;
    var phi_1282_: bool;
    var phi_1283_: bool;
    var phi_1018_: u32;
    var phi_1021_: lt_mask_Neighbourhood;
    var phi_1286_: lt_mask_Neighbourhood;
    var phi_1287_: lt_mask_Neighbourhood;
    var phi_1288_: lt_mask_Neighbourhood;
    var phi_1320_: bool;
    var phi_1321_: bool;
    var phi_1343_: bool;
    var phi_1344_: bool;
    var phi_1345_: bool;
    var phi_1349_: bool;
    var phi_1371_: bool;
    var phi_1372_: bool;
    var phi_1385_: bool;
    var phi_1386_: bool;
    var phi_1387_: bool;
    var phi_1394_: u32;
    var phi_1395_: u32;
    var phi_1396_: u32;
    var phi_1397_: u32;
    var phi_1398_: u32;
    var phi_1399_: u32;
    var phi_1400_: u32;
    var phi_1412_: bool;
    var phi_1413_: bool;
    var phi_1414_: bool;
    var phi_1415_: bool;
    var phi_1419_: bool;
    var phi_1425_: bool;
    var phi_1433_: u32;
    var phi_1438_: u32;
    var phi_1447_: u32;
    var phi_1452_: u32;
    var phi_1456_: u32;
    var phi_1457_: u32;
    var phi_1458_: u32;
    var phi_1462_: f32;
    var phi_1464_: mask_Masked;
    var phi_1514_: bool;
    var phi_1515_: u32;
    var phi_1526_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e56 = id_1;
    let _e57 = local_2;
    let _e62 = arrayLength((&last_bits.member));
    let _e70 = p.member.current.size[0u];
    let _e72 = p.member.current.size[1u];
    let _e73 = lt_shaders_entry_pixel_index(_e56, _e70, _e72);
    if (bitcast<i32>(_e73.word) != 0i) {
        let _e80 = p.member.light.number;
        let _e81 = (_e80 * 3u);
        let _e82 = (_e81 / 32u);
        let _e83 = (_e81 % 32u);
        let _e85 = p.member.light.mask_words;
        let _e89 = p.member.current.size[0u];
        let _e92 = past.member[_e73.shift];
        let _e97 = visibility.member[_e73.shift];
        let _e103 = samples.member[_e73.shift].normal[0u];
        let _e105 = global[0u];
        if (_e103 == _e105) {
            let _e108 = samples.member[_e73.shift].normal[1u];
            let _e110 = global[1u];
            if (_e108 == _e110) {
                let _e113 = samples.member[_e73.shift].normal[2u];
                let _e115 = global[2u];
                phi_364_ = (_e113 == _e115);
                phi_365_ = false;
            } else {
                phi_364_ = bool();
                phi_365_ = true;
            }
            let _e118 = phi_364_;
            let _e120 = phi_365_;
            phi_366_ = _e118;
            phi_367_ = _e120;
        } else {
            phi_366_ = bool();
            phi_367_ = true;
        }
        let _e122 = phi_366_;
        let _e124 = phi_367_;
        if _e124 {
            phi_371_ = false;
        } else {
            phi_371_ = _e122;
        }
        let _e126 = phi_371_;
        if !(_e126) {
            let _e129 = samples.member[_e73.shift].position;
            let _e131 = p.member.light.place;
            let _e137 = p.member.light.place[3u];
            let _e144 = (_e131.x - (_e129.x * _e137));
            let _e145 = (_e131.y - (_e129.y * _e137));
            let _e146 = (_e131.z - (_e129.z * _e137));
            let _e148 = samples.member[_e73.shift].normal;
            if ((((_e148.x * _e144) + (_e148.y * _e145)) + (_e148.z * _e146)) > 0f) {
                let _e162 = (((_e144 * _e144) + (_e145 * _e145)) + (_e146 * _e146));
                let _e164 = p.member.light.axis;
                let _e176 = p.member.light.place[3u];
                if (_e176 == 0f) {
                    phi_442_ = true;
                } else {
                    let _e179 = p.member.light.range_squared;
                    if (_e162 <= _e179) {
                        let _e182 = p.member.light.cos_outer;
                        phi_441_ = (-((((_e144 * _e164.x) + (_e145 * _e164.y)) + (_e146 * _e164.z))) >= (_e182 * sqrt(_e162)));
                    } else {
                        phi_441_ = false;
                    }
                    let _e187 = phi_441_;
                    phi_442_ = _e187;
                }
                let _e189 = phi_442_;
                if _e189 {
                    let _e191 = samples.member[_e73.shift].flags;
                    let _e199 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e205 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e199.unnamed.visibility, false), _e199.unnamed_1);
                    phi_453_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e205.unnamed, ((_e191 & 1u) == 0u));
                    phi_454_ = false;
                } else {
                    phi_453_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_454_ = true;
                }
                let _e210 = phi_453_;
                let _e212 = phi_454_;
                phi_455_ = _e210;
                phi_456_ = _e212;
            } else {
                phi_455_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_456_ = true;
            }
            let _e214 = phi_455_;
            let _e216 = phi_456_;
            if _e216 {
                let _e222 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e228 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e222.unnamed.visibility, false), _e222.unnamed_1);
                phi_463_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e228.unnamed, true);
            } else {
                phi_463_ = _e214;
            }
            let _e233 = phi_463_;
            phi_467_ = _e233;
        } else {
            let _e239 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e245 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e239.unnamed.visibility, false), _e239.unnamed_1);
            phi_467_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e245.unnamed, true);
        }
        let _e250 = phi_467_;
        if _e250.unnamed_1 {
            phi_1464_ = mask_Masked(_e250.unnamed.visibility, 0u, false);
        } else {
            let _e255 = (_e97 < 0.5f);
            if (_e97 > 0f) {
                phi_480_ = (_e97 < 1f);
            } else {
                phi_480_ = false;
            }
            let _e259 = phi_480_;
            let _e266 = lt_mask_Reprojection(vec2<u32>(_e56.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e273 = lt_mask_Reprojection(vec2<u32>(_e266.pixel.x, _e56.y), _e266.is_valid, _e266.has_moved);
            let _e277 = lt_mask_Reprojection(_e273.pixel, true, _e273.has_moved);
            let _e283 = p.member.flags;
            if ((_e283 & 16u) == 0u) {
                phi_516_ = false;
            } else {
                let _e288 = samples.member[_e73.shift].position[0u];
                if (_e92.x == _e288) {
                    let _e291 = samples.member[_e73.shift].position[1u];
                    if (_e92.y == _e291) {
                        let _e294 = samples.member[_e73.shift].position[2u];
                        phi_508_ = (_e92.z == _e294);
                        phi_509_ = false;
                    } else {
                        phi_508_ = bool();
                        phi_509_ = true;
                    }
                    let _e297 = phi_508_;
                    let _e299 = phi_509_;
                    phi_510_ = _e297;
                    phi_511_ = _e299;
                } else {
                    phi_510_ = bool();
                    phi_511_ = true;
                }
                let _e301 = phi_510_;
                let _e303 = phi_511_;
                if _e303 {
                    phi_515_ = false;
                } else {
                    phi_515_ = _e301;
                }
                let _e305 = phi_515_;
                phi_516_ = _e305;
            }
            let _e307 = phi_516_;
            if _e307 {
                phi_893_ = lt_mask_Reprojection(_e277.pixel, _e277.is_valid, false);
                phi_894_ = lt_mask_Reprojection();
                phi_895_ = true;
            } else {
                let _e309 = samples.member[_e73.shift].position;
                let _e313 = p.member.previous.eye;
                let _e315 = (_e92.x - _e313.x);
                let _e317 = (_e92.y - _e313.y);
                let _e319 = (_e92.z - _e313.z);
                let _e321 = p.member.previous.forward;
                let _e329 = (((_e315 * _e321.x) + (_e317 * _e321.y)) + (_e319 * _e321.z));
                let _e331 = p.member.previous.right;
                let _e341 = p.member.previous.right;
                let _e356 = p.member.previous.up;
                let _e366 = p.member.previous.up;
                let _e381 = p.member.current.eye;
                let _e384 = (_e309.x - _e381.x);
                let _e387 = (_e309.y - _e381.y);
                let _e390 = (_e309.z - _e381.z);
                let _e392 = p.member.current.forward;
                let _e400 = (((_e384 * _e392.x) + (_e387 * _e392.y)) + (_e390 * _e392.z));
                let _e402 = p.member.current.right;
                let _e412 = p.member.current.right;
                let _e427 = p.member.current.up;
                let _e437 = p.member.current.up;
                let _e456 = p.member.current.size[0u];
                let _e458 = (((((((_e315 * _e331.x) + (_e317 * _e331.y)) + (_e319 * _e331.z)) / ((((_e341.x * _e341.x) + (_e341.y * _e341.y)) + (_e341.z * _e341.z)) * _e329)) - ((((_e384 * _e402.x) + (_e387 * _e402.y)) + (_e390 * _e402.z)) / ((((_e412.x * _e412.x) + (_e412.y * _e412.y)) + (_e412.z * _e412.z)) * _e400))) * 0.5f) * f32(_e456));
                let _e462 = p.member.current.size[1u];
                let _e464 = (((((((_e315 * _e356.x) + (_e317 * _e356.y)) + (_e319 * _e356.z)) / ((((_e366.x * _e366.x) + (_e366.y * _e366.y)) + (_e366.z * _e366.z)) * _e329)) - ((((_e384 * _e427.x) + (_e387 * _e427.y)) + (_e390 * _e427.z)) / ((((_e437.x * _e437.x) + (_e437.y * _e437.y)) + (_e437.z * _e437.z)) * _e400))) * -0.5f) * f32(_e462));
                let _e468 = p.member.current.grid[0u];
                let _e470 = p.member.current.grid[1u];
                let _e490 = p.member.current.size[0u];
                let _e492 = p.member.current.size[1u];
                let _e494 = ((f32(_e56.x) + ((f32((_e56.y & (_e470 - 1u))) + 0.5f) / f32(_e470))) + _e458);
                if (_e494 > -8388608f) {
                    let _e506 = f32(select(0i, select(select(i32(_e494), i32(-2147483648), (_e494 < bitcast<f32>(3472883712u))), 2147483647i, (_e494 > bitcast<f32>(1325400063u))), (_e494 == _e494)));
                    if (_e506 > _e494) {
                        phi_724_ = 1f;
                    } else {
                        phi_724_ = 0f;
                    }
                    let _e509 = phi_724_;
                    if (_e494 < 8388608f) {
                        phi_729_ = (_e506 - _e509);
                        phi_730_ = false;
                    } else {
                        phi_729_ = f32();
                        phi_730_ = true;
                    }
                    let _e512 = phi_729_;
                    let _e514 = phi_730_;
                    phi_731_ = _e512;
                    phi_732_ = _e514;
                } else {
                    phi_731_ = f32();
                    phi_732_ = true;
                }
                let _e516 = phi_731_;
                let _e518 = phi_732_;
                if _e518 {
                    phi_736_ = _e494;
                } else {
                    phi_736_ = _e516;
                }
                let _e520 = phi_736_;
                let _e521 = ((f32(_e56.y) + ((f32((_e56.x & (_e468 - 1u))) + 0.5f) / f32(_e468))) + _e464);
                if (_e521 > -8388608f) {
                    let _e533 = f32(select(0i, select(select(i32(_e521), i32(-2147483648), (_e521 < bitcast<f32>(3472883712u))), 2147483647i, (_e521 > bitcast<f32>(1325400063u))), (_e521 == _e521)));
                    if (_e533 > _e521) {
                        phi_757_ = 1f;
                    } else {
                        phi_757_ = 0f;
                    }
                    let _e536 = phi_757_;
                    if (_e521 < 8388608f) {
                        phi_762_ = (_e533 - _e536);
                        phi_763_ = false;
                    } else {
                        phi_762_ = f32();
                        phi_763_ = true;
                    }
                    let _e539 = phi_762_;
                    let _e541 = phi_763_;
                    phi_764_ = _e539;
                    phi_765_ = _e541;
                } else {
                    phi_764_ = f32();
                    phi_765_ = true;
                }
                let _e543 = phi_764_;
                let _e545 = phi_765_;
                if _e545 {
                    phi_769_ = _e521;
                } else {
                    phi_769_ = _e543;
                }
                let _e547 = phi_769_;
                if (_e520 >= 0f) {
                    if (_e547 >= 0f) {
                        if (_e520 < f32(_e490)) {
                            let _e553 = (_e547 < f32(_e492));
                            if (_e458 == 0f) {
                                phi_790_ = (_e464 == 0f);
                            } else {
                                phi_790_ = false;
                            }
                            let _e557 = phi_790_;
                            if _e553 {
                                phi_809_ = vec2<u32>(select(select(u32(_e520), 0u, (_e520 < bitcast<f32>(0u))), 4294967295u, (_e520 > bitcast<f32>(1333788671u))), select(select(u32(_e547), 0u, (_e547 < bitcast<f32>(0u))), 4294967295u, (_e547 > bitcast<f32>(1333788671u))));
                                phi_810_ = false;
                            } else {
                                phi_809_ = vec2<u32>();
                                phi_810_ = true;
                            }
                            let _e574 = phi_809_;
                            let _e576 = phi_810_;
                            phi_811_ = _e557;
                            phi_812_ = _e553;
                            phi_813_ = _e574;
                            phi_814_ = _e557;
                            phi_815_ = _e553;
                            phi_816_ = false;
                            phi_817_ = _e576;
                        } else {
                            phi_811_ = bool();
                            phi_812_ = bool();
                            phi_813_ = vec2<u32>();
                            phi_814_ = bool();
                            phi_815_ = bool();
                            phi_816_ = true;
                            phi_817_ = false;
                        }
                        let _e578 = phi_811_;
                        let _e580 = phi_812_;
                        let _e582 = phi_813_;
                        let _e584 = phi_814_;
                        let _e586 = phi_815_;
                        let _e588 = phi_816_;
                        let _e590 = phi_817_;
                        phi_818_ = _e578;
                        phi_819_ = _e580;
                        phi_820_ = _e582;
                        phi_821_ = _e584;
                        phi_822_ = _e586;
                        phi_823_ = _e588;
                        phi_824_ = _e590;
                    } else {
                        phi_818_ = bool();
                        phi_819_ = bool();
                        phi_820_ = vec2<u32>();
                        phi_821_ = bool();
                        phi_822_ = bool();
                        phi_823_ = true;
                        phi_824_ = false;
                    }
                    let _e592 = phi_818_;
                    let _e594 = phi_819_;
                    let _e596 = phi_820_;
                    let _e598 = phi_821_;
                    let _e600 = phi_822_;
                    let _e602 = phi_823_;
                    let _e604 = phi_824_;
                    phi_825_ = _e592;
                    phi_826_ = _e594;
                    phi_827_ = _e596;
                    phi_828_ = _e598;
                    phi_829_ = _e600;
                    phi_830_ = _e602;
                    phi_831_ = _e604;
                } else {
                    phi_825_ = bool();
                    phi_826_ = bool();
                    phi_827_ = vec2<u32>();
                    phi_828_ = bool();
                    phi_829_ = bool();
                    phi_830_ = true;
                    phi_831_ = false;
                }
                let _e606 = phi_825_;
                let _e608 = phi_826_;
                let _e610 = phi_827_;
                let _e612 = phi_828_;
                let _e614 = phi_829_;
                let _e616 = phi_830_;
                let _e618 = phi_831_;
                if _e616 {
                    if (_e458 == 0f) {
                        phi_840_ = (_e464 == 0f);
                    } else {
                        phi_840_ = false;
                    }
                    let _e622 = phi_840_;
                    phi_841_ = _e622;
                    phi_842_ = false;
                    phi_843_ = true;
                } else {
                    phi_841_ = _e612;
                    phi_842_ = _e614;
                    phi_843_ = _e618;
                }
                let _e624 = phi_841_;
                let _e626 = phi_842_;
                let _e628 = phi_843_;
                if _e628 {
                    phi_847_ = _e624;
                    phi_848_ = _e626;
                    phi_849_ = vec2<u32>(_e56.x, _e56.y);
                } else {
                    phi_847_ = _e606;
                    phi_848_ = _e608;
                    phi_849_ = _e610;
                }
                let _e630 = phi_847_;
                let _e632 = phi_848_;
                let _e634 = phi_849_;
                let _e644 = lt_mask_Reprojection(vec2<u32>(_e634.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
                let _e651 = lt_mask_Reprojection(vec2<u32>(_e644.pixel.x, _e634.y), _e644.is_valid, _e644.has_moved);
                let _e655 = lt_mask_Reprojection(_e651.pixel, _e632, _e651.has_moved);
                let _e659 = lt_mask_Reprojection(_e655.pixel, _e655.is_valid, !(_e630));
                if _e632 {
                    let _e662 = p.member.previous.eye;
                    let _e670 = p.member.previous.forward;
                    let _e679 = (((((_e92.x - _e662.x) * _e670.x) + ((_e92.y - _e662.y) * _e670.y)) + ((_e92.z - _e662.z) * _e670.z)) > 0f);
                    let _e683 = lt_mask_Reprojection(_e659.pixel, _e679, _e659.has_moved);
                    if _e679 {
                        phi_884_ = false;
                    } else {
                        phi_884_ = true;
                    }
                    let _e685 = phi_884_;
                    phi_886_ = _e683;
                    phi_887_ = _e683;
                    phi_888_ = _e685;
                } else {
                    phi_886_ = lt_mask_Reprojection();
                    phi_887_ = lt_mask_Reprojection(_e659.pixel, false, _e659.has_moved);
                    phi_888_ = true;
                }
                let _e691 = phi_886_;
                let _e693 = phi_887_;
                let _e695 = phi_888_;
                if _e695 {
                    phi_892_ = false;
                } else {
                    phi_892_ = true;
                }
                let _e697 = phi_892_;
                phi_893_ = _e691;
                phi_894_ = _e693;
                phi_895_ = _e697;
            }
            let _e699 = phi_893_;
            let _e701 = phi_894_;
            let _e703 = phi_895_;
            if _e703 {
                let _e705 = p.member.flags;
                phi_903_ = ((_e705 & 1u) != 0u);
                phi_904_ = _e699;
            } else {
                phi_903_ = false;
                phi_904_ = _e701;
            }
            let _e709 = phi_903_;
            let _e711 = phi_904_;
            let _e715 = lt_mask_Reprojection(_e711.pixel, _e709, _e711.has_moved);
            let _e717 = p.member.flags;
            let _e719 = ((_e717 & 2u) != 0u);
            let _e721 = p.member.flags;
            if ((_e721 & 4u) == 0u) {
                phi_978_ = u32();
                phi_979_ = true;
                phi_980_ = false;
            } else {
                if _e709 {
                    if !(_e715.has_moved) {
                        let _e729 = ((((_e56.y * _e89) + _e56.x) * _e85) + _e82);
                        if (_e83 > 29u) {
                            let _e731 = (_e729 + 1u);
                            if (_e731 < _e62) {
                            } else {
                                return;
                            }
                            let _e735 = last_bits.member[(0u + _e731)];
                            phi_945_ = _e735;
                        } else {
                            phi_945_ = 0u;
                        }
                        let _e737 = phi_945_;
                        if (_e729 < _e62) {
                        } else {
                            return;
                        }
                        let _e741 = last_bits.member[(0u + _e729)];
                        let _e744 = (_e741 >> bitcast<u32>((_e83 & 31u)));
                        if (_e83 > 29u) {
                            phi_964_ = (_e744 | (_e737 << bitcast<u32>(((32u - _e83) & 31u))));
                        } else {
                            phi_964_ = _e744;
                        }
                        let _e752 = phi_964_;
                        if ((_e752 & 2u) == 0u) {
                            phi_972_ = (_e752 & 1u);
                        } else {
                            phi_972_ = (_e752 & 7u);
                        }
                        let _e758 = phi_972_;
                        phi_973_ = _e758;
                        phi_974_ = false;
                    } else {
                        phi_973_ = u32();
                        phi_974_ = true;
                    }
                    let _e760 = phi_973_;
                    let _e762 = phi_974_;
                    phi_975_ = _e760;
                    phi_976_ = false;
                    phi_977_ = _e762;
                } else {
                    phi_975_ = u32();
                    phi_976_ = true;
                    phi_977_ = false;
                }
                let _e764 = phi_975_;
                let _e766 = phi_976_;
                let _e768 = phi_977_;
                phi_978_ = _e764;
                phi_979_ = _e766;
                phi_980_ = _e768;
            }
            let _e770 = phi_978_;
            let _e772 = phi_979_;
            let _e774 = phi_980_;
            if _e772 {
                phi_984_ = true;
            } else {
                phi_984_ = _e774;
            }
            let _e776 = phi_984_;
            if _e776 {
                phi_988_ = 0u;
            } else {
                phi_988_ = _e770;
            }
            let _e778 = phi_988_;
            let _e779 = lt_mask_Neighbourhood(false, true);
            if _e259 {
                phi_993_ = _e719;
            } else {
                phi_993_ = false;
            }
            let _e781 = phi_993_;
            if _e781 {
                if _e709 {
                    if ((_e778 & 2u) != 0u) {
                        phi_1286_ = _e779;
                    } else {
                        let _e785 = p.member.expansion;
                        if _e715.has_moved {
                            let _e788 = p.member.moving_pattern;
                            phi_1015_ = _e788;
                        } else {
                            let _e790 = p.member.still_pattern;
                            phi_1015_ = _e790;
                        }
                        let _e792 = phi_1015_;
                        phi_1017_ = 0u;
                        phi_1020_ = _e779;
                        loop {
                            let _e794 = phi_1017_;
                            let _e796 = phi_1020_;
                            local_1 = _e796;
                            if (1u <= _e792) {
                                if (_e792 <= 4u) {
                                    phi_1032_ = false;
                                } else {
                                    phi_1032_ = true;
                                }
                                let _e800 = phi_1032_;
                                phi_1033_ = _e800;
                            } else {
                                phi_1033_ = true;
                            }
                            let _e802 = phi_1033_;
                            if _e802 {
                                switch bitcast<i32>(_e792) {
                                    case 5: {
                                        phi_1042_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_1042_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_1042_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_1042_ = 9u;
                                        break;
                                    }
                                }
                                let _e805 = phi_1042_;
                                phi_1043_ = _e805;
                            } else {
                                phi_1043_ = 5u;
                            }
                            let _e807 = phi_1043_;
                            let _e808 = (_e794 < _e807);
                            if _e808 {
                                let _e814 = p.member.frame;
                                let _e818 = p.member.current.size[0u];
                                let _e820 = p.member.current.size[1u];
                                switch bitcast<i32>(_e792) {
                                    case 1: {
                                        let _e830 = lt_mask_pattern_plus(_e794);
                                        phi_1123_ = vec2<i32>(_e830.x, _e830.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e834 = lt_mask_pattern_cross(_e794);
                                        phi_1123_ = vec2<i32>(_e834.x, _e834.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e840 = lt_mask_pattern_plus_or_cross(_e794, ((_e715.pixel.x + _e715.pixel.y) & 1u));
                                        phi_1123_ = vec2<i32>(_e840.x, _e840.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e845 = lt_mask_pattern_plus_or_cross(_e794, (_e814 & 1u));
                                        phi_1123_ = vec2<i32>(_e845.x, _e845.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e814 & 3u)) {
                                            case 0: {
                                                phi_1103_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_1103_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_1103_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_1103_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e856 = phi_1103_;
                                        phi_1123_ = (_e856 + vec2<i32>(bitcast<i32>((_e794 & 1u)), bitcast<i32>(((_e794 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_1123_ = vec2<i32>((bitcast<i32>((_e794 % 5u)) - 2i), (bitcast<i32>(((_e794 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e873 = lt_mask_pattern_diamond(_e794);
                                        phi_1123_ = vec2<i32>(_e873.x, _e873.y);
                                        break;
                                    }
                                    default: {
                                        phi_1123_ = vec2<i32>((bitcast<i32>((_e794 % 3u)) - 1i), (bitcast<i32>(((_e794 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e878 = phi_1123_;
                                let _e881 = lt_mask_pattern_step_clamped(_e715.pixel.x, _e878.x, _e818);
                                let _e882 = lt_mask_pattern_step_clamped(_e715.pixel.y, _e878.y, _e820);
                                let _e886 = ((((_e882 * _e89) + _e881) * _e85) + _e82);
                                if (_e83 > 29u) {
                                    let _e888 = (_e886 + 1u);
                                    if (_e888 < _e62) {
                                    } else {
                                        return;
                                    }
                                    let _e892 = last_bits.member[(0u + _e888)];
                                    phi_1148_ = _e892;
                                } else {
                                    phi_1148_ = 0u;
                                }
                                let _e894 = phi_1148_;
                                if (_e886 < _e62) {
                                } else {
                                    return;
                                }
                                let _e898 = last_bits.member[(0u + _e886)];
                                let _e901 = (_e898 >> bitcast<u32>((_e83 & 31u)));
                                if (_e83 > 29u) {
                                    phi_1167_ = (_e901 | (_e894 << bitcast<u32>(((32u - _e83) & 31u))));
                                } else {
                                    phi_1167_ = _e901;
                                }
                                let _e909 = phi_1167_;
                                if ((_e909 & 2u) == 0u) {
                                    phi_1175_ = (_e909 & 1u);
                                } else {
                                    phi_1175_ = (_e909 & 7u);
                                }
                                let _e915 = phi_1175_;
                                if _e796.any_expands {
                                    phi_1263_ = true;
                                } else {
                                    if ((_e915 & 2u) != 0u) {
                                        let _e922 = (((_e915 & 4u) != 0u) != _e255);
                                        switch bitcast<i32>(_e785) {
                                            case 1: {
                                                phi_1203_ = bool();
                                                phi_1204_ = false;
                                                phi_1205_ = true;
                                                phi_1206_ = false;
                                                phi_1207_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e922 {
                                                    phi_1201_ = (((_e915 & 4u) != 0u) != ((_e915 & 1u) != 0u));
                                                    phi_1202_ = false;
                                                } else {
                                                    phi_1201_ = bool();
                                                    phi_1202_ = true;
                                                }
                                                let _e930 = phi_1201_;
                                                let _e932 = phi_1202_;
                                                phi_1203_ = _e930;
                                                phi_1204_ = false;
                                                phi_1205_ = false;
                                                phi_1206_ = _e932;
                                                phi_1207_ = _e922;
                                                break;
                                            }
                                            default: {
                                                phi_1203_ = bool();
                                                phi_1204_ = true;
                                                phi_1205_ = false;
                                                phi_1206_ = false;
                                                phi_1207_ = false;
                                                break;
                                            }
                                        }
                                        let _e934 = phi_1203_;
                                        let _e936 = phi_1204_;
                                        let _e938 = phi_1205_;
                                        let _e940 = phi_1206_;
                                        let _e942 = phi_1207_;
                                        phi_1215_ = _e922;
                                        phi_1216_ = _e934;
                                        phi_1217_ = _e936;
                                        phi_1218_ = _e938;
                                        phi_1219_ = _e940;
                                        phi_1220_ = _e942;
                                    } else {
                                        switch bitcast<i32>(_e785) {
                                            case 1: {
                                                phi_1212_ = false;
                                                phi_1213_ = true;
                                                phi_1214_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_1212_ = false;
                                                phi_1213_ = false;
                                                phi_1214_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_1212_ = true;
                                                phi_1213_ = false;
                                                phi_1214_ = false;
                                                break;
                                            }
                                        }
                                        let _e945 = phi_1212_;
                                        let _e947 = phi_1213_;
                                        let _e949 = phi_1214_;
                                        phi_1215_ = false;
                                        phi_1216_ = bool();
                                        phi_1217_ = _e945;
                                        phi_1218_ = _e947;
                                        phi_1219_ = _e949;
                                        phi_1220_ = false;
                                    }
                                    let _e951 = phi_1215_;
                                    let _e953 = phi_1216_;
                                    let _e955 = phi_1217_;
                                    let _e957 = phi_1218_;
                                    let _e959 = phi_1219_;
                                    let _e961 = phi_1220_;
                                    if _e955 {
                                        if ((_e915 & 2u) != 0u) {
                                            if (((_e915 & 4u) != 0u) != _e255) {
                                                phi_1235_ = false;
                                            } else {
                                                phi_1235_ = true;
                                            }
                                            let _e968 = phi_1235_;
                                            phi_1236_ = _e968;
                                        } else {
                                            phi_1236_ = true;
                                        }
                                        let _e970 = phi_1236_;
                                        if _e970 {
                                            phi_1243_ = (((_e915 & 1u) != 0u) != _e255);
                                        } else {
                                            phi_1243_ = true;
                                        }
                                        let _e975 = phi_1243_;
                                        phi_1244_ = _e975;
                                        phi_1245_ = false;
                                        phi_1246_ = false;
                                        phi_1247_ = false;
                                    } else {
                                        phi_1244_ = bool();
                                        phi_1245_ = _e957;
                                        phi_1246_ = _e959;
                                        phi_1247_ = _e961;
                                    }
                                    let _e977 = phi_1244_;
                                    let _e979 = phi_1245_;
                                    let _e981 = phi_1246_;
                                    let _e983 = phi_1247_;
                                    if _e979 {
                                        phi_1251_ = _e951;
                                        phi_1252_ = false;
                                        phi_1253_ = false;
                                    } else {
                                        phi_1251_ = _e977;
                                        phi_1252_ = _e981;
                                        phi_1253_ = _e983;
                                    }
                                    let _e985 = phi_1251_;
                                    let _e987 = phi_1252_;
                                    let _e989 = phi_1253_;
                                    if _e987 {
                                        phi_1257_ = false;
                                        phi_1258_ = true;
                                    } else {
                                        phi_1257_ = _e953;
                                        phi_1258_ = _e989;
                                    }
                                    let _e991 = phi_1257_;
                                    let _e993 = phi_1258_;
                                    if _e993 {
                                        phi_1262_ = _e991;
                                    } else {
                                        phi_1262_ = _e985;
                                    }
                                    let _e995 = phi_1262_;
                                    phi_1263_ = _e995;
                                }
                                let _e997 = phi_1263_;
                                if _e796.all_remove {
                                    if (((_e915 & 1u) != 0u) == _e255) {
                                        if ((_e915 & 2u) != 0u) {
                                            phi_1281_ = (((_e915 & 4u) != 0u) == _e255);
                                        } else {
                                            phi_1281_ = true;
                                        }
                                        let _e1007 = phi_1281_;
                                        phi_1282_ = _e1007;
                                    } else {
                                        phi_1282_ = false;
                                    }
                                    let _e1009 = phi_1282_;
                                    phi_1283_ = _e1009;
                                } else {
                                    phi_1283_ = false;
                                }
                                let _e1011 = phi_1283_;
                                phi_1018_ = (_e794 + 1u);
                                phi_1021_ = lt_mask_Neighbourhood(_e997, _e1011);
                            } else {
                                phi_1018_ = u32();
                                phi_1021_ = lt_mask_Neighbourhood();
                            }
                            let _e1015 = phi_1018_;
                            let _e1017 = phi_1021_;
                            continue;
                            continuing {
                                phi_1017_ = _e1015;
                                phi_1020_ = _e1017;
                                break if !(_e808);
                            }
                        }
                        let _e1327 = local_1;
                        phi_1286_ = _e1327;
                    }
                    let _e1020 = phi_1286_;
                    phi_1287_ = _e1020;
                } else {
                    phi_1287_ = _e779;
                }
                let _e1022 = phi_1287_;
                phi_1288_ = _e1022;
            } else {
                phi_1288_ = _e779;
            }
            let _e1024 = phi_1288_;
            let _e1027 = p.member.frame;
            let _e1029 = p.member.refresh;
            if (_e1029 == 0u) {
                phi_1321_ = false;
            } else {
                if (_e1029 == 0u) {
                    return;
                }
                let _e1038 = ((_e56.x + (_e56.y * (((_e1029 * 5u) / 8u) | 1u))) + (_e1027 % _e1029));
                if (_e1029 == 0u) {
                    phi_1320_ = (_e1038 == 0u);
                } else {
                    if (_e1029 == 0u) {
                        return;
                    }
                    phi_1320_ = ((_e1038 % _e1029) == 0u);
                }
                let _e1045 = phi_1320_;
                phi_1321_ = _e1045;
            }
            let _e1047 = phi_1321_;
            if _e709 {
                if _e1047 {
                    phi_1343_ = bool();
                } else {
                    phi_1343_ = ((_e778 & 2u) != 0u);
                }
                let _e1053 = phi_1343_;
                phi_1344_ = _e1053;
                phi_1345_ = _e1047;
            } else {
                phi_1344_ = bool();
                phi_1345_ = true;
            }
            let _e1055 = phi_1344_;
            let _e1057 = phi_1345_;
            if _e1057 {
                phi_1349_ = false;
            } else {
                phi_1349_ = _e1055;
            }
            let _e1059 = phi_1349_;
            if _e1059 {
                phi_1400_ = 7u;
            } else {
                if (_e97 != 0.5f) {
                    if _e709 {
                        if _e1047 {
                            phi_1397_ = 6u;
                        } else {
                            if _e259 {
                                phi_1372_ = true;
                            } else {
                                if _e1024.any_expands {
                                    phi_1371_ = false;
                                } else {
                                    phi_1371_ = true;
                                }
                                let _e1061 = phi_1371_;
                                phi_1372_ = _e1061;
                            }
                            let _e1063 = phi_1372_;
                            if _e1063 {
                                if _e259 {
                                    if _e719 {
                                        if _e1024.all_remove {
                                            phi_1385_ = false;
                                        } else {
                                            phi_1385_ = true;
                                        }
                                        let _e1065 = phi_1385_;
                                        phi_1386_ = _e1065;
                                    } else {
                                        phi_1386_ = true;
                                    }
                                    let _e1067 = phi_1386_;
                                    phi_1387_ = _e1067;
                                } else {
                                    phi_1387_ = true;
                                }
                                let _e1069 = phi_1387_;
                                if _e1069 {
                                    if _e259 {
                                        phi_1394_ = 1u;
                                    } else {
                                        phi_1394_ = 0u;
                                    }
                                    let _e1071 = phi_1394_;
                                    phi_1395_ = _e1071;
                                } else {
                                    phi_1395_ = 5u;
                                }
                                let _e1073 = phi_1395_;
                                phi_1396_ = _e1073;
                            } else {
                                phi_1396_ = 4u;
                            }
                            let _e1075 = phi_1396_;
                            phi_1397_ = _e1075;
                        }
                        let _e1077 = phi_1397_;
                        phi_1398_ = _e1077;
                    } else {
                        phi_1398_ = 3u;
                    }
                    let _e1079 = phi_1398_;
                    phi_1399_ = _e1079;
                } else {
                    phi_1399_ = 2u;
                }
                let _e1081 = phi_1399_;
                phi_1400_ = _e1081;
            }
            let _e1083 = phi_1400_;
            if !((_e1083 == 0u)) {
                if !((_e1083 == 5u)) {
                    phi_1412_ = !(_e1059);
                    phi_1413_ = false;
                } else {
                    phi_1412_ = bool();
                    phi_1413_ = true;
                }
                let _e1090 = phi_1412_;
                let _e1092 = phi_1413_;
                phi_1414_ = _e1090;
                phi_1415_ = _e1092;
            } else {
                phi_1414_ = bool();
                phi_1415_ = true;
            }
            let _e1094 = phi_1414_;
            let _e1096 = phi_1415_;
            if _e1096 {
                phi_1419_ = false;
            } else {
                phi_1419_ = _e1094;
            }
            let _e1098 = phi_1419_;
            if _e1059 {
                phi_1425_ = ((_e778 & 4u) != 0u);
            } else {
                phi_1425_ = _e255;
            }
            let _e1102 = phi_1425_;
            if _e1098 {
                if _e255 {
                    phi_1433_ = (2u | 1u);
                } else {
                    phi_1433_ = 2u;
                }
                let _e1105 = phi_1433_;
                if false {
                    phi_1438_ = (_e1105 | 4u);
                } else {
                    phi_1438_ = _e1105;
                }
                let _e1108 = phi_1438_;
                phi_1458_ = _e1108;
            } else {
                if (_e1083 == 7u) {
                    if _e255 {
                        phi_1447_ = (2u | 1u);
                    } else {
                        phi_1447_ = 2u;
                    }
                    let _e1112 = phi_1447_;
                    if _e1102 {
                        phi_1452_ = (_e1112 | 4u);
                    } else {
                        phi_1452_ = _e1112;
                    }
                    let _e1115 = phi_1452_;
                    phi_1457_ = _e1115;
                } else {
                    if _e255 {
                        phi_1456_ = 1u;
                    } else {
                        phi_1456_ = 0u;
                    }
                    let _e1117 = phi_1456_;
                    phi_1457_ = _e1117;
                }
                let _e1119 = phi_1457_;
                phi_1458_ = _e1119;
            }
            let _e1121 = phi_1458_;
            if _e1102 {
                phi_1462_ = 0f;
            } else {
                phi_1462_ = 1f;
            }
            let _e1123 = phi_1462_;
            phi_1464_ = mask_Masked(_e1123, _e1121, _e1098);
        }
        let _e1126 = phi_1464_;
        visibility.member[_e73.shift] = _e1126.visibility;
        let _e1131 = p.member.light.number;
        let _e1132 = (_e1131 * 3u);
        let _e1134 = (_e1132 % 32u);
        let _e1136 = p.member.light.mask_words;
        let _e1138 = ((_e73.shift * _e1136) + (_e1132 / 32u));
        let _e1140 = bits.member[_e1138];
        bits.member[_e1138] = ((_e1140 & ~((7u << bitcast<u32>((_e1134 & 31u))))) | (_e1126.bits << bitcast<u32>((_e1134 & 31u))));
        if (_e1134 > 29u) {
            let _e1155 = bits.member[(_e1138 + 1u)];
            let _e1157 = (32u - _e1134);
            bits.member[(_e1138 + 1u)] = ((_e1155 & ~((7u >> bitcast<u32>((_e1157 & 31u))))) | (_e1126.bits >> bitcast<u32>((_e1157 & 31u))));
        }
        phi_1514_ = _e1126.needs_ray;
        phi_1515_ = _e73.shift;
    } else {
        phi_1514_ = false;
        phi_1515_ = 0u;
    }
    let _e1171 = phi_1514_;
    let _e1173 = phi_1515_;
    if (_e57 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1171 {
        let _e1177 = atomicAdd((&shared_[0u]), 1u);
        phi_1526_ = _e1177;
    } else {
        phi_1526_ = 0u;
    }
    let _e1179 = phi_1526_;
    workgroupBarrier();
    if (_e57 == 0u) {
        let _e1183 = atomicLoad((&shared_[0u]));
        let _e1184 = atomicAdd((&list.member[3u]), _e1183);
        atomicStore((&shared_[1u]), _e1184);
    }
    workgroupBarrier();
    if _e1171 {
        let _e1187 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1187) + _e1179)]), _e1173);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_rr_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
