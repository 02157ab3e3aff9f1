struct abi_CameraParams {
    eye: vec3<f32>,
    root: u32,
    right: vec3<f32>,
    layers_behind: u32,
    up: vec3<f32>,
    pad1_: u32,
    forward: vec3<f32>,
    pad2_: u32,
    size: vec2<u32>,
    grid: vec2<u32>,
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

struct type_20 {
    member: array<abi_Sample>,
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

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_32 {
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

struct type_36 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_40 {
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

struct type_44 {
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

struct type_55 {
    member: array<lt_bvh_Instance>,
}

struct type_59 {
    member: abi_CameraParams,
}

struct lt_bvh_Ray {
    origin: vec3<f32>,
    tmin: f32,
    direction: vec3<f32>,
    tmax: f32,
}

struct lt_bvh_Hit {
    t: f32,
    u: f32,
    v: f32,
    triangle: u32,
    instance: u32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(3) 
var<storage> vertices: type_40;
@group(0) @binding(4) 
var<storage> materials: type_44;
@group(0) @binding(0) 
var<uniform> p: type_59;
@group(0) @binding(1) 
var<storage> nodes: type_32;
@group(0) @binding(2) 
var<storage> triangles: type_36;
@group(0) @binding(5) 
var<storage, read_write> samples: type_20;
@group(0) @binding(6) 
var<storage> instances: type_55;
@group(0) @binding(7) 
var<storage> color_texels: type_9;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_220_: lt_bvh_traverse_Tree;
    var phi_221_: bool;
    var phi_222_: lt_bvh_traverse_Tree;
    var phi_223_: bool;
    var phi_228_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_220_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_221_ = false;
        } else {
            phi_220_ = lt_bvh_traverse_Tree();
            phi_221_ = true;
        }
        let _e83 = phi_220_;
        let _e85 = phi_221_;
        phi_222_ = _e83;
        phi_223_ = _e85;
    } else {
        phi_222_ = lt_bvh_traverse_Tree();
        phi_223_ = true;
    }
    let _e87 = phi_222_;
    let _e89 = phi_223_;
    if _e89 {
        phi_228_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_228_ = _e87;
    }
    let _e94 = phi_228_;
    return lt_bvh_traverse_Tree(_e94.root, _e94.first_primitive);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_243_: bool;
    var phi_247_: f32;

    if (param_3 != param_3) {
        phi_243_ = true;
    } else {
        let _e73 = (param_4 >= param_3);
        if _e73 {
        }
        phi_243_ = _e73;
    }
    let _e75 = phi_243_;
    if _e75 {
        phi_247_ = param_4;
    } else {
        phi_247_ = param_3;
    }
    let _e77 = phi_247_;
    return _e77;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_259_: bool;
    var phi_263_: f32;

    if (param_5 != param_5) {
        phi_259_ = true;
    } else {
        let _e73 = (param_6 <= param_5);
        if _e73 {
        }
        phi_259_ = _e73;
    }
    let _e75 = phi_259_;
    if _e75 {
        phi_263_ = param_6;
    } else {
        phi_263_ = param_5;
    }
    let _e77 = phi_263_;
    return _e77;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_305_: f32;
    var phi_310_: f32;
    var phi_311_: bool;
    var phi_312_: f32;
    var phi_313_: bool;
    var phi_317_: f32;
    var phi_343_: f32;
    var phi_348_: f32;
    var phi_349_: bool;
    var phi_350_: f32;
    var phi_351_: bool;
    var phi_355_: f32;
    var phi_363_: f32;
    var phi_364_: f32;
    var phi_365_: f32;
    var phi_374_: f32;
    var phi_375_: f32;
    var phi_393_: u32;
    var phi_407_: u32;
    var phi_414_: u32;
    var phi_419_: u32;
    var phi_425_: u32;
    var phi_430_: u32;
    var phi_432_: texture_Axis;
    var phi_460_: f32;
    var phi_465_: f32;
    var phi_466_: bool;
    var phi_467_: f32;
    var phi_468_: bool;
    var phi_472_: f32;
    var phi_498_: f32;
    var phi_503_: f32;
    var phi_504_: bool;
    var phi_505_: f32;
    var phi_506_: bool;
    var phi_510_: f32;
    var phi_518_: f32;
    var phi_519_: f32;
    var phi_520_: f32;
    var phi_529_: f32;
    var phi_530_: f32;
    var phi_548_: u32;
    var phi_562_: u32;
    var phi_569_: u32;
    var phi_574_: u32;
    var phi_580_: u32;
    var phi_585_: u32;
    var phi_587_: texture_Axis;

    let _e74 = (*param_7).size;
    let _e75 = (_e74 & 65535u);
    let _e77 = (*param_7).size;
    let _e79 = (_e77 >> bitcast<u32>(16i));
    let _e81 = (*param_7).flags;
    let _e83 = ((_e81 & 4u) != 0u);
    let _e85 = (*param_7).flags;
    let _e88 = ((_e85 >> bitcast<u32>(4u)) & 3u);
    if (_e88 == 0u) {
        if (param_8 > -8388608f) {
            let _e101 = f32(select(0i, select(select(i32(param_8), i32(-2147483648), (param_8 < bitcast<f32>(3472883712u))), 2147483647i, (param_8 > bitcast<f32>(1325400063u))), (param_8 == param_8)));
            if (_e101 > param_8) {
                phi_305_ = 1f;
            } else {
                phi_305_ = 0f;
            }
            let _e104 = phi_305_;
            if (param_8 < 8388608f) {
                phi_310_ = (_e101 - _e104);
                phi_311_ = false;
            } else {
                phi_310_ = f32();
                phi_311_ = true;
            }
            let _e107 = phi_310_;
            let _e109 = phi_311_;
            phi_312_ = _e107;
            phi_313_ = _e109;
        } else {
            phi_312_ = f32();
            phi_313_ = true;
        }
        let _e111 = phi_312_;
        let _e113 = phi_313_;
        if _e113 {
            phi_317_ = param_8;
        } else {
            phi_317_ = _e111;
        }
        let _e115 = phi_317_;
        phi_365_ = (param_8 - _e115);
    } else {
        if (_e88 == 1u) {
            let _e118 = (param_8 * 0.5f);
            if (_e118 > -8388608f) {
                let _e130 = f32(select(0i, select(select(i32(_e118), i32(-2147483648), (_e118 < bitcast<f32>(3472883712u))), 2147483647i, (_e118 > bitcast<f32>(1325400063u))), (_e118 == _e118)));
                if (_e130 > _e118) {
                    phi_343_ = 1f;
                } else {
                    phi_343_ = 0f;
                }
                let _e133 = phi_343_;
                if (_e118 < 8388608f) {
                    phi_348_ = (_e130 - _e133);
                    phi_349_ = false;
                } else {
                    phi_348_ = f32();
                    phi_349_ = true;
                }
                let _e136 = phi_348_;
                let _e138 = phi_349_;
                phi_350_ = _e136;
                phi_351_ = _e138;
            } else {
                phi_350_ = f32();
                phi_351_ = true;
            }
            let _e140 = phi_350_;
            let _e142 = phi_351_;
            if _e142 {
                phi_355_ = _e118;
            } else {
                phi_355_ = _e140;
            }
            let _e144 = phi_355_;
            let _e146 = (param_8 - (2f * _e144));
            if (_e146 > 1f) {
                phi_363_ = (2f - _e146);
            } else {
                phi_363_ = _e146;
            }
            let _e150 = phi_363_;
            phi_364_ = _e150;
        } else {
            phi_364_ = param_8;
        }
        let _e152 = phi_364_;
        phi_365_ = _e152;
    }
    let _e154 = phi_365_;
    if (_e154 > 0f) {
        if (_e154 < 1f) {
            phi_374_ = _e154;
        } else {
            phi_374_ = 1f;
        }
        let _e158 = phi_374_;
        phi_375_ = _e158;
    } else {
        phi_375_ = 0f;
    }
    let _e160 = phi_375_;
    let _e161 = (_e75 - 1u);
    let _e163 = (_e160 * f32(_e75));
    if _e83 {
        let _e170 = select(select(u32(_e163), 0u, (_e163 < bitcast<f32>(0u))), 4294967295u, (_e163 > bitcast<f32>(1333788671u)));
        if (_e161 < _e170) {
            phi_393_ = _e161;
        } else {
            phi_393_ = _e170;
        }
        let _e173 = phi_393_;
        phi_432_ = texture_Axis(_e173, _e173, 0f);
    } else {
        let _e175 = (_e163 + 0.5f);
        let _e182 = select(select(u32(_e175), 0u, (_e175 < bitcast<f32>(0u))), 4294967295u, (_e175 > bitcast<f32>(1333788671u)));
        if (_e75 < _e182) {
            phi_407_ = _e75;
        } else {
            phi_407_ = _e182;
        }
        let _e185 = phi_407_;
        if (_e88 == 0u) {
            phi_414_ = _e161;
        } else {
            phi_414_ = 0u;
        }
        let _e190 = phi_414_;
        if (_e88 == 0u) {
            phi_419_ = 0u;
        } else {
            phi_419_ = _e161;
        }
        let _e193 = phi_419_;
        if (_e185 == 0u) {
            phi_425_ = _e190;
        } else {
            phi_425_ = (_e185 - 1u);
        }
        let _e197 = phi_425_;
        if (_e185 > _e161) {
            phi_430_ = _e193;
        } else {
            phi_430_ = _e185;
        }
        let _e200 = phi_430_;
        phi_432_ = texture_Axis(_e197, _e200, (_e175 - f32(_e185)));
    }
    let _e203 = phi_432_;
    let _e205 = (*param_7).flags;
    let _e208 = ((_e205 >> bitcast<u32>(6u)) & 3u);
    if (_e208 == 0u) {
        if (param_9 > -8388608f) {
            let _e221 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e221 > param_9) {
                phi_460_ = 1f;
            } else {
                phi_460_ = 0f;
            }
            let _e224 = phi_460_;
            if (param_9 < 8388608f) {
                phi_465_ = (_e221 - _e224);
                phi_466_ = false;
            } else {
                phi_465_ = f32();
                phi_466_ = true;
            }
            let _e227 = phi_465_;
            let _e229 = phi_466_;
            phi_467_ = _e227;
            phi_468_ = _e229;
        } else {
            phi_467_ = f32();
            phi_468_ = true;
        }
        let _e231 = phi_467_;
        let _e233 = phi_468_;
        if _e233 {
            phi_472_ = param_9;
        } else {
            phi_472_ = _e231;
        }
        let _e235 = phi_472_;
        phi_520_ = (param_9 - _e235);
    } else {
        if (_e208 == 1u) {
            let _e238 = (param_9 * 0.5f);
            if (_e238 > -8388608f) {
                let _e250 = f32(select(0i, select(select(i32(_e238), i32(-2147483648), (_e238 < bitcast<f32>(3472883712u))), 2147483647i, (_e238 > bitcast<f32>(1325400063u))), (_e238 == _e238)));
                if (_e250 > _e238) {
                    phi_498_ = 1f;
                } else {
                    phi_498_ = 0f;
                }
                let _e253 = phi_498_;
                if (_e238 < 8388608f) {
                    phi_503_ = (_e250 - _e253);
                    phi_504_ = false;
                } else {
                    phi_503_ = f32();
                    phi_504_ = true;
                }
                let _e256 = phi_503_;
                let _e258 = phi_504_;
                phi_505_ = _e256;
                phi_506_ = _e258;
            } else {
                phi_505_ = f32();
                phi_506_ = true;
            }
            let _e260 = phi_505_;
            let _e262 = phi_506_;
            if _e262 {
                phi_510_ = _e238;
            } else {
                phi_510_ = _e260;
            }
            let _e264 = phi_510_;
            let _e266 = (param_9 - (2f * _e264));
            if (_e266 > 1f) {
                phi_518_ = (2f - _e266);
            } else {
                phi_518_ = _e266;
            }
            let _e270 = phi_518_;
            phi_519_ = _e270;
        } else {
            phi_519_ = param_9;
        }
        let _e272 = phi_519_;
        phi_520_ = _e272;
    }
    let _e274 = phi_520_;
    if (_e274 > 0f) {
        if (_e274 < 1f) {
            phi_529_ = _e274;
        } else {
            phi_529_ = 1f;
        }
        let _e278 = phi_529_;
        phi_530_ = _e278;
    } else {
        phi_530_ = 0f;
    }
    let _e280 = phi_530_;
    let _e281 = (_e79 - 1u);
    let _e283 = (_e280 * f32(_e79));
    if _e83 {
        let _e290 = select(select(u32(_e283), 0u, (_e283 < bitcast<f32>(0u))), 4294967295u, (_e283 > bitcast<f32>(1333788671u)));
        if (_e281 < _e290) {
            phi_548_ = _e281;
        } else {
            phi_548_ = _e290;
        }
        let _e293 = phi_548_;
        phi_587_ = texture_Axis(_e293, _e293, 0f);
    } else {
        let _e295 = (_e283 + 0.5f);
        let _e302 = select(select(u32(_e295), 0u, (_e295 < bitcast<f32>(0u))), 4294967295u, (_e295 > bitcast<f32>(1333788671u)));
        if (_e79 < _e302) {
            phi_562_ = _e79;
        } else {
            phi_562_ = _e302;
        }
        let _e305 = phi_562_;
        if (_e208 == 0u) {
            phi_569_ = _e281;
        } else {
            phi_569_ = 0u;
        }
        let _e310 = phi_569_;
        if (_e208 == 0u) {
            phi_574_ = 0u;
        } else {
            phi_574_ = _e281;
        }
        let _e313 = phi_574_;
        if (_e305 == 0u) {
            phi_580_ = _e310;
        } else {
            phi_580_ = (_e305 - 1u);
        }
        let _e317 = phi_580_;
        if (_e305 > _e281) {
            phi_585_ = _e313;
        } else {
            phi_585_ = _e305;
        }
        let _e320 = phi_585_;
        phi_587_ = texture_Axis(_e317, _e320, (_e295 - f32(_e305)));
    }
    let _e323 = phi_587_;
    let _e327 = (*param_7).offset;
    let _e334 = (*param_7).offset;
    let _e341 = (*param_7).offset;
    let _e348 = (*param_7).offset;
    return texture_TexelQuad(array<u32, 4>(((_e327 + (_e323.low * _e75)) + _e203.low), ((_e334 + (_e323.low * _e75)) + _e203.high), ((_e341 + (_e323.high * _e75)) + _e203.low), ((_e348 + (_e323.high * _e75)) + _e203.high)), vec4<f32>(((1f - _e203.fraction) * (1f - _e323.fraction)), (_e203.fraction * (1f - _e323.fraction)), ((1f - _e203.fraction) * _e323.fraction), (_e203.fraction * _e323.fraction)));
}

fn _lt_bvh_ray_Ray_new(param_10: vec3<f32>, param_11: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_10, 0f, param_11, 300000000000000000000000000000000000000f);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_12: f32, param_13: f32) -> f32 {
    var phi_646_: f32;

    if (param_12 > param_13) {
        phi_646_ = param_12;
    } else {
        phi_646_ = param_13;
    }
    let _e74 = phi_646_;
    return _e74;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: lt_bvh_traverse_Stack;
    var phi_788_: bool;
    var phi_789_: bool;
    var phi_790_: bool;
    var phi_791_: bool;
    var phi_795_: bool;
    var phi_808_: bool;
    var phi_809_: bool;
    var phi_810_: bool;
    var phi_811_: bool;
    var phi_815_: bool;
    var phi_828_: bool;
    var phi_829_: bool;
    var phi_830_: bool;
    var phi_834_: bool;
    var phi_835_: bool;
    var phi_836_: bool;
    var phi_837_: bool;
    var phi_838_: bool;
    var phi_842_: bool;
    var phi_918_: f32;
    var phi_925_: f32;
    var phi_933_: f32;
    var phi_940_: f32;
    var phi_948_: f32;
    var phi_955_: f32;
    var phi_978_: f32;
    var phi_983_: f32;
    var phi_988_: f32;
    var phi_993_: f32;
    var phi_998_: f32;
    var phi_1017_: u32;
    var phi_1022_: u32;
    var phi_1027_: u32;
    var phi_1141_: bool;
    var phi_1142_: bool;
    var phi_1173_: u32;
    var phi_1175_: u32;
    var phi_1178_: lt_bvh_Hit;
    var phi_1263_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1290_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1317_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1323_: u32;
    var phi_1326_: u32;
    var phi_1340_: u32;
    var phi_1350_: u32;
    var phi_1360_: u32;
    var phi_1378_: u32;
    var phi_1388_: u32;
    var phi_1398_: u32;
    var phi_1434_: u32;
    var phi_1447_: u32;
    var phi_1452_: u32;
    var phi_1453_: u32;
    var phi_1454_: u32;
    var phi_1324_: u32;
    var phi_1327_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1512_: u32;
    var phi_1515_: lt_bvh_Hit;
    var phi_1570_: f32;
    var phi_1575_: f32;
    var phi_1580_: f32;
    var phi_1588_: f32;
    var phi_1593_: f32;
    var phi_1598_: f32;
    var phi_1730_: bool;
    var phi_1731_: bool;
    var phi_1732_: bool;
    var phi_1733_: bool;
    var phi_1737_: bool;
    var phi_1750_: bool;
    var phi_1751_: bool;
    var phi_1752_: bool;
    var phi_1753_: bool;
    var phi_1757_: bool;
    var phi_1770_: bool;
    var phi_1771_: bool;
    var phi_1772_: bool;
    var phi_1776_: bool;
    var phi_1777_: bool;
    var phi_1778_: bool;
    var phi_1779_: bool;
    var phi_1780_: bool;
    var phi_1784_: bool;
    var phi_1854_: f32;
    var phi_1861_: f32;
    var phi_1868_: f32;
    var phi_1875_: f32;
    var phi_1882_: f32;
    var phi_1889_: f32;
    var phi_1906_: f32;
    var phi_1911_: f32;
    var phi_1916_: f32;
    var phi_1921_: f32;
    var phi_1926_: f32;
    var phi_1952_: bool;
    var phi_1953_: bool;
    var phi_1961_: u32;
    var phi_1962_: u32;
    var phi_1973_: vec3<f32>;
    var phi_1974_: vec3<f32>;
    var phi_1987_: u32;
    var phi_1992_: u32;
    var phi_1997_: u32;
    var phi_2111_: bool;
    var phi_2112_: bool;
    var phi_2143_: u32;
    var phi_2145_: lt_bvh_Hit;
    var phi_2148_: u32;
    var phi_2229_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2256_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2283_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2289_: u32;
    var phi_2292_: u32;
    var phi_2306_: u32;
    var phi_2316_: u32;
    var phi_2326_: u32;
    var phi_2344_: u32;
    var phi_2354_: u32;
    var phi_2364_: u32;
    var phi_2400_: u32;
    var phi_2413_: u32;
    var phi_2418_: u32;
    var phi_2419_: u32;
    var phi_2420_: u32;
    var phi_2290_: u32;
    var phi_2293_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2478_: lt_bvh_Hit;
    var phi_2481_: u32;
    var phi_2525_: vec3<f32>;
    var phi_2526_: vec3<f32>;
    var phi_2555_: vec3<f32>;
    var phi_2556_: vec3<f32>;
    var phi_2585_: vec3<f32>;
    var phi_2586_: vec3<f32>;
    var phi_2604_: bool;
    var phi_2605_: bool;
    var phi_2609_: f32;
    var phi_2610_: f32;
    var phi_2611_: f32;
    var phi_2612_: f32;
    var phi_2620_: f32;
    var phi_2630_: bool;
    var phi_2631_: bool;
    var phi_2635_: f32;
    var phi_2636_: f32;
    var phi_2637_: f32;
    var phi_2638_: f32;
    var phi_2646_: f32;
    var phi_2656_: bool;
    var phi_2657_: bool;
    var phi_2661_: f32;
    var phi_2662_: f32;
    var phi_2663_: f32;
    var phi_2664_: f32;
    var phi_2672_: f32;
    var phi_2687_: f32;
    var phi_2688_: bool;
    var phi_2689_: f32;
    var phi_2690_: bool;
    var phi_2691_: f32;
    var phi_2692_: bool;
    var phi_2710_: f32;
    var phi_2711_: bool;
    var phi_2712_: bool;
    var phi_2713_: f32;
    var phi_2714_: bool;
    var phi_2715_: bool;
    var phi_2719_: bool;
    var phi_2720_: f32;
    var phi_2721_: bool;
    var phi_2749_: vec3<f32>;
    var phi_2750_: vec3<f32>;
    var phi_2775_: vec3<f32>;
    var phi_2776_: vec3<f32>;
    var phi_2801_: vec3<f32>;
    var phi_2802_: vec3<f32>;
    var phi_2858_: f32;
    var phi_2867_: f32;
    var phi_2876_: f32;
    var phi_2885_: f32;
    var phi_2892_: f32;
    var phi_2899_: f32;
    var phi_2912_: f32;
    var phi_2921_: f32;
    var phi_2930_: f32;
    var phi_2939_: f32;
    var phi_2946_: f32;
    var phi_2953_: f32;
    var phi_2970_: f32;
    var phi_2975_: f32;
    var phi_2980_: f32;
    var phi_2988_: f32;
    var phi_2993_: f32;
    var phi_2998_: f32;
    var phi_3010_: f32;
    var phi_3015_: f32;
    var phi_3020_: f32;
    var phi_3025_: f32;
    var phi_3030_: lt_bvh_triangle_Intersection;
    var phi_3031_: bool;
    var phi_3032_: lt_bvh_triangle_Intersection;
    var phi_3033_: bool;
    var phi_3037_: lt_bvh_triangle_Intersection;
    var phi_3038_: bool;
    var phi_3039_: lt_bvh_triangle_Intersection;
    var phi_3040_: bool;
    var phi_3041_: bool;
    var phi_3045_: bool;
    var phi_3049_: lt_bvh_triangle_Intersection;
    var phi_3087_: bool;
    var phi_3088_: bool;
    var phi_3089_: bool;
    var phi_3090_: bool;
    var phi_3091_: bool;
    var phi_3092_: bool;
    var phi_3096_: bool;
    var phi_3097_: bool;
    var phi_3111_: bool;
    var phi_3119_: lt_bvh_Hit;
    var phi_3120_: lt_bvh_Hit;
    var phi_3121_: lt_bvh_Hit;
    var phi_3122_: lt_bvh_Hit;
    var phi_2479_: lt_bvh_Hit;
    var phi_2482_: u32;
    var phi_3123_: bool;
    var phi_3162_: bool;
    var phi_3163_: bool;
    var phi_3194_: u32;
    var phi_2146_: lt_bvh_Hit;
    var phi_2149_: u32;
    var phi_3195_: lt_bvh_Hit;
    var phi_3196_: lt_bvh_Hit;
    var phi_3197_: bool;
    var phi_3201_: lt_bvh_Hit;
    var phi_3202_: lt_bvh_Hit;
    var phi_3203_: lt_bvh_Hit;
    var phi_3204_: lt_bvh_Hit;
    var phi_1513_: u32;
    var phi_1516_: lt_bvh_Hit;
    var phi_3205_: bool;
    var phi_3244_: bool;
    var phi_3245_: bool;
    var phi_3276_: u32;
    var phi_1176_: u32;
    var phi_1179_: lt_bvh_Hit;
    var phi_3277_: lt_bvh_Hit;
    var phi_3278_: lt_bvh_Hit;
    var phi_3279_: bool;
    var phi_3283_: lt_bvh_Hit;
    var phi_3470_: f32;
    var phi_3475_: f32;
    var phi_3480_: f32;
    var phi_3488_: f32;
    var phi_3493_: f32;
    var phi_3498_: f32;
    var phi_3562_: vec3<f32>;
    var phi_3805_: vec3<f32>;
    var phi_3820_: u32;
    var phi_3847_: f32;
    var phi_3854_: f32;
    var phi_3861_: f32;
    var phi_3896_: f32;
    var phi_3903_: f32;
    var phi_3910_: f32;
    var phi_3948_: f32;
    var phi_3955_: f32;
    var phi_3962_: f32;
    var phi_4048_: vec3<f32>;
    var phi_4049_: vec3<f32>;
    var phi_4050_: vec3<f32>;
    var phi_4059_: f32;
    var phi_4060_: f32;
    var phi_4070_: f32;
    var phi_4071_: f32;
    var phi_4081_: f32;
    var phi_4082_: f32;
    var phi_4117_: abi_Sample;
    var local_9: lt_bvh_Hit;
    var local_10: lt_bvh_Hit;
    var local_11: lt_bvh_Hit;
    var local_12: lt_bvh_Hit;

    let _e73 = id_1;
    let _e77 = arrayLength((&nodes.member));
    let _e80 = arrayLength((&triangles.member));
    let _e83 = arrayLength((&vertices.member));
    let _e92 = arrayLength((&instances.member));
    let _e95 = arrayLength((&color_texels.member));
    let _e98 = p.member.size[0u];
    let _e100 = p.member.size[1u];
    let _e101 = lt_shaders_entry_pixel_index(_e73, _e98, _e100);
    if (bitcast<i32>(_e101.root) != 0i) {
        let _e107 = p.member.root;
        let _e111 = p.member.eye;
        let _e114 = p.member.grid[0u];
        let _e116 = p.member.grid[1u];
        let _e135 = p.member.size[0u];
        let _e139 = ((((f32(_e73.x) + ((f32((_e73.y & (_e116 - 1u))) + 0.5f) / f32(_e116))) / f32(_e135)) * 2f) - 1f);
        let _e142 = p.member.size[1u];
        let _e146 = (1f - (((f32(_e73.y) + ((f32((_e73.x & (_e114 - 1u))) + 0.5f) / f32(_e114))) / f32(_e142)) * 2f));
        let _e148 = p.member.forward;
        let _e150 = p.member.right;
        let _e164 = p.member.up;
        let _e175 = _lt_bvh_ray_Ray_new(_e111, vec3<f32>(((_e148.x + (_e150.x * _e139)) + (_e164.x * _e146)), ((_e148.y + (_e150.y * _e139)) + (_e164.y * _e146)), ((_e148.z + (_e150.z * _e139)) + (_e164.z * _e146))));
        let _e177 = lt_bvh_Hit(_e175.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e180 = abs(_e175.direction.x);
        let _e182 = abs(_e175.direction.y);
        let _e184 = abs(_e175.direction.z);
        if (abs(_e175.origin.x) < 1000000000000000f) {
            if (abs(_e175.origin.y) < 1000000000000000f) {
                phi_788_ = (abs(_e175.origin.z) < 1000000000000000f);
                phi_789_ = false;
            } else {
                phi_788_ = bool();
                phi_789_ = true;
            }
            let _e196 = phi_788_;
            let _e198 = phi_789_;
            phi_790_ = _e196;
            phi_791_ = _e198;
        } else {
            phi_790_ = bool();
            phi_791_ = true;
        }
        let _e200 = phi_790_;
        let _e202 = phi_791_;
        if _e202 {
            phi_795_ = false;
        } else {
            phi_795_ = _e200;
        }
        let _e204 = phi_795_;
        if _e204 {
            if (_e180 < 1000000000000000f) {
                if (_e182 < 1000000000000000f) {
                    phi_808_ = (_e184 < 1000000000000000f);
                    phi_809_ = false;
                } else {
                    phi_808_ = bool();
                    phi_809_ = true;
                }
                let _e209 = phi_808_;
                let _e211 = phi_809_;
                phi_810_ = _e209;
                phi_811_ = _e211;
            } else {
                phi_810_ = bool();
                phi_811_ = true;
            }
            let _e213 = phi_810_;
            let _e215 = phi_811_;
            if _e215 {
                phi_815_ = false;
            } else {
                phi_815_ = _e213;
            }
            let _e217 = phi_815_;
            if _e217 {
                if (_e180 > 0f) {
                    phi_829_ = bool();
                    phi_830_ = true;
                } else {
                    let _e219 = (_e182 > 0f);
                    if _e219 {
                        phi_828_ = bool();
                    } else {
                        phi_828_ = (_e184 > 0f);
                    }
                    let _e222 = phi_828_;
                    phi_829_ = _e222;
                    phi_830_ = _e219;
                }
                let _e224 = phi_829_;
                let _e226 = phi_830_;
                if _e226 {
                    phi_834_ = true;
                } else {
                    phi_834_ = _e224;
                }
                let _e228 = phi_834_;
                phi_835_ = _e228;
                phi_836_ = false;
            } else {
                phi_835_ = bool();
                phi_836_ = true;
            }
            let _e230 = phi_835_;
            let _e232 = phi_836_;
            phi_837_ = _e230;
            phi_838_ = _e232;
        } else {
            phi_837_ = bool();
            phi_838_ = true;
        }
        let _e234 = phi_837_;
        let _e236 = phi_838_;
        if _e236 {
            phi_842_ = false;
        } else {
            phi_842_ = _e234;
        }
        let _e238 = phi_842_;
        if _e238 {
            let _e239 = (_e107 >= _e77);
            if _e239 {
                phi_3277_ = lt_bvh_Hit();
            } else {
                if (_e107 < _e77) {
                } else {
                    return;
                }
                let _e245 = nodes.member[(0u + _e107)].frame[0u];
                let _e249 = nodes.member[(0u + _e107)].frame[1u];
                let _e253 = nodes.member[(0u + _e107)].frame[2u];
                let _e257 = nodes.member[(0u + _e107)].frame[0u];
                let _e261 = nodes.member[(0u + _e107)].frame[1u];
                let _e265 = nodes.member[(0u + _e107)].frame[2u];
                let _e269 = nodes.member[(0u + _e107)].frame[3u];
                let _e308 = core_intrinsics_maximum_number_nsz_f32_(abs(_e175.direction.x), abs(_e175.direction.y));
                let _e309 = core_intrinsics_maximum_number_nsz_f32_(_e308, abs(_e175.direction.z));
                let _e310 = (_e309 * 0.0000000000009094947f);
                if (abs(_e175.direction.x) < _e310) {
                    phi_918_ = _e310;
                } else {
                    phi_918_ = abs(_e175.direction.x);
                }
                let _e316 = phi_918_;
                if (_e175.direction.x < 0f) {
                    phi_925_ = (-1f / _e316);
                } else {
                    phi_925_ = (1f / _e316);
                }
                let _e321 = phi_925_;
                if (abs(_e175.direction.y) < _e310) {
                    phi_933_ = _e310;
                } else {
                    phi_933_ = abs(_e175.direction.y);
                }
                let _e327 = phi_933_;
                if (_e175.direction.y < 0f) {
                    phi_940_ = (-1f / _e327);
                } else {
                    phi_940_ = (1f / _e327);
                }
                let _e332 = phi_940_;
                if (abs(_e175.direction.z) < _e310) {
                    phi_948_ = _e310;
                } else {
                    phi_948_ = abs(_e175.direction.z);
                }
                let _e338 = phi_948_;
                if (_e175.direction.z < 0f) {
                    phi_955_ = (-1f / _e338);
                } else {
                    phi_955_ = (1f / _e338);
                }
                let _e343 = phi_955_;
                let _e350 = abs((bitcast<f32>(_e245) - _e175.origin.x));
                let _e351 = abs((bitcast<f32>(_e249) - _e175.origin.y));
                let _e352 = abs((bitcast<f32>(_e253) - _e175.origin.z));
                let _e359 = abs(((bitcast<f32>(_e257) + (bitcast<f32>((((_e269 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e175.origin.x));
                let _e360 = abs(((bitcast<f32>(_e261) + (bitcast<f32>((((_e269 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e175.origin.y));
                let _e361 = abs(((bitcast<f32>(_e265) + (bitcast<f32>((((_e269 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e175.origin.z));
                if (_e350 > _e359) {
                    phi_978_ = _e350;
                } else {
                    phi_978_ = _e359;
                }
                let _e364 = phi_978_;
                if (_e351 > _e360) {
                    phi_983_ = _e351;
                } else {
                    phi_983_ = _e360;
                }
                let _e367 = phi_983_;
                if (_e352 > _e361) {
                    phi_988_ = _e352;
                } else {
                    phi_988_ = _e361;
                }
                let _e370 = phi_988_;
                if (_e364 > _e367) {
                    phi_993_ = _e364;
                } else {
                    phi_993_ = _e367;
                }
                let _e373 = phi_993_;
                if (_e373 > _e370) {
                    phi_998_ = _e373;
                } else {
                    phi_998_ = _e370;
                }
                let _e376 = phi_998_;
                let _e380 = (_e376 * 0.0000019073486f);
                let _e381 = (abs(_e321) * _e380);
                let _e382 = (abs(_e332) * _e380);
                let _e383 = (abs(_e343) * _e380);
                let _e387 = (_e376 * 0.0000009536743f);
                let _e388 = (abs(_e321) * _e387);
                let _e389 = (abs(_e332) * _e387);
                let _e390 = (abs(_e343) * _e387);
                if (_e321 < 0f) {
                    phi_1017_ = 0u;
                } else {
                    phi_1017_ = 1u;
                }
                let _e393 = phi_1017_;
                if (_e332 < 0f) {
                    phi_1022_ = 0u;
                } else {
                    phi_1022_ = 2u;
                }
                let _e396 = phi_1022_;
                if (_e343 < 0f) {
                    phi_1027_ = 0u;
                } else {
                    phi_1027_ = 4u;
                }
                let _e399 = phi_1027_;
                let _e401 = ((_e393 | _e396) | _e399);
                let _e402 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e107, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e402.first[0], _e402.first[1], _e402.first[2], _e402.first[3], _e402.first[4], _e402.first[5], _e402.first[6], _e402.first[7], _e402.first[8], _e402.first[9], _e402.first[10], _e402.first[11], _e402.first[12], _e402.first[13], _e402.first[14], _e402.first[15], _e402.first[16], _e402.first[17], _e402.first[18], _e402.first[19], _e402.first[20], _e402.first[21], _e402.first[22], _e402.first[23], _e402.first[24], _e402.first[25], _e402.first[26], _e402.first[27], _e402.first[28], _e402.first[29], _e402.first[30], _e402.first[31]), array<u32, 32>(_e402.mask[0], _e402.mask[1], _e402.mask[2], _e402.mask[3], _e402.mask[4], _e402.mask[5], _e402.mask[6], _e402.mask[7], _e402.mask[8], _e402.mask[9], _e402.mask[10], _e402.mask[11], _e402.mask[12], _e402.mask[13], _e402.mask[14], _e402.mask[15], _e402.mask[16], _e402.mask[17], _e402.mask[18], _e402.mask[19], _e402.mask[20], _e402.mask[21], _e402.mask[22], _e402.mask[23], _e402.mask[24], _e402.mask[25], _e402.mask[26], _e402.mask[27], _e402.mask[28], _e402.mask[29], _e402.mask[30], _e402.mask[31]), _e402.len, _e402.group, _e402.group_mask);
                let _e476 = local_2.group_mask;
                if ((_e476 & 4278190080u) == 0u) {
                    let _e480 = local_2.len;
                    if (_e480 == 0u) {
                        phi_1141_ = false;
                    } else {
                        let _e484 = local_2.len;
                        local_2.len = (_e484 - 1u);
                        let _e487 = local_2.len;
                        if (_e487 < 32u) {
                        } else {
                            return;
                        }
                        let _e492 = local_2.first[(0u + _e487)];
                        local_2.group = _e492;
                        let _e495 = local_2.len;
                        if (_e495 < 32u) {
                        } else {
                            return;
                        }
                        let _e500 = local_2.mask[(0u + _e495)];
                        local_2.group_mask = _e500;
                        phi_1141_ = true;
                    }
                    let _e503 = phi_1141_;
                    phi_1142_ = _e503;
                } else {
                    phi_1142_ = true;
                }
                let _e505 = phi_1142_;
                if _e505 {
                    let _e507 = local_2.group_mask;
                    let _e513 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e507)), 32u, (_e507 == 0u)));
                    let _e517 = local_2.group_mask;
                    let _e531 = local_2.group_mask;
                    local_2.group_mask = (_e531 & ~((1u << bitcast<u32>((_e513 & 31u)))));
                    let _e534 = local_2.group;
                    phi_1173_ = (_e534 + countOneBits(((_e517 & ~((4294967295u << bitcast<u32>((((_e513 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1173_ = 4294967295u;
                }
                let _e537 = phi_1173_;
                phi_1175_ = _e537;
                phi_1178_ = _e177;
                loop {
                    let _e539 = phi_1175_;
                    let _e541 = phi_1178_;
                    local_12 = _e541;
                    let _e542 = (_e539 != 4294967295u);
                    if _e542 {
                        if (_e539 < _e77) {
                        } else {
                            return;
                        }
                        let _e550 = nodes.member[(0u + _e539)].frame[3u];
                        let _e575 = (bitcast<f32>((((_e550 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e321);
                        let _e576 = (bitcast<f32>((((_e550 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e332);
                        let _e577 = (bitcast<f32>((((_e550 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e343);
                        let _e580 = nodes.member[(0u + _e539)].frame[0u];
                        let _e584 = nodes.member[(0u + _e539)].frame[1u];
                        let _e588 = nodes.member[(0u + _e539)].frame[2u];
                        let _e596 = ((bitcast<f32>(_e580) - _e175.origin.x) * _e321);
                        let _e597 = ((bitcast<f32>(_e584) - _e175.origin.y) * _e332);
                        let _e598 = ((bitcast<f32>(_e588) - _e175.origin.z) * _e343);
                        let _e606 = nodes.member[(0u + _e539)].x;
                        if (_e321 < 0f) {
                            let _e617 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e606.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e623 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e617.unnamed.root, _e606.w), _e617.unnamed_1);
                            let _e629 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e623.unnamed, lt_bvh_traverse_Tree(_e606.x, _e623.unnamed_1.first_primitive));
                            phi_1263_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e629.unnamed, lt_bvh_traverse_Tree(_e629.unnamed_1.root, _e606.y));
                        } else {
                            let _e645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e606.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e651 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e645.unnamed.root, _e606.y), _e645.unnamed_1);
                            let _e657 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e651.unnamed, lt_bvh_traverse_Tree(_e606.z, _e651.unnamed_1.first_primitive));
                            phi_1263_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e657.unnamed, lt_bvh_traverse_Tree(_e657.unnamed_1.root, _e606.w));
                        }
                        let _e665 = phi_1263_;
                        let _e675 = nodes.member[(0u + _e539)].y;
                        if (_e332 < 0f) {
                            let _e686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e675.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e692 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e686.unnamed.root, _e675.w), _e686.unnamed_1);
                            let _e698 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e692.unnamed, lt_bvh_traverse_Tree(_e675.x, _e692.unnamed_1.first_primitive));
                            phi_1290_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e698.unnamed, lt_bvh_traverse_Tree(_e698.unnamed_1.root, _e675.y));
                        } else {
                            let _e714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e675.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e720 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e714.unnamed.root, _e675.y), _e714.unnamed_1);
                            let _e726 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e720.unnamed, lt_bvh_traverse_Tree(_e675.z, _e720.unnamed_1.first_primitive));
                            phi_1290_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e726.unnamed, lt_bvh_traverse_Tree(_e726.unnamed_1.root, _e675.w));
                        }
                        let _e734 = phi_1290_;
                        let _e744 = nodes.member[(0u + _e539)].z;
                        if (_e343 < 0f) {
                            let _e755 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e744.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e761 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e755.unnamed.root, _e744.w), _e755.unnamed_1);
                            let _e767 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e761.unnamed, lt_bvh_traverse_Tree(_e744.x, _e761.unnamed_1.first_primitive));
                            phi_1317_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e767.unnamed, lt_bvh_traverse_Tree(_e767.unnamed_1.root, _e744.y));
                        } else {
                            let _e783 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e744.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e789 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e783.unnamed.root, _e744.y), _e783.unnamed_1);
                            let _e795 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e789.unnamed, lt_bvh_traverse_Tree(_e744.z, _e789.unnamed_1.first_primitive));
                            phi_1317_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e795.unnamed, lt_bvh_traverse_Tree(_e795.unnamed_1.root, _e744.w));
                        }
                        let _e803 = phi_1317_;
                        phi_1323_ = 0u;
                        phi_1326_ = 0u;
                        loop {
                            let _e813 = phi_1323_;
                            let _e815 = phi_1326_;
                            local_3 = _e815;
                            local_4 = _e815;
                            local_5 = _e815;
                            let _e816 = (_e813 < 8u);
                            if _e816 {
                                let _e818 = (_e813 >> bitcast<u32>(2i));
                                let _e819 = (_e813 & 3u);
                                if (_e818 == 0u) {
                                    phi_1340_ = _e665.unnamed.root;
                                } else {
                                    phi_1340_ = _e665.unnamed.first_primitive;
                                }
                                let _e822 = phi_1340_;
                                if (_e818 == 0u) {
                                    phi_1350_ = _e734.unnamed.root;
                                } else {
                                    phi_1350_ = _e734.unnamed.first_primitive;
                                }
                                let _e831 = phi_1350_;
                                if (_e818 == 0u) {
                                    phi_1360_ = _e803.unnamed.root;
                                } else {
                                    phi_1360_ = _e803.unnamed.first_primitive;
                                }
                                let _e840 = phi_1360_;
                                let _e853 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e822 >> bitcast<u32>(((_e819 * 8u) & 31u))) & 255u)) * _e575) + (_e596 - _e381)), ((f32(((_e831 >> bitcast<u32>(((_e819 * 8u) & 31u))) & 255u)) * _e576) + (_e597 - _e382)));
                                let _e854 = core_intrinsics_maximum_number_nsz_f32_(_e853, ((f32(((_e840 >> bitcast<u32>(((_e819 * 8u) & 31u))) & 255u)) * _e577) + (_e598 - _e383)));
                                if (_e818 == 0u) {
                                    phi_1378_ = _e665.unnamed_1.root;
                                } else {
                                    phi_1378_ = _e665.unnamed_1.first_primitive;
                                }
                                let _e857 = phi_1378_;
                                if (_e818 == 0u) {
                                    phi_1388_ = _e734.unnamed_1.root;
                                } else {
                                    phi_1388_ = _e734.unnamed_1.first_primitive;
                                }
                                let _e866 = phi_1388_;
                                if (_e818 == 0u) {
                                    phi_1398_ = _e803.unnamed_1.root;
                                } else {
                                    phi_1398_ = _e803.unnamed_1.first_primitive;
                                }
                                let _e875 = phi_1398_;
                                let _e888 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e857 >> bitcast<u32>(((_e819 * 8u) & 31u))) & 255u)) * _e575) + (_e596 + _e381)), ((f32(((_e866 >> bitcast<u32>(((_e819 * 8u) & 31u))) & 255u)) * _e576) + (_e597 + _e382)));
                                let _e889 = core_intrinsics_minimum_number_nsz_f32_(_e888, ((f32(((_e875 >> bitcast<u32>(((_e819 * 8u) & 31u))) & 255u)) * _e577) + (_e598 + _e383)));
                                if (_e854 <= _e889) {
                                    if (_e854 <= _e541.t) {
                                        if (_e889 >= _e175.tmin) {
                                            if (_e818 == 0u) {
                                                let _e896 = nodes.member[(0u + _e539)].links[2u];
                                                phi_1434_ = _e896;
                                            } else {
                                                let _e899 = nodes.member[(0u + _e539)].links[3u];
                                                phi_1434_ = _e899;
                                            }
                                            let _e901 = phi_1434_;
                                            let _e906 = ((_e901 >> bitcast<u32>(((_e819 * 8u) & 31u))) & 255u);
                                            let _e907 = (_e906 & 31u);
                                            if (_e907 >= 24u) {
                                                phi_1447_ = (24u + ((_e907 - 24u) ^ _e401));
                                            } else {
                                                phi_1447_ = _e907;
                                            }
                                            let _e913 = phi_1447_;
                                            phi_1452_ = (_e815 | ((_e906 >> bitcast<u32>(5i)) << bitcast<u32>((_e913 & 31u))));
                                        } else {
                                            phi_1452_ = _e815;
                                        }
                                        let _e921 = phi_1452_;
                                        phi_1453_ = _e921;
                                    } else {
                                        phi_1453_ = _e815;
                                    }
                                    let _e923 = phi_1453_;
                                    phi_1454_ = _e923;
                                } else {
                                    phi_1454_ = _e815;
                                }
                                let _e925 = phi_1454_;
                                phi_1324_ = (_e813 + 1u);
                                phi_1327_ = _e925;
                            } else {
                                phi_1324_ = u32();
                                phi_1327_ = u32();
                            }
                            let _e928 = phi_1324_;
                            let _e930 = phi_1327_;
                            continue;
                            continuing {
                                phi_1323_ = _e928;
                                phi_1326_ = _e930;
                                break if !(_e816);
                            }
                        }
                        let _e934 = nodes.member[(0u + _e539)].links[0u];
                        let _e938 = nodes.member[(0u + _e539)].frame[3u];
                        let _e942 = local_3;
                        if ((_e942 & 4278190080u) == 0u) {
                        } else {
                            let _e946 = local_2.group_mask;
                            if ((_e946 & 4278190080u) == 0u) {
                            } else {
                                let _e950 = local_2.len;
                                if (_e950 < 32u) {
                                    let _e953 = local_2.group;
                                    let _e955 = local_2.len;
                                    if (_e955 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e955)] = _e953;
                                    let _e961 = local_2.group_mask;
                                    let _e963 = local_2.len;
                                    if (_e963 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e963)] = _e961;
                                    let _e970 = local_2.len;
                                    local_2.len = (_e970 + 1u);
                                }
                            }
                            local_2.group = (_e107 + _e934);
                            let _e974 = local_4;
                            local_2.group_mask = ((_e974 & 4278190080u) | (_e938 >> bitcast<u32>(24i)));
                        }
                        let _e979 = local_5;
                        phi_1512_ = (_e979 & 16777215u);
                        phi_1515_ = _e541;
                        loop {
                            let _e982 = phi_1512_;
                            let _e984 = phi_1515_;
                            local_11 = _e984;
                            if (_e982 == 0u) {
                                phi_1513_ = u32();
                                phi_1516_ = lt_bvh_Hit();
                                phi_3205_ = false;
                            } else {
                                let _e988 = nodes.member[(0u + _e539)].links[1u];
                                let _e992 = (_e988 + select(firstTrailingBit(_e982), 32u, (_e982 == 0u)));
                                if (_e992 < _e92) {
                                } else {
                                    return;
                                }
                                let _e999 = instances.member[(0u + _e992)].low_world;
                                let _e1001 = instances.member[(0u + _e992)].high_world;
                                let _e1011 = ((_e999.x - _e175.origin.x) * _e321);
                                let _e1012 = ((_e999.y - _e175.origin.y) * _e332);
                                let _e1013 = ((_e999.z - _e175.origin.z) * _e343);
                                let _e1023 = ((_e1001.x - _e175.origin.x) * _e321);
                                let _e1024 = ((_e1001.y - _e175.origin.y) * _e332);
                                let _e1025 = ((_e1001.z - _e175.origin.z) * _e343);
                                if (_e1011 < _e1023) {
                                    phi_1570_ = _e1011;
                                } else {
                                    phi_1570_ = _e1023;
                                }
                                let _e1028 = phi_1570_;
                                if (_e1012 < _e1024) {
                                    phi_1575_ = _e1012;
                                } else {
                                    phi_1575_ = _e1024;
                                }
                                let _e1031 = phi_1575_;
                                if (_e1013 < _e1025) {
                                    phi_1580_ = _e1013;
                                } else {
                                    phi_1580_ = _e1025;
                                }
                                let _e1034 = phi_1580_;
                                if (_e1011 > _e1023) {
                                    phi_1588_ = _e1011;
                                } else {
                                    phi_1588_ = _e1023;
                                }
                                let _e1040 = phi_1588_;
                                if (_e1012 > _e1024) {
                                    phi_1593_ = _e1012;
                                } else {
                                    phi_1593_ = _e1024;
                                }
                                let _e1043 = phi_1593_;
                                if (_e1013 > _e1025) {
                                    phi_1598_ = _e1013;
                                } else {
                                    phi_1598_ = _e1025;
                                }
                                let _e1046 = phi_1598_;
                                let _e1050 = core_intrinsics_maximum_number_nsz_f32_((_e1028 - _e388), (_e1031 - _e389));
                                let _e1051 = core_intrinsics_maximum_number_nsz_f32_(_e1050, (_e1034 - _e390));
                                let _e1052 = core_intrinsics_minimum_number_nsz_f32_((_e1040 + _e388), (_e1043 + _e389));
                                let _e1053 = core_intrinsics_minimum_number_nsz_f32_(_e1052, (_e1046 + _e390));
                                if (_e1051 <= _e1053) {
                                    if (_e1051 <= _e984.t) {
                                        if (_e1053 >= _e175.tmin) {
                                            let _e1065 = instances.member[(0u + _e992)].world_to_object[0u];
                                            let _e1076 = ((((_e1065.x * _e175.origin.x) + (_e1065.y * _e175.origin.y)) + (_e1065.z * _e175.origin.z)) + (_e1065.w * 1f));
                                            let _e1078 = instances.member[(0u + _e992)].world_to_object[1u];
                                            let _e1089 = ((((_e1078.x * _e175.origin.x) + (_e1078.y * _e175.origin.y)) + (_e1078.z * _e175.origin.z)) + (_e1078.w * 1f));
                                            let _e1091 = instances.member[(0u + _e992)].world_to_object[2u];
                                            let _e1102 = ((((_e1091.x * _e175.origin.x) + (_e1091.y * _e175.origin.y)) + (_e1091.z * _e175.origin.z)) + (_e1091.w * 1f));
                                            let _e1109 = instances.member[(0u + _e992)].world_to_object[0u];
                                            let _e1120 = ((((_e1109.x * _e175.direction.x) + (_e1109.y * _e175.direction.y)) + (_e1109.z * _e175.direction.z)) + (_e1109.w * 0f));
                                            let _e1122 = instances.member[(0u + _e992)].world_to_object[1u];
                                            let _e1133 = ((((_e1122.x * _e175.direction.x) + (_e1122.y * _e175.direction.y)) + (_e1122.z * _e175.direction.z)) + (_e1122.w * 0f));
                                            let _e1135 = instances.member[(0u + _e992)].world_to_object[2u];
                                            let _e1146 = ((((_e1135.x * _e175.direction.x) + (_e1135.y * _e175.direction.y)) + (_e1135.z * _e175.direction.z)) + (_e1135.w * 0f));
                                            let _e1151 = instances.member[(0u + _e992)].root;
                                            let _e1153 = instances.member[(0u + _e992)].first_triangle;
                                            let _e1154 = abs(_e1120);
                                            let _e1155 = abs(_e1133);
                                            let _e1156 = abs(_e1146);
                                            if (abs(_e1076) < 1000000000000000f) {
                                                if (abs(_e1089) < 1000000000000000f) {
                                                    phi_1730_ = (abs(_e1102) < 1000000000000000f);
                                                    phi_1731_ = false;
                                                } else {
                                                    phi_1730_ = bool();
                                                    phi_1731_ = true;
                                                }
                                                let _e1164 = phi_1730_;
                                                let _e1166 = phi_1731_;
                                                phi_1732_ = _e1164;
                                                phi_1733_ = _e1166;
                                            } else {
                                                phi_1732_ = bool();
                                                phi_1733_ = true;
                                            }
                                            let _e1168 = phi_1732_;
                                            let _e1170 = phi_1733_;
                                            if _e1170 {
                                                phi_1737_ = false;
                                            } else {
                                                phi_1737_ = _e1168;
                                            }
                                            let _e1172 = phi_1737_;
                                            if _e1172 {
                                                if (_e1154 < 1000000000000000f) {
                                                    if (_e1155 < 1000000000000000f) {
                                                        phi_1750_ = (_e1156 < 1000000000000000f);
                                                        phi_1751_ = false;
                                                    } else {
                                                        phi_1750_ = bool();
                                                        phi_1751_ = true;
                                                    }
                                                    let _e1177 = phi_1750_;
                                                    let _e1179 = phi_1751_;
                                                    phi_1752_ = _e1177;
                                                    phi_1753_ = _e1179;
                                                } else {
                                                    phi_1752_ = bool();
                                                    phi_1753_ = true;
                                                }
                                                let _e1181 = phi_1752_;
                                                let _e1183 = phi_1753_;
                                                if _e1183 {
                                                    phi_1757_ = false;
                                                } else {
                                                    phi_1757_ = _e1181;
                                                }
                                                let _e1185 = phi_1757_;
                                                if _e1185 {
                                                    if (_e1154 > 0f) {
                                                        phi_1771_ = bool();
                                                        phi_1772_ = true;
                                                    } else {
                                                        let _e1187 = (_e1155 > 0f);
                                                        if _e1187 {
                                                            phi_1770_ = bool();
                                                        } else {
                                                            phi_1770_ = (_e1156 > 0f);
                                                        }
                                                        let _e1190 = phi_1770_;
                                                        phi_1771_ = _e1190;
                                                        phi_1772_ = _e1187;
                                                    }
                                                    let _e1192 = phi_1771_;
                                                    let _e1194 = phi_1772_;
                                                    if _e1194 {
                                                        phi_1776_ = true;
                                                    } else {
                                                        phi_1776_ = _e1192;
                                                    }
                                                    let _e1196 = phi_1776_;
                                                    phi_1777_ = _e1196;
                                                    phi_1778_ = false;
                                                } else {
                                                    phi_1777_ = bool();
                                                    phi_1778_ = true;
                                                }
                                                let _e1198 = phi_1777_;
                                                let _e1200 = phi_1778_;
                                                phi_1779_ = _e1198;
                                                phi_1780_ = _e1200;
                                            } else {
                                                phi_1779_ = bool();
                                                phi_1780_ = true;
                                            }
                                            let _e1202 = phi_1779_;
                                            let _e1204 = phi_1780_;
                                            if _e1204 {
                                                phi_1784_ = false;
                                            } else {
                                                phi_1784_ = _e1202;
                                            }
                                            let _e1206 = phi_1784_;
                                            if _e1206 {
                                                let _e1207 = (_e1151 >= _e77);
                                                if _e1207 {
                                                    phi_3195_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1151 < _e77) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1213 = nodes.member[(0u + _e1151)].frame[0u];
                                                    let _e1217 = nodes.member[(0u + _e1151)].frame[1u];
                                                    let _e1221 = nodes.member[(0u + _e1151)].frame[2u];
                                                    let _e1225 = nodes.member[(0u + _e1151)].frame[0u];
                                                    let _e1229 = nodes.member[(0u + _e1151)].frame[1u];
                                                    let _e1233 = nodes.member[(0u + _e1151)].frame[2u];
                                                    let _e1237 = nodes.member[(0u + _e1151)].frame[3u];
                                                    let _e1271 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1120), abs(_e1133));
                                                    let _e1272 = core_intrinsics_maximum_number_nsz_f32_(_e1271, abs(_e1146));
                                                    let _e1273 = (_e1272 * 0.0000000000009094947f);
                                                    if (abs(_e1120) < _e1273) {
                                                        phi_1854_ = _e1273;
                                                    } else {
                                                        phi_1854_ = abs(_e1120);
                                                    }
                                                    let _e1278 = phi_1854_;
                                                    if (_e1120 < 0f) {
                                                        phi_1861_ = (-1f / _e1278);
                                                    } else {
                                                        phi_1861_ = (1f / _e1278);
                                                    }
                                                    let _e1283 = phi_1861_;
                                                    if (abs(_e1133) < _e1273) {
                                                        phi_1868_ = _e1273;
                                                    } else {
                                                        phi_1868_ = abs(_e1133);
                                                    }
                                                    let _e1288 = phi_1868_;
                                                    if (_e1133 < 0f) {
                                                        phi_1875_ = (-1f / _e1288);
                                                    } else {
                                                        phi_1875_ = (1f / _e1288);
                                                    }
                                                    let _e1293 = phi_1875_;
                                                    if (abs(_e1146) < _e1273) {
                                                        phi_1882_ = _e1273;
                                                    } else {
                                                        phi_1882_ = abs(_e1146);
                                                    }
                                                    let _e1298 = phi_1882_;
                                                    if (_e1146 < 0f) {
                                                        phi_1889_ = (-1f / _e1298);
                                                    } else {
                                                        phi_1889_ = (1f / _e1298);
                                                    }
                                                    let _e1303 = phi_1889_;
                                                    let _e1307 = abs((bitcast<f32>(_e1213) - _e1076));
                                                    let _e1308 = abs((bitcast<f32>(_e1217) - _e1089));
                                                    let _e1309 = abs((bitcast<f32>(_e1221) - _e1102));
                                                    let _e1313 = abs(((bitcast<f32>(_e1225) + (bitcast<f32>((((_e1237 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1076));
                                                    let _e1314 = abs(((bitcast<f32>(_e1229) + (bitcast<f32>((((_e1237 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1089));
                                                    let _e1315 = abs(((bitcast<f32>(_e1233) + (bitcast<f32>((((_e1237 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1102));
                                                    if (_e1307 > _e1313) {
                                                        phi_1906_ = _e1307;
                                                    } else {
                                                        phi_1906_ = _e1313;
                                                    }
                                                    let _e1318 = phi_1906_;
                                                    if (_e1308 > _e1314) {
                                                        phi_1911_ = _e1308;
                                                    } else {
                                                        phi_1911_ = _e1314;
                                                    }
                                                    let _e1321 = phi_1911_;
                                                    if (_e1309 > _e1315) {
                                                        phi_1916_ = _e1309;
                                                    } else {
                                                        phi_1916_ = _e1315;
                                                    }
                                                    let _e1324 = phi_1916_;
                                                    if (_e1318 > _e1321) {
                                                        phi_1921_ = _e1318;
                                                    } else {
                                                        phi_1921_ = _e1321;
                                                    }
                                                    let _e1327 = phi_1921_;
                                                    if (_e1327 > _e1324) {
                                                        phi_1926_ = _e1327;
                                                    } else {
                                                        phi_1926_ = _e1324;
                                                    }
                                                    let _e1330 = phi_1926_;
                                                    let _e1334 = (_e1330 * 0.0000019073486f);
                                                    let _e1335 = (abs(_e1283) * _e1334);
                                                    let _e1336 = (abs(_e1293) * _e1334);
                                                    let _e1337 = (abs(_e1303) * _e1334);
                                                    let _e1341 = (_e1330 * 0.0000009536743f);
                                                    let _e1342 = (abs(_e1283) * _e1341);
                                                    let _e1343 = (abs(_e1293) * _e1341);
                                                    let _e1344 = (abs(_e1303) * _e1341);
                                                    let _e1345 = abs(_e1120);
                                                    let _e1346 = abs(_e1133);
                                                    let _e1347 = abs(_e1146);
                                                    if (_e1345 >= _e1346) {
                                                        if (_e1345 >= _e1347) {
                                                            phi_1952_ = false;
                                                        } else {
                                                            phi_1952_ = true;
                                                        }
                                                        let _e1351 = phi_1952_;
                                                        phi_1953_ = _e1351;
                                                    } else {
                                                        phi_1953_ = true;
                                                    }
                                                    let _e1353 = phi_1953_;
                                                    if _e1353 {
                                                        if (_e1346 >= _e1347) {
                                                            phi_1961_ = 1u;
                                                        } else {
                                                            phi_1961_ = 2u;
                                                        }
                                                        let _e1356 = phi_1961_;
                                                        phi_1962_ = _e1356;
                                                    } else {
                                                        phi_1962_ = 0u;
                                                    }
                                                    let _e1358 = phi_1962_;
                                                    if (_e1358 == 0u) {
                                                        phi_1974_ = vec3<f32>(_e1133, _e1146, _e1120);
                                                    } else {
                                                        if (_e1358 == 1u) {
                                                            phi_1973_ = vec3<f32>(_e1146, _e1120, _e1133);
                                                        } else {
                                                            phi_1973_ = vec3<f32>(_e1120, _e1133, _e1146);
                                                        }
                                                        let _e1364 = phi_1973_;
                                                        phi_1974_ = _e1364;
                                                    }
                                                    let _e1366 = phi_1974_;
                                                    let _e1369 = (_e1366.x / _e1366.z);
                                                    let _e1372 = (_e1366.y / _e1366.z);
                                                    if (_e1283 < 0f) {
                                                        phi_1987_ = 0u;
                                                    } else {
                                                        phi_1987_ = 1u;
                                                    }
                                                    let _e1377 = phi_1987_;
                                                    if (_e1293 < 0f) {
                                                        phi_1992_ = 0u;
                                                    } else {
                                                        phi_1992_ = 2u;
                                                    }
                                                    let _e1380 = phi_1992_;
                                                    if (_e1303 < 0f) {
                                                        phi_1997_ = 0u;
                                                    } else {
                                                        phi_1997_ = 4u;
                                                    }
                                                    let _e1383 = phi_1997_;
                                                    let _e1385 = ((_e1377 | _e1380) | _e1383);
                                                    let _e1386 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1151, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1386.first[0], _e1386.first[1], _e1386.first[2], _e1386.first[3], _e1386.first[4], _e1386.first[5], _e1386.first[6], _e1386.first[7], _e1386.first[8], _e1386.first[9], _e1386.first[10], _e1386.first[11], _e1386.first[12], _e1386.first[13], _e1386.first[14], _e1386.first[15], _e1386.first[16], _e1386.first[17], _e1386.first[18], _e1386.first[19], _e1386.first[20], _e1386.first[21], _e1386.first[22], _e1386.first[23], _e1386.first[24], _e1386.first[25], _e1386.first[26], _e1386.first[27], _e1386.first[28], _e1386.first[29], _e1386.first[30], _e1386.first[31]), array<u32, 32>(_e1386.mask[0], _e1386.mask[1], _e1386.mask[2], _e1386.mask[3], _e1386.mask[4], _e1386.mask[5], _e1386.mask[6], _e1386.mask[7], _e1386.mask[8], _e1386.mask[9], _e1386.mask[10], _e1386.mask[11], _e1386.mask[12], _e1386.mask[13], _e1386.mask[14], _e1386.mask[15], _e1386.mask[16], _e1386.mask[17], _e1386.mask[18], _e1386.mask[19], _e1386.mask[20], _e1386.mask[21], _e1386.mask[22], _e1386.mask[23], _e1386.mask[24], _e1386.mask[25], _e1386.mask[26], _e1386.mask[27], _e1386.mask[28], _e1386.mask[29], _e1386.mask[30], _e1386.mask[31]), _e1386.len, _e1386.group, _e1386.group_mask);
                                                    let _e1460 = local_1.group_mask;
                                                    if ((_e1460 & 4278190080u) == 0u) {
                                                        let _e1464 = local_1.len;
                                                        if (_e1464 == 0u) {
                                                            phi_2111_ = false;
                                                        } else {
                                                            let _e1468 = local_1.len;
                                                            local_1.len = (_e1468 - 1u);
                                                            let _e1471 = local_1.len;
                                                            if (_e1471 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1476 = local_1.first[(0u + _e1471)];
                                                            local_1.group = _e1476;
                                                            let _e1479 = local_1.len;
                                                            if (_e1479 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1484 = local_1.mask[(0u + _e1479)];
                                                            local_1.group_mask = _e1484;
                                                            phi_2111_ = true;
                                                        }
                                                        let _e1487 = phi_2111_;
                                                        phi_2112_ = _e1487;
                                                    } else {
                                                        phi_2112_ = true;
                                                    }
                                                    let _e1489 = phi_2112_;
                                                    if _e1489 {
                                                        let _e1491 = local_1.group_mask;
                                                        let _e1497 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1491)), 32u, (_e1491 == 0u)));
                                                        let _e1501 = local_1.group_mask;
                                                        let _e1515 = local_1.group_mask;
                                                        local_1.group_mask = (_e1515 & ~((1u << bitcast<u32>((_e1497 & 31u)))));
                                                        let _e1518 = local_1.group;
                                                        phi_2143_ = (_e1518 + countOneBits(((_e1501 & ~((4294967295u << bitcast<u32>((((_e1497 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2143_ = 4294967295u;
                                                    }
                                                    let _e1521 = phi_2143_;
                                                    phi_2145_ = _e984;
                                                    phi_2148_ = _e1521;
                                                    loop {
                                                        let _e1523 = phi_2145_;
                                                        let _e1525 = phi_2148_;
                                                        local_10 = _e1523;
                                                        let _e1526 = (_e1525 != 4294967295u);
                                                        if _e1526 {
                                                            if (_e1525 < _e77) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1533 = nodes.member[(0u + _e1525)].frame[3u];
                                                            let _e1558 = (bitcast<f32>((((_e1533 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1283);
                                                            let _e1559 = (bitcast<f32>((((_e1533 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1293);
                                                            let _e1560 = (bitcast<f32>((((_e1533 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1303);
                                                            let _e1563 = nodes.member[(0u + _e1525)].frame[0u];
                                                            let _e1567 = nodes.member[(0u + _e1525)].frame[1u];
                                                            let _e1571 = nodes.member[(0u + _e1525)].frame[2u];
                                                            let _e1576 = ((bitcast<f32>(_e1563) - _e1076) * _e1283);
                                                            let _e1577 = ((bitcast<f32>(_e1567) - _e1089) * _e1293);
                                                            let _e1578 = ((bitcast<f32>(_e1571) - _e1102) * _e1303);
                                                            let _e1586 = nodes.member[(0u + _e1525)].x;
                                                            if (_e1283 < 0f) {
                                                                let _e1597 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1586.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1603 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1597.unnamed.root, _e1586.w), _e1597.unnamed_1);
                                                                let _e1609 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1603.unnamed, lt_bvh_traverse_Tree(_e1586.x, _e1603.unnamed_1.first_primitive));
                                                                phi_2229_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1609.unnamed, lt_bvh_traverse_Tree(_e1609.unnamed_1.root, _e1586.y));
                                                            } else {
                                                                let _e1625 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1586.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1631 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1625.unnamed.root, _e1586.y), _e1625.unnamed_1);
                                                                let _e1637 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1631.unnamed, lt_bvh_traverse_Tree(_e1586.z, _e1631.unnamed_1.first_primitive));
                                                                phi_2229_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1637.unnamed, lt_bvh_traverse_Tree(_e1637.unnamed_1.root, _e1586.w));
                                                            }
                                                            let _e1645 = phi_2229_;
                                                            let _e1655 = nodes.member[(0u + _e1525)].y;
                                                            if (_e1293 < 0f) {
                                                                let _e1666 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1655.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1672 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1666.unnamed.root, _e1655.w), _e1666.unnamed_1);
                                                                let _e1678 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1672.unnamed, lt_bvh_traverse_Tree(_e1655.x, _e1672.unnamed_1.first_primitive));
                                                                phi_2256_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1678.unnamed, lt_bvh_traverse_Tree(_e1678.unnamed_1.root, _e1655.y));
                                                            } else {
                                                                let _e1694 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1655.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1700 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1694.unnamed.root, _e1655.y), _e1694.unnamed_1);
                                                                let _e1706 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1700.unnamed, lt_bvh_traverse_Tree(_e1655.z, _e1700.unnamed_1.first_primitive));
                                                                phi_2256_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1706.unnamed, lt_bvh_traverse_Tree(_e1706.unnamed_1.root, _e1655.w));
                                                            }
                                                            let _e1714 = phi_2256_;
                                                            let _e1724 = nodes.member[(0u + _e1525)].z;
                                                            if (_e1303 < 0f) {
                                                                let _e1735 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1724.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1741 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1735.unnamed.root, _e1724.w), _e1735.unnamed_1);
                                                                let _e1747 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1741.unnamed, lt_bvh_traverse_Tree(_e1724.x, _e1741.unnamed_1.first_primitive));
                                                                phi_2283_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1747.unnamed, lt_bvh_traverse_Tree(_e1747.unnamed_1.root, _e1724.y));
                                                            } else {
                                                                let _e1763 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1724.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1769 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1763.unnamed.root, _e1724.y), _e1763.unnamed_1);
                                                                let _e1775 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1769.unnamed, lt_bvh_traverse_Tree(_e1724.z, _e1769.unnamed_1.first_primitive));
                                                                phi_2283_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1775.unnamed, lt_bvh_traverse_Tree(_e1775.unnamed_1.root, _e1724.w));
                                                            }
                                                            let _e1783 = phi_2283_;
                                                            phi_2289_ = 0u;
                                                            phi_2292_ = 0u;
                                                            loop {
                                                                let _e1793 = phi_2289_;
                                                                let _e1795 = phi_2292_;
                                                                local_6 = _e1795;
                                                                local_7 = _e1795;
                                                                local_8 = _e1795;
                                                                let _e1796 = (_e1793 < 8u);
                                                                if _e1796 {
                                                                    let _e1798 = (_e1793 >> bitcast<u32>(2i));
                                                                    let _e1799 = (_e1793 & 3u);
                                                                    if (_e1798 == 0u) {
                                                                        phi_2306_ = _e1645.unnamed.root;
                                                                    } else {
                                                                        phi_2306_ = _e1645.unnamed.first_primitive;
                                                                    }
                                                                    let _e1802 = phi_2306_;
                                                                    if (_e1798 == 0u) {
                                                                        phi_2316_ = _e1714.unnamed.root;
                                                                    } else {
                                                                        phi_2316_ = _e1714.unnamed.first_primitive;
                                                                    }
                                                                    let _e1811 = phi_2316_;
                                                                    if (_e1798 == 0u) {
                                                                        phi_2326_ = _e1783.unnamed.root;
                                                                    } else {
                                                                        phi_2326_ = _e1783.unnamed.first_primitive;
                                                                    }
                                                                    let _e1820 = phi_2326_;
                                                                    let _e1833 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1802 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1558) + (_e1576 - _e1335)), ((f32(((_e1811 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1559) + (_e1577 - _e1336)));
                                                                    let _e1834 = core_intrinsics_maximum_number_nsz_f32_(_e1833, ((f32(((_e1820 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1560) + (_e1578 - _e1337)));
                                                                    if (_e1798 == 0u) {
                                                                        phi_2344_ = _e1645.unnamed_1.root;
                                                                    } else {
                                                                        phi_2344_ = _e1645.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1837 = phi_2344_;
                                                                    if (_e1798 == 0u) {
                                                                        phi_2354_ = _e1714.unnamed_1.root;
                                                                    } else {
                                                                        phi_2354_ = _e1714.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1846 = phi_2354_;
                                                                    if (_e1798 == 0u) {
                                                                        phi_2364_ = _e1783.unnamed_1.root;
                                                                    } else {
                                                                        phi_2364_ = _e1783.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1855 = phi_2364_;
                                                                    let _e1868 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1837 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1558) + (_e1576 + _e1335)), ((f32(((_e1846 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1559) + (_e1577 + _e1336)));
                                                                    let _e1869 = core_intrinsics_minimum_number_nsz_f32_(_e1868, ((f32(((_e1855 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u)) * _e1560) + (_e1578 + _e1337)));
                                                                    if (_e1834 <= _e1869) {
                                                                        if (_e1834 <= _e1523.t) {
                                                                            if (_e1869 >= _e175.tmin) {
                                                                                if (_e1798 == 0u) {
                                                                                    let _e1876 = nodes.member[(0u + _e1525)].links[2u];
                                                                                    phi_2400_ = _e1876;
                                                                                } else {
                                                                                    let _e1879 = nodes.member[(0u + _e1525)].links[3u];
                                                                                    phi_2400_ = _e1879;
                                                                                }
                                                                                let _e1881 = phi_2400_;
                                                                                let _e1886 = ((_e1881 >> bitcast<u32>(((_e1799 * 8u) & 31u))) & 255u);
                                                                                let _e1887 = (_e1886 & 31u);
                                                                                if (_e1887 >= 24u) {
                                                                                    phi_2413_ = (24u + ((_e1887 - 24u) ^ _e1385));
                                                                                } else {
                                                                                    phi_2413_ = _e1887;
                                                                                }
                                                                                let _e1893 = phi_2413_;
                                                                                phi_2418_ = (_e1795 | ((_e1886 >> bitcast<u32>(5i)) << bitcast<u32>((_e1893 & 31u))));
                                                                            } else {
                                                                                phi_2418_ = _e1795;
                                                                            }
                                                                            let _e1901 = phi_2418_;
                                                                            phi_2419_ = _e1901;
                                                                        } else {
                                                                            phi_2419_ = _e1795;
                                                                        }
                                                                        let _e1903 = phi_2419_;
                                                                        phi_2420_ = _e1903;
                                                                    } else {
                                                                        phi_2420_ = _e1795;
                                                                    }
                                                                    let _e1905 = phi_2420_;
                                                                    phi_2290_ = (_e1793 + 1u);
                                                                    phi_2293_ = _e1905;
                                                                } else {
                                                                    phi_2290_ = u32();
                                                                    phi_2293_ = u32();
                                                                }
                                                                let _e1908 = phi_2290_;
                                                                let _e1910 = phi_2293_;
                                                                continue;
                                                                continuing {
                                                                    phi_2289_ = _e1908;
                                                                    phi_2292_ = _e1910;
                                                                    break if !(_e1796);
                                                                }
                                                            }
                                                            let _e1914 = nodes.member[(0u + _e1525)].links[0u];
                                                            let _e1918 = nodes.member[(0u + _e1525)].frame[3u];
                                                            let _e1922 = local_6;
                                                            if ((_e1922 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1926 = local_1.group_mask;
                                                                if ((_e1926 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1930 = local_1.len;
                                                                    if (_e1930 < 32u) {
                                                                        let _e1933 = local_1.group;
                                                                        let _e1935 = local_1.len;
                                                                        if (_e1935 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.first[(0u + _e1935)] = _e1933;
                                                                        let _e1941 = local_1.group_mask;
                                                                        let _e1943 = local_1.len;
                                                                        if (_e1943 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.mask[(0u + _e1943)] = _e1941;
                                                                        let _e1950 = local_1.len;
                                                                        local_1.len = (_e1950 + 1u);
                                                                    }
                                                                }
                                                                local_1.group = (_e1151 + _e1914);
                                                                let _e1954 = local_7;
                                                                local_1.group_mask = ((_e1954 & 4278190080u) | (_e1918 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1959 = local_8;
                                                            phi_2478_ = _e1523;
                                                            phi_2481_ = (_e1959 & 16777215u);
                                                            loop {
                                                                let _e1962 = phi_2478_;
                                                                let _e1964 = phi_2481_;
                                                                local_9 = _e1962;
                                                                if (_e1964 == 0u) {
                                                                    phi_2479_ = lt_bvh_Hit();
                                                                    phi_2482_ = u32();
                                                                    phi_3123_ = false;
                                                                } else {
                                                                    let _e1968 = nodes.member[(0u + _e1525)].links[1u];
                                                                    let _e1973 = ((_e1153 + _e1968) + select(firstTrailingBit(_e1964), 32u, (_e1964 == 0u)));
                                                                    if (_e1973 < _e80) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1980 = triangles.member[(0u + _e1973)].v0_;
                                                                    let _e1982 = (_e1980.x - _e1076);
                                                                    let _e1984 = (_e1980.y - _e1089);
                                                                    let _e1986 = (_e1980.z - _e1102);
                                                                    if (_e1358 == 0u) {
                                                                        phi_2526_ = vec3<f32>(_e1984, _e1986, _e1982);
                                                                    } else {
                                                                        if (_e1358 == 1u) {
                                                                            phi_2525_ = vec3<f32>(_e1986, _e1982, _e1984);
                                                                        } else {
                                                                            phi_2525_ = (_e1980 - vec3<f32>(_e1076, _e1089, _e1102));
                                                                        }
                                                                        let _e1994 = phi_2525_;
                                                                        phi_2526_ = _e1994;
                                                                    }
                                                                    let _e1996 = phi_2526_;
                                                                    let _e2000 = (_e1996.x - (_e1369 * _e1996.z));
                                                                    let _e2004 = (_e1996.y - (_e1372 * _e1996.z));
                                                                    let _e2006 = triangles.member[(0u + _e1973)].v1_;
                                                                    let _e2008 = (_e2006.x - _e1076);
                                                                    let _e2010 = (_e2006.y - _e1089);
                                                                    let _e2012 = (_e2006.z - _e1102);
                                                                    if (_e1358 == 0u) {
                                                                        phi_2556_ = vec3<f32>(_e2010, _e2012, _e2008);
                                                                    } else {
                                                                        if (_e1358 == 1u) {
                                                                            phi_2555_ = vec3<f32>(_e2012, _e2008, _e2010);
                                                                        } else {
                                                                            phi_2555_ = (_e2006 - vec3<f32>(_e1076, _e1089, _e1102));
                                                                        }
                                                                        let _e2020 = phi_2555_;
                                                                        phi_2556_ = _e2020;
                                                                    }
                                                                    let _e2022 = phi_2556_;
                                                                    let _e2026 = (_e2022.x - (_e1369 * _e2022.z));
                                                                    let _e2030 = (_e2022.y - (_e1372 * _e2022.z));
                                                                    let _e2032 = triangles.member[(0u + _e1973)].v2_;
                                                                    let _e2034 = (_e2032.x - _e1076);
                                                                    let _e2036 = (_e2032.y - _e1089);
                                                                    let _e2038 = (_e2032.z - _e1102);
                                                                    if (_e1358 == 0u) {
                                                                        phi_2586_ = vec3<f32>(_e2036, _e2038, _e2034);
                                                                    } else {
                                                                        if (_e1358 == 1u) {
                                                                            phi_2585_ = vec3<f32>(_e2038, _e2034, _e2036);
                                                                        } else {
                                                                            phi_2585_ = (_e2032 - vec3<f32>(_e1076, _e1089, _e1102));
                                                                        }
                                                                        let _e2046 = phi_2585_;
                                                                        phi_2586_ = _e2046;
                                                                    }
                                                                    let _e2048 = phi_2586_;
                                                                    let _e2052 = (_e2048.x - (_e1369 * _e2048.z));
                                                                    let _e2056 = (_e2048.y - (_e1372 * _e2048.z));
                                                                    if (_e2026 < _e2052) {
                                                                        phi_2605_ = true;
                                                                    } else {
                                                                        if (_e2026 == _e2052) {
                                                                            phi_2604_ = (_e2030 < _e2056);
                                                                        } else {
                                                                            phi_2604_ = false;
                                                                        }
                                                                        let _e2061 = phi_2604_;
                                                                        phi_2605_ = _e2061;
                                                                    }
                                                                    let _e2063 = phi_2605_;
                                                                    if _e2063 {
                                                                        phi_2609_ = _e2056;
                                                                        phi_2610_ = _e2052;
                                                                        phi_2611_ = _e2030;
                                                                        phi_2612_ = _e2026;
                                                                    } else {
                                                                        phi_2609_ = _e2030;
                                                                        phi_2610_ = _e2026;
                                                                        phi_2611_ = _e2056;
                                                                        phi_2612_ = _e2052;
                                                                    }
                                                                    let _e2065 = phi_2609_;
                                                                    let _e2067 = phi_2610_;
                                                                    let _e2069 = phi_2611_;
                                                                    let _e2071 = phi_2612_;
                                                                    let _e2074 = ((_e2071 * _e2065) - (_e2069 * _e2067));
                                                                    if _e2063 {
                                                                        phi_2620_ = -(_e2074);
                                                                    } else {
                                                                        phi_2620_ = _e2074;
                                                                    }
                                                                    let _e2077 = phi_2620_;
                                                                    if (_e2052 < _e2000) {
                                                                        phi_2631_ = true;
                                                                    } else {
                                                                        if (_e2052 == _e2000) {
                                                                            phi_2630_ = (_e2056 < _e2004);
                                                                        } else {
                                                                            phi_2630_ = false;
                                                                        }
                                                                        let _e2082 = phi_2630_;
                                                                        phi_2631_ = _e2082;
                                                                    }
                                                                    let _e2084 = phi_2631_;
                                                                    if _e2084 {
                                                                        phi_2635_ = _e2004;
                                                                        phi_2636_ = _e2000;
                                                                        phi_2637_ = _e2056;
                                                                        phi_2638_ = _e2052;
                                                                    } else {
                                                                        phi_2635_ = _e2056;
                                                                        phi_2636_ = _e2052;
                                                                        phi_2637_ = _e2004;
                                                                        phi_2638_ = _e2000;
                                                                    }
                                                                    let _e2086 = phi_2635_;
                                                                    let _e2088 = phi_2636_;
                                                                    let _e2090 = phi_2637_;
                                                                    let _e2092 = phi_2638_;
                                                                    let _e2095 = ((_e2092 * _e2086) - (_e2090 * _e2088));
                                                                    if _e2084 {
                                                                        phi_2646_ = -(_e2095);
                                                                    } else {
                                                                        phi_2646_ = _e2095;
                                                                    }
                                                                    let _e2098 = phi_2646_;
                                                                    if (_e2000 < _e2026) {
                                                                        phi_2657_ = true;
                                                                    } else {
                                                                        if (_e2000 == _e2026) {
                                                                            phi_2656_ = (_e2004 < _e2030);
                                                                        } else {
                                                                            phi_2656_ = false;
                                                                        }
                                                                        let _e2103 = phi_2656_;
                                                                        phi_2657_ = _e2103;
                                                                    }
                                                                    let _e2105 = phi_2657_;
                                                                    if _e2105 {
                                                                        phi_2661_ = _e2030;
                                                                        phi_2662_ = _e2026;
                                                                        phi_2663_ = _e2004;
                                                                        phi_2664_ = _e2000;
                                                                    } else {
                                                                        phi_2661_ = _e2004;
                                                                        phi_2662_ = _e2000;
                                                                        phi_2663_ = _e2030;
                                                                        phi_2664_ = _e2026;
                                                                    }
                                                                    let _e2107 = phi_2661_;
                                                                    let _e2109 = phi_2662_;
                                                                    let _e2111 = phi_2663_;
                                                                    let _e2113 = phi_2664_;
                                                                    let _e2116 = ((_e2113 * _e2107) - (_e2111 * _e2109));
                                                                    if _e2105 {
                                                                        phi_2672_ = -(_e2116);
                                                                    } else {
                                                                        phi_2672_ = _e2116;
                                                                    }
                                                                    let _e2119 = phi_2672_;
                                                                    if (_e2077 >= 0f) {
                                                                        if (_e2098 >= 0f) {
                                                                            if (_e2119 >= 0f) {
                                                                                phi_2687_ = ((_e2077 + _e2098) + _e2119);
                                                                                phi_2688_ = false;
                                                                            } else {
                                                                                phi_2687_ = f32();
                                                                                phi_2688_ = true;
                                                                            }
                                                                            let _e2126 = phi_2687_;
                                                                            let _e2128 = phi_2688_;
                                                                            phi_2689_ = _e2126;
                                                                            phi_2690_ = _e2128;
                                                                        } else {
                                                                            phi_2689_ = f32();
                                                                            phi_2690_ = true;
                                                                        }
                                                                        let _e2130 = phi_2689_;
                                                                        let _e2132 = phi_2690_;
                                                                        phi_2691_ = _e2130;
                                                                        phi_2692_ = _e2132;
                                                                    } else {
                                                                        phi_2691_ = f32();
                                                                        phi_2692_ = true;
                                                                    }
                                                                    let _e2134 = phi_2691_;
                                                                    let _e2136 = phi_2692_;
                                                                    if _e2136 {
                                                                        if (_e2077 <= 0f) {
                                                                            if (_e2098 <= 0f) {
                                                                                let _e2139 = (_e2119 <= 0f);
                                                                                if _e2139 {
                                                                                }
                                                                                phi_2710_ = ((_e2077 + _e2098) + _e2119);
                                                                                phi_2711_ = false;
                                                                                phi_2712_ = _e2139;
                                                                            } else {
                                                                                phi_2710_ = f32();
                                                                                phi_2711_ = true;
                                                                                phi_2712_ = false;
                                                                            }
                                                                            let _e2143 = phi_2710_;
                                                                            let _e2145 = phi_2711_;
                                                                            let _e2147 = phi_2712_;
                                                                            phi_2713_ = _e2143;
                                                                            phi_2714_ = _e2145;
                                                                            phi_2715_ = _e2147;
                                                                        } else {
                                                                            phi_2713_ = f32();
                                                                            phi_2714_ = true;
                                                                            phi_2715_ = false;
                                                                        }
                                                                        let _e2149 = phi_2713_;
                                                                        let _e2151 = phi_2714_;
                                                                        let _e2153 = phi_2715_;
                                                                        if _e2151 {
                                                                            phi_2719_ = false;
                                                                        } else {
                                                                            phi_2719_ = _e2153;
                                                                        }
                                                                        let _e2155 = phi_2719_;
                                                                        phi_2720_ = _e2149;
                                                                        phi_2721_ = _e2155;
                                                                    } else {
                                                                        phi_2720_ = _e2134;
                                                                        phi_2721_ = true;
                                                                    }
                                                                    let _e2157 = phi_2720_;
                                                                    let _e2159 = phi_2721_;
                                                                    if _e2159 {
                                                                        let _e2160 = (_e2157 == 0f);
                                                                        if _e2160 {
                                                                            phi_3037_ = lt_bvh_triangle_Intersection();
                                                                            phi_3038_ = false;
                                                                        } else {
                                                                            let _e2162 = triangles.member[(0u + _e1973)].v0_;
                                                                            let _e2164 = (_e2162.x - _e1076);
                                                                            let _e2166 = (_e2162.y - _e1089);
                                                                            let _e2168 = (_e2162.z - _e1102);
                                                                            if (_e1358 == 0u) {
                                                                                phi_2750_ = vec3<f32>(_e2166, _e2168, _e2164);
                                                                            } else {
                                                                                if (_e1358 == 1u) {
                                                                                    phi_2749_ = vec3<f32>(_e2168, _e2164, _e2166);
                                                                                } else {
                                                                                    phi_2749_ = (_e2162 - vec3<f32>(_e1076, _e1089, _e1102));
                                                                                }
                                                                                let _e2176 = phi_2749_;
                                                                                phi_2750_ = _e2176;
                                                                            }
                                                                            let _e2178 = phi_2750_;
                                                                            let _e2180 = triangles.member[(0u + _e1973)].v1_;
                                                                            let _e2182 = triangles.member[(0u + _e1973)].v0_;
                                                                            let _e2185 = (_e2180.x - _e2182.x);
                                                                            let _e2188 = (_e2180.y - _e2182.y);
                                                                            let _e2191 = (_e2180.z - _e2182.z);
                                                                            if (_e1358 == 0u) {
                                                                                phi_2776_ = vec3<f32>(_e2188, _e2191, _e2185);
                                                                            } else {
                                                                                if (_e1358 == 1u) {
                                                                                    phi_2775_ = vec3<f32>(_e2191, _e2185, _e2188);
                                                                                } else {
                                                                                    phi_2775_ = (_e2180 - _e2182);
                                                                                }
                                                                                let _e2198 = phi_2775_;
                                                                                phi_2776_ = _e2198;
                                                                            }
                                                                            let _e2200 = phi_2776_;
                                                                            let _e2202 = triangles.member[(0u + _e1973)].v2_;
                                                                            let _e2204 = triangles.member[(0u + _e1973)].v0_;
                                                                            let _e2207 = (_e2202.x - _e2204.x);
                                                                            let _e2210 = (_e2202.y - _e2204.y);
                                                                            let _e2213 = (_e2202.z - _e2204.z);
                                                                            if (_e1358 == 0u) {
                                                                                phi_2802_ = vec3<f32>(_e2210, _e2213, _e2207);
                                                                            } else {
                                                                                if (_e1358 == 1u) {
                                                                                    phi_2801_ = vec3<f32>(_e2213, _e2207, _e2210);
                                                                                } else {
                                                                                    phi_2801_ = (_e2202 - _e2204);
                                                                                }
                                                                                let _e2220 = phi_2801_;
                                                                                phi_2802_ = _e2220;
                                                                            }
                                                                            let _e2222 = phi_2802_;
                                                                            let _e2229 = ((_e2200.y * _e2222.z) - (_e2200.z * _e2222.y));
                                                                            let _e2236 = ((_e2200.z * _e2222.x) - (_e2200.x * _e2222.z));
                                                                            let _e2243 = ((_e2200.x * _e2222.y) - (_e2200.y * _e2222.x));
                                                                            let _e2257 = (((1f / _e1366.z) * (((_e2229 * _e2178.x) + (_e2236 * _e2178.y)) + (_e2243 * _e2178.z))) / (((_e2229 * _e1369) + (_e2236 * _e1372)) + _e2243));
                                                                            if (_e2257 > _e175.tmin) {
                                                                                if (_e2257 < _e175.tmax) {
                                                                                    let _e2261 = triangles.member[(0u + _e1973)].v0_;
                                                                                    let _e2263 = triangles.member[(0u + _e1973)].v1_;
                                                                                    if (_e2261.x < _e2263.x) {
                                                                                        phi_2858_ = _e2261.x;
                                                                                    } else {
                                                                                        phi_2858_ = _e2263.x;
                                                                                    }
                                                                                    let _e2270 = phi_2858_;
                                                                                    if (_e2261.y < _e2263.y) {
                                                                                        phi_2867_ = _e2261.y;
                                                                                    } else {
                                                                                        phi_2867_ = _e2263.y;
                                                                                    }
                                                                                    let _e2277 = phi_2867_;
                                                                                    if (_e2261.z < _e2263.z) {
                                                                                        phi_2876_ = _e2261.z;
                                                                                    } else {
                                                                                        phi_2876_ = _e2263.z;
                                                                                    }
                                                                                    let _e2284 = phi_2876_;
                                                                                    let _e2286 = triangles.member[(0u + _e1973)].v2_;
                                                                                    if (_e2270 < _e2286.x) {
                                                                                        phi_2885_ = _e2270;
                                                                                    } else {
                                                                                        phi_2885_ = _e2286.x;
                                                                                    }
                                                                                    let _e2291 = phi_2885_;
                                                                                    if (_e2277 < _e2286.y) {
                                                                                        phi_2892_ = _e2277;
                                                                                    } else {
                                                                                        phi_2892_ = _e2286.y;
                                                                                    }
                                                                                    let _e2296 = phi_2892_;
                                                                                    if (_e2284 < _e2286.z) {
                                                                                        phi_2899_ = _e2284;
                                                                                    } else {
                                                                                        phi_2899_ = _e2286.z;
                                                                                    }
                                                                                    let _e2301 = phi_2899_;
                                                                                    let _e2303 = triangles.member[(0u + _e1973)].v0_;
                                                                                    let _e2305 = triangles.member[(0u + _e1973)].v1_;
                                                                                    if (_e2303.x > _e2305.x) {
                                                                                        phi_2912_ = _e2303.x;
                                                                                    } else {
                                                                                        phi_2912_ = _e2305.x;
                                                                                    }
                                                                                    let _e2312 = phi_2912_;
                                                                                    if (_e2303.y > _e2305.y) {
                                                                                        phi_2921_ = _e2303.y;
                                                                                    } else {
                                                                                        phi_2921_ = _e2305.y;
                                                                                    }
                                                                                    let _e2319 = phi_2921_;
                                                                                    if (_e2303.z > _e2305.z) {
                                                                                        phi_2930_ = _e2303.z;
                                                                                    } else {
                                                                                        phi_2930_ = _e2305.z;
                                                                                    }
                                                                                    let _e2326 = phi_2930_;
                                                                                    let _e2328 = triangles.member[(0u + _e1973)].v2_;
                                                                                    if (_e2312 > _e2328.x) {
                                                                                        phi_2939_ = _e2312;
                                                                                    } else {
                                                                                        phi_2939_ = _e2328.x;
                                                                                    }
                                                                                    let _e2333 = phi_2939_;
                                                                                    if (_e2319 > _e2328.y) {
                                                                                        phi_2946_ = _e2319;
                                                                                    } else {
                                                                                        phi_2946_ = _e2328.y;
                                                                                    }
                                                                                    let _e2338 = phi_2946_;
                                                                                    if (_e2326 > _e2328.z) {
                                                                                        phi_2953_ = _e2326;
                                                                                    } else {
                                                                                        phi_2953_ = _e2328.z;
                                                                                    }
                                                                                    let _e2343 = phi_2953_;
                                                                                    let _e2347 = ((_e2291 - _e1076) * _e1283);
                                                                                    let _e2348 = ((_e2296 - _e1089) * _e1293);
                                                                                    let _e2349 = ((_e2301 - _e1102) * _e1303);
                                                                                    let _e2353 = ((_e2333 - _e1076) * _e1283);
                                                                                    let _e2354 = ((_e2338 - _e1089) * _e1293);
                                                                                    let _e2355 = ((_e2343 - _e1102) * _e1303);
                                                                                    if (_e2347 < _e2353) {
                                                                                        phi_2970_ = _e2347;
                                                                                    } else {
                                                                                        phi_2970_ = _e2353;
                                                                                    }
                                                                                    let _e2358 = phi_2970_;
                                                                                    if (_e2348 < _e2354) {
                                                                                        phi_2975_ = _e2348;
                                                                                    } else {
                                                                                        phi_2975_ = _e2354;
                                                                                    }
                                                                                    let _e2361 = phi_2975_;
                                                                                    if (_e2349 < _e2355) {
                                                                                        phi_2980_ = _e2349;
                                                                                    } else {
                                                                                        phi_2980_ = _e2355;
                                                                                    }
                                                                                    let _e2364 = phi_2980_;
                                                                                    if (_e2347 > _e2353) {
                                                                                        phi_2988_ = _e2347;
                                                                                    } else {
                                                                                        phi_2988_ = _e2353;
                                                                                    }
                                                                                    let _e2370 = phi_2988_;
                                                                                    if (_e2348 > _e2354) {
                                                                                        phi_2993_ = _e2348;
                                                                                    } else {
                                                                                        phi_2993_ = _e2354;
                                                                                    }
                                                                                    let _e2373 = phi_2993_;
                                                                                    if (_e2349 > _e2355) {
                                                                                        phi_2998_ = _e2349;
                                                                                    } else {
                                                                                        phi_2998_ = _e2355;
                                                                                    }
                                                                                    let _e2376 = phi_2998_;
                                                                                    let _e2380 = core_intrinsics_maximum_number_nsz_f32_((_e2358 - _e1342), (_e2361 - _e1343));
                                                                                    let _e2381 = core_intrinsics_maximum_number_nsz_f32_(_e2380, (_e2364 - _e1344));
                                                                                    let _e2382 = core_intrinsics_minimum_number_nsz_f32_((_e2370 + _e1342), (_e2373 + _e1343));
                                                                                    let _e2383 = core_intrinsics_minimum_number_nsz_f32_(_e2382, (_e2376 + _e1344));
                                                                                    if (_e2381 > _e1051) {
                                                                                        phi_3010_ = _e2381;
                                                                                    } else {
                                                                                        phi_3010_ = _e1051;
                                                                                    }
                                                                                    let _e2386 = phi_3010_;
                                                                                    if (_e2383 < _e1053) {
                                                                                        phi_3015_ = _e2383;
                                                                                    } else {
                                                                                        phi_3015_ = _e1053;
                                                                                    }
                                                                                    let _e2389 = phi_3015_;
                                                                                    if (_e2257 < _e2386) {
                                                                                        phi_3020_ = _e2386;
                                                                                    } else {
                                                                                        phi_3020_ = _e2257;
                                                                                    }
                                                                                    let _e2392 = phi_3020_;
                                                                                    if (_e2392 > _e2389) {
                                                                                        phi_3025_ = _e2389;
                                                                                    } else {
                                                                                        phi_3025_ = _e2392;
                                                                                    }
                                                                                    let _e2395 = phi_3025_;
                                                                                    phi_3030_ = lt_bvh_triangle_Intersection(_e2395, (_e2098 / _e2157), (_e2119 / _e2157), (_e2386 <= _e2389));
                                                                                    phi_3031_ = false;
                                                                                } else {
                                                                                    phi_3030_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3031_ = true;
                                                                                }
                                                                                let _e2401 = phi_3030_;
                                                                                let _e2403 = phi_3031_;
                                                                                phi_3032_ = _e2401;
                                                                                phi_3033_ = _e2403;
                                                                            } else {
                                                                                phi_3032_ = lt_bvh_triangle_Intersection();
                                                                                phi_3033_ = true;
                                                                            }
                                                                            let _e2405 = phi_3032_;
                                                                            let _e2407 = phi_3033_;
                                                                            if _e2407 {
                                                                            }
                                                                            phi_3037_ = _e2405;
                                                                            phi_3038_ = _e2407;
                                                                        }
                                                                        let _e2409 = phi_3037_;
                                                                        let _e2411 = phi_3038_;
                                                                        phi_3039_ = _e2409;
                                                                        phi_3040_ = _e2160;
                                                                        phi_3041_ = _e2411;
                                                                    } else {
                                                                        phi_3039_ = lt_bvh_triangle_Intersection();
                                                                        phi_3040_ = true;
                                                                        phi_3041_ = false;
                                                                    }
                                                                    let _e2413 = phi_3039_;
                                                                    let _e2415 = phi_3040_;
                                                                    let _e2417 = phi_3041_;
                                                                    if _e2415 {
                                                                        phi_3045_ = true;
                                                                    } else {
                                                                        phi_3045_ = _e2417;
                                                                    }
                                                                    let _e2419 = phi_3045_;
                                                                    if _e2419 {
                                                                        phi_3049_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_3049_ = _e2413;
                                                                    }
                                                                    let _e2421 = phi_3049_;
                                                                    if _e2421.is_hit {
                                                                        if (_e2421.t > _e175.tmin) {
                                                                            if (_e2421.t < _e1962.t) {
                                                                                phi_3097_ = true;
                                                                            } else {
                                                                                if (_e2421.t == _e1962.t) {
                                                                                    if (_e1962.triangle != 4294967295u) {
                                                                                        if (_e1973 < _e1962.triangle) {
                                                                                            phi_3088_ = true;
                                                                                        } else {
                                                                                            if (_e1973 == _e1962.triangle) {
                                                                                                phi_3087_ = (_e992 < _e1962.instance);
                                                                                            } else {
                                                                                                phi_3087_ = false;
                                                                                            }
                                                                                            let _e2439 = phi_3087_;
                                                                                            phi_3088_ = _e2439;
                                                                                        }
                                                                                        let _e2441 = phi_3088_;
                                                                                        phi_3089_ = _e2441;
                                                                                        phi_3090_ = false;
                                                                                    } else {
                                                                                        phi_3089_ = bool();
                                                                                        phi_3090_ = true;
                                                                                    }
                                                                                    let _e2443 = phi_3089_;
                                                                                    let _e2445 = phi_3090_;
                                                                                    phi_3091_ = _e2443;
                                                                                    phi_3092_ = _e2445;
                                                                                } else {
                                                                                    phi_3091_ = bool();
                                                                                    phi_3092_ = true;
                                                                                }
                                                                                let _e2447 = phi_3091_;
                                                                                let _e2449 = phi_3092_;
                                                                                if _e2449 {
                                                                                    phi_3096_ = false;
                                                                                } else {
                                                                                    phi_3096_ = _e2447;
                                                                                }
                                                                                let _e2451 = phi_3096_;
                                                                                phi_3097_ = _e2451;
                                                                            }
                                                                            let _e2453 = phi_3097_;
                                                                            if _e2453 {
                                                                                let _e2455 = triangles.member[(0u + _e1973)].i0_;
                                                                                if ((_e2455 & 2147483648u) == 0u) {
                                                                                    phi_3111_ = true;
                                                                                } else {
                                                                                    if true {
                                                                                    }
                                                                                    phi_3111_ = true;
                                                                                }
                                                                                let _e2459 = phi_3111_;
                                                                                if _e2459 {
                                                                                    phi_3119_ = lt_bvh_Hit(_e2421.t, _e2421.u, _e2421.v, _e1973, _e992);
                                                                                } else {
                                                                                    phi_3119_ = _e1962;
                                                                                }
                                                                                let _e2465 = phi_3119_;
                                                                                phi_3120_ = _e2465;
                                                                            } else {
                                                                                phi_3120_ = _e1962;
                                                                            }
                                                                            let _e2467 = phi_3120_;
                                                                            phi_3121_ = _e2467;
                                                                        } else {
                                                                            phi_3121_ = _e1962;
                                                                        }
                                                                        let _e2469 = phi_3121_;
                                                                        phi_3122_ = _e2469;
                                                                    } else {
                                                                        phi_3122_ = _e1962;
                                                                    }
                                                                    let _e2471 = phi_3122_;
                                                                    phi_2479_ = _e2471;
                                                                    phi_2482_ = (_e1964 & (_e1964 - 1u));
                                                                    phi_3123_ = true;
                                                                }
                                                                let _e2473 = phi_2479_;
                                                                let _e2475 = phi_2482_;
                                                                let _e2477 = phi_3123_;
                                                                continue;
                                                                continuing {
                                                                    phi_2478_ = _e2473;
                                                                    phi_2481_ = _e2475;
                                                                    break if !(_e2477);
                                                                }
                                                            }
                                                            let _e2480 = local_1.group_mask;
                                                            if ((_e2480 & 4278190080u) == 0u) {
                                                                let _e2484 = local_1.len;
                                                                if (_e2484 == 0u) {
                                                                    phi_3162_ = false;
                                                                } else {
                                                                    let _e2488 = local_1.len;
                                                                    local_1.len = (_e2488 - 1u);
                                                                    let _e2491 = local_1.len;
                                                                    if (_e2491 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2496 = local_1.first[(0u + _e2491)];
                                                                    local_1.group = _e2496;
                                                                    let _e2499 = local_1.len;
                                                                    if (_e2499 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2504 = local_1.mask[(0u + _e2499)];
                                                                    local_1.group_mask = _e2504;
                                                                    phi_3162_ = true;
                                                                }
                                                                let _e2507 = phi_3162_;
                                                                phi_3163_ = _e2507;
                                                            } else {
                                                                phi_3163_ = true;
                                                            }
                                                            let _e2509 = phi_3163_;
                                                            if _e2509 {
                                                                let _e2511 = local_1.group_mask;
                                                                let _e2517 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2511)), 32u, (_e2511 == 0u)));
                                                                let _e2521 = local_1.group_mask;
                                                                let _e2535 = local_1.group_mask;
                                                                local_1.group_mask = (_e2535 & ~((1u << bitcast<u32>((_e2517 & 31u)))));
                                                                let _e2538 = local_1.group;
                                                                phi_3194_ = (_e2538 + countOneBits(((_e2521 & ~((4294967295u << bitcast<u32>((((_e2517 - 24u) ^ _e1385) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3194_ = 4294967295u;
                                                            }
                                                            let _e2541 = phi_3194_;
                                                            let _e3667 = local_9;
                                                            phi_2146_ = _e3667;
                                                            phi_2149_ = _e2541;
                                                        } else {
                                                            phi_2146_ = lt_bvh_Hit();
                                                            phi_2149_ = u32();
                                                        }
                                                        let _e2543 = phi_2146_;
                                                        let _e2545 = phi_2149_;
                                                        continue;
                                                        continuing {
                                                            phi_2145_ = _e2543;
                                                            phi_2148_ = _e2545;
                                                            break if !(_e1526);
                                                        }
                                                    }
                                                    let _e3671 = local_10;
                                                    phi_3195_ = _e3671;
                                                }
                                                let _e2548 = phi_3195_;
                                                phi_3196_ = _e2548;
                                                phi_3197_ = _e1207;
                                            } else {
                                                phi_3196_ = lt_bvh_Hit();
                                                phi_3197_ = true;
                                            }
                                            let _e2550 = phi_3196_;
                                            let _e2552 = phi_3197_;
                                            if _e2552 {
                                                phi_3201_ = _e984;
                                            } else {
                                                phi_3201_ = _e2550;
                                            }
                                            let _e2554 = phi_3201_;
                                            phi_3202_ = _e2554;
                                        } else {
                                            phi_3202_ = _e984;
                                        }
                                        let _e2556 = phi_3202_;
                                        phi_3203_ = _e2556;
                                    } else {
                                        phi_3203_ = _e984;
                                    }
                                    let _e2558 = phi_3203_;
                                    phi_3204_ = _e2558;
                                } else {
                                    phi_3204_ = _e984;
                                }
                                let _e2560 = phi_3204_;
                                phi_1513_ = (_e982 & (_e982 - 1u));
                                phi_1516_ = _e2560;
                                phi_3205_ = true;
                            }
                            let _e2562 = phi_1513_;
                            let _e2564 = phi_1516_;
                            let _e2566 = phi_3205_;
                            continue;
                            continuing {
                                phi_1512_ = _e2562;
                                phi_1515_ = _e2564;
                                break if !(_e2566);
                            }
                        }
                        let _e2569 = local_2.group_mask;
                        if ((_e2569 & 4278190080u) == 0u) {
                            let _e2573 = local_2.len;
                            if (_e2573 == 0u) {
                                phi_3244_ = false;
                            } else {
                                let _e2577 = local_2.len;
                                local_2.len = (_e2577 - 1u);
                                let _e2580 = local_2.len;
                                if (_e2580 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2585 = local_2.first[(0u + _e2580)];
                                local_2.group = _e2585;
                                let _e2588 = local_2.len;
                                if (_e2588 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2593 = local_2.mask[(0u + _e2588)];
                                local_2.group_mask = _e2593;
                                phi_3244_ = true;
                            }
                            let _e2596 = phi_3244_;
                            phi_3245_ = _e2596;
                        } else {
                            phi_3245_ = true;
                        }
                        let _e2598 = phi_3245_;
                        if _e2598 {
                            let _e2600 = local_2.group_mask;
                            let _e2606 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2600)), 32u, (_e2600 == 0u)));
                            let _e2610 = local_2.group_mask;
                            let _e2624 = local_2.group_mask;
                            local_2.group_mask = (_e2624 & ~((1u << bitcast<u32>((_e2606 & 31u)))));
                            let _e2627 = local_2.group;
                            phi_3276_ = (_e2627 + countOneBits(((_e2610 & ~((4294967295u << bitcast<u32>((((_e2606 - 24u) ^ _e401) & 31u))))) & 255u)));
                        } else {
                            phi_3276_ = 4294967295u;
                        }
                        let _e2630 = phi_3276_;
                        phi_1176_ = _e2630;
                        let _e3687 = local_11;
                        phi_1179_ = _e3687;
                    } else {
                        phi_1176_ = u32();
                        phi_1179_ = lt_bvh_Hit();
                    }
                    let _e2632 = phi_1176_;
                    let _e2634 = phi_1179_;
                    continue;
                    continuing {
                        phi_1175_ = _e2632;
                        phi_1178_ = _e2634;
                        break if !(_e542);
                    }
                }
                let _e3690 = local_12;
                phi_3277_ = _e3690;
            }
            let _e2637 = phi_3277_;
            phi_3278_ = _e2637;
            phi_3279_ = _e239;
        } else {
            phi_3278_ = lt_bvh_Hit();
            phi_3279_ = true;
        }
        let _e2639 = phi_3278_;
        let _e2641 = phi_3279_;
        if _e2641 {
            phi_3283_ = _e177;
        } else {
            phi_3283_ = _e2639;
        }
        let _e2643 = phi_3283_;
        if (_e2643.triangle != 4294967295u) {
            let _e2649 = ((1f - _e2643.u) - _e2643.v);
            if (_e2643.triangle < _e80) {
            } else {
                return;
            }
            let _e2654 = triangles.member[(0u + _e2643.triangle)];
            if (_e2643.instance < _e92) {
            } else {
                return;
            }
            let _e2665 = instances.member[(0u + _e2643.instance)].object_to_world[0u];
            let _e2676 = ((((_e2665.x * _e2654.v0_.x) + (_e2665.y * _e2654.v0_.y)) + (_e2665.z * _e2654.v0_.z)) + (_e2665.w * 1f));
            let _e2678 = instances.member[(0u + _e2643.instance)].object_to_world[1u];
            let _e2689 = ((((_e2678.x * _e2654.v0_.x) + (_e2678.y * _e2654.v0_.y)) + (_e2678.z * _e2654.v0_.z)) + (_e2678.w * 1f));
            let _e2691 = instances.member[(0u + _e2643.instance)].object_to_world[2u];
            let _e2702 = ((((_e2691.x * _e2654.v0_.x) + (_e2691.y * _e2654.v0_.y)) + (_e2691.z * _e2654.v0_.z)) + (_e2691.w * 1f));
            let _e2709 = instances.member[(0u + _e2643.instance)].object_to_world[0u];
            let _e2720 = ((((_e2709.x * _e2654.v1_.x) + (_e2709.y * _e2654.v1_.y)) + (_e2709.z * _e2654.v1_.z)) + (_e2709.w * 1f));
            let _e2722 = instances.member[(0u + _e2643.instance)].object_to_world[1u];
            let _e2733 = ((((_e2722.x * _e2654.v1_.x) + (_e2722.y * _e2654.v1_.y)) + (_e2722.z * _e2654.v1_.z)) + (_e2722.w * 1f));
            let _e2735 = instances.member[(0u + _e2643.instance)].object_to_world[2u];
            let _e2746 = ((((_e2735.x * _e2654.v1_.x) + (_e2735.y * _e2654.v1_.y)) + (_e2735.z * _e2654.v1_.z)) + (_e2735.w * 1f));
            let _e2753 = instances.member[(0u + _e2643.instance)].object_to_world[0u];
            let _e2764 = ((((_e2753.x * _e2654.v2_.x) + (_e2753.y * _e2654.v2_.y)) + (_e2753.z * _e2654.v2_.z)) + (_e2753.w * 1f));
            let _e2766 = instances.member[(0u + _e2643.instance)].object_to_world[1u];
            let _e2777 = ((((_e2766.x * _e2654.v2_.x) + (_e2766.y * _e2654.v2_.y)) + (_e2766.z * _e2654.v2_.z)) + (_e2766.w * 1f));
            let _e2779 = instances.member[(0u + _e2643.instance)].object_to_world[2u];
            let _e2790 = ((((_e2779.x * _e2654.v2_.x) + (_e2779.y * _e2654.v2_.y)) + (_e2779.z * _e2654.v2_.z)) + (_e2779.w * 1f));
            let _e2803 = (((_e2676 * _e2649) + (_e2720 * _e2643.u)) + (_e2764 * _e2643.v));
            let _e2804 = (((_e2689 * _e2649) + (_e2733 * _e2643.u)) + (_e2777 * _e2643.v));
            let _e2805 = (((_e2702 * _e2649) + (_e2746 * _e2643.u)) + (_e2790 * _e2643.v));
            let _e2807 = abs(_e2676);
            let _e2808 = abs(_e2689);
            let _e2809 = abs(_e2702);
            let _e2810 = abs(_e2720);
            let _e2811 = abs(_e2733);
            let _e2812 = abs(_e2746);
            if (_e2807 > _e2810) {
                phi_3470_ = _e2807;
            } else {
                phi_3470_ = _e2810;
            }
            let _e2815 = phi_3470_;
            if (_e2808 > _e2811) {
                phi_3475_ = _e2808;
            } else {
                phi_3475_ = _e2811;
            }
            let _e2818 = phi_3475_;
            if (_e2809 > _e2812) {
                phi_3480_ = _e2809;
            } else {
                phi_3480_ = _e2812;
            }
            let _e2821 = phi_3480_;
            let _e2822 = abs(_e2764);
            let _e2823 = abs(_e2777);
            let _e2824 = abs(_e2790);
            if (_e2815 > _e2822) {
                phi_3488_ = _e2815;
            } else {
                phi_3488_ = _e2822;
            }
            let _e2827 = phi_3488_;
            if (_e2818 > _e2823) {
                phi_3493_ = _e2818;
            } else {
                phi_3493_ = _e2823;
            }
            let _e2830 = phi_3493_;
            if (_e2821 > _e2824) {
                phi_3498_ = _e2821;
            } else {
                phi_3498_ = _e2824;
            }
            let _e2833 = phi_3498_;
            let _e2834 = (_e2720 - _e2676);
            let _e2835 = (_e2733 - _e2689);
            let _e2836 = (_e2746 - _e2702);
            let _e2837 = (_e2764 - _e2676);
            let _e2838 = (_e2777 - _e2689);
            let _e2839 = (_e2790 - _e2702);
            let _e2843 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2835), abs(_e2836));
            let _e2844 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2834), _e2843);
            let _e2845 = (_e2834 / _e2844);
            let _e2846 = (_e2835 / _e2844);
            let _e2847 = (_e2836 / _e2844);
            let _e2851 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2838), abs(_e2839));
            let _e2852 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2837), _e2851);
            let _e2853 = (_e2837 / _e2852);
            let _e2854 = (_e2838 / _e2852);
            let _e2855 = (_e2839 / _e2852);
            let _e2858 = ((_e2846 * _e2855) - (_e2854 * _e2847));
            let _e2861 = ((_e2847 * _e2853) - (_e2855 * _e2845));
            let _e2864 = ((_e2845 * _e2854) - (_e2853 * _e2846));
            let _e2866 = p.member.eye;
            let _e2879 = (1f / sqrt((((_e2858 * _e2858) + (_e2861 * _e2861)) + (_e2864 * _e2864))));
            let _e2880 = (_e2858 * _e2879);
            let _e2881 = (_e2861 * _e2879);
            let _e2882 = (_e2864 * _e2879);
            if ((((_e2880 * (_e2866.x - _e2803)) + (_e2881 * (_e2866.y - _e2804))) + (_e2882 * (_e2866.z - _e2805))) < 0f) {
                phi_3562_ = vec3<f32>(-(_e2880), -(_e2881), -(_e2882));
            } else {
                phi_3562_ = vec3<f32>(_e2880, _e2881, _e2882);
            }
            let _e2895 = phi_3562_;
            if (_e2643.triangle < _e80) {
            } else {
                return;
            }
            let _e2900 = triangles.member[(0u + _e2643.triangle)];
            let _e2902 = (_e2900.i0_ & 2147483647u);
            if (_e2902 < _e83) {
            } else {
                return;
            }
            let _e2908 = vertices.member[(0u + _e2902)];
            if (_e2900.i1_ < _e83) {
            } else {
                return;
            }
            let _e2912 = vertices.member[(0u + _e2900.i1_)];
            if (_e2900.i2_ < _e83) {
            } else {
                return;
            }
            let _e2916 = vertices.member[(0u + _e2900.i2_)];
            let _e2917 = array<abi_Vertex, 3>(_e2908, _e2912, _e2916);
            if (_e2917[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e2923 = materials.member[(0u + _e2917[0].material)];
            let _e2940 = (1f / 255f);
            let _e2959 = (1f / 255f);
            let _e2981 = (1f / 255f);
            if (_e2923.color_size == 0u) {
                phi_3805_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e2923.color_offset;
                local.size = _e2923.color_size;
                local.flags = _e2923.flags;
                let _e3024 = _lt_shaders_texture_TextureView_quad((&local), (((_e2917[0].u * _e2649) + (_e2917[1].u * _e2643.u)) + (_e2917[2].u * _e2643.v)), (((_e2917[0].v * _e2649) + (_e2917[1].v * _e2643.u)) + (_e2917[2].v * _e2643.v)));
                if (_e3024.indices[0] < _e95) {
                } else {
                    return;
                }
                let _e3030 = color_texels.member[(0u + _e3024.indices[0])];
                let _e3041 = (1f / 255f);
                if (_e3024.indices[1] < _e95) {
                } else {
                    return;
                }
                let _e3055 = color_texels.member[(0u + _e3024.indices[1])];
                let _e3066 = (1f / 255f);
                if (_e3024.indices[2] < _e95) {
                } else {
                    return;
                }
                let _e3083 = color_texels.member[(0u + _e3024.indices[2])];
                let _e3094 = (1f / 255f);
                if (_e3024.indices[3] < _e95) {
                } else {
                    return;
                }
                let _e3111 = color_texels.member[(0u + _e3024.indices[3])];
                let _e3122 = (1f / 255f);
                let _e3131 = (((((f32((_e3030 & 255u)) * _e3041) * _e3024.weights.x) + ((f32((_e3055 & 255u)) * _e3066) * _e3024.weights.y)) + ((f32((_e3083 & 255u)) * _e3094) * _e3024.weights.z)) + ((f32((_e3111 & 255u)) * _e3122) * _e3024.weights.w));
                let _e3132 = (((((f32(((_e3030 >> bitcast<u32>(8i)) & 255u)) * _e3041) * _e3024.weights.x) + ((f32(((_e3055 >> bitcast<u32>(8i)) & 255u)) * _e3066) * _e3024.weights.y)) + ((f32(((_e3083 >> bitcast<u32>(8i)) & 255u)) * _e3094) * _e3024.weights.z)) + ((f32(((_e3111 >> bitcast<u32>(8i)) & 255u)) * _e3122) * _e3024.weights.w));
                let _e3133 = (((((f32(((_e3030 >> bitcast<u32>(16i)) & 255u)) * _e3041) * _e3024.weights.x) + ((f32(((_e3055 >> bitcast<u32>(16i)) & 255u)) * _e3066) * _e3024.weights.y)) + ((f32(((_e3083 >> bitcast<u32>(16i)) & 255u)) * _e3094) * _e3024.weights.z)) + ((f32(((_e3111 >> bitcast<u32>(16i)) & 255u)) * _e3122) * _e3024.weights.w));
                phi_3805_ = vec3<f32>((_e3131 * _e3131), (_e3132 * _e3132), (_e3133 * _e3133));
            }
            let _e3139 = phi_3805_;
            let _e3141 = ((_e2923.base_color.x * ((((f32((_e2917[0].color & 255u)) * _e2940) * _e2649) + ((f32((_e2917[1].color & 255u)) * _e2959) * _e2643.u)) + ((f32((_e2917[2].color & 255u)) * _e2981) * _e2643.v))) * _e3139.x);
            let _e3143 = ((_e2923.base_color.y * ((((f32(((_e2917[0].color >> bitcast<u32>(8i)) & 255u)) * _e2940) * _e2649) + ((f32(((_e2917[1].color >> bitcast<u32>(8i)) & 255u)) * _e2959) * _e2643.u)) + ((f32(((_e2917[2].color >> bitcast<u32>(8i)) & 255u)) * _e2981) * _e2643.v))) * _e3139.y);
            let _e3145 = ((_e2923.base_color.z * ((((f32(((_e2917[0].color >> bitcast<u32>(16i)) & 255u)) * _e2940) * _e2649) + ((f32(((_e2917[1].color >> bitcast<u32>(16i)) & 255u)) * _e2959) * _e2643.u)) + ((f32(((_e2917[2].color >> bitcast<u32>(16i)) & 255u)) * _e2981) * _e2643.v))) * _e3139.z);
            let _e3146 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2830, _e2833);
            let _e3147 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2827, _e3146);
            if ((_e2923.flags & 2u) == 0u) {
                phi_3820_ = 0u;
            } else {
                phi_3820_ = 1u;
            }
            let _e3152 = phi_3820_;
            if (_e2917[0].normal == 2147516416u) {
                phi_4050_ = _e2895;
            } else {
                let _e3165 = (f32((bitcast<i32>((_e2917[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3171 = (f32((bitcast<i32>(_e2917[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3175 = ((1f - abs(_e3165)) - abs(_e3171));
                if (_e3175 < 0f) {
                    phi_3847_ = -(_e3175);
                } else {
                    phi_3847_ = 0f;
                }
                let _e3179 = phi_3847_;
                if (_e3165 < 0f) {
                    phi_3854_ = (_e3165 + _e3179);
                } else {
                    phi_3854_ = (_e3165 - _e3179);
                }
                let _e3184 = phi_3854_;
                if (_e3171 < 0f) {
                    phi_3861_ = (_e3171 + _e3179);
                } else {
                    phi_3861_ = (_e3171 - _e3179);
                }
                let _e3189 = phi_3861_;
                let _e3196 = (1f / sqrt((((_e3184 * _e3184) + (_e3189 * _e3189)) + (_e3175 * _e3175))));
                let _e3212 = (f32((bitcast<i32>((_e2917[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3218 = (f32((bitcast<i32>(_e2917[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3222 = ((1f - abs(_e3212)) - abs(_e3218));
                if (_e3222 < 0f) {
                    phi_3896_ = -(_e3222);
                } else {
                    phi_3896_ = 0f;
                }
                let _e3226 = phi_3896_;
                if (_e3212 < 0f) {
                    phi_3903_ = (_e3212 + _e3226);
                } else {
                    phi_3903_ = (_e3212 - _e3226);
                }
                let _e3231 = phi_3903_;
                if (_e3218 < 0f) {
                    phi_3910_ = (_e3218 + _e3226);
                } else {
                    phi_3910_ = (_e3218 - _e3226);
                }
                let _e3236 = phi_3910_;
                let _e3243 = (1f / sqrt((((_e3231 * _e3231) + (_e3236 * _e3236)) + (_e3222 * _e3222))));
                let _e3262 = (f32((bitcast<i32>((_e2917[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3268 = (f32((bitcast<i32>(_e2917[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3272 = ((1f - abs(_e3262)) - abs(_e3268));
                if (_e3272 < 0f) {
                    phi_3948_ = -(_e3272);
                } else {
                    phi_3948_ = 0f;
                }
                let _e3276 = phi_3948_;
                if (_e3262 < 0f) {
                    phi_3955_ = (_e3262 + _e3276);
                } else {
                    phi_3955_ = (_e3262 - _e3276);
                }
                let _e3281 = phi_3955_;
                if (_e3268 < 0f) {
                    phi_3962_ = (_e3268 + _e3276);
                } else {
                    phi_3962_ = (_e3268 - _e3276);
                }
                let _e3286 = phi_3962_;
                let _e3293 = (1f / sqrt((((_e3281 * _e3281) + (_e3286 * _e3286)) + (_e3272 * _e3272))));
                let _e3300 = ((((_e3184 * _e3196) * _e2649) + ((_e3231 * _e3243) * _e2643.u)) + ((_e3281 * _e3293) * _e2643.v));
                let _e3301 = ((((_e3189 * _e3196) * _e2649) + ((_e3236 * _e3243) * _e2643.u)) + ((_e3286 * _e3293) * _e2643.v));
                let _e3302 = ((((_e3175 * _e3196) * _e2649) + ((_e3222 * _e3243) * _e2643.u)) + ((_e3272 * _e3293) * _e2643.v));
                if (_e2643.instance < _e92) {
                } else {
                    return;
                }
                let _e3309 = instances.member[(0u + _e2643.instance)].world_to_object[0u];
                let _e3318 = instances.member[(0u + _e2643.instance)].world_to_object[1u];
                let _e3330 = instances.member[(0u + _e2643.instance)].world_to_object[2u];
                let _e3337 = (((_e3309.x * _e3300) + (_e3318.x * _e3301)) + (_e3330.x * _e3302));
                let _e3338 = (((_e3309.y * _e3300) + (_e3318.y * _e3301)) + (_e3330.y * _e3302));
                let _e3339 = (((_e3309.z * _e3300) + (_e3318.z * _e3301)) + (_e3330.z * _e3302));
                let _e3345 = sqrt((((_e3337 * _e3337) + (_e3338 * _e3338)) + (_e3339 * _e3339)));
                if (_e3345 > 0f) {
                    let _e3347 = (_e3337 / _e3345);
                    let _e3348 = (_e3338 / _e3345);
                    let _e3349 = (_e3339 / _e3345);
                    if ((((_e3347 * _e2895.x) + (_e3348 * _e2895.y)) + (_e3349 * _e2895.z)) < 0f) {
                        phi_4048_ = vec3<f32>(-(_e3347), -(_e3348), -(_e3349));
                    } else {
                        phi_4048_ = vec3<f32>(_e3347, _e3348, _e3349);
                    }
                    let _e3365 = phi_4048_;
                    phi_4049_ = _e3365;
                } else {
                    phi_4049_ = _e2895;
                }
                let _e3367 = phi_4049_;
                phi_4050_ = _e3367;
            }
            let _e3369 = phi_4050_;
            if (_e3141 > 0f) {
                if (_e3141 < 1f) {
                    phi_4059_ = _e3141;
                } else {
                    phi_4059_ = 1f;
                }
                let _e3373 = phi_4059_;
                phi_4060_ = _e3373;
            } else {
                phi_4060_ = 0f;
            }
            let _e3375 = phi_4060_;
            if (_e3143 > 0f) {
                if (_e3143 < 1f) {
                    phi_4070_ = _e3143;
                } else {
                    phi_4070_ = 1f;
                }
                let _e3380 = phi_4070_;
                phi_4071_ = _e3380;
            } else {
                phi_4071_ = 0f;
            }
            let _e3382 = phi_4071_;
            if (_e3145 > 0f) {
                if (_e3145 < 1f) {
                    phi_4081_ = _e3145;
                } else {
                    phi_4081_ = 1f;
                }
                let _e3387 = phi_4081_;
                phi_4082_ = _e3387;
            } else {
                phi_4082_ = 0f;
            }
            let _e3389 = phi_4082_;
            let _e3392 = ((sqrt(_e3375) * 255f) + 0.5f);
            let _e3401 = ((sqrt(_e3382) * 255f) + 0.5f);
            let _e3413 = ((sqrt(_e3389) * 255f) + 0.5f);
            phi_4117_ = abi_Sample(vec3<f32>(_e2803, _e2804, _e2805), _e3147, _e2895, _e3152, _e3369, ((select(select(u32(_e3392), 0u, (_e3392 < bitcast<f32>(0u))), 4294967295u, (_e3392 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3401), 0u, (_e3401 < bitcast<f32>(0u))), 4294967295u, (_e3401 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3413), 0u, (_e3413 < bitcast<f32>(0u))), 4294967295u, (_e3413 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4117_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3427 = phi_4117_;
        if (_e101.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e101.first_primitive)] = _e3427;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_color_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
