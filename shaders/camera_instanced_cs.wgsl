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

struct type_26 {
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

struct type_30 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_34 {
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

struct type_38 {
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

struct lt_bvh_Instance {
    world_to_object: array<vec4<f32>, 3>,
    object_to_world: array<vec4<f32>, 3>,
    low_world: vec3<f32>,
    root: u32,
    high_world: vec3<f32>,
    first_triangle: u32,
    source: u32,
    padding: array<u32, 3>,
}

struct type_51 {
    member: array<lt_bvh_Instance>,
}

struct type_55 {
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
var<storage> vertices: type_34;
@group(0) @binding(4) 
var<storage> materials: type_38;
@group(0) @binding(0) 
var<uniform> p: type_55;
@group(0) @binding(1) 
var<storage> nodes: type_26;
@group(0) @binding(2) 
var<storage> triangles: type_30;
@group(0) @binding(5) 
var<storage, read_write> samples: type_9;
@group(0) @binding(6) 
var<storage> instances: type_51;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_199_: lt_mask_LightPlace;
    var phi_200_: bool;
    var phi_201_: lt_mask_LightPlace;
    var phi_202_: bool;
    var phi_207_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_199_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_200_ = false;
        } else {
            phi_199_ = lt_mask_LightPlace();
            phi_200_ = true;
        }
        let _e74 = phi_199_;
        let _e76 = phi_200_;
        phi_201_ = _e74;
        phi_202_ = _e76;
    } else {
        phi_201_ = lt_mask_LightPlace();
        phi_202_ = true;
    }
    let _e78 = phi_201_;
    let _e80 = phi_202_;
    if _e80 {
        phi_207_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_207_ = _e78;
    }
    let _e85 = phi_207_;
    return lt_mask_LightPlace(_e85.word, _e85.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_222_: bool;
    var phi_226_: f32;

    if (param_3 != param_3) {
        phi_222_ = true;
    } else {
        let _e64 = (param_4 >= param_3);
        if _e64 {
        }
        phi_222_ = _e64;
    }
    let _e66 = phi_222_;
    if _e66 {
        phi_226_ = param_4;
    } else {
        phi_226_ = param_3;
    }
    let _e68 = phi_226_;
    return _e68;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_238_: bool;
    var phi_242_: f32;

    if (param_5 != param_5) {
        phi_238_ = true;
    } else {
        let _e64 = (param_6 <= param_5);
        if _e64 {
        }
        phi_238_ = _e64;
    }
    let _e66 = phi_238_;
    if _e66 {
        phi_242_ = param_6;
    } else {
        phi_242_ = param_5;
    }
    let _e68 = phi_242_;
    return _e68;
}

fn _lt_bvh_ray_Ray_new(param_7: vec3<f32>, param_8: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_7, 0f, param_8, 300000000000000000000000000000000000000f);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_9: f32, param_10: f32) -> f32 {
    var phi_254_: f32;

    if (param_9 > param_10) {
        phi_254_ = param_9;
    } else {
        phi_254_ = param_10;
    }
    let _e65 = phi_254_;
    return _e65;
}

fn _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(param_11: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(1f, 1f, 1f);
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: lt_bvh_traverse_Stack;
    var phi_378_: bool;
    var phi_379_: bool;
    var phi_380_: bool;
    var phi_381_: bool;
    var phi_385_: bool;
    var phi_398_: bool;
    var phi_399_: bool;
    var phi_400_: bool;
    var phi_401_: bool;
    var phi_405_: bool;
    var phi_418_: bool;
    var phi_419_: bool;
    var phi_420_: bool;
    var phi_424_: bool;
    var phi_425_: bool;
    var phi_426_: bool;
    var phi_427_: bool;
    var phi_428_: bool;
    var phi_432_: bool;
    var phi_508_: f32;
    var phi_515_: f32;
    var phi_523_: f32;
    var phi_530_: f32;
    var phi_538_: f32;
    var phi_545_: f32;
    var phi_568_: f32;
    var phi_573_: f32;
    var phi_578_: f32;
    var phi_583_: f32;
    var phi_588_: f32;
    var phi_607_: u32;
    var phi_612_: u32;
    var phi_617_: u32;
    var phi_731_: bool;
    var phi_732_: bool;
    var phi_763_: u32;
    var phi_765_: u32;
    var phi_768_: lt_bvh_Hit;
    var phi_853_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_880_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_907_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_913_: u32;
    var phi_916_: u32;
    var phi_930_: u32;
    var phi_940_: u32;
    var phi_950_: u32;
    var phi_968_: u32;
    var phi_978_: u32;
    var phi_988_: u32;
    var phi_1024_: u32;
    var phi_1037_: u32;
    var phi_1042_: u32;
    var phi_1043_: u32;
    var phi_1044_: u32;
    var phi_914_: u32;
    var phi_917_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1102_: u32;
    var phi_1105_: lt_bvh_Hit;
    var phi_1160_: f32;
    var phi_1165_: f32;
    var phi_1170_: f32;
    var phi_1178_: f32;
    var phi_1183_: f32;
    var phi_1188_: f32;
    var phi_1320_: bool;
    var phi_1321_: bool;
    var phi_1322_: bool;
    var phi_1323_: bool;
    var phi_1327_: bool;
    var phi_1340_: bool;
    var phi_1341_: bool;
    var phi_1342_: bool;
    var phi_1343_: bool;
    var phi_1347_: bool;
    var phi_1360_: bool;
    var phi_1361_: bool;
    var phi_1362_: bool;
    var phi_1366_: bool;
    var phi_1367_: bool;
    var phi_1368_: bool;
    var phi_1369_: bool;
    var phi_1370_: bool;
    var phi_1374_: bool;
    var phi_1444_: f32;
    var phi_1451_: f32;
    var phi_1458_: f32;
    var phi_1465_: f32;
    var phi_1472_: f32;
    var phi_1479_: f32;
    var phi_1496_: f32;
    var phi_1501_: f32;
    var phi_1506_: f32;
    var phi_1511_: f32;
    var phi_1516_: f32;
    var phi_1542_: bool;
    var phi_1543_: bool;
    var phi_1551_: u32;
    var phi_1552_: u32;
    var phi_1563_: vec3<f32>;
    var phi_1564_: vec3<f32>;
    var phi_1577_: u32;
    var phi_1582_: u32;
    var phi_1587_: u32;
    var phi_1701_: bool;
    var phi_1702_: bool;
    var phi_1733_: u32;
    var phi_1735_: lt_bvh_Hit;
    var phi_1738_: u32;
    var phi_1819_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1846_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1873_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1879_: u32;
    var phi_1882_: u32;
    var phi_1896_: u32;
    var phi_1906_: u32;
    var phi_1916_: u32;
    var phi_1934_: u32;
    var phi_1944_: u32;
    var phi_1954_: u32;
    var phi_1990_: u32;
    var phi_2003_: u32;
    var phi_2008_: u32;
    var phi_2009_: u32;
    var phi_2010_: u32;
    var phi_1880_: u32;
    var phi_1883_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_2068_: lt_bvh_Hit;
    var phi_2071_: u32;
    var phi_2115_: vec3<f32>;
    var phi_2116_: vec3<f32>;
    var phi_2145_: vec3<f32>;
    var phi_2146_: vec3<f32>;
    var phi_2175_: vec3<f32>;
    var phi_2176_: vec3<f32>;
    var phi_2194_: bool;
    var phi_2195_: bool;
    var phi_2199_: f32;
    var phi_2200_: f32;
    var phi_2201_: f32;
    var phi_2202_: f32;
    var phi_2210_: f32;
    var phi_2220_: bool;
    var phi_2221_: bool;
    var phi_2225_: f32;
    var phi_2226_: f32;
    var phi_2227_: f32;
    var phi_2228_: f32;
    var phi_2236_: f32;
    var phi_2246_: bool;
    var phi_2247_: bool;
    var phi_2251_: f32;
    var phi_2252_: f32;
    var phi_2253_: f32;
    var phi_2254_: f32;
    var phi_2262_: f32;
    var phi_2277_: f32;
    var phi_2278_: bool;
    var phi_2279_: f32;
    var phi_2280_: bool;
    var phi_2281_: f32;
    var phi_2282_: bool;
    var phi_2300_: f32;
    var phi_2301_: bool;
    var phi_2302_: bool;
    var phi_2303_: f32;
    var phi_2304_: bool;
    var phi_2305_: bool;
    var phi_2309_: bool;
    var phi_2310_: f32;
    var phi_2311_: bool;
    var phi_2339_: vec3<f32>;
    var phi_2340_: vec3<f32>;
    var phi_2365_: vec3<f32>;
    var phi_2366_: vec3<f32>;
    var phi_2391_: vec3<f32>;
    var phi_2392_: vec3<f32>;
    var phi_2448_: f32;
    var phi_2457_: f32;
    var phi_2466_: f32;
    var phi_2475_: f32;
    var phi_2482_: f32;
    var phi_2489_: f32;
    var phi_2502_: f32;
    var phi_2511_: f32;
    var phi_2520_: f32;
    var phi_2529_: f32;
    var phi_2536_: f32;
    var phi_2543_: f32;
    var phi_2560_: f32;
    var phi_2565_: f32;
    var phi_2570_: f32;
    var phi_2578_: f32;
    var phi_2583_: f32;
    var phi_2588_: f32;
    var phi_2600_: f32;
    var phi_2605_: f32;
    var phi_2610_: f32;
    var phi_2615_: f32;
    var phi_2620_: lt_bvh_triangle_Intersection;
    var phi_2621_: bool;
    var phi_2622_: lt_bvh_triangle_Intersection;
    var phi_2623_: bool;
    var phi_2627_: lt_bvh_triangle_Intersection;
    var phi_2628_: bool;
    var phi_2629_: lt_bvh_triangle_Intersection;
    var phi_2630_: bool;
    var phi_2631_: bool;
    var phi_2635_: bool;
    var phi_2639_: lt_bvh_triangle_Intersection;
    var phi_2677_: bool;
    var phi_2678_: bool;
    var phi_2679_: bool;
    var phi_2680_: bool;
    var phi_2681_: bool;
    var phi_2682_: bool;
    var phi_2686_: bool;
    var phi_2687_: bool;
    var phi_2701_: bool;
    var phi_2709_: lt_bvh_Hit;
    var phi_2710_: lt_bvh_Hit;
    var phi_2711_: lt_bvh_Hit;
    var phi_2712_: lt_bvh_Hit;
    var phi_2069_: lt_bvh_Hit;
    var phi_2072_: u32;
    var phi_2713_: bool;
    var phi_2752_: bool;
    var phi_2753_: bool;
    var phi_2784_: u32;
    var phi_1736_: lt_bvh_Hit;
    var phi_1739_: u32;
    var phi_2785_: lt_bvh_Hit;
    var phi_2786_: lt_bvh_Hit;
    var phi_2787_: bool;
    var phi_2791_: lt_bvh_Hit;
    var phi_2792_: lt_bvh_Hit;
    var phi_2793_: lt_bvh_Hit;
    var phi_2794_: lt_bvh_Hit;
    var phi_1103_: u32;
    var phi_1106_: lt_bvh_Hit;
    var phi_2795_: bool;
    var phi_2834_: bool;
    var phi_2835_: bool;
    var phi_2866_: u32;
    var phi_766_: u32;
    var phi_769_: lt_bvh_Hit;
    var phi_2867_: lt_bvh_Hit;
    var phi_2868_: lt_bvh_Hit;
    var phi_2869_: bool;
    var phi_2873_: lt_bvh_Hit;
    var phi_3061_: f32;
    var phi_3066_: f32;
    var phi_3071_: f32;
    var phi_3079_: f32;
    var phi_3084_: f32;
    var phi_3089_: f32;
    var phi_3153_: vec3<f32>;
    var phi_3274_: u32;
    var phi_3301_: f32;
    var phi_3308_: f32;
    var phi_3315_: f32;
    var phi_3350_: f32;
    var phi_3357_: f32;
    var phi_3364_: f32;
    var phi_3402_: f32;
    var phi_3409_: f32;
    var phi_3416_: f32;
    var phi_3502_: vec3<f32>;
    var phi_3503_: vec3<f32>;
    var phi_3504_: vec3<f32>;
    var phi_3513_: f32;
    var phi_3514_: f32;
    var phi_3524_: f32;
    var phi_3525_: f32;
    var phi_3535_: f32;
    var phi_3536_: f32;
    var phi_3571_: abi_Sample;
    var local_8: lt_bvh_Hit;
    var local_9: lt_bvh_Hit;
    var local_10: lt_bvh_Hit;
    var local_11: lt_bvh_Hit;

    let _e63 = id_1;
    let _e67 = arrayLength((&nodes.member));
    let _e70 = arrayLength((&triangles.member));
    let _e73 = arrayLength((&vertices.member));
    let _e82 = arrayLength((&instances.member));
    let _e85 = p.member.size[0u];
    let _e87 = p.member.size[1u];
    let _e88 = lt_shaders_entry_pixel_index(_e63, _e85, _e87);
    if (bitcast<i32>(_e88.word) != 0i) {
        let _e94 = p.member.root;
        let _e98 = p.member.eye;
        let _e103 = p.member.size[0u];
        let _e107 = ((((f32(_e63.x) + 0.5f) / f32(_e103)) * 2f) - 1f);
        let _e112 = p.member.size[1u];
        let _e116 = (1f - (((f32(_e63.y) + 0.5f) / f32(_e112)) * 2f));
        let _e118 = p.member.forward;
        let _e120 = p.member.right;
        let _e134 = p.member.up;
        let _e145 = _lt_bvh_ray_Ray_new(_e98, vec3<f32>(((_e118.x + (_e120.x * _e107)) + (_e134.x * _e116)), ((_e118.y + (_e120.y * _e107)) + (_e134.y * _e116)), ((_e118.z + (_e120.z * _e107)) + (_e134.z * _e116))));
        let _e147 = lt_bvh_Hit(_e145.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e150 = abs(_e145.direction.x);
        let _e152 = abs(_e145.direction.y);
        let _e154 = abs(_e145.direction.z);
        if (abs(_e145.origin.x) < 1000000000000000f) {
            if (abs(_e145.origin.y) < 1000000000000000f) {
                phi_378_ = (abs(_e145.origin.z) < 1000000000000000f);
                phi_379_ = false;
            } else {
                phi_378_ = bool();
                phi_379_ = true;
            }
            let _e166 = phi_378_;
            let _e168 = phi_379_;
            phi_380_ = _e166;
            phi_381_ = _e168;
        } else {
            phi_380_ = bool();
            phi_381_ = true;
        }
        let _e170 = phi_380_;
        let _e172 = phi_381_;
        if _e172 {
            phi_385_ = false;
        } else {
            phi_385_ = _e170;
        }
        let _e174 = phi_385_;
        if _e174 {
            if (_e150 < 1000000000000000f) {
                if (_e152 < 1000000000000000f) {
                    phi_398_ = (_e154 < 1000000000000000f);
                    phi_399_ = false;
                } else {
                    phi_398_ = bool();
                    phi_399_ = true;
                }
                let _e179 = phi_398_;
                let _e181 = phi_399_;
                phi_400_ = _e179;
                phi_401_ = _e181;
            } else {
                phi_400_ = bool();
                phi_401_ = true;
            }
            let _e183 = phi_400_;
            let _e185 = phi_401_;
            if _e185 {
                phi_405_ = false;
            } else {
                phi_405_ = _e183;
            }
            let _e187 = phi_405_;
            if _e187 {
                if (_e150 > 0f) {
                    phi_419_ = bool();
                    phi_420_ = true;
                } else {
                    let _e189 = (_e152 > 0f);
                    if _e189 {
                        phi_418_ = bool();
                    } else {
                        phi_418_ = (_e154 > 0f);
                    }
                    let _e192 = phi_418_;
                    phi_419_ = _e192;
                    phi_420_ = _e189;
                }
                let _e194 = phi_419_;
                let _e196 = phi_420_;
                if _e196 {
                    phi_424_ = true;
                } else {
                    phi_424_ = _e194;
                }
                let _e198 = phi_424_;
                phi_425_ = _e198;
                phi_426_ = false;
            } else {
                phi_425_ = bool();
                phi_426_ = true;
            }
            let _e200 = phi_425_;
            let _e202 = phi_426_;
            phi_427_ = _e200;
            phi_428_ = _e202;
        } else {
            phi_427_ = bool();
            phi_428_ = true;
        }
        let _e204 = phi_427_;
        let _e206 = phi_428_;
        if _e206 {
            phi_432_ = false;
        } else {
            phi_432_ = _e204;
        }
        let _e208 = phi_432_;
        if _e208 {
            let _e209 = (_e94 >= _e67);
            if _e209 {
                phi_2867_ = lt_bvh_Hit();
            } else {
                if (_e94 < _e67) {
                } else {
                    return;
                }
                let _e215 = nodes.member[(0u + _e94)].frame[0u];
                let _e219 = nodes.member[(0u + _e94)].frame[1u];
                let _e223 = nodes.member[(0u + _e94)].frame[2u];
                let _e227 = nodes.member[(0u + _e94)].frame[0u];
                let _e231 = nodes.member[(0u + _e94)].frame[1u];
                let _e235 = nodes.member[(0u + _e94)].frame[2u];
                let _e239 = nodes.member[(0u + _e94)].frame[3u];
                let _e278 = core_intrinsics_maximum_number_nsz_f32_(abs(_e145.direction.x), abs(_e145.direction.y));
                let _e279 = core_intrinsics_maximum_number_nsz_f32_(_e278, abs(_e145.direction.z));
                let _e280 = (_e279 * 0.0000000000009094947f);
                if (abs(_e145.direction.x) < _e280) {
                    phi_508_ = _e280;
                } else {
                    phi_508_ = abs(_e145.direction.x);
                }
                let _e286 = phi_508_;
                if (_e145.direction.x < 0f) {
                    phi_515_ = (-1f / _e286);
                } else {
                    phi_515_ = (1f / _e286);
                }
                let _e291 = phi_515_;
                if (abs(_e145.direction.y) < _e280) {
                    phi_523_ = _e280;
                } else {
                    phi_523_ = abs(_e145.direction.y);
                }
                let _e297 = phi_523_;
                if (_e145.direction.y < 0f) {
                    phi_530_ = (-1f / _e297);
                } else {
                    phi_530_ = (1f / _e297);
                }
                let _e302 = phi_530_;
                if (abs(_e145.direction.z) < _e280) {
                    phi_538_ = _e280;
                } else {
                    phi_538_ = abs(_e145.direction.z);
                }
                let _e308 = phi_538_;
                if (_e145.direction.z < 0f) {
                    phi_545_ = (-1f / _e308);
                } else {
                    phi_545_ = (1f / _e308);
                }
                let _e313 = phi_545_;
                let _e320 = abs((bitcast<f32>(_e215) - _e145.origin.x));
                let _e321 = abs((bitcast<f32>(_e219) - _e145.origin.y));
                let _e322 = abs((bitcast<f32>(_e223) - _e145.origin.z));
                let _e329 = abs(((bitcast<f32>(_e227) + (bitcast<f32>((((_e239 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e145.origin.x));
                let _e330 = abs(((bitcast<f32>(_e231) + (bitcast<f32>((((_e239 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e145.origin.y));
                let _e331 = abs(((bitcast<f32>(_e235) + (bitcast<f32>((((_e239 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e145.origin.z));
                if (_e320 > _e329) {
                    phi_568_ = _e320;
                } else {
                    phi_568_ = _e329;
                }
                let _e334 = phi_568_;
                if (_e321 > _e330) {
                    phi_573_ = _e321;
                } else {
                    phi_573_ = _e330;
                }
                let _e337 = phi_573_;
                if (_e322 > _e331) {
                    phi_578_ = _e322;
                } else {
                    phi_578_ = _e331;
                }
                let _e340 = phi_578_;
                if (_e334 > _e337) {
                    phi_583_ = _e334;
                } else {
                    phi_583_ = _e337;
                }
                let _e343 = phi_583_;
                if (_e343 > _e340) {
                    phi_588_ = _e343;
                } else {
                    phi_588_ = _e340;
                }
                let _e346 = phi_588_;
                let _e350 = (_e346 * 0.0000019073486f);
                let _e351 = (abs(_e291) * _e350);
                let _e352 = (abs(_e302) * _e350);
                let _e353 = (abs(_e313) * _e350);
                let _e357 = (_e346 * 0.0000009536743f);
                let _e358 = (abs(_e291) * _e357);
                let _e359 = (abs(_e302) * _e357);
                let _e360 = (abs(_e313) * _e357);
                if (_e291 < 0f) {
                    phi_607_ = 0u;
                } else {
                    phi_607_ = 1u;
                }
                let _e363 = phi_607_;
                if (_e302 < 0f) {
                    phi_612_ = 0u;
                } else {
                    phi_612_ = 2u;
                }
                let _e366 = phi_612_;
                if (_e313 < 0f) {
                    phi_617_ = 0u;
                } else {
                    phi_617_ = 4u;
                }
                let _e369 = phi_617_;
                let _e371 = ((_e363 | _e366) | _e369);
                let _e372 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e94, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e372.first[0], _e372.first[1], _e372.first[2], _e372.first[3], _e372.first[4], _e372.first[5], _e372.first[6], _e372.first[7], _e372.first[8], _e372.first[9], _e372.first[10], _e372.first[11], _e372.first[12], _e372.first[13], _e372.first[14], _e372.first[15], _e372.first[16], _e372.first[17], _e372.first[18], _e372.first[19], _e372.first[20], _e372.first[21], _e372.first[22], _e372.first[23], _e372.first[24], _e372.first[25], _e372.first[26], _e372.first[27], _e372.first[28], _e372.first[29], _e372.first[30], _e372.first[31]), array<u32, 32>(_e372.mask[0], _e372.mask[1], _e372.mask[2], _e372.mask[3], _e372.mask[4], _e372.mask[5], _e372.mask[6], _e372.mask[7], _e372.mask[8], _e372.mask[9], _e372.mask[10], _e372.mask[11], _e372.mask[12], _e372.mask[13], _e372.mask[14], _e372.mask[15], _e372.mask[16], _e372.mask[17], _e372.mask[18], _e372.mask[19], _e372.mask[20], _e372.mask[21], _e372.mask[22], _e372.mask[23], _e372.mask[24], _e372.mask[25], _e372.mask[26], _e372.mask[27], _e372.mask[28], _e372.mask[29], _e372.mask[30], _e372.mask[31]), _e372.len, _e372.group, _e372.group_mask);
                let _e446 = local_1.group_mask;
                if ((_e446 & 4278190080u) == 0u) {
                    let _e450 = local_1.len;
                    if (_e450 == 0u) {
                        phi_731_ = false;
                    } else {
                        let _e454 = local_1.len;
                        local_1.len = (_e454 - 1u);
                        let _e457 = local_1.len;
                        if (_e457 < 32u) {
                        } else {
                            return;
                        }
                        let _e462 = local_1.first[(0u + _e457)];
                        local_1.group = _e462;
                        let _e465 = local_1.len;
                        if (_e465 < 32u) {
                        } else {
                            return;
                        }
                        let _e470 = local_1.mask[(0u + _e465)];
                        local_1.group_mask = _e470;
                        phi_731_ = true;
                    }
                    let _e473 = phi_731_;
                    phi_732_ = _e473;
                } else {
                    phi_732_ = true;
                }
                let _e475 = phi_732_;
                if _e475 {
                    let _e477 = local_1.group_mask;
                    let _e483 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e477)), 32u, (_e477 == 0u)));
                    let _e487 = local_1.group_mask;
                    let _e501 = local_1.group_mask;
                    local_1.group_mask = (_e501 & ~((1u << bitcast<u32>((_e483 & 31u)))));
                    let _e504 = local_1.group;
                    phi_763_ = (_e504 + countOneBits(((_e487 & ~((4294967295u << bitcast<u32>((((_e483 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_763_ = 4294967295u;
                }
                let _e507 = phi_763_;
                phi_765_ = _e507;
                phi_768_ = _e147;
                loop {
                    let _e509 = phi_765_;
                    let _e511 = phi_768_;
                    local_11 = _e511;
                    let _e512 = (_e509 != 4294967295u);
                    if _e512 {
                        if (_e509 < _e67) {
                        } else {
                            return;
                        }
                        let _e520 = nodes.member[(0u + _e509)].frame[3u];
                        let _e545 = (bitcast<f32>((((_e520 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e291);
                        let _e546 = (bitcast<f32>((((_e520 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e302);
                        let _e547 = (bitcast<f32>((((_e520 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e313);
                        let _e550 = nodes.member[(0u + _e509)].frame[0u];
                        let _e554 = nodes.member[(0u + _e509)].frame[1u];
                        let _e558 = nodes.member[(0u + _e509)].frame[2u];
                        let _e566 = ((bitcast<f32>(_e550) - _e145.origin.x) * _e291);
                        let _e567 = ((bitcast<f32>(_e554) - _e145.origin.y) * _e302);
                        let _e568 = ((bitcast<f32>(_e558) - _e145.origin.z) * _e313);
                        let _e576 = nodes.member[(0u + _e509)].x;
                        if (_e291 < 0f) {
                            let _e587 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e576.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e593 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e587.unnamed.word, _e576.w), _e587.unnamed_1);
                            let _e599 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e593.unnamed, lt_mask_LightPlace(_e576.x, _e593.unnamed_1.shift));
                            phi_853_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e599.unnamed, lt_mask_LightPlace(_e599.unnamed_1.word, _e576.y));
                        } else {
                            let _e615 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e576.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e621 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e615.unnamed.word, _e576.y), _e615.unnamed_1);
                            let _e627 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e621.unnamed, lt_mask_LightPlace(_e576.z, _e621.unnamed_1.shift));
                            phi_853_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e627.unnamed, lt_mask_LightPlace(_e627.unnamed_1.word, _e576.w));
                        }
                        let _e635 = phi_853_;
                        let _e645 = nodes.member[(0u + _e509)].y;
                        if (_e302 < 0f) {
                            let _e656 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e645.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e662 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e656.unnamed.word, _e645.w), _e656.unnamed_1);
                            let _e668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e662.unnamed, lt_mask_LightPlace(_e645.x, _e662.unnamed_1.shift));
                            phi_880_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e668.unnamed, lt_mask_LightPlace(_e668.unnamed_1.word, _e645.y));
                        } else {
                            let _e684 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e645.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e690 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e684.unnamed.word, _e645.y), _e684.unnamed_1);
                            let _e696 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e690.unnamed, lt_mask_LightPlace(_e645.z, _e690.unnamed_1.shift));
                            phi_880_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e696.unnamed, lt_mask_LightPlace(_e696.unnamed_1.word, _e645.w));
                        }
                        let _e704 = phi_880_;
                        let _e714 = nodes.member[(0u + _e509)].z;
                        if (_e313 < 0f) {
                            let _e725 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e714.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e731 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e725.unnamed.word, _e714.w), _e725.unnamed_1);
                            let _e737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e731.unnamed, lt_mask_LightPlace(_e714.x, _e731.unnamed_1.shift));
                            phi_907_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e737.unnamed, lt_mask_LightPlace(_e737.unnamed_1.word, _e714.y));
                        } else {
                            let _e753 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e714.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e759 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e753.unnamed.word, _e714.y), _e753.unnamed_1);
                            let _e765 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e759.unnamed, lt_mask_LightPlace(_e714.z, _e759.unnamed_1.shift));
                            phi_907_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e765.unnamed, lt_mask_LightPlace(_e765.unnamed_1.word, _e714.w));
                        }
                        let _e773 = phi_907_;
                        phi_913_ = 0u;
                        phi_916_ = 0u;
                        loop {
                            let _e783 = phi_913_;
                            let _e785 = phi_916_;
                            local_2 = _e785;
                            local_3 = _e785;
                            local_4 = _e785;
                            let _e786 = (_e783 < 8u);
                            if _e786 {
                                let _e788 = (_e783 >> bitcast<u32>(2i));
                                let _e789 = (_e783 & 3u);
                                if (_e788 == 0u) {
                                    phi_930_ = _e635.unnamed.word;
                                } else {
                                    phi_930_ = _e635.unnamed.shift;
                                }
                                let _e792 = phi_930_;
                                if (_e788 == 0u) {
                                    phi_940_ = _e704.unnamed.word;
                                } else {
                                    phi_940_ = _e704.unnamed.shift;
                                }
                                let _e801 = phi_940_;
                                if (_e788 == 0u) {
                                    phi_950_ = _e773.unnamed.word;
                                } else {
                                    phi_950_ = _e773.unnamed.shift;
                                }
                                let _e810 = phi_950_;
                                let _e823 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e792 >> bitcast<u32>(((_e789 * 8u) & 31u))) & 255u)) * _e545) + (_e566 - _e351)), ((f32(((_e801 >> bitcast<u32>(((_e789 * 8u) & 31u))) & 255u)) * _e546) + (_e567 - _e352)));
                                let _e824 = core_intrinsics_maximum_number_nsz_f32_(_e823, ((f32(((_e810 >> bitcast<u32>(((_e789 * 8u) & 31u))) & 255u)) * _e547) + (_e568 - _e353)));
                                if (_e788 == 0u) {
                                    phi_968_ = _e635.unnamed_1.word;
                                } else {
                                    phi_968_ = _e635.unnamed_1.shift;
                                }
                                let _e827 = phi_968_;
                                if (_e788 == 0u) {
                                    phi_978_ = _e704.unnamed_1.word;
                                } else {
                                    phi_978_ = _e704.unnamed_1.shift;
                                }
                                let _e836 = phi_978_;
                                if (_e788 == 0u) {
                                    phi_988_ = _e773.unnamed_1.word;
                                } else {
                                    phi_988_ = _e773.unnamed_1.shift;
                                }
                                let _e845 = phi_988_;
                                let _e858 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e827 >> bitcast<u32>(((_e789 * 8u) & 31u))) & 255u)) * _e545) + (_e566 + _e351)), ((f32(((_e836 >> bitcast<u32>(((_e789 * 8u) & 31u))) & 255u)) * _e546) + (_e567 + _e352)));
                                let _e859 = core_intrinsics_minimum_number_nsz_f32_(_e858, ((f32(((_e845 >> bitcast<u32>(((_e789 * 8u) & 31u))) & 255u)) * _e547) + (_e568 + _e353)));
                                if (_e824 <= _e859) {
                                    if (_e824 <= _e511.t) {
                                        if (_e859 >= _e145.tmin) {
                                            if (_e788 == 0u) {
                                                let _e866 = nodes.member[(0u + _e509)].links[2u];
                                                phi_1024_ = _e866;
                                            } else {
                                                let _e869 = nodes.member[(0u + _e509)].links[3u];
                                                phi_1024_ = _e869;
                                            }
                                            let _e871 = phi_1024_;
                                            let _e876 = ((_e871 >> bitcast<u32>(((_e789 * 8u) & 31u))) & 255u);
                                            let _e877 = (_e876 & 31u);
                                            if (_e877 >= 24u) {
                                                phi_1037_ = (24u + ((_e877 - 24u) ^ _e371));
                                            } else {
                                                phi_1037_ = _e877;
                                            }
                                            let _e883 = phi_1037_;
                                            phi_1042_ = (_e785 | ((_e876 >> bitcast<u32>(5i)) << bitcast<u32>((_e883 & 31u))));
                                        } else {
                                            phi_1042_ = _e785;
                                        }
                                        let _e891 = phi_1042_;
                                        phi_1043_ = _e891;
                                    } else {
                                        phi_1043_ = _e785;
                                    }
                                    let _e893 = phi_1043_;
                                    phi_1044_ = _e893;
                                } else {
                                    phi_1044_ = _e785;
                                }
                                let _e895 = phi_1044_;
                                phi_914_ = (_e783 + 1u);
                                phi_917_ = _e895;
                            } else {
                                phi_914_ = u32();
                                phi_917_ = u32();
                            }
                            let _e898 = phi_914_;
                            let _e900 = phi_917_;
                            continue;
                            continuing {
                                phi_913_ = _e898;
                                phi_916_ = _e900;
                                break if !(_e786);
                            }
                        }
                        let _e904 = nodes.member[(0u + _e509)].links[0u];
                        let _e908 = nodes.member[(0u + _e509)].frame[3u];
                        let _e912 = local_2;
                        if ((_e912 & 4278190080u) == 0u) {
                        } else {
                            let _e916 = local_1.group_mask;
                            if ((_e916 & 4278190080u) == 0u) {
                            } else {
                                let _e920 = local_1.len;
                                if (_e920 < 32u) {
                                    let _e923 = local_1.group;
                                    let _e925 = local_1.len;
                                    if (_e925 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e925)] = _e923;
                                    let _e931 = local_1.group_mask;
                                    let _e933 = local_1.len;
                                    if (_e933 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e933)] = _e931;
                                    let _e940 = local_1.len;
                                    local_1.len = (_e940 + 1u);
                                }
                            }
                            local_1.group = (_e94 + _e904);
                            let _e944 = local_3;
                            local_1.group_mask = ((_e944 & 4278190080u) | (_e908 >> bitcast<u32>(24i)));
                        }
                        let _e949 = local_4;
                        phi_1102_ = (_e949 & 16777215u);
                        phi_1105_ = _e511;
                        loop {
                            let _e952 = phi_1102_;
                            let _e954 = phi_1105_;
                            local_10 = _e954;
                            if (_e952 == 0u) {
                                phi_1103_ = u32();
                                phi_1106_ = lt_bvh_Hit();
                                phi_2795_ = false;
                            } else {
                                let _e958 = nodes.member[(0u + _e509)].links[1u];
                                let _e962 = (_e958 + select(firstTrailingBit(_e952), 32u, (_e952 == 0u)));
                                if (_e962 < _e82) {
                                } else {
                                    return;
                                }
                                let _e969 = instances.member[(0u + _e962)].low_world;
                                let _e971 = instances.member[(0u + _e962)].high_world;
                                let _e981 = ((_e969.x - _e145.origin.x) * _e291);
                                let _e982 = ((_e969.y - _e145.origin.y) * _e302);
                                let _e983 = ((_e969.z - _e145.origin.z) * _e313);
                                let _e993 = ((_e971.x - _e145.origin.x) * _e291);
                                let _e994 = ((_e971.y - _e145.origin.y) * _e302);
                                let _e995 = ((_e971.z - _e145.origin.z) * _e313);
                                if (_e981 < _e993) {
                                    phi_1160_ = _e981;
                                } else {
                                    phi_1160_ = _e993;
                                }
                                let _e998 = phi_1160_;
                                if (_e982 < _e994) {
                                    phi_1165_ = _e982;
                                } else {
                                    phi_1165_ = _e994;
                                }
                                let _e1001 = phi_1165_;
                                if (_e983 < _e995) {
                                    phi_1170_ = _e983;
                                } else {
                                    phi_1170_ = _e995;
                                }
                                let _e1004 = phi_1170_;
                                if (_e981 > _e993) {
                                    phi_1178_ = _e981;
                                } else {
                                    phi_1178_ = _e993;
                                }
                                let _e1010 = phi_1178_;
                                if (_e982 > _e994) {
                                    phi_1183_ = _e982;
                                } else {
                                    phi_1183_ = _e994;
                                }
                                let _e1013 = phi_1183_;
                                if (_e983 > _e995) {
                                    phi_1188_ = _e983;
                                } else {
                                    phi_1188_ = _e995;
                                }
                                let _e1016 = phi_1188_;
                                let _e1020 = core_intrinsics_maximum_number_nsz_f32_((_e998 - _e358), (_e1001 - _e359));
                                let _e1021 = core_intrinsics_maximum_number_nsz_f32_(_e1020, (_e1004 - _e360));
                                let _e1022 = core_intrinsics_minimum_number_nsz_f32_((_e1010 + _e358), (_e1013 + _e359));
                                let _e1023 = core_intrinsics_minimum_number_nsz_f32_(_e1022, (_e1016 + _e360));
                                if (_e1021 <= _e1023) {
                                    if (_e1021 <= _e954.t) {
                                        if (_e1023 >= _e145.tmin) {
                                            let _e1035 = instances.member[(0u + _e962)].world_to_object[0u];
                                            let _e1046 = ((((_e1035.x * _e145.origin.x) + (_e1035.y * _e145.origin.y)) + (_e1035.z * _e145.origin.z)) + (_e1035.w * 1f));
                                            let _e1048 = instances.member[(0u + _e962)].world_to_object[1u];
                                            let _e1059 = ((((_e1048.x * _e145.origin.x) + (_e1048.y * _e145.origin.y)) + (_e1048.z * _e145.origin.z)) + (_e1048.w * 1f));
                                            let _e1061 = instances.member[(0u + _e962)].world_to_object[2u];
                                            let _e1072 = ((((_e1061.x * _e145.origin.x) + (_e1061.y * _e145.origin.y)) + (_e1061.z * _e145.origin.z)) + (_e1061.w * 1f));
                                            let _e1079 = instances.member[(0u + _e962)].world_to_object[0u];
                                            let _e1090 = ((((_e1079.x * _e145.direction.x) + (_e1079.y * _e145.direction.y)) + (_e1079.z * _e145.direction.z)) + (_e1079.w * 0f));
                                            let _e1092 = instances.member[(0u + _e962)].world_to_object[1u];
                                            let _e1103 = ((((_e1092.x * _e145.direction.x) + (_e1092.y * _e145.direction.y)) + (_e1092.z * _e145.direction.z)) + (_e1092.w * 0f));
                                            let _e1105 = instances.member[(0u + _e962)].world_to_object[2u];
                                            let _e1116 = ((((_e1105.x * _e145.direction.x) + (_e1105.y * _e145.direction.y)) + (_e1105.z * _e145.direction.z)) + (_e1105.w * 0f));
                                            let _e1121 = instances.member[(0u + _e962)].root;
                                            let _e1123 = instances.member[(0u + _e962)].first_triangle;
                                            let _e1124 = abs(_e1090);
                                            let _e1125 = abs(_e1103);
                                            let _e1126 = abs(_e1116);
                                            if (abs(_e1046) < 1000000000000000f) {
                                                if (abs(_e1059) < 1000000000000000f) {
                                                    phi_1320_ = (abs(_e1072) < 1000000000000000f);
                                                    phi_1321_ = false;
                                                } else {
                                                    phi_1320_ = bool();
                                                    phi_1321_ = true;
                                                }
                                                let _e1134 = phi_1320_;
                                                let _e1136 = phi_1321_;
                                                phi_1322_ = _e1134;
                                                phi_1323_ = _e1136;
                                            } else {
                                                phi_1322_ = bool();
                                                phi_1323_ = true;
                                            }
                                            let _e1138 = phi_1322_;
                                            let _e1140 = phi_1323_;
                                            if _e1140 {
                                                phi_1327_ = false;
                                            } else {
                                                phi_1327_ = _e1138;
                                            }
                                            let _e1142 = phi_1327_;
                                            if _e1142 {
                                                if (_e1124 < 1000000000000000f) {
                                                    if (_e1125 < 1000000000000000f) {
                                                        phi_1340_ = (_e1126 < 1000000000000000f);
                                                        phi_1341_ = false;
                                                    } else {
                                                        phi_1340_ = bool();
                                                        phi_1341_ = true;
                                                    }
                                                    let _e1147 = phi_1340_;
                                                    let _e1149 = phi_1341_;
                                                    phi_1342_ = _e1147;
                                                    phi_1343_ = _e1149;
                                                } else {
                                                    phi_1342_ = bool();
                                                    phi_1343_ = true;
                                                }
                                                let _e1151 = phi_1342_;
                                                let _e1153 = phi_1343_;
                                                if _e1153 {
                                                    phi_1347_ = false;
                                                } else {
                                                    phi_1347_ = _e1151;
                                                }
                                                let _e1155 = phi_1347_;
                                                if _e1155 {
                                                    if (_e1124 > 0f) {
                                                        phi_1361_ = bool();
                                                        phi_1362_ = true;
                                                    } else {
                                                        let _e1157 = (_e1125 > 0f);
                                                        if _e1157 {
                                                            phi_1360_ = bool();
                                                        } else {
                                                            phi_1360_ = (_e1126 > 0f);
                                                        }
                                                        let _e1160 = phi_1360_;
                                                        phi_1361_ = _e1160;
                                                        phi_1362_ = _e1157;
                                                    }
                                                    let _e1162 = phi_1361_;
                                                    let _e1164 = phi_1362_;
                                                    if _e1164 {
                                                        phi_1366_ = true;
                                                    } else {
                                                        phi_1366_ = _e1162;
                                                    }
                                                    let _e1166 = phi_1366_;
                                                    phi_1367_ = _e1166;
                                                    phi_1368_ = false;
                                                } else {
                                                    phi_1367_ = bool();
                                                    phi_1368_ = true;
                                                }
                                                let _e1168 = phi_1367_;
                                                let _e1170 = phi_1368_;
                                                phi_1369_ = _e1168;
                                                phi_1370_ = _e1170;
                                            } else {
                                                phi_1369_ = bool();
                                                phi_1370_ = true;
                                            }
                                            let _e1172 = phi_1369_;
                                            let _e1174 = phi_1370_;
                                            if _e1174 {
                                                phi_1374_ = false;
                                            } else {
                                                phi_1374_ = _e1172;
                                            }
                                            let _e1176 = phi_1374_;
                                            if _e1176 {
                                                let _e1177 = (_e1121 >= _e67);
                                                if _e1177 {
                                                    phi_2785_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1121 < _e67) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1183 = nodes.member[(0u + _e1121)].frame[0u];
                                                    let _e1187 = nodes.member[(0u + _e1121)].frame[1u];
                                                    let _e1191 = nodes.member[(0u + _e1121)].frame[2u];
                                                    let _e1195 = nodes.member[(0u + _e1121)].frame[0u];
                                                    let _e1199 = nodes.member[(0u + _e1121)].frame[1u];
                                                    let _e1203 = nodes.member[(0u + _e1121)].frame[2u];
                                                    let _e1207 = nodes.member[(0u + _e1121)].frame[3u];
                                                    let _e1241 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1090), abs(_e1103));
                                                    let _e1242 = core_intrinsics_maximum_number_nsz_f32_(_e1241, abs(_e1116));
                                                    let _e1243 = (_e1242 * 0.0000000000009094947f);
                                                    if (abs(_e1090) < _e1243) {
                                                        phi_1444_ = _e1243;
                                                    } else {
                                                        phi_1444_ = abs(_e1090);
                                                    }
                                                    let _e1248 = phi_1444_;
                                                    if (_e1090 < 0f) {
                                                        phi_1451_ = (-1f / _e1248);
                                                    } else {
                                                        phi_1451_ = (1f / _e1248);
                                                    }
                                                    let _e1253 = phi_1451_;
                                                    if (abs(_e1103) < _e1243) {
                                                        phi_1458_ = _e1243;
                                                    } else {
                                                        phi_1458_ = abs(_e1103);
                                                    }
                                                    let _e1258 = phi_1458_;
                                                    if (_e1103 < 0f) {
                                                        phi_1465_ = (-1f / _e1258);
                                                    } else {
                                                        phi_1465_ = (1f / _e1258);
                                                    }
                                                    let _e1263 = phi_1465_;
                                                    if (abs(_e1116) < _e1243) {
                                                        phi_1472_ = _e1243;
                                                    } else {
                                                        phi_1472_ = abs(_e1116);
                                                    }
                                                    let _e1268 = phi_1472_;
                                                    if (_e1116 < 0f) {
                                                        phi_1479_ = (-1f / _e1268);
                                                    } else {
                                                        phi_1479_ = (1f / _e1268);
                                                    }
                                                    let _e1273 = phi_1479_;
                                                    let _e1277 = abs((bitcast<f32>(_e1183) - _e1046));
                                                    let _e1278 = abs((bitcast<f32>(_e1187) - _e1059));
                                                    let _e1279 = abs((bitcast<f32>(_e1191) - _e1072));
                                                    let _e1283 = abs(((bitcast<f32>(_e1195) + (bitcast<f32>((((_e1207 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1046));
                                                    let _e1284 = abs(((bitcast<f32>(_e1199) + (bitcast<f32>((((_e1207 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1059));
                                                    let _e1285 = abs(((bitcast<f32>(_e1203) + (bitcast<f32>((((_e1207 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1072));
                                                    if (_e1277 > _e1283) {
                                                        phi_1496_ = _e1277;
                                                    } else {
                                                        phi_1496_ = _e1283;
                                                    }
                                                    let _e1288 = phi_1496_;
                                                    if (_e1278 > _e1284) {
                                                        phi_1501_ = _e1278;
                                                    } else {
                                                        phi_1501_ = _e1284;
                                                    }
                                                    let _e1291 = phi_1501_;
                                                    if (_e1279 > _e1285) {
                                                        phi_1506_ = _e1279;
                                                    } else {
                                                        phi_1506_ = _e1285;
                                                    }
                                                    let _e1294 = phi_1506_;
                                                    if (_e1288 > _e1291) {
                                                        phi_1511_ = _e1288;
                                                    } else {
                                                        phi_1511_ = _e1291;
                                                    }
                                                    let _e1297 = phi_1511_;
                                                    if (_e1297 > _e1294) {
                                                        phi_1516_ = _e1297;
                                                    } else {
                                                        phi_1516_ = _e1294;
                                                    }
                                                    let _e1300 = phi_1516_;
                                                    let _e1304 = (_e1300 * 0.0000019073486f);
                                                    let _e1305 = (abs(_e1253) * _e1304);
                                                    let _e1306 = (abs(_e1263) * _e1304);
                                                    let _e1307 = (abs(_e1273) * _e1304);
                                                    let _e1311 = (_e1300 * 0.0000009536743f);
                                                    let _e1312 = (abs(_e1253) * _e1311);
                                                    let _e1313 = (abs(_e1263) * _e1311);
                                                    let _e1314 = (abs(_e1273) * _e1311);
                                                    let _e1315 = abs(_e1090);
                                                    let _e1316 = abs(_e1103);
                                                    let _e1317 = abs(_e1116);
                                                    if (_e1315 >= _e1316) {
                                                        if (_e1315 >= _e1317) {
                                                            phi_1542_ = false;
                                                        } else {
                                                            phi_1542_ = true;
                                                        }
                                                        let _e1321 = phi_1542_;
                                                        phi_1543_ = _e1321;
                                                    } else {
                                                        phi_1543_ = true;
                                                    }
                                                    let _e1323 = phi_1543_;
                                                    if _e1323 {
                                                        if (_e1316 >= _e1317) {
                                                            phi_1551_ = 1u;
                                                        } else {
                                                            phi_1551_ = 2u;
                                                        }
                                                        let _e1326 = phi_1551_;
                                                        phi_1552_ = _e1326;
                                                    } else {
                                                        phi_1552_ = 0u;
                                                    }
                                                    let _e1328 = phi_1552_;
                                                    if (_e1328 == 0u) {
                                                        phi_1564_ = vec3<f32>(_e1103, _e1116, _e1090);
                                                    } else {
                                                        if (_e1328 == 1u) {
                                                            phi_1563_ = vec3<f32>(_e1116, _e1090, _e1103);
                                                        } else {
                                                            phi_1563_ = vec3<f32>(_e1090, _e1103, _e1116);
                                                        }
                                                        let _e1334 = phi_1563_;
                                                        phi_1564_ = _e1334;
                                                    }
                                                    let _e1336 = phi_1564_;
                                                    let _e1339 = (_e1336.x / _e1336.z);
                                                    let _e1342 = (_e1336.y / _e1336.z);
                                                    if (_e1253 < 0f) {
                                                        phi_1577_ = 0u;
                                                    } else {
                                                        phi_1577_ = 1u;
                                                    }
                                                    let _e1347 = phi_1577_;
                                                    if (_e1263 < 0f) {
                                                        phi_1582_ = 0u;
                                                    } else {
                                                        phi_1582_ = 2u;
                                                    }
                                                    let _e1350 = phi_1582_;
                                                    if (_e1273 < 0f) {
                                                        phi_1587_ = 0u;
                                                    } else {
                                                        phi_1587_ = 4u;
                                                    }
                                                    let _e1353 = phi_1587_;
                                                    let _e1355 = ((_e1347 | _e1350) | _e1353);
                                                    let _e1356 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1121, 2147483648u);
                                                    local = lt_bvh_traverse_Stack(array<u32, 32>(_e1356.first[0], _e1356.first[1], _e1356.first[2], _e1356.first[3], _e1356.first[4], _e1356.first[5], _e1356.first[6], _e1356.first[7], _e1356.first[8], _e1356.first[9], _e1356.first[10], _e1356.first[11], _e1356.first[12], _e1356.first[13], _e1356.first[14], _e1356.first[15], _e1356.first[16], _e1356.first[17], _e1356.first[18], _e1356.first[19], _e1356.first[20], _e1356.first[21], _e1356.first[22], _e1356.first[23], _e1356.first[24], _e1356.first[25], _e1356.first[26], _e1356.first[27], _e1356.first[28], _e1356.first[29], _e1356.first[30], _e1356.first[31]), array<u32, 32>(_e1356.mask[0], _e1356.mask[1], _e1356.mask[2], _e1356.mask[3], _e1356.mask[4], _e1356.mask[5], _e1356.mask[6], _e1356.mask[7], _e1356.mask[8], _e1356.mask[9], _e1356.mask[10], _e1356.mask[11], _e1356.mask[12], _e1356.mask[13], _e1356.mask[14], _e1356.mask[15], _e1356.mask[16], _e1356.mask[17], _e1356.mask[18], _e1356.mask[19], _e1356.mask[20], _e1356.mask[21], _e1356.mask[22], _e1356.mask[23], _e1356.mask[24], _e1356.mask[25], _e1356.mask[26], _e1356.mask[27], _e1356.mask[28], _e1356.mask[29], _e1356.mask[30], _e1356.mask[31]), _e1356.len, _e1356.group, _e1356.group_mask);
                                                    let _e1430 = local.group_mask;
                                                    if ((_e1430 & 4278190080u) == 0u) {
                                                        let _e1434 = local.len;
                                                        if (_e1434 == 0u) {
                                                            phi_1701_ = false;
                                                        } else {
                                                            let _e1438 = local.len;
                                                            local.len = (_e1438 - 1u);
                                                            let _e1441 = local.len;
                                                            if (_e1441 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1446 = local.first[(0u + _e1441)];
                                                            local.group = _e1446;
                                                            let _e1449 = local.len;
                                                            if (_e1449 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1454 = local.mask[(0u + _e1449)];
                                                            local.group_mask = _e1454;
                                                            phi_1701_ = true;
                                                        }
                                                        let _e1457 = phi_1701_;
                                                        phi_1702_ = _e1457;
                                                    } else {
                                                        phi_1702_ = true;
                                                    }
                                                    let _e1459 = phi_1702_;
                                                    if _e1459 {
                                                        let _e1461 = local.group_mask;
                                                        let _e1467 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1461)), 32u, (_e1461 == 0u)));
                                                        let _e1471 = local.group_mask;
                                                        let _e1485 = local.group_mask;
                                                        local.group_mask = (_e1485 & ~((1u << bitcast<u32>((_e1467 & 31u)))));
                                                        let _e1488 = local.group;
                                                        phi_1733_ = (_e1488 + countOneBits(((_e1471 & ~((4294967295u << bitcast<u32>((((_e1467 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_1733_ = 4294967295u;
                                                    }
                                                    let _e1491 = phi_1733_;
                                                    phi_1735_ = _e954;
                                                    phi_1738_ = _e1491;
                                                    loop {
                                                        let _e1493 = phi_1735_;
                                                        let _e1495 = phi_1738_;
                                                        local_9 = _e1493;
                                                        let _e1496 = (_e1495 != 4294967295u);
                                                        if _e1496 {
                                                            if (_e1495 < _e67) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1503 = nodes.member[(0u + _e1495)].frame[3u];
                                                            let _e1528 = (bitcast<f32>((((_e1503 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1253);
                                                            let _e1529 = (bitcast<f32>((((_e1503 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1263);
                                                            let _e1530 = (bitcast<f32>((((_e1503 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1273);
                                                            let _e1533 = nodes.member[(0u + _e1495)].frame[0u];
                                                            let _e1537 = nodes.member[(0u + _e1495)].frame[1u];
                                                            let _e1541 = nodes.member[(0u + _e1495)].frame[2u];
                                                            let _e1546 = ((bitcast<f32>(_e1533) - _e1046) * _e1253);
                                                            let _e1547 = ((bitcast<f32>(_e1537) - _e1059) * _e1263);
                                                            let _e1548 = ((bitcast<f32>(_e1541) - _e1072) * _e1273);
                                                            let _e1556 = nodes.member[(0u + _e1495)].x;
                                                            if (_e1253 < 0f) {
                                                                let _e1567 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1556.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1573 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1567.unnamed.word, _e1556.w), _e1567.unnamed_1);
                                                                let _e1579 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1573.unnamed, lt_mask_LightPlace(_e1556.x, _e1573.unnamed_1.shift));
                                                                phi_1819_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1579.unnamed, lt_mask_LightPlace(_e1579.unnamed_1.word, _e1556.y));
                                                            } else {
                                                                let _e1595 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1556.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1601 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1595.unnamed.word, _e1556.y), _e1595.unnamed_1);
                                                                let _e1607 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1601.unnamed, lt_mask_LightPlace(_e1556.z, _e1601.unnamed_1.shift));
                                                                phi_1819_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1607.unnamed, lt_mask_LightPlace(_e1607.unnamed_1.word, _e1556.w));
                                                            }
                                                            let _e1615 = phi_1819_;
                                                            let _e1625 = nodes.member[(0u + _e1495)].y;
                                                            if (_e1263 < 0f) {
                                                                let _e1636 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1625.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1642 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1636.unnamed.word, _e1625.w), _e1636.unnamed_1);
                                                                let _e1648 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1642.unnamed, lt_mask_LightPlace(_e1625.x, _e1642.unnamed_1.shift));
                                                                phi_1846_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1648.unnamed, lt_mask_LightPlace(_e1648.unnamed_1.word, _e1625.y));
                                                            } else {
                                                                let _e1664 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1625.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1670 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1664.unnamed.word, _e1625.y), _e1664.unnamed_1);
                                                                let _e1676 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1670.unnamed, lt_mask_LightPlace(_e1625.z, _e1670.unnamed_1.shift));
                                                                phi_1846_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1676.unnamed, lt_mask_LightPlace(_e1676.unnamed_1.word, _e1625.w));
                                                            }
                                                            let _e1684 = phi_1846_;
                                                            let _e1694 = nodes.member[(0u + _e1495)].z;
                                                            if (_e1273 < 0f) {
                                                                let _e1705 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1694.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1711 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1705.unnamed.word, _e1694.w), _e1705.unnamed_1);
                                                                let _e1717 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1711.unnamed, lt_mask_LightPlace(_e1694.x, _e1711.unnamed_1.shift));
                                                                phi_1873_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1717.unnamed, lt_mask_LightPlace(_e1717.unnamed_1.word, _e1694.y));
                                                            } else {
                                                                let _e1733 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1694.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1739 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1733.unnamed.word, _e1694.y), _e1733.unnamed_1);
                                                                let _e1745 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1739.unnamed, lt_mask_LightPlace(_e1694.z, _e1739.unnamed_1.shift));
                                                                phi_1873_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1745.unnamed, lt_mask_LightPlace(_e1745.unnamed_1.word, _e1694.w));
                                                            }
                                                            let _e1753 = phi_1873_;
                                                            phi_1879_ = 0u;
                                                            phi_1882_ = 0u;
                                                            loop {
                                                                let _e1763 = phi_1879_;
                                                                let _e1765 = phi_1882_;
                                                                local_5 = _e1765;
                                                                local_6 = _e1765;
                                                                local_7 = _e1765;
                                                                let _e1766 = (_e1763 < 8u);
                                                                if _e1766 {
                                                                    let _e1768 = (_e1763 >> bitcast<u32>(2i));
                                                                    let _e1769 = (_e1763 & 3u);
                                                                    if (_e1768 == 0u) {
                                                                        phi_1896_ = _e1615.unnamed.word;
                                                                    } else {
                                                                        phi_1896_ = _e1615.unnamed.shift;
                                                                    }
                                                                    let _e1772 = phi_1896_;
                                                                    if (_e1768 == 0u) {
                                                                        phi_1906_ = _e1684.unnamed.word;
                                                                    } else {
                                                                        phi_1906_ = _e1684.unnamed.shift;
                                                                    }
                                                                    let _e1781 = phi_1906_;
                                                                    if (_e1768 == 0u) {
                                                                        phi_1916_ = _e1753.unnamed.word;
                                                                    } else {
                                                                        phi_1916_ = _e1753.unnamed.shift;
                                                                    }
                                                                    let _e1790 = phi_1916_;
                                                                    let _e1803 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1772 >> bitcast<u32>(((_e1769 * 8u) & 31u))) & 255u)) * _e1528) + (_e1546 - _e1305)), ((f32(((_e1781 >> bitcast<u32>(((_e1769 * 8u) & 31u))) & 255u)) * _e1529) + (_e1547 - _e1306)));
                                                                    let _e1804 = core_intrinsics_maximum_number_nsz_f32_(_e1803, ((f32(((_e1790 >> bitcast<u32>(((_e1769 * 8u) & 31u))) & 255u)) * _e1530) + (_e1548 - _e1307)));
                                                                    if (_e1768 == 0u) {
                                                                        phi_1934_ = _e1615.unnamed_1.word;
                                                                    } else {
                                                                        phi_1934_ = _e1615.unnamed_1.shift;
                                                                    }
                                                                    let _e1807 = phi_1934_;
                                                                    if (_e1768 == 0u) {
                                                                        phi_1944_ = _e1684.unnamed_1.word;
                                                                    } else {
                                                                        phi_1944_ = _e1684.unnamed_1.shift;
                                                                    }
                                                                    let _e1816 = phi_1944_;
                                                                    if (_e1768 == 0u) {
                                                                        phi_1954_ = _e1753.unnamed_1.word;
                                                                    } else {
                                                                        phi_1954_ = _e1753.unnamed_1.shift;
                                                                    }
                                                                    let _e1825 = phi_1954_;
                                                                    let _e1838 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1807 >> bitcast<u32>(((_e1769 * 8u) & 31u))) & 255u)) * _e1528) + (_e1546 + _e1305)), ((f32(((_e1816 >> bitcast<u32>(((_e1769 * 8u) & 31u))) & 255u)) * _e1529) + (_e1547 + _e1306)));
                                                                    let _e1839 = core_intrinsics_minimum_number_nsz_f32_(_e1838, ((f32(((_e1825 >> bitcast<u32>(((_e1769 * 8u) & 31u))) & 255u)) * _e1530) + (_e1548 + _e1307)));
                                                                    if (_e1804 <= _e1839) {
                                                                        if (_e1804 <= _e1493.t) {
                                                                            if (_e1839 >= _e145.tmin) {
                                                                                if (_e1768 == 0u) {
                                                                                    let _e1846 = nodes.member[(0u + _e1495)].links[2u];
                                                                                    phi_1990_ = _e1846;
                                                                                } else {
                                                                                    let _e1849 = nodes.member[(0u + _e1495)].links[3u];
                                                                                    phi_1990_ = _e1849;
                                                                                }
                                                                                let _e1851 = phi_1990_;
                                                                                let _e1856 = ((_e1851 >> bitcast<u32>(((_e1769 * 8u) & 31u))) & 255u);
                                                                                let _e1857 = (_e1856 & 31u);
                                                                                if (_e1857 >= 24u) {
                                                                                    phi_2003_ = (24u + ((_e1857 - 24u) ^ _e1355));
                                                                                } else {
                                                                                    phi_2003_ = _e1857;
                                                                                }
                                                                                let _e1863 = phi_2003_;
                                                                                phi_2008_ = (_e1765 | ((_e1856 >> bitcast<u32>(5i)) << bitcast<u32>((_e1863 & 31u))));
                                                                            } else {
                                                                                phi_2008_ = _e1765;
                                                                            }
                                                                            let _e1871 = phi_2008_;
                                                                            phi_2009_ = _e1871;
                                                                        } else {
                                                                            phi_2009_ = _e1765;
                                                                        }
                                                                        let _e1873 = phi_2009_;
                                                                        phi_2010_ = _e1873;
                                                                    } else {
                                                                        phi_2010_ = _e1765;
                                                                    }
                                                                    let _e1875 = phi_2010_;
                                                                    phi_1880_ = (_e1763 + 1u);
                                                                    phi_1883_ = _e1875;
                                                                } else {
                                                                    phi_1880_ = u32();
                                                                    phi_1883_ = u32();
                                                                }
                                                                let _e1878 = phi_1880_;
                                                                let _e1880 = phi_1883_;
                                                                continue;
                                                                continuing {
                                                                    phi_1879_ = _e1878;
                                                                    phi_1882_ = _e1880;
                                                                    break if !(_e1766);
                                                                }
                                                            }
                                                            let _e1884 = nodes.member[(0u + _e1495)].links[0u];
                                                            let _e1888 = nodes.member[(0u + _e1495)].frame[3u];
                                                            let _e1892 = local_5;
                                                            if ((_e1892 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1896 = local.group_mask;
                                                                if ((_e1896 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1900 = local.len;
                                                                    if (_e1900 < 32u) {
                                                                        let _e1903 = local.group;
                                                                        let _e1905 = local.len;
                                                                        if (_e1905 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.first[(0u + _e1905)] = _e1903;
                                                                        let _e1911 = local.group_mask;
                                                                        let _e1913 = local.len;
                                                                        if (_e1913 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.mask[(0u + _e1913)] = _e1911;
                                                                        let _e1920 = local.len;
                                                                        local.len = (_e1920 + 1u);
                                                                    }
                                                                }
                                                                local.group = (_e1121 + _e1884);
                                                                let _e1924 = local_6;
                                                                local.group_mask = ((_e1924 & 4278190080u) | (_e1888 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1929 = local_7;
                                                            phi_2068_ = _e1493;
                                                            phi_2071_ = (_e1929 & 16777215u);
                                                            loop {
                                                                let _e1932 = phi_2068_;
                                                                let _e1934 = phi_2071_;
                                                                local_8 = _e1932;
                                                                if (_e1934 == 0u) {
                                                                    phi_2069_ = lt_bvh_Hit();
                                                                    phi_2072_ = u32();
                                                                    phi_2713_ = false;
                                                                } else {
                                                                    let _e1938 = nodes.member[(0u + _e1495)].links[1u];
                                                                    let _e1943 = ((_e1123 + _e1938) + select(firstTrailingBit(_e1934), 32u, (_e1934 == 0u)));
                                                                    if (_e1943 < _e70) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1950 = triangles.member[(0u + _e1943)].v0_;
                                                                    let _e1952 = (_e1950.x - _e1046);
                                                                    let _e1954 = (_e1950.y - _e1059);
                                                                    let _e1956 = (_e1950.z - _e1072);
                                                                    if (_e1328 == 0u) {
                                                                        phi_2116_ = vec3<f32>(_e1954, _e1956, _e1952);
                                                                    } else {
                                                                        if (_e1328 == 1u) {
                                                                            phi_2115_ = vec3<f32>(_e1956, _e1952, _e1954);
                                                                        } else {
                                                                            phi_2115_ = (_e1950 - vec3<f32>(_e1046, _e1059, _e1072));
                                                                        }
                                                                        let _e1964 = phi_2115_;
                                                                        phi_2116_ = _e1964;
                                                                    }
                                                                    let _e1966 = phi_2116_;
                                                                    let _e1970 = (_e1966.x - (_e1339 * _e1966.z));
                                                                    let _e1974 = (_e1966.y - (_e1342 * _e1966.z));
                                                                    let _e1976 = triangles.member[(0u + _e1943)].v1_;
                                                                    let _e1978 = (_e1976.x - _e1046);
                                                                    let _e1980 = (_e1976.y - _e1059);
                                                                    let _e1982 = (_e1976.z - _e1072);
                                                                    if (_e1328 == 0u) {
                                                                        phi_2146_ = vec3<f32>(_e1980, _e1982, _e1978);
                                                                    } else {
                                                                        if (_e1328 == 1u) {
                                                                            phi_2145_ = vec3<f32>(_e1982, _e1978, _e1980);
                                                                        } else {
                                                                            phi_2145_ = (_e1976 - vec3<f32>(_e1046, _e1059, _e1072));
                                                                        }
                                                                        let _e1990 = phi_2145_;
                                                                        phi_2146_ = _e1990;
                                                                    }
                                                                    let _e1992 = phi_2146_;
                                                                    let _e1996 = (_e1992.x - (_e1339 * _e1992.z));
                                                                    let _e2000 = (_e1992.y - (_e1342 * _e1992.z));
                                                                    let _e2002 = triangles.member[(0u + _e1943)].v2_;
                                                                    let _e2004 = (_e2002.x - _e1046);
                                                                    let _e2006 = (_e2002.y - _e1059);
                                                                    let _e2008 = (_e2002.z - _e1072);
                                                                    if (_e1328 == 0u) {
                                                                        phi_2176_ = vec3<f32>(_e2006, _e2008, _e2004);
                                                                    } else {
                                                                        if (_e1328 == 1u) {
                                                                            phi_2175_ = vec3<f32>(_e2008, _e2004, _e2006);
                                                                        } else {
                                                                            phi_2175_ = (_e2002 - vec3<f32>(_e1046, _e1059, _e1072));
                                                                        }
                                                                        let _e2016 = phi_2175_;
                                                                        phi_2176_ = _e2016;
                                                                    }
                                                                    let _e2018 = phi_2176_;
                                                                    let _e2022 = (_e2018.x - (_e1339 * _e2018.z));
                                                                    let _e2026 = (_e2018.y - (_e1342 * _e2018.z));
                                                                    if (_e1996 < _e2022) {
                                                                        phi_2195_ = true;
                                                                    } else {
                                                                        if (_e1996 == _e2022) {
                                                                            phi_2194_ = (_e2000 < _e2026);
                                                                        } else {
                                                                            phi_2194_ = false;
                                                                        }
                                                                        let _e2031 = phi_2194_;
                                                                        phi_2195_ = _e2031;
                                                                    }
                                                                    let _e2033 = phi_2195_;
                                                                    if _e2033 {
                                                                        phi_2199_ = _e2026;
                                                                        phi_2200_ = _e2022;
                                                                        phi_2201_ = _e2000;
                                                                        phi_2202_ = _e1996;
                                                                    } else {
                                                                        phi_2199_ = _e2000;
                                                                        phi_2200_ = _e1996;
                                                                        phi_2201_ = _e2026;
                                                                        phi_2202_ = _e2022;
                                                                    }
                                                                    let _e2035 = phi_2199_;
                                                                    let _e2037 = phi_2200_;
                                                                    let _e2039 = phi_2201_;
                                                                    let _e2041 = phi_2202_;
                                                                    let _e2044 = ((_e2041 * _e2035) - (_e2039 * _e2037));
                                                                    if _e2033 {
                                                                        phi_2210_ = -(_e2044);
                                                                    } else {
                                                                        phi_2210_ = _e2044;
                                                                    }
                                                                    let _e2047 = phi_2210_;
                                                                    if (_e2022 < _e1970) {
                                                                        phi_2221_ = true;
                                                                    } else {
                                                                        if (_e2022 == _e1970) {
                                                                            phi_2220_ = (_e2026 < _e1974);
                                                                        } else {
                                                                            phi_2220_ = false;
                                                                        }
                                                                        let _e2052 = phi_2220_;
                                                                        phi_2221_ = _e2052;
                                                                    }
                                                                    let _e2054 = phi_2221_;
                                                                    if _e2054 {
                                                                        phi_2225_ = _e1974;
                                                                        phi_2226_ = _e1970;
                                                                        phi_2227_ = _e2026;
                                                                        phi_2228_ = _e2022;
                                                                    } else {
                                                                        phi_2225_ = _e2026;
                                                                        phi_2226_ = _e2022;
                                                                        phi_2227_ = _e1974;
                                                                        phi_2228_ = _e1970;
                                                                    }
                                                                    let _e2056 = phi_2225_;
                                                                    let _e2058 = phi_2226_;
                                                                    let _e2060 = phi_2227_;
                                                                    let _e2062 = phi_2228_;
                                                                    let _e2065 = ((_e2062 * _e2056) - (_e2060 * _e2058));
                                                                    if _e2054 {
                                                                        phi_2236_ = -(_e2065);
                                                                    } else {
                                                                        phi_2236_ = _e2065;
                                                                    }
                                                                    let _e2068 = phi_2236_;
                                                                    if (_e1970 < _e1996) {
                                                                        phi_2247_ = true;
                                                                    } else {
                                                                        if (_e1970 == _e1996) {
                                                                            phi_2246_ = (_e1974 < _e2000);
                                                                        } else {
                                                                            phi_2246_ = false;
                                                                        }
                                                                        let _e2073 = phi_2246_;
                                                                        phi_2247_ = _e2073;
                                                                    }
                                                                    let _e2075 = phi_2247_;
                                                                    if _e2075 {
                                                                        phi_2251_ = _e2000;
                                                                        phi_2252_ = _e1996;
                                                                        phi_2253_ = _e1974;
                                                                        phi_2254_ = _e1970;
                                                                    } else {
                                                                        phi_2251_ = _e1974;
                                                                        phi_2252_ = _e1970;
                                                                        phi_2253_ = _e2000;
                                                                        phi_2254_ = _e1996;
                                                                    }
                                                                    let _e2077 = phi_2251_;
                                                                    let _e2079 = phi_2252_;
                                                                    let _e2081 = phi_2253_;
                                                                    let _e2083 = phi_2254_;
                                                                    let _e2086 = ((_e2083 * _e2077) - (_e2081 * _e2079));
                                                                    if _e2075 {
                                                                        phi_2262_ = -(_e2086);
                                                                    } else {
                                                                        phi_2262_ = _e2086;
                                                                    }
                                                                    let _e2089 = phi_2262_;
                                                                    if (_e2047 >= 0f) {
                                                                        if (_e2068 >= 0f) {
                                                                            if (_e2089 >= 0f) {
                                                                                phi_2277_ = ((_e2047 + _e2068) + _e2089);
                                                                                phi_2278_ = false;
                                                                            } else {
                                                                                phi_2277_ = f32();
                                                                                phi_2278_ = true;
                                                                            }
                                                                            let _e2096 = phi_2277_;
                                                                            let _e2098 = phi_2278_;
                                                                            phi_2279_ = _e2096;
                                                                            phi_2280_ = _e2098;
                                                                        } else {
                                                                            phi_2279_ = f32();
                                                                            phi_2280_ = true;
                                                                        }
                                                                        let _e2100 = phi_2279_;
                                                                        let _e2102 = phi_2280_;
                                                                        phi_2281_ = _e2100;
                                                                        phi_2282_ = _e2102;
                                                                    } else {
                                                                        phi_2281_ = f32();
                                                                        phi_2282_ = true;
                                                                    }
                                                                    let _e2104 = phi_2281_;
                                                                    let _e2106 = phi_2282_;
                                                                    if _e2106 {
                                                                        if (_e2047 <= 0f) {
                                                                            if (_e2068 <= 0f) {
                                                                                let _e2109 = (_e2089 <= 0f);
                                                                                if _e2109 {
                                                                                }
                                                                                phi_2300_ = ((_e2047 + _e2068) + _e2089);
                                                                                phi_2301_ = false;
                                                                                phi_2302_ = _e2109;
                                                                            } else {
                                                                                phi_2300_ = f32();
                                                                                phi_2301_ = true;
                                                                                phi_2302_ = false;
                                                                            }
                                                                            let _e2113 = phi_2300_;
                                                                            let _e2115 = phi_2301_;
                                                                            let _e2117 = phi_2302_;
                                                                            phi_2303_ = _e2113;
                                                                            phi_2304_ = _e2115;
                                                                            phi_2305_ = _e2117;
                                                                        } else {
                                                                            phi_2303_ = f32();
                                                                            phi_2304_ = true;
                                                                            phi_2305_ = false;
                                                                        }
                                                                        let _e2119 = phi_2303_;
                                                                        let _e2121 = phi_2304_;
                                                                        let _e2123 = phi_2305_;
                                                                        if _e2121 {
                                                                            phi_2309_ = false;
                                                                        } else {
                                                                            phi_2309_ = _e2123;
                                                                        }
                                                                        let _e2125 = phi_2309_;
                                                                        phi_2310_ = _e2119;
                                                                        phi_2311_ = _e2125;
                                                                    } else {
                                                                        phi_2310_ = _e2104;
                                                                        phi_2311_ = true;
                                                                    }
                                                                    let _e2127 = phi_2310_;
                                                                    let _e2129 = phi_2311_;
                                                                    if _e2129 {
                                                                        let _e2130 = (_e2127 == 0f);
                                                                        if _e2130 {
                                                                            phi_2627_ = lt_bvh_triangle_Intersection();
                                                                            phi_2628_ = false;
                                                                        } else {
                                                                            let _e2132 = triangles.member[(0u + _e1943)].v0_;
                                                                            let _e2134 = (_e2132.x - _e1046);
                                                                            let _e2136 = (_e2132.y - _e1059);
                                                                            let _e2138 = (_e2132.z - _e1072);
                                                                            if (_e1328 == 0u) {
                                                                                phi_2340_ = vec3<f32>(_e2136, _e2138, _e2134);
                                                                            } else {
                                                                                if (_e1328 == 1u) {
                                                                                    phi_2339_ = vec3<f32>(_e2138, _e2134, _e2136);
                                                                                } else {
                                                                                    phi_2339_ = (_e2132 - vec3<f32>(_e1046, _e1059, _e1072));
                                                                                }
                                                                                let _e2146 = phi_2339_;
                                                                                phi_2340_ = _e2146;
                                                                            }
                                                                            let _e2148 = phi_2340_;
                                                                            let _e2150 = triangles.member[(0u + _e1943)].v1_;
                                                                            let _e2152 = triangles.member[(0u + _e1943)].v0_;
                                                                            let _e2155 = (_e2150.x - _e2152.x);
                                                                            let _e2158 = (_e2150.y - _e2152.y);
                                                                            let _e2161 = (_e2150.z - _e2152.z);
                                                                            if (_e1328 == 0u) {
                                                                                phi_2366_ = vec3<f32>(_e2158, _e2161, _e2155);
                                                                            } else {
                                                                                if (_e1328 == 1u) {
                                                                                    phi_2365_ = vec3<f32>(_e2161, _e2155, _e2158);
                                                                                } else {
                                                                                    phi_2365_ = (_e2150 - _e2152);
                                                                                }
                                                                                let _e2168 = phi_2365_;
                                                                                phi_2366_ = _e2168;
                                                                            }
                                                                            let _e2170 = phi_2366_;
                                                                            let _e2172 = triangles.member[(0u + _e1943)].v2_;
                                                                            let _e2174 = triangles.member[(0u + _e1943)].v0_;
                                                                            let _e2177 = (_e2172.x - _e2174.x);
                                                                            let _e2180 = (_e2172.y - _e2174.y);
                                                                            let _e2183 = (_e2172.z - _e2174.z);
                                                                            if (_e1328 == 0u) {
                                                                                phi_2392_ = vec3<f32>(_e2180, _e2183, _e2177);
                                                                            } else {
                                                                                if (_e1328 == 1u) {
                                                                                    phi_2391_ = vec3<f32>(_e2183, _e2177, _e2180);
                                                                                } else {
                                                                                    phi_2391_ = (_e2172 - _e2174);
                                                                                }
                                                                                let _e2190 = phi_2391_;
                                                                                phi_2392_ = _e2190;
                                                                            }
                                                                            let _e2192 = phi_2392_;
                                                                            let _e2199 = ((_e2170.y * _e2192.z) - (_e2170.z * _e2192.y));
                                                                            let _e2206 = ((_e2170.z * _e2192.x) - (_e2170.x * _e2192.z));
                                                                            let _e2213 = ((_e2170.x * _e2192.y) - (_e2170.y * _e2192.x));
                                                                            let _e2227 = (((1f / _e1336.z) * (((_e2199 * _e2148.x) + (_e2206 * _e2148.y)) + (_e2213 * _e2148.z))) / (((_e2199 * _e1339) + (_e2206 * _e1342)) + _e2213));
                                                                            if (_e2227 > _e145.tmin) {
                                                                                if (_e2227 < _e145.tmax) {
                                                                                    let _e2231 = triangles.member[(0u + _e1943)].v0_;
                                                                                    let _e2233 = triangles.member[(0u + _e1943)].v1_;
                                                                                    if (_e2231.x < _e2233.x) {
                                                                                        phi_2448_ = _e2231.x;
                                                                                    } else {
                                                                                        phi_2448_ = _e2233.x;
                                                                                    }
                                                                                    let _e2240 = phi_2448_;
                                                                                    if (_e2231.y < _e2233.y) {
                                                                                        phi_2457_ = _e2231.y;
                                                                                    } else {
                                                                                        phi_2457_ = _e2233.y;
                                                                                    }
                                                                                    let _e2247 = phi_2457_;
                                                                                    if (_e2231.z < _e2233.z) {
                                                                                        phi_2466_ = _e2231.z;
                                                                                    } else {
                                                                                        phi_2466_ = _e2233.z;
                                                                                    }
                                                                                    let _e2254 = phi_2466_;
                                                                                    let _e2256 = triangles.member[(0u + _e1943)].v2_;
                                                                                    if (_e2240 < _e2256.x) {
                                                                                        phi_2475_ = _e2240;
                                                                                    } else {
                                                                                        phi_2475_ = _e2256.x;
                                                                                    }
                                                                                    let _e2261 = phi_2475_;
                                                                                    if (_e2247 < _e2256.y) {
                                                                                        phi_2482_ = _e2247;
                                                                                    } else {
                                                                                        phi_2482_ = _e2256.y;
                                                                                    }
                                                                                    let _e2266 = phi_2482_;
                                                                                    if (_e2254 < _e2256.z) {
                                                                                        phi_2489_ = _e2254;
                                                                                    } else {
                                                                                        phi_2489_ = _e2256.z;
                                                                                    }
                                                                                    let _e2271 = phi_2489_;
                                                                                    let _e2273 = triangles.member[(0u + _e1943)].v0_;
                                                                                    let _e2275 = triangles.member[(0u + _e1943)].v1_;
                                                                                    if (_e2273.x > _e2275.x) {
                                                                                        phi_2502_ = _e2273.x;
                                                                                    } else {
                                                                                        phi_2502_ = _e2275.x;
                                                                                    }
                                                                                    let _e2282 = phi_2502_;
                                                                                    if (_e2273.y > _e2275.y) {
                                                                                        phi_2511_ = _e2273.y;
                                                                                    } else {
                                                                                        phi_2511_ = _e2275.y;
                                                                                    }
                                                                                    let _e2289 = phi_2511_;
                                                                                    if (_e2273.z > _e2275.z) {
                                                                                        phi_2520_ = _e2273.z;
                                                                                    } else {
                                                                                        phi_2520_ = _e2275.z;
                                                                                    }
                                                                                    let _e2296 = phi_2520_;
                                                                                    let _e2298 = triangles.member[(0u + _e1943)].v2_;
                                                                                    if (_e2282 > _e2298.x) {
                                                                                        phi_2529_ = _e2282;
                                                                                    } else {
                                                                                        phi_2529_ = _e2298.x;
                                                                                    }
                                                                                    let _e2303 = phi_2529_;
                                                                                    if (_e2289 > _e2298.y) {
                                                                                        phi_2536_ = _e2289;
                                                                                    } else {
                                                                                        phi_2536_ = _e2298.y;
                                                                                    }
                                                                                    let _e2308 = phi_2536_;
                                                                                    if (_e2296 > _e2298.z) {
                                                                                        phi_2543_ = _e2296;
                                                                                    } else {
                                                                                        phi_2543_ = _e2298.z;
                                                                                    }
                                                                                    let _e2313 = phi_2543_;
                                                                                    let _e2317 = ((_e2261 - _e1046) * _e1253);
                                                                                    let _e2318 = ((_e2266 - _e1059) * _e1263);
                                                                                    let _e2319 = ((_e2271 - _e1072) * _e1273);
                                                                                    let _e2323 = ((_e2303 - _e1046) * _e1253);
                                                                                    let _e2324 = ((_e2308 - _e1059) * _e1263);
                                                                                    let _e2325 = ((_e2313 - _e1072) * _e1273);
                                                                                    if (_e2317 < _e2323) {
                                                                                        phi_2560_ = _e2317;
                                                                                    } else {
                                                                                        phi_2560_ = _e2323;
                                                                                    }
                                                                                    let _e2328 = phi_2560_;
                                                                                    if (_e2318 < _e2324) {
                                                                                        phi_2565_ = _e2318;
                                                                                    } else {
                                                                                        phi_2565_ = _e2324;
                                                                                    }
                                                                                    let _e2331 = phi_2565_;
                                                                                    if (_e2319 < _e2325) {
                                                                                        phi_2570_ = _e2319;
                                                                                    } else {
                                                                                        phi_2570_ = _e2325;
                                                                                    }
                                                                                    let _e2334 = phi_2570_;
                                                                                    if (_e2317 > _e2323) {
                                                                                        phi_2578_ = _e2317;
                                                                                    } else {
                                                                                        phi_2578_ = _e2323;
                                                                                    }
                                                                                    let _e2340 = phi_2578_;
                                                                                    if (_e2318 > _e2324) {
                                                                                        phi_2583_ = _e2318;
                                                                                    } else {
                                                                                        phi_2583_ = _e2324;
                                                                                    }
                                                                                    let _e2343 = phi_2583_;
                                                                                    if (_e2319 > _e2325) {
                                                                                        phi_2588_ = _e2319;
                                                                                    } else {
                                                                                        phi_2588_ = _e2325;
                                                                                    }
                                                                                    let _e2346 = phi_2588_;
                                                                                    let _e2350 = core_intrinsics_maximum_number_nsz_f32_((_e2328 - _e1312), (_e2331 - _e1313));
                                                                                    let _e2351 = core_intrinsics_maximum_number_nsz_f32_(_e2350, (_e2334 - _e1314));
                                                                                    let _e2352 = core_intrinsics_minimum_number_nsz_f32_((_e2340 + _e1312), (_e2343 + _e1313));
                                                                                    let _e2353 = core_intrinsics_minimum_number_nsz_f32_(_e2352, (_e2346 + _e1314));
                                                                                    if (_e2351 > _e1021) {
                                                                                        phi_2600_ = _e2351;
                                                                                    } else {
                                                                                        phi_2600_ = _e1021;
                                                                                    }
                                                                                    let _e2356 = phi_2600_;
                                                                                    if (_e2353 < _e1023) {
                                                                                        phi_2605_ = _e2353;
                                                                                    } else {
                                                                                        phi_2605_ = _e1023;
                                                                                    }
                                                                                    let _e2359 = phi_2605_;
                                                                                    if (_e2227 < _e2356) {
                                                                                        phi_2610_ = _e2356;
                                                                                    } else {
                                                                                        phi_2610_ = _e2227;
                                                                                    }
                                                                                    let _e2362 = phi_2610_;
                                                                                    if (_e2362 > _e2359) {
                                                                                        phi_2615_ = _e2359;
                                                                                    } else {
                                                                                        phi_2615_ = _e2362;
                                                                                    }
                                                                                    let _e2365 = phi_2615_;
                                                                                    phi_2620_ = lt_bvh_triangle_Intersection(_e2365, (_e2068 / _e2127), (_e2089 / _e2127), (_e2356 <= _e2359));
                                                                                    phi_2621_ = false;
                                                                                } else {
                                                                                    phi_2620_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2621_ = true;
                                                                                }
                                                                                let _e2371 = phi_2620_;
                                                                                let _e2373 = phi_2621_;
                                                                                phi_2622_ = _e2371;
                                                                                phi_2623_ = _e2373;
                                                                            } else {
                                                                                phi_2622_ = lt_bvh_triangle_Intersection();
                                                                                phi_2623_ = true;
                                                                            }
                                                                            let _e2375 = phi_2622_;
                                                                            let _e2377 = phi_2623_;
                                                                            if _e2377 {
                                                                            }
                                                                            phi_2627_ = _e2375;
                                                                            phi_2628_ = _e2377;
                                                                        }
                                                                        let _e2379 = phi_2627_;
                                                                        let _e2381 = phi_2628_;
                                                                        phi_2629_ = _e2379;
                                                                        phi_2630_ = _e2130;
                                                                        phi_2631_ = _e2381;
                                                                    } else {
                                                                        phi_2629_ = lt_bvh_triangle_Intersection();
                                                                        phi_2630_ = true;
                                                                        phi_2631_ = false;
                                                                    }
                                                                    let _e2383 = phi_2629_;
                                                                    let _e2385 = phi_2630_;
                                                                    let _e2387 = phi_2631_;
                                                                    if _e2385 {
                                                                        phi_2635_ = true;
                                                                    } else {
                                                                        phi_2635_ = _e2387;
                                                                    }
                                                                    let _e2389 = phi_2635_;
                                                                    if _e2389 {
                                                                        phi_2639_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2639_ = _e2383;
                                                                    }
                                                                    let _e2391 = phi_2639_;
                                                                    if _e2391.is_hit {
                                                                        if (_e2391.t > _e145.tmin) {
                                                                            if (_e2391.t < _e1932.t) {
                                                                                phi_2687_ = true;
                                                                            } else {
                                                                                if (_e2391.t == _e1932.t) {
                                                                                    if (_e1932.triangle != 4294967295u) {
                                                                                        if (_e1943 < _e1932.triangle) {
                                                                                            phi_2678_ = true;
                                                                                        } else {
                                                                                            if (_e1943 == _e1932.triangle) {
                                                                                                phi_2677_ = (_e962 < _e1932.instance);
                                                                                            } else {
                                                                                                phi_2677_ = false;
                                                                                            }
                                                                                            let _e2409 = phi_2677_;
                                                                                            phi_2678_ = _e2409;
                                                                                        }
                                                                                        let _e2411 = phi_2678_;
                                                                                        phi_2679_ = _e2411;
                                                                                        phi_2680_ = false;
                                                                                    } else {
                                                                                        phi_2679_ = bool();
                                                                                        phi_2680_ = true;
                                                                                    }
                                                                                    let _e2413 = phi_2679_;
                                                                                    let _e2415 = phi_2680_;
                                                                                    phi_2681_ = _e2413;
                                                                                    phi_2682_ = _e2415;
                                                                                } else {
                                                                                    phi_2681_ = bool();
                                                                                    phi_2682_ = true;
                                                                                }
                                                                                let _e2417 = phi_2681_;
                                                                                let _e2419 = phi_2682_;
                                                                                if _e2419 {
                                                                                    phi_2686_ = false;
                                                                                } else {
                                                                                    phi_2686_ = _e2417;
                                                                                }
                                                                                let _e2421 = phi_2686_;
                                                                                phi_2687_ = _e2421;
                                                                            }
                                                                            let _e2423 = phi_2687_;
                                                                            if _e2423 {
                                                                                let _e2425 = triangles.member[(0u + _e1943)].i0_;
                                                                                if ((_e2425 & 2147483648u) == 0u) {
                                                                                    phi_2701_ = true;
                                                                                } else {
                                                                                    if true {
                                                                                    }
                                                                                    phi_2701_ = true;
                                                                                }
                                                                                let _e2429 = phi_2701_;
                                                                                if _e2429 {
                                                                                    phi_2709_ = lt_bvh_Hit(_e2391.t, _e2391.u, _e2391.v, _e1943, _e962);
                                                                                } else {
                                                                                    phi_2709_ = _e1932;
                                                                                }
                                                                                let _e2435 = phi_2709_;
                                                                                phi_2710_ = _e2435;
                                                                            } else {
                                                                                phi_2710_ = _e1932;
                                                                            }
                                                                            let _e2437 = phi_2710_;
                                                                            phi_2711_ = _e2437;
                                                                        } else {
                                                                            phi_2711_ = _e1932;
                                                                        }
                                                                        let _e2439 = phi_2711_;
                                                                        phi_2712_ = _e2439;
                                                                    } else {
                                                                        phi_2712_ = _e1932;
                                                                    }
                                                                    let _e2441 = phi_2712_;
                                                                    phi_2069_ = _e2441;
                                                                    phi_2072_ = (_e1934 & (_e1934 - 1u));
                                                                    phi_2713_ = true;
                                                                }
                                                                let _e2443 = phi_2069_;
                                                                let _e2445 = phi_2072_;
                                                                let _e2447 = phi_2713_;
                                                                continue;
                                                                continuing {
                                                                    phi_2068_ = _e2443;
                                                                    phi_2071_ = _e2445;
                                                                    break if !(_e2447);
                                                                }
                                                            }
                                                            let _e2450 = local.group_mask;
                                                            if ((_e2450 & 4278190080u) == 0u) {
                                                                let _e2454 = local.len;
                                                                if (_e2454 == 0u) {
                                                                    phi_2752_ = false;
                                                                } else {
                                                                    let _e2458 = local.len;
                                                                    local.len = (_e2458 - 1u);
                                                                    let _e2461 = local.len;
                                                                    if (_e2461 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2466 = local.first[(0u + _e2461)];
                                                                    local.group = _e2466;
                                                                    let _e2469 = local.len;
                                                                    if (_e2469 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2474 = local.mask[(0u + _e2469)];
                                                                    local.group_mask = _e2474;
                                                                    phi_2752_ = true;
                                                                }
                                                                let _e2477 = phi_2752_;
                                                                phi_2753_ = _e2477;
                                                            } else {
                                                                phi_2753_ = true;
                                                            }
                                                            let _e2479 = phi_2753_;
                                                            if _e2479 {
                                                                let _e2481 = local.group_mask;
                                                                let _e2487 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2481)), 32u, (_e2481 == 0u)));
                                                                let _e2491 = local.group_mask;
                                                                let _e2505 = local.group_mask;
                                                                local.group_mask = (_e2505 & ~((1u << bitcast<u32>((_e2487 & 31u)))));
                                                                let _e2508 = local.group;
                                                                phi_2784_ = (_e2508 + countOneBits(((_e2491 & ~((4294967295u << bitcast<u32>((((_e2487 - 24u) ^ _e1355) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_2784_ = 4294967295u;
                                                            }
                                                            let _e2511 = phi_2784_;
                                                            let _e3493 = local_8;
                                                            phi_1736_ = _e3493;
                                                            phi_1739_ = _e2511;
                                                        } else {
                                                            phi_1736_ = lt_bvh_Hit();
                                                            phi_1739_ = u32();
                                                        }
                                                        let _e2513 = phi_1736_;
                                                        let _e2515 = phi_1739_;
                                                        continue;
                                                        continuing {
                                                            phi_1735_ = _e2513;
                                                            phi_1738_ = _e2515;
                                                            break if !(_e1496);
                                                        }
                                                    }
                                                    let _e3497 = local_9;
                                                    phi_2785_ = _e3497;
                                                }
                                                let _e2518 = phi_2785_;
                                                phi_2786_ = _e2518;
                                                phi_2787_ = _e1177;
                                            } else {
                                                phi_2786_ = lt_bvh_Hit();
                                                phi_2787_ = true;
                                            }
                                            let _e2520 = phi_2786_;
                                            let _e2522 = phi_2787_;
                                            if _e2522 {
                                                phi_2791_ = _e954;
                                            } else {
                                                phi_2791_ = _e2520;
                                            }
                                            let _e2524 = phi_2791_;
                                            phi_2792_ = _e2524;
                                        } else {
                                            phi_2792_ = _e954;
                                        }
                                        let _e2526 = phi_2792_;
                                        phi_2793_ = _e2526;
                                    } else {
                                        phi_2793_ = _e954;
                                    }
                                    let _e2528 = phi_2793_;
                                    phi_2794_ = _e2528;
                                } else {
                                    phi_2794_ = _e954;
                                }
                                let _e2530 = phi_2794_;
                                phi_1103_ = (_e952 & (_e952 - 1u));
                                phi_1106_ = _e2530;
                                phi_2795_ = true;
                            }
                            let _e2532 = phi_1103_;
                            let _e2534 = phi_1106_;
                            let _e2536 = phi_2795_;
                            continue;
                            continuing {
                                phi_1102_ = _e2532;
                                phi_1105_ = _e2534;
                                break if !(_e2536);
                            }
                        }
                        let _e2539 = local_1.group_mask;
                        if ((_e2539 & 4278190080u) == 0u) {
                            let _e2543 = local_1.len;
                            if (_e2543 == 0u) {
                                phi_2834_ = false;
                            } else {
                                let _e2547 = local_1.len;
                                local_1.len = (_e2547 - 1u);
                                let _e2550 = local_1.len;
                                if (_e2550 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2555 = local_1.first[(0u + _e2550)];
                                local_1.group = _e2555;
                                let _e2558 = local_1.len;
                                if (_e2558 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2563 = local_1.mask[(0u + _e2558)];
                                local_1.group_mask = _e2563;
                                phi_2834_ = true;
                            }
                            let _e2566 = phi_2834_;
                            phi_2835_ = _e2566;
                        } else {
                            phi_2835_ = true;
                        }
                        let _e2568 = phi_2835_;
                        if _e2568 {
                            let _e2570 = local_1.group_mask;
                            let _e2576 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2570)), 32u, (_e2570 == 0u)));
                            let _e2580 = local_1.group_mask;
                            let _e2594 = local_1.group_mask;
                            local_1.group_mask = (_e2594 & ~((1u << bitcast<u32>((_e2576 & 31u)))));
                            let _e2597 = local_1.group;
                            phi_2866_ = (_e2597 + countOneBits(((_e2580 & ~((4294967295u << bitcast<u32>((((_e2576 - 24u) ^ _e371) & 31u))))) & 255u)));
                        } else {
                            phi_2866_ = 4294967295u;
                        }
                        let _e2600 = phi_2866_;
                        phi_766_ = _e2600;
                        let _e3513 = local_10;
                        phi_769_ = _e3513;
                    } else {
                        phi_766_ = u32();
                        phi_769_ = lt_bvh_Hit();
                    }
                    let _e2602 = phi_766_;
                    let _e2604 = phi_769_;
                    continue;
                    continuing {
                        phi_765_ = _e2602;
                        phi_768_ = _e2604;
                        break if !(_e512);
                    }
                }
                let _e3516 = local_11;
                phi_2867_ = _e3516;
            }
            let _e2607 = phi_2867_;
            phi_2868_ = _e2607;
            phi_2869_ = _e209;
        } else {
            phi_2868_ = lt_bvh_Hit();
            phi_2869_ = true;
        }
        let _e2609 = phi_2868_;
        let _e2611 = phi_2869_;
        if _e2611 {
            phi_2873_ = _e147;
        } else {
            phi_2873_ = _e2609;
        }
        let _e2613 = phi_2873_;
        if (_e2613.triangle != 4294967295u) {
            let _e2619 = ((1f - _e2613.u) - _e2613.v);
            if (_e2613.triangle < _e70) {
            } else {
                return;
            }
            let _e2625 = triangles.member[(0u + _e2613.triangle)];
            if (_e2613.instance < _e82) {
            } else {
                return;
            }
            let _e2636 = instances.member[(0u + _e2613.instance)].object_to_world[0u];
            let _e2647 = ((((_e2636.x * _e2625.v0_.x) + (_e2636.y * _e2625.v0_.y)) + (_e2636.z * _e2625.v0_.z)) + (_e2636.w * 1f));
            let _e2649 = instances.member[(0u + _e2613.instance)].object_to_world[1u];
            let _e2660 = ((((_e2649.x * _e2625.v0_.x) + (_e2649.y * _e2625.v0_.y)) + (_e2649.z * _e2625.v0_.z)) + (_e2649.w * 1f));
            let _e2662 = instances.member[(0u + _e2613.instance)].object_to_world[2u];
            let _e2673 = ((((_e2662.x * _e2625.v0_.x) + (_e2662.y * _e2625.v0_.y)) + (_e2662.z * _e2625.v0_.z)) + (_e2662.w * 1f));
            let _e2680 = instances.member[(0u + _e2613.instance)].object_to_world[0u];
            let _e2691 = ((((_e2680.x * _e2625.v1_.x) + (_e2680.y * _e2625.v1_.y)) + (_e2680.z * _e2625.v1_.z)) + (_e2680.w * 1f));
            let _e2693 = instances.member[(0u + _e2613.instance)].object_to_world[1u];
            let _e2704 = ((((_e2693.x * _e2625.v1_.x) + (_e2693.y * _e2625.v1_.y)) + (_e2693.z * _e2625.v1_.z)) + (_e2693.w * 1f));
            let _e2706 = instances.member[(0u + _e2613.instance)].object_to_world[2u];
            let _e2717 = ((((_e2706.x * _e2625.v1_.x) + (_e2706.y * _e2625.v1_.y)) + (_e2706.z * _e2625.v1_.z)) + (_e2706.w * 1f));
            let _e2724 = instances.member[(0u + _e2613.instance)].object_to_world[0u];
            let _e2735 = ((((_e2724.x * _e2625.v2_.x) + (_e2724.y * _e2625.v2_.y)) + (_e2724.z * _e2625.v2_.z)) + (_e2724.w * 1f));
            let _e2737 = instances.member[(0u + _e2613.instance)].object_to_world[1u];
            let _e2748 = ((((_e2737.x * _e2625.v2_.x) + (_e2737.y * _e2625.v2_.y)) + (_e2737.z * _e2625.v2_.z)) + (_e2737.w * 1f));
            let _e2750 = instances.member[(0u + _e2613.instance)].object_to_world[2u];
            let _e2761 = ((((_e2750.x * _e2625.v2_.x) + (_e2750.y * _e2625.v2_.y)) + (_e2750.z * _e2625.v2_.z)) + (_e2750.w * 1f));
            let _e2774 = (((_e2647 * _e2619) + (_e2691 * _e2613.u)) + (_e2735 * _e2613.v));
            let _e2775 = (((_e2660 * _e2619) + (_e2704 * _e2613.u)) + (_e2748 * _e2613.v));
            let _e2776 = (((_e2673 * _e2619) + (_e2717 * _e2613.u)) + (_e2761 * _e2613.v));
            let _e2778 = abs(_e2647);
            let _e2779 = abs(_e2660);
            let _e2780 = abs(_e2673);
            let _e2781 = abs(_e2691);
            let _e2782 = abs(_e2704);
            let _e2783 = abs(_e2717);
            if (_e2778 > _e2781) {
                phi_3061_ = _e2778;
            } else {
                phi_3061_ = _e2781;
            }
            let _e2786 = phi_3061_;
            if (_e2779 > _e2782) {
                phi_3066_ = _e2779;
            } else {
                phi_3066_ = _e2782;
            }
            let _e2789 = phi_3066_;
            if (_e2780 > _e2783) {
                phi_3071_ = _e2780;
            } else {
                phi_3071_ = _e2783;
            }
            let _e2792 = phi_3071_;
            let _e2793 = abs(_e2735);
            let _e2794 = abs(_e2748);
            let _e2795 = abs(_e2761);
            if (_e2786 > _e2793) {
                phi_3079_ = _e2786;
            } else {
                phi_3079_ = _e2793;
            }
            let _e2798 = phi_3079_;
            if (_e2789 > _e2794) {
                phi_3084_ = _e2789;
            } else {
                phi_3084_ = _e2794;
            }
            let _e2801 = phi_3084_;
            if (_e2792 > _e2795) {
                phi_3089_ = _e2792;
            } else {
                phi_3089_ = _e2795;
            }
            let _e2804 = phi_3089_;
            let _e2805 = (_e2691 - _e2647);
            let _e2806 = (_e2704 - _e2660);
            let _e2807 = (_e2717 - _e2673);
            let _e2808 = (_e2735 - _e2647);
            let _e2809 = (_e2748 - _e2660);
            let _e2810 = (_e2761 - _e2673);
            let _e2814 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2806), abs(_e2807));
            let _e2815 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2805), _e2814);
            let _e2816 = (_e2805 / _e2815);
            let _e2817 = (_e2806 / _e2815);
            let _e2818 = (_e2807 / _e2815);
            let _e2822 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2809), abs(_e2810));
            let _e2823 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2808), _e2822);
            let _e2824 = (_e2808 / _e2823);
            let _e2825 = (_e2809 / _e2823);
            let _e2826 = (_e2810 / _e2823);
            let _e2829 = ((_e2817 * _e2826) - (_e2825 * _e2818));
            let _e2832 = ((_e2818 * _e2824) - (_e2826 * _e2816));
            let _e2835 = ((_e2816 * _e2825) - (_e2824 * _e2817));
            let _e2837 = p.member.eye;
            let _e2850 = (1f / sqrt((((_e2829 * _e2829) + (_e2832 * _e2832)) + (_e2835 * _e2835))));
            let _e2851 = (_e2829 * _e2850);
            let _e2852 = (_e2832 * _e2850);
            let _e2853 = (_e2835 * _e2850);
            if ((((_e2851 * (_e2837.x - _e2774)) + (_e2852 * (_e2837.y - _e2775))) + (_e2853 * (_e2837.z - _e2776))) < 0f) {
                phi_3153_ = vec3<f32>(-(_e2851), -(_e2852), -(_e2853));
            } else {
                phi_3153_ = vec3<f32>(_e2851, _e2852, _e2853);
            }
            let _e2866 = phi_3153_;
            if (_e2613.triangle < _e70) {
            } else {
                return;
            }
            let _e2871 = triangles.member[(0u + _e2613.triangle)];
            let _e2873 = (_e2871.i0_ & 2147483647u);
            if (_e2873 < _e73) {
            } else {
                return;
            }
            let _e2879 = vertices.member[(0u + _e2873)];
            if (_e2871.i1_ < _e73) {
            } else {
                return;
            }
            let _e2883 = vertices.member[(0u + _e2871.i1_)];
            if (_e2871.i2_ < _e73) {
            } else {
                return;
            }
            let _e2887 = vertices.member[(0u + _e2871.i2_)];
            let _e2888 = array<abi_Vertex, 3>(_e2879, _e2883, _e2887);
            if (_e2888[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e2894 = materials.member[(0u + _e2888[0].material)];
            let _e2911 = (1f / 255f);
            let _e2930 = (1f / 255f);
            let _e2952 = (1f / 255f);
            let _e2965 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e2619, _e2613.u, _e2613.v));
            let _e2967 = ((_e2894.base_color.x * ((((f32((_e2888[0].color & 255u)) * _e2911) * _e2619) + ((f32((_e2888[1].color & 255u)) * _e2930) * _e2613.u)) + ((f32((_e2888[2].color & 255u)) * _e2952) * _e2613.v))) * _e2965.x);
            let _e2969 = ((_e2894.base_color.y * ((((f32(((_e2888[0].color >> bitcast<u32>(8i)) & 255u)) * _e2911) * _e2619) + ((f32(((_e2888[1].color >> bitcast<u32>(8i)) & 255u)) * _e2930) * _e2613.u)) + ((f32(((_e2888[2].color >> bitcast<u32>(8i)) & 255u)) * _e2952) * _e2613.v))) * _e2965.y);
            let _e2971 = ((_e2894.base_color.z * ((((f32(((_e2888[0].color >> bitcast<u32>(16i)) & 255u)) * _e2911) * _e2619) + ((f32(((_e2888[1].color >> bitcast<u32>(16i)) & 255u)) * _e2930) * _e2613.u)) + ((f32(((_e2888[2].color >> bitcast<u32>(16i)) & 255u)) * _e2952) * _e2613.v))) * _e2965.z);
            let _e2972 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2801, _e2804);
            let _e2973 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2798, _e2972);
            if ((_e2894.flags & 2u) == 0u) {
                phi_3274_ = 0u;
            } else {
                phi_3274_ = 1u;
            }
            let _e2978 = phi_3274_;
            if (_e2888[0].normal == 2147516416u) {
                phi_3504_ = _e2866;
            } else {
                let _e2991 = (f32((bitcast<i32>((_e2888[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e2997 = (f32((bitcast<i32>(_e2888[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3001 = ((1f - abs(_e2991)) - abs(_e2997));
                if (_e3001 < 0f) {
                    phi_3301_ = -(_e3001);
                } else {
                    phi_3301_ = 0f;
                }
                let _e3005 = phi_3301_;
                if (_e2991 < 0f) {
                    phi_3308_ = (_e2991 + _e3005);
                } else {
                    phi_3308_ = (_e2991 - _e3005);
                }
                let _e3010 = phi_3308_;
                if (_e2997 < 0f) {
                    phi_3315_ = (_e2997 + _e3005);
                } else {
                    phi_3315_ = (_e2997 - _e3005);
                }
                let _e3015 = phi_3315_;
                let _e3022 = (1f / sqrt((((_e3010 * _e3010) + (_e3015 * _e3015)) + (_e3001 * _e3001))));
                let _e3038 = (f32((bitcast<i32>((_e2888[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3044 = (f32((bitcast<i32>(_e2888[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3048 = ((1f - abs(_e3038)) - abs(_e3044));
                if (_e3048 < 0f) {
                    phi_3350_ = -(_e3048);
                } else {
                    phi_3350_ = 0f;
                }
                let _e3052 = phi_3350_;
                if (_e3038 < 0f) {
                    phi_3357_ = (_e3038 + _e3052);
                } else {
                    phi_3357_ = (_e3038 - _e3052);
                }
                let _e3057 = phi_3357_;
                if (_e3044 < 0f) {
                    phi_3364_ = (_e3044 + _e3052);
                } else {
                    phi_3364_ = (_e3044 - _e3052);
                }
                let _e3062 = phi_3364_;
                let _e3069 = (1f / sqrt((((_e3057 * _e3057) + (_e3062 * _e3062)) + (_e3048 * _e3048))));
                let _e3088 = (f32((bitcast<i32>((_e2888[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3094 = (f32((bitcast<i32>(_e2888[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3098 = ((1f - abs(_e3088)) - abs(_e3094));
                if (_e3098 < 0f) {
                    phi_3402_ = -(_e3098);
                } else {
                    phi_3402_ = 0f;
                }
                let _e3102 = phi_3402_;
                if (_e3088 < 0f) {
                    phi_3409_ = (_e3088 + _e3102);
                } else {
                    phi_3409_ = (_e3088 - _e3102);
                }
                let _e3107 = phi_3409_;
                if (_e3094 < 0f) {
                    phi_3416_ = (_e3094 + _e3102);
                } else {
                    phi_3416_ = (_e3094 - _e3102);
                }
                let _e3112 = phi_3416_;
                let _e3119 = (1f / sqrt((((_e3107 * _e3107) + (_e3112 * _e3112)) + (_e3098 * _e3098))));
                let _e3126 = ((((_e3010 * _e3022) * _e2619) + ((_e3057 * _e3069) * _e2613.u)) + ((_e3107 * _e3119) * _e2613.v));
                let _e3127 = ((((_e3015 * _e3022) * _e2619) + ((_e3062 * _e3069) * _e2613.u)) + ((_e3112 * _e3119) * _e2613.v));
                let _e3128 = ((((_e3001 * _e3022) * _e2619) + ((_e3048 * _e3069) * _e2613.u)) + ((_e3098 * _e3119) * _e2613.v));
                if (_e2613.instance < _e82) {
                } else {
                    return;
                }
                let _e3135 = instances.member[(0u + _e2613.instance)].world_to_object[0u];
                let _e3144 = instances.member[(0u + _e2613.instance)].world_to_object[1u];
                let _e3156 = instances.member[(0u + _e2613.instance)].world_to_object[2u];
                let _e3163 = (((_e3135.x * _e3126) + (_e3144.x * _e3127)) + (_e3156.x * _e3128));
                let _e3164 = (((_e3135.y * _e3126) + (_e3144.y * _e3127)) + (_e3156.y * _e3128));
                let _e3165 = (((_e3135.z * _e3126) + (_e3144.z * _e3127)) + (_e3156.z * _e3128));
                let _e3171 = sqrt((((_e3163 * _e3163) + (_e3164 * _e3164)) + (_e3165 * _e3165)));
                if (_e3171 > 0f) {
                    let _e3173 = (_e3163 / _e3171);
                    let _e3174 = (_e3164 / _e3171);
                    let _e3175 = (_e3165 / _e3171);
                    if ((((_e3173 * _e2866.x) + (_e3174 * _e2866.y)) + (_e3175 * _e2866.z)) < 0f) {
                        phi_3502_ = vec3<f32>(-(_e3173), -(_e3174), -(_e3175));
                    } else {
                        phi_3502_ = vec3<f32>(_e3173, _e3174, _e3175);
                    }
                    let _e3191 = phi_3502_;
                    phi_3503_ = _e3191;
                } else {
                    phi_3503_ = _e2866;
                }
                let _e3193 = phi_3503_;
                phi_3504_ = _e3193;
            }
            let _e3195 = phi_3504_;
            if (_e2967 > 0f) {
                if (_e2967 < 1f) {
                    phi_3513_ = _e2967;
                } else {
                    phi_3513_ = 1f;
                }
                let _e3199 = phi_3513_;
                phi_3514_ = _e3199;
            } else {
                phi_3514_ = 0f;
            }
            let _e3201 = phi_3514_;
            if (_e2969 > 0f) {
                if (_e2969 < 1f) {
                    phi_3524_ = _e2969;
                } else {
                    phi_3524_ = 1f;
                }
                let _e3206 = phi_3524_;
                phi_3525_ = _e3206;
            } else {
                phi_3525_ = 0f;
            }
            let _e3208 = phi_3525_;
            if (_e2971 > 0f) {
                if (_e2971 < 1f) {
                    phi_3535_ = _e2971;
                } else {
                    phi_3535_ = 1f;
                }
                let _e3213 = phi_3535_;
                phi_3536_ = _e3213;
            } else {
                phi_3536_ = 0f;
            }
            let _e3215 = phi_3536_;
            let _e3218 = ((sqrt(_e3201) * 255f) + 0.5f);
            let _e3227 = ((sqrt(_e3208) * 255f) + 0.5f);
            let _e3239 = ((sqrt(_e3215) * 255f) + 0.5f);
            phi_3571_ = abi_Sample(vec3<f32>(_e2774, _e2775, _e2776), _e2973, _e2866, _e2978, _e3195, ((select(select(u32(_e3218), 0u, (_e3218 < bitcast<f32>(0u))), 4294967295u, (_e3218 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3227), 0u, (_e3227 < bitcast<f32>(0u))), 4294967295u, (_e3227 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3239), 0u, (_e3239 < bitcast<f32>(0u))), 4294967295u, (_e3239 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_3571_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3253 = phi_3571_;
        if (_e88.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e88.shift)] = _e3253;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
