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

struct lt_mask_LightPlace {
    word: u32,
    shift: u32,
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

struct type_25 {
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

struct type_29 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_33 {
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

struct type_37 {
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

struct type_47 {
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
var<storage> vertices: type_33;
@group(0) @binding(4) 
var<storage> materials: type_37;
@group(0) @binding(0) 
var<uniform> p: type_47;
@group(0) @binding(1) 
var<storage> nodes: type_25;
@group(0) @binding(2) 
var<storage> triangles: type_29;
@group(0) @binding(5) 
var<storage, read_write> samples: type_9;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_184_: lt_mask_LightPlace;
    var phi_185_: bool;
    var phi_186_: lt_mask_LightPlace;
    var phi_187_: bool;
    var phi_192_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_184_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_185_ = false;
        } else {
            phi_184_ = lt_mask_LightPlace();
            phi_185_ = true;
        }
        let _e73 = phi_184_;
        let _e75 = phi_185_;
        phi_186_ = _e73;
        phi_187_ = _e75;
    } else {
        phi_186_ = lt_mask_LightPlace();
        phi_187_ = true;
    }
    let _e77 = phi_186_;
    let _e79 = phi_187_;
    if _e79 {
        phi_192_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_192_ = _e77;
    }
    let _e84 = phi_192_;
    return lt_mask_LightPlace(_e84.word, _e84.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_207_: bool;
    var phi_211_: f32;

    if (param_3 != param_3) {
        phi_207_ = true;
    } else {
        let _e63 = (param_4 >= param_3);
        if _e63 {
        }
        phi_207_ = _e63;
    }
    let _e65 = phi_207_;
    if _e65 {
        phi_211_ = param_4;
    } else {
        phi_211_ = param_3;
    }
    let _e67 = phi_211_;
    return _e67;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_223_: bool;
    var phi_227_: f32;

    if (param_5 != param_5) {
        phi_223_ = true;
    } else {
        let _e63 = (param_6 <= param_5);
        if _e63 {
        }
        phi_223_ = _e63;
    }
    let _e65 = phi_223_;
    if _e65 {
        phi_227_ = param_6;
    } else {
        phi_227_ = param_5;
    }
    let _e67 = phi_227_;
    return _e67;
}

fn _lt_bvh_ray_Ray_new(param_7: vec3<f32>, param_8: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_7, 0f, param_8, 300000000000000000000000000000000000000f);
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
    var phi_1209_: vec3<f32>;
    var phi_1210_: vec3<f32>;
    var phi_1241_: vec3<f32>;
    var phi_1242_: vec3<f32>;
    var phi_1260_: bool;
    var phi_1261_: bool;
    var phi_1265_: f32;
    var phi_1266_: f32;
    var phi_1267_: f32;
    var phi_1268_: f32;
    var phi_1276_: f32;
    var phi_1286_: bool;
    var phi_1287_: bool;
    var phi_1291_: f32;
    var phi_1292_: f32;
    var phi_1293_: f32;
    var phi_1294_: f32;
    var phi_1302_: f32;
    var phi_1312_: bool;
    var phi_1313_: bool;
    var phi_1317_: f32;
    var phi_1318_: f32;
    var phi_1319_: f32;
    var phi_1320_: f32;
    var phi_1328_: f32;
    var phi_1343_: f32;
    var phi_1344_: bool;
    var phi_1345_: f32;
    var phi_1346_: bool;
    var phi_1347_: f32;
    var phi_1348_: bool;
    var phi_1366_: f32;
    var phi_1367_: bool;
    var phi_1368_: bool;
    var phi_1369_: f32;
    var phi_1370_: bool;
    var phi_1371_: bool;
    var phi_1375_: bool;
    var phi_1376_: f32;
    var phi_1377_: bool;
    var phi_1407_: vec3<f32>;
    var phi_1408_: vec3<f32>;
    var phi_1433_: vec3<f32>;
    var phi_1434_: vec3<f32>;
    var phi_1459_: vec3<f32>;
    var phi_1460_: vec3<f32>;
    var phi_1518_: f32;
    var phi_1527_: f32;
    var phi_1536_: f32;
    var phi_1545_: f32;
    var phi_1552_: f32;
    var phi_1559_: f32;
    var phi_1572_: f32;
    var phi_1581_: f32;
    var phi_1590_: f32;
    var phi_1599_: f32;
    var phi_1606_: f32;
    var phi_1613_: f32;
    var phi_1636_: f32;
    var phi_1641_: f32;
    var phi_1646_: f32;
    var phi_1654_: f32;
    var phi_1659_: f32;
    var phi_1664_: f32;
    var phi_1676_: f32;
    var phi_1681_: f32;
    var phi_1686_: f32;
    var phi_1691_: f32;
    var phi_1696_: lt_bvh_triangle_Intersection;
    var phi_1697_: bool;
    var phi_1698_: lt_bvh_triangle_Intersection;
    var phi_1699_: bool;
    var phi_1703_: lt_bvh_triangle_Intersection;
    var phi_1704_: bool;
    var phi_1705_: lt_bvh_triangle_Intersection;
    var phi_1706_: bool;
    var phi_1707_: bool;
    var phi_1711_: bool;
    var phi_1715_: lt_bvh_triangle_Intersection;
    var phi_1754_: bool;
    var phi_1755_: bool;
    var phi_1756_: bool;
    var phi_1757_: bool;
    var phi_1758_: bool;
    var phi_1759_: bool;
    var phi_1763_: bool;
    var phi_1764_: bool;
    var phi_1778_: bool;
    var phi_1786_: lt_bvh_Hit;
    var phi_1787_: lt_bvh_Hit;
    var phi_1788_: lt_bvh_Hit;
    var phi_1789_: lt_bvh_Hit;
    var phi_1129_: lt_bvh_Hit;
    var phi_1132_: u32;
    var phi_1790_: bool;
    var phi_1829_: bool;
    var phi_1830_: bool;
    var phi_1861_: u32;
    var phi_792_: lt_bvh_Hit;
    var phi_795_: u32;
    var phi_1862_: lt_bvh_Hit;
    var phi_1863_: lt_bvh_Hit;
    var phi_1864_: bool;
    var phi_1868_: lt_bvh_Hit;
    var phi_1933_: f32;
    var phi_1938_: f32;
    var phi_1943_: f32;
    var phi_1954_: f32;
    var phi_1959_: f32;
    var phi_1964_: f32;
    var phi_2040_: vec3<f32>;
    var phi_2161_: u32;
    var phi_2188_: f32;
    var phi_2195_: f32;
    var phi_2202_: f32;
    var phi_2237_: f32;
    var phi_2244_: f32;
    var phi_2251_: f32;
    var phi_2289_: f32;
    var phi_2296_: f32;
    var phi_2303_: f32;
    var phi_2362_: vec3<f32>;
    var phi_2363_: vec3<f32>;
    var phi_2364_: vec3<f32>;
    var phi_2373_: f32;
    var phi_2374_: f32;
    var phi_2384_: f32;
    var phi_2385_: f32;
    var phi_2395_: f32;
    var phi_2396_: f32;
    var phi_2431_: abi_Sample;
    var local_4: lt_bvh_Hit;
    var local_5: lt_bvh_Hit;

    let _e61 = id_1;
    let _e65 = arrayLength((&nodes.member));
    let _e68 = arrayLength((&triangles.member));
    let _e71 = arrayLength((&vertices.member));
    let _e80 = p.member.size[0u];
    let _e82 = p.member.size[1u];
    let _e83 = lt_shaders_entry_pixel_index(_e61, _e80, _e82);
    if (bitcast<i32>(_e83.word) != 0i) {
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
                phi_1862_ = lt_bvh_Hit();
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
                            let _e631 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e620.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e637 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e631.unnamed.word, _e620.w), _e631.unnamed_1);
                            let _e643 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e637.unnamed, lt_mask_LightPlace(_e620.x, _e637.unnamed_1.shift));
                            phi_879_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e643.unnamed, lt_mask_LightPlace(_e643.unnamed_1.word, _e620.y));
                        } else {
                            let _e659 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e620.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e665 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e659.unnamed.word, _e620.y), _e659.unnamed_1);
                            let _e671 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e665.unnamed, lt_mask_LightPlace(_e620.z, _e665.unnamed_1.shift));
                            phi_879_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e671.unnamed, lt_mask_LightPlace(_e671.unnamed_1.word, _e620.w));
                        }
                        let _e679 = phi_879_;
                        let _e689 = nodes.member[(0u + _e555)].y;
                        if (_e304 < 0f) {
                            let _e700 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e689.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e706 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e700.unnamed.word, _e689.w), _e700.unnamed_1);
                            let _e712 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e706.unnamed, lt_mask_LightPlace(_e689.x, _e706.unnamed_1.shift));
                            phi_906_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e712.unnamed, lt_mask_LightPlace(_e712.unnamed_1.word, _e689.y));
                        } else {
                            let _e728 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e689.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e734 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e728.unnamed.word, _e689.y), _e728.unnamed_1);
                            let _e740 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e734.unnamed, lt_mask_LightPlace(_e689.z, _e734.unnamed_1.shift));
                            phi_906_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e740.unnamed, lt_mask_LightPlace(_e740.unnamed_1.word, _e689.w));
                        }
                        let _e748 = phi_906_;
                        let _e758 = nodes.member[(0u + _e555)].z;
                        if (_e316 < 0f) {
                            let _e769 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e758.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e775 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e769.unnamed.word, _e758.w), _e769.unnamed_1);
                            let _e781 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e775.unnamed, lt_mask_LightPlace(_e758.x, _e775.unnamed_1.shift));
                            phi_933_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e781.unnamed, lt_mask_LightPlace(_e781.unnamed_1.word, _e758.y));
                        } else {
                            let _e797 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e758.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e803 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e797.unnamed.word, _e758.y), _e797.unnamed_1);
                            let _e809 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e803.unnamed, lt_mask_LightPlace(_e758.z, _e803.unnamed_1.shift));
                            phi_933_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e809.unnamed, lt_mask_LightPlace(_e809.unnamed_1.word, _e758.w));
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
                                    phi_956_ = _e679.unnamed.word;
                                } else {
                                    phi_956_ = _e679.unnamed.shift;
                                }
                                let _e836 = phi_956_;
                                if (_e832 == 0u) {
                                    phi_966_ = _e748.unnamed.word;
                                } else {
                                    phi_966_ = _e748.unnamed.shift;
                                }
                                let _e845 = phi_966_;
                                if (_e832 == 0u) {
                                    phi_976_ = _e817.unnamed.word;
                                } else {
                                    phi_976_ = _e817.unnamed.shift;
                                }
                                let _e854 = phi_976_;
                                let _e867 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e836 >> bitcast<u32>(((_e833 * 8u) & 31u))) & 255u)) * _e589) + (_e610 - _e353)), ((f32(((_e845 >> bitcast<u32>(((_e833 * 8u) & 31u))) & 255u)) * _e590) + (_e611 - _e354)));
                                let _e868 = core_intrinsics_maximum_number_nsz_f32_(_e867, ((f32(((_e854 >> bitcast<u32>(((_e833 * 8u) & 31u))) & 255u)) * _e591) + (_e612 - _e355)));
                                if (_e832 == 0u) {
                                    phi_994_ = _e679.unnamed_1.word;
                                } else {
                                    phi_994_ = _e679.unnamed_1.shift;
                                }
                                let _e871 = phi_994_;
                                if (_e832 == 0u) {
                                    phi_1004_ = _e748.unnamed_1.word;
                                } else {
                                    phi_1004_ = _e748.unnamed_1.shift;
                                }
                                let _e880 = phi_1004_;
                                if (_e832 == 0u) {
                                    phi_1014_ = _e817.unnamed_1.word;
                                } else {
                                    phi_1014_ = _e817.unnamed_1.shift;
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
                                phi_1790_ = false;
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
                                let _e1042 = triangles.member[(0u + _e1007)].v1_;
                                let _e1045 = (_e1042.x - _e138.origin.x);
                                let _e1048 = (_e1042.y - _e138.origin.y);
                                let _e1051 = (_e1042.z - _e138.origin.z);
                                if (_e380 == 0u) {
                                    phi_1210_ = vec3<f32>(_e1048, _e1051, _e1045);
                                } else {
                                    if (_e380 == 1u) {
                                        phi_1209_ = vec3<f32>(_e1051, _e1045, _e1048);
                                    } else {
                                        phi_1209_ = (_e1042 - _e138.origin);
                                    }
                                    let _e1058 = phi_1209_;
                                    phi_1210_ = _e1058;
                                }
                                let _e1060 = phi_1210_;
                                let _e1064 = (_e1060.x - (_e399 * _e1060.z));
                                let _e1068 = (_e1060.y - (_e402 * _e1060.z));
                                let _e1070 = triangles.member[(0u + _e1007)].v2_;
                                let _e1073 = (_e1070.x - _e138.origin.x);
                                let _e1076 = (_e1070.y - _e138.origin.y);
                                let _e1079 = (_e1070.z - _e138.origin.z);
                                if (_e380 == 0u) {
                                    phi_1242_ = vec3<f32>(_e1076, _e1079, _e1073);
                                } else {
                                    if (_e380 == 1u) {
                                        phi_1241_ = vec3<f32>(_e1079, _e1073, _e1076);
                                    } else {
                                        phi_1241_ = (_e1070 - _e138.origin);
                                    }
                                    let _e1086 = phi_1241_;
                                    phi_1242_ = _e1086;
                                }
                                let _e1088 = phi_1242_;
                                let _e1092 = (_e1088.x - (_e399 * _e1088.z));
                                let _e1096 = (_e1088.y - (_e402 * _e1088.z));
                                if (_e1064 < _e1092) {
                                    phi_1261_ = true;
                                } else {
                                    if (_e1064 == _e1092) {
                                        phi_1260_ = (_e1068 < _e1096);
                                    } else {
                                        phi_1260_ = false;
                                    }
                                    let _e1101 = phi_1260_;
                                    phi_1261_ = _e1101;
                                }
                                let _e1103 = phi_1261_;
                                if _e1103 {
                                    phi_1265_ = _e1096;
                                    phi_1266_ = _e1092;
                                    phi_1267_ = _e1068;
                                    phi_1268_ = _e1064;
                                } else {
                                    phi_1265_ = _e1068;
                                    phi_1266_ = _e1064;
                                    phi_1267_ = _e1096;
                                    phi_1268_ = _e1092;
                                }
                                let _e1105 = phi_1265_;
                                let _e1107 = phi_1266_;
                                let _e1109 = phi_1267_;
                                let _e1111 = phi_1268_;
                                let _e1114 = ((_e1111 * _e1105) - (_e1109 * _e1107));
                                if _e1103 {
                                    phi_1276_ = -(_e1114);
                                } else {
                                    phi_1276_ = _e1114;
                                }
                                let _e1117 = phi_1276_;
                                if (_e1092 < _e1036) {
                                    phi_1287_ = true;
                                } else {
                                    if (_e1092 == _e1036) {
                                        phi_1286_ = (_e1096 < _e1040);
                                    } else {
                                        phi_1286_ = false;
                                    }
                                    let _e1122 = phi_1286_;
                                    phi_1287_ = _e1122;
                                }
                                let _e1124 = phi_1287_;
                                if _e1124 {
                                    phi_1291_ = _e1040;
                                    phi_1292_ = _e1036;
                                    phi_1293_ = _e1096;
                                    phi_1294_ = _e1092;
                                } else {
                                    phi_1291_ = _e1096;
                                    phi_1292_ = _e1092;
                                    phi_1293_ = _e1040;
                                    phi_1294_ = _e1036;
                                }
                                let _e1126 = phi_1291_;
                                let _e1128 = phi_1292_;
                                let _e1130 = phi_1293_;
                                let _e1132 = phi_1294_;
                                let _e1135 = ((_e1132 * _e1126) - (_e1130 * _e1128));
                                if _e1124 {
                                    phi_1302_ = -(_e1135);
                                } else {
                                    phi_1302_ = _e1135;
                                }
                                let _e1138 = phi_1302_;
                                if (_e1036 < _e1064) {
                                    phi_1313_ = true;
                                } else {
                                    if (_e1036 == _e1064) {
                                        phi_1312_ = (_e1040 < _e1068);
                                    } else {
                                        phi_1312_ = false;
                                    }
                                    let _e1143 = phi_1312_;
                                    phi_1313_ = _e1143;
                                }
                                let _e1145 = phi_1313_;
                                if _e1145 {
                                    phi_1317_ = _e1068;
                                    phi_1318_ = _e1064;
                                    phi_1319_ = _e1040;
                                    phi_1320_ = _e1036;
                                } else {
                                    phi_1317_ = _e1040;
                                    phi_1318_ = _e1036;
                                    phi_1319_ = _e1068;
                                    phi_1320_ = _e1064;
                                }
                                let _e1147 = phi_1317_;
                                let _e1149 = phi_1318_;
                                let _e1151 = phi_1319_;
                                let _e1153 = phi_1320_;
                                let _e1156 = ((_e1153 * _e1147) - (_e1151 * _e1149));
                                if _e1145 {
                                    phi_1328_ = -(_e1156);
                                } else {
                                    phi_1328_ = _e1156;
                                }
                                let _e1159 = phi_1328_;
                                if (_e1117 >= 0f) {
                                    if (_e1138 >= 0f) {
                                        if (_e1159 >= 0f) {
                                            phi_1343_ = ((_e1117 + _e1138) + _e1159);
                                            phi_1344_ = false;
                                        } else {
                                            phi_1343_ = f32();
                                            phi_1344_ = true;
                                        }
                                        let _e1166 = phi_1343_;
                                        let _e1168 = phi_1344_;
                                        phi_1345_ = _e1166;
                                        phi_1346_ = _e1168;
                                    } else {
                                        phi_1345_ = f32();
                                        phi_1346_ = true;
                                    }
                                    let _e1170 = phi_1345_;
                                    let _e1172 = phi_1346_;
                                    phi_1347_ = _e1170;
                                    phi_1348_ = _e1172;
                                } else {
                                    phi_1347_ = f32();
                                    phi_1348_ = true;
                                }
                                let _e1174 = phi_1347_;
                                let _e1176 = phi_1348_;
                                if _e1176 {
                                    if (_e1117 <= 0f) {
                                        if (_e1138 <= 0f) {
                                            let _e1179 = (_e1159 <= 0f);
                                            if _e1179 {
                                            }
                                            phi_1366_ = ((_e1117 + _e1138) + _e1159);
                                            phi_1367_ = false;
                                            phi_1368_ = _e1179;
                                        } else {
                                            phi_1366_ = f32();
                                            phi_1367_ = true;
                                            phi_1368_ = false;
                                        }
                                        let _e1183 = phi_1366_;
                                        let _e1185 = phi_1367_;
                                        let _e1187 = phi_1368_;
                                        phi_1369_ = _e1183;
                                        phi_1370_ = _e1185;
                                        phi_1371_ = _e1187;
                                    } else {
                                        phi_1369_ = f32();
                                        phi_1370_ = true;
                                        phi_1371_ = false;
                                    }
                                    let _e1189 = phi_1369_;
                                    let _e1191 = phi_1370_;
                                    let _e1193 = phi_1371_;
                                    if _e1191 {
                                        phi_1375_ = false;
                                    } else {
                                        phi_1375_ = _e1193;
                                    }
                                    let _e1195 = phi_1375_;
                                    phi_1376_ = _e1189;
                                    phi_1377_ = _e1195;
                                } else {
                                    phi_1376_ = _e1174;
                                    phi_1377_ = true;
                                }
                                let _e1197 = phi_1376_;
                                let _e1199 = phi_1377_;
                                if _e1199 {
                                    let _e1200 = (_e1197 == 0f);
                                    if _e1200 {
                                        phi_1703_ = lt_bvh_triangle_Intersection();
                                        phi_1704_ = false;
                                    } else {
                                        let _e1202 = triangles.member[(0u + _e1007)].v0_;
                                        let _e1205 = (_e1202.x - _e138.origin.x);
                                        let _e1208 = (_e1202.y - _e138.origin.y);
                                        let _e1211 = (_e1202.z - _e138.origin.z);
                                        if (_e380 == 0u) {
                                            phi_1408_ = vec3<f32>(_e1208, _e1211, _e1205);
                                        } else {
                                            if (_e380 == 1u) {
                                                phi_1407_ = vec3<f32>(_e1211, _e1205, _e1208);
                                            } else {
                                                phi_1407_ = (_e1202 - _e138.origin);
                                            }
                                            let _e1218 = phi_1407_;
                                            phi_1408_ = _e1218;
                                        }
                                        let _e1220 = phi_1408_;
                                        let _e1222 = triangles.member[(0u + _e1007)].v1_;
                                        let _e1224 = triangles.member[(0u + _e1007)].v0_;
                                        let _e1227 = (_e1222.x - _e1224.x);
                                        let _e1230 = (_e1222.y - _e1224.y);
                                        let _e1233 = (_e1222.z - _e1224.z);
                                        if (_e380 == 0u) {
                                            phi_1434_ = vec3<f32>(_e1230, _e1233, _e1227);
                                        } else {
                                            if (_e380 == 1u) {
                                                phi_1433_ = vec3<f32>(_e1233, _e1227, _e1230);
                                            } else {
                                                phi_1433_ = (_e1222 - _e1224);
                                            }
                                            let _e1240 = phi_1433_;
                                            phi_1434_ = _e1240;
                                        }
                                        let _e1242 = phi_1434_;
                                        let _e1244 = triangles.member[(0u + _e1007)].v2_;
                                        let _e1246 = triangles.member[(0u + _e1007)].v0_;
                                        let _e1249 = (_e1244.x - _e1246.x);
                                        let _e1252 = (_e1244.y - _e1246.y);
                                        let _e1255 = (_e1244.z - _e1246.z);
                                        if (_e380 == 0u) {
                                            phi_1460_ = vec3<f32>(_e1252, _e1255, _e1249);
                                        } else {
                                            if (_e380 == 1u) {
                                                phi_1459_ = vec3<f32>(_e1255, _e1249, _e1252);
                                            } else {
                                                phi_1459_ = (_e1244 - _e1246);
                                            }
                                            let _e1262 = phi_1459_;
                                            phi_1460_ = _e1262;
                                        }
                                        let _e1264 = phi_1460_;
                                        let _e1271 = ((_e1242.y * _e1264.z) - (_e1242.z * _e1264.y));
                                        let _e1278 = ((_e1242.z * _e1264.x) - (_e1242.x * _e1264.z));
                                        let _e1285 = ((_e1242.x * _e1264.y) - (_e1242.y * _e1264.x));
                                        let _e1299 = (((1f / _e395.z) * (((_e1271 * _e1220.x) + (_e1278 * _e1220.y)) + (_e1285 * _e1220.z))) / (((_e1271 * _e399) + (_e1278 * _e402)) + _e1285));
                                        if (_e1299 > _e138.tmin) {
                                            if (_e1299 < _e138.tmax) {
                                                let _e1305 = triangles.member[(0u + _e1007)].v0_;
                                                let _e1307 = triangles.member[(0u + _e1007)].v1_;
                                                if (_e1305.x < _e1307.x) {
                                                    phi_1518_ = _e1305.x;
                                                } else {
                                                    phi_1518_ = _e1307.x;
                                                }
                                                let _e1314 = phi_1518_;
                                                if (_e1305.y < _e1307.y) {
                                                    phi_1527_ = _e1305.y;
                                                } else {
                                                    phi_1527_ = _e1307.y;
                                                }
                                                let _e1321 = phi_1527_;
                                                if (_e1305.z < _e1307.z) {
                                                    phi_1536_ = _e1305.z;
                                                } else {
                                                    phi_1536_ = _e1307.z;
                                                }
                                                let _e1328 = phi_1536_;
                                                let _e1330 = triangles.member[(0u + _e1007)].v2_;
                                                if (_e1314 < _e1330.x) {
                                                    phi_1545_ = _e1314;
                                                } else {
                                                    phi_1545_ = _e1330.x;
                                                }
                                                let _e1335 = phi_1545_;
                                                if (_e1321 < _e1330.y) {
                                                    phi_1552_ = _e1321;
                                                } else {
                                                    phi_1552_ = _e1330.y;
                                                }
                                                let _e1340 = phi_1552_;
                                                if (_e1328 < _e1330.z) {
                                                    phi_1559_ = _e1328;
                                                } else {
                                                    phi_1559_ = _e1330.z;
                                                }
                                                let _e1345 = phi_1559_;
                                                let _e1347 = triangles.member[(0u + _e1007)].v0_;
                                                let _e1349 = triangles.member[(0u + _e1007)].v1_;
                                                if (_e1347.x > _e1349.x) {
                                                    phi_1572_ = _e1347.x;
                                                } else {
                                                    phi_1572_ = _e1349.x;
                                                }
                                                let _e1356 = phi_1572_;
                                                if (_e1347.y > _e1349.y) {
                                                    phi_1581_ = _e1347.y;
                                                } else {
                                                    phi_1581_ = _e1349.y;
                                                }
                                                let _e1363 = phi_1581_;
                                                if (_e1347.z > _e1349.z) {
                                                    phi_1590_ = _e1347.z;
                                                } else {
                                                    phi_1590_ = _e1349.z;
                                                }
                                                let _e1370 = phi_1590_;
                                                let _e1372 = triangles.member[(0u + _e1007)].v2_;
                                                if (_e1356 > _e1372.x) {
                                                    phi_1599_ = _e1356;
                                                } else {
                                                    phi_1599_ = _e1372.x;
                                                }
                                                let _e1377 = phi_1599_;
                                                if (_e1363 > _e1372.y) {
                                                    phi_1606_ = _e1363;
                                                } else {
                                                    phi_1606_ = _e1372.y;
                                                }
                                                let _e1382 = phi_1606_;
                                                if (_e1370 > _e1372.z) {
                                                    phi_1613_ = _e1370;
                                                } else {
                                                    phi_1613_ = _e1372.z;
                                                }
                                                let _e1387 = phi_1613_;
                                                let _e1394 = ((_e1335 - _e138.origin.x) * _e292);
                                                let _e1395 = ((_e1340 - _e138.origin.y) * _e304);
                                                let _e1396 = ((_e1345 - _e138.origin.z) * _e316);
                                                let _e1403 = ((_e1377 - _e138.origin.x) * _e292);
                                                let _e1404 = ((_e1382 - _e138.origin.y) * _e304);
                                                let _e1405 = ((_e1387 - _e138.origin.z) * _e316);
                                                if (_e1394 < _e1403) {
                                                    phi_1636_ = _e1394;
                                                } else {
                                                    phi_1636_ = _e1403;
                                                }
                                                let _e1408 = phi_1636_;
                                                if (_e1395 < _e1404) {
                                                    phi_1641_ = _e1395;
                                                } else {
                                                    phi_1641_ = _e1404;
                                                }
                                                let _e1411 = phi_1641_;
                                                if (_e1396 < _e1405) {
                                                    phi_1646_ = _e1396;
                                                } else {
                                                    phi_1646_ = _e1405;
                                                }
                                                let _e1414 = phi_1646_;
                                                if (_e1394 > _e1403) {
                                                    phi_1654_ = _e1394;
                                                } else {
                                                    phi_1654_ = _e1403;
                                                }
                                                let _e1420 = phi_1654_;
                                                if (_e1395 > _e1404) {
                                                    phi_1659_ = _e1395;
                                                } else {
                                                    phi_1659_ = _e1404;
                                                }
                                                let _e1423 = phi_1659_;
                                                if (_e1396 > _e1405) {
                                                    phi_1664_ = _e1396;
                                                } else {
                                                    phi_1664_ = _e1405;
                                                }
                                                let _e1426 = phi_1664_;
                                                let _e1430 = core_intrinsics_maximum_number_nsz_f32_((_e1408 - _e360), (_e1411 - _e361));
                                                let _e1431 = core_intrinsics_maximum_number_nsz_f32_(_e1430, (_e1414 - _e362));
                                                let _e1432 = core_intrinsics_minimum_number_nsz_f32_((_e1420 + _e360), (_e1423 + _e361));
                                                let _e1433 = core_intrinsics_minimum_number_nsz_f32_(_e1432, (_e1426 + _e362));
                                                if (_e1431 > -300000000000000000000000000000000000000f) {
                                                    phi_1676_ = _e1431;
                                                } else {
                                                    phi_1676_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1436 = phi_1676_;
                                                if (_e1433 < 300000000000000000000000000000000000000f) {
                                                    phi_1681_ = _e1433;
                                                } else {
                                                    phi_1681_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1439 = phi_1681_;
                                                if (_e1299 < _e1436) {
                                                    phi_1686_ = _e1436;
                                                } else {
                                                    phi_1686_ = _e1299;
                                                }
                                                let _e1442 = phi_1686_;
                                                if (_e1442 > _e1439) {
                                                    phi_1691_ = _e1439;
                                                } else {
                                                    phi_1691_ = _e1442;
                                                }
                                                let _e1445 = phi_1691_;
                                                phi_1696_ = lt_bvh_triangle_Intersection(_e1445, (_e1138 / _e1197), (_e1159 / _e1197), (_e1436 <= _e1439));
                                                phi_1697_ = false;
                                            } else {
                                                phi_1696_ = lt_bvh_triangle_Intersection();
                                                phi_1697_ = true;
                                            }
                                            let _e1451 = phi_1696_;
                                            let _e1453 = phi_1697_;
                                            phi_1698_ = _e1451;
                                            phi_1699_ = _e1453;
                                        } else {
                                            phi_1698_ = lt_bvh_triangle_Intersection();
                                            phi_1699_ = true;
                                        }
                                        let _e1455 = phi_1698_;
                                        let _e1457 = phi_1699_;
                                        if _e1457 {
                                        }
                                        phi_1703_ = _e1455;
                                        phi_1704_ = _e1457;
                                    }
                                    let _e1459 = phi_1703_;
                                    let _e1461 = phi_1704_;
                                    phi_1705_ = _e1459;
                                    phi_1706_ = _e1200;
                                    phi_1707_ = _e1461;
                                } else {
                                    phi_1705_ = lt_bvh_triangle_Intersection();
                                    phi_1706_ = true;
                                    phi_1707_ = false;
                                }
                                let _e1463 = phi_1705_;
                                let _e1465 = phi_1706_;
                                let _e1467 = phi_1707_;
                                if _e1465 {
                                    phi_1711_ = true;
                                } else {
                                    phi_1711_ = _e1467;
                                }
                                let _e1469 = phi_1711_;
                                if _e1469 {
                                    phi_1715_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1715_ = _e1463;
                                }
                                let _e1471 = phi_1715_;
                                if _e1471.is_hit {
                                    if (_e1471.t > _e138.tmin) {
                                        if (_e1471.t < _e996.t) {
                                            phi_1764_ = true;
                                        } else {
                                            if (_e1471.t == _e996.t) {
                                                if (_e996.triangle != 4294967295u) {
                                                    if (_e1007 < _e996.triangle) {
                                                        phi_1755_ = true;
                                                    } else {
                                                        if (_e1007 == _e996.triangle) {
                                                            phi_1754_ = (4294967295u < _e996.instance);
                                                        } else {
                                                            phi_1754_ = false;
                                                        }
                                                        let _e1490 = phi_1754_;
                                                        phi_1755_ = _e1490;
                                                    }
                                                    let _e1492 = phi_1755_;
                                                    phi_1756_ = _e1492;
                                                    phi_1757_ = false;
                                                } else {
                                                    phi_1756_ = bool();
                                                    phi_1757_ = true;
                                                }
                                                let _e1494 = phi_1756_;
                                                let _e1496 = phi_1757_;
                                                phi_1758_ = _e1494;
                                                phi_1759_ = _e1496;
                                            } else {
                                                phi_1758_ = bool();
                                                phi_1759_ = true;
                                            }
                                            let _e1498 = phi_1758_;
                                            let _e1500 = phi_1759_;
                                            if _e1500 {
                                                phi_1763_ = false;
                                            } else {
                                                phi_1763_ = _e1498;
                                            }
                                            let _e1502 = phi_1763_;
                                            phi_1764_ = _e1502;
                                        }
                                        let _e1504 = phi_1764_;
                                        if _e1504 {
                                            let _e1506 = triangles.member[(0u + _e1007)].i0_;
                                            if ((_e1506 & 2147483648u) == 0u) {
                                                phi_1778_ = true;
                                            } else {
                                                if true {
                                                }
                                                phi_1778_ = true;
                                            }
                                            let _e1510 = phi_1778_;
                                            if _e1510 {
                                                phi_1786_ = lt_bvh_Hit(_e1471.t, _e1471.u, _e1471.v, _e1007, 4294967295u);
                                            } else {
                                                phi_1786_ = _e996;
                                            }
                                            let _e1516 = phi_1786_;
                                            phi_1787_ = _e1516;
                                        } else {
                                            phi_1787_ = _e996;
                                        }
                                        let _e1518 = phi_1787_;
                                        phi_1788_ = _e1518;
                                    } else {
                                        phi_1788_ = _e996;
                                    }
                                    let _e1520 = phi_1788_;
                                    phi_1789_ = _e1520;
                                } else {
                                    phi_1789_ = _e996;
                                }
                                let _e1522 = phi_1789_;
                                phi_1129_ = _e1522;
                                phi_1132_ = (_e998 & (_e998 - 1u));
                                phi_1790_ = true;
                            }
                            let _e1524 = phi_1129_;
                            let _e1526 = phi_1132_;
                            let _e1528 = phi_1790_;
                            continue;
                            continuing {
                                phi_1128_ = _e1524;
                                phi_1131_ = _e1526;
                                break if !(_e1528);
                            }
                        }
                        let _e1531 = local.group_mask;
                        if ((_e1531 & 4278190080u) == 0u) {
                            let _e1535 = local.len;
                            if (_e1535 == 0u) {
                                phi_1829_ = false;
                            } else {
                                let _e1539 = local.len;
                                local.len = (_e1539 - 1u);
                                let _e1542 = local.len;
                                if (_e1542 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1547 = local.first[(0u + _e1542)];
                                local.group = _e1547;
                                let _e1550 = local.len;
                                if (_e1550 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1555 = local.mask[(0u + _e1550)];
                                local.group_mask = _e1555;
                                phi_1829_ = true;
                            }
                            let _e1558 = phi_1829_;
                            phi_1830_ = _e1558;
                        } else {
                            phi_1830_ = true;
                        }
                        let _e1560 = phi_1830_;
                        if _e1560 {
                            let _e1562 = local.group_mask;
                            let _e1568 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1562)), 32u, (_e1562 == 0u)));
                            let _e1572 = local.group_mask;
                            let _e1586 = local.group_mask;
                            local.group_mask = (_e1586 & ~((1u << bitcast<u32>((_e1568 & 31u)))));
                            let _e1589 = local.group;
                            phi_1861_ = (_e1589 + countOneBits(((_e1572 & ~((4294967295u << bitcast<u32>((((_e1568 - 24u) ^ _e415) & 31u))))) & 255u)));
                        } else {
                            phi_1861_ = 4294967295u;
                        }
                        let _e1592 = phi_1861_;
                        let _e2292 = local_4;
                        phi_792_ = _e2292;
                        phi_795_ = _e1592;
                    } else {
                        phi_792_ = lt_bvh_Hit();
                        phi_795_ = u32();
                    }
                    let _e1594 = phi_792_;
                    let _e1596 = phi_795_;
                    continue;
                    continuing {
                        phi_791_ = _e1594;
                        phi_794_ = _e1596;
                        break if !(_e556);
                    }
                }
                let _e2296 = local_5;
                phi_1862_ = _e2296;
            }
            let _e1599 = phi_1862_;
            phi_1863_ = _e1599;
            phi_1864_ = _e210;
        } else {
            phi_1863_ = lt_bvh_Hit();
            phi_1864_ = true;
        }
        let _e1601 = phi_1863_;
        let _e1603 = phi_1864_;
        if _e1603 {
            phi_1868_ = _e140;
        } else {
            phi_1868_ = _e1601;
        }
        let _e1605 = phi_1868_;
        if (_e1605.triangle != 4294967295u) {
            let _e1611 = ((1f - _e1605.u) - _e1605.v);
            if (_e1605.triangle < _e68) {
            } else {
                return;
            }
            let _e1617 = triangles.member[(0u + _e1605.triangle)];
            let _e1642 = (((_e1617.v0_.x * _e1611) + (_e1617.v1_.x * _e1605.u)) + (_e1617.v2_.x * _e1605.v));
            let _e1643 = (((_e1617.v0_.y * _e1611) + (_e1617.v1_.y * _e1605.u)) + (_e1617.v2_.y * _e1605.v));
            let _e1644 = (((_e1617.v0_.z * _e1611) + (_e1617.v1_.z * _e1605.u)) + (_e1617.v2_.z * _e1605.v));
            let _e1647 = abs(_e1617.v0_.x);
            let _e1649 = abs(_e1617.v0_.y);
            let _e1651 = abs(_e1617.v0_.z);
            let _e1653 = abs(_e1617.v1_.x);
            let _e1655 = abs(_e1617.v1_.y);
            let _e1657 = abs(_e1617.v1_.z);
            if (_e1647 > _e1653) {
                phi_1933_ = _e1647;
            } else {
                phi_1933_ = _e1653;
            }
            let _e1660 = phi_1933_;
            if (_e1649 > _e1655) {
                phi_1938_ = _e1649;
            } else {
                phi_1938_ = _e1655;
            }
            let _e1663 = phi_1938_;
            if (_e1651 > _e1657) {
                phi_1943_ = _e1651;
            } else {
                phi_1943_ = _e1657;
            }
            let _e1666 = phi_1943_;
            let _e1668 = abs(_e1617.v2_.x);
            let _e1670 = abs(_e1617.v2_.y);
            let _e1672 = abs(_e1617.v2_.z);
            if (_e1660 > _e1668) {
                phi_1954_ = _e1660;
            } else {
                phi_1954_ = _e1668;
            }
            let _e1675 = phi_1954_;
            if (_e1663 > _e1670) {
                phi_1959_ = _e1663;
            } else {
                phi_1959_ = _e1670;
            }
            let _e1678 = phi_1959_;
            if (_e1666 > _e1672) {
                phi_1964_ = _e1666;
            } else {
                phi_1964_ = _e1672;
            }
            let _e1681 = phi_1964_;
            let _e1684 = (_e1617.v1_.x - _e1617.v0_.x);
            let _e1687 = (_e1617.v1_.y - _e1617.v0_.y);
            let _e1690 = (_e1617.v1_.z - _e1617.v0_.z);
            let _e1693 = (_e1617.v2_.x - _e1617.v0_.x);
            let _e1696 = (_e1617.v2_.y - _e1617.v0_.y);
            let _e1699 = (_e1617.v2_.z - _e1617.v0_.z);
            let _e1703 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1687), abs(_e1690));
            let _e1704 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1684), _e1703);
            let _e1705 = (_e1684 / _e1704);
            let _e1706 = (_e1687 / _e1704);
            let _e1707 = (_e1690 / _e1704);
            let _e1711 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1696), abs(_e1699));
            let _e1712 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1693), _e1711);
            let _e1713 = (_e1693 / _e1712);
            let _e1714 = (_e1696 / _e1712);
            let _e1715 = (_e1699 / _e1712);
            let _e1718 = ((_e1706 * _e1715) - (_e1714 * _e1707));
            let _e1721 = ((_e1707 * _e1713) - (_e1715 * _e1705));
            let _e1724 = ((_e1705 * _e1714) - (_e1713 * _e1706));
            let _e1726 = p.member.eye;
            let _e1739 = (1f / sqrt((((_e1718 * _e1718) + (_e1721 * _e1721)) + (_e1724 * _e1724))));
            let _e1740 = (_e1718 * _e1739);
            let _e1741 = (_e1721 * _e1739);
            let _e1742 = (_e1724 * _e1739);
            if ((((_e1740 * (_e1726.x - _e1642)) + (_e1741 * (_e1726.y - _e1643))) + (_e1742 * (_e1726.z - _e1644))) < 0f) {
                phi_2040_ = vec3<f32>(-(_e1740), -(_e1741), -(_e1742));
            } else {
                phi_2040_ = vec3<f32>(_e1740, _e1741, _e1742);
            }
            let _e1755 = phi_2040_;
            if (_e1605.triangle < _e68) {
            } else {
                return;
            }
            let _e1760 = triangles.member[(0u + _e1605.triangle)];
            let _e1762 = (_e1760.i0_ & 2147483647u);
            if (_e1762 < _e71) {
            } else {
                return;
            }
            let _e1768 = vertices.member[(0u + _e1762)];
            if (_e1760.i1_ < _e71) {
            } else {
                return;
            }
            let _e1772 = vertices.member[(0u + _e1760.i1_)];
            if (_e1760.i2_ < _e71) {
            } else {
                return;
            }
            let _e1776 = vertices.member[(0u + _e1760.i2_)];
            let _e1777 = array<abi_Vertex, 3>(_e1768, _e1772, _e1776);
            if (_e1777[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e1783 = materials.member[(0u + _e1777[0].material)];
            let _e1800 = (1f / 255f);
            let _e1819 = (1f / 255f);
            let _e1841 = (1f / 255f);
            let _e1854 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e1611, _e1605.u, _e1605.v));
            let _e1856 = ((_e1783.base_color.x * ((((f32((_e1777[0].color & 255u)) * _e1800) * _e1611) + ((f32((_e1777[1].color & 255u)) * _e1819) * _e1605.u)) + ((f32((_e1777[2].color & 255u)) * _e1841) * _e1605.v))) * _e1854.x);
            let _e1858 = ((_e1783.base_color.y * ((((f32(((_e1777[0].color >> bitcast<u32>(8i)) & 255u)) * _e1800) * _e1611) + ((f32(((_e1777[1].color >> bitcast<u32>(8i)) & 255u)) * _e1819) * _e1605.u)) + ((f32(((_e1777[2].color >> bitcast<u32>(8i)) & 255u)) * _e1841) * _e1605.v))) * _e1854.y);
            let _e1860 = ((_e1783.base_color.z * ((((f32(((_e1777[0].color >> bitcast<u32>(16i)) & 255u)) * _e1800) * _e1611) + ((f32(((_e1777[1].color >> bitcast<u32>(16i)) & 255u)) * _e1819) * _e1605.u)) + ((f32(((_e1777[2].color >> bitcast<u32>(16i)) & 255u)) * _e1841) * _e1605.v))) * _e1854.z);
            let _e1861 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1678, _e1681);
            let _e1862 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1675, _e1861);
            if ((_e1783.flags & 2u) == 0u) {
                phi_2161_ = 0u;
            } else {
                phi_2161_ = 1u;
            }
            let _e1867 = phi_2161_;
            if (_e1777[0].normal == 2147516416u) {
                phi_2364_ = _e1755;
            } else {
                let _e1880 = (f32((bitcast<i32>((_e1777[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1886 = (f32((bitcast<i32>(_e1777[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1890 = ((1f - abs(_e1880)) - abs(_e1886));
                if (_e1890 < 0f) {
                    phi_2188_ = -(_e1890);
                } else {
                    phi_2188_ = 0f;
                }
                let _e1894 = phi_2188_;
                if (_e1880 < 0f) {
                    phi_2195_ = (_e1880 + _e1894);
                } else {
                    phi_2195_ = (_e1880 - _e1894);
                }
                let _e1899 = phi_2195_;
                if (_e1886 < 0f) {
                    phi_2202_ = (_e1886 + _e1894);
                } else {
                    phi_2202_ = (_e1886 - _e1894);
                }
                let _e1904 = phi_2202_;
                let _e1911 = (1f / sqrt((((_e1899 * _e1899) + (_e1904 * _e1904)) + (_e1890 * _e1890))));
                let _e1927 = (f32((bitcast<i32>((_e1777[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1933 = (f32((bitcast<i32>(_e1777[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1937 = ((1f - abs(_e1927)) - abs(_e1933));
                if (_e1937 < 0f) {
                    phi_2237_ = -(_e1937);
                } else {
                    phi_2237_ = 0f;
                }
                let _e1941 = phi_2237_;
                if (_e1927 < 0f) {
                    phi_2244_ = (_e1927 + _e1941);
                } else {
                    phi_2244_ = (_e1927 - _e1941);
                }
                let _e1946 = phi_2244_;
                if (_e1933 < 0f) {
                    phi_2251_ = (_e1933 + _e1941);
                } else {
                    phi_2251_ = (_e1933 - _e1941);
                }
                let _e1951 = phi_2251_;
                let _e1958 = (1f / sqrt((((_e1946 * _e1946) + (_e1951 * _e1951)) + (_e1937 * _e1937))));
                let _e1977 = (f32((bitcast<i32>((_e1777[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1983 = (f32((bitcast<i32>(_e1777[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1987 = ((1f - abs(_e1977)) - abs(_e1983));
                if (_e1987 < 0f) {
                    phi_2289_ = -(_e1987);
                } else {
                    phi_2289_ = 0f;
                }
                let _e1991 = phi_2289_;
                if (_e1977 < 0f) {
                    phi_2296_ = (_e1977 + _e1991);
                } else {
                    phi_2296_ = (_e1977 - _e1991);
                }
                let _e1996 = phi_2296_;
                if (_e1983 < 0f) {
                    phi_2303_ = (_e1983 + _e1991);
                } else {
                    phi_2303_ = (_e1983 - _e1991);
                }
                let _e2001 = phi_2303_;
                let _e2008 = (1f / sqrt((((_e1996 * _e1996) + (_e2001 * _e2001)) + (_e1987 * _e1987))));
                let _e2019 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e1899 * _e1911) * _e1611) + ((_e1946 * _e1958) * _e1605.u)) + ((_e1996 * _e2008) * _e1605.v)), ((((_e1904 * _e1911) * _e1611) + ((_e1951 * _e1958) * _e1605.u)) + ((_e2001 * _e2008) * _e1605.v)), ((((_e1890 * _e1911) * _e1611) + ((_e1937 * _e1958) * _e1605.u)) + ((_e1987 * _e2008) * _e1605.v))));
                let _e2031 = sqrt((((_e2019.x * _e2019.x) + (_e2019.y * _e2019.y)) + (_e2019.z * _e2019.z)));
                if (_e2031 > 0f) {
                    let _e2034 = (_e2019.x / _e2031);
                    let _e2036 = (_e2019.y / _e2031);
                    let _e2038 = (_e2019.z / _e2031);
                    if ((((_e2034 * _e1755.x) + (_e2036 * _e1755.y)) + (_e2038 * _e1755.z)) < 0f) {
                        phi_2362_ = vec3<f32>(-(_e2034), -(_e2036), -(_e2038));
                    } else {
                        phi_2362_ = (_e2019 / vec3(_e2031));
                    }
                    let _e2055 = phi_2362_;
                    phi_2363_ = _e2055;
                } else {
                    phi_2363_ = _e1755;
                }
                let _e2057 = phi_2363_;
                phi_2364_ = _e2057;
            }
            let _e2059 = phi_2364_;
            if (_e1856 > 0f) {
                if (_e1856 < 1f) {
                    phi_2373_ = _e1856;
                } else {
                    phi_2373_ = 1f;
                }
                let _e2063 = phi_2373_;
                phi_2374_ = _e2063;
            } else {
                phi_2374_ = 0f;
            }
            let _e2065 = phi_2374_;
            if (_e1858 > 0f) {
                if (_e1858 < 1f) {
                    phi_2384_ = _e1858;
                } else {
                    phi_2384_ = 1f;
                }
                let _e2070 = phi_2384_;
                phi_2385_ = _e2070;
            } else {
                phi_2385_ = 0f;
            }
            let _e2072 = phi_2385_;
            if (_e1860 > 0f) {
                if (_e1860 < 1f) {
                    phi_2395_ = _e1860;
                } else {
                    phi_2395_ = 1f;
                }
                let _e2077 = phi_2395_;
                phi_2396_ = _e2077;
            } else {
                phi_2396_ = 0f;
            }
            let _e2079 = phi_2396_;
            let _e2082 = ((sqrt(_e2065) * 255f) + 0.5f);
            let _e2091 = ((sqrt(_e2072) * 255f) + 0.5f);
            let _e2103 = ((sqrt(_e2079) * 255f) + 0.5f);
            phi_2431_ = abi_Sample(vec3<f32>(_e1642, _e1643, _e1644), _e1862, _e1755, _e1867, _e2059, ((select(select(u32(_e2082), 0u, (_e2082 < bitcast<f32>(0u))), 4294967295u, (_e2082 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2091), 0u, (_e2091 < bitcast<f32>(0u))), 4294967295u, (_e2091 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2103), 0u, (_e2103 < bitcast<f32>(0u))), 4294967295u, (_e2103 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_2431_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2117 = phi_2431_;
        if (_e83.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e83.shift)] = _e2117;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
