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
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
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
    var phi_1651_: vec3<f32>;
    var phi_1652_: vec3<f32>;
    var phi_1681_: vec3<f32>;
    var phi_1682_: vec3<f32>;
    var phi_1700_: bool;
    var phi_1701_: bool;
    var phi_1705_: f32;
    var phi_1706_: f32;
    var phi_1707_: f32;
    var phi_1708_: f32;
    var phi_1716_: f32;
    var phi_1726_: bool;
    var phi_1727_: bool;
    var phi_1731_: f32;
    var phi_1732_: f32;
    var phi_1733_: f32;
    var phi_1734_: f32;
    var phi_1742_: f32;
    var phi_1752_: bool;
    var phi_1753_: bool;
    var phi_1757_: f32;
    var phi_1758_: f32;
    var phi_1759_: f32;
    var phi_1760_: f32;
    var phi_1768_: f32;
    var phi_1783_: f32;
    var phi_1784_: bool;
    var phi_1785_: f32;
    var phi_1786_: bool;
    var phi_1787_: f32;
    var phi_1788_: bool;
    var phi_1806_: f32;
    var phi_1807_: bool;
    var phi_1808_: bool;
    var phi_1809_: f32;
    var phi_1810_: bool;
    var phi_1811_: bool;
    var phi_1815_: bool;
    var phi_1816_: f32;
    var phi_1817_: bool;
    var phi_1845_: vec3<f32>;
    var phi_1846_: vec3<f32>;
    var phi_1871_: vec3<f32>;
    var phi_1872_: vec3<f32>;
    var phi_1897_: vec3<f32>;
    var phi_1898_: vec3<f32>;
    var phi_1954_: f32;
    var phi_1963_: f32;
    var phi_1972_: f32;
    var phi_1981_: f32;
    var phi_1988_: f32;
    var phi_1995_: f32;
    var phi_2008_: f32;
    var phi_2017_: f32;
    var phi_2026_: f32;
    var phi_2035_: f32;
    var phi_2042_: f32;
    var phi_2049_: f32;
    var phi_2066_: f32;
    var phi_2071_: f32;
    var phi_2076_: f32;
    var phi_2084_: f32;
    var phi_2089_: f32;
    var phi_2094_: f32;
    var phi_2106_: f32;
    var phi_2111_: f32;
    var phi_2116_: f32;
    var phi_2121_: f32;
    var phi_2126_: lt_bvh_triangle_Intersection;
    var phi_2127_: bool;
    var phi_2128_: lt_bvh_triangle_Intersection;
    var phi_2129_: bool;
    var phi_2133_: lt_bvh_triangle_Intersection;
    var phi_2134_: bool;
    var phi_2135_: lt_bvh_triangle_Intersection;
    var phi_2136_: bool;
    var phi_2137_: bool;
    var phi_2141_: bool;
    var phi_2145_: lt_bvh_triangle_Intersection;
    var phi_2359_: f32;
    var phi_2362_: bool;
    var phi_2363_: bool;
    var phi_2367_: bool;
    var phi_2368_: bool;
    var phi_2369_: bool;
    var phi_2370_: bool;
    var phi_2371_: bool;
    var phi_2372_: bool;
    var phi_2373_: bool;
    var phi_2374_: bool;
    var phi_2375_: bool;
    var phi_2376_: bool;
    var phi_2377_: bool;
    var phi_2378_: bool;
    var phi_2382_: bool;
    var phi_2383_: bool;
    var phi_1577_: u32;
    var phi_2384_: bool;
    var phi_2385_: bool;
    var phi_2386_: bool;
    var local_6: bool;
    var phi_2428_: bool;
    var phi_2429_: bool;
    var phi_2460_: u32;
    var phi_2461_: u32;
    var phi_2462_: bool;
    var phi_2463_: bool;
    var phi_1247_: u32;
    var phi_2464_: bool;
    var phi_2465_: bool;
    var phi_2466_: bool;
    var phi_2467_: bool;
    var local_7: bool;
    var phi_2471_: bool;
    var phi_2472_: bool;
    var phi_2476_: bool;
    var phi_2480_: bool;
    var phi_2481_: bool;
    var phi_2482_: bool;
    var phi_2483_: bool;
    var phi_2487_: bool;
    var phi_2491_: f32;
    var phi_2492_: f32;
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
            phi_2492_ = _e196.unnamed.visibility;
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
                    phi_2481_ = bool();
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
                                    phi_2384_ = false;
                                    phi_2385_ = false;
                                    phi_2386_ = false;
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
                                    let _e1088 = triangles.member[(0u + _e1055)].v1_;
                                    let _e1090 = (_e1088.x - _e217);
                                    let _e1092 = (_e1088.y - _e219);
                                    let _e1094 = (_e1088.z - _e221);
                                    if (_e445 == 0u) {
                                        phi_1652_ = vec3<f32>(_e1092, _e1094, _e1090);
                                    } else {
                                        if (_e445 == 1u) {
                                            phi_1651_ = vec3<f32>(_e1094, _e1090, _e1092);
                                        } else {
                                            phi_1651_ = (_e1088 - vec3<f32>(_e217, _e219, _e221));
                                        }
                                        let _e1102 = phi_1651_;
                                        phi_1652_ = _e1102;
                                    }
                                    let _e1104 = phi_1652_;
                                    let _e1108 = (_e1104.x - (_e456 * _e1104.z));
                                    let _e1112 = (_e1104.y - (_e459 * _e1104.z));
                                    let _e1114 = triangles.member[(0u + _e1055)].v2_;
                                    let _e1116 = (_e1114.x - _e217);
                                    let _e1118 = (_e1114.y - _e219);
                                    let _e1120 = (_e1114.z - _e221);
                                    if (_e445 == 0u) {
                                        phi_1682_ = vec3<f32>(_e1118, _e1120, _e1116);
                                    } else {
                                        if (_e445 == 1u) {
                                            phi_1681_ = vec3<f32>(_e1120, _e1116, _e1118);
                                        } else {
                                            phi_1681_ = (_e1114 - vec3<f32>(_e217, _e219, _e221));
                                        }
                                        let _e1128 = phi_1681_;
                                        phi_1682_ = _e1128;
                                    }
                                    let _e1130 = phi_1682_;
                                    let _e1134 = (_e1130.x - (_e456 * _e1130.z));
                                    let _e1138 = (_e1130.y - (_e459 * _e1130.z));
                                    if (_e1108 < _e1134) {
                                        phi_1701_ = true;
                                    } else {
                                        if (_e1108 == _e1134) {
                                            phi_1700_ = (_e1112 < _e1138);
                                        } else {
                                            phi_1700_ = false;
                                        }
                                        let _e1143 = phi_1700_;
                                        phi_1701_ = _e1143;
                                    }
                                    let _e1145 = phi_1701_;
                                    if _e1145 {
                                        phi_1705_ = _e1138;
                                        phi_1706_ = _e1134;
                                        phi_1707_ = _e1112;
                                        phi_1708_ = _e1108;
                                    } else {
                                        phi_1705_ = _e1112;
                                        phi_1706_ = _e1108;
                                        phi_1707_ = _e1138;
                                        phi_1708_ = _e1134;
                                    }
                                    let _e1147 = phi_1705_;
                                    let _e1149 = phi_1706_;
                                    let _e1151 = phi_1707_;
                                    let _e1153 = phi_1708_;
                                    let _e1156 = ((_e1153 * _e1147) - (_e1151 * _e1149));
                                    if _e1145 {
                                        phi_1716_ = -(_e1156);
                                    } else {
                                        phi_1716_ = _e1156;
                                    }
                                    let _e1159 = phi_1716_;
                                    if (_e1134 < _e1082) {
                                        phi_1727_ = true;
                                    } else {
                                        if (_e1134 == _e1082) {
                                            phi_1726_ = (_e1138 < _e1086);
                                        } else {
                                            phi_1726_ = false;
                                        }
                                        let _e1164 = phi_1726_;
                                        phi_1727_ = _e1164;
                                    }
                                    let _e1166 = phi_1727_;
                                    if _e1166 {
                                        phi_1731_ = _e1086;
                                        phi_1732_ = _e1082;
                                        phi_1733_ = _e1138;
                                        phi_1734_ = _e1134;
                                    } else {
                                        phi_1731_ = _e1138;
                                        phi_1732_ = _e1134;
                                        phi_1733_ = _e1086;
                                        phi_1734_ = _e1082;
                                    }
                                    let _e1168 = phi_1731_;
                                    let _e1170 = phi_1732_;
                                    let _e1172 = phi_1733_;
                                    let _e1174 = phi_1734_;
                                    let _e1177 = ((_e1174 * _e1168) - (_e1172 * _e1170));
                                    if _e1166 {
                                        phi_1742_ = -(_e1177);
                                    } else {
                                        phi_1742_ = _e1177;
                                    }
                                    let _e1180 = phi_1742_;
                                    if (_e1082 < _e1108) {
                                        phi_1753_ = true;
                                    } else {
                                        if (_e1082 == _e1108) {
                                            phi_1752_ = (_e1086 < _e1112);
                                        } else {
                                            phi_1752_ = false;
                                        }
                                        let _e1185 = phi_1752_;
                                        phi_1753_ = _e1185;
                                    }
                                    let _e1187 = phi_1753_;
                                    if _e1187 {
                                        phi_1757_ = _e1112;
                                        phi_1758_ = _e1108;
                                        phi_1759_ = _e1086;
                                        phi_1760_ = _e1082;
                                    } else {
                                        phi_1757_ = _e1086;
                                        phi_1758_ = _e1082;
                                        phi_1759_ = _e1112;
                                        phi_1760_ = _e1108;
                                    }
                                    let _e1189 = phi_1757_;
                                    let _e1191 = phi_1758_;
                                    let _e1193 = phi_1759_;
                                    let _e1195 = phi_1760_;
                                    let _e1198 = ((_e1195 * _e1189) - (_e1193 * _e1191));
                                    if _e1187 {
                                        phi_1768_ = -(_e1198);
                                    } else {
                                        phi_1768_ = _e1198;
                                    }
                                    let _e1201 = phi_1768_;
                                    if (_e1159 >= 0f) {
                                        if (_e1180 >= 0f) {
                                            if (_e1201 >= 0f) {
                                                phi_1783_ = ((_e1159 + _e1180) + _e1201);
                                                phi_1784_ = false;
                                            } else {
                                                phi_1783_ = f32();
                                                phi_1784_ = true;
                                            }
                                            let _e1208 = phi_1783_;
                                            let _e1210 = phi_1784_;
                                            phi_1785_ = _e1208;
                                            phi_1786_ = _e1210;
                                        } else {
                                            phi_1785_ = f32();
                                            phi_1786_ = true;
                                        }
                                        let _e1212 = phi_1785_;
                                        let _e1214 = phi_1786_;
                                        phi_1787_ = _e1212;
                                        phi_1788_ = _e1214;
                                    } else {
                                        phi_1787_ = f32();
                                        phi_1788_ = true;
                                    }
                                    let _e1216 = phi_1787_;
                                    let _e1218 = phi_1788_;
                                    if _e1218 {
                                        if (_e1159 <= 0f) {
                                            if (_e1180 <= 0f) {
                                                let _e1221 = (_e1201 <= 0f);
                                                if _e1221 {
                                                }
                                                phi_1806_ = ((_e1159 + _e1180) + _e1201);
                                                phi_1807_ = false;
                                                phi_1808_ = _e1221;
                                            } else {
                                                phi_1806_ = f32();
                                                phi_1807_ = true;
                                                phi_1808_ = false;
                                            }
                                            let _e1225 = phi_1806_;
                                            let _e1227 = phi_1807_;
                                            let _e1229 = phi_1808_;
                                            phi_1809_ = _e1225;
                                            phi_1810_ = _e1227;
                                            phi_1811_ = _e1229;
                                        } else {
                                            phi_1809_ = f32();
                                            phi_1810_ = true;
                                            phi_1811_ = false;
                                        }
                                        let _e1231 = phi_1809_;
                                        let _e1233 = phi_1810_;
                                        let _e1235 = phi_1811_;
                                        if _e1233 {
                                            phi_1815_ = false;
                                        } else {
                                            phi_1815_ = _e1235;
                                        }
                                        let _e1237 = phi_1815_;
                                        phi_1816_ = _e1231;
                                        phi_1817_ = _e1237;
                                    } else {
                                        phi_1816_ = _e1216;
                                        phi_1817_ = true;
                                    }
                                    let _e1239 = phi_1816_;
                                    let _e1241 = phi_1817_;
                                    if _e1241 {
                                        let _e1242 = (_e1239 == 0f);
                                        if _e1242 {
                                            phi_2133_ = lt_bvh_triangle_Intersection();
                                            phi_2134_ = false;
                                        } else {
                                            let _e1244 = triangles.member[(0u + _e1055)].v0_;
                                            let _e1246 = (_e1244.x - _e217);
                                            let _e1248 = (_e1244.y - _e219);
                                            let _e1250 = (_e1244.z - _e221);
                                            if (_e445 == 0u) {
                                                phi_1846_ = vec3<f32>(_e1248, _e1250, _e1246);
                                            } else {
                                                if (_e445 == 1u) {
                                                    phi_1845_ = vec3<f32>(_e1250, _e1246, _e1248);
                                                } else {
                                                    phi_1845_ = (_e1244 - vec3<f32>(_e217, _e219, _e221));
                                                }
                                                let _e1258 = phi_1845_;
                                                phi_1846_ = _e1258;
                                            }
                                            let _e1260 = phi_1846_;
                                            let _e1262 = triangles.member[(0u + _e1055)].v1_;
                                            let _e1264 = triangles.member[(0u + _e1055)].v0_;
                                            let _e1267 = (_e1262.x - _e1264.x);
                                            let _e1270 = (_e1262.y - _e1264.y);
                                            let _e1273 = (_e1262.z - _e1264.z);
                                            if (_e445 == 0u) {
                                                phi_1872_ = vec3<f32>(_e1270, _e1273, _e1267);
                                            } else {
                                                if (_e445 == 1u) {
                                                    phi_1871_ = vec3<f32>(_e1273, _e1267, _e1270);
                                                } else {
                                                    phi_1871_ = (_e1262 - _e1264);
                                                }
                                                let _e1280 = phi_1871_;
                                                phi_1872_ = _e1280;
                                            }
                                            let _e1282 = phi_1872_;
                                            let _e1284 = triangles.member[(0u + _e1055)].v2_;
                                            let _e1286 = triangles.member[(0u + _e1055)].v0_;
                                            let _e1289 = (_e1284.x - _e1286.x);
                                            let _e1292 = (_e1284.y - _e1286.y);
                                            let _e1295 = (_e1284.z - _e1286.z);
                                            if (_e445 == 0u) {
                                                phi_1898_ = vec3<f32>(_e1292, _e1295, _e1289);
                                            } else {
                                                if (_e445 == 1u) {
                                                    phi_1897_ = vec3<f32>(_e1295, _e1289, _e1292);
                                                } else {
                                                    phi_1897_ = (_e1284 - _e1286);
                                                }
                                                let _e1302 = phi_1897_;
                                                phi_1898_ = _e1302;
                                            }
                                            let _e1304 = phi_1898_;
                                            let _e1311 = ((_e1282.y * _e1304.z) - (_e1282.z * _e1304.y));
                                            let _e1318 = ((_e1282.z * _e1304.x) - (_e1282.x * _e1304.z));
                                            let _e1325 = ((_e1282.x * _e1304.y) - (_e1282.y * _e1304.x));
                                            let _e1339 = (((1f / _e453.z) * (((_e1311 * _e1260.x) + (_e1318 * _e1260.y)) + (_e1325 * _e1260.z))) / (((_e1311 * _e456) + (_e1318 * _e459)) + _e1325));
                                            if (_e1339 > 0f) {
                                                if (_e1339 < _e225) {
                                                    let _e1343 = triangles.member[(0u + _e1055)].v0_;
                                                    let _e1345 = triangles.member[(0u + _e1055)].v1_;
                                                    if (_e1343.x < _e1345.x) {
                                                        phi_1954_ = _e1343.x;
                                                    } else {
                                                        phi_1954_ = _e1345.x;
                                                    }
                                                    let _e1352 = phi_1954_;
                                                    if (_e1343.y < _e1345.y) {
                                                        phi_1963_ = _e1343.y;
                                                    } else {
                                                        phi_1963_ = _e1345.y;
                                                    }
                                                    let _e1359 = phi_1963_;
                                                    if (_e1343.z < _e1345.z) {
                                                        phi_1972_ = _e1343.z;
                                                    } else {
                                                        phi_1972_ = _e1345.z;
                                                    }
                                                    let _e1366 = phi_1972_;
                                                    let _e1368 = triangles.member[(0u + _e1055)].v2_;
                                                    if (_e1352 < _e1368.x) {
                                                        phi_1981_ = _e1352;
                                                    } else {
                                                        phi_1981_ = _e1368.x;
                                                    }
                                                    let _e1373 = phi_1981_;
                                                    if (_e1359 < _e1368.y) {
                                                        phi_1988_ = _e1359;
                                                    } else {
                                                        phi_1988_ = _e1368.y;
                                                    }
                                                    let _e1378 = phi_1988_;
                                                    if (_e1366 < _e1368.z) {
                                                        phi_1995_ = _e1366;
                                                    } else {
                                                        phi_1995_ = _e1368.z;
                                                    }
                                                    let _e1383 = phi_1995_;
                                                    let _e1385 = triangles.member[(0u + _e1055)].v0_;
                                                    let _e1387 = triangles.member[(0u + _e1055)].v1_;
                                                    if (_e1385.x > _e1387.x) {
                                                        phi_2008_ = _e1385.x;
                                                    } else {
                                                        phi_2008_ = _e1387.x;
                                                    }
                                                    let _e1394 = phi_2008_;
                                                    if (_e1385.y > _e1387.y) {
                                                        phi_2017_ = _e1385.y;
                                                    } else {
                                                        phi_2017_ = _e1387.y;
                                                    }
                                                    let _e1401 = phi_2017_;
                                                    if (_e1385.z > _e1387.z) {
                                                        phi_2026_ = _e1385.z;
                                                    } else {
                                                        phi_2026_ = _e1387.z;
                                                    }
                                                    let _e1408 = phi_2026_;
                                                    let _e1410 = triangles.member[(0u + _e1055)].v2_;
                                                    if (_e1394 > _e1410.x) {
                                                        phi_2035_ = _e1394;
                                                    } else {
                                                        phi_2035_ = _e1410.x;
                                                    }
                                                    let _e1415 = phi_2035_;
                                                    if (_e1401 > _e1410.y) {
                                                        phi_2042_ = _e1401;
                                                    } else {
                                                        phi_2042_ = _e1410.y;
                                                    }
                                                    let _e1420 = phi_2042_;
                                                    if (_e1408 > _e1410.z) {
                                                        phi_2049_ = _e1408;
                                                    } else {
                                                        phi_2049_ = _e1410.z;
                                                    }
                                                    let _e1425 = phi_2049_;
                                                    let _e1429 = ((_e1373 - _e217) * _e374);
                                                    let _e1430 = ((_e1378 - _e219) * _e384);
                                                    let _e1431 = ((_e1383 - _e221) * _e394);
                                                    let _e1435 = ((_e1415 - _e217) * _e374);
                                                    let _e1436 = ((_e1420 - _e219) * _e384);
                                                    let _e1437 = ((_e1425 - _e221) * _e394);
                                                    if (_e1429 < _e1435) {
                                                        phi_2066_ = _e1429;
                                                    } else {
                                                        phi_2066_ = _e1435;
                                                    }
                                                    let _e1440 = phi_2066_;
                                                    if (_e1430 < _e1436) {
                                                        phi_2071_ = _e1430;
                                                    } else {
                                                        phi_2071_ = _e1436;
                                                    }
                                                    let _e1443 = phi_2071_;
                                                    if (_e1431 < _e1437) {
                                                        phi_2076_ = _e1431;
                                                    } else {
                                                        phi_2076_ = _e1437;
                                                    }
                                                    let _e1446 = phi_2076_;
                                                    if (_e1429 > _e1435) {
                                                        phi_2084_ = _e1429;
                                                    } else {
                                                        phi_2084_ = _e1435;
                                                    }
                                                    let _e1452 = phi_2084_;
                                                    if (_e1430 > _e1436) {
                                                        phi_2089_ = _e1430;
                                                    } else {
                                                        phi_2089_ = _e1436;
                                                    }
                                                    let _e1455 = phi_2089_;
                                                    if (_e1431 > _e1437) {
                                                        phi_2094_ = _e1431;
                                                    } else {
                                                        phi_2094_ = _e1437;
                                                    }
                                                    let _e1458 = phi_2094_;
                                                    let _e1462 = core_intrinsics_maximum_number_nsz_f32_((_e1440 - _e429), (_e1443 - _e430));
                                                    let _e1463 = core_intrinsics_maximum_number_nsz_f32_(_e1462, (_e1446 - _e431));
                                                    let _e1464 = core_intrinsics_minimum_number_nsz_f32_((_e1452 + _e429), (_e1455 + _e430));
                                                    let _e1465 = core_intrinsics_minimum_number_nsz_f32_(_e1464, (_e1458 + _e431));
                                                    if (_e1463 > -300000000000000000000000000000000000000f) {
                                                        phi_2106_ = _e1463;
                                                    } else {
                                                        phi_2106_ = -300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1468 = phi_2106_;
                                                    if (_e1465 < 300000000000000000000000000000000000000f) {
                                                        phi_2111_ = _e1465;
                                                    } else {
                                                        phi_2111_ = 300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1471 = phi_2111_;
                                                    if (_e1339 < _e1468) {
                                                        phi_2116_ = _e1468;
                                                    } else {
                                                        phi_2116_ = _e1339;
                                                    }
                                                    let _e1474 = phi_2116_;
                                                    if (_e1474 > _e1471) {
                                                        phi_2121_ = _e1471;
                                                    } else {
                                                        phi_2121_ = _e1474;
                                                    }
                                                    let _e1477 = phi_2121_;
                                                    phi_2126_ = lt_bvh_triangle_Intersection(_e1477, (_e1180 / _e1239), (_e1201 / _e1239), (_e1468 <= _e1471));
                                                    phi_2127_ = false;
                                                } else {
                                                    phi_2126_ = lt_bvh_triangle_Intersection();
                                                    phi_2127_ = true;
                                                }
                                                let _e1483 = phi_2126_;
                                                let _e1485 = phi_2127_;
                                                phi_2128_ = _e1483;
                                                phi_2129_ = _e1485;
                                            } else {
                                                phi_2128_ = lt_bvh_triangle_Intersection();
                                                phi_2129_ = true;
                                            }
                                            let _e1487 = phi_2128_;
                                            let _e1489 = phi_2129_;
                                            if _e1489 {
                                            }
                                            phi_2133_ = _e1487;
                                            phi_2134_ = _e1489;
                                        }
                                        let _e1491 = phi_2133_;
                                        let _e1493 = phi_2134_;
                                        phi_2135_ = _e1491;
                                        phi_2136_ = _e1242;
                                        phi_2137_ = _e1493;
                                    } else {
                                        phi_2135_ = lt_bvh_triangle_Intersection();
                                        phi_2136_ = true;
                                        phi_2137_ = false;
                                    }
                                    let _e1495 = phi_2135_;
                                    let _e1497 = phi_2136_;
                                    let _e1499 = phi_2137_;
                                    if _e1497 {
                                        phi_2141_ = true;
                                    } else {
                                        phi_2141_ = _e1499;
                                    }
                                    let _e1501 = phi_2141_;
                                    if _e1501 {
                                        phi_2145_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                    } else {
                                        phi_2145_ = _e1495;
                                    }
                                    let _e1503 = phi_2145_;
                                    if _e1503.is_hit {
                                        if (_e1503.t > 0f) {
                                            if (_e1503.t < _e225) {
                                                let _e1510 = triangles.member[(0u + _e1055)].i0_;
                                                let _e1512 = ((_e1510 & 2147483648u) == 0u);
                                                if _e1512 {
                                                    phi_2368_ = false;
                                                    phi_2369_ = false;
                                                } else {
                                                    if (_e1055 < _e81) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1519 = triangles.member[(0u + _e1055)].i0_;
                                                    let _e1520 = (_e1519 & 2147483647u);
                                                    let _e1522 = triangles.member[(0u + _e1055)].i1_;
                                                    let _e1524 = triangles.member[(0u + _e1055)].i2_;
                                                    if (_e1520 < _e87) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1528 = vertices.member[(0u + _e1520)];
                                                    if (_e1522 < _e87) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1532 = vertices.member[(0u + _e1522)];
                                                    if (_e1524 < _e87) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1536 = vertices.member[(0u + _e1524)];
                                                    let _e1537 = array<abi_Vertex, 3>(_e1528, _e1532, _e1536);
                                                    if (_e1537[0].material < arrayLength((&materials.member))) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1543 = materials.member[(0u + _e1537[0].material)];
                                                    if ((_e1543.flags & 1u) == 1u) {
                                                        let _e1548 = ((1f - _e1503.u) - _e1503.v);
                                                        if (_e1543.cutoff <= 0f) {
                                                            phi_2362_ = true;
                                                        } else {
                                                            let _e1575 = (_e1543.base_color.w * ((((f32((_e1537[0].color >> bitcast<u32>(24i))) * _e1548) + (f32((_e1537[1].color >> bitcast<u32>(24i))) * _e1503.u)) + (f32((_e1537[2].color >> bitcast<u32>(24i))) * _e1503.v)) * (1f / 255f)));
                                                            if (_e1543.alpha_size == 0u) {
                                                                phi_2359_ = _e1575;
                                                            } else {
                                                                local.offset = _e1543.alpha_offset;
                                                                local.size = _e1543.alpha_size;
                                                                local.flags = _e1543.flags;
                                                                let _e1606 = _lt_shaders_texture_TextureView_quad((&local), (((_e1537[0].u * _e1548) + (_e1537[1].u * _e1503.u)) + (_e1537[2].u * _e1503.v)), (((_e1537[0].v * _e1548) + (_e1537[1].v * _e1503.u)) + (_e1537[2].v * _e1503.v)));
                                                                let _e1610 = (_e1606.indices[0] >> bitcast<u32>(2i));
                                                                if (_e1610 < _e93) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1614 = alpha_texels.member[(0u + _e1610)];
                                                                let _e1630 = (_e1606.indices[1] >> bitcast<u32>(2i));
                                                                if (_e1630 < _e93) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1634 = alpha_texels.member[(0u + _e1630)];
                                                                let _e1651 = (_e1606.indices[2] >> bitcast<u32>(2i));
                                                                if (_e1651 < _e93) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1655 = alpha_texels.member[(0u + _e1651)];
                                                                let _e1672 = (_e1606.indices[3] >> bitcast<u32>(2i));
                                                                if (_e1672 < _e93) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1676 = alpha_texels.member[(0u + _e1672)];
                                                                phi_2359_ = (_e1575 * (((((f32(((_e1614 >> bitcast<u32>((((_e1606.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1606.weights.x) + ((f32(((_e1634 >> bitcast<u32>((((_e1606.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1606.weights.y)) + ((f32(((_e1655 >> bitcast<u32>((((_e1606.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1606.weights.z)) + ((f32(((_e1676 >> bitcast<u32>((((_e1606.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1606.weights.w)));
                                                            }
                                                            let _e1692 = phi_2359_;
                                                            phi_2362_ = (_e1692 >= _e1543.cutoff);
                                                        }
                                                        let _e1696 = phi_2362_;
                                                        phi_2363_ = _e1696;
                                                    } else {
                                                        phi_2363_ = false;
                                                    }
                                                    let _e1698 = phi_2363_;
                                                    if _e1698 {
                                                        phi_2367_ = false;
                                                    } else {
                                                        phi_2367_ = true;
                                                    }
                                                    let _e1700 = phi_2367_;
                                                    phi_2368_ = _e1700;
                                                    phi_2369_ = _e1698;
                                                }
                                                let _e1702 = phi_2368_;
                                                let _e1704 = phi_2369_;
                                                phi_2370_ = _e1702;
                                                phi_2371_ = _e1512;
                                                phi_2372_ = _e1704;
                                            } else {
                                                phi_2370_ = true;
                                                phi_2371_ = false;
                                                phi_2372_ = false;
                                            }
                                            let _e1706 = phi_2370_;
                                            let _e1708 = phi_2371_;
                                            let _e1710 = phi_2372_;
                                            phi_2373_ = _e1706;
                                            phi_2374_ = _e1708;
                                            phi_2375_ = _e1710;
                                        } else {
                                            phi_2373_ = true;
                                            phi_2374_ = false;
                                            phi_2375_ = false;
                                        }
                                        let _e1712 = phi_2373_;
                                        let _e1714 = phi_2374_;
                                        let _e1716 = phi_2375_;
                                        phi_2376_ = _e1712;
                                        phi_2377_ = _e1714;
                                        phi_2378_ = _e1716;
                                    } else {
                                        phi_2376_ = true;
                                        phi_2377_ = false;
                                        phi_2378_ = false;
                                    }
                                    let _e1718 = phi_2376_;
                                    let _e1720 = phi_2377_;
                                    let _e1722 = phi_2378_;
                                    if _e1718 {
                                        phi_2382_ = false;
                                        phi_2383_ = false;
                                    } else {
                                        phi_2382_ = _e1720;
                                        phi_2383_ = _e1722;
                                    }
                                    let _e1724 = phi_2382_;
                                    let _e1726 = phi_2383_;
                                    phi_1577_ = (_e1046 & (_e1046 - 1u));
                                    phi_2384_ = _e1718;
                                    phi_2385_ = _e1724;
                                    phi_2386_ = _e1726;
                                }
                                let _e1728 = phi_1577_;
                                let _e1730 = phi_2384_;
                                let _e1732 = phi_2385_;
                                let _e1734 = phi_2386_;
                                local_8 = _e1732;
                                local_9 = _e1734;
                                continue;
                                continuing {
                                    phi_1576_ = _e1728;
                                    break if !(_e1730);
                                }
                            }
                            let _e1737 = local_6;
                            if _e1737 {
                                let _e1739 = local_1.group_mask;
                                if ((_e1739 & 4278190080u) == 0u) {
                                    let _e1743 = local_1.len;
                                    if (_e1743 == 0u) {
                                        phi_2428_ = false;
                                    } else {
                                        let _e1747 = local_1.len;
                                        local_1.len = (_e1747 - 1u);
                                        let _e1750 = local_1.len;
                                        if (_e1750 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1755 = local_1.first[(0u + _e1750)];
                                        local_1.group = _e1755;
                                        let _e1758 = local_1.len;
                                        if (_e1758 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1763 = local_1.mask[(0u + _e1758)];
                                        local_1.group_mask = _e1763;
                                        phi_2428_ = true;
                                    }
                                    let _e1766 = phi_2428_;
                                    phi_2429_ = _e1766;
                                } else {
                                    phi_2429_ = true;
                                }
                                let _e1768 = phi_2429_;
                                if _e1768 {
                                    let _e1770 = local_1.group_mask;
                                    let _e1776 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1770)), 32u, (_e1770 == 0u)));
                                    let _e1780 = local_1.group_mask;
                                    let _e1794 = local_1.group_mask;
                                    local_1.group_mask = (_e1794 & ~((1u << bitcast<u32>((_e1776 & 31u)))));
                                    let _e1797 = local_1.group;
                                    phi_2460_ = (_e1797 + countOneBits(((_e1780 & ~((4294967295u << bitcast<u32>((((_e1776 - 24u) ^ _e472) & 31u))))) & 255u)));
                                } else {
                                    phi_2460_ = 4294967295u;
                                }
                                let _e1800 = phi_2460_;
                                phi_2461_ = _e1800;
                                phi_2462_ = false;
                                phi_2463_ = false;
                            } else {
                                phi_2461_ = u32();
                                let _e2022 = local_8;
                                phi_2462_ = _e2022;
                                let _e2025 = local_9;
                                phi_2463_ = _e2025;
                            }
                            let _e1802 = phi_2461_;
                            let _e1804 = phi_2462_;
                            let _e1806 = phi_2463_;
                            phi_1247_ = _e1802;
                            let _e2029 = local_10;
                            phi_2464_ = _e2029;
                            phi_2465_ = false;
                            phi_2466_ = _e1804;
                            phi_2467_ = _e1806;
                        } else {
                            phi_1247_ = u32();
                            phi_2464_ = false;
                            phi_2465_ = true;
                            phi_2466_ = false;
                            phi_2467_ = false;
                        }
                        let _e1808 = phi_1247_;
                        let _e1810 = phi_2464_;
                        let _e1812 = phi_2465_;
                        let _e1814 = phi_2466_;
                        let _e1816 = phi_2467_;
                        local_7 = _e1812;
                        local_11 = _e1814;
                        local_12 = _e1816;
                        continue;
                        continuing {
                            phi_1246_ = _e1808;
                            break if !(_e1810);
                        }
                    }
                    let _e1819 = local_7;
                    if _e1819 {
                        phi_2471_ = false;
                        phi_2472_ = false;
                    } else {
                        let _e2036 = local_11;
                        phi_2471_ = _e2036;
                        let _e2039 = local_12;
                        phi_2472_ = _e2039;
                    }
                    let _e1821 = phi_2471_;
                    let _e1823 = phi_2472_;
                    if _e1821 {
                        phi_2476_ = true;
                    } else {
                        phi_2476_ = _e1823;
                    }
                    let _e1825 = phi_2476_;
                    if _e1825 {
                        phi_2480_ = true;
                    } else {
                        phi_2480_ = false;
                    }
                    let _e1827 = phi_2480_;
                    phi_2481_ = _e1827;
                }
                let _e1829 = phi_2481_;
                phi_2482_ = _e1829;
                phi_2483_ = _e298;
            } else {
                phi_2482_ = bool();
                phi_2483_ = true;
            }
            let _e1831 = phi_2482_;
            let _e1833 = phi_2483_;
            if _e1833 {
                phi_2487_ = false;
            } else {
                phi_2487_ = _e1831;
            }
            let _e1835 = phi_2487_;
            if _e1835 {
                phi_2491_ = 0f;
            } else {
                phi_2491_ = 1f;
            }
            let _e1837 = phi_2491_;
            phi_2492_ = _e1837;
        }
        let _e1839 = phi_2492_;
        if (_e99.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e99.first_primitive)] = _e1839;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
