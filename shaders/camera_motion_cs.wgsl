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
    var phi_195_: lt_mask_LightPlace;
    var phi_196_: bool;
    var phi_197_: lt_mask_LightPlace;
    var phi_198_: bool;
    var phi_203_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_195_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_196_ = false;
        } else {
            phi_195_ = lt_mask_LightPlace();
            phi_196_ = true;
        }
        let _e75 = phi_195_;
        let _e77 = phi_196_;
        phi_197_ = _e75;
        phi_198_ = _e77;
    } else {
        phi_197_ = lt_mask_LightPlace();
        phi_198_ = true;
    }
    let _e79 = phi_197_;
    let _e81 = phi_198_;
    if _e81 {
        phi_203_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_203_ = _e79;
    }
    let _e86 = phi_203_;
    return lt_mask_LightPlace(_e86.word, _e86.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_218_: bool;
    var phi_222_: f32;

    if (param_3 != param_3) {
        phi_218_ = true;
    } else {
        let _e65 = (param_4 >= param_3);
        if _e65 {
        }
        phi_218_ = _e65;
    }
    let _e67 = phi_218_;
    if _e67 {
        phi_222_ = param_4;
    } else {
        phi_222_ = param_3;
    }
    let _e69 = phi_222_;
    return _e69;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_234_: bool;
    var phi_238_: f32;

    if (param_5 != param_5) {
        phi_234_ = true;
    } else {
        let _e65 = (param_6 <= param_5);
        if _e65 {
        }
        phi_234_ = _e65;
    }
    let _e67 = phi_234_;
    if _e67 {
        phi_238_ = param_6;
    } else {
        phi_238_ = param_5;
    }
    let _e69 = phi_238_;
    return _e69;
}

fn _lt_bvh_ray_Ray_new(param_7: vec3<f32>, param_8: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_7, 0f, param_8, 300000000000000000000000000000000000000f);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_9: f32, param_10: f32) -> f32 {
    var phi_250_: f32;

    if (param_9 > param_10) {
        phi_250_ = param_9;
    } else {
        phi_250_ = param_10;
    }
    let _e66 = phi_250_;
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
    var phi_370_: bool;
    var phi_371_: bool;
    var phi_372_: bool;
    var phi_373_: bool;
    var phi_377_: bool;
    var phi_390_: bool;
    var phi_391_: bool;
    var phi_392_: bool;
    var phi_393_: bool;
    var phi_397_: bool;
    var phi_410_: bool;
    var phi_411_: bool;
    var phi_412_: bool;
    var phi_416_: bool;
    var phi_417_: bool;
    var phi_418_: bool;
    var phi_419_: bool;
    var phi_420_: bool;
    var phi_424_: bool;
    var phi_500_: f32;
    var phi_507_: f32;
    var phi_515_: f32;
    var phi_522_: f32;
    var phi_530_: f32;
    var phi_537_: f32;
    var phi_560_: f32;
    var phi_565_: f32;
    var phi_570_: f32;
    var phi_575_: f32;
    var phi_580_: f32;
    var phi_611_: bool;
    var phi_612_: bool;
    var phi_620_: u32;
    var phi_621_: u32;
    var phi_638_: vec3<f32>;
    var phi_639_: vec3<f32>;
    var phi_652_: u32;
    var phi_657_: u32;
    var phi_662_: u32;
    var phi_776_: bool;
    var phi_777_: bool;
    var phi_808_: u32;
    var phi_810_: lt_bvh_Hit;
    var phi_813_: u32;
    var phi_898_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_925_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_952_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_958_: u32;
    var phi_961_: u32;
    var phi_975_: u32;
    var phi_985_: u32;
    var phi_995_: u32;
    var phi_1013_: u32;
    var phi_1023_: u32;
    var phi_1033_: u32;
    var phi_1069_: u32;
    var phi_1082_: u32;
    var phi_1087_: u32;
    var phi_1088_: u32;
    var phi_1089_: u32;
    var phi_959_: u32;
    var phi_962_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1147_: lt_bvh_Hit;
    var phi_1150_: u32;
    var phi_1196_: vec3<f32>;
    var phi_1197_: vec3<f32>;
    var phi_1228_: vec3<f32>;
    var phi_1229_: vec3<f32>;
    var phi_1260_: vec3<f32>;
    var phi_1261_: vec3<f32>;
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
    var phi_1426_: vec3<f32>;
    var phi_1427_: vec3<f32>;
    var phi_1452_: vec3<f32>;
    var phi_1453_: vec3<f32>;
    var phi_1478_: vec3<f32>;
    var phi_1479_: vec3<f32>;
    var phi_1537_: f32;
    var phi_1546_: f32;
    var phi_1555_: f32;
    var phi_1564_: f32;
    var phi_1571_: f32;
    var phi_1578_: f32;
    var phi_1591_: f32;
    var phi_1600_: f32;
    var phi_1609_: f32;
    var phi_1618_: f32;
    var phi_1625_: f32;
    var phi_1632_: f32;
    var phi_1655_: f32;
    var phi_1660_: f32;
    var phi_1665_: f32;
    var phi_1673_: f32;
    var phi_1678_: f32;
    var phi_1683_: f32;
    var phi_1695_: f32;
    var phi_1700_: f32;
    var phi_1705_: f32;
    var phi_1710_: f32;
    var phi_1715_: lt_bvh_triangle_Intersection;
    var phi_1716_: bool;
    var phi_1717_: lt_bvh_triangle_Intersection;
    var phi_1718_: bool;
    var phi_1722_: lt_bvh_triangle_Intersection;
    var phi_1723_: bool;
    var phi_1724_: lt_bvh_triangle_Intersection;
    var phi_1725_: bool;
    var phi_1726_: bool;
    var phi_1730_: bool;
    var phi_1734_: lt_bvh_triangle_Intersection;
    var phi_1773_: bool;
    var phi_1774_: bool;
    var phi_1775_: bool;
    var phi_1776_: bool;
    var phi_1777_: bool;
    var phi_1778_: bool;
    var phi_1782_: bool;
    var phi_1783_: bool;
    var phi_1797_: bool;
    var phi_1805_: lt_bvh_Hit;
    var phi_1806_: lt_bvh_Hit;
    var phi_1807_: lt_bvh_Hit;
    var phi_1808_: lt_bvh_Hit;
    var phi_1148_: lt_bvh_Hit;
    var phi_1151_: u32;
    var phi_1809_: bool;
    var phi_1848_: bool;
    var phi_1849_: bool;
    var phi_1880_: u32;
    var phi_811_: lt_bvh_Hit;
    var phi_814_: u32;
    var phi_1881_: lt_bvh_Hit;
    var phi_1882_: lt_bvh_Hit;
    var phi_1883_: bool;
    var phi_1887_: lt_bvh_Hit;
    var phi_1952_: f32;
    var phi_1957_: f32;
    var phi_1962_: f32;
    var phi_1973_: f32;
    var phi_1978_: f32;
    var phi_1983_: f32;
    var phi_2059_: vec3<f32>;
    var phi_2180_: u32;
    var phi_2207_: f32;
    var phi_2214_: f32;
    var phi_2221_: f32;
    var phi_2256_: f32;
    var phi_2263_: f32;
    var phi_2270_: f32;
    var phi_2308_: f32;
    var phi_2315_: f32;
    var phi_2322_: f32;
    var phi_2381_: vec3<f32>;
    var phi_2382_: vec3<f32>;
    var phi_2383_: vec3<f32>;
    var phi_2392_: f32;
    var phi_2393_: f32;
    var phi_2403_: f32;
    var phi_2404_: f32;
    var phi_2414_: f32;
    var phi_2415_: f32;
    var phi_2450_: abi_Sample;
    var phi_2541_: vec3<f32>;
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
        let _e151 = abs(_e146.direction.x);
        let _e153 = abs(_e146.direction.y);
        let _e155 = abs(_e146.direction.z);
        if (abs(_e146.origin.x) < 1000000000000000f) {
            if (abs(_e146.origin.y) < 1000000000000000f) {
                phi_370_ = (abs(_e146.origin.z) < 1000000000000000f);
                phi_371_ = false;
            } else {
                phi_370_ = bool();
                phi_371_ = true;
            }
            let _e167 = phi_370_;
            let _e169 = phi_371_;
            phi_372_ = _e167;
            phi_373_ = _e169;
        } else {
            phi_372_ = bool();
            phi_373_ = true;
        }
        let _e171 = phi_372_;
        let _e173 = phi_373_;
        if _e173 {
            phi_377_ = false;
        } else {
            phi_377_ = _e171;
        }
        let _e175 = phi_377_;
        if _e175 {
            if (_e151 < 1000000000000000f) {
                if (_e153 < 1000000000000000f) {
                    phi_390_ = (_e155 < 1000000000000000f);
                    phi_391_ = false;
                } else {
                    phi_390_ = bool();
                    phi_391_ = true;
                }
                let _e180 = phi_390_;
                let _e182 = phi_391_;
                phi_392_ = _e180;
                phi_393_ = _e182;
            } else {
                phi_392_ = bool();
                phi_393_ = true;
            }
            let _e184 = phi_392_;
            let _e186 = phi_393_;
            if _e186 {
                phi_397_ = false;
            } else {
                phi_397_ = _e184;
            }
            let _e188 = phi_397_;
            if _e188 {
                if (_e151 > 0f) {
                    phi_411_ = bool();
                    phi_412_ = true;
                } else {
                    let _e190 = (_e153 > 0f);
                    if _e190 {
                        phi_410_ = bool();
                    } else {
                        phi_410_ = (_e155 > 0f);
                    }
                    let _e193 = phi_410_;
                    phi_411_ = _e193;
                    phi_412_ = _e190;
                }
                let _e195 = phi_411_;
                let _e197 = phi_412_;
                if _e197 {
                    phi_416_ = true;
                } else {
                    phi_416_ = _e195;
                }
                let _e199 = phi_416_;
                phi_417_ = _e199;
                phi_418_ = false;
            } else {
                phi_417_ = bool();
                phi_418_ = true;
            }
            let _e201 = phi_417_;
            let _e203 = phi_418_;
            phi_419_ = _e201;
            phi_420_ = _e203;
        } else {
            phi_419_ = bool();
            phi_420_ = true;
        }
        let _e205 = phi_419_;
        let _e207 = phi_420_;
        if _e207 {
            phi_424_ = false;
        } else {
            phi_424_ = _e205;
        }
        let _e209 = phi_424_;
        if _e209 {
            let _e210 = (0u >= _e67);
            if _e210 {
                phi_1881_ = lt_bvh_Hit();
            } else {
                if (0u < _e67) {
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
                let _e279 = core_intrinsics_maximum_number_nsz_f32_(abs(_e146.direction.x), abs(_e146.direction.y));
                let _e280 = core_intrinsics_maximum_number_nsz_f32_(_e279, abs(_e146.direction.z));
                let _e281 = (_e280 * 0.0000000000009094947f);
                if (abs(_e146.direction.x) < _e281) {
                    phi_500_ = _e281;
                } else {
                    phi_500_ = abs(_e146.direction.x);
                }
                let _e287 = phi_500_;
                if (_e146.direction.x < 0f) {
                    phi_507_ = (-1f / _e287);
                } else {
                    phi_507_ = (1f / _e287);
                }
                let _e292 = phi_507_;
                if (abs(_e146.direction.y) < _e281) {
                    phi_515_ = _e281;
                } else {
                    phi_515_ = abs(_e146.direction.y);
                }
                let _e298 = phi_515_;
                if (_e146.direction.y < 0f) {
                    phi_522_ = (-1f / _e298);
                } else {
                    phi_522_ = (1f / _e298);
                }
                let _e303 = phi_522_;
                if (abs(_e146.direction.z) < _e281) {
                    phi_530_ = _e281;
                } else {
                    phi_530_ = abs(_e146.direction.z);
                }
                let _e309 = phi_530_;
                if (_e146.direction.z < 0f) {
                    phi_537_ = (-1f / _e309);
                } else {
                    phi_537_ = (1f / _e309);
                }
                let _e314 = phi_537_;
                let _e321 = abs((bitcast<f32>(_e216) - _e146.origin.x));
                let _e322 = abs((bitcast<f32>(_e220) - _e146.origin.y));
                let _e323 = abs((bitcast<f32>(_e224) - _e146.origin.z));
                let _e330 = abs(((bitcast<f32>(_e228) + (bitcast<f32>((((_e240 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e146.origin.x));
                let _e331 = abs(((bitcast<f32>(_e232) + (bitcast<f32>((((_e240 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e146.origin.y));
                let _e332 = abs(((bitcast<f32>(_e236) + (bitcast<f32>((((_e240 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e146.origin.z));
                if (_e321 > _e330) {
                    phi_560_ = _e321;
                } else {
                    phi_560_ = _e330;
                }
                let _e335 = phi_560_;
                if (_e322 > _e331) {
                    phi_565_ = _e322;
                } else {
                    phi_565_ = _e331;
                }
                let _e338 = phi_565_;
                if (_e323 > _e332) {
                    phi_570_ = _e323;
                } else {
                    phi_570_ = _e332;
                }
                let _e341 = phi_570_;
                if (_e335 > _e338) {
                    phi_575_ = _e335;
                } else {
                    phi_575_ = _e338;
                }
                let _e344 = phi_575_;
                if (_e344 > _e341) {
                    phi_580_ = _e344;
                } else {
                    phi_580_ = _e341;
                }
                let _e347 = phi_580_;
                let _e351 = (_e347 * 0.0000019073486f);
                let _e352 = (abs(_e292) * _e351);
                let _e353 = (abs(_e303) * _e351);
                let _e354 = (abs(_e314) * _e351);
                let _e358 = (_e347 * 0.0000009536743f);
                let _e359 = (abs(_e292) * _e358);
                let _e360 = (abs(_e303) * _e358);
                let _e361 = (abs(_e314) * _e358);
                let _e365 = abs(_e146.direction.x);
                let _e367 = abs(_e146.direction.y);
                let _e369 = abs(_e146.direction.z);
                if (_e365 >= _e367) {
                    if (_e365 >= _e369) {
                        phi_611_ = false;
                    } else {
                        phi_611_ = true;
                    }
                    let _e373 = phi_611_;
                    phi_612_ = _e373;
                } else {
                    phi_612_ = true;
                }
                let _e375 = phi_612_;
                if _e375 {
                    if (_e367 >= _e369) {
                        phi_620_ = 1u;
                    } else {
                        phi_620_ = 2u;
                    }
                    let _e378 = phi_620_;
                    phi_621_ = _e378;
                } else {
                    phi_621_ = 0u;
                }
                let _e380 = phi_621_;
                if (_e380 == 0u) {
                    phi_639_ = vec3<f32>(_e146.direction.y, _e146.direction.z, _e146.direction.x);
                } else {
                    if (_e380 == 1u) {
                        phi_638_ = vec3<f32>(_e146.direction.z, _e146.direction.x, _e146.direction.y);
                    } else {
                        phi_638_ = _e146.direction;
                    }
                    let _e392 = phi_638_;
                    phi_639_ = _e392;
                }
                let _e394 = phi_639_;
                let _e397 = (_e394.x / _e394.z);
                let _e400 = (_e394.y / _e394.z);
                if (_e292 < 0f) {
                    phi_652_ = 0u;
                } else {
                    phi_652_ = 1u;
                }
                let _e405 = phi_652_;
                if (_e303 < 0f) {
                    phi_657_ = 0u;
                } else {
                    phi_657_ = 2u;
                }
                let _e408 = phi_657_;
                if (_e314 < 0f) {
                    phi_662_ = 0u;
                } else {
                    phi_662_ = 4u;
                }
                let _e411 = phi_662_;
                let _e413 = ((_e405 | _e408) | _e411);
                let _e414 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local = lt_bvh_traverse_Stack(array<u32, 32>(_e414.first[0], _e414.first[1], _e414.first[2], _e414.first[3], _e414.first[4], _e414.first[5], _e414.first[6], _e414.first[7], _e414.first[8], _e414.first[9], _e414.first[10], _e414.first[11], _e414.first[12], _e414.first[13], _e414.first[14], _e414.first[15], _e414.first[16], _e414.first[17], _e414.first[18], _e414.first[19], _e414.first[20], _e414.first[21], _e414.first[22], _e414.first[23], _e414.first[24], _e414.first[25], _e414.first[26], _e414.first[27], _e414.first[28], _e414.first[29], _e414.first[30], _e414.first[31]), array<u32, 32>(_e414.mask[0], _e414.mask[1], _e414.mask[2], _e414.mask[3], _e414.mask[4], _e414.mask[5], _e414.mask[6], _e414.mask[7], _e414.mask[8], _e414.mask[9], _e414.mask[10], _e414.mask[11], _e414.mask[12], _e414.mask[13], _e414.mask[14], _e414.mask[15], _e414.mask[16], _e414.mask[17], _e414.mask[18], _e414.mask[19], _e414.mask[20], _e414.mask[21], _e414.mask[22], _e414.mask[23], _e414.mask[24], _e414.mask[25], _e414.mask[26], _e414.mask[27], _e414.mask[28], _e414.mask[29], _e414.mask[30], _e414.mask[31]), _e414.len, _e414.group, _e414.group_mask);
                let _e488 = local.group_mask;
                if ((_e488 & 4278190080u) == 0u) {
                    let _e492 = local.len;
                    if (_e492 == 0u) {
                        phi_776_ = false;
                    } else {
                        let _e496 = local.len;
                        local.len = (_e496 - 1u);
                        let _e499 = local.len;
                        if (_e499 < 32u) {
                        } else {
                            return;
                        }
                        let _e504 = local.first[(0u + _e499)];
                        local.group = _e504;
                        let _e507 = local.len;
                        if (_e507 < 32u) {
                        } else {
                            return;
                        }
                        let _e512 = local.mask[(0u + _e507)];
                        local.group_mask = _e512;
                        phi_776_ = true;
                    }
                    let _e515 = phi_776_;
                    phi_777_ = _e515;
                } else {
                    phi_777_ = true;
                }
                let _e517 = phi_777_;
                if _e517 {
                    let _e519 = local.group_mask;
                    let _e525 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e519)), 32u, (_e519 == 0u)));
                    let _e529 = local.group_mask;
                    let _e543 = local.group_mask;
                    local.group_mask = (_e543 & ~((1u << bitcast<u32>((_e525 & 31u)))));
                    let _e546 = local.group;
                    phi_808_ = (_e546 + countOneBits(((_e529 & ~((4294967295u << bitcast<u32>((((_e525 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_808_ = 4294967295u;
                }
                let _e549 = phi_808_;
                phi_810_ = _e148;
                phi_813_ = _e549;
                loop {
                    let _e551 = phi_810_;
                    let _e553 = phi_813_;
                    local_5 = _e551;
                    let _e554 = (_e553 != 4294967295u);
                    if _e554 {
                        if (_e553 < _e67) {
                        } else {
                            return;
                        }
                        let _e562 = nodes.member[(0u + _e553)].frame[3u];
                        let _e587 = (bitcast<f32>((((_e562 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e292);
                        let _e588 = (bitcast<f32>((((_e562 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e303);
                        let _e589 = (bitcast<f32>((((_e562 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e314);
                        let _e592 = nodes.member[(0u + _e553)].frame[0u];
                        let _e596 = nodes.member[(0u + _e553)].frame[1u];
                        let _e600 = nodes.member[(0u + _e553)].frame[2u];
                        let _e608 = ((bitcast<f32>(_e592) - _e146.origin.x) * _e292);
                        let _e609 = ((bitcast<f32>(_e596) - _e146.origin.y) * _e303);
                        let _e610 = ((bitcast<f32>(_e600) - _e146.origin.z) * _e314);
                        let _e618 = nodes.member[(0u + _e553)].x;
                        if (_e292 < 0f) {
                            let _e629 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e618.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e635 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e629.unnamed.word, _e618.w), _e629.unnamed_1);
                            let _e641 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e635.unnamed, lt_mask_LightPlace(_e618.x, _e635.unnamed_1.shift));
                            phi_898_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e641.unnamed, lt_mask_LightPlace(_e641.unnamed_1.word, _e618.y));
                        } else {
                            let _e657 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e618.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e663 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e657.unnamed.word, _e618.y), _e657.unnamed_1);
                            let _e669 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e663.unnamed, lt_mask_LightPlace(_e618.z, _e663.unnamed_1.shift));
                            phi_898_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e669.unnamed, lt_mask_LightPlace(_e669.unnamed_1.word, _e618.w));
                        }
                        let _e677 = phi_898_;
                        let _e687 = nodes.member[(0u + _e553)].y;
                        if (_e303 < 0f) {
                            let _e698 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e687.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e704 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e698.unnamed.word, _e687.w), _e698.unnamed_1);
                            let _e710 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e704.unnamed, lt_mask_LightPlace(_e687.x, _e704.unnamed_1.shift));
                            phi_925_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e710.unnamed, lt_mask_LightPlace(_e710.unnamed_1.word, _e687.y));
                        } else {
                            let _e726 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e687.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e732 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e726.unnamed.word, _e687.y), _e726.unnamed_1);
                            let _e738 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e732.unnamed, lt_mask_LightPlace(_e687.z, _e732.unnamed_1.shift));
                            phi_925_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e738.unnamed, lt_mask_LightPlace(_e738.unnamed_1.word, _e687.w));
                        }
                        let _e746 = phi_925_;
                        let _e756 = nodes.member[(0u + _e553)].z;
                        if (_e314 < 0f) {
                            let _e767 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e756.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e773 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e767.unnamed.word, _e756.w), _e767.unnamed_1);
                            let _e779 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e773.unnamed, lt_mask_LightPlace(_e756.x, _e773.unnamed_1.shift));
                            phi_952_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e779.unnamed, lt_mask_LightPlace(_e779.unnamed_1.word, _e756.y));
                        } else {
                            let _e795 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e756.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e801 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e795.unnamed.word, _e756.y), _e795.unnamed_1);
                            let _e807 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e801.unnamed, lt_mask_LightPlace(_e756.z, _e801.unnamed_1.shift));
                            phi_952_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e807.unnamed, lt_mask_LightPlace(_e807.unnamed_1.word, _e756.w));
                        }
                        let _e815 = phi_952_;
                        phi_958_ = 0u;
                        phi_961_ = 0u;
                        loop {
                            let _e825 = phi_958_;
                            let _e827 = phi_961_;
                            local_1 = _e827;
                            local_2 = _e827;
                            local_3 = _e827;
                            let _e828 = (_e825 < 8u);
                            if _e828 {
                                let _e830 = (_e825 >> bitcast<u32>(2i));
                                let _e831 = (_e825 & 3u);
                                if (_e830 == 0u) {
                                    phi_975_ = _e677.unnamed.word;
                                } else {
                                    phi_975_ = _e677.unnamed.shift;
                                }
                                let _e834 = phi_975_;
                                if (_e830 == 0u) {
                                    phi_985_ = _e746.unnamed.word;
                                } else {
                                    phi_985_ = _e746.unnamed.shift;
                                }
                                let _e843 = phi_985_;
                                if (_e830 == 0u) {
                                    phi_995_ = _e815.unnamed.word;
                                } else {
                                    phi_995_ = _e815.unnamed.shift;
                                }
                                let _e852 = phi_995_;
                                let _e865 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e834 >> bitcast<u32>(((_e831 * 8u) & 31u))) & 255u)) * _e587) + (_e608 - _e352)), ((f32(((_e843 >> bitcast<u32>(((_e831 * 8u) & 31u))) & 255u)) * _e588) + (_e609 - _e353)));
                                let _e866 = core_intrinsics_maximum_number_nsz_f32_(_e865, ((f32(((_e852 >> bitcast<u32>(((_e831 * 8u) & 31u))) & 255u)) * _e589) + (_e610 - _e354)));
                                if (_e830 == 0u) {
                                    phi_1013_ = _e677.unnamed_1.word;
                                } else {
                                    phi_1013_ = _e677.unnamed_1.shift;
                                }
                                let _e869 = phi_1013_;
                                if (_e830 == 0u) {
                                    phi_1023_ = _e746.unnamed_1.word;
                                } else {
                                    phi_1023_ = _e746.unnamed_1.shift;
                                }
                                let _e878 = phi_1023_;
                                if (_e830 == 0u) {
                                    phi_1033_ = _e815.unnamed_1.word;
                                } else {
                                    phi_1033_ = _e815.unnamed_1.shift;
                                }
                                let _e887 = phi_1033_;
                                let _e900 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e869 >> bitcast<u32>(((_e831 * 8u) & 31u))) & 255u)) * _e587) + (_e608 + _e352)), ((f32(((_e878 >> bitcast<u32>(((_e831 * 8u) & 31u))) & 255u)) * _e588) + (_e609 + _e353)));
                                let _e901 = core_intrinsics_minimum_number_nsz_f32_(_e900, ((f32(((_e887 >> bitcast<u32>(((_e831 * 8u) & 31u))) & 255u)) * _e589) + (_e610 + _e354)));
                                if (_e866 <= _e901) {
                                    if (_e866 <= _e551.t) {
                                        if (_e901 >= _e146.tmin) {
                                            if (_e830 == 0u) {
                                                let _e908 = nodes.member[(0u + _e553)].links[2u];
                                                phi_1069_ = _e908;
                                            } else {
                                                let _e911 = nodes.member[(0u + _e553)].links[3u];
                                                phi_1069_ = _e911;
                                            }
                                            let _e913 = phi_1069_;
                                            let _e918 = ((_e913 >> bitcast<u32>(((_e831 * 8u) & 31u))) & 255u);
                                            let _e919 = (_e918 & 31u);
                                            if (_e919 >= 24u) {
                                                phi_1082_ = (24u + ((_e919 - 24u) ^ _e413));
                                            } else {
                                                phi_1082_ = _e919;
                                            }
                                            let _e925 = phi_1082_;
                                            phi_1087_ = (_e827 | ((_e918 >> bitcast<u32>(5i)) << bitcast<u32>((_e925 & 31u))));
                                        } else {
                                            phi_1087_ = _e827;
                                        }
                                        let _e933 = phi_1087_;
                                        phi_1088_ = _e933;
                                    } else {
                                        phi_1088_ = _e827;
                                    }
                                    let _e935 = phi_1088_;
                                    phi_1089_ = _e935;
                                } else {
                                    phi_1089_ = _e827;
                                }
                                let _e937 = phi_1089_;
                                phi_959_ = (_e825 + 1u);
                                phi_962_ = _e937;
                            } else {
                                phi_959_ = u32();
                                phi_962_ = u32();
                            }
                            let _e940 = phi_959_;
                            let _e942 = phi_962_;
                            continue;
                            continuing {
                                phi_958_ = _e940;
                                phi_961_ = _e942;
                                break if !(_e828);
                            }
                        }
                        let _e946 = nodes.member[(0u + _e553)].links[0u];
                        let _e950 = nodes.member[(0u + _e553)].frame[3u];
                        let _e954 = local_1;
                        if ((_e954 & 4278190080u) == 0u) {
                        } else {
                            let _e958 = local.group_mask;
                            if ((_e958 & 4278190080u) == 0u) {
                            } else {
                                let _e962 = local.len;
                                if (_e962 < 32u) {
                                    let _e965 = local.group;
                                    let _e967 = local.len;
                                    if (_e967 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.first[(0u + _e967)] = _e965;
                                    let _e973 = local.group_mask;
                                    let _e975 = local.len;
                                    if (_e975 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.mask[(0u + _e975)] = _e973;
                                    let _e982 = local.len;
                                    local.len = (_e982 + 1u);
                                }
                            }
                            local.group = (0u + _e946);
                            let _e986 = local_2;
                            local.group_mask = ((_e986 & 4278190080u) | (_e950 >> bitcast<u32>(24i)));
                        }
                        let _e991 = local_3;
                        phi_1147_ = _e551;
                        phi_1150_ = (_e991 & 16777215u);
                        loop {
                            let _e994 = phi_1147_;
                            let _e996 = phi_1150_;
                            local_4 = _e994;
                            if (_e996 == 0u) {
                                phi_1148_ = lt_bvh_Hit();
                                phi_1151_ = u32();
                                phi_1809_ = false;
                            } else {
                                let _e1000 = nodes.member[(0u + _e553)].links[1u];
                                let _e1005 = ((0u + _e1000) + select(firstTrailingBit(_e996), 32u, (_e996 == 0u)));
                                if (_e1005 < _e70) {
                                } else {
                                    return;
                                }
                                let _e1012 = triangles.member[(0u + _e1005)].v0_;
                                let _e1015 = (_e1012.x - _e146.origin.x);
                                let _e1018 = (_e1012.y - _e146.origin.y);
                                let _e1021 = (_e1012.z - _e146.origin.z);
                                if (_e380 == 0u) {
                                    phi_1197_ = vec3<f32>(_e1018, _e1021, _e1015);
                                } else {
                                    if (_e380 == 1u) {
                                        phi_1196_ = vec3<f32>(_e1021, _e1015, _e1018);
                                    } else {
                                        phi_1196_ = (_e1012 - _e146.origin);
                                    }
                                    let _e1028 = phi_1196_;
                                    phi_1197_ = _e1028;
                                }
                                let _e1030 = phi_1197_;
                                let _e1034 = (_e1030.x - (_e397 * _e1030.z));
                                let _e1038 = (_e1030.y - (_e400 * _e1030.z));
                                let _e1040 = triangles.member[(0u + _e1005)].v1_;
                                let _e1043 = (_e1040.x - _e146.origin.x);
                                let _e1046 = (_e1040.y - _e146.origin.y);
                                let _e1049 = (_e1040.z - _e146.origin.z);
                                if (_e380 == 0u) {
                                    phi_1229_ = vec3<f32>(_e1046, _e1049, _e1043);
                                } else {
                                    if (_e380 == 1u) {
                                        phi_1228_ = vec3<f32>(_e1049, _e1043, _e1046);
                                    } else {
                                        phi_1228_ = (_e1040 - _e146.origin);
                                    }
                                    let _e1056 = phi_1228_;
                                    phi_1229_ = _e1056;
                                }
                                let _e1058 = phi_1229_;
                                let _e1062 = (_e1058.x - (_e397 * _e1058.z));
                                let _e1066 = (_e1058.y - (_e400 * _e1058.z));
                                let _e1068 = triangles.member[(0u + _e1005)].v2_;
                                let _e1071 = (_e1068.x - _e146.origin.x);
                                let _e1074 = (_e1068.y - _e146.origin.y);
                                let _e1077 = (_e1068.z - _e146.origin.z);
                                if (_e380 == 0u) {
                                    phi_1261_ = vec3<f32>(_e1074, _e1077, _e1071);
                                } else {
                                    if (_e380 == 1u) {
                                        phi_1260_ = vec3<f32>(_e1077, _e1071, _e1074);
                                    } else {
                                        phi_1260_ = (_e1068 - _e146.origin);
                                    }
                                    let _e1084 = phi_1260_;
                                    phi_1261_ = _e1084;
                                }
                                let _e1086 = phi_1261_;
                                let _e1090 = (_e1086.x - (_e397 * _e1086.z));
                                let _e1094 = (_e1086.y - (_e400 * _e1086.z));
                                if (_e1062 < _e1090) {
                                    phi_1280_ = true;
                                } else {
                                    if (_e1062 == _e1090) {
                                        phi_1279_ = (_e1066 < _e1094);
                                    } else {
                                        phi_1279_ = false;
                                    }
                                    let _e1099 = phi_1279_;
                                    phi_1280_ = _e1099;
                                }
                                let _e1101 = phi_1280_;
                                if _e1101 {
                                    phi_1284_ = _e1094;
                                    phi_1285_ = _e1090;
                                    phi_1286_ = _e1066;
                                    phi_1287_ = _e1062;
                                } else {
                                    phi_1284_ = _e1066;
                                    phi_1285_ = _e1062;
                                    phi_1286_ = _e1094;
                                    phi_1287_ = _e1090;
                                }
                                let _e1103 = phi_1284_;
                                let _e1105 = phi_1285_;
                                let _e1107 = phi_1286_;
                                let _e1109 = phi_1287_;
                                let _e1112 = ((_e1109 * _e1103) - (_e1107 * _e1105));
                                if _e1101 {
                                    phi_1295_ = -(_e1112);
                                } else {
                                    phi_1295_ = _e1112;
                                }
                                let _e1115 = phi_1295_;
                                if (_e1090 < _e1034) {
                                    phi_1306_ = true;
                                } else {
                                    if (_e1090 == _e1034) {
                                        phi_1305_ = (_e1094 < _e1038);
                                    } else {
                                        phi_1305_ = false;
                                    }
                                    let _e1120 = phi_1305_;
                                    phi_1306_ = _e1120;
                                }
                                let _e1122 = phi_1306_;
                                if _e1122 {
                                    phi_1310_ = _e1038;
                                    phi_1311_ = _e1034;
                                    phi_1312_ = _e1094;
                                    phi_1313_ = _e1090;
                                } else {
                                    phi_1310_ = _e1094;
                                    phi_1311_ = _e1090;
                                    phi_1312_ = _e1038;
                                    phi_1313_ = _e1034;
                                }
                                let _e1124 = phi_1310_;
                                let _e1126 = phi_1311_;
                                let _e1128 = phi_1312_;
                                let _e1130 = phi_1313_;
                                let _e1133 = ((_e1130 * _e1124) - (_e1128 * _e1126));
                                if _e1122 {
                                    phi_1321_ = -(_e1133);
                                } else {
                                    phi_1321_ = _e1133;
                                }
                                let _e1136 = phi_1321_;
                                if (_e1034 < _e1062) {
                                    phi_1332_ = true;
                                } else {
                                    if (_e1034 == _e1062) {
                                        phi_1331_ = (_e1038 < _e1066);
                                    } else {
                                        phi_1331_ = false;
                                    }
                                    let _e1141 = phi_1331_;
                                    phi_1332_ = _e1141;
                                }
                                let _e1143 = phi_1332_;
                                if _e1143 {
                                    phi_1336_ = _e1066;
                                    phi_1337_ = _e1062;
                                    phi_1338_ = _e1038;
                                    phi_1339_ = _e1034;
                                } else {
                                    phi_1336_ = _e1038;
                                    phi_1337_ = _e1034;
                                    phi_1338_ = _e1066;
                                    phi_1339_ = _e1062;
                                }
                                let _e1145 = phi_1336_;
                                let _e1147 = phi_1337_;
                                let _e1149 = phi_1338_;
                                let _e1151 = phi_1339_;
                                let _e1154 = ((_e1151 * _e1145) - (_e1149 * _e1147));
                                if _e1143 {
                                    phi_1347_ = -(_e1154);
                                } else {
                                    phi_1347_ = _e1154;
                                }
                                let _e1157 = phi_1347_;
                                if (_e1115 >= 0f) {
                                    if (_e1136 >= 0f) {
                                        if (_e1157 >= 0f) {
                                            phi_1362_ = ((_e1115 + _e1136) + _e1157);
                                            phi_1363_ = false;
                                        } else {
                                            phi_1362_ = f32();
                                            phi_1363_ = true;
                                        }
                                        let _e1164 = phi_1362_;
                                        let _e1166 = phi_1363_;
                                        phi_1364_ = _e1164;
                                        phi_1365_ = _e1166;
                                    } else {
                                        phi_1364_ = f32();
                                        phi_1365_ = true;
                                    }
                                    let _e1168 = phi_1364_;
                                    let _e1170 = phi_1365_;
                                    phi_1366_ = _e1168;
                                    phi_1367_ = _e1170;
                                } else {
                                    phi_1366_ = f32();
                                    phi_1367_ = true;
                                }
                                let _e1172 = phi_1366_;
                                let _e1174 = phi_1367_;
                                if _e1174 {
                                    if (_e1115 <= 0f) {
                                        if (_e1136 <= 0f) {
                                            let _e1177 = (_e1157 <= 0f);
                                            if _e1177 {
                                            }
                                            phi_1385_ = ((_e1115 + _e1136) + _e1157);
                                            phi_1386_ = false;
                                            phi_1387_ = _e1177;
                                        } else {
                                            phi_1385_ = f32();
                                            phi_1386_ = true;
                                            phi_1387_ = false;
                                        }
                                        let _e1181 = phi_1385_;
                                        let _e1183 = phi_1386_;
                                        let _e1185 = phi_1387_;
                                        phi_1388_ = _e1181;
                                        phi_1389_ = _e1183;
                                        phi_1390_ = _e1185;
                                    } else {
                                        phi_1388_ = f32();
                                        phi_1389_ = true;
                                        phi_1390_ = false;
                                    }
                                    let _e1187 = phi_1388_;
                                    let _e1189 = phi_1389_;
                                    let _e1191 = phi_1390_;
                                    if _e1189 {
                                        phi_1394_ = false;
                                    } else {
                                        phi_1394_ = _e1191;
                                    }
                                    let _e1193 = phi_1394_;
                                    phi_1395_ = _e1187;
                                    phi_1396_ = _e1193;
                                } else {
                                    phi_1395_ = _e1172;
                                    phi_1396_ = true;
                                }
                                let _e1195 = phi_1395_;
                                let _e1197 = phi_1396_;
                                if _e1197 {
                                    let _e1198 = (_e1195 == 0f);
                                    if _e1198 {
                                        phi_1722_ = lt_bvh_triangle_Intersection();
                                        phi_1723_ = false;
                                    } else {
                                        let _e1200 = triangles.member[(0u + _e1005)].v0_;
                                        let _e1203 = (_e1200.x - _e146.origin.x);
                                        let _e1206 = (_e1200.y - _e146.origin.y);
                                        let _e1209 = (_e1200.z - _e146.origin.z);
                                        if (_e380 == 0u) {
                                            phi_1427_ = vec3<f32>(_e1206, _e1209, _e1203);
                                        } else {
                                            if (_e380 == 1u) {
                                                phi_1426_ = vec3<f32>(_e1209, _e1203, _e1206);
                                            } else {
                                                phi_1426_ = (_e1200 - _e146.origin);
                                            }
                                            let _e1216 = phi_1426_;
                                            phi_1427_ = _e1216;
                                        }
                                        let _e1218 = phi_1427_;
                                        let _e1220 = triangles.member[(0u + _e1005)].v1_;
                                        let _e1222 = triangles.member[(0u + _e1005)].v0_;
                                        let _e1225 = (_e1220.x - _e1222.x);
                                        let _e1228 = (_e1220.y - _e1222.y);
                                        let _e1231 = (_e1220.z - _e1222.z);
                                        if (_e380 == 0u) {
                                            phi_1453_ = vec3<f32>(_e1228, _e1231, _e1225);
                                        } else {
                                            if (_e380 == 1u) {
                                                phi_1452_ = vec3<f32>(_e1231, _e1225, _e1228);
                                            } else {
                                                phi_1452_ = (_e1220 - _e1222);
                                            }
                                            let _e1238 = phi_1452_;
                                            phi_1453_ = _e1238;
                                        }
                                        let _e1240 = phi_1453_;
                                        let _e1242 = triangles.member[(0u + _e1005)].v2_;
                                        let _e1244 = triangles.member[(0u + _e1005)].v0_;
                                        let _e1247 = (_e1242.x - _e1244.x);
                                        let _e1250 = (_e1242.y - _e1244.y);
                                        let _e1253 = (_e1242.z - _e1244.z);
                                        if (_e380 == 0u) {
                                            phi_1479_ = vec3<f32>(_e1250, _e1253, _e1247);
                                        } else {
                                            if (_e380 == 1u) {
                                                phi_1478_ = vec3<f32>(_e1253, _e1247, _e1250);
                                            } else {
                                                phi_1478_ = (_e1242 - _e1244);
                                            }
                                            let _e1260 = phi_1478_;
                                            phi_1479_ = _e1260;
                                        }
                                        let _e1262 = phi_1479_;
                                        let _e1269 = ((_e1240.y * _e1262.z) - (_e1240.z * _e1262.y));
                                        let _e1276 = ((_e1240.z * _e1262.x) - (_e1240.x * _e1262.z));
                                        let _e1283 = ((_e1240.x * _e1262.y) - (_e1240.y * _e1262.x));
                                        let _e1297 = (((1f / _e394.z) * (((_e1269 * _e1218.x) + (_e1276 * _e1218.y)) + (_e1283 * _e1218.z))) / (((_e1269 * _e397) + (_e1276 * _e400)) + _e1283));
                                        if (_e1297 > _e146.tmin) {
                                            if (_e1297 < _e146.tmax) {
                                                let _e1303 = triangles.member[(0u + _e1005)].v0_;
                                                let _e1305 = triangles.member[(0u + _e1005)].v1_;
                                                if (_e1303.x < _e1305.x) {
                                                    phi_1537_ = _e1303.x;
                                                } else {
                                                    phi_1537_ = _e1305.x;
                                                }
                                                let _e1312 = phi_1537_;
                                                if (_e1303.y < _e1305.y) {
                                                    phi_1546_ = _e1303.y;
                                                } else {
                                                    phi_1546_ = _e1305.y;
                                                }
                                                let _e1319 = phi_1546_;
                                                if (_e1303.z < _e1305.z) {
                                                    phi_1555_ = _e1303.z;
                                                } else {
                                                    phi_1555_ = _e1305.z;
                                                }
                                                let _e1326 = phi_1555_;
                                                let _e1328 = triangles.member[(0u + _e1005)].v2_;
                                                if (_e1312 < _e1328.x) {
                                                    phi_1564_ = _e1312;
                                                } else {
                                                    phi_1564_ = _e1328.x;
                                                }
                                                let _e1333 = phi_1564_;
                                                if (_e1319 < _e1328.y) {
                                                    phi_1571_ = _e1319;
                                                } else {
                                                    phi_1571_ = _e1328.y;
                                                }
                                                let _e1338 = phi_1571_;
                                                if (_e1326 < _e1328.z) {
                                                    phi_1578_ = _e1326;
                                                } else {
                                                    phi_1578_ = _e1328.z;
                                                }
                                                let _e1343 = phi_1578_;
                                                let _e1345 = triangles.member[(0u + _e1005)].v0_;
                                                let _e1347 = triangles.member[(0u + _e1005)].v1_;
                                                if (_e1345.x > _e1347.x) {
                                                    phi_1591_ = _e1345.x;
                                                } else {
                                                    phi_1591_ = _e1347.x;
                                                }
                                                let _e1354 = phi_1591_;
                                                if (_e1345.y > _e1347.y) {
                                                    phi_1600_ = _e1345.y;
                                                } else {
                                                    phi_1600_ = _e1347.y;
                                                }
                                                let _e1361 = phi_1600_;
                                                if (_e1345.z > _e1347.z) {
                                                    phi_1609_ = _e1345.z;
                                                } else {
                                                    phi_1609_ = _e1347.z;
                                                }
                                                let _e1368 = phi_1609_;
                                                let _e1370 = triangles.member[(0u + _e1005)].v2_;
                                                if (_e1354 > _e1370.x) {
                                                    phi_1618_ = _e1354;
                                                } else {
                                                    phi_1618_ = _e1370.x;
                                                }
                                                let _e1375 = phi_1618_;
                                                if (_e1361 > _e1370.y) {
                                                    phi_1625_ = _e1361;
                                                } else {
                                                    phi_1625_ = _e1370.y;
                                                }
                                                let _e1380 = phi_1625_;
                                                if (_e1368 > _e1370.z) {
                                                    phi_1632_ = _e1368;
                                                } else {
                                                    phi_1632_ = _e1370.z;
                                                }
                                                let _e1385 = phi_1632_;
                                                let _e1392 = ((_e1333 - _e146.origin.x) * _e292);
                                                let _e1393 = ((_e1338 - _e146.origin.y) * _e303);
                                                let _e1394 = ((_e1343 - _e146.origin.z) * _e314);
                                                let _e1401 = ((_e1375 - _e146.origin.x) * _e292);
                                                let _e1402 = ((_e1380 - _e146.origin.y) * _e303);
                                                let _e1403 = ((_e1385 - _e146.origin.z) * _e314);
                                                if (_e1392 < _e1401) {
                                                    phi_1655_ = _e1392;
                                                } else {
                                                    phi_1655_ = _e1401;
                                                }
                                                let _e1406 = phi_1655_;
                                                if (_e1393 < _e1402) {
                                                    phi_1660_ = _e1393;
                                                } else {
                                                    phi_1660_ = _e1402;
                                                }
                                                let _e1409 = phi_1660_;
                                                if (_e1394 < _e1403) {
                                                    phi_1665_ = _e1394;
                                                } else {
                                                    phi_1665_ = _e1403;
                                                }
                                                let _e1412 = phi_1665_;
                                                if (_e1392 > _e1401) {
                                                    phi_1673_ = _e1392;
                                                } else {
                                                    phi_1673_ = _e1401;
                                                }
                                                let _e1418 = phi_1673_;
                                                if (_e1393 > _e1402) {
                                                    phi_1678_ = _e1393;
                                                } else {
                                                    phi_1678_ = _e1402;
                                                }
                                                let _e1421 = phi_1678_;
                                                if (_e1394 > _e1403) {
                                                    phi_1683_ = _e1394;
                                                } else {
                                                    phi_1683_ = _e1403;
                                                }
                                                let _e1424 = phi_1683_;
                                                let _e1428 = core_intrinsics_maximum_number_nsz_f32_((_e1406 - _e359), (_e1409 - _e360));
                                                let _e1429 = core_intrinsics_maximum_number_nsz_f32_(_e1428, (_e1412 - _e361));
                                                let _e1430 = core_intrinsics_minimum_number_nsz_f32_((_e1418 + _e359), (_e1421 + _e360));
                                                let _e1431 = core_intrinsics_minimum_number_nsz_f32_(_e1430, (_e1424 + _e361));
                                                if (_e1429 > -300000000000000000000000000000000000000f) {
                                                    phi_1695_ = _e1429;
                                                } else {
                                                    phi_1695_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1434 = phi_1695_;
                                                if (_e1431 < 300000000000000000000000000000000000000f) {
                                                    phi_1700_ = _e1431;
                                                } else {
                                                    phi_1700_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1437 = phi_1700_;
                                                if (_e1297 < _e1434) {
                                                    phi_1705_ = _e1434;
                                                } else {
                                                    phi_1705_ = _e1297;
                                                }
                                                let _e1440 = phi_1705_;
                                                if (_e1440 > _e1437) {
                                                    phi_1710_ = _e1437;
                                                } else {
                                                    phi_1710_ = _e1440;
                                                }
                                                let _e1443 = phi_1710_;
                                                phi_1715_ = lt_bvh_triangle_Intersection(_e1443, (_e1136 / _e1195), (_e1157 / _e1195), (_e1434 <= _e1437));
                                                phi_1716_ = false;
                                            } else {
                                                phi_1715_ = lt_bvh_triangle_Intersection();
                                                phi_1716_ = true;
                                            }
                                            let _e1449 = phi_1715_;
                                            let _e1451 = phi_1716_;
                                            phi_1717_ = _e1449;
                                            phi_1718_ = _e1451;
                                        } else {
                                            phi_1717_ = lt_bvh_triangle_Intersection();
                                            phi_1718_ = true;
                                        }
                                        let _e1453 = phi_1717_;
                                        let _e1455 = phi_1718_;
                                        if _e1455 {
                                        }
                                        phi_1722_ = _e1453;
                                        phi_1723_ = _e1455;
                                    }
                                    let _e1457 = phi_1722_;
                                    let _e1459 = phi_1723_;
                                    phi_1724_ = _e1457;
                                    phi_1725_ = _e1198;
                                    phi_1726_ = _e1459;
                                } else {
                                    phi_1724_ = lt_bvh_triangle_Intersection();
                                    phi_1725_ = true;
                                    phi_1726_ = false;
                                }
                                let _e1461 = phi_1724_;
                                let _e1463 = phi_1725_;
                                let _e1465 = phi_1726_;
                                if _e1463 {
                                    phi_1730_ = true;
                                } else {
                                    phi_1730_ = _e1465;
                                }
                                let _e1467 = phi_1730_;
                                if _e1467 {
                                    phi_1734_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1734_ = _e1461;
                                }
                                let _e1469 = phi_1734_;
                                if _e1469.is_hit {
                                    if (_e1469.t > _e146.tmin) {
                                        if (_e1469.t < _e994.t) {
                                            phi_1783_ = true;
                                        } else {
                                            if (_e1469.t == _e994.t) {
                                                if (_e994.triangle != 4294967295u) {
                                                    if (_e1005 < _e994.triangle) {
                                                        phi_1774_ = true;
                                                    } else {
                                                        if (_e1005 == _e994.triangle) {
                                                            phi_1773_ = (4294967295u < _e994.instance);
                                                        } else {
                                                            phi_1773_ = false;
                                                        }
                                                        let _e1488 = phi_1773_;
                                                        phi_1774_ = _e1488;
                                                    }
                                                    let _e1490 = phi_1774_;
                                                    phi_1775_ = _e1490;
                                                    phi_1776_ = false;
                                                } else {
                                                    phi_1775_ = bool();
                                                    phi_1776_ = true;
                                                }
                                                let _e1492 = phi_1775_;
                                                let _e1494 = phi_1776_;
                                                phi_1777_ = _e1492;
                                                phi_1778_ = _e1494;
                                            } else {
                                                phi_1777_ = bool();
                                                phi_1778_ = true;
                                            }
                                            let _e1496 = phi_1777_;
                                            let _e1498 = phi_1778_;
                                            if _e1498 {
                                                phi_1782_ = false;
                                            } else {
                                                phi_1782_ = _e1496;
                                            }
                                            let _e1500 = phi_1782_;
                                            phi_1783_ = _e1500;
                                        }
                                        let _e1502 = phi_1783_;
                                        if _e1502 {
                                            let _e1504 = triangles.member[(0u + _e1005)].i0_;
                                            if ((_e1504 & 2147483648u) == 0u) {
                                                phi_1797_ = true;
                                            } else {
                                                if true {
                                                }
                                                phi_1797_ = true;
                                            }
                                            let _e1508 = phi_1797_;
                                            if _e1508 {
                                                phi_1805_ = lt_bvh_Hit(_e1469.t, _e1469.u, _e1469.v, _e1005, 4294967295u);
                                            } else {
                                                phi_1805_ = _e994;
                                            }
                                            let _e1514 = phi_1805_;
                                            phi_1806_ = _e1514;
                                        } else {
                                            phi_1806_ = _e994;
                                        }
                                        let _e1516 = phi_1806_;
                                        phi_1807_ = _e1516;
                                    } else {
                                        phi_1807_ = _e994;
                                    }
                                    let _e1518 = phi_1807_;
                                    phi_1808_ = _e1518;
                                } else {
                                    phi_1808_ = _e994;
                                }
                                let _e1520 = phi_1808_;
                                phi_1148_ = _e1520;
                                phi_1151_ = (_e996 & (_e996 - 1u));
                                phi_1809_ = true;
                            }
                            let _e1522 = phi_1148_;
                            let _e1524 = phi_1151_;
                            let _e1526 = phi_1809_;
                            continue;
                            continuing {
                                phi_1147_ = _e1522;
                                phi_1150_ = _e1524;
                                break if !(_e1526);
                            }
                        }
                        let _e1529 = local.group_mask;
                        if ((_e1529 & 4278190080u) == 0u) {
                            let _e1533 = local.len;
                            if (_e1533 == 0u) {
                                phi_1848_ = false;
                            } else {
                                let _e1537 = local.len;
                                local.len = (_e1537 - 1u);
                                let _e1540 = local.len;
                                if (_e1540 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1545 = local.first[(0u + _e1540)];
                                local.group = _e1545;
                                let _e1548 = local.len;
                                if (_e1548 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1553 = local.mask[(0u + _e1548)];
                                local.group_mask = _e1553;
                                phi_1848_ = true;
                            }
                            let _e1556 = phi_1848_;
                            phi_1849_ = _e1556;
                        } else {
                            phi_1849_ = true;
                        }
                        let _e1558 = phi_1849_;
                        if _e1558 {
                            let _e1560 = local.group_mask;
                            let _e1566 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1560)), 32u, (_e1560 == 0u)));
                            let _e1570 = local.group_mask;
                            let _e1584 = local.group_mask;
                            local.group_mask = (_e1584 & ~((1u << bitcast<u32>((_e1566 & 31u)))));
                            let _e1587 = local.group;
                            phi_1880_ = (_e1587 + countOneBits(((_e1570 & ~((4294967295u << bitcast<u32>((((_e1566 - 24u) ^ _e413) & 31u))))) & 255u)));
                        } else {
                            phi_1880_ = 4294967295u;
                        }
                        let _e1590 = phi_1880_;
                        let _e2364 = local_4;
                        phi_811_ = _e2364;
                        phi_814_ = _e1590;
                    } else {
                        phi_811_ = lt_bvh_Hit();
                        phi_814_ = u32();
                    }
                    let _e1592 = phi_811_;
                    let _e1594 = phi_814_;
                    continue;
                    continuing {
                        phi_810_ = _e1592;
                        phi_813_ = _e1594;
                        break if !(_e554);
                    }
                }
                let _e2368 = local_5;
                phi_1881_ = _e2368;
            }
            let _e1597 = phi_1881_;
            phi_1882_ = _e1597;
            phi_1883_ = _e210;
        } else {
            phi_1882_ = lt_bvh_Hit();
            phi_1883_ = true;
        }
        let _e1599 = phi_1882_;
        let _e1601 = phi_1883_;
        if _e1601 {
            phi_1887_ = _e148;
        } else {
            phi_1887_ = _e1599;
        }
        let _e1603 = phi_1887_;
        if (_e1603.triangle != 4294967295u) {
            let _e1609 = ((1f - _e1603.u) - _e1603.v);
            if (_e1603.triangle < _e70) {
            } else {
                return;
            }
            let _e1615 = triangles.member[(0u + _e1603.triangle)];
            let _e1640 = (((_e1615.v0_.x * _e1609) + (_e1615.v1_.x * _e1603.u)) + (_e1615.v2_.x * _e1603.v));
            let _e1641 = (((_e1615.v0_.y * _e1609) + (_e1615.v1_.y * _e1603.u)) + (_e1615.v2_.y * _e1603.v));
            let _e1642 = (((_e1615.v0_.z * _e1609) + (_e1615.v1_.z * _e1603.u)) + (_e1615.v2_.z * _e1603.v));
            let _e1645 = abs(_e1615.v0_.x);
            let _e1647 = abs(_e1615.v0_.y);
            let _e1649 = abs(_e1615.v0_.z);
            let _e1651 = abs(_e1615.v1_.x);
            let _e1653 = abs(_e1615.v1_.y);
            let _e1655 = abs(_e1615.v1_.z);
            if (_e1645 > _e1651) {
                phi_1952_ = _e1645;
            } else {
                phi_1952_ = _e1651;
            }
            let _e1658 = phi_1952_;
            if (_e1647 > _e1653) {
                phi_1957_ = _e1647;
            } else {
                phi_1957_ = _e1653;
            }
            let _e1661 = phi_1957_;
            if (_e1649 > _e1655) {
                phi_1962_ = _e1649;
            } else {
                phi_1962_ = _e1655;
            }
            let _e1664 = phi_1962_;
            let _e1666 = abs(_e1615.v2_.x);
            let _e1668 = abs(_e1615.v2_.y);
            let _e1670 = abs(_e1615.v2_.z);
            if (_e1658 > _e1666) {
                phi_1973_ = _e1658;
            } else {
                phi_1973_ = _e1666;
            }
            let _e1673 = phi_1973_;
            if (_e1661 > _e1668) {
                phi_1978_ = _e1661;
            } else {
                phi_1978_ = _e1668;
            }
            let _e1676 = phi_1978_;
            if (_e1664 > _e1670) {
                phi_1983_ = _e1664;
            } else {
                phi_1983_ = _e1670;
            }
            let _e1679 = phi_1983_;
            let _e1682 = (_e1615.v1_.x - _e1615.v0_.x);
            let _e1685 = (_e1615.v1_.y - _e1615.v0_.y);
            let _e1688 = (_e1615.v1_.z - _e1615.v0_.z);
            let _e1691 = (_e1615.v2_.x - _e1615.v0_.x);
            let _e1694 = (_e1615.v2_.y - _e1615.v0_.y);
            let _e1697 = (_e1615.v2_.z - _e1615.v0_.z);
            let _e1701 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1685), abs(_e1688));
            let _e1702 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1682), _e1701);
            let _e1703 = (_e1682 / _e1702);
            let _e1704 = (_e1685 / _e1702);
            let _e1705 = (_e1688 / _e1702);
            let _e1709 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1694), abs(_e1697));
            let _e1710 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1691), _e1709);
            let _e1711 = (_e1691 / _e1710);
            let _e1712 = (_e1694 / _e1710);
            let _e1713 = (_e1697 / _e1710);
            let _e1716 = ((_e1704 * _e1713) - (_e1712 * _e1705));
            let _e1719 = ((_e1705 * _e1711) - (_e1713 * _e1703));
            let _e1722 = ((_e1703 * _e1712) - (_e1711 * _e1704));
            let _e1724 = p.member.eye;
            let _e1737 = (1f / sqrt((((_e1716 * _e1716) + (_e1719 * _e1719)) + (_e1722 * _e1722))));
            let _e1738 = (_e1716 * _e1737);
            let _e1739 = (_e1719 * _e1737);
            let _e1740 = (_e1722 * _e1737);
            if ((((_e1738 * (_e1724.x - _e1640)) + (_e1739 * (_e1724.y - _e1641))) + (_e1740 * (_e1724.z - _e1642))) < 0f) {
                phi_2059_ = vec3<f32>(-(_e1738), -(_e1739), -(_e1740));
            } else {
                phi_2059_ = vec3<f32>(_e1738, _e1739, _e1740);
            }
            let _e1753 = phi_2059_;
            if (_e1603.triangle < _e70) {
            } else {
                return;
            }
            let _e1758 = triangles.member[(0u + _e1603.triangle)];
            let _e1760 = (_e1758.i0_ & 2147483647u);
            if (_e1760 < _e73) {
            } else {
                return;
            }
            let _e1766 = vertices.member[(0u + _e1760)];
            if (_e1758.i1_ < _e73) {
            } else {
                return;
            }
            let _e1770 = vertices.member[(0u + _e1758.i1_)];
            if (_e1758.i2_ < _e73) {
            } else {
                return;
            }
            let _e1774 = vertices.member[(0u + _e1758.i2_)];
            let _e1775 = array<abi_Vertex, 3>(_e1766, _e1770, _e1774);
            if (_e1775[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e1781 = materials.member[(0u + _e1775[0].material)];
            let _e1798 = (1f / 255f);
            let _e1817 = (1f / 255f);
            let _e1839 = (1f / 255f);
            let _e1852 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e1609, _e1603.u, _e1603.v));
            let _e1854 = ((_e1781.base_color.x * ((((f32((_e1775[0].color & 255u)) * _e1798) * _e1609) + ((f32((_e1775[1].color & 255u)) * _e1817) * _e1603.u)) + ((f32((_e1775[2].color & 255u)) * _e1839) * _e1603.v))) * _e1852.x);
            let _e1856 = ((_e1781.base_color.y * ((((f32(((_e1775[0].color >> bitcast<u32>(8i)) & 255u)) * _e1798) * _e1609) + ((f32(((_e1775[1].color >> bitcast<u32>(8i)) & 255u)) * _e1817) * _e1603.u)) + ((f32(((_e1775[2].color >> bitcast<u32>(8i)) & 255u)) * _e1839) * _e1603.v))) * _e1852.y);
            let _e1858 = ((_e1781.base_color.z * ((((f32(((_e1775[0].color >> bitcast<u32>(16i)) & 255u)) * _e1798) * _e1609) + ((f32(((_e1775[1].color >> bitcast<u32>(16i)) & 255u)) * _e1817) * _e1603.u)) + ((f32(((_e1775[2].color >> bitcast<u32>(16i)) & 255u)) * _e1839) * _e1603.v))) * _e1852.z);
            let _e1859 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1676, _e1679);
            let _e1860 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1673, _e1859);
            if ((_e1781.flags & 2u) == 0u) {
                phi_2180_ = 0u;
            } else {
                phi_2180_ = 1u;
            }
            let _e1865 = phi_2180_;
            if (_e1775[0].normal == 2147516416u) {
                phi_2383_ = _e1753;
            } else {
                let _e1878 = (f32((bitcast<i32>((_e1775[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1884 = (f32((bitcast<i32>(_e1775[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1888 = ((1f - abs(_e1878)) - abs(_e1884));
                if (_e1888 < 0f) {
                    phi_2207_ = -(_e1888);
                } else {
                    phi_2207_ = 0f;
                }
                let _e1892 = phi_2207_;
                if (_e1878 < 0f) {
                    phi_2214_ = (_e1878 + _e1892);
                } else {
                    phi_2214_ = (_e1878 - _e1892);
                }
                let _e1897 = phi_2214_;
                if (_e1884 < 0f) {
                    phi_2221_ = (_e1884 + _e1892);
                } else {
                    phi_2221_ = (_e1884 - _e1892);
                }
                let _e1902 = phi_2221_;
                let _e1909 = (1f / sqrt((((_e1897 * _e1897) + (_e1902 * _e1902)) + (_e1888 * _e1888))));
                let _e1925 = (f32((bitcast<i32>((_e1775[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1931 = (f32((bitcast<i32>(_e1775[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1935 = ((1f - abs(_e1925)) - abs(_e1931));
                if (_e1935 < 0f) {
                    phi_2256_ = -(_e1935);
                } else {
                    phi_2256_ = 0f;
                }
                let _e1939 = phi_2256_;
                if (_e1925 < 0f) {
                    phi_2263_ = (_e1925 + _e1939);
                } else {
                    phi_2263_ = (_e1925 - _e1939);
                }
                let _e1944 = phi_2263_;
                if (_e1931 < 0f) {
                    phi_2270_ = (_e1931 + _e1939);
                } else {
                    phi_2270_ = (_e1931 - _e1939);
                }
                let _e1949 = phi_2270_;
                let _e1956 = (1f / sqrt((((_e1944 * _e1944) + (_e1949 * _e1949)) + (_e1935 * _e1935))));
                let _e1975 = (f32((bitcast<i32>((_e1775[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1981 = (f32((bitcast<i32>(_e1775[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1985 = ((1f - abs(_e1975)) - abs(_e1981));
                if (_e1985 < 0f) {
                    phi_2308_ = -(_e1985);
                } else {
                    phi_2308_ = 0f;
                }
                let _e1989 = phi_2308_;
                if (_e1975 < 0f) {
                    phi_2315_ = (_e1975 + _e1989);
                } else {
                    phi_2315_ = (_e1975 - _e1989);
                }
                let _e1994 = phi_2315_;
                if (_e1981 < 0f) {
                    phi_2322_ = (_e1981 + _e1989);
                } else {
                    phi_2322_ = (_e1981 - _e1989);
                }
                let _e1999 = phi_2322_;
                let _e2006 = (1f / sqrt((((_e1994 * _e1994) + (_e1999 * _e1999)) + (_e1985 * _e1985))));
                let _e2017 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e1897 * _e1909) * _e1609) + ((_e1944 * _e1956) * _e1603.u)) + ((_e1994 * _e2006) * _e1603.v)), ((((_e1902 * _e1909) * _e1609) + ((_e1949 * _e1956) * _e1603.u)) + ((_e1999 * _e2006) * _e1603.v)), ((((_e1888 * _e1909) * _e1609) + ((_e1935 * _e1956) * _e1603.u)) + ((_e1985 * _e2006) * _e1603.v))));
                let _e2029 = sqrt((((_e2017.x * _e2017.x) + (_e2017.y * _e2017.y)) + (_e2017.z * _e2017.z)));
                if (_e2029 > 0f) {
                    let _e2032 = (_e2017.x / _e2029);
                    let _e2034 = (_e2017.y / _e2029);
                    let _e2036 = (_e2017.z / _e2029);
                    if ((((_e2032 * _e1753.x) + (_e2034 * _e1753.y)) + (_e2036 * _e1753.z)) < 0f) {
                        phi_2381_ = vec3<f32>(-(_e2032), -(_e2034), -(_e2036));
                    } else {
                        phi_2381_ = (_e2017 / vec3(_e2029));
                    }
                    let _e2053 = phi_2381_;
                    phi_2382_ = _e2053;
                } else {
                    phi_2382_ = _e1753;
                }
                let _e2055 = phi_2382_;
                phi_2383_ = _e2055;
            }
            let _e2057 = phi_2383_;
            if (_e1854 > 0f) {
                if (_e1854 < 1f) {
                    phi_2392_ = _e1854;
                } else {
                    phi_2392_ = 1f;
                }
                let _e2061 = phi_2392_;
                phi_2393_ = _e2061;
            } else {
                phi_2393_ = 0f;
            }
            let _e2063 = phi_2393_;
            if (_e1856 > 0f) {
                if (_e1856 < 1f) {
                    phi_2403_ = _e1856;
                } else {
                    phi_2403_ = 1f;
                }
                let _e2068 = phi_2403_;
                phi_2404_ = _e2068;
            } else {
                phi_2404_ = 0f;
            }
            let _e2070 = phi_2404_;
            if (_e1858 > 0f) {
                if (_e1858 < 1f) {
                    phi_2414_ = _e1858;
                } else {
                    phi_2414_ = 1f;
                }
                let _e2075 = phi_2414_;
                phi_2415_ = _e2075;
            } else {
                phi_2415_ = 0f;
            }
            let _e2077 = phi_2415_;
            let _e2080 = ((sqrt(_e2063) * 255f) + 0.5f);
            let _e2089 = ((sqrt(_e2070) * 255f) + 0.5f);
            let _e2101 = ((sqrt(_e2077) * 255f) + 0.5f);
            phi_2450_ = abi_Sample(vec3<f32>(_e1640, _e1641, _e1642), _e1860, _e1753, _e1865, _e2057, ((select(select(u32(_e2080), 0u, (_e2080 < bitcast<f32>(0u))), 4294967295u, (_e2080 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2089), 0u, (_e2089 < bitcast<f32>(0u))), 4294967295u, (_e2089 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2101), 0u, (_e2101 < bitcast<f32>(0u))), 4294967295u, (_e2101 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_2450_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2115 = phi_2450_;
        if (_e91.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e91.shift)] = _e2115;
        if (_e1603.triangle != 4294967295u) {
            let _e2124 = ((1f - _e1603.u) - _e1603.v);
            if (_e1603.triangle < _e70) {
            } else {
                return;
            }
            let _e2129 = triangles.member[(0u + _e1603.triangle)];
            let _e2131 = (_e2129.i0_ & 2147483647u);
            if (_e2131 < _e82) {
            } else {
                return;
            }
            let _e2137 = before.member[(0u + _e2131)];
            if (_e2129.i1_ < _e82) {
            } else {
                return;
            }
            let _e2141 = before.member[(0u + _e2129.i1_)];
            if (_e2129.i2_ < _e82) {
            } else {
                return;
            }
            let _e2145 = before.member[(0u + _e2129.i2_)];
            let _e2150 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2137.x, _e2137.y, _e2137.z));
            let _e2161 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2141.x, _e2141.y, _e2141.z));
            let _e2175 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_point_to_world(vec3<f32>(_e2145.x, _e2145.y, _e2145.z));
            phi_2541_ = vec3<f32>((((_e2150.x * _e2124) + (_e2161.x * _e1603.u)) + (_e2175.x * _e1603.v)), (((_e2150.y * _e2124) + (_e2161.y * _e1603.u)) + (_e2175.y * _e1603.v)), (((_e2150.z * _e2124) + (_e2161.z * _e1603.u)) + (_e2175.z * _e1603.v)));
        } else {
            phi_2541_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e2187 = phi_2541_;
        if (_e91.shift < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e91.shift)] = vec4<f32>(_e2187.x, _e2187.y, _e2187.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
