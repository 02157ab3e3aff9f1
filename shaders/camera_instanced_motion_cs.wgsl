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

struct type_55 {
    member: array<lt_bvh_Instance>,
}

struct type_59 {
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
var<uniform> p: type_59;
@group(0) @binding(1) 
var<storage> nodes: type_30;
@group(0) @binding(2) 
var<storage> triangles: type_34;
@group(0) @binding(5) 
var<storage, read_write> samples: type_9;
@group(0) @binding(6) 
var<storage> instances: type_55;
@group(0) @binding(7) 
var<storage> before: type_22;
@group(0) @binding(8) 
var<storage, read_write> past: type_22;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_205_: lt_mask_LightPlace;
    var phi_206_: bool;
    var phi_207_: lt_mask_LightPlace;
    var phi_208_: bool;
    var phi_213_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_205_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_206_ = false;
        } else {
            phi_205_ = lt_mask_LightPlace();
            phi_206_ = true;
        }
        let _e76 = phi_205_;
        let _e78 = phi_206_;
        phi_207_ = _e76;
        phi_208_ = _e78;
    } else {
        phi_207_ = lt_mask_LightPlace();
        phi_208_ = true;
    }
    let _e80 = phi_207_;
    let _e82 = phi_208_;
    if _e82 {
        phi_213_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_213_ = _e80;
    }
    let _e87 = phi_213_;
    return lt_mask_LightPlace(_e87.word, _e87.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_228_: bool;
    var phi_232_: f32;

    if (param_3 != param_3) {
        phi_228_ = true;
    } else {
        let _e66 = (param_4 >= param_3);
        if _e66 {
        }
        phi_228_ = _e66;
    }
    let _e68 = phi_228_;
    if _e68 {
        phi_232_ = param_4;
    } else {
        phi_232_ = param_3;
    }
    let _e70 = phi_232_;
    return _e70;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_244_: bool;
    var phi_248_: f32;

    if (param_5 != param_5) {
        phi_244_ = true;
    } else {
        let _e66 = (param_6 <= param_5);
        if _e66 {
        }
        phi_244_ = _e66;
    }
    let _e68 = phi_244_;
    if _e68 {
        phi_248_ = param_6;
    } else {
        phi_248_ = param_5;
    }
    let _e70 = phi_248_;
    return _e70;
}

fn _lt_bvh_ray_Ray_new(param_7: vec3<f32>, param_8: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_7, 0f, param_8, 300000000000000000000000000000000000000f);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_9: f32, param_10: f32) -> f32 {
    var phi_260_: f32;

    if (param_9 > param_10) {
        phi_260_ = param_9;
    } else {
        phi_260_ = param_10;
    }
    let _e67 = phi_260_;
    return _e67;
}

fn _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(param_11: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(1f, 1f, 1f);
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: lt_bvh_traverse_Stack;
    var phi_388_: bool;
    var phi_389_: bool;
    var phi_390_: bool;
    var phi_391_: bool;
    var phi_395_: bool;
    var phi_408_: bool;
    var phi_409_: bool;
    var phi_410_: bool;
    var phi_411_: bool;
    var phi_415_: bool;
    var phi_428_: bool;
    var phi_429_: bool;
    var phi_430_: bool;
    var phi_434_: bool;
    var phi_435_: bool;
    var phi_436_: bool;
    var phi_437_: bool;
    var phi_438_: bool;
    var phi_442_: bool;
    var phi_518_: f32;
    var phi_525_: f32;
    var phi_533_: f32;
    var phi_540_: f32;
    var phi_548_: f32;
    var phi_555_: f32;
    var phi_578_: f32;
    var phi_583_: f32;
    var phi_588_: f32;
    var phi_593_: f32;
    var phi_598_: f32;
    var phi_617_: u32;
    var phi_622_: u32;
    var phi_627_: u32;
    var phi_741_: bool;
    var phi_742_: bool;
    var phi_773_: u32;
    var phi_775_: u32;
    var phi_778_: lt_bvh_Hit;
    var phi_863_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_890_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_917_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_923_: u32;
    var phi_926_: u32;
    var phi_940_: u32;
    var phi_950_: u32;
    var phi_960_: u32;
    var phi_978_: u32;
    var phi_988_: u32;
    var phi_998_: u32;
    var phi_1034_: u32;
    var phi_1047_: u32;
    var phi_1052_: u32;
    var phi_1053_: u32;
    var phi_1054_: u32;
    var phi_924_: u32;
    var phi_927_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1112_: u32;
    var phi_1115_: lt_bvh_Hit;
    var phi_1170_: f32;
    var phi_1175_: f32;
    var phi_1180_: f32;
    var phi_1188_: f32;
    var phi_1193_: f32;
    var phi_1198_: f32;
    var phi_1330_: bool;
    var phi_1331_: bool;
    var phi_1332_: bool;
    var phi_1333_: bool;
    var phi_1337_: bool;
    var phi_1350_: bool;
    var phi_1351_: bool;
    var phi_1352_: bool;
    var phi_1353_: bool;
    var phi_1357_: bool;
    var phi_1370_: bool;
    var phi_1371_: bool;
    var phi_1372_: bool;
    var phi_1376_: bool;
    var phi_1377_: bool;
    var phi_1378_: bool;
    var phi_1379_: bool;
    var phi_1380_: bool;
    var phi_1384_: bool;
    var phi_1454_: f32;
    var phi_1461_: f32;
    var phi_1468_: f32;
    var phi_1475_: f32;
    var phi_1482_: f32;
    var phi_1489_: f32;
    var phi_1506_: f32;
    var phi_1511_: f32;
    var phi_1516_: f32;
    var phi_1521_: f32;
    var phi_1526_: f32;
    var phi_1552_: bool;
    var phi_1553_: bool;
    var phi_1561_: u32;
    var phi_1562_: u32;
    var phi_1573_: vec3<f32>;
    var phi_1574_: vec3<f32>;
    var phi_1587_: u32;
    var phi_1592_: u32;
    var phi_1597_: u32;
    var phi_1711_: bool;
    var phi_1712_: bool;
    var phi_1743_: u32;
    var phi_1745_: lt_bvh_Hit;
    var phi_1748_: u32;
    var phi_1829_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1856_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1883_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1889_: u32;
    var phi_1892_: u32;
    var phi_1906_: u32;
    var phi_1916_: u32;
    var phi_1926_: u32;
    var phi_1944_: u32;
    var phi_1954_: u32;
    var phi_1964_: u32;
    var phi_2000_: u32;
    var phi_2013_: u32;
    var phi_2018_: u32;
    var phi_2019_: u32;
    var phi_2020_: u32;
    var phi_1890_: u32;
    var phi_1893_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_2078_: lt_bvh_Hit;
    var phi_2081_: u32;
    var phi_2125_: vec3<f32>;
    var phi_2126_: vec3<f32>;
    var phi_2155_: vec3<f32>;
    var phi_2156_: vec3<f32>;
    var phi_2185_: vec3<f32>;
    var phi_2186_: vec3<f32>;
    var phi_2204_: bool;
    var phi_2205_: bool;
    var phi_2209_: f32;
    var phi_2210_: f32;
    var phi_2211_: f32;
    var phi_2212_: f32;
    var phi_2220_: f32;
    var phi_2230_: bool;
    var phi_2231_: bool;
    var phi_2235_: f32;
    var phi_2236_: f32;
    var phi_2237_: f32;
    var phi_2238_: f32;
    var phi_2246_: f32;
    var phi_2256_: bool;
    var phi_2257_: bool;
    var phi_2261_: f32;
    var phi_2262_: f32;
    var phi_2263_: f32;
    var phi_2264_: f32;
    var phi_2272_: f32;
    var phi_2287_: f32;
    var phi_2288_: bool;
    var phi_2289_: f32;
    var phi_2290_: bool;
    var phi_2291_: f32;
    var phi_2292_: bool;
    var phi_2310_: f32;
    var phi_2311_: bool;
    var phi_2312_: bool;
    var phi_2313_: f32;
    var phi_2314_: bool;
    var phi_2315_: bool;
    var phi_2319_: bool;
    var phi_2320_: f32;
    var phi_2321_: bool;
    var phi_2349_: vec3<f32>;
    var phi_2350_: vec3<f32>;
    var phi_2375_: vec3<f32>;
    var phi_2376_: vec3<f32>;
    var phi_2401_: vec3<f32>;
    var phi_2402_: vec3<f32>;
    var phi_2458_: f32;
    var phi_2467_: f32;
    var phi_2476_: f32;
    var phi_2485_: f32;
    var phi_2492_: f32;
    var phi_2499_: f32;
    var phi_2512_: f32;
    var phi_2521_: f32;
    var phi_2530_: f32;
    var phi_2539_: f32;
    var phi_2546_: f32;
    var phi_2553_: f32;
    var phi_2570_: f32;
    var phi_2575_: f32;
    var phi_2580_: f32;
    var phi_2588_: f32;
    var phi_2593_: f32;
    var phi_2598_: f32;
    var phi_2610_: f32;
    var phi_2615_: f32;
    var phi_2620_: f32;
    var phi_2625_: f32;
    var phi_2630_: lt_bvh_triangle_Intersection;
    var phi_2631_: bool;
    var phi_2632_: lt_bvh_triangle_Intersection;
    var phi_2633_: bool;
    var phi_2637_: lt_bvh_triangle_Intersection;
    var phi_2638_: bool;
    var phi_2639_: lt_bvh_triangle_Intersection;
    var phi_2640_: bool;
    var phi_2641_: bool;
    var phi_2645_: bool;
    var phi_2649_: lt_bvh_triangle_Intersection;
    var phi_2687_: bool;
    var phi_2688_: bool;
    var phi_2689_: bool;
    var phi_2690_: bool;
    var phi_2691_: bool;
    var phi_2692_: bool;
    var phi_2696_: bool;
    var phi_2697_: bool;
    var phi_2711_: bool;
    var phi_2719_: lt_bvh_Hit;
    var phi_2720_: lt_bvh_Hit;
    var phi_2721_: lt_bvh_Hit;
    var phi_2722_: lt_bvh_Hit;
    var phi_2079_: lt_bvh_Hit;
    var phi_2082_: u32;
    var phi_2723_: bool;
    var phi_2762_: bool;
    var phi_2763_: bool;
    var phi_2794_: u32;
    var phi_1746_: lt_bvh_Hit;
    var phi_1749_: u32;
    var phi_2795_: lt_bvh_Hit;
    var phi_2796_: lt_bvh_Hit;
    var phi_2797_: bool;
    var phi_2801_: lt_bvh_Hit;
    var phi_2802_: lt_bvh_Hit;
    var phi_2803_: lt_bvh_Hit;
    var phi_2804_: lt_bvh_Hit;
    var phi_1113_: u32;
    var phi_1116_: lt_bvh_Hit;
    var phi_2805_: bool;
    var phi_2844_: bool;
    var phi_2845_: bool;
    var phi_2876_: u32;
    var phi_776_: u32;
    var phi_779_: lt_bvh_Hit;
    var phi_2877_: lt_bvh_Hit;
    var phi_2878_: lt_bvh_Hit;
    var phi_2879_: bool;
    var phi_2883_: lt_bvh_Hit;
    var phi_3071_: f32;
    var phi_3076_: f32;
    var phi_3081_: f32;
    var phi_3089_: f32;
    var phi_3094_: f32;
    var phi_3099_: f32;
    var phi_3163_: vec3<f32>;
    var phi_3284_: u32;
    var phi_3311_: f32;
    var phi_3318_: f32;
    var phi_3325_: f32;
    var phi_3360_: f32;
    var phi_3367_: f32;
    var phi_3374_: f32;
    var phi_3412_: f32;
    var phi_3419_: f32;
    var phi_3426_: f32;
    var phi_3512_: vec3<f32>;
    var phi_3513_: vec3<f32>;
    var phi_3514_: vec3<f32>;
    var phi_3523_: f32;
    var phi_3524_: f32;
    var phi_3534_: f32;
    var phi_3535_: f32;
    var phi_3545_: f32;
    var phi_3546_: f32;
    var phi_3581_: abi_Sample;
    var phi_3804_: vec3<f32>;
    var local_8: lt_bvh_Hit;
    var local_9: lt_bvh_Hit;
    var local_10: lt_bvh_Hit;
    var local_11: lt_bvh_Hit;

    let _e65 = id_1;
    let _e69 = arrayLength((&nodes.member));
    let _e72 = arrayLength((&triangles.member));
    let _e75 = arrayLength((&vertices.member));
    let _e84 = arrayLength((&instances.member));
    let _e87 = arrayLength((&before.member));
    let _e93 = p.member.size[0u];
    let _e95 = p.member.size[1u];
    let _e96 = lt_shaders_entry_pixel_index(_e65, _e93, _e95);
    if (bitcast<i32>(_e96.word) != 0i) {
        let _e102 = p.member.root;
        let _e106 = p.member.eye;
        let _e111 = p.member.size[0u];
        let _e115 = ((((f32(_e65.x) + 0.5f) / f32(_e111)) * 2f) - 1f);
        let _e120 = p.member.size[1u];
        let _e124 = (1f - (((f32(_e65.y) + 0.5f) / f32(_e120)) * 2f));
        let _e126 = p.member.forward;
        let _e128 = p.member.right;
        let _e142 = p.member.up;
        let _e153 = _lt_bvh_ray_Ray_new(_e106, vec3<f32>(((_e126.x + (_e128.x * _e115)) + (_e142.x * _e124)), ((_e126.y + (_e128.y * _e115)) + (_e142.y * _e124)), ((_e126.z + (_e128.z * _e115)) + (_e142.z * _e124))));
        let _e155 = lt_bvh_Hit(_e153.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e158 = abs(_e153.direction.x);
        let _e160 = abs(_e153.direction.y);
        let _e162 = abs(_e153.direction.z);
        if (abs(_e153.origin.x) < 1000000000000000f) {
            if (abs(_e153.origin.y) < 1000000000000000f) {
                phi_388_ = (abs(_e153.origin.z) < 1000000000000000f);
                phi_389_ = false;
            } else {
                phi_388_ = bool();
                phi_389_ = true;
            }
            let _e174 = phi_388_;
            let _e176 = phi_389_;
            phi_390_ = _e174;
            phi_391_ = _e176;
        } else {
            phi_390_ = bool();
            phi_391_ = true;
        }
        let _e178 = phi_390_;
        let _e180 = phi_391_;
        if _e180 {
            phi_395_ = false;
        } else {
            phi_395_ = _e178;
        }
        let _e182 = phi_395_;
        if _e182 {
            if (_e158 < 1000000000000000f) {
                if (_e160 < 1000000000000000f) {
                    phi_408_ = (_e162 < 1000000000000000f);
                    phi_409_ = false;
                } else {
                    phi_408_ = bool();
                    phi_409_ = true;
                }
                let _e187 = phi_408_;
                let _e189 = phi_409_;
                phi_410_ = _e187;
                phi_411_ = _e189;
            } else {
                phi_410_ = bool();
                phi_411_ = true;
            }
            let _e191 = phi_410_;
            let _e193 = phi_411_;
            if _e193 {
                phi_415_ = false;
            } else {
                phi_415_ = _e191;
            }
            let _e195 = phi_415_;
            if _e195 {
                if (_e158 > 0f) {
                    phi_429_ = bool();
                    phi_430_ = true;
                } else {
                    let _e197 = (_e160 > 0f);
                    if _e197 {
                        phi_428_ = bool();
                    } else {
                        phi_428_ = (_e162 > 0f);
                    }
                    let _e200 = phi_428_;
                    phi_429_ = _e200;
                    phi_430_ = _e197;
                }
                let _e202 = phi_429_;
                let _e204 = phi_430_;
                if _e204 {
                    phi_434_ = true;
                } else {
                    phi_434_ = _e202;
                }
                let _e206 = phi_434_;
                phi_435_ = _e206;
                phi_436_ = false;
            } else {
                phi_435_ = bool();
                phi_436_ = true;
            }
            let _e208 = phi_435_;
            let _e210 = phi_436_;
            phi_437_ = _e208;
            phi_438_ = _e210;
        } else {
            phi_437_ = bool();
            phi_438_ = true;
        }
        let _e212 = phi_437_;
        let _e214 = phi_438_;
        if _e214 {
            phi_442_ = false;
        } else {
            phi_442_ = _e212;
        }
        let _e216 = phi_442_;
        if _e216 {
            let _e217 = (_e102 >= _e69);
            if _e217 {
                phi_2877_ = lt_bvh_Hit();
            } else {
                if (_e102 < _e69) {
                } else {
                    return;
                }
                let _e223 = nodes.member[(0u + _e102)].frame[0u];
                let _e227 = nodes.member[(0u + _e102)].frame[1u];
                let _e231 = nodes.member[(0u + _e102)].frame[2u];
                let _e235 = nodes.member[(0u + _e102)].frame[0u];
                let _e239 = nodes.member[(0u + _e102)].frame[1u];
                let _e243 = nodes.member[(0u + _e102)].frame[2u];
                let _e247 = nodes.member[(0u + _e102)].frame[3u];
                let _e286 = core_intrinsics_maximum_number_nsz_f32_(abs(_e153.direction.x), abs(_e153.direction.y));
                let _e287 = core_intrinsics_maximum_number_nsz_f32_(_e286, abs(_e153.direction.z));
                let _e288 = (_e287 * 0.0000000000009094947f);
                if (abs(_e153.direction.x) < _e288) {
                    phi_518_ = _e288;
                } else {
                    phi_518_ = abs(_e153.direction.x);
                }
                let _e294 = phi_518_;
                if (_e153.direction.x < 0f) {
                    phi_525_ = (-1f / _e294);
                } else {
                    phi_525_ = (1f / _e294);
                }
                let _e299 = phi_525_;
                if (abs(_e153.direction.y) < _e288) {
                    phi_533_ = _e288;
                } else {
                    phi_533_ = abs(_e153.direction.y);
                }
                let _e305 = phi_533_;
                if (_e153.direction.y < 0f) {
                    phi_540_ = (-1f / _e305);
                } else {
                    phi_540_ = (1f / _e305);
                }
                let _e310 = phi_540_;
                if (abs(_e153.direction.z) < _e288) {
                    phi_548_ = _e288;
                } else {
                    phi_548_ = abs(_e153.direction.z);
                }
                let _e316 = phi_548_;
                if (_e153.direction.z < 0f) {
                    phi_555_ = (-1f / _e316);
                } else {
                    phi_555_ = (1f / _e316);
                }
                let _e321 = phi_555_;
                let _e328 = abs((bitcast<f32>(_e223) - _e153.origin.x));
                let _e329 = abs((bitcast<f32>(_e227) - _e153.origin.y));
                let _e330 = abs((bitcast<f32>(_e231) - _e153.origin.z));
                let _e337 = abs(((bitcast<f32>(_e235) + (bitcast<f32>((((_e247 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e153.origin.x));
                let _e338 = abs(((bitcast<f32>(_e239) + (bitcast<f32>((((_e247 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e153.origin.y));
                let _e339 = abs(((bitcast<f32>(_e243) + (bitcast<f32>((((_e247 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e153.origin.z));
                if (_e328 > _e337) {
                    phi_578_ = _e328;
                } else {
                    phi_578_ = _e337;
                }
                let _e342 = phi_578_;
                if (_e329 > _e338) {
                    phi_583_ = _e329;
                } else {
                    phi_583_ = _e338;
                }
                let _e345 = phi_583_;
                if (_e330 > _e339) {
                    phi_588_ = _e330;
                } else {
                    phi_588_ = _e339;
                }
                let _e348 = phi_588_;
                if (_e342 > _e345) {
                    phi_593_ = _e342;
                } else {
                    phi_593_ = _e345;
                }
                let _e351 = phi_593_;
                if (_e351 > _e348) {
                    phi_598_ = _e351;
                } else {
                    phi_598_ = _e348;
                }
                let _e354 = phi_598_;
                let _e358 = (_e354 * 0.0000019073486f);
                let _e359 = (abs(_e299) * _e358);
                let _e360 = (abs(_e310) * _e358);
                let _e361 = (abs(_e321) * _e358);
                let _e365 = (_e354 * 0.0000009536743f);
                let _e366 = (abs(_e299) * _e365);
                let _e367 = (abs(_e310) * _e365);
                let _e368 = (abs(_e321) * _e365);
                if (_e299 < 0f) {
                    phi_617_ = 0u;
                } else {
                    phi_617_ = 1u;
                }
                let _e371 = phi_617_;
                if (_e310 < 0f) {
                    phi_622_ = 0u;
                } else {
                    phi_622_ = 2u;
                }
                let _e374 = phi_622_;
                if (_e321 < 0f) {
                    phi_627_ = 0u;
                } else {
                    phi_627_ = 4u;
                }
                let _e377 = phi_627_;
                let _e379 = ((_e371 | _e374) | _e377);
                let _e380 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e102, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e380.first[0], _e380.first[1], _e380.first[2], _e380.first[3], _e380.first[4], _e380.first[5], _e380.first[6], _e380.first[7], _e380.first[8], _e380.first[9], _e380.first[10], _e380.first[11], _e380.first[12], _e380.first[13], _e380.first[14], _e380.first[15], _e380.first[16], _e380.first[17], _e380.first[18], _e380.first[19], _e380.first[20], _e380.first[21], _e380.first[22], _e380.first[23], _e380.first[24], _e380.first[25], _e380.first[26], _e380.first[27], _e380.first[28], _e380.first[29], _e380.first[30], _e380.first[31]), array<u32, 32>(_e380.mask[0], _e380.mask[1], _e380.mask[2], _e380.mask[3], _e380.mask[4], _e380.mask[5], _e380.mask[6], _e380.mask[7], _e380.mask[8], _e380.mask[9], _e380.mask[10], _e380.mask[11], _e380.mask[12], _e380.mask[13], _e380.mask[14], _e380.mask[15], _e380.mask[16], _e380.mask[17], _e380.mask[18], _e380.mask[19], _e380.mask[20], _e380.mask[21], _e380.mask[22], _e380.mask[23], _e380.mask[24], _e380.mask[25], _e380.mask[26], _e380.mask[27], _e380.mask[28], _e380.mask[29], _e380.mask[30], _e380.mask[31]), _e380.len, _e380.group, _e380.group_mask);
                let _e454 = local_1.group_mask;
                if ((_e454 & 4278190080u) == 0u) {
                    let _e458 = local_1.len;
                    if (_e458 == 0u) {
                        phi_741_ = false;
                    } else {
                        let _e462 = local_1.len;
                        local_1.len = (_e462 - 1u);
                        let _e465 = local_1.len;
                        if (_e465 < 32u) {
                        } else {
                            return;
                        }
                        let _e470 = local_1.first[(0u + _e465)];
                        local_1.group = _e470;
                        let _e473 = local_1.len;
                        if (_e473 < 32u) {
                        } else {
                            return;
                        }
                        let _e478 = local_1.mask[(0u + _e473)];
                        local_1.group_mask = _e478;
                        phi_741_ = true;
                    }
                    let _e481 = phi_741_;
                    phi_742_ = _e481;
                } else {
                    phi_742_ = true;
                }
                let _e483 = phi_742_;
                if _e483 {
                    let _e485 = local_1.group_mask;
                    let _e491 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e485)), 32u, (_e485 == 0u)));
                    let _e495 = local_1.group_mask;
                    let _e509 = local_1.group_mask;
                    local_1.group_mask = (_e509 & ~((1u << bitcast<u32>((_e491 & 31u)))));
                    let _e512 = local_1.group;
                    phi_773_ = (_e512 + countOneBits(((_e495 & ~((4294967295u << bitcast<u32>((((_e491 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_773_ = 4294967295u;
                }
                let _e515 = phi_773_;
                phi_775_ = _e515;
                phi_778_ = _e155;
                loop {
                    let _e517 = phi_775_;
                    let _e519 = phi_778_;
                    local_11 = _e519;
                    let _e520 = (_e517 != 4294967295u);
                    if _e520 {
                        if (_e517 < _e69) {
                        } else {
                            return;
                        }
                        let _e528 = nodes.member[(0u + _e517)].frame[3u];
                        let _e553 = (bitcast<f32>((((_e528 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e299);
                        let _e554 = (bitcast<f32>((((_e528 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e310);
                        let _e555 = (bitcast<f32>((((_e528 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e321);
                        let _e558 = nodes.member[(0u + _e517)].frame[0u];
                        let _e562 = nodes.member[(0u + _e517)].frame[1u];
                        let _e566 = nodes.member[(0u + _e517)].frame[2u];
                        let _e574 = ((bitcast<f32>(_e558) - _e153.origin.x) * _e299);
                        let _e575 = ((bitcast<f32>(_e562) - _e153.origin.y) * _e310);
                        let _e576 = ((bitcast<f32>(_e566) - _e153.origin.z) * _e321);
                        let _e584 = nodes.member[(0u + _e517)].x;
                        if (_e299 < 0f) {
                            let _e595 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e584.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e601 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e595.unnamed.word, _e584.w), _e595.unnamed_1);
                            let _e607 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e601.unnamed, lt_mask_LightPlace(_e584.x, _e601.unnamed_1.shift));
                            phi_863_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e607.unnamed, lt_mask_LightPlace(_e607.unnamed_1.word, _e584.y));
                        } else {
                            let _e623 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e584.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e629 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e623.unnamed.word, _e584.y), _e623.unnamed_1);
                            let _e635 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e629.unnamed, lt_mask_LightPlace(_e584.z, _e629.unnamed_1.shift));
                            phi_863_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e635.unnamed, lt_mask_LightPlace(_e635.unnamed_1.word, _e584.w));
                        }
                        let _e643 = phi_863_;
                        let _e653 = nodes.member[(0u + _e517)].y;
                        if (_e310 < 0f) {
                            let _e664 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e653.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e670 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e664.unnamed.word, _e653.w), _e664.unnamed_1);
                            let _e676 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e670.unnamed, lt_mask_LightPlace(_e653.x, _e670.unnamed_1.shift));
                            phi_890_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e676.unnamed, lt_mask_LightPlace(_e676.unnamed_1.word, _e653.y));
                        } else {
                            let _e692 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e653.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e698 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e692.unnamed.word, _e653.y), _e692.unnamed_1);
                            let _e704 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e698.unnamed, lt_mask_LightPlace(_e653.z, _e698.unnamed_1.shift));
                            phi_890_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e704.unnamed, lt_mask_LightPlace(_e704.unnamed_1.word, _e653.w));
                        }
                        let _e712 = phi_890_;
                        let _e722 = nodes.member[(0u + _e517)].z;
                        if (_e321 < 0f) {
                            let _e733 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e722.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e739 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e733.unnamed.word, _e722.w), _e733.unnamed_1);
                            let _e745 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e739.unnamed, lt_mask_LightPlace(_e722.x, _e739.unnamed_1.shift));
                            phi_917_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e745.unnamed, lt_mask_LightPlace(_e745.unnamed_1.word, _e722.y));
                        } else {
                            let _e761 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e722.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e767 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e761.unnamed.word, _e722.y), _e761.unnamed_1);
                            let _e773 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e767.unnamed, lt_mask_LightPlace(_e722.z, _e767.unnamed_1.shift));
                            phi_917_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e773.unnamed, lt_mask_LightPlace(_e773.unnamed_1.word, _e722.w));
                        }
                        let _e781 = phi_917_;
                        phi_923_ = 0u;
                        phi_926_ = 0u;
                        loop {
                            let _e791 = phi_923_;
                            let _e793 = phi_926_;
                            local_2 = _e793;
                            local_3 = _e793;
                            local_4 = _e793;
                            let _e794 = (_e791 < 8u);
                            if _e794 {
                                let _e796 = (_e791 >> bitcast<u32>(2i));
                                let _e797 = (_e791 & 3u);
                                if (_e796 == 0u) {
                                    phi_940_ = _e643.unnamed.word;
                                } else {
                                    phi_940_ = _e643.unnamed.shift;
                                }
                                let _e800 = phi_940_;
                                if (_e796 == 0u) {
                                    phi_950_ = _e712.unnamed.word;
                                } else {
                                    phi_950_ = _e712.unnamed.shift;
                                }
                                let _e809 = phi_950_;
                                if (_e796 == 0u) {
                                    phi_960_ = _e781.unnamed.word;
                                } else {
                                    phi_960_ = _e781.unnamed.shift;
                                }
                                let _e818 = phi_960_;
                                let _e831 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e800 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e553) + (_e574 - _e359)), ((f32(((_e809 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e554) + (_e575 - _e360)));
                                let _e832 = core_intrinsics_maximum_number_nsz_f32_(_e831, ((f32(((_e818 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e555) + (_e576 - _e361)));
                                if (_e796 == 0u) {
                                    phi_978_ = _e643.unnamed_1.word;
                                } else {
                                    phi_978_ = _e643.unnamed_1.shift;
                                }
                                let _e835 = phi_978_;
                                if (_e796 == 0u) {
                                    phi_988_ = _e712.unnamed_1.word;
                                } else {
                                    phi_988_ = _e712.unnamed_1.shift;
                                }
                                let _e844 = phi_988_;
                                if (_e796 == 0u) {
                                    phi_998_ = _e781.unnamed_1.word;
                                } else {
                                    phi_998_ = _e781.unnamed_1.shift;
                                }
                                let _e853 = phi_998_;
                                let _e866 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e835 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e553) + (_e574 + _e359)), ((f32(((_e844 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e554) + (_e575 + _e360)));
                                let _e867 = core_intrinsics_minimum_number_nsz_f32_(_e866, ((f32(((_e853 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e555) + (_e576 + _e361)));
                                if (_e832 <= _e867) {
                                    if (_e832 <= _e519.t) {
                                        if (_e867 >= _e153.tmin) {
                                            if (_e796 == 0u) {
                                                let _e874 = nodes.member[(0u + _e517)].links[2u];
                                                phi_1034_ = _e874;
                                            } else {
                                                let _e877 = nodes.member[(0u + _e517)].links[3u];
                                                phi_1034_ = _e877;
                                            }
                                            let _e879 = phi_1034_;
                                            let _e884 = ((_e879 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u);
                                            let _e885 = (_e884 & 31u);
                                            if (_e885 >= 24u) {
                                                phi_1047_ = (24u + ((_e885 - 24u) ^ _e379));
                                            } else {
                                                phi_1047_ = _e885;
                                            }
                                            let _e891 = phi_1047_;
                                            phi_1052_ = (_e793 | ((_e884 >> bitcast<u32>(5i)) << bitcast<u32>((_e891 & 31u))));
                                        } else {
                                            phi_1052_ = _e793;
                                        }
                                        let _e899 = phi_1052_;
                                        phi_1053_ = _e899;
                                    } else {
                                        phi_1053_ = _e793;
                                    }
                                    let _e901 = phi_1053_;
                                    phi_1054_ = _e901;
                                } else {
                                    phi_1054_ = _e793;
                                }
                                let _e903 = phi_1054_;
                                phi_924_ = (_e791 + 1u);
                                phi_927_ = _e903;
                            } else {
                                phi_924_ = u32();
                                phi_927_ = u32();
                            }
                            let _e906 = phi_924_;
                            let _e908 = phi_927_;
                            continue;
                            continuing {
                                phi_923_ = _e906;
                                phi_926_ = _e908;
                                break if !(_e794);
                            }
                        }
                        let _e912 = nodes.member[(0u + _e517)].links[0u];
                        let _e916 = nodes.member[(0u + _e517)].frame[3u];
                        let _e920 = local_2;
                        if ((_e920 & 4278190080u) == 0u) {
                        } else {
                            let _e924 = local_1.group_mask;
                            if ((_e924 & 4278190080u) == 0u) {
                            } else {
                                let _e928 = local_1.len;
                                if (_e928 < 32u) {
                                    let _e931 = local_1.group;
                                    let _e933 = local_1.len;
                                    if (_e933 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e933)] = _e931;
                                    let _e939 = local_1.group_mask;
                                    let _e941 = local_1.len;
                                    if (_e941 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e941)] = _e939;
                                    let _e948 = local_1.len;
                                    local_1.len = (_e948 + 1u);
                                }
                            }
                            local_1.group = (_e102 + _e912);
                            let _e952 = local_3;
                            local_1.group_mask = ((_e952 & 4278190080u) | (_e916 >> bitcast<u32>(24i)));
                        }
                        let _e957 = local_4;
                        phi_1112_ = (_e957 & 16777215u);
                        phi_1115_ = _e519;
                        loop {
                            let _e960 = phi_1112_;
                            let _e962 = phi_1115_;
                            local_10 = _e962;
                            if (_e960 == 0u) {
                                phi_1113_ = u32();
                                phi_1116_ = lt_bvh_Hit();
                                phi_2805_ = false;
                            } else {
                                let _e966 = nodes.member[(0u + _e517)].links[1u];
                                let _e970 = (_e966 + select(firstTrailingBit(_e960), 32u, (_e960 == 0u)));
                                if (_e970 < _e84) {
                                } else {
                                    return;
                                }
                                let _e977 = instances.member[(0u + _e970)].low_world;
                                let _e979 = instances.member[(0u + _e970)].high_world;
                                let _e989 = ((_e977.x - _e153.origin.x) * _e299);
                                let _e990 = ((_e977.y - _e153.origin.y) * _e310);
                                let _e991 = ((_e977.z - _e153.origin.z) * _e321);
                                let _e1001 = ((_e979.x - _e153.origin.x) * _e299);
                                let _e1002 = ((_e979.y - _e153.origin.y) * _e310);
                                let _e1003 = ((_e979.z - _e153.origin.z) * _e321);
                                if (_e989 < _e1001) {
                                    phi_1170_ = _e989;
                                } else {
                                    phi_1170_ = _e1001;
                                }
                                let _e1006 = phi_1170_;
                                if (_e990 < _e1002) {
                                    phi_1175_ = _e990;
                                } else {
                                    phi_1175_ = _e1002;
                                }
                                let _e1009 = phi_1175_;
                                if (_e991 < _e1003) {
                                    phi_1180_ = _e991;
                                } else {
                                    phi_1180_ = _e1003;
                                }
                                let _e1012 = phi_1180_;
                                if (_e989 > _e1001) {
                                    phi_1188_ = _e989;
                                } else {
                                    phi_1188_ = _e1001;
                                }
                                let _e1018 = phi_1188_;
                                if (_e990 > _e1002) {
                                    phi_1193_ = _e990;
                                } else {
                                    phi_1193_ = _e1002;
                                }
                                let _e1021 = phi_1193_;
                                if (_e991 > _e1003) {
                                    phi_1198_ = _e991;
                                } else {
                                    phi_1198_ = _e1003;
                                }
                                let _e1024 = phi_1198_;
                                let _e1028 = core_intrinsics_maximum_number_nsz_f32_((_e1006 - _e366), (_e1009 - _e367));
                                let _e1029 = core_intrinsics_maximum_number_nsz_f32_(_e1028, (_e1012 - _e368));
                                let _e1030 = core_intrinsics_minimum_number_nsz_f32_((_e1018 + _e366), (_e1021 + _e367));
                                let _e1031 = core_intrinsics_minimum_number_nsz_f32_(_e1030, (_e1024 + _e368));
                                if (_e1029 <= _e1031) {
                                    if (_e1029 <= _e962.t) {
                                        if (_e1031 >= _e153.tmin) {
                                            let _e1043 = instances.member[(0u + _e970)].world_to_object[0u];
                                            let _e1054 = ((((_e1043.x * _e153.origin.x) + (_e1043.y * _e153.origin.y)) + (_e1043.z * _e153.origin.z)) + (_e1043.w * 1f));
                                            let _e1056 = instances.member[(0u + _e970)].world_to_object[1u];
                                            let _e1067 = ((((_e1056.x * _e153.origin.x) + (_e1056.y * _e153.origin.y)) + (_e1056.z * _e153.origin.z)) + (_e1056.w * 1f));
                                            let _e1069 = instances.member[(0u + _e970)].world_to_object[2u];
                                            let _e1080 = ((((_e1069.x * _e153.origin.x) + (_e1069.y * _e153.origin.y)) + (_e1069.z * _e153.origin.z)) + (_e1069.w * 1f));
                                            let _e1087 = instances.member[(0u + _e970)].world_to_object[0u];
                                            let _e1098 = ((((_e1087.x * _e153.direction.x) + (_e1087.y * _e153.direction.y)) + (_e1087.z * _e153.direction.z)) + (_e1087.w * 0f));
                                            let _e1100 = instances.member[(0u + _e970)].world_to_object[1u];
                                            let _e1111 = ((((_e1100.x * _e153.direction.x) + (_e1100.y * _e153.direction.y)) + (_e1100.z * _e153.direction.z)) + (_e1100.w * 0f));
                                            let _e1113 = instances.member[(0u + _e970)].world_to_object[2u];
                                            let _e1124 = ((((_e1113.x * _e153.direction.x) + (_e1113.y * _e153.direction.y)) + (_e1113.z * _e153.direction.z)) + (_e1113.w * 0f));
                                            let _e1129 = instances.member[(0u + _e970)].root;
                                            let _e1131 = instances.member[(0u + _e970)].first_triangle;
                                            let _e1132 = abs(_e1098);
                                            let _e1133 = abs(_e1111);
                                            let _e1134 = abs(_e1124);
                                            if (abs(_e1054) < 1000000000000000f) {
                                                if (abs(_e1067) < 1000000000000000f) {
                                                    phi_1330_ = (abs(_e1080) < 1000000000000000f);
                                                    phi_1331_ = false;
                                                } else {
                                                    phi_1330_ = bool();
                                                    phi_1331_ = true;
                                                }
                                                let _e1142 = phi_1330_;
                                                let _e1144 = phi_1331_;
                                                phi_1332_ = _e1142;
                                                phi_1333_ = _e1144;
                                            } else {
                                                phi_1332_ = bool();
                                                phi_1333_ = true;
                                            }
                                            let _e1146 = phi_1332_;
                                            let _e1148 = phi_1333_;
                                            if _e1148 {
                                                phi_1337_ = false;
                                            } else {
                                                phi_1337_ = _e1146;
                                            }
                                            let _e1150 = phi_1337_;
                                            if _e1150 {
                                                if (_e1132 < 1000000000000000f) {
                                                    if (_e1133 < 1000000000000000f) {
                                                        phi_1350_ = (_e1134 < 1000000000000000f);
                                                        phi_1351_ = false;
                                                    } else {
                                                        phi_1350_ = bool();
                                                        phi_1351_ = true;
                                                    }
                                                    let _e1155 = phi_1350_;
                                                    let _e1157 = phi_1351_;
                                                    phi_1352_ = _e1155;
                                                    phi_1353_ = _e1157;
                                                } else {
                                                    phi_1352_ = bool();
                                                    phi_1353_ = true;
                                                }
                                                let _e1159 = phi_1352_;
                                                let _e1161 = phi_1353_;
                                                if _e1161 {
                                                    phi_1357_ = false;
                                                } else {
                                                    phi_1357_ = _e1159;
                                                }
                                                let _e1163 = phi_1357_;
                                                if _e1163 {
                                                    if (_e1132 > 0f) {
                                                        phi_1371_ = bool();
                                                        phi_1372_ = true;
                                                    } else {
                                                        let _e1165 = (_e1133 > 0f);
                                                        if _e1165 {
                                                            phi_1370_ = bool();
                                                        } else {
                                                            phi_1370_ = (_e1134 > 0f);
                                                        }
                                                        let _e1168 = phi_1370_;
                                                        phi_1371_ = _e1168;
                                                        phi_1372_ = _e1165;
                                                    }
                                                    let _e1170 = phi_1371_;
                                                    let _e1172 = phi_1372_;
                                                    if _e1172 {
                                                        phi_1376_ = true;
                                                    } else {
                                                        phi_1376_ = _e1170;
                                                    }
                                                    let _e1174 = phi_1376_;
                                                    phi_1377_ = _e1174;
                                                    phi_1378_ = false;
                                                } else {
                                                    phi_1377_ = bool();
                                                    phi_1378_ = true;
                                                }
                                                let _e1176 = phi_1377_;
                                                let _e1178 = phi_1378_;
                                                phi_1379_ = _e1176;
                                                phi_1380_ = _e1178;
                                            } else {
                                                phi_1379_ = bool();
                                                phi_1380_ = true;
                                            }
                                            let _e1180 = phi_1379_;
                                            let _e1182 = phi_1380_;
                                            if _e1182 {
                                                phi_1384_ = false;
                                            } else {
                                                phi_1384_ = _e1180;
                                            }
                                            let _e1184 = phi_1384_;
                                            if _e1184 {
                                                let _e1185 = (_e1129 >= _e69);
                                                if _e1185 {
                                                    phi_2795_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1129 < _e69) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1191 = nodes.member[(0u + _e1129)].frame[0u];
                                                    let _e1195 = nodes.member[(0u + _e1129)].frame[1u];
                                                    let _e1199 = nodes.member[(0u + _e1129)].frame[2u];
                                                    let _e1203 = nodes.member[(0u + _e1129)].frame[0u];
                                                    let _e1207 = nodes.member[(0u + _e1129)].frame[1u];
                                                    let _e1211 = nodes.member[(0u + _e1129)].frame[2u];
                                                    let _e1215 = nodes.member[(0u + _e1129)].frame[3u];
                                                    let _e1249 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1098), abs(_e1111));
                                                    let _e1250 = core_intrinsics_maximum_number_nsz_f32_(_e1249, abs(_e1124));
                                                    let _e1251 = (_e1250 * 0.0000000000009094947f);
                                                    if (abs(_e1098) < _e1251) {
                                                        phi_1454_ = _e1251;
                                                    } else {
                                                        phi_1454_ = abs(_e1098);
                                                    }
                                                    let _e1256 = phi_1454_;
                                                    if (_e1098 < 0f) {
                                                        phi_1461_ = (-1f / _e1256);
                                                    } else {
                                                        phi_1461_ = (1f / _e1256);
                                                    }
                                                    let _e1261 = phi_1461_;
                                                    if (abs(_e1111) < _e1251) {
                                                        phi_1468_ = _e1251;
                                                    } else {
                                                        phi_1468_ = abs(_e1111);
                                                    }
                                                    let _e1266 = phi_1468_;
                                                    if (_e1111 < 0f) {
                                                        phi_1475_ = (-1f / _e1266);
                                                    } else {
                                                        phi_1475_ = (1f / _e1266);
                                                    }
                                                    let _e1271 = phi_1475_;
                                                    if (abs(_e1124) < _e1251) {
                                                        phi_1482_ = _e1251;
                                                    } else {
                                                        phi_1482_ = abs(_e1124);
                                                    }
                                                    let _e1276 = phi_1482_;
                                                    if (_e1124 < 0f) {
                                                        phi_1489_ = (-1f / _e1276);
                                                    } else {
                                                        phi_1489_ = (1f / _e1276);
                                                    }
                                                    let _e1281 = phi_1489_;
                                                    let _e1285 = abs((bitcast<f32>(_e1191) - _e1054));
                                                    let _e1286 = abs((bitcast<f32>(_e1195) - _e1067));
                                                    let _e1287 = abs((bitcast<f32>(_e1199) - _e1080));
                                                    let _e1291 = abs(((bitcast<f32>(_e1203) + (bitcast<f32>((((_e1215 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1054));
                                                    let _e1292 = abs(((bitcast<f32>(_e1207) + (bitcast<f32>((((_e1215 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1067));
                                                    let _e1293 = abs(((bitcast<f32>(_e1211) + (bitcast<f32>((((_e1215 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1080));
                                                    if (_e1285 > _e1291) {
                                                        phi_1506_ = _e1285;
                                                    } else {
                                                        phi_1506_ = _e1291;
                                                    }
                                                    let _e1296 = phi_1506_;
                                                    if (_e1286 > _e1292) {
                                                        phi_1511_ = _e1286;
                                                    } else {
                                                        phi_1511_ = _e1292;
                                                    }
                                                    let _e1299 = phi_1511_;
                                                    if (_e1287 > _e1293) {
                                                        phi_1516_ = _e1287;
                                                    } else {
                                                        phi_1516_ = _e1293;
                                                    }
                                                    let _e1302 = phi_1516_;
                                                    if (_e1296 > _e1299) {
                                                        phi_1521_ = _e1296;
                                                    } else {
                                                        phi_1521_ = _e1299;
                                                    }
                                                    let _e1305 = phi_1521_;
                                                    if (_e1305 > _e1302) {
                                                        phi_1526_ = _e1305;
                                                    } else {
                                                        phi_1526_ = _e1302;
                                                    }
                                                    let _e1308 = phi_1526_;
                                                    let _e1312 = (_e1308 * 0.0000019073486f);
                                                    let _e1313 = (abs(_e1261) * _e1312);
                                                    let _e1314 = (abs(_e1271) * _e1312);
                                                    let _e1315 = (abs(_e1281) * _e1312);
                                                    let _e1319 = (_e1308 * 0.0000009536743f);
                                                    let _e1320 = (abs(_e1261) * _e1319);
                                                    let _e1321 = (abs(_e1271) * _e1319);
                                                    let _e1322 = (abs(_e1281) * _e1319);
                                                    let _e1323 = abs(_e1098);
                                                    let _e1324 = abs(_e1111);
                                                    let _e1325 = abs(_e1124);
                                                    if (_e1323 >= _e1324) {
                                                        if (_e1323 >= _e1325) {
                                                            phi_1552_ = false;
                                                        } else {
                                                            phi_1552_ = true;
                                                        }
                                                        let _e1329 = phi_1552_;
                                                        phi_1553_ = _e1329;
                                                    } else {
                                                        phi_1553_ = true;
                                                    }
                                                    let _e1331 = phi_1553_;
                                                    if _e1331 {
                                                        if (_e1324 >= _e1325) {
                                                            phi_1561_ = 1u;
                                                        } else {
                                                            phi_1561_ = 2u;
                                                        }
                                                        let _e1334 = phi_1561_;
                                                        phi_1562_ = _e1334;
                                                    } else {
                                                        phi_1562_ = 0u;
                                                    }
                                                    let _e1336 = phi_1562_;
                                                    if (_e1336 == 0u) {
                                                        phi_1574_ = vec3<f32>(_e1111, _e1124, _e1098);
                                                    } else {
                                                        if (_e1336 == 1u) {
                                                            phi_1573_ = vec3<f32>(_e1124, _e1098, _e1111);
                                                        } else {
                                                            phi_1573_ = vec3<f32>(_e1098, _e1111, _e1124);
                                                        }
                                                        let _e1342 = phi_1573_;
                                                        phi_1574_ = _e1342;
                                                    }
                                                    let _e1344 = phi_1574_;
                                                    let _e1347 = (_e1344.x / _e1344.z);
                                                    let _e1350 = (_e1344.y / _e1344.z);
                                                    if (_e1261 < 0f) {
                                                        phi_1587_ = 0u;
                                                    } else {
                                                        phi_1587_ = 1u;
                                                    }
                                                    let _e1355 = phi_1587_;
                                                    if (_e1271 < 0f) {
                                                        phi_1592_ = 0u;
                                                    } else {
                                                        phi_1592_ = 2u;
                                                    }
                                                    let _e1358 = phi_1592_;
                                                    if (_e1281 < 0f) {
                                                        phi_1597_ = 0u;
                                                    } else {
                                                        phi_1597_ = 4u;
                                                    }
                                                    let _e1361 = phi_1597_;
                                                    let _e1363 = ((_e1355 | _e1358) | _e1361);
                                                    let _e1364 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1129, 2147483648u);
                                                    local = lt_bvh_traverse_Stack(array<u32, 32>(_e1364.first[0], _e1364.first[1], _e1364.first[2], _e1364.first[3], _e1364.first[4], _e1364.first[5], _e1364.first[6], _e1364.first[7], _e1364.first[8], _e1364.first[9], _e1364.first[10], _e1364.first[11], _e1364.first[12], _e1364.first[13], _e1364.first[14], _e1364.first[15], _e1364.first[16], _e1364.first[17], _e1364.first[18], _e1364.first[19], _e1364.first[20], _e1364.first[21], _e1364.first[22], _e1364.first[23], _e1364.first[24], _e1364.first[25], _e1364.first[26], _e1364.first[27], _e1364.first[28], _e1364.first[29], _e1364.first[30], _e1364.first[31]), array<u32, 32>(_e1364.mask[0], _e1364.mask[1], _e1364.mask[2], _e1364.mask[3], _e1364.mask[4], _e1364.mask[5], _e1364.mask[6], _e1364.mask[7], _e1364.mask[8], _e1364.mask[9], _e1364.mask[10], _e1364.mask[11], _e1364.mask[12], _e1364.mask[13], _e1364.mask[14], _e1364.mask[15], _e1364.mask[16], _e1364.mask[17], _e1364.mask[18], _e1364.mask[19], _e1364.mask[20], _e1364.mask[21], _e1364.mask[22], _e1364.mask[23], _e1364.mask[24], _e1364.mask[25], _e1364.mask[26], _e1364.mask[27], _e1364.mask[28], _e1364.mask[29], _e1364.mask[30], _e1364.mask[31]), _e1364.len, _e1364.group, _e1364.group_mask);
                                                    let _e1438 = local.group_mask;
                                                    if ((_e1438 & 4278190080u) == 0u) {
                                                        let _e1442 = local.len;
                                                        if (_e1442 == 0u) {
                                                            phi_1711_ = false;
                                                        } else {
                                                            let _e1446 = local.len;
                                                            local.len = (_e1446 - 1u);
                                                            let _e1449 = local.len;
                                                            if (_e1449 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1454 = local.first[(0u + _e1449)];
                                                            local.group = _e1454;
                                                            let _e1457 = local.len;
                                                            if (_e1457 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1462 = local.mask[(0u + _e1457)];
                                                            local.group_mask = _e1462;
                                                            phi_1711_ = true;
                                                        }
                                                        let _e1465 = phi_1711_;
                                                        phi_1712_ = _e1465;
                                                    } else {
                                                        phi_1712_ = true;
                                                    }
                                                    let _e1467 = phi_1712_;
                                                    if _e1467 {
                                                        let _e1469 = local.group_mask;
                                                        let _e1475 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1469)), 32u, (_e1469 == 0u)));
                                                        let _e1479 = local.group_mask;
                                                        let _e1493 = local.group_mask;
                                                        local.group_mask = (_e1493 & ~((1u << bitcast<u32>((_e1475 & 31u)))));
                                                        let _e1496 = local.group;
                                                        phi_1743_ = (_e1496 + countOneBits(((_e1479 & ~((4294967295u << bitcast<u32>((((_e1475 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_1743_ = 4294967295u;
                                                    }
                                                    let _e1499 = phi_1743_;
                                                    phi_1745_ = _e962;
                                                    phi_1748_ = _e1499;
                                                    loop {
                                                        let _e1501 = phi_1745_;
                                                        let _e1503 = phi_1748_;
                                                        local_9 = _e1501;
                                                        let _e1504 = (_e1503 != 4294967295u);
                                                        if _e1504 {
                                                            if (_e1503 < _e69) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1511 = nodes.member[(0u + _e1503)].frame[3u];
                                                            let _e1536 = (bitcast<f32>((((_e1511 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1261);
                                                            let _e1537 = (bitcast<f32>((((_e1511 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1271);
                                                            let _e1538 = (bitcast<f32>((((_e1511 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1281);
                                                            let _e1541 = nodes.member[(0u + _e1503)].frame[0u];
                                                            let _e1545 = nodes.member[(0u + _e1503)].frame[1u];
                                                            let _e1549 = nodes.member[(0u + _e1503)].frame[2u];
                                                            let _e1554 = ((bitcast<f32>(_e1541) - _e1054) * _e1261);
                                                            let _e1555 = ((bitcast<f32>(_e1545) - _e1067) * _e1271);
                                                            let _e1556 = ((bitcast<f32>(_e1549) - _e1080) * _e1281);
                                                            let _e1564 = nodes.member[(0u + _e1503)].x;
                                                            if (_e1261 < 0f) {
                                                                let _e1575 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1564.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1581 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1575.unnamed.word, _e1564.w), _e1575.unnamed_1);
                                                                let _e1587 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1581.unnamed, lt_mask_LightPlace(_e1564.x, _e1581.unnamed_1.shift));
                                                                phi_1829_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1587.unnamed, lt_mask_LightPlace(_e1587.unnamed_1.word, _e1564.y));
                                                            } else {
                                                                let _e1603 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1564.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1609 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1603.unnamed.word, _e1564.y), _e1603.unnamed_1);
                                                                let _e1615 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1609.unnamed, lt_mask_LightPlace(_e1564.z, _e1609.unnamed_1.shift));
                                                                phi_1829_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1615.unnamed, lt_mask_LightPlace(_e1615.unnamed_1.word, _e1564.w));
                                                            }
                                                            let _e1623 = phi_1829_;
                                                            let _e1633 = nodes.member[(0u + _e1503)].y;
                                                            if (_e1271 < 0f) {
                                                                let _e1644 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1633.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1650 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1644.unnamed.word, _e1633.w), _e1644.unnamed_1);
                                                                let _e1656 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1650.unnamed, lt_mask_LightPlace(_e1633.x, _e1650.unnamed_1.shift));
                                                                phi_1856_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1656.unnamed, lt_mask_LightPlace(_e1656.unnamed_1.word, _e1633.y));
                                                            } else {
                                                                let _e1672 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1633.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1678 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1672.unnamed.word, _e1633.y), _e1672.unnamed_1);
                                                                let _e1684 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1678.unnamed, lt_mask_LightPlace(_e1633.z, _e1678.unnamed_1.shift));
                                                                phi_1856_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1684.unnamed, lt_mask_LightPlace(_e1684.unnamed_1.word, _e1633.w));
                                                            }
                                                            let _e1692 = phi_1856_;
                                                            let _e1702 = nodes.member[(0u + _e1503)].z;
                                                            if (_e1281 < 0f) {
                                                                let _e1713 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1702.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1719 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1713.unnamed.word, _e1702.w), _e1713.unnamed_1);
                                                                let _e1725 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1719.unnamed, lt_mask_LightPlace(_e1702.x, _e1719.unnamed_1.shift));
                                                                phi_1883_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1725.unnamed, lt_mask_LightPlace(_e1725.unnamed_1.word, _e1702.y));
                                                            } else {
                                                                let _e1741 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1702.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1747 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1741.unnamed.word, _e1702.y), _e1741.unnamed_1);
                                                                let _e1753 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1747.unnamed, lt_mask_LightPlace(_e1702.z, _e1747.unnamed_1.shift));
                                                                phi_1883_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1753.unnamed, lt_mask_LightPlace(_e1753.unnamed_1.word, _e1702.w));
                                                            }
                                                            let _e1761 = phi_1883_;
                                                            phi_1889_ = 0u;
                                                            phi_1892_ = 0u;
                                                            loop {
                                                                let _e1771 = phi_1889_;
                                                                let _e1773 = phi_1892_;
                                                                local_5 = _e1773;
                                                                local_6 = _e1773;
                                                                local_7 = _e1773;
                                                                let _e1774 = (_e1771 < 8u);
                                                                if _e1774 {
                                                                    let _e1776 = (_e1771 >> bitcast<u32>(2i));
                                                                    let _e1777 = (_e1771 & 3u);
                                                                    if (_e1776 == 0u) {
                                                                        phi_1906_ = _e1623.unnamed.word;
                                                                    } else {
                                                                        phi_1906_ = _e1623.unnamed.shift;
                                                                    }
                                                                    let _e1780 = phi_1906_;
                                                                    if (_e1776 == 0u) {
                                                                        phi_1916_ = _e1692.unnamed.word;
                                                                    } else {
                                                                        phi_1916_ = _e1692.unnamed.shift;
                                                                    }
                                                                    let _e1789 = phi_1916_;
                                                                    if (_e1776 == 0u) {
                                                                        phi_1926_ = _e1761.unnamed.word;
                                                                    } else {
                                                                        phi_1926_ = _e1761.unnamed.shift;
                                                                    }
                                                                    let _e1798 = phi_1926_;
                                                                    let _e1811 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1780 >> bitcast<u32>(((_e1777 * 8u) & 31u))) & 255u)) * _e1536) + (_e1554 - _e1313)), ((f32(((_e1789 >> bitcast<u32>(((_e1777 * 8u) & 31u))) & 255u)) * _e1537) + (_e1555 - _e1314)));
                                                                    let _e1812 = core_intrinsics_maximum_number_nsz_f32_(_e1811, ((f32(((_e1798 >> bitcast<u32>(((_e1777 * 8u) & 31u))) & 255u)) * _e1538) + (_e1556 - _e1315)));
                                                                    if (_e1776 == 0u) {
                                                                        phi_1944_ = _e1623.unnamed_1.word;
                                                                    } else {
                                                                        phi_1944_ = _e1623.unnamed_1.shift;
                                                                    }
                                                                    let _e1815 = phi_1944_;
                                                                    if (_e1776 == 0u) {
                                                                        phi_1954_ = _e1692.unnamed_1.word;
                                                                    } else {
                                                                        phi_1954_ = _e1692.unnamed_1.shift;
                                                                    }
                                                                    let _e1824 = phi_1954_;
                                                                    if (_e1776 == 0u) {
                                                                        phi_1964_ = _e1761.unnamed_1.word;
                                                                    } else {
                                                                        phi_1964_ = _e1761.unnamed_1.shift;
                                                                    }
                                                                    let _e1833 = phi_1964_;
                                                                    let _e1846 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1815 >> bitcast<u32>(((_e1777 * 8u) & 31u))) & 255u)) * _e1536) + (_e1554 + _e1313)), ((f32(((_e1824 >> bitcast<u32>(((_e1777 * 8u) & 31u))) & 255u)) * _e1537) + (_e1555 + _e1314)));
                                                                    let _e1847 = core_intrinsics_minimum_number_nsz_f32_(_e1846, ((f32(((_e1833 >> bitcast<u32>(((_e1777 * 8u) & 31u))) & 255u)) * _e1538) + (_e1556 + _e1315)));
                                                                    if (_e1812 <= _e1847) {
                                                                        if (_e1812 <= _e1501.t) {
                                                                            if (_e1847 >= _e153.tmin) {
                                                                                if (_e1776 == 0u) {
                                                                                    let _e1854 = nodes.member[(0u + _e1503)].links[2u];
                                                                                    phi_2000_ = _e1854;
                                                                                } else {
                                                                                    let _e1857 = nodes.member[(0u + _e1503)].links[3u];
                                                                                    phi_2000_ = _e1857;
                                                                                }
                                                                                let _e1859 = phi_2000_;
                                                                                let _e1864 = ((_e1859 >> bitcast<u32>(((_e1777 * 8u) & 31u))) & 255u);
                                                                                let _e1865 = (_e1864 & 31u);
                                                                                if (_e1865 >= 24u) {
                                                                                    phi_2013_ = (24u + ((_e1865 - 24u) ^ _e1363));
                                                                                } else {
                                                                                    phi_2013_ = _e1865;
                                                                                }
                                                                                let _e1871 = phi_2013_;
                                                                                phi_2018_ = (_e1773 | ((_e1864 >> bitcast<u32>(5i)) << bitcast<u32>((_e1871 & 31u))));
                                                                            } else {
                                                                                phi_2018_ = _e1773;
                                                                            }
                                                                            let _e1879 = phi_2018_;
                                                                            phi_2019_ = _e1879;
                                                                        } else {
                                                                            phi_2019_ = _e1773;
                                                                        }
                                                                        let _e1881 = phi_2019_;
                                                                        phi_2020_ = _e1881;
                                                                    } else {
                                                                        phi_2020_ = _e1773;
                                                                    }
                                                                    let _e1883 = phi_2020_;
                                                                    phi_1890_ = (_e1771 + 1u);
                                                                    phi_1893_ = _e1883;
                                                                } else {
                                                                    phi_1890_ = u32();
                                                                    phi_1893_ = u32();
                                                                }
                                                                let _e1886 = phi_1890_;
                                                                let _e1888 = phi_1893_;
                                                                continue;
                                                                continuing {
                                                                    phi_1889_ = _e1886;
                                                                    phi_1892_ = _e1888;
                                                                    break if !(_e1774);
                                                                }
                                                            }
                                                            let _e1892 = nodes.member[(0u + _e1503)].links[0u];
                                                            let _e1896 = nodes.member[(0u + _e1503)].frame[3u];
                                                            let _e1900 = local_5;
                                                            if ((_e1900 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1904 = local.group_mask;
                                                                if ((_e1904 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1908 = local.len;
                                                                    if (_e1908 < 32u) {
                                                                        let _e1911 = local.group;
                                                                        let _e1913 = local.len;
                                                                        if (_e1913 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.first[(0u + _e1913)] = _e1911;
                                                                        let _e1919 = local.group_mask;
                                                                        let _e1921 = local.len;
                                                                        if (_e1921 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.mask[(0u + _e1921)] = _e1919;
                                                                        let _e1928 = local.len;
                                                                        local.len = (_e1928 + 1u);
                                                                    }
                                                                }
                                                                local.group = (_e1129 + _e1892);
                                                                let _e1932 = local_6;
                                                                local.group_mask = ((_e1932 & 4278190080u) | (_e1896 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1937 = local_7;
                                                            phi_2078_ = _e1501;
                                                            phi_2081_ = (_e1937 & 16777215u);
                                                            loop {
                                                                let _e1940 = phi_2078_;
                                                                let _e1942 = phi_2081_;
                                                                local_8 = _e1940;
                                                                if (_e1942 == 0u) {
                                                                    phi_2079_ = lt_bvh_Hit();
                                                                    phi_2082_ = u32();
                                                                    phi_2723_ = false;
                                                                } else {
                                                                    let _e1946 = nodes.member[(0u + _e1503)].links[1u];
                                                                    let _e1951 = ((_e1131 + _e1946) + select(firstTrailingBit(_e1942), 32u, (_e1942 == 0u)));
                                                                    if (_e1951 < _e72) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1958 = triangles.member[(0u + _e1951)].v0_;
                                                                    let _e1960 = (_e1958.x - _e1054);
                                                                    let _e1962 = (_e1958.y - _e1067);
                                                                    let _e1964 = (_e1958.z - _e1080);
                                                                    if (_e1336 == 0u) {
                                                                        phi_2126_ = vec3<f32>(_e1962, _e1964, _e1960);
                                                                    } else {
                                                                        if (_e1336 == 1u) {
                                                                            phi_2125_ = vec3<f32>(_e1964, _e1960, _e1962);
                                                                        } else {
                                                                            phi_2125_ = (_e1958 - vec3<f32>(_e1054, _e1067, _e1080));
                                                                        }
                                                                        let _e1972 = phi_2125_;
                                                                        phi_2126_ = _e1972;
                                                                    }
                                                                    let _e1974 = phi_2126_;
                                                                    let _e1978 = (_e1974.x - (_e1347 * _e1974.z));
                                                                    let _e1982 = (_e1974.y - (_e1350 * _e1974.z));
                                                                    let _e1984 = triangles.member[(0u + _e1951)].v1_;
                                                                    let _e1986 = (_e1984.x - _e1054);
                                                                    let _e1988 = (_e1984.y - _e1067);
                                                                    let _e1990 = (_e1984.z - _e1080);
                                                                    if (_e1336 == 0u) {
                                                                        phi_2156_ = vec3<f32>(_e1988, _e1990, _e1986);
                                                                    } else {
                                                                        if (_e1336 == 1u) {
                                                                            phi_2155_ = vec3<f32>(_e1990, _e1986, _e1988);
                                                                        } else {
                                                                            phi_2155_ = (_e1984 - vec3<f32>(_e1054, _e1067, _e1080));
                                                                        }
                                                                        let _e1998 = phi_2155_;
                                                                        phi_2156_ = _e1998;
                                                                    }
                                                                    let _e2000 = phi_2156_;
                                                                    let _e2004 = (_e2000.x - (_e1347 * _e2000.z));
                                                                    let _e2008 = (_e2000.y - (_e1350 * _e2000.z));
                                                                    let _e2010 = triangles.member[(0u + _e1951)].v2_;
                                                                    let _e2012 = (_e2010.x - _e1054);
                                                                    let _e2014 = (_e2010.y - _e1067);
                                                                    let _e2016 = (_e2010.z - _e1080);
                                                                    if (_e1336 == 0u) {
                                                                        phi_2186_ = vec3<f32>(_e2014, _e2016, _e2012);
                                                                    } else {
                                                                        if (_e1336 == 1u) {
                                                                            phi_2185_ = vec3<f32>(_e2016, _e2012, _e2014);
                                                                        } else {
                                                                            phi_2185_ = (_e2010 - vec3<f32>(_e1054, _e1067, _e1080));
                                                                        }
                                                                        let _e2024 = phi_2185_;
                                                                        phi_2186_ = _e2024;
                                                                    }
                                                                    let _e2026 = phi_2186_;
                                                                    let _e2030 = (_e2026.x - (_e1347 * _e2026.z));
                                                                    let _e2034 = (_e2026.y - (_e1350 * _e2026.z));
                                                                    if (_e2004 < _e2030) {
                                                                        phi_2205_ = true;
                                                                    } else {
                                                                        if (_e2004 == _e2030) {
                                                                            phi_2204_ = (_e2008 < _e2034);
                                                                        } else {
                                                                            phi_2204_ = false;
                                                                        }
                                                                        let _e2039 = phi_2204_;
                                                                        phi_2205_ = _e2039;
                                                                    }
                                                                    let _e2041 = phi_2205_;
                                                                    if _e2041 {
                                                                        phi_2209_ = _e2034;
                                                                        phi_2210_ = _e2030;
                                                                        phi_2211_ = _e2008;
                                                                        phi_2212_ = _e2004;
                                                                    } else {
                                                                        phi_2209_ = _e2008;
                                                                        phi_2210_ = _e2004;
                                                                        phi_2211_ = _e2034;
                                                                        phi_2212_ = _e2030;
                                                                    }
                                                                    let _e2043 = phi_2209_;
                                                                    let _e2045 = phi_2210_;
                                                                    let _e2047 = phi_2211_;
                                                                    let _e2049 = phi_2212_;
                                                                    let _e2052 = ((_e2049 * _e2043) - (_e2047 * _e2045));
                                                                    if _e2041 {
                                                                        phi_2220_ = -(_e2052);
                                                                    } else {
                                                                        phi_2220_ = _e2052;
                                                                    }
                                                                    let _e2055 = phi_2220_;
                                                                    if (_e2030 < _e1978) {
                                                                        phi_2231_ = true;
                                                                    } else {
                                                                        if (_e2030 == _e1978) {
                                                                            phi_2230_ = (_e2034 < _e1982);
                                                                        } else {
                                                                            phi_2230_ = false;
                                                                        }
                                                                        let _e2060 = phi_2230_;
                                                                        phi_2231_ = _e2060;
                                                                    }
                                                                    let _e2062 = phi_2231_;
                                                                    if _e2062 {
                                                                        phi_2235_ = _e1982;
                                                                        phi_2236_ = _e1978;
                                                                        phi_2237_ = _e2034;
                                                                        phi_2238_ = _e2030;
                                                                    } else {
                                                                        phi_2235_ = _e2034;
                                                                        phi_2236_ = _e2030;
                                                                        phi_2237_ = _e1982;
                                                                        phi_2238_ = _e1978;
                                                                    }
                                                                    let _e2064 = phi_2235_;
                                                                    let _e2066 = phi_2236_;
                                                                    let _e2068 = phi_2237_;
                                                                    let _e2070 = phi_2238_;
                                                                    let _e2073 = ((_e2070 * _e2064) - (_e2068 * _e2066));
                                                                    if _e2062 {
                                                                        phi_2246_ = -(_e2073);
                                                                    } else {
                                                                        phi_2246_ = _e2073;
                                                                    }
                                                                    let _e2076 = phi_2246_;
                                                                    if (_e1978 < _e2004) {
                                                                        phi_2257_ = true;
                                                                    } else {
                                                                        if (_e1978 == _e2004) {
                                                                            phi_2256_ = (_e1982 < _e2008);
                                                                        } else {
                                                                            phi_2256_ = false;
                                                                        }
                                                                        let _e2081 = phi_2256_;
                                                                        phi_2257_ = _e2081;
                                                                    }
                                                                    let _e2083 = phi_2257_;
                                                                    if _e2083 {
                                                                        phi_2261_ = _e2008;
                                                                        phi_2262_ = _e2004;
                                                                        phi_2263_ = _e1982;
                                                                        phi_2264_ = _e1978;
                                                                    } else {
                                                                        phi_2261_ = _e1982;
                                                                        phi_2262_ = _e1978;
                                                                        phi_2263_ = _e2008;
                                                                        phi_2264_ = _e2004;
                                                                    }
                                                                    let _e2085 = phi_2261_;
                                                                    let _e2087 = phi_2262_;
                                                                    let _e2089 = phi_2263_;
                                                                    let _e2091 = phi_2264_;
                                                                    let _e2094 = ((_e2091 * _e2085) - (_e2089 * _e2087));
                                                                    if _e2083 {
                                                                        phi_2272_ = -(_e2094);
                                                                    } else {
                                                                        phi_2272_ = _e2094;
                                                                    }
                                                                    let _e2097 = phi_2272_;
                                                                    if (_e2055 >= 0f) {
                                                                        if (_e2076 >= 0f) {
                                                                            if (_e2097 >= 0f) {
                                                                                phi_2287_ = ((_e2055 + _e2076) + _e2097);
                                                                                phi_2288_ = false;
                                                                            } else {
                                                                                phi_2287_ = f32();
                                                                                phi_2288_ = true;
                                                                            }
                                                                            let _e2104 = phi_2287_;
                                                                            let _e2106 = phi_2288_;
                                                                            phi_2289_ = _e2104;
                                                                            phi_2290_ = _e2106;
                                                                        } else {
                                                                            phi_2289_ = f32();
                                                                            phi_2290_ = true;
                                                                        }
                                                                        let _e2108 = phi_2289_;
                                                                        let _e2110 = phi_2290_;
                                                                        phi_2291_ = _e2108;
                                                                        phi_2292_ = _e2110;
                                                                    } else {
                                                                        phi_2291_ = f32();
                                                                        phi_2292_ = true;
                                                                    }
                                                                    let _e2112 = phi_2291_;
                                                                    let _e2114 = phi_2292_;
                                                                    if _e2114 {
                                                                        if (_e2055 <= 0f) {
                                                                            if (_e2076 <= 0f) {
                                                                                let _e2117 = (_e2097 <= 0f);
                                                                                if _e2117 {
                                                                                }
                                                                                phi_2310_ = ((_e2055 + _e2076) + _e2097);
                                                                                phi_2311_ = false;
                                                                                phi_2312_ = _e2117;
                                                                            } else {
                                                                                phi_2310_ = f32();
                                                                                phi_2311_ = true;
                                                                                phi_2312_ = false;
                                                                            }
                                                                            let _e2121 = phi_2310_;
                                                                            let _e2123 = phi_2311_;
                                                                            let _e2125 = phi_2312_;
                                                                            phi_2313_ = _e2121;
                                                                            phi_2314_ = _e2123;
                                                                            phi_2315_ = _e2125;
                                                                        } else {
                                                                            phi_2313_ = f32();
                                                                            phi_2314_ = true;
                                                                            phi_2315_ = false;
                                                                        }
                                                                        let _e2127 = phi_2313_;
                                                                        let _e2129 = phi_2314_;
                                                                        let _e2131 = phi_2315_;
                                                                        if _e2129 {
                                                                            phi_2319_ = false;
                                                                        } else {
                                                                            phi_2319_ = _e2131;
                                                                        }
                                                                        let _e2133 = phi_2319_;
                                                                        phi_2320_ = _e2127;
                                                                        phi_2321_ = _e2133;
                                                                    } else {
                                                                        phi_2320_ = _e2112;
                                                                        phi_2321_ = true;
                                                                    }
                                                                    let _e2135 = phi_2320_;
                                                                    let _e2137 = phi_2321_;
                                                                    if _e2137 {
                                                                        let _e2138 = (_e2135 == 0f);
                                                                        if _e2138 {
                                                                            phi_2637_ = lt_bvh_triangle_Intersection();
                                                                            phi_2638_ = false;
                                                                        } else {
                                                                            let _e2140 = triangles.member[(0u + _e1951)].v0_;
                                                                            let _e2142 = (_e2140.x - _e1054);
                                                                            let _e2144 = (_e2140.y - _e1067);
                                                                            let _e2146 = (_e2140.z - _e1080);
                                                                            if (_e1336 == 0u) {
                                                                                phi_2350_ = vec3<f32>(_e2144, _e2146, _e2142);
                                                                            } else {
                                                                                if (_e1336 == 1u) {
                                                                                    phi_2349_ = vec3<f32>(_e2146, _e2142, _e2144);
                                                                                } else {
                                                                                    phi_2349_ = (_e2140 - vec3<f32>(_e1054, _e1067, _e1080));
                                                                                }
                                                                                let _e2154 = phi_2349_;
                                                                                phi_2350_ = _e2154;
                                                                            }
                                                                            let _e2156 = phi_2350_;
                                                                            let _e2158 = triangles.member[(0u + _e1951)].v1_;
                                                                            let _e2160 = triangles.member[(0u + _e1951)].v0_;
                                                                            let _e2163 = (_e2158.x - _e2160.x);
                                                                            let _e2166 = (_e2158.y - _e2160.y);
                                                                            let _e2169 = (_e2158.z - _e2160.z);
                                                                            if (_e1336 == 0u) {
                                                                                phi_2376_ = vec3<f32>(_e2166, _e2169, _e2163);
                                                                            } else {
                                                                                if (_e1336 == 1u) {
                                                                                    phi_2375_ = vec3<f32>(_e2169, _e2163, _e2166);
                                                                                } else {
                                                                                    phi_2375_ = (_e2158 - _e2160);
                                                                                }
                                                                                let _e2176 = phi_2375_;
                                                                                phi_2376_ = _e2176;
                                                                            }
                                                                            let _e2178 = phi_2376_;
                                                                            let _e2180 = triangles.member[(0u + _e1951)].v2_;
                                                                            let _e2182 = triangles.member[(0u + _e1951)].v0_;
                                                                            let _e2185 = (_e2180.x - _e2182.x);
                                                                            let _e2188 = (_e2180.y - _e2182.y);
                                                                            let _e2191 = (_e2180.z - _e2182.z);
                                                                            if (_e1336 == 0u) {
                                                                                phi_2402_ = vec3<f32>(_e2188, _e2191, _e2185);
                                                                            } else {
                                                                                if (_e1336 == 1u) {
                                                                                    phi_2401_ = vec3<f32>(_e2191, _e2185, _e2188);
                                                                                } else {
                                                                                    phi_2401_ = (_e2180 - _e2182);
                                                                                }
                                                                                let _e2198 = phi_2401_;
                                                                                phi_2402_ = _e2198;
                                                                            }
                                                                            let _e2200 = phi_2402_;
                                                                            let _e2207 = ((_e2178.y * _e2200.z) - (_e2178.z * _e2200.y));
                                                                            let _e2214 = ((_e2178.z * _e2200.x) - (_e2178.x * _e2200.z));
                                                                            let _e2221 = ((_e2178.x * _e2200.y) - (_e2178.y * _e2200.x));
                                                                            let _e2235 = (((1f / _e1344.z) * (((_e2207 * _e2156.x) + (_e2214 * _e2156.y)) + (_e2221 * _e2156.z))) / (((_e2207 * _e1347) + (_e2214 * _e1350)) + _e2221));
                                                                            if (_e2235 > _e153.tmin) {
                                                                                if (_e2235 < _e153.tmax) {
                                                                                    let _e2239 = triangles.member[(0u + _e1951)].v0_;
                                                                                    let _e2241 = triangles.member[(0u + _e1951)].v1_;
                                                                                    if (_e2239.x < _e2241.x) {
                                                                                        phi_2458_ = _e2239.x;
                                                                                    } else {
                                                                                        phi_2458_ = _e2241.x;
                                                                                    }
                                                                                    let _e2248 = phi_2458_;
                                                                                    if (_e2239.y < _e2241.y) {
                                                                                        phi_2467_ = _e2239.y;
                                                                                    } else {
                                                                                        phi_2467_ = _e2241.y;
                                                                                    }
                                                                                    let _e2255 = phi_2467_;
                                                                                    if (_e2239.z < _e2241.z) {
                                                                                        phi_2476_ = _e2239.z;
                                                                                    } else {
                                                                                        phi_2476_ = _e2241.z;
                                                                                    }
                                                                                    let _e2262 = phi_2476_;
                                                                                    let _e2264 = triangles.member[(0u + _e1951)].v2_;
                                                                                    if (_e2248 < _e2264.x) {
                                                                                        phi_2485_ = _e2248;
                                                                                    } else {
                                                                                        phi_2485_ = _e2264.x;
                                                                                    }
                                                                                    let _e2269 = phi_2485_;
                                                                                    if (_e2255 < _e2264.y) {
                                                                                        phi_2492_ = _e2255;
                                                                                    } else {
                                                                                        phi_2492_ = _e2264.y;
                                                                                    }
                                                                                    let _e2274 = phi_2492_;
                                                                                    if (_e2262 < _e2264.z) {
                                                                                        phi_2499_ = _e2262;
                                                                                    } else {
                                                                                        phi_2499_ = _e2264.z;
                                                                                    }
                                                                                    let _e2279 = phi_2499_;
                                                                                    let _e2281 = triangles.member[(0u + _e1951)].v0_;
                                                                                    let _e2283 = triangles.member[(0u + _e1951)].v1_;
                                                                                    if (_e2281.x > _e2283.x) {
                                                                                        phi_2512_ = _e2281.x;
                                                                                    } else {
                                                                                        phi_2512_ = _e2283.x;
                                                                                    }
                                                                                    let _e2290 = phi_2512_;
                                                                                    if (_e2281.y > _e2283.y) {
                                                                                        phi_2521_ = _e2281.y;
                                                                                    } else {
                                                                                        phi_2521_ = _e2283.y;
                                                                                    }
                                                                                    let _e2297 = phi_2521_;
                                                                                    if (_e2281.z > _e2283.z) {
                                                                                        phi_2530_ = _e2281.z;
                                                                                    } else {
                                                                                        phi_2530_ = _e2283.z;
                                                                                    }
                                                                                    let _e2304 = phi_2530_;
                                                                                    let _e2306 = triangles.member[(0u + _e1951)].v2_;
                                                                                    if (_e2290 > _e2306.x) {
                                                                                        phi_2539_ = _e2290;
                                                                                    } else {
                                                                                        phi_2539_ = _e2306.x;
                                                                                    }
                                                                                    let _e2311 = phi_2539_;
                                                                                    if (_e2297 > _e2306.y) {
                                                                                        phi_2546_ = _e2297;
                                                                                    } else {
                                                                                        phi_2546_ = _e2306.y;
                                                                                    }
                                                                                    let _e2316 = phi_2546_;
                                                                                    if (_e2304 > _e2306.z) {
                                                                                        phi_2553_ = _e2304;
                                                                                    } else {
                                                                                        phi_2553_ = _e2306.z;
                                                                                    }
                                                                                    let _e2321 = phi_2553_;
                                                                                    let _e2325 = ((_e2269 - _e1054) * _e1261);
                                                                                    let _e2326 = ((_e2274 - _e1067) * _e1271);
                                                                                    let _e2327 = ((_e2279 - _e1080) * _e1281);
                                                                                    let _e2331 = ((_e2311 - _e1054) * _e1261);
                                                                                    let _e2332 = ((_e2316 - _e1067) * _e1271);
                                                                                    let _e2333 = ((_e2321 - _e1080) * _e1281);
                                                                                    if (_e2325 < _e2331) {
                                                                                        phi_2570_ = _e2325;
                                                                                    } else {
                                                                                        phi_2570_ = _e2331;
                                                                                    }
                                                                                    let _e2336 = phi_2570_;
                                                                                    if (_e2326 < _e2332) {
                                                                                        phi_2575_ = _e2326;
                                                                                    } else {
                                                                                        phi_2575_ = _e2332;
                                                                                    }
                                                                                    let _e2339 = phi_2575_;
                                                                                    if (_e2327 < _e2333) {
                                                                                        phi_2580_ = _e2327;
                                                                                    } else {
                                                                                        phi_2580_ = _e2333;
                                                                                    }
                                                                                    let _e2342 = phi_2580_;
                                                                                    if (_e2325 > _e2331) {
                                                                                        phi_2588_ = _e2325;
                                                                                    } else {
                                                                                        phi_2588_ = _e2331;
                                                                                    }
                                                                                    let _e2348 = phi_2588_;
                                                                                    if (_e2326 > _e2332) {
                                                                                        phi_2593_ = _e2326;
                                                                                    } else {
                                                                                        phi_2593_ = _e2332;
                                                                                    }
                                                                                    let _e2351 = phi_2593_;
                                                                                    if (_e2327 > _e2333) {
                                                                                        phi_2598_ = _e2327;
                                                                                    } else {
                                                                                        phi_2598_ = _e2333;
                                                                                    }
                                                                                    let _e2354 = phi_2598_;
                                                                                    let _e2358 = core_intrinsics_maximum_number_nsz_f32_((_e2336 - _e1320), (_e2339 - _e1321));
                                                                                    let _e2359 = core_intrinsics_maximum_number_nsz_f32_(_e2358, (_e2342 - _e1322));
                                                                                    let _e2360 = core_intrinsics_minimum_number_nsz_f32_((_e2348 + _e1320), (_e2351 + _e1321));
                                                                                    let _e2361 = core_intrinsics_minimum_number_nsz_f32_(_e2360, (_e2354 + _e1322));
                                                                                    if (_e2359 > _e1029) {
                                                                                        phi_2610_ = _e2359;
                                                                                    } else {
                                                                                        phi_2610_ = _e1029;
                                                                                    }
                                                                                    let _e2364 = phi_2610_;
                                                                                    if (_e2361 < _e1031) {
                                                                                        phi_2615_ = _e2361;
                                                                                    } else {
                                                                                        phi_2615_ = _e1031;
                                                                                    }
                                                                                    let _e2367 = phi_2615_;
                                                                                    if (_e2235 < _e2364) {
                                                                                        phi_2620_ = _e2364;
                                                                                    } else {
                                                                                        phi_2620_ = _e2235;
                                                                                    }
                                                                                    let _e2370 = phi_2620_;
                                                                                    if (_e2370 > _e2367) {
                                                                                        phi_2625_ = _e2367;
                                                                                    } else {
                                                                                        phi_2625_ = _e2370;
                                                                                    }
                                                                                    let _e2373 = phi_2625_;
                                                                                    phi_2630_ = lt_bvh_triangle_Intersection(_e2373, (_e2076 / _e2135), (_e2097 / _e2135), (_e2364 <= _e2367));
                                                                                    phi_2631_ = false;
                                                                                } else {
                                                                                    phi_2630_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2631_ = true;
                                                                                }
                                                                                let _e2379 = phi_2630_;
                                                                                let _e2381 = phi_2631_;
                                                                                phi_2632_ = _e2379;
                                                                                phi_2633_ = _e2381;
                                                                            } else {
                                                                                phi_2632_ = lt_bvh_triangle_Intersection();
                                                                                phi_2633_ = true;
                                                                            }
                                                                            let _e2383 = phi_2632_;
                                                                            let _e2385 = phi_2633_;
                                                                            if _e2385 {
                                                                            }
                                                                            phi_2637_ = _e2383;
                                                                            phi_2638_ = _e2385;
                                                                        }
                                                                        let _e2387 = phi_2637_;
                                                                        let _e2389 = phi_2638_;
                                                                        phi_2639_ = _e2387;
                                                                        phi_2640_ = _e2138;
                                                                        phi_2641_ = _e2389;
                                                                    } else {
                                                                        phi_2639_ = lt_bvh_triangle_Intersection();
                                                                        phi_2640_ = true;
                                                                        phi_2641_ = false;
                                                                    }
                                                                    let _e2391 = phi_2639_;
                                                                    let _e2393 = phi_2640_;
                                                                    let _e2395 = phi_2641_;
                                                                    if _e2393 {
                                                                        phi_2645_ = true;
                                                                    } else {
                                                                        phi_2645_ = _e2395;
                                                                    }
                                                                    let _e2397 = phi_2645_;
                                                                    if _e2397 {
                                                                        phi_2649_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2649_ = _e2391;
                                                                    }
                                                                    let _e2399 = phi_2649_;
                                                                    if _e2399.is_hit {
                                                                        if (_e2399.t > _e153.tmin) {
                                                                            if (_e2399.t < _e1940.t) {
                                                                                phi_2697_ = true;
                                                                            } else {
                                                                                if (_e2399.t == _e1940.t) {
                                                                                    if (_e1940.triangle != 4294967295u) {
                                                                                        if (_e1951 < _e1940.triangle) {
                                                                                            phi_2688_ = true;
                                                                                        } else {
                                                                                            if (_e1951 == _e1940.triangle) {
                                                                                                phi_2687_ = (_e970 < _e1940.instance);
                                                                                            } else {
                                                                                                phi_2687_ = false;
                                                                                            }
                                                                                            let _e2417 = phi_2687_;
                                                                                            phi_2688_ = _e2417;
                                                                                        }
                                                                                        let _e2419 = phi_2688_;
                                                                                        phi_2689_ = _e2419;
                                                                                        phi_2690_ = false;
                                                                                    } else {
                                                                                        phi_2689_ = bool();
                                                                                        phi_2690_ = true;
                                                                                    }
                                                                                    let _e2421 = phi_2689_;
                                                                                    let _e2423 = phi_2690_;
                                                                                    phi_2691_ = _e2421;
                                                                                    phi_2692_ = _e2423;
                                                                                } else {
                                                                                    phi_2691_ = bool();
                                                                                    phi_2692_ = true;
                                                                                }
                                                                                let _e2425 = phi_2691_;
                                                                                let _e2427 = phi_2692_;
                                                                                if _e2427 {
                                                                                    phi_2696_ = false;
                                                                                } else {
                                                                                    phi_2696_ = _e2425;
                                                                                }
                                                                                let _e2429 = phi_2696_;
                                                                                phi_2697_ = _e2429;
                                                                            }
                                                                            let _e2431 = phi_2697_;
                                                                            if _e2431 {
                                                                                let _e2433 = triangles.member[(0u + _e1951)].i0_;
                                                                                if ((_e2433 & 2147483648u) == 0u) {
                                                                                    phi_2711_ = true;
                                                                                } else {
                                                                                    if true {
                                                                                    }
                                                                                    phi_2711_ = true;
                                                                                }
                                                                                let _e2437 = phi_2711_;
                                                                                if _e2437 {
                                                                                    phi_2719_ = lt_bvh_Hit(_e2399.t, _e2399.u, _e2399.v, _e1951, _e970);
                                                                                } else {
                                                                                    phi_2719_ = _e1940;
                                                                                }
                                                                                let _e2443 = phi_2719_;
                                                                                phi_2720_ = _e2443;
                                                                            } else {
                                                                                phi_2720_ = _e1940;
                                                                            }
                                                                            let _e2445 = phi_2720_;
                                                                            phi_2721_ = _e2445;
                                                                        } else {
                                                                            phi_2721_ = _e1940;
                                                                        }
                                                                        let _e2447 = phi_2721_;
                                                                        phi_2722_ = _e2447;
                                                                    } else {
                                                                        phi_2722_ = _e1940;
                                                                    }
                                                                    let _e2449 = phi_2722_;
                                                                    phi_2079_ = _e2449;
                                                                    phi_2082_ = (_e1942 & (_e1942 - 1u));
                                                                    phi_2723_ = true;
                                                                }
                                                                let _e2451 = phi_2079_;
                                                                let _e2453 = phi_2082_;
                                                                let _e2455 = phi_2723_;
                                                                continue;
                                                                continuing {
                                                                    phi_2078_ = _e2451;
                                                                    phi_2081_ = _e2453;
                                                                    break if !(_e2455);
                                                                }
                                                            }
                                                            let _e2458 = local.group_mask;
                                                            if ((_e2458 & 4278190080u) == 0u) {
                                                                let _e2462 = local.len;
                                                                if (_e2462 == 0u) {
                                                                    phi_2762_ = false;
                                                                } else {
                                                                    let _e2466 = local.len;
                                                                    local.len = (_e2466 - 1u);
                                                                    let _e2469 = local.len;
                                                                    if (_e2469 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2474 = local.first[(0u + _e2469)];
                                                                    local.group = _e2474;
                                                                    let _e2477 = local.len;
                                                                    if (_e2477 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2482 = local.mask[(0u + _e2477)];
                                                                    local.group_mask = _e2482;
                                                                    phi_2762_ = true;
                                                                }
                                                                let _e2485 = phi_2762_;
                                                                phi_2763_ = _e2485;
                                                            } else {
                                                                phi_2763_ = true;
                                                            }
                                                            let _e2487 = phi_2763_;
                                                            if _e2487 {
                                                                let _e2489 = local.group_mask;
                                                                let _e2495 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2489)), 32u, (_e2489 == 0u)));
                                                                let _e2499 = local.group_mask;
                                                                let _e2513 = local.group_mask;
                                                                local.group_mask = (_e2513 & ~((1u << bitcast<u32>((_e2495 & 31u)))));
                                                                let _e2516 = local.group;
                                                                phi_2794_ = (_e2516 + countOneBits(((_e2499 & ~((4294967295u << bitcast<u32>((((_e2495 - 24u) ^ _e1363) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_2794_ = 4294967295u;
                                                            }
                                                            let _e2519 = phi_2794_;
                                                            let _e3694 = local_8;
                                                            phi_1746_ = _e3694;
                                                            phi_1749_ = _e2519;
                                                        } else {
                                                            phi_1746_ = lt_bvh_Hit();
                                                            phi_1749_ = u32();
                                                        }
                                                        let _e2521 = phi_1746_;
                                                        let _e2523 = phi_1749_;
                                                        continue;
                                                        continuing {
                                                            phi_1745_ = _e2521;
                                                            phi_1748_ = _e2523;
                                                            break if !(_e1504);
                                                        }
                                                    }
                                                    let _e3698 = local_9;
                                                    phi_2795_ = _e3698;
                                                }
                                                let _e2526 = phi_2795_;
                                                phi_2796_ = _e2526;
                                                phi_2797_ = _e1185;
                                            } else {
                                                phi_2796_ = lt_bvh_Hit();
                                                phi_2797_ = true;
                                            }
                                            let _e2528 = phi_2796_;
                                            let _e2530 = phi_2797_;
                                            if _e2530 {
                                                phi_2801_ = _e962;
                                            } else {
                                                phi_2801_ = _e2528;
                                            }
                                            let _e2532 = phi_2801_;
                                            phi_2802_ = _e2532;
                                        } else {
                                            phi_2802_ = _e962;
                                        }
                                        let _e2534 = phi_2802_;
                                        phi_2803_ = _e2534;
                                    } else {
                                        phi_2803_ = _e962;
                                    }
                                    let _e2536 = phi_2803_;
                                    phi_2804_ = _e2536;
                                } else {
                                    phi_2804_ = _e962;
                                }
                                let _e2538 = phi_2804_;
                                phi_1113_ = (_e960 & (_e960 - 1u));
                                phi_1116_ = _e2538;
                                phi_2805_ = true;
                            }
                            let _e2540 = phi_1113_;
                            let _e2542 = phi_1116_;
                            let _e2544 = phi_2805_;
                            continue;
                            continuing {
                                phi_1112_ = _e2540;
                                phi_1115_ = _e2542;
                                break if !(_e2544);
                            }
                        }
                        let _e2547 = local_1.group_mask;
                        if ((_e2547 & 4278190080u) == 0u) {
                            let _e2551 = local_1.len;
                            if (_e2551 == 0u) {
                                phi_2844_ = false;
                            } else {
                                let _e2555 = local_1.len;
                                local_1.len = (_e2555 - 1u);
                                let _e2558 = local_1.len;
                                if (_e2558 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2563 = local_1.first[(0u + _e2558)];
                                local_1.group = _e2563;
                                let _e2566 = local_1.len;
                                if (_e2566 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2571 = local_1.mask[(0u + _e2566)];
                                local_1.group_mask = _e2571;
                                phi_2844_ = true;
                            }
                            let _e2574 = phi_2844_;
                            phi_2845_ = _e2574;
                        } else {
                            phi_2845_ = true;
                        }
                        let _e2576 = phi_2845_;
                        if _e2576 {
                            let _e2578 = local_1.group_mask;
                            let _e2584 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2578)), 32u, (_e2578 == 0u)));
                            let _e2588 = local_1.group_mask;
                            let _e2602 = local_1.group_mask;
                            local_1.group_mask = (_e2602 & ~((1u << bitcast<u32>((_e2584 & 31u)))));
                            let _e2605 = local_1.group;
                            phi_2876_ = (_e2605 + countOneBits(((_e2588 & ~((4294967295u << bitcast<u32>((((_e2584 - 24u) ^ _e379) & 31u))))) & 255u)));
                        } else {
                            phi_2876_ = 4294967295u;
                        }
                        let _e2608 = phi_2876_;
                        phi_776_ = _e2608;
                        let _e3714 = local_10;
                        phi_779_ = _e3714;
                    } else {
                        phi_776_ = u32();
                        phi_779_ = lt_bvh_Hit();
                    }
                    let _e2610 = phi_776_;
                    let _e2612 = phi_779_;
                    continue;
                    continuing {
                        phi_775_ = _e2610;
                        phi_778_ = _e2612;
                        break if !(_e520);
                    }
                }
                let _e3717 = local_11;
                phi_2877_ = _e3717;
            }
            let _e2615 = phi_2877_;
            phi_2878_ = _e2615;
            phi_2879_ = _e217;
        } else {
            phi_2878_ = lt_bvh_Hit();
            phi_2879_ = true;
        }
        let _e2617 = phi_2878_;
        let _e2619 = phi_2879_;
        if _e2619 {
            phi_2883_ = _e155;
        } else {
            phi_2883_ = _e2617;
        }
        let _e2621 = phi_2883_;
        if (_e2621.triangle != 4294967295u) {
            let _e2627 = ((1f - _e2621.u) - _e2621.v);
            if (_e2621.triangle < _e72) {
            } else {
                return;
            }
            let _e2633 = triangles.member[(0u + _e2621.triangle)];
            if (_e2621.instance < _e84) {
            } else {
                return;
            }
            let _e2644 = instances.member[(0u + _e2621.instance)].object_to_world[0u];
            let _e2655 = ((((_e2644.x * _e2633.v0_.x) + (_e2644.y * _e2633.v0_.y)) + (_e2644.z * _e2633.v0_.z)) + (_e2644.w * 1f));
            let _e2657 = instances.member[(0u + _e2621.instance)].object_to_world[1u];
            let _e2668 = ((((_e2657.x * _e2633.v0_.x) + (_e2657.y * _e2633.v0_.y)) + (_e2657.z * _e2633.v0_.z)) + (_e2657.w * 1f));
            let _e2670 = instances.member[(0u + _e2621.instance)].object_to_world[2u];
            let _e2681 = ((((_e2670.x * _e2633.v0_.x) + (_e2670.y * _e2633.v0_.y)) + (_e2670.z * _e2633.v0_.z)) + (_e2670.w * 1f));
            let _e2688 = instances.member[(0u + _e2621.instance)].object_to_world[0u];
            let _e2699 = ((((_e2688.x * _e2633.v1_.x) + (_e2688.y * _e2633.v1_.y)) + (_e2688.z * _e2633.v1_.z)) + (_e2688.w * 1f));
            let _e2701 = instances.member[(0u + _e2621.instance)].object_to_world[1u];
            let _e2712 = ((((_e2701.x * _e2633.v1_.x) + (_e2701.y * _e2633.v1_.y)) + (_e2701.z * _e2633.v1_.z)) + (_e2701.w * 1f));
            let _e2714 = instances.member[(0u + _e2621.instance)].object_to_world[2u];
            let _e2725 = ((((_e2714.x * _e2633.v1_.x) + (_e2714.y * _e2633.v1_.y)) + (_e2714.z * _e2633.v1_.z)) + (_e2714.w * 1f));
            let _e2732 = instances.member[(0u + _e2621.instance)].object_to_world[0u];
            let _e2743 = ((((_e2732.x * _e2633.v2_.x) + (_e2732.y * _e2633.v2_.y)) + (_e2732.z * _e2633.v2_.z)) + (_e2732.w * 1f));
            let _e2745 = instances.member[(0u + _e2621.instance)].object_to_world[1u];
            let _e2756 = ((((_e2745.x * _e2633.v2_.x) + (_e2745.y * _e2633.v2_.y)) + (_e2745.z * _e2633.v2_.z)) + (_e2745.w * 1f));
            let _e2758 = instances.member[(0u + _e2621.instance)].object_to_world[2u];
            let _e2769 = ((((_e2758.x * _e2633.v2_.x) + (_e2758.y * _e2633.v2_.y)) + (_e2758.z * _e2633.v2_.z)) + (_e2758.w * 1f));
            let _e2782 = (((_e2655 * _e2627) + (_e2699 * _e2621.u)) + (_e2743 * _e2621.v));
            let _e2783 = (((_e2668 * _e2627) + (_e2712 * _e2621.u)) + (_e2756 * _e2621.v));
            let _e2784 = (((_e2681 * _e2627) + (_e2725 * _e2621.u)) + (_e2769 * _e2621.v));
            let _e2786 = abs(_e2655);
            let _e2787 = abs(_e2668);
            let _e2788 = abs(_e2681);
            let _e2789 = abs(_e2699);
            let _e2790 = abs(_e2712);
            let _e2791 = abs(_e2725);
            if (_e2786 > _e2789) {
                phi_3071_ = _e2786;
            } else {
                phi_3071_ = _e2789;
            }
            let _e2794 = phi_3071_;
            if (_e2787 > _e2790) {
                phi_3076_ = _e2787;
            } else {
                phi_3076_ = _e2790;
            }
            let _e2797 = phi_3076_;
            if (_e2788 > _e2791) {
                phi_3081_ = _e2788;
            } else {
                phi_3081_ = _e2791;
            }
            let _e2800 = phi_3081_;
            let _e2801 = abs(_e2743);
            let _e2802 = abs(_e2756);
            let _e2803 = abs(_e2769);
            if (_e2794 > _e2801) {
                phi_3089_ = _e2794;
            } else {
                phi_3089_ = _e2801;
            }
            let _e2806 = phi_3089_;
            if (_e2797 > _e2802) {
                phi_3094_ = _e2797;
            } else {
                phi_3094_ = _e2802;
            }
            let _e2809 = phi_3094_;
            if (_e2800 > _e2803) {
                phi_3099_ = _e2800;
            } else {
                phi_3099_ = _e2803;
            }
            let _e2812 = phi_3099_;
            let _e2813 = (_e2699 - _e2655);
            let _e2814 = (_e2712 - _e2668);
            let _e2815 = (_e2725 - _e2681);
            let _e2816 = (_e2743 - _e2655);
            let _e2817 = (_e2756 - _e2668);
            let _e2818 = (_e2769 - _e2681);
            let _e2822 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2814), abs(_e2815));
            let _e2823 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2813), _e2822);
            let _e2824 = (_e2813 / _e2823);
            let _e2825 = (_e2814 / _e2823);
            let _e2826 = (_e2815 / _e2823);
            let _e2830 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2817), abs(_e2818));
            let _e2831 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2816), _e2830);
            let _e2832 = (_e2816 / _e2831);
            let _e2833 = (_e2817 / _e2831);
            let _e2834 = (_e2818 / _e2831);
            let _e2837 = ((_e2825 * _e2834) - (_e2833 * _e2826));
            let _e2840 = ((_e2826 * _e2832) - (_e2834 * _e2824));
            let _e2843 = ((_e2824 * _e2833) - (_e2832 * _e2825));
            let _e2845 = p.member.eye;
            let _e2858 = (1f / sqrt((((_e2837 * _e2837) + (_e2840 * _e2840)) + (_e2843 * _e2843))));
            let _e2859 = (_e2837 * _e2858);
            let _e2860 = (_e2840 * _e2858);
            let _e2861 = (_e2843 * _e2858);
            if ((((_e2859 * (_e2845.x - _e2782)) + (_e2860 * (_e2845.y - _e2783))) + (_e2861 * (_e2845.z - _e2784))) < 0f) {
                phi_3163_ = vec3<f32>(-(_e2859), -(_e2860), -(_e2861));
            } else {
                phi_3163_ = vec3<f32>(_e2859, _e2860, _e2861);
            }
            let _e2874 = phi_3163_;
            if (_e2621.triangle < _e72) {
            } else {
                return;
            }
            let _e2879 = triangles.member[(0u + _e2621.triangle)];
            let _e2881 = (_e2879.i0_ & 2147483647u);
            if (_e2881 < _e75) {
            } else {
                return;
            }
            let _e2887 = vertices.member[(0u + _e2881)];
            if (_e2879.i1_ < _e75) {
            } else {
                return;
            }
            let _e2891 = vertices.member[(0u + _e2879.i1_)];
            if (_e2879.i2_ < _e75) {
            } else {
                return;
            }
            let _e2895 = vertices.member[(0u + _e2879.i2_)];
            let _e2896 = array<abi_Vertex, 3>(_e2887, _e2891, _e2895);
            if (_e2896[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e2902 = materials.member[(0u + _e2896[0].material)];
            let _e2919 = (1f / 255f);
            let _e2938 = (1f / 255f);
            let _e2960 = (1f / 255f);
            let _e2973 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e2627, _e2621.u, _e2621.v));
            let _e2975 = ((_e2902.base_color.x * ((((f32((_e2896[0].color & 255u)) * _e2919) * _e2627) + ((f32((_e2896[1].color & 255u)) * _e2938) * _e2621.u)) + ((f32((_e2896[2].color & 255u)) * _e2960) * _e2621.v))) * _e2973.x);
            let _e2977 = ((_e2902.base_color.y * ((((f32(((_e2896[0].color >> bitcast<u32>(8i)) & 255u)) * _e2919) * _e2627) + ((f32(((_e2896[1].color >> bitcast<u32>(8i)) & 255u)) * _e2938) * _e2621.u)) + ((f32(((_e2896[2].color >> bitcast<u32>(8i)) & 255u)) * _e2960) * _e2621.v))) * _e2973.y);
            let _e2979 = ((_e2902.base_color.z * ((((f32(((_e2896[0].color >> bitcast<u32>(16i)) & 255u)) * _e2919) * _e2627) + ((f32(((_e2896[1].color >> bitcast<u32>(16i)) & 255u)) * _e2938) * _e2621.u)) + ((f32(((_e2896[2].color >> bitcast<u32>(16i)) & 255u)) * _e2960) * _e2621.v))) * _e2973.z);
            let _e2980 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2809, _e2812);
            let _e2981 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2806, _e2980);
            if ((_e2902.flags & 2u) == 0u) {
                phi_3284_ = 0u;
            } else {
                phi_3284_ = 1u;
            }
            let _e2986 = phi_3284_;
            if (_e2896[0].normal == 2147516416u) {
                phi_3514_ = _e2874;
            } else {
                let _e2999 = (f32((bitcast<i32>((_e2896[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3005 = (f32((bitcast<i32>(_e2896[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3009 = ((1f - abs(_e2999)) - abs(_e3005));
                if (_e3009 < 0f) {
                    phi_3311_ = -(_e3009);
                } else {
                    phi_3311_ = 0f;
                }
                let _e3013 = phi_3311_;
                if (_e2999 < 0f) {
                    phi_3318_ = (_e2999 + _e3013);
                } else {
                    phi_3318_ = (_e2999 - _e3013);
                }
                let _e3018 = phi_3318_;
                if (_e3005 < 0f) {
                    phi_3325_ = (_e3005 + _e3013);
                } else {
                    phi_3325_ = (_e3005 - _e3013);
                }
                let _e3023 = phi_3325_;
                let _e3030 = (1f / sqrt((((_e3018 * _e3018) + (_e3023 * _e3023)) + (_e3009 * _e3009))));
                let _e3046 = (f32((bitcast<i32>((_e2896[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3052 = (f32((bitcast<i32>(_e2896[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3056 = ((1f - abs(_e3046)) - abs(_e3052));
                if (_e3056 < 0f) {
                    phi_3360_ = -(_e3056);
                } else {
                    phi_3360_ = 0f;
                }
                let _e3060 = phi_3360_;
                if (_e3046 < 0f) {
                    phi_3367_ = (_e3046 + _e3060);
                } else {
                    phi_3367_ = (_e3046 - _e3060);
                }
                let _e3065 = phi_3367_;
                if (_e3052 < 0f) {
                    phi_3374_ = (_e3052 + _e3060);
                } else {
                    phi_3374_ = (_e3052 - _e3060);
                }
                let _e3070 = phi_3374_;
                let _e3077 = (1f / sqrt((((_e3065 * _e3065) + (_e3070 * _e3070)) + (_e3056 * _e3056))));
                let _e3096 = (f32((bitcast<i32>((_e2896[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3102 = (f32((bitcast<i32>(_e2896[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3106 = ((1f - abs(_e3096)) - abs(_e3102));
                if (_e3106 < 0f) {
                    phi_3412_ = -(_e3106);
                } else {
                    phi_3412_ = 0f;
                }
                let _e3110 = phi_3412_;
                if (_e3096 < 0f) {
                    phi_3419_ = (_e3096 + _e3110);
                } else {
                    phi_3419_ = (_e3096 - _e3110);
                }
                let _e3115 = phi_3419_;
                if (_e3102 < 0f) {
                    phi_3426_ = (_e3102 + _e3110);
                } else {
                    phi_3426_ = (_e3102 - _e3110);
                }
                let _e3120 = phi_3426_;
                let _e3127 = (1f / sqrt((((_e3115 * _e3115) + (_e3120 * _e3120)) + (_e3106 * _e3106))));
                let _e3134 = ((((_e3018 * _e3030) * _e2627) + ((_e3065 * _e3077) * _e2621.u)) + ((_e3115 * _e3127) * _e2621.v));
                let _e3135 = ((((_e3023 * _e3030) * _e2627) + ((_e3070 * _e3077) * _e2621.u)) + ((_e3120 * _e3127) * _e2621.v));
                let _e3136 = ((((_e3009 * _e3030) * _e2627) + ((_e3056 * _e3077) * _e2621.u)) + ((_e3106 * _e3127) * _e2621.v));
                if (_e2621.instance < _e84) {
                } else {
                    return;
                }
                let _e3143 = instances.member[(0u + _e2621.instance)].world_to_object[0u];
                let _e3152 = instances.member[(0u + _e2621.instance)].world_to_object[1u];
                let _e3164 = instances.member[(0u + _e2621.instance)].world_to_object[2u];
                let _e3171 = (((_e3143.x * _e3134) + (_e3152.x * _e3135)) + (_e3164.x * _e3136));
                let _e3172 = (((_e3143.y * _e3134) + (_e3152.y * _e3135)) + (_e3164.y * _e3136));
                let _e3173 = (((_e3143.z * _e3134) + (_e3152.z * _e3135)) + (_e3164.z * _e3136));
                let _e3179 = sqrt((((_e3171 * _e3171) + (_e3172 * _e3172)) + (_e3173 * _e3173)));
                if (_e3179 > 0f) {
                    let _e3181 = (_e3171 / _e3179);
                    let _e3182 = (_e3172 / _e3179);
                    let _e3183 = (_e3173 / _e3179);
                    if ((((_e3181 * _e2874.x) + (_e3182 * _e2874.y)) + (_e3183 * _e2874.z)) < 0f) {
                        phi_3512_ = vec3<f32>(-(_e3181), -(_e3182), -(_e3183));
                    } else {
                        phi_3512_ = vec3<f32>(_e3181, _e3182, _e3183);
                    }
                    let _e3199 = phi_3512_;
                    phi_3513_ = _e3199;
                } else {
                    phi_3513_ = _e2874;
                }
                let _e3201 = phi_3513_;
                phi_3514_ = _e3201;
            }
            let _e3203 = phi_3514_;
            if (_e2975 > 0f) {
                if (_e2975 < 1f) {
                    phi_3523_ = _e2975;
                } else {
                    phi_3523_ = 1f;
                }
                let _e3207 = phi_3523_;
                phi_3524_ = _e3207;
            } else {
                phi_3524_ = 0f;
            }
            let _e3209 = phi_3524_;
            if (_e2977 > 0f) {
                if (_e2977 < 1f) {
                    phi_3534_ = _e2977;
                } else {
                    phi_3534_ = 1f;
                }
                let _e3214 = phi_3534_;
                phi_3535_ = _e3214;
            } else {
                phi_3535_ = 0f;
            }
            let _e3216 = phi_3535_;
            if (_e2979 > 0f) {
                if (_e2979 < 1f) {
                    phi_3545_ = _e2979;
                } else {
                    phi_3545_ = 1f;
                }
                let _e3221 = phi_3545_;
                phi_3546_ = _e3221;
            } else {
                phi_3546_ = 0f;
            }
            let _e3223 = phi_3546_;
            let _e3226 = ((sqrt(_e3209) * 255f) + 0.5f);
            let _e3235 = ((sqrt(_e3216) * 255f) + 0.5f);
            let _e3247 = ((sqrt(_e3223) * 255f) + 0.5f);
            phi_3581_ = abi_Sample(vec3<f32>(_e2782, _e2783, _e2784), _e2981, _e2874, _e2986, _e3203, ((select(select(u32(_e3226), 0u, (_e3226 < bitcast<f32>(0u))), 4294967295u, (_e3226 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3235), 0u, (_e3235 < bitcast<f32>(0u))), 4294967295u, (_e3235 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3247), 0u, (_e3247 < bitcast<f32>(0u))), 4294967295u, (_e3247 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_3581_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3261 = phi_3581_;
        if (_e96.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e96.shift)] = _e3261;
        if (_e2621.triangle != 4294967295u) {
            let _e3270 = ((1f - _e2621.u) - _e2621.v);
            if (_e2621.triangle < _e72) {
            } else {
                return;
            }
            let _e3275 = triangles.member[(0u + _e2621.triangle)];
            let _e3277 = (_e3275.i0_ & 2147483647u);
            if (_e3277 < _e87) {
            } else {
                return;
            }
            let _e3283 = before.member[(0u + _e3277)];
            if (_e3275.i1_ < _e87) {
            } else {
                return;
            }
            let _e3287 = before.member[(0u + _e3275.i1_)];
            if (_e3275.i2_ < _e87) {
            } else {
                return;
            }
            let _e3291 = before.member[(0u + _e3275.i2_)];
            if (_e2621.instance < _e84) {
            } else {
                return;
            }
            let _e3301 = instances.member[(0u + _e2621.instance)].object_to_world[0u];
            let _e3314 = instances.member[(0u + _e2621.instance)].object_to_world[1u];
            let _e3327 = instances.member[(0u + _e2621.instance)].object_to_world[2u];
            if (_e2621.instance < _e84) {
            } else {
                return;
            }
            let _e3351 = instances.member[(0u + _e2621.instance)].object_to_world[0u];
            let _e3364 = instances.member[(0u + _e2621.instance)].object_to_world[1u];
            let _e3377 = instances.member[(0u + _e2621.instance)].object_to_world[2u];
            if (_e2621.instance < _e84) {
            } else {
                return;
            }
            let _e3404 = instances.member[(0u + _e2621.instance)].object_to_world[0u];
            let _e3417 = instances.member[(0u + _e2621.instance)].object_to_world[1u];
            let _e3430 = instances.member[(0u + _e2621.instance)].object_to_world[2u];
            phi_3804_ = vec3<f32>((((((((_e3301.x * _e3283.x) + (_e3301.y * _e3283.y)) + (_e3301.z * _e3283.z)) + (_e3301.w * 1f)) * _e3270) + (((((_e3351.x * _e3287.x) + (_e3351.y * _e3287.y)) + (_e3351.z * _e3287.z)) + (_e3351.w * 1f)) * _e2621.u)) + (((((_e3404.x * _e3291.x) + (_e3404.y * _e3291.y)) + (_e3404.z * _e3291.z)) + (_e3404.w * 1f)) * _e2621.v)), (((((((_e3314.x * _e3283.x) + (_e3314.y * _e3283.y)) + (_e3314.z * _e3283.z)) + (_e3314.w * 1f)) * _e3270) + (((((_e3364.x * _e3287.x) + (_e3364.y * _e3287.y)) + (_e3364.z * _e3287.z)) + (_e3364.w * 1f)) * _e2621.u)) + (((((_e3417.x * _e3291.x) + (_e3417.y * _e3291.y)) + (_e3417.z * _e3291.z)) + (_e3417.w * 1f)) * _e2621.v)), (((((((_e3327.x * _e3283.x) + (_e3327.y * _e3283.y)) + (_e3327.z * _e3283.z)) + (_e3327.w * 1f)) * _e3270) + (((((_e3377.x * _e3287.x) + (_e3377.y * _e3287.y)) + (_e3377.z * _e3287.z)) + (_e3377.w * 1f)) * _e2621.u)) + (((((_e3430.x * _e3291.x) + (_e3430.y * _e3291.y)) + (_e3430.z * _e3291.z)) + (_e3430.w * 1f)) * _e2621.v)));
        } else {
            phi_3804_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e3450 = phi_3804_;
        if (_e96.shift < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e96.shift)] = vec4<f32>(_e3450.x, _e3450.y, _e3450.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
