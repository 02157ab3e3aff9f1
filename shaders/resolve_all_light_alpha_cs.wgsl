struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_9 {
    member: array<abi_Sample>,
}

struct type_13 {
    member: array<u32>,
}

struct type_17 {
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

struct texture_TextureView {
    offset: u32,
    size: u32,
    flags: u32,
}

struct lt_bvh_traverse_Stack {
    first: array<u32, 32>,
    mask: array<u32, 32>,
    len: u32,
    group: u32,
    group_mask: u32,
}

struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct abi_ShadowParams {
    projection: lt_math_LightProjection,
    light: abi_LightParams,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    pad0_: u32,
    pad1_: u32,
}

struct type_37 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_42 {
    member: array<lt_bvh_Node>,
}

struct lt_bvh_Triangle {
    v0_: vec3<f32>,
    i0_: u32,
    v1_: vec3<f32>,
    i1_: u32,
    v2_: vec3<f32>,
    i2_: u32,
}

struct type_46 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_50 {
    member: array<abi_Vertex>,
}

struct abi_Material {
    base_color: vec4<f32>,
    cutoff: f32,
    flags: u32,
    alpha_offset: u32,
    alpha_size: u32,
    color_offset: u32,
    color_size: u32,
    transmission: f32,
    pad: u32,
}

struct type_54 {
    member: array<abi_Material>,
}

struct u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_ {
    unnamed: lt_mask_LightPlace,
    unnamed_1: lt_mask_LightPlace,
}

struct lt_bvh_triangle_Intersection {
    t: f32,
    u: f32,
    v: f32,
    is_hit: bool,
}

struct texture_TexelQuad {
    indices: array<u32, 4>,
    weights: vec4<f32>,
}

struct texture_Axis {
    low: u32,
    high: u32,
    fraction: f32,
}

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

struct type_70 {
    member: array<vec4<u32>>,
}

struct lt_bvh_LightSpace {
    shear: vec3<f32>,
    axis: u32,
    middle: vec3<f32>,
    sign: f32,
    low: vec3<f32>,
    is_parallel: u32,
    high: vec3<f32>,
    pad: u32,
    roots: vec4<u32>,
    roots_z: vec4<u32>,
}

struct type_73 {
    member: lt_bvh_LightSpace,
}

struct u0028_lt_bvh_LightPoint_u0020_u32_u0029_ {
    unnamed: lt_math_Evsm,
    unnamed_1: u32,
}

struct lt_bvh_LightNode {
    frame: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    rest: vec4<u32>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_37;
@group(0) @binding(2) 
var<storage> nodes: type_42;
@group(0) @binding(3) 
var<storage> triangles: type_46;
@group(0) @binding(5) 
var<storage> rows: type_70;
@group(0) @binding(6) 
var<uniform> space: type_73;
@group(0) @binding(7) 
var<storage> vertices: type_50;
@group(0) @binding(8) 
var<storage> materials: type_54;
@group(0) @binding(9) 
var<storage> alpha_texels: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_251_: lt_mask_LightPlace;
    var phi_252_: bool;
    var phi_253_: lt_mask_LightPlace;
    var phi_254_: bool;
    var phi_259_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_251_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_252_ = false;
        } else {
            phi_251_ = lt_mask_LightPlace();
            phi_252_ = true;
        }
        let _e93 = phi_251_;
        let _e95 = phi_252_;
        phi_253_ = _e93;
        phi_254_ = _e95;
    } else {
        phi_253_ = lt_mask_LightPlace();
        phi_254_ = true;
    }
    let _e97 = phi_253_;
    let _e99 = phi_254_;
    if _e99 {
        phi_259_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_259_ = _e97;
    }
    let _e104 = phi_259_;
    return lt_mask_LightPlace(_e104.word, _e104.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_274_: bool;
    var phi_278_: f32;

    if (param_3 != param_3) {
        phi_274_ = true;
    } else {
        let _e83 = (param_4 >= param_3);
        if _e83 {
        }
        phi_274_ = _e83;
    }
    let _e85 = phi_274_;
    if _e85 {
        phi_278_ = param_4;
    } else {
        phi_278_ = param_3;
    }
    let _e87 = phi_278_;
    return _e87;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_290_: bool;
    var phi_294_: f32;

    if (param_5 != param_5) {
        phi_290_ = true;
    } else {
        let _e83 = (param_6 <= param_5);
        if _e83 {
        }
        phi_290_ = _e83;
    }
    let _e85 = phi_290_;
    if _e85 {
        phi_294_ = param_6;
    } else {
        phi_294_ = param_5;
    }
    let _e87 = phi_294_;
    return _e87;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_336_: f32;
    var phi_341_: f32;
    var phi_342_: bool;
    var phi_343_: f32;
    var phi_344_: bool;
    var phi_348_: f32;
    var phi_374_: f32;
    var phi_379_: f32;
    var phi_380_: bool;
    var phi_381_: f32;
    var phi_382_: bool;
    var phi_386_: f32;
    var phi_394_: f32;
    var phi_395_: f32;
    var phi_396_: f32;
    var phi_405_: f32;
    var phi_406_: f32;
    var phi_424_: u32;
    var phi_438_: u32;
    var phi_445_: u32;
    var phi_450_: u32;
    var phi_456_: u32;
    var phi_461_: u32;
    var phi_463_: texture_Axis;
    var phi_491_: f32;
    var phi_496_: f32;
    var phi_497_: bool;
    var phi_498_: f32;
    var phi_499_: bool;
    var phi_503_: f32;
    var phi_529_: f32;
    var phi_534_: f32;
    var phi_535_: bool;
    var phi_536_: f32;
    var phi_537_: bool;
    var phi_541_: f32;
    var phi_549_: f32;
    var phi_550_: f32;
    var phi_551_: f32;
    var phi_560_: f32;
    var phi_561_: f32;
    var phi_579_: u32;
    var phi_593_: u32;
    var phi_600_: u32;
    var phi_605_: u32;
    var phi_611_: u32;
    var phi_616_: u32;
    var phi_618_: texture_Axis;

    let _e84 = (*param_7).size;
    let _e85 = (_e84 & 65535u);
    let _e87 = (*param_7).size;
    let _e89 = (_e87 >> bitcast<u32>(16i));
    let _e91 = (*param_7).flags;
    let _e93 = ((_e91 & 4u) != 0u);
    let _e95 = (*param_7).flags;
    let _e98 = ((_e95 >> bitcast<u32>(4u)) & 3u);
    if (_e98 == 0u) {
        if (param_8 > -8388608f) {
            let _e111 = f32(select(0i, select(select(i32(param_8), i32(-2147483648), (param_8 < bitcast<f32>(3472883712u))), 2147483647i, (param_8 > bitcast<f32>(1325400063u))), (param_8 == param_8)));
            if (_e111 > param_8) {
                phi_336_ = 1f;
            } else {
                phi_336_ = 0f;
            }
            let _e114 = phi_336_;
            if (param_8 < 8388608f) {
                phi_341_ = (_e111 - _e114);
                phi_342_ = false;
            } else {
                phi_341_ = f32();
                phi_342_ = true;
            }
            let _e117 = phi_341_;
            let _e119 = phi_342_;
            phi_343_ = _e117;
            phi_344_ = _e119;
        } else {
            phi_343_ = f32();
            phi_344_ = true;
        }
        let _e121 = phi_343_;
        let _e123 = phi_344_;
        if _e123 {
            phi_348_ = param_8;
        } else {
            phi_348_ = _e121;
        }
        let _e125 = phi_348_;
        phi_396_ = (param_8 - _e125);
    } else {
        if (_e98 == 1u) {
            let _e128 = (param_8 * 0.5f);
            if (_e128 > -8388608f) {
                let _e140 = f32(select(0i, select(select(i32(_e128), i32(-2147483648), (_e128 < bitcast<f32>(3472883712u))), 2147483647i, (_e128 > bitcast<f32>(1325400063u))), (_e128 == _e128)));
                if (_e140 > _e128) {
                    phi_374_ = 1f;
                } else {
                    phi_374_ = 0f;
                }
                let _e143 = phi_374_;
                if (_e128 < 8388608f) {
                    phi_379_ = (_e140 - _e143);
                    phi_380_ = false;
                } else {
                    phi_379_ = f32();
                    phi_380_ = true;
                }
                let _e146 = phi_379_;
                let _e148 = phi_380_;
                phi_381_ = _e146;
                phi_382_ = _e148;
            } else {
                phi_381_ = f32();
                phi_382_ = true;
            }
            let _e150 = phi_381_;
            let _e152 = phi_382_;
            if _e152 {
                phi_386_ = _e128;
            } else {
                phi_386_ = _e150;
            }
            let _e154 = phi_386_;
            let _e156 = (param_8 - (2f * _e154));
            if (_e156 > 1f) {
                phi_394_ = (2f - _e156);
            } else {
                phi_394_ = _e156;
            }
            let _e160 = phi_394_;
            phi_395_ = _e160;
        } else {
            phi_395_ = param_8;
        }
        let _e162 = phi_395_;
        phi_396_ = _e162;
    }
    let _e164 = phi_396_;
    if (_e164 > 0f) {
        if (_e164 < 1f) {
            phi_405_ = _e164;
        } else {
            phi_405_ = 1f;
        }
        let _e168 = phi_405_;
        phi_406_ = _e168;
    } else {
        phi_406_ = 0f;
    }
    let _e170 = phi_406_;
    let _e171 = (_e85 - 1u);
    let _e173 = (_e170 * f32(_e85));
    if _e93 {
        let _e180 = select(select(u32(_e173), 0u, (_e173 < bitcast<f32>(0u))), 4294967295u, (_e173 > bitcast<f32>(1333788671u)));
        if (_e171 < _e180) {
            phi_424_ = _e171;
        } else {
            phi_424_ = _e180;
        }
        let _e183 = phi_424_;
        phi_463_ = texture_Axis(_e183, _e183, 0f);
    } else {
        let _e185 = (_e173 + 0.5f);
        let _e192 = select(select(u32(_e185), 0u, (_e185 < bitcast<f32>(0u))), 4294967295u, (_e185 > bitcast<f32>(1333788671u)));
        if (_e85 < _e192) {
            phi_438_ = _e85;
        } else {
            phi_438_ = _e192;
        }
        let _e195 = phi_438_;
        if (_e98 == 0u) {
            phi_445_ = _e171;
        } else {
            phi_445_ = 0u;
        }
        let _e200 = phi_445_;
        if (_e98 == 0u) {
            phi_450_ = 0u;
        } else {
            phi_450_ = _e171;
        }
        let _e203 = phi_450_;
        if (_e195 == 0u) {
            phi_456_ = _e200;
        } else {
            phi_456_ = (_e195 - 1u);
        }
        let _e207 = phi_456_;
        if (_e195 > _e171) {
            phi_461_ = _e203;
        } else {
            phi_461_ = _e195;
        }
        let _e210 = phi_461_;
        phi_463_ = texture_Axis(_e207, _e210, (_e185 - f32(_e195)));
    }
    let _e213 = phi_463_;
    let _e215 = (*param_7).flags;
    let _e218 = ((_e215 >> bitcast<u32>(6u)) & 3u);
    if (_e218 == 0u) {
        if (param_9 > -8388608f) {
            let _e231 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e231 > param_9) {
                phi_491_ = 1f;
            } else {
                phi_491_ = 0f;
            }
            let _e234 = phi_491_;
            if (param_9 < 8388608f) {
                phi_496_ = (_e231 - _e234);
                phi_497_ = false;
            } else {
                phi_496_ = f32();
                phi_497_ = true;
            }
            let _e237 = phi_496_;
            let _e239 = phi_497_;
            phi_498_ = _e237;
            phi_499_ = _e239;
        } else {
            phi_498_ = f32();
            phi_499_ = true;
        }
        let _e241 = phi_498_;
        let _e243 = phi_499_;
        if _e243 {
            phi_503_ = param_9;
        } else {
            phi_503_ = _e241;
        }
        let _e245 = phi_503_;
        phi_551_ = (param_9 - _e245);
    } else {
        if (_e218 == 1u) {
            let _e248 = (param_9 * 0.5f);
            if (_e248 > -8388608f) {
                let _e260 = f32(select(0i, select(select(i32(_e248), i32(-2147483648), (_e248 < bitcast<f32>(3472883712u))), 2147483647i, (_e248 > bitcast<f32>(1325400063u))), (_e248 == _e248)));
                if (_e260 > _e248) {
                    phi_529_ = 1f;
                } else {
                    phi_529_ = 0f;
                }
                let _e263 = phi_529_;
                if (_e248 < 8388608f) {
                    phi_534_ = (_e260 - _e263);
                    phi_535_ = false;
                } else {
                    phi_534_ = f32();
                    phi_535_ = true;
                }
                let _e266 = phi_534_;
                let _e268 = phi_535_;
                phi_536_ = _e266;
                phi_537_ = _e268;
            } else {
                phi_536_ = f32();
                phi_537_ = true;
            }
            let _e270 = phi_536_;
            let _e272 = phi_537_;
            if _e272 {
                phi_541_ = _e248;
            } else {
                phi_541_ = _e270;
            }
            let _e274 = phi_541_;
            let _e276 = (param_9 - (2f * _e274));
            if (_e276 > 1f) {
                phi_549_ = (2f - _e276);
            } else {
                phi_549_ = _e276;
            }
            let _e280 = phi_549_;
            phi_550_ = _e280;
        } else {
            phi_550_ = param_9;
        }
        let _e282 = phi_550_;
        phi_551_ = _e282;
    }
    let _e284 = phi_551_;
    if (_e284 > 0f) {
        if (_e284 < 1f) {
            phi_560_ = _e284;
        } else {
            phi_560_ = 1f;
        }
        let _e288 = phi_560_;
        phi_561_ = _e288;
    } else {
        phi_561_ = 0f;
    }
    let _e290 = phi_561_;
    let _e291 = (_e89 - 1u);
    let _e293 = (_e290 * f32(_e89));
    if _e93 {
        let _e300 = select(select(u32(_e293), 0u, (_e293 < bitcast<f32>(0u))), 4294967295u, (_e293 > bitcast<f32>(1333788671u)));
        if (_e291 < _e300) {
            phi_579_ = _e291;
        } else {
            phi_579_ = _e300;
        }
        let _e303 = phi_579_;
        phi_618_ = texture_Axis(_e303, _e303, 0f);
    } else {
        let _e305 = (_e293 + 0.5f);
        let _e312 = select(select(u32(_e305), 0u, (_e305 < bitcast<f32>(0u))), 4294967295u, (_e305 > bitcast<f32>(1333788671u)));
        if (_e89 < _e312) {
            phi_593_ = _e89;
        } else {
            phi_593_ = _e312;
        }
        let _e315 = phi_593_;
        if (_e218 == 0u) {
            phi_600_ = _e291;
        } else {
            phi_600_ = 0u;
        }
        let _e320 = phi_600_;
        if (_e218 == 0u) {
            phi_605_ = 0u;
        } else {
            phi_605_ = _e291;
        }
        let _e323 = phi_605_;
        if (_e315 == 0u) {
            phi_611_ = _e320;
        } else {
            phi_611_ = (_e315 - 1u);
        }
        let _e327 = phi_611_;
        if (_e315 > _e291) {
            phi_616_ = _e323;
        } else {
            phi_616_ = _e315;
        }
        let _e330 = phi_616_;
        phi_618_ = texture_Axis(_e327, _e330, (_e305 - f32(_e315)));
    }
    let _e333 = phi_618_;
    let _e337 = (*param_7).offset;
    let _e344 = (*param_7).offset;
    let _e351 = (*param_7).offset;
    let _e358 = (*param_7).offset;
    return texture_TexelQuad(array<u32, 4>(((_e337 + (_e333.low * _e85)) + _e213.low), ((_e344 + (_e333.low * _e85)) + _e213.high), ((_e351 + (_e333.high * _e85)) + _e213.low), ((_e358 + (_e333.high * _e85)) + _e213.high)), vec4<f32>(((1f - _e213.fraction) * (1f - _e333.fraction)), (_e213.fraction * (1f - _e333.fraction)), ((1f - _e213.fraction) * _e333.fraction), (_e213.fraction * _e333.fraction)));
}

fn _lt_shaders_abi_Sample_is_valid(param_10: ptr<function, abi_Sample>) -> bool {
    var phi_690_: bool;
    var phi_691_: bool;
    var phi_692_: bool;
    var phi_693_: bool;
    var phi_697_: bool;

    let _e83 = (*param_10).normal[0u];
    let _e85 = global[0u];
    if (_e83 == _e85) {
        let _e88 = (*param_10).normal[1u];
        let _e90 = global[1u];
        if (_e88 == _e90) {
            let _e93 = (*param_10).normal[2u];
            let _e95 = global[2u];
            phi_690_ = (_e93 == _e95);
            phi_691_ = false;
        } else {
            phi_690_ = bool();
            phi_691_ = true;
        }
        let _e98 = phi_690_;
        let _e100 = phi_691_;
        phi_692_ = _e98;
        phi_693_ = _e100;
    } else {
        phi_692_ = bool();
        phi_693_ = true;
    }
    let _e102 = phi_692_;
    let _e104 = phi_693_;
    if _e104 {
        phi_697_ = false;
    } else {
        phi_697_ = _e102;
    }
    let _e106 = phi_697_;
    return !(_e106);
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: texture_TextureView;
    var local_3: array<u32, 32>;
    var local_4: abi_Sample;
    var phi_821_: bool;
    var phi_822_: bool;
    var phi_833_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_834_: bool;
    var phi_835_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_836_: bool;
    var phi_843_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_847_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_900_: f32;
    var phi_933_: bool;
    var phi_934_: bool;
    var phi_935_: bool;
    var phi_936_: bool;
    var phi_940_: bool;
    var phi_953_: bool;
    var phi_954_: bool;
    var phi_955_: bool;
    var phi_956_: bool;
    var phi_960_: bool;
    var phi_973_: bool;
    var phi_974_: bool;
    var phi_975_: bool;
    var phi_979_: bool;
    var phi_980_: bool;
    var phi_981_: bool;
    var phi_982_: bool;
    var phi_983_: bool;
    var phi_987_: bool;
    var phi_1010_: bool;
    var phi_1011_: bool;
    var phi_1012_: bool;
    var phi_1013_: bool;
    var phi_1014_: bool;
    var phi_1015_: bool;
    var phi_1019_: bool;
    var phi_1032_: bool;
    var phi_1033_: bool;
    var phi_1034_: bool;
    var phi_1038_: bool;
    var phi_1055_: bool;
    var phi_1056_: bool;
    var phi_1057_: bool;
    var phi_1058_: bool;
    var phi_1059_: bool;
    var phi_1060_: bool;
    var phi_1061_: bool;
    var phi_1065_: bool;
    var phi_1085_: bool;
    var phi_1086_: bool;
    var phi_1094_: u32;
    var phi_1095_: f32;
    var phi_1096_: u32;
    var phi_1097_: f32;
    var phi_1102_: f32;
    var phi_1113_: u32;
    var phi_1123_: u32;
    var phi_1129_: u32;
    var phi_1130_: u32;
    var phi_1131_: u32;
    var phi_1142_: vec3<f32>;
    var phi_1143_: vec3<f32>;
    var phi_1165_: vec3<f32>;
    var phi_1166_: vec3<f32>;
    var phi_1189_: u0028_lt_bvh_LightPoint_u0020_u32_u0029_;
    var phi_1257_: f32;
    var phi_1264_: f32;
    var phi_1271_: f32;
    var phi_1278_: f32;
    var phi_1285_: f32;
    var phi_1292_: f32;
    var phi_1309_: f32;
    var phi_1314_: f32;
    var phi_1319_: f32;
    var phi_1324_: f32;
    var phi_1329_: f32;
    var phi_1351_: bool;
    var phi_1352_: bool;
    var phi_1360_: u32;
    var phi_1361_: u32;
    var phi_1372_: vec3<f32>;
    var phi_1373_: vec3<f32>;
    var phi_1385_: u32;
    var phi_1388_: u32;
    var phi_1457_: f32;
    var phi_1458_: f32;
    var phi_1472_: u32;
    var phi_1495_: f32;
    var phi_1496_: f32;
    var phi_1510_: u32;
    var phi_1533_: f32;
    var phi_1534_: f32;
    var phi_1548_: u32;
    var phi_1675_: u32;
    var phi_1715_: u32;
    var phi_1716_: u32;
    var phi_1722_: u32;
    var phi_1751_: vec3<f32>;
    var phi_1752_: vec3<f32>;
    var phi_1781_: vec3<f32>;
    var phi_1782_: vec3<f32>;
    var phi_1811_: vec3<f32>;
    var phi_1812_: vec3<f32>;
    var phi_1830_: bool;
    var phi_1831_: bool;
    var phi_1835_: f32;
    var phi_1836_: f32;
    var phi_1837_: f32;
    var phi_1838_: f32;
    var phi_1846_: f32;
    var phi_1856_: bool;
    var phi_1857_: bool;
    var phi_1861_: f32;
    var phi_1862_: f32;
    var phi_1863_: f32;
    var phi_1864_: f32;
    var phi_1872_: f32;
    var phi_1882_: bool;
    var phi_1883_: bool;
    var phi_1887_: f32;
    var phi_1888_: f32;
    var phi_1889_: f32;
    var phi_1890_: f32;
    var phi_1898_: f32;
    var phi_1913_: f32;
    var phi_1914_: bool;
    var phi_1915_: f32;
    var phi_1916_: bool;
    var phi_1917_: f32;
    var phi_1918_: bool;
    var phi_1936_: f32;
    var phi_1937_: bool;
    var phi_1938_: bool;
    var phi_1939_: f32;
    var phi_1940_: bool;
    var phi_1941_: bool;
    var phi_1945_: bool;
    var phi_1946_: f32;
    var phi_1947_: bool;
    var phi_1975_: vec3<f32>;
    var phi_1976_: vec3<f32>;
    var phi_2001_: vec3<f32>;
    var phi_2002_: vec3<f32>;
    var phi_2027_: vec3<f32>;
    var phi_2028_: vec3<f32>;
    var phi_2084_: f32;
    var phi_2093_: f32;
    var phi_2102_: f32;
    var phi_2111_: f32;
    var phi_2118_: f32;
    var phi_2125_: f32;
    var phi_2138_: f32;
    var phi_2147_: f32;
    var phi_2156_: f32;
    var phi_2165_: f32;
    var phi_2172_: f32;
    var phi_2179_: f32;
    var phi_2196_: f32;
    var phi_2201_: f32;
    var phi_2206_: f32;
    var phi_2214_: f32;
    var phi_2219_: f32;
    var phi_2224_: f32;
    var phi_2236_: f32;
    var phi_2241_: f32;
    var phi_2246_: f32;
    var phi_2251_: f32;
    var phi_2256_: lt_bvh_triangle_Intersection;
    var phi_2257_: bool;
    var phi_2258_: lt_bvh_triangle_Intersection;
    var phi_2259_: bool;
    var phi_2263_: lt_bvh_triangle_Intersection;
    var phi_2264_: bool;
    var phi_2265_: lt_bvh_triangle_Intersection;
    var phi_2266_: bool;
    var phi_2267_: bool;
    var phi_2271_: bool;
    var phi_2275_: lt_bvh_triangle_Intersection;
    var phi_2489_: f32;
    var phi_2492_: bool;
    var phi_2493_: bool;
    var phi_2497_: bool;
    var phi_2498_: bool;
    var phi_2499_: bool;
    var phi_2500_: bool;
    var phi_2501_: bool;
    var phi_2502_: bool;
    var phi_2503_: bool;
    var phi_2504_: bool;
    var phi_2505_: bool;
    var phi_2506_: bool;
    var phi_2507_: bool;
    var phi_2508_: bool;
    var phi_2509_: bool;
    var phi_2510_: bool;
    var phi_2514_: bool;
    var phi_2515_: bool;
    var phi_2516_: bool;
    var phi_2520_: bool;
    var phi_2521_: bool;
    var phi_1676_: u32;
    var phi_2522_: bool;
    var phi_2523_: bool;
    var phi_2524_: bool;
    var local_5: bool;
    var phi_2528_: bool;
    var phi_2529_: bool;
    var phi_2550_: u32;
    var phi_2551_: u32;
    var phi_2555_: u32;
    var phi_2556_: u32;
    var phi_2557_: u32;
    var phi_2558_: u32;
    var phi_2559_: bool;
    var phi_2560_: bool;
    var phi_2561_: bool;
    var phi_2582_: u32;
    var phi_2583_: u32;
    var phi_2584_: u32;
    var phi_2585_: u32;
    var phi_2586_: u32;
    var phi_2587_: u32;
    var phi_2588_: bool;
    var phi_2589_: bool;
    var phi_1386_: u32;
    var phi_1389_: u32;
    var phi_2590_: bool;
    var phi_2591_: bool;
    var phi_2592_: bool;
    var local_6: bool;
    var phi_2596_: bool;
    var phi_2597_: bool;
    var phi_2601_: bool;
    var phi_2605_: bool;
    var phi_2609_: bool;
    var phi_2610_: bool;
    var phi_2614_: bool;
    var phi_2630_: bool;
    var phi_2631_: bool;
    var phi_2632_: bool;
    var phi_2633_: bool;
    var phi_2637_: bool;
    var phi_2650_: bool;
    var phi_2651_: bool;
    var phi_2652_: bool;
    var phi_2653_: bool;
    var phi_2657_: bool;
    var phi_2670_: bool;
    var phi_2671_: bool;
    var phi_2672_: bool;
    var phi_2676_: bool;
    var phi_2677_: bool;
    var phi_2678_: bool;
    var phi_2679_: bool;
    var phi_2680_: bool;
    var phi_2684_: bool;
    var phi_2754_: f32;
    var phi_2761_: f32;
    var phi_2768_: f32;
    var phi_2775_: f32;
    var phi_2782_: f32;
    var phi_2789_: f32;
    var phi_2806_: f32;
    var phi_2811_: f32;
    var phi_2816_: f32;
    var phi_2821_: f32;
    var phi_2826_: f32;
    var phi_2852_: bool;
    var phi_2853_: bool;
    var phi_2861_: u32;
    var phi_2862_: u32;
    var phi_2873_: vec3<f32>;
    var phi_2874_: vec3<f32>;
    var phi_2887_: u32;
    var phi_2892_: u32;
    var phi_2897_: u32;
    var phi_3011_: bool;
    var phi_3012_: bool;
    var phi_3043_: u32;
    var phi_3045_: u32;
    var phi_3048_: bool;
    var phi_3128_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_3155_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_3182_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_3188_: u32;
    var phi_3191_: u32;
    var phi_3205_: u32;
    var phi_3215_: u32;
    var phi_3225_: u32;
    var phi_3243_: u32;
    var phi_3253_: u32;
    var phi_3263_: u32;
    var phi_3299_: u32;
    var phi_3312_: u32;
    var phi_3317_: u32;
    var phi_3318_: u32;
    var phi_3319_: u32;
    var phi_3189_: u32;
    var phi_3192_: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var phi_3377_: u32;
    var phi_3380_: bool;
    var phi_3424_: vec3<f32>;
    var phi_3425_: vec3<f32>;
    var phi_3454_: vec3<f32>;
    var phi_3455_: vec3<f32>;
    var phi_3484_: vec3<f32>;
    var phi_3485_: vec3<f32>;
    var phi_3503_: bool;
    var phi_3504_: bool;
    var phi_3508_: f32;
    var phi_3509_: f32;
    var phi_3510_: f32;
    var phi_3511_: f32;
    var phi_3519_: f32;
    var phi_3529_: bool;
    var phi_3530_: bool;
    var phi_3534_: f32;
    var phi_3535_: f32;
    var phi_3536_: f32;
    var phi_3537_: f32;
    var phi_3545_: f32;
    var phi_3555_: bool;
    var phi_3556_: bool;
    var phi_3560_: f32;
    var phi_3561_: f32;
    var phi_3562_: f32;
    var phi_3563_: f32;
    var phi_3571_: f32;
    var phi_3586_: f32;
    var phi_3587_: bool;
    var phi_3588_: f32;
    var phi_3589_: bool;
    var phi_3590_: f32;
    var phi_3591_: bool;
    var phi_3609_: f32;
    var phi_3610_: bool;
    var phi_3611_: bool;
    var phi_3612_: f32;
    var phi_3613_: bool;
    var phi_3614_: bool;
    var phi_3618_: bool;
    var phi_3619_: f32;
    var phi_3620_: bool;
    var phi_3648_: vec3<f32>;
    var phi_3649_: vec3<f32>;
    var phi_3674_: vec3<f32>;
    var phi_3675_: vec3<f32>;
    var phi_3700_: vec3<f32>;
    var phi_3701_: vec3<f32>;
    var phi_3757_: f32;
    var phi_3766_: f32;
    var phi_3775_: f32;
    var phi_3784_: f32;
    var phi_3791_: f32;
    var phi_3798_: f32;
    var phi_3811_: f32;
    var phi_3820_: f32;
    var phi_3829_: f32;
    var phi_3838_: f32;
    var phi_3845_: f32;
    var phi_3852_: f32;
    var phi_3869_: f32;
    var phi_3874_: f32;
    var phi_3879_: f32;
    var phi_3887_: f32;
    var phi_3892_: f32;
    var phi_3897_: f32;
    var phi_3909_: f32;
    var phi_3914_: f32;
    var phi_3919_: f32;
    var phi_3924_: f32;
    var phi_3929_: lt_bvh_triangle_Intersection;
    var phi_3930_: bool;
    var phi_3931_: lt_bvh_triangle_Intersection;
    var phi_3932_: bool;
    var phi_3936_: lt_bvh_triangle_Intersection;
    var phi_3937_: bool;
    var phi_3938_: lt_bvh_triangle_Intersection;
    var phi_3939_: bool;
    var phi_3940_: bool;
    var phi_3944_: bool;
    var phi_3948_: lt_bvh_triangle_Intersection;
    var phi_4162_: f32;
    var phi_4165_: bool;
    var phi_4166_: bool;
    var phi_4167_: bool;
    var phi_4171_: bool;
    var phi_4172_: bool;
    var phi_4173_: bool;
    var phi_4174_: bool;
    var phi_4175_: bool;
    var phi_4176_: bool;
    var phi_4177_: bool;
    var phi_4178_: bool;
    var phi_4179_: bool;
    var phi_4180_: bool;
    var phi_3378_: u32;
    var phi_3381_: bool;
    var phi_4184_: bool;
    var phi_4185_: bool;
    var local_10: bool;
    var phi_4227_: bool;
    var phi_4228_: bool;
    var phi_4259_: u32;
    var phi_4260_: u32;
    var phi_3046_: u32;
    var phi_3049_: bool;
    var phi_4261_: bool;
    var phi_4262_: bool;
    var phi_4263_: bool;
    var local_11: bool;
    var phi_4267_: bool;
    var phi_4271_: bool;
    var phi_4272_: bool;
    var phi_4273_: bool;
    var phi_4274_: bool;
    var phi_4278_: bool;
    var phi_4279_: bool;
    var phi_4280_: bool;
    var phi_4284_: f32;
    var phi_4285_: f32;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;
    var local_18: bool;
    var local_19: bool;
    var local_20: bool;
    var local_21: bool;

    let _e85 = id_1;
    let _e92 = arrayLength((&nodes.member));
    let _e95 = arrayLength((&triangles.member));
    let _e101 = arrayLength((&rows.member));
    let _e105 = arrayLength((&vertices.member));
    let _e108 = arrayLength((&materials.member));
    let _e111 = arrayLength((&alpha_texels.member));
    let _e114 = p.member.size[0u];
    let _e116 = p.member.size[1u];
    let _e117 = lt_shaders_entry_pixel_index(_e85, _e114, _e116);
    if (bitcast<i32>(_e117.word) != 0i) {
        if (_e117.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e125 = samples.member[(0u + _e117.shift)];
        local_4 = abi_Sample(_e125.position, _e125.magnitude, _e125.normal, _e125.flags, _e125.shading_normal, _e125.albedo);
        let _e134 = _lt_shaders_abi_Sample_is_valid((&local_4));
        if _e134 {
            let _e136 = local_4.position;
            let _e138 = p.member.light.place;
            let _e144 = p.member.light.place[3u];
            let _e151 = (_e138.x - (_e136.x * _e144));
            let _e152 = (_e138.y - (_e136.y * _e144));
            let _e153 = (_e138.z - (_e136.z * _e144));
            let _e155 = local_4.normal;
            if ((((_e155.x * _e151) + (_e155.y * _e152)) + (_e155.z * _e153)) > 0f) {
                let _e169 = (((_e151 * _e151) + (_e152 * _e152)) + (_e153 * _e153));
                let _e171 = p.member.light.axis;
                let _e183 = p.member.light.place[3u];
                if (_e183 == 0f) {
                    phi_822_ = true;
                } else {
                    let _e186 = p.member.light.range_squared;
                    if (_e169 <= _e186) {
                        let _e189 = p.member.light.cos_outer;
                        phi_821_ = (-((((_e151 * _e171.x) + (_e152 * _e171.y)) + (_e153 * _e171.z))) >= (_e189 * sqrt(_e169)));
                    } else {
                        phi_821_ = false;
                    }
                    let _e194 = phi_821_;
                    phi_822_ = _e194;
                }
                let _e196 = phi_822_;
                if _e196 {
                    let _e198 = local_4.flags;
                    let _e206 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e212 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e206.unnamed.visibility, false), _e206.unnamed_1);
                    phi_833_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e212.unnamed, ((_e198 & 1u) == 0u));
                    phi_834_ = false;
                } else {
                    phi_833_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_834_ = true;
                }
                let _e217 = phi_833_;
                let _e219 = phi_834_;
                phi_835_ = _e217;
                phi_836_ = _e219;
            } else {
                phi_835_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_836_ = true;
            }
            let _e221 = phi_835_;
            let _e223 = phi_836_;
            if _e223 {
                let _e229 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e235 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e229.unnamed.visibility, false), _e229.unnamed_1);
                phi_843_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e235.unnamed, true);
            } else {
                phi_843_ = _e221;
            }
            let _e240 = phi_843_;
            phi_847_ = _e240;
        } else {
            let _e246 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e252 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e246.unnamed.visibility, false), _e246.unnamed_1);
            phi_847_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e252.unnamed, true);
        }
        let _e257 = phi_847_;
        let _e261 = space.member;
        if _e257.unnamed_1 {
            phi_4285_ = _e257.unnamed.visibility;
        } else {
            let _e264 = local_4.position;
            let _e266 = local_4.normal;
            let _e268 = local_4.magnitude;
            let _e270 = ((8f / 8388608f) * _e268);
            let _e272 = (_e266.x * _e270);
            let _e274 = (_e266.y * _e270);
            let _e276 = (_e266.z * _e270);
            let _e278 = (_e264.x + _e272);
            let _e280 = (_e264.y + _e274);
            let _e282 = (_e264.z + _e276);
            let _e286 = p.member.light.place;
            if (_e286.w == 0f) {
                phi_900_ = 300000000000000000000000000000000000000f;
            } else {
                phi_900_ = 1f;
            }
            let _e290 = phi_900_;
            let _e298 = (_e286.x - (_e278 * _e286.w));
            let _e299 = (_e286.y - (_e280 * _e286.w));
            let _e300 = (_e286.z - (_e282 * _e286.w));
            let _e301 = vec3<f32>(_e298, _e299, _e300);
            let _e302 = abs(_e298);
            let _e303 = abs(_e299);
            let _e304 = abs(_e300);
            if (abs(_e278) < 1000000000000000f) {
                if (abs(_e280) < 1000000000000000f) {
                    phi_933_ = (abs(_e282) < 1000000000000000f);
                    phi_934_ = false;
                } else {
                    phi_933_ = bool();
                    phi_934_ = true;
                }
                let _e312 = phi_933_;
                let _e314 = phi_934_;
                phi_935_ = _e312;
                phi_936_ = _e314;
            } else {
                phi_935_ = bool();
                phi_936_ = true;
            }
            let _e316 = phi_935_;
            let _e318 = phi_936_;
            if _e318 {
                phi_940_ = false;
            } else {
                phi_940_ = _e316;
            }
            let _e320 = phi_940_;
            if _e320 {
                if (_e302 < 1000000000000000f) {
                    if (_e303 < 1000000000000000f) {
                        phi_953_ = (_e304 < 1000000000000000f);
                        phi_954_ = false;
                    } else {
                        phi_953_ = bool();
                        phi_954_ = true;
                    }
                    let _e325 = phi_953_;
                    let _e327 = phi_954_;
                    phi_955_ = _e325;
                    phi_956_ = _e327;
                } else {
                    phi_955_ = bool();
                    phi_956_ = true;
                }
                let _e329 = phi_955_;
                let _e331 = phi_956_;
                if _e331 {
                    phi_960_ = false;
                } else {
                    phi_960_ = _e329;
                }
                let _e333 = phi_960_;
                if _e333 {
                    if (_e302 > 0f) {
                        phi_974_ = bool();
                        phi_975_ = true;
                    } else {
                        let _e335 = (_e303 > 0f);
                        if _e335 {
                            phi_973_ = bool();
                        } else {
                            phi_973_ = (_e304 > 0f);
                        }
                        let _e338 = phi_973_;
                        phi_974_ = _e338;
                        phi_975_ = _e335;
                    }
                    let _e340 = phi_974_;
                    let _e342 = phi_975_;
                    if _e342 {
                        phi_979_ = true;
                    } else {
                        phi_979_ = _e340;
                    }
                    let _e344 = phi_979_;
                    phi_980_ = _e344;
                    phi_981_ = false;
                } else {
                    phi_980_ = bool();
                    phi_981_ = true;
                }
                let _e346 = phi_980_;
                let _e348 = phi_981_;
                phi_982_ = _e346;
                phi_983_ = _e348;
            } else {
                phi_982_ = bool();
                phi_983_ = true;
            }
            let _e350 = phi_982_;
            let _e352 = phi_983_;
            if _e352 {
                phi_987_ = false;
            } else {
                phi_987_ = _e350;
            }
            let _e354 = phi_987_;
            if _e354 {
                if (_e261.low.x <= _e278) {
                    if (_e278 <= _e261.high.x) {
                        if (_e261.low.y <= _e280) {
                            phi_1010_ = (_e280 <= _e261.high.y);
                            phi_1011_ = false;
                        } else {
                            phi_1010_ = bool();
                            phi_1011_ = true;
                        }
                        let _e372 = phi_1010_;
                        let _e374 = phi_1011_;
                        phi_1012_ = _e372;
                        phi_1013_ = _e374;
                    } else {
                        phi_1012_ = bool();
                        phi_1013_ = true;
                    }
                    let _e376 = phi_1012_;
                    let _e378 = phi_1013_;
                    phi_1014_ = _e376;
                    phi_1015_ = _e378;
                } else {
                    phi_1014_ = bool();
                    phi_1015_ = true;
                }
                let _e380 = phi_1014_;
                let _e382 = phi_1015_;
                if _e382 {
                    phi_1019_ = false;
                } else {
                    phi_1019_ = _e380;
                }
                let _e384 = phi_1019_;
                if (abs(_e298) > 0.000000000000000000000000000001f) {
                    phi_1033_ = bool();
                    phi_1034_ = true;
                } else {
                    let _e389 = (abs(_e299) > 0.000000000000000000000000000001f);
                    if _e389 {
                        phi_1032_ = bool();
                    } else {
                        phi_1032_ = (abs(_e300) > 0.000000000000000000000000000001f);
                    }
                    let _e392 = phi_1032_;
                    phi_1033_ = _e392;
                    phi_1034_ = _e389;
                }
                let _e394 = phi_1033_;
                let _e396 = phi_1034_;
                if _e396 {
                    phi_1038_ = true;
                } else {
                    phi_1038_ = _e394;
                }
                let _e398 = phi_1038_;
                if _e384 {
                    if (_e261.low.z <= _e282) {
                        if (_e282 <= _e261.high.z) {
                            if (_e261.is_parallel == 0u) {
                                phi_1055_ = _e398;
                            } else {
                                phi_1055_ = true;
                            }
                            let _e404 = phi_1055_;
                            phi_1056_ = _e404;
                            phi_1057_ = false;
                        } else {
                            phi_1056_ = bool();
                            phi_1057_ = true;
                        }
                        let _e406 = phi_1056_;
                        let _e408 = phi_1057_;
                        phi_1058_ = _e406;
                        phi_1059_ = _e408;
                    } else {
                        phi_1058_ = bool();
                        phi_1059_ = true;
                    }
                    let _e410 = phi_1058_;
                    let _e412 = phi_1059_;
                    phi_1060_ = _e410;
                    phi_1061_ = _e412;
                } else {
                    phi_1060_ = bool();
                    phi_1061_ = true;
                }
                let _e414 = phi_1060_;
                let _e416 = phi_1061_;
                if _e416 {
                    phi_1065_ = false;
                } else {
                    phi_1065_ = _e414;
                }
                let _e418 = phi_1065_;
                if _e418 {
                    if (_e261.is_parallel == 0u) {
                        let _e421 = abs(_e298);
                        let _e422 = abs(_e299);
                        let _e423 = abs(_e300);
                        if (_e421 >= _e422) {
                            if (_e421 >= _e423) {
                                phi_1085_ = false;
                            } else {
                                phi_1085_ = true;
                            }
                            let _e427 = phi_1085_;
                            phi_1086_ = _e427;
                        } else {
                            phi_1086_ = true;
                        }
                        let _e429 = phi_1086_;
                        if _e429 {
                            if (_e422 >= _e423) {
                                phi_1094_ = 1u;
                                phi_1095_ = _e299;
                            } else {
                                phi_1094_ = 2u;
                                phi_1095_ = _e300;
                            }
                            let _e432 = phi_1094_;
                            let _e434 = phi_1095_;
                            phi_1096_ = _e432;
                            phi_1097_ = _e434;
                        } else {
                            phi_1096_ = 0u;
                            phi_1097_ = _e298;
                        }
                        let _e436 = phi_1096_;
                        let _e438 = phi_1097_;
                        if (_e438 < 0f) {
                            phi_1102_ = -1f;
                        } else {
                            phi_1102_ = 1f;
                        }
                        let _e441 = phi_1102_;
                        let _e442 = (_e441 < 0f);
                        if (_e436 == 0u) {
                            if _e442 {
                                phi_1113_ = _e261.roots.y;
                            } else {
                                phi_1113_ = _e261.roots.x;
                            }
                            let _e449 = phi_1113_;
                            phi_1131_ = _e449;
                        } else {
                            if (_e436 == 1u) {
                                if _e442 {
                                    phi_1123_ = _e261.roots.w;
                                } else {
                                    phi_1123_ = _e261.roots.z;
                                }
                                let _e456 = phi_1123_;
                                phi_1130_ = _e456;
                            } else {
                                if _e442 {
                                    phi_1129_ = _e261.roots_z.y;
                                } else {
                                    phi_1129_ = _e261.roots_z.x;
                                }
                                let _e462 = phi_1129_;
                                phi_1130_ = _e462;
                            }
                            let _e464 = phi_1130_;
                            phi_1131_ = _e464;
                        }
                        let _e466 = phi_1131_;
                        if (_e436 == 0u) {
                            phi_1143_ = vec3<f32>(_e299, _e300, _e298);
                        } else {
                            if (_e436 == 1u) {
                                phi_1142_ = vec3<f32>(_e300, _e298, _e299);
                            } else {
                                phi_1142_ = _e301;
                            }
                            let _e472 = phi_1142_;
                            phi_1143_ = _e472;
                        }
                        let _e474 = phi_1143_;
                        phi_1189_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm((_e474.x / _e474.z), (_e474.y / _e474.z), (_e441 / _e474.z)), _e466);
                    } else {
                        if (_e261.axis == 0u) {
                            phi_1166_ = vec3<f32>(_e280, _e282, _e278);
                        } else {
                            if (_e261.axis == 1u) {
                                phi_1165_ = vec3<f32>(_e282, _e278, _e280);
                            } else {
                                phi_1165_ = (_e264 + vec3<f32>(_e272, _e274, _e276));
                            }
                            let _e491 = phi_1165_;
                            phi_1166_ = _e491;
                        }
                        let _e493 = phi_1166_;
                        let _e505 = (_e493.z - _e261.middle.z);
                        phi_1189_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm(((_e493.x - _e261.middle.x) - (_e261.shear.x * _e505)), ((_e493.y - _e261.middle.y) - (_e261.shear.y * _e505)), (_e261.sign * _e505)), _e261.roots.x);
                    }
                    let _e518 = phi_1189_;
                    if (_e518.unnamed_1 == 4294967295u) {
                        phi_2609_ = false;
                        phi_2610_ = true;
                    } else {
                        if (0u < _e92) {
                        } else {
                            return;
                        }
                        let _e526 = nodes.member[0u].frame[0u];
                        let _e530 = nodes.member[0u].frame[1u];
                        let _e534 = nodes.member[0u].frame[2u];
                        let _e538 = nodes.member[0u].frame[0u];
                        let _e542 = nodes.member[0u].frame[1u];
                        let _e546 = nodes.member[0u].frame[2u];
                        let _e550 = nodes.member[0u].frame[3u];
                        let _e584 = core_intrinsics_maximum_number_nsz_f32_(abs(_e298), abs(_e299));
                        let _e585 = core_intrinsics_maximum_number_nsz_f32_(_e584, abs(_e300));
                        let _e586 = (_e585 * 0.0000000000009094947f);
                        if (abs(_e298) < _e586) {
                            phi_1257_ = _e586;
                        } else {
                            phi_1257_ = abs(_e298);
                        }
                        let _e591 = phi_1257_;
                        if (_e298 < 0f) {
                            phi_1264_ = (-1f / _e591);
                        } else {
                            phi_1264_ = (1f / _e591);
                        }
                        let _e596 = phi_1264_;
                        if (abs(_e299) < _e586) {
                            phi_1271_ = _e586;
                        } else {
                            phi_1271_ = abs(_e299);
                        }
                        let _e601 = phi_1271_;
                        if (_e299 < 0f) {
                            phi_1278_ = (-1f / _e601);
                        } else {
                            phi_1278_ = (1f / _e601);
                        }
                        let _e606 = phi_1278_;
                        if (abs(_e300) < _e586) {
                            phi_1285_ = _e586;
                        } else {
                            phi_1285_ = abs(_e300);
                        }
                        let _e611 = phi_1285_;
                        if (_e300 < 0f) {
                            phi_1292_ = (-1f / _e611);
                        } else {
                            phi_1292_ = (1f / _e611);
                        }
                        let _e616 = phi_1292_;
                        let _e620 = abs((bitcast<f32>(_e526) - _e278));
                        let _e621 = abs((bitcast<f32>(_e530) - _e280));
                        let _e622 = abs((bitcast<f32>(_e534) - _e282));
                        let _e626 = abs(((bitcast<f32>(_e538) + (bitcast<f32>((((_e550 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e278));
                        let _e627 = abs(((bitcast<f32>(_e542) + (bitcast<f32>((((_e550 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e280));
                        let _e628 = abs(((bitcast<f32>(_e546) + (bitcast<f32>((((_e550 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e282));
                        if (_e620 > _e626) {
                            phi_1309_ = _e620;
                        } else {
                            phi_1309_ = _e626;
                        }
                        let _e631 = phi_1309_;
                        if (_e621 > _e627) {
                            phi_1314_ = _e621;
                        } else {
                            phi_1314_ = _e627;
                        }
                        let _e634 = phi_1314_;
                        if (_e622 > _e628) {
                            phi_1319_ = _e622;
                        } else {
                            phi_1319_ = _e628;
                        }
                        let _e637 = phi_1319_;
                        if (_e631 > _e634) {
                            phi_1324_ = _e631;
                        } else {
                            phi_1324_ = _e634;
                        }
                        let _e640 = phi_1324_;
                        if (_e640 > _e637) {
                            phi_1329_ = _e640;
                        } else {
                            phi_1329_ = _e637;
                        }
                        let _e643 = phi_1329_;
                        let _e650 = (_e643 * 0.0000009536743f);
                        let _e651 = (abs(_e596) * _e650);
                        let _e652 = (abs(_e606) * _e650);
                        let _e653 = (abs(_e616) * _e650);
                        let _e654 = abs(_e298);
                        let _e655 = abs(_e299);
                        let _e656 = abs(_e300);
                        if (_e654 >= _e655) {
                            if (_e654 >= _e656) {
                                phi_1351_ = false;
                            } else {
                                phi_1351_ = true;
                            }
                            let _e660 = phi_1351_;
                            phi_1352_ = _e660;
                        } else {
                            phi_1352_ = true;
                        }
                        let _e662 = phi_1352_;
                        if _e662 {
                            if (_e655 >= _e656) {
                                phi_1360_ = 1u;
                            } else {
                                phi_1360_ = 2u;
                            }
                            let _e665 = phi_1360_;
                            phi_1361_ = _e665;
                        } else {
                            phi_1361_ = 0u;
                        }
                        let _e667 = phi_1361_;
                        if (_e667 == 0u) {
                            phi_1373_ = vec3<f32>(_e299, _e300, _e298);
                        } else {
                            if (_e667 == 1u) {
                                phi_1372_ = vec3<f32>(_e300, _e298, _e299);
                            } else {
                                phi_1372_ = _e301;
                            }
                            let _e673 = phi_1372_;
                            phi_1373_ = _e673;
                        }
                        let _e675 = phi_1373_;
                        let _e678 = (_e675.x / _e675.z);
                        let _e681 = (_e675.y / _e675.z);
                        local_3 = array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        phi_1385_ = ((_e518.unnamed_1 << bitcast<u32>(8i)) | 1u);
                        phi_1388_ = 0u;
                        loop {
                            let _e688 = phi_1385_;
                            let _e690 = phi_1388_;
                            let _e691 = (_e688 == 0u);
                            local_6 = _e691;
                            if _e691 {
                                phi_1386_ = u32();
                                phi_1389_ = u32();
                                phi_2590_ = false;
                                phi_2591_ = false;
                                phi_2592_ = false;
                            } else {
                                let _e699 = (_e688 & (_e688 - 1u));
                                let _e700 = (((_e688 >> bitcast<u32>(8i)) + select(firstTrailingBit(_e688), 32u, (_e688 == 0u))) * 4u);
                                if (_e700 < _e101) {
                                } else {
                                    return;
                                }
                                let _e704 = rows.member[(0u + _e700)];
                                let _e705 = (_e700 + 1u);
                                if (_e705 < _e101) {
                                } else {
                                    return;
                                }
                                let _e709 = rows.member[(0u + _e705)];
                                let _e710 = (_e700 + 2u);
                                if (_e710 < _e101) {
                                } else {
                                    return;
                                }
                                let _e714 = rows.member[(0u + _e710)];
                                let _e715 = (_e700 + 3u);
                                if (_e715 < _e101) {
                                } else {
                                    return;
                                }
                                let _e719 = rows.member[(0u + _e715)];
                                let _e720 = lt_bvh_LightNode(_e704, _e709, _e714, _e719);
                                let _e732 = (_e518.unnamed.positive_exponent - bitcast<f32>(_e720.frame.x));
                                let _e735 = bitcast<f32>((((_e720.frame.w >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                if (_e732 > 0f) {
                                    if (_e732 < (255f * _e735)) {
                                        phi_1457_ = (_e732 / _e735);
                                    } else {
                                        phi_1457_ = 255f;
                                    }
                                    let _e741 = phi_1457_;
                                    phi_1458_ = _e741;
                                } else {
                                    phi_1458_ = 0f;
                                }
                                let _e743 = phi_1458_;
                                let _e750 = select(select(u32(_e743), 0u, (_e743 < bitcast<f32>(0u))), 4294967295u, (_e743 > bitcast<f32>(1333788671u)));
                                if (f32(_e750) < _e743) {
                                    phi_1472_ = (_e750 + 1u);
                                } else {
                                    phi_1472_ = _e750;
                                }
                                let _e755 = phi_1472_;
                                let _e756 = (_e750 * 16843009u);
                                let _e757 = (_e755 * 16843009u);
                                let _e767 = (_e518.unnamed.negative_exponent - bitcast<f32>(_e720.frame.y));
                                let _e770 = bitcast<f32>((((_e720.frame.w >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                if (_e767 > 0f) {
                                    if (_e767 < (255f * _e770)) {
                                        phi_1495_ = (_e767 / _e770);
                                    } else {
                                        phi_1495_ = 255f;
                                    }
                                    let _e776 = phi_1495_;
                                    phi_1496_ = _e776;
                                } else {
                                    phi_1496_ = 0f;
                                }
                                let _e778 = phi_1496_;
                                let _e785 = select(select(u32(_e778), 0u, (_e778 < bitcast<f32>(0u))), 4294967295u, (_e778 > bitcast<f32>(1333788671u)));
                                if (f32(_e785) < _e778) {
                                    phi_1510_ = (_e785 + 1u);
                                } else {
                                    phi_1510_ = _e785;
                                }
                                let _e790 = phi_1510_;
                                let _e791 = (_e785 * 16843009u);
                                let _e792 = (_e790 * 16843009u);
                                let _e802 = (_e518.unnamed.min_variance - bitcast<f32>(_e720.frame.z));
                                let _e805 = bitcast<f32>((((_e720.frame.w >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                if (_e802 > 0f) {
                                    if (_e802 < (255f * _e805)) {
                                        phi_1533_ = (_e802 / _e805);
                                    } else {
                                        phi_1533_ = 255f;
                                    }
                                    let _e811 = phi_1533_;
                                    phi_1534_ = _e811;
                                } else {
                                    phi_1534_ = 0f;
                                }
                                let _e813 = phi_1534_;
                                let _e820 = select(select(u32(_e813), 0u, (_e813 < bitcast<f32>(0u))), 4294967295u, (_e813 > bitcast<f32>(1333788671u)));
                                if (f32(_e820) < _e813) {
                                    phi_1548_ = (_e820 + 1u);
                                } else {
                                    phi_1548_ = _e820;
                                }
                                let _e825 = phi_1548_;
                                let _e826 = (_e825 * 16843009u);
                                let _e959 = (((((((((((_e756 & ~(_e720.x.x)) | (~((_e720.x.x ^ _e756)) & ((_e756 | 2155905152u) - (_e720.x.x & 2139062143u)))) & ((_e720.x.z & ~(_e757)) | (~((_e757 ^ _e720.x.z)) & ((_e720.x.z | 2155905152u) - (_e757 & 2139062143u))))) & ((_e791 & ~(_e720.y.x)) | (~((_e720.y.x ^ _e791)) & ((_e791 | 2155905152u) - (_e720.y.x & 2139062143u))))) & ((_e720.y.z & ~(_e792)) | (~((_e792 ^ _e720.y.z)) & ((_e720.y.z | 2155905152u) - (_e792 & 2139062143u))))) & ((_e720.rest.x & ~(_e826)) | (~((_e826 ^ _e720.rest.x)) & ((_e720.rest.x | 2155905152u) - (_e826 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) | (((((((((((_e756 & ~(_e720.x.y)) | (~((_e720.x.y ^ _e756)) & ((_e756 | 2155905152u) - (_e720.x.y & 2139062143u)))) & ((_e720.x.w & ~(_e757)) | (~((_e757 ^ _e720.x.w)) & ((_e720.x.w | 2155905152u) - (_e757 & 2139062143u))))) & ((_e791 & ~(_e720.y.y)) | (~((_e720.y.y ^ _e791)) & ((_e791 | 2155905152u) - (_e720.y.y & 2139062143u))))) & ((_e720.y.w & ~(_e792)) | (~((_e792 ^ _e720.y.w)) & ((_e720.y.w | 2155905152u) - (_e792 & 2139062143u))))) & ((_e720.rest.y & ~(_e826)) | (~((_e826 ^ _e720.rest.y)) & ((_e720.rest.y | 2155905152u) - (_e826 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) << bitcast<u32>(4i)));
                                if ((_e720.frame.w & 16777216u) != 0u) {
                                    phi_1675_ = _e959;
                                    loop {
                                        let _e965 = phi_1675_;
                                        let _e966 = (_e965 == 0u);
                                        local_5 = _e966;
                                        local_14 = _e966;
                                        if _e966 {
                                            phi_1676_ = u32();
                                            phi_2522_ = false;
                                            phi_2523_ = false;
                                            phi_2524_ = false;
                                        } else {
                                            let _e969 = select(firstTrailingBit(_e965), 32u, (_e965 == 0u));
                                            let _e974 = (_e720.rest.z + (_e969 >> bitcast<u32>(2i)));
                                            if (_e974 < _e101) {
                                            } else {
                                                return;
                                            }
                                            let _e979 = rows.member[(0u + _e974)][0u];
                                            let _e983 = rows.member[(0u + _e974)][1u];
                                            let _e987 = rows.member[(0u + _e974)][2u];
                                            let _e991 = rows.member[(0u + _e974)][3u];
                                            if ((_e969 & 2u) == 0u) {
                                                phi_1715_ = _e983;
                                                phi_1716_ = _e979;
                                            } else {
                                                phi_1715_ = _e991;
                                                phi_1716_ = _e987;
                                            }
                                            let _e995 = phi_1715_;
                                            let _e997 = phi_1716_;
                                            if ((_e969 & 1u) == 0u) {
                                                phi_1722_ = _e997;
                                            } else {
                                                phi_1722_ = _e995;
                                            }
                                            let _e1001 = phi_1722_;
                                            if (_e1001 < _e95) {
                                            } else {
                                                return;
                                            }
                                            let _e1008 = triangles.member[(0u + _e1001)].v0_;
                                            let _e1010 = (_e1008.x - _e278);
                                            let _e1012 = (_e1008.y - _e280);
                                            let _e1014 = (_e1008.z - _e282);
                                            if (_e667 == 0u) {
                                                phi_1752_ = vec3<f32>(_e1012, _e1014, _e1010);
                                            } else {
                                                if (_e667 == 1u) {
                                                    phi_1751_ = vec3<f32>(_e1014, _e1010, _e1012);
                                                } else {
                                                    phi_1751_ = (_e1008 - vec3<f32>(_e278, _e280, _e282));
                                                }
                                                let _e1022 = phi_1751_;
                                                phi_1752_ = _e1022;
                                            }
                                            let _e1024 = phi_1752_;
                                            let _e1028 = (_e1024.x - (_e678 * _e1024.z));
                                            let _e1032 = (_e1024.y - (_e681 * _e1024.z));
                                            let _e1034 = triangles.member[(0u + _e1001)].v1_;
                                            let _e1036 = (_e1034.x - _e278);
                                            let _e1038 = (_e1034.y - _e280);
                                            let _e1040 = (_e1034.z - _e282);
                                            if (_e667 == 0u) {
                                                phi_1782_ = vec3<f32>(_e1038, _e1040, _e1036);
                                            } else {
                                                if (_e667 == 1u) {
                                                    phi_1781_ = vec3<f32>(_e1040, _e1036, _e1038);
                                                } else {
                                                    phi_1781_ = (_e1034 - vec3<f32>(_e278, _e280, _e282));
                                                }
                                                let _e1048 = phi_1781_;
                                                phi_1782_ = _e1048;
                                            }
                                            let _e1050 = phi_1782_;
                                            let _e1054 = (_e1050.x - (_e678 * _e1050.z));
                                            let _e1058 = (_e1050.y - (_e681 * _e1050.z));
                                            let _e1060 = triangles.member[(0u + _e1001)].v2_;
                                            let _e1062 = (_e1060.x - _e278);
                                            let _e1064 = (_e1060.y - _e280);
                                            let _e1066 = (_e1060.z - _e282);
                                            if (_e667 == 0u) {
                                                phi_1812_ = vec3<f32>(_e1064, _e1066, _e1062);
                                            } else {
                                                if (_e667 == 1u) {
                                                    phi_1811_ = vec3<f32>(_e1066, _e1062, _e1064);
                                                } else {
                                                    phi_1811_ = (_e1060 - vec3<f32>(_e278, _e280, _e282));
                                                }
                                                let _e1074 = phi_1811_;
                                                phi_1812_ = _e1074;
                                            }
                                            let _e1076 = phi_1812_;
                                            let _e1080 = (_e1076.x - (_e678 * _e1076.z));
                                            let _e1084 = (_e1076.y - (_e681 * _e1076.z));
                                            if (_e1054 < _e1080) {
                                                phi_1831_ = true;
                                            } else {
                                                if (_e1054 == _e1080) {
                                                    phi_1830_ = (_e1058 < _e1084);
                                                } else {
                                                    phi_1830_ = false;
                                                }
                                                let _e1089 = phi_1830_;
                                                phi_1831_ = _e1089;
                                            }
                                            let _e1091 = phi_1831_;
                                            if _e1091 {
                                                phi_1835_ = _e1084;
                                                phi_1836_ = _e1080;
                                                phi_1837_ = _e1058;
                                                phi_1838_ = _e1054;
                                            } else {
                                                phi_1835_ = _e1058;
                                                phi_1836_ = _e1054;
                                                phi_1837_ = _e1084;
                                                phi_1838_ = _e1080;
                                            }
                                            let _e1093 = phi_1835_;
                                            let _e1095 = phi_1836_;
                                            let _e1097 = phi_1837_;
                                            let _e1099 = phi_1838_;
                                            let _e1102 = ((_e1099 * _e1093) - (_e1097 * _e1095));
                                            if _e1091 {
                                                phi_1846_ = -(_e1102);
                                            } else {
                                                phi_1846_ = _e1102;
                                            }
                                            let _e1105 = phi_1846_;
                                            if (_e1080 < _e1028) {
                                                phi_1857_ = true;
                                            } else {
                                                if (_e1080 == _e1028) {
                                                    phi_1856_ = (_e1084 < _e1032);
                                                } else {
                                                    phi_1856_ = false;
                                                }
                                                let _e1110 = phi_1856_;
                                                phi_1857_ = _e1110;
                                            }
                                            let _e1112 = phi_1857_;
                                            if _e1112 {
                                                phi_1861_ = _e1032;
                                                phi_1862_ = _e1028;
                                                phi_1863_ = _e1084;
                                                phi_1864_ = _e1080;
                                            } else {
                                                phi_1861_ = _e1084;
                                                phi_1862_ = _e1080;
                                                phi_1863_ = _e1032;
                                                phi_1864_ = _e1028;
                                            }
                                            let _e1114 = phi_1861_;
                                            let _e1116 = phi_1862_;
                                            let _e1118 = phi_1863_;
                                            let _e1120 = phi_1864_;
                                            let _e1123 = ((_e1120 * _e1114) - (_e1118 * _e1116));
                                            if _e1112 {
                                                phi_1872_ = -(_e1123);
                                            } else {
                                                phi_1872_ = _e1123;
                                            }
                                            let _e1126 = phi_1872_;
                                            if (_e1028 < _e1054) {
                                                phi_1883_ = true;
                                            } else {
                                                if (_e1028 == _e1054) {
                                                    phi_1882_ = (_e1032 < _e1058);
                                                } else {
                                                    phi_1882_ = false;
                                                }
                                                let _e1131 = phi_1882_;
                                                phi_1883_ = _e1131;
                                            }
                                            let _e1133 = phi_1883_;
                                            if _e1133 {
                                                phi_1887_ = _e1058;
                                                phi_1888_ = _e1054;
                                                phi_1889_ = _e1032;
                                                phi_1890_ = _e1028;
                                            } else {
                                                phi_1887_ = _e1032;
                                                phi_1888_ = _e1028;
                                                phi_1889_ = _e1058;
                                                phi_1890_ = _e1054;
                                            }
                                            let _e1135 = phi_1887_;
                                            let _e1137 = phi_1888_;
                                            let _e1139 = phi_1889_;
                                            let _e1141 = phi_1890_;
                                            let _e1144 = ((_e1141 * _e1135) - (_e1139 * _e1137));
                                            if _e1133 {
                                                phi_1898_ = -(_e1144);
                                            } else {
                                                phi_1898_ = _e1144;
                                            }
                                            let _e1147 = phi_1898_;
                                            if (_e1105 >= 0f) {
                                                if (_e1126 >= 0f) {
                                                    if (_e1147 >= 0f) {
                                                        phi_1913_ = ((_e1105 + _e1126) + _e1147);
                                                        phi_1914_ = false;
                                                    } else {
                                                        phi_1913_ = f32();
                                                        phi_1914_ = true;
                                                    }
                                                    let _e1154 = phi_1913_;
                                                    let _e1156 = phi_1914_;
                                                    phi_1915_ = _e1154;
                                                    phi_1916_ = _e1156;
                                                } else {
                                                    phi_1915_ = f32();
                                                    phi_1916_ = true;
                                                }
                                                let _e1158 = phi_1915_;
                                                let _e1160 = phi_1916_;
                                                phi_1917_ = _e1158;
                                                phi_1918_ = _e1160;
                                            } else {
                                                phi_1917_ = f32();
                                                phi_1918_ = true;
                                            }
                                            let _e1162 = phi_1917_;
                                            let _e1164 = phi_1918_;
                                            if _e1164 {
                                                if (_e1105 <= 0f) {
                                                    if (_e1126 <= 0f) {
                                                        let _e1167 = (_e1147 <= 0f);
                                                        if _e1167 {
                                                        }
                                                        phi_1936_ = ((_e1105 + _e1126) + _e1147);
                                                        phi_1937_ = false;
                                                        phi_1938_ = _e1167;
                                                    } else {
                                                        phi_1936_ = f32();
                                                        phi_1937_ = true;
                                                        phi_1938_ = false;
                                                    }
                                                    let _e1171 = phi_1936_;
                                                    let _e1173 = phi_1937_;
                                                    let _e1175 = phi_1938_;
                                                    phi_1939_ = _e1171;
                                                    phi_1940_ = _e1173;
                                                    phi_1941_ = _e1175;
                                                } else {
                                                    phi_1939_ = f32();
                                                    phi_1940_ = true;
                                                    phi_1941_ = false;
                                                }
                                                let _e1177 = phi_1939_;
                                                let _e1179 = phi_1940_;
                                                let _e1181 = phi_1941_;
                                                if _e1179 {
                                                    phi_1945_ = false;
                                                } else {
                                                    phi_1945_ = _e1181;
                                                }
                                                let _e1183 = phi_1945_;
                                                phi_1946_ = _e1177;
                                                phi_1947_ = _e1183;
                                            } else {
                                                phi_1946_ = _e1162;
                                                phi_1947_ = true;
                                            }
                                            let _e1185 = phi_1946_;
                                            let _e1187 = phi_1947_;
                                            if _e1187 {
                                                let _e1188 = (_e1185 == 0f);
                                                if _e1188 {
                                                    phi_2263_ = lt_bvh_triangle_Intersection();
                                                    phi_2264_ = false;
                                                } else {
                                                    let _e1190 = triangles.member[(0u + _e1001)].v0_;
                                                    let _e1192 = (_e1190.x - _e278);
                                                    let _e1194 = (_e1190.y - _e280);
                                                    let _e1196 = (_e1190.z - _e282);
                                                    if (_e667 == 0u) {
                                                        phi_1976_ = vec3<f32>(_e1194, _e1196, _e1192);
                                                    } else {
                                                        if (_e667 == 1u) {
                                                            phi_1975_ = vec3<f32>(_e1196, _e1192, _e1194);
                                                        } else {
                                                            phi_1975_ = (_e1190 - vec3<f32>(_e278, _e280, _e282));
                                                        }
                                                        let _e1204 = phi_1975_;
                                                        phi_1976_ = _e1204;
                                                    }
                                                    let _e1206 = phi_1976_;
                                                    let _e1208 = triangles.member[(0u + _e1001)].v1_;
                                                    let _e1210 = triangles.member[(0u + _e1001)].v0_;
                                                    let _e1213 = (_e1208.x - _e1210.x);
                                                    let _e1216 = (_e1208.y - _e1210.y);
                                                    let _e1219 = (_e1208.z - _e1210.z);
                                                    if (_e667 == 0u) {
                                                        phi_2002_ = vec3<f32>(_e1216, _e1219, _e1213);
                                                    } else {
                                                        if (_e667 == 1u) {
                                                            phi_2001_ = vec3<f32>(_e1219, _e1213, _e1216);
                                                        } else {
                                                            phi_2001_ = (_e1208 - _e1210);
                                                        }
                                                        let _e1226 = phi_2001_;
                                                        phi_2002_ = _e1226;
                                                    }
                                                    let _e1228 = phi_2002_;
                                                    let _e1230 = triangles.member[(0u + _e1001)].v2_;
                                                    let _e1232 = triangles.member[(0u + _e1001)].v0_;
                                                    let _e1235 = (_e1230.x - _e1232.x);
                                                    let _e1238 = (_e1230.y - _e1232.y);
                                                    let _e1241 = (_e1230.z - _e1232.z);
                                                    if (_e667 == 0u) {
                                                        phi_2028_ = vec3<f32>(_e1238, _e1241, _e1235);
                                                    } else {
                                                        if (_e667 == 1u) {
                                                            phi_2027_ = vec3<f32>(_e1241, _e1235, _e1238);
                                                        } else {
                                                            phi_2027_ = (_e1230 - _e1232);
                                                        }
                                                        let _e1248 = phi_2027_;
                                                        phi_2028_ = _e1248;
                                                    }
                                                    let _e1250 = phi_2028_;
                                                    let _e1257 = ((_e1228.y * _e1250.z) - (_e1228.z * _e1250.y));
                                                    let _e1264 = ((_e1228.z * _e1250.x) - (_e1228.x * _e1250.z));
                                                    let _e1271 = ((_e1228.x * _e1250.y) - (_e1228.y * _e1250.x));
                                                    let _e1285 = (((1f / _e675.z) * (((_e1257 * _e1206.x) + (_e1264 * _e1206.y)) + (_e1271 * _e1206.z))) / (((_e1257 * _e678) + (_e1264 * _e681)) + _e1271));
                                                    if (_e1285 > 0f) {
                                                        if (_e1285 < _e290) {
                                                            let _e1289 = triangles.member[(0u + _e1001)].v0_;
                                                            let _e1291 = triangles.member[(0u + _e1001)].v1_;
                                                            if (_e1289.x < _e1291.x) {
                                                                phi_2084_ = _e1289.x;
                                                            } else {
                                                                phi_2084_ = _e1291.x;
                                                            }
                                                            let _e1298 = phi_2084_;
                                                            if (_e1289.y < _e1291.y) {
                                                                phi_2093_ = _e1289.y;
                                                            } else {
                                                                phi_2093_ = _e1291.y;
                                                            }
                                                            let _e1305 = phi_2093_;
                                                            if (_e1289.z < _e1291.z) {
                                                                phi_2102_ = _e1289.z;
                                                            } else {
                                                                phi_2102_ = _e1291.z;
                                                            }
                                                            let _e1312 = phi_2102_;
                                                            let _e1314 = triangles.member[(0u + _e1001)].v2_;
                                                            if (_e1298 < _e1314.x) {
                                                                phi_2111_ = _e1298;
                                                            } else {
                                                                phi_2111_ = _e1314.x;
                                                            }
                                                            let _e1319 = phi_2111_;
                                                            if (_e1305 < _e1314.y) {
                                                                phi_2118_ = _e1305;
                                                            } else {
                                                                phi_2118_ = _e1314.y;
                                                            }
                                                            let _e1324 = phi_2118_;
                                                            if (_e1312 < _e1314.z) {
                                                                phi_2125_ = _e1312;
                                                            } else {
                                                                phi_2125_ = _e1314.z;
                                                            }
                                                            let _e1329 = phi_2125_;
                                                            let _e1331 = triangles.member[(0u + _e1001)].v0_;
                                                            let _e1333 = triangles.member[(0u + _e1001)].v1_;
                                                            if (_e1331.x > _e1333.x) {
                                                                phi_2138_ = _e1331.x;
                                                            } else {
                                                                phi_2138_ = _e1333.x;
                                                            }
                                                            let _e1340 = phi_2138_;
                                                            if (_e1331.y > _e1333.y) {
                                                                phi_2147_ = _e1331.y;
                                                            } else {
                                                                phi_2147_ = _e1333.y;
                                                            }
                                                            let _e1347 = phi_2147_;
                                                            if (_e1331.z > _e1333.z) {
                                                                phi_2156_ = _e1331.z;
                                                            } else {
                                                                phi_2156_ = _e1333.z;
                                                            }
                                                            let _e1354 = phi_2156_;
                                                            let _e1356 = triangles.member[(0u + _e1001)].v2_;
                                                            if (_e1340 > _e1356.x) {
                                                                phi_2165_ = _e1340;
                                                            } else {
                                                                phi_2165_ = _e1356.x;
                                                            }
                                                            let _e1361 = phi_2165_;
                                                            if (_e1347 > _e1356.y) {
                                                                phi_2172_ = _e1347;
                                                            } else {
                                                                phi_2172_ = _e1356.y;
                                                            }
                                                            let _e1366 = phi_2172_;
                                                            if (_e1354 > _e1356.z) {
                                                                phi_2179_ = _e1354;
                                                            } else {
                                                                phi_2179_ = _e1356.z;
                                                            }
                                                            let _e1371 = phi_2179_;
                                                            let _e1375 = ((_e1319 - _e278) * _e596);
                                                            let _e1376 = ((_e1324 - _e280) * _e606);
                                                            let _e1377 = ((_e1329 - _e282) * _e616);
                                                            let _e1381 = ((_e1361 - _e278) * _e596);
                                                            let _e1382 = ((_e1366 - _e280) * _e606);
                                                            let _e1383 = ((_e1371 - _e282) * _e616);
                                                            if (_e1375 < _e1381) {
                                                                phi_2196_ = _e1375;
                                                            } else {
                                                                phi_2196_ = _e1381;
                                                            }
                                                            let _e1386 = phi_2196_;
                                                            if (_e1376 < _e1382) {
                                                                phi_2201_ = _e1376;
                                                            } else {
                                                                phi_2201_ = _e1382;
                                                            }
                                                            let _e1389 = phi_2201_;
                                                            if (_e1377 < _e1383) {
                                                                phi_2206_ = _e1377;
                                                            } else {
                                                                phi_2206_ = _e1383;
                                                            }
                                                            let _e1392 = phi_2206_;
                                                            if (_e1375 > _e1381) {
                                                                phi_2214_ = _e1375;
                                                            } else {
                                                                phi_2214_ = _e1381;
                                                            }
                                                            let _e1398 = phi_2214_;
                                                            if (_e1376 > _e1382) {
                                                                phi_2219_ = _e1376;
                                                            } else {
                                                                phi_2219_ = _e1382;
                                                            }
                                                            let _e1401 = phi_2219_;
                                                            if (_e1377 > _e1383) {
                                                                phi_2224_ = _e1377;
                                                            } else {
                                                                phi_2224_ = _e1383;
                                                            }
                                                            let _e1404 = phi_2224_;
                                                            let _e1408 = core_intrinsics_maximum_number_nsz_f32_((_e1386 - _e651), (_e1389 - _e652));
                                                            let _e1409 = core_intrinsics_maximum_number_nsz_f32_(_e1408, (_e1392 - _e653));
                                                            let _e1410 = core_intrinsics_minimum_number_nsz_f32_((_e1398 + _e651), (_e1401 + _e652));
                                                            let _e1411 = core_intrinsics_minimum_number_nsz_f32_(_e1410, (_e1404 + _e653));
                                                            if (_e1409 > -300000000000000000000000000000000000000f) {
                                                                phi_2236_ = _e1409;
                                                            } else {
                                                                phi_2236_ = -300000000000000000000000000000000000000f;
                                                            }
                                                            let _e1414 = phi_2236_;
                                                            if (_e1411 < 300000000000000000000000000000000000000f) {
                                                                phi_2241_ = _e1411;
                                                            } else {
                                                                phi_2241_ = 300000000000000000000000000000000000000f;
                                                            }
                                                            let _e1417 = phi_2241_;
                                                            if (_e1285 < _e1414) {
                                                                phi_2246_ = _e1414;
                                                            } else {
                                                                phi_2246_ = _e1285;
                                                            }
                                                            let _e1420 = phi_2246_;
                                                            if (_e1420 > _e1417) {
                                                                phi_2251_ = _e1417;
                                                            } else {
                                                                phi_2251_ = _e1420;
                                                            }
                                                            let _e1423 = phi_2251_;
                                                            phi_2256_ = lt_bvh_triangle_Intersection(_e1423, (_e1126 / _e1185), (_e1147 / _e1185), (_e1414 <= _e1417));
                                                            phi_2257_ = false;
                                                        } else {
                                                            phi_2256_ = lt_bvh_triangle_Intersection();
                                                            phi_2257_ = true;
                                                        }
                                                        let _e1429 = phi_2256_;
                                                        let _e1431 = phi_2257_;
                                                        phi_2258_ = _e1429;
                                                        phi_2259_ = _e1431;
                                                    } else {
                                                        phi_2258_ = lt_bvh_triangle_Intersection();
                                                        phi_2259_ = true;
                                                    }
                                                    let _e1433 = phi_2258_;
                                                    let _e1435 = phi_2259_;
                                                    if _e1435 {
                                                    }
                                                    phi_2263_ = _e1433;
                                                    phi_2264_ = _e1435;
                                                }
                                                let _e1437 = phi_2263_;
                                                let _e1439 = phi_2264_;
                                                phi_2265_ = _e1437;
                                                phi_2266_ = _e1188;
                                                phi_2267_ = _e1439;
                                            } else {
                                                phi_2265_ = lt_bvh_triangle_Intersection();
                                                phi_2266_ = true;
                                                phi_2267_ = false;
                                            }
                                            let _e1441 = phi_2265_;
                                            let _e1443 = phi_2266_;
                                            let _e1445 = phi_2267_;
                                            if _e1443 {
                                                phi_2271_ = true;
                                            } else {
                                                phi_2271_ = _e1445;
                                            }
                                            let _e1447 = phi_2271_;
                                            if _e1447 {
                                                phi_2275_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                            } else {
                                                phi_2275_ = _e1441;
                                            }
                                            let _e1449 = phi_2275_;
                                            if _e1449.is_hit {
                                                if (_e1449.t > 0f) {
                                                    if (_e1449.t < _e290) {
                                                        let _e1456 = triangles.member[(0u + _e1001)].i0_;
                                                        let _e1458 = ((_e1456 & 2147483648u) == 0u);
                                                        if _e1458 {
                                                            phi_2498_ = false;
                                                            phi_2499_ = false;
                                                        } else {
                                                            if (_e1001 < _e95) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1465 = triangles.member[(0u + _e1001)].i0_;
                                                            let _e1466 = (_e1465 & 2147483647u);
                                                            let _e1468 = triangles.member[(0u + _e1001)].i1_;
                                                            let _e1470 = triangles.member[(0u + _e1001)].i2_;
                                                            if (_e1466 < _e105) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1474 = vertices.member[(0u + _e1466)];
                                                            if (_e1468 < _e105) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1478 = vertices.member[(0u + _e1468)];
                                                            if (_e1470 < _e105) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1482 = vertices.member[(0u + _e1470)];
                                                            let _e1483 = array<abi_Vertex, 3>(_e1474, _e1478, _e1482);
                                                            if (_e1483[0].material < _e108) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1489 = materials.member[(0u + _e1483[0].material)];
                                                            if ((_e1489.flags & 1u) == 1u) {
                                                                let _e1494 = ((1f - _e1449.u) - _e1449.v);
                                                                if (_e1489.cutoff <= 0f) {
                                                                    phi_2492_ = true;
                                                                } else {
                                                                    let _e1521 = (_e1489.base_color.w * ((((f32((_e1483[0].color >> bitcast<u32>(24i))) * _e1494) + (f32((_e1483[1].color >> bitcast<u32>(24i))) * _e1449.u)) + (f32((_e1483[2].color >> bitcast<u32>(24i))) * _e1449.v)) * (1f / 255f)));
                                                                    if (_e1489.alpha_size == 0u) {
                                                                        phi_2489_ = _e1521;
                                                                    } else {
                                                                        local_2.offset = _e1489.alpha_offset;
                                                                        local_2.size = _e1489.alpha_size;
                                                                        local_2.flags = _e1489.flags;
                                                                        let _e1552 = _lt_shaders_texture_TextureView_quad((&local_2), (((_e1483[0].u * _e1494) + (_e1483[1].u * _e1449.u)) + (_e1483[2].u * _e1449.v)), (((_e1483[0].v * _e1494) + (_e1483[1].v * _e1449.u)) + (_e1483[2].v * _e1449.v)));
                                                                        let _e1556 = (_e1552.indices[0] >> bitcast<u32>(2i));
                                                                        if (_e1556 < _e111) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e1560 = alpha_texels.member[(0u + _e1556)];
                                                                        let _e1576 = (_e1552.indices[1] >> bitcast<u32>(2i));
                                                                        if (_e1576 < _e111) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e1580 = alpha_texels.member[(0u + _e1576)];
                                                                        let _e1597 = (_e1552.indices[2] >> bitcast<u32>(2i));
                                                                        if (_e1597 < _e111) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e1601 = alpha_texels.member[(0u + _e1597)];
                                                                        let _e1618 = (_e1552.indices[3] >> bitcast<u32>(2i));
                                                                        if (_e1618 < _e111) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e1622 = alpha_texels.member[(0u + _e1618)];
                                                                        phi_2489_ = (_e1521 * (((((f32(((_e1560 >> bitcast<u32>((((_e1552.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1552.weights.x) + ((f32(((_e1580 >> bitcast<u32>((((_e1552.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1552.weights.y)) + ((f32(((_e1601 >> bitcast<u32>((((_e1552.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1552.weights.z)) + ((f32(((_e1622 >> bitcast<u32>((((_e1552.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1552.weights.w)));
                                                                    }
                                                                    let _e1638 = phi_2489_;
                                                                    phi_2492_ = (_e1638 >= _e1489.cutoff);
                                                                }
                                                                let _e1642 = phi_2492_;
                                                                phi_2493_ = _e1642;
                                                            } else {
                                                                phi_2493_ = false;
                                                            }
                                                            let _e1644 = phi_2493_;
                                                            if _e1644 {
                                                                phi_2497_ = false;
                                                            } else {
                                                                phi_2497_ = true;
                                                            }
                                                            let _e1646 = phi_2497_;
                                                            phi_2498_ = _e1646;
                                                            phi_2499_ = _e1644;
                                                        }
                                                        let _e1648 = phi_2498_;
                                                        let _e1650 = phi_2499_;
                                                        phi_2500_ = _e1648;
                                                        phi_2501_ = _e1458;
                                                        phi_2502_ = _e1650;
                                                    } else {
                                                        phi_2500_ = true;
                                                        phi_2501_ = false;
                                                        phi_2502_ = false;
                                                    }
                                                    let _e1652 = phi_2500_;
                                                    let _e1654 = phi_2501_;
                                                    let _e1656 = phi_2502_;
                                                    phi_2503_ = false;
                                                    phi_2504_ = _e1652;
                                                    phi_2505_ = _e1654;
                                                    phi_2506_ = _e1656;
                                                } else {
                                                    phi_2503_ = true;
                                                    phi_2504_ = false;
                                                    phi_2505_ = false;
                                                    phi_2506_ = false;
                                                }
                                                let _e1658 = phi_2503_;
                                                let _e1660 = phi_2504_;
                                                let _e1662 = phi_2505_;
                                                let _e1664 = phi_2506_;
                                                phi_2507_ = _e1658;
                                                phi_2508_ = _e1660;
                                                phi_2509_ = _e1662;
                                                phi_2510_ = _e1664;
                                            } else {
                                                phi_2507_ = true;
                                                phi_2508_ = false;
                                                phi_2509_ = false;
                                                phi_2510_ = false;
                                            }
                                            let _e1666 = phi_2507_;
                                            let _e1668 = phi_2508_;
                                            let _e1670 = phi_2509_;
                                            let _e1672 = phi_2510_;
                                            if _e1666 {
                                                phi_2514_ = true;
                                                phi_2515_ = false;
                                                phi_2516_ = false;
                                            } else {
                                                phi_2514_ = _e1668;
                                                phi_2515_ = _e1670;
                                                phi_2516_ = _e1672;
                                            }
                                            let _e1674 = phi_2514_;
                                            let _e1676 = phi_2515_;
                                            let _e1678 = phi_2516_;
                                            if _e1674 {
                                                phi_2520_ = false;
                                                phi_2521_ = false;
                                            } else {
                                                phi_2520_ = _e1676;
                                                phi_2521_ = _e1678;
                                            }
                                            let _e1680 = phi_2520_;
                                            let _e1682 = phi_2521_;
                                            phi_1676_ = (_e965 & (_e965 - 1u));
                                            phi_2522_ = _e1674;
                                            phi_2523_ = _e1680;
                                            phi_2524_ = _e1682;
                                        }
                                        let _e1684 = phi_1676_;
                                        let _e1686 = phi_2522_;
                                        let _e1688 = phi_2523_;
                                        let _e1690 = phi_2524_;
                                        local_12 = _e1688;
                                        local_13 = _e1690;
                                        continue;
                                        continuing {
                                            phi_1675_ = _e1684;
                                            break if !(_e1686);
                                        }
                                    }
                                    let _e1693 = local_5;
                                    if _e1693 {
                                        phi_2528_ = false;
                                        phi_2529_ = false;
                                    } else {
                                        let _e3582 = local_12;
                                        phi_2528_ = _e3582;
                                        let _e3585 = local_13;
                                        phi_2529_ = _e3585;
                                    }
                                    let _e1695 = phi_2528_;
                                    let _e1697 = phi_2529_;
                                    phi_2557_ = _e699;
                                    phi_2558_ = _e690;
                                    let _e3594 = local_14;
                                    phi_2559_ = _e3594;
                                    phi_2560_ = _e1695;
                                    phi_2561_ = _e1697;
                                } else {
                                    if (_e959 == 0u) {
                                        phi_2555_ = _e699;
                                        phi_2556_ = _e690;
                                    } else {
                                        if ((_e699 & 255u) == 0u) {
                                            phi_2551_ = _e690;
                                        } else {
                                            if (_e690 < 32u) {
                                                if (_e690 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                local_3[(0u + _e690)] = _e699;
                                                phi_2550_ = (_e690 + 1u);
                                            } else {
                                                phi_2550_ = _e690;
                                            }
                                            let _e1707 = phi_2550_;
                                            phi_2551_ = _e1707;
                                        }
                                        let _e1709 = phi_2551_;
                                        phi_2555_ = ((_e720.rest.z << bitcast<u32>(8i)) | _e959);
                                        phi_2556_ = _e1709;
                                    }
                                    let _e1716 = phi_2555_;
                                    let _e1718 = phi_2556_;
                                    phi_2557_ = _e1716;
                                    phi_2558_ = _e1718;
                                    phi_2559_ = true;
                                    phi_2560_ = false;
                                    phi_2561_ = false;
                                }
                                let _e1720 = phi_2557_;
                                let _e1722 = phi_2558_;
                                let _e1724 = phi_2559_;
                                let _e1726 = phi_2560_;
                                let _e1728 = phi_2561_;
                                if _e1724 {
                                    if ((_e1720 & 255u) == 0u) {
                                        if (_e1722 > 0u) {
                                            let _e1732 = (_e1722 - 1u);
                                            if (_e1732 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e1736 = local_3[(0u + _e1732)];
                                            phi_2582_ = _e1736;
                                            phi_2583_ = _e1732;
                                        } else {
                                            phi_2582_ = 0u;
                                            phi_2583_ = _e1722;
                                        }
                                        let _e1738 = phi_2582_;
                                        let _e1740 = phi_2583_;
                                        phi_2584_ = _e1738;
                                        phi_2585_ = _e1740;
                                    } else {
                                        phi_2584_ = _e1720;
                                        phi_2585_ = _e1722;
                                    }
                                    let _e1742 = phi_2584_;
                                    let _e1744 = phi_2585_;
                                    phi_2586_ = _e1742;
                                    phi_2587_ = _e1744;
                                    phi_2588_ = false;
                                    phi_2589_ = false;
                                } else {
                                    phi_2586_ = u32();
                                    phi_2587_ = u32();
                                    phi_2588_ = _e1726;
                                    phi_2589_ = _e1728;
                                }
                                let _e1746 = phi_2586_;
                                let _e1748 = phi_2587_;
                                let _e1750 = phi_2588_;
                                let _e1752 = phi_2589_;
                                phi_1386_ = _e1746;
                                phi_1389_ = _e1748;
                                phi_2590_ = _e1724;
                                phi_2591_ = _e1750;
                                phi_2592_ = _e1752;
                            }
                            let _e1754 = phi_1386_;
                            let _e1756 = phi_1389_;
                            let _e1758 = phi_2590_;
                            let _e1760 = phi_2591_;
                            let _e1762 = phi_2592_;
                            local_15 = _e1760;
                            local_16 = _e1762;
                            continue;
                            continuing {
                                phi_1385_ = _e1754;
                                phi_1388_ = _e1756;
                                break if !(_e1758);
                            }
                        }
                        let _e1765 = local_6;
                        if _e1765 {
                            phi_2596_ = false;
                            phi_2597_ = false;
                        } else {
                            let _e3613 = local_15;
                            phi_2596_ = _e3613;
                            let _e3616 = local_16;
                            phi_2597_ = _e3616;
                        }
                        let _e1767 = phi_2596_;
                        let _e1769 = phi_2597_;
                        if _e1767 {
                            phi_2601_ = false;
                        } else {
                            phi_2601_ = _e1769;
                        }
                        let _e1771 = phi_2601_;
                        if _e1771 {
                            phi_2605_ = true;
                        } else {
                            phi_2605_ = _e1767;
                        }
                        let _e1773 = phi_2605_;
                        if _e1773 {
                        }
                        phi_2609_ = true;
                        phi_2610_ = _e1773;
                    }
                    let _e1775 = phi_2609_;
                    let _e1777 = phi_2610_;
                    if _e1777 {
                        phi_2614_ = _e1775;
                    } else {
                        phi_2614_ = false;
                    }
                    let _e1779 = phi_2614_;
                    phi_4279_ = _e1779;
                } else {
                    let _e1780 = abs(_e298);
                    let _e1781 = abs(_e299);
                    let _e1782 = abs(_e300);
                    if (abs(_e278) < 1000000000000000f) {
                        if (abs(_e280) < 1000000000000000f) {
                            phi_2630_ = (abs(_e282) < 1000000000000000f);
                            phi_2631_ = false;
                        } else {
                            phi_2630_ = bool();
                            phi_2631_ = true;
                        }
                        let _e1790 = phi_2630_;
                        let _e1792 = phi_2631_;
                        phi_2632_ = _e1790;
                        phi_2633_ = _e1792;
                    } else {
                        phi_2632_ = bool();
                        phi_2633_ = true;
                    }
                    let _e1794 = phi_2632_;
                    let _e1796 = phi_2633_;
                    if _e1796 {
                        phi_2637_ = false;
                    } else {
                        phi_2637_ = _e1794;
                    }
                    let _e1798 = phi_2637_;
                    if _e1798 {
                        if (_e1780 < 1000000000000000f) {
                            if (_e1781 < 1000000000000000f) {
                                phi_2650_ = (_e1782 < 1000000000000000f);
                                phi_2651_ = false;
                            } else {
                                phi_2650_ = bool();
                                phi_2651_ = true;
                            }
                            let _e1803 = phi_2650_;
                            let _e1805 = phi_2651_;
                            phi_2652_ = _e1803;
                            phi_2653_ = _e1805;
                        } else {
                            phi_2652_ = bool();
                            phi_2653_ = true;
                        }
                        let _e1807 = phi_2652_;
                        let _e1809 = phi_2653_;
                        if _e1809 {
                            phi_2657_ = false;
                        } else {
                            phi_2657_ = _e1807;
                        }
                        let _e1811 = phi_2657_;
                        if _e1811 {
                            if (_e1780 > 0f) {
                                phi_2671_ = bool();
                                phi_2672_ = true;
                            } else {
                                let _e1813 = (_e1781 > 0f);
                                if _e1813 {
                                    phi_2670_ = bool();
                                } else {
                                    phi_2670_ = (_e1782 > 0f);
                                }
                                let _e1816 = phi_2670_;
                                phi_2671_ = _e1816;
                                phi_2672_ = _e1813;
                            }
                            let _e1818 = phi_2671_;
                            let _e1820 = phi_2672_;
                            if _e1820 {
                                phi_2676_ = true;
                            } else {
                                phi_2676_ = _e1818;
                            }
                            let _e1822 = phi_2676_;
                            phi_2677_ = _e1822;
                            phi_2678_ = false;
                        } else {
                            phi_2677_ = bool();
                            phi_2678_ = true;
                        }
                        let _e1824 = phi_2677_;
                        let _e1826 = phi_2678_;
                        phi_2679_ = _e1824;
                        phi_2680_ = _e1826;
                    } else {
                        phi_2679_ = bool();
                        phi_2680_ = true;
                    }
                    let _e1828 = phi_2679_;
                    let _e1830 = phi_2680_;
                    if _e1830 {
                        phi_2684_ = false;
                    } else {
                        phi_2684_ = _e1828;
                    }
                    let _e1832 = phi_2684_;
                    if _e1832 {
                        let _e1833 = (0u >= _e92);
                        if _e1833 {
                            phi_4272_ = bool();
                        } else {
                            if (0u < _e92) {
                            } else {
                                return;
                            }
                            let _e1839 = nodes.member[(0u + 0u)].frame[0u];
                            let _e1843 = nodes.member[(0u + 0u)].frame[1u];
                            let _e1847 = nodes.member[(0u + 0u)].frame[2u];
                            let _e1851 = nodes.member[(0u + 0u)].frame[0u];
                            let _e1855 = nodes.member[(0u + 0u)].frame[1u];
                            let _e1859 = nodes.member[(0u + 0u)].frame[2u];
                            let _e1863 = nodes.member[(0u + 0u)].frame[3u];
                            let _e1897 = core_intrinsics_maximum_number_nsz_f32_(abs(_e298), abs(_e299));
                            let _e1898 = core_intrinsics_maximum_number_nsz_f32_(_e1897, abs(_e300));
                            let _e1899 = (_e1898 * 0.0000000000009094947f);
                            if (abs(_e298) < _e1899) {
                                phi_2754_ = _e1899;
                            } else {
                                phi_2754_ = abs(_e298);
                            }
                            let _e1904 = phi_2754_;
                            if (_e298 < 0f) {
                                phi_2761_ = (-1f / _e1904);
                            } else {
                                phi_2761_ = (1f / _e1904);
                            }
                            let _e1909 = phi_2761_;
                            if (abs(_e299) < _e1899) {
                                phi_2768_ = _e1899;
                            } else {
                                phi_2768_ = abs(_e299);
                            }
                            let _e1914 = phi_2768_;
                            if (_e299 < 0f) {
                                phi_2775_ = (-1f / _e1914);
                            } else {
                                phi_2775_ = (1f / _e1914);
                            }
                            let _e1919 = phi_2775_;
                            if (abs(_e300) < _e1899) {
                                phi_2782_ = _e1899;
                            } else {
                                phi_2782_ = abs(_e300);
                            }
                            let _e1924 = phi_2782_;
                            if (_e300 < 0f) {
                                phi_2789_ = (-1f / _e1924);
                            } else {
                                phi_2789_ = (1f / _e1924);
                            }
                            let _e1929 = phi_2789_;
                            let _e1933 = abs((bitcast<f32>(_e1839) - _e278));
                            let _e1934 = abs((bitcast<f32>(_e1843) - _e280));
                            let _e1935 = abs((bitcast<f32>(_e1847) - _e282));
                            let _e1939 = abs(((bitcast<f32>(_e1851) + (bitcast<f32>((((_e1863 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e278));
                            let _e1940 = abs(((bitcast<f32>(_e1855) + (bitcast<f32>((((_e1863 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e280));
                            let _e1941 = abs(((bitcast<f32>(_e1859) + (bitcast<f32>((((_e1863 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e282));
                            if (_e1933 > _e1939) {
                                phi_2806_ = _e1933;
                            } else {
                                phi_2806_ = _e1939;
                            }
                            let _e1944 = phi_2806_;
                            if (_e1934 > _e1940) {
                                phi_2811_ = _e1934;
                            } else {
                                phi_2811_ = _e1940;
                            }
                            let _e1947 = phi_2811_;
                            if (_e1935 > _e1941) {
                                phi_2816_ = _e1935;
                            } else {
                                phi_2816_ = _e1941;
                            }
                            let _e1950 = phi_2816_;
                            if (_e1944 > _e1947) {
                                phi_2821_ = _e1944;
                            } else {
                                phi_2821_ = _e1947;
                            }
                            let _e1953 = phi_2821_;
                            if (_e1953 > _e1950) {
                                phi_2826_ = _e1953;
                            } else {
                                phi_2826_ = _e1950;
                            }
                            let _e1956 = phi_2826_;
                            let _e1960 = (_e1956 * 0.0000019073486f);
                            let _e1961 = (abs(_e1909) * _e1960);
                            let _e1962 = (abs(_e1919) * _e1960);
                            let _e1963 = (abs(_e1929) * _e1960);
                            let _e1967 = (_e1956 * 0.0000009536743f);
                            let _e1968 = (abs(_e1909) * _e1967);
                            let _e1969 = (abs(_e1919) * _e1967);
                            let _e1970 = (abs(_e1929) * _e1967);
                            let _e1971 = abs(_e298);
                            let _e1972 = abs(_e299);
                            let _e1973 = abs(_e300);
                            if (_e1971 >= _e1972) {
                                if (_e1971 >= _e1973) {
                                    phi_2852_ = false;
                                } else {
                                    phi_2852_ = true;
                                }
                                let _e1977 = phi_2852_;
                                phi_2853_ = _e1977;
                            } else {
                                phi_2853_ = true;
                            }
                            let _e1979 = phi_2853_;
                            if _e1979 {
                                if (_e1972 >= _e1973) {
                                    phi_2861_ = 1u;
                                } else {
                                    phi_2861_ = 2u;
                                }
                                let _e1982 = phi_2861_;
                                phi_2862_ = _e1982;
                            } else {
                                phi_2862_ = 0u;
                            }
                            let _e1984 = phi_2862_;
                            if (_e1984 == 0u) {
                                phi_2874_ = vec3<f32>(_e299, _e300, _e298);
                            } else {
                                if (_e1984 == 1u) {
                                    phi_2873_ = vec3<f32>(_e300, _e298, _e299);
                                } else {
                                    phi_2873_ = _e301;
                                }
                                let _e1990 = phi_2873_;
                                phi_2874_ = _e1990;
                            }
                            let _e1992 = phi_2874_;
                            let _e1995 = (_e1992.x / _e1992.z);
                            let _e1998 = (_e1992.y / _e1992.z);
                            if (_e1909 < 0f) {
                                phi_2887_ = 0u;
                            } else {
                                phi_2887_ = 1u;
                            }
                            let _e2003 = phi_2887_;
                            if (_e1919 < 0f) {
                                phi_2892_ = 0u;
                            } else {
                                phi_2892_ = 2u;
                            }
                            let _e2006 = phi_2892_;
                            if (_e1929 < 0f) {
                                phi_2897_ = 0u;
                            } else {
                                phi_2897_ = 4u;
                            }
                            let _e2009 = phi_2897_;
                            let _e2011 = ((_e2003 | _e2006) | _e2009);
                            let _e2012 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                            local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e2012.first[0], _e2012.first[1], _e2012.first[2], _e2012.first[3], _e2012.first[4], _e2012.first[5], _e2012.first[6], _e2012.first[7], _e2012.first[8], _e2012.first[9], _e2012.first[10], _e2012.first[11], _e2012.first[12], _e2012.first[13], _e2012.first[14], _e2012.first[15], _e2012.first[16], _e2012.first[17], _e2012.first[18], _e2012.first[19], _e2012.first[20], _e2012.first[21], _e2012.first[22], _e2012.first[23], _e2012.first[24], _e2012.first[25], _e2012.first[26], _e2012.first[27], _e2012.first[28], _e2012.first[29], _e2012.first[30], _e2012.first[31]), array<u32, 32>(_e2012.mask[0], _e2012.mask[1], _e2012.mask[2], _e2012.mask[3], _e2012.mask[4], _e2012.mask[5], _e2012.mask[6], _e2012.mask[7], _e2012.mask[8], _e2012.mask[9], _e2012.mask[10], _e2012.mask[11], _e2012.mask[12], _e2012.mask[13], _e2012.mask[14], _e2012.mask[15], _e2012.mask[16], _e2012.mask[17], _e2012.mask[18], _e2012.mask[19], _e2012.mask[20], _e2012.mask[21], _e2012.mask[22], _e2012.mask[23], _e2012.mask[24], _e2012.mask[25], _e2012.mask[26], _e2012.mask[27], _e2012.mask[28], _e2012.mask[29], _e2012.mask[30], _e2012.mask[31]), _e2012.len, _e2012.group, _e2012.group_mask);
                            let _e2086 = local_1.group_mask;
                            if ((_e2086 & 4278190080u) == 0u) {
                                let _e2090 = local_1.len;
                                if (_e2090 == 0u) {
                                    phi_3011_ = false;
                                } else {
                                    let _e2094 = local_1.len;
                                    local_1.len = (_e2094 - 1u);
                                    let _e2097 = local_1.len;
                                    if (_e2097 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2102 = local_1.first[(0u + _e2097)];
                                    local_1.group = _e2102;
                                    let _e2105 = local_1.len;
                                    if (_e2105 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2110 = local_1.mask[(0u + _e2105)];
                                    local_1.group_mask = _e2110;
                                    phi_3011_ = true;
                                }
                                let _e2113 = phi_3011_;
                                phi_3012_ = _e2113;
                            } else {
                                phi_3012_ = true;
                            }
                            let _e2115 = phi_3012_;
                            if _e2115 {
                                let _e2117 = local_1.group_mask;
                                let _e2123 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2117)), 32u, (_e2117 == 0u)));
                                let _e2127 = local_1.group_mask;
                                let _e2141 = local_1.group_mask;
                                local_1.group_mask = (_e2141 & ~((1u << bitcast<u32>((_e2123 & 31u)))));
                                let _e2144 = local_1.group;
                                phi_3043_ = (_e2144 + countOneBits(((_e2127 & ~((4294967295u << bitcast<u32>((((_e2123 - 24u) ^ 7u) & 31u))))) & 255u)));
                            } else {
                                phi_3043_ = 4294967295u;
                            }
                            let _e2147 = phi_3043_;
                            phi_3045_ = _e2147;
                            phi_3048_ = false;
                            loop {
                                let _e2149 = phi_3045_;
                                let _e2151 = phi_3048_;
                                local_21 = _e2151;
                                if (_e2149 != 4294967295u) {
                                    if (_e2149 < _e92) {
                                    } else {
                                        return;
                                    }
                                    let _e2158 = nodes.member[(0u + _e2149)].frame[3u];
                                    let _e2183 = (bitcast<f32>((((_e2158 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1909);
                                    let _e2184 = (bitcast<f32>((((_e2158 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1919);
                                    let _e2185 = (bitcast<f32>((((_e2158 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1929);
                                    let _e2188 = nodes.member[(0u + _e2149)].frame[0u];
                                    let _e2192 = nodes.member[(0u + _e2149)].frame[1u];
                                    let _e2196 = nodes.member[(0u + _e2149)].frame[2u];
                                    let _e2201 = ((bitcast<f32>(_e2188) - _e278) * _e1909);
                                    let _e2202 = ((bitcast<f32>(_e2192) - _e280) * _e1919);
                                    let _e2203 = ((bitcast<f32>(_e2196) - _e282) * _e1929);
                                    let _e2211 = nodes.member[(0u + _e2149)].x;
                                    if (_e1909 < 0f) {
                                        let _e2222 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2211.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2228 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2222.unnamed.word, _e2211.w), _e2222.unnamed_1);
                                        let _e2234 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2228.unnamed, lt_mask_LightPlace(_e2211.x, _e2228.unnamed_1.shift));
                                        phi_3128_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2234.unnamed, lt_mask_LightPlace(_e2234.unnamed_1.word, _e2211.y));
                                    } else {
                                        let _e2250 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2211.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2256 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2250.unnamed.word, _e2211.y), _e2250.unnamed_1);
                                        let _e2262 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2256.unnamed, lt_mask_LightPlace(_e2211.z, _e2256.unnamed_1.shift));
                                        phi_3128_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2262.unnamed, lt_mask_LightPlace(_e2262.unnamed_1.word, _e2211.w));
                                    }
                                    let _e2270 = phi_3128_;
                                    let _e2280 = nodes.member[(0u + _e2149)].y;
                                    if (_e1919 < 0f) {
                                        let _e2291 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2280.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2297 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2291.unnamed.word, _e2280.w), _e2291.unnamed_1);
                                        let _e2303 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2297.unnamed, lt_mask_LightPlace(_e2280.x, _e2297.unnamed_1.shift));
                                        phi_3155_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2303.unnamed, lt_mask_LightPlace(_e2303.unnamed_1.word, _e2280.y));
                                    } else {
                                        let _e2319 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2280.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2325 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2319.unnamed.word, _e2280.y), _e2319.unnamed_1);
                                        let _e2331 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2325.unnamed, lt_mask_LightPlace(_e2280.z, _e2325.unnamed_1.shift));
                                        phi_3155_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2331.unnamed, lt_mask_LightPlace(_e2331.unnamed_1.word, _e2280.w));
                                    }
                                    let _e2339 = phi_3155_;
                                    let _e2349 = nodes.member[(0u + _e2149)].z;
                                    if (_e1929 < 0f) {
                                        let _e2360 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2349.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2366 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2360.unnamed.word, _e2349.w), _e2360.unnamed_1);
                                        let _e2372 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2366.unnamed, lt_mask_LightPlace(_e2349.x, _e2366.unnamed_1.shift));
                                        phi_3182_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2372.unnamed, lt_mask_LightPlace(_e2372.unnamed_1.word, _e2349.y));
                                    } else {
                                        let _e2388 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2349.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2394 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2388.unnamed.word, _e2349.y), _e2388.unnamed_1);
                                        let _e2400 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2394.unnamed, lt_mask_LightPlace(_e2349.z, _e2394.unnamed_1.shift));
                                        phi_3182_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2400.unnamed, lt_mask_LightPlace(_e2400.unnamed_1.word, _e2349.w));
                                    }
                                    let _e2408 = phi_3182_;
                                    phi_3188_ = 0u;
                                    phi_3191_ = 0u;
                                    loop {
                                        let _e2418 = phi_3188_;
                                        let _e2420 = phi_3191_;
                                        local_7 = _e2420;
                                        local_8 = _e2420;
                                        local_9 = _e2420;
                                        let _e2421 = (_e2418 < 8u);
                                        if _e2421 {
                                            let _e2423 = (_e2418 >> bitcast<u32>(2i));
                                            let _e2424 = (_e2418 & 3u);
                                            if (_e2423 == 0u) {
                                                phi_3205_ = _e2270.unnamed.word;
                                            } else {
                                                phi_3205_ = _e2270.unnamed.shift;
                                            }
                                            let _e2427 = phi_3205_;
                                            if (_e2423 == 0u) {
                                                phi_3215_ = _e2339.unnamed.word;
                                            } else {
                                                phi_3215_ = _e2339.unnamed.shift;
                                            }
                                            let _e2436 = phi_3215_;
                                            if (_e2423 == 0u) {
                                                phi_3225_ = _e2408.unnamed.word;
                                            } else {
                                                phi_3225_ = _e2408.unnamed.shift;
                                            }
                                            let _e2445 = phi_3225_;
                                            let _e2458 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e2427 >> bitcast<u32>(((_e2424 * 8u) & 31u))) & 255u)) * _e2183) + (_e2201 - _e1961)), ((f32(((_e2436 >> bitcast<u32>(((_e2424 * 8u) & 31u))) & 255u)) * _e2184) + (_e2202 - _e1962)));
                                            let _e2459 = core_intrinsics_maximum_number_nsz_f32_(_e2458, ((f32(((_e2445 >> bitcast<u32>(((_e2424 * 8u) & 31u))) & 255u)) * _e2185) + (_e2203 - _e1963)));
                                            if (_e2423 == 0u) {
                                                phi_3243_ = _e2270.unnamed_1.word;
                                            } else {
                                                phi_3243_ = _e2270.unnamed_1.shift;
                                            }
                                            let _e2462 = phi_3243_;
                                            if (_e2423 == 0u) {
                                                phi_3253_ = _e2339.unnamed_1.word;
                                            } else {
                                                phi_3253_ = _e2339.unnamed_1.shift;
                                            }
                                            let _e2471 = phi_3253_;
                                            if (_e2423 == 0u) {
                                                phi_3263_ = _e2408.unnamed_1.word;
                                            } else {
                                                phi_3263_ = _e2408.unnamed_1.shift;
                                            }
                                            let _e2480 = phi_3263_;
                                            let _e2493 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e2462 >> bitcast<u32>(((_e2424 * 8u) & 31u))) & 255u)) * _e2183) + (_e2201 + _e1961)), ((f32(((_e2471 >> bitcast<u32>(((_e2424 * 8u) & 31u))) & 255u)) * _e2184) + (_e2202 + _e1962)));
                                            let _e2494 = core_intrinsics_minimum_number_nsz_f32_(_e2493, ((f32(((_e2480 >> bitcast<u32>(((_e2424 * 8u) & 31u))) & 255u)) * _e2185) + (_e2203 + _e1963)));
                                            if (_e2459 <= _e2494) {
                                                if (_e2459 <= _e290) {
                                                    if (_e2494 >= 0f) {
                                                        if (_e2423 == 0u) {
                                                            let _e2501 = nodes.member[(0u + _e2149)].links[2u];
                                                            phi_3299_ = _e2501;
                                                        } else {
                                                            let _e2504 = nodes.member[(0u + _e2149)].links[3u];
                                                            phi_3299_ = _e2504;
                                                        }
                                                        let _e2506 = phi_3299_;
                                                        let _e2511 = ((_e2506 >> bitcast<u32>(((_e2424 * 8u) & 31u))) & 255u);
                                                        let _e2512 = (_e2511 & 31u);
                                                        if (_e2512 >= 24u) {
                                                            phi_3312_ = (24u + ((_e2512 - 24u) ^ _e2011));
                                                        } else {
                                                            phi_3312_ = _e2512;
                                                        }
                                                        let _e2518 = phi_3312_;
                                                        phi_3317_ = (_e2420 | ((_e2511 >> bitcast<u32>(5i)) << bitcast<u32>((_e2518 & 31u))));
                                                    } else {
                                                        phi_3317_ = _e2420;
                                                    }
                                                    let _e2526 = phi_3317_;
                                                    phi_3318_ = _e2526;
                                                } else {
                                                    phi_3318_ = _e2420;
                                                }
                                                let _e2528 = phi_3318_;
                                                phi_3319_ = _e2528;
                                            } else {
                                                phi_3319_ = _e2420;
                                            }
                                            let _e2530 = phi_3319_;
                                            phi_3189_ = (_e2418 + 1u);
                                            phi_3192_ = _e2530;
                                        } else {
                                            phi_3189_ = u32();
                                            phi_3192_ = u32();
                                        }
                                        let _e2533 = phi_3189_;
                                        let _e2535 = phi_3192_;
                                        continue;
                                        continuing {
                                            phi_3188_ = _e2533;
                                            phi_3191_ = _e2535;
                                            break if !(_e2421);
                                        }
                                    }
                                    let _e2539 = nodes.member[(0u + _e2149)].links[0u];
                                    let _e2543 = nodes.member[(0u + _e2149)].frame[3u];
                                    let _e2547 = local_7;
                                    if ((_e2547 & 4278190080u) == 0u) {
                                    } else {
                                        let _e2551 = local_1.group_mask;
                                        if ((_e2551 & 4278190080u) == 0u) {
                                        } else {
                                            let _e2555 = local_1.len;
                                            if (_e2555 < 32u) {
                                                let _e2558 = local_1.group;
                                                let _e2560 = local_1.len;
                                                if (_e2560 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                local_1.first[(0u + _e2560)] = _e2558;
                                                let _e2566 = local_1.group_mask;
                                                let _e2568 = local_1.len;
                                                if (_e2568 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                local_1.mask[(0u + _e2568)] = _e2566;
                                                let _e2575 = local_1.len;
                                                local_1.len = (_e2575 + 1u);
                                            }
                                        }
                                        local_1.group = (0u + _e2539);
                                        let _e2579 = local_8;
                                        local_1.group_mask = ((_e2579 & 4278190080u) | (_e2543 >> bitcast<u32>(24i)));
                                    }
                                    let _e2584 = local_9;
                                    phi_3377_ = (_e2584 & 16777215u);
                                    phi_3380_ = _e2151;
                                    loop {
                                        let _e2587 = phi_3377_;
                                        let _e2589 = phi_3380_;
                                        local_17 = _e2589;
                                        let _e2590 = (_e2587 == 0u);
                                        local_10 = _e2590;
                                        local_19 = _e2590;
                                        if _e2590 {
                                            phi_3378_ = u32();
                                            phi_3381_ = bool();
                                            phi_4184_ = bool();
                                            phi_4185_ = false;
                                        } else {
                                            let _e2593 = nodes.member[(0u + _e2149)].links[1u];
                                            let _e2598 = ((0u + _e2593) + select(firstTrailingBit(_e2587), 32u, (_e2587 == 0u)));
                                            if (_e2598 < _e95) {
                                            } else {
                                                return;
                                            }
                                            let _e2605 = triangles.member[(0u + _e2598)].v0_;
                                            let _e2607 = (_e2605.x - _e278);
                                            let _e2609 = (_e2605.y - _e280);
                                            let _e2611 = (_e2605.z - _e282);
                                            if (_e1984 == 0u) {
                                                phi_3425_ = vec3<f32>(_e2609, _e2611, _e2607);
                                            } else {
                                                if (_e1984 == 1u) {
                                                    phi_3424_ = vec3<f32>(_e2611, _e2607, _e2609);
                                                } else {
                                                    phi_3424_ = (_e2605 - vec3<f32>(_e278, _e280, _e282));
                                                }
                                                let _e2619 = phi_3424_;
                                                phi_3425_ = _e2619;
                                            }
                                            let _e2621 = phi_3425_;
                                            let _e2625 = (_e2621.x - (_e1995 * _e2621.z));
                                            let _e2629 = (_e2621.y - (_e1998 * _e2621.z));
                                            let _e2631 = triangles.member[(0u + _e2598)].v1_;
                                            let _e2633 = (_e2631.x - _e278);
                                            let _e2635 = (_e2631.y - _e280);
                                            let _e2637 = (_e2631.z - _e282);
                                            if (_e1984 == 0u) {
                                                phi_3455_ = vec3<f32>(_e2635, _e2637, _e2633);
                                            } else {
                                                if (_e1984 == 1u) {
                                                    phi_3454_ = vec3<f32>(_e2637, _e2633, _e2635);
                                                } else {
                                                    phi_3454_ = (_e2631 - vec3<f32>(_e278, _e280, _e282));
                                                }
                                                let _e2645 = phi_3454_;
                                                phi_3455_ = _e2645;
                                            }
                                            let _e2647 = phi_3455_;
                                            let _e2651 = (_e2647.x - (_e1995 * _e2647.z));
                                            let _e2655 = (_e2647.y - (_e1998 * _e2647.z));
                                            let _e2657 = triangles.member[(0u + _e2598)].v2_;
                                            let _e2659 = (_e2657.x - _e278);
                                            let _e2661 = (_e2657.y - _e280);
                                            let _e2663 = (_e2657.z - _e282);
                                            if (_e1984 == 0u) {
                                                phi_3485_ = vec3<f32>(_e2661, _e2663, _e2659);
                                            } else {
                                                if (_e1984 == 1u) {
                                                    phi_3484_ = vec3<f32>(_e2663, _e2659, _e2661);
                                                } else {
                                                    phi_3484_ = (_e2657 - vec3<f32>(_e278, _e280, _e282));
                                                }
                                                let _e2671 = phi_3484_;
                                                phi_3485_ = _e2671;
                                            }
                                            let _e2673 = phi_3485_;
                                            let _e2677 = (_e2673.x - (_e1995 * _e2673.z));
                                            let _e2681 = (_e2673.y - (_e1998 * _e2673.z));
                                            if (_e2651 < _e2677) {
                                                phi_3504_ = true;
                                            } else {
                                                if (_e2651 == _e2677) {
                                                    phi_3503_ = (_e2655 < _e2681);
                                                } else {
                                                    phi_3503_ = false;
                                                }
                                                let _e2686 = phi_3503_;
                                                phi_3504_ = _e2686;
                                            }
                                            let _e2688 = phi_3504_;
                                            if _e2688 {
                                                phi_3508_ = _e2681;
                                                phi_3509_ = _e2677;
                                                phi_3510_ = _e2655;
                                                phi_3511_ = _e2651;
                                            } else {
                                                phi_3508_ = _e2655;
                                                phi_3509_ = _e2651;
                                                phi_3510_ = _e2681;
                                                phi_3511_ = _e2677;
                                            }
                                            let _e2690 = phi_3508_;
                                            let _e2692 = phi_3509_;
                                            let _e2694 = phi_3510_;
                                            let _e2696 = phi_3511_;
                                            let _e2699 = ((_e2696 * _e2690) - (_e2694 * _e2692));
                                            if _e2688 {
                                                phi_3519_ = -(_e2699);
                                            } else {
                                                phi_3519_ = _e2699;
                                            }
                                            let _e2702 = phi_3519_;
                                            if (_e2677 < _e2625) {
                                                phi_3530_ = true;
                                            } else {
                                                if (_e2677 == _e2625) {
                                                    phi_3529_ = (_e2681 < _e2629);
                                                } else {
                                                    phi_3529_ = false;
                                                }
                                                let _e2707 = phi_3529_;
                                                phi_3530_ = _e2707;
                                            }
                                            let _e2709 = phi_3530_;
                                            if _e2709 {
                                                phi_3534_ = _e2629;
                                                phi_3535_ = _e2625;
                                                phi_3536_ = _e2681;
                                                phi_3537_ = _e2677;
                                            } else {
                                                phi_3534_ = _e2681;
                                                phi_3535_ = _e2677;
                                                phi_3536_ = _e2629;
                                                phi_3537_ = _e2625;
                                            }
                                            let _e2711 = phi_3534_;
                                            let _e2713 = phi_3535_;
                                            let _e2715 = phi_3536_;
                                            let _e2717 = phi_3537_;
                                            let _e2720 = ((_e2717 * _e2711) - (_e2715 * _e2713));
                                            if _e2709 {
                                                phi_3545_ = -(_e2720);
                                            } else {
                                                phi_3545_ = _e2720;
                                            }
                                            let _e2723 = phi_3545_;
                                            if (_e2625 < _e2651) {
                                                phi_3556_ = true;
                                            } else {
                                                if (_e2625 == _e2651) {
                                                    phi_3555_ = (_e2629 < _e2655);
                                                } else {
                                                    phi_3555_ = false;
                                                }
                                                let _e2728 = phi_3555_;
                                                phi_3556_ = _e2728;
                                            }
                                            let _e2730 = phi_3556_;
                                            if _e2730 {
                                                phi_3560_ = _e2655;
                                                phi_3561_ = _e2651;
                                                phi_3562_ = _e2629;
                                                phi_3563_ = _e2625;
                                            } else {
                                                phi_3560_ = _e2629;
                                                phi_3561_ = _e2625;
                                                phi_3562_ = _e2655;
                                                phi_3563_ = _e2651;
                                            }
                                            let _e2732 = phi_3560_;
                                            let _e2734 = phi_3561_;
                                            let _e2736 = phi_3562_;
                                            let _e2738 = phi_3563_;
                                            let _e2741 = ((_e2738 * _e2732) - (_e2736 * _e2734));
                                            if _e2730 {
                                                phi_3571_ = -(_e2741);
                                            } else {
                                                phi_3571_ = _e2741;
                                            }
                                            let _e2744 = phi_3571_;
                                            if (_e2702 >= 0f) {
                                                if (_e2723 >= 0f) {
                                                    if (_e2744 >= 0f) {
                                                        phi_3586_ = ((_e2702 + _e2723) + _e2744);
                                                        phi_3587_ = false;
                                                    } else {
                                                        phi_3586_ = f32();
                                                        phi_3587_ = true;
                                                    }
                                                    let _e2751 = phi_3586_;
                                                    let _e2753 = phi_3587_;
                                                    phi_3588_ = _e2751;
                                                    phi_3589_ = _e2753;
                                                } else {
                                                    phi_3588_ = f32();
                                                    phi_3589_ = true;
                                                }
                                                let _e2755 = phi_3588_;
                                                let _e2757 = phi_3589_;
                                                phi_3590_ = _e2755;
                                                phi_3591_ = _e2757;
                                            } else {
                                                phi_3590_ = f32();
                                                phi_3591_ = true;
                                            }
                                            let _e2759 = phi_3590_;
                                            let _e2761 = phi_3591_;
                                            if _e2761 {
                                                if (_e2702 <= 0f) {
                                                    if (_e2723 <= 0f) {
                                                        let _e2764 = (_e2744 <= 0f);
                                                        if _e2764 {
                                                        }
                                                        phi_3609_ = ((_e2702 + _e2723) + _e2744);
                                                        phi_3610_ = false;
                                                        phi_3611_ = _e2764;
                                                    } else {
                                                        phi_3609_ = f32();
                                                        phi_3610_ = true;
                                                        phi_3611_ = false;
                                                    }
                                                    let _e2768 = phi_3609_;
                                                    let _e2770 = phi_3610_;
                                                    let _e2772 = phi_3611_;
                                                    phi_3612_ = _e2768;
                                                    phi_3613_ = _e2770;
                                                    phi_3614_ = _e2772;
                                                } else {
                                                    phi_3612_ = f32();
                                                    phi_3613_ = true;
                                                    phi_3614_ = false;
                                                }
                                                let _e2774 = phi_3612_;
                                                let _e2776 = phi_3613_;
                                                let _e2778 = phi_3614_;
                                                if _e2776 {
                                                    phi_3618_ = false;
                                                } else {
                                                    phi_3618_ = _e2778;
                                                }
                                                let _e2780 = phi_3618_;
                                                phi_3619_ = _e2774;
                                                phi_3620_ = _e2780;
                                            } else {
                                                phi_3619_ = _e2759;
                                                phi_3620_ = true;
                                            }
                                            let _e2782 = phi_3619_;
                                            let _e2784 = phi_3620_;
                                            if _e2784 {
                                                let _e2785 = (_e2782 == 0f);
                                                if _e2785 {
                                                    phi_3936_ = lt_bvh_triangle_Intersection();
                                                    phi_3937_ = false;
                                                } else {
                                                    let _e2787 = triangles.member[(0u + _e2598)].v0_;
                                                    let _e2789 = (_e2787.x - _e278);
                                                    let _e2791 = (_e2787.y - _e280);
                                                    let _e2793 = (_e2787.z - _e282);
                                                    if (_e1984 == 0u) {
                                                        phi_3649_ = vec3<f32>(_e2791, _e2793, _e2789);
                                                    } else {
                                                        if (_e1984 == 1u) {
                                                            phi_3648_ = vec3<f32>(_e2793, _e2789, _e2791);
                                                        } else {
                                                            phi_3648_ = (_e2787 - vec3<f32>(_e278, _e280, _e282));
                                                        }
                                                        let _e2801 = phi_3648_;
                                                        phi_3649_ = _e2801;
                                                    }
                                                    let _e2803 = phi_3649_;
                                                    let _e2805 = triangles.member[(0u + _e2598)].v1_;
                                                    let _e2807 = triangles.member[(0u + _e2598)].v0_;
                                                    let _e2810 = (_e2805.x - _e2807.x);
                                                    let _e2813 = (_e2805.y - _e2807.y);
                                                    let _e2816 = (_e2805.z - _e2807.z);
                                                    if (_e1984 == 0u) {
                                                        phi_3675_ = vec3<f32>(_e2813, _e2816, _e2810);
                                                    } else {
                                                        if (_e1984 == 1u) {
                                                            phi_3674_ = vec3<f32>(_e2816, _e2810, _e2813);
                                                        } else {
                                                            phi_3674_ = (_e2805 - _e2807);
                                                        }
                                                        let _e2823 = phi_3674_;
                                                        phi_3675_ = _e2823;
                                                    }
                                                    let _e2825 = phi_3675_;
                                                    let _e2827 = triangles.member[(0u + _e2598)].v2_;
                                                    let _e2829 = triangles.member[(0u + _e2598)].v0_;
                                                    let _e2832 = (_e2827.x - _e2829.x);
                                                    let _e2835 = (_e2827.y - _e2829.y);
                                                    let _e2838 = (_e2827.z - _e2829.z);
                                                    if (_e1984 == 0u) {
                                                        phi_3701_ = vec3<f32>(_e2835, _e2838, _e2832);
                                                    } else {
                                                        if (_e1984 == 1u) {
                                                            phi_3700_ = vec3<f32>(_e2838, _e2832, _e2835);
                                                        } else {
                                                            phi_3700_ = (_e2827 - _e2829);
                                                        }
                                                        let _e2845 = phi_3700_;
                                                        phi_3701_ = _e2845;
                                                    }
                                                    let _e2847 = phi_3701_;
                                                    let _e2854 = ((_e2825.y * _e2847.z) - (_e2825.z * _e2847.y));
                                                    let _e2861 = ((_e2825.z * _e2847.x) - (_e2825.x * _e2847.z));
                                                    let _e2868 = ((_e2825.x * _e2847.y) - (_e2825.y * _e2847.x));
                                                    let _e2882 = (((1f / _e1992.z) * (((_e2854 * _e2803.x) + (_e2861 * _e2803.y)) + (_e2868 * _e2803.z))) / (((_e2854 * _e1995) + (_e2861 * _e1998)) + _e2868));
                                                    if (_e2882 > 0f) {
                                                        if (_e2882 < _e290) {
                                                            let _e2886 = triangles.member[(0u + _e2598)].v0_;
                                                            let _e2888 = triangles.member[(0u + _e2598)].v1_;
                                                            if (_e2886.x < _e2888.x) {
                                                                phi_3757_ = _e2886.x;
                                                            } else {
                                                                phi_3757_ = _e2888.x;
                                                            }
                                                            let _e2895 = phi_3757_;
                                                            if (_e2886.y < _e2888.y) {
                                                                phi_3766_ = _e2886.y;
                                                            } else {
                                                                phi_3766_ = _e2888.y;
                                                            }
                                                            let _e2902 = phi_3766_;
                                                            if (_e2886.z < _e2888.z) {
                                                                phi_3775_ = _e2886.z;
                                                            } else {
                                                                phi_3775_ = _e2888.z;
                                                            }
                                                            let _e2909 = phi_3775_;
                                                            let _e2911 = triangles.member[(0u + _e2598)].v2_;
                                                            if (_e2895 < _e2911.x) {
                                                                phi_3784_ = _e2895;
                                                            } else {
                                                                phi_3784_ = _e2911.x;
                                                            }
                                                            let _e2916 = phi_3784_;
                                                            if (_e2902 < _e2911.y) {
                                                                phi_3791_ = _e2902;
                                                            } else {
                                                                phi_3791_ = _e2911.y;
                                                            }
                                                            let _e2921 = phi_3791_;
                                                            if (_e2909 < _e2911.z) {
                                                                phi_3798_ = _e2909;
                                                            } else {
                                                                phi_3798_ = _e2911.z;
                                                            }
                                                            let _e2926 = phi_3798_;
                                                            let _e2928 = triangles.member[(0u + _e2598)].v0_;
                                                            let _e2930 = triangles.member[(0u + _e2598)].v1_;
                                                            if (_e2928.x > _e2930.x) {
                                                                phi_3811_ = _e2928.x;
                                                            } else {
                                                                phi_3811_ = _e2930.x;
                                                            }
                                                            let _e2937 = phi_3811_;
                                                            if (_e2928.y > _e2930.y) {
                                                                phi_3820_ = _e2928.y;
                                                            } else {
                                                                phi_3820_ = _e2930.y;
                                                            }
                                                            let _e2944 = phi_3820_;
                                                            if (_e2928.z > _e2930.z) {
                                                                phi_3829_ = _e2928.z;
                                                            } else {
                                                                phi_3829_ = _e2930.z;
                                                            }
                                                            let _e2951 = phi_3829_;
                                                            let _e2953 = triangles.member[(0u + _e2598)].v2_;
                                                            if (_e2937 > _e2953.x) {
                                                                phi_3838_ = _e2937;
                                                            } else {
                                                                phi_3838_ = _e2953.x;
                                                            }
                                                            let _e2958 = phi_3838_;
                                                            if (_e2944 > _e2953.y) {
                                                                phi_3845_ = _e2944;
                                                            } else {
                                                                phi_3845_ = _e2953.y;
                                                            }
                                                            let _e2963 = phi_3845_;
                                                            if (_e2951 > _e2953.z) {
                                                                phi_3852_ = _e2951;
                                                            } else {
                                                                phi_3852_ = _e2953.z;
                                                            }
                                                            let _e2968 = phi_3852_;
                                                            let _e2972 = ((_e2916 - _e278) * _e1909);
                                                            let _e2973 = ((_e2921 - _e280) * _e1919);
                                                            let _e2974 = ((_e2926 - _e282) * _e1929);
                                                            let _e2978 = ((_e2958 - _e278) * _e1909);
                                                            let _e2979 = ((_e2963 - _e280) * _e1919);
                                                            let _e2980 = ((_e2968 - _e282) * _e1929);
                                                            if (_e2972 < _e2978) {
                                                                phi_3869_ = _e2972;
                                                            } else {
                                                                phi_3869_ = _e2978;
                                                            }
                                                            let _e2983 = phi_3869_;
                                                            if (_e2973 < _e2979) {
                                                                phi_3874_ = _e2973;
                                                            } else {
                                                                phi_3874_ = _e2979;
                                                            }
                                                            let _e2986 = phi_3874_;
                                                            if (_e2974 < _e2980) {
                                                                phi_3879_ = _e2974;
                                                            } else {
                                                                phi_3879_ = _e2980;
                                                            }
                                                            let _e2989 = phi_3879_;
                                                            if (_e2972 > _e2978) {
                                                                phi_3887_ = _e2972;
                                                            } else {
                                                                phi_3887_ = _e2978;
                                                            }
                                                            let _e2995 = phi_3887_;
                                                            if (_e2973 > _e2979) {
                                                                phi_3892_ = _e2973;
                                                            } else {
                                                                phi_3892_ = _e2979;
                                                            }
                                                            let _e2998 = phi_3892_;
                                                            if (_e2974 > _e2980) {
                                                                phi_3897_ = _e2974;
                                                            } else {
                                                                phi_3897_ = _e2980;
                                                            }
                                                            let _e3001 = phi_3897_;
                                                            let _e3005 = core_intrinsics_maximum_number_nsz_f32_((_e2983 - _e1968), (_e2986 - _e1969));
                                                            let _e3006 = core_intrinsics_maximum_number_nsz_f32_(_e3005, (_e2989 - _e1970));
                                                            let _e3007 = core_intrinsics_minimum_number_nsz_f32_((_e2995 + _e1968), (_e2998 + _e1969));
                                                            let _e3008 = core_intrinsics_minimum_number_nsz_f32_(_e3007, (_e3001 + _e1970));
                                                            if (_e3006 > -300000000000000000000000000000000000000f) {
                                                                phi_3909_ = _e3006;
                                                            } else {
                                                                phi_3909_ = -300000000000000000000000000000000000000f;
                                                            }
                                                            let _e3011 = phi_3909_;
                                                            if (_e3008 < 300000000000000000000000000000000000000f) {
                                                                phi_3914_ = _e3008;
                                                            } else {
                                                                phi_3914_ = 300000000000000000000000000000000000000f;
                                                            }
                                                            let _e3014 = phi_3914_;
                                                            if (_e2882 < _e3011) {
                                                                phi_3919_ = _e3011;
                                                            } else {
                                                                phi_3919_ = _e2882;
                                                            }
                                                            let _e3017 = phi_3919_;
                                                            if (_e3017 > _e3014) {
                                                                phi_3924_ = _e3014;
                                                            } else {
                                                                phi_3924_ = _e3017;
                                                            }
                                                            let _e3020 = phi_3924_;
                                                            phi_3929_ = lt_bvh_triangle_Intersection(_e3020, (_e2723 / _e2782), (_e2744 / _e2782), (_e3011 <= _e3014));
                                                            phi_3930_ = false;
                                                        } else {
                                                            phi_3929_ = lt_bvh_triangle_Intersection();
                                                            phi_3930_ = true;
                                                        }
                                                        let _e3026 = phi_3929_;
                                                        let _e3028 = phi_3930_;
                                                        phi_3931_ = _e3026;
                                                        phi_3932_ = _e3028;
                                                    } else {
                                                        phi_3931_ = lt_bvh_triangle_Intersection();
                                                        phi_3932_ = true;
                                                    }
                                                    let _e3030 = phi_3931_;
                                                    let _e3032 = phi_3932_;
                                                    if _e3032 {
                                                    }
                                                    phi_3936_ = _e3030;
                                                    phi_3937_ = _e3032;
                                                }
                                                let _e3034 = phi_3936_;
                                                let _e3036 = phi_3937_;
                                                phi_3938_ = _e3034;
                                                phi_3939_ = _e2785;
                                                phi_3940_ = _e3036;
                                            } else {
                                                phi_3938_ = lt_bvh_triangle_Intersection();
                                                phi_3939_ = true;
                                                phi_3940_ = false;
                                            }
                                            let _e3038 = phi_3938_;
                                            let _e3040 = phi_3939_;
                                            let _e3042 = phi_3940_;
                                            if _e3040 {
                                                phi_3944_ = true;
                                            } else {
                                                phi_3944_ = _e3042;
                                            }
                                            let _e3044 = phi_3944_;
                                            if _e3044 {
                                                phi_3948_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                            } else {
                                                phi_3948_ = _e3038;
                                            }
                                            let _e3046 = phi_3948_;
                                            if _e3046.is_hit {
                                                if (_e3046.t > 0f) {
                                                    if (_e3046.t < _e290) {
                                                        let _e3053 = triangles.member[(0u + _e2598)].i0_;
                                                        if ((_e3053 & 2147483648u) == 0u) {
                                                            phi_4167_ = true;
                                                        } else {
                                                            if (_e2598 < _e95) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e3062 = triangles.member[(0u + _e2598)].i0_;
                                                            let _e3063 = (_e3062 & 2147483647u);
                                                            let _e3065 = triangles.member[(0u + _e2598)].i1_;
                                                            let _e3067 = triangles.member[(0u + _e2598)].i2_;
                                                            if (_e3063 < _e105) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e3071 = vertices.member[(0u + _e3063)];
                                                            if (_e3065 < _e105) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e3075 = vertices.member[(0u + _e3065)];
                                                            if (_e3067 < _e105) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e3079 = vertices.member[(0u + _e3067)];
                                                            let _e3080 = array<abi_Vertex, 3>(_e3071, _e3075, _e3079);
                                                            if (_e3080[0].material < _e108) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e3086 = materials.member[(0u + _e3080[0].material)];
                                                            if ((_e3086.flags & 1u) == 1u) {
                                                                let _e3091 = ((1f - _e3046.u) - _e3046.v);
                                                                if (_e3086.cutoff <= 0f) {
                                                                    phi_4165_ = true;
                                                                } else {
                                                                    let _e3118 = (_e3086.base_color.w * ((((f32((_e3080[0].color >> bitcast<u32>(24i))) * _e3091) + (f32((_e3080[1].color >> bitcast<u32>(24i))) * _e3046.u)) + (f32((_e3080[2].color >> bitcast<u32>(24i))) * _e3046.v)) * (1f / 255f)));
                                                                    if (_e3086.alpha_size == 0u) {
                                                                        phi_4162_ = _e3118;
                                                                    } else {
                                                                        local.offset = _e3086.alpha_offset;
                                                                        local.size = _e3086.alpha_size;
                                                                        local.flags = _e3086.flags;
                                                                        let _e3149 = _lt_shaders_texture_TextureView_quad((&local), (((_e3080[0].u * _e3091) + (_e3080[1].u * _e3046.u)) + (_e3080[2].u * _e3046.v)), (((_e3080[0].v * _e3091) + (_e3080[1].v * _e3046.u)) + (_e3080[2].v * _e3046.v)));
                                                                        let _e3153 = (_e3149.indices[0] >> bitcast<u32>(2i));
                                                                        if (_e3153 < _e111) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e3157 = alpha_texels.member[(0u + _e3153)];
                                                                        let _e3173 = (_e3149.indices[1] >> bitcast<u32>(2i));
                                                                        if (_e3173 < _e111) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e3177 = alpha_texels.member[(0u + _e3173)];
                                                                        let _e3194 = (_e3149.indices[2] >> bitcast<u32>(2i));
                                                                        if (_e3194 < _e111) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e3198 = alpha_texels.member[(0u + _e3194)];
                                                                        let _e3215 = (_e3149.indices[3] >> bitcast<u32>(2i));
                                                                        if (_e3215 < _e111) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e3219 = alpha_texels.member[(0u + _e3215)];
                                                                        phi_4162_ = (_e3118 * (((((f32(((_e3157 >> bitcast<u32>((((_e3149.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3149.weights.x) + ((f32(((_e3177 >> bitcast<u32>((((_e3149.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3149.weights.y)) + ((f32(((_e3198 >> bitcast<u32>((((_e3149.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3149.weights.z)) + ((f32(((_e3219 >> bitcast<u32>((((_e3149.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3149.weights.w)));
                                                                    }
                                                                    let _e3235 = phi_4162_;
                                                                    phi_4165_ = (_e3235 >= _e3086.cutoff);
                                                                }
                                                                let _e3239 = phi_4165_;
                                                                phi_4166_ = _e3239;
                                                            } else {
                                                                phi_4166_ = false;
                                                            }
                                                            let _e3241 = phi_4166_;
                                                            phi_4167_ = _e3241;
                                                        }
                                                        let _e3243 = phi_4167_;
                                                        if _e3243 {
                                                            phi_4171_ = false;
                                                        } else {
                                                            phi_4171_ = true;
                                                        }
                                                        let _e3245 = phi_4171_;
                                                        phi_4172_ = _e3243;
                                                        phi_4173_ = _e3243;
                                                        phi_4174_ = _e3245;
                                                    } else {
                                                        phi_4172_ = bool();
                                                        phi_4173_ = _e2589;
                                                        phi_4174_ = true;
                                                    }
                                                    let _e3247 = phi_4172_;
                                                    let _e3249 = phi_4173_;
                                                    let _e3251 = phi_4174_;
                                                    phi_4175_ = _e3247;
                                                    phi_4176_ = _e3249;
                                                    phi_4177_ = _e3251;
                                                } else {
                                                    phi_4175_ = bool();
                                                    phi_4176_ = _e2589;
                                                    phi_4177_ = true;
                                                }
                                                let _e3253 = phi_4175_;
                                                let _e3255 = phi_4176_;
                                                let _e3257 = phi_4177_;
                                                phi_4178_ = _e3253;
                                                phi_4179_ = _e3255;
                                                phi_4180_ = _e3257;
                                            } else {
                                                phi_4178_ = bool();
                                                phi_4179_ = _e2589;
                                                phi_4180_ = true;
                                            }
                                            let _e3259 = phi_4178_;
                                            let _e3261 = phi_4179_;
                                            let _e3263 = phi_4180_;
                                            if _e3263 {
                                            }
                                            phi_3378_ = (_e2587 & (_e2587 - 1u));
                                            phi_3381_ = _e3261;
                                            phi_4184_ = _e3259;
                                            phi_4185_ = _e3263;
                                        }
                                        let _e3265 = phi_3378_;
                                        let _e3267 = phi_3381_;
                                        let _e3269 = phi_4184_;
                                        let _e3271 = phi_4185_;
                                        local_18 = _e3269;
                                        continue;
                                        continuing {
                                            phi_3377_ = _e3265;
                                            phi_3380_ = _e3267;
                                            break if !(_e3271);
                                        }
                                    }
                                    let _e3274 = local_10;
                                    if _e3274 {
                                        let _e3276 = local_1.group_mask;
                                        if ((_e3276 & 4278190080u) == 0u) {
                                            let _e3280 = local_1.len;
                                            if (_e3280 == 0u) {
                                                phi_4227_ = false;
                                            } else {
                                                let _e3284 = local_1.len;
                                                local_1.len = (_e3284 - 1u);
                                                let _e3287 = local_1.len;
                                                if (_e3287 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3292 = local_1.first[(0u + _e3287)];
                                                local_1.group = _e3292;
                                                let _e3295 = local_1.len;
                                                if (_e3295 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3300 = local_1.mask[(0u + _e3295)];
                                                local_1.group_mask = _e3300;
                                                phi_4227_ = true;
                                            }
                                            let _e3303 = phi_4227_;
                                            phi_4228_ = _e3303;
                                        } else {
                                            phi_4228_ = true;
                                        }
                                        let _e3305 = phi_4228_;
                                        if _e3305 {
                                            let _e3307 = local_1.group_mask;
                                            let _e3313 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e3307)), 32u, (_e3307 == 0u)));
                                            let _e3317 = local_1.group_mask;
                                            let _e3331 = local_1.group_mask;
                                            local_1.group_mask = (_e3331 & ~((1u << bitcast<u32>((_e3313 & 31u)))));
                                            let _e3334 = local_1.group;
                                            phi_4259_ = (_e3334 + countOneBits(((_e3317 & ~((4294967295u << bitcast<u32>((((_e3313 - 24u) ^ _e2011) & 31u))))) & 255u)));
                                        } else {
                                            phi_4259_ = 4294967295u;
                                        }
                                        let _e3337 = phi_4259_;
                                        phi_4260_ = _e3337;
                                    } else {
                                        phi_4260_ = u32();
                                    }
                                    let _e3339 = phi_4260_;
                                    phi_3046_ = _e3339;
                                    let _e3796 = local_17;
                                    phi_3049_ = _e3796;
                                    let _e3799 = local_18;
                                    phi_4261_ = _e3799;
                                    let _e3802 = local_19;
                                    phi_4262_ = _e3802;
                                    phi_4263_ = false;
                                } else {
                                    phi_3046_ = u32();
                                    phi_3049_ = bool();
                                    phi_4261_ = bool();
                                    phi_4262_ = false;
                                    phi_4263_ = true;
                                }
                                let _e3341 = phi_3046_;
                                let _e3343 = phi_3049_;
                                let _e3345 = phi_4261_;
                                let _e3347 = phi_4262_;
                                let _e3349 = phi_4263_;
                                local_11 = _e3349;
                                local_20 = _e3345;
                                continue;
                                continuing {
                                    phi_3045_ = _e3341;
                                    phi_3048_ = _e3343;
                                    break if !(_e3347);
                                }
                            }
                            let _e3352 = local_11;
                            if _e3352 {
                                phi_4267_ = false;
                            } else {
                                phi_4267_ = true;
                            }
                            let _e3354 = phi_4267_;
                            if _e3354 {
                                let _e3808 = local_20;
                                phi_4271_ = _e3808;
                            } else {
                                let _e3810 = local_21;
                                phi_4271_ = _e3810;
                            }
                            let _e3356 = phi_4271_;
                            phi_4272_ = _e3356;
                        }
                        let _e3358 = phi_4272_;
                        phi_4273_ = _e3358;
                        phi_4274_ = _e1833;
                    } else {
                        phi_4273_ = bool();
                        phi_4274_ = true;
                    }
                    let _e3360 = phi_4273_;
                    let _e3362 = phi_4274_;
                    if _e3362 {
                        phi_4278_ = false;
                    } else {
                        phi_4278_ = _e3360;
                    }
                    let _e3364 = phi_4278_;
                    phi_4279_ = _e3364;
                }
                let _e3366 = phi_4279_;
                phi_4280_ = _e3366;
            } else {
                phi_4280_ = false;
            }
            let _e3368 = phi_4280_;
            if _e3368 {
                phi_4284_ = 0f;
            } else {
                phi_4284_ = 1f;
            }
            let _e3370 = phi_4284_;
            phi_4285_ = _e3370;
        }
        let _e3372 = phi_4285_;
        if (_e117.shift < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e117.shift)] = _e3372;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_light_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
