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

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct texture_TextureView {
    offset: u32,
    size: u32,
    flags: u32,
}

struct lt_bvh_Triangle {
    v0_: vec3<f32>,
    i0_: u32,
    v1_: vec3<f32>,
    i1_: u32,
    v2_: vec3<f32>,
    i2_: u32,
}

struct type_27 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_31 {
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

struct type_35 {
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

struct type_45 {
    member: abi_CameraParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_50 {
    member: array<lt_bvh_Node>,
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

var<private> id_1: vec3<u32>;
@group(0) @binding(3) 
var<storage> vertices: type_31;
@group(0) @binding(4) 
var<storage> materials: type_35;
@group(0) @binding(0) 
var<uniform> p: type_45;
@group(0) @binding(1) 
var<storage> nodes: type_50;
@group(0) @binding(2) 
var<storage> triangles: type_27;
@group(0) @binding(5) 
var<storage, read_write> samples: type_9;
@group(0) @binding(6) 
var<storage> alpha_texels: type_13;
@group(0) @binding(7) 
var<storage> color_texels: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_212_: lt_bvh_traverse_Tree;
    var phi_213_: bool;
    var phi_214_: lt_bvh_traverse_Tree;
    var phi_215_: bool;
    var phi_220_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_212_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_213_ = false;
        } else {
            phi_212_ = lt_bvh_traverse_Tree();
            phi_213_ = true;
        }
        let _e83 = phi_212_;
        let _e85 = phi_213_;
        phi_214_ = _e83;
        phi_215_ = _e85;
    } else {
        phi_214_ = lt_bvh_traverse_Tree();
        phi_215_ = true;
    }
    let _e87 = phi_214_;
    let _e89 = phi_215_;
    if _e89 {
        phi_220_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_220_ = _e87;
    }
    let _e94 = phi_220_;
    return lt_bvh_traverse_Tree(_e94.root, _e94.first_primitive);
}

fn _lt_shaders_texture_TextureView_quad(param_3: ptr<function, texture_TextureView>, param_4: f32, param_5: f32) -> texture_TexelQuad {
    var phi_265_: f32;
    var phi_270_: f32;
    var phi_271_: bool;
    var phi_272_: f32;
    var phi_273_: bool;
    var phi_277_: f32;
    var phi_303_: f32;
    var phi_308_: f32;
    var phi_309_: bool;
    var phi_310_: f32;
    var phi_311_: bool;
    var phi_315_: f32;
    var phi_323_: f32;
    var phi_324_: f32;
    var phi_325_: f32;
    var phi_334_: f32;
    var phi_335_: f32;
    var phi_353_: u32;
    var phi_367_: u32;
    var phi_374_: u32;
    var phi_379_: u32;
    var phi_385_: u32;
    var phi_390_: u32;
    var phi_392_: texture_Axis;
    var phi_420_: f32;
    var phi_425_: f32;
    var phi_426_: bool;
    var phi_427_: f32;
    var phi_428_: bool;
    var phi_432_: f32;
    var phi_458_: f32;
    var phi_463_: f32;
    var phi_464_: bool;
    var phi_465_: f32;
    var phi_466_: bool;
    var phi_470_: f32;
    var phi_478_: f32;
    var phi_479_: f32;
    var phi_480_: f32;
    var phi_489_: f32;
    var phi_490_: f32;
    var phi_508_: u32;
    var phi_522_: u32;
    var phi_529_: u32;
    var phi_534_: u32;
    var phi_540_: u32;
    var phi_545_: u32;
    var phi_547_: texture_Axis;

    let _e74 = (*param_3).size;
    let _e75 = (_e74 & 65535u);
    let _e77 = (*param_3).size;
    let _e79 = (_e77 >> bitcast<u32>(16i));
    let _e81 = (*param_3).flags;
    let _e83 = ((_e81 & 4u) != 0u);
    let _e85 = (*param_3).flags;
    let _e88 = ((_e85 >> bitcast<u32>(4u)) & 3u);
    if (_e88 == 0u) {
        if (param_4 > -8388608f) {
            let _e101 = f32(select(0i, select(select(i32(param_4), i32(-2147483648), (param_4 < bitcast<f32>(3472883712u))), 2147483647i, (param_4 > bitcast<f32>(1325400063u))), (param_4 == param_4)));
            if (_e101 > param_4) {
                phi_265_ = 1f;
            } else {
                phi_265_ = 0f;
            }
            let _e104 = phi_265_;
            if (param_4 < 8388608f) {
                phi_270_ = (_e101 - _e104);
                phi_271_ = false;
            } else {
                phi_270_ = f32();
                phi_271_ = true;
            }
            let _e107 = phi_270_;
            let _e109 = phi_271_;
            phi_272_ = _e107;
            phi_273_ = _e109;
        } else {
            phi_272_ = f32();
            phi_273_ = true;
        }
        let _e111 = phi_272_;
        let _e113 = phi_273_;
        if _e113 {
            phi_277_ = param_4;
        } else {
            phi_277_ = _e111;
        }
        let _e115 = phi_277_;
        phi_325_ = (param_4 - _e115);
    } else {
        if (_e88 == 1u) {
            let _e118 = (param_4 * 0.5f);
            if (_e118 > -8388608f) {
                let _e130 = f32(select(0i, select(select(i32(_e118), i32(-2147483648), (_e118 < bitcast<f32>(3472883712u))), 2147483647i, (_e118 > bitcast<f32>(1325400063u))), (_e118 == _e118)));
                if (_e130 > _e118) {
                    phi_303_ = 1f;
                } else {
                    phi_303_ = 0f;
                }
                let _e133 = phi_303_;
                if (_e118 < 8388608f) {
                    phi_308_ = (_e130 - _e133);
                    phi_309_ = false;
                } else {
                    phi_308_ = f32();
                    phi_309_ = true;
                }
                let _e136 = phi_308_;
                let _e138 = phi_309_;
                phi_310_ = _e136;
                phi_311_ = _e138;
            } else {
                phi_310_ = f32();
                phi_311_ = true;
            }
            let _e140 = phi_310_;
            let _e142 = phi_311_;
            if _e142 {
                phi_315_ = _e118;
            } else {
                phi_315_ = _e140;
            }
            let _e144 = phi_315_;
            let _e146 = (param_4 - (2f * _e144));
            if (_e146 > 1f) {
                phi_323_ = (2f - _e146);
            } else {
                phi_323_ = _e146;
            }
            let _e150 = phi_323_;
            phi_324_ = _e150;
        } else {
            phi_324_ = param_4;
        }
        let _e152 = phi_324_;
        phi_325_ = _e152;
    }
    let _e154 = phi_325_;
    if (_e154 > 0f) {
        if (_e154 < 1f) {
            phi_334_ = _e154;
        } else {
            phi_334_ = 1f;
        }
        let _e158 = phi_334_;
        phi_335_ = _e158;
    } else {
        phi_335_ = 0f;
    }
    let _e160 = phi_335_;
    let _e161 = (_e75 - 1u);
    let _e163 = (_e160 * f32(_e75));
    if _e83 {
        let _e170 = select(select(u32(_e163), 0u, (_e163 < bitcast<f32>(0u))), 4294967295u, (_e163 > bitcast<f32>(1333788671u)));
        if (_e161 < _e170) {
            phi_353_ = _e161;
        } else {
            phi_353_ = _e170;
        }
        let _e173 = phi_353_;
        phi_392_ = texture_Axis(_e173, _e173, 0f);
    } else {
        let _e175 = (_e163 + 0.5f);
        let _e182 = select(select(u32(_e175), 0u, (_e175 < bitcast<f32>(0u))), 4294967295u, (_e175 > bitcast<f32>(1333788671u)));
        if (_e75 < _e182) {
            phi_367_ = _e75;
        } else {
            phi_367_ = _e182;
        }
        let _e185 = phi_367_;
        if (_e88 == 0u) {
            phi_374_ = _e161;
        } else {
            phi_374_ = 0u;
        }
        let _e190 = phi_374_;
        if (_e88 == 0u) {
            phi_379_ = 0u;
        } else {
            phi_379_ = _e161;
        }
        let _e193 = phi_379_;
        if (_e185 == 0u) {
            phi_385_ = _e190;
        } else {
            phi_385_ = (_e185 - 1u);
        }
        let _e197 = phi_385_;
        if (_e185 > _e161) {
            phi_390_ = _e193;
        } else {
            phi_390_ = _e185;
        }
        let _e200 = phi_390_;
        phi_392_ = texture_Axis(_e197, _e200, (_e175 - f32(_e185)));
    }
    let _e203 = phi_392_;
    let _e205 = (*param_3).flags;
    let _e208 = ((_e205 >> bitcast<u32>(6u)) & 3u);
    if (_e208 == 0u) {
        if (param_5 > -8388608f) {
            let _e221 = f32(select(0i, select(select(i32(param_5), i32(-2147483648), (param_5 < bitcast<f32>(3472883712u))), 2147483647i, (param_5 > bitcast<f32>(1325400063u))), (param_5 == param_5)));
            if (_e221 > param_5) {
                phi_420_ = 1f;
            } else {
                phi_420_ = 0f;
            }
            let _e224 = phi_420_;
            if (param_5 < 8388608f) {
                phi_425_ = (_e221 - _e224);
                phi_426_ = false;
            } else {
                phi_425_ = f32();
                phi_426_ = true;
            }
            let _e227 = phi_425_;
            let _e229 = phi_426_;
            phi_427_ = _e227;
            phi_428_ = _e229;
        } else {
            phi_427_ = f32();
            phi_428_ = true;
        }
        let _e231 = phi_427_;
        let _e233 = phi_428_;
        if _e233 {
            phi_432_ = param_5;
        } else {
            phi_432_ = _e231;
        }
        let _e235 = phi_432_;
        phi_480_ = (param_5 - _e235);
    } else {
        if (_e208 == 1u) {
            let _e238 = (param_5 * 0.5f);
            if (_e238 > -8388608f) {
                let _e250 = f32(select(0i, select(select(i32(_e238), i32(-2147483648), (_e238 < bitcast<f32>(3472883712u))), 2147483647i, (_e238 > bitcast<f32>(1325400063u))), (_e238 == _e238)));
                if (_e250 > _e238) {
                    phi_458_ = 1f;
                } else {
                    phi_458_ = 0f;
                }
                let _e253 = phi_458_;
                if (_e238 < 8388608f) {
                    phi_463_ = (_e250 - _e253);
                    phi_464_ = false;
                } else {
                    phi_463_ = f32();
                    phi_464_ = true;
                }
                let _e256 = phi_463_;
                let _e258 = phi_464_;
                phi_465_ = _e256;
                phi_466_ = _e258;
            } else {
                phi_465_ = f32();
                phi_466_ = true;
            }
            let _e260 = phi_465_;
            let _e262 = phi_466_;
            if _e262 {
                phi_470_ = _e238;
            } else {
                phi_470_ = _e260;
            }
            let _e264 = phi_470_;
            let _e266 = (param_5 - (2f * _e264));
            if (_e266 > 1f) {
                phi_478_ = (2f - _e266);
            } else {
                phi_478_ = _e266;
            }
            let _e270 = phi_478_;
            phi_479_ = _e270;
        } else {
            phi_479_ = param_5;
        }
        let _e272 = phi_479_;
        phi_480_ = _e272;
    }
    let _e274 = phi_480_;
    if (_e274 > 0f) {
        if (_e274 < 1f) {
            phi_489_ = _e274;
        } else {
            phi_489_ = 1f;
        }
        let _e278 = phi_489_;
        phi_490_ = _e278;
    } else {
        phi_490_ = 0f;
    }
    let _e280 = phi_490_;
    let _e281 = (_e79 - 1u);
    let _e283 = (_e280 * f32(_e79));
    if _e83 {
        let _e290 = select(select(u32(_e283), 0u, (_e283 < bitcast<f32>(0u))), 4294967295u, (_e283 > bitcast<f32>(1333788671u)));
        if (_e281 < _e290) {
            phi_508_ = _e281;
        } else {
            phi_508_ = _e290;
        }
        let _e293 = phi_508_;
        phi_547_ = texture_Axis(_e293, _e293, 0f);
    } else {
        let _e295 = (_e283 + 0.5f);
        let _e302 = select(select(u32(_e295), 0u, (_e295 < bitcast<f32>(0u))), 4294967295u, (_e295 > bitcast<f32>(1333788671u)));
        if (_e79 < _e302) {
            phi_522_ = _e79;
        } else {
            phi_522_ = _e302;
        }
        let _e305 = phi_522_;
        if (_e208 == 0u) {
            phi_529_ = _e281;
        } else {
            phi_529_ = 0u;
        }
        let _e310 = phi_529_;
        if (_e208 == 0u) {
            phi_534_ = 0u;
        } else {
            phi_534_ = _e281;
        }
        let _e313 = phi_534_;
        if (_e305 == 0u) {
            phi_540_ = _e310;
        } else {
            phi_540_ = (_e305 - 1u);
        }
        let _e317 = phi_540_;
        if (_e305 > _e281) {
            phi_545_ = _e313;
        } else {
            phi_545_ = _e305;
        }
        let _e320 = phi_545_;
        phi_547_ = texture_Axis(_e317, _e320, (_e295 - f32(_e305)));
    }
    let _e323 = phi_547_;
    let _e327 = (*param_3).offset;
    let _e334 = (*param_3).offset;
    let _e341 = (*param_3).offset;
    let _e348 = (*param_3).offset;
    return texture_TexelQuad(array<u32, 4>(((_e327 + (_e323.low * _e75)) + _e203.low), ((_e334 + (_e323.low * _e75)) + _e203.high), ((_e341 + (_e323.high * _e75)) + _e203.low), ((_e348 + (_e323.high * _e75)) + _e203.high)), vec4<f32>(((1f - _e203.fraction) * (1f - _e323.fraction)), (_e203.fraction * (1f - _e323.fraction)), ((1f - _e203.fraction) * _e323.fraction), (_e203.fraction * _e323.fraction)));
}

fn _lt_bvh_ray_Ray_new(param_6: vec3<f32>, param_7: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_6, 0f, param_7, 300000000000000000000000000000000000000f);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_8: f32, param_9: f32) -> f32 {
    var phi_610_: bool;
    var phi_614_: f32;

    if (param_8 != param_8) {
        phi_610_ = true;
    } else {
        let _e73 = (param_9 >= param_8);
        if _e73 {
        }
        phi_610_ = _e73;
    }
    let _e75 = phi_610_;
    if _e75 {
        phi_614_ = param_9;
    } else {
        phi_614_ = param_8;
    }
    let _e77 = phi_614_;
    return _e77;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_10: f32, param_11: f32) -> f32 {
    var phi_626_: bool;
    var phi_630_: f32;

    if (param_10 != param_10) {
        phi_626_ = true;
    } else {
        let _e73 = (param_11 <= param_10);
        if _e73 {
        }
        phi_626_ = _e73;
    }
    let _e75 = phi_626_;
    if _e75 {
        phi_630_ = param_11;
    } else {
        phi_630_ = param_10;
    }
    let _e77 = phi_630_;
    return _e77;
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_12: f32, param_13: f32) -> f32 {
    var phi_638_: f32;

    if (param_12 > param_13) {
        phi_638_ = param_12;
    } else {
        phi_638_ = param_13;
    }
    let _e74 = phi_638_;
    return _e74;
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(param_14: vec3<f32>) -> vec3<f32> {
    return param_14;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: texture_TextureView;
    var local_2: lt_bvh_traverse_Stack;
    var phi_791_: bool;
    var phi_792_: bool;
    var phi_793_: bool;
    var phi_797_: bool;
    var phi_798_: bool;
    var phi_799_: bool;
    var phi_800_: bool;
    var phi_801_: bool;
    var phi_802_: bool;
    var phi_803_: bool;
    var phi_804_: bool;
    var phi_805_: bool;
    var phi_806_: bool;
    var phi_807_: bool;
    var phi_808_: bool;
    var phi_809_: bool;
    var phi_810_: bool;
    var phi_811_: bool;
    var phi_812_: bool;
    var phi_813_: bool;
    var phi_814_: bool;
    var phi_818_: bool;
    var phi_822_: bool;
    var phi_897_: f32;
    var phi_904_: f32;
    var phi_912_: f32;
    var phi_919_: f32;
    var phi_927_: f32;
    var phi_934_: f32;
    var phi_959_: f32;
    var phi_964_: f32;
    var phi_969_: f32;
    var phi_1002_: bool;
    var phi_1003_: bool;
    var phi_1011_: u32;
    var phi_1012_: u32;
    var phi_1030_: vec3<f32>;
    var phi_1031_: vec3<f32>;
    var phi_1045_: u32;
    var phi_1050_: u32;
    var phi_1055_: u32;
    var phi_1169_: bool;
    var phi_1170_: bool;
    var phi_1201_: u32;
    var phi_1203_: lt_bvh_Hit;
    var phi_1206_: u32;
    var phi_1291_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1318_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1345_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1351_: u32;
    var phi_1354_: u32;
    var phi_1368_: u32;
    var phi_1378_: u32;
    var phi_1388_: u32;
    var phi_1406_: u32;
    var phi_1416_: u32;
    var phi_1426_: u32;
    var phi_1462_: u32;
    var phi_1475_: u32;
    var phi_1480_: u32;
    var phi_1481_: u32;
    var phi_1482_: u32;
    var phi_1352_: u32;
    var phi_1355_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1540_: lt_bvh_Hit;
    var phi_1543_: u32;
    var phi_1589_: vec3<f32>;
    var phi_1590_: vec3<f32>;
    var phi_1623_: vec3<f32>;
    var phi_1624_: vec3<f32>;
    var phi_1657_: vec3<f32>;
    var phi_1658_: vec3<f32>;
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
    var phi_1831_: f32;
    var phi_1840_: f32;
    var phi_1849_: f32;
    var phi_1858_: f32;
    var phi_1865_: f32;
    var phi_1872_: f32;
    var phi_1885_: f32;
    var phi_1894_: f32;
    var phi_1903_: f32;
    var phi_1912_: f32;
    var phi_1919_: f32;
    var phi_1926_: f32;
    var phi_1949_: f32;
    var phi_1954_: f32;
    var phi_1959_: f32;
    var phi_1967_: f32;
    var phi_1972_: f32;
    var phi_1977_: f32;
    var phi_1989_: f32;
    var phi_1994_: f32;
    var phi_1999_: f32;
    var phi_2004_: f32;
    var phi_2009_: lt_bvh_triangle_Intersection;
    var phi_2010_: bool;
    var phi_2011_: lt_bvh_triangle_Intersection;
    var phi_2012_: bool;
    var phi_2016_: lt_bvh_triangle_Intersection;
    var phi_2017_: bool;
    var phi_2018_: lt_bvh_triangle_Intersection;
    var phi_2019_: bool;
    var phi_2020_: bool;
    var phi_2024_: bool;
    var phi_2028_: lt_bvh_triangle_Intersection;
    var phi_2067_: bool;
    var phi_2068_: bool;
    var phi_2069_: bool;
    var phi_2070_: bool;
    var phi_2071_: bool;
    var phi_2072_: bool;
    var phi_2076_: bool;
    var phi_2077_: bool;
    var phi_2280_: f32;
    var phi_2283_: bool;
    var phi_2284_: bool;
    var phi_2288_: bool;
    var phi_2296_: lt_bvh_Hit;
    var phi_2297_: lt_bvh_Hit;
    var phi_2298_: lt_bvh_Hit;
    var phi_2299_: lt_bvh_Hit;
    var phi_1541_: lt_bvh_Hit;
    var phi_1544_: u32;
    var phi_2300_: bool;
    var phi_2339_: bool;
    var phi_2340_: bool;
    var phi_2371_: u32;
    var phi_1204_: lt_bvh_Hit;
    var phi_1207_: u32;
    var phi_2372_: lt_bvh_Hit;
    var phi_2373_: lt_bvh_Hit;
    var phi_2374_: bool;
    var phi_2378_: lt_bvh_Hit;
    var phi_2442_: f32;
    var phi_2447_: f32;
    var phi_2452_: f32;
    var phi_2463_: f32;
    var phi_2468_: f32;
    var phi_2473_: f32;
    var phi_2549_: vec3<f32>;
    var phi_2792_: vec3<f32>;
    var phi_2807_: u32;
    var phi_2834_: f32;
    var phi_2841_: f32;
    var phi_2848_: f32;
    var phi_2883_: f32;
    var phi_2890_: f32;
    var phi_2897_: f32;
    var phi_2935_: f32;
    var phi_2942_: f32;
    var phi_2949_: f32;
    var phi_3008_: vec3<f32>;
    var phi_3009_: vec3<f32>;
    var phi_3010_: vec3<f32>;
    var phi_3019_: f32;
    var phi_3020_: f32;
    var phi_3030_: f32;
    var phi_3031_: f32;
    var phi_3041_: f32;
    var phi_3042_: f32;
    var phi_3077_: abi_Sample;
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
    if (bitcast<i32>(_e101.root) != 0i) {
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
        let _e168 = abs(_e156.direction.x);
        let _e170 = abs(_e156.direction.y);
        let _e172 = abs(_e156.direction.z);
        if (abs(_e156.origin.x) < 1000000000000000f) {
            if (abs(_e156.origin.y) < 1000000000000000f) {
                if (abs(_e156.origin.z) < 1000000000000000f) {
                    if (_e168 < 1000000000000000f) {
                        if (_e170 < 1000000000000000f) {
                            if (_e172 < 1000000000000000f) {
                                if (_e168 > 0f) {
                                    phi_792_ = bool();
                                    phi_793_ = true;
                                } else {
                                    let _e180 = (_e170 > 0f);
                                    if _e180 {
                                        phi_791_ = bool();
                                    } else {
                                        phi_791_ = (_e172 > 0f);
                                    }
                                    let _e183 = phi_791_;
                                    phi_792_ = _e183;
                                    phi_793_ = _e180;
                                }
                                let _e185 = phi_792_;
                                let _e187 = phi_793_;
                                if _e187 {
                                    phi_797_ = true;
                                } else {
                                    phi_797_ = _e185;
                                }
                                let _e189 = phi_797_;
                                phi_798_ = _e189;
                                phi_799_ = false;
                            } else {
                                phi_798_ = bool();
                                phi_799_ = true;
                            }
                            let _e191 = phi_798_;
                            let _e193 = phi_799_;
                            phi_800_ = _e191;
                            phi_801_ = false;
                            phi_802_ = _e193;
                        } else {
                            phi_800_ = bool();
                            phi_801_ = true;
                            phi_802_ = false;
                        }
                        let _e195 = phi_800_;
                        let _e197 = phi_801_;
                        let _e199 = phi_802_;
                        phi_803_ = _e195;
                        phi_804_ = _e197;
                        phi_805_ = _e199;
                    } else {
                        phi_803_ = bool();
                        phi_804_ = true;
                        phi_805_ = false;
                    }
                    let _e201 = phi_803_;
                    let _e203 = phi_804_;
                    let _e205 = phi_805_;
                    phi_806_ = _e201;
                    phi_807_ = _e203;
                    phi_808_ = _e205;
                } else {
                    phi_806_ = bool();
                    phi_807_ = true;
                    phi_808_ = false;
                }
                let _e207 = phi_806_;
                let _e209 = phi_807_;
                let _e211 = phi_808_;
                phi_809_ = _e207;
                phi_810_ = _e209;
                phi_811_ = _e211;
            } else {
                phi_809_ = bool();
                phi_810_ = true;
                phi_811_ = false;
            }
            let _e213 = phi_809_;
            let _e215 = phi_810_;
            let _e217 = phi_811_;
            phi_812_ = _e213;
            phi_813_ = _e215;
            phi_814_ = _e217;
        } else {
            phi_812_ = bool();
            phi_813_ = true;
            phi_814_ = false;
        }
        let _e219 = phi_812_;
        let _e221 = phi_813_;
        let _e223 = phi_814_;
        if _e221 {
            phi_818_ = true;
        } else {
            phi_818_ = _e223;
        }
        let _e225 = phi_818_;
        if _e225 {
            phi_822_ = false;
        } else {
            phi_822_ = _e219;
        }
        let _e227 = phi_822_;
        if _e227 {
            let _e228 = (0u >= _e77);
            if _e228 {
                phi_2372_ = lt_bvh_Hit();
            } else {
                if (0u < _e77) {
                } else {
                    return;
                }
                let _e234 = nodes.member[(0u + 0u)].frame[0u];
                let _e238 = nodes.member[(0u + 0u)].frame[1u];
                let _e242 = nodes.member[(0u + 0u)].frame[2u];
                let _e246 = nodes.member[(0u + 0u)].frame[0u];
                let _e250 = nodes.member[(0u + 0u)].frame[1u];
                let _e254 = nodes.member[(0u + 0u)].frame[2u];
                let _e258 = nodes.member[(0u + 0u)].frame[3u];
                let _e296 = core_intrinsics_maximum_number_nsz_f32_(abs(_e156.direction.x), abs(_e156.direction.y));
                let _e297 = core_intrinsics_maximum_number_nsz_f32_(_e296, abs(_e156.direction.z));
                let _e298 = (_e297 * 0.0000000000009094947f);
                if (abs(_e156.direction.x) < _e298) {
                    phi_897_ = _e298;
                } else {
                    phi_897_ = abs(_e156.direction.x);
                }
                let _e305 = phi_897_;
                if (_e156.direction.x < 0f) {
                    phi_904_ = (-1f / _e305);
                } else {
                    phi_904_ = (1f / _e305);
                }
                let _e310 = phi_904_;
                if (abs(_e156.direction.y) < _e298) {
                    phi_912_ = _e298;
                } else {
                    phi_912_ = abs(_e156.direction.y);
                }
                let _e317 = phi_912_;
                if (_e156.direction.y < 0f) {
                    phi_919_ = (-1f / _e317);
                } else {
                    phi_919_ = (1f / _e317);
                }
                let _e322 = phi_919_;
                if (abs(_e156.direction.z) < _e298) {
                    phi_927_ = _e298;
                } else {
                    phi_927_ = abs(_e156.direction.z);
                }
                let _e329 = phi_927_;
                if (_e156.direction.z < 0f) {
                    phi_934_ = (-1f / _e329);
                } else {
                    phi_934_ = (1f / _e329);
                }
                let _e334 = phi_934_;
                let _e342 = abs((bitcast<f32>(_e234) - _e156.origin.x));
                let _e343 = abs((bitcast<f32>(_e238) - _e156.origin.y));
                let _e344 = abs((bitcast<f32>(_e242) - _e156.origin.z));
                let _e352 = abs(((bitcast<f32>(_e246) + (bitcast<f32>((((_e258 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e156.origin.x));
                let _e353 = abs(((bitcast<f32>(_e250) + (bitcast<f32>((((_e258 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e156.origin.y));
                let _e354 = abs(((bitcast<f32>(_e254) + (bitcast<f32>((((_e258 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e156.origin.z));
                if (_e342 > _e352) {
                    phi_959_ = _e342;
                } else {
                    phi_959_ = _e352;
                }
                let _e357 = phi_959_;
                if (_e343 > _e353) {
                    phi_964_ = _e343;
                } else {
                    phi_964_ = _e353;
                }
                let _e360 = phi_964_;
                if (_e344 > _e354) {
                    phi_969_ = _e344;
                } else {
                    phi_969_ = _e354;
                }
                let _e363 = phi_969_;
                let _e364 = core_intrinsics_maximum_number_nsz_f32_(_e357, _e360);
                let _e365 = core_intrinsics_maximum_number_nsz_f32_(_e364, _e363);
                let _e370 = (_e365 * 0.0000019073486f);
                let _e371 = (abs(_e310) * _e370);
                let _e372 = (abs(_e322) * _e370);
                let _e373 = (abs(_e334) * _e370);
                let _e377 = (_e365 * 0.0000009536743f);
                let _e378 = (abs(_e310) * _e377);
                let _e379 = (abs(_e322) * _e377);
                let _e380 = (abs(_e334) * _e377);
                let _e383 = abs(_e156.direction.x);
                let _e385 = abs(_e156.direction.y);
                let _e387 = abs(_e156.direction.z);
                if (_e383 >= _e385) {
                    if (_e383 >= _e387) {
                        phi_1002_ = false;
                    } else {
                        phi_1002_ = true;
                    }
                    let _e391 = phi_1002_;
                    phi_1003_ = _e391;
                } else {
                    phi_1003_ = true;
                }
                let _e393 = phi_1003_;
                if _e393 {
                    if (_e385 >= _e387) {
                        phi_1011_ = 1u;
                    } else {
                        phi_1011_ = 2u;
                    }
                    let _e396 = phi_1011_;
                    phi_1012_ = _e396;
                } else {
                    phi_1012_ = 0u;
                }
                let _e398 = phi_1012_;
                if (_e398 == 0u) {
                    phi_1031_ = vec3<f32>(_e156.direction.y, _e156.direction.z, _e156.direction.x);
                } else {
                    if (_e398 == 1u) {
                        phi_1030_ = vec3<f32>(_e156.direction.z, _e156.direction.x, _e156.direction.y);
                    } else {
                        phi_1030_ = _e156.direction;
                    }
                    let _e411 = phi_1030_;
                    phi_1031_ = _e411;
                }
                let _e413 = phi_1031_;
                let _e417 = (_e413.x / _e413.z);
                let _e420 = (_e413.y / _e413.z);
                let _e422 = (1f / _e413.z);
                if (_e310 < 0f) {
                    phi_1045_ = 0u;
                } else {
                    phi_1045_ = 1u;
                }
                let _e425 = phi_1045_;
                if (_e322 < 0f) {
                    phi_1050_ = 0u;
                } else {
                    phi_1050_ = 2u;
                }
                let _e428 = phi_1050_;
                if (_e334 < 0f) {
                    phi_1055_ = 0u;
                } else {
                    phi_1055_ = 4u;
                }
                let _e431 = phi_1055_;
                let _e433 = ((_e425 | _e428) | _e431);
                let _e434 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e434.first[0], _e434.first[1], _e434.first[2], _e434.first[3], _e434.first[4], _e434.first[5], _e434.first[6], _e434.first[7], _e434.first[8], _e434.first[9], _e434.first[10], _e434.first[11], _e434.first[12], _e434.first[13], _e434.first[14], _e434.first[15], _e434.first[16], _e434.first[17], _e434.first[18], _e434.first[19], _e434.first[20], _e434.first[21], _e434.first[22], _e434.first[23], _e434.first[24], _e434.first[25], _e434.first[26], _e434.first[27], _e434.first[28], _e434.first[29], _e434.first[30], _e434.first[31]), array<u32, 32>(_e434.mask[0], _e434.mask[1], _e434.mask[2], _e434.mask[3], _e434.mask[4], _e434.mask[5], _e434.mask[6], _e434.mask[7], _e434.mask[8], _e434.mask[9], _e434.mask[10], _e434.mask[11], _e434.mask[12], _e434.mask[13], _e434.mask[14], _e434.mask[15], _e434.mask[16], _e434.mask[17], _e434.mask[18], _e434.mask[19], _e434.mask[20], _e434.mask[21], _e434.mask[22], _e434.mask[23], _e434.mask[24], _e434.mask[25], _e434.mask[26], _e434.mask[27], _e434.mask[28], _e434.mask[29], _e434.mask[30], _e434.mask[31]), _e434.len, _e434.group, _e434.group_mask);
                let _e508 = local_2.group_mask;
                if ((_e508 & 4278190080u) == 0u) {
                    let _e512 = local_2.len;
                    if (_e512 == 0u) {
                        phi_1169_ = false;
                    } else {
                        let _e516 = local_2.len;
                        local_2.len = (_e516 - 1u);
                        let _e519 = local_2.len;
                        if (_e519 < 32u) {
                        } else {
                            return;
                        }
                        let _e524 = local_2.first[(0u + _e519)];
                        local_2.group = _e524;
                        let _e527 = local_2.len;
                        if (_e527 < 32u) {
                        } else {
                            return;
                        }
                        let _e532 = local_2.mask[(0u + _e527)];
                        local_2.group_mask = _e532;
                        phi_1169_ = true;
                    }
                    let _e535 = phi_1169_;
                    phi_1170_ = _e535;
                } else {
                    phi_1170_ = true;
                }
                let _e537 = phi_1170_;
                if _e537 {
                    let _e539 = local_2.group_mask;
                    let _e545 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e539)), 32u, (_e539 == 0u)));
                    let _e549 = local_2.group_mask;
                    let _e563 = local_2.group_mask;
                    local_2.group_mask = (_e563 & ~((1u << bitcast<u32>((_e545 & 31u)))));
                    let _e566 = local_2.group;
                    phi_1201_ = (_e566 + countOneBits(((_e549 & ~((4294967295u << bitcast<u32>((((_e545 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1201_ = 4294967295u;
                }
                let _e569 = phi_1201_;
                phi_1203_ = _e158;
                phi_1206_ = _e569;
                loop {
                    let _e571 = phi_1203_;
                    let _e573 = phi_1206_;
                    local_7 = _e571;
                    let _e574 = (_e573 != 4294967295u);
                    if _e574 {
                        if (_e573 < _e77) {
                        } else {
                            return;
                        }
                        let _e582 = nodes.member[(0u + _e573)].frame[3u];
                        let _e607 = (bitcast<f32>((((_e582 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e310);
                        let _e608 = (bitcast<f32>((((_e582 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e322);
                        let _e609 = (bitcast<f32>((((_e582 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e334);
                        let _e612 = nodes.member[(0u + _e573)].frame[0u];
                        let _e616 = nodes.member[(0u + _e573)].frame[1u];
                        let _e620 = nodes.member[(0u + _e573)].frame[2u];
                        let _e628 = ((bitcast<f32>(_e612) - _e156.origin.x) * _e310);
                        let _e629 = ((bitcast<f32>(_e616) - _e156.origin.y) * _e322);
                        let _e630 = ((bitcast<f32>(_e620) - _e156.origin.z) * _e334);
                        let _e638 = nodes.member[(0u + _e573)].x;
                        if (_e310 < 0f) {
                            let _e649 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e638.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e655 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e649.unnamed.root, _e638.w), _e649.unnamed_1);
                            let _e661 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e655.unnamed, lt_bvh_traverse_Tree(_e638.x, _e655.unnamed_1.first_primitive));
                            phi_1291_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e661.unnamed, lt_bvh_traverse_Tree(_e661.unnamed_1.root, _e638.y));
                        } else {
                            let _e677 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e638.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e683 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e677.unnamed.root, _e638.y), _e677.unnamed_1);
                            let _e689 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e683.unnamed, lt_bvh_traverse_Tree(_e638.z, _e683.unnamed_1.first_primitive));
                            phi_1291_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e689.unnamed, lt_bvh_traverse_Tree(_e689.unnamed_1.root, _e638.w));
                        }
                        let _e697 = phi_1291_;
                        let _e707 = nodes.member[(0u + _e573)].y;
                        if (_e322 < 0f) {
                            let _e718 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e707.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e724 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e718.unnamed.root, _e707.w), _e718.unnamed_1);
                            let _e730 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e724.unnamed, lt_bvh_traverse_Tree(_e707.x, _e724.unnamed_1.first_primitive));
                            phi_1318_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e730.unnamed, lt_bvh_traverse_Tree(_e730.unnamed_1.root, _e707.y));
                        } else {
                            let _e746 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e707.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e752 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e746.unnamed.root, _e707.y), _e746.unnamed_1);
                            let _e758 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e752.unnamed, lt_bvh_traverse_Tree(_e707.z, _e752.unnamed_1.first_primitive));
                            phi_1318_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e758.unnamed, lt_bvh_traverse_Tree(_e758.unnamed_1.root, _e707.w));
                        }
                        let _e766 = phi_1318_;
                        let _e776 = nodes.member[(0u + _e573)].z;
                        if (_e334 < 0f) {
                            let _e787 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e776.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e793 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e787.unnamed.root, _e776.w), _e787.unnamed_1);
                            let _e799 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e793.unnamed, lt_bvh_traverse_Tree(_e776.x, _e793.unnamed_1.first_primitive));
                            phi_1345_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e799.unnamed, lt_bvh_traverse_Tree(_e799.unnamed_1.root, _e776.y));
                        } else {
                            let _e815 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e776.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e821 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e815.unnamed.root, _e776.y), _e815.unnamed_1);
                            let _e827 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e821.unnamed, lt_bvh_traverse_Tree(_e776.z, _e821.unnamed_1.first_primitive));
                            phi_1345_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e827.unnamed, lt_bvh_traverse_Tree(_e827.unnamed_1.root, _e776.w));
                        }
                        let _e835 = phi_1345_;
                        phi_1351_ = 0u;
                        phi_1354_ = 0u;
                        loop {
                            let _e845 = phi_1351_;
                            let _e847 = phi_1354_;
                            local_3 = _e847;
                            local_4 = _e847;
                            local_5 = _e847;
                            let _e848 = (_e845 < 8u);
                            if _e848 {
                                let _e850 = (_e845 >> bitcast<u32>(2i));
                                let _e851 = (_e845 & 3u);
                                if (_e850 == 0u) {
                                    phi_1368_ = _e697.unnamed.root;
                                } else {
                                    phi_1368_ = _e697.unnamed.first_primitive;
                                }
                                let _e854 = phi_1368_;
                                if (_e850 == 0u) {
                                    phi_1378_ = _e766.unnamed.root;
                                } else {
                                    phi_1378_ = _e766.unnamed.first_primitive;
                                }
                                let _e863 = phi_1378_;
                                if (_e850 == 0u) {
                                    phi_1388_ = _e835.unnamed.root;
                                } else {
                                    phi_1388_ = _e835.unnamed.first_primitive;
                                }
                                let _e872 = phi_1388_;
                                let _e885 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e854 >> bitcast<u32>(((_e851 * 8u) & 31u))) & 255u)) * _e607) + (_e628 - _e371)), ((f32(((_e863 >> bitcast<u32>(((_e851 * 8u) & 31u))) & 255u)) * _e608) + (_e629 - _e372)));
                                let _e886 = core_intrinsics_maximum_number_nsz_f32_(_e885, ((f32(((_e872 >> bitcast<u32>(((_e851 * 8u) & 31u))) & 255u)) * _e609) + (_e630 - _e373)));
                                if (_e850 == 0u) {
                                    phi_1406_ = _e697.unnamed_1.root;
                                } else {
                                    phi_1406_ = _e697.unnamed_1.first_primitive;
                                }
                                let _e889 = phi_1406_;
                                if (_e850 == 0u) {
                                    phi_1416_ = _e766.unnamed_1.root;
                                } else {
                                    phi_1416_ = _e766.unnamed_1.first_primitive;
                                }
                                let _e898 = phi_1416_;
                                if (_e850 == 0u) {
                                    phi_1426_ = _e835.unnamed_1.root;
                                } else {
                                    phi_1426_ = _e835.unnamed_1.first_primitive;
                                }
                                let _e907 = phi_1426_;
                                let _e920 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e889 >> bitcast<u32>(((_e851 * 8u) & 31u))) & 255u)) * _e607) + (_e628 + _e371)), ((f32(((_e898 >> bitcast<u32>(((_e851 * 8u) & 31u))) & 255u)) * _e608) + (_e629 + _e372)));
                                let _e921 = core_intrinsics_minimum_number_nsz_f32_(_e920, ((f32(((_e907 >> bitcast<u32>(((_e851 * 8u) & 31u))) & 255u)) * _e609) + (_e630 + _e373)));
                                if (_e886 <= _e921) {
                                    if (_e886 <= _e571.t) {
                                        if (_e921 >= _e156.tmin) {
                                            if (_e850 == 0u) {
                                                let _e928 = nodes.member[(0u + _e573)].links[2u];
                                                phi_1462_ = _e928;
                                            } else {
                                                let _e931 = nodes.member[(0u + _e573)].links[3u];
                                                phi_1462_ = _e931;
                                            }
                                            let _e933 = phi_1462_;
                                            let _e938 = ((_e933 >> bitcast<u32>(((_e851 * 8u) & 31u))) & 255u);
                                            let _e939 = (_e938 & 31u);
                                            if (_e939 >= 24u) {
                                                phi_1475_ = (24u + ((_e939 - 24u) ^ _e433));
                                            } else {
                                                phi_1475_ = _e939;
                                            }
                                            let _e945 = phi_1475_;
                                            phi_1480_ = (_e847 | ((_e938 >> bitcast<u32>(5i)) << bitcast<u32>((_e945 & 31u))));
                                        } else {
                                            phi_1480_ = _e847;
                                        }
                                        let _e953 = phi_1480_;
                                        phi_1481_ = _e953;
                                    } else {
                                        phi_1481_ = _e847;
                                    }
                                    let _e955 = phi_1481_;
                                    phi_1482_ = _e955;
                                } else {
                                    phi_1482_ = _e847;
                                }
                                let _e957 = phi_1482_;
                                phi_1352_ = (_e845 + 1u);
                                phi_1355_ = _e957;
                            } else {
                                phi_1352_ = u32();
                                phi_1355_ = u32();
                            }
                            let _e960 = phi_1352_;
                            let _e962 = phi_1355_;
                            continue;
                            continuing {
                                phi_1351_ = _e960;
                                phi_1354_ = _e962;
                                break if !(_e848);
                            }
                        }
                        let _e966 = nodes.member[(0u + _e573)].links[0u];
                        let _e970 = nodes.member[(0u + _e573)].frame[3u];
                        let _e974 = local_3;
                        if ((_e974 & 4278190080u) == 0u) {
                        } else {
                            let _e978 = local_2.group_mask;
                            if ((_e978 & 4278190080u) == 0u) {
                            } else {
                                let _e982 = local_2.len;
                                if (_e982 < 32u) {
                                    let _e985 = local_2.group;
                                    let _e987 = local_2.len;
                                    if (_e987 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e987)] = _e985;
                                    let _e993 = local_2.group_mask;
                                    let _e995 = local_2.len;
                                    if (_e995 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e995)] = _e993;
                                    let _e1002 = local_2.len;
                                    local_2.len = (_e1002 + 1u);
                                }
                            }
                            local_2.group = (0u + _e966);
                            let _e1006 = local_4;
                            local_2.group_mask = ((_e1006 & 4278190080u) | (_e970 >> bitcast<u32>(24i)));
                        }
                        let _e1011 = local_5;
                        phi_1540_ = _e571;
                        phi_1543_ = (_e1011 & 16777215u);
                        loop {
                            let _e1014 = phi_1540_;
                            let _e1016 = phi_1543_;
                            local_6 = _e1014;
                            if (_e1016 == 0u) {
                                phi_1541_ = lt_bvh_Hit();
                                phi_1544_ = u32();
                                phi_2300_ = false;
                            } else {
                                let _e1020 = nodes.member[(0u + _e573)].links[1u];
                                let _e1025 = ((0u + _e1020) + select(firstTrailingBit(_e1016), 32u, (_e1016 == 0u)));
                                if (_e1025 < _e80) {
                                } else {
                                    return;
                                }
                                let _e1032 = triangles.member[(0u + _e1025)].v0_;
                                let _e1035 = (_e1032.x - _e156.origin.x);
                                let _e1038 = (_e1032.y - _e156.origin.y);
                                let _e1041 = (_e1032.z - _e156.origin.z);
                                if (_e398 == 0u) {
                                    phi_1590_ = vec3<f32>(_e1038, _e1041, _e1035);
                                } else {
                                    if (_e398 == 1u) {
                                        phi_1589_ = vec3<f32>(_e1041, _e1035, _e1038);
                                    } else {
                                        phi_1589_ = (_e1032 - _e156.origin);
                                    }
                                    let _e1048 = phi_1589_;
                                    phi_1590_ = _e1048;
                                }
                                let _e1050 = phi_1590_;
                                let _e1054 = (_e1050.x - (_e417 * _e1050.z));
                                let _e1058 = (_e1050.y - (_e420 * _e1050.z));
                                let _e1062 = triangles.member[(0u + _e1025)].v1_;
                                let _e1065 = (_e1062.x - _e156.origin.x);
                                let _e1068 = (_e1062.y - _e156.origin.y);
                                let _e1071 = (_e1062.z - _e156.origin.z);
                                if (_e398 == 0u) {
                                    phi_1624_ = vec3<f32>(_e1068, _e1071, _e1065);
                                } else {
                                    if (_e398 == 1u) {
                                        phi_1623_ = vec3<f32>(_e1071, _e1065, _e1068);
                                    } else {
                                        phi_1623_ = (_e1062 - _e156.origin);
                                    }
                                    let _e1078 = phi_1623_;
                                    phi_1624_ = _e1078;
                                }
                                let _e1080 = phi_1624_;
                                let _e1084 = (_e1080.x - (_e417 * _e1080.z));
                                let _e1088 = (_e1080.y - (_e420 * _e1080.z));
                                let _e1092 = triangles.member[(0u + _e1025)].v2_;
                                let _e1095 = (_e1092.x - _e156.origin.x);
                                let _e1098 = (_e1092.y - _e156.origin.y);
                                let _e1101 = (_e1092.z - _e156.origin.z);
                                if (_e398 == 0u) {
                                    phi_1658_ = vec3<f32>(_e1098, _e1101, _e1095);
                                } else {
                                    if (_e398 == 1u) {
                                        phi_1657_ = vec3<f32>(_e1101, _e1095, _e1098);
                                    } else {
                                        phi_1657_ = (_e1092 - _e156.origin);
                                    }
                                    let _e1108 = phi_1657_;
                                    phi_1658_ = _e1108;
                                }
                                let _e1110 = phi_1658_;
                                let _e1114 = (_e1110.x - (_e417 * _e1110.z));
                                let _e1118 = (_e1110.y - (_e420 * _e1110.z));
                                if (_e1084 < _e1114) {
                                    phi_1679_ = true;
                                } else {
                                    if (_e1084 == _e1114) {
                                        phi_1678_ = (_e1088 < _e1118);
                                    } else {
                                        phi_1678_ = false;
                                    }
                                    let _e1125 = phi_1678_;
                                    phi_1679_ = _e1125;
                                }
                                let _e1127 = phi_1679_;
                                if _e1127 {
                                    phi_1683_ = _e1118;
                                    phi_1684_ = _e1114;
                                    phi_1685_ = _e1088;
                                    phi_1686_ = _e1084;
                                } else {
                                    phi_1683_ = _e1088;
                                    phi_1684_ = _e1084;
                                    phi_1685_ = _e1118;
                                    phi_1686_ = _e1114;
                                }
                                let _e1129 = phi_1683_;
                                let _e1131 = phi_1684_;
                                let _e1133 = phi_1685_;
                                let _e1135 = phi_1686_;
                                let _e1138 = ((_e1135 * _e1129) - (_e1133 * _e1131));
                                if _e1127 {
                                    phi_1694_ = -(_e1138);
                                } else {
                                    phi_1694_ = _e1138;
                                }
                                let _e1141 = phi_1694_;
                                if (_e1114 < _e1054) {
                                    phi_1705_ = true;
                                } else {
                                    if (_e1114 == _e1054) {
                                        phi_1704_ = (_e1118 < _e1058);
                                    } else {
                                        phi_1704_ = false;
                                    }
                                    let _e1146 = phi_1704_;
                                    phi_1705_ = _e1146;
                                }
                                let _e1148 = phi_1705_;
                                if _e1148 {
                                    phi_1709_ = _e1058;
                                    phi_1710_ = _e1054;
                                    phi_1711_ = _e1118;
                                    phi_1712_ = _e1114;
                                } else {
                                    phi_1709_ = _e1118;
                                    phi_1710_ = _e1114;
                                    phi_1711_ = _e1058;
                                    phi_1712_ = _e1054;
                                }
                                let _e1150 = phi_1709_;
                                let _e1152 = phi_1710_;
                                let _e1154 = phi_1711_;
                                let _e1156 = phi_1712_;
                                let _e1159 = ((_e1156 * _e1150) - (_e1154 * _e1152));
                                if _e1148 {
                                    phi_1720_ = -(_e1159);
                                } else {
                                    phi_1720_ = _e1159;
                                }
                                let _e1162 = phi_1720_;
                                if (_e1054 < _e1084) {
                                    phi_1731_ = true;
                                } else {
                                    if (_e1054 == _e1084) {
                                        phi_1730_ = (_e1058 < _e1088);
                                    } else {
                                        phi_1730_ = false;
                                    }
                                    let _e1167 = phi_1730_;
                                    phi_1731_ = _e1167;
                                }
                                let _e1169 = phi_1731_;
                                if _e1169 {
                                    phi_1735_ = _e1088;
                                    phi_1736_ = _e1084;
                                    phi_1737_ = _e1058;
                                    phi_1738_ = _e1054;
                                } else {
                                    phi_1735_ = _e1058;
                                    phi_1736_ = _e1054;
                                    phi_1737_ = _e1088;
                                    phi_1738_ = _e1084;
                                }
                                let _e1171 = phi_1735_;
                                let _e1173 = phi_1736_;
                                let _e1175 = phi_1737_;
                                let _e1177 = phi_1738_;
                                let _e1180 = ((_e1177 * _e1171) - (_e1175 * _e1173));
                                if _e1169 {
                                    phi_1746_ = -(_e1180);
                                } else {
                                    phi_1746_ = _e1180;
                                }
                                let _e1183 = phi_1746_;
                                if (_e1141 >= 0f) {
                                    if (_e1162 >= 0f) {
                                        if (_e1183 >= 0f) {
                                            phi_1761_ = ((_e1141 + _e1162) + _e1183);
                                            phi_1762_ = false;
                                        } else {
                                            phi_1761_ = f32();
                                            phi_1762_ = true;
                                        }
                                        let _e1190 = phi_1761_;
                                        let _e1192 = phi_1762_;
                                        phi_1763_ = _e1190;
                                        phi_1764_ = _e1192;
                                    } else {
                                        phi_1763_ = f32();
                                        phi_1764_ = true;
                                    }
                                    let _e1194 = phi_1763_;
                                    let _e1196 = phi_1764_;
                                    phi_1765_ = _e1194;
                                    phi_1766_ = _e1196;
                                } else {
                                    phi_1765_ = f32();
                                    phi_1766_ = true;
                                }
                                let _e1198 = phi_1765_;
                                let _e1200 = phi_1766_;
                                if _e1200 {
                                    if (_e1141 <= 0f) {
                                        if (_e1162 <= 0f) {
                                            let _e1203 = (_e1183 <= 0f);
                                            if _e1203 {
                                            }
                                            phi_1784_ = ((_e1141 + _e1162) + _e1183);
                                            phi_1785_ = false;
                                            phi_1786_ = _e1203;
                                        } else {
                                            phi_1784_ = f32();
                                            phi_1785_ = true;
                                            phi_1786_ = false;
                                        }
                                        let _e1207 = phi_1784_;
                                        let _e1209 = phi_1785_;
                                        let _e1211 = phi_1786_;
                                        phi_1787_ = _e1207;
                                        phi_1788_ = _e1209;
                                        phi_1789_ = _e1211;
                                    } else {
                                        phi_1787_ = f32();
                                        phi_1788_ = true;
                                        phi_1789_ = false;
                                    }
                                    let _e1213 = phi_1787_;
                                    let _e1215 = phi_1788_;
                                    let _e1217 = phi_1789_;
                                    if _e1215 {
                                        phi_1793_ = false;
                                    } else {
                                        phi_1793_ = _e1217;
                                    }
                                    let _e1219 = phi_1793_;
                                    phi_1794_ = _e1213;
                                    phi_1795_ = _e1219;
                                } else {
                                    phi_1794_ = _e1198;
                                    phi_1795_ = true;
                                }
                                let _e1221 = phi_1794_;
                                let _e1223 = phi_1795_;
                                if _e1223 {
                                    let _e1224 = (_e1221 == 0f);
                                    if _e1224 {
                                        phi_2016_ = lt_bvh_triangle_Intersection();
                                        phi_2017_ = false;
                                    } else {
                                        let _e1230 = ((((_e1141 * (_e422 * _e1050.z)) + (_e1162 * (_e422 * _e1080.z))) + (_e1183 * (_e422 * _e1110.z))) / _e1221);
                                        if (_e1230 > _e156.tmin) {
                                            if (_e1230 < _e156.tmax) {
                                                let _e1236 = triangles.member[(0u + _e1025)].v0_;
                                                let _e1238 = triangles.member[(0u + _e1025)].v1_;
                                                if (_e1236.x < _e1238.x) {
                                                    phi_1831_ = _e1236.x;
                                                } else {
                                                    phi_1831_ = _e1238.x;
                                                }
                                                let _e1245 = phi_1831_;
                                                if (_e1236.y < _e1238.y) {
                                                    phi_1840_ = _e1236.y;
                                                } else {
                                                    phi_1840_ = _e1238.y;
                                                }
                                                let _e1252 = phi_1840_;
                                                if (_e1236.z < _e1238.z) {
                                                    phi_1849_ = _e1236.z;
                                                } else {
                                                    phi_1849_ = _e1238.z;
                                                }
                                                let _e1259 = phi_1849_;
                                                let _e1261 = triangles.member[(0u + _e1025)].v2_;
                                                if (_e1245 < _e1261.x) {
                                                    phi_1858_ = _e1245;
                                                } else {
                                                    phi_1858_ = _e1261.x;
                                                }
                                                let _e1266 = phi_1858_;
                                                if (_e1252 < _e1261.y) {
                                                    phi_1865_ = _e1252;
                                                } else {
                                                    phi_1865_ = _e1261.y;
                                                }
                                                let _e1271 = phi_1865_;
                                                if (_e1259 < _e1261.z) {
                                                    phi_1872_ = _e1259;
                                                } else {
                                                    phi_1872_ = _e1261.z;
                                                }
                                                let _e1276 = phi_1872_;
                                                let _e1278 = triangles.member[(0u + _e1025)].v0_;
                                                let _e1280 = triangles.member[(0u + _e1025)].v1_;
                                                if (_e1278.x > _e1280.x) {
                                                    phi_1885_ = _e1278.x;
                                                } else {
                                                    phi_1885_ = _e1280.x;
                                                }
                                                let _e1287 = phi_1885_;
                                                if (_e1278.y > _e1280.y) {
                                                    phi_1894_ = _e1278.y;
                                                } else {
                                                    phi_1894_ = _e1280.y;
                                                }
                                                let _e1294 = phi_1894_;
                                                if (_e1278.z > _e1280.z) {
                                                    phi_1903_ = _e1278.z;
                                                } else {
                                                    phi_1903_ = _e1280.z;
                                                }
                                                let _e1301 = phi_1903_;
                                                let _e1303 = triangles.member[(0u + _e1025)].v2_;
                                                if (_e1287 > _e1303.x) {
                                                    phi_1912_ = _e1287;
                                                } else {
                                                    phi_1912_ = _e1303.x;
                                                }
                                                let _e1308 = phi_1912_;
                                                if (_e1294 > _e1303.y) {
                                                    phi_1919_ = _e1294;
                                                } else {
                                                    phi_1919_ = _e1303.y;
                                                }
                                                let _e1313 = phi_1919_;
                                                if (_e1301 > _e1303.z) {
                                                    phi_1926_ = _e1301;
                                                } else {
                                                    phi_1926_ = _e1303.z;
                                                }
                                                let _e1318 = phi_1926_;
                                                let _e1325 = ((_e1266 - _e156.origin.x) * _e310);
                                                let _e1326 = ((_e1271 - _e156.origin.y) * _e322);
                                                let _e1327 = ((_e1276 - _e156.origin.z) * _e334);
                                                let _e1334 = ((_e1308 - _e156.origin.x) * _e310);
                                                let _e1335 = ((_e1313 - _e156.origin.y) * _e322);
                                                let _e1336 = ((_e1318 - _e156.origin.z) * _e334);
                                                if (_e1325 < _e1334) {
                                                    phi_1949_ = _e1325;
                                                } else {
                                                    phi_1949_ = _e1334;
                                                }
                                                let _e1339 = phi_1949_;
                                                if (_e1326 < _e1335) {
                                                    phi_1954_ = _e1326;
                                                } else {
                                                    phi_1954_ = _e1335;
                                                }
                                                let _e1342 = phi_1954_;
                                                if (_e1327 < _e1336) {
                                                    phi_1959_ = _e1327;
                                                } else {
                                                    phi_1959_ = _e1336;
                                                }
                                                let _e1345 = phi_1959_;
                                                if (_e1325 > _e1334) {
                                                    phi_1967_ = _e1325;
                                                } else {
                                                    phi_1967_ = _e1334;
                                                }
                                                let _e1351 = phi_1967_;
                                                if (_e1326 > _e1335) {
                                                    phi_1972_ = _e1326;
                                                } else {
                                                    phi_1972_ = _e1335;
                                                }
                                                let _e1354 = phi_1972_;
                                                if (_e1327 > _e1336) {
                                                    phi_1977_ = _e1327;
                                                } else {
                                                    phi_1977_ = _e1336;
                                                }
                                                let _e1357 = phi_1977_;
                                                let _e1361 = core_intrinsics_maximum_number_nsz_f32_((_e1339 - _e378), (_e1342 - _e379));
                                                let _e1362 = core_intrinsics_maximum_number_nsz_f32_(_e1361, (_e1345 - _e380));
                                                let _e1363 = core_intrinsics_minimum_number_nsz_f32_((_e1351 + _e378), (_e1354 + _e379));
                                                let _e1364 = core_intrinsics_minimum_number_nsz_f32_(_e1363, (_e1357 + _e380));
                                                if (_e1362 > -300000000000000000000000000000000000000f) {
                                                    phi_1989_ = _e1362;
                                                } else {
                                                    phi_1989_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1367 = phi_1989_;
                                                if (_e1364 < 300000000000000000000000000000000000000f) {
                                                    phi_1994_ = _e1364;
                                                } else {
                                                    phi_1994_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1370 = phi_1994_;
                                                if (_e1230 < _e1367) {
                                                    phi_1999_ = _e1367;
                                                } else {
                                                    phi_1999_ = _e1230;
                                                }
                                                let _e1373 = phi_1999_;
                                                if (_e1373 > _e1370) {
                                                    phi_2004_ = _e1370;
                                                } else {
                                                    phi_2004_ = _e1373;
                                                }
                                                let _e1376 = phi_2004_;
                                                phi_2009_ = lt_bvh_triangle_Intersection(_e1376, (_e1162 / _e1221), (_e1183 / _e1221), (_e1367 <= _e1370));
                                                phi_2010_ = false;
                                            } else {
                                                phi_2009_ = lt_bvh_triangle_Intersection();
                                                phi_2010_ = true;
                                            }
                                            let _e1382 = phi_2009_;
                                            let _e1384 = phi_2010_;
                                            phi_2011_ = _e1382;
                                            phi_2012_ = _e1384;
                                        } else {
                                            phi_2011_ = lt_bvh_triangle_Intersection();
                                            phi_2012_ = true;
                                        }
                                        let _e1386 = phi_2011_;
                                        let _e1388 = phi_2012_;
                                        if _e1388 {
                                        }
                                        phi_2016_ = _e1386;
                                        phi_2017_ = _e1388;
                                    }
                                    let _e1390 = phi_2016_;
                                    let _e1392 = phi_2017_;
                                    phi_2018_ = _e1390;
                                    phi_2019_ = _e1224;
                                    phi_2020_ = _e1392;
                                } else {
                                    phi_2018_ = lt_bvh_triangle_Intersection();
                                    phi_2019_ = true;
                                    phi_2020_ = false;
                                }
                                let _e1394 = phi_2018_;
                                let _e1396 = phi_2019_;
                                let _e1398 = phi_2020_;
                                if _e1396 {
                                    phi_2024_ = true;
                                } else {
                                    phi_2024_ = _e1398;
                                }
                                let _e1400 = phi_2024_;
                                if _e1400 {
                                    phi_2028_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2028_ = _e1394;
                                }
                                let _e1402 = phi_2028_;
                                if _e1402.is_hit {
                                    if (_e1402.t > _e156.tmin) {
                                        if (_e1402.t < _e1014.t) {
                                            phi_2077_ = true;
                                        } else {
                                            if (_e1402.t == _e1014.t) {
                                                if (_e1014.triangle != 4294967295u) {
                                                    if (_e1025 < _e1014.triangle) {
                                                        phi_2068_ = true;
                                                    } else {
                                                        if (_e1025 == _e1014.triangle) {
                                                            phi_2067_ = (4294967295u < _e1014.instance);
                                                        } else {
                                                            phi_2067_ = false;
                                                        }
                                                        let _e1421 = phi_2067_;
                                                        phi_2068_ = _e1421;
                                                    }
                                                    let _e1423 = phi_2068_;
                                                    phi_2069_ = _e1423;
                                                    phi_2070_ = false;
                                                } else {
                                                    phi_2069_ = bool();
                                                    phi_2070_ = true;
                                                }
                                                let _e1425 = phi_2069_;
                                                let _e1427 = phi_2070_;
                                                phi_2071_ = _e1425;
                                                phi_2072_ = _e1427;
                                            } else {
                                                phi_2071_ = bool();
                                                phi_2072_ = true;
                                            }
                                            let _e1429 = phi_2071_;
                                            let _e1431 = phi_2072_;
                                            if _e1431 {
                                                phi_2076_ = false;
                                            } else {
                                                phi_2076_ = _e1429;
                                            }
                                            let _e1433 = phi_2076_;
                                            phi_2077_ = _e1433;
                                        }
                                        let _e1435 = phi_2077_;
                                        if _e1435 {
                                            let _e1437 = triangles.member[(0u + _e1025)].i0_;
                                            if ((_e1437 & 2147483648u) == 0u) {
                                                phi_2288_ = true;
                                            } else {
                                                if (_e1025 < _e80) {
                                                } else {
                                                    return;
                                                }
                                                let _e1446 = triangles.member[(0u + _e1025)].i0_;
                                                let _e1447 = (_e1446 & 2147483647u);
                                                let _e1449 = triangles.member[(0u + _e1025)].i1_;
                                                let _e1451 = triangles.member[(0u + _e1025)].i2_;
                                                if (_e1447 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1455 = vertices.member[(0u + _e1447)];
                                                if (_e1449 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1459 = vertices.member[(0u + _e1449)];
                                                if (_e1451 < _e83) {
                                                } else {
                                                    return;
                                                }
                                                let _e1463 = vertices.member[(0u + _e1451)];
                                                let _e1464 = array<abi_Vertex, 3>(_e1455, _e1459, _e1463);
                                                if (_e1464[0].material < _e86) {
                                                } else {
                                                    return;
                                                }
                                                let _e1470 = materials.member[(0u + _e1464[0].material)];
                                                if ((_e1470.flags & 0u) == 0u) {
                                                    let _e1475 = ((1f - _e1402.u) - _e1402.v);
                                                    if (_e1470.cutoff <= 0f) {
                                                        phi_2283_ = true;
                                                    } else {
                                                        let _e1502 = (_e1470.base_color.w * ((((f32((_e1464[0].color >> bitcast<u32>(24i))) * _e1475) + (f32((_e1464[1].color >> bitcast<u32>(24i))) * _e1402.u)) + (f32((_e1464[2].color >> bitcast<u32>(24i))) * _e1402.v)) * (1f / 255f)));
                                                        if (_e1470.alpha_size == 0u) {
                                                            phi_2280_ = _e1502;
                                                        } else {
                                                            local_1.offset = _e1470.alpha_offset;
                                                            local_1.size = _e1470.alpha_size;
                                                            local_1.flags = _e1470.flags;
                                                            let _e1533 = _lt_shaders_texture_TextureView_quad((&local_1), (((_e1464[0].u * _e1475) + (_e1464[1].u * _e1402.u)) + (_e1464[2].u * _e1402.v)), (((_e1464[0].v * _e1475) + (_e1464[1].v * _e1402.u)) + (_e1464[2].v * _e1402.v)));
                                                            let _e1537 = (_e1533.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1537 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1541 = alpha_texels.member[(0u + _e1537)];
                                                            let _e1557 = (_e1533.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1557 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1561 = alpha_texels.member[(0u + _e1557)];
                                                            let _e1578 = (_e1533.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1578 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1582 = alpha_texels.member[(0u + _e1578)];
                                                            let _e1599 = (_e1533.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1599 < _e92) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1603 = alpha_texels.member[(0u + _e1599)];
                                                            phi_2280_ = (_e1502 * (((((f32(((_e1541 >> bitcast<u32>((((_e1533.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1533.weights.x) + ((f32(((_e1561 >> bitcast<u32>((((_e1533.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1533.weights.y)) + ((f32(((_e1582 >> bitcast<u32>((((_e1533.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1533.weights.z)) + ((f32(((_e1603 >> bitcast<u32>((((_e1533.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1533.weights.w)));
                                                        }
                                                        let _e1619 = phi_2280_;
                                                        phi_2283_ = (_e1619 >= _e1470.cutoff);
                                                    }
                                                    let _e1623 = phi_2283_;
                                                    phi_2284_ = _e1623;
                                                } else {
                                                    phi_2284_ = false;
                                                }
                                                let _e1625 = phi_2284_;
                                                if _e1625 {
                                                }
                                                phi_2288_ = _e1625;
                                            }
                                            let _e1627 = phi_2288_;
                                            if _e1627 {
                                                phi_2296_ = lt_bvh_Hit(_e1402.t, _e1402.u, _e1402.v, _e1025, 4294967295u);
                                            } else {
                                                phi_2296_ = _e1014;
                                            }
                                            let _e1633 = phi_2296_;
                                            phi_2297_ = _e1633;
                                        } else {
                                            phi_2297_ = _e1014;
                                        }
                                        let _e1635 = phi_2297_;
                                        phi_2298_ = _e1635;
                                    } else {
                                        phi_2298_ = _e1014;
                                    }
                                    let _e1637 = phi_2298_;
                                    phi_2299_ = _e1637;
                                } else {
                                    phi_2299_ = _e1014;
                                }
                                let _e1639 = phi_2299_;
                                phi_1541_ = _e1639;
                                phi_1544_ = (_e1016 & (_e1016 - 1u));
                                phi_2300_ = true;
                            }
                            let _e1641 = phi_1541_;
                            let _e1643 = phi_1544_;
                            let _e1645 = phi_2300_;
                            continue;
                            continuing {
                                phi_1540_ = _e1641;
                                phi_1543_ = _e1643;
                                break if !(_e1645);
                            }
                        }
                        let _e1648 = local_2.group_mask;
                        if ((_e1648 & 4278190080u) == 0u) {
                            let _e1652 = local_2.len;
                            if (_e1652 == 0u) {
                                phi_2339_ = false;
                            } else {
                                let _e1656 = local_2.len;
                                local_2.len = (_e1656 - 1u);
                                let _e1659 = local_2.len;
                                if (_e1659 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1664 = local_2.first[(0u + _e1659)];
                                local_2.group = _e1664;
                                let _e1667 = local_2.len;
                                if (_e1667 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1672 = local_2.mask[(0u + _e1667)];
                                local_2.group_mask = _e1672;
                                phi_2339_ = true;
                            }
                            let _e1675 = phi_2339_;
                            phi_2340_ = _e1675;
                        } else {
                            phi_2340_ = true;
                        }
                        let _e1677 = phi_2340_;
                        if _e1677 {
                            let _e1679 = local_2.group_mask;
                            let _e1685 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1679)), 32u, (_e1679 == 0u)));
                            let _e1689 = local_2.group_mask;
                            let _e1703 = local_2.group_mask;
                            local_2.group_mask = (_e1703 & ~((1u << bitcast<u32>((_e1685 & 31u)))));
                            let _e1706 = local_2.group;
                            phi_2371_ = (_e1706 + countOneBits(((_e1689 & ~((4294967295u << bitcast<u32>((((_e1685 - 24u) ^ _e433) & 31u))))) & 255u)));
                        } else {
                            phi_2371_ = 4294967295u;
                        }
                        let _e1709 = phi_2371_;
                        let _e2550 = local_6;
                        phi_1204_ = _e2550;
                        phi_1207_ = _e1709;
                    } else {
                        phi_1204_ = lt_bvh_Hit();
                        phi_1207_ = u32();
                    }
                    let _e1711 = phi_1204_;
                    let _e1713 = phi_1207_;
                    continue;
                    continuing {
                        phi_1203_ = _e1711;
                        phi_1206_ = _e1713;
                        break if !(_e574);
                    }
                }
                let _e2554 = local_7;
                phi_2372_ = _e2554;
            }
            let _e1716 = phi_2372_;
            phi_2373_ = _e1716;
            phi_2374_ = _e228;
        } else {
            phi_2373_ = lt_bvh_Hit();
            phi_2374_ = true;
        }
        let _e1718 = phi_2373_;
        let _e1720 = phi_2374_;
        if _e1720 {
            phi_2378_ = _e158;
        } else {
            phi_2378_ = _e1718;
        }
        let _e1722 = phi_2378_;
        if (_e1722.triangle != 4294967295u) {
            let _e1728 = ((1f - _e1722.u) - _e1722.v);
            if (_e1722.triangle < _e80) {
            } else {
                return;
            }
            let _e1733 = triangles.member[(0u + _e1722.triangle)];
            let _e1758 = (((_e1733.v0_.x * _e1728) + (_e1733.v1_.x * _e1722.u)) + (_e1733.v2_.x * _e1722.v));
            let _e1759 = (((_e1733.v0_.y * _e1728) + (_e1733.v1_.y * _e1722.u)) + (_e1733.v2_.y * _e1722.v));
            let _e1760 = (((_e1733.v0_.z * _e1728) + (_e1733.v1_.z * _e1722.u)) + (_e1733.v2_.z * _e1722.v));
            let _e1763 = abs(_e1733.v0_.x);
            let _e1765 = abs(_e1733.v0_.y);
            let _e1767 = abs(_e1733.v0_.z);
            let _e1769 = abs(_e1733.v1_.x);
            let _e1771 = abs(_e1733.v1_.y);
            let _e1773 = abs(_e1733.v1_.z);
            if (_e1763 > _e1769) {
                phi_2442_ = _e1763;
            } else {
                phi_2442_ = _e1769;
            }
            let _e1776 = phi_2442_;
            if (_e1765 > _e1771) {
                phi_2447_ = _e1765;
            } else {
                phi_2447_ = _e1771;
            }
            let _e1779 = phi_2447_;
            if (_e1767 > _e1773) {
                phi_2452_ = _e1767;
            } else {
                phi_2452_ = _e1773;
            }
            let _e1782 = phi_2452_;
            let _e1784 = abs(_e1733.v2_.x);
            let _e1786 = abs(_e1733.v2_.y);
            let _e1788 = abs(_e1733.v2_.z);
            if (_e1776 > _e1784) {
                phi_2463_ = _e1776;
            } else {
                phi_2463_ = _e1784;
            }
            let _e1791 = phi_2463_;
            if (_e1779 > _e1786) {
                phi_2468_ = _e1779;
            } else {
                phi_2468_ = _e1786;
            }
            let _e1794 = phi_2468_;
            if (_e1782 > _e1788) {
                phi_2473_ = _e1782;
            } else {
                phi_2473_ = _e1788;
            }
            let _e1797 = phi_2473_;
            let _e1800 = (_e1733.v1_.x - _e1733.v0_.x);
            let _e1803 = (_e1733.v1_.y - _e1733.v0_.y);
            let _e1806 = (_e1733.v1_.z - _e1733.v0_.z);
            let _e1809 = (_e1733.v2_.x - _e1733.v0_.x);
            let _e1812 = (_e1733.v2_.y - _e1733.v0_.y);
            let _e1815 = (_e1733.v2_.z - _e1733.v0_.z);
            let _e1819 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1803), abs(_e1806));
            let _e1820 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1800), _e1819);
            let _e1821 = (_e1800 / _e1820);
            let _e1822 = (_e1803 / _e1820);
            let _e1823 = (_e1806 / _e1820);
            let _e1827 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1812), abs(_e1815));
            let _e1828 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1809), _e1827);
            let _e1829 = (_e1809 / _e1828);
            let _e1830 = (_e1812 / _e1828);
            let _e1831 = (_e1815 / _e1828);
            let _e1834 = ((_e1822 * _e1831) - (_e1830 * _e1823));
            let _e1837 = ((_e1823 * _e1829) - (_e1831 * _e1821));
            let _e1840 = ((_e1821 * _e1830) - (_e1829 * _e1822));
            let _e1842 = p.member.eye;
            let _e1855 = (1f / sqrt((((_e1834 * _e1834) + (_e1837 * _e1837)) + (_e1840 * _e1840))));
            let _e1856 = (_e1834 * _e1855);
            let _e1857 = (_e1837 * _e1855);
            let _e1858 = (_e1840 * _e1855);
            if ((((_e1856 * (_e1842.x - _e1758)) + (_e1857 * (_e1842.y - _e1759))) + (_e1858 * (_e1842.z - _e1760))) < 0f) {
                phi_2549_ = vec3<f32>(-(_e1856), -(_e1857), -(_e1858));
            } else {
                phi_2549_ = vec3<f32>(_e1856, _e1857, _e1858);
            }
            let _e1871 = phi_2549_;
            if (_e1722.triangle < _e80) {
            } else {
                return;
            }
            let _e1876 = triangles.member[(0u + _e1722.triangle)];
            let _e1878 = (_e1876.i0_ & 2147483647u);
            if (_e1878 < _e83) {
            } else {
                return;
            }
            let _e1884 = vertices.member[(0u + _e1878)];
            if (_e1876.i1_ < _e83) {
            } else {
                return;
            }
            let _e1888 = vertices.member[(0u + _e1876.i1_)];
            if (_e1876.i2_ < _e83) {
            } else {
                return;
            }
            let _e1892 = vertices.member[(0u + _e1876.i2_)];
            let _e1893 = array<abi_Vertex, 3>(_e1884, _e1888, _e1892);
            if (_e1893[0].material < _e86) {
            } else {
                return;
            }
            let _e1899 = materials.member[(0u + _e1893[0].material)];
            let _e1916 = (1f / 255f);
            let _e1935 = (1f / 255f);
            let _e1957 = (1f / 255f);
            if (_e1899.color_size == 0u) {
                phi_2792_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e1899.color_offset;
                local.size = _e1899.color_size;
                local.flags = _e1899.flags;
                let _e2000 = _lt_shaders_texture_TextureView_quad((&local), (((_e1893[0].u * _e1728) + (_e1893[1].u * _e1722.u)) + (_e1893[2].u * _e1722.v)), (((_e1893[0].v * _e1728) + (_e1893[1].v * _e1722.u)) + (_e1893[2].v * _e1722.v)));
                if (_e2000.indices[0] < _e95) {
                } else {
                    return;
                }
                let _e2006 = color_texels.member[(0u + _e2000.indices[0])];
                let _e2017 = (1f / 255f);
                if (_e2000.indices[1] < _e95) {
                } else {
                    return;
                }
                let _e2031 = color_texels.member[(0u + _e2000.indices[1])];
                let _e2042 = (1f / 255f);
                if (_e2000.indices[2] < _e95) {
                } else {
                    return;
                }
                let _e2059 = color_texels.member[(0u + _e2000.indices[2])];
                let _e2070 = (1f / 255f);
                if (_e2000.indices[3] < _e95) {
                } else {
                    return;
                }
                let _e2087 = color_texels.member[(0u + _e2000.indices[3])];
                let _e2098 = (1f / 255f);
                let _e2107 = (((((f32((_e2006 & 255u)) * _e2017) * _e2000.weights.x) + ((f32((_e2031 & 255u)) * _e2042) * _e2000.weights.y)) + ((f32((_e2059 & 255u)) * _e2070) * _e2000.weights.z)) + ((f32((_e2087 & 255u)) * _e2098) * _e2000.weights.w));
                let _e2108 = (((((f32(((_e2006 >> bitcast<u32>(8i)) & 255u)) * _e2017) * _e2000.weights.x) + ((f32(((_e2031 >> bitcast<u32>(8i)) & 255u)) * _e2042) * _e2000.weights.y)) + ((f32(((_e2059 >> bitcast<u32>(8i)) & 255u)) * _e2070) * _e2000.weights.z)) + ((f32(((_e2087 >> bitcast<u32>(8i)) & 255u)) * _e2098) * _e2000.weights.w));
                let _e2109 = (((((f32(((_e2006 >> bitcast<u32>(16i)) & 255u)) * _e2017) * _e2000.weights.x) + ((f32(((_e2031 >> bitcast<u32>(16i)) & 255u)) * _e2042) * _e2000.weights.y)) + ((f32(((_e2059 >> bitcast<u32>(16i)) & 255u)) * _e2070) * _e2000.weights.z)) + ((f32(((_e2087 >> bitcast<u32>(16i)) & 255u)) * _e2098) * _e2000.weights.w));
                phi_2792_ = vec3<f32>((_e2107 * _e2107), (_e2108 * _e2108), (_e2109 * _e2109));
            }
            let _e2115 = phi_2792_;
            let _e2117 = ((_e1899.base_color.x * ((((f32((_e1893[0].color & 255u)) * _e1916) * _e1728) + ((f32((_e1893[1].color & 255u)) * _e1935) * _e1722.u)) + ((f32((_e1893[2].color & 255u)) * _e1957) * _e1722.v))) * _e2115.x);
            let _e2119 = ((_e1899.base_color.y * ((((f32(((_e1893[0].color >> bitcast<u32>(8i)) & 255u)) * _e1916) * _e1728) + ((f32(((_e1893[1].color >> bitcast<u32>(8i)) & 255u)) * _e1935) * _e1722.u)) + ((f32(((_e1893[2].color >> bitcast<u32>(8i)) & 255u)) * _e1957) * _e1722.v))) * _e2115.y);
            let _e2121 = ((_e1899.base_color.z * ((((f32(((_e1893[0].color >> bitcast<u32>(16i)) & 255u)) * _e1916) * _e1728) + ((f32(((_e1893[1].color >> bitcast<u32>(16i)) & 255u)) * _e1935) * _e1722.u)) + ((f32(((_e1893[2].color >> bitcast<u32>(16i)) & 255u)) * _e1957) * _e1722.v))) * _e2115.z);
            let _e2122 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1794, _e1797);
            let _e2123 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1791, _e2122);
            if ((_e1899.flags & 2u) == 0u) {
                phi_2807_ = 0u;
            } else {
                phi_2807_ = 1u;
            }
            let _e2128 = phi_2807_;
            if (_e1893[0].normal == 2147516416u) {
                phi_3010_ = _e1871;
            } else {
                let _e2141 = (f32((bitcast<i32>((_e1893[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2147 = (f32((bitcast<i32>(_e1893[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2151 = ((1f - abs(_e2141)) - abs(_e2147));
                if (_e2151 < 0f) {
                    phi_2834_ = -(_e2151);
                } else {
                    phi_2834_ = 0f;
                }
                let _e2155 = phi_2834_;
                if (_e2141 < 0f) {
                    phi_2841_ = (_e2141 + _e2155);
                } else {
                    phi_2841_ = (_e2141 - _e2155);
                }
                let _e2160 = phi_2841_;
                if (_e2147 < 0f) {
                    phi_2848_ = (_e2147 + _e2155);
                } else {
                    phi_2848_ = (_e2147 - _e2155);
                }
                let _e2165 = phi_2848_;
                let _e2172 = (1f / sqrt((((_e2160 * _e2160) + (_e2165 * _e2165)) + (_e2151 * _e2151))));
                let _e2188 = (f32((bitcast<i32>((_e1893[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2194 = (f32((bitcast<i32>(_e1893[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2198 = ((1f - abs(_e2188)) - abs(_e2194));
                if (_e2198 < 0f) {
                    phi_2883_ = -(_e2198);
                } else {
                    phi_2883_ = 0f;
                }
                let _e2202 = phi_2883_;
                if (_e2188 < 0f) {
                    phi_2890_ = (_e2188 + _e2202);
                } else {
                    phi_2890_ = (_e2188 - _e2202);
                }
                let _e2207 = phi_2890_;
                if (_e2194 < 0f) {
                    phi_2897_ = (_e2194 + _e2202);
                } else {
                    phi_2897_ = (_e2194 - _e2202);
                }
                let _e2212 = phi_2897_;
                let _e2219 = (1f / sqrt((((_e2207 * _e2207) + (_e2212 * _e2212)) + (_e2198 * _e2198))));
                let _e2238 = (f32((bitcast<i32>((_e1893[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2244 = (f32((bitcast<i32>(_e1893[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2248 = ((1f - abs(_e2238)) - abs(_e2244));
                if (_e2248 < 0f) {
                    phi_2935_ = -(_e2248);
                } else {
                    phi_2935_ = 0f;
                }
                let _e2252 = phi_2935_;
                if (_e2238 < 0f) {
                    phi_2942_ = (_e2238 + _e2252);
                } else {
                    phi_2942_ = (_e2238 - _e2252);
                }
                let _e2257 = phi_2942_;
                if (_e2244 < 0f) {
                    phi_2949_ = (_e2244 + _e2252);
                } else {
                    phi_2949_ = (_e2244 - _e2252);
                }
                let _e2262 = phi_2949_;
                let _e2269 = (1f / sqrt((((_e2257 * _e2257) + (_e2262 * _e2262)) + (_e2248 * _e2248))));
                let _e2280 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e2160 * _e2172) * _e1728) + ((_e2207 * _e2219) * _e1722.u)) + ((_e2257 * _e2269) * _e1722.v)), ((((_e2165 * _e2172) * _e1728) + ((_e2212 * _e2219) * _e1722.u)) + ((_e2262 * _e2269) * _e1722.v)), ((((_e2151 * _e2172) * _e1728) + ((_e2198 * _e2219) * _e1722.u)) + ((_e2248 * _e2269) * _e1722.v))));
                let _e2292 = sqrt((((_e2280.x * _e2280.x) + (_e2280.y * _e2280.y)) + (_e2280.z * _e2280.z)));
                if (_e2292 > 0f) {
                    let _e2295 = (_e2280.x / _e2292);
                    let _e2297 = (_e2280.y / _e2292);
                    let _e2299 = (_e2280.z / _e2292);
                    if ((((_e2295 * _e1871.x) + (_e2297 * _e1871.y)) + (_e2299 * _e1871.z)) < 0f) {
                        phi_3008_ = vec3<f32>(-(_e2295), -(_e2297), -(_e2299));
                    } else {
                        phi_3008_ = (_e2280 / vec3(_e2292));
                    }
                    let _e2316 = phi_3008_;
                    phi_3009_ = _e2316;
                } else {
                    phi_3009_ = _e1871;
                }
                let _e2318 = phi_3009_;
                phi_3010_ = _e2318;
            }
            let _e2320 = phi_3010_;
            if (_e2117 > 0f) {
                if (_e2117 < 1f) {
                    phi_3019_ = _e2117;
                } else {
                    phi_3019_ = 1f;
                }
                let _e2324 = phi_3019_;
                phi_3020_ = _e2324;
            } else {
                phi_3020_ = 0f;
            }
            let _e2326 = phi_3020_;
            if (_e2119 > 0f) {
                if (_e2119 < 1f) {
                    phi_3030_ = _e2119;
                } else {
                    phi_3030_ = 1f;
                }
                let _e2331 = phi_3030_;
                phi_3031_ = _e2331;
            } else {
                phi_3031_ = 0f;
            }
            let _e2333 = phi_3031_;
            if (_e2121 > 0f) {
                if (_e2121 < 1f) {
                    phi_3041_ = _e2121;
                } else {
                    phi_3041_ = 1f;
                }
                let _e2338 = phi_3041_;
                phi_3042_ = _e2338;
            } else {
                phi_3042_ = 0f;
            }
            let _e2340 = phi_3042_;
            let _e2343 = ((sqrt(_e2326) * 255f) + 0.5f);
            let _e2352 = ((sqrt(_e2333) * 255f) + 0.5f);
            let _e2364 = ((sqrt(_e2340) * 255f) + 0.5f);
            phi_3077_ = abi_Sample(vec3<f32>(_e1758, _e1759, _e1760), _e2123, _e1871, _e2128, _e2320, ((select(select(u32(_e2343), 0u, (_e2343 < bitcast<f32>(0u))), 4294967295u, (_e2343 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2352), 0u, (_e2352 < bitcast<f32>(0u))), 4294967295u, (_e2352 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2364), 0u, (_e2364 < bitcast<f32>(0u))), 4294967295u, (_e2364 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_3077_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2378 = phi_3077_;
        if (_e101.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e101.first_primitive)] = _e2378;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_alpha_color_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
