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

struct type_39 {
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

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_21;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_25;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_39;
@group(0) @binding(2) 
var<storage> nodes: type_43;
@group(0) @binding(3) 
var<storage> triangles: type_47;
@group(0) @binding(7) 
var<storage> alpha_texels: type_9;
@group(0) @binding(5) 
var<storage> vertices: type_51;
@group(0) @binding(6) 
var<storage> materials: type_55;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_224_: lt_bvh_traverse_Tree;
    var phi_225_: bool;
    var phi_226_: lt_bvh_traverse_Tree;
    var phi_227_: bool;
    var phi_232_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_224_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_225_ = false;
        } else {
            phi_224_ = lt_bvh_traverse_Tree();
            phi_225_ = true;
        }
        let _e81 = phi_224_;
        let _e83 = phi_225_;
        phi_226_ = _e81;
        phi_227_ = _e83;
    } else {
        phi_226_ = lt_bvh_traverse_Tree();
        phi_227_ = true;
    }
    let _e85 = phi_226_;
    let _e87 = phi_227_;
    if _e87 {
        phi_232_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_232_ = _e85;
    }
    let _e92 = phi_232_;
    return lt_bvh_traverse_Tree(_e92.root, _e92.first_primitive);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_247_: bool;
    var phi_251_: f32;

    if (param_3 != param_3) {
        phi_247_ = true;
    } else {
        let _e71 = (param_4 >= param_3);
        if _e71 {
        }
        phi_247_ = _e71;
    }
    let _e73 = phi_247_;
    if _e73 {
        phi_251_ = param_4;
    } else {
        phi_251_ = param_3;
    }
    let _e75 = phi_251_;
    return _e75;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_263_: bool;
    var phi_267_: f32;

    if (param_5 != param_5) {
        phi_263_ = true;
    } else {
        let _e71 = (param_6 <= param_5);
        if _e71 {
        }
        phi_263_ = _e71;
    }
    let _e73 = phi_263_;
    if _e73 {
        phi_267_ = param_6;
    } else {
        phi_267_ = param_5;
    }
    let _e75 = phi_267_;
    return _e75;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_309_: f32;
    var phi_314_: f32;
    var phi_315_: bool;
    var phi_316_: f32;
    var phi_317_: bool;
    var phi_321_: f32;
    var phi_347_: f32;
    var phi_352_: f32;
    var phi_353_: bool;
    var phi_354_: f32;
    var phi_355_: bool;
    var phi_359_: f32;
    var phi_367_: f32;
    var phi_368_: f32;
    var phi_369_: f32;
    var phi_378_: f32;
    var phi_379_: f32;
    var phi_397_: u32;
    var phi_411_: u32;
    var phi_418_: u32;
    var phi_423_: u32;
    var phi_429_: u32;
    var phi_434_: u32;
    var phi_436_: texture_Axis;
    var phi_464_: f32;
    var phi_469_: f32;
    var phi_470_: bool;
    var phi_471_: f32;
    var phi_472_: bool;
    var phi_476_: f32;
    var phi_502_: f32;
    var phi_507_: f32;
    var phi_508_: bool;
    var phi_509_: f32;
    var phi_510_: bool;
    var phi_514_: f32;
    var phi_522_: f32;
    var phi_523_: f32;
    var phi_524_: f32;
    var phi_533_: f32;
    var phi_534_: f32;
    var phi_552_: u32;
    var phi_566_: u32;
    var phi_573_: u32;
    var phi_578_: u32;
    var phi_584_: u32;
    var phi_589_: u32;
    var phi_591_: texture_Axis;

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
                phi_309_ = 1f;
            } else {
                phi_309_ = 0f;
            }
            let _e102 = phi_309_;
            if (param_8 < 8388608f) {
                phi_314_ = (_e99 - _e102);
                phi_315_ = false;
            } else {
                phi_314_ = f32();
                phi_315_ = true;
            }
            let _e105 = phi_314_;
            let _e107 = phi_315_;
            phi_316_ = _e105;
            phi_317_ = _e107;
        } else {
            phi_316_ = f32();
            phi_317_ = true;
        }
        let _e109 = phi_316_;
        let _e111 = phi_317_;
        if _e111 {
            phi_321_ = param_8;
        } else {
            phi_321_ = _e109;
        }
        let _e113 = phi_321_;
        phi_369_ = (param_8 - _e113);
    } else {
        if (_e86 == 1u) {
            let _e116 = (param_8 * 0.5f);
            if (_e116 > -8388608f) {
                let _e128 = f32(select(0i, select(select(i32(_e116), i32(-2147483648), (_e116 < bitcast<f32>(3472883712u))), 2147483647i, (_e116 > bitcast<f32>(1325400063u))), (_e116 == _e116)));
                if (_e128 > _e116) {
                    phi_347_ = 1f;
                } else {
                    phi_347_ = 0f;
                }
                let _e131 = phi_347_;
                if (_e116 < 8388608f) {
                    phi_352_ = (_e128 - _e131);
                    phi_353_ = false;
                } else {
                    phi_352_ = f32();
                    phi_353_ = true;
                }
                let _e134 = phi_352_;
                let _e136 = phi_353_;
                phi_354_ = _e134;
                phi_355_ = _e136;
            } else {
                phi_354_ = f32();
                phi_355_ = true;
            }
            let _e138 = phi_354_;
            let _e140 = phi_355_;
            if _e140 {
                phi_359_ = _e116;
            } else {
                phi_359_ = _e138;
            }
            let _e142 = phi_359_;
            let _e144 = (param_8 - (2f * _e142));
            if (_e144 > 1f) {
                phi_367_ = (2f - _e144);
            } else {
                phi_367_ = _e144;
            }
            let _e148 = phi_367_;
            phi_368_ = _e148;
        } else {
            phi_368_ = param_8;
        }
        let _e150 = phi_368_;
        phi_369_ = _e150;
    }
    let _e152 = phi_369_;
    if (_e152 > 0f) {
        if (_e152 < 1f) {
            phi_378_ = _e152;
        } else {
            phi_378_ = 1f;
        }
        let _e156 = phi_378_;
        phi_379_ = _e156;
    } else {
        phi_379_ = 0f;
    }
    let _e158 = phi_379_;
    let _e159 = (_e73 - 1u);
    let _e161 = (_e158 * f32(_e73));
    if _e81 {
        let _e168 = select(select(u32(_e161), 0u, (_e161 < bitcast<f32>(0u))), 4294967295u, (_e161 > bitcast<f32>(1333788671u)));
        if (_e159 < _e168) {
            phi_397_ = _e159;
        } else {
            phi_397_ = _e168;
        }
        let _e171 = phi_397_;
        phi_436_ = texture_Axis(_e171, _e171, 0f);
    } else {
        let _e173 = (_e161 + 0.5f);
        let _e180 = select(select(u32(_e173), 0u, (_e173 < bitcast<f32>(0u))), 4294967295u, (_e173 > bitcast<f32>(1333788671u)));
        if (_e73 < _e180) {
            phi_411_ = _e73;
        } else {
            phi_411_ = _e180;
        }
        let _e183 = phi_411_;
        if (_e86 == 0u) {
            phi_418_ = _e159;
        } else {
            phi_418_ = 0u;
        }
        let _e188 = phi_418_;
        if (_e86 == 0u) {
            phi_423_ = 0u;
        } else {
            phi_423_ = _e159;
        }
        let _e191 = phi_423_;
        if (_e183 == 0u) {
            phi_429_ = _e188;
        } else {
            phi_429_ = (_e183 - 1u);
        }
        let _e195 = phi_429_;
        if (_e183 > _e159) {
            phi_434_ = _e191;
        } else {
            phi_434_ = _e183;
        }
        let _e198 = phi_434_;
        phi_436_ = texture_Axis(_e195, _e198, (_e173 - f32(_e183)));
    }
    let _e201 = phi_436_;
    let _e203 = (*param_7).flags;
    let _e206 = ((_e203 >> bitcast<u32>(6u)) & 3u);
    if (_e206 == 0u) {
        if (param_9 > -8388608f) {
            let _e219 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e219 > param_9) {
                phi_464_ = 1f;
            } else {
                phi_464_ = 0f;
            }
            let _e222 = phi_464_;
            if (param_9 < 8388608f) {
                phi_469_ = (_e219 - _e222);
                phi_470_ = false;
            } else {
                phi_469_ = f32();
                phi_470_ = true;
            }
            let _e225 = phi_469_;
            let _e227 = phi_470_;
            phi_471_ = _e225;
            phi_472_ = _e227;
        } else {
            phi_471_ = f32();
            phi_472_ = true;
        }
        let _e229 = phi_471_;
        let _e231 = phi_472_;
        if _e231 {
            phi_476_ = param_9;
        } else {
            phi_476_ = _e229;
        }
        let _e233 = phi_476_;
        phi_524_ = (param_9 - _e233);
    } else {
        if (_e206 == 1u) {
            let _e236 = (param_9 * 0.5f);
            if (_e236 > -8388608f) {
                let _e248 = f32(select(0i, select(select(i32(_e236), i32(-2147483648), (_e236 < bitcast<f32>(3472883712u))), 2147483647i, (_e236 > bitcast<f32>(1325400063u))), (_e236 == _e236)));
                if (_e248 > _e236) {
                    phi_502_ = 1f;
                } else {
                    phi_502_ = 0f;
                }
                let _e251 = phi_502_;
                if (_e236 < 8388608f) {
                    phi_507_ = (_e248 - _e251);
                    phi_508_ = false;
                } else {
                    phi_507_ = f32();
                    phi_508_ = true;
                }
                let _e254 = phi_507_;
                let _e256 = phi_508_;
                phi_509_ = _e254;
                phi_510_ = _e256;
            } else {
                phi_509_ = f32();
                phi_510_ = true;
            }
            let _e258 = phi_509_;
            let _e260 = phi_510_;
            if _e260 {
                phi_514_ = _e236;
            } else {
                phi_514_ = _e258;
            }
            let _e262 = phi_514_;
            let _e264 = (param_9 - (2f * _e262));
            if (_e264 > 1f) {
                phi_522_ = (2f - _e264);
            } else {
                phi_522_ = _e264;
            }
            let _e268 = phi_522_;
            phi_523_ = _e268;
        } else {
            phi_523_ = param_9;
        }
        let _e270 = phi_523_;
        phi_524_ = _e270;
    }
    let _e272 = phi_524_;
    if (_e272 > 0f) {
        if (_e272 < 1f) {
            phi_533_ = _e272;
        } else {
            phi_533_ = 1f;
        }
        let _e276 = phi_533_;
        phi_534_ = _e276;
    } else {
        phi_534_ = 0f;
    }
    let _e278 = phi_534_;
    let _e279 = (_e77 - 1u);
    let _e281 = (_e278 * f32(_e77));
    if _e81 {
        let _e288 = select(select(u32(_e281), 0u, (_e281 < bitcast<f32>(0u))), 4294967295u, (_e281 > bitcast<f32>(1333788671u)));
        if (_e279 < _e288) {
            phi_552_ = _e279;
        } else {
            phi_552_ = _e288;
        }
        let _e291 = phi_552_;
        phi_591_ = texture_Axis(_e291, _e291, 0f);
    } else {
        let _e293 = (_e281 + 0.5f);
        let _e300 = select(select(u32(_e293), 0u, (_e293 < bitcast<f32>(0u))), 4294967295u, (_e293 > bitcast<f32>(1333788671u)));
        if (_e77 < _e300) {
            phi_566_ = _e77;
        } else {
            phi_566_ = _e300;
        }
        let _e303 = phi_566_;
        if (_e206 == 0u) {
            phi_573_ = _e279;
        } else {
            phi_573_ = 0u;
        }
        let _e308 = phi_573_;
        if (_e206 == 0u) {
            phi_578_ = 0u;
        } else {
            phi_578_ = _e279;
        }
        let _e311 = phi_578_;
        if (_e303 == 0u) {
            phi_584_ = _e308;
        } else {
            phi_584_ = (_e303 - 1u);
        }
        let _e315 = phi_584_;
        if (_e303 > _e279) {
            phi_589_ = _e311;
        } else {
            phi_589_ = _e303;
        }
        let _e318 = phi_589_;
        phi_591_ = texture_Axis(_e315, _e318, (_e293 - f32(_e303)));
    }
    let _e321 = phi_591_;
    let _e325 = (*param_7).offset;
    let _e332 = (*param_7).offset;
    let _e339 = (*param_7).offset;
    let _e346 = (*param_7).offset;
    return texture_TexelQuad(array<u32, 4>(((_e325 + (_e321.low * _e73)) + _e201.low), ((_e332 + (_e321.low * _e73)) + _e201.high), ((_e339 + (_e321.high * _e73)) + _e201.low), ((_e346 + (_e321.high * _e73)) + _e201.high)), vec4<f32>(((1f - _e201.fraction) * (1f - _e321.fraction)), (_e201.fraction * (1f - _e321.fraction)), ((1f - _e201.fraction) * _e321.fraction), (_e201.fraction * _e321.fraction)));
}

fn _lt_shaders_abi_Sample_is_valid(param_10: ptr<function, abi_Sample>) -> bool {
    var phi_663_: bool;
    var phi_664_: bool;
    var phi_665_: bool;
    var phi_666_: bool;
    var phi_670_: bool;

    let _e71 = (*param_10).normal[0u];
    let _e73 = global[0u];
    if (_e71 == _e73) {
        let _e76 = (*param_10).normal[1u];
        let _e78 = global[1u];
        if (_e76 == _e78) {
            let _e81 = (*param_10).normal[2u];
            let _e83 = global[2u];
            phi_663_ = (_e81 == _e83);
            phi_664_ = false;
        } else {
            phi_663_ = bool();
            phi_664_ = true;
        }
        let _e86 = phi_663_;
        let _e88 = phi_664_;
        phi_665_ = _e86;
        phi_666_ = _e88;
    } else {
        phi_665_ = bool();
        phi_666_ = true;
    }
    let _e90 = phi_665_;
    let _e92 = phi_666_;
    if _e92 {
        phi_670_ = false;
    } else {
        phi_670_ = _e90;
    }
    let _e94 = phi_670_;
    return !(_e94);
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: abi_Sample;
    var phi_789_: bool;
    var phi_790_: bool;
    var phi_801_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_802_: bool;
    var phi_803_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_804_: bool;
    var phi_811_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_815_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_862_: f32;
    var phi_893_: bool;
    var phi_894_: bool;
    var phi_895_: bool;
    var phi_896_: bool;
    var phi_900_: bool;
    var phi_913_: bool;
    var phi_914_: bool;
    var phi_915_: bool;
    var phi_916_: bool;
    var phi_920_: bool;
    var phi_933_: bool;
    var phi_934_: bool;
    var phi_935_: bool;
    var phi_939_: bool;
    var phi_940_: bool;
    var phi_941_: bool;
    var phi_942_: bool;
    var phi_943_: bool;
    var phi_947_: bool;
    var phi_1017_: f32;
    var phi_1024_: f32;
    var phi_1031_: f32;
    var phi_1038_: f32;
    var phi_1045_: f32;
    var phi_1052_: f32;
    var phi_1069_: f32;
    var phi_1074_: f32;
    var phi_1079_: f32;
    var phi_1084_: f32;
    var phi_1089_: f32;
    var phi_1115_: bool;
    var phi_1116_: bool;
    var phi_1124_: u32;
    var phi_1125_: u32;
    var phi_1136_: vec3<f32>;
    var phi_1137_: vec3<f32>;
    var phi_1150_: u32;
    var phi_1155_: u32;
    var phi_1160_: u32;
    var phi_1274_: bool;
    var phi_1275_: bool;
    var phi_1306_: u32;
    var phi_1308_: u32;
    var phi_1311_: bool;
    var phi_1391_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1418_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1445_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1451_: u32;
    var phi_1454_: u32;
    var phi_1468_: u32;
    var phi_1478_: u32;
    var phi_1488_: u32;
    var phi_1506_: u32;
    var phi_1516_: u32;
    var phi_1526_: u32;
    var phi_1562_: u32;
    var phi_1575_: u32;
    var phi_1580_: u32;
    var phi_1581_: u32;
    var phi_1582_: u32;
    var phi_1452_: u32;
    var phi_1455_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1640_: u32;
    var phi_1643_: bool;
    var phi_1687_: vec3<f32>;
    var phi_1688_: vec3<f32>;
    var phi_1717_: vec3<f32>;
    var phi_1718_: vec3<f32>;
    var phi_1747_: vec3<f32>;
    var phi_1748_: vec3<f32>;
    var phi_1766_: bool;
    var phi_1767_: bool;
    var phi_1771_: f32;
    var phi_1772_: f32;
    var phi_1773_: f32;
    var phi_1774_: f32;
    var phi_1782_: f32;
    var phi_1792_: bool;
    var phi_1793_: bool;
    var phi_1797_: f32;
    var phi_1798_: f32;
    var phi_1799_: f32;
    var phi_1800_: f32;
    var phi_1808_: f32;
    var phi_1818_: bool;
    var phi_1819_: bool;
    var phi_1823_: f32;
    var phi_1824_: f32;
    var phi_1825_: f32;
    var phi_1826_: f32;
    var phi_1834_: f32;
    var phi_1849_: f32;
    var phi_1850_: bool;
    var phi_1851_: f32;
    var phi_1852_: bool;
    var phi_1853_: f32;
    var phi_1854_: bool;
    var phi_1872_: f32;
    var phi_1873_: bool;
    var phi_1874_: bool;
    var phi_1875_: f32;
    var phi_1876_: bool;
    var phi_1877_: bool;
    var phi_1881_: bool;
    var phi_1882_: f32;
    var phi_1883_: bool;
    var phi_1911_: vec3<f32>;
    var phi_1912_: vec3<f32>;
    var phi_1937_: vec3<f32>;
    var phi_1938_: vec3<f32>;
    var phi_1963_: vec3<f32>;
    var phi_1964_: vec3<f32>;
    var phi_2020_: f32;
    var phi_2029_: f32;
    var phi_2038_: f32;
    var phi_2047_: f32;
    var phi_2054_: f32;
    var phi_2061_: f32;
    var phi_2074_: f32;
    var phi_2083_: f32;
    var phi_2092_: f32;
    var phi_2101_: f32;
    var phi_2108_: f32;
    var phi_2115_: f32;
    var phi_2132_: f32;
    var phi_2137_: f32;
    var phi_2142_: f32;
    var phi_2150_: f32;
    var phi_2155_: f32;
    var phi_2160_: f32;
    var phi_2172_: f32;
    var phi_2177_: f32;
    var phi_2182_: f32;
    var phi_2187_: f32;
    var phi_2192_: lt_bvh_triangle_Intersection;
    var phi_2193_: bool;
    var phi_2194_: lt_bvh_triangle_Intersection;
    var phi_2195_: bool;
    var phi_2199_: lt_bvh_triangle_Intersection;
    var phi_2200_: bool;
    var phi_2201_: lt_bvh_triangle_Intersection;
    var phi_2202_: bool;
    var phi_2203_: bool;
    var phi_2207_: bool;
    var phi_2211_: lt_bvh_triangle_Intersection;
    var phi_2425_: f32;
    var phi_2428_: bool;
    var phi_2429_: bool;
    var phi_2430_: bool;
    var phi_2434_: bool;
    var phi_2435_: bool;
    var phi_2436_: bool;
    var phi_2437_: bool;
    var phi_2438_: bool;
    var phi_2439_: bool;
    var phi_2440_: bool;
    var phi_2441_: bool;
    var phi_2442_: bool;
    var phi_2443_: bool;
    var phi_1641_: u32;
    var phi_1644_: bool;
    var phi_2447_: bool;
    var phi_2448_: bool;
    var local_6: bool;
    var phi_2490_: bool;
    var phi_2491_: bool;
    var phi_2522_: u32;
    var phi_2523_: u32;
    var phi_1309_: u32;
    var phi_1312_: bool;
    var phi_2524_: bool;
    var phi_2525_: bool;
    var phi_2526_: bool;
    var local_7: bool;
    var phi_2530_: bool;
    var phi_2534_: bool;
    var phi_2535_: bool;
    var phi_2536_: bool;
    var phi_2537_: bool;
    var phi_2541_: bool;
    var phi_2545_: f32;
    var phi_2546_: f32;
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
    if (bitcast<i32>(_e99.root) != 0i) {
        if (_e99.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e107 = samples.member[(0u + _e99.first_primitive)];
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
                    phi_790_ = true;
                } else {
                    let _e168 = p.member.light.range_squared;
                    if (_e151 <= _e168) {
                        let _e171 = p.member.light.cos_outer;
                        phi_789_ = (-((((_e133 * _e153.x) + (_e134 * _e153.y)) + (_e135 * _e153.z))) >= (_e171 * sqrt(_e151)));
                    } else {
                        phi_789_ = false;
                    }
                    let _e176 = phi_789_;
                    phi_790_ = _e176;
                }
                let _e178 = phi_790_;
                if _e178 {
                    let _e180 = local_2.flags;
                    let _e188 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e194 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e188.unnamed.visibility, false), _e188.unnamed_1);
                    phi_801_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e194.unnamed, ((_e180 & 1u) == 0u));
                    phi_802_ = false;
                } else {
                    phi_801_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_802_ = true;
                }
                let _e199 = phi_801_;
                let _e201 = phi_802_;
                phi_803_ = _e199;
                phi_804_ = _e201;
            } else {
                phi_803_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_804_ = true;
            }
            let _e203 = phi_803_;
            let _e205 = phi_804_;
            if _e205 {
                let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e217 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e211.unnamed.visibility, false), _e211.unnamed_1);
                phi_811_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e217.unnamed, true);
            } else {
                phi_811_ = _e203;
            }
            let _e222 = phi_811_;
            phi_815_ = _e222;
        } else {
            let _e228 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e234 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e228.unnamed.visibility, false), _e228.unnamed_1);
            phi_815_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e234.unnamed, true);
        }
        let _e239 = phi_815_;
        if _e239.unnamed_1 {
            phi_2546_ = _e239.unnamed.visibility;
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
                phi_862_ = 300000000000000000000000000000000000000f;
            } else {
                phi_862_ = 1f;
            }
            let _e269 = phi_862_;
            let _e277 = (_e265.x - (_e259 * _e265.w));
            let _e278 = (_e265.y - (_e261 * _e265.w));
            let _e279 = (_e265.z - (_e263 * _e265.w));
            let _e281 = abs(_e277);
            let _e282 = abs(_e278);
            let _e283 = abs(_e279);
            if (abs(_e259) < 1000000000000000f) {
                if (abs(_e261) < 1000000000000000f) {
                    phi_893_ = (abs(_e263) < 1000000000000000f);
                    phi_894_ = false;
                } else {
                    phi_893_ = bool();
                    phi_894_ = true;
                }
                let _e291 = phi_893_;
                let _e293 = phi_894_;
                phi_895_ = _e291;
                phi_896_ = _e293;
            } else {
                phi_895_ = bool();
                phi_896_ = true;
            }
            let _e295 = phi_895_;
            let _e297 = phi_896_;
            if _e297 {
                phi_900_ = false;
            } else {
                phi_900_ = _e295;
            }
            let _e299 = phi_900_;
            if _e299 {
                if (_e281 < 1000000000000000f) {
                    if (_e282 < 1000000000000000f) {
                        phi_913_ = (_e283 < 1000000000000000f);
                        phi_914_ = false;
                    } else {
                        phi_913_ = bool();
                        phi_914_ = true;
                    }
                    let _e304 = phi_913_;
                    let _e306 = phi_914_;
                    phi_915_ = _e304;
                    phi_916_ = _e306;
                } else {
                    phi_915_ = bool();
                    phi_916_ = true;
                }
                let _e308 = phi_915_;
                let _e310 = phi_916_;
                if _e310 {
                    phi_920_ = false;
                } else {
                    phi_920_ = _e308;
                }
                let _e312 = phi_920_;
                if _e312 {
                    if (_e281 > 0f) {
                        phi_934_ = bool();
                        phi_935_ = true;
                    } else {
                        let _e314 = (_e282 > 0f);
                        if _e314 {
                            phi_933_ = bool();
                        } else {
                            phi_933_ = (_e283 > 0f);
                        }
                        let _e317 = phi_933_;
                        phi_934_ = _e317;
                        phi_935_ = _e314;
                    }
                    let _e319 = phi_934_;
                    let _e321 = phi_935_;
                    if _e321 {
                        phi_939_ = true;
                    } else {
                        phi_939_ = _e319;
                    }
                    let _e323 = phi_939_;
                    phi_940_ = _e323;
                    phi_941_ = false;
                } else {
                    phi_940_ = bool();
                    phi_941_ = true;
                }
                let _e325 = phi_940_;
                let _e327 = phi_941_;
                phi_942_ = _e325;
                phi_943_ = _e327;
            } else {
                phi_942_ = bool();
                phi_943_ = true;
            }
            let _e329 = phi_942_;
            let _e331 = phi_943_;
            if _e331 {
                phi_947_ = false;
            } else {
                phi_947_ = _e329;
            }
            let _e333 = phi_947_;
            if _e333 {
                let _e334 = (0u >= _e78);
                if _e334 {
                    phi_2535_ = bool();
                } else {
                    if (0u < _e78) {
                    } else {
                        return;
                    }
                    let _e340 = nodes.member[(0u + 0u)].frame[0u];
                    let _e344 = nodes.member[(0u + 0u)].frame[1u];
                    let _e348 = nodes.member[(0u + 0u)].frame[2u];
                    let _e352 = nodes.member[(0u + 0u)].frame[0u];
                    let _e356 = nodes.member[(0u + 0u)].frame[1u];
                    let _e360 = nodes.member[(0u + 0u)].frame[2u];
                    let _e364 = nodes.member[(0u + 0u)].frame[3u];
                    let _e398 = core_intrinsics_maximum_number_nsz_f32_(abs(_e277), abs(_e278));
                    let _e399 = core_intrinsics_maximum_number_nsz_f32_(_e398, abs(_e279));
                    let _e400 = (_e399 * 0.0000000000009094947f);
                    if (abs(_e277) < _e400) {
                        phi_1017_ = _e400;
                    } else {
                        phi_1017_ = abs(_e277);
                    }
                    let _e405 = phi_1017_;
                    if (_e277 < 0f) {
                        phi_1024_ = (-1f / _e405);
                    } else {
                        phi_1024_ = (1f / _e405);
                    }
                    let _e410 = phi_1024_;
                    if (abs(_e278) < _e400) {
                        phi_1031_ = _e400;
                    } else {
                        phi_1031_ = abs(_e278);
                    }
                    let _e415 = phi_1031_;
                    if (_e278 < 0f) {
                        phi_1038_ = (-1f / _e415);
                    } else {
                        phi_1038_ = (1f / _e415);
                    }
                    let _e420 = phi_1038_;
                    if (abs(_e279) < _e400) {
                        phi_1045_ = _e400;
                    } else {
                        phi_1045_ = abs(_e279);
                    }
                    let _e425 = phi_1045_;
                    if (_e279 < 0f) {
                        phi_1052_ = (-1f / _e425);
                    } else {
                        phi_1052_ = (1f / _e425);
                    }
                    let _e430 = phi_1052_;
                    let _e434 = abs((bitcast<f32>(_e340) - _e259));
                    let _e435 = abs((bitcast<f32>(_e344) - _e261));
                    let _e436 = abs((bitcast<f32>(_e348) - _e263));
                    let _e440 = abs(((bitcast<f32>(_e352) + (bitcast<f32>((((_e364 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e259));
                    let _e441 = abs(((bitcast<f32>(_e356) + (bitcast<f32>((((_e364 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e261));
                    let _e442 = abs(((bitcast<f32>(_e360) + (bitcast<f32>((((_e364 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e263));
                    if (_e434 > _e440) {
                        phi_1069_ = _e434;
                    } else {
                        phi_1069_ = _e440;
                    }
                    let _e445 = phi_1069_;
                    if (_e435 > _e441) {
                        phi_1074_ = _e435;
                    } else {
                        phi_1074_ = _e441;
                    }
                    let _e448 = phi_1074_;
                    if (_e436 > _e442) {
                        phi_1079_ = _e436;
                    } else {
                        phi_1079_ = _e442;
                    }
                    let _e451 = phi_1079_;
                    if (_e445 > _e448) {
                        phi_1084_ = _e445;
                    } else {
                        phi_1084_ = _e448;
                    }
                    let _e454 = phi_1084_;
                    if (_e454 > _e451) {
                        phi_1089_ = _e454;
                    } else {
                        phi_1089_ = _e451;
                    }
                    let _e457 = phi_1089_;
                    let _e461 = (_e457 * 0.0000019073486f);
                    let _e462 = (abs(_e410) * _e461);
                    let _e463 = (abs(_e420) * _e461);
                    let _e464 = (abs(_e430) * _e461);
                    let _e468 = (_e457 * 0.0000009536743f);
                    let _e469 = (abs(_e410) * _e468);
                    let _e470 = (abs(_e420) * _e468);
                    let _e471 = (abs(_e430) * _e468);
                    let _e472 = abs(_e277);
                    let _e473 = abs(_e278);
                    let _e474 = abs(_e279);
                    if (_e472 >= _e473) {
                        if (_e472 >= _e474) {
                            phi_1115_ = false;
                        } else {
                            phi_1115_ = true;
                        }
                        let _e478 = phi_1115_;
                        phi_1116_ = _e478;
                    } else {
                        phi_1116_ = true;
                    }
                    let _e480 = phi_1116_;
                    if _e480 {
                        if (_e473 >= _e474) {
                            phi_1124_ = 1u;
                        } else {
                            phi_1124_ = 2u;
                        }
                        let _e483 = phi_1124_;
                        phi_1125_ = _e483;
                    } else {
                        phi_1125_ = 0u;
                    }
                    let _e485 = phi_1125_;
                    if (_e485 == 0u) {
                        phi_1137_ = vec3<f32>(_e278, _e279, _e277);
                    } else {
                        if (_e485 == 1u) {
                            phi_1136_ = vec3<f32>(_e279, _e277, _e278);
                        } else {
                            phi_1136_ = vec3<f32>(_e277, _e278, _e279);
                        }
                        let _e491 = phi_1136_;
                        phi_1137_ = _e491;
                    }
                    let _e493 = phi_1137_;
                    let _e496 = (_e493.x / _e493.z);
                    let _e499 = (_e493.y / _e493.z);
                    if (_e410 < 0f) {
                        phi_1150_ = 0u;
                    } else {
                        phi_1150_ = 1u;
                    }
                    let _e504 = phi_1150_;
                    if (_e420 < 0f) {
                        phi_1155_ = 0u;
                    } else {
                        phi_1155_ = 2u;
                    }
                    let _e507 = phi_1155_;
                    if (_e430 < 0f) {
                        phi_1160_ = 0u;
                    } else {
                        phi_1160_ = 4u;
                    }
                    let _e510 = phi_1160_;
                    let _e512 = ((_e504 | _e507) | _e510);
                    let _e513 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e513.first[0], _e513.first[1], _e513.first[2], _e513.first[3], _e513.first[4], _e513.first[5], _e513.first[6], _e513.first[7], _e513.first[8], _e513.first[9], _e513.first[10], _e513.first[11], _e513.first[12], _e513.first[13], _e513.first[14], _e513.first[15], _e513.first[16], _e513.first[17], _e513.first[18], _e513.first[19], _e513.first[20], _e513.first[21], _e513.first[22], _e513.first[23], _e513.first[24], _e513.first[25], _e513.first[26], _e513.first[27], _e513.first[28], _e513.first[29], _e513.first[30], _e513.first[31]), array<u32, 32>(_e513.mask[0], _e513.mask[1], _e513.mask[2], _e513.mask[3], _e513.mask[4], _e513.mask[5], _e513.mask[6], _e513.mask[7], _e513.mask[8], _e513.mask[9], _e513.mask[10], _e513.mask[11], _e513.mask[12], _e513.mask[13], _e513.mask[14], _e513.mask[15], _e513.mask[16], _e513.mask[17], _e513.mask[18], _e513.mask[19], _e513.mask[20], _e513.mask[21], _e513.mask[22], _e513.mask[23], _e513.mask[24], _e513.mask[25], _e513.mask[26], _e513.mask[27], _e513.mask[28], _e513.mask[29], _e513.mask[30], _e513.mask[31]), _e513.len, _e513.group, _e513.group_mask);
                    let _e587 = local_1.group_mask;
                    if ((_e587 & 4278190080u) == 0u) {
                        let _e591 = local_1.len;
                        if (_e591 == 0u) {
                            phi_1274_ = false;
                        } else {
                            let _e595 = local_1.len;
                            local_1.len = (_e595 - 1u);
                            let _e598 = local_1.len;
                            if (_e598 < 32u) {
                            } else {
                                return;
                            }
                            let _e603 = local_1.first[(0u + _e598)];
                            local_1.group = _e603;
                            let _e606 = local_1.len;
                            if (_e606 < 32u) {
                            } else {
                                return;
                            }
                            let _e611 = local_1.mask[(0u + _e606)];
                            local_1.group_mask = _e611;
                            phi_1274_ = true;
                        }
                        let _e614 = phi_1274_;
                        phi_1275_ = _e614;
                    } else {
                        phi_1275_ = true;
                    }
                    let _e616 = phi_1275_;
                    if _e616 {
                        let _e618 = local_1.group_mask;
                        let _e624 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e618)), 32u, (_e618 == 0u)));
                        let _e628 = local_1.group_mask;
                        let _e642 = local_1.group_mask;
                        local_1.group_mask = (_e642 & ~((1u << bitcast<u32>((_e624 & 31u)))));
                        let _e645 = local_1.group;
                        phi_1306_ = (_e645 + countOneBits(((_e628 & ~((4294967295u << bitcast<u32>((((_e624 - 24u) ^ 7u) & 31u))))) & 255u)));
                    } else {
                        phi_1306_ = 4294967295u;
                    }
                    let _e648 = phi_1306_;
                    phi_1308_ = _e648;
                    phi_1311_ = false;
                    loop {
                        let _e650 = phi_1308_;
                        let _e652 = phi_1311_;
                        local_12 = _e652;
                        if (_e650 != 4294967295u) {
                            if (_e650 < _e78) {
                            } else {
                                return;
                            }
                            let _e659 = nodes.member[(0u + _e650)].frame[3u];
                            let _e684 = (bitcast<f32>((((_e659 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e410);
                            let _e685 = (bitcast<f32>((((_e659 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e420);
                            let _e686 = (bitcast<f32>((((_e659 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e430);
                            let _e689 = nodes.member[(0u + _e650)].frame[0u];
                            let _e693 = nodes.member[(0u + _e650)].frame[1u];
                            let _e697 = nodes.member[(0u + _e650)].frame[2u];
                            let _e702 = ((bitcast<f32>(_e689) - _e259) * _e410);
                            let _e703 = ((bitcast<f32>(_e693) - _e261) * _e420);
                            let _e704 = ((bitcast<f32>(_e697) - _e263) * _e430);
                            let _e712 = nodes.member[(0u + _e650)].x;
                            if (_e410 < 0f) {
                                let _e723 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e712.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e729 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e723.unnamed.root, _e712.w), _e723.unnamed_1);
                                let _e735 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e729.unnamed, lt_bvh_traverse_Tree(_e712.x, _e729.unnamed_1.first_primitive));
                                phi_1391_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e735.unnamed, lt_bvh_traverse_Tree(_e735.unnamed_1.root, _e712.y));
                            } else {
                                let _e751 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e712.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e757 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e751.unnamed.root, _e712.y), _e751.unnamed_1);
                                let _e763 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e757.unnamed, lt_bvh_traverse_Tree(_e712.z, _e757.unnamed_1.first_primitive));
                                phi_1391_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e763.unnamed, lt_bvh_traverse_Tree(_e763.unnamed_1.root, _e712.w));
                            }
                            let _e771 = phi_1391_;
                            let _e781 = nodes.member[(0u + _e650)].y;
                            if (_e420 < 0f) {
                                let _e792 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e781.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e798 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e792.unnamed.root, _e781.w), _e792.unnamed_1);
                                let _e804 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e798.unnamed, lt_bvh_traverse_Tree(_e781.x, _e798.unnamed_1.first_primitive));
                                phi_1418_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e804.unnamed, lt_bvh_traverse_Tree(_e804.unnamed_1.root, _e781.y));
                            } else {
                                let _e820 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e781.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e826 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e820.unnamed.root, _e781.y), _e820.unnamed_1);
                                let _e832 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e826.unnamed, lt_bvh_traverse_Tree(_e781.z, _e826.unnamed_1.first_primitive));
                                phi_1418_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e832.unnamed, lt_bvh_traverse_Tree(_e832.unnamed_1.root, _e781.w));
                            }
                            let _e840 = phi_1418_;
                            let _e850 = nodes.member[(0u + _e650)].z;
                            if (_e430 < 0f) {
                                let _e861 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e850.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e867 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e861.unnamed.root, _e850.w), _e861.unnamed_1);
                                let _e873 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e867.unnamed, lt_bvh_traverse_Tree(_e850.x, _e867.unnamed_1.first_primitive));
                                phi_1445_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e873.unnamed, lt_bvh_traverse_Tree(_e873.unnamed_1.root, _e850.y));
                            } else {
                                let _e889 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e850.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e895 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e889.unnamed.root, _e850.y), _e889.unnamed_1);
                                let _e901 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e895.unnamed, lt_bvh_traverse_Tree(_e850.z, _e895.unnamed_1.first_primitive));
                                phi_1445_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e901.unnamed, lt_bvh_traverse_Tree(_e901.unnamed_1.root, _e850.w));
                            }
                            let _e909 = phi_1445_;
                            phi_1451_ = 0u;
                            phi_1454_ = 0u;
                            loop {
                                let _e919 = phi_1451_;
                                let _e921 = phi_1454_;
                                local_3 = _e921;
                                local_4 = _e921;
                                local_5 = _e921;
                                let _e922 = (_e919 < 8u);
                                if _e922 {
                                    let _e924 = (_e919 >> bitcast<u32>(2i));
                                    let _e925 = (_e919 & 3u);
                                    if (_e924 == 0u) {
                                        phi_1468_ = _e771.unnamed.root;
                                    } else {
                                        phi_1468_ = _e771.unnamed.first_primitive;
                                    }
                                    let _e928 = phi_1468_;
                                    if (_e924 == 0u) {
                                        phi_1478_ = _e840.unnamed.root;
                                    } else {
                                        phi_1478_ = _e840.unnamed.first_primitive;
                                    }
                                    let _e937 = phi_1478_;
                                    if (_e924 == 0u) {
                                        phi_1488_ = _e909.unnamed.root;
                                    } else {
                                        phi_1488_ = _e909.unnamed.first_primitive;
                                    }
                                    let _e946 = phi_1488_;
                                    let _e959 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e928 >> bitcast<u32>(((_e925 * 8u) & 31u))) & 255u)) * _e684) + (_e702 - _e462)), ((f32(((_e937 >> bitcast<u32>(((_e925 * 8u) & 31u))) & 255u)) * _e685) + (_e703 - _e463)));
                                    let _e960 = core_intrinsics_maximum_number_nsz_f32_(_e959, ((f32(((_e946 >> bitcast<u32>(((_e925 * 8u) & 31u))) & 255u)) * _e686) + (_e704 - _e464)));
                                    if (_e924 == 0u) {
                                        phi_1506_ = _e771.unnamed_1.root;
                                    } else {
                                        phi_1506_ = _e771.unnamed_1.first_primitive;
                                    }
                                    let _e963 = phi_1506_;
                                    if (_e924 == 0u) {
                                        phi_1516_ = _e840.unnamed_1.root;
                                    } else {
                                        phi_1516_ = _e840.unnamed_1.first_primitive;
                                    }
                                    let _e972 = phi_1516_;
                                    if (_e924 == 0u) {
                                        phi_1526_ = _e909.unnamed_1.root;
                                    } else {
                                        phi_1526_ = _e909.unnamed_1.first_primitive;
                                    }
                                    let _e981 = phi_1526_;
                                    let _e994 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e963 >> bitcast<u32>(((_e925 * 8u) & 31u))) & 255u)) * _e684) + (_e702 + _e462)), ((f32(((_e972 >> bitcast<u32>(((_e925 * 8u) & 31u))) & 255u)) * _e685) + (_e703 + _e463)));
                                    let _e995 = core_intrinsics_minimum_number_nsz_f32_(_e994, ((f32(((_e981 >> bitcast<u32>(((_e925 * 8u) & 31u))) & 255u)) * _e686) + (_e704 + _e464)));
                                    if (_e960 <= _e995) {
                                        if (_e960 <= _e269) {
                                            if (_e995 >= 0f) {
                                                if (_e924 == 0u) {
                                                    let _e1002 = nodes.member[(0u + _e650)].links[2u];
                                                    phi_1562_ = _e1002;
                                                } else {
                                                    let _e1005 = nodes.member[(0u + _e650)].links[3u];
                                                    phi_1562_ = _e1005;
                                                }
                                                let _e1007 = phi_1562_;
                                                let _e1012 = ((_e1007 >> bitcast<u32>(((_e925 * 8u) & 31u))) & 255u);
                                                let _e1013 = (_e1012 & 31u);
                                                if (_e1013 >= 24u) {
                                                    phi_1575_ = (24u + ((_e1013 - 24u) ^ _e512));
                                                } else {
                                                    phi_1575_ = _e1013;
                                                }
                                                let _e1019 = phi_1575_;
                                                phi_1580_ = (_e921 | ((_e1012 >> bitcast<u32>(5i)) << bitcast<u32>((_e1019 & 31u))));
                                            } else {
                                                phi_1580_ = _e921;
                                            }
                                            let _e1027 = phi_1580_;
                                            phi_1581_ = _e1027;
                                        } else {
                                            phi_1581_ = _e921;
                                        }
                                        let _e1029 = phi_1581_;
                                        phi_1582_ = _e1029;
                                    } else {
                                        phi_1582_ = _e921;
                                    }
                                    let _e1031 = phi_1582_;
                                    phi_1452_ = (_e919 + 1u);
                                    phi_1455_ = _e1031;
                                } else {
                                    phi_1452_ = u32();
                                    phi_1455_ = u32();
                                }
                                let _e1034 = phi_1452_;
                                let _e1036 = phi_1455_;
                                continue;
                                continuing {
                                    phi_1451_ = _e1034;
                                    phi_1454_ = _e1036;
                                    break if !(_e922);
                                }
                            }
                            let _e1040 = nodes.member[(0u + _e650)].links[0u];
                            let _e1044 = nodes.member[(0u + _e650)].frame[3u];
                            let _e1048 = local_3;
                            if ((_e1048 & 4278190080u) == 0u) {
                            } else {
                                let _e1052 = local_1.group_mask;
                                if ((_e1052 & 4278190080u) == 0u) {
                                } else {
                                    let _e1056 = local_1.len;
                                    if (_e1056 < 32u) {
                                        let _e1059 = local_1.group;
                                        let _e1061 = local_1.len;
                                        if (_e1061 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_1.first[(0u + _e1061)] = _e1059;
                                        let _e1067 = local_1.group_mask;
                                        let _e1069 = local_1.len;
                                        if (_e1069 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_1.mask[(0u + _e1069)] = _e1067;
                                        let _e1076 = local_1.len;
                                        local_1.len = (_e1076 + 1u);
                                    }
                                }
                                local_1.group = (0u + _e1040);
                                let _e1080 = local_4;
                                local_1.group_mask = ((_e1080 & 4278190080u) | (_e1044 >> bitcast<u32>(24i)));
                            }
                            let _e1085 = local_5;
                            phi_1640_ = (_e1085 & 16777215u);
                            phi_1643_ = _e652;
                            loop {
                                let _e1088 = phi_1640_;
                                let _e1090 = phi_1643_;
                                local_8 = _e1090;
                                let _e1091 = (_e1088 == 0u);
                                local_6 = _e1091;
                                local_10 = _e1091;
                                if _e1091 {
                                    phi_1641_ = u32();
                                    phi_1644_ = bool();
                                    phi_2447_ = bool();
                                    phi_2448_ = false;
                                } else {
                                    let _e1094 = nodes.member[(0u + _e650)].links[1u];
                                    let _e1099 = ((0u + _e1094) + select(firstTrailingBit(_e1088), 32u, (_e1088 == 0u)));
                                    if (_e1099 < _e81) {
                                    } else {
                                        return;
                                    }
                                    let _e1106 = triangles.member[(0u + _e1099)].v0_;
                                    let _e1108 = (_e1106.x - _e259);
                                    let _e1110 = (_e1106.y - _e261);
                                    let _e1112 = (_e1106.z - _e263);
                                    if (_e485 == 0u) {
                                        phi_1688_ = vec3<f32>(_e1110, _e1112, _e1108);
                                    } else {
                                        if (_e485 == 1u) {
                                            phi_1687_ = vec3<f32>(_e1112, _e1108, _e1110);
                                        } else {
                                            phi_1687_ = (_e1106 - vec3<f32>(_e259, _e261, _e263));
                                        }
                                        let _e1120 = phi_1687_;
                                        phi_1688_ = _e1120;
                                    }
                                    let _e1122 = phi_1688_;
                                    let _e1126 = (_e1122.x - (_e496 * _e1122.z));
                                    let _e1130 = (_e1122.y - (_e499 * _e1122.z));
                                    let _e1132 = triangles.member[(0u + _e1099)].v1_;
                                    let _e1134 = (_e1132.x - _e259);
                                    let _e1136 = (_e1132.y - _e261);
                                    let _e1138 = (_e1132.z - _e263);
                                    if (_e485 == 0u) {
                                        phi_1718_ = vec3<f32>(_e1136, _e1138, _e1134);
                                    } else {
                                        if (_e485 == 1u) {
                                            phi_1717_ = vec3<f32>(_e1138, _e1134, _e1136);
                                        } else {
                                            phi_1717_ = (_e1132 - vec3<f32>(_e259, _e261, _e263));
                                        }
                                        let _e1146 = phi_1717_;
                                        phi_1718_ = _e1146;
                                    }
                                    let _e1148 = phi_1718_;
                                    let _e1152 = (_e1148.x - (_e496 * _e1148.z));
                                    let _e1156 = (_e1148.y - (_e499 * _e1148.z));
                                    let _e1158 = triangles.member[(0u + _e1099)].v2_;
                                    let _e1160 = (_e1158.x - _e259);
                                    let _e1162 = (_e1158.y - _e261);
                                    let _e1164 = (_e1158.z - _e263);
                                    if (_e485 == 0u) {
                                        phi_1748_ = vec3<f32>(_e1162, _e1164, _e1160);
                                    } else {
                                        if (_e485 == 1u) {
                                            phi_1747_ = vec3<f32>(_e1164, _e1160, _e1162);
                                        } else {
                                            phi_1747_ = (_e1158 - vec3<f32>(_e259, _e261, _e263));
                                        }
                                        let _e1172 = phi_1747_;
                                        phi_1748_ = _e1172;
                                    }
                                    let _e1174 = phi_1748_;
                                    let _e1178 = (_e1174.x - (_e496 * _e1174.z));
                                    let _e1182 = (_e1174.y - (_e499 * _e1174.z));
                                    if (_e1152 < _e1178) {
                                        phi_1767_ = true;
                                    } else {
                                        if (_e1152 == _e1178) {
                                            phi_1766_ = (_e1156 < _e1182);
                                        } else {
                                            phi_1766_ = false;
                                        }
                                        let _e1187 = phi_1766_;
                                        phi_1767_ = _e1187;
                                    }
                                    let _e1189 = phi_1767_;
                                    if _e1189 {
                                        phi_1771_ = _e1182;
                                        phi_1772_ = _e1178;
                                        phi_1773_ = _e1156;
                                        phi_1774_ = _e1152;
                                    } else {
                                        phi_1771_ = _e1156;
                                        phi_1772_ = _e1152;
                                        phi_1773_ = _e1182;
                                        phi_1774_ = _e1178;
                                    }
                                    let _e1191 = phi_1771_;
                                    let _e1193 = phi_1772_;
                                    let _e1195 = phi_1773_;
                                    let _e1197 = phi_1774_;
                                    let _e1200 = ((_e1197 * _e1191) - (_e1195 * _e1193));
                                    if _e1189 {
                                        phi_1782_ = -(_e1200);
                                    } else {
                                        phi_1782_ = _e1200;
                                    }
                                    let _e1203 = phi_1782_;
                                    if (_e1178 < _e1126) {
                                        phi_1793_ = true;
                                    } else {
                                        if (_e1178 == _e1126) {
                                            phi_1792_ = (_e1182 < _e1130);
                                        } else {
                                            phi_1792_ = false;
                                        }
                                        let _e1208 = phi_1792_;
                                        phi_1793_ = _e1208;
                                    }
                                    let _e1210 = phi_1793_;
                                    if _e1210 {
                                        phi_1797_ = _e1130;
                                        phi_1798_ = _e1126;
                                        phi_1799_ = _e1182;
                                        phi_1800_ = _e1178;
                                    } else {
                                        phi_1797_ = _e1182;
                                        phi_1798_ = _e1178;
                                        phi_1799_ = _e1130;
                                        phi_1800_ = _e1126;
                                    }
                                    let _e1212 = phi_1797_;
                                    let _e1214 = phi_1798_;
                                    let _e1216 = phi_1799_;
                                    let _e1218 = phi_1800_;
                                    let _e1221 = ((_e1218 * _e1212) - (_e1216 * _e1214));
                                    if _e1210 {
                                        phi_1808_ = -(_e1221);
                                    } else {
                                        phi_1808_ = _e1221;
                                    }
                                    let _e1224 = phi_1808_;
                                    if (_e1126 < _e1152) {
                                        phi_1819_ = true;
                                    } else {
                                        if (_e1126 == _e1152) {
                                            phi_1818_ = (_e1130 < _e1156);
                                        } else {
                                            phi_1818_ = false;
                                        }
                                        let _e1229 = phi_1818_;
                                        phi_1819_ = _e1229;
                                    }
                                    let _e1231 = phi_1819_;
                                    if _e1231 {
                                        phi_1823_ = _e1156;
                                        phi_1824_ = _e1152;
                                        phi_1825_ = _e1130;
                                        phi_1826_ = _e1126;
                                    } else {
                                        phi_1823_ = _e1130;
                                        phi_1824_ = _e1126;
                                        phi_1825_ = _e1156;
                                        phi_1826_ = _e1152;
                                    }
                                    let _e1233 = phi_1823_;
                                    let _e1235 = phi_1824_;
                                    let _e1237 = phi_1825_;
                                    let _e1239 = phi_1826_;
                                    let _e1242 = ((_e1239 * _e1233) - (_e1237 * _e1235));
                                    if _e1231 {
                                        phi_1834_ = -(_e1242);
                                    } else {
                                        phi_1834_ = _e1242;
                                    }
                                    let _e1245 = phi_1834_;
                                    if (_e1203 >= 0f) {
                                        if (_e1224 >= 0f) {
                                            if (_e1245 >= 0f) {
                                                phi_1849_ = ((_e1203 + _e1224) + _e1245);
                                                phi_1850_ = false;
                                            } else {
                                                phi_1849_ = f32();
                                                phi_1850_ = true;
                                            }
                                            let _e1252 = phi_1849_;
                                            let _e1254 = phi_1850_;
                                            phi_1851_ = _e1252;
                                            phi_1852_ = _e1254;
                                        } else {
                                            phi_1851_ = f32();
                                            phi_1852_ = true;
                                        }
                                        let _e1256 = phi_1851_;
                                        let _e1258 = phi_1852_;
                                        phi_1853_ = _e1256;
                                        phi_1854_ = _e1258;
                                    } else {
                                        phi_1853_ = f32();
                                        phi_1854_ = true;
                                    }
                                    let _e1260 = phi_1853_;
                                    let _e1262 = phi_1854_;
                                    if _e1262 {
                                        if (_e1203 <= 0f) {
                                            if (_e1224 <= 0f) {
                                                let _e1265 = (_e1245 <= 0f);
                                                if _e1265 {
                                                }
                                                phi_1872_ = ((_e1203 + _e1224) + _e1245);
                                                phi_1873_ = false;
                                                phi_1874_ = _e1265;
                                            } else {
                                                phi_1872_ = f32();
                                                phi_1873_ = true;
                                                phi_1874_ = false;
                                            }
                                            let _e1269 = phi_1872_;
                                            let _e1271 = phi_1873_;
                                            let _e1273 = phi_1874_;
                                            phi_1875_ = _e1269;
                                            phi_1876_ = _e1271;
                                            phi_1877_ = _e1273;
                                        } else {
                                            phi_1875_ = f32();
                                            phi_1876_ = true;
                                            phi_1877_ = false;
                                        }
                                        let _e1275 = phi_1875_;
                                        let _e1277 = phi_1876_;
                                        let _e1279 = phi_1877_;
                                        if _e1277 {
                                            phi_1881_ = false;
                                        } else {
                                            phi_1881_ = _e1279;
                                        }
                                        let _e1281 = phi_1881_;
                                        phi_1882_ = _e1275;
                                        phi_1883_ = _e1281;
                                    } else {
                                        phi_1882_ = _e1260;
                                        phi_1883_ = true;
                                    }
                                    let _e1283 = phi_1882_;
                                    let _e1285 = phi_1883_;
                                    if _e1285 {
                                        let _e1286 = (_e1283 == 0f);
                                        if _e1286 {
                                            phi_2199_ = lt_bvh_triangle_Intersection();
                                            phi_2200_ = false;
                                        } else {
                                            let _e1288 = triangles.member[(0u + _e1099)].v0_;
                                            let _e1290 = (_e1288.x - _e259);
                                            let _e1292 = (_e1288.y - _e261);
                                            let _e1294 = (_e1288.z - _e263);
                                            if (_e485 == 0u) {
                                                phi_1912_ = vec3<f32>(_e1292, _e1294, _e1290);
                                            } else {
                                                if (_e485 == 1u) {
                                                    phi_1911_ = vec3<f32>(_e1294, _e1290, _e1292);
                                                } else {
                                                    phi_1911_ = (_e1288 - vec3<f32>(_e259, _e261, _e263));
                                                }
                                                let _e1302 = phi_1911_;
                                                phi_1912_ = _e1302;
                                            }
                                            let _e1304 = phi_1912_;
                                            let _e1306 = triangles.member[(0u + _e1099)].v1_;
                                            let _e1308 = triangles.member[(0u + _e1099)].v0_;
                                            let _e1311 = (_e1306.x - _e1308.x);
                                            let _e1314 = (_e1306.y - _e1308.y);
                                            let _e1317 = (_e1306.z - _e1308.z);
                                            if (_e485 == 0u) {
                                                phi_1938_ = vec3<f32>(_e1314, _e1317, _e1311);
                                            } else {
                                                if (_e485 == 1u) {
                                                    phi_1937_ = vec3<f32>(_e1317, _e1311, _e1314);
                                                } else {
                                                    phi_1937_ = (_e1306 - _e1308);
                                                }
                                                let _e1324 = phi_1937_;
                                                phi_1938_ = _e1324;
                                            }
                                            let _e1326 = phi_1938_;
                                            let _e1328 = triangles.member[(0u + _e1099)].v2_;
                                            let _e1330 = triangles.member[(0u + _e1099)].v0_;
                                            let _e1333 = (_e1328.x - _e1330.x);
                                            let _e1336 = (_e1328.y - _e1330.y);
                                            let _e1339 = (_e1328.z - _e1330.z);
                                            if (_e485 == 0u) {
                                                phi_1964_ = vec3<f32>(_e1336, _e1339, _e1333);
                                            } else {
                                                if (_e485 == 1u) {
                                                    phi_1963_ = vec3<f32>(_e1339, _e1333, _e1336);
                                                } else {
                                                    phi_1963_ = (_e1328 - _e1330);
                                                }
                                                let _e1346 = phi_1963_;
                                                phi_1964_ = _e1346;
                                            }
                                            let _e1348 = phi_1964_;
                                            let _e1355 = ((_e1326.y * _e1348.z) - (_e1326.z * _e1348.y));
                                            let _e1362 = ((_e1326.z * _e1348.x) - (_e1326.x * _e1348.z));
                                            let _e1369 = ((_e1326.x * _e1348.y) - (_e1326.y * _e1348.x));
                                            let _e1383 = (((1f / _e493.z) * (((_e1355 * _e1304.x) + (_e1362 * _e1304.y)) + (_e1369 * _e1304.z))) / (((_e1355 * _e496) + (_e1362 * _e499)) + _e1369));
                                            if (_e1383 > 0f) {
                                                if (_e1383 < _e269) {
                                                    let _e1387 = triangles.member[(0u + _e1099)].v0_;
                                                    let _e1389 = triangles.member[(0u + _e1099)].v1_;
                                                    if (_e1387.x < _e1389.x) {
                                                        phi_2020_ = _e1387.x;
                                                    } else {
                                                        phi_2020_ = _e1389.x;
                                                    }
                                                    let _e1396 = phi_2020_;
                                                    if (_e1387.y < _e1389.y) {
                                                        phi_2029_ = _e1387.y;
                                                    } else {
                                                        phi_2029_ = _e1389.y;
                                                    }
                                                    let _e1403 = phi_2029_;
                                                    if (_e1387.z < _e1389.z) {
                                                        phi_2038_ = _e1387.z;
                                                    } else {
                                                        phi_2038_ = _e1389.z;
                                                    }
                                                    let _e1410 = phi_2038_;
                                                    let _e1412 = triangles.member[(0u + _e1099)].v2_;
                                                    if (_e1396 < _e1412.x) {
                                                        phi_2047_ = _e1396;
                                                    } else {
                                                        phi_2047_ = _e1412.x;
                                                    }
                                                    let _e1417 = phi_2047_;
                                                    if (_e1403 < _e1412.y) {
                                                        phi_2054_ = _e1403;
                                                    } else {
                                                        phi_2054_ = _e1412.y;
                                                    }
                                                    let _e1422 = phi_2054_;
                                                    if (_e1410 < _e1412.z) {
                                                        phi_2061_ = _e1410;
                                                    } else {
                                                        phi_2061_ = _e1412.z;
                                                    }
                                                    let _e1427 = phi_2061_;
                                                    let _e1429 = triangles.member[(0u + _e1099)].v0_;
                                                    let _e1431 = triangles.member[(0u + _e1099)].v1_;
                                                    if (_e1429.x > _e1431.x) {
                                                        phi_2074_ = _e1429.x;
                                                    } else {
                                                        phi_2074_ = _e1431.x;
                                                    }
                                                    let _e1438 = phi_2074_;
                                                    if (_e1429.y > _e1431.y) {
                                                        phi_2083_ = _e1429.y;
                                                    } else {
                                                        phi_2083_ = _e1431.y;
                                                    }
                                                    let _e1445 = phi_2083_;
                                                    if (_e1429.z > _e1431.z) {
                                                        phi_2092_ = _e1429.z;
                                                    } else {
                                                        phi_2092_ = _e1431.z;
                                                    }
                                                    let _e1452 = phi_2092_;
                                                    let _e1454 = triangles.member[(0u + _e1099)].v2_;
                                                    if (_e1438 > _e1454.x) {
                                                        phi_2101_ = _e1438;
                                                    } else {
                                                        phi_2101_ = _e1454.x;
                                                    }
                                                    let _e1459 = phi_2101_;
                                                    if (_e1445 > _e1454.y) {
                                                        phi_2108_ = _e1445;
                                                    } else {
                                                        phi_2108_ = _e1454.y;
                                                    }
                                                    let _e1464 = phi_2108_;
                                                    if (_e1452 > _e1454.z) {
                                                        phi_2115_ = _e1452;
                                                    } else {
                                                        phi_2115_ = _e1454.z;
                                                    }
                                                    let _e1469 = phi_2115_;
                                                    let _e1473 = ((_e1417 - _e259) * _e410);
                                                    let _e1474 = ((_e1422 - _e261) * _e420);
                                                    let _e1475 = ((_e1427 - _e263) * _e430);
                                                    let _e1479 = ((_e1459 - _e259) * _e410);
                                                    let _e1480 = ((_e1464 - _e261) * _e420);
                                                    let _e1481 = ((_e1469 - _e263) * _e430);
                                                    if (_e1473 < _e1479) {
                                                        phi_2132_ = _e1473;
                                                    } else {
                                                        phi_2132_ = _e1479;
                                                    }
                                                    let _e1484 = phi_2132_;
                                                    if (_e1474 < _e1480) {
                                                        phi_2137_ = _e1474;
                                                    } else {
                                                        phi_2137_ = _e1480;
                                                    }
                                                    let _e1487 = phi_2137_;
                                                    if (_e1475 < _e1481) {
                                                        phi_2142_ = _e1475;
                                                    } else {
                                                        phi_2142_ = _e1481;
                                                    }
                                                    let _e1490 = phi_2142_;
                                                    if (_e1473 > _e1479) {
                                                        phi_2150_ = _e1473;
                                                    } else {
                                                        phi_2150_ = _e1479;
                                                    }
                                                    let _e1496 = phi_2150_;
                                                    if (_e1474 > _e1480) {
                                                        phi_2155_ = _e1474;
                                                    } else {
                                                        phi_2155_ = _e1480;
                                                    }
                                                    let _e1499 = phi_2155_;
                                                    if (_e1475 > _e1481) {
                                                        phi_2160_ = _e1475;
                                                    } else {
                                                        phi_2160_ = _e1481;
                                                    }
                                                    let _e1502 = phi_2160_;
                                                    let _e1506 = core_intrinsics_maximum_number_nsz_f32_((_e1484 - _e469), (_e1487 - _e470));
                                                    let _e1507 = core_intrinsics_maximum_number_nsz_f32_(_e1506, (_e1490 - _e471));
                                                    let _e1508 = core_intrinsics_minimum_number_nsz_f32_((_e1496 + _e469), (_e1499 + _e470));
                                                    let _e1509 = core_intrinsics_minimum_number_nsz_f32_(_e1508, (_e1502 + _e471));
                                                    if (_e1507 > -300000000000000000000000000000000000000f) {
                                                        phi_2172_ = _e1507;
                                                    } else {
                                                        phi_2172_ = -300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1512 = phi_2172_;
                                                    if (_e1509 < 300000000000000000000000000000000000000f) {
                                                        phi_2177_ = _e1509;
                                                    } else {
                                                        phi_2177_ = 300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1515 = phi_2177_;
                                                    if (_e1383 < _e1512) {
                                                        phi_2182_ = _e1512;
                                                    } else {
                                                        phi_2182_ = _e1383;
                                                    }
                                                    let _e1518 = phi_2182_;
                                                    if (_e1518 > _e1515) {
                                                        phi_2187_ = _e1515;
                                                    } else {
                                                        phi_2187_ = _e1518;
                                                    }
                                                    let _e1521 = phi_2187_;
                                                    phi_2192_ = lt_bvh_triangle_Intersection(_e1521, (_e1224 / _e1283), (_e1245 / _e1283), (_e1512 <= _e1515));
                                                    phi_2193_ = false;
                                                } else {
                                                    phi_2192_ = lt_bvh_triangle_Intersection();
                                                    phi_2193_ = true;
                                                }
                                                let _e1527 = phi_2192_;
                                                let _e1529 = phi_2193_;
                                                phi_2194_ = _e1527;
                                                phi_2195_ = _e1529;
                                            } else {
                                                phi_2194_ = lt_bvh_triangle_Intersection();
                                                phi_2195_ = true;
                                            }
                                            let _e1531 = phi_2194_;
                                            let _e1533 = phi_2195_;
                                            if _e1533 {
                                            }
                                            phi_2199_ = _e1531;
                                            phi_2200_ = _e1533;
                                        }
                                        let _e1535 = phi_2199_;
                                        let _e1537 = phi_2200_;
                                        phi_2201_ = _e1535;
                                        phi_2202_ = _e1286;
                                        phi_2203_ = _e1537;
                                    } else {
                                        phi_2201_ = lt_bvh_triangle_Intersection();
                                        phi_2202_ = true;
                                        phi_2203_ = false;
                                    }
                                    let _e1539 = phi_2201_;
                                    let _e1541 = phi_2202_;
                                    let _e1543 = phi_2203_;
                                    if _e1541 {
                                        phi_2207_ = true;
                                    } else {
                                        phi_2207_ = _e1543;
                                    }
                                    let _e1545 = phi_2207_;
                                    if _e1545 {
                                        phi_2211_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                    } else {
                                        phi_2211_ = _e1539;
                                    }
                                    let _e1547 = phi_2211_;
                                    if _e1547.is_hit {
                                        if (_e1547.t > 0f) {
                                            if (_e1547.t < _e269) {
                                                let _e1554 = triangles.member[(0u + _e1099)].i0_;
                                                if ((_e1554 & 2147483648u) == 0u) {
                                                    phi_2430_ = true;
                                                } else {
                                                    if (_e1099 < _e81) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1563 = triangles.member[(0u + _e1099)].i0_;
                                                    let _e1564 = (_e1563 & 2147483647u);
                                                    let _e1566 = triangles.member[(0u + _e1099)].i1_;
                                                    let _e1568 = triangles.member[(0u + _e1099)].i2_;
                                                    if (_e1564 < _e87) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1572 = vertices.member[(0u + _e1564)];
                                                    if (_e1566 < _e87) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1576 = vertices.member[(0u + _e1566)];
                                                    if (_e1568 < _e87) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1580 = vertices.member[(0u + _e1568)];
                                                    let _e1581 = array<abi_Vertex, 3>(_e1572, _e1576, _e1580);
                                                    if (_e1581[0].material < arrayLength((&materials.member))) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1587 = materials.member[(0u + _e1581[0].material)];
                                                    if ((_e1587.flags & 1u) == 1u) {
                                                        let _e1592 = ((1f - _e1547.u) - _e1547.v);
                                                        if (_e1587.cutoff <= 0f) {
                                                            phi_2428_ = true;
                                                        } else {
                                                            let _e1619 = (_e1587.base_color.w * ((((f32((_e1581[0].color >> bitcast<u32>(24i))) * _e1592) + (f32((_e1581[1].color >> bitcast<u32>(24i))) * _e1547.u)) + (f32((_e1581[2].color >> bitcast<u32>(24i))) * _e1547.v)) * (1f / 255f)));
                                                            if (_e1587.alpha_size == 0u) {
                                                                phi_2425_ = _e1619;
                                                            } else {
                                                                local.offset = _e1587.alpha_offset;
                                                                local.size = _e1587.alpha_size;
                                                                local.flags = _e1587.flags;
                                                                let _e1650 = _lt_shaders_texture_TextureView_quad((&local), (((_e1581[0].u * _e1592) + (_e1581[1].u * _e1547.u)) + (_e1581[2].u * _e1547.v)), (((_e1581[0].v * _e1592) + (_e1581[1].v * _e1547.u)) + (_e1581[2].v * _e1547.v)));
                                                                let _e1654 = (_e1650.indices[0] >> bitcast<u32>(2i));
                                                                if (_e1654 < _e93) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1658 = alpha_texels.member[(0u + _e1654)];
                                                                let _e1674 = (_e1650.indices[1] >> bitcast<u32>(2i));
                                                                if (_e1674 < _e93) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1678 = alpha_texels.member[(0u + _e1674)];
                                                                let _e1695 = (_e1650.indices[2] >> bitcast<u32>(2i));
                                                                if (_e1695 < _e93) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1699 = alpha_texels.member[(0u + _e1695)];
                                                                let _e1716 = (_e1650.indices[3] >> bitcast<u32>(2i));
                                                                if (_e1716 < _e93) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1720 = alpha_texels.member[(0u + _e1716)];
                                                                phi_2425_ = (_e1619 * (((((f32(((_e1658 >> bitcast<u32>((((_e1650.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1650.weights.x) + ((f32(((_e1678 >> bitcast<u32>((((_e1650.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1650.weights.y)) + ((f32(((_e1699 >> bitcast<u32>((((_e1650.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1650.weights.z)) + ((f32(((_e1720 >> bitcast<u32>((((_e1650.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1650.weights.w)));
                                                            }
                                                            let _e1736 = phi_2425_;
                                                            phi_2428_ = (_e1736 >= _e1587.cutoff);
                                                        }
                                                        let _e1740 = phi_2428_;
                                                        phi_2429_ = _e1740;
                                                    } else {
                                                        phi_2429_ = false;
                                                    }
                                                    let _e1742 = phi_2429_;
                                                    phi_2430_ = _e1742;
                                                }
                                                let _e1744 = phi_2430_;
                                                if _e1744 {
                                                    phi_2434_ = false;
                                                } else {
                                                    phi_2434_ = true;
                                                }
                                                let _e1746 = phi_2434_;
                                                phi_2435_ = _e1744;
                                                phi_2436_ = _e1744;
                                                phi_2437_ = _e1746;
                                            } else {
                                                phi_2435_ = bool();
                                                phi_2436_ = _e1090;
                                                phi_2437_ = true;
                                            }
                                            let _e1748 = phi_2435_;
                                            let _e1750 = phi_2436_;
                                            let _e1752 = phi_2437_;
                                            phi_2438_ = _e1748;
                                            phi_2439_ = _e1750;
                                            phi_2440_ = _e1752;
                                        } else {
                                            phi_2438_ = bool();
                                            phi_2439_ = _e1090;
                                            phi_2440_ = true;
                                        }
                                        let _e1754 = phi_2438_;
                                        let _e1756 = phi_2439_;
                                        let _e1758 = phi_2440_;
                                        phi_2441_ = _e1754;
                                        phi_2442_ = _e1756;
                                        phi_2443_ = _e1758;
                                    } else {
                                        phi_2441_ = bool();
                                        phi_2442_ = _e1090;
                                        phi_2443_ = true;
                                    }
                                    let _e1760 = phi_2441_;
                                    let _e1762 = phi_2442_;
                                    let _e1764 = phi_2443_;
                                    if _e1764 {
                                    }
                                    phi_1641_ = (_e1088 & (_e1088 - 1u));
                                    phi_1644_ = _e1762;
                                    phi_2447_ = _e1760;
                                    phi_2448_ = _e1764;
                                }
                                let _e1766 = phi_1641_;
                                let _e1768 = phi_1644_;
                                let _e1770 = phi_2447_;
                                let _e1772 = phi_2448_;
                                local_9 = _e1770;
                                continue;
                                continuing {
                                    phi_1640_ = _e1766;
                                    phi_1643_ = _e1768;
                                    break if !(_e1772);
                                }
                            }
                            let _e1775 = local_6;
                            if _e1775 {
                                let _e1777 = local_1.group_mask;
                                if ((_e1777 & 4278190080u) == 0u) {
                                    let _e1781 = local_1.len;
                                    if (_e1781 == 0u) {
                                        phi_2490_ = false;
                                    } else {
                                        let _e1785 = local_1.len;
                                        local_1.len = (_e1785 - 1u);
                                        let _e1788 = local_1.len;
                                        if (_e1788 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1793 = local_1.first[(0u + _e1788)];
                                        local_1.group = _e1793;
                                        let _e1796 = local_1.len;
                                        if (_e1796 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1801 = local_1.mask[(0u + _e1796)];
                                        local_1.group_mask = _e1801;
                                        phi_2490_ = true;
                                    }
                                    let _e1804 = phi_2490_;
                                    phi_2491_ = _e1804;
                                } else {
                                    phi_2491_ = true;
                                }
                                let _e1806 = phi_2491_;
                                if _e1806 {
                                    let _e1808 = local_1.group_mask;
                                    let _e1814 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1808)), 32u, (_e1808 == 0u)));
                                    let _e1818 = local_1.group_mask;
                                    let _e1832 = local_1.group_mask;
                                    local_1.group_mask = (_e1832 & ~((1u << bitcast<u32>((_e1814 & 31u)))));
                                    let _e1835 = local_1.group;
                                    phi_2522_ = (_e1835 + countOneBits(((_e1818 & ~((4294967295u << bitcast<u32>((((_e1814 - 24u) ^ _e512) & 31u))))) & 255u)));
                                } else {
                                    phi_2522_ = 4294967295u;
                                }
                                let _e1838 = phi_2522_;
                                phi_2523_ = _e1838;
                            } else {
                                phi_2523_ = u32();
                            }
                            let _e1840 = phi_2523_;
                            phi_1309_ = _e1840;
                            let _e2056 = local_8;
                            phi_1312_ = _e2056;
                            let _e2059 = local_9;
                            phi_2524_ = _e2059;
                            let _e2062 = local_10;
                            phi_2525_ = _e2062;
                            phi_2526_ = false;
                        } else {
                            phi_1309_ = u32();
                            phi_1312_ = bool();
                            phi_2524_ = bool();
                            phi_2525_ = false;
                            phi_2526_ = true;
                        }
                        let _e1842 = phi_1309_;
                        let _e1844 = phi_1312_;
                        let _e1846 = phi_2524_;
                        let _e1848 = phi_2525_;
                        let _e1850 = phi_2526_;
                        local_7 = _e1850;
                        local_11 = _e1846;
                        continue;
                        continuing {
                            phi_1308_ = _e1842;
                            phi_1311_ = _e1844;
                            break if !(_e1848);
                        }
                    }
                    let _e1853 = local_7;
                    if _e1853 {
                        phi_2530_ = false;
                    } else {
                        phi_2530_ = true;
                    }
                    let _e1855 = phi_2530_;
                    if _e1855 {
                        let _e2068 = local_11;
                        phi_2534_ = _e2068;
                    } else {
                        let _e2070 = local_12;
                        phi_2534_ = _e2070;
                    }
                    let _e1857 = phi_2534_;
                    phi_2535_ = _e1857;
                }
                let _e1859 = phi_2535_;
                phi_2536_ = _e1859;
                phi_2537_ = _e334;
            } else {
                phi_2536_ = bool();
                phi_2537_ = true;
            }
            let _e1861 = phi_2536_;
            let _e1863 = phi_2537_;
            if _e1863 {
                phi_2541_ = false;
            } else {
                phi_2541_ = _e1861;
            }
            let _e1865 = phi_2541_;
            if _e1865 {
                phi_2545_ = 0f;
            } else {
                phi_2545_ = 1f;
            }
            let _e1867 = phi_2545_;
            phi_2546_ = _e1867;
        }
        let _e1869 = phi_2546_;
        if (_e99.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e99.first_primitive)] = _e1869;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
