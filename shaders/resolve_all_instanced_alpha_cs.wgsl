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

struct type_38 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_43 {
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

struct type_47 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_51 {
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

struct type_55 {
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

struct lt_bvh_Instance {
    world_to_object: array<vec4<f32>, 3>,
    object_to_world: array<vec4<f32>, 3>,
    low_world: vec3<f32>,
    root: u32,
    high_world: vec3<f32>,
    first_triangle: u32,
    source: u32,
    padding: array<u32, 3>,
}

struct type_69 {
    member: array<lt_bvh_Instance>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_38;
@group(0) @binding(2) 
var<storage> nodes: type_43;
@group(0) @binding(3) 
var<storage> triangles: type_47;
@group(0) @binding(6) 
var<storage> vertices: type_51;
@group(0) @binding(7) 
var<storage> materials: type_55;
@group(0) @binding(8) 
var<storage> alpha_texels: type_13;
@group(0) @binding(5) 
var<storage> instances: type_69;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_234_: lt_mask_LightPlace;
    var phi_235_: bool;
    var phi_236_: lt_mask_LightPlace;
    var phi_237_: bool;
    var phi_242_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_234_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_235_ = false;
        } else {
            phi_234_ = lt_mask_LightPlace();
            phi_235_ = true;
        }
        let _e81 = phi_234_;
        let _e83 = phi_235_;
        phi_236_ = _e81;
        phi_237_ = _e83;
    } else {
        phi_236_ = lt_mask_LightPlace();
        phi_237_ = true;
    }
    let _e85 = phi_236_;
    let _e87 = phi_237_;
    if _e87 {
        phi_242_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_242_ = _e85;
    }
    let _e92 = phi_242_;
    return lt_mask_LightPlace(_e92.word, _e92.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_257_: bool;
    var phi_261_: f32;

    if (param_3 != param_3) {
        phi_257_ = true;
    } else {
        let _e71 = (param_4 >= param_3);
        if _e71 {
        }
        phi_257_ = _e71;
    }
    let _e73 = phi_257_;
    if _e73 {
        phi_261_ = param_4;
    } else {
        phi_261_ = param_3;
    }
    let _e75 = phi_261_;
    return _e75;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_273_: bool;
    var phi_277_: f32;

    if (param_5 != param_5) {
        phi_273_ = true;
    } else {
        let _e71 = (param_6 <= param_5);
        if _e71 {
        }
        phi_273_ = _e71;
    }
    let _e73 = phi_273_;
    if _e73 {
        phi_277_ = param_6;
    } else {
        phi_277_ = param_5;
    }
    let _e75 = phi_277_;
    return _e75;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_319_: f32;
    var phi_324_: f32;
    var phi_325_: bool;
    var phi_326_: f32;
    var phi_327_: bool;
    var phi_331_: f32;
    var phi_357_: f32;
    var phi_362_: f32;
    var phi_363_: bool;
    var phi_364_: f32;
    var phi_365_: bool;
    var phi_369_: f32;
    var phi_377_: f32;
    var phi_378_: f32;
    var phi_379_: f32;
    var phi_388_: f32;
    var phi_389_: f32;
    var phi_407_: u32;
    var phi_421_: u32;
    var phi_428_: u32;
    var phi_433_: u32;
    var phi_439_: u32;
    var phi_444_: u32;
    var phi_446_: texture_Axis;
    var phi_474_: f32;
    var phi_479_: f32;
    var phi_480_: bool;
    var phi_481_: f32;
    var phi_482_: bool;
    var phi_486_: f32;
    var phi_512_: f32;
    var phi_517_: f32;
    var phi_518_: bool;
    var phi_519_: f32;
    var phi_520_: bool;
    var phi_524_: f32;
    var phi_532_: f32;
    var phi_533_: f32;
    var phi_534_: f32;
    var phi_543_: f32;
    var phi_544_: f32;
    var phi_562_: u32;
    var phi_576_: u32;
    var phi_583_: u32;
    var phi_588_: u32;
    var phi_594_: u32;
    var phi_599_: u32;
    var phi_601_: texture_Axis;

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
                phi_319_ = 1f;
            } else {
                phi_319_ = 0f;
            }
            let _e102 = phi_319_;
            if (param_8 < 8388608f) {
                phi_324_ = (_e99 - _e102);
                phi_325_ = false;
            } else {
                phi_324_ = f32();
                phi_325_ = true;
            }
            let _e105 = phi_324_;
            let _e107 = phi_325_;
            phi_326_ = _e105;
            phi_327_ = _e107;
        } else {
            phi_326_ = f32();
            phi_327_ = true;
        }
        let _e109 = phi_326_;
        let _e111 = phi_327_;
        if _e111 {
            phi_331_ = param_8;
        } else {
            phi_331_ = _e109;
        }
        let _e113 = phi_331_;
        phi_379_ = (param_8 - _e113);
    } else {
        if (_e86 == 1u) {
            let _e116 = (param_8 * 0.5f);
            if (_e116 > -8388608f) {
                let _e128 = f32(select(0i, select(select(i32(_e116), i32(-2147483648), (_e116 < bitcast<f32>(3472883712u))), 2147483647i, (_e116 > bitcast<f32>(1325400063u))), (_e116 == _e116)));
                if (_e128 > _e116) {
                    phi_357_ = 1f;
                } else {
                    phi_357_ = 0f;
                }
                let _e131 = phi_357_;
                if (_e116 < 8388608f) {
                    phi_362_ = (_e128 - _e131);
                    phi_363_ = false;
                } else {
                    phi_362_ = f32();
                    phi_363_ = true;
                }
                let _e134 = phi_362_;
                let _e136 = phi_363_;
                phi_364_ = _e134;
                phi_365_ = _e136;
            } else {
                phi_364_ = f32();
                phi_365_ = true;
            }
            let _e138 = phi_364_;
            let _e140 = phi_365_;
            if _e140 {
                phi_369_ = _e116;
            } else {
                phi_369_ = _e138;
            }
            let _e142 = phi_369_;
            let _e144 = (param_8 - (2f * _e142));
            if (_e144 > 1f) {
                phi_377_ = (2f - _e144);
            } else {
                phi_377_ = _e144;
            }
            let _e148 = phi_377_;
            phi_378_ = _e148;
        } else {
            phi_378_ = param_8;
        }
        let _e150 = phi_378_;
        phi_379_ = _e150;
    }
    let _e152 = phi_379_;
    if (_e152 > 0f) {
        if (_e152 < 1f) {
            phi_388_ = _e152;
        } else {
            phi_388_ = 1f;
        }
        let _e156 = phi_388_;
        phi_389_ = _e156;
    } else {
        phi_389_ = 0f;
    }
    let _e158 = phi_389_;
    let _e159 = (_e73 - 1u);
    let _e161 = (_e158 * f32(_e73));
    if _e81 {
        let _e168 = select(select(u32(_e161), 0u, (_e161 < bitcast<f32>(0u))), 4294967295u, (_e161 > bitcast<f32>(1333788671u)));
        if (_e159 < _e168) {
            phi_407_ = _e159;
        } else {
            phi_407_ = _e168;
        }
        let _e171 = phi_407_;
        phi_446_ = texture_Axis(_e171, _e171, 0f);
    } else {
        let _e173 = (_e161 + 0.5f);
        let _e180 = select(select(u32(_e173), 0u, (_e173 < bitcast<f32>(0u))), 4294967295u, (_e173 > bitcast<f32>(1333788671u)));
        if (_e73 < _e180) {
            phi_421_ = _e73;
        } else {
            phi_421_ = _e180;
        }
        let _e183 = phi_421_;
        if (_e86 == 0u) {
            phi_428_ = _e159;
        } else {
            phi_428_ = 0u;
        }
        let _e188 = phi_428_;
        if (_e86 == 0u) {
            phi_433_ = 0u;
        } else {
            phi_433_ = _e159;
        }
        let _e191 = phi_433_;
        if (_e183 == 0u) {
            phi_439_ = _e188;
        } else {
            phi_439_ = (_e183 - 1u);
        }
        let _e195 = phi_439_;
        if (_e183 > _e159) {
            phi_444_ = _e191;
        } else {
            phi_444_ = _e183;
        }
        let _e198 = phi_444_;
        phi_446_ = texture_Axis(_e195, _e198, (_e173 - f32(_e183)));
    }
    let _e201 = phi_446_;
    let _e203 = (*param_7).flags;
    let _e206 = ((_e203 >> bitcast<u32>(6u)) & 3u);
    if (_e206 == 0u) {
        if (param_9 > -8388608f) {
            let _e219 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e219 > param_9) {
                phi_474_ = 1f;
            } else {
                phi_474_ = 0f;
            }
            let _e222 = phi_474_;
            if (param_9 < 8388608f) {
                phi_479_ = (_e219 - _e222);
                phi_480_ = false;
            } else {
                phi_479_ = f32();
                phi_480_ = true;
            }
            let _e225 = phi_479_;
            let _e227 = phi_480_;
            phi_481_ = _e225;
            phi_482_ = _e227;
        } else {
            phi_481_ = f32();
            phi_482_ = true;
        }
        let _e229 = phi_481_;
        let _e231 = phi_482_;
        if _e231 {
            phi_486_ = param_9;
        } else {
            phi_486_ = _e229;
        }
        let _e233 = phi_486_;
        phi_534_ = (param_9 - _e233);
    } else {
        if (_e206 == 1u) {
            let _e236 = (param_9 * 0.5f);
            if (_e236 > -8388608f) {
                let _e248 = f32(select(0i, select(select(i32(_e236), i32(-2147483648), (_e236 < bitcast<f32>(3472883712u))), 2147483647i, (_e236 > bitcast<f32>(1325400063u))), (_e236 == _e236)));
                if (_e248 > _e236) {
                    phi_512_ = 1f;
                } else {
                    phi_512_ = 0f;
                }
                let _e251 = phi_512_;
                if (_e236 < 8388608f) {
                    phi_517_ = (_e248 - _e251);
                    phi_518_ = false;
                } else {
                    phi_517_ = f32();
                    phi_518_ = true;
                }
                let _e254 = phi_517_;
                let _e256 = phi_518_;
                phi_519_ = _e254;
                phi_520_ = _e256;
            } else {
                phi_519_ = f32();
                phi_520_ = true;
            }
            let _e258 = phi_519_;
            let _e260 = phi_520_;
            if _e260 {
                phi_524_ = _e236;
            } else {
                phi_524_ = _e258;
            }
            let _e262 = phi_524_;
            let _e264 = (param_9 - (2f * _e262));
            if (_e264 > 1f) {
                phi_532_ = (2f - _e264);
            } else {
                phi_532_ = _e264;
            }
            let _e268 = phi_532_;
            phi_533_ = _e268;
        } else {
            phi_533_ = param_9;
        }
        let _e270 = phi_533_;
        phi_534_ = _e270;
    }
    let _e272 = phi_534_;
    if (_e272 > 0f) {
        if (_e272 < 1f) {
            phi_543_ = _e272;
        } else {
            phi_543_ = 1f;
        }
        let _e276 = phi_543_;
        phi_544_ = _e276;
    } else {
        phi_544_ = 0f;
    }
    let _e278 = phi_544_;
    let _e279 = (_e77 - 1u);
    let _e281 = (_e278 * f32(_e77));
    if _e81 {
        let _e288 = select(select(u32(_e281), 0u, (_e281 < bitcast<f32>(0u))), 4294967295u, (_e281 > bitcast<f32>(1333788671u)));
        if (_e279 < _e288) {
            phi_562_ = _e279;
        } else {
            phi_562_ = _e288;
        }
        let _e291 = phi_562_;
        phi_601_ = texture_Axis(_e291, _e291, 0f);
    } else {
        let _e293 = (_e281 + 0.5f);
        let _e300 = select(select(u32(_e293), 0u, (_e293 < bitcast<f32>(0u))), 4294967295u, (_e293 > bitcast<f32>(1333788671u)));
        if (_e77 < _e300) {
            phi_576_ = _e77;
        } else {
            phi_576_ = _e300;
        }
        let _e303 = phi_576_;
        if (_e206 == 0u) {
            phi_583_ = _e279;
        } else {
            phi_583_ = 0u;
        }
        let _e308 = phi_583_;
        if (_e206 == 0u) {
            phi_588_ = 0u;
        } else {
            phi_588_ = _e279;
        }
        let _e311 = phi_588_;
        if (_e303 == 0u) {
            phi_594_ = _e308;
        } else {
            phi_594_ = (_e303 - 1u);
        }
        let _e315 = phi_594_;
        if (_e303 > _e279) {
            phi_599_ = _e311;
        } else {
            phi_599_ = _e303;
        }
        let _e318 = phi_599_;
        phi_601_ = texture_Axis(_e315, _e318, (_e293 - f32(_e303)));
    }
    let _e321 = phi_601_;
    let _e325 = (*param_7).offset;
    let _e332 = (*param_7).offset;
    let _e339 = (*param_7).offset;
    let _e346 = (*param_7).offset;
    return texture_TexelQuad(array<u32, 4>(((_e325 + (_e321.low * _e73)) + _e201.low), ((_e332 + (_e321.low * _e73)) + _e201.high), ((_e339 + (_e321.high * _e73)) + _e201.low), ((_e346 + (_e321.high * _e73)) + _e201.high)), vec4<f32>(((1f - _e201.fraction) * (1f - _e321.fraction)), (_e201.fraction * (1f - _e321.fraction)), ((1f - _e201.fraction) * _e321.fraction), (_e201.fraction * _e321.fraction)));
}

fn _lt_shaders_abi_Sample_is_valid(param_10: ptr<function, abi_Sample>) -> bool {
    var phi_673_: bool;
    var phi_674_: bool;
    var phi_675_: bool;
    var phi_676_: bool;
    var phi_680_: bool;

    let _e71 = (*param_10).normal[0u];
    let _e73 = global[0u];
    if (_e71 == _e73) {
        let _e76 = (*param_10).normal[1u];
        let _e78 = global[1u];
        if (_e76 == _e78) {
            let _e81 = (*param_10).normal[2u];
            let _e83 = global[2u];
            phi_673_ = (_e81 == _e83);
            phi_674_ = false;
        } else {
            phi_673_ = bool();
            phi_674_ = true;
        }
        let _e86 = phi_673_;
        let _e88 = phi_674_;
        phi_675_ = _e86;
        phi_676_ = _e88;
    } else {
        phi_675_ = bool();
        phi_676_ = true;
    }
    let _e90 = phi_675_;
    let _e92 = phi_676_;
    if _e92 {
        phi_680_ = false;
    } else {
        phi_680_ = _e90;
    }
    let _e94 = phi_680_;
    return !(_e94);
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: lt_bvh_traverse_Stack;
    var local_3: abi_Sample;
    var phi_802_: bool;
    var phi_803_: bool;
    var phi_814_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_815_: bool;
    var phi_816_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_817_: bool;
    var phi_824_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_828_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_880_: f32;
    var phi_936_: bool;
    var phi_937_: bool;
    var phi_938_: bool;
    var phi_942_: bool;
    var phi_943_: bool;
    var phi_944_: bool;
    var phi_945_: bool;
    var phi_946_: bool;
    var phi_947_: bool;
    var phi_948_: bool;
    var phi_949_: bool;
    var phi_950_: bool;
    var phi_951_: bool;
    var phi_952_: bool;
    var phi_953_: bool;
    var phi_954_: bool;
    var phi_955_: bool;
    var phi_956_: bool;
    var phi_957_: bool;
    var phi_958_: bool;
    var phi_959_: bool;
    var phi_963_: bool;
    var phi_967_: bool;
    var phi_1037_: f32;
    var phi_1044_: f32;
    var phi_1051_: f32;
    var phi_1058_: f32;
    var phi_1065_: f32;
    var phi_1072_: f32;
    var phi_1089_: f32;
    var phi_1094_: f32;
    var phi_1099_: f32;
    var phi_1120_: u32;
    var phi_1125_: u32;
    var phi_1130_: u32;
    var phi_1244_: bool;
    var phi_1245_: bool;
    var phi_1276_: u32;
    var phi_1278_: u32;
    var phi_1281_: bool;
    var phi_1361_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1388_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1415_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1421_: u32;
    var phi_1424_: u32;
    var phi_1438_: u32;
    var phi_1448_: u32;
    var phi_1458_: u32;
    var phi_1476_: u32;
    var phi_1486_: u32;
    var phi_1496_: u32;
    var phi_1532_: u32;
    var phi_1545_: u32;
    var phi_1550_: u32;
    var phi_1551_: u32;
    var phi_1552_: u32;
    var phi_1422_: u32;
    var phi_1425_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_1610_: u32;
    var phi_1613_: bool;
    var phi_1662_: f32;
    var phi_1667_: f32;
    var phi_1672_: f32;
    var phi_1680_: f32;
    var phi_1685_: f32;
    var phi_1690_: f32;
    var phi_1834_: bool;
    var phi_1835_: bool;
    var phi_1836_: bool;
    var phi_1840_: bool;
    var phi_1841_: bool;
    var phi_1842_: bool;
    var phi_1843_: bool;
    var phi_1844_: bool;
    var phi_1845_: bool;
    var phi_1846_: bool;
    var phi_1847_: bool;
    var phi_1848_: bool;
    var phi_1849_: bool;
    var phi_1850_: bool;
    var phi_1851_: bool;
    var phi_1852_: bool;
    var phi_1853_: bool;
    var phi_1854_: bool;
    var phi_1855_: bool;
    var phi_1856_: bool;
    var phi_1857_: bool;
    var phi_1861_: bool;
    var phi_1865_: bool;
    var phi_1935_: f32;
    var phi_1942_: f32;
    var phi_1949_: f32;
    var phi_1956_: f32;
    var phi_1963_: f32;
    var phi_1970_: f32;
    var phi_1987_: f32;
    var phi_1992_: f32;
    var phi_1997_: f32;
    var phi_2025_: bool;
    var phi_2026_: bool;
    var phi_2034_: u32;
    var phi_2035_: u32;
    var phi_2046_: vec3<f32>;
    var phi_2047_: vec3<f32>;
    var phi_2060_: u32;
    var phi_2065_: u32;
    var phi_2070_: u32;
    var phi_2184_: bool;
    var phi_2185_: bool;
    var phi_2216_: u32;
    var phi_2218_: u32;
    var phi_2221_: bool;
    var phi_2301_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2328_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2355_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2361_: u32;
    var phi_2364_: u32;
    var phi_2378_: u32;
    var phi_2388_: u32;
    var phi_2398_: u32;
    var phi_2416_: u32;
    var phi_2426_: u32;
    var phi_2436_: u32;
    var phi_2472_: u32;
    var phi_2485_: u32;
    var phi_2490_: u32;
    var phi_2491_: u32;
    var phi_2492_: u32;
    var phi_2362_: u32;
    var phi_2365_: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var phi_2550_: u32;
    var phi_2553_: bool;
    var phi_2597_: vec3<f32>;
    var phi_2598_: vec3<f32>;
    var phi_2627_: vec3<f32>;
    var phi_2628_: vec3<f32>;
    var phi_2657_: vec3<f32>;
    var phi_2658_: vec3<f32>;
    var phi_2676_: bool;
    var phi_2677_: bool;
    var phi_2681_: f32;
    var phi_2682_: f32;
    var phi_2683_: f32;
    var phi_2684_: f32;
    var phi_2692_: f32;
    var phi_2702_: bool;
    var phi_2703_: bool;
    var phi_2707_: f32;
    var phi_2708_: f32;
    var phi_2709_: f32;
    var phi_2710_: f32;
    var phi_2718_: f32;
    var phi_2728_: bool;
    var phi_2729_: bool;
    var phi_2733_: f32;
    var phi_2734_: f32;
    var phi_2735_: f32;
    var phi_2736_: f32;
    var phi_2744_: f32;
    var phi_2759_: f32;
    var phi_2760_: bool;
    var phi_2761_: f32;
    var phi_2762_: bool;
    var phi_2763_: f32;
    var phi_2764_: bool;
    var phi_2782_: f32;
    var phi_2783_: bool;
    var phi_2784_: bool;
    var phi_2785_: f32;
    var phi_2786_: bool;
    var phi_2787_: bool;
    var phi_2791_: bool;
    var phi_2792_: f32;
    var phi_2793_: bool;
    var phi_2821_: vec3<f32>;
    var phi_2822_: vec3<f32>;
    var phi_2847_: vec3<f32>;
    var phi_2848_: vec3<f32>;
    var phi_2873_: vec3<f32>;
    var phi_2874_: vec3<f32>;
    var phi_2930_: f32;
    var phi_2939_: f32;
    var phi_2948_: f32;
    var phi_2957_: f32;
    var phi_2964_: f32;
    var phi_2971_: f32;
    var phi_2984_: f32;
    var phi_2993_: f32;
    var phi_3002_: f32;
    var phi_3011_: f32;
    var phi_3018_: f32;
    var phi_3025_: f32;
    var phi_3042_: f32;
    var phi_3047_: f32;
    var phi_3052_: f32;
    var phi_3060_: f32;
    var phi_3065_: f32;
    var phi_3070_: f32;
    var phi_3082_: f32;
    var phi_3087_: f32;
    var phi_3092_: f32;
    var phi_3097_: f32;
    var phi_3102_: lt_bvh_triangle_Intersection;
    var phi_3103_: bool;
    var phi_3104_: lt_bvh_triangle_Intersection;
    var phi_3105_: bool;
    var phi_3109_: lt_bvh_triangle_Intersection;
    var phi_3110_: bool;
    var phi_3111_: lt_bvh_triangle_Intersection;
    var phi_3112_: bool;
    var phi_3113_: bool;
    var phi_3117_: bool;
    var phi_3121_: lt_bvh_triangle_Intersection;
    var phi_3335_: f32;
    var phi_3338_: bool;
    var phi_3339_: bool;
    var phi_3340_: bool;
    var phi_3344_: bool;
    var phi_3345_: bool;
    var phi_3346_: bool;
    var phi_3347_: bool;
    var phi_3348_: bool;
    var phi_3349_: bool;
    var phi_3350_: bool;
    var phi_3351_: bool;
    var phi_3352_: bool;
    var phi_3353_: bool;
    var phi_2551_: u32;
    var phi_2554_: bool;
    var phi_3357_: bool;
    var phi_3358_: bool;
    var local_10: bool;
    var phi_3400_: bool;
    var phi_3401_: bool;
    var phi_3432_: u32;
    var phi_3433_: u32;
    var phi_2219_: u32;
    var phi_2222_: bool;
    var phi_3434_: bool;
    var phi_3435_: bool;
    var phi_3436_: bool;
    var local_11: bool;
    var phi_3440_: bool;
    var phi_3444_: bool;
    var phi_3445_: bool;
    var phi_3446_: bool;
    var phi_3447_: bool;
    var phi_3451_: bool;
    var phi_3455_: bool;
    var phi_3456_: bool;
    var phi_3457_: bool;
    var phi_3458_: bool;
    var phi_3459_: bool;
    var phi_3460_: bool;
    var phi_3461_: bool;
    var phi_1611_: u32;
    var phi_1614_: bool;
    var phi_3465_: bool;
    var local_12: bool;
    var phi_3507_: bool;
    var phi_3508_: bool;
    var phi_3539_: u32;
    var phi_3540_: u32;
    var phi_1279_: u32;
    var phi_1282_: bool;
    var phi_3541_: bool;
    var phi_3542_: bool;
    var local_13: bool;
    var phi_3546_: bool;
    var phi_3550_: bool;
    var phi_3551_: bool;
    var phi_3552_: bool;
    var phi_3556_: bool;
    var phi_3557_: bool;
    var phi_3561_: bool;
    var phi_3565_: f32;
    var phi_3566_: f32;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;
    var local_18: bool;
    var local_19: bool;
    var local_20: bool;

    let _e72 = id_1;
    let _e79 = arrayLength((&nodes.member));
    let _e82 = arrayLength((&triangles.member));
    let _e91 = arrayLength((&vertices.member));
    let _e97 = arrayLength((&alpha_texels.member));
    let _e100 = p.member.size[0u];
    let _e102 = p.member.size[1u];
    let _e103 = lt_shaders_entry_pixel_index(_e72, _e100, _e102);
    if (bitcast<i32>(_e103.word) != 0i) {
        if (_e103.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e111 = samples.member[(0u + _e103.shift)];
        local_3 = abi_Sample(_e111.position, _e111.magnitude, _e111.normal, _e111.flags, _e111.shading_normal, _e111.albedo);
        let _e120 = _lt_shaders_abi_Sample_is_valid((&local_3));
        if _e120 {
            let _e122 = local_3.position;
            let _e124 = p.member.light.place;
            let _e130 = p.member.light.place[3u];
            let _e137 = (_e124.x - (_e122.x * _e130));
            let _e138 = (_e124.y - (_e122.y * _e130));
            let _e139 = (_e124.z - (_e122.z * _e130));
            let _e141 = local_3.normal;
            if ((((_e141.x * _e137) + (_e141.y * _e138)) + (_e141.z * _e139)) > 0f) {
                let _e155 = (((_e137 * _e137) + (_e138 * _e138)) + (_e139 * _e139));
                let _e157 = p.member.light.axis;
                let _e169 = p.member.light.place[3u];
                if (_e169 == 0f) {
                    phi_803_ = true;
                } else {
                    let _e172 = p.member.light.range_squared;
                    if (_e155 <= _e172) {
                        let _e175 = p.member.light.cos_outer;
                        phi_802_ = (-((((_e137 * _e157.x) + (_e138 * _e157.y)) + (_e139 * _e157.z))) >= (_e175 * sqrt(_e155)));
                    } else {
                        phi_802_ = false;
                    }
                    let _e180 = phi_802_;
                    phi_803_ = _e180;
                }
                let _e182 = phi_803_;
                if _e182 {
                    let _e184 = local_3.flags;
                    let _e192 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e198 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e192.unnamed.visibility, false), _e192.unnamed_1);
                    phi_814_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e198.unnamed, ((_e184 & 1u) == 0u));
                    phi_815_ = false;
                } else {
                    phi_814_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_815_ = true;
                }
                let _e203 = phi_814_;
                let _e205 = phi_815_;
                phi_816_ = _e203;
                phi_817_ = _e205;
            } else {
                phi_816_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_817_ = true;
            }
            let _e207 = phi_816_;
            let _e209 = phi_817_;
            if _e209 {
                let _e215 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e215.unnamed.visibility, false), _e215.unnamed_1);
                phi_824_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e221.unnamed, true);
            } else {
                phi_824_ = _e207;
            }
            let _e226 = phi_824_;
            phi_828_ = _e226;
        } else {
            let _e232 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e238 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e232.unnamed.visibility, false), _e232.unnamed_1);
            phi_828_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e238.unnamed, true);
        }
        let _e243 = phi_828_;
        let _e248 = p.member.root;
        if _e243.unnamed_1 {
            phi_3566_ = _e243.unnamed.visibility;
        } else {
            let _e251 = local_3.position;
            let _e253 = local_3.normal;
            let _e255 = local_3.magnitude;
            let _e257 = ((8f / 8388608f) * _e255);
            let _e265 = (_e251.x + (_e253.x * _e257));
            let _e267 = (_e251.y + (_e253.y * _e257));
            let _e269 = (_e251.z + (_e253.z * _e257));
            let _e271 = p.member.light.place;
            if (_e271.w == 0f) {
                phi_880_ = 300000000000000000000000000000000000000f;
            } else {
                phi_880_ = 1f;
            }
            let _e275 = phi_880_;
            let _e283 = (_e271.x - (_e265 * _e271.w));
            let _e284 = (_e271.y - (_e267 * _e271.w));
            let _e285 = (_e271.z - (_e269 * _e271.w));
            let _e289 = abs(_e283);
            let _e290 = abs(_e284);
            let _e291 = abs(_e285);
            if (abs(_e265) < 1000000000000000f) {
                if (abs(_e267) < 1000000000000000f) {
                    if (abs(_e269) < 1000000000000000f) {
                        if (_e289 < 1000000000000000f) {
                            if (_e290 < 1000000000000000f) {
                                if (_e291 < 1000000000000000f) {
                                    if (_e289 > 0f) {
                                        phi_937_ = bool();
                                        phi_938_ = true;
                                    } else {
                                        let _e299 = (_e290 > 0f);
                                        if _e299 {
                                            phi_936_ = bool();
                                        } else {
                                            phi_936_ = (_e291 > 0f);
                                        }
                                        let _e302 = phi_936_;
                                        phi_937_ = _e302;
                                        phi_938_ = _e299;
                                    }
                                    let _e304 = phi_937_;
                                    let _e306 = phi_938_;
                                    if _e306 {
                                        phi_942_ = true;
                                    } else {
                                        phi_942_ = _e304;
                                    }
                                    let _e308 = phi_942_;
                                    phi_943_ = _e308;
                                    phi_944_ = false;
                                } else {
                                    phi_943_ = bool();
                                    phi_944_ = true;
                                }
                                let _e310 = phi_943_;
                                let _e312 = phi_944_;
                                phi_945_ = _e310;
                                phi_946_ = false;
                                phi_947_ = _e312;
                            } else {
                                phi_945_ = bool();
                                phi_946_ = true;
                                phi_947_ = false;
                            }
                            let _e314 = phi_945_;
                            let _e316 = phi_946_;
                            let _e318 = phi_947_;
                            phi_948_ = _e314;
                            phi_949_ = _e316;
                            phi_950_ = _e318;
                        } else {
                            phi_948_ = bool();
                            phi_949_ = true;
                            phi_950_ = false;
                        }
                        let _e320 = phi_948_;
                        let _e322 = phi_949_;
                        let _e324 = phi_950_;
                        phi_951_ = _e320;
                        phi_952_ = _e322;
                        phi_953_ = _e324;
                    } else {
                        phi_951_ = bool();
                        phi_952_ = true;
                        phi_953_ = false;
                    }
                    let _e326 = phi_951_;
                    let _e328 = phi_952_;
                    let _e330 = phi_953_;
                    phi_954_ = _e326;
                    phi_955_ = _e328;
                    phi_956_ = _e330;
                } else {
                    phi_954_ = bool();
                    phi_955_ = true;
                    phi_956_ = false;
                }
                let _e332 = phi_954_;
                let _e334 = phi_955_;
                let _e336 = phi_956_;
                phi_957_ = _e332;
                phi_958_ = _e334;
                phi_959_ = _e336;
            } else {
                phi_957_ = bool();
                phi_958_ = true;
                phi_959_ = false;
            }
            let _e338 = phi_957_;
            let _e340 = phi_958_;
            let _e342 = phi_959_;
            if _e340 {
                phi_963_ = true;
            } else {
                phi_963_ = _e342;
            }
            let _e344 = phi_963_;
            if _e344 {
                phi_967_ = false;
            } else {
                phi_967_ = _e338;
            }
            let _e346 = phi_967_;
            if _e346 {
                let _e347 = (_e248 >= _e79);
                if _e347 {
                    phi_3550_ = false;
                } else {
                    if (_e248 < _e79) {
                    } else {
                        return;
                    }
                    let _e353 = nodes.member[(0u + _e248)].frame[0u];
                    let _e357 = nodes.member[(0u + _e248)].frame[1u];
                    let _e361 = nodes.member[(0u + _e248)].frame[2u];
                    let _e365 = nodes.member[(0u + _e248)].frame[0u];
                    let _e369 = nodes.member[(0u + _e248)].frame[1u];
                    let _e373 = nodes.member[(0u + _e248)].frame[2u];
                    let _e377 = nodes.member[(0u + _e248)].frame[3u];
                    let _e411 = core_intrinsics_maximum_number_nsz_f32_(abs(_e283), abs(_e284));
                    let _e412 = core_intrinsics_maximum_number_nsz_f32_(_e411, abs(_e285));
                    let _e413 = (_e412 * 0.0000000000009094947f);
                    if (abs(_e283) < _e413) {
                        phi_1037_ = _e413;
                    } else {
                        phi_1037_ = abs(_e283);
                    }
                    let _e418 = phi_1037_;
                    if (_e283 < 0f) {
                        phi_1044_ = (-1f / _e418);
                    } else {
                        phi_1044_ = (1f / _e418);
                    }
                    let _e423 = phi_1044_;
                    if (abs(_e284) < _e413) {
                        phi_1051_ = _e413;
                    } else {
                        phi_1051_ = abs(_e284);
                    }
                    let _e428 = phi_1051_;
                    if (_e284 < 0f) {
                        phi_1058_ = (-1f / _e428);
                    } else {
                        phi_1058_ = (1f / _e428);
                    }
                    let _e433 = phi_1058_;
                    if (abs(_e285) < _e413) {
                        phi_1065_ = _e413;
                    } else {
                        phi_1065_ = abs(_e285);
                    }
                    let _e438 = phi_1065_;
                    if (_e285 < 0f) {
                        phi_1072_ = (-1f / _e438);
                    } else {
                        phi_1072_ = (1f / _e438);
                    }
                    let _e443 = phi_1072_;
                    let _e447 = abs((bitcast<f32>(_e353) - _e265));
                    let _e448 = abs((bitcast<f32>(_e357) - _e267));
                    let _e449 = abs((bitcast<f32>(_e361) - _e269));
                    let _e453 = abs(((bitcast<f32>(_e365) + (bitcast<f32>((((_e377 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e265));
                    let _e454 = abs(((bitcast<f32>(_e369) + (bitcast<f32>((((_e377 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e267));
                    let _e455 = abs(((bitcast<f32>(_e373) + (bitcast<f32>((((_e377 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e269));
                    if (_e447 > _e453) {
                        phi_1089_ = _e447;
                    } else {
                        phi_1089_ = _e453;
                    }
                    let _e458 = phi_1089_;
                    if (_e448 > _e454) {
                        phi_1094_ = _e448;
                    } else {
                        phi_1094_ = _e454;
                    }
                    let _e461 = phi_1094_;
                    if (_e449 > _e455) {
                        phi_1099_ = _e449;
                    } else {
                        phi_1099_ = _e455;
                    }
                    let _e464 = phi_1099_;
                    let _e465 = core_intrinsics_maximum_number_nsz_f32_(_e458, _e461);
                    let _e466 = core_intrinsics_maximum_number_nsz_f32_(_e465, _e464);
                    let _e470 = (_e466 * 0.0000019073486f);
                    let _e471 = (abs(_e423) * _e470);
                    let _e472 = (abs(_e433) * _e470);
                    let _e473 = (abs(_e443) * _e470);
                    let _e477 = (_e466 * 0.0000009536743f);
                    let _e478 = (abs(_e423) * _e477);
                    let _e479 = (abs(_e433) * _e477);
                    let _e480 = (abs(_e443) * _e477);
                    if (_e423 < 0f) {
                        phi_1120_ = 0u;
                    } else {
                        phi_1120_ = 1u;
                    }
                    let _e483 = phi_1120_;
                    if (_e433 < 0f) {
                        phi_1125_ = 0u;
                    } else {
                        phi_1125_ = 2u;
                    }
                    let _e486 = phi_1125_;
                    if (_e443 < 0f) {
                        phi_1130_ = 0u;
                    } else {
                        phi_1130_ = 4u;
                    }
                    let _e489 = phi_1130_;
                    let _e491 = ((_e483 | _e486) | _e489);
                    let _e492 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e248, 2147483648u);
                    local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e492.first[0], _e492.first[1], _e492.first[2], _e492.first[3], _e492.first[4], _e492.first[5], _e492.first[6], _e492.first[7], _e492.first[8], _e492.first[9], _e492.first[10], _e492.first[11], _e492.first[12], _e492.first[13], _e492.first[14], _e492.first[15], _e492.first[16], _e492.first[17], _e492.first[18], _e492.first[19], _e492.first[20], _e492.first[21], _e492.first[22], _e492.first[23], _e492.first[24], _e492.first[25], _e492.first[26], _e492.first[27], _e492.first[28], _e492.first[29], _e492.first[30], _e492.first[31]), array<u32, 32>(_e492.mask[0], _e492.mask[1], _e492.mask[2], _e492.mask[3], _e492.mask[4], _e492.mask[5], _e492.mask[6], _e492.mask[7], _e492.mask[8], _e492.mask[9], _e492.mask[10], _e492.mask[11], _e492.mask[12], _e492.mask[13], _e492.mask[14], _e492.mask[15], _e492.mask[16], _e492.mask[17], _e492.mask[18], _e492.mask[19], _e492.mask[20], _e492.mask[21], _e492.mask[22], _e492.mask[23], _e492.mask[24], _e492.mask[25], _e492.mask[26], _e492.mask[27], _e492.mask[28], _e492.mask[29], _e492.mask[30], _e492.mask[31]), _e492.len, _e492.group, _e492.group_mask);
                    let _e566 = local_2.group_mask;
                    if ((_e566 & 4278190080u) == 0u) {
                        let _e570 = local_2.len;
                        if (_e570 == 0u) {
                            phi_1244_ = false;
                        } else {
                            let _e574 = local_2.len;
                            local_2.len = (_e574 - 1u);
                            let _e577 = local_2.len;
                            if (_e577 < 32u) {
                            } else {
                                return;
                            }
                            let _e582 = local_2.first[(0u + _e577)];
                            local_2.group = _e582;
                            let _e585 = local_2.len;
                            if (_e585 < 32u) {
                            } else {
                                return;
                            }
                            let _e590 = local_2.mask[(0u + _e585)];
                            local_2.group_mask = _e590;
                            phi_1244_ = true;
                        }
                        let _e593 = phi_1244_;
                        phi_1245_ = _e593;
                    } else {
                        phi_1245_ = true;
                    }
                    let _e595 = phi_1245_;
                    if _e595 {
                        let _e597 = local_2.group_mask;
                        let _e603 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e597)), 32u, (_e597 == 0u)));
                        let _e607 = local_2.group_mask;
                        let _e621 = local_2.group_mask;
                        local_2.group_mask = (_e621 & ~((1u << bitcast<u32>((_e603 & 31u)))));
                        let _e624 = local_2.group;
                        phi_1276_ = (_e624 + countOneBits(((_e607 & ~((4294967295u << bitcast<u32>((((_e603 - 24u) ^ 7u) & 31u))))) & 255u)));
                    } else {
                        phi_1276_ = 4294967295u;
                    }
                    let _e627 = phi_1276_;
                    phi_1278_ = _e627;
                    phi_1281_ = false;
                    loop {
                        let _e629 = phi_1278_;
                        let _e631 = phi_1281_;
                        if (_e629 != 4294967295u) {
                            if (_e629 < _e79) {
                            } else {
                                return;
                            }
                            let _e638 = nodes.member[(0u + _e629)].frame[3u];
                            let _e663 = (bitcast<f32>((((_e638 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e423);
                            let _e664 = (bitcast<f32>((((_e638 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e433);
                            let _e665 = (bitcast<f32>((((_e638 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e443);
                            let _e668 = nodes.member[(0u + _e629)].frame[0u];
                            let _e672 = nodes.member[(0u + _e629)].frame[1u];
                            let _e676 = nodes.member[(0u + _e629)].frame[2u];
                            let _e681 = ((bitcast<f32>(_e668) - _e265) * _e423);
                            let _e682 = ((bitcast<f32>(_e672) - _e267) * _e433);
                            let _e683 = ((bitcast<f32>(_e676) - _e269) * _e443);
                            let _e691 = nodes.member[(0u + _e629)].x;
                            if (_e423 < 0f) {
                                let _e702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e691.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e702.unnamed.word, _e691.w), _e702.unnamed_1);
                                let _e714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e708.unnamed, lt_mask_LightPlace(_e691.x, _e708.unnamed_1.shift));
                                phi_1361_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e714.unnamed, lt_mask_LightPlace(_e714.unnamed_1.word, _e691.y));
                            } else {
                                let _e730 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e691.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e736 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e730.unnamed.word, _e691.y), _e730.unnamed_1);
                                let _e742 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e736.unnamed, lt_mask_LightPlace(_e691.z, _e736.unnamed_1.shift));
                                phi_1361_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e742.unnamed, lt_mask_LightPlace(_e742.unnamed_1.word, _e691.w));
                            }
                            let _e750 = phi_1361_;
                            let _e760 = nodes.member[(0u + _e629)].y;
                            if (_e433 < 0f) {
                                let _e771 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e760.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e777 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e771.unnamed.word, _e760.w), _e771.unnamed_1);
                                let _e783 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e777.unnamed, lt_mask_LightPlace(_e760.x, _e777.unnamed_1.shift));
                                phi_1388_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e783.unnamed, lt_mask_LightPlace(_e783.unnamed_1.word, _e760.y));
                            } else {
                                let _e799 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e760.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e805 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e799.unnamed.word, _e760.y), _e799.unnamed_1);
                                let _e811 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e805.unnamed, lt_mask_LightPlace(_e760.z, _e805.unnamed_1.shift));
                                phi_1388_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e811.unnamed, lt_mask_LightPlace(_e811.unnamed_1.word, _e760.w));
                            }
                            let _e819 = phi_1388_;
                            let _e829 = nodes.member[(0u + _e629)].z;
                            if (_e443 < 0f) {
                                let _e840 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e829.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e846 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e840.unnamed.word, _e829.w), _e840.unnamed_1);
                                let _e852 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e846.unnamed, lt_mask_LightPlace(_e829.x, _e846.unnamed_1.shift));
                                phi_1415_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e852.unnamed, lt_mask_LightPlace(_e852.unnamed_1.word, _e829.y));
                            } else {
                                let _e868 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e829.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e874 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e868.unnamed.word, _e829.y), _e868.unnamed_1);
                                let _e880 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e874.unnamed, lt_mask_LightPlace(_e829.z, _e874.unnamed_1.shift));
                                phi_1415_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e880.unnamed, lt_mask_LightPlace(_e880.unnamed_1.word, _e829.w));
                            }
                            let _e888 = phi_1415_;
                            phi_1421_ = 0u;
                            phi_1424_ = 0u;
                            loop {
                                let _e898 = phi_1421_;
                                let _e900 = phi_1424_;
                                local_4 = _e900;
                                local_5 = _e900;
                                local_6 = _e900;
                                let _e901 = (_e898 < 8u);
                                if _e901 {
                                    let _e903 = (_e898 >> bitcast<u32>(2i));
                                    let _e904 = (_e898 & 3u);
                                    if (_e903 == 0u) {
                                        phi_1438_ = _e750.unnamed.word;
                                    } else {
                                        phi_1438_ = _e750.unnamed.shift;
                                    }
                                    let _e907 = phi_1438_;
                                    if (_e903 == 0u) {
                                        phi_1448_ = _e819.unnamed.word;
                                    } else {
                                        phi_1448_ = _e819.unnamed.shift;
                                    }
                                    let _e916 = phi_1448_;
                                    if (_e903 == 0u) {
                                        phi_1458_ = _e888.unnamed.word;
                                    } else {
                                        phi_1458_ = _e888.unnamed.shift;
                                    }
                                    let _e925 = phi_1458_;
                                    let _e938 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e907 >> bitcast<u32>(((_e904 * 8u) & 31u))) & 255u)) * _e663) + (_e681 - _e471)), ((f32(((_e916 >> bitcast<u32>(((_e904 * 8u) & 31u))) & 255u)) * _e664) + (_e682 - _e472)));
                                    let _e939 = core_intrinsics_maximum_number_nsz_f32_(_e938, ((f32(((_e925 >> bitcast<u32>(((_e904 * 8u) & 31u))) & 255u)) * _e665) + (_e683 - _e473)));
                                    if (_e903 == 0u) {
                                        phi_1476_ = _e750.unnamed_1.word;
                                    } else {
                                        phi_1476_ = _e750.unnamed_1.shift;
                                    }
                                    let _e942 = phi_1476_;
                                    if (_e903 == 0u) {
                                        phi_1486_ = _e819.unnamed_1.word;
                                    } else {
                                        phi_1486_ = _e819.unnamed_1.shift;
                                    }
                                    let _e951 = phi_1486_;
                                    if (_e903 == 0u) {
                                        phi_1496_ = _e888.unnamed_1.word;
                                    } else {
                                        phi_1496_ = _e888.unnamed_1.shift;
                                    }
                                    let _e960 = phi_1496_;
                                    let _e973 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e942 >> bitcast<u32>(((_e904 * 8u) & 31u))) & 255u)) * _e663) + (_e681 + _e471)), ((f32(((_e951 >> bitcast<u32>(((_e904 * 8u) & 31u))) & 255u)) * _e664) + (_e682 + _e472)));
                                    let _e974 = core_intrinsics_minimum_number_nsz_f32_(_e973, ((f32(((_e960 >> bitcast<u32>(((_e904 * 8u) & 31u))) & 255u)) * _e665) + (_e683 + _e473)));
                                    if (_e939 <= _e974) {
                                        if (_e939 <= _e275) {
                                            if (_e974 >= 0f) {
                                                if (_e903 == 0u) {
                                                    let _e981 = nodes.member[(0u + _e629)].links[2u];
                                                    phi_1532_ = _e981;
                                                } else {
                                                    let _e984 = nodes.member[(0u + _e629)].links[3u];
                                                    phi_1532_ = _e984;
                                                }
                                                let _e986 = phi_1532_;
                                                let _e991 = ((_e986 >> bitcast<u32>(((_e904 * 8u) & 31u))) & 255u);
                                                let _e992 = (_e991 & 31u);
                                                if (_e992 >= 24u) {
                                                    phi_1545_ = (24u + ((_e992 - 24u) ^ _e491));
                                                } else {
                                                    phi_1545_ = _e992;
                                                }
                                                let _e998 = phi_1545_;
                                                phi_1550_ = (_e900 | ((_e991 >> bitcast<u32>(5i)) << bitcast<u32>((_e998 & 31u))));
                                            } else {
                                                phi_1550_ = _e900;
                                            }
                                            let _e1006 = phi_1550_;
                                            phi_1551_ = _e1006;
                                        } else {
                                            phi_1551_ = _e900;
                                        }
                                        let _e1008 = phi_1551_;
                                        phi_1552_ = _e1008;
                                    } else {
                                        phi_1552_ = _e900;
                                    }
                                    let _e1010 = phi_1552_;
                                    phi_1422_ = (_e898 + 1u);
                                    phi_1425_ = _e1010;
                                } else {
                                    phi_1422_ = u32();
                                    phi_1425_ = u32();
                                }
                                let _e1013 = phi_1422_;
                                let _e1015 = phi_1425_;
                                continue;
                                continuing {
                                    phi_1421_ = _e1013;
                                    phi_1424_ = _e1015;
                                    break if !(_e901);
                                }
                            }
                            let _e1019 = nodes.member[(0u + _e629)].links[0u];
                            let _e1023 = nodes.member[(0u + _e629)].frame[3u];
                            let _e1027 = local_4;
                            if ((_e1027 & 4278190080u) == 0u) {
                            } else {
                                let _e1031 = local_2.group_mask;
                                if ((_e1031 & 4278190080u) == 0u) {
                                } else {
                                    let _e1035 = local_2.len;
                                    if (_e1035 < 32u) {
                                        let _e1038 = local_2.group;
                                        let _e1040 = local_2.len;
                                        if (_e1040 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_2.first[(0u + _e1040)] = _e1038;
                                        let _e1046 = local_2.group_mask;
                                        let _e1048 = local_2.len;
                                        if (_e1048 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_2.mask[(0u + _e1048)] = _e1046;
                                        let _e1055 = local_2.len;
                                        local_2.len = (_e1055 + 1u);
                                    }
                                }
                                local_2.group = (_e248 + _e1019);
                                let _e1059 = local_5;
                                local_2.group_mask = ((_e1059 & 4278190080u) | (_e1023 >> bitcast<u32>(24i)));
                            }
                            let _e1064 = local_6;
                            phi_1610_ = (_e1064 & 16777215u);
                            phi_1613_ = _e631;
                            loop {
                                let _e1067 = phi_1610_;
                                let _e1069 = phi_1613_;
                                local_19 = _e1069;
                                let _e1070 = (_e1067 == 0u);
                                local_12 = _e1070;
                                local_20 = _e1070;
                                if _e1070 {
                                    phi_1611_ = u32();
                                    phi_1614_ = bool();
                                    phi_3465_ = false;
                                } else {
                                    let _e1073 = nodes.member[(0u + _e629)].links[1u];
                                    let _e1077 = (_e1073 + select(firstTrailingBit(_e1067), 32u, (_e1067 == 0u)));
                                    if (_e1077 < arrayLength((&instances.member))) {
                                    } else {
                                        return;
                                    }
                                    let _e1084 = instances.member[(0u + _e1077)].low_world;
                                    let _e1086 = instances.member[(0u + _e1077)].high_world;
                                    let _e1093 = ((_e1084.x - _e265) * _e423);
                                    let _e1094 = ((_e1084.y - _e267) * _e433);
                                    let _e1095 = ((_e1084.z - _e269) * _e443);
                                    let _e1102 = ((_e1086.x - _e265) * _e423);
                                    let _e1103 = ((_e1086.y - _e267) * _e433);
                                    let _e1104 = ((_e1086.z - _e269) * _e443);
                                    if (_e1093 < _e1102) {
                                        phi_1662_ = _e1093;
                                    } else {
                                        phi_1662_ = _e1102;
                                    }
                                    let _e1107 = phi_1662_;
                                    if (_e1094 < _e1103) {
                                        phi_1667_ = _e1094;
                                    } else {
                                        phi_1667_ = _e1103;
                                    }
                                    let _e1110 = phi_1667_;
                                    if (_e1095 < _e1104) {
                                        phi_1672_ = _e1095;
                                    } else {
                                        phi_1672_ = _e1104;
                                    }
                                    let _e1113 = phi_1672_;
                                    if (_e1093 > _e1102) {
                                        phi_1680_ = _e1093;
                                    } else {
                                        phi_1680_ = _e1102;
                                    }
                                    let _e1119 = phi_1680_;
                                    if (_e1094 > _e1103) {
                                        phi_1685_ = _e1094;
                                    } else {
                                        phi_1685_ = _e1103;
                                    }
                                    let _e1122 = phi_1685_;
                                    if (_e1095 > _e1104) {
                                        phi_1690_ = _e1095;
                                    } else {
                                        phi_1690_ = _e1104;
                                    }
                                    let _e1125 = phi_1690_;
                                    let _e1129 = core_intrinsics_maximum_number_nsz_f32_((_e1107 - _e478), (_e1110 - _e479));
                                    let _e1130 = core_intrinsics_maximum_number_nsz_f32_(_e1129, (_e1113 - _e480));
                                    let _e1131 = core_intrinsics_minimum_number_nsz_f32_((_e1119 + _e478), (_e1122 + _e479));
                                    let _e1132 = core_intrinsics_minimum_number_nsz_f32_(_e1131, (_e1125 + _e480));
                                    if (_e1130 <= _e1132) {
                                        if (_e1130 <= _e275) {
                                            if (_e1132 >= 0f) {
                                                let _e1138 = instances.member[(0u + _e1077)].world_to_object[0u];
                                                let _e1149 = ((((_e1138.x * _e265) + (_e1138.y * _e267)) + (_e1138.z * _e269)) + (_e1138.w * 1f));
                                                let _e1151 = instances.member[(0u + _e1077)].world_to_object[1u];
                                                let _e1162 = ((((_e1151.x * _e265) + (_e1151.y * _e267)) + (_e1151.z * _e269)) + (_e1151.w * 1f));
                                                let _e1164 = instances.member[(0u + _e1077)].world_to_object[2u];
                                                let _e1175 = ((((_e1164.x * _e265) + (_e1164.y * _e267)) + (_e1164.z * _e269)) + (_e1164.w * 1f));
                                                let _e1178 = instances.member[(0u + _e1077)].world_to_object[0u];
                                                let _e1189 = ((((_e1178.x * _e283) + (_e1178.y * _e284)) + (_e1178.z * _e285)) + (_e1178.w * 0f));
                                                let _e1191 = instances.member[(0u + _e1077)].world_to_object[1u];
                                                let _e1202 = ((((_e1191.x * _e283) + (_e1191.y * _e284)) + (_e1191.z * _e285)) + (_e1191.w * 0f));
                                                let _e1204 = instances.member[(0u + _e1077)].world_to_object[2u];
                                                let _e1215 = ((((_e1204.x * _e283) + (_e1204.y * _e284)) + (_e1204.z * _e285)) + (_e1204.w * 0f));
                                                let _e1218 = instances.member[(0u + _e1077)].root;
                                                let _e1220 = instances.member[(0u + _e1077)].first_triangle;
                                                let _e1224 = abs(_e1189);
                                                let _e1225 = abs(_e1202);
                                                let _e1226 = abs(_e1215);
                                                if (abs(_e1149) < 1000000000000000f) {
                                                    if (abs(_e1162) < 1000000000000000f) {
                                                        if (abs(_e1175) < 1000000000000000f) {
                                                            if (_e1224 < 1000000000000000f) {
                                                                if (_e1225 < 1000000000000000f) {
                                                                    if (_e1226 < 1000000000000000f) {
                                                                        if (_e1224 > 0f) {
                                                                            phi_1835_ = bool();
                                                                            phi_1836_ = true;
                                                                        } else {
                                                                            let _e1234 = (_e1225 > 0f);
                                                                            if _e1234 {
                                                                                phi_1834_ = bool();
                                                                            } else {
                                                                                phi_1834_ = (_e1226 > 0f);
                                                                            }
                                                                            let _e1237 = phi_1834_;
                                                                            phi_1835_ = _e1237;
                                                                            phi_1836_ = _e1234;
                                                                        }
                                                                        let _e1239 = phi_1835_;
                                                                        let _e1241 = phi_1836_;
                                                                        if _e1241 {
                                                                            phi_1840_ = true;
                                                                        } else {
                                                                            phi_1840_ = _e1239;
                                                                        }
                                                                        let _e1243 = phi_1840_;
                                                                        phi_1841_ = _e1243;
                                                                        phi_1842_ = false;
                                                                    } else {
                                                                        phi_1841_ = bool();
                                                                        phi_1842_ = true;
                                                                    }
                                                                    let _e1245 = phi_1841_;
                                                                    let _e1247 = phi_1842_;
                                                                    phi_1843_ = _e1245;
                                                                    phi_1844_ = false;
                                                                    phi_1845_ = _e1247;
                                                                } else {
                                                                    phi_1843_ = bool();
                                                                    phi_1844_ = true;
                                                                    phi_1845_ = false;
                                                                }
                                                                let _e1249 = phi_1843_;
                                                                let _e1251 = phi_1844_;
                                                                let _e1253 = phi_1845_;
                                                                phi_1846_ = _e1249;
                                                                phi_1847_ = _e1251;
                                                                phi_1848_ = _e1253;
                                                            } else {
                                                                phi_1846_ = bool();
                                                                phi_1847_ = true;
                                                                phi_1848_ = false;
                                                            }
                                                            let _e1255 = phi_1846_;
                                                            let _e1257 = phi_1847_;
                                                            let _e1259 = phi_1848_;
                                                            phi_1849_ = _e1255;
                                                            phi_1850_ = _e1257;
                                                            phi_1851_ = _e1259;
                                                        } else {
                                                            phi_1849_ = bool();
                                                            phi_1850_ = true;
                                                            phi_1851_ = false;
                                                        }
                                                        let _e1261 = phi_1849_;
                                                        let _e1263 = phi_1850_;
                                                        let _e1265 = phi_1851_;
                                                        phi_1852_ = _e1261;
                                                        phi_1853_ = _e1263;
                                                        phi_1854_ = _e1265;
                                                    } else {
                                                        phi_1852_ = bool();
                                                        phi_1853_ = true;
                                                        phi_1854_ = false;
                                                    }
                                                    let _e1267 = phi_1852_;
                                                    let _e1269 = phi_1853_;
                                                    let _e1271 = phi_1854_;
                                                    phi_1855_ = _e1267;
                                                    phi_1856_ = _e1269;
                                                    phi_1857_ = _e1271;
                                                } else {
                                                    phi_1855_ = bool();
                                                    phi_1856_ = true;
                                                    phi_1857_ = false;
                                                }
                                                let _e1273 = phi_1855_;
                                                let _e1275 = phi_1856_;
                                                let _e1277 = phi_1857_;
                                                if _e1275 {
                                                    phi_1861_ = true;
                                                } else {
                                                    phi_1861_ = _e1277;
                                                }
                                                let _e1279 = phi_1861_;
                                                if _e1279 {
                                                    phi_1865_ = false;
                                                } else {
                                                    phi_1865_ = _e1273;
                                                }
                                                let _e1281 = phi_1865_;
                                                if _e1281 {
                                                    let _e1282 = (_e1218 >= _e79);
                                                    if _e1282 {
                                                        phi_3445_ = bool();
                                                    } else {
                                                        if (_e1218 < _e79) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1288 = nodes.member[(0u + _e1218)].frame[0u];
                                                        let _e1292 = nodes.member[(0u + _e1218)].frame[1u];
                                                        let _e1296 = nodes.member[(0u + _e1218)].frame[2u];
                                                        let _e1300 = nodes.member[(0u + _e1218)].frame[0u];
                                                        let _e1304 = nodes.member[(0u + _e1218)].frame[1u];
                                                        let _e1308 = nodes.member[(0u + _e1218)].frame[2u];
                                                        let _e1312 = nodes.member[(0u + _e1218)].frame[3u];
                                                        let _e1346 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1189), abs(_e1202));
                                                        let _e1347 = core_intrinsics_maximum_number_nsz_f32_(_e1346, abs(_e1215));
                                                        let _e1348 = (_e1347 * 0.0000000000009094947f);
                                                        if (abs(_e1189) < _e1348) {
                                                            phi_1935_ = _e1348;
                                                        } else {
                                                            phi_1935_ = abs(_e1189);
                                                        }
                                                        let _e1353 = phi_1935_;
                                                        if (_e1189 < 0f) {
                                                            phi_1942_ = (-1f / _e1353);
                                                        } else {
                                                            phi_1942_ = (1f / _e1353);
                                                        }
                                                        let _e1358 = phi_1942_;
                                                        if (abs(_e1202) < _e1348) {
                                                            phi_1949_ = _e1348;
                                                        } else {
                                                            phi_1949_ = abs(_e1202);
                                                        }
                                                        let _e1363 = phi_1949_;
                                                        if (_e1202 < 0f) {
                                                            phi_1956_ = (-1f / _e1363);
                                                        } else {
                                                            phi_1956_ = (1f / _e1363);
                                                        }
                                                        let _e1368 = phi_1956_;
                                                        if (abs(_e1215) < _e1348) {
                                                            phi_1963_ = _e1348;
                                                        } else {
                                                            phi_1963_ = abs(_e1215);
                                                        }
                                                        let _e1373 = phi_1963_;
                                                        if (_e1215 < 0f) {
                                                            phi_1970_ = (-1f / _e1373);
                                                        } else {
                                                            phi_1970_ = (1f / _e1373);
                                                        }
                                                        let _e1378 = phi_1970_;
                                                        let _e1382 = abs((bitcast<f32>(_e1288) - _e1149));
                                                        let _e1383 = abs((bitcast<f32>(_e1292) - _e1162));
                                                        let _e1384 = abs((bitcast<f32>(_e1296) - _e1175));
                                                        let _e1388 = abs(((bitcast<f32>(_e1300) + (bitcast<f32>((((_e1312 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1149));
                                                        let _e1389 = abs(((bitcast<f32>(_e1304) + (bitcast<f32>((((_e1312 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1162));
                                                        let _e1390 = abs(((bitcast<f32>(_e1308) + (bitcast<f32>((((_e1312 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1175));
                                                        if (_e1382 > _e1388) {
                                                            phi_1987_ = _e1382;
                                                        } else {
                                                            phi_1987_ = _e1388;
                                                        }
                                                        let _e1393 = phi_1987_;
                                                        if (_e1383 > _e1389) {
                                                            phi_1992_ = _e1383;
                                                        } else {
                                                            phi_1992_ = _e1389;
                                                        }
                                                        let _e1396 = phi_1992_;
                                                        if (_e1384 > _e1390) {
                                                            phi_1997_ = _e1384;
                                                        } else {
                                                            phi_1997_ = _e1390;
                                                        }
                                                        let _e1399 = phi_1997_;
                                                        let _e1400 = core_intrinsics_maximum_number_nsz_f32_(_e1393, _e1396);
                                                        let _e1401 = core_intrinsics_maximum_number_nsz_f32_(_e1400, _e1399);
                                                        let _e1405 = (_e1401 * 0.0000019073486f);
                                                        let _e1406 = (abs(_e1358) * _e1405);
                                                        let _e1407 = (abs(_e1368) * _e1405);
                                                        let _e1408 = (abs(_e1378) * _e1405);
                                                        let _e1412 = (_e1401 * 0.0000009536743f);
                                                        let _e1413 = (abs(_e1358) * _e1412);
                                                        let _e1414 = (abs(_e1368) * _e1412);
                                                        let _e1415 = (abs(_e1378) * _e1412);
                                                        let _e1416 = abs(_e1189);
                                                        let _e1417 = abs(_e1202);
                                                        let _e1418 = abs(_e1215);
                                                        if (_e1416 >= _e1417) {
                                                            if (_e1416 >= _e1418) {
                                                                phi_2025_ = false;
                                                            } else {
                                                                phi_2025_ = true;
                                                            }
                                                            let _e1422 = phi_2025_;
                                                            phi_2026_ = _e1422;
                                                        } else {
                                                            phi_2026_ = true;
                                                        }
                                                        let _e1424 = phi_2026_;
                                                        if _e1424 {
                                                            if (_e1417 >= _e1418) {
                                                                phi_2034_ = 1u;
                                                            } else {
                                                                phi_2034_ = 2u;
                                                            }
                                                            let _e1427 = phi_2034_;
                                                            phi_2035_ = _e1427;
                                                        } else {
                                                            phi_2035_ = 0u;
                                                        }
                                                        let _e1429 = phi_2035_;
                                                        if (_e1429 == 0u) {
                                                            phi_2047_ = vec3<f32>(_e1202, _e1215, _e1189);
                                                        } else {
                                                            if (_e1429 == 1u) {
                                                                phi_2046_ = vec3<f32>(_e1215, _e1189, _e1202);
                                                            } else {
                                                                phi_2046_ = vec3<f32>(_e1189, _e1202, _e1215);
                                                            }
                                                            let _e1435 = phi_2046_;
                                                            phi_2047_ = _e1435;
                                                        }
                                                        let _e1437 = phi_2047_;
                                                        let _e1440 = (_e1437.x / _e1437.z);
                                                        let _e1443 = (_e1437.y / _e1437.z);
                                                        if (_e1358 < 0f) {
                                                            phi_2060_ = 0u;
                                                        } else {
                                                            phi_2060_ = 1u;
                                                        }
                                                        let _e1448 = phi_2060_;
                                                        if (_e1368 < 0f) {
                                                            phi_2065_ = 0u;
                                                        } else {
                                                            phi_2065_ = 2u;
                                                        }
                                                        let _e1451 = phi_2065_;
                                                        if (_e1378 < 0f) {
                                                            phi_2070_ = 0u;
                                                        } else {
                                                            phi_2070_ = 4u;
                                                        }
                                                        let _e1454 = phi_2070_;
                                                        let _e1456 = ((_e1448 | _e1451) | _e1454);
                                                        let _e1457 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1218, 2147483648u);
                                                        local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1457.first[0], _e1457.first[1], _e1457.first[2], _e1457.first[3], _e1457.first[4], _e1457.first[5], _e1457.first[6], _e1457.first[7], _e1457.first[8], _e1457.first[9], _e1457.first[10], _e1457.first[11], _e1457.first[12], _e1457.first[13], _e1457.first[14], _e1457.first[15], _e1457.first[16], _e1457.first[17], _e1457.first[18], _e1457.first[19], _e1457.first[20], _e1457.first[21], _e1457.first[22], _e1457.first[23], _e1457.first[24], _e1457.first[25], _e1457.first[26], _e1457.first[27], _e1457.first[28], _e1457.first[29], _e1457.first[30], _e1457.first[31]), array<u32, 32>(_e1457.mask[0], _e1457.mask[1], _e1457.mask[2], _e1457.mask[3], _e1457.mask[4], _e1457.mask[5], _e1457.mask[6], _e1457.mask[7], _e1457.mask[8], _e1457.mask[9], _e1457.mask[10], _e1457.mask[11], _e1457.mask[12], _e1457.mask[13], _e1457.mask[14], _e1457.mask[15], _e1457.mask[16], _e1457.mask[17], _e1457.mask[18], _e1457.mask[19], _e1457.mask[20], _e1457.mask[21], _e1457.mask[22], _e1457.mask[23], _e1457.mask[24], _e1457.mask[25], _e1457.mask[26], _e1457.mask[27], _e1457.mask[28], _e1457.mask[29], _e1457.mask[30], _e1457.mask[31]), _e1457.len, _e1457.group, _e1457.group_mask);
                                                        let _e1531 = local_1.group_mask;
                                                        if ((_e1531 & 4278190080u) == 0u) {
                                                            let _e1535 = local_1.len;
                                                            if (_e1535 == 0u) {
                                                                phi_2184_ = false;
                                                            } else {
                                                                let _e1539 = local_1.len;
                                                                local_1.len = (_e1539 - 1u);
                                                                let _e1542 = local_1.len;
                                                                if (_e1542 < 32u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1547 = local_1.first[(0u + _e1542)];
                                                                local_1.group = _e1547;
                                                                let _e1550 = local_1.len;
                                                                if (_e1550 < 32u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1555 = local_1.mask[(0u + _e1550)];
                                                                local_1.group_mask = _e1555;
                                                                phi_2184_ = true;
                                                            }
                                                            let _e1558 = phi_2184_;
                                                            phi_2185_ = _e1558;
                                                        } else {
                                                            phi_2185_ = true;
                                                        }
                                                        let _e1560 = phi_2185_;
                                                        if _e1560 {
                                                            let _e1562 = local_1.group_mask;
                                                            let _e1568 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1562)), 32u, (_e1562 == 0u)));
                                                            let _e1572 = local_1.group_mask;
                                                            let _e1586 = local_1.group_mask;
                                                            local_1.group_mask = (_e1586 & ~((1u << bitcast<u32>((_e1568 & 31u)))));
                                                            let _e1589 = local_1.group;
                                                            phi_2216_ = (_e1589 + countOneBits(((_e1572 & ~((4294967295u << bitcast<u32>((((_e1568 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                        } else {
                                                            phi_2216_ = 4294967295u;
                                                        }
                                                        let _e1592 = phi_2216_;
                                                        phi_2218_ = _e1592;
                                                        phi_2221_ = _e1069;
                                                        loop {
                                                            let _e1594 = phi_2218_;
                                                            let _e1596 = phi_2221_;
                                                            local_18 = _e1596;
                                                            if (_e1594 != 4294967295u) {
                                                                if (_e1594 < _e79) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1603 = nodes.member[(0u + _e1594)].frame[3u];
                                                                let _e1628 = (bitcast<f32>((((_e1603 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1358);
                                                                let _e1629 = (bitcast<f32>((((_e1603 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1368);
                                                                let _e1630 = (bitcast<f32>((((_e1603 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1378);
                                                                let _e1633 = nodes.member[(0u + _e1594)].frame[0u];
                                                                let _e1637 = nodes.member[(0u + _e1594)].frame[1u];
                                                                let _e1641 = nodes.member[(0u + _e1594)].frame[2u];
                                                                let _e1646 = ((bitcast<f32>(_e1633) - _e1149) * _e1358);
                                                                let _e1647 = ((bitcast<f32>(_e1637) - _e1162) * _e1368);
                                                                let _e1648 = ((bitcast<f32>(_e1641) - _e1175) * _e1378);
                                                                let _e1656 = nodes.member[(0u + _e1594)].x;
                                                                if (_e1358 < 0f) {
                                                                    let _e1667 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1656.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1667.unnamed.word, _e1656.w), _e1667.unnamed_1);
                                                                    let _e1679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1673.unnamed, lt_mask_LightPlace(_e1656.x, _e1673.unnamed_1.shift));
                                                                    phi_2301_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1679.unnamed, lt_mask_LightPlace(_e1679.unnamed_1.word, _e1656.y));
                                                                } else {
                                                                    let _e1695 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1656.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1701 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1695.unnamed.word, _e1656.y), _e1695.unnamed_1);
                                                                    let _e1707 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1701.unnamed, lt_mask_LightPlace(_e1656.z, _e1701.unnamed_1.shift));
                                                                    phi_2301_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1707.unnamed, lt_mask_LightPlace(_e1707.unnamed_1.word, _e1656.w));
                                                                }
                                                                let _e1715 = phi_2301_;
                                                                let _e1725 = nodes.member[(0u + _e1594)].y;
                                                                if (_e1368 < 0f) {
                                                                    let _e1736 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1725.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1742 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1736.unnamed.word, _e1725.w), _e1736.unnamed_1);
                                                                    let _e1748 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1742.unnamed, lt_mask_LightPlace(_e1725.x, _e1742.unnamed_1.shift));
                                                                    phi_2328_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1748.unnamed, lt_mask_LightPlace(_e1748.unnamed_1.word, _e1725.y));
                                                                } else {
                                                                    let _e1764 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1725.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1770 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1764.unnamed.word, _e1725.y), _e1764.unnamed_1);
                                                                    let _e1776 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1770.unnamed, lt_mask_LightPlace(_e1725.z, _e1770.unnamed_1.shift));
                                                                    phi_2328_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1776.unnamed, lt_mask_LightPlace(_e1776.unnamed_1.word, _e1725.w));
                                                                }
                                                                let _e1784 = phi_2328_;
                                                                let _e1794 = nodes.member[(0u + _e1594)].z;
                                                                if (_e1378 < 0f) {
                                                                    let _e1805 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1794.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1811 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1805.unnamed.word, _e1794.w), _e1805.unnamed_1);
                                                                    let _e1817 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1811.unnamed, lt_mask_LightPlace(_e1794.x, _e1811.unnamed_1.shift));
                                                                    phi_2355_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1817.unnamed, lt_mask_LightPlace(_e1817.unnamed_1.word, _e1794.y));
                                                                } else {
                                                                    let _e1833 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1794.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1839 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1833.unnamed.word, _e1794.y), _e1833.unnamed_1);
                                                                    let _e1845 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1839.unnamed, lt_mask_LightPlace(_e1794.z, _e1839.unnamed_1.shift));
                                                                    phi_2355_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1845.unnamed, lt_mask_LightPlace(_e1845.unnamed_1.word, _e1794.w));
                                                                }
                                                                let _e1853 = phi_2355_;
                                                                phi_2361_ = 0u;
                                                                phi_2364_ = 0u;
                                                                loop {
                                                                    let _e1863 = phi_2361_;
                                                                    let _e1865 = phi_2364_;
                                                                    local_7 = _e1865;
                                                                    local_8 = _e1865;
                                                                    local_9 = _e1865;
                                                                    let _e1866 = (_e1863 < 8u);
                                                                    if _e1866 {
                                                                        let _e1868 = (_e1863 >> bitcast<u32>(2i));
                                                                        let _e1869 = (_e1863 & 3u);
                                                                        if (_e1868 == 0u) {
                                                                            phi_2378_ = _e1715.unnamed.word;
                                                                        } else {
                                                                            phi_2378_ = _e1715.unnamed.shift;
                                                                        }
                                                                        let _e1872 = phi_2378_;
                                                                        if (_e1868 == 0u) {
                                                                            phi_2388_ = _e1784.unnamed.word;
                                                                        } else {
                                                                            phi_2388_ = _e1784.unnamed.shift;
                                                                        }
                                                                        let _e1881 = phi_2388_;
                                                                        if (_e1868 == 0u) {
                                                                            phi_2398_ = _e1853.unnamed.word;
                                                                        } else {
                                                                            phi_2398_ = _e1853.unnamed.shift;
                                                                        }
                                                                        let _e1890 = phi_2398_;
                                                                        let _e1903 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1872 >> bitcast<u32>(((_e1869 * 8u) & 31u))) & 255u)) * _e1628) + (_e1646 - _e1406)), ((f32(((_e1881 >> bitcast<u32>(((_e1869 * 8u) & 31u))) & 255u)) * _e1629) + (_e1647 - _e1407)));
                                                                        let _e1904 = core_intrinsics_maximum_number_nsz_f32_(_e1903, ((f32(((_e1890 >> bitcast<u32>(((_e1869 * 8u) & 31u))) & 255u)) * _e1630) + (_e1648 - _e1408)));
                                                                        if (_e1868 == 0u) {
                                                                            phi_2416_ = _e1715.unnamed_1.word;
                                                                        } else {
                                                                            phi_2416_ = _e1715.unnamed_1.shift;
                                                                        }
                                                                        let _e1907 = phi_2416_;
                                                                        if (_e1868 == 0u) {
                                                                            phi_2426_ = _e1784.unnamed_1.word;
                                                                        } else {
                                                                            phi_2426_ = _e1784.unnamed_1.shift;
                                                                        }
                                                                        let _e1916 = phi_2426_;
                                                                        if (_e1868 == 0u) {
                                                                            phi_2436_ = _e1853.unnamed_1.word;
                                                                        } else {
                                                                            phi_2436_ = _e1853.unnamed_1.shift;
                                                                        }
                                                                        let _e1925 = phi_2436_;
                                                                        let _e1938 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1907 >> bitcast<u32>(((_e1869 * 8u) & 31u))) & 255u)) * _e1628) + (_e1646 + _e1406)), ((f32(((_e1916 >> bitcast<u32>(((_e1869 * 8u) & 31u))) & 255u)) * _e1629) + (_e1647 + _e1407)));
                                                                        let _e1939 = core_intrinsics_minimum_number_nsz_f32_(_e1938, ((f32(((_e1925 >> bitcast<u32>(((_e1869 * 8u) & 31u))) & 255u)) * _e1630) + (_e1648 + _e1408)));
                                                                        if (_e1904 <= _e1939) {
                                                                            if (_e1904 <= _e275) {
                                                                                if (_e1939 >= 0f) {
                                                                                    if (_e1868 == 0u) {
                                                                                        let _e1946 = nodes.member[(0u + _e1594)].links[2u];
                                                                                        phi_2472_ = _e1946;
                                                                                    } else {
                                                                                        let _e1949 = nodes.member[(0u + _e1594)].links[3u];
                                                                                        phi_2472_ = _e1949;
                                                                                    }
                                                                                    let _e1951 = phi_2472_;
                                                                                    let _e1956 = ((_e1951 >> bitcast<u32>(((_e1869 * 8u) & 31u))) & 255u);
                                                                                    let _e1957 = (_e1956 & 31u);
                                                                                    if (_e1957 >= 24u) {
                                                                                        phi_2485_ = (24u + ((_e1957 - 24u) ^ _e1456));
                                                                                    } else {
                                                                                        phi_2485_ = _e1957;
                                                                                    }
                                                                                    let _e1963 = phi_2485_;
                                                                                    phi_2490_ = (_e1865 | ((_e1956 >> bitcast<u32>(5i)) << bitcast<u32>((_e1963 & 31u))));
                                                                                } else {
                                                                                    phi_2490_ = _e1865;
                                                                                }
                                                                                let _e1971 = phi_2490_;
                                                                                phi_2491_ = _e1971;
                                                                            } else {
                                                                                phi_2491_ = _e1865;
                                                                            }
                                                                            let _e1973 = phi_2491_;
                                                                            phi_2492_ = _e1973;
                                                                        } else {
                                                                            phi_2492_ = _e1865;
                                                                        }
                                                                        let _e1975 = phi_2492_;
                                                                        phi_2362_ = (_e1863 + 1u);
                                                                        phi_2365_ = _e1975;
                                                                    } else {
                                                                        phi_2362_ = u32();
                                                                        phi_2365_ = u32();
                                                                    }
                                                                    let _e1978 = phi_2362_;
                                                                    let _e1980 = phi_2365_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_2361_ = _e1978;
                                                                        phi_2364_ = _e1980;
                                                                        break if !(_e1866);
                                                                    }
                                                                }
                                                                let _e1984 = nodes.member[(0u + _e1594)].links[0u];
                                                                let _e1988 = nodes.member[(0u + _e1594)].frame[3u];
                                                                let _e1992 = local_7;
                                                                if ((_e1992 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1996 = local_1.group_mask;
                                                                    if ((_e1996 & 4278190080u) == 0u) {
                                                                    } else {
                                                                        let _e2000 = local_1.len;
                                                                        if (_e2000 < 32u) {
                                                                            let _e2003 = local_1.group;
                                                                            let _e2005 = local_1.len;
                                                                            if (_e2005 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            local_1.first[(0u + _e2005)] = _e2003;
                                                                            let _e2011 = local_1.group_mask;
                                                                            let _e2013 = local_1.len;
                                                                            if (_e2013 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            local_1.mask[(0u + _e2013)] = _e2011;
                                                                            let _e2020 = local_1.len;
                                                                            local_1.len = (_e2020 + 1u);
                                                                        }
                                                                    }
                                                                    local_1.group = (_e1218 + _e1984);
                                                                    let _e2024 = local_8;
                                                                    local_1.group_mask = ((_e2024 & 4278190080u) | (_e1988 >> bitcast<u32>(24i)));
                                                                }
                                                                let _e2029 = local_9;
                                                                phi_2550_ = (_e2029 & 16777215u);
                                                                phi_2553_ = _e1596;
                                                                loop {
                                                                    let _e2032 = phi_2550_;
                                                                    let _e2034 = phi_2553_;
                                                                    local_14 = _e2034;
                                                                    let _e2035 = (_e2032 == 0u);
                                                                    local_10 = _e2035;
                                                                    local_16 = _e2035;
                                                                    if _e2035 {
                                                                        phi_2551_ = u32();
                                                                        phi_2554_ = bool();
                                                                        phi_3357_ = bool();
                                                                        phi_3358_ = false;
                                                                    } else {
                                                                        let _e2038 = nodes.member[(0u + _e1594)].links[1u];
                                                                        let _e2043 = ((_e1220 + _e2038) + select(firstTrailingBit(_e2032), 32u, (_e2032 == 0u)));
                                                                        if (_e2043 < _e82) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2050 = triangles.member[(0u + _e2043)].v0_;
                                                                        let _e2052 = (_e2050.x - _e1149);
                                                                        let _e2054 = (_e2050.y - _e1162);
                                                                        let _e2056 = (_e2050.z - _e1175);
                                                                        if (_e1429 == 0u) {
                                                                            phi_2598_ = vec3<f32>(_e2054, _e2056, _e2052);
                                                                        } else {
                                                                            if (_e1429 == 1u) {
                                                                                phi_2597_ = vec3<f32>(_e2056, _e2052, _e2054);
                                                                            } else {
                                                                                phi_2597_ = (_e2050 - vec3<f32>(_e1149, _e1162, _e1175));
                                                                            }
                                                                            let _e2064 = phi_2597_;
                                                                            phi_2598_ = _e2064;
                                                                        }
                                                                        let _e2066 = phi_2598_;
                                                                        let _e2070 = (_e2066.x - (_e1440 * _e2066.z));
                                                                        let _e2074 = (_e2066.y - (_e1443 * _e2066.z));
                                                                        let _e2076 = triangles.member[(0u + _e2043)].v1_;
                                                                        let _e2078 = (_e2076.x - _e1149);
                                                                        let _e2080 = (_e2076.y - _e1162);
                                                                        let _e2082 = (_e2076.z - _e1175);
                                                                        if (_e1429 == 0u) {
                                                                            phi_2628_ = vec3<f32>(_e2080, _e2082, _e2078);
                                                                        } else {
                                                                            if (_e1429 == 1u) {
                                                                                phi_2627_ = vec3<f32>(_e2082, _e2078, _e2080);
                                                                            } else {
                                                                                phi_2627_ = (_e2076 - vec3<f32>(_e1149, _e1162, _e1175));
                                                                            }
                                                                            let _e2090 = phi_2627_;
                                                                            phi_2628_ = _e2090;
                                                                        }
                                                                        let _e2092 = phi_2628_;
                                                                        let _e2096 = (_e2092.x - (_e1440 * _e2092.z));
                                                                        let _e2100 = (_e2092.y - (_e1443 * _e2092.z));
                                                                        let _e2102 = triangles.member[(0u + _e2043)].v2_;
                                                                        let _e2104 = (_e2102.x - _e1149);
                                                                        let _e2106 = (_e2102.y - _e1162);
                                                                        let _e2108 = (_e2102.z - _e1175);
                                                                        if (_e1429 == 0u) {
                                                                            phi_2658_ = vec3<f32>(_e2106, _e2108, _e2104);
                                                                        } else {
                                                                            if (_e1429 == 1u) {
                                                                                phi_2657_ = vec3<f32>(_e2108, _e2104, _e2106);
                                                                            } else {
                                                                                phi_2657_ = (_e2102 - vec3<f32>(_e1149, _e1162, _e1175));
                                                                            }
                                                                            let _e2116 = phi_2657_;
                                                                            phi_2658_ = _e2116;
                                                                        }
                                                                        let _e2118 = phi_2658_;
                                                                        let _e2122 = (_e2118.x - (_e1440 * _e2118.z));
                                                                        let _e2126 = (_e2118.y - (_e1443 * _e2118.z));
                                                                        if (_e2096 < _e2122) {
                                                                            phi_2677_ = true;
                                                                        } else {
                                                                            if (_e2096 == _e2122) {
                                                                                phi_2676_ = (_e2100 < _e2126);
                                                                            } else {
                                                                                phi_2676_ = false;
                                                                            }
                                                                            let _e2131 = phi_2676_;
                                                                            phi_2677_ = _e2131;
                                                                        }
                                                                        let _e2133 = phi_2677_;
                                                                        if _e2133 {
                                                                            phi_2681_ = _e2126;
                                                                            phi_2682_ = _e2122;
                                                                            phi_2683_ = _e2100;
                                                                            phi_2684_ = _e2096;
                                                                        } else {
                                                                            phi_2681_ = _e2100;
                                                                            phi_2682_ = _e2096;
                                                                            phi_2683_ = _e2126;
                                                                            phi_2684_ = _e2122;
                                                                        }
                                                                        let _e2135 = phi_2681_;
                                                                        let _e2137 = phi_2682_;
                                                                        let _e2139 = phi_2683_;
                                                                        let _e2141 = phi_2684_;
                                                                        let _e2144 = ((_e2141 * _e2135) - (_e2139 * _e2137));
                                                                        if _e2133 {
                                                                            phi_2692_ = -(_e2144);
                                                                        } else {
                                                                            phi_2692_ = _e2144;
                                                                        }
                                                                        let _e2147 = phi_2692_;
                                                                        if (_e2122 < _e2070) {
                                                                            phi_2703_ = true;
                                                                        } else {
                                                                            if (_e2122 == _e2070) {
                                                                                phi_2702_ = (_e2126 < _e2074);
                                                                            } else {
                                                                                phi_2702_ = false;
                                                                            }
                                                                            let _e2152 = phi_2702_;
                                                                            phi_2703_ = _e2152;
                                                                        }
                                                                        let _e2154 = phi_2703_;
                                                                        if _e2154 {
                                                                            phi_2707_ = _e2074;
                                                                            phi_2708_ = _e2070;
                                                                            phi_2709_ = _e2126;
                                                                            phi_2710_ = _e2122;
                                                                        } else {
                                                                            phi_2707_ = _e2126;
                                                                            phi_2708_ = _e2122;
                                                                            phi_2709_ = _e2074;
                                                                            phi_2710_ = _e2070;
                                                                        }
                                                                        let _e2156 = phi_2707_;
                                                                        let _e2158 = phi_2708_;
                                                                        let _e2160 = phi_2709_;
                                                                        let _e2162 = phi_2710_;
                                                                        let _e2165 = ((_e2162 * _e2156) - (_e2160 * _e2158));
                                                                        if _e2154 {
                                                                            phi_2718_ = -(_e2165);
                                                                        } else {
                                                                            phi_2718_ = _e2165;
                                                                        }
                                                                        let _e2168 = phi_2718_;
                                                                        if (_e2070 < _e2096) {
                                                                            phi_2729_ = true;
                                                                        } else {
                                                                            if (_e2070 == _e2096) {
                                                                                phi_2728_ = (_e2074 < _e2100);
                                                                            } else {
                                                                                phi_2728_ = false;
                                                                            }
                                                                            let _e2173 = phi_2728_;
                                                                            phi_2729_ = _e2173;
                                                                        }
                                                                        let _e2175 = phi_2729_;
                                                                        if _e2175 {
                                                                            phi_2733_ = _e2100;
                                                                            phi_2734_ = _e2096;
                                                                            phi_2735_ = _e2074;
                                                                            phi_2736_ = _e2070;
                                                                        } else {
                                                                            phi_2733_ = _e2074;
                                                                            phi_2734_ = _e2070;
                                                                            phi_2735_ = _e2100;
                                                                            phi_2736_ = _e2096;
                                                                        }
                                                                        let _e2177 = phi_2733_;
                                                                        let _e2179 = phi_2734_;
                                                                        let _e2181 = phi_2735_;
                                                                        let _e2183 = phi_2736_;
                                                                        let _e2186 = ((_e2183 * _e2177) - (_e2181 * _e2179));
                                                                        if _e2175 {
                                                                            phi_2744_ = -(_e2186);
                                                                        } else {
                                                                            phi_2744_ = _e2186;
                                                                        }
                                                                        let _e2189 = phi_2744_;
                                                                        if (_e2147 >= 0f) {
                                                                            if (_e2168 >= 0f) {
                                                                                if (_e2189 >= 0f) {
                                                                                    phi_2759_ = ((_e2147 + _e2168) + _e2189);
                                                                                    phi_2760_ = false;
                                                                                } else {
                                                                                    phi_2759_ = f32();
                                                                                    phi_2760_ = true;
                                                                                }
                                                                                let _e2196 = phi_2759_;
                                                                                let _e2198 = phi_2760_;
                                                                                phi_2761_ = _e2196;
                                                                                phi_2762_ = _e2198;
                                                                            } else {
                                                                                phi_2761_ = f32();
                                                                                phi_2762_ = true;
                                                                            }
                                                                            let _e2200 = phi_2761_;
                                                                            let _e2202 = phi_2762_;
                                                                            phi_2763_ = _e2200;
                                                                            phi_2764_ = _e2202;
                                                                        } else {
                                                                            phi_2763_ = f32();
                                                                            phi_2764_ = true;
                                                                        }
                                                                        let _e2204 = phi_2763_;
                                                                        let _e2206 = phi_2764_;
                                                                        if _e2206 {
                                                                            if (_e2147 <= 0f) {
                                                                                if (_e2168 <= 0f) {
                                                                                    let _e2209 = (_e2189 <= 0f);
                                                                                    if _e2209 {
                                                                                    }
                                                                                    phi_2782_ = ((_e2147 + _e2168) + _e2189);
                                                                                    phi_2783_ = false;
                                                                                    phi_2784_ = _e2209;
                                                                                } else {
                                                                                    phi_2782_ = f32();
                                                                                    phi_2783_ = true;
                                                                                    phi_2784_ = false;
                                                                                }
                                                                                let _e2213 = phi_2782_;
                                                                                let _e2215 = phi_2783_;
                                                                                let _e2217 = phi_2784_;
                                                                                phi_2785_ = _e2213;
                                                                                phi_2786_ = _e2215;
                                                                                phi_2787_ = _e2217;
                                                                            } else {
                                                                                phi_2785_ = f32();
                                                                                phi_2786_ = true;
                                                                                phi_2787_ = false;
                                                                            }
                                                                            let _e2219 = phi_2785_;
                                                                            let _e2221 = phi_2786_;
                                                                            let _e2223 = phi_2787_;
                                                                            if _e2221 {
                                                                                phi_2791_ = false;
                                                                            } else {
                                                                                phi_2791_ = _e2223;
                                                                            }
                                                                            let _e2225 = phi_2791_;
                                                                            phi_2792_ = _e2219;
                                                                            phi_2793_ = _e2225;
                                                                        } else {
                                                                            phi_2792_ = _e2204;
                                                                            phi_2793_ = true;
                                                                        }
                                                                        let _e2227 = phi_2792_;
                                                                        let _e2229 = phi_2793_;
                                                                        if _e2229 {
                                                                            let _e2230 = (_e2227 == 0f);
                                                                            if _e2230 {
                                                                                phi_3109_ = lt_bvh_triangle_Intersection();
                                                                                phi_3110_ = false;
                                                                            } else {
                                                                                let _e2232 = triangles.member[(0u + _e2043)].v0_;
                                                                                let _e2234 = (_e2232.x - _e1149);
                                                                                let _e2236 = (_e2232.y - _e1162);
                                                                                let _e2238 = (_e2232.z - _e1175);
                                                                                if (_e1429 == 0u) {
                                                                                    phi_2822_ = vec3<f32>(_e2236, _e2238, _e2234);
                                                                                } else {
                                                                                    if (_e1429 == 1u) {
                                                                                        phi_2821_ = vec3<f32>(_e2238, _e2234, _e2236);
                                                                                    } else {
                                                                                        phi_2821_ = (_e2232 - vec3<f32>(_e1149, _e1162, _e1175));
                                                                                    }
                                                                                    let _e2246 = phi_2821_;
                                                                                    phi_2822_ = _e2246;
                                                                                }
                                                                                let _e2248 = phi_2822_;
                                                                                let _e2250 = triangles.member[(0u + _e2043)].v1_;
                                                                                let _e2252 = triangles.member[(0u + _e2043)].v0_;
                                                                                let _e2255 = (_e2250.x - _e2252.x);
                                                                                let _e2258 = (_e2250.y - _e2252.y);
                                                                                let _e2261 = (_e2250.z - _e2252.z);
                                                                                if (_e1429 == 0u) {
                                                                                    phi_2848_ = vec3<f32>(_e2258, _e2261, _e2255);
                                                                                } else {
                                                                                    if (_e1429 == 1u) {
                                                                                        phi_2847_ = vec3<f32>(_e2261, _e2255, _e2258);
                                                                                    } else {
                                                                                        phi_2847_ = (_e2250 - _e2252);
                                                                                    }
                                                                                    let _e2268 = phi_2847_;
                                                                                    phi_2848_ = _e2268;
                                                                                }
                                                                                let _e2270 = phi_2848_;
                                                                                let _e2272 = triangles.member[(0u + _e2043)].v2_;
                                                                                let _e2274 = triangles.member[(0u + _e2043)].v0_;
                                                                                let _e2277 = (_e2272.x - _e2274.x);
                                                                                let _e2280 = (_e2272.y - _e2274.y);
                                                                                let _e2283 = (_e2272.z - _e2274.z);
                                                                                if (_e1429 == 0u) {
                                                                                    phi_2874_ = vec3<f32>(_e2280, _e2283, _e2277);
                                                                                } else {
                                                                                    if (_e1429 == 1u) {
                                                                                        phi_2873_ = vec3<f32>(_e2283, _e2277, _e2280);
                                                                                    } else {
                                                                                        phi_2873_ = (_e2272 - _e2274);
                                                                                    }
                                                                                    let _e2290 = phi_2873_;
                                                                                    phi_2874_ = _e2290;
                                                                                }
                                                                                let _e2292 = phi_2874_;
                                                                                let _e2299 = ((_e2270.y * _e2292.z) - (_e2270.z * _e2292.y));
                                                                                let _e2306 = ((_e2270.z * _e2292.x) - (_e2270.x * _e2292.z));
                                                                                let _e2313 = ((_e2270.x * _e2292.y) - (_e2270.y * _e2292.x));
                                                                                let _e2327 = (((1f / _e1437.z) * (((_e2299 * _e2248.x) + (_e2306 * _e2248.y)) + (_e2313 * _e2248.z))) / (((_e2299 * _e1440) + (_e2306 * _e1443)) + _e2313));
                                                                                if (_e2327 > 0f) {
                                                                                    if (_e2327 < _e275) {
                                                                                        let _e2331 = triangles.member[(0u + _e2043)].v0_;
                                                                                        let _e2333 = triangles.member[(0u + _e2043)].v1_;
                                                                                        if (_e2331.x < _e2333.x) {
                                                                                            phi_2930_ = _e2331.x;
                                                                                        } else {
                                                                                            phi_2930_ = _e2333.x;
                                                                                        }
                                                                                        let _e2340 = phi_2930_;
                                                                                        if (_e2331.y < _e2333.y) {
                                                                                            phi_2939_ = _e2331.y;
                                                                                        } else {
                                                                                            phi_2939_ = _e2333.y;
                                                                                        }
                                                                                        let _e2347 = phi_2939_;
                                                                                        if (_e2331.z < _e2333.z) {
                                                                                            phi_2948_ = _e2331.z;
                                                                                        } else {
                                                                                            phi_2948_ = _e2333.z;
                                                                                        }
                                                                                        let _e2354 = phi_2948_;
                                                                                        let _e2356 = triangles.member[(0u + _e2043)].v2_;
                                                                                        if (_e2340 < _e2356.x) {
                                                                                            phi_2957_ = _e2340;
                                                                                        } else {
                                                                                            phi_2957_ = _e2356.x;
                                                                                        }
                                                                                        let _e2361 = phi_2957_;
                                                                                        if (_e2347 < _e2356.y) {
                                                                                            phi_2964_ = _e2347;
                                                                                        } else {
                                                                                            phi_2964_ = _e2356.y;
                                                                                        }
                                                                                        let _e2366 = phi_2964_;
                                                                                        if (_e2354 < _e2356.z) {
                                                                                            phi_2971_ = _e2354;
                                                                                        } else {
                                                                                            phi_2971_ = _e2356.z;
                                                                                        }
                                                                                        let _e2371 = phi_2971_;
                                                                                        let _e2373 = triangles.member[(0u + _e2043)].v0_;
                                                                                        let _e2375 = triangles.member[(0u + _e2043)].v1_;
                                                                                        if (_e2373.x > _e2375.x) {
                                                                                            phi_2984_ = _e2373.x;
                                                                                        } else {
                                                                                            phi_2984_ = _e2375.x;
                                                                                        }
                                                                                        let _e2382 = phi_2984_;
                                                                                        if (_e2373.y > _e2375.y) {
                                                                                            phi_2993_ = _e2373.y;
                                                                                        } else {
                                                                                            phi_2993_ = _e2375.y;
                                                                                        }
                                                                                        let _e2389 = phi_2993_;
                                                                                        if (_e2373.z > _e2375.z) {
                                                                                            phi_3002_ = _e2373.z;
                                                                                        } else {
                                                                                            phi_3002_ = _e2375.z;
                                                                                        }
                                                                                        let _e2396 = phi_3002_;
                                                                                        let _e2398 = triangles.member[(0u + _e2043)].v2_;
                                                                                        if (_e2382 > _e2398.x) {
                                                                                            phi_3011_ = _e2382;
                                                                                        } else {
                                                                                            phi_3011_ = _e2398.x;
                                                                                        }
                                                                                        let _e2403 = phi_3011_;
                                                                                        if (_e2389 > _e2398.y) {
                                                                                            phi_3018_ = _e2389;
                                                                                        } else {
                                                                                            phi_3018_ = _e2398.y;
                                                                                        }
                                                                                        let _e2408 = phi_3018_;
                                                                                        if (_e2396 > _e2398.z) {
                                                                                            phi_3025_ = _e2396;
                                                                                        } else {
                                                                                            phi_3025_ = _e2398.z;
                                                                                        }
                                                                                        let _e2413 = phi_3025_;
                                                                                        let _e2417 = ((_e2361 - _e1149) * _e1358);
                                                                                        let _e2418 = ((_e2366 - _e1162) * _e1368);
                                                                                        let _e2419 = ((_e2371 - _e1175) * _e1378);
                                                                                        let _e2423 = ((_e2403 - _e1149) * _e1358);
                                                                                        let _e2424 = ((_e2408 - _e1162) * _e1368);
                                                                                        let _e2425 = ((_e2413 - _e1175) * _e1378);
                                                                                        if (_e2417 < _e2423) {
                                                                                            phi_3042_ = _e2417;
                                                                                        } else {
                                                                                            phi_3042_ = _e2423;
                                                                                        }
                                                                                        let _e2428 = phi_3042_;
                                                                                        if (_e2418 < _e2424) {
                                                                                            phi_3047_ = _e2418;
                                                                                        } else {
                                                                                            phi_3047_ = _e2424;
                                                                                        }
                                                                                        let _e2431 = phi_3047_;
                                                                                        if (_e2419 < _e2425) {
                                                                                            phi_3052_ = _e2419;
                                                                                        } else {
                                                                                            phi_3052_ = _e2425;
                                                                                        }
                                                                                        let _e2434 = phi_3052_;
                                                                                        if (_e2417 > _e2423) {
                                                                                            phi_3060_ = _e2417;
                                                                                        } else {
                                                                                            phi_3060_ = _e2423;
                                                                                        }
                                                                                        let _e2440 = phi_3060_;
                                                                                        if (_e2418 > _e2424) {
                                                                                            phi_3065_ = _e2418;
                                                                                        } else {
                                                                                            phi_3065_ = _e2424;
                                                                                        }
                                                                                        let _e2443 = phi_3065_;
                                                                                        if (_e2419 > _e2425) {
                                                                                            phi_3070_ = _e2419;
                                                                                        } else {
                                                                                            phi_3070_ = _e2425;
                                                                                        }
                                                                                        let _e2446 = phi_3070_;
                                                                                        let _e2450 = core_intrinsics_maximum_number_nsz_f32_((_e2428 - _e1413), (_e2431 - _e1414));
                                                                                        let _e2451 = core_intrinsics_maximum_number_nsz_f32_(_e2450, (_e2434 - _e1415));
                                                                                        let _e2452 = core_intrinsics_minimum_number_nsz_f32_((_e2440 + _e1413), (_e2443 + _e1414));
                                                                                        let _e2453 = core_intrinsics_minimum_number_nsz_f32_(_e2452, (_e2446 + _e1415));
                                                                                        if (_e2451 > _e1130) {
                                                                                            phi_3082_ = _e2451;
                                                                                        } else {
                                                                                            phi_3082_ = _e1130;
                                                                                        }
                                                                                        let _e2456 = phi_3082_;
                                                                                        if (_e2453 < _e1132) {
                                                                                            phi_3087_ = _e2453;
                                                                                        } else {
                                                                                            phi_3087_ = _e1132;
                                                                                        }
                                                                                        let _e2459 = phi_3087_;
                                                                                        if (_e2327 < _e2456) {
                                                                                            phi_3092_ = _e2456;
                                                                                        } else {
                                                                                            phi_3092_ = _e2327;
                                                                                        }
                                                                                        let _e2462 = phi_3092_;
                                                                                        if (_e2462 > _e2459) {
                                                                                            phi_3097_ = _e2459;
                                                                                        } else {
                                                                                            phi_3097_ = _e2462;
                                                                                        }
                                                                                        let _e2465 = phi_3097_;
                                                                                        phi_3102_ = lt_bvh_triangle_Intersection(_e2465, (_e2168 / _e2227), (_e2189 / _e2227), (_e2456 <= _e2459));
                                                                                        phi_3103_ = false;
                                                                                    } else {
                                                                                        phi_3102_ = lt_bvh_triangle_Intersection();
                                                                                        phi_3103_ = true;
                                                                                    }
                                                                                    let _e2471 = phi_3102_;
                                                                                    let _e2473 = phi_3103_;
                                                                                    phi_3104_ = _e2471;
                                                                                    phi_3105_ = _e2473;
                                                                                } else {
                                                                                    phi_3104_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3105_ = true;
                                                                                }
                                                                                let _e2475 = phi_3104_;
                                                                                let _e2477 = phi_3105_;
                                                                                if _e2477 {
                                                                                }
                                                                                phi_3109_ = _e2475;
                                                                                phi_3110_ = _e2477;
                                                                            }
                                                                            let _e2479 = phi_3109_;
                                                                            let _e2481 = phi_3110_;
                                                                            phi_3111_ = _e2479;
                                                                            phi_3112_ = _e2230;
                                                                            phi_3113_ = _e2481;
                                                                        } else {
                                                                            phi_3111_ = lt_bvh_triangle_Intersection();
                                                                            phi_3112_ = true;
                                                                            phi_3113_ = false;
                                                                        }
                                                                        let _e2483 = phi_3111_;
                                                                        let _e2485 = phi_3112_;
                                                                        let _e2487 = phi_3113_;
                                                                        if _e2485 {
                                                                            phi_3117_ = true;
                                                                        } else {
                                                                            phi_3117_ = _e2487;
                                                                        }
                                                                        let _e2489 = phi_3117_;
                                                                        if _e2489 {
                                                                            phi_3121_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                        } else {
                                                                            phi_3121_ = _e2483;
                                                                        }
                                                                        let _e2491 = phi_3121_;
                                                                        if _e2491.is_hit {
                                                                            if (_e2491.t > 0f) {
                                                                                if (_e2491.t < _e275) {
                                                                                    let _e2498 = triangles.member[(0u + _e2043)].i0_;
                                                                                    if ((_e2498 & 2147483648u) == 0u) {
                                                                                        phi_3340_ = true;
                                                                                    } else {
                                                                                        if (_e2043 < _e82) {
                                                                                        } else {
                                                                                            return;
                                                                                        }
                                                                                        let _e2507 = triangles.member[(0u + _e2043)].i0_;
                                                                                        let _e2508 = (_e2507 & 2147483647u);
                                                                                        let _e2510 = triangles.member[(0u + _e2043)].i1_;
                                                                                        let _e2512 = triangles.member[(0u + _e2043)].i2_;
                                                                                        if (_e2508 < _e91) {
                                                                                        } else {
                                                                                            return;
                                                                                        }
                                                                                        let _e2516 = vertices.member[(0u + _e2508)];
                                                                                        if (_e2510 < _e91) {
                                                                                        } else {
                                                                                            return;
                                                                                        }
                                                                                        let _e2520 = vertices.member[(0u + _e2510)];
                                                                                        if (_e2512 < _e91) {
                                                                                        } else {
                                                                                            return;
                                                                                        }
                                                                                        let _e2524 = vertices.member[(0u + _e2512)];
                                                                                        let _e2525 = array<abi_Vertex, 3>(_e2516, _e2520, _e2524);
                                                                                        if (_e2525[0].material < arrayLength((&materials.member))) {
                                                                                        } else {
                                                                                            return;
                                                                                        }
                                                                                        let _e2531 = materials.member[(0u + _e2525[0].material)];
                                                                                        if ((_e2531.flags & 1u) == 1u) {
                                                                                            let _e2536 = ((1f - _e2491.u) - _e2491.v);
                                                                                            if (_e2531.cutoff <= 0f) {
                                                                                                phi_3338_ = true;
                                                                                            } else {
                                                                                                let _e2563 = (_e2531.base_color.w * ((((f32((_e2525[0].color >> bitcast<u32>(24i))) * _e2536) + (f32((_e2525[1].color >> bitcast<u32>(24i))) * _e2491.u)) + (f32((_e2525[2].color >> bitcast<u32>(24i))) * _e2491.v)) * (1f / 255f)));
                                                                                                if (_e2531.alpha_size == 0u) {
                                                                                                    phi_3335_ = _e2563;
                                                                                                } else {
                                                                                                    local.offset = _e2531.alpha_offset;
                                                                                                    local.size = _e2531.alpha_size;
                                                                                                    local.flags = _e2531.flags;
                                                                                                    let _e2594 = _lt_shaders_texture_TextureView_quad((&local), (((_e2525[0].u * _e2536) + (_e2525[1].u * _e2491.u)) + (_e2525[2].u * _e2491.v)), (((_e2525[0].v * _e2536) + (_e2525[1].v * _e2491.u)) + (_e2525[2].v * _e2491.v)));
                                                                                                    let _e2598 = (_e2594.indices[0] >> bitcast<u32>(2i));
                                                                                                    if (_e2598 < _e97) {
                                                                                                    } else {
                                                                                                        return;
                                                                                                    }
                                                                                                    let _e2602 = alpha_texels.member[(0u + _e2598)];
                                                                                                    let _e2618 = (_e2594.indices[1] >> bitcast<u32>(2i));
                                                                                                    if (_e2618 < _e97) {
                                                                                                    } else {
                                                                                                        return;
                                                                                                    }
                                                                                                    let _e2622 = alpha_texels.member[(0u + _e2618)];
                                                                                                    let _e2639 = (_e2594.indices[2] >> bitcast<u32>(2i));
                                                                                                    if (_e2639 < _e97) {
                                                                                                    } else {
                                                                                                        return;
                                                                                                    }
                                                                                                    let _e2643 = alpha_texels.member[(0u + _e2639)];
                                                                                                    let _e2660 = (_e2594.indices[3] >> bitcast<u32>(2i));
                                                                                                    if (_e2660 < _e97) {
                                                                                                    } else {
                                                                                                        return;
                                                                                                    }
                                                                                                    let _e2664 = alpha_texels.member[(0u + _e2660)];
                                                                                                    phi_3335_ = (_e2563 * (((((f32(((_e2602 >> bitcast<u32>((((_e2594.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2594.weights.x) + ((f32(((_e2622 >> bitcast<u32>((((_e2594.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2594.weights.y)) + ((f32(((_e2643 >> bitcast<u32>((((_e2594.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2594.weights.z)) + ((f32(((_e2664 >> bitcast<u32>((((_e2594.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2594.weights.w)));
                                                                                                }
                                                                                                let _e2680 = phi_3335_;
                                                                                                phi_3338_ = (_e2680 >= _e2531.cutoff);
                                                                                            }
                                                                                            let _e2684 = phi_3338_;
                                                                                            phi_3339_ = _e2684;
                                                                                        } else {
                                                                                            phi_3339_ = false;
                                                                                        }
                                                                                        let _e2686 = phi_3339_;
                                                                                        phi_3340_ = _e2686;
                                                                                    }
                                                                                    let _e2688 = phi_3340_;
                                                                                    if _e2688 {
                                                                                        phi_3344_ = false;
                                                                                    } else {
                                                                                        phi_3344_ = true;
                                                                                    }
                                                                                    let _e2690 = phi_3344_;
                                                                                    phi_3345_ = _e2688;
                                                                                    phi_3346_ = _e2688;
                                                                                    phi_3347_ = _e2690;
                                                                                } else {
                                                                                    phi_3345_ = bool();
                                                                                    phi_3346_ = _e2034;
                                                                                    phi_3347_ = true;
                                                                                }
                                                                                let _e2692 = phi_3345_;
                                                                                let _e2694 = phi_3346_;
                                                                                let _e2696 = phi_3347_;
                                                                                phi_3348_ = _e2692;
                                                                                phi_3349_ = _e2694;
                                                                                phi_3350_ = _e2696;
                                                                            } else {
                                                                                phi_3348_ = bool();
                                                                                phi_3349_ = _e2034;
                                                                                phi_3350_ = true;
                                                                            }
                                                                            let _e2698 = phi_3348_;
                                                                            let _e2700 = phi_3349_;
                                                                            let _e2702 = phi_3350_;
                                                                            phi_3351_ = _e2698;
                                                                            phi_3352_ = _e2700;
                                                                            phi_3353_ = _e2702;
                                                                        } else {
                                                                            phi_3351_ = bool();
                                                                            phi_3352_ = _e2034;
                                                                            phi_3353_ = true;
                                                                        }
                                                                        let _e2704 = phi_3351_;
                                                                        let _e2706 = phi_3352_;
                                                                        let _e2708 = phi_3353_;
                                                                        if _e2708 {
                                                                        }
                                                                        phi_2551_ = (_e2032 & (_e2032 - 1u));
                                                                        phi_2554_ = _e2706;
                                                                        phi_3357_ = _e2704;
                                                                        phi_3358_ = _e2708;
                                                                    }
                                                                    let _e2710 = phi_2551_;
                                                                    let _e2712 = phi_2554_;
                                                                    let _e2714 = phi_3357_;
                                                                    let _e2716 = phi_3358_;
                                                                    local_15 = _e2714;
                                                                    continue;
                                                                    continuing {
                                                                        phi_2550_ = _e2710;
                                                                        phi_2553_ = _e2712;
                                                                        break if !(_e2716);
                                                                    }
                                                                }
                                                                let _e2719 = local_10;
                                                                if _e2719 {
                                                                    let _e2721 = local_1.group_mask;
                                                                    if ((_e2721 & 4278190080u) == 0u) {
                                                                        let _e2725 = local_1.len;
                                                                        if (_e2725 == 0u) {
                                                                            phi_3400_ = false;
                                                                        } else {
                                                                            let _e2729 = local_1.len;
                                                                            local_1.len = (_e2729 - 1u);
                                                                            let _e2732 = local_1.len;
                                                                            if (_e2732 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            let _e2737 = local_1.first[(0u + _e2732)];
                                                                            local_1.group = _e2737;
                                                                            let _e2740 = local_1.len;
                                                                            if (_e2740 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            let _e2745 = local_1.mask[(0u + _e2740)];
                                                                            local_1.group_mask = _e2745;
                                                                            phi_3400_ = true;
                                                                        }
                                                                        let _e2748 = phi_3400_;
                                                                        phi_3401_ = _e2748;
                                                                    } else {
                                                                        phi_3401_ = true;
                                                                    }
                                                                    let _e2750 = phi_3401_;
                                                                    if _e2750 {
                                                                        let _e2752 = local_1.group_mask;
                                                                        let _e2758 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2752)), 32u, (_e2752 == 0u)));
                                                                        let _e2762 = local_1.group_mask;
                                                                        let _e2776 = local_1.group_mask;
                                                                        local_1.group_mask = (_e2776 & ~((1u << bitcast<u32>((_e2758 & 31u)))));
                                                                        let _e2779 = local_1.group;
                                                                        phi_3432_ = (_e2779 + countOneBits(((_e2762 & ~((4294967295u << bitcast<u32>((((_e2758 - 24u) ^ _e1456) & 31u))))) & 255u)));
                                                                    } else {
                                                                        phi_3432_ = 4294967295u;
                                                                    }
                                                                    let _e2782 = phi_3432_;
                                                                    phi_3433_ = _e2782;
                                                                } else {
                                                                    phi_3433_ = u32();
                                                                }
                                                                let _e2784 = phi_3433_;
                                                                phi_2219_ = _e2784;
                                                                let _e3184 = local_14;
                                                                phi_2222_ = _e3184;
                                                                let _e3187 = local_15;
                                                                phi_3434_ = _e3187;
                                                                let _e3190 = local_16;
                                                                phi_3435_ = _e3190;
                                                                phi_3436_ = false;
                                                            } else {
                                                                phi_2219_ = u32();
                                                                phi_2222_ = bool();
                                                                phi_3434_ = bool();
                                                                phi_3435_ = false;
                                                                phi_3436_ = true;
                                                            }
                                                            let _e2786 = phi_2219_;
                                                            let _e2788 = phi_2222_;
                                                            let _e2790 = phi_3434_;
                                                            let _e2792 = phi_3435_;
                                                            let _e2794 = phi_3436_;
                                                            local_11 = _e2794;
                                                            local_17 = _e2790;
                                                            continue;
                                                            continuing {
                                                                phi_2218_ = _e2786;
                                                                phi_2221_ = _e2788;
                                                                break if !(_e2792);
                                                            }
                                                        }
                                                        let _e2797 = local_11;
                                                        if _e2797 {
                                                            phi_3440_ = false;
                                                        } else {
                                                            phi_3440_ = true;
                                                        }
                                                        let _e2799 = phi_3440_;
                                                        if _e2799 {
                                                            let _e3196 = local_17;
                                                            phi_3444_ = _e3196;
                                                        } else {
                                                            let _e3198 = local_18;
                                                            phi_3444_ = _e3198;
                                                        }
                                                        let _e2801 = phi_3444_;
                                                        phi_3445_ = _e2801;
                                                    }
                                                    let _e2803 = phi_3445_;
                                                    phi_3446_ = _e2803;
                                                    phi_3447_ = _e1282;
                                                } else {
                                                    phi_3446_ = bool();
                                                    phi_3447_ = true;
                                                }
                                                let _e2805 = phi_3446_;
                                                let _e2807 = phi_3447_;
                                                if _e2807 {
                                                    phi_3451_ = _e1069;
                                                } else {
                                                    phi_3451_ = _e2805;
                                                }
                                                let _e2809 = phi_3451_;
                                                if _e2809 {
                                                    phi_3455_ = false;
                                                } else {
                                                    phi_3455_ = true;
                                                }
                                                let _e2811 = phi_3455_;
                                                phi_3456_ = _e2809;
                                                phi_3457_ = _e2811;
                                            } else {
                                                phi_3456_ = _e1069;
                                                phi_3457_ = true;
                                            }
                                            let _e2813 = phi_3456_;
                                            let _e2815 = phi_3457_;
                                            phi_3458_ = _e2813;
                                            phi_3459_ = _e2815;
                                        } else {
                                            phi_3458_ = _e1069;
                                            phi_3459_ = true;
                                        }
                                        let _e2817 = phi_3458_;
                                        let _e2819 = phi_3459_;
                                        phi_3460_ = _e2817;
                                        phi_3461_ = _e2819;
                                    } else {
                                        phi_3460_ = _e1069;
                                        phi_3461_ = true;
                                    }
                                    let _e2821 = phi_3460_;
                                    let _e2823 = phi_3461_;
                                    if _e2823 {
                                    }
                                    phi_1611_ = (_e1067 & (_e1067 - 1u));
                                    phi_1614_ = _e2821;
                                    phi_3465_ = _e2823;
                                }
                                let _e2825 = phi_1611_;
                                let _e2827 = phi_1614_;
                                let _e2829 = phi_3465_;
                                continue;
                                continuing {
                                    phi_1610_ = _e2825;
                                    phi_1613_ = _e2827;
                                    break if !(_e2829);
                                }
                            }
                            let _e2832 = local_12;
                            if _e2832 {
                                let _e2834 = local_2.group_mask;
                                if ((_e2834 & 4278190080u) == 0u) {
                                    let _e2838 = local_2.len;
                                    if (_e2838 == 0u) {
                                        phi_3507_ = false;
                                    } else {
                                        let _e2842 = local_2.len;
                                        local_2.len = (_e2842 - 1u);
                                        let _e2845 = local_2.len;
                                        if (_e2845 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2850 = local_2.first[(0u + _e2845)];
                                        local_2.group = _e2850;
                                        let _e2853 = local_2.len;
                                        if (_e2853 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2858 = local_2.mask[(0u + _e2853)];
                                        local_2.group_mask = _e2858;
                                        phi_3507_ = true;
                                    }
                                    let _e2861 = phi_3507_;
                                    phi_3508_ = _e2861;
                                } else {
                                    phi_3508_ = true;
                                }
                                let _e2863 = phi_3508_;
                                if _e2863 {
                                    let _e2865 = local_2.group_mask;
                                    let _e2871 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2865)), 32u, (_e2865 == 0u)));
                                    let _e2875 = local_2.group_mask;
                                    let _e2889 = local_2.group_mask;
                                    local_2.group_mask = (_e2889 & ~((1u << bitcast<u32>((_e2871 & 31u)))));
                                    let _e2892 = local_2.group;
                                    phi_3539_ = (_e2892 + countOneBits(((_e2875 & ~((4294967295u << bitcast<u32>((((_e2871 - 24u) ^ _e491) & 31u))))) & 255u)));
                                } else {
                                    phi_3539_ = 4294967295u;
                                }
                                let _e2895 = phi_3539_;
                                phi_3540_ = _e2895;
                            } else {
                                phi_3540_ = u32();
                            }
                            let _e2897 = phi_3540_;
                            phi_1279_ = _e2897;
                            let _e3221 = local_19;
                            phi_1282_ = _e3221;
                            let _e3224 = local_20;
                            phi_3541_ = _e3224;
                            phi_3542_ = false;
                        } else {
                            phi_1279_ = u32();
                            phi_1282_ = bool();
                            phi_3541_ = false;
                            phi_3542_ = true;
                        }
                        let _e2899 = phi_1279_;
                        let _e2901 = phi_1282_;
                        let _e2903 = phi_3541_;
                        let _e2905 = phi_3542_;
                        local_13 = _e2905;
                        continue;
                        continuing {
                            phi_1278_ = _e2899;
                            phi_1281_ = _e2901;
                            break if !(_e2903);
                        }
                    }
                    let _e2908 = local_13;
                    if _e2908 {
                        phi_3546_ = false;
                    } else {
                        phi_3546_ = true;
                    }
                    let _e2910 = phi_3546_;
                    if _e2910 {
                    }
                    phi_3550_ = _e2910;
                }
                let _e2912 = phi_3550_;
                phi_3551_ = _e347;
                phi_3552_ = _e2912;
            } else {
                phi_3551_ = true;
                phi_3552_ = false;
            }
            let _e2914 = phi_3551_;
            let _e2916 = phi_3552_;
            if _e2914 {
                phi_3556_ = false;
                phi_3557_ = true;
            } else {
                phi_3556_ = true;
                phi_3557_ = _e2916;
            }
            let _e2918 = phi_3556_;
            let _e2920 = phi_3557_;
            if _e2920 {
                phi_3561_ = _e2918;
            } else {
                phi_3561_ = false;
            }
            let _e2922 = phi_3561_;
            if _e2922 {
                phi_3565_ = 0f;
            } else {
                phi_3565_ = 1f;
            }
            let _e2924 = phi_3565_;
            phi_3566_ = _e2924;
        }
        let _e2926 = phi_3566_;
        if (_e103.shift < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e103.shift)] = _e2926;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_instanced_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
