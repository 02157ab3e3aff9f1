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

struct type_22 {
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

struct type_52 {
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
var<uniform> p: type_52;
@group(0) @binding(1) 
var<storage> nodes: type_30;
@group(0) @binding(2) 
var<storage> triangles: type_34;
@group(0) @binding(5) 
var<storage, read_write> samples: type_9;
@group(0) @binding(6) 
var<storage> before: type_22;
@group(0) @binding(7) 
var<storage, read_write> past: type_22;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_193_: lt_mask_LightPlace;
    var phi_194_: bool;
    var phi_195_: lt_mask_LightPlace;
    var phi_196_: bool;
    var phi_201_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_193_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_194_ = false;
        } else {
            phi_193_ = lt_mask_LightPlace();
            phi_194_ = true;
        }
        let _e75 = phi_193_;
        let _e77 = phi_194_;
        phi_195_ = _e75;
        phi_196_ = _e77;
    } else {
        phi_195_ = lt_mask_LightPlace();
        phi_196_ = true;
    }
    let _e79 = phi_195_;
    let _e81 = phi_196_;
    if _e81 {
        phi_201_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_201_ = _e79;
    }
    let _e86 = phi_201_;
    return lt_mask_LightPlace(_e86.word, _e86.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_216_: bool;
    var phi_220_: f32;

    if (param_3 != param_3) {
        phi_216_ = true;
    } else {
        let _e65 = (param_4 >= param_3);
        if _e65 {
        }
        phi_216_ = _e65;
    }
    let _e67 = phi_216_;
    if _e67 {
        phi_220_ = param_4;
    } else {
        phi_220_ = param_3;
    }
    let _e69 = phi_220_;
    return _e69;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_232_: bool;
    var phi_236_: f32;

    if (param_5 != param_5) {
        phi_232_ = true;
    } else {
        let _e65 = (param_6 <= param_5);
        if _e65 {
        }
        phi_232_ = _e65;
    }
    let _e67 = phi_232_;
    if _e67 {
        phi_236_ = param_6;
    } else {
        phi_236_ = param_5;
    }
    let _e69 = phi_236_;
    return _e69;
}

fn _lt_bvh_ray_Ray_new(param_7: vec3<f32>, param_8: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_7, 0f, param_8, 300000000000000000000000000000000000000f);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_9: f32, param_10: f32) -> f32 {
    var phi_248_: f32;

    if (param_9 > param_10) {
        phi_248_ = param_9;
    } else {
        phi_248_ = param_10;
    }
    let _e66 = phi_248_;
    return _e66;
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
    var phi_392_: bool;
    var phi_393_: bool;
    var phi_394_: bool;
    var phi_398_: bool;
    var phi_399_: bool;
    var phi_400_: bool;
    var phi_401_: bool;
    var phi_402_: bool;
    var phi_403_: bool;
    var phi_404_: bool;
    var phi_405_: bool;
    var phi_406_: bool;
    var phi_407_: bool;
    var phi_408_: bool;
    var phi_409_: bool;
    var phi_410_: bool;
    var phi_411_: bool;
    var phi_412_: bool;
    var phi_413_: bool;
    var phi_414_: bool;
    var phi_415_: bool;
    var phi_419_: bool;
    var phi_423_: bool;
    var phi_498_: f32;
    var phi_505_: f32;
    var phi_513_: f32;
    var phi_520_: f32;
    var phi_528_: f32;
    var phi_535_: f32;
    var phi_560_: f32;
    var phi_565_: f32;
    var phi_570_: f32;
    var phi_603_: bool;
    var phi_604_: bool;
    var phi_612_: u32;
    var phi_613_: u32;
    var phi_631_: vec3<f32>;
    var phi_632_: vec3<f32>;
    var phi_646_: u32;
    var phi_651_: u32;
    var phi_656_: u32;
    var phi_770_: bool;
    var phi_771_: bool;
    var phi_802_: u32;
    var phi_804_: lt_bvh_Hit;
    var phi_807_: u32;
    var phi_892_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_919_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_946_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_952_: u32;
    var phi_955_: u32;
    var phi_969_: u32;
    var phi_979_: u32;
    var phi_989_: u32;
    var phi_1007_: u32;
    var phi_1017_: u32;
    var phi_1027_: u32;
    var phi_1063_: u32;
    var phi_1076_: u32;
    var phi_1081_: u32;
    var phi_1082_: u32;
    var phi_1083_: u32;
    var phi_953_: u32;
    var phi_956_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1141_: lt_bvh_Hit;
    var phi_1144_: u32;
    var phi_1190_: vec3<f32>;
    var phi_1191_: vec3<f32>;
    var phi_1222_: vec3<f32>;
    var phi_1223_: vec3<f32>;
    var phi_1254_: vec3<f32>;
    var phi_1255_: vec3<f32>;
    var phi_1273_: bool;
    var phi_1274_: bool;
    var phi_1278_: f32;
    var phi_1279_: f32;
    var phi_1280_: f32;
    var phi_1281_: f32;
    var phi_1289_: f32;
    var phi_1299_: bool;
    var phi_1300_: bool;
    var phi_1304_: f32;
    var phi_1305_: f32;
    var phi_1306_: f32;
    var phi_1307_: f32;
    var phi_1315_: f32;
    var phi_1325_: bool;
    var phi_1326_: bool;
    var phi_1330_: f32;
    var phi_1331_: f32;
    var phi_1332_: f32;
    var phi_1333_: f32;
    var phi_1341_: f32;
    var phi_1356_: f32;
    var phi_1357_: bool;
    var phi_1358_: f32;
    var phi_1359_: bool;
    var phi_1360_: f32;
    var phi_1361_: bool;
    var phi_1379_: f32;
    var phi_1380_: bool;
    var phi_1381_: bool;
    var phi_1382_: f32;
    var phi_1383_: bool;
    var phi_1384_: bool;
    var phi_1388_: bool;
    var phi_1389_: f32;
    var phi_1390_: bool;
    var phi_1420_: vec3<f32>;
    var phi_1421_: vec3<f32>;
    var phi_1446_: vec3<f32>;
    var phi_1447_: vec3<f32>;
    var phi_1472_: vec3<f32>;
    var phi_1473_: vec3<f32>;
    var phi_1531_: f32;
    var phi_1540_: f32;
    var phi_1549_: f32;
    var phi_1558_: f32;
    var phi_1565_: f32;
    var phi_1572_: f32;
    var phi_1585_: f32;
    var phi_1594_: f32;
    var phi_1603_: f32;
    var phi_1612_: f32;
    var phi_1619_: f32;
    var phi_1626_: f32;
    var phi_1649_: f32;
    var phi_1654_: f32;
    var phi_1659_: f32;
    var phi_1667_: f32;
    var phi_1672_: f32;
    var phi_1677_: f32;
    var phi_1689_: f32;
    var phi_1694_: f32;
    var phi_1699_: f32;
    var phi_1704_: f32;
    var phi_1709_: lt_bvh_triangle_Intersection;
    var phi_1710_: bool;
    var phi_1711_: lt_bvh_triangle_Intersection;
    var phi_1712_: bool;
    var phi_1716_: lt_bvh_triangle_Intersection;
    var phi_1717_: bool;
    var phi_1718_: lt_bvh_triangle_Intersection;
    var phi_1719_: bool;
    var phi_1720_: bool;
    var phi_1724_: bool;
    var phi_1728_: lt_bvh_triangle_Intersection;
    var phi_1767_: bool;
    var phi_1768_: bool;
    var phi_1769_: bool;
    var phi_1770_: bool;
    var phi_1771_: bool;
    var phi_1772_: bool;
    var phi_1776_: bool;
    var phi_1777_: bool;
    var phi_1791_: bool;
    var phi_1799_: lt_bvh_Hit;
    var phi_1800_: lt_bvh_Hit;
    var phi_1801_: lt_bvh_Hit;
    var phi_1802_: lt_bvh_Hit;
    var phi_1142_: lt_bvh_Hit;
    var phi_1145_: u32;
    var phi_1803_: bool;
    var phi_1842_: bool;
    var phi_1843_: bool;
    var phi_1874_: u32;
    var phi_805_: lt_bvh_Hit;
    var phi_808_: u32;
    var phi_1875_: lt_bvh_Hit;
    var phi_1876_: lt_bvh_Hit;
    var phi_1877_: bool;
    var phi_1881_: lt_bvh_Hit;
    var phi_1946_: f32;
    var phi_1951_: f32;
    var phi_1956_: f32;
    var phi_1967_: f32;
    var phi_1972_: f32;
    var phi_1977_: f32;
    var phi_2053_: vec3<f32>;
    var phi_2174_: u32;
    var phi_2201_: f32;
    var phi_2208_: f32;
    var phi_2215_: f32;
    var phi_2250_: f32;
    var phi_2257_: f32;
    var phi_2264_: f32;
    var phi_2302_: f32;
    var phi_2309_: f32;
    var phi_2316_: f32;
    var phi_2375_: vec3<f32>;
    var phi_2376_: vec3<f32>;
    var phi_2377_: vec3<f32>;
    var phi_2386_: f32;
    var phi_2387_: f32;
    var phi_2397_: f32;
    var phi_2398_: f32;
    var phi_2408_: f32;
    var phi_2409_: f32;
    var phi_2444_: abi_Sample;
    var phi_2535_: vec3<f32>;
    var local_4: lt_bvh_Hit;
    var local_5: lt_bvh_Hit;

    let _e63 = id_1;
    let _e67 = arrayLength((&nodes.member));
    let _e70 = arrayLength((&triangles.member));
    let _e73 = arrayLength((&vertices.member));
    let _e82 = arrayLength((&before.member));
    let _e88 = p.member.size[0u];
    let _e90 = p.member.size[1u];
    let _e91 = lt_shaders_entry_pixel_index(_e63, _e88, _e90);
    if (bitcast<i32>(_e91.word) != 0i) {
        let _e99 = p.member.eye;
        let _e104 = p.member.size[0u];
        let _e108 = ((((f32(_e63.x) + 0.5f) / f32(_e104)) * 2f) - 1f);
        let _e113 = p.member.size[1u];
        let _e117 = (1f - (((f32(_e63.y) + 0.5f) / f32(_e113)) * 2f));
        let _e119 = p.member.forward;
        let _e121 = p.member.right;
        let _e135 = p.member.up;
        let _e146 = _lt_bvh_ray_Ray_new(_e99, vec3<f32>(((_e119.x + (_e121.x * _e108)) + (_e135.x * _e117)), ((_e119.y + (_e121.y * _e108)) + (_e135.y * _e117)), ((_e119.z + (_e121.z * _e108)) + (_e135.z * _e117))));
        let _e148 = lt_bvh_Hit(_e146.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e158 = abs(_e146.direction.x);
        let _e160 = abs(_e146.direction.y);
        let _e162 = abs(_e146.direction.z);
        if (abs(_e146.origin.x) < 1000000000000000f) {
            if (abs(_e146.origin.y) < 1000000000000000f) {
                if (abs(_e146.origin.z) < 1000000000000000f) {
                    if (_e158 < 1000000000000000f) {
                        if (_e160 < 1000000000000000f) {
                            if (_e162 < 1000000000000000f) {
                                if (_e158 > 0f) {
                                    phi_393_ = bool();
                                    phi_394_ = true;
                                } else {
                                    let _e170 = (_e160 > 0f);
                                    if _e170 {
                                        phi_392_ = bool();
                                    } else {
                                        phi_392_ = (_e162 > 0f);
                                    }
                                    let _e173 = phi_392_;
                                    phi_393_ = _e173;
                                    phi_394_ = _e170;
                                }
                                let _e175 = phi_393_;
                                let _e177 = phi_394_;
                                if _e177 {
                                    phi_398_ = true;
                                } else {
                                    phi_398_ = _e175;
                                }
                                let _e179 = phi_398_;
                                phi_399_ = _e179;
                                phi_400_ = false;
                            } else {
                                phi_399_ = bool();
                                phi_400_ = true;
                            }
                            let _e181 = phi_399_;
                            let _e183 = phi_400_;
                            phi_401_ = _e181;
                            phi_402_ = false;
                            phi_403_ = _e183;
                        } else {
                            phi_401_ = bool();
                            phi_402_ = true;
                            phi_403_ = false;
                        }
                        let _e185 = phi_401_;
                        let _e187 = phi_402_;
                        let _e189 = phi_403_;
                        phi_404_ = _e185;
                        phi_405_ = _e187;
                        phi_406_ = _e189;
                    } else {
                        phi_404_ = bool();
                        phi_405_ = true;
                        phi_406_ = false;
                    }
                    let _e191 = phi_404_;
                    let _e193 = phi_405_;
                    let _e195 = phi_406_;
                    phi_407_ = _e191;
                    phi_408_ = _e193;
                    phi_409_ = _e195;
                } else {
                    phi_407_ = bool();
                    phi_408_ = true;
                    phi_409_ = false;
                }
                let _e197 = phi_407_;
                let _e199 = phi_408_;
                let _e201 = phi_409_;
                phi_410_ = _e197;
                phi_411_ = _e199;
                phi_412_ = _e201;
            } else {
                phi_410_ = bool();
                phi_411_ = true;
                phi_412_ = false;
            }
            let _e203 = phi_410_;
            let _e205 = phi_411_;
            let _e207 = phi_412_;
            phi_413_ = _e203;
            phi_414_ = _e205;
            phi_415_ = _e207;
        } else {
            phi_413_ = bool();
            phi_414_ = true;
            phi_415_ = false;
        }
        let _e209 = phi_413_;
        let _e211 = phi_414_;
        let _e213 = phi_415_;
        if _e211 {
            phi_419_ = true;
        } else {
            phi_419_ = _e213;
        }
        let _e215 = phi_419_;
        if _e215 {
            phi_423_ = false;
        } else {
            phi_423_ = _e209;
        }
        let _e217 = phi_423_;
        if _e217 {
            let _e218 = (0u >= _e67);
            if _e218 {
                phi_1875_ = lt_bvh_Hit();
            } else {
                if (0u < _e67) {
                } else {
                    return;
                }
                let _e224 = nodes.member[(0u + 0u)].frame[0u];
                let _e228 = nodes.member[(0u + 0u)].frame[1u];
                let _e232 = nodes.member[(0u + 0u)].frame[2u];
                let _e236 = nodes.member[(0u + 0u)].frame[0u];
                let _e240 = nodes.member[(0u + 0u)].frame[1u];
                let _e244 = nodes.member[(0u + 0u)].frame[2u];
                let _e248 = nodes.member[(0u + 0u)].frame[3u];
                let _e286 = core_intrinsics_maximum_number_nsz_f32_(abs(_e146.direction.x), abs(_e146.direction.y));
                let _e287 = core_intrinsics_maximum_number_nsz_f32_(_e286, abs(_e146.direction.z));
                let _e288 = (_e287 * 0.0000000000009094947f);
                if (abs(_e146.direction.x) < _e288) {
                    phi_498_ = _e288;
                } else {
                    phi_498_ = abs(_e146.direction.x);
                }
                let _e295 = phi_498_;
                if (_e146.direction.x < 0f) {
                    phi_505_ = (-1f / _e295);
                } else {
                    phi_505_ = (1f / _e295);
                }
                let _e300 = phi_505_;
                if (abs(_e146.direction.y) < _e288) {
                    phi_513_ = _e288;
                } else {
                    phi_513_ = abs(_e146.direction.y);
                }
                let _e307 = phi_513_;
                if (_e146.direction.y < 0f) {
                    phi_520_ = (-1f / _e307);
                } else {
                    phi_520_ = (1f / _e307);
                }
                let _e312 = phi_520_;
                if (abs(_e146.direction.z) < _e288) {
                    phi_528_ = _e288;
                } else {
                    phi_528_ = abs(_e146.direction.z);
                }
                let _e319 = phi_528_;
                if (_e146.direction.z < 0f) {
                    phi_535_ = (-1f / _e319);
                } else {
                    phi_535_ = (1f / _e319);
                }
                let _e324 = phi_535_;
                let _e332 = abs((bitcast<f32>(_e224) - _e146.origin.x));
                let _e333 = abs((bitcast<f32>(_e228) - _e146.origin.y));
                let _e334 = abs((bitcast<f32>(_e232) - _e146.origin.z));
                let _e342 = abs(((bitcast<f32>(_e236) + (bitcast<f32>((((_e248 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e146.origin.x));
                let _e343 = abs(((bitcast<f32>(_e240) + (bitcast<f32>((((_e248 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e146.origin.y));
                let _e344 = abs(((bitcast<f32>(_e244) + (bitcast<f32>((((_e248 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e146.origin.z));
                if (_e332 > _e342) {
                    phi_560_ = _e332;
                } else {
                    phi_560_ = _e342;
                }
                let _e347 = phi_560_;
                if (_e333 > _e343) {
                    phi_565_ = _e333;
                } else {
                    phi_565_ = _e343;
                }
                let _e350 = phi_565_;
                if (_e334 > _e344) {
                    phi_570_ = _e334;
                } else {
                    phi_570_ = _e344;
                }
                let _e353 = phi_570_;
                let _e354 = core_intrinsics_maximum_number_nsz_f32_(_e347, _e350);
                let _e355 = core_intrinsics_maximum_number_nsz_f32_(_e354, _e353);
                let _e360 = (_e355 * 0.0000019073486f);
                let _e361 = (abs(_e300) * _e360);
                let _e362 = (abs(_e312) * _e360);
                let _e363 = (abs(_e324) * _e360);
                let _e367 = (_e355 * 0.0000009536743f);
                let _e368 = (abs(_e300) * _e367);
                let _e369 = (abs(_e312) * _e367);
                let _e370 = (abs(_e324) * _e367);
                let _e373 = abs(_e146.direction.x);
                let _e375 = abs(_e146.direction.y);
                let _e377 = abs(_e146.direction.z);
                if (_e373 >= _e375) {
                    if (_e373 >= _e377) {
                        phi_603_ = false;
                    } else {
                        phi_603_ = true;
                    }
                    let _e381 = phi_603_;
                    phi_604_ = _e381;
                } else {
                    phi_604_ = true;
                }
                let _e383 = phi_604_;
                if _e383 {
                    if (_e375 >= _e377) {
                        phi_612_ = 1u;
                    } else {
                        phi_612_ = 2u;
                    }
                    let _e386 = phi_612_;
                    phi_613_ = _e386;
                } else {
                    phi_613_ = 0u;
                }
                let _e388 = phi_613_;
                if (_e388 == 0u) {
                    phi_632_ = vec3<f32>(_e146.direction.y, _e146.direction.z, _e146.direction.x);
                } else {
                    if (_e388 == 1u) {
                        phi_631_ = vec3<f32>(_e146.direction.z, _e146.direction.x, _e146.direction.y);
                    } else {
                        phi_631_ = _e146.direction;
                    }
                    let _e401 = phi_631_;
                    phi_632_ = _e401;
                }
                let _e403 = phi_632_;
                let _e407 = (_e403.x / _e403.z);
                let _e410 = (_e403.y / _e403.z);
                if (_e300 < 0f) {
                    phi_646_ = 0u;
                } else {
                    phi_646_ = 1u;
                }
                let _e415 = phi_646_;
                if (_e312 < 0f) {
                    phi_651_ = 0u;
                } else {
                    phi_651_ = 2u;
                }
                let _e418 = phi_651_;
                if (_e324 < 0f) {
                    phi_656_ = 0u;
                } else {
                    phi_656_ = 4u;
                }
                let _e421 = phi_656_;
                let _e423 = ((_e415 | _e418) | _e421);
                let _e424 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local = lt_bvh_traverse_Stack(array<u32, 32>(_e424.first[0], _e424.first[1], _e424.first[2], _e424.first[3], _e424.first[4], _e424.first[5], _e424.first[6], _e424.first[7], _e424.first[8], _e424.first[9], _e424.first[10], _e424.first[11], _e424.first[12], _e424.first[13], _e424.first[14], _e424.first[15], _e424.first[16], _e424.first[17], _e424.first[18], _e424.first[19], _e424.first[20], _e424.first[21], _e424.first[22], _e424.first[23], _e424.first[24], _e424.first[25], _e424.first[26], _e424.first[27], _e424.first[28], _e424.first[29], _e424.first[30], _e424.first[31]), array<u32, 32>(_e424.mask[0], _e424.mask[1], _e424.mask[2], _e424.mask[3], _e424.mask[4], _e424.mask[5], _e424.mask[6], _e424.mask[7], _e424.mask[8], _e424.mask[9], _e424.mask[10], _e424.mask[11], _e424.mask[12], _e424.mask[13], _e424.mask[14], _e424.mask[15], _e424.mask[16], _e424.mask[17], _e424.mask[18], _e424.mask[19], _e424.mask[20], _e424.mask[21], _e424.mask[22], _e424.mask[23], _e424.mask[24], _e424.mask[25], _e424.mask[26], _e424.mask[27], _e424.mask[28], _e424.mask[29], _e424.mask[30], _e424.mask[31]), _e424.len, _e424.group, _e424.group_mask);
                let _e498 = local.group_mask;
                if ((_e498 & 4278190080u) == 0u) {
                    let _e502 = local.len;
                    if (_e502 == 0u) {
                        phi_770_ = false;
                    } else {
                        let _e506 = local.len;
                        local.len = (_e506 - 1u);
                        let _e509 = local.len;
                        if (_e509 < 32u) {
                        } else {
                            return;
                        }
                        let _e514 = local.first[(0u + _e509)];
                        local.group = _e514;
                        let _e517 = local.len;
                        if (_e517 < 32u) {
                        } else {
                            return;
                        }
                        let _e522 = local.mask[(0u + _e517)];
                        local.group_mask = _e522;
                        phi_770_ = true;
                    }
                    let _e525 = phi_770_;
                    phi_771_ = _e525;
                } else {
                    phi_771_ = true;
                }
                let _e527 = phi_771_;
                if _e527 {
                    let _e529 = local.group_mask;
                    let _e535 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e529)), 32u, (_e529 == 0u)));
                    let _e539 = local.group_mask;
                    let _e553 = local.group_mask;
                    local.group_mask = (_e553 & ~((1u << bitcast<u32>((_e535 & 31u)))));
                    let _e556 = local.group;
                    phi_802_ = (_e556 + countOneBits(((_e539 & ~((4294967295u << bitcast<u32>((((_e535 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_802_ = 4294967295u;
                }
                let _e559 = phi_802_;
                phi_804_ = _e148;
                phi_807_ = _e559;
                loop {
                    let _e561 = phi_804_;
                    let _e563 = phi_807_;
                    local_5 = _e561;
                    let _e564 = (_e563 != 4294967295u);
                    if _e564 {
                        if (_e563 < _e67) {
                        } else {
                            return;
                        }
                        let _e572 = nodes.member[(0u + _e563)].frame[3u];
                        let _e597 = (bitcast<f32>((((_e572 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e300);
                        let _e598 = (bitcast<f32>((((_e572 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e312);
                        let _e599 = (bitcast<f32>((((_e572 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e324);
                        let _e602 = nodes.member[(0u + _e563)].frame[0u];
                        let _e606 = nodes.member[(0u + _e563)].frame[1u];
                        let _e610 = nodes.member[(0u + _e563)].frame[2u];
                        let _e618 = ((bitcast<f32>(_e602) - _e146.origin.x) * _e300);
                        let _e619 = ((bitcast<f32>(_e606) - _e146.origin.y) * _e312);
                        let _e620 = ((bitcast<f32>(_e610) - _e146.origin.z) * _e324);
                        let _e628 = nodes.member[(0u + _e563)].x;
                        if (_e300 < 0f) {
                            let _e639 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e628.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e639.unnamed.word, _e628.w), _e639.unnamed_1);
                            let _e651 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e645.unnamed, lt_mask_LightPlace(_e628.x, _e645.unnamed_1.shift));
                            phi_892_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e651.unnamed, lt_mask_LightPlace(_e651.unnamed_1.word, _e628.y));
                        } else {
                            let _e667 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e628.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e667.unnamed.word, _e628.y), _e667.unnamed_1);
                            let _e679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e673.unnamed, lt_mask_LightPlace(_e628.z, _e673.unnamed_1.shift));
                            phi_892_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e679.unnamed, lt_mask_LightPlace(_e679.unnamed_1.word, _e628.w));
                        }
                        let _e687 = phi_892_;
                        let _e697 = nodes.member[(0u + _e563)].y;
                        if (_e312 < 0f) {
                            let _e708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e697.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e708.unnamed.word, _e697.w), _e708.unnamed_1);
                            let _e720 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e714.unnamed, lt_mask_LightPlace(_e697.x, _e714.unnamed_1.shift));
                            phi_919_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e720.unnamed, lt_mask_LightPlace(_e720.unnamed_1.word, _e697.y));
                        } else {
                            let _e736 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e697.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e742 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e736.unnamed.word, _e697.y), _e736.unnamed_1);
                            let _e748 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e742.unnamed, lt_mask_LightPlace(_e697.z, _e742.unnamed_1.shift));
                            phi_919_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e748.unnamed, lt_mask_LightPlace(_e748.unnamed_1.word, _e697.w));
                        }
                        let _e756 = phi_919_;
                        let _e766 = nodes.member[(0u + _e563)].z;
                        if (_e324 < 0f) {
                            let _e777 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e766.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e783 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e777.unnamed.word, _e766.w), _e777.unnamed_1);
                            let _e789 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e783.unnamed, lt_mask_LightPlace(_e766.x, _e783.unnamed_1.shift));
                            phi_946_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e789.unnamed, lt_mask_LightPlace(_e789.unnamed_1.word, _e766.y));
                        } else {
                            let _e805 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e766.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e811 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e805.unnamed.word, _e766.y), _e805.unnamed_1);
                            let _e817 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e811.unnamed, lt_mask_LightPlace(_e766.z, _e811.unnamed_1.shift));
                            phi_946_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e817.unnamed, lt_mask_LightPlace(_e817.unnamed_1.word, _e766.w));
                        }
                        let _e825 = phi_946_;
                        phi_952_ = 0u;
                        phi_955_ = 0u;
                        loop {
                            let _e835 = phi_952_;
                            let _e837 = phi_955_;
                            local_1 = _e837;
                            local_2 = _e837;
                            local_3 = _e837;
                            let _e838 = (_e835 < 8u);
                            if _e838 {
                                let _e840 = (_e835 >> bitcast<u32>(2i));
                                let _e841 = (_e835 & 3u);
                                if (_e840 == 0u) {
                                    phi_969_ = _e687.unnamed.word;
                                } else {
                                    phi_969_ = _e687.unnamed.shift;
                                }
                                let _e844 = phi_969_;
                                if (_e840 == 0u) {
                                    phi_979_ = _e756.unnamed.word;
                                } else {
                                    phi_979_ = _e756.unnamed.shift;
                                }
                                let _e853 = phi_979_;
                                if (_e840 == 0u) {
                                    phi_989_ = _e825.unnamed.word;
                                } else {
                                    phi_989_ = _e825.unnamed.shift;
                                }
                                let _e862 = phi_989_;
                                let _e875 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e844 >> bitcast<u32>(((_e841 * 8u) & 31u))) & 255u)) * _e597) + (_e618 - _e361)), ((f32(((_e853 >> bitcast<u32>(((_e841 * 8u) & 31u))) & 255u)) * _e598) + (_e619 - _e362)));
                                let _e876 = core_intrinsics_maximum_number_nsz_f32_(_e875, ((f32(((_e862 >> bitcast<u32>(((_e841 * 8u) & 31u))) & 255u)) * _e599) + (_e620 - _e363)));
                                if (_e840 == 0u) {
                                    phi_1007_ = _e687.unnamed_1.word;
                                } else {
                                    phi_1007_ = _e687.unnamed_1.shift;
                                }
                                let _e879 = phi_1007_;
                                if (_e840 == 0u) {
                                    phi_1017_ = _e756.unnamed_1.word;
                                } else {
                                    phi_1017_ = _e756.unnamed_1.shift;
                                }
                                let _e888 = phi_1017_;
                                if (_e840 == 0u) {
                                    phi_1027_ = _e825.unnamed_1.word;
                                } else {
                                    phi_1027_ = _e825.unnamed_1.shift;
                                }
                                let _e897 = phi_1027_;
                                let _e910 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e879 >> bitcast<u32>(((_e841 * 8u) & 31u))) & 255u)) * _e597) + (_e618 + _e361)), ((f32(((_e888 >> bitcast<u32>(((_e841 * 8u) & 31u))) & 255u)) * _e598) + (_e619 + _e362)));
                                let _e911 = core_intrinsics_minimum_number_nsz_f32_(_e910, ((f32(((_e897 >> bitcast<u32>(((_e841 * 8u) & 31u))) & 255u)) * _e599) + (_e620 + _e363)));
                                if (_e876 <= _e911) {
                                    if (_e876 <= _e561.t) {
                                        if (_e911 >= _e146.tmin) {
                                            if (_e840 == 0u) {
                                                let _e918 = nodes.member[(0u + _e563)].links[2u];
                                                phi_1063_ = _e918;
                                            } else {
                                                let _e921 = nodes.member[(0u + _e563)].links[3u];
                                                phi_1063_ = _e921;
                                            }
                                            let _e923 = phi_1063_;
                                            let _e928 = ((_e923 >> bitcast<u32>(((_e841 * 8u) & 31u))) & 255u);
                                            let _e929 = (_e928 & 31u);
                                            if (_e929 >= 24u) {
                                                phi_1076_ = (24u + ((_e929 - 24u) ^ _e423));
                                            } else {
                                                phi_1076_ = _e929;
                                            }
                                            let _e935 = phi_1076_;
                                            phi_1081_ = (_e837 | ((_e928 >> bitcast<u32>(5i)) << bitcast<u32>((_e935 & 31u))));
                                        } else {
                                            phi_1081_ = _e837;
                                        }
                                        let _e943 = phi_1081_;
                                        phi_1082_ = _e943;
                                    } else {
                                        phi_1082_ = _e837;
                                    }
                                    let _e945 = phi_1082_;
                                    phi_1083_ = _e945;
                                } else {
                                    phi_1083_ = _e837;
                                }
                                let _e947 = phi_1083_;
                                phi_953_ = (_e835 + 1u);
                                phi_956_ = _e947;
                            } else {
                                phi_953_ = u32();
                                phi_956_ = u32();
                            }
                            let _e950 = phi_953_;
                            let _e952 = phi_956_;
                            continue;
                            continuing {
                                phi_952_ = _e950;
                                phi_955_ = _e952;
                                break if !(_e838);
                            }
                        }
                        let _e956 = nodes.member[(0u + _e563)].links[0u];
                        let _e960 = nodes.member[(0u + _e563)].frame[3u];
                        let _e964 = local_1;
                        if ((_e964 & 4278190080u) == 0u) {
                        } else {
                            let _e968 = local.group_mask;
                            if ((_e968 & 4278190080u) == 0u) {
                            } else {
                                let _e972 = local.len;
                                if (_e972 < 32u) {
                                    let _e975 = local.group;
                                    let _e977 = local.len;
                                    if (_e977 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.first[(0u + _e977)] = _e975;
                                    let _e983 = local.group_mask;
                                    let _e985 = local.len;
                                    if (_e985 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.mask[(0u + _e985)] = _e983;
                                    let _e992 = local.len;
                                    local.len = (_e992 + 1u);
                                }
                            }
                            local.group = (0u + _e956);
                            let _e996 = local_2;
                            local.group_mask = ((_e996 & 4278190080u) | (_e960 >> bitcast<u32>(24i)));
                        }
                        let _e1001 = local_3;
                        phi_1141_ = _e561;
                        phi_1144_ = (_e1001 & 16777215u);
                        loop {
                            let _e1004 = phi_1141_;
                            let _e1006 = phi_1144_;
                            local_4 = _e1004;
                            if (_e1006 == 0u) {
                                phi_1142_ = lt_bvh_Hit();
                                phi_1145_ = u32();
                                phi_1803_ = false;
                            } else {
                                let _e1010 = nodes.member[(0u + _e563)].links[1u];
                                let _e1015 = ((0u + _e1010) + select(firstTrailingBit(_e1006), 32u, (_e1006 == 0u)));
                                if (_e1015 < _e70) {
                                } else {
                                    return;
                                }
                                let _e1022 = triangles.member[(0u + _e1015)].v0_;
                                let _e1025 = (_e1022.x - _e146.origin.x);
                                let _e1028 = (_e1022.y - _e146.origin.y);
                                let _e1031 = (_e1022.z - _e146.origin.z);
                                if (_e388 == 0u) {
                                    phi_1191_ = vec3<f32>(_e1028, _e1031, _e1025);
                                } else {
                                    if (_e388 == 1u) {
                                        phi_1190_ = vec3<f32>(_e1031, _e1025, _e1028);
                                    } else {
                                        phi_1190_ = (_e1022 - _e146.origin);
                                    }
                                    let _e1038 = phi_1190_;
                                    phi_1191_ = _e1038;
                                }
                                let _e1040 = phi_1191_;
                                let _e1044 = (_e1040.x - (_e407 * _e1040.z));
                                let _e1048 = (_e1040.y - (_e410 * _e1040.z));
                                let _e1050 = triangles.member[(0u + _e1015)].v1_;
                                let _e1053 = (_e1050.x - _e146.origin.x);
                                let _e1056 = (_e1050.y - _e146.origin.y);
                                let _e1059 = (_e1050.z - _e146.origin.z);
                                if (_e388 == 0u) {
                                    phi_1223_ = vec3<f32>(_e1056, _e1059, _e1053);
                                } else {
                                    if (_e388 == 1u) {
                                        phi_1222_ = vec3<f32>(_e1059, _e1053, _e1056);
                                    } else {
                                        phi_1222_ = (_e1050 - _e146.origin);
                                    }
                                    let _e1066 = phi_1222_;
                                    phi_1223_ = _e1066;
                                }
                                let _e1068 = phi_1223_;
                                let _e1072 = (_e1068.x - (_e407 * _e1068.z));
                                let _e1076 = (_e1068.y - (_e410 * _e1068.z));
                                let _e1078 = triangles.member[(0u + _e1015)].v2_;
                                let _e1081 = (_e1078.x - _e146.origin.x);
                                let _e1084 = (_e1078.y - _e146.origin.y);
                                let _e1087 = (_e1078.z - _e146.origin.z);
                                if (_e388 == 0u) {
                                    phi_1255_ = vec3<f32>(_e1084, _e1087, _e1081);
                                } else {
                                    if (_e388 == 1u) {
                                        phi_1254_ = vec3<f32>(_e1087, _e1081, _e1084);
                                    } else {
                                        phi_1254_ = (_e1078 - _e146.origin);
                                    }
                                    let _e1094 = phi_1254_;
                                    phi_1255_ = _e1094;
                                }
                                let _e1096 = phi_1255_;
                                let _e1100 = (_e1096.x - (_e407 * _e1096.z));
                                let _e1104 = (_e1096.y - (_e410 * _e1096.z));
                                if (_e1072 < _e1100) {
                                    phi_1274_ = true;
                                } else {
                                    if (_e1072 == _e1100) {
                                        phi_1273_ = (_e1076 < _e1104);
                                    } else {
                                        phi_1273_ = false;
                                    }
                                    let _e1109 = phi_1273_;
                                    phi_1274_ = _e1109;
                                }
                                let _e1111 = phi_1274_;
                                if _e1111 {
                                    phi_1278_ = _e1104;
                                    phi_1279_ = _e1100;
                                    phi_1280_ = _e1076;
                                    phi_1281_ = _e1072;
                                } else {
                                    phi_1278_ = _e1076;
                                    phi_1279_ = _e1072;
                                    phi_1280_ = _e1104;
                                    phi_1281_ = _e1100;
                                }
                                let _e1113 = phi_1278_;
                                let _e1115 = phi_1279_;
                                let _e1117 = phi_1280_;
                                let _e1119 = phi_1281_;
                                let _e1122 = ((_e1119 * _e1113) - (_e1117 * _e1115));
                                if _e1111 {
                                    phi_1289_ = -(_e1122);
                                } else {
                                    phi_1289_ = _e1122;
                                }
                                let _e1125 = phi_1289_;
                                if (_e1100 < _e1044) {
                                    phi_1300_ = true;
                                } else {
                                    if (_e1100 == _e1044) {
                                        phi_1299_ = (_e1104 < _e1048);
                                    } else {
                                        phi_1299_ = false;
                                    }
                                    let _e1130 = phi_1299_;
                                    phi_1300_ = _e1130;
                                }
                                let _e1132 = phi_1300_;
                                if _e1132 {
                                    phi_1304_ = _e1048;
                                    phi_1305_ = _e1044;
                                    phi_1306_ = _e1104;
                                    phi_1307_ = _e1100;
                                } else {
                                    phi_1304_ = _e1104;
                                    phi_1305_ = _e1100;
                                    phi_1306_ = _e1048;
                                    phi_1307_ = _e1044;
                                }
                                let _e1134 = phi_1304_;
                                let _e1136 = phi_1305_;
                                let _e1138 = phi_1306_;
                                let _e1140 = phi_1307_;
                                let _e1143 = ((_e1140 * _e1134) - (_e1138 * _e1136));
                                if _e1132 {
                                    phi_1315_ = -(_e1143);
                                } else {
                                    phi_1315_ = _e1143;
                                }
                                let _e1146 = phi_1315_;
                                if (_e1044 < _e1072) {
                                    phi_1326_ = true;
                                } else {
                                    if (_e1044 == _e1072) {
                                        phi_1325_ = (_e1048 < _e1076);
                                    } else {
                                        phi_1325_ = false;
                                    }
                                    let _e1151 = phi_1325_;
                                    phi_1326_ = _e1151;
                                }
                                let _e1153 = phi_1326_;
                                if _e1153 {
                                    phi_1330_ = _e1076;
                                    phi_1331_ = _e1072;
                                    phi_1332_ = _e1048;
                                    phi_1333_ = _e1044;
                                } else {
                                    phi_1330_ = _e1048;
                                    phi_1331_ = _e1044;
                                    phi_1332_ = _e1076;
                                    phi_1333_ = _e1072;
                                }
                                let _e1155 = phi_1330_;
                                let _e1157 = phi_1331_;
                                let _e1159 = phi_1332_;
                                let _e1161 = phi_1333_;
                                let _e1164 = ((_e1161 * _e1155) - (_e1159 * _e1157));
                                if _e1153 {
                                    phi_1341_ = -(_e1164);
                                } else {
                                    phi_1341_ = _e1164;
                                }
                                let _e1167 = phi_1341_;
                                if (_e1125 >= 0f) {
                                    if (_e1146 >= 0f) {
                                        if (_e1167 >= 0f) {
                                            phi_1356_ = ((_e1125 + _e1146) + _e1167);
                                            phi_1357_ = false;
                                        } else {
                                            phi_1356_ = f32();
                                            phi_1357_ = true;
                                        }
                                        let _e1174 = phi_1356_;
                                        let _e1176 = phi_1357_;
                                        phi_1358_ = _e1174;
                                        phi_1359_ = _e1176;
                                    } else {
                                        phi_1358_ = f32();
                                        phi_1359_ = true;
                                    }
                                    let _e1178 = phi_1358_;
                                    let _e1180 = phi_1359_;
                                    phi_1360_ = _e1178;
                                    phi_1361_ = _e1180;
                                } else {
                                    phi_1360_ = f32();
                                    phi_1361_ = true;
                                }
                                let _e1182 = phi_1360_;
                                let _e1184 = phi_1361_;
                                if _e1184 {
                                    if (_e1125 <= 0f) {
                                        if (_e1146 <= 0f) {
                                            let _e1187 = (_e1167 <= 0f);
                                            if _e1187 {
                                            }
                                            phi_1379_ = ((_e1125 + _e1146) + _e1167);
                                            phi_1380_ = false;
                                            phi_1381_ = _e1187;
                                        } else {
                                            phi_1379_ = f32();
                                            phi_1380_ = true;
                                            phi_1381_ = false;
                                        }
                                        let _e1191 = phi_1379_;
                                        let _e1193 = phi_1380_;
                                        let _e1195 = phi_1381_;
                                        phi_1382_ = _e1191;
                                        phi_1383_ = _e1193;
                                        phi_1384_ = _e1195;
                                    } else {
                                        phi_1382_ = f32();
                                        phi_1383_ = true;
                                        phi_1384_ = false;
                                    }
                                    let _e1197 = phi_1382_;
                                    let _e1199 = phi_1383_;
                                    let _e1201 = phi_1384_;
                                    if _e1199 {
                                        phi_1388_ = false;
                                    } else {
                                        phi_1388_ = _e1201;
                                    }
                                    let _e1203 = phi_1388_;
                                    phi_1389_ = _e1197;
                                    phi_1390_ = _e1203;
                                } else {
                                    phi_1389_ = _e1182;
                                    phi_1390_ = true;
                                }
                                let _e1205 = phi_1389_;
                                let _e1207 = phi_1390_;
                                if _e1207 {
                                    let _e1208 = (_e1205 == 0f);
                                    if _e1208 {
                                        phi_1716_ = lt_bvh_triangle_Intersection();
                                        phi_1717_ = false;
                                    } else {
                                        let _e1210 = triangles.member[(0u + _e1015)].v0_;
                                        let _e1213 = (_e1210.x - _e146.origin.x);
                                        let _e1216 = (_e1210.y - _e146.origin.y);
                                        let _e1219 = (_e1210.z - _e146.origin.z);
                                        if (_e388 == 0u) {
                                            phi_1421_ = vec3<f32>(_e1216, _e1219, _e1213);
                                        } else {
                                            if (_e388 == 1u) {
                                                phi_1420_ = vec3<f32>(_e1219, _e1213, _e1216);
                                            } else {
                                                phi_1420_ = (_e1210 - _e146.origin);
                                            }
                                            let _e1226 = phi_1420_;
                                            phi_1421_ = _e1226;
                                        }
                                        let _e1228 = phi_1421_;
                                        let _e1230 = triangles.member[(0u + _e1015)].v1_;
                                        let _e1232 = triangles.member[(0u + _e1015)].v0_;
                                        let _e1235 = (_e1230.x - _e1232.x);
                                        let _e1238 = (_e1230.y - _e1232.y);
                                        let _e1241 = (_e1230.z - _e1232.z);
                                        if (_e388 == 0u) {
                                            phi_1447_ = vec3<f32>(_e1238, _e1241, _e1235);
                                        } else {
                                            if (_e388 == 1u) {
                                                phi_1446_ = vec3<f32>(_e1241, _e1235, _e1238);
                                            } else {
                                                phi_1446_ = (_e1230 - _e1232);
                                            }
                                            let _e1248 = phi_1446_;
                                            phi_1447_ = _e1248;
                                        }
                                        let _e1250 = phi_1447_;
                                        let _e1252 = triangles.member[(0u + _e1015)].v2_;
                                        let _e1254 = triangles.member[(0u + _e1015)].v0_;
                                        let _e1257 = (_e1252.x - _e1254.x);
                                        let _e1260 = (_e1252.y - _e1254.y);
                                        let _e1263 = (_e1252.z - _e1254.z);
                                        if (_e388 == 0u) {
                                            phi_1473_ = vec3<f32>(_e1260, _e1263, _e1257);
                                        } else {
                                            if (_e388 == 1u) {
                                                phi_1472_ = vec3<f32>(_e1263, _e1257, _e1260);
                                            } else {
                                                phi_1472_ = (_e1252 - _e1254);
                                            }
                                            let _e1270 = phi_1472_;
                                            phi_1473_ = _e1270;
                                        }
                                        let _e1272 = phi_1473_;
                                        let _e1279 = ((_e1250.y * _e1272.z) - (_e1250.z * _e1272.y));
                                        let _e1286 = ((_e1250.z * _e1272.x) - (_e1250.x * _e1272.z));
                                        let _e1293 = ((_e1250.x * _e1272.y) - (_e1250.y * _e1272.x));
                                        let _e1307 = (((1f / _e403.z) * (((_e1279 * _e1228.x) + (_e1286 * _e1228.y)) + (_e1293 * _e1228.z))) / (((_e1279 * _e407) + (_e1286 * _e410)) + _e1293));
                                        if (_e1307 > _e146.tmin) {
                                            if (_e1307 < _e146.tmax) {
                                                let _e1313 = triangles.member[(0u + _e1015)].v0_;
                                                let _e1315 = triangles.member[(0u + _e1015)].v1_;
                                                if (_e1313.x < _e1315.x) {
                                                    phi_1531_ = _e1313.x;
                                                } else {
                                                    phi_1531_ = _e1315.x;
                                                }
                                                let _e1322 = phi_1531_;
                                                if (_e1313.y < _e1315.y) {
                                                    phi_1540_ = _e1313.y;
                                                } else {
                                                    phi_1540_ = _e1315.y;
                                                }
                                                let _e1329 = phi_1540_;
                                                if (_e1313.z < _e1315.z) {
                                                    phi_1549_ = _e1313.z;
                                                } else {
                                                    phi_1549_ = _e1315.z;
                                                }
                                                let _e1336 = phi_1549_;
                                                let _e1338 = triangles.member[(0u + _e1015)].v2_;
                                                if (_e1322 < _e1338.x) {
                                                    phi_1558_ = _e1322;
                                                } else {
                                                    phi_1558_ = _e1338.x;
                                                }
                                                let _e1343 = phi_1558_;
                                                if (_e1329 < _e1338.y) {
                                                    phi_1565_ = _e1329;
                                                } else {
                                                    phi_1565_ = _e1338.y;
                                                }
                                                let _e1348 = phi_1565_;
                                                if (_e1336 < _e1338.z) {
                                                    phi_1572_ = _e1336;
                                                } else {
                                                    phi_1572_ = _e1338.z;
                                                }
                                                let _e1353 = phi_1572_;
                                                let _e1355 = triangles.member[(0u + _e1015)].v0_;
                                                let _e1357 = triangles.member[(0u + _e1015)].v1_;
                                                if (_e1355.x > _e1357.x) {
                                                    phi_1585_ = _e1355.x;
                                                } else {
                                                    phi_1585_ = _e1357.x;
                                                }
                                                let _e1364 = phi_1585_;
                                                if (_e1355.y > _e1357.y) {
                                                    phi_1594_ = _e1355.y;
                                                } else {
                                                    phi_1594_ = _e1357.y;
                                                }
                                                let _e1371 = phi_1594_;
                                                if (_e1355.z > _e1357.z) {
                                                    phi_1603_ = _e1355.z;
                                                } else {
                                                    phi_1603_ = _e1357.z;
                                                }
                                                let _e1378 = phi_1603_;
                                                let _e1380 = triangles.member[(0u + _e1015)].v2_;
                                                if (_e1364 > _e1380.x) {
                                                    phi_1612_ = _e1364;
                                                } else {
                                                    phi_1612_ = _e1380.x;
                                                }
                                                let _e1385 = phi_1612_;
                                                if (_e1371 > _e1380.y) {
                                                    phi_1619_ = _e1371;
                                                } else {
                                                    phi_1619_ = _e1380.y;
                                                }
                                                let _e1390 = phi_1619_;
                                                if (_e1378 > _e1380.z) {
                                                    phi_1626_ = _e1378;
                                                } else {
                                                    phi_1626_ = _e1380.z;
                                                }
                                                let _e1395 = phi_1626_;
                                                let _e1402 = ((_e1343 - _e146.origin.x) * _e300);
                                                let _e1403 = ((_e1348 - _e146.origin.y) * _e312);
                                                let _e1404 = ((_e1353 - _e146.origin.z) * _e324);
                                                let _e1411 = ((_e1385 - _e146.origin.x) * _e300);
                                                let _e1412 = ((_e1390 - _e146.origin.y) * _e312);
                                                let _e1413 = ((_e1395 - _e146.origin.z) * _e324);
                                                if (_e1402 < _e1411) {
                                                    phi_1649_ = _e1402;
                                                } else {
                                                    phi_1649_ = _e1411;
                                                }
                                                let _e1416 = phi_1649_;
                                                if (_e1403 < _e1412) {
                                                    phi_1654_ = _e1403;
                                                } else {
                                                    phi_1654_ = _e1412;
                                                }
                                                let _e1419 = phi_1654_;
                                                if (_e1404 < _e1413) {
                                                    phi_1659_ = _e1404;
                                                } else {
                                                    phi_1659_ = _e1413;
                                                }
                                                let _e1422 = phi_1659_;
                                                if (_e1402 > _e1411) {
                                                    phi_1667_ = _e1402;
                                                } else {
                                                    phi_1667_ = _e1411;
                                                }
                                                let _e1428 = phi_1667_;
                                                if (_e1403 > _e1412) {
                                                    phi_1672_ = _e1403;
                                                } else {
                                                    phi_1672_ = _e1412;
                                                }
                                                let _e1431 = phi_1672_;
                                                if (_e1404 > _e1413) {
                                                    phi_1677_ = _e1404;
                                                } else {
                                                    phi_1677_ = _e1413;
                                                }
                                                let _e1434 = phi_1677_;
                                                let _e1438 = core_intrinsics_maximum_number_nsz_f32_((_e1416 - _e368), (_e1419 - _e369));
                                                let _e1439 = core_intrinsics_maximum_number_nsz_f32_(_e1438, (_e1422 - _e370));
                                                let _e1440 = core_intrinsics_minimum_number_nsz_f32_((_e1428 + _e368), (_e1431 + _e369));
                                                let _e1441 = core_intrinsics_minimum_number_nsz_f32_(_e1440, (_e1434 + _e370));
                                                if (_e1439 > -300000000000000000000000000000000000000f) {
                                                    phi_1689_ = _e1439;
                                                } else {
                                                    phi_1689_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1444 = phi_1689_;
                                                if (_e1441 < 300000000000000000000000000000000000000f) {
                                                    phi_1694_ = _e1441;
                                                } else {
                                                    phi_1694_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1447 = phi_1694_;
                                                if (_e1307 < _e1444) {
                                                    phi_1699_ = _e1444;
                                                } else {
                                                    phi_1699_ = _e1307;
                                                }
                                                let _e1450 = phi_1699_;
                                                if (_e1450 > _e1447) {
                                                    phi_1704_ = _e1447;
                                                } else {
                                                    phi_1704_ = _e1450;
                                                }
                                                let _e1453 = phi_1704_;
                                                phi_1709_ = lt_bvh_triangle_Intersection(_e1453, (_e1146 / _e1205), (_e1167 / _e1205), (_e1444 <= _e1447));
                                                phi_1710_ = false;
                                            } else {
                                                phi_1709_ = lt_bvh_triangle_Intersection();
                                                phi_1710_ = true;
                                            }
                                            let _e1459 = phi_1709_;
                                            let _e1461 = phi_1710_;
                                            phi_1711_ = _e1459;
                                            phi_1712_ = _e1461;
                                        } else {
                                            phi_1711_ = lt_bvh_triangle_Intersection();
                                            phi_1712_ = true;
                                        }
                                        let _e1463 = phi_1711_;
                                        let _e1465 = phi_1712_;
                                        if _e1465 {
                                        }
                                        phi_1716_ = _e1463;
                                        phi_1717_ = _e1465;
                                    }
                                    let _e1467 = phi_1716_;
                                    let _e1469 = phi_1717_;
                                    phi_1718_ = _e1467;
                                    phi_1719_ = _e1208;
                                    phi_1720_ = _e1469;
                                } else {
                                    phi_1718_ = lt_bvh_triangle_Intersection();
                                    phi_1719_ = true;
                                    phi_1720_ = false;
                                }
                                let _e1471 = phi_1718_;
                                let _e1473 = phi_1719_;
                                let _e1475 = phi_1720_;
                                if _e1473 {
                                    phi_1724_ = true;
                                } else {
                                    phi_1724_ = _e1475;
                                }
                                let _e1477 = phi_1724_;
                                if _e1477 {
                                    phi_1728_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1728_ = _e1471;
                                }
                                let _e1479 = phi_1728_;
                                if _e1479.is_hit {
                                    if (_e1479.t > _e146.tmin) {
                                        if (_e1479.t < _e1004.t) {
                                            phi_1777_ = true;
                                        } else {
                                            if (_e1479.t == _e1004.t) {
                                                if (_e1004.triangle != 4294967295u) {
                                                    if (_e1015 < _e1004.triangle) {
                                                        phi_1768_ = true;
                                                    } else {
                                                        if (_e1015 == _e1004.triangle) {
                                                            phi_1767_ = (4294967295u < _e1004.instance);
                                                        } else {
                                                            phi_1767_ = false;
                                                        }
                                                        let _e1498 = phi_1767_;
                                                        phi_1768_ = _e1498;
                                                    }
                                                    let _e1500 = phi_1768_;
                                                    phi_1769_ = _e1500;
                                                    phi_1770_ = false;
                                                } else {
                                                    phi_1769_ = bool();
                                                    phi_1770_ = true;
                                                }
                                                let _e1502 = phi_1769_;
                                                let _e1504 = phi_1770_;
                                                phi_1771_ = _e1502;
                                                phi_1772_ = _e1504;
                                            } else {
                                                phi_1771_ = bool();
                                                phi_1772_ = true;
                                            }
                                            let _e1506 = phi_1771_;
                                            let _e1508 = phi_1772_;
                                            if _e1508 {
                                                phi_1776_ = false;
                                            } else {
                                                phi_1776_ = _e1506;
                                            }
                                            let _e1510 = phi_1776_;
                                            phi_1777_ = _e1510;
                                        }
                                        let _e1512 = phi_1777_;
                                        if _e1512 {
                                            let _e1514 = triangles.member[(0u + _e1015)].i0_;
                                            if ((_e1514 & 2147483648u) == 0u) {
                                                phi_1791_ = true;
                                            } else {
                                                if true {
                                                }
                                                phi_1791_ = true;
                                            }
                                            let _e1518 = phi_1791_;
                                            if _e1518 {
                                                phi_1799_ = lt_bvh_Hit(_e1479.t, _e1479.u, _e1479.v, _e1015, 4294967295u);
                                            } else {
                                                phi_1799_ = _e1004;
                                            }
                                            let _e1524 = phi_1799_;
                                            phi_1800_ = _e1524;
                                        } else {
                                            phi_1800_ = _e1004;
                                        }
                                        let _e1526 = phi_1800_;
                                        phi_1801_ = _e1526;
                                    } else {
                                        phi_1801_ = _e1004;
                                    }
                                    let _e1528 = phi_1801_;
                                    phi_1802_ = _e1528;
                                } else {
                                    phi_1802_ = _e1004;
                                }
                                let _e1530 = phi_1802_;
                                phi_1142_ = _e1530;
                                phi_1145_ = (_e1006 & (_e1006 - 1u));
                                phi_1803_ = true;
                            }
                            let _e1532 = phi_1142_;
                            let _e1534 = phi_1145_;
                            let _e1536 = phi_1803_;
                            continue;
                            continuing {
                                phi_1141_ = _e1532;
                                phi_1144_ = _e1534;
                                break if !(_e1536);
                            }
                        }
                        let _e1539 = local.group_mask;
                        if ((_e1539 & 4278190080u) == 0u) {
                            let _e1543 = local.len;
                            if (_e1543 == 0u) {
                                phi_1842_ = false;
                            } else {
                                let _e1547 = local.len;
                                local.len = (_e1547 - 1u);
                                let _e1550 = local.len;
                                if (_e1550 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1555 = local.first[(0u + _e1550)];
                                local.group = _e1555;
                                let _e1558 = local.len;
                                if (_e1558 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1563 = local.mask[(0u + _e1558)];
                                local.group_mask = _e1563;
                                phi_1842_ = true;
                            }
                            let _e1566 = phi_1842_;
                            phi_1843_ = _e1566;
                        } else {
                            phi_1843_ = true;
                        }
                        let _e1568 = phi_1843_;
                        if _e1568 {
                            let _e1570 = local.group_mask;
                            let _e1576 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1570)), 32u, (_e1570 == 0u)));
                            let _e1580 = local.group_mask;
                            let _e1594 = local.group_mask;
                            local.group_mask = (_e1594 & ~((1u << bitcast<u32>((_e1576 & 31u)))));
                            let _e1597 = local.group;
                            phi_1874_ = (_e1597 + countOneBits(((_e1580 & ~((4294967295u << bitcast<u32>((((_e1576 - 24u) ^ _e423) & 31u))))) & 255u)));
                        } else {
                            phi_1874_ = 4294967295u;
                        }
                        let _e1600 = phi_1874_;
                        let _e2376 = local_4;
                        phi_805_ = _e2376;
                        phi_808_ = _e1600;
                    } else {
                        phi_805_ = lt_bvh_Hit();
                        phi_808_ = u32();
                    }
                    let _e1602 = phi_805_;
                    let _e1604 = phi_808_;
                    continue;
                    continuing {
                        phi_804_ = _e1602;
                        phi_807_ = _e1604;
                        break if !(_e564);
                    }
                }
                let _e2380 = local_5;
                phi_1875_ = _e2380;
            }
            let _e1607 = phi_1875_;
            phi_1876_ = _e1607;
            phi_1877_ = _e218;
        } else {
            phi_1876_ = lt_bvh_Hit();
            phi_1877_ = true;
        }
        let _e1609 = phi_1876_;
        let _e1611 = phi_1877_;
        if _e1611 {
            phi_1881_ = _e148;
        } else {
            phi_1881_ = _e1609;
        }
        let _e1613 = phi_1881_;
        if (_e1613.triangle != 4294967295u) {
            let _e1619 = ((1f - _e1613.u) - _e1613.v);
            if (_e1613.triangle < _e70) {
            } else {
                return;
            }
            let _e1625 = triangles.member[(0u + _e1613.triangle)];
            let _e1650 = (((_e1625.v0_.x * _e1619) + (_e1625.v1_.x * _e1613.u)) + (_e1625.v2_.x * _e1613.v));
            let _e1651 = (((_e1625.v0_.y * _e1619) + (_e1625.v1_.y * _e1613.u)) + (_e1625.v2_.y * _e1613.v));
            let _e1652 = (((_e1625.v0_.z * _e1619) + (_e1625.v1_.z * _e1613.u)) + (_e1625.v2_.z * _e1613.v));
            let _e1655 = abs(_e1625.v0_.x);
            let _e1657 = abs(_e1625.v0_.y);
            let _e1659 = abs(_e1625.v0_.z);
            let _e1661 = abs(_e1625.v1_.x);
            let _e1663 = abs(_e1625.v1_.y);
            let _e1665 = abs(_e1625.v1_.z);
            if (_e1655 > _e1661) {
                phi_1946_ = _e1655;
            } else {
                phi_1946_ = _e1661;
            }
            let _e1668 = phi_1946_;
            if (_e1657 > _e1663) {
                phi_1951_ = _e1657;
            } else {
                phi_1951_ = _e1663;
            }
            let _e1671 = phi_1951_;
            if (_e1659 > _e1665) {
                phi_1956_ = _e1659;
            } else {
                phi_1956_ = _e1665;
            }
            let _e1674 = phi_1956_;
            let _e1676 = abs(_e1625.v2_.x);
            let _e1678 = abs(_e1625.v2_.y);
            let _e1680 = abs(_e1625.v2_.z);
            if (_e1668 > _e1676) {
                phi_1967_ = _e1668;
            } else {
                phi_1967_ = _e1676;
            }
            let _e1683 = phi_1967_;
            if (_e1671 > _e1678) {
                phi_1972_ = _e1671;
            } else {
                phi_1972_ = _e1678;
            }
            let _e1686 = phi_1972_;
            if (_e1674 > _e1680) {
                phi_1977_ = _e1674;
            } else {
                phi_1977_ = _e1680;
            }
            let _e1689 = phi_1977_;
            let _e1692 = (_e1625.v1_.x - _e1625.v0_.x);
            let _e1695 = (_e1625.v1_.y - _e1625.v0_.y);
            let _e1698 = (_e1625.v1_.z - _e1625.v0_.z);
            let _e1701 = (_e1625.v2_.x - _e1625.v0_.x);
            let _e1704 = (_e1625.v2_.y - _e1625.v0_.y);
            let _e1707 = (_e1625.v2_.z - _e1625.v0_.z);
            let _e1711 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1695), abs(_e1698));
            let _e1712 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1692), _e1711);
            let _e1713 = (_e1692 / _e1712);
            let _e1714 = (_e1695 / _e1712);
            let _e1715 = (_e1698 / _e1712);
            let _e1719 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1704), abs(_e1707));
            let _e1720 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1701), _e1719);
            let _e1721 = (_e1701 / _e1720);
            let _e1722 = (_e1704 / _e1720);
            let _e1723 = (_e1707 / _e1720);
            let _e1726 = ((_e1714 * _e1723) - (_e1722 * _e1715));
            let _e1729 = ((_e1715 * _e1721) - (_e1723 * _e1713));
            let _e1732 = ((_e1713 * _e1722) - (_e1721 * _e1714));
            let _e1734 = p.member.eye;
            let _e1747 = (1f / sqrt((((_e1726 * _e1726) + (_e1729 * _e1729)) + (_e1732 * _e1732))));
            let _e1748 = (_e1726 * _e1747);
            let _e1749 = (_e1729 * _e1747);
            let _e1750 = (_e1732 * _e1747);
            if ((((_e1748 * (_e1734.x - _e1650)) + (_e1749 * (_e1734.y - _e1651))) + (_e1750 * (_e1734.z - _e1652))) < 0f) {
                phi_2053_ = vec3<f32>(-(_e1748), -(_e1749), -(_e1750));
            } else {
                phi_2053_ = vec3<f32>(_e1748, _e1749, _e1750);
            }
            let _e1763 = phi_2053_;
            if (_e1613.triangle < _e70) {
            } else {
                return;
            }
            let _e1768 = triangles.member[(0u + _e1613.triangle)];
            let _e1770 = (_e1768.i0_ & 2147483647u);
            if (_e1770 < _e73) {
            } else {
                return;
            }
            let _e1776 = vertices.member[(0u + _e1770)];
            if (_e1768.i1_ < _e73) {
            } else {
                return;
            }
            let _e1780 = vertices.member[(0u + _e1768.i1_)];
            if (_e1768.i2_ < _e73) {
            } else {
                return;
            }
            let _e1784 = vertices.member[(0u + _e1768.i2_)];
            let _e1785 = array<abi_Vertex, 3>(_e1776, _e1780, _e1784);
            if (_e1785[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e1791 = materials.member[(0u + _e1785[0].material)];
            let _e1808 = (1f / 255f);
            let _e1827 = (1f / 255f);
            let _e1849 = (1f / 255f);
            let _e1862 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e1619, _e1613.u, _e1613.v));
            let _e1864 = ((_e1791.base_color.x * ((((f32((_e1785[0].color & 255u)) * _e1808) * _e1619) + ((f32((_e1785[1].color & 255u)) * _e1827) * _e1613.u)) + ((f32((_e1785[2].color & 255u)) * _e1849) * _e1613.v))) * _e1862.x);
            let _e1866 = ((_e1791.base_color.y * ((((f32(((_e1785[0].color >> bitcast<u32>(8i)) & 255u)) * _e1808) * _e1619) + ((f32(((_e1785[1].color >> bitcast<u32>(8i)) & 255u)) * _e1827) * _e1613.u)) + ((f32(((_e1785[2].color >> bitcast<u32>(8i)) & 255u)) * _e1849) * _e1613.v))) * _e1862.y);
            let _e1868 = ((_e1791.base_color.z * ((((f32(((_e1785[0].color >> bitcast<u32>(16i)) & 255u)) * _e1808) * _e1619) + ((f32(((_e1785[1].color >> bitcast<u32>(16i)) & 255u)) * _e1827) * _e1613.u)) + ((f32(((_e1785[2].color >> bitcast<u32>(16i)) & 255u)) * _e1849) * _e1613.v))) * _e1862.z);
            let _e1869 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1686, _e1689);
            let _e1870 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1683, _e1869);
            if ((_e1791.flags & 2u) == 0u) {
                phi_2174_ = 0u;
            } else {
                phi_2174_ = 1u;
            }
            let _e1875 = phi_2174_;
            if (_e1785[0].normal == 2147516416u) {
                phi_2377_ = _e1763;
            } else {
                let _e1888 = (f32((bitcast<i32>((_e1785[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1894 = (f32((bitcast<i32>(_e1785[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1898 = ((1f - abs(_e1888)) - abs(_e1894));
                if (_e1898 < 0f) {
                    phi_2201_ = -(_e1898);
                } else {
                    phi_2201_ = 0f;
                }
                let _e1902 = phi_2201_;
                if (_e1888 < 0f) {
                    phi_2208_ = (_e1888 + _e1902);
                } else {
                    phi_2208_ = (_e1888 - _e1902);
                }
                let _e1907 = phi_2208_;
                if (_e1894 < 0f) {
                    phi_2215_ = (_e1894 + _e1902);
                } else {
                    phi_2215_ = (_e1894 - _e1902);
                }
                let _e1912 = phi_2215_;
                let _e1919 = (1f / sqrt((((_e1907 * _e1907) + (_e1912 * _e1912)) + (_e1898 * _e1898))));
                let _e1935 = (f32((bitcast<i32>((_e1785[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1941 = (f32((bitcast<i32>(_e1785[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1945 = ((1f - abs(_e1935)) - abs(_e1941));
                if (_e1945 < 0f) {
                    phi_2250_ = -(_e1945);
                } else {
                    phi_2250_ = 0f;
                }
                let _e1949 = phi_2250_;
                if (_e1935 < 0f) {
                    phi_2257_ = (_e1935 + _e1949);
                } else {
                    phi_2257_ = (_e1935 - _e1949);
                }
                let _e1954 = phi_2257_;
                if (_e1941 < 0f) {
                    phi_2264_ = (_e1941 + _e1949);
                } else {
                    phi_2264_ = (_e1941 - _e1949);
                }
                let _e1959 = phi_2264_;
                let _e1966 = (1f / sqrt((((_e1954 * _e1954) + (_e1959 * _e1959)) + (_e1945 * _e1945))));
                let _e1985 = (f32((bitcast<i32>((_e1785[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1991 = (f32((bitcast<i32>(_e1785[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1995 = ((1f - abs(_e1985)) - abs(_e1991));
                if (_e1995 < 0f) {
                    phi_2302_ = -(_e1995);
                } else {
                    phi_2302_ = 0f;
                }
                let _e1999 = phi_2302_;
                if (_e1985 < 0f) {
                    phi_2309_ = (_e1985 + _e1999);
                } else {
                    phi_2309_ = (_e1985 - _e1999);
                }
                let _e2004 = phi_2309_;
                if (_e1991 < 0f) {
                    phi_2316_ = (_e1991 + _e1999);
                } else {
                    phi_2316_ = (_e1991 - _e1999);
                }
                let _e2009 = phi_2316_;
                let _e2016 = (1f / sqrt((((_e2004 * _e2004) + (_e2009 * _e2009)) + (_e1995 * _e1995))));
                let _e2027 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e1907 * _e1919) * _e1619) + ((_e1954 * _e1966) * _e1613.u)) + ((_e2004 * _e2016) * _e1613.v)), ((((_e1912 * _e1919) * _e1619) + ((_e1959 * _e1966) * _e1613.u)) + ((_e2009 * _e2016) * _e1613.v)), ((((_e1898 * _e1919) * _e1619) + ((_e1945 * _e1966) * _e1613.u)) + ((_e1995 * _e2016) * _e1613.v))));
                let _e2039 = sqrt((((_e2027.x * _e2027.x) + (_e2027.y * _e2027.y)) + (_e2027.z * _e2027.z)));
                if (_e2039 > 0f) {
                    let _e2042 = (_e2027.x / _e2039);
                    let _e2044 = (_e2027.y / _e2039);
                    let _e2046 = (_e2027.z / _e2039);
                    if ((((_e2042 * _e1763.x) + (_e2044 * _e1763.y)) + (_e2046 * _e1763.z)) < 0f) {
                        phi_2375_ = vec3<f32>(-(_e2042), -(_e2044), -(_e2046));
                    } else {
                        phi_2375_ = (_e2027 / vec3(_e2039));
                    }
                    let _e2063 = phi_2375_;
                    phi_2376_ = _e2063;
                } else {
                    phi_2376_ = _e1763;
                }
                let _e2065 = phi_2376_;
                phi_2377_ = _e2065;
            }
            let _e2067 = phi_2377_;
            if (_e1864 > 0f) {
                if (_e1864 < 1f) {
                    phi_2386_ = _e1864;
                } else {
                    phi_2386_ = 1f;
                }
                let _e2071 = phi_2386_;
                phi_2387_ = _e2071;
            } else {
                phi_2387_ = 0f;
            }
            let _e2073 = phi_2387_;
            if (_e1866 > 0f) {
                if (_e1866 < 1f) {
                    phi_2397_ = _e1866;
                } else {
                    phi_2397_ = 1f;
                }
                let _e2078 = phi_2397_;
                phi_2398_ = _e2078;
            } else {
                phi_2398_ = 0f;
            }
            let _e2080 = phi_2398_;
            if (_e1868 > 0f) {
                if (_e1868 < 1f) {
                    phi_2408_ = _e1868;
                } else {
                    phi_2408_ = 1f;
                }
                let _e2085 = phi_2408_;
                phi_2409_ = _e2085;
            } else {
                phi_2409_ = 0f;
            }
            let _e2087 = phi_2409_;
            let _e2090 = ((sqrt(_e2073) * 255f) + 0.5f);
            let _e2099 = ((sqrt(_e2080) * 255f) + 0.5f);
            let _e2111 = ((sqrt(_e2087) * 255f) + 0.5f);
            phi_2444_ = abi_Sample(vec3<f32>(_e1650, _e1651, _e1652), _e1870, _e1763, _e1875, _e2067, ((select(select(u32(_e2090), 0u, (_e2090 < bitcast<f32>(0u))), 4294967295u, (_e2090 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2099), 0u, (_e2099 < bitcast<f32>(0u))), 4294967295u, (_e2099 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2111), 0u, (_e2111 < bitcast<f32>(0u))), 4294967295u, (_e2111 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_2444_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2125 = phi_2444_;
        if (_e91.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e91.shift)] = _e2125;
        if (_e1613.triangle != 4294967295u) {
            let _e2134 = ((1f - _e1613.u) - _e1613.v);
            if (_e1613.triangle < _e70) {
            } else {
                return;
            }
            let _e2139 = triangles.member[(0u + _e1613.triangle)];
            let _e2141 = (_e2139.i0_ & 2147483647u);
            if (_e2141 < _e82) {
            } else {
                return;
            }
            let _e2147 = before.member[(0u + _e2141)];
            if (_e2139.i1_ < _e82) {
            } else {
                return;
            }
            let _e2151 = before.member[(0u + _e2139.i1_)];
            if (_e2139.i2_ < _e82) {
            } else {
                return;
            }
            let _e2155 = before.member[(0u + _e2139.i2_)];
            let _e2160 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2147.x, _e2147.y, _e2147.z));
            let _e2171 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2151.x, _e2151.y, _e2151.z));
            let _e2185 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2155.x, _e2155.y, _e2155.z));
            phi_2535_ = vec3<f32>((((_e2160.x * _e2134) + (_e2171.x * _e1613.u)) + (_e2185.x * _e1613.v)), (((_e2160.y * _e2134) + (_e2171.y * _e1613.u)) + (_e2185.y * _e1613.v)), (((_e2160.z * _e2134) + (_e2171.z * _e1613.u)) + (_e2185.z * _e1613.v)));
        } else {
            phi_2535_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e2197 = phi_2535_;
        if (_e91.shift < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e91.shift)] = vec4<f32>(_e2197.x, _e2197.y, _e2197.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
