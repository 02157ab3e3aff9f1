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
    var phi_910_: bool;
    var phi_932_: u32;
    var phi_934_: u32;
    var phi_937_: lt_mask_Neighbourhood;
    var phi_949_: bool;
    var phi_950_: bool;
    var phi_959_: u32;
    var phi_960_: u32;
    var phi_1020_: vec2<i32>;
    var phi_1040_: vec2<i32>;
    var phi_1065_: u32;
    var phi_1084_: u32;
    var phi_1092_: u32;
    var phi_1118_: bool;
    var phi_1119_: bool;
    var phi_1120_: bool;
    var phi_1121_: bool;
    var phi_1122_: bool;
    var phi_1123_: bool;
    var phi_1124_: bool;
    var phi_1129_: bool;
    var phi_1130_: bool;
    var phi_1131_: bool;
    var phi_1132_: bool;
    var phi_1133_: bool;
    var phi_1134_: bool;
    var phi_1135_: bool;
    var phi_1136_: bool;
    var phi_1137_: bool;
    var phi_1152_: bool;
    var phi_1153_: bool;
    var phi_1160_: bool;
    var phi_1161_: bool;
    var phi_1162_: bool;
    var phi_1163_: bool;
    var phi_1164_: bool;
    var phi_1168_: bool;
    var phi_1169_: bool;
    var phi_1170_: bool;
    var phi_1174_: bool;
    var phi_1175_: bool;
    var phi_1179_: bool;
    var phi_1180_: bool;
    var phi_1198_: bool;
    var phi_1199_: bool;
    var phi_1200_: bool;
    var phi_935_: u32;
    var phi_938_: lt_mask_Neighbourhood;
    var phi_1203_: lt_mask_Neighbourhood;
    var phi_1204_: lt_mask_Neighbourhood;
    var phi_1205_: lt_mask_Neighbourhood;
    var phi_1237_: bool;
    var phi_1238_: bool;
    var phi_1260_: bool;
    var phi_1261_: bool;
    var phi_1262_: bool;
    var phi_1266_: bool;
    var phi_1288_: bool;
    var phi_1289_: bool;
    var phi_1302_: bool;
    var phi_1303_: bool;
    var phi_1304_: bool;
    var phi_1311_: u32;
    var phi_1312_: u32;
    var phi_1313_: u32;
    var phi_1314_: u32;
    var phi_1315_: u32;
    var phi_1316_: u32;
    var phi_1317_: u32;
    var phi_1329_: bool;
    var phi_1330_: bool;
    var phi_1331_: bool;
    var phi_1332_: bool;
    var phi_1336_: bool;
    var phi_1342_: bool;
    var phi_1350_: u32;
    var phi_1355_: u32;
    var phi_1364_: u32;
    var phi_1369_: u32;
    var phi_1373_: u32;
    var phi_1374_: u32;
    var phi_1375_: u32;
    var phi_1379_: f32;
    var phi_1381_: mask_Masked;
    var phi_1431_: bool;
    var phi_1432_: u32;
    var phi_1443_: u32;
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
            phi_1381_ = mask_Masked(_e250.unnamed.visibility, 0u, false);
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
            let _e716 = lt_mask_Neighbourhood(false, true);
            if _e259 {
                phi_910_ = false;
            } else {
                phi_910_ = true;
            }
            let _e718 = phi_910_;
            if _e718 {
                if _e709 {
                    if ((0u & 2u) != 0u) {
                        phi_1203_ = _e716;
                    } else {
                        let _e722 = p.member.expansion;
                        if _e715.has_moved {
                            let _e725 = p.member.moving_pattern;
                            phi_932_ = _e725;
                        } else {
                            let _e727 = p.member.still_pattern;
                            phi_932_ = _e727;
                        }
                        let _e729 = phi_932_;
                        phi_934_ = 0u;
                        phi_937_ = _e716;
                        loop {
                            let _e731 = phi_934_;
                            let _e733 = phi_937_;
                            local_1 = _e733;
                            if (1u <= _e729) {
                                if (_e729 <= 4u) {
                                    phi_949_ = false;
                                } else {
                                    phi_949_ = true;
                                }
                                let _e737 = phi_949_;
                                phi_950_ = _e737;
                            } else {
                                phi_950_ = true;
                            }
                            let _e739 = phi_950_;
                            if _e739 {
                                switch bitcast<i32>(_e729) {
                                    case 5: {
                                        phi_959_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_959_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_959_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_959_ = 9u;
                                        break;
                                    }
                                }
                                let _e742 = phi_959_;
                                phi_960_ = _e742;
                            } else {
                                phi_960_ = 5u;
                            }
                            let _e744 = phi_960_;
                            let _e745 = (_e731 < _e744);
                            if _e745 {
                                let _e751 = p.member.frame;
                                let _e755 = p.member.current.size[0u];
                                let _e757 = p.member.current.size[1u];
                                switch bitcast<i32>(_e729) {
                                    case 1: {
                                        let _e767 = lt_mask_pattern_plus(_e731);
                                        phi_1040_ = vec2<i32>(_e767.x, _e767.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e771 = lt_mask_pattern_cross(_e731);
                                        phi_1040_ = vec2<i32>(_e771.x, _e771.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e777 = lt_mask_pattern_plus_or_cross(_e731, ((_e715.pixel.x + _e715.pixel.y) & 1u));
                                        phi_1040_ = vec2<i32>(_e777.x, _e777.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e782 = lt_mask_pattern_plus_or_cross(_e731, (_e751 & 1u));
                                        phi_1040_ = vec2<i32>(_e782.x, _e782.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e751 & 3u)) {
                                            case 0: {
                                                phi_1020_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_1020_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_1020_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_1020_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e793 = phi_1020_;
                                        phi_1040_ = (_e793 + vec2<i32>(bitcast<i32>((_e731 & 1u)), bitcast<i32>(((_e731 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_1040_ = vec2<i32>((bitcast<i32>((_e731 % 5u)) - 2i), (bitcast<i32>(((_e731 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e810 = lt_mask_pattern_diamond(_e731);
                                        phi_1040_ = vec2<i32>(_e810.x, _e810.y);
                                        break;
                                    }
                                    default: {
                                        phi_1040_ = vec2<i32>((bitcast<i32>((_e731 % 3u)) - 1i), (bitcast<i32>(((_e731 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e815 = phi_1040_;
                                let _e818 = lt_mask_pattern_step_clamped(_e715.pixel.x, _e815.x, _e755);
                                let _e819 = lt_mask_pattern_step_clamped(_e715.pixel.y, _e815.y, _e757);
                                let _e823 = ((((_e819 * _e89) + _e818) * _e85) + (_e81 / 32u));
                                if (_e83 > 29u) {
                                    let _e825 = (_e823 + 1u);
                                    if (_e825 < _e62) {
                                    } else {
                                        return;
                                    }
                                    let _e829 = last_bits.member[(0u + _e825)];
                                    phi_1065_ = _e829;
                                } else {
                                    phi_1065_ = 0u;
                                }
                                let _e831 = phi_1065_;
                                if (_e823 < _e62) {
                                } else {
                                    return;
                                }
                                let _e835 = last_bits.member[(0u + _e823)];
                                let _e838 = (_e835 >> bitcast<u32>((_e83 & 31u)));
                                if (_e83 > 29u) {
                                    phi_1084_ = (_e838 | (_e831 << bitcast<u32>(((32u - _e83) & 31u))));
                                } else {
                                    phi_1084_ = _e838;
                                }
                                let _e846 = phi_1084_;
                                if ((_e846 & 2u) == 0u) {
                                    phi_1092_ = (_e846 & 1u);
                                } else {
                                    phi_1092_ = (_e846 & 7u);
                                }
                                let _e852 = phi_1092_;
                                if _e733.any_expands {
                                    phi_1180_ = true;
                                } else {
                                    if ((_e852 & 2u) != 0u) {
                                        let _e859 = (((_e852 & 4u) != 0u) != _e255);
                                        switch bitcast<i32>(_e722) {
                                            case 1: {
                                                phi_1120_ = bool();
                                                phi_1121_ = false;
                                                phi_1122_ = true;
                                                phi_1123_ = false;
                                                phi_1124_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e859 {
                                                    phi_1118_ = (((_e852 & 4u) != 0u) != ((_e852 & 1u) != 0u));
                                                    phi_1119_ = false;
                                                } else {
                                                    phi_1118_ = bool();
                                                    phi_1119_ = true;
                                                }
                                                let _e867 = phi_1118_;
                                                let _e869 = phi_1119_;
                                                phi_1120_ = _e867;
                                                phi_1121_ = false;
                                                phi_1122_ = false;
                                                phi_1123_ = _e869;
                                                phi_1124_ = _e859;
                                                break;
                                            }
                                            default: {
                                                phi_1120_ = bool();
                                                phi_1121_ = true;
                                                phi_1122_ = false;
                                                phi_1123_ = false;
                                                phi_1124_ = false;
                                                break;
                                            }
                                        }
                                        let _e871 = phi_1120_;
                                        let _e873 = phi_1121_;
                                        let _e875 = phi_1122_;
                                        let _e877 = phi_1123_;
                                        let _e879 = phi_1124_;
                                        phi_1132_ = _e859;
                                        phi_1133_ = _e871;
                                        phi_1134_ = _e873;
                                        phi_1135_ = _e875;
                                        phi_1136_ = _e877;
                                        phi_1137_ = _e879;
                                    } else {
                                        switch bitcast<i32>(_e722) {
                                            case 1: {
                                                phi_1129_ = false;
                                                phi_1130_ = true;
                                                phi_1131_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_1129_ = false;
                                                phi_1130_ = false;
                                                phi_1131_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_1129_ = true;
                                                phi_1130_ = false;
                                                phi_1131_ = false;
                                                break;
                                            }
                                        }
                                        let _e882 = phi_1129_;
                                        let _e884 = phi_1130_;
                                        let _e886 = phi_1131_;
                                        phi_1132_ = false;
                                        phi_1133_ = bool();
                                        phi_1134_ = _e882;
                                        phi_1135_ = _e884;
                                        phi_1136_ = _e886;
                                        phi_1137_ = false;
                                    }
                                    let _e888 = phi_1132_;
                                    let _e890 = phi_1133_;
                                    let _e892 = phi_1134_;
                                    let _e894 = phi_1135_;
                                    let _e896 = phi_1136_;
                                    let _e898 = phi_1137_;
                                    if _e892 {
                                        if ((_e852 & 2u) != 0u) {
                                            if (((_e852 & 4u) != 0u) != _e255) {
                                                phi_1152_ = false;
                                            } else {
                                                phi_1152_ = true;
                                            }
                                            let _e905 = phi_1152_;
                                            phi_1153_ = _e905;
                                        } else {
                                            phi_1153_ = true;
                                        }
                                        let _e907 = phi_1153_;
                                        if _e907 {
                                            phi_1160_ = (((_e852 & 1u) != 0u) != _e255);
                                        } else {
                                            phi_1160_ = true;
                                        }
                                        let _e912 = phi_1160_;
                                        phi_1161_ = _e912;
                                        phi_1162_ = false;
                                        phi_1163_ = false;
                                        phi_1164_ = false;
                                    } else {
                                        phi_1161_ = bool();
                                        phi_1162_ = _e894;
                                        phi_1163_ = _e896;
                                        phi_1164_ = _e898;
                                    }
                                    let _e914 = phi_1161_;
                                    let _e916 = phi_1162_;
                                    let _e918 = phi_1163_;
                                    let _e920 = phi_1164_;
                                    if _e916 {
                                        phi_1168_ = _e888;
                                        phi_1169_ = false;
                                        phi_1170_ = false;
                                    } else {
                                        phi_1168_ = _e914;
                                        phi_1169_ = _e918;
                                        phi_1170_ = _e920;
                                    }
                                    let _e922 = phi_1168_;
                                    let _e924 = phi_1169_;
                                    let _e926 = phi_1170_;
                                    if _e924 {
                                        phi_1174_ = false;
                                        phi_1175_ = true;
                                    } else {
                                        phi_1174_ = _e890;
                                        phi_1175_ = _e926;
                                    }
                                    let _e928 = phi_1174_;
                                    let _e930 = phi_1175_;
                                    if _e930 {
                                        phi_1179_ = _e928;
                                    } else {
                                        phi_1179_ = _e922;
                                    }
                                    let _e932 = phi_1179_;
                                    phi_1180_ = _e932;
                                }
                                let _e934 = phi_1180_;
                                if _e733.all_remove {
                                    if (((_e852 & 1u) != 0u) == _e255) {
                                        if ((_e852 & 2u) != 0u) {
                                            phi_1198_ = (((_e852 & 4u) != 0u) == _e255);
                                        } else {
                                            phi_1198_ = true;
                                        }
                                        let _e944 = phi_1198_;
                                        phi_1199_ = _e944;
                                    } else {
                                        phi_1199_ = false;
                                    }
                                    let _e946 = phi_1199_;
                                    phi_1200_ = _e946;
                                } else {
                                    phi_1200_ = false;
                                }
                                let _e948 = phi_1200_;
                                phi_935_ = (_e731 + 1u);
                                phi_938_ = lt_mask_Neighbourhood(_e934, _e948);
                            } else {
                                phi_935_ = u32();
                                phi_938_ = lt_mask_Neighbourhood();
                            }
                            let _e952 = phi_935_;
                            let _e954 = phi_938_;
                            continue;
                            continuing {
                                phi_934_ = _e952;
                                phi_937_ = _e954;
                                break if !(_e745);
                            }
                        }
                        let _e1251 = local_1;
                        phi_1203_ = _e1251;
                    }
                    let _e957 = phi_1203_;
                    phi_1204_ = _e957;
                } else {
                    phi_1204_ = _e716;
                }
                let _e959 = phi_1204_;
                phi_1205_ = _e959;
            } else {
                phi_1205_ = _e716;
            }
            let _e961 = phi_1205_;
            let _e964 = p.member.frame;
            let _e966 = p.member.refresh;
            if (_e966 == 0u) {
                phi_1238_ = false;
            } else {
                if (_e966 == 0u) {
                    return;
                }
                let _e975 = ((_e56.x + (_e56.y * (((_e966 * 5u) / 8u) | 1u))) + (_e964 % _e966));
                if (_e966 == 0u) {
                    phi_1237_ = (_e975 == 0u);
                } else {
                    if (_e966 == 0u) {
                        return;
                    }
                    phi_1237_ = ((_e975 % _e966) == 0u);
                }
                let _e982 = phi_1237_;
                phi_1238_ = _e982;
            }
            let _e984 = phi_1238_;
            if _e709 {
                if _e984 {
                    phi_1260_ = bool();
                } else {
                    phi_1260_ = ((0u & 2u) != 0u);
                }
                let _e990 = phi_1260_;
                phi_1261_ = _e990;
                phi_1262_ = _e984;
            } else {
                phi_1261_ = bool();
                phi_1262_ = true;
            }
            let _e992 = phi_1261_;
            let _e994 = phi_1262_;
            if _e994 {
                phi_1266_ = false;
            } else {
                phi_1266_ = _e992;
            }
            let _e996 = phi_1266_;
            if _e996 {
                phi_1317_ = 7u;
            } else {
                if (_e97 != 0.5f) {
                    if _e709 {
                        if _e984 {
                            phi_1314_ = 6u;
                        } else {
                            if _e259 {
                                phi_1289_ = true;
                            } else {
                                if _e961.any_expands {
                                    phi_1288_ = false;
                                } else {
                                    phi_1288_ = true;
                                }
                                let _e998 = phi_1288_;
                                phi_1289_ = _e998;
                            }
                            let _e1000 = phi_1289_;
                            if _e1000 {
                                if _e259 {
                                    if false {
                                        if _e961.all_remove {
                                            phi_1302_ = false;
                                        } else {
                                            phi_1302_ = true;
                                        }
                                        let _e1002 = phi_1302_;
                                        phi_1303_ = _e1002;
                                    } else {
                                        phi_1303_ = true;
                                    }
                                    let _e1004 = phi_1303_;
                                    phi_1304_ = _e1004;
                                } else {
                                    phi_1304_ = true;
                                }
                                let _e1006 = phi_1304_;
                                if _e1006 {
                                    if _e259 {
                                        phi_1311_ = 1u;
                                    } else {
                                        phi_1311_ = 0u;
                                    }
                                    let _e1008 = phi_1311_;
                                    phi_1312_ = _e1008;
                                } else {
                                    phi_1312_ = 5u;
                                }
                                let _e1010 = phi_1312_;
                                phi_1313_ = _e1010;
                            } else {
                                phi_1313_ = 4u;
                            }
                            let _e1012 = phi_1313_;
                            phi_1314_ = _e1012;
                        }
                        let _e1014 = phi_1314_;
                        phi_1315_ = _e1014;
                    } else {
                        phi_1315_ = 3u;
                    }
                    let _e1016 = phi_1315_;
                    phi_1316_ = _e1016;
                } else {
                    phi_1316_ = 2u;
                }
                let _e1018 = phi_1316_;
                phi_1317_ = _e1018;
            }
            let _e1020 = phi_1317_;
            if !((_e1020 == 0u)) {
                if !((_e1020 == 5u)) {
                    phi_1329_ = !(_e996);
                    phi_1330_ = false;
                } else {
                    phi_1329_ = bool();
                    phi_1330_ = true;
                }
                let _e1027 = phi_1329_;
                let _e1029 = phi_1330_;
                phi_1331_ = _e1027;
                phi_1332_ = _e1029;
            } else {
                phi_1331_ = bool();
                phi_1332_ = true;
            }
            let _e1031 = phi_1331_;
            let _e1033 = phi_1332_;
            if _e1033 {
                phi_1336_ = false;
            } else {
                phi_1336_ = _e1031;
            }
            let _e1035 = phi_1336_;
            if _e996 {
                phi_1342_ = ((0u & 4u) != 0u);
            } else {
                phi_1342_ = _e255;
            }
            let _e1039 = phi_1342_;
            if _e1035 {
                if _e255 {
                    phi_1350_ = (2u | 1u);
                } else {
                    phi_1350_ = 2u;
                }
                let _e1042 = phi_1350_;
                if false {
                    phi_1355_ = (_e1042 | 4u);
                } else {
                    phi_1355_ = _e1042;
                }
                let _e1045 = phi_1355_;
                phi_1375_ = _e1045;
            } else {
                if (_e1020 == 7u) {
                    if _e255 {
                        phi_1364_ = (2u | 1u);
                    } else {
                        phi_1364_ = 2u;
                    }
                    let _e1049 = phi_1364_;
                    if _e1039 {
                        phi_1369_ = (_e1049 | 4u);
                    } else {
                        phi_1369_ = _e1049;
                    }
                    let _e1052 = phi_1369_;
                    phi_1374_ = _e1052;
                } else {
                    if _e255 {
                        phi_1373_ = 1u;
                    } else {
                        phi_1373_ = 0u;
                    }
                    let _e1054 = phi_1373_;
                    phi_1374_ = _e1054;
                }
                let _e1056 = phi_1374_;
                phi_1375_ = _e1056;
            }
            let _e1058 = phi_1375_;
            if _e1039 {
                phi_1379_ = 0f;
            } else {
                phi_1379_ = 1f;
            }
            let _e1060 = phi_1379_;
            phi_1381_ = mask_Masked(_e1060, _e1058, _e1035);
        }
        let _e1063 = phi_1381_;
        visibility.member[_e73.shift] = _e1063.visibility;
        let _e1068 = p.member.light.number;
        let _e1069 = (_e1068 * 3u);
        let _e1071 = (_e1069 % 32u);
        let _e1073 = p.member.light.mask_words;
        let _e1075 = ((_e73.shift * _e1073) + (_e1069 / 32u));
        let _e1077 = bits.member[_e1075];
        bits.member[_e1075] = ((_e1077 & ~((7u << bitcast<u32>((_e1071 & 31u))))) | (_e1063.bits << bitcast<u32>((_e1071 & 31u))));
        if (_e1071 > 29u) {
            let _e1092 = bits.member[(_e1075 + 1u)];
            let _e1094 = (32u - _e1071);
            bits.member[(_e1075 + 1u)] = ((_e1092 & ~((7u >> bitcast<u32>((_e1094 & 31u))))) | (_e1063.bits >> bitcast<u32>((_e1094 & 31u))));
        }
        phi_1431_ = _e1063.needs_ray;
        phi_1432_ = _e73.shift;
    } else {
        phi_1431_ = false;
        phi_1432_ = 0u;
    }
    let _e1108 = phi_1431_;
    let _e1110 = phi_1432_;
    if (_e57 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1108 {
        let _e1114 = atomicAdd((&shared_[0u]), 1u);
        phi_1443_ = _e1114;
    } else {
        phi_1443_ = 0u;
    }
    let _e1116 = phi_1443_;
    workgroupBarrier();
    if (_e57 == 0u) {
        let _e1120 = atomicLoad((&shared_[0u]));
        let _e1121 = atomicAdd((&list.member[3u]), _e1120);
        atomicStore((&shared_[1u]), _e1121);
    }
    workgroupBarrier();
    if _e1108 {
        let _e1124 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1124) + _e1116)]), _e1110);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
