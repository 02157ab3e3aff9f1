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
    pad0_: u32,
    pad1_: u32,
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
    var phi_855_: bool;
    var phi_866_: bool;
    var phi_867_: bool;
    var phi_868_: bool;
    var phi_869_: bool;
    var phi_870_: bool;
    var phi_871_: bool;
    var phi_875_: bool;
    var phi_880_: bool;
    var phi_895_: u32;
    var phi_897_: u32;
    var phi_900_: lt_mask_Neighbourhood;
    var phi_912_: bool;
    var phi_913_: bool;
    var phi_922_: u32;
    var phi_923_: u32;
    var phi_983_: vec2<i32>;
    var phi_1003_: vec2<i32>;
    var phi_1028_: u32;
    var phi_1047_: u32;
    var phi_1055_: u32;
    var phi_1072_: bool;
    var phi_1073_: bool;
    var phi_1080_: bool;
    var phi_1081_: bool;
    var phi_1099_: bool;
    var phi_1100_: bool;
    var phi_1101_: bool;
    var phi_898_: u32;
    var phi_901_: lt_mask_Neighbourhood;
    var phi_1104_: lt_mask_Neighbourhood;
    var phi_1105_: lt_mask_Neighbourhood;
    var phi_1137_: bool;
    var phi_1138_: bool;
    var phi_1167_: bool;
    var phi_1168_: bool;
    var phi_1181_: bool;
    var phi_1182_: bool;
    var phi_1183_: bool;
    var phi_1190_: u32;
    var phi_1191_: u32;
    var phi_1192_: u32;
    var phi_1193_: u32;
    var phi_1194_: u32;
    var phi_1195_: u32;
    var phi_1203_: bool;
    var phi_1211_: u32;
    var phi_1216_: u32;
    var phi_1220_: u32;
    var phi_1221_: u32;
    var phi_1225_: f32;
    var phi_1227_: mask_Masked;
    var phi_1277_: bool;
    var phi_1278_: u32;
    var phi_1289_: u32;
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
            phi_1227_ = mask_Masked(_e249.unnamed.visibility, 0u, false);
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
            if _e644.has_moved {
                let _e651 = p.member.flags;
                phi_855_ = ((_e651 & 4u) == 0u);
            } else {
                phi_855_ = false;
            }
            let _e655 = phi_855_;
            if ((_e646 & 2u) != 0u) {
                if false {
                    phi_868_ = bool();
                    phi_869_ = true;
                } else {
                    if true {
                        phi_866_ = !(_e655);
                        phi_867_ = false;
                    } else {
                        phi_866_ = bool();
                        phi_867_ = true;
                    }
                    let _e658 = phi_866_;
                    let _e660 = phi_867_;
                    phi_868_ = _e658;
                    phi_869_ = _e660;
                }
                let _e662 = phi_868_;
                let _e664 = phi_869_;
                phi_870_ = _e662;
                phi_871_ = _e664;
            } else {
                phi_870_ = bool();
                phi_871_ = true;
            }
            let _e666 = phi_870_;
            let _e668 = phi_871_;
            if _e668 {
                phi_875_ = false;
            } else {
                phi_875_ = _e666;
            }
            let _e670 = phi_875_;
            let _e671 = lt_mask_Neighbourhood(false, true);
            if _e258 {
                phi_880_ = _e670;
            } else {
                phi_880_ = true;
            }
            let _e673 = phi_880_;
            if _e673 {
                if _e638 {
                    if _e644.has_moved {
                        let _e676 = p.member.moving_pattern;
                        phi_895_ = _e676;
                    } else {
                        let _e678 = p.member.still_pattern;
                        phi_895_ = _e678;
                    }
                    let _e680 = phi_895_;
                    phi_897_ = 0u;
                    phi_900_ = _e671;
                    loop {
                        let _e682 = phi_897_;
                        let _e684 = phi_900_;
                        local_1 = _e684;
                        if (1u <= _e680) {
                            if (_e680 <= 4u) {
                                phi_912_ = false;
                            } else {
                                phi_912_ = true;
                            }
                            let _e688 = phi_912_;
                            phi_913_ = _e688;
                        } else {
                            phi_913_ = true;
                        }
                        let _e690 = phi_913_;
                        if _e690 {
                            switch bitcast<i32>(_e680) {
                                case 5: {
                                    phi_922_ = 4u;
                                    break;
                                }
                                case 6: {
                                    phi_922_ = 25u;
                                    break;
                                }
                                case 7: {
                                    phi_922_ = 13u;
                                    break;
                                }
                                default: {
                                    phi_922_ = 9u;
                                    break;
                                }
                            }
                            let _e693 = phi_922_;
                            phi_923_ = _e693;
                        } else {
                            phi_923_ = 5u;
                        }
                        let _e695 = phi_923_;
                        let _e696 = (_e682 < _e695);
                        if _e696 {
                            let _e702 = p.member.frame;
                            let _e706 = p.member.current.size[0u];
                            let _e708 = p.member.current.size[1u];
                            switch bitcast<i32>(_e680) {
                                case 1: {
                                    let _e718 = lt_mask_pattern_plus(_e682);
                                    phi_1003_ = vec2<i32>(_e718.x, _e718.y);
                                    break;
                                }
                                case 2: {
                                    let _e722 = lt_mask_pattern_cross(_e682);
                                    phi_1003_ = vec2<i32>(_e722.x, _e722.y);
                                    break;
                                }
                                case 3: {
                                    let _e728 = lt_mask_pattern_plus_or_cross(_e682, ((_e644.pixel.x + _e644.pixel.y) & 1u));
                                    phi_1003_ = vec2<i32>(_e728.x, _e728.y);
                                    break;
                                }
                                case 4: {
                                    let _e733 = lt_mask_pattern_plus_or_cross(_e682, (_e702 & 1u));
                                    phi_1003_ = vec2<i32>(_e733.x, _e733.y);
                                    break;
                                }
                                case 5: {
                                    switch bitcast<i32>((_e702 & 3u)) {
                                        case 0: {
                                            phi_983_ = vec2(-1i);
                                            break;
                                        }
                                        case 1: {
                                            phi_983_ = vec2(0i);
                                            break;
                                        }
                                        case 2: {
                                            phi_983_ = vec2<i32>(0i, -1i);
                                            break;
                                        }
                                        default: {
                                            phi_983_ = vec2<i32>(-1i, 0i);
                                            break;
                                        }
                                    }
                                    let _e744 = phi_983_;
                                    phi_1003_ = (_e744 + vec2<i32>(bitcast<i32>((_e682 & 1u)), bitcast<i32>(((_e682 >> bitcast<u32>(1i)) & 1u))));
                                    break;
                                }
                                case 6: {
                                    phi_1003_ = vec2<i32>((bitcast<i32>((_e682 % 5u)) - 2i), (bitcast<i32>(((_e682 / 5u) % 5u)) - 2i));
                                    break;
                                }
                                case 7: {
                                    let _e761 = lt_mask_pattern_diamond(_e682);
                                    phi_1003_ = vec2<i32>(_e761.x, _e761.y);
                                    break;
                                }
                                default: {
                                    phi_1003_ = vec2<i32>((bitcast<i32>((_e682 % 3u)) - 1i), (bitcast<i32>(((_e682 / 3u) % 3u)) - 1i));
                                    break;
                                }
                            }
                            let _e766 = phi_1003_;
                            let _e769 = lt_mask_pattern_step_clamped(_e644.pixel.x, _e766.x, _e706);
                            let _e770 = lt_mask_pattern_step_clamped(_e644.pixel.y, _e766.y, _e708);
                            let _e774 = ((((_e770 * _e88) + _e769) * _e84) + (_e80 / 32u));
                            if (_e82 > 29u) {
                                let _e776 = (_e774 + 1u);
                                if (_e776 < _e61) {
                                } else {
                                    return;
                                }
                                let _e780 = last_bits.member[(0u + _e776)];
                                phi_1028_ = _e780;
                            } else {
                                phi_1028_ = 0u;
                            }
                            let _e782 = phi_1028_;
                            if (_e774 < _e61) {
                            } else {
                                return;
                            }
                            let _e786 = last_bits.member[(0u + _e774)];
                            let _e789 = (_e786 >> bitcast<u32>((_e82 & 31u)));
                            if (_e82 > 29u) {
                                phi_1047_ = (_e789 | (_e782 << bitcast<u32>(((32u - _e82) & 31u))));
                            } else {
                                phi_1047_ = _e789;
                            }
                            let _e797 = phi_1047_;
                            if ((_e797 & 2u) == 0u) {
                                phi_1055_ = (_e797 & 1u);
                            } else {
                                phi_1055_ = (_e797 & 7u);
                            }
                            let _e803 = phi_1055_;
                            if _e684.any_expands {
                                phi_1081_ = true;
                            } else {
                                if ((_e803 & 2u) != 0u) {
                                    if (((_e803 & 4u) != 0u) != _e254) {
                                        phi_1072_ = false;
                                    } else {
                                        phi_1072_ = true;
                                    }
                                    let _e812 = phi_1072_;
                                    phi_1073_ = _e812;
                                } else {
                                    phi_1073_ = true;
                                }
                                let _e814 = phi_1073_;
                                if _e814 {
                                    phi_1080_ = (((_e803 & 1u) != 0u) != _e254);
                                } else {
                                    phi_1080_ = true;
                                }
                                let _e819 = phi_1080_;
                                phi_1081_ = _e819;
                            }
                            let _e821 = phi_1081_;
                            if _e684.all_remove {
                                if (((_e803 & 1u) != 0u) == _e254) {
                                    if ((_e803 & 2u) != 0u) {
                                        phi_1099_ = (((_e803 & 4u) != 0u) == _e254);
                                    } else {
                                        phi_1099_ = true;
                                    }
                                    let _e831 = phi_1099_;
                                    phi_1100_ = _e831;
                                } else {
                                    phi_1100_ = false;
                                }
                                let _e833 = phi_1100_;
                                phi_1101_ = _e833;
                            } else {
                                phi_1101_ = false;
                            }
                            let _e835 = phi_1101_;
                            phi_898_ = (_e682 + 1u);
                            phi_901_ = lt_mask_Neighbourhood(_e821, _e835);
                        } else {
                            phi_898_ = u32();
                            phi_901_ = lt_mask_Neighbourhood();
                        }
                        let _e839 = phi_898_;
                        let _e841 = phi_901_;
                        continue;
                        continuing {
                            phi_897_ = _e839;
                            phi_900_ = _e841;
                            break if !(_e696);
                        }
                    }
                    let _e1076 = local_1;
                    phi_1104_ = _e1076;
                } else {
                    phi_1104_ = _e671;
                }
                let _e844 = phi_1104_;
                phi_1105_ = _e844;
            } else {
                phi_1105_ = _e671;
            }
            let _e846 = phi_1105_;
            let _e849 = p.member.frame;
            let _e851 = p.member.refresh;
            if (_e851 == 0u) {
                phi_1138_ = false;
            } else {
                if (_e851 == 0u) {
                    return;
                }
                let _e860 = ((_e55.x + (_e55.y * (((_e851 * 5u) / 8u) | 1u))) + (_e849 % _e851));
                if (_e851 == 0u) {
                    phi_1137_ = (_e860 == 0u);
                } else {
                    if (_e851 == 0u) {
                        return;
                    }
                    phi_1137_ = ((_e860 % _e851) == 0u);
                }
                let _e867 = phi_1137_;
                phi_1138_ = _e867;
            }
            let _e869 = phi_1138_;
            if (_e96 != 0.5f) {
                if _e638 {
                    if _e869 {
                        phi_1193_ = 6u;
                    } else {
                        if _e258 {
                            phi_1168_ = true;
                        } else {
                            if _e846.any_expands {
                                phi_1167_ = false;
                            } else {
                                phi_1167_ = true;
                            }
                            let _e873 = phi_1167_;
                            phi_1168_ = _e873;
                        }
                        let _e875 = phi_1168_;
                        if _e875 {
                            if _e258 {
                                if _e670 {
                                    if _e846.all_remove {
                                        phi_1181_ = false;
                                    } else {
                                        phi_1181_ = true;
                                    }
                                    let _e877 = phi_1181_;
                                    phi_1182_ = _e877;
                                } else {
                                    phi_1182_ = true;
                                }
                                let _e879 = phi_1182_;
                                phi_1183_ = _e879;
                            } else {
                                phi_1183_ = true;
                            }
                            let _e881 = phi_1183_;
                            if _e881 {
                                if _e258 {
                                    phi_1190_ = 1u;
                                } else {
                                    phi_1190_ = 0u;
                                }
                                let _e883 = phi_1190_;
                                phi_1191_ = _e883;
                            } else {
                                phi_1191_ = 5u;
                            }
                            let _e885 = phi_1191_;
                            phi_1192_ = _e885;
                        } else {
                            phi_1192_ = 4u;
                        }
                        let _e887 = phi_1192_;
                        phi_1193_ = _e887;
                    }
                    let _e889 = phi_1193_;
                    phi_1194_ = _e889;
                } else {
                    phi_1194_ = 3u;
                }
                let _e891 = phi_1194_;
                phi_1195_ = _e891;
            } else {
                phi_1195_ = 2u;
            }
            let _e893 = phi_1195_;
            if !((_e893 == 0u)) {
                phi_1203_ = !((_e893 == 5u));
            } else {
                phi_1203_ = false;
            }
            let _e899 = phi_1203_;
            if _e899 {
                if _e254 {
                    phi_1211_ = (2u | 1u);
                } else {
                    phi_1211_ = 2u;
                }
                let _e902 = phi_1211_;
                if false {
                    phi_1216_ = (_e902 | 4u);
                } else {
                    phi_1216_ = _e902;
                }
                let _e905 = phi_1216_;
                phi_1221_ = _e905;
            } else {
                if _e254 {
                    phi_1220_ = 1u;
                } else {
                    phi_1220_ = 0u;
                }
                let _e907 = phi_1220_;
                phi_1221_ = _e907;
            }
            let _e909 = phi_1221_;
            if _e254 {
                phi_1225_ = 0f;
            } else {
                phi_1225_ = 1f;
            }
            let _e911 = phi_1225_;
            phi_1227_ = mask_Masked(_e911, _e909, _e899);
        }
        let _e914 = phi_1227_;
        visibility.member[_e72.shift] = _e914.visibility;
        let _e919 = p.member.light.number;
        let _e920 = (_e919 * 3u);
        let _e922 = (_e920 % 32u);
        let _e924 = p.member.light.mask_words;
        let _e926 = ((_e72.shift * _e924) + (_e920 / 32u));
        let _e928 = bits.member[_e926];
        bits.member[_e926] = ((_e928 & ~((7u << bitcast<u32>((_e922 & 31u))))) | (_e914.bits << bitcast<u32>((_e922 & 31u))));
        if (_e922 > 29u) {
            let _e943 = bits.member[(_e926 + 1u)];
            let _e945 = (32u - _e922);
            bits.member[(_e926 + 1u)] = ((_e943 & ~((7u >> bitcast<u32>((_e945 & 31u))))) | (_e914.bits >> bitcast<u32>((_e945 & 31u))));
        }
        phi_1277_ = _e914.needs_ray;
        phi_1278_ = _e72.shift;
    } else {
        phi_1277_ = false;
        phi_1278_ = 0u;
    }
    let _e959 = phi_1277_;
    let _e961 = phi_1278_;
    if (_e56 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e959 {
        let _e965 = atomicAdd((&shared_[0u]), 1u);
        phi_1289_ = _e965;
    } else {
        phi_1289_ = 0u;
    }
    let _e967 = phi_1289_;
    workgroupBarrier();
    if (_e56 == 0u) {
        let _e971 = atomicLoad((&shared_[0u]));
        let _e972 = atomicAdd((&list.member[3u]), _e971);
        atomicStore((&shared_[1u]), _e972);
    }
    workgroupBarrier();
    if _e959 {
        let _e975 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e975) + _e967)]), _e961);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_mask_mask_objects_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
