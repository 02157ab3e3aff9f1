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

struct type_16 {
    member: array<abi_Sample>,
}

struct type_24 {
    member: array<vec4<f32>>,
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
var<storage, read_write> samples: type_16;
@group(0) @binding(6) 
var<storage> before: type_24;
@group(0) @binding(7) 
var<storage, read_write> past: type_24;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_197_: lt_bvh_traverse_Tree;
    var phi_198_: bool;
    var phi_199_: lt_bvh_traverse_Tree;
    var phi_200_: bool;
    var phi_205_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_197_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_198_ = false;
        } else {
            phi_197_ = lt_bvh_traverse_Tree();
            phi_198_ = true;
        }
        let _e76 = phi_197_;
        let _e78 = phi_198_;
        phi_199_ = _e76;
        phi_200_ = _e78;
    } else {
        phi_199_ = lt_bvh_traverse_Tree();
        phi_200_ = true;
    }
    let _e80 = phi_199_;
    let _e82 = phi_200_;
    if _e82 {
        phi_205_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_205_ = _e80;
    }
    let _e87 = phi_205_;
    return lt_bvh_traverse_Tree(_e87.root, _e87.first_primitive);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_220_: bool;
    var phi_224_: f32;

    if (param_3 != param_3) {
        phi_220_ = true;
    } else {
        let _e66 = (param_4 >= param_3);
        if _e66 {
        }
        phi_220_ = _e66;
    }
    let _e68 = phi_220_;
    if _e68 {
        phi_224_ = param_4;
    } else {
        phi_224_ = param_3;
    }
    let _e70 = phi_224_;
    return _e70;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_236_: bool;
    var phi_240_: f32;

    if (param_5 != param_5) {
        phi_236_ = true;
    } else {
        let _e66 = (param_6 <= param_5);
        if _e66 {
        }
        phi_236_ = _e66;
    }
    let _e68 = phi_236_;
    if _e68 {
        phi_240_ = param_6;
    } else {
        phi_240_ = param_5;
    }
    let _e70 = phi_240_;
    return _e70;
}

fn _lt_bvh_ray_Ray_new(param_7: vec3<f32>, param_8: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_7, 0f, param_8, 300000000000000000000000000000000000000f);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_9: f32, param_10: f32) -> f32 {
    var phi_252_: f32;

    if (param_9 > param_10) {
        phi_252_ = param_9;
    } else {
        phi_252_ = param_10;
    }
    let _e67 = phi_252_;
    return _e67;
}

fn _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(param_11: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(1f, 1f, 1f);
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(param_12: vec3<f32>) -> vec3<f32> {
    return param_12;
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(param_13: vec3<f32>) -> vec3<f32> {
    return param_13;
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var phi_389_: bool;
    var phi_390_: bool;
    var phi_391_: bool;
    var phi_392_: bool;
    var phi_396_: bool;
    var phi_409_: bool;
    var phi_410_: bool;
    var phi_411_: bool;
    var phi_412_: bool;
    var phi_416_: bool;
    var phi_429_: bool;
    var phi_430_: bool;
    var phi_431_: bool;
    var phi_435_: bool;
    var phi_436_: bool;
    var phi_437_: bool;
    var phi_438_: bool;
    var phi_439_: bool;
    var phi_443_: bool;
    var phi_519_: f32;
    var phi_526_: f32;
    var phi_534_: f32;
    var phi_541_: f32;
    var phi_549_: f32;
    var phi_556_: f32;
    var phi_579_: f32;
    var phi_584_: f32;
    var phi_589_: f32;
    var phi_594_: f32;
    var phi_599_: f32;
    var phi_630_: bool;
    var phi_631_: bool;
    var phi_639_: u32;
    var phi_640_: u32;
    var phi_657_: vec3<f32>;
    var phi_658_: vec3<f32>;
    var phi_671_: u32;
    var phi_676_: u32;
    var phi_681_: u32;
    var phi_795_: bool;
    var phi_796_: bool;
    var phi_827_: u32;
    var phi_829_: lt_bvh_Hit;
    var phi_832_: u32;
    var phi_917_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_944_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_971_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_977_: u32;
    var phi_980_: u32;
    var phi_994_: u32;
    var phi_1004_: u32;
    var phi_1014_: u32;
    var phi_1032_: u32;
    var phi_1042_: u32;
    var phi_1052_: u32;
    var phi_1088_: u32;
    var phi_1101_: u32;
    var phi_1106_: u32;
    var phi_1107_: u32;
    var phi_1108_: u32;
    var phi_978_: u32;
    var phi_981_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1166_: lt_bvh_Hit;
    var phi_1169_: u32;
    var phi_1215_: vec3<f32>;
    var phi_1216_: vec3<f32>;
    var phi_1247_: vec3<f32>;
    var phi_1248_: vec3<f32>;
    var phi_1279_: vec3<f32>;
    var phi_1280_: vec3<f32>;
    var phi_1298_: bool;
    var phi_1299_: bool;
    var phi_1303_: f32;
    var phi_1304_: f32;
    var phi_1305_: f32;
    var phi_1306_: f32;
    var phi_1314_: f32;
    var phi_1324_: bool;
    var phi_1325_: bool;
    var phi_1329_: f32;
    var phi_1330_: f32;
    var phi_1331_: f32;
    var phi_1332_: f32;
    var phi_1340_: f32;
    var phi_1350_: bool;
    var phi_1351_: bool;
    var phi_1355_: f32;
    var phi_1356_: f32;
    var phi_1357_: f32;
    var phi_1358_: f32;
    var phi_1366_: f32;
    var phi_1381_: f32;
    var phi_1382_: bool;
    var phi_1383_: f32;
    var phi_1384_: bool;
    var phi_1385_: f32;
    var phi_1386_: bool;
    var phi_1404_: f32;
    var phi_1405_: bool;
    var phi_1406_: bool;
    var phi_1407_: f32;
    var phi_1408_: bool;
    var phi_1409_: bool;
    var phi_1413_: bool;
    var phi_1414_: f32;
    var phi_1415_: bool;
    var phi_1445_: vec3<f32>;
    var phi_1446_: vec3<f32>;
    var phi_1471_: vec3<f32>;
    var phi_1472_: vec3<f32>;
    var phi_1497_: vec3<f32>;
    var phi_1498_: vec3<f32>;
    var phi_1556_: f32;
    var phi_1565_: f32;
    var phi_1574_: f32;
    var phi_1583_: f32;
    var phi_1590_: f32;
    var phi_1597_: f32;
    var phi_1610_: f32;
    var phi_1619_: f32;
    var phi_1628_: f32;
    var phi_1637_: f32;
    var phi_1644_: f32;
    var phi_1651_: f32;
    var phi_1674_: f32;
    var phi_1679_: f32;
    var phi_1684_: f32;
    var phi_1692_: f32;
    var phi_1697_: f32;
    var phi_1702_: f32;
    var phi_1714_: f32;
    var phi_1719_: f32;
    var phi_1724_: f32;
    var phi_1729_: f32;
    var phi_1734_: lt_bvh_triangle_Intersection;
    var phi_1735_: bool;
    var phi_1736_: lt_bvh_triangle_Intersection;
    var phi_1737_: bool;
    var phi_1741_: lt_bvh_triangle_Intersection;
    var phi_1742_: bool;
    var phi_1743_: lt_bvh_triangle_Intersection;
    var phi_1744_: bool;
    var phi_1745_: bool;
    var phi_1749_: bool;
    var phi_1753_: lt_bvh_triangle_Intersection;
    var phi_1792_: bool;
    var phi_1793_: bool;
    var phi_1794_: bool;
    var phi_1795_: bool;
    var phi_1796_: bool;
    var phi_1797_: bool;
    var phi_1801_: bool;
    var phi_1802_: bool;
    var phi_1816_: bool;
    var phi_1824_: lt_bvh_Hit;
    var phi_1825_: lt_bvh_Hit;
    var phi_1826_: lt_bvh_Hit;
    var phi_1827_: lt_bvh_Hit;
    var phi_1167_: lt_bvh_Hit;
    var phi_1170_: u32;
    var phi_1828_: bool;
    var phi_1867_: bool;
    var phi_1868_: bool;
    var phi_1899_: u32;
    var phi_830_: lt_bvh_Hit;
    var phi_833_: u32;
    var phi_1900_: lt_bvh_Hit;
    var phi_1901_: lt_bvh_Hit;
    var phi_1902_: bool;
    var phi_1906_: lt_bvh_Hit;
    var phi_1971_: f32;
    var phi_1976_: f32;
    var phi_1981_: f32;
    var phi_1992_: f32;
    var phi_1997_: f32;
    var phi_2002_: f32;
    var phi_2078_: vec3<f32>;
    var phi_2199_: u32;
    var phi_2226_: f32;
    var phi_2233_: f32;
    var phi_2240_: f32;
    var phi_2275_: f32;
    var phi_2282_: f32;
    var phi_2289_: f32;
    var phi_2327_: f32;
    var phi_2334_: f32;
    var phi_2341_: f32;
    var phi_2400_: vec3<f32>;
    var phi_2401_: vec3<f32>;
    var phi_2402_: vec3<f32>;
    var phi_2411_: f32;
    var phi_2412_: f32;
    var phi_2422_: f32;
    var phi_2423_: f32;
    var phi_2433_: f32;
    var phi_2434_: f32;
    var phi_2469_: abi_Sample;
    var phi_2560_: vec3<f32>;
    var local_4: lt_bvh_Hit;
    var local_5: lt_bvh_Hit;

    let _e64 = id_1;
    let _e68 = arrayLength((&nodes.member));
    let _e71 = arrayLength((&triangles.member));
    let _e74 = arrayLength((&vertices.member));
    let _e83 = arrayLength((&before.member));
    let _e89 = p.member.size[0u];
    let _e91 = p.member.size[1u];
    let _e92 = lt_shaders_entry_pixel_index(_e64, _e89, _e91);
    if (bitcast<i32>(_e92.root) != 0i) {
        let _e100 = p.member.eye;
        let _e103 = p.member.grid[0u];
        let _e105 = p.member.grid[1u];
        let _e124 = p.member.size[0u];
        let _e128 = ((((f32(_e64.x) + ((f32((_e64.y & (_e105 - 1u))) + 0.5f) / f32(_e105))) / f32(_e124)) * 2f) - 1f);
        let _e131 = p.member.size[1u];
        let _e135 = (1f - (((f32(_e64.y) + ((f32((_e64.x & (_e103 - 1u))) + 0.5f) / f32(_e103))) / f32(_e131)) * 2f));
        let _e137 = p.member.forward;
        let _e139 = p.member.right;
        let _e153 = p.member.up;
        let _e164 = _lt_bvh_ray_Ray_new(_e100, vec3<f32>(((_e137.x + (_e139.x * _e128)) + (_e153.x * _e135)), ((_e137.y + (_e139.y * _e128)) + (_e153.y * _e135)), ((_e137.z + (_e139.z * _e128)) + (_e153.z * _e135))));
        let _e166 = lt_bvh_Hit(_e164.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e169 = abs(_e164.direction.x);
        let _e171 = abs(_e164.direction.y);
        let _e173 = abs(_e164.direction.z);
        if (abs(_e164.origin.x) < 1000000000000000f) {
            if (abs(_e164.origin.y) < 1000000000000000f) {
                phi_389_ = (abs(_e164.origin.z) < 1000000000000000f);
                phi_390_ = false;
            } else {
                phi_389_ = bool();
                phi_390_ = true;
            }
            let _e185 = phi_389_;
            let _e187 = phi_390_;
            phi_391_ = _e185;
            phi_392_ = _e187;
        } else {
            phi_391_ = bool();
            phi_392_ = true;
        }
        let _e189 = phi_391_;
        let _e191 = phi_392_;
        if _e191 {
            phi_396_ = false;
        } else {
            phi_396_ = _e189;
        }
        let _e193 = phi_396_;
        if _e193 {
            if (_e169 < 1000000000000000f) {
                if (_e171 < 1000000000000000f) {
                    phi_409_ = (_e173 < 1000000000000000f);
                    phi_410_ = false;
                } else {
                    phi_409_ = bool();
                    phi_410_ = true;
                }
                let _e198 = phi_409_;
                let _e200 = phi_410_;
                phi_411_ = _e198;
                phi_412_ = _e200;
            } else {
                phi_411_ = bool();
                phi_412_ = true;
            }
            let _e202 = phi_411_;
            let _e204 = phi_412_;
            if _e204 {
                phi_416_ = false;
            } else {
                phi_416_ = _e202;
            }
            let _e206 = phi_416_;
            if _e206 {
                if (_e169 > 0f) {
                    phi_430_ = bool();
                    phi_431_ = true;
                } else {
                    let _e208 = (_e171 > 0f);
                    if _e208 {
                        phi_429_ = bool();
                    } else {
                        phi_429_ = (_e173 > 0f);
                    }
                    let _e211 = phi_429_;
                    phi_430_ = _e211;
                    phi_431_ = _e208;
                }
                let _e213 = phi_430_;
                let _e215 = phi_431_;
                if _e215 {
                    phi_435_ = true;
                } else {
                    phi_435_ = _e213;
                }
                let _e217 = phi_435_;
                phi_436_ = _e217;
                phi_437_ = false;
            } else {
                phi_436_ = bool();
                phi_437_ = true;
            }
            let _e219 = phi_436_;
            let _e221 = phi_437_;
            phi_438_ = _e219;
            phi_439_ = _e221;
        } else {
            phi_438_ = bool();
            phi_439_ = true;
        }
        let _e223 = phi_438_;
        let _e225 = phi_439_;
        if _e225 {
            phi_443_ = false;
        } else {
            phi_443_ = _e223;
        }
        let _e227 = phi_443_;
        if _e227 {
            let _e228 = (0u >= _e68);
            if _e228 {
                phi_1900_ = lt_bvh_Hit();
            } else {
                if (0u < _e68) {
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
                let _e297 = core_intrinsics_maximum_number_nsz_f32_(abs(_e164.direction.x), abs(_e164.direction.y));
                let _e298 = core_intrinsics_maximum_number_nsz_f32_(_e297, abs(_e164.direction.z));
                let _e299 = (_e298 * 0.0000000000009094947f);
                if (abs(_e164.direction.x) < _e299) {
                    phi_519_ = _e299;
                } else {
                    phi_519_ = abs(_e164.direction.x);
                }
                let _e305 = phi_519_;
                if (_e164.direction.x < 0f) {
                    phi_526_ = (-1f / _e305);
                } else {
                    phi_526_ = (1f / _e305);
                }
                let _e310 = phi_526_;
                if (abs(_e164.direction.y) < _e299) {
                    phi_534_ = _e299;
                } else {
                    phi_534_ = abs(_e164.direction.y);
                }
                let _e316 = phi_534_;
                if (_e164.direction.y < 0f) {
                    phi_541_ = (-1f / _e316);
                } else {
                    phi_541_ = (1f / _e316);
                }
                let _e321 = phi_541_;
                if (abs(_e164.direction.z) < _e299) {
                    phi_549_ = _e299;
                } else {
                    phi_549_ = abs(_e164.direction.z);
                }
                let _e327 = phi_549_;
                if (_e164.direction.z < 0f) {
                    phi_556_ = (-1f / _e327);
                } else {
                    phi_556_ = (1f / _e327);
                }
                let _e332 = phi_556_;
                let _e339 = abs((bitcast<f32>(_e234) - _e164.origin.x));
                let _e340 = abs((bitcast<f32>(_e238) - _e164.origin.y));
                let _e341 = abs((bitcast<f32>(_e242) - _e164.origin.z));
                let _e348 = abs(((bitcast<f32>(_e246) + (bitcast<f32>((((_e258 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e164.origin.x));
                let _e349 = abs(((bitcast<f32>(_e250) + (bitcast<f32>((((_e258 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e164.origin.y));
                let _e350 = abs(((bitcast<f32>(_e254) + (bitcast<f32>((((_e258 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e164.origin.z));
                if (_e339 > _e348) {
                    phi_579_ = _e339;
                } else {
                    phi_579_ = _e348;
                }
                let _e353 = phi_579_;
                if (_e340 > _e349) {
                    phi_584_ = _e340;
                } else {
                    phi_584_ = _e349;
                }
                let _e356 = phi_584_;
                if (_e341 > _e350) {
                    phi_589_ = _e341;
                } else {
                    phi_589_ = _e350;
                }
                let _e359 = phi_589_;
                if (_e353 > _e356) {
                    phi_594_ = _e353;
                } else {
                    phi_594_ = _e356;
                }
                let _e362 = phi_594_;
                if (_e362 > _e359) {
                    phi_599_ = _e362;
                } else {
                    phi_599_ = _e359;
                }
                let _e365 = phi_599_;
                let _e369 = (_e365 * 0.0000019073486f);
                let _e370 = (abs(_e310) * _e369);
                let _e371 = (abs(_e321) * _e369);
                let _e372 = (abs(_e332) * _e369);
                let _e376 = (_e365 * 0.0000009536743f);
                let _e377 = (abs(_e310) * _e376);
                let _e378 = (abs(_e321) * _e376);
                let _e379 = (abs(_e332) * _e376);
                let _e383 = abs(_e164.direction.x);
                let _e385 = abs(_e164.direction.y);
                let _e387 = abs(_e164.direction.z);
                if (_e383 >= _e385) {
                    if (_e383 >= _e387) {
                        phi_630_ = false;
                    } else {
                        phi_630_ = true;
                    }
                    let _e391 = phi_630_;
                    phi_631_ = _e391;
                } else {
                    phi_631_ = true;
                }
                let _e393 = phi_631_;
                if _e393 {
                    if (_e385 >= _e387) {
                        phi_639_ = 1u;
                    } else {
                        phi_639_ = 2u;
                    }
                    let _e396 = phi_639_;
                    phi_640_ = _e396;
                } else {
                    phi_640_ = 0u;
                }
                let _e398 = phi_640_;
                if (_e398 == 0u) {
                    phi_658_ = vec3<f32>(_e164.direction.y, _e164.direction.z, _e164.direction.x);
                } else {
                    if (_e398 == 1u) {
                        phi_657_ = vec3<f32>(_e164.direction.z, _e164.direction.x, _e164.direction.y);
                    } else {
                        phi_657_ = _e164.direction;
                    }
                    let _e410 = phi_657_;
                    phi_658_ = _e410;
                }
                let _e412 = phi_658_;
                let _e415 = (_e412.x / _e412.z);
                let _e418 = (_e412.y / _e412.z);
                if (_e310 < 0f) {
                    phi_671_ = 0u;
                } else {
                    phi_671_ = 1u;
                }
                let _e423 = phi_671_;
                if (_e321 < 0f) {
                    phi_676_ = 0u;
                } else {
                    phi_676_ = 2u;
                }
                let _e426 = phi_676_;
                if (_e332 < 0f) {
                    phi_681_ = 0u;
                } else {
                    phi_681_ = 4u;
                }
                let _e429 = phi_681_;
                let _e431 = ((_e423 | _e426) | _e429);
                let _e432 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local = lt_bvh_traverse_Stack(array<u32, 32>(_e432.first[0], _e432.first[1], _e432.first[2], _e432.first[3], _e432.first[4], _e432.first[5], _e432.first[6], _e432.first[7], _e432.first[8], _e432.first[9], _e432.first[10], _e432.first[11], _e432.first[12], _e432.first[13], _e432.first[14], _e432.first[15], _e432.first[16], _e432.first[17], _e432.first[18], _e432.first[19], _e432.first[20], _e432.first[21], _e432.first[22], _e432.first[23], _e432.first[24], _e432.first[25], _e432.first[26], _e432.first[27], _e432.first[28], _e432.first[29], _e432.first[30], _e432.first[31]), array<u32, 32>(_e432.mask[0], _e432.mask[1], _e432.mask[2], _e432.mask[3], _e432.mask[4], _e432.mask[5], _e432.mask[6], _e432.mask[7], _e432.mask[8], _e432.mask[9], _e432.mask[10], _e432.mask[11], _e432.mask[12], _e432.mask[13], _e432.mask[14], _e432.mask[15], _e432.mask[16], _e432.mask[17], _e432.mask[18], _e432.mask[19], _e432.mask[20], _e432.mask[21], _e432.mask[22], _e432.mask[23], _e432.mask[24], _e432.mask[25], _e432.mask[26], _e432.mask[27], _e432.mask[28], _e432.mask[29], _e432.mask[30], _e432.mask[31]), _e432.len, _e432.group, _e432.group_mask);
                let _e506 = local.group_mask;
                if ((_e506 & 4278190080u) == 0u) {
                    let _e510 = local.len;
                    if (_e510 == 0u) {
                        phi_795_ = false;
                    } else {
                        let _e514 = local.len;
                        local.len = (_e514 - 1u);
                        let _e517 = local.len;
                        if (_e517 < 32u) {
                        } else {
                            return;
                        }
                        let _e522 = local.first[(0u + _e517)];
                        local.group = _e522;
                        let _e525 = local.len;
                        if (_e525 < 32u) {
                        } else {
                            return;
                        }
                        let _e530 = local.mask[(0u + _e525)];
                        local.group_mask = _e530;
                        phi_795_ = true;
                    }
                    let _e533 = phi_795_;
                    phi_796_ = _e533;
                } else {
                    phi_796_ = true;
                }
                let _e535 = phi_796_;
                if _e535 {
                    let _e537 = local.group_mask;
                    let _e543 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e537)), 32u, (_e537 == 0u)));
                    let _e547 = local.group_mask;
                    let _e561 = local.group_mask;
                    local.group_mask = (_e561 & ~((1u << bitcast<u32>((_e543 & 31u)))));
                    let _e564 = local.group;
                    phi_827_ = (_e564 + countOneBits(((_e547 & ~((4294967295u << bitcast<u32>((((_e543 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_827_ = 4294967295u;
                }
                let _e567 = phi_827_;
                phi_829_ = _e166;
                phi_832_ = _e567;
                loop {
                    let _e569 = phi_829_;
                    let _e571 = phi_832_;
                    local_5 = _e569;
                    let _e572 = (_e571 != 4294967295u);
                    if _e572 {
                        if (_e571 < _e68) {
                        } else {
                            return;
                        }
                        let _e580 = nodes.member[(0u + _e571)].frame[3u];
                        let _e605 = (bitcast<f32>((((_e580 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e310);
                        let _e606 = (bitcast<f32>((((_e580 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e321);
                        let _e607 = (bitcast<f32>((((_e580 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e332);
                        let _e610 = nodes.member[(0u + _e571)].frame[0u];
                        let _e614 = nodes.member[(0u + _e571)].frame[1u];
                        let _e618 = nodes.member[(0u + _e571)].frame[2u];
                        let _e626 = ((bitcast<f32>(_e610) - _e164.origin.x) * _e310);
                        let _e627 = ((bitcast<f32>(_e614) - _e164.origin.y) * _e321);
                        let _e628 = ((bitcast<f32>(_e618) - _e164.origin.z) * _e332);
                        let _e636 = nodes.member[(0u + _e571)].x;
                        if (_e310 < 0f) {
                            let _e647 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e636.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e653 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e647.unnamed.root, _e636.w), _e647.unnamed_1);
                            let _e659 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e653.unnamed, lt_bvh_traverse_Tree(_e636.x, _e653.unnamed_1.first_primitive));
                            phi_917_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e659.unnamed, lt_bvh_traverse_Tree(_e659.unnamed_1.root, _e636.y));
                        } else {
                            let _e675 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e636.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e681 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e675.unnamed.root, _e636.y), _e675.unnamed_1);
                            let _e687 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e681.unnamed, lt_bvh_traverse_Tree(_e636.z, _e681.unnamed_1.first_primitive));
                            phi_917_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e687.unnamed, lt_bvh_traverse_Tree(_e687.unnamed_1.root, _e636.w));
                        }
                        let _e695 = phi_917_;
                        let _e705 = nodes.member[(0u + _e571)].y;
                        if (_e321 < 0f) {
                            let _e716 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e705.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e722 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e716.unnamed.root, _e705.w), _e716.unnamed_1);
                            let _e728 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e722.unnamed, lt_bvh_traverse_Tree(_e705.x, _e722.unnamed_1.first_primitive));
                            phi_944_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e728.unnamed, lt_bvh_traverse_Tree(_e728.unnamed_1.root, _e705.y));
                        } else {
                            let _e744 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e705.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e750 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e744.unnamed.root, _e705.y), _e744.unnamed_1);
                            let _e756 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e750.unnamed, lt_bvh_traverse_Tree(_e705.z, _e750.unnamed_1.first_primitive));
                            phi_944_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e756.unnamed, lt_bvh_traverse_Tree(_e756.unnamed_1.root, _e705.w));
                        }
                        let _e764 = phi_944_;
                        let _e774 = nodes.member[(0u + _e571)].z;
                        if (_e332 < 0f) {
                            let _e785 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e774.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e791 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e785.unnamed.root, _e774.w), _e785.unnamed_1);
                            let _e797 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e791.unnamed, lt_bvh_traverse_Tree(_e774.x, _e791.unnamed_1.first_primitive));
                            phi_971_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e797.unnamed, lt_bvh_traverse_Tree(_e797.unnamed_1.root, _e774.y));
                        } else {
                            let _e813 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e774.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e819 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e813.unnamed.root, _e774.y), _e813.unnamed_1);
                            let _e825 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e819.unnamed, lt_bvh_traverse_Tree(_e774.z, _e819.unnamed_1.first_primitive));
                            phi_971_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e825.unnamed, lt_bvh_traverse_Tree(_e825.unnamed_1.root, _e774.w));
                        }
                        let _e833 = phi_971_;
                        phi_977_ = 0u;
                        phi_980_ = 0u;
                        loop {
                            let _e843 = phi_977_;
                            let _e845 = phi_980_;
                            local_1 = _e845;
                            local_2 = _e845;
                            local_3 = _e845;
                            let _e846 = (_e843 < 8u);
                            if _e846 {
                                let _e848 = (_e843 >> bitcast<u32>(2i));
                                let _e849 = (_e843 & 3u);
                                if (_e848 == 0u) {
                                    phi_994_ = _e695.unnamed.root;
                                } else {
                                    phi_994_ = _e695.unnamed.first_primitive;
                                }
                                let _e852 = phi_994_;
                                if (_e848 == 0u) {
                                    phi_1004_ = _e764.unnamed.root;
                                } else {
                                    phi_1004_ = _e764.unnamed.first_primitive;
                                }
                                let _e861 = phi_1004_;
                                if (_e848 == 0u) {
                                    phi_1014_ = _e833.unnamed.root;
                                } else {
                                    phi_1014_ = _e833.unnamed.first_primitive;
                                }
                                let _e870 = phi_1014_;
                                let _e883 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e852 >> bitcast<u32>(((_e849 * 8u) & 31u))) & 255u)) * _e605) + (_e626 - _e370)), ((f32(((_e861 >> bitcast<u32>(((_e849 * 8u) & 31u))) & 255u)) * _e606) + (_e627 - _e371)));
                                let _e884 = core_intrinsics_maximum_number_nsz_f32_(_e883, ((f32(((_e870 >> bitcast<u32>(((_e849 * 8u) & 31u))) & 255u)) * _e607) + (_e628 - _e372)));
                                if (_e848 == 0u) {
                                    phi_1032_ = _e695.unnamed_1.root;
                                } else {
                                    phi_1032_ = _e695.unnamed_1.first_primitive;
                                }
                                let _e887 = phi_1032_;
                                if (_e848 == 0u) {
                                    phi_1042_ = _e764.unnamed_1.root;
                                } else {
                                    phi_1042_ = _e764.unnamed_1.first_primitive;
                                }
                                let _e896 = phi_1042_;
                                if (_e848 == 0u) {
                                    phi_1052_ = _e833.unnamed_1.root;
                                } else {
                                    phi_1052_ = _e833.unnamed_1.first_primitive;
                                }
                                let _e905 = phi_1052_;
                                let _e918 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e887 >> bitcast<u32>(((_e849 * 8u) & 31u))) & 255u)) * _e605) + (_e626 + _e370)), ((f32(((_e896 >> bitcast<u32>(((_e849 * 8u) & 31u))) & 255u)) * _e606) + (_e627 + _e371)));
                                let _e919 = core_intrinsics_minimum_number_nsz_f32_(_e918, ((f32(((_e905 >> bitcast<u32>(((_e849 * 8u) & 31u))) & 255u)) * _e607) + (_e628 + _e372)));
                                if (_e884 <= _e919) {
                                    if (_e884 <= _e569.t) {
                                        if (_e919 >= _e164.tmin) {
                                            if (_e848 == 0u) {
                                                let _e926 = nodes.member[(0u + _e571)].links[2u];
                                                phi_1088_ = _e926;
                                            } else {
                                                let _e929 = nodes.member[(0u + _e571)].links[3u];
                                                phi_1088_ = _e929;
                                            }
                                            let _e931 = phi_1088_;
                                            let _e936 = ((_e931 >> bitcast<u32>(((_e849 * 8u) & 31u))) & 255u);
                                            let _e937 = (_e936 & 31u);
                                            if (_e937 >= 24u) {
                                                phi_1101_ = (24u + ((_e937 - 24u) ^ _e431));
                                            } else {
                                                phi_1101_ = _e937;
                                            }
                                            let _e943 = phi_1101_;
                                            phi_1106_ = (_e845 | ((_e936 >> bitcast<u32>(5i)) << bitcast<u32>((_e943 & 31u))));
                                        } else {
                                            phi_1106_ = _e845;
                                        }
                                        let _e951 = phi_1106_;
                                        phi_1107_ = _e951;
                                    } else {
                                        phi_1107_ = _e845;
                                    }
                                    let _e953 = phi_1107_;
                                    phi_1108_ = _e953;
                                } else {
                                    phi_1108_ = _e845;
                                }
                                let _e955 = phi_1108_;
                                phi_978_ = (_e843 + 1u);
                                phi_981_ = _e955;
                            } else {
                                phi_978_ = u32();
                                phi_981_ = u32();
                            }
                            let _e958 = phi_978_;
                            let _e960 = phi_981_;
                            continue;
                            continuing {
                                phi_977_ = _e958;
                                phi_980_ = _e960;
                                break if !(_e846);
                            }
                        }
                        let _e964 = nodes.member[(0u + _e571)].links[0u];
                        let _e968 = nodes.member[(0u + _e571)].frame[3u];
                        let _e972 = local_1;
                        if ((_e972 & 4278190080u) == 0u) {
                        } else {
                            let _e976 = local.group_mask;
                            if ((_e976 & 4278190080u) == 0u) {
                            } else {
                                let _e980 = local.len;
                                if (_e980 < 32u) {
                                    let _e983 = local.group;
                                    let _e985 = local.len;
                                    if (_e985 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.first[(0u + _e985)] = _e983;
                                    let _e991 = local.group_mask;
                                    let _e993 = local.len;
                                    if (_e993 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.mask[(0u + _e993)] = _e991;
                                    let _e1000 = local.len;
                                    local.len = (_e1000 + 1u);
                                }
                            }
                            local.group = (0u + _e964);
                            let _e1004 = local_2;
                            local.group_mask = ((_e1004 & 4278190080u) | (_e968 >> bitcast<u32>(24i)));
                        }
                        let _e1009 = local_3;
                        phi_1166_ = _e569;
                        phi_1169_ = (_e1009 & 16777215u);
                        loop {
                            let _e1012 = phi_1166_;
                            let _e1014 = phi_1169_;
                            local_4 = _e1012;
                            if (_e1014 == 0u) {
                                phi_1167_ = lt_bvh_Hit();
                                phi_1170_ = u32();
                                phi_1828_ = false;
                            } else {
                                let _e1018 = nodes.member[(0u + _e571)].links[1u];
                                let _e1023 = ((0u + _e1018) + select(firstTrailingBit(_e1014), 32u, (_e1014 == 0u)));
                                if (_e1023 < _e71) {
                                } else {
                                    return;
                                }
                                let _e1030 = triangles.member[(0u + _e1023)].v0_;
                                let _e1033 = (_e1030.x - _e164.origin.x);
                                let _e1036 = (_e1030.y - _e164.origin.y);
                                let _e1039 = (_e1030.z - _e164.origin.z);
                                if (_e398 == 0u) {
                                    phi_1216_ = vec3<f32>(_e1036, _e1039, _e1033);
                                } else {
                                    if (_e398 == 1u) {
                                        phi_1215_ = vec3<f32>(_e1039, _e1033, _e1036);
                                    } else {
                                        phi_1215_ = (_e1030 - _e164.origin);
                                    }
                                    let _e1046 = phi_1215_;
                                    phi_1216_ = _e1046;
                                }
                                let _e1048 = phi_1216_;
                                let _e1052 = (_e1048.x - (_e415 * _e1048.z));
                                let _e1056 = (_e1048.y - (_e418 * _e1048.z));
                                let _e1058 = triangles.member[(0u + _e1023)].v1_;
                                let _e1061 = (_e1058.x - _e164.origin.x);
                                let _e1064 = (_e1058.y - _e164.origin.y);
                                let _e1067 = (_e1058.z - _e164.origin.z);
                                if (_e398 == 0u) {
                                    phi_1248_ = vec3<f32>(_e1064, _e1067, _e1061);
                                } else {
                                    if (_e398 == 1u) {
                                        phi_1247_ = vec3<f32>(_e1067, _e1061, _e1064);
                                    } else {
                                        phi_1247_ = (_e1058 - _e164.origin);
                                    }
                                    let _e1074 = phi_1247_;
                                    phi_1248_ = _e1074;
                                }
                                let _e1076 = phi_1248_;
                                let _e1080 = (_e1076.x - (_e415 * _e1076.z));
                                let _e1084 = (_e1076.y - (_e418 * _e1076.z));
                                let _e1086 = triangles.member[(0u + _e1023)].v2_;
                                let _e1089 = (_e1086.x - _e164.origin.x);
                                let _e1092 = (_e1086.y - _e164.origin.y);
                                let _e1095 = (_e1086.z - _e164.origin.z);
                                if (_e398 == 0u) {
                                    phi_1280_ = vec3<f32>(_e1092, _e1095, _e1089);
                                } else {
                                    if (_e398 == 1u) {
                                        phi_1279_ = vec3<f32>(_e1095, _e1089, _e1092);
                                    } else {
                                        phi_1279_ = (_e1086 - _e164.origin);
                                    }
                                    let _e1102 = phi_1279_;
                                    phi_1280_ = _e1102;
                                }
                                let _e1104 = phi_1280_;
                                let _e1108 = (_e1104.x - (_e415 * _e1104.z));
                                let _e1112 = (_e1104.y - (_e418 * _e1104.z));
                                if (_e1080 < _e1108) {
                                    phi_1299_ = true;
                                } else {
                                    if (_e1080 == _e1108) {
                                        phi_1298_ = (_e1084 < _e1112);
                                    } else {
                                        phi_1298_ = false;
                                    }
                                    let _e1117 = phi_1298_;
                                    phi_1299_ = _e1117;
                                }
                                let _e1119 = phi_1299_;
                                if _e1119 {
                                    phi_1303_ = _e1112;
                                    phi_1304_ = _e1108;
                                    phi_1305_ = _e1084;
                                    phi_1306_ = _e1080;
                                } else {
                                    phi_1303_ = _e1084;
                                    phi_1304_ = _e1080;
                                    phi_1305_ = _e1112;
                                    phi_1306_ = _e1108;
                                }
                                let _e1121 = phi_1303_;
                                let _e1123 = phi_1304_;
                                let _e1125 = phi_1305_;
                                let _e1127 = phi_1306_;
                                let _e1130 = ((_e1127 * _e1121) - (_e1125 * _e1123));
                                if _e1119 {
                                    phi_1314_ = -(_e1130);
                                } else {
                                    phi_1314_ = _e1130;
                                }
                                let _e1133 = phi_1314_;
                                if (_e1108 < _e1052) {
                                    phi_1325_ = true;
                                } else {
                                    if (_e1108 == _e1052) {
                                        phi_1324_ = (_e1112 < _e1056);
                                    } else {
                                        phi_1324_ = false;
                                    }
                                    let _e1138 = phi_1324_;
                                    phi_1325_ = _e1138;
                                }
                                let _e1140 = phi_1325_;
                                if _e1140 {
                                    phi_1329_ = _e1056;
                                    phi_1330_ = _e1052;
                                    phi_1331_ = _e1112;
                                    phi_1332_ = _e1108;
                                } else {
                                    phi_1329_ = _e1112;
                                    phi_1330_ = _e1108;
                                    phi_1331_ = _e1056;
                                    phi_1332_ = _e1052;
                                }
                                let _e1142 = phi_1329_;
                                let _e1144 = phi_1330_;
                                let _e1146 = phi_1331_;
                                let _e1148 = phi_1332_;
                                let _e1151 = ((_e1148 * _e1142) - (_e1146 * _e1144));
                                if _e1140 {
                                    phi_1340_ = -(_e1151);
                                } else {
                                    phi_1340_ = _e1151;
                                }
                                let _e1154 = phi_1340_;
                                if (_e1052 < _e1080) {
                                    phi_1351_ = true;
                                } else {
                                    if (_e1052 == _e1080) {
                                        phi_1350_ = (_e1056 < _e1084);
                                    } else {
                                        phi_1350_ = false;
                                    }
                                    let _e1159 = phi_1350_;
                                    phi_1351_ = _e1159;
                                }
                                let _e1161 = phi_1351_;
                                if _e1161 {
                                    phi_1355_ = _e1084;
                                    phi_1356_ = _e1080;
                                    phi_1357_ = _e1056;
                                    phi_1358_ = _e1052;
                                } else {
                                    phi_1355_ = _e1056;
                                    phi_1356_ = _e1052;
                                    phi_1357_ = _e1084;
                                    phi_1358_ = _e1080;
                                }
                                let _e1163 = phi_1355_;
                                let _e1165 = phi_1356_;
                                let _e1167 = phi_1357_;
                                let _e1169 = phi_1358_;
                                let _e1172 = ((_e1169 * _e1163) - (_e1167 * _e1165));
                                if _e1161 {
                                    phi_1366_ = -(_e1172);
                                } else {
                                    phi_1366_ = _e1172;
                                }
                                let _e1175 = phi_1366_;
                                if (_e1133 >= 0f) {
                                    if (_e1154 >= 0f) {
                                        if (_e1175 >= 0f) {
                                            phi_1381_ = ((_e1133 + _e1154) + _e1175);
                                            phi_1382_ = false;
                                        } else {
                                            phi_1381_ = f32();
                                            phi_1382_ = true;
                                        }
                                        let _e1182 = phi_1381_;
                                        let _e1184 = phi_1382_;
                                        phi_1383_ = _e1182;
                                        phi_1384_ = _e1184;
                                    } else {
                                        phi_1383_ = f32();
                                        phi_1384_ = true;
                                    }
                                    let _e1186 = phi_1383_;
                                    let _e1188 = phi_1384_;
                                    phi_1385_ = _e1186;
                                    phi_1386_ = _e1188;
                                } else {
                                    phi_1385_ = f32();
                                    phi_1386_ = true;
                                }
                                let _e1190 = phi_1385_;
                                let _e1192 = phi_1386_;
                                if _e1192 {
                                    if (_e1133 <= 0f) {
                                        if (_e1154 <= 0f) {
                                            let _e1195 = (_e1175 <= 0f);
                                            if _e1195 {
                                            }
                                            phi_1404_ = ((_e1133 + _e1154) + _e1175);
                                            phi_1405_ = false;
                                            phi_1406_ = _e1195;
                                        } else {
                                            phi_1404_ = f32();
                                            phi_1405_ = true;
                                            phi_1406_ = false;
                                        }
                                        let _e1199 = phi_1404_;
                                        let _e1201 = phi_1405_;
                                        let _e1203 = phi_1406_;
                                        phi_1407_ = _e1199;
                                        phi_1408_ = _e1201;
                                        phi_1409_ = _e1203;
                                    } else {
                                        phi_1407_ = f32();
                                        phi_1408_ = true;
                                        phi_1409_ = false;
                                    }
                                    let _e1205 = phi_1407_;
                                    let _e1207 = phi_1408_;
                                    let _e1209 = phi_1409_;
                                    if _e1207 {
                                        phi_1413_ = false;
                                    } else {
                                        phi_1413_ = _e1209;
                                    }
                                    let _e1211 = phi_1413_;
                                    phi_1414_ = _e1205;
                                    phi_1415_ = _e1211;
                                } else {
                                    phi_1414_ = _e1190;
                                    phi_1415_ = true;
                                }
                                let _e1213 = phi_1414_;
                                let _e1215 = phi_1415_;
                                if _e1215 {
                                    let _e1216 = (_e1213 == 0f);
                                    if _e1216 {
                                        phi_1741_ = lt_bvh_triangle_Intersection();
                                        phi_1742_ = false;
                                    } else {
                                        let _e1218 = triangles.member[(0u + _e1023)].v0_;
                                        let _e1221 = (_e1218.x - _e164.origin.x);
                                        let _e1224 = (_e1218.y - _e164.origin.y);
                                        let _e1227 = (_e1218.z - _e164.origin.z);
                                        if (_e398 == 0u) {
                                            phi_1446_ = vec3<f32>(_e1224, _e1227, _e1221);
                                        } else {
                                            if (_e398 == 1u) {
                                                phi_1445_ = vec3<f32>(_e1227, _e1221, _e1224);
                                            } else {
                                                phi_1445_ = (_e1218 - _e164.origin);
                                            }
                                            let _e1234 = phi_1445_;
                                            phi_1446_ = _e1234;
                                        }
                                        let _e1236 = phi_1446_;
                                        let _e1238 = triangles.member[(0u + _e1023)].v1_;
                                        let _e1240 = triangles.member[(0u + _e1023)].v0_;
                                        let _e1243 = (_e1238.x - _e1240.x);
                                        let _e1246 = (_e1238.y - _e1240.y);
                                        let _e1249 = (_e1238.z - _e1240.z);
                                        if (_e398 == 0u) {
                                            phi_1472_ = vec3<f32>(_e1246, _e1249, _e1243);
                                        } else {
                                            if (_e398 == 1u) {
                                                phi_1471_ = vec3<f32>(_e1249, _e1243, _e1246);
                                            } else {
                                                phi_1471_ = (_e1238 - _e1240);
                                            }
                                            let _e1256 = phi_1471_;
                                            phi_1472_ = _e1256;
                                        }
                                        let _e1258 = phi_1472_;
                                        let _e1260 = triangles.member[(0u + _e1023)].v2_;
                                        let _e1262 = triangles.member[(0u + _e1023)].v0_;
                                        let _e1265 = (_e1260.x - _e1262.x);
                                        let _e1268 = (_e1260.y - _e1262.y);
                                        let _e1271 = (_e1260.z - _e1262.z);
                                        if (_e398 == 0u) {
                                            phi_1498_ = vec3<f32>(_e1268, _e1271, _e1265);
                                        } else {
                                            if (_e398 == 1u) {
                                                phi_1497_ = vec3<f32>(_e1271, _e1265, _e1268);
                                            } else {
                                                phi_1497_ = (_e1260 - _e1262);
                                            }
                                            let _e1278 = phi_1497_;
                                            phi_1498_ = _e1278;
                                        }
                                        let _e1280 = phi_1498_;
                                        let _e1287 = ((_e1258.y * _e1280.z) - (_e1258.z * _e1280.y));
                                        let _e1294 = ((_e1258.z * _e1280.x) - (_e1258.x * _e1280.z));
                                        let _e1301 = ((_e1258.x * _e1280.y) - (_e1258.y * _e1280.x));
                                        let _e1315 = (((1f / _e412.z) * (((_e1287 * _e1236.x) + (_e1294 * _e1236.y)) + (_e1301 * _e1236.z))) / (((_e1287 * _e415) + (_e1294 * _e418)) + _e1301));
                                        if (_e1315 > _e164.tmin) {
                                            if (_e1315 < _e164.tmax) {
                                                let _e1321 = triangles.member[(0u + _e1023)].v0_;
                                                let _e1323 = triangles.member[(0u + _e1023)].v1_;
                                                if (_e1321.x < _e1323.x) {
                                                    phi_1556_ = _e1321.x;
                                                } else {
                                                    phi_1556_ = _e1323.x;
                                                }
                                                let _e1330 = phi_1556_;
                                                if (_e1321.y < _e1323.y) {
                                                    phi_1565_ = _e1321.y;
                                                } else {
                                                    phi_1565_ = _e1323.y;
                                                }
                                                let _e1337 = phi_1565_;
                                                if (_e1321.z < _e1323.z) {
                                                    phi_1574_ = _e1321.z;
                                                } else {
                                                    phi_1574_ = _e1323.z;
                                                }
                                                let _e1344 = phi_1574_;
                                                let _e1346 = triangles.member[(0u + _e1023)].v2_;
                                                if (_e1330 < _e1346.x) {
                                                    phi_1583_ = _e1330;
                                                } else {
                                                    phi_1583_ = _e1346.x;
                                                }
                                                let _e1351 = phi_1583_;
                                                if (_e1337 < _e1346.y) {
                                                    phi_1590_ = _e1337;
                                                } else {
                                                    phi_1590_ = _e1346.y;
                                                }
                                                let _e1356 = phi_1590_;
                                                if (_e1344 < _e1346.z) {
                                                    phi_1597_ = _e1344;
                                                } else {
                                                    phi_1597_ = _e1346.z;
                                                }
                                                let _e1361 = phi_1597_;
                                                let _e1363 = triangles.member[(0u + _e1023)].v0_;
                                                let _e1365 = triangles.member[(0u + _e1023)].v1_;
                                                if (_e1363.x > _e1365.x) {
                                                    phi_1610_ = _e1363.x;
                                                } else {
                                                    phi_1610_ = _e1365.x;
                                                }
                                                let _e1372 = phi_1610_;
                                                if (_e1363.y > _e1365.y) {
                                                    phi_1619_ = _e1363.y;
                                                } else {
                                                    phi_1619_ = _e1365.y;
                                                }
                                                let _e1379 = phi_1619_;
                                                if (_e1363.z > _e1365.z) {
                                                    phi_1628_ = _e1363.z;
                                                } else {
                                                    phi_1628_ = _e1365.z;
                                                }
                                                let _e1386 = phi_1628_;
                                                let _e1388 = triangles.member[(0u + _e1023)].v2_;
                                                if (_e1372 > _e1388.x) {
                                                    phi_1637_ = _e1372;
                                                } else {
                                                    phi_1637_ = _e1388.x;
                                                }
                                                let _e1393 = phi_1637_;
                                                if (_e1379 > _e1388.y) {
                                                    phi_1644_ = _e1379;
                                                } else {
                                                    phi_1644_ = _e1388.y;
                                                }
                                                let _e1398 = phi_1644_;
                                                if (_e1386 > _e1388.z) {
                                                    phi_1651_ = _e1386;
                                                } else {
                                                    phi_1651_ = _e1388.z;
                                                }
                                                let _e1403 = phi_1651_;
                                                let _e1410 = ((_e1351 - _e164.origin.x) * _e310);
                                                let _e1411 = ((_e1356 - _e164.origin.y) * _e321);
                                                let _e1412 = ((_e1361 - _e164.origin.z) * _e332);
                                                let _e1419 = ((_e1393 - _e164.origin.x) * _e310);
                                                let _e1420 = ((_e1398 - _e164.origin.y) * _e321);
                                                let _e1421 = ((_e1403 - _e164.origin.z) * _e332);
                                                if (_e1410 < _e1419) {
                                                    phi_1674_ = _e1410;
                                                } else {
                                                    phi_1674_ = _e1419;
                                                }
                                                let _e1424 = phi_1674_;
                                                if (_e1411 < _e1420) {
                                                    phi_1679_ = _e1411;
                                                } else {
                                                    phi_1679_ = _e1420;
                                                }
                                                let _e1427 = phi_1679_;
                                                if (_e1412 < _e1421) {
                                                    phi_1684_ = _e1412;
                                                } else {
                                                    phi_1684_ = _e1421;
                                                }
                                                let _e1430 = phi_1684_;
                                                if (_e1410 > _e1419) {
                                                    phi_1692_ = _e1410;
                                                } else {
                                                    phi_1692_ = _e1419;
                                                }
                                                let _e1436 = phi_1692_;
                                                if (_e1411 > _e1420) {
                                                    phi_1697_ = _e1411;
                                                } else {
                                                    phi_1697_ = _e1420;
                                                }
                                                let _e1439 = phi_1697_;
                                                if (_e1412 > _e1421) {
                                                    phi_1702_ = _e1412;
                                                } else {
                                                    phi_1702_ = _e1421;
                                                }
                                                let _e1442 = phi_1702_;
                                                let _e1446 = core_intrinsics_maximum_number_nsz_f32_((_e1424 - _e377), (_e1427 - _e378));
                                                let _e1447 = core_intrinsics_maximum_number_nsz_f32_(_e1446, (_e1430 - _e379));
                                                let _e1448 = core_intrinsics_minimum_number_nsz_f32_((_e1436 + _e377), (_e1439 + _e378));
                                                let _e1449 = core_intrinsics_minimum_number_nsz_f32_(_e1448, (_e1442 + _e379));
                                                if (_e1447 > -300000000000000000000000000000000000000f) {
                                                    phi_1714_ = _e1447;
                                                } else {
                                                    phi_1714_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1452 = phi_1714_;
                                                if (_e1449 < 300000000000000000000000000000000000000f) {
                                                    phi_1719_ = _e1449;
                                                } else {
                                                    phi_1719_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1455 = phi_1719_;
                                                if (_e1315 < _e1452) {
                                                    phi_1724_ = _e1452;
                                                } else {
                                                    phi_1724_ = _e1315;
                                                }
                                                let _e1458 = phi_1724_;
                                                if (_e1458 > _e1455) {
                                                    phi_1729_ = _e1455;
                                                } else {
                                                    phi_1729_ = _e1458;
                                                }
                                                let _e1461 = phi_1729_;
                                                phi_1734_ = lt_bvh_triangle_Intersection(_e1461, (_e1154 / _e1213), (_e1175 / _e1213), (_e1452 <= _e1455));
                                                phi_1735_ = false;
                                            } else {
                                                phi_1734_ = lt_bvh_triangle_Intersection();
                                                phi_1735_ = true;
                                            }
                                            let _e1467 = phi_1734_;
                                            let _e1469 = phi_1735_;
                                            phi_1736_ = _e1467;
                                            phi_1737_ = _e1469;
                                        } else {
                                            phi_1736_ = lt_bvh_triangle_Intersection();
                                            phi_1737_ = true;
                                        }
                                        let _e1471 = phi_1736_;
                                        let _e1473 = phi_1737_;
                                        if _e1473 {
                                        }
                                        phi_1741_ = _e1471;
                                        phi_1742_ = _e1473;
                                    }
                                    let _e1475 = phi_1741_;
                                    let _e1477 = phi_1742_;
                                    phi_1743_ = _e1475;
                                    phi_1744_ = _e1216;
                                    phi_1745_ = _e1477;
                                } else {
                                    phi_1743_ = lt_bvh_triangle_Intersection();
                                    phi_1744_ = true;
                                    phi_1745_ = false;
                                }
                                let _e1479 = phi_1743_;
                                let _e1481 = phi_1744_;
                                let _e1483 = phi_1745_;
                                if _e1481 {
                                    phi_1749_ = true;
                                } else {
                                    phi_1749_ = _e1483;
                                }
                                let _e1485 = phi_1749_;
                                if _e1485 {
                                    phi_1753_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1753_ = _e1479;
                                }
                                let _e1487 = phi_1753_;
                                if _e1487.is_hit {
                                    if (_e1487.t > _e164.tmin) {
                                        if (_e1487.t < _e1012.t) {
                                            phi_1802_ = true;
                                        } else {
                                            if (_e1487.t == _e1012.t) {
                                                if (_e1012.triangle != 4294967295u) {
                                                    if (_e1023 < _e1012.triangle) {
                                                        phi_1793_ = true;
                                                    } else {
                                                        if (_e1023 == _e1012.triangle) {
                                                            phi_1792_ = (4294967295u < _e1012.instance);
                                                        } else {
                                                            phi_1792_ = false;
                                                        }
                                                        let _e1506 = phi_1792_;
                                                        phi_1793_ = _e1506;
                                                    }
                                                    let _e1508 = phi_1793_;
                                                    phi_1794_ = _e1508;
                                                    phi_1795_ = false;
                                                } else {
                                                    phi_1794_ = bool();
                                                    phi_1795_ = true;
                                                }
                                                let _e1510 = phi_1794_;
                                                let _e1512 = phi_1795_;
                                                phi_1796_ = _e1510;
                                                phi_1797_ = _e1512;
                                            } else {
                                                phi_1796_ = bool();
                                                phi_1797_ = true;
                                            }
                                            let _e1514 = phi_1796_;
                                            let _e1516 = phi_1797_;
                                            if _e1516 {
                                                phi_1801_ = false;
                                            } else {
                                                phi_1801_ = _e1514;
                                            }
                                            let _e1518 = phi_1801_;
                                            phi_1802_ = _e1518;
                                        }
                                        let _e1520 = phi_1802_;
                                        if _e1520 {
                                            let _e1522 = triangles.member[(0u + _e1023)].i0_;
                                            if ((_e1522 & 2147483648u) == 0u) {
                                                phi_1816_ = true;
                                            } else {
                                                if true {
                                                }
                                                phi_1816_ = true;
                                            }
                                            let _e1526 = phi_1816_;
                                            if _e1526 {
                                                phi_1824_ = lt_bvh_Hit(_e1487.t, _e1487.u, _e1487.v, _e1023, 4294967295u);
                                            } else {
                                                phi_1824_ = _e1012;
                                            }
                                            let _e1532 = phi_1824_;
                                            phi_1825_ = _e1532;
                                        } else {
                                            phi_1825_ = _e1012;
                                        }
                                        let _e1534 = phi_1825_;
                                        phi_1826_ = _e1534;
                                    } else {
                                        phi_1826_ = _e1012;
                                    }
                                    let _e1536 = phi_1826_;
                                    phi_1827_ = _e1536;
                                } else {
                                    phi_1827_ = _e1012;
                                }
                                let _e1538 = phi_1827_;
                                phi_1167_ = _e1538;
                                phi_1170_ = (_e1014 & (_e1014 - 1u));
                                phi_1828_ = true;
                            }
                            let _e1540 = phi_1167_;
                            let _e1542 = phi_1170_;
                            let _e1544 = phi_1828_;
                            continue;
                            continuing {
                                phi_1166_ = _e1540;
                                phi_1169_ = _e1542;
                                break if !(_e1544);
                            }
                        }
                        let _e1547 = local.group_mask;
                        if ((_e1547 & 4278190080u) == 0u) {
                            let _e1551 = local.len;
                            if (_e1551 == 0u) {
                                phi_1867_ = false;
                            } else {
                                let _e1555 = local.len;
                                local.len = (_e1555 - 1u);
                                let _e1558 = local.len;
                                if (_e1558 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1563 = local.first[(0u + _e1558)];
                                local.group = _e1563;
                                let _e1566 = local.len;
                                if (_e1566 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1571 = local.mask[(0u + _e1566)];
                                local.group_mask = _e1571;
                                phi_1867_ = true;
                            }
                            let _e1574 = phi_1867_;
                            phi_1868_ = _e1574;
                        } else {
                            phi_1868_ = true;
                        }
                        let _e1576 = phi_1868_;
                        if _e1576 {
                            let _e1578 = local.group_mask;
                            let _e1584 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1578)), 32u, (_e1578 == 0u)));
                            let _e1588 = local.group_mask;
                            let _e1602 = local.group_mask;
                            local.group_mask = (_e1602 & ~((1u << bitcast<u32>((_e1584 & 31u)))));
                            let _e1605 = local.group;
                            phi_1899_ = (_e1605 + countOneBits(((_e1588 & ~((4294967295u << bitcast<u32>((((_e1584 - 24u) ^ _e431) & 31u))))) & 255u)));
                        } else {
                            phi_1899_ = 4294967295u;
                        }
                        let _e1608 = phi_1899_;
                        let _e2382 = local_4;
                        phi_830_ = _e2382;
                        phi_833_ = _e1608;
                    } else {
                        phi_830_ = lt_bvh_Hit();
                        phi_833_ = u32();
                    }
                    let _e1610 = phi_830_;
                    let _e1612 = phi_833_;
                    continue;
                    continuing {
                        phi_829_ = _e1610;
                        phi_832_ = _e1612;
                        break if !(_e572);
                    }
                }
                let _e2386 = local_5;
                phi_1900_ = _e2386;
            }
            let _e1615 = phi_1900_;
            phi_1901_ = _e1615;
            phi_1902_ = _e228;
        } else {
            phi_1901_ = lt_bvh_Hit();
            phi_1902_ = true;
        }
        let _e1617 = phi_1901_;
        let _e1619 = phi_1902_;
        if _e1619 {
            phi_1906_ = _e166;
        } else {
            phi_1906_ = _e1617;
        }
        let _e1621 = phi_1906_;
        if (_e1621.triangle != 4294967295u) {
            let _e1627 = ((1f - _e1621.u) - _e1621.v);
            if (_e1621.triangle < _e71) {
            } else {
                return;
            }
            let _e1633 = triangles.member[(0u + _e1621.triangle)];
            let _e1658 = (((_e1633.v0_.x * _e1627) + (_e1633.v1_.x * _e1621.u)) + (_e1633.v2_.x * _e1621.v));
            let _e1659 = (((_e1633.v0_.y * _e1627) + (_e1633.v1_.y * _e1621.u)) + (_e1633.v2_.y * _e1621.v));
            let _e1660 = (((_e1633.v0_.z * _e1627) + (_e1633.v1_.z * _e1621.u)) + (_e1633.v2_.z * _e1621.v));
            let _e1663 = abs(_e1633.v0_.x);
            let _e1665 = abs(_e1633.v0_.y);
            let _e1667 = abs(_e1633.v0_.z);
            let _e1669 = abs(_e1633.v1_.x);
            let _e1671 = abs(_e1633.v1_.y);
            let _e1673 = abs(_e1633.v1_.z);
            if (_e1663 > _e1669) {
                phi_1971_ = _e1663;
            } else {
                phi_1971_ = _e1669;
            }
            let _e1676 = phi_1971_;
            if (_e1665 > _e1671) {
                phi_1976_ = _e1665;
            } else {
                phi_1976_ = _e1671;
            }
            let _e1679 = phi_1976_;
            if (_e1667 > _e1673) {
                phi_1981_ = _e1667;
            } else {
                phi_1981_ = _e1673;
            }
            let _e1682 = phi_1981_;
            let _e1684 = abs(_e1633.v2_.x);
            let _e1686 = abs(_e1633.v2_.y);
            let _e1688 = abs(_e1633.v2_.z);
            if (_e1676 > _e1684) {
                phi_1992_ = _e1676;
            } else {
                phi_1992_ = _e1684;
            }
            let _e1691 = phi_1992_;
            if (_e1679 > _e1686) {
                phi_1997_ = _e1679;
            } else {
                phi_1997_ = _e1686;
            }
            let _e1694 = phi_1997_;
            if (_e1682 > _e1688) {
                phi_2002_ = _e1682;
            } else {
                phi_2002_ = _e1688;
            }
            let _e1697 = phi_2002_;
            let _e1700 = (_e1633.v1_.x - _e1633.v0_.x);
            let _e1703 = (_e1633.v1_.y - _e1633.v0_.y);
            let _e1706 = (_e1633.v1_.z - _e1633.v0_.z);
            let _e1709 = (_e1633.v2_.x - _e1633.v0_.x);
            let _e1712 = (_e1633.v2_.y - _e1633.v0_.y);
            let _e1715 = (_e1633.v2_.z - _e1633.v0_.z);
            let _e1719 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1703), abs(_e1706));
            let _e1720 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1700), _e1719);
            let _e1721 = (_e1700 / _e1720);
            let _e1722 = (_e1703 / _e1720);
            let _e1723 = (_e1706 / _e1720);
            let _e1727 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1712), abs(_e1715));
            let _e1728 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1709), _e1727);
            let _e1729 = (_e1709 / _e1728);
            let _e1730 = (_e1712 / _e1728);
            let _e1731 = (_e1715 / _e1728);
            let _e1734 = ((_e1722 * _e1731) - (_e1730 * _e1723));
            let _e1737 = ((_e1723 * _e1729) - (_e1731 * _e1721));
            let _e1740 = ((_e1721 * _e1730) - (_e1729 * _e1722));
            let _e1742 = p.member.eye;
            let _e1755 = (1f / sqrt((((_e1734 * _e1734) + (_e1737 * _e1737)) + (_e1740 * _e1740))));
            let _e1756 = (_e1734 * _e1755);
            let _e1757 = (_e1737 * _e1755);
            let _e1758 = (_e1740 * _e1755);
            if ((((_e1756 * (_e1742.x - _e1658)) + (_e1757 * (_e1742.y - _e1659))) + (_e1758 * (_e1742.z - _e1660))) < 0f) {
                phi_2078_ = vec3<f32>(-(_e1756), -(_e1757), -(_e1758));
            } else {
                phi_2078_ = vec3<f32>(_e1756, _e1757, _e1758);
            }
            let _e1771 = phi_2078_;
            if (_e1621.triangle < _e71) {
            } else {
                return;
            }
            let _e1776 = triangles.member[(0u + _e1621.triangle)];
            let _e1778 = (_e1776.i0_ & 2147483647u);
            if (_e1778 < _e74) {
            } else {
                return;
            }
            let _e1784 = vertices.member[(0u + _e1778)];
            if (_e1776.i1_ < _e74) {
            } else {
                return;
            }
            let _e1788 = vertices.member[(0u + _e1776.i1_)];
            if (_e1776.i2_ < _e74) {
            } else {
                return;
            }
            let _e1792 = vertices.member[(0u + _e1776.i2_)];
            let _e1793 = array<abi_Vertex, 3>(_e1784, _e1788, _e1792);
            if (_e1793[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e1799 = materials.member[(0u + _e1793[0].material)];
            let _e1816 = (1f / 255f);
            let _e1835 = (1f / 255f);
            let _e1857 = (1f / 255f);
            let _e1870 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e1627, _e1621.u, _e1621.v));
            let _e1872 = ((_e1799.base_color.x * ((((f32((_e1793[0].color & 255u)) * _e1816) * _e1627) + ((f32((_e1793[1].color & 255u)) * _e1835) * _e1621.u)) + ((f32((_e1793[2].color & 255u)) * _e1857) * _e1621.v))) * _e1870.x);
            let _e1874 = ((_e1799.base_color.y * ((((f32(((_e1793[0].color >> bitcast<u32>(8i)) & 255u)) * _e1816) * _e1627) + ((f32(((_e1793[1].color >> bitcast<u32>(8i)) & 255u)) * _e1835) * _e1621.u)) + ((f32(((_e1793[2].color >> bitcast<u32>(8i)) & 255u)) * _e1857) * _e1621.v))) * _e1870.y);
            let _e1876 = ((_e1799.base_color.z * ((((f32(((_e1793[0].color >> bitcast<u32>(16i)) & 255u)) * _e1816) * _e1627) + ((f32(((_e1793[1].color >> bitcast<u32>(16i)) & 255u)) * _e1835) * _e1621.u)) + ((f32(((_e1793[2].color >> bitcast<u32>(16i)) & 255u)) * _e1857) * _e1621.v))) * _e1870.z);
            let _e1877 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1694, _e1697);
            let _e1878 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1691, _e1877);
            if ((_e1799.flags & 2u) == 0u) {
                phi_2199_ = 0u;
            } else {
                phi_2199_ = 1u;
            }
            let _e1883 = phi_2199_;
            if (_e1793[0].normal == 2147516416u) {
                phi_2402_ = _e1771;
            } else {
                let _e1896 = (f32((bitcast<i32>((_e1793[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1902 = (f32((bitcast<i32>(_e1793[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1906 = ((1f - abs(_e1896)) - abs(_e1902));
                if (_e1906 < 0f) {
                    phi_2226_ = -(_e1906);
                } else {
                    phi_2226_ = 0f;
                }
                let _e1910 = phi_2226_;
                if (_e1896 < 0f) {
                    phi_2233_ = (_e1896 + _e1910);
                } else {
                    phi_2233_ = (_e1896 - _e1910);
                }
                let _e1915 = phi_2233_;
                if (_e1902 < 0f) {
                    phi_2240_ = (_e1902 + _e1910);
                } else {
                    phi_2240_ = (_e1902 - _e1910);
                }
                let _e1920 = phi_2240_;
                let _e1927 = (1f / sqrt((((_e1915 * _e1915) + (_e1920 * _e1920)) + (_e1906 * _e1906))));
                let _e1943 = (f32((bitcast<i32>((_e1793[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1949 = (f32((bitcast<i32>(_e1793[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1953 = ((1f - abs(_e1943)) - abs(_e1949));
                if (_e1953 < 0f) {
                    phi_2275_ = -(_e1953);
                } else {
                    phi_2275_ = 0f;
                }
                let _e1957 = phi_2275_;
                if (_e1943 < 0f) {
                    phi_2282_ = (_e1943 + _e1957);
                } else {
                    phi_2282_ = (_e1943 - _e1957);
                }
                let _e1962 = phi_2282_;
                if (_e1949 < 0f) {
                    phi_2289_ = (_e1949 + _e1957);
                } else {
                    phi_2289_ = (_e1949 - _e1957);
                }
                let _e1967 = phi_2289_;
                let _e1974 = (1f / sqrt((((_e1962 * _e1962) + (_e1967 * _e1967)) + (_e1953 * _e1953))));
                let _e1993 = (f32((bitcast<i32>((_e1793[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1999 = (f32((bitcast<i32>(_e1793[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2003 = ((1f - abs(_e1993)) - abs(_e1999));
                if (_e2003 < 0f) {
                    phi_2327_ = -(_e2003);
                } else {
                    phi_2327_ = 0f;
                }
                let _e2007 = phi_2327_;
                if (_e1993 < 0f) {
                    phi_2334_ = (_e1993 + _e2007);
                } else {
                    phi_2334_ = (_e1993 - _e2007);
                }
                let _e2012 = phi_2334_;
                if (_e1999 < 0f) {
                    phi_2341_ = (_e1999 + _e2007);
                } else {
                    phi_2341_ = (_e1999 - _e2007);
                }
                let _e2017 = phi_2341_;
                let _e2024 = (1f / sqrt((((_e2012 * _e2012) + (_e2017 * _e2017)) + (_e2003 * _e2003))));
                let _e2035 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e1915 * _e1927) * _e1627) + ((_e1962 * _e1974) * _e1621.u)) + ((_e2012 * _e2024) * _e1621.v)), ((((_e1920 * _e1927) * _e1627) + ((_e1967 * _e1974) * _e1621.u)) + ((_e2017 * _e2024) * _e1621.v)), ((((_e1906 * _e1927) * _e1627) + ((_e1953 * _e1974) * _e1621.u)) + ((_e2003 * _e2024) * _e1621.v))));
                let _e2047 = sqrt((((_e2035.x * _e2035.x) + (_e2035.y * _e2035.y)) + (_e2035.z * _e2035.z)));
                if (_e2047 > 0f) {
                    let _e2050 = (_e2035.x / _e2047);
                    let _e2052 = (_e2035.y / _e2047);
                    let _e2054 = (_e2035.z / _e2047);
                    if ((((_e2050 * _e1771.x) + (_e2052 * _e1771.y)) + (_e2054 * _e1771.z)) < 0f) {
                        phi_2400_ = vec3<f32>(-(_e2050), -(_e2052), -(_e2054));
                    } else {
                        phi_2400_ = (_e2035 / vec3(_e2047));
                    }
                    let _e2071 = phi_2400_;
                    phi_2401_ = _e2071;
                } else {
                    phi_2401_ = _e1771;
                }
                let _e2073 = phi_2401_;
                phi_2402_ = _e2073;
            }
            let _e2075 = phi_2402_;
            if (_e1872 > 0f) {
                if (_e1872 < 1f) {
                    phi_2411_ = _e1872;
                } else {
                    phi_2411_ = 1f;
                }
                let _e2079 = phi_2411_;
                phi_2412_ = _e2079;
            } else {
                phi_2412_ = 0f;
            }
            let _e2081 = phi_2412_;
            if (_e1874 > 0f) {
                if (_e1874 < 1f) {
                    phi_2422_ = _e1874;
                } else {
                    phi_2422_ = 1f;
                }
                let _e2086 = phi_2422_;
                phi_2423_ = _e2086;
            } else {
                phi_2423_ = 0f;
            }
            let _e2088 = phi_2423_;
            if (_e1876 > 0f) {
                if (_e1876 < 1f) {
                    phi_2433_ = _e1876;
                } else {
                    phi_2433_ = 1f;
                }
                let _e2093 = phi_2433_;
                phi_2434_ = _e2093;
            } else {
                phi_2434_ = 0f;
            }
            let _e2095 = phi_2434_;
            let _e2098 = ((sqrt(_e2081) * 255f) + 0.5f);
            let _e2107 = ((sqrt(_e2088) * 255f) + 0.5f);
            let _e2119 = ((sqrt(_e2095) * 255f) + 0.5f);
            phi_2469_ = abi_Sample(vec3<f32>(_e1658, _e1659, _e1660), _e1878, _e1771, _e1883, _e2075, ((select(select(u32(_e2098), 0u, (_e2098 < bitcast<f32>(0u))), 4294967295u, (_e2098 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2107), 0u, (_e2107 < bitcast<f32>(0u))), 4294967295u, (_e2107 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2119), 0u, (_e2119 < bitcast<f32>(0u))), 4294967295u, (_e2119 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_2469_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2133 = phi_2469_;
        if (_e92.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e92.first_primitive)] = _e2133;
        if (_e1621.triangle != 4294967295u) {
            let _e2142 = ((1f - _e1621.u) - _e1621.v);
            if (_e1621.triangle < _e71) {
            } else {
                return;
            }
            let _e2147 = triangles.member[(0u + _e1621.triangle)];
            let _e2149 = (_e2147.i0_ & 2147483647u);
            if (_e2149 < _e83) {
            } else {
                return;
            }
            let _e2155 = before.member[(0u + _e2149)];
            if (_e2147.i1_ < _e83) {
            } else {
                return;
            }
            let _e2159 = before.member[(0u + _e2147.i1_)];
            if (_e2147.i2_ < _e83) {
            } else {
                return;
            }
            let _e2163 = before.member[(0u + _e2147.i2_)];
            let _e2168 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2155.x, _e2155.y, _e2155.z));
            let _e2179 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2159.x, _e2159.y, _e2159.z));
            let _e2193 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2163.x, _e2163.y, _e2163.z));
            phi_2560_ = vec3<f32>((((_e2168.x * _e2142) + (_e2179.x * _e1621.u)) + (_e2193.x * _e1621.v)), (((_e2168.y * _e2142) + (_e2179.y * _e1621.u)) + (_e2193.y * _e1621.v)), (((_e2168.z * _e2142) + (_e2179.z * _e1621.u)) + (_e2193.z * _e1621.v)));
        } else {
            phi_2560_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e2205 = phi_2560_;
        if (_e92.first_primitive < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e92.first_primitive)] = vec4<f32>(_e2205.x, _e2205.y, _e2205.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
