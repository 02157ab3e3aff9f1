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
    var phi_913_: bool;
    var phi_935_: u32;
    var phi_937_: u32;
    var phi_940_: lt_mask_Neighbourhood;
    var phi_952_: bool;
    var phi_953_: bool;
    var phi_962_: u32;
    var phi_963_: u32;
    var phi_1023_: vec2<i32>;
    var phi_1043_: vec2<i32>;
    var phi_1068_: u32;
    var phi_1087_: u32;
    var phi_1095_: u32;
    var phi_1121_: bool;
    var phi_1122_: bool;
    var phi_1123_: bool;
    var phi_1124_: bool;
    var phi_1125_: bool;
    var phi_1126_: bool;
    var phi_1127_: bool;
    var phi_1132_: bool;
    var phi_1133_: bool;
    var phi_1134_: bool;
    var phi_1135_: bool;
    var phi_1136_: bool;
    var phi_1137_: bool;
    var phi_1138_: bool;
    var phi_1139_: bool;
    var phi_1140_: bool;
    var phi_1155_: bool;
    var phi_1156_: bool;
    var phi_1163_: bool;
    var phi_1164_: bool;
    var phi_1165_: bool;
    var phi_1166_: bool;
    var phi_1167_: bool;
    var phi_1171_: bool;
    var phi_1172_: bool;
    var phi_1173_: bool;
    var phi_1177_: bool;
    var phi_1178_: bool;
    var phi_1182_: bool;
    var phi_1183_: bool;
    var phi_1201_: bool;
    var phi_1202_: bool;
    var phi_1203_: bool;
    var phi_938_: u32;
    var phi_941_: lt_mask_Neighbourhood;
    var phi_1206_: lt_mask_Neighbourhood;
    var phi_1207_: lt_mask_Neighbourhood;
    var phi_1208_: lt_mask_Neighbourhood;
    var phi_1240_: bool;
    var phi_1241_: bool;
    var phi_1263_: bool;
    var phi_1264_: bool;
    var phi_1265_: bool;
    var phi_1269_: bool;
    var phi_1291_: bool;
    var phi_1292_: bool;
    var phi_1305_: bool;
    var phi_1306_: bool;
    var phi_1307_: bool;
    var phi_1314_: u32;
    var phi_1315_: u32;
    var phi_1316_: u32;
    var phi_1317_: u32;
    var phi_1318_: u32;
    var phi_1319_: u32;
    var phi_1320_: u32;
    var phi_1332_: bool;
    var phi_1333_: bool;
    var phi_1334_: bool;
    var phi_1335_: bool;
    var phi_1339_: bool;
    var phi_1345_: bool;
    var phi_1353_: u32;
    var phi_1358_: u32;
    var phi_1367_: u32;
    var phi_1372_: u32;
    var phi_1376_: u32;
    var phi_1377_: u32;
    var phi_1378_: u32;
    var phi_1382_: f32;
    var phi_1384_: mask_Masked;
    var phi_1434_: bool;
    var phi_1435_: u32;
    var phi_1446_: u32;
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
            phi_1384_ = mask_Masked(_e245.unnamed.visibility, 0u, false);
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
            let _e722 = lt_mask_Neighbourhood(false, true);
            if _e254 {
                phi_913_ = false;
            } else {
                phi_913_ = true;
            }
            let _e724 = phi_913_;
            if _e724 {
                if _e715 {
                    if ((0u & 2u) != 0u) {
                        phi_1206_ = _e722;
                    } else {
                        let _e728 = p.member.expansion;
                        if _e721.has_moved {
                            let _e731 = p.member.moving_pattern;
                            phi_935_ = _e731;
                        } else {
                            let _e733 = p.member.still_pattern;
                            phi_935_ = _e733;
                        }
                        let _e735 = phi_935_;
                        phi_937_ = 0u;
                        phi_940_ = _e722;
                        loop {
                            let _e737 = phi_937_;
                            let _e739 = phi_940_;
                            local_1 = _e739;
                            if (1u <= _e735) {
                                if (_e735 <= 4u) {
                                    phi_952_ = false;
                                } else {
                                    phi_952_ = true;
                                }
                                let _e743 = phi_952_;
                                phi_953_ = _e743;
                            } else {
                                phi_953_ = true;
                            }
                            let _e745 = phi_953_;
                            if _e745 {
                                switch bitcast<i32>(_e735) {
                                    case 5: {
                                        phi_962_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_962_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_962_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_962_ = 9u;
                                        break;
                                    }
                                }
                                let _e748 = phi_962_;
                                phi_963_ = _e748;
                            } else {
                                phi_963_ = 5u;
                            }
                            let _e750 = phi_963_;
                            let _e751 = (_e737 < _e750);
                            if _e751 {
                                let _e757 = p.member.frame;
                                let _e761 = p.member.current.size[0u];
                                let _e763 = p.member.current.size[1u];
                                switch bitcast<i32>(_e735) {
                                    case 1: {
                                        let _e773 = lt_mask_pattern_plus(_e737);
                                        phi_1043_ = vec2<i32>(_e773.x, _e773.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e777 = lt_mask_pattern_cross(_e737);
                                        phi_1043_ = vec2<i32>(_e777.x, _e777.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e783 = lt_mask_pattern_plus_or_cross(_e737, ((_e721.pixel.x + _e721.pixel.y) & 1u));
                                        phi_1043_ = vec2<i32>(_e783.x, _e783.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e788 = lt_mask_pattern_plus_or_cross(_e737, (_e757 & 1u));
                                        phi_1043_ = vec2<i32>(_e788.x, _e788.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e757 & 3u)) {
                                            case 0: {
                                                phi_1023_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_1023_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_1023_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_1023_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e799 = phi_1023_;
                                        phi_1043_ = (_e799 + vec2<i32>(bitcast<i32>((_e737 & 1u)), bitcast<i32>(((_e737 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_1043_ = vec2<i32>((bitcast<i32>((_e737 % 5u)) - 2i), (bitcast<i32>(((_e737 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e816 = lt_mask_pattern_diamond(_e737);
                                        phi_1043_ = vec2<i32>(_e816.x, _e816.y);
                                        break;
                                    }
                                    default: {
                                        phi_1043_ = vec2<i32>((bitcast<i32>((_e737 % 3u)) - 1i), (bitcast<i32>(((_e737 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e821 = phi_1043_;
                                let _e824 = lt_mask_pattern_step_clamped(_e721.pixel.x, _e821.x, _e761);
                                let _e825 = lt_mask_pattern_step_clamped(_e721.pixel.y, _e821.y, _e763);
                                let _e829 = ((((_e825 * _e87) + _e824) * _e83) + (_e79 / 32u));
                                if (_e81 > 29u) {
                                    let _e831 = (_e829 + 1u);
                                    if (_e831 < _e61) {
                                    } else {
                                        return;
                                    }
                                    let _e835 = last_bits.member[(0u + _e831)];
                                    phi_1068_ = _e835;
                                } else {
                                    phi_1068_ = 0u;
                                }
                                let _e837 = phi_1068_;
                                if (_e829 < _e61) {
                                } else {
                                    return;
                                }
                                let _e841 = last_bits.member[(0u + _e829)];
                                let _e844 = (_e841 >> bitcast<u32>((_e81 & 31u)));
                                if (_e81 > 29u) {
                                    phi_1087_ = (_e844 | (_e837 << bitcast<u32>(((32u - _e81) & 31u))));
                                } else {
                                    phi_1087_ = _e844;
                                }
                                let _e852 = phi_1087_;
                                if ((_e852 & 2u) == 0u) {
                                    phi_1095_ = (_e852 & 1u);
                                } else {
                                    phi_1095_ = (_e852 & 7u);
                                }
                                let _e858 = phi_1095_;
                                if _e739.any_expands {
                                    phi_1183_ = true;
                                } else {
                                    if ((_e858 & 2u) != 0u) {
                                        let _e865 = (((_e858 & 4u) != 0u) != _e250);
                                        switch bitcast<i32>(_e728) {
                                            case 1: {
                                                phi_1123_ = bool();
                                                phi_1124_ = false;
                                                phi_1125_ = true;
                                                phi_1126_ = false;
                                                phi_1127_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e865 {
                                                    phi_1121_ = (((_e858 & 4u) != 0u) != ((_e858 & 1u) != 0u));
                                                    phi_1122_ = false;
                                                } else {
                                                    phi_1121_ = bool();
                                                    phi_1122_ = true;
                                                }
                                                let _e873 = phi_1121_;
                                                let _e875 = phi_1122_;
                                                phi_1123_ = _e873;
                                                phi_1124_ = false;
                                                phi_1125_ = false;
                                                phi_1126_ = _e875;
                                                phi_1127_ = _e865;
                                                break;
                                            }
                                            default: {
                                                phi_1123_ = bool();
                                                phi_1124_ = true;
                                                phi_1125_ = false;
                                                phi_1126_ = false;
                                                phi_1127_ = false;
                                                break;
                                            }
                                        }
                                        let _e877 = phi_1123_;
                                        let _e879 = phi_1124_;
                                        let _e881 = phi_1125_;
                                        let _e883 = phi_1126_;
                                        let _e885 = phi_1127_;
                                        phi_1135_ = _e865;
                                        phi_1136_ = _e877;
                                        phi_1137_ = _e879;
                                        phi_1138_ = _e881;
                                        phi_1139_ = _e883;
                                        phi_1140_ = _e885;
                                    } else {
                                        switch bitcast<i32>(_e728) {
                                            case 1: {
                                                phi_1132_ = false;
                                                phi_1133_ = true;
                                                phi_1134_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_1132_ = false;
                                                phi_1133_ = false;
                                                phi_1134_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_1132_ = true;
                                                phi_1133_ = false;
                                                phi_1134_ = false;
                                                break;
                                            }
                                        }
                                        let _e888 = phi_1132_;
                                        let _e890 = phi_1133_;
                                        let _e892 = phi_1134_;
                                        phi_1135_ = false;
                                        phi_1136_ = bool();
                                        phi_1137_ = _e888;
                                        phi_1138_ = _e890;
                                        phi_1139_ = _e892;
                                        phi_1140_ = false;
                                    }
                                    let _e894 = phi_1135_;
                                    let _e896 = phi_1136_;
                                    let _e898 = phi_1137_;
                                    let _e900 = phi_1138_;
                                    let _e902 = phi_1139_;
                                    let _e904 = phi_1140_;
                                    if _e898 {
                                        if ((_e858 & 2u) != 0u) {
                                            if (((_e858 & 4u) != 0u) != _e250) {
                                                phi_1155_ = false;
                                            } else {
                                                phi_1155_ = true;
                                            }
                                            let _e911 = phi_1155_;
                                            phi_1156_ = _e911;
                                        } else {
                                            phi_1156_ = true;
                                        }
                                        let _e913 = phi_1156_;
                                        if _e913 {
                                            phi_1163_ = (((_e858 & 1u) != 0u) != _e250);
                                        } else {
                                            phi_1163_ = true;
                                        }
                                        let _e918 = phi_1163_;
                                        phi_1164_ = _e918;
                                        phi_1165_ = false;
                                        phi_1166_ = false;
                                        phi_1167_ = false;
                                    } else {
                                        phi_1164_ = bool();
                                        phi_1165_ = _e900;
                                        phi_1166_ = _e902;
                                        phi_1167_ = _e904;
                                    }
                                    let _e920 = phi_1164_;
                                    let _e922 = phi_1165_;
                                    let _e924 = phi_1166_;
                                    let _e926 = phi_1167_;
                                    if _e922 {
                                        phi_1171_ = _e894;
                                        phi_1172_ = false;
                                        phi_1173_ = false;
                                    } else {
                                        phi_1171_ = _e920;
                                        phi_1172_ = _e924;
                                        phi_1173_ = _e926;
                                    }
                                    let _e928 = phi_1171_;
                                    let _e930 = phi_1172_;
                                    let _e932 = phi_1173_;
                                    if _e930 {
                                        phi_1177_ = false;
                                        phi_1178_ = true;
                                    } else {
                                        phi_1177_ = _e896;
                                        phi_1178_ = _e932;
                                    }
                                    let _e934 = phi_1177_;
                                    let _e936 = phi_1178_;
                                    if _e936 {
                                        phi_1182_ = _e934;
                                    } else {
                                        phi_1182_ = _e928;
                                    }
                                    let _e938 = phi_1182_;
                                    phi_1183_ = _e938;
                                }
                                let _e940 = phi_1183_;
                                if _e739.all_remove {
                                    if (((_e858 & 1u) != 0u) == _e250) {
                                        if ((_e858 & 2u) != 0u) {
                                            phi_1201_ = (((_e858 & 4u) != 0u) == _e250);
                                        } else {
                                            phi_1201_ = true;
                                        }
                                        let _e950 = phi_1201_;
                                        phi_1202_ = _e950;
                                    } else {
                                        phi_1202_ = false;
                                    }
                                    let _e952 = phi_1202_;
                                    phi_1203_ = _e952;
                                } else {
                                    phi_1203_ = false;
                                }
                                let _e954 = phi_1203_;
                                phi_938_ = (_e737 + 1u);
                                phi_941_ = lt_mask_Neighbourhood(_e940, _e954);
                            } else {
                                phi_938_ = u32();
                                phi_941_ = lt_mask_Neighbourhood();
                            }
                            let _e958 = phi_938_;
                            let _e960 = phi_941_;
                            continue;
                            continuing {
                                phi_937_ = _e958;
                                phi_940_ = _e960;
                                break if !(_e751);
                            }
                        }
                        let _e1258 = local_1;
                        phi_1206_ = _e1258;
                    }
                    let _e963 = phi_1206_;
                    phi_1207_ = _e963;
                } else {
                    phi_1207_ = _e722;
                }
                let _e965 = phi_1207_;
                phi_1208_ = _e965;
            } else {
                phi_1208_ = _e722;
            }
            let _e967 = phi_1208_;
            let _e970 = p.member.frame;
            let _e972 = p.member.refresh;
            if (_e972 == 0u) {
                phi_1241_ = false;
            } else {
                if (_e972 == 0u) {
                    return;
                }
                let _e981 = ((_e55.x + (_e55.y * (((_e972 * 5u) / 8u) | 1u))) + (_e970 % _e972));
                if (_e972 == 0u) {
                    phi_1240_ = (_e981 == 0u);
                } else {
                    if (_e972 == 0u) {
                        return;
                    }
                    phi_1240_ = ((_e981 % _e972) == 0u);
                }
                let _e988 = phi_1240_;
                phi_1241_ = _e988;
            }
            let _e990 = phi_1241_;
            if _e715 {
                if _e990 {
                    phi_1263_ = bool();
                } else {
                    phi_1263_ = ((0u & 2u) != 0u);
                }
                let _e996 = phi_1263_;
                phi_1264_ = _e996;
                phi_1265_ = _e990;
            } else {
                phi_1264_ = bool();
                phi_1265_ = true;
            }
            let _e998 = phi_1264_;
            let _e1000 = phi_1265_;
            if _e1000 {
                phi_1269_ = false;
            } else {
                phi_1269_ = _e998;
            }
            let _e1002 = phi_1269_;
            if _e1002 {
                phi_1320_ = 7u;
            } else {
                if (_e92 != 0.5f) {
                    if _e715 {
                        if _e990 {
                            phi_1317_ = 6u;
                        } else {
                            if _e254 {
                                phi_1292_ = true;
                            } else {
                                if _e967.any_expands {
                                    phi_1291_ = false;
                                } else {
                                    phi_1291_ = true;
                                }
                                let _e1004 = phi_1291_;
                                phi_1292_ = _e1004;
                            }
                            let _e1006 = phi_1292_;
                            if _e1006 {
                                if _e254 {
                                    if false {
                                        if _e967.all_remove {
                                            phi_1305_ = false;
                                        } else {
                                            phi_1305_ = true;
                                        }
                                        let _e1008 = phi_1305_;
                                        phi_1306_ = _e1008;
                                    } else {
                                        phi_1306_ = true;
                                    }
                                    let _e1010 = phi_1306_;
                                    phi_1307_ = _e1010;
                                } else {
                                    phi_1307_ = true;
                                }
                                let _e1012 = phi_1307_;
                                if _e1012 {
                                    if _e254 {
                                        phi_1314_ = 1u;
                                    } else {
                                        phi_1314_ = 0u;
                                    }
                                    let _e1014 = phi_1314_;
                                    phi_1315_ = _e1014;
                                } else {
                                    phi_1315_ = 5u;
                                }
                                let _e1016 = phi_1315_;
                                phi_1316_ = _e1016;
                            } else {
                                phi_1316_ = 4u;
                            }
                            let _e1018 = phi_1316_;
                            phi_1317_ = _e1018;
                        }
                        let _e1020 = phi_1317_;
                        phi_1318_ = _e1020;
                    } else {
                        phi_1318_ = 3u;
                    }
                    let _e1022 = phi_1318_;
                    phi_1319_ = _e1022;
                } else {
                    phi_1319_ = 2u;
                }
                let _e1024 = phi_1319_;
                phi_1320_ = _e1024;
            }
            let _e1026 = phi_1320_;
            if !((_e1026 == 0u)) {
                if !((_e1026 == 5u)) {
                    phi_1332_ = !(_e1002);
                    phi_1333_ = false;
                } else {
                    phi_1332_ = bool();
                    phi_1333_ = true;
                }
                let _e1033 = phi_1332_;
                let _e1035 = phi_1333_;
                phi_1334_ = _e1033;
                phi_1335_ = _e1035;
            } else {
                phi_1334_ = bool();
                phi_1335_ = true;
            }
            let _e1037 = phi_1334_;
            let _e1039 = phi_1335_;
            if _e1039 {
                phi_1339_ = false;
            } else {
                phi_1339_ = _e1037;
            }
            let _e1041 = phi_1339_;
            if _e1002 {
                phi_1345_ = ((0u & 4u) != 0u);
            } else {
                phi_1345_ = _e250;
            }
            let _e1045 = phi_1345_;
            if _e1041 {
                if _e250 {
                    phi_1353_ = (2u | 1u);
                } else {
                    phi_1353_ = 2u;
                }
                let _e1048 = phi_1353_;
                if false {
                    phi_1358_ = (_e1048 | 4u);
                } else {
                    phi_1358_ = _e1048;
                }
                let _e1051 = phi_1358_;
                phi_1378_ = _e1051;
            } else {
                if (_e1026 == 7u) {
                    if _e250 {
                        phi_1367_ = (2u | 1u);
                    } else {
                        phi_1367_ = 2u;
                    }
                    let _e1055 = phi_1367_;
                    if _e1045 {
                        phi_1372_ = (_e1055 | 4u);
                    } else {
                        phi_1372_ = _e1055;
                    }
                    let _e1058 = phi_1372_;
                    phi_1377_ = _e1058;
                } else {
                    if _e250 {
                        phi_1376_ = 1u;
                    } else {
                        phi_1376_ = 0u;
                    }
                    let _e1060 = phi_1376_;
                    phi_1377_ = _e1060;
                }
                let _e1062 = phi_1377_;
                phi_1378_ = _e1062;
            }
            let _e1064 = phi_1378_;
            if _e1045 {
                phi_1382_ = 0f;
            } else {
                phi_1382_ = 1f;
            }
            let _e1066 = phi_1382_;
            phi_1384_ = mask_Masked(_e1066, _e1064, _e1041);
        }
        let _e1069 = phi_1384_;
        visibility.member[_e71.shift] = _e1069.visibility;
        let _e1074 = p.member.light.number;
        let _e1075 = (_e1074 * 3u);
        let _e1077 = (_e1075 % 32u);
        let _e1079 = p.member.light.mask_words;
        let _e1081 = ((_e71.shift * _e1079) + (_e1075 / 32u));
        let _e1083 = bits.member[_e1081];
        bits.member[_e1081] = ((_e1083 & ~((7u << bitcast<u32>((_e1077 & 31u))))) | (_e1069.bits << bitcast<u32>((_e1077 & 31u))));
        if (_e1077 > 29u) {
            let _e1098 = bits.member[(_e1081 + 1u)];
            let _e1100 = (32u - _e1077);
            bits.member[(_e1081 + 1u)] = ((_e1098 & ~((7u >> bitcast<u32>((_e1100 & 31u))))) | (_e1069.bits >> bitcast<u32>((_e1100 & 31u))));
        }
        phi_1434_ = _e1069.needs_ray;
        phi_1435_ = _e71.shift;
    } else {
        phi_1434_ = false;
        phi_1435_ = 0u;
    }
    let _e1114 = phi_1434_;
    let _e1116 = phi_1435_;
    if (_e56 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1114 {
        let _e1120 = atomicAdd((&shared_[0u]), 1u);
        phi_1446_ = _e1120;
    } else {
        phi_1446_ = 0u;
    }
    let _e1122 = phi_1446_;
    workgroupBarrier();
    if (_e56 == 0u) {
        let _e1126 = atomicLoad((&shared_[0u]));
        let _e1127 = atomicAdd((&list.member[3u]), _e1126);
        atomicStore((&shared_[1u]), _e1127);
    }
    workgroupBarrier();
    if _e1114 {
        let _e1130 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1130) + _e1122)]), _e1116);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_motion_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
