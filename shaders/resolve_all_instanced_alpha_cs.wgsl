struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    pad: vec2<u32>,
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

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
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

struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct lt_bvh_Triangle {
    v0_: vec3<f32>,
    i0_: u32,
    v1_: vec3<f32>,
    i1_: u32,
    v2_: vec3<f32>,
    i2_: u32,
}

struct type_37 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_41 {
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
    pad: vec2<u32>,
}

struct type_45 {
    member: array<abi_Material>,
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

struct type_56 {
    member: array<lt_bvh_Instance>,
}

struct lt_bvh_traverse_Stack {
    first: array<u32, 32>,
    mask: array<u32, 32>,
    len: u32,
    group: u32,
    group_mask: u32,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_65 {
    member: array<lt_bvh_Node>,
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

struct abi_ShadowParams {
    projection: lt_math_LightProjection,
    light: abi_LightParams,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_73 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_73;
@group(0) @binding(2) 
var<storage> nodes: type_65;
@group(0) @binding(3) 
var<storage> triangles: type_37;
@group(0) @binding(6) 
var<storage> vertices: type_41;
@group(0) @binding(7) 
var<storage> materials: type_45;
@group(0) @binding(8) 
var<storage> alpha_texels: type_13;
@group(0) @binding(5) 
var<storage> instances: type_56;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_234_: lt_bvh_traverse_Tree;
    var phi_235_: bool;
    var phi_236_: lt_bvh_traverse_Tree;
    var phi_237_: bool;
    var phi_242_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_234_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_235_ = false;
        } else {
            phi_234_ = lt_bvh_traverse_Tree();
            phi_235_ = true;
        }
        let _e81 = phi_234_;
        let _e83 = phi_235_;
        phi_236_ = _e81;
        phi_237_ = _e83;
    } else {
        phi_236_ = lt_bvh_traverse_Tree();
        phi_237_ = true;
    }
    let _e85 = phi_236_;
    let _e87 = phi_237_;
    if _e87 {
        phi_242_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_242_ = _e85;
    }
    let _e92 = phi_242_;
    return lt_bvh_traverse_Tree(_e92.root, _e92.first_primitive);
}

fn _lt_shaders_texture_TextureView_quad(param_3: ptr<function, texture_TextureView>, param_4: f32, param_5: f32) -> texture_TexelQuad {
    var phi_287_: f32;
    var phi_292_: f32;
    var phi_293_: bool;
    var phi_294_: f32;
    var phi_295_: bool;
    var phi_299_: f32;
    var phi_325_: f32;
    var phi_330_: f32;
    var phi_331_: bool;
    var phi_332_: f32;
    var phi_333_: bool;
    var phi_337_: f32;
    var phi_345_: f32;
    var phi_346_: f32;
    var phi_347_: f32;
    var phi_356_: f32;
    var phi_357_: f32;
    var phi_375_: u32;
    var phi_389_: u32;
    var phi_396_: u32;
    var phi_401_: u32;
    var phi_407_: u32;
    var phi_412_: u32;
    var phi_414_: texture_Axis;
    var phi_442_: f32;
    var phi_447_: f32;
    var phi_448_: bool;
    var phi_449_: f32;
    var phi_450_: bool;
    var phi_454_: f32;
    var phi_480_: f32;
    var phi_485_: f32;
    var phi_486_: bool;
    var phi_487_: f32;
    var phi_488_: bool;
    var phi_492_: f32;
    var phi_500_: f32;
    var phi_501_: f32;
    var phi_502_: f32;
    var phi_511_: f32;
    var phi_512_: f32;
    var phi_530_: u32;
    var phi_544_: u32;
    var phi_551_: u32;
    var phi_556_: u32;
    var phi_562_: u32;
    var phi_567_: u32;
    var phi_569_: texture_Axis;

    let _e72 = (*param_3).size;
    let _e73 = (_e72 & 65535u);
    let _e75 = (*param_3).size;
    let _e77 = (_e75 >> bitcast<u32>(16i));
    let _e79 = (*param_3).flags;
    let _e81 = ((_e79 & 4u) != 0u);
    let _e83 = (*param_3).flags;
    let _e86 = ((_e83 >> bitcast<u32>(4u)) & 3u);
    if (_e86 == 0u) {
        if (param_4 > -8388608f) {
            let _e99 = f32(select(0i, select(select(i32(param_4), i32(-2147483648), (param_4 < bitcast<f32>(3472883712u))), 2147483647i, (param_4 > bitcast<f32>(1325400063u))), (param_4 == param_4)));
            if (_e99 > param_4) {
                phi_287_ = 1f;
            } else {
                phi_287_ = 0f;
            }
            let _e102 = phi_287_;
            if (param_4 < 8388608f) {
                phi_292_ = (_e99 - _e102);
                phi_293_ = false;
            } else {
                phi_292_ = f32();
                phi_293_ = true;
            }
            let _e105 = phi_292_;
            let _e107 = phi_293_;
            phi_294_ = _e105;
            phi_295_ = _e107;
        } else {
            phi_294_ = f32();
            phi_295_ = true;
        }
        let _e109 = phi_294_;
        let _e111 = phi_295_;
        if _e111 {
            phi_299_ = param_4;
        } else {
            phi_299_ = _e109;
        }
        let _e113 = phi_299_;
        phi_347_ = (param_4 - _e113);
    } else {
        if (_e86 == 1u) {
            let _e116 = (param_4 * 0.5f);
            if (_e116 > -8388608f) {
                let _e128 = f32(select(0i, select(select(i32(_e116), i32(-2147483648), (_e116 < bitcast<f32>(3472883712u))), 2147483647i, (_e116 > bitcast<f32>(1325400063u))), (_e116 == _e116)));
                if (_e128 > _e116) {
                    phi_325_ = 1f;
                } else {
                    phi_325_ = 0f;
                }
                let _e131 = phi_325_;
                if (_e116 < 8388608f) {
                    phi_330_ = (_e128 - _e131);
                    phi_331_ = false;
                } else {
                    phi_330_ = f32();
                    phi_331_ = true;
                }
                let _e134 = phi_330_;
                let _e136 = phi_331_;
                phi_332_ = _e134;
                phi_333_ = _e136;
            } else {
                phi_332_ = f32();
                phi_333_ = true;
            }
            let _e138 = phi_332_;
            let _e140 = phi_333_;
            if _e140 {
                phi_337_ = _e116;
            } else {
                phi_337_ = _e138;
            }
            let _e142 = phi_337_;
            let _e144 = (param_4 - (2f * _e142));
            if (_e144 > 1f) {
                phi_345_ = (2f - _e144);
            } else {
                phi_345_ = _e144;
            }
            let _e148 = phi_345_;
            phi_346_ = _e148;
        } else {
            phi_346_ = param_4;
        }
        let _e150 = phi_346_;
        phi_347_ = _e150;
    }
    let _e152 = phi_347_;
    if (_e152 > 0f) {
        if (_e152 < 1f) {
            phi_356_ = _e152;
        } else {
            phi_356_ = 1f;
        }
        let _e156 = phi_356_;
        phi_357_ = _e156;
    } else {
        phi_357_ = 0f;
    }
    let _e158 = phi_357_;
    let _e159 = (_e73 - 1u);
    let _e161 = (_e158 * f32(_e73));
    if _e81 {
        let _e168 = select(select(u32(_e161), 0u, (_e161 < bitcast<f32>(0u))), 4294967295u, (_e161 > bitcast<f32>(1333788671u)));
        if (_e159 < _e168) {
            phi_375_ = _e159;
        } else {
            phi_375_ = _e168;
        }
        let _e171 = phi_375_;
        phi_414_ = texture_Axis(_e171, _e171, 0f);
    } else {
        let _e173 = (_e161 + 0.5f);
        let _e180 = select(select(u32(_e173), 0u, (_e173 < bitcast<f32>(0u))), 4294967295u, (_e173 > bitcast<f32>(1333788671u)));
        if (_e73 < _e180) {
            phi_389_ = _e73;
        } else {
            phi_389_ = _e180;
        }
        let _e183 = phi_389_;
        if (_e86 == 0u) {
            phi_396_ = _e159;
        } else {
            phi_396_ = 0u;
        }
        let _e188 = phi_396_;
        if (_e86 == 0u) {
            phi_401_ = 0u;
        } else {
            phi_401_ = _e159;
        }
        let _e191 = phi_401_;
        if (_e183 == 0u) {
            phi_407_ = _e188;
        } else {
            phi_407_ = (_e183 - 1u);
        }
        let _e195 = phi_407_;
        if (_e183 > _e159) {
            phi_412_ = _e191;
        } else {
            phi_412_ = _e183;
        }
        let _e198 = phi_412_;
        phi_414_ = texture_Axis(_e195, _e198, (_e173 - f32(_e183)));
    }
    let _e201 = phi_414_;
    let _e203 = (*param_3).flags;
    let _e206 = ((_e203 >> bitcast<u32>(6u)) & 3u);
    if (_e206 == 0u) {
        if (param_5 > -8388608f) {
            let _e219 = f32(select(0i, select(select(i32(param_5), i32(-2147483648), (param_5 < bitcast<f32>(3472883712u))), 2147483647i, (param_5 > bitcast<f32>(1325400063u))), (param_5 == param_5)));
            if (_e219 > param_5) {
                phi_442_ = 1f;
            } else {
                phi_442_ = 0f;
            }
            let _e222 = phi_442_;
            if (param_5 < 8388608f) {
                phi_447_ = (_e219 - _e222);
                phi_448_ = false;
            } else {
                phi_447_ = f32();
                phi_448_ = true;
            }
            let _e225 = phi_447_;
            let _e227 = phi_448_;
            phi_449_ = _e225;
            phi_450_ = _e227;
        } else {
            phi_449_ = f32();
            phi_450_ = true;
        }
        let _e229 = phi_449_;
        let _e231 = phi_450_;
        if _e231 {
            phi_454_ = param_5;
        } else {
            phi_454_ = _e229;
        }
        let _e233 = phi_454_;
        phi_502_ = (param_5 - _e233);
    } else {
        if (_e206 == 1u) {
            let _e236 = (param_5 * 0.5f);
            if (_e236 > -8388608f) {
                let _e248 = f32(select(0i, select(select(i32(_e236), i32(-2147483648), (_e236 < bitcast<f32>(3472883712u))), 2147483647i, (_e236 > bitcast<f32>(1325400063u))), (_e236 == _e236)));
                if (_e248 > _e236) {
                    phi_480_ = 1f;
                } else {
                    phi_480_ = 0f;
                }
                let _e251 = phi_480_;
                if (_e236 < 8388608f) {
                    phi_485_ = (_e248 - _e251);
                    phi_486_ = false;
                } else {
                    phi_485_ = f32();
                    phi_486_ = true;
                }
                let _e254 = phi_485_;
                let _e256 = phi_486_;
                phi_487_ = _e254;
                phi_488_ = _e256;
            } else {
                phi_487_ = f32();
                phi_488_ = true;
            }
            let _e258 = phi_487_;
            let _e260 = phi_488_;
            if _e260 {
                phi_492_ = _e236;
            } else {
                phi_492_ = _e258;
            }
            let _e262 = phi_492_;
            let _e264 = (param_5 - (2f * _e262));
            if (_e264 > 1f) {
                phi_500_ = (2f - _e264);
            } else {
                phi_500_ = _e264;
            }
            let _e268 = phi_500_;
            phi_501_ = _e268;
        } else {
            phi_501_ = param_5;
        }
        let _e270 = phi_501_;
        phi_502_ = _e270;
    }
    let _e272 = phi_502_;
    if (_e272 > 0f) {
        if (_e272 < 1f) {
            phi_511_ = _e272;
        } else {
            phi_511_ = 1f;
        }
        let _e276 = phi_511_;
        phi_512_ = _e276;
    } else {
        phi_512_ = 0f;
    }
    let _e278 = phi_512_;
    let _e279 = (_e77 - 1u);
    let _e281 = (_e278 * f32(_e77));
    if _e81 {
        let _e288 = select(select(u32(_e281), 0u, (_e281 < bitcast<f32>(0u))), 4294967295u, (_e281 > bitcast<f32>(1333788671u)));
        if (_e279 < _e288) {
            phi_530_ = _e279;
        } else {
            phi_530_ = _e288;
        }
        let _e291 = phi_530_;
        phi_569_ = texture_Axis(_e291, _e291, 0f);
    } else {
        let _e293 = (_e281 + 0.5f);
        let _e300 = select(select(u32(_e293), 0u, (_e293 < bitcast<f32>(0u))), 4294967295u, (_e293 > bitcast<f32>(1333788671u)));
        if (_e77 < _e300) {
            phi_544_ = _e77;
        } else {
            phi_544_ = _e300;
        }
        let _e303 = phi_544_;
        if (_e206 == 0u) {
            phi_551_ = _e279;
        } else {
            phi_551_ = 0u;
        }
        let _e308 = phi_551_;
        if (_e206 == 0u) {
            phi_556_ = 0u;
        } else {
            phi_556_ = _e279;
        }
        let _e311 = phi_556_;
        if (_e303 == 0u) {
            phi_562_ = _e308;
        } else {
            phi_562_ = (_e303 - 1u);
        }
        let _e315 = phi_562_;
        if (_e303 > _e279) {
            phi_567_ = _e311;
        } else {
            phi_567_ = _e303;
        }
        let _e318 = phi_567_;
        phi_569_ = texture_Axis(_e315, _e318, (_e293 - f32(_e303)));
    }
    let _e321 = phi_569_;
    let _e325 = (*param_3).offset;
    let _e332 = (*param_3).offset;
    let _e339 = (*param_3).offset;
    let _e346 = (*param_3).offset;
    return texture_TexelQuad(array<u32, 4>(((_e325 + (_e321.low * _e73)) + _e201.low), ((_e332 + (_e321.low * _e73)) + _e201.high), ((_e339 + (_e321.high * _e73)) + _e201.low), ((_e346 + (_e321.high * _e73)) + _e201.high)), vec4<f32>(((1f - _e201.fraction) * (1f - _e321.fraction)), (_e201.fraction * (1f - _e321.fraction)), ((1f - _e201.fraction) * _e321.fraction), (_e201.fraction * _e321.fraction)));
}

fn core_intrinsics_maximum_number_nsz_f32_(param_6: f32, param_7: f32) -> f32 {
    var phi_628_: bool;
    var phi_632_: f32;

    if (param_6 != param_6) {
        phi_628_ = true;
    } else {
        let _e71 = (param_7 >= param_6);
        if _e71 {
        }
        phi_628_ = _e71;
    }
    let _e73 = phi_628_;
    if _e73 {
        phi_632_ = param_7;
    } else {
        phi_632_ = param_6;
    }
    let _e75 = phi_632_;
    return _e75;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_8: f32, param_9: f32) -> f32 {
    var phi_644_: bool;
    var phi_648_: f32;

    if (param_8 != param_8) {
        phi_644_ = true;
    } else {
        let _e71 = (param_9 <= param_8);
        if _e71 {
        }
        phi_644_ = _e71;
    }
    let _e73 = phi_644_;
    if _e73 {
        phi_648_ = param_9;
    } else {
        phi_648_ = param_8;
    }
    let _e75 = phi_648_;
    return _e75;
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
    var phi_1359_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1386_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1413_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1419_: u32;
    var phi_1422_: u32;
    var phi_1436_: u32;
    var phi_1446_: u32;
    var phi_1456_: u32;
    var phi_1474_: u32;
    var phi_1484_: u32;
    var phi_1494_: u32;
    var phi_1530_: u32;
    var phi_1543_: u32;
    var phi_1548_: u32;
    var phi_1549_: u32;
    var phi_1550_: u32;
    var phi_1420_: u32;
    var phi_1423_: u32;
    var local_4: u32;
    var local_5: u32;
    var local_6: u32;
    var phi_1608_: u32;
    var phi_1658_: f32;
    var phi_1663_: f32;
    var phi_1668_: f32;
    var phi_1676_: f32;
    var phi_1681_: f32;
    var phi_1686_: f32;
    var phi_1830_: bool;
    var phi_1831_: bool;
    var phi_1832_: bool;
    var phi_1836_: bool;
    var phi_1837_: bool;
    var phi_1838_: bool;
    var phi_1839_: bool;
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
    var phi_1857_: bool;
    var phi_1861_: bool;
    var phi_1931_: f32;
    var phi_1938_: f32;
    var phi_1945_: f32;
    var phi_1952_: f32;
    var phi_1959_: f32;
    var phi_1966_: f32;
    var phi_1983_: f32;
    var phi_1988_: f32;
    var phi_1993_: f32;
    var phi_2021_: bool;
    var phi_2022_: bool;
    var phi_2030_: u32;
    var phi_2031_: u32;
    var phi_2042_: vec3<f32>;
    var phi_2043_: vec3<f32>;
    var phi_2056_: u32;
    var phi_2061_: u32;
    var phi_2066_: u32;
    var phi_2180_: bool;
    var phi_2181_: bool;
    var phi_2212_: u32;
    var phi_2214_: u32;
    var phi_2295_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2322_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2349_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2355_: u32;
    var phi_2358_: u32;
    var phi_2372_: u32;
    var phi_2382_: u32;
    var phi_2392_: u32;
    var phi_2410_: u32;
    var phi_2420_: u32;
    var phi_2430_: u32;
    var phi_2466_: u32;
    var phi_2479_: u32;
    var phi_2484_: u32;
    var phi_2485_: u32;
    var phi_2486_: u32;
    var phi_2356_: u32;
    var phi_2359_: u32;
    var local_7: u32;
    var local_8: u32;
    var local_9: u32;
    var phi_2544_: u32;
    var phi_2589_: vec3<f32>;
    var phi_2590_: vec3<f32>;
    var phi_2619_: vec3<f32>;
    var phi_2620_: vec3<f32>;
    var phi_2649_: vec3<f32>;
    var phi_2650_: vec3<f32>;
    var phi_2668_: bool;
    var phi_2669_: bool;
    var phi_2673_: f32;
    var phi_2674_: f32;
    var phi_2675_: f32;
    var phi_2676_: f32;
    var phi_2684_: f32;
    var phi_2694_: bool;
    var phi_2695_: bool;
    var phi_2699_: f32;
    var phi_2700_: f32;
    var phi_2701_: f32;
    var phi_2702_: f32;
    var phi_2710_: f32;
    var phi_2720_: bool;
    var phi_2721_: bool;
    var phi_2725_: f32;
    var phi_2726_: f32;
    var phi_2727_: f32;
    var phi_2728_: f32;
    var phi_2736_: f32;
    var phi_2751_: f32;
    var phi_2752_: bool;
    var phi_2753_: f32;
    var phi_2754_: bool;
    var phi_2755_: f32;
    var phi_2756_: bool;
    var phi_2774_: f32;
    var phi_2775_: bool;
    var phi_2776_: bool;
    var phi_2777_: f32;
    var phi_2778_: bool;
    var phi_2779_: bool;
    var phi_2783_: bool;
    var phi_2784_: f32;
    var phi_2785_: bool;
    var phi_2813_: vec3<f32>;
    var phi_2814_: vec3<f32>;
    var phi_2839_: vec3<f32>;
    var phi_2840_: vec3<f32>;
    var phi_2865_: vec3<f32>;
    var phi_2866_: vec3<f32>;
    var phi_2922_: f32;
    var phi_2931_: f32;
    var phi_2940_: f32;
    var phi_2949_: f32;
    var phi_2956_: f32;
    var phi_2963_: f32;
    var phi_2976_: f32;
    var phi_2985_: f32;
    var phi_2994_: f32;
    var phi_3003_: f32;
    var phi_3010_: f32;
    var phi_3017_: f32;
    var phi_3034_: f32;
    var phi_3039_: f32;
    var phi_3044_: f32;
    var phi_3052_: f32;
    var phi_3057_: f32;
    var phi_3062_: f32;
    var phi_3074_: f32;
    var phi_3079_: f32;
    var phi_3084_: f32;
    var phi_3089_: f32;
    var phi_3094_: lt_bvh_triangle_Intersection;
    var phi_3095_: bool;
    var phi_3096_: lt_bvh_triangle_Intersection;
    var phi_3097_: bool;
    var phi_3101_: lt_bvh_triangle_Intersection;
    var phi_3102_: bool;
    var phi_3103_: lt_bvh_triangle_Intersection;
    var phi_3104_: bool;
    var phi_3105_: bool;
    var phi_3109_: bool;
    var phi_3113_: lt_bvh_triangle_Intersection;
    var phi_3327_: f32;
    var phi_3330_: bool;
    var phi_3331_: bool;
    var phi_3335_: bool;
    var phi_3336_: bool;
    var phi_3337_: bool;
    var phi_3338_: bool;
    var phi_3339_: bool;
    var phi_3340_: bool;
    var phi_3341_: bool;
    var phi_3342_: bool;
    var phi_3343_: bool;
    var phi_3344_: bool;
    var phi_3345_: bool;
    var phi_3346_: bool;
    var phi_3350_: bool;
    var phi_3351_: bool;
    var phi_2545_: u32;
    var phi_3352_: bool;
    var phi_3353_: bool;
    var phi_3354_: bool;
    var local_10: bool;
    var phi_3396_: bool;
    var phi_3397_: bool;
    var phi_3428_: u32;
    var phi_3429_: u32;
    var phi_3430_: bool;
    var phi_3431_: bool;
    var phi_2215_: u32;
    var phi_3432_: bool;
    var phi_3433_: bool;
    var phi_3434_: bool;
    var phi_3435_: bool;
    var local_11: bool;
    var phi_3439_: bool;
    var phi_3440_: bool;
    var phi_3444_: bool;
    var phi_3448_: bool;
    var phi_3449_: bool;
    var phi_3450_: bool;
    var phi_3451_: bool;
    var phi_3455_: bool;
    var phi_3459_: bool;
    var phi_3460_: bool;
    var phi_3461_: bool;
    var phi_3462_: bool;
    var phi_1609_: u32;
    var phi_3466_: bool;
    var local_12: bool;
    var phi_3508_: bool;
    var phi_3509_: bool;
    var phi_3540_: u32;
    var phi_3541_: u32;
    var phi_1279_: u32;
    var phi_3542_: bool;
    var phi_3543_: bool;
    var local_13: bool;
    var phi_3547_: bool;
    var phi_3551_: bool;
    var phi_3552_: bool;
    var phi_3553_: bool;
    var phi_3554_: bool;
    var phi_3558_: bool;
    var phi_3562_: f32;
    var phi_3563_: f32;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;
    var local_18: bool;
    var local_19: bool;

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
            phi_3563_ = _e243.unnamed.visibility;
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
                    phi_3552_ = bool();
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
                    loop {
                        let _e629 = phi_1278_;
                        if (_e629 != 4294967295u) {
                            if (_e629 < _e79) {
                            } else {
                                return;
                            }
                            let _e636 = nodes.member[(0u + _e629)].frame[3u];
                            let _e661 = (bitcast<f32>((((_e636 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e423);
                            let _e662 = (bitcast<f32>((((_e636 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e433);
                            let _e663 = (bitcast<f32>((((_e636 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e443);
                            let _e666 = nodes.member[(0u + _e629)].frame[0u];
                            let _e670 = nodes.member[(0u + _e629)].frame[1u];
                            let _e674 = nodes.member[(0u + _e629)].frame[2u];
                            let _e679 = ((bitcast<f32>(_e666) - _e265) * _e423);
                            let _e680 = ((bitcast<f32>(_e670) - _e267) * _e433);
                            let _e681 = ((bitcast<f32>(_e674) - _e269) * _e443);
                            let _e689 = nodes.member[(0u + _e629)].x;
                            if (_e423 < 0f) {
                                let _e700 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e689.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e706 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e700.unnamed.root, _e689.w), _e700.unnamed_1);
                                let _e712 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e706.unnamed, lt_bvh_traverse_Tree(_e689.x, _e706.unnamed_1.first_primitive));
                                phi_1359_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e712.unnamed, lt_bvh_traverse_Tree(_e712.unnamed_1.root, _e689.y));
                            } else {
                                let _e728 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e689.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e734 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e728.unnamed.root, _e689.y), _e728.unnamed_1);
                                let _e740 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e734.unnamed, lt_bvh_traverse_Tree(_e689.z, _e734.unnamed_1.first_primitive));
                                phi_1359_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e740.unnamed, lt_bvh_traverse_Tree(_e740.unnamed_1.root, _e689.w));
                            }
                            let _e748 = phi_1359_;
                            let _e758 = nodes.member[(0u + _e629)].y;
                            if (_e433 < 0f) {
                                let _e769 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e758.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e775 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e769.unnamed.root, _e758.w), _e769.unnamed_1);
                                let _e781 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e775.unnamed, lt_bvh_traverse_Tree(_e758.x, _e775.unnamed_1.first_primitive));
                                phi_1386_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e781.unnamed, lt_bvh_traverse_Tree(_e781.unnamed_1.root, _e758.y));
                            } else {
                                let _e797 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e758.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e803 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e797.unnamed.root, _e758.y), _e797.unnamed_1);
                                let _e809 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e803.unnamed, lt_bvh_traverse_Tree(_e758.z, _e803.unnamed_1.first_primitive));
                                phi_1386_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e809.unnamed, lt_bvh_traverse_Tree(_e809.unnamed_1.root, _e758.w));
                            }
                            let _e817 = phi_1386_;
                            let _e827 = nodes.member[(0u + _e629)].z;
                            if (_e443 < 0f) {
                                let _e838 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e827.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e844 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e838.unnamed.root, _e827.w), _e838.unnamed_1);
                                let _e850 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e844.unnamed, lt_bvh_traverse_Tree(_e827.x, _e844.unnamed_1.first_primitive));
                                phi_1413_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e850.unnamed, lt_bvh_traverse_Tree(_e850.unnamed_1.root, _e827.y));
                            } else {
                                let _e866 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e827.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e872 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e866.unnamed.root, _e827.y), _e866.unnamed_1);
                                let _e878 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e872.unnamed, lt_bvh_traverse_Tree(_e827.z, _e872.unnamed_1.first_primitive));
                                phi_1413_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e878.unnamed, lt_bvh_traverse_Tree(_e878.unnamed_1.root, _e827.w));
                            }
                            let _e886 = phi_1413_;
                            phi_1419_ = 0u;
                            phi_1422_ = 0u;
                            loop {
                                let _e896 = phi_1419_;
                                let _e898 = phi_1422_;
                                local_4 = _e898;
                                local_5 = _e898;
                                local_6 = _e898;
                                let _e899 = (_e896 < 8u);
                                if _e899 {
                                    let _e901 = (_e896 >> bitcast<u32>(2i));
                                    let _e902 = (_e896 & 3u);
                                    if (_e901 == 0u) {
                                        phi_1436_ = _e748.unnamed.root;
                                    } else {
                                        phi_1436_ = _e748.unnamed.first_primitive;
                                    }
                                    let _e905 = phi_1436_;
                                    if (_e901 == 0u) {
                                        phi_1446_ = _e817.unnamed.root;
                                    } else {
                                        phi_1446_ = _e817.unnamed.first_primitive;
                                    }
                                    let _e914 = phi_1446_;
                                    if (_e901 == 0u) {
                                        phi_1456_ = _e886.unnamed.root;
                                    } else {
                                        phi_1456_ = _e886.unnamed.first_primitive;
                                    }
                                    let _e923 = phi_1456_;
                                    let _e936 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e905 >> bitcast<u32>(((_e902 * 8u) & 31u))) & 255u)) * _e661) + (_e679 - _e471)), ((f32(((_e914 >> bitcast<u32>(((_e902 * 8u) & 31u))) & 255u)) * _e662) + (_e680 - _e472)));
                                    let _e937 = core_intrinsics_maximum_number_nsz_f32_(_e936, ((f32(((_e923 >> bitcast<u32>(((_e902 * 8u) & 31u))) & 255u)) * _e663) + (_e681 - _e473)));
                                    if (_e901 == 0u) {
                                        phi_1474_ = _e748.unnamed_1.root;
                                    } else {
                                        phi_1474_ = _e748.unnamed_1.first_primitive;
                                    }
                                    let _e940 = phi_1474_;
                                    if (_e901 == 0u) {
                                        phi_1484_ = _e817.unnamed_1.root;
                                    } else {
                                        phi_1484_ = _e817.unnamed_1.first_primitive;
                                    }
                                    let _e949 = phi_1484_;
                                    if (_e901 == 0u) {
                                        phi_1494_ = _e886.unnamed_1.root;
                                    } else {
                                        phi_1494_ = _e886.unnamed_1.first_primitive;
                                    }
                                    let _e958 = phi_1494_;
                                    let _e971 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e940 >> bitcast<u32>(((_e902 * 8u) & 31u))) & 255u)) * _e661) + (_e679 + _e471)), ((f32(((_e949 >> bitcast<u32>(((_e902 * 8u) & 31u))) & 255u)) * _e662) + (_e680 + _e472)));
                                    let _e972 = core_intrinsics_minimum_number_nsz_f32_(_e971, ((f32(((_e958 >> bitcast<u32>(((_e902 * 8u) & 31u))) & 255u)) * _e663) + (_e681 + _e473)));
                                    if (_e937 <= _e972) {
                                        if (_e937 <= _e275) {
                                            if (_e972 >= 0f) {
                                                if (_e901 == 0u) {
                                                    let _e979 = nodes.member[(0u + _e629)].links[2u];
                                                    phi_1530_ = _e979;
                                                } else {
                                                    let _e982 = nodes.member[(0u + _e629)].links[3u];
                                                    phi_1530_ = _e982;
                                                }
                                                let _e984 = phi_1530_;
                                                let _e989 = ((_e984 >> bitcast<u32>(((_e902 * 8u) & 31u))) & 255u);
                                                let _e990 = (_e989 & 31u);
                                                if (_e990 >= 24u) {
                                                    phi_1543_ = (24u + ((_e990 - 24u) ^ _e491));
                                                } else {
                                                    phi_1543_ = _e990;
                                                }
                                                let _e996 = phi_1543_;
                                                phi_1548_ = (_e898 | ((_e989 >> bitcast<u32>(5i)) << bitcast<u32>((_e996 & 31u))));
                                            } else {
                                                phi_1548_ = _e898;
                                            }
                                            let _e1004 = phi_1548_;
                                            phi_1549_ = _e1004;
                                        } else {
                                            phi_1549_ = _e898;
                                        }
                                        let _e1006 = phi_1549_;
                                        phi_1550_ = _e1006;
                                    } else {
                                        phi_1550_ = _e898;
                                    }
                                    let _e1008 = phi_1550_;
                                    phi_1420_ = (_e896 + 1u);
                                    phi_1423_ = _e1008;
                                } else {
                                    phi_1420_ = u32();
                                    phi_1423_ = u32();
                                }
                                let _e1011 = phi_1420_;
                                let _e1013 = phi_1423_;
                                continue;
                                continuing {
                                    phi_1419_ = _e1011;
                                    phi_1422_ = _e1013;
                                    break if !(_e899);
                                }
                            }
                            let _e1017 = nodes.member[(0u + _e629)].links[0u];
                            let _e1021 = nodes.member[(0u + _e629)].frame[3u];
                            let _e1025 = local_4;
                            if ((_e1025 & 4278190080u) == 0u) {
                            } else {
                                let _e1029 = local_2.group_mask;
                                if ((_e1029 & 4278190080u) == 0u) {
                                } else {
                                    let _e1033 = local_2.len;
                                    if (_e1033 < 32u) {
                                        let _e1036 = local_2.group;
                                        let _e1038 = local_2.len;
                                        if (_e1038 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_2.first[(0u + _e1038)] = _e1036;
                                        let _e1044 = local_2.group_mask;
                                        let _e1046 = local_2.len;
                                        if (_e1046 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_2.mask[(0u + _e1046)] = _e1044;
                                        let _e1053 = local_2.len;
                                        local_2.len = (_e1053 + 1u);
                                    }
                                }
                                local_2.group = (_e248 + _e1017);
                                let _e1057 = local_5;
                                local_2.group_mask = ((_e1057 & 4278190080u) | (_e1021 >> bitcast<u32>(24i)));
                            }
                            let _e1062 = local_6;
                            phi_1608_ = (_e1062 & 16777215u);
                            loop {
                                let _e1065 = phi_1608_;
                                let _e1066 = (_e1065 == 0u);
                                local_12 = _e1066;
                                local_19 = _e1066;
                                if _e1066 {
                                    phi_1609_ = u32();
                                    phi_3466_ = false;
                                } else {
                                    let _e1069 = nodes.member[(0u + _e629)].links[1u];
                                    let _e1073 = (_e1069 + select(firstTrailingBit(_e1065), 32u, (_e1065 == 0u)));
                                    if (_e1073 < arrayLength((&instances.member))) {
                                    } else {
                                        return;
                                    }
                                    let _e1080 = instances.member[(0u + _e1073)].low_world;
                                    let _e1082 = instances.member[(0u + _e1073)].high_world;
                                    let _e1089 = ((_e1080.x - _e265) * _e423);
                                    let _e1090 = ((_e1080.y - _e267) * _e433);
                                    let _e1091 = ((_e1080.z - _e269) * _e443);
                                    let _e1098 = ((_e1082.x - _e265) * _e423);
                                    let _e1099 = ((_e1082.y - _e267) * _e433);
                                    let _e1100 = ((_e1082.z - _e269) * _e443);
                                    if (_e1089 < _e1098) {
                                        phi_1658_ = _e1089;
                                    } else {
                                        phi_1658_ = _e1098;
                                    }
                                    let _e1103 = phi_1658_;
                                    if (_e1090 < _e1099) {
                                        phi_1663_ = _e1090;
                                    } else {
                                        phi_1663_ = _e1099;
                                    }
                                    let _e1106 = phi_1663_;
                                    if (_e1091 < _e1100) {
                                        phi_1668_ = _e1091;
                                    } else {
                                        phi_1668_ = _e1100;
                                    }
                                    let _e1109 = phi_1668_;
                                    if (_e1089 > _e1098) {
                                        phi_1676_ = _e1089;
                                    } else {
                                        phi_1676_ = _e1098;
                                    }
                                    let _e1115 = phi_1676_;
                                    if (_e1090 > _e1099) {
                                        phi_1681_ = _e1090;
                                    } else {
                                        phi_1681_ = _e1099;
                                    }
                                    let _e1118 = phi_1681_;
                                    if (_e1091 > _e1100) {
                                        phi_1686_ = _e1091;
                                    } else {
                                        phi_1686_ = _e1100;
                                    }
                                    let _e1121 = phi_1686_;
                                    let _e1125 = core_intrinsics_maximum_number_nsz_f32_((_e1103 - _e478), (_e1106 - _e479));
                                    let _e1126 = core_intrinsics_maximum_number_nsz_f32_(_e1125, (_e1109 - _e480));
                                    let _e1127 = core_intrinsics_minimum_number_nsz_f32_((_e1115 + _e478), (_e1118 + _e479));
                                    let _e1128 = core_intrinsics_minimum_number_nsz_f32_(_e1127, (_e1121 + _e480));
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
                                                let _e1220 = abs(_e1185);
                                                let _e1221 = abs(_e1198);
                                                let _e1222 = abs(_e1211);
                                                if (abs(_e1145) < 1000000000000000f) {
                                                    if (abs(_e1158) < 1000000000000000f) {
                                                        if (abs(_e1171) < 1000000000000000f) {
                                                            if (_e1220 < 1000000000000000f) {
                                                                if (_e1221 < 1000000000000000f) {
                                                                    if (_e1222 < 1000000000000000f) {
                                                                        if (_e1220 > 0f) {
                                                                            phi_1831_ = bool();
                                                                            phi_1832_ = true;
                                                                        } else {
                                                                            let _e1230 = (_e1221 > 0f);
                                                                            if _e1230 {
                                                                                phi_1830_ = bool();
                                                                            } else {
                                                                                phi_1830_ = (_e1222 > 0f);
                                                                            }
                                                                            let _e1233 = phi_1830_;
                                                                            phi_1831_ = _e1233;
                                                                            phi_1832_ = _e1230;
                                                                        }
                                                                        let _e1235 = phi_1831_;
                                                                        let _e1237 = phi_1832_;
                                                                        if _e1237 {
                                                                            phi_1836_ = true;
                                                                        } else {
                                                                            phi_1836_ = _e1235;
                                                                        }
                                                                        let _e1239 = phi_1836_;
                                                                        phi_1837_ = _e1239;
                                                                        phi_1838_ = false;
                                                                    } else {
                                                                        phi_1837_ = bool();
                                                                        phi_1838_ = true;
                                                                    }
                                                                    let _e1241 = phi_1837_;
                                                                    let _e1243 = phi_1838_;
                                                                    phi_1839_ = _e1241;
                                                                    phi_1840_ = false;
                                                                    phi_1841_ = _e1243;
                                                                } else {
                                                                    phi_1839_ = bool();
                                                                    phi_1840_ = true;
                                                                    phi_1841_ = false;
                                                                }
                                                                let _e1245 = phi_1839_;
                                                                let _e1247 = phi_1840_;
                                                                let _e1249 = phi_1841_;
                                                                phi_1842_ = _e1245;
                                                                phi_1843_ = _e1247;
                                                                phi_1844_ = _e1249;
                                                            } else {
                                                                phi_1842_ = bool();
                                                                phi_1843_ = true;
                                                                phi_1844_ = false;
                                                            }
                                                            let _e1251 = phi_1842_;
                                                            let _e1253 = phi_1843_;
                                                            let _e1255 = phi_1844_;
                                                            phi_1845_ = _e1251;
                                                            phi_1846_ = _e1253;
                                                            phi_1847_ = _e1255;
                                                        } else {
                                                            phi_1845_ = bool();
                                                            phi_1846_ = true;
                                                            phi_1847_ = false;
                                                        }
                                                        let _e1257 = phi_1845_;
                                                        let _e1259 = phi_1846_;
                                                        let _e1261 = phi_1847_;
                                                        phi_1848_ = _e1257;
                                                        phi_1849_ = _e1259;
                                                        phi_1850_ = _e1261;
                                                    } else {
                                                        phi_1848_ = bool();
                                                        phi_1849_ = true;
                                                        phi_1850_ = false;
                                                    }
                                                    let _e1263 = phi_1848_;
                                                    let _e1265 = phi_1849_;
                                                    let _e1267 = phi_1850_;
                                                    phi_1851_ = _e1263;
                                                    phi_1852_ = _e1265;
                                                    phi_1853_ = _e1267;
                                                } else {
                                                    phi_1851_ = bool();
                                                    phi_1852_ = true;
                                                    phi_1853_ = false;
                                                }
                                                let _e1269 = phi_1851_;
                                                let _e1271 = phi_1852_;
                                                let _e1273 = phi_1853_;
                                                if _e1271 {
                                                    phi_1857_ = true;
                                                } else {
                                                    phi_1857_ = _e1273;
                                                }
                                                let _e1275 = phi_1857_;
                                                if _e1275 {
                                                    phi_1861_ = false;
                                                } else {
                                                    phi_1861_ = _e1269;
                                                }
                                                let _e1277 = phi_1861_;
                                                if _e1277 {
                                                    let _e1278 = (_e1214 >= _e79);
                                                    if _e1278 {
                                                        phi_3449_ = bool();
                                                    } else {
                                                        if (_e1214 < _e79) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1284 = nodes.member[(0u + _e1214)].frame[0u];
                                                        let _e1288 = nodes.member[(0u + _e1214)].frame[1u];
                                                        let _e1292 = nodes.member[(0u + _e1214)].frame[2u];
                                                        let _e1296 = nodes.member[(0u + _e1214)].frame[0u];
                                                        let _e1300 = nodes.member[(0u + _e1214)].frame[1u];
                                                        let _e1304 = nodes.member[(0u + _e1214)].frame[2u];
                                                        let _e1308 = nodes.member[(0u + _e1214)].frame[3u];
                                                        let _e1342 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1185), abs(_e1198));
                                                        let _e1343 = core_intrinsics_maximum_number_nsz_f32_(_e1342, abs(_e1211));
                                                        let _e1344 = (_e1343 * 0.0000000000009094947f);
                                                        if (abs(_e1185) < _e1344) {
                                                            phi_1931_ = _e1344;
                                                        } else {
                                                            phi_1931_ = abs(_e1185);
                                                        }
                                                        let _e1349 = phi_1931_;
                                                        if (_e1185 < 0f) {
                                                            phi_1938_ = (-1f / _e1349);
                                                        } else {
                                                            phi_1938_ = (1f / _e1349);
                                                        }
                                                        let _e1354 = phi_1938_;
                                                        if (abs(_e1198) < _e1344) {
                                                            phi_1945_ = _e1344;
                                                        } else {
                                                            phi_1945_ = abs(_e1198);
                                                        }
                                                        let _e1359 = phi_1945_;
                                                        if (_e1198 < 0f) {
                                                            phi_1952_ = (-1f / _e1359);
                                                        } else {
                                                            phi_1952_ = (1f / _e1359);
                                                        }
                                                        let _e1364 = phi_1952_;
                                                        if (abs(_e1211) < _e1344) {
                                                            phi_1959_ = _e1344;
                                                        } else {
                                                            phi_1959_ = abs(_e1211);
                                                        }
                                                        let _e1369 = phi_1959_;
                                                        if (_e1211 < 0f) {
                                                            phi_1966_ = (-1f / _e1369);
                                                        } else {
                                                            phi_1966_ = (1f / _e1369);
                                                        }
                                                        let _e1374 = phi_1966_;
                                                        let _e1378 = abs((bitcast<f32>(_e1284) - _e1145));
                                                        let _e1379 = abs((bitcast<f32>(_e1288) - _e1158));
                                                        let _e1380 = abs((bitcast<f32>(_e1292) - _e1171));
                                                        let _e1384 = abs(((bitcast<f32>(_e1296) + (bitcast<f32>((((_e1308 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1145));
                                                        let _e1385 = abs(((bitcast<f32>(_e1300) + (bitcast<f32>((((_e1308 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1158));
                                                        let _e1386 = abs(((bitcast<f32>(_e1304) + (bitcast<f32>((((_e1308 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1171));
                                                        if (_e1378 > _e1384) {
                                                            phi_1983_ = _e1378;
                                                        } else {
                                                            phi_1983_ = _e1384;
                                                        }
                                                        let _e1389 = phi_1983_;
                                                        if (_e1379 > _e1385) {
                                                            phi_1988_ = _e1379;
                                                        } else {
                                                            phi_1988_ = _e1385;
                                                        }
                                                        let _e1392 = phi_1988_;
                                                        if (_e1380 > _e1386) {
                                                            phi_1993_ = _e1380;
                                                        } else {
                                                            phi_1993_ = _e1386;
                                                        }
                                                        let _e1395 = phi_1993_;
                                                        let _e1396 = core_intrinsics_maximum_number_nsz_f32_(_e1389, _e1392);
                                                        let _e1397 = core_intrinsics_maximum_number_nsz_f32_(_e1396, _e1395);
                                                        let _e1401 = (_e1397 * 0.0000019073486f);
                                                        let _e1402 = (abs(_e1354) * _e1401);
                                                        let _e1403 = (abs(_e1364) * _e1401);
                                                        let _e1404 = (abs(_e1374) * _e1401);
                                                        let _e1408 = (_e1397 * 0.0000009536743f);
                                                        let _e1409 = (abs(_e1354) * _e1408);
                                                        let _e1410 = (abs(_e1364) * _e1408);
                                                        let _e1411 = (abs(_e1374) * _e1408);
                                                        let _e1412 = abs(_e1185);
                                                        let _e1413 = abs(_e1198);
                                                        let _e1414 = abs(_e1211);
                                                        if (_e1412 >= _e1413) {
                                                            if (_e1412 >= _e1414) {
                                                                phi_2021_ = false;
                                                            } else {
                                                                phi_2021_ = true;
                                                            }
                                                            let _e1418 = phi_2021_;
                                                            phi_2022_ = _e1418;
                                                        } else {
                                                            phi_2022_ = true;
                                                        }
                                                        let _e1420 = phi_2022_;
                                                        if _e1420 {
                                                            if (_e1413 >= _e1414) {
                                                                phi_2030_ = 1u;
                                                            } else {
                                                                phi_2030_ = 2u;
                                                            }
                                                            let _e1423 = phi_2030_;
                                                            phi_2031_ = _e1423;
                                                        } else {
                                                            phi_2031_ = 0u;
                                                        }
                                                        let _e1425 = phi_2031_;
                                                        if (_e1425 == 0u) {
                                                            phi_2043_ = vec3<f32>(_e1198, _e1211, _e1185);
                                                        } else {
                                                            if (_e1425 == 1u) {
                                                                phi_2042_ = vec3<f32>(_e1211, _e1185, _e1198);
                                                            } else {
                                                                phi_2042_ = vec3<f32>(_e1185, _e1198, _e1211);
                                                            }
                                                            let _e1431 = phi_2042_;
                                                            phi_2043_ = _e1431;
                                                        }
                                                        let _e1433 = phi_2043_;
                                                        let _e1436 = (_e1433.x / _e1433.z);
                                                        let _e1439 = (_e1433.y / _e1433.z);
                                                        if (_e1354 < 0f) {
                                                            phi_2056_ = 0u;
                                                        } else {
                                                            phi_2056_ = 1u;
                                                        }
                                                        let _e1444 = phi_2056_;
                                                        if (_e1364 < 0f) {
                                                            phi_2061_ = 0u;
                                                        } else {
                                                            phi_2061_ = 2u;
                                                        }
                                                        let _e1447 = phi_2061_;
                                                        if (_e1374 < 0f) {
                                                            phi_2066_ = 0u;
                                                        } else {
                                                            phi_2066_ = 4u;
                                                        }
                                                        let _e1450 = phi_2066_;
                                                        let _e1452 = ((_e1444 | _e1447) | _e1450);
                                                        let _e1453 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1214, 2147483648u);
                                                        local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1453.first[0], _e1453.first[1], _e1453.first[2], _e1453.first[3], _e1453.first[4], _e1453.first[5], _e1453.first[6], _e1453.first[7], _e1453.first[8], _e1453.first[9], _e1453.first[10], _e1453.first[11], _e1453.first[12], _e1453.first[13], _e1453.first[14], _e1453.first[15], _e1453.first[16], _e1453.first[17], _e1453.first[18], _e1453.first[19], _e1453.first[20], _e1453.first[21], _e1453.first[22], _e1453.first[23], _e1453.first[24], _e1453.first[25], _e1453.first[26], _e1453.first[27], _e1453.first[28], _e1453.first[29], _e1453.first[30], _e1453.first[31]), array<u32, 32>(_e1453.mask[0], _e1453.mask[1], _e1453.mask[2], _e1453.mask[3], _e1453.mask[4], _e1453.mask[5], _e1453.mask[6], _e1453.mask[7], _e1453.mask[8], _e1453.mask[9], _e1453.mask[10], _e1453.mask[11], _e1453.mask[12], _e1453.mask[13], _e1453.mask[14], _e1453.mask[15], _e1453.mask[16], _e1453.mask[17], _e1453.mask[18], _e1453.mask[19], _e1453.mask[20], _e1453.mask[21], _e1453.mask[22], _e1453.mask[23], _e1453.mask[24], _e1453.mask[25], _e1453.mask[26], _e1453.mask[27], _e1453.mask[28], _e1453.mask[29], _e1453.mask[30], _e1453.mask[31]), _e1453.len, _e1453.group, _e1453.group_mask);
                                                        let _e1527 = local_1.group_mask;
                                                        if ((_e1527 & 4278190080u) == 0u) {
                                                            let _e1531 = local_1.len;
                                                            if (_e1531 == 0u) {
                                                                phi_2180_ = false;
                                                            } else {
                                                                let _e1535 = local_1.len;
                                                                local_1.len = (_e1535 - 1u);
                                                                let _e1538 = local_1.len;
                                                                if (_e1538 < 32u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1543 = local_1.first[(0u + _e1538)];
                                                                local_1.group = _e1543;
                                                                let _e1546 = local_1.len;
                                                                if (_e1546 < 32u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1551 = local_1.mask[(0u + _e1546)];
                                                                local_1.group_mask = _e1551;
                                                                phi_2180_ = true;
                                                            }
                                                            let _e1554 = phi_2180_;
                                                            phi_2181_ = _e1554;
                                                        } else {
                                                            phi_2181_ = true;
                                                        }
                                                        let _e1556 = phi_2181_;
                                                        if _e1556 {
                                                            let _e1558 = local_1.group_mask;
                                                            let _e1564 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1558)), 32u, (_e1558 == 0u)));
                                                            let _e1568 = local_1.group_mask;
                                                            let _e1582 = local_1.group_mask;
                                                            local_1.group_mask = (_e1582 & ~((1u << bitcast<u32>((_e1564 & 31u)))));
                                                            let _e1585 = local_1.group;
                                                            phi_2212_ = (_e1585 + countOneBits(((_e1568 & ~((4294967295u << bitcast<u32>((((_e1564 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                        } else {
                                                            phi_2212_ = 4294967295u;
                                                        }
                                                        let _e1588 = phi_2212_;
                                                        phi_2214_ = _e1588;
                                                        loop {
                                                            let _e1590 = phi_2214_;
                                                            if (_e1590 != 4294967295u) {
                                                                if (_e1590 < _e79) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1597 = nodes.member[(0u + _e1590)].frame[3u];
                                                                let _e1622 = (bitcast<f32>((((_e1597 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1354);
                                                                let _e1623 = (bitcast<f32>((((_e1597 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1364);
                                                                let _e1624 = (bitcast<f32>((((_e1597 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1374);
                                                                let _e1627 = nodes.member[(0u + _e1590)].frame[0u];
                                                                let _e1631 = nodes.member[(0u + _e1590)].frame[1u];
                                                                let _e1635 = nodes.member[(0u + _e1590)].frame[2u];
                                                                let _e1640 = ((bitcast<f32>(_e1627) - _e1145) * _e1354);
                                                                let _e1641 = ((bitcast<f32>(_e1631) - _e1158) * _e1364);
                                                                let _e1642 = ((bitcast<f32>(_e1635) - _e1171) * _e1374);
                                                                let _e1650 = nodes.member[(0u + _e1590)].x;
                                                                if (_e1354 < 0f) {
                                                                    let _e1661 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1650.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1667 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1661.unnamed.root, _e1650.w), _e1661.unnamed_1);
                                                                    let _e1673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1667.unnamed, lt_bvh_traverse_Tree(_e1650.x, _e1667.unnamed_1.first_primitive));
                                                                    phi_2295_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1673.unnamed, lt_bvh_traverse_Tree(_e1673.unnamed_1.root, _e1650.y));
                                                                } else {
                                                                    let _e1689 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1650.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1695 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1689.unnamed.root, _e1650.y), _e1689.unnamed_1);
                                                                    let _e1701 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1695.unnamed, lt_bvh_traverse_Tree(_e1650.z, _e1695.unnamed_1.first_primitive));
                                                                    phi_2295_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1701.unnamed, lt_bvh_traverse_Tree(_e1701.unnamed_1.root, _e1650.w));
                                                                }
                                                                let _e1709 = phi_2295_;
                                                                let _e1719 = nodes.member[(0u + _e1590)].y;
                                                                if (_e1364 < 0f) {
                                                                    let _e1730 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1719.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1736 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1730.unnamed.root, _e1719.w), _e1730.unnamed_1);
                                                                    let _e1742 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1736.unnamed, lt_bvh_traverse_Tree(_e1719.x, _e1736.unnamed_1.first_primitive));
                                                                    phi_2322_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1742.unnamed, lt_bvh_traverse_Tree(_e1742.unnamed_1.root, _e1719.y));
                                                                } else {
                                                                    let _e1758 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1719.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1764 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1758.unnamed.root, _e1719.y), _e1758.unnamed_1);
                                                                    let _e1770 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1764.unnamed, lt_bvh_traverse_Tree(_e1719.z, _e1764.unnamed_1.first_primitive));
                                                                    phi_2322_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1770.unnamed, lt_bvh_traverse_Tree(_e1770.unnamed_1.root, _e1719.w));
                                                                }
                                                                let _e1778 = phi_2322_;
                                                                let _e1788 = nodes.member[(0u + _e1590)].z;
                                                                if (_e1374 < 0f) {
                                                                    let _e1799 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1788.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1805 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1799.unnamed.root, _e1788.w), _e1799.unnamed_1);
                                                                    let _e1811 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1805.unnamed, lt_bvh_traverse_Tree(_e1788.x, _e1805.unnamed_1.first_primitive));
                                                                    phi_2349_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1811.unnamed, lt_bvh_traverse_Tree(_e1811.unnamed_1.root, _e1788.y));
                                                                } else {
                                                                    let _e1827 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1788.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1833 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1827.unnamed.root, _e1788.y), _e1827.unnamed_1);
                                                                    let _e1839 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1833.unnamed, lt_bvh_traverse_Tree(_e1788.z, _e1833.unnamed_1.first_primitive));
                                                                    phi_2349_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1839.unnamed, lt_bvh_traverse_Tree(_e1839.unnamed_1.root, _e1788.w));
                                                                }
                                                                let _e1847 = phi_2349_;
                                                                phi_2355_ = 0u;
                                                                phi_2358_ = 0u;
                                                                loop {
                                                                    let _e1857 = phi_2355_;
                                                                    let _e1859 = phi_2358_;
                                                                    local_7 = _e1859;
                                                                    local_8 = _e1859;
                                                                    local_9 = _e1859;
                                                                    let _e1860 = (_e1857 < 8u);
                                                                    if _e1860 {
                                                                        let _e1862 = (_e1857 >> bitcast<u32>(2i));
                                                                        let _e1863 = (_e1857 & 3u);
                                                                        if (_e1862 == 0u) {
                                                                            phi_2372_ = _e1709.unnamed.root;
                                                                        } else {
                                                                            phi_2372_ = _e1709.unnamed.first_primitive;
                                                                        }
                                                                        let _e1866 = phi_2372_;
                                                                        if (_e1862 == 0u) {
                                                                            phi_2382_ = _e1778.unnamed.root;
                                                                        } else {
                                                                            phi_2382_ = _e1778.unnamed.first_primitive;
                                                                        }
                                                                        let _e1875 = phi_2382_;
                                                                        if (_e1862 == 0u) {
                                                                            phi_2392_ = _e1847.unnamed.root;
                                                                        } else {
                                                                            phi_2392_ = _e1847.unnamed.first_primitive;
                                                                        }
                                                                        let _e1884 = phi_2392_;
                                                                        let _e1897 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1866 >> bitcast<u32>(((_e1863 * 8u) & 31u))) & 255u)) * _e1622) + (_e1640 - _e1402)), ((f32(((_e1875 >> bitcast<u32>(((_e1863 * 8u) & 31u))) & 255u)) * _e1623) + (_e1641 - _e1403)));
                                                                        let _e1898 = core_intrinsics_maximum_number_nsz_f32_(_e1897, ((f32(((_e1884 >> bitcast<u32>(((_e1863 * 8u) & 31u))) & 255u)) * _e1624) + (_e1642 - _e1404)));
                                                                        if (_e1862 == 0u) {
                                                                            phi_2410_ = _e1709.unnamed_1.root;
                                                                        } else {
                                                                            phi_2410_ = _e1709.unnamed_1.first_primitive;
                                                                        }
                                                                        let _e1901 = phi_2410_;
                                                                        if (_e1862 == 0u) {
                                                                            phi_2420_ = _e1778.unnamed_1.root;
                                                                        } else {
                                                                            phi_2420_ = _e1778.unnamed_1.first_primitive;
                                                                        }
                                                                        let _e1910 = phi_2420_;
                                                                        if (_e1862 == 0u) {
                                                                            phi_2430_ = _e1847.unnamed_1.root;
                                                                        } else {
                                                                            phi_2430_ = _e1847.unnamed_1.first_primitive;
                                                                        }
                                                                        let _e1919 = phi_2430_;
                                                                        let _e1932 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1901 >> bitcast<u32>(((_e1863 * 8u) & 31u))) & 255u)) * _e1622) + (_e1640 + _e1402)), ((f32(((_e1910 >> bitcast<u32>(((_e1863 * 8u) & 31u))) & 255u)) * _e1623) + (_e1641 + _e1403)));
                                                                        let _e1933 = core_intrinsics_minimum_number_nsz_f32_(_e1932, ((f32(((_e1919 >> bitcast<u32>(((_e1863 * 8u) & 31u))) & 255u)) * _e1624) + (_e1642 + _e1404)));
                                                                        if (_e1898 <= _e1933) {
                                                                            if (_e1898 <= _e275) {
                                                                                if (_e1933 >= 0f) {
                                                                                    if (_e1862 == 0u) {
                                                                                        let _e1940 = nodes.member[(0u + _e1590)].links[2u];
                                                                                        phi_2466_ = _e1940;
                                                                                    } else {
                                                                                        let _e1943 = nodes.member[(0u + _e1590)].links[3u];
                                                                                        phi_2466_ = _e1943;
                                                                                    }
                                                                                    let _e1945 = phi_2466_;
                                                                                    let _e1950 = ((_e1945 >> bitcast<u32>(((_e1863 * 8u) & 31u))) & 255u);
                                                                                    let _e1951 = (_e1950 & 31u);
                                                                                    if (_e1951 >= 24u) {
                                                                                        phi_2479_ = (24u + ((_e1951 - 24u) ^ _e1452));
                                                                                    } else {
                                                                                        phi_2479_ = _e1951;
                                                                                    }
                                                                                    let _e1957 = phi_2479_;
                                                                                    phi_2484_ = (_e1859 | ((_e1950 >> bitcast<u32>(5i)) << bitcast<u32>((_e1957 & 31u))));
                                                                                } else {
                                                                                    phi_2484_ = _e1859;
                                                                                }
                                                                                let _e1965 = phi_2484_;
                                                                                phi_2485_ = _e1965;
                                                                            } else {
                                                                                phi_2485_ = _e1859;
                                                                            }
                                                                            let _e1967 = phi_2485_;
                                                                            phi_2486_ = _e1967;
                                                                        } else {
                                                                            phi_2486_ = _e1859;
                                                                        }
                                                                        let _e1969 = phi_2486_;
                                                                        phi_2356_ = (_e1857 + 1u);
                                                                        phi_2359_ = _e1969;
                                                                    } else {
                                                                        phi_2356_ = u32();
                                                                        phi_2359_ = u32();
                                                                    }
                                                                    let _e1972 = phi_2356_;
                                                                    let _e1974 = phi_2359_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_2355_ = _e1972;
                                                                        phi_2358_ = _e1974;
                                                                        break if !(_e1860);
                                                                    }
                                                                }
                                                                let _e1978 = nodes.member[(0u + _e1590)].links[0u];
                                                                let _e1982 = nodes.member[(0u + _e1590)].frame[3u];
                                                                let _e1986 = local_7;
                                                                if ((_e1986 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1990 = local_1.group_mask;
                                                                    if ((_e1990 & 4278190080u) == 0u) {
                                                                    } else {
                                                                        let _e1994 = local_1.len;
                                                                        if (_e1994 < 32u) {
                                                                            let _e1997 = local_1.group;
                                                                            let _e1999 = local_1.len;
                                                                            if (_e1999 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            local_1.first[(0u + _e1999)] = _e1997;
                                                                            let _e2005 = local_1.group_mask;
                                                                            let _e2007 = local_1.len;
                                                                            if (_e2007 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            local_1.mask[(0u + _e2007)] = _e2005;
                                                                            let _e2014 = local_1.len;
                                                                            local_1.len = (_e2014 + 1u);
                                                                        }
                                                                    }
                                                                    local_1.group = (_e1214 + _e1978);
                                                                    let _e2018 = local_8;
                                                                    local_1.group_mask = ((_e2018 & 4278190080u) | (_e1982 >> bitcast<u32>(24i)));
                                                                }
                                                                let _e2023 = local_9;
                                                                phi_2544_ = (_e2023 & 16777215u);
                                                                loop {
                                                                    let _e2026 = phi_2544_;
                                                                    let _e2027 = (_e2026 == 0u);
                                                                    local_10 = _e2027;
                                                                    local_16 = _e2027;
                                                                    if _e2027 {
                                                                        phi_2545_ = u32();
                                                                        phi_3352_ = false;
                                                                        phi_3353_ = false;
                                                                        phi_3354_ = false;
                                                                    } else {
                                                                        let _e2030 = nodes.member[(0u + _e1590)].links[1u];
                                                                        let _e2035 = ((_e1216 + _e2030) + select(firstTrailingBit(_e2026), 32u, (_e2026 == 0u)));
                                                                        if (_e2035 < _e82) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2042 = triangles.member[(0u + _e2035)].v0_;
                                                                        let _e2044 = (_e2042.x - _e1145);
                                                                        let _e2046 = (_e2042.y - _e1158);
                                                                        let _e2048 = (_e2042.z - _e1171);
                                                                        if (_e1425 == 0u) {
                                                                            phi_2590_ = vec3<f32>(_e2046, _e2048, _e2044);
                                                                        } else {
                                                                            if (_e1425 == 1u) {
                                                                                phi_2589_ = vec3<f32>(_e2048, _e2044, _e2046);
                                                                            } else {
                                                                                phi_2589_ = (_e2042 - vec3<f32>(_e1145, _e1158, _e1171));
                                                                            }
                                                                            let _e2056 = phi_2589_;
                                                                            phi_2590_ = _e2056;
                                                                        }
                                                                        let _e2058 = phi_2590_;
                                                                        let _e2062 = (_e2058.x - (_e1436 * _e2058.z));
                                                                        let _e2066 = (_e2058.y - (_e1439 * _e2058.z));
                                                                        let _e2068 = triangles.member[(0u + _e2035)].v1_;
                                                                        let _e2070 = (_e2068.x - _e1145);
                                                                        let _e2072 = (_e2068.y - _e1158);
                                                                        let _e2074 = (_e2068.z - _e1171);
                                                                        if (_e1425 == 0u) {
                                                                            phi_2620_ = vec3<f32>(_e2072, _e2074, _e2070);
                                                                        } else {
                                                                            if (_e1425 == 1u) {
                                                                                phi_2619_ = vec3<f32>(_e2074, _e2070, _e2072);
                                                                            } else {
                                                                                phi_2619_ = (_e2068 - vec3<f32>(_e1145, _e1158, _e1171));
                                                                            }
                                                                            let _e2082 = phi_2619_;
                                                                            phi_2620_ = _e2082;
                                                                        }
                                                                        let _e2084 = phi_2620_;
                                                                        let _e2088 = (_e2084.x - (_e1436 * _e2084.z));
                                                                        let _e2092 = (_e2084.y - (_e1439 * _e2084.z));
                                                                        let _e2094 = triangles.member[(0u + _e2035)].v2_;
                                                                        let _e2096 = (_e2094.x - _e1145);
                                                                        let _e2098 = (_e2094.y - _e1158);
                                                                        let _e2100 = (_e2094.z - _e1171);
                                                                        if (_e1425 == 0u) {
                                                                            phi_2650_ = vec3<f32>(_e2098, _e2100, _e2096);
                                                                        } else {
                                                                            if (_e1425 == 1u) {
                                                                                phi_2649_ = vec3<f32>(_e2100, _e2096, _e2098);
                                                                            } else {
                                                                                phi_2649_ = (_e2094 - vec3<f32>(_e1145, _e1158, _e1171));
                                                                            }
                                                                            let _e2108 = phi_2649_;
                                                                            phi_2650_ = _e2108;
                                                                        }
                                                                        let _e2110 = phi_2650_;
                                                                        let _e2114 = (_e2110.x - (_e1436 * _e2110.z));
                                                                        let _e2118 = (_e2110.y - (_e1439 * _e2110.z));
                                                                        if (_e2088 < _e2114) {
                                                                            phi_2669_ = true;
                                                                        } else {
                                                                            if (_e2088 == _e2114) {
                                                                                phi_2668_ = (_e2092 < _e2118);
                                                                            } else {
                                                                                phi_2668_ = false;
                                                                            }
                                                                            let _e2123 = phi_2668_;
                                                                            phi_2669_ = _e2123;
                                                                        }
                                                                        let _e2125 = phi_2669_;
                                                                        if _e2125 {
                                                                            phi_2673_ = _e2118;
                                                                            phi_2674_ = _e2114;
                                                                            phi_2675_ = _e2092;
                                                                            phi_2676_ = _e2088;
                                                                        } else {
                                                                            phi_2673_ = _e2092;
                                                                            phi_2674_ = _e2088;
                                                                            phi_2675_ = _e2118;
                                                                            phi_2676_ = _e2114;
                                                                        }
                                                                        let _e2127 = phi_2673_;
                                                                        let _e2129 = phi_2674_;
                                                                        let _e2131 = phi_2675_;
                                                                        let _e2133 = phi_2676_;
                                                                        let _e2136 = ((_e2133 * _e2127) - (_e2131 * _e2129));
                                                                        if _e2125 {
                                                                            phi_2684_ = -(_e2136);
                                                                        } else {
                                                                            phi_2684_ = _e2136;
                                                                        }
                                                                        let _e2139 = phi_2684_;
                                                                        if (_e2114 < _e2062) {
                                                                            phi_2695_ = true;
                                                                        } else {
                                                                            if (_e2114 == _e2062) {
                                                                                phi_2694_ = (_e2118 < _e2066);
                                                                            } else {
                                                                                phi_2694_ = false;
                                                                            }
                                                                            let _e2144 = phi_2694_;
                                                                            phi_2695_ = _e2144;
                                                                        }
                                                                        let _e2146 = phi_2695_;
                                                                        if _e2146 {
                                                                            phi_2699_ = _e2066;
                                                                            phi_2700_ = _e2062;
                                                                            phi_2701_ = _e2118;
                                                                            phi_2702_ = _e2114;
                                                                        } else {
                                                                            phi_2699_ = _e2118;
                                                                            phi_2700_ = _e2114;
                                                                            phi_2701_ = _e2066;
                                                                            phi_2702_ = _e2062;
                                                                        }
                                                                        let _e2148 = phi_2699_;
                                                                        let _e2150 = phi_2700_;
                                                                        let _e2152 = phi_2701_;
                                                                        let _e2154 = phi_2702_;
                                                                        let _e2157 = ((_e2154 * _e2148) - (_e2152 * _e2150));
                                                                        if _e2146 {
                                                                            phi_2710_ = -(_e2157);
                                                                        } else {
                                                                            phi_2710_ = _e2157;
                                                                        }
                                                                        let _e2160 = phi_2710_;
                                                                        if (_e2062 < _e2088) {
                                                                            phi_2721_ = true;
                                                                        } else {
                                                                            if (_e2062 == _e2088) {
                                                                                phi_2720_ = (_e2066 < _e2092);
                                                                            } else {
                                                                                phi_2720_ = false;
                                                                            }
                                                                            let _e2165 = phi_2720_;
                                                                            phi_2721_ = _e2165;
                                                                        }
                                                                        let _e2167 = phi_2721_;
                                                                        if _e2167 {
                                                                            phi_2725_ = _e2092;
                                                                            phi_2726_ = _e2088;
                                                                            phi_2727_ = _e2066;
                                                                            phi_2728_ = _e2062;
                                                                        } else {
                                                                            phi_2725_ = _e2066;
                                                                            phi_2726_ = _e2062;
                                                                            phi_2727_ = _e2092;
                                                                            phi_2728_ = _e2088;
                                                                        }
                                                                        let _e2169 = phi_2725_;
                                                                        let _e2171 = phi_2726_;
                                                                        let _e2173 = phi_2727_;
                                                                        let _e2175 = phi_2728_;
                                                                        let _e2178 = ((_e2175 * _e2169) - (_e2173 * _e2171));
                                                                        if _e2167 {
                                                                            phi_2736_ = -(_e2178);
                                                                        } else {
                                                                            phi_2736_ = _e2178;
                                                                        }
                                                                        let _e2181 = phi_2736_;
                                                                        if (_e2139 >= 0f) {
                                                                            if (_e2160 >= 0f) {
                                                                                if (_e2181 >= 0f) {
                                                                                    phi_2751_ = ((_e2139 + _e2160) + _e2181);
                                                                                    phi_2752_ = false;
                                                                                } else {
                                                                                    phi_2751_ = f32();
                                                                                    phi_2752_ = true;
                                                                                }
                                                                                let _e2188 = phi_2751_;
                                                                                let _e2190 = phi_2752_;
                                                                                phi_2753_ = _e2188;
                                                                                phi_2754_ = _e2190;
                                                                            } else {
                                                                                phi_2753_ = f32();
                                                                                phi_2754_ = true;
                                                                            }
                                                                            let _e2192 = phi_2753_;
                                                                            let _e2194 = phi_2754_;
                                                                            phi_2755_ = _e2192;
                                                                            phi_2756_ = _e2194;
                                                                        } else {
                                                                            phi_2755_ = f32();
                                                                            phi_2756_ = true;
                                                                        }
                                                                        let _e2196 = phi_2755_;
                                                                        let _e2198 = phi_2756_;
                                                                        if _e2198 {
                                                                            if (_e2139 <= 0f) {
                                                                                if (_e2160 <= 0f) {
                                                                                    let _e2201 = (_e2181 <= 0f);
                                                                                    if _e2201 {
                                                                                    }
                                                                                    phi_2774_ = ((_e2139 + _e2160) + _e2181);
                                                                                    phi_2775_ = false;
                                                                                    phi_2776_ = _e2201;
                                                                                } else {
                                                                                    phi_2774_ = f32();
                                                                                    phi_2775_ = true;
                                                                                    phi_2776_ = false;
                                                                                }
                                                                                let _e2205 = phi_2774_;
                                                                                let _e2207 = phi_2775_;
                                                                                let _e2209 = phi_2776_;
                                                                                phi_2777_ = _e2205;
                                                                                phi_2778_ = _e2207;
                                                                                phi_2779_ = _e2209;
                                                                            } else {
                                                                                phi_2777_ = f32();
                                                                                phi_2778_ = true;
                                                                                phi_2779_ = false;
                                                                            }
                                                                            let _e2211 = phi_2777_;
                                                                            let _e2213 = phi_2778_;
                                                                            let _e2215 = phi_2779_;
                                                                            if _e2213 {
                                                                                phi_2783_ = false;
                                                                            } else {
                                                                                phi_2783_ = _e2215;
                                                                            }
                                                                            let _e2217 = phi_2783_;
                                                                            phi_2784_ = _e2211;
                                                                            phi_2785_ = _e2217;
                                                                        } else {
                                                                            phi_2784_ = _e2196;
                                                                            phi_2785_ = true;
                                                                        }
                                                                        let _e2219 = phi_2784_;
                                                                        let _e2221 = phi_2785_;
                                                                        if _e2221 {
                                                                            let _e2222 = (_e2219 == 0f);
                                                                            if _e2222 {
                                                                                phi_3101_ = lt_bvh_triangle_Intersection();
                                                                                phi_3102_ = false;
                                                                            } else {
                                                                                let _e2224 = triangles.member[(0u + _e2035)].v0_;
                                                                                let _e2226 = (_e2224.x - _e1145);
                                                                                let _e2228 = (_e2224.y - _e1158);
                                                                                let _e2230 = (_e2224.z - _e1171);
                                                                                if (_e1425 == 0u) {
                                                                                    phi_2814_ = vec3<f32>(_e2228, _e2230, _e2226);
                                                                                } else {
                                                                                    if (_e1425 == 1u) {
                                                                                        phi_2813_ = vec3<f32>(_e2230, _e2226, _e2228);
                                                                                    } else {
                                                                                        phi_2813_ = (_e2224 - vec3<f32>(_e1145, _e1158, _e1171));
                                                                                    }
                                                                                    let _e2238 = phi_2813_;
                                                                                    phi_2814_ = _e2238;
                                                                                }
                                                                                let _e2240 = phi_2814_;
                                                                                let _e2242 = triangles.member[(0u + _e2035)].v1_;
                                                                                let _e2244 = triangles.member[(0u + _e2035)].v0_;
                                                                                let _e2247 = (_e2242.x - _e2244.x);
                                                                                let _e2250 = (_e2242.y - _e2244.y);
                                                                                let _e2253 = (_e2242.z - _e2244.z);
                                                                                if (_e1425 == 0u) {
                                                                                    phi_2840_ = vec3<f32>(_e2250, _e2253, _e2247);
                                                                                } else {
                                                                                    if (_e1425 == 1u) {
                                                                                        phi_2839_ = vec3<f32>(_e2253, _e2247, _e2250);
                                                                                    } else {
                                                                                        phi_2839_ = (_e2242 - _e2244);
                                                                                    }
                                                                                    let _e2260 = phi_2839_;
                                                                                    phi_2840_ = _e2260;
                                                                                }
                                                                                let _e2262 = phi_2840_;
                                                                                let _e2264 = triangles.member[(0u + _e2035)].v2_;
                                                                                let _e2266 = triangles.member[(0u + _e2035)].v0_;
                                                                                let _e2269 = (_e2264.x - _e2266.x);
                                                                                let _e2272 = (_e2264.y - _e2266.y);
                                                                                let _e2275 = (_e2264.z - _e2266.z);
                                                                                if (_e1425 == 0u) {
                                                                                    phi_2866_ = vec3<f32>(_e2272, _e2275, _e2269);
                                                                                } else {
                                                                                    if (_e1425 == 1u) {
                                                                                        phi_2865_ = vec3<f32>(_e2275, _e2269, _e2272);
                                                                                    } else {
                                                                                        phi_2865_ = (_e2264 - _e2266);
                                                                                    }
                                                                                    let _e2282 = phi_2865_;
                                                                                    phi_2866_ = _e2282;
                                                                                }
                                                                                let _e2284 = phi_2866_;
                                                                                let _e2291 = ((_e2262.y * _e2284.z) - (_e2262.z * _e2284.y));
                                                                                let _e2298 = ((_e2262.z * _e2284.x) - (_e2262.x * _e2284.z));
                                                                                let _e2305 = ((_e2262.x * _e2284.y) - (_e2262.y * _e2284.x));
                                                                                let _e2319 = (((1f / _e1433.z) * (((_e2291 * _e2240.x) + (_e2298 * _e2240.y)) + (_e2305 * _e2240.z))) / (((_e2291 * _e1436) + (_e2298 * _e1439)) + _e2305));
                                                                                if (_e2319 > 0f) {
                                                                                    if (_e2319 < _e275) {
                                                                                        let _e2323 = triangles.member[(0u + _e2035)].v0_;
                                                                                        let _e2325 = triangles.member[(0u + _e2035)].v1_;
                                                                                        if (_e2323.x < _e2325.x) {
                                                                                            phi_2922_ = _e2323.x;
                                                                                        } else {
                                                                                            phi_2922_ = _e2325.x;
                                                                                        }
                                                                                        let _e2332 = phi_2922_;
                                                                                        if (_e2323.y < _e2325.y) {
                                                                                            phi_2931_ = _e2323.y;
                                                                                        } else {
                                                                                            phi_2931_ = _e2325.y;
                                                                                        }
                                                                                        let _e2339 = phi_2931_;
                                                                                        if (_e2323.z < _e2325.z) {
                                                                                            phi_2940_ = _e2323.z;
                                                                                        } else {
                                                                                            phi_2940_ = _e2325.z;
                                                                                        }
                                                                                        let _e2346 = phi_2940_;
                                                                                        let _e2348 = triangles.member[(0u + _e2035)].v2_;
                                                                                        if (_e2332 < _e2348.x) {
                                                                                            phi_2949_ = _e2332;
                                                                                        } else {
                                                                                            phi_2949_ = _e2348.x;
                                                                                        }
                                                                                        let _e2353 = phi_2949_;
                                                                                        if (_e2339 < _e2348.y) {
                                                                                            phi_2956_ = _e2339;
                                                                                        } else {
                                                                                            phi_2956_ = _e2348.y;
                                                                                        }
                                                                                        let _e2358 = phi_2956_;
                                                                                        if (_e2346 < _e2348.z) {
                                                                                            phi_2963_ = _e2346;
                                                                                        } else {
                                                                                            phi_2963_ = _e2348.z;
                                                                                        }
                                                                                        let _e2363 = phi_2963_;
                                                                                        let _e2365 = triangles.member[(0u + _e2035)].v0_;
                                                                                        let _e2367 = triangles.member[(0u + _e2035)].v1_;
                                                                                        if (_e2365.x > _e2367.x) {
                                                                                            phi_2976_ = _e2365.x;
                                                                                        } else {
                                                                                            phi_2976_ = _e2367.x;
                                                                                        }
                                                                                        let _e2374 = phi_2976_;
                                                                                        if (_e2365.y > _e2367.y) {
                                                                                            phi_2985_ = _e2365.y;
                                                                                        } else {
                                                                                            phi_2985_ = _e2367.y;
                                                                                        }
                                                                                        let _e2381 = phi_2985_;
                                                                                        if (_e2365.z > _e2367.z) {
                                                                                            phi_2994_ = _e2365.z;
                                                                                        } else {
                                                                                            phi_2994_ = _e2367.z;
                                                                                        }
                                                                                        let _e2388 = phi_2994_;
                                                                                        let _e2390 = triangles.member[(0u + _e2035)].v2_;
                                                                                        if (_e2374 > _e2390.x) {
                                                                                            phi_3003_ = _e2374;
                                                                                        } else {
                                                                                            phi_3003_ = _e2390.x;
                                                                                        }
                                                                                        let _e2395 = phi_3003_;
                                                                                        if (_e2381 > _e2390.y) {
                                                                                            phi_3010_ = _e2381;
                                                                                        } else {
                                                                                            phi_3010_ = _e2390.y;
                                                                                        }
                                                                                        let _e2400 = phi_3010_;
                                                                                        if (_e2388 > _e2390.z) {
                                                                                            phi_3017_ = _e2388;
                                                                                        } else {
                                                                                            phi_3017_ = _e2390.z;
                                                                                        }
                                                                                        let _e2405 = phi_3017_;
                                                                                        let _e2409 = ((_e2353 - _e1145) * _e1354);
                                                                                        let _e2410 = ((_e2358 - _e1158) * _e1364);
                                                                                        let _e2411 = ((_e2363 - _e1171) * _e1374);
                                                                                        let _e2415 = ((_e2395 - _e1145) * _e1354);
                                                                                        let _e2416 = ((_e2400 - _e1158) * _e1364);
                                                                                        let _e2417 = ((_e2405 - _e1171) * _e1374);
                                                                                        if (_e2409 < _e2415) {
                                                                                            phi_3034_ = _e2409;
                                                                                        } else {
                                                                                            phi_3034_ = _e2415;
                                                                                        }
                                                                                        let _e2420 = phi_3034_;
                                                                                        if (_e2410 < _e2416) {
                                                                                            phi_3039_ = _e2410;
                                                                                        } else {
                                                                                            phi_3039_ = _e2416;
                                                                                        }
                                                                                        let _e2423 = phi_3039_;
                                                                                        if (_e2411 < _e2417) {
                                                                                            phi_3044_ = _e2411;
                                                                                        } else {
                                                                                            phi_3044_ = _e2417;
                                                                                        }
                                                                                        let _e2426 = phi_3044_;
                                                                                        if (_e2409 > _e2415) {
                                                                                            phi_3052_ = _e2409;
                                                                                        } else {
                                                                                            phi_3052_ = _e2415;
                                                                                        }
                                                                                        let _e2432 = phi_3052_;
                                                                                        if (_e2410 > _e2416) {
                                                                                            phi_3057_ = _e2410;
                                                                                        } else {
                                                                                            phi_3057_ = _e2416;
                                                                                        }
                                                                                        let _e2435 = phi_3057_;
                                                                                        if (_e2411 > _e2417) {
                                                                                            phi_3062_ = _e2411;
                                                                                        } else {
                                                                                            phi_3062_ = _e2417;
                                                                                        }
                                                                                        let _e2438 = phi_3062_;
                                                                                        let _e2442 = core_intrinsics_maximum_number_nsz_f32_((_e2420 - _e1409), (_e2423 - _e1410));
                                                                                        let _e2443 = core_intrinsics_maximum_number_nsz_f32_(_e2442, (_e2426 - _e1411));
                                                                                        let _e2444 = core_intrinsics_minimum_number_nsz_f32_((_e2432 + _e1409), (_e2435 + _e1410));
                                                                                        let _e2445 = core_intrinsics_minimum_number_nsz_f32_(_e2444, (_e2438 + _e1411));
                                                                                        if (_e2443 > _e1126) {
                                                                                            phi_3074_ = _e2443;
                                                                                        } else {
                                                                                            phi_3074_ = _e1126;
                                                                                        }
                                                                                        let _e2448 = phi_3074_;
                                                                                        if (_e2445 < _e1128) {
                                                                                            phi_3079_ = _e2445;
                                                                                        } else {
                                                                                            phi_3079_ = _e1128;
                                                                                        }
                                                                                        let _e2451 = phi_3079_;
                                                                                        if (_e2319 < _e2448) {
                                                                                            phi_3084_ = _e2448;
                                                                                        } else {
                                                                                            phi_3084_ = _e2319;
                                                                                        }
                                                                                        let _e2454 = phi_3084_;
                                                                                        if (_e2454 > _e2451) {
                                                                                            phi_3089_ = _e2451;
                                                                                        } else {
                                                                                            phi_3089_ = _e2454;
                                                                                        }
                                                                                        let _e2457 = phi_3089_;
                                                                                        phi_3094_ = lt_bvh_triangle_Intersection(_e2457, (_e2160 / _e2219), (_e2181 / _e2219), (_e2448 <= _e2451));
                                                                                        phi_3095_ = false;
                                                                                    } else {
                                                                                        phi_3094_ = lt_bvh_triangle_Intersection();
                                                                                        phi_3095_ = true;
                                                                                    }
                                                                                    let _e2463 = phi_3094_;
                                                                                    let _e2465 = phi_3095_;
                                                                                    phi_3096_ = _e2463;
                                                                                    phi_3097_ = _e2465;
                                                                                } else {
                                                                                    phi_3096_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3097_ = true;
                                                                                }
                                                                                let _e2467 = phi_3096_;
                                                                                let _e2469 = phi_3097_;
                                                                                if _e2469 {
                                                                                }
                                                                                phi_3101_ = _e2467;
                                                                                phi_3102_ = _e2469;
                                                                            }
                                                                            let _e2471 = phi_3101_;
                                                                            let _e2473 = phi_3102_;
                                                                            phi_3103_ = _e2471;
                                                                            phi_3104_ = _e2222;
                                                                            phi_3105_ = _e2473;
                                                                        } else {
                                                                            phi_3103_ = lt_bvh_triangle_Intersection();
                                                                            phi_3104_ = true;
                                                                            phi_3105_ = false;
                                                                        }
                                                                        let _e2475 = phi_3103_;
                                                                        let _e2477 = phi_3104_;
                                                                        let _e2479 = phi_3105_;
                                                                        if _e2477 {
                                                                            phi_3109_ = true;
                                                                        } else {
                                                                            phi_3109_ = _e2479;
                                                                        }
                                                                        let _e2481 = phi_3109_;
                                                                        if _e2481 {
                                                                            phi_3113_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                        } else {
                                                                            phi_3113_ = _e2475;
                                                                        }
                                                                        let _e2483 = phi_3113_;
                                                                        if _e2483.is_hit {
                                                                            if (_e2483.t > 0f) {
                                                                                if (_e2483.t < _e275) {
                                                                                    let _e2490 = triangles.member[(0u + _e2035)].i0_;
                                                                                    let _e2492 = ((_e2490 & 2147483648u) == 0u);
                                                                                    if _e2492 {
                                                                                        phi_3336_ = false;
                                                                                        phi_3337_ = false;
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
                                                                                                phi_3330_ = true;
                                                                                            } else {
                                                                                                let _e2555 = (_e2523.base_color.w * ((((f32((_e2517[0].color >> bitcast<u32>(24i))) * _e2528) + (f32((_e2517[1].color >> bitcast<u32>(24i))) * _e2483.u)) + (f32((_e2517[2].color >> bitcast<u32>(24i))) * _e2483.v)) * (1f / 255f)));
                                                                                                if (_e2523.alpha_size == 0u) {
                                                                                                    phi_3327_ = _e2555;
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
                                                                                                    phi_3327_ = (_e2555 * (((((f32(((_e2594 >> bitcast<u32>((((_e2586.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2586.weights.x) + ((f32(((_e2614 >> bitcast<u32>((((_e2586.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2586.weights.y)) + ((f32(((_e2635 >> bitcast<u32>((((_e2586.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2586.weights.z)) + ((f32(((_e2656 >> bitcast<u32>((((_e2586.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2586.weights.w)));
                                                                                                }
                                                                                                let _e2672 = phi_3327_;
                                                                                                phi_3330_ = (_e2672 >= _e2523.cutoff);
                                                                                            }
                                                                                            let _e2676 = phi_3330_;
                                                                                            phi_3331_ = _e2676;
                                                                                        } else {
                                                                                            phi_3331_ = false;
                                                                                        }
                                                                                        let _e2678 = phi_3331_;
                                                                                        if _e2678 {
                                                                                            phi_3335_ = false;
                                                                                        } else {
                                                                                            phi_3335_ = true;
                                                                                        }
                                                                                        let _e2680 = phi_3335_;
                                                                                        phi_3336_ = _e2680;
                                                                                        phi_3337_ = _e2678;
                                                                                    }
                                                                                    let _e2682 = phi_3336_;
                                                                                    let _e2684 = phi_3337_;
                                                                                    phi_3338_ = _e2682;
                                                                                    phi_3339_ = _e2492;
                                                                                    phi_3340_ = _e2684;
                                                                                } else {
                                                                                    phi_3338_ = true;
                                                                                    phi_3339_ = false;
                                                                                    phi_3340_ = false;
                                                                                }
                                                                                let _e2686 = phi_3338_;
                                                                                let _e2688 = phi_3339_;
                                                                                let _e2690 = phi_3340_;
                                                                                phi_3341_ = _e2686;
                                                                                phi_3342_ = _e2688;
                                                                                phi_3343_ = _e2690;
                                                                            } else {
                                                                                phi_3341_ = true;
                                                                                phi_3342_ = false;
                                                                                phi_3343_ = false;
                                                                            }
                                                                            let _e2692 = phi_3341_;
                                                                            let _e2694 = phi_3342_;
                                                                            let _e2696 = phi_3343_;
                                                                            phi_3344_ = _e2692;
                                                                            phi_3345_ = _e2694;
                                                                            phi_3346_ = _e2696;
                                                                        } else {
                                                                            phi_3344_ = true;
                                                                            phi_3345_ = false;
                                                                            phi_3346_ = false;
                                                                        }
                                                                        let _e2698 = phi_3344_;
                                                                        let _e2700 = phi_3345_;
                                                                        let _e2702 = phi_3346_;
                                                                        if _e2698 {
                                                                            phi_3350_ = false;
                                                                            phi_3351_ = false;
                                                                        } else {
                                                                            phi_3350_ = _e2700;
                                                                            phi_3351_ = _e2702;
                                                                        }
                                                                        let _e2704 = phi_3350_;
                                                                        let _e2706 = phi_3351_;
                                                                        phi_2545_ = (_e2026 & (_e2026 - 1u));
                                                                        phi_3352_ = _e2698;
                                                                        phi_3353_ = _e2704;
                                                                        phi_3354_ = _e2706;
                                                                    }
                                                                    let _e2708 = phi_2545_;
                                                                    let _e2710 = phi_3352_;
                                                                    let _e2712 = phi_3353_;
                                                                    let _e2714 = phi_3354_;
                                                                    local_14 = _e2712;
                                                                    local_15 = _e2714;
                                                                    continue;
                                                                    continuing {
                                                                        phi_2544_ = _e2708;
                                                                        break if !(_e2710);
                                                                    }
                                                                }
                                                                let _e2717 = local_10;
                                                                if _e2717 {
                                                                    let _e2719 = local_1.group_mask;
                                                                    if ((_e2719 & 4278190080u) == 0u) {
                                                                        let _e2723 = local_1.len;
                                                                        if (_e2723 == 0u) {
                                                                            phi_3396_ = false;
                                                                        } else {
                                                                            let _e2727 = local_1.len;
                                                                            local_1.len = (_e2727 - 1u);
                                                                            let _e2730 = local_1.len;
                                                                            if (_e2730 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            let _e2735 = local_1.first[(0u + _e2730)];
                                                                            local_1.group = _e2735;
                                                                            let _e2738 = local_1.len;
                                                                            if (_e2738 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            let _e2743 = local_1.mask[(0u + _e2738)];
                                                                            local_1.group_mask = _e2743;
                                                                            phi_3396_ = true;
                                                                        }
                                                                        let _e2746 = phi_3396_;
                                                                        phi_3397_ = _e2746;
                                                                    } else {
                                                                        phi_3397_ = true;
                                                                    }
                                                                    let _e2748 = phi_3397_;
                                                                    if _e2748 {
                                                                        let _e2750 = local_1.group_mask;
                                                                        let _e2756 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2750)), 32u, (_e2750 == 0u)));
                                                                        let _e2760 = local_1.group_mask;
                                                                        let _e2774 = local_1.group_mask;
                                                                        local_1.group_mask = (_e2774 & ~((1u << bitcast<u32>((_e2756 & 31u)))));
                                                                        let _e2777 = local_1.group;
                                                                        phi_3428_ = (_e2777 + countOneBits(((_e2760 & ~((4294967295u << bitcast<u32>((((_e2756 - 24u) ^ _e1452) & 31u))))) & 255u)));
                                                                    } else {
                                                                        phi_3428_ = 4294967295u;
                                                                    }
                                                                    let _e2780 = phi_3428_;
                                                                    phi_3429_ = _e2780;
                                                                    phi_3430_ = false;
                                                                    phi_3431_ = false;
                                                                } else {
                                                                    phi_3429_ = u32();
                                                                    let _e3176 = local_14;
                                                                    phi_3430_ = _e3176;
                                                                    let _e3179 = local_15;
                                                                    phi_3431_ = _e3179;
                                                                }
                                                                let _e2782 = phi_3429_;
                                                                let _e2784 = phi_3430_;
                                                                let _e2786 = phi_3431_;
                                                                phi_2215_ = _e2782;
                                                                let _e3183 = local_16;
                                                                phi_3432_ = _e3183;
                                                                phi_3433_ = false;
                                                                phi_3434_ = _e2784;
                                                                phi_3435_ = _e2786;
                                                            } else {
                                                                phi_2215_ = u32();
                                                                phi_3432_ = false;
                                                                phi_3433_ = true;
                                                                phi_3434_ = false;
                                                                phi_3435_ = false;
                                                            }
                                                            let _e2788 = phi_2215_;
                                                            let _e2790 = phi_3432_;
                                                            let _e2792 = phi_3433_;
                                                            let _e2794 = phi_3434_;
                                                            let _e2796 = phi_3435_;
                                                            local_11 = _e2792;
                                                            local_17 = _e2794;
                                                            local_18 = _e2796;
                                                            continue;
                                                            continuing {
                                                                phi_2214_ = _e2788;
                                                                break if !(_e2790);
                                                            }
                                                        }
                                                        let _e2799 = local_11;
                                                        if _e2799 {
                                                            phi_3439_ = false;
                                                            phi_3440_ = false;
                                                        } else {
                                                            let _e3190 = local_17;
                                                            phi_3439_ = _e3190;
                                                            let _e3193 = local_18;
                                                            phi_3440_ = _e3193;
                                                        }
                                                        let _e2801 = phi_3439_;
                                                        let _e2803 = phi_3440_;
                                                        if _e2801 {
                                                            phi_3444_ = true;
                                                        } else {
                                                            phi_3444_ = _e2803;
                                                        }
                                                        let _e2805 = phi_3444_;
                                                        if _e2805 {
                                                            phi_3448_ = true;
                                                        } else {
                                                            phi_3448_ = false;
                                                        }
                                                        let _e2807 = phi_3448_;
                                                        phi_3449_ = _e2807;
                                                    }
                                                    let _e2809 = phi_3449_;
                                                    phi_3450_ = _e2809;
                                                    phi_3451_ = _e1278;
                                                } else {
                                                    phi_3450_ = bool();
                                                    phi_3451_ = true;
                                                }
                                                let _e2811 = phi_3450_;
                                                let _e2813 = phi_3451_;
                                                if _e2813 {
                                                    phi_3455_ = false;
                                                } else {
                                                    phi_3455_ = _e2811;
                                                }
                                                let _e2815 = phi_3455_;
                                                if _e2815 {
                                                    phi_3459_ = false;
                                                } else {
                                                    phi_3459_ = true;
                                                }
                                                let _e2817 = phi_3459_;
                                                phi_3460_ = _e2817;
                                            } else {
                                                phi_3460_ = true;
                                            }
                                            let _e2819 = phi_3460_;
                                            phi_3461_ = _e2819;
                                        } else {
                                            phi_3461_ = true;
                                        }
                                        let _e2821 = phi_3461_;
                                        phi_3462_ = _e2821;
                                    } else {
                                        phi_3462_ = true;
                                    }
                                    let _e2823 = phi_3462_;
                                    if _e2823 {
                                    }
                                    phi_1609_ = (_e1065 & (_e1065 - 1u));
                                    phi_3466_ = _e2823;
                                }
                                let _e2825 = phi_1609_;
                                let _e2827 = phi_3466_;
                                continue;
                                continuing {
                                    phi_1608_ = _e2825;
                                    break if !(_e2827);
                                }
                            }
                            let _e2830 = local_12;
                            if _e2830 {
                                let _e2832 = local_2.group_mask;
                                if ((_e2832 & 4278190080u) == 0u) {
                                    let _e2836 = local_2.len;
                                    if (_e2836 == 0u) {
                                        phi_3508_ = false;
                                    } else {
                                        let _e2840 = local_2.len;
                                        local_2.len = (_e2840 - 1u);
                                        let _e2843 = local_2.len;
                                        if (_e2843 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2848 = local_2.first[(0u + _e2843)];
                                        local_2.group = _e2848;
                                        let _e2851 = local_2.len;
                                        if (_e2851 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2856 = local_2.mask[(0u + _e2851)];
                                        local_2.group_mask = _e2856;
                                        phi_3508_ = true;
                                    }
                                    let _e2859 = phi_3508_;
                                    phi_3509_ = _e2859;
                                } else {
                                    phi_3509_ = true;
                                }
                                let _e2861 = phi_3509_;
                                if _e2861 {
                                    let _e2863 = local_2.group_mask;
                                    let _e2869 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2863)), 32u, (_e2863 == 0u)));
                                    let _e2873 = local_2.group_mask;
                                    let _e2887 = local_2.group_mask;
                                    local_2.group_mask = (_e2887 & ~((1u << bitcast<u32>((_e2869 & 31u)))));
                                    let _e2890 = local_2.group;
                                    phi_3540_ = (_e2890 + countOneBits(((_e2873 & ~((4294967295u << bitcast<u32>((((_e2869 - 24u) ^ _e491) & 31u))))) & 255u)));
                                } else {
                                    phi_3540_ = 4294967295u;
                                }
                                let _e2893 = phi_3540_;
                                phi_3541_ = _e2893;
                            } else {
                                phi_3541_ = u32();
                            }
                            let _e2895 = phi_3541_;
                            phi_1279_ = _e2895;
                            let _e3214 = local_19;
                            phi_3542_ = _e3214;
                            phi_3543_ = false;
                        } else {
                            phi_1279_ = u32();
                            phi_3542_ = false;
                            phi_3543_ = true;
                        }
                        let _e2897 = phi_1279_;
                        let _e2899 = phi_3542_;
                        let _e2901 = phi_3543_;
                        local_13 = _e2901;
                        continue;
                        continuing {
                            phi_1278_ = _e2897;
                            break if !(_e2899);
                        }
                    }
                    let _e2904 = local_13;
                    if _e2904 {
                        phi_3547_ = false;
                    } else {
                        phi_3547_ = true;
                    }
                    let _e2906 = phi_3547_;
                    if _e2906 {
                        phi_3551_ = true;
                    } else {
                        phi_3551_ = false;
                    }
                    let _e2908 = phi_3551_;
                    phi_3552_ = _e2908;
                }
                let _e2910 = phi_3552_;
                phi_3553_ = _e2910;
                phi_3554_ = _e347;
            } else {
                phi_3553_ = bool();
                phi_3554_ = true;
            }
            let _e2912 = phi_3553_;
            let _e2914 = phi_3554_;
            if _e2914 {
                phi_3558_ = false;
            } else {
                phi_3558_ = _e2912;
            }
            let _e2916 = phi_3558_;
            if _e2916 {
                phi_3562_ = 0f;
            } else {
                phi_3562_ = 1f;
            }
            let _e2918 = phi_3562_;
            phi_3563_ = _e2918;
        }
        let _e2920 = phi_3563_;
        if (_e103.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e103.first_primitive)] = _e2920;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_instanced_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
