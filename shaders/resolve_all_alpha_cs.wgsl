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
@group(0) @binding(7) 
var<storage> alpha_texels: type_13;
@group(0) @binding(5) 
var<storage> vertices: type_50;
@group(0) @binding(6) 
var<storage> materials: type_54;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_222_: lt_mask_LightPlace;
    var phi_223_: bool;
    var phi_224_: lt_mask_LightPlace;
    var phi_225_: bool;
    var phi_230_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_222_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_223_ = false;
        } else {
            phi_222_ = lt_mask_LightPlace();
            phi_223_ = true;
        }
        let _e81 = phi_222_;
        let _e83 = phi_223_;
        phi_224_ = _e81;
        phi_225_ = _e83;
    } else {
        phi_224_ = lt_mask_LightPlace();
        phi_225_ = true;
    }
    let _e85 = phi_224_;
    let _e87 = phi_225_;
    if _e87 {
        phi_230_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_230_ = _e85;
    }
    let _e92 = phi_230_;
    return lt_mask_LightPlace(_e92.word, _e92.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_245_: bool;
    var phi_249_: f32;

    if (param_3 != param_3) {
        phi_245_ = true;
    } else {
        let _e71 = (param_4 >= param_3);
        if _e71 {
        }
        phi_245_ = _e71;
    }
    let _e73 = phi_245_;
    if _e73 {
        phi_249_ = param_4;
    } else {
        phi_249_ = param_3;
    }
    let _e75 = phi_249_;
    return _e75;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_261_: bool;
    var phi_265_: f32;

    if (param_5 != param_5) {
        phi_261_ = true;
    } else {
        let _e71 = (param_6 <= param_5);
        if _e71 {
        }
        phi_261_ = _e71;
    }
    let _e73 = phi_261_;
    if _e73 {
        phi_265_ = param_6;
    } else {
        phi_265_ = param_5;
    }
    let _e75 = phi_265_;
    return _e75;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_307_: f32;
    var phi_312_: f32;
    var phi_313_: bool;
    var phi_314_: f32;
    var phi_315_: bool;
    var phi_319_: f32;
    var phi_345_: f32;
    var phi_350_: f32;
    var phi_351_: bool;
    var phi_352_: f32;
    var phi_353_: bool;
    var phi_357_: f32;
    var phi_365_: f32;
    var phi_366_: f32;
    var phi_367_: f32;
    var phi_376_: f32;
    var phi_377_: f32;
    var phi_395_: u32;
    var phi_409_: u32;
    var phi_416_: u32;
    var phi_421_: u32;
    var phi_427_: u32;
    var phi_432_: u32;
    var phi_434_: texture_Axis;
    var phi_462_: f32;
    var phi_467_: f32;
    var phi_468_: bool;
    var phi_469_: f32;
    var phi_470_: bool;
    var phi_474_: f32;
    var phi_500_: f32;
    var phi_505_: f32;
    var phi_506_: bool;
    var phi_507_: f32;
    var phi_508_: bool;
    var phi_512_: f32;
    var phi_520_: f32;
    var phi_521_: f32;
    var phi_522_: f32;
    var phi_531_: f32;
    var phi_532_: f32;
    var phi_550_: u32;
    var phi_564_: u32;
    var phi_571_: u32;
    var phi_576_: u32;
    var phi_582_: u32;
    var phi_587_: u32;
    var phi_589_: texture_Axis;

    let _e72 = (*param_7).size;
    let _e73 = (_e72 & 65535u);
    let _e75 = (*param_7).size;
    let _e77 = (_e75 >> bitcast<u32>(16i));
    let _e79 = (*param_7).flags;
    let _e81 = ((_e79 & 4u) != 0u);
    let _e83 = (*param_7).flags;
    let _e86 = ((_e83 >> bitcast<u32>(4u)) & 3u);
    if (_e86 == 0u) {
        if (param_8 > -8388608f) {
            let _e99 = f32(select(0i, select(select(i32(param_8), i32(-2147483648), (param_8 < bitcast<f32>(3472883712u))), 2147483647i, (param_8 > bitcast<f32>(1325400063u))), (param_8 == param_8)));
            if (_e99 > param_8) {
                phi_307_ = 1f;
            } else {
                phi_307_ = 0f;
            }
            let _e102 = phi_307_;
            if (param_8 < 8388608f) {
                phi_312_ = (_e99 - _e102);
                phi_313_ = false;
            } else {
                phi_312_ = f32();
                phi_313_ = true;
            }
            let _e105 = phi_312_;
            let _e107 = phi_313_;
            phi_314_ = _e105;
            phi_315_ = _e107;
        } else {
            phi_314_ = f32();
            phi_315_ = true;
        }
        let _e109 = phi_314_;
        let _e111 = phi_315_;
        if _e111 {
            phi_319_ = param_8;
        } else {
            phi_319_ = _e109;
        }
        let _e113 = phi_319_;
        phi_367_ = (param_8 - _e113);
    } else {
        if (_e86 == 1u) {
            let _e116 = (param_8 * 0.5f);
            if (_e116 > -8388608f) {
                let _e128 = f32(select(0i, select(select(i32(_e116), i32(-2147483648), (_e116 < bitcast<f32>(3472883712u))), 2147483647i, (_e116 > bitcast<f32>(1325400063u))), (_e116 == _e116)));
                if (_e128 > _e116) {
                    phi_345_ = 1f;
                } else {
                    phi_345_ = 0f;
                }
                let _e131 = phi_345_;
                if (_e116 < 8388608f) {
                    phi_350_ = (_e128 - _e131);
                    phi_351_ = false;
                } else {
                    phi_350_ = f32();
                    phi_351_ = true;
                }
                let _e134 = phi_350_;
                let _e136 = phi_351_;
                phi_352_ = _e134;
                phi_353_ = _e136;
            } else {
                phi_352_ = f32();
                phi_353_ = true;
            }
            let _e138 = phi_352_;
            let _e140 = phi_353_;
            if _e140 {
                phi_357_ = _e116;
            } else {
                phi_357_ = _e138;
            }
            let _e142 = phi_357_;
            let _e144 = (param_8 - (2f * _e142));
            if (_e144 > 1f) {
                phi_365_ = (2f - _e144);
            } else {
                phi_365_ = _e144;
            }
            let _e148 = phi_365_;
            phi_366_ = _e148;
        } else {
            phi_366_ = param_8;
        }
        let _e150 = phi_366_;
        phi_367_ = _e150;
    }
    let _e152 = phi_367_;
    if (_e152 > 0f) {
        if (_e152 < 1f) {
            phi_376_ = _e152;
        } else {
            phi_376_ = 1f;
        }
        let _e156 = phi_376_;
        phi_377_ = _e156;
    } else {
        phi_377_ = 0f;
    }
    let _e158 = phi_377_;
    let _e159 = (_e73 - 1u);
    let _e161 = (_e158 * f32(_e73));
    if _e81 {
        let _e168 = select(select(u32(_e161), 0u, (_e161 < bitcast<f32>(0u))), 4294967295u, (_e161 > bitcast<f32>(1333788671u)));
        if (_e159 < _e168) {
            phi_395_ = _e159;
        } else {
            phi_395_ = _e168;
        }
        let _e171 = phi_395_;
        phi_434_ = texture_Axis(_e171, _e171, 0f);
    } else {
        let _e173 = (_e161 + 0.5f);
        let _e180 = select(select(u32(_e173), 0u, (_e173 < bitcast<f32>(0u))), 4294967295u, (_e173 > bitcast<f32>(1333788671u)));
        if (_e73 < _e180) {
            phi_409_ = _e73;
        } else {
            phi_409_ = _e180;
        }
        let _e183 = phi_409_;
        if (_e86 == 0u) {
            phi_416_ = _e159;
        } else {
            phi_416_ = 0u;
        }
        let _e188 = phi_416_;
        if (_e86 == 0u) {
            phi_421_ = 0u;
        } else {
            phi_421_ = _e159;
        }
        let _e191 = phi_421_;
        if (_e183 == 0u) {
            phi_427_ = _e188;
        } else {
            phi_427_ = (_e183 - 1u);
        }
        let _e195 = phi_427_;
        if (_e183 > _e159) {
            phi_432_ = _e191;
        } else {
            phi_432_ = _e183;
        }
        let _e198 = phi_432_;
        phi_434_ = texture_Axis(_e195, _e198, (_e173 - f32(_e183)));
    }
    let _e201 = phi_434_;
    let _e203 = (*param_7).flags;
    let _e206 = ((_e203 >> bitcast<u32>(6u)) & 3u);
    if (_e206 == 0u) {
        if (param_9 > -8388608f) {
            let _e219 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e219 > param_9) {
                phi_462_ = 1f;
            } else {
                phi_462_ = 0f;
            }
            let _e222 = phi_462_;
            if (param_9 < 8388608f) {
                phi_467_ = (_e219 - _e222);
                phi_468_ = false;
            } else {
                phi_467_ = f32();
                phi_468_ = true;
            }
            let _e225 = phi_467_;
            let _e227 = phi_468_;
            phi_469_ = _e225;
            phi_470_ = _e227;
        } else {
            phi_469_ = f32();
            phi_470_ = true;
        }
        let _e229 = phi_469_;
        let _e231 = phi_470_;
        if _e231 {
            phi_474_ = param_9;
        } else {
            phi_474_ = _e229;
        }
        let _e233 = phi_474_;
        phi_522_ = (param_9 - _e233);
    } else {
        if (_e206 == 1u) {
            let _e236 = (param_9 * 0.5f);
            if (_e236 > -8388608f) {
                let _e248 = f32(select(0i, select(select(i32(_e236), i32(-2147483648), (_e236 < bitcast<f32>(3472883712u))), 2147483647i, (_e236 > bitcast<f32>(1325400063u))), (_e236 == _e236)));
                if (_e248 > _e236) {
                    phi_500_ = 1f;
                } else {
                    phi_500_ = 0f;
                }
                let _e251 = phi_500_;
                if (_e236 < 8388608f) {
                    phi_505_ = (_e248 - _e251);
                    phi_506_ = false;
                } else {
                    phi_505_ = f32();
                    phi_506_ = true;
                }
                let _e254 = phi_505_;
                let _e256 = phi_506_;
                phi_507_ = _e254;
                phi_508_ = _e256;
            } else {
                phi_507_ = f32();
                phi_508_ = true;
            }
            let _e258 = phi_507_;
            let _e260 = phi_508_;
            if _e260 {
                phi_512_ = _e236;
            } else {
                phi_512_ = _e258;
            }
            let _e262 = phi_512_;
            let _e264 = (param_9 - (2f * _e262));
            if (_e264 > 1f) {
                phi_520_ = (2f - _e264);
            } else {
                phi_520_ = _e264;
            }
            let _e268 = phi_520_;
            phi_521_ = _e268;
        } else {
            phi_521_ = param_9;
        }
        let _e270 = phi_521_;
        phi_522_ = _e270;
    }
    let _e272 = phi_522_;
    if (_e272 > 0f) {
        if (_e272 < 1f) {
            phi_531_ = _e272;
        } else {
            phi_531_ = 1f;
        }
        let _e276 = phi_531_;
        phi_532_ = _e276;
    } else {
        phi_532_ = 0f;
    }
    let _e278 = phi_532_;
    let _e279 = (_e77 - 1u);
    let _e281 = (_e278 * f32(_e77));
    if _e81 {
        let _e288 = select(select(u32(_e281), 0u, (_e281 < bitcast<f32>(0u))), 4294967295u, (_e281 > bitcast<f32>(1333788671u)));
        if (_e279 < _e288) {
            phi_550_ = _e279;
        } else {
            phi_550_ = _e288;
        }
        let _e291 = phi_550_;
        phi_589_ = texture_Axis(_e291, _e291, 0f);
    } else {
        let _e293 = (_e281 + 0.5f);
        let _e300 = select(select(u32(_e293), 0u, (_e293 < bitcast<f32>(0u))), 4294967295u, (_e293 > bitcast<f32>(1333788671u)));
        if (_e77 < _e300) {
            phi_564_ = _e77;
        } else {
            phi_564_ = _e300;
        }
        let _e303 = phi_564_;
        if (_e206 == 0u) {
            phi_571_ = _e279;
        } else {
            phi_571_ = 0u;
        }
        let _e308 = phi_571_;
        if (_e206 == 0u) {
            phi_576_ = 0u;
        } else {
            phi_576_ = _e279;
        }
        let _e311 = phi_576_;
        if (_e303 == 0u) {
            phi_582_ = _e308;
        } else {
            phi_582_ = (_e303 - 1u);
        }
        let _e315 = phi_582_;
        if (_e303 > _e279) {
            phi_587_ = _e311;
        } else {
            phi_587_ = _e303;
        }
        let _e318 = phi_587_;
        phi_589_ = texture_Axis(_e315, _e318, (_e293 - f32(_e303)));
    }
    let _e321 = phi_589_;
    let _e325 = (*param_7).offset;
    let _e332 = (*param_7).offset;
    let _e339 = (*param_7).offset;
    let _e346 = (*param_7).offset;
    return texture_TexelQuad(array<u32, 4>(((_e325 + (_e321.low * _e73)) + _e201.low), ((_e332 + (_e321.low * _e73)) + _e201.high), ((_e339 + (_e321.high * _e73)) + _e201.low), ((_e346 + (_e321.high * _e73)) + _e201.high)), vec4<f32>(((1f - _e201.fraction) * (1f - _e321.fraction)), (_e201.fraction * (1f - _e321.fraction)), ((1f - _e201.fraction) * _e321.fraction), (_e201.fraction * _e321.fraction)));
}

fn _lt_shaders_abi_Sample_is_valid(param_10: ptr<function, abi_Sample>) -> bool {
    var phi_661_: bool;
    var phi_662_: bool;
    var phi_663_: bool;
    var phi_664_: bool;
    var phi_668_: bool;

    let _e71 = (*param_10).normal[0u];
    let _e73 = global[0u];
    if (_e71 == _e73) {
        let _e76 = (*param_10).normal[1u];
        let _e78 = global[1u];
        if (_e76 == _e78) {
            let _e81 = (*param_10).normal[2u];
            let _e83 = global[2u];
            phi_661_ = (_e81 == _e83);
            phi_662_ = false;
        } else {
            phi_661_ = bool();
            phi_662_ = true;
        }
        let _e86 = phi_661_;
        let _e88 = phi_662_;
        phi_663_ = _e86;
        phi_664_ = _e88;
    } else {
        phi_663_ = bool();
        phi_664_ = true;
    }
    let _e90 = phi_663_;
    let _e92 = phi_664_;
    if _e92 {
        phi_668_ = false;
    } else {
        phi_668_ = _e90;
    }
    let _e94 = phi_668_;
    return !(_e94);
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: abi_Sample;
    var phi_787_: bool;
    var phi_788_: bool;
    var phi_799_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_800_: bool;
    var phi_801_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_802_: bool;
    var phi_809_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_813_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_860_: f32;
    var phi_915_: bool;
    var phi_916_: bool;
    var phi_917_: bool;
    var phi_921_: bool;
    var phi_922_: bool;
    var phi_923_: bool;
    var phi_924_: bool;
    var phi_925_: bool;
    var phi_926_: bool;
    var phi_927_: bool;
    var phi_928_: bool;
    var phi_929_: bool;
    var phi_930_: bool;
    var phi_931_: bool;
    var phi_932_: bool;
    var phi_933_: bool;
    var phi_934_: bool;
    var phi_935_: bool;
    var phi_936_: bool;
    var phi_937_: bool;
    var phi_938_: bool;
    var phi_942_: bool;
    var phi_946_: bool;
    var phi_1016_: f32;
    var phi_1023_: f32;
    var phi_1030_: f32;
    var phi_1037_: f32;
    var phi_1044_: f32;
    var phi_1051_: f32;
    var phi_1068_: f32;
    var phi_1073_: f32;
    var phi_1078_: f32;
    var phi_1106_: bool;
    var phi_1107_: bool;
    var phi_1115_: u32;
    var phi_1116_: u32;
    var phi_1127_: vec3<f32>;
    var phi_1128_: vec3<f32>;
    var phi_1141_: u32;
    var phi_1146_: u32;
    var phi_1151_: u32;
    var phi_1265_: bool;
    var phi_1266_: bool;
    var phi_1297_: u32;
    var phi_1299_: u32;
    var phi_1302_: bool;
    var phi_1382_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1409_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1436_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1442_: u32;
    var phi_1445_: u32;
    var phi_1459_: u32;
    var phi_1469_: u32;
    var phi_1479_: u32;
    var phi_1497_: u32;
    var phi_1507_: u32;
    var phi_1517_: u32;
    var phi_1553_: u32;
    var phi_1566_: u32;
    var phi_1571_: u32;
    var phi_1572_: u32;
    var phi_1573_: u32;
    var phi_1443_: u32;
    var phi_1446_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1631_: u32;
    var phi_1634_: bool;
    var phi_1678_: vec3<f32>;
    var phi_1679_: vec3<f32>;
    var phi_1708_: vec3<f32>;
    var phi_1709_: vec3<f32>;
    var phi_1738_: vec3<f32>;
    var phi_1739_: vec3<f32>;
    var phi_1757_: bool;
    var phi_1758_: bool;
    var phi_1762_: f32;
    var phi_1763_: f32;
    var phi_1764_: f32;
    var phi_1765_: f32;
    var phi_1773_: f32;
    var phi_1783_: bool;
    var phi_1784_: bool;
    var phi_1788_: f32;
    var phi_1789_: f32;
    var phi_1790_: f32;
    var phi_1791_: f32;
    var phi_1799_: f32;
    var phi_1809_: bool;
    var phi_1810_: bool;
    var phi_1814_: f32;
    var phi_1815_: f32;
    var phi_1816_: f32;
    var phi_1817_: f32;
    var phi_1825_: f32;
    var phi_1840_: f32;
    var phi_1841_: bool;
    var phi_1842_: f32;
    var phi_1843_: bool;
    var phi_1844_: f32;
    var phi_1845_: bool;
    var phi_1863_: f32;
    var phi_1864_: bool;
    var phi_1865_: bool;
    var phi_1866_: f32;
    var phi_1867_: bool;
    var phi_1868_: bool;
    var phi_1872_: bool;
    var phi_1873_: f32;
    var phi_1874_: bool;
    var phi_1902_: vec3<f32>;
    var phi_1903_: vec3<f32>;
    var phi_1928_: vec3<f32>;
    var phi_1929_: vec3<f32>;
    var phi_1954_: vec3<f32>;
    var phi_1955_: vec3<f32>;
    var phi_2011_: f32;
    var phi_2020_: f32;
    var phi_2029_: f32;
    var phi_2038_: f32;
    var phi_2045_: f32;
    var phi_2052_: f32;
    var phi_2065_: f32;
    var phi_2074_: f32;
    var phi_2083_: f32;
    var phi_2092_: f32;
    var phi_2099_: f32;
    var phi_2106_: f32;
    var phi_2123_: f32;
    var phi_2128_: f32;
    var phi_2133_: f32;
    var phi_2141_: f32;
    var phi_2146_: f32;
    var phi_2151_: f32;
    var phi_2163_: f32;
    var phi_2168_: f32;
    var phi_2173_: f32;
    var phi_2178_: f32;
    var phi_2183_: lt_bvh_triangle_Intersection;
    var phi_2184_: bool;
    var phi_2185_: lt_bvh_triangle_Intersection;
    var phi_2186_: bool;
    var phi_2190_: lt_bvh_triangle_Intersection;
    var phi_2191_: bool;
    var phi_2192_: lt_bvh_triangle_Intersection;
    var phi_2193_: bool;
    var phi_2194_: bool;
    var phi_2198_: bool;
    var phi_2202_: lt_bvh_triangle_Intersection;
    var phi_2416_: f32;
    var phi_2419_: bool;
    var phi_2420_: bool;
    var phi_2421_: bool;
    var phi_2425_: bool;
    var phi_2426_: bool;
    var phi_2427_: bool;
    var phi_2428_: bool;
    var phi_2429_: bool;
    var phi_2430_: bool;
    var phi_2431_: bool;
    var phi_2432_: bool;
    var phi_2433_: bool;
    var phi_2434_: bool;
    var phi_1632_: u32;
    var phi_1635_: bool;
    var phi_2438_: bool;
    var phi_2439_: bool;
    var local_6: bool;
    var phi_2481_: bool;
    var phi_2482_: bool;
    var phi_2513_: u32;
    var phi_2514_: u32;
    var phi_1300_: u32;
    var phi_1303_: bool;
    var phi_2515_: bool;
    var phi_2516_: bool;
    var phi_2517_: bool;
    var local_7: bool;
    var phi_2521_: bool;
    var phi_2525_: bool;
    var phi_2526_: bool;
    var phi_2527_: bool;
    var phi_2528_: bool;
    var phi_2532_: bool;
    var phi_2536_: f32;
    var phi_2537_: f32;
    var local_8: bool;
    var local_9: bool;
    var local_10: bool;
    var local_11: bool;
    var local_12: bool;

    let _e71 = id_1;
    let _e78 = arrayLength((&nodes.member));
    let _e81 = arrayLength((&triangles.member));
    let _e87 = arrayLength((&vertices.member));
    let _e93 = arrayLength((&alpha_texels.member));
    let _e96 = p.member.size[0u];
    let _e98 = p.member.size[1u];
    let _e99 = lt_shaders_entry_pixel_index(_e71, _e96, _e98);
    if (bitcast<i32>(_e99.word) != 0i) {
        if (_e99.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e107 = samples.member[(0u + _e99.shift)];
        local_2 = abi_Sample(_e107.position, _e107.magnitude, _e107.normal, _e107.flags, _e107.shading_normal, _e107.albedo);
        let _e116 = _lt_shaders_abi_Sample_is_valid((&local_2));
        if _e116 {
            let _e118 = local_2.position;
            let _e120 = p.member.light.place;
            let _e126 = p.member.light.place[3u];
            let _e133 = (_e120.x - (_e118.x * _e126));
            let _e134 = (_e120.y - (_e118.y * _e126));
            let _e135 = (_e120.z - (_e118.z * _e126));
            let _e137 = local_2.normal;
            if ((((_e137.x * _e133) + (_e137.y * _e134)) + (_e137.z * _e135)) > 0f) {
                let _e151 = (((_e133 * _e133) + (_e134 * _e134)) + (_e135 * _e135));
                let _e153 = p.member.light.axis;
                let _e165 = p.member.light.place[3u];
                if (_e165 == 0f) {
                    phi_788_ = true;
                } else {
                    let _e168 = p.member.light.range_squared;
                    if (_e151 <= _e168) {
                        let _e171 = p.member.light.cos_outer;
                        phi_787_ = (-((((_e133 * _e153.x) + (_e134 * _e153.y)) + (_e135 * _e153.z))) >= (_e171 * sqrt(_e151)));
                    } else {
                        phi_787_ = false;
                    }
                    let _e176 = phi_787_;
                    phi_788_ = _e176;
                }
                let _e178 = phi_788_;
                if _e178 {
                    let _e180 = local_2.flags;
                    let _e188 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e194 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e188.unnamed.visibility, false), _e188.unnamed_1);
                    phi_799_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e194.unnamed, ((_e180 & 1u) == 0u));
                    phi_800_ = false;
                } else {
                    phi_799_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_800_ = true;
                }
                let _e199 = phi_799_;
                let _e201 = phi_800_;
                phi_801_ = _e199;
                phi_802_ = _e201;
            } else {
                phi_801_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_802_ = true;
            }
            let _e203 = phi_801_;
            let _e205 = phi_802_;
            if _e205 {
                let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e217 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e211.unnamed.visibility, false), _e211.unnamed_1);
                phi_809_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e217.unnamed, true);
            } else {
                phi_809_ = _e203;
            }
            let _e222 = phi_809_;
            phi_813_ = _e222;
        } else {
            let _e228 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e234 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e228.unnamed.visibility, false), _e228.unnamed_1);
            phi_813_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e234.unnamed, true);
        }
        let _e239 = phi_813_;
        if _e239.unnamed_1 {
            phi_2537_ = _e239.unnamed.visibility;
        } else {
            let _e245 = local_2.position;
            let _e247 = local_2.normal;
            let _e249 = local_2.magnitude;
            let _e251 = ((8f / 8388608f) * _e249);
            let _e259 = (_e245.x + (_e247.x * _e251));
            let _e261 = (_e245.y + (_e247.y * _e251));
            let _e263 = (_e245.z + (_e247.z * _e251));
            let _e265 = p.member.light.place;
            if (_e265.w == 0f) {
                phi_860_ = 300000000000000000000000000000000000000f;
            } else {
                phi_860_ = 1f;
            }
            let _e269 = phi_860_;
            let _e277 = (_e265.x - (_e259 * _e265.w));
            let _e278 = (_e265.y - (_e261 * _e265.w));
            let _e279 = (_e265.z - (_e263 * _e265.w));
            let _e284 = abs(_e277);
            let _e285 = abs(_e278);
            let _e286 = abs(_e279);
            if (abs(_e259) < 1000000000000000f) {
                if (abs(_e261) < 1000000000000000f) {
                    if (abs(_e263) < 1000000000000000f) {
                        if (_e284 < 1000000000000000f) {
                            if (_e285 < 1000000000000000f) {
                                if (_e286 < 1000000000000000f) {
                                    if (_e284 > 0f) {
                                        phi_916_ = bool();
                                        phi_917_ = true;
                                    } else {
                                        let _e294 = (_e285 > 0f);
                                        if _e294 {
                                            phi_915_ = bool();
                                        } else {
                                            phi_915_ = (_e286 > 0f);
                                        }
                                        let _e297 = phi_915_;
                                        phi_916_ = _e297;
                                        phi_917_ = _e294;
                                    }
                                    let _e299 = phi_916_;
                                    let _e301 = phi_917_;
                                    if _e301 {
                                        phi_921_ = true;
                                    } else {
                                        phi_921_ = _e299;
                                    }
                                    let _e303 = phi_921_;
                                    phi_922_ = _e303;
                                    phi_923_ = false;
                                } else {
                                    phi_922_ = bool();
                                    phi_923_ = true;
                                }
                                let _e305 = phi_922_;
                                let _e307 = phi_923_;
                                phi_924_ = _e305;
                                phi_925_ = false;
                                phi_926_ = _e307;
                            } else {
                                phi_924_ = bool();
                                phi_925_ = true;
                                phi_926_ = false;
                            }
                            let _e309 = phi_924_;
                            let _e311 = phi_925_;
                            let _e313 = phi_926_;
                            phi_927_ = _e309;
                            phi_928_ = _e311;
                            phi_929_ = _e313;
                        } else {
                            phi_927_ = bool();
                            phi_928_ = true;
                            phi_929_ = false;
                        }
                        let _e315 = phi_927_;
                        let _e317 = phi_928_;
                        let _e319 = phi_929_;
                        phi_930_ = _e315;
                        phi_931_ = _e317;
                        phi_932_ = _e319;
                    } else {
                        phi_930_ = bool();
                        phi_931_ = true;
                        phi_932_ = false;
                    }
                    let _e321 = phi_930_;
                    let _e323 = phi_931_;
                    let _e325 = phi_932_;
                    phi_933_ = _e321;
                    phi_934_ = _e323;
                    phi_935_ = _e325;
                } else {
                    phi_933_ = bool();
                    phi_934_ = true;
                    phi_935_ = false;
                }
                let _e327 = phi_933_;
                let _e329 = phi_934_;
                let _e331 = phi_935_;
                phi_936_ = _e327;
                phi_937_ = _e329;
                phi_938_ = _e331;
            } else {
                phi_936_ = bool();
                phi_937_ = true;
                phi_938_ = false;
            }
            let _e333 = phi_936_;
            let _e335 = phi_937_;
            let _e337 = phi_938_;
            if _e335 {
                phi_942_ = true;
            } else {
                phi_942_ = _e337;
            }
            let _e339 = phi_942_;
            if _e339 {
                phi_946_ = false;
            } else {
                phi_946_ = _e333;
            }
            let _e341 = phi_946_;
            if _e341 {
                let _e342 = (0u >= _e78);
                if _e342 {
                    phi_2526_ = bool();
                } else {
                    if (0u < _e78) {
                    } else {
                        return;
                    }
                    let _e348 = nodes.member[(0u + 0u)].frame[0u];
                    let _e352 = nodes.member[(0u + 0u)].frame[1u];
                    let _e356 = nodes.member[(0u + 0u)].frame[2u];
                    let _e360 = nodes.member[(0u + 0u)].frame[0u];
                    let _e364 = nodes.member[(0u + 0u)].frame[1u];
                    let _e368 = nodes.member[(0u + 0u)].frame[2u];
                    let _e372 = nodes.member[(0u + 0u)].frame[3u];
                    let _e406 = core_intrinsics_maximum_number_nsz_f32_(abs(_e277), abs(_e278));
                    let _e407 = core_intrinsics_maximum_number_nsz_f32_(_e406, abs(_e279));
                    let _e408 = (_e407 * 0.0000000000009094947f);
                    if (abs(_e277) < _e408) {
                        phi_1016_ = _e408;
                    } else {
                        phi_1016_ = abs(_e277);
                    }
                    let _e413 = phi_1016_;
                    if (_e277 < 0f) {
                        phi_1023_ = (-1f / _e413);
                    } else {
                        phi_1023_ = (1f / _e413);
                    }
                    let _e418 = phi_1023_;
                    if (abs(_e278) < _e408) {
                        phi_1030_ = _e408;
                    } else {
                        phi_1030_ = abs(_e278);
                    }
                    let _e423 = phi_1030_;
                    if (_e278 < 0f) {
                        phi_1037_ = (-1f / _e423);
                    } else {
                        phi_1037_ = (1f / _e423);
                    }
                    let _e428 = phi_1037_;
                    if (abs(_e279) < _e408) {
                        phi_1044_ = _e408;
                    } else {
                        phi_1044_ = abs(_e279);
                    }
                    let _e433 = phi_1044_;
                    if (_e279 < 0f) {
                        phi_1051_ = (-1f / _e433);
                    } else {
                        phi_1051_ = (1f / _e433);
                    }
                    let _e438 = phi_1051_;
                    let _e442 = abs((bitcast<f32>(_e348) - _e259));
                    let _e443 = abs((bitcast<f32>(_e352) - _e261));
                    let _e444 = abs((bitcast<f32>(_e356) - _e263));
                    let _e448 = abs(((bitcast<f32>(_e360) + (bitcast<f32>((((_e372 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e259));
                    let _e449 = abs(((bitcast<f32>(_e364) + (bitcast<f32>((((_e372 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e261));
                    let _e450 = abs(((bitcast<f32>(_e368) + (bitcast<f32>((((_e372 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e263));
                    if (_e442 > _e448) {
                        phi_1068_ = _e442;
                    } else {
                        phi_1068_ = _e448;
                    }
                    let _e453 = phi_1068_;
                    if (_e443 > _e449) {
                        phi_1073_ = _e443;
                    } else {
                        phi_1073_ = _e449;
                    }
                    let _e456 = phi_1073_;
                    if (_e444 > _e450) {
                        phi_1078_ = _e444;
                    } else {
                        phi_1078_ = _e450;
                    }
                    let _e459 = phi_1078_;
                    let _e460 = core_intrinsics_maximum_number_nsz_f32_(_e453, _e456);
                    let _e461 = core_intrinsics_maximum_number_nsz_f32_(_e460, _e459);
                    let _e465 = (_e461 * 0.0000019073486f);
                    let _e466 = (abs(_e418) * _e465);
                    let _e467 = (abs(_e428) * _e465);
                    let _e468 = (abs(_e438) * _e465);
                    let _e472 = (_e461 * 0.0000009536743f);
                    let _e473 = (abs(_e418) * _e472);
                    let _e474 = (abs(_e428) * _e472);
                    let _e475 = (abs(_e438) * _e472);
                    let _e476 = abs(_e277);
                    let _e477 = abs(_e278);
                    let _e478 = abs(_e279);
                    if (_e476 >= _e477) {
                        if (_e476 >= _e478) {
                            phi_1106_ = false;
                        } else {
                            phi_1106_ = true;
                        }
                        let _e482 = phi_1106_;
                        phi_1107_ = _e482;
                    } else {
                        phi_1107_ = true;
                    }
                    let _e484 = phi_1107_;
                    if _e484 {
                        if (_e477 >= _e478) {
                            phi_1115_ = 1u;
                        } else {
                            phi_1115_ = 2u;
                        }
                        let _e487 = phi_1115_;
                        phi_1116_ = _e487;
                    } else {
                        phi_1116_ = 0u;
                    }
                    let _e489 = phi_1116_;
                    if (_e489 == 0u) {
                        phi_1128_ = vec3<f32>(_e278, _e279, _e277);
                    } else {
                        if (_e489 == 1u) {
                            phi_1127_ = vec3<f32>(_e279, _e277, _e278);
                        } else {
                            phi_1127_ = vec3<f32>(_e277, _e278, _e279);
                        }
                        let _e495 = phi_1127_;
                        phi_1128_ = _e495;
                    }
                    let _e497 = phi_1128_;
                    let _e500 = (_e497.x / _e497.z);
                    let _e503 = (_e497.y / _e497.z);
                    if (_e418 < 0f) {
                        phi_1141_ = 0u;
                    } else {
                        phi_1141_ = 1u;
                    }
                    let _e508 = phi_1141_;
                    if (_e428 < 0f) {
                        phi_1146_ = 0u;
                    } else {
                        phi_1146_ = 2u;
                    }
                    let _e511 = phi_1146_;
                    if (_e438 < 0f) {
                        phi_1151_ = 0u;
                    } else {
                        phi_1151_ = 4u;
                    }
                    let _e514 = phi_1151_;
                    let _e516 = ((_e508 | _e511) | _e514);
                    let _e517 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e517.first[0], _e517.first[1], _e517.first[2], _e517.first[3], _e517.first[4], _e517.first[5], _e517.first[6], _e517.first[7], _e517.first[8], _e517.first[9], _e517.first[10], _e517.first[11], _e517.first[12], _e517.first[13], _e517.first[14], _e517.first[15], _e517.first[16], _e517.first[17], _e517.first[18], _e517.first[19], _e517.first[20], _e517.first[21], _e517.first[22], _e517.first[23], _e517.first[24], _e517.first[25], _e517.first[26], _e517.first[27], _e517.first[28], _e517.first[29], _e517.first[30], _e517.first[31]), array<u32, 32>(_e517.mask[0], _e517.mask[1], _e517.mask[2], _e517.mask[3], _e517.mask[4], _e517.mask[5], _e517.mask[6], _e517.mask[7], _e517.mask[8], _e517.mask[9], _e517.mask[10], _e517.mask[11], _e517.mask[12], _e517.mask[13], _e517.mask[14], _e517.mask[15], _e517.mask[16], _e517.mask[17], _e517.mask[18], _e517.mask[19], _e517.mask[20], _e517.mask[21], _e517.mask[22], _e517.mask[23], _e517.mask[24], _e517.mask[25], _e517.mask[26], _e517.mask[27], _e517.mask[28], _e517.mask[29], _e517.mask[30], _e517.mask[31]), _e517.len, _e517.group, _e517.group_mask);
                    let _e591 = local_1.group_mask;
                    if ((_e591 & 4278190080u) == 0u) {
                        let _e595 = local_1.len;
                        if (_e595 == 0u) {
                            phi_1265_ = false;
                        } else {
                            let _e599 = local_1.len;
                            local_1.len = (_e599 - 1u);
                            let _e602 = local_1.len;
                            if (_e602 < 32u) {
                            } else {
                                return;
                            }
                            let _e607 = local_1.first[(0u + _e602)];
                            local_1.group = _e607;
                            let _e610 = local_1.len;
                            if (_e610 < 32u) {
                            } else {
                                return;
                            }
                            let _e615 = local_1.mask[(0u + _e610)];
                            local_1.group_mask = _e615;
                            phi_1265_ = true;
                        }
                        let _e618 = phi_1265_;
                        phi_1266_ = _e618;
                    } else {
                        phi_1266_ = true;
                    }
                    let _e620 = phi_1266_;
                    if _e620 {
                        let _e622 = local_1.group_mask;
                        let _e628 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e622)), 32u, (_e622 == 0u)));
                        let _e632 = local_1.group_mask;
                        let _e646 = local_1.group_mask;
                        local_1.group_mask = (_e646 & ~((1u << bitcast<u32>((_e628 & 31u)))));
                        let _e649 = local_1.group;
                        phi_1297_ = (_e649 + countOneBits(((_e632 & ~((4294967295u << bitcast<u32>((((_e628 - 24u) ^ 7u) & 31u))))) & 255u)));
                    } else {
                        phi_1297_ = 4294967295u;
                    }
                    let _e652 = phi_1297_;
                    phi_1299_ = _e652;
                    phi_1302_ = false;
                    loop {
                        let _e654 = phi_1299_;
                        let _e656 = phi_1302_;
                        local_12 = _e656;
                        if (_e654 != 4294967295u) {
                            if (_e654 < _e78) {
                            } else {
                                return;
                            }
                            let _e663 = nodes.member[(0u + _e654)].frame[3u];
                            let _e688 = (bitcast<f32>((((_e663 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e418);
                            let _e689 = (bitcast<f32>((((_e663 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e428);
                            let _e690 = (bitcast<f32>((((_e663 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e438);
                            let _e693 = nodes.member[(0u + _e654)].frame[0u];
                            let _e697 = nodes.member[(0u + _e654)].frame[1u];
                            let _e701 = nodes.member[(0u + _e654)].frame[2u];
                            let _e706 = ((bitcast<f32>(_e693) - _e259) * _e418);
                            let _e707 = ((bitcast<f32>(_e697) - _e261) * _e428);
                            let _e708 = ((bitcast<f32>(_e701) - _e263) * _e438);
                            let _e716 = nodes.member[(0u + _e654)].x;
                            if (_e418 < 0f) {
                                let _e727 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e716.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e733 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e727.unnamed.word, _e716.w), _e727.unnamed_1);
                                let _e739 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e733.unnamed, lt_mask_LightPlace(_e716.x, _e733.unnamed_1.shift));
                                phi_1382_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e739.unnamed, lt_mask_LightPlace(_e739.unnamed_1.word, _e716.y));
                            } else {
                                let _e755 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e716.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e761 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e755.unnamed.word, _e716.y), _e755.unnamed_1);
                                let _e767 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e761.unnamed, lt_mask_LightPlace(_e716.z, _e761.unnamed_1.shift));
                                phi_1382_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e767.unnamed, lt_mask_LightPlace(_e767.unnamed_1.word, _e716.w));
                            }
                            let _e775 = phi_1382_;
                            let _e785 = nodes.member[(0u + _e654)].y;
                            if (_e428 < 0f) {
                                let _e796 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e785.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e802 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e796.unnamed.word, _e785.w), _e796.unnamed_1);
                                let _e808 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e802.unnamed, lt_mask_LightPlace(_e785.x, _e802.unnamed_1.shift));
                                phi_1409_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e808.unnamed, lt_mask_LightPlace(_e808.unnamed_1.word, _e785.y));
                            } else {
                                let _e824 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e785.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e830 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e824.unnamed.word, _e785.y), _e824.unnamed_1);
                                let _e836 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e830.unnamed, lt_mask_LightPlace(_e785.z, _e830.unnamed_1.shift));
                                phi_1409_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e836.unnamed, lt_mask_LightPlace(_e836.unnamed_1.word, _e785.w));
                            }
                            let _e844 = phi_1409_;
                            let _e854 = nodes.member[(0u + _e654)].z;
                            if (_e438 < 0f) {
                                let _e865 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e854.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e871 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e865.unnamed.word, _e854.w), _e865.unnamed_1);
                                let _e877 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e871.unnamed, lt_mask_LightPlace(_e854.x, _e871.unnamed_1.shift));
                                phi_1436_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e877.unnamed, lt_mask_LightPlace(_e877.unnamed_1.word, _e854.y));
                            } else {
                                let _e893 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e854.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e899 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e893.unnamed.word, _e854.y), _e893.unnamed_1);
                                let _e905 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e899.unnamed, lt_mask_LightPlace(_e854.z, _e899.unnamed_1.shift));
                                phi_1436_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e905.unnamed, lt_mask_LightPlace(_e905.unnamed_1.word, _e854.w));
                            }
                            let _e913 = phi_1436_;
                            phi_1442_ = 0u;
                            phi_1445_ = 0u;
                            loop {
                                let _e923 = phi_1442_;
                                let _e925 = phi_1445_;
                                local_3 = _e925;
                                local_4 = _e925;
                                local_5 = _e925;
                                let _e926 = (_e923 < 8u);
                                if _e926 {
                                    let _e928 = (_e923 >> bitcast<u32>(2i));
                                    let _e929 = (_e923 & 3u);
                                    if (_e928 == 0u) {
                                        phi_1459_ = _e775.unnamed.word;
                                    } else {
                                        phi_1459_ = _e775.unnamed.shift;
                                    }
                                    let _e932 = phi_1459_;
                                    if (_e928 == 0u) {
                                        phi_1469_ = _e844.unnamed.word;
                                    } else {
                                        phi_1469_ = _e844.unnamed.shift;
                                    }
                                    let _e941 = phi_1469_;
                                    if (_e928 == 0u) {
                                        phi_1479_ = _e913.unnamed.word;
                                    } else {
                                        phi_1479_ = _e913.unnamed.shift;
                                    }
                                    let _e950 = phi_1479_;
                                    let _e963 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e932 >> bitcast<u32>(((_e929 * 8u) & 31u))) & 255u)) * _e688) + (_e706 - _e466)), ((f32(((_e941 >> bitcast<u32>(((_e929 * 8u) & 31u))) & 255u)) * _e689) + (_e707 - _e467)));
                                    let _e964 = core_intrinsics_maximum_number_nsz_f32_(_e963, ((f32(((_e950 >> bitcast<u32>(((_e929 * 8u) & 31u))) & 255u)) * _e690) + (_e708 - _e468)));
                                    if (_e928 == 0u) {
                                        phi_1497_ = _e775.unnamed_1.word;
                                    } else {
                                        phi_1497_ = _e775.unnamed_1.shift;
                                    }
                                    let _e967 = phi_1497_;
                                    if (_e928 == 0u) {
                                        phi_1507_ = _e844.unnamed_1.word;
                                    } else {
                                        phi_1507_ = _e844.unnamed_1.shift;
                                    }
                                    let _e976 = phi_1507_;
                                    if (_e928 == 0u) {
                                        phi_1517_ = _e913.unnamed_1.word;
                                    } else {
                                        phi_1517_ = _e913.unnamed_1.shift;
                                    }
                                    let _e985 = phi_1517_;
                                    let _e998 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e967 >> bitcast<u32>(((_e929 * 8u) & 31u))) & 255u)) * _e688) + (_e706 + _e466)), ((f32(((_e976 >> bitcast<u32>(((_e929 * 8u) & 31u))) & 255u)) * _e689) + (_e707 + _e467)));
                                    let _e999 = core_intrinsics_minimum_number_nsz_f32_(_e998, ((f32(((_e985 >> bitcast<u32>(((_e929 * 8u) & 31u))) & 255u)) * _e690) + (_e708 + _e468)));
                                    if (_e964 <= _e999) {
                                        if (_e964 <= _e269) {
                                            if (_e999 >= 0f) {
                                                if (_e928 == 0u) {
                                                    let _e1006 = nodes.member[(0u + _e654)].links[2u];
                                                    phi_1553_ = _e1006;
                                                } else {
                                                    let _e1009 = nodes.member[(0u + _e654)].links[3u];
                                                    phi_1553_ = _e1009;
                                                }
                                                let _e1011 = phi_1553_;
                                                let _e1016 = ((_e1011 >> bitcast<u32>(((_e929 * 8u) & 31u))) & 255u);
                                                let _e1017 = (_e1016 & 31u);
                                                if (_e1017 >= 24u) {
                                                    phi_1566_ = (24u + ((_e1017 - 24u) ^ _e516));
                                                } else {
                                                    phi_1566_ = _e1017;
                                                }
                                                let _e1023 = phi_1566_;
                                                phi_1571_ = (_e925 | ((_e1016 >> bitcast<u32>(5i)) << bitcast<u32>((_e1023 & 31u))));
                                            } else {
                                                phi_1571_ = _e925;
                                            }
                                            let _e1031 = phi_1571_;
                                            phi_1572_ = _e1031;
                                        } else {
                                            phi_1572_ = _e925;
                                        }
                                        let _e1033 = phi_1572_;
                                        phi_1573_ = _e1033;
                                    } else {
                                        phi_1573_ = _e925;
                                    }
                                    let _e1035 = phi_1573_;
                                    phi_1443_ = (_e923 + 1u);
                                    phi_1446_ = _e1035;
                                } else {
                                    phi_1443_ = u32();
                                    phi_1446_ = u32();
                                }
                                let _e1038 = phi_1443_;
                                let _e1040 = phi_1446_;
                                continue;
                                continuing {
                                    phi_1442_ = _e1038;
                                    phi_1445_ = _e1040;
                                    break if !(_e926);
                                }
                            }
                            let _e1044 = nodes.member[(0u + _e654)].links[0u];
                            let _e1048 = nodes.member[(0u + _e654)].frame[3u];
                            let _e1052 = local_3;
                            if ((_e1052 & 4278190080u) == 0u) {
                            } else {
                                let _e1056 = local_1.group_mask;
                                if ((_e1056 & 4278190080u) == 0u) {
                                } else {
                                    let _e1060 = local_1.len;
                                    if (_e1060 < 32u) {
                                        let _e1063 = local_1.group;
                                        let _e1065 = local_1.len;
                                        if (_e1065 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_1.first[(0u + _e1065)] = _e1063;
                                        let _e1071 = local_1.group_mask;
                                        let _e1073 = local_1.len;
                                        if (_e1073 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_1.mask[(0u + _e1073)] = _e1071;
                                        let _e1080 = local_1.len;
                                        local_1.len = (_e1080 + 1u);
                                    }
                                }
                                local_1.group = (0u + _e1044);
                                let _e1084 = local_4;
                                local_1.group_mask = ((_e1084 & 4278190080u) | (_e1048 >> bitcast<u32>(24i)));
                            }
                            let _e1089 = local_5;
                            phi_1631_ = (_e1089 & 16777215u);
                            phi_1634_ = _e656;
                            loop {
                                let _e1092 = phi_1631_;
                                let _e1094 = phi_1634_;
                                local_8 = _e1094;
                                let _e1095 = (_e1092 == 0u);
                                local_6 = _e1095;
                                local_10 = _e1095;
                                if _e1095 {
                                    phi_1632_ = u32();
                                    phi_1635_ = bool();
                                    phi_2438_ = bool();
                                    phi_2439_ = false;
                                } else {
                                    let _e1098 = nodes.member[(0u + _e654)].links[1u];
                                    let _e1103 = ((0u + _e1098) + select(firstTrailingBit(_e1092), 32u, (_e1092 == 0u)));
                                    if (_e1103 < _e81) {
                                    } else {
                                        return;
                                    }
                                    let _e1110 = triangles.member[(0u + _e1103)].v0_;
                                    let _e1112 = (_e1110.x - _e259);
                                    let _e1114 = (_e1110.y - _e261);
                                    let _e1116 = (_e1110.z - _e263);
                                    if (_e489 == 0u) {
                                        phi_1679_ = vec3<f32>(_e1114, _e1116, _e1112);
                                    } else {
                                        if (_e489 == 1u) {
                                            phi_1678_ = vec3<f32>(_e1116, _e1112, _e1114);
                                        } else {
                                            phi_1678_ = (_e1110 - vec3<f32>(_e259, _e261, _e263));
                                        }
                                        let _e1124 = phi_1678_;
                                        phi_1679_ = _e1124;
                                    }
                                    let _e1126 = phi_1679_;
                                    let _e1130 = (_e1126.x - (_e500 * _e1126.z));
                                    let _e1134 = (_e1126.y - (_e503 * _e1126.z));
                                    let _e1136 = triangles.member[(0u + _e1103)].v1_;
                                    let _e1138 = (_e1136.x - _e259);
                                    let _e1140 = (_e1136.y - _e261);
                                    let _e1142 = (_e1136.z - _e263);
                                    if (_e489 == 0u) {
                                        phi_1709_ = vec3<f32>(_e1140, _e1142, _e1138);
                                    } else {
                                        if (_e489 == 1u) {
                                            phi_1708_ = vec3<f32>(_e1142, _e1138, _e1140);
                                        } else {
                                            phi_1708_ = (_e1136 - vec3<f32>(_e259, _e261, _e263));
                                        }
                                        let _e1150 = phi_1708_;
                                        phi_1709_ = _e1150;
                                    }
                                    let _e1152 = phi_1709_;
                                    let _e1156 = (_e1152.x - (_e500 * _e1152.z));
                                    let _e1160 = (_e1152.y - (_e503 * _e1152.z));
                                    let _e1162 = triangles.member[(0u + _e1103)].v2_;
                                    let _e1164 = (_e1162.x - _e259);
                                    let _e1166 = (_e1162.y - _e261);
                                    let _e1168 = (_e1162.z - _e263);
                                    if (_e489 == 0u) {
                                        phi_1739_ = vec3<f32>(_e1166, _e1168, _e1164);
                                    } else {
                                        if (_e489 == 1u) {
                                            phi_1738_ = vec3<f32>(_e1168, _e1164, _e1166);
                                        } else {
                                            phi_1738_ = (_e1162 - vec3<f32>(_e259, _e261, _e263));
                                        }
                                        let _e1176 = phi_1738_;
                                        phi_1739_ = _e1176;
                                    }
                                    let _e1178 = phi_1739_;
                                    let _e1182 = (_e1178.x - (_e500 * _e1178.z));
                                    let _e1186 = (_e1178.y - (_e503 * _e1178.z));
                                    if (_e1156 < _e1182) {
                                        phi_1758_ = true;
                                    } else {
                                        if (_e1156 == _e1182) {
                                            phi_1757_ = (_e1160 < _e1186);
                                        } else {
                                            phi_1757_ = false;
                                        }
                                        let _e1191 = phi_1757_;
                                        phi_1758_ = _e1191;
                                    }
                                    let _e1193 = phi_1758_;
                                    if _e1193 {
                                        phi_1762_ = _e1186;
                                        phi_1763_ = _e1182;
                                        phi_1764_ = _e1160;
                                        phi_1765_ = _e1156;
                                    } else {
                                        phi_1762_ = _e1160;
                                        phi_1763_ = _e1156;
                                        phi_1764_ = _e1186;
                                        phi_1765_ = _e1182;
                                    }
                                    let _e1195 = phi_1762_;
                                    let _e1197 = phi_1763_;
                                    let _e1199 = phi_1764_;
                                    let _e1201 = phi_1765_;
                                    let _e1204 = ((_e1201 * _e1195) - (_e1199 * _e1197));
                                    if _e1193 {
                                        phi_1773_ = -(_e1204);
                                    } else {
                                        phi_1773_ = _e1204;
                                    }
                                    let _e1207 = phi_1773_;
                                    if (_e1182 < _e1130) {
                                        phi_1784_ = true;
                                    } else {
                                        if (_e1182 == _e1130) {
                                            phi_1783_ = (_e1186 < _e1134);
                                        } else {
                                            phi_1783_ = false;
                                        }
                                        let _e1212 = phi_1783_;
                                        phi_1784_ = _e1212;
                                    }
                                    let _e1214 = phi_1784_;
                                    if _e1214 {
                                        phi_1788_ = _e1134;
                                        phi_1789_ = _e1130;
                                        phi_1790_ = _e1186;
                                        phi_1791_ = _e1182;
                                    } else {
                                        phi_1788_ = _e1186;
                                        phi_1789_ = _e1182;
                                        phi_1790_ = _e1134;
                                        phi_1791_ = _e1130;
                                    }
                                    let _e1216 = phi_1788_;
                                    let _e1218 = phi_1789_;
                                    let _e1220 = phi_1790_;
                                    let _e1222 = phi_1791_;
                                    let _e1225 = ((_e1222 * _e1216) - (_e1220 * _e1218));
                                    if _e1214 {
                                        phi_1799_ = -(_e1225);
                                    } else {
                                        phi_1799_ = _e1225;
                                    }
                                    let _e1228 = phi_1799_;
                                    if (_e1130 < _e1156) {
                                        phi_1810_ = true;
                                    } else {
                                        if (_e1130 == _e1156) {
                                            phi_1809_ = (_e1134 < _e1160);
                                        } else {
                                            phi_1809_ = false;
                                        }
                                        let _e1233 = phi_1809_;
                                        phi_1810_ = _e1233;
                                    }
                                    let _e1235 = phi_1810_;
                                    if _e1235 {
                                        phi_1814_ = _e1160;
                                        phi_1815_ = _e1156;
                                        phi_1816_ = _e1134;
                                        phi_1817_ = _e1130;
                                    } else {
                                        phi_1814_ = _e1134;
                                        phi_1815_ = _e1130;
                                        phi_1816_ = _e1160;
                                        phi_1817_ = _e1156;
                                    }
                                    let _e1237 = phi_1814_;
                                    let _e1239 = phi_1815_;
                                    let _e1241 = phi_1816_;
                                    let _e1243 = phi_1817_;
                                    let _e1246 = ((_e1243 * _e1237) - (_e1241 * _e1239));
                                    if _e1235 {
                                        phi_1825_ = -(_e1246);
                                    } else {
                                        phi_1825_ = _e1246;
                                    }
                                    let _e1249 = phi_1825_;
                                    if (_e1207 >= 0f) {
                                        if (_e1228 >= 0f) {
                                            if (_e1249 >= 0f) {
                                                phi_1840_ = ((_e1207 + _e1228) + _e1249);
                                                phi_1841_ = false;
                                            } else {
                                                phi_1840_ = f32();
                                                phi_1841_ = true;
                                            }
                                            let _e1256 = phi_1840_;
                                            let _e1258 = phi_1841_;
                                            phi_1842_ = _e1256;
                                            phi_1843_ = _e1258;
                                        } else {
                                            phi_1842_ = f32();
                                            phi_1843_ = true;
                                        }
                                        let _e1260 = phi_1842_;
                                        let _e1262 = phi_1843_;
                                        phi_1844_ = _e1260;
                                        phi_1845_ = _e1262;
                                    } else {
                                        phi_1844_ = f32();
                                        phi_1845_ = true;
                                    }
                                    let _e1264 = phi_1844_;
                                    let _e1266 = phi_1845_;
                                    if _e1266 {
                                        if (_e1207 <= 0f) {
                                            if (_e1228 <= 0f) {
                                                let _e1269 = (_e1249 <= 0f);
                                                if _e1269 {
                                                }
                                                phi_1863_ = ((_e1207 + _e1228) + _e1249);
                                                phi_1864_ = false;
                                                phi_1865_ = _e1269;
                                            } else {
                                                phi_1863_ = f32();
                                                phi_1864_ = true;
                                                phi_1865_ = false;
                                            }
                                            let _e1273 = phi_1863_;
                                            let _e1275 = phi_1864_;
                                            let _e1277 = phi_1865_;
                                            phi_1866_ = _e1273;
                                            phi_1867_ = _e1275;
                                            phi_1868_ = _e1277;
                                        } else {
                                            phi_1866_ = f32();
                                            phi_1867_ = true;
                                            phi_1868_ = false;
                                        }
                                        let _e1279 = phi_1866_;
                                        let _e1281 = phi_1867_;
                                        let _e1283 = phi_1868_;
                                        if _e1281 {
                                            phi_1872_ = false;
                                        } else {
                                            phi_1872_ = _e1283;
                                        }
                                        let _e1285 = phi_1872_;
                                        phi_1873_ = _e1279;
                                        phi_1874_ = _e1285;
                                    } else {
                                        phi_1873_ = _e1264;
                                        phi_1874_ = true;
                                    }
                                    let _e1287 = phi_1873_;
                                    let _e1289 = phi_1874_;
                                    if _e1289 {
                                        let _e1290 = (_e1287 == 0f);
                                        if _e1290 {
                                            phi_2190_ = lt_bvh_triangle_Intersection();
                                            phi_2191_ = false;
                                        } else {
                                            let _e1292 = triangles.member[(0u + _e1103)].v0_;
                                            let _e1294 = (_e1292.x - _e259);
                                            let _e1296 = (_e1292.y - _e261);
                                            let _e1298 = (_e1292.z - _e263);
                                            if (_e489 == 0u) {
                                                phi_1903_ = vec3<f32>(_e1296, _e1298, _e1294);
                                            } else {
                                                if (_e489 == 1u) {
                                                    phi_1902_ = vec3<f32>(_e1298, _e1294, _e1296);
                                                } else {
                                                    phi_1902_ = (_e1292 - vec3<f32>(_e259, _e261, _e263));
                                                }
                                                let _e1306 = phi_1902_;
                                                phi_1903_ = _e1306;
                                            }
                                            let _e1308 = phi_1903_;
                                            let _e1310 = triangles.member[(0u + _e1103)].v1_;
                                            let _e1312 = triangles.member[(0u + _e1103)].v0_;
                                            let _e1315 = (_e1310.x - _e1312.x);
                                            let _e1318 = (_e1310.y - _e1312.y);
                                            let _e1321 = (_e1310.z - _e1312.z);
                                            if (_e489 == 0u) {
                                                phi_1929_ = vec3<f32>(_e1318, _e1321, _e1315);
                                            } else {
                                                if (_e489 == 1u) {
                                                    phi_1928_ = vec3<f32>(_e1321, _e1315, _e1318);
                                                } else {
                                                    phi_1928_ = (_e1310 - _e1312);
                                                }
                                                let _e1328 = phi_1928_;
                                                phi_1929_ = _e1328;
                                            }
                                            let _e1330 = phi_1929_;
                                            let _e1332 = triangles.member[(0u + _e1103)].v2_;
                                            let _e1334 = triangles.member[(0u + _e1103)].v0_;
                                            let _e1337 = (_e1332.x - _e1334.x);
                                            let _e1340 = (_e1332.y - _e1334.y);
                                            let _e1343 = (_e1332.z - _e1334.z);
                                            if (_e489 == 0u) {
                                                phi_1955_ = vec3<f32>(_e1340, _e1343, _e1337);
                                            } else {
                                                if (_e489 == 1u) {
                                                    phi_1954_ = vec3<f32>(_e1343, _e1337, _e1340);
                                                } else {
                                                    phi_1954_ = (_e1332 - _e1334);
                                                }
                                                let _e1350 = phi_1954_;
                                                phi_1955_ = _e1350;
                                            }
                                            let _e1352 = phi_1955_;
                                            let _e1359 = ((_e1330.y * _e1352.z) - (_e1330.z * _e1352.y));
                                            let _e1366 = ((_e1330.z * _e1352.x) - (_e1330.x * _e1352.z));
                                            let _e1373 = ((_e1330.x * _e1352.y) - (_e1330.y * _e1352.x));
                                            let _e1387 = (((1f / _e497.z) * (((_e1359 * _e1308.x) + (_e1366 * _e1308.y)) + (_e1373 * _e1308.z))) / (((_e1359 * _e500) + (_e1366 * _e503)) + _e1373));
                                            if (_e1387 > 0f) {
                                                if (_e1387 < _e269) {
                                                    let _e1391 = triangles.member[(0u + _e1103)].v0_;
                                                    let _e1393 = triangles.member[(0u + _e1103)].v1_;
                                                    if (_e1391.x < _e1393.x) {
                                                        phi_2011_ = _e1391.x;
                                                    } else {
                                                        phi_2011_ = _e1393.x;
                                                    }
                                                    let _e1400 = phi_2011_;
                                                    if (_e1391.y < _e1393.y) {
                                                        phi_2020_ = _e1391.y;
                                                    } else {
                                                        phi_2020_ = _e1393.y;
                                                    }
                                                    let _e1407 = phi_2020_;
                                                    if (_e1391.z < _e1393.z) {
                                                        phi_2029_ = _e1391.z;
                                                    } else {
                                                        phi_2029_ = _e1393.z;
                                                    }
                                                    let _e1414 = phi_2029_;
                                                    let _e1416 = triangles.member[(0u + _e1103)].v2_;
                                                    if (_e1400 < _e1416.x) {
                                                        phi_2038_ = _e1400;
                                                    } else {
                                                        phi_2038_ = _e1416.x;
                                                    }
                                                    let _e1421 = phi_2038_;
                                                    if (_e1407 < _e1416.y) {
                                                        phi_2045_ = _e1407;
                                                    } else {
                                                        phi_2045_ = _e1416.y;
                                                    }
                                                    let _e1426 = phi_2045_;
                                                    if (_e1414 < _e1416.z) {
                                                        phi_2052_ = _e1414;
                                                    } else {
                                                        phi_2052_ = _e1416.z;
                                                    }
                                                    let _e1431 = phi_2052_;
                                                    let _e1433 = triangles.member[(0u + _e1103)].v0_;
                                                    let _e1435 = triangles.member[(0u + _e1103)].v1_;
                                                    if (_e1433.x > _e1435.x) {
                                                        phi_2065_ = _e1433.x;
                                                    } else {
                                                        phi_2065_ = _e1435.x;
                                                    }
                                                    let _e1442 = phi_2065_;
                                                    if (_e1433.y > _e1435.y) {
                                                        phi_2074_ = _e1433.y;
                                                    } else {
                                                        phi_2074_ = _e1435.y;
                                                    }
                                                    let _e1449 = phi_2074_;
                                                    if (_e1433.z > _e1435.z) {
                                                        phi_2083_ = _e1433.z;
                                                    } else {
                                                        phi_2083_ = _e1435.z;
                                                    }
                                                    let _e1456 = phi_2083_;
                                                    let _e1458 = triangles.member[(0u + _e1103)].v2_;
                                                    if (_e1442 > _e1458.x) {
                                                        phi_2092_ = _e1442;
                                                    } else {
                                                        phi_2092_ = _e1458.x;
                                                    }
                                                    let _e1463 = phi_2092_;
                                                    if (_e1449 > _e1458.y) {
                                                        phi_2099_ = _e1449;
                                                    } else {
                                                        phi_2099_ = _e1458.y;
                                                    }
                                                    let _e1468 = phi_2099_;
                                                    if (_e1456 > _e1458.z) {
                                                        phi_2106_ = _e1456;
                                                    } else {
                                                        phi_2106_ = _e1458.z;
                                                    }
                                                    let _e1473 = phi_2106_;
                                                    let _e1477 = ((_e1421 - _e259) * _e418);
                                                    let _e1478 = ((_e1426 - _e261) * _e428);
                                                    let _e1479 = ((_e1431 - _e263) * _e438);
                                                    let _e1483 = ((_e1463 - _e259) * _e418);
                                                    let _e1484 = ((_e1468 - _e261) * _e428);
                                                    let _e1485 = ((_e1473 - _e263) * _e438);
                                                    if (_e1477 < _e1483) {
                                                        phi_2123_ = _e1477;
                                                    } else {
                                                        phi_2123_ = _e1483;
                                                    }
                                                    let _e1488 = phi_2123_;
                                                    if (_e1478 < _e1484) {
                                                        phi_2128_ = _e1478;
                                                    } else {
                                                        phi_2128_ = _e1484;
                                                    }
                                                    let _e1491 = phi_2128_;
                                                    if (_e1479 < _e1485) {
                                                        phi_2133_ = _e1479;
                                                    } else {
                                                        phi_2133_ = _e1485;
                                                    }
                                                    let _e1494 = phi_2133_;
                                                    if (_e1477 > _e1483) {
                                                        phi_2141_ = _e1477;
                                                    } else {
                                                        phi_2141_ = _e1483;
                                                    }
                                                    let _e1500 = phi_2141_;
                                                    if (_e1478 > _e1484) {
                                                        phi_2146_ = _e1478;
                                                    } else {
                                                        phi_2146_ = _e1484;
                                                    }
                                                    let _e1503 = phi_2146_;
                                                    if (_e1479 > _e1485) {
                                                        phi_2151_ = _e1479;
                                                    } else {
                                                        phi_2151_ = _e1485;
                                                    }
                                                    let _e1506 = phi_2151_;
                                                    let _e1510 = core_intrinsics_maximum_number_nsz_f32_((_e1488 - _e473), (_e1491 - _e474));
                                                    let _e1511 = core_intrinsics_maximum_number_nsz_f32_(_e1510, (_e1494 - _e475));
                                                    let _e1512 = core_intrinsics_minimum_number_nsz_f32_((_e1500 + _e473), (_e1503 + _e474));
                                                    let _e1513 = core_intrinsics_minimum_number_nsz_f32_(_e1512, (_e1506 + _e475));
                                                    if (_e1511 > -300000000000000000000000000000000000000f) {
                                                        phi_2163_ = _e1511;
                                                    } else {
                                                        phi_2163_ = -300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1516 = phi_2163_;
                                                    if (_e1513 < 300000000000000000000000000000000000000f) {
                                                        phi_2168_ = _e1513;
                                                    } else {
                                                        phi_2168_ = 300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1519 = phi_2168_;
                                                    if (_e1387 < _e1516) {
                                                        phi_2173_ = _e1516;
                                                    } else {
                                                        phi_2173_ = _e1387;
                                                    }
                                                    let _e1522 = phi_2173_;
                                                    if (_e1522 > _e1519) {
                                                        phi_2178_ = _e1519;
                                                    } else {
                                                        phi_2178_ = _e1522;
                                                    }
                                                    let _e1525 = phi_2178_;
                                                    phi_2183_ = lt_bvh_triangle_Intersection(_e1525, (_e1228 / _e1287), (_e1249 / _e1287), (_e1516 <= _e1519));
                                                    phi_2184_ = false;
                                                } else {
                                                    phi_2183_ = lt_bvh_triangle_Intersection();
                                                    phi_2184_ = true;
                                                }
                                                let _e1531 = phi_2183_;
                                                let _e1533 = phi_2184_;
                                                phi_2185_ = _e1531;
                                                phi_2186_ = _e1533;
                                            } else {
                                                phi_2185_ = lt_bvh_triangle_Intersection();
                                                phi_2186_ = true;
                                            }
                                            let _e1535 = phi_2185_;
                                            let _e1537 = phi_2186_;
                                            if _e1537 {
                                            }
                                            phi_2190_ = _e1535;
                                            phi_2191_ = _e1537;
                                        }
                                        let _e1539 = phi_2190_;
                                        let _e1541 = phi_2191_;
                                        phi_2192_ = _e1539;
                                        phi_2193_ = _e1290;
                                        phi_2194_ = _e1541;
                                    } else {
                                        phi_2192_ = lt_bvh_triangle_Intersection();
                                        phi_2193_ = true;
                                        phi_2194_ = false;
                                    }
                                    let _e1543 = phi_2192_;
                                    let _e1545 = phi_2193_;
                                    let _e1547 = phi_2194_;
                                    if _e1545 {
                                        phi_2198_ = true;
                                    } else {
                                        phi_2198_ = _e1547;
                                    }
                                    let _e1549 = phi_2198_;
                                    if _e1549 {
                                        phi_2202_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                    } else {
                                        phi_2202_ = _e1543;
                                    }
                                    let _e1551 = phi_2202_;
                                    if _e1551.is_hit {
                                        if (_e1551.t > 0f) {
                                            if (_e1551.t < _e269) {
                                                let _e1558 = triangles.member[(0u + _e1103)].i0_;
                                                if ((_e1558 & 2147483648u) == 0u) {
                                                    phi_2421_ = true;
                                                } else {
                                                    if (_e1103 < _e81) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1567 = triangles.member[(0u + _e1103)].i0_;
                                                    let _e1568 = (_e1567 & 2147483647u);
                                                    let _e1570 = triangles.member[(0u + _e1103)].i1_;
                                                    let _e1572 = triangles.member[(0u + _e1103)].i2_;
                                                    if (_e1568 < _e87) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1576 = vertices.member[(0u + _e1568)];
                                                    if (_e1570 < _e87) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1580 = vertices.member[(0u + _e1570)];
                                                    if (_e1572 < _e87) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1584 = vertices.member[(0u + _e1572)];
                                                    let _e1585 = array<abi_Vertex, 3>(_e1576, _e1580, _e1584);
                                                    if (_e1585[0].material < arrayLength((&materials.member))) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1591 = materials.member[(0u + _e1585[0].material)];
                                                    if ((_e1591.flags & 1u) == 1u) {
                                                        let _e1596 = ((1f - _e1551.u) - _e1551.v);
                                                        if (_e1591.cutoff <= 0f) {
                                                            phi_2419_ = true;
                                                        } else {
                                                            let _e1623 = (_e1591.base_color.w * ((((f32((_e1585[0].color >> bitcast<u32>(24i))) * _e1596) + (f32((_e1585[1].color >> bitcast<u32>(24i))) * _e1551.u)) + (f32((_e1585[2].color >> bitcast<u32>(24i))) * _e1551.v)) * (1f / 255f)));
                                                            if (_e1591.alpha_size == 0u) {
                                                                phi_2416_ = _e1623;
                                                            } else {
                                                                local.offset = _e1591.alpha_offset;
                                                                local.size = _e1591.alpha_size;
                                                                local.flags = _e1591.flags;
                                                                let _e1654 = _lt_shaders_texture_TextureView_quad((&local), (((_e1585[0].u * _e1596) + (_e1585[1].u * _e1551.u)) + (_e1585[2].u * _e1551.v)), (((_e1585[0].v * _e1596) + (_e1585[1].v * _e1551.u)) + (_e1585[2].v * _e1551.v)));
                                                                let _e1658 = (_e1654.indices[0] >> bitcast<u32>(2i));
                                                                if (_e1658 < _e93) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1662 = alpha_texels.member[(0u + _e1658)];
                                                                let _e1678 = (_e1654.indices[1] >> bitcast<u32>(2i));
                                                                if (_e1678 < _e93) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1682 = alpha_texels.member[(0u + _e1678)];
                                                                let _e1699 = (_e1654.indices[2] >> bitcast<u32>(2i));
                                                                if (_e1699 < _e93) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1703 = alpha_texels.member[(0u + _e1699)];
                                                                let _e1720 = (_e1654.indices[3] >> bitcast<u32>(2i));
                                                                if (_e1720 < _e93) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1724 = alpha_texels.member[(0u + _e1720)];
                                                                phi_2416_ = (_e1623 * (((((f32(((_e1662 >> bitcast<u32>((((_e1654.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1654.weights.x) + ((f32(((_e1682 >> bitcast<u32>((((_e1654.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1654.weights.y)) + ((f32(((_e1703 >> bitcast<u32>((((_e1654.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1654.weights.z)) + ((f32(((_e1724 >> bitcast<u32>((((_e1654.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1654.weights.w)));
                                                            }
                                                            let _e1740 = phi_2416_;
                                                            phi_2419_ = (_e1740 >= _e1591.cutoff);
                                                        }
                                                        let _e1744 = phi_2419_;
                                                        phi_2420_ = _e1744;
                                                    } else {
                                                        phi_2420_ = false;
                                                    }
                                                    let _e1746 = phi_2420_;
                                                    phi_2421_ = _e1746;
                                                }
                                                let _e1748 = phi_2421_;
                                                if _e1748 {
                                                    phi_2425_ = false;
                                                } else {
                                                    phi_2425_ = true;
                                                }
                                                let _e1750 = phi_2425_;
                                                phi_2426_ = _e1748;
                                                phi_2427_ = _e1748;
                                                phi_2428_ = _e1750;
                                            } else {
                                                phi_2426_ = bool();
                                                phi_2427_ = _e1094;
                                                phi_2428_ = true;
                                            }
                                            let _e1752 = phi_2426_;
                                            let _e1754 = phi_2427_;
                                            let _e1756 = phi_2428_;
                                            phi_2429_ = _e1752;
                                            phi_2430_ = _e1754;
                                            phi_2431_ = _e1756;
                                        } else {
                                            phi_2429_ = bool();
                                            phi_2430_ = _e1094;
                                            phi_2431_ = true;
                                        }
                                        let _e1758 = phi_2429_;
                                        let _e1760 = phi_2430_;
                                        let _e1762 = phi_2431_;
                                        phi_2432_ = _e1758;
                                        phi_2433_ = _e1760;
                                        phi_2434_ = _e1762;
                                    } else {
                                        phi_2432_ = bool();
                                        phi_2433_ = _e1094;
                                        phi_2434_ = true;
                                    }
                                    let _e1764 = phi_2432_;
                                    let _e1766 = phi_2433_;
                                    let _e1768 = phi_2434_;
                                    if _e1768 {
                                    }
                                    phi_1632_ = (_e1092 & (_e1092 - 1u));
                                    phi_1635_ = _e1766;
                                    phi_2438_ = _e1764;
                                    phi_2439_ = _e1768;
                                }
                                let _e1770 = phi_1632_;
                                let _e1772 = phi_1635_;
                                let _e1774 = phi_2438_;
                                let _e1776 = phi_2439_;
                                local_9 = _e1774;
                                continue;
                                continuing {
                                    phi_1631_ = _e1770;
                                    phi_1634_ = _e1772;
                                    break if !(_e1776);
                                }
                            }
                            let _e1779 = local_6;
                            if _e1779 {
                                let _e1781 = local_1.group_mask;
                                if ((_e1781 & 4278190080u) == 0u) {
                                    let _e1785 = local_1.len;
                                    if (_e1785 == 0u) {
                                        phi_2481_ = false;
                                    } else {
                                        let _e1789 = local_1.len;
                                        local_1.len = (_e1789 - 1u);
                                        let _e1792 = local_1.len;
                                        if (_e1792 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1797 = local_1.first[(0u + _e1792)];
                                        local_1.group = _e1797;
                                        let _e1800 = local_1.len;
                                        if (_e1800 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1805 = local_1.mask[(0u + _e1800)];
                                        local_1.group_mask = _e1805;
                                        phi_2481_ = true;
                                    }
                                    let _e1808 = phi_2481_;
                                    phi_2482_ = _e1808;
                                } else {
                                    phi_2482_ = true;
                                }
                                let _e1810 = phi_2482_;
                                if _e1810 {
                                    let _e1812 = local_1.group_mask;
                                    let _e1818 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1812)), 32u, (_e1812 == 0u)));
                                    let _e1822 = local_1.group_mask;
                                    let _e1836 = local_1.group_mask;
                                    local_1.group_mask = (_e1836 & ~((1u << bitcast<u32>((_e1818 & 31u)))));
                                    let _e1839 = local_1.group;
                                    phi_2513_ = (_e1839 + countOneBits(((_e1822 & ~((4294967295u << bitcast<u32>((((_e1818 - 24u) ^ _e516) & 31u))))) & 255u)));
                                } else {
                                    phi_2513_ = 4294967295u;
                                }
                                let _e1842 = phi_2513_;
                                phi_2514_ = _e1842;
                            } else {
                                phi_2514_ = u32();
                            }
                            let _e1844 = phi_2514_;
                            phi_1300_ = _e1844;
                            let _e2062 = local_8;
                            phi_1303_ = _e2062;
                            let _e2065 = local_9;
                            phi_2515_ = _e2065;
                            let _e2068 = local_10;
                            phi_2516_ = _e2068;
                            phi_2517_ = false;
                        } else {
                            phi_1300_ = u32();
                            phi_1303_ = bool();
                            phi_2515_ = bool();
                            phi_2516_ = false;
                            phi_2517_ = true;
                        }
                        let _e1846 = phi_1300_;
                        let _e1848 = phi_1303_;
                        let _e1850 = phi_2515_;
                        let _e1852 = phi_2516_;
                        let _e1854 = phi_2517_;
                        local_7 = _e1854;
                        local_11 = _e1850;
                        continue;
                        continuing {
                            phi_1299_ = _e1846;
                            phi_1302_ = _e1848;
                            break if !(_e1852);
                        }
                    }
                    let _e1857 = local_7;
                    if _e1857 {
                        phi_2521_ = false;
                    } else {
                        phi_2521_ = true;
                    }
                    let _e1859 = phi_2521_;
                    if _e1859 {
                        let _e2074 = local_11;
                        phi_2525_ = _e2074;
                    } else {
                        let _e2076 = local_12;
                        phi_2525_ = _e2076;
                    }
                    let _e1861 = phi_2525_;
                    phi_2526_ = _e1861;
                }
                let _e1863 = phi_2526_;
                phi_2527_ = _e1863;
                phi_2528_ = _e342;
            } else {
                phi_2527_ = bool();
                phi_2528_ = true;
            }
            let _e1865 = phi_2527_;
            let _e1867 = phi_2528_;
            if _e1867 {
                phi_2532_ = false;
            } else {
                phi_2532_ = _e1865;
            }
            let _e1869 = phi_2532_;
            if _e1869 {
                phi_2536_ = 0f;
            } else {
                phi_2536_ = 1f;
            }
            let _e1871 = phi_2536_;
            phi_2537_ = _e1871;
        }
        let _e1873 = phi_2537_;
        if (_e99.shift < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e99.shift)] = _e1873;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
