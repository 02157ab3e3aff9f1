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

struct type_22 {
    member: array<vec4<f32>>,
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

struct lt_bvh_traverse_Stack {
    first: array<u32, 32>,
    mask: array<u32, 32>,
    len: u32,
    group: u32,
    group_mask: u32,
}

struct type_44 {
    member: abi_CameraParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_49 {
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
var<uniform> p: type_44;
@group(0) @binding(1) 
var<storage> nodes: type_49;
@group(0) @binding(2) 
var<storage> triangles: type_27;
@group(0) @binding(5) 
var<storage, read_write> samples: type_9;
@group(0) @binding(6) 
var<storage> before: type_22;
@group(0) @binding(7) 
var<storage, read_write> past: type_22;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_193_: lt_bvh_traverse_Tree;
    var phi_194_: bool;
    var phi_195_: lt_bvh_traverse_Tree;
    var phi_196_: bool;
    var phi_201_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_193_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_194_ = false;
        } else {
            phi_193_ = lt_bvh_traverse_Tree();
            phi_194_ = true;
        }
        let _e75 = phi_193_;
        let _e77 = phi_194_;
        phi_195_ = _e75;
        phi_196_ = _e77;
    } else {
        phi_195_ = lt_bvh_traverse_Tree();
        phi_196_ = true;
    }
    let _e79 = phi_195_;
    let _e81 = phi_196_;
    if _e81 {
        phi_201_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_201_ = _e79;
    }
    let _e86 = phi_201_;
    return lt_bvh_traverse_Tree(_e86.root, _e86.first_primitive);
}

fn _lt_bvh_ray_Ray_new(param_3: vec3<f32>, param_4: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_3, 0f, param_4, 300000000000000000000000000000000000000f);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_220_: bool;
    var phi_224_: f32;

    if (param_5 != param_5) {
        phi_220_ = true;
    } else {
        let _e65 = (param_6 >= param_5);
        if _e65 {
        }
        phi_220_ = _e65;
    }
    let _e67 = phi_220_;
    if _e67 {
        phi_224_ = param_6;
    } else {
        phi_224_ = param_5;
    }
    let _e69 = phi_224_;
    return _e69;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_7: f32, param_8: f32) -> f32 {
    var phi_236_: bool;
    var phi_240_: f32;

    if (param_7 != param_7) {
        phi_236_ = true;
    } else {
        let _e65 = (param_8 <= param_7);
        if _e65 {
        }
        phi_236_ = _e65;
    }
    let _e67 = phi_236_;
    if _e67 {
        phi_240_ = param_8;
    } else {
        phi_240_ = param_7;
    }
    let _e69 = phi_240_;
    return _e69;
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
    var phi_1224_: vec3<f32>;
    var phi_1225_: vec3<f32>;
    var phi_1258_: vec3<f32>;
    var phi_1259_: vec3<f32>;
    var phi_1279_: bool;
    var phi_1280_: bool;
    var phi_1284_: f32;
    var phi_1285_: f32;
    var phi_1286_: f32;
    var phi_1287_: f32;
    var phi_1295_: f32;
    var phi_1305_: bool;
    var phi_1306_: bool;
    var phi_1310_: f32;
    var phi_1311_: f32;
    var phi_1312_: f32;
    var phi_1313_: f32;
    var phi_1321_: f32;
    var phi_1331_: bool;
    var phi_1332_: bool;
    var phi_1336_: f32;
    var phi_1337_: f32;
    var phi_1338_: f32;
    var phi_1339_: f32;
    var phi_1347_: f32;
    var phi_1362_: f32;
    var phi_1363_: bool;
    var phi_1364_: f32;
    var phi_1365_: bool;
    var phi_1366_: f32;
    var phi_1367_: bool;
    var phi_1385_: f32;
    var phi_1386_: bool;
    var phi_1387_: bool;
    var phi_1388_: f32;
    var phi_1389_: bool;
    var phi_1390_: bool;
    var phi_1394_: bool;
    var phi_1395_: f32;
    var phi_1396_: bool;
    var phi_1432_: f32;
    var phi_1441_: f32;
    var phi_1450_: f32;
    var phi_1459_: f32;
    var phi_1466_: f32;
    var phi_1473_: f32;
    var phi_1486_: f32;
    var phi_1495_: f32;
    var phi_1504_: f32;
    var phi_1513_: f32;
    var phi_1520_: f32;
    var phi_1527_: f32;
    var phi_1550_: f32;
    var phi_1555_: f32;
    var phi_1560_: f32;
    var phi_1568_: f32;
    var phi_1573_: f32;
    var phi_1578_: f32;
    var phi_1590_: f32;
    var phi_1595_: f32;
    var phi_1600_: f32;
    var phi_1605_: f32;
    var phi_1610_: lt_bvh_triangle_Intersection;
    var phi_1611_: bool;
    var phi_1612_: lt_bvh_triangle_Intersection;
    var phi_1613_: bool;
    var phi_1617_: lt_bvh_triangle_Intersection;
    var phi_1618_: bool;
    var phi_1619_: lt_bvh_triangle_Intersection;
    var phi_1620_: bool;
    var phi_1621_: bool;
    var phi_1625_: bool;
    var phi_1629_: lt_bvh_triangle_Intersection;
    var phi_1668_: bool;
    var phi_1669_: bool;
    var phi_1670_: bool;
    var phi_1671_: bool;
    var phi_1672_: bool;
    var phi_1673_: bool;
    var phi_1677_: bool;
    var phi_1678_: bool;
    var phi_1692_: bool;
    var phi_1700_: lt_bvh_Hit;
    var phi_1701_: lt_bvh_Hit;
    var phi_1702_: lt_bvh_Hit;
    var phi_1703_: lt_bvh_Hit;
    var phi_1142_: lt_bvh_Hit;
    var phi_1145_: u32;
    var phi_1704_: bool;
    var phi_1743_: bool;
    var phi_1744_: bool;
    var phi_1775_: u32;
    var phi_805_: lt_bvh_Hit;
    var phi_808_: u32;
    var phi_1776_: lt_bvh_Hit;
    var phi_1777_: lt_bvh_Hit;
    var phi_1778_: bool;
    var phi_1782_: lt_bvh_Hit;
    var phi_1847_: f32;
    var phi_1852_: f32;
    var phi_1857_: f32;
    var phi_1868_: f32;
    var phi_1873_: f32;
    var phi_1878_: f32;
    var phi_1954_: vec3<f32>;
    var phi_2075_: u32;
    var phi_2102_: f32;
    var phi_2109_: f32;
    var phi_2116_: f32;
    var phi_2151_: f32;
    var phi_2158_: f32;
    var phi_2165_: f32;
    var phi_2203_: f32;
    var phi_2210_: f32;
    var phi_2217_: f32;
    var phi_2276_: vec3<f32>;
    var phi_2277_: vec3<f32>;
    var phi_2278_: vec3<f32>;
    var phi_2287_: f32;
    var phi_2288_: f32;
    var phi_2298_: f32;
    var phi_2299_: f32;
    var phi_2309_: f32;
    var phi_2310_: f32;
    var phi_2345_: abi_Sample;
    var phi_2436_: vec3<f32>;
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
    if (bitcast<i32>(_e91.root) != 0i) {
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
                phi_1776_ = lt_bvh_Hit();
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
                let _e412 = (1f / _e403.z);
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
                            let _e639 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e628.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e639.unnamed.root, _e628.w), _e639.unnamed_1);
                            let _e651 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e645.unnamed, lt_bvh_traverse_Tree(_e628.x, _e645.unnamed_1.first_primitive));
                            phi_892_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e651.unnamed, lt_bvh_traverse_Tree(_e651.unnamed_1.root, _e628.y));
                        } else {
                            let _e667 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e628.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e667.unnamed.root, _e628.y), _e667.unnamed_1);
                            let _e679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e673.unnamed, lt_bvh_traverse_Tree(_e628.z, _e673.unnamed_1.first_primitive));
                            phi_892_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e679.unnamed, lt_bvh_traverse_Tree(_e679.unnamed_1.root, _e628.w));
                        }
                        let _e687 = phi_892_;
                        let _e697 = nodes.member[(0u + _e563)].y;
                        if (_e312 < 0f) {
                            let _e708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e697.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e708.unnamed.root, _e697.w), _e708.unnamed_1);
                            let _e720 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e714.unnamed, lt_bvh_traverse_Tree(_e697.x, _e714.unnamed_1.first_primitive));
                            phi_919_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e720.unnamed, lt_bvh_traverse_Tree(_e720.unnamed_1.root, _e697.y));
                        } else {
                            let _e736 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e697.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e742 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e736.unnamed.root, _e697.y), _e736.unnamed_1);
                            let _e748 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e742.unnamed, lt_bvh_traverse_Tree(_e697.z, _e742.unnamed_1.first_primitive));
                            phi_919_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e748.unnamed, lt_bvh_traverse_Tree(_e748.unnamed_1.root, _e697.w));
                        }
                        let _e756 = phi_919_;
                        let _e766 = nodes.member[(0u + _e563)].z;
                        if (_e324 < 0f) {
                            let _e777 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e766.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e783 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e777.unnamed.root, _e766.w), _e777.unnamed_1);
                            let _e789 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e783.unnamed, lt_bvh_traverse_Tree(_e766.x, _e783.unnamed_1.first_primitive));
                            phi_946_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e789.unnamed, lt_bvh_traverse_Tree(_e789.unnamed_1.root, _e766.y));
                        } else {
                            let _e805 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e766.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e811 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e805.unnamed.root, _e766.y), _e805.unnamed_1);
                            let _e817 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e811.unnamed, lt_bvh_traverse_Tree(_e766.z, _e811.unnamed_1.first_primitive));
                            phi_946_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e817.unnamed, lt_bvh_traverse_Tree(_e817.unnamed_1.root, _e766.w));
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
                                    phi_969_ = _e687.unnamed.root;
                                } else {
                                    phi_969_ = _e687.unnamed.first_primitive;
                                }
                                let _e844 = phi_969_;
                                if (_e840 == 0u) {
                                    phi_979_ = _e756.unnamed.root;
                                } else {
                                    phi_979_ = _e756.unnamed.first_primitive;
                                }
                                let _e853 = phi_979_;
                                if (_e840 == 0u) {
                                    phi_989_ = _e825.unnamed.root;
                                } else {
                                    phi_989_ = _e825.unnamed.first_primitive;
                                }
                                let _e862 = phi_989_;
                                let _e875 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e844 >> bitcast<u32>(((_e841 * 8u) & 31u))) & 255u)) * _e597) + (_e618 - _e361)), ((f32(((_e853 >> bitcast<u32>(((_e841 * 8u) & 31u))) & 255u)) * _e598) + (_e619 - _e362)));
                                let _e876 = core_intrinsics_maximum_number_nsz_f32_(_e875, ((f32(((_e862 >> bitcast<u32>(((_e841 * 8u) & 31u))) & 255u)) * _e599) + (_e620 - _e363)));
                                if (_e840 == 0u) {
                                    phi_1007_ = _e687.unnamed_1.root;
                                } else {
                                    phi_1007_ = _e687.unnamed_1.first_primitive;
                                }
                                let _e879 = phi_1007_;
                                if (_e840 == 0u) {
                                    phi_1017_ = _e756.unnamed_1.root;
                                } else {
                                    phi_1017_ = _e756.unnamed_1.first_primitive;
                                }
                                let _e888 = phi_1017_;
                                if (_e840 == 0u) {
                                    phi_1027_ = _e825.unnamed_1.root;
                                } else {
                                    phi_1027_ = _e825.unnamed_1.first_primitive;
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
                                phi_1704_ = false;
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
                                let _e1052 = triangles.member[(0u + _e1015)].v1_;
                                let _e1055 = (_e1052.x - _e146.origin.x);
                                let _e1058 = (_e1052.y - _e146.origin.y);
                                let _e1061 = (_e1052.z - _e146.origin.z);
                                if (_e388 == 0u) {
                                    phi_1225_ = vec3<f32>(_e1058, _e1061, _e1055);
                                } else {
                                    if (_e388 == 1u) {
                                        phi_1224_ = vec3<f32>(_e1061, _e1055, _e1058);
                                    } else {
                                        phi_1224_ = (_e1052 - _e146.origin);
                                    }
                                    let _e1068 = phi_1224_;
                                    phi_1225_ = _e1068;
                                }
                                let _e1070 = phi_1225_;
                                let _e1074 = (_e1070.x - (_e407 * _e1070.z));
                                let _e1078 = (_e1070.y - (_e410 * _e1070.z));
                                let _e1082 = triangles.member[(0u + _e1015)].v2_;
                                let _e1085 = (_e1082.x - _e146.origin.x);
                                let _e1088 = (_e1082.y - _e146.origin.y);
                                let _e1091 = (_e1082.z - _e146.origin.z);
                                if (_e388 == 0u) {
                                    phi_1259_ = vec3<f32>(_e1088, _e1091, _e1085);
                                } else {
                                    if (_e388 == 1u) {
                                        phi_1258_ = vec3<f32>(_e1091, _e1085, _e1088);
                                    } else {
                                        phi_1258_ = (_e1082 - _e146.origin);
                                    }
                                    let _e1098 = phi_1258_;
                                    phi_1259_ = _e1098;
                                }
                                let _e1100 = phi_1259_;
                                let _e1104 = (_e1100.x - (_e407 * _e1100.z));
                                let _e1108 = (_e1100.y - (_e410 * _e1100.z));
                                if (_e1074 < _e1104) {
                                    phi_1280_ = true;
                                } else {
                                    if (_e1074 == _e1104) {
                                        phi_1279_ = (_e1078 < _e1108);
                                    } else {
                                        phi_1279_ = false;
                                    }
                                    let _e1115 = phi_1279_;
                                    phi_1280_ = _e1115;
                                }
                                let _e1117 = phi_1280_;
                                if _e1117 {
                                    phi_1284_ = _e1108;
                                    phi_1285_ = _e1104;
                                    phi_1286_ = _e1078;
                                    phi_1287_ = _e1074;
                                } else {
                                    phi_1284_ = _e1078;
                                    phi_1285_ = _e1074;
                                    phi_1286_ = _e1108;
                                    phi_1287_ = _e1104;
                                }
                                let _e1119 = phi_1284_;
                                let _e1121 = phi_1285_;
                                let _e1123 = phi_1286_;
                                let _e1125 = phi_1287_;
                                let _e1128 = ((_e1125 * _e1119) - (_e1123 * _e1121));
                                if _e1117 {
                                    phi_1295_ = -(_e1128);
                                } else {
                                    phi_1295_ = _e1128;
                                }
                                let _e1131 = phi_1295_;
                                if (_e1104 < _e1044) {
                                    phi_1306_ = true;
                                } else {
                                    if (_e1104 == _e1044) {
                                        phi_1305_ = (_e1108 < _e1048);
                                    } else {
                                        phi_1305_ = false;
                                    }
                                    let _e1136 = phi_1305_;
                                    phi_1306_ = _e1136;
                                }
                                let _e1138 = phi_1306_;
                                if _e1138 {
                                    phi_1310_ = _e1048;
                                    phi_1311_ = _e1044;
                                    phi_1312_ = _e1108;
                                    phi_1313_ = _e1104;
                                } else {
                                    phi_1310_ = _e1108;
                                    phi_1311_ = _e1104;
                                    phi_1312_ = _e1048;
                                    phi_1313_ = _e1044;
                                }
                                let _e1140 = phi_1310_;
                                let _e1142 = phi_1311_;
                                let _e1144 = phi_1312_;
                                let _e1146 = phi_1313_;
                                let _e1149 = ((_e1146 * _e1140) - (_e1144 * _e1142));
                                if _e1138 {
                                    phi_1321_ = -(_e1149);
                                } else {
                                    phi_1321_ = _e1149;
                                }
                                let _e1152 = phi_1321_;
                                if (_e1044 < _e1074) {
                                    phi_1332_ = true;
                                } else {
                                    if (_e1044 == _e1074) {
                                        phi_1331_ = (_e1048 < _e1078);
                                    } else {
                                        phi_1331_ = false;
                                    }
                                    let _e1157 = phi_1331_;
                                    phi_1332_ = _e1157;
                                }
                                let _e1159 = phi_1332_;
                                if _e1159 {
                                    phi_1336_ = _e1078;
                                    phi_1337_ = _e1074;
                                    phi_1338_ = _e1048;
                                    phi_1339_ = _e1044;
                                } else {
                                    phi_1336_ = _e1048;
                                    phi_1337_ = _e1044;
                                    phi_1338_ = _e1078;
                                    phi_1339_ = _e1074;
                                }
                                let _e1161 = phi_1336_;
                                let _e1163 = phi_1337_;
                                let _e1165 = phi_1338_;
                                let _e1167 = phi_1339_;
                                let _e1170 = ((_e1167 * _e1161) - (_e1165 * _e1163));
                                if _e1159 {
                                    phi_1347_ = -(_e1170);
                                } else {
                                    phi_1347_ = _e1170;
                                }
                                let _e1173 = phi_1347_;
                                if (_e1131 >= 0f) {
                                    if (_e1152 >= 0f) {
                                        if (_e1173 >= 0f) {
                                            phi_1362_ = ((_e1131 + _e1152) + _e1173);
                                            phi_1363_ = false;
                                        } else {
                                            phi_1362_ = f32();
                                            phi_1363_ = true;
                                        }
                                        let _e1180 = phi_1362_;
                                        let _e1182 = phi_1363_;
                                        phi_1364_ = _e1180;
                                        phi_1365_ = _e1182;
                                    } else {
                                        phi_1364_ = f32();
                                        phi_1365_ = true;
                                    }
                                    let _e1184 = phi_1364_;
                                    let _e1186 = phi_1365_;
                                    phi_1366_ = _e1184;
                                    phi_1367_ = _e1186;
                                } else {
                                    phi_1366_ = f32();
                                    phi_1367_ = true;
                                }
                                let _e1188 = phi_1366_;
                                let _e1190 = phi_1367_;
                                if _e1190 {
                                    if (_e1131 <= 0f) {
                                        if (_e1152 <= 0f) {
                                            let _e1193 = (_e1173 <= 0f);
                                            if _e1193 {
                                            }
                                            phi_1385_ = ((_e1131 + _e1152) + _e1173);
                                            phi_1386_ = false;
                                            phi_1387_ = _e1193;
                                        } else {
                                            phi_1385_ = f32();
                                            phi_1386_ = true;
                                            phi_1387_ = false;
                                        }
                                        let _e1197 = phi_1385_;
                                        let _e1199 = phi_1386_;
                                        let _e1201 = phi_1387_;
                                        phi_1388_ = _e1197;
                                        phi_1389_ = _e1199;
                                        phi_1390_ = _e1201;
                                    } else {
                                        phi_1388_ = f32();
                                        phi_1389_ = true;
                                        phi_1390_ = false;
                                    }
                                    let _e1203 = phi_1388_;
                                    let _e1205 = phi_1389_;
                                    let _e1207 = phi_1390_;
                                    if _e1205 {
                                        phi_1394_ = false;
                                    } else {
                                        phi_1394_ = _e1207;
                                    }
                                    let _e1209 = phi_1394_;
                                    phi_1395_ = _e1203;
                                    phi_1396_ = _e1209;
                                } else {
                                    phi_1395_ = _e1188;
                                    phi_1396_ = true;
                                }
                                let _e1211 = phi_1395_;
                                let _e1213 = phi_1396_;
                                if _e1213 {
                                    let _e1214 = (_e1211 == 0f);
                                    if _e1214 {
                                        phi_1617_ = lt_bvh_triangle_Intersection();
                                        phi_1618_ = false;
                                    } else {
                                        let _e1220 = ((((_e1131 * (_e412 * _e1040.z)) + (_e1152 * (_e412 * _e1070.z))) + (_e1173 * (_e412 * _e1100.z))) / _e1211);
                                        if (_e1220 > _e146.tmin) {
                                            if (_e1220 < _e146.tmax) {
                                                let _e1226 = triangles.member[(0u + _e1015)].v0_;
                                                let _e1228 = triangles.member[(0u + _e1015)].v1_;
                                                if (_e1226.x < _e1228.x) {
                                                    phi_1432_ = _e1226.x;
                                                } else {
                                                    phi_1432_ = _e1228.x;
                                                }
                                                let _e1235 = phi_1432_;
                                                if (_e1226.y < _e1228.y) {
                                                    phi_1441_ = _e1226.y;
                                                } else {
                                                    phi_1441_ = _e1228.y;
                                                }
                                                let _e1242 = phi_1441_;
                                                if (_e1226.z < _e1228.z) {
                                                    phi_1450_ = _e1226.z;
                                                } else {
                                                    phi_1450_ = _e1228.z;
                                                }
                                                let _e1249 = phi_1450_;
                                                let _e1251 = triangles.member[(0u + _e1015)].v2_;
                                                if (_e1235 < _e1251.x) {
                                                    phi_1459_ = _e1235;
                                                } else {
                                                    phi_1459_ = _e1251.x;
                                                }
                                                let _e1256 = phi_1459_;
                                                if (_e1242 < _e1251.y) {
                                                    phi_1466_ = _e1242;
                                                } else {
                                                    phi_1466_ = _e1251.y;
                                                }
                                                let _e1261 = phi_1466_;
                                                if (_e1249 < _e1251.z) {
                                                    phi_1473_ = _e1249;
                                                } else {
                                                    phi_1473_ = _e1251.z;
                                                }
                                                let _e1266 = phi_1473_;
                                                let _e1268 = triangles.member[(0u + _e1015)].v0_;
                                                let _e1270 = triangles.member[(0u + _e1015)].v1_;
                                                if (_e1268.x > _e1270.x) {
                                                    phi_1486_ = _e1268.x;
                                                } else {
                                                    phi_1486_ = _e1270.x;
                                                }
                                                let _e1277 = phi_1486_;
                                                if (_e1268.y > _e1270.y) {
                                                    phi_1495_ = _e1268.y;
                                                } else {
                                                    phi_1495_ = _e1270.y;
                                                }
                                                let _e1284 = phi_1495_;
                                                if (_e1268.z > _e1270.z) {
                                                    phi_1504_ = _e1268.z;
                                                } else {
                                                    phi_1504_ = _e1270.z;
                                                }
                                                let _e1291 = phi_1504_;
                                                let _e1293 = triangles.member[(0u + _e1015)].v2_;
                                                if (_e1277 > _e1293.x) {
                                                    phi_1513_ = _e1277;
                                                } else {
                                                    phi_1513_ = _e1293.x;
                                                }
                                                let _e1298 = phi_1513_;
                                                if (_e1284 > _e1293.y) {
                                                    phi_1520_ = _e1284;
                                                } else {
                                                    phi_1520_ = _e1293.y;
                                                }
                                                let _e1303 = phi_1520_;
                                                if (_e1291 > _e1293.z) {
                                                    phi_1527_ = _e1291;
                                                } else {
                                                    phi_1527_ = _e1293.z;
                                                }
                                                let _e1308 = phi_1527_;
                                                let _e1315 = ((_e1256 - _e146.origin.x) * _e300);
                                                let _e1316 = ((_e1261 - _e146.origin.y) * _e312);
                                                let _e1317 = ((_e1266 - _e146.origin.z) * _e324);
                                                let _e1324 = ((_e1298 - _e146.origin.x) * _e300);
                                                let _e1325 = ((_e1303 - _e146.origin.y) * _e312);
                                                let _e1326 = ((_e1308 - _e146.origin.z) * _e324);
                                                if (_e1315 < _e1324) {
                                                    phi_1550_ = _e1315;
                                                } else {
                                                    phi_1550_ = _e1324;
                                                }
                                                let _e1329 = phi_1550_;
                                                if (_e1316 < _e1325) {
                                                    phi_1555_ = _e1316;
                                                } else {
                                                    phi_1555_ = _e1325;
                                                }
                                                let _e1332 = phi_1555_;
                                                if (_e1317 < _e1326) {
                                                    phi_1560_ = _e1317;
                                                } else {
                                                    phi_1560_ = _e1326;
                                                }
                                                let _e1335 = phi_1560_;
                                                if (_e1315 > _e1324) {
                                                    phi_1568_ = _e1315;
                                                } else {
                                                    phi_1568_ = _e1324;
                                                }
                                                let _e1341 = phi_1568_;
                                                if (_e1316 > _e1325) {
                                                    phi_1573_ = _e1316;
                                                } else {
                                                    phi_1573_ = _e1325;
                                                }
                                                let _e1344 = phi_1573_;
                                                if (_e1317 > _e1326) {
                                                    phi_1578_ = _e1317;
                                                } else {
                                                    phi_1578_ = _e1326;
                                                }
                                                let _e1347 = phi_1578_;
                                                let _e1351 = core_intrinsics_maximum_number_nsz_f32_((_e1329 - _e368), (_e1332 - _e369));
                                                let _e1352 = core_intrinsics_maximum_number_nsz_f32_(_e1351, (_e1335 - _e370));
                                                let _e1353 = core_intrinsics_minimum_number_nsz_f32_((_e1341 + _e368), (_e1344 + _e369));
                                                let _e1354 = core_intrinsics_minimum_number_nsz_f32_(_e1353, (_e1347 + _e370));
                                                if (_e1352 > -300000000000000000000000000000000000000f) {
                                                    phi_1590_ = _e1352;
                                                } else {
                                                    phi_1590_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1357 = phi_1590_;
                                                if (_e1354 < 300000000000000000000000000000000000000f) {
                                                    phi_1595_ = _e1354;
                                                } else {
                                                    phi_1595_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1360 = phi_1595_;
                                                if (_e1220 < _e1357) {
                                                    phi_1600_ = _e1357;
                                                } else {
                                                    phi_1600_ = _e1220;
                                                }
                                                let _e1363 = phi_1600_;
                                                if (_e1363 > _e1360) {
                                                    phi_1605_ = _e1360;
                                                } else {
                                                    phi_1605_ = _e1363;
                                                }
                                                let _e1366 = phi_1605_;
                                                phi_1610_ = lt_bvh_triangle_Intersection(_e1366, (_e1152 / _e1211), (_e1173 / _e1211), (_e1357 <= _e1360));
                                                phi_1611_ = false;
                                            } else {
                                                phi_1610_ = lt_bvh_triangle_Intersection();
                                                phi_1611_ = true;
                                            }
                                            let _e1372 = phi_1610_;
                                            let _e1374 = phi_1611_;
                                            phi_1612_ = _e1372;
                                            phi_1613_ = _e1374;
                                        } else {
                                            phi_1612_ = lt_bvh_triangle_Intersection();
                                            phi_1613_ = true;
                                        }
                                        let _e1376 = phi_1612_;
                                        let _e1378 = phi_1613_;
                                        if _e1378 {
                                        }
                                        phi_1617_ = _e1376;
                                        phi_1618_ = _e1378;
                                    }
                                    let _e1380 = phi_1617_;
                                    let _e1382 = phi_1618_;
                                    phi_1619_ = _e1380;
                                    phi_1620_ = _e1214;
                                    phi_1621_ = _e1382;
                                } else {
                                    phi_1619_ = lt_bvh_triangle_Intersection();
                                    phi_1620_ = true;
                                    phi_1621_ = false;
                                }
                                let _e1384 = phi_1619_;
                                let _e1386 = phi_1620_;
                                let _e1388 = phi_1621_;
                                if _e1386 {
                                    phi_1625_ = true;
                                } else {
                                    phi_1625_ = _e1388;
                                }
                                let _e1390 = phi_1625_;
                                if _e1390 {
                                    phi_1629_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1629_ = _e1384;
                                }
                                let _e1392 = phi_1629_;
                                if _e1392.is_hit {
                                    if (_e1392.t > _e146.tmin) {
                                        if (_e1392.t < _e1004.t) {
                                            phi_1678_ = true;
                                        } else {
                                            if (_e1392.t == _e1004.t) {
                                                if (_e1004.triangle != 4294967295u) {
                                                    if (_e1015 < _e1004.triangle) {
                                                        phi_1669_ = true;
                                                    } else {
                                                        if (_e1015 == _e1004.triangle) {
                                                            phi_1668_ = (4294967295u < _e1004.instance);
                                                        } else {
                                                            phi_1668_ = false;
                                                        }
                                                        let _e1411 = phi_1668_;
                                                        phi_1669_ = _e1411;
                                                    }
                                                    let _e1413 = phi_1669_;
                                                    phi_1670_ = _e1413;
                                                    phi_1671_ = false;
                                                } else {
                                                    phi_1670_ = bool();
                                                    phi_1671_ = true;
                                                }
                                                let _e1415 = phi_1670_;
                                                let _e1417 = phi_1671_;
                                                phi_1672_ = _e1415;
                                                phi_1673_ = _e1417;
                                            } else {
                                                phi_1672_ = bool();
                                                phi_1673_ = true;
                                            }
                                            let _e1419 = phi_1672_;
                                            let _e1421 = phi_1673_;
                                            if _e1421 {
                                                phi_1677_ = false;
                                            } else {
                                                phi_1677_ = _e1419;
                                            }
                                            let _e1423 = phi_1677_;
                                            phi_1678_ = _e1423;
                                        }
                                        let _e1425 = phi_1678_;
                                        if _e1425 {
                                            let _e1427 = triangles.member[(0u + _e1015)].i0_;
                                            if ((_e1427 & 2147483648u) == 0u) {
                                                phi_1692_ = true;
                                            } else {
                                                if true {
                                                }
                                                phi_1692_ = true;
                                            }
                                            let _e1431 = phi_1692_;
                                            if _e1431 {
                                                phi_1700_ = lt_bvh_Hit(_e1392.t, _e1392.u, _e1392.v, _e1015, 4294967295u);
                                            } else {
                                                phi_1700_ = _e1004;
                                            }
                                            let _e1437 = phi_1700_;
                                            phi_1701_ = _e1437;
                                        } else {
                                            phi_1701_ = _e1004;
                                        }
                                        let _e1439 = phi_1701_;
                                        phi_1702_ = _e1439;
                                    } else {
                                        phi_1702_ = _e1004;
                                    }
                                    let _e1441 = phi_1702_;
                                    phi_1703_ = _e1441;
                                } else {
                                    phi_1703_ = _e1004;
                                }
                                let _e1443 = phi_1703_;
                                phi_1142_ = _e1443;
                                phi_1145_ = (_e1006 & (_e1006 - 1u));
                                phi_1704_ = true;
                            }
                            let _e1445 = phi_1142_;
                            let _e1447 = phi_1145_;
                            let _e1449 = phi_1704_;
                            continue;
                            continuing {
                                phi_1141_ = _e1445;
                                phi_1144_ = _e1447;
                                break if !(_e1449);
                            }
                        }
                        let _e1452 = local.group_mask;
                        if ((_e1452 & 4278190080u) == 0u) {
                            let _e1456 = local.len;
                            if (_e1456 == 0u) {
                                phi_1743_ = false;
                            } else {
                                let _e1460 = local.len;
                                local.len = (_e1460 - 1u);
                                let _e1463 = local.len;
                                if (_e1463 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1468 = local.first[(0u + _e1463)];
                                local.group = _e1468;
                                let _e1471 = local.len;
                                if (_e1471 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1476 = local.mask[(0u + _e1471)];
                                local.group_mask = _e1476;
                                phi_1743_ = true;
                            }
                            let _e1479 = phi_1743_;
                            phi_1744_ = _e1479;
                        } else {
                            phi_1744_ = true;
                        }
                        let _e1481 = phi_1744_;
                        if _e1481 {
                            let _e1483 = local.group_mask;
                            let _e1489 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1483)), 32u, (_e1483 == 0u)));
                            let _e1493 = local.group_mask;
                            let _e1507 = local.group_mask;
                            local.group_mask = (_e1507 & ~((1u << bitcast<u32>((_e1489 & 31u)))));
                            let _e1510 = local.group;
                            phi_1775_ = (_e1510 + countOneBits(((_e1493 & ~((4294967295u << bitcast<u32>((((_e1489 - 24u) ^ _e423) & 31u))))) & 255u)));
                        } else {
                            phi_1775_ = 4294967295u;
                        }
                        let _e1513 = phi_1775_;
                        let _e2283 = local_4;
                        phi_805_ = _e2283;
                        phi_808_ = _e1513;
                    } else {
                        phi_805_ = lt_bvh_Hit();
                        phi_808_ = u32();
                    }
                    let _e1515 = phi_805_;
                    let _e1517 = phi_808_;
                    continue;
                    continuing {
                        phi_804_ = _e1515;
                        phi_807_ = _e1517;
                        break if !(_e564);
                    }
                }
                let _e2287 = local_5;
                phi_1776_ = _e2287;
            }
            let _e1520 = phi_1776_;
            phi_1777_ = _e1520;
            phi_1778_ = _e218;
        } else {
            phi_1777_ = lt_bvh_Hit();
            phi_1778_ = true;
        }
        let _e1522 = phi_1777_;
        let _e1524 = phi_1778_;
        if _e1524 {
            phi_1782_ = _e148;
        } else {
            phi_1782_ = _e1522;
        }
        let _e1526 = phi_1782_;
        if (_e1526.triangle != 4294967295u) {
            let _e1532 = ((1f - _e1526.u) - _e1526.v);
            if (_e1526.triangle < _e70) {
            } else {
                return;
            }
            let _e1538 = triangles.member[(0u + _e1526.triangle)];
            let _e1563 = (((_e1538.v0_.x * _e1532) + (_e1538.v1_.x * _e1526.u)) + (_e1538.v2_.x * _e1526.v));
            let _e1564 = (((_e1538.v0_.y * _e1532) + (_e1538.v1_.y * _e1526.u)) + (_e1538.v2_.y * _e1526.v));
            let _e1565 = (((_e1538.v0_.z * _e1532) + (_e1538.v1_.z * _e1526.u)) + (_e1538.v2_.z * _e1526.v));
            let _e1568 = abs(_e1538.v0_.x);
            let _e1570 = abs(_e1538.v0_.y);
            let _e1572 = abs(_e1538.v0_.z);
            let _e1574 = abs(_e1538.v1_.x);
            let _e1576 = abs(_e1538.v1_.y);
            let _e1578 = abs(_e1538.v1_.z);
            if (_e1568 > _e1574) {
                phi_1847_ = _e1568;
            } else {
                phi_1847_ = _e1574;
            }
            let _e1581 = phi_1847_;
            if (_e1570 > _e1576) {
                phi_1852_ = _e1570;
            } else {
                phi_1852_ = _e1576;
            }
            let _e1584 = phi_1852_;
            if (_e1572 > _e1578) {
                phi_1857_ = _e1572;
            } else {
                phi_1857_ = _e1578;
            }
            let _e1587 = phi_1857_;
            let _e1589 = abs(_e1538.v2_.x);
            let _e1591 = abs(_e1538.v2_.y);
            let _e1593 = abs(_e1538.v2_.z);
            if (_e1581 > _e1589) {
                phi_1868_ = _e1581;
            } else {
                phi_1868_ = _e1589;
            }
            let _e1596 = phi_1868_;
            if (_e1584 > _e1591) {
                phi_1873_ = _e1584;
            } else {
                phi_1873_ = _e1591;
            }
            let _e1599 = phi_1873_;
            if (_e1587 > _e1593) {
                phi_1878_ = _e1587;
            } else {
                phi_1878_ = _e1593;
            }
            let _e1602 = phi_1878_;
            let _e1605 = (_e1538.v1_.x - _e1538.v0_.x);
            let _e1608 = (_e1538.v1_.y - _e1538.v0_.y);
            let _e1611 = (_e1538.v1_.z - _e1538.v0_.z);
            let _e1614 = (_e1538.v2_.x - _e1538.v0_.x);
            let _e1617 = (_e1538.v2_.y - _e1538.v0_.y);
            let _e1620 = (_e1538.v2_.z - _e1538.v0_.z);
            let _e1624 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1608), abs(_e1611));
            let _e1625 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1605), _e1624);
            let _e1626 = (_e1605 / _e1625);
            let _e1627 = (_e1608 / _e1625);
            let _e1628 = (_e1611 / _e1625);
            let _e1632 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1617), abs(_e1620));
            let _e1633 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1614), _e1632);
            let _e1634 = (_e1614 / _e1633);
            let _e1635 = (_e1617 / _e1633);
            let _e1636 = (_e1620 / _e1633);
            let _e1639 = ((_e1627 * _e1636) - (_e1635 * _e1628));
            let _e1642 = ((_e1628 * _e1634) - (_e1636 * _e1626));
            let _e1645 = ((_e1626 * _e1635) - (_e1634 * _e1627));
            let _e1647 = p.member.eye;
            let _e1660 = (1f / sqrt((((_e1639 * _e1639) + (_e1642 * _e1642)) + (_e1645 * _e1645))));
            let _e1661 = (_e1639 * _e1660);
            let _e1662 = (_e1642 * _e1660);
            let _e1663 = (_e1645 * _e1660);
            if ((((_e1661 * (_e1647.x - _e1563)) + (_e1662 * (_e1647.y - _e1564))) + (_e1663 * (_e1647.z - _e1565))) < 0f) {
                phi_1954_ = vec3<f32>(-(_e1661), -(_e1662), -(_e1663));
            } else {
                phi_1954_ = vec3<f32>(_e1661, _e1662, _e1663);
            }
            let _e1676 = phi_1954_;
            if (_e1526.triangle < _e70) {
            } else {
                return;
            }
            let _e1681 = triangles.member[(0u + _e1526.triangle)];
            let _e1683 = (_e1681.i0_ & 2147483647u);
            if (_e1683 < _e73) {
            } else {
                return;
            }
            let _e1689 = vertices.member[(0u + _e1683)];
            if (_e1681.i1_ < _e73) {
            } else {
                return;
            }
            let _e1693 = vertices.member[(0u + _e1681.i1_)];
            if (_e1681.i2_ < _e73) {
            } else {
                return;
            }
            let _e1697 = vertices.member[(0u + _e1681.i2_)];
            let _e1698 = array<abi_Vertex, 3>(_e1689, _e1693, _e1697);
            if (_e1698[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e1704 = materials.member[(0u + _e1698[0].material)];
            let _e1721 = (1f / 255f);
            let _e1740 = (1f / 255f);
            let _e1762 = (1f / 255f);
            let _e1775 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e1532, _e1526.u, _e1526.v));
            let _e1777 = ((_e1704.base_color.x * ((((f32((_e1698[0].color & 255u)) * _e1721) * _e1532) + ((f32((_e1698[1].color & 255u)) * _e1740) * _e1526.u)) + ((f32((_e1698[2].color & 255u)) * _e1762) * _e1526.v))) * _e1775.x);
            let _e1779 = ((_e1704.base_color.y * ((((f32(((_e1698[0].color >> bitcast<u32>(8i)) & 255u)) * _e1721) * _e1532) + ((f32(((_e1698[1].color >> bitcast<u32>(8i)) & 255u)) * _e1740) * _e1526.u)) + ((f32(((_e1698[2].color >> bitcast<u32>(8i)) & 255u)) * _e1762) * _e1526.v))) * _e1775.y);
            let _e1781 = ((_e1704.base_color.z * ((((f32(((_e1698[0].color >> bitcast<u32>(16i)) & 255u)) * _e1721) * _e1532) + ((f32(((_e1698[1].color >> bitcast<u32>(16i)) & 255u)) * _e1740) * _e1526.u)) + ((f32(((_e1698[2].color >> bitcast<u32>(16i)) & 255u)) * _e1762) * _e1526.v))) * _e1775.z);
            let _e1782 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1599, _e1602);
            let _e1783 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1596, _e1782);
            if ((_e1704.flags & 2u) == 0u) {
                phi_2075_ = 0u;
            } else {
                phi_2075_ = 1u;
            }
            let _e1788 = phi_2075_;
            if (_e1698[0].normal == 2147516416u) {
                phi_2278_ = _e1676;
            } else {
                let _e1801 = (f32((bitcast<i32>((_e1698[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1807 = (f32((bitcast<i32>(_e1698[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1811 = ((1f - abs(_e1801)) - abs(_e1807));
                if (_e1811 < 0f) {
                    phi_2102_ = -(_e1811);
                } else {
                    phi_2102_ = 0f;
                }
                let _e1815 = phi_2102_;
                if (_e1801 < 0f) {
                    phi_2109_ = (_e1801 + _e1815);
                } else {
                    phi_2109_ = (_e1801 - _e1815);
                }
                let _e1820 = phi_2109_;
                if (_e1807 < 0f) {
                    phi_2116_ = (_e1807 + _e1815);
                } else {
                    phi_2116_ = (_e1807 - _e1815);
                }
                let _e1825 = phi_2116_;
                let _e1832 = (1f / sqrt((((_e1820 * _e1820) + (_e1825 * _e1825)) + (_e1811 * _e1811))));
                let _e1848 = (f32((bitcast<i32>((_e1698[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1854 = (f32((bitcast<i32>(_e1698[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1858 = ((1f - abs(_e1848)) - abs(_e1854));
                if (_e1858 < 0f) {
                    phi_2151_ = -(_e1858);
                } else {
                    phi_2151_ = 0f;
                }
                let _e1862 = phi_2151_;
                if (_e1848 < 0f) {
                    phi_2158_ = (_e1848 + _e1862);
                } else {
                    phi_2158_ = (_e1848 - _e1862);
                }
                let _e1867 = phi_2158_;
                if (_e1854 < 0f) {
                    phi_2165_ = (_e1854 + _e1862);
                } else {
                    phi_2165_ = (_e1854 - _e1862);
                }
                let _e1872 = phi_2165_;
                let _e1879 = (1f / sqrt((((_e1867 * _e1867) + (_e1872 * _e1872)) + (_e1858 * _e1858))));
                let _e1898 = (f32((bitcast<i32>((_e1698[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1904 = (f32((bitcast<i32>(_e1698[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1908 = ((1f - abs(_e1898)) - abs(_e1904));
                if (_e1908 < 0f) {
                    phi_2203_ = -(_e1908);
                } else {
                    phi_2203_ = 0f;
                }
                let _e1912 = phi_2203_;
                if (_e1898 < 0f) {
                    phi_2210_ = (_e1898 + _e1912);
                } else {
                    phi_2210_ = (_e1898 - _e1912);
                }
                let _e1917 = phi_2210_;
                if (_e1904 < 0f) {
                    phi_2217_ = (_e1904 + _e1912);
                } else {
                    phi_2217_ = (_e1904 - _e1912);
                }
                let _e1922 = phi_2217_;
                let _e1929 = (1f / sqrt((((_e1917 * _e1917) + (_e1922 * _e1922)) + (_e1908 * _e1908))));
                let _e1940 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e1820 * _e1832) * _e1532) + ((_e1867 * _e1879) * _e1526.u)) + ((_e1917 * _e1929) * _e1526.v)), ((((_e1825 * _e1832) * _e1532) + ((_e1872 * _e1879) * _e1526.u)) + ((_e1922 * _e1929) * _e1526.v)), ((((_e1811 * _e1832) * _e1532) + ((_e1858 * _e1879) * _e1526.u)) + ((_e1908 * _e1929) * _e1526.v))));
                let _e1952 = sqrt((((_e1940.x * _e1940.x) + (_e1940.y * _e1940.y)) + (_e1940.z * _e1940.z)));
                if (_e1952 > 0f) {
                    let _e1955 = (_e1940.x / _e1952);
                    let _e1957 = (_e1940.y / _e1952);
                    let _e1959 = (_e1940.z / _e1952);
                    if ((((_e1955 * _e1676.x) + (_e1957 * _e1676.y)) + (_e1959 * _e1676.z)) < 0f) {
                        phi_2276_ = vec3<f32>(-(_e1955), -(_e1957), -(_e1959));
                    } else {
                        phi_2276_ = (_e1940 / vec3(_e1952));
                    }
                    let _e1976 = phi_2276_;
                    phi_2277_ = _e1976;
                } else {
                    phi_2277_ = _e1676;
                }
                let _e1978 = phi_2277_;
                phi_2278_ = _e1978;
            }
            let _e1980 = phi_2278_;
            if (_e1777 > 0f) {
                if (_e1777 < 1f) {
                    phi_2287_ = _e1777;
                } else {
                    phi_2287_ = 1f;
                }
                let _e1984 = phi_2287_;
                phi_2288_ = _e1984;
            } else {
                phi_2288_ = 0f;
            }
            let _e1986 = phi_2288_;
            if (_e1779 > 0f) {
                if (_e1779 < 1f) {
                    phi_2298_ = _e1779;
                } else {
                    phi_2298_ = 1f;
                }
                let _e1991 = phi_2298_;
                phi_2299_ = _e1991;
            } else {
                phi_2299_ = 0f;
            }
            let _e1993 = phi_2299_;
            if (_e1781 > 0f) {
                if (_e1781 < 1f) {
                    phi_2309_ = _e1781;
                } else {
                    phi_2309_ = 1f;
                }
                let _e1998 = phi_2309_;
                phi_2310_ = _e1998;
            } else {
                phi_2310_ = 0f;
            }
            let _e2000 = phi_2310_;
            let _e2003 = ((sqrt(_e1986) * 255f) + 0.5f);
            let _e2012 = ((sqrt(_e1993) * 255f) + 0.5f);
            let _e2024 = ((sqrt(_e2000) * 255f) + 0.5f);
            phi_2345_ = abi_Sample(vec3<f32>(_e1563, _e1564, _e1565), _e1783, _e1676, _e1788, _e1980, ((select(select(u32(_e2003), 0u, (_e2003 < bitcast<f32>(0u))), 4294967295u, (_e2003 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2012), 0u, (_e2012 < bitcast<f32>(0u))), 4294967295u, (_e2012 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2024), 0u, (_e2024 < bitcast<f32>(0u))), 4294967295u, (_e2024 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_2345_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2038 = phi_2345_;
        if (_e91.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e91.first_primitive)] = _e2038;
        if (_e1526.triangle != 4294967295u) {
            let _e2047 = ((1f - _e1526.u) - _e1526.v);
            if (_e1526.triangle < _e70) {
            } else {
                return;
            }
            let _e2052 = triangles.member[(0u + _e1526.triangle)];
            let _e2054 = (_e2052.i0_ & 2147483647u);
            if (_e2054 < _e82) {
            } else {
                return;
            }
            let _e2060 = before.member[(0u + _e2054)];
            if (_e2052.i1_ < _e82) {
            } else {
                return;
            }
            let _e2064 = before.member[(0u + _e2052.i1_)];
            if (_e2052.i2_ < _e82) {
            } else {
                return;
            }
            let _e2068 = before.member[(0u + _e2052.i2_)];
            let _e2073 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2060.x, _e2060.y, _e2060.z));
            let _e2084 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2064.x, _e2064.y, _e2064.z));
            let _e2098 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2068.x, _e2068.y, _e2068.z));
            phi_2436_ = vec3<f32>((((_e2073.x * _e2047) + (_e2084.x * _e1526.u)) + (_e2098.x * _e1526.v)), (((_e2073.y * _e2047) + (_e2084.y * _e1526.u)) + (_e2098.y * _e1526.v)), (((_e2073.z * _e2047) + (_e2084.z * _e1526.u)) + (_e2098.z * _e1526.v)));
        } else {
            phi_2436_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e2110 = phi_2436_;
        if (_e91.first_primitive < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e91.first_primitive)] = vec4<f32>(_e2110.x, _e2110.y, _e2110.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
