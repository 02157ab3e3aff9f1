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
    var phi_186_: lt_mask_LightPlace;
    var phi_187_: bool;
    var phi_188_: lt_mask_LightPlace;
    var phi_189_: bool;
    var phi_194_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_186_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_187_ = false;
        } else {
            phi_186_ = lt_mask_LightPlace();
            phi_187_ = true;
        }
        let _e73 = phi_186_;
        let _e75 = phi_187_;
        phi_188_ = _e73;
        phi_189_ = _e75;
    } else {
        phi_188_ = lt_mask_LightPlace();
        phi_189_ = true;
    }
    let _e77 = phi_188_;
    let _e79 = phi_189_;
    if _e79 {
        phi_194_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_194_ = _e77;
    }
    let _e84 = phi_194_;
    return lt_mask_LightPlace(_e84.word, _e84.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_209_: bool;
    var phi_213_: f32;

    if (param_3 != param_3) {
        phi_209_ = true;
    } else {
        let _e63 = (param_4 >= param_3);
        if _e63 {
        }
        phi_209_ = _e63;
    }
    let _e65 = phi_209_;
    if _e65 {
        phi_213_ = param_4;
    } else {
        phi_213_ = param_3;
    }
    let _e67 = phi_213_;
    return _e67;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_225_: bool;
    var phi_229_: f32;

    if (param_5 != param_5) {
        phi_225_ = true;
    } else {
        let _e63 = (param_6 <= param_5);
        if _e63 {
        }
        phi_225_ = _e63;
    }
    let _e65 = phi_225_;
    if _e65 {
        phi_229_ = param_6;
    } else {
        phi_229_ = param_5;
    }
    let _e67 = phi_229_;
    return _e67;
}

fn _lt_bvh_ray_Ray_new(param_7: vec3<f32>, param_8: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_7, 0f, param_8, 300000000000000000000000000000000000000f);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_9: f32, param_10: f32) -> f32 {
    var phi_241_: f32;

    if (param_9 > param_10) {
        phi_241_ = param_9;
    } else {
        phi_241_ = param_10;
    }
    let _e64 = phi_241_;
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
    var phi_357_: bool;
    var phi_358_: bool;
    var phi_359_: bool;
    var phi_360_: bool;
    var phi_364_: bool;
    var phi_377_: bool;
    var phi_378_: bool;
    var phi_379_: bool;
    var phi_380_: bool;
    var phi_384_: bool;
    var phi_397_: bool;
    var phi_398_: bool;
    var phi_399_: bool;
    var phi_403_: bool;
    var phi_404_: bool;
    var phi_405_: bool;
    var phi_406_: bool;
    var phi_407_: bool;
    var phi_411_: bool;
    var phi_487_: f32;
    var phi_494_: f32;
    var phi_502_: f32;
    var phi_509_: f32;
    var phi_517_: f32;
    var phi_524_: f32;
    var phi_547_: f32;
    var phi_552_: f32;
    var phi_557_: f32;
    var phi_562_: f32;
    var phi_567_: f32;
    var phi_598_: bool;
    var phi_599_: bool;
    var phi_607_: u32;
    var phi_608_: u32;
    var phi_625_: vec3<f32>;
    var phi_626_: vec3<f32>;
    var phi_639_: u32;
    var phi_644_: u32;
    var phi_649_: u32;
    var phi_763_: bool;
    var phi_764_: bool;
    var phi_795_: u32;
    var phi_797_: lt_bvh_Hit;
    var phi_800_: u32;
    var phi_885_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_912_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_939_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_945_: u32;
    var phi_948_: u32;
    var phi_962_: u32;
    var phi_972_: u32;
    var phi_982_: u32;
    var phi_1000_: u32;
    var phi_1010_: u32;
    var phi_1020_: u32;
    var phi_1056_: u32;
    var phi_1069_: u32;
    var phi_1074_: u32;
    var phi_1075_: u32;
    var phi_1076_: u32;
    var phi_946_: u32;
    var phi_949_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1134_: lt_bvh_Hit;
    var phi_1137_: u32;
    var phi_1183_: vec3<f32>;
    var phi_1184_: vec3<f32>;
    var phi_1215_: vec3<f32>;
    var phi_1216_: vec3<f32>;
    var phi_1247_: vec3<f32>;
    var phi_1248_: vec3<f32>;
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
    var phi_1413_: vec3<f32>;
    var phi_1414_: vec3<f32>;
    var phi_1439_: vec3<f32>;
    var phi_1440_: vec3<f32>;
    var phi_1465_: vec3<f32>;
    var phi_1466_: vec3<f32>;
    var phi_1524_: f32;
    var phi_1533_: f32;
    var phi_1542_: f32;
    var phi_1551_: f32;
    var phi_1558_: f32;
    var phi_1565_: f32;
    var phi_1578_: f32;
    var phi_1587_: f32;
    var phi_1596_: f32;
    var phi_1605_: f32;
    var phi_1612_: f32;
    var phi_1619_: f32;
    var phi_1642_: f32;
    var phi_1647_: f32;
    var phi_1652_: f32;
    var phi_1660_: f32;
    var phi_1665_: f32;
    var phi_1670_: f32;
    var phi_1682_: f32;
    var phi_1687_: f32;
    var phi_1692_: f32;
    var phi_1697_: f32;
    var phi_1702_: lt_bvh_triangle_Intersection;
    var phi_1703_: bool;
    var phi_1704_: lt_bvh_triangle_Intersection;
    var phi_1705_: bool;
    var phi_1709_: lt_bvh_triangle_Intersection;
    var phi_1710_: bool;
    var phi_1711_: lt_bvh_triangle_Intersection;
    var phi_1712_: bool;
    var phi_1713_: bool;
    var phi_1717_: bool;
    var phi_1721_: lt_bvh_triangle_Intersection;
    var phi_1760_: bool;
    var phi_1761_: bool;
    var phi_1762_: bool;
    var phi_1763_: bool;
    var phi_1764_: bool;
    var phi_1765_: bool;
    var phi_1769_: bool;
    var phi_1770_: bool;
    var phi_1784_: bool;
    var phi_1792_: lt_bvh_Hit;
    var phi_1793_: lt_bvh_Hit;
    var phi_1794_: lt_bvh_Hit;
    var phi_1795_: lt_bvh_Hit;
    var phi_1135_: lt_bvh_Hit;
    var phi_1138_: u32;
    var phi_1796_: bool;
    var phi_1835_: bool;
    var phi_1836_: bool;
    var phi_1867_: u32;
    var phi_798_: lt_bvh_Hit;
    var phi_801_: u32;
    var phi_1868_: lt_bvh_Hit;
    var phi_1869_: lt_bvh_Hit;
    var phi_1870_: bool;
    var phi_1874_: lt_bvh_Hit;
    var phi_1939_: f32;
    var phi_1944_: f32;
    var phi_1949_: f32;
    var phi_1960_: f32;
    var phi_1965_: f32;
    var phi_1970_: f32;
    var phi_2046_: vec3<f32>;
    var phi_2167_: u32;
    var phi_2194_: f32;
    var phi_2201_: f32;
    var phi_2208_: f32;
    var phi_2243_: f32;
    var phi_2250_: f32;
    var phi_2257_: f32;
    var phi_2295_: f32;
    var phi_2302_: f32;
    var phi_2309_: f32;
    var phi_2368_: vec3<f32>;
    var phi_2369_: vec3<f32>;
    var phi_2370_: vec3<f32>;
    var phi_2379_: f32;
    var phi_2380_: f32;
    var phi_2390_: f32;
    var phi_2391_: f32;
    var phi_2401_: f32;
    var phi_2402_: f32;
    var phi_2437_: abi_Sample;
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
        let _e143 = abs(_e138.direction.x);
        let _e145 = abs(_e138.direction.y);
        let _e147 = abs(_e138.direction.z);
        if (abs(_e138.origin.x) < 1000000000000000f) {
            if (abs(_e138.origin.y) < 1000000000000000f) {
                phi_357_ = (abs(_e138.origin.z) < 1000000000000000f);
                phi_358_ = false;
            } else {
                phi_357_ = bool();
                phi_358_ = true;
            }
            let _e159 = phi_357_;
            let _e161 = phi_358_;
            phi_359_ = _e159;
            phi_360_ = _e161;
        } else {
            phi_359_ = bool();
            phi_360_ = true;
        }
        let _e163 = phi_359_;
        let _e165 = phi_360_;
        if _e165 {
            phi_364_ = false;
        } else {
            phi_364_ = _e163;
        }
        let _e167 = phi_364_;
        if _e167 {
            if (_e143 < 1000000000000000f) {
                if (_e145 < 1000000000000000f) {
                    phi_377_ = (_e147 < 1000000000000000f);
                    phi_378_ = false;
                } else {
                    phi_377_ = bool();
                    phi_378_ = true;
                }
                let _e172 = phi_377_;
                let _e174 = phi_378_;
                phi_379_ = _e172;
                phi_380_ = _e174;
            } else {
                phi_379_ = bool();
                phi_380_ = true;
            }
            let _e176 = phi_379_;
            let _e178 = phi_380_;
            if _e178 {
                phi_384_ = false;
            } else {
                phi_384_ = _e176;
            }
            let _e180 = phi_384_;
            if _e180 {
                if (_e143 > 0f) {
                    phi_398_ = bool();
                    phi_399_ = true;
                } else {
                    let _e182 = (_e145 > 0f);
                    if _e182 {
                        phi_397_ = bool();
                    } else {
                        phi_397_ = (_e147 > 0f);
                    }
                    let _e185 = phi_397_;
                    phi_398_ = _e185;
                    phi_399_ = _e182;
                }
                let _e187 = phi_398_;
                let _e189 = phi_399_;
                if _e189 {
                    phi_403_ = true;
                } else {
                    phi_403_ = _e187;
                }
                let _e191 = phi_403_;
                phi_404_ = _e191;
                phi_405_ = false;
            } else {
                phi_404_ = bool();
                phi_405_ = true;
            }
            let _e193 = phi_404_;
            let _e195 = phi_405_;
            phi_406_ = _e193;
            phi_407_ = _e195;
        } else {
            phi_406_ = bool();
            phi_407_ = true;
        }
        let _e197 = phi_406_;
        let _e199 = phi_407_;
        if _e199 {
            phi_411_ = false;
        } else {
            phi_411_ = _e197;
        }
        let _e201 = phi_411_;
        if _e201 {
            let _e202 = (0u >= _e65);
            if _e202 {
                phi_1868_ = lt_bvh_Hit();
            } else {
                if (0u < _e65) {
                } else {
                    return;
                }
                let _e208 = nodes.member[(0u + 0u)].frame[0u];
                let _e212 = nodes.member[(0u + 0u)].frame[1u];
                let _e216 = nodes.member[(0u + 0u)].frame[2u];
                let _e220 = nodes.member[(0u + 0u)].frame[0u];
                let _e224 = nodes.member[(0u + 0u)].frame[1u];
                let _e228 = nodes.member[(0u + 0u)].frame[2u];
                let _e232 = nodes.member[(0u + 0u)].frame[3u];
                let _e271 = core_intrinsics_maximum_number_nsz_f32_(abs(_e138.direction.x), abs(_e138.direction.y));
                let _e272 = core_intrinsics_maximum_number_nsz_f32_(_e271, abs(_e138.direction.z));
                let _e273 = (_e272 * 0.0000000000009094947f);
                if (abs(_e138.direction.x) < _e273) {
                    phi_487_ = _e273;
                } else {
                    phi_487_ = abs(_e138.direction.x);
                }
                let _e279 = phi_487_;
                if (_e138.direction.x < 0f) {
                    phi_494_ = (-1f / _e279);
                } else {
                    phi_494_ = (1f / _e279);
                }
                let _e284 = phi_494_;
                if (abs(_e138.direction.y) < _e273) {
                    phi_502_ = _e273;
                } else {
                    phi_502_ = abs(_e138.direction.y);
                }
                let _e290 = phi_502_;
                if (_e138.direction.y < 0f) {
                    phi_509_ = (-1f / _e290);
                } else {
                    phi_509_ = (1f / _e290);
                }
                let _e295 = phi_509_;
                if (abs(_e138.direction.z) < _e273) {
                    phi_517_ = _e273;
                } else {
                    phi_517_ = abs(_e138.direction.z);
                }
                let _e301 = phi_517_;
                if (_e138.direction.z < 0f) {
                    phi_524_ = (-1f / _e301);
                } else {
                    phi_524_ = (1f / _e301);
                }
                let _e306 = phi_524_;
                let _e313 = abs((bitcast<f32>(_e208) - _e138.origin.x));
                let _e314 = abs((bitcast<f32>(_e212) - _e138.origin.y));
                let _e315 = abs((bitcast<f32>(_e216) - _e138.origin.z));
                let _e322 = abs(((bitcast<f32>(_e220) + (bitcast<f32>((((_e232 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e138.origin.x));
                let _e323 = abs(((bitcast<f32>(_e224) + (bitcast<f32>((((_e232 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e138.origin.y));
                let _e324 = abs(((bitcast<f32>(_e228) + (bitcast<f32>((((_e232 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e138.origin.z));
                if (_e313 > _e322) {
                    phi_547_ = _e313;
                } else {
                    phi_547_ = _e322;
                }
                let _e327 = phi_547_;
                if (_e314 > _e323) {
                    phi_552_ = _e314;
                } else {
                    phi_552_ = _e323;
                }
                let _e330 = phi_552_;
                if (_e315 > _e324) {
                    phi_557_ = _e315;
                } else {
                    phi_557_ = _e324;
                }
                let _e333 = phi_557_;
                if (_e327 > _e330) {
                    phi_562_ = _e327;
                } else {
                    phi_562_ = _e330;
                }
                let _e336 = phi_562_;
                if (_e336 > _e333) {
                    phi_567_ = _e336;
                } else {
                    phi_567_ = _e333;
                }
                let _e339 = phi_567_;
                let _e343 = (_e339 * 0.0000019073486f);
                let _e344 = (abs(_e284) * _e343);
                let _e345 = (abs(_e295) * _e343);
                let _e346 = (abs(_e306) * _e343);
                let _e350 = (_e339 * 0.0000009536743f);
                let _e351 = (abs(_e284) * _e350);
                let _e352 = (abs(_e295) * _e350);
                let _e353 = (abs(_e306) * _e350);
                let _e357 = abs(_e138.direction.x);
                let _e359 = abs(_e138.direction.y);
                let _e361 = abs(_e138.direction.z);
                if (_e357 >= _e359) {
                    if (_e357 >= _e361) {
                        phi_598_ = false;
                    } else {
                        phi_598_ = true;
                    }
                    let _e365 = phi_598_;
                    phi_599_ = _e365;
                } else {
                    phi_599_ = true;
                }
                let _e367 = phi_599_;
                if _e367 {
                    if (_e359 >= _e361) {
                        phi_607_ = 1u;
                    } else {
                        phi_607_ = 2u;
                    }
                    let _e370 = phi_607_;
                    phi_608_ = _e370;
                } else {
                    phi_608_ = 0u;
                }
                let _e372 = phi_608_;
                if (_e372 == 0u) {
                    phi_626_ = vec3<f32>(_e138.direction.y, _e138.direction.z, _e138.direction.x);
                } else {
                    if (_e372 == 1u) {
                        phi_625_ = vec3<f32>(_e138.direction.z, _e138.direction.x, _e138.direction.y);
                    } else {
                        phi_625_ = _e138.direction;
                    }
                    let _e384 = phi_625_;
                    phi_626_ = _e384;
                }
                let _e386 = phi_626_;
                let _e389 = (_e386.x / _e386.z);
                let _e392 = (_e386.y / _e386.z);
                if (_e284 < 0f) {
                    phi_639_ = 0u;
                } else {
                    phi_639_ = 1u;
                }
                let _e397 = phi_639_;
                if (_e295 < 0f) {
                    phi_644_ = 0u;
                } else {
                    phi_644_ = 2u;
                }
                let _e400 = phi_644_;
                if (_e306 < 0f) {
                    phi_649_ = 0u;
                } else {
                    phi_649_ = 4u;
                }
                let _e403 = phi_649_;
                let _e405 = ((_e397 | _e400) | _e403);
                let _e406 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local = lt_bvh_traverse_Stack(array<u32, 32>(_e406.first[0], _e406.first[1], _e406.first[2], _e406.first[3], _e406.first[4], _e406.first[5], _e406.first[6], _e406.first[7], _e406.first[8], _e406.first[9], _e406.first[10], _e406.first[11], _e406.first[12], _e406.first[13], _e406.first[14], _e406.first[15], _e406.first[16], _e406.first[17], _e406.first[18], _e406.first[19], _e406.first[20], _e406.first[21], _e406.first[22], _e406.first[23], _e406.first[24], _e406.first[25], _e406.first[26], _e406.first[27], _e406.first[28], _e406.first[29], _e406.first[30], _e406.first[31]), array<u32, 32>(_e406.mask[0], _e406.mask[1], _e406.mask[2], _e406.mask[3], _e406.mask[4], _e406.mask[5], _e406.mask[6], _e406.mask[7], _e406.mask[8], _e406.mask[9], _e406.mask[10], _e406.mask[11], _e406.mask[12], _e406.mask[13], _e406.mask[14], _e406.mask[15], _e406.mask[16], _e406.mask[17], _e406.mask[18], _e406.mask[19], _e406.mask[20], _e406.mask[21], _e406.mask[22], _e406.mask[23], _e406.mask[24], _e406.mask[25], _e406.mask[26], _e406.mask[27], _e406.mask[28], _e406.mask[29], _e406.mask[30], _e406.mask[31]), _e406.len, _e406.group, _e406.group_mask);
                let _e480 = local.group_mask;
                if ((_e480 & 4278190080u) == 0u) {
                    let _e484 = local.len;
                    if (_e484 == 0u) {
                        phi_763_ = false;
                    } else {
                        let _e488 = local.len;
                        local.len = (_e488 - 1u);
                        let _e491 = local.len;
                        if (_e491 < 32u) {
                        } else {
                            return;
                        }
                        let _e496 = local.first[(0u + _e491)];
                        local.group = _e496;
                        let _e499 = local.len;
                        if (_e499 < 32u) {
                        } else {
                            return;
                        }
                        let _e504 = local.mask[(0u + _e499)];
                        local.group_mask = _e504;
                        phi_763_ = true;
                    }
                    let _e507 = phi_763_;
                    phi_764_ = _e507;
                } else {
                    phi_764_ = true;
                }
                let _e509 = phi_764_;
                if _e509 {
                    let _e511 = local.group_mask;
                    let _e517 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e511)), 32u, (_e511 == 0u)));
                    let _e521 = local.group_mask;
                    let _e535 = local.group_mask;
                    local.group_mask = (_e535 & ~((1u << bitcast<u32>((_e517 & 31u)))));
                    let _e538 = local.group;
                    phi_795_ = (_e538 + countOneBits(((_e521 & ~((4294967295u << bitcast<u32>((((_e517 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_795_ = 4294967295u;
                }
                let _e541 = phi_795_;
                phi_797_ = _e140;
                phi_800_ = _e541;
                loop {
                    let _e543 = phi_797_;
                    let _e545 = phi_800_;
                    local_5 = _e543;
                    let _e546 = (_e545 != 4294967295u);
                    if _e546 {
                        if (_e545 < _e65) {
                        } else {
                            return;
                        }
                        let _e554 = nodes.member[(0u + _e545)].frame[3u];
                        let _e579 = (bitcast<f32>((((_e554 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e284);
                        let _e580 = (bitcast<f32>((((_e554 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e295);
                        let _e581 = (bitcast<f32>((((_e554 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e306);
                        let _e584 = nodes.member[(0u + _e545)].frame[0u];
                        let _e588 = nodes.member[(0u + _e545)].frame[1u];
                        let _e592 = nodes.member[(0u + _e545)].frame[2u];
                        let _e600 = ((bitcast<f32>(_e584) - _e138.origin.x) * _e284);
                        let _e601 = ((bitcast<f32>(_e588) - _e138.origin.y) * _e295);
                        let _e602 = ((bitcast<f32>(_e592) - _e138.origin.z) * _e306);
                        let _e610 = nodes.member[(0u + _e545)].x;
                        if (_e284 < 0f) {
                            let _e621 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e610.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e627 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e621.unnamed.word, _e610.w), _e621.unnamed_1);
                            let _e633 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e627.unnamed, lt_mask_LightPlace(_e610.x, _e627.unnamed_1.shift));
                            phi_885_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e633.unnamed, lt_mask_LightPlace(_e633.unnamed_1.word, _e610.y));
                        } else {
                            let _e649 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e610.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e655 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e649.unnamed.word, _e610.y), _e649.unnamed_1);
                            let _e661 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e655.unnamed, lt_mask_LightPlace(_e610.z, _e655.unnamed_1.shift));
                            phi_885_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e661.unnamed, lt_mask_LightPlace(_e661.unnamed_1.word, _e610.w));
                        }
                        let _e669 = phi_885_;
                        let _e679 = nodes.member[(0u + _e545)].y;
                        if (_e295 < 0f) {
                            let _e690 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e679.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e696 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e690.unnamed.word, _e679.w), _e690.unnamed_1);
                            let _e702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e696.unnamed, lt_mask_LightPlace(_e679.x, _e696.unnamed_1.shift));
                            phi_912_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e702.unnamed, lt_mask_LightPlace(_e702.unnamed_1.word, _e679.y));
                        } else {
                            let _e718 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e679.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e724 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e718.unnamed.word, _e679.y), _e718.unnamed_1);
                            let _e730 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e724.unnamed, lt_mask_LightPlace(_e679.z, _e724.unnamed_1.shift));
                            phi_912_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e730.unnamed, lt_mask_LightPlace(_e730.unnamed_1.word, _e679.w));
                        }
                        let _e738 = phi_912_;
                        let _e748 = nodes.member[(0u + _e545)].z;
                        if (_e306 < 0f) {
                            let _e759 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e748.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e765 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e759.unnamed.word, _e748.w), _e759.unnamed_1);
                            let _e771 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e765.unnamed, lt_mask_LightPlace(_e748.x, _e765.unnamed_1.shift));
                            phi_939_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e771.unnamed, lt_mask_LightPlace(_e771.unnamed_1.word, _e748.y));
                        } else {
                            let _e787 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e748.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e793 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e787.unnamed.word, _e748.y), _e787.unnamed_1);
                            let _e799 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e793.unnamed, lt_mask_LightPlace(_e748.z, _e793.unnamed_1.shift));
                            phi_939_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e799.unnamed, lt_mask_LightPlace(_e799.unnamed_1.word, _e748.w));
                        }
                        let _e807 = phi_939_;
                        phi_945_ = 0u;
                        phi_948_ = 0u;
                        loop {
                            let _e817 = phi_945_;
                            let _e819 = phi_948_;
                            local_1 = _e819;
                            local_2 = _e819;
                            local_3 = _e819;
                            let _e820 = (_e817 < 8u);
                            if _e820 {
                                let _e822 = (_e817 >> bitcast<u32>(2i));
                                let _e823 = (_e817 & 3u);
                                if (_e822 == 0u) {
                                    phi_962_ = _e669.unnamed.word;
                                } else {
                                    phi_962_ = _e669.unnamed.shift;
                                }
                                let _e826 = phi_962_;
                                if (_e822 == 0u) {
                                    phi_972_ = _e738.unnamed.word;
                                } else {
                                    phi_972_ = _e738.unnamed.shift;
                                }
                                let _e835 = phi_972_;
                                if (_e822 == 0u) {
                                    phi_982_ = _e807.unnamed.word;
                                } else {
                                    phi_982_ = _e807.unnamed.shift;
                                }
                                let _e844 = phi_982_;
                                let _e857 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e826 >> bitcast<u32>(((_e823 * 8u) & 31u))) & 255u)) * _e579) + (_e600 - _e344)), ((f32(((_e835 >> bitcast<u32>(((_e823 * 8u) & 31u))) & 255u)) * _e580) + (_e601 - _e345)));
                                let _e858 = core_intrinsics_maximum_number_nsz_f32_(_e857, ((f32(((_e844 >> bitcast<u32>(((_e823 * 8u) & 31u))) & 255u)) * _e581) + (_e602 - _e346)));
                                if (_e822 == 0u) {
                                    phi_1000_ = _e669.unnamed_1.word;
                                } else {
                                    phi_1000_ = _e669.unnamed_1.shift;
                                }
                                let _e861 = phi_1000_;
                                if (_e822 == 0u) {
                                    phi_1010_ = _e738.unnamed_1.word;
                                } else {
                                    phi_1010_ = _e738.unnamed_1.shift;
                                }
                                let _e870 = phi_1010_;
                                if (_e822 == 0u) {
                                    phi_1020_ = _e807.unnamed_1.word;
                                } else {
                                    phi_1020_ = _e807.unnamed_1.shift;
                                }
                                let _e879 = phi_1020_;
                                let _e892 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e861 >> bitcast<u32>(((_e823 * 8u) & 31u))) & 255u)) * _e579) + (_e600 + _e344)), ((f32(((_e870 >> bitcast<u32>(((_e823 * 8u) & 31u))) & 255u)) * _e580) + (_e601 + _e345)));
                                let _e893 = core_intrinsics_minimum_number_nsz_f32_(_e892, ((f32(((_e879 >> bitcast<u32>(((_e823 * 8u) & 31u))) & 255u)) * _e581) + (_e602 + _e346)));
                                if (_e858 <= _e893) {
                                    if (_e858 <= _e543.t) {
                                        if (_e893 >= _e138.tmin) {
                                            if (_e822 == 0u) {
                                                let _e900 = nodes.member[(0u + _e545)].links[2u];
                                                phi_1056_ = _e900;
                                            } else {
                                                let _e903 = nodes.member[(0u + _e545)].links[3u];
                                                phi_1056_ = _e903;
                                            }
                                            let _e905 = phi_1056_;
                                            let _e910 = ((_e905 >> bitcast<u32>(((_e823 * 8u) & 31u))) & 255u);
                                            let _e911 = (_e910 & 31u);
                                            if (_e911 >= 24u) {
                                                phi_1069_ = (24u + ((_e911 - 24u) ^ _e405));
                                            } else {
                                                phi_1069_ = _e911;
                                            }
                                            let _e917 = phi_1069_;
                                            phi_1074_ = (_e819 | ((_e910 >> bitcast<u32>(5i)) << bitcast<u32>((_e917 & 31u))));
                                        } else {
                                            phi_1074_ = _e819;
                                        }
                                        let _e925 = phi_1074_;
                                        phi_1075_ = _e925;
                                    } else {
                                        phi_1075_ = _e819;
                                    }
                                    let _e927 = phi_1075_;
                                    phi_1076_ = _e927;
                                } else {
                                    phi_1076_ = _e819;
                                }
                                let _e929 = phi_1076_;
                                phi_946_ = (_e817 + 1u);
                                phi_949_ = _e929;
                            } else {
                                phi_946_ = u32();
                                phi_949_ = u32();
                            }
                            let _e932 = phi_946_;
                            let _e934 = phi_949_;
                            continue;
                            continuing {
                                phi_945_ = _e932;
                                phi_948_ = _e934;
                                break if !(_e820);
                            }
                        }
                        let _e938 = nodes.member[(0u + _e545)].links[0u];
                        let _e942 = nodes.member[(0u + _e545)].frame[3u];
                        let _e946 = local_1;
                        if ((_e946 & 4278190080u) == 0u) {
                        } else {
                            let _e950 = local.group_mask;
                            if ((_e950 & 4278190080u) == 0u) {
                            } else {
                                let _e954 = local.len;
                                if (_e954 < 32u) {
                                    let _e957 = local.group;
                                    let _e959 = local.len;
                                    if (_e959 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.first[(0u + _e959)] = _e957;
                                    let _e965 = local.group_mask;
                                    let _e967 = local.len;
                                    if (_e967 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.mask[(0u + _e967)] = _e965;
                                    let _e974 = local.len;
                                    local.len = (_e974 + 1u);
                                }
                            }
                            local.group = (0u + _e938);
                            let _e978 = local_2;
                            local.group_mask = ((_e978 & 4278190080u) | (_e942 >> bitcast<u32>(24i)));
                        }
                        let _e983 = local_3;
                        phi_1134_ = _e543;
                        phi_1137_ = (_e983 & 16777215u);
                        loop {
                            let _e986 = phi_1134_;
                            let _e988 = phi_1137_;
                            local_4 = _e986;
                            if (_e988 == 0u) {
                                phi_1135_ = lt_bvh_Hit();
                                phi_1138_ = u32();
                                phi_1796_ = false;
                            } else {
                                let _e992 = nodes.member[(0u + _e545)].links[1u];
                                let _e997 = ((0u + _e992) + select(firstTrailingBit(_e988), 32u, (_e988 == 0u)));
                                if (_e997 < _e68) {
                                } else {
                                    return;
                                }
                                let _e1004 = triangles.member[(0u + _e997)].v0_;
                                let _e1007 = (_e1004.x - _e138.origin.x);
                                let _e1010 = (_e1004.y - _e138.origin.y);
                                let _e1013 = (_e1004.z - _e138.origin.z);
                                if (_e372 == 0u) {
                                    phi_1184_ = vec3<f32>(_e1010, _e1013, _e1007);
                                } else {
                                    if (_e372 == 1u) {
                                        phi_1183_ = vec3<f32>(_e1013, _e1007, _e1010);
                                    } else {
                                        phi_1183_ = (_e1004 - _e138.origin);
                                    }
                                    let _e1020 = phi_1183_;
                                    phi_1184_ = _e1020;
                                }
                                let _e1022 = phi_1184_;
                                let _e1026 = (_e1022.x - (_e389 * _e1022.z));
                                let _e1030 = (_e1022.y - (_e392 * _e1022.z));
                                let _e1032 = triangles.member[(0u + _e997)].v1_;
                                let _e1035 = (_e1032.x - _e138.origin.x);
                                let _e1038 = (_e1032.y - _e138.origin.y);
                                let _e1041 = (_e1032.z - _e138.origin.z);
                                if (_e372 == 0u) {
                                    phi_1216_ = vec3<f32>(_e1038, _e1041, _e1035);
                                } else {
                                    if (_e372 == 1u) {
                                        phi_1215_ = vec3<f32>(_e1041, _e1035, _e1038);
                                    } else {
                                        phi_1215_ = (_e1032 - _e138.origin);
                                    }
                                    let _e1048 = phi_1215_;
                                    phi_1216_ = _e1048;
                                }
                                let _e1050 = phi_1216_;
                                let _e1054 = (_e1050.x - (_e389 * _e1050.z));
                                let _e1058 = (_e1050.y - (_e392 * _e1050.z));
                                let _e1060 = triangles.member[(0u + _e997)].v2_;
                                let _e1063 = (_e1060.x - _e138.origin.x);
                                let _e1066 = (_e1060.y - _e138.origin.y);
                                let _e1069 = (_e1060.z - _e138.origin.z);
                                if (_e372 == 0u) {
                                    phi_1248_ = vec3<f32>(_e1066, _e1069, _e1063);
                                } else {
                                    if (_e372 == 1u) {
                                        phi_1247_ = vec3<f32>(_e1069, _e1063, _e1066);
                                    } else {
                                        phi_1247_ = (_e1060 - _e138.origin);
                                    }
                                    let _e1076 = phi_1247_;
                                    phi_1248_ = _e1076;
                                }
                                let _e1078 = phi_1248_;
                                let _e1082 = (_e1078.x - (_e389 * _e1078.z));
                                let _e1086 = (_e1078.y - (_e392 * _e1078.z));
                                if (_e1054 < _e1082) {
                                    phi_1267_ = true;
                                } else {
                                    if (_e1054 == _e1082) {
                                        phi_1266_ = (_e1058 < _e1086);
                                    } else {
                                        phi_1266_ = false;
                                    }
                                    let _e1091 = phi_1266_;
                                    phi_1267_ = _e1091;
                                }
                                let _e1093 = phi_1267_;
                                if _e1093 {
                                    phi_1271_ = _e1086;
                                    phi_1272_ = _e1082;
                                    phi_1273_ = _e1058;
                                    phi_1274_ = _e1054;
                                } else {
                                    phi_1271_ = _e1058;
                                    phi_1272_ = _e1054;
                                    phi_1273_ = _e1086;
                                    phi_1274_ = _e1082;
                                }
                                let _e1095 = phi_1271_;
                                let _e1097 = phi_1272_;
                                let _e1099 = phi_1273_;
                                let _e1101 = phi_1274_;
                                let _e1104 = ((_e1101 * _e1095) - (_e1099 * _e1097));
                                if _e1093 {
                                    phi_1282_ = -(_e1104);
                                } else {
                                    phi_1282_ = _e1104;
                                }
                                let _e1107 = phi_1282_;
                                if (_e1082 < _e1026) {
                                    phi_1293_ = true;
                                } else {
                                    if (_e1082 == _e1026) {
                                        phi_1292_ = (_e1086 < _e1030);
                                    } else {
                                        phi_1292_ = false;
                                    }
                                    let _e1112 = phi_1292_;
                                    phi_1293_ = _e1112;
                                }
                                let _e1114 = phi_1293_;
                                if _e1114 {
                                    phi_1297_ = _e1030;
                                    phi_1298_ = _e1026;
                                    phi_1299_ = _e1086;
                                    phi_1300_ = _e1082;
                                } else {
                                    phi_1297_ = _e1086;
                                    phi_1298_ = _e1082;
                                    phi_1299_ = _e1030;
                                    phi_1300_ = _e1026;
                                }
                                let _e1116 = phi_1297_;
                                let _e1118 = phi_1298_;
                                let _e1120 = phi_1299_;
                                let _e1122 = phi_1300_;
                                let _e1125 = ((_e1122 * _e1116) - (_e1120 * _e1118));
                                if _e1114 {
                                    phi_1308_ = -(_e1125);
                                } else {
                                    phi_1308_ = _e1125;
                                }
                                let _e1128 = phi_1308_;
                                if (_e1026 < _e1054) {
                                    phi_1319_ = true;
                                } else {
                                    if (_e1026 == _e1054) {
                                        phi_1318_ = (_e1030 < _e1058);
                                    } else {
                                        phi_1318_ = false;
                                    }
                                    let _e1133 = phi_1318_;
                                    phi_1319_ = _e1133;
                                }
                                let _e1135 = phi_1319_;
                                if _e1135 {
                                    phi_1323_ = _e1058;
                                    phi_1324_ = _e1054;
                                    phi_1325_ = _e1030;
                                    phi_1326_ = _e1026;
                                } else {
                                    phi_1323_ = _e1030;
                                    phi_1324_ = _e1026;
                                    phi_1325_ = _e1058;
                                    phi_1326_ = _e1054;
                                }
                                let _e1137 = phi_1323_;
                                let _e1139 = phi_1324_;
                                let _e1141 = phi_1325_;
                                let _e1143 = phi_1326_;
                                let _e1146 = ((_e1143 * _e1137) - (_e1141 * _e1139));
                                if _e1135 {
                                    phi_1334_ = -(_e1146);
                                } else {
                                    phi_1334_ = _e1146;
                                }
                                let _e1149 = phi_1334_;
                                if (_e1107 >= 0f) {
                                    if (_e1128 >= 0f) {
                                        if (_e1149 >= 0f) {
                                            phi_1349_ = ((_e1107 + _e1128) + _e1149);
                                            phi_1350_ = false;
                                        } else {
                                            phi_1349_ = f32();
                                            phi_1350_ = true;
                                        }
                                        let _e1156 = phi_1349_;
                                        let _e1158 = phi_1350_;
                                        phi_1351_ = _e1156;
                                        phi_1352_ = _e1158;
                                    } else {
                                        phi_1351_ = f32();
                                        phi_1352_ = true;
                                    }
                                    let _e1160 = phi_1351_;
                                    let _e1162 = phi_1352_;
                                    phi_1353_ = _e1160;
                                    phi_1354_ = _e1162;
                                } else {
                                    phi_1353_ = f32();
                                    phi_1354_ = true;
                                }
                                let _e1164 = phi_1353_;
                                let _e1166 = phi_1354_;
                                if _e1166 {
                                    if (_e1107 <= 0f) {
                                        if (_e1128 <= 0f) {
                                            let _e1169 = (_e1149 <= 0f);
                                            if _e1169 {
                                            }
                                            phi_1372_ = ((_e1107 + _e1128) + _e1149);
                                            phi_1373_ = false;
                                            phi_1374_ = _e1169;
                                        } else {
                                            phi_1372_ = f32();
                                            phi_1373_ = true;
                                            phi_1374_ = false;
                                        }
                                        let _e1173 = phi_1372_;
                                        let _e1175 = phi_1373_;
                                        let _e1177 = phi_1374_;
                                        phi_1375_ = _e1173;
                                        phi_1376_ = _e1175;
                                        phi_1377_ = _e1177;
                                    } else {
                                        phi_1375_ = f32();
                                        phi_1376_ = true;
                                        phi_1377_ = false;
                                    }
                                    let _e1179 = phi_1375_;
                                    let _e1181 = phi_1376_;
                                    let _e1183 = phi_1377_;
                                    if _e1181 {
                                        phi_1381_ = false;
                                    } else {
                                        phi_1381_ = _e1183;
                                    }
                                    let _e1185 = phi_1381_;
                                    phi_1382_ = _e1179;
                                    phi_1383_ = _e1185;
                                } else {
                                    phi_1382_ = _e1164;
                                    phi_1383_ = true;
                                }
                                let _e1187 = phi_1382_;
                                let _e1189 = phi_1383_;
                                if _e1189 {
                                    let _e1190 = (_e1187 == 0f);
                                    if _e1190 {
                                        phi_1709_ = lt_bvh_triangle_Intersection();
                                        phi_1710_ = false;
                                    } else {
                                        let _e1192 = triangles.member[(0u + _e997)].v0_;
                                        let _e1195 = (_e1192.x - _e138.origin.x);
                                        let _e1198 = (_e1192.y - _e138.origin.y);
                                        let _e1201 = (_e1192.z - _e138.origin.z);
                                        if (_e372 == 0u) {
                                            phi_1414_ = vec3<f32>(_e1198, _e1201, _e1195);
                                        } else {
                                            if (_e372 == 1u) {
                                                phi_1413_ = vec3<f32>(_e1201, _e1195, _e1198);
                                            } else {
                                                phi_1413_ = (_e1192 - _e138.origin);
                                            }
                                            let _e1208 = phi_1413_;
                                            phi_1414_ = _e1208;
                                        }
                                        let _e1210 = phi_1414_;
                                        let _e1212 = triangles.member[(0u + _e997)].v1_;
                                        let _e1214 = triangles.member[(0u + _e997)].v0_;
                                        let _e1217 = (_e1212.x - _e1214.x);
                                        let _e1220 = (_e1212.y - _e1214.y);
                                        let _e1223 = (_e1212.z - _e1214.z);
                                        if (_e372 == 0u) {
                                            phi_1440_ = vec3<f32>(_e1220, _e1223, _e1217);
                                        } else {
                                            if (_e372 == 1u) {
                                                phi_1439_ = vec3<f32>(_e1223, _e1217, _e1220);
                                            } else {
                                                phi_1439_ = (_e1212 - _e1214);
                                            }
                                            let _e1230 = phi_1439_;
                                            phi_1440_ = _e1230;
                                        }
                                        let _e1232 = phi_1440_;
                                        let _e1234 = triangles.member[(0u + _e997)].v2_;
                                        let _e1236 = triangles.member[(0u + _e997)].v0_;
                                        let _e1239 = (_e1234.x - _e1236.x);
                                        let _e1242 = (_e1234.y - _e1236.y);
                                        let _e1245 = (_e1234.z - _e1236.z);
                                        if (_e372 == 0u) {
                                            phi_1466_ = vec3<f32>(_e1242, _e1245, _e1239);
                                        } else {
                                            if (_e372 == 1u) {
                                                phi_1465_ = vec3<f32>(_e1245, _e1239, _e1242);
                                            } else {
                                                phi_1465_ = (_e1234 - _e1236);
                                            }
                                            let _e1252 = phi_1465_;
                                            phi_1466_ = _e1252;
                                        }
                                        let _e1254 = phi_1466_;
                                        let _e1261 = ((_e1232.y * _e1254.z) - (_e1232.z * _e1254.y));
                                        let _e1268 = ((_e1232.z * _e1254.x) - (_e1232.x * _e1254.z));
                                        let _e1275 = ((_e1232.x * _e1254.y) - (_e1232.y * _e1254.x));
                                        let _e1289 = (((1f / _e386.z) * (((_e1261 * _e1210.x) + (_e1268 * _e1210.y)) + (_e1275 * _e1210.z))) / (((_e1261 * _e389) + (_e1268 * _e392)) + _e1275));
                                        if (_e1289 > _e138.tmin) {
                                            if (_e1289 < _e138.tmax) {
                                                let _e1295 = triangles.member[(0u + _e997)].v0_;
                                                let _e1297 = triangles.member[(0u + _e997)].v1_;
                                                if (_e1295.x < _e1297.x) {
                                                    phi_1524_ = _e1295.x;
                                                } else {
                                                    phi_1524_ = _e1297.x;
                                                }
                                                let _e1304 = phi_1524_;
                                                if (_e1295.y < _e1297.y) {
                                                    phi_1533_ = _e1295.y;
                                                } else {
                                                    phi_1533_ = _e1297.y;
                                                }
                                                let _e1311 = phi_1533_;
                                                if (_e1295.z < _e1297.z) {
                                                    phi_1542_ = _e1295.z;
                                                } else {
                                                    phi_1542_ = _e1297.z;
                                                }
                                                let _e1318 = phi_1542_;
                                                let _e1320 = triangles.member[(0u + _e997)].v2_;
                                                if (_e1304 < _e1320.x) {
                                                    phi_1551_ = _e1304;
                                                } else {
                                                    phi_1551_ = _e1320.x;
                                                }
                                                let _e1325 = phi_1551_;
                                                if (_e1311 < _e1320.y) {
                                                    phi_1558_ = _e1311;
                                                } else {
                                                    phi_1558_ = _e1320.y;
                                                }
                                                let _e1330 = phi_1558_;
                                                if (_e1318 < _e1320.z) {
                                                    phi_1565_ = _e1318;
                                                } else {
                                                    phi_1565_ = _e1320.z;
                                                }
                                                let _e1335 = phi_1565_;
                                                let _e1337 = triangles.member[(0u + _e997)].v0_;
                                                let _e1339 = triangles.member[(0u + _e997)].v1_;
                                                if (_e1337.x > _e1339.x) {
                                                    phi_1578_ = _e1337.x;
                                                } else {
                                                    phi_1578_ = _e1339.x;
                                                }
                                                let _e1346 = phi_1578_;
                                                if (_e1337.y > _e1339.y) {
                                                    phi_1587_ = _e1337.y;
                                                } else {
                                                    phi_1587_ = _e1339.y;
                                                }
                                                let _e1353 = phi_1587_;
                                                if (_e1337.z > _e1339.z) {
                                                    phi_1596_ = _e1337.z;
                                                } else {
                                                    phi_1596_ = _e1339.z;
                                                }
                                                let _e1360 = phi_1596_;
                                                let _e1362 = triangles.member[(0u + _e997)].v2_;
                                                if (_e1346 > _e1362.x) {
                                                    phi_1605_ = _e1346;
                                                } else {
                                                    phi_1605_ = _e1362.x;
                                                }
                                                let _e1367 = phi_1605_;
                                                if (_e1353 > _e1362.y) {
                                                    phi_1612_ = _e1353;
                                                } else {
                                                    phi_1612_ = _e1362.y;
                                                }
                                                let _e1372 = phi_1612_;
                                                if (_e1360 > _e1362.z) {
                                                    phi_1619_ = _e1360;
                                                } else {
                                                    phi_1619_ = _e1362.z;
                                                }
                                                let _e1377 = phi_1619_;
                                                let _e1384 = ((_e1325 - _e138.origin.x) * _e284);
                                                let _e1385 = ((_e1330 - _e138.origin.y) * _e295);
                                                let _e1386 = ((_e1335 - _e138.origin.z) * _e306);
                                                let _e1393 = ((_e1367 - _e138.origin.x) * _e284);
                                                let _e1394 = ((_e1372 - _e138.origin.y) * _e295);
                                                let _e1395 = ((_e1377 - _e138.origin.z) * _e306);
                                                if (_e1384 < _e1393) {
                                                    phi_1642_ = _e1384;
                                                } else {
                                                    phi_1642_ = _e1393;
                                                }
                                                let _e1398 = phi_1642_;
                                                if (_e1385 < _e1394) {
                                                    phi_1647_ = _e1385;
                                                } else {
                                                    phi_1647_ = _e1394;
                                                }
                                                let _e1401 = phi_1647_;
                                                if (_e1386 < _e1395) {
                                                    phi_1652_ = _e1386;
                                                } else {
                                                    phi_1652_ = _e1395;
                                                }
                                                let _e1404 = phi_1652_;
                                                if (_e1384 > _e1393) {
                                                    phi_1660_ = _e1384;
                                                } else {
                                                    phi_1660_ = _e1393;
                                                }
                                                let _e1410 = phi_1660_;
                                                if (_e1385 > _e1394) {
                                                    phi_1665_ = _e1385;
                                                } else {
                                                    phi_1665_ = _e1394;
                                                }
                                                let _e1413 = phi_1665_;
                                                if (_e1386 > _e1395) {
                                                    phi_1670_ = _e1386;
                                                } else {
                                                    phi_1670_ = _e1395;
                                                }
                                                let _e1416 = phi_1670_;
                                                let _e1420 = core_intrinsics_maximum_number_nsz_f32_((_e1398 - _e351), (_e1401 - _e352));
                                                let _e1421 = core_intrinsics_maximum_number_nsz_f32_(_e1420, (_e1404 - _e353));
                                                let _e1422 = core_intrinsics_minimum_number_nsz_f32_((_e1410 + _e351), (_e1413 + _e352));
                                                let _e1423 = core_intrinsics_minimum_number_nsz_f32_(_e1422, (_e1416 + _e353));
                                                if (_e1421 > -300000000000000000000000000000000000000f) {
                                                    phi_1682_ = _e1421;
                                                } else {
                                                    phi_1682_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1426 = phi_1682_;
                                                if (_e1423 < 300000000000000000000000000000000000000f) {
                                                    phi_1687_ = _e1423;
                                                } else {
                                                    phi_1687_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1429 = phi_1687_;
                                                if (_e1289 < _e1426) {
                                                    phi_1692_ = _e1426;
                                                } else {
                                                    phi_1692_ = _e1289;
                                                }
                                                let _e1432 = phi_1692_;
                                                if (_e1432 > _e1429) {
                                                    phi_1697_ = _e1429;
                                                } else {
                                                    phi_1697_ = _e1432;
                                                }
                                                let _e1435 = phi_1697_;
                                                phi_1702_ = lt_bvh_triangle_Intersection(_e1435, (_e1128 / _e1187), (_e1149 / _e1187), (_e1426 <= _e1429));
                                                phi_1703_ = false;
                                            } else {
                                                phi_1702_ = lt_bvh_triangle_Intersection();
                                                phi_1703_ = true;
                                            }
                                            let _e1441 = phi_1702_;
                                            let _e1443 = phi_1703_;
                                            phi_1704_ = _e1441;
                                            phi_1705_ = _e1443;
                                        } else {
                                            phi_1704_ = lt_bvh_triangle_Intersection();
                                            phi_1705_ = true;
                                        }
                                        let _e1445 = phi_1704_;
                                        let _e1447 = phi_1705_;
                                        if _e1447 {
                                        }
                                        phi_1709_ = _e1445;
                                        phi_1710_ = _e1447;
                                    }
                                    let _e1449 = phi_1709_;
                                    let _e1451 = phi_1710_;
                                    phi_1711_ = _e1449;
                                    phi_1712_ = _e1190;
                                    phi_1713_ = _e1451;
                                } else {
                                    phi_1711_ = lt_bvh_triangle_Intersection();
                                    phi_1712_ = true;
                                    phi_1713_ = false;
                                }
                                let _e1453 = phi_1711_;
                                let _e1455 = phi_1712_;
                                let _e1457 = phi_1713_;
                                if _e1455 {
                                    phi_1717_ = true;
                                } else {
                                    phi_1717_ = _e1457;
                                }
                                let _e1459 = phi_1717_;
                                if _e1459 {
                                    phi_1721_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1721_ = _e1453;
                                }
                                let _e1461 = phi_1721_;
                                if _e1461.is_hit {
                                    if (_e1461.t > _e138.tmin) {
                                        if (_e1461.t < _e986.t) {
                                            phi_1770_ = true;
                                        } else {
                                            if (_e1461.t == _e986.t) {
                                                if (_e986.triangle != 4294967295u) {
                                                    if (_e997 < _e986.triangle) {
                                                        phi_1761_ = true;
                                                    } else {
                                                        if (_e997 == _e986.triangle) {
                                                            phi_1760_ = (4294967295u < _e986.instance);
                                                        } else {
                                                            phi_1760_ = false;
                                                        }
                                                        let _e1480 = phi_1760_;
                                                        phi_1761_ = _e1480;
                                                    }
                                                    let _e1482 = phi_1761_;
                                                    phi_1762_ = _e1482;
                                                    phi_1763_ = false;
                                                } else {
                                                    phi_1762_ = bool();
                                                    phi_1763_ = true;
                                                }
                                                let _e1484 = phi_1762_;
                                                let _e1486 = phi_1763_;
                                                phi_1764_ = _e1484;
                                                phi_1765_ = _e1486;
                                            } else {
                                                phi_1764_ = bool();
                                                phi_1765_ = true;
                                            }
                                            let _e1488 = phi_1764_;
                                            let _e1490 = phi_1765_;
                                            if _e1490 {
                                                phi_1769_ = false;
                                            } else {
                                                phi_1769_ = _e1488;
                                            }
                                            let _e1492 = phi_1769_;
                                            phi_1770_ = _e1492;
                                        }
                                        let _e1494 = phi_1770_;
                                        if _e1494 {
                                            let _e1496 = triangles.member[(0u + _e997)].i0_;
                                            if ((_e1496 & 2147483648u) == 0u) {
                                                phi_1784_ = true;
                                            } else {
                                                if true {
                                                }
                                                phi_1784_ = true;
                                            }
                                            let _e1500 = phi_1784_;
                                            if _e1500 {
                                                phi_1792_ = lt_bvh_Hit(_e1461.t, _e1461.u, _e1461.v, _e997, 4294967295u);
                                            } else {
                                                phi_1792_ = _e986;
                                            }
                                            let _e1506 = phi_1792_;
                                            phi_1793_ = _e1506;
                                        } else {
                                            phi_1793_ = _e986;
                                        }
                                        let _e1508 = phi_1793_;
                                        phi_1794_ = _e1508;
                                    } else {
                                        phi_1794_ = _e986;
                                    }
                                    let _e1510 = phi_1794_;
                                    phi_1795_ = _e1510;
                                } else {
                                    phi_1795_ = _e986;
                                }
                                let _e1512 = phi_1795_;
                                phi_1135_ = _e1512;
                                phi_1138_ = (_e988 & (_e988 - 1u));
                                phi_1796_ = true;
                            }
                            let _e1514 = phi_1135_;
                            let _e1516 = phi_1138_;
                            let _e1518 = phi_1796_;
                            continue;
                            continuing {
                                phi_1134_ = _e1514;
                                phi_1137_ = _e1516;
                                break if !(_e1518);
                            }
                        }
                        let _e1521 = local.group_mask;
                        if ((_e1521 & 4278190080u) == 0u) {
                            let _e1525 = local.len;
                            if (_e1525 == 0u) {
                                phi_1835_ = false;
                            } else {
                                let _e1529 = local.len;
                                local.len = (_e1529 - 1u);
                                let _e1532 = local.len;
                                if (_e1532 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1537 = local.first[(0u + _e1532)];
                                local.group = _e1537;
                                let _e1540 = local.len;
                                if (_e1540 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1545 = local.mask[(0u + _e1540)];
                                local.group_mask = _e1545;
                                phi_1835_ = true;
                            }
                            let _e1548 = phi_1835_;
                            phi_1836_ = _e1548;
                        } else {
                            phi_1836_ = true;
                        }
                        let _e1550 = phi_1836_;
                        if _e1550 {
                            let _e1552 = local.group_mask;
                            let _e1558 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1552)), 32u, (_e1552 == 0u)));
                            let _e1562 = local.group_mask;
                            let _e1576 = local.group_mask;
                            local.group_mask = (_e1576 & ~((1u << bitcast<u32>((_e1558 & 31u)))));
                            let _e1579 = local.group;
                            phi_1867_ = (_e1579 + countOneBits(((_e1562 & ~((4294967295u << bitcast<u32>((((_e1558 - 24u) ^ _e405) & 31u))))) & 255u)));
                        } else {
                            phi_1867_ = 4294967295u;
                        }
                        let _e1582 = phi_1867_;
                        let _e2280 = local_4;
                        phi_798_ = _e2280;
                        phi_801_ = _e1582;
                    } else {
                        phi_798_ = lt_bvh_Hit();
                        phi_801_ = u32();
                    }
                    let _e1584 = phi_798_;
                    let _e1586 = phi_801_;
                    continue;
                    continuing {
                        phi_797_ = _e1584;
                        phi_800_ = _e1586;
                        break if !(_e546);
                    }
                }
                let _e2284 = local_5;
                phi_1868_ = _e2284;
            }
            let _e1589 = phi_1868_;
            phi_1869_ = _e1589;
            phi_1870_ = _e202;
        } else {
            phi_1869_ = lt_bvh_Hit();
            phi_1870_ = true;
        }
        let _e1591 = phi_1869_;
        let _e1593 = phi_1870_;
        if _e1593 {
            phi_1874_ = _e140;
        } else {
            phi_1874_ = _e1591;
        }
        let _e1595 = phi_1874_;
        if (_e1595.triangle != 4294967295u) {
            let _e1601 = ((1f - _e1595.u) - _e1595.v);
            if (_e1595.triangle < _e68) {
            } else {
                return;
            }
            let _e1607 = triangles.member[(0u + _e1595.triangle)];
            let _e1632 = (((_e1607.v0_.x * _e1601) + (_e1607.v1_.x * _e1595.u)) + (_e1607.v2_.x * _e1595.v));
            let _e1633 = (((_e1607.v0_.y * _e1601) + (_e1607.v1_.y * _e1595.u)) + (_e1607.v2_.y * _e1595.v));
            let _e1634 = (((_e1607.v0_.z * _e1601) + (_e1607.v1_.z * _e1595.u)) + (_e1607.v2_.z * _e1595.v));
            let _e1637 = abs(_e1607.v0_.x);
            let _e1639 = abs(_e1607.v0_.y);
            let _e1641 = abs(_e1607.v0_.z);
            let _e1643 = abs(_e1607.v1_.x);
            let _e1645 = abs(_e1607.v1_.y);
            let _e1647 = abs(_e1607.v1_.z);
            if (_e1637 > _e1643) {
                phi_1939_ = _e1637;
            } else {
                phi_1939_ = _e1643;
            }
            let _e1650 = phi_1939_;
            if (_e1639 > _e1645) {
                phi_1944_ = _e1639;
            } else {
                phi_1944_ = _e1645;
            }
            let _e1653 = phi_1944_;
            if (_e1641 > _e1647) {
                phi_1949_ = _e1641;
            } else {
                phi_1949_ = _e1647;
            }
            let _e1656 = phi_1949_;
            let _e1658 = abs(_e1607.v2_.x);
            let _e1660 = abs(_e1607.v2_.y);
            let _e1662 = abs(_e1607.v2_.z);
            if (_e1650 > _e1658) {
                phi_1960_ = _e1650;
            } else {
                phi_1960_ = _e1658;
            }
            let _e1665 = phi_1960_;
            if (_e1653 > _e1660) {
                phi_1965_ = _e1653;
            } else {
                phi_1965_ = _e1660;
            }
            let _e1668 = phi_1965_;
            if (_e1656 > _e1662) {
                phi_1970_ = _e1656;
            } else {
                phi_1970_ = _e1662;
            }
            let _e1671 = phi_1970_;
            let _e1674 = (_e1607.v1_.x - _e1607.v0_.x);
            let _e1677 = (_e1607.v1_.y - _e1607.v0_.y);
            let _e1680 = (_e1607.v1_.z - _e1607.v0_.z);
            let _e1683 = (_e1607.v2_.x - _e1607.v0_.x);
            let _e1686 = (_e1607.v2_.y - _e1607.v0_.y);
            let _e1689 = (_e1607.v2_.z - _e1607.v0_.z);
            let _e1693 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1677), abs(_e1680));
            let _e1694 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1674), _e1693);
            let _e1695 = (_e1674 / _e1694);
            let _e1696 = (_e1677 / _e1694);
            let _e1697 = (_e1680 / _e1694);
            let _e1701 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1686), abs(_e1689));
            let _e1702 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1683), _e1701);
            let _e1703 = (_e1683 / _e1702);
            let _e1704 = (_e1686 / _e1702);
            let _e1705 = (_e1689 / _e1702);
            let _e1708 = ((_e1696 * _e1705) - (_e1704 * _e1697));
            let _e1711 = ((_e1697 * _e1703) - (_e1705 * _e1695));
            let _e1714 = ((_e1695 * _e1704) - (_e1703 * _e1696));
            let _e1716 = p.member.eye;
            let _e1729 = (1f / sqrt((((_e1708 * _e1708) + (_e1711 * _e1711)) + (_e1714 * _e1714))));
            let _e1730 = (_e1708 * _e1729);
            let _e1731 = (_e1711 * _e1729);
            let _e1732 = (_e1714 * _e1729);
            if ((((_e1730 * (_e1716.x - _e1632)) + (_e1731 * (_e1716.y - _e1633))) + (_e1732 * (_e1716.z - _e1634))) < 0f) {
                phi_2046_ = vec3<f32>(-(_e1730), -(_e1731), -(_e1732));
            } else {
                phi_2046_ = vec3<f32>(_e1730, _e1731, _e1732);
            }
            let _e1745 = phi_2046_;
            if (_e1595.triangle < _e68) {
            } else {
                return;
            }
            let _e1750 = triangles.member[(0u + _e1595.triangle)];
            let _e1752 = (_e1750.i0_ & 2147483647u);
            if (_e1752 < _e71) {
            } else {
                return;
            }
            let _e1758 = vertices.member[(0u + _e1752)];
            if (_e1750.i1_ < _e71) {
            } else {
                return;
            }
            let _e1762 = vertices.member[(0u + _e1750.i1_)];
            if (_e1750.i2_ < _e71) {
            } else {
                return;
            }
            let _e1766 = vertices.member[(0u + _e1750.i2_)];
            let _e1767 = array<abi_Vertex, 3>(_e1758, _e1762, _e1766);
            if (_e1767[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e1773 = materials.member[(0u + _e1767[0].material)];
            let _e1790 = (1f / 255f);
            let _e1809 = (1f / 255f);
            let _e1831 = (1f / 255f);
            let _e1844 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e1601, _e1595.u, _e1595.v));
            let _e1846 = ((_e1773.base_color.x * ((((f32((_e1767[0].color & 255u)) * _e1790) * _e1601) + ((f32((_e1767[1].color & 255u)) * _e1809) * _e1595.u)) + ((f32((_e1767[2].color & 255u)) * _e1831) * _e1595.v))) * _e1844.x);
            let _e1848 = ((_e1773.base_color.y * ((((f32(((_e1767[0].color >> bitcast<u32>(8i)) & 255u)) * _e1790) * _e1601) + ((f32(((_e1767[1].color >> bitcast<u32>(8i)) & 255u)) * _e1809) * _e1595.u)) + ((f32(((_e1767[2].color >> bitcast<u32>(8i)) & 255u)) * _e1831) * _e1595.v))) * _e1844.y);
            let _e1850 = ((_e1773.base_color.z * ((((f32(((_e1767[0].color >> bitcast<u32>(16i)) & 255u)) * _e1790) * _e1601) + ((f32(((_e1767[1].color >> bitcast<u32>(16i)) & 255u)) * _e1809) * _e1595.u)) + ((f32(((_e1767[2].color >> bitcast<u32>(16i)) & 255u)) * _e1831) * _e1595.v))) * _e1844.z);
            let _e1851 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1668, _e1671);
            let _e1852 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1665, _e1851);
            if ((_e1773.flags & 2u) == 0u) {
                phi_2167_ = 0u;
            } else {
                phi_2167_ = 1u;
            }
            let _e1857 = phi_2167_;
            if (_e1767[0].normal == 2147516416u) {
                phi_2370_ = _e1745;
            } else {
                let _e1870 = (f32((bitcast<i32>((_e1767[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1876 = (f32((bitcast<i32>(_e1767[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1880 = ((1f - abs(_e1870)) - abs(_e1876));
                if (_e1880 < 0f) {
                    phi_2194_ = -(_e1880);
                } else {
                    phi_2194_ = 0f;
                }
                let _e1884 = phi_2194_;
                if (_e1870 < 0f) {
                    phi_2201_ = (_e1870 + _e1884);
                } else {
                    phi_2201_ = (_e1870 - _e1884);
                }
                let _e1889 = phi_2201_;
                if (_e1876 < 0f) {
                    phi_2208_ = (_e1876 + _e1884);
                } else {
                    phi_2208_ = (_e1876 - _e1884);
                }
                let _e1894 = phi_2208_;
                let _e1901 = (1f / sqrt((((_e1889 * _e1889) + (_e1894 * _e1894)) + (_e1880 * _e1880))));
                let _e1917 = (f32((bitcast<i32>((_e1767[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1923 = (f32((bitcast<i32>(_e1767[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1927 = ((1f - abs(_e1917)) - abs(_e1923));
                if (_e1927 < 0f) {
                    phi_2243_ = -(_e1927);
                } else {
                    phi_2243_ = 0f;
                }
                let _e1931 = phi_2243_;
                if (_e1917 < 0f) {
                    phi_2250_ = (_e1917 + _e1931);
                } else {
                    phi_2250_ = (_e1917 - _e1931);
                }
                let _e1936 = phi_2250_;
                if (_e1923 < 0f) {
                    phi_2257_ = (_e1923 + _e1931);
                } else {
                    phi_2257_ = (_e1923 - _e1931);
                }
                let _e1941 = phi_2257_;
                let _e1948 = (1f / sqrt((((_e1936 * _e1936) + (_e1941 * _e1941)) + (_e1927 * _e1927))));
                let _e1967 = (f32((bitcast<i32>((_e1767[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1973 = (f32((bitcast<i32>(_e1767[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1977 = ((1f - abs(_e1967)) - abs(_e1973));
                if (_e1977 < 0f) {
                    phi_2295_ = -(_e1977);
                } else {
                    phi_2295_ = 0f;
                }
                let _e1981 = phi_2295_;
                if (_e1967 < 0f) {
                    phi_2302_ = (_e1967 + _e1981);
                } else {
                    phi_2302_ = (_e1967 - _e1981);
                }
                let _e1986 = phi_2302_;
                if (_e1973 < 0f) {
                    phi_2309_ = (_e1973 + _e1981);
                } else {
                    phi_2309_ = (_e1973 - _e1981);
                }
                let _e1991 = phi_2309_;
                let _e1998 = (1f / sqrt((((_e1986 * _e1986) + (_e1991 * _e1991)) + (_e1977 * _e1977))));
                let _e2009 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e1889 * _e1901) * _e1601) + ((_e1936 * _e1948) * _e1595.u)) + ((_e1986 * _e1998) * _e1595.v)), ((((_e1894 * _e1901) * _e1601) + ((_e1941 * _e1948) * _e1595.u)) + ((_e1991 * _e1998) * _e1595.v)), ((((_e1880 * _e1901) * _e1601) + ((_e1927 * _e1948) * _e1595.u)) + ((_e1977 * _e1998) * _e1595.v))));
                let _e2021 = sqrt((((_e2009.x * _e2009.x) + (_e2009.y * _e2009.y)) + (_e2009.z * _e2009.z)));
                if (_e2021 > 0f) {
                    let _e2024 = (_e2009.x / _e2021);
                    let _e2026 = (_e2009.y / _e2021);
                    let _e2028 = (_e2009.z / _e2021);
                    if ((((_e2024 * _e1745.x) + (_e2026 * _e1745.y)) + (_e2028 * _e1745.z)) < 0f) {
                        phi_2368_ = vec3<f32>(-(_e2024), -(_e2026), -(_e2028));
                    } else {
                        phi_2368_ = (_e2009 / vec3(_e2021));
                    }
                    let _e2045 = phi_2368_;
                    phi_2369_ = _e2045;
                } else {
                    phi_2369_ = _e1745;
                }
                let _e2047 = phi_2369_;
                phi_2370_ = _e2047;
            }
            let _e2049 = phi_2370_;
            if (_e1846 > 0f) {
                if (_e1846 < 1f) {
                    phi_2379_ = _e1846;
                } else {
                    phi_2379_ = 1f;
                }
                let _e2053 = phi_2379_;
                phi_2380_ = _e2053;
            } else {
                phi_2380_ = 0f;
            }
            let _e2055 = phi_2380_;
            if (_e1848 > 0f) {
                if (_e1848 < 1f) {
                    phi_2390_ = _e1848;
                } else {
                    phi_2390_ = 1f;
                }
                let _e2060 = phi_2390_;
                phi_2391_ = _e2060;
            } else {
                phi_2391_ = 0f;
            }
            let _e2062 = phi_2391_;
            if (_e1850 > 0f) {
                if (_e1850 < 1f) {
                    phi_2401_ = _e1850;
                } else {
                    phi_2401_ = 1f;
                }
                let _e2067 = phi_2401_;
                phi_2402_ = _e2067;
            } else {
                phi_2402_ = 0f;
            }
            let _e2069 = phi_2402_;
            let _e2072 = ((sqrt(_e2055) * 255f) + 0.5f);
            let _e2081 = ((sqrt(_e2062) * 255f) + 0.5f);
            let _e2093 = ((sqrt(_e2069) * 255f) + 0.5f);
            phi_2437_ = abi_Sample(vec3<f32>(_e1632, _e1633, _e1634), _e1852, _e1745, _e1857, _e2049, ((select(select(u32(_e2072), 0u, (_e2072 < bitcast<f32>(0u))), 4294967295u, (_e2072 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2081), 0u, (_e2081 < bitcast<f32>(0u))), 4294967295u, (_e2081 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2093), 0u, (_e2093 < bitcast<f32>(0u))), 4294967295u, (_e2093 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_2437_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2107 = phi_2437_;
        if (_e83.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e83.shift)] = _e2107;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
