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

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct lt_bvh_Triangle {
    v0_: vec3<f32>,
    i0_: u32,
    v1_: vec3<f32>,
    i1_: u32,
    v2_: vec3<f32>,
    i2_: u32,
}

struct type_22 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_26 {
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

struct type_30 {
    member: array<abi_Material>,
}

struct lt_bvh_traverse_Stack {
    first: array<u32, 32>,
    mask: array<u32, 32>,
    len: u32,
    group: u32,
    group_mask: u32,
}

struct type_39 {
    member: abi_CameraParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_44 {
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
var<storage> vertices: type_26;
@group(0) @binding(4) 
var<storage> materials: type_30;
@group(0) @binding(0) 
var<uniform> p: type_39;
@group(0) @binding(1) 
var<storage> nodes: type_44;
@group(0) @binding(2) 
var<storage> triangles: type_22;
@group(0) @binding(5) 
var<storage, read_write> samples: type_9;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_184_: lt_bvh_traverse_Tree;
    var phi_185_: bool;
    var phi_186_: lt_bvh_traverse_Tree;
    var phi_187_: bool;
    var phi_192_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_184_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_185_ = false;
        } else {
            phi_184_ = lt_bvh_traverse_Tree();
            phi_185_ = true;
        }
        let _e73 = phi_184_;
        let _e75 = phi_185_;
        phi_186_ = _e73;
        phi_187_ = _e75;
    } else {
        phi_186_ = lt_bvh_traverse_Tree();
        phi_187_ = true;
    }
    let _e77 = phi_186_;
    let _e79 = phi_187_;
    if _e79 {
        phi_192_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_192_ = _e77;
    }
    let _e84 = phi_192_;
    return lt_bvh_traverse_Tree(_e84.root, _e84.first_primitive);
}

fn _lt_bvh_ray_Ray_new(param_3: vec3<f32>, param_4: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_3, 0f, param_4, 300000000000000000000000000000000000000f);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_211_: bool;
    var phi_215_: f32;

    if (param_5 != param_5) {
        phi_211_ = true;
    } else {
        let _e63 = (param_6 >= param_5);
        if _e63 {
        }
        phi_211_ = _e63;
    }
    let _e65 = phi_211_;
    if _e65 {
        phi_215_ = param_6;
    } else {
        phi_215_ = param_5;
    }
    let _e67 = phi_215_;
    return _e67;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_7: f32, param_8: f32) -> f32 {
    var phi_227_: bool;
    var phi_231_: f32;

    if (param_7 != param_7) {
        phi_227_ = true;
    } else {
        let _e63 = (param_8 <= param_7);
        if _e63 {
        }
        phi_227_ = _e63;
    }
    let _e65 = phi_227_;
    if _e65 {
        phi_231_ = param_8;
    } else {
        phi_231_ = param_7;
    }
    let _e67 = phi_231_;
    return _e67;
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_9: f32, param_10: f32) -> f32 {
    var phi_239_: f32;

    if (param_9 > param_10) {
        phi_239_ = param_9;
    } else {
        phi_239_ = param_10;
    }
    let _e64 = phi_239_;
    return _e64;
}

fn _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(param_11: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(1f, 1f, 1f);
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(param_12: vec3<f32>) -> vec3<f32> {
    return param_12;
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var phi_379_: bool;
    var phi_380_: bool;
    var phi_381_: bool;
    var phi_385_: bool;
    var phi_386_: bool;
    var phi_387_: bool;
    var phi_388_: bool;
    var phi_389_: bool;
    var phi_390_: bool;
    var phi_391_: bool;
    var phi_392_: bool;
    var phi_393_: bool;
    var phi_394_: bool;
    var phi_395_: bool;
    var phi_396_: bool;
    var phi_397_: bool;
    var phi_398_: bool;
    var phi_399_: bool;
    var phi_400_: bool;
    var phi_401_: bool;
    var phi_402_: bool;
    var phi_406_: bool;
    var phi_410_: bool;
    var phi_485_: f32;
    var phi_492_: f32;
    var phi_500_: f32;
    var phi_507_: f32;
    var phi_515_: f32;
    var phi_522_: f32;
    var phi_547_: f32;
    var phi_552_: f32;
    var phi_557_: f32;
    var phi_590_: bool;
    var phi_591_: bool;
    var phi_599_: u32;
    var phi_600_: u32;
    var phi_618_: vec3<f32>;
    var phi_619_: vec3<f32>;
    var phi_633_: u32;
    var phi_638_: u32;
    var phi_643_: u32;
    var phi_757_: bool;
    var phi_758_: bool;
    var phi_789_: u32;
    var phi_791_: lt_bvh_Hit;
    var phi_794_: u32;
    var phi_879_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_906_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_933_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_939_: u32;
    var phi_942_: u32;
    var phi_956_: u32;
    var phi_966_: u32;
    var phi_976_: u32;
    var phi_994_: u32;
    var phi_1004_: u32;
    var phi_1014_: u32;
    var phi_1050_: u32;
    var phi_1063_: u32;
    var phi_1068_: u32;
    var phi_1069_: u32;
    var phi_1070_: u32;
    var phi_940_: u32;
    var phi_943_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1128_: lt_bvh_Hit;
    var phi_1131_: u32;
    var phi_1177_: vec3<f32>;
    var phi_1178_: vec3<f32>;
    var phi_1211_: vec3<f32>;
    var phi_1212_: vec3<f32>;
    var phi_1245_: vec3<f32>;
    var phi_1246_: vec3<f32>;
    var phi_1266_: bool;
    var phi_1267_: bool;
    var phi_1271_: f32;
    var phi_1272_: f32;
    var phi_1273_: f32;
    var phi_1274_: f32;
    var phi_1282_: f32;
    var phi_1292_: bool;
    var phi_1293_: bool;
    var phi_1297_: f32;
    var phi_1298_: f32;
    var phi_1299_: f32;
    var phi_1300_: f32;
    var phi_1308_: f32;
    var phi_1318_: bool;
    var phi_1319_: bool;
    var phi_1323_: f32;
    var phi_1324_: f32;
    var phi_1325_: f32;
    var phi_1326_: f32;
    var phi_1334_: f32;
    var phi_1349_: f32;
    var phi_1350_: bool;
    var phi_1351_: f32;
    var phi_1352_: bool;
    var phi_1353_: f32;
    var phi_1354_: bool;
    var phi_1372_: f32;
    var phi_1373_: bool;
    var phi_1374_: bool;
    var phi_1375_: f32;
    var phi_1376_: bool;
    var phi_1377_: bool;
    var phi_1381_: bool;
    var phi_1382_: f32;
    var phi_1383_: bool;
    var phi_1419_: f32;
    var phi_1428_: f32;
    var phi_1437_: f32;
    var phi_1446_: f32;
    var phi_1453_: f32;
    var phi_1460_: f32;
    var phi_1473_: f32;
    var phi_1482_: f32;
    var phi_1491_: f32;
    var phi_1500_: f32;
    var phi_1507_: f32;
    var phi_1514_: f32;
    var phi_1537_: f32;
    var phi_1542_: f32;
    var phi_1547_: f32;
    var phi_1555_: f32;
    var phi_1560_: f32;
    var phi_1565_: f32;
    var phi_1577_: f32;
    var phi_1582_: f32;
    var phi_1587_: f32;
    var phi_1592_: f32;
    var phi_1597_: lt_bvh_triangle_Intersection;
    var phi_1598_: bool;
    var phi_1599_: lt_bvh_triangle_Intersection;
    var phi_1600_: bool;
    var phi_1604_: lt_bvh_triangle_Intersection;
    var phi_1605_: bool;
    var phi_1606_: lt_bvh_triangle_Intersection;
    var phi_1607_: bool;
    var phi_1608_: bool;
    var phi_1612_: bool;
    var phi_1616_: lt_bvh_triangle_Intersection;
    var phi_1655_: bool;
    var phi_1656_: bool;
    var phi_1657_: bool;
    var phi_1658_: bool;
    var phi_1659_: bool;
    var phi_1660_: bool;
    var phi_1664_: bool;
    var phi_1665_: bool;
    var phi_1679_: bool;
    var phi_1687_: lt_bvh_Hit;
    var phi_1688_: lt_bvh_Hit;
    var phi_1689_: lt_bvh_Hit;
    var phi_1690_: lt_bvh_Hit;
    var phi_1129_: lt_bvh_Hit;
    var phi_1132_: u32;
    var phi_1691_: bool;
    var phi_1730_: bool;
    var phi_1731_: bool;
    var phi_1762_: u32;
    var phi_792_: lt_bvh_Hit;
    var phi_795_: u32;
    var phi_1763_: lt_bvh_Hit;
    var phi_1764_: lt_bvh_Hit;
    var phi_1765_: bool;
    var phi_1769_: lt_bvh_Hit;
    var phi_1834_: f32;
    var phi_1839_: f32;
    var phi_1844_: f32;
    var phi_1855_: f32;
    var phi_1860_: f32;
    var phi_1865_: f32;
    var phi_1941_: vec3<f32>;
    var phi_2062_: u32;
    var phi_2089_: f32;
    var phi_2096_: f32;
    var phi_2103_: f32;
    var phi_2138_: f32;
    var phi_2145_: f32;
    var phi_2152_: f32;
    var phi_2190_: f32;
    var phi_2197_: f32;
    var phi_2204_: f32;
    var phi_2263_: vec3<f32>;
    var phi_2264_: vec3<f32>;
    var phi_2265_: vec3<f32>;
    var phi_2274_: f32;
    var phi_2275_: f32;
    var phi_2285_: f32;
    var phi_2286_: f32;
    var phi_2296_: f32;
    var phi_2297_: f32;
    var phi_2332_: abi_Sample;
    var local_4: lt_bvh_Hit;
    var local_5: lt_bvh_Hit;

    let _e61 = id_1;
    let _e65 = arrayLength((&nodes.member));
    let _e68 = arrayLength((&triangles.member));
    let _e71 = arrayLength((&vertices.member));
    let _e80 = p.member.size[0u];
    let _e82 = p.member.size[1u];
    let _e83 = lt_shaders_entry_pixel_index(_e61, _e80, _e82);
    if (bitcast<i32>(_e83.root) != 0i) {
        let _e91 = p.member.eye;
        let _e96 = p.member.size[0u];
        let _e100 = ((((f32(_e61.x) + 0.5f) / f32(_e96)) * 2f) - 1f);
        let _e105 = p.member.size[1u];
        let _e109 = (1f - (((f32(_e61.y) + 0.5f) / f32(_e105)) * 2f));
        let _e111 = p.member.forward;
        let _e113 = p.member.right;
        let _e127 = p.member.up;
        let _e138 = _lt_bvh_ray_Ray_new(_e91, vec3<f32>(((_e111.x + (_e113.x * _e100)) + (_e127.x * _e109)), ((_e111.y + (_e113.y * _e100)) + (_e127.y * _e109)), ((_e111.z + (_e113.z * _e100)) + (_e127.z * _e109))));
        let _e140 = lt_bvh_Hit(_e138.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e150 = abs(_e138.direction.x);
        let _e152 = abs(_e138.direction.y);
        let _e154 = abs(_e138.direction.z);
        if (abs(_e138.origin.x) < 1000000000000000f) {
            if (abs(_e138.origin.y) < 1000000000000000f) {
                if (abs(_e138.origin.z) < 1000000000000000f) {
                    if (_e150 < 1000000000000000f) {
                        if (_e152 < 1000000000000000f) {
                            if (_e154 < 1000000000000000f) {
                                if (_e150 > 0f) {
                                    phi_380_ = bool();
                                    phi_381_ = true;
                                } else {
                                    let _e162 = (_e152 > 0f);
                                    if _e162 {
                                        phi_379_ = bool();
                                    } else {
                                        phi_379_ = (_e154 > 0f);
                                    }
                                    let _e165 = phi_379_;
                                    phi_380_ = _e165;
                                    phi_381_ = _e162;
                                }
                                let _e167 = phi_380_;
                                let _e169 = phi_381_;
                                if _e169 {
                                    phi_385_ = true;
                                } else {
                                    phi_385_ = _e167;
                                }
                                let _e171 = phi_385_;
                                phi_386_ = _e171;
                                phi_387_ = false;
                            } else {
                                phi_386_ = bool();
                                phi_387_ = true;
                            }
                            let _e173 = phi_386_;
                            let _e175 = phi_387_;
                            phi_388_ = _e173;
                            phi_389_ = false;
                            phi_390_ = _e175;
                        } else {
                            phi_388_ = bool();
                            phi_389_ = true;
                            phi_390_ = false;
                        }
                        let _e177 = phi_388_;
                        let _e179 = phi_389_;
                        let _e181 = phi_390_;
                        phi_391_ = _e177;
                        phi_392_ = _e179;
                        phi_393_ = _e181;
                    } else {
                        phi_391_ = bool();
                        phi_392_ = true;
                        phi_393_ = false;
                    }
                    let _e183 = phi_391_;
                    let _e185 = phi_392_;
                    let _e187 = phi_393_;
                    phi_394_ = _e183;
                    phi_395_ = _e185;
                    phi_396_ = _e187;
                } else {
                    phi_394_ = bool();
                    phi_395_ = true;
                    phi_396_ = false;
                }
                let _e189 = phi_394_;
                let _e191 = phi_395_;
                let _e193 = phi_396_;
                phi_397_ = _e189;
                phi_398_ = _e191;
                phi_399_ = _e193;
            } else {
                phi_397_ = bool();
                phi_398_ = true;
                phi_399_ = false;
            }
            let _e195 = phi_397_;
            let _e197 = phi_398_;
            let _e199 = phi_399_;
            phi_400_ = _e195;
            phi_401_ = _e197;
            phi_402_ = _e199;
        } else {
            phi_400_ = bool();
            phi_401_ = true;
            phi_402_ = false;
        }
        let _e201 = phi_400_;
        let _e203 = phi_401_;
        let _e205 = phi_402_;
        if _e203 {
            phi_406_ = true;
        } else {
            phi_406_ = _e205;
        }
        let _e207 = phi_406_;
        if _e207 {
            phi_410_ = false;
        } else {
            phi_410_ = _e201;
        }
        let _e209 = phi_410_;
        if _e209 {
            let _e210 = (0u >= _e65);
            if _e210 {
                phi_1763_ = lt_bvh_Hit();
            } else {
                if (0u < _e65) {
                } else {
                    return;
                }
                let _e216 = nodes.member[(0u + 0u)].frame[0u];
                let _e220 = nodes.member[(0u + 0u)].frame[1u];
                let _e224 = nodes.member[(0u + 0u)].frame[2u];
                let _e228 = nodes.member[(0u + 0u)].frame[0u];
                let _e232 = nodes.member[(0u + 0u)].frame[1u];
                let _e236 = nodes.member[(0u + 0u)].frame[2u];
                let _e240 = nodes.member[(0u + 0u)].frame[3u];
                let _e278 = core_intrinsics_maximum_number_nsz_f32_(abs(_e138.direction.x), abs(_e138.direction.y));
                let _e279 = core_intrinsics_maximum_number_nsz_f32_(_e278, abs(_e138.direction.z));
                let _e280 = (_e279 * 0.0000000000009094947f);
                if (abs(_e138.direction.x) < _e280) {
                    phi_485_ = _e280;
                } else {
                    phi_485_ = abs(_e138.direction.x);
                }
                let _e287 = phi_485_;
                if (_e138.direction.x < 0f) {
                    phi_492_ = (-1f / _e287);
                } else {
                    phi_492_ = (1f / _e287);
                }
                let _e292 = phi_492_;
                if (abs(_e138.direction.y) < _e280) {
                    phi_500_ = _e280;
                } else {
                    phi_500_ = abs(_e138.direction.y);
                }
                let _e299 = phi_500_;
                if (_e138.direction.y < 0f) {
                    phi_507_ = (-1f / _e299);
                } else {
                    phi_507_ = (1f / _e299);
                }
                let _e304 = phi_507_;
                if (abs(_e138.direction.z) < _e280) {
                    phi_515_ = _e280;
                } else {
                    phi_515_ = abs(_e138.direction.z);
                }
                let _e311 = phi_515_;
                if (_e138.direction.z < 0f) {
                    phi_522_ = (-1f / _e311);
                } else {
                    phi_522_ = (1f / _e311);
                }
                let _e316 = phi_522_;
                let _e324 = abs((bitcast<f32>(_e216) - _e138.origin.x));
                let _e325 = abs((bitcast<f32>(_e220) - _e138.origin.y));
                let _e326 = abs((bitcast<f32>(_e224) - _e138.origin.z));
                let _e334 = abs(((bitcast<f32>(_e228) + (bitcast<f32>((((_e240 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e138.origin.x));
                let _e335 = abs(((bitcast<f32>(_e232) + (bitcast<f32>((((_e240 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e138.origin.y));
                let _e336 = abs(((bitcast<f32>(_e236) + (bitcast<f32>((((_e240 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e138.origin.z));
                if (_e324 > _e334) {
                    phi_547_ = _e324;
                } else {
                    phi_547_ = _e334;
                }
                let _e339 = phi_547_;
                if (_e325 > _e335) {
                    phi_552_ = _e325;
                } else {
                    phi_552_ = _e335;
                }
                let _e342 = phi_552_;
                if (_e326 > _e336) {
                    phi_557_ = _e326;
                } else {
                    phi_557_ = _e336;
                }
                let _e345 = phi_557_;
                let _e346 = core_intrinsics_maximum_number_nsz_f32_(_e339, _e342);
                let _e347 = core_intrinsics_maximum_number_nsz_f32_(_e346, _e345);
                let _e352 = (_e347 * 0.0000019073486f);
                let _e353 = (abs(_e292) * _e352);
                let _e354 = (abs(_e304) * _e352);
                let _e355 = (abs(_e316) * _e352);
                let _e359 = (_e347 * 0.0000009536743f);
                let _e360 = (abs(_e292) * _e359);
                let _e361 = (abs(_e304) * _e359);
                let _e362 = (abs(_e316) * _e359);
                let _e365 = abs(_e138.direction.x);
                let _e367 = abs(_e138.direction.y);
                let _e369 = abs(_e138.direction.z);
                if (_e365 >= _e367) {
                    if (_e365 >= _e369) {
                        phi_590_ = false;
                    } else {
                        phi_590_ = true;
                    }
                    let _e373 = phi_590_;
                    phi_591_ = _e373;
                } else {
                    phi_591_ = true;
                }
                let _e375 = phi_591_;
                if _e375 {
                    if (_e367 >= _e369) {
                        phi_599_ = 1u;
                    } else {
                        phi_599_ = 2u;
                    }
                    let _e378 = phi_599_;
                    phi_600_ = _e378;
                } else {
                    phi_600_ = 0u;
                }
                let _e380 = phi_600_;
                if (_e380 == 0u) {
                    phi_619_ = vec3<f32>(_e138.direction.y, _e138.direction.z, _e138.direction.x);
                } else {
                    if (_e380 == 1u) {
                        phi_618_ = vec3<f32>(_e138.direction.z, _e138.direction.x, _e138.direction.y);
                    } else {
                        phi_618_ = _e138.direction;
                    }
                    let _e393 = phi_618_;
                    phi_619_ = _e393;
                }
                let _e395 = phi_619_;
                let _e399 = (_e395.x / _e395.z);
                let _e402 = (_e395.y / _e395.z);
                let _e404 = (1f / _e395.z);
                if (_e292 < 0f) {
                    phi_633_ = 0u;
                } else {
                    phi_633_ = 1u;
                }
                let _e407 = phi_633_;
                if (_e304 < 0f) {
                    phi_638_ = 0u;
                } else {
                    phi_638_ = 2u;
                }
                let _e410 = phi_638_;
                if (_e316 < 0f) {
                    phi_643_ = 0u;
                } else {
                    phi_643_ = 4u;
                }
                let _e413 = phi_643_;
                let _e415 = ((_e407 | _e410) | _e413);
                let _e416 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local = lt_bvh_traverse_Stack(array<u32, 32>(_e416.first[0], _e416.first[1], _e416.first[2], _e416.first[3], _e416.first[4], _e416.first[5], _e416.first[6], _e416.first[7], _e416.first[8], _e416.first[9], _e416.first[10], _e416.first[11], _e416.first[12], _e416.first[13], _e416.first[14], _e416.first[15], _e416.first[16], _e416.first[17], _e416.first[18], _e416.first[19], _e416.first[20], _e416.first[21], _e416.first[22], _e416.first[23], _e416.first[24], _e416.first[25], _e416.first[26], _e416.first[27], _e416.first[28], _e416.first[29], _e416.first[30], _e416.first[31]), array<u32, 32>(_e416.mask[0], _e416.mask[1], _e416.mask[2], _e416.mask[3], _e416.mask[4], _e416.mask[5], _e416.mask[6], _e416.mask[7], _e416.mask[8], _e416.mask[9], _e416.mask[10], _e416.mask[11], _e416.mask[12], _e416.mask[13], _e416.mask[14], _e416.mask[15], _e416.mask[16], _e416.mask[17], _e416.mask[18], _e416.mask[19], _e416.mask[20], _e416.mask[21], _e416.mask[22], _e416.mask[23], _e416.mask[24], _e416.mask[25], _e416.mask[26], _e416.mask[27], _e416.mask[28], _e416.mask[29], _e416.mask[30], _e416.mask[31]), _e416.len, _e416.group, _e416.group_mask);
                let _e490 = local.group_mask;
                if ((_e490 & 4278190080u) == 0u) {
                    let _e494 = local.len;
                    if (_e494 == 0u) {
                        phi_757_ = false;
                    } else {
                        let _e498 = local.len;
                        local.len = (_e498 - 1u);
                        let _e501 = local.len;
                        if (_e501 < 32u) {
                        } else {
                            return;
                        }
                        let _e506 = local.first[(0u + _e501)];
                        local.group = _e506;
                        let _e509 = local.len;
                        if (_e509 < 32u) {
                        } else {
                            return;
                        }
                        let _e514 = local.mask[(0u + _e509)];
                        local.group_mask = _e514;
                        phi_757_ = true;
                    }
                    let _e517 = phi_757_;
                    phi_758_ = _e517;
                } else {
                    phi_758_ = true;
                }
                let _e519 = phi_758_;
                if _e519 {
                    let _e521 = local.group_mask;
                    let _e527 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e521)), 32u, (_e521 == 0u)));
                    let _e531 = local.group_mask;
                    let _e545 = local.group_mask;
                    local.group_mask = (_e545 & ~((1u << bitcast<u32>((_e527 & 31u)))));
                    let _e548 = local.group;
                    phi_789_ = (_e548 + countOneBits(((_e531 & ~((4294967295u << bitcast<u32>((((_e527 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_789_ = 4294967295u;
                }
                let _e551 = phi_789_;
                phi_791_ = _e140;
                phi_794_ = _e551;
                loop {
                    let _e553 = phi_791_;
                    let _e555 = phi_794_;
                    local_5 = _e553;
                    let _e556 = (_e555 != 4294967295u);
                    if _e556 {
                        if (_e555 < _e65) {
                        } else {
                            return;
                        }
                        let _e564 = nodes.member[(0u + _e555)].frame[3u];
                        let _e589 = (bitcast<f32>((((_e564 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e292);
                        let _e590 = (bitcast<f32>((((_e564 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e304);
                        let _e591 = (bitcast<f32>((((_e564 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e316);
                        let _e594 = nodes.member[(0u + _e555)].frame[0u];
                        let _e598 = nodes.member[(0u + _e555)].frame[1u];
                        let _e602 = nodes.member[(0u + _e555)].frame[2u];
                        let _e610 = ((bitcast<f32>(_e594) - _e138.origin.x) * _e292);
                        let _e611 = ((bitcast<f32>(_e598) - _e138.origin.y) * _e304);
                        let _e612 = ((bitcast<f32>(_e602) - _e138.origin.z) * _e316);
                        let _e620 = nodes.member[(0u + _e555)].x;
                        if (_e292 < 0f) {
                            let _e631 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e620.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e637 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e631.unnamed.root, _e620.w), _e631.unnamed_1);
                            let _e643 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e637.unnamed, lt_bvh_traverse_Tree(_e620.x, _e637.unnamed_1.first_primitive));
                            phi_879_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e643.unnamed, lt_bvh_traverse_Tree(_e643.unnamed_1.root, _e620.y));
                        } else {
                            let _e659 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e620.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e665 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e659.unnamed.root, _e620.y), _e659.unnamed_1);
                            let _e671 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e665.unnamed, lt_bvh_traverse_Tree(_e620.z, _e665.unnamed_1.first_primitive));
                            phi_879_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e671.unnamed, lt_bvh_traverse_Tree(_e671.unnamed_1.root, _e620.w));
                        }
                        let _e679 = phi_879_;
                        let _e689 = nodes.member[(0u + _e555)].y;
                        if (_e304 < 0f) {
                            let _e700 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e689.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e706 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e700.unnamed.root, _e689.w), _e700.unnamed_1);
                            let _e712 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e706.unnamed, lt_bvh_traverse_Tree(_e689.x, _e706.unnamed_1.first_primitive));
                            phi_906_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e712.unnamed, lt_bvh_traverse_Tree(_e712.unnamed_1.root, _e689.y));
                        } else {
                            let _e728 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e689.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e734 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e728.unnamed.root, _e689.y), _e728.unnamed_1);
                            let _e740 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e734.unnamed, lt_bvh_traverse_Tree(_e689.z, _e734.unnamed_1.first_primitive));
                            phi_906_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e740.unnamed, lt_bvh_traverse_Tree(_e740.unnamed_1.root, _e689.w));
                        }
                        let _e748 = phi_906_;
                        let _e758 = nodes.member[(0u + _e555)].z;
                        if (_e316 < 0f) {
                            let _e769 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e758.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e775 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e769.unnamed.root, _e758.w), _e769.unnamed_1);
                            let _e781 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e775.unnamed, lt_bvh_traverse_Tree(_e758.x, _e775.unnamed_1.first_primitive));
                            phi_933_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e781.unnamed, lt_bvh_traverse_Tree(_e781.unnamed_1.root, _e758.y));
                        } else {
                            let _e797 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e758.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e803 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e797.unnamed.root, _e758.y), _e797.unnamed_1);
                            let _e809 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e803.unnamed, lt_bvh_traverse_Tree(_e758.z, _e803.unnamed_1.first_primitive));
                            phi_933_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e809.unnamed, lt_bvh_traverse_Tree(_e809.unnamed_1.root, _e758.w));
                        }
                        let _e817 = phi_933_;
                        phi_939_ = 0u;
                        phi_942_ = 0u;
                        loop {
                            let _e827 = phi_939_;
                            let _e829 = phi_942_;
                            local_1 = _e829;
                            local_2 = _e829;
                            local_3 = _e829;
                            let _e830 = (_e827 < 8u);
                            if _e830 {
                                let _e832 = (_e827 >> bitcast<u32>(2i));
                                let _e833 = (_e827 & 3u);
                                if (_e832 == 0u) {
                                    phi_956_ = _e679.unnamed.root;
                                } else {
                                    phi_956_ = _e679.unnamed.first_primitive;
                                }
                                let _e836 = phi_956_;
                                if (_e832 == 0u) {
                                    phi_966_ = _e748.unnamed.root;
                                } else {
                                    phi_966_ = _e748.unnamed.first_primitive;
                                }
                                let _e845 = phi_966_;
                                if (_e832 == 0u) {
                                    phi_976_ = _e817.unnamed.root;
                                } else {
                                    phi_976_ = _e817.unnamed.first_primitive;
                                }
                                let _e854 = phi_976_;
                                let _e867 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e836 >> bitcast<u32>(((_e833 * 8u) & 31u))) & 255u)) * _e589) + (_e610 - _e353)), ((f32(((_e845 >> bitcast<u32>(((_e833 * 8u) & 31u))) & 255u)) * _e590) + (_e611 - _e354)));
                                let _e868 = core_intrinsics_maximum_number_nsz_f32_(_e867, ((f32(((_e854 >> bitcast<u32>(((_e833 * 8u) & 31u))) & 255u)) * _e591) + (_e612 - _e355)));
                                if (_e832 == 0u) {
                                    phi_994_ = _e679.unnamed_1.root;
                                } else {
                                    phi_994_ = _e679.unnamed_1.first_primitive;
                                }
                                let _e871 = phi_994_;
                                if (_e832 == 0u) {
                                    phi_1004_ = _e748.unnamed_1.root;
                                } else {
                                    phi_1004_ = _e748.unnamed_1.first_primitive;
                                }
                                let _e880 = phi_1004_;
                                if (_e832 == 0u) {
                                    phi_1014_ = _e817.unnamed_1.root;
                                } else {
                                    phi_1014_ = _e817.unnamed_1.first_primitive;
                                }
                                let _e889 = phi_1014_;
                                let _e902 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e871 >> bitcast<u32>(((_e833 * 8u) & 31u))) & 255u)) * _e589) + (_e610 + _e353)), ((f32(((_e880 >> bitcast<u32>(((_e833 * 8u) & 31u))) & 255u)) * _e590) + (_e611 + _e354)));
                                let _e903 = core_intrinsics_minimum_number_nsz_f32_(_e902, ((f32(((_e889 >> bitcast<u32>(((_e833 * 8u) & 31u))) & 255u)) * _e591) + (_e612 + _e355)));
                                if (_e868 <= _e903) {
                                    if (_e868 <= _e553.t) {
                                        if (_e903 >= _e138.tmin) {
                                            if (_e832 == 0u) {
                                                let _e910 = nodes.member[(0u + _e555)].links[2u];
                                                phi_1050_ = _e910;
                                            } else {
                                                let _e913 = nodes.member[(0u + _e555)].links[3u];
                                                phi_1050_ = _e913;
                                            }
                                            let _e915 = phi_1050_;
                                            let _e920 = ((_e915 >> bitcast<u32>(((_e833 * 8u) & 31u))) & 255u);
                                            let _e921 = (_e920 & 31u);
                                            if (_e921 >= 24u) {
                                                phi_1063_ = (24u + ((_e921 - 24u) ^ _e415));
                                            } else {
                                                phi_1063_ = _e921;
                                            }
                                            let _e927 = phi_1063_;
                                            phi_1068_ = (_e829 | ((_e920 >> bitcast<u32>(5i)) << bitcast<u32>((_e927 & 31u))));
                                        } else {
                                            phi_1068_ = _e829;
                                        }
                                        let _e935 = phi_1068_;
                                        phi_1069_ = _e935;
                                    } else {
                                        phi_1069_ = _e829;
                                    }
                                    let _e937 = phi_1069_;
                                    phi_1070_ = _e937;
                                } else {
                                    phi_1070_ = _e829;
                                }
                                let _e939 = phi_1070_;
                                phi_940_ = (_e827 + 1u);
                                phi_943_ = _e939;
                            } else {
                                phi_940_ = u32();
                                phi_943_ = u32();
                            }
                            let _e942 = phi_940_;
                            let _e944 = phi_943_;
                            continue;
                            continuing {
                                phi_939_ = _e942;
                                phi_942_ = _e944;
                                break if !(_e830);
                            }
                        }
                        let _e948 = nodes.member[(0u + _e555)].links[0u];
                        let _e952 = nodes.member[(0u + _e555)].frame[3u];
                        let _e956 = local_1;
                        if ((_e956 & 4278190080u) == 0u) {
                        } else {
                            let _e960 = local.group_mask;
                            if ((_e960 & 4278190080u) == 0u) {
                            } else {
                                let _e964 = local.len;
                                if (_e964 < 32u) {
                                    let _e967 = local.group;
                                    let _e969 = local.len;
                                    if (_e969 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.first[(0u + _e969)] = _e967;
                                    let _e975 = local.group_mask;
                                    let _e977 = local.len;
                                    if (_e977 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.mask[(0u + _e977)] = _e975;
                                    let _e984 = local.len;
                                    local.len = (_e984 + 1u);
                                }
                            }
                            local.group = (0u + _e948);
                            let _e988 = local_2;
                            local.group_mask = ((_e988 & 4278190080u) | (_e952 >> bitcast<u32>(24i)));
                        }
                        let _e993 = local_3;
                        phi_1128_ = _e553;
                        phi_1131_ = (_e993 & 16777215u);
                        loop {
                            let _e996 = phi_1128_;
                            let _e998 = phi_1131_;
                            local_4 = _e996;
                            if (_e998 == 0u) {
                                phi_1129_ = lt_bvh_Hit();
                                phi_1132_ = u32();
                                phi_1691_ = false;
                            } else {
                                let _e1002 = nodes.member[(0u + _e555)].links[1u];
                                let _e1007 = ((0u + _e1002) + select(firstTrailingBit(_e998), 32u, (_e998 == 0u)));
                                if (_e1007 < _e68) {
                                } else {
                                    return;
                                }
                                let _e1014 = triangles.member[(0u + _e1007)].v0_;
                                let _e1017 = (_e1014.x - _e138.origin.x);
                                let _e1020 = (_e1014.y - _e138.origin.y);
                                let _e1023 = (_e1014.z - _e138.origin.z);
                                if (_e380 == 0u) {
                                    phi_1178_ = vec3<f32>(_e1020, _e1023, _e1017);
                                } else {
                                    if (_e380 == 1u) {
                                        phi_1177_ = vec3<f32>(_e1023, _e1017, _e1020);
                                    } else {
                                        phi_1177_ = (_e1014 - _e138.origin);
                                    }
                                    let _e1030 = phi_1177_;
                                    phi_1178_ = _e1030;
                                }
                                let _e1032 = phi_1178_;
                                let _e1036 = (_e1032.x - (_e399 * _e1032.z));
                                let _e1040 = (_e1032.y - (_e402 * _e1032.z));
                                let _e1044 = triangles.member[(0u + _e1007)].v1_;
                                let _e1047 = (_e1044.x - _e138.origin.x);
                                let _e1050 = (_e1044.y - _e138.origin.y);
                                let _e1053 = (_e1044.z - _e138.origin.z);
                                if (_e380 == 0u) {
                                    phi_1212_ = vec3<f32>(_e1050, _e1053, _e1047);
                                } else {
                                    if (_e380 == 1u) {
                                        phi_1211_ = vec3<f32>(_e1053, _e1047, _e1050);
                                    } else {
                                        phi_1211_ = (_e1044 - _e138.origin);
                                    }
                                    let _e1060 = phi_1211_;
                                    phi_1212_ = _e1060;
                                }
                                let _e1062 = phi_1212_;
                                let _e1066 = (_e1062.x - (_e399 * _e1062.z));
                                let _e1070 = (_e1062.y - (_e402 * _e1062.z));
                                let _e1074 = triangles.member[(0u + _e1007)].v2_;
                                let _e1077 = (_e1074.x - _e138.origin.x);
                                let _e1080 = (_e1074.y - _e138.origin.y);
                                let _e1083 = (_e1074.z - _e138.origin.z);
                                if (_e380 == 0u) {
                                    phi_1246_ = vec3<f32>(_e1080, _e1083, _e1077);
                                } else {
                                    if (_e380 == 1u) {
                                        phi_1245_ = vec3<f32>(_e1083, _e1077, _e1080);
                                    } else {
                                        phi_1245_ = (_e1074 - _e138.origin);
                                    }
                                    let _e1090 = phi_1245_;
                                    phi_1246_ = _e1090;
                                }
                                let _e1092 = phi_1246_;
                                let _e1096 = (_e1092.x - (_e399 * _e1092.z));
                                let _e1100 = (_e1092.y - (_e402 * _e1092.z));
                                if (_e1066 < _e1096) {
                                    phi_1267_ = true;
                                } else {
                                    if (_e1066 == _e1096) {
                                        phi_1266_ = (_e1070 < _e1100);
                                    } else {
                                        phi_1266_ = false;
                                    }
                                    let _e1107 = phi_1266_;
                                    phi_1267_ = _e1107;
                                }
                                let _e1109 = phi_1267_;
                                if _e1109 {
                                    phi_1271_ = _e1100;
                                    phi_1272_ = _e1096;
                                    phi_1273_ = _e1070;
                                    phi_1274_ = _e1066;
                                } else {
                                    phi_1271_ = _e1070;
                                    phi_1272_ = _e1066;
                                    phi_1273_ = _e1100;
                                    phi_1274_ = _e1096;
                                }
                                let _e1111 = phi_1271_;
                                let _e1113 = phi_1272_;
                                let _e1115 = phi_1273_;
                                let _e1117 = phi_1274_;
                                let _e1120 = ((_e1117 * _e1111) - (_e1115 * _e1113));
                                if _e1109 {
                                    phi_1282_ = -(_e1120);
                                } else {
                                    phi_1282_ = _e1120;
                                }
                                let _e1123 = phi_1282_;
                                if (_e1096 < _e1036) {
                                    phi_1293_ = true;
                                } else {
                                    if (_e1096 == _e1036) {
                                        phi_1292_ = (_e1100 < _e1040);
                                    } else {
                                        phi_1292_ = false;
                                    }
                                    let _e1128 = phi_1292_;
                                    phi_1293_ = _e1128;
                                }
                                let _e1130 = phi_1293_;
                                if _e1130 {
                                    phi_1297_ = _e1040;
                                    phi_1298_ = _e1036;
                                    phi_1299_ = _e1100;
                                    phi_1300_ = _e1096;
                                } else {
                                    phi_1297_ = _e1100;
                                    phi_1298_ = _e1096;
                                    phi_1299_ = _e1040;
                                    phi_1300_ = _e1036;
                                }
                                let _e1132 = phi_1297_;
                                let _e1134 = phi_1298_;
                                let _e1136 = phi_1299_;
                                let _e1138 = phi_1300_;
                                let _e1141 = ((_e1138 * _e1132) - (_e1136 * _e1134));
                                if _e1130 {
                                    phi_1308_ = -(_e1141);
                                } else {
                                    phi_1308_ = _e1141;
                                }
                                let _e1144 = phi_1308_;
                                if (_e1036 < _e1066) {
                                    phi_1319_ = true;
                                } else {
                                    if (_e1036 == _e1066) {
                                        phi_1318_ = (_e1040 < _e1070);
                                    } else {
                                        phi_1318_ = false;
                                    }
                                    let _e1149 = phi_1318_;
                                    phi_1319_ = _e1149;
                                }
                                let _e1151 = phi_1319_;
                                if _e1151 {
                                    phi_1323_ = _e1070;
                                    phi_1324_ = _e1066;
                                    phi_1325_ = _e1040;
                                    phi_1326_ = _e1036;
                                } else {
                                    phi_1323_ = _e1040;
                                    phi_1324_ = _e1036;
                                    phi_1325_ = _e1070;
                                    phi_1326_ = _e1066;
                                }
                                let _e1153 = phi_1323_;
                                let _e1155 = phi_1324_;
                                let _e1157 = phi_1325_;
                                let _e1159 = phi_1326_;
                                let _e1162 = ((_e1159 * _e1153) - (_e1157 * _e1155));
                                if _e1151 {
                                    phi_1334_ = -(_e1162);
                                } else {
                                    phi_1334_ = _e1162;
                                }
                                let _e1165 = phi_1334_;
                                if (_e1123 >= 0f) {
                                    if (_e1144 >= 0f) {
                                        if (_e1165 >= 0f) {
                                            phi_1349_ = ((_e1123 + _e1144) + _e1165);
                                            phi_1350_ = false;
                                        } else {
                                            phi_1349_ = f32();
                                            phi_1350_ = true;
                                        }
                                        let _e1172 = phi_1349_;
                                        let _e1174 = phi_1350_;
                                        phi_1351_ = _e1172;
                                        phi_1352_ = _e1174;
                                    } else {
                                        phi_1351_ = f32();
                                        phi_1352_ = true;
                                    }
                                    let _e1176 = phi_1351_;
                                    let _e1178 = phi_1352_;
                                    phi_1353_ = _e1176;
                                    phi_1354_ = _e1178;
                                } else {
                                    phi_1353_ = f32();
                                    phi_1354_ = true;
                                }
                                let _e1180 = phi_1353_;
                                let _e1182 = phi_1354_;
                                if _e1182 {
                                    if (_e1123 <= 0f) {
                                        if (_e1144 <= 0f) {
                                            let _e1185 = (_e1165 <= 0f);
                                            if _e1185 {
                                            }
                                            phi_1372_ = ((_e1123 + _e1144) + _e1165);
                                            phi_1373_ = false;
                                            phi_1374_ = _e1185;
                                        } else {
                                            phi_1372_ = f32();
                                            phi_1373_ = true;
                                            phi_1374_ = false;
                                        }
                                        let _e1189 = phi_1372_;
                                        let _e1191 = phi_1373_;
                                        let _e1193 = phi_1374_;
                                        phi_1375_ = _e1189;
                                        phi_1376_ = _e1191;
                                        phi_1377_ = _e1193;
                                    } else {
                                        phi_1375_ = f32();
                                        phi_1376_ = true;
                                        phi_1377_ = false;
                                    }
                                    let _e1195 = phi_1375_;
                                    let _e1197 = phi_1376_;
                                    let _e1199 = phi_1377_;
                                    if _e1197 {
                                        phi_1381_ = false;
                                    } else {
                                        phi_1381_ = _e1199;
                                    }
                                    let _e1201 = phi_1381_;
                                    phi_1382_ = _e1195;
                                    phi_1383_ = _e1201;
                                } else {
                                    phi_1382_ = _e1180;
                                    phi_1383_ = true;
                                }
                                let _e1203 = phi_1382_;
                                let _e1205 = phi_1383_;
                                if _e1205 {
                                    let _e1206 = (_e1203 == 0f);
                                    if _e1206 {
                                        phi_1604_ = lt_bvh_triangle_Intersection();
                                        phi_1605_ = false;
                                    } else {
                                        let _e1212 = ((((_e1123 * (_e404 * _e1032.z)) + (_e1144 * (_e404 * _e1062.z))) + (_e1165 * (_e404 * _e1092.z))) / _e1203);
                                        if (_e1212 > _e138.tmin) {
                                            if (_e1212 < _e138.tmax) {
                                                let _e1218 = triangles.member[(0u + _e1007)].v0_;
                                                let _e1220 = triangles.member[(0u + _e1007)].v1_;
                                                if (_e1218.x < _e1220.x) {
                                                    phi_1419_ = _e1218.x;
                                                } else {
                                                    phi_1419_ = _e1220.x;
                                                }
                                                let _e1227 = phi_1419_;
                                                if (_e1218.y < _e1220.y) {
                                                    phi_1428_ = _e1218.y;
                                                } else {
                                                    phi_1428_ = _e1220.y;
                                                }
                                                let _e1234 = phi_1428_;
                                                if (_e1218.z < _e1220.z) {
                                                    phi_1437_ = _e1218.z;
                                                } else {
                                                    phi_1437_ = _e1220.z;
                                                }
                                                let _e1241 = phi_1437_;
                                                let _e1243 = triangles.member[(0u + _e1007)].v2_;
                                                if (_e1227 < _e1243.x) {
                                                    phi_1446_ = _e1227;
                                                } else {
                                                    phi_1446_ = _e1243.x;
                                                }
                                                let _e1248 = phi_1446_;
                                                if (_e1234 < _e1243.y) {
                                                    phi_1453_ = _e1234;
                                                } else {
                                                    phi_1453_ = _e1243.y;
                                                }
                                                let _e1253 = phi_1453_;
                                                if (_e1241 < _e1243.z) {
                                                    phi_1460_ = _e1241;
                                                } else {
                                                    phi_1460_ = _e1243.z;
                                                }
                                                let _e1258 = phi_1460_;
                                                let _e1260 = triangles.member[(0u + _e1007)].v0_;
                                                let _e1262 = triangles.member[(0u + _e1007)].v1_;
                                                if (_e1260.x > _e1262.x) {
                                                    phi_1473_ = _e1260.x;
                                                } else {
                                                    phi_1473_ = _e1262.x;
                                                }
                                                let _e1269 = phi_1473_;
                                                if (_e1260.y > _e1262.y) {
                                                    phi_1482_ = _e1260.y;
                                                } else {
                                                    phi_1482_ = _e1262.y;
                                                }
                                                let _e1276 = phi_1482_;
                                                if (_e1260.z > _e1262.z) {
                                                    phi_1491_ = _e1260.z;
                                                } else {
                                                    phi_1491_ = _e1262.z;
                                                }
                                                let _e1283 = phi_1491_;
                                                let _e1285 = triangles.member[(0u + _e1007)].v2_;
                                                if (_e1269 > _e1285.x) {
                                                    phi_1500_ = _e1269;
                                                } else {
                                                    phi_1500_ = _e1285.x;
                                                }
                                                let _e1290 = phi_1500_;
                                                if (_e1276 > _e1285.y) {
                                                    phi_1507_ = _e1276;
                                                } else {
                                                    phi_1507_ = _e1285.y;
                                                }
                                                let _e1295 = phi_1507_;
                                                if (_e1283 > _e1285.z) {
                                                    phi_1514_ = _e1283;
                                                } else {
                                                    phi_1514_ = _e1285.z;
                                                }
                                                let _e1300 = phi_1514_;
                                                let _e1307 = ((_e1248 - _e138.origin.x) * _e292);
                                                let _e1308 = ((_e1253 - _e138.origin.y) * _e304);
                                                let _e1309 = ((_e1258 - _e138.origin.z) * _e316);
                                                let _e1316 = ((_e1290 - _e138.origin.x) * _e292);
                                                let _e1317 = ((_e1295 - _e138.origin.y) * _e304);
                                                let _e1318 = ((_e1300 - _e138.origin.z) * _e316);
                                                if (_e1307 < _e1316) {
                                                    phi_1537_ = _e1307;
                                                } else {
                                                    phi_1537_ = _e1316;
                                                }
                                                let _e1321 = phi_1537_;
                                                if (_e1308 < _e1317) {
                                                    phi_1542_ = _e1308;
                                                } else {
                                                    phi_1542_ = _e1317;
                                                }
                                                let _e1324 = phi_1542_;
                                                if (_e1309 < _e1318) {
                                                    phi_1547_ = _e1309;
                                                } else {
                                                    phi_1547_ = _e1318;
                                                }
                                                let _e1327 = phi_1547_;
                                                if (_e1307 > _e1316) {
                                                    phi_1555_ = _e1307;
                                                } else {
                                                    phi_1555_ = _e1316;
                                                }
                                                let _e1333 = phi_1555_;
                                                if (_e1308 > _e1317) {
                                                    phi_1560_ = _e1308;
                                                } else {
                                                    phi_1560_ = _e1317;
                                                }
                                                let _e1336 = phi_1560_;
                                                if (_e1309 > _e1318) {
                                                    phi_1565_ = _e1309;
                                                } else {
                                                    phi_1565_ = _e1318;
                                                }
                                                let _e1339 = phi_1565_;
                                                let _e1343 = core_intrinsics_maximum_number_nsz_f32_((_e1321 - _e360), (_e1324 - _e361));
                                                let _e1344 = core_intrinsics_maximum_number_nsz_f32_(_e1343, (_e1327 - _e362));
                                                let _e1345 = core_intrinsics_minimum_number_nsz_f32_((_e1333 + _e360), (_e1336 + _e361));
                                                let _e1346 = core_intrinsics_minimum_number_nsz_f32_(_e1345, (_e1339 + _e362));
                                                if (_e1344 > -300000000000000000000000000000000000000f) {
                                                    phi_1577_ = _e1344;
                                                } else {
                                                    phi_1577_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1349 = phi_1577_;
                                                if (_e1346 < 300000000000000000000000000000000000000f) {
                                                    phi_1582_ = _e1346;
                                                } else {
                                                    phi_1582_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1352 = phi_1582_;
                                                if (_e1212 < _e1349) {
                                                    phi_1587_ = _e1349;
                                                } else {
                                                    phi_1587_ = _e1212;
                                                }
                                                let _e1355 = phi_1587_;
                                                if (_e1355 > _e1352) {
                                                    phi_1592_ = _e1352;
                                                } else {
                                                    phi_1592_ = _e1355;
                                                }
                                                let _e1358 = phi_1592_;
                                                phi_1597_ = lt_bvh_triangle_Intersection(_e1358, (_e1144 / _e1203), (_e1165 / _e1203), (_e1349 <= _e1352));
                                                phi_1598_ = false;
                                            } else {
                                                phi_1597_ = lt_bvh_triangle_Intersection();
                                                phi_1598_ = true;
                                            }
                                            let _e1364 = phi_1597_;
                                            let _e1366 = phi_1598_;
                                            phi_1599_ = _e1364;
                                            phi_1600_ = _e1366;
                                        } else {
                                            phi_1599_ = lt_bvh_triangle_Intersection();
                                            phi_1600_ = true;
                                        }
                                        let _e1368 = phi_1599_;
                                        let _e1370 = phi_1600_;
                                        if _e1370 {
                                        }
                                        phi_1604_ = _e1368;
                                        phi_1605_ = _e1370;
                                    }
                                    let _e1372 = phi_1604_;
                                    let _e1374 = phi_1605_;
                                    phi_1606_ = _e1372;
                                    phi_1607_ = _e1206;
                                    phi_1608_ = _e1374;
                                } else {
                                    phi_1606_ = lt_bvh_triangle_Intersection();
                                    phi_1607_ = true;
                                    phi_1608_ = false;
                                }
                                let _e1376 = phi_1606_;
                                let _e1378 = phi_1607_;
                                let _e1380 = phi_1608_;
                                if _e1378 {
                                    phi_1612_ = true;
                                } else {
                                    phi_1612_ = _e1380;
                                }
                                let _e1382 = phi_1612_;
                                if _e1382 {
                                    phi_1616_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1616_ = _e1376;
                                }
                                let _e1384 = phi_1616_;
                                if _e1384.is_hit {
                                    if (_e1384.t > _e138.tmin) {
                                        if (_e1384.t < _e996.t) {
                                            phi_1665_ = true;
                                        } else {
                                            if (_e1384.t == _e996.t) {
                                                if (_e996.triangle != 4294967295u) {
                                                    if (_e1007 < _e996.triangle) {
                                                        phi_1656_ = true;
                                                    } else {
                                                        if (_e1007 == _e996.triangle) {
                                                            phi_1655_ = (4294967295u < _e996.instance);
                                                        } else {
                                                            phi_1655_ = false;
                                                        }
                                                        let _e1403 = phi_1655_;
                                                        phi_1656_ = _e1403;
                                                    }
                                                    let _e1405 = phi_1656_;
                                                    phi_1657_ = _e1405;
                                                    phi_1658_ = false;
                                                } else {
                                                    phi_1657_ = bool();
                                                    phi_1658_ = true;
                                                }
                                                let _e1407 = phi_1657_;
                                                let _e1409 = phi_1658_;
                                                phi_1659_ = _e1407;
                                                phi_1660_ = _e1409;
                                            } else {
                                                phi_1659_ = bool();
                                                phi_1660_ = true;
                                            }
                                            let _e1411 = phi_1659_;
                                            let _e1413 = phi_1660_;
                                            if _e1413 {
                                                phi_1664_ = false;
                                            } else {
                                                phi_1664_ = _e1411;
                                            }
                                            let _e1415 = phi_1664_;
                                            phi_1665_ = _e1415;
                                        }
                                        let _e1417 = phi_1665_;
                                        if _e1417 {
                                            let _e1419 = triangles.member[(0u + _e1007)].i0_;
                                            if ((_e1419 & 2147483648u) == 0u) {
                                                phi_1679_ = true;
                                            } else {
                                                if true {
                                                }
                                                phi_1679_ = true;
                                            }
                                            let _e1423 = phi_1679_;
                                            if _e1423 {
                                                phi_1687_ = lt_bvh_Hit(_e1384.t, _e1384.u, _e1384.v, _e1007, 4294967295u);
                                            } else {
                                                phi_1687_ = _e996;
                                            }
                                            let _e1429 = phi_1687_;
                                            phi_1688_ = _e1429;
                                        } else {
                                            phi_1688_ = _e996;
                                        }
                                        let _e1431 = phi_1688_;
                                        phi_1689_ = _e1431;
                                    } else {
                                        phi_1689_ = _e996;
                                    }
                                    let _e1433 = phi_1689_;
                                    phi_1690_ = _e1433;
                                } else {
                                    phi_1690_ = _e996;
                                }
                                let _e1435 = phi_1690_;
                                phi_1129_ = _e1435;
                                phi_1132_ = (_e998 & (_e998 - 1u));
                                phi_1691_ = true;
                            }
                            let _e1437 = phi_1129_;
                            let _e1439 = phi_1132_;
                            let _e1441 = phi_1691_;
                            continue;
                            continuing {
                                phi_1128_ = _e1437;
                                phi_1131_ = _e1439;
                                break if !(_e1441);
                            }
                        }
                        let _e1444 = local.group_mask;
                        if ((_e1444 & 4278190080u) == 0u) {
                            let _e1448 = local.len;
                            if (_e1448 == 0u) {
                                phi_1730_ = false;
                            } else {
                                let _e1452 = local.len;
                                local.len = (_e1452 - 1u);
                                let _e1455 = local.len;
                                if (_e1455 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1460 = local.first[(0u + _e1455)];
                                local.group = _e1460;
                                let _e1463 = local.len;
                                if (_e1463 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1468 = local.mask[(0u + _e1463)];
                                local.group_mask = _e1468;
                                phi_1730_ = true;
                            }
                            let _e1471 = phi_1730_;
                            phi_1731_ = _e1471;
                        } else {
                            phi_1731_ = true;
                        }
                        let _e1473 = phi_1731_;
                        if _e1473 {
                            let _e1475 = local.group_mask;
                            let _e1481 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1475)), 32u, (_e1475 == 0u)));
                            let _e1485 = local.group_mask;
                            let _e1499 = local.group_mask;
                            local.group_mask = (_e1499 & ~((1u << bitcast<u32>((_e1481 & 31u)))));
                            let _e1502 = local.group;
                            phi_1762_ = (_e1502 + countOneBits(((_e1485 & ~((4294967295u << bitcast<u32>((((_e1481 - 24u) ^ _e415) & 31u))))) & 255u)));
                        } else {
                            phi_1762_ = 4294967295u;
                        }
                        let _e1505 = phi_1762_;
                        let _e2199 = local_4;
                        phi_792_ = _e2199;
                        phi_795_ = _e1505;
                    } else {
                        phi_792_ = lt_bvh_Hit();
                        phi_795_ = u32();
                    }
                    let _e1507 = phi_792_;
                    let _e1509 = phi_795_;
                    continue;
                    continuing {
                        phi_791_ = _e1507;
                        phi_794_ = _e1509;
                        break if !(_e556);
                    }
                }
                let _e2203 = local_5;
                phi_1763_ = _e2203;
            }
            let _e1512 = phi_1763_;
            phi_1764_ = _e1512;
            phi_1765_ = _e210;
        } else {
            phi_1764_ = lt_bvh_Hit();
            phi_1765_ = true;
        }
        let _e1514 = phi_1764_;
        let _e1516 = phi_1765_;
        if _e1516 {
            phi_1769_ = _e140;
        } else {
            phi_1769_ = _e1514;
        }
        let _e1518 = phi_1769_;
        if (_e1518.triangle != 4294967295u) {
            let _e1524 = ((1f - _e1518.u) - _e1518.v);
            if (_e1518.triangle < _e68) {
            } else {
                return;
            }
            let _e1530 = triangles.member[(0u + _e1518.triangle)];
            let _e1555 = (((_e1530.v0_.x * _e1524) + (_e1530.v1_.x * _e1518.u)) + (_e1530.v2_.x * _e1518.v));
            let _e1556 = (((_e1530.v0_.y * _e1524) + (_e1530.v1_.y * _e1518.u)) + (_e1530.v2_.y * _e1518.v));
            let _e1557 = (((_e1530.v0_.z * _e1524) + (_e1530.v1_.z * _e1518.u)) + (_e1530.v2_.z * _e1518.v));
            let _e1560 = abs(_e1530.v0_.x);
            let _e1562 = abs(_e1530.v0_.y);
            let _e1564 = abs(_e1530.v0_.z);
            let _e1566 = abs(_e1530.v1_.x);
            let _e1568 = abs(_e1530.v1_.y);
            let _e1570 = abs(_e1530.v1_.z);
            if (_e1560 > _e1566) {
                phi_1834_ = _e1560;
            } else {
                phi_1834_ = _e1566;
            }
            let _e1573 = phi_1834_;
            if (_e1562 > _e1568) {
                phi_1839_ = _e1562;
            } else {
                phi_1839_ = _e1568;
            }
            let _e1576 = phi_1839_;
            if (_e1564 > _e1570) {
                phi_1844_ = _e1564;
            } else {
                phi_1844_ = _e1570;
            }
            let _e1579 = phi_1844_;
            let _e1581 = abs(_e1530.v2_.x);
            let _e1583 = abs(_e1530.v2_.y);
            let _e1585 = abs(_e1530.v2_.z);
            if (_e1573 > _e1581) {
                phi_1855_ = _e1573;
            } else {
                phi_1855_ = _e1581;
            }
            let _e1588 = phi_1855_;
            if (_e1576 > _e1583) {
                phi_1860_ = _e1576;
            } else {
                phi_1860_ = _e1583;
            }
            let _e1591 = phi_1860_;
            if (_e1579 > _e1585) {
                phi_1865_ = _e1579;
            } else {
                phi_1865_ = _e1585;
            }
            let _e1594 = phi_1865_;
            let _e1597 = (_e1530.v1_.x - _e1530.v0_.x);
            let _e1600 = (_e1530.v1_.y - _e1530.v0_.y);
            let _e1603 = (_e1530.v1_.z - _e1530.v0_.z);
            let _e1606 = (_e1530.v2_.x - _e1530.v0_.x);
            let _e1609 = (_e1530.v2_.y - _e1530.v0_.y);
            let _e1612 = (_e1530.v2_.z - _e1530.v0_.z);
            let _e1616 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1600), abs(_e1603));
            let _e1617 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1597), _e1616);
            let _e1618 = (_e1597 / _e1617);
            let _e1619 = (_e1600 / _e1617);
            let _e1620 = (_e1603 / _e1617);
            let _e1624 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1609), abs(_e1612));
            let _e1625 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1606), _e1624);
            let _e1626 = (_e1606 / _e1625);
            let _e1627 = (_e1609 / _e1625);
            let _e1628 = (_e1612 / _e1625);
            let _e1631 = ((_e1619 * _e1628) - (_e1627 * _e1620));
            let _e1634 = ((_e1620 * _e1626) - (_e1628 * _e1618));
            let _e1637 = ((_e1618 * _e1627) - (_e1626 * _e1619));
            let _e1639 = p.member.eye;
            let _e1652 = (1f / sqrt((((_e1631 * _e1631) + (_e1634 * _e1634)) + (_e1637 * _e1637))));
            let _e1653 = (_e1631 * _e1652);
            let _e1654 = (_e1634 * _e1652);
            let _e1655 = (_e1637 * _e1652);
            if ((((_e1653 * (_e1639.x - _e1555)) + (_e1654 * (_e1639.y - _e1556))) + (_e1655 * (_e1639.z - _e1557))) < 0f) {
                phi_1941_ = vec3<f32>(-(_e1653), -(_e1654), -(_e1655));
            } else {
                phi_1941_ = vec3<f32>(_e1653, _e1654, _e1655);
            }
            let _e1668 = phi_1941_;
            if (_e1518.triangle < _e68) {
            } else {
                return;
            }
            let _e1673 = triangles.member[(0u + _e1518.triangle)];
            let _e1675 = (_e1673.i0_ & 2147483647u);
            if (_e1675 < _e71) {
            } else {
                return;
            }
            let _e1681 = vertices.member[(0u + _e1675)];
            if (_e1673.i1_ < _e71) {
            } else {
                return;
            }
            let _e1685 = vertices.member[(0u + _e1673.i1_)];
            if (_e1673.i2_ < _e71) {
            } else {
                return;
            }
            let _e1689 = vertices.member[(0u + _e1673.i2_)];
            let _e1690 = array<abi_Vertex, 3>(_e1681, _e1685, _e1689);
            if (_e1690[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e1696 = materials.member[(0u + _e1690[0].material)];
            let _e1713 = (1f / 255f);
            let _e1732 = (1f / 255f);
            let _e1754 = (1f / 255f);
            let _e1767 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e1524, _e1518.u, _e1518.v));
            let _e1769 = ((_e1696.base_color.x * ((((f32((_e1690[0].color & 255u)) * _e1713) * _e1524) + ((f32((_e1690[1].color & 255u)) * _e1732) * _e1518.u)) + ((f32((_e1690[2].color & 255u)) * _e1754) * _e1518.v))) * _e1767.x);
            let _e1771 = ((_e1696.base_color.y * ((((f32(((_e1690[0].color >> bitcast<u32>(8i)) & 255u)) * _e1713) * _e1524) + ((f32(((_e1690[1].color >> bitcast<u32>(8i)) & 255u)) * _e1732) * _e1518.u)) + ((f32(((_e1690[2].color >> bitcast<u32>(8i)) & 255u)) * _e1754) * _e1518.v))) * _e1767.y);
            let _e1773 = ((_e1696.base_color.z * ((((f32(((_e1690[0].color >> bitcast<u32>(16i)) & 255u)) * _e1713) * _e1524) + ((f32(((_e1690[1].color >> bitcast<u32>(16i)) & 255u)) * _e1732) * _e1518.u)) + ((f32(((_e1690[2].color >> bitcast<u32>(16i)) & 255u)) * _e1754) * _e1518.v))) * _e1767.z);
            let _e1774 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1591, _e1594);
            let _e1775 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1588, _e1774);
            if ((_e1696.flags & 2u) == 0u) {
                phi_2062_ = 0u;
            } else {
                phi_2062_ = 1u;
            }
            let _e1780 = phi_2062_;
            if (_e1690[0].normal == 2147516416u) {
                phi_2265_ = _e1668;
            } else {
                let _e1793 = (f32((bitcast<i32>((_e1690[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1799 = (f32((bitcast<i32>(_e1690[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1803 = ((1f - abs(_e1793)) - abs(_e1799));
                if (_e1803 < 0f) {
                    phi_2089_ = -(_e1803);
                } else {
                    phi_2089_ = 0f;
                }
                let _e1807 = phi_2089_;
                if (_e1793 < 0f) {
                    phi_2096_ = (_e1793 + _e1807);
                } else {
                    phi_2096_ = (_e1793 - _e1807);
                }
                let _e1812 = phi_2096_;
                if (_e1799 < 0f) {
                    phi_2103_ = (_e1799 + _e1807);
                } else {
                    phi_2103_ = (_e1799 - _e1807);
                }
                let _e1817 = phi_2103_;
                let _e1824 = (1f / sqrt((((_e1812 * _e1812) + (_e1817 * _e1817)) + (_e1803 * _e1803))));
                let _e1840 = (f32((bitcast<i32>((_e1690[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1846 = (f32((bitcast<i32>(_e1690[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1850 = ((1f - abs(_e1840)) - abs(_e1846));
                if (_e1850 < 0f) {
                    phi_2138_ = -(_e1850);
                } else {
                    phi_2138_ = 0f;
                }
                let _e1854 = phi_2138_;
                if (_e1840 < 0f) {
                    phi_2145_ = (_e1840 + _e1854);
                } else {
                    phi_2145_ = (_e1840 - _e1854);
                }
                let _e1859 = phi_2145_;
                if (_e1846 < 0f) {
                    phi_2152_ = (_e1846 + _e1854);
                } else {
                    phi_2152_ = (_e1846 - _e1854);
                }
                let _e1864 = phi_2152_;
                let _e1871 = (1f / sqrt((((_e1859 * _e1859) + (_e1864 * _e1864)) + (_e1850 * _e1850))));
                let _e1890 = (f32((bitcast<i32>((_e1690[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1896 = (f32((bitcast<i32>(_e1690[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1900 = ((1f - abs(_e1890)) - abs(_e1896));
                if (_e1900 < 0f) {
                    phi_2190_ = -(_e1900);
                } else {
                    phi_2190_ = 0f;
                }
                let _e1904 = phi_2190_;
                if (_e1890 < 0f) {
                    phi_2197_ = (_e1890 + _e1904);
                } else {
                    phi_2197_ = (_e1890 - _e1904);
                }
                let _e1909 = phi_2197_;
                if (_e1896 < 0f) {
                    phi_2204_ = (_e1896 + _e1904);
                } else {
                    phi_2204_ = (_e1896 - _e1904);
                }
                let _e1914 = phi_2204_;
                let _e1921 = (1f / sqrt((((_e1909 * _e1909) + (_e1914 * _e1914)) + (_e1900 * _e1900))));
                let _e1932 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e1812 * _e1824) * _e1524) + ((_e1859 * _e1871) * _e1518.u)) + ((_e1909 * _e1921) * _e1518.v)), ((((_e1817 * _e1824) * _e1524) + ((_e1864 * _e1871) * _e1518.u)) + ((_e1914 * _e1921) * _e1518.v)), ((((_e1803 * _e1824) * _e1524) + ((_e1850 * _e1871) * _e1518.u)) + ((_e1900 * _e1921) * _e1518.v))));
                let _e1944 = sqrt((((_e1932.x * _e1932.x) + (_e1932.y * _e1932.y)) + (_e1932.z * _e1932.z)));
                if (_e1944 > 0f) {
                    let _e1947 = (_e1932.x / _e1944);
                    let _e1949 = (_e1932.y / _e1944);
                    let _e1951 = (_e1932.z / _e1944);
                    if ((((_e1947 * _e1668.x) + (_e1949 * _e1668.y)) + (_e1951 * _e1668.z)) < 0f) {
                        phi_2263_ = vec3<f32>(-(_e1947), -(_e1949), -(_e1951));
                    } else {
                        phi_2263_ = (_e1932 / vec3(_e1944));
                    }
                    let _e1968 = phi_2263_;
                    phi_2264_ = _e1968;
                } else {
                    phi_2264_ = _e1668;
                }
                let _e1970 = phi_2264_;
                phi_2265_ = _e1970;
            }
            let _e1972 = phi_2265_;
            if (_e1769 > 0f) {
                if (_e1769 < 1f) {
                    phi_2274_ = _e1769;
                } else {
                    phi_2274_ = 1f;
                }
                let _e1976 = phi_2274_;
                phi_2275_ = _e1976;
            } else {
                phi_2275_ = 0f;
            }
            let _e1978 = phi_2275_;
            if (_e1771 > 0f) {
                if (_e1771 < 1f) {
                    phi_2285_ = _e1771;
                } else {
                    phi_2285_ = 1f;
                }
                let _e1983 = phi_2285_;
                phi_2286_ = _e1983;
            } else {
                phi_2286_ = 0f;
            }
            let _e1985 = phi_2286_;
            if (_e1773 > 0f) {
                if (_e1773 < 1f) {
                    phi_2296_ = _e1773;
                } else {
                    phi_2296_ = 1f;
                }
                let _e1990 = phi_2296_;
                phi_2297_ = _e1990;
            } else {
                phi_2297_ = 0f;
            }
            let _e1992 = phi_2297_;
            let _e1995 = ((sqrt(_e1978) * 255f) + 0.5f);
            let _e2004 = ((sqrt(_e1985) * 255f) + 0.5f);
            let _e2016 = ((sqrt(_e1992) * 255f) + 0.5f);
            phi_2332_ = abi_Sample(vec3<f32>(_e1555, _e1556, _e1557), _e1775, _e1668, _e1780, _e1972, ((select(select(u32(_e1995), 0u, (_e1995 < bitcast<f32>(0u))), 4294967295u, (_e1995 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2004), 0u, (_e2004 < bitcast<f32>(0u))), 4294967295u, (_e2004 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2016), 0u, (_e2016 < bitcast<f32>(0u))), 4294967295u, (_e2016 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_2332_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2030 = phi_2332_;
        if (_e83.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e83.first_primitive)] = _e2030;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
