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
                let _e286 = phi_485_;
                if (_e138.direction.x < 0f) {
                    phi_492_ = (-1f / _e286);
                } else {
                    phi_492_ = (1f / _e286);
                }
                let _e291 = phi_492_;
                if (abs(_e138.direction.y) < _e280) {
                    phi_500_ = _e280;
                } else {
                    phi_500_ = abs(_e138.direction.y);
                }
                let _e297 = phi_500_;
                if (_e138.direction.y < 0f) {
                    phi_507_ = (-1f / _e297);
                } else {
                    phi_507_ = (1f / _e297);
                }
                let _e302 = phi_507_;
                if (abs(_e138.direction.z) < _e280) {
                    phi_515_ = _e280;
                } else {
                    phi_515_ = abs(_e138.direction.z);
                }
                let _e308 = phi_515_;
                if (_e138.direction.z < 0f) {
                    phi_522_ = (-1f / _e308);
                } else {
                    phi_522_ = (1f / _e308);
                }
                let _e313 = phi_522_;
                let _e321 = abs((bitcast<f32>(_e216) - _e138.origin.x));
                let _e322 = abs((bitcast<f32>(_e220) - _e138.origin.y));
                let _e323 = abs((bitcast<f32>(_e224) - _e138.origin.z));
                let _e331 = abs(((bitcast<f32>(_e228) + (bitcast<f32>((((_e240 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e138.origin.x));
                let _e332 = abs(((bitcast<f32>(_e232) + (bitcast<f32>((((_e240 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e138.origin.y));
                let _e333 = abs(((bitcast<f32>(_e236) + (bitcast<f32>((((_e240 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e138.origin.z));
                if (_e321 > _e331) {
                    phi_547_ = _e321;
                } else {
                    phi_547_ = _e331;
                }
                let _e336 = phi_547_;
                if (_e322 > _e332) {
                    phi_552_ = _e322;
                } else {
                    phi_552_ = _e332;
                }
                let _e339 = phi_552_;
                if (_e323 > _e333) {
                    phi_557_ = _e323;
                } else {
                    phi_557_ = _e333;
                }
                let _e342 = phi_557_;
                let _e343 = core_intrinsics_maximum_number_nsz_f32_(_e336, _e339);
                let _e344 = core_intrinsics_maximum_number_nsz_f32_(_e343, _e342);
                let _e349 = (_e344 * 0.0000019073486f);
                let _e350 = (abs(_e291) * _e349);
                let _e351 = (abs(_e302) * _e349);
                let _e352 = (abs(_e313) * _e349);
                let _e356 = (_e344 * 0.0000009536743f);
                let _e357 = (abs(_e291) * _e356);
                let _e358 = (abs(_e302) * _e356);
                let _e359 = (abs(_e313) * _e356);
                let _e362 = abs(_e138.direction.x);
                let _e364 = abs(_e138.direction.y);
                let _e366 = abs(_e138.direction.z);
                if (_e362 >= _e364) {
                    if (_e362 >= _e366) {
                        phi_590_ = false;
                    } else {
                        phi_590_ = true;
                    }
                    let _e370 = phi_590_;
                    phi_591_ = _e370;
                } else {
                    phi_591_ = true;
                }
                let _e372 = phi_591_;
                if _e372 {
                    if (_e364 >= _e366) {
                        phi_599_ = 1u;
                    } else {
                        phi_599_ = 2u;
                    }
                    let _e375 = phi_599_;
                    phi_600_ = _e375;
                } else {
                    phi_600_ = 0u;
                }
                let _e377 = phi_600_;
                if (_e377 == 0u) {
                    phi_619_ = vec3<f32>(_e138.direction.y, _e138.direction.z, _e138.direction.x);
                } else {
                    if (_e377 == 1u) {
                        phi_618_ = vec3<f32>(_e138.direction.z, _e138.direction.x, _e138.direction.y);
                    } else {
                        phi_618_ = _e138.direction;
                    }
                    let _e390 = phi_618_;
                    phi_619_ = _e390;
                }
                let _e392 = phi_619_;
                let _e396 = (_e392.x / _e392.z);
                let _e399 = (_e392.y / _e392.z);
                if (_e291 < 0f) {
                    phi_633_ = 0u;
                } else {
                    phi_633_ = 1u;
                }
                let _e404 = phi_633_;
                if (_e302 < 0f) {
                    phi_638_ = 0u;
                } else {
                    phi_638_ = 2u;
                }
                let _e407 = phi_638_;
                if (_e313 < 0f) {
                    phi_643_ = 0u;
                } else {
                    phi_643_ = 4u;
                }
                let _e410 = phi_643_;
                let _e412 = ((_e404 | _e407) | _e410);
                let _e413 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local = lt_bvh_traverse_Stack(array<u32, 32>(_e413.first[0], _e413.first[1], _e413.first[2], _e413.first[3], _e413.first[4], _e413.first[5], _e413.first[6], _e413.first[7], _e413.first[8], _e413.first[9], _e413.first[10], _e413.first[11], _e413.first[12], _e413.first[13], _e413.first[14], _e413.first[15], _e413.first[16], _e413.first[17], _e413.first[18], _e413.first[19], _e413.first[20], _e413.first[21], _e413.first[22], _e413.first[23], _e413.first[24], _e413.first[25], _e413.first[26], _e413.first[27], _e413.first[28], _e413.first[29], _e413.first[30], _e413.first[31]), array<u32, 32>(_e413.mask[0], _e413.mask[1], _e413.mask[2], _e413.mask[3], _e413.mask[4], _e413.mask[5], _e413.mask[6], _e413.mask[7], _e413.mask[8], _e413.mask[9], _e413.mask[10], _e413.mask[11], _e413.mask[12], _e413.mask[13], _e413.mask[14], _e413.mask[15], _e413.mask[16], _e413.mask[17], _e413.mask[18], _e413.mask[19], _e413.mask[20], _e413.mask[21], _e413.mask[22], _e413.mask[23], _e413.mask[24], _e413.mask[25], _e413.mask[26], _e413.mask[27], _e413.mask[28], _e413.mask[29], _e413.mask[30], _e413.mask[31]), _e413.len, _e413.group, _e413.group_mask);
                let _e487 = local.group_mask;
                if ((_e487 & 4278190080u) == 0u) {
                    let _e491 = local.len;
                    if (_e491 == 0u) {
                        phi_757_ = false;
                    } else {
                        let _e495 = local.len;
                        local.len = (_e495 - 1u);
                        let _e498 = local.len;
                        if (_e498 < 32u) {
                        } else {
                            return;
                        }
                        let _e503 = local.first[(0u + _e498)];
                        local.group = _e503;
                        let _e506 = local.len;
                        if (_e506 < 32u) {
                        } else {
                            return;
                        }
                        let _e511 = local.mask[(0u + _e506)];
                        local.group_mask = _e511;
                        phi_757_ = true;
                    }
                    let _e514 = phi_757_;
                    phi_758_ = _e514;
                } else {
                    phi_758_ = true;
                }
                let _e516 = phi_758_;
                if _e516 {
                    let _e518 = local.group_mask;
                    let _e524 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e518)), 32u, (_e518 == 0u)));
                    let _e528 = local.group_mask;
                    let _e542 = local.group_mask;
                    local.group_mask = (_e542 & ~((1u << bitcast<u32>((_e524 & 31u)))));
                    let _e545 = local.group;
                    phi_789_ = (_e545 + countOneBits(((_e528 & ~((4294967295u << bitcast<u32>((((_e524 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_789_ = 4294967295u;
                }
                let _e548 = phi_789_;
                phi_791_ = _e140;
                phi_794_ = _e548;
                loop {
                    let _e550 = phi_791_;
                    let _e552 = phi_794_;
                    local_5 = _e550;
                    let _e553 = (_e552 != 4294967295u);
                    if _e553 {
                        if (_e552 < _e65) {
                        } else {
                            return;
                        }
                        let _e561 = nodes.member[(0u + _e552)].frame[3u];
                        let _e586 = (bitcast<f32>((((_e561 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e291);
                        let _e587 = (bitcast<f32>((((_e561 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e302);
                        let _e588 = (bitcast<f32>((((_e561 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e313);
                        let _e591 = nodes.member[(0u + _e552)].frame[0u];
                        let _e595 = nodes.member[(0u + _e552)].frame[1u];
                        let _e599 = nodes.member[(0u + _e552)].frame[2u];
                        let _e607 = ((bitcast<f32>(_e591) - _e138.origin.x) * _e291);
                        let _e608 = ((bitcast<f32>(_e595) - _e138.origin.y) * _e302);
                        let _e609 = ((bitcast<f32>(_e599) - _e138.origin.z) * _e313);
                        let _e617 = nodes.member[(0u + _e552)].x;
                        if (_e291 < 0f) {
                            let _e628 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e617.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e634 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e628.unnamed.word, _e617.w), _e628.unnamed_1);
                            let _e640 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e634.unnamed, lt_mask_LightPlace(_e617.x, _e634.unnamed_1.shift));
                            phi_879_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e640.unnamed, lt_mask_LightPlace(_e640.unnamed_1.word, _e617.y));
                        } else {
                            let _e656 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e617.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e662 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e656.unnamed.word, _e617.y), _e656.unnamed_1);
                            let _e668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e662.unnamed, lt_mask_LightPlace(_e617.z, _e662.unnamed_1.shift));
                            phi_879_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e668.unnamed, lt_mask_LightPlace(_e668.unnamed_1.word, _e617.w));
                        }
                        let _e676 = phi_879_;
                        let _e686 = nodes.member[(0u + _e552)].y;
                        if (_e302 < 0f) {
                            let _e697 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e686.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e703 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e697.unnamed.word, _e686.w), _e697.unnamed_1);
                            let _e709 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e703.unnamed, lt_mask_LightPlace(_e686.x, _e703.unnamed_1.shift));
                            phi_906_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e709.unnamed, lt_mask_LightPlace(_e709.unnamed_1.word, _e686.y));
                        } else {
                            let _e725 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e686.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e731 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e725.unnamed.word, _e686.y), _e725.unnamed_1);
                            let _e737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e731.unnamed, lt_mask_LightPlace(_e686.z, _e731.unnamed_1.shift));
                            phi_906_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e737.unnamed, lt_mask_LightPlace(_e737.unnamed_1.word, _e686.w));
                        }
                        let _e745 = phi_906_;
                        let _e755 = nodes.member[(0u + _e552)].z;
                        if (_e313 < 0f) {
                            let _e766 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e755.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e772 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e766.unnamed.word, _e755.w), _e766.unnamed_1);
                            let _e778 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e772.unnamed, lt_mask_LightPlace(_e755.x, _e772.unnamed_1.shift));
                            phi_933_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e778.unnamed, lt_mask_LightPlace(_e778.unnamed_1.word, _e755.y));
                        } else {
                            let _e794 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e755.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e800 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e794.unnamed.word, _e755.y), _e794.unnamed_1);
                            let _e806 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e800.unnamed, lt_mask_LightPlace(_e755.z, _e800.unnamed_1.shift));
                            phi_933_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e806.unnamed, lt_mask_LightPlace(_e806.unnamed_1.word, _e755.w));
                        }
                        let _e814 = phi_933_;
                        phi_939_ = 0u;
                        phi_942_ = 0u;
                        loop {
                            let _e824 = phi_939_;
                            let _e826 = phi_942_;
                            local_1 = _e826;
                            local_2 = _e826;
                            local_3 = _e826;
                            let _e827 = (_e824 < 8u);
                            if _e827 {
                                let _e829 = (_e824 >> bitcast<u32>(2i));
                                let _e830 = (_e824 & 3u);
                                if (_e829 == 0u) {
                                    phi_956_ = _e676.unnamed.word;
                                } else {
                                    phi_956_ = _e676.unnamed.shift;
                                }
                                let _e833 = phi_956_;
                                if (_e829 == 0u) {
                                    phi_966_ = _e745.unnamed.word;
                                } else {
                                    phi_966_ = _e745.unnamed.shift;
                                }
                                let _e842 = phi_966_;
                                if (_e829 == 0u) {
                                    phi_976_ = _e814.unnamed.word;
                                } else {
                                    phi_976_ = _e814.unnamed.shift;
                                }
                                let _e851 = phi_976_;
                                let _e864 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e833 >> bitcast<u32>(((_e830 * 8u) & 31u))) & 255u)) * _e586) + (_e607 - _e350)), ((f32(((_e842 >> bitcast<u32>(((_e830 * 8u) & 31u))) & 255u)) * _e587) + (_e608 - _e351)));
                                let _e865 = core_intrinsics_maximum_number_nsz_f32_(_e864, ((f32(((_e851 >> bitcast<u32>(((_e830 * 8u) & 31u))) & 255u)) * _e588) + (_e609 - _e352)));
                                if (_e829 == 0u) {
                                    phi_994_ = _e676.unnamed_1.word;
                                } else {
                                    phi_994_ = _e676.unnamed_1.shift;
                                }
                                let _e868 = phi_994_;
                                if (_e829 == 0u) {
                                    phi_1004_ = _e745.unnamed_1.word;
                                } else {
                                    phi_1004_ = _e745.unnamed_1.shift;
                                }
                                let _e877 = phi_1004_;
                                if (_e829 == 0u) {
                                    phi_1014_ = _e814.unnamed_1.word;
                                } else {
                                    phi_1014_ = _e814.unnamed_1.shift;
                                }
                                let _e886 = phi_1014_;
                                let _e899 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e868 >> bitcast<u32>(((_e830 * 8u) & 31u))) & 255u)) * _e586) + (_e607 + _e350)), ((f32(((_e877 >> bitcast<u32>(((_e830 * 8u) & 31u))) & 255u)) * _e587) + (_e608 + _e351)));
                                let _e900 = core_intrinsics_minimum_number_nsz_f32_(_e899, ((f32(((_e886 >> bitcast<u32>(((_e830 * 8u) & 31u))) & 255u)) * _e588) + (_e609 + _e352)));
                                if (_e865 <= _e900) {
                                    if (_e865 <= _e550.t) {
                                        if (_e900 >= _e138.tmin) {
                                            if (_e829 == 0u) {
                                                let _e907 = nodes.member[(0u + _e552)].links[2u];
                                                phi_1050_ = _e907;
                                            } else {
                                                let _e910 = nodes.member[(0u + _e552)].links[3u];
                                                phi_1050_ = _e910;
                                            }
                                            let _e912 = phi_1050_;
                                            let _e917 = ((_e912 >> bitcast<u32>(((_e830 * 8u) & 31u))) & 255u);
                                            let _e918 = (_e917 & 31u);
                                            if (_e918 >= 24u) {
                                                phi_1063_ = (24u + ((_e918 - 24u) ^ _e412));
                                            } else {
                                                phi_1063_ = _e918;
                                            }
                                            let _e924 = phi_1063_;
                                            phi_1068_ = (_e826 | ((_e917 >> bitcast<u32>(5i)) << bitcast<u32>((_e924 & 31u))));
                                        } else {
                                            phi_1068_ = _e826;
                                        }
                                        let _e932 = phi_1068_;
                                        phi_1069_ = _e932;
                                    } else {
                                        phi_1069_ = _e826;
                                    }
                                    let _e934 = phi_1069_;
                                    phi_1070_ = _e934;
                                } else {
                                    phi_1070_ = _e826;
                                }
                                let _e936 = phi_1070_;
                                phi_940_ = (_e824 + 1u);
                                phi_943_ = _e936;
                            } else {
                                phi_940_ = u32();
                                phi_943_ = u32();
                            }
                            let _e939 = phi_940_;
                            let _e941 = phi_943_;
                            continue;
                            continuing {
                                phi_939_ = _e939;
                                phi_942_ = _e941;
                                break if !(_e827);
                            }
                        }
                        let _e945 = nodes.member[(0u + _e552)].links[0u];
                        let _e949 = nodes.member[(0u + _e552)].frame[3u];
                        let _e953 = local_1;
                        if ((_e953 & 4278190080u) == 0u) {
                        } else {
                            let _e957 = local.group_mask;
                            if ((_e957 & 4278190080u) == 0u) {
                            } else {
                                let _e961 = local.len;
                                if (_e961 < 32u) {
                                    let _e964 = local.group;
                                    let _e966 = local.len;
                                    if (_e966 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.first[(0u + _e966)] = _e964;
                                    let _e972 = local.group_mask;
                                    let _e974 = local.len;
                                    if (_e974 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.mask[(0u + _e974)] = _e972;
                                    let _e981 = local.len;
                                    local.len = (_e981 + 1u);
                                }
                            }
                            local.group = (0u + _e945);
                            let _e985 = local_2;
                            local.group_mask = ((_e985 & 4278190080u) | (_e949 >> bitcast<u32>(24i)));
                        }
                        let _e990 = local_3;
                        phi_1128_ = _e550;
                        phi_1131_ = (_e990 & 16777215u);
                        loop {
                            let _e993 = phi_1128_;
                            let _e995 = phi_1131_;
                            local_4 = _e993;
                            if (_e995 == 0u) {
                                phi_1129_ = lt_bvh_Hit();
                                phi_1132_ = u32();
                                phi_1790_ = false;
                            } else {
                                let _e999 = nodes.member[(0u + _e552)].links[1u];
                                let _e1004 = ((0u + _e999) + select(firstTrailingBit(_e995), 32u, (_e995 == 0u)));
                                if (_e1004 < _e68) {
                                } else {
                                    return;
                                }
                                let _e1011 = triangles.member[(0u + _e1004)].v0_;
                                let _e1014 = (_e1011.x - _e138.origin.x);
                                let _e1017 = (_e1011.y - _e138.origin.y);
                                let _e1020 = (_e1011.z - _e138.origin.z);
                                if (_e377 == 0u) {
                                    phi_1178_ = vec3<f32>(_e1017, _e1020, _e1014);
                                } else {
                                    if (_e377 == 1u) {
                                        phi_1177_ = vec3<f32>(_e1020, _e1014, _e1017);
                                    } else {
                                        phi_1177_ = (_e1011 - _e138.origin);
                                    }
                                    let _e1027 = phi_1177_;
                                    phi_1178_ = _e1027;
                                }
                                let _e1029 = phi_1178_;
                                let _e1033 = (_e1029.x - (_e396 * _e1029.z));
                                let _e1037 = (_e1029.y - (_e399 * _e1029.z));
                                let _e1039 = triangles.member[(0u + _e1004)].v1_;
                                let _e1042 = (_e1039.x - _e138.origin.x);
                                let _e1045 = (_e1039.y - _e138.origin.y);
                                let _e1048 = (_e1039.z - _e138.origin.z);
                                if (_e377 == 0u) {
                                    phi_1210_ = vec3<f32>(_e1045, _e1048, _e1042);
                                } else {
                                    if (_e377 == 1u) {
                                        phi_1209_ = vec3<f32>(_e1048, _e1042, _e1045);
                                    } else {
                                        phi_1209_ = (_e1039 - _e138.origin);
                                    }
                                    let _e1055 = phi_1209_;
                                    phi_1210_ = _e1055;
                                }
                                let _e1057 = phi_1210_;
                                let _e1061 = (_e1057.x - (_e396 * _e1057.z));
                                let _e1065 = (_e1057.y - (_e399 * _e1057.z));
                                let _e1067 = triangles.member[(0u + _e1004)].v2_;
                                let _e1070 = (_e1067.x - _e138.origin.x);
                                let _e1073 = (_e1067.y - _e138.origin.y);
                                let _e1076 = (_e1067.z - _e138.origin.z);
                                if (_e377 == 0u) {
                                    phi_1242_ = vec3<f32>(_e1073, _e1076, _e1070);
                                } else {
                                    if (_e377 == 1u) {
                                        phi_1241_ = vec3<f32>(_e1076, _e1070, _e1073);
                                    } else {
                                        phi_1241_ = (_e1067 - _e138.origin);
                                    }
                                    let _e1083 = phi_1241_;
                                    phi_1242_ = _e1083;
                                }
                                let _e1085 = phi_1242_;
                                let _e1089 = (_e1085.x - (_e396 * _e1085.z));
                                let _e1093 = (_e1085.y - (_e399 * _e1085.z));
                                if (_e1061 < _e1089) {
                                    phi_1261_ = true;
                                } else {
                                    if (_e1061 == _e1089) {
                                        phi_1260_ = (_e1065 < _e1093);
                                    } else {
                                        phi_1260_ = false;
                                    }
                                    let _e1098 = phi_1260_;
                                    phi_1261_ = _e1098;
                                }
                                let _e1100 = phi_1261_;
                                if _e1100 {
                                    phi_1265_ = _e1093;
                                    phi_1266_ = _e1089;
                                    phi_1267_ = _e1065;
                                    phi_1268_ = _e1061;
                                } else {
                                    phi_1265_ = _e1065;
                                    phi_1266_ = _e1061;
                                    phi_1267_ = _e1093;
                                    phi_1268_ = _e1089;
                                }
                                let _e1102 = phi_1265_;
                                let _e1104 = phi_1266_;
                                let _e1106 = phi_1267_;
                                let _e1108 = phi_1268_;
                                let _e1111 = ((_e1108 * _e1102) - (_e1106 * _e1104));
                                if _e1100 {
                                    phi_1276_ = -(_e1111);
                                } else {
                                    phi_1276_ = _e1111;
                                }
                                let _e1114 = phi_1276_;
                                if (_e1089 < _e1033) {
                                    phi_1287_ = true;
                                } else {
                                    if (_e1089 == _e1033) {
                                        phi_1286_ = (_e1093 < _e1037);
                                    } else {
                                        phi_1286_ = false;
                                    }
                                    let _e1119 = phi_1286_;
                                    phi_1287_ = _e1119;
                                }
                                let _e1121 = phi_1287_;
                                if _e1121 {
                                    phi_1291_ = _e1037;
                                    phi_1292_ = _e1033;
                                    phi_1293_ = _e1093;
                                    phi_1294_ = _e1089;
                                } else {
                                    phi_1291_ = _e1093;
                                    phi_1292_ = _e1089;
                                    phi_1293_ = _e1037;
                                    phi_1294_ = _e1033;
                                }
                                let _e1123 = phi_1291_;
                                let _e1125 = phi_1292_;
                                let _e1127 = phi_1293_;
                                let _e1129 = phi_1294_;
                                let _e1132 = ((_e1129 * _e1123) - (_e1127 * _e1125));
                                if _e1121 {
                                    phi_1302_ = -(_e1132);
                                } else {
                                    phi_1302_ = _e1132;
                                }
                                let _e1135 = phi_1302_;
                                if (_e1033 < _e1061) {
                                    phi_1313_ = true;
                                } else {
                                    if (_e1033 == _e1061) {
                                        phi_1312_ = (_e1037 < _e1065);
                                    } else {
                                        phi_1312_ = false;
                                    }
                                    let _e1140 = phi_1312_;
                                    phi_1313_ = _e1140;
                                }
                                let _e1142 = phi_1313_;
                                if _e1142 {
                                    phi_1317_ = _e1065;
                                    phi_1318_ = _e1061;
                                    phi_1319_ = _e1037;
                                    phi_1320_ = _e1033;
                                } else {
                                    phi_1317_ = _e1037;
                                    phi_1318_ = _e1033;
                                    phi_1319_ = _e1065;
                                    phi_1320_ = _e1061;
                                }
                                let _e1144 = phi_1317_;
                                let _e1146 = phi_1318_;
                                let _e1148 = phi_1319_;
                                let _e1150 = phi_1320_;
                                let _e1153 = ((_e1150 * _e1144) - (_e1148 * _e1146));
                                if _e1142 {
                                    phi_1328_ = -(_e1153);
                                } else {
                                    phi_1328_ = _e1153;
                                }
                                let _e1156 = phi_1328_;
                                if (_e1114 >= 0f) {
                                    if (_e1135 >= 0f) {
                                        if (_e1156 >= 0f) {
                                            phi_1343_ = ((_e1114 + _e1135) + _e1156);
                                            phi_1344_ = false;
                                        } else {
                                            phi_1343_ = f32();
                                            phi_1344_ = true;
                                        }
                                        let _e1163 = phi_1343_;
                                        let _e1165 = phi_1344_;
                                        phi_1345_ = _e1163;
                                        phi_1346_ = _e1165;
                                    } else {
                                        phi_1345_ = f32();
                                        phi_1346_ = true;
                                    }
                                    let _e1167 = phi_1345_;
                                    let _e1169 = phi_1346_;
                                    phi_1347_ = _e1167;
                                    phi_1348_ = _e1169;
                                } else {
                                    phi_1347_ = f32();
                                    phi_1348_ = true;
                                }
                                let _e1171 = phi_1347_;
                                let _e1173 = phi_1348_;
                                if _e1173 {
                                    if (_e1114 <= 0f) {
                                        if (_e1135 <= 0f) {
                                            let _e1176 = (_e1156 <= 0f);
                                            if _e1176 {
                                            }
                                            phi_1366_ = ((_e1114 + _e1135) + _e1156);
                                            phi_1367_ = false;
                                            phi_1368_ = _e1176;
                                        } else {
                                            phi_1366_ = f32();
                                            phi_1367_ = true;
                                            phi_1368_ = false;
                                        }
                                        let _e1180 = phi_1366_;
                                        let _e1182 = phi_1367_;
                                        let _e1184 = phi_1368_;
                                        phi_1369_ = _e1180;
                                        phi_1370_ = _e1182;
                                        phi_1371_ = _e1184;
                                    } else {
                                        phi_1369_ = f32();
                                        phi_1370_ = true;
                                        phi_1371_ = false;
                                    }
                                    let _e1186 = phi_1369_;
                                    let _e1188 = phi_1370_;
                                    let _e1190 = phi_1371_;
                                    if _e1188 {
                                        phi_1375_ = false;
                                    } else {
                                        phi_1375_ = _e1190;
                                    }
                                    let _e1192 = phi_1375_;
                                    phi_1376_ = _e1186;
                                    phi_1377_ = _e1192;
                                } else {
                                    phi_1376_ = _e1171;
                                    phi_1377_ = true;
                                }
                                let _e1194 = phi_1376_;
                                let _e1196 = phi_1377_;
                                if _e1196 {
                                    let _e1197 = (_e1194 == 0f);
                                    if _e1197 {
                                        phi_1703_ = lt_bvh_triangle_Intersection();
                                        phi_1704_ = false;
                                    } else {
                                        let _e1199 = triangles.member[(0u + _e1004)].v0_;
                                        let _e1202 = (_e1199.x - _e138.origin.x);
                                        let _e1205 = (_e1199.y - _e138.origin.y);
                                        let _e1208 = (_e1199.z - _e138.origin.z);
                                        if (_e377 == 0u) {
                                            phi_1408_ = vec3<f32>(_e1205, _e1208, _e1202);
                                        } else {
                                            if (_e377 == 1u) {
                                                phi_1407_ = vec3<f32>(_e1208, _e1202, _e1205);
                                            } else {
                                                phi_1407_ = (_e1199 - _e138.origin);
                                            }
                                            let _e1215 = phi_1407_;
                                            phi_1408_ = _e1215;
                                        }
                                        let _e1217 = phi_1408_;
                                        let _e1219 = triangles.member[(0u + _e1004)].v1_;
                                        let _e1221 = triangles.member[(0u + _e1004)].v0_;
                                        let _e1224 = (_e1219.x - _e1221.x);
                                        let _e1227 = (_e1219.y - _e1221.y);
                                        let _e1230 = (_e1219.z - _e1221.z);
                                        if (_e377 == 0u) {
                                            phi_1434_ = vec3<f32>(_e1227, _e1230, _e1224);
                                        } else {
                                            if (_e377 == 1u) {
                                                phi_1433_ = vec3<f32>(_e1230, _e1224, _e1227);
                                            } else {
                                                phi_1433_ = (_e1219 - _e1221);
                                            }
                                            let _e1237 = phi_1433_;
                                            phi_1434_ = _e1237;
                                        }
                                        let _e1239 = phi_1434_;
                                        let _e1241 = triangles.member[(0u + _e1004)].v2_;
                                        let _e1243 = triangles.member[(0u + _e1004)].v0_;
                                        let _e1246 = (_e1241.x - _e1243.x);
                                        let _e1249 = (_e1241.y - _e1243.y);
                                        let _e1252 = (_e1241.z - _e1243.z);
                                        if (_e377 == 0u) {
                                            phi_1460_ = vec3<f32>(_e1249, _e1252, _e1246);
                                        } else {
                                            if (_e377 == 1u) {
                                                phi_1459_ = vec3<f32>(_e1252, _e1246, _e1249);
                                            } else {
                                                phi_1459_ = (_e1241 - _e1243);
                                            }
                                            let _e1259 = phi_1459_;
                                            phi_1460_ = _e1259;
                                        }
                                        let _e1261 = phi_1460_;
                                        let _e1268 = ((_e1239.y * _e1261.z) - (_e1239.z * _e1261.y));
                                        let _e1275 = ((_e1239.z * _e1261.x) - (_e1239.x * _e1261.z));
                                        let _e1282 = ((_e1239.x * _e1261.y) - (_e1239.y * _e1261.x));
                                        let _e1296 = (((1f / _e392.z) * (((_e1268 * _e1217.x) + (_e1275 * _e1217.y)) + (_e1282 * _e1217.z))) / (((_e1268 * _e396) + (_e1275 * _e399)) + _e1282));
                                        if (_e1296 > _e138.tmin) {
                                            if (_e1296 < _e138.tmax) {
                                                let _e1302 = triangles.member[(0u + _e1004)].v0_;
                                                let _e1304 = triangles.member[(0u + _e1004)].v1_;
                                                if (_e1302.x < _e1304.x) {
                                                    phi_1518_ = _e1302.x;
                                                } else {
                                                    phi_1518_ = _e1304.x;
                                                }
                                                let _e1311 = phi_1518_;
                                                if (_e1302.y < _e1304.y) {
                                                    phi_1527_ = _e1302.y;
                                                } else {
                                                    phi_1527_ = _e1304.y;
                                                }
                                                let _e1318 = phi_1527_;
                                                if (_e1302.z < _e1304.z) {
                                                    phi_1536_ = _e1302.z;
                                                } else {
                                                    phi_1536_ = _e1304.z;
                                                }
                                                let _e1325 = phi_1536_;
                                                let _e1327 = triangles.member[(0u + _e1004)].v2_;
                                                if (_e1311 < _e1327.x) {
                                                    phi_1545_ = _e1311;
                                                } else {
                                                    phi_1545_ = _e1327.x;
                                                }
                                                let _e1332 = phi_1545_;
                                                if (_e1318 < _e1327.y) {
                                                    phi_1552_ = _e1318;
                                                } else {
                                                    phi_1552_ = _e1327.y;
                                                }
                                                let _e1337 = phi_1552_;
                                                if (_e1325 < _e1327.z) {
                                                    phi_1559_ = _e1325;
                                                } else {
                                                    phi_1559_ = _e1327.z;
                                                }
                                                let _e1342 = phi_1559_;
                                                let _e1344 = triangles.member[(0u + _e1004)].v0_;
                                                let _e1346 = triangles.member[(0u + _e1004)].v1_;
                                                if (_e1344.x > _e1346.x) {
                                                    phi_1572_ = _e1344.x;
                                                } else {
                                                    phi_1572_ = _e1346.x;
                                                }
                                                let _e1353 = phi_1572_;
                                                if (_e1344.y > _e1346.y) {
                                                    phi_1581_ = _e1344.y;
                                                } else {
                                                    phi_1581_ = _e1346.y;
                                                }
                                                let _e1360 = phi_1581_;
                                                if (_e1344.z > _e1346.z) {
                                                    phi_1590_ = _e1344.z;
                                                } else {
                                                    phi_1590_ = _e1346.z;
                                                }
                                                let _e1367 = phi_1590_;
                                                let _e1369 = triangles.member[(0u + _e1004)].v2_;
                                                if (_e1353 > _e1369.x) {
                                                    phi_1599_ = _e1353;
                                                } else {
                                                    phi_1599_ = _e1369.x;
                                                }
                                                let _e1374 = phi_1599_;
                                                if (_e1360 > _e1369.y) {
                                                    phi_1606_ = _e1360;
                                                } else {
                                                    phi_1606_ = _e1369.y;
                                                }
                                                let _e1379 = phi_1606_;
                                                if (_e1367 > _e1369.z) {
                                                    phi_1613_ = _e1367;
                                                } else {
                                                    phi_1613_ = _e1369.z;
                                                }
                                                let _e1384 = phi_1613_;
                                                let _e1391 = ((_e1332 - _e138.origin.x) * _e291);
                                                let _e1392 = ((_e1337 - _e138.origin.y) * _e302);
                                                let _e1393 = ((_e1342 - _e138.origin.z) * _e313);
                                                let _e1400 = ((_e1374 - _e138.origin.x) * _e291);
                                                let _e1401 = ((_e1379 - _e138.origin.y) * _e302);
                                                let _e1402 = ((_e1384 - _e138.origin.z) * _e313);
                                                if (_e1391 < _e1400) {
                                                    phi_1636_ = _e1391;
                                                } else {
                                                    phi_1636_ = _e1400;
                                                }
                                                let _e1405 = phi_1636_;
                                                if (_e1392 < _e1401) {
                                                    phi_1641_ = _e1392;
                                                } else {
                                                    phi_1641_ = _e1401;
                                                }
                                                let _e1408 = phi_1641_;
                                                if (_e1393 < _e1402) {
                                                    phi_1646_ = _e1393;
                                                } else {
                                                    phi_1646_ = _e1402;
                                                }
                                                let _e1411 = phi_1646_;
                                                if (_e1391 > _e1400) {
                                                    phi_1654_ = _e1391;
                                                } else {
                                                    phi_1654_ = _e1400;
                                                }
                                                let _e1417 = phi_1654_;
                                                if (_e1392 > _e1401) {
                                                    phi_1659_ = _e1392;
                                                } else {
                                                    phi_1659_ = _e1401;
                                                }
                                                let _e1420 = phi_1659_;
                                                if (_e1393 > _e1402) {
                                                    phi_1664_ = _e1393;
                                                } else {
                                                    phi_1664_ = _e1402;
                                                }
                                                let _e1423 = phi_1664_;
                                                let _e1427 = core_intrinsics_maximum_number_nsz_f32_((_e1405 - _e357), (_e1408 - _e358));
                                                let _e1428 = core_intrinsics_maximum_number_nsz_f32_(_e1427, (_e1411 - _e359));
                                                let _e1429 = core_intrinsics_minimum_number_nsz_f32_((_e1417 + _e357), (_e1420 + _e358));
                                                let _e1430 = core_intrinsics_minimum_number_nsz_f32_(_e1429, (_e1423 + _e359));
                                                if (_e1428 > -300000000000000000000000000000000000000f) {
                                                    phi_1676_ = _e1428;
                                                } else {
                                                    phi_1676_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1433 = phi_1676_;
                                                if (_e1430 < 300000000000000000000000000000000000000f) {
                                                    phi_1681_ = _e1430;
                                                } else {
                                                    phi_1681_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1436 = phi_1681_;
                                                if (_e1296 < _e1433) {
                                                    phi_1686_ = _e1433;
                                                } else {
                                                    phi_1686_ = _e1296;
                                                }
                                                let _e1439 = phi_1686_;
                                                if (_e1439 > _e1436) {
                                                    phi_1691_ = _e1436;
                                                } else {
                                                    phi_1691_ = _e1439;
                                                }
                                                let _e1442 = phi_1691_;
                                                phi_1696_ = lt_bvh_triangle_Intersection(_e1442, (_e1135 / _e1194), (_e1156 / _e1194), (_e1433 <= _e1436));
                                                phi_1697_ = false;
                                            } else {
                                                phi_1696_ = lt_bvh_triangle_Intersection();
                                                phi_1697_ = true;
                                            }
                                            let _e1448 = phi_1696_;
                                            let _e1450 = phi_1697_;
                                            phi_1698_ = _e1448;
                                            phi_1699_ = _e1450;
                                        } else {
                                            phi_1698_ = lt_bvh_triangle_Intersection();
                                            phi_1699_ = true;
                                        }
                                        let _e1452 = phi_1698_;
                                        let _e1454 = phi_1699_;
                                        if _e1454 {
                                        }
                                        phi_1703_ = _e1452;
                                        phi_1704_ = _e1454;
                                    }
                                    let _e1456 = phi_1703_;
                                    let _e1458 = phi_1704_;
                                    phi_1705_ = _e1456;
                                    phi_1706_ = _e1197;
                                    phi_1707_ = _e1458;
                                } else {
                                    phi_1705_ = lt_bvh_triangle_Intersection();
                                    phi_1706_ = true;
                                    phi_1707_ = false;
                                }
                                let _e1460 = phi_1705_;
                                let _e1462 = phi_1706_;
                                let _e1464 = phi_1707_;
                                if _e1462 {
                                    phi_1711_ = true;
                                } else {
                                    phi_1711_ = _e1464;
                                }
                                let _e1466 = phi_1711_;
                                if _e1466 {
                                    phi_1715_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1715_ = _e1460;
                                }
                                let _e1468 = phi_1715_;
                                if _e1468.is_hit {
                                    if (_e1468.t > _e138.tmin) {
                                        if (_e1468.t < _e993.t) {
                                            phi_1764_ = true;
                                        } else {
                                            if (_e1468.t == _e993.t) {
                                                if (_e993.triangle != 4294967295u) {
                                                    if (_e1004 < _e993.triangle) {
                                                        phi_1755_ = true;
                                                    } else {
                                                        if (_e1004 == _e993.triangle) {
                                                            phi_1754_ = (4294967295u < _e993.instance);
                                                        } else {
                                                            phi_1754_ = false;
                                                        }
                                                        let _e1487 = phi_1754_;
                                                        phi_1755_ = _e1487;
                                                    }
                                                    let _e1489 = phi_1755_;
                                                    phi_1756_ = _e1489;
                                                    phi_1757_ = false;
                                                } else {
                                                    phi_1756_ = bool();
                                                    phi_1757_ = true;
                                                }
                                                let _e1491 = phi_1756_;
                                                let _e1493 = phi_1757_;
                                                phi_1758_ = _e1491;
                                                phi_1759_ = _e1493;
                                            } else {
                                                phi_1758_ = bool();
                                                phi_1759_ = true;
                                            }
                                            let _e1495 = phi_1758_;
                                            let _e1497 = phi_1759_;
                                            if _e1497 {
                                                phi_1763_ = false;
                                            } else {
                                                phi_1763_ = _e1495;
                                            }
                                            let _e1499 = phi_1763_;
                                            phi_1764_ = _e1499;
                                        }
                                        let _e1501 = phi_1764_;
                                        if _e1501 {
                                            let _e1503 = triangles.member[(0u + _e1004)].i0_;
                                            if ((_e1503 & 2147483648u) == 0u) {
                                                phi_1778_ = true;
                                            } else {
                                                if true {
                                                }
                                                phi_1778_ = true;
                                            }
                                            let _e1507 = phi_1778_;
                                            if _e1507 {
                                                phi_1786_ = lt_bvh_Hit(_e1468.t, _e1468.u, _e1468.v, _e1004, 4294967295u);
                                            } else {
                                                phi_1786_ = _e993;
                                            }
                                            let _e1513 = phi_1786_;
                                            phi_1787_ = _e1513;
                                        } else {
                                            phi_1787_ = _e993;
                                        }
                                        let _e1515 = phi_1787_;
                                        phi_1788_ = _e1515;
                                    } else {
                                        phi_1788_ = _e993;
                                    }
                                    let _e1517 = phi_1788_;
                                    phi_1789_ = _e1517;
                                } else {
                                    phi_1789_ = _e993;
                                }
                                let _e1519 = phi_1789_;
                                phi_1129_ = _e1519;
                                phi_1132_ = (_e995 & (_e995 - 1u));
                                phi_1790_ = true;
                            }
                            let _e1521 = phi_1129_;
                            let _e1523 = phi_1132_;
                            let _e1525 = phi_1790_;
                            continue;
                            continuing {
                                phi_1128_ = _e1521;
                                phi_1131_ = _e1523;
                                break if !(_e1525);
                            }
                        }
                        let _e1528 = local.group_mask;
                        if ((_e1528 & 4278190080u) == 0u) {
                            let _e1532 = local.len;
                            if (_e1532 == 0u) {
                                phi_1829_ = false;
                            } else {
                                let _e1536 = local.len;
                                local.len = (_e1536 - 1u);
                                let _e1539 = local.len;
                                if (_e1539 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1544 = local.first[(0u + _e1539)];
                                local.group = _e1544;
                                let _e1547 = local.len;
                                if (_e1547 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1552 = local.mask[(0u + _e1547)];
                                local.group_mask = _e1552;
                                phi_1829_ = true;
                            }
                            let _e1555 = phi_1829_;
                            phi_1830_ = _e1555;
                        } else {
                            phi_1830_ = true;
                        }
                        let _e1557 = phi_1830_;
                        if _e1557 {
                            let _e1559 = local.group_mask;
                            let _e1565 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1559)), 32u, (_e1559 == 0u)));
                            let _e1569 = local.group_mask;
                            let _e1583 = local.group_mask;
                            local.group_mask = (_e1583 & ~((1u << bitcast<u32>((_e1565 & 31u)))));
                            let _e1586 = local.group;
                            phi_1861_ = (_e1586 + countOneBits(((_e1569 & ~((4294967295u << bitcast<u32>((((_e1565 - 24u) ^ _e412) & 31u))))) & 255u)));
                        } else {
                            phi_1861_ = 4294967295u;
                        }
                        let _e1589 = phi_1861_;
                        let _e2289 = local_4;
                        phi_792_ = _e2289;
                        phi_795_ = _e1589;
                    } else {
                        phi_792_ = lt_bvh_Hit();
                        phi_795_ = u32();
                    }
                    let _e1591 = phi_792_;
                    let _e1593 = phi_795_;
                    continue;
                    continuing {
                        phi_791_ = _e1591;
                        phi_794_ = _e1593;
                        break if !(_e553);
                    }
                }
                let _e2293 = local_5;
                phi_1862_ = _e2293;
            }
            let _e1596 = phi_1862_;
            phi_1863_ = _e1596;
            phi_1864_ = _e210;
        } else {
            phi_1863_ = lt_bvh_Hit();
            phi_1864_ = true;
        }
        let _e1598 = phi_1863_;
        let _e1600 = phi_1864_;
        if _e1600 {
            phi_1868_ = _e140;
        } else {
            phi_1868_ = _e1598;
        }
        let _e1602 = phi_1868_;
        if (_e1602.triangle != 4294967295u) {
            let _e1608 = ((1f - _e1602.u) - _e1602.v);
            if (_e1602.triangle < _e68) {
            } else {
                return;
            }
            let _e1614 = triangles.member[(0u + _e1602.triangle)];
            let _e1639 = (((_e1614.v0_.x * _e1608) + (_e1614.v1_.x * _e1602.u)) + (_e1614.v2_.x * _e1602.v));
            let _e1640 = (((_e1614.v0_.y * _e1608) + (_e1614.v1_.y * _e1602.u)) + (_e1614.v2_.y * _e1602.v));
            let _e1641 = (((_e1614.v0_.z * _e1608) + (_e1614.v1_.z * _e1602.u)) + (_e1614.v2_.z * _e1602.v));
            let _e1644 = abs(_e1614.v0_.x);
            let _e1646 = abs(_e1614.v0_.y);
            let _e1648 = abs(_e1614.v0_.z);
            let _e1650 = abs(_e1614.v1_.x);
            let _e1652 = abs(_e1614.v1_.y);
            let _e1654 = abs(_e1614.v1_.z);
            if (_e1644 > _e1650) {
                phi_1933_ = _e1644;
            } else {
                phi_1933_ = _e1650;
            }
            let _e1657 = phi_1933_;
            if (_e1646 > _e1652) {
                phi_1938_ = _e1646;
            } else {
                phi_1938_ = _e1652;
            }
            let _e1660 = phi_1938_;
            if (_e1648 > _e1654) {
                phi_1943_ = _e1648;
            } else {
                phi_1943_ = _e1654;
            }
            let _e1663 = phi_1943_;
            let _e1665 = abs(_e1614.v2_.x);
            let _e1667 = abs(_e1614.v2_.y);
            let _e1669 = abs(_e1614.v2_.z);
            if (_e1657 > _e1665) {
                phi_1954_ = _e1657;
            } else {
                phi_1954_ = _e1665;
            }
            let _e1672 = phi_1954_;
            if (_e1660 > _e1667) {
                phi_1959_ = _e1660;
            } else {
                phi_1959_ = _e1667;
            }
            let _e1675 = phi_1959_;
            if (_e1663 > _e1669) {
                phi_1964_ = _e1663;
            } else {
                phi_1964_ = _e1669;
            }
            let _e1678 = phi_1964_;
            let _e1681 = (_e1614.v1_.x - _e1614.v0_.x);
            let _e1684 = (_e1614.v1_.y - _e1614.v0_.y);
            let _e1687 = (_e1614.v1_.z - _e1614.v0_.z);
            let _e1690 = (_e1614.v2_.x - _e1614.v0_.x);
            let _e1693 = (_e1614.v2_.y - _e1614.v0_.y);
            let _e1696 = (_e1614.v2_.z - _e1614.v0_.z);
            let _e1700 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1684), abs(_e1687));
            let _e1701 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1681), _e1700);
            let _e1702 = (_e1681 / _e1701);
            let _e1703 = (_e1684 / _e1701);
            let _e1704 = (_e1687 / _e1701);
            let _e1708 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1693), abs(_e1696));
            let _e1709 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1690), _e1708);
            let _e1710 = (_e1690 / _e1709);
            let _e1711 = (_e1693 / _e1709);
            let _e1712 = (_e1696 / _e1709);
            let _e1715 = ((_e1703 * _e1712) - (_e1711 * _e1704));
            let _e1718 = ((_e1704 * _e1710) - (_e1712 * _e1702));
            let _e1721 = ((_e1702 * _e1711) - (_e1710 * _e1703));
            let _e1723 = p.member.eye;
            let _e1736 = (1f / sqrt((((_e1715 * _e1715) + (_e1718 * _e1718)) + (_e1721 * _e1721))));
            let _e1737 = (_e1715 * _e1736);
            let _e1738 = (_e1718 * _e1736);
            let _e1739 = (_e1721 * _e1736);
            if ((((_e1737 * (_e1723.x - _e1639)) + (_e1738 * (_e1723.y - _e1640))) + (_e1739 * (_e1723.z - _e1641))) < 0f) {
                phi_2040_ = vec3<f32>(-(_e1737), -(_e1738), -(_e1739));
            } else {
                phi_2040_ = vec3<f32>(_e1737, _e1738, _e1739);
            }
            let _e1752 = phi_2040_;
            if (_e1602.triangle < _e68) {
            } else {
                return;
            }
            let _e1757 = triangles.member[(0u + _e1602.triangle)];
            let _e1759 = (_e1757.i0_ & 2147483647u);
            if (_e1759 < _e71) {
            } else {
                return;
            }
            let _e1765 = vertices.member[(0u + _e1759)];
            if (_e1757.i1_ < _e71) {
            } else {
                return;
            }
            let _e1769 = vertices.member[(0u + _e1757.i1_)];
            if (_e1757.i2_ < _e71) {
            } else {
                return;
            }
            let _e1773 = vertices.member[(0u + _e1757.i2_)];
            let _e1774 = array<abi_Vertex, 3>(_e1765, _e1769, _e1773);
            if (_e1774[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e1780 = materials.member[(0u + _e1774[0].material)];
            let _e1797 = (1f / 255f);
            let _e1816 = (1f / 255f);
            let _e1838 = (1f / 255f);
            let _e1851 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e1608, _e1602.u, _e1602.v));
            let _e1853 = ((_e1780.base_color.x * ((((f32((_e1774[0].color & 255u)) * _e1797) * _e1608) + ((f32((_e1774[1].color & 255u)) * _e1816) * _e1602.u)) + ((f32((_e1774[2].color & 255u)) * _e1838) * _e1602.v))) * _e1851.x);
            let _e1855 = ((_e1780.base_color.y * ((((f32(((_e1774[0].color >> bitcast<u32>(8i)) & 255u)) * _e1797) * _e1608) + ((f32(((_e1774[1].color >> bitcast<u32>(8i)) & 255u)) * _e1816) * _e1602.u)) + ((f32(((_e1774[2].color >> bitcast<u32>(8i)) & 255u)) * _e1838) * _e1602.v))) * _e1851.y);
            let _e1857 = ((_e1780.base_color.z * ((((f32(((_e1774[0].color >> bitcast<u32>(16i)) & 255u)) * _e1797) * _e1608) + ((f32(((_e1774[1].color >> bitcast<u32>(16i)) & 255u)) * _e1816) * _e1602.u)) + ((f32(((_e1774[2].color >> bitcast<u32>(16i)) & 255u)) * _e1838) * _e1602.v))) * _e1851.z);
            let _e1858 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1675, _e1678);
            let _e1859 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1672, _e1858);
            if ((_e1780.flags & 2u) == 0u) {
                phi_2161_ = 0u;
            } else {
                phi_2161_ = 1u;
            }
            let _e1864 = phi_2161_;
            if (_e1774[0].normal == 2147516416u) {
                phi_2364_ = _e1752;
            } else {
                let _e1877 = (f32((bitcast<i32>((_e1774[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1883 = (f32((bitcast<i32>(_e1774[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1887 = ((1f - abs(_e1877)) - abs(_e1883));
                if (_e1887 < 0f) {
                    phi_2188_ = -(_e1887);
                } else {
                    phi_2188_ = 0f;
                }
                let _e1891 = phi_2188_;
                if (_e1877 < 0f) {
                    phi_2195_ = (_e1877 + _e1891);
                } else {
                    phi_2195_ = (_e1877 - _e1891);
                }
                let _e1896 = phi_2195_;
                if (_e1883 < 0f) {
                    phi_2202_ = (_e1883 + _e1891);
                } else {
                    phi_2202_ = (_e1883 - _e1891);
                }
                let _e1901 = phi_2202_;
                let _e1908 = (1f / sqrt((((_e1896 * _e1896) + (_e1901 * _e1901)) + (_e1887 * _e1887))));
                let _e1924 = (f32((bitcast<i32>((_e1774[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1930 = (f32((bitcast<i32>(_e1774[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1934 = ((1f - abs(_e1924)) - abs(_e1930));
                if (_e1934 < 0f) {
                    phi_2237_ = -(_e1934);
                } else {
                    phi_2237_ = 0f;
                }
                let _e1938 = phi_2237_;
                if (_e1924 < 0f) {
                    phi_2244_ = (_e1924 + _e1938);
                } else {
                    phi_2244_ = (_e1924 - _e1938);
                }
                let _e1943 = phi_2244_;
                if (_e1930 < 0f) {
                    phi_2251_ = (_e1930 + _e1938);
                } else {
                    phi_2251_ = (_e1930 - _e1938);
                }
                let _e1948 = phi_2251_;
                let _e1955 = (1f / sqrt((((_e1943 * _e1943) + (_e1948 * _e1948)) + (_e1934 * _e1934))));
                let _e1974 = (f32((bitcast<i32>((_e1774[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1980 = (f32((bitcast<i32>(_e1774[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1984 = ((1f - abs(_e1974)) - abs(_e1980));
                if (_e1984 < 0f) {
                    phi_2289_ = -(_e1984);
                } else {
                    phi_2289_ = 0f;
                }
                let _e1988 = phi_2289_;
                if (_e1974 < 0f) {
                    phi_2296_ = (_e1974 + _e1988);
                } else {
                    phi_2296_ = (_e1974 - _e1988);
                }
                let _e1993 = phi_2296_;
                if (_e1980 < 0f) {
                    phi_2303_ = (_e1980 + _e1988);
                } else {
                    phi_2303_ = (_e1980 - _e1988);
                }
                let _e1998 = phi_2303_;
                let _e2005 = (1f / sqrt((((_e1993 * _e1993) + (_e1998 * _e1998)) + (_e1984 * _e1984))));
                let _e2016 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e1896 * _e1908) * _e1608) + ((_e1943 * _e1955) * _e1602.u)) + ((_e1993 * _e2005) * _e1602.v)), ((((_e1901 * _e1908) * _e1608) + ((_e1948 * _e1955) * _e1602.u)) + ((_e1998 * _e2005) * _e1602.v)), ((((_e1887 * _e1908) * _e1608) + ((_e1934 * _e1955) * _e1602.u)) + ((_e1984 * _e2005) * _e1602.v))));
                let _e2028 = sqrt((((_e2016.x * _e2016.x) + (_e2016.y * _e2016.y)) + (_e2016.z * _e2016.z)));
                if (_e2028 > 0f) {
                    let _e2031 = (_e2016.x / _e2028);
                    let _e2033 = (_e2016.y / _e2028);
                    let _e2035 = (_e2016.z / _e2028);
                    if ((((_e2031 * _e1752.x) + (_e2033 * _e1752.y)) + (_e2035 * _e1752.z)) < 0f) {
                        phi_2362_ = vec3<f32>(-(_e2031), -(_e2033), -(_e2035));
                    } else {
                        phi_2362_ = (_e2016 / vec3(_e2028));
                    }
                    let _e2052 = phi_2362_;
                    phi_2363_ = _e2052;
                } else {
                    phi_2363_ = _e1752;
                }
                let _e2054 = phi_2363_;
                phi_2364_ = _e2054;
            }
            let _e2056 = phi_2364_;
            if (_e1853 > 0f) {
                if (_e1853 < 1f) {
                    phi_2373_ = _e1853;
                } else {
                    phi_2373_ = 1f;
                }
                let _e2060 = phi_2373_;
                phi_2374_ = _e2060;
            } else {
                phi_2374_ = 0f;
            }
            let _e2062 = phi_2374_;
            if (_e1855 > 0f) {
                if (_e1855 < 1f) {
                    phi_2384_ = _e1855;
                } else {
                    phi_2384_ = 1f;
                }
                let _e2067 = phi_2384_;
                phi_2385_ = _e2067;
            } else {
                phi_2385_ = 0f;
            }
            let _e2069 = phi_2385_;
            if (_e1857 > 0f) {
                if (_e1857 < 1f) {
                    phi_2395_ = _e1857;
                } else {
                    phi_2395_ = 1f;
                }
                let _e2074 = phi_2395_;
                phi_2396_ = _e2074;
            } else {
                phi_2396_ = 0f;
            }
            let _e2076 = phi_2396_;
            let _e2079 = ((sqrt(_e2062) * 255f) + 0.5f);
            let _e2088 = ((sqrt(_e2069) * 255f) + 0.5f);
            let _e2100 = ((sqrt(_e2076) * 255f) + 0.5f);
            phi_2431_ = abi_Sample(vec3<f32>(_e1639, _e1640, _e1641), _e1859, _e1752, _e1864, _e2056, ((select(select(u32(_e2079), 0u, (_e2079 < bitcast<f32>(0u))), 4294967295u, (_e2079 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2088), 0u, (_e2088 < bitcast<f32>(0u))), 4294967295u, (_e2088 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2100), 0u, (_e2100 < bitcast<f32>(0u))), 4294967295u, (_e2100 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_2431_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2114 = phi_2431_;
        if (_e83.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e83.shift)] = _e2114;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
