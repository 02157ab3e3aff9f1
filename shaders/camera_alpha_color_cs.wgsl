struct abi_CameraParams {
    eye: vec3<f32>,
    root: u32,
    right: vec3<f32>,
    pad0_: u32,
    up: vec3<f32>,
    pad1_: u32,
    forward: vec3<f32>,
    pad2_: u32,
    size: vec2<u32>,
    pad3_: vec2<u32>,
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

struct lt_mask_LightPlace {
    word: u32,
    shift: u32,
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

struct type_30 {
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

struct type_34 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_38 {
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

struct type_42 {
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

struct type_53 {
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
var<storage> vertices: type_38;
@group(0) @binding(4) 
var<storage> materials: type_42;
@group(0) @binding(0) 
var<uniform> p: type_53;
@group(0) @binding(1) 
var<storage> nodes: type_30;
@group(0) @binding(2) 
var<storage> triangles: type_34;
@group(0) @binding(5) 
var<storage, read_write> samples: type_9;
@group(0) @binding(6) 
var<storage> alpha_texels: type_13;
@group(0) @binding(7) 
var<storage> color_texels: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_214_: lt_mask_LightPlace;
    var phi_215_: bool;
    var phi_216_: lt_mask_LightPlace;
    var phi_217_: bool;
    var phi_222_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_214_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_215_ = false;
        } else {
            phi_214_ = lt_mask_LightPlace();
            phi_215_ = true;
        }
        let _e83 = phi_214_;
        let _e85 = phi_215_;
        phi_216_ = _e83;
        phi_217_ = _e85;
    } else {
        phi_216_ = lt_mask_LightPlace();
        phi_217_ = true;
    }
    let _e87 = phi_216_;
    let _e89 = phi_217_;
    if _e89 {
        phi_222_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_222_ = _e87;
    }
    let _e94 = phi_222_;
    return lt_mask_LightPlace(_e94.word, _e94.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_237_: bool;
    var phi_241_: f32;

    if (param_3 != param_3) {
        phi_237_ = true;
    } else {
        let _e73 = (param_4 >= param_3);
        if _e73 {
        }
        phi_237_ = _e73;
    }
    let _e75 = phi_237_;
    if _e75 {
        phi_241_ = param_4;
    } else {
        phi_241_ = param_3;
    }
    let _e77 = phi_241_;
    return _e77;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_253_: bool;
    var phi_257_: f32;

    if (param_5 != param_5) {
        phi_253_ = true;
    } else {
        let _e73 = (param_6 <= param_5);
        if _e73 {
        }
        phi_253_ = _e73;
    }
    let _e75 = phi_253_;
    if _e75 {
        phi_257_ = param_6;
    } else {
        phi_257_ = param_5;
    }
    let _e77 = phi_257_;
    return _e77;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_299_: f32;
    var phi_304_: f32;
    var phi_305_: bool;
    var phi_306_: f32;
    var phi_307_: bool;
    var phi_311_: f32;
    var phi_337_: f32;
    var phi_342_: f32;
    var phi_343_: bool;
    var phi_344_: f32;
    var phi_345_: bool;
    var phi_349_: f32;
    var phi_357_: f32;
    var phi_358_: f32;
    var phi_359_: f32;
    var phi_368_: f32;
    var phi_369_: f32;
    var phi_387_: u32;
    var phi_401_: u32;
    var phi_408_: u32;
    var phi_413_: u32;
    var phi_419_: u32;
    var phi_424_: u32;
    var phi_426_: texture_Axis;
    var phi_454_: f32;
    var phi_459_: f32;
    var phi_460_: bool;
    var phi_461_: f32;
    var phi_462_: bool;
    var phi_466_: f32;
    var phi_492_: f32;
    var phi_497_: f32;
    var phi_498_: bool;
    var phi_499_: f32;
    var phi_500_: bool;
    var phi_504_: f32;
    var phi_512_: f32;
    var phi_513_: f32;
    var phi_514_: f32;
    var phi_523_: f32;
    var phi_524_: f32;
    var phi_542_: u32;
    var phi_556_: u32;
    var phi_563_: u32;
    var phi_568_: u32;
    var phi_574_: u32;
    var phi_579_: u32;
    var phi_581_: texture_Axis;

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
                phi_299_ = 1f;
            } else {
                phi_299_ = 0f;
            }
            let _e104 = phi_299_;
            if (param_8 < 8388608f) {
                phi_304_ = (_e101 - _e104);
                phi_305_ = false;
            } else {
                phi_304_ = f32();
                phi_305_ = true;
            }
            let _e107 = phi_304_;
            let _e109 = phi_305_;
            phi_306_ = _e107;
            phi_307_ = _e109;
        } else {
            phi_306_ = f32();
            phi_307_ = true;
        }
        let _e111 = phi_306_;
        let _e113 = phi_307_;
        if _e113 {
            phi_311_ = param_8;
        } else {
            phi_311_ = _e111;
        }
        let _e115 = phi_311_;
        phi_359_ = (param_8 - _e115);
    } else {
        if (_e88 == 1u) {
            let _e118 = (param_8 * 0.5f);
            if (_e118 > -8388608f) {
                let _e130 = f32(select(0i, select(select(i32(_e118), i32(-2147483648), (_e118 < bitcast<f32>(3472883712u))), 2147483647i, (_e118 > bitcast<f32>(1325400063u))), (_e118 == _e118)));
                if (_e130 > _e118) {
                    phi_337_ = 1f;
                } else {
                    phi_337_ = 0f;
                }
                let _e133 = phi_337_;
                if (_e118 < 8388608f) {
                    phi_342_ = (_e130 - _e133);
                    phi_343_ = false;
                } else {
                    phi_342_ = f32();
                    phi_343_ = true;
                }
                let _e136 = phi_342_;
                let _e138 = phi_343_;
                phi_344_ = _e136;
                phi_345_ = _e138;
            } else {
                phi_344_ = f32();
                phi_345_ = true;
            }
            let _e140 = phi_344_;
            let _e142 = phi_345_;
            if _e142 {
                phi_349_ = _e118;
            } else {
                phi_349_ = _e140;
            }
            let _e144 = phi_349_;
            let _e146 = (param_8 - (2f * _e144));
            if (_e146 > 1f) {
                phi_357_ = (2f - _e146);
            } else {
                phi_357_ = _e146;
            }
            let _e150 = phi_357_;
            phi_358_ = _e150;
        } else {
            phi_358_ = param_8;
        }
        let _e152 = phi_358_;
        phi_359_ = _e152;
    }
    let _e154 = phi_359_;
    if (_e154 > 0f) {
        if (_e154 < 1f) {
            phi_368_ = _e154;
        } else {
            phi_368_ = 1f;
        }
        let _e158 = phi_368_;
        phi_369_ = _e158;
    } else {
        phi_369_ = 0f;
    }
    let _e160 = phi_369_;
    let _e161 = (_e75 - 1u);
    let _e163 = (_e160 * f32(_e75));
    if _e83 {
        let _e170 = select(select(u32(_e163), 0u, (_e163 < bitcast<f32>(0u))), 4294967295u, (_e163 > bitcast<f32>(1333788671u)));
        if (_e161 < _e170) {
            phi_387_ = _e161;
        } else {
            phi_387_ = _e170;
        }
        let _e173 = phi_387_;
        phi_426_ = texture_Axis(_e173, _e173, 0f);
    } else {
        let _e175 = (_e163 + 0.5f);
        let _e182 = select(select(u32(_e175), 0u, (_e175 < bitcast<f32>(0u))), 4294967295u, (_e175 > bitcast<f32>(1333788671u)));
        if (_e75 < _e182) {
            phi_401_ = _e75;
        } else {
            phi_401_ = _e182;
        }
        let _e185 = phi_401_;
        if (_e88 == 0u) {
            phi_408_ = _e161;
        } else {
            phi_408_ = 0u;
        }
        let _e190 = phi_408_;
        if (_e88 == 0u) {
            phi_413_ = 0u;
        } else {
            phi_413_ = _e161;
        }
        let _e193 = phi_413_;
        if (_e185 == 0u) {
            phi_419_ = _e190;
        } else {
            phi_419_ = (_e185 - 1u);
        }
        let _e197 = phi_419_;
        if (_e185 > _e161) {
            phi_424_ = _e193;
        } else {
            phi_424_ = _e185;
        }
        let _e200 = phi_424_;
        phi_426_ = texture_Axis(_e197, _e200, (_e175 - f32(_e185)));
    }
    let _e203 = phi_426_;
    let _e205 = (*param_7).flags;
    let _e208 = ((_e205 >> bitcast<u32>(6u)) & 3u);
    if (_e208 == 0u) {
        if (param_9 > -8388608f) {
            let _e221 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e221 > param_9) {
                phi_454_ = 1f;
            } else {
                phi_454_ = 0f;
            }
            let _e224 = phi_454_;
            if (param_9 < 8388608f) {
                phi_459_ = (_e221 - _e224);
                phi_460_ = false;
            } else {
                phi_459_ = f32();
                phi_460_ = true;
            }
            let _e227 = phi_459_;
            let _e229 = phi_460_;
            phi_461_ = _e227;
            phi_462_ = _e229;
        } else {
            phi_461_ = f32();
            phi_462_ = true;
        }
        let _e231 = phi_461_;
        let _e233 = phi_462_;
        if _e233 {
            phi_466_ = param_9;
        } else {
            phi_466_ = _e231;
        }
        let _e235 = phi_466_;
        phi_514_ = (param_9 - _e235);
    } else {
        if (_e208 == 1u) {
            let _e238 = (param_9 * 0.5f);
            if (_e238 > -8388608f) {
                let _e250 = f32(select(0i, select(select(i32(_e238), i32(-2147483648), (_e238 < bitcast<f32>(3472883712u))), 2147483647i, (_e238 > bitcast<f32>(1325400063u))), (_e238 == _e238)));
                if (_e250 > _e238) {
                    phi_492_ = 1f;
                } else {
                    phi_492_ = 0f;
                }
                let _e253 = phi_492_;
                if (_e238 < 8388608f) {
                    phi_497_ = (_e250 - _e253);
                    phi_498_ = false;
                } else {
                    phi_497_ = f32();
                    phi_498_ = true;
                }
                let _e256 = phi_497_;
                let _e258 = phi_498_;
                phi_499_ = _e256;
                phi_500_ = _e258;
            } else {
                phi_499_ = f32();
                phi_500_ = true;
            }
            let _e260 = phi_499_;
            let _e262 = phi_500_;
            if _e262 {
                phi_504_ = _e238;
            } else {
                phi_504_ = _e260;
            }
            let _e264 = phi_504_;
            let _e266 = (param_9 - (2f * _e264));
            if (_e266 > 1f) {
                phi_512_ = (2f - _e266);
            } else {
                phi_512_ = _e266;
            }
            let _e270 = phi_512_;
            phi_513_ = _e270;
        } else {
            phi_513_ = param_9;
        }
        let _e272 = phi_513_;
        phi_514_ = _e272;
    }
    let _e274 = phi_514_;
    if (_e274 > 0f) {
        if (_e274 < 1f) {
            phi_523_ = _e274;
        } else {
            phi_523_ = 1f;
        }
        let _e278 = phi_523_;
        phi_524_ = _e278;
    } else {
        phi_524_ = 0f;
    }
    let _e280 = phi_524_;
    let _e281 = (_e79 - 1u);
    let _e283 = (_e280 * f32(_e79));
    if _e83 {
        let _e290 = select(select(u32(_e283), 0u, (_e283 < bitcast<f32>(0u))), 4294967295u, (_e283 > bitcast<f32>(1333788671u)));
        if (_e281 < _e290) {
            phi_542_ = _e281;
        } else {
            phi_542_ = _e290;
        }
        let _e293 = phi_542_;
        phi_581_ = texture_Axis(_e293, _e293, 0f);
    } else {
        let _e295 = (_e283 + 0.5f);
        let _e302 = select(select(u32(_e295), 0u, (_e295 < bitcast<f32>(0u))), 4294967295u, (_e295 > bitcast<f32>(1333788671u)));
        if (_e79 < _e302) {
            phi_556_ = _e79;
        } else {
            phi_556_ = _e302;
        }
        let _e305 = phi_556_;
        if (_e208 == 0u) {
            phi_563_ = _e281;
        } else {
            phi_563_ = 0u;
        }
        let _e310 = phi_563_;
        if (_e208 == 0u) {
            phi_568_ = 0u;
        } else {
            phi_568_ = _e281;
        }
        let _e313 = phi_568_;
        if (_e305 == 0u) {
            phi_574_ = _e310;
        } else {
            phi_574_ = (_e305 - 1u);
        }
        let _e317 = phi_574_;
        if (_e305 > _e281) {
            phi_579_ = _e313;
        } else {
            phi_579_ = _e305;
        }
        let _e320 = phi_579_;
        phi_581_ = texture_Axis(_e317, _e320, (_e295 - f32(_e305)));
    }
    let _e323 = phi_581_;
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
    var phi_640_: f32;

    if (param_12 > param_13) {
        phi_640_ = param_12;
    } else {
        phi_640_ = param_13;
    }
    let _e74 = phi_640_;
    return _e74;
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(param_14: vec3<f32>) -> vec3<f32> {
    return param_14;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: texture_TextureView;
    var local_2: lt_bvh_traverse_Stack;
    var phi_769_: bool;
    var phi_770_: bool;
    var phi_771_: bool;
    var phi_772_: bool;
    var phi_776_: bool;
    var phi_789_: bool;
    var phi_790_: bool;
    var phi_791_: bool;
    var phi_792_: bool;
    var phi_796_: bool;
    var phi_809_: bool;
    var phi_810_: bool;
    var phi_811_: bool;
    var phi_815_: bool;
    var phi_816_: bool;
    var phi_817_: bool;
    var phi_818_: bool;
    var phi_819_: bool;
    var phi_823_: bool;
    var phi_899_: f32;
    var phi_906_: f32;
    var phi_914_: f32;
    var phi_921_: f32;
    var phi_929_: f32;
    var phi_936_: f32;
    var phi_959_: f32;
    var phi_964_: f32;
    var phi_969_: f32;
    var phi_974_: f32;
    var phi_979_: f32;
    var phi_1010_: bool;
    var phi_1011_: bool;
    var phi_1019_: u32;
    var phi_1020_: u32;
    var phi_1037_: vec3<f32>;
    var phi_1038_: vec3<f32>;
    var phi_1051_: u32;
    var phi_1056_: u32;
    var phi_1061_: u32;
    var phi_1175_: bool;
    var phi_1176_: bool;
    var phi_1207_: u32;
    var phi_1209_: lt_bvh_Hit;
    var phi_1212_: u32;
    var phi_1297_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1324_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1351_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1357_: u32;
    var phi_1360_: u32;
    var phi_1374_: u32;
    var phi_1384_: u32;
    var phi_1394_: u32;
    var phi_1412_: u32;
    var phi_1422_: u32;
    var phi_1432_: u32;
    var phi_1468_: u32;
    var phi_1481_: u32;
    var phi_1486_: u32;
    var phi_1487_: u32;
    var phi_1488_: u32;
    var phi_1358_: u32;
    var phi_1361_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1546_: lt_bvh_Hit;
    var phi_1549_: u32;
    var phi_1595_: vec3<f32>;
    var phi_1596_: vec3<f32>;
    var phi_1627_: vec3<f32>;
    var phi_1628_: vec3<f32>;
    var phi_1659_: vec3<f32>;
    var phi_1660_: vec3<f32>;
    var phi_1678_: bool;
    var phi_1679_: bool;
    var phi_1683_: f32;
    var phi_1684_: f32;
    var phi_1685_: f32;
    var phi_1686_: f32;
    var phi_1694_: f32;
    var phi_1704_: bool;
    var phi_1705_: bool;
    var phi_1709_: f32;
    var phi_1710_: f32;
    var phi_1711_: f32;
    var phi_1712_: f32;
    var phi_1720_: f32;
    var phi_1730_: bool;
    var phi_1731_: bool;
    var phi_1735_: f32;
    var phi_1736_: f32;
    var phi_1737_: f32;
    var phi_1738_: f32;
    var phi_1746_: f32;
    var phi_1761_: f32;
    var phi_1762_: bool;
    var phi_1763_: f32;
    var phi_1764_: bool;
    var phi_1765_: f32;
    var phi_1766_: bool;
    var phi_1784_: f32;
    var phi_1785_: bool;
    var phi_1786_: bool;
    var phi_1787_: f32;
    var phi_1788_: bool;
    var phi_1789_: bool;
    var phi_1793_: bool;
    var phi_1794_: f32;
    var phi_1795_: bool;
    var phi_1825_: vec3<f32>;
    var phi_1826_: vec3<f32>;
    var phi_1851_: vec3<f32>;
    var phi_1852_: vec3<f32>;
    var phi_1877_: vec3<f32>;
    var phi_1878_: vec3<f32>;
    var phi_1936_: f32;
    var phi_1945_: f32;
    var phi_1954_: f32;
    var phi_1963_: f32;
    var phi_1970_: f32;
    var phi_1977_: f32;
    var phi_1990_: f32;
    var phi_1999_: f32;
    var phi_2008_: f32;
    var phi_2017_: f32;
    var phi_2024_: f32;
    var phi_2031_: f32;
    var phi_2054_: f32;
    var phi_2059_: f32;
    var phi_2064_: f32;
    var phi_2072_: f32;
    var phi_2077_: f32;
    var phi_2082_: f32;
    var phi_2094_: f32;
    var phi_2099_: f32;
    var phi_2104_: f32;
    var phi_2109_: f32;
    var phi_2114_: lt_bvh_triangle_Intersection;
    var phi_2115_: bool;
    var phi_2116_: lt_bvh_triangle_Intersection;
    var phi_2117_: bool;
    var phi_2121_: lt_bvh_triangle_Intersection;
    var phi_2122_: bool;
    var phi_2123_: lt_bvh_triangle_Intersection;
    var phi_2124_: bool;
    var phi_2125_: bool;
    var phi_2129_: bool;
    var phi_2133_: lt_bvh_triangle_Intersection;
    var phi_2172_: bool;
    var phi_2173_: bool;
    var phi_2174_: bool;
    var phi_2175_: bool;
    var phi_2176_: bool;
    var phi_2177_: bool;
    var phi_2181_: bool;
    var phi_2182_: bool;
    var phi_2385_: f32;
    var phi_2388_: bool;
    var phi_2389_: bool;
    var phi_2393_: bool;
    var phi_2401_: lt_bvh_Hit;
    var phi_2402_: lt_bvh_Hit;
    var phi_2403_: lt_bvh_Hit;
    var phi_2404_: lt_bvh_Hit;
    var phi_1547_: lt_bvh_Hit;
    var phi_1550_: u32;
    var phi_2405_: bool;
    var phi_2444_: bool;
    var phi_2445_: bool;
    var phi_2476_: u32;
    var phi_1210_: lt_bvh_Hit;
    var phi_1213_: u32;
    var phi_2477_: lt_bvh_Hit;
    var phi_2478_: lt_bvh_Hit;
    var phi_2479_: bool;
    var phi_2483_: lt_bvh_Hit;
    var phi_2547_: f32;
    var phi_2552_: f32;
    var phi_2557_: f32;
    var phi_2568_: f32;
    var phi_2573_: f32;
    var phi_2578_: f32;
    var phi_2654_: vec3<f32>;
    var phi_2897_: vec3<f32>;
    var phi_2912_: u32;
    var phi_2939_: f32;
    var phi_2946_: f32;
    var phi_2953_: f32;
    var phi_2988_: f32;
    var phi_2995_: f32;
    var phi_3002_: f32;
    var phi_3040_: f32;
    var phi_3047_: f32;
    var phi_3054_: f32;
    var phi_3113_: vec3<f32>;
    var phi_3114_: vec3<f32>;
    var phi_3115_: vec3<f32>;
    var phi_3124_: f32;
    var phi_3125_: f32;
    var phi_3135_: f32;
    var phi_3136_: f32;
    var phi_3146_: f32;
    var phi_3147_: f32;
    var phi_3182_: abi_Sample;
    var local_6: lt_bvh_Hit;
    var local_7: lt_bvh_Hit;

    let _e73 = id_1;
    let _e77 = arrayLength((&nodes.member));
    let _e80 = arrayLength((&triangles.member));
    let _e83 = arrayLength((&vertices.member));
    let _e86 = arrayLength((&materials.member));
    let _e92 = arrayLength((&alpha_texels.member));
    let _e95 = arrayLength((&color_texels.member));
    let _e98 = p.member.size[0u];
    let _e100 = p.member.size[1u];
    let _e101 = lt_shaders_entry_pixel_index(_e73, _e98, _e100);
    if (bitcast<i32>(_e101.word) != 0i) {
        let _e109 = p.member.eye;
        let _e114 = p.member.size[0u];
        let _e118 = ((((f32(_e73.x) + 0.5f) / f32(_e114)) * 2f) - 1f);
        let _e123 = p.member.size[1u];
        let _e127 = (1f - (((f32(_e73.y) + 0.5f) / f32(_e123)) * 2f));
        let _e129 = p.member.forward;
        let _e131 = p.member.right;
        let _e145 = p.member.up;
        let _e156 = _lt_bvh_ray_Ray_new(_e109, vec3<f32>(((_e129.x + (_e131.x * _e118)) + (_e145.x * _e127)), ((_e129.y + (_e131.y * _e118)) + (_e145.y * _e127)), ((_e129.z + (_e131.z * _e118)) + (_e145.z * _e127))));
        let _e158 = lt_bvh_Hit(_e156.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e161 = abs(_e156.direction.x);
        let _e163 = abs(_e156.direction.y);
        let _e165 = abs(_e156.direction.z);
        if (abs(_e156.origin.x) < 1000000000000000f) {
            if (abs(_e156.origin.y) < 1000000000000000f) {
                phi_769_ = (abs(_e156.origin.z) < 1000000000000000f);
                phi_770_ = false;
            } else {
                phi_769_ = bool();
                phi_770_ = true;
            }
            let _e177 = phi_769_;
            let _e179 = phi_770_;
            phi_771_ = _e177;
            phi_772_ = _e179;
        } else {
            phi_771_ = bool();
            phi_772_ = true;
        }
        let _e181 = phi_771_;
        let _e183 = phi_772_;
        if _e183 {
            phi_776_ = false;
        } else {
            phi_776_ = _e181;
        }
        let _e185 = phi_776_;
        if _e185 {
            if (_e161 < 1000000000000000f) {
                if (_e163 < 1000000000000000f) {
                    phi_789_ = (_e165 < 1000000000000000f);
                    phi_790_ = false;
                } else {
                    phi_789_ = bool();
                    phi_790_ = true;
                }
                let _e190 = phi_789_;
                let _e192 = phi_790_;
                phi_791_ = _e190;
                phi_792_ = _e192;
            } else {
                phi_791_ = bool();
                phi_792_ = true;
            }
            let _e194 = phi_791_;
            let _e196 = phi_792_;
            if _e196 {
                phi_796_ = false;
            } else {
                phi_796_ = _e194;
            }
            let _e198 = phi_796_;
            if _e198 {
                if (_e161 > 0f) {
                    phi_810_ = bool();
                    phi_811_ = true;
                } else {
                    let _e200 = (_e163 > 0f);
                    if _e200 {
                        phi_809_ = bool();
                    } else {
                        phi_809_ = (_e165 > 0f);
                    }
                    let _e203 = phi_809_;
                    phi_810_ = _e203;
                    phi_811_ = _e200;
                }
                let _e205 = phi_810_;
                let _e207 = phi_811_;
                if _e207 {
                    phi_815_ = true;
                } else {
                    phi_815_ = _e205;
                }
                let _e209 = phi_815_;
                phi_816_ = _e209;
                phi_817_ = false;
            } else {
                phi_816_ = bool();
                phi_817_ = true;
            }
            let _e211 = phi_816_;
            let _e213 = phi_817_;
            phi_818_ = _e211;
            phi_819_ = _e213;
        } else {
            phi_818_ = bool();
            phi_819_ = true;
        }
        let _e215 = phi_818_;
        let _e217 = phi_819_;
        if _e217 {
            phi_823_ = false;
        } else {
            phi_823_ = _e215;
        }
        let _e219 = phi_823_;
        if _e219 {
            let _e220 = (0u >= _e77);
            if _e220 {
                phi_2477_ = lt_bvh_Hit();
            } else {
                if (0u < _e77) {
                } else {
                    return;
                }
                let _e226 = nodes.member[(0u + 0u)].frame[0u];
                let _e230 = nodes.member[(0u + 0u)].frame[1u];
                let _e234 = nodes.member[(0u + 0u)].frame[2u];
                let _e238 = nodes.member[(0u + 0u)].frame[0u];
                let _e242 = nodes.member[(0u + 0u)].frame[1u];
                let _e246 = nodes.member[(0u + 0u)].frame[2u];
                let _e250 = nodes.member[(0u + 0u)].frame[3u];
                let _e289 = core_intrinsics_maximum_number_nsz_f32_(abs(_e156.direction.x), abs(_e156.direction.y));
                let _e290 = core_intrinsics_maximum_number_nsz_f32_(_e289, abs(_e156.direction.z));
                let _e291 = (_e290 * 0.0000000000009094947f);
                if (abs(_e156.direction.x) < _e291) {
                    phi_899_ = _e291;
                } else {
                    phi_899_ = abs(_e156.direction.x);
                }
                let _e297 = phi_899_;
                if (_e156.direction.x < 0f) {
                    phi_906_ = (-1f / _e297);
                } else {
                    phi_906_ = (1f / _e297);
                }
                let _e302 = phi_906_;
                if (abs(_e156.direction.y) < _e291) {
                    phi_914_ = _e291;
                } else {
                    phi_914_ = abs(_e156.direction.y);
                }
                let _e308 = phi_914_;
                if (_e156.direction.y < 0f) {
                    phi_921_ = (-1f / _e308);
                } else {
                    phi_921_ = (1f / _e308);
                }
                let _e313 = phi_921_;
                if (abs(_e156.direction.z) < _e291) {
                    phi_929_ = _e291;
                } else {
                    phi_929_ = abs(_e156.direction.z);
                }
                let _e319 = phi_929_;
                if (_e156.direction.z < 0f) {
                    phi_936_ = (-1f / _e319);
                } else {
                    phi_936_ = (1f / _e319);
                }
                let _e324 = phi_936_;
                let _e331 = abs((bitcast<f32>(_e226) - _e156.origin.x));
                let _e332 = abs((bitcast<f32>(_e230) - _e156.origin.y));
                let _e333 = abs((bitcast<f32>(_e234) - _e156.origin.z));
                let _e340 = abs(((bitcast<f32>(_e238) + (bitcast<f32>((((_e250 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e156.origin.x));
                let _e341 = abs(((bitcast<f32>(_e242) + (bitcast<f32>((((_e250 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e156.origin.y));
                let _e342 = abs(((bitcast<f32>(_e246) + (bitcast<f32>((((_e250 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e156.origin.z));
                if (_e331 > _e340) {
                    phi_959_ = _e331;
                } else {
                    phi_959_ = _e340;
                }
                let _e345 = phi_959_;
                if (_e332 > _e341) {
                    phi_964_ = _e332;
                } else {
                    phi_964_ = _e341;
                }
                let _e348 = phi_964_;
                if (_e333 > _e342) {
                    phi_969_ = _e333;
                } else {
                    phi_969_ = _e342;
                }
                let _e351 = phi_969_;
                if (_e345 > _e348) {
                    phi_974_ = _e345;
                } else {
                    phi_974_ = _e348;
                }
                let _e354 = phi_974_;
                if (_e354 > _e351) {
                    phi_979_ = _e354;
                } else {
                    phi_979_ = _e351;
                }
                let _e357 = phi_979_;
                let _e361 = (_e357 * 0.0000019073486f);
                let _e362 = (abs(_e302) * _e361);
                let _e363 = (abs(_e313) * _e361);
                let _e364 = (abs(_e324) * _e361);
                let _e368 = (_e357 * 0.0000009536743f);
                let _e369 = (abs(_e302) * _e368);
                let _e370 = (abs(_e313) * _e368);
                let _e371 = (abs(_e324) * _e368);
                let _e375 = abs(_e156.direction.x);
                let _e377 = abs(_e156.direction.y);
                let _e379 = abs(_e156.direction.z);
                if (_e375 >= _e377) {
                    if (_e375 >= _e379) {
                        phi_1010_ = false;
                    } else {
                        phi_1010_ = true;
                    }
                    let _e383 = phi_1010_;
                    phi_1011_ = _e383;
                } else {
                    phi_1011_ = true;
                }
                let _e385 = phi_1011_;
                if _e385 {
                    if (_e377 >= _e379) {
                        phi_1019_ = 1u;
                    } else {
                        phi_1019_ = 2u;
                    }
                    let _e388 = phi_1019_;
                    phi_1020_ = _e388;
                } else {
                    phi_1020_ = 0u;
                }
                let _e390 = phi_1020_;
                if (_e390 == 0u) {
                    phi_1038_ = vec3<f32>(_e156.direction.y, _e156.direction.z, _e156.direction.x);
                } else {
                    if (_e390 == 1u) {
                        phi_1037_ = vec3<f32>(_e156.direction.z, _e156.direction.x, _e156.direction.y);
                    } else {
                        phi_1037_ = _e156.direction;
                    }
                    let _e402 = phi_1037_;
                    phi_1038_ = _e402;
                }
                let _e404 = phi_1038_;
                let _e407 = (_e404.x / _e404.z);
                let _e410 = (_e404.y / _e404.z);
                if (_e302 < 0f) {
                    phi_1051_ = 0u;
                } else {
                    phi_1051_ = 1u;
                }
                let _e415 = phi_1051_;
                if (_e313 < 0f) {
                    phi_1056_ = 0u;
                } else {
                    phi_1056_ = 2u;
                }
                let _e418 = phi_1056_;
                if (_e324 < 0f) {
                    phi_1061_ = 0u;
                } else {
                    phi_1061_ = 4u;
                }
                let _e421 = phi_1061_;
                let _e423 = ((_e415 | _e418) | _e421);
                let _e424 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e424.first[0], _e424.first[1], _e424.first[2], _e424.first[3], _e424.first[4], _e424.first[5], _e424.first[6], _e424.first[7], _e424.first[8], _e424.first[9], _e424.first[10], _e424.first[11], _e424.first[12], _e424.first[13], _e424.first[14], _e424.first[15], _e424.first[16], _e424.first[17], _e424.first[18], _e424.first[19], _e424.first[20], _e424.first[21], _e424.first[22], _e424.first[23], _e424.first[24], _e424.first[25], _e424.first[26], _e424.first[27], _e424.first[28], _e424.first[29], _e424.first[30], _e424.first[31]), array<u32, 32>(_e424.mask[0], _e424.mask[1], _e424.mask[2], _e424.mask[3], _e424.mask[4], _e424.mask[5], _e424.mask[6], _e424.mask[7], _e424.mask[8], _e424.mask[9], _e424.mask[10], _e424.mask[11], _e424.mask[12], _e424.mask[13], _e424.mask[14], _e424.mask[15], _e424.mask[16], _e424.mask[17], _e424.mask[18], _e424.mask[19], _e424.mask[20], _e424.mask[21], _e424.mask[22], _e424.mask[23], _e424.mask[24], _e424.mask[25], _e424.mask[26], _e424.mask[27], _e424.mask[28], _e424.mask[29], _e424.mask[30], _e424.mask[31]), _e424.len, _e424.group, _e424.group_mask);
                let _e498 = local_2.group_mask;
                if ((_e498 & 4278190080u) == 0u) {
                    let _e502 = local_2.len;
                    if (_e502 == 0u) {
                        phi_1175_ = false;
                    } else {
                        let _e506 = local_2.len;
                        local_2.len = (_e506 - 1u);
                        let _e509 = local_2.len;
                        if (_e509 < 32u) {
                        } else {
                            return;
                        }
                        let _e514 = local_2.first[(0u + _e509)];
                        local_2.group = _e514;
                        let _e517 = local_2.len;
                        if (_e517 < 32u) {
                        } else {
                            return;
                        }
                        let _e522 = local_2.mask[(0u + _e517)];
                        local_2.group_mask = _e522;
                        phi_1175_ = true;
                    }
                    let _e525 = phi_1175_;
                    phi_1176_ = _e525;
                } else {
                    phi_1176_ = true;
                }
                let _e527 = phi_1176_;
                if _e527 {
                    let _e529 = local_2.group_mask;
                    let _e535 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e529)), 32u, (_e529 == 0u)));
                    let _e539 = local_2.group_mask;
                    let _e553 = local_2.group_mask;
                    local_2.group_mask = (_e553 & ~((1u << bitcast<u32>((_e535 & 31u)))));
                    let _e556 = local_2.group;
                    phi_1207_ = (_e556 + countOneBits(((_e539 & ~((4294967295u << bitcast<u32>((((_e535 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1207_ = 4294967295u;
                }
                let _e559 = phi_1207_;
                phi_1209_ = _e158;
                phi_1212_ = _e559;
                loop {
                    let _e561 = phi_1209_;
                    let _e563 = phi_1212_;
                    local_7 = _e561;
                    let _e564 = (_e563 != 4294967295u);
                    if _e564 {
                        if (_e563 < _e77) {
                        } else {
                            return;
                        }
                        let _e572 = nodes.member[(0u + _e563)].frame[3u];
                        let _e597 = (bitcast<f32>((((_e572 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e302);
                        let _e598 = (bitcast<f32>((((_e572 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e313);
                        let _e599 = (bitcast<f32>((((_e572 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e324);
                        let _e602 = nodes.member[(0u + _e563)].frame[0u];
                        let _e606 = nodes.member[(0u + _e563)].frame[1u];
                        let _e610 = nodes.member[(0u + _e563)].frame[2u];
                        let _e618 = ((bitcast<f32>(_e602) - _e156.origin.x) * _e302);
                        let _e619 = ((bitcast<f32>(_e606) - _e156.origin.y) * _e313);
                        let _e620 = ((bitcast<f32>(_e610) - _e156.origin.z) * _e324);
                        let _e628 = nodes.member[(0u + _e563)].x;
                        if (_e302 < 0f) {
                            let _e639 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e628.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e639.unnamed.word, _e628.w), _e639.unnamed_1);
                            let _e651 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e645.unnamed, lt_mask_LightPlace(_e628.x, _e645.unnamed_1.shift));
                            phi_1297_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e651.unnamed, lt_mask_LightPlace(_e651.unnamed_1.word, _e628.y));
                        } else {
                            let _e667 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e628.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e667.unnamed.word, _e628.y), _e667.unnamed_1);
                            let _e679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e673.unnamed, lt_mask_LightPlace(_e628.z, _e673.unnamed_1.shift));
                            phi_1297_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e679.unnamed, lt_mask_LightPlace(_e679.unnamed_1.word, _e628.w));
                        }
                        let _e687 = phi_1297_;
                        let _e697 = nodes.member[(0u + _e563)].y;
                        if (_e313 < 0f) {
                            let _e708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e697.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e708.unnamed.word, _e697.w), _e708.unnamed_1);
                            let _e720 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e714.unnamed, lt_mask_LightPlace(_e697.x, _e714.unnamed_1.shift));
                            phi_1324_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e720.unnamed, lt_mask_LightPlace(_e720.unnamed_1.word, _e697.y));
                        } else {
                            let _e736 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e697.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e742 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e736.unnamed.word, _e697.y), _e736.unnamed_1);
                            let _e748 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e742.unnamed, lt_mask_LightPlace(_e697.z, _e742.unnamed_1.shift));
                            phi_1324_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e748.unnamed, lt_mask_LightPlace(_e748.unnamed_1.word, _e697.w));
                        }
                        let _e756 = phi_1324_;
                        let _e766 = nodes.member[(0u + _e563)].z;
                        if (_e324 < 0f) {
                            let _e777 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e766.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e783 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e777.unnamed.word, _e766.w), _e777.unnamed_1);
                            let _e789 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e783.unnamed, lt_mask_LightPlace(_e766.x, _e783.unnamed_1.shift));
                            phi_1351_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e789.unnamed, lt_mask_LightPlace(_e789.unnamed_1.word, _e766.y));
                        } else {
                            let _e805 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e766.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e811 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e805.unnamed.word, _e766.y), _e805.unnamed_1);
                            let _e817 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e811.unnamed, lt_mask_LightPlace(_e766.z, _e811.unnamed_1.shift));
                            phi_1351_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e817.unnamed, lt_mask_LightPlace(_e817.unnamed_1.word, _e766.w));
                        }
                        let _e825 = phi_1351_;
                        phi_1357_ = 0u;
                        phi_1360_ = 0u;
                        loop {
                            let _e835 = phi_1357_;
                            let _e837 = phi_1360_;
                            local_3 = _e837;
                            local_4 = _e837;
                            local_5 = _e837;
                            let _e838 = (_e835 < 8u);
                            if _e838 {
                                let _e840 = (_e835 >> bitcast<u32>(2i));
                                let _e841 = (_e835 & 3u);
                                if (_e840 == 0u) {
                                    phi_1374_ = _e687.unnamed.word;
                                } else {
                                    phi_1374_ = _e687.unnamed.shift;
                                }
                                let _e844 = phi_1374_;
                                if (_e840 == 0u) {
                                    phi_1384_ = _e756.unnamed.word;
                                } else {
                                    phi_1384_ = _e756.unnamed.shift;
                                }
                                let _e853 = phi_1384_;
                                if (_e840 == 0u) {
                                    phi_1394_ = _e825.unnamed.word;
                                } else {
                                    phi_1394_ = _e825.unnamed.shift;
                                }
                                let _e862 = phi_1394_;
                                let _e875 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e844 >> bitcast<u32>(((_e841 * 8u) & 31u))) & 255u)) * _e597) + (_e618 - _e362)), ((f32(((_e853 >> bitcast<u32>(((_e841 * 8u) & 31u))) & 255u)) * _e598) + (_e619 - _e363)));
                                let _e876 = core_intrinsics_maximum_number_nsz_f32_(_e875, ((f32(((_e862 >> bitcast<u32>(((_e841 * 8u) & 31u))) & 255u)) * _e599) + (_e620 - _e364)));
                                if (_e840 == 0u) {
                                    phi_1412_ = _e687.unnamed_1.word;
                                } else {
                                    phi_1412_ = _e687.unnamed_1.shift;
                                }
                                let _e879 = phi_1412_;
                                if (_e840 == 0u) {
                                    phi_1422_ = _e756.unnamed_1.word;
                                } else {
                                    phi_1422_ = _e756.unnamed_1.shift;
                                }
                                let _e888 = phi_1422_;
                                if (_e840 == 0u) {
                                    phi_1432_ = _e825.unnamed_1.word;
                                } else {
                                    phi_1432_ = _e825.unnamed_1.shift;
                                }
                                let _e897 = phi_1432_;
                                let _e910 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e879 >> bitcast<u32>(((_e841 * 8u) & 31u))) & 255u)) * _e597) + (_e618 + _e362)), ((f32(((_e888 >> bitcast<u32>(((_e841 * 8u) & 31u))) & 255u)) * _e598) + (_e619 + _e363)));
                                let _e911 = core_intrinsics_minimum_number_nsz_f32_(_e910, ((f32(((_e897 >> bitcast<u32>(((_e841 * 8u) & 31u))) & 255u)) * _e599) + (_e620 + _e364)));
                                if (_e876 <= _e911) {
                                    if (_e876 <= _e561.t) {
                                        if (_e911 >= _e156.tmin) {
                                            if (_e840 == 0u) {
                                                let _e918 = nodes.member[(0u + _e563)].links[2u];
                                                phi_1468_ = _e918;
                                            } else {
                                                let _e921 = nodes.member[(0u + _e563)].links[3u];
                                                phi_1468_ = _e921;
                                            }
                                            let _e923 = phi_1468_;
                                            let _e928 = ((_e923 >> bitcast<u32>(((_e841 * 8u) & 31u))) & 255u);
                                            let _e929 = (_e928 & 31u);
                                            if (_e929 >= 24u) {
                                                phi_1481_ = (24u + ((_e929 - 24u) ^ _e423));
                                            } else {
                                                phi_1481_ = _e929;
                                            }
                                            let _e935 = phi_1481_;
                                            phi_1486_ = (_e837 | ((_e928 >> bitcast<u32>(5i)) << bitcast<u32>((_e935 & 31u))));
                                        } else {
                                            phi_1486_ = _e837;
                                        }
                                        let _e943 = phi_1486_;
                                        phi_1487_ = _e943;
                                    } else {
                                        phi_1487_ = _e837;
                                    }
                                    let _e945 = phi_1487_;
                                    phi_1488_ = _e945;
                                } else {
                                    phi_1488_ = _e837;
                                }
                                let _e947 = phi_1488_;
                                phi_1358_ = (_e835 + 1u);
                                phi_1361_ = _e947;
                            } else {
                                phi_1358_ = u32();
                                phi_1361_ = u32();
                            }
                            let _e950 = phi_1358_;
                            let _e952 = phi_1361_;
                            continue;
                            continuing {
                                phi_1357_ = _e950;
                                phi_1360_ = _e952;
                                break if !(_e838);
                            }
                        }
                        let _e956 = nodes.member[(0u + _e563)].links[0u];
                        let _e960 = nodes.member[(0u + _e563)].frame[3u];
                        let _e964 = local_3;
                        if ((_e964 & 4278190080u) == 0u) {
                        } else {
                            let _e968 = local_2.group_mask;
                            if ((_e968 & 4278190080u) == 0u) {
                            } else {
                                let _e972 = local_2.len;
                                if (_e972 < 32u) {
                                    let _e975 = local_2.group;
                                    let _e977 = local_2.len;
                                    if (_e977 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e977)] = _e975;
                                    let _e983 = local_2.group_mask;
                                    let _e985 = local_2.len;
                                    if (_e985 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e985)] = _e983;
                                    let _e992 = local_2.len;
                                    local_2.len = (_e992 + 1u);
                                }
                            }
                            local_2.group = (0u + _e956);
                            let _e996 = local_4;
                            local_2.group_mask = ((_e996 & 4278190080u) | (_e960 >> bitcast<u32>(24i)));
                        }
                        let _e1001 = local_5;
                        phi_1546_ = _e561;
                        phi_1549_ = (_e1001 & 16777215u);
                        loop {
                            let _e1004 = phi_1546_;
                            let _e1006 = phi_1549_;
                            local_6 = _e1004;
                            if (_e1006 == 0u) {
                                phi_1547_ = lt_bvh_Hit();
                                phi_1550_ = u32();
                                phi_2405_ = false;
                            } else {
                                let _e1010 = nodes.member[(0u + _e563)].links[1u];
                                let _e1015 = ((0u + _e1010) + select(firstTrailingBit(_e1006), 32u, (_e1006 == 0u)));
                                if (_e1015 < _e80) {
                                } else {
                                    return;
                                }
                                let _e1022 = triangles.member[(0u + _e1015)].v0_;
                                let _e1025 = (_e1022.x - _e156.origin.x);
                                let _e1028 = (_e1022.y - _e156.origin.y);
                                let _e1031 = (_e1022.z - _e156.origin.z);
                                if (_e390 == 0u) {
                                    phi_1596_ = vec3<f32>(_e1028, _e1031, _e1025);
                                } else {
                                    if (_e390 == 1u) {
                                        phi_1595_ = vec3<f32>(_e1031, _e1025, _e1028);
                                    } else {
                                        phi_1595_ = (_e1022 - _e156.origin);
                                    }
                                    let _e1038 = phi_1595_;
                                    phi_1596_ = _e1038;
                                }
                                let _e1040 = phi_1596_;
                                let _e1044 = (_e1040.x - (_e407 * _e1040.z));
                                let _e1048 = (_e1040.y - (_e410 * _e1040.z));
                                let _e1050 = triangles.member[(0u + _e1015)].v1_;
                                let _e1053 = (_e1050.x - _e156.origin.x);
                                let _e1056 = (_e1050.y - _e156.origin.y);
                                let _e1059 = (_e1050.z - _e156.origin.z);
                                if (_e390 == 0u) {
                                    phi_1628_ = vec3<f32>(_e1056, _e1059, _e1053);
                                } else {
                                    if (_e390 == 1u) {
                                        phi_1627_ = vec3<f32>(_e1059, _e1053, _e1056);
                                    } else {
                                        phi_1627_ = (_e1050 - _e156.origin);
                                    }
                                    let _e1066 = phi_1627_;
                                    phi_1628_ = _e1066;
                                }
                                let _e1068 = phi_1628_;
                                let _e1072 = (_e1068.x - (_e407 * _e1068.z));
                                let _e1076 = (_e1068.y - (_e410 * _e1068.z));
                                let _e1078 = triangles.member[(0u + _e1015)].v2_;
                                let _e1081 = (_e1078.x - _e156.origin.x);
                                let _e1084 = (_e1078.y - _e156.origin.y);
                                let _e1087 = (_e1078.z - _e156.origin.z);
                                if (_e390 == 0u) {
                                    phi_1660_ = vec3<f32>(_e1084, _e1087, _e1081);
                                } else {
                                    if (_e390 == 1u) {
                                        phi_1659_ = vec3<f32>(_e1087, _e1081, _e1084);
                                    } else {
                                        phi_1659_ = (_e1078 - _e156.origin);
                                    }
                                    let _e1094 = phi_1659_;
                                    phi_1660_ = _e1094;
                                }
                                let _e1096 = phi_1660_;
                                let _e1100 = (_e1096.x - (_e407 * _e1096.z));
                                let _e1104 = (_e1096.y - (_e410 * _e1096.z));
                                if (_e1072 < _e1100) {
                                    phi_1679_ = true;
                                } else {
                                    if (_e1072 == _e1100) {
                                        phi_1678_ = (_e1076 < _e1104);
                                    } else {
                                        phi_1678_ = false;
                                    }
                                    let _e1109 = phi_1678_;
                                    phi_1679_ = _e1109;
                                }
                                let _e1111 = phi_1679_;
                                if _e1111 {
                                    phi_1683_ = _e1104;
                                    phi_1684_ = _e1100;
                                    phi_1685_ = _e1076;
                                    phi_1686_ = _e1072;
                                } else {
                                    phi_1683_ = _e1076;
                                    phi_1684_ = _e1072;
                                    phi_1685_ = _e1104;
                                    phi_1686_ = _e1100;
                                }
                                let _e1113 = phi_1683_;
                                let _e1115 = phi_1684_;
                                let _e1117 = phi_1685_;
                                let _e1119 = phi_1686_;
                                let _e1122 = ((_e1119 * _e1113) - (_e1117 * _e1115));
                                if _e1111 {
                                    phi_1694_ = -(_e1122);
                                } else {
                                    phi_1694_ = _e1122;
                                }
                                let _e1125 = phi_1694_;
                                if (_e1100 < _e1044) {
                                    phi_1705_ = true;
                                } else {
                                    if (_e1100 == _e1044) {
                                        phi_1704_ = (_e1104 < _e1048);
                                    } else {
                                        phi_1704_ = false;
                                    }
                                    let _e1130 = phi_1704_;
                                    phi_1705_ = _e1130;
                                }
                                let _e1132 = phi_1705_;
                                if _e1132 {
                                    phi_1709_ = _e1048;
                                    phi_1710_ = _e1044;
                                    phi_1711_ = _e1104;
                                    phi_1712_ = _e1100;
                                } else {
                                    phi_1709_ = _e1104;
                                    phi_1710_ = _e1100;
                                    phi_1711_ = _e1048;
                                    phi_1712_ = _e1044;
                                }
                                let _e1134 = phi_1709_;
                                let _e1136 = phi_1710_;
                                let _e1138 = phi_1711_;
                                let _e1140 = phi_1712_;
                                let _e1143 = ((_e1140 * _e1134) - (_e1138 * _e1136));
                                if _e1132 {
                                    phi_1720_ = -(_e1143);
                                } else {
                                    phi_1720_ = _e1143;
                                }
                                let _e1146 = phi_1720_;
                                if (_e1044 < _e1072) {
                                    phi_1731_ = true;
                                } else {
                                    if (_e1044 == _e1072) {
                                        phi_1730_ = (_e1048 < _e1076);
                                    } else {
                                        phi_1730_ = false;
                                    }
                                    let _e1151 = phi_1730_;
                                    phi_1731_ = _e1151;
                                }
                                let _e1153 = phi_1731_;
                                if _e1153 {
                                    phi_1735_ = _e1076;
                                    phi_1736_ = _e1072;
                                    phi_1737_ = _e1048;
                                    phi_1738_ = _e1044;
                                } else {
                                    phi_1735_ = _e1048;
                                    phi_1736_ = _e1044;
                                    phi_1737_ = _e1076;
                                    phi_1738_ = _e1072;
                                }
                                let _e1155 = phi_1735_;
                                let _e1157 = phi_1736_;
                                let _e1159 = phi_1737_;
                                let _e1161 = phi_1738_;
                                let _e1164 = ((_e1161 * _e1155) - (_e1159 * _e1157));
                                if _e1153 {
                                    phi_1746_ = -(_e1164);
                                } else {
                                    phi_1746_ = _e1164;
                                }
                                let _e1167 = phi_1746_;
                                if (_e1125 >= 0f) {
                                    if (_e1146 >= 0f) {
                                        if (_e1167 >= 0f) {
                                            phi_1761_ = ((_e1125 + _e1146) + _e1167);
                                            phi_1762_ = false;
                                        } else {
                                            phi_1761_ = f32();
                                            phi_1762_ = true;
                                        }
                                        let _e1174 = phi_1761_;
                                        let _e1176 = phi_1762_;
                                        phi_1763_ = _e1174;
                                        phi_1764_ = _e1176;
                                    } else {
                                        phi_1763_ = f32();
                                        phi_1764_ = true;
                                    }
                                    let _e1178 = phi_1763_;
                                    let _e1180 = phi_1764_;
                                    phi_1765_ = _e1178;
                                    phi_1766_ = _e1180;
                                } else {
                                    phi_1765_ = f32();
                                    phi_1766_ = true;
                                }
                                let _e1182 = phi_1765_;
                                let _e1184 = phi_1766_;
                                if _e1184 {
                                    if (_e1125 <= 0f) {
                                        if (_e1146 <= 0f) {
                                            let _e1187 = (_e1167 <= 0f);
                                            if _e1187 {
                                            }
                                            phi_1784_ = ((_e1125 + _e1146) + _e1167);
                                            phi_1785_ = false;
                                            phi_1786_ = _e1187;
                                        } else {
                                            phi_1784_ = f32();
                                            phi_1785_ = true;
                                            phi_1786_ = false;
                                        }
                                        let _e1191 = phi_1784_;
                                        let _e1193 = phi_1785_;
                                        let _e1195 = phi_1786_;
                                        phi_1787_ = _e1191;
                                        phi_1788_ = _e1193;
                                        phi_1789_ = _e1195;
                                    } else {
                                        phi_1787_ = f32();
                                        phi_1788_ = true;
                                        phi_1789_ = false;
                                    }
                                    let _e1197 = phi_1787_;
                                    let _e1199 = phi_1788_;
                                    let _e1201 = phi_1789_;
                                    if _e1199 {
                                        phi_1793_ = false;
                                    } else {
                                        phi_1793_ = _e1201;
                                    }
                                    let _e1203 = phi_1793_;
                                    phi_1794_ = _e1197;
                                    phi_1795_ = _e1203;
                                } else {
                                    phi_1794_ = _e1182;
                                    phi_1795_ = true;
                                }
                                let _e1205 = phi_1794_;
                                let _e1207 = phi_1795_;
                                if _e1207 {
                                    let _e1208 = (_e1205 == 0f);
                                    if _e1208 {
                                        phi_2121_ = lt_bvh_triangle_Intersection();
                                        phi_2122_ = false;
                                    } else {
                                        let _e1210 = triangles.member[(0u + _e1015)].v0_;
                                        let _e1213 = (_e1210.x - _e156.origin.x);
                                        let _e1216 = (_e1210.y - _e156.origin.y);
                                        let _e1219 = (_e1210.z - _e156.origin.z);
                                        if (_e390 == 0u) {
                                            phi_1826_ = vec3<f32>(_e1216, _e1219, _e1213);
                                        } else {
                                            if (_e390 == 1u) {
                                                phi_1825_ = vec3<f32>(_e1219, _e1213, _e1216);
                                            } else {
                                                phi_1825_ = (_e1210 - _e156.origin);
                                            }
                                            let _e1226 = phi_1825_;
                                            phi_1826_ = _e1226;
                                        }
                                        let _e1228 = phi_1826_;
                                        let _e1230 = triangles.member[(0u + _e1015)].v1_;
                                        let _e1232 = triangles.member[(0u + _e1015)].v0_;
                                        let _e1235 = (_e1230.x - _e1232.x);
                                        let _e1238 = (_e1230.y - _e1232.y);
                                        let _e1241 = (_e1230.z - _e1232.z);
                                        if (_e390 == 0u) {
                                            phi_1852_ = vec3<f32>(_e1238, _e1241, _e1235);
                                        } else {
                                            if (_e390 == 1u) {
                                                phi_1851_ = vec3<f32>(_e1241, _e1235, _e1238);
                                            } else {
                                                phi_1851_ = (_e1230 - _e1232);
                                            }
                                            let _e1248 = phi_1851_;
                                            phi_1852_ = _e1248;
                                        }
                                        let _e1250 = phi_1852_;
                                        let _e1252 = triangles.member[(0u + _e1015)].v2_;
                                        let _e1254 = triangles.member[(0u + _e1015)].v0_;
                                        let _e1257 = (_e1252.x - _e1254.x);
                                        let _e1260 = (_e1252.y - _e1254.y);
                                        let _e1263 = (_e1252.z - _e1254.z);
                                        if (_e390 == 0u) {
                                            phi_1878_ = vec3<f32>(_e1260, _e1263, _e1257);
                                        } else {
                                            if (_e390 == 1u) {
                                                phi_1877_ = vec3<f32>(_e1263, _e1257, _e1260);
                                            } else {
                                                phi_1877_ = (_e1252 - _e1254);
                                            }
                                            let _e1270 = phi_1877_;
                                            phi_1878_ = _e1270;
                                        }
                                        let _e1272 = phi_1878_;
                                        let _e1279 = ((_e1250.y * _e1272.z) - (_e1250.z * _e1272.y));
                                        let _e1286 = ((_e1250.z * _e1272.x) - (_e1250.x * _e1272.z));
                                        let _e1293 = ((_e1250.x * _e1272.y) - (_e1250.y * _e1272.x));
                                        let _e1307 = (((1f / _e404.z) * (((_e1279 * _e1228.x) + (_e1286 * _e1228.y)) + (_e1293 * _e1228.z))) / (((_e1279 * _e407) + (_e1286 * _e410)) + _e1293));
                                        if (_e1307 > _e156.tmin) {
                                            if (_e1307 < _e156.tmax) {
                                                let _e1313 = triangles.member[(0u + _e1015)].v0_;
                                                let _e1315 = triangles.member[(0u + _e1015)].v1_;
                                                if (_e1313.x < _e1315.x) {
                                                    phi_1936_ = _e1313.x;
                                                } else {
                                                    phi_1936_ = _e1315.x;
                                                }
                                                let _e1322 = phi_1936_;
                                                if (_e1313.y < _e1315.y) {
                                                    phi_1945_ = _e1313.y;
                                                } else {
                                                    phi_1945_ = _e1315.y;
                                                }
                                                let _e1329 = phi_1945_;
                                                if (_e1313.z < _e1315.z) {
                                                    phi_1954_ = _e1313.z;
                                                } else {
                                                    phi_1954_ = _e1315.z;
                                                }
                                                let _e1336 = phi_1954_;
                                                let _e1338 = triangles.member[(0u + _e1015)].v2_;
                                                if (_e1322 < _e1338.x) {
                                                    phi_1963_ = _e1322;
                                                } else {
                                                    phi_1963_ = _e1338.x;
                                                }
                                                let _e1343 = phi_1963_;
                                                if (_e1329 < _e1338.y) {
                                                    phi_1970_ = _e1329;
                                                } else {
                                                    phi_1970_ = _e1338.y;
                                                }
                                                let _e1348 = phi_1970_;
                                                if (_e1336 < _e1338.z) {
                                                    phi_1977_ = _e1336;
                                                } else {
                                                    phi_1977_ = _e1338.z;
                                                }
                                                let _e1353 = phi_1977_;
                                                let _e1355 = triangles.member[(0u + _e1015)].v0_;
                                                let _e1357 = triangles.member[(0u + _e1015)].v1_;
                                                if (_e1355.x > _e1357.x) {
                                                    phi_1990_ = _e1355.x;
                                                } else {
                                                    phi_1990_ = _e1357.x;
                                                }
                                                let _e1364 = phi_1990_;
                                                if (_e1355.y > _e1357.y) {
                                                    phi_1999_ = _e1355.y;
                                                } else {
                                                    phi_1999_ = _e1357.y;
                                                }
                                                let _e1371 = phi_1999_;
                                                if (_e1355.z > _e1357.z) {
                                                    phi_2008_ = _e1355.z;
                                                } else {
                                                    phi_2008_ = _e1357.z;
                                                }
                                                let _e1378 = phi_2008_;
                                                let _e1380 = triangles.member[(0u + _e1015)].v2_;
                                                if (_e1364 > _e1380.x) {
                                                    phi_2017_ = _e1364;
                                                } else {
                                                    phi_2017_ = _e1380.x;
                                                }
                                                let _e1385 = phi_2017_;
                                                if (_e1371 > _e1380.y) {
                                                    phi_2024_ = _e1371;
                                                } else {
                                                    phi_2024_ = _e1380.y;
                                                }
                                                let _e1390 = phi_2024_;
                                                if (_e1378 > _e1380.z) {
                                                    phi_2031_ = _e1378;
                                                } else {
                                                    phi_2031_ = _e1380.z;
                                                }
                                                let _e1395 = phi_2031_;
                                                let _e1402 = ((_e1343 - _e156.origin.x) * _e302);
                                                let _e1403 = ((_e1348 - _e156.origin.y) * _e313);
                                                let _e1404 = ((_e1353 - _e156.origin.z) * _e324);
                                                let _e1411 = ((_e1385 - _e156.origin.x) * _e302);
                                                let _e1412 = ((_e1390 - _e156.origin.y) * _e313);
                                                let _e1413 = ((_e1395 - _e156.origin.z) * _e324);
                                                if (_e1402 < _e1411) {
                                                    phi_2054_ = _e1402;
                                                } else {
                                                    phi_2054_ = _e1411;
                                                }
                                                let _e1416 = phi_2054_;
                                                if (_e1403 < _e1412) {
                                                    phi_2059_ = _e1403;
                                                } else {
                                                    phi_2059_ = _e1412;
                                                }
                                                let _e1419 = phi_2059_;
                                                if (_e1404 < _e1413) {
                                                    phi_2064_ = _e1404;
                                                } else {
                                                    phi_2064_ = _e1413;
                                                }
                                                let _e1422 = phi_2064_;
                                                if (_e1402 > _e1411) {
                                                    phi_2072_ = _e1402;
                                                } else {
                                                    phi_2072_ = _e1411;
                                                }
                                                let _e1428 = phi_2072_;
                                                if (_e1403 > _e1412) {
                                                    phi_2077_ = _e1403;
                                                } else {
                                                    phi_2077_ = _e1412;
                                                }
                                                let _e1431 = phi_2077_;
                                                if (_e1404 > _e1413) {
                                                    phi_2082_ = _e1404;
                                                } else {
                                                    phi_2082_ = _e1413;
                                                }
                                                let _e1434 = phi_2082_;
                                                let _e1438 = core_intrinsics_maximum_number_nsz_f32_((_e1416 - _e369), (_e1419 - _e370));
                                                let _e1439 = core_intrinsics_maximum_number_nsz_f32_(_e1438, (_e1422 - _e371));
                                                let _e1440 = core_intrinsics_minimum_number_nsz_f32_((_e1428 + _e369), (_e1431 + _e370));
                                                let _e1441 = core_intrinsics_minimum_number_nsz_f32_(_e1440, (_e1434 + _e371));
                                                if (_e1439 > -300000000000000000000000000000000000000f) {
                                                    phi_2094_ = _e1439;
                                                } else {
                                                    phi_2094_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1444 = phi_2094_;
                                                if (_e1441 < 300000000000000000000000000000000000000f) {
                                                    phi_2099_ = _e1441;
                                                } else {
                                                    phi_2099_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1447 = phi_2099_;
                                                if (_e1307 < _e1444) {
                                                    phi_2104_ = _e1444;
                                                } else {
                                                    phi_2104_ = _e1307;
                                                }
                                                let _e1450 = phi_2104_;
                                                if (_e1450 > _e1447) {
                                                    phi_2109_ = _e1447;
                                                } else {
                                                    phi_2109_ = _e1450;
                                                }
                                                let _e1453 = phi_2109_;
                                                phi_2114_ = lt_bvh_triangle_Intersection(_e1453, (_e1146 / _e1205), (_e1167 / _e1205), (_e1444 <= _e1447));
                                                phi_2115_ = false;
                                            } else {
                                                phi_2114_ = lt_bvh_triangle_Intersection();
                                                phi_2115_ = true;
                                            }
                                            let _e1459 = phi_2114_;
                                            let _e1461 = phi_2115_;
                                            phi_2116_ = _e1459;
                                            phi_2117_ = _e1461;
                                        } else {
                                            phi_2116_ = lt_bvh_triangle_Intersection();
                                            phi_2117_ = true;
                                        }
                                        let _e1463 = phi_2116_;
                                        let _e1465 = phi_2117_;
                                        if _e1465 {
                                        }
                                        phi_2121_ = _e1463;
                                        phi_2122_ = _e1465;
                                    }
                                    let _e1467 = phi_2121_;
                                    let _e1469 = phi_2122_;
                                    phi_2123_ = _e1467;
                                    phi_2124_ = _e1208;
                                    phi_2125_ = _e1469;
                                } else {
                                    phi_2123_ = lt_bvh_triangle_Intersection();
                                    phi_2124_ = true;
                                    phi_2125_ = false;
                                }
                                let _e1471 = phi_2123_;
                                let _e1473 = phi_2124_;
                                let _e1475 = phi_2125_;
                                if _e1473 {
                                    phi_2129_ = true;
                                } else {
                                    phi_2129_ = _e1475;
                                }
                                let _e1477 = phi_2129_;
                                if _e1477 {
                                    phi_2133_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2133_ = _e1471;
                                }
                                let _e1479 = phi_2133_;
                                if _e1479.is_hit {
                                    if (_e1479.t > _e156.tmin) {
                                        if (_e1479.t < _e1004.t) {
                                            phi_2182_ = true;
                                        } else {
                                            if (_e1479.t == _e1004.t) {
                                                if (_e1004.triangle != 4294967295u) {
                                                    if (_e1015 < _e1004.triangle) {
                                                        phi_2173_ = true;
                                                    } else {
                                                        if (_e1015 == _e1004.triangle) {
                                                            phi_2172_ = (4294967295u < _e1004.instance);
                                                        } else {
                                                            phi_2172_ = false;
                                                        }
                                                        let _e1498 = phi_2172_;
                                                        phi_2173_ = _e1498;
                                                    }
                                                    let _e1500 = phi_2173_;
                                                    phi_2174_ = _e1500;
                                                    phi_2175_ = false;
                                                } else {
                                                    phi_2174_ = bool();
                                                    phi_2175_ = true;
                                                }
                                                let _e1502 = phi_2174_;
                                                let _e1504 = phi_2175_;
                                                phi_2176_ = _e1502;
                                                phi_2177_ = _e1504;
                                            } else {
                                                phi_2176_ = bool();
                                                phi_2177_ = true;
                                            }
                                            let _e1506 = phi_2176_;
                                            let _e1508 = phi_2177_;
                                            if _e1508 {
                                                phi_2181_ = false;
                                            } else {
                                                phi_2181_ = _e1506;
                                            }
                                            let _e1510 = phi_2181_;
                                            phi_2182_ = _e1510;
                                        }
                                        let _e1512 = phi_2182_;
                                        if _e1512 {
                                            let _e1514 = triangles.member[(0u + _e1015)].i0_;
                                            if ((_e1514 & 2147483648u) == 0u) {
                                                phi_2393_ = true;
                                            } else {
                                                if (_e1015 < _e80) {
                                                } else {
                                                    return;
                                                }
                                                let _e1523 = triangles.member[(0u + _e1015)].i0_;
                                                let _e1524 = (_e1523 & 2147483647u);
                                                let _e1526 = triangles.member[(0u + _e1015)].i1_;
                                                let _e1528 = triangles.member[(0u + _e1015)].i2_;
                                                if (_e1524 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1532 = vertices.member[(0u + _e1524)];
                                                if (_e1526 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1536 = vertices.member[(0u + _e1526)];
                                                if (_e1528 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1540 = vertices.member[(0u + _e1528)];
                                                let _e1541 = array<abi_Vertex, 3>(_e1532, _e1536, _e1540);
                                                if (_e1541[0].material < _e86) {
                                                } else {
                                                    return;
                                                }
                                                let _e1547 = materials.member[(0u + _e1541[0].material)];
                                                if ((_e1547.flags & 0u) == 0u) {
                                                    let _e1552 = ((1f - _e1479.u) - _e1479.v);
                                                    if (_e1547.cutoff <= 0f) {
                                                        phi_2388_ = true;
                                                    } else {
                                                        let _e1579 = (_e1547.base_color.w * ((((f32((_e1541[0].color >> bitcast<u32>(24i))) * _e1552) + (f32((_e1541[1].color >> bitcast<u32>(24i))) * _e1479.u)) + (f32((_e1541[2].color >> bitcast<u32>(24i))) * _e1479.v)) * (1f / 255f)));
                                                        if (_e1547.alpha_size == 0u) {
                                                            phi_2385_ = _e1579;
                                                        } else {
                                                            local_1.offset = _e1547.alpha_offset;
                                                            local_1.size = _e1547.alpha_size;
                                                            local_1.flags = _e1547.flags;
                                                            let _e1610 = _lt_shaders_texture_TextureView_quad((&local_1), (((_e1541[0].u * _e1552) + (_e1541[1].u * _e1479.u)) + (_e1541[2].u * _e1479.v)), (((_e1541[0].v * _e1552) + (_e1541[1].v * _e1479.u)) + (_e1541[2].v * _e1479.v)));
                                                            let _e1614 = (_e1610.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1614 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1618 = alpha_texels.member[(0u + _e1614)];
                                                            let _e1634 = (_e1610.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1634 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1638 = alpha_texels.member[(0u + _e1634)];
                                                            let _e1655 = (_e1610.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1655 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1659 = alpha_texels.member[(0u + _e1655)];
                                                            let _e1676 = (_e1610.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1676 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1680 = alpha_texels.member[(0u + _e1676)];
                                                            phi_2385_ = (_e1579 * (((((f32(((_e1618 >> bitcast<u32>((((_e1610.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1610.weights.x) + ((f32(((_e1638 >> bitcast<u32>((((_e1610.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1610.weights.y)) + ((f32(((_e1659 >> bitcast<u32>((((_e1610.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1610.weights.z)) + ((f32(((_e1680 >> bitcast<u32>((((_e1610.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1610.weights.w)));
                                                        }
                                                        let _e1696 = phi_2385_;
                                                        phi_2388_ = (_e1696 >= _e1547.cutoff);
                                                    }
                                                    let _e1700 = phi_2388_;
                                                    phi_2389_ = _e1700;
                                                } else {
                                                    phi_2389_ = false;
                                                }
                                                let _e1702 = phi_2389_;
                                                if _e1702 {
                                                }
                                                phi_2393_ = _e1702;
                                            }
                                            let _e1704 = phi_2393_;
                                            if _e1704 {
                                                phi_2401_ = lt_bvh_Hit(_e1479.t, _e1479.u, _e1479.v, _e1015, 4294967295u);
                                            } else {
                                                phi_2401_ = _e1004;
                                            }
                                            let _e1710 = phi_2401_;
                                            phi_2402_ = _e1710;
                                        } else {
                                            phi_2402_ = _e1004;
                                        }
                                        let _e1712 = phi_2402_;
                                        phi_2403_ = _e1712;
                                    } else {
                                        phi_2403_ = _e1004;
                                    }
                                    let _e1714 = phi_2403_;
                                    phi_2404_ = _e1714;
                                } else {
                                    phi_2404_ = _e1004;
                                }
                                let _e1716 = phi_2404_;
                                phi_1547_ = _e1716;
                                phi_1550_ = (_e1006 & (_e1006 - 1u));
                                phi_2405_ = true;
                            }
                            let _e1718 = phi_1547_;
                            let _e1720 = phi_1550_;
                            let _e1722 = phi_2405_;
                            continue;
                            continuing {
                                phi_1546_ = _e1718;
                                phi_1549_ = _e1720;
                                break if !(_e1722);
                            }
                        }
                        let _e1725 = local_2.group_mask;
                        if ((_e1725 & 4278190080u) == 0u) {
                            let _e1729 = local_2.len;
                            if (_e1729 == 0u) {
                                phi_2444_ = false;
                            } else {
                                let _e1733 = local_2.len;
                                local_2.len = (_e1733 - 1u);
                                let _e1736 = local_2.len;
                                if (_e1736 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1741 = local_2.first[(0u + _e1736)];
                                local_2.group = _e1741;
                                let _e1744 = local_2.len;
                                if (_e1744 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1749 = local_2.mask[(0u + _e1744)];
                                local_2.group_mask = _e1749;
                                phi_2444_ = true;
                            }
                            let _e1752 = phi_2444_;
                            phi_2445_ = _e1752;
                        } else {
                            phi_2445_ = true;
                        }
                        let _e1754 = phi_2445_;
                        if _e1754 {
                            let _e1756 = local_2.group_mask;
                            let _e1762 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1756)), 32u, (_e1756 == 0u)));
                            let _e1766 = local_2.group_mask;
                            let _e1780 = local_2.group_mask;
                            local_2.group_mask = (_e1780 & ~((1u << bitcast<u32>((_e1762 & 31u)))));
                            let _e1783 = local_2.group;
                            phi_2476_ = (_e1783 + countOneBits(((_e1766 & ~((4294967295u << bitcast<u32>((((_e1762 - 24u) ^ _e423) & 31u))))) & 255u)));
                        } else {
                            phi_2476_ = 4294967295u;
                        }
                        let _e1786 = phi_2476_;
                        let _e2631 = local_6;
                        phi_1210_ = _e2631;
                        phi_1213_ = _e1786;
                    } else {
                        phi_1210_ = lt_bvh_Hit();
                        phi_1213_ = u32();
                    }
                    let _e1788 = phi_1210_;
                    let _e1790 = phi_1213_;
                    continue;
                    continuing {
                        phi_1209_ = _e1788;
                        phi_1212_ = _e1790;
                        break if !(_e564);
                    }
                }
                let _e2635 = local_7;
                phi_2477_ = _e2635;
            }
            let _e1793 = phi_2477_;
            phi_2478_ = _e1793;
            phi_2479_ = _e220;
        } else {
            phi_2478_ = lt_bvh_Hit();
            phi_2479_ = true;
        }
        let _e1795 = phi_2478_;
        let _e1797 = phi_2479_;
        if _e1797 {
            phi_2483_ = _e158;
        } else {
            phi_2483_ = _e1795;
        }
        let _e1799 = phi_2483_;
        if (_e1799.triangle != 4294967295u) {
            let _e1805 = ((1f - _e1799.u) - _e1799.v);
            if (_e1799.triangle < _e80) {
            } else {
                return;
            }
            let _e1810 = triangles.member[(0u + _e1799.triangle)];
            let _e1835 = (((_e1810.v0_.x * _e1805) + (_e1810.v1_.x * _e1799.u)) + (_e1810.v2_.x * _e1799.v));
            let _e1836 = (((_e1810.v0_.y * _e1805) + (_e1810.v1_.y * _e1799.u)) + (_e1810.v2_.y * _e1799.v));
            let _e1837 = (((_e1810.v0_.z * _e1805) + (_e1810.v1_.z * _e1799.u)) + (_e1810.v2_.z * _e1799.v));
            let _e1840 = abs(_e1810.v0_.x);
            let _e1842 = abs(_e1810.v0_.y);
            let _e1844 = abs(_e1810.v0_.z);
            let _e1846 = abs(_e1810.v1_.x);
            let _e1848 = abs(_e1810.v1_.y);
            let _e1850 = abs(_e1810.v1_.z);
            if (_e1840 > _e1846) {
                phi_2547_ = _e1840;
            } else {
                phi_2547_ = _e1846;
            }
            let _e1853 = phi_2547_;
            if (_e1842 > _e1848) {
                phi_2552_ = _e1842;
            } else {
                phi_2552_ = _e1848;
            }
            let _e1856 = phi_2552_;
            if (_e1844 > _e1850) {
                phi_2557_ = _e1844;
            } else {
                phi_2557_ = _e1850;
            }
            let _e1859 = phi_2557_;
            let _e1861 = abs(_e1810.v2_.x);
            let _e1863 = abs(_e1810.v2_.y);
            let _e1865 = abs(_e1810.v2_.z);
            if (_e1853 > _e1861) {
                phi_2568_ = _e1853;
            } else {
                phi_2568_ = _e1861;
            }
            let _e1868 = phi_2568_;
            if (_e1856 > _e1863) {
                phi_2573_ = _e1856;
            } else {
                phi_2573_ = _e1863;
            }
            let _e1871 = phi_2573_;
            if (_e1859 > _e1865) {
                phi_2578_ = _e1859;
            } else {
                phi_2578_ = _e1865;
            }
            let _e1874 = phi_2578_;
            let _e1877 = (_e1810.v1_.x - _e1810.v0_.x);
            let _e1880 = (_e1810.v1_.y - _e1810.v0_.y);
            let _e1883 = (_e1810.v1_.z - _e1810.v0_.z);
            let _e1886 = (_e1810.v2_.x - _e1810.v0_.x);
            let _e1889 = (_e1810.v2_.y - _e1810.v0_.y);
            let _e1892 = (_e1810.v2_.z - _e1810.v0_.z);
            let _e1896 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1880), abs(_e1883));
            let _e1897 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1877), _e1896);
            let _e1898 = (_e1877 / _e1897);
            let _e1899 = (_e1880 / _e1897);
            let _e1900 = (_e1883 / _e1897);
            let _e1904 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1889), abs(_e1892));
            let _e1905 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1886), _e1904);
            let _e1906 = (_e1886 / _e1905);
            let _e1907 = (_e1889 / _e1905);
            let _e1908 = (_e1892 / _e1905);
            let _e1911 = ((_e1899 * _e1908) - (_e1907 * _e1900));
            let _e1914 = ((_e1900 * _e1906) - (_e1908 * _e1898));
            let _e1917 = ((_e1898 * _e1907) - (_e1906 * _e1899));
            let _e1919 = p.member.eye;
            let _e1932 = (1f / sqrt((((_e1911 * _e1911) + (_e1914 * _e1914)) + (_e1917 * _e1917))));
            let _e1933 = (_e1911 * _e1932);
            let _e1934 = (_e1914 * _e1932);
            let _e1935 = (_e1917 * _e1932);
            if ((((_e1933 * (_e1919.x - _e1835)) + (_e1934 * (_e1919.y - _e1836))) + (_e1935 * (_e1919.z - _e1837))) < 0f) {
                phi_2654_ = vec3<f32>(-(_e1933), -(_e1934), -(_e1935));
            } else {
                phi_2654_ = vec3<f32>(_e1933, _e1934, _e1935);
            }
            let _e1948 = phi_2654_;
            if (_e1799.triangle < _e80) {
            } else {
                return;
            }
            let _e1953 = triangles.member[(0u + _e1799.triangle)];
            let _e1955 = (_e1953.i0_ & 2147483647u);
            if (_e1955 < _e83) {
            } else {
                return;
            }
            let _e1961 = vertices.member[(0u + _e1955)];
            if (_e1953.i1_ < _e83) {
            } else {
                return;
            }
            let _e1965 = vertices.member[(0u + _e1953.i1_)];
            if (_e1953.i2_ < _e83) {
            } else {
                return;
            }
            let _e1969 = vertices.member[(0u + _e1953.i2_)];
            let _e1970 = array<abi_Vertex, 3>(_e1961, _e1965, _e1969);
            if (_e1970[0].material < _e86) {
            } else {
                return;
            }
            let _e1976 = materials.member[(0u + _e1970[0].material)];
            let _e1993 = (1f / 255f);
            let _e2012 = (1f / 255f);
            let _e2034 = (1f / 255f);
            if (_e1976.color_size == 0u) {
                phi_2897_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e1976.color_offset;
                local.size = _e1976.color_size;
                local.flags = _e1976.flags;
                let _e2077 = _lt_shaders_texture_TextureView_quad((&local), (((_e1970[0].u * _e1805) + (_e1970[1].u * _e1799.u)) + (_e1970[2].u * _e1799.v)), (((_e1970[0].v * _e1805) + (_e1970[1].v * _e1799.u)) + (_e1970[2].v * _e1799.v)));
                if (_e2077.indices[0] < _e95) {
                } else {
                    return;
                }
                let _e2083 = color_texels.member[(0u + _e2077.indices[0])];
                let _e2094 = (1f / 255f);
                if (_e2077.indices[1] < _e95) {
                } else {
                    return;
                }
                let _e2108 = color_texels.member[(0u + _e2077.indices[1])];
                let _e2119 = (1f / 255f);
                if (_e2077.indices[2] < _e95) {
                } else {
                    return;
                }
                let _e2136 = color_texels.member[(0u + _e2077.indices[2])];
                let _e2147 = (1f / 255f);
                if (_e2077.indices[3] < _e95) {
                } else {
                    return;
                }
                let _e2164 = color_texels.member[(0u + _e2077.indices[3])];
                let _e2175 = (1f / 255f);
                let _e2184 = (((((f32((_e2083 & 255u)) * _e2094) * _e2077.weights.x) + ((f32((_e2108 & 255u)) * _e2119) * _e2077.weights.y)) + ((f32((_e2136 & 255u)) * _e2147) * _e2077.weights.z)) + ((f32((_e2164 & 255u)) * _e2175) * _e2077.weights.w));
                let _e2185 = (((((f32(((_e2083 >> bitcast<u32>(8i)) & 255u)) * _e2094) * _e2077.weights.x) + ((f32(((_e2108 >> bitcast<u32>(8i)) & 255u)) * _e2119) * _e2077.weights.y)) + ((f32(((_e2136 >> bitcast<u32>(8i)) & 255u)) * _e2147) * _e2077.weights.z)) + ((f32(((_e2164 >> bitcast<u32>(8i)) & 255u)) * _e2175) * _e2077.weights.w));
                let _e2186 = (((((f32(((_e2083 >> bitcast<u32>(16i)) & 255u)) * _e2094) * _e2077.weights.x) + ((f32(((_e2108 >> bitcast<u32>(16i)) & 255u)) * _e2119) * _e2077.weights.y)) + ((f32(((_e2136 >> bitcast<u32>(16i)) & 255u)) * _e2147) * _e2077.weights.z)) + ((f32(((_e2164 >> bitcast<u32>(16i)) & 255u)) * _e2175) * _e2077.weights.w));
                phi_2897_ = vec3<f32>((_e2184 * _e2184), (_e2185 * _e2185), (_e2186 * _e2186));
            }
            let _e2192 = phi_2897_;
            let _e2194 = ((_e1976.base_color.x * ((((f32((_e1970[0].color & 255u)) * _e1993) * _e1805) + ((f32((_e1970[1].color & 255u)) * _e2012) * _e1799.u)) + ((f32((_e1970[2].color & 255u)) * _e2034) * _e1799.v))) * _e2192.x);
            let _e2196 = ((_e1976.base_color.y * ((((f32(((_e1970[0].color >> bitcast<u32>(8i)) & 255u)) * _e1993) * _e1805) + ((f32(((_e1970[1].color >> bitcast<u32>(8i)) & 255u)) * _e2012) * _e1799.u)) + ((f32(((_e1970[2].color >> bitcast<u32>(8i)) & 255u)) * _e2034) * _e1799.v))) * _e2192.y);
            let _e2198 = ((_e1976.base_color.z * ((((f32(((_e1970[0].color >> bitcast<u32>(16i)) & 255u)) * _e1993) * _e1805) + ((f32(((_e1970[1].color >> bitcast<u32>(16i)) & 255u)) * _e2012) * _e1799.u)) + ((f32(((_e1970[2].color >> bitcast<u32>(16i)) & 255u)) * _e2034) * _e1799.v))) * _e2192.z);
            let _e2199 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1871, _e1874);
            let _e2200 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1868, _e2199);
            if ((_e1976.flags & 2u) == 0u) {
                phi_2912_ = 0u;
            } else {
                phi_2912_ = 1u;
            }
            let _e2205 = phi_2912_;
            if (_e1970[0].normal == 2147516416u) {
                phi_3115_ = _e1948;
            } else {
                let _e2218 = (f32((bitcast<i32>((_e1970[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2224 = (f32((bitcast<i32>(_e1970[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2228 = ((1f - abs(_e2218)) - abs(_e2224));
                if (_e2228 < 0f) {
                    phi_2939_ = -(_e2228);
                } else {
                    phi_2939_ = 0f;
                }
                let _e2232 = phi_2939_;
                if (_e2218 < 0f) {
                    phi_2946_ = (_e2218 + _e2232);
                } else {
                    phi_2946_ = (_e2218 - _e2232);
                }
                let _e2237 = phi_2946_;
                if (_e2224 < 0f) {
                    phi_2953_ = (_e2224 + _e2232);
                } else {
                    phi_2953_ = (_e2224 - _e2232);
                }
                let _e2242 = phi_2953_;
                let _e2249 = (1f / sqrt((((_e2237 * _e2237) + (_e2242 * _e2242)) + (_e2228 * _e2228))));
                let _e2265 = (f32((bitcast<i32>((_e1970[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2271 = (f32((bitcast<i32>(_e1970[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2275 = ((1f - abs(_e2265)) - abs(_e2271));
                if (_e2275 < 0f) {
                    phi_2988_ = -(_e2275);
                } else {
                    phi_2988_ = 0f;
                }
                let _e2279 = phi_2988_;
                if (_e2265 < 0f) {
                    phi_2995_ = (_e2265 + _e2279);
                } else {
                    phi_2995_ = (_e2265 - _e2279);
                }
                let _e2284 = phi_2995_;
                if (_e2271 < 0f) {
                    phi_3002_ = (_e2271 + _e2279);
                } else {
                    phi_3002_ = (_e2271 - _e2279);
                }
                let _e2289 = phi_3002_;
                let _e2296 = (1f / sqrt((((_e2284 * _e2284) + (_e2289 * _e2289)) + (_e2275 * _e2275))));
                let _e2315 = (f32((bitcast<i32>((_e1970[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2321 = (f32((bitcast<i32>(_e1970[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2325 = ((1f - abs(_e2315)) - abs(_e2321));
                if (_e2325 < 0f) {
                    phi_3040_ = -(_e2325);
                } else {
                    phi_3040_ = 0f;
                }
                let _e2329 = phi_3040_;
                if (_e2315 < 0f) {
                    phi_3047_ = (_e2315 + _e2329);
                } else {
                    phi_3047_ = (_e2315 - _e2329);
                }
                let _e2334 = phi_3047_;
                if (_e2321 < 0f) {
                    phi_3054_ = (_e2321 + _e2329);
                } else {
                    phi_3054_ = (_e2321 - _e2329);
                }
                let _e2339 = phi_3054_;
                let _e2346 = (1f / sqrt((((_e2334 * _e2334) + (_e2339 * _e2339)) + (_e2325 * _e2325))));
                let _e2357 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2237 * _e2249) * _e1805) + ((_e2284 * _e2296) * _e1799.u)) + ((_e2334 * _e2346) * _e1799.v)), ((((_e2242 * _e2249) * _e1805) + ((_e2289 * _e2296) * _e1799.u)) + ((_e2339 * _e2346) * _e1799.v)), ((((_e2228 * _e2249) * _e1805) + ((_e2275 * _e2296) * _e1799.u)) + ((_e2325 * _e2346) * _e1799.v))));
                let _e2369 = sqrt((((_e2357.x * _e2357.x) + (_e2357.y * _e2357.y)) + (_e2357.z * _e2357.z)));
                if (_e2369 > 0f) {
                    let _e2372 = (_e2357.x / _e2369);
                    let _e2374 = (_e2357.y / _e2369);
                    let _e2376 = (_e2357.z / _e2369);
                    if ((((_e2372 * _e1948.x) + (_e2374 * _e1948.y)) + (_e2376 * _e1948.z)) < 0f) {
                        phi_3113_ = vec3<f32>(-(_e2372), -(_e2374), -(_e2376));
                    } else {
                        phi_3113_ = (_e2357 / vec3(_e2369));
                    }
                    let _e2393 = phi_3113_;
                    phi_3114_ = _e2393;
                } else {
                    phi_3114_ = _e1948;
                }
                let _e2395 = phi_3114_;
                phi_3115_ = _e2395;
            }
            let _e2397 = phi_3115_;
            if (_e2194 > 0f) {
                if (_e2194 < 1f) {
                    phi_3124_ = _e2194;
                } else {
                    phi_3124_ = 1f;
                }
                let _e2401 = phi_3124_;
                phi_3125_ = _e2401;
            } else {
                phi_3125_ = 0f;
            }
            let _e2403 = phi_3125_;
            if (_e2196 > 0f) {
                if (_e2196 < 1f) {
                    phi_3135_ = _e2196;
                } else {
                    phi_3135_ = 1f;
                }
                let _e2408 = phi_3135_;
                phi_3136_ = _e2408;
            } else {
                phi_3136_ = 0f;
            }
            let _e2410 = phi_3136_;
            if (_e2198 > 0f) {
                if (_e2198 < 1f) {
                    phi_3146_ = _e2198;
                } else {
                    phi_3146_ = 1f;
                }
                let _e2415 = phi_3146_;
                phi_3147_ = _e2415;
            } else {
                phi_3147_ = 0f;
            }
            let _e2417 = phi_3147_;
            let _e2420 = ((sqrt(_e2403) * 255f) + 0.5f);
            let _e2429 = ((sqrt(_e2410) * 255f) + 0.5f);
            let _e2441 = ((sqrt(_e2417) * 255f) + 0.5f);
            phi_3182_ = abi_Sample(vec3<f32>(_e1835, _e1836, _e1837), _e2200, _e1948, _e2205, _e2397, ((select(select(u32(_e2420), 0u, (_e2420 < bitcast<f32>(0u))), 4294967295u, (_e2420 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2429), 0u, (_e2429 < bitcast<f32>(0u))), 4294967295u, (_e2429 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2441), 0u, (_e2441 < bitcast<f32>(0u))), 4294967295u, (_e2441 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_3182_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2455 = phi_3182_;
        if (_e101.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e101.shift)] = _e2455;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_alpha_color_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
