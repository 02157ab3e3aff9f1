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
    var phi_847_: bool;
    var phi_869_: u32;
    var phi_871_: u32;
    var phi_874_: lt_mask_Neighbourhood;
    var phi_886_: bool;
    var phi_887_: bool;
    var phi_896_: u32;
    var phi_897_: u32;
    var phi_957_: vec2<i32>;
    var phi_977_: vec2<i32>;
    var phi_1002_: u32;
    var phi_1021_: u32;
    var phi_1029_: u32;
    var phi_1055_: bool;
    var phi_1056_: bool;
    var phi_1057_: bool;
    var phi_1058_: bool;
    var phi_1059_: bool;
    var phi_1060_: bool;
    var phi_1061_: bool;
    var phi_1066_: bool;
    var phi_1067_: bool;
    var phi_1068_: bool;
    var phi_1069_: bool;
    var phi_1070_: bool;
    var phi_1071_: bool;
    var phi_1072_: bool;
    var phi_1073_: bool;
    var phi_1074_: bool;
    var phi_1089_: bool;
    var phi_1090_: bool;
    var phi_1097_: bool;
    var phi_1098_: bool;
    var phi_1099_: bool;
    var phi_1100_: bool;
    var phi_1101_: bool;
    var phi_1105_: bool;
    var phi_1106_: bool;
    var phi_1107_: bool;
    var phi_1111_: bool;
    var phi_1112_: bool;
    var phi_1116_: bool;
    var phi_1117_: bool;
    var phi_1135_: bool;
    var phi_1136_: bool;
    var phi_1137_: bool;
    var phi_872_: u32;
    var phi_875_: lt_mask_Neighbourhood;
    var phi_1140_: lt_mask_Neighbourhood;
    var phi_1141_: lt_mask_Neighbourhood;
    var phi_1142_: lt_mask_Neighbourhood;
    var phi_1174_: bool;
    var phi_1175_: bool;
    var phi_1197_: bool;
    var phi_1198_: bool;
    var phi_1199_: bool;
    var phi_1203_: bool;
    var phi_1225_: bool;
    var phi_1226_: bool;
    var phi_1239_: bool;
    var phi_1240_: bool;
    var phi_1241_: bool;
    var phi_1248_: u32;
    var phi_1249_: u32;
    var phi_1250_: u32;
    var phi_1251_: u32;
    var phi_1252_: u32;
    var phi_1253_: u32;
    var phi_1254_: u32;
    var phi_1266_: bool;
    var phi_1267_: bool;
    var phi_1268_: bool;
    var phi_1269_: bool;
    var phi_1273_: bool;
    var phi_1279_: bool;
    var phi_1287_: u32;
    var phi_1292_: u32;
    var phi_1301_: u32;
    var phi_1306_: u32;
    var phi_1310_: u32;
    var phi_1311_: u32;
    var phi_1312_: u32;
    var phi_1316_: f32;
    var phi_1318_: mask_Masked;
    var phi_1368_: bool;
    var phi_1369_: u32;
    var phi_1380_: u32;
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
            phi_1318_ = mask_Masked(_e249.unnamed.visibility, 0u, false);
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
            let _e645 = lt_mask_Neighbourhood(false, true);
            if _e258 {
                phi_847_ = false;
            } else {
                phi_847_ = true;
            }
            let _e647 = phi_847_;
            if _e647 {
                if _e638 {
                    if ((0u & 2u) != 0u) {
                        phi_1140_ = _e645;
                    } else {
                        let _e651 = p.member.expansion;
                        if _e644.has_moved {
                            let _e654 = p.member.moving_pattern;
                            phi_869_ = _e654;
                        } else {
                            let _e656 = p.member.still_pattern;
                            phi_869_ = _e656;
                        }
                        let _e658 = phi_869_;
                        phi_871_ = 0u;
                        phi_874_ = _e645;
                        loop {
                            let _e660 = phi_871_;
                            let _e662 = phi_874_;
                            local_1 = _e662;
                            if (1u <= _e658) {
                                if (_e658 <= 4u) {
                                    phi_886_ = false;
                                } else {
                                    phi_886_ = true;
                                }
                                let _e666 = phi_886_;
                                phi_887_ = _e666;
                            } else {
                                phi_887_ = true;
                            }
                            let _e668 = phi_887_;
                            if _e668 {
                                switch bitcast<i32>(_e658) {
                                    case 5: {
                                        phi_896_ = 4u;
                                        break;
                                    }
                                    case 6: {
                                        phi_896_ = 25u;
                                        break;
                                    }
                                    case 7: {
                                        phi_896_ = 13u;
                                        break;
                                    }
                                    default: {
                                        phi_896_ = 9u;
                                        break;
                                    }
                                }
                                let _e671 = phi_896_;
                                phi_897_ = _e671;
                            } else {
                                phi_897_ = 5u;
                            }
                            let _e673 = phi_897_;
                            let _e674 = (_e660 < _e673);
                            if _e674 {
                                let _e680 = p.member.frame;
                                let _e684 = p.member.current.size[0u];
                                let _e686 = p.member.current.size[1u];
                                switch bitcast<i32>(_e658) {
                                    case 1: {
                                        let _e696 = lt_mask_pattern_plus(_e660);
                                        phi_977_ = vec2<i32>(_e696.x, _e696.y);
                                        break;
                                    }
                                    case 2: {
                                        let _e700 = lt_mask_pattern_cross(_e660);
                                        phi_977_ = vec2<i32>(_e700.x, _e700.y);
                                        break;
                                    }
                                    case 3: {
                                        let _e706 = lt_mask_pattern_plus_or_cross(_e660, ((_e644.pixel.x + _e644.pixel.y) & 1u));
                                        phi_977_ = vec2<i32>(_e706.x, _e706.y);
                                        break;
                                    }
                                    case 4: {
                                        let _e711 = lt_mask_pattern_plus_or_cross(_e660, (_e680 & 1u));
                                        phi_977_ = vec2<i32>(_e711.x, _e711.y);
                                        break;
                                    }
                                    case 5: {
                                        switch bitcast<i32>((_e680 & 3u)) {
                                            case 0: {
                                                phi_957_ = vec2(-1i);
                                                break;
                                            }
                                            case 1: {
                                                phi_957_ = vec2(0i);
                                                break;
                                            }
                                            case 2: {
                                                phi_957_ = vec2<i32>(0i, -1i);
                                                break;
                                            }
                                            default: {
                                                phi_957_ = vec2<i32>(-1i, 0i);
                                                break;
                                            }
                                        }
                                        let _e722 = phi_957_;
                                        phi_977_ = (_e722 + vec2<i32>(bitcast<i32>((_e660 & 1u)), bitcast<i32>(((_e660 >> bitcast<u32>(1i)) & 1u))));
                                        break;
                                    }
                                    case 6: {
                                        phi_977_ = vec2<i32>((bitcast<i32>((_e660 % 5u)) - 2i), (bitcast<i32>(((_e660 / 5u) % 5u)) - 2i));
                                        break;
                                    }
                                    case 7: {
                                        let _e739 = lt_mask_pattern_diamond(_e660);
                                        phi_977_ = vec2<i32>(_e739.x, _e739.y);
                                        break;
                                    }
                                    default: {
                                        phi_977_ = vec2<i32>((bitcast<i32>((_e660 % 3u)) - 1i), (bitcast<i32>(((_e660 / 3u) % 3u)) - 1i));
                                        break;
                                    }
                                }
                                let _e744 = phi_977_;
                                let _e747 = lt_mask_pattern_step_clamped(_e644.pixel.x, _e744.x, _e684);
                                let _e748 = lt_mask_pattern_step_clamped(_e644.pixel.y, _e744.y, _e686);
                                let _e752 = ((((_e748 * _e88) + _e747) * _e84) + (_e80 / 32u));
                                if (_e82 > 29u) {
                                    let _e754 = (_e752 + 1u);
                                    if (_e754 < _e61) {
                                    } else {
                                        return;
                                    }
                                    let _e758 = last_bits.member[(0u + _e754)];
                                    phi_1002_ = _e758;
                                } else {
                                    phi_1002_ = 0u;
                                }
                                let _e760 = phi_1002_;
                                if (_e752 < _e61) {
                                } else {
                                    return;
                                }
                                let _e764 = last_bits.member[(0u + _e752)];
                                let _e767 = (_e764 >> bitcast<u32>((_e82 & 31u)));
                                if (_e82 > 29u) {
                                    phi_1021_ = (_e767 | (_e760 << bitcast<u32>(((32u - _e82) & 31u))));
                                } else {
                                    phi_1021_ = _e767;
                                }
                                let _e775 = phi_1021_;
                                if ((_e775 & 2u) == 0u) {
                                    phi_1029_ = (_e775 & 1u);
                                } else {
                                    phi_1029_ = (_e775 & 7u);
                                }
                                let _e781 = phi_1029_;
                                if _e662.any_expands {
                                    phi_1117_ = true;
                                } else {
                                    if ((_e781 & 2u) != 0u) {
                                        let _e788 = (((_e781 & 4u) != 0u) != _e254);
                                        switch bitcast<i32>(_e651) {
                                            case 1: {
                                                phi_1057_ = bool();
                                                phi_1058_ = false;
                                                phi_1059_ = true;
                                                phi_1060_ = false;
                                                phi_1061_ = false;
                                                break;
                                            }
                                            case 2: {
                                                if _e788 {
                                                    phi_1055_ = (((_e781 & 4u) != 0u) != ((_e781 & 1u) != 0u));
                                                    phi_1056_ = false;
                                                } else {
                                                    phi_1055_ = bool();
                                                    phi_1056_ = true;
                                                }
                                                let _e796 = phi_1055_;
                                                let _e798 = phi_1056_;
                                                phi_1057_ = _e796;
                                                phi_1058_ = false;
                                                phi_1059_ = false;
                                                phi_1060_ = _e798;
                                                phi_1061_ = _e788;
                                                break;
                                            }
                                            default: {
                                                phi_1057_ = bool();
                                                phi_1058_ = true;
                                                phi_1059_ = false;
                                                phi_1060_ = false;
                                                phi_1061_ = false;
                                                break;
                                            }
                                        }
                                        let _e800 = phi_1057_;
                                        let _e802 = phi_1058_;
                                        let _e804 = phi_1059_;
                                        let _e806 = phi_1060_;
                                        let _e808 = phi_1061_;
                                        phi_1069_ = _e788;
                                        phi_1070_ = _e800;
                                        phi_1071_ = _e802;
                                        phi_1072_ = _e804;
                                        phi_1073_ = _e806;
                                        phi_1074_ = _e808;
                                    } else {
                                        switch bitcast<i32>(_e651) {
                                            case 1: {
                                                phi_1066_ = false;
                                                phi_1067_ = true;
                                                phi_1068_ = false;
                                                break;
                                            }
                                            case 2: {
                                                phi_1066_ = false;
                                                phi_1067_ = false;
                                                phi_1068_ = true;
                                                break;
                                            }
                                            default: {
                                                phi_1066_ = true;
                                                phi_1067_ = false;
                                                phi_1068_ = false;
                                                break;
                                            }
                                        }
                                        let _e811 = phi_1066_;
                                        let _e813 = phi_1067_;
                                        let _e815 = phi_1068_;
                                        phi_1069_ = false;
                                        phi_1070_ = bool();
                                        phi_1071_ = _e811;
                                        phi_1072_ = _e813;
                                        phi_1073_ = _e815;
                                        phi_1074_ = false;
                                    }
                                    let _e817 = phi_1069_;
                                    let _e819 = phi_1070_;
                                    let _e821 = phi_1071_;
                                    let _e823 = phi_1072_;
                                    let _e825 = phi_1073_;
                                    let _e827 = phi_1074_;
                                    if _e821 {
                                        if ((_e781 & 2u) != 0u) {
                                            if (((_e781 & 4u) != 0u) != _e254) {
                                                phi_1089_ = false;
                                            } else {
                                                phi_1089_ = true;
                                            }
                                            let _e834 = phi_1089_;
                                            phi_1090_ = _e834;
                                        } else {
                                            phi_1090_ = true;
                                        }
                                        let _e836 = phi_1090_;
                                        if _e836 {
                                            phi_1097_ = (((_e781 & 1u) != 0u) != _e254);
                                        } else {
                                            phi_1097_ = true;
                                        }
                                        let _e841 = phi_1097_;
                                        phi_1098_ = _e841;
                                        phi_1099_ = false;
                                        phi_1100_ = false;
                                        phi_1101_ = false;
                                    } else {
                                        phi_1098_ = bool();
                                        phi_1099_ = _e823;
                                        phi_1100_ = _e825;
                                        phi_1101_ = _e827;
                                    }
                                    let _e843 = phi_1098_;
                                    let _e845 = phi_1099_;
                                    let _e847 = phi_1100_;
                                    let _e849 = phi_1101_;
                                    if _e845 {
                                        phi_1105_ = _e817;
                                        phi_1106_ = false;
                                        phi_1107_ = false;
                                    } else {
                                        phi_1105_ = _e843;
                                        phi_1106_ = _e847;
                                        phi_1107_ = _e849;
                                    }
                                    let _e851 = phi_1105_;
                                    let _e853 = phi_1106_;
                                    let _e855 = phi_1107_;
                                    if _e853 {
                                        phi_1111_ = false;
                                        phi_1112_ = true;
                                    } else {
                                        phi_1111_ = _e819;
                                        phi_1112_ = _e855;
                                    }
                                    let _e857 = phi_1111_;
                                    let _e859 = phi_1112_;
                                    if _e859 {
                                        phi_1116_ = _e857;
                                    } else {
                                        phi_1116_ = _e851;
                                    }
                                    let _e861 = phi_1116_;
                                    phi_1117_ = _e861;
                                }
                                let _e863 = phi_1117_;
                                if _e662.all_remove {
                                    if (((_e781 & 1u) != 0u) == _e254) {
                                        if ((_e781 & 2u) != 0u) {
                                            phi_1135_ = (((_e781 & 4u) != 0u) == _e254);
                                        } else {
                                            phi_1135_ = true;
                                        }
                                        let _e873 = phi_1135_;
                                        phi_1136_ = _e873;
                                    } else {
                                        phi_1136_ = false;
                                    }
                                    let _e875 = phi_1136_;
                                    phi_1137_ = _e875;
                                } else {
                                    phi_1137_ = false;
                                }
                                let _e877 = phi_1137_;
                                phi_872_ = (_e660 + 1u);
                                phi_875_ = lt_mask_Neighbourhood(_e863, _e877);
                            } else {
                                phi_872_ = u32();
                                phi_875_ = lt_mask_Neighbourhood();
                            }
                            let _e881 = phi_872_;
                            let _e883 = phi_875_;
                            continue;
                            continuing {
                                phi_871_ = _e881;
                                phi_874_ = _e883;
                                break if !(_e674);
                            }
                        }
                        let _e1172 = local_1;
                        phi_1140_ = _e1172;
                    }
                    let _e886 = phi_1140_;
                    phi_1141_ = _e886;
                } else {
                    phi_1141_ = _e645;
                }
                let _e888 = phi_1141_;
                phi_1142_ = _e888;
            } else {
                phi_1142_ = _e645;
            }
            let _e890 = phi_1142_;
            let _e893 = p.member.frame;
            let _e895 = p.member.refresh;
            if (_e895 == 0u) {
                phi_1175_ = false;
            } else {
                if (_e895 == 0u) {
                    return;
                }
                let _e904 = ((_e55.x + (_e55.y * (((_e895 * 5u) / 8u) | 1u))) + (_e893 % _e895));
                if (_e895 == 0u) {
                    phi_1174_ = (_e904 == 0u);
                } else {
                    if (_e895 == 0u) {
                        return;
                    }
                    phi_1174_ = ((_e904 % _e895) == 0u);
                }
                let _e911 = phi_1174_;
                phi_1175_ = _e911;
            }
            let _e913 = phi_1175_;
            if _e638 {
                if _e913 {
                    phi_1197_ = bool();
                } else {
                    phi_1197_ = ((0u & 2u) != 0u);
                }
                let _e919 = phi_1197_;
                phi_1198_ = _e919;
                phi_1199_ = _e913;
            } else {
                phi_1198_ = bool();
                phi_1199_ = true;
            }
            let _e921 = phi_1198_;
            let _e923 = phi_1199_;
            if _e923 {
                phi_1203_ = false;
            } else {
                phi_1203_ = _e921;
            }
            let _e925 = phi_1203_;
            if _e925 {
                phi_1254_ = 7u;
            } else {
                if (_e96 != 0.5f) {
                    if _e638 {
                        if _e913 {
                            phi_1251_ = 6u;
                        } else {
                            if _e258 {
                                phi_1226_ = true;
                            } else {
                                if _e890.any_expands {
                                    phi_1225_ = false;
                                } else {
                                    phi_1225_ = true;
                                }
                                let _e927 = phi_1225_;
                                phi_1226_ = _e927;
                            }
                            let _e929 = phi_1226_;
                            if _e929 {
                                if _e258 {
                                    if false {
                                        if _e890.all_remove {
                                            phi_1239_ = false;
                                        } else {
                                            phi_1239_ = true;
                                        }
                                        let _e931 = phi_1239_;
                                        phi_1240_ = _e931;
                                    } else {
                                        phi_1240_ = true;
                                    }
                                    let _e933 = phi_1240_;
                                    phi_1241_ = _e933;
                                } else {
                                    phi_1241_ = true;
                                }
                                let _e935 = phi_1241_;
                                if _e935 {
                                    if _e258 {
                                        phi_1248_ = 1u;
                                    } else {
                                        phi_1248_ = 0u;
                                    }
                                    let _e937 = phi_1248_;
                                    phi_1249_ = _e937;
                                } else {
                                    phi_1249_ = 5u;
                                }
                                let _e939 = phi_1249_;
                                phi_1250_ = _e939;
                            } else {
                                phi_1250_ = 4u;
                            }
                            let _e941 = phi_1250_;
                            phi_1251_ = _e941;
                        }
                        let _e943 = phi_1251_;
                        phi_1252_ = _e943;
                    } else {
                        phi_1252_ = 3u;
                    }
                    let _e945 = phi_1252_;
                    phi_1253_ = _e945;
                } else {
                    phi_1253_ = 2u;
                }
                let _e947 = phi_1253_;
                phi_1254_ = _e947;
            }
            let _e949 = phi_1254_;
            if !((_e949 == 0u)) {
                if !((_e949 == 5u)) {
                    phi_1266_ = !(_e925);
                    phi_1267_ = false;
                } else {
                    phi_1266_ = bool();
                    phi_1267_ = true;
                }
                let _e956 = phi_1266_;
                let _e958 = phi_1267_;
                phi_1268_ = _e956;
                phi_1269_ = _e958;
            } else {
                phi_1268_ = bool();
                phi_1269_ = true;
            }
            let _e960 = phi_1268_;
            let _e962 = phi_1269_;
            if _e962 {
                phi_1273_ = false;
            } else {
                phi_1273_ = _e960;
            }
            let _e964 = phi_1273_;
            if _e925 {
                phi_1279_ = ((0u & 4u) != 0u);
            } else {
                phi_1279_ = _e254;
            }
            let _e968 = phi_1279_;
            if _e964 {
                if _e254 {
                    phi_1287_ = (2u | 1u);
                } else {
                    phi_1287_ = 2u;
                }
                let _e971 = phi_1287_;
                if false {
                    phi_1292_ = (_e971 | 4u);
                } else {
                    phi_1292_ = _e971;
                }
                let _e974 = phi_1292_;
                phi_1312_ = _e974;
            } else {
                if (_e949 == 7u) {
                    if _e254 {
                        phi_1301_ = (2u | 1u);
                    } else {
                        phi_1301_ = 2u;
                    }
                    let _e978 = phi_1301_;
                    if _e968 {
                        phi_1306_ = (_e978 | 4u);
                    } else {
                        phi_1306_ = _e978;
                    }
                    let _e981 = phi_1306_;
                    phi_1311_ = _e981;
                } else {
                    if _e254 {
                        phi_1310_ = 1u;
                    } else {
                        phi_1310_ = 0u;
                    }
                    let _e983 = phi_1310_;
                    phi_1311_ = _e983;
                }
                let _e985 = phi_1311_;
                phi_1312_ = _e985;
            }
            let _e987 = phi_1312_;
            if _e968 {
                phi_1316_ = 0f;
            } else {
                phi_1316_ = 1f;
            }
            let _e989 = phi_1316_;
            phi_1318_ = mask_Masked(_e989, _e987, _e964);
        }
        let _e992 = phi_1318_;
        visibility.member[_e72.shift] = _e992.visibility;
        let _e997 = p.member.light.number;
        let _e998 = (_e997 * 3u);
        let _e1000 = (_e998 % 32u);
        let _e1002 = p.member.light.mask_words;
        let _e1004 = ((_e72.shift * _e1002) + (_e998 / 32u));
        let _e1006 = bits.member[_e1004];
        bits.member[_e1004] = ((_e1006 & ~((7u << bitcast<u32>((_e1000 & 31u))))) | (_e992.bits << bitcast<u32>((_e1000 & 31u))));
        if (_e1000 > 29u) {
            let _e1021 = bits.member[(_e1004 + 1u)];
            let _e1023 = (32u - _e1000);
            bits.member[(_e1004 + 1u)] = ((_e1021 & ~((7u >> bitcast<u32>((_e1023 & 31u))))) | (_e992.bits >> bitcast<u32>((_e1023 & 31u))));
        }
        phi_1368_ = _e992.needs_ray;
        phi_1369_ = _e72.shift;
    } else {
        phi_1368_ = false;
        phi_1369_ = 0u;
    }
    let _e1037 = phi_1368_;
    let _e1039 = phi_1369_;
    if (_e56 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e1037 {
        let _e1043 = atomicAdd((&shared_[0u]), 1u);
        phi_1380_ = _e1043;
    } else {
        phi_1380_ = 0u;
    }
    let _e1045 = phi_1380_;
    workgroupBarrier();
    if (_e56 == 0u) {
        let _e1049 = atomicLoad((&shared_[0u]));
        let _e1050 = atomicAdd((&list.member[3u]), _e1049);
        atomicStore((&shared_[1u]), _e1050);
    }
    workgroupBarrier();
    if _e1037 {
        let _e1053 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e1053) + _e1045)]), _e1039);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_er_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
