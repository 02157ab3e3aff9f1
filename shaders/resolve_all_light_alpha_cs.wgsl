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
    var phi_1397_: u32;
    var phi_1400_: u32;
    var phi_1402_: u32;
    var phi_1404_: u32;
    var phi_1477_: f32;
    var phi_1478_: f32;
    var phi_1492_: u32;
    var phi_1515_: f32;
    var phi_1516_: f32;
    var phi_1530_: u32;
    var phi_1553_: f32;
    var phi_1554_: f32;
    var phi_1568_: u32;
    var phi_1715_: u32;
    var phi_1716_: u32;
    var phi_1720_: u32;
    var phi_1721_: u32;
    var phi_1722_: u32;
    var phi_1723_: u32;
    var phi_1724_: u32;
    var phi_1725_: u32;
    var phi_1743_: u32;
    var phi_1744_: u32;
    var phi_1745_: u32;
    var phi_1746_: u32;
    var phi_1747_: u32;
    var phi_1748_: u32;
    var phi_1749_: u32;
    var phi_1750_: u32;
    var phi_1398_: u32;
    var phi_1401_: u32;
    var phi_1403_: u32;
    var phi_1405_: u32;
    var phi_1751_: bool;
    var local_5: bool;
    var phi_1756_: u32;
    var local_6: u32;
    var phi_1795_: u32;
    var phi_1796_: u32;
    var phi_1802_: u32;
    var phi_1831_: vec3<f32>;
    var phi_1832_: vec3<f32>;
    var phi_1861_: vec3<f32>;
    var phi_1862_: vec3<f32>;
    var phi_1891_: vec3<f32>;
    var phi_1892_: vec3<f32>;
    var phi_1910_: bool;
    var phi_1911_: bool;
    var phi_1915_: f32;
    var phi_1916_: f32;
    var phi_1917_: f32;
    var phi_1918_: f32;
    var phi_1926_: f32;
    var phi_1936_: bool;
    var phi_1937_: bool;
    var phi_1941_: f32;
    var phi_1942_: f32;
    var phi_1943_: f32;
    var phi_1944_: f32;
    var phi_1952_: f32;
    var phi_1962_: bool;
    var phi_1963_: bool;
    var phi_1967_: f32;
    var phi_1968_: f32;
    var phi_1969_: f32;
    var phi_1970_: f32;
    var phi_1978_: f32;
    var phi_1993_: f32;
    var phi_1994_: bool;
    var phi_1995_: f32;
    var phi_1996_: bool;
    var phi_1997_: f32;
    var phi_1998_: bool;
    var phi_2016_: f32;
    var phi_2017_: bool;
    var phi_2018_: bool;
    var phi_2019_: f32;
    var phi_2020_: bool;
    var phi_2021_: bool;
    var phi_2025_: bool;
    var phi_2026_: f32;
    var phi_2027_: bool;
    var phi_2055_: vec3<f32>;
    var phi_2056_: vec3<f32>;
    var phi_2081_: vec3<f32>;
    var phi_2082_: vec3<f32>;
    var phi_2107_: vec3<f32>;
    var phi_2108_: vec3<f32>;
    var phi_2164_: f32;
    var phi_2173_: f32;
    var phi_2182_: f32;
    var phi_2191_: f32;
    var phi_2198_: f32;
    var phi_2205_: f32;
    var phi_2218_: f32;
    var phi_2227_: f32;
    var phi_2236_: f32;
    var phi_2245_: f32;
    var phi_2252_: f32;
    var phi_2259_: f32;
    var phi_2276_: f32;
    var phi_2281_: f32;
    var phi_2286_: f32;
    var phi_2294_: f32;
    var phi_2299_: f32;
    var phi_2304_: f32;
    var phi_2316_: f32;
    var phi_2321_: f32;
    var phi_2326_: f32;
    var phi_2331_: f32;
    var phi_2336_: lt_bvh_triangle_Intersection;
    var phi_2337_: bool;
    var phi_2338_: lt_bvh_triangle_Intersection;
    var phi_2339_: bool;
    var phi_2343_: lt_bvh_triangle_Intersection;
    var phi_2344_: bool;
    var phi_2345_: lt_bvh_triangle_Intersection;
    var phi_2346_: bool;
    var phi_2347_: bool;
    var phi_2351_: bool;
    var phi_2355_: lt_bvh_triangle_Intersection;
    var phi_2569_: f32;
    var phi_2572_: bool;
    var phi_2573_: bool;
    var phi_2577_: bool;
    var phi_2578_: bool;
    var phi_2579_: bool;
    var phi_2580_: bool;
    var phi_2581_: bool;
    var phi_2582_: bool;
    var phi_2583_: bool;
    var phi_2584_: bool;
    var phi_2585_: bool;
    var phi_2586_: bool;
    var phi_2587_: bool;
    var phi_2588_: bool;
    var phi_2589_: bool;
    var phi_2590_: bool;
    var phi_2594_: bool;
    var phi_2595_: bool;
    var phi_2596_: bool;
    var phi_2600_: bool;
    var phi_2601_: bool;
    var phi_1757_: u32;
    var phi_2602_: bool;
    var phi_2603_: bool;
    var phi_2604_: bool;
    var local_7: bool;
    var phi_2608_: bool;
    var phi_2609_: bool;
    var phi_1386_: u32;
    var phi_1389_: u32;
    var phi_2610_: bool;
    var phi_2611_: bool;
    var phi_2612_: bool;
    var local_8: bool;
    var phi_2616_: bool;
    var phi_2617_: bool;
    var phi_2621_: bool;
    var phi_2625_: bool;
    var phi_2629_: bool;
    var phi_2630_: bool;
    var phi_2634_: bool;
    var phi_2650_: bool;
    var phi_2651_: bool;
    var phi_2652_: bool;
    var phi_2653_: bool;
    var phi_2657_: bool;
    var phi_2670_: bool;
    var phi_2671_: bool;
    var phi_2672_: bool;
    var phi_2673_: bool;
    var phi_2677_: bool;
    var phi_2690_: bool;
    var phi_2691_: bool;
    var phi_2692_: bool;
    var phi_2696_: bool;
    var phi_2697_: bool;
    var phi_2698_: bool;
    var phi_2699_: bool;
    var phi_2700_: bool;
    var phi_2704_: bool;
    var phi_2774_: f32;
    var phi_2781_: f32;
    var phi_2788_: f32;
    var phi_2795_: f32;
    var phi_2802_: f32;
    var phi_2809_: f32;
    var phi_2826_: f32;
    var phi_2831_: f32;
    var phi_2836_: f32;
    var phi_2841_: f32;
    var phi_2846_: f32;
    var phi_2872_: bool;
    var phi_2873_: bool;
    var phi_2881_: u32;
    var phi_2882_: u32;
    var phi_2893_: vec3<f32>;
    var phi_2894_: vec3<f32>;
    var phi_2907_: u32;
    var phi_2912_: u32;
    var phi_2917_: u32;
    var phi_3031_: bool;
    var phi_3032_: bool;
    var phi_3063_: u32;
    var phi_3065_: u32;
    var phi_3068_: bool;
    var phi_3148_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_3175_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_3202_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_3208_: u32;
    var phi_3211_: u32;
    var phi_3225_: u32;
    var phi_3235_: u32;
    var phi_3245_: u32;
    var phi_3263_: u32;
    var phi_3273_: u32;
    var phi_3283_: u32;
    var phi_3319_: u32;
    var phi_3332_: u32;
    var phi_3337_: u32;
    var phi_3338_: u32;
    var phi_3339_: u32;
    var phi_3209_: u32;
    var phi_3212_: u32;
    var local_9: u32;
    var local_10: u32;
    var local_11: u32;
    var phi_3397_: u32;
    var phi_3400_: bool;
    var phi_3444_: vec3<f32>;
    var phi_3445_: vec3<f32>;
    var phi_3474_: vec3<f32>;
    var phi_3475_: vec3<f32>;
    var phi_3504_: vec3<f32>;
    var phi_3505_: vec3<f32>;
    var phi_3523_: bool;
    var phi_3524_: bool;
    var phi_3528_: f32;
    var phi_3529_: f32;
    var phi_3530_: f32;
    var phi_3531_: f32;
    var phi_3539_: f32;
    var phi_3549_: bool;
    var phi_3550_: bool;
    var phi_3554_: f32;
    var phi_3555_: f32;
    var phi_3556_: f32;
    var phi_3557_: f32;
    var phi_3565_: f32;
    var phi_3575_: bool;
    var phi_3576_: bool;
    var phi_3580_: f32;
    var phi_3581_: f32;
    var phi_3582_: f32;
    var phi_3583_: f32;
    var phi_3591_: f32;
    var phi_3606_: f32;
    var phi_3607_: bool;
    var phi_3608_: f32;
    var phi_3609_: bool;
    var phi_3610_: f32;
    var phi_3611_: bool;
    var phi_3629_: f32;
    var phi_3630_: bool;
    var phi_3631_: bool;
    var phi_3632_: f32;
    var phi_3633_: bool;
    var phi_3634_: bool;
    var phi_3638_: bool;
    var phi_3639_: f32;
    var phi_3640_: bool;
    var phi_3668_: vec3<f32>;
    var phi_3669_: vec3<f32>;
    var phi_3694_: vec3<f32>;
    var phi_3695_: vec3<f32>;
    var phi_3720_: vec3<f32>;
    var phi_3721_: vec3<f32>;
    var phi_3777_: f32;
    var phi_3786_: f32;
    var phi_3795_: f32;
    var phi_3804_: f32;
    var phi_3811_: f32;
    var phi_3818_: f32;
    var phi_3831_: f32;
    var phi_3840_: f32;
    var phi_3849_: f32;
    var phi_3858_: f32;
    var phi_3865_: f32;
    var phi_3872_: f32;
    var phi_3889_: f32;
    var phi_3894_: f32;
    var phi_3899_: f32;
    var phi_3907_: f32;
    var phi_3912_: f32;
    var phi_3917_: f32;
    var phi_3929_: f32;
    var phi_3934_: f32;
    var phi_3939_: f32;
    var phi_3944_: f32;
    var phi_3949_: lt_bvh_triangle_Intersection;
    var phi_3950_: bool;
    var phi_3951_: lt_bvh_triangle_Intersection;
    var phi_3952_: bool;
    var phi_3956_: lt_bvh_triangle_Intersection;
    var phi_3957_: bool;
    var phi_3958_: lt_bvh_triangle_Intersection;
    var phi_3959_: bool;
    var phi_3960_: bool;
    var phi_3964_: bool;
    var phi_3968_: lt_bvh_triangle_Intersection;
    var phi_4182_: f32;
    var phi_4185_: bool;
    var phi_4186_: bool;
    var phi_4187_: bool;
    var phi_4191_: bool;
    var phi_4192_: bool;
    var phi_4193_: bool;
    var phi_4194_: bool;
    var phi_4195_: bool;
    var phi_4196_: bool;
    var phi_4197_: bool;
    var phi_4198_: bool;
    var phi_4199_: bool;
    var phi_4200_: bool;
    var phi_3398_: u32;
    var phi_3401_: bool;
    var phi_4204_: bool;
    var phi_4205_: bool;
    var local_12: bool;
    var phi_4247_: bool;
    var phi_4248_: bool;
    var phi_4279_: u32;
    var phi_4280_: u32;
    var phi_3066_: u32;
    var phi_3069_: bool;
    var phi_4281_: bool;
    var phi_4282_: bool;
    var phi_4283_: bool;
    var local_13: bool;
    var phi_4287_: bool;
    var phi_4291_: bool;
    var phi_4292_: bool;
    var phi_4293_: bool;
    var phi_4294_: bool;
    var phi_4298_: bool;
    var phi_4299_: bool;
    var phi_4300_: bool;
    var phi_4304_: f32;
    var phi_4305_: f32;
    var local_14: u32;
    var local_15: bool;
    var local_16: bool;
    var local_17: u32;
    var local_18: u32;
    var local_19: bool;
    var local_20: bool;
    var local_21: bool;
    var local_22: bool;
    var local_23: bool;
    var local_24: bool;
    var local_25: bool;
    var local_26: bool;

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
            phi_4305_ = _e257.unnamed.visibility;
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
                        phi_2629_ = false;
                        phi_2630_ = true;
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
                            local_8 = _e691;
                            if _e691 {
                                phi_1386_ = u32();
                                phi_1389_ = u32();
                                phi_2610_ = false;
                                phi_2611_ = false;
                                phi_2612_ = false;
                            } else {
                                phi_1397_ = _e688;
                                phi_1400_ = 0u;
                                phi_1402_ = 0u;
                                phi_1404_ = _e690;
                                loop {
                                    let _e693 = phi_1397_;
                                    let _e695 = phi_1400_;
                                    let _e697 = phi_1402_;
                                    let _e699 = phi_1404_;
                                    local_14 = _e697;
                                    local_6 = _e695;
                                    local_17 = _e693;
                                    local_18 = _e699;
                                    let _e700 = (_e693 == 0u);
                                    local_5 = _e700;
                                    if _e700 {
                                        phi_1398_ = u32();
                                        phi_1401_ = u32();
                                        phi_1403_ = u32();
                                        phi_1405_ = u32();
                                        phi_1751_ = false;
                                    } else {
                                        let _e701 = (_e697 == 0u);
                                        if _e701 {
                                            let _e708 = (((_e693 >> bitcast<u32>(8i)) + select(firstTrailingBit(_e693), 32u, (_e693 == 0u))) * 4u);
                                            if (_e708 < _e101) {
                                            } else {
                                                return;
                                            }
                                            let _e712 = rows.member[(0u + _e708)];
                                            let _e713 = (_e708 + 1u);
                                            if (_e713 < _e101) {
                                            } else {
                                                return;
                                            }
                                            let _e717 = rows.member[(0u + _e713)];
                                            let _e718 = (_e708 + 2u);
                                            if (_e718 < _e101) {
                                            } else {
                                                return;
                                            }
                                            let _e722 = rows.member[(0u + _e718)];
                                            let _e723 = (_e708 + 3u);
                                            if (_e723 < _e101) {
                                            } else {
                                                return;
                                            }
                                            let _e727 = rows.member[(0u + _e723)];
                                            let _e728 = lt_bvh_LightNode(_e712, _e717, _e722, _e727);
                                            let _e730 = (_e693 & (_e693 - 1u));
                                            let _e742 = (_e518.unnamed.positive_exponent - bitcast<f32>(_e728.frame.x));
                                            let _e745 = bitcast<f32>((((_e728.frame.w >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                            if (_e742 > 0f) {
                                                if (_e742 < (255f * _e745)) {
                                                    phi_1477_ = (_e742 / _e745);
                                                } else {
                                                    phi_1477_ = 255f;
                                                }
                                                let _e751 = phi_1477_;
                                                phi_1478_ = _e751;
                                            } else {
                                                phi_1478_ = 0f;
                                            }
                                            let _e753 = phi_1478_;
                                            let _e760 = select(select(u32(_e753), 0u, (_e753 < bitcast<f32>(0u))), 4294967295u, (_e753 > bitcast<f32>(1333788671u)));
                                            if (f32(_e760) < _e753) {
                                                phi_1492_ = (_e760 + 1u);
                                            } else {
                                                phi_1492_ = _e760;
                                            }
                                            let _e765 = phi_1492_;
                                            let _e766 = (_e760 * 16843009u);
                                            let _e767 = (_e765 * 16843009u);
                                            let _e777 = (_e518.unnamed.negative_exponent - bitcast<f32>(_e728.frame.y));
                                            let _e780 = bitcast<f32>((((_e728.frame.w >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                            if (_e777 > 0f) {
                                                if (_e777 < (255f * _e780)) {
                                                    phi_1515_ = (_e777 / _e780);
                                                } else {
                                                    phi_1515_ = 255f;
                                                }
                                                let _e786 = phi_1515_;
                                                phi_1516_ = _e786;
                                            } else {
                                                phi_1516_ = 0f;
                                            }
                                            let _e788 = phi_1516_;
                                            let _e795 = select(select(u32(_e788), 0u, (_e788 < bitcast<f32>(0u))), 4294967295u, (_e788 > bitcast<f32>(1333788671u)));
                                            if (f32(_e795) < _e788) {
                                                phi_1530_ = (_e795 + 1u);
                                            } else {
                                                phi_1530_ = _e795;
                                            }
                                            let _e800 = phi_1530_;
                                            let _e801 = (_e795 * 16843009u);
                                            let _e802 = (_e800 * 16843009u);
                                            let _e812 = (_e518.unnamed.min_variance - bitcast<f32>(_e728.frame.z));
                                            let _e815 = bitcast<f32>((((_e728.frame.w >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                            if (_e812 > 0f) {
                                                if (_e812 < (255f * _e815)) {
                                                    phi_1553_ = (_e812 / _e815);
                                                } else {
                                                    phi_1553_ = 255f;
                                                }
                                                let _e821 = phi_1553_;
                                                phi_1554_ = _e821;
                                            } else {
                                                phi_1554_ = 0f;
                                            }
                                            let _e823 = phi_1554_;
                                            let _e830 = select(select(u32(_e823), 0u, (_e823 < bitcast<f32>(0u))), 4294967295u, (_e823 > bitcast<f32>(1333788671u)));
                                            if (f32(_e830) < _e823) {
                                                phi_1568_ = (_e830 + 1u);
                                            } else {
                                                phi_1568_ = _e830;
                                            }
                                            let _e835 = phi_1568_;
                                            let _e836 = (_e835 * 16843009u);
                                            let _e969 = (((((((((((_e766 & ~(_e728.x.x)) | (~((_e728.x.x ^ _e766)) & ((_e766 | 2155905152u) - (_e728.x.x & 2139062143u)))) & ((_e728.x.z & ~(_e767)) | (~((_e767 ^ _e728.x.z)) & ((_e728.x.z | 2155905152u) - (_e767 & 2139062143u))))) & ((_e801 & ~(_e728.y.x)) | (~((_e728.y.x ^ _e801)) & ((_e801 | 2155905152u) - (_e728.y.x & 2139062143u))))) & ((_e728.y.z & ~(_e802)) | (~((_e802 ^ _e728.y.z)) & ((_e728.y.z | 2155905152u) - (_e802 & 2139062143u))))) & ((_e728.rest.x & ~(_e836)) | (~((_e836 ^ _e728.rest.x)) & ((_e728.rest.x | 2155905152u) - (_e836 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) | (((((((((((_e766 & ~(_e728.x.y)) | (~((_e728.x.y ^ _e766)) & ((_e766 | 2155905152u) - (_e728.x.y & 2139062143u)))) & ((_e728.x.w & ~(_e767)) | (~((_e767 ^ _e728.x.w)) & ((_e728.x.w | 2155905152u) - (_e767 & 2139062143u))))) & ((_e801 & ~(_e728.y.y)) | (~((_e728.y.y ^ _e801)) & ((_e801 | 2155905152u) - (_e728.y.y & 2139062143u))))) & ((_e728.y.w & ~(_e802)) | (~((_e802 ^ _e728.y.w)) & ((_e728.y.w | 2155905152u) - (_e802 & 2139062143u))))) & ((_e728.rest.y & ~(_e836)) | (~((_e836 ^ _e728.rest.y)) & ((_e728.rest.y | 2155905152u) - (_e836 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) << bitcast<u32>(4i)));
                                            if ((_e728.frame.w & 16777216u) != 0u) {
                                                phi_1722_ = _e730;
                                                phi_1723_ = _e728.rest.z;
                                                phi_1724_ = _e969;
                                                phi_1725_ = _e699;
                                            } else {
                                                if (_e969 == 0u) {
                                                    phi_1720_ = _e730;
                                                    phi_1721_ = _e699;
                                                } else {
                                                    if ((_e730 & 255u) == 0u) {
                                                        phi_1716_ = _e699;
                                                    } else {
                                                        if (_e699 < 32u) {
                                                            if (_e699 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            local_3[(0u + _e699)] = _e730;
                                                            phi_1715_ = (_e699 + 1u);
                                                        } else {
                                                            phi_1715_ = _e699;
                                                        }
                                                        let _e985 = phi_1715_;
                                                        phi_1716_ = _e985;
                                                    }
                                                    let _e987 = phi_1716_;
                                                    phi_1720_ = ((_e728.rest.z << bitcast<u32>(8i)) | _e969);
                                                    phi_1721_ = _e987;
                                                }
                                                let _e994 = phi_1720_;
                                                let _e996 = phi_1721_;
                                                phi_1722_ = _e994;
                                                phi_1723_ = _e695;
                                                phi_1724_ = _e697;
                                                phi_1725_ = _e996;
                                            }
                                            let _e998 = phi_1722_;
                                            let _e1000 = phi_1723_;
                                            let _e1002 = phi_1724_;
                                            let _e1004 = phi_1725_;
                                            if ((_e998 & 255u) == 0u) {
                                                if (_e1004 > 0u) {
                                                    let _e1008 = (_e1004 - 1u);
                                                    if (_e1008 < 32u) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1012 = local_3[(0u + _e1008)];
                                                    phi_1743_ = _e1012;
                                                    phi_1744_ = _e1008;
                                                } else {
                                                    phi_1743_ = 0u;
                                                    phi_1744_ = _e1004;
                                                }
                                                let _e1014 = phi_1743_;
                                                let _e1016 = phi_1744_;
                                                phi_1745_ = _e1014;
                                                phi_1746_ = _e1016;
                                            } else {
                                                phi_1745_ = _e998;
                                                phi_1746_ = _e1004;
                                            }
                                            let _e1018 = phi_1745_;
                                            let _e1020 = phi_1746_;
                                            phi_1747_ = _e1018;
                                            phi_1748_ = _e1000;
                                            phi_1749_ = _e1002;
                                            phi_1750_ = _e1020;
                                        } else {
                                            phi_1747_ = u32();
                                            phi_1748_ = u32();
                                            phi_1749_ = u32();
                                            phi_1750_ = u32();
                                        }
                                        let _e1022 = phi_1747_;
                                        let _e1024 = phi_1748_;
                                        let _e1026 = phi_1749_;
                                        let _e1028 = phi_1750_;
                                        phi_1398_ = _e1022;
                                        phi_1401_ = _e1024;
                                        phi_1403_ = _e1026;
                                        phi_1405_ = _e1028;
                                        phi_1751_ = _e701;
                                    }
                                    let _e1030 = phi_1398_;
                                    let _e1032 = phi_1401_;
                                    let _e1034 = phi_1403_;
                                    let _e1036 = phi_1405_;
                                    let _e1038 = phi_1751_;
                                    continue;
                                    continuing {
                                        phi_1397_ = _e1030;
                                        phi_1400_ = _e1032;
                                        phi_1402_ = _e1034;
                                        phi_1404_ = _e1036;
                                        break if !(_e1038);
                                    }
                                }
                                let _e1041 = local_5;
                                if _e1041 {
                                }
                                let _e3519 = local_14;
                                phi_1756_ = _e3519;
                                loop {
                                    let _e1043 = phi_1756_;
                                    let _e1044 = (_e1043 == 0u);
                                    local_7 = _e1044;
                                    local_19 = _e1044;
                                    if _e1044 {
                                        phi_1757_ = u32();
                                        phi_2602_ = false;
                                        phi_2603_ = false;
                                        phi_2604_ = false;
                                    } else {
                                        let _e1047 = select(firstTrailingBit(_e1043), 32u, (_e1043 == 0u));
                                        let _e1051 = local_6;
                                        let _e1052 = (_e1051 + (_e1047 >> bitcast<u32>(2i)));
                                        if (_e1052 < _e101) {
                                        } else {
                                            return;
                                        }
                                        let _e1057 = rows.member[(0u + _e1052)][0u];
                                        let _e1061 = rows.member[(0u + _e1052)][1u];
                                        let _e1065 = rows.member[(0u + _e1052)][2u];
                                        let _e1069 = rows.member[(0u + _e1052)][3u];
                                        if ((_e1047 & 2u) == 0u) {
                                            phi_1795_ = _e1061;
                                            phi_1796_ = _e1057;
                                        } else {
                                            phi_1795_ = _e1069;
                                            phi_1796_ = _e1065;
                                        }
                                        let _e1073 = phi_1795_;
                                        let _e1075 = phi_1796_;
                                        if ((_e1047 & 1u) == 0u) {
                                            phi_1802_ = _e1075;
                                        } else {
                                            phi_1802_ = _e1073;
                                        }
                                        let _e1079 = phi_1802_;
                                        if (_e1079 < _e95) {
                                        } else {
                                            return;
                                        }
                                        let _e1086 = triangles.member[(0u + _e1079)].v0_;
                                        let _e1088 = (_e1086.x - _e278);
                                        let _e1090 = (_e1086.y - _e280);
                                        let _e1092 = (_e1086.z - _e282);
                                        if (_e667 == 0u) {
                                            phi_1832_ = vec3<f32>(_e1090, _e1092, _e1088);
                                        } else {
                                            if (_e667 == 1u) {
                                                phi_1831_ = vec3<f32>(_e1092, _e1088, _e1090);
                                            } else {
                                                phi_1831_ = (_e1086 - vec3<f32>(_e278, _e280, _e282));
                                            }
                                            let _e1100 = phi_1831_;
                                            phi_1832_ = _e1100;
                                        }
                                        let _e1102 = phi_1832_;
                                        let _e1106 = (_e1102.x - (_e678 * _e1102.z));
                                        let _e1110 = (_e1102.y - (_e681 * _e1102.z));
                                        let _e1112 = triangles.member[(0u + _e1079)].v1_;
                                        let _e1114 = (_e1112.x - _e278);
                                        let _e1116 = (_e1112.y - _e280);
                                        let _e1118 = (_e1112.z - _e282);
                                        if (_e667 == 0u) {
                                            phi_1862_ = vec3<f32>(_e1116, _e1118, _e1114);
                                        } else {
                                            if (_e667 == 1u) {
                                                phi_1861_ = vec3<f32>(_e1118, _e1114, _e1116);
                                            } else {
                                                phi_1861_ = (_e1112 - vec3<f32>(_e278, _e280, _e282));
                                            }
                                            let _e1126 = phi_1861_;
                                            phi_1862_ = _e1126;
                                        }
                                        let _e1128 = phi_1862_;
                                        let _e1132 = (_e1128.x - (_e678 * _e1128.z));
                                        let _e1136 = (_e1128.y - (_e681 * _e1128.z));
                                        let _e1138 = triangles.member[(0u + _e1079)].v2_;
                                        let _e1140 = (_e1138.x - _e278);
                                        let _e1142 = (_e1138.y - _e280);
                                        let _e1144 = (_e1138.z - _e282);
                                        if (_e667 == 0u) {
                                            phi_1892_ = vec3<f32>(_e1142, _e1144, _e1140);
                                        } else {
                                            if (_e667 == 1u) {
                                                phi_1891_ = vec3<f32>(_e1144, _e1140, _e1142);
                                            } else {
                                                phi_1891_ = (_e1138 - vec3<f32>(_e278, _e280, _e282));
                                            }
                                            let _e1152 = phi_1891_;
                                            phi_1892_ = _e1152;
                                        }
                                        let _e1154 = phi_1892_;
                                        let _e1158 = (_e1154.x - (_e678 * _e1154.z));
                                        let _e1162 = (_e1154.y - (_e681 * _e1154.z));
                                        if (_e1132 < _e1158) {
                                            phi_1911_ = true;
                                        } else {
                                            if (_e1132 == _e1158) {
                                                phi_1910_ = (_e1136 < _e1162);
                                            } else {
                                                phi_1910_ = false;
                                            }
                                            let _e1167 = phi_1910_;
                                            phi_1911_ = _e1167;
                                        }
                                        let _e1169 = phi_1911_;
                                        if _e1169 {
                                            phi_1915_ = _e1162;
                                            phi_1916_ = _e1158;
                                            phi_1917_ = _e1136;
                                            phi_1918_ = _e1132;
                                        } else {
                                            phi_1915_ = _e1136;
                                            phi_1916_ = _e1132;
                                            phi_1917_ = _e1162;
                                            phi_1918_ = _e1158;
                                        }
                                        let _e1171 = phi_1915_;
                                        let _e1173 = phi_1916_;
                                        let _e1175 = phi_1917_;
                                        let _e1177 = phi_1918_;
                                        let _e1180 = ((_e1177 * _e1171) - (_e1175 * _e1173));
                                        if _e1169 {
                                            phi_1926_ = -(_e1180);
                                        } else {
                                            phi_1926_ = _e1180;
                                        }
                                        let _e1183 = phi_1926_;
                                        if (_e1158 < _e1106) {
                                            phi_1937_ = true;
                                        } else {
                                            if (_e1158 == _e1106) {
                                                phi_1936_ = (_e1162 < _e1110);
                                            } else {
                                                phi_1936_ = false;
                                            }
                                            let _e1188 = phi_1936_;
                                            phi_1937_ = _e1188;
                                        }
                                        let _e1190 = phi_1937_;
                                        if _e1190 {
                                            phi_1941_ = _e1110;
                                            phi_1942_ = _e1106;
                                            phi_1943_ = _e1162;
                                            phi_1944_ = _e1158;
                                        } else {
                                            phi_1941_ = _e1162;
                                            phi_1942_ = _e1158;
                                            phi_1943_ = _e1110;
                                            phi_1944_ = _e1106;
                                        }
                                        let _e1192 = phi_1941_;
                                        let _e1194 = phi_1942_;
                                        let _e1196 = phi_1943_;
                                        let _e1198 = phi_1944_;
                                        let _e1201 = ((_e1198 * _e1192) - (_e1196 * _e1194));
                                        if _e1190 {
                                            phi_1952_ = -(_e1201);
                                        } else {
                                            phi_1952_ = _e1201;
                                        }
                                        let _e1204 = phi_1952_;
                                        if (_e1106 < _e1132) {
                                            phi_1963_ = true;
                                        } else {
                                            if (_e1106 == _e1132) {
                                                phi_1962_ = (_e1110 < _e1136);
                                            } else {
                                                phi_1962_ = false;
                                            }
                                            let _e1209 = phi_1962_;
                                            phi_1963_ = _e1209;
                                        }
                                        let _e1211 = phi_1963_;
                                        if _e1211 {
                                            phi_1967_ = _e1136;
                                            phi_1968_ = _e1132;
                                            phi_1969_ = _e1110;
                                            phi_1970_ = _e1106;
                                        } else {
                                            phi_1967_ = _e1110;
                                            phi_1968_ = _e1106;
                                            phi_1969_ = _e1136;
                                            phi_1970_ = _e1132;
                                        }
                                        let _e1213 = phi_1967_;
                                        let _e1215 = phi_1968_;
                                        let _e1217 = phi_1969_;
                                        let _e1219 = phi_1970_;
                                        let _e1222 = ((_e1219 * _e1213) - (_e1217 * _e1215));
                                        if _e1211 {
                                            phi_1978_ = -(_e1222);
                                        } else {
                                            phi_1978_ = _e1222;
                                        }
                                        let _e1225 = phi_1978_;
                                        if (_e1183 >= 0f) {
                                            if (_e1204 >= 0f) {
                                                if (_e1225 >= 0f) {
                                                    phi_1993_ = ((_e1183 + _e1204) + _e1225);
                                                    phi_1994_ = false;
                                                } else {
                                                    phi_1993_ = f32();
                                                    phi_1994_ = true;
                                                }
                                                let _e1232 = phi_1993_;
                                                let _e1234 = phi_1994_;
                                                phi_1995_ = _e1232;
                                                phi_1996_ = _e1234;
                                            } else {
                                                phi_1995_ = f32();
                                                phi_1996_ = true;
                                            }
                                            let _e1236 = phi_1995_;
                                            let _e1238 = phi_1996_;
                                            phi_1997_ = _e1236;
                                            phi_1998_ = _e1238;
                                        } else {
                                            phi_1997_ = f32();
                                            phi_1998_ = true;
                                        }
                                        let _e1240 = phi_1997_;
                                        let _e1242 = phi_1998_;
                                        if _e1242 {
                                            if (_e1183 <= 0f) {
                                                if (_e1204 <= 0f) {
                                                    let _e1245 = (_e1225 <= 0f);
                                                    if _e1245 {
                                                    }
                                                    phi_2016_ = ((_e1183 + _e1204) + _e1225);
                                                    phi_2017_ = false;
                                                    phi_2018_ = _e1245;
                                                } else {
                                                    phi_2016_ = f32();
                                                    phi_2017_ = true;
                                                    phi_2018_ = false;
                                                }
                                                let _e1249 = phi_2016_;
                                                let _e1251 = phi_2017_;
                                                let _e1253 = phi_2018_;
                                                phi_2019_ = _e1249;
                                                phi_2020_ = _e1251;
                                                phi_2021_ = _e1253;
                                            } else {
                                                phi_2019_ = f32();
                                                phi_2020_ = true;
                                                phi_2021_ = false;
                                            }
                                            let _e1255 = phi_2019_;
                                            let _e1257 = phi_2020_;
                                            let _e1259 = phi_2021_;
                                            if _e1257 {
                                                phi_2025_ = false;
                                            } else {
                                                phi_2025_ = _e1259;
                                            }
                                            let _e1261 = phi_2025_;
                                            phi_2026_ = _e1255;
                                            phi_2027_ = _e1261;
                                        } else {
                                            phi_2026_ = _e1240;
                                            phi_2027_ = true;
                                        }
                                        let _e1263 = phi_2026_;
                                        let _e1265 = phi_2027_;
                                        if _e1265 {
                                            let _e1266 = (_e1263 == 0f);
                                            if _e1266 {
                                                phi_2343_ = lt_bvh_triangle_Intersection();
                                                phi_2344_ = false;
                                            } else {
                                                let _e1268 = triangles.member[(0u + _e1079)].v0_;
                                                let _e1270 = (_e1268.x - _e278);
                                                let _e1272 = (_e1268.y - _e280);
                                                let _e1274 = (_e1268.z - _e282);
                                                if (_e667 == 0u) {
                                                    phi_2056_ = vec3<f32>(_e1272, _e1274, _e1270);
                                                } else {
                                                    if (_e667 == 1u) {
                                                        phi_2055_ = vec3<f32>(_e1274, _e1270, _e1272);
                                                    } else {
                                                        phi_2055_ = (_e1268 - vec3<f32>(_e278, _e280, _e282));
                                                    }
                                                    let _e1282 = phi_2055_;
                                                    phi_2056_ = _e1282;
                                                }
                                                let _e1284 = phi_2056_;
                                                let _e1286 = triangles.member[(0u + _e1079)].v1_;
                                                let _e1288 = triangles.member[(0u + _e1079)].v0_;
                                                let _e1291 = (_e1286.x - _e1288.x);
                                                let _e1294 = (_e1286.y - _e1288.y);
                                                let _e1297 = (_e1286.z - _e1288.z);
                                                if (_e667 == 0u) {
                                                    phi_2082_ = vec3<f32>(_e1294, _e1297, _e1291);
                                                } else {
                                                    if (_e667 == 1u) {
                                                        phi_2081_ = vec3<f32>(_e1297, _e1291, _e1294);
                                                    } else {
                                                        phi_2081_ = (_e1286 - _e1288);
                                                    }
                                                    let _e1304 = phi_2081_;
                                                    phi_2082_ = _e1304;
                                                }
                                                let _e1306 = phi_2082_;
                                                let _e1308 = triangles.member[(0u + _e1079)].v2_;
                                                let _e1310 = triangles.member[(0u + _e1079)].v0_;
                                                let _e1313 = (_e1308.x - _e1310.x);
                                                let _e1316 = (_e1308.y - _e1310.y);
                                                let _e1319 = (_e1308.z - _e1310.z);
                                                if (_e667 == 0u) {
                                                    phi_2108_ = vec3<f32>(_e1316, _e1319, _e1313);
                                                } else {
                                                    if (_e667 == 1u) {
                                                        phi_2107_ = vec3<f32>(_e1319, _e1313, _e1316);
                                                    } else {
                                                        phi_2107_ = (_e1308 - _e1310);
                                                    }
                                                    let _e1326 = phi_2107_;
                                                    phi_2108_ = _e1326;
                                                }
                                                let _e1328 = phi_2108_;
                                                let _e1335 = ((_e1306.y * _e1328.z) - (_e1306.z * _e1328.y));
                                                let _e1342 = ((_e1306.z * _e1328.x) - (_e1306.x * _e1328.z));
                                                let _e1349 = ((_e1306.x * _e1328.y) - (_e1306.y * _e1328.x));
                                                let _e1363 = (((1f / _e675.z) * (((_e1335 * _e1284.x) + (_e1342 * _e1284.y)) + (_e1349 * _e1284.z))) / (((_e1335 * _e678) + (_e1342 * _e681)) + _e1349));
                                                if (_e1363 > 0f) {
                                                    if (_e1363 < _e290) {
                                                        let _e1367 = triangles.member[(0u + _e1079)].v0_;
                                                        let _e1369 = triangles.member[(0u + _e1079)].v1_;
                                                        if (_e1367.x < _e1369.x) {
                                                            phi_2164_ = _e1367.x;
                                                        } else {
                                                            phi_2164_ = _e1369.x;
                                                        }
                                                        let _e1376 = phi_2164_;
                                                        if (_e1367.y < _e1369.y) {
                                                            phi_2173_ = _e1367.y;
                                                        } else {
                                                            phi_2173_ = _e1369.y;
                                                        }
                                                        let _e1383 = phi_2173_;
                                                        if (_e1367.z < _e1369.z) {
                                                            phi_2182_ = _e1367.z;
                                                        } else {
                                                            phi_2182_ = _e1369.z;
                                                        }
                                                        let _e1390 = phi_2182_;
                                                        let _e1392 = triangles.member[(0u + _e1079)].v2_;
                                                        if (_e1376 < _e1392.x) {
                                                            phi_2191_ = _e1376;
                                                        } else {
                                                            phi_2191_ = _e1392.x;
                                                        }
                                                        let _e1397 = phi_2191_;
                                                        if (_e1383 < _e1392.y) {
                                                            phi_2198_ = _e1383;
                                                        } else {
                                                            phi_2198_ = _e1392.y;
                                                        }
                                                        let _e1402 = phi_2198_;
                                                        if (_e1390 < _e1392.z) {
                                                            phi_2205_ = _e1390;
                                                        } else {
                                                            phi_2205_ = _e1392.z;
                                                        }
                                                        let _e1407 = phi_2205_;
                                                        let _e1409 = triangles.member[(0u + _e1079)].v0_;
                                                        let _e1411 = triangles.member[(0u + _e1079)].v1_;
                                                        if (_e1409.x > _e1411.x) {
                                                            phi_2218_ = _e1409.x;
                                                        } else {
                                                            phi_2218_ = _e1411.x;
                                                        }
                                                        let _e1418 = phi_2218_;
                                                        if (_e1409.y > _e1411.y) {
                                                            phi_2227_ = _e1409.y;
                                                        } else {
                                                            phi_2227_ = _e1411.y;
                                                        }
                                                        let _e1425 = phi_2227_;
                                                        if (_e1409.z > _e1411.z) {
                                                            phi_2236_ = _e1409.z;
                                                        } else {
                                                            phi_2236_ = _e1411.z;
                                                        }
                                                        let _e1432 = phi_2236_;
                                                        let _e1434 = triangles.member[(0u + _e1079)].v2_;
                                                        if (_e1418 > _e1434.x) {
                                                            phi_2245_ = _e1418;
                                                        } else {
                                                            phi_2245_ = _e1434.x;
                                                        }
                                                        let _e1439 = phi_2245_;
                                                        if (_e1425 > _e1434.y) {
                                                            phi_2252_ = _e1425;
                                                        } else {
                                                            phi_2252_ = _e1434.y;
                                                        }
                                                        let _e1444 = phi_2252_;
                                                        if (_e1432 > _e1434.z) {
                                                            phi_2259_ = _e1432;
                                                        } else {
                                                            phi_2259_ = _e1434.z;
                                                        }
                                                        let _e1449 = phi_2259_;
                                                        let _e1453 = ((_e1397 - _e278) * _e596);
                                                        let _e1454 = ((_e1402 - _e280) * _e606);
                                                        let _e1455 = ((_e1407 - _e282) * _e616);
                                                        let _e1459 = ((_e1439 - _e278) * _e596);
                                                        let _e1460 = ((_e1444 - _e280) * _e606);
                                                        let _e1461 = ((_e1449 - _e282) * _e616);
                                                        if (_e1453 < _e1459) {
                                                            phi_2276_ = _e1453;
                                                        } else {
                                                            phi_2276_ = _e1459;
                                                        }
                                                        let _e1464 = phi_2276_;
                                                        if (_e1454 < _e1460) {
                                                            phi_2281_ = _e1454;
                                                        } else {
                                                            phi_2281_ = _e1460;
                                                        }
                                                        let _e1467 = phi_2281_;
                                                        if (_e1455 < _e1461) {
                                                            phi_2286_ = _e1455;
                                                        } else {
                                                            phi_2286_ = _e1461;
                                                        }
                                                        let _e1470 = phi_2286_;
                                                        if (_e1453 > _e1459) {
                                                            phi_2294_ = _e1453;
                                                        } else {
                                                            phi_2294_ = _e1459;
                                                        }
                                                        let _e1476 = phi_2294_;
                                                        if (_e1454 > _e1460) {
                                                            phi_2299_ = _e1454;
                                                        } else {
                                                            phi_2299_ = _e1460;
                                                        }
                                                        let _e1479 = phi_2299_;
                                                        if (_e1455 > _e1461) {
                                                            phi_2304_ = _e1455;
                                                        } else {
                                                            phi_2304_ = _e1461;
                                                        }
                                                        let _e1482 = phi_2304_;
                                                        let _e1486 = core_intrinsics_maximum_number_nsz_f32_((_e1464 - _e651), (_e1467 - _e652));
                                                        let _e1487 = core_intrinsics_maximum_number_nsz_f32_(_e1486, (_e1470 - _e653));
                                                        let _e1488 = core_intrinsics_minimum_number_nsz_f32_((_e1476 + _e651), (_e1479 + _e652));
                                                        let _e1489 = core_intrinsics_minimum_number_nsz_f32_(_e1488, (_e1482 + _e653));
                                                        if (_e1487 > -300000000000000000000000000000000000000f) {
                                                            phi_2316_ = _e1487;
                                                        } else {
                                                            phi_2316_ = -300000000000000000000000000000000000000f;
                                                        }
                                                        let _e1492 = phi_2316_;
                                                        if (_e1489 < 300000000000000000000000000000000000000f) {
                                                            phi_2321_ = _e1489;
                                                        } else {
                                                            phi_2321_ = 300000000000000000000000000000000000000f;
                                                        }
                                                        let _e1495 = phi_2321_;
                                                        if (_e1363 < _e1492) {
                                                            phi_2326_ = _e1492;
                                                        } else {
                                                            phi_2326_ = _e1363;
                                                        }
                                                        let _e1498 = phi_2326_;
                                                        if (_e1498 > _e1495) {
                                                            phi_2331_ = _e1495;
                                                        } else {
                                                            phi_2331_ = _e1498;
                                                        }
                                                        let _e1501 = phi_2331_;
                                                        phi_2336_ = lt_bvh_triangle_Intersection(_e1501, (_e1204 / _e1263), (_e1225 / _e1263), (_e1492 <= _e1495));
                                                        phi_2337_ = false;
                                                    } else {
                                                        phi_2336_ = lt_bvh_triangle_Intersection();
                                                        phi_2337_ = true;
                                                    }
                                                    let _e1507 = phi_2336_;
                                                    let _e1509 = phi_2337_;
                                                    phi_2338_ = _e1507;
                                                    phi_2339_ = _e1509;
                                                } else {
                                                    phi_2338_ = lt_bvh_triangle_Intersection();
                                                    phi_2339_ = true;
                                                }
                                                let _e1511 = phi_2338_;
                                                let _e1513 = phi_2339_;
                                                if _e1513 {
                                                }
                                                phi_2343_ = _e1511;
                                                phi_2344_ = _e1513;
                                            }
                                            let _e1515 = phi_2343_;
                                            let _e1517 = phi_2344_;
                                            phi_2345_ = _e1515;
                                            phi_2346_ = _e1266;
                                            phi_2347_ = _e1517;
                                        } else {
                                            phi_2345_ = lt_bvh_triangle_Intersection();
                                            phi_2346_ = true;
                                            phi_2347_ = false;
                                        }
                                        let _e1519 = phi_2345_;
                                        let _e1521 = phi_2346_;
                                        let _e1523 = phi_2347_;
                                        if _e1521 {
                                            phi_2351_ = true;
                                        } else {
                                            phi_2351_ = _e1523;
                                        }
                                        let _e1525 = phi_2351_;
                                        if _e1525 {
                                            phi_2355_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                        } else {
                                            phi_2355_ = _e1519;
                                        }
                                        let _e1527 = phi_2355_;
                                        if _e1527.is_hit {
                                            if (_e1527.t > 0f) {
                                                if (_e1527.t < _e290) {
                                                    let _e1534 = triangles.member[(0u + _e1079)].i0_;
                                                    let _e1536 = ((_e1534 & 2147483648u) == 0u);
                                                    if _e1536 {
                                                        phi_2578_ = false;
                                                        phi_2579_ = false;
                                                    } else {
                                                        if (_e1079 < _e95) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1543 = triangles.member[(0u + _e1079)].i0_;
                                                        let _e1544 = (_e1543 & 2147483647u);
                                                        let _e1546 = triangles.member[(0u + _e1079)].i1_;
                                                        let _e1548 = triangles.member[(0u + _e1079)].i2_;
                                                        if (_e1544 < _e105) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1552 = vertices.member[(0u + _e1544)];
                                                        if (_e1546 < _e105) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1556 = vertices.member[(0u + _e1546)];
                                                        if (_e1548 < _e105) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1560 = vertices.member[(0u + _e1548)];
                                                        let _e1561 = array<abi_Vertex, 3>(_e1552, _e1556, _e1560);
                                                        if (_e1561[0].material < _e108) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1567 = materials.member[(0u + _e1561[0].material)];
                                                        if ((_e1567.flags & 1u) == 1u) {
                                                            let _e1572 = ((1f - _e1527.u) - _e1527.v);
                                                            if (_e1567.cutoff <= 0f) {
                                                                phi_2572_ = true;
                                                            } else {
                                                                let _e1599 = (_e1567.base_color.w * ((((f32((_e1561[0].color >> bitcast<u32>(24i))) * _e1572) + (f32((_e1561[1].color >> bitcast<u32>(24i))) * _e1527.u)) + (f32((_e1561[2].color >> bitcast<u32>(24i))) * _e1527.v)) * (1f / 255f)));
                                                                if (_e1567.alpha_size == 0u) {
                                                                    phi_2569_ = _e1599;
                                                                } else {
                                                                    local_2.offset = _e1567.alpha_offset;
                                                                    local_2.size = _e1567.alpha_size;
                                                                    local_2.flags = _e1567.flags;
                                                                    let _e1630 = _lt_shaders_texture_TextureView_quad((&local_2), (((_e1561[0].u * _e1572) + (_e1561[1].u * _e1527.u)) + (_e1561[2].u * _e1527.v)), (((_e1561[0].v * _e1572) + (_e1561[1].v * _e1527.u)) + (_e1561[2].v * _e1527.v)));
                                                                    let _e1634 = (_e1630.indices[0] >> bitcast<u32>(2i));
                                                                    if (_e1634 < _e111) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1638 = alpha_texels.member[(0u + _e1634)];
                                                                    let _e1654 = (_e1630.indices[1] >> bitcast<u32>(2i));
                                                                    if (_e1654 < _e111) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1658 = alpha_texels.member[(0u + _e1654)];
                                                                    let _e1675 = (_e1630.indices[2] >> bitcast<u32>(2i));
                                                                    if (_e1675 < _e111) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1679 = alpha_texels.member[(0u + _e1675)];
                                                                    let _e1696 = (_e1630.indices[3] >> bitcast<u32>(2i));
                                                                    if (_e1696 < _e111) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1700 = alpha_texels.member[(0u + _e1696)];
                                                                    phi_2569_ = (_e1599 * (((((f32(((_e1638 >> bitcast<u32>((((_e1630.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1630.weights.x) + ((f32(((_e1658 >> bitcast<u32>((((_e1630.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1630.weights.y)) + ((f32(((_e1679 >> bitcast<u32>((((_e1630.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1630.weights.z)) + ((f32(((_e1700 >> bitcast<u32>((((_e1630.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1630.weights.w)));
                                                                }
                                                                let _e1716 = phi_2569_;
                                                                phi_2572_ = (_e1716 >= _e1567.cutoff);
                                                            }
                                                            let _e1720 = phi_2572_;
                                                            phi_2573_ = _e1720;
                                                        } else {
                                                            phi_2573_ = false;
                                                        }
                                                        let _e1722 = phi_2573_;
                                                        if _e1722 {
                                                            phi_2577_ = false;
                                                        } else {
                                                            phi_2577_ = true;
                                                        }
                                                        let _e1724 = phi_2577_;
                                                        phi_2578_ = _e1724;
                                                        phi_2579_ = _e1722;
                                                    }
                                                    let _e1726 = phi_2578_;
                                                    let _e1728 = phi_2579_;
                                                    phi_2580_ = _e1726;
                                                    phi_2581_ = _e1536;
                                                    phi_2582_ = _e1728;
                                                } else {
                                                    phi_2580_ = true;
                                                    phi_2581_ = false;
                                                    phi_2582_ = false;
                                                }
                                                let _e1730 = phi_2580_;
                                                let _e1732 = phi_2581_;
                                                let _e1734 = phi_2582_;
                                                phi_2583_ = false;
                                                phi_2584_ = _e1730;
                                                phi_2585_ = _e1732;
                                                phi_2586_ = _e1734;
                                            } else {
                                                phi_2583_ = true;
                                                phi_2584_ = false;
                                                phi_2585_ = false;
                                                phi_2586_ = false;
                                            }
                                            let _e1736 = phi_2583_;
                                            let _e1738 = phi_2584_;
                                            let _e1740 = phi_2585_;
                                            let _e1742 = phi_2586_;
                                            phi_2587_ = _e1736;
                                            phi_2588_ = _e1738;
                                            phi_2589_ = _e1740;
                                            phi_2590_ = _e1742;
                                        } else {
                                            phi_2587_ = true;
                                            phi_2588_ = false;
                                            phi_2589_ = false;
                                            phi_2590_ = false;
                                        }
                                        let _e1744 = phi_2587_;
                                        let _e1746 = phi_2588_;
                                        let _e1748 = phi_2589_;
                                        let _e1750 = phi_2590_;
                                        if _e1744 {
                                            phi_2594_ = true;
                                            phi_2595_ = false;
                                            phi_2596_ = false;
                                        } else {
                                            phi_2594_ = _e1746;
                                            phi_2595_ = _e1748;
                                            phi_2596_ = _e1750;
                                        }
                                        let _e1752 = phi_2594_;
                                        let _e1754 = phi_2595_;
                                        let _e1756 = phi_2596_;
                                        if _e1752 {
                                            phi_2600_ = false;
                                            phi_2601_ = false;
                                        } else {
                                            phi_2600_ = _e1754;
                                            phi_2601_ = _e1756;
                                        }
                                        let _e1758 = phi_2600_;
                                        let _e1760 = phi_2601_;
                                        phi_1757_ = (_e1043 & (_e1043 - 1u));
                                        phi_2602_ = _e1752;
                                        phi_2603_ = _e1758;
                                        phi_2604_ = _e1760;
                                    }
                                    let _e1762 = phi_1757_;
                                    let _e1764 = phi_2602_;
                                    let _e1766 = phi_2603_;
                                    let _e1768 = phi_2604_;
                                    local_15 = _e1766;
                                    local_16 = _e1768;
                                    continue;
                                    continuing {
                                        phi_1756_ = _e1762;
                                        break if !(_e1764);
                                    }
                                }
                                let _e1771 = local_7;
                                if _e1771 {
                                    phi_2608_ = false;
                                    phi_2609_ = false;
                                } else {
                                    let _e3634 = local_15;
                                    phi_2608_ = _e3634;
                                    let _e3637 = local_16;
                                    phi_2609_ = _e3637;
                                }
                                let _e1773 = phi_2608_;
                                let _e1775 = phi_2609_;
                                let _e3640 = local_17;
                                phi_1386_ = _e3640;
                                let _e3643 = local_18;
                                phi_1389_ = _e3643;
                                let _e3646 = local_19;
                                phi_2610_ = _e3646;
                                phi_2611_ = _e1773;
                                phi_2612_ = _e1775;
                            }
                            let _e1777 = phi_1386_;
                            let _e1779 = phi_1389_;
                            let _e1781 = phi_2610_;
                            let _e1783 = phi_2611_;
                            let _e1785 = phi_2612_;
                            local_20 = _e1783;
                            local_21 = _e1785;
                            continue;
                            continuing {
                                phi_1385_ = _e1777;
                                phi_1388_ = _e1779;
                                break if !(_e1781);
                            }
                        }
                        let _e1788 = local_8;
                        if _e1788 {
                            phi_2616_ = false;
                            phi_2617_ = false;
                        } else {
                            let _e3652 = local_20;
                            phi_2616_ = _e3652;
                            let _e3655 = local_21;
                            phi_2617_ = _e3655;
                        }
                        let _e1790 = phi_2616_;
                        let _e1792 = phi_2617_;
                        if _e1790 {
                            phi_2621_ = false;
                        } else {
                            phi_2621_ = _e1792;
                        }
                        let _e1794 = phi_2621_;
                        if _e1794 {
                            phi_2625_ = true;
                        } else {
                            phi_2625_ = _e1790;
                        }
                        let _e1796 = phi_2625_;
                        if _e1796 {
                        }
                        phi_2629_ = true;
                        phi_2630_ = _e1796;
                    }
                    let _e1798 = phi_2629_;
                    let _e1800 = phi_2630_;
                    if _e1800 {
                        phi_2634_ = _e1798;
                    } else {
                        phi_2634_ = false;
                    }
                    let _e1802 = phi_2634_;
                    phi_4299_ = _e1802;
                } else {
                    let _e1803 = abs(_e298);
                    let _e1804 = abs(_e299);
                    let _e1805 = abs(_e300);
                    if (abs(_e278) < 1000000000000000f) {
                        if (abs(_e280) < 1000000000000000f) {
                            phi_2650_ = (abs(_e282) < 1000000000000000f);
                            phi_2651_ = false;
                        } else {
                            phi_2650_ = bool();
                            phi_2651_ = true;
                        }
                        let _e1813 = phi_2650_;
                        let _e1815 = phi_2651_;
                        phi_2652_ = _e1813;
                        phi_2653_ = _e1815;
                    } else {
                        phi_2652_ = bool();
                        phi_2653_ = true;
                    }
                    let _e1817 = phi_2652_;
                    let _e1819 = phi_2653_;
                    if _e1819 {
                        phi_2657_ = false;
                    } else {
                        phi_2657_ = _e1817;
                    }
                    let _e1821 = phi_2657_;
                    if _e1821 {
                        if (_e1803 < 1000000000000000f) {
                            if (_e1804 < 1000000000000000f) {
                                phi_2670_ = (_e1805 < 1000000000000000f);
                                phi_2671_ = false;
                            } else {
                                phi_2670_ = bool();
                                phi_2671_ = true;
                            }
                            let _e1826 = phi_2670_;
                            let _e1828 = phi_2671_;
                            phi_2672_ = _e1826;
                            phi_2673_ = _e1828;
                        } else {
                            phi_2672_ = bool();
                            phi_2673_ = true;
                        }
                        let _e1830 = phi_2672_;
                        let _e1832 = phi_2673_;
                        if _e1832 {
                            phi_2677_ = false;
                        } else {
                            phi_2677_ = _e1830;
                        }
                        let _e1834 = phi_2677_;
                        if _e1834 {
                            if (_e1803 > 0f) {
                                phi_2691_ = bool();
                                phi_2692_ = true;
                            } else {
                                let _e1836 = (_e1804 > 0f);
                                if _e1836 {
                                    phi_2690_ = bool();
                                } else {
                                    phi_2690_ = (_e1805 > 0f);
                                }
                                let _e1839 = phi_2690_;
                                phi_2691_ = _e1839;
                                phi_2692_ = _e1836;
                            }
                            let _e1841 = phi_2691_;
                            let _e1843 = phi_2692_;
                            if _e1843 {
                                phi_2696_ = true;
                            } else {
                                phi_2696_ = _e1841;
                            }
                            let _e1845 = phi_2696_;
                            phi_2697_ = _e1845;
                            phi_2698_ = false;
                        } else {
                            phi_2697_ = bool();
                            phi_2698_ = true;
                        }
                        let _e1847 = phi_2697_;
                        let _e1849 = phi_2698_;
                        phi_2699_ = _e1847;
                        phi_2700_ = _e1849;
                    } else {
                        phi_2699_ = bool();
                        phi_2700_ = true;
                    }
                    let _e1851 = phi_2699_;
                    let _e1853 = phi_2700_;
                    if _e1853 {
                        phi_2704_ = false;
                    } else {
                        phi_2704_ = _e1851;
                    }
                    let _e1855 = phi_2704_;
                    if _e1855 {
                        let _e1856 = (0u >= _e92);
                        if _e1856 {
                            phi_4292_ = bool();
                        } else {
                            if (0u < _e92) {
                            } else {
                                return;
                            }
                            let _e1862 = nodes.member[(0u + 0u)].frame[0u];
                            let _e1866 = nodes.member[(0u + 0u)].frame[1u];
                            let _e1870 = nodes.member[(0u + 0u)].frame[2u];
                            let _e1874 = nodes.member[(0u + 0u)].frame[0u];
                            let _e1878 = nodes.member[(0u + 0u)].frame[1u];
                            let _e1882 = nodes.member[(0u + 0u)].frame[2u];
                            let _e1886 = nodes.member[(0u + 0u)].frame[3u];
                            let _e1920 = core_intrinsics_maximum_number_nsz_f32_(abs(_e298), abs(_e299));
                            let _e1921 = core_intrinsics_maximum_number_nsz_f32_(_e1920, abs(_e300));
                            let _e1922 = (_e1921 * 0.0000000000009094947f);
                            if (abs(_e298) < _e1922) {
                                phi_2774_ = _e1922;
                            } else {
                                phi_2774_ = abs(_e298);
                            }
                            let _e1927 = phi_2774_;
                            if (_e298 < 0f) {
                                phi_2781_ = (-1f / _e1927);
                            } else {
                                phi_2781_ = (1f / _e1927);
                            }
                            let _e1932 = phi_2781_;
                            if (abs(_e299) < _e1922) {
                                phi_2788_ = _e1922;
                            } else {
                                phi_2788_ = abs(_e299);
                            }
                            let _e1937 = phi_2788_;
                            if (_e299 < 0f) {
                                phi_2795_ = (-1f / _e1937);
                            } else {
                                phi_2795_ = (1f / _e1937);
                            }
                            let _e1942 = phi_2795_;
                            if (abs(_e300) < _e1922) {
                                phi_2802_ = _e1922;
                            } else {
                                phi_2802_ = abs(_e300);
                            }
                            let _e1947 = phi_2802_;
                            if (_e300 < 0f) {
                                phi_2809_ = (-1f / _e1947);
                            } else {
                                phi_2809_ = (1f / _e1947);
                            }
                            let _e1952 = phi_2809_;
                            let _e1956 = abs((bitcast<f32>(_e1862) - _e278));
                            let _e1957 = abs((bitcast<f32>(_e1866) - _e280));
                            let _e1958 = abs((bitcast<f32>(_e1870) - _e282));
                            let _e1962 = abs(((bitcast<f32>(_e1874) + (bitcast<f32>((((_e1886 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e278));
                            let _e1963 = abs(((bitcast<f32>(_e1878) + (bitcast<f32>((((_e1886 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e280));
                            let _e1964 = abs(((bitcast<f32>(_e1882) + (bitcast<f32>((((_e1886 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e282));
                            if (_e1956 > _e1962) {
                                phi_2826_ = _e1956;
                            } else {
                                phi_2826_ = _e1962;
                            }
                            let _e1967 = phi_2826_;
                            if (_e1957 > _e1963) {
                                phi_2831_ = _e1957;
                            } else {
                                phi_2831_ = _e1963;
                            }
                            let _e1970 = phi_2831_;
                            if (_e1958 > _e1964) {
                                phi_2836_ = _e1958;
                            } else {
                                phi_2836_ = _e1964;
                            }
                            let _e1973 = phi_2836_;
                            if (_e1967 > _e1970) {
                                phi_2841_ = _e1967;
                            } else {
                                phi_2841_ = _e1970;
                            }
                            let _e1976 = phi_2841_;
                            if (_e1976 > _e1973) {
                                phi_2846_ = _e1976;
                            } else {
                                phi_2846_ = _e1973;
                            }
                            let _e1979 = phi_2846_;
                            let _e1983 = (_e1979 * 0.0000019073486f);
                            let _e1984 = (abs(_e1932) * _e1983);
                            let _e1985 = (abs(_e1942) * _e1983);
                            let _e1986 = (abs(_e1952) * _e1983);
                            let _e1990 = (_e1979 * 0.0000009536743f);
                            let _e1991 = (abs(_e1932) * _e1990);
                            let _e1992 = (abs(_e1942) * _e1990);
                            let _e1993 = (abs(_e1952) * _e1990);
                            let _e1994 = abs(_e298);
                            let _e1995 = abs(_e299);
                            let _e1996 = abs(_e300);
                            if (_e1994 >= _e1995) {
                                if (_e1994 >= _e1996) {
                                    phi_2872_ = false;
                                } else {
                                    phi_2872_ = true;
                                }
                                let _e2000 = phi_2872_;
                                phi_2873_ = _e2000;
                            } else {
                                phi_2873_ = true;
                            }
                            let _e2002 = phi_2873_;
                            if _e2002 {
                                if (_e1995 >= _e1996) {
                                    phi_2881_ = 1u;
                                } else {
                                    phi_2881_ = 2u;
                                }
                                let _e2005 = phi_2881_;
                                phi_2882_ = _e2005;
                            } else {
                                phi_2882_ = 0u;
                            }
                            let _e2007 = phi_2882_;
                            if (_e2007 == 0u) {
                                phi_2894_ = vec3<f32>(_e299, _e300, _e298);
                            } else {
                                if (_e2007 == 1u) {
                                    phi_2893_ = vec3<f32>(_e300, _e298, _e299);
                                } else {
                                    phi_2893_ = _e301;
                                }
                                let _e2013 = phi_2893_;
                                phi_2894_ = _e2013;
                            }
                            let _e2015 = phi_2894_;
                            let _e2018 = (_e2015.x / _e2015.z);
                            let _e2021 = (_e2015.y / _e2015.z);
                            if (_e1932 < 0f) {
                                phi_2907_ = 0u;
                            } else {
                                phi_2907_ = 1u;
                            }
                            let _e2026 = phi_2907_;
                            if (_e1942 < 0f) {
                                phi_2912_ = 0u;
                            } else {
                                phi_2912_ = 2u;
                            }
                            let _e2029 = phi_2912_;
                            if (_e1952 < 0f) {
                                phi_2917_ = 0u;
                            } else {
                                phi_2917_ = 4u;
                            }
                            let _e2032 = phi_2917_;
                            let _e2034 = ((_e2026 | _e2029) | _e2032);
                            let _e2035 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                            local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e2035.first[0], _e2035.first[1], _e2035.first[2], _e2035.first[3], _e2035.first[4], _e2035.first[5], _e2035.first[6], _e2035.first[7], _e2035.first[8], _e2035.first[9], _e2035.first[10], _e2035.first[11], _e2035.first[12], _e2035.first[13], _e2035.first[14], _e2035.first[15], _e2035.first[16], _e2035.first[17], _e2035.first[18], _e2035.first[19], _e2035.first[20], _e2035.first[21], _e2035.first[22], _e2035.first[23], _e2035.first[24], _e2035.first[25], _e2035.first[26], _e2035.first[27], _e2035.first[28], _e2035.first[29], _e2035.first[30], _e2035.first[31]), array<u32, 32>(_e2035.mask[0], _e2035.mask[1], _e2035.mask[2], _e2035.mask[3], _e2035.mask[4], _e2035.mask[5], _e2035.mask[6], _e2035.mask[7], _e2035.mask[8], _e2035.mask[9], _e2035.mask[10], _e2035.mask[11], _e2035.mask[12], _e2035.mask[13], _e2035.mask[14], _e2035.mask[15], _e2035.mask[16], _e2035.mask[17], _e2035.mask[18], _e2035.mask[19], _e2035.mask[20], _e2035.mask[21], _e2035.mask[22], _e2035.mask[23], _e2035.mask[24], _e2035.mask[25], _e2035.mask[26], _e2035.mask[27], _e2035.mask[28], _e2035.mask[29], _e2035.mask[30], _e2035.mask[31]), _e2035.len, _e2035.group, _e2035.group_mask);
                            let _e2109 = local_1.group_mask;
                            if ((_e2109 & 4278190080u) == 0u) {
                                let _e2113 = local_1.len;
                                if (_e2113 == 0u) {
                                    phi_3031_ = false;
                                } else {
                                    let _e2117 = local_1.len;
                                    local_1.len = (_e2117 - 1u);
                                    let _e2120 = local_1.len;
                                    if (_e2120 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2125 = local_1.first[(0u + _e2120)];
                                    local_1.group = _e2125;
                                    let _e2128 = local_1.len;
                                    if (_e2128 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2133 = local_1.mask[(0u + _e2128)];
                                    local_1.group_mask = _e2133;
                                    phi_3031_ = true;
                                }
                                let _e2136 = phi_3031_;
                                phi_3032_ = _e2136;
                            } else {
                                phi_3032_ = true;
                            }
                            let _e2138 = phi_3032_;
                            if _e2138 {
                                let _e2140 = local_1.group_mask;
                                let _e2146 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2140)), 32u, (_e2140 == 0u)));
                                let _e2150 = local_1.group_mask;
                                let _e2164 = local_1.group_mask;
                                local_1.group_mask = (_e2164 & ~((1u << bitcast<u32>((_e2146 & 31u)))));
                                let _e2167 = local_1.group;
                                phi_3063_ = (_e2167 + countOneBits(((_e2150 & ~((4294967295u << bitcast<u32>((((_e2146 - 24u) ^ 7u) & 31u))))) & 255u)));
                            } else {
                                phi_3063_ = 4294967295u;
                            }
                            let _e2170 = phi_3063_;
                            phi_3065_ = _e2170;
                            phi_3068_ = false;
                            loop {
                                let _e2172 = phi_3065_;
                                let _e2174 = phi_3068_;
                                local_26 = _e2174;
                                if (_e2172 != 4294967295u) {
                                    if (_e2172 < _e92) {
                                    } else {
                                        return;
                                    }
                                    let _e2181 = nodes.member[(0u + _e2172)].frame[3u];
                                    let _e2206 = (bitcast<f32>((((_e2181 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1932);
                                    let _e2207 = (bitcast<f32>((((_e2181 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1942);
                                    let _e2208 = (bitcast<f32>((((_e2181 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1952);
                                    let _e2211 = nodes.member[(0u + _e2172)].frame[0u];
                                    let _e2215 = nodes.member[(0u + _e2172)].frame[1u];
                                    let _e2219 = nodes.member[(0u + _e2172)].frame[2u];
                                    let _e2224 = ((bitcast<f32>(_e2211) - _e278) * _e1932);
                                    let _e2225 = ((bitcast<f32>(_e2215) - _e280) * _e1942);
                                    let _e2226 = ((bitcast<f32>(_e2219) - _e282) * _e1952);
                                    let _e2234 = nodes.member[(0u + _e2172)].x;
                                    if (_e1932 < 0f) {
                                        let _e2245 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2234.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2251 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2245.unnamed.word, _e2234.w), _e2245.unnamed_1);
                                        let _e2257 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2251.unnamed, lt_mask_LightPlace(_e2234.x, _e2251.unnamed_1.shift));
                                        phi_3148_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2257.unnamed, lt_mask_LightPlace(_e2257.unnamed_1.word, _e2234.y));
                                    } else {
                                        let _e2273 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2234.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2279 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2273.unnamed.word, _e2234.y), _e2273.unnamed_1);
                                        let _e2285 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2279.unnamed, lt_mask_LightPlace(_e2234.z, _e2279.unnamed_1.shift));
                                        phi_3148_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2285.unnamed, lt_mask_LightPlace(_e2285.unnamed_1.word, _e2234.w));
                                    }
                                    let _e2293 = phi_3148_;
                                    let _e2303 = nodes.member[(0u + _e2172)].y;
                                    if (_e1942 < 0f) {
                                        let _e2314 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2303.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2320 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2314.unnamed.word, _e2303.w), _e2314.unnamed_1);
                                        let _e2326 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2320.unnamed, lt_mask_LightPlace(_e2303.x, _e2320.unnamed_1.shift));
                                        phi_3175_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2326.unnamed, lt_mask_LightPlace(_e2326.unnamed_1.word, _e2303.y));
                                    } else {
                                        let _e2342 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2303.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2348 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2342.unnamed.word, _e2303.y), _e2342.unnamed_1);
                                        let _e2354 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2348.unnamed, lt_mask_LightPlace(_e2303.z, _e2348.unnamed_1.shift));
                                        phi_3175_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2354.unnamed, lt_mask_LightPlace(_e2354.unnamed_1.word, _e2303.w));
                                    }
                                    let _e2362 = phi_3175_;
                                    let _e2372 = nodes.member[(0u + _e2172)].z;
                                    if (_e1952 < 0f) {
                                        let _e2383 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2372.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2389 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2383.unnamed.word, _e2372.w), _e2383.unnamed_1);
                                        let _e2395 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2389.unnamed, lt_mask_LightPlace(_e2372.x, _e2389.unnamed_1.shift));
                                        phi_3202_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2395.unnamed, lt_mask_LightPlace(_e2395.unnamed_1.word, _e2372.y));
                                    } else {
                                        let _e2411 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2372.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2417 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2411.unnamed.word, _e2372.y), _e2411.unnamed_1);
                                        let _e2423 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2417.unnamed, lt_mask_LightPlace(_e2372.z, _e2417.unnamed_1.shift));
                                        phi_3202_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2423.unnamed, lt_mask_LightPlace(_e2423.unnamed_1.word, _e2372.w));
                                    }
                                    let _e2431 = phi_3202_;
                                    phi_3208_ = 0u;
                                    phi_3211_ = 0u;
                                    loop {
                                        let _e2441 = phi_3208_;
                                        let _e2443 = phi_3211_;
                                        local_9 = _e2443;
                                        local_10 = _e2443;
                                        local_11 = _e2443;
                                        let _e2444 = (_e2441 < 8u);
                                        if _e2444 {
                                            let _e2446 = (_e2441 >> bitcast<u32>(2i));
                                            let _e2447 = (_e2441 & 3u);
                                            if (_e2446 == 0u) {
                                                phi_3225_ = _e2293.unnamed.word;
                                            } else {
                                                phi_3225_ = _e2293.unnamed.shift;
                                            }
                                            let _e2450 = phi_3225_;
                                            if (_e2446 == 0u) {
                                                phi_3235_ = _e2362.unnamed.word;
                                            } else {
                                                phi_3235_ = _e2362.unnamed.shift;
                                            }
                                            let _e2459 = phi_3235_;
                                            if (_e2446 == 0u) {
                                                phi_3245_ = _e2431.unnamed.word;
                                            } else {
                                                phi_3245_ = _e2431.unnamed.shift;
                                            }
                                            let _e2468 = phi_3245_;
                                            let _e2481 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e2450 >> bitcast<u32>(((_e2447 * 8u) & 31u))) & 255u)) * _e2206) + (_e2224 - _e1984)), ((f32(((_e2459 >> bitcast<u32>(((_e2447 * 8u) & 31u))) & 255u)) * _e2207) + (_e2225 - _e1985)));
                                            let _e2482 = core_intrinsics_maximum_number_nsz_f32_(_e2481, ((f32(((_e2468 >> bitcast<u32>(((_e2447 * 8u) & 31u))) & 255u)) * _e2208) + (_e2226 - _e1986)));
                                            if (_e2446 == 0u) {
                                                phi_3263_ = _e2293.unnamed_1.word;
                                            } else {
                                                phi_3263_ = _e2293.unnamed_1.shift;
                                            }
                                            let _e2485 = phi_3263_;
                                            if (_e2446 == 0u) {
                                                phi_3273_ = _e2362.unnamed_1.word;
                                            } else {
                                                phi_3273_ = _e2362.unnamed_1.shift;
                                            }
                                            let _e2494 = phi_3273_;
                                            if (_e2446 == 0u) {
                                                phi_3283_ = _e2431.unnamed_1.word;
                                            } else {
                                                phi_3283_ = _e2431.unnamed_1.shift;
                                            }
                                            let _e2503 = phi_3283_;
                                            let _e2516 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e2485 >> bitcast<u32>(((_e2447 * 8u) & 31u))) & 255u)) * _e2206) + (_e2224 + _e1984)), ((f32(((_e2494 >> bitcast<u32>(((_e2447 * 8u) & 31u))) & 255u)) * _e2207) + (_e2225 + _e1985)));
                                            let _e2517 = core_intrinsics_minimum_number_nsz_f32_(_e2516, ((f32(((_e2503 >> bitcast<u32>(((_e2447 * 8u) & 31u))) & 255u)) * _e2208) + (_e2226 + _e1986)));
                                            if (_e2482 <= _e2517) {
                                                if (_e2482 <= _e290) {
                                                    if (_e2517 >= 0f) {
                                                        if (_e2446 == 0u) {
                                                            let _e2524 = nodes.member[(0u + _e2172)].links[2u];
                                                            phi_3319_ = _e2524;
                                                        } else {
                                                            let _e2527 = nodes.member[(0u + _e2172)].links[3u];
                                                            phi_3319_ = _e2527;
                                                        }
                                                        let _e2529 = phi_3319_;
                                                        let _e2534 = ((_e2529 >> bitcast<u32>(((_e2447 * 8u) & 31u))) & 255u);
                                                        let _e2535 = (_e2534 & 31u);
                                                        if (_e2535 >= 24u) {
                                                            phi_3332_ = (24u + ((_e2535 - 24u) ^ _e2034));
                                                        } else {
                                                            phi_3332_ = _e2535;
                                                        }
                                                        let _e2541 = phi_3332_;
                                                        phi_3337_ = (_e2443 | ((_e2534 >> bitcast<u32>(5i)) << bitcast<u32>((_e2541 & 31u))));
                                                    } else {
                                                        phi_3337_ = _e2443;
                                                    }
                                                    let _e2549 = phi_3337_;
                                                    phi_3338_ = _e2549;
                                                } else {
                                                    phi_3338_ = _e2443;
                                                }
                                                let _e2551 = phi_3338_;
                                                phi_3339_ = _e2551;
                                            } else {
                                                phi_3339_ = _e2443;
                                            }
                                            let _e2553 = phi_3339_;
                                            phi_3209_ = (_e2441 + 1u);
                                            phi_3212_ = _e2553;
                                        } else {
                                            phi_3209_ = u32();
                                            phi_3212_ = u32();
                                        }
                                        let _e2556 = phi_3209_;
                                        let _e2558 = phi_3212_;
                                        continue;
                                        continuing {
                                            phi_3208_ = _e2556;
                                            phi_3211_ = _e2558;
                                            break if !(_e2444);
                                        }
                                    }
                                    let _e2562 = nodes.member[(0u + _e2172)].links[0u];
                                    let _e2566 = nodes.member[(0u + _e2172)].frame[3u];
                                    let _e2570 = local_9;
                                    if ((_e2570 & 4278190080u) == 0u) {
                                    } else {
                                        let _e2574 = local_1.group_mask;
                                        if ((_e2574 & 4278190080u) == 0u) {
                                        } else {
                                            let _e2578 = local_1.len;
                                            if (_e2578 < 32u) {
                                                let _e2581 = local_1.group;
                                                let _e2583 = local_1.len;
                                                if (_e2583 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                local_1.first[(0u + _e2583)] = _e2581;
                                                let _e2589 = local_1.group_mask;
                                                let _e2591 = local_1.len;
                                                if (_e2591 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                local_1.mask[(0u + _e2591)] = _e2589;
                                                let _e2598 = local_1.len;
                                                local_1.len = (_e2598 + 1u);
                                            }
                                        }
                                        local_1.group = (0u + _e2562);
                                        let _e2602 = local_10;
                                        local_1.group_mask = ((_e2602 & 4278190080u) | (_e2566 >> bitcast<u32>(24i)));
                                    }
                                    let _e2607 = local_11;
                                    phi_3397_ = (_e2607 & 16777215u);
                                    phi_3400_ = _e2174;
                                    loop {
                                        let _e2610 = phi_3397_;
                                        let _e2612 = phi_3400_;
                                        local_22 = _e2612;
                                        let _e2613 = (_e2610 == 0u);
                                        local_12 = _e2613;
                                        local_24 = _e2613;
                                        if _e2613 {
                                            phi_3398_ = u32();
                                            phi_3401_ = bool();
                                            phi_4204_ = bool();
                                            phi_4205_ = false;
                                        } else {
                                            let _e2616 = nodes.member[(0u + _e2172)].links[1u];
                                            let _e2621 = ((0u + _e2616) + select(firstTrailingBit(_e2610), 32u, (_e2610 == 0u)));
                                            if (_e2621 < _e95) {
                                            } else {
                                                return;
                                            }
                                            let _e2628 = triangles.member[(0u + _e2621)].v0_;
                                            let _e2630 = (_e2628.x - _e278);
                                            let _e2632 = (_e2628.y - _e280);
                                            let _e2634 = (_e2628.z - _e282);
                                            if (_e2007 == 0u) {
                                                phi_3445_ = vec3<f32>(_e2632, _e2634, _e2630);
                                            } else {
                                                if (_e2007 == 1u) {
                                                    phi_3444_ = vec3<f32>(_e2634, _e2630, _e2632);
                                                } else {
                                                    phi_3444_ = (_e2628 - vec3<f32>(_e278, _e280, _e282));
                                                }
                                                let _e2642 = phi_3444_;
                                                phi_3445_ = _e2642;
                                            }
                                            let _e2644 = phi_3445_;
                                            let _e2648 = (_e2644.x - (_e2018 * _e2644.z));
                                            let _e2652 = (_e2644.y - (_e2021 * _e2644.z));
                                            let _e2654 = triangles.member[(0u + _e2621)].v1_;
                                            let _e2656 = (_e2654.x - _e278);
                                            let _e2658 = (_e2654.y - _e280);
                                            let _e2660 = (_e2654.z - _e282);
                                            if (_e2007 == 0u) {
                                                phi_3475_ = vec3<f32>(_e2658, _e2660, _e2656);
                                            } else {
                                                if (_e2007 == 1u) {
                                                    phi_3474_ = vec3<f32>(_e2660, _e2656, _e2658);
                                                } else {
                                                    phi_3474_ = (_e2654 - vec3<f32>(_e278, _e280, _e282));
                                                }
                                                let _e2668 = phi_3474_;
                                                phi_3475_ = _e2668;
                                            }
                                            let _e2670 = phi_3475_;
                                            let _e2674 = (_e2670.x - (_e2018 * _e2670.z));
                                            let _e2678 = (_e2670.y - (_e2021 * _e2670.z));
                                            let _e2680 = triangles.member[(0u + _e2621)].v2_;
                                            let _e2682 = (_e2680.x - _e278);
                                            let _e2684 = (_e2680.y - _e280);
                                            let _e2686 = (_e2680.z - _e282);
                                            if (_e2007 == 0u) {
                                                phi_3505_ = vec3<f32>(_e2684, _e2686, _e2682);
                                            } else {
                                                if (_e2007 == 1u) {
                                                    phi_3504_ = vec3<f32>(_e2686, _e2682, _e2684);
                                                } else {
                                                    phi_3504_ = (_e2680 - vec3<f32>(_e278, _e280, _e282));
                                                }
                                                let _e2694 = phi_3504_;
                                                phi_3505_ = _e2694;
                                            }
                                            let _e2696 = phi_3505_;
                                            let _e2700 = (_e2696.x - (_e2018 * _e2696.z));
                                            let _e2704 = (_e2696.y - (_e2021 * _e2696.z));
                                            if (_e2674 < _e2700) {
                                                phi_3524_ = true;
                                            } else {
                                                if (_e2674 == _e2700) {
                                                    phi_3523_ = (_e2678 < _e2704);
                                                } else {
                                                    phi_3523_ = false;
                                                }
                                                let _e2709 = phi_3523_;
                                                phi_3524_ = _e2709;
                                            }
                                            let _e2711 = phi_3524_;
                                            if _e2711 {
                                                phi_3528_ = _e2704;
                                                phi_3529_ = _e2700;
                                                phi_3530_ = _e2678;
                                                phi_3531_ = _e2674;
                                            } else {
                                                phi_3528_ = _e2678;
                                                phi_3529_ = _e2674;
                                                phi_3530_ = _e2704;
                                                phi_3531_ = _e2700;
                                            }
                                            let _e2713 = phi_3528_;
                                            let _e2715 = phi_3529_;
                                            let _e2717 = phi_3530_;
                                            let _e2719 = phi_3531_;
                                            let _e2722 = ((_e2719 * _e2713) - (_e2717 * _e2715));
                                            if _e2711 {
                                                phi_3539_ = -(_e2722);
                                            } else {
                                                phi_3539_ = _e2722;
                                            }
                                            let _e2725 = phi_3539_;
                                            if (_e2700 < _e2648) {
                                                phi_3550_ = true;
                                            } else {
                                                if (_e2700 == _e2648) {
                                                    phi_3549_ = (_e2704 < _e2652);
                                                } else {
                                                    phi_3549_ = false;
                                                }
                                                let _e2730 = phi_3549_;
                                                phi_3550_ = _e2730;
                                            }
                                            let _e2732 = phi_3550_;
                                            if _e2732 {
                                                phi_3554_ = _e2652;
                                                phi_3555_ = _e2648;
                                                phi_3556_ = _e2704;
                                                phi_3557_ = _e2700;
                                            } else {
                                                phi_3554_ = _e2704;
                                                phi_3555_ = _e2700;
                                                phi_3556_ = _e2652;
                                                phi_3557_ = _e2648;
                                            }
                                            let _e2734 = phi_3554_;
                                            let _e2736 = phi_3555_;
                                            let _e2738 = phi_3556_;
                                            let _e2740 = phi_3557_;
                                            let _e2743 = ((_e2740 * _e2734) - (_e2738 * _e2736));
                                            if _e2732 {
                                                phi_3565_ = -(_e2743);
                                            } else {
                                                phi_3565_ = _e2743;
                                            }
                                            let _e2746 = phi_3565_;
                                            if (_e2648 < _e2674) {
                                                phi_3576_ = true;
                                            } else {
                                                if (_e2648 == _e2674) {
                                                    phi_3575_ = (_e2652 < _e2678);
                                                } else {
                                                    phi_3575_ = false;
                                                }
                                                let _e2751 = phi_3575_;
                                                phi_3576_ = _e2751;
                                            }
                                            let _e2753 = phi_3576_;
                                            if _e2753 {
                                                phi_3580_ = _e2678;
                                                phi_3581_ = _e2674;
                                                phi_3582_ = _e2652;
                                                phi_3583_ = _e2648;
                                            } else {
                                                phi_3580_ = _e2652;
                                                phi_3581_ = _e2648;
                                                phi_3582_ = _e2678;
                                                phi_3583_ = _e2674;
                                            }
                                            let _e2755 = phi_3580_;
                                            let _e2757 = phi_3581_;
                                            let _e2759 = phi_3582_;
                                            let _e2761 = phi_3583_;
                                            let _e2764 = ((_e2761 * _e2755) - (_e2759 * _e2757));
                                            if _e2753 {
                                                phi_3591_ = -(_e2764);
                                            } else {
                                                phi_3591_ = _e2764;
                                            }
                                            let _e2767 = phi_3591_;
                                            if (_e2725 >= 0f) {
                                                if (_e2746 >= 0f) {
                                                    if (_e2767 >= 0f) {
                                                        phi_3606_ = ((_e2725 + _e2746) + _e2767);
                                                        phi_3607_ = false;
                                                    } else {
                                                        phi_3606_ = f32();
                                                        phi_3607_ = true;
                                                    }
                                                    let _e2774 = phi_3606_;
                                                    let _e2776 = phi_3607_;
                                                    phi_3608_ = _e2774;
                                                    phi_3609_ = _e2776;
                                                } else {
                                                    phi_3608_ = f32();
                                                    phi_3609_ = true;
                                                }
                                                let _e2778 = phi_3608_;
                                                let _e2780 = phi_3609_;
                                                phi_3610_ = _e2778;
                                                phi_3611_ = _e2780;
                                            } else {
                                                phi_3610_ = f32();
                                                phi_3611_ = true;
                                            }
                                            let _e2782 = phi_3610_;
                                            let _e2784 = phi_3611_;
                                            if _e2784 {
                                                if (_e2725 <= 0f) {
                                                    if (_e2746 <= 0f) {
                                                        let _e2787 = (_e2767 <= 0f);
                                                        if _e2787 {
                                                        }
                                                        phi_3629_ = ((_e2725 + _e2746) + _e2767);
                                                        phi_3630_ = false;
                                                        phi_3631_ = _e2787;
                                                    } else {
                                                        phi_3629_ = f32();
                                                        phi_3630_ = true;
                                                        phi_3631_ = false;
                                                    }
                                                    let _e2791 = phi_3629_;
                                                    let _e2793 = phi_3630_;
                                                    let _e2795 = phi_3631_;
                                                    phi_3632_ = _e2791;
                                                    phi_3633_ = _e2793;
                                                    phi_3634_ = _e2795;
                                                } else {
                                                    phi_3632_ = f32();
                                                    phi_3633_ = true;
                                                    phi_3634_ = false;
                                                }
                                                let _e2797 = phi_3632_;
                                                let _e2799 = phi_3633_;
                                                let _e2801 = phi_3634_;
                                                if _e2799 {
                                                    phi_3638_ = false;
                                                } else {
                                                    phi_3638_ = _e2801;
                                                }
                                                let _e2803 = phi_3638_;
                                                phi_3639_ = _e2797;
                                                phi_3640_ = _e2803;
                                            } else {
                                                phi_3639_ = _e2782;
                                                phi_3640_ = true;
                                            }
                                            let _e2805 = phi_3639_;
                                            let _e2807 = phi_3640_;
                                            if _e2807 {
                                                let _e2808 = (_e2805 == 0f);
                                                if _e2808 {
                                                    phi_3956_ = lt_bvh_triangle_Intersection();
                                                    phi_3957_ = false;
                                                } else {
                                                    let _e2810 = triangles.member[(0u + _e2621)].v0_;
                                                    let _e2812 = (_e2810.x - _e278);
                                                    let _e2814 = (_e2810.y - _e280);
                                                    let _e2816 = (_e2810.z - _e282);
                                                    if (_e2007 == 0u) {
                                                        phi_3669_ = vec3<f32>(_e2814, _e2816, _e2812);
                                                    } else {
                                                        if (_e2007 == 1u) {
                                                            phi_3668_ = vec3<f32>(_e2816, _e2812, _e2814);
                                                        } else {
                                                            phi_3668_ = (_e2810 - vec3<f32>(_e278, _e280, _e282));
                                                        }
                                                        let _e2824 = phi_3668_;
                                                        phi_3669_ = _e2824;
                                                    }
                                                    let _e2826 = phi_3669_;
                                                    let _e2828 = triangles.member[(0u + _e2621)].v1_;
                                                    let _e2830 = triangles.member[(0u + _e2621)].v0_;
                                                    let _e2833 = (_e2828.x - _e2830.x);
                                                    let _e2836 = (_e2828.y - _e2830.y);
                                                    let _e2839 = (_e2828.z - _e2830.z);
                                                    if (_e2007 == 0u) {
                                                        phi_3695_ = vec3<f32>(_e2836, _e2839, _e2833);
                                                    } else {
                                                        if (_e2007 == 1u) {
                                                            phi_3694_ = vec3<f32>(_e2839, _e2833, _e2836);
                                                        } else {
                                                            phi_3694_ = (_e2828 - _e2830);
                                                        }
                                                        let _e2846 = phi_3694_;
                                                        phi_3695_ = _e2846;
                                                    }
                                                    let _e2848 = phi_3695_;
                                                    let _e2850 = triangles.member[(0u + _e2621)].v2_;
                                                    let _e2852 = triangles.member[(0u + _e2621)].v0_;
                                                    let _e2855 = (_e2850.x - _e2852.x);
                                                    let _e2858 = (_e2850.y - _e2852.y);
                                                    let _e2861 = (_e2850.z - _e2852.z);
                                                    if (_e2007 == 0u) {
                                                        phi_3721_ = vec3<f32>(_e2858, _e2861, _e2855);
                                                    } else {
                                                        if (_e2007 == 1u) {
                                                            phi_3720_ = vec3<f32>(_e2861, _e2855, _e2858);
                                                        } else {
                                                            phi_3720_ = (_e2850 - _e2852);
                                                        }
                                                        let _e2868 = phi_3720_;
                                                        phi_3721_ = _e2868;
                                                    }
                                                    let _e2870 = phi_3721_;
                                                    let _e2877 = ((_e2848.y * _e2870.z) - (_e2848.z * _e2870.y));
                                                    let _e2884 = ((_e2848.z * _e2870.x) - (_e2848.x * _e2870.z));
                                                    let _e2891 = ((_e2848.x * _e2870.y) - (_e2848.y * _e2870.x));
                                                    let _e2905 = (((1f / _e2015.z) * (((_e2877 * _e2826.x) + (_e2884 * _e2826.y)) + (_e2891 * _e2826.z))) / (((_e2877 * _e2018) + (_e2884 * _e2021)) + _e2891));
                                                    if (_e2905 > 0f) {
                                                        if (_e2905 < _e290) {
                                                            let _e2909 = triangles.member[(0u + _e2621)].v0_;
                                                            let _e2911 = triangles.member[(0u + _e2621)].v1_;
                                                            if (_e2909.x < _e2911.x) {
                                                                phi_3777_ = _e2909.x;
                                                            } else {
                                                                phi_3777_ = _e2911.x;
                                                            }
                                                            let _e2918 = phi_3777_;
                                                            if (_e2909.y < _e2911.y) {
                                                                phi_3786_ = _e2909.y;
                                                            } else {
                                                                phi_3786_ = _e2911.y;
                                                            }
                                                            let _e2925 = phi_3786_;
                                                            if (_e2909.z < _e2911.z) {
                                                                phi_3795_ = _e2909.z;
                                                            } else {
                                                                phi_3795_ = _e2911.z;
                                                            }
                                                            let _e2932 = phi_3795_;
                                                            let _e2934 = triangles.member[(0u + _e2621)].v2_;
                                                            if (_e2918 < _e2934.x) {
                                                                phi_3804_ = _e2918;
                                                            } else {
                                                                phi_3804_ = _e2934.x;
                                                            }
                                                            let _e2939 = phi_3804_;
                                                            if (_e2925 < _e2934.y) {
                                                                phi_3811_ = _e2925;
                                                            } else {
                                                                phi_3811_ = _e2934.y;
                                                            }
                                                            let _e2944 = phi_3811_;
                                                            if (_e2932 < _e2934.z) {
                                                                phi_3818_ = _e2932;
                                                            } else {
                                                                phi_3818_ = _e2934.z;
                                                            }
                                                            let _e2949 = phi_3818_;
                                                            let _e2951 = triangles.member[(0u + _e2621)].v0_;
                                                            let _e2953 = triangles.member[(0u + _e2621)].v1_;
                                                            if (_e2951.x > _e2953.x) {
                                                                phi_3831_ = _e2951.x;
                                                            } else {
                                                                phi_3831_ = _e2953.x;
                                                            }
                                                            let _e2960 = phi_3831_;
                                                            if (_e2951.y > _e2953.y) {
                                                                phi_3840_ = _e2951.y;
                                                            } else {
                                                                phi_3840_ = _e2953.y;
                                                            }
                                                            let _e2967 = phi_3840_;
                                                            if (_e2951.z > _e2953.z) {
                                                                phi_3849_ = _e2951.z;
                                                            } else {
                                                                phi_3849_ = _e2953.z;
                                                            }
                                                            let _e2974 = phi_3849_;
                                                            let _e2976 = triangles.member[(0u + _e2621)].v2_;
                                                            if (_e2960 > _e2976.x) {
                                                                phi_3858_ = _e2960;
                                                            } else {
                                                                phi_3858_ = _e2976.x;
                                                            }
                                                            let _e2981 = phi_3858_;
                                                            if (_e2967 > _e2976.y) {
                                                                phi_3865_ = _e2967;
                                                            } else {
                                                                phi_3865_ = _e2976.y;
                                                            }
                                                            let _e2986 = phi_3865_;
                                                            if (_e2974 > _e2976.z) {
                                                                phi_3872_ = _e2974;
                                                            } else {
                                                                phi_3872_ = _e2976.z;
                                                            }
                                                            let _e2991 = phi_3872_;
                                                            let _e2995 = ((_e2939 - _e278) * _e1932);
                                                            let _e2996 = ((_e2944 - _e280) * _e1942);
                                                            let _e2997 = ((_e2949 - _e282) * _e1952);
                                                            let _e3001 = ((_e2981 - _e278) * _e1932);
                                                            let _e3002 = ((_e2986 - _e280) * _e1942);
                                                            let _e3003 = ((_e2991 - _e282) * _e1952);
                                                            if (_e2995 < _e3001) {
                                                                phi_3889_ = _e2995;
                                                            } else {
                                                                phi_3889_ = _e3001;
                                                            }
                                                            let _e3006 = phi_3889_;
                                                            if (_e2996 < _e3002) {
                                                                phi_3894_ = _e2996;
                                                            } else {
                                                                phi_3894_ = _e3002;
                                                            }
                                                            let _e3009 = phi_3894_;
                                                            if (_e2997 < _e3003) {
                                                                phi_3899_ = _e2997;
                                                            } else {
                                                                phi_3899_ = _e3003;
                                                            }
                                                            let _e3012 = phi_3899_;
                                                            if (_e2995 > _e3001) {
                                                                phi_3907_ = _e2995;
                                                            } else {
                                                                phi_3907_ = _e3001;
                                                            }
                                                            let _e3018 = phi_3907_;
                                                            if (_e2996 > _e3002) {
                                                                phi_3912_ = _e2996;
                                                            } else {
                                                                phi_3912_ = _e3002;
                                                            }
                                                            let _e3021 = phi_3912_;
                                                            if (_e2997 > _e3003) {
                                                                phi_3917_ = _e2997;
                                                            } else {
                                                                phi_3917_ = _e3003;
                                                            }
                                                            let _e3024 = phi_3917_;
                                                            let _e3028 = core_intrinsics_maximum_number_nsz_f32_((_e3006 - _e1991), (_e3009 - _e1992));
                                                            let _e3029 = core_intrinsics_maximum_number_nsz_f32_(_e3028, (_e3012 - _e1993));
                                                            let _e3030 = core_intrinsics_minimum_number_nsz_f32_((_e3018 + _e1991), (_e3021 + _e1992));
                                                            let _e3031 = core_intrinsics_minimum_number_nsz_f32_(_e3030, (_e3024 + _e1993));
                                                            if (_e3029 > -300000000000000000000000000000000000000f) {
                                                                phi_3929_ = _e3029;
                                                            } else {
                                                                phi_3929_ = -300000000000000000000000000000000000000f;
                                                            }
                                                            let _e3034 = phi_3929_;
                                                            if (_e3031 < 300000000000000000000000000000000000000f) {
                                                                phi_3934_ = _e3031;
                                                            } else {
                                                                phi_3934_ = 300000000000000000000000000000000000000f;
                                                            }
                                                            let _e3037 = phi_3934_;
                                                            if (_e2905 < _e3034) {
                                                                phi_3939_ = _e3034;
                                                            } else {
                                                                phi_3939_ = _e2905;
                                                            }
                                                            let _e3040 = phi_3939_;
                                                            if (_e3040 > _e3037) {
                                                                phi_3944_ = _e3037;
                                                            } else {
                                                                phi_3944_ = _e3040;
                                                            }
                                                            let _e3043 = phi_3944_;
                                                            phi_3949_ = lt_bvh_triangle_Intersection(_e3043, (_e2746 / _e2805), (_e2767 / _e2805), (_e3034 <= _e3037));
                                                            phi_3950_ = false;
                                                        } else {
                                                            phi_3949_ = lt_bvh_triangle_Intersection();
                                                            phi_3950_ = true;
                                                        }
                                                        let _e3049 = phi_3949_;
                                                        let _e3051 = phi_3950_;
                                                        phi_3951_ = _e3049;
                                                        phi_3952_ = _e3051;
                                                    } else {
                                                        phi_3951_ = lt_bvh_triangle_Intersection();
                                                        phi_3952_ = true;
                                                    }
                                                    let _e3053 = phi_3951_;
                                                    let _e3055 = phi_3952_;
                                                    if _e3055 {
                                                    }
                                                    phi_3956_ = _e3053;
                                                    phi_3957_ = _e3055;
                                                }
                                                let _e3057 = phi_3956_;
                                                let _e3059 = phi_3957_;
                                                phi_3958_ = _e3057;
                                                phi_3959_ = _e2808;
                                                phi_3960_ = _e3059;
                                            } else {
                                                phi_3958_ = lt_bvh_triangle_Intersection();
                                                phi_3959_ = true;
                                                phi_3960_ = false;
                                            }
                                            let _e3061 = phi_3958_;
                                            let _e3063 = phi_3959_;
                                            let _e3065 = phi_3960_;
                                            if _e3063 {
                                                phi_3964_ = true;
                                            } else {
                                                phi_3964_ = _e3065;
                                            }
                                            let _e3067 = phi_3964_;
                                            if _e3067 {
                                                phi_3968_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                            } else {
                                                phi_3968_ = _e3061;
                                            }
                                            let _e3069 = phi_3968_;
                                            if _e3069.is_hit {
                                                if (_e3069.t > 0f) {
                                                    if (_e3069.t < _e290) {
                                                        let _e3076 = triangles.member[(0u + _e2621)].i0_;
                                                        if ((_e3076 & 2147483648u) == 0u) {
                                                            phi_4187_ = true;
                                                        } else {
                                                            if (_e2621 < _e95) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e3085 = triangles.member[(0u + _e2621)].i0_;
                                                            let _e3086 = (_e3085 & 2147483647u);
                                                            let _e3088 = triangles.member[(0u + _e2621)].i1_;
                                                            let _e3090 = triangles.member[(0u + _e2621)].i2_;
                                                            if (_e3086 < _e105) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e3094 = vertices.member[(0u + _e3086)];
                                                            if (_e3088 < _e105) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e3098 = vertices.member[(0u + _e3088)];
                                                            if (_e3090 < _e105) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e3102 = vertices.member[(0u + _e3090)];
                                                            let _e3103 = array<abi_Vertex, 3>(_e3094, _e3098, _e3102);
                                                            if (_e3103[0].material < _e108) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e3109 = materials.member[(0u + _e3103[0].material)];
                                                            if ((_e3109.flags & 1u) == 1u) {
                                                                let _e3114 = ((1f - _e3069.u) - _e3069.v);
                                                                if (_e3109.cutoff <= 0f) {
                                                                    phi_4185_ = true;
                                                                } else {
                                                                    let _e3141 = (_e3109.base_color.w * ((((f32((_e3103[0].color >> bitcast<u32>(24i))) * _e3114) + (f32((_e3103[1].color >> bitcast<u32>(24i))) * _e3069.u)) + (f32((_e3103[2].color >> bitcast<u32>(24i))) * _e3069.v)) * (1f / 255f)));
                                                                    if (_e3109.alpha_size == 0u) {
                                                                        phi_4182_ = _e3141;
                                                                    } else {
                                                                        local.offset = _e3109.alpha_offset;
                                                                        local.size = _e3109.alpha_size;
                                                                        local.flags = _e3109.flags;
                                                                        let _e3172 = _lt_shaders_texture_TextureView_quad((&local), (((_e3103[0].u * _e3114) + (_e3103[1].u * _e3069.u)) + (_e3103[2].u * _e3069.v)), (((_e3103[0].v * _e3114) + (_e3103[1].v * _e3069.u)) + (_e3103[2].v * _e3069.v)));
                                                                        let _e3176 = (_e3172.indices[0] >> bitcast<u32>(2i));
                                                                        if (_e3176 < _e111) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e3180 = alpha_texels.member[(0u + _e3176)];
                                                                        let _e3196 = (_e3172.indices[1] >> bitcast<u32>(2i));
                                                                        if (_e3196 < _e111) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e3200 = alpha_texels.member[(0u + _e3196)];
                                                                        let _e3217 = (_e3172.indices[2] >> bitcast<u32>(2i));
                                                                        if (_e3217 < _e111) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e3221 = alpha_texels.member[(0u + _e3217)];
                                                                        let _e3238 = (_e3172.indices[3] >> bitcast<u32>(2i));
                                                                        if (_e3238 < _e111) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e3242 = alpha_texels.member[(0u + _e3238)];
                                                                        phi_4182_ = (_e3141 * (((((f32(((_e3180 >> bitcast<u32>((((_e3172.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3172.weights.x) + ((f32(((_e3200 >> bitcast<u32>((((_e3172.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3172.weights.y)) + ((f32(((_e3221 >> bitcast<u32>((((_e3172.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3172.weights.z)) + ((f32(((_e3242 >> bitcast<u32>((((_e3172.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3172.weights.w)));
                                                                    }
                                                                    let _e3258 = phi_4182_;
                                                                    phi_4185_ = (_e3258 >= _e3109.cutoff);
                                                                }
                                                                let _e3262 = phi_4185_;
                                                                phi_4186_ = _e3262;
                                                            } else {
                                                                phi_4186_ = false;
                                                            }
                                                            let _e3264 = phi_4186_;
                                                            phi_4187_ = _e3264;
                                                        }
                                                        let _e3266 = phi_4187_;
                                                        if _e3266 {
                                                            phi_4191_ = false;
                                                        } else {
                                                            phi_4191_ = true;
                                                        }
                                                        let _e3268 = phi_4191_;
                                                        phi_4192_ = _e3266;
                                                        phi_4193_ = _e3266;
                                                        phi_4194_ = _e3268;
                                                    } else {
                                                        phi_4192_ = bool();
                                                        phi_4193_ = _e2612;
                                                        phi_4194_ = true;
                                                    }
                                                    let _e3270 = phi_4192_;
                                                    let _e3272 = phi_4193_;
                                                    let _e3274 = phi_4194_;
                                                    phi_4195_ = _e3270;
                                                    phi_4196_ = _e3272;
                                                    phi_4197_ = _e3274;
                                                } else {
                                                    phi_4195_ = bool();
                                                    phi_4196_ = _e2612;
                                                    phi_4197_ = true;
                                                }
                                                let _e3276 = phi_4195_;
                                                let _e3278 = phi_4196_;
                                                let _e3280 = phi_4197_;
                                                phi_4198_ = _e3276;
                                                phi_4199_ = _e3278;
                                                phi_4200_ = _e3280;
                                            } else {
                                                phi_4198_ = bool();
                                                phi_4199_ = _e2612;
                                                phi_4200_ = true;
                                            }
                                            let _e3282 = phi_4198_;
                                            let _e3284 = phi_4199_;
                                            let _e3286 = phi_4200_;
                                            if _e3286 {
                                            }
                                            phi_3398_ = (_e2610 & (_e2610 - 1u));
                                            phi_3401_ = _e3284;
                                            phi_4204_ = _e3282;
                                            phi_4205_ = _e3286;
                                        }
                                        let _e3288 = phi_3398_;
                                        let _e3290 = phi_3401_;
                                        let _e3292 = phi_4204_;
                                        let _e3294 = phi_4205_;
                                        local_23 = _e3292;
                                        continue;
                                        continuing {
                                            phi_3397_ = _e3288;
                                            phi_3400_ = _e3290;
                                            break if !(_e3294);
                                        }
                                    }
                                    let _e3297 = local_12;
                                    if _e3297 {
                                        let _e3299 = local_1.group_mask;
                                        if ((_e3299 & 4278190080u) == 0u) {
                                            let _e3303 = local_1.len;
                                            if (_e3303 == 0u) {
                                                phi_4247_ = false;
                                            } else {
                                                let _e3307 = local_1.len;
                                                local_1.len = (_e3307 - 1u);
                                                let _e3310 = local_1.len;
                                                if (_e3310 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3315 = local_1.first[(0u + _e3310)];
                                                local_1.group = _e3315;
                                                let _e3318 = local_1.len;
                                                if (_e3318 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3323 = local_1.mask[(0u + _e3318)];
                                                local_1.group_mask = _e3323;
                                                phi_4247_ = true;
                                            }
                                            let _e3326 = phi_4247_;
                                            phi_4248_ = _e3326;
                                        } else {
                                            phi_4248_ = true;
                                        }
                                        let _e3328 = phi_4248_;
                                        if _e3328 {
                                            let _e3330 = local_1.group_mask;
                                            let _e3336 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e3330)), 32u, (_e3330 == 0u)));
                                            let _e3340 = local_1.group_mask;
                                            let _e3354 = local_1.group_mask;
                                            local_1.group_mask = (_e3354 & ~((1u << bitcast<u32>((_e3336 & 31u)))));
                                            let _e3357 = local_1.group;
                                            phi_4279_ = (_e3357 + countOneBits(((_e3340 & ~((4294967295u << bitcast<u32>((((_e3336 - 24u) ^ _e2034) & 31u))))) & 255u)));
                                        } else {
                                            phi_4279_ = 4294967295u;
                                        }
                                        let _e3360 = phi_4279_;
                                        phi_4280_ = _e3360;
                                    } else {
                                        phi_4280_ = u32();
                                    }
                                    let _e3362 = phi_4280_;
                                    phi_3066_ = _e3362;
                                    let _e3835 = local_22;
                                    phi_3069_ = _e3835;
                                    let _e3838 = local_23;
                                    phi_4281_ = _e3838;
                                    let _e3841 = local_24;
                                    phi_4282_ = _e3841;
                                    phi_4283_ = false;
                                } else {
                                    phi_3066_ = u32();
                                    phi_3069_ = bool();
                                    phi_4281_ = bool();
                                    phi_4282_ = false;
                                    phi_4283_ = true;
                                }
                                let _e3364 = phi_3066_;
                                let _e3366 = phi_3069_;
                                let _e3368 = phi_4281_;
                                let _e3370 = phi_4282_;
                                let _e3372 = phi_4283_;
                                local_13 = _e3372;
                                local_25 = _e3368;
                                continue;
                                continuing {
                                    phi_3065_ = _e3364;
                                    phi_3068_ = _e3366;
                                    break if !(_e3370);
                                }
                            }
                            let _e3375 = local_13;
                            if _e3375 {
                                phi_4287_ = false;
                            } else {
                                phi_4287_ = true;
                            }
                            let _e3377 = phi_4287_;
                            if _e3377 {
                                let _e3847 = local_25;
                                phi_4291_ = _e3847;
                            } else {
                                let _e3849 = local_26;
                                phi_4291_ = _e3849;
                            }
                            let _e3379 = phi_4291_;
                            phi_4292_ = _e3379;
                        }
                        let _e3381 = phi_4292_;
                        phi_4293_ = _e3381;
                        phi_4294_ = _e1856;
                    } else {
                        phi_4293_ = bool();
                        phi_4294_ = true;
                    }
                    let _e3383 = phi_4293_;
                    let _e3385 = phi_4294_;
                    if _e3385 {
                        phi_4298_ = false;
                    } else {
                        phi_4298_ = _e3383;
                    }
                    let _e3387 = phi_4298_;
                    phi_4299_ = _e3387;
                }
                let _e3389 = phi_4299_;
                phi_4300_ = _e3389;
            } else {
                phi_4300_ = false;
            }
            let _e3391 = phi_4300_;
            if _e3391 {
                phi_4304_ = 0f;
            } else {
                phi_4304_ = 1f;
            }
            let _e3393 = phi_4304_;
            phi_4305_ = _e3393;
        }
        let _e3395 = phi_4305_;
        if (_e117.shift < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e117.shift)] = _e3395;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_light_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
