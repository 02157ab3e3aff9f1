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

struct type_33 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_37 {
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

struct type_41 {
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

struct type_54 {
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
    light: vec4<f32>,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_62 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(7) 
var<storage> alpha_texels: type_13;
@group(0) @binding(0) 
var<uniform> p: type_62;
@group(0) @binding(2) 
var<storage> nodes: type_54;
@group(0) @binding(3) 
var<storage> triangles: type_33;
@group(0) @binding(5) 
var<storage> vertices: type_37;
@group(0) @binding(6) 
var<storage> materials: type_41;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_217_: lt_bvh_traverse_Tree;
    var phi_218_: bool;
    var phi_219_: lt_bvh_traverse_Tree;
    var phi_220_: bool;
    var phi_225_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_217_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_218_ = false;
        } else {
            phi_217_ = lt_bvh_traverse_Tree();
            phi_218_ = true;
        }
        let _e81 = phi_217_;
        let _e83 = phi_218_;
        phi_219_ = _e81;
        phi_220_ = _e83;
    } else {
        phi_219_ = lt_bvh_traverse_Tree();
        phi_220_ = true;
    }
    let _e85 = phi_219_;
    let _e87 = phi_220_;
    if _e87 {
        phi_225_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_225_ = _e85;
    }
    let _e92 = phi_225_;
    return lt_bvh_traverse_Tree(_e92.root, _e92.first_primitive);
}

fn _lt_shaders_texture_TextureView_quad(param_3: ptr<function, texture_TextureView>, param_4: f32, param_5: f32) -> texture_TexelQuad {
    var phi_270_: f32;
    var phi_275_: f32;
    var phi_276_: bool;
    var phi_277_: f32;
    var phi_278_: bool;
    var phi_282_: f32;
    var phi_308_: f32;
    var phi_313_: f32;
    var phi_314_: bool;
    var phi_315_: f32;
    var phi_316_: bool;
    var phi_320_: f32;
    var phi_328_: f32;
    var phi_329_: f32;
    var phi_330_: f32;
    var phi_339_: f32;
    var phi_340_: f32;
    var phi_358_: u32;
    var phi_372_: u32;
    var phi_379_: u32;
    var phi_384_: u32;
    var phi_390_: u32;
    var phi_395_: u32;
    var phi_397_: texture_Axis;
    var phi_425_: f32;
    var phi_430_: f32;
    var phi_431_: bool;
    var phi_432_: f32;
    var phi_433_: bool;
    var phi_437_: f32;
    var phi_463_: f32;
    var phi_468_: f32;
    var phi_469_: bool;
    var phi_470_: f32;
    var phi_471_: bool;
    var phi_475_: f32;
    var phi_483_: f32;
    var phi_484_: f32;
    var phi_485_: f32;
    var phi_494_: f32;
    var phi_495_: f32;
    var phi_513_: u32;
    var phi_527_: u32;
    var phi_534_: u32;
    var phi_539_: u32;
    var phi_545_: u32;
    var phi_550_: u32;
    var phi_552_: texture_Axis;

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
                phi_270_ = 1f;
            } else {
                phi_270_ = 0f;
            }
            let _e102 = phi_270_;
            if (param_4 < 8388608f) {
                phi_275_ = (_e99 - _e102);
                phi_276_ = false;
            } else {
                phi_275_ = f32();
                phi_276_ = true;
            }
            let _e105 = phi_275_;
            let _e107 = phi_276_;
            phi_277_ = _e105;
            phi_278_ = _e107;
        } else {
            phi_277_ = f32();
            phi_278_ = true;
        }
        let _e109 = phi_277_;
        let _e111 = phi_278_;
        if _e111 {
            phi_282_ = param_4;
        } else {
            phi_282_ = _e109;
        }
        let _e113 = phi_282_;
        phi_330_ = (param_4 - _e113);
    } else {
        if (_e86 == 1u) {
            let _e116 = (param_4 * 0.5f);
            if (_e116 > -8388608f) {
                let _e128 = f32(select(0i, select(select(i32(_e116), i32(-2147483648), (_e116 < bitcast<f32>(3472883712u))), 2147483647i, (_e116 > bitcast<f32>(1325400063u))), (_e116 == _e116)));
                if (_e128 > _e116) {
                    phi_308_ = 1f;
                } else {
                    phi_308_ = 0f;
                }
                let _e131 = phi_308_;
                if (_e116 < 8388608f) {
                    phi_313_ = (_e128 - _e131);
                    phi_314_ = false;
                } else {
                    phi_313_ = f32();
                    phi_314_ = true;
                }
                let _e134 = phi_313_;
                let _e136 = phi_314_;
                phi_315_ = _e134;
                phi_316_ = _e136;
            } else {
                phi_315_ = f32();
                phi_316_ = true;
            }
            let _e138 = phi_315_;
            let _e140 = phi_316_;
            if _e140 {
                phi_320_ = _e116;
            } else {
                phi_320_ = _e138;
            }
            let _e142 = phi_320_;
            let _e144 = (param_4 - (2f * _e142));
            if (_e144 > 1f) {
                phi_328_ = (2f - _e144);
            } else {
                phi_328_ = _e144;
            }
            let _e148 = phi_328_;
            phi_329_ = _e148;
        } else {
            phi_329_ = param_4;
        }
        let _e150 = phi_329_;
        phi_330_ = _e150;
    }
    let _e152 = phi_330_;
    if (_e152 > 0f) {
        if (_e152 < 1f) {
            phi_339_ = _e152;
        } else {
            phi_339_ = 1f;
        }
        let _e156 = phi_339_;
        phi_340_ = _e156;
    } else {
        phi_340_ = 0f;
    }
    let _e158 = phi_340_;
    let _e159 = (_e73 - 1u);
    let _e161 = (_e158 * f32(_e73));
    if _e81 {
        let _e168 = select(select(u32(_e161), 0u, (_e161 < bitcast<f32>(0u))), 4294967295u, (_e161 > bitcast<f32>(1333788671u)));
        if (_e159 < _e168) {
            phi_358_ = _e159;
        } else {
            phi_358_ = _e168;
        }
        let _e171 = phi_358_;
        phi_397_ = texture_Axis(_e171, _e171, 0f);
    } else {
        let _e173 = (_e161 + 0.5f);
        let _e180 = select(select(u32(_e173), 0u, (_e173 < bitcast<f32>(0u))), 4294967295u, (_e173 > bitcast<f32>(1333788671u)));
        if (_e73 < _e180) {
            phi_372_ = _e73;
        } else {
            phi_372_ = _e180;
        }
        let _e183 = phi_372_;
        if (_e86 == 0u) {
            phi_379_ = _e159;
        } else {
            phi_379_ = 0u;
        }
        let _e188 = phi_379_;
        if (_e86 == 0u) {
            phi_384_ = 0u;
        } else {
            phi_384_ = _e159;
        }
        let _e191 = phi_384_;
        if (_e183 == 0u) {
            phi_390_ = _e188;
        } else {
            phi_390_ = (_e183 - 1u);
        }
        let _e195 = phi_390_;
        if (_e183 > _e159) {
            phi_395_ = _e191;
        } else {
            phi_395_ = _e183;
        }
        let _e198 = phi_395_;
        phi_397_ = texture_Axis(_e195, _e198, (_e173 - f32(_e183)));
    }
    let _e201 = phi_397_;
    let _e203 = (*param_3).flags;
    let _e206 = ((_e203 >> bitcast<u32>(6u)) & 3u);
    if (_e206 == 0u) {
        if (param_5 > -8388608f) {
            let _e219 = f32(select(0i, select(select(i32(param_5), i32(-2147483648), (param_5 < bitcast<f32>(3472883712u))), 2147483647i, (param_5 > bitcast<f32>(1325400063u))), (param_5 == param_5)));
            if (_e219 > param_5) {
                phi_425_ = 1f;
            } else {
                phi_425_ = 0f;
            }
            let _e222 = phi_425_;
            if (param_5 < 8388608f) {
                phi_430_ = (_e219 - _e222);
                phi_431_ = false;
            } else {
                phi_430_ = f32();
                phi_431_ = true;
            }
            let _e225 = phi_430_;
            let _e227 = phi_431_;
            phi_432_ = _e225;
            phi_433_ = _e227;
        } else {
            phi_432_ = f32();
            phi_433_ = true;
        }
        let _e229 = phi_432_;
        let _e231 = phi_433_;
        if _e231 {
            phi_437_ = param_5;
        } else {
            phi_437_ = _e229;
        }
        let _e233 = phi_437_;
        phi_485_ = (param_5 - _e233);
    } else {
        if (_e206 == 1u) {
            let _e236 = (param_5 * 0.5f);
            if (_e236 > -8388608f) {
                let _e248 = f32(select(0i, select(select(i32(_e236), i32(-2147483648), (_e236 < bitcast<f32>(3472883712u))), 2147483647i, (_e236 > bitcast<f32>(1325400063u))), (_e236 == _e236)));
                if (_e248 > _e236) {
                    phi_463_ = 1f;
                } else {
                    phi_463_ = 0f;
                }
                let _e251 = phi_463_;
                if (_e236 < 8388608f) {
                    phi_468_ = (_e248 - _e251);
                    phi_469_ = false;
                } else {
                    phi_468_ = f32();
                    phi_469_ = true;
                }
                let _e254 = phi_468_;
                let _e256 = phi_469_;
                phi_470_ = _e254;
                phi_471_ = _e256;
            } else {
                phi_470_ = f32();
                phi_471_ = true;
            }
            let _e258 = phi_470_;
            let _e260 = phi_471_;
            if _e260 {
                phi_475_ = _e236;
            } else {
                phi_475_ = _e258;
            }
            let _e262 = phi_475_;
            let _e264 = (param_5 - (2f * _e262));
            if (_e264 > 1f) {
                phi_483_ = (2f - _e264);
            } else {
                phi_483_ = _e264;
            }
            let _e268 = phi_483_;
            phi_484_ = _e268;
        } else {
            phi_484_ = param_5;
        }
        let _e270 = phi_484_;
        phi_485_ = _e270;
    }
    let _e272 = phi_485_;
    if (_e272 > 0f) {
        if (_e272 < 1f) {
            phi_494_ = _e272;
        } else {
            phi_494_ = 1f;
        }
        let _e276 = phi_494_;
        phi_495_ = _e276;
    } else {
        phi_495_ = 0f;
    }
    let _e278 = phi_495_;
    let _e279 = (_e77 - 1u);
    let _e281 = (_e278 * f32(_e77));
    if _e81 {
        let _e288 = select(select(u32(_e281), 0u, (_e281 < bitcast<f32>(0u))), 4294967295u, (_e281 > bitcast<f32>(1333788671u)));
        if (_e279 < _e288) {
            phi_513_ = _e279;
        } else {
            phi_513_ = _e288;
        }
        let _e291 = phi_513_;
        phi_552_ = texture_Axis(_e291, _e291, 0f);
    } else {
        let _e293 = (_e281 + 0.5f);
        let _e300 = select(select(u32(_e293), 0u, (_e293 < bitcast<f32>(0u))), 4294967295u, (_e293 > bitcast<f32>(1333788671u)));
        if (_e77 < _e300) {
            phi_527_ = _e77;
        } else {
            phi_527_ = _e300;
        }
        let _e303 = phi_527_;
        if (_e206 == 0u) {
            phi_534_ = _e279;
        } else {
            phi_534_ = 0u;
        }
        let _e308 = phi_534_;
        if (_e206 == 0u) {
            phi_539_ = 0u;
        } else {
            phi_539_ = _e279;
        }
        let _e311 = phi_539_;
        if (_e303 == 0u) {
            phi_545_ = _e308;
        } else {
            phi_545_ = (_e303 - 1u);
        }
        let _e315 = phi_545_;
        if (_e303 > _e279) {
            phi_550_ = _e311;
        } else {
            phi_550_ = _e303;
        }
        let _e318 = phi_550_;
        phi_552_ = texture_Axis(_e315, _e318, (_e293 - f32(_e303)));
    }
    let _e321 = phi_552_;
    let _e325 = (*param_3).offset;
    let _e332 = (*param_3).offset;
    let _e339 = (*param_3).offset;
    let _e346 = (*param_3).offset;
    return texture_TexelQuad(array<u32, 4>(((_e325 + (_e321.low * _e73)) + _e201.low), ((_e332 + (_e321.low * _e73)) + _e201.high), ((_e339 + (_e321.high * _e73)) + _e201.low), ((_e346 + (_e321.high * _e73)) + _e201.high)), vec4<f32>(((1f - _e201.fraction) * (1f - _e321.fraction)), (_e201.fraction * (1f - _e321.fraction)), ((1f - _e201.fraction) * _e321.fraction), (_e201.fraction * _e321.fraction)));
}

fn core_intrinsics_maximum_number_nsz_f32_(param_6: f32, param_7: f32) -> f32 {
    var phi_611_: bool;
    var phi_615_: f32;

    if (param_6 != param_6) {
        phi_611_ = true;
    } else {
        let _e71 = (param_7 >= param_6);
        if _e71 {
        }
        phi_611_ = _e71;
    }
    let _e73 = phi_611_;
    if _e73 {
        phi_615_ = param_7;
    } else {
        phi_615_ = param_6;
    }
    let _e75 = phi_615_;
    return _e75;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_8: f32, param_9: f32) -> f32 {
    var phi_627_: bool;
    var phi_631_: f32;

    if (param_8 != param_8) {
        phi_627_ = true;
    } else {
        let _e71 = (param_9 <= param_8);
        if _e71 {
        }
        phi_627_ = _e71;
    }
    let _e73 = phi_627_;
    if _e73 {
        phi_631_ = param_9;
    } else {
        phi_631_ = param_8;
    }
    let _e75 = phi_631_;
    return _e75;
}

fn _lt_shaders_abi_Sample_is_valid(param_10: ptr<function, abi_Sample>) -> bool {
    var phi_656_: bool;
    var phi_657_: bool;
    var phi_658_: bool;
    var phi_659_: bool;
    var phi_663_: bool;

    let _e71 = (*param_10).normal[0u];
    let _e73 = global[0u];
    if (_e71 == _e73) {
        let _e76 = (*param_10).normal[1u];
        let _e78 = global[1u];
        if (_e76 == _e78) {
            let _e81 = (*param_10).normal[2u];
            let _e83 = global[2u];
            phi_656_ = (_e81 == _e83);
            phi_657_ = false;
        } else {
            phi_656_ = bool();
            phi_657_ = true;
        }
        let _e86 = phi_656_;
        let _e88 = phi_657_;
        phi_658_ = _e86;
        phi_659_ = _e88;
    } else {
        phi_658_ = bool();
        phi_659_ = true;
    }
    let _e90 = phi_658_;
    let _e92 = phi_659_;
    if _e92 {
        phi_663_ = false;
    } else {
        phi_663_ = _e90;
    }
    let _e94 = phi_663_;
    return !(_e94);
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: abi_Sample;
    var phi_757_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_761_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_807_: f32;
    var phi_862_: bool;
    var phi_863_: bool;
    var phi_864_: bool;
    var phi_868_: bool;
    var phi_869_: bool;
    var phi_870_: bool;
    var phi_871_: bool;
    var phi_872_: bool;
    var phi_873_: bool;
    var phi_874_: bool;
    var phi_875_: bool;
    var phi_876_: bool;
    var phi_877_: bool;
    var phi_878_: bool;
    var phi_879_: bool;
    var phi_880_: bool;
    var phi_881_: bool;
    var phi_882_: bool;
    var phi_883_: bool;
    var phi_884_: bool;
    var phi_885_: bool;
    var phi_889_: bool;
    var phi_893_: bool;
    var phi_963_: f32;
    var phi_970_: f32;
    var phi_977_: f32;
    var phi_984_: f32;
    var phi_991_: f32;
    var phi_998_: f32;
    var phi_1015_: f32;
    var phi_1020_: f32;
    var phi_1025_: f32;
    var phi_1053_: bool;
    var phi_1054_: bool;
    var phi_1062_: u32;
    var phi_1063_: u32;
    var phi_1074_: vec3<f32>;
    var phi_1075_: vec3<f32>;
    var phi_1088_: u32;
    var phi_1093_: u32;
    var phi_1098_: u32;
    var phi_1212_: bool;
    var phi_1213_: bool;
    var phi_1244_: u32;
    var phi_1246_: u32;
    var phi_1327_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1354_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1381_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1387_: u32;
    var phi_1390_: u32;
    var phi_1404_: u32;
    var phi_1414_: u32;
    var phi_1424_: u32;
    var phi_1442_: u32;
    var phi_1452_: u32;
    var phi_1462_: u32;
    var phi_1498_: u32;
    var phi_1511_: u32;
    var phi_1516_: u32;
    var phi_1517_: u32;
    var phi_1518_: u32;
    var phi_1388_: u32;
    var phi_1391_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1576_: u32;
    var phi_1621_: vec3<f32>;
    var phi_1622_: vec3<f32>;
    var phi_1653_: vec3<f32>;
    var phi_1654_: vec3<f32>;
    var phi_1685_: vec3<f32>;
    var phi_1686_: vec3<f32>;
    var phi_1706_: bool;
    var phi_1707_: bool;
    var phi_1711_: f32;
    var phi_1712_: f32;
    var phi_1713_: f32;
    var phi_1714_: f32;
    var phi_1722_: f32;
    var phi_1732_: bool;
    var phi_1733_: bool;
    var phi_1737_: f32;
    var phi_1738_: f32;
    var phi_1739_: f32;
    var phi_1740_: f32;
    var phi_1748_: f32;
    var phi_1758_: bool;
    var phi_1759_: bool;
    var phi_1763_: f32;
    var phi_1764_: f32;
    var phi_1765_: f32;
    var phi_1766_: f32;
    var phi_1774_: f32;
    var phi_1789_: f32;
    var phi_1790_: bool;
    var phi_1791_: f32;
    var phi_1792_: bool;
    var phi_1793_: f32;
    var phi_1794_: bool;
    var phi_1812_: f32;
    var phi_1813_: bool;
    var phi_1814_: bool;
    var phi_1815_: f32;
    var phi_1816_: bool;
    var phi_1817_: bool;
    var phi_1821_: bool;
    var phi_1822_: f32;
    var phi_1823_: bool;
    var phi_1857_: f32;
    var phi_1866_: f32;
    var phi_1875_: f32;
    var phi_1884_: f32;
    var phi_1891_: f32;
    var phi_1898_: f32;
    var phi_1911_: f32;
    var phi_1920_: f32;
    var phi_1929_: f32;
    var phi_1938_: f32;
    var phi_1945_: f32;
    var phi_1952_: f32;
    var phi_1969_: f32;
    var phi_1974_: f32;
    var phi_1979_: f32;
    var phi_1987_: f32;
    var phi_1992_: f32;
    var phi_1997_: f32;
    var phi_2009_: f32;
    var phi_2014_: f32;
    var phi_2019_: f32;
    var phi_2024_: f32;
    var phi_2029_: lt_bvh_triangle_Intersection;
    var phi_2030_: bool;
    var phi_2031_: lt_bvh_triangle_Intersection;
    var phi_2032_: bool;
    var phi_2036_: lt_bvh_triangle_Intersection;
    var phi_2037_: bool;
    var phi_2038_: lt_bvh_triangle_Intersection;
    var phi_2039_: bool;
    var phi_2040_: bool;
    var phi_2044_: bool;
    var phi_2048_: lt_bvh_triangle_Intersection;
    var phi_2262_: f32;
    var phi_2265_: bool;
    var phi_2266_: bool;
    var phi_2270_: bool;
    var phi_2271_: bool;
    var phi_2272_: bool;
    var phi_2273_: bool;
    var phi_2274_: bool;
    var phi_2275_: bool;
    var phi_2276_: bool;
    var phi_2277_: bool;
    var phi_2278_: bool;
    var phi_2279_: bool;
    var phi_2280_: bool;
    var phi_2281_: bool;
    var phi_2285_: bool;
    var phi_2286_: bool;
    var phi_1577_: u32;
    var phi_2287_: bool;
    var phi_2288_: bool;
    var phi_2289_: bool;
    var local_6: bool;
    var phi_2331_: bool;
    var phi_2332_: bool;
    var phi_2363_: u32;
    var phi_2364_: u32;
    var phi_2365_: bool;
    var phi_2366_: bool;
    var phi_1247_: u32;
    var phi_2367_: bool;
    var phi_2368_: bool;
    var phi_2369_: bool;
    var phi_2370_: bool;
    var local_7: bool;
    var phi_2374_: bool;
    var phi_2375_: bool;
    var phi_2379_: bool;
    var phi_2383_: bool;
    var phi_2384_: bool;
    var phi_2385_: bool;
    var phi_2386_: bool;
    var phi_2390_: bool;
    var phi_2394_: f32;
    var phi_2395_: f32;
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
        let _e116 = p.member.light;
        let _e117 = _lt_shaders_abi_Sample_is_valid((&local_2));
        if _e117 {
            let _e119 = local_2.normal;
            let _e121 = local_2.position;
            if ((((_e119.x * (_e116.x - (_e121.x * _e116.w))) + (_e119.y * (_e116.y - (_e121.y * _e116.w)))) + (_e119.z * (_e116.z - (_e121.z * _e116.w)))) > 0f) {
                let _e145 = local_2.flags;
                let _e153 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e159 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e153.unnamed.visibility, false), _e153.unnamed_1);
                phi_757_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e159.unnamed, ((_e145 & 1u) == 0u));
            } else {
                let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
                phi_757_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, true);
            }
            let _e179 = phi_757_;
            phi_761_ = _e179;
        } else {
            let _e185 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e191 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e185.unnamed.visibility, false), _e185.unnamed_1);
            phi_761_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e191.unnamed, true);
        }
        let _e196 = phi_761_;
        if _e196.unnamed_1 {
            phi_2395_ = _e196.unnamed.visibility;
        } else {
            let _e201 = p.member.light;
            let _e203 = local_2.position;
            let _e205 = local_2.normal;
            let _e207 = local_2.magnitude;
            let _e209 = ((8f / 8388608f) * _e207);
            let _e217 = (_e203.x + (_e205.x * _e209));
            let _e219 = (_e203.y + (_e205.y * _e209));
            let _e221 = (_e203.z + (_e205.z * _e209));
            if (_e201.w == 0f) {
                phi_807_ = 300000000000000000000000000000000000000f;
            } else {
                phi_807_ = 1f;
            }
            let _e225 = phi_807_;
            let _e233 = (_e201.x - (_e217 * _e201.w));
            let _e234 = (_e201.y - (_e219 * _e201.w));
            let _e235 = (_e201.z - (_e221 * _e201.w));
            let _e240 = abs(_e233);
            let _e241 = abs(_e234);
            let _e242 = abs(_e235);
            if (abs(_e217) < 1000000000000000f) {
                if (abs(_e219) < 1000000000000000f) {
                    if (abs(_e221) < 1000000000000000f) {
                        if (_e240 < 1000000000000000f) {
                            if (_e241 < 1000000000000000f) {
                                if (_e242 < 1000000000000000f) {
                                    if (_e240 > 0f) {
                                        phi_863_ = bool();
                                        phi_864_ = true;
                                    } else {
                                        let _e250 = (_e241 > 0f);
                                        if _e250 {
                                            phi_862_ = bool();
                                        } else {
                                            phi_862_ = (_e242 > 0f);
                                        }
                                        let _e253 = phi_862_;
                                        phi_863_ = _e253;
                                        phi_864_ = _e250;
                                    }
                                    let _e255 = phi_863_;
                                    let _e257 = phi_864_;
                                    if _e257 {
                                        phi_868_ = true;
                                    } else {
                                        phi_868_ = _e255;
                                    }
                                    let _e259 = phi_868_;
                                    phi_869_ = _e259;
                                    phi_870_ = false;
                                } else {
                                    phi_869_ = bool();
                                    phi_870_ = true;
                                }
                                let _e261 = phi_869_;
                                let _e263 = phi_870_;
                                phi_871_ = _e261;
                                phi_872_ = false;
                                phi_873_ = _e263;
                            } else {
                                phi_871_ = bool();
                                phi_872_ = true;
                                phi_873_ = false;
                            }
                            let _e265 = phi_871_;
                            let _e267 = phi_872_;
                            let _e269 = phi_873_;
                            phi_874_ = _e265;
                            phi_875_ = _e267;
                            phi_876_ = _e269;
                        } else {
                            phi_874_ = bool();
                            phi_875_ = true;
                            phi_876_ = false;
                        }
                        let _e271 = phi_874_;
                        let _e273 = phi_875_;
                        let _e275 = phi_876_;
                        phi_877_ = _e271;
                        phi_878_ = _e273;
                        phi_879_ = _e275;
                    } else {
                        phi_877_ = bool();
                        phi_878_ = true;
                        phi_879_ = false;
                    }
                    let _e277 = phi_877_;
                    let _e279 = phi_878_;
                    let _e281 = phi_879_;
                    phi_880_ = _e277;
                    phi_881_ = _e279;
                    phi_882_ = _e281;
                } else {
                    phi_880_ = bool();
                    phi_881_ = true;
                    phi_882_ = false;
                }
                let _e283 = phi_880_;
                let _e285 = phi_881_;
                let _e287 = phi_882_;
                phi_883_ = _e283;
                phi_884_ = _e285;
                phi_885_ = _e287;
            } else {
                phi_883_ = bool();
                phi_884_ = true;
                phi_885_ = false;
            }
            let _e289 = phi_883_;
            let _e291 = phi_884_;
            let _e293 = phi_885_;
            if _e291 {
                phi_889_ = true;
            } else {
                phi_889_ = _e293;
            }
            let _e295 = phi_889_;
            if _e295 {
                phi_893_ = false;
            } else {
                phi_893_ = _e289;
            }
            let _e297 = phi_893_;
            if _e297 {
                let _e298 = (0u >= _e78);
                if _e298 {
                    phi_2384_ = bool();
                } else {
                    if (0u < _e78) {
                    } else {
                        return;
                    }
                    let _e304 = nodes.member[(0u + 0u)].frame[0u];
                    let _e308 = nodes.member[(0u + 0u)].frame[1u];
                    let _e312 = nodes.member[(0u + 0u)].frame[2u];
                    let _e316 = nodes.member[(0u + 0u)].frame[0u];
                    let _e320 = nodes.member[(0u + 0u)].frame[1u];
                    let _e324 = nodes.member[(0u + 0u)].frame[2u];
                    let _e328 = nodes.member[(0u + 0u)].frame[3u];
                    let _e362 = core_intrinsics_maximum_number_nsz_f32_(abs(_e233), abs(_e234));
                    let _e363 = core_intrinsics_maximum_number_nsz_f32_(_e362, abs(_e235));
                    let _e364 = (_e363 * 0.0000000000009094947f);
                    if (abs(_e233) < _e364) {
                        phi_963_ = _e364;
                    } else {
                        phi_963_ = abs(_e233);
                    }
                    let _e369 = phi_963_;
                    if (_e233 < 0f) {
                        phi_970_ = (-1f / _e369);
                    } else {
                        phi_970_ = (1f / _e369);
                    }
                    let _e374 = phi_970_;
                    if (abs(_e234) < _e364) {
                        phi_977_ = _e364;
                    } else {
                        phi_977_ = abs(_e234);
                    }
                    let _e379 = phi_977_;
                    if (_e234 < 0f) {
                        phi_984_ = (-1f / _e379);
                    } else {
                        phi_984_ = (1f / _e379);
                    }
                    let _e384 = phi_984_;
                    if (abs(_e235) < _e364) {
                        phi_991_ = _e364;
                    } else {
                        phi_991_ = abs(_e235);
                    }
                    let _e389 = phi_991_;
                    if (_e235 < 0f) {
                        phi_998_ = (-1f / _e389);
                    } else {
                        phi_998_ = (1f / _e389);
                    }
                    let _e394 = phi_998_;
                    let _e398 = abs((bitcast<f32>(_e304) - _e217));
                    let _e399 = abs((bitcast<f32>(_e308) - _e219));
                    let _e400 = abs((bitcast<f32>(_e312) - _e221));
                    let _e404 = abs(((bitcast<f32>(_e316) + (bitcast<f32>((((_e328 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e217));
                    let _e405 = abs(((bitcast<f32>(_e320) + (bitcast<f32>((((_e328 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e219));
                    let _e406 = abs(((bitcast<f32>(_e324) + (bitcast<f32>((((_e328 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e221));
                    if (_e398 > _e404) {
                        phi_1015_ = _e398;
                    } else {
                        phi_1015_ = _e404;
                    }
                    let _e409 = phi_1015_;
                    if (_e399 > _e405) {
                        phi_1020_ = _e399;
                    } else {
                        phi_1020_ = _e405;
                    }
                    let _e412 = phi_1020_;
                    if (_e400 > _e406) {
                        phi_1025_ = _e400;
                    } else {
                        phi_1025_ = _e406;
                    }
                    let _e415 = phi_1025_;
                    let _e416 = core_intrinsics_maximum_number_nsz_f32_(_e409, _e412);
                    let _e417 = core_intrinsics_maximum_number_nsz_f32_(_e416, _e415);
                    let _e421 = (_e417 * 0.0000019073486f);
                    let _e422 = (abs(_e374) * _e421);
                    let _e423 = (abs(_e384) * _e421);
                    let _e424 = (abs(_e394) * _e421);
                    let _e428 = (_e417 * 0.0000009536743f);
                    let _e429 = (abs(_e374) * _e428);
                    let _e430 = (abs(_e384) * _e428);
                    let _e431 = (abs(_e394) * _e428);
                    let _e432 = abs(_e233);
                    let _e433 = abs(_e234);
                    let _e434 = abs(_e235);
                    if (_e432 >= _e433) {
                        if (_e432 >= _e434) {
                            phi_1053_ = false;
                        } else {
                            phi_1053_ = true;
                        }
                        let _e438 = phi_1053_;
                        phi_1054_ = _e438;
                    } else {
                        phi_1054_ = true;
                    }
                    let _e440 = phi_1054_;
                    if _e440 {
                        if (_e433 >= _e434) {
                            phi_1062_ = 1u;
                        } else {
                            phi_1062_ = 2u;
                        }
                        let _e443 = phi_1062_;
                        phi_1063_ = _e443;
                    } else {
                        phi_1063_ = 0u;
                    }
                    let _e445 = phi_1063_;
                    if (_e445 == 0u) {
                        phi_1075_ = vec3<f32>(_e234, _e235, _e233);
                    } else {
                        if (_e445 == 1u) {
                            phi_1074_ = vec3<f32>(_e235, _e233, _e234);
                        } else {
                            phi_1074_ = vec3<f32>(_e233, _e234, _e235);
                        }
                        let _e451 = phi_1074_;
                        phi_1075_ = _e451;
                    }
                    let _e453 = phi_1075_;
                    let _e456 = (_e453.x / _e453.z);
                    let _e459 = (_e453.y / _e453.z);
                    let _e461 = (1f / _e453.z);
                    if (_e374 < 0f) {
                        phi_1088_ = 0u;
                    } else {
                        phi_1088_ = 1u;
                    }
                    let _e464 = phi_1088_;
                    if (_e384 < 0f) {
                        phi_1093_ = 0u;
                    } else {
                        phi_1093_ = 2u;
                    }
                    let _e467 = phi_1093_;
                    if (_e394 < 0f) {
                        phi_1098_ = 0u;
                    } else {
                        phi_1098_ = 4u;
                    }
                    let _e470 = phi_1098_;
                    let _e472 = ((_e464 | _e467) | _e470);
                    let _e473 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e473.first[0], _e473.first[1], _e473.first[2], _e473.first[3], _e473.first[4], _e473.first[5], _e473.first[6], _e473.first[7], _e473.first[8], _e473.first[9], _e473.first[10], _e473.first[11], _e473.first[12], _e473.first[13], _e473.first[14], _e473.first[15], _e473.first[16], _e473.first[17], _e473.first[18], _e473.first[19], _e473.first[20], _e473.first[21], _e473.first[22], _e473.first[23], _e473.first[24], _e473.first[25], _e473.first[26], _e473.first[27], _e473.first[28], _e473.first[29], _e473.first[30], _e473.first[31]), array<u32, 32>(_e473.mask[0], _e473.mask[1], _e473.mask[2], _e473.mask[3], _e473.mask[4], _e473.mask[5], _e473.mask[6], _e473.mask[7], _e473.mask[8], _e473.mask[9], _e473.mask[10], _e473.mask[11], _e473.mask[12], _e473.mask[13], _e473.mask[14], _e473.mask[15], _e473.mask[16], _e473.mask[17], _e473.mask[18], _e473.mask[19], _e473.mask[20], _e473.mask[21], _e473.mask[22], _e473.mask[23], _e473.mask[24], _e473.mask[25], _e473.mask[26], _e473.mask[27], _e473.mask[28], _e473.mask[29], _e473.mask[30], _e473.mask[31]), _e473.len, _e473.group, _e473.group_mask);
                    let _e547 = local_1.group_mask;
                    if ((_e547 & 4278190080u) == 0u) {
                        let _e551 = local_1.len;
                        if (_e551 == 0u) {
                            phi_1212_ = false;
                        } else {
                            let _e555 = local_1.len;
                            local_1.len = (_e555 - 1u);
                            let _e558 = local_1.len;
                            if (_e558 < 32u) {
                            } else {
                                return;
                            }
                            let _e563 = local_1.first[(0u + _e558)];
                            local_1.group = _e563;
                            let _e566 = local_1.len;
                            if (_e566 < 32u) {
                            } else {
                                return;
                            }
                            let _e571 = local_1.mask[(0u + _e566)];
                            local_1.group_mask = _e571;
                            phi_1212_ = true;
                        }
                        let _e574 = phi_1212_;
                        phi_1213_ = _e574;
                    } else {
                        phi_1213_ = true;
                    }
                    let _e576 = phi_1213_;
                    if _e576 {
                        let _e578 = local_1.group_mask;
                        let _e584 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e578)), 32u, (_e578 == 0u)));
                        let _e588 = local_1.group_mask;
                        let _e602 = local_1.group_mask;
                        local_1.group_mask = (_e602 & ~((1u << bitcast<u32>((_e584 & 31u)))));
                        let _e605 = local_1.group;
                        phi_1244_ = (_e605 + countOneBits(((_e588 & ~((4294967295u << bitcast<u32>((((_e584 - 24u) ^ 7u) & 31u))))) & 255u)));
                    } else {
                        phi_1244_ = 4294967295u;
                    }
                    let _e608 = phi_1244_;
                    phi_1246_ = _e608;
                    loop {
                        let _e610 = phi_1246_;
                        if (_e610 != 4294967295u) {
                            if (_e610 < _e78) {
                            } else {
                                return;
                            }
                            let _e617 = nodes.member[(0u + _e610)].frame[3u];
                            let _e642 = (bitcast<f32>((((_e617 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e374);
                            let _e643 = (bitcast<f32>((((_e617 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e384);
                            let _e644 = (bitcast<f32>((((_e617 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e394);
                            let _e647 = nodes.member[(0u + _e610)].frame[0u];
                            let _e651 = nodes.member[(0u + _e610)].frame[1u];
                            let _e655 = nodes.member[(0u + _e610)].frame[2u];
                            let _e660 = ((bitcast<f32>(_e647) - _e217) * _e374);
                            let _e661 = ((bitcast<f32>(_e651) - _e219) * _e384);
                            let _e662 = ((bitcast<f32>(_e655) - _e221) * _e394);
                            let _e670 = nodes.member[(0u + _e610)].x;
                            if (_e374 < 0f) {
                                let _e681 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e670.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e687 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e681.unnamed.root, _e670.w), _e681.unnamed_1);
                                let _e693 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e687.unnamed, lt_bvh_traverse_Tree(_e670.x, _e687.unnamed_1.first_primitive));
                                phi_1327_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e693.unnamed, lt_bvh_traverse_Tree(_e693.unnamed_1.root, _e670.y));
                            } else {
                                let _e709 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e670.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e715 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e709.unnamed.root, _e670.y), _e709.unnamed_1);
                                let _e721 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e715.unnamed, lt_bvh_traverse_Tree(_e670.z, _e715.unnamed_1.first_primitive));
                                phi_1327_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e721.unnamed, lt_bvh_traverse_Tree(_e721.unnamed_1.root, _e670.w));
                            }
                            let _e729 = phi_1327_;
                            let _e739 = nodes.member[(0u + _e610)].y;
                            if (_e384 < 0f) {
                                let _e750 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e739.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e756 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e750.unnamed.root, _e739.w), _e750.unnamed_1);
                                let _e762 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e756.unnamed, lt_bvh_traverse_Tree(_e739.x, _e756.unnamed_1.first_primitive));
                                phi_1354_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e762.unnamed, lt_bvh_traverse_Tree(_e762.unnamed_1.root, _e739.y));
                            } else {
                                let _e778 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e739.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e784 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e778.unnamed.root, _e739.y), _e778.unnamed_1);
                                let _e790 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e784.unnamed, lt_bvh_traverse_Tree(_e739.z, _e784.unnamed_1.first_primitive));
                                phi_1354_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e790.unnamed, lt_bvh_traverse_Tree(_e790.unnamed_1.root, _e739.w));
                            }
                            let _e798 = phi_1354_;
                            let _e808 = nodes.member[(0u + _e610)].z;
                            if (_e394 < 0f) {
                                let _e819 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e808.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e825 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e819.unnamed.root, _e808.w), _e819.unnamed_1);
                                let _e831 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e825.unnamed, lt_bvh_traverse_Tree(_e808.x, _e825.unnamed_1.first_primitive));
                                phi_1381_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e831.unnamed, lt_bvh_traverse_Tree(_e831.unnamed_1.root, _e808.y));
                            } else {
                                let _e847 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e808.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e853 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e847.unnamed.root, _e808.y), _e847.unnamed_1);
                                let _e859 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e853.unnamed, lt_bvh_traverse_Tree(_e808.z, _e853.unnamed_1.first_primitive));
                                phi_1381_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e859.unnamed, lt_bvh_traverse_Tree(_e859.unnamed_1.root, _e808.w));
                            }
                            let _e867 = phi_1381_;
                            phi_1387_ = 0u;
                            phi_1390_ = 0u;
                            loop {
                                let _e877 = phi_1387_;
                                let _e879 = phi_1390_;
                                local_3 = _e879;
                                local_4 = _e879;
                                local_5 = _e879;
                                let _e880 = (_e877 < 8u);
                                if _e880 {
                                    let _e882 = (_e877 >> bitcast<u32>(2i));
                                    let _e883 = (_e877 & 3u);
                                    if (_e882 == 0u) {
                                        phi_1404_ = _e729.unnamed.root;
                                    } else {
                                        phi_1404_ = _e729.unnamed.first_primitive;
                                    }
                                    let _e886 = phi_1404_;
                                    if (_e882 == 0u) {
                                        phi_1414_ = _e798.unnamed.root;
                                    } else {
                                        phi_1414_ = _e798.unnamed.first_primitive;
                                    }
                                    let _e895 = phi_1414_;
                                    if (_e882 == 0u) {
                                        phi_1424_ = _e867.unnamed.root;
                                    } else {
                                        phi_1424_ = _e867.unnamed.first_primitive;
                                    }
                                    let _e904 = phi_1424_;
                                    let _e917 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e886 >> bitcast<u32>(((_e883 * 8u) & 31u))) & 255u)) * _e642) + (_e660 - _e422)), ((f32(((_e895 >> bitcast<u32>(((_e883 * 8u) & 31u))) & 255u)) * _e643) + (_e661 - _e423)));
                                    let _e918 = core_intrinsics_maximum_number_nsz_f32_(_e917, ((f32(((_e904 >> bitcast<u32>(((_e883 * 8u) & 31u))) & 255u)) * _e644) + (_e662 - _e424)));
                                    if (_e882 == 0u) {
                                        phi_1442_ = _e729.unnamed_1.root;
                                    } else {
                                        phi_1442_ = _e729.unnamed_1.first_primitive;
                                    }
                                    let _e921 = phi_1442_;
                                    if (_e882 == 0u) {
                                        phi_1452_ = _e798.unnamed_1.root;
                                    } else {
                                        phi_1452_ = _e798.unnamed_1.first_primitive;
                                    }
                                    let _e930 = phi_1452_;
                                    if (_e882 == 0u) {
                                        phi_1462_ = _e867.unnamed_1.root;
                                    } else {
                                        phi_1462_ = _e867.unnamed_1.first_primitive;
                                    }
                                    let _e939 = phi_1462_;
                                    let _e952 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e921 >> bitcast<u32>(((_e883 * 8u) & 31u))) & 255u)) * _e642) + (_e660 + _e422)), ((f32(((_e930 >> bitcast<u32>(((_e883 * 8u) & 31u))) & 255u)) * _e643) + (_e661 + _e423)));
                                    let _e953 = core_intrinsics_minimum_number_nsz_f32_(_e952, ((f32(((_e939 >> bitcast<u32>(((_e883 * 8u) & 31u))) & 255u)) * _e644) + (_e662 + _e424)));
                                    if (_e918 <= _e953) {
                                        if (_e918 <= _e225) {
                                            if (_e953 >= 0f) {
                                                if (_e882 == 0u) {
                                                    let _e960 = nodes.member[(0u + _e610)].links[2u];
                                                    phi_1498_ = _e960;
                                                } else {
                                                    let _e963 = nodes.member[(0u + _e610)].links[3u];
                                                    phi_1498_ = _e963;
                                                }
                                                let _e965 = phi_1498_;
                                                let _e970 = ((_e965 >> bitcast<u32>(((_e883 * 8u) & 31u))) & 255u);
                                                let _e971 = (_e970 & 31u);
                                                if (_e971 >= 24u) {
                                                    phi_1511_ = (24u + ((_e971 - 24u) ^ _e472));
                                                } else {
                                                    phi_1511_ = _e971;
                                                }
                                                let _e977 = phi_1511_;
                                                phi_1516_ = (_e879 | ((_e970 >> bitcast<u32>(5i)) << bitcast<u32>((_e977 & 31u))));
                                            } else {
                                                phi_1516_ = _e879;
                                            }
                                            let _e985 = phi_1516_;
                                            phi_1517_ = _e985;
                                        } else {
                                            phi_1517_ = _e879;
                                        }
                                        let _e987 = phi_1517_;
                                        phi_1518_ = _e987;
                                    } else {
                                        phi_1518_ = _e879;
                                    }
                                    let _e989 = phi_1518_;
                                    phi_1388_ = (_e877 + 1u);
                                    phi_1391_ = _e989;
                                } else {
                                    phi_1388_ = u32();
                                    phi_1391_ = u32();
                                }
                                let _e992 = phi_1388_;
                                let _e994 = phi_1391_;
                                continue;
                                continuing {
                                    phi_1387_ = _e992;
                                    phi_1390_ = _e994;
                                    break if !(_e880);
                                }
                            }
                            let _e998 = nodes.member[(0u + _e610)].links[0u];
                            let _e1002 = nodes.member[(0u + _e610)].frame[3u];
                            let _e1006 = local_3;
                            if ((_e1006 & 4278190080u) == 0u) {
                            } else {
                                let _e1010 = local_1.group_mask;
                                if ((_e1010 & 4278190080u) == 0u) {
                                } else {
                                    let _e1014 = local_1.len;
                                    if (_e1014 < 32u) {
                                        let _e1017 = local_1.group;
                                        let _e1019 = local_1.len;
                                        if (_e1019 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_1.first[(0u + _e1019)] = _e1017;
                                        let _e1025 = local_1.group_mask;
                                        let _e1027 = local_1.len;
                                        if (_e1027 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_1.mask[(0u + _e1027)] = _e1025;
                                        let _e1034 = local_1.len;
                                        local_1.len = (_e1034 + 1u);
                                    }
                                }
                                local_1.group = (0u + _e998);
                                let _e1038 = local_4;
                                local_1.group_mask = ((_e1038 & 4278190080u) | (_e1002 >> bitcast<u32>(24i)));
                            }
                            let _e1043 = local_5;
                            phi_1576_ = (_e1043 & 16777215u);
                            loop {
                                let _e1046 = phi_1576_;
                                let _e1047 = (_e1046 == 0u);
                                local_6 = _e1047;
                                local_10 = _e1047;
                                if _e1047 {
                                    phi_1577_ = u32();
                                    phi_2287_ = false;
                                    phi_2288_ = false;
                                    phi_2289_ = false;
                                } else {
                                    let _e1050 = nodes.member[(0u + _e610)].links[1u];
                                    let _e1055 = ((0u + _e1050) + select(firstTrailingBit(_e1046), 32u, (_e1046 == 0u)));
                                    if (_e1055 < _e81) {
                                    } else {
                                        return;
                                    }
                                    let _e1062 = triangles.member[(0u + _e1055)].v0_;
                                    let _e1064 = (_e1062.x - _e217);
                                    let _e1066 = (_e1062.y - _e219);
                                    let _e1068 = (_e1062.z - _e221);
                                    if (_e445 == 0u) {
                                        phi_1622_ = vec3<f32>(_e1066, _e1068, _e1064);
                                    } else {
                                        if (_e445 == 1u) {
                                            phi_1621_ = vec3<f32>(_e1068, _e1064, _e1066);
                                        } else {
                                            phi_1621_ = (_e1062 - vec3<f32>(_e217, _e219, _e221));
                                        }
                                        let _e1076 = phi_1621_;
                                        phi_1622_ = _e1076;
                                    }
                                    let _e1078 = phi_1622_;
                                    let _e1082 = (_e1078.x - (_e456 * _e1078.z));
                                    let _e1086 = (_e1078.y - (_e459 * _e1078.z));
                                    let _e1090 = triangles.member[(0u + _e1055)].v1_;
                                    let _e1092 = (_e1090.x - _e217);
                                    let _e1094 = (_e1090.y - _e219);
                                    let _e1096 = (_e1090.z - _e221);
                                    if (_e445 == 0u) {
                                        phi_1654_ = vec3<f32>(_e1094, _e1096, _e1092);
                                    } else {
                                        if (_e445 == 1u) {
                                            phi_1653_ = vec3<f32>(_e1096, _e1092, _e1094);
                                        } else {
                                            phi_1653_ = (_e1090 - vec3<f32>(_e217, _e219, _e221));
                                        }
                                        let _e1104 = phi_1653_;
                                        phi_1654_ = _e1104;
                                    }
                                    let _e1106 = phi_1654_;
                                    let _e1110 = (_e1106.x - (_e456 * _e1106.z));
                                    let _e1114 = (_e1106.y - (_e459 * _e1106.z));
                                    let _e1118 = triangles.member[(0u + _e1055)].v2_;
                                    let _e1120 = (_e1118.x - _e217);
                                    let _e1122 = (_e1118.y - _e219);
                                    let _e1124 = (_e1118.z - _e221);
                                    if (_e445 == 0u) {
                                        phi_1686_ = vec3<f32>(_e1122, _e1124, _e1120);
                                    } else {
                                        if (_e445 == 1u) {
                                            phi_1685_ = vec3<f32>(_e1124, _e1120, _e1122);
                                        } else {
                                            phi_1685_ = (_e1118 - vec3<f32>(_e217, _e219, _e221));
                                        }
                                        let _e1132 = phi_1685_;
                                        phi_1686_ = _e1132;
                                    }
                                    let _e1134 = phi_1686_;
                                    let _e1138 = (_e1134.x - (_e456 * _e1134.z));
                                    let _e1142 = (_e1134.y - (_e459 * _e1134.z));
                                    if (_e1110 < _e1138) {
                                        phi_1707_ = true;
                                    } else {
                                        if (_e1110 == _e1138) {
                                            phi_1706_ = (_e1114 < _e1142);
                                        } else {
                                            phi_1706_ = false;
                                        }
                                        let _e1149 = phi_1706_;
                                        phi_1707_ = _e1149;
                                    }
                                    let _e1151 = phi_1707_;
                                    if _e1151 {
                                        phi_1711_ = _e1142;
                                        phi_1712_ = _e1138;
                                        phi_1713_ = _e1114;
                                        phi_1714_ = _e1110;
                                    } else {
                                        phi_1711_ = _e1114;
                                        phi_1712_ = _e1110;
                                        phi_1713_ = _e1142;
                                        phi_1714_ = _e1138;
                                    }
                                    let _e1153 = phi_1711_;
                                    let _e1155 = phi_1712_;
                                    let _e1157 = phi_1713_;
                                    let _e1159 = phi_1714_;
                                    let _e1162 = ((_e1159 * _e1153) - (_e1157 * _e1155));
                                    if _e1151 {
                                        phi_1722_ = -(_e1162);
                                    } else {
                                        phi_1722_ = _e1162;
                                    }
                                    let _e1165 = phi_1722_;
                                    if (_e1138 < _e1082) {
                                        phi_1733_ = true;
                                    } else {
                                        if (_e1138 == _e1082) {
                                            phi_1732_ = (_e1142 < _e1086);
                                        } else {
                                            phi_1732_ = false;
                                        }
                                        let _e1170 = phi_1732_;
                                        phi_1733_ = _e1170;
                                    }
                                    let _e1172 = phi_1733_;
                                    if _e1172 {
                                        phi_1737_ = _e1086;
                                        phi_1738_ = _e1082;
                                        phi_1739_ = _e1142;
                                        phi_1740_ = _e1138;
                                    } else {
                                        phi_1737_ = _e1142;
                                        phi_1738_ = _e1138;
                                        phi_1739_ = _e1086;
                                        phi_1740_ = _e1082;
                                    }
                                    let _e1174 = phi_1737_;
                                    let _e1176 = phi_1738_;
                                    let _e1178 = phi_1739_;
                                    let _e1180 = phi_1740_;
                                    let _e1183 = ((_e1180 * _e1174) - (_e1178 * _e1176));
                                    if _e1172 {
                                        phi_1748_ = -(_e1183);
                                    } else {
                                        phi_1748_ = _e1183;
                                    }
                                    let _e1186 = phi_1748_;
                                    if (_e1082 < _e1110) {
                                        phi_1759_ = true;
                                    } else {
                                        if (_e1082 == _e1110) {
                                            phi_1758_ = (_e1086 < _e1114);
                                        } else {
                                            phi_1758_ = false;
                                        }
                                        let _e1191 = phi_1758_;
                                        phi_1759_ = _e1191;
                                    }
                                    let _e1193 = phi_1759_;
                                    if _e1193 {
                                        phi_1763_ = _e1114;
                                        phi_1764_ = _e1110;
                                        phi_1765_ = _e1086;
                                        phi_1766_ = _e1082;
                                    } else {
                                        phi_1763_ = _e1086;
                                        phi_1764_ = _e1082;
                                        phi_1765_ = _e1114;
                                        phi_1766_ = _e1110;
                                    }
                                    let _e1195 = phi_1763_;
                                    let _e1197 = phi_1764_;
                                    let _e1199 = phi_1765_;
                                    let _e1201 = phi_1766_;
                                    let _e1204 = ((_e1201 * _e1195) - (_e1199 * _e1197));
                                    if _e1193 {
                                        phi_1774_ = -(_e1204);
                                    } else {
                                        phi_1774_ = _e1204;
                                    }
                                    let _e1207 = phi_1774_;
                                    if (_e1165 >= 0f) {
                                        if (_e1186 >= 0f) {
                                            if (_e1207 >= 0f) {
                                                phi_1789_ = ((_e1165 + _e1186) + _e1207);
                                                phi_1790_ = false;
                                            } else {
                                                phi_1789_ = f32();
                                                phi_1790_ = true;
                                            }
                                            let _e1214 = phi_1789_;
                                            let _e1216 = phi_1790_;
                                            phi_1791_ = _e1214;
                                            phi_1792_ = _e1216;
                                        } else {
                                            phi_1791_ = f32();
                                            phi_1792_ = true;
                                        }
                                        let _e1218 = phi_1791_;
                                        let _e1220 = phi_1792_;
                                        phi_1793_ = _e1218;
                                        phi_1794_ = _e1220;
                                    } else {
                                        phi_1793_ = f32();
                                        phi_1794_ = true;
                                    }
                                    let _e1222 = phi_1793_;
                                    let _e1224 = phi_1794_;
                                    if _e1224 {
                                        if (_e1165 <= 0f) {
                                            if (_e1186 <= 0f) {
                                                let _e1227 = (_e1207 <= 0f);
                                                if _e1227 {
                                                }
                                                phi_1812_ = ((_e1165 + _e1186) + _e1207);
                                                phi_1813_ = false;
                                                phi_1814_ = _e1227;
                                            } else {
                                                phi_1812_ = f32();
                                                phi_1813_ = true;
                                                phi_1814_ = false;
                                            }
                                            let _e1231 = phi_1812_;
                                            let _e1233 = phi_1813_;
                                            let _e1235 = phi_1814_;
                                            phi_1815_ = _e1231;
                                            phi_1816_ = _e1233;
                                            phi_1817_ = _e1235;
                                        } else {
                                            phi_1815_ = f32();
                                            phi_1816_ = true;
                                            phi_1817_ = false;
                                        }
                                        let _e1237 = phi_1815_;
                                        let _e1239 = phi_1816_;
                                        let _e1241 = phi_1817_;
                                        if _e1239 {
                                            phi_1821_ = false;
                                        } else {
                                            phi_1821_ = _e1241;
                                        }
                                        let _e1243 = phi_1821_;
                                        phi_1822_ = _e1237;
                                        phi_1823_ = _e1243;
                                    } else {
                                        phi_1822_ = _e1222;
                                        phi_1823_ = true;
                                    }
                                    let _e1245 = phi_1822_;
                                    let _e1247 = phi_1823_;
                                    if _e1247 {
                                        let _e1248 = (_e1245 == 0f);
                                        if _e1248 {
                                            phi_2036_ = lt_bvh_triangle_Intersection();
                                            phi_2037_ = false;
                                        } else {
                                            let _e1254 = ((((_e1165 * (_e461 * _e1078.z)) + (_e1186 * (_e461 * _e1106.z))) + (_e1207 * (_e461 * _e1134.z))) / _e1245);
                                            if (_e1254 > 0f) {
                                                if (_e1254 < _e225) {
                                                    let _e1258 = triangles.member[(0u + _e1055)].v0_;
                                                    let _e1260 = triangles.member[(0u + _e1055)].v1_;
                                                    if (_e1258.x < _e1260.x) {
                                                        phi_1857_ = _e1258.x;
                                                    } else {
                                                        phi_1857_ = _e1260.x;
                                                    }
                                                    let _e1267 = phi_1857_;
                                                    if (_e1258.y < _e1260.y) {
                                                        phi_1866_ = _e1258.y;
                                                    } else {
                                                        phi_1866_ = _e1260.y;
                                                    }
                                                    let _e1274 = phi_1866_;
                                                    if (_e1258.z < _e1260.z) {
                                                        phi_1875_ = _e1258.z;
                                                    } else {
                                                        phi_1875_ = _e1260.z;
                                                    }
                                                    let _e1281 = phi_1875_;
                                                    let _e1283 = triangles.member[(0u + _e1055)].v2_;
                                                    if (_e1267 < _e1283.x) {
                                                        phi_1884_ = _e1267;
                                                    } else {
                                                        phi_1884_ = _e1283.x;
                                                    }
                                                    let _e1288 = phi_1884_;
                                                    if (_e1274 < _e1283.y) {
                                                        phi_1891_ = _e1274;
                                                    } else {
                                                        phi_1891_ = _e1283.y;
                                                    }
                                                    let _e1293 = phi_1891_;
                                                    if (_e1281 < _e1283.z) {
                                                        phi_1898_ = _e1281;
                                                    } else {
                                                        phi_1898_ = _e1283.z;
                                                    }
                                                    let _e1298 = phi_1898_;
                                                    let _e1300 = triangles.member[(0u + _e1055)].v0_;
                                                    let _e1302 = triangles.member[(0u + _e1055)].v1_;
                                                    if (_e1300.x > _e1302.x) {
                                                        phi_1911_ = _e1300.x;
                                                    } else {
                                                        phi_1911_ = _e1302.x;
                                                    }
                                                    let _e1309 = phi_1911_;
                                                    if (_e1300.y > _e1302.y) {
                                                        phi_1920_ = _e1300.y;
                                                    } else {
                                                        phi_1920_ = _e1302.y;
                                                    }
                                                    let _e1316 = phi_1920_;
                                                    if (_e1300.z > _e1302.z) {
                                                        phi_1929_ = _e1300.z;
                                                    } else {
                                                        phi_1929_ = _e1302.z;
                                                    }
                                                    let _e1323 = phi_1929_;
                                                    let _e1325 = triangles.member[(0u + _e1055)].v2_;
                                                    if (_e1309 > _e1325.x) {
                                                        phi_1938_ = _e1309;
                                                    } else {
                                                        phi_1938_ = _e1325.x;
                                                    }
                                                    let _e1330 = phi_1938_;
                                                    if (_e1316 > _e1325.y) {
                                                        phi_1945_ = _e1316;
                                                    } else {
                                                        phi_1945_ = _e1325.y;
                                                    }
                                                    let _e1335 = phi_1945_;
                                                    if (_e1323 > _e1325.z) {
                                                        phi_1952_ = _e1323;
                                                    } else {
                                                        phi_1952_ = _e1325.z;
                                                    }
                                                    let _e1340 = phi_1952_;
                                                    let _e1344 = ((_e1288 - _e217) * _e374);
                                                    let _e1345 = ((_e1293 - _e219) * _e384);
                                                    let _e1346 = ((_e1298 - _e221) * _e394);
                                                    let _e1350 = ((_e1330 - _e217) * _e374);
                                                    let _e1351 = ((_e1335 - _e219) * _e384);
                                                    let _e1352 = ((_e1340 - _e221) * _e394);
                                                    if (_e1344 < _e1350) {
                                                        phi_1969_ = _e1344;
                                                    } else {
                                                        phi_1969_ = _e1350;
                                                    }
                                                    let _e1355 = phi_1969_;
                                                    if (_e1345 < _e1351) {
                                                        phi_1974_ = _e1345;
                                                    } else {
                                                        phi_1974_ = _e1351;
                                                    }
                                                    let _e1358 = phi_1974_;
                                                    if (_e1346 < _e1352) {
                                                        phi_1979_ = _e1346;
                                                    } else {
                                                        phi_1979_ = _e1352;
                                                    }
                                                    let _e1361 = phi_1979_;
                                                    if (_e1344 > _e1350) {
                                                        phi_1987_ = _e1344;
                                                    } else {
                                                        phi_1987_ = _e1350;
                                                    }
                                                    let _e1367 = phi_1987_;
                                                    if (_e1345 > _e1351) {
                                                        phi_1992_ = _e1345;
                                                    } else {
                                                        phi_1992_ = _e1351;
                                                    }
                                                    let _e1370 = phi_1992_;
                                                    if (_e1346 > _e1352) {
                                                        phi_1997_ = _e1346;
                                                    } else {
                                                        phi_1997_ = _e1352;
                                                    }
                                                    let _e1373 = phi_1997_;
                                                    let _e1377 = core_intrinsics_maximum_number_nsz_f32_((_e1355 - _e429), (_e1358 - _e430));
                                                    let _e1378 = core_intrinsics_maximum_number_nsz_f32_(_e1377, (_e1361 - _e431));
                                                    let _e1379 = core_intrinsics_minimum_number_nsz_f32_((_e1367 + _e429), (_e1370 + _e430));
                                                    let _e1380 = core_intrinsics_minimum_number_nsz_f32_(_e1379, (_e1373 + _e431));
                                                    if (_e1378 > -300000000000000000000000000000000000000f) {
                                                        phi_2009_ = _e1378;
                                                    } else {
                                                        phi_2009_ = -300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1383 = phi_2009_;
                                                    if (_e1380 < 300000000000000000000000000000000000000f) {
                                                        phi_2014_ = _e1380;
                                                    } else {
                                                        phi_2014_ = 300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1386 = phi_2014_;
                                                    if (_e1254 < _e1383) {
                                                        phi_2019_ = _e1383;
                                                    } else {
                                                        phi_2019_ = _e1254;
                                                    }
                                                    let _e1389 = phi_2019_;
                                                    if (_e1389 > _e1386) {
                                                        phi_2024_ = _e1386;
                                                    } else {
                                                        phi_2024_ = _e1389;
                                                    }
                                                    let _e1392 = phi_2024_;
                                                    phi_2029_ = lt_bvh_triangle_Intersection(_e1392, (_e1186 / _e1245), (_e1207 / _e1245), (_e1383 <= _e1386));
                                                    phi_2030_ = false;
                                                } else {
                                                    phi_2029_ = lt_bvh_triangle_Intersection();
                                                    phi_2030_ = true;
                                                }
                                                let _e1398 = phi_2029_;
                                                let _e1400 = phi_2030_;
                                                phi_2031_ = _e1398;
                                                phi_2032_ = _e1400;
                                            } else {
                                                phi_2031_ = lt_bvh_triangle_Intersection();
                                                phi_2032_ = true;
                                            }
                                            let _e1402 = phi_2031_;
                                            let _e1404 = phi_2032_;
                                            if _e1404 {
                                            }
                                            phi_2036_ = _e1402;
                                            phi_2037_ = _e1404;
                                        }
                                        let _e1406 = phi_2036_;
                                        let _e1408 = phi_2037_;
                                        phi_2038_ = _e1406;
                                        phi_2039_ = _e1248;
                                        phi_2040_ = _e1408;
                                    } else {
                                        phi_2038_ = lt_bvh_triangle_Intersection();
                                        phi_2039_ = true;
                                        phi_2040_ = false;
                                    }
                                    let _e1410 = phi_2038_;
                                    let _e1412 = phi_2039_;
                                    let _e1414 = phi_2040_;
                                    if _e1412 {
                                        phi_2044_ = true;
                                    } else {
                                        phi_2044_ = _e1414;
                                    }
                                    let _e1416 = phi_2044_;
                                    if _e1416 {
                                        phi_2048_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                    } else {
                                        phi_2048_ = _e1410;
                                    }
                                    let _e1418 = phi_2048_;
                                    if _e1418.is_hit {
                                        if (_e1418.t > 0f) {
                                            if (_e1418.t < _e225) {
                                                let _e1425 = triangles.member[(0u + _e1055)].i0_;
                                                let _e1427 = ((_e1425 & 2147483648u) == 0u);
                                                if _e1427 {
                                                    phi_2271_ = false;
                                                    phi_2272_ = false;
                                                } else {
                                                    if (_e1055 < _e81) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1434 = triangles.member[(0u + _e1055)].i0_;
                                                    let _e1435 = (_e1434 & 2147483647u);
                                                    let _e1437 = triangles.member[(0u + _e1055)].i1_;
                                                    let _e1439 = triangles.member[(0u + _e1055)].i2_;
                                                    if (_e1435 < _e87) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1443 = vertices.member[(0u + _e1435)];
                                                    if (_e1437 < _e87) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1447 = vertices.member[(0u + _e1437)];
                                                    if (_e1439 < _e87) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1451 = vertices.member[(0u + _e1439)];
                                                    let _e1452 = array<abi_Vertex, 3>(_e1443, _e1447, _e1451);
                                                    if (_e1452[0].material < arrayLength((&materials.member))) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1458 = materials.member[(0u + _e1452[0].material)];
                                                    if ((_e1458.flags & 1u) == 1u) {
                                                        let _e1463 = ((1f - _e1418.u) - _e1418.v);
                                                        if (_e1458.cutoff <= 0f) {
                                                            phi_2265_ = true;
                                                        } else {
                                                            let _e1490 = (_e1458.base_color.w * ((((f32((_e1452[0].color >> bitcast<u32>(24i))) * _e1463) + (f32((_e1452[1].color >> bitcast<u32>(24i))) * _e1418.u)) + (f32((_e1452[2].color >> bitcast<u32>(24i))) * _e1418.v)) * (1f / 255f)));
                                                            if (_e1458.alpha_size == 0u) {
                                                                phi_2262_ = _e1490;
                                                            } else {
                                                                local.offset = _e1458.alpha_offset;
                                                                local.size = _e1458.alpha_size;
                                                                local.flags = _e1458.flags;
                                                                let _e1521 = _lt_shaders_texture_TextureView_quad((&local), (((_e1452[0].u * _e1463) + (_e1452[1].u * _e1418.u)) + (_e1452[2].u * _e1418.v)), (((_e1452[0].v * _e1463) + (_e1452[1].v * _e1418.u)) + (_e1452[2].v * _e1418.v)));
                                                                let _e1525 = (_e1521.indices[0] >> bitcast<u32>(2i));
                                                                if (_e1525 < _e93) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1529 = alpha_texels.member[(0u + _e1525)];
                                                                let _e1545 = (_e1521.indices[1] >> bitcast<u32>(2i));
                                                                if (_e1545 < _e93) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1549 = alpha_texels.member[(0u + _e1545)];
                                                                let _e1566 = (_e1521.indices[2] >> bitcast<u32>(2i));
                                                                if (_e1566 < _e93) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1570 = alpha_texels.member[(0u + _e1566)];
                                                                let _e1587 = (_e1521.indices[3] >> bitcast<u32>(2i));
                                                                if (_e1587 < _e93) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1591 = alpha_texels.member[(0u + _e1587)];
                                                                phi_2262_ = (_e1490 * (((((f32(((_e1529 >> bitcast<u32>((((_e1521.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1521.weights.x) + ((f32(((_e1549 >> bitcast<u32>((((_e1521.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1521.weights.y)) + ((f32(((_e1570 >> bitcast<u32>((((_e1521.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1521.weights.z)) + ((f32(((_e1591 >> bitcast<u32>((((_e1521.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1521.weights.w)));
                                                            }
                                                            let _e1607 = phi_2262_;
                                                            phi_2265_ = (_e1607 >= _e1458.cutoff);
                                                        }
                                                        let _e1611 = phi_2265_;
                                                        phi_2266_ = _e1611;
                                                    } else {
                                                        phi_2266_ = false;
                                                    }
                                                    let _e1613 = phi_2266_;
                                                    if _e1613 {
                                                        phi_2270_ = false;
                                                    } else {
                                                        phi_2270_ = true;
                                                    }
                                                    let _e1615 = phi_2270_;
                                                    phi_2271_ = _e1615;
                                                    phi_2272_ = _e1613;
                                                }
                                                let _e1617 = phi_2271_;
                                                let _e1619 = phi_2272_;
                                                phi_2273_ = _e1617;
                                                phi_2274_ = _e1427;
                                                phi_2275_ = _e1619;
                                            } else {
                                                phi_2273_ = true;
                                                phi_2274_ = false;
                                                phi_2275_ = false;
                                            }
                                            let _e1621 = phi_2273_;
                                            let _e1623 = phi_2274_;
                                            let _e1625 = phi_2275_;
                                            phi_2276_ = _e1621;
                                            phi_2277_ = _e1623;
                                            phi_2278_ = _e1625;
                                        } else {
                                            phi_2276_ = true;
                                            phi_2277_ = false;
                                            phi_2278_ = false;
                                        }
                                        let _e1627 = phi_2276_;
                                        let _e1629 = phi_2277_;
                                        let _e1631 = phi_2278_;
                                        phi_2279_ = _e1627;
                                        phi_2280_ = _e1629;
                                        phi_2281_ = _e1631;
                                    } else {
                                        phi_2279_ = true;
                                        phi_2280_ = false;
                                        phi_2281_ = false;
                                    }
                                    let _e1633 = phi_2279_;
                                    let _e1635 = phi_2280_;
                                    let _e1637 = phi_2281_;
                                    if _e1633 {
                                        phi_2285_ = false;
                                        phi_2286_ = false;
                                    } else {
                                        phi_2285_ = _e1635;
                                        phi_2286_ = _e1637;
                                    }
                                    let _e1639 = phi_2285_;
                                    let _e1641 = phi_2286_;
                                    phi_1577_ = (_e1046 & (_e1046 - 1u));
                                    phi_2287_ = _e1633;
                                    phi_2288_ = _e1639;
                                    phi_2289_ = _e1641;
                                }
                                let _e1643 = phi_1577_;
                                let _e1645 = phi_2287_;
                                let _e1647 = phi_2288_;
                                let _e1649 = phi_2289_;
                                local_8 = _e1647;
                                local_9 = _e1649;
                                continue;
                                continuing {
                                    phi_1576_ = _e1643;
                                    break if !(_e1645);
                                }
                            }
                            let _e1652 = local_6;
                            if _e1652 {
                                let _e1654 = local_1.group_mask;
                                if ((_e1654 & 4278190080u) == 0u) {
                                    let _e1658 = local_1.len;
                                    if (_e1658 == 0u) {
                                        phi_2331_ = false;
                                    } else {
                                        let _e1662 = local_1.len;
                                        local_1.len = (_e1662 - 1u);
                                        let _e1665 = local_1.len;
                                        if (_e1665 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1670 = local_1.first[(0u + _e1665)];
                                        local_1.group = _e1670;
                                        let _e1673 = local_1.len;
                                        if (_e1673 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1678 = local_1.mask[(0u + _e1673)];
                                        local_1.group_mask = _e1678;
                                        phi_2331_ = true;
                                    }
                                    let _e1681 = phi_2331_;
                                    phi_2332_ = _e1681;
                                } else {
                                    phi_2332_ = true;
                                }
                                let _e1683 = phi_2332_;
                                if _e1683 {
                                    let _e1685 = local_1.group_mask;
                                    let _e1691 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1685)), 32u, (_e1685 == 0u)));
                                    let _e1695 = local_1.group_mask;
                                    let _e1709 = local_1.group_mask;
                                    local_1.group_mask = (_e1709 & ~((1u << bitcast<u32>((_e1691 & 31u)))));
                                    let _e1712 = local_1.group;
                                    phi_2363_ = (_e1712 + countOneBits(((_e1695 & ~((4294967295u << bitcast<u32>((((_e1691 - 24u) ^ _e472) & 31u))))) & 255u)));
                                } else {
                                    phi_2363_ = 4294967295u;
                                }
                                let _e1715 = phi_2363_;
                                phi_2364_ = _e1715;
                                phi_2365_ = false;
                                phi_2366_ = false;
                            } else {
                                phi_2364_ = u32();
                                let _e1931 = local_8;
                                phi_2365_ = _e1931;
                                let _e1934 = local_9;
                                phi_2366_ = _e1934;
                            }
                            let _e1717 = phi_2364_;
                            let _e1719 = phi_2365_;
                            let _e1721 = phi_2366_;
                            phi_1247_ = _e1717;
                            let _e1938 = local_10;
                            phi_2367_ = _e1938;
                            phi_2368_ = false;
                            phi_2369_ = _e1719;
                            phi_2370_ = _e1721;
                        } else {
                            phi_1247_ = u32();
                            phi_2367_ = false;
                            phi_2368_ = true;
                            phi_2369_ = false;
                            phi_2370_ = false;
                        }
                        let _e1723 = phi_1247_;
                        let _e1725 = phi_2367_;
                        let _e1727 = phi_2368_;
                        let _e1729 = phi_2369_;
                        let _e1731 = phi_2370_;
                        local_7 = _e1727;
                        local_11 = _e1729;
                        local_12 = _e1731;
                        continue;
                        continuing {
                            phi_1246_ = _e1723;
                            break if !(_e1725);
                        }
                    }
                    let _e1734 = local_7;
                    if _e1734 {
                        phi_2374_ = false;
                        phi_2375_ = false;
                    } else {
                        let _e1945 = local_11;
                        phi_2374_ = _e1945;
                        let _e1948 = local_12;
                        phi_2375_ = _e1948;
                    }
                    let _e1736 = phi_2374_;
                    let _e1738 = phi_2375_;
                    if _e1736 {
                        phi_2379_ = true;
                    } else {
                        phi_2379_ = _e1738;
                    }
                    let _e1740 = phi_2379_;
                    if _e1740 {
                        phi_2383_ = true;
                    } else {
                        phi_2383_ = false;
                    }
                    let _e1742 = phi_2383_;
                    phi_2384_ = _e1742;
                }
                let _e1744 = phi_2384_;
                phi_2385_ = _e1744;
                phi_2386_ = _e298;
            } else {
                phi_2385_ = bool();
                phi_2386_ = true;
            }
            let _e1746 = phi_2385_;
            let _e1748 = phi_2386_;
            if _e1748 {
                phi_2390_ = false;
            } else {
                phi_2390_ = _e1746;
            }
            let _e1750 = phi_2390_;
            if _e1750 {
                phi_2394_ = 0f;
            } else {
                phi_2394_ = 1f;
            }
            let _e1752 = phi_2394_;
            phi_2395_ = _e1752;
        }
        let _e1754 = phi_2395_;
        if (_e99.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e99.first_primitive)] = _e1754;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
