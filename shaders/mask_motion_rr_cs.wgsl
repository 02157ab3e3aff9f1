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
    var phi_512_: bool;
    var phi_513_: bool;
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
    var phi_887_: bool;
    var phi_889_: lt_mask_Reprojection;
    var phi_890_: lt_mask_Reprojection;
    var phi_891_: bool;
    var phi_895_: bool;
    var phi_896_: lt_mask_Reprojection;
    var phi_897_: lt_mask_Reprojection;
    var phi_898_: bool;
    var phi_906_: bool;
    var phi_907_: lt_mask_Reprojection;
    var phi_948_: u32;
    var phi_967_: u32;
    var phi_975_: u32;
    var phi_976_: u32;
    var phi_977_: bool;
    var phi_978_: u32;
    var phi_979_: bool;
    var phi_980_: bool;
    var phi_981_: u32;
    var phi_982_: bool;
    var phi_983_: bool;
    var phi_987_: bool;
    var phi_991_: u32;
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
    var phi_1021_: u32;
    var phi_1024_: lt_mask_Neighbourhood;
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
    var phi_1517_: bool;
    var phi_1518_: u32;
    var phi_1529_: u32;
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
            phi_1467_ = mask_Masked(_e245.unnamed.visibility, 0u, false);
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
                phi_513_ = true;
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
                if _e303 {
                    phi_512_ = false;
                } else {
                    phi_512_ = true;
                }
                let _e305 = phi_512_;
                phi_513_ = _e305;
            }
            let _e307 = phi_513_;
            if _e307 {
                let _e309 = samples.member[_e71.shift].position;
                let _e313 = p.member.previous.eye;
                let _e316 = (_e90.x - _e313.x);
                let _e319 = (_e90.y - _e313.y);
                let _e322 = (_e90.z - _e313.z);
                let _e324 = p.member.previous.forward;
                let _e332 = (((_e316 * _e324.x) + (_e319 * _e324.y)) + (_e322 * _e324.z));
                let _e334 = p.member.previous.right;
                let _e344 = p.member.previous.right;
                let _e359 = p.member.previous.up;
                let _e369 = p.member.previous.up;
                let _e384 = p.member.current.eye;
                let _e387 = (_e309.x - _e384.x);
                let _e390 = (_e309.y - _e384.y);
                let _e393 = (_e309.z - _e384.z);
                let _e395 = p.member.current.forward;
                let _e403 = (((_e387 * _e395.x) + (_e390 * _e395.y)) + (_e393 * _e395.z));
                let _e405 = p.member.current.right;
                let _e415 = p.member.current.right;
                let _e430 = p.member.current.up;
                let _e440 = p.member.current.up;
                let _e459 = p.member.current.size[0u];
                let _e461 = (((((((_e316 * _e334.x) + (_e319 * _e334.y)) + (_e322 * _e334.z)) / ((((_e344.x * _e344.x) + (_e344.y * _e344.y)) + (_e344.z * _e344.z)) * _e332)) - ((((_e387 * _e405.x) + (_e390 * _e405.y)) + (_e393 * _e405.z)) / ((((_e415.x * _e415.x) + (_e415.y * _e415.y)) + (_e415.z * _e415.z)) * _e403))) * 0.5f) * f32(_e459));
                let _e465 = p.member.current.size[1u];
                let _e467 = (((((((_e316 * _e359.x) + (_e319 * _e359.y)) + (_e322 * _e359.z)) / ((((_e369.x * _e369.x) + (_e369.y * _e369.y)) + (_e369.z * _e369.z)) * _e332)) - ((((_e387 * _e430.x) + (_e390 * _e430.y)) + (_e393 * _e430.z)) / ((((_e440.x * _e440.x) + (_e440.y * _e440.y)) + (_e440.z * _e440.z)) * _e403))) * -0.5f) * f32(_e465));
                let _e471 = p.member.current.grid[0u];
                let _e473 = p.member.current.grid[1u];
                let _e493 = p.member.current.size[0u];
                let _e495 = p.member.current.size[1u];
                let _e497 = ((f32(_e55.x) + ((f32((_e55.y & (_e473 - 1u))) + 0.5f) / f32(_e473))) + _e461);
                if (_e497 > -8388608f) {
                    let _e509 = f32(select(0i, select(select(i32(_e497), i32(-2147483648), (_e497 < bitcast<f32>(3472883712u))), 2147483647i, (_e497 > bitcast<f32>(1325400063u))), (_e497 == _e497)));
                    if (_e509 > _e497) {
                        phi_724_ = 1f;
                    } else {
                        phi_724_ = 0f;
                    }
                    let _e512 = phi_724_;
                    if (_e497 < 8388608f) {
                        phi_729_ = (_e509 - _e512);
                        phi_730_ = false;
                    } else {
                        phi_729_ = f32();
                        phi_730_ = true;
                    }
                    let _e515 = phi_729_;
                    let _e517 = phi_730_;
                    phi_731_ = _e515;
                    phi_732_ = _e517;
                } else {
                    phi_731_ = f32();
                    phi_732_ = true;
                }
                let _e519 = phi_731_;
                let _e521 = phi_732_;
                if _e521 {
                    phi_736_ = _e497;
                } else {
                    phi_736_ = _e519;
                }
                let _e523 = phi_736_;
                let _e524 = ((f32(_e55.y) + ((f32((_e55.x & (_e471 - 1u))) + 0.5f) / f32(_e471))) + _e467);
                if (_e524 > -8388608f) {
                    let _e536 = f32(select(0i, select(select(i32(_e524), i32(-2147483648), (_e524 < bitcast<f32>(3472883712u))), 2147483647i, (_e524 > bitcast<f32>(1325400063u))), (_e524 == _e524)));
                    if (_e536 > _e524) {
                        phi_757_ = 1f;
                    } else {
                        phi_757_ = 0f;
                    }
                    let _e539 = phi_757_;
                    if (_e524 < 8388608f) {
                        phi_762_ = (_e536 - _e539);
                        phi_763_ = false;
                    } else {
                        phi_762_ = f32();
                        phi_763_ = true;
                    }
                    let _e542 = phi_762_;
                    let _e544 = phi_763_;
                    phi_764_ = _e542;
                    phi_765_ = _e544;
                } else {
                    phi_764_ = f32();
                    phi_765_ = true;
                }
                let _e546 = phi_764_;
                let _e548 = phi_765_;
                if _e548 {
                    phi_769_ = _e524;
                } else {
                    phi_769_ = _e546;
                }
                let _e550 = phi_769_;
                if (_e523 >= 0f) {
                    if (_e550 >= 0f) {
                        if (_e523 < f32(_e493)) {
                            let _e556 = (_e550 < f32(_e495));
                            if (_e461 == 0f) {
                                phi_790_ = (_e467 == 0f);
                            } else {
                                phi_790_ = false;
                            }
                            let _e560 = phi_790_;
                            if _e556 {
                                phi_809_ = vec2<u32>(select(select(u32(_e523), 0u, (_e523 < bitcast<f32>(0u))), 4294967295u, (_e523 > bitcast<f32>(1333788671u))), select(select(u32(_e550), 0u, (_e550 < bitcast<f32>(0u))), 4294967295u, (_e550 > bitcast<f32>(1333788671u))));
                                phi_810_ = false;
                            } else {
                                phi_809_ = vec2<u32>();
                                phi_810_ = true;
                            }
                            let _e577 = phi_809_;
                            let _e579 = phi_810_;
                            phi_811_ = _e560;
                            phi_812_ = _e556;
                            phi_813_ = _e577;
                            phi_814_ = _e560;
                            phi_815_ = _e556;
                            phi_816_ = false;
                            phi_817_ = _e579;
                        } else {
                            phi_811_ = bool();
                            phi_812_ = bool();
                            phi_813_ = vec2<u32>();
                            phi_814_ = bool();
                            phi_815_ = bool();
                            phi_816_ = true;
                            phi_817_ = false;
                        }
                        let _e581 = phi_811_;
                        let _e583 = phi_812_;
                        let _e585 = phi_813_;
                        let _e587 = phi_814_;
                        let _e589 = phi_815_;
                        let _e591 = phi_816_;
                        let _e593 = phi_817_;
                        phi_818_ = _e581;
                        phi_819_ = _e583;
                        phi_820_ = _e585;
                        phi_821_ = _e587;
                        phi_822_ = _e589;
                        phi_823_ = _e591;
                        phi_824_ = _e593;
                    } else {
                        phi_818_ = bool();
                        phi_819_ = bool();
                        phi_820_ = vec2<u32>();
                        phi_821_ = bool();
                        phi_822_ = bool();
                        phi_823_ = true;
                        phi_824_ = false;
                    }
                    let _e595 = phi_818_;
                    let _e597 = phi_819_;
                    let _e599 = phi_820_;
                    let _e601 = phi_821_;
                    let _e603 = phi_822_;
                    let _e605 = phi_823_;
                    let _e607 = phi_824_;
                    phi_825_ = _e595;
                    phi_826_ = _e597;
                    phi_827_ = _e599;
                    phi_828_ = _e601;
                    phi_829_ = _e603;
                    phi_830_ = _e605;
                    phi_831_ = _e607;
                } else {
                    phi_825_ = bool();
                    phi_826_ = bool();
                    phi_827_ = vec2<u32>();
                    phi_828_ = bool();
                    phi_829_ = bool();
                    phi_830_ = true;
                    phi_831_ = false;
                }
                let _e609 = phi_825_;
                let _e611 = phi_826_;
                let _e613 = phi_827_;
                let _e615 = phi_828_;
                let _e617 = phi_829_;
                let _e619 = phi_830_;
                let _e621 = phi_831_;
                if _e619 {
                    if (_e461 == 0f) {
                        phi_840_ = (_e467 == 0f);
                    } else {
                        phi_840_ = false;
                    }
                    let _e625 = phi_840_;
                    phi_841_ = _e625;
                    phi_842_ = false;
                    phi_843_ = true;
                } else {
                    phi_841_ = _e615;
                    phi_842_ = _e617;
                    phi_843_ = _e621;
                }
                let _e627 = phi_841_;
                let _e629 = phi_842_;
                let _e631 = phi_843_;
                if _e631 {
                    phi_847_ = _e627;
                    phi_848_ = _e629;
                    phi_849_ = vec2<u32>(_e55.x, _e55.y);
                } else {
                    phi_847_ = _e609;
                    phi_848_ = _e611;
                    phi_849_ = _e613;
                }
                let _e633 = phi_847_;
                let _e635 = phi_848_;
                let _e637 = phi_849_;
                let _e647 = lt_mask_Reprojection(vec2<u32>(_e637.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
                let _e654 = lt_mask_Reprojection(vec2<u32>(_e647.pixel.x, _e637.y), _e647.is_valid, _e647.has_moved);
                let _e658 = lt_mask_Reprojection(_e654.pixel, _e635, _e654.has_moved);
                let _e662 = lt_mask_Reprojection(_e658.pixel, _e658.is_valid, !(_e633));
                if _e635 {
                    let _e665 = p.member.previous.eye;
                    let _e676 = p.member.previous.forward;
                    let _e685 = (((((_e90.x - _e665.x) * _e676.x) + ((_e90.y - _e665.y) * _e676.y)) + ((_e90.z - _e665.z) * _e676.z)) > 0f);
                    let _e689 = lt_mask_Reprojection(_e662.pixel, _e685, _e662.has_moved);
                    if _e685 {
                        phi_887_ = false;
                    } else {
                        phi_887_ = true;
                    }
                    let _e691 = phi_887_;
                    phi_889_ = _e689;
                    phi_890_ = _e689;
                    phi_891_ = _e691;
                } else {
                    phi_889_ = lt_mask_Reprojection();
                    phi_890_ = lt_mask_Reprojection(_e662.pixel, false, _e662.has_moved);
                    phi_891_ = true;
                }
                let _e697 = phi_889_;
                let _e699 = phi_890_;
                let _e701 = phi_891_;
                if _e701 {
                    phi_895_ = false;
                } else {
                    phi_895_ = true;
                }
                let _e703 = phi_895_;
                phi_896_ = _e699;
                phi_897_ = _e697;
                phi_898_ = _e703;
            } else {
                phi_896_ = lt_mask_Reprojection();
                phi_897_ = lt_mask_Reprojection(_e272.pixel, _e272.is_valid, false);
                phi_898_ = true;
            }
            let _e705 = phi_896_;
            let _e707 = phi_897_;
            let _e709 = phi_898_;
            if _e709 {
                let _e711 = p.member.flags;
                phi_906_ = ((_e711 & 1u) != 0u);
                phi_907_ = _e707;
            } else {
                phi_906_ = false;
                phi_907_ = _e705;
            }
            let _e715 = phi_906_;
            let _e717 = phi_907_;
            let _e721 = lt_mask_Reprojection(_e717.pixel, _e715, _e717.has_moved);
            let _e723 = p.member.flags;
            let _e725 = ((_e723 & 2u) != 0u);
            let _e727 = p.member.flags;
            if ((_e727 & 4u) == 0u) {
                phi_981_ = u32();
                phi_982_ = true;
                phi_983_ = false;
            } else {
                if _e715 {
                    if !(_e721.has_moved) {
                        let _e735 = ((((_e55.y * _e87) + _e55.x) * _e83) + _e80);
                        if (_e81 > 29u) {
                            let _e737 = (_e735 + 1u);
                            if (_e737 < _e61) {
                            } else {
                                return;
                            }
                            let _e741 = last_bits.member[(0u + _e737)];
                            phi_948_ = _e741;
                        } else {
                            phi_948_ = 0u;
                        }
                        let _e743 = phi_948_;
                        if (_e735 < _e61) {
                        } else {
                            return;
                        }
                        let _e747 = last_bits.member[(0u + _e735)];
                        let _e750 = (_e747 >> bitcast<u32>((_e81 & 31u)));
                        if (_e81 > 29u) {
                            phi_967_ = (_e750 | (_e743 << bitcast<u32>(((32u - _e81) & 31u))));
                        } else {
                            phi_967_ = _e750;
                        }
                        let _e758 = phi_967_;
                        if ((_e758 & 2u) == 0u) {
                            phi_975_ = (_e758 & 1u);
                        } else {
                            phi_975_ = (_e758 & 7u);
                        }
                        let _e764 = phi_975_;
                        phi_976_ = _e764;
                        phi_977_ = false;
                    } else {
                        phi_976_ = u32();
                        phi_977_ = true;
                    }
                    let _e766 = phi_976_;
                    let _e768 = phi_977_;
                    phi_978_ = _e766;
                    phi_979_ = false;
                    phi_980_ = _e768;
                } else {
                    phi_978_ = u32();
                    phi_979_ = true;
                    phi_980_ = false;
                }
                let _e770 = phi_978_;
                let _e772 = phi_979_;
                let _e774 = phi_980_;
                phi_981_ = _e770;
                phi_982_ = _e772;
                phi_983_ = _e774;
            }
            let _e776 = phi_981_;
            let _e778 = phi_982_;
            let _e780 = phi_983_;
            if _e778 {
                phi_987_ = true;
            } else {
                phi_987_ = _e780;
            }
            let _e782 = phi_987_;
            if _e782 {
                phi_991_ = 0u;
            } else {
                phi_991_ = _e776;
            }
            let _e784 = phi_991_;
            let _e785 = lt_mask_Neighbourhood(false, true);
            if _e254 {
                phi_996_ = _e725;
            } else {
                phi_996_ = false;
            }
            let _e787 = phi_996_;
            if _e787 {
                if _e715 {
                    if ((_e784 & 2u) != 0u) {
                        phi_1289_ = _e785;
                    } else {
                        let _e791 = p.member.expansion;
                        if _e721.has_moved {
                            let _e794 = p.member.moving_pattern;
                            phi_1018_ = _e794;
                        } else {
                            let _e796 = p.member.still_pattern;
                            phi_1018_ = _e796;
                        }
                        let _e798 = phi_1018_;
                        phi_1020_ = 0u;
                        phi_1023_ = _e785;
                        loop {
                            let _e800 = phi_1020_;
                            let _e802 = phi_1023_;
                            local_1 = _e802;
                            if (1u <= _e798) {
                                if (_e798 <= 4u) {
                                    phi_1035_ = false;
                                } else {
                                    phi_1035_ = true;
                                }
                                let _e806 = phi_1035_;
                                phi_1036_ = _e806;
                            } else {
                                phi_1036_ = true;
                            }
                            let _e808 = phi_1036_;
                            if _e808 {
                                switch bitcast<i32>(_e798) {
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
                                let _e811 = phi_1045_;
                                phi_1046_ = _e811;
                            } else {
                                phi_1046_ = 5u;
                            }
                            let _e813 = phi_1046_;
                            let _e814 = (_e800 < _e813);
                            if _e814 {
                                let _e820 = p.member.frame;
                                let _e824 = p.member.current.size[0u];
                                let _e826 = p.member.current.size[1u];
                                switch bitcast<i32>(_e798) {
                                    case 1: {
                                        let _e836 = lt_mask_pattern_plus(_e800);
                                        phi_1126_ = vec2<i32>(_e836.x, _e836.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e840 = lt_mask_pattern_cross(_e800);
                                        phi_1126_ = vec2<i32>(_e840.x, _e840.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e846 = lt_mask_pattern_plus_or_cross(_e800, ((_e721.pixel.x + _e721.pixel.y) & 1u));
                                        phi_1126_ = vec2<i32>(_e846.x, _e846.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e851 = lt_mask_pattern_plus_or_cross(_e800, (_e820 & 1u));
                                        phi_1126_ = vec2<i32>(_e851.x, _e851.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e820 & 3u)) {
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
                                        let _e862 = phi_1106_;
                                        phi_1126_ = (_e862 + vec2<i32>(bitcast<i32>((_e800 & 1u)), bitcast<i32>(((_e800 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_1126_ = vec2<i32>((bitcast<i32>((_e800 % 5u)) - 2i), (bitcast<i32>(((_e800 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e879 = lt_mask_pattern_diamond(_e800);
                                        phi_1126_ = vec2<i32>(_e879.x, _e879.y);
                                        break;
                                    }
                                    default: {
                                        phi_1126_ = vec2<i32>((bitcast<i32>((_e800 % 3u)) - 1i), (bitcast<i32>(((_e800 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e884 = phi_1126_;
                                let _e887 = lt_mask_pattern_step_clamped(_e721.pixel.x, _e884.x, _e824);
                                let _e888 = lt_mask_pattern_step_clamped(_e721.pixel.y, _e884.y, _e826);
                                let _e892 = ((((_e888 * _e87) + _e887) * _e83) + _e80);
                                if (_e81 > 29u) {
                                    let _e894 = (_e892 + 1u);
                                    if (_e894 < _e61) {
                                    } else {
                                        return;
                                    }
                                    let _e898 = last_bits.member[(0u + _e894)];
                                    phi_1151_ = _e898;
                                } else {
                                    phi_1151_ = 0u;
                                }
                                let _e900 = phi_1151_;
                                if (_e892 < _e61) {
                                } else {
                                    return;
                                }
                                let _e904 = last_bits.member[(0u + _e892)];
                                let _e907 = (_e904 >> bitcast<u32>((_e81 & 31u)));
                                if (_e81 > 29u) {
                                    phi_1170_ = (_e907 | (_e900 << bitcast<u32>(((32u - _e81) & 31u))));
                                } else {
                                    phi_1170_ = _e907;
                                }
                                let _e915 = phi_1170_;
                                if ((_e915 & 2u) == 0u) {
                                    phi_1178_ = (_e915 & 1u);
                                } else {
                                    phi_1178_ = (_e915 & 7u);
                                }
                                let _e921 = phi_1178_;
                                if _e802.any_expands {
                                    phi_1266_ = true;
                                } else {
                                    if ((_e921 & 2u) != 0u) {
                                        let _e928 = (((_e921 & 4u) != 0u) != _e250);
                                        switch bitcast<i32>(_e791) {
                                            case 1: {
                                                phi_1206_ = bool();
                                                phi_1207_ = false;
                                                phi_1208_ = true;
                                                phi_1209_ = false;
                                                phi_1210_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e928 {
                                                    phi_1204_ = (((_e921 & 4u) != 0u) != ((_e921 & 1u) != 0u));
                                                    phi_1205_ = false;
                                                } else {
                                                    phi_1204_ = bool();
                                                    phi_1205_ = true;
                                                }
                                                let _e936 = phi_1204_;
                                                let _e938 = phi_1205_;
                                                phi_1206_ = _e936;
                                                phi_1207_ = false;
                                                phi_1208_ = false;
                                                phi_1209_ = _e938;
                                                phi_1210_ = _e928;
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
                                        let _e940 = phi_1206_;
                                        let _e942 = phi_1207_;
                                        let _e944 = phi_1208_;
                                        let _e946 = phi_1209_;
                                        let _e948 = phi_1210_;
                                        phi_1218_ = _e928;
                                        phi_1219_ = _e940;
                                        phi_1220_ = _e942;
                                        phi_1221_ = _e944;
                                        phi_1222_ = _e946;
                                        phi_1223_ = _e948;
                                    } else {
                                        switch bitcast<i32>(_e791) {
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
                                        let _e951 = phi_1215_;
                                        let _e953 = phi_1216_;
                                        let _e955 = phi_1217_;
                                        phi_1218_ = false;
                                        phi_1219_ = bool();
                                        phi_1220_ = _e951;
                                        phi_1221_ = _e953;
                                        phi_1222_ = _e955;
                                        phi_1223_ = false;
                                    }
                                    let _e957 = phi_1218_;
                                    let _e959 = phi_1219_;
                                    let _e961 = phi_1220_;
                                    let _e963 = phi_1221_;
                                    let _e965 = phi_1222_;
                                    let _e967 = phi_1223_;
                                    if _e961 {
                                        if ((_e921 & 2u) != 0u) {
                                            if (((_e921 & 4u) != 0u) != _e250) {
                                                phi_1238_ = false;
                                            } else {
                                                phi_1238_ = true;
                                            }
                                            let _e974 = phi_1238_;
                                            phi_1239_ = _e974;
                                        } else {
                                            phi_1239_ = true;
                                        }
                                        let _e976 = phi_1239_;
                                        if _e976 {
                                            phi_1246_ = (((_e921 & 1u) != 0u) != _e250);
                                        } else {
                                            phi_1246_ = true;
                                        }
                                        let _e981 = phi_1246_;
                                        phi_1247_ = _e981;
                                        phi_1248_ = false;
                                        phi_1249_ = false;
                                        phi_1250_ = false;
                                    } else {
                                        phi_1247_ = bool();
                                        phi_1248_ = _e963;
                                        phi_1249_ = _e965;
                                        phi_1250_ = _e967;
                                    }
                                    let _e983 = phi_1247_;
                                    let _e985 = phi_1248_;
                                    let _e987 = phi_1249_;
                                    let _e989 = phi_1250_;
                                    if _e985 {
                                        phi_1254_ = _e957;
                                        phi_1255_ = false;
                                        phi_1256_ = false;
                                    } else {
                                        phi_1254_ = _e983;
                                        phi_1255_ = _e987;
                                        phi_1256_ = _e989;
                                    }
                                    let _e991 = phi_1254_;
                                    let _e993 = phi_1255_;
                                    let _e995 = phi_1256_;
                                    if _e993 {
                                        phi_1260_ = false;
                                        phi_1261_ = true;
                                    } else {
                                        phi_1260_ = _e959;
                                        phi_1261_ = _e995;
                                    }
                                    let _e997 = phi_1260_;
                                    let _e999 = phi_1261_;
                                    if _e999 {
                                        phi_1265_ = _e997;
                                    } else {
                                        phi_1265_ = _e991;
                                    }
                                    let _e1001 = phi_1265_;
                                    phi_1266_ = _e1001;
                                }
                                let _e1003 = phi_1266_;
                                if _e802.all_remove {
                                    if (((_e921 & 1u) != 0u) == _e250) {
                                        if ((_e921 & 2u) != 0u) {
                                            phi_1284_ = (((_e921 & 4u) != 0u) == _e250);
                                        } else {
                                            phi_1284_ = true;
                                        }
                                        let _e1013 = phi_1284_;
                                        phi_1285_ = _e1013;
                                    } else {
                                        phi_1285_ = false;
                                    }
                                    let _e1015 = phi_1285_;
                                    phi_1286_ = _e1015;
                                } else {
                                    phi_1286_ = false;
                                }
                                let _e1017 = phi_1286_;
                                phi_1021_ = (_e800 + 1u);
                                phi_1024_ = lt_mask_Neighbourhood(_e1003, _e1017);
                            } else {
                                phi_1021_ = u32();
                                phi_1024_ = lt_mask_Neighbourhood();
                            }
                            let _e1021 = phi_1021_;
                            let _e1023 = phi_1024_;
                            continue;
                            continuing {
                                phi_1020_ = _e1021;
                                phi_1023_ = _e1023;
                                break if !(_e814);
                            }
                        }
                        let _e1334 = local_1;
                        phi_1289_ = _e1334;
                    }
                    let _e1026 = phi_1289_;
                    phi_1290_ = _e1026;
                } else {
                    phi_1290_ = _e785;
                }
                let _e1028 = phi_1290_;
                phi_1291_ = _e1028;
            } else {
                phi_1291_ = _e785;
            }
            let _e1030 = phi_1291_;
            let _e1033 = p.member.frame;
            let _e1035 = p.member.refresh;
            if (_e1035 == 0u) {
                phi_1324_ = false;
            } else {
                if (_e1035 == 0u) {
                    return;
                }
                let _e1044 = ((_e55.x + (_e55.y * (((_e1035 * 5u) / 8u) | 1u))) + (_e1033 % _e1035));
                if (_e1035 == 0u) {
                    phi_1323_ = (_e1044 == 0u);
                } else {
                    if (_e1035 == 0u) {
                        return;
                    }
                    phi_1323_ = ((_e1044 % _e1035) == 0u);
                }
                let _e1051 = phi_1323_;
                phi_1324_ = _e1051;
            }
            let _e1053 = phi_1324_;
            if _e715 {
                if _e1053 {
                    phi_1346_ = bool();
                } else {
                    phi_1346_ = ((_e784 & 2u) != 0u);
                }
                let _e1059 = phi_1346_;
                phi_1347_ = _e1059;
                phi_1348_ = _e1053;
            } else {
                phi_1347_ = bool();
                phi_1348_ = true;
            }
            let _e1061 = phi_1347_;
            let _e1063 = phi_1348_;
            if _e1063 {
                phi_1352_ = false;
            } else {
                phi_1352_ = _e1061;
            }
            let _e1065 = phi_1352_;
            if _e1065 {
                phi_1403_ = 7u;
            } else {
                if (_e92 != 0.5f) {
                    if _e715 {
                        if _e1053 {
                            phi_1400_ = 6u;
                        } else {
                            if _e254 {
                                phi_1375_ = true;
                            } else {
                                if _e1030.any_expands {
                                    phi_1374_ = false;
                                } else {
                                    phi_1374_ = true;
                                }
                                let _e1067 = phi_1374_;
                                phi_1375_ = _e1067;
                            }
                            let _e1069 = phi_1375_;
                            if _e1069 {
                                if _e254 {
                                    if _e725 {
                                        if _e1030.all_remove {
                                            phi_1388_ = false;
                                        } else {
                                            phi_1388_ = true;
                                        }
                                        let _e1071 = phi_1388_;
                                        phi_1389_ = _e1071;
                                    } else {
                                        phi_1389_ = true;
                                    }
                                    let _e1073 = phi_1389_;
                                    phi_1390_ = _e1073;
                                } else {
                                    phi_1390_ = true;
                                }
                                let _e1075 = phi_1390_;
                                if _e1075 {
                                    if _e254 {
                                        phi_1397_ = 1u;
                                    } else {
                                        phi_1397_ = 0u;
                                    }
                                    let _e1077 = phi_1397_;
                                    phi_1398_ = _e1077;
                                } else {
                                    phi_1398_ = 5u;
                                }
                                let _e1079 = phi_1398_;
                                phi_1399_ = _e1079;
                            } else {
                                phi_1399_ = 4u;
                            }
                            let _e1081 = phi_1399_;
                            phi_1400_ = _e1081;
                        }
                        let _e1083 = phi_1400_;
                        phi_1401_ = _e1083;
                    } else {
                        phi_1401_ = 3u;
                    }
                    let _e1085 = phi_1401_;
                    phi_1402_ = _e1085;
                } else {
                    phi_1402_ = 2u;
                }
                let _e1087 = phi_1402_;
                phi_1403_ = _e1087;
            }
            let _e1089 = phi_1403_;
            if !((_e1089 == 0u)) {
                if !((_e1089 == 5u)) {
                    phi_1415_ = !(_e1065);
                    phi_1416_ = false;
                } else {
                    phi_1415_ = bool();
                    phi_1416_ = true;
                }
                let _e1096 = phi_1415_;
                let _e1098 = phi_1416_;
                phi_1417_ = _e1096;
                phi_1418_ = _e1098;
            } else {
                phi_1417_ = bool();
                phi_1418_ = true;
            }
            let _e1100 = phi_1417_;
            let _e1102 = phi_1418_;
            if _e1102 {
                phi_1422_ = false;
            } else {
                phi_1422_ = _e1100;
            }
            let _e1104 = phi_1422_;
            if _e1065 {
                phi_1428_ = ((_e784 & 4u) != 0u);
            } else {
                phi_1428_ = _e250;
            }
            let _e1108 = phi_1428_;
            if _e1104 {
                if _e250 {
                    phi_1436_ = (2u | 1u);
                } else {
                    phi_1436_ = 2u;
                }
                let _e1111 = phi_1436_;
                if false {
                    phi_1441_ = (_e1111 | 4u);
                } else {
                    phi_1441_ = _e1111;
                }
                let _e1114 = phi_1441_;
                phi_1461_ = _e1114;
            } else {
                if (_e1089 == 7u) {
                    if _e250 {
                        phi_1450_ = (2u | 1u);
                    } else {
                        phi_1450_ = 2u;
                    }
                    let _e1118 = phi_1450_;
                    if _e1108 {
                        phi_1455_ = (_e1118 | 4u);
                    } else {
                        phi_1455_ = _e1118;
                    }
                    let _e1121 = phi_1455_;
                    phi_1460_ = _e1121;
                } else {
                    if _e250 {
                        phi_1459_ = 1u;
                    } else {
                        phi_1459_ = 0u;
                    }
                    let _e1123 = phi_1459_;
                    phi_1460_ = _e1123;
                }
                let _e1125 = phi_1460_;
                phi_1461_ = _e1125;
            }
            let _e1127 = phi_1461_;
            if _e1108 {
                phi_1465_ = 0f;
            } else {
                phi_1465_ = 1f;
            }
            let _e1129 = phi_1465_;
            phi_1467_ = mask_Masked(_e1129, _e1127, _e1104);
        }
        let _e1132 = phi_1467_;
        visibility.member[_e71.shift] = _e1132.visibility;
        let _e1137 = p.member.light.number;
        let _e1138 = (_e1137 * 3u);
        let _e1140 = (_e1138 % 32u);
        let _e1142 = p.member.light.mask_words;
        let _e1144 = ((_e71.shift * _e1142) + (_e1138 / 32u));
        let _e1146 = bits.member[_e1144];
        bits.member[_e1144] = ((_e1146 & ~((7u << bitcast<u32>((_e1140 & 31u))))) | (_e1132.bits << bitcast<u32>((_e1140 & 31u))));
        if (_e1140 > 29u) {
            let _e1161 = bits.member[(_e1144 + 1u)];
            let _e1163 = (32u - _e1140);
            bits.member[(_e1144 + 1u)] = ((_e1161 & ~((7u >> bitcast<u32>((_e1163 & 31u))))) | (_e1132.bits >> bitcast<u32>((_e1163 & 31u))));
        }
        phi_1517_ = _e1132.needs_ray;
        phi_1518_ = _e71.shift;
    } else {
        phi_1517_ = false;
        phi_1518_ = 0u;
    }
    let _e1177 = phi_1517_;
    let _e1179 = phi_1518_;
    if (_e56 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1177 {
        let _e1183 = atomicAdd((&shared_[0u]), 1u);
        phi_1529_ = _e1183;
    } else {
        phi_1529_ = 0u;
    }
    let _e1185 = phi_1529_;
    workgroupBarrier();
    if (_e56 == 0u) {
        let _e1189 = atomicLoad((&shared_[0u]));
        let _e1190 = atomicAdd((&list.member[3u]), _e1189);
        atomicStore((&shared_[1u]), _e1190);
    }
    workgroupBarrier();
    if _e1177 {
        let _e1193 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1193) + _e1185)]), _e1179);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_rr_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
