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
                let _e294 = phi_498_;
                if (_e146.direction.x < 0f) {
                    phi_505_ = (-1f / _e294);
                } else {
                    phi_505_ = (1f / _e294);
                }
                let _e299 = phi_505_;
                if (abs(_e146.direction.y) < _e288) {
                    phi_513_ = _e288;
                } else {
                    phi_513_ = abs(_e146.direction.y);
                }
                let _e305 = phi_513_;
                if (_e146.direction.y < 0f) {
                    phi_520_ = (-1f / _e305);
                } else {
                    phi_520_ = (1f / _e305);
                }
                let _e310 = phi_520_;
                if (abs(_e146.direction.z) < _e288) {
                    phi_528_ = _e288;
                } else {
                    phi_528_ = abs(_e146.direction.z);
                }
                let _e316 = phi_528_;
                if (_e146.direction.z < 0f) {
                    phi_535_ = (-1f / _e316);
                } else {
                    phi_535_ = (1f / _e316);
                }
                let _e321 = phi_535_;
                let _e329 = abs((bitcast<f32>(_e224) - _e146.origin.x));
                let _e330 = abs((bitcast<f32>(_e228) - _e146.origin.y));
                let _e331 = abs((bitcast<f32>(_e232) - _e146.origin.z));
                let _e339 = abs(((bitcast<f32>(_e236) + (bitcast<f32>((((_e248 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e146.origin.x));
                let _e340 = abs(((bitcast<f32>(_e240) + (bitcast<f32>((((_e248 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e146.origin.y));
                let _e341 = abs(((bitcast<f32>(_e244) + (bitcast<f32>((((_e248 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e146.origin.z));
                if (_e329 > _e339) {
                    phi_560_ = _e329;
                } else {
                    phi_560_ = _e339;
                }
                let _e344 = phi_560_;
                if (_e330 > _e340) {
                    phi_565_ = _e330;
                } else {
                    phi_565_ = _e340;
                }
                let _e347 = phi_565_;
                if (_e331 > _e341) {
                    phi_570_ = _e331;
                } else {
                    phi_570_ = _e341;
                }
                let _e350 = phi_570_;
                let _e351 = core_intrinsics_maximum_number_nsz_f32_(_e344, _e347);
                let _e352 = core_intrinsics_maximum_number_nsz_f32_(_e351, _e350);
                let _e357 = (_e352 * 0.0000019073486f);
                let _e358 = (abs(_e299) * _e357);
                let _e359 = (abs(_e310) * _e357);
                let _e360 = (abs(_e321) * _e357);
                let _e364 = (_e352 * 0.0000009536743f);
                let _e365 = (abs(_e299) * _e364);
                let _e366 = (abs(_e310) * _e364);
                let _e367 = (abs(_e321) * _e364);
                let _e370 = abs(_e146.direction.x);
                let _e372 = abs(_e146.direction.y);
                let _e374 = abs(_e146.direction.z);
                if (_e370 >= _e372) {
                    if (_e370 >= _e374) {
                        phi_603_ = false;
                    } else {
                        phi_603_ = true;
                    }
                    let _e378 = phi_603_;
                    phi_604_ = _e378;
                } else {
                    phi_604_ = true;
                }
                let _e380 = phi_604_;
                if _e380 {
                    if (_e372 >= _e374) {
                        phi_612_ = 1u;
                    } else {
                        phi_612_ = 2u;
                    }
                    let _e383 = phi_612_;
                    phi_613_ = _e383;
                } else {
                    phi_613_ = 0u;
                }
                let _e385 = phi_613_;
                if (_e385 == 0u) {
                    phi_632_ = vec3<f32>(_e146.direction.y, _e146.direction.z, _e146.direction.x);
                } else {
                    if (_e385 == 1u) {
                        phi_631_ = vec3<f32>(_e146.direction.z, _e146.direction.x, _e146.direction.y);
                    } else {
                        phi_631_ = _e146.direction;
                    }
                    let _e398 = phi_631_;
                    phi_632_ = _e398;
                }
                let _e400 = phi_632_;
                let _e404 = (_e400.x / _e400.z);
                let _e407 = (_e400.y / _e400.z);
                if (_e299 < 0f) {
                    phi_646_ = 0u;
                } else {
                    phi_646_ = 1u;
                }
                let _e412 = phi_646_;
                if (_e310 < 0f) {
                    phi_651_ = 0u;
                } else {
                    phi_651_ = 2u;
                }
                let _e415 = phi_651_;
                if (_e321 < 0f) {
                    phi_656_ = 0u;
                } else {
                    phi_656_ = 4u;
                }
                let _e418 = phi_656_;
                let _e420 = ((_e412 | _e415) | _e418);
                let _e421 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local = lt_bvh_traverse_Stack(array<u32, 32>(_e421.first[0], _e421.first[1], _e421.first[2], _e421.first[3], _e421.first[4], _e421.first[5], _e421.first[6], _e421.first[7], _e421.first[8], _e421.first[9], _e421.first[10], _e421.first[11], _e421.first[12], _e421.first[13], _e421.first[14], _e421.first[15], _e421.first[16], _e421.first[17], _e421.first[18], _e421.first[19], _e421.first[20], _e421.first[21], _e421.first[22], _e421.first[23], _e421.first[24], _e421.first[25], _e421.first[26], _e421.first[27], _e421.first[28], _e421.first[29], _e421.first[30], _e421.first[31]), array<u32, 32>(_e421.mask[0], _e421.mask[1], _e421.mask[2], _e421.mask[3], _e421.mask[4], _e421.mask[5], _e421.mask[6], _e421.mask[7], _e421.mask[8], _e421.mask[9], _e421.mask[10], _e421.mask[11], _e421.mask[12], _e421.mask[13], _e421.mask[14], _e421.mask[15], _e421.mask[16], _e421.mask[17], _e421.mask[18], _e421.mask[19], _e421.mask[20], _e421.mask[21], _e421.mask[22], _e421.mask[23], _e421.mask[24], _e421.mask[25], _e421.mask[26], _e421.mask[27], _e421.mask[28], _e421.mask[29], _e421.mask[30], _e421.mask[31]), _e421.len, _e421.group, _e421.group_mask);
                let _e495 = local.group_mask;
                if ((_e495 & 4278190080u) == 0u) {
                    let _e499 = local.len;
                    if (_e499 == 0u) {
                        phi_770_ = false;
                    } else {
                        let _e503 = local.len;
                        local.len = (_e503 - 1u);
                        let _e506 = local.len;
                        if (_e506 < 32u) {
                        } else {
                            return;
                        }
                        let _e511 = local.first[(0u + _e506)];
                        local.group = _e511;
                        let _e514 = local.len;
                        if (_e514 < 32u) {
                        } else {
                            return;
                        }
                        let _e519 = local.mask[(0u + _e514)];
                        local.group_mask = _e519;
                        phi_770_ = true;
                    }
                    let _e522 = phi_770_;
                    phi_771_ = _e522;
                } else {
                    phi_771_ = true;
                }
                let _e524 = phi_771_;
                if _e524 {
                    let _e526 = local.group_mask;
                    let _e532 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e526)), 32u, (_e526 == 0u)));
                    let _e536 = local.group_mask;
                    let _e550 = local.group_mask;
                    local.group_mask = (_e550 & ~((1u << bitcast<u32>((_e532 & 31u)))));
                    let _e553 = local.group;
                    phi_802_ = (_e553 + countOneBits(((_e536 & ~((4294967295u << bitcast<u32>((((_e532 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_802_ = 4294967295u;
                }
                let _e556 = phi_802_;
                phi_804_ = _e148;
                phi_807_ = _e556;
                loop {
                    let _e558 = phi_804_;
                    let _e560 = phi_807_;
                    local_5 = _e558;
                    let _e561 = (_e560 != 4294967295u);
                    if _e561 {
                        if (_e560 < _e67) {
                        } else {
                            return;
                        }
                        let _e569 = nodes.member[(0u + _e560)].frame[3u];
                        let _e594 = (bitcast<f32>((((_e569 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e299);
                        let _e595 = (bitcast<f32>((((_e569 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e310);
                        let _e596 = (bitcast<f32>((((_e569 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e321);
                        let _e599 = nodes.member[(0u + _e560)].frame[0u];
                        let _e603 = nodes.member[(0u + _e560)].frame[1u];
                        let _e607 = nodes.member[(0u + _e560)].frame[2u];
                        let _e615 = ((bitcast<f32>(_e599) - _e146.origin.x) * _e299);
                        let _e616 = ((bitcast<f32>(_e603) - _e146.origin.y) * _e310);
                        let _e617 = ((bitcast<f32>(_e607) - _e146.origin.z) * _e321);
                        let _e625 = nodes.member[(0u + _e560)].x;
                        if (_e299 < 0f) {
                            let _e636 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e625.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e642 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e636.unnamed.word, _e625.w), _e636.unnamed_1);
                            let _e648 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e642.unnamed, lt_mask_LightPlace(_e625.x, _e642.unnamed_1.shift));
                            phi_892_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e648.unnamed, lt_mask_LightPlace(_e648.unnamed_1.word, _e625.y));
                        } else {
                            let _e664 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e625.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e670 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e664.unnamed.word, _e625.y), _e664.unnamed_1);
                            let _e676 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e670.unnamed, lt_mask_LightPlace(_e625.z, _e670.unnamed_1.shift));
                            phi_892_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e676.unnamed, lt_mask_LightPlace(_e676.unnamed_1.word, _e625.w));
                        }
                        let _e684 = phi_892_;
                        let _e694 = nodes.member[(0u + _e560)].y;
                        if (_e310 < 0f) {
                            let _e705 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e694.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e711 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e705.unnamed.word, _e694.w), _e705.unnamed_1);
                            let _e717 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e711.unnamed, lt_mask_LightPlace(_e694.x, _e711.unnamed_1.shift));
                            phi_919_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e717.unnamed, lt_mask_LightPlace(_e717.unnamed_1.word, _e694.y));
                        } else {
                            let _e733 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e694.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e739 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e733.unnamed.word, _e694.y), _e733.unnamed_1);
                            let _e745 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e739.unnamed, lt_mask_LightPlace(_e694.z, _e739.unnamed_1.shift));
                            phi_919_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e745.unnamed, lt_mask_LightPlace(_e745.unnamed_1.word, _e694.w));
                        }
                        let _e753 = phi_919_;
                        let _e763 = nodes.member[(0u + _e560)].z;
                        if (_e321 < 0f) {
                            let _e774 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e763.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e780 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e774.unnamed.word, _e763.w), _e774.unnamed_1);
                            let _e786 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e780.unnamed, lt_mask_LightPlace(_e763.x, _e780.unnamed_1.shift));
                            phi_946_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e786.unnamed, lt_mask_LightPlace(_e786.unnamed_1.word, _e763.y));
                        } else {
                            let _e802 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e763.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e808 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e802.unnamed.word, _e763.y), _e802.unnamed_1);
                            let _e814 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e808.unnamed, lt_mask_LightPlace(_e763.z, _e808.unnamed_1.shift));
                            phi_946_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e814.unnamed, lt_mask_LightPlace(_e814.unnamed_1.word, _e763.w));
                        }
                        let _e822 = phi_946_;
                        phi_952_ = 0u;
                        phi_955_ = 0u;
                        loop {
                            let _e832 = phi_952_;
                            let _e834 = phi_955_;
                            local_1 = _e834;
                            local_2 = _e834;
                            local_3 = _e834;
                            let _e835 = (_e832 < 8u);
                            if _e835 {
                                let _e837 = (_e832 >> bitcast<u32>(2i));
                                let _e838 = (_e832 & 3u);
                                if (_e837 == 0u) {
                                    phi_969_ = _e684.unnamed.word;
                                } else {
                                    phi_969_ = _e684.unnamed.shift;
                                }
                                let _e841 = phi_969_;
                                if (_e837 == 0u) {
                                    phi_979_ = _e753.unnamed.word;
                                } else {
                                    phi_979_ = _e753.unnamed.shift;
                                }
                                let _e850 = phi_979_;
                                if (_e837 == 0u) {
                                    phi_989_ = _e822.unnamed.word;
                                } else {
                                    phi_989_ = _e822.unnamed.shift;
                                }
                                let _e859 = phi_989_;
                                let _e872 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e841 >> bitcast<u32>(((_e838 * 8u) & 31u))) & 255u)) * _e594) + (_e615 - _e358)), ((f32(((_e850 >> bitcast<u32>(((_e838 * 8u) & 31u))) & 255u)) * _e595) + (_e616 - _e359)));
                                let _e873 = core_intrinsics_maximum_number_nsz_f32_(_e872, ((f32(((_e859 >> bitcast<u32>(((_e838 * 8u) & 31u))) & 255u)) * _e596) + (_e617 - _e360)));
                                if (_e837 == 0u) {
                                    phi_1007_ = _e684.unnamed_1.word;
                                } else {
                                    phi_1007_ = _e684.unnamed_1.shift;
                                }
                                let _e876 = phi_1007_;
                                if (_e837 == 0u) {
                                    phi_1017_ = _e753.unnamed_1.word;
                                } else {
                                    phi_1017_ = _e753.unnamed_1.shift;
                                }
                                let _e885 = phi_1017_;
                                if (_e837 == 0u) {
                                    phi_1027_ = _e822.unnamed_1.word;
                                } else {
                                    phi_1027_ = _e822.unnamed_1.shift;
                                }
                                let _e894 = phi_1027_;
                                let _e907 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e876 >> bitcast<u32>(((_e838 * 8u) & 31u))) & 255u)) * _e594) + (_e615 + _e358)), ((f32(((_e885 >> bitcast<u32>(((_e838 * 8u) & 31u))) & 255u)) * _e595) + (_e616 + _e359)));
                                let _e908 = core_intrinsics_minimum_number_nsz_f32_(_e907, ((f32(((_e894 >> bitcast<u32>(((_e838 * 8u) & 31u))) & 255u)) * _e596) + (_e617 + _e360)));
                                if (_e873 <= _e908) {
                                    if (_e873 <= _e558.t) {
                                        if (_e908 >= _e146.tmin) {
                                            if (_e837 == 0u) {
                                                let _e915 = nodes.member[(0u + _e560)].links[2u];
                                                phi_1063_ = _e915;
                                            } else {
                                                let _e918 = nodes.member[(0u + _e560)].links[3u];
                                                phi_1063_ = _e918;
                                            }
                                            let _e920 = phi_1063_;
                                            let _e925 = ((_e920 >> bitcast<u32>(((_e838 * 8u) & 31u))) & 255u);
                                            let _e926 = (_e925 & 31u);
                                            if (_e926 >= 24u) {
                                                phi_1076_ = (24u + ((_e926 - 24u) ^ _e420));
                                            } else {
                                                phi_1076_ = _e926;
                                            }
                                            let _e932 = phi_1076_;
                                            phi_1081_ = (_e834 | ((_e925 >> bitcast<u32>(5i)) << bitcast<u32>((_e932 & 31u))));
                                        } else {
                                            phi_1081_ = _e834;
                                        }
                                        let _e940 = phi_1081_;
                                        phi_1082_ = _e940;
                                    } else {
                                        phi_1082_ = _e834;
                                    }
                                    let _e942 = phi_1082_;
                                    phi_1083_ = _e942;
                                } else {
                                    phi_1083_ = _e834;
                                }
                                let _e944 = phi_1083_;
                                phi_953_ = (_e832 + 1u);
                                phi_956_ = _e944;
                            } else {
                                phi_953_ = u32();
                                phi_956_ = u32();
                            }
                            let _e947 = phi_953_;
                            let _e949 = phi_956_;
                            continue;
                            continuing {
                                phi_952_ = _e947;
                                phi_955_ = _e949;
                                break if !(_e835);
                            }
                        }
                        let _e953 = nodes.member[(0u + _e560)].links[0u];
                        let _e957 = nodes.member[(0u + _e560)].frame[3u];
                        let _e961 = local_1;
                        if ((_e961 & 4278190080u) == 0u) {
                        } else {
                            let _e965 = local.group_mask;
                            if ((_e965 & 4278190080u) == 0u) {
                            } else {
                                let _e969 = local.len;
                                if (_e969 < 32u) {
                                    let _e972 = local.group;
                                    let _e974 = local.len;
                                    if (_e974 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.first[(0u + _e974)] = _e972;
                                    let _e980 = local.group_mask;
                                    let _e982 = local.len;
                                    if (_e982 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.mask[(0u + _e982)] = _e980;
                                    let _e989 = local.len;
                                    local.len = (_e989 + 1u);
                                }
                            }
                            local.group = (0u + _e953);
                            let _e993 = local_2;
                            local.group_mask = ((_e993 & 4278190080u) | (_e957 >> bitcast<u32>(24i)));
                        }
                        let _e998 = local_3;
                        phi_1141_ = _e558;
                        phi_1144_ = (_e998 & 16777215u);
                        loop {
                            let _e1001 = phi_1141_;
                            let _e1003 = phi_1144_;
                            local_4 = _e1001;
                            if (_e1003 == 0u) {
                                phi_1142_ = lt_bvh_Hit();
                                phi_1145_ = u32();
                                phi_1803_ = false;
                            } else {
                                let _e1007 = nodes.member[(0u + _e560)].links[1u];
                                let _e1012 = ((0u + _e1007) + select(firstTrailingBit(_e1003), 32u, (_e1003 == 0u)));
                                if (_e1012 < _e70) {
                                } else {
                                    return;
                                }
                                let _e1019 = triangles.member[(0u + _e1012)].v0_;
                                let _e1022 = (_e1019.x - _e146.origin.x);
                                let _e1025 = (_e1019.y - _e146.origin.y);
                                let _e1028 = (_e1019.z - _e146.origin.z);
                                if (_e385 == 0u) {
                                    phi_1191_ = vec3<f32>(_e1025, _e1028, _e1022);
                                } else {
                                    if (_e385 == 1u) {
                                        phi_1190_ = vec3<f32>(_e1028, _e1022, _e1025);
                                    } else {
                                        phi_1190_ = (_e1019 - _e146.origin);
                                    }
                                    let _e1035 = phi_1190_;
                                    phi_1191_ = _e1035;
                                }
                                let _e1037 = phi_1191_;
                                let _e1041 = (_e1037.x - (_e404 * _e1037.z));
                                let _e1045 = (_e1037.y - (_e407 * _e1037.z));
                                let _e1047 = triangles.member[(0u + _e1012)].v1_;
                                let _e1050 = (_e1047.x - _e146.origin.x);
                                let _e1053 = (_e1047.y - _e146.origin.y);
                                let _e1056 = (_e1047.z - _e146.origin.z);
                                if (_e385 == 0u) {
                                    phi_1223_ = vec3<f32>(_e1053, _e1056, _e1050);
                                } else {
                                    if (_e385 == 1u) {
                                        phi_1222_ = vec3<f32>(_e1056, _e1050, _e1053);
                                    } else {
                                        phi_1222_ = (_e1047 - _e146.origin);
                                    }
                                    let _e1063 = phi_1222_;
                                    phi_1223_ = _e1063;
                                }
                                let _e1065 = phi_1223_;
                                let _e1069 = (_e1065.x - (_e404 * _e1065.z));
                                let _e1073 = (_e1065.y - (_e407 * _e1065.z));
                                let _e1075 = triangles.member[(0u + _e1012)].v2_;
                                let _e1078 = (_e1075.x - _e146.origin.x);
                                let _e1081 = (_e1075.y - _e146.origin.y);
                                let _e1084 = (_e1075.z - _e146.origin.z);
                                if (_e385 == 0u) {
                                    phi_1255_ = vec3<f32>(_e1081, _e1084, _e1078);
                                } else {
                                    if (_e385 == 1u) {
                                        phi_1254_ = vec3<f32>(_e1084, _e1078, _e1081);
                                    } else {
                                        phi_1254_ = (_e1075 - _e146.origin);
                                    }
                                    let _e1091 = phi_1254_;
                                    phi_1255_ = _e1091;
                                }
                                let _e1093 = phi_1255_;
                                let _e1097 = (_e1093.x - (_e404 * _e1093.z));
                                let _e1101 = (_e1093.y - (_e407 * _e1093.z));
                                if (_e1069 < _e1097) {
                                    phi_1274_ = true;
                                } else {
                                    if (_e1069 == _e1097) {
                                        phi_1273_ = (_e1073 < _e1101);
                                    } else {
                                        phi_1273_ = false;
                                    }
                                    let _e1106 = phi_1273_;
                                    phi_1274_ = _e1106;
                                }
                                let _e1108 = phi_1274_;
                                if _e1108 {
                                    phi_1278_ = _e1101;
                                    phi_1279_ = _e1097;
                                    phi_1280_ = _e1073;
                                    phi_1281_ = _e1069;
                                } else {
                                    phi_1278_ = _e1073;
                                    phi_1279_ = _e1069;
                                    phi_1280_ = _e1101;
                                    phi_1281_ = _e1097;
                                }
                                let _e1110 = phi_1278_;
                                let _e1112 = phi_1279_;
                                let _e1114 = phi_1280_;
                                let _e1116 = phi_1281_;
                                let _e1119 = ((_e1116 * _e1110) - (_e1114 * _e1112));
                                if _e1108 {
                                    phi_1289_ = -(_e1119);
                                } else {
                                    phi_1289_ = _e1119;
                                }
                                let _e1122 = phi_1289_;
                                if (_e1097 < _e1041) {
                                    phi_1300_ = true;
                                } else {
                                    if (_e1097 == _e1041) {
                                        phi_1299_ = (_e1101 < _e1045);
                                    } else {
                                        phi_1299_ = false;
                                    }
                                    let _e1127 = phi_1299_;
                                    phi_1300_ = _e1127;
                                }
                                let _e1129 = phi_1300_;
                                if _e1129 {
                                    phi_1304_ = _e1045;
                                    phi_1305_ = _e1041;
                                    phi_1306_ = _e1101;
                                    phi_1307_ = _e1097;
                                } else {
                                    phi_1304_ = _e1101;
                                    phi_1305_ = _e1097;
                                    phi_1306_ = _e1045;
                                    phi_1307_ = _e1041;
                                }
                                let _e1131 = phi_1304_;
                                let _e1133 = phi_1305_;
                                let _e1135 = phi_1306_;
                                let _e1137 = phi_1307_;
                                let _e1140 = ((_e1137 * _e1131) - (_e1135 * _e1133));
                                if _e1129 {
                                    phi_1315_ = -(_e1140);
                                } else {
                                    phi_1315_ = _e1140;
                                }
                                let _e1143 = phi_1315_;
                                if (_e1041 < _e1069) {
                                    phi_1326_ = true;
                                } else {
                                    if (_e1041 == _e1069) {
                                        phi_1325_ = (_e1045 < _e1073);
                                    } else {
                                        phi_1325_ = false;
                                    }
                                    let _e1148 = phi_1325_;
                                    phi_1326_ = _e1148;
                                }
                                let _e1150 = phi_1326_;
                                if _e1150 {
                                    phi_1330_ = _e1073;
                                    phi_1331_ = _e1069;
                                    phi_1332_ = _e1045;
                                    phi_1333_ = _e1041;
                                } else {
                                    phi_1330_ = _e1045;
                                    phi_1331_ = _e1041;
                                    phi_1332_ = _e1073;
                                    phi_1333_ = _e1069;
                                }
                                let _e1152 = phi_1330_;
                                let _e1154 = phi_1331_;
                                let _e1156 = phi_1332_;
                                let _e1158 = phi_1333_;
                                let _e1161 = ((_e1158 * _e1152) - (_e1156 * _e1154));
                                if _e1150 {
                                    phi_1341_ = -(_e1161);
                                } else {
                                    phi_1341_ = _e1161;
                                }
                                let _e1164 = phi_1341_;
                                if (_e1122 >= 0f) {
                                    if (_e1143 >= 0f) {
                                        if (_e1164 >= 0f) {
                                            phi_1356_ = ((_e1122 + _e1143) + _e1164);
                                            phi_1357_ = false;
                                        } else {
                                            phi_1356_ = f32();
                                            phi_1357_ = true;
                                        }
                                        let _e1171 = phi_1356_;
                                        let _e1173 = phi_1357_;
                                        phi_1358_ = _e1171;
                                        phi_1359_ = _e1173;
                                    } else {
                                        phi_1358_ = f32();
                                        phi_1359_ = true;
                                    }
                                    let _e1175 = phi_1358_;
                                    let _e1177 = phi_1359_;
                                    phi_1360_ = _e1175;
                                    phi_1361_ = _e1177;
                                } else {
                                    phi_1360_ = f32();
                                    phi_1361_ = true;
                                }
                                let _e1179 = phi_1360_;
                                let _e1181 = phi_1361_;
                                if _e1181 {
                                    if (_e1122 <= 0f) {
                                        if (_e1143 <= 0f) {
                                            let _e1184 = (_e1164 <= 0f);
                                            if _e1184 {
                                            }
                                            phi_1379_ = ((_e1122 + _e1143) + _e1164);
                                            phi_1380_ = false;
                                            phi_1381_ = _e1184;
                                        } else {
                                            phi_1379_ = f32();
                                            phi_1380_ = true;
                                            phi_1381_ = false;
                                        }
                                        let _e1188 = phi_1379_;
                                        let _e1190 = phi_1380_;
                                        let _e1192 = phi_1381_;
                                        phi_1382_ = _e1188;
                                        phi_1383_ = _e1190;
                                        phi_1384_ = _e1192;
                                    } else {
                                        phi_1382_ = f32();
                                        phi_1383_ = true;
                                        phi_1384_ = false;
                                    }
                                    let _e1194 = phi_1382_;
                                    let _e1196 = phi_1383_;
                                    let _e1198 = phi_1384_;
                                    if _e1196 {
                                        phi_1388_ = false;
                                    } else {
                                        phi_1388_ = _e1198;
                                    }
                                    let _e1200 = phi_1388_;
                                    phi_1389_ = _e1194;
                                    phi_1390_ = _e1200;
                                } else {
                                    phi_1389_ = _e1179;
                                    phi_1390_ = true;
                                }
                                let _e1202 = phi_1389_;
                                let _e1204 = phi_1390_;
                                if _e1204 {
                                    let _e1205 = (_e1202 == 0f);
                                    if _e1205 {
                                        phi_1716_ = lt_bvh_triangle_Intersection();
                                        phi_1717_ = false;
                                    } else {
                                        let _e1207 = triangles.member[(0u + _e1012)].v0_;
                                        let _e1210 = (_e1207.x - _e146.origin.x);
                                        let _e1213 = (_e1207.y - _e146.origin.y);
                                        let _e1216 = (_e1207.z - _e146.origin.z);
                                        if (_e385 == 0u) {
                                            phi_1421_ = vec3<f32>(_e1213, _e1216, _e1210);
                                        } else {
                                            if (_e385 == 1u) {
                                                phi_1420_ = vec3<f32>(_e1216, _e1210, _e1213);
                                            } else {
                                                phi_1420_ = (_e1207 - _e146.origin);
                                            }
                                            let _e1223 = phi_1420_;
                                            phi_1421_ = _e1223;
                                        }
                                        let _e1225 = phi_1421_;
                                        let _e1227 = triangles.member[(0u + _e1012)].v1_;
                                        let _e1229 = triangles.member[(0u + _e1012)].v0_;
                                        let _e1232 = (_e1227.x - _e1229.x);
                                        let _e1235 = (_e1227.y - _e1229.y);
                                        let _e1238 = (_e1227.z - _e1229.z);
                                        if (_e385 == 0u) {
                                            phi_1447_ = vec3<f32>(_e1235, _e1238, _e1232);
                                        } else {
                                            if (_e385 == 1u) {
                                                phi_1446_ = vec3<f32>(_e1238, _e1232, _e1235);
                                            } else {
                                                phi_1446_ = (_e1227 - _e1229);
                                            }
                                            let _e1245 = phi_1446_;
                                            phi_1447_ = _e1245;
                                        }
                                        let _e1247 = phi_1447_;
                                        let _e1249 = triangles.member[(0u + _e1012)].v2_;
                                        let _e1251 = triangles.member[(0u + _e1012)].v0_;
                                        let _e1254 = (_e1249.x - _e1251.x);
                                        let _e1257 = (_e1249.y - _e1251.y);
                                        let _e1260 = (_e1249.z - _e1251.z);
                                        if (_e385 == 0u) {
                                            phi_1473_ = vec3<f32>(_e1257, _e1260, _e1254);
                                        } else {
                                            if (_e385 == 1u) {
                                                phi_1472_ = vec3<f32>(_e1260, _e1254, _e1257);
                                            } else {
                                                phi_1472_ = (_e1249 - _e1251);
                                            }
                                            let _e1267 = phi_1472_;
                                            phi_1473_ = _e1267;
                                        }
                                        let _e1269 = phi_1473_;
                                        let _e1276 = ((_e1247.y * _e1269.z) - (_e1247.z * _e1269.y));
                                        let _e1283 = ((_e1247.z * _e1269.x) - (_e1247.x * _e1269.z));
                                        let _e1290 = ((_e1247.x * _e1269.y) - (_e1247.y * _e1269.x));
                                        let _e1304 = (((1f / _e400.z) * (((_e1276 * _e1225.x) + (_e1283 * _e1225.y)) + (_e1290 * _e1225.z))) / (((_e1276 * _e404) + (_e1283 * _e407)) + _e1290));
                                        if (_e1304 > _e146.tmin) {
                                            if (_e1304 < _e146.tmax) {
                                                let _e1310 = triangles.member[(0u + _e1012)].v0_;
                                                let _e1312 = triangles.member[(0u + _e1012)].v1_;
                                                if (_e1310.x < _e1312.x) {
                                                    phi_1531_ = _e1310.x;
                                                } else {
                                                    phi_1531_ = _e1312.x;
                                                }
                                                let _e1319 = phi_1531_;
                                                if (_e1310.y < _e1312.y) {
                                                    phi_1540_ = _e1310.y;
                                                } else {
                                                    phi_1540_ = _e1312.y;
                                                }
                                                let _e1326 = phi_1540_;
                                                if (_e1310.z < _e1312.z) {
                                                    phi_1549_ = _e1310.z;
                                                } else {
                                                    phi_1549_ = _e1312.z;
                                                }
                                                let _e1333 = phi_1549_;
                                                let _e1335 = triangles.member[(0u + _e1012)].v2_;
                                                if (_e1319 < _e1335.x) {
                                                    phi_1558_ = _e1319;
                                                } else {
                                                    phi_1558_ = _e1335.x;
                                                }
                                                let _e1340 = phi_1558_;
                                                if (_e1326 < _e1335.y) {
                                                    phi_1565_ = _e1326;
                                                } else {
                                                    phi_1565_ = _e1335.y;
                                                }
                                                let _e1345 = phi_1565_;
                                                if (_e1333 < _e1335.z) {
                                                    phi_1572_ = _e1333;
                                                } else {
                                                    phi_1572_ = _e1335.z;
                                                }
                                                let _e1350 = phi_1572_;
                                                let _e1352 = triangles.member[(0u + _e1012)].v0_;
                                                let _e1354 = triangles.member[(0u + _e1012)].v1_;
                                                if (_e1352.x > _e1354.x) {
                                                    phi_1585_ = _e1352.x;
                                                } else {
                                                    phi_1585_ = _e1354.x;
                                                }
                                                let _e1361 = phi_1585_;
                                                if (_e1352.y > _e1354.y) {
                                                    phi_1594_ = _e1352.y;
                                                } else {
                                                    phi_1594_ = _e1354.y;
                                                }
                                                let _e1368 = phi_1594_;
                                                if (_e1352.z > _e1354.z) {
                                                    phi_1603_ = _e1352.z;
                                                } else {
                                                    phi_1603_ = _e1354.z;
                                                }
                                                let _e1375 = phi_1603_;
                                                let _e1377 = triangles.member[(0u + _e1012)].v2_;
                                                if (_e1361 > _e1377.x) {
                                                    phi_1612_ = _e1361;
                                                } else {
                                                    phi_1612_ = _e1377.x;
                                                }
                                                let _e1382 = phi_1612_;
                                                if (_e1368 > _e1377.y) {
                                                    phi_1619_ = _e1368;
                                                } else {
                                                    phi_1619_ = _e1377.y;
                                                }
                                                let _e1387 = phi_1619_;
                                                if (_e1375 > _e1377.z) {
                                                    phi_1626_ = _e1375;
                                                } else {
                                                    phi_1626_ = _e1377.z;
                                                }
                                                let _e1392 = phi_1626_;
                                                let _e1399 = ((_e1340 - _e146.origin.x) * _e299);
                                                let _e1400 = ((_e1345 - _e146.origin.y) * _e310);
                                                let _e1401 = ((_e1350 - _e146.origin.z) * _e321);
                                                let _e1408 = ((_e1382 - _e146.origin.x) * _e299);
                                                let _e1409 = ((_e1387 - _e146.origin.y) * _e310);
                                                let _e1410 = ((_e1392 - _e146.origin.z) * _e321);
                                                if (_e1399 < _e1408) {
                                                    phi_1649_ = _e1399;
                                                } else {
                                                    phi_1649_ = _e1408;
                                                }
                                                let _e1413 = phi_1649_;
                                                if (_e1400 < _e1409) {
                                                    phi_1654_ = _e1400;
                                                } else {
                                                    phi_1654_ = _e1409;
                                                }
                                                let _e1416 = phi_1654_;
                                                if (_e1401 < _e1410) {
                                                    phi_1659_ = _e1401;
                                                } else {
                                                    phi_1659_ = _e1410;
                                                }
                                                let _e1419 = phi_1659_;
                                                if (_e1399 > _e1408) {
                                                    phi_1667_ = _e1399;
                                                } else {
                                                    phi_1667_ = _e1408;
                                                }
                                                let _e1425 = phi_1667_;
                                                if (_e1400 > _e1409) {
                                                    phi_1672_ = _e1400;
                                                } else {
                                                    phi_1672_ = _e1409;
                                                }
                                                let _e1428 = phi_1672_;
                                                if (_e1401 > _e1410) {
                                                    phi_1677_ = _e1401;
                                                } else {
                                                    phi_1677_ = _e1410;
                                                }
                                                let _e1431 = phi_1677_;
                                                let _e1435 = core_intrinsics_maximum_number_nsz_f32_((_e1413 - _e365), (_e1416 - _e366));
                                                let _e1436 = core_intrinsics_maximum_number_nsz_f32_(_e1435, (_e1419 - _e367));
                                                let _e1437 = core_intrinsics_minimum_number_nsz_f32_((_e1425 + _e365), (_e1428 + _e366));
                                                let _e1438 = core_intrinsics_minimum_number_nsz_f32_(_e1437, (_e1431 + _e367));
                                                if (_e1436 > -300000000000000000000000000000000000000f) {
                                                    phi_1689_ = _e1436;
                                                } else {
                                                    phi_1689_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1441 = phi_1689_;
                                                if (_e1438 < 300000000000000000000000000000000000000f) {
                                                    phi_1694_ = _e1438;
                                                } else {
                                                    phi_1694_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1444 = phi_1694_;
                                                if (_e1304 < _e1441) {
                                                    phi_1699_ = _e1441;
                                                } else {
                                                    phi_1699_ = _e1304;
                                                }
                                                let _e1447 = phi_1699_;
                                                if (_e1447 > _e1444) {
                                                    phi_1704_ = _e1444;
                                                } else {
                                                    phi_1704_ = _e1447;
                                                }
                                                let _e1450 = phi_1704_;
                                                phi_1709_ = lt_bvh_triangle_Intersection(_e1450, (_e1143 / _e1202), (_e1164 / _e1202), (_e1441 <= _e1444));
                                                phi_1710_ = false;
                                            } else {
                                                phi_1709_ = lt_bvh_triangle_Intersection();
                                                phi_1710_ = true;
                                            }
                                            let _e1456 = phi_1709_;
                                            let _e1458 = phi_1710_;
                                            phi_1711_ = _e1456;
                                            phi_1712_ = _e1458;
                                        } else {
                                            phi_1711_ = lt_bvh_triangle_Intersection();
                                            phi_1712_ = true;
                                        }
                                        let _e1460 = phi_1711_;
                                        let _e1462 = phi_1712_;
                                        if _e1462 {
                                        }
                                        phi_1716_ = _e1460;
                                        phi_1717_ = _e1462;
                                    }
                                    let _e1464 = phi_1716_;
                                    let _e1466 = phi_1717_;
                                    phi_1718_ = _e1464;
                                    phi_1719_ = _e1205;
                                    phi_1720_ = _e1466;
                                } else {
                                    phi_1718_ = lt_bvh_triangle_Intersection();
                                    phi_1719_ = true;
                                    phi_1720_ = false;
                                }
                                let _e1468 = phi_1718_;
                                let _e1470 = phi_1719_;
                                let _e1472 = phi_1720_;
                                if _e1470 {
                                    phi_1724_ = true;
                                } else {
                                    phi_1724_ = _e1472;
                                }
                                let _e1474 = phi_1724_;
                                if _e1474 {
                                    phi_1728_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1728_ = _e1468;
                                }
                                let _e1476 = phi_1728_;
                                if _e1476.is_hit {
                                    if (_e1476.t > _e146.tmin) {
                                        if (_e1476.t < _e1001.t) {
                                            phi_1777_ = true;
                                        } else {
                                            if (_e1476.t == _e1001.t) {
                                                if (_e1001.triangle != 4294967295u) {
                                                    if (_e1012 < _e1001.triangle) {
                                                        phi_1768_ = true;
                                                    } else {
                                                        if (_e1012 == _e1001.triangle) {
                                                            phi_1767_ = (4294967295u < _e1001.instance);
                                                        } else {
                                                            phi_1767_ = false;
                                                        }
                                                        let _e1495 = phi_1767_;
                                                        phi_1768_ = _e1495;
                                                    }
                                                    let _e1497 = phi_1768_;
                                                    phi_1769_ = _e1497;
                                                    phi_1770_ = false;
                                                } else {
                                                    phi_1769_ = bool();
                                                    phi_1770_ = true;
                                                }
                                                let _e1499 = phi_1769_;
                                                let _e1501 = phi_1770_;
                                                phi_1771_ = _e1499;
                                                phi_1772_ = _e1501;
                                            } else {
                                                phi_1771_ = bool();
                                                phi_1772_ = true;
                                            }
                                            let _e1503 = phi_1771_;
                                            let _e1505 = phi_1772_;
                                            if _e1505 {
                                                phi_1776_ = false;
                                            } else {
                                                phi_1776_ = _e1503;
                                            }
                                            let _e1507 = phi_1776_;
                                            phi_1777_ = _e1507;
                                        }
                                        let _e1509 = phi_1777_;
                                        if _e1509 {
                                            let _e1511 = triangles.member[(0u + _e1012)].i0_;
                                            if ((_e1511 & 2147483648u) == 0u) {
                                                phi_1791_ = true;
                                            } else {
                                                if true {
                                                }
                                                phi_1791_ = true;
                                            }
                                            let _e1515 = phi_1791_;
                                            if _e1515 {
                                                phi_1799_ = lt_bvh_Hit(_e1476.t, _e1476.u, _e1476.v, _e1012, 4294967295u);
                                            } else {
                                                phi_1799_ = _e1001;
                                            }
                                            let _e1521 = phi_1799_;
                                            phi_1800_ = _e1521;
                                        } else {
                                            phi_1800_ = _e1001;
                                        }
                                        let _e1523 = phi_1800_;
                                        phi_1801_ = _e1523;
                                    } else {
                                        phi_1801_ = _e1001;
                                    }
                                    let _e1525 = phi_1801_;
                                    phi_1802_ = _e1525;
                                } else {
                                    phi_1802_ = _e1001;
                                }
                                let _e1527 = phi_1802_;
                                phi_1142_ = _e1527;
                                phi_1145_ = (_e1003 & (_e1003 - 1u));
                                phi_1803_ = true;
                            }
                            let _e1529 = phi_1142_;
                            let _e1531 = phi_1145_;
                            let _e1533 = phi_1803_;
                            continue;
                            continuing {
                                phi_1141_ = _e1529;
                                phi_1144_ = _e1531;
                                break if !(_e1533);
                            }
                        }
                        let _e1536 = local.group_mask;
                        if ((_e1536 & 4278190080u) == 0u) {
                            let _e1540 = local.len;
                            if (_e1540 == 0u) {
                                phi_1842_ = false;
                            } else {
                                let _e1544 = local.len;
                                local.len = (_e1544 - 1u);
                                let _e1547 = local.len;
                                if (_e1547 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1552 = local.first[(0u + _e1547)];
                                local.group = _e1552;
                                let _e1555 = local.len;
                                if (_e1555 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1560 = local.mask[(0u + _e1555)];
                                local.group_mask = _e1560;
                                phi_1842_ = true;
                            }
                            let _e1563 = phi_1842_;
                            phi_1843_ = _e1563;
                        } else {
                            phi_1843_ = true;
                        }
                        let _e1565 = phi_1843_;
                        if _e1565 {
                            let _e1567 = local.group_mask;
                            let _e1573 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1567)), 32u, (_e1567 == 0u)));
                            let _e1577 = local.group_mask;
                            let _e1591 = local.group_mask;
                            local.group_mask = (_e1591 & ~((1u << bitcast<u32>((_e1573 & 31u)))));
                            let _e1594 = local.group;
                            phi_1874_ = (_e1594 + countOneBits(((_e1577 & ~((4294967295u << bitcast<u32>((((_e1573 - 24u) ^ _e420) & 31u))))) & 255u)));
                        } else {
                            phi_1874_ = 4294967295u;
                        }
                        let _e1597 = phi_1874_;
                        let _e2373 = local_4;
                        phi_805_ = _e2373;
                        phi_808_ = _e1597;
                    } else {
                        phi_805_ = lt_bvh_Hit();
                        phi_808_ = u32();
                    }
                    let _e1599 = phi_805_;
                    let _e1601 = phi_808_;
                    continue;
                    continuing {
                        phi_804_ = _e1599;
                        phi_807_ = _e1601;
                        break if !(_e561);
                    }
                }
                let _e2377 = local_5;
                phi_1875_ = _e2377;
            }
            let _e1604 = phi_1875_;
            phi_1876_ = _e1604;
            phi_1877_ = _e218;
        } else {
            phi_1876_ = lt_bvh_Hit();
            phi_1877_ = true;
        }
        let _e1606 = phi_1876_;
        let _e1608 = phi_1877_;
        if _e1608 {
            phi_1881_ = _e148;
        } else {
            phi_1881_ = _e1606;
        }
        let _e1610 = phi_1881_;
        if (_e1610.triangle != 4294967295u) {
            let _e1616 = ((1f - _e1610.u) - _e1610.v);
            if (_e1610.triangle < _e70) {
            } else {
                return;
            }
            let _e1622 = triangles.member[(0u + _e1610.triangle)];
            let _e1647 = (((_e1622.v0_.x * _e1616) + (_e1622.v1_.x * _e1610.u)) + (_e1622.v2_.x * _e1610.v));
            let _e1648 = (((_e1622.v0_.y * _e1616) + (_e1622.v1_.y * _e1610.u)) + (_e1622.v2_.y * _e1610.v));
            let _e1649 = (((_e1622.v0_.z * _e1616) + (_e1622.v1_.z * _e1610.u)) + (_e1622.v2_.z * _e1610.v));
            let _e1652 = abs(_e1622.v0_.x);
            let _e1654 = abs(_e1622.v0_.y);
            let _e1656 = abs(_e1622.v0_.z);
            let _e1658 = abs(_e1622.v1_.x);
            let _e1660 = abs(_e1622.v1_.y);
            let _e1662 = abs(_e1622.v1_.z);
            if (_e1652 > _e1658) {
                phi_1946_ = _e1652;
            } else {
                phi_1946_ = _e1658;
            }
            let _e1665 = phi_1946_;
            if (_e1654 > _e1660) {
                phi_1951_ = _e1654;
            } else {
                phi_1951_ = _e1660;
            }
            let _e1668 = phi_1951_;
            if (_e1656 > _e1662) {
                phi_1956_ = _e1656;
            } else {
                phi_1956_ = _e1662;
            }
            let _e1671 = phi_1956_;
            let _e1673 = abs(_e1622.v2_.x);
            let _e1675 = abs(_e1622.v2_.y);
            let _e1677 = abs(_e1622.v2_.z);
            if (_e1665 > _e1673) {
                phi_1967_ = _e1665;
            } else {
                phi_1967_ = _e1673;
            }
            let _e1680 = phi_1967_;
            if (_e1668 > _e1675) {
                phi_1972_ = _e1668;
            } else {
                phi_1972_ = _e1675;
            }
            let _e1683 = phi_1972_;
            if (_e1671 > _e1677) {
                phi_1977_ = _e1671;
            } else {
                phi_1977_ = _e1677;
            }
            let _e1686 = phi_1977_;
            let _e1689 = (_e1622.v1_.x - _e1622.v0_.x);
            let _e1692 = (_e1622.v1_.y - _e1622.v0_.y);
            let _e1695 = (_e1622.v1_.z - _e1622.v0_.z);
            let _e1698 = (_e1622.v2_.x - _e1622.v0_.x);
            let _e1701 = (_e1622.v2_.y - _e1622.v0_.y);
            let _e1704 = (_e1622.v2_.z - _e1622.v0_.z);
            let _e1708 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1692), abs(_e1695));
            let _e1709 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1689), _e1708);
            let _e1710 = (_e1689 / _e1709);
            let _e1711 = (_e1692 / _e1709);
            let _e1712 = (_e1695 / _e1709);
            let _e1716 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1701), abs(_e1704));
            let _e1717 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1698), _e1716);
            let _e1718 = (_e1698 / _e1717);
            let _e1719 = (_e1701 / _e1717);
            let _e1720 = (_e1704 / _e1717);
            let _e1723 = ((_e1711 * _e1720) - (_e1719 * _e1712));
            let _e1726 = ((_e1712 * _e1718) - (_e1720 * _e1710));
            let _e1729 = ((_e1710 * _e1719) - (_e1718 * _e1711));
            let _e1731 = p.member.eye;
            let _e1744 = (1f / sqrt((((_e1723 * _e1723) + (_e1726 * _e1726)) + (_e1729 * _e1729))));
            let _e1745 = (_e1723 * _e1744);
            let _e1746 = (_e1726 * _e1744);
            let _e1747 = (_e1729 * _e1744);
            if ((((_e1745 * (_e1731.x - _e1647)) + (_e1746 * (_e1731.y - _e1648))) + (_e1747 * (_e1731.z - _e1649))) < 0f) {
                phi_2053_ = vec3<f32>(-(_e1745), -(_e1746), -(_e1747));
            } else {
                phi_2053_ = vec3<f32>(_e1745, _e1746, _e1747);
            }
            let _e1760 = phi_2053_;
            if (_e1610.triangle < _e70) {
            } else {
                return;
            }
            let _e1765 = triangles.member[(0u + _e1610.triangle)];
            let _e1767 = (_e1765.i0_ & 2147483647u);
            if (_e1767 < _e73) {
            } else {
                return;
            }
            let _e1773 = vertices.member[(0u + _e1767)];
            if (_e1765.i1_ < _e73) {
            } else {
                return;
            }
            let _e1777 = vertices.member[(0u + _e1765.i1_)];
            if (_e1765.i2_ < _e73) {
            } else {
                return;
            }
            let _e1781 = vertices.member[(0u + _e1765.i2_)];
            let _e1782 = array<abi_Vertex, 3>(_e1773, _e1777, _e1781);
            if (_e1782[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e1788 = materials.member[(0u + _e1782[0].material)];
            let _e1805 = (1f / 255f);
            let _e1824 = (1f / 255f);
            let _e1846 = (1f / 255f);
            let _e1859 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e1616, _e1610.u, _e1610.v));
            let _e1861 = ((_e1788.base_color.x * ((((f32((_e1782[0].color & 255u)) * _e1805) * _e1616) + ((f32((_e1782[1].color & 255u)) * _e1824) * _e1610.u)) + ((f32((_e1782[2].color & 255u)) * _e1846) * _e1610.v))) * _e1859.x);
            let _e1863 = ((_e1788.base_color.y * ((((f32(((_e1782[0].color >> bitcast<u32>(8i)) & 255u)) * _e1805) * _e1616) + ((f32(((_e1782[1].color >> bitcast<u32>(8i)) & 255u)) * _e1824) * _e1610.u)) + ((f32(((_e1782[2].color >> bitcast<u32>(8i)) & 255u)) * _e1846) * _e1610.v))) * _e1859.y);
            let _e1865 = ((_e1788.base_color.z * ((((f32(((_e1782[0].color >> bitcast<u32>(16i)) & 255u)) * _e1805) * _e1616) + ((f32(((_e1782[1].color >> bitcast<u32>(16i)) & 255u)) * _e1824) * _e1610.u)) + ((f32(((_e1782[2].color >> bitcast<u32>(16i)) & 255u)) * _e1846) * _e1610.v))) * _e1859.z);
            let _e1866 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1683, _e1686);
            let _e1867 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1680, _e1866);
            if ((_e1788.flags & 2u) == 0u) {
                phi_2174_ = 0u;
            } else {
                phi_2174_ = 1u;
            }
            let _e1872 = phi_2174_;
            if (_e1782[0].normal == 2147516416u) {
                phi_2377_ = _e1760;
            } else {
                let _e1885 = (f32((bitcast<i32>((_e1782[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1891 = (f32((bitcast<i32>(_e1782[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1895 = ((1f - abs(_e1885)) - abs(_e1891));
                if (_e1895 < 0f) {
                    phi_2201_ = -(_e1895);
                } else {
                    phi_2201_ = 0f;
                }
                let _e1899 = phi_2201_;
                if (_e1885 < 0f) {
                    phi_2208_ = (_e1885 + _e1899);
                } else {
                    phi_2208_ = (_e1885 - _e1899);
                }
                let _e1904 = phi_2208_;
                if (_e1891 < 0f) {
                    phi_2215_ = (_e1891 + _e1899);
                } else {
                    phi_2215_ = (_e1891 - _e1899);
                }
                let _e1909 = phi_2215_;
                let _e1916 = (1f / sqrt((((_e1904 * _e1904) + (_e1909 * _e1909)) + (_e1895 * _e1895))));
                let _e1932 = (f32((bitcast<i32>((_e1782[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1938 = (f32((bitcast<i32>(_e1782[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1942 = ((1f - abs(_e1932)) - abs(_e1938));
                if (_e1942 < 0f) {
                    phi_2250_ = -(_e1942);
                } else {
                    phi_2250_ = 0f;
                }
                let _e1946 = phi_2250_;
                if (_e1932 < 0f) {
                    phi_2257_ = (_e1932 + _e1946);
                } else {
                    phi_2257_ = (_e1932 - _e1946);
                }
                let _e1951 = phi_2257_;
                if (_e1938 < 0f) {
                    phi_2264_ = (_e1938 + _e1946);
                } else {
                    phi_2264_ = (_e1938 - _e1946);
                }
                let _e1956 = phi_2264_;
                let _e1963 = (1f / sqrt((((_e1951 * _e1951) + (_e1956 * _e1956)) + (_e1942 * _e1942))));
                let _e1982 = (f32((bitcast<i32>((_e1782[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1988 = (f32((bitcast<i32>(_e1782[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1992 = ((1f - abs(_e1982)) - abs(_e1988));
                if (_e1992 < 0f) {
                    phi_2302_ = -(_e1992);
                } else {
                    phi_2302_ = 0f;
                }
                let _e1996 = phi_2302_;
                if (_e1982 < 0f) {
                    phi_2309_ = (_e1982 + _e1996);
                } else {
                    phi_2309_ = (_e1982 - _e1996);
                }
                let _e2001 = phi_2309_;
                if (_e1988 < 0f) {
                    phi_2316_ = (_e1988 + _e1996);
                } else {
                    phi_2316_ = (_e1988 - _e1996);
                }
                let _e2006 = phi_2316_;
                let _e2013 = (1f / sqrt((((_e2001 * _e2001) + (_e2006 * _e2006)) + (_e1992 * _e1992))));
                let _e2024 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e1904 * _e1916) * _e1616) + ((_e1951 * _e1963) * _e1610.u)) + ((_e2001 * _e2013) * _e1610.v)), ((((_e1909 * _e1916) * _e1616) + ((_e1956 * _e1963) * _e1610.u)) + ((_e2006 * _e2013) * _e1610.v)), ((((_e1895 * _e1916) * _e1616) + ((_e1942 * _e1963) * _e1610.u)) + ((_e1992 * _e2013) * _e1610.v))));
                let _e2036 = sqrt((((_e2024.x * _e2024.x) + (_e2024.y * _e2024.y)) + (_e2024.z * _e2024.z)));
                if (_e2036 > 0f) {
                    let _e2039 = (_e2024.x / _e2036);
                    let _e2041 = (_e2024.y / _e2036);
                    let _e2043 = (_e2024.z / _e2036);
                    if ((((_e2039 * _e1760.x) + (_e2041 * _e1760.y)) + (_e2043 * _e1760.z)) < 0f) {
                        phi_2375_ = vec3<f32>(-(_e2039), -(_e2041), -(_e2043));
                    } else {
                        phi_2375_ = (_e2024 / vec3(_e2036));
                    }
                    let _e2060 = phi_2375_;
                    phi_2376_ = _e2060;
                } else {
                    phi_2376_ = _e1760;
                }
                let _e2062 = phi_2376_;
                phi_2377_ = _e2062;
            }
            let _e2064 = phi_2377_;
            if (_e1861 > 0f) {
                if (_e1861 < 1f) {
                    phi_2386_ = _e1861;
                } else {
                    phi_2386_ = 1f;
                }
                let _e2068 = phi_2386_;
                phi_2387_ = _e2068;
            } else {
                phi_2387_ = 0f;
            }
            let _e2070 = phi_2387_;
            if (_e1863 > 0f) {
                if (_e1863 < 1f) {
                    phi_2397_ = _e1863;
                } else {
                    phi_2397_ = 1f;
                }
                let _e2075 = phi_2397_;
                phi_2398_ = _e2075;
            } else {
                phi_2398_ = 0f;
            }
            let _e2077 = phi_2398_;
            if (_e1865 > 0f) {
                if (_e1865 < 1f) {
                    phi_2408_ = _e1865;
                } else {
                    phi_2408_ = 1f;
                }
                let _e2082 = phi_2408_;
                phi_2409_ = _e2082;
            } else {
                phi_2409_ = 0f;
            }
            let _e2084 = phi_2409_;
            let _e2087 = ((sqrt(_e2070) * 255f) + 0.5f);
            let _e2096 = ((sqrt(_e2077) * 255f) + 0.5f);
            let _e2108 = ((sqrt(_e2084) * 255f) + 0.5f);
            phi_2444_ = abi_Sample(vec3<f32>(_e1647, _e1648, _e1649), _e1867, _e1760, _e1872, _e2064, ((select(select(u32(_e2087), 0u, (_e2087 < bitcast<f32>(0u))), 4294967295u, (_e2087 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2096), 0u, (_e2096 < bitcast<f32>(0u))), 4294967295u, (_e2096 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2108), 0u, (_e2108 < bitcast<f32>(0u))), 4294967295u, (_e2108 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_2444_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2122 = phi_2444_;
        if (_e91.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e91.shift)] = _e2122;
        if (_e1610.triangle != 4294967295u) {
            let _e2131 = ((1f - _e1610.u) - _e1610.v);
            if (_e1610.triangle < _e70) {
            } else {
                return;
            }
            let _e2136 = triangles.member[(0u + _e1610.triangle)];
            let _e2138 = (_e2136.i0_ & 2147483647u);
            if (_e2138 < _e82) {
            } else {
                return;
            }
            let _e2144 = before.member[(0u + _e2138)];
            if (_e2136.i1_ < _e82) {
            } else {
                return;
            }
            let _e2148 = before.member[(0u + _e2136.i1_)];
            if (_e2136.i2_ < _e82) {
            } else {
                return;
            }
            let _e2152 = before.member[(0u + _e2136.i2_)];
            let _e2157 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2144.x, _e2144.y, _e2144.z));
            let _e2168 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2148.x, _e2148.y, _e2148.z));
            let _e2182 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2152.x, _e2152.y, _e2152.z));
            phi_2535_ = vec3<f32>((((_e2157.x * _e2131) + (_e2168.x * _e1610.u)) + (_e2182.x * _e1610.v)), (((_e2157.y * _e2131) + (_e2168.y * _e1610.u)) + (_e2182.y * _e1610.v)), (((_e2157.z * _e2131) + (_e2168.z * _e1610.u)) + (_e2182.z * _e1610.v)));
        } else {
            phi_2535_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e2194 = phi_2535_;
        if (_e91.shift < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e91.shift)] = vec4<f32>(_e2194.x, _e2194.y, _e2194.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
