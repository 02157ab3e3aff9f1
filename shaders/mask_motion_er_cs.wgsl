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
    var phi_909_: bool;
    var phi_931_: u32;
    var phi_933_: u32;
    var phi_936_: lt_mask_Neighbourhood;
    var phi_948_: bool;
    var phi_949_: bool;
    var phi_958_: u32;
    var phi_959_: u32;
    var phi_1019_: vec2<i32>;
    var phi_1039_: vec2<i32>;
    var phi_1064_: u32;
    var phi_1083_: u32;
    var phi_1091_: u32;
    var phi_1117_: bool;
    var phi_1118_: bool;
    var phi_1119_: bool;
    var phi_1120_: bool;
    var phi_1121_: bool;
    var phi_1122_: bool;
    var phi_1123_: bool;
    var phi_1128_: bool;
    var phi_1129_: bool;
    var phi_1130_: bool;
    var phi_1131_: bool;
    var phi_1132_: bool;
    var phi_1133_: bool;
    var phi_1134_: bool;
    var phi_1135_: bool;
    var phi_1136_: bool;
    var phi_1151_: bool;
    var phi_1152_: bool;
    var phi_1159_: bool;
    var phi_1160_: bool;
    var phi_1161_: bool;
    var phi_1162_: bool;
    var phi_1163_: bool;
    var phi_1167_: bool;
    var phi_1168_: bool;
    var phi_1169_: bool;
    var phi_1173_: bool;
    var phi_1174_: bool;
    var phi_1178_: bool;
    var phi_1179_: bool;
    var phi_1197_: bool;
    var phi_1198_: bool;
    var phi_1199_: bool;
    var phi_934_: u32;
    var phi_937_: lt_mask_Neighbourhood;
    var phi_1202_: lt_mask_Neighbourhood;
    var phi_1203_: lt_mask_Neighbourhood;
    var phi_1204_: lt_mask_Neighbourhood;
    var phi_1236_: bool;
    var phi_1237_: bool;
    var phi_1259_: bool;
    var phi_1260_: bool;
    var phi_1261_: bool;
    var phi_1265_: bool;
    var phi_1287_: bool;
    var phi_1288_: bool;
    var phi_1301_: bool;
    var phi_1302_: bool;
    var phi_1303_: bool;
    var phi_1310_: u32;
    var phi_1311_: u32;
    var phi_1312_: u32;
    var phi_1313_: u32;
    var phi_1314_: u32;
    var phi_1315_: u32;
    var phi_1316_: u32;
    var phi_1328_: bool;
    var phi_1329_: bool;
    var phi_1330_: bool;
    var phi_1331_: bool;
    var phi_1335_: bool;
    var phi_1341_: bool;
    var phi_1349_: u32;
    var phi_1354_: u32;
    var phi_1363_: u32;
    var phi_1368_: u32;
    var phi_1372_: u32;
    var phi_1373_: u32;
    var phi_1374_: u32;
    var phi_1378_: f32;
    var phi_1380_: mask_Masked;
    var phi_1430_: bool;
    var phi_1431_: u32;
    var phi_1442_: u32;
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
            phi_1380_ = mask_Masked(_e245.unnamed.visibility, 0u, false);
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
            let _e720 = lt_mask_Neighbourhood(false, true);
            if _e254 {
                phi_909_ = false;
            } else {
                phi_909_ = true;
            }
            let _e722 = phi_909_;
            if _e722 {
                if _e713 {
                    if ((0u & 2u) != 0u) {
                        phi_1202_ = _e720;
                    } else {
                        let _e726 = p.member.expansion;
                        if _e719.has_moved {
                            let _e729 = p.member.moving_pattern;
                            phi_931_ = _e729;
                        } else {
                            let _e731 = p.member.still_pattern;
                            phi_931_ = _e731;
                        }
                        let _e733 = phi_931_;
                        phi_933_ = 0u;
                        phi_936_ = _e720;
                        loop {
                            let _e735 = phi_933_;
                            let _e737 = phi_936_;
                            local_1 = _e737;
                            if (1u <= _e733) {
                                if (_e733 <= 4u) {
                                    phi_948_ = false;
                                } else {
                                    phi_948_ = true;
                                }
                                let _e741 = phi_948_;
                                phi_949_ = _e741;
                            } else {
                                phi_949_ = true;
                            }
                            let _e743 = phi_949_;
                            if _e743 {
                                switch bitcast<i32>(_e733) {
                                    case 5: {
                                        phi_958_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_958_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_958_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_958_ = 9u;
                                        break;
                                    }
                                }
                                let _e746 = phi_958_;
                                phi_959_ = _e746;
                            } else {
                                phi_959_ = 5u;
                            }
                            let _e748 = phi_959_;
                            let _e749 = (_e735 < _e748);
                            if _e749 {
                                let _e755 = p.member.frame;
                                let _e759 = p.member.current.size[0u];
                                let _e761 = p.member.current.size[1u];
                                switch bitcast<i32>(_e733) {
                                    case 1: {
                                        let _e771 = lt_mask_pattern_plus(_e735);
                                        phi_1039_ = vec2<i32>(_e771.x, _e771.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e775 = lt_mask_pattern_cross(_e735);
                                        phi_1039_ = vec2<i32>(_e775.x, _e775.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e781 = lt_mask_pattern_plus_or_cross(_e735, ((_e719.pixel.x + _e719.pixel.y) & 1u));
                                        phi_1039_ = vec2<i32>(_e781.x, _e781.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e786 = lt_mask_pattern_plus_or_cross(_e735, (_e755 & 1u));
                                        phi_1039_ = vec2<i32>(_e786.x, _e786.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e755 & 3u)) {
                                            case 0: {
                                                phi_1019_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_1019_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_1019_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_1019_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e797 = phi_1019_;
                                        phi_1039_ = (_e797 + vec2<i32>(bitcast<i32>((_e735 & 1u)), bitcast<i32>(((_e735 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_1039_ = vec2<i32>((bitcast<i32>((_e735 % 5u)) - 2i), (bitcast<i32>(((_e735 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e814 = lt_mask_pattern_diamond(_e735);
                                        phi_1039_ = vec2<i32>(_e814.x, _e814.y);
                                        break;
                                    }
                                    default: {
                                        phi_1039_ = vec2<i32>((bitcast<i32>((_e735 % 3u)) - 1i), (bitcast<i32>(((_e735 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e819 = phi_1039_;
                                let _e822 = lt_mask_pattern_step_clamped(_e719.pixel.x, _e819.x, _e759);
                                let _e823 = lt_mask_pattern_step_clamped(_e719.pixel.y, _e819.y, _e761);
                                let _e827 = ((((_e823 * _e87) + _e822) * _e83) + (_e79 / 32u));
                                if (_e81 > 29u) {
                                    let _e829 = (_e827 + 1u);
                                    if (_e829 < _e61) {
                                    } else {
                                        return;
                                    }
                                    let _e833 = last_bits.member[(0u + _e829)];
                                    phi_1064_ = _e833;
                                } else {
                                    phi_1064_ = 0u;
                                }
                                let _e835 = phi_1064_;
                                if (_e827 < _e61) {
                                } else {
                                    return;
                                }
                                let _e839 = last_bits.member[(0u + _e827)];
                                let _e842 = (_e839 >> bitcast<u32>((_e81 & 31u)));
                                if (_e81 > 29u) {
                                    phi_1083_ = (_e842 | (_e835 << bitcast<u32>(((32u - _e81) & 31u))));
                                } else {
                                    phi_1083_ = _e842;
                                }
                                let _e850 = phi_1083_;
                                if ((_e850 & 2u) == 0u) {
                                    phi_1091_ = (_e850 & 1u);
                                } else {
                                    phi_1091_ = (_e850 & 7u);
                                }
                                let _e856 = phi_1091_;
                                if _e737.any_expands {
                                    phi_1179_ = true;
                                } else {
                                    if ((_e856 & 2u) != 0u) {
                                        let _e863 = (((_e856 & 4u) != 0u) != _e250);
                                        switch bitcast<i32>(_e726) {
                                            case 1: {
                                                phi_1119_ = bool();
                                                phi_1120_ = false;
                                                phi_1121_ = true;
                                                phi_1122_ = false;
                                                phi_1123_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e863 {
                                                    phi_1117_ = (((_e856 & 4u) != 0u) != ((_e856 & 1u) != 0u));
                                                    phi_1118_ = false;
                                                } else {
                                                    phi_1117_ = bool();
                                                    phi_1118_ = true;
                                                }
                                                let _e871 = phi_1117_;
                                                let _e873 = phi_1118_;
                                                phi_1119_ = _e871;
                                                phi_1120_ = false;
                                                phi_1121_ = false;
                                                phi_1122_ = _e873;
                                                phi_1123_ = _e863;
                                                break;
                                            }
                                            default: {
                                                phi_1119_ = bool();
                                                phi_1120_ = true;
                                                phi_1121_ = false;
                                                phi_1122_ = false;
                                                phi_1123_ = false;
                                                break;
                                            }
                                        }
                                        let _e875 = phi_1119_;
                                        let _e877 = phi_1120_;
                                        let _e879 = phi_1121_;
                                        let _e881 = phi_1122_;
                                        let _e883 = phi_1123_;
                                        phi_1131_ = _e863;
                                        phi_1132_ = _e875;
                                        phi_1133_ = _e877;
                                        phi_1134_ = _e879;
                                        phi_1135_ = _e881;
                                        phi_1136_ = _e883;
                                    } else {
                                        switch bitcast<i32>(_e726) {
                                            case 1: {
                                                phi_1128_ = false;
                                                phi_1129_ = true;
                                                phi_1130_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_1128_ = false;
                                                phi_1129_ = false;
                                                phi_1130_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_1128_ = true;
                                                phi_1129_ = false;
                                                phi_1130_ = false;
                                                break;
                                            }
                                        }
                                        let _e886 = phi_1128_;
                                        let _e888 = phi_1129_;
                                        let _e890 = phi_1130_;
                                        phi_1131_ = false;
                                        phi_1132_ = bool();
                                        phi_1133_ = _e886;
                                        phi_1134_ = _e888;
                                        phi_1135_ = _e890;
                                        phi_1136_ = false;
                                    }
                                    let _e892 = phi_1131_;
                                    let _e894 = phi_1132_;
                                    let _e896 = phi_1133_;
                                    let _e898 = phi_1134_;
                                    let _e900 = phi_1135_;
                                    let _e902 = phi_1136_;
                                    if _e896 {
                                        if ((_e856 & 2u) != 0u) {
                                            if (((_e856 & 4u) != 0u) != _e250) {
                                                phi_1151_ = false;
                                            } else {
                                                phi_1151_ = true;
                                            }
                                            let _e909 = phi_1151_;
                                            phi_1152_ = _e909;
                                        } else {
                                            phi_1152_ = true;
                                        }
                                        let _e911 = phi_1152_;
                                        if _e911 {
                                            phi_1159_ = (((_e856 & 1u) != 0u) != _e250);
                                        } else {
                                            phi_1159_ = true;
                                        }
                                        let _e916 = phi_1159_;
                                        phi_1160_ = _e916;
                                        phi_1161_ = false;
                                        phi_1162_ = false;
                                        phi_1163_ = false;
                                    } else {
                                        phi_1160_ = bool();
                                        phi_1161_ = _e898;
                                        phi_1162_ = _e900;
                                        phi_1163_ = _e902;
                                    }
                                    let _e918 = phi_1160_;
                                    let _e920 = phi_1161_;
                                    let _e922 = phi_1162_;
                                    let _e924 = phi_1163_;
                                    if _e920 {
                                        phi_1167_ = _e892;
                                        phi_1168_ = false;
                                        phi_1169_ = false;
                                    } else {
                                        phi_1167_ = _e918;
                                        phi_1168_ = _e922;
                                        phi_1169_ = _e924;
                                    }
                                    let _e926 = phi_1167_;
                                    let _e928 = phi_1168_;
                                    let _e930 = phi_1169_;
                                    if _e928 {
                                        phi_1173_ = false;
                                        phi_1174_ = true;
                                    } else {
                                        phi_1173_ = _e894;
                                        phi_1174_ = _e930;
                                    }
                                    let _e932 = phi_1173_;
                                    let _e934 = phi_1174_;
                                    if _e934 {
                                        phi_1178_ = _e932;
                                    } else {
                                        phi_1178_ = _e926;
                                    }
                                    let _e936 = phi_1178_;
                                    phi_1179_ = _e936;
                                }
                                let _e938 = phi_1179_;
                                if _e737.all_remove {
                                    if (((_e856 & 1u) != 0u) == _e250) {
                                        if ((_e856 & 2u) != 0u) {
                                            phi_1197_ = (((_e856 & 4u) != 0u) == _e250);
                                        } else {
                                            phi_1197_ = true;
                                        }
                                        let _e948 = phi_1197_;
                                        phi_1198_ = _e948;
                                    } else {
                                        phi_1198_ = false;
                                    }
                                    let _e950 = phi_1198_;
                                    phi_1199_ = _e950;
                                } else {
                                    phi_1199_ = false;
                                }
                                let _e952 = phi_1199_;
                                phi_934_ = (_e735 + 1u);
                                phi_937_ = lt_mask_Neighbourhood(_e938, _e952);
                            } else {
                                phi_934_ = u32();
                                phi_937_ = lt_mask_Neighbourhood();
                            }
                            let _e956 = phi_934_;
                            let _e958 = phi_937_;
                            continue;
                            continuing {
                                phi_933_ = _e956;
                                phi_936_ = _e958;
                                break if !(_e749);
                            }
                        }
                        let _e1255 = local_1;
                        phi_1202_ = _e1255;
                    }
                    let _e961 = phi_1202_;
                    phi_1203_ = _e961;
                } else {
                    phi_1203_ = _e720;
                }
                let _e963 = phi_1203_;
                phi_1204_ = _e963;
            } else {
                phi_1204_ = _e720;
            }
            let _e965 = phi_1204_;
            let _e968 = p.member.frame;
            let _e970 = p.member.refresh;
            if (_e970 == 0u) {
                phi_1237_ = false;
            } else {
                if (_e970 == 0u) {
                    return;
                }
                let _e979 = ((_e55.x + (_e55.y * (((_e970 * 5u) / 8u) | 1u))) + (_e968 % _e970));
                if (_e970 == 0u) {
                    phi_1236_ = (_e979 == 0u);
                } else {
                    if (_e970 == 0u) {
                        return;
                    }
                    phi_1236_ = ((_e979 % _e970) == 0u);
                }
                let _e986 = phi_1236_;
                phi_1237_ = _e986;
            }
            let _e988 = phi_1237_;
            if _e713 {
                if _e988 {
                    phi_1259_ = bool();
                } else {
                    phi_1259_ = ((0u & 2u) != 0u);
                }
                let _e994 = phi_1259_;
                phi_1260_ = _e994;
                phi_1261_ = _e988;
            } else {
                phi_1260_ = bool();
                phi_1261_ = true;
            }
            let _e996 = phi_1260_;
            let _e998 = phi_1261_;
            if _e998 {
                phi_1265_ = false;
            } else {
                phi_1265_ = _e996;
            }
            let _e1000 = phi_1265_;
            if _e1000 {
                phi_1316_ = 7u;
            } else {
                if (_e92 != 0.5f) {
                    if _e713 {
                        if _e988 {
                            phi_1313_ = 6u;
                        } else {
                            if _e254 {
                                phi_1288_ = true;
                            } else {
                                if _e965.any_expands {
                                    phi_1287_ = false;
                                } else {
                                    phi_1287_ = true;
                                }
                                let _e1002 = phi_1287_;
                                phi_1288_ = _e1002;
                            }
                            let _e1004 = phi_1288_;
                            if _e1004 {
                                if _e254 {
                                    if false {
                                        if _e965.all_remove {
                                            phi_1301_ = false;
                                        } else {
                                            phi_1301_ = true;
                                        }
                                        let _e1006 = phi_1301_;
                                        phi_1302_ = _e1006;
                                    } else {
                                        phi_1302_ = true;
                                    }
                                    let _e1008 = phi_1302_;
                                    phi_1303_ = _e1008;
                                } else {
                                    phi_1303_ = true;
                                }
                                let _e1010 = phi_1303_;
                                if _e1010 {
                                    if _e254 {
                                        phi_1310_ = 1u;
                                    } else {
                                        phi_1310_ = 0u;
                                    }
                                    let _e1012 = phi_1310_;
                                    phi_1311_ = _e1012;
                                } else {
                                    phi_1311_ = 5u;
                                }
                                let _e1014 = phi_1311_;
                                phi_1312_ = _e1014;
                            } else {
                                phi_1312_ = 4u;
                            }
                            let _e1016 = phi_1312_;
                            phi_1313_ = _e1016;
                        }
                        let _e1018 = phi_1313_;
                        phi_1314_ = _e1018;
                    } else {
                        phi_1314_ = 3u;
                    }
                    let _e1020 = phi_1314_;
                    phi_1315_ = _e1020;
                } else {
                    phi_1315_ = 2u;
                }
                let _e1022 = phi_1315_;
                phi_1316_ = _e1022;
            }
            let _e1024 = phi_1316_;
            if !((_e1024 == 0u)) {
                if !((_e1024 == 5u)) {
                    phi_1328_ = !(_e1000);
                    phi_1329_ = false;
                } else {
                    phi_1328_ = bool();
                    phi_1329_ = true;
                }
                let _e1031 = phi_1328_;
                let _e1033 = phi_1329_;
                phi_1330_ = _e1031;
                phi_1331_ = _e1033;
            } else {
                phi_1330_ = bool();
                phi_1331_ = true;
            }
            let _e1035 = phi_1330_;
            let _e1037 = phi_1331_;
            if _e1037 {
                phi_1335_ = false;
            } else {
                phi_1335_ = _e1035;
            }
            let _e1039 = phi_1335_;
            if _e1000 {
                phi_1341_ = ((0u & 4u) != 0u);
            } else {
                phi_1341_ = _e250;
            }
            let _e1043 = phi_1341_;
            if _e1039 {
                if _e250 {
                    phi_1349_ = (2u | 1u);
                } else {
                    phi_1349_ = 2u;
                }
                let _e1046 = phi_1349_;
                if false {
                    phi_1354_ = (_e1046 | 4u);
                } else {
                    phi_1354_ = _e1046;
                }
                let _e1049 = phi_1354_;
                phi_1374_ = _e1049;
            } else {
                if (_e1024 == 7u) {
                    if _e250 {
                        phi_1363_ = (2u | 1u);
                    } else {
                        phi_1363_ = 2u;
                    }
                    let _e1053 = phi_1363_;
                    if _e1043 {
                        phi_1368_ = (_e1053 | 4u);
                    } else {
                        phi_1368_ = _e1053;
                    }
                    let _e1056 = phi_1368_;
                    phi_1373_ = _e1056;
                } else {
                    if _e250 {
                        phi_1372_ = 1u;
                    } else {
                        phi_1372_ = 0u;
                    }
                    let _e1058 = phi_1372_;
                    phi_1373_ = _e1058;
                }
                let _e1060 = phi_1373_;
                phi_1374_ = _e1060;
            }
            let _e1062 = phi_1374_;
            if _e1043 {
                phi_1378_ = 0f;
            } else {
                phi_1378_ = 1f;
            }
            let _e1064 = phi_1378_;
            phi_1380_ = mask_Masked(_e1064, _e1062, _e1039);
        }
        let _e1067 = phi_1380_;
        visibility.member[_e71.shift] = _e1067.visibility;
        let _e1072 = p.member.light.number;
        let _e1073 = (_e1072 * 3u);
        let _e1075 = (_e1073 % 32u);
        let _e1077 = p.member.light.mask_words;
        let _e1079 = ((_e71.shift * _e1077) + (_e1073 / 32u));
        let _e1081 = bits.member[_e1079];
        bits.member[_e1079] = ((_e1081 & ~((7u << bitcast<u32>((_e1075 & 31u))))) | (_e1067.bits << bitcast<u32>((_e1075 & 31u))));
        if (_e1075 > 29u) {
            let _e1096 = bits.member[(_e1079 + 1u)];
            let _e1098 = (32u - _e1075);
            bits.member[(_e1079 + 1u)] = ((_e1096 & ~((7u >> bitcast<u32>((_e1098 & 31u))))) | (_e1067.bits >> bitcast<u32>((_e1098 & 31u))));
        }
        phi_1430_ = _e1067.needs_ray;
        phi_1431_ = _e71.shift;
    } else {
        phi_1430_ = false;
        phi_1431_ = 0u;
    }
    let _e1112 = phi_1430_;
    let _e1114 = phi_1431_;
    if (_e56 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1112 {
        let _e1118 = atomicAdd((&shared_[0u]), 1u);
        phi_1442_ = _e1118;
    } else {
        phi_1442_ = 0u;
    }
    let _e1120 = phi_1442_;
    workgroupBarrier();
    if (_e56 == 0u) {
        let _e1124 = atomicLoad((&shared_[0u]));
        let _e1125 = atomicAdd((&list.member[3u]), _e1124);
        atomicStore((&shared_[1u]), _e1125);
    }
    workgroupBarrier();
    if _e1112 {
        let _e1128 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1128) + _e1120)]), _e1114);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
