struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
}

struct type_9 {
    member: array<u32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_21 {
    member: array<abi_Sample>,
}

struct type_25 {
    member: array<f32>,
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

struct type_40 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_44 {
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

struct type_48 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_52 {
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

struct type_56 {
    member: array<abi_Material>,
}

struct u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_ {
    unnamed: lt_bvh_traverse_Tree,
    unnamed_1: lt_bvh_traverse_Tree,
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

struct type_67 {
    member: array<lt_bvh_Instance>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_21;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_25;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_40;
@group(0) @binding(2) 
var<storage> nodes: type_44;
@group(0) @binding(3) 
var<storage> triangles: type_48;
@group(0) @binding(6) 
var<storage> vertices: type_52;
@group(0) @binding(7) 
var<storage> materials: type_56;
@group(0) @binding(8) 
var<storage> alpha_texels: type_9;
@group(0) @binding(5) 
var<storage> instances: type_67;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_236_: lt_bvh_traverse_Tree;
    var phi_237_: bool;
    var phi_238_: lt_bvh_traverse_Tree;
    var phi_239_: bool;
    var phi_244_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_236_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_237_ = false;
        } else {
            phi_236_ = lt_bvh_traverse_Tree();
            phi_237_ = true;
        }
        let _e81 = phi_236_;
        let _e83 = phi_237_;
        phi_238_ = _e81;
        phi_239_ = _e83;
    } else {
        phi_238_ = lt_bvh_traverse_Tree();
        phi_239_ = true;
    }
    let _e85 = phi_238_;
    let _e87 = phi_239_;
    if _e87 {
        phi_244_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_244_ = _e85;
    }
    let _e92 = phi_244_;
    return lt_bvh_traverse_Tree(_e92.root, _e92.first_primitive);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_259_: bool;
    var phi_263_: f32;

    if (param_3 != param_3) {
        phi_259_ = true;
    } else {
        let _e71 = (param_4 >= param_3);
        if _e71 {
        }
        phi_259_ = _e71;
    }
    let _e73 = phi_259_;
    if _e73 {
        phi_263_ = param_4;
    } else {
        phi_263_ = param_3;
    }
    let _e75 = phi_263_;
    return _e75;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_275_: bool;
    var phi_279_: f32;

    if (param_5 != param_5) {
        phi_275_ = true;
    } else {
        let _e71 = (param_6 <= param_5);
        if _e71 {
        }
        phi_275_ = _e71;
    }
    let _e73 = phi_275_;
    if _e73 {
        phi_279_ = param_6;
    } else {
        phi_279_ = param_5;
    }
    let _e75 = phi_279_;
    return _e75;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_321_: f32;
    var phi_326_: f32;
    var phi_327_: bool;
    var phi_328_: f32;
    var phi_329_: bool;
    var phi_333_: f32;
    var phi_359_: f32;
    var phi_364_: f32;
    var phi_365_: bool;
    var phi_366_: f32;
    var phi_367_: bool;
    var phi_371_: f32;
    var phi_379_: f32;
    var phi_380_: f32;
    var phi_381_: f32;
    var phi_390_: f32;
    var phi_391_: f32;
    var phi_409_: u32;
    var phi_423_: u32;
    var phi_430_: u32;
    var phi_435_: u32;
    var phi_441_: u32;
    var phi_446_: u32;
    var phi_448_: texture_Axis;
    var phi_476_: f32;
    var phi_481_: f32;
    var phi_482_: bool;
    var phi_483_: f32;
    var phi_484_: bool;
    var phi_488_: f32;
    var phi_514_: f32;
    var phi_519_: f32;
    var phi_520_: bool;
    var phi_521_: f32;
    var phi_522_: bool;
    var phi_526_: f32;
    var phi_534_: f32;
    var phi_535_: f32;
    var phi_536_: f32;
    var phi_545_: f32;
    var phi_546_: f32;
    var phi_564_: u32;
    var phi_578_: u32;
    var phi_585_: u32;
    var phi_590_: u32;
    var phi_596_: u32;
    var phi_601_: u32;
    var phi_603_: texture_Axis;

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
                phi_321_ = 1f;
            } else {
                phi_321_ = 0f;
            }
            let _e102 = phi_321_;
            if (param_8 < 8388608f) {
                phi_326_ = (_e99 - _e102);
                phi_327_ = false;
            } else {
                phi_326_ = f32();
                phi_327_ = true;
            }
            let _e105 = phi_326_;
            let _e107 = phi_327_;
            phi_328_ = _e105;
            phi_329_ = _e107;
        } else {
            phi_328_ = f32();
            phi_329_ = true;
        }
        let _e109 = phi_328_;
        let _e111 = phi_329_;
        if _e111 {
            phi_333_ = param_8;
        } else {
            phi_333_ = _e109;
        }
        let _e113 = phi_333_;
        phi_381_ = (param_8 - _e113);
    } else {
        if (_e86 == 1u) {
            let _e116 = (param_8 * 0.5f);
            if (_e116 > -8388608f) {
                let _e128 = f32(select(0i, select(select(i32(_e116), i32(-2147483648), (_e116 < bitcast<f32>(3472883712u))), 2147483647i, (_e116 > bitcast<f32>(1325400063u))), (_e116 == _e116)));
                if (_e128 > _e116) {
                    phi_359_ = 1f;
                } else {
                    phi_359_ = 0f;
                }
                let _e131 = phi_359_;
                if (_e116 < 8388608f) {
                    phi_364_ = (_e128 - _e131);
                    phi_365_ = false;
                } else {
                    phi_364_ = f32();
                    phi_365_ = true;
                }
                let _e134 = phi_364_;
                let _e136 = phi_365_;
                phi_366_ = _e134;
                phi_367_ = _e136;
            } else {
                phi_366_ = f32();
                phi_367_ = true;
            }
            let _e138 = phi_366_;
            let _e140 = phi_367_;
            if _e140 {
                phi_371_ = _e116;
            } else {
                phi_371_ = _e138;
            }
            let _e142 = phi_371_;
            let _e144 = (param_8 - (2f * _e142));
            if (_e144 > 1f) {
                phi_379_ = (2f - _e144);
            } else {
                phi_379_ = _e144;
            }
            let _e148 = phi_379_;
            phi_380_ = _e148;
        } else {
            phi_380_ = param_8;
        }
        let _e150 = phi_380_;
        phi_381_ = _e150;
    }
    let _e152 = phi_381_;
    if (_e152 > 0f) {
        if (_e152 < 1f) {
            phi_390_ = _e152;
        } else {
            phi_390_ = 1f;
        }
        let _e156 = phi_390_;
        phi_391_ = _e156;
    } else {
        phi_391_ = 0f;
    }
    let _e158 = phi_391_;
    let _e159 = (_e73 - 1u);
    let _e161 = (_e158 * f32(_e73));
    if _e81 {
        let _e168 = select(select(u32(_e161), 0u, (_e161 < bitcast<f32>(0u))), 4294967295u, (_e161 > bitcast<f32>(1333788671u)));
        if (_e159 < _e168) {
            phi_409_ = _e159;
        } else {
            phi_409_ = _e168;
        }
        let _e171 = phi_409_;
        phi_448_ = texture_Axis(_e171, _e171, 0f);
    } else {
        let _e173 = (_e161 + 0.5f);
        let _e180 = select(select(u32(_e173), 0u, (_e173 < bitcast<f32>(0u))), 4294967295u, (_e173 > bitcast<f32>(1333788671u)));
        if (_e73 < _e180) {
            phi_423_ = _e73;
        } else {
            phi_423_ = _e180;
        }
        let _e183 = phi_423_;
        if (_e86 == 0u) {
            phi_430_ = _e159;
        } else {
            phi_430_ = 0u;
        }
        let _e188 = phi_430_;
        if (_e86 == 0u) {
            phi_435_ = 0u;
        } else {
            phi_435_ = _e159;
        }
        let _e191 = phi_435_;
        if (_e183 == 0u) {
            phi_441_ = _e188;
        } else {
            phi_441_ = (_e183 - 1u);
        }
        let _e195 = phi_441_;
        if (_e183 > _e159) {
            phi_446_ = _e191;
        } else {
            phi_446_ = _e183;
        }
        let _e198 = phi_446_;
        phi_448_ = texture_Axis(_e195, _e198, (_e173 - f32(_e183)));
    }
    let _e201 = phi_448_;
    let _e203 = (*param_7).flags;
    let _e206 = ((_e203 >> bitcast<u32>(6u)) & 3u);
    if (_e206 == 0u) {
        if (param_9 > -8388608f) {
            let _e219 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e219 > param_9) {
                phi_476_ = 1f;
            } else {
                phi_476_ = 0f;
            }
            let _e222 = phi_476_;
            if (param_9 < 8388608f) {
                phi_481_ = (_e219 - _e222);
                phi_482_ = false;
            } else {
                phi_481_ = f32();
                phi_482_ = true;
            }
            let _e225 = phi_481_;
            let _e227 = phi_482_;
            phi_483_ = _e225;
            phi_484_ = _e227;
        } else {
            phi_483_ = f32();
            phi_484_ = true;
        }
        let _e229 = phi_483_;
        let _e231 = phi_484_;
        if _e231 {
            phi_488_ = param_9;
        } else {
            phi_488_ = _e229;
        }
        let _e233 = phi_488_;
        phi_536_ = (param_9 - _e233);
    } else {
        if (_e206 == 1u) {
            let _e236 = (param_9 * 0.5f);
            if (_e236 > -8388608f) {
                let _e248 = f32(select(0i, select(select(i32(_e236), i32(-2147483648), (_e236 < bitcast<f32>(3472883712u))), 2147483647i, (_e236 > bitcast<f32>(1325400063u))), (_e236 == _e236)));
                if (_e248 > _e236) {
                    phi_514_ = 1f;
                } else {
                    phi_514_ = 0f;
                }
                let _e251 = phi_514_;
                if (_e236 < 8388608f) {
                    phi_519_ = (_e248 - _e251);
                    phi_520_ = false;
                } else {
                    phi_519_ = f32();
                    phi_520_ = true;
                }
                let _e254 = phi_519_;
                let _e256 = phi_520_;
                phi_521_ = _e254;
                phi_522_ = _e256;
            } else {
                phi_521_ = f32();
                phi_522_ = true;
            }
            let _e258 = phi_521_;
            let _e260 = phi_522_;
            if _e260 {
                phi_526_ = _e236;
            } else {
                phi_526_ = _e258;
            }
            let _e262 = phi_526_;
            let _e264 = (param_9 - (2f * _e262));
            if (_e264 > 1f) {
                phi_534_ = (2f - _e264);
            } else {
                phi_534_ = _e264;
            }
            let _e268 = phi_534_;
            phi_535_ = _e268;
        } else {
            phi_535_ = param_9;
        }
        let _e270 = phi_535_;
        phi_536_ = _e270;
    }
    let _e272 = phi_536_;
    if (_e272 > 0f) {
        if (_e272 < 1f) {
            phi_545_ = _e272;
        } else {
            phi_545_ = 1f;
        }
        let _e276 = phi_545_;
        phi_546_ = _e276;
    } else {
        phi_546_ = 0f;
    }
    let _e278 = phi_546_;
    let _e279 = (_e77 - 1u);
    let _e281 = (_e278 * f32(_e77));
    if _e81 {
        let _e288 = select(select(u32(_e281), 0u, (_e281 < bitcast<f32>(0u))), 4294967295u, (_e281 > bitcast<f32>(1333788671u)));
        if (_e279 < _e288) {
            phi_564_ = _e279;
        } else {
            phi_564_ = _e288;
        }
        let _e291 = phi_564_;
        phi_603_ = texture_Axis(_e291, _e291, 0f);
    } else {
        let _e293 = (_e281 + 0.5f);
        let _e300 = select(select(u32(_e293), 0u, (_e293 < bitcast<f32>(0u))), 4294967295u, (_e293 > bitcast<f32>(1333788671u)));
        if (_e77 < _e300) {
            phi_578_ = _e77;
        } else {
            phi_578_ = _e300;
        }
        let _e303 = phi_578_;
        if (_e206 == 0u) {
            phi_585_ = _e279;
        } else {
            phi_585_ = 0u;
        }
        let _e308 = phi_585_;
        if (_e206 == 0u) {
            phi_590_ = 0u;
        } else {
            phi_590_ = _e279;
        }
        let _e311 = phi_590_;
        if (_e303 == 0u) {
            phi_596_ = _e308;
        } else {
            phi_596_ = (_e303 - 1u);
        }
        let _e315 = phi_596_;
        if (_e303 > _e279) {
            phi_601_ = _e311;
        } else {
            phi_601_ = _e303;
        }
        let _e318 = phi_601_;
        phi_603_ = texture_Axis(_e315, _e318, (_e293 - f32(_e303)));
    }
    let _e321 = phi_603_;
    let _e325 = (*param_7).offset;
    let _e332 = (*param_7).offset;
    let _e339 = (*param_7).offset;
    let _e346 = (*param_7).offset;
    return texture_TexelQuad(array<u32, 4>(((_e325 + (_e321.low * _e73)) + _e201.low), ((_e332 + (_e321.low * _e73)) + _e201.high), ((_e339 + (_e321.high * _e73)) + _e201.low), ((_e346 + (_e321.high * _e73)) + _e201.high)), vec4<f32>(((1f - _e201.fraction) * (1f - _e321.fraction)), (_e201.fraction * (1f - _e321.fraction)), ((1f - _e201.fraction) * _e321.fraction), (_e201.fraction * _e321.fraction)));
}

fn _lt_shaders_abi_Sample_is_valid(param_10: ptr<function, abi_Sample>) -> bool {
    var phi_675_: bool;
    var phi_676_: bool;
    var phi_677_: bool;
    var phi_678_: bool;
    var phi_682_: bool;

    let _e71 = (*param_10).normal[0u];
    let _e73 = global[0u];
    if (_e71 == _e73) {
        let _e76 = (*param_10).normal[1u];
        let _e78 = global[1u];
        if (_e76 == _e78) {
            let _e81 = (*param_10).normal[2u];
            let _e83 = global[2u];
            phi_675_ = (_e81 == _e83);
            phi_676_ = false;
        } else {
            phi_675_ = bool();
            phi_676_ = true;
        }
        let _e86 = phi_675_;
        let _e88 = phi_676_;
        phi_677_ = _e86;
        phi_678_ = _e88;
    } else {
        phi_677_ = bool();
        phi_678_ = true;
    }
    let _e90 = phi_677_;
    let _e92 = phi_678_;
    if _e92 {
        phi_682_ = false;
    } else {
        phi_682_ = _e90;
    }
    let _e94 = phi_682_;
    return !(_e94);
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: lt_bvh_traverse_Stack;
    var local_3: abi_Sample;
    var phi_804_: bool;
    var phi_805_: bool;
    var phi_816_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_817_: bool;
    var phi_818_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_819_: bool;
    var phi_826_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_830_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_882_: f32;
    var phi_914_: bool;
    var phi_915_: bool;
    var phi_916_: bool;
    var phi_917_: bool;
    var phi_921_: bool;
    var phi_934_: bool;
    var phi_935_: bool;
    var phi_936_: bool;
    var phi_937_: bool;
    var phi_941_: bool;
    var phi_954_: bool;
    var phi_955_: bool;
    var phi_956_: bool;
    var phi_960_: bool;
    var phi_961_: bool;
    var phi_962_: bool;
    var phi_963_: bool;
    var phi_964_: bool;
    var phi_968_: bool;
    var phi_1038_: f32;
    var phi_1045_: f32;
    var phi_1052_: f32;
    var phi_1059_: f32;
    var phi_1066_: f32;
    var phi_1073_: f32;
    var phi_1090_: f32;
    var phi_1095_: f32;
    var phi_1100_: f32;
    var phi_1105_: f32;
    var phi_1110_: f32;
    var phi_1129_: u32;
    var phi_1134_: u32;
    var phi_1139_: u32;
    var phi_1253_: bool;
    var phi_1254_: bool;
    var phi_1285_: u32;
    var phi_1287_: u32;
    var phi_1290_: bool;
    var phi_1370_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1397_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1424_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1430_: u32;
    var phi_1433_: u32;
    var phi_1447_: u32;
    var phi_1457_: u32;
    var phi_1467_: u32;
    var phi_1485_: u32;
    var phi_1495_: u32;
    var phi_1505_: u32;
    var phi_1541_: u32;
    var phi_1554_: u32;
    var phi_1559_: u32;
    var phi_1560_: u32;
    var phi_1561_: u32;
    var phi_1431_: u32;
    var phi_1434_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_1619_: u32;
    var phi_1622_: bool;
    var phi_1671_: f32;
    var phi_1676_: f32;
    var phi_1681_: f32;
    var phi_1689_: f32;
    var phi_1694_: f32;
    var phi_1699_: f32;
    var phi_1819_: bool;
    var phi_1820_: bool;
    var phi_1821_: bool;
    var phi_1822_: bool;
    var phi_1826_: bool;
    var phi_1839_: bool;
    var phi_1840_: bool;
    var phi_1841_: bool;
    var phi_1842_: bool;
    var phi_1846_: bool;
    var phi_1859_: bool;
    var phi_1860_: bool;
    var phi_1861_: bool;
    var phi_1865_: bool;
    var phi_1866_: bool;
    var phi_1867_: bool;
    var phi_1868_: bool;
    var phi_1869_: bool;
    var phi_1873_: bool;
    var phi_1943_: f32;
    var phi_1950_: f32;
    var phi_1957_: f32;
    var phi_1964_: f32;
    var phi_1971_: f32;
    var phi_1978_: f32;
    var phi_1995_: f32;
    var phi_2000_: f32;
    var phi_2005_: f32;
    var phi_2010_: f32;
    var phi_2015_: f32;
    var phi_2041_: bool;
    var phi_2042_: bool;
    var phi_2050_: u32;
    var phi_2051_: u32;
    var phi_2062_: vec3<f32>;
    var phi_2063_: vec3<f32>;
    var phi_2076_: u32;
    var phi_2081_: u32;
    var phi_2086_: u32;
    var phi_2200_: bool;
    var phi_2201_: bool;
    var phi_2232_: u32;
    var phi_2234_: u32;
    var phi_2237_: bool;
    var phi_2317_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2344_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2371_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2377_: u32;
    var phi_2380_: u32;
    var phi_2394_: u32;
    var phi_2404_: u32;
    var phi_2414_: u32;
    var phi_2432_: u32;
    var phi_2442_: u32;
    var phi_2452_: u32;
    var phi_2488_: u32;
    var phi_2501_: u32;
    var phi_2506_: u32;
    var phi_2507_: u32;
    var phi_2508_: u32;
    var phi_2378_: u32;
    var phi_2381_: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var phi_2566_: u32;
    var phi_2569_: bool;
    var phi_2613_: vec3<f32>;
    var phi_2614_: vec3<f32>;
    var phi_2643_: vec3<f32>;
    var phi_2644_: vec3<f32>;
    var phi_2673_: vec3<f32>;
    var phi_2674_: vec3<f32>;
    var phi_2692_: bool;
    var phi_2693_: bool;
    var phi_2697_: f32;
    var phi_2698_: f32;
    var phi_2699_: f32;
    var phi_2700_: f32;
    var phi_2708_: f32;
    var phi_2718_: bool;
    var phi_2719_: bool;
    var phi_2723_: f32;
    var phi_2724_: f32;
    var phi_2725_: f32;
    var phi_2726_: f32;
    var phi_2734_: f32;
    var phi_2744_: bool;
    var phi_2745_: bool;
    var phi_2749_: f32;
    var phi_2750_: f32;
    var phi_2751_: f32;
    var phi_2752_: f32;
    var phi_2760_: f32;
    var phi_2775_: f32;
    var phi_2776_: bool;
    var phi_2777_: f32;
    var phi_2778_: bool;
    var phi_2779_: f32;
    var phi_2780_: bool;
    var phi_2798_: f32;
    var phi_2799_: bool;
    var phi_2800_: bool;
    var phi_2801_: f32;
    var phi_2802_: bool;
    var phi_2803_: bool;
    var phi_2807_: bool;
    var phi_2808_: f32;
    var phi_2809_: bool;
    var phi_2837_: vec3<f32>;
    var phi_2838_: vec3<f32>;
    var phi_2863_: vec3<f32>;
    var phi_2864_: vec3<f32>;
    var phi_2889_: vec3<f32>;
    var phi_2890_: vec3<f32>;
    var phi_2946_: f32;
    var phi_2955_: f32;
    var phi_2964_: f32;
    var phi_2973_: f32;
    var phi_2980_: f32;
    var phi_2987_: f32;
    var phi_3000_: f32;
    var phi_3009_: f32;
    var phi_3018_: f32;
    var phi_3027_: f32;
    var phi_3034_: f32;
    var phi_3041_: f32;
    var phi_3058_: f32;
    var phi_3063_: f32;
    var phi_3068_: f32;
    var phi_3076_: f32;
    var phi_3081_: f32;
    var phi_3086_: f32;
    var phi_3098_: f32;
    var phi_3103_: f32;
    var phi_3108_: f32;
    var phi_3113_: f32;
    var phi_3118_: lt_bvh_triangle_Intersection;
    var phi_3119_: bool;
    var phi_3120_: lt_bvh_triangle_Intersection;
    var phi_3121_: bool;
    var phi_3125_: lt_bvh_triangle_Intersection;
    var phi_3126_: bool;
    var phi_3127_: lt_bvh_triangle_Intersection;
    var phi_3128_: bool;
    var phi_3129_: bool;
    var phi_3133_: bool;
    var phi_3137_: lt_bvh_triangle_Intersection;
    var phi_3351_: f32;
    var phi_3354_: bool;
    var phi_3355_: bool;
    var phi_3356_: bool;
    var phi_3360_: bool;
    var phi_3361_: bool;
    var phi_3362_: bool;
    var phi_3363_: bool;
    var phi_3364_: bool;
    var phi_3365_: bool;
    var phi_3366_: bool;
    var phi_3367_: bool;
    var phi_3368_: bool;
    var phi_3369_: bool;
    var phi_2567_: u32;
    var phi_2570_: bool;
    var phi_3373_: bool;
    var phi_3374_: bool;
    var local_10: bool;
    var phi_3416_: bool;
    var phi_3417_: bool;
    var phi_3448_: u32;
    var phi_3449_: u32;
    var phi_2235_: u32;
    var phi_2238_: bool;
    var phi_3450_: bool;
    var phi_3451_: bool;
    var phi_3452_: bool;
    var local_11: bool;
    var phi_3456_: bool;
    var phi_3460_: bool;
    var phi_3461_: bool;
    var phi_3462_: bool;
    var phi_3463_: bool;
    var phi_3467_: bool;
    var phi_3471_: bool;
    var phi_3472_: bool;
    var phi_3473_: bool;
    var phi_3474_: bool;
    var phi_3475_: bool;
    var phi_3476_: bool;
    var phi_3477_: bool;
    var phi_1620_: u32;
    var phi_1623_: bool;
    var phi_3481_: bool;
    var local_12: bool;
    var phi_3523_: bool;
    var phi_3524_: bool;
    var phi_3555_: u32;
    var phi_3556_: u32;
    var phi_1288_: u32;
    var phi_1291_: bool;
    var phi_3557_: bool;
    var phi_3558_: bool;
    var local_13: bool;
    var phi_3562_: bool;
    var phi_3566_: bool;
    var phi_3567_: bool;
    var phi_3568_: bool;
    var phi_3572_: bool;
    var phi_3573_: bool;
    var phi_3577_: bool;
    var phi_3581_: f32;
    var phi_3582_: f32;
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
    if (bitcast<i32>(_e103.root) != 0i) {
        if (_e103.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e111 = samples.member[(0u + _e103.first_primitive)];
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
                    phi_805_ = true;
                } else {
                    let _e172 = p.member.light.range_squared;
                    if (_e155 <= _e172) {
                        let _e175 = p.member.light.cos_outer;
                        phi_804_ = (-((((_e137 * _e157.x) + (_e138 * _e157.y)) + (_e139 * _e157.z))) >= (_e175 * sqrt(_e155)));
                    } else {
                        phi_804_ = false;
                    }
                    let _e180 = phi_804_;
                    phi_805_ = _e180;
                }
                let _e182 = phi_805_;
                if _e182 {
                    let _e184 = local_3.flags;
                    let _e192 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e198 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e192.unnamed.visibility, false), _e192.unnamed_1);
                    phi_816_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e198.unnamed, ((_e184 & 1u) == 0u));
                    phi_817_ = false;
                } else {
                    phi_816_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_817_ = true;
                }
                let _e203 = phi_816_;
                let _e205 = phi_817_;
                phi_818_ = _e203;
                phi_819_ = _e205;
            } else {
                phi_818_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_819_ = true;
            }
            let _e207 = phi_818_;
            let _e209 = phi_819_;
            if _e209 {
                let _e215 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e215.unnamed.visibility, false), _e215.unnamed_1);
                phi_826_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e221.unnamed, true);
            } else {
                phi_826_ = _e207;
            }
            let _e226 = phi_826_;
            phi_830_ = _e226;
        } else {
            let _e232 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e238 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e232.unnamed.visibility, false), _e232.unnamed_1);
            phi_830_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e238.unnamed, true);
        }
        let _e243 = phi_830_;
        let _e248 = p.member.root;
        if _e243.unnamed_1 {
            phi_3582_ = _e243.unnamed.visibility;
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
                phi_882_ = 300000000000000000000000000000000000000f;
            } else {
                phi_882_ = 1f;
            }
            let _e275 = phi_882_;
            let _e283 = (_e271.x - (_e265 * _e271.w));
            let _e284 = (_e271.y - (_e267 * _e271.w));
            let _e285 = (_e271.z - (_e269 * _e271.w));
            let _e286 = abs(_e283);
            let _e287 = abs(_e284);
            let _e288 = abs(_e285);
            if (abs(_e265) < 1000000000000000f) {
                if (abs(_e267) < 1000000000000000f) {
                    phi_914_ = (abs(_e269) < 1000000000000000f);
                    phi_915_ = false;
                } else {
                    phi_914_ = bool();
                    phi_915_ = true;
                }
                let _e296 = phi_914_;
                let _e298 = phi_915_;
                phi_916_ = _e296;
                phi_917_ = _e298;
            } else {
                phi_916_ = bool();
                phi_917_ = true;
            }
            let _e300 = phi_916_;
            let _e302 = phi_917_;
            if _e302 {
                phi_921_ = false;
            } else {
                phi_921_ = _e300;
            }
            let _e304 = phi_921_;
            if _e304 {
                if (_e286 < 1000000000000000f) {
                    if (_e287 < 1000000000000000f) {
                        phi_934_ = (_e288 < 1000000000000000f);
                        phi_935_ = false;
                    } else {
                        phi_934_ = bool();
                        phi_935_ = true;
                    }
                    let _e309 = phi_934_;
                    let _e311 = phi_935_;
                    phi_936_ = _e309;
                    phi_937_ = _e311;
                } else {
                    phi_936_ = bool();
                    phi_937_ = true;
                }
                let _e313 = phi_936_;
                let _e315 = phi_937_;
                if _e315 {
                    phi_941_ = false;
                } else {
                    phi_941_ = _e313;
                }
                let _e317 = phi_941_;
                if _e317 {
                    if (_e286 > 0f) {
                        phi_955_ = bool();
                        phi_956_ = true;
                    } else {
                        let _e319 = (_e287 > 0f);
                        if _e319 {
                            phi_954_ = bool();
                        } else {
                            phi_954_ = (_e288 > 0f);
                        }
                        let _e322 = phi_954_;
                        phi_955_ = _e322;
                        phi_956_ = _e319;
                    }
                    let _e324 = phi_955_;
                    let _e326 = phi_956_;
                    if _e326 {
                        phi_960_ = true;
                    } else {
                        phi_960_ = _e324;
                    }
                    let _e328 = phi_960_;
                    phi_961_ = _e328;
                    phi_962_ = false;
                } else {
                    phi_961_ = bool();
                    phi_962_ = true;
                }
                let _e330 = phi_961_;
                let _e332 = phi_962_;
                phi_963_ = _e330;
                phi_964_ = _e332;
            } else {
                phi_963_ = bool();
                phi_964_ = true;
            }
            let _e334 = phi_963_;
            let _e336 = phi_964_;
            if _e336 {
                phi_968_ = false;
            } else {
                phi_968_ = _e334;
            }
            let _e338 = phi_968_;
            if _e338 {
                let _e339 = (_e248 >= _e79);
                if _e339 {
                    phi_3566_ = false;
                } else {
                    if (_e248 < _e79) {
                    } else {
                        return;
                    }
                    let _e345 = nodes.member[(0u + _e248)].frame[0u];
                    let _e349 = nodes.member[(0u + _e248)].frame[1u];
                    let _e353 = nodes.member[(0u + _e248)].frame[2u];
                    let _e357 = nodes.member[(0u + _e248)].frame[0u];
                    let _e361 = nodes.member[(0u + _e248)].frame[1u];
                    let _e365 = nodes.member[(0u + _e248)].frame[2u];
                    let _e369 = nodes.member[(0u + _e248)].frame[3u];
                    let _e403 = core_intrinsics_maximum_number_nsz_f32_(abs(_e283), abs(_e284));
                    let _e404 = core_intrinsics_maximum_number_nsz_f32_(_e403, abs(_e285));
                    let _e405 = (_e404 * 0.0000000000009094947f);
                    if (abs(_e283) < _e405) {
                        phi_1038_ = _e405;
                    } else {
                        phi_1038_ = abs(_e283);
                    }
                    let _e410 = phi_1038_;
                    if (_e283 < 0f) {
                        phi_1045_ = (-1f / _e410);
                    } else {
                        phi_1045_ = (1f / _e410);
                    }
                    let _e415 = phi_1045_;
                    if (abs(_e284) < _e405) {
                        phi_1052_ = _e405;
                    } else {
                        phi_1052_ = abs(_e284);
                    }
                    let _e420 = phi_1052_;
                    if (_e284 < 0f) {
                        phi_1059_ = (-1f / _e420);
                    } else {
                        phi_1059_ = (1f / _e420);
                    }
                    let _e425 = phi_1059_;
                    if (abs(_e285) < _e405) {
                        phi_1066_ = _e405;
                    } else {
                        phi_1066_ = abs(_e285);
                    }
                    let _e430 = phi_1066_;
                    if (_e285 < 0f) {
                        phi_1073_ = (-1f / _e430);
                    } else {
                        phi_1073_ = (1f / _e430);
                    }
                    let _e435 = phi_1073_;
                    let _e439 = abs((bitcast<f32>(_e345) - _e265));
                    let _e440 = abs((bitcast<f32>(_e349) - _e267));
                    let _e441 = abs((bitcast<f32>(_e353) - _e269));
                    let _e445 = abs(((bitcast<f32>(_e357) + (bitcast<f32>((((_e369 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e265));
                    let _e446 = abs(((bitcast<f32>(_e361) + (bitcast<f32>((((_e369 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e267));
                    let _e447 = abs(((bitcast<f32>(_e365) + (bitcast<f32>((((_e369 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e269));
                    if (_e439 > _e445) {
                        phi_1090_ = _e439;
                    } else {
                        phi_1090_ = _e445;
                    }
                    let _e450 = phi_1090_;
                    if (_e440 > _e446) {
                        phi_1095_ = _e440;
                    } else {
                        phi_1095_ = _e446;
                    }
                    let _e453 = phi_1095_;
                    if (_e441 > _e447) {
                        phi_1100_ = _e441;
                    } else {
                        phi_1100_ = _e447;
                    }
                    let _e456 = phi_1100_;
                    if (_e450 > _e453) {
                        phi_1105_ = _e450;
                    } else {
                        phi_1105_ = _e453;
                    }
                    let _e459 = phi_1105_;
                    if (_e459 > _e456) {
                        phi_1110_ = _e459;
                    } else {
                        phi_1110_ = _e456;
                    }
                    let _e462 = phi_1110_;
                    let _e466 = (_e462 * 0.0000019073486f);
                    let _e467 = (abs(_e415) * _e466);
                    let _e468 = (abs(_e425) * _e466);
                    let _e469 = (abs(_e435) * _e466);
                    let _e473 = (_e462 * 0.0000009536743f);
                    let _e474 = (abs(_e415) * _e473);
                    let _e475 = (abs(_e425) * _e473);
                    let _e476 = (abs(_e435) * _e473);
                    if (_e415 < 0f) {
                        phi_1129_ = 0u;
                    } else {
                        phi_1129_ = 1u;
                    }
                    let _e479 = phi_1129_;
                    if (_e425 < 0f) {
                        phi_1134_ = 0u;
                    } else {
                        phi_1134_ = 2u;
                    }
                    let _e482 = phi_1134_;
                    if (_e435 < 0f) {
                        phi_1139_ = 0u;
                    } else {
                        phi_1139_ = 4u;
                    }
                    let _e485 = phi_1139_;
                    let _e487 = ((_e479 | _e482) | _e485);
                    let _e488 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e248, 2147483648u);
                    local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e488.first[0], _e488.first[1], _e488.first[2], _e488.first[3], _e488.first[4], _e488.first[5], _e488.first[6], _e488.first[7], _e488.first[8], _e488.first[9], _e488.first[10], _e488.first[11], _e488.first[12], _e488.first[13], _e488.first[14], _e488.first[15], _e488.first[16], _e488.first[17], _e488.first[18], _e488.first[19], _e488.first[20], _e488.first[21], _e488.first[22], _e488.first[23], _e488.first[24], _e488.first[25], _e488.first[26], _e488.first[27], _e488.first[28], _e488.first[29], _e488.first[30], _e488.first[31]), array<u32, 32>(_e488.mask[0], _e488.mask[1], _e488.mask[2], _e488.mask[3], _e488.mask[4], _e488.mask[5], _e488.mask[6], _e488.mask[7], _e488.mask[8], _e488.mask[9], _e488.mask[10], _e488.mask[11], _e488.mask[12], _e488.mask[13], _e488.mask[14], _e488.mask[15], _e488.mask[16], _e488.mask[17], _e488.mask[18], _e488.mask[19], _e488.mask[20], _e488.mask[21], _e488.mask[22], _e488.mask[23], _e488.mask[24], _e488.mask[25], _e488.mask[26], _e488.mask[27], _e488.mask[28], _e488.mask[29], _e488.mask[30], _e488.mask[31]), _e488.len, _e488.group, _e488.group_mask);
                    let _e562 = local_2.group_mask;
                    if ((_e562 & 4278190080u) == 0u) {
                        let _e566 = local_2.len;
                        if (_e566 == 0u) {
                            phi_1253_ = false;
                        } else {
                            let _e570 = local_2.len;
                            local_2.len = (_e570 - 1u);
                            let _e573 = local_2.len;
                            if (_e573 < 32u) {
                            } else {
                                return;
                            }
                            let _e578 = local_2.first[(0u + _e573)];
                            local_2.group = _e578;
                            let _e581 = local_2.len;
                            if (_e581 < 32u) {
                            } else {
                                return;
                            }
                            let _e586 = local_2.mask[(0u + _e581)];
                            local_2.group_mask = _e586;
                            phi_1253_ = true;
                        }
                        let _e589 = phi_1253_;
                        phi_1254_ = _e589;
                    } else {
                        phi_1254_ = true;
                    }
                    let _e591 = phi_1254_;
                    if _e591 {
                        let _e593 = local_2.group_mask;
                        let _e599 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e593)), 32u, (_e593 == 0u)));
                        let _e603 = local_2.group_mask;
                        let _e617 = local_2.group_mask;
                        local_2.group_mask = (_e617 & ~((1u << bitcast<u32>((_e599 & 31u)))));
                        let _e620 = local_2.group;
                        phi_1285_ = (_e620 + countOneBits(((_e603 & ~((4294967295u << bitcast<u32>((((_e599 - 24u) ^ 7u) & 31u))))) & 255u)));
                    } else {
                        phi_1285_ = 4294967295u;
                    }
                    let _e623 = phi_1285_;
                    phi_1287_ = _e623;
                    phi_1290_ = false;
                    loop {
                        let _e625 = phi_1287_;
                        let _e627 = phi_1290_;
                        if (_e625 != 4294967295u) {
                            if (_e625 < _e79) {
                            } else {
                                return;
                            }
                            let _e634 = nodes.member[(0u + _e625)].frame[3u];
                            let _e659 = (bitcast<f32>((((_e634 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e415);
                            let _e660 = (bitcast<f32>((((_e634 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e425);
                            let _e661 = (bitcast<f32>((((_e634 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e435);
                            let _e664 = nodes.member[(0u + _e625)].frame[0u];
                            let _e668 = nodes.member[(0u + _e625)].frame[1u];
                            let _e672 = nodes.member[(0u + _e625)].frame[2u];
                            let _e677 = ((bitcast<f32>(_e664) - _e265) * _e415);
                            let _e678 = ((bitcast<f32>(_e668) - _e267) * _e425);
                            let _e679 = ((bitcast<f32>(_e672) - _e269) * _e435);
                            let _e687 = nodes.member[(0u + _e625)].x;
                            if (_e415 < 0f) {
                                let _e698 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e687.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e704 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e698.unnamed.root, _e687.w), _e698.unnamed_1);
                                let _e710 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e704.unnamed, lt_bvh_traverse_Tree(_e687.x, _e704.unnamed_1.first_primitive));
                                phi_1370_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e710.unnamed, lt_bvh_traverse_Tree(_e710.unnamed_1.root, _e687.y));
                            } else {
                                let _e726 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e687.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e732 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e726.unnamed.root, _e687.y), _e726.unnamed_1);
                                let _e738 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e732.unnamed, lt_bvh_traverse_Tree(_e687.z, _e732.unnamed_1.first_primitive));
                                phi_1370_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e738.unnamed, lt_bvh_traverse_Tree(_e738.unnamed_1.root, _e687.w));
                            }
                            let _e746 = phi_1370_;
                            let _e756 = nodes.member[(0u + _e625)].y;
                            if (_e425 < 0f) {
                                let _e767 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e756.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e773 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e767.unnamed.root, _e756.w), _e767.unnamed_1);
                                let _e779 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e773.unnamed, lt_bvh_traverse_Tree(_e756.x, _e773.unnamed_1.first_primitive));
                                phi_1397_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e779.unnamed, lt_bvh_traverse_Tree(_e779.unnamed_1.root, _e756.y));
                            } else {
                                let _e795 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e756.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e801 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e795.unnamed.root, _e756.y), _e795.unnamed_1);
                                let _e807 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e801.unnamed, lt_bvh_traverse_Tree(_e756.z, _e801.unnamed_1.first_primitive));
                                phi_1397_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e807.unnamed, lt_bvh_traverse_Tree(_e807.unnamed_1.root, _e756.w));
                            }
                            let _e815 = phi_1397_;
                            let _e825 = nodes.member[(0u + _e625)].z;
                            if (_e435 < 0f) {
                                let _e836 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e825.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e842 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e836.unnamed.root, _e825.w), _e836.unnamed_1);
                                let _e848 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e842.unnamed, lt_bvh_traverse_Tree(_e825.x, _e842.unnamed_1.first_primitive));
                                phi_1424_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e848.unnamed, lt_bvh_traverse_Tree(_e848.unnamed_1.root, _e825.y));
                            } else {
                                let _e864 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e825.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e870 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e864.unnamed.root, _e825.y), _e864.unnamed_1);
                                let _e876 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e870.unnamed, lt_bvh_traverse_Tree(_e825.z, _e870.unnamed_1.first_primitive));
                                phi_1424_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e876.unnamed, lt_bvh_traverse_Tree(_e876.unnamed_1.root, _e825.w));
                            }
                            let _e884 = phi_1424_;
                            phi_1430_ = 0u;
                            phi_1433_ = 0u;
                            loop {
                                let _e894 = phi_1430_;
                                let _e896 = phi_1433_;
                                local_4 = _e896;
                                local_5 = _e896;
                                local_6 = _e896;
                                let _e897 = (_e894 < 8u);
                                if _e897 {
                                    let _e899 = (_e894 >> bitcast<u32>(2i));
                                    let _e900 = (_e894 & 3u);
                                    if (_e899 == 0u) {
                                        phi_1447_ = _e746.unnamed.root;
                                    } else {
                                        phi_1447_ = _e746.unnamed.first_primitive;
                                    }
                                    let _e903 = phi_1447_;
                                    if (_e899 == 0u) {
                                        phi_1457_ = _e815.unnamed.root;
                                    } else {
                                        phi_1457_ = _e815.unnamed.first_primitive;
                                    }
                                    let _e912 = phi_1457_;
                                    if (_e899 == 0u) {
                                        phi_1467_ = _e884.unnamed.root;
                                    } else {
                                        phi_1467_ = _e884.unnamed.first_primitive;
                                    }
                                    let _e921 = phi_1467_;
                                    let _e934 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e903 >> bitcast<u32>(((_e900 * 8u) & 31u))) & 255u)) * _e659) + (_e677 - _e467)), ((f32(((_e912 >> bitcast<u32>(((_e900 * 8u) & 31u))) & 255u)) * _e660) + (_e678 - _e468)));
                                    let _e935 = core_intrinsics_maximum_number_nsz_f32_(_e934, ((f32(((_e921 >> bitcast<u32>(((_e900 * 8u) & 31u))) & 255u)) * _e661) + (_e679 - _e469)));
                                    if (_e899 == 0u) {
                                        phi_1485_ = _e746.unnamed_1.root;
                                    } else {
                                        phi_1485_ = _e746.unnamed_1.first_primitive;
                                    }
                                    let _e938 = phi_1485_;
                                    if (_e899 == 0u) {
                                        phi_1495_ = _e815.unnamed_1.root;
                                    } else {
                                        phi_1495_ = _e815.unnamed_1.first_primitive;
                                    }
                                    let _e947 = phi_1495_;
                                    if (_e899 == 0u) {
                                        phi_1505_ = _e884.unnamed_1.root;
                                    } else {
                                        phi_1505_ = _e884.unnamed_1.first_primitive;
                                    }
                                    let _e956 = phi_1505_;
                                    let _e969 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e938 >> bitcast<u32>(((_e900 * 8u) & 31u))) & 255u)) * _e659) + (_e677 + _e467)), ((f32(((_e947 >> bitcast<u32>(((_e900 * 8u) & 31u))) & 255u)) * _e660) + (_e678 + _e468)));
                                    let _e970 = core_intrinsics_minimum_number_nsz_f32_(_e969, ((f32(((_e956 >> bitcast<u32>(((_e900 * 8u) & 31u))) & 255u)) * _e661) + (_e679 + _e469)));
                                    if (_e935 <= _e970) {
                                        if (_e935 <= _e275) {
                                            if (_e970 >= 0f) {
                                                if (_e899 == 0u) {
                                                    let _e977 = nodes.member[(0u + _e625)].links[2u];
                                                    phi_1541_ = _e977;
                                                } else {
                                                    let _e980 = nodes.member[(0u + _e625)].links[3u];
                                                    phi_1541_ = _e980;
                                                }
                                                let _e982 = phi_1541_;
                                                let _e987 = ((_e982 >> bitcast<u32>(((_e900 * 8u) & 31u))) & 255u);
                                                let _e988 = (_e987 & 31u);
                                                if (_e988 >= 24u) {
                                                    phi_1554_ = (24u + ((_e988 - 24u) ^ _e487));
                                                } else {
                                                    phi_1554_ = _e988;
                                                }
                                                let _e994 = phi_1554_;
                                                phi_1559_ = (_e896 | ((_e987 >> bitcast<u32>(5i)) << bitcast<u32>((_e994 & 31u))));
                                            } else {
                                                phi_1559_ = _e896;
                                            }
                                            let _e1002 = phi_1559_;
                                            phi_1560_ = _e1002;
                                        } else {
                                            phi_1560_ = _e896;
                                        }
                                        let _e1004 = phi_1560_;
                                        phi_1561_ = _e1004;
                                    } else {
                                        phi_1561_ = _e896;
                                    }
                                    let _e1006 = phi_1561_;
                                    phi_1431_ = (_e894 + 1u);
                                    phi_1434_ = _e1006;
                                } else {
                                    phi_1431_ = u32();
                                    phi_1434_ = u32();
                                }
                                let _e1009 = phi_1431_;
                                let _e1011 = phi_1434_;
                                continue;
                                continuing {
                                    phi_1430_ = _e1009;
                                    phi_1433_ = _e1011;
                                    break if !(_e897);
                                }
                            }
                            let _e1015 = nodes.member[(0u + _e625)].links[0u];
                            let _e1019 = nodes.member[(0u + _e625)].frame[3u];
                            let _e1023 = local_4;
                            if ((_e1023 & 4278190080u) == 0u) {
                            } else {
                                let _e1027 = local_2.group_mask;
                                if ((_e1027 & 4278190080u) == 0u) {
                                } else {
                                    let _e1031 = local_2.len;
                                    if (_e1031 < 32u) {
                                        let _e1034 = local_2.group;
                                        let _e1036 = local_2.len;
                                        if (_e1036 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_2.first[(0u + _e1036)] = _e1034;
                                        let _e1042 = local_2.group_mask;
                                        let _e1044 = local_2.len;
                                        if (_e1044 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_2.mask[(0u + _e1044)] = _e1042;
                                        let _e1051 = local_2.len;
                                        local_2.len = (_e1051 + 1u);
                                    }
                                }
                                local_2.group = (_e248 + _e1015);
                                let _e1055 = local_5;
                                local_2.group_mask = ((_e1055 & 4278190080u) | (_e1019 >> bitcast<u32>(24i)));
                            }
                            let _e1060 = local_6;
                            phi_1619_ = (_e1060 & 16777215u);
                            phi_1622_ = _e627;
                            loop {
                                let _e1063 = phi_1619_;
                                let _e1065 = phi_1622_;
                                local_19 = _e1065;
                                let _e1066 = (_e1063 == 0u);
                                local_12 = _e1066;
                                local_20 = _e1066;
                                if _e1066 {
                                    phi_1620_ = u32();
                                    phi_1623_ = bool();
                                    phi_3481_ = false;
                                } else {
                                    let _e1069 = nodes.member[(0u + _e625)].links[1u];
                                    let _e1073 = (_e1069 + select(firstTrailingBit(_e1063), 32u, (_e1063 == 0u)));
                                    if (_e1073 < arrayLength((&instances.member))) {
                                    } else {
                                        return;
                                    }
                                    let _e1080 = instances.member[(0u + _e1073)].low_world;
                                    let _e1082 = instances.member[(0u + _e1073)].high_world;
                                    let _e1089 = ((_e1080.x - _e265) * _e415);
                                    let _e1090 = ((_e1080.y - _e267) * _e425);
                                    let _e1091 = ((_e1080.z - _e269) * _e435);
                                    let _e1098 = ((_e1082.x - _e265) * _e415);
                                    let _e1099 = ((_e1082.y - _e267) * _e425);
                                    let _e1100 = ((_e1082.z - _e269) * _e435);
                                    if (_e1089 < _e1098) {
                                        phi_1671_ = _e1089;
                                    } else {
                                        phi_1671_ = _e1098;
                                    }
                                    let _e1103 = phi_1671_;
                                    if (_e1090 < _e1099) {
                                        phi_1676_ = _e1090;
                                    } else {
                                        phi_1676_ = _e1099;
                                    }
                                    let _e1106 = phi_1676_;
                                    if (_e1091 < _e1100) {
                                        phi_1681_ = _e1091;
                                    } else {
                                        phi_1681_ = _e1100;
                                    }
                                    let _e1109 = phi_1681_;
                                    if (_e1089 > _e1098) {
                                        phi_1689_ = _e1089;
                                    } else {
                                        phi_1689_ = _e1098;
                                    }
                                    let _e1115 = phi_1689_;
                                    if (_e1090 > _e1099) {
                                        phi_1694_ = _e1090;
                                    } else {
                                        phi_1694_ = _e1099;
                                    }
                                    let _e1118 = phi_1694_;
                                    if (_e1091 > _e1100) {
                                        phi_1699_ = _e1091;
                                    } else {
                                        phi_1699_ = _e1100;
                                    }
                                    let _e1121 = phi_1699_;
                                    let _e1125 = core_intrinsics_maximum_number_nsz_f32_((_e1103 - _e474), (_e1106 - _e475));
                                    let _e1126 = core_intrinsics_maximum_number_nsz_f32_(_e1125, (_e1109 - _e476));
                                    let _e1127 = core_intrinsics_minimum_number_nsz_f32_((_e1115 + _e474), (_e1118 + _e475));
                                    let _e1128 = core_intrinsics_minimum_number_nsz_f32_(_e1127, (_e1121 + _e476));
                                    if (_e1126 <= _e1128) {
                                        if (_e1126 <= _e275) {
                                            if (_e1128 >= 0f) {
                                                let _e1134 = instances.member[(0u + _e1073)].world_to_object[0u];
                                                let _e1145 = ((((_e1134.x * _e265) + (_e1134.y * _e267)) + (_e1134.z * _e269)) + (_e1134.w * 1f));
                                                let _e1147 = instances.member[(0u + _e1073)].world_to_object[1u];
                                                let _e1158 = ((((_e1147.x * _e265) + (_e1147.y * _e267)) + (_e1147.z * _e269)) + (_e1147.w * 1f));
                                                let _e1160 = instances.member[(0u + _e1073)].world_to_object[2u];
                                                let _e1171 = ((((_e1160.x * _e265) + (_e1160.y * _e267)) + (_e1160.z * _e269)) + (_e1160.w * 1f));
                                                let _e1174 = instances.member[(0u + _e1073)].world_to_object[0u];
                                                let _e1185 = ((((_e1174.x * _e283) + (_e1174.y * _e284)) + (_e1174.z * _e285)) + (_e1174.w * 0f));
                                                let _e1187 = instances.member[(0u + _e1073)].world_to_object[1u];
                                                let _e1198 = ((((_e1187.x * _e283) + (_e1187.y * _e284)) + (_e1187.z * _e285)) + (_e1187.w * 0f));
                                                let _e1200 = instances.member[(0u + _e1073)].world_to_object[2u];
                                                let _e1211 = ((((_e1200.x * _e283) + (_e1200.y * _e284)) + (_e1200.z * _e285)) + (_e1200.w * 0f));
                                                let _e1214 = instances.member[(0u + _e1073)].root;
                                                let _e1216 = instances.member[(0u + _e1073)].first_triangle;
                                                let _e1217 = abs(_e1185);
                                                let _e1218 = abs(_e1198);
                                                let _e1219 = abs(_e1211);
                                                if (abs(_e1145) < 1000000000000000f) {
                                                    if (abs(_e1158) < 1000000000000000f) {
                                                        phi_1819_ = (abs(_e1171) < 1000000000000000f);
                                                        phi_1820_ = false;
                                                    } else {
                                                        phi_1819_ = bool();
                                                        phi_1820_ = true;
                                                    }
                                                    let _e1227 = phi_1819_;
                                                    let _e1229 = phi_1820_;
                                                    phi_1821_ = _e1227;
                                                    phi_1822_ = _e1229;
                                                } else {
                                                    phi_1821_ = bool();
                                                    phi_1822_ = true;
                                                }
                                                let _e1231 = phi_1821_;
                                                let _e1233 = phi_1822_;
                                                if _e1233 {
                                                    phi_1826_ = false;
                                                } else {
                                                    phi_1826_ = _e1231;
                                                }
                                                let _e1235 = phi_1826_;
                                                if _e1235 {
                                                    if (_e1217 < 1000000000000000f) {
                                                        if (_e1218 < 1000000000000000f) {
                                                            phi_1839_ = (_e1219 < 1000000000000000f);
                                                            phi_1840_ = false;
                                                        } else {
                                                            phi_1839_ = bool();
                                                            phi_1840_ = true;
                                                        }
                                                        let _e1240 = phi_1839_;
                                                        let _e1242 = phi_1840_;
                                                        phi_1841_ = _e1240;
                                                        phi_1842_ = _e1242;
                                                    } else {
                                                        phi_1841_ = bool();
                                                        phi_1842_ = true;
                                                    }
                                                    let _e1244 = phi_1841_;
                                                    let _e1246 = phi_1842_;
                                                    if _e1246 {
                                                        phi_1846_ = false;
                                                    } else {
                                                        phi_1846_ = _e1244;
                                                    }
                                                    let _e1248 = phi_1846_;
                                                    if _e1248 {
                                                        if (_e1217 > 0f) {
                                                            phi_1860_ = bool();
                                                            phi_1861_ = true;
                                                        } else {
                                                            let _e1250 = (_e1218 > 0f);
                                                            if _e1250 {
                                                                phi_1859_ = bool();
                                                            } else {
                                                                phi_1859_ = (_e1219 > 0f);
                                                            }
                                                            let _e1253 = phi_1859_;
                                                            phi_1860_ = _e1253;
                                                            phi_1861_ = _e1250;
                                                        }
                                                        let _e1255 = phi_1860_;
                                                        let _e1257 = phi_1861_;
                                                        if _e1257 {
                                                            phi_1865_ = true;
                                                        } else {
                                                            phi_1865_ = _e1255;
                                                        }
                                                        let _e1259 = phi_1865_;
                                                        phi_1866_ = _e1259;
                                                        phi_1867_ = false;
                                                    } else {
                                                        phi_1866_ = bool();
                                                        phi_1867_ = true;
                                                    }
                                                    let _e1261 = phi_1866_;
                                                    let _e1263 = phi_1867_;
                                                    phi_1868_ = _e1261;
                                                    phi_1869_ = _e1263;
                                                } else {
                                                    phi_1868_ = bool();
                                                    phi_1869_ = true;
                                                }
                                                let _e1265 = phi_1868_;
                                                let _e1267 = phi_1869_;
                                                if _e1267 {
                                                    phi_1873_ = false;
                                                } else {
                                                    phi_1873_ = _e1265;
                                                }
                                                let _e1269 = phi_1873_;
                                                if _e1269 {
                                                    let _e1270 = (_e1214 >= _e79);
                                                    if _e1270 {
                                                        phi_3461_ = bool();
                                                    } else {
                                                        if (_e1214 < _e79) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1276 = nodes.member[(0u + _e1214)].frame[0u];
                                                        let _e1280 = nodes.member[(0u + _e1214)].frame[1u];
                                                        let _e1284 = nodes.member[(0u + _e1214)].frame[2u];
                                                        let _e1288 = nodes.member[(0u + _e1214)].frame[0u];
                                                        let _e1292 = nodes.member[(0u + _e1214)].frame[1u];
                                                        let _e1296 = nodes.member[(0u + _e1214)].frame[2u];
                                                        let _e1300 = nodes.member[(0u + _e1214)].frame[3u];
                                                        let _e1334 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1185), abs(_e1198));
                                                        let _e1335 = core_intrinsics_maximum_number_nsz_f32_(_e1334, abs(_e1211));
                                                        let _e1336 = (_e1335 * 0.0000000000009094947f);
                                                        if (abs(_e1185) < _e1336) {
                                                            phi_1943_ = _e1336;
                                                        } else {
                                                            phi_1943_ = abs(_e1185);
                                                        }
                                                        let _e1341 = phi_1943_;
                                                        if (_e1185 < 0f) {
                                                            phi_1950_ = (-1f / _e1341);
                                                        } else {
                                                            phi_1950_ = (1f / _e1341);
                                                        }
                                                        let _e1346 = phi_1950_;
                                                        if (abs(_e1198) < _e1336) {
                                                            phi_1957_ = _e1336;
                                                        } else {
                                                            phi_1957_ = abs(_e1198);
                                                        }
                                                        let _e1351 = phi_1957_;
                                                        if (_e1198 < 0f) {
                                                            phi_1964_ = (-1f / _e1351);
                                                        } else {
                                                            phi_1964_ = (1f / _e1351);
                                                        }
                                                        let _e1356 = phi_1964_;
                                                        if (abs(_e1211) < _e1336) {
                                                            phi_1971_ = _e1336;
                                                        } else {
                                                            phi_1971_ = abs(_e1211);
                                                        }
                                                        let _e1361 = phi_1971_;
                                                        if (_e1211 < 0f) {
                                                            phi_1978_ = (-1f / _e1361);
                                                        } else {
                                                            phi_1978_ = (1f / _e1361);
                                                        }
                                                        let _e1366 = phi_1978_;
                                                        let _e1370 = abs((bitcast<f32>(_e1276) - _e1145));
                                                        let _e1371 = abs((bitcast<f32>(_e1280) - _e1158));
                                                        let _e1372 = abs((bitcast<f32>(_e1284) - _e1171));
                                                        let _e1376 = abs(((bitcast<f32>(_e1288) + (bitcast<f32>((((_e1300 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1145));
                                                        let _e1377 = abs(((bitcast<f32>(_e1292) + (bitcast<f32>((((_e1300 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1158));
                                                        let _e1378 = abs(((bitcast<f32>(_e1296) + (bitcast<f32>((((_e1300 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1171));
                                                        if (_e1370 > _e1376) {
                                                            phi_1995_ = _e1370;
                                                        } else {
                                                            phi_1995_ = _e1376;
                                                        }
                                                        let _e1381 = phi_1995_;
                                                        if (_e1371 > _e1377) {
                                                            phi_2000_ = _e1371;
                                                        } else {
                                                            phi_2000_ = _e1377;
                                                        }
                                                        let _e1384 = phi_2000_;
                                                        if (_e1372 > _e1378) {
                                                            phi_2005_ = _e1372;
                                                        } else {
                                                            phi_2005_ = _e1378;
                                                        }
                                                        let _e1387 = phi_2005_;
                                                        if (_e1381 > _e1384) {
                                                            phi_2010_ = _e1381;
                                                        } else {
                                                            phi_2010_ = _e1384;
                                                        }
                                                        let _e1390 = phi_2010_;
                                                        if (_e1390 > _e1387) {
                                                            phi_2015_ = _e1390;
                                                        } else {
                                                            phi_2015_ = _e1387;
                                                        }
                                                        let _e1393 = phi_2015_;
                                                        let _e1397 = (_e1393 * 0.0000019073486f);
                                                        let _e1398 = (abs(_e1346) * _e1397);
                                                        let _e1399 = (abs(_e1356) * _e1397);
                                                        let _e1400 = (abs(_e1366) * _e1397);
                                                        let _e1404 = (_e1393 * 0.0000009536743f);
                                                        let _e1405 = (abs(_e1346) * _e1404);
                                                        let _e1406 = (abs(_e1356) * _e1404);
                                                        let _e1407 = (abs(_e1366) * _e1404);
                                                        let _e1408 = abs(_e1185);
                                                        let _e1409 = abs(_e1198);
                                                        let _e1410 = abs(_e1211);
                                                        if (_e1408 >= _e1409) {
                                                            if (_e1408 >= _e1410) {
                                                                phi_2041_ = false;
                                                            } else {
                                                                phi_2041_ = true;
                                                            }
                                                            let _e1414 = phi_2041_;
                                                            phi_2042_ = _e1414;
                                                        } else {
                                                            phi_2042_ = true;
                                                        }
                                                        let _e1416 = phi_2042_;
                                                        if _e1416 {
                                                            if (_e1409 >= _e1410) {
                                                                phi_2050_ = 1u;
                                                            } else {
                                                                phi_2050_ = 2u;
                                                            }
                                                            let _e1419 = phi_2050_;
                                                            phi_2051_ = _e1419;
                                                        } else {
                                                            phi_2051_ = 0u;
                                                        }
                                                        let _e1421 = phi_2051_;
                                                        if (_e1421 == 0u) {
                                                            phi_2063_ = vec3<f32>(_e1198, _e1211, _e1185);
                                                        } else {
                                                            if (_e1421 == 1u) {
                                                                phi_2062_ = vec3<f32>(_e1211, _e1185, _e1198);
                                                            } else {
                                                                phi_2062_ = vec3<f32>(_e1185, _e1198, _e1211);
                                                            }
                                                            let _e1427 = phi_2062_;
                                                            phi_2063_ = _e1427;
                                                        }
                                                        let _e1429 = phi_2063_;
                                                        let _e1432 = (_e1429.x / _e1429.z);
                                                        let _e1435 = (_e1429.y / _e1429.z);
                                                        if (_e1346 < 0f) {
                                                            phi_2076_ = 0u;
                                                        } else {
                                                            phi_2076_ = 1u;
                                                        }
                                                        let _e1440 = phi_2076_;
                                                        if (_e1356 < 0f) {
                                                            phi_2081_ = 0u;
                                                        } else {
                                                            phi_2081_ = 2u;
                                                        }
                                                        let _e1443 = phi_2081_;
                                                        if (_e1366 < 0f) {
                                                            phi_2086_ = 0u;
                                                        } else {
                                                            phi_2086_ = 4u;
                                                        }
                                                        let _e1446 = phi_2086_;
                                                        let _e1448 = ((_e1440 | _e1443) | _e1446);
                                                        let _e1449 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1214, 2147483648u);
                                                        local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1449.first[0], _e1449.first[1], _e1449.first[2], _e1449.first[3], _e1449.first[4], _e1449.first[5], _e1449.first[6], _e1449.first[7], _e1449.first[8], _e1449.first[9], _e1449.first[10], _e1449.first[11], _e1449.first[12], _e1449.first[13], _e1449.first[14], _e1449.first[15], _e1449.first[16], _e1449.first[17], _e1449.first[18], _e1449.first[19], _e1449.first[20], _e1449.first[21], _e1449.first[22], _e1449.first[23], _e1449.first[24], _e1449.first[25], _e1449.first[26], _e1449.first[27], _e1449.first[28], _e1449.first[29], _e1449.first[30], _e1449.first[31]), array<u32, 32>(_e1449.mask[0], _e1449.mask[1], _e1449.mask[2], _e1449.mask[3], _e1449.mask[4], _e1449.mask[5], _e1449.mask[6], _e1449.mask[7], _e1449.mask[8], _e1449.mask[9], _e1449.mask[10], _e1449.mask[11], _e1449.mask[12], _e1449.mask[13], _e1449.mask[14], _e1449.mask[15], _e1449.mask[16], _e1449.mask[17], _e1449.mask[18], _e1449.mask[19], _e1449.mask[20], _e1449.mask[21], _e1449.mask[22], _e1449.mask[23], _e1449.mask[24], _e1449.mask[25], _e1449.mask[26], _e1449.mask[27], _e1449.mask[28], _e1449.mask[29], _e1449.mask[30], _e1449.mask[31]), _e1449.len, _e1449.group, _e1449.group_mask);
                                                        let _e1523 = local_1.group_mask;
                                                        if ((_e1523 & 4278190080u) == 0u) {
                                                            let _e1527 = local_1.len;
                                                            if (_e1527 == 0u) {
                                                                phi_2200_ = false;
                                                            } else {
                                                                let _e1531 = local_1.len;
                                                                local_1.len = (_e1531 - 1u);
                                                                let _e1534 = local_1.len;
                                                                if (_e1534 < 32u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1539 = local_1.first[(0u + _e1534)];
                                                                local_1.group = _e1539;
                                                                let _e1542 = local_1.len;
                                                                if (_e1542 < 32u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1547 = local_1.mask[(0u + _e1542)];
                                                                local_1.group_mask = _e1547;
                                                                phi_2200_ = true;
                                                            }
                                                            let _e1550 = phi_2200_;
                                                            phi_2201_ = _e1550;
                                                        } else {
                                                            phi_2201_ = true;
                                                        }
                                                        let _e1552 = phi_2201_;
                                                        if _e1552 {
                                                            let _e1554 = local_1.group_mask;
                                                            let _e1560 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1554)), 32u, (_e1554 == 0u)));
                                                            let _e1564 = local_1.group_mask;
                                                            let _e1578 = local_1.group_mask;
                                                            local_1.group_mask = (_e1578 & ~((1u << bitcast<u32>((_e1560 & 31u)))));
                                                            let _e1581 = local_1.group;
                                                            phi_2232_ = (_e1581 + countOneBits(((_e1564 & ~((4294967295u << bitcast<u32>((((_e1560 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                        } else {
                                                            phi_2232_ = 4294967295u;
                                                        }
                                                        let _e1584 = phi_2232_;
                                                        phi_2234_ = _e1584;
                                                        phi_2237_ = _e1065;
                                                        loop {
                                                            let _e1586 = phi_2234_;
                                                            let _e1588 = phi_2237_;
                                                            local_18 = _e1588;
                                                            if (_e1586 != 4294967295u) {
                                                                if (_e1586 < _e79) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1595 = nodes.member[(0u + _e1586)].frame[3u];
                                                                let _e1620 = (bitcast<f32>((((_e1595 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1346);
                                                                let _e1621 = (bitcast<f32>((((_e1595 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1356);
                                                                let _e1622 = (bitcast<f32>((((_e1595 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1366);
                                                                let _e1625 = nodes.member[(0u + _e1586)].frame[0u];
                                                                let _e1629 = nodes.member[(0u + _e1586)].frame[1u];
                                                                let _e1633 = nodes.member[(0u + _e1586)].frame[2u];
                                                                let _e1638 = ((bitcast<f32>(_e1625) - _e1145) * _e1346);
                                                                let _e1639 = ((bitcast<f32>(_e1629) - _e1158) * _e1356);
                                                                let _e1640 = ((bitcast<f32>(_e1633) - _e1171) * _e1366);
                                                                let _e1648 = nodes.member[(0u + _e1586)].x;
                                                                if (_e1346 < 0f) {
                                                                    let _e1659 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1648.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1665 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1659.unnamed.root, _e1648.w), _e1659.unnamed_1);
                                                                    let _e1671 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1665.unnamed, lt_bvh_traverse_Tree(_e1648.x, _e1665.unnamed_1.first_primitive));
                                                                    phi_2317_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1671.unnamed, lt_bvh_traverse_Tree(_e1671.unnamed_1.root, _e1648.y));
                                                                } else {
                                                                    let _e1687 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1648.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1693 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1687.unnamed.root, _e1648.y), _e1687.unnamed_1);
                                                                    let _e1699 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1693.unnamed, lt_bvh_traverse_Tree(_e1648.z, _e1693.unnamed_1.first_primitive));
                                                                    phi_2317_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1699.unnamed, lt_bvh_traverse_Tree(_e1699.unnamed_1.root, _e1648.w));
                                                                }
                                                                let _e1707 = phi_2317_;
                                                                let _e1717 = nodes.member[(0u + _e1586)].y;
                                                                if (_e1356 < 0f) {
                                                                    let _e1728 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1717.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1734 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1728.unnamed.root, _e1717.w), _e1728.unnamed_1);
                                                                    let _e1740 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1734.unnamed, lt_bvh_traverse_Tree(_e1717.x, _e1734.unnamed_1.first_primitive));
                                                                    phi_2344_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1740.unnamed, lt_bvh_traverse_Tree(_e1740.unnamed_1.root, _e1717.y));
                                                                } else {
                                                                    let _e1756 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1717.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1762 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1756.unnamed.root, _e1717.y), _e1756.unnamed_1);
                                                                    let _e1768 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1762.unnamed, lt_bvh_traverse_Tree(_e1717.z, _e1762.unnamed_1.first_primitive));
                                                                    phi_2344_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1768.unnamed, lt_bvh_traverse_Tree(_e1768.unnamed_1.root, _e1717.w));
                                                                }
                                                                let _e1776 = phi_2344_;
                                                                let _e1786 = nodes.member[(0u + _e1586)].z;
                                                                if (_e1366 < 0f) {
                                                                    let _e1797 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1786.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1803 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1797.unnamed.root, _e1786.w), _e1797.unnamed_1);
                                                                    let _e1809 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1803.unnamed, lt_bvh_traverse_Tree(_e1786.x, _e1803.unnamed_1.first_primitive));
                                                                    phi_2371_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1809.unnamed, lt_bvh_traverse_Tree(_e1809.unnamed_1.root, _e1786.y));
                                                                } else {
                                                                    let _e1825 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1786.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1831 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1825.unnamed.root, _e1786.y), _e1825.unnamed_1);
                                                                    let _e1837 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1831.unnamed, lt_bvh_traverse_Tree(_e1786.z, _e1831.unnamed_1.first_primitive));
                                                                    phi_2371_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1837.unnamed, lt_bvh_traverse_Tree(_e1837.unnamed_1.root, _e1786.w));
                                                                }
                                                                let _e1845 = phi_2371_;
                                                                phi_2377_ = 0u;
                                                                phi_2380_ = 0u;
                                                                loop {
                                                                    let _e1855 = phi_2377_;
                                                                    let _e1857 = phi_2380_;
                                                                    local_7 = _e1857;
                                                                    local_8 = _e1857;
                                                                    local_9 = _e1857;
                                                                    let _e1858 = (_e1855 < 8u);
                                                                    if _e1858 {
                                                                        let _e1860 = (_e1855 >> bitcast<u32>(2i));
                                                                        let _e1861 = (_e1855 & 3u);
                                                                        if (_e1860 == 0u) {
                                                                            phi_2394_ = _e1707.unnamed.root;
                                                                        } else {
                                                                            phi_2394_ = _e1707.unnamed.first_primitive;
                                                                        }
                                                                        let _e1864 = phi_2394_;
                                                                        if (_e1860 == 0u) {
                                                                            phi_2404_ = _e1776.unnamed.root;
                                                                        } else {
                                                                            phi_2404_ = _e1776.unnamed.first_primitive;
                                                                        }
                                                                        let _e1873 = phi_2404_;
                                                                        if (_e1860 == 0u) {
                                                                            phi_2414_ = _e1845.unnamed.root;
                                                                        } else {
                                                                            phi_2414_ = _e1845.unnamed.first_primitive;
                                                                        }
                                                                        let _e1882 = phi_2414_;
                                                                        let _e1895 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1864 >> bitcast<u32>(((_e1861 * 8u) & 31u))) & 255u)) * _e1620) + (_e1638 - _e1398)), ((f32(((_e1873 >> bitcast<u32>(((_e1861 * 8u) & 31u))) & 255u)) * _e1621) + (_e1639 - _e1399)));
                                                                        let _e1896 = core_intrinsics_maximum_number_nsz_f32_(_e1895, ((f32(((_e1882 >> bitcast<u32>(((_e1861 * 8u) & 31u))) & 255u)) * _e1622) + (_e1640 - _e1400)));
                                                                        if (_e1860 == 0u) {
                                                                            phi_2432_ = _e1707.unnamed_1.root;
                                                                        } else {
                                                                            phi_2432_ = _e1707.unnamed_1.first_primitive;
                                                                        }
                                                                        let _e1899 = phi_2432_;
                                                                        if (_e1860 == 0u) {
                                                                            phi_2442_ = _e1776.unnamed_1.root;
                                                                        } else {
                                                                            phi_2442_ = _e1776.unnamed_1.first_primitive;
                                                                        }
                                                                        let _e1908 = phi_2442_;
                                                                        if (_e1860 == 0u) {
                                                                            phi_2452_ = _e1845.unnamed_1.root;
                                                                        } else {
                                                                            phi_2452_ = _e1845.unnamed_1.first_primitive;
                                                                        }
                                                                        let _e1917 = phi_2452_;
                                                                        let _e1930 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1899 >> bitcast<u32>(((_e1861 * 8u) & 31u))) & 255u)) * _e1620) + (_e1638 + _e1398)), ((f32(((_e1908 >> bitcast<u32>(((_e1861 * 8u) & 31u))) & 255u)) * _e1621) + (_e1639 + _e1399)));
                                                                        let _e1931 = core_intrinsics_minimum_number_nsz_f32_(_e1930, ((f32(((_e1917 >> bitcast<u32>(((_e1861 * 8u) & 31u))) & 255u)) * _e1622) + (_e1640 + _e1400)));
                                                                        if (_e1896 <= _e1931) {
                                                                            if (_e1896 <= _e275) {
                                                                                if (_e1931 >= 0f) {
                                                                                    if (_e1860 == 0u) {
                                                                                        let _e1938 = nodes.member[(0u + _e1586)].links[2u];
                                                                                        phi_2488_ = _e1938;
                                                                                    } else {
                                                                                        let _e1941 = nodes.member[(0u + _e1586)].links[3u];
                                                                                        phi_2488_ = _e1941;
                                                                                    }
                                                                                    let _e1943 = phi_2488_;
                                                                                    let _e1948 = ((_e1943 >> bitcast<u32>(((_e1861 * 8u) & 31u))) & 255u);
                                                                                    let _e1949 = (_e1948 & 31u);
                                                                                    if (_e1949 >= 24u) {
                                                                                        phi_2501_ = (24u + ((_e1949 - 24u) ^ _e1448));
                                                                                    } else {
                                                                                        phi_2501_ = _e1949;
                                                                                    }
                                                                                    let _e1955 = phi_2501_;
                                                                                    phi_2506_ = (_e1857 | ((_e1948 >> bitcast<u32>(5i)) << bitcast<u32>((_e1955 & 31u))));
                                                                                } else {
                                                                                    phi_2506_ = _e1857;
                                                                                }
                                                                                let _e1963 = phi_2506_;
                                                                                phi_2507_ = _e1963;
                                                                            } else {
                                                                                phi_2507_ = _e1857;
                                                                            }
                                                                            let _e1965 = phi_2507_;
                                                                            phi_2508_ = _e1965;
                                                                        } else {
                                                                            phi_2508_ = _e1857;
                                                                        }
                                                                        let _e1967 = phi_2508_;
                                                                        phi_2378_ = (_e1855 + 1u);
                                                                        phi_2381_ = _e1967;
                                                                    } else {
                                                                        phi_2378_ = u32();
                                                                        phi_2381_ = u32();
                                                                    }
                                                                    let _e1970 = phi_2378_;
                                                                    let _e1972 = phi_2381_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_2377_ = _e1970;
                                                                        phi_2380_ = _e1972;
                                                                        break if !(_e1858);
                                                                    }
                                                                }
                                                                let _e1976 = nodes.member[(0u + _e1586)].links[0u];
                                                                let _e1980 = nodes.member[(0u + _e1586)].frame[3u];
                                                                let _e1984 = local_7;
                                                                if ((_e1984 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1988 = local_1.group_mask;
                                                                    if ((_e1988 & 4278190080u) == 0u) {
                                                                    } else {
                                                                        let _e1992 = local_1.len;
                                                                        if (_e1992 < 32u) {
                                                                            let _e1995 = local_1.group;
                                                                            let _e1997 = local_1.len;
                                                                            if (_e1997 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            local_1.first[(0u + _e1997)] = _e1995;
                                                                            let _e2003 = local_1.group_mask;
                                                                            let _e2005 = local_1.len;
                                                                            if (_e2005 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            local_1.mask[(0u + _e2005)] = _e2003;
                                                                            let _e2012 = local_1.len;
                                                                            local_1.len = (_e2012 + 1u);
                                                                        }
                                                                    }
                                                                    local_1.group = (_e1214 + _e1976);
                                                                    let _e2016 = local_8;
                                                                    local_1.group_mask = ((_e2016 & 4278190080u) | (_e1980 >> bitcast<u32>(24i)));
                                                                }
                                                                let _e2021 = local_9;
                                                                phi_2566_ = (_e2021 & 16777215u);
                                                                phi_2569_ = _e1588;
                                                                loop {
                                                                    let _e2024 = phi_2566_;
                                                                    let _e2026 = phi_2569_;
                                                                    local_14 = _e2026;
                                                                    let _e2027 = (_e2024 == 0u);
                                                                    local_10 = _e2027;
                                                                    local_16 = _e2027;
                                                                    if _e2027 {
                                                                        phi_2567_ = u32();
                                                                        phi_2570_ = bool();
                                                                        phi_3373_ = bool();
                                                                        phi_3374_ = false;
                                                                    } else {
                                                                        let _e2030 = nodes.member[(0u + _e1586)].links[1u];
                                                                        let _e2035 = ((_e1216 + _e2030) + select(firstTrailingBit(_e2024), 32u, (_e2024 == 0u)));
                                                                        if (_e2035 < _e82) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2042 = triangles.member[(0u + _e2035)].v0_;
                                                                        let _e2044 = (_e2042.x - _e1145);
                                                                        let _e2046 = (_e2042.y - _e1158);
                                                                        let _e2048 = (_e2042.z - _e1171);
                                                                        if (_e1421 == 0u) {
                                                                            phi_2614_ = vec3<f32>(_e2046, _e2048, _e2044);
                                                                        } else {
                                                                            if (_e1421 == 1u) {
                                                                                phi_2613_ = vec3<f32>(_e2048, _e2044, _e2046);
                                                                            } else {
                                                                                phi_2613_ = (_e2042 - vec3<f32>(_e1145, _e1158, _e1171));
                                                                            }
                                                                            let _e2056 = phi_2613_;
                                                                            phi_2614_ = _e2056;
                                                                        }
                                                                        let _e2058 = phi_2614_;
                                                                        let _e2062 = (_e2058.x - (_e1432 * _e2058.z));
                                                                        let _e2066 = (_e2058.y - (_e1435 * _e2058.z));
                                                                        let _e2068 = triangles.member[(0u + _e2035)].v1_;
                                                                        let _e2070 = (_e2068.x - _e1145);
                                                                        let _e2072 = (_e2068.y - _e1158);
                                                                        let _e2074 = (_e2068.z - _e1171);
                                                                        if (_e1421 == 0u) {
                                                                            phi_2644_ = vec3<f32>(_e2072, _e2074, _e2070);
                                                                        } else {
                                                                            if (_e1421 == 1u) {
                                                                                phi_2643_ = vec3<f32>(_e2074, _e2070, _e2072);
                                                                            } else {
                                                                                phi_2643_ = (_e2068 - vec3<f32>(_e1145, _e1158, _e1171));
                                                                            }
                                                                            let _e2082 = phi_2643_;
                                                                            phi_2644_ = _e2082;
                                                                        }
                                                                        let _e2084 = phi_2644_;
                                                                        let _e2088 = (_e2084.x - (_e1432 * _e2084.z));
                                                                        let _e2092 = (_e2084.y - (_e1435 * _e2084.z));
                                                                        let _e2094 = triangles.member[(0u + _e2035)].v2_;
                                                                        let _e2096 = (_e2094.x - _e1145);
                                                                        let _e2098 = (_e2094.y - _e1158);
                                                                        let _e2100 = (_e2094.z - _e1171);
                                                                        if (_e1421 == 0u) {
                                                                            phi_2674_ = vec3<f32>(_e2098, _e2100, _e2096);
                                                                        } else {
                                                                            if (_e1421 == 1u) {
                                                                                phi_2673_ = vec3<f32>(_e2100, _e2096, _e2098);
                                                                            } else {
                                                                                phi_2673_ = (_e2094 - vec3<f32>(_e1145, _e1158, _e1171));
                                                                            }
                                                                            let _e2108 = phi_2673_;
                                                                            phi_2674_ = _e2108;
                                                                        }
                                                                        let _e2110 = phi_2674_;
                                                                        let _e2114 = (_e2110.x - (_e1432 * _e2110.z));
                                                                        let _e2118 = (_e2110.y - (_e1435 * _e2110.z));
                                                                        if (_e2088 < _e2114) {
                                                                            phi_2693_ = true;
                                                                        } else {
                                                                            if (_e2088 == _e2114) {
                                                                                phi_2692_ = (_e2092 < _e2118);
                                                                            } else {
                                                                                phi_2692_ = false;
                                                                            }
                                                                            let _e2123 = phi_2692_;
                                                                            phi_2693_ = _e2123;
                                                                        }
                                                                        let _e2125 = phi_2693_;
                                                                        if _e2125 {
                                                                            phi_2697_ = _e2118;
                                                                            phi_2698_ = _e2114;
                                                                            phi_2699_ = _e2092;
                                                                            phi_2700_ = _e2088;
                                                                        } else {
                                                                            phi_2697_ = _e2092;
                                                                            phi_2698_ = _e2088;
                                                                            phi_2699_ = _e2118;
                                                                            phi_2700_ = _e2114;
                                                                        }
                                                                        let _e2127 = phi_2697_;
                                                                        let _e2129 = phi_2698_;
                                                                        let _e2131 = phi_2699_;
                                                                        let _e2133 = phi_2700_;
                                                                        let _e2136 = ((_e2133 * _e2127) - (_e2131 * _e2129));
                                                                        if _e2125 {
                                                                            phi_2708_ = -(_e2136);
                                                                        } else {
                                                                            phi_2708_ = _e2136;
                                                                        }
                                                                        let _e2139 = phi_2708_;
                                                                        if (_e2114 < _e2062) {
                                                                            phi_2719_ = true;
                                                                        } else {
                                                                            if (_e2114 == _e2062) {
                                                                                phi_2718_ = (_e2118 < _e2066);
                                                                            } else {
                                                                                phi_2718_ = false;
                                                                            }
                                                                            let _e2144 = phi_2718_;
                                                                            phi_2719_ = _e2144;
                                                                        }
                                                                        let _e2146 = phi_2719_;
                                                                        if _e2146 {
                                                                            phi_2723_ = _e2066;
                                                                            phi_2724_ = _e2062;
                                                                            phi_2725_ = _e2118;
                                                                            phi_2726_ = _e2114;
                                                                        } else {
                                                                            phi_2723_ = _e2118;
                                                                            phi_2724_ = _e2114;
                                                                            phi_2725_ = _e2066;
                                                                            phi_2726_ = _e2062;
                                                                        }
                                                                        let _e2148 = phi_2723_;
                                                                        let _e2150 = phi_2724_;
                                                                        let _e2152 = phi_2725_;
                                                                        let _e2154 = phi_2726_;
                                                                        let _e2157 = ((_e2154 * _e2148) - (_e2152 * _e2150));
                                                                        if _e2146 {
                                                                            phi_2734_ = -(_e2157);
                                                                        } else {
                                                                            phi_2734_ = _e2157;
                                                                        }
                                                                        let _e2160 = phi_2734_;
                                                                        if (_e2062 < _e2088) {
                                                                            phi_2745_ = true;
                                                                        } else {
                                                                            if (_e2062 == _e2088) {
                                                                                phi_2744_ = (_e2066 < _e2092);
                                                                            } else {
                                                                                phi_2744_ = false;
                                                                            }
                                                                            let _e2165 = phi_2744_;
                                                                            phi_2745_ = _e2165;
                                                                        }
                                                                        let _e2167 = phi_2745_;
                                                                        if _e2167 {
                                                                            phi_2749_ = _e2092;
                                                                            phi_2750_ = _e2088;
                                                                            phi_2751_ = _e2066;
                                                                            phi_2752_ = _e2062;
                                                                        } else {
                                                                            phi_2749_ = _e2066;
                                                                            phi_2750_ = _e2062;
                                                                            phi_2751_ = _e2092;
                                                                            phi_2752_ = _e2088;
                                                                        }
                                                                        let _e2169 = phi_2749_;
                                                                        let _e2171 = phi_2750_;
                                                                        let _e2173 = phi_2751_;
                                                                        let _e2175 = phi_2752_;
                                                                        let _e2178 = ((_e2175 * _e2169) - (_e2173 * _e2171));
                                                                        if _e2167 {
                                                                            phi_2760_ = -(_e2178);
                                                                        } else {
                                                                            phi_2760_ = _e2178;
                                                                        }
                                                                        let _e2181 = phi_2760_;
                                                                        if (_e2139 >= 0f) {
                                                                            if (_e2160 >= 0f) {
                                                                                if (_e2181 >= 0f) {
                                                                                    phi_2775_ = ((_e2139 + _e2160) + _e2181);
                                                                                    phi_2776_ = false;
                                                                                } else {
                                                                                    phi_2775_ = f32();
                                                                                    phi_2776_ = true;
                                                                                }
                                                                                let _e2188 = phi_2775_;
                                                                                let _e2190 = phi_2776_;
                                                                                phi_2777_ = _e2188;
                                                                                phi_2778_ = _e2190;
                                                                            } else {
                                                                                phi_2777_ = f32();
                                                                                phi_2778_ = true;
                                                                            }
                                                                            let _e2192 = phi_2777_;
                                                                            let _e2194 = phi_2778_;
                                                                            phi_2779_ = _e2192;
                                                                            phi_2780_ = _e2194;
                                                                        } else {
                                                                            phi_2779_ = f32();
                                                                            phi_2780_ = true;
                                                                        }
                                                                        let _e2196 = phi_2779_;
                                                                        let _e2198 = phi_2780_;
                                                                        if _e2198 {
                                                                            if (_e2139 <= 0f) {
                                                                                if (_e2160 <= 0f) {
                                                                                    let _e2201 = (_e2181 <= 0f);
                                                                                    if _e2201 {
                                                                                    }
                                                                                    phi_2798_ = ((_e2139 + _e2160) + _e2181);
                                                                                    phi_2799_ = false;
                                                                                    phi_2800_ = _e2201;
                                                                                } else {
                                                                                    phi_2798_ = f32();
                                                                                    phi_2799_ = true;
                                                                                    phi_2800_ = false;
                                                                                }
                                                                                let _e2205 = phi_2798_;
                                                                                let _e2207 = phi_2799_;
                                                                                let _e2209 = phi_2800_;
                                                                                phi_2801_ = _e2205;
                                                                                phi_2802_ = _e2207;
                                                                                phi_2803_ = _e2209;
                                                                            } else {
                                                                                phi_2801_ = f32();
                                                                                phi_2802_ = true;
                                                                                phi_2803_ = false;
                                                                            }
                                                                            let _e2211 = phi_2801_;
                                                                            let _e2213 = phi_2802_;
                                                                            let _e2215 = phi_2803_;
                                                                            if _e2213 {
                                                                                phi_2807_ = false;
                                                                            } else {
                                                                                phi_2807_ = _e2215;
                                                                            }
                                                                            let _e2217 = phi_2807_;
                                                                            phi_2808_ = _e2211;
                                                                            phi_2809_ = _e2217;
                                                                        } else {
                                                                            phi_2808_ = _e2196;
                                                                            phi_2809_ = true;
                                                                        }
                                                                        let _e2219 = phi_2808_;
                                                                        let _e2221 = phi_2809_;
                                                                        if _e2221 {
                                                                            let _e2222 = (_e2219 == 0f);
                                                                            if _e2222 {
                                                                                phi_3125_ = lt_bvh_triangle_Intersection();
                                                                                phi_3126_ = false;
                                                                            } else {
                                                                                let _e2224 = triangles.member[(0u + _e2035)].v0_;
                                                                                let _e2226 = (_e2224.x - _e1145);
                                                                                let _e2228 = (_e2224.y - _e1158);
                                                                                let _e2230 = (_e2224.z - _e1171);
                                                                                if (_e1421 == 0u) {
                                                                                    phi_2838_ = vec3<f32>(_e2228, _e2230, _e2226);
                                                                                } else {
                                                                                    if (_e1421 == 1u) {
                                                                                        phi_2837_ = vec3<f32>(_e2230, _e2226, _e2228);
                                                                                    } else {
                                                                                        phi_2837_ = (_e2224 - vec3<f32>(_e1145, _e1158, _e1171));
                                                                                    }
                                                                                    let _e2238 = phi_2837_;
                                                                                    phi_2838_ = _e2238;
                                                                                }
                                                                                let _e2240 = phi_2838_;
                                                                                let _e2242 = triangles.member[(0u + _e2035)].v1_;
                                                                                let _e2244 = triangles.member[(0u + _e2035)].v0_;
                                                                                let _e2247 = (_e2242.x - _e2244.x);
                                                                                let _e2250 = (_e2242.y - _e2244.y);
                                                                                let _e2253 = (_e2242.z - _e2244.z);
                                                                                if (_e1421 == 0u) {
                                                                                    phi_2864_ = vec3<f32>(_e2250, _e2253, _e2247);
                                                                                } else {
                                                                                    if (_e1421 == 1u) {
                                                                                        phi_2863_ = vec3<f32>(_e2253, _e2247, _e2250);
                                                                                    } else {
                                                                                        phi_2863_ = (_e2242 - _e2244);
                                                                                    }
                                                                                    let _e2260 = phi_2863_;
                                                                                    phi_2864_ = _e2260;
                                                                                }
                                                                                let _e2262 = phi_2864_;
                                                                                let _e2264 = triangles.member[(0u + _e2035)].v2_;
                                                                                let _e2266 = triangles.member[(0u + _e2035)].v0_;
                                                                                let _e2269 = (_e2264.x - _e2266.x);
                                                                                let _e2272 = (_e2264.y - _e2266.y);
                                                                                let _e2275 = (_e2264.z - _e2266.z);
                                                                                if (_e1421 == 0u) {
                                                                                    phi_2890_ = vec3<f32>(_e2272, _e2275, _e2269);
                                                                                } else {
                                                                                    if (_e1421 == 1u) {
                                                                                        phi_2889_ = vec3<f32>(_e2275, _e2269, _e2272);
                                                                                    } else {
                                                                                        phi_2889_ = (_e2264 - _e2266);
                                                                                    }
                                                                                    let _e2282 = phi_2889_;
                                                                                    phi_2890_ = _e2282;
                                                                                }
                                                                                let _e2284 = phi_2890_;
                                                                                let _e2291 = ((_e2262.y * _e2284.z) - (_e2262.z * _e2284.y));
                                                                                let _e2298 = ((_e2262.z * _e2284.x) - (_e2262.x * _e2284.z));
                                                                                let _e2305 = ((_e2262.x * _e2284.y) - (_e2262.y * _e2284.x));
                                                                                let _e2319 = (((1f / _e1429.z) * (((_e2291 * _e2240.x) + (_e2298 * _e2240.y)) + (_e2305 * _e2240.z))) / (((_e2291 * _e1432) + (_e2298 * _e1435)) + _e2305));
                                                                                if (_e2319 > 0f) {
                                                                                    if (_e2319 < _e275) {
                                                                                        let _e2323 = triangles.member[(0u + _e2035)].v0_;
                                                                                        let _e2325 = triangles.member[(0u + _e2035)].v1_;
                                                                                        if (_e2323.x < _e2325.x) {
                                                                                            phi_2946_ = _e2323.x;
                                                                                        } else {
                                                                                            phi_2946_ = _e2325.x;
                                                                                        }
                                                                                        let _e2332 = phi_2946_;
                                                                                        if (_e2323.y < _e2325.y) {
                                                                                            phi_2955_ = _e2323.y;
                                                                                        } else {
                                                                                            phi_2955_ = _e2325.y;
                                                                                        }
                                                                                        let _e2339 = phi_2955_;
                                                                                        if (_e2323.z < _e2325.z) {
                                                                                            phi_2964_ = _e2323.z;
                                                                                        } else {
                                                                                            phi_2964_ = _e2325.z;
                                                                                        }
                                                                                        let _e2346 = phi_2964_;
                                                                                        let _e2348 = triangles.member[(0u + _e2035)].v2_;
                                                                                        if (_e2332 < _e2348.x) {
                                                                                            phi_2973_ = _e2332;
                                                                                        } else {
                                                                                            phi_2973_ = _e2348.x;
                                                                                        }
                                                                                        let _e2353 = phi_2973_;
                                                                                        if (_e2339 < _e2348.y) {
                                                                                            phi_2980_ = _e2339;
                                                                                        } else {
                                                                                            phi_2980_ = _e2348.y;
                                                                                        }
                                                                                        let _e2358 = phi_2980_;
                                                                                        if (_e2346 < _e2348.z) {
                                                                                            phi_2987_ = _e2346;
                                                                                        } else {
                                                                                            phi_2987_ = _e2348.z;
                                                                                        }
                                                                                        let _e2363 = phi_2987_;
                                                                                        let _e2365 = triangles.member[(0u + _e2035)].v0_;
                                                                                        let _e2367 = triangles.member[(0u + _e2035)].v1_;
                                                                                        if (_e2365.x > _e2367.x) {
                                                                                            phi_3000_ = _e2365.x;
                                                                                        } else {
                                                                                            phi_3000_ = _e2367.x;
                                                                                        }
                                                                                        let _e2374 = phi_3000_;
                                                                                        if (_e2365.y > _e2367.y) {
                                                                                            phi_3009_ = _e2365.y;
                                                                                        } else {
                                                                                            phi_3009_ = _e2367.y;
                                                                                        }
                                                                                        let _e2381 = phi_3009_;
                                                                                        if (_e2365.z > _e2367.z) {
                                                                                            phi_3018_ = _e2365.z;
                                                                                        } else {
                                                                                            phi_3018_ = _e2367.z;
                                                                                        }
                                                                                        let _e2388 = phi_3018_;
                                                                                        let _e2390 = triangles.member[(0u + _e2035)].v2_;
                                                                                        if (_e2374 > _e2390.x) {
                                                                                            phi_3027_ = _e2374;
                                                                                        } else {
                                                                                            phi_3027_ = _e2390.x;
                                                                                        }
                                                                                        let _e2395 = phi_3027_;
                                                                                        if (_e2381 > _e2390.y) {
                                                                                            phi_3034_ = _e2381;
                                                                                        } else {
                                                                                            phi_3034_ = _e2390.y;
                                                                                        }
                                                                                        let _e2400 = phi_3034_;
                                                                                        if (_e2388 > _e2390.z) {
                                                                                            phi_3041_ = _e2388;
                                                                                        } else {
                                                                                            phi_3041_ = _e2390.z;
                                                                                        }
                                                                                        let _e2405 = phi_3041_;
                                                                                        let _e2409 = ((_e2353 - _e1145) * _e1346);
                                                                                        let _e2410 = ((_e2358 - _e1158) * _e1356);
                                                                                        let _e2411 = ((_e2363 - _e1171) * _e1366);
                                                                                        let _e2415 = ((_e2395 - _e1145) * _e1346);
                                                                                        let _e2416 = ((_e2400 - _e1158) * _e1356);
                                                                                        let _e2417 = ((_e2405 - _e1171) * _e1366);
                                                                                        if (_e2409 < _e2415) {
                                                                                            phi_3058_ = _e2409;
                                                                                        } else {
                                                                                            phi_3058_ = _e2415;
                                                                                        }
                                                                                        let _e2420 = phi_3058_;
                                                                                        if (_e2410 < _e2416) {
                                                                                            phi_3063_ = _e2410;
                                                                                        } else {
                                                                                            phi_3063_ = _e2416;
                                                                                        }
                                                                                        let _e2423 = phi_3063_;
                                                                                        if (_e2411 < _e2417) {
                                                                                            phi_3068_ = _e2411;
                                                                                        } else {
                                                                                            phi_3068_ = _e2417;
                                                                                        }
                                                                                        let _e2426 = phi_3068_;
                                                                                        if (_e2409 > _e2415) {
                                                                                            phi_3076_ = _e2409;
                                                                                        } else {
                                                                                            phi_3076_ = _e2415;
                                                                                        }
                                                                                        let _e2432 = phi_3076_;
                                                                                        if (_e2410 > _e2416) {
                                                                                            phi_3081_ = _e2410;
                                                                                        } else {
                                                                                            phi_3081_ = _e2416;
                                                                                        }
                                                                                        let _e2435 = phi_3081_;
                                                                                        if (_e2411 > _e2417) {
                                                                                            phi_3086_ = _e2411;
                                                                                        } else {
                                                                                            phi_3086_ = _e2417;
                                                                                        }
                                                                                        let _e2438 = phi_3086_;
                                                                                        let _e2442 = core_intrinsics_maximum_number_nsz_f32_((_e2420 - _e1405), (_e2423 - _e1406));
                                                                                        let _e2443 = core_intrinsics_maximum_number_nsz_f32_(_e2442, (_e2426 - _e1407));
                                                                                        let _e2444 = core_intrinsics_minimum_number_nsz_f32_((_e2432 + _e1405), (_e2435 + _e1406));
                                                                                        let _e2445 = core_intrinsics_minimum_number_nsz_f32_(_e2444, (_e2438 + _e1407));
                                                                                        if (_e2443 > _e1126) {
                                                                                            phi_3098_ = _e2443;
                                                                                        } else {
                                                                                            phi_3098_ = _e1126;
                                                                                        }
                                                                                        let _e2448 = phi_3098_;
                                                                                        if (_e2445 < _e1128) {
                                                                                            phi_3103_ = _e2445;
                                                                                        } else {
                                                                                            phi_3103_ = _e1128;
                                                                                        }
                                                                                        let _e2451 = phi_3103_;
                                                                                        if (_e2319 < _e2448) {
                                                                                            phi_3108_ = _e2448;
                                                                                        } else {
                                                                                            phi_3108_ = _e2319;
                                                                                        }
                                                                                        let _e2454 = phi_3108_;
                                                                                        if (_e2454 > _e2451) {
                                                                                            phi_3113_ = _e2451;
                                                                                        } else {
                                                                                            phi_3113_ = _e2454;
                                                                                        }
                                                                                        let _e2457 = phi_3113_;
                                                                                        phi_3118_ = lt_bvh_triangle_Intersection(_e2457, (_e2160 / _e2219), (_e2181 / _e2219), (_e2448 <= _e2451));
                                                                                        phi_3119_ = false;
                                                                                    } else {
                                                                                        phi_3118_ = lt_bvh_triangle_Intersection();
                                                                                        phi_3119_ = true;
                                                                                    }
                                                                                    let _e2463 = phi_3118_;
                                                                                    let _e2465 = phi_3119_;
                                                                                    phi_3120_ = _e2463;
                                                                                    phi_3121_ = _e2465;
                                                                                } else {
                                                                                    phi_3120_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3121_ = true;
                                                                                }
                                                                                let _e2467 = phi_3120_;
                                                                                let _e2469 = phi_3121_;
                                                                                if _e2469 {
                                                                                }
                                                                                phi_3125_ = _e2467;
                                                                                phi_3126_ = _e2469;
                                                                            }
                                                                            let _e2471 = phi_3125_;
                                                                            let _e2473 = phi_3126_;
                                                                            phi_3127_ = _e2471;
                                                                            phi_3128_ = _e2222;
                                                                            phi_3129_ = _e2473;
                                                                        } else {
                                                                            phi_3127_ = lt_bvh_triangle_Intersection();
                                                                            phi_3128_ = true;
                                                                            phi_3129_ = false;
                                                                        }
                                                                        let _e2475 = phi_3127_;
                                                                        let _e2477 = phi_3128_;
                                                                        let _e2479 = phi_3129_;
                                                                        if _e2477 {
                                                                            phi_3133_ = true;
                                                                        } else {
                                                                            phi_3133_ = _e2479;
                                                                        }
                                                                        let _e2481 = phi_3133_;
                                                                        if _e2481 {
                                                                            phi_3137_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                        } else {
                                                                            phi_3137_ = _e2475;
                                                                        }
                                                                        let _e2483 = phi_3137_;
                                                                        if _e2483.is_hit {
                                                                            if (_e2483.t > 0f) {
                                                                                if (_e2483.t < _e275) {
                                                                                    let _e2490 = triangles.member[(0u + _e2035)].i0_;
                                                                                    if ((_e2490 & 2147483648u) == 0u) {
                                                                                        phi_3356_ = true;
                                                                                    } else {
                                                                                        if (_e2035 < _e82) {
                                                                                        } else {
                                                                                            return;
                                                                                        }
                                                                                        let _e2499 = triangles.member[(0u + _e2035)].i0_;
                                                                                        let _e2500 = (_e2499 & 2147483647u);
                                                                                        let _e2502 = triangles.member[(0u + _e2035)].i1_;
                                                                                        let _e2504 = triangles.member[(0u + _e2035)].i2_;
                                                                                        if (_e2500 < _e91) {
                                                                                        } else {
                                                                                            return;
                                                                                        }
                                                                                        let _e2508 = vertices.member[(0u + _e2500)];
                                                                                        if (_e2502 < _e91) {
                                                                                        } else {
                                                                                            return;
                                                                                        }
                                                                                        let _e2512 = vertices.member[(0u + _e2502)];
                                                                                        if (_e2504 < _e91) {
                                                                                        } else {
                                                                                            return;
                                                                                        }
                                                                                        let _e2516 = vertices.member[(0u + _e2504)];
                                                                                        let _e2517 = array<abi_Vertex, 3>(_e2508, _e2512, _e2516);
                                                                                        if (_e2517[0].material < arrayLength((&materials.member))) {
                                                                                        } else {
                                                                                            return;
                                                                                        }
                                                                                        let _e2523 = materials.member[(0u + _e2517[0].material)];
                                                                                        if ((_e2523.flags & 1u) == 1u) {
                                                                                            let _e2528 = ((1f - _e2483.u) - _e2483.v);
                                                                                            if (_e2523.cutoff <= 0f) {
                                                                                                phi_3354_ = true;
                                                                                            } else {
                                                                                                let _e2555 = (_e2523.base_color.w * ((((f32((_e2517[0].color >> bitcast<u32>(24i))) * _e2528) + (f32((_e2517[1].color >> bitcast<u32>(24i))) * _e2483.u)) + (f32((_e2517[2].color >> bitcast<u32>(24i))) * _e2483.v)) * (1f / 255f)));
                                                                                                if (_e2523.alpha_size == 0u) {
                                                                                                    phi_3351_ = _e2555;
                                                                                                } else {
                                                                                                    local.offset = _e2523.alpha_offset;
                                                                                                    local.size = _e2523.alpha_size;
                                                                                                    local.flags = _e2523.flags;
                                                                                                    let _e2586 = _lt_shaders_texture_TextureView_quad((&local), (((_e2517[0].u * _e2528) + (_e2517[1].u * _e2483.u)) + (_e2517[2].u * _e2483.v)), (((_e2517[0].v * _e2528) + (_e2517[1].v * _e2483.u)) + (_e2517[2].v * _e2483.v)));
                                                                                                    let _e2590 = (_e2586.indices[0] >> bitcast<u32>(2i));
                                                                                                    if (_e2590 < _e97) {
                                                                                                    } else {
                                                                                                        return;
                                                                                                    }
                                                                                                    let _e2594 = alpha_texels.member[(0u + _e2590)];
                                                                                                    let _e2610 = (_e2586.indices[1] >> bitcast<u32>(2i));
                                                                                                    if (_e2610 < _e97) {
                                                                                                    } else {
                                                                                                        return;
                                                                                                    }
                                                                                                    let _e2614 = alpha_texels.member[(0u + _e2610)];
                                                                                                    let _e2631 = (_e2586.indices[2] >> bitcast<u32>(2i));
                                                                                                    if (_e2631 < _e97) {
                                                                                                    } else {
                                                                                                        return;
                                                                                                    }
                                                                                                    let _e2635 = alpha_texels.member[(0u + _e2631)];
                                                                                                    let _e2652 = (_e2586.indices[3] >> bitcast<u32>(2i));
                                                                                                    if (_e2652 < _e97) {
                                                                                                    } else {
                                                                                                        return;
                                                                                                    }
                                                                                                    let _e2656 = alpha_texels.member[(0u + _e2652)];
                                                                                                    phi_3351_ = (_e2555 * (((((f32(((_e2594 >> bitcast<u32>((((_e2586.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2586.weights.x) + ((f32(((_e2614 >> bitcast<u32>((((_e2586.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2586.weights.y)) + ((f32(((_e2635 >> bitcast<u32>((((_e2586.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2586.weights.z)) + ((f32(((_e2656 >> bitcast<u32>((((_e2586.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2586.weights.w)));
                                                                                                }
                                                                                                let _e2672 = phi_3351_;
                                                                                                phi_3354_ = (_e2672 >= _e2523.cutoff);
                                                                                            }
                                                                                            let _e2676 = phi_3354_;
                                                                                            phi_3355_ = _e2676;
                                                                                        } else {
                                                                                            phi_3355_ = false;
                                                                                        }
                                                                                        let _e2678 = phi_3355_;
                                                                                        phi_3356_ = _e2678;
                                                                                    }
                                                                                    let _e2680 = phi_3356_;
                                                                                    if _e2680 {
                                                                                        phi_3360_ = false;
                                                                                    } else {
                                                                                        phi_3360_ = true;
                                                                                    }
                                                                                    let _e2682 = phi_3360_;
                                                                                    phi_3361_ = _e2680;
                                                                                    phi_3362_ = _e2680;
                                                                                    phi_3363_ = _e2682;
                                                                                } else {
                                                                                    phi_3361_ = bool();
                                                                                    phi_3362_ = _e2026;
                                                                                    phi_3363_ = true;
                                                                                }
                                                                                let _e2684 = phi_3361_;
                                                                                let _e2686 = phi_3362_;
                                                                                let _e2688 = phi_3363_;
                                                                                phi_3364_ = _e2684;
                                                                                phi_3365_ = _e2686;
                                                                                phi_3366_ = _e2688;
                                                                            } else {
                                                                                phi_3364_ = bool();
                                                                                phi_3365_ = _e2026;
                                                                                phi_3366_ = true;
                                                                            }
                                                                            let _e2690 = phi_3364_;
                                                                            let _e2692 = phi_3365_;
                                                                            let _e2694 = phi_3366_;
                                                                            phi_3367_ = _e2690;
                                                                            phi_3368_ = _e2692;
                                                                            phi_3369_ = _e2694;
                                                                        } else {
                                                                            phi_3367_ = bool();
                                                                            phi_3368_ = _e2026;
                                                                            phi_3369_ = true;
                                                                        }
                                                                        let _e2696 = phi_3367_;
                                                                        let _e2698 = phi_3368_;
                                                                        let _e2700 = phi_3369_;
                                                                        if _e2700 {
                                                                        }
                                                                        phi_2567_ = (_e2024 & (_e2024 - 1u));
                                                                        phi_2570_ = _e2698;
                                                                        phi_3373_ = _e2696;
                                                                        phi_3374_ = _e2700;
                                                                    }
                                                                    let _e2702 = phi_2567_;
                                                                    let _e2704 = phi_2570_;
                                                                    let _e2706 = phi_3373_;
                                                                    let _e2708 = phi_3374_;
                                                                    local_15 = _e2706;
                                                                    continue;
                                                                    continuing {
                                                                        phi_2566_ = _e2702;
                                                                        phi_2569_ = _e2704;
                                                                        break if !(_e2708);
                                                                    }
                                                                }
                                                                let _e2711 = local_10;
                                                                if _e2711 {
                                                                    let _e2713 = local_1.group_mask;
                                                                    if ((_e2713 & 4278190080u) == 0u) {
                                                                        let _e2717 = local_1.len;
                                                                        if (_e2717 == 0u) {
                                                                            phi_3416_ = false;
                                                                        } else {
                                                                            let _e2721 = local_1.len;
                                                                            local_1.len = (_e2721 - 1u);
                                                                            let _e2724 = local_1.len;
                                                                            if (_e2724 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            let _e2729 = local_1.first[(0u + _e2724)];
                                                                            local_1.group = _e2729;
                                                                            let _e2732 = local_1.len;
                                                                            if (_e2732 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            let _e2737 = local_1.mask[(0u + _e2732)];
                                                                            local_1.group_mask = _e2737;
                                                                            phi_3416_ = true;
                                                                        }
                                                                        let _e2740 = phi_3416_;
                                                                        phi_3417_ = _e2740;
                                                                    } else {
                                                                        phi_3417_ = true;
                                                                    }
                                                                    let _e2742 = phi_3417_;
                                                                    if _e2742 {
                                                                        let _e2744 = local_1.group_mask;
                                                                        let _e2750 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2744)), 32u, (_e2744 == 0u)));
                                                                        let _e2754 = local_1.group_mask;
                                                                        let _e2768 = local_1.group_mask;
                                                                        local_1.group_mask = (_e2768 & ~((1u << bitcast<u32>((_e2750 & 31u)))));
                                                                        let _e2771 = local_1.group;
                                                                        phi_3448_ = (_e2771 + countOneBits(((_e2754 & ~((4294967295u << bitcast<u32>((((_e2750 - 24u) ^ _e1448) & 31u))))) & 255u)));
                                                                    } else {
                                                                        phi_3448_ = 4294967295u;
                                                                    }
                                                                    let _e2774 = phi_3448_;
                                                                    phi_3449_ = _e2774;
                                                                } else {
                                                                    phi_3449_ = u32();
                                                                }
                                                                let _e2776 = phi_3449_;
                                                                phi_2235_ = _e2776;
                                                                let _e3172 = local_14;
                                                                phi_2238_ = _e3172;
                                                                let _e3175 = local_15;
                                                                phi_3450_ = _e3175;
                                                                let _e3178 = local_16;
                                                                phi_3451_ = _e3178;
                                                                phi_3452_ = false;
                                                            } else {
                                                                phi_2235_ = u32();
                                                                phi_2238_ = bool();
                                                                phi_3450_ = bool();
                                                                phi_3451_ = false;
                                                                phi_3452_ = true;
                                                            }
                                                            let _e2778 = phi_2235_;
                                                            let _e2780 = phi_2238_;
                                                            let _e2782 = phi_3450_;
                                                            let _e2784 = phi_3451_;
                                                            let _e2786 = phi_3452_;
                                                            local_11 = _e2786;
                                                            local_17 = _e2782;
                                                            continue;
                                                            continuing {
                                                                phi_2234_ = _e2778;
                                                                phi_2237_ = _e2780;
                                                                break if !(_e2784);
                                                            }
                                                        }
                                                        let _e2789 = local_11;
                                                        if _e2789 {
                                                            phi_3456_ = false;
                                                        } else {
                                                            phi_3456_ = true;
                                                        }
                                                        let _e2791 = phi_3456_;
                                                        if _e2791 {
                                                            let _e3184 = local_17;
                                                            phi_3460_ = _e3184;
                                                        } else {
                                                            let _e3186 = local_18;
                                                            phi_3460_ = _e3186;
                                                        }
                                                        let _e2793 = phi_3460_;
                                                        phi_3461_ = _e2793;
                                                    }
                                                    let _e2795 = phi_3461_;
                                                    phi_3462_ = _e2795;
                                                    phi_3463_ = _e1270;
                                                } else {
                                                    phi_3462_ = bool();
                                                    phi_3463_ = true;
                                                }
                                                let _e2797 = phi_3462_;
                                                let _e2799 = phi_3463_;
                                                if _e2799 {
                                                    phi_3467_ = _e1065;
                                                } else {
                                                    phi_3467_ = _e2797;
                                                }
                                                let _e2801 = phi_3467_;
                                                if _e2801 {
                                                    phi_3471_ = false;
                                                } else {
                                                    phi_3471_ = true;
                                                }
                                                let _e2803 = phi_3471_;
                                                phi_3472_ = _e2801;
                                                phi_3473_ = _e2803;
                                            } else {
                                                phi_3472_ = _e1065;
                                                phi_3473_ = true;
                                            }
                                            let _e2805 = phi_3472_;
                                            let _e2807 = phi_3473_;
                                            phi_3474_ = _e2805;
                                            phi_3475_ = _e2807;
                                        } else {
                                            phi_3474_ = _e1065;
                                            phi_3475_ = true;
                                        }
                                        let _e2809 = phi_3474_;
                                        let _e2811 = phi_3475_;
                                        phi_3476_ = _e2809;
                                        phi_3477_ = _e2811;
                                    } else {
                                        phi_3476_ = _e1065;
                                        phi_3477_ = true;
                                    }
                                    let _e2813 = phi_3476_;
                                    let _e2815 = phi_3477_;
                                    if _e2815 {
                                    }
                                    phi_1620_ = (_e1063 & (_e1063 - 1u));
                                    phi_1623_ = _e2813;
                                    phi_3481_ = _e2815;
                                }
                                let _e2817 = phi_1620_;
                                let _e2819 = phi_1623_;
                                let _e2821 = phi_3481_;
                                continue;
                                continuing {
                                    phi_1619_ = _e2817;
                                    phi_1622_ = _e2819;
                                    break if !(_e2821);
                                }
                            }
                            let _e2824 = local_12;
                            if _e2824 {
                                let _e2826 = local_2.group_mask;
                                if ((_e2826 & 4278190080u) == 0u) {
                                    let _e2830 = local_2.len;
                                    if (_e2830 == 0u) {
                                        phi_3523_ = false;
                                    } else {
                                        let _e2834 = local_2.len;
                                        local_2.len = (_e2834 - 1u);
                                        let _e2837 = local_2.len;
                                        if (_e2837 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2842 = local_2.first[(0u + _e2837)];
                                        local_2.group = _e2842;
                                        let _e2845 = local_2.len;
                                        if (_e2845 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2850 = local_2.mask[(0u + _e2845)];
                                        local_2.group_mask = _e2850;
                                        phi_3523_ = true;
                                    }
                                    let _e2853 = phi_3523_;
                                    phi_3524_ = _e2853;
                                } else {
                                    phi_3524_ = true;
                                }
                                let _e2855 = phi_3524_;
                                if _e2855 {
                                    let _e2857 = local_2.group_mask;
                                    let _e2863 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2857)), 32u, (_e2857 == 0u)));
                                    let _e2867 = local_2.group_mask;
                                    let _e2881 = local_2.group_mask;
                                    local_2.group_mask = (_e2881 & ~((1u << bitcast<u32>((_e2863 & 31u)))));
                                    let _e2884 = local_2.group;
                                    phi_3555_ = (_e2884 + countOneBits(((_e2867 & ~((4294967295u << bitcast<u32>((((_e2863 - 24u) ^ _e487) & 31u))))) & 255u)));
                                } else {
                                    phi_3555_ = 4294967295u;
                                }
                                let _e2887 = phi_3555_;
                                phi_3556_ = _e2887;
                            } else {
                                phi_3556_ = u32();
                            }
                            let _e2889 = phi_3556_;
                            phi_1288_ = _e2889;
                            let _e3209 = local_19;
                            phi_1291_ = _e3209;
                            let _e3212 = local_20;
                            phi_3557_ = _e3212;
                            phi_3558_ = false;
                        } else {
                            phi_1288_ = u32();
                            phi_1291_ = bool();
                            phi_3557_ = false;
                            phi_3558_ = true;
                        }
                        let _e2891 = phi_1288_;
                        let _e2893 = phi_1291_;
                        let _e2895 = phi_3557_;
                        let _e2897 = phi_3558_;
                        local_13 = _e2897;
                        continue;
                        continuing {
                            phi_1287_ = _e2891;
                            phi_1290_ = _e2893;
                            break if !(_e2895);
                        }
                    }
                    let _e2900 = local_13;
                    if _e2900 {
                        phi_3562_ = false;
                    } else {
                        phi_3562_ = true;
                    }
                    let _e2902 = phi_3562_;
                    if _e2902 {
                    }
                    phi_3566_ = _e2902;
                }
                let _e2904 = phi_3566_;
                phi_3567_ = _e339;
                phi_3568_ = _e2904;
            } else {
                phi_3567_ = true;
                phi_3568_ = false;
            }
            let _e2906 = phi_3567_;
            let _e2908 = phi_3568_;
            if _e2906 {
                phi_3572_ = false;
                phi_3573_ = true;
            } else {
                phi_3572_ = true;
                phi_3573_ = _e2908;
            }
            let _e2910 = phi_3572_;
            let _e2912 = phi_3573_;
            if _e2912 {
                phi_3577_ = _e2910;
            } else {
                phi_3577_ = false;
            }
            let _e2914 = phi_3577_;
            if _e2914 {
                phi_3581_ = 0f;
            } else {
                phi_3581_ = 1f;
            }
            let _e2916 = phi_3581_;
            phi_3582_ = _e2916;
        }
        let _e2918 = phi_3582_;
        if (_e103.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e103.first_primitive)] = _e2918;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_instanced_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
