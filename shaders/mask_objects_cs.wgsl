struct abi_CameraParams {
    eye: vec3<f32>,
    root: u32,
    right: vec3<f32>,
    pad0_: u32,
    up: vec3<f32>,
    pad1_: u32,
    forward: vec3<f32>,
    pad2_: u32,
    size: vec2<u32>,
    pad3_: vec2<u32>,
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
    var phi_176_: lt_mask_LightPlace;
    var phi_177_: bool;
    var phi_178_: lt_mask_LightPlace;
    var phi_179_: bool;
    var phi_184_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_176_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_177_ = false;
        } else {
            phi_176_ = lt_mask_LightPlace();
            phi_177_ = true;
        }
        let _e68 = phi_176_;
        let _e70 = phi_177_;
        phi_178_ = _e68;
        phi_179_ = _e70;
    } else {
        phi_178_ = lt_mask_LightPlace();
        phi_179_ = true;
    }
    let _e72 = phi_178_;
    let _e74 = phi_179_;
    if _e74 {
        phi_184_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_184_ = _e72;
    }
    let _e79 = phi_184_;
    return lt_mask_LightPlace(_e79.word, _e79.shift);
}

fn lt_mask_pattern_plus(param_3: u32) -> vec2<i32> {
    var phi_202_: vec2<i32>;

    switch bitcast<i32>((param_3 % 5u)) {
        case 0: {
            phi_202_ = vec2(0i);
            break;
        }
        case 1: {
            phi_202_ = vec2<i32>(0i, -1i);
            break;
        }
        case 2: {
            phi_202_ = vec2<i32>(-1i, 0i);
            break;
        }
        case 3: {
            phi_202_ = vec2<i32>(1i, 0i);
            break;
        }
        default: {
            phi_202_ = vec2<i32>(0i, 1i);
            break;
        }
    }
    let _e64 = phi_202_;
    return vec2<i32>(_e64.x, _e64.y);
}

fn lt_mask_pattern_cross(param_4: u32) -> vec2<i32> {
    var phi_220_: vec2<i32>;

    switch bitcast<i32>((param_4 % 5u)) {
        case 0: {
            phi_220_ = vec2(0i);
            break;
        }
        case 1: {
            phi_220_ = vec2(-1i);
            break;
        }
        case 2: {
            phi_220_ = vec2<i32>(1i, -1i);
            break;
        }
        case 3: {
            phi_220_ = vec2<i32>(-1i, 1i);
            break;
        }
        default: {
            phi_220_ = vec2(1i);
            break;
        }
    }
    let _e64 = phi_220_;
    return vec2<i32>(_e64.x, _e64.y);
}

fn lt_mask_pattern_plus_or_cross(param_5: u32, param_6: u32) -> vec2<i32> {
    var phi_239_: vec2<i32>;

    if (param_6 == 0u) {
        let _e58 = lt_mask_pattern_plus(param_5);
        phi_239_ = vec2<i32>(_e58.x, _e58.y);
    } else {
        let _e62 = lt_mask_pattern_cross(param_5);
        phi_239_ = vec2<i32>(_e62.x, _e62.y);
    }
    let _e67 = phi_239_;
    return vec2<i32>(_e67.x, _e67.y);
}

fn lt_mask_pattern_diamond(param_7: u32) -> vec2<i32> {
    var phi_264_: vec2<i32>;

    let _e56 = (param_7 % 13u);
    switch bitcast<i32>(_e56) {
        case 9: {
            phi_264_ = vec2<i32>(0i, -2i);
            break;
        }
        case 10: {
            phi_264_ = vec2<i32>(-2i, 0i);
            break;
        }
        case 11: {
            phi_264_ = vec2<i32>(2i, 0i);
            break;
        }
        case 12: {
            phi_264_ = vec2<i32>(0i, 2i);
            break;
        }
        default: {
            phi_264_ = vec2<i32>((bitcast<i32>((_e56 % 3u)) - 1i), (bitcast<i32>(((_e56 / 3u) % 3u)) - 1i));
            break;
        }
    }
    let _e71 = phi_264_;
    return vec2<i32>(_e71.x, _e71.y);
}

fn lt_mask_pattern_step_clamped(param_8: u32, param_9: i32, param_10: u32) -> u32 {
    var phi_285_: u32;
    var phi_286_: u32;

    let _e59 = (bitcast<i32>(param_8) + param_9);
    if (_e59 < 0i) {
        phi_286_ = 0u;
    } else {
        if (_e59 >= bitcast<i32>(param_10)) {
            phi_285_ = (param_10 - 1u);
        } else {
            phi_285_ = bitcast<u32>(_e59);
        }
        let _e66 = phi_285_;
        phi_286_ = _e66;
    }
    let _e68 = phi_286_;
    return _e68;
}

fn function_() {
    var phi_362_: bool;
    var phi_363_: bool;
    var phi_364_: bool;
    var phi_365_: bool;
    var phi_369_: bool;
    var phi_439_: bool;
    var phi_440_: bool;
    var phi_451_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_452_: bool;
    var phi_453_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_454_: bool;
    var phi_461_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_465_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_478_: bool;
    var phi_664_: f32;
    var phi_669_: f32;
    var phi_670_: bool;
    var phi_671_: f32;
    var phi_672_: bool;
    var phi_676_: f32;
    var phi_699_: f32;
    var phi_704_: f32;
    var phi_705_: bool;
    var phi_706_: f32;
    var phi_707_: bool;
    var phi_711_: f32;
    var phi_732_: bool;
    var phi_751_: vec2<u32>;
    var phi_752_: bool;
    var phi_753_: bool;
    var phi_754_: bool;
    var phi_755_: vec2<u32>;
    var phi_756_: bool;
    var phi_757_: bool;
    var phi_758_: bool;
    var phi_759_: bool;
    var phi_760_: bool;
    var phi_761_: bool;
    var phi_762_: vec2<u32>;
    var phi_763_: bool;
    var phi_764_: bool;
    var phi_765_: bool;
    var phi_766_: bool;
    var phi_767_: bool;
    var phi_768_: bool;
    var phi_769_: vec2<u32>;
    var phi_770_: bool;
    var phi_771_: bool;
    var phi_772_: bool;
    var phi_773_: bool;
    var phi_782_: bool;
    var phi_783_: bool;
    var phi_784_: bool;
    var phi_785_: bool;
    var phi_789_: bool;
    var phi_790_: bool;
    var phi_791_: vec2<u32>;
    var phi_830_: bool;
    var phi_831_: bool;
    var phi_833_: bool;
    var phi_834_: lt_mask_Reprojection;
    var phi_835_: lt_mask_Reprojection;
    var phi_836_: bool;
    var phi_840_: bool;
    var phi_841_: lt_mask_Reprojection;
    var phi_882_: u32;
    var phi_901_: u32;
    var phi_909_: u32;
    var phi_910_: u32;
    var phi_911_: bool;
    var phi_912_: u32;
    var phi_913_: bool;
    var phi_914_: bool;
    var phi_915_: u32;
    var phi_916_: bool;
    var phi_917_: bool;
    var phi_921_: bool;
    var phi_925_: u32;
    var phi_930_: bool;
    var phi_952_: u32;
    var phi_954_: u32;
    var phi_957_: lt_mask_Neighbourhood;
    var phi_969_: bool;
    var phi_970_: bool;
    var phi_979_: u32;
    var phi_980_: u32;
    var phi_1040_: vec2<i32>;
    var phi_1060_: vec2<i32>;
    var phi_1085_: u32;
    var phi_1104_: u32;
    var phi_1112_: u32;
    var phi_1138_: bool;
    var phi_1139_: bool;
    var phi_1140_: bool;
    var phi_1141_: bool;
    var phi_1142_: bool;
    var phi_1143_: bool;
    var phi_1144_: bool;
    var phi_1149_: bool;
    var phi_1150_: bool;
    var phi_1151_: bool;
    var phi_1152_: bool;
    var phi_1153_: bool;
    var phi_1154_: bool;
    var phi_1155_: bool;
    var phi_1156_: bool;
    var phi_1157_: bool;
    var phi_1172_: bool;
    var phi_1173_: bool;
    var phi_1180_: bool;
    var phi_1181_: bool;
    var phi_1182_: bool;
    var phi_1183_: bool;
    var phi_1184_: bool;
    var phi_1188_: bool;
    var phi_1189_: bool;
    var phi_1190_: bool;
    var phi_1194_: bool;
    var phi_1195_: bool;
    var phi_1199_: bool;
    var phi_1200_: bool;
    var phi_1218_: bool;
    var phi_1219_: bool;
    var phi_1220_: bool;
    var phi_955_: u32;
    var phi_958_: lt_mask_Neighbourhood;
    var phi_1223_: lt_mask_Neighbourhood;
    var phi_1224_: lt_mask_Neighbourhood;
    var phi_1225_: lt_mask_Neighbourhood;
    var phi_1257_: bool;
    var phi_1258_: bool;
    var phi_1280_: bool;
    var phi_1281_: bool;
    var phi_1282_: bool;
    var phi_1286_: bool;
    var phi_1308_: bool;
    var phi_1309_: bool;
    var phi_1322_: bool;
    var phi_1323_: bool;
    var phi_1324_: bool;
    var phi_1331_: u32;
    var phi_1332_: u32;
    var phi_1333_: u32;
    var phi_1334_: u32;
    var phi_1335_: u32;
    var phi_1336_: u32;
    var phi_1337_: u32;
    var phi_1349_: bool;
    var phi_1350_: bool;
    var phi_1351_: bool;
    var phi_1352_: bool;
    var phi_1356_: bool;
    var phi_1362_: bool;
    var phi_1370_: u32;
    var phi_1375_: u32;
    var phi_1384_: u32;
    var phi_1389_: u32;
    var phi_1393_: u32;
    var phi_1394_: u32;
    var phi_1395_: u32;
    var phi_1399_: f32;
    var phi_1401_: mask_Masked;
    var phi_1451_: bool;
    var phi_1452_: u32;
    var phi_1463_: u32;
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
                phi_362_ = (_e112 == _e114);
                phi_363_ = false;
            } else {
                phi_362_ = bool();
                phi_363_ = true;
            }
            let _e117 = phi_362_;
            let _e119 = phi_363_;
            phi_364_ = _e117;
            phi_365_ = _e119;
        } else {
            phi_364_ = bool();
            phi_365_ = true;
        }
        let _e121 = phi_364_;
        let _e123 = phi_365_;
        if _e123 {
            phi_369_ = false;
        } else {
            phi_369_ = _e121;
        }
        let _e125 = phi_369_;
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
                    phi_440_ = true;
                } else {
                    let _e178 = p.member.light.range_squared;
                    if (_e161 <= _e178) {
                        let _e181 = p.member.light.cos_outer;
                        phi_439_ = (-((((_e143 * _e163.x) + (_e144 * _e163.y)) + (_e145 * _e163.z))) >= (_e181 * sqrt(_e161)));
                    } else {
                        phi_439_ = false;
                    }
                    let _e186 = phi_439_;
                    phi_440_ = _e186;
                }
                let _e188 = phi_440_;
                if _e188 {
                    let _e190 = samples.member[_e72.shift].flags;
                    let _e198 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e204 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e198.unnamed.visibility, false), _e198.unnamed_1);
                    phi_451_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e204.unnamed, ((_e190 & 1u) == 0u));
                    phi_452_ = false;
                } else {
                    phi_451_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_452_ = true;
                }
                let _e209 = phi_451_;
                let _e211 = phi_452_;
                phi_453_ = _e209;
                phi_454_ = _e211;
            } else {
                phi_453_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_454_ = true;
            }
            let _e213 = phi_453_;
            let _e215 = phi_454_;
            if _e215 {
                let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e227 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e221.unnamed.visibility, false), _e221.unnamed_1);
                phi_461_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e227.unnamed, true);
            } else {
                phi_461_ = _e213;
            }
            let _e232 = phi_461_;
            phi_465_ = _e232;
        } else {
            let _e238 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e244 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e238.unnamed.visibility, false), _e238.unnamed_1);
            phi_465_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e244.unnamed, true);
        }
        let _e249 = phi_465_;
        if _e249.unnamed_1 {
            phi_1401_ = mask_Masked(_e249.unnamed.visibility, 0u, false);
        } else {
            let _e254 = (_e96 < 0.5f);
            if (_e96 > 0f) {
                phi_478_ = (_e96 < 1f);
            } else {
                phi_478_ = false;
            }
            let _e258 = phi_478_;
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
            let _e419 = p.member.current.size[0u];
            let _e421 = p.member.current.size[1u];
            let _e425 = ((f32(_e55.x) + 0.5f) + _e409);
            if (_e425 > -8388608f) {
                let _e437 = f32(select(0i, select(select(i32(_e425), i32(-2147483648), (_e425 < bitcast<f32>(3472883712u))), 2147483647i, (_e425 > bitcast<f32>(1325400063u))), (_e425 == _e425)));
                if (_e437 > _e425) {
                    phi_664_ = 1f;
                } else {
                    phi_664_ = 0f;
                }
                let _e440 = phi_664_;
                if (_e425 < 8388608f) {
                    phi_669_ = (_e437 - _e440);
                    phi_670_ = false;
                } else {
                    phi_669_ = f32();
                    phi_670_ = true;
                }
                let _e443 = phi_669_;
                let _e445 = phi_670_;
                phi_671_ = _e443;
                phi_672_ = _e445;
            } else {
                phi_671_ = f32();
                phi_672_ = true;
            }
            let _e447 = phi_671_;
            let _e449 = phi_672_;
            if _e449 {
                phi_676_ = _e425;
            } else {
                phi_676_ = _e447;
            }
            let _e451 = phi_676_;
            let _e454 = ((f32(_e55.y) + 0.5f) + _e415);
            if (_e454 > -8388608f) {
                let _e466 = f32(select(0i, select(select(i32(_e454), i32(-2147483648), (_e454 < bitcast<f32>(3472883712u))), 2147483647i, (_e454 > bitcast<f32>(1325400063u))), (_e454 == _e454)));
                if (_e466 > _e454) {
                    phi_699_ = 1f;
                } else {
                    phi_699_ = 0f;
                }
                let _e469 = phi_699_;
                if (_e454 < 8388608f) {
                    phi_704_ = (_e466 - _e469);
                    phi_705_ = false;
                } else {
                    phi_704_ = f32();
                    phi_705_ = true;
                }
                let _e472 = phi_704_;
                let _e474 = phi_705_;
                phi_706_ = _e472;
                phi_707_ = _e474;
            } else {
                phi_706_ = f32();
                phi_707_ = true;
            }
            let _e476 = phi_706_;
            let _e478 = phi_707_;
            if _e478 {
                phi_711_ = _e454;
            } else {
                phi_711_ = _e476;
            }
            let _e480 = phi_711_;
            if (_e451 >= 0f) {
                if (_e480 >= 0f) {
                    if (_e451 < f32(_e419)) {
                        let _e486 = (_e480 < f32(_e421));
                        if (_e409 == 0f) {
                            phi_732_ = (_e415 == 0f);
                        } else {
                            phi_732_ = false;
                        }
                        let _e490 = phi_732_;
                        if _e486 {
                            phi_751_ = vec2<u32>(select(select(u32(_e451), 0u, (_e451 < bitcast<f32>(0u))), 4294967295u, (_e451 > bitcast<f32>(1333788671u))), select(select(u32(_e480), 0u, (_e480 < bitcast<f32>(0u))), 4294967295u, (_e480 > bitcast<f32>(1333788671u))));
                            phi_752_ = false;
                        } else {
                            phi_751_ = vec2<u32>();
                            phi_752_ = true;
                        }
                        let _e507 = phi_751_;
                        let _e509 = phi_752_;
                        phi_753_ = _e490;
                        phi_754_ = _e486;
                        phi_755_ = _e507;
                        phi_756_ = _e490;
                        phi_757_ = _e486;
                        phi_758_ = false;
                        phi_759_ = _e509;
                    } else {
                        phi_753_ = bool();
                        phi_754_ = bool();
                        phi_755_ = vec2<u32>();
                        phi_756_ = bool();
                        phi_757_ = bool();
                        phi_758_ = true;
                        phi_759_ = false;
                    }
                    let _e511 = phi_753_;
                    let _e513 = phi_754_;
                    let _e515 = phi_755_;
                    let _e517 = phi_756_;
                    let _e519 = phi_757_;
                    let _e521 = phi_758_;
                    let _e523 = phi_759_;
                    phi_760_ = _e511;
                    phi_761_ = _e513;
                    phi_762_ = _e515;
                    phi_763_ = _e517;
                    phi_764_ = _e519;
                    phi_765_ = _e521;
                    phi_766_ = _e523;
                } else {
                    phi_760_ = bool();
                    phi_761_ = bool();
                    phi_762_ = vec2<u32>();
                    phi_763_ = bool();
                    phi_764_ = bool();
                    phi_765_ = true;
                    phi_766_ = false;
                }
                let _e525 = phi_760_;
                let _e527 = phi_761_;
                let _e529 = phi_762_;
                let _e531 = phi_763_;
                let _e533 = phi_764_;
                let _e535 = phi_765_;
                let _e537 = phi_766_;
                phi_767_ = _e525;
                phi_768_ = _e527;
                phi_769_ = _e529;
                phi_770_ = _e531;
                phi_771_ = _e533;
                phi_772_ = _e535;
                phi_773_ = _e537;
            } else {
                phi_767_ = bool();
                phi_768_ = bool();
                phi_769_ = vec2<u32>();
                phi_770_ = bool();
                phi_771_ = bool();
                phi_772_ = true;
                phi_773_ = false;
            }
            let _e539 = phi_767_;
            let _e541 = phi_768_;
            let _e543 = phi_769_;
            let _e545 = phi_770_;
            let _e547 = phi_771_;
            let _e549 = phi_772_;
            let _e551 = phi_773_;
            if _e549 {
                if (_e409 == 0f) {
                    phi_782_ = (_e415 == 0f);
                } else {
                    phi_782_ = false;
                }
                let _e555 = phi_782_;
                phi_783_ = _e555;
                phi_784_ = false;
                phi_785_ = true;
            } else {
                phi_783_ = _e545;
                phi_784_ = _e547;
                phi_785_ = _e551;
            }
            let _e557 = phi_783_;
            let _e559 = phi_784_;
            let _e561 = phi_785_;
            if _e561 {
                phi_789_ = _e557;
                phi_790_ = _e559;
                phi_791_ = vec2<u32>(_e55.x, _e55.y);
            } else {
                phi_789_ = _e539;
                phi_790_ = _e541;
                phi_791_ = _e543;
            }
            let _e563 = phi_789_;
            let _e565 = phi_790_;
            let _e567 = phi_791_;
            let _e577 = lt_mask_Reprojection(vec2<u32>(_e567.x, lt_mask_Reprojection().pixel.y), lt_mask_Reprojection().is_valid, lt_mask_Reprojection().has_moved);
            let _e584 = lt_mask_Reprojection(vec2<u32>(_e577.pixel.x, _e567.y), _e577.is_valid, _e577.has_moved);
            let _e588 = lt_mask_Reprojection(_e584.pixel, _e565, _e584.has_moved);
            let _e592 = lt_mask_Reprojection(_e588.pixel, _e588.is_valid, !(_e563));
            if _e565 {
                let _e595 = p.member.previous.eye;
                let _e603 = p.member.previous.forward;
                let _e612 = (((((_e91.x - _e595.x) * _e603.x) + ((_e91.y - _e595.y) * _e603.y)) + ((_e91.z - _e595.z) * _e603.z)) > 0f);
                let _e616 = lt_mask_Reprojection(_e592.pixel, _e612, _e592.has_moved);
                if _e612 {
                    let _e618 = p.member.flags;
                    phi_830_ = ((_e618 & 1u) != 0u);
                    phi_831_ = false;
                } else {
                    phi_830_ = bool();
                    phi_831_ = true;
                }
                let _e622 = phi_830_;
                let _e624 = phi_831_;
                phi_833_ = _e622;
                phi_834_ = _e616;
                phi_835_ = _e616;
                phi_836_ = _e624;
            } else {
                phi_833_ = bool();
                phi_834_ = lt_mask_Reprojection();
                phi_835_ = lt_mask_Reprojection(_e592.pixel, false, _e592.has_moved);
                phi_836_ = true;
            }
            let _e630 = phi_833_;
            let _e632 = phi_834_;
            let _e634 = phi_835_;
            let _e636 = phi_836_;
            if _e636 {
                phi_840_ = false;
                phi_841_ = _e634;
            } else {
                phi_840_ = _e630;
                phi_841_ = _e632;
            }
            let _e638 = phi_840_;
            let _e640 = phi_841_;
            let _e644 = lt_mask_Reprojection(_e640.pixel, _e638, _e640.has_moved);
            let _e646 = p.member.flags;
            let _e648 = ((_e646 & 2u) != 0u);
            let _e650 = p.member.flags;
            if ((_e650 & 4u) == 0u) {
                phi_915_ = u32();
                phi_916_ = true;
                phi_917_ = false;
            } else {
                if _e638 {
                    if !(_e644.has_moved) {
                        let _e658 = ((((_e55.y * _e88) + _e55.x) * _e84) + _e81);
                        if (_e82 > 29u) {
                            let _e660 = (_e658 + 1u);
                            if (_e660 < _e61) {
                            } else {
                                return;
                            }
                            let _e664 = last_bits.member[(0u + _e660)];
                            phi_882_ = _e664;
                        } else {
                            phi_882_ = 0u;
                        }
                        let _e666 = phi_882_;
                        if (_e658 < _e61) {
                        } else {
                            return;
                        }
                        let _e670 = last_bits.member[(0u + _e658)];
                        let _e673 = (_e670 >> bitcast<u32>((_e82 & 31u)));
                        if (_e82 > 29u) {
                            phi_901_ = (_e673 | (_e666 << bitcast<u32>(((32u - _e82) & 31u))));
                        } else {
                            phi_901_ = _e673;
                        }
                        let _e681 = phi_901_;
                        if ((_e681 & 2u) == 0u) {
                            phi_909_ = (_e681 & 1u);
                        } else {
                            phi_909_ = (_e681 & 7u);
                        }
                        let _e687 = phi_909_;
                        phi_910_ = _e687;
                        phi_911_ = false;
                    } else {
                        phi_910_ = u32();
                        phi_911_ = true;
                    }
                    let _e689 = phi_910_;
                    let _e691 = phi_911_;
                    phi_912_ = _e689;
                    phi_913_ = false;
                    phi_914_ = _e691;
                } else {
                    phi_912_ = u32();
                    phi_913_ = true;
                    phi_914_ = false;
                }
                let _e693 = phi_912_;
                let _e695 = phi_913_;
                let _e697 = phi_914_;
                phi_915_ = _e693;
                phi_916_ = _e695;
                phi_917_ = _e697;
            }
            let _e699 = phi_915_;
            let _e701 = phi_916_;
            let _e703 = phi_917_;
            if _e701 {
                phi_921_ = true;
            } else {
                phi_921_ = _e703;
            }
            let _e705 = phi_921_;
            if _e705 {
                phi_925_ = 0u;
            } else {
                phi_925_ = _e699;
            }
            let _e707 = phi_925_;
            let _e708 = lt_mask_Neighbourhood(false, true);
            if _e258 {
                phi_930_ = _e648;
            } else {
                phi_930_ = true;
            }
            let _e710 = phi_930_;
            if _e710 {
                if _e638 {
                    if ((_e707 & 2u) != 0u) {
                        phi_1223_ = _e708;
                    } else {
                        let _e714 = p.member.expansion;
                        if _e644.has_moved {
                            let _e717 = p.member.moving_pattern;
                            phi_952_ = _e717;
                        } else {
                            let _e719 = p.member.still_pattern;
                            phi_952_ = _e719;
                        }
                        let _e721 = phi_952_;
                        phi_954_ = 0u;
                        phi_957_ = _e708;
                        loop {
                            let _e723 = phi_954_;
                            let _e725 = phi_957_;
                            local_1 = _e725;
                            if (1u <= _e721) {
                                if (_e721 <= 4u) {
                                    phi_969_ = false;
                                } else {
                                    phi_969_ = true;
                                }
                                let _e729 = phi_969_;
                                phi_970_ = _e729;
                            } else {
                                phi_970_ = true;
                            }
                            let _e731 = phi_970_;
                            if _e731 {
                                switch bitcast<i32>(_e721) {
                                    case 5: {
                                        phi_979_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_979_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_979_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_979_ = 9u;
                                        break;
                                    }
                                }
                                let _e734 = phi_979_;
                                phi_980_ = _e734;
                            } else {
                                phi_980_ = 5u;
                            }
                            let _e736 = phi_980_;
                            let _e737 = (_e723 < _e736);
                            if _e737 {
                                let _e743 = p.member.frame;
                                let _e747 = p.member.current.size[0u];
                                let _e749 = p.member.current.size[1u];
                                switch bitcast<i32>(_e721) {
                                    case 1: {
                                        let _e759 = lt_mask_pattern_plus(_e723);
                                        phi_1060_ = vec2<i32>(_e759.x, _e759.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e763 = lt_mask_pattern_cross(_e723);
                                        phi_1060_ = vec2<i32>(_e763.x, _e763.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e769 = lt_mask_pattern_plus_or_cross(_e723, ((_e644.pixel.x + _e644.pixel.y) & 1u));
                                        phi_1060_ = vec2<i32>(_e769.x, _e769.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e774 = lt_mask_pattern_plus_or_cross(_e723, (_e743 & 1u));
                                        phi_1060_ = vec2<i32>(_e774.x, _e774.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e743 & 3u)) {
                                            case 0: {
                                                phi_1040_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_1040_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_1040_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_1040_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e785 = phi_1040_;
                                        phi_1060_ = (_e785 + vec2<i32>(bitcast<i32>((_e723 & 1u)), bitcast<i32>(((_e723 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_1060_ = vec2<i32>((bitcast<i32>((_e723 % 5u)) - 2i), (bitcast<i32>(((_e723 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e802 = lt_mask_pattern_diamond(_e723);
                                        phi_1060_ = vec2<i32>(_e802.x, _e802.y);
                                        break;
                                    }
                                    default: {
                                        phi_1060_ = vec2<i32>((bitcast<i32>((_e723 % 3u)) - 1i), (bitcast<i32>(((_e723 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e807 = phi_1060_;
                                let _e810 = lt_mask_pattern_step_clamped(_e644.pixel.x, _e807.x, _e747);
                                let _e811 = lt_mask_pattern_step_clamped(_e644.pixel.y, _e807.y, _e749);
                                let _e815 = ((((_e811 * _e88) + _e810) * _e84) + _e81);
                                if (_e82 > 29u) {
                                    let _e817 = (_e815 + 1u);
                                    if (_e817 < _e61) {
                                    } else {
                                        return;
                                    }
                                    let _e821 = last_bits.member[(0u + _e817)];
                                    phi_1085_ = _e821;
                                } else {
                                    phi_1085_ = 0u;
                                }
                                let _e823 = phi_1085_;
                                if (_e815 < _e61) {
                                } else {
                                    return;
                                }
                                let _e827 = last_bits.member[(0u + _e815)];
                                let _e830 = (_e827 >> bitcast<u32>((_e82 & 31u)));
                                if (_e82 > 29u) {
                                    phi_1104_ = (_e830 | (_e823 << bitcast<u32>(((32u - _e82) & 31u))));
                                } else {
                                    phi_1104_ = _e830;
                                }
                                let _e838 = phi_1104_;
                                if ((_e838 & 2u) == 0u) {
                                    phi_1112_ = (_e838 & 1u);
                                } else {
                                    phi_1112_ = (_e838 & 7u);
                                }
                                let _e844 = phi_1112_;
                                if _e725.any_expands {
                                    phi_1200_ = true;
                                } else {
                                    if ((_e844 & 2u) != 0u) {
                                        let _e851 = (((_e844 & 4u) != 0u) != _e254);
                                        switch bitcast<i32>(_e714) {
                                            case 1: {
                                                phi_1140_ = bool();
                                                phi_1141_ = false;
                                                phi_1142_ = true;
                                                phi_1143_ = false;
                                                phi_1144_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e851 {
                                                    phi_1138_ = (((_e844 & 4u) != 0u) != ((_e844 & 1u) != 0u));
                                                    phi_1139_ = false;
                                                } else {
                                                    phi_1138_ = bool();
                                                    phi_1139_ = true;
                                                }
                                                let _e859 = phi_1138_;
                                                let _e861 = phi_1139_;
                                                phi_1140_ = _e859;
                                                phi_1141_ = false;
                                                phi_1142_ = false;
                                                phi_1143_ = _e861;
                                                phi_1144_ = _e851;
                                                break;
                                            }
                                            default: {
                                                phi_1140_ = bool();
                                                phi_1141_ = true;
                                                phi_1142_ = false;
                                                phi_1143_ = false;
                                                phi_1144_ = false;
                                                break;
                                            }
                                        }
                                        let _e863 = phi_1140_;
                                        let _e865 = phi_1141_;
                                        let _e867 = phi_1142_;
                                        let _e869 = phi_1143_;
                                        let _e871 = phi_1144_;
                                        phi_1152_ = _e851;
                                        phi_1153_ = _e863;
                                        phi_1154_ = _e865;
                                        phi_1155_ = _e867;
                                        phi_1156_ = _e869;
                                        phi_1157_ = _e871;
                                    } else {
                                        switch bitcast<i32>(_e714) {
                                            case 1: {
                                                phi_1149_ = false;
                                                phi_1150_ = true;
                                                phi_1151_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_1149_ = false;
                                                phi_1150_ = false;
                                                phi_1151_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_1149_ = true;
                                                phi_1150_ = false;
                                                phi_1151_ = false;
                                                break;
                                            }
                                        }
                                        let _e874 = phi_1149_;
                                        let _e876 = phi_1150_;
                                        let _e878 = phi_1151_;
                                        phi_1152_ = false;
                                        phi_1153_ = bool();
                                        phi_1154_ = _e874;
                                        phi_1155_ = _e876;
                                        phi_1156_ = _e878;
                                        phi_1157_ = false;
                                    }
                                    let _e880 = phi_1152_;
                                    let _e882 = phi_1153_;
                                    let _e884 = phi_1154_;
                                    let _e886 = phi_1155_;
                                    let _e888 = phi_1156_;
                                    let _e890 = phi_1157_;
                                    if _e884 {
                                        if ((_e844 & 2u) != 0u) {
                                            if (((_e844 & 4u) != 0u) != _e254) {
                                                phi_1172_ = false;
                                            } else {
                                                phi_1172_ = true;
                                            }
                                            let _e897 = phi_1172_;
                                            phi_1173_ = _e897;
                                        } else {
                                            phi_1173_ = true;
                                        }
                                        let _e899 = phi_1173_;
                                        if _e899 {
                                            phi_1180_ = (((_e844 & 1u) != 0u) != _e254);
                                        } else {
                                            phi_1180_ = true;
                                        }
                                        let _e904 = phi_1180_;
                                        phi_1181_ = _e904;
                                        phi_1182_ = false;
                                        phi_1183_ = false;
                                        phi_1184_ = false;
                                    } else {
                                        phi_1181_ = bool();
                                        phi_1182_ = _e886;
                                        phi_1183_ = _e888;
                                        phi_1184_ = _e890;
                                    }
                                    let _e906 = phi_1181_;
                                    let _e908 = phi_1182_;
                                    let _e910 = phi_1183_;
                                    let _e912 = phi_1184_;
                                    if _e908 {
                                        phi_1188_ = _e880;
                                        phi_1189_ = false;
                                        phi_1190_ = false;
                                    } else {
                                        phi_1188_ = _e906;
                                        phi_1189_ = _e910;
                                        phi_1190_ = _e912;
                                    }
                                    let _e914 = phi_1188_;
                                    let _e916 = phi_1189_;
                                    let _e918 = phi_1190_;
                                    if _e916 {
                                        phi_1194_ = false;
                                        phi_1195_ = true;
                                    } else {
                                        phi_1194_ = _e882;
                                        phi_1195_ = _e918;
                                    }
                                    let _e920 = phi_1194_;
                                    let _e922 = phi_1195_;
                                    if _e922 {
                                        phi_1199_ = _e920;
                                    } else {
                                        phi_1199_ = _e914;
                                    }
                                    let _e924 = phi_1199_;
                                    phi_1200_ = _e924;
                                }
                                let _e926 = phi_1200_;
                                if _e725.all_remove {
                                    if (((_e844 & 1u) != 0u) == _e254) {
                                        if ((_e844 & 2u) != 0u) {
                                            phi_1218_ = (((_e844 & 4u) != 0u) == _e254);
                                        } else {
                                            phi_1218_ = true;
                                        }
                                        let _e936 = phi_1218_;
                                        phi_1219_ = _e936;
                                    } else {
                                        phi_1219_ = false;
                                    }
                                    let _e938 = phi_1219_;
                                    phi_1220_ = _e938;
                                } else {
                                    phi_1220_ = false;
                                }
                                let _e940 = phi_1220_;
                                phi_955_ = (_e723 + 1u);
                                phi_958_ = lt_mask_Neighbourhood(_e926, _e940);
                            } else {
                                phi_955_ = u32();
                                phi_958_ = lt_mask_Neighbourhood();
                            }
                            let _e944 = phi_955_;
                            let _e946 = phi_958_;
                            continue;
                            continuing {
                                phi_954_ = _e944;
                                phi_957_ = _e946;
                                break if !(_e737);
                            }
                        }
                        let _e1248 = local_1;
                        phi_1223_ = _e1248;
                    }
                    let _e949 = phi_1223_;
                    phi_1224_ = _e949;
                } else {
                    phi_1224_ = _e708;
                }
                let _e951 = phi_1224_;
                phi_1225_ = _e951;
            } else {
                phi_1225_ = _e708;
            }
            let _e953 = phi_1225_;
            let _e956 = p.member.frame;
            let _e958 = p.member.refresh;
            if (_e958 == 0u) {
                phi_1258_ = false;
            } else {
                if (_e958 == 0u) {
                    return;
                }
                let _e967 = ((_e55.x + (_e55.y * (((_e958 * 5u) / 8u) | 1u))) + (_e956 % _e958));
                if (_e958 == 0u) {
                    phi_1257_ = (_e967 == 0u);
                } else {
                    if (_e958 == 0u) {
                        return;
                    }
                    phi_1257_ = ((_e967 % _e958) == 0u);
                }
                let _e974 = phi_1257_;
                phi_1258_ = _e974;
            }
            let _e976 = phi_1258_;
            if _e638 {
                if _e976 {
                    phi_1280_ = bool();
                } else {
                    phi_1280_ = ((_e707 & 2u) != 0u);
                }
                let _e982 = phi_1280_;
                phi_1281_ = _e982;
                phi_1282_ = _e976;
            } else {
                phi_1281_ = bool();
                phi_1282_ = true;
            }
            let _e984 = phi_1281_;
            let _e986 = phi_1282_;
            if _e986 {
                phi_1286_ = false;
            } else {
                phi_1286_ = _e984;
            }
            let _e988 = phi_1286_;
            if _e988 {
                phi_1337_ = 7u;
            } else {
                if (_e96 != 0.5f) {
                    if _e638 {
                        if _e976 {
                            phi_1334_ = 6u;
                        } else {
                            if _e258 {
                                phi_1309_ = true;
                            } else {
                                if _e953.any_expands {
                                    phi_1308_ = false;
                                } else {
                                    phi_1308_ = true;
                                }
                                let _e990 = phi_1308_;
                                phi_1309_ = _e990;
                            }
                            let _e992 = phi_1309_;
                            if _e992 {
                                if _e258 {
                                    if _e648 {
                                        if _e953.all_remove {
                                            phi_1322_ = false;
                                        } else {
                                            phi_1322_ = true;
                                        }
                                        let _e994 = phi_1322_;
                                        phi_1323_ = _e994;
                                    } else {
                                        phi_1323_ = true;
                                    }
                                    let _e996 = phi_1323_;
                                    phi_1324_ = _e996;
                                } else {
                                    phi_1324_ = true;
                                }
                                let _e998 = phi_1324_;
                                if _e998 {
                                    if _e258 {
                                        phi_1331_ = 1u;
                                    } else {
                                        phi_1331_ = 0u;
                                    }
                                    let _e1000 = phi_1331_;
                                    phi_1332_ = _e1000;
                                } else {
                                    phi_1332_ = 5u;
                                }
                                let _e1002 = phi_1332_;
                                phi_1333_ = _e1002;
                            } else {
                                phi_1333_ = 4u;
                            }
                            let _e1004 = phi_1333_;
                            phi_1334_ = _e1004;
                        }
                        let _e1006 = phi_1334_;
                        phi_1335_ = _e1006;
                    } else {
                        phi_1335_ = 3u;
                    }
                    let _e1008 = phi_1335_;
                    phi_1336_ = _e1008;
                } else {
                    phi_1336_ = 2u;
                }
                let _e1010 = phi_1336_;
                phi_1337_ = _e1010;
            }
            let _e1012 = phi_1337_;
            if !((_e1012 == 0u)) {
                if !((_e1012 == 5u)) {
                    phi_1349_ = !(_e988);
                    phi_1350_ = false;
                } else {
                    phi_1349_ = bool();
                    phi_1350_ = true;
                }
                let _e1019 = phi_1349_;
                let _e1021 = phi_1350_;
                phi_1351_ = _e1019;
                phi_1352_ = _e1021;
            } else {
                phi_1351_ = bool();
                phi_1352_ = true;
            }
            let _e1023 = phi_1351_;
            let _e1025 = phi_1352_;
            if _e1025 {
                phi_1356_ = false;
            } else {
                phi_1356_ = _e1023;
            }
            let _e1027 = phi_1356_;
            if _e988 {
                phi_1362_ = ((_e707 & 4u) != 0u);
            } else {
                phi_1362_ = _e254;
            }
            let _e1031 = phi_1362_;
            if _e1027 {
                if _e254 {
                    phi_1370_ = (2u | 1u);
                } else {
                    phi_1370_ = 2u;
                }
                let _e1034 = phi_1370_;
                if false {
                    phi_1375_ = (_e1034 | 4u);
                } else {
                    phi_1375_ = _e1034;
                }
                let _e1037 = phi_1375_;
                phi_1395_ = _e1037;
            } else {
                if (_e1012 == 7u) {
                    if _e254 {
                        phi_1384_ = (2u | 1u);
                    } else {
                        phi_1384_ = 2u;
                    }
                    let _e1041 = phi_1384_;
                    if _e1031 {
                        phi_1389_ = (_e1041 | 4u);
                    } else {
                        phi_1389_ = _e1041;
                    }
                    let _e1044 = phi_1389_;
                    phi_1394_ = _e1044;
                } else {
                    if _e254 {
                        phi_1393_ = 1u;
                    } else {
                        phi_1393_ = 0u;
                    }
                    let _e1046 = phi_1393_;
                    phi_1394_ = _e1046;
                }
                let _e1048 = phi_1394_;
                phi_1395_ = _e1048;
            }
            let _e1050 = phi_1395_;
            if _e1031 {
                phi_1399_ = 0f;
            } else {
                phi_1399_ = 1f;
            }
            let _e1052 = phi_1399_;
            phi_1401_ = mask_Masked(_e1052, _e1050, _e1027);
        }
        let _e1055 = phi_1401_;
        visibility.member[_e72.shift] = _e1055.visibility;
        let _e1060 = p.member.light.number;
        let _e1061 = (_e1060 * 3u);
        let _e1063 = (_e1061 % 32u);
        let _e1065 = p.member.light.mask_words;
        let _e1067 = ((_e72.shift * _e1065) + (_e1061 / 32u));
        let _e1069 = bits.member[_e1067];
        bits.member[_e1067] = ((_e1069 & ~((7u << bitcast<u32>((_e1063 & 31u))))) | (_e1055.bits << bitcast<u32>((_e1063 & 31u))));
        if (_e1063 > 29u) {
            let _e1084 = bits.member[(_e1067 + 1u)];
            let _e1086 = (32u - _e1063);
            bits.member[(_e1067 + 1u)] = ((_e1084 & ~((7u >> bitcast<u32>((_e1086 & 31u))))) | (_e1055.bits >> bitcast<u32>((_e1086 & 31u))));
        }
        phi_1451_ = _e1055.needs_ray;
        phi_1452_ = _e72.shift;
    } else {
        phi_1451_ = false;
        phi_1452_ = 0u;
    }
    let _e1100 = phi_1451_;
    let _e1102 = phi_1452_;
    if (_e56 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1100 {
        let _e1106 = atomicAdd((&shared_[0u]), 1u);
        phi_1463_ = _e1106;
    } else {
        phi_1463_ = 0u;
    }
    let _e1108 = phi_1463_;
    workgroupBarrier();
    if (_e56 == 0u) {
        let _e1112 = atomicLoad((&shared_[0u]));
        let _e1113 = atomicAdd((&list.member[3u]), _e1112);
        atomicStore((&shared_[1u]), _e1113);
    }
    workgroupBarrier();
    if _e1100 {
        let _e1116 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1116) + _e1108)]), _e1102);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
