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

struct type_26 {
    member: array<vec4<f32>>,
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

struct type_32 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_36 {
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

struct type_40 {
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

struct type_50 {
    member: abi_CameraParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_55 {
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
var<storage> vertices: type_36;
@group(0) @binding(4) 
var<storage> materials: type_40;
@group(0) @binding(0) 
var<uniform> p: type_50;
@group(0) @binding(1) 
var<storage> nodes: type_55;
@group(0) @binding(2) 
var<storage> triangles: type_32;
@group(0) @binding(5) 
var<storage, read_write> samples: type_9;
@group(0) @binding(6) 
var<storage> color_texels: type_13;
@group(0) @binding(7) 
var<storage> before: type_26;
@group(0) @binding(8) 
var<storage, read_write> past: type_26;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_213_: lt_bvh_traverse_Tree;
    var phi_214_: bool;
    var phi_215_: lt_bvh_traverse_Tree;
    var phi_216_: bool;
    var phi_221_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_213_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_214_ = false;
        } else {
            phi_213_ = lt_bvh_traverse_Tree();
            phi_214_ = true;
        }
        let _e83 = phi_213_;
        let _e85 = phi_214_;
        phi_215_ = _e83;
        phi_216_ = _e85;
    } else {
        phi_215_ = lt_bvh_traverse_Tree();
        phi_216_ = true;
    }
    let _e87 = phi_215_;
    let _e89 = phi_216_;
    if _e89 {
        phi_221_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_221_ = _e87;
    }
    let _e94 = phi_221_;
    return lt_bvh_traverse_Tree(_e94.root, _e94.first_primitive);
}

fn _lt_shaders_texture_TextureView_quad(param_3: ptr<function, texture_TextureView>, param_4: f32, param_5: f32) -> texture_TexelQuad {
    var phi_266_: f32;
    var phi_271_: f32;
    var phi_272_: bool;
    var phi_273_: f32;
    var phi_274_: bool;
    var phi_278_: f32;
    var phi_304_: f32;
    var phi_309_: f32;
    var phi_310_: bool;
    var phi_311_: f32;
    var phi_312_: bool;
    var phi_316_: f32;
    var phi_324_: f32;
    var phi_325_: f32;
    var phi_326_: f32;
    var phi_335_: f32;
    var phi_336_: f32;
    var phi_354_: u32;
    var phi_368_: u32;
    var phi_375_: u32;
    var phi_380_: u32;
    var phi_386_: u32;
    var phi_391_: u32;
    var phi_393_: texture_Axis;
    var phi_421_: f32;
    var phi_426_: f32;
    var phi_427_: bool;
    var phi_428_: f32;
    var phi_429_: bool;
    var phi_433_: f32;
    var phi_459_: f32;
    var phi_464_: f32;
    var phi_465_: bool;
    var phi_466_: f32;
    var phi_467_: bool;
    var phi_471_: f32;
    var phi_479_: f32;
    var phi_480_: f32;
    var phi_481_: f32;
    var phi_490_: f32;
    var phi_491_: f32;
    var phi_509_: u32;
    var phi_523_: u32;
    var phi_530_: u32;
    var phi_535_: u32;
    var phi_541_: u32;
    var phi_546_: u32;
    var phi_548_: texture_Axis;

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
                phi_266_ = 1f;
            } else {
                phi_266_ = 0f;
            }
            let _e104 = phi_266_;
            if (param_4 < 8388608f) {
                phi_271_ = (_e101 - _e104);
                phi_272_ = false;
            } else {
                phi_271_ = f32();
                phi_272_ = true;
            }
            let _e107 = phi_271_;
            let _e109 = phi_272_;
            phi_273_ = _e107;
            phi_274_ = _e109;
        } else {
            phi_273_ = f32();
            phi_274_ = true;
        }
        let _e111 = phi_273_;
        let _e113 = phi_274_;
        if _e113 {
            phi_278_ = param_4;
        } else {
            phi_278_ = _e111;
        }
        let _e115 = phi_278_;
        phi_326_ = (param_4 - _e115);
    } else {
        if (_e88 == 1u) {
            let _e118 = (param_4 * 0.5f);
            if (_e118 > -8388608f) {
                let _e130 = f32(select(0i, select(select(i32(_e118), i32(-2147483648), (_e118 < bitcast<f32>(3472883712u))), 2147483647i, (_e118 > bitcast<f32>(1325400063u))), (_e118 == _e118)));
                if (_e130 > _e118) {
                    phi_304_ = 1f;
                } else {
                    phi_304_ = 0f;
                }
                let _e133 = phi_304_;
                if (_e118 < 8388608f) {
                    phi_309_ = (_e130 - _e133);
                    phi_310_ = false;
                } else {
                    phi_309_ = f32();
                    phi_310_ = true;
                }
                let _e136 = phi_309_;
                let _e138 = phi_310_;
                phi_311_ = _e136;
                phi_312_ = _e138;
            } else {
                phi_311_ = f32();
                phi_312_ = true;
            }
            let _e140 = phi_311_;
            let _e142 = phi_312_;
            if _e142 {
                phi_316_ = _e118;
            } else {
                phi_316_ = _e140;
            }
            let _e144 = phi_316_;
            let _e146 = (param_4 - (2f * _e144));
            if (_e146 > 1f) {
                phi_324_ = (2f - _e146);
            } else {
                phi_324_ = _e146;
            }
            let _e150 = phi_324_;
            phi_325_ = _e150;
        } else {
            phi_325_ = param_4;
        }
        let _e152 = phi_325_;
        phi_326_ = _e152;
    }
    let _e154 = phi_326_;
    if (_e154 > 0f) {
        if (_e154 < 1f) {
            phi_335_ = _e154;
        } else {
            phi_335_ = 1f;
        }
        let _e158 = phi_335_;
        phi_336_ = _e158;
    } else {
        phi_336_ = 0f;
    }
    let _e160 = phi_336_;
    let _e161 = (_e75 - 1u);
    let _e163 = (_e160 * f32(_e75));
    if _e83 {
        let _e170 = select(select(u32(_e163), 0u, (_e163 < bitcast<f32>(0u))), 4294967295u, (_e163 > bitcast<f32>(1333788671u)));
        if (_e161 < _e170) {
            phi_354_ = _e161;
        } else {
            phi_354_ = _e170;
        }
        let _e173 = phi_354_;
        phi_393_ = texture_Axis(_e173, _e173, 0f);
    } else {
        let _e175 = (_e163 + 0.5f);
        let _e182 = select(select(u32(_e175), 0u, (_e175 < bitcast<f32>(0u))), 4294967295u, (_e175 > bitcast<f32>(1333788671u)));
        if (_e75 < _e182) {
            phi_368_ = _e75;
        } else {
            phi_368_ = _e182;
        }
        let _e185 = phi_368_;
        if (_e88 == 0u) {
            phi_375_ = _e161;
        } else {
            phi_375_ = 0u;
        }
        let _e190 = phi_375_;
        if (_e88 == 0u) {
            phi_380_ = 0u;
        } else {
            phi_380_ = _e161;
        }
        let _e193 = phi_380_;
        if (_e185 == 0u) {
            phi_386_ = _e190;
        } else {
            phi_386_ = (_e185 - 1u);
        }
        let _e197 = phi_386_;
        if (_e185 > _e161) {
            phi_391_ = _e193;
        } else {
            phi_391_ = _e185;
        }
        let _e200 = phi_391_;
        phi_393_ = texture_Axis(_e197, _e200, (_e175 - f32(_e185)));
    }
    let _e203 = phi_393_;
    let _e205 = (*param_3).flags;
    let _e208 = ((_e205 >> bitcast<u32>(6u)) & 3u);
    if (_e208 == 0u) {
        if (param_5 > -8388608f) {
            let _e221 = f32(select(0i, select(select(i32(param_5), i32(-2147483648), (param_5 < bitcast<f32>(3472883712u))), 2147483647i, (param_5 > bitcast<f32>(1325400063u))), (param_5 == param_5)));
            if (_e221 > param_5) {
                phi_421_ = 1f;
            } else {
                phi_421_ = 0f;
            }
            let _e224 = phi_421_;
            if (param_5 < 8388608f) {
                phi_426_ = (_e221 - _e224);
                phi_427_ = false;
            } else {
                phi_426_ = f32();
                phi_427_ = true;
            }
            let _e227 = phi_426_;
            let _e229 = phi_427_;
            phi_428_ = _e227;
            phi_429_ = _e229;
        } else {
            phi_428_ = f32();
            phi_429_ = true;
        }
        let _e231 = phi_428_;
        let _e233 = phi_429_;
        if _e233 {
            phi_433_ = param_5;
        } else {
            phi_433_ = _e231;
        }
        let _e235 = phi_433_;
        phi_481_ = (param_5 - _e235);
    } else {
        if (_e208 == 1u) {
            let _e238 = (param_5 * 0.5f);
            if (_e238 > -8388608f) {
                let _e250 = f32(select(0i, select(select(i32(_e238), i32(-2147483648), (_e238 < bitcast<f32>(3472883712u))), 2147483647i, (_e238 > bitcast<f32>(1325400063u))), (_e238 == _e238)));
                if (_e250 > _e238) {
                    phi_459_ = 1f;
                } else {
                    phi_459_ = 0f;
                }
                let _e253 = phi_459_;
                if (_e238 < 8388608f) {
                    phi_464_ = (_e250 - _e253);
                    phi_465_ = false;
                } else {
                    phi_464_ = f32();
                    phi_465_ = true;
                }
                let _e256 = phi_464_;
                let _e258 = phi_465_;
                phi_466_ = _e256;
                phi_467_ = _e258;
            } else {
                phi_466_ = f32();
                phi_467_ = true;
            }
            let _e260 = phi_466_;
            let _e262 = phi_467_;
            if _e262 {
                phi_471_ = _e238;
            } else {
                phi_471_ = _e260;
            }
            let _e264 = phi_471_;
            let _e266 = (param_5 - (2f * _e264));
            if (_e266 > 1f) {
                phi_479_ = (2f - _e266);
            } else {
                phi_479_ = _e266;
            }
            let _e270 = phi_479_;
            phi_480_ = _e270;
        } else {
            phi_480_ = param_5;
        }
        let _e272 = phi_480_;
        phi_481_ = _e272;
    }
    let _e274 = phi_481_;
    if (_e274 > 0f) {
        if (_e274 < 1f) {
            phi_490_ = _e274;
        } else {
            phi_490_ = 1f;
        }
        let _e278 = phi_490_;
        phi_491_ = _e278;
    } else {
        phi_491_ = 0f;
    }
    let _e280 = phi_491_;
    let _e281 = (_e79 - 1u);
    let _e283 = (_e280 * f32(_e79));
    if _e83 {
        let _e290 = select(select(u32(_e283), 0u, (_e283 < bitcast<f32>(0u))), 4294967295u, (_e283 > bitcast<f32>(1333788671u)));
        if (_e281 < _e290) {
            phi_509_ = _e281;
        } else {
            phi_509_ = _e290;
        }
        let _e293 = phi_509_;
        phi_548_ = texture_Axis(_e293, _e293, 0f);
    } else {
        let _e295 = (_e283 + 0.5f);
        let _e302 = select(select(u32(_e295), 0u, (_e295 < bitcast<f32>(0u))), 4294967295u, (_e295 > bitcast<f32>(1333788671u)));
        if (_e79 < _e302) {
            phi_523_ = _e79;
        } else {
            phi_523_ = _e302;
        }
        let _e305 = phi_523_;
        if (_e208 == 0u) {
            phi_530_ = _e281;
        } else {
            phi_530_ = 0u;
        }
        let _e310 = phi_530_;
        if (_e208 == 0u) {
            phi_535_ = 0u;
        } else {
            phi_535_ = _e281;
        }
        let _e313 = phi_535_;
        if (_e305 == 0u) {
            phi_541_ = _e310;
        } else {
            phi_541_ = (_e305 - 1u);
        }
        let _e317 = phi_541_;
        if (_e305 > _e281) {
            phi_546_ = _e313;
        } else {
            phi_546_ = _e305;
        }
        let _e320 = phi_546_;
        phi_548_ = texture_Axis(_e317, _e320, (_e295 - f32(_e305)));
    }
    let _e323 = phi_548_;
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
    var phi_611_: bool;
    var phi_615_: f32;

    if (param_8 != param_8) {
        phi_611_ = true;
    } else {
        let _e73 = (param_9 >= param_8);
        if _e73 {
        }
        phi_611_ = _e73;
    }
    let _e75 = phi_611_;
    if _e75 {
        phi_615_ = param_9;
    } else {
        phi_615_ = param_8;
    }
    let _e77 = phi_615_;
    return _e77;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_10: f32, param_11: f32) -> f32 {
    var phi_627_: bool;
    var phi_631_: f32;

    if (param_10 != param_10) {
        phi_627_ = true;
    } else {
        let _e73 = (param_11 <= param_10);
        if _e73 {
        }
        phi_627_ = _e73;
    }
    let _e75 = phi_627_;
    if _e75 {
        phi_631_ = param_11;
    } else {
        phi_631_ = param_10;
    }
    let _e77 = phi_631_;
    return _e77;
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_12: f32, param_13: f32) -> f32 {
    var phi_639_: f32;

    if (param_12 > param_13) {
        phi_639_ = param_12;
    } else {
        phi_639_ = param_13;
    }
    let _e74 = phi_639_;
    return _e74;
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(param_14: vec3<f32>) -> vec3<f32> {
    return param_14;
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(param_15: vec3<f32>) -> vec3<f32> {
    return param_15;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var phi_786_: bool;
    var phi_787_: bool;
    var phi_788_: bool;
    var phi_792_: bool;
    var phi_793_: bool;
    var phi_794_: bool;
    var phi_795_: bool;
    var phi_796_: bool;
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
    var phi_813_: bool;
    var phi_817_: bool;
    var phi_892_: f32;
    var phi_899_: f32;
    var phi_907_: f32;
    var phi_914_: f32;
    var phi_922_: f32;
    var phi_929_: f32;
    var phi_954_: f32;
    var phi_959_: f32;
    var phi_964_: f32;
    var phi_997_: bool;
    var phi_998_: bool;
    var phi_1006_: u32;
    var phi_1007_: u32;
    var phi_1025_: vec3<f32>;
    var phi_1026_: vec3<f32>;
    var phi_1040_: u32;
    var phi_1045_: u32;
    var phi_1050_: u32;
    var phi_1164_: bool;
    var phi_1165_: bool;
    var phi_1196_: u32;
    var phi_1198_: lt_bvh_Hit;
    var phi_1201_: u32;
    var phi_1286_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1313_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1340_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1346_: u32;
    var phi_1349_: u32;
    var phi_1363_: u32;
    var phi_1373_: u32;
    var phi_1383_: u32;
    var phi_1401_: u32;
    var phi_1411_: u32;
    var phi_1421_: u32;
    var phi_1457_: u32;
    var phi_1470_: u32;
    var phi_1475_: u32;
    var phi_1476_: u32;
    var phi_1477_: u32;
    var phi_1347_: u32;
    var phi_1350_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1535_: lt_bvh_Hit;
    var phi_1538_: u32;
    var phi_1584_: vec3<f32>;
    var phi_1585_: vec3<f32>;
    var phi_1618_: vec3<f32>;
    var phi_1619_: vec3<f32>;
    var phi_1652_: vec3<f32>;
    var phi_1653_: vec3<f32>;
    var phi_1673_: bool;
    var phi_1674_: bool;
    var phi_1678_: f32;
    var phi_1679_: f32;
    var phi_1680_: f32;
    var phi_1681_: f32;
    var phi_1689_: f32;
    var phi_1699_: bool;
    var phi_1700_: bool;
    var phi_1704_: f32;
    var phi_1705_: f32;
    var phi_1706_: f32;
    var phi_1707_: f32;
    var phi_1715_: f32;
    var phi_1725_: bool;
    var phi_1726_: bool;
    var phi_1730_: f32;
    var phi_1731_: f32;
    var phi_1732_: f32;
    var phi_1733_: f32;
    var phi_1741_: f32;
    var phi_1756_: f32;
    var phi_1757_: bool;
    var phi_1758_: f32;
    var phi_1759_: bool;
    var phi_1760_: f32;
    var phi_1761_: bool;
    var phi_1779_: f32;
    var phi_1780_: bool;
    var phi_1781_: bool;
    var phi_1782_: f32;
    var phi_1783_: bool;
    var phi_1784_: bool;
    var phi_1788_: bool;
    var phi_1789_: f32;
    var phi_1790_: bool;
    var phi_1826_: f32;
    var phi_1835_: f32;
    var phi_1844_: f32;
    var phi_1853_: f32;
    var phi_1860_: f32;
    var phi_1867_: f32;
    var phi_1880_: f32;
    var phi_1889_: f32;
    var phi_1898_: f32;
    var phi_1907_: f32;
    var phi_1914_: f32;
    var phi_1921_: f32;
    var phi_1944_: f32;
    var phi_1949_: f32;
    var phi_1954_: f32;
    var phi_1962_: f32;
    var phi_1967_: f32;
    var phi_1972_: f32;
    var phi_1984_: f32;
    var phi_1989_: f32;
    var phi_1994_: f32;
    var phi_1999_: f32;
    var phi_2004_: lt_bvh_triangle_Intersection;
    var phi_2005_: bool;
    var phi_2006_: lt_bvh_triangle_Intersection;
    var phi_2007_: bool;
    var phi_2011_: lt_bvh_triangle_Intersection;
    var phi_2012_: bool;
    var phi_2013_: lt_bvh_triangle_Intersection;
    var phi_2014_: bool;
    var phi_2015_: bool;
    var phi_2019_: bool;
    var phi_2023_: lt_bvh_triangle_Intersection;
    var phi_2062_: bool;
    var phi_2063_: bool;
    var phi_2064_: bool;
    var phi_2065_: bool;
    var phi_2066_: bool;
    var phi_2067_: bool;
    var phi_2071_: bool;
    var phi_2072_: bool;
    var phi_2086_: bool;
    var phi_2094_: lt_bvh_Hit;
    var phi_2095_: lt_bvh_Hit;
    var phi_2096_: lt_bvh_Hit;
    var phi_2097_: lt_bvh_Hit;
    var phi_1536_: lt_bvh_Hit;
    var phi_1539_: u32;
    var phi_2098_: bool;
    var phi_2137_: bool;
    var phi_2138_: bool;
    var phi_2169_: u32;
    var phi_1199_: lt_bvh_Hit;
    var phi_1202_: u32;
    var phi_2170_: lt_bvh_Hit;
    var phi_2171_: lt_bvh_Hit;
    var phi_2172_: bool;
    var phi_2176_: lt_bvh_Hit;
    var phi_2240_: f32;
    var phi_2245_: f32;
    var phi_2250_: f32;
    var phi_2261_: f32;
    var phi_2266_: f32;
    var phi_2271_: f32;
    var phi_2347_: vec3<f32>;
    var phi_2590_: vec3<f32>;
    var phi_2605_: u32;
    var phi_2632_: f32;
    var phi_2639_: f32;
    var phi_2646_: f32;
    var phi_2681_: f32;
    var phi_2688_: f32;
    var phi_2695_: f32;
    var phi_2733_: f32;
    var phi_2740_: f32;
    var phi_2747_: f32;
    var phi_2806_: vec3<f32>;
    var phi_2807_: vec3<f32>;
    var phi_2808_: vec3<f32>;
    var phi_2817_: f32;
    var phi_2818_: f32;
    var phi_2828_: f32;
    var phi_2829_: f32;
    var phi_2839_: f32;
    var phi_2840_: f32;
    var phi_2875_: abi_Sample;
    var phi_2966_: vec3<f32>;
    var local_5: lt_bvh_Hit;
    var local_6: lt_bvh_Hit;

    let _e72 = id_1;
    let _e76 = arrayLength((&nodes.member));
    let _e79 = arrayLength((&triangles.member));
    let _e82 = arrayLength((&vertices.member));
    let _e91 = arrayLength((&color_texels.member));
    let _e94 = arrayLength((&before.member));
    let _e100 = p.member.size[0u];
    let _e102 = p.member.size[1u];
    let _e103 = lt_shaders_entry_pixel_index(_e72, _e100, _e102);
    if (bitcast<i32>(_e103.root) != 0i) {
        let _e111 = p.member.eye;
        let _e116 = p.member.size[0u];
        let _e120 = ((((f32(_e72.x) + 0.5f) / f32(_e116)) * 2f) - 1f);
        let _e125 = p.member.size[1u];
        let _e129 = (1f - (((f32(_e72.y) + 0.5f) / f32(_e125)) * 2f));
        let _e131 = p.member.forward;
        let _e133 = p.member.right;
        let _e147 = p.member.up;
        let _e158 = _lt_bvh_ray_Ray_new(_e111, vec3<f32>(((_e131.x + (_e133.x * _e120)) + (_e147.x * _e129)), ((_e131.y + (_e133.y * _e120)) + (_e147.y * _e129)), ((_e131.z + (_e133.z * _e120)) + (_e147.z * _e129))));
        let _e160 = lt_bvh_Hit(_e158.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e170 = abs(_e158.direction.x);
        let _e172 = abs(_e158.direction.y);
        let _e174 = abs(_e158.direction.z);
        if (abs(_e158.origin.x) < 1000000000000000f) {
            if (abs(_e158.origin.y) < 1000000000000000f) {
                if (abs(_e158.origin.z) < 1000000000000000f) {
                    if (_e170 < 1000000000000000f) {
                        if (_e172 < 1000000000000000f) {
                            if (_e174 < 1000000000000000f) {
                                if (_e170 > 0f) {
                                    phi_787_ = bool();
                                    phi_788_ = true;
                                } else {
                                    let _e182 = (_e172 > 0f);
                                    if _e182 {
                                        phi_786_ = bool();
                                    } else {
                                        phi_786_ = (_e174 > 0f);
                                    }
                                    let _e185 = phi_786_;
                                    phi_787_ = _e185;
                                    phi_788_ = _e182;
                                }
                                let _e187 = phi_787_;
                                let _e189 = phi_788_;
                                if _e189 {
                                    phi_792_ = true;
                                } else {
                                    phi_792_ = _e187;
                                }
                                let _e191 = phi_792_;
                                phi_793_ = _e191;
                                phi_794_ = false;
                            } else {
                                phi_793_ = bool();
                                phi_794_ = true;
                            }
                            let _e193 = phi_793_;
                            let _e195 = phi_794_;
                            phi_795_ = _e193;
                            phi_796_ = false;
                            phi_797_ = _e195;
                        } else {
                            phi_795_ = bool();
                            phi_796_ = true;
                            phi_797_ = false;
                        }
                        let _e197 = phi_795_;
                        let _e199 = phi_796_;
                        let _e201 = phi_797_;
                        phi_798_ = _e197;
                        phi_799_ = _e199;
                        phi_800_ = _e201;
                    } else {
                        phi_798_ = bool();
                        phi_799_ = true;
                        phi_800_ = false;
                    }
                    let _e203 = phi_798_;
                    let _e205 = phi_799_;
                    let _e207 = phi_800_;
                    phi_801_ = _e203;
                    phi_802_ = _e205;
                    phi_803_ = _e207;
                } else {
                    phi_801_ = bool();
                    phi_802_ = true;
                    phi_803_ = false;
                }
                let _e209 = phi_801_;
                let _e211 = phi_802_;
                let _e213 = phi_803_;
                phi_804_ = _e209;
                phi_805_ = _e211;
                phi_806_ = _e213;
            } else {
                phi_804_ = bool();
                phi_805_ = true;
                phi_806_ = false;
            }
            let _e215 = phi_804_;
            let _e217 = phi_805_;
            let _e219 = phi_806_;
            phi_807_ = _e215;
            phi_808_ = _e217;
            phi_809_ = _e219;
        } else {
            phi_807_ = bool();
            phi_808_ = true;
            phi_809_ = false;
        }
        let _e221 = phi_807_;
        let _e223 = phi_808_;
        let _e225 = phi_809_;
        if _e223 {
            phi_813_ = true;
        } else {
            phi_813_ = _e225;
        }
        let _e227 = phi_813_;
        if _e227 {
            phi_817_ = false;
        } else {
            phi_817_ = _e221;
        }
        let _e229 = phi_817_;
        if _e229 {
            let _e230 = (0u >= _e76);
            if _e230 {
                phi_2170_ = lt_bvh_Hit();
            } else {
                if (0u < _e76) {
                } else {
                    return;
                }
                let _e236 = nodes.member[(0u + 0u)].frame[0u];
                let _e240 = nodes.member[(0u + 0u)].frame[1u];
                let _e244 = nodes.member[(0u + 0u)].frame[2u];
                let _e248 = nodes.member[(0u + 0u)].frame[0u];
                let _e252 = nodes.member[(0u + 0u)].frame[1u];
                let _e256 = nodes.member[(0u + 0u)].frame[2u];
                let _e260 = nodes.member[(0u + 0u)].frame[3u];
                let _e298 = core_intrinsics_maximum_number_nsz_f32_(abs(_e158.direction.x), abs(_e158.direction.y));
                let _e299 = core_intrinsics_maximum_number_nsz_f32_(_e298, abs(_e158.direction.z));
                let _e300 = (_e299 * 0.0000000000009094947f);
                if (abs(_e158.direction.x) < _e300) {
                    phi_892_ = _e300;
                } else {
                    phi_892_ = abs(_e158.direction.x);
                }
                let _e307 = phi_892_;
                if (_e158.direction.x < 0f) {
                    phi_899_ = (-1f / _e307);
                } else {
                    phi_899_ = (1f / _e307);
                }
                let _e312 = phi_899_;
                if (abs(_e158.direction.y) < _e300) {
                    phi_907_ = _e300;
                } else {
                    phi_907_ = abs(_e158.direction.y);
                }
                let _e319 = phi_907_;
                if (_e158.direction.y < 0f) {
                    phi_914_ = (-1f / _e319);
                } else {
                    phi_914_ = (1f / _e319);
                }
                let _e324 = phi_914_;
                if (abs(_e158.direction.z) < _e300) {
                    phi_922_ = _e300;
                } else {
                    phi_922_ = abs(_e158.direction.z);
                }
                let _e331 = phi_922_;
                if (_e158.direction.z < 0f) {
                    phi_929_ = (-1f / _e331);
                } else {
                    phi_929_ = (1f / _e331);
                }
                let _e336 = phi_929_;
                let _e344 = abs((bitcast<f32>(_e236) - _e158.origin.x));
                let _e345 = abs((bitcast<f32>(_e240) - _e158.origin.y));
                let _e346 = abs((bitcast<f32>(_e244) - _e158.origin.z));
                let _e354 = abs(((bitcast<f32>(_e248) + (bitcast<f32>((((_e260 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e158.origin.x));
                let _e355 = abs(((bitcast<f32>(_e252) + (bitcast<f32>((((_e260 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e158.origin.y));
                let _e356 = abs(((bitcast<f32>(_e256) + (bitcast<f32>((((_e260 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e158.origin.z));
                if (_e344 > _e354) {
                    phi_954_ = _e344;
                } else {
                    phi_954_ = _e354;
                }
                let _e359 = phi_954_;
                if (_e345 > _e355) {
                    phi_959_ = _e345;
                } else {
                    phi_959_ = _e355;
                }
                let _e362 = phi_959_;
                if (_e346 > _e356) {
                    phi_964_ = _e346;
                } else {
                    phi_964_ = _e356;
                }
                let _e365 = phi_964_;
                let _e366 = core_intrinsics_maximum_number_nsz_f32_(_e359, _e362);
                let _e367 = core_intrinsics_maximum_number_nsz_f32_(_e366, _e365);
                let _e372 = (_e367 * 0.0000019073486f);
                let _e373 = (abs(_e312) * _e372);
                let _e374 = (abs(_e324) * _e372);
                let _e375 = (abs(_e336) * _e372);
                let _e379 = (_e367 * 0.0000009536743f);
                let _e380 = (abs(_e312) * _e379);
                let _e381 = (abs(_e324) * _e379);
                let _e382 = (abs(_e336) * _e379);
                let _e385 = abs(_e158.direction.x);
                let _e387 = abs(_e158.direction.y);
                let _e389 = abs(_e158.direction.z);
                if (_e385 >= _e387) {
                    if (_e385 >= _e389) {
                        phi_997_ = false;
                    } else {
                        phi_997_ = true;
                    }
                    let _e393 = phi_997_;
                    phi_998_ = _e393;
                } else {
                    phi_998_ = true;
                }
                let _e395 = phi_998_;
                if _e395 {
                    if (_e387 >= _e389) {
                        phi_1006_ = 1u;
                    } else {
                        phi_1006_ = 2u;
                    }
                    let _e398 = phi_1006_;
                    phi_1007_ = _e398;
                } else {
                    phi_1007_ = 0u;
                }
                let _e400 = phi_1007_;
                if (_e400 == 0u) {
                    phi_1026_ = vec3<f32>(_e158.direction.y, _e158.direction.z, _e158.direction.x);
                } else {
                    if (_e400 == 1u) {
                        phi_1025_ = vec3<f32>(_e158.direction.z, _e158.direction.x, _e158.direction.y);
                    } else {
                        phi_1025_ = _e158.direction;
                    }
                    let _e413 = phi_1025_;
                    phi_1026_ = _e413;
                }
                let _e415 = phi_1026_;
                let _e419 = (_e415.x / _e415.z);
                let _e422 = (_e415.y / _e415.z);
                let _e424 = (1f / _e415.z);
                if (_e312 < 0f) {
                    phi_1040_ = 0u;
                } else {
                    phi_1040_ = 1u;
                }
                let _e427 = phi_1040_;
                if (_e324 < 0f) {
                    phi_1045_ = 0u;
                } else {
                    phi_1045_ = 2u;
                }
                let _e430 = phi_1045_;
                if (_e336 < 0f) {
                    phi_1050_ = 0u;
                } else {
                    phi_1050_ = 4u;
                }
                let _e433 = phi_1050_;
                let _e435 = ((_e427 | _e430) | _e433);
                let _e436 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e436.first[0], _e436.first[1], _e436.first[2], _e436.first[3], _e436.first[4], _e436.first[5], _e436.first[6], _e436.first[7], _e436.first[8], _e436.first[9], _e436.first[10], _e436.first[11], _e436.first[12], _e436.first[13], _e436.first[14], _e436.first[15], _e436.first[16], _e436.first[17], _e436.first[18], _e436.first[19], _e436.first[20], _e436.first[21], _e436.first[22], _e436.first[23], _e436.first[24], _e436.first[25], _e436.first[26], _e436.first[27], _e436.first[28], _e436.first[29], _e436.first[30], _e436.first[31]), array<u32, 32>(_e436.mask[0], _e436.mask[1], _e436.mask[2], _e436.mask[3], _e436.mask[4], _e436.mask[5], _e436.mask[6], _e436.mask[7], _e436.mask[8], _e436.mask[9], _e436.mask[10], _e436.mask[11], _e436.mask[12], _e436.mask[13], _e436.mask[14], _e436.mask[15], _e436.mask[16], _e436.mask[17], _e436.mask[18], _e436.mask[19], _e436.mask[20], _e436.mask[21], _e436.mask[22], _e436.mask[23], _e436.mask[24], _e436.mask[25], _e436.mask[26], _e436.mask[27], _e436.mask[28], _e436.mask[29], _e436.mask[30], _e436.mask[31]), _e436.len, _e436.group, _e436.group_mask);
                let _e510 = local_1.group_mask;
                if ((_e510 & 4278190080u) == 0u) {
                    let _e514 = local_1.len;
                    if (_e514 == 0u) {
                        phi_1164_ = false;
                    } else {
                        let _e518 = local_1.len;
                        local_1.len = (_e518 - 1u);
                        let _e521 = local_1.len;
                        if (_e521 < 32u) {
                        } else {
                            return;
                        }
                        let _e526 = local_1.first[(0u + _e521)];
                        local_1.group = _e526;
                        let _e529 = local_1.len;
                        if (_e529 < 32u) {
                        } else {
                            return;
                        }
                        let _e534 = local_1.mask[(0u + _e529)];
                        local_1.group_mask = _e534;
                        phi_1164_ = true;
                    }
                    let _e537 = phi_1164_;
                    phi_1165_ = _e537;
                } else {
                    phi_1165_ = true;
                }
                let _e539 = phi_1165_;
                if _e539 {
                    let _e541 = local_1.group_mask;
                    let _e547 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e541)), 32u, (_e541 == 0u)));
                    let _e551 = local_1.group_mask;
                    let _e565 = local_1.group_mask;
                    local_1.group_mask = (_e565 & ~((1u << bitcast<u32>((_e547 & 31u)))));
                    let _e568 = local_1.group;
                    phi_1196_ = (_e568 + countOneBits(((_e551 & ~((4294967295u << bitcast<u32>((((_e547 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1196_ = 4294967295u;
                }
                let _e571 = phi_1196_;
                phi_1198_ = _e160;
                phi_1201_ = _e571;
                loop {
                    let _e573 = phi_1198_;
                    let _e575 = phi_1201_;
                    local_6 = _e573;
                    let _e576 = (_e575 != 4294967295u);
                    if _e576 {
                        if (_e575 < _e76) {
                        } else {
                            return;
                        }
                        let _e584 = nodes.member[(0u + _e575)].frame[3u];
                        let _e609 = (bitcast<f32>((((_e584 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e312);
                        let _e610 = (bitcast<f32>((((_e584 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e324);
                        let _e611 = (bitcast<f32>((((_e584 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e336);
                        let _e614 = nodes.member[(0u + _e575)].frame[0u];
                        let _e618 = nodes.member[(0u + _e575)].frame[1u];
                        let _e622 = nodes.member[(0u + _e575)].frame[2u];
                        let _e630 = ((bitcast<f32>(_e614) - _e158.origin.x) * _e312);
                        let _e631 = ((bitcast<f32>(_e618) - _e158.origin.y) * _e324);
                        let _e632 = ((bitcast<f32>(_e622) - _e158.origin.z) * _e336);
                        let _e640 = nodes.member[(0u + _e575)].x;
                        if (_e312 < 0f) {
                            let _e651 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e640.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e657 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e651.unnamed.root, _e640.w), _e651.unnamed_1);
                            let _e663 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e657.unnamed, lt_bvh_traverse_Tree(_e640.x, _e657.unnamed_1.first_primitive));
                            phi_1286_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e663.unnamed, lt_bvh_traverse_Tree(_e663.unnamed_1.root, _e640.y));
                        } else {
                            let _e679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e640.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e685 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e679.unnamed.root, _e640.y), _e679.unnamed_1);
                            let _e691 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e685.unnamed, lt_bvh_traverse_Tree(_e640.z, _e685.unnamed_1.first_primitive));
                            phi_1286_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e691.unnamed, lt_bvh_traverse_Tree(_e691.unnamed_1.root, _e640.w));
                        }
                        let _e699 = phi_1286_;
                        let _e709 = nodes.member[(0u + _e575)].y;
                        if (_e324 < 0f) {
                            let _e720 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e709.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e726 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e720.unnamed.root, _e709.w), _e720.unnamed_1);
                            let _e732 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e726.unnamed, lt_bvh_traverse_Tree(_e709.x, _e726.unnamed_1.first_primitive));
                            phi_1313_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e732.unnamed, lt_bvh_traverse_Tree(_e732.unnamed_1.root, _e709.y));
                        } else {
                            let _e748 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e709.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e754 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e748.unnamed.root, _e709.y), _e748.unnamed_1);
                            let _e760 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e754.unnamed, lt_bvh_traverse_Tree(_e709.z, _e754.unnamed_1.first_primitive));
                            phi_1313_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e760.unnamed, lt_bvh_traverse_Tree(_e760.unnamed_1.root, _e709.w));
                        }
                        let _e768 = phi_1313_;
                        let _e778 = nodes.member[(0u + _e575)].z;
                        if (_e336 < 0f) {
                            let _e789 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e778.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e795 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e789.unnamed.root, _e778.w), _e789.unnamed_1);
                            let _e801 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e795.unnamed, lt_bvh_traverse_Tree(_e778.x, _e795.unnamed_1.first_primitive));
                            phi_1340_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e801.unnamed, lt_bvh_traverse_Tree(_e801.unnamed_1.root, _e778.y));
                        } else {
                            let _e817 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e778.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e823 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e817.unnamed.root, _e778.y), _e817.unnamed_1);
                            let _e829 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e823.unnamed, lt_bvh_traverse_Tree(_e778.z, _e823.unnamed_1.first_primitive));
                            phi_1340_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e829.unnamed, lt_bvh_traverse_Tree(_e829.unnamed_1.root, _e778.w));
                        }
                        let _e837 = phi_1340_;
                        phi_1346_ = 0u;
                        phi_1349_ = 0u;
                        loop {
                            let _e847 = phi_1346_;
                            let _e849 = phi_1349_;
                            local_2 = _e849;
                            local_3 = _e849;
                            local_4 = _e849;
                            let _e850 = (_e847 < 8u);
                            if _e850 {
                                let _e852 = (_e847 >> bitcast<u32>(2i));
                                let _e853 = (_e847 & 3u);
                                if (_e852 == 0u) {
                                    phi_1363_ = _e699.unnamed.root;
                                } else {
                                    phi_1363_ = _e699.unnamed.first_primitive;
                                }
                                let _e856 = phi_1363_;
                                if (_e852 == 0u) {
                                    phi_1373_ = _e768.unnamed.root;
                                } else {
                                    phi_1373_ = _e768.unnamed.first_primitive;
                                }
                                let _e865 = phi_1373_;
                                if (_e852 == 0u) {
                                    phi_1383_ = _e837.unnamed.root;
                                } else {
                                    phi_1383_ = _e837.unnamed.first_primitive;
                                }
                                let _e874 = phi_1383_;
                                let _e887 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e856 >> bitcast<u32>(((_e853 * 8u) & 31u))) & 255u)) * _e609) + (_e630 - _e373)), ((f32(((_e865 >> bitcast<u32>(((_e853 * 8u) & 31u))) & 255u)) * _e610) + (_e631 - _e374)));
                                let _e888 = core_intrinsics_maximum_number_nsz_f32_(_e887, ((f32(((_e874 >> bitcast<u32>(((_e853 * 8u) & 31u))) & 255u)) * _e611) + (_e632 - _e375)));
                                if (_e852 == 0u) {
                                    phi_1401_ = _e699.unnamed_1.root;
                                } else {
                                    phi_1401_ = _e699.unnamed_1.first_primitive;
                                }
                                let _e891 = phi_1401_;
                                if (_e852 == 0u) {
                                    phi_1411_ = _e768.unnamed_1.root;
                                } else {
                                    phi_1411_ = _e768.unnamed_1.first_primitive;
                                }
                                let _e900 = phi_1411_;
                                if (_e852 == 0u) {
                                    phi_1421_ = _e837.unnamed_1.root;
                                } else {
                                    phi_1421_ = _e837.unnamed_1.first_primitive;
                                }
                                let _e909 = phi_1421_;
                                let _e922 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e891 >> bitcast<u32>(((_e853 * 8u) & 31u))) & 255u)) * _e609) + (_e630 + _e373)), ((f32(((_e900 >> bitcast<u32>(((_e853 * 8u) & 31u))) & 255u)) * _e610) + (_e631 + _e374)));
                                let _e923 = core_intrinsics_minimum_number_nsz_f32_(_e922, ((f32(((_e909 >> bitcast<u32>(((_e853 * 8u) & 31u))) & 255u)) * _e611) + (_e632 + _e375)));
                                if (_e888 <= _e923) {
                                    if (_e888 <= _e573.t) {
                                        if (_e923 >= _e158.tmin) {
                                            if (_e852 == 0u) {
                                                let _e930 = nodes.member[(0u + _e575)].links[2u];
                                                phi_1457_ = _e930;
                                            } else {
                                                let _e933 = nodes.member[(0u + _e575)].links[3u];
                                                phi_1457_ = _e933;
                                            }
                                            let _e935 = phi_1457_;
                                            let _e940 = ((_e935 >> bitcast<u32>(((_e853 * 8u) & 31u))) & 255u);
                                            let _e941 = (_e940 & 31u);
                                            if (_e941 >= 24u) {
                                                phi_1470_ = (24u + ((_e941 - 24u) ^ _e435));
                                            } else {
                                                phi_1470_ = _e941;
                                            }
                                            let _e947 = phi_1470_;
                                            phi_1475_ = (_e849 | ((_e940 >> bitcast<u32>(5i)) << bitcast<u32>((_e947 & 31u))));
                                        } else {
                                            phi_1475_ = _e849;
                                        }
                                        let _e955 = phi_1475_;
                                        phi_1476_ = _e955;
                                    } else {
                                        phi_1476_ = _e849;
                                    }
                                    let _e957 = phi_1476_;
                                    phi_1477_ = _e957;
                                } else {
                                    phi_1477_ = _e849;
                                }
                                let _e959 = phi_1477_;
                                phi_1347_ = (_e847 + 1u);
                                phi_1350_ = _e959;
                            } else {
                                phi_1347_ = u32();
                                phi_1350_ = u32();
                            }
                            let _e962 = phi_1347_;
                            let _e964 = phi_1350_;
                            continue;
                            continuing {
                                phi_1346_ = _e962;
                                phi_1349_ = _e964;
                                break if !(_e850);
                            }
                        }
                        let _e968 = nodes.member[(0u + _e575)].links[0u];
                        let _e972 = nodes.member[(0u + _e575)].frame[3u];
                        let _e976 = local_2;
                        if ((_e976 & 4278190080u) == 0u) {
                        } else {
                            let _e980 = local_1.group_mask;
                            if ((_e980 & 4278190080u) == 0u) {
                            } else {
                                let _e984 = local_1.len;
                                if (_e984 < 32u) {
                                    let _e987 = local_1.group;
                                    let _e989 = local_1.len;
                                    if (_e989 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e989)] = _e987;
                                    let _e995 = local_1.group_mask;
                                    let _e997 = local_1.len;
                                    if (_e997 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e997)] = _e995;
                                    let _e1004 = local_1.len;
                                    local_1.len = (_e1004 + 1u);
                                }
                            }
                            local_1.group = (0u + _e968);
                            let _e1008 = local_3;
                            local_1.group_mask = ((_e1008 & 4278190080u) | (_e972 >> bitcast<u32>(24i)));
                        }
                        let _e1013 = local_4;
                        phi_1535_ = _e573;
                        phi_1538_ = (_e1013 & 16777215u);
                        loop {
                            let _e1016 = phi_1535_;
                            let _e1018 = phi_1538_;
                            local_5 = _e1016;
                            if (_e1018 == 0u) {
                                phi_1536_ = lt_bvh_Hit();
                                phi_1539_ = u32();
                                phi_2098_ = false;
                            } else {
                                let _e1022 = nodes.member[(0u + _e575)].links[1u];
                                let _e1027 = ((0u + _e1022) + select(firstTrailingBit(_e1018), 32u, (_e1018 == 0u)));
                                if (_e1027 < _e79) {
                                } else {
                                    return;
                                }
                                let _e1034 = triangles.member[(0u + _e1027)].v0_;
                                let _e1037 = (_e1034.x - _e158.origin.x);
                                let _e1040 = (_e1034.y - _e158.origin.y);
                                let _e1043 = (_e1034.z - _e158.origin.z);
                                if (_e400 == 0u) {
                                    phi_1585_ = vec3<f32>(_e1040, _e1043, _e1037);
                                } else {
                                    if (_e400 == 1u) {
                                        phi_1584_ = vec3<f32>(_e1043, _e1037, _e1040);
                                    } else {
                                        phi_1584_ = (_e1034 - _e158.origin);
                                    }
                                    let _e1050 = phi_1584_;
                                    phi_1585_ = _e1050;
                                }
                                let _e1052 = phi_1585_;
                                let _e1056 = (_e1052.x - (_e419 * _e1052.z));
                                let _e1060 = (_e1052.y - (_e422 * _e1052.z));
                                let _e1064 = triangles.member[(0u + _e1027)].v1_;
                                let _e1067 = (_e1064.x - _e158.origin.x);
                                let _e1070 = (_e1064.y - _e158.origin.y);
                                let _e1073 = (_e1064.z - _e158.origin.z);
                                if (_e400 == 0u) {
                                    phi_1619_ = vec3<f32>(_e1070, _e1073, _e1067);
                                } else {
                                    if (_e400 == 1u) {
                                        phi_1618_ = vec3<f32>(_e1073, _e1067, _e1070);
                                    } else {
                                        phi_1618_ = (_e1064 - _e158.origin);
                                    }
                                    let _e1080 = phi_1618_;
                                    phi_1619_ = _e1080;
                                }
                                let _e1082 = phi_1619_;
                                let _e1086 = (_e1082.x - (_e419 * _e1082.z));
                                let _e1090 = (_e1082.y - (_e422 * _e1082.z));
                                let _e1094 = triangles.member[(0u + _e1027)].v2_;
                                let _e1097 = (_e1094.x - _e158.origin.x);
                                let _e1100 = (_e1094.y - _e158.origin.y);
                                let _e1103 = (_e1094.z - _e158.origin.z);
                                if (_e400 == 0u) {
                                    phi_1653_ = vec3<f32>(_e1100, _e1103, _e1097);
                                } else {
                                    if (_e400 == 1u) {
                                        phi_1652_ = vec3<f32>(_e1103, _e1097, _e1100);
                                    } else {
                                        phi_1652_ = (_e1094 - _e158.origin);
                                    }
                                    let _e1110 = phi_1652_;
                                    phi_1653_ = _e1110;
                                }
                                let _e1112 = phi_1653_;
                                let _e1116 = (_e1112.x - (_e419 * _e1112.z));
                                let _e1120 = (_e1112.y - (_e422 * _e1112.z));
                                if (_e1086 < _e1116) {
                                    phi_1674_ = true;
                                } else {
                                    if (_e1086 == _e1116) {
                                        phi_1673_ = (_e1090 < _e1120);
                                    } else {
                                        phi_1673_ = false;
                                    }
                                    let _e1127 = phi_1673_;
                                    phi_1674_ = _e1127;
                                }
                                let _e1129 = phi_1674_;
                                if _e1129 {
                                    phi_1678_ = _e1120;
                                    phi_1679_ = _e1116;
                                    phi_1680_ = _e1090;
                                    phi_1681_ = _e1086;
                                } else {
                                    phi_1678_ = _e1090;
                                    phi_1679_ = _e1086;
                                    phi_1680_ = _e1120;
                                    phi_1681_ = _e1116;
                                }
                                let _e1131 = phi_1678_;
                                let _e1133 = phi_1679_;
                                let _e1135 = phi_1680_;
                                let _e1137 = phi_1681_;
                                let _e1140 = ((_e1137 * _e1131) - (_e1135 * _e1133));
                                if _e1129 {
                                    phi_1689_ = -(_e1140);
                                } else {
                                    phi_1689_ = _e1140;
                                }
                                let _e1143 = phi_1689_;
                                if (_e1116 < _e1056) {
                                    phi_1700_ = true;
                                } else {
                                    if (_e1116 == _e1056) {
                                        phi_1699_ = (_e1120 < _e1060);
                                    } else {
                                        phi_1699_ = false;
                                    }
                                    let _e1148 = phi_1699_;
                                    phi_1700_ = _e1148;
                                }
                                let _e1150 = phi_1700_;
                                if _e1150 {
                                    phi_1704_ = _e1060;
                                    phi_1705_ = _e1056;
                                    phi_1706_ = _e1120;
                                    phi_1707_ = _e1116;
                                } else {
                                    phi_1704_ = _e1120;
                                    phi_1705_ = _e1116;
                                    phi_1706_ = _e1060;
                                    phi_1707_ = _e1056;
                                }
                                let _e1152 = phi_1704_;
                                let _e1154 = phi_1705_;
                                let _e1156 = phi_1706_;
                                let _e1158 = phi_1707_;
                                let _e1161 = ((_e1158 * _e1152) - (_e1156 * _e1154));
                                if _e1150 {
                                    phi_1715_ = -(_e1161);
                                } else {
                                    phi_1715_ = _e1161;
                                }
                                let _e1164 = phi_1715_;
                                if (_e1056 < _e1086) {
                                    phi_1726_ = true;
                                } else {
                                    if (_e1056 == _e1086) {
                                        phi_1725_ = (_e1060 < _e1090);
                                    } else {
                                        phi_1725_ = false;
                                    }
                                    let _e1169 = phi_1725_;
                                    phi_1726_ = _e1169;
                                }
                                let _e1171 = phi_1726_;
                                if _e1171 {
                                    phi_1730_ = _e1090;
                                    phi_1731_ = _e1086;
                                    phi_1732_ = _e1060;
                                    phi_1733_ = _e1056;
                                } else {
                                    phi_1730_ = _e1060;
                                    phi_1731_ = _e1056;
                                    phi_1732_ = _e1090;
                                    phi_1733_ = _e1086;
                                }
                                let _e1173 = phi_1730_;
                                let _e1175 = phi_1731_;
                                let _e1177 = phi_1732_;
                                let _e1179 = phi_1733_;
                                let _e1182 = ((_e1179 * _e1173) - (_e1177 * _e1175));
                                if _e1171 {
                                    phi_1741_ = -(_e1182);
                                } else {
                                    phi_1741_ = _e1182;
                                }
                                let _e1185 = phi_1741_;
                                if (_e1143 >= 0f) {
                                    if (_e1164 >= 0f) {
                                        if (_e1185 >= 0f) {
                                            phi_1756_ = ((_e1143 + _e1164) + _e1185);
                                            phi_1757_ = false;
                                        } else {
                                            phi_1756_ = f32();
                                            phi_1757_ = true;
                                        }
                                        let _e1192 = phi_1756_;
                                        let _e1194 = phi_1757_;
                                        phi_1758_ = _e1192;
                                        phi_1759_ = _e1194;
                                    } else {
                                        phi_1758_ = f32();
                                        phi_1759_ = true;
                                    }
                                    let _e1196 = phi_1758_;
                                    let _e1198 = phi_1759_;
                                    phi_1760_ = _e1196;
                                    phi_1761_ = _e1198;
                                } else {
                                    phi_1760_ = f32();
                                    phi_1761_ = true;
                                }
                                let _e1200 = phi_1760_;
                                let _e1202 = phi_1761_;
                                if _e1202 {
                                    if (_e1143 <= 0f) {
                                        if (_e1164 <= 0f) {
                                            let _e1205 = (_e1185 <= 0f);
                                            if _e1205 {
                                            }
                                            phi_1779_ = ((_e1143 + _e1164) + _e1185);
                                            phi_1780_ = false;
                                            phi_1781_ = _e1205;
                                        } else {
                                            phi_1779_ = f32();
                                            phi_1780_ = true;
                                            phi_1781_ = false;
                                        }
                                        let _e1209 = phi_1779_;
                                        let _e1211 = phi_1780_;
                                        let _e1213 = phi_1781_;
                                        phi_1782_ = _e1209;
                                        phi_1783_ = _e1211;
                                        phi_1784_ = _e1213;
                                    } else {
                                        phi_1782_ = f32();
                                        phi_1783_ = true;
                                        phi_1784_ = false;
                                    }
                                    let _e1215 = phi_1782_;
                                    let _e1217 = phi_1783_;
                                    let _e1219 = phi_1784_;
                                    if _e1217 {
                                        phi_1788_ = false;
                                    } else {
                                        phi_1788_ = _e1219;
                                    }
                                    let _e1221 = phi_1788_;
                                    phi_1789_ = _e1215;
                                    phi_1790_ = _e1221;
                                } else {
                                    phi_1789_ = _e1200;
                                    phi_1790_ = true;
                                }
                                let _e1223 = phi_1789_;
                                let _e1225 = phi_1790_;
                                if _e1225 {
                                    let _e1226 = (_e1223 == 0f);
                                    if _e1226 {
                                        phi_2011_ = lt_bvh_triangle_Intersection();
                                        phi_2012_ = false;
                                    } else {
                                        let _e1232 = ((((_e1143 * (_e424 * _e1052.z)) + (_e1164 * (_e424 * _e1082.z))) + (_e1185 * (_e424 * _e1112.z))) / _e1223);
                                        if (_e1232 > _e158.tmin) {
                                            if (_e1232 < _e158.tmax) {
                                                let _e1238 = triangles.member[(0u + _e1027)].v0_;
                                                let _e1240 = triangles.member[(0u + _e1027)].v1_;
                                                if (_e1238.x < _e1240.x) {
                                                    phi_1826_ = _e1238.x;
                                                } else {
                                                    phi_1826_ = _e1240.x;
                                                }
                                                let _e1247 = phi_1826_;
                                                if (_e1238.y < _e1240.y) {
                                                    phi_1835_ = _e1238.y;
                                                } else {
                                                    phi_1835_ = _e1240.y;
                                                }
                                                let _e1254 = phi_1835_;
                                                if (_e1238.z < _e1240.z) {
                                                    phi_1844_ = _e1238.z;
                                                } else {
                                                    phi_1844_ = _e1240.z;
                                                }
                                                let _e1261 = phi_1844_;
                                                let _e1263 = triangles.member[(0u + _e1027)].v2_;
                                                if (_e1247 < _e1263.x) {
                                                    phi_1853_ = _e1247;
                                                } else {
                                                    phi_1853_ = _e1263.x;
                                                }
                                                let _e1268 = phi_1853_;
                                                if (_e1254 < _e1263.y) {
                                                    phi_1860_ = _e1254;
                                                } else {
                                                    phi_1860_ = _e1263.y;
                                                }
                                                let _e1273 = phi_1860_;
                                                if (_e1261 < _e1263.z) {
                                                    phi_1867_ = _e1261;
                                                } else {
                                                    phi_1867_ = _e1263.z;
                                                }
                                                let _e1278 = phi_1867_;
                                                let _e1280 = triangles.member[(0u + _e1027)].v0_;
                                                let _e1282 = triangles.member[(0u + _e1027)].v1_;
                                                if (_e1280.x > _e1282.x) {
                                                    phi_1880_ = _e1280.x;
                                                } else {
                                                    phi_1880_ = _e1282.x;
                                                }
                                                let _e1289 = phi_1880_;
                                                if (_e1280.y > _e1282.y) {
                                                    phi_1889_ = _e1280.y;
                                                } else {
                                                    phi_1889_ = _e1282.y;
                                                }
                                                let _e1296 = phi_1889_;
                                                if (_e1280.z > _e1282.z) {
                                                    phi_1898_ = _e1280.z;
                                                } else {
                                                    phi_1898_ = _e1282.z;
                                                }
                                                let _e1303 = phi_1898_;
                                                let _e1305 = triangles.member[(0u + _e1027)].v2_;
                                                if (_e1289 > _e1305.x) {
                                                    phi_1907_ = _e1289;
                                                } else {
                                                    phi_1907_ = _e1305.x;
                                                }
                                                let _e1310 = phi_1907_;
                                                if (_e1296 > _e1305.y) {
                                                    phi_1914_ = _e1296;
                                                } else {
                                                    phi_1914_ = _e1305.y;
                                                }
                                                let _e1315 = phi_1914_;
                                                if (_e1303 > _e1305.z) {
                                                    phi_1921_ = _e1303;
                                                } else {
                                                    phi_1921_ = _e1305.z;
                                                }
                                                let _e1320 = phi_1921_;
                                                let _e1327 = ((_e1268 - _e158.origin.x) * _e312);
                                                let _e1328 = ((_e1273 - _e158.origin.y) * _e324);
                                                let _e1329 = ((_e1278 - _e158.origin.z) * _e336);
                                                let _e1336 = ((_e1310 - _e158.origin.x) * _e312);
                                                let _e1337 = ((_e1315 - _e158.origin.y) * _e324);
                                                let _e1338 = ((_e1320 - _e158.origin.z) * _e336);
                                                if (_e1327 < _e1336) {
                                                    phi_1944_ = _e1327;
                                                } else {
                                                    phi_1944_ = _e1336;
                                                }
                                                let _e1341 = phi_1944_;
                                                if (_e1328 < _e1337) {
                                                    phi_1949_ = _e1328;
                                                } else {
                                                    phi_1949_ = _e1337;
                                                }
                                                let _e1344 = phi_1949_;
                                                if (_e1329 < _e1338) {
                                                    phi_1954_ = _e1329;
                                                } else {
                                                    phi_1954_ = _e1338;
                                                }
                                                let _e1347 = phi_1954_;
                                                if (_e1327 > _e1336) {
                                                    phi_1962_ = _e1327;
                                                } else {
                                                    phi_1962_ = _e1336;
                                                }
                                                let _e1353 = phi_1962_;
                                                if (_e1328 > _e1337) {
                                                    phi_1967_ = _e1328;
                                                } else {
                                                    phi_1967_ = _e1337;
                                                }
                                                let _e1356 = phi_1967_;
                                                if (_e1329 > _e1338) {
                                                    phi_1972_ = _e1329;
                                                } else {
                                                    phi_1972_ = _e1338;
                                                }
                                                let _e1359 = phi_1972_;
                                                let _e1363 = core_intrinsics_maximum_number_nsz_f32_((_e1341 - _e380), (_e1344 - _e381));
                                                let _e1364 = core_intrinsics_maximum_number_nsz_f32_(_e1363, (_e1347 - _e382));
                                                let _e1365 = core_intrinsics_minimum_number_nsz_f32_((_e1353 + _e380), (_e1356 + _e381));
                                                let _e1366 = core_intrinsics_minimum_number_nsz_f32_(_e1365, (_e1359 + _e382));
                                                if (_e1364 > -300000000000000000000000000000000000000f) {
                                                    phi_1984_ = _e1364;
                                                } else {
                                                    phi_1984_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1369 = phi_1984_;
                                                if (_e1366 < 300000000000000000000000000000000000000f) {
                                                    phi_1989_ = _e1366;
                                                } else {
                                                    phi_1989_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1372 = phi_1989_;
                                                if (_e1232 < _e1369) {
                                                    phi_1994_ = _e1369;
                                                } else {
                                                    phi_1994_ = _e1232;
                                                }
                                                let _e1375 = phi_1994_;
                                                if (_e1375 > _e1372) {
                                                    phi_1999_ = _e1372;
                                                } else {
                                                    phi_1999_ = _e1375;
                                                }
                                                let _e1378 = phi_1999_;
                                                phi_2004_ = lt_bvh_triangle_Intersection(_e1378, (_e1164 / _e1223), (_e1185 / _e1223), (_e1369 <= _e1372));
                                                phi_2005_ = false;
                                            } else {
                                                phi_2004_ = lt_bvh_triangle_Intersection();
                                                phi_2005_ = true;
                                            }
                                            let _e1384 = phi_2004_;
                                            let _e1386 = phi_2005_;
                                            phi_2006_ = _e1384;
                                            phi_2007_ = _e1386;
                                        } else {
                                            phi_2006_ = lt_bvh_triangle_Intersection();
                                            phi_2007_ = true;
                                        }
                                        let _e1388 = phi_2006_;
                                        let _e1390 = phi_2007_;
                                        if _e1390 {
                                        }
                                        phi_2011_ = _e1388;
                                        phi_2012_ = _e1390;
                                    }
                                    let _e1392 = phi_2011_;
                                    let _e1394 = phi_2012_;
                                    phi_2013_ = _e1392;
                                    phi_2014_ = _e1226;
                                    phi_2015_ = _e1394;
                                } else {
                                    phi_2013_ = lt_bvh_triangle_Intersection();
                                    phi_2014_ = true;
                                    phi_2015_ = false;
                                }
                                let _e1396 = phi_2013_;
                                let _e1398 = phi_2014_;
                                let _e1400 = phi_2015_;
                                if _e1398 {
                                    phi_2019_ = true;
                                } else {
                                    phi_2019_ = _e1400;
                                }
                                let _e1402 = phi_2019_;
                                if _e1402 {
                                    phi_2023_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2023_ = _e1396;
                                }
                                let _e1404 = phi_2023_;
                                if _e1404.is_hit {
                                    if (_e1404.t > _e158.tmin) {
                                        if (_e1404.t < _e1016.t) {
                                            phi_2072_ = true;
                                        } else {
                                            if (_e1404.t == _e1016.t) {
                                                if (_e1016.triangle != 4294967295u) {
                                                    if (_e1027 < _e1016.triangle) {
                                                        phi_2063_ = true;
                                                    } else {
                                                        if (_e1027 == _e1016.triangle) {
                                                            phi_2062_ = (4294967295u < _e1016.instance);
                                                        } else {
                                                            phi_2062_ = false;
                                                        }
                                                        let _e1423 = phi_2062_;
                                                        phi_2063_ = _e1423;
                                                    }
                                                    let _e1425 = phi_2063_;
                                                    phi_2064_ = _e1425;
                                                    phi_2065_ = false;
                                                } else {
                                                    phi_2064_ = bool();
                                                    phi_2065_ = true;
                                                }
                                                let _e1427 = phi_2064_;
                                                let _e1429 = phi_2065_;
                                                phi_2066_ = _e1427;
                                                phi_2067_ = _e1429;
                                            } else {
                                                phi_2066_ = bool();
                                                phi_2067_ = true;
                                            }
                                            let _e1431 = phi_2066_;
                                            let _e1433 = phi_2067_;
                                            if _e1433 {
                                                phi_2071_ = false;
                                            } else {
                                                phi_2071_ = _e1431;
                                            }
                                            let _e1435 = phi_2071_;
                                            phi_2072_ = _e1435;
                                        }
                                        let _e1437 = phi_2072_;
                                        if _e1437 {
                                            let _e1439 = triangles.member[(0u + _e1027)].i0_;
                                            if ((_e1439 & 2147483648u) == 0u) {
                                                phi_2086_ = true;
                                            } else {
                                                if true {
                                                }
                                                phi_2086_ = true;
                                            }
                                            let _e1443 = phi_2086_;
                                            if _e1443 {
                                                phi_2094_ = lt_bvh_Hit(_e1404.t, _e1404.u, _e1404.v, _e1027, 4294967295u);
                                            } else {
                                                phi_2094_ = _e1016;
                                            }
                                            let _e1449 = phi_2094_;
                                            phi_2095_ = _e1449;
                                        } else {
                                            phi_2095_ = _e1016;
                                        }
                                        let _e1451 = phi_2095_;
                                        phi_2096_ = _e1451;
                                    } else {
                                        phi_2096_ = _e1016;
                                    }
                                    let _e1453 = phi_2096_;
                                    phi_2097_ = _e1453;
                                } else {
                                    phi_2097_ = _e1016;
                                }
                                let _e1455 = phi_2097_;
                                phi_1536_ = _e1455;
                                phi_1539_ = (_e1018 & (_e1018 - 1u));
                                phi_2098_ = true;
                            }
                            let _e1457 = phi_1536_;
                            let _e1459 = phi_1539_;
                            let _e1461 = phi_2098_;
                            continue;
                            continuing {
                                phi_1535_ = _e1457;
                                phi_1538_ = _e1459;
                                break if !(_e1461);
                            }
                        }
                        let _e1464 = local_1.group_mask;
                        if ((_e1464 & 4278190080u) == 0u) {
                            let _e1468 = local_1.len;
                            if (_e1468 == 0u) {
                                phi_2137_ = false;
                            } else {
                                let _e1472 = local_1.len;
                                local_1.len = (_e1472 - 1u);
                                let _e1475 = local_1.len;
                                if (_e1475 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1480 = local_1.first[(0u + _e1475)];
                                local_1.group = _e1480;
                                let _e1483 = local_1.len;
                                if (_e1483 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1488 = local_1.mask[(0u + _e1483)];
                                local_1.group_mask = _e1488;
                                phi_2137_ = true;
                            }
                            let _e1491 = phi_2137_;
                            phi_2138_ = _e1491;
                        } else {
                            phi_2138_ = true;
                        }
                        let _e1493 = phi_2138_;
                        if _e1493 {
                            let _e1495 = local_1.group_mask;
                            let _e1501 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1495)), 32u, (_e1495 == 0u)));
                            let _e1505 = local_1.group_mask;
                            let _e1519 = local_1.group_mask;
                            local_1.group_mask = (_e1519 & ~((1u << bitcast<u32>((_e1501 & 31u)))));
                            let _e1522 = local_1.group;
                            phi_2169_ = (_e1522 + countOneBits(((_e1505 & ~((4294967295u << bitcast<u32>((((_e1501 - 24u) ^ _e435) & 31u))))) & 255u)));
                        } else {
                            phi_2169_ = 4294967295u;
                        }
                        let _e1525 = phi_2169_;
                        let _e2439 = local_5;
                        phi_1199_ = _e2439;
                        phi_1202_ = _e1525;
                    } else {
                        phi_1199_ = lt_bvh_Hit();
                        phi_1202_ = u32();
                    }
                    let _e1527 = phi_1199_;
                    let _e1529 = phi_1202_;
                    continue;
                    continuing {
                        phi_1198_ = _e1527;
                        phi_1201_ = _e1529;
                        break if !(_e576);
                    }
                }
                let _e2443 = local_6;
                phi_2170_ = _e2443;
            }
            let _e1532 = phi_2170_;
            phi_2171_ = _e1532;
            phi_2172_ = _e230;
        } else {
            phi_2171_ = lt_bvh_Hit();
            phi_2172_ = true;
        }
        let _e1534 = phi_2171_;
        let _e1536 = phi_2172_;
        if _e1536 {
            phi_2176_ = _e160;
        } else {
            phi_2176_ = _e1534;
        }
        let _e1538 = phi_2176_;
        if (_e1538.triangle != 4294967295u) {
            let _e1544 = ((1f - _e1538.u) - _e1538.v);
            if (_e1538.triangle < _e79) {
            } else {
                return;
            }
            let _e1549 = triangles.member[(0u + _e1538.triangle)];
            let _e1574 = (((_e1549.v0_.x * _e1544) + (_e1549.v1_.x * _e1538.u)) + (_e1549.v2_.x * _e1538.v));
            let _e1575 = (((_e1549.v0_.y * _e1544) + (_e1549.v1_.y * _e1538.u)) + (_e1549.v2_.y * _e1538.v));
            let _e1576 = (((_e1549.v0_.z * _e1544) + (_e1549.v1_.z * _e1538.u)) + (_e1549.v2_.z * _e1538.v));
            let _e1579 = abs(_e1549.v0_.x);
            let _e1581 = abs(_e1549.v0_.y);
            let _e1583 = abs(_e1549.v0_.z);
            let _e1585 = abs(_e1549.v1_.x);
            let _e1587 = abs(_e1549.v1_.y);
            let _e1589 = abs(_e1549.v1_.z);
            if (_e1579 > _e1585) {
                phi_2240_ = _e1579;
            } else {
                phi_2240_ = _e1585;
            }
            let _e1592 = phi_2240_;
            if (_e1581 > _e1587) {
                phi_2245_ = _e1581;
            } else {
                phi_2245_ = _e1587;
            }
            let _e1595 = phi_2245_;
            if (_e1583 > _e1589) {
                phi_2250_ = _e1583;
            } else {
                phi_2250_ = _e1589;
            }
            let _e1598 = phi_2250_;
            let _e1600 = abs(_e1549.v2_.x);
            let _e1602 = abs(_e1549.v2_.y);
            let _e1604 = abs(_e1549.v2_.z);
            if (_e1592 > _e1600) {
                phi_2261_ = _e1592;
            } else {
                phi_2261_ = _e1600;
            }
            let _e1607 = phi_2261_;
            if (_e1595 > _e1602) {
                phi_2266_ = _e1595;
            } else {
                phi_2266_ = _e1602;
            }
            let _e1610 = phi_2266_;
            if (_e1598 > _e1604) {
                phi_2271_ = _e1598;
            } else {
                phi_2271_ = _e1604;
            }
            let _e1613 = phi_2271_;
            let _e1616 = (_e1549.v1_.x - _e1549.v0_.x);
            let _e1619 = (_e1549.v1_.y - _e1549.v0_.y);
            let _e1622 = (_e1549.v1_.z - _e1549.v0_.z);
            let _e1625 = (_e1549.v2_.x - _e1549.v0_.x);
            let _e1628 = (_e1549.v2_.y - _e1549.v0_.y);
            let _e1631 = (_e1549.v2_.z - _e1549.v0_.z);
            let _e1635 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1619), abs(_e1622));
            let _e1636 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1616), _e1635);
            let _e1637 = (_e1616 / _e1636);
            let _e1638 = (_e1619 / _e1636);
            let _e1639 = (_e1622 / _e1636);
            let _e1643 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1628), abs(_e1631));
            let _e1644 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1625), _e1643);
            let _e1645 = (_e1625 / _e1644);
            let _e1646 = (_e1628 / _e1644);
            let _e1647 = (_e1631 / _e1644);
            let _e1650 = ((_e1638 * _e1647) - (_e1646 * _e1639));
            let _e1653 = ((_e1639 * _e1645) - (_e1647 * _e1637));
            let _e1656 = ((_e1637 * _e1646) - (_e1645 * _e1638));
            let _e1658 = p.member.eye;
            let _e1671 = (1f / sqrt((((_e1650 * _e1650) + (_e1653 * _e1653)) + (_e1656 * _e1656))));
            let _e1672 = (_e1650 * _e1671);
            let _e1673 = (_e1653 * _e1671);
            let _e1674 = (_e1656 * _e1671);
            if ((((_e1672 * (_e1658.x - _e1574)) + (_e1673 * (_e1658.y - _e1575))) + (_e1674 * (_e1658.z - _e1576))) < 0f) {
                phi_2347_ = vec3<f32>(-(_e1672), -(_e1673), -(_e1674));
            } else {
                phi_2347_ = vec3<f32>(_e1672, _e1673, _e1674);
            }
            let _e1687 = phi_2347_;
            if (_e1538.triangle < _e79) {
            } else {
                return;
            }
            let _e1692 = triangles.member[(0u + _e1538.triangle)];
            let _e1694 = (_e1692.i0_ & 2147483647u);
            if (_e1694 < _e82) {
            } else {
                return;
            }
            let _e1700 = vertices.member[(0u + _e1694)];
            if (_e1692.i1_ < _e82) {
            } else {
                return;
            }
            let _e1704 = vertices.member[(0u + _e1692.i1_)];
            if (_e1692.i2_ < _e82) {
            } else {
                return;
            }
            let _e1708 = vertices.member[(0u + _e1692.i2_)];
            let _e1709 = array<abi_Vertex, 3>(_e1700, _e1704, _e1708);
            if (_e1709[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e1715 = materials.member[(0u + _e1709[0].material)];
            let _e1732 = (1f / 255f);
            let _e1751 = (1f / 255f);
            let _e1773 = (1f / 255f);
            if (_e1715.color_size == 0u) {
                phi_2590_ = vec3<f32>(1f, 1f, 1f);
            } else {
                local.offset = _e1715.color_offset;
                local.size = _e1715.color_size;
                local.flags = _e1715.flags;
                let _e1816 = _lt_shaders_texture_TextureView_quad((&local), (((_e1709[0].u * _e1544) + (_e1709[1].u * _e1538.u)) + (_e1709[2].u * _e1538.v)), (((_e1709[0].v * _e1544) + (_e1709[1].v * _e1538.u)) + (_e1709[2].v * _e1538.v)));
                if (_e1816.indices[0] < _e91) {
                } else {
                    return;
                }
                let _e1822 = color_texels.member[(0u + _e1816.indices[0])];
                let _e1833 = (1f / 255f);
                if (_e1816.indices[1] < _e91) {
                } else {
                    return;
                }
                let _e1847 = color_texels.member[(0u + _e1816.indices[1])];
                let _e1858 = (1f / 255f);
                if (_e1816.indices[2] < _e91) {
                } else {
                    return;
                }
                let _e1875 = color_texels.member[(0u + _e1816.indices[2])];
                let _e1886 = (1f / 255f);
                if (_e1816.indices[3] < _e91) {
                } else {
                    return;
                }
                let _e1903 = color_texels.member[(0u + _e1816.indices[3])];
                let _e1914 = (1f / 255f);
                let _e1923 = (((((f32((_e1822 & 255u)) * _e1833) * _e1816.weights.x) + ((f32((_e1847 & 255u)) * _e1858) * _e1816.weights.y)) + ((f32((_e1875 & 255u)) * _e1886) * _e1816.weights.z)) + ((f32((_e1903 & 255u)) * _e1914) * _e1816.weights.w));
                let _e1924 = (((((f32(((_e1822 >> bitcast<u32>(8i)) & 255u)) * _e1833) * _e1816.weights.x) + ((f32(((_e1847 >> bitcast<u32>(8i)) & 255u)) * _e1858) * _e1816.weights.y)) + ((f32(((_e1875 >> bitcast<u32>(8i)) & 255u)) * _e1886) * _e1816.weights.z)) + ((f32(((_e1903 >> bitcast<u32>(8i)) & 255u)) * _e1914) * _e1816.weights.w));
                let _e1925 = (((((f32(((_e1822 >> bitcast<u32>(16i)) & 255u)) * _e1833) * _e1816.weights.x) + ((f32(((_e1847 >> bitcast<u32>(16i)) & 255u)) * _e1858) * _e1816.weights.y)) + ((f32(((_e1875 >> bitcast<u32>(16i)) & 255u)) * _e1886) * _e1816.weights.z)) + ((f32(((_e1903 >> bitcast<u32>(16i)) & 255u)) * _e1914) * _e1816.weights.w));
                phi_2590_ = vec3<f32>((_e1923 * _e1923), (_e1924 * _e1924), (_e1925 * _e1925));
            }
            let _e1931 = phi_2590_;
            let _e1933 = ((_e1715.base_color.x * ((((f32((_e1709[0].color & 255u)) * _e1732) * _e1544) + ((f32((_e1709[1].color & 255u)) * _e1751) * _e1538.u)) + ((f32((_e1709[2].color & 255u)) * _e1773) * _e1538.v))) * _e1931.x);
            let _e1935 = ((_e1715.base_color.y * ((((f32(((_e1709[0].color >> bitcast<u32>(8i)) & 255u)) * _e1732) * _e1544) + ((f32(((_e1709[1].color >> bitcast<u32>(8i)) & 255u)) * _e1751) * _e1538.u)) + ((f32(((_e1709[2].color >> bitcast<u32>(8i)) & 255u)) * _e1773) * _e1538.v))) * _e1931.y);
            let _e1937 = ((_e1715.base_color.z * ((((f32(((_e1709[0].color >> bitcast<u32>(16i)) & 255u)) * _e1732) * _e1544) + ((f32(((_e1709[1].color >> bitcast<u32>(16i)) & 255u)) * _e1751) * _e1538.u)) + ((f32(((_e1709[2].color >> bitcast<u32>(16i)) & 255u)) * _e1773) * _e1538.v))) * _e1931.z);
            let _e1938 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1610, _e1613);
            let _e1939 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1607, _e1938);
            if ((_e1715.flags & 2u) == 0u) {
                phi_2605_ = 0u;
            } else {
                phi_2605_ = 1u;
            }
            let _e1944 = phi_2605_;
            if (_e1709[0].normal == 2147516416u) {
                phi_2808_ = _e1687;
            } else {
                let _e1957 = (f32((bitcast<i32>((_e1709[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1963 = (f32((bitcast<i32>(_e1709[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1967 = ((1f - abs(_e1957)) - abs(_e1963));
                if (_e1967 < 0f) {
                    phi_2632_ = -(_e1967);
                } else {
                    phi_2632_ = 0f;
                }
                let _e1971 = phi_2632_;
                if (_e1957 < 0f) {
                    phi_2639_ = (_e1957 + _e1971);
                } else {
                    phi_2639_ = (_e1957 - _e1971);
                }
                let _e1976 = phi_2639_;
                if (_e1963 < 0f) {
                    phi_2646_ = (_e1963 + _e1971);
                } else {
                    phi_2646_ = (_e1963 - _e1971);
                }
                let _e1981 = phi_2646_;
                let _e1988 = (1f / sqrt((((_e1976 * _e1976) + (_e1981 * _e1981)) + (_e1967 * _e1967))));
                let _e2004 = (f32((bitcast<i32>((_e1709[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2010 = (f32((bitcast<i32>(_e1709[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2014 = ((1f - abs(_e2004)) - abs(_e2010));
                if (_e2014 < 0f) {
                    phi_2681_ = -(_e2014);
                } else {
                    phi_2681_ = 0f;
                }
                let _e2018 = phi_2681_;
                if (_e2004 < 0f) {
                    phi_2688_ = (_e2004 + _e2018);
                } else {
                    phi_2688_ = (_e2004 - _e2018);
                }
                let _e2023 = phi_2688_;
                if (_e2010 < 0f) {
                    phi_2695_ = (_e2010 + _e2018);
                } else {
                    phi_2695_ = (_e2010 - _e2018);
                }
                let _e2028 = phi_2695_;
                let _e2035 = (1f / sqrt((((_e2023 * _e2023) + (_e2028 * _e2028)) + (_e2014 * _e2014))));
                let _e2054 = (f32((bitcast<i32>((_e1709[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2060 = (f32((bitcast<i32>(_e1709[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2064 = ((1f - abs(_e2054)) - abs(_e2060));
                if (_e2064 < 0f) {
                    phi_2733_ = -(_e2064);
                } else {
                    phi_2733_ = 0f;
                }
                let _e2068 = phi_2733_;
                if (_e2054 < 0f) {
                    phi_2740_ = (_e2054 + _e2068);
                } else {
                    phi_2740_ = (_e2054 - _e2068);
                }
                let _e2073 = phi_2740_;
                if (_e2060 < 0f) {
                    phi_2747_ = (_e2060 + _e2068);
                } else {
                    phi_2747_ = (_e2060 - _e2068);
                }
                let _e2078 = phi_2747_;
                let _e2085 = (1f / sqrt((((_e2073 * _e2073) + (_e2078 * _e2078)) + (_e2064 * _e2064))));
                let _e2096 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e1976 * _e1988) * _e1544) + ((_e2023 * _e2035) * _e1538.u)) + ((_e2073 * _e2085) * _e1538.v)), ((((_e1981 * _e1988) * _e1544) + ((_e2028 * _e2035) * _e1538.u)) + ((_e2078 * _e2085) * _e1538.v)), ((((_e1967 * _e1988) * _e1544) + ((_e2014 * _e2035) * _e1538.u)) + ((_e2064 * _e2085) * _e1538.v))));
                let _e2108 = sqrt((((_e2096.x * _e2096.x) + (_e2096.y * _e2096.y)) + (_e2096.z * _e2096.z)));
                if (_e2108 > 0f) {
                    let _e2111 = (_e2096.x / _e2108);
                    let _e2113 = (_e2096.y / _e2108);
                    let _e2115 = (_e2096.z / _e2108);
                    if ((((_e2111 * _e1687.x) + (_e2113 * _e1687.y)) + (_e2115 * _e1687.z)) < 0f) {
                        phi_2806_ = vec3<f32>(-(_e2111), -(_e2113), -(_e2115));
                    } else {
                        phi_2806_ = (_e2096 / vec3(_e2108));
                    }
                    let _e2132 = phi_2806_;
                    phi_2807_ = _e2132;
                } else {
                    phi_2807_ = _e1687;
                }
                let _e2134 = phi_2807_;
                phi_2808_ = _e2134;
            }
            let _e2136 = phi_2808_;
            if (_e1933 > 0f) {
                if (_e1933 < 1f) {
                    phi_2817_ = _e1933;
                } else {
                    phi_2817_ = 1f;
                }
                let _e2140 = phi_2817_;
                phi_2818_ = _e2140;
            } else {
                phi_2818_ = 0f;
            }
            let _e2142 = phi_2818_;
            if (_e1935 > 0f) {
                if (_e1935 < 1f) {
                    phi_2828_ = _e1935;
                } else {
                    phi_2828_ = 1f;
                }
                let _e2147 = phi_2828_;
                phi_2829_ = _e2147;
            } else {
                phi_2829_ = 0f;
            }
            let _e2149 = phi_2829_;
            if (_e1937 > 0f) {
                if (_e1937 < 1f) {
                    phi_2839_ = _e1937;
                } else {
                    phi_2839_ = 1f;
                }
                let _e2154 = phi_2839_;
                phi_2840_ = _e2154;
            } else {
                phi_2840_ = 0f;
            }
            let _e2156 = phi_2840_;
            let _e2159 = ((sqrt(_e2142) * 255f) + 0.5f);
            let _e2168 = ((sqrt(_e2149) * 255f) + 0.5f);
            let _e2180 = ((sqrt(_e2156) * 255f) + 0.5f);
            phi_2875_ = abi_Sample(vec3<f32>(_e1574, _e1575, _e1576), _e1939, _e1687, _e1944, _e2136, ((select(select(u32(_e2159), 0u, (_e2159 < bitcast<f32>(0u))), 4294967295u, (_e2159 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2168), 0u, (_e2168 < bitcast<f32>(0u))), 4294967295u, (_e2168 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2180), 0u, (_e2180 < bitcast<f32>(0u))), 4294967295u, (_e2180 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_2875_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2194 = phi_2875_;
        if (_e103.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e103.first_primitive)] = _e2194;
        if (_e1538.triangle != 4294967295u) {
            let _e2203 = ((1f - _e1538.u) - _e1538.v);
            if (_e1538.triangle < _e79) {
            } else {
                return;
            }
            let _e2208 = triangles.member[(0u + _e1538.triangle)];
            let _e2210 = (_e2208.i0_ & 2147483647u);
            if (_e2210 < _e94) {
            } else {
                return;
            }
            let _e2216 = before.member[(0u + _e2210)];
            if (_e2208.i1_ < _e94) {
            } else {
                return;
            }
            let _e2220 = before.member[(0u + _e2208.i1_)];
            if (_e2208.i2_ < _e94) {
            } else {
                return;
            }
            let _e2224 = before.member[(0u + _e2208.i2_)];
            let _e2229 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2216.x, _e2216.y, _e2216.z));
            let _e2240 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2220.x, _e2220.y, _e2220.z));
            let _e2254 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2224.x, _e2224.y, _e2224.z));
            phi_2966_ = vec3<f32>((((_e2229.x * _e2203) + (_e2240.x * _e1538.u)) + (_e2254.x * _e1538.v)), (((_e2229.y * _e2203) + (_e2240.y * _e1538.u)) + (_e2254.y * _e1538.v)), (((_e2229.z * _e2203) + (_e2240.z * _e1538.u)) + (_e2254.z * _e1538.v)));
        } else {
            phi_2966_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e2266 = phi_2966_;
        if (_e103.first_primitive < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e103.first_primitive)] = vec4<f32>(_e2266.x, _e2266.y, _e2266.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_color_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
