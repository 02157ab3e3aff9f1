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
    var phi_172_: lt_mask_LightPlace;
    var phi_173_: bool;
    var phi_174_: lt_mask_LightPlace;
    var phi_175_: bool;
    var phi_180_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_172_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_173_ = false;
        } else {
            phi_172_ = lt_mask_LightPlace();
            phi_173_ = true;
        }
        let _e68 = phi_172_;
        let _e70 = phi_173_;
        phi_174_ = _e68;
        phi_175_ = _e70;
    } else {
        phi_174_ = lt_mask_LightPlace();
        phi_175_ = true;
    }
    let _e72 = phi_174_;
    let _e74 = phi_175_;
    if _e74 {
        phi_180_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_180_ = _e72;
    }
    let _e79 = phi_180_;
    return lt_mask_LightPlace(_e79.word, _e79.shift);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_198_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_198_ = vec2(0i);
            break;
        }
        case 1: {
            phi_198_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_198_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_198_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_198_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e64 = phi_198_;
    return vec2<i32>(_e64.x, _e64.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_216_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_216_ = vec2(0i);
            break;
        }
        case 1: {
            phi_216_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_216_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_216_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_216_ = vec2(1i);
            break;
        }
    }
    let _e64 = phi_216_;
    return vec2<i32>(_e64.x, _e64.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_235_: vec2<i32>;

    if (param_6 == 0u) {
        let _e58 = lt_mask_pattern_plus(param_5);
        phi_235_ = vec2<i32>(_e58.x, _e58.y);
    } else {
        let _e62 = lt_mask_pattern_cross(param_5);
        phi_235_ = vec2<i32>(_e62.x, _e62.y);
    }
    let _e67 = phi_235_;
    return vec2<i32>(_e67.x, _e67.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_260_: vec2<i32>;

    let _e56 = (param_7 % 13u);
    switch bitcast<i32>(_e56) {
        case 9: {
            phi_260_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_260_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_260_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_260_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_260_ = vec2<i32>((bitcast<i32>((_e56 % 3u)) - 1i), (bitcast<i32>(((_e56 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e71 = phi_260_;
    return vec2<i32>(_e71.x, _e71.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_281_: u32;
    var phi_282_: u32;

    let _e59 = (bitcast<i32>(param_8) + param_9);
    if (_e59 < 0i) {
        phi_282_ = 0u;
    } else {
        if (_e59 >= bitcast<i32>(param_10)) {
            phi_281_ = (param_10 - 1u);
        } else {
            phi_281_ = bitcast<u32>(_e59);
        }
        let _e66 = phi_281_;
        phi_282_ = _e66;
    }
    let _e68 = phi_282_;
    return _e68;
}

fn function_() {
    var phi_354_: bool;
    var phi_355_: bool;
    var phi_356_: bool;
    var phi_357_: bool;
    var phi_361_: bool;
    var phi_431_: bool;
    var phi_432_: bool;
    var phi_443_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_444_: bool;
    var phi_445_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_446_: bool;
    var phi_453_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_457_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_470_: bool;
    var phi_501_: bool;
    var phi_502_: bool;
    var phi_503_: bool;
    var phi_504_: bool;
    var phi_508_: bool;
    var phi_509_: bool;
    var phi_720_: f32;
    var phi_725_: f32;
    var phi_726_: bool;
    var phi_727_: f32;
    var phi_728_: bool;
    var phi_732_: f32;
    var phi_753_: f32;
    var phi_758_: f32;
    var phi_759_: bool;
    var phi_760_: f32;
    var phi_761_: bool;
    var phi_765_: f32;
    var phi_786_: bool;
    var phi_805_: vec2<u32>;
    var phi_806_: bool;
    var phi_807_: bool;
    var phi_808_: bool;
    var phi_809_: vec2<u32>;
    var phi_810_: bool;
    var phi_811_: bool;
    var phi_812_: bool;
    var phi_813_: bool;
    var phi_814_: bool;
    var phi_815_: bool;
    var phi_816_: vec2<u32>;
    var phi_817_: bool;
    var phi_818_: bool;
    var phi_819_: bool;
    var phi_820_: bool;
    var phi_821_: bool;
    var phi_822_: bool;
    var phi_823_: vec2<u32>;
    var phi_824_: bool;
    var phi_825_: bool;
    var phi_826_: bool;
    var phi_827_: bool;
    var phi_836_: bool;
    var phi_837_: bool;
    var phi_838_: bool;
    var phi_839_: bool;
    var phi_843_: bool;
    var phi_844_: bool;
    var phi_845_: vec2<u32>;
    var phi_883_: bool;
    var phi_885_: lt_mask_Reprojection;
    var phi_886_: lt_mask_Reprojection;
    var phi_887_: bool;
    var phi_891_: bool;
    var phi_892_: lt_mask_Reprojection;
    var phi_893_: lt_mask_Reprojection;
    var phi_894_: bool;
    var phi_902_: bool;
    var phi_903_: lt_mask_Reprojection;
    var phi_944_: u32;
    var phi_963_: u32;
    var phi_971_: u32;
    var phi_972_: u32;
    var phi_973_: bool;
    var phi_974_: u32;
    var phi_975_: bool;
    var phi_976_: bool;
    var phi_977_: u32;
    var phi_978_: bool;
    var phi_979_: bool;
    var phi_983_: bool;
    var phi_987_: u32;
    var phi_992_: bool;
    var phi_1014_: u32;
    var phi_1016_: u32;
    var phi_1019_: lt_mask_Neighbourhood;
    var phi_1031_: bool;
    var phi_1032_: bool;
    var phi_1041_: u32;
    var phi_1042_: u32;
    var phi_1102_: vec2<i32>;
    var phi_1122_: vec2<i32>;
    var phi_1147_: u32;
    var phi_1166_: u32;
    var phi_1174_: u32;
    var phi_1200_: bool;
    var phi_1201_: bool;
    var phi_1202_: bool;
    var phi_1203_: bool;
    var phi_1204_: bool;
    var phi_1205_: bool;
    var phi_1206_: bool;
    var phi_1211_: bool;
    var phi_1212_: bool;
    var phi_1213_: bool;
    var phi_1214_: bool;
    var phi_1215_: bool;
    var phi_1216_: bool;
    var phi_1217_: bool;
    var phi_1218_: bool;
    var phi_1219_: bool;
    var phi_1234_: bool;
    var phi_1235_: bool;
    var phi_1242_: bool;
    var phi_1243_: bool;
    var phi_1244_: bool;
    var phi_1245_: bool;
    var phi_1246_: bool;
    var phi_1250_: bool;
    var phi_1251_: bool;
    var phi_1252_: bool;
    var phi_1256_: bool;
    var phi_1257_: bool;
    var phi_1261_: bool;
    var phi_1262_: bool;
    var phi_1280_: bool;
    var phi_1281_: bool;
    var phi_1282_: bool;
    var phi_1017_: u32;
    var phi_1020_: lt_mask_Neighbourhood;
    var phi_1285_: lt_mask_Neighbourhood;
    var phi_1286_: lt_mask_Neighbourhood;
    var phi_1287_: lt_mask_Neighbourhood;
    var phi_1319_: bool;
    var phi_1320_: bool;
    var phi_1342_: bool;
    var phi_1343_: bool;
    var phi_1344_: bool;
    var phi_1348_: bool;
    var phi_1370_: bool;
    var phi_1371_: bool;
    var phi_1384_: bool;
    var phi_1385_: bool;
    var phi_1386_: bool;
    var phi_1393_: u32;
    var phi_1394_: u32;
    var phi_1395_: u32;
    var phi_1396_: u32;
    var phi_1397_: u32;
    var phi_1398_: u32;
    var phi_1399_: u32;
    var phi_1411_: bool;
    var phi_1412_: bool;
    var phi_1413_: bool;
    var phi_1414_: bool;
    var phi_1418_: bool;
    var phi_1424_: bool;
    var phi_1432_: u32;
    var phi_1437_: u32;
    var phi_1446_: u32;
    var phi_1451_: u32;
    var phi_1455_: u32;
    var phi_1456_: u32;
    var phi_1457_: u32;
    var phi_1461_: f32;
    var phi_1463_: mask_Masked;
    var phi_1513_: bool;
    var phi_1514_: u32;
    var phi_1525_: u32;
    var local_1: lt_mask_Neighbourhood;

    let _e55 = id_1;
    let _e56 = local_2;
    let _e61 = arrayLength((&last_bits.member));
    let _e68 = p.member.current.size[0u];
    let _e70 = p.member.current.size[1u];
    let _e71 = lt_shaders_entry_pixel_index(_e55, _e68, _e70);
    if (bitcast<i32>(_e71.word) != 0i) {
        let _e78 = p.member.light.number;
        let _e79 = (_e78 * 3u);
        let _e80 = (_e79 / 32u);
        let _e81 = (_e79 % 32u);
        let _e83 = p.member.light.mask_words;
        let _e87 = p.member.current.size[0u];
        let _e90 = samples.member[_e71.shift].position;
        let _e92 = visibility.member[_e71.shift];
        let _e98 = samples.member[_e71.shift].normal[0u];
        let _e100 = global[0u];
        if (_e98 == _e100) {
            let _e103 = samples.member[_e71.shift].normal[1u];
            let _e105 = global[1u];
            if (_e103 == _e105) {
                let _e108 = samples.member[_e71.shift].normal[2u];
                let _e110 = global[2u];
                phi_354_ = (_e108 == _e110);
                phi_355_ = false;
            } else {
                phi_354_ = bool();
                phi_355_ = true;
            }
            let _e113 = phi_354_;
            let _e115 = phi_355_;
            phi_356_ = _e113;
            phi_357_ = _e115;
        } else {
            phi_356_ = bool();
            phi_357_ = true;
        }
        let _e117 = phi_356_;
        let _e119 = phi_357_;
        if _e119 {
            phi_361_ = false;
        } else {
            phi_361_ = _e117;
        }
        let _e121 = phi_361_;
        if !(_e121) {
            let _e124 = samples.member[_e71.shift].position;
            let _e126 = p.member.light.place;
            let _e132 = p.member.light.place[3u];
            let _e139 = (_e126.x - (_e124.x * _e132));
            let _e140 = (_e126.y - (_e124.y * _e132));
            let _e141 = (_e126.z - (_e124.z * _e132));
            let _e143 = samples.member[_e71.shift].normal;
            if ((((_e143.x * _e139) + (_e143.y * _e140)) + (_e143.z * _e141)) > 0f) {
                let _e157 = (((_e139 * _e139) + (_e140 * _e140)) + (_e141 * _e141));
                let _e159 = p.member.light.axis;
                let _e171 = p.member.light.place[3u];
                if (_e171 == 0f) {
                    phi_432_ = true;
                } else {
                    let _e174 = p.member.light.range_squared;
                    if (_e157 <= _e174) {
                        let _e177 = p.member.light.cos_outer;
                        phi_431_ = (-((((_e139 * _e159.x) + (_e140 * _e159.y)) + (_e141 * _e159.z))) >= (_e177 * sqrt(_e157)));
                    } else {
                        phi_431_ = false;
                    }
                    let _e182 = phi_431_;
                    phi_432_ = _e182;
                }
                let _e184 = phi_432_;
                if _e184 {
                    let _e186 = samples.member[_e71.shift].flags;
                    let _e194 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e200 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e194.unnamed.visibility, false), _e194.unnamed_1);
                    phi_443_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e200.unnamed, ((_e186 & 1u) == 0u));
                    phi_444_ = false;
                } else {
                    phi_443_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_444_ = true;
                }
                let _e205 = phi_443_;
                let _e207 = phi_444_;
                phi_445_ = _e205;
                phi_446_ = _e207;
            } else {
                phi_445_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_446_ = true;
            }
            let _e209 = phi_445_;
            let _e211 = phi_446_;
            if _e211 {
                let _e217 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e223 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e217.unnamed.visibility, false), _e217.unnamed_1);
                phi_453_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e223.unnamed, true);
            } else {
                phi_453_ = _e209;
            }
            let _e228 = phi_453_;
            phi_457_ = _e228;
        } else {
            let _e234 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e240 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e234.unnamed.visibility, false), _e234.unnamed_1);
            phi_457_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e240.unnamed, true);
        }
        let _e245 = phi_457_;
        if _e245.unnamed_1 {
            phi_1463_ = mask_Masked(_e245.unnamed.visibility, 0u, false);
        } else {
            let _e250 = (_e92 < 0.5f);
            if (_e92 > 0f) {
                phi_470_ = (_e92 < 1f);
            } else {
                phi_470_ = false;
            }
            let _e254 = phi_470_;
            let _e261 = lt_mask_Reprojection(vec2<u32>(_e55.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e268 = lt_mask_Reprojection(vec2<u32>(_e261.pixel.x, _e55.y), _e261.is_valid, _e261.has_moved);
            let _e272 = lt_mask_Reprojection(_e268.pixel, true, _e268.has_moved);
            let _e278 = p.member.flags;
            if ((_e278 & 16u) == 0u) {
                phi_509_ = false;
            } else {
                let _e284 = samples.member[_e71.shift].position[0u];
                if (_e90.x == _e284) {
                    let _e288 = samples.member[_e71.shift].position[1u];
                    if (_e90.y == _e288) {
                        let _e292 = samples.member[_e71.shift].position[2u];
                        phi_501_ = (_e90.z == _e292);
                        phi_502_ = false;
                    } else {
                        phi_501_ = bool();
                        phi_502_ = true;
                    }
                    let _e295 = phi_501_;
                    let _e297 = phi_502_;
                    phi_503_ = _e295;
                    phi_504_ = _e297;
                } else {
                    phi_503_ = bool();
                    phi_504_ = true;
                }
                let _e299 = phi_503_;
                let _e301 = phi_504_;
                if _e301 {
                    phi_508_ = false;
                } else {
                    phi_508_ = _e299;
                }
                let _e303 = phi_508_;
                phi_509_ = _e303;
            }
            let _e305 = phi_509_;
            if _e305 {
                phi_892_ = lt_mask_Reprojection(_e272.pixel, _e272.is_valid, false);
                phi_893_ = lt_mask_Reprojection();
                phi_894_ = true;
            } else {
                let _e307 = samples.member[_e71.shift].position;
                let _e311 = p.member.previous.eye;
                let _e314 = (_e90.x - _e311.x);
                let _e317 = (_e90.y - _e311.y);
                let _e320 = (_e90.z - _e311.z);
                let _e322 = p.member.previous.forward;
                let _e330 = (((_e314 * _e322.x) + (_e317 * _e322.y)) + (_e320 * _e322.z));
                let _e332 = p.member.previous.right;
                let _e342 = p.member.previous.right;
                let _e357 = p.member.previous.up;
                let _e367 = p.member.previous.up;
                let _e382 = p.member.current.eye;
                let _e385 = (_e307.x - _e382.x);
                let _e388 = (_e307.y - _e382.y);
                let _e391 = (_e307.z - _e382.z);
                let _e393 = p.member.current.forward;
                let _e401 = (((_e385 * _e393.x) + (_e388 * _e393.y)) + (_e391 * _e393.z));
                let _e403 = p.member.current.right;
                let _e413 = p.member.current.right;
                let _e428 = p.member.current.up;
                let _e438 = p.member.current.up;
                let _e457 = p.member.current.size[0u];
                let _e459 = (((((((_e314 * _e332.x) + (_e317 * _e332.y)) + (_e320 * _e332.z)) / ((((_e342.x * _e342.x) + (_e342.y * _e342.y)) + (_e342.z * _e342.z)) * _e330)) - ((((_e385 * _e403.x) + (_e388 * _e403.y)) + (_e391 * _e403.z)) / ((((_e413.x * _e413.x) + (_e413.y * _e413.y)) + (_e413.z * _e413.z)) * _e401))) * 0.5f) * f32(_e457));
                let _e463 = p.member.current.size[1u];
                let _e465 = (((((((_e314 * _e357.x) + (_e317 * _e357.y)) + (_e320 * _e357.z)) / ((((_e367.x * _e367.x) + (_e367.y * _e367.y)) + (_e367.z * _e367.z)) * _e330)) - ((((_e385 * _e428.x) + (_e388 * _e428.y)) + (_e391 * _e428.z)) / ((((_e438.x * _e438.x) + (_e438.y * _e438.y)) + (_e438.z * _e438.z)) * _e401))) * -0.5f) * f32(_e463));
                let _e469 = p.member.current.grid[0u];
                let _e471 = p.member.current.grid[1u];
                let _e491 = p.member.current.size[0u];
                let _e493 = p.member.current.size[1u];
                let _e495 = ((f32(_e55.x) + ((f32((_e55.y & (_e471 - 1u))) + 0.5f) / f32(_e471))) + _e459);
                if (_e495 > -8388608f) {
                    let _e507 = f32(select(0i, select(select(i32(_e495), i32(-2147483648), (_e495 < bitcast<f32>(3472883712u))), 2147483647i, (_e495 > bitcast<f32>(1325400063u))), (_e495 == _e495)));
                    if (_e507 > _e495) {
                        phi_720_ = 1f;
                    } else {
                        phi_720_ = 0f;
                    }
                    let _e510 = phi_720_;
                    if (_e495 < 8388608f) {
                        phi_725_ = (_e507 - _e510);
                        phi_726_ = false;
                    } else {
                        phi_725_ = f32();
                        phi_726_ = true;
                    }
                    let _e513 = phi_725_;
                    let _e515 = phi_726_;
                    phi_727_ = _e513;
                    phi_728_ = _e515;
                } else {
                    phi_727_ = f32();
                    phi_728_ = true;
                }
                let _e517 = phi_727_;
                let _e519 = phi_728_;
                if _e519 {
                    phi_732_ = _e495;
                } else {
                    phi_732_ = _e517;
                }
                let _e521 = phi_732_;
                let _e522 = ((f32(_e55.y) + ((f32((_e55.x & (_e469 - 1u))) + 0.5f) / f32(_e469))) + _e465);
                if (_e522 > -8388608f) {
                    let _e534 = f32(select(0i, select(select(i32(_e522), i32(-2147483648), (_e522 < bitcast<f32>(3472883712u))), 2147483647i, (_e522 > bitcast<f32>(1325400063u))), (_e522 == _e522)));
                    if (_e534 > _e522) {
                        phi_753_ = 1f;
                    } else {
                        phi_753_ = 0f;
                    }
                    let _e537 = phi_753_;
                    if (_e522 < 8388608f) {
                        phi_758_ = (_e534 - _e537);
                        phi_759_ = false;
                    } else {
                        phi_758_ = f32();
                        phi_759_ = true;
                    }
                    let _e540 = phi_758_;
                    let _e542 = phi_759_;
                    phi_760_ = _e540;
                    phi_761_ = _e542;
                } else {
                    phi_760_ = f32();
                    phi_761_ = true;
                }
                let _e544 = phi_760_;
                let _e546 = phi_761_;
                if _e546 {
                    phi_765_ = _e522;
                } else {
                    phi_765_ = _e544;
                }
                let _e548 = phi_765_;
                if (_e521 >= 0f) {
                    if (_e548 >= 0f) {
                        if (_e521 < f32(_e491)) {
                            let _e554 = (_e548 < f32(_e493));
                            if (_e459 == 0f) {
                                phi_786_ = (_e465 == 0f);
                            } else {
                                phi_786_ = false;
                            }
                            let _e558 = phi_786_;
                            if _e554 {
                                phi_805_ = vec2<u32>(select(select(u32(_e521), 0u, (_e521 < bitcast<f32>(0u))), 4294967295u, (_e521 > bitcast<f32>(1333788671u))), select(select(u32(_e548), 0u, (_e548 < bitcast<f32>(0u))), 4294967295u, (_e548 > bitcast<f32>(1333788671u))));
                                phi_806_ = false;
                            } else {
                                phi_805_ = vec2<u32>();
                                phi_806_ = true;
                            }
                            let _e575 = phi_805_;
                            let _e577 = phi_806_;
                            phi_807_ = _e558;
                            phi_808_ = _e554;
                            phi_809_ = _e575;
                            phi_810_ = _e558;
                            phi_811_ = _e554;
                            phi_812_ = false;
                            phi_813_ = _e577;
                        } else {
                            phi_807_ = bool();
                            phi_808_ = bool();
                            phi_809_ = vec2<u32>();
                            phi_810_ = bool();
                            phi_811_ = bool();
                            phi_812_ = true;
                            phi_813_ = false;
                        }
                        let _e579 = phi_807_;
                        let _e581 = phi_808_;
                        let _e583 = phi_809_;
                        let _e585 = phi_810_;
                        let _e587 = phi_811_;
                        let _e589 = phi_812_;
                        let _e591 = phi_813_;
                        phi_814_ = _e579;
                        phi_815_ = _e581;
                        phi_816_ = _e583;
                        phi_817_ = _e585;
                        phi_818_ = _e587;
                        phi_819_ = _e589;
                        phi_820_ = _e591;
                    } else {
                        phi_814_ = bool();
                        phi_815_ = bool();
                        phi_816_ = vec2<u32>();
                        phi_817_ = bool();
                        phi_818_ = bool();
                        phi_819_ = true;
                        phi_820_ = false;
                    }
                    let _e593 = phi_814_;
                    let _e595 = phi_815_;
                    let _e597 = phi_816_;
                    let _e599 = phi_817_;
                    let _e601 = phi_818_;
                    let _e603 = phi_819_;
                    let _e605 = phi_820_;
                    phi_821_ = _e593;
                    phi_822_ = _e595;
                    phi_823_ = _e597;
                    phi_824_ = _e599;
                    phi_825_ = _e601;
                    phi_826_ = _e603;
                    phi_827_ = _e605;
                } else {
                    phi_821_ = bool();
                    phi_822_ = bool();
                    phi_823_ = vec2<u32>();
                    phi_824_ = bool();
                    phi_825_ = bool();
                    phi_826_ = true;
                    phi_827_ = false;
                }
                let _e607 = phi_821_;
                let _e609 = phi_822_;
                let _e611 = phi_823_;
                let _e613 = phi_824_;
                let _e615 = phi_825_;
                let _e617 = phi_826_;
                let _e619 = phi_827_;
                if _e617 {
                    if (_e459 == 0f) {
                        phi_836_ = (_e465 == 0f);
                    } else {
                        phi_836_ = false;
                    }
                    let _e623 = phi_836_;
                    phi_837_ = _e623;
                    phi_838_ = false;
                    phi_839_ = true;
                } else {
                    phi_837_ = _e613;
                    phi_838_ = _e615;
                    phi_839_ = _e619;
                }
                let _e625 = phi_837_;
                let _e627 = phi_838_;
                let _e629 = phi_839_;
                if _e629 {
                    phi_843_ = _e625;
                    phi_844_ = _e627;
                    phi_845_ = vec2<u32>(_e55.x, _e55.y);
                } else {
                    phi_843_ = _e607;
                    phi_844_ = _e609;
                    phi_845_ = _e611;
                }
                let _e631 = phi_843_;
                let _e633 = phi_844_;
                let _e635 = phi_845_;
                let _e645 = lt_mask_Reprojection(vec2<u32>(_e635.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
                let _e652 = lt_mask_Reprojection(vec2<u32>(_e645.pixel.x, _e635.y), _e645.is_valid, _e645.has_moved);
                let _e656 = lt_mask_Reprojection(_e652.pixel, _e633, _e652.has_moved);
                let _e660 = lt_mask_Reprojection(_e656.pixel, _e656.is_valid, !(_e631));
                if _e633 {
                    let _e663 = p.member.previous.eye;
                    let _e674 = p.member.previous.forward;
                    let _e683 = (((((_e90.x - _e663.x) * _e674.x) + ((_e90.y - _e663.y) * _e674.y)) + ((_e90.z - _e663.z) * _e674.z)) > 0f);
                    let _e687 = lt_mask_Reprojection(_e660.pixel, _e683, _e660.has_moved);
                    if _e683 {
                        phi_883_ = false;
                    } else {
                        phi_883_ = true;
                    }
                    let _e689 = phi_883_;
                    phi_885_ = _e687;
                    phi_886_ = _e687;
                    phi_887_ = _e689;
                } else {
                    phi_885_ = lt_mask_Reprojection();
                    phi_886_ = lt_mask_Reprojection(_e660.pixel, false, _e660.has_moved);
                    phi_887_ = true;
                }
                let _e695 = phi_885_;
                let _e697 = phi_886_;
                let _e699 = phi_887_;
                if _e699 {
                    phi_891_ = false;
                } else {
                    phi_891_ = true;
                }
                let _e701 = phi_891_;
                phi_892_ = _e695;
                phi_893_ = _e697;
                phi_894_ = _e701;
            }
            let _e703 = phi_892_;
            let _e705 = phi_893_;
            let _e707 = phi_894_;
            if _e707 {
                let _e709 = p.member.flags;
                phi_902_ = ((_e709 & 1u) != 0u);
                phi_903_ = _e703;
            } else {
                phi_902_ = false;
                phi_903_ = _e705;
            }
            let _e713 = phi_902_;
            let _e715 = phi_903_;
            let _e719 = lt_mask_Reprojection(_e715.pixel, _e713, _e715.has_moved);
            let _e721 = p.member.flags;
            let _e723 = ((_e721 & 2u) != 0u);
            let _e725 = p.member.flags;
            if ((_e725 & 4u) == 0u) {
                phi_977_ = u32();
                phi_978_ = true;
                phi_979_ = false;
            } else {
                if _e713 {
                    if !(_e719.has_moved) {
                        let _e733 = ((((_e55.y * _e87) + _e55.x) * _e83) + _e80);
                        if (_e81 > 29u) {
                            let _e735 = (_e733 + 1u);
                            if (_e735 < _e61) {
                            } else {
                                return;
                            }
                            let _e739 = last_bits.member[(0u + _e735)];
                            phi_944_ = _e739;
                        } else {
                            phi_944_ = 0u;
                        }
                        let _e741 = phi_944_;
                        if (_e733 < _e61) {
                        } else {
                            return;
                        }
                        let _e745 = last_bits.member[(0u + _e733)];
                        let _e748 = (_e745 >> bitcast<u32>((_e81 & 31u)));
                        if (_e81 > 29u) {
                            phi_963_ = (_e748 | (_e741 << bitcast<u32>(((32u - _e81) & 31u))));
                        } else {
                            phi_963_ = _e748;
                        }
                        let _e756 = phi_963_;
                        if ((_e756 & 2u) == 0u) {
                            phi_971_ = (_e756 & 1u);
                        } else {
                            phi_971_ = (_e756 & 7u);
                        }
                        let _e762 = phi_971_;
                        phi_972_ = _e762;
                        phi_973_ = false;
                    } else {
                        phi_972_ = u32();
                        phi_973_ = true;
                    }
                    let _e764 = phi_972_;
                    let _e766 = phi_973_;
                    phi_974_ = _e764;
                    phi_975_ = false;
                    phi_976_ = _e766;
                } else {
                    phi_974_ = u32();
                    phi_975_ = true;
                    phi_976_ = false;
                }
                let _e768 = phi_974_;
                let _e770 = phi_975_;
                let _e772 = phi_976_;
                phi_977_ = _e768;
                phi_978_ = _e770;
                phi_979_ = _e772;
            }
            let _e774 = phi_977_;
            let _e776 = phi_978_;
            let _e778 = phi_979_;
            if _e776 {
                phi_983_ = true;
            } else {
                phi_983_ = _e778;
            }
            let _e780 = phi_983_;
            if _e780 {
                phi_987_ = 0u;
            } else {
                phi_987_ = _e774;
            }
            let _e782 = phi_987_;
            let _e783 = lt_mask_Neighbourhood(false, true);
            if _e254 {
                phi_992_ = _e723;
            } else {
                phi_992_ = true;
            }
            let _e785 = phi_992_;
            if _e785 {
                if _e713 {
                    if ((_e782 & 2u) != 0u) {
                        phi_1285_ = _e783;
                    } else {
                        let _e789 = p.member.expansion;
                        if _e719.has_moved {
                            let _e792 = p.member.moving_pattern;
                            phi_1014_ = _e792;
                        } else {
                            let _e794 = p.member.still_pattern;
                            phi_1014_ = _e794;
                        }
                        let _e796 = phi_1014_;
                        phi_1016_ = 0u;
                        phi_1019_ = _e783;
                        loop {
                            let _e798 = phi_1016_;
                            let _e800 = phi_1019_;
                            local_1 = _e800;
                            if (1u <= _e796) {
                                if (_e796 <= 4u) {
                                    phi_1031_ = false;
                                } else {
                                    phi_1031_ = true;
                                }
                                let _e804 = phi_1031_;
                                phi_1032_ = _e804;
                            } else {
                                phi_1032_ = true;
                            }
                            let _e806 = phi_1032_;
                            if _e806 {
                                switch bitcast<i32>(_e796) {
                                    case 5: {
                                        phi_1041_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_1041_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_1041_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_1041_ = 9u;
                                        break;
                                    }
                                }
                                let _e809 = phi_1041_;
                                phi_1042_ = _e809;
                            } else {
                                phi_1042_ = 5u;
                            }
                            let _e811 = phi_1042_;
                            let _e812 = (_e798 < _e811);
                            if _e812 {
                                let _e818 = p.member.frame;
                                let _e822 = p.member.current.size[0u];
                                let _e824 = p.member.current.size[1u];
                                switch bitcast<i32>(_e796) {
                                    case 1: {
                                        let _e834 = lt_mask_pattern_plus(_e798);
                                        phi_1122_ = vec2<i32>(_e834.x, _e834.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e838 = lt_mask_pattern_cross(_e798);
                                        phi_1122_ = vec2<i32>(_e838.x, _e838.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e844 = lt_mask_pattern_plus_or_cross(_e798, ((_e719.pixel.x + _e719.pixel.y) & 1u));
                                        phi_1122_ = vec2<i32>(_e844.x, _e844.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e849 = lt_mask_pattern_plus_or_cross(_e798, (_e818 & 1u));
                                        phi_1122_ = vec2<i32>(_e849.x, _e849.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e818 & 3u)) {
                                            case 0: {
                                                phi_1102_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_1102_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_1102_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_1102_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e860 = phi_1102_;
                                        phi_1122_ = (_e860 + vec2<i32>(bitcast<i32>((_e798 & 1u)), bitcast<i32>(((_e798 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_1122_ = vec2<i32>((bitcast<i32>((_e798 % 5u)) - 2i), (bitcast<i32>(((_e798 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e877 = lt_mask_pattern_diamond(_e798);
                                        phi_1122_ = vec2<i32>(_e877.x, _e877.y);
                                        break;
                                    }
                                    default: {
                                        phi_1122_ = vec2<i32>((bitcast<i32>((_e798 % 3u)) - 1i), (bitcast<i32>(((_e798 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e882 = phi_1122_;
                                let _e885 = lt_mask_pattern_step_clamped(_e719.pixel.x, _e882.x, _e822);
                                let _e886 = lt_mask_pattern_step_clamped(_e719.pixel.y, _e882.y, _e824);
                                let _e890 = ((((_e886 * _e87) + _e885) * _e83) + _e80);
                                if (_e81 > 29u) {
                                    let _e892 = (_e890 + 1u);
                                    if (_e892 < _e61) {
                                    } else {
                                        return;
                                    }
                                    let _e896 = last_bits.member[(0u + _e892)];
                                    phi_1147_ = _e896;
                                } else {
                                    phi_1147_ = 0u;
                                }
                                let _e898 = phi_1147_;
                                if (_e890 < _e61) {
                                } else {
                                    return;
                                }
                                let _e902 = last_bits.member[(0u + _e890)];
                                let _e905 = (_e902 >> bitcast<u32>((_e81 & 31u)));
                                if (_e81 > 29u) {
                                    phi_1166_ = (_e905 | (_e898 << bitcast<u32>(((32u - _e81) & 31u))));
                                } else {
                                    phi_1166_ = _e905;
                                }
                                let _e913 = phi_1166_;
                                if ((_e913 & 2u) == 0u) {
                                    phi_1174_ = (_e913 & 1u);
                                } else {
                                    phi_1174_ = (_e913 & 7u);
                                }
                                let _e919 = phi_1174_;
                                if _e800.any_expands {
                                    phi_1262_ = true;
                                } else {
                                    if ((_e919 & 2u) != 0u) {
                                        let _e926 = (((_e919 & 4u) != 0u) != _e250);
                                        switch bitcast<i32>(_e789) {
                                            case 1: {
                                                phi_1202_ = bool();
                                                phi_1203_ = false;
                                                phi_1204_ = true;
                                                phi_1205_ = false;
                                                phi_1206_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e926 {
                                                    phi_1200_ = (((_e919 & 4u) != 0u) != ((_e919 & 1u) != 0u));
                                                    phi_1201_ = false;
                                                } else {
                                                    phi_1200_ = bool();
                                                    phi_1201_ = true;
                                                }
                                                let _e934 = phi_1200_;
                                                let _e936 = phi_1201_;
                                                phi_1202_ = _e934;
                                                phi_1203_ = false;
                                                phi_1204_ = false;
                                                phi_1205_ = _e936;
                                                phi_1206_ = _e926;
                                                break;
                                            }
                                            default: {
                                                phi_1202_ = bool();
                                                phi_1203_ = true;
                                                phi_1204_ = false;
                                                phi_1205_ = false;
                                                phi_1206_ = false;
                                                break;
                                            }
                                        }
                                        let _e938 = phi_1202_;
                                        let _e940 = phi_1203_;
                                        let _e942 = phi_1204_;
                                        let _e944 = phi_1205_;
                                        let _e946 = phi_1206_;
                                        phi_1214_ = _e926;
                                        phi_1215_ = _e938;
                                        phi_1216_ = _e940;
                                        phi_1217_ = _e942;
                                        phi_1218_ = _e944;
                                        phi_1219_ = _e946;
                                    } else {
                                        switch bitcast<i32>(_e789) {
                                            case 1: {
                                                phi_1211_ = false;
                                                phi_1212_ = true;
                                                phi_1213_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_1211_ = false;
                                                phi_1212_ = false;
                                                phi_1213_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_1211_ = true;
                                                phi_1212_ = false;
                                                phi_1213_ = false;
                                                break;
                                            }
                                        }
                                        let _e949 = phi_1211_;
                                        let _e951 = phi_1212_;
                                        let _e953 = phi_1213_;
                                        phi_1214_ = false;
                                        phi_1215_ = bool();
                                        phi_1216_ = _e949;
                                        phi_1217_ = _e951;
                                        phi_1218_ = _e953;
                                        phi_1219_ = false;
                                    }
                                    let _e955 = phi_1214_;
                                    let _e957 = phi_1215_;
                                    let _e959 = phi_1216_;
                                    let _e961 = phi_1217_;
                                    let _e963 = phi_1218_;
                                    let _e965 = phi_1219_;
                                    if _e959 {
                                        if ((_e919 & 2u) != 0u) {
                                            if (((_e919 & 4u) != 0u) != _e250) {
                                                phi_1234_ = false;
                                            } else {
                                                phi_1234_ = true;
                                            }
                                            let _e972 = phi_1234_;
                                            phi_1235_ = _e972;
                                        } else {
                                            phi_1235_ = true;
                                        }
                                        let _e974 = phi_1235_;
                                        if _e974 {
                                            phi_1242_ = (((_e919 & 1u) != 0u) != _e250);
                                        } else {
                                            phi_1242_ = true;
                                        }
                                        let _e979 = phi_1242_;
                                        phi_1243_ = _e979;
                                        phi_1244_ = false;
                                        phi_1245_ = false;
                                        phi_1246_ = false;
                                    } else {
                                        phi_1243_ = bool();
                                        phi_1244_ = _e961;
                                        phi_1245_ = _e963;
                                        phi_1246_ = _e965;
                                    }
                                    let _e981 = phi_1243_;
                                    let _e983 = phi_1244_;
                                    let _e985 = phi_1245_;
                                    let _e987 = phi_1246_;
                                    if _e983 {
                                        phi_1250_ = _e955;
                                        phi_1251_ = false;
                                        phi_1252_ = false;
                                    } else {
                                        phi_1250_ = _e981;
                                        phi_1251_ = _e985;
                                        phi_1252_ = _e987;
                                    }
                                    let _e989 = phi_1250_;
                                    let _e991 = phi_1251_;
                                    let _e993 = phi_1252_;
                                    if _e991 {
                                        phi_1256_ = false;
                                        phi_1257_ = true;
                                    } else {
                                        phi_1256_ = _e957;
                                        phi_1257_ = _e993;
                                    }
                                    let _e995 = phi_1256_;
                                    let _e997 = phi_1257_;
                                    if _e997 {
                                        phi_1261_ = _e995;
                                    } else {
                                        phi_1261_ = _e989;
                                    }
                                    let _e999 = phi_1261_;
                                    phi_1262_ = _e999;
                                }
                                let _e1001 = phi_1262_;
                                if _e800.all_remove {
                                    if (((_e919 & 1u) != 0u) == _e250) {
                                        if ((_e919 & 2u) != 0u) {
                                            phi_1280_ = (((_e919 & 4u) != 0u) == _e250);
                                        } else {
                                            phi_1280_ = true;
                                        }
                                        let _e1011 = phi_1280_;
                                        phi_1281_ = _e1011;
                                    } else {
                                        phi_1281_ = false;
                                    }
                                    let _e1013 = phi_1281_;
                                    phi_1282_ = _e1013;
                                } else {
                                    phi_1282_ = false;
                                }
                                let _e1015 = phi_1282_;
                                phi_1017_ = (_e798 + 1u);
                                phi_1020_ = lt_mask_Neighbourhood(_e1001, _e1015);
                            } else {
                                phi_1017_ = u32();
                                phi_1020_ = lt_mask_Neighbourhood();
                            }
                            let _e1019 = phi_1017_;
                            let _e1021 = phi_1020_;
                            continue;
                            continuing {
                                phi_1016_ = _e1019;
                                phi_1019_ = _e1021;
                                break if !(_e812);
                            }
                        }
                        let _e1331 = local_1;
                        phi_1285_ = _e1331;
                    }
                    let _e1024 = phi_1285_;
                    phi_1286_ = _e1024;
                } else {
                    phi_1286_ = _e783;
                }
                let _e1026 = phi_1286_;
                phi_1287_ = _e1026;
            } else {
                phi_1287_ = _e783;
            }
            let _e1028 = phi_1287_;
            let _e1031 = p.member.frame;
            let _e1033 = p.member.refresh;
            if (_e1033 == 0u) {
                phi_1320_ = false;
            } else {
                if (_e1033 == 0u) {
                    return;
                }
                let _e1042 = ((_e55.x + (_e55.y * (((_e1033 * 5u) / 8u) | 1u))) + (_e1031 % _e1033));
                if (_e1033 == 0u) {
                    phi_1319_ = (_e1042 == 0u);
                } else {
                    if (_e1033 == 0u) {
                        return;
                    }
                    phi_1319_ = ((_e1042 % _e1033) == 0u);
                }
                let _e1049 = phi_1319_;
                phi_1320_ = _e1049;
            }
            let _e1051 = phi_1320_;
            if _e713 {
                if _e1051 {
                    phi_1342_ = bool();
                } else {
                    phi_1342_ = ((_e782 & 2u) != 0u);
                }
                let _e1057 = phi_1342_;
                phi_1343_ = _e1057;
                phi_1344_ = _e1051;
            } else {
                phi_1343_ = bool();
                phi_1344_ = true;
            }
            let _e1059 = phi_1343_;
            let _e1061 = phi_1344_;
            if _e1061 {
                phi_1348_ = false;
            } else {
                phi_1348_ = _e1059;
            }
            let _e1063 = phi_1348_;
            if _e1063 {
                phi_1399_ = 7u;
            } else {
                if (_e92 != 0.5f) {
                    if _e713 {
                        if _e1051 {
                            phi_1396_ = 6u;
                        } else {
                            if _e254 {
                                phi_1371_ = true;
                            } else {
                                if _e1028.any_expands {
                                    phi_1370_ = false;
                                } else {
                                    phi_1370_ = true;
                                }
                                let _e1065 = phi_1370_;
                                phi_1371_ = _e1065;
                            }
                            let _e1067 = phi_1371_;
                            if _e1067 {
                                if _e254 {
                                    if _e723 {
                                        if _e1028.all_remove {
                                            phi_1384_ = false;
                                        } else {
                                            phi_1384_ = true;
                                        }
                                        let _e1069 = phi_1384_;
                                        phi_1385_ = _e1069;
                                    } else {
                                        phi_1385_ = true;
                                    }
                                    let _e1071 = phi_1385_;
                                    phi_1386_ = _e1071;
                                } else {
                                    phi_1386_ = true;
                                }
                                let _e1073 = phi_1386_;
                                if _e1073 {
                                    if _e254 {
                                        phi_1393_ = 1u;
                                    } else {
                                        phi_1393_ = 0u;
                                    }
                                    let _e1075 = phi_1393_;
                                    phi_1394_ = _e1075;
                                } else {
                                    phi_1394_ = 5u;
                                }
                                let _e1077 = phi_1394_;
                                phi_1395_ = _e1077;
                            } else {
                                phi_1395_ = 4u;
                            }
                            let _e1079 = phi_1395_;
                            phi_1396_ = _e1079;
                        }
                        let _e1081 = phi_1396_;
                        phi_1397_ = _e1081;
                    } else {
                        phi_1397_ = 3u;
                    }
                    let _e1083 = phi_1397_;
                    phi_1398_ = _e1083;
                } else {
                    phi_1398_ = 2u;
                }
                let _e1085 = phi_1398_;
                phi_1399_ = _e1085;
            }
            let _e1087 = phi_1399_;
            if !((_e1087 == 0u)) {
                if !((_e1087 == 5u)) {
                    phi_1411_ = !(_e1063);
                    phi_1412_ = false;
                } else {
                    phi_1411_ = bool();
                    phi_1412_ = true;
                }
                let _e1094 = phi_1411_;
                let _e1096 = phi_1412_;
                phi_1413_ = _e1094;
                phi_1414_ = _e1096;
            } else {
                phi_1413_ = bool();
                phi_1414_ = true;
            }
            let _e1098 = phi_1413_;
            let _e1100 = phi_1414_;
            if _e1100 {
                phi_1418_ = false;
            } else {
                phi_1418_ = _e1098;
            }
            let _e1102 = phi_1418_;
            if _e1063 {
                phi_1424_ = ((_e782 & 4u) != 0u);
            } else {
                phi_1424_ = _e250;
            }
            let _e1106 = phi_1424_;
            if _e1102 {
                if _e250 {
                    phi_1432_ = (2u | 1u);
                } else {
                    phi_1432_ = 2u;
                }
                let _e1109 = phi_1432_;
                if false {
                    phi_1437_ = (_e1109 | 4u);
                } else {
                    phi_1437_ = _e1109;
                }
                let _e1112 = phi_1437_;
                phi_1457_ = _e1112;
            } else {
                if (_e1087 == 7u) {
                    if _e250 {
                        phi_1446_ = (2u | 1u);
                    } else {
                        phi_1446_ = 2u;
                    }
                    let _e1116 = phi_1446_;
                    if _e1106 {
                        phi_1451_ = (_e1116 | 4u);
                    } else {
                        phi_1451_ = _e1116;
                    }
                    let _e1119 = phi_1451_;
                    phi_1456_ = _e1119;
                } else {
                    if _e250 {
                        phi_1455_ = 1u;
                    } else {
                        phi_1455_ = 0u;
                    }
                    let _e1121 = phi_1455_;
                    phi_1456_ = _e1121;
                }
                let _e1123 = phi_1456_;
                phi_1457_ = _e1123;
            }
            let _e1125 = phi_1457_;
            if _e1106 {
                phi_1461_ = 0f;
            } else {
                phi_1461_ = 1f;
            }
            let _e1127 = phi_1461_;
            phi_1463_ = mask_Masked(_e1127, _e1125, _e1102);
        }
        let _e1130 = phi_1463_;
        visibility.member[_e71.shift] = _e1130.visibility;
        let _e1135 = p.member.light.number;
        let _e1136 = (_e1135 * 3u);
        let _e1138 = (_e1136 % 32u);
        let _e1140 = p.member.light.mask_words;
        let _e1142 = ((_e71.shift * _e1140) + (_e1136 / 32u));
        let _e1144 = bits.member[_e1142];
        bits.member[_e1142] = ((_e1144 & ~((7u << bitcast<u32>((_e1138 & 31u))))) | (_e1130.bits << bitcast<u32>((_e1138 & 31u))));
        if (_e1138 > 29u) {
            let _e1159 = bits.member[(_e1142 + 1u)];
            let _e1161 = (32u - _e1138);
            bits.member[(_e1142 + 1u)] = ((_e1159 & ~((7u >> bitcast<u32>((_e1161 & 31u))))) | (_e1130.bits >> bitcast<u32>((_e1161 & 31u))));
        }
        phi_1513_ = _e1130.needs_ray;
        phi_1514_ = _e71.shift;
    } else {
        phi_1513_ = false;
        phi_1514_ = 0u;
    }
    let _e1175 = phi_1513_;
    let _e1177 = phi_1514_;
    if (_e56 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1175 {
        let _e1181 = atomicAdd((&shared_[0u]), 1u);
        phi_1525_ = _e1181;
    } else {
        phi_1525_ = 0u;
    }
    let _e1183 = phi_1525_;
    workgroupBarrier();
    if (_e56 == 0u) {
        let _e1187 = atomicLoad((&shared_[0u]));
        let _e1188 = atomicAdd((&list.member[3u]), _e1187);
        atomicStore((&shared_[1u]), _e1188);
    }
    workgroupBarrier();
    if _e1175 {
        let _e1191 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1191) + _e1183)]), _e1177);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
