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

struct type_31 {
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

struct type_35 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_39 {
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

struct type_43 {
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

struct type_51 {
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
var<storage> vertices: type_39;
@group(0) @binding(4) 
var<storage> materials: type_43;
@group(0) @binding(0) 
var<uniform> p: type_51;
@group(0) @binding(1) 
var<storage> nodes: type_31;
@group(0) @binding(2) 
var<storage> triangles: type_35;
@group(0) @binding(5) 
var<storage, read_write> samples: type_20;
@group(0) @binding(6) 
var<storage> alpha_texels: type_9;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_216_: lt_bvh_traverse_Tree;
    var phi_217_: bool;
    var phi_218_: lt_bvh_traverse_Tree;
    var phi_219_: bool;
    var phi_224_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_216_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_217_ = false;
        } else {
            phi_216_ = lt_bvh_traverse_Tree();
            phi_217_ = true;
        }
        let _e83 = phi_216_;
        let _e85 = phi_217_;
        phi_218_ = _e83;
        phi_219_ = _e85;
    } else {
        phi_218_ = lt_bvh_traverse_Tree();
        phi_219_ = true;
    }
    let _e87 = phi_218_;
    let _e89 = phi_219_;
    if _e89 {
        phi_224_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_224_ = _e87;
    }
    let _e94 = phi_224_;
    return lt_bvh_traverse_Tree(_e94.root, _e94.first_primitive);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_239_: bool;
    var phi_243_: f32;

    if (param_3 != param_3) {
        phi_239_ = true;
    } else {
        let _e73 = (param_4 >= param_3);
        if _e73 {
        }
        phi_239_ = _e73;
    }
    let _e75 = phi_239_;
    if _e75 {
        phi_243_ = param_4;
    } else {
        phi_243_ = param_3;
    }
    let _e77 = phi_243_;
    return _e77;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_255_: bool;
    var phi_259_: f32;

    if (param_5 != param_5) {
        phi_255_ = true;
    } else {
        let _e73 = (param_6 <= param_5);
        if _e73 {
        }
        phi_255_ = _e73;
    }
    let _e75 = phi_255_;
    if _e75 {
        phi_259_ = param_6;
    } else {
        phi_259_ = param_5;
    }
    let _e77 = phi_259_;
    return _e77;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_301_: f32;
    var phi_306_: f32;
    var phi_307_: bool;
    var phi_308_: f32;
    var phi_309_: bool;
    var phi_313_: f32;
    var phi_339_: f32;
    var phi_344_: f32;
    var phi_345_: bool;
    var phi_346_: f32;
    var phi_347_: bool;
    var phi_351_: f32;
    var phi_359_: f32;
    var phi_360_: f32;
    var phi_361_: f32;
    var phi_370_: f32;
    var phi_371_: f32;
    var phi_389_: u32;
    var phi_403_: u32;
    var phi_410_: u32;
    var phi_415_: u32;
    var phi_421_: u32;
    var phi_426_: u32;
    var phi_428_: texture_Axis;
    var phi_456_: f32;
    var phi_461_: f32;
    var phi_462_: bool;
    var phi_463_: f32;
    var phi_464_: bool;
    var phi_468_: f32;
    var phi_494_: f32;
    var phi_499_: f32;
    var phi_500_: bool;
    var phi_501_: f32;
    var phi_502_: bool;
    var phi_506_: f32;
    var phi_514_: f32;
    var phi_515_: f32;
    var phi_516_: f32;
    var phi_525_: f32;
    var phi_526_: f32;
    var phi_544_: u32;
    var phi_558_: u32;
    var phi_565_: u32;
    var phi_570_: u32;
    var phi_576_: u32;
    var phi_581_: u32;
    var phi_583_: texture_Axis;

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
                phi_301_ = 1f;
            } else {
                phi_301_ = 0f;
            }
            let _e104 = phi_301_;
            if (param_8 < 8388608f) {
                phi_306_ = (_e101 - _e104);
                phi_307_ = false;
            } else {
                phi_306_ = f32();
                phi_307_ = true;
            }
            let _e107 = phi_306_;
            let _e109 = phi_307_;
            phi_308_ = _e107;
            phi_309_ = _e109;
        } else {
            phi_308_ = f32();
            phi_309_ = true;
        }
        let _e111 = phi_308_;
        let _e113 = phi_309_;
        if _e113 {
            phi_313_ = param_8;
        } else {
            phi_313_ = _e111;
        }
        let _e115 = phi_313_;
        phi_361_ = (param_8 - _e115);
    } else {
        if (_e88 == 1u) {
            let _e118 = (param_8 * 0.5f);
            if (_e118 > -8388608f) {
                let _e130 = f32(select(0i, select(select(i32(_e118), i32(-2147483648), (_e118 < bitcast<f32>(3472883712u))), 2147483647i, (_e118 > bitcast<f32>(1325400063u))), (_e118 == _e118)));
                if (_e130 > _e118) {
                    phi_339_ = 1f;
                } else {
                    phi_339_ = 0f;
                }
                let _e133 = phi_339_;
                if (_e118 < 8388608f) {
                    phi_344_ = (_e130 - _e133);
                    phi_345_ = false;
                } else {
                    phi_344_ = f32();
                    phi_345_ = true;
                }
                let _e136 = phi_344_;
                let _e138 = phi_345_;
                phi_346_ = _e136;
                phi_347_ = _e138;
            } else {
                phi_346_ = f32();
                phi_347_ = true;
            }
            let _e140 = phi_346_;
            let _e142 = phi_347_;
            if _e142 {
                phi_351_ = _e118;
            } else {
                phi_351_ = _e140;
            }
            let _e144 = phi_351_;
            let _e146 = (param_8 - (2f * _e144));
            if (_e146 > 1f) {
                phi_359_ = (2f - _e146);
            } else {
                phi_359_ = _e146;
            }
            let _e150 = phi_359_;
            phi_360_ = _e150;
        } else {
            phi_360_ = param_8;
        }
        let _e152 = phi_360_;
        phi_361_ = _e152;
    }
    let _e154 = phi_361_;
    if (_e154 > 0f) {
        if (_e154 < 1f) {
            phi_370_ = _e154;
        } else {
            phi_370_ = 1f;
        }
        let _e158 = phi_370_;
        phi_371_ = _e158;
    } else {
        phi_371_ = 0f;
    }
    let _e160 = phi_371_;
    let _e161 = (_e75 - 1u);
    let _e163 = (_e160 * f32(_e75));
    if _e83 {
        let _e170 = select(select(u32(_e163), 0u, (_e163 < bitcast<f32>(0u))), 4294967295u, (_e163 > bitcast<f32>(1333788671u)));
        if (_e161 < _e170) {
            phi_389_ = _e161;
        } else {
            phi_389_ = _e170;
        }
        let _e173 = phi_389_;
        phi_428_ = texture_Axis(_e173, _e173, 0f);
    } else {
        let _e175 = (_e163 + 0.5f);
        let _e182 = select(select(u32(_e175), 0u, (_e175 < bitcast<f32>(0u))), 4294967295u, (_e175 > bitcast<f32>(1333788671u)));
        if (_e75 < _e182) {
            phi_403_ = _e75;
        } else {
            phi_403_ = _e182;
        }
        let _e185 = phi_403_;
        if (_e88 == 0u) {
            phi_410_ = _e161;
        } else {
            phi_410_ = 0u;
        }
        let _e190 = phi_410_;
        if (_e88 == 0u) {
            phi_415_ = 0u;
        } else {
            phi_415_ = _e161;
        }
        let _e193 = phi_415_;
        if (_e185 == 0u) {
            phi_421_ = _e190;
        } else {
            phi_421_ = (_e185 - 1u);
        }
        let _e197 = phi_421_;
        if (_e185 > _e161) {
            phi_426_ = _e193;
        } else {
            phi_426_ = _e185;
        }
        let _e200 = phi_426_;
        phi_428_ = texture_Axis(_e197, _e200, (_e175 - f32(_e185)));
    }
    let _e203 = phi_428_;
    let _e205 = (*param_7).flags;
    let _e208 = ((_e205 >> bitcast<u32>(6u)) & 3u);
    if (_e208 == 0u) {
        if (param_9 > -8388608f) {
            let _e221 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e221 > param_9) {
                phi_456_ = 1f;
            } else {
                phi_456_ = 0f;
            }
            let _e224 = phi_456_;
            if (param_9 < 8388608f) {
                phi_461_ = (_e221 - _e224);
                phi_462_ = false;
            } else {
                phi_461_ = f32();
                phi_462_ = true;
            }
            let _e227 = phi_461_;
            let _e229 = phi_462_;
            phi_463_ = _e227;
            phi_464_ = _e229;
        } else {
            phi_463_ = f32();
            phi_464_ = true;
        }
        let _e231 = phi_463_;
        let _e233 = phi_464_;
        if _e233 {
            phi_468_ = param_9;
        } else {
            phi_468_ = _e231;
        }
        let _e235 = phi_468_;
        phi_516_ = (param_9 - _e235);
    } else {
        if (_e208 == 1u) {
            let _e238 = (param_9 * 0.5f);
            if (_e238 > -8388608f) {
                let _e250 = f32(select(0i, select(select(i32(_e238), i32(-2147483648), (_e238 < bitcast<f32>(3472883712u))), 2147483647i, (_e238 > bitcast<f32>(1325400063u))), (_e238 == _e238)));
                if (_e250 > _e238) {
                    phi_494_ = 1f;
                } else {
                    phi_494_ = 0f;
                }
                let _e253 = phi_494_;
                if (_e238 < 8388608f) {
                    phi_499_ = (_e250 - _e253);
                    phi_500_ = false;
                } else {
                    phi_499_ = f32();
                    phi_500_ = true;
                }
                let _e256 = phi_499_;
                let _e258 = phi_500_;
                phi_501_ = _e256;
                phi_502_ = _e258;
            } else {
                phi_501_ = f32();
                phi_502_ = true;
            }
            let _e260 = phi_501_;
            let _e262 = phi_502_;
            if _e262 {
                phi_506_ = _e238;
            } else {
                phi_506_ = _e260;
            }
            let _e264 = phi_506_;
            let _e266 = (param_9 - (2f * _e264));
            if (_e266 > 1f) {
                phi_514_ = (2f - _e266);
            } else {
                phi_514_ = _e266;
            }
            let _e270 = phi_514_;
            phi_515_ = _e270;
        } else {
            phi_515_ = param_9;
        }
        let _e272 = phi_515_;
        phi_516_ = _e272;
    }
    let _e274 = phi_516_;
    if (_e274 > 0f) {
        if (_e274 < 1f) {
            phi_525_ = _e274;
        } else {
            phi_525_ = 1f;
        }
        let _e278 = phi_525_;
        phi_526_ = _e278;
    } else {
        phi_526_ = 0f;
    }
    let _e280 = phi_526_;
    let _e281 = (_e79 - 1u);
    let _e283 = (_e280 * f32(_e79));
    if _e83 {
        let _e290 = select(select(u32(_e283), 0u, (_e283 < bitcast<f32>(0u))), 4294967295u, (_e283 > bitcast<f32>(1333788671u)));
        if (_e281 < _e290) {
            phi_544_ = _e281;
        } else {
            phi_544_ = _e290;
        }
        let _e293 = phi_544_;
        phi_583_ = texture_Axis(_e293, _e293, 0f);
    } else {
        let _e295 = (_e283 + 0.5f);
        let _e302 = select(select(u32(_e295), 0u, (_e295 < bitcast<f32>(0u))), 4294967295u, (_e295 > bitcast<f32>(1333788671u)));
        if (_e79 < _e302) {
            phi_558_ = _e79;
        } else {
            phi_558_ = _e302;
        }
        let _e305 = phi_558_;
        if (_e208 == 0u) {
            phi_565_ = _e281;
        } else {
            phi_565_ = 0u;
        }
        let _e310 = phi_565_;
        if (_e208 == 0u) {
            phi_570_ = 0u;
        } else {
            phi_570_ = _e281;
        }
        let _e313 = phi_570_;
        if (_e305 == 0u) {
            phi_576_ = _e310;
        } else {
            phi_576_ = (_e305 - 1u);
        }
        let _e317 = phi_576_;
        if (_e305 > _e281) {
            phi_581_ = _e313;
        } else {
            phi_581_ = _e305;
        }
        let _e320 = phi_581_;
        phi_583_ = texture_Axis(_e317, _e320, (_e295 - f32(_e305)));
    }
    let _e323 = phi_583_;
    let _e327 = (*param_7).offset;
    let _e334 = (*param_7).offset;
    let _e341 = (*param_7).offset;
    let _e348 = (*param_7).offset;
    return texture_TexelQuad(array<u32, 4>(((_e327 + (_e323.low * _e75)) + _e203.low), ((_e334 + (_e323.low * _e75)) + _e203.high), ((_e341 + (_e323.high * _e75)) + _e203.low), ((_e348 + (_e323.high * _e75)) + _e203.high)), vec4<f32>(((1f - _e203.fraction) * (1f - _e323.fraction)), (_e203.fraction * (1f - _e323.fraction)), ((1f - _e203.fraction) * _e323.fraction), (_e203.fraction * _e323.fraction)));
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(param_10: vec3<f32>) -> vec3<f32> {
    return param_10;
}

fn _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(param_11: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(1f, 1f, 1f);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_12: f32, param_13: f32) -> f32 {
    var phi_3066_: f32;

    if (param_12 > param_13) {
        phi_3066_ = param_12;
    } else {
        phi_3066_ = param_13;
    }
    let _e74 = phi_3066_;
    return _e74;
}

fn _lt_bvh_ray_Ray_new(param_14: vec3<f32>, param_15: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_14, 0f, param_15, 300000000000000000000000000000000000000f);
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var phi_771_: bool;
    var phi_772_: bool;
    var phi_773_: bool;
    var phi_774_: bool;
    var phi_778_: bool;
    var phi_791_: bool;
    var phi_792_: bool;
    var phi_793_: bool;
    var phi_794_: bool;
    var phi_798_: bool;
    var phi_811_: bool;
    var phi_812_: bool;
    var phi_813_: bool;
    var phi_817_: bool;
    var phi_818_: bool;
    var phi_819_: bool;
    var phi_820_: bool;
    var phi_821_: bool;
    var phi_825_: bool;
    var phi_901_: f32;
    var phi_908_: f32;
    var phi_916_: f32;
    var phi_923_: f32;
    var phi_931_: f32;
    var phi_938_: f32;
    var phi_961_: f32;
    var phi_966_: f32;
    var phi_971_: f32;
    var phi_976_: f32;
    var phi_981_: f32;
    var phi_1012_: bool;
    var phi_1013_: bool;
    var phi_1021_: u32;
    var phi_1022_: u32;
    var phi_1039_: vec3<f32>;
    var phi_1040_: vec3<f32>;
    var phi_1053_: u32;
    var phi_1058_: u32;
    var phi_1063_: u32;
    var phi_1177_: bool;
    var phi_1178_: bool;
    var phi_1209_: u32;
    var phi_1211_: lt_bvh_Hit;
    var phi_1214_: u32;
    var phi_1299_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1326_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1353_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1359_: u32;
    var phi_1362_: u32;
    var phi_1376_: u32;
    var phi_1386_: u32;
    var phi_1396_: u32;
    var phi_1414_: u32;
    var phi_1424_: u32;
    var phi_1434_: u32;
    var phi_1470_: u32;
    var phi_1483_: u32;
    var phi_1488_: u32;
    var phi_1489_: u32;
    var phi_1490_: u32;
    var phi_1360_: u32;
    var phi_1363_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1548_: lt_bvh_Hit;
    var phi_1551_: u32;
    var phi_1597_: vec3<f32>;
    var phi_1598_: vec3<f32>;
    var phi_1629_: vec3<f32>;
    var phi_1630_: vec3<f32>;
    var phi_1661_: vec3<f32>;
    var phi_1662_: vec3<f32>;
    var phi_1680_: bool;
    var phi_1681_: bool;
    var phi_1685_: f32;
    var phi_1686_: f32;
    var phi_1687_: f32;
    var phi_1688_: f32;
    var phi_1696_: f32;
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
    var phi_1763_: f32;
    var phi_1764_: bool;
    var phi_1765_: f32;
    var phi_1766_: bool;
    var phi_1767_: f32;
    var phi_1768_: bool;
    var phi_1786_: f32;
    var phi_1787_: bool;
    var phi_1788_: bool;
    var phi_1789_: f32;
    var phi_1790_: bool;
    var phi_1791_: bool;
    var phi_1795_: bool;
    var phi_1796_: f32;
    var phi_1797_: bool;
    var phi_1827_: vec3<f32>;
    var phi_1828_: vec3<f32>;
    var phi_1853_: vec3<f32>;
    var phi_1854_: vec3<f32>;
    var phi_1879_: vec3<f32>;
    var phi_1880_: vec3<f32>;
    var phi_1938_: f32;
    var phi_1947_: f32;
    var phi_1956_: f32;
    var phi_1965_: f32;
    var phi_1972_: f32;
    var phi_1979_: f32;
    var phi_1992_: f32;
    var phi_2001_: f32;
    var phi_2010_: f32;
    var phi_2019_: f32;
    var phi_2026_: f32;
    var phi_2033_: f32;
    var phi_2056_: f32;
    var phi_2061_: f32;
    var phi_2066_: f32;
    var phi_2074_: f32;
    var phi_2079_: f32;
    var phi_2084_: f32;
    var phi_2096_: f32;
    var phi_2101_: f32;
    var phi_2106_: f32;
    var phi_2111_: f32;
    var phi_2116_: lt_bvh_triangle_Intersection;
    var phi_2117_: bool;
    var phi_2118_: lt_bvh_triangle_Intersection;
    var phi_2119_: bool;
    var phi_2123_: lt_bvh_triangle_Intersection;
    var phi_2124_: bool;
    var phi_2125_: lt_bvh_triangle_Intersection;
    var phi_2126_: bool;
    var phi_2127_: bool;
    var phi_2131_: bool;
    var phi_2135_: lt_bvh_triangle_Intersection;
    var phi_2174_: bool;
    var phi_2175_: bool;
    var phi_2176_: bool;
    var phi_2177_: bool;
    var phi_2178_: bool;
    var phi_2179_: bool;
    var phi_2183_: bool;
    var phi_2184_: bool;
    var phi_2387_: f32;
    var phi_2390_: bool;
    var phi_2391_: bool;
    var phi_2395_: bool;
    var phi_2403_: lt_bvh_Hit;
    var phi_2404_: lt_bvh_Hit;
    var phi_2405_: lt_bvh_Hit;
    var phi_2406_: lt_bvh_Hit;
    var phi_1549_: lt_bvh_Hit;
    var phi_1552_: u32;
    var phi_2407_: bool;
    var phi_2446_: bool;
    var phi_2447_: bool;
    var phi_2478_: u32;
    var phi_1212_: lt_bvh_Hit;
    var phi_1215_: u32;
    var phi_2479_: lt_bvh_Hit;
    var phi_2480_: lt_bvh_Hit;
    var phi_2481_: bool;
    var phi_2485_: lt_bvh_Hit;
    var phi_2550_: f32;
    var phi_2555_: f32;
    var phi_2560_: f32;
    var phi_2571_: f32;
    var phi_2576_: f32;
    var phi_2581_: f32;
    var phi_2657_: vec3<f32>;
    var phi_2778_: u32;
    var phi_2805_: f32;
    var phi_2812_: f32;
    var phi_2819_: f32;
    var phi_2854_: f32;
    var phi_2861_: f32;
    var phi_2868_: f32;
    var phi_2906_: f32;
    var phi_2913_: f32;
    var phi_2920_: f32;
    var phi_2979_: vec3<f32>;
    var phi_2980_: vec3<f32>;
    var phi_2981_: vec3<f32>;
    var phi_2990_: f32;
    var phi_2991_: f32;
    var phi_3001_: f32;
    var phi_3002_: f32;
    var phi_3012_: f32;
    var phi_3013_: f32;
    var phi_3048_: abi_Sample;
    var local_5: lt_bvh_Hit;
    var local_6: lt_bvh_Hit;

    let _e72 = id_1;
    let _e76 = arrayLength((&nodes.member));
    let _e79 = arrayLength((&triangles.member));
    let _e82 = arrayLength((&vertices.member));
    let _e85 = arrayLength((&materials.member));
    let _e91 = arrayLength((&alpha_texels.member));
    let _e94 = p.member.size[0u];
    let _e96 = p.member.size[1u];
    let _e97 = lt_shaders_entry_pixel_index(_e72, _e94, _e96);
    if (bitcast<i32>(_e97.root) != 0i) {
        let _e105 = p.member.eye;
        let _e108 = p.member.grid[0u];
        let _e110 = p.member.grid[1u];
        let _e129 = p.member.size[0u];
        let _e133 = ((((f32(_e72.x) + ((f32((_e72.y & (_e110 - 1u))) + 0.5f) / f32(_e110))) / f32(_e129)) * 2f) - 1f);
        let _e136 = p.member.size[1u];
        let _e140 = (1f - (((f32(_e72.y) + ((f32((_e72.x & (_e108 - 1u))) + 0.5f) / f32(_e108))) / f32(_e136)) * 2f));
        let _e142 = p.member.forward;
        let _e144 = p.member.right;
        let _e158 = p.member.up;
        let _e169 = _lt_bvh_ray_Ray_new(_e105, vec3<f32>(((_e142.x + (_e144.x * _e133)) + (_e158.x * _e140)), ((_e142.y + (_e144.y * _e133)) + (_e158.y * _e140)), ((_e142.z + (_e144.z * _e133)) + (_e158.z * _e140))));
        let _e171 = lt_bvh_Hit(_e169.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e174 = abs(_e169.direction.x);
        let _e176 = abs(_e169.direction.y);
        let _e178 = abs(_e169.direction.z);
        if (abs(_e169.origin.x) < 1000000000000000f) {
            if (abs(_e169.origin.y) < 1000000000000000f) {
                phi_771_ = (abs(_e169.origin.z) < 1000000000000000f);
                phi_772_ = false;
            } else {
                phi_771_ = bool();
                phi_772_ = true;
            }
            let _e190 = phi_771_;
            let _e192 = phi_772_;
            phi_773_ = _e190;
            phi_774_ = _e192;
        } else {
            phi_773_ = bool();
            phi_774_ = true;
        }
        let _e194 = phi_773_;
        let _e196 = phi_774_;
        if _e196 {
            phi_778_ = false;
        } else {
            phi_778_ = _e194;
        }
        let _e198 = phi_778_;
        if _e198 {
            if (_e174 < 1000000000000000f) {
                if (_e176 < 1000000000000000f) {
                    phi_791_ = (_e178 < 1000000000000000f);
                    phi_792_ = false;
                } else {
                    phi_791_ = bool();
                    phi_792_ = true;
                }
                let _e203 = phi_791_;
                let _e205 = phi_792_;
                phi_793_ = _e203;
                phi_794_ = _e205;
            } else {
                phi_793_ = bool();
                phi_794_ = true;
            }
            let _e207 = phi_793_;
            let _e209 = phi_794_;
            if _e209 {
                phi_798_ = false;
            } else {
                phi_798_ = _e207;
            }
            let _e211 = phi_798_;
            if _e211 {
                if (_e174 > 0f) {
                    phi_812_ = bool();
                    phi_813_ = true;
                } else {
                    let _e213 = (_e176 > 0f);
                    if _e213 {
                        phi_811_ = bool();
                    } else {
                        phi_811_ = (_e178 > 0f);
                    }
                    let _e216 = phi_811_;
                    phi_812_ = _e216;
                    phi_813_ = _e213;
                }
                let _e218 = phi_812_;
                let _e220 = phi_813_;
                if _e220 {
                    phi_817_ = true;
                } else {
                    phi_817_ = _e218;
                }
                let _e222 = phi_817_;
                phi_818_ = _e222;
                phi_819_ = false;
            } else {
                phi_818_ = bool();
                phi_819_ = true;
            }
            let _e224 = phi_818_;
            let _e226 = phi_819_;
            phi_820_ = _e224;
            phi_821_ = _e226;
        } else {
            phi_820_ = bool();
            phi_821_ = true;
        }
        let _e228 = phi_820_;
        let _e230 = phi_821_;
        if _e230 {
            phi_825_ = false;
        } else {
            phi_825_ = _e228;
        }
        let _e232 = phi_825_;
        if _e232 {
            let _e233 = (0u >= _e76);
            if _e233 {
                phi_2479_ = lt_bvh_Hit();
            } else {
                if (0u < _e76) {
                } else {
                    return;
                }
                let _e239 = nodes.member[(0u + 0u)].frame[0u];
                let _e243 = nodes.member[(0u + 0u)].frame[1u];
                let _e247 = nodes.member[(0u + 0u)].frame[2u];
                let _e251 = nodes.member[(0u + 0u)].frame[0u];
                let _e255 = nodes.member[(0u + 0u)].frame[1u];
                let _e259 = nodes.member[(0u + 0u)].frame[2u];
                let _e263 = nodes.member[(0u + 0u)].frame[3u];
                let _e302 = core_intrinsics_maximum_number_nsz_f32_(abs(_e169.direction.x), abs(_e169.direction.y));
                let _e303 = core_intrinsics_maximum_number_nsz_f32_(_e302, abs(_e169.direction.z));
                let _e304 = (_e303 * 0.0000000000009094947f);
                if (abs(_e169.direction.x) < _e304) {
                    phi_901_ = _e304;
                } else {
                    phi_901_ = abs(_e169.direction.x);
                }
                let _e310 = phi_901_;
                if (_e169.direction.x < 0f) {
                    phi_908_ = (-1f / _e310);
                } else {
                    phi_908_ = (1f / _e310);
                }
                let _e315 = phi_908_;
                if (abs(_e169.direction.y) < _e304) {
                    phi_916_ = _e304;
                } else {
                    phi_916_ = abs(_e169.direction.y);
                }
                let _e321 = phi_916_;
                if (_e169.direction.y < 0f) {
                    phi_923_ = (-1f / _e321);
                } else {
                    phi_923_ = (1f / _e321);
                }
                let _e326 = phi_923_;
                if (abs(_e169.direction.z) < _e304) {
                    phi_931_ = _e304;
                } else {
                    phi_931_ = abs(_e169.direction.z);
                }
                let _e332 = phi_931_;
                if (_e169.direction.z < 0f) {
                    phi_938_ = (-1f / _e332);
                } else {
                    phi_938_ = (1f / _e332);
                }
                let _e337 = phi_938_;
                let _e344 = abs((bitcast<f32>(_e239) - _e169.origin.x));
                let _e345 = abs((bitcast<f32>(_e243) - _e169.origin.y));
                let _e346 = abs((bitcast<f32>(_e247) - _e169.origin.z));
                let _e353 = abs(((bitcast<f32>(_e251) + (bitcast<f32>((((_e263 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e169.origin.x));
                let _e354 = abs(((bitcast<f32>(_e255) + (bitcast<f32>((((_e263 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e169.origin.y));
                let _e355 = abs(((bitcast<f32>(_e259) + (bitcast<f32>((((_e263 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e169.origin.z));
                if (_e344 > _e353) {
                    phi_961_ = _e344;
                } else {
                    phi_961_ = _e353;
                }
                let _e358 = phi_961_;
                if (_e345 > _e354) {
                    phi_966_ = _e345;
                } else {
                    phi_966_ = _e354;
                }
                let _e361 = phi_966_;
                if (_e346 > _e355) {
                    phi_971_ = _e346;
                } else {
                    phi_971_ = _e355;
                }
                let _e364 = phi_971_;
                if (_e358 > _e361) {
                    phi_976_ = _e358;
                } else {
                    phi_976_ = _e361;
                }
                let _e367 = phi_976_;
                if (_e367 > _e364) {
                    phi_981_ = _e367;
                } else {
                    phi_981_ = _e364;
                }
                let _e370 = phi_981_;
                let _e374 = (_e370 * 0.0000019073486f);
                let _e375 = (abs(_e315) * _e374);
                let _e376 = (abs(_e326) * _e374);
                let _e377 = (abs(_e337) * _e374);
                let _e381 = (_e370 * 0.0000009536743f);
                let _e382 = (abs(_e315) * _e381);
                let _e383 = (abs(_e326) * _e381);
                let _e384 = (abs(_e337) * _e381);
                let _e388 = abs(_e169.direction.x);
                let _e390 = abs(_e169.direction.y);
                let _e392 = abs(_e169.direction.z);
                if (_e388 >= _e390) {
                    if (_e388 >= _e392) {
                        phi_1012_ = false;
                    } else {
                        phi_1012_ = true;
                    }
                    let _e396 = phi_1012_;
                    phi_1013_ = _e396;
                } else {
                    phi_1013_ = true;
                }
                let _e398 = phi_1013_;
                if _e398 {
                    if (_e390 >= _e392) {
                        phi_1021_ = 1u;
                    } else {
                        phi_1021_ = 2u;
                    }
                    let _e401 = phi_1021_;
                    phi_1022_ = _e401;
                } else {
                    phi_1022_ = 0u;
                }
                let _e403 = phi_1022_;
                if (_e403 == 0u) {
                    phi_1040_ = vec3<f32>(_e169.direction.y, _e169.direction.z, _e169.direction.x);
                } else {
                    if (_e403 == 1u) {
                        phi_1039_ = vec3<f32>(_e169.direction.z, _e169.direction.x, _e169.direction.y);
                    } else {
                        phi_1039_ = _e169.direction;
                    }
                    let _e415 = phi_1039_;
                    phi_1040_ = _e415;
                }
                let _e417 = phi_1040_;
                let _e420 = (_e417.x / _e417.z);
                let _e423 = (_e417.y / _e417.z);
                if (_e315 < 0f) {
                    phi_1053_ = 0u;
                } else {
                    phi_1053_ = 1u;
                }
                let _e428 = phi_1053_;
                if (_e326 < 0f) {
                    phi_1058_ = 0u;
                } else {
                    phi_1058_ = 2u;
                }
                let _e431 = phi_1058_;
                if (_e337 < 0f) {
                    phi_1063_ = 0u;
                } else {
                    phi_1063_ = 4u;
                }
                let _e434 = phi_1063_;
                let _e436 = ((_e428 | _e431) | _e434);
                let _e437 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e437.first[0], _e437.first[1], _e437.first[2], _e437.first[3], _e437.first[4], _e437.first[5], _e437.first[6], _e437.first[7], _e437.first[8], _e437.first[9], _e437.first[10], _e437.first[11], _e437.first[12], _e437.first[13], _e437.first[14], _e437.first[15], _e437.first[16], _e437.first[17], _e437.first[18], _e437.first[19], _e437.first[20], _e437.first[21], _e437.first[22], _e437.first[23], _e437.first[24], _e437.first[25], _e437.first[26], _e437.first[27], _e437.first[28], _e437.first[29], _e437.first[30], _e437.first[31]), array<u32, 32>(_e437.mask[0], _e437.mask[1], _e437.mask[2], _e437.mask[3], _e437.mask[4], _e437.mask[5], _e437.mask[6], _e437.mask[7], _e437.mask[8], _e437.mask[9], _e437.mask[10], _e437.mask[11], _e437.mask[12], _e437.mask[13], _e437.mask[14], _e437.mask[15], _e437.mask[16], _e437.mask[17], _e437.mask[18], _e437.mask[19], _e437.mask[20], _e437.mask[21], _e437.mask[22], _e437.mask[23], _e437.mask[24], _e437.mask[25], _e437.mask[26], _e437.mask[27], _e437.mask[28], _e437.mask[29], _e437.mask[30], _e437.mask[31]), _e437.len, _e437.group, _e437.group_mask);
                let _e511 = local_1.group_mask;
                if ((_e511 & 4278190080u) == 0u) {
                    let _e515 = local_1.len;
                    if (_e515 == 0u) {
                        phi_1177_ = false;
                    } else {
                        let _e519 = local_1.len;
                        local_1.len = (_e519 - 1u);
                        let _e522 = local_1.len;
                        if (_e522 < 32u) {
                        } else {
                            return;
                        }
                        let _e527 = local_1.first[(0u + _e522)];
                        local_1.group = _e527;
                        let _e530 = local_1.len;
                        if (_e530 < 32u) {
                        } else {
                            return;
                        }
                        let _e535 = local_1.mask[(0u + _e530)];
                        local_1.group_mask = _e535;
                        phi_1177_ = true;
                    }
                    let _e538 = phi_1177_;
                    phi_1178_ = _e538;
                } else {
                    phi_1178_ = true;
                }
                let _e540 = phi_1178_;
                if _e540 {
                    let _e542 = local_1.group_mask;
                    let _e548 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e542)), 32u, (_e542 == 0u)));
                    let _e552 = local_1.group_mask;
                    let _e566 = local_1.group_mask;
                    local_1.group_mask = (_e566 & ~((1u << bitcast<u32>((_e548 & 31u)))));
                    let _e569 = local_1.group;
                    phi_1209_ = (_e569 + countOneBits(((_e552 & ~((4294967295u << bitcast<u32>((((_e548 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1209_ = 4294967295u;
                }
                let _e572 = phi_1209_;
                phi_1211_ = _e171;
                phi_1214_ = _e572;
                loop {
                    let _e574 = phi_1211_;
                    let _e576 = phi_1214_;
                    local_6 = _e574;
                    let _e577 = (_e576 != 4294967295u);
                    if _e577 {
                        if (_e576 < _e76) {
                        } else {
                            return;
                        }
                        let _e585 = nodes.member[(0u + _e576)].frame[3u];
                        let _e610 = (bitcast<f32>((((_e585 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e315);
                        let _e611 = (bitcast<f32>((((_e585 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e326);
                        let _e612 = (bitcast<f32>((((_e585 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e337);
                        let _e615 = nodes.member[(0u + _e576)].frame[0u];
                        let _e619 = nodes.member[(0u + _e576)].frame[1u];
                        let _e623 = nodes.member[(0u + _e576)].frame[2u];
                        let _e631 = ((bitcast<f32>(_e615) - _e169.origin.x) * _e315);
                        let _e632 = ((bitcast<f32>(_e619) - _e169.origin.y) * _e326);
                        let _e633 = ((bitcast<f32>(_e623) - _e169.origin.z) * _e337);
                        let _e641 = nodes.member[(0u + _e576)].x;
                        if (_e315 < 0f) {
                            let _e652 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e641.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e658 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e652.unnamed.root, _e641.w), _e652.unnamed_1);
                            let _e664 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e658.unnamed, lt_bvh_traverse_Tree(_e641.x, _e658.unnamed_1.first_primitive));
                            phi_1299_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e664.unnamed, lt_bvh_traverse_Tree(_e664.unnamed_1.root, _e641.y));
                        } else {
                            let _e680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e641.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e680.unnamed.root, _e641.y), _e680.unnamed_1);
                            let _e692 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e686.unnamed, lt_bvh_traverse_Tree(_e641.z, _e686.unnamed_1.first_primitive));
                            phi_1299_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e692.unnamed, lt_bvh_traverse_Tree(_e692.unnamed_1.root, _e641.w));
                        }
                        let _e700 = phi_1299_;
                        let _e710 = nodes.member[(0u + _e576)].y;
                        if (_e326 < 0f) {
                            let _e721 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e710.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e727 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e721.unnamed.root, _e710.w), _e721.unnamed_1);
                            let _e733 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e727.unnamed, lt_bvh_traverse_Tree(_e710.x, _e727.unnamed_1.first_primitive));
                            phi_1326_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e733.unnamed, lt_bvh_traverse_Tree(_e733.unnamed_1.root, _e710.y));
                        } else {
                            let _e749 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e710.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e755 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e749.unnamed.root, _e710.y), _e749.unnamed_1);
                            let _e761 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e755.unnamed, lt_bvh_traverse_Tree(_e710.z, _e755.unnamed_1.first_primitive));
                            phi_1326_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e761.unnamed, lt_bvh_traverse_Tree(_e761.unnamed_1.root, _e710.w));
                        }
                        let _e769 = phi_1326_;
                        let _e779 = nodes.member[(0u + _e576)].z;
                        if (_e337 < 0f) {
                            let _e790 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e779.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e796 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e790.unnamed.root, _e779.w), _e790.unnamed_1);
                            let _e802 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e796.unnamed, lt_bvh_traverse_Tree(_e779.x, _e796.unnamed_1.first_primitive));
                            phi_1353_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e802.unnamed, lt_bvh_traverse_Tree(_e802.unnamed_1.root, _e779.y));
                        } else {
                            let _e818 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e779.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e824 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e818.unnamed.root, _e779.y), _e818.unnamed_1);
                            let _e830 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e824.unnamed, lt_bvh_traverse_Tree(_e779.z, _e824.unnamed_1.first_primitive));
                            phi_1353_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e830.unnamed, lt_bvh_traverse_Tree(_e830.unnamed_1.root, _e779.w));
                        }
                        let _e838 = phi_1353_;
                        phi_1359_ = 0u;
                        phi_1362_ = 0u;
                        loop {
                            let _e848 = phi_1359_;
                            let _e850 = phi_1362_;
                            local_2 = _e850;
                            local_3 = _e850;
                            local_4 = _e850;
                            let _e851 = (_e848 < 8u);
                            if _e851 {
                                let _e853 = (_e848 >> bitcast<u32>(2i));
                                let _e854 = (_e848 & 3u);
                                if (_e853 == 0u) {
                                    phi_1376_ = _e700.unnamed.root;
                                } else {
                                    phi_1376_ = _e700.unnamed.first_primitive;
                                }
                                let _e857 = phi_1376_;
                                if (_e853 == 0u) {
                                    phi_1386_ = _e769.unnamed.root;
                                } else {
                                    phi_1386_ = _e769.unnamed.first_primitive;
                                }
                                let _e866 = phi_1386_;
                                if (_e853 == 0u) {
                                    phi_1396_ = _e838.unnamed.root;
                                } else {
                                    phi_1396_ = _e838.unnamed.first_primitive;
                                }
                                let _e875 = phi_1396_;
                                let _e888 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e857 >> bitcast<u32>(((_e854 * 8u) & 31u))) & 255u)) * _e610) + (_e631 - _e375)), ((f32(((_e866 >> bitcast<u32>(((_e854 * 8u) & 31u))) & 255u)) * _e611) + (_e632 - _e376)));
                                let _e889 = core_intrinsics_maximum_number_nsz_f32_(_e888, ((f32(((_e875 >> bitcast<u32>(((_e854 * 8u) & 31u))) & 255u)) * _e612) + (_e633 - _e377)));
                                if (_e853 == 0u) {
                                    phi_1414_ = _e700.unnamed_1.root;
                                } else {
                                    phi_1414_ = _e700.unnamed_1.first_primitive;
                                }
                                let _e892 = phi_1414_;
                                if (_e853 == 0u) {
                                    phi_1424_ = _e769.unnamed_1.root;
                                } else {
                                    phi_1424_ = _e769.unnamed_1.first_primitive;
                                }
                                let _e901 = phi_1424_;
                                if (_e853 == 0u) {
                                    phi_1434_ = _e838.unnamed_1.root;
                                } else {
                                    phi_1434_ = _e838.unnamed_1.first_primitive;
                                }
                                let _e910 = phi_1434_;
                                let _e923 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e892 >> bitcast<u32>(((_e854 * 8u) & 31u))) & 255u)) * _e610) + (_e631 + _e375)), ((f32(((_e901 >> bitcast<u32>(((_e854 * 8u) & 31u))) & 255u)) * _e611) + (_e632 + _e376)));
                                let _e924 = core_intrinsics_minimum_number_nsz_f32_(_e923, ((f32(((_e910 >> bitcast<u32>(((_e854 * 8u) & 31u))) & 255u)) * _e612) + (_e633 + _e377)));
                                if (_e889 <= _e924) {
                                    if (_e889 <= _e574.t) {
                                        if (_e924 >= _e169.tmin) {
                                            if (_e853 == 0u) {
                                                let _e931 = nodes.member[(0u + _e576)].links[2u];
                                                phi_1470_ = _e931;
                                            } else {
                                                let _e934 = nodes.member[(0u + _e576)].links[3u];
                                                phi_1470_ = _e934;
                                            }
                                            let _e936 = phi_1470_;
                                            let _e941 = ((_e936 >> bitcast<u32>(((_e854 * 8u) & 31u))) & 255u);
                                            let _e942 = (_e941 & 31u);
                                            if (_e942 >= 24u) {
                                                phi_1483_ = (24u + ((_e942 - 24u) ^ _e436));
                                            } else {
                                                phi_1483_ = _e942;
                                            }
                                            let _e948 = phi_1483_;
                                            phi_1488_ = (_e850 | ((_e941 >> bitcast<u32>(5i)) << bitcast<u32>((_e948 & 31u))));
                                        } else {
                                            phi_1488_ = _e850;
                                        }
                                        let _e956 = phi_1488_;
                                        phi_1489_ = _e956;
                                    } else {
                                        phi_1489_ = _e850;
                                    }
                                    let _e958 = phi_1489_;
                                    phi_1490_ = _e958;
                                } else {
                                    phi_1490_ = _e850;
                                }
                                let _e960 = phi_1490_;
                                phi_1360_ = (_e848 + 1u);
                                phi_1363_ = _e960;
                            } else {
                                phi_1360_ = u32();
                                phi_1363_ = u32();
                            }
                            let _e963 = phi_1360_;
                            let _e965 = phi_1363_;
                            continue;
                            continuing {
                                phi_1359_ = _e963;
                                phi_1362_ = _e965;
                                break if !(_e851);
                            }
                        }
                        let _e969 = nodes.member[(0u + _e576)].links[0u];
                        let _e973 = nodes.member[(0u + _e576)].frame[3u];
                        let _e977 = local_2;
                        if ((_e977 & 4278190080u) == 0u) {
                        } else {
                            let _e981 = local_1.group_mask;
                            if ((_e981 & 4278190080u) == 0u) {
                            } else {
                                let _e985 = local_1.len;
                                if (_e985 < 32u) {
                                    let _e988 = local_1.group;
                                    let _e990 = local_1.len;
                                    if (_e990 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e990)] = _e988;
                                    let _e996 = local_1.group_mask;
                                    let _e998 = local_1.len;
                                    if (_e998 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e998)] = _e996;
                                    let _e1005 = local_1.len;
                                    local_1.len = (_e1005 + 1u);
                                }
                            }
                            local_1.group = (0u + _e969);
                            let _e1009 = local_3;
                            local_1.group_mask = ((_e1009 & 4278190080u) | (_e973 >> bitcast<u32>(24i)));
                        }
                        let _e1014 = local_4;
                        phi_1548_ = _e574;
                        phi_1551_ = (_e1014 & 16777215u);
                        loop {
                            let _e1017 = phi_1548_;
                            let _e1019 = phi_1551_;
                            local_5 = _e1017;
                            if (_e1019 == 0u) {
                                phi_1549_ = lt_bvh_Hit();
                                phi_1552_ = u32();
                                phi_2407_ = false;
                            } else {
                                let _e1023 = nodes.member[(0u + _e576)].links[1u];
                                let _e1028 = ((0u + _e1023) + select(firstTrailingBit(_e1019), 32u, (_e1019 == 0u)));
                                if (_e1028 < _e79) {
                                } else {
                                    return;
                                }
                                let _e1035 = triangles.member[(0u + _e1028)].v0_;
                                let _e1038 = (_e1035.x - _e169.origin.x);
                                let _e1041 = (_e1035.y - _e169.origin.y);
                                let _e1044 = (_e1035.z - _e169.origin.z);
                                if (_e403 == 0u) {
                                    phi_1598_ = vec3<f32>(_e1041, _e1044, _e1038);
                                } else {
                                    if (_e403 == 1u) {
                                        phi_1597_ = vec3<f32>(_e1044, _e1038, _e1041);
                                    } else {
                                        phi_1597_ = (_e1035 - _e169.origin);
                                    }
                                    let _e1051 = phi_1597_;
                                    phi_1598_ = _e1051;
                                }
                                let _e1053 = phi_1598_;
                                let _e1057 = (_e1053.x - (_e420 * _e1053.z));
                                let _e1061 = (_e1053.y - (_e423 * _e1053.z));
                                let _e1063 = triangles.member[(0u + _e1028)].v1_;
                                let _e1066 = (_e1063.x - _e169.origin.x);
                                let _e1069 = (_e1063.y - _e169.origin.y);
                                let _e1072 = (_e1063.z - _e169.origin.z);
                                if (_e403 == 0u) {
                                    phi_1630_ = vec3<f32>(_e1069, _e1072, _e1066);
                                } else {
                                    if (_e403 == 1u) {
                                        phi_1629_ = vec3<f32>(_e1072, _e1066, _e1069);
                                    } else {
                                        phi_1629_ = (_e1063 - _e169.origin);
                                    }
                                    let _e1079 = phi_1629_;
                                    phi_1630_ = _e1079;
                                }
                                let _e1081 = phi_1630_;
                                let _e1085 = (_e1081.x - (_e420 * _e1081.z));
                                let _e1089 = (_e1081.y - (_e423 * _e1081.z));
                                let _e1091 = triangles.member[(0u + _e1028)].v2_;
                                let _e1094 = (_e1091.x - _e169.origin.x);
                                let _e1097 = (_e1091.y - _e169.origin.y);
                                let _e1100 = (_e1091.z - _e169.origin.z);
                                if (_e403 == 0u) {
                                    phi_1662_ = vec3<f32>(_e1097, _e1100, _e1094);
                                } else {
                                    if (_e403 == 1u) {
                                        phi_1661_ = vec3<f32>(_e1100, _e1094, _e1097);
                                    } else {
                                        phi_1661_ = (_e1091 - _e169.origin);
                                    }
                                    let _e1107 = phi_1661_;
                                    phi_1662_ = _e1107;
                                }
                                let _e1109 = phi_1662_;
                                let _e1113 = (_e1109.x - (_e420 * _e1109.z));
                                let _e1117 = (_e1109.y - (_e423 * _e1109.z));
                                if (_e1085 < _e1113) {
                                    phi_1681_ = true;
                                } else {
                                    if (_e1085 == _e1113) {
                                        phi_1680_ = (_e1089 < _e1117);
                                    } else {
                                        phi_1680_ = false;
                                    }
                                    let _e1122 = phi_1680_;
                                    phi_1681_ = _e1122;
                                }
                                let _e1124 = phi_1681_;
                                if _e1124 {
                                    phi_1685_ = _e1117;
                                    phi_1686_ = _e1113;
                                    phi_1687_ = _e1089;
                                    phi_1688_ = _e1085;
                                } else {
                                    phi_1685_ = _e1089;
                                    phi_1686_ = _e1085;
                                    phi_1687_ = _e1117;
                                    phi_1688_ = _e1113;
                                }
                                let _e1126 = phi_1685_;
                                let _e1128 = phi_1686_;
                                let _e1130 = phi_1687_;
                                let _e1132 = phi_1688_;
                                let _e1135 = ((_e1132 * _e1126) - (_e1130 * _e1128));
                                if _e1124 {
                                    phi_1696_ = -(_e1135);
                                } else {
                                    phi_1696_ = _e1135;
                                }
                                let _e1138 = phi_1696_;
                                if (_e1113 < _e1057) {
                                    phi_1707_ = true;
                                } else {
                                    if (_e1113 == _e1057) {
                                        phi_1706_ = (_e1117 < _e1061);
                                    } else {
                                        phi_1706_ = false;
                                    }
                                    let _e1143 = phi_1706_;
                                    phi_1707_ = _e1143;
                                }
                                let _e1145 = phi_1707_;
                                if _e1145 {
                                    phi_1711_ = _e1061;
                                    phi_1712_ = _e1057;
                                    phi_1713_ = _e1117;
                                    phi_1714_ = _e1113;
                                } else {
                                    phi_1711_ = _e1117;
                                    phi_1712_ = _e1113;
                                    phi_1713_ = _e1061;
                                    phi_1714_ = _e1057;
                                }
                                let _e1147 = phi_1711_;
                                let _e1149 = phi_1712_;
                                let _e1151 = phi_1713_;
                                let _e1153 = phi_1714_;
                                let _e1156 = ((_e1153 * _e1147) - (_e1151 * _e1149));
                                if _e1145 {
                                    phi_1722_ = -(_e1156);
                                } else {
                                    phi_1722_ = _e1156;
                                }
                                let _e1159 = phi_1722_;
                                if (_e1057 < _e1085) {
                                    phi_1733_ = true;
                                } else {
                                    if (_e1057 == _e1085) {
                                        phi_1732_ = (_e1061 < _e1089);
                                    } else {
                                        phi_1732_ = false;
                                    }
                                    let _e1164 = phi_1732_;
                                    phi_1733_ = _e1164;
                                }
                                let _e1166 = phi_1733_;
                                if _e1166 {
                                    phi_1737_ = _e1089;
                                    phi_1738_ = _e1085;
                                    phi_1739_ = _e1061;
                                    phi_1740_ = _e1057;
                                } else {
                                    phi_1737_ = _e1061;
                                    phi_1738_ = _e1057;
                                    phi_1739_ = _e1089;
                                    phi_1740_ = _e1085;
                                }
                                let _e1168 = phi_1737_;
                                let _e1170 = phi_1738_;
                                let _e1172 = phi_1739_;
                                let _e1174 = phi_1740_;
                                let _e1177 = ((_e1174 * _e1168) - (_e1172 * _e1170));
                                if _e1166 {
                                    phi_1748_ = -(_e1177);
                                } else {
                                    phi_1748_ = _e1177;
                                }
                                let _e1180 = phi_1748_;
                                if (_e1138 >= 0f) {
                                    if (_e1159 >= 0f) {
                                        if (_e1180 >= 0f) {
                                            phi_1763_ = ((_e1138 + _e1159) + _e1180);
                                            phi_1764_ = false;
                                        } else {
                                            phi_1763_ = f32();
                                            phi_1764_ = true;
                                        }
                                        let _e1187 = phi_1763_;
                                        let _e1189 = phi_1764_;
                                        phi_1765_ = _e1187;
                                        phi_1766_ = _e1189;
                                    } else {
                                        phi_1765_ = f32();
                                        phi_1766_ = true;
                                    }
                                    let _e1191 = phi_1765_;
                                    let _e1193 = phi_1766_;
                                    phi_1767_ = _e1191;
                                    phi_1768_ = _e1193;
                                } else {
                                    phi_1767_ = f32();
                                    phi_1768_ = true;
                                }
                                let _e1195 = phi_1767_;
                                let _e1197 = phi_1768_;
                                if _e1197 {
                                    if (_e1138 <= 0f) {
                                        if (_e1159 <= 0f) {
                                            let _e1200 = (_e1180 <= 0f);
                                            if _e1200 {
                                            }
                                            phi_1786_ = ((_e1138 + _e1159) + _e1180);
                                            phi_1787_ = false;
                                            phi_1788_ = _e1200;
                                        } else {
                                            phi_1786_ = f32();
                                            phi_1787_ = true;
                                            phi_1788_ = false;
                                        }
                                        let _e1204 = phi_1786_;
                                        let _e1206 = phi_1787_;
                                        let _e1208 = phi_1788_;
                                        phi_1789_ = _e1204;
                                        phi_1790_ = _e1206;
                                        phi_1791_ = _e1208;
                                    } else {
                                        phi_1789_ = f32();
                                        phi_1790_ = true;
                                        phi_1791_ = false;
                                    }
                                    let _e1210 = phi_1789_;
                                    let _e1212 = phi_1790_;
                                    let _e1214 = phi_1791_;
                                    if _e1212 {
                                        phi_1795_ = false;
                                    } else {
                                        phi_1795_ = _e1214;
                                    }
                                    let _e1216 = phi_1795_;
                                    phi_1796_ = _e1210;
                                    phi_1797_ = _e1216;
                                } else {
                                    phi_1796_ = _e1195;
                                    phi_1797_ = true;
                                }
                                let _e1218 = phi_1796_;
                                let _e1220 = phi_1797_;
                                if _e1220 {
                                    let _e1221 = (_e1218 == 0f);
                                    if _e1221 {
                                        phi_2123_ = lt_bvh_triangle_Intersection();
                                        phi_2124_ = false;
                                    } else {
                                        let _e1223 = triangles.member[(0u + _e1028)].v0_;
                                        let _e1226 = (_e1223.x - _e169.origin.x);
                                        let _e1229 = (_e1223.y - _e169.origin.y);
                                        let _e1232 = (_e1223.z - _e169.origin.z);
                                        if (_e403 == 0u) {
                                            phi_1828_ = vec3<f32>(_e1229, _e1232, _e1226);
                                        } else {
                                            if (_e403 == 1u) {
                                                phi_1827_ = vec3<f32>(_e1232, _e1226, _e1229);
                                            } else {
                                                phi_1827_ = (_e1223 - _e169.origin);
                                            }
                                            let _e1239 = phi_1827_;
                                            phi_1828_ = _e1239;
                                        }
                                        let _e1241 = phi_1828_;
                                        let _e1243 = triangles.member[(0u + _e1028)].v1_;
                                        let _e1245 = triangles.member[(0u + _e1028)].v0_;
                                        let _e1248 = (_e1243.x - _e1245.x);
                                        let _e1251 = (_e1243.y - _e1245.y);
                                        let _e1254 = (_e1243.z - _e1245.z);
                                        if (_e403 == 0u) {
                                            phi_1854_ = vec3<f32>(_e1251, _e1254, _e1248);
                                        } else {
                                            if (_e403 == 1u) {
                                                phi_1853_ = vec3<f32>(_e1254, _e1248, _e1251);
                                            } else {
                                                phi_1853_ = (_e1243 - _e1245);
                                            }
                                            let _e1261 = phi_1853_;
                                            phi_1854_ = _e1261;
                                        }
                                        let _e1263 = phi_1854_;
                                        let _e1265 = triangles.member[(0u + _e1028)].v2_;
                                        let _e1267 = triangles.member[(0u + _e1028)].v0_;
                                        let _e1270 = (_e1265.x - _e1267.x);
                                        let _e1273 = (_e1265.y - _e1267.y);
                                        let _e1276 = (_e1265.z - _e1267.z);
                                        if (_e403 == 0u) {
                                            phi_1880_ = vec3<f32>(_e1273, _e1276, _e1270);
                                        } else {
                                            if (_e403 == 1u) {
                                                phi_1879_ = vec3<f32>(_e1276, _e1270, _e1273);
                                            } else {
                                                phi_1879_ = (_e1265 - _e1267);
                                            }
                                            let _e1283 = phi_1879_;
                                            phi_1880_ = _e1283;
                                        }
                                        let _e1285 = phi_1880_;
                                        let _e1292 = ((_e1263.y * _e1285.z) - (_e1263.z * _e1285.y));
                                        let _e1299 = ((_e1263.z * _e1285.x) - (_e1263.x * _e1285.z));
                                        let _e1306 = ((_e1263.x * _e1285.y) - (_e1263.y * _e1285.x));
                                        let _e1320 = (((1f / _e417.z) * (((_e1292 * _e1241.x) + (_e1299 * _e1241.y)) + (_e1306 * _e1241.z))) / (((_e1292 * _e420) + (_e1299 * _e423)) + _e1306));
                                        if (_e1320 > _e169.tmin) {
                                            if (_e1320 < _e169.tmax) {
                                                let _e1326 = triangles.member[(0u + _e1028)].v0_;
                                                let _e1328 = triangles.member[(0u + _e1028)].v1_;
                                                if (_e1326.x < _e1328.x) {
                                                    phi_1938_ = _e1326.x;
                                                } else {
                                                    phi_1938_ = _e1328.x;
                                                }
                                                let _e1335 = phi_1938_;
                                                if (_e1326.y < _e1328.y) {
                                                    phi_1947_ = _e1326.y;
                                                } else {
                                                    phi_1947_ = _e1328.y;
                                                }
                                                let _e1342 = phi_1947_;
                                                if (_e1326.z < _e1328.z) {
                                                    phi_1956_ = _e1326.z;
                                                } else {
                                                    phi_1956_ = _e1328.z;
                                                }
                                                let _e1349 = phi_1956_;
                                                let _e1351 = triangles.member[(0u + _e1028)].v2_;
                                                if (_e1335 < _e1351.x) {
                                                    phi_1965_ = _e1335;
                                                } else {
                                                    phi_1965_ = _e1351.x;
                                                }
                                                let _e1356 = phi_1965_;
                                                if (_e1342 < _e1351.y) {
                                                    phi_1972_ = _e1342;
                                                } else {
                                                    phi_1972_ = _e1351.y;
                                                }
                                                let _e1361 = phi_1972_;
                                                if (_e1349 < _e1351.z) {
                                                    phi_1979_ = _e1349;
                                                } else {
                                                    phi_1979_ = _e1351.z;
                                                }
                                                let _e1366 = phi_1979_;
                                                let _e1368 = triangles.member[(0u + _e1028)].v0_;
                                                let _e1370 = triangles.member[(0u + _e1028)].v1_;
                                                if (_e1368.x > _e1370.x) {
                                                    phi_1992_ = _e1368.x;
                                                } else {
                                                    phi_1992_ = _e1370.x;
                                                }
                                                let _e1377 = phi_1992_;
                                                if (_e1368.y > _e1370.y) {
                                                    phi_2001_ = _e1368.y;
                                                } else {
                                                    phi_2001_ = _e1370.y;
                                                }
                                                let _e1384 = phi_2001_;
                                                if (_e1368.z > _e1370.z) {
                                                    phi_2010_ = _e1368.z;
                                                } else {
                                                    phi_2010_ = _e1370.z;
                                                }
                                                let _e1391 = phi_2010_;
                                                let _e1393 = triangles.member[(0u + _e1028)].v2_;
                                                if (_e1377 > _e1393.x) {
                                                    phi_2019_ = _e1377;
                                                } else {
                                                    phi_2019_ = _e1393.x;
                                                }
                                                let _e1398 = phi_2019_;
                                                if (_e1384 > _e1393.y) {
                                                    phi_2026_ = _e1384;
                                                } else {
                                                    phi_2026_ = _e1393.y;
                                                }
                                                let _e1403 = phi_2026_;
                                                if (_e1391 > _e1393.z) {
                                                    phi_2033_ = _e1391;
                                                } else {
                                                    phi_2033_ = _e1393.z;
                                                }
                                                let _e1408 = phi_2033_;
                                                let _e1415 = ((_e1356 - _e169.origin.x) * _e315);
                                                let _e1416 = ((_e1361 - _e169.origin.y) * _e326);
                                                let _e1417 = ((_e1366 - _e169.origin.z) * _e337);
                                                let _e1424 = ((_e1398 - _e169.origin.x) * _e315);
                                                let _e1425 = ((_e1403 - _e169.origin.y) * _e326);
                                                let _e1426 = ((_e1408 - _e169.origin.z) * _e337);
                                                if (_e1415 < _e1424) {
                                                    phi_2056_ = _e1415;
                                                } else {
                                                    phi_2056_ = _e1424;
                                                }
                                                let _e1429 = phi_2056_;
                                                if (_e1416 < _e1425) {
                                                    phi_2061_ = _e1416;
                                                } else {
                                                    phi_2061_ = _e1425;
                                                }
                                                let _e1432 = phi_2061_;
                                                if (_e1417 < _e1426) {
                                                    phi_2066_ = _e1417;
                                                } else {
                                                    phi_2066_ = _e1426;
                                                }
                                                let _e1435 = phi_2066_;
                                                if (_e1415 > _e1424) {
                                                    phi_2074_ = _e1415;
                                                } else {
                                                    phi_2074_ = _e1424;
                                                }
                                                let _e1441 = phi_2074_;
                                                if (_e1416 > _e1425) {
                                                    phi_2079_ = _e1416;
                                                } else {
                                                    phi_2079_ = _e1425;
                                                }
                                                let _e1444 = phi_2079_;
                                                if (_e1417 > _e1426) {
                                                    phi_2084_ = _e1417;
                                                } else {
                                                    phi_2084_ = _e1426;
                                                }
                                                let _e1447 = phi_2084_;
                                                let _e1451 = core_intrinsics_maximum_number_nsz_f32_((_e1429 - _e382), (_e1432 - _e383));
                                                let _e1452 = core_intrinsics_maximum_number_nsz_f32_(_e1451, (_e1435 - _e384));
                                                let _e1453 = core_intrinsics_minimum_number_nsz_f32_((_e1441 + _e382), (_e1444 + _e383));
                                                let _e1454 = core_intrinsics_minimum_number_nsz_f32_(_e1453, (_e1447 + _e384));
                                                if (_e1452 > -300000000000000000000000000000000000000f) {
                                                    phi_2096_ = _e1452;
                                                } else {
                                                    phi_2096_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1457 = phi_2096_;
                                                if (_e1454 < 300000000000000000000000000000000000000f) {
                                                    phi_2101_ = _e1454;
                                                } else {
                                                    phi_2101_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1460 = phi_2101_;
                                                if (_e1320 < _e1457) {
                                                    phi_2106_ = _e1457;
                                                } else {
                                                    phi_2106_ = _e1320;
                                                }
                                                let _e1463 = phi_2106_;
                                                if (_e1463 > _e1460) {
                                                    phi_2111_ = _e1460;
                                                } else {
                                                    phi_2111_ = _e1463;
                                                }
                                                let _e1466 = phi_2111_;
                                                phi_2116_ = lt_bvh_triangle_Intersection(_e1466, (_e1159 / _e1218), (_e1180 / _e1218), (_e1457 <= _e1460));
                                                phi_2117_ = false;
                                            } else {
                                                phi_2116_ = lt_bvh_triangle_Intersection();
                                                phi_2117_ = true;
                                            }
                                            let _e1472 = phi_2116_;
                                            let _e1474 = phi_2117_;
                                            phi_2118_ = _e1472;
                                            phi_2119_ = _e1474;
                                        } else {
                                            phi_2118_ = lt_bvh_triangle_Intersection();
                                            phi_2119_ = true;
                                        }
                                        let _e1476 = phi_2118_;
                                        let _e1478 = phi_2119_;
                                        if _e1478 {
                                        }
                                        phi_2123_ = _e1476;
                                        phi_2124_ = _e1478;
                                    }
                                    let _e1480 = phi_2123_;
                                    let _e1482 = phi_2124_;
                                    phi_2125_ = _e1480;
                                    phi_2126_ = _e1221;
                                    phi_2127_ = _e1482;
                                } else {
                                    phi_2125_ = lt_bvh_triangle_Intersection();
                                    phi_2126_ = true;
                                    phi_2127_ = false;
                                }
                                let _e1484 = phi_2125_;
                                let _e1486 = phi_2126_;
                                let _e1488 = phi_2127_;
                                if _e1486 {
                                    phi_2131_ = true;
                                } else {
                                    phi_2131_ = _e1488;
                                }
                                let _e1490 = phi_2131_;
                                if _e1490 {
                                    phi_2135_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2135_ = _e1484;
                                }
                                let _e1492 = phi_2135_;
                                if _e1492.is_hit {
                                    if (_e1492.t > _e169.tmin) {
                                        if (_e1492.t < _e1017.t) {
                                            phi_2184_ = true;
                                        } else {
                                            if (_e1492.t == _e1017.t) {
                                                if (_e1017.triangle != 4294967295u) {
                                                    if (_e1028 < _e1017.triangle) {
                                                        phi_2175_ = true;
                                                    } else {
                                                        if (_e1028 == _e1017.triangle) {
                                                            phi_2174_ = (4294967295u < _e1017.instance);
                                                        } else {
                                                            phi_2174_ = false;
                                                        }
                                                        let _e1511 = phi_2174_;
                                                        phi_2175_ = _e1511;
                                                    }
                                                    let _e1513 = phi_2175_;
                                                    phi_2176_ = _e1513;
                                                    phi_2177_ = false;
                                                } else {
                                                    phi_2176_ = bool();
                                                    phi_2177_ = true;
                                                }
                                                let _e1515 = phi_2176_;
                                                let _e1517 = phi_2177_;
                                                phi_2178_ = _e1515;
                                                phi_2179_ = _e1517;
                                            } else {
                                                phi_2178_ = bool();
                                                phi_2179_ = true;
                                            }
                                            let _e1519 = phi_2178_;
                                            let _e1521 = phi_2179_;
                                            if _e1521 {
                                                phi_2183_ = false;
                                            } else {
                                                phi_2183_ = _e1519;
                                            }
                                            let _e1523 = phi_2183_;
                                            phi_2184_ = _e1523;
                                        }
                                        let _e1525 = phi_2184_;
                                        if _e1525 {
                                            let _e1527 = triangles.member[(0u + _e1028)].i0_;
                                            if ((_e1527 & 2147483648u) == 0u) {
                                                phi_2395_ = true;
                                            } else {
                                                if (_e1028 < _e79) {
                                                } else {
                                                    return;
                                                }
                                                let _e1536 = triangles.member[(0u + _e1028)].i0_;
                                                let _e1537 = (_e1536 & 2147483647u);
                                                let _e1539 = triangles.member[(0u + _e1028)].i1_;
                                                let _e1541 = triangles.member[(0u + _e1028)].i2_;
                                                if (_e1537 < _e82) {
                                                } else {
                                                    return;
                                                }
                                                let _e1545 = vertices.member[(0u + _e1537)];
                                                if (_e1539 < _e82) {
                                                } else {
                                                    return;
                                                }
                                                let _e1549 = vertices.member[(0u + _e1539)];
                                                if (_e1541 < _e82) {
                                                } else {
                                                    return;
                                                }
                                                let _e1553 = vertices.member[(0u + _e1541)];
                                                let _e1554 = array<abi_Vertex, 3>(_e1545, _e1549, _e1553);
                                                if (_e1554[0].material < _e85) {
                                                } else {
                                                    return;
                                                }
                                                let _e1560 = materials.member[(0u + _e1554[0].material)];
                                                if ((_e1560.flags & 0u) == 0u) {
                                                    let _e1565 = ((1f - _e1492.u) - _e1492.v);
                                                    if (_e1560.cutoff <= 0f) {
                                                        phi_2390_ = true;
                                                    } else {
                                                        let _e1592 = (_e1560.base_color.w * ((((f32((_e1554[0].color >> bitcast<u32>(24i))) * _e1565) + (f32((_e1554[1].color >> bitcast<u32>(24i))) * _e1492.u)) + (f32((_e1554[2].color >> bitcast<u32>(24i))) * _e1492.v)) * (1f / 255f)));
                                                        if (_e1560.alpha_size == 0u) {
                                                            phi_2387_ = _e1592;
                                                        } else {
                                                            local.offset = _e1560.alpha_offset;
                                                            local.size = _e1560.alpha_size;
                                                            local.flags = _e1560.flags;
                                                            let _e1623 = _lt_shaders_texture_TextureView_quad((&local), (((_e1554[0].u * _e1565) + (_e1554[1].u * _e1492.u)) + (_e1554[2].u * _e1492.v)), (((_e1554[0].v * _e1565) + (_e1554[1].v * _e1492.u)) + (_e1554[2].v * _e1492.v)));
                                                            let _e1627 = (_e1623.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1627 < _e91) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1631 = alpha_texels.member[(0u + _e1627)];
                                                            let _e1647 = (_e1623.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1647 < _e91) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1651 = alpha_texels.member[(0u + _e1647)];
                                                            let _e1668 = (_e1623.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1668 < _e91) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1672 = alpha_texels.member[(0u + _e1668)];
                                                            let _e1689 = (_e1623.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1689 < _e91) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1693 = alpha_texels.member[(0u + _e1689)];
                                                            phi_2387_ = (_e1592 * (((((f32(((_e1631 >> bitcast<u32>((((_e1623.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1623.weights.x) + ((f32(((_e1651 >> bitcast<u32>((((_e1623.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1623.weights.y)) + ((f32(((_e1672 >> bitcast<u32>((((_e1623.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1623.weights.z)) + ((f32(((_e1693 >> bitcast<u32>((((_e1623.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1623.weights.w)));
                                                        }
                                                        let _e1709 = phi_2387_;
                                                        phi_2390_ = (_e1709 >= _e1560.cutoff);
                                                    }
                                                    let _e1713 = phi_2390_;
                                                    phi_2391_ = _e1713;
                                                } else {
                                                    phi_2391_ = false;
                                                }
                                                let _e1715 = phi_2391_;
                                                if _e1715 {
                                                }
                                                phi_2395_ = _e1715;
                                            }
                                            let _e1717 = phi_2395_;
                                            if _e1717 {
                                                phi_2403_ = lt_bvh_Hit(_e1492.t, _e1492.u, _e1492.v, _e1028, 4294967295u);
                                            } else {
                                                phi_2403_ = _e1017;
                                            }
                                            let _e1723 = phi_2403_;
                                            phi_2404_ = _e1723;
                                        } else {
                                            phi_2404_ = _e1017;
                                        }
                                        let _e1725 = phi_2404_;
                                        phi_2405_ = _e1725;
                                    } else {
                                        phi_2405_ = _e1017;
                                    }
                                    let _e1727 = phi_2405_;
                                    phi_2406_ = _e1727;
                                } else {
                                    phi_2406_ = _e1017;
                                }
                                let _e1729 = phi_2406_;
                                phi_1549_ = _e1729;
                                phi_1552_ = (_e1019 & (_e1019 - 1u));
                                phi_2407_ = true;
                            }
                            let _e1731 = phi_1549_;
                            let _e1733 = phi_1552_;
                            let _e1735 = phi_2407_;
                            continue;
                            continuing {
                                phi_1548_ = _e1731;
                                phi_1551_ = _e1733;
                                break if !(_e1735);
                            }
                        }
                        let _e1738 = local_1.group_mask;
                        if ((_e1738 & 4278190080u) == 0u) {
                            let _e1742 = local_1.len;
                            if (_e1742 == 0u) {
                                phi_2446_ = false;
                            } else {
                                let _e1746 = local_1.len;
                                local_1.len = (_e1746 - 1u);
                                let _e1749 = local_1.len;
                                if (_e1749 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1754 = local_1.first[(0u + _e1749)];
                                local_1.group = _e1754;
                                let _e1757 = local_1.len;
                                if (_e1757 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1762 = local_1.mask[(0u + _e1757)];
                                local_1.group_mask = _e1762;
                                phi_2446_ = true;
                            }
                            let _e1765 = phi_2446_;
                            phi_2447_ = _e1765;
                        } else {
                            phi_2447_ = true;
                        }
                        let _e1767 = phi_2447_;
                        if _e1767 {
                            let _e1769 = local_1.group_mask;
                            let _e1775 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1769)), 32u, (_e1769 == 0u)));
                            let _e1779 = local_1.group_mask;
                            let _e1793 = local_1.group_mask;
                            local_1.group_mask = (_e1793 & ~((1u << bitcast<u32>((_e1775 & 31u)))));
                            let _e1796 = local_1.group;
                            phi_2478_ = (_e1796 + countOneBits(((_e1779 & ~((4294967295u << bitcast<u32>((((_e1775 - 24u) ^ _e436) & 31u))))) & 255u)));
                        } else {
                            phi_2478_ = 4294967295u;
                        }
                        let _e1799 = phi_2478_;
                        let _e2500 = local_5;
                        phi_1212_ = _e2500;
                        phi_1215_ = _e1799;
                    } else {
                        phi_1212_ = lt_bvh_Hit();
                        phi_1215_ = u32();
                    }
                    let _e1801 = phi_1212_;
                    let _e1803 = phi_1215_;
                    continue;
                    continuing {
                        phi_1211_ = _e1801;
                        phi_1214_ = _e1803;
                        break if !(_e577);
                    }
                }
                let _e2504 = local_6;
                phi_2479_ = _e2504;
            }
            let _e1806 = phi_2479_;
            phi_2480_ = _e1806;
            phi_2481_ = _e233;
        } else {
            phi_2480_ = lt_bvh_Hit();
            phi_2481_ = true;
        }
        let _e1808 = phi_2480_;
        let _e1810 = phi_2481_;
        if _e1810 {
            phi_2485_ = _e171;
        } else {
            phi_2485_ = _e1808;
        }
        let _e1812 = phi_2485_;
        if (_e1812.triangle != 4294967295u) {
            let _e1818 = ((1f - _e1812.u) - _e1812.v);
            if (_e1812.triangle < _e79) {
            } else {
                return;
            }
            let _e1824 = triangles.member[(0u + _e1812.triangle)];
            let _e1849 = (((_e1824.v0_.x * _e1818) + (_e1824.v1_.x * _e1812.u)) + (_e1824.v2_.x * _e1812.v));
            let _e1850 = (((_e1824.v0_.y * _e1818) + (_e1824.v1_.y * _e1812.u)) + (_e1824.v2_.y * _e1812.v));
            let _e1851 = (((_e1824.v0_.z * _e1818) + (_e1824.v1_.z * _e1812.u)) + (_e1824.v2_.z * _e1812.v));
            let _e1854 = abs(_e1824.v0_.x);
            let _e1856 = abs(_e1824.v0_.y);
            let _e1858 = abs(_e1824.v0_.z);
            let _e1860 = abs(_e1824.v1_.x);
            let _e1862 = abs(_e1824.v1_.y);
            let _e1864 = abs(_e1824.v1_.z);
            if (_e1854 > _e1860) {
                phi_2550_ = _e1854;
            } else {
                phi_2550_ = _e1860;
            }
            let _e1867 = phi_2550_;
            if (_e1856 > _e1862) {
                phi_2555_ = _e1856;
            } else {
                phi_2555_ = _e1862;
            }
            let _e1870 = phi_2555_;
            if (_e1858 > _e1864) {
                phi_2560_ = _e1858;
            } else {
                phi_2560_ = _e1864;
            }
            let _e1873 = phi_2560_;
            let _e1875 = abs(_e1824.v2_.x);
            let _e1877 = abs(_e1824.v2_.y);
            let _e1879 = abs(_e1824.v2_.z);
            if (_e1867 > _e1875) {
                phi_2571_ = _e1867;
            } else {
                phi_2571_ = _e1875;
            }
            let _e1882 = phi_2571_;
            if (_e1870 > _e1877) {
                phi_2576_ = _e1870;
            } else {
                phi_2576_ = _e1877;
            }
            let _e1885 = phi_2576_;
            if (_e1873 > _e1879) {
                phi_2581_ = _e1873;
            } else {
                phi_2581_ = _e1879;
            }
            let _e1888 = phi_2581_;
            let _e1891 = (_e1824.v1_.x - _e1824.v0_.x);
            let _e1894 = (_e1824.v1_.y - _e1824.v0_.y);
            let _e1897 = (_e1824.v1_.z - _e1824.v0_.z);
            let _e1900 = (_e1824.v2_.x - _e1824.v0_.x);
            let _e1903 = (_e1824.v2_.y - _e1824.v0_.y);
            let _e1906 = (_e1824.v2_.z - _e1824.v0_.z);
            let _e1910 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1894), abs(_e1897));
            let _e1911 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1891), _e1910);
            let _e1912 = (_e1891 / _e1911);
            let _e1913 = (_e1894 / _e1911);
            let _e1914 = (_e1897 / _e1911);
            let _e1918 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1903), abs(_e1906));
            let _e1919 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1900), _e1918);
            let _e1920 = (_e1900 / _e1919);
            let _e1921 = (_e1903 / _e1919);
            let _e1922 = (_e1906 / _e1919);
            let _e1925 = ((_e1913 * _e1922) - (_e1921 * _e1914));
            let _e1928 = ((_e1914 * _e1920) - (_e1922 * _e1912));
            let _e1931 = ((_e1912 * _e1921) - (_e1920 * _e1913));
            let _e1933 = p.member.eye;
            let _e1946 = (1f / sqrt((((_e1925 * _e1925) + (_e1928 * _e1928)) + (_e1931 * _e1931))));
            let _e1947 = (_e1925 * _e1946);
            let _e1948 = (_e1928 * _e1946);
            let _e1949 = (_e1931 * _e1946);
            if ((((_e1947 * (_e1933.x - _e1849)) + (_e1948 * (_e1933.y - _e1850))) + (_e1949 * (_e1933.z - _e1851))) < 0f) {
                phi_2657_ = vec3<f32>(-(_e1947), -(_e1948), -(_e1949));
            } else {
                phi_2657_ = vec3<f32>(_e1947, _e1948, _e1949);
            }
            let _e1962 = phi_2657_;
            if (_e1812.triangle < _e79) {
            } else {
                return;
            }
            let _e1967 = triangles.member[(0u + _e1812.triangle)];
            let _e1969 = (_e1967.i0_ & 2147483647u);
            if (_e1969 < _e82) {
            } else {
                return;
            }
            let _e1975 = vertices.member[(0u + _e1969)];
            if (_e1967.i1_ < _e82) {
            } else {
                return;
            }
            let _e1979 = vertices.member[(0u + _e1967.i1_)];
            if (_e1967.i2_ < _e82) {
            } else {
                return;
            }
            let _e1983 = vertices.member[(0u + _e1967.i2_)];
            let _e1984 = array<abi_Vertex, 3>(_e1975, _e1979, _e1983);
            if (_e1984[0].material < _e85) {
            } else {
                return;
            }
            let _e1990 = materials.member[(0u + _e1984[0].material)];
            let _e2007 = (1f / 255f);
            let _e2026 = (1f / 255f);
            let _e2048 = (1f / 255f);
            let _e2061 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e1818, _e1812.u, _e1812.v));
            let _e2063 = ((_e1990.base_color.x * ((((f32((_e1984[0].color & 255u)) * _e2007) * _e1818) + ((f32((_e1984[1].color & 255u)) * _e2026) * _e1812.u)) + ((f32((_e1984[2].color & 255u)) * _e2048) * _e1812.v))) * _e2061.x);
            let _e2065 = ((_e1990.base_color.y * ((((f32(((_e1984[0].color >> bitcast<u32>(8i)) & 255u)) * _e2007) * _e1818) + ((f32(((_e1984[1].color >> bitcast<u32>(8i)) & 255u)) * _e2026) * _e1812.u)) + ((f32(((_e1984[2].color >> bitcast<u32>(8i)) & 255u)) * _e2048) * _e1812.v))) * _e2061.y);
            let _e2067 = ((_e1990.base_color.z * ((((f32(((_e1984[0].color >> bitcast<u32>(16i)) & 255u)) * _e2007) * _e1818) + ((f32(((_e1984[1].color >> bitcast<u32>(16i)) & 255u)) * _e2026) * _e1812.u)) + ((f32(((_e1984[2].color >> bitcast<u32>(16i)) & 255u)) * _e2048) * _e1812.v))) * _e2061.z);
            let _e2068 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1885, _e1888);
            let _e2069 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1882, _e2068);
            if ((_e1990.flags & 2u) == 0u) {
                phi_2778_ = 0u;
            } else {
                phi_2778_ = 1u;
            }
            let _e2074 = phi_2778_;
            if (_e1984[0].normal == 2147516416u) {
                phi_2981_ = _e1962;
            } else {
                let _e2087 = (f32((bitcast<i32>((_e1984[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2093 = (f32((bitcast<i32>(_e1984[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2097 = ((1f - abs(_e2087)) - abs(_e2093));
                if (_e2097 < 0f) {
                    phi_2805_ = -(_e2097);
                } else {
                    phi_2805_ = 0f;
                }
                let _e2101 = phi_2805_;
                if (_e2087 < 0f) {
                    phi_2812_ = (_e2087 + _e2101);
                } else {
                    phi_2812_ = (_e2087 - _e2101);
                }
                let _e2106 = phi_2812_;
                if (_e2093 < 0f) {
                    phi_2819_ = (_e2093 + _e2101);
                } else {
                    phi_2819_ = (_e2093 - _e2101);
                }
                let _e2111 = phi_2819_;
                let _e2118 = (1f / sqrt((((_e2106 * _e2106) + (_e2111 * _e2111)) + (_e2097 * _e2097))));
                let _e2134 = (f32((bitcast<i32>((_e1984[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2140 = (f32((bitcast<i32>(_e1984[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2144 = ((1f - abs(_e2134)) - abs(_e2140));
                if (_e2144 < 0f) {
                    phi_2854_ = -(_e2144);
                } else {
                    phi_2854_ = 0f;
                }
                let _e2148 = phi_2854_;
                if (_e2134 < 0f) {
                    phi_2861_ = (_e2134 + _e2148);
                } else {
                    phi_2861_ = (_e2134 - _e2148);
                }
                let _e2153 = phi_2861_;
                if (_e2140 < 0f) {
                    phi_2868_ = (_e2140 + _e2148);
                } else {
                    phi_2868_ = (_e2140 - _e2148);
                }
                let _e2158 = phi_2868_;
                let _e2165 = (1f / sqrt((((_e2153 * _e2153) + (_e2158 * _e2158)) + (_e2144 * _e2144))));
                let _e2184 = (f32((bitcast<i32>((_e1984[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2190 = (f32((bitcast<i32>(_e1984[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2194 = ((1f - abs(_e2184)) - abs(_e2190));
                if (_e2194 < 0f) {
                    phi_2906_ = -(_e2194);
                } else {
                    phi_2906_ = 0f;
                }
                let _e2198 = phi_2906_;
                if (_e2184 < 0f) {
                    phi_2913_ = (_e2184 + _e2198);
                } else {
                    phi_2913_ = (_e2184 - _e2198);
                }
                let _e2203 = phi_2913_;
                if (_e2190 < 0f) {
                    phi_2920_ = (_e2190 + _e2198);
                } else {
                    phi_2920_ = (_e2190 - _e2198);
                }
                let _e2208 = phi_2920_;
                let _e2215 = (1f / sqrt((((_e2203 * _e2203) + (_e2208 * _e2208)) + (_e2194 * _e2194))));
                let _e2226 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2106 * _e2118) * _e1818) + ((_e2153 * _e2165) * _e1812.u)) + ((_e2203 * _e2215) * _e1812.v)), ((((_e2111 * _e2118) * _e1818) + ((_e2158 * _e2165) * _e1812.u)) + ((_e2208 * _e2215) * _e1812.v)), ((((_e2097 * _e2118) * _e1818) + ((_e2144 * _e2165) * _e1812.u)) + ((_e2194 * _e2215) * _e1812.v))));
                let _e2238 = sqrt((((_e2226.x * _e2226.x) + (_e2226.y * _e2226.y)) + (_e2226.z * _e2226.z)));
                if (_e2238 > 0f) {
                    let _e2241 = (_e2226.x / _e2238);
                    let _e2243 = (_e2226.y / _e2238);
                    let _e2245 = (_e2226.z / _e2238);
                    if ((((_e2241 * _e1962.x) + (_e2243 * _e1962.y)) + (_e2245 * _e1962.z)) < 0f) {
                        phi_2979_ = vec3<f32>(-(_e2241), -(_e2243), -(_e2245));
                    } else {
                        phi_2979_ = (_e2226 / vec3(_e2238));
                    }
                    let _e2262 = phi_2979_;
                    phi_2980_ = _e2262;
                } else {
                    phi_2980_ = _e1962;
                }
                let _e2264 = phi_2980_;
                phi_2981_ = _e2264;
            }
            let _e2266 = phi_2981_;
            if (_e2063 > 0f) {
                if (_e2063 < 1f) {
                    phi_2990_ = _e2063;
                } else {
                    phi_2990_ = 1f;
                }
                let _e2270 = phi_2990_;
                phi_2991_ = _e2270;
            } else {
                phi_2991_ = 0f;
            }
            let _e2272 = phi_2991_;
            if (_e2065 > 0f) {
                if (_e2065 < 1f) {
                    phi_3001_ = _e2065;
                } else {
                    phi_3001_ = 1f;
                }
                let _e2277 = phi_3001_;
                phi_3002_ = _e2277;
            } else {
                phi_3002_ = 0f;
            }
            let _e2279 = phi_3002_;
            if (_e2067 > 0f) {
                if (_e2067 < 1f) {
                    phi_3012_ = _e2067;
                } else {
                    phi_3012_ = 1f;
                }
                let _e2284 = phi_3012_;
                phi_3013_ = _e2284;
            } else {
                phi_3013_ = 0f;
            }
            let _e2286 = phi_3013_;
            let _e2289 = ((sqrt(_e2272) * 255f) + 0.5f);
            let _e2298 = ((sqrt(_e2279) * 255f) + 0.5f);
            let _e2310 = ((sqrt(_e2286) * 255f) + 0.5f);
            phi_3048_ = abi_Sample(vec3<f32>(_e1849, _e1850, _e1851), _e2069, _e1962, _e2074, _e2266, ((select(select(u32(_e2289), 0u, (_e2289 < bitcast<f32>(0u))), 4294967295u, (_e2289 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2298), 0u, (_e2298 < bitcast<f32>(0u))), 4294967295u, (_e2298 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2310), 0u, (_e2310 < bitcast<f32>(0u))), 4294967295u, (_e2310 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_3048_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2324 = phi_3048_;
        if (_e97.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e97.first_primitive)] = _e2324;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
