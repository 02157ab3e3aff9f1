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

struct type_13 {
    member: array<vec4<u32>>,
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

struct type_25 {
    member: array<abi_Sample>,
}

struct type_29 {
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

struct type_43 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_47 {
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

struct type_51 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_55 {
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

struct type_59 {
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

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

struct lt_bvh_LightSpace {
    shear: vec2<f32>,
    diagonal: vec2<f32>,
    middle: vec3<f32>,
    sign: f32,
    low: vec3<f32>,
    is_parallel: u32,
    high: vec3<f32>,
    axis: u32,
    roots: vec4<u32>,
    roots_z: vec4<u32>,
}

struct type_72 {
    member: lt_bvh_LightSpace,
}

struct u0028_lt_bvh_LightPoint_u0020_u32_u0029_ {
    unnamed: lt_math_Evsm,
    unnamed_1: u32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_25;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_29;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_43;
@group(0) @binding(2) 
var<storage> nodes: type_47;
@group(0) @binding(3) 
var<storage> triangles: type_51;
@group(0) @binding(5) 
var<storage> rows: type_13;
@group(0) @binding(6) 
var<uniform> space: type_72;
@group(0) @binding(7) 
var<storage> vertices: type_55;
@group(0) @binding(8) 
var<storage> materials: type_59;
@group(0) @binding(9) 
var<storage> alpha_texels: type_9;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_250_: lt_bvh_traverse_Tree;
    var phi_251_: bool;
    var phi_252_: lt_bvh_traverse_Tree;
    var phi_253_: bool;
    var phi_258_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_250_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_251_ = false;
        } else {
            phi_250_ = lt_bvh_traverse_Tree();
            phi_251_ = true;
        }
        let _e92 = phi_250_;
        let _e94 = phi_251_;
        phi_252_ = _e92;
        phi_253_ = _e94;
    } else {
        phi_252_ = lt_bvh_traverse_Tree();
        phi_253_ = true;
    }
    let _e96 = phi_252_;
    let _e98 = phi_253_;
    if _e98 {
        phi_258_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_258_ = _e96;
    }
    let _e103 = phi_258_;
    return lt_bvh_traverse_Tree(_e103.root, _e103.first_primitive);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_273_: bool;
    var phi_277_: f32;

    if (param_3 != param_3) {
        phi_273_ = true;
    } else {
        let _e82 = (param_4 >= param_3);
        if _e82 {
        }
        phi_273_ = _e82;
    }
    let _e84 = phi_273_;
    if _e84 {
        phi_277_ = param_4;
    } else {
        phi_277_ = param_3;
    }
    let _e86 = phi_277_;
    return _e86;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_289_: bool;
    var phi_293_: f32;

    if (param_5 != param_5) {
        phi_289_ = true;
    } else {
        let _e82 = (param_6 <= param_5);
        if _e82 {
        }
        phi_289_ = _e82;
    }
    let _e84 = phi_289_;
    if _e84 {
        phi_293_ = param_6;
    } else {
        phi_293_ = param_5;
    }
    let _e86 = phi_293_;
    return _e86;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_335_: f32;
    var phi_340_: f32;
    var phi_341_: bool;
    var phi_342_: f32;
    var phi_343_: bool;
    var phi_347_: f32;
    var phi_373_: f32;
    var phi_378_: f32;
    var phi_379_: bool;
    var phi_380_: f32;
    var phi_381_: bool;
    var phi_385_: f32;
    var phi_393_: f32;
    var phi_394_: f32;
    var phi_395_: f32;
    var phi_404_: f32;
    var phi_405_: f32;
    var phi_423_: u32;
    var phi_437_: u32;
    var phi_444_: u32;
    var phi_449_: u32;
    var phi_455_: u32;
    var phi_460_: u32;
    var phi_462_: texture_Axis;
    var phi_490_: f32;
    var phi_495_: f32;
    var phi_496_: bool;
    var phi_497_: f32;
    var phi_498_: bool;
    var phi_502_: f32;
    var phi_528_: f32;
    var phi_533_: f32;
    var phi_534_: bool;
    var phi_535_: f32;
    var phi_536_: bool;
    var phi_540_: f32;
    var phi_548_: f32;
    var phi_549_: f32;
    var phi_550_: f32;
    var phi_559_: f32;
    var phi_560_: f32;
    var phi_578_: u32;
    var phi_592_: u32;
    var phi_599_: u32;
    var phi_604_: u32;
    var phi_610_: u32;
    var phi_615_: u32;
    var phi_617_: texture_Axis;

    let _e83 = (*param_7).size;
    let _e84 = (_e83 & 65535u);
    let _e86 = (*param_7).size;
    let _e88 = (_e86 >> bitcast<u32>(16i));
    let _e90 = (*param_7).flags;
    let _e92 = ((_e90 & 4u) != 0u);
    let _e94 = (*param_7).flags;
    let _e97 = ((_e94 >> bitcast<u32>(4u)) & 3u);
    if (_e97 == 0u) {
        if (param_8 > -8388608f) {
            let _e110 = f32(select(0i, select(select(i32(param_8), i32(-2147483648), (param_8 < bitcast<f32>(3472883712u))), 2147483647i, (param_8 > bitcast<f32>(1325400063u))), (param_8 == param_8)));
            if (_e110 > param_8) {
                phi_335_ = 1f;
            } else {
                phi_335_ = 0f;
            }
            let _e113 = phi_335_;
            if (param_8 < 8388608f) {
                phi_340_ = (_e110 - _e113);
                phi_341_ = false;
            } else {
                phi_340_ = f32();
                phi_341_ = true;
            }
            let _e116 = phi_340_;
            let _e118 = phi_341_;
            phi_342_ = _e116;
            phi_343_ = _e118;
        } else {
            phi_342_ = f32();
            phi_343_ = true;
        }
        let _e120 = phi_342_;
        let _e122 = phi_343_;
        if _e122 {
            phi_347_ = param_8;
        } else {
            phi_347_ = _e120;
        }
        let _e124 = phi_347_;
        phi_395_ = (param_8 - _e124);
    } else {
        if (_e97 == 1u) {
            let _e127 = (param_8 * 0.5f);
            if (_e127 > -8388608f) {
                let _e139 = f32(select(0i, select(select(i32(_e127), i32(-2147483648), (_e127 < bitcast<f32>(3472883712u))), 2147483647i, (_e127 > bitcast<f32>(1325400063u))), (_e127 == _e127)));
                if (_e139 > _e127) {
                    phi_373_ = 1f;
                } else {
                    phi_373_ = 0f;
                }
                let _e142 = phi_373_;
                if (_e127 < 8388608f) {
                    phi_378_ = (_e139 - _e142);
                    phi_379_ = false;
                } else {
                    phi_378_ = f32();
                    phi_379_ = true;
                }
                let _e145 = phi_378_;
                let _e147 = phi_379_;
                phi_380_ = _e145;
                phi_381_ = _e147;
            } else {
                phi_380_ = f32();
                phi_381_ = true;
            }
            let _e149 = phi_380_;
            let _e151 = phi_381_;
            if _e151 {
                phi_385_ = _e127;
            } else {
                phi_385_ = _e149;
            }
            let _e153 = phi_385_;
            let _e155 = (param_8 - (2f * _e153));
            if (_e155 > 1f) {
                phi_393_ = (2f - _e155);
            } else {
                phi_393_ = _e155;
            }
            let _e159 = phi_393_;
            phi_394_ = _e159;
        } else {
            phi_394_ = param_8;
        }
        let _e161 = phi_394_;
        phi_395_ = _e161;
    }
    let _e163 = phi_395_;
    if (_e163 > 0f) {
        if (_e163 < 1f) {
            phi_404_ = _e163;
        } else {
            phi_404_ = 1f;
        }
        let _e167 = phi_404_;
        phi_405_ = _e167;
    } else {
        phi_405_ = 0f;
    }
    let _e169 = phi_405_;
    let _e170 = (_e84 - 1u);
    let _e172 = (_e169 * f32(_e84));
    if _e92 {
        let _e179 = select(select(u32(_e172), 0u, (_e172 < bitcast<f32>(0u))), 4294967295u, (_e172 > bitcast<f32>(1333788671u)));
        if (_e170 < _e179) {
            phi_423_ = _e170;
        } else {
            phi_423_ = _e179;
        }
        let _e182 = phi_423_;
        phi_462_ = texture_Axis(_e182, _e182, 0f);
    } else {
        let _e184 = (_e172 + 0.5f);
        let _e191 = select(select(u32(_e184), 0u, (_e184 < bitcast<f32>(0u))), 4294967295u, (_e184 > bitcast<f32>(1333788671u)));
        if (_e84 < _e191) {
            phi_437_ = _e84;
        } else {
            phi_437_ = _e191;
        }
        let _e194 = phi_437_;
        if (_e97 == 0u) {
            phi_444_ = _e170;
        } else {
            phi_444_ = 0u;
        }
        let _e199 = phi_444_;
        if (_e97 == 0u) {
            phi_449_ = 0u;
        } else {
            phi_449_ = _e170;
        }
        let _e202 = phi_449_;
        if (_e194 == 0u) {
            phi_455_ = _e199;
        } else {
            phi_455_ = (_e194 - 1u);
        }
        let _e206 = phi_455_;
        if (_e194 > _e170) {
            phi_460_ = _e202;
        } else {
            phi_460_ = _e194;
        }
        let _e209 = phi_460_;
        phi_462_ = texture_Axis(_e206, _e209, (_e184 - f32(_e194)));
    }
    let _e212 = phi_462_;
    let _e214 = (*param_7).flags;
    let _e217 = ((_e214 >> bitcast<u32>(6u)) & 3u);
    if (_e217 == 0u) {
        if (param_9 > -8388608f) {
            let _e230 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e230 > param_9) {
                phi_490_ = 1f;
            } else {
                phi_490_ = 0f;
            }
            let _e233 = phi_490_;
            if (param_9 < 8388608f) {
                phi_495_ = (_e230 - _e233);
                phi_496_ = false;
            } else {
                phi_495_ = f32();
                phi_496_ = true;
            }
            let _e236 = phi_495_;
            let _e238 = phi_496_;
            phi_497_ = _e236;
            phi_498_ = _e238;
        } else {
            phi_497_ = f32();
            phi_498_ = true;
        }
        let _e240 = phi_497_;
        let _e242 = phi_498_;
        if _e242 {
            phi_502_ = param_9;
        } else {
            phi_502_ = _e240;
        }
        let _e244 = phi_502_;
        phi_550_ = (param_9 - _e244);
    } else {
        if (_e217 == 1u) {
            let _e247 = (param_9 * 0.5f);
            if (_e247 > -8388608f) {
                let _e259 = f32(select(0i, select(select(i32(_e247), i32(-2147483648), (_e247 < bitcast<f32>(3472883712u))), 2147483647i, (_e247 > bitcast<f32>(1325400063u))), (_e247 == _e247)));
                if (_e259 > _e247) {
                    phi_528_ = 1f;
                } else {
                    phi_528_ = 0f;
                }
                let _e262 = phi_528_;
                if (_e247 < 8388608f) {
                    phi_533_ = (_e259 - _e262);
                    phi_534_ = false;
                } else {
                    phi_533_ = f32();
                    phi_534_ = true;
                }
                let _e265 = phi_533_;
                let _e267 = phi_534_;
                phi_535_ = _e265;
                phi_536_ = _e267;
            } else {
                phi_535_ = f32();
                phi_536_ = true;
            }
            let _e269 = phi_535_;
            let _e271 = phi_536_;
            if _e271 {
                phi_540_ = _e247;
            } else {
                phi_540_ = _e269;
            }
            let _e273 = phi_540_;
            let _e275 = (param_9 - (2f * _e273));
            if (_e275 > 1f) {
                phi_548_ = (2f - _e275);
            } else {
                phi_548_ = _e275;
            }
            let _e279 = phi_548_;
            phi_549_ = _e279;
        } else {
            phi_549_ = param_9;
        }
        let _e281 = phi_549_;
        phi_550_ = _e281;
    }
    let _e283 = phi_550_;
    if (_e283 > 0f) {
        if (_e283 < 1f) {
            phi_559_ = _e283;
        } else {
            phi_559_ = 1f;
        }
        let _e287 = phi_559_;
        phi_560_ = _e287;
    } else {
        phi_560_ = 0f;
    }
    let _e289 = phi_560_;
    let _e290 = (_e88 - 1u);
    let _e292 = (_e289 * f32(_e88));
    if _e92 {
        let _e299 = select(select(u32(_e292), 0u, (_e292 < bitcast<f32>(0u))), 4294967295u, (_e292 > bitcast<f32>(1333788671u)));
        if (_e290 < _e299) {
            phi_578_ = _e290;
        } else {
            phi_578_ = _e299;
        }
        let _e302 = phi_578_;
        phi_617_ = texture_Axis(_e302, _e302, 0f);
    } else {
        let _e304 = (_e292 + 0.5f);
        let _e311 = select(select(u32(_e304), 0u, (_e304 < bitcast<f32>(0u))), 4294967295u, (_e304 > bitcast<f32>(1333788671u)));
        if (_e88 < _e311) {
            phi_592_ = _e88;
        } else {
            phi_592_ = _e311;
        }
        let _e314 = phi_592_;
        if (_e217 == 0u) {
            phi_599_ = _e290;
        } else {
            phi_599_ = 0u;
        }
        let _e319 = phi_599_;
        if (_e217 == 0u) {
            phi_604_ = 0u;
        } else {
            phi_604_ = _e290;
        }
        let _e322 = phi_604_;
        if (_e314 == 0u) {
            phi_610_ = _e319;
        } else {
            phi_610_ = (_e314 - 1u);
        }
        let _e326 = phi_610_;
        if (_e314 > _e290) {
            phi_615_ = _e322;
        } else {
            phi_615_ = _e314;
        }
        let _e329 = phi_615_;
        phi_617_ = texture_Axis(_e326, _e329, (_e304 - f32(_e314)));
    }
    let _e332 = phi_617_;
    let _e336 = (*param_7).offset;
    let _e343 = (*param_7).offset;
    let _e350 = (*param_7).offset;
    let _e357 = (*param_7).offset;
    return texture_TexelQuad(array<u32, 4>(((_e336 + (_e332.low * _e84)) + _e212.low), ((_e343 + (_e332.low * _e84)) + _e212.high), ((_e350 + (_e332.high * _e84)) + _e212.low), ((_e357 + (_e332.high * _e84)) + _e212.high)), vec4<f32>(((1f - _e212.fraction) * (1f - _e332.fraction)), (_e212.fraction * (1f - _e332.fraction)), ((1f - _e212.fraction) * _e332.fraction), (_e212.fraction * _e332.fraction)));
}

fn _lt_shaders_abi_Sample_is_valid(param_10: ptr<function, abi_Sample>) -> bool {
    var phi_689_: bool;
    var phi_690_: bool;
    var phi_691_: bool;
    var phi_692_: bool;
    var phi_696_: bool;

    let _e82 = (*param_10).normal[0u];
    let _e84 = global[0u];
    if (_e82 == _e84) {
        let _e87 = (*param_10).normal[1u];
        let _e89 = global[1u];
        if (_e87 == _e89) {
            let _e92 = (*param_10).normal[2u];
            let _e94 = global[2u];
            phi_689_ = (_e92 == _e94);
            phi_690_ = false;
        } else {
            phi_689_ = bool();
            phi_690_ = true;
        }
        let _e97 = phi_689_;
        let _e99 = phi_690_;
        phi_691_ = _e97;
        phi_692_ = _e99;
    } else {
        phi_691_ = bool();
        phi_692_ = true;
    }
    let _e101 = phi_691_;
    let _e103 = phi_692_;
    if _e103 {
        phi_696_ = false;
    } else {
        phi_696_ = _e101;
    }
    let _e105 = phi_696_;
    return !(_e105);
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: texture_TextureView;
    var local_3: array<u32, 32>;
    var local_4: abi_Sample;
    var phi_820_: bool;
    var phi_821_: bool;
    var phi_832_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_833_: bool;
    var phi_834_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_835_: bool;
    var phi_842_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_846_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_899_: f32;
    var phi_932_: bool;
    var phi_933_: bool;
    var phi_934_: bool;
    var phi_935_: bool;
    var phi_939_: bool;
    var phi_952_: bool;
    var phi_953_: bool;
    var phi_954_: bool;
    var phi_955_: bool;
    var phi_959_: bool;
    var phi_972_: bool;
    var phi_973_: bool;
    var phi_974_: bool;
    var phi_978_: bool;
    var phi_979_: bool;
    var phi_980_: bool;
    var phi_981_: bool;
    var phi_982_: bool;
    var phi_986_: bool;
    var phi_1009_: bool;
    var phi_1010_: bool;
    var phi_1011_: bool;
    var phi_1012_: bool;
    var phi_1013_: bool;
    var phi_1014_: bool;
    var phi_1018_: bool;
    var phi_1031_: bool;
    var phi_1032_: bool;
    var phi_1033_: bool;
    var phi_1037_: bool;
    var phi_1054_: bool;
    var phi_1055_: bool;
    var phi_1056_: bool;
    var phi_1057_: bool;
    var phi_1058_: bool;
    var phi_1059_: bool;
    var phi_1060_: bool;
    var phi_1064_: bool;
    var phi_1084_: bool;
    var phi_1085_: bool;
    var phi_1093_: u32;
    var phi_1094_: f32;
    var phi_1095_: u32;
    var phi_1096_: f32;
    var phi_1101_: f32;
    var phi_1112_: u32;
    var phi_1122_: u32;
    var phi_1128_: u32;
    var phi_1129_: u32;
    var phi_1130_: u32;
    var phi_1141_: vec3<f32>;
    var phi_1142_: vec3<f32>;
    var phi_1164_: vec3<f32>;
    var phi_1165_: vec3<f32>;
    var phi_1187_: u0028_lt_bvh_LightPoint_u0020_u32_u0029_;
    var phi_1262_: f32;
    var phi_1269_: f32;
    var phi_1276_: f32;
    var phi_1283_: f32;
    var phi_1290_: f32;
    var phi_1297_: f32;
    var phi_1314_: f32;
    var phi_1319_: f32;
    var phi_1324_: f32;
    var phi_1329_: f32;
    var phi_1334_: f32;
    var phi_1356_: bool;
    var phi_1357_: bool;
    var phi_1365_: u32;
    var phi_1366_: u32;
    var phi_1377_: vec3<f32>;
    var phi_1378_: vec3<f32>;
    var phi_1390_: u32;
    var phi_1393_: u32;
    var phi_1398_: u32;
    var phi_1400_: u32;
    var phi_1402_: u32;
    var phi_1404_: u32;
    var phi_1476_: f32;
    var phi_1477_: f32;
    var phi_1491_: u32;
    var phi_1514_: f32;
    var phi_1515_: f32;
    var phi_1529_: u32;
    var phi_1551_: f32;
    var phi_1552_: f32;
    var phi_1566_: u32;
    var phi_1589_: f32;
    var phi_1590_: f32;
    var phi_1604_: u32;
    var phi_1796_: u32;
    var phi_1797_: u32;
    var phi_1802_: u32;
    var phi_1803_: u32;
    var phi_1804_: u32;
    var phi_1401_: u32;
    var phi_1403_: u32;
    var phi_1805_: u32;
    var phi_1823_: u32;
    var phi_1824_: u32;
    var phi_1391_: u32;
    var phi_1394_: u32;
    var phi_1833_: bool;
    var phi_1834_: bool;
    var phi_1835_: bool;
    var local_5: bool;
    var local_6: u32;
    var phi_1844_: u32;
    var local_7: u32;
    var phi_1879_: u32;
    var phi_1880_: u32;
    var phi_1886_: u32;
    var phi_1914_: vec3<f32>;
    var phi_1915_: vec3<f32>;
    var phi_1944_: vec3<f32>;
    var phi_1945_: vec3<f32>;
    var phi_1974_: vec3<f32>;
    var phi_1975_: vec3<f32>;
    var phi_1993_: bool;
    var phi_1994_: bool;
    var phi_1998_: f32;
    var phi_1999_: f32;
    var phi_2000_: f32;
    var phi_2001_: f32;
    var phi_2009_: f32;
    var phi_2019_: bool;
    var phi_2020_: bool;
    var phi_2024_: f32;
    var phi_2025_: f32;
    var phi_2026_: f32;
    var phi_2027_: f32;
    var phi_2035_: f32;
    var phi_2045_: bool;
    var phi_2046_: bool;
    var phi_2050_: f32;
    var phi_2051_: f32;
    var phi_2052_: f32;
    var phi_2053_: f32;
    var phi_2061_: f32;
    var phi_2076_: f32;
    var phi_2077_: bool;
    var phi_2078_: f32;
    var phi_2079_: bool;
    var phi_2080_: f32;
    var phi_2081_: bool;
    var phi_2099_: f32;
    var phi_2100_: bool;
    var phi_2101_: bool;
    var phi_2102_: f32;
    var phi_2103_: bool;
    var phi_2104_: bool;
    var phi_2108_: bool;
    var phi_2109_: f32;
    var phi_2110_: bool;
    var phi_2138_: vec3<f32>;
    var phi_2139_: vec3<f32>;
    var phi_2164_: vec3<f32>;
    var phi_2165_: vec3<f32>;
    var phi_2190_: vec3<f32>;
    var phi_2191_: vec3<f32>;
    var phi_2247_: f32;
    var phi_2256_: f32;
    var phi_2265_: f32;
    var phi_2274_: f32;
    var phi_2281_: f32;
    var phi_2288_: f32;
    var phi_2301_: f32;
    var phi_2310_: f32;
    var phi_2319_: f32;
    var phi_2328_: f32;
    var phi_2335_: f32;
    var phi_2342_: f32;
    var phi_2359_: f32;
    var phi_2364_: f32;
    var phi_2369_: f32;
    var phi_2377_: f32;
    var phi_2382_: f32;
    var phi_2387_: f32;
    var phi_2399_: f32;
    var phi_2404_: f32;
    var phi_2409_: f32;
    var phi_2414_: f32;
    var phi_2419_: lt_bvh_triangle_Intersection;
    var phi_2420_: bool;
    var phi_2421_: lt_bvh_triangle_Intersection;
    var phi_2422_: bool;
    var phi_2426_: lt_bvh_triangle_Intersection;
    var phi_2427_: bool;
    var phi_2428_: lt_bvh_triangle_Intersection;
    var phi_2429_: bool;
    var phi_2430_: bool;
    var phi_2434_: bool;
    var phi_2438_: lt_bvh_triangle_Intersection;
    var phi_2652_: f32;
    var phi_2655_: bool;
    var phi_2656_: bool;
    var phi_2660_: bool;
    var phi_2661_: bool;
    var phi_2662_: bool;
    var phi_2663_: bool;
    var phi_2664_: bool;
    var phi_2665_: bool;
    var phi_2666_: bool;
    var phi_2667_: bool;
    var phi_2668_: bool;
    var phi_2669_: bool;
    var phi_2670_: bool;
    var phi_2671_: bool;
    var phi_2672_: bool;
    var phi_2673_: bool;
    var phi_2677_: bool;
    var phi_2678_: bool;
    var phi_2679_: bool;
    var phi_2687_: bool;
    var phi_2688_: bool;
    var phi_2689_: bool;
    var phi_2690_: bool;
    var phi_2691_: bool;
    var local_8: bool;
    var phi_2695_: bool;
    var phi_2696_: bool;
    var phi_2697_: bool;
    var phi_2698_: bool;
    var phi_2699_: bool;
    var local_9: u32;
    var phi_2707_: bool;
    var phi_2708_: bool;
    var phi_2709_: bool;
    var phi_2710_: bool;
    var local_10: bool;
    var phi_2714_: bool;
    var phi_2718_: bool;
    var phi_2722_: bool;
    var phi_2723_: bool;
    var phi_2739_: bool;
    var phi_2740_: bool;
    var phi_2741_: bool;
    var phi_2742_: bool;
    var phi_2746_: bool;
    var phi_2759_: bool;
    var phi_2760_: bool;
    var phi_2761_: bool;
    var phi_2762_: bool;
    var phi_2766_: bool;
    var phi_2779_: bool;
    var phi_2780_: bool;
    var phi_2781_: bool;
    var phi_2785_: bool;
    var phi_2786_: bool;
    var phi_2787_: bool;
    var phi_2788_: bool;
    var phi_2789_: bool;
    var phi_2793_: bool;
    var phi_2863_: f32;
    var phi_2870_: f32;
    var phi_2877_: f32;
    var phi_2884_: f32;
    var phi_2891_: f32;
    var phi_2898_: f32;
    var phi_2915_: f32;
    var phi_2920_: f32;
    var phi_2925_: f32;
    var phi_2930_: f32;
    var phi_2935_: f32;
    var phi_2961_: bool;
    var phi_2962_: bool;
    var phi_2970_: u32;
    var phi_2971_: u32;
    var phi_2982_: vec3<f32>;
    var phi_2983_: vec3<f32>;
    var phi_2996_: u32;
    var phi_3001_: u32;
    var phi_3006_: u32;
    var phi_3120_: bool;
    var phi_3121_: bool;
    var phi_3152_: u32;
    var phi_3154_: u32;
    var phi_3157_: bool;
    var phi_3237_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_3264_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_3291_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_3297_: u32;
    var phi_3300_: u32;
    var phi_3314_: u32;
    var phi_3324_: u32;
    var phi_3334_: u32;
    var phi_3352_: u32;
    var phi_3362_: u32;
    var phi_3372_: u32;
    var phi_3408_: u32;
    var phi_3421_: u32;
    var phi_3426_: u32;
    var phi_3427_: u32;
    var phi_3428_: u32;
    var phi_3298_: u32;
    var phi_3301_: u32;
    var local_11: u32;
    var local_12: u32;
    var local_13: u32;
    var phi_3486_: u32;
    var phi_3489_: bool;
    var phi_3533_: vec3<f32>;
    var phi_3534_: vec3<f32>;
    var phi_3563_: vec3<f32>;
    var phi_3564_: vec3<f32>;
    var phi_3593_: vec3<f32>;
    var phi_3594_: vec3<f32>;
    var phi_3612_: bool;
    var phi_3613_: bool;
    var phi_3617_: f32;
    var phi_3618_: f32;
    var phi_3619_: f32;
    var phi_3620_: f32;
    var phi_3628_: f32;
    var phi_3638_: bool;
    var phi_3639_: bool;
    var phi_3643_: f32;
    var phi_3644_: f32;
    var phi_3645_: f32;
    var phi_3646_: f32;
    var phi_3654_: f32;
    var phi_3664_: bool;
    var phi_3665_: bool;
    var phi_3669_: f32;
    var phi_3670_: f32;
    var phi_3671_: f32;
    var phi_3672_: f32;
    var phi_3680_: f32;
    var phi_3695_: f32;
    var phi_3696_: bool;
    var phi_3697_: f32;
    var phi_3698_: bool;
    var phi_3699_: f32;
    var phi_3700_: bool;
    var phi_3718_: f32;
    var phi_3719_: bool;
    var phi_3720_: bool;
    var phi_3721_: f32;
    var phi_3722_: bool;
    var phi_3723_: bool;
    var phi_3727_: bool;
    var phi_3728_: f32;
    var phi_3729_: bool;
    var phi_3757_: vec3<f32>;
    var phi_3758_: vec3<f32>;
    var phi_3783_: vec3<f32>;
    var phi_3784_: vec3<f32>;
    var phi_3809_: vec3<f32>;
    var phi_3810_: vec3<f32>;
    var phi_3866_: f32;
    var phi_3875_: f32;
    var phi_3884_: f32;
    var phi_3893_: f32;
    var phi_3900_: f32;
    var phi_3907_: f32;
    var phi_3920_: f32;
    var phi_3929_: f32;
    var phi_3938_: f32;
    var phi_3947_: f32;
    var phi_3954_: f32;
    var phi_3961_: f32;
    var phi_3978_: f32;
    var phi_3983_: f32;
    var phi_3988_: f32;
    var phi_3996_: f32;
    var phi_4001_: f32;
    var phi_4006_: f32;
    var phi_4018_: f32;
    var phi_4023_: f32;
    var phi_4028_: f32;
    var phi_4033_: f32;
    var phi_4038_: lt_bvh_triangle_Intersection;
    var phi_4039_: bool;
    var phi_4040_: lt_bvh_triangle_Intersection;
    var phi_4041_: bool;
    var phi_4045_: lt_bvh_triangle_Intersection;
    var phi_4046_: bool;
    var phi_4047_: lt_bvh_triangle_Intersection;
    var phi_4048_: bool;
    var phi_4049_: bool;
    var phi_4053_: bool;
    var phi_4057_: lt_bvh_triangle_Intersection;
    var phi_4271_: f32;
    var phi_4274_: bool;
    var phi_4275_: bool;
    var phi_4276_: bool;
    var phi_4280_: bool;
    var phi_4281_: bool;
    var phi_4282_: bool;
    var phi_4283_: bool;
    var phi_4284_: bool;
    var phi_4285_: bool;
    var phi_4286_: bool;
    var phi_4287_: bool;
    var phi_4288_: bool;
    var phi_4289_: bool;
    var phi_3487_: u32;
    var phi_3490_: bool;
    var phi_4293_: bool;
    var phi_4294_: bool;
    var local_14: bool;
    var phi_4336_: bool;
    var phi_4337_: bool;
    var phi_4368_: u32;
    var phi_4369_: u32;
    var phi_3155_: u32;
    var phi_3158_: bool;
    var phi_4370_: bool;
    var phi_4371_: bool;
    var phi_4372_: bool;
    var local_15: bool;
    var phi_4376_: bool;
    var phi_4380_: bool;
    var phi_4381_: bool;
    var phi_4382_: bool;
    var phi_4383_: bool;
    var phi_4387_: bool;
    var phi_4388_: bool;
    var phi_4389_: bool;
    var phi_4393_: f32;
    var phi_4394_: f32;
    var local_16: u32;
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
    var local_27: bool;
    var local_28: bool;

    let _e84 = id_1;
    let _e91 = arrayLength((&nodes.member));
    let _e94 = arrayLength((&triangles.member));
    let _e100 = arrayLength((&rows.member));
    let _e104 = arrayLength((&vertices.member));
    let _e107 = arrayLength((&materials.member));
    let _e110 = arrayLength((&alpha_texels.member));
    let _e113 = p.member.size[0u];
    let _e115 = p.member.size[1u];
    let _e116 = lt_shaders_entry_pixel_index(_e84, _e113, _e115);
    if (bitcast<i32>(_e116.root) != 0i) {
        if (_e116.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e124 = samples.member[(0u + _e116.first_primitive)];
        local_4 = abi_Sample(_e124.position, _e124.magnitude, _e124.normal, _e124.flags, _e124.shading_normal, _e124.albedo);
        let _e133 = _lt_shaders_abi_Sample_is_valid((&local_4));
        if _e133 {
            let _e135 = local_4.position;
            let _e137 = p.member.light.place;
            let _e143 = p.member.light.place[3u];
            let _e150 = (_e137.x - (_e135.x * _e143));
            let _e151 = (_e137.y - (_e135.y * _e143));
            let _e152 = (_e137.z - (_e135.z * _e143));
            let _e154 = local_4.normal;
            if ((((_e154.x * _e150) + (_e154.y * _e151)) + (_e154.z * _e152)) > 0f) {
                let _e168 = (((_e150 * _e150) + (_e151 * _e151)) + (_e152 * _e152));
                let _e170 = p.member.light.axis;
                let _e182 = p.member.light.place[3u];
                if (_e182 == 0f) {
                    phi_821_ = true;
                } else {
                    let _e185 = p.member.light.range_squared;
                    if (_e168 <= _e185) {
                        let _e188 = p.member.light.cos_outer;
                        phi_820_ = (-((((_e150 * _e170.x) + (_e151 * _e170.y)) + (_e152 * _e170.z))) >= (_e188 * sqrt(_e168)));
                    } else {
                        phi_820_ = false;
                    }
                    let _e193 = phi_820_;
                    phi_821_ = _e193;
                }
                let _e195 = phi_821_;
                if _e195 {
                    let _e197 = local_4.flags;
                    let _e205 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e205.unnamed.visibility, false), _e205.unnamed_1);
                    phi_832_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e211.unnamed, ((_e197 & 1u) == 0u));
                    phi_833_ = false;
                } else {
                    phi_832_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_833_ = true;
                }
                let _e216 = phi_832_;
                let _e218 = phi_833_;
                phi_834_ = _e216;
                phi_835_ = _e218;
            } else {
                phi_834_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_835_ = true;
            }
            let _e220 = phi_834_;
            let _e222 = phi_835_;
            if _e222 {
                let _e228 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e234 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e228.unnamed.visibility, false), _e228.unnamed_1);
                phi_842_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e234.unnamed, true);
            } else {
                phi_842_ = _e220;
            }
            let _e239 = phi_842_;
            phi_846_ = _e239;
        } else {
            let _e245 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e251 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e245.unnamed.visibility, false), _e245.unnamed_1);
            phi_846_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e251.unnamed, true);
        }
        let _e256 = phi_846_;
        let _e260 = space.member;
        if _e256.unnamed_1 {
            phi_4394_ = _e256.unnamed.visibility;
        } else {
            let _e263 = local_4.position;
            let _e265 = local_4.normal;
            let _e267 = local_4.magnitude;
            let _e269 = ((8f / 8388608f) * _e267);
            let _e271 = (_e265.x * _e269);
            let _e273 = (_e265.y * _e269);
            let _e275 = (_e265.z * _e269);
            let _e277 = (_e263.x + _e271);
            let _e279 = (_e263.y + _e273);
            let _e281 = (_e263.z + _e275);
            let _e285 = p.member.light.place;
            if (_e285.w == 0f) {
                phi_899_ = 300000000000000000000000000000000000000f;
            } else {
                phi_899_ = 1f;
            }
            let _e289 = phi_899_;
            let _e297 = (_e285.x - (_e277 * _e285.w));
            let _e298 = (_e285.y - (_e279 * _e285.w));
            let _e299 = (_e285.z - (_e281 * _e285.w));
            let _e300 = vec3<f32>(_e297, _e298, _e299);
            let _e301 = abs(_e297);
            let _e302 = abs(_e298);
            let _e303 = abs(_e299);
            if (abs(_e277) < 1000000000000000f) {
                if (abs(_e279) < 1000000000000000f) {
                    phi_932_ = (abs(_e281) < 1000000000000000f);
                    phi_933_ = false;
                } else {
                    phi_932_ = bool();
                    phi_933_ = true;
                }
                let _e311 = phi_932_;
                let _e313 = phi_933_;
                phi_934_ = _e311;
                phi_935_ = _e313;
            } else {
                phi_934_ = bool();
                phi_935_ = true;
            }
            let _e315 = phi_934_;
            let _e317 = phi_935_;
            if _e317 {
                phi_939_ = false;
            } else {
                phi_939_ = _e315;
            }
            let _e319 = phi_939_;
            if _e319 {
                if (_e301 < 1000000000000000f) {
                    if (_e302 < 1000000000000000f) {
                        phi_952_ = (_e303 < 1000000000000000f);
                        phi_953_ = false;
                    } else {
                        phi_952_ = bool();
                        phi_953_ = true;
                    }
                    let _e324 = phi_952_;
                    let _e326 = phi_953_;
                    phi_954_ = _e324;
                    phi_955_ = _e326;
                } else {
                    phi_954_ = bool();
                    phi_955_ = true;
                }
                let _e328 = phi_954_;
                let _e330 = phi_955_;
                if _e330 {
                    phi_959_ = false;
                } else {
                    phi_959_ = _e328;
                }
                let _e332 = phi_959_;
                if _e332 {
                    if (_e301 > 0f) {
                        phi_973_ = bool();
                        phi_974_ = true;
                    } else {
                        let _e334 = (_e302 > 0f);
                        if _e334 {
                            phi_972_ = bool();
                        } else {
                            phi_972_ = (_e303 > 0f);
                        }
                        let _e337 = phi_972_;
                        phi_973_ = _e337;
                        phi_974_ = _e334;
                    }
                    let _e339 = phi_973_;
                    let _e341 = phi_974_;
                    if _e341 {
                        phi_978_ = true;
                    } else {
                        phi_978_ = _e339;
                    }
                    let _e343 = phi_978_;
                    phi_979_ = _e343;
                    phi_980_ = false;
                } else {
                    phi_979_ = bool();
                    phi_980_ = true;
                }
                let _e345 = phi_979_;
                let _e347 = phi_980_;
                phi_981_ = _e345;
                phi_982_ = _e347;
            } else {
                phi_981_ = bool();
                phi_982_ = true;
            }
            let _e349 = phi_981_;
            let _e351 = phi_982_;
            if _e351 {
                phi_986_ = false;
            } else {
                phi_986_ = _e349;
            }
            let _e353 = phi_986_;
            if _e353 {
                if (_e260.low.x <= _e277) {
                    if (_e277 <= _e260.high.x) {
                        if (_e260.low.y <= _e279) {
                            phi_1009_ = (_e279 <= _e260.high.y);
                            phi_1010_ = false;
                        } else {
                            phi_1009_ = bool();
                            phi_1010_ = true;
                        }
                        let _e371 = phi_1009_;
                        let _e373 = phi_1010_;
                        phi_1011_ = _e371;
                        phi_1012_ = _e373;
                    } else {
                        phi_1011_ = bool();
                        phi_1012_ = true;
                    }
                    let _e375 = phi_1011_;
                    let _e377 = phi_1012_;
                    phi_1013_ = _e375;
                    phi_1014_ = _e377;
                } else {
                    phi_1013_ = bool();
                    phi_1014_ = true;
                }
                let _e379 = phi_1013_;
                let _e381 = phi_1014_;
                if _e381 {
                    phi_1018_ = false;
                } else {
                    phi_1018_ = _e379;
                }
                let _e383 = phi_1018_;
                if (abs(_e297) > 0.000000000000000000000000000001f) {
                    phi_1032_ = bool();
                    phi_1033_ = true;
                } else {
                    let _e388 = (abs(_e298) > 0.000000000000000000000000000001f);
                    if _e388 {
                        phi_1031_ = bool();
                    } else {
                        phi_1031_ = (abs(_e299) > 0.000000000000000000000000000001f);
                    }
                    let _e391 = phi_1031_;
                    phi_1032_ = _e391;
                    phi_1033_ = _e388;
                }
                let _e393 = phi_1032_;
                let _e395 = phi_1033_;
                if _e395 {
                    phi_1037_ = true;
                } else {
                    phi_1037_ = _e393;
                }
                let _e397 = phi_1037_;
                if _e383 {
                    if (_e260.low.z <= _e281) {
                        if (_e281 <= _e260.high.z) {
                            if (_e260.is_parallel == 0u) {
                                phi_1054_ = _e397;
                            } else {
                                phi_1054_ = true;
                            }
                            let _e403 = phi_1054_;
                            phi_1055_ = _e403;
                            phi_1056_ = false;
                        } else {
                            phi_1055_ = bool();
                            phi_1056_ = true;
                        }
                        let _e405 = phi_1055_;
                        let _e407 = phi_1056_;
                        phi_1057_ = _e405;
                        phi_1058_ = _e407;
                    } else {
                        phi_1057_ = bool();
                        phi_1058_ = true;
                    }
                    let _e409 = phi_1057_;
                    let _e411 = phi_1058_;
                    phi_1059_ = _e409;
                    phi_1060_ = _e411;
                } else {
                    phi_1059_ = bool();
                    phi_1060_ = true;
                }
                let _e413 = phi_1059_;
                let _e415 = phi_1060_;
                if _e415 {
                    phi_1064_ = false;
                } else {
                    phi_1064_ = _e413;
                }
                let _e417 = phi_1064_;
                if _e417 {
                    if (_e260.is_parallel == 0u) {
                        let _e420 = abs(_e297);
                        let _e421 = abs(_e298);
                        let _e422 = abs(_e299);
                        if (_e420 >= _e421) {
                            if (_e420 >= _e422) {
                                phi_1084_ = false;
                            } else {
                                phi_1084_ = true;
                            }
                            let _e426 = phi_1084_;
                            phi_1085_ = _e426;
                        } else {
                            phi_1085_ = true;
                        }
                        let _e428 = phi_1085_;
                        if _e428 {
                            if (_e421 >= _e422) {
                                phi_1093_ = 1u;
                                phi_1094_ = _e298;
                            } else {
                                phi_1093_ = 2u;
                                phi_1094_ = _e299;
                            }
                            let _e431 = phi_1093_;
                            let _e433 = phi_1094_;
                            phi_1095_ = _e431;
                            phi_1096_ = _e433;
                        } else {
                            phi_1095_ = 0u;
                            phi_1096_ = _e297;
                        }
                        let _e435 = phi_1095_;
                        let _e437 = phi_1096_;
                        if (_e437 < 0f) {
                            phi_1101_ = -1f;
                        } else {
                            phi_1101_ = 1f;
                        }
                        let _e440 = phi_1101_;
                        let _e441 = (_e440 < 0f);
                        if (_e435 == 0u) {
                            if _e441 {
                                phi_1112_ = _e260.roots.y;
                            } else {
                                phi_1112_ = _e260.roots.x;
                            }
                            let _e448 = phi_1112_;
                            phi_1130_ = _e448;
                        } else {
                            if (_e435 == 1u) {
                                if _e441 {
                                    phi_1122_ = _e260.roots.w;
                                } else {
                                    phi_1122_ = _e260.roots.z;
                                }
                                let _e455 = phi_1122_;
                                phi_1129_ = _e455;
                            } else {
                                if _e441 {
                                    phi_1128_ = _e260.roots_z.y;
                                } else {
                                    phi_1128_ = _e260.roots_z.x;
                                }
                                let _e461 = phi_1128_;
                                phi_1129_ = _e461;
                            }
                            let _e463 = phi_1129_;
                            phi_1130_ = _e463;
                        }
                        let _e465 = phi_1130_;
                        if (_e435 == 0u) {
                            phi_1142_ = vec3<f32>(_e298, _e299, _e297);
                        } else {
                            if (_e435 == 1u) {
                                phi_1141_ = vec3<f32>(_e299, _e297, _e298);
                            } else {
                                phi_1141_ = _e300;
                            }
                            let _e471 = phi_1141_;
                            phi_1142_ = _e471;
                        }
                        let _e473 = phi_1142_;
                        phi_1187_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm((_e473.x / _e473.z), (_e473.y / _e473.z), (_e440 / _e473.z)), _e465);
                    } else {
                        if (_e260.axis == 0u) {
                            phi_1165_ = vec3<f32>(_e279, _e281, _e277);
                        } else {
                            if (_e260.axis == 1u) {
                                phi_1164_ = vec3<f32>(_e281, _e277, _e279);
                            } else {
                                phi_1164_ = (_e263 + vec3<f32>(_e271, _e273, _e275));
                            }
                            let _e490 = phi_1164_;
                            phi_1165_ = _e490;
                        }
                        let _e492 = phi_1165_;
                        let _e507 = (_e492.z - _e260.middle.z);
                        phi_1187_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm(((_e492.x - _e260.middle.x) - (_e260.shear.x * _e507)), ((_e492.y - _e260.middle.y) - (_e260.shear.y * _e507)), (_e260.sign * _e507)), _e260.roots.x);
                    }
                    let _e518 = phi_1187_;
                    if (_e518.unnamed_1 == 4294967295u) {
                        phi_2723_ = false;
                    } else {
                        if (0u < _e91) {
                        } else {
                            return;
                        }
                        let _e535 = nodes.member[0u].frame[0u];
                        let _e539 = nodes.member[0u].frame[1u];
                        let _e543 = nodes.member[0u].frame[2u];
                        let _e547 = nodes.member[0u].frame[0u];
                        let _e551 = nodes.member[0u].frame[1u];
                        let _e555 = nodes.member[0u].frame[2u];
                        let _e559 = nodes.member[0u].frame[3u];
                        let _e593 = core_intrinsics_maximum_number_nsz_f32_(abs(_e297), abs(_e298));
                        let _e594 = core_intrinsics_maximum_number_nsz_f32_(_e593, abs(_e299));
                        let _e595 = (_e594 * 0.0000000000009094947f);
                        if (abs(_e297) < _e595) {
                            phi_1262_ = _e595;
                        } else {
                            phi_1262_ = abs(_e297);
                        }
                        let _e600 = phi_1262_;
                        if (_e297 < 0f) {
                            phi_1269_ = (-1f / _e600);
                        } else {
                            phi_1269_ = (1f / _e600);
                        }
                        let _e605 = phi_1269_;
                        if (abs(_e298) < _e595) {
                            phi_1276_ = _e595;
                        } else {
                            phi_1276_ = abs(_e298);
                        }
                        let _e610 = phi_1276_;
                        if (_e298 < 0f) {
                            phi_1283_ = (-1f / _e610);
                        } else {
                            phi_1283_ = (1f / _e610);
                        }
                        let _e615 = phi_1283_;
                        if (abs(_e299) < _e595) {
                            phi_1290_ = _e595;
                        } else {
                            phi_1290_ = abs(_e299);
                        }
                        let _e620 = phi_1290_;
                        if (_e299 < 0f) {
                            phi_1297_ = (-1f / _e620);
                        } else {
                            phi_1297_ = (1f / _e620);
                        }
                        let _e625 = phi_1297_;
                        let _e629 = abs((bitcast<f32>(_e535) - _e277));
                        let _e630 = abs((bitcast<f32>(_e539) - _e279));
                        let _e631 = abs((bitcast<f32>(_e543) - _e281));
                        let _e635 = abs(((bitcast<f32>(_e547) + (bitcast<f32>((((_e559 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e277));
                        let _e636 = abs(((bitcast<f32>(_e551) + (bitcast<f32>((((_e559 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e279));
                        let _e637 = abs(((bitcast<f32>(_e555) + (bitcast<f32>((((_e559 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e281));
                        if (_e629 > _e635) {
                            phi_1314_ = _e629;
                        } else {
                            phi_1314_ = _e635;
                        }
                        let _e640 = phi_1314_;
                        if (_e630 > _e636) {
                            phi_1319_ = _e630;
                        } else {
                            phi_1319_ = _e636;
                        }
                        let _e643 = phi_1319_;
                        if (_e631 > _e637) {
                            phi_1324_ = _e631;
                        } else {
                            phi_1324_ = _e637;
                        }
                        let _e646 = phi_1324_;
                        if (_e640 > _e643) {
                            phi_1329_ = _e640;
                        } else {
                            phi_1329_ = _e643;
                        }
                        let _e649 = phi_1329_;
                        if (_e649 > _e646) {
                            phi_1334_ = _e649;
                        } else {
                            phi_1334_ = _e646;
                        }
                        let _e652 = phi_1334_;
                        let _e659 = (_e652 * 0.0000009536743f);
                        let _e660 = (abs(_e605) * _e659);
                        let _e661 = (abs(_e615) * _e659);
                        let _e662 = (abs(_e625) * _e659);
                        let _e663 = abs(_e297);
                        let _e664 = abs(_e298);
                        let _e665 = abs(_e299);
                        if (_e663 >= _e664) {
                            if (_e663 >= _e665) {
                                phi_1356_ = false;
                            } else {
                                phi_1356_ = true;
                            }
                            let _e669 = phi_1356_;
                            phi_1357_ = _e669;
                        } else {
                            phi_1357_ = true;
                        }
                        let _e671 = phi_1357_;
                        if _e671 {
                            if (_e664 >= _e665) {
                                phi_1365_ = 1u;
                            } else {
                                phi_1365_ = 2u;
                            }
                            let _e674 = phi_1365_;
                            phi_1366_ = _e674;
                        } else {
                            phi_1366_ = 0u;
                        }
                        let _e676 = phi_1366_;
                        if (_e676 == 0u) {
                            phi_1378_ = vec3<f32>(_e298, _e299, _e297);
                        } else {
                            if (_e676 == 1u) {
                                phi_1377_ = vec3<f32>(_e299, _e297, _e298);
                            } else {
                                phi_1377_ = _e300;
                            }
                            let _e682 = phi_1377_;
                            phi_1378_ = _e682;
                        }
                        let _e684 = phi_1378_;
                        let _e687 = (_e684.x / _e684.z);
                        let _e690 = (_e684.y / _e684.z);
                        local_3 = array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        phi_1390_ = ((_e518.unnamed_1 << bitcast<u32>(8i)) | 1u);
                        phi_1393_ = 0u;
                        loop {
                            let _e697 = phi_1390_;
                            let _e699 = phi_1393_;
                            phi_1398_ = _e697;
                            phi_1400_ = 0u;
                            phi_1402_ = 0u;
                            phi_1404_ = _e699;
                            loop {
                                let _e701 = phi_1398_;
                                let _e703 = phi_1400_;
                                let _e705 = phi_1402_;
                                let _e707 = phi_1404_;
                                let _e714 = (((_e701 >> bitcast<u32>(8i)) + select(firstTrailingBit(_e701), 32u, (_e701 == 0u))) * 5u);
                                if (_e714 < _e100) {
                                } else {
                                    return;
                                }
                                let _e718 = rows.member[(0u + _e714)];
                                let _e719 = (_e714 + 1u);
                                if (_e719 < _e100) {
                                } else {
                                    return;
                                }
                                let _e723 = rows.member[(0u + _e719)];
                                let _e724 = (_e714 + 2u);
                                if (_e724 < _e100) {
                                } else {
                                    return;
                                }
                                let _e728 = rows.member[(0u + _e724)];
                                let _e729 = (_e714 + 3u);
                                if (_e729 < _e100) {
                                } else {
                                    return;
                                }
                                let _e733 = rows.member[(0u + _e729)];
                                let _e734 = (_e714 + 4u);
                                if (_e734 < _e100) {
                                } else {
                                    return;
                                }
                                let _e738 = rows.member[(0u + _e734)];
                                let _e739 = lt_bvh_Node(_e718, _e723, _e728, _e733, _e738);
                                let _e741 = (_e701 & (_e701 - 1u));
                                let _e753 = (_e518.unnamed.positive_exponent - bitcast<f32>(_e739.frame.x));
                                let _e756 = bitcast<f32>((((_e739.z.z >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                if (_e753 > 0f) {
                                    if (_e753 < (255f * _e756)) {
                                        phi_1476_ = (_e753 / _e756);
                                    } else {
                                        phi_1476_ = 255f;
                                    }
                                    let _e762 = phi_1476_;
                                    phi_1477_ = _e762;
                                } else {
                                    phi_1477_ = 0f;
                                }
                                let _e764 = phi_1477_;
                                let _e771 = select(select(u32(_e764), 0u, (_e764 < bitcast<f32>(0u))), 4294967295u, (_e764 > bitcast<f32>(1333788671u)));
                                if (f32(_e771) < _e764) {
                                    phi_1491_ = (_e771 + 1u);
                                } else {
                                    phi_1491_ = _e771;
                                }
                                let _e776 = phi_1491_;
                                let _e777 = (_e771 * 16843009u);
                                let _e778 = (_e776 * 16843009u);
                                let _e788 = (_e518.unnamed.negative_exponent - bitcast<f32>(_e739.frame.y));
                                let _e791 = bitcast<f32>((((_e739.z.z >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                if (_e788 > 0f) {
                                    if (_e788 < (255f * _e791)) {
                                        phi_1514_ = (_e788 / _e791);
                                    } else {
                                        phi_1514_ = 255f;
                                    }
                                    let _e797 = phi_1514_;
                                    phi_1515_ = _e797;
                                } else {
                                    phi_1515_ = 0f;
                                }
                                let _e799 = phi_1515_;
                                let _e806 = select(select(u32(_e799), 0u, (_e799 < bitcast<f32>(0u))), 4294967295u, (_e799 > bitcast<f32>(1333788671u)));
                                if (f32(_e806) < _e799) {
                                    phi_1529_ = (_e806 + 1u);
                                } else {
                                    phi_1529_ = _e806;
                                }
                                let _e811 = phi_1529_;
                                let _e812 = (_e806 * 16843009u);
                                let _e813 = (_e811 * 16843009u);
                                let _e822 = (((_e260.diagonal.x * _e518.unnamed.positive_exponent) + (_e260.diagonal.y * _e518.unnamed.negative_exponent)) - bitcast<f32>(_e739.frame.z));
                                let _e825 = bitcast<f32>((((_e739.z.z >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                if (_e822 > 0f) {
                                    if (_e822 < (255f * _e825)) {
                                        phi_1551_ = (_e822 / _e825);
                                    } else {
                                        phi_1551_ = 255f;
                                    }
                                    let _e831 = phi_1551_;
                                    phi_1552_ = _e831;
                                } else {
                                    phi_1552_ = 0f;
                                }
                                let _e833 = phi_1552_;
                                let _e840 = select(select(u32(_e833), 0u, (_e833 < bitcast<f32>(0u))), 4294967295u, (_e833 > bitcast<f32>(1333788671u)));
                                if (f32(_e840) < _e833) {
                                    phi_1566_ = (_e840 + 1u);
                                } else {
                                    phi_1566_ = _e840;
                                }
                                let _e845 = phi_1566_;
                                let _e846 = (_e840 * 16843009u);
                                let _e847 = (_e845 * 16843009u);
                                let _e857 = (_e518.unnamed.min_variance - bitcast<f32>(_e739.frame.w));
                                let _e860 = bitcast<f32>((((_e739.z.z >> bitcast<u32>(((3u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                                if (_e857 > 0f) {
                                    if (_e857 < (255f * _e860)) {
                                        phi_1589_ = (_e857 / _e860);
                                    } else {
                                        phi_1589_ = 255f;
                                    }
                                    let _e866 = phi_1589_;
                                    phi_1590_ = _e866;
                                } else {
                                    phi_1590_ = 0f;
                                }
                                let _e868 = phi_1590_;
                                let _e875 = select(select(u32(_e868), 0u, (_e868 < bitcast<f32>(0u))), 4294967295u, (_e868 > bitcast<f32>(1333788671u)));
                                if (f32(_e875) < _e868) {
                                    phi_1604_ = (_e875 + 1u);
                                } else {
                                    phi_1604_ = _e875;
                                }
                                let _e880 = phi_1604_;
                                let _e881 = (_e880 * 16843009u);
                                let _e1062 = (((((((((((_e777 & ~(_e739.links.x)) | (~((_e739.links.x ^ _e777)) & ((_e777 | 2155905152u) - (_e739.links.x & 2139062143u)))) & ((_e739.links.z & ~(_e778)) | (~((_e778 ^ _e739.links.z)) & ((_e739.links.z | 2155905152u) - (_e778 & 2139062143u))))) & (((_e812 & ~(_e739.x.x)) | (~((_e739.x.x ^ _e812)) & ((_e812 | 2155905152u) - (_e739.x.x & 2139062143u)))) & ((_e739.x.z & ~(_e813)) | (~((_e813 ^ _e739.x.z)) & ((_e739.x.z | 2155905152u) - (_e813 & 2139062143u)))))) & (((_e846 & ~(_e739.y.x)) | (~((_e739.y.x ^ _e846)) & ((_e846 | 2155905152u) - (_e739.y.x & 2139062143u)))) & ((_e739.y.z & ~(_e847)) | (~((_e847 ^ _e739.y.z)) & ((_e739.y.z | 2155905152u) - (_e847 & 2139062143u)))))) & ((_e739.z.x & ~(_e881)) | (~((_e881 ^ _e739.z.x)) & ((_e739.z.x | 2155905152u) - (_e881 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) | (((((((((((_e777 & ~(_e739.links.y)) | (~((_e739.links.y ^ _e777)) & ((_e777 | 2155905152u) - (_e739.links.y & 2139062143u)))) & ((_e739.links.w & ~(_e778)) | (~((_e778 ^ _e739.links.w)) & ((_e739.links.w | 2155905152u) - (_e778 & 2139062143u))))) & (((_e812 & ~(_e739.x.y)) | (~((_e739.x.y ^ _e812)) & ((_e812 | 2155905152u) - (_e739.x.y & 2139062143u)))) & ((_e739.x.w & ~(_e813)) | (~((_e813 ^ _e739.x.w)) & ((_e739.x.w | 2155905152u) - (_e813 & 2139062143u)))))) & (((_e846 & ~(_e739.y.y)) | (~((_e739.y.y ^ _e846)) & ((_e846 | 2155905152u) - (_e739.y.y & 2139062143u)))) & ((_e739.y.w & ~(_e847)) | (~((_e847 ^ _e739.y.w)) & ((_e739.y.w | 2155905152u) - (_e847 & 2139062143u)))))) & ((_e739.z.y & ~(_e881)) | (~((_e881 ^ _e739.z.y)) & ((_e739.z.y | 2155905152u) - (_e881 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) << bitcast<u32>(4i)));
                                if ((_e739.z.w & 2147483648u) != 0u) {
                                    phi_1804_ = _e741;
                                    phi_1401_ = (_e739.z.w & 2147483647u);
                                    phi_1403_ = _e1062;
                                    phi_1805_ = _e707;
                                } else {
                                    if (_e1062 == 0u) {
                                        phi_1802_ = _e741;
                                        phi_1803_ = _e707;
                                    } else {
                                        if ((_e741 & 255u) == 0u) {
                                            phi_1797_ = _e707;
                                        } else {
                                            if (_e707 < 32u) {
                                                if (_e707 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                local_3[(0u + _e707)] = _e741;
                                                phi_1796_ = (_e707 + 1u);
                                            } else {
                                                phi_1796_ = _e707;
                                            }
                                            let _e1079 = phi_1796_;
                                            phi_1797_ = _e1079;
                                        }
                                        let _e1081 = phi_1797_;
                                        phi_1802_ = (((_e739.z.w & 2147483647u) << bitcast<u32>(8i)) | _e1062);
                                        phi_1803_ = _e1081;
                                    }
                                    let _e1089 = phi_1802_;
                                    let _e1091 = phi_1803_;
                                    phi_1804_ = _e1089;
                                    phi_1401_ = _e703;
                                    phi_1403_ = _e705;
                                    phi_1805_ = _e1091;
                                }
                                let _e1093 = phi_1804_;
                                let _e1095 = phi_1401_;
                                let _e1097 = phi_1403_;
                                let _e1099 = phi_1805_;
                                local_6 = _e1097;
                                local_18 = _e1097;
                                local_7 = _e1095;
                                if ((_e1093 & 255u) == 0u) {
                                    if (_e1099 > 0u) {
                                        let _e1103 = (_e1099 - 1u);
                                        if (_e1103 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1107 = local_3[(0u + _e1103)];
                                        phi_1823_ = _e1107;
                                        phi_1824_ = _e1103;
                                    } else {
                                        phi_1823_ = 0u;
                                        phi_1824_ = _e1099;
                                    }
                                    let _e1109 = phi_1823_;
                                    let _e1111 = phi_1824_;
                                    phi_1391_ = _e1109;
                                    phi_1394_ = _e1111;
                                } else {
                                    phi_1391_ = _e1093;
                                    phi_1394_ = _e1099;
                                }
                                let _e1113 = phi_1391_;
                                let _e1115 = phi_1394_;
                                local_16 = _e1113;
                                local_17 = _e1115;
                                local_9 = _e1113;
                                if (_e1097 == 0u) {
                                    let _e1117 = (_e1113 == 0u);
                                    if _e1117 {
                                        phi_1833_ = false;
                                    } else {
                                        phi_1833_ = true;
                                    }
                                    let _e1119 = phi_1833_;
                                    phi_1834_ = _e1119;
                                    phi_1835_ = _e1117;
                                } else {
                                    phi_1834_ = false;
                                    phi_1835_ = false;
                                }
                                let _e1121 = phi_1834_;
                                let _e1123 = phi_1835_;
                                local_5 = _e1123;
                                continue;
                                continuing {
                                    phi_1398_ = _e1113;
                                    phi_1400_ = _e1095;
                                    phi_1402_ = _e1097;
                                    phi_1404_ = _e1115;
                                    break if !(_e1121);
                                }
                            }
                            let _e1126 = local_5;
                            if _e1126 {
                            }
                            let _e1128 = local_6;
                            if (_e1128 == 0u) {
                                phi_2697_ = true;
                                phi_2698_ = false;
                                phi_2699_ = false;
                            } else {
                                let _e3608 = local_18;
                                phi_1844_ = _e3608;
                                loop {
                                    let _e1131 = phi_1844_;
                                    let _e1134 = select(firstTrailingBit(_e1131), 32u, (_e1131 == 0u));
                                    let _e1138 = local_7;
                                    let _e1139 = (_e1138 + (_e1134 >> bitcast<u32>(2i)));
                                    if (_e1139 < _e100) {
                                    } else {
                                        return;
                                    }
                                    let _e1144 = rows.member[(0u + _e1139)][0u];
                                    let _e1148 = rows.member[(0u + _e1139)][1u];
                                    let _e1152 = rows.member[(0u + _e1139)][2u];
                                    let _e1156 = rows.member[(0u + _e1139)][3u];
                                    if ((_e1134 & 2u) == 0u) {
                                        phi_1879_ = _e1148;
                                        phi_1880_ = _e1144;
                                    } else {
                                        phi_1879_ = _e1156;
                                        phi_1880_ = _e1152;
                                    }
                                    let _e1160 = phi_1879_;
                                    let _e1162 = phi_1880_;
                                    if ((_e1134 & 1u) == 0u) {
                                        phi_1886_ = _e1162;
                                    } else {
                                        phi_1886_ = _e1160;
                                    }
                                    let _e1166 = phi_1886_;
                                    let _e1168 = (_e1131 & (_e1131 - 1u));
                                    if (_e1166 < _e94) {
                                    } else {
                                        return;
                                    }
                                    let _e1173 = triangles.member[(0u + _e1166)].v0_;
                                    let _e1175 = (_e1173.x - _e277);
                                    let _e1177 = (_e1173.y - _e279);
                                    let _e1179 = (_e1173.z - _e281);
                                    if (_e676 == 0u) {
                                        phi_1915_ = vec3<f32>(_e1177, _e1179, _e1175);
                                    } else {
                                        if (_e676 == 1u) {
                                            phi_1914_ = vec3<f32>(_e1179, _e1175, _e1177);
                                        } else {
                                            phi_1914_ = (_e1173 - vec3<f32>(_e277, _e279, _e281));
                                        }
                                        let _e1187 = phi_1914_;
                                        phi_1915_ = _e1187;
                                    }
                                    let _e1189 = phi_1915_;
                                    let _e1193 = (_e1189.x - (_e687 * _e1189.z));
                                    let _e1197 = (_e1189.y - (_e690 * _e1189.z));
                                    let _e1199 = triangles.member[(0u + _e1166)].v1_;
                                    let _e1201 = (_e1199.x - _e277);
                                    let _e1203 = (_e1199.y - _e279);
                                    let _e1205 = (_e1199.z - _e281);
                                    if (_e676 == 0u) {
                                        phi_1945_ = vec3<f32>(_e1203, _e1205, _e1201);
                                    } else {
                                        if (_e676 == 1u) {
                                            phi_1944_ = vec3<f32>(_e1205, _e1201, _e1203);
                                        } else {
                                            phi_1944_ = (_e1199 - vec3<f32>(_e277, _e279, _e281));
                                        }
                                        let _e1213 = phi_1944_;
                                        phi_1945_ = _e1213;
                                    }
                                    let _e1215 = phi_1945_;
                                    let _e1219 = (_e1215.x - (_e687 * _e1215.z));
                                    let _e1223 = (_e1215.y - (_e690 * _e1215.z));
                                    let _e1225 = triangles.member[(0u + _e1166)].v2_;
                                    let _e1227 = (_e1225.x - _e277);
                                    let _e1229 = (_e1225.y - _e279);
                                    let _e1231 = (_e1225.z - _e281);
                                    if (_e676 == 0u) {
                                        phi_1975_ = vec3<f32>(_e1229, _e1231, _e1227);
                                    } else {
                                        if (_e676 == 1u) {
                                            phi_1974_ = vec3<f32>(_e1231, _e1227, _e1229);
                                        } else {
                                            phi_1974_ = (_e1225 - vec3<f32>(_e277, _e279, _e281));
                                        }
                                        let _e1239 = phi_1974_;
                                        phi_1975_ = _e1239;
                                    }
                                    let _e1241 = phi_1975_;
                                    let _e1245 = (_e1241.x - (_e687 * _e1241.z));
                                    let _e1249 = (_e1241.y - (_e690 * _e1241.z));
                                    if (_e1219 < _e1245) {
                                        phi_1994_ = true;
                                    } else {
                                        if (_e1219 == _e1245) {
                                            phi_1993_ = (_e1223 < _e1249);
                                        } else {
                                            phi_1993_ = false;
                                        }
                                        let _e1254 = phi_1993_;
                                        phi_1994_ = _e1254;
                                    }
                                    let _e1256 = phi_1994_;
                                    if _e1256 {
                                        phi_1998_ = _e1249;
                                        phi_1999_ = _e1245;
                                        phi_2000_ = _e1223;
                                        phi_2001_ = _e1219;
                                    } else {
                                        phi_1998_ = _e1223;
                                        phi_1999_ = _e1219;
                                        phi_2000_ = _e1249;
                                        phi_2001_ = _e1245;
                                    }
                                    let _e1258 = phi_1998_;
                                    let _e1260 = phi_1999_;
                                    let _e1262 = phi_2000_;
                                    let _e1264 = phi_2001_;
                                    let _e1267 = ((_e1264 * _e1258) - (_e1262 * _e1260));
                                    if _e1256 {
                                        phi_2009_ = -(_e1267);
                                    } else {
                                        phi_2009_ = _e1267;
                                    }
                                    let _e1270 = phi_2009_;
                                    if (_e1245 < _e1193) {
                                        phi_2020_ = true;
                                    } else {
                                        if (_e1245 == _e1193) {
                                            phi_2019_ = (_e1249 < _e1197);
                                        } else {
                                            phi_2019_ = false;
                                        }
                                        let _e1275 = phi_2019_;
                                        phi_2020_ = _e1275;
                                    }
                                    let _e1277 = phi_2020_;
                                    if _e1277 {
                                        phi_2024_ = _e1197;
                                        phi_2025_ = _e1193;
                                        phi_2026_ = _e1249;
                                        phi_2027_ = _e1245;
                                    } else {
                                        phi_2024_ = _e1249;
                                        phi_2025_ = _e1245;
                                        phi_2026_ = _e1197;
                                        phi_2027_ = _e1193;
                                    }
                                    let _e1279 = phi_2024_;
                                    let _e1281 = phi_2025_;
                                    let _e1283 = phi_2026_;
                                    let _e1285 = phi_2027_;
                                    let _e1288 = ((_e1285 * _e1279) - (_e1283 * _e1281));
                                    if _e1277 {
                                        phi_2035_ = -(_e1288);
                                    } else {
                                        phi_2035_ = _e1288;
                                    }
                                    let _e1291 = phi_2035_;
                                    if (_e1193 < _e1219) {
                                        phi_2046_ = true;
                                    } else {
                                        if (_e1193 == _e1219) {
                                            phi_2045_ = (_e1197 < _e1223);
                                        } else {
                                            phi_2045_ = false;
                                        }
                                        let _e1296 = phi_2045_;
                                        phi_2046_ = _e1296;
                                    }
                                    let _e1298 = phi_2046_;
                                    if _e1298 {
                                        phi_2050_ = _e1223;
                                        phi_2051_ = _e1219;
                                        phi_2052_ = _e1197;
                                        phi_2053_ = _e1193;
                                    } else {
                                        phi_2050_ = _e1197;
                                        phi_2051_ = _e1193;
                                        phi_2052_ = _e1223;
                                        phi_2053_ = _e1219;
                                    }
                                    let _e1300 = phi_2050_;
                                    let _e1302 = phi_2051_;
                                    let _e1304 = phi_2052_;
                                    let _e1306 = phi_2053_;
                                    let _e1309 = ((_e1306 * _e1300) - (_e1304 * _e1302));
                                    if _e1298 {
                                        phi_2061_ = -(_e1309);
                                    } else {
                                        phi_2061_ = _e1309;
                                    }
                                    let _e1312 = phi_2061_;
                                    if (_e1270 >= 0f) {
                                        if (_e1291 >= 0f) {
                                            if (_e1312 >= 0f) {
                                                phi_2076_ = ((_e1270 + _e1291) + _e1312);
                                                phi_2077_ = false;
                                            } else {
                                                phi_2076_ = f32();
                                                phi_2077_ = true;
                                            }
                                            let _e1319 = phi_2076_;
                                            let _e1321 = phi_2077_;
                                            phi_2078_ = _e1319;
                                            phi_2079_ = _e1321;
                                        } else {
                                            phi_2078_ = f32();
                                            phi_2079_ = true;
                                        }
                                        let _e1323 = phi_2078_;
                                        let _e1325 = phi_2079_;
                                        phi_2080_ = _e1323;
                                        phi_2081_ = _e1325;
                                    } else {
                                        phi_2080_ = f32();
                                        phi_2081_ = true;
                                    }
                                    let _e1327 = phi_2080_;
                                    let _e1329 = phi_2081_;
                                    if _e1329 {
                                        if (_e1270 <= 0f) {
                                            if (_e1291 <= 0f) {
                                                let _e1332 = (_e1312 <= 0f);
                                                if _e1332 {
                                                }
                                                phi_2099_ = ((_e1270 + _e1291) + _e1312);
                                                phi_2100_ = false;
                                                phi_2101_ = _e1332;
                                            } else {
                                                phi_2099_ = f32();
                                                phi_2100_ = true;
                                                phi_2101_ = false;
                                            }
                                            let _e1336 = phi_2099_;
                                            let _e1338 = phi_2100_;
                                            let _e1340 = phi_2101_;
                                            phi_2102_ = _e1336;
                                            phi_2103_ = _e1338;
                                            phi_2104_ = _e1340;
                                        } else {
                                            phi_2102_ = f32();
                                            phi_2103_ = true;
                                            phi_2104_ = false;
                                        }
                                        let _e1342 = phi_2102_;
                                        let _e1344 = phi_2103_;
                                        let _e1346 = phi_2104_;
                                        if _e1344 {
                                            phi_2108_ = false;
                                        } else {
                                            phi_2108_ = _e1346;
                                        }
                                        let _e1348 = phi_2108_;
                                        phi_2109_ = _e1342;
                                        phi_2110_ = _e1348;
                                    } else {
                                        phi_2109_ = _e1327;
                                        phi_2110_ = true;
                                    }
                                    let _e1350 = phi_2109_;
                                    let _e1352 = phi_2110_;
                                    if _e1352 {
                                        let _e1353 = (_e1350 == 0f);
                                        if _e1353 {
                                            phi_2426_ = lt_bvh_triangle_Intersection();
                                            phi_2427_ = false;
                                        } else {
                                            let _e1355 = triangles.member[(0u + _e1166)].v0_;
                                            let _e1357 = (_e1355.x - _e277);
                                            let _e1359 = (_e1355.y - _e279);
                                            let _e1361 = (_e1355.z - _e281);
                                            if (_e676 == 0u) {
                                                phi_2139_ = vec3<f32>(_e1359, _e1361, _e1357);
                                            } else {
                                                if (_e676 == 1u) {
                                                    phi_2138_ = vec3<f32>(_e1361, _e1357, _e1359);
                                                } else {
                                                    phi_2138_ = (_e1355 - vec3<f32>(_e277, _e279, _e281));
                                                }
                                                let _e1369 = phi_2138_;
                                                phi_2139_ = _e1369;
                                            }
                                            let _e1371 = phi_2139_;
                                            let _e1373 = triangles.member[(0u + _e1166)].v1_;
                                            let _e1375 = triangles.member[(0u + _e1166)].v0_;
                                            let _e1378 = (_e1373.x - _e1375.x);
                                            let _e1381 = (_e1373.y - _e1375.y);
                                            let _e1384 = (_e1373.z - _e1375.z);
                                            if (_e676 == 0u) {
                                                phi_2165_ = vec3<f32>(_e1381, _e1384, _e1378);
                                            } else {
                                                if (_e676 == 1u) {
                                                    phi_2164_ = vec3<f32>(_e1384, _e1378, _e1381);
                                                } else {
                                                    phi_2164_ = (_e1373 - _e1375);
                                                }
                                                let _e1391 = phi_2164_;
                                                phi_2165_ = _e1391;
                                            }
                                            let _e1393 = phi_2165_;
                                            let _e1395 = triangles.member[(0u + _e1166)].v2_;
                                            let _e1397 = triangles.member[(0u + _e1166)].v0_;
                                            let _e1400 = (_e1395.x - _e1397.x);
                                            let _e1403 = (_e1395.y - _e1397.y);
                                            let _e1406 = (_e1395.z - _e1397.z);
                                            if (_e676 == 0u) {
                                                phi_2191_ = vec3<f32>(_e1403, _e1406, _e1400);
                                            } else {
                                                if (_e676 == 1u) {
                                                    phi_2190_ = vec3<f32>(_e1406, _e1400, _e1403);
                                                } else {
                                                    phi_2190_ = (_e1395 - _e1397);
                                                }
                                                let _e1413 = phi_2190_;
                                                phi_2191_ = _e1413;
                                            }
                                            let _e1415 = phi_2191_;
                                            let _e1422 = ((_e1393.y * _e1415.z) - (_e1393.z * _e1415.y));
                                            let _e1429 = ((_e1393.z * _e1415.x) - (_e1393.x * _e1415.z));
                                            let _e1436 = ((_e1393.x * _e1415.y) - (_e1393.y * _e1415.x));
                                            let _e1450 = (((1f / _e684.z) * (((_e1422 * _e1371.x) + (_e1429 * _e1371.y)) + (_e1436 * _e1371.z))) / (((_e1422 * _e687) + (_e1429 * _e690)) + _e1436));
                                            if (_e1450 > 0f) {
                                                if (_e1450 < _e289) {
                                                    let _e1454 = triangles.member[(0u + _e1166)].v0_;
                                                    let _e1456 = triangles.member[(0u + _e1166)].v1_;
                                                    if (_e1454.x < _e1456.x) {
                                                        phi_2247_ = _e1454.x;
                                                    } else {
                                                        phi_2247_ = _e1456.x;
                                                    }
                                                    let _e1463 = phi_2247_;
                                                    if (_e1454.y < _e1456.y) {
                                                        phi_2256_ = _e1454.y;
                                                    } else {
                                                        phi_2256_ = _e1456.y;
                                                    }
                                                    let _e1470 = phi_2256_;
                                                    if (_e1454.z < _e1456.z) {
                                                        phi_2265_ = _e1454.z;
                                                    } else {
                                                        phi_2265_ = _e1456.z;
                                                    }
                                                    let _e1477 = phi_2265_;
                                                    let _e1479 = triangles.member[(0u + _e1166)].v2_;
                                                    if (_e1463 < _e1479.x) {
                                                        phi_2274_ = _e1463;
                                                    } else {
                                                        phi_2274_ = _e1479.x;
                                                    }
                                                    let _e1484 = phi_2274_;
                                                    if (_e1470 < _e1479.y) {
                                                        phi_2281_ = _e1470;
                                                    } else {
                                                        phi_2281_ = _e1479.y;
                                                    }
                                                    let _e1489 = phi_2281_;
                                                    if (_e1477 < _e1479.z) {
                                                        phi_2288_ = _e1477;
                                                    } else {
                                                        phi_2288_ = _e1479.z;
                                                    }
                                                    let _e1494 = phi_2288_;
                                                    let _e1496 = triangles.member[(0u + _e1166)].v0_;
                                                    let _e1498 = triangles.member[(0u + _e1166)].v1_;
                                                    if (_e1496.x > _e1498.x) {
                                                        phi_2301_ = _e1496.x;
                                                    } else {
                                                        phi_2301_ = _e1498.x;
                                                    }
                                                    let _e1505 = phi_2301_;
                                                    if (_e1496.y > _e1498.y) {
                                                        phi_2310_ = _e1496.y;
                                                    } else {
                                                        phi_2310_ = _e1498.y;
                                                    }
                                                    let _e1512 = phi_2310_;
                                                    if (_e1496.z > _e1498.z) {
                                                        phi_2319_ = _e1496.z;
                                                    } else {
                                                        phi_2319_ = _e1498.z;
                                                    }
                                                    let _e1519 = phi_2319_;
                                                    let _e1521 = triangles.member[(0u + _e1166)].v2_;
                                                    if (_e1505 > _e1521.x) {
                                                        phi_2328_ = _e1505;
                                                    } else {
                                                        phi_2328_ = _e1521.x;
                                                    }
                                                    let _e1526 = phi_2328_;
                                                    if (_e1512 > _e1521.y) {
                                                        phi_2335_ = _e1512;
                                                    } else {
                                                        phi_2335_ = _e1521.y;
                                                    }
                                                    let _e1531 = phi_2335_;
                                                    if (_e1519 > _e1521.z) {
                                                        phi_2342_ = _e1519;
                                                    } else {
                                                        phi_2342_ = _e1521.z;
                                                    }
                                                    let _e1536 = phi_2342_;
                                                    let _e1540 = ((_e1484 - _e277) * _e605);
                                                    let _e1541 = ((_e1489 - _e279) * _e615);
                                                    let _e1542 = ((_e1494 - _e281) * _e625);
                                                    let _e1546 = ((_e1526 - _e277) * _e605);
                                                    let _e1547 = ((_e1531 - _e279) * _e615);
                                                    let _e1548 = ((_e1536 - _e281) * _e625);
                                                    if (_e1540 < _e1546) {
                                                        phi_2359_ = _e1540;
                                                    } else {
                                                        phi_2359_ = _e1546;
                                                    }
                                                    let _e1551 = phi_2359_;
                                                    if (_e1541 < _e1547) {
                                                        phi_2364_ = _e1541;
                                                    } else {
                                                        phi_2364_ = _e1547;
                                                    }
                                                    let _e1554 = phi_2364_;
                                                    if (_e1542 < _e1548) {
                                                        phi_2369_ = _e1542;
                                                    } else {
                                                        phi_2369_ = _e1548;
                                                    }
                                                    let _e1557 = phi_2369_;
                                                    if (_e1540 > _e1546) {
                                                        phi_2377_ = _e1540;
                                                    } else {
                                                        phi_2377_ = _e1546;
                                                    }
                                                    let _e1563 = phi_2377_;
                                                    if (_e1541 > _e1547) {
                                                        phi_2382_ = _e1541;
                                                    } else {
                                                        phi_2382_ = _e1547;
                                                    }
                                                    let _e1566 = phi_2382_;
                                                    if (_e1542 > _e1548) {
                                                        phi_2387_ = _e1542;
                                                    } else {
                                                        phi_2387_ = _e1548;
                                                    }
                                                    let _e1569 = phi_2387_;
                                                    let _e1573 = core_intrinsics_maximum_number_nsz_f32_((_e1551 - _e660), (_e1554 - _e661));
                                                    let _e1574 = core_intrinsics_maximum_number_nsz_f32_(_e1573, (_e1557 - _e662));
                                                    let _e1575 = core_intrinsics_minimum_number_nsz_f32_((_e1563 + _e660), (_e1566 + _e661));
                                                    let _e1576 = core_intrinsics_minimum_number_nsz_f32_(_e1575, (_e1569 + _e662));
                                                    if (_e1574 > -300000000000000000000000000000000000000f) {
                                                        phi_2399_ = _e1574;
                                                    } else {
                                                        phi_2399_ = -300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1579 = phi_2399_;
                                                    if (_e1576 < 300000000000000000000000000000000000000f) {
                                                        phi_2404_ = _e1576;
                                                    } else {
                                                        phi_2404_ = 300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1582 = phi_2404_;
                                                    if (_e1450 < _e1579) {
                                                        phi_2409_ = _e1579;
                                                    } else {
                                                        phi_2409_ = _e1450;
                                                    }
                                                    let _e1585 = phi_2409_;
                                                    if (_e1585 > _e1582) {
                                                        phi_2414_ = _e1582;
                                                    } else {
                                                        phi_2414_ = _e1585;
                                                    }
                                                    let _e1588 = phi_2414_;
                                                    phi_2419_ = lt_bvh_triangle_Intersection(_e1588, (_e1291 / _e1350), (_e1312 / _e1350), (_e1579 <= _e1582));
                                                    phi_2420_ = false;
                                                } else {
                                                    phi_2419_ = lt_bvh_triangle_Intersection();
                                                    phi_2420_ = true;
                                                }
                                                let _e1594 = phi_2419_;
                                                let _e1596 = phi_2420_;
                                                phi_2421_ = _e1594;
                                                phi_2422_ = _e1596;
                                            } else {
                                                phi_2421_ = lt_bvh_triangle_Intersection();
                                                phi_2422_ = true;
                                            }
                                            let _e1598 = phi_2421_;
                                            let _e1600 = phi_2422_;
                                            if _e1600 {
                                            }
                                            phi_2426_ = _e1598;
                                            phi_2427_ = _e1600;
                                        }
                                        let _e1602 = phi_2426_;
                                        let _e1604 = phi_2427_;
                                        phi_2428_ = _e1602;
                                        phi_2429_ = _e1353;
                                        phi_2430_ = _e1604;
                                    } else {
                                        phi_2428_ = lt_bvh_triangle_Intersection();
                                        phi_2429_ = true;
                                        phi_2430_ = false;
                                    }
                                    let _e1606 = phi_2428_;
                                    let _e1608 = phi_2429_;
                                    let _e1610 = phi_2430_;
                                    if _e1608 {
                                        phi_2434_ = true;
                                    } else {
                                        phi_2434_ = _e1610;
                                    }
                                    let _e1612 = phi_2434_;
                                    if _e1612 {
                                        phi_2438_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                    } else {
                                        phi_2438_ = _e1606;
                                    }
                                    let _e1614 = phi_2438_;
                                    if _e1614.is_hit {
                                        if (_e1614.t > 0f) {
                                            if (_e1614.t < _e289) {
                                                let _e1621 = triangles.member[(0u + _e1166)].i0_;
                                                let _e1623 = ((_e1621 & 2147483648u) == 0u);
                                                if _e1623 {
                                                    phi_2661_ = false;
                                                    phi_2662_ = false;
                                                } else {
                                                    if (_e1166 < _e94) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1630 = triangles.member[(0u + _e1166)].i0_;
                                                    let _e1631 = (_e1630 & 2147483647u);
                                                    let _e1633 = triangles.member[(0u + _e1166)].i1_;
                                                    let _e1635 = triangles.member[(0u + _e1166)].i2_;
                                                    if (_e1631 < _e104) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1639 = vertices.member[(0u + _e1631)];
                                                    if (_e1633 < _e104) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1643 = vertices.member[(0u + _e1633)];
                                                    if (_e1635 < _e104) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1647 = vertices.member[(0u + _e1635)];
                                                    let _e1648 = array<abi_Vertex, 3>(_e1639, _e1643, _e1647);
                                                    if (_e1648[0].material < _e107) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1654 = materials.member[(0u + _e1648[0].material)];
                                                    if ((_e1654.flags & 1u) == 1u) {
                                                        let _e1659 = ((1f - _e1614.u) - _e1614.v);
                                                        if (_e1654.cutoff <= 0f) {
                                                            phi_2655_ = true;
                                                        } else {
                                                            let _e1686 = (_e1654.base_color.w * ((((f32((_e1648[0].color >> bitcast<u32>(24i))) * _e1659) + (f32((_e1648[1].color >> bitcast<u32>(24i))) * _e1614.u)) + (f32((_e1648[2].color >> bitcast<u32>(24i))) * _e1614.v)) * (1f / 255f)));
                                                            if (_e1654.alpha_size == 0u) {
                                                                phi_2652_ = _e1686;
                                                            } else {
                                                                local_2.offset = _e1654.alpha_offset;
                                                                local_2.size = _e1654.alpha_size;
                                                                local_2.flags = _e1654.flags;
                                                                let _e1717 = _lt_shaders_texture_TextureView_quad((&local_2), (((_e1648[0].u * _e1659) + (_e1648[1].u * _e1614.u)) + (_e1648[2].u * _e1614.v)), (((_e1648[0].v * _e1659) + (_e1648[1].v * _e1614.u)) + (_e1648[2].v * _e1614.v)));
                                                                let _e1721 = (_e1717.indices[0] >> bitcast<u32>(2i));
                                                                if (_e1721 < _e110) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1725 = alpha_texels.member[(0u + _e1721)];
                                                                let _e1741 = (_e1717.indices[1] >> bitcast<u32>(2i));
                                                                if (_e1741 < _e110) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1745 = alpha_texels.member[(0u + _e1741)];
                                                                let _e1762 = (_e1717.indices[2] >> bitcast<u32>(2i));
                                                                if (_e1762 < _e110) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1766 = alpha_texels.member[(0u + _e1762)];
                                                                let _e1783 = (_e1717.indices[3] >> bitcast<u32>(2i));
                                                                if (_e1783 < _e110) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1787 = alpha_texels.member[(0u + _e1783)];
                                                                phi_2652_ = (_e1686 * (((((f32(((_e1725 >> bitcast<u32>((((_e1717.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1717.weights.x) + ((f32(((_e1745 >> bitcast<u32>((((_e1717.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1717.weights.y)) + ((f32(((_e1766 >> bitcast<u32>((((_e1717.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1717.weights.z)) + ((f32(((_e1787 >> bitcast<u32>((((_e1717.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1717.weights.w)));
                                                            }
                                                            let _e1803 = phi_2652_;
                                                            phi_2655_ = (_e1803 >= _e1654.cutoff);
                                                        }
                                                        let _e1807 = phi_2655_;
                                                        phi_2656_ = _e1807;
                                                    } else {
                                                        phi_2656_ = false;
                                                    }
                                                    let _e1809 = phi_2656_;
                                                    if _e1809 {
                                                        phi_2660_ = false;
                                                    } else {
                                                        phi_2660_ = true;
                                                    }
                                                    let _e1811 = phi_2660_;
                                                    phi_2661_ = _e1811;
                                                    phi_2662_ = _e1809;
                                                }
                                                let _e1813 = phi_2661_;
                                                let _e1815 = phi_2662_;
                                                phi_2663_ = _e1813;
                                                phi_2664_ = _e1623;
                                                phi_2665_ = _e1815;
                                            } else {
                                                phi_2663_ = true;
                                                phi_2664_ = false;
                                                phi_2665_ = false;
                                            }
                                            let _e1817 = phi_2663_;
                                            let _e1819 = phi_2664_;
                                            let _e1821 = phi_2665_;
                                            phi_2666_ = false;
                                            phi_2667_ = _e1817;
                                            phi_2668_ = _e1819;
                                            phi_2669_ = _e1821;
                                        } else {
                                            phi_2666_ = true;
                                            phi_2667_ = false;
                                            phi_2668_ = false;
                                            phi_2669_ = false;
                                        }
                                        let _e1823 = phi_2666_;
                                        let _e1825 = phi_2667_;
                                        let _e1827 = phi_2668_;
                                        let _e1829 = phi_2669_;
                                        phi_2670_ = _e1823;
                                        phi_2671_ = _e1825;
                                        phi_2672_ = _e1827;
                                        phi_2673_ = _e1829;
                                    } else {
                                        phi_2670_ = true;
                                        phi_2671_ = false;
                                        phi_2672_ = false;
                                        phi_2673_ = false;
                                    }
                                    let _e1831 = phi_2670_;
                                    let _e1833 = phi_2671_;
                                    let _e1835 = phi_2672_;
                                    let _e1837 = phi_2673_;
                                    if _e1831 {
                                        phi_2677_ = true;
                                        phi_2678_ = false;
                                        phi_2679_ = false;
                                    } else {
                                        phi_2677_ = _e1833;
                                        phi_2678_ = _e1835;
                                        phi_2679_ = _e1837;
                                    }
                                    let _e1839 = phi_2677_;
                                    let _e1841 = phi_2678_;
                                    let _e1843 = phi_2679_;
                                    if _e1839 {
                                        let _e1844 = (_e1168 == 0u);
                                        if _e1844 {
                                            phi_2687_ = false;
                                        } else {
                                            phi_2687_ = true;
                                        }
                                        let _e1846 = phi_2687_;
                                        phi_2688_ = _e1846;
                                        phi_2689_ = _e1844;
                                        phi_2690_ = false;
                                        phi_2691_ = false;
                                    } else {
                                        phi_2688_ = false;
                                        phi_2689_ = false;
                                        phi_2690_ = _e1841;
                                        phi_2691_ = _e1843;
                                    }
                                    let _e1848 = phi_2688_;
                                    let _e1850 = phi_2689_;
                                    let _e1852 = phi_2690_;
                                    let _e1854 = phi_2691_;
                                    local_8 = _e1850;
                                    local_19 = _e1852;
                                    local_20 = _e1854;
                                    local_21 = _e1850;
                                    continue;
                                    continuing {
                                        phi_1844_ = _e1168;
                                        break if !(_e1848);
                                    }
                                }
                                let _e1857 = local_8;
                                if _e1857 {
                                    phi_2695_ = false;
                                    phi_2696_ = false;
                                } else {
                                    let _e3722 = local_19;
                                    phi_2695_ = _e3722;
                                    let _e3725 = local_20;
                                    phi_2696_ = _e3725;
                                }
                                let _e1859 = phi_2695_;
                                let _e1861 = phi_2696_;
                                let _e3728 = local_21;
                                phi_2697_ = _e3728;
                                phi_2698_ = _e1859;
                                phi_2699_ = _e1861;
                            }
                            let _e1863 = phi_2697_;
                            let _e1865 = phi_2698_;
                            let _e1867 = phi_2699_;
                            if _e1863 {
                                let _e1869 = local_9;
                                if (_e1869 == 0u) {
                                    phi_2707_ = false;
                                } else {
                                    phi_2707_ = true;
                                }
                                let _e1872 = phi_2707_;
                                phi_2708_ = _e1872;
                                phi_2709_ = false;
                                phi_2710_ = false;
                            } else {
                                phi_2708_ = false;
                                phi_2709_ = _e1865;
                                phi_2710_ = _e1867;
                            }
                            let _e1874 = phi_2708_;
                            let _e1876 = phi_2709_;
                            let _e1878 = phi_2710_;
                            local_10 = _e1876;
                            local_22 = _e1878;
                            local_23 = _e1876;
                            continue;
                            continuing {
                                let _e3569 = local_16;
                                phi_1390_ = _e3569;
                                let _e3572 = local_17;
                                phi_1393_ = _e3572;
                                break if !(_e1874);
                            }
                        }
                        let _e1881 = local_10;
                        if _e1881 {
                            phi_2714_ = false;
                        } else {
                            let _e3739 = local_22;
                            phi_2714_ = _e3739;
                        }
                        let _e1883 = phi_2714_;
                        if _e1883 {
                            phi_2718_ = true;
                        } else {
                            let _e3742 = local_23;
                            phi_2718_ = _e3742;
                        }
                        let _e1885 = phi_2718_;
                        if _e1885 {
                            phi_2722_ = true;
                        } else {
                            phi_2722_ = false;
                        }
                        let _e1887 = phi_2722_;
                        phi_2723_ = _e1887;
                    }
                    let _e1889 = phi_2723_;
                    phi_4388_ = _e1889;
                } else {
                    let _e1890 = abs(_e297);
                    let _e1891 = abs(_e298);
                    let _e1892 = abs(_e299);
                    if (abs(_e277) < 1000000000000000f) {
                        if (abs(_e279) < 1000000000000000f) {
                            phi_2739_ = (abs(_e281) < 1000000000000000f);
                            phi_2740_ = false;
                        } else {
                            phi_2739_ = bool();
                            phi_2740_ = true;
                        }
                        let _e1900 = phi_2739_;
                        let _e1902 = phi_2740_;
                        phi_2741_ = _e1900;
                        phi_2742_ = _e1902;
                    } else {
                        phi_2741_ = bool();
                        phi_2742_ = true;
                    }
                    let _e1904 = phi_2741_;
                    let _e1906 = phi_2742_;
                    if _e1906 {
                        phi_2746_ = false;
                    } else {
                        phi_2746_ = _e1904;
                    }
                    let _e1908 = phi_2746_;
                    if _e1908 {
                        if (_e1890 < 1000000000000000f) {
                            if (_e1891 < 1000000000000000f) {
                                phi_2759_ = (_e1892 < 1000000000000000f);
                                phi_2760_ = false;
                            } else {
                                phi_2759_ = bool();
                                phi_2760_ = true;
                            }
                            let _e1913 = phi_2759_;
                            let _e1915 = phi_2760_;
                            phi_2761_ = _e1913;
                            phi_2762_ = _e1915;
                        } else {
                            phi_2761_ = bool();
                            phi_2762_ = true;
                        }
                        let _e1917 = phi_2761_;
                        let _e1919 = phi_2762_;
                        if _e1919 {
                            phi_2766_ = false;
                        } else {
                            phi_2766_ = _e1917;
                        }
                        let _e1921 = phi_2766_;
                        if _e1921 {
                            if (_e1890 > 0f) {
                                phi_2780_ = bool();
                                phi_2781_ = true;
                            } else {
                                let _e1923 = (_e1891 > 0f);
                                if _e1923 {
                                    phi_2779_ = bool();
                                } else {
                                    phi_2779_ = (_e1892 > 0f);
                                }
                                let _e1926 = phi_2779_;
                                phi_2780_ = _e1926;
                                phi_2781_ = _e1923;
                            }
                            let _e1928 = phi_2780_;
                            let _e1930 = phi_2781_;
                            if _e1930 {
                                phi_2785_ = true;
                            } else {
                                phi_2785_ = _e1928;
                            }
                            let _e1932 = phi_2785_;
                            phi_2786_ = _e1932;
                            phi_2787_ = false;
                        } else {
                            phi_2786_ = bool();
                            phi_2787_ = true;
                        }
                        let _e1934 = phi_2786_;
                        let _e1936 = phi_2787_;
                        phi_2788_ = _e1934;
                        phi_2789_ = _e1936;
                    } else {
                        phi_2788_ = bool();
                        phi_2789_ = true;
                    }
                    let _e1938 = phi_2788_;
                    let _e1940 = phi_2789_;
                    if _e1940 {
                        phi_2793_ = false;
                    } else {
                        phi_2793_ = _e1938;
                    }
                    let _e1942 = phi_2793_;
                    if _e1942 {
                        let _e1943 = (0u >= _e91);
                        if _e1943 {
                            phi_4381_ = bool();
                        } else {
                            if (0u < _e91) {
                            } else {
                                return;
                            }
                            let _e1949 = nodes.member[(0u + 0u)].frame[0u];
                            let _e1953 = nodes.member[(0u + 0u)].frame[1u];
                            let _e1957 = nodes.member[(0u + 0u)].frame[2u];
                            let _e1961 = nodes.member[(0u + 0u)].frame[0u];
                            let _e1965 = nodes.member[(0u + 0u)].frame[1u];
                            let _e1969 = nodes.member[(0u + 0u)].frame[2u];
                            let _e1973 = nodes.member[(0u + 0u)].frame[3u];
                            let _e2007 = core_intrinsics_maximum_number_nsz_f32_(abs(_e297), abs(_e298));
                            let _e2008 = core_intrinsics_maximum_number_nsz_f32_(_e2007, abs(_e299));
                            let _e2009 = (_e2008 * 0.0000000000009094947f);
                            if (abs(_e297) < _e2009) {
                                phi_2863_ = _e2009;
                            } else {
                                phi_2863_ = abs(_e297);
                            }
                            let _e2014 = phi_2863_;
                            if (_e297 < 0f) {
                                phi_2870_ = (-1f / _e2014);
                            } else {
                                phi_2870_ = (1f / _e2014);
                            }
                            let _e2019 = phi_2870_;
                            if (abs(_e298) < _e2009) {
                                phi_2877_ = _e2009;
                            } else {
                                phi_2877_ = abs(_e298);
                            }
                            let _e2024 = phi_2877_;
                            if (_e298 < 0f) {
                                phi_2884_ = (-1f / _e2024);
                            } else {
                                phi_2884_ = (1f / _e2024);
                            }
                            let _e2029 = phi_2884_;
                            if (abs(_e299) < _e2009) {
                                phi_2891_ = _e2009;
                            } else {
                                phi_2891_ = abs(_e299);
                            }
                            let _e2034 = phi_2891_;
                            if (_e299 < 0f) {
                                phi_2898_ = (-1f / _e2034);
                            } else {
                                phi_2898_ = (1f / _e2034);
                            }
                            let _e2039 = phi_2898_;
                            let _e2043 = abs((bitcast<f32>(_e1949) - _e277));
                            let _e2044 = abs((bitcast<f32>(_e1953) - _e279));
                            let _e2045 = abs((bitcast<f32>(_e1957) - _e281));
                            let _e2049 = abs(((bitcast<f32>(_e1961) + (bitcast<f32>((((_e1973 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e277));
                            let _e2050 = abs(((bitcast<f32>(_e1965) + (bitcast<f32>((((_e1973 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e279));
                            let _e2051 = abs(((bitcast<f32>(_e1969) + (bitcast<f32>((((_e1973 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e281));
                            if (_e2043 > _e2049) {
                                phi_2915_ = _e2043;
                            } else {
                                phi_2915_ = _e2049;
                            }
                            let _e2054 = phi_2915_;
                            if (_e2044 > _e2050) {
                                phi_2920_ = _e2044;
                            } else {
                                phi_2920_ = _e2050;
                            }
                            let _e2057 = phi_2920_;
                            if (_e2045 > _e2051) {
                                phi_2925_ = _e2045;
                            } else {
                                phi_2925_ = _e2051;
                            }
                            let _e2060 = phi_2925_;
                            if (_e2054 > _e2057) {
                                phi_2930_ = _e2054;
                            } else {
                                phi_2930_ = _e2057;
                            }
                            let _e2063 = phi_2930_;
                            if (_e2063 > _e2060) {
                                phi_2935_ = _e2063;
                            } else {
                                phi_2935_ = _e2060;
                            }
                            let _e2066 = phi_2935_;
                            let _e2070 = (_e2066 * 0.0000019073486f);
                            let _e2071 = (abs(_e2019) * _e2070);
                            let _e2072 = (abs(_e2029) * _e2070);
                            let _e2073 = (abs(_e2039) * _e2070);
                            let _e2077 = (_e2066 * 0.0000009536743f);
                            let _e2078 = (abs(_e2019) * _e2077);
                            let _e2079 = (abs(_e2029) * _e2077);
                            let _e2080 = (abs(_e2039) * _e2077);
                            let _e2081 = abs(_e297);
                            let _e2082 = abs(_e298);
                            let _e2083 = abs(_e299);
                            if (_e2081 >= _e2082) {
                                if (_e2081 >= _e2083) {
                                    phi_2961_ = false;
                                } else {
                                    phi_2961_ = true;
                                }
                                let _e2087 = phi_2961_;
                                phi_2962_ = _e2087;
                            } else {
                                phi_2962_ = true;
                            }
                            let _e2089 = phi_2962_;
                            if _e2089 {
                                if (_e2082 >= _e2083) {
                                    phi_2970_ = 1u;
                                } else {
                                    phi_2970_ = 2u;
                                }
                                let _e2092 = phi_2970_;
                                phi_2971_ = _e2092;
                            } else {
                                phi_2971_ = 0u;
                            }
                            let _e2094 = phi_2971_;
                            if (_e2094 == 0u) {
                                phi_2983_ = vec3<f32>(_e298, _e299, _e297);
                            } else {
                                if (_e2094 == 1u) {
                                    phi_2982_ = vec3<f32>(_e299, _e297, _e298);
                                } else {
                                    phi_2982_ = _e300;
                                }
                                let _e2100 = phi_2982_;
                                phi_2983_ = _e2100;
                            }
                            let _e2102 = phi_2983_;
                            let _e2105 = (_e2102.x / _e2102.z);
                            let _e2108 = (_e2102.y / _e2102.z);
                            if (_e2019 < 0f) {
                                phi_2996_ = 0u;
                            } else {
                                phi_2996_ = 1u;
                            }
                            let _e2113 = phi_2996_;
                            if (_e2029 < 0f) {
                                phi_3001_ = 0u;
                            } else {
                                phi_3001_ = 2u;
                            }
                            let _e2116 = phi_3001_;
                            if (_e2039 < 0f) {
                                phi_3006_ = 0u;
                            } else {
                                phi_3006_ = 4u;
                            }
                            let _e2119 = phi_3006_;
                            let _e2121 = ((_e2113 | _e2116) | _e2119);
                            let _e2122 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                            local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e2122.first[0], _e2122.first[1], _e2122.first[2], _e2122.first[3], _e2122.first[4], _e2122.first[5], _e2122.first[6], _e2122.first[7], _e2122.first[8], _e2122.first[9], _e2122.first[10], _e2122.first[11], _e2122.first[12], _e2122.first[13], _e2122.first[14], _e2122.first[15], _e2122.first[16], _e2122.first[17], _e2122.first[18], _e2122.first[19], _e2122.first[20], _e2122.first[21], _e2122.first[22], _e2122.first[23], _e2122.first[24], _e2122.first[25], _e2122.first[26], _e2122.first[27], _e2122.first[28], _e2122.first[29], _e2122.first[30], _e2122.first[31]), array<u32, 32>(_e2122.mask[0], _e2122.mask[1], _e2122.mask[2], _e2122.mask[3], _e2122.mask[4], _e2122.mask[5], _e2122.mask[6], _e2122.mask[7], _e2122.mask[8], _e2122.mask[9], _e2122.mask[10], _e2122.mask[11], _e2122.mask[12], _e2122.mask[13], _e2122.mask[14], _e2122.mask[15], _e2122.mask[16], _e2122.mask[17], _e2122.mask[18], _e2122.mask[19], _e2122.mask[20], _e2122.mask[21], _e2122.mask[22], _e2122.mask[23], _e2122.mask[24], _e2122.mask[25], _e2122.mask[26], _e2122.mask[27], _e2122.mask[28], _e2122.mask[29], _e2122.mask[30], _e2122.mask[31]), _e2122.len, _e2122.group, _e2122.group_mask);
                            let _e2196 = local_1.group_mask;
                            if ((_e2196 & 4278190080u) == 0u) {
                                let _e2200 = local_1.len;
                                if (_e2200 == 0u) {
                                    phi_3120_ = false;
                                } else {
                                    let _e2204 = local_1.len;
                                    local_1.len = (_e2204 - 1u);
                                    let _e2207 = local_1.len;
                                    if (_e2207 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2212 = local_1.first[(0u + _e2207)];
                                    local_1.group = _e2212;
                                    let _e2215 = local_1.len;
                                    if (_e2215 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2220 = local_1.mask[(0u + _e2215)];
                                    local_1.group_mask = _e2220;
                                    phi_3120_ = true;
                                }
                                let _e2223 = phi_3120_;
                                phi_3121_ = _e2223;
                            } else {
                                phi_3121_ = true;
                            }
                            let _e2225 = phi_3121_;
                            if _e2225 {
                                let _e2227 = local_1.group_mask;
                                let _e2233 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2227)), 32u, (_e2227 == 0u)));
                                let _e2237 = local_1.group_mask;
                                let _e2251 = local_1.group_mask;
                                local_1.group_mask = (_e2251 & ~((1u << bitcast<u32>((_e2233 & 31u)))));
                                let _e2254 = local_1.group;
                                phi_3152_ = (_e2254 + countOneBits(((_e2237 & ~((4294967295u << bitcast<u32>((((_e2233 - 24u) ^ 7u) & 31u))))) & 255u)));
                            } else {
                                phi_3152_ = 4294967295u;
                            }
                            let _e2257 = phi_3152_;
                            phi_3154_ = _e2257;
                            phi_3157_ = false;
                            loop {
                                let _e2259 = phi_3154_;
                                let _e2261 = phi_3157_;
                                local_28 = _e2261;
                                if (_e2259 != 4294967295u) {
                                    if (_e2259 < _e91) {
                                    } else {
                                        return;
                                    }
                                    let _e2268 = nodes.member[(0u + _e2259)].frame[3u];
                                    let _e2293 = (bitcast<f32>((((_e2268 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e2019);
                                    let _e2294 = (bitcast<f32>((((_e2268 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e2029);
                                    let _e2295 = (bitcast<f32>((((_e2268 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e2039);
                                    let _e2298 = nodes.member[(0u + _e2259)].frame[0u];
                                    let _e2302 = nodes.member[(0u + _e2259)].frame[1u];
                                    let _e2306 = nodes.member[(0u + _e2259)].frame[2u];
                                    let _e2311 = ((bitcast<f32>(_e2298) - _e277) * _e2019);
                                    let _e2312 = ((bitcast<f32>(_e2302) - _e279) * _e2029);
                                    let _e2313 = ((bitcast<f32>(_e2306) - _e281) * _e2039);
                                    let _e2321 = nodes.member[(0u + _e2259)].x;
                                    if (_e2019 < 0f) {
                                        let _e2332 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2321.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2338 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2332.unnamed.root, _e2321.w), _e2332.unnamed_1);
                                        let _e2344 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2338.unnamed, lt_bvh_traverse_Tree(_e2321.x, _e2338.unnamed_1.first_primitive));
                                        phi_3237_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2344.unnamed, lt_bvh_traverse_Tree(_e2344.unnamed_1.root, _e2321.y));
                                    } else {
                                        let _e2360 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2321.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2366 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2360.unnamed.root, _e2321.y), _e2360.unnamed_1);
                                        let _e2372 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2366.unnamed, lt_bvh_traverse_Tree(_e2321.z, _e2366.unnamed_1.first_primitive));
                                        phi_3237_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2372.unnamed, lt_bvh_traverse_Tree(_e2372.unnamed_1.root, _e2321.w));
                                    }
                                    let _e2380 = phi_3237_;
                                    let _e2390 = nodes.member[(0u + _e2259)].y;
                                    if (_e2029 < 0f) {
                                        let _e2401 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2390.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2407 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2401.unnamed.root, _e2390.w), _e2401.unnamed_1);
                                        let _e2413 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2407.unnamed, lt_bvh_traverse_Tree(_e2390.x, _e2407.unnamed_1.first_primitive));
                                        phi_3264_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2413.unnamed, lt_bvh_traverse_Tree(_e2413.unnamed_1.root, _e2390.y));
                                    } else {
                                        let _e2429 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2390.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2435 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2429.unnamed.root, _e2390.y), _e2429.unnamed_1);
                                        let _e2441 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2435.unnamed, lt_bvh_traverse_Tree(_e2390.z, _e2435.unnamed_1.first_primitive));
                                        phi_3264_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2441.unnamed, lt_bvh_traverse_Tree(_e2441.unnamed_1.root, _e2390.w));
                                    }
                                    let _e2449 = phi_3264_;
                                    let _e2459 = nodes.member[(0u + _e2259)].z;
                                    if (_e2039 < 0f) {
                                        let _e2470 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2459.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2476 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2470.unnamed.root, _e2459.w), _e2470.unnamed_1);
                                        let _e2482 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2476.unnamed, lt_bvh_traverse_Tree(_e2459.x, _e2476.unnamed_1.first_primitive));
                                        phi_3291_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2482.unnamed, lt_bvh_traverse_Tree(_e2482.unnamed_1.root, _e2459.y));
                                    } else {
                                        let _e2498 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2459.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                        let _e2504 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2498.unnamed.root, _e2459.y), _e2498.unnamed_1);
                                        let _e2510 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2504.unnamed, lt_bvh_traverse_Tree(_e2459.z, _e2504.unnamed_1.first_primitive));
                                        phi_3291_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2510.unnamed, lt_bvh_traverse_Tree(_e2510.unnamed_1.root, _e2459.w));
                                    }
                                    let _e2518 = phi_3291_;
                                    phi_3297_ = 0u;
                                    phi_3300_ = 0u;
                                    loop {
                                        let _e2528 = phi_3297_;
                                        let _e2530 = phi_3300_;
                                        local_11 = _e2530;
                                        local_12 = _e2530;
                                        local_13 = _e2530;
                                        let _e2531 = (_e2528 < 8u);
                                        if _e2531 {
                                            let _e2533 = (_e2528 >> bitcast<u32>(2i));
                                            let _e2534 = (_e2528 & 3u);
                                            if (_e2533 == 0u) {
                                                phi_3314_ = _e2380.unnamed.root;
                                            } else {
                                                phi_3314_ = _e2380.unnamed.first_primitive;
                                            }
                                            let _e2537 = phi_3314_;
                                            if (_e2533 == 0u) {
                                                phi_3324_ = _e2449.unnamed.root;
                                            } else {
                                                phi_3324_ = _e2449.unnamed.first_primitive;
                                            }
                                            let _e2546 = phi_3324_;
                                            if (_e2533 == 0u) {
                                                phi_3334_ = _e2518.unnamed.root;
                                            } else {
                                                phi_3334_ = _e2518.unnamed.first_primitive;
                                            }
                                            let _e2555 = phi_3334_;
                                            let _e2568 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e2537 >> bitcast<u32>(((_e2534 * 8u) & 31u))) & 255u)) * _e2293) + (_e2311 - _e2071)), ((f32(((_e2546 >> bitcast<u32>(((_e2534 * 8u) & 31u))) & 255u)) * _e2294) + (_e2312 - _e2072)));
                                            let _e2569 = core_intrinsics_maximum_number_nsz_f32_(_e2568, ((f32(((_e2555 >> bitcast<u32>(((_e2534 * 8u) & 31u))) & 255u)) * _e2295) + (_e2313 - _e2073)));
                                            if (_e2533 == 0u) {
                                                phi_3352_ = _e2380.unnamed_1.root;
                                            } else {
                                                phi_3352_ = _e2380.unnamed_1.first_primitive;
                                            }
                                            let _e2572 = phi_3352_;
                                            if (_e2533 == 0u) {
                                                phi_3362_ = _e2449.unnamed_1.root;
                                            } else {
                                                phi_3362_ = _e2449.unnamed_1.first_primitive;
                                            }
                                            let _e2581 = phi_3362_;
                                            if (_e2533 == 0u) {
                                                phi_3372_ = _e2518.unnamed_1.root;
                                            } else {
                                                phi_3372_ = _e2518.unnamed_1.first_primitive;
                                            }
                                            let _e2590 = phi_3372_;
                                            let _e2603 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e2572 >> bitcast<u32>(((_e2534 * 8u) & 31u))) & 255u)) * _e2293) + (_e2311 + _e2071)), ((f32(((_e2581 >> bitcast<u32>(((_e2534 * 8u) & 31u))) & 255u)) * _e2294) + (_e2312 + _e2072)));
                                            let _e2604 = core_intrinsics_minimum_number_nsz_f32_(_e2603, ((f32(((_e2590 >> bitcast<u32>(((_e2534 * 8u) & 31u))) & 255u)) * _e2295) + (_e2313 + _e2073)));
                                            if (_e2569 <= _e2604) {
                                                if (_e2569 <= _e289) {
                                                    if (_e2604 >= 0f) {
                                                        if (_e2533 == 0u) {
                                                            let _e2611 = nodes.member[(0u + _e2259)].links[2u];
                                                            phi_3408_ = _e2611;
                                                        } else {
                                                            let _e2614 = nodes.member[(0u + _e2259)].links[3u];
                                                            phi_3408_ = _e2614;
                                                        }
                                                        let _e2616 = phi_3408_;
                                                        let _e2621 = ((_e2616 >> bitcast<u32>(((_e2534 * 8u) & 31u))) & 255u);
                                                        let _e2622 = (_e2621 & 31u);
                                                        if (_e2622 >= 24u) {
                                                            phi_3421_ = (24u + ((_e2622 - 24u) ^ _e2121));
                                                        } else {
                                                            phi_3421_ = _e2622;
                                                        }
                                                        let _e2628 = phi_3421_;
                                                        phi_3426_ = (_e2530 | ((_e2621 >> bitcast<u32>(5i)) << bitcast<u32>((_e2628 & 31u))));
                                                    } else {
                                                        phi_3426_ = _e2530;
                                                    }
                                                    let _e2636 = phi_3426_;
                                                    phi_3427_ = _e2636;
                                                } else {
                                                    phi_3427_ = _e2530;
                                                }
                                                let _e2638 = phi_3427_;
                                                phi_3428_ = _e2638;
                                            } else {
                                                phi_3428_ = _e2530;
                                            }
                                            let _e2640 = phi_3428_;
                                            phi_3298_ = (_e2528 + 1u);
                                            phi_3301_ = _e2640;
                                        } else {
                                            phi_3298_ = u32();
                                            phi_3301_ = u32();
                                        }
                                        let _e2643 = phi_3298_;
                                        let _e2645 = phi_3301_;
                                        continue;
                                        continuing {
                                            phi_3297_ = _e2643;
                                            phi_3300_ = _e2645;
                                            break if !(_e2531);
                                        }
                                    }
                                    let _e2649 = nodes.member[(0u + _e2259)].links[0u];
                                    let _e2653 = nodes.member[(0u + _e2259)].frame[3u];
                                    let _e2657 = local_11;
                                    if ((_e2657 & 4278190080u) == 0u) {
                                    } else {
                                        let _e2661 = local_1.group_mask;
                                        if ((_e2661 & 4278190080u) == 0u) {
                                        } else {
                                            let _e2665 = local_1.len;
                                            if (_e2665 < 32u) {
                                                let _e2668 = local_1.group;
                                                let _e2670 = local_1.len;
                                                if (_e2670 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                local_1.first[(0u + _e2670)] = _e2668;
                                                let _e2676 = local_1.group_mask;
                                                let _e2678 = local_1.len;
                                                if (_e2678 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                local_1.mask[(0u + _e2678)] = _e2676;
                                                let _e2685 = local_1.len;
                                                local_1.len = (_e2685 + 1u);
                                            }
                                        }
                                        local_1.group = (0u + _e2649);
                                        let _e2689 = local_12;
                                        local_1.group_mask = ((_e2689 & 4278190080u) | (_e2653 >> bitcast<u32>(24i)));
                                    }
                                    let _e2694 = local_13;
                                    phi_3486_ = (_e2694 & 16777215u);
                                    phi_3489_ = _e2261;
                                    loop {
                                        let _e2697 = phi_3486_;
                                        let _e2699 = phi_3489_;
                                        local_24 = _e2699;
                                        let _e2700 = (_e2697 == 0u);
                                        local_14 = _e2700;
                                        local_26 = _e2700;
                                        if _e2700 {
                                            phi_3487_ = u32();
                                            phi_3490_ = bool();
                                            phi_4293_ = bool();
                                            phi_4294_ = false;
                                        } else {
                                            let _e2703 = nodes.member[(0u + _e2259)].links[1u];
                                            let _e2708 = ((0u + _e2703) + select(firstTrailingBit(_e2697), 32u, (_e2697 == 0u)));
                                            if (_e2708 < _e94) {
                                            } else {
                                                return;
                                            }
                                            let _e2715 = triangles.member[(0u + _e2708)].v0_;
                                            let _e2717 = (_e2715.x - _e277);
                                            let _e2719 = (_e2715.y - _e279);
                                            let _e2721 = (_e2715.z - _e281);
                                            if (_e2094 == 0u) {
                                                phi_3534_ = vec3<f32>(_e2719, _e2721, _e2717);
                                            } else {
                                                if (_e2094 == 1u) {
                                                    phi_3533_ = vec3<f32>(_e2721, _e2717, _e2719);
                                                } else {
                                                    phi_3533_ = (_e2715 - vec3<f32>(_e277, _e279, _e281));
                                                }
                                                let _e2729 = phi_3533_;
                                                phi_3534_ = _e2729;
                                            }
                                            let _e2731 = phi_3534_;
                                            let _e2735 = (_e2731.x - (_e2105 * _e2731.z));
                                            let _e2739 = (_e2731.y - (_e2108 * _e2731.z));
                                            let _e2741 = triangles.member[(0u + _e2708)].v1_;
                                            let _e2743 = (_e2741.x - _e277);
                                            let _e2745 = (_e2741.y - _e279);
                                            let _e2747 = (_e2741.z - _e281);
                                            if (_e2094 == 0u) {
                                                phi_3564_ = vec3<f32>(_e2745, _e2747, _e2743);
                                            } else {
                                                if (_e2094 == 1u) {
                                                    phi_3563_ = vec3<f32>(_e2747, _e2743, _e2745);
                                                } else {
                                                    phi_3563_ = (_e2741 - vec3<f32>(_e277, _e279, _e281));
                                                }
                                                let _e2755 = phi_3563_;
                                                phi_3564_ = _e2755;
                                            }
                                            let _e2757 = phi_3564_;
                                            let _e2761 = (_e2757.x - (_e2105 * _e2757.z));
                                            let _e2765 = (_e2757.y - (_e2108 * _e2757.z));
                                            let _e2767 = triangles.member[(0u + _e2708)].v2_;
                                            let _e2769 = (_e2767.x - _e277);
                                            let _e2771 = (_e2767.y - _e279);
                                            let _e2773 = (_e2767.z - _e281);
                                            if (_e2094 == 0u) {
                                                phi_3594_ = vec3<f32>(_e2771, _e2773, _e2769);
                                            } else {
                                                if (_e2094 == 1u) {
                                                    phi_3593_ = vec3<f32>(_e2773, _e2769, _e2771);
                                                } else {
                                                    phi_3593_ = (_e2767 - vec3<f32>(_e277, _e279, _e281));
                                                }
                                                let _e2781 = phi_3593_;
                                                phi_3594_ = _e2781;
                                            }
                                            let _e2783 = phi_3594_;
                                            let _e2787 = (_e2783.x - (_e2105 * _e2783.z));
                                            let _e2791 = (_e2783.y - (_e2108 * _e2783.z));
                                            if (_e2761 < _e2787) {
                                                phi_3613_ = true;
                                            } else {
                                                if (_e2761 == _e2787) {
                                                    phi_3612_ = (_e2765 < _e2791);
                                                } else {
                                                    phi_3612_ = false;
                                                }
                                                let _e2796 = phi_3612_;
                                                phi_3613_ = _e2796;
                                            }
                                            let _e2798 = phi_3613_;
                                            if _e2798 {
                                                phi_3617_ = _e2791;
                                                phi_3618_ = _e2787;
                                                phi_3619_ = _e2765;
                                                phi_3620_ = _e2761;
                                            } else {
                                                phi_3617_ = _e2765;
                                                phi_3618_ = _e2761;
                                                phi_3619_ = _e2791;
                                                phi_3620_ = _e2787;
                                            }
                                            let _e2800 = phi_3617_;
                                            let _e2802 = phi_3618_;
                                            let _e2804 = phi_3619_;
                                            let _e2806 = phi_3620_;
                                            let _e2809 = ((_e2806 * _e2800) - (_e2804 * _e2802));
                                            if _e2798 {
                                                phi_3628_ = -(_e2809);
                                            } else {
                                                phi_3628_ = _e2809;
                                            }
                                            let _e2812 = phi_3628_;
                                            if (_e2787 < _e2735) {
                                                phi_3639_ = true;
                                            } else {
                                                if (_e2787 == _e2735) {
                                                    phi_3638_ = (_e2791 < _e2739);
                                                } else {
                                                    phi_3638_ = false;
                                                }
                                                let _e2817 = phi_3638_;
                                                phi_3639_ = _e2817;
                                            }
                                            let _e2819 = phi_3639_;
                                            if _e2819 {
                                                phi_3643_ = _e2739;
                                                phi_3644_ = _e2735;
                                                phi_3645_ = _e2791;
                                                phi_3646_ = _e2787;
                                            } else {
                                                phi_3643_ = _e2791;
                                                phi_3644_ = _e2787;
                                                phi_3645_ = _e2739;
                                                phi_3646_ = _e2735;
                                            }
                                            let _e2821 = phi_3643_;
                                            let _e2823 = phi_3644_;
                                            let _e2825 = phi_3645_;
                                            let _e2827 = phi_3646_;
                                            let _e2830 = ((_e2827 * _e2821) - (_e2825 * _e2823));
                                            if _e2819 {
                                                phi_3654_ = -(_e2830);
                                            } else {
                                                phi_3654_ = _e2830;
                                            }
                                            let _e2833 = phi_3654_;
                                            if (_e2735 < _e2761) {
                                                phi_3665_ = true;
                                            } else {
                                                if (_e2735 == _e2761) {
                                                    phi_3664_ = (_e2739 < _e2765);
                                                } else {
                                                    phi_3664_ = false;
                                                }
                                                let _e2838 = phi_3664_;
                                                phi_3665_ = _e2838;
                                            }
                                            let _e2840 = phi_3665_;
                                            if _e2840 {
                                                phi_3669_ = _e2765;
                                                phi_3670_ = _e2761;
                                                phi_3671_ = _e2739;
                                                phi_3672_ = _e2735;
                                            } else {
                                                phi_3669_ = _e2739;
                                                phi_3670_ = _e2735;
                                                phi_3671_ = _e2765;
                                                phi_3672_ = _e2761;
                                            }
                                            let _e2842 = phi_3669_;
                                            let _e2844 = phi_3670_;
                                            let _e2846 = phi_3671_;
                                            let _e2848 = phi_3672_;
                                            let _e2851 = ((_e2848 * _e2842) - (_e2846 * _e2844));
                                            if _e2840 {
                                                phi_3680_ = -(_e2851);
                                            } else {
                                                phi_3680_ = _e2851;
                                            }
                                            let _e2854 = phi_3680_;
                                            if (_e2812 >= 0f) {
                                                if (_e2833 >= 0f) {
                                                    if (_e2854 >= 0f) {
                                                        phi_3695_ = ((_e2812 + _e2833) + _e2854);
                                                        phi_3696_ = false;
                                                    } else {
                                                        phi_3695_ = f32();
                                                        phi_3696_ = true;
                                                    }
                                                    let _e2861 = phi_3695_;
                                                    let _e2863 = phi_3696_;
                                                    phi_3697_ = _e2861;
                                                    phi_3698_ = _e2863;
                                                } else {
                                                    phi_3697_ = f32();
                                                    phi_3698_ = true;
                                                }
                                                let _e2865 = phi_3697_;
                                                let _e2867 = phi_3698_;
                                                phi_3699_ = _e2865;
                                                phi_3700_ = _e2867;
                                            } else {
                                                phi_3699_ = f32();
                                                phi_3700_ = true;
                                            }
                                            let _e2869 = phi_3699_;
                                            let _e2871 = phi_3700_;
                                            if _e2871 {
                                                if (_e2812 <= 0f) {
                                                    if (_e2833 <= 0f) {
                                                        let _e2874 = (_e2854 <= 0f);
                                                        if _e2874 {
                                                        }
                                                        phi_3718_ = ((_e2812 + _e2833) + _e2854);
                                                        phi_3719_ = false;
                                                        phi_3720_ = _e2874;
                                                    } else {
                                                        phi_3718_ = f32();
                                                        phi_3719_ = true;
                                                        phi_3720_ = false;
                                                    }
                                                    let _e2878 = phi_3718_;
                                                    let _e2880 = phi_3719_;
                                                    let _e2882 = phi_3720_;
                                                    phi_3721_ = _e2878;
                                                    phi_3722_ = _e2880;
                                                    phi_3723_ = _e2882;
                                                } else {
                                                    phi_3721_ = f32();
                                                    phi_3722_ = true;
                                                    phi_3723_ = false;
                                                }
                                                let _e2884 = phi_3721_;
                                                let _e2886 = phi_3722_;
                                                let _e2888 = phi_3723_;
                                                if _e2886 {
                                                    phi_3727_ = false;
                                                } else {
                                                    phi_3727_ = _e2888;
                                                }
                                                let _e2890 = phi_3727_;
                                                phi_3728_ = _e2884;
                                                phi_3729_ = _e2890;
                                            } else {
                                                phi_3728_ = _e2869;
                                                phi_3729_ = true;
                                            }
                                            let _e2892 = phi_3728_;
                                            let _e2894 = phi_3729_;
                                            if _e2894 {
                                                let _e2895 = (_e2892 == 0f);
                                                if _e2895 {
                                                    phi_4045_ = lt_bvh_triangle_Intersection();
                                                    phi_4046_ = false;
                                                } else {
                                                    let _e2897 = triangles.member[(0u + _e2708)].v0_;
                                                    let _e2899 = (_e2897.x - _e277);
                                                    let _e2901 = (_e2897.y - _e279);
                                                    let _e2903 = (_e2897.z - _e281);
                                                    if (_e2094 == 0u) {
                                                        phi_3758_ = vec3<f32>(_e2901, _e2903, _e2899);
                                                    } else {
                                                        if (_e2094 == 1u) {
                                                            phi_3757_ = vec3<f32>(_e2903, _e2899, _e2901);
                                                        } else {
                                                            phi_3757_ = (_e2897 - vec3<f32>(_e277, _e279, _e281));
                                                        }
                                                        let _e2911 = phi_3757_;
                                                        phi_3758_ = _e2911;
                                                    }
                                                    let _e2913 = phi_3758_;
                                                    let _e2915 = triangles.member[(0u + _e2708)].v1_;
                                                    let _e2917 = triangles.member[(0u + _e2708)].v0_;
                                                    let _e2920 = (_e2915.x - _e2917.x);
                                                    let _e2923 = (_e2915.y - _e2917.y);
                                                    let _e2926 = (_e2915.z - _e2917.z);
                                                    if (_e2094 == 0u) {
                                                        phi_3784_ = vec3<f32>(_e2923, _e2926, _e2920);
                                                    } else {
                                                        if (_e2094 == 1u) {
                                                            phi_3783_ = vec3<f32>(_e2926, _e2920, _e2923);
                                                        } else {
                                                            phi_3783_ = (_e2915 - _e2917);
                                                        }
                                                        let _e2933 = phi_3783_;
                                                        phi_3784_ = _e2933;
                                                    }
                                                    let _e2935 = phi_3784_;
                                                    let _e2937 = triangles.member[(0u + _e2708)].v2_;
                                                    let _e2939 = triangles.member[(0u + _e2708)].v0_;
                                                    let _e2942 = (_e2937.x - _e2939.x);
                                                    let _e2945 = (_e2937.y - _e2939.y);
                                                    let _e2948 = (_e2937.z - _e2939.z);
                                                    if (_e2094 == 0u) {
                                                        phi_3810_ = vec3<f32>(_e2945, _e2948, _e2942);
                                                    } else {
                                                        if (_e2094 == 1u) {
                                                            phi_3809_ = vec3<f32>(_e2948, _e2942, _e2945);
                                                        } else {
                                                            phi_3809_ = (_e2937 - _e2939);
                                                        }
                                                        let _e2955 = phi_3809_;
                                                        phi_3810_ = _e2955;
                                                    }
                                                    let _e2957 = phi_3810_;
                                                    let _e2964 = ((_e2935.y * _e2957.z) - (_e2935.z * _e2957.y));
                                                    let _e2971 = ((_e2935.z * _e2957.x) - (_e2935.x * _e2957.z));
                                                    let _e2978 = ((_e2935.x * _e2957.y) - (_e2935.y * _e2957.x));
                                                    let _e2992 = (((1f / _e2102.z) * (((_e2964 * _e2913.x) + (_e2971 * _e2913.y)) + (_e2978 * _e2913.z))) / (((_e2964 * _e2105) + (_e2971 * _e2108)) + _e2978));
                                                    if (_e2992 > 0f) {
                                                        if (_e2992 < _e289) {
                                                            let _e2996 = triangles.member[(0u + _e2708)].v0_;
                                                            let _e2998 = triangles.member[(0u + _e2708)].v1_;
                                                            if (_e2996.x < _e2998.x) {
                                                                phi_3866_ = _e2996.x;
                                                            } else {
                                                                phi_3866_ = _e2998.x;
                                                            }
                                                            let _e3005 = phi_3866_;
                                                            if (_e2996.y < _e2998.y) {
                                                                phi_3875_ = _e2996.y;
                                                            } else {
                                                                phi_3875_ = _e2998.y;
                                                            }
                                                            let _e3012 = phi_3875_;
                                                            if (_e2996.z < _e2998.z) {
                                                                phi_3884_ = _e2996.z;
                                                            } else {
                                                                phi_3884_ = _e2998.z;
                                                            }
                                                            let _e3019 = phi_3884_;
                                                            let _e3021 = triangles.member[(0u + _e2708)].v2_;
                                                            if (_e3005 < _e3021.x) {
                                                                phi_3893_ = _e3005;
                                                            } else {
                                                                phi_3893_ = _e3021.x;
                                                            }
                                                            let _e3026 = phi_3893_;
                                                            if (_e3012 < _e3021.y) {
                                                                phi_3900_ = _e3012;
                                                            } else {
                                                                phi_3900_ = _e3021.y;
                                                            }
                                                            let _e3031 = phi_3900_;
                                                            if (_e3019 < _e3021.z) {
                                                                phi_3907_ = _e3019;
                                                            } else {
                                                                phi_3907_ = _e3021.z;
                                                            }
                                                            let _e3036 = phi_3907_;
                                                            let _e3038 = triangles.member[(0u + _e2708)].v0_;
                                                            let _e3040 = triangles.member[(0u + _e2708)].v1_;
                                                            if (_e3038.x > _e3040.x) {
                                                                phi_3920_ = _e3038.x;
                                                            } else {
                                                                phi_3920_ = _e3040.x;
                                                            }
                                                            let _e3047 = phi_3920_;
                                                            if (_e3038.y > _e3040.y) {
                                                                phi_3929_ = _e3038.y;
                                                            } else {
                                                                phi_3929_ = _e3040.y;
                                                            }
                                                            let _e3054 = phi_3929_;
                                                            if (_e3038.z > _e3040.z) {
                                                                phi_3938_ = _e3038.z;
                                                            } else {
                                                                phi_3938_ = _e3040.z;
                                                            }
                                                            let _e3061 = phi_3938_;
                                                            let _e3063 = triangles.member[(0u + _e2708)].v2_;
                                                            if (_e3047 > _e3063.x) {
                                                                phi_3947_ = _e3047;
                                                            } else {
                                                                phi_3947_ = _e3063.x;
                                                            }
                                                            let _e3068 = phi_3947_;
                                                            if (_e3054 > _e3063.y) {
                                                                phi_3954_ = _e3054;
                                                            } else {
                                                                phi_3954_ = _e3063.y;
                                                            }
                                                            let _e3073 = phi_3954_;
                                                            if (_e3061 > _e3063.z) {
                                                                phi_3961_ = _e3061;
                                                            } else {
                                                                phi_3961_ = _e3063.z;
                                                            }
                                                            let _e3078 = phi_3961_;
                                                            let _e3082 = ((_e3026 - _e277) * _e2019);
                                                            let _e3083 = ((_e3031 - _e279) * _e2029);
                                                            let _e3084 = ((_e3036 - _e281) * _e2039);
                                                            let _e3088 = ((_e3068 - _e277) * _e2019);
                                                            let _e3089 = ((_e3073 - _e279) * _e2029);
                                                            let _e3090 = ((_e3078 - _e281) * _e2039);
                                                            if (_e3082 < _e3088) {
                                                                phi_3978_ = _e3082;
                                                            } else {
                                                                phi_3978_ = _e3088;
                                                            }
                                                            let _e3093 = phi_3978_;
                                                            if (_e3083 < _e3089) {
                                                                phi_3983_ = _e3083;
                                                            } else {
                                                                phi_3983_ = _e3089;
                                                            }
                                                            let _e3096 = phi_3983_;
                                                            if (_e3084 < _e3090) {
                                                                phi_3988_ = _e3084;
                                                            } else {
                                                                phi_3988_ = _e3090;
                                                            }
                                                            let _e3099 = phi_3988_;
                                                            if (_e3082 > _e3088) {
                                                                phi_3996_ = _e3082;
                                                            } else {
                                                                phi_3996_ = _e3088;
                                                            }
                                                            let _e3105 = phi_3996_;
                                                            if (_e3083 > _e3089) {
                                                                phi_4001_ = _e3083;
                                                            } else {
                                                                phi_4001_ = _e3089;
                                                            }
                                                            let _e3108 = phi_4001_;
                                                            if (_e3084 > _e3090) {
                                                                phi_4006_ = _e3084;
                                                            } else {
                                                                phi_4006_ = _e3090;
                                                            }
                                                            let _e3111 = phi_4006_;
                                                            let _e3115 = core_intrinsics_maximum_number_nsz_f32_((_e3093 - _e2078), (_e3096 - _e2079));
                                                            let _e3116 = core_intrinsics_maximum_number_nsz_f32_(_e3115, (_e3099 - _e2080));
                                                            let _e3117 = core_intrinsics_minimum_number_nsz_f32_((_e3105 + _e2078), (_e3108 + _e2079));
                                                            let _e3118 = core_intrinsics_minimum_number_nsz_f32_(_e3117, (_e3111 + _e2080));
                                                            if (_e3116 > -300000000000000000000000000000000000000f) {
                                                                phi_4018_ = _e3116;
                                                            } else {
                                                                phi_4018_ = -300000000000000000000000000000000000000f;
                                                            }
                                                            let _e3121 = phi_4018_;
                                                            if (_e3118 < 300000000000000000000000000000000000000f) {
                                                                phi_4023_ = _e3118;
                                                            } else {
                                                                phi_4023_ = 300000000000000000000000000000000000000f;
                                                            }
                                                            let _e3124 = phi_4023_;
                                                            if (_e2992 < _e3121) {
                                                                phi_4028_ = _e3121;
                                                            } else {
                                                                phi_4028_ = _e2992;
                                                            }
                                                            let _e3127 = phi_4028_;
                                                            if (_e3127 > _e3124) {
                                                                phi_4033_ = _e3124;
                                                            } else {
                                                                phi_4033_ = _e3127;
                                                            }
                                                            let _e3130 = phi_4033_;
                                                            phi_4038_ = lt_bvh_triangle_Intersection(_e3130, (_e2833 / _e2892), (_e2854 / _e2892), (_e3121 <= _e3124));
                                                            phi_4039_ = false;
                                                        } else {
                                                            phi_4038_ = lt_bvh_triangle_Intersection();
                                                            phi_4039_ = true;
                                                        }
                                                        let _e3136 = phi_4038_;
                                                        let _e3138 = phi_4039_;
                                                        phi_4040_ = _e3136;
                                                        phi_4041_ = _e3138;
                                                    } else {
                                                        phi_4040_ = lt_bvh_triangle_Intersection();
                                                        phi_4041_ = true;
                                                    }
                                                    let _e3140 = phi_4040_;
                                                    let _e3142 = phi_4041_;
                                                    if _e3142 {
                                                    }
                                                    phi_4045_ = _e3140;
                                                    phi_4046_ = _e3142;
                                                }
                                                let _e3144 = phi_4045_;
                                                let _e3146 = phi_4046_;
                                                phi_4047_ = _e3144;
                                                phi_4048_ = _e2895;
                                                phi_4049_ = _e3146;
                                            } else {
                                                phi_4047_ = lt_bvh_triangle_Intersection();
                                                phi_4048_ = true;
                                                phi_4049_ = false;
                                            }
                                            let _e3148 = phi_4047_;
                                            let _e3150 = phi_4048_;
                                            let _e3152 = phi_4049_;
                                            if _e3150 {
                                                phi_4053_ = true;
                                            } else {
                                                phi_4053_ = _e3152;
                                            }
                                            let _e3154 = phi_4053_;
                                            if _e3154 {
                                                phi_4057_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                            } else {
                                                phi_4057_ = _e3148;
                                            }
                                            let _e3156 = phi_4057_;
                                            if _e3156.is_hit {
                                                if (_e3156.t > 0f) {
                                                    if (_e3156.t < _e289) {
                                                        let _e3163 = triangles.member[(0u + _e2708)].i0_;
                                                        if ((_e3163 & 2147483648u) == 0u) {
                                                            phi_4276_ = true;
                                                        } else {
                                                            if (_e2708 < _e94) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e3172 = triangles.member[(0u + _e2708)].i0_;
                                                            let _e3173 = (_e3172 & 2147483647u);
                                                            let _e3175 = triangles.member[(0u + _e2708)].i1_;
                                                            let _e3177 = triangles.member[(0u + _e2708)].i2_;
                                                            if (_e3173 < _e104) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e3181 = vertices.member[(0u + _e3173)];
                                                            if (_e3175 < _e104) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e3185 = vertices.member[(0u + _e3175)];
                                                            if (_e3177 < _e104) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e3189 = vertices.member[(0u + _e3177)];
                                                            let _e3190 = array<abi_Vertex, 3>(_e3181, _e3185, _e3189);
                                                            if (_e3190[0].material < _e107) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e3196 = materials.member[(0u + _e3190[0].material)];
                                                            if ((_e3196.flags & 1u) == 1u) {
                                                                let _e3201 = ((1f - _e3156.u) - _e3156.v);
                                                                if (_e3196.cutoff <= 0f) {
                                                                    phi_4274_ = true;
                                                                } else {
                                                                    let _e3228 = (_e3196.base_color.w * ((((f32((_e3190[0].color >> bitcast<u32>(24i))) * _e3201) + (f32((_e3190[1].color >> bitcast<u32>(24i))) * _e3156.u)) + (f32((_e3190[2].color >> bitcast<u32>(24i))) * _e3156.v)) * (1f / 255f)));
                                                                    if (_e3196.alpha_size == 0u) {
                                                                        phi_4271_ = _e3228;
                                                                    } else {
                                                                        local.offset = _e3196.alpha_offset;
                                                                        local.size = _e3196.alpha_size;
                                                                        local.flags = _e3196.flags;
                                                                        let _e3259 = _lt_shaders_texture_TextureView_quad((&local), (((_e3190[0].u * _e3201) + (_e3190[1].u * _e3156.u)) + (_e3190[2].u * _e3156.v)), (((_e3190[0].v * _e3201) + (_e3190[1].v * _e3156.u)) + (_e3190[2].v * _e3156.v)));
                                                                        let _e3263 = (_e3259.indices[0] >> bitcast<u32>(2i));
                                                                        if (_e3263 < _e110) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e3267 = alpha_texels.member[(0u + _e3263)];
                                                                        let _e3283 = (_e3259.indices[1] >> bitcast<u32>(2i));
                                                                        if (_e3283 < _e110) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e3287 = alpha_texels.member[(0u + _e3283)];
                                                                        let _e3304 = (_e3259.indices[2] >> bitcast<u32>(2i));
                                                                        if (_e3304 < _e110) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e3308 = alpha_texels.member[(0u + _e3304)];
                                                                        let _e3325 = (_e3259.indices[3] >> bitcast<u32>(2i));
                                                                        if (_e3325 < _e110) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e3329 = alpha_texels.member[(0u + _e3325)];
                                                                        phi_4271_ = (_e3228 * (((((f32(((_e3267 >> bitcast<u32>((((_e3259.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3259.weights.x) + ((f32(((_e3287 >> bitcast<u32>((((_e3259.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3259.weights.y)) + ((f32(((_e3308 >> bitcast<u32>((((_e3259.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3259.weights.z)) + ((f32(((_e3329 >> bitcast<u32>((((_e3259.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3259.weights.w)));
                                                                    }
                                                                    let _e3345 = phi_4271_;
                                                                    phi_4274_ = (_e3345 >= _e3196.cutoff);
                                                                }
                                                                let _e3349 = phi_4274_;
                                                                phi_4275_ = _e3349;
                                                            } else {
                                                                phi_4275_ = false;
                                                            }
                                                            let _e3351 = phi_4275_;
                                                            phi_4276_ = _e3351;
                                                        }
                                                        let _e3353 = phi_4276_;
                                                        if _e3353 {
                                                            phi_4280_ = false;
                                                        } else {
                                                            phi_4280_ = true;
                                                        }
                                                        let _e3355 = phi_4280_;
                                                        phi_4281_ = _e3353;
                                                        phi_4282_ = _e3353;
                                                        phi_4283_ = _e3355;
                                                    } else {
                                                        phi_4281_ = bool();
                                                        phi_4282_ = _e2699;
                                                        phi_4283_ = true;
                                                    }
                                                    let _e3357 = phi_4281_;
                                                    let _e3359 = phi_4282_;
                                                    let _e3361 = phi_4283_;
                                                    phi_4284_ = _e3357;
                                                    phi_4285_ = _e3359;
                                                    phi_4286_ = _e3361;
                                                } else {
                                                    phi_4284_ = bool();
                                                    phi_4285_ = _e2699;
                                                    phi_4286_ = true;
                                                }
                                                let _e3363 = phi_4284_;
                                                let _e3365 = phi_4285_;
                                                let _e3367 = phi_4286_;
                                                phi_4287_ = _e3363;
                                                phi_4288_ = _e3365;
                                                phi_4289_ = _e3367;
                                            } else {
                                                phi_4287_ = bool();
                                                phi_4288_ = _e2699;
                                                phi_4289_ = true;
                                            }
                                            let _e3369 = phi_4287_;
                                            let _e3371 = phi_4288_;
                                            let _e3373 = phi_4289_;
                                            if _e3373 {
                                            }
                                            phi_3487_ = (_e2697 & (_e2697 - 1u));
                                            phi_3490_ = _e3371;
                                            phi_4293_ = _e3369;
                                            phi_4294_ = _e3373;
                                        }
                                        let _e3375 = phi_3487_;
                                        let _e3377 = phi_3490_;
                                        let _e3379 = phi_4293_;
                                        let _e3381 = phi_4294_;
                                        local_25 = _e3379;
                                        continue;
                                        continuing {
                                            phi_3486_ = _e3375;
                                            phi_3489_ = _e3377;
                                            break if !(_e3381);
                                        }
                                    }
                                    let _e3384 = local_14;
                                    if _e3384 {
                                        let _e3386 = local_1.group_mask;
                                        if ((_e3386 & 4278190080u) == 0u) {
                                            let _e3390 = local_1.len;
                                            if (_e3390 == 0u) {
                                                phi_4336_ = false;
                                            } else {
                                                let _e3394 = local_1.len;
                                                local_1.len = (_e3394 - 1u);
                                                let _e3397 = local_1.len;
                                                if (_e3397 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3402 = local_1.first[(0u + _e3397)];
                                                local_1.group = _e3402;
                                                let _e3405 = local_1.len;
                                                if (_e3405 < 32u) {
                                                } else {
                                                    return;
                                                }
                                                let _e3410 = local_1.mask[(0u + _e3405)];
                                                local_1.group_mask = _e3410;
                                                phi_4336_ = true;
                                            }
                                            let _e3413 = phi_4336_;
                                            phi_4337_ = _e3413;
                                        } else {
                                            phi_4337_ = true;
                                        }
                                        let _e3415 = phi_4337_;
                                        if _e3415 {
                                            let _e3417 = local_1.group_mask;
                                            let _e3423 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e3417)), 32u, (_e3417 == 0u)));
                                            let _e3427 = local_1.group_mask;
                                            let _e3441 = local_1.group_mask;
                                            local_1.group_mask = (_e3441 & ~((1u << bitcast<u32>((_e3423 & 31u)))));
                                            let _e3444 = local_1.group;
                                            phi_4368_ = (_e3444 + countOneBits(((_e3427 & ~((4294967295u << bitcast<u32>((((_e3423 - 24u) ^ _e2121) & 31u))))) & 255u)));
                                        } else {
                                            phi_4368_ = 4294967295u;
                                        }
                                        let _e3447 = phi_4368_;
                                        phi_4369_ = _e3447;
                                    } else {
                                        phi_4369_ = u32();
                                    }
                                    let _e3449 = phi_4369_;
                                    phi_3155_ = _e3449;
                                    let _e3919 = local_24;
                                    phi_3158_ = _e3919;
                                    let _e3922 = local_25;
                                    phi_4370_ = _e3922;
                                    let _e3925 = local_26;
                                    phi_4371_ = _e3925;
                                    phi_4372_ = false;
                                } else {
                                    phi_3155_ = u32();
                                    phi_3158_ = bool();
                                    phi_4370_ = bool();
                                    phi_4371_ = false;
                                    phi_4372_ = true;
                                }
                                let _e3451 = phi_3155_;
                                let _e3453 = phi_3158_;
                                let _e3455 = phi_4370_;
                                let _e3457 = phi_4371_;
                                let _e3459 = phi_4372_;
                                local_15 = _e3459;
                                local_27 = _e3455;
                                continue;
                                continuing {
                                    phi_3154_ = _e3451;
                                    phi_3157_ = _e3453;
                                    break if !(_e3457);
                                }
                            }
                            let _e3462 = local_15;
                            if _e3462 {
                                phi_4376_ = false;
                            } else {
                                phi_4376_ = true;
                            }
                            let _e3464 = phi_4376_;
                            if _e3464 {
                                let _e3931 = local_27;
                                phi_4380_ = _e3931;
                            } else {
                                let _e3933 = local_28;
                                phi_4380_ = _e3933;
                            }
                            let _e3466 = phi_4380_;
                            phi_4381_ = _e3466;
                        }
                        let _e3468 = phi_4381_;
                        phi_4382_ = _e3468;
                        phi_4383_ = _e1943;
                    } else {
                        phi_4382_ = bool();
                        phi_4383_ = true;
                    }
                    let _e3470 = phi_4382_;
                    let _e3472 = phi_4383_;
                    if _e3472 {
                        phi_4387_ = false;
                    } else {
                        phi_4387_ = _e3470;
                    }
                    let _e3474 = phi_4387_;
                    phi_4388_ = _e3474;
                }
                let _e3476 = phi_4388_;
                phi_4389_ = _e3476;
            } else {
                phi_4389_ = false;
            }
            let _e3478 = phi_4389_;
            if _e3478 {
                phi_4393_ = 0f;
            } else {
                phi_4393_ = 1f;
            }
            let _e3480 = phi_4393_;
            phi_4394_ = _e3480;
        }
        let _e3482 = phi_4394_;
        if (_e116.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e116.first_primitive)] = _e3482;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_light_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
