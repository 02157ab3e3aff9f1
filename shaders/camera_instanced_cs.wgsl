struct abi_CameraParams {
    eye: vec3<f32>,
    root: u32,
    right: vec3<f32>,
    layers_behind: u32,
    up: vec3<f32>,
    pad1_: u32,
    forward: vec3<f32>,
    pad2_: u32,
    size: vec2<u32>,
    grid: vec2<u32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_16 {
    member: array<abi_Sample>,
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

struct type_27 {
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

struct type_31 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_35 {
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

struct type_39 {
    member: array<abi_Material>,
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

struct type_50 {
    member: array<lt_bvh_Instance>,
}

struct type_54 {
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
var<storage> vertices: type_35;
@group(0) @binding(4) 
var<storage> materials: type_39;
@group(0) @binding(0) 
var<uniform> p: type_54;
@group(0) @binding(1) 
var<storage> nodes: type_27;
@group(0) @binding(2) 
var<storage> triangles: type_31;
@group(0) @binding(5) 
var<storage, read_write> samples: type_16;
@group(0) @binding(6) 
var<storage> instances: type_50;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_201_: lt_bvh_traverse_Tree;
    var phi_202_: bool;
    var phi_203_: lt_bvh_traverse_Tree;
    var phi_204_: bool;
    var phi_209_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_201_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_202_ = false;
        } else {
            phi_201_ = lt_bvh_traverse_Tree();
            phi_202_ = true;
        }
        let _e75 = phi_201_;
        let _e77 = phi_202_;
        phi_203_ = _e75;
        phi_204_ = _e77;
    } else {
        phi_203_ = lt_bvh_traverse_Tree();
        phi_204_ = true;
    }
    let _e79 = phi_203_;
    let _e81 = phi_204_;
    if _e81 {
        phi_209_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_209_ = _e79;
    }
    let _e86 = phi_209_;
    return lt_bvh_traverse_Tree(_e86.root, _e86.first_primitive);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_224_: bool;
    var phi_228_: f32;

    if (param_3 != param_3) {
        phi_224_ = true;
    } else {
        let _e65 = (param_4 >= param_3);
        if _e65 {
        }
        phi_224_ = _e65;
    }
    let _e67 = phi_224_;
    if _e67 {
        phi_228_ = param_4;
    } else {
        phi_228_ = param_3;
    }
    let _e69 = phi_228_;
    return _e69;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_240_: bool;
    var phi_244_: f32;

    if (param_5 != param_5) {
        phi_240_ = true;
    } else {
        let _e65 = (param_6 <= param_5);
        if _e65 {
        }
        phi_240_ = _e65;
    }
    let _e67 = phi_240_;
    if _e67 {
        phi_244_ = param_6;
    } else {
        phi_244_ = param_5;
    }
    let _e69 = phi_244_;
    return _e69;
}

fn _lt_bvh_ray_Ray_new(param_7: vec3<f32>, param_8: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_7, 0f, param_8, 300000000000000000000000000000000000000f);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_9: f32, param_10: f32) -> f32 {
    var phi_256_: f32;

    if (param_9 > param_10) {
        phi_256_ = param_9;
    } else {
        phi_256_ = param_10;
    }
    let _e66 = phi_256_;
    return _e66;
}

fn _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(param_11: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(1f, 1f, 1f);
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: lt_bvh_traverse_Stack;
    var phi_397_: bool;
    var phi_398_: bool;
    var phi_399_: bool;
    var phi_400_: bool;
    var phi_404_: bool;
    var phi_417_: bool;
    var phi_418_: bool;
    var phi_419_: bool;
    var phi_420_: bool;
    var phi_424_: bool;
    var phi_437_: bool;
    var phi_438_: bool;
    var phi_439_: bool;
    var phi_443_: bool;
    var phi_444_: bool;
    var phi_445_: bool;
    var phi_446_: bool;
    var phi_447_: bool;
    var phi_451_: bool;
    var phi_527_: f32;
    var phi_534_: f32;
    var phi_542_: f32;
    var phi_549_: f32;
    var phi_557_: f32;
    var phi_564_: f32;
    var phi_587_: f32;
    var phi_592_: f32;
    var phi_597_: f32;
    var phi_602_: f32;
    var phi_607_: f32;
    var phi_626_: u32;
    var phi_631_: u32;
    var phi_636_: u32;
    var phi_750_: bool;
    var phi_751_: bool;
    var phi_782_: u32;
    var phi_784_: u32;
    var phi_787_: lt_bvh_Hit;
    var phi_872_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_899_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_926_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_932_: u32;
    var phi_935_: u32;
    var phi_949_: u32;
    var phi_959_: u32;
    var phi_969_: u32;
    var phi_987_: u32;
    var phi_997_: u32;
    var phi_1007_: u32;
    var phi_1043_: u32;
    var phi_1056_: u32;
    var phi_1061_: u32;
    var phi_1062_: u32;
    var phi_1063_: u32;
    var phi_933_: u32;
    var phi_936_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1121_: u32;
    var phi_1124_: lt_bvh_Hit;
    var phi_1179_: f32;
    var phi_1184_: f32;
    var phi_1189_: f32;
    var phi_1197_: f32;
    var phi_1202_: f32;
    var phi_1207_: f32;
    var phi_1339_: bool;
    var phi_1340_: bool;
    var phi_1341_: bool;
    var phi_1342_: bool;
    var phi_1346_: bool;
    var phi_1359_: bool;
    var phi_1360_: bool;
    var phi_1361_: bool;
    var phi_1362_: bool;
    var phi_1366_: bool;
    var phi_1379_: bool;
    var phi_1380_: bool;
    var phi_1381_: bool;
    var phi_1385_: bool;
    var phi_1386_: bool;
    var phi_1387_: bool;
    var phi_1388_: bool;
    var phi_1389_: bool;
    var phi_1393_: bool;
    var phi_1463_: f32;
    var phi_1470_: f32;
    var phi_1477_: f32;
    var phi_1484_: f32;
    var phi_1491_: f32;
    var phi_1498_: f32;
    var phi_1515_: f32;
    var phi_1520_: f32;
    var phi_1525_: f32;
    var phi_1530_: f32;
    var phi_1535_: f32;
    var phi_1561_: bool;
    var phi_1562_: bool;
    var phi_1570_: u32;
    var phi_1571_: u32;
    var phi_1582_: vec3<f32>;
    var phi_1583_: vec3<f32>;
    var phi_1596_: u32;
    var phi_1601_: u32;
    var phi_1606_: u32;
    var phi_1720_: bool;
    var phi_1721_: bool;
    var phi_1752_: u32;
    var phi_1754_: lt_bvh_Hit;
    var phi_1757_: u32;
    var phi_1838_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1865_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1892_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1898_: u32;
    var phi_1901_: u32;
    var phi_1915_: u32;
    var phi_1925_: u32;
    var phi_1935_: u32;
    var phi_1953_: u32;
    var phi_1963_: u32;
    var phi_1973_: u32;
    var phi_2009_: u32;
    var phi_2022_: u32;
    var phi_2027_: u32;
    var phi_2028_: u32;
    var phi_2029_: u32;
    var phi_1899_: u32;
    var phi_1902_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_2087_: lt_bvh_Hit;
    var phi_2090_: u32;
    var phi_2134_: vec3<f32>;
    var phi_2135_: vec3<f32>;
    var phi_2164_: vec3<f32>;
    var phi_2165_: vec3<f32>;
    var phi_2194_: vec3<f32>;
    var phi_2195_: vec3<f32>;
    var phi_2213_: bool;
    var phi_2214_: bool;
    var phi_2218_: f32;
    var phi_2219_: f32;
    var phi_2220_: f32;
    var phi_2221_: f32;
    var phi_2229_: f32;
    var phi_2239_: bool;
    var phi_2240_: bool;
    var phi_2244_: f32;
    var phi_2245_: f32;
    var phi_2246_: f32;
    var phi_2247_: f32;
    var phi_2255_: f32;
    var phi_2265_: bool;
    var phi_2266_: bool;
    var phi_2270_: f32;
    var phi_2271_: f32;
    var phi_2272_: f32;
    var phi_2273_: f32;
    var phi_2281_: f32;
    var phi_2296_: f32;
    var phi_2297_: bool;
    var phi_2298_: f32;
    var phi_2299_: bool;
    var phi_2300_: f32;
    var phi_2301_: bool;
    var phi_2319_: f32;
    var phi_2320_: bool;
    var phi_2321_: bool;
    var phi_2322_: f32;
    var phi_2323_: bool;
    var phi_2324_: bool;
    var phi_2328_: bool;
    var phi_2329_: f32;
    var phi_2330_: bool;
    var phi_2358_: vec3<f32>;
    var phi_2359_: vec3<f32>;
    var phi_2384_: vec3<f32>;
    var phi_2385_: vec3<f32>;
    var phi_2410_: vec3<f32>;
    var phi_2411_: vec3<f32>;
    var phi_2467_: f32;
    var phi_2476_: f32;
    var phi_2485_: f32;
    var phi_2494_: f32;
    var phi_2501_: f32;
    var phi_2508_: f32;
    var phi_2521_: f32;
    var phi_2530_: f32;
    var phi_2539_: f32;
    var phi_2548_: f32;
    var phi_2555_: f32;
    var phi_2562_: f32;
    var phi_2579_: f32;
    var phi_2584_: f32;
    var phi_2589_: f32;
    var phi_2597_: f32;
    var phi_2602_: f32;
    var phi_2607_: f32;
    var phi_2619_: f32;
    var phi_2624_: f32;
    var phi_2629_: f32;
    var phi_2634_: f32;
    var phi_2639_: lt_bvh_triangle_Intersection;
    var phi_2640_: bool;
    var phi_2641_: lt_bvh_triangle_Intersection;
    var phi_2642_: bool;
    var phi_2646_: lt_bvh_triangle_Intersection;
    var phi_2647_: bool;
    var phi_2648_: lt_bvh_triangle_Intersection;
    var phi_2649_: bool;
    var phi_2650_: bool;
    var phi_2654_: bool;
    var phi_2658_: lt_bvh_triangle_Intersection;
    var phi_2696_: bool;
    var phi_2697_: bool;
    var phi_2698_: bool;
    var phi_2699_: bool;
    var phi_2700_: bool;
    var phi_2701_: bool;
    var phi_2705_: bool;
    var phi_2706_: bool;
    var phi_2720_: bool;
    var phi_2728_: lt_bvh_Hit;
    var phi_2729_: lt_bvh_Hit;
    var phi_2730_: lt_bvh_Hit;
    var phi_2731_: lt_bvh_Hit;
    var phi_2088_: lt_bvh_Hit;
    var phi_2091_: u32;
    var phi_2732_: bool;
    var phi_2771_: bool;
    var phi_2772_: bool;
    var phi_2803_: u32;
    var phi_1755_: lt_bvh_Hit;
    var phi_1758_: u32;
    var phi_2804_: lt_bvh_Hit;
    var phi_2805_: lt_bvh_Hit;
    var phi_2806_: bool;
    var phi_2810_: lt_bvh_Hit;
    var phi_2811_: lt_bvh_Hit;
    var phi_2812_: lt_bvh_Hit;
    var phi_2813_: lt_bvh_Hit;
    var phi_1122_: u32;
    var phi_1125_: lt_bvh_Hit;
    var phi_2814_: bool;
    var phi_2853_: bool;
    var phi_2854_: bool;
    var phi_2885_: u32;
    var phi_785_: u32;
    var phi_788_: lt_bvh_Hit;
    var phi_2886_: lt_bvh_Hit;
    var phi_2887_: lt_bvh_Hit;
    var phi_2888_: bool;
    var phi_2892_: lt_bvh_Hit;
    var phi_3080_: f32;
    var phi_3085_: f32;
    var phi_3090_: f32;
    var phi_3098_: f32;
    var phi_3103_: f32;
    var phi_3108_: f32;
    var phi_3172_: vec3<f32>;
    var phi_3293_: u32;
    var phi_3320_: f32;
    var phi_3327_: f32;
    var phi_3334_: f32;
    var phi_3369_: f32;
    var phi_3376_: f32;
    var phi_3383_: f32;
    var phi_3421_: f32;
    var phi_3428_: f32;
    var phi_3435_: f32;
    var phi_3521_: vec3<f32>;
    var phi_3522_: vec3<f32>;
    var phi_3523_: vec3<f32>;
    var phi_3532_: f32;
    var phi_3533_: f32;
    var phi_3543_: f32;
    var phi_3544_: f32;
    var phi_3554_: f32;
    var phi_3555_: f32;
    var phi_3590_: abi_Sample;
    var local_8: lt_bvh_Hit;
    var local_9: lt_bvh_Hit;
    var local_10: lt_bvh_Hit;
    var local_11: lt_bvh_Hit;

    let _e64 = id_1;
    let _e68 = arrayLength((&nodes.member));
    let _e71 = arrayLength((&triangles.member));
    let _e74 = arrayLength((&vertices.member));
    let _e83 = arrayLength((&instances.member));
    let _e86 = p.member.size[0u];
    let _e88 = p.member.size[1u];
    let _e89 = lt_shaders_entry_pixel_index(_e64, _e86, _e88);
    if (bitcast<i32>(_e89.root) != 0i) {
        let _e95 = p.member.root;
        let _e99 = p.member.eye;
        let _e102 = p.member.grid[0u];
        let _e104 = p.member.grid[1u];
        let _e123 = p.member.size[0u];
        let _e127 = ((((f32(_e64.x) + ((f32((_e64.y & (_e104 - 1u))) + 0.5f) / f32(_e104))) / f32(_e123)) * 2f) - 1f);
        let _e130 = p.member.size[1u];
        let _e134 = (1f - (((f32(_e64.y) + ((f32((_e64.x & (_e102 - 1u))) + 0.5f) / f32(_e102))) / f32(_e130)) * 2f));
        let _e136 = p.member.forward;
        let _e138 = p.member.right;
        let _e152 = p.member.up;
        let _e163 = _lt_bvh_ray_Ray_new(_e99, vec3<f32>(((_e136.x + (_e138.x * _e127)) + (_e152.x * _e134)), ((_e136.y + (_e138.y * _e127)) + (_e152.y * _e134)), ((_e136.z + (_e138.z * _e127)) + (_e152.z * _e134))));
        let _e165 = lt_bvh_Hit(_e163.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e168 = abs(_e163.direction.x);
        let _e170 = abs(_e163.direction.y);
        let _e172 = abs(_e163.direction.z);
        if (abs(_e163.origin.x) < 1000000000000000f) {
            if (abs(_e163.origin.y) < 1000000000000000f) {
                phi_397_ = (abs(_e163.origin.z) < 1000000000000000f);
                phi_398_ = false;
            } else {
                phi_397_ = bool();
                phi_398_ = true;
            }
            let _e184 = phi_397_;
            let _e186 = phi_398_;
            phi_399_ = _e184;
            phi_400_ = _e186;
        } else {
            phi_399_ = bool();
            phi_400_ = true;
        }
        let _e188 = phi_399_;
        let _e190 = phi_400_;
        if _e190 {
            phi_404_ = false;
        } else {
            phi_404_ = _e188;
        }
        let _e192 = phi_404_;
        if _e192 {
            if (_e168 < 1000000000000000f) {
                if (_e170 < 1000000000000000f) {
                    phi_417_ = (_e172 < 1000000000000000f);
                    phi_418_ = false;
                } else {
                    phi_417_ = bool();
                    phi_418_ = true;
                }
                let _e197 = phi_417_;
                let _e199 = phi_418_;
                phi_419_ = _e197;
                phi_420_ = _e199;
            } else {
                phi_419_ = bool();
                phi_420_ = true;
            }
            let _e201 = phi_419_;
            let _e203 = phi_420_;
            if _e203 {
                phi_424_ = false;
            } else {
                phi_424_ = _e201;
            }
            let _e205 = phi_424_;
            if _e205 {
                if (_e168 > 0f) {
                    phi_438_ = bool();
                    phi_439_ = true;
                } else {
                    let _e207 = (_e170 > 0f);
                    if _e207 {
                        phi_437_ = bool();
                    } else {
                        phi_437_ = (_e172 > 0f);
                    }
                    let _e210 = phi_437_;
                    phi_438_ = _e210;
                    phi_439_ = _e207;
                }
                let _e212 = phi_438_;
                let _e214 = phi_439_;
                if _e214 {
                    phi_443_ = true;
                } else {
                    phi_443_ = _e212;
                }
                let _e216 = phi_443_;
                phi_444_ = _e216;
                phi_445_ = false;
            } else {
                phi_444_ = bool();
                phi_445_ = true;
            }
            let _e218 = phi_444_;
            let _e220 = phi_445_;
            phi_446_ = _e218;
            phi_447_ = _e220;
        } else {
            phi_446_ = bool();
            phi_447_ = true;
        }
        let _e222 = phi_446_;
        let _e224 = phi_447_;
        if _e224 {
            phi_451_ = false;
        } else {
            phi_451_ = _e222;
        }
        let _e226 = phi_451_;
        if _e226 {
            let _e227 = (_e95 >= _e68);
            if _e227 {
                phi_2886_ = lt_bvh_Hit();
            } else {
                if (_e95 < _e68) {
                } else {
                    return;
                }
                let _e233 = nodes.member[(0u + _e95)].frame[0u];
                let _e237 = nodes.member[(0u + _e95)].frame[1u];
                let _e241 = nodes.member[(0u + _e95)].frame[2u];
                let _e245 = nodes.member[(0u + _e95)].frame[0u];
                let _e249 = nodes.member[(0u + _e95)].frame[1u];
                let _e253 = nodes.member[(0u + _e95)].frame[2u];
                let _e257 = nodes.member[(0u + _e95)].frame[3u];
                let _e296 = core_intrinsics_maximum_number_nsz_f32_(abs(_e163.direction.x), abs(_e163.direction.y));
                let _e297 = core_intrinsics_maximum_number_nsz_f32_(_e296, abs(_e163.direction.z));
                let _e298 = (_e297 * 0.0000000000009094947f);
                if (abs(_e163.direction.x) < _e298) {
                    phi_527_ = _e298;
                } else {
                    phi_527_ = abs(_e163.direction.x);
                }
                let _e304 = phi_527_;
                if (_e163.direction.x < 0f) {
                    phi_534_ = (-1f / _e304);
                } else {
                    phi_534_ = (1f / _e304);
                }
                let _e309 = phi_534_;
                if (abs(_e163.direction.y) < _e298) {
                    phi_542_ = _e298;
                } else {
                    phi_542_ = abs(_e163.direction.y);
                }
                let _e315 = phi_542_;
                if (_e163.direction.y < 0f) {
                    phi_549_ = (-1f / _e315);
                } else {
                    phi_549_ = (1f / _e315);
                }
                let _e320 = phi_549_;
                if (abs(_e163.direction.z) < _e298) {
                    phi_557_ = _e298;
                } else {
                    phi_557_ = abs(_e163.direction.z);
                }
                let _e326 = phi_557_;
                if (_e163.direction.z < 0f) {
                    phi_564_ = (-1f / _e326);
                } else {
                    phi_564_ = (1f / _e326);
                }
                let _e331 = phi_564_;
                let _e338 = abs((bitcast<f32>(_e233) - _e163.origin.x));
                let _e339 = abs((bitcast<f32>(_e237) - _e163.origin.y));
                let _e340 = abs((bitcast<f32>(_e241) - _e163.origin.z));
                let _e347 = abs(((bitcast<f32>(_e245) + (bitcast<f32>((((_e257 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e163.origin.x));
                let _e348 = abs(((bitcast<f32>(_e249) + (bitcast<f32>((((_e257 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e163.origin.y));
                let _e349 = abs(((bitcast<f32>(_e253) + (bitcast<f32>((((_e257 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e163.origin.z));
                if (_e338 > _e347) {
                    phi_587_ = _e338;
                } else {
                    phi_587_ = _e347;
                }
                let _e352 = phi_587_;
                if (_e339 > _e348) {
                    phi_592_ = _e339;
                } else {
                    phi_592_ = _e348;
                }
                let _e355 = phi_592_;
                if (_e340 > _e349) {
                    phi_597_ = _e340;
                } else {
                    phi_597_ = _e349;
                }
                let _e358 = phi_597_;
                if (_e352 > _e355) {
                    phi_602_ = _e352;
                } else {
                    phi_602_ = _e355;
                }
                let _e361 = phi_602_;
                if (_e361 > _e358) {
                    phi_607_ = _e361;
                } else {
                    phi_607_ = _e358;
                }
                let _e364 = phi_607_;
                let _e368 = (_e364 * 0.0000019073486f);
                let _e369 = (abs(_e309) * _e368);
                let _e370 = (abs(_e320) * _e368);
                let _e371 = (abs(_e331) * _e368);
                let _e375 = (_e364 * 0.0000009536743f);
                let _e376 = (abs(_e309) * _e375);
                let _e377 = (abs(_e320) * _e375);
                let _e378 = (abs(_e331) * _e375);
                if (_e309 < 0f) {
                    phi_626_ = 0u;
                } else {
                    phi_626_ = 1u;
                }
                let _e381 = phi_626_;
                if (_e320 < 0f) {
                    phi_631_ = 0u;
                } else {
                    phi_631_ = 2u;
                }
                let _e384 = phi_631_;
                if (_e331 < 0f) {
                    phi_636_ = 0u;
                } else {
                    phi_636_ = 4u;
                }
                let _e387 = phi_636_;
                let _e389 = ((_e381 | _e384) | _e387);
                let _e390 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e95, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e390.first[0], _e390.first[1], _e390.first[2], _e390.first[3], _e390.first[4], _e390.first[5], _e390.first[6], _e390.first[7], _e390.first[8], _e390.first[9], _e390.first[10], _e390.first[11], _e390.first[12], _e390.first[13], _e390.first[14], _e390.first[15], _e390.first[16], _e390.first[17], _e390.first[18], _e390.first[19], _e390.first[20], _e390.first[21], _e390.first[22], _e390.first[23], _e390.first[24], _e390.first[25], _e390.first[26], _e390.first[27], _e390.first[28], _e390.first[29], _e390.first[30], _e390.first[31]), array<u32, 32>(_e390.mask[0], _e390.mask[1], _e390.mask[2], _e390.mask[3], _e390.mask[4], _e390.mask[5], _e390.mask[6], _e390.mask[7], _e390.mask[8], _e390.mask[9], _e390.mask[10], _e390.mask[11], _e390.mask[12], _e390.mask[13], _e390.mask[14], _e390.mask[15], _e390.mask[16], _e390.mask[17], _e390.mask[18], _e390.mask[19], _e390.mask[20], _e390.mask[21], _e390.mask[22], _e390.mask[23], _e390.mask[24], _e390.mask[25], _e390.mask[26], _e390.mask[27], _e390.mask[28], _e390.mask[29], _e390.mask[30], _e390.mask[31]), _e390.len, _e390.group, _e390.group_mask);
                let _e464 = local_1.group_mask;
                if ((_e464 & 4278190080u) == 0u) {
                    let _e468 = local_1.len;
                    if (_e468 == 0u) {
                        phi_750_ = false;
                    } else {
                        let _e472 = local_1.len;
                        local_1.len = (_e472 - 1u);
                        let _e475 = local_1.len;
                        if (_e475 < 32u) {
                        } else {
                            return;
                        }
                        let _e480 = local_1.first[(0u + _e475)];
                        local_1.group = _e480;
                        let _e483 = local_1.len;
                        if (_e483 < 32u) {
                        } else {
                            return;
                        }
                        let _e488 = local_1.mask[(0u + _e483)];
                        local_1.group_mask = _e488;
                        phi_750_ = true;
                    }
                    let _e491 = phi_750_;
                    phi_751_ = _e491;
                } else {
                    phi_751_ = true;
                }
                let _e493 = phi_751_;
                if _e493 {
                    let _e495 = local_1.group_mask;
                    let _e501 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e495)), 32u, (_e495 == 0u)));
                    let _e505 = local_1.group_mask;
                    let _e519 = local_1.group_mask;
                    local_1.group_mask = (_e519 & ~((1u << bitcast<u32>((_e501 & 31u)))));
                    let _e522 = local_1.group;
                    phi_782_ = (_e522 + countOneBits(((_e505 & ~((4294967295u << bitcast<u32>((((_e501 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_782_ = 4294967295u;
                }
                let _e525 = phi_782_;
                phi_784_ = _e525;
                phi_787_ = _e165;
                loop {
                    let _e527 = phi_784_;
                    let _e529 = phi_787_;
                    local_11 = _e529;
                    let _e530 = (_e527 != 4294967295u);
                    if _e530 {
                        if (_e527 < _e68) {
                        } else {
                            return;
                        }
                        let _e538 = nodes.member[(0u + _e527)].frame[3u];
                        let _e563 = (bitcast<f32>((((_e538 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e309);
                        let _e564 = (bitcast<f32>((((_e538 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e320);
                        let _e565 = (bitcast<f32>((((_e538 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e331);
                        let _e568 = nodes.member[(0u + _e527)].frame[0u];
                        let _e572 = nodes.member[(0u + _e527)].frame[1u];
                        let _e576 = nodes.member[(0u + _e527)].frame[2u];
                        let _e584 = ((bitcast<f32>(_e568) - _e163.origin.x) * _e309);
                        let _e585 = ((bitcast<f32>(_e572) - _e163.origin.y) * _e320);
                        let _e586 = ((bitcast<f32>(_e576) - _e163.origin.z) * _e331);
                        let _e594 = nodes.member[(0u + _e527)].x;
                        if (_e309 < 0f) {
                            let _e605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e594.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e611 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e605.unnamed.root, _e594.w), _e605.unnamed_1);
                            let _e617 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e611.unnamed, lt_bvh_traverse_Tree(_e594.x, _e611.unnamed_1.first_primitive));
                            phi_872_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e617.unnamed, lt_bvh_traverse_Tree(_e617.unnamed_1.root, _e594.y));
                        } else {
                            let _e633 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e594.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e639 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e633.unnamed.root, _e594.y), _e633.unnamed_1);
                            let _e645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e639.unnamed, lt_bvh_traverse_Tree(_e594.z, _e639.unnamed_1.first_primitive));
                            phi_872_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e645.unnamed, lt_bvh_traverse_Tree(_e645.unnamed_1.root, _e594.w));
                        }
                        let _e653 = phi_872_;
                        let _e663 = nodes.member[(0u + _e527)].y;
                        if (_e320 < 0f) {
                            let _e674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e663.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e674.unnamed.root, _e663.w), _e674.unnamed_1);
                            let _e686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e680.unnamed, lt_bvh_traverse_Tree(_e663.x, _e680.unnamed_1.first_primitive));
                            phi_899_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e686.unnamed, lt_bvh_traverse_Tree(_e686.unnamed_1.root, _e663.y));
                        } else {
                            let _e702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e663.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e702.unnamed.root, _e663.y), _e702.unnamed_1);
                            let _e714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e708.unnamed, lt_bvh_traverse_Tree(_e663.z, _e708.unnamed_1.first_primitive));
                            phi_899_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e714.unnamed, lt_bvh_traverse_Tree(_e714.unnamed_1.root, _e663.w));
                        }
                        let _e722 = phi_899_;
                        let _e732 = nodes.member[(0u + _e527)].z;
                        if (_e331 < 0f) {
                            let _e743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e732.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e749 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e743.unnamed.root, _e732.w), _e743.unnamed_1);
                            let _e755 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e749.unnamed, lt_bvh_traverse_Tree(_e732.x, _e749.unnamed_1.first_primitive));
                            phi_926_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e755.unnamed, lt_bvh_traverse_Tree(_e755.unnamed_1.root, _e732.y));
                        } else {
                            let _e771 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e732.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e777 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e771.unnamed.root, _e732.y), _e771.unnamed_1);
                            let _e783 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e777.unnamed, lt_bvh_traverse_Tree(_e732.z, _e777.unnamed_1.first_primitive));
                            phi_926_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e783.unnamed, lt_bvh_traverse_Tree(_e783.unnamed_1.root, _e732.w));
                        }
                        let _e791 = phi_926_;
                        phi_932_ = 0u;
                        phi_935_ = 0u;
                        loop {
                            let _e801 = phi_932_;
                            let _e803 = phi_935_;
                            local_2 = _e803;
                            local_3 = _e803;
                            local_4 = _e803;
                            let _e804 = (_e801 < 8u);
                            if _e804 {
                                let _e806 = (_e801 >> bitcast<u32>(2i));
                                let _e807 = (_e801 & 3u);
                                if (_e806 == 0u) {
                                    phi_949_ = _e653.unnamed.root;
                                } else {
                                    phi_949_ = _e653.unnamed.first_primitive;
                                }
                                let _e810 = phi_949_;
                                if (_e806 == 0u) {
                                    phi_959_ = _e722.unnamed.root;
                                } else {
                                    phi_959_ = _e722.unnamed.first_primitive;
                                }
                                let _e819 = phi_959_;
                                if (_e806 == 0u) {
                                    phi_969_ = _e791.unnamed.root;
                                } else {
                                    phi_969_ = _e791.unnamed.first_primitive;
                                }
                                let _e828 = phi_969_;
                                let _e841 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e810 >> bitcast<u32>(((_e807 * 8u) & 31u))) & 255u)) * _e563) + (_e584 - _e369)), ((f32(((_e819 >> bitcast<u32>(((_e807 * 8u) & 31u))) & 255u)) * _e564) + (_e585 - _e370)));
                                let _e842 = core_intrinsics_maximum_number_nsz_f32_(_e841, ((f32(((_e828 >> bitcast<u32>(((_e807 * 8u) & 31u))) & 255u)) * _e565) + (_e586 - _e371)));
                                if (_e806 == 0u) {
                                    phi_987_ = _e653.unnamed_1.root;
                                } else {
                                    phi_987_ = _e653.unnamed_1.first_primitive;
                                }
                                let _e845 = phi_987_;
                                if (_e806 == 0u) {
                                    phi_997_ = _e722.unnamed_1.root;
                                } else {
                                    phi_997_ = _e722.unnamed_1.first_primitive;
                                }
                                let _e854 = phi_997_;
                                if (_e806 == 0u) {
                                    phi_1007_ = _e791.unnamed_1.root;
                                } else {
                                    phi_1007_ = _e791.unnamed_1.first_primitive;
                                }
                                let _e863 = phi_1007_;
                                let _e876 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e845 >> bitcast<u32>(((_e807 * 8u) & 31u))) & 255u)) * _e563) + (_e584 + _e369)), ((f32(((_e854 >> bitcast<u32>(((_e807 * 8u) & 31u))) & 255u)) * _e564) + (_e585 + _e370)));
                                let _e877 = core_intrinsics_minimum_number_nsz_f32_(_e876, ((f32(((_e863 >> bitcast<u32>(((_e807 * 8u) & 31u))) & 255u)) * _e565) + (_e586 + _e371)));
                                if (_e842 <= _e877) {
                                    if (_e842 <= _e529.t) {
                                        if (_e877 >= _e163.tmin) {
                                            if (_e806 == 0u) {
                                                let _e884 = nodes.member[(0u + _e527)].links[2u];
                                                phi_1043_ = _e884;
                                            } else {
                                                let _e887 = nodes.member[(0u + _e527)].links[3u];
                                                phi_1043_ = _e887;
                                            }
                                            let _e889 = phi_1043_;
                                            let _e894 = ((_e889 >> bitcast<u32>(((_e807 * 8u) & 31u))) & 255u);
                                            let _e895 = (_e894 & 31u);
                                            if (_e895 >= 24u) {
                                                phi_1056_ = (24u + ((_e895 - 24u) ^ _e389));
                                            } else {
                                                phi_1056_ = _e895;
                                            }
                                            let _e901 = phi_1056_;
                                            phi_1061_ = (_e803 | ((_e894 >> bitcast<u32>(5i)) << bitcast<u32>((_e901 & 31u))));
                                        } else {
                                            phi_1061_ = _e803;
                                        }
                                        let _e909 = phi_1061_;
                                        phi_1062_ = _e909;
                                    } else {
                                        phi_1062_ = _e803;
                                    }
                                    let _e911 = phi_1062_;
                                    phi_1063_ = _e911;
                                } else {
                                    phi_1063_ = _e803;
                                }
                                let _e913 = phi_1063_;
                                phi_933_ = (_e801 + 1u);
                                phi_936_ = _e913;
                            } else {
                                phi_933_ = u32();
                                phi_936_ = u32();
                            }
                            let _e916 = phi_933_;
                            let _e918 = phi_936_;
                            continue;
                            continuing {
                                phi_932_ = _e916;
                                phi_935_ = _e918;
                                break if !(_e804);
                            }
                        }
                        let _e922 = nodes.member[(0u + _e527)].links[0u];
                        let _e926 = nodes.member[(0u + _e527)].frame[3u];
                        let _e930 = local_2;
                        if ((_e930 & 4278190080u) == 0u) {
                        } else {
                            let _e934 = local_1.group_mask;
                            if ((_e934 & 4278190080u) == 0u) {
                            } else {
                                let _e938 = local_1.len;
                                if (_e938 < 32u) {
                                    let _e941 = local_1.group;
                                    let _e943 = local_1.len;
                                    if (_e943 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e943)] = _e941;
                                    let _e949 = local_1.group_mask;
                                    let _e951 = local_1.len;
                                    if (_e951 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e951)] = _e949;
                                    let _e958 = local_1.len;
                                    local_1.len = (_e958 + 1u);
                                }
                            }
                            local_1.group = (_e95 + _e922);
                            let _e962 = local_3;
                            local_1.group_mask = ((_e962 & 4278190080u) | (_e926 >> bitcast<u32>(24i)));
                        }
                        let _e967 = local_4;
                        phi_1121_ = (_e967 & 16777215u);
                        phi_1124_ = _e529;
                        loop {
                            let _e970 = phi_1121_;
                            let _e972 = phi_1124_;
                            local_10 = _e972;
                            if (_e970 == 0u) {
                                phi_1122_ = u32();
                                phi_1125_ = lt_bvh_Hit();
                                phi_2814_ = false;
                            } else {
                                let _e976 = nodes.member[(0u + _e527)].links[1u];
                                let _e980 = (_e976 + select(firstTrailingBit(_e970), 32u, (_e970 == 0u)));
                                if (_e980 < _e83) {
                                } else {
                                    return;
                                }
                                let _e987 = instances.member[(0u + _e980)].low_world;
                                let _e989 = instances.member[(0u + _e980)].high_world;
                                let _e999 = ((_e987.x - _e163.origin.x) * _e309);
                                let _e1000 = ((_e987.y - _e163.origin.y) * _e320);
                                let _e1001 = ((_e987.z - _e163.origin.z) * _e331);
                                let _e1011 = ((_e989.x - _e163.origin.x) * _e309);
                                let _e1012 = ((_e989.y - _e163.origin.y) * _e320);
                                let _e1013 = ((_e989.z - _e163.origin.z) * _e331);
                                if (_e999 < _e1011) {
                                    phi_1179_ = _e999;
                                } else {
                                    phi_1179_ = _e1011;
                                }
                                let _e1016 = phi_1179_;
                                if (_e1000 < _e1012) {
                                    phi_1184_ = _e1000;
                                } else {
                                    phi_1184_ = _e1012;
                                }
                                let _e1019 = phi_1184_;
                                if (_e1001 < _e1013) {
                                    phi_1189_ = _e1001;
                                } else {
                                    phi_1189_ = _e1013;
                                }
                                let _e1022 = phi_1189_;
                                if (_e999 > _e1011) {
                                    phi_1197_ = _e999;
                                } else {
                                    phi_1197_ = _e1011;
                                }
                                let _e1028 = phi_1197_;
                                if (_e1000 > _e1012) {
                                    phi_1202_ = _e1000;
                                } else {
                                    phi_1202_ = _e1012;
                                }
                                let _e1031 = phi_1202_;
                                if (_e1001 > _e1013) {
                                    phi_1207_ = _e1001;
                                } else {
                                    phi_1207_ = _e1013;
                                }
                                let _e1034 = phi_1207_;
                                let _e1038 = core_intrinsics_maximum_number_nsz_f32_((_e1016 - _e376), (_e1019 - _e377));
                                let _e1039 = core_intrinsics_maximum_number_nsz_f32_(_e1038, (_e1022 - _e378));
                                let _e1040 = core_intrinsics_minimum_number_nsz_f32_((_e1028 + _e376), (_e1031 + _e377));
                                let _e1041 = core_intrinsics_minimum_number_nsz_f32_(_e1040, (_e1034 + _e378));
                                if (_e1039 <= _e1041) {
                                    if (_e1039 <= _e972.t) {
                                        if (_e1041 >= _e163.tmin) {
                                            let _e1053 = instances.member[(0u + _e980)].world_to_object[0u];
                                            let _e1064 = ((((_e1053.x * _e163.origin.x) + (_e1053.y * _e163.origin.y)) + (_e1053.z * _e163.origin.z)) + (_e1053.w * 1f));
                                            let _e1066 = instances.member[(0u + _e980)].world_to_object[1u];
                                            let _e1077 = ((((_e1066.x * _e163.origin.x) + (_e1066.y * _e163.origin.y)) + (_e1066.z * _e163.origin.z)) + (_e1066.w * 1f));
                                            let _e1079 = instances.member[(0u + _e980)].world_to_object[2u];
                                            let _e1090 = ((((_e1079.x * _e163.origin.x) + (_e1079.y * _e163.origin.y)) + (_e1079.z * _e163.origin.z)) + (_e1079.w * 1f));
                                            let _e1097 = instances.member[(0u + _e980)].world_to_object[0u];
                                            let _e1108 = ((((_e1097.x * _e163.direction.x) + (_e1097.y * _e163.direction.y)) + (_e1097.z * _e163.direction.z)) + (_e1097.w * 0f));
                                            let _e1110 = instances.member[(0u + _e980)].world_to_object[1u];
                                            let _e1121 = ((((_e1110.x * _e163.direction.x) + (_e1110.y * _e163.direction.y)) + (_e1110.z * _e163.direction.z)) + (_e1110.w * 0f));
                                            let _e1123 = instances.member[(0u + _e980)].world_to_object[2u];
                                            let _e1134 = ((((_e1123.x * _e163.direction.x) + (_e1123.y * _e163.direction.y)) + (_e1123.z * _e163.direction.z)) + (_e1123.w * 0f));
                                            let _e1139 = instances.member[(0u + _e980)].root;
                                            let _e1141 = instances.member[(0u + _e980)].first_triangle;
                                            let _e1142 = abs(_e1108);
                                            let _e1143 = abs(_e1121);
                                            let _e1144 = abs(_e1134);
                                            if (abs(_e1064) < 1000000000000000f) {
                                                if (abs(_e1077) < 1000000000000000f) {
                                                    phi_1339_ = (abs(_e1090) < 1000000000000000f);
                                                    phi_1340_ = false;
                                                } else {
                                                    phi_1339_ = bool();
                                                    phi_1340_ = true;
                                                }
                                                let _e1152 = phi_1339_;
                                                let _e1154 = phi_1340_;
                                                phi_1341_ = _e1152;
                                                phi_1342_ = _e1154;
                                            } else {
                                                phi_1341_ = bool();
                                                phi_1342_ = true;
                                            }
                                            let _e1156 = phi_1341_;
                                            let _e1158 = phi_1342_;
                                            if _e1158 {
                                                phi_1346_ = false;
                                            } else {
                                                phi_1346_ = _e1156;
                                            }
                                            let _e1160 = phi_1346_;
                                            if _e1160 {
                                                if (_e1142 < 1000000000000000f) {
                                                    if (_e1143 < 1000000000000000f) {
                                                        phi_1359_ = (_e1144 < 1000000000000000f);
                                                        phi_1360_ = false;
                                                    } else {
                                                        phi_1359_ = bool();
                                                        phi_1360_ = true;
                                                    }
                                                    let _e1165 = phi_1359_;
                                                    let _e1167 = phi_1360_;
                                                    phi_1361_ = _e1165;
                                                    phi_1362_ = _e1167;
                                                } else {
                                                    phi_1361_ = bool();
                                                    phi_1362_ = true;
                                                }
                                                let _e1169 = phi_1361_;
                                                let _e1171 = phi_1362_;
                                                if _e1171 {
                                                    phi_1366_ = false;
                                                } else {
                                                    phi_1366_ = _e1169;
                                                }
                                                let _e1173 = phi_1366_;
                                                if _e1173 {
                                                    if (_e1142 > 0f) {
                                                        phi_1380_ = bool();
                                                        phi_1381_ = true;
                                                    } else {
                                                        let _e1175 = (_e1143 > 0f);
                                                        if _e1175 {
                                                            phi_1379_ = bool();
                                                        } else {
                                                            phi_1379_ = (_e1144 > 0f);
                                                        }
                                                        let _e1178 = phi_1379_;
                                                        phi_1380_ = _e1178;
                                                        phi_1381_ = _e1175;
                                                    }
                                                    let _e1180 = phi_1380_;
                                                    let _e1182 = phi_1381_;
                                                    if _e1182 {
                                                        phi_1385_ = true;
                                                    } else {
                                                        phi_1385_ = _e1180;
                                                    }
                                                    let _e1184 = phi_1385_;
                                                    phi_1386_ = _e1184;
                                                    phi_1387_ = false;
                                                } else {
                                                    phi_1386_ = bool();
                                                    phi_1387_ = true;
                                                }
                                                let _e1186 = phi_1386_;
                                                let _e1188 = phi_1387_;
                                                phi_1388_ = _e1186;
                                                phi_1389_ = _e1188;
                                            } else {
                                                phi_1388_ = bool();
                                                phi_1389_ = true;
                                            }
                                            let _e1190 = phi_1388_;
                                            let _e1192 = phi_1389_;
                                            if _e1192 {
                                                phi_1393_ = false;
                                            } else {
                                                phi_1393_ = _e1190;
                                            }
                                            let _e1194 = phi_1393_;
                                            if _e1194 {
                                                let _e1195 = (_e1139 >= _e68);
                                                if _e1195 {
                                                    phi_2804_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1139 < _e68) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1201 = nodes.member[(0u + _e1139)].frame[0u];
                                                    let _e1205 = nodes.member[(0u + _e1139)].frame[1u];
                                                    let _e1209 = nodes.member[(0u + _e1139)].frame[2u];
                                                    let _e1213 = nodes.member[(0u + _e1139)].frame[0u];
                                                    let _e1217 = nodes.member[(0u + _e1139)].frame[1u];
                                                    let _e1221 = nodes.member[(0u + _e1139)].frame[2u];
                                                    let _e1225 = nodes.member[(0u + _e1139)].frame[3u];
                                                    let _e1259 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1108), abs(_e1121));
                                                    let _e1260 = core_intrinsics_maximum_number_nsz_f32_(_e1259, abs(_e1134));
                                                    let _e1261 = (_e1260 * 0.0000000000009094947f);
                                                    if (abs(_e1108) < _e1261) {
                                                        phi_1463_ = _e1261;
                                                    } else {
                                                        phi_1463_ = abs(_e1108);
                                                    }
                                                    let _e1266 = phi_1463_;
                                                    if (_e1108 < 0f) {
                                                        phi_1470_ = (-1f / _e1266);
                                                    } else {
                                                        phi_1470_ = (1f / _e1266);
                                                    }
                                                    let _e1271 = phi_1470_;
                                                    if (abs(_e1121) < _e1261) {
                                                        phi_1477_ = _e1261;
                                                    } else {
                                                        phi_1477_ = abs(_e1121);
                                                    }
                                                    let _e1276 = phi_1477_;
                                                    if (_e1121 < 0f) {
                                                        phi_1484_ = (-1f / _e1276);
                                                    } else {
                                                        phi_1484_ = (1f / _e1276);
                                                    }
                                                    let _e1281 = phi_1484_;
                                                    if (abs(_e1134) < _e1261) {
                                                        phi_1491_ = _e1261;
                                                    } else {
                                                        phi_1491_ = abs(_e1134);
                                                    }
                                                    let _e1286 = phi_1491_;
                                                    if (_e1134 < 0f) {
                                                        phi_1498_ = (-1f / _e1286);
                                                    } else {
                                                        phi_1498_ = (1f / _e1286);
                                                    }
                                                    let _e1291 = phi_1498_;
                                                    let _e1295 = abs((bitcast<f32>(_e1201) - _e1064));
                                                    let _e1296 = abs((bitcast<f32>(_e1205) - _e1077));
                                                    let _e1297 = abs((bitcast<f32>(_e1209) - _e1090));
                                                    let _e1301 = abs(((bitcast<f32>(_e1213) + (bitcast<f32>((((_e1225 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1064));
                                                    let _e1302 = abs(((bitcast<f32>(_e1217) + (bitcast<f32>((((_e1225 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1077));
                                                    let _e1303 = abs(((bitcast<f32>(_e1221) + (bitcast<f32>((((_e1225 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1090));
                                                    if (_e1295 > _e1301) {
                                                        phi_1515_ = _e1295;
                                                    } else {
                                                        phi_1515_ = _e1301;
                                                    }
                                                    let _e1306 = phi_1515_;
                                                    if (_e1296 > _e1302) {
                                                        phi_1520_ = _e1296;
                                                    } else {
                                                        phi_1520_ = _e1302;
                                                    }
                                                    let _e1309 = phi_1520_;
                                                    if (_e1297 > _e1303) {
                                                        phi_1525_ = _e1297;
                                                    } else {
                                                        phi_1525_ = _e1303;
                                                    }
                                                    let _e1312 = phi_1525_;
                                                    if (_e1306 > _e1309) {
                                                        phi_1530_ = _e1306;
                                                    } else {
                                                        phi_1530_ = _e1309;
                                                    }
                                                    let _e1315 = phi_1530_;
                                                    if (_e1315 > _e1312) {
                                                        phi_1535_ = _e1315;
                                                    } else {
                                                        phi_1535_ = _e1312;
                                                    }
                                                    let _e1318 = phi_1535_;
                                                    let _e1322 = (_e1318 * 0.0000019073486f);
                                                    let _e1323 = (abs(_e1271) * _e1322);
                                                    let _e1324 = (abs(_e1281) * _e1322);
                                                    let _e1325 = (abs(_e1291) * _e1322);
                                                    let _e1329 = (_e1318 * 0.0000009536743f);
                                                    let _e1330 = (abs(_e1271) * _e1329);
                                                    let _e1331 = (abs(_e1281) * _e1329);
                                                    let _e1332 = (abs(_e1291) * _e1329);
                                                    let _e1333 = abs(_e1108);
                                                    let _e1334 = abs(_e1121);
                                                    let _e1335 = abs(_e1134);
                                                    if (_e1333 >= _e1334) {
                                                        if (_e1333 >= _e1335) {
                                                            phi_1561_ = false;
                                                        } else {
                                                            phi_1561_ = true;
                                                        }
                                                        let _e1339 = phi_1561_;
                                                        phi_1562_ = _e1339;
                                                    } else {
                                                        phi_1562_ = true;
                                                    }
                                                    let _e1341 = phi_1562_;
                                                    if _e1341 {
                                                        if (_e1334 >= _e1335) {
                                                            phi_1570_ = 1u;
                                                        } else {
                                                            phi_1570_ = 2u;
                                                        }
                                                        let _e1344 = phi_1570_;
                                                        phi_1571_ = _e1344;
                                                    } else {
                                                        phi_1571_ = 0u;
                                                    }
                                                    let _e1346 = phi_1571_;
                                                    if (_e1346 == 0u) {
                                                        phi_1583_ = vec3<f32>(_e1121, _e1134, _e1108);
                                                    } else {
                                                        if (_e1346 == 1u) {
                                                            phi_1582_ = vec3<f32>(_e1134, _e1108, _e1121);
                                                        } else {
                                                            phi_1582_ = vec3<f32>(_e1108, _e1121, _e1134);
                                                        }
                                                        let _e1352 = phi_1582_;
                                                        phi_1583_ = _e1352;
                                                    }
                                                    let _e1354 = phi_1583_;
                                                    let _e1357 = (_e1354.x / _e1354.z);
                                                    let _e1360 = (_e1354.y / _e1354.z);
                                                    if (_e1271 < 0f) {
                                                        phi_1596_ = 0u;
                                                    } else {
                                                        phi_1596_ = 1u;
                                                    }
                                                    let _e1365 = phi_1596_;
                                                    if (_e1281 < 0f) {
                                                        phi_1601_ = 0u;
                                                    } else {
                                                        phi_1601_ = 2u;
                                                    }
                                                    let _e1368 = phi_1601_;
                                                    if (_e1291 < 0f) {
                                                        phi_1606_ = 0u;
                                                    } else {
                                                        phi_1606_ = 4u;
                                                    }
                                                    let _e1371 = phi_1606_;
                                                    let _e1373 = ((_e1365 | _e1368) | _e1371);
                                                    let _e1374 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1139, 2147483648u);
                                                    local = lt_bvh_traverse_Stack(array<u32, 32>(_e1374.first[0], _e1374.first[1], _e1374.first[2], _e1374.first[3], _e1374.first[4], _e1374.first[5], _e1374.first[6], _e1374.first[7], _e1374.first[8], _e1374.first[9], _e1374.first[10], _e1374.first[11], _e1374.first[12], _e1374.first[13], _e1374.first[14], _e1374.first[15], _e1374.first[16], _e1374.first[17], _e1374.first[18], _e1374.first[19], _e1374.first[20], _e1374.first[21], _e1374.first[22], _e1374.first[23], _e1374.first[24], _e1374.first[25], _e1374.first[26], _e1374.first[27], _e1374.first[28], _e1374.first[29], _e1374.first[30], _e1374.first[31]), array<u32, 32>(_e1374.mask[0], _e1374.mask[1], _e1374.mask[2], _e1374.mask[3], _e1374.mask[4], _e1374.mask[5], _e1374.mask[6], _e1374.mask[7], _e1374.mask[8], _e1374.mask[9], _e1374.mask[10], _e1374.mask[11], _e1374.mask[12], _e1374.mask[13], _e1374.mask[14], _e1374.mask[15], _e1374.mask[16], _e1374.mask[17], _e1374.mask[18], _e1374.mask[19], _e1374.mask[20], _e1374.mask[21], _e1374.mask[22], _e1374.mask[23], _e1374.mask[24], _e1374.mask[25], _e1374.mask[26], _e1374.mask[27], _e1374.mask[28], _e1374.mask[29], _e1374.mask[30], _e1374.mask[31]), _e1374.len, _e1374.group, _e1374.group_mask);
                                                    let _e1448 = local.group_mask;
                                                    if ((_e1448 & 4278190080u) == 0u) {
                                                        let _e1452 = local.len;
                                                        if (_e1452 == 0u) {
                                                            phi_1720_ = false;
                                                        } else {
                                                            let _e1456 = local.len;
                                                            local.len = (_e1456 - 1u);
                                                            let _e1459 = local.len;
                                                            if (_e1459 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1464 = local.first[(0u + _e1459)];
                                                            local.group = _e1464;
                                                            let _e1467 = local.len;
                                                            if (_e1467 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1472 = local.mask[(0u + _e1467)];
                                                            local.group_mask = _e1472;
                                                            phi_1720_ = true;
                                                        }
                                                        let _e1475 = phi_1720_;
                                                        phi_1721_ = _e1475;
                                                    } else {
                                                        phi_1721_ = true;
                                                    }
                                                    let _e1477 = phi_1721_;
                                                    if _e1477 {
                                                        let _e1479 = local.group_mask;
                                                        let _e1485 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1479)), 32u, (_e1479 == 0u)));
                                                        let _e1489 = local.group_mask;
                                                        let _e1503 = local.group_mask;
                                                        local.group_mask = (_e1503 & ~((1u << bitcast<u32>((_e1485 & 31u)))));
                                                        let _e1506 = local.group;
                                                        phi_1752_ = (_e1506 + countOneBits(((_e1489 & ~((4294967295u << bitcast<u32>((((_e1485 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_1752_ = 4294967295u;
                                                    }
                                                    let _e1509 = phi_1752_;
                                                    phi_1754_ = _e972;
                                                    phi_1757_ = _e1509;
                                                    loop {
                                                        let _e1511 = phi_1754_;
                                                        let _e1513 = phi_1757_;
                                                        local_9 = _e1511;
                                                        let _e1514 = (_e1513 != 4294967295u);
                                                        if _e1514 {
                                                            if (_e1513 < _e68) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1521 = nodes.member[(0u + _e1513)].frame[3u];
                                                            let _e1546 = (bitcast<f32>((((_e1521 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1271);
                                                            let _e1547 = (bitcast<f32>((((_e1521 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1281);
                                                            let _e1548 = (bitcast<f32>((((_e1521 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1291);
                                                            let _e1551 = nodes.member[(0u + _e1513)].frame[0u];
                                                            let _e1555 = nodes.member[(0u + _e1513)].frame[1u];
                                                            let _e1559 = nodes.member[(0u + _e1513)].frame[2u];
                                                            let _e1564 = ((bitcast<f32>(_e1551) - _e1064) * _e1271);
                                                            let _e1565 = ((bitcast<f32>(_e1555) - _e1077) * _e1281);
                                                            let _e1566 = ((bitcast<f32>(_e1559) - _e1090) * _e1291);
                                                            let _e1574 = nodes.member[(0u + _e1513)].x;
                                                            if (_e1271 < 0f) {
                                                                let _e1585 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1574.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1591 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1585.unnamed.root, _e1574.w), _e1585.unnamed_1);
                                                                let _e1597 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1591.unnamed, lt_bvh_traverse_Tree(_e1574.x, _e1591.unnamed_1.first_primitive));
                                                                phi_1838_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1597.unnamed, lt_bvh_traverse_Tree(_e1597.unnamed_1.root, _e1574.y));
                                                            } else {
                                                                let _e1613 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1574.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1619 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1613.unnamed.root, _e1574.y), _e1613.unnamed_1);
                                                                let _e1625 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1619.unnamed, lt_bvh_traverse_Tree(_e1574.z, _e1619.unnamed_1.first_primitive));
                                                                phi_1838_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1625.unnamed, lt_bvh_traverse_Tree(_e1625.unnamed_1.root, _e1574.w));
                                                            }
                                                            let _e1633 = phi_1838_;
                                                            let _e1643 = nodes.member[(0u + _e1513)].y;
                                                            if (_e1281 < 0f) {
                                                                let _e1654 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1643.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1660 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1654.unnamed.root, _e1643.w), _e1654.unnamed_1);
                                                                let _e1666 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1660.unnamed, lt_bvh_traverse_Tree(_e1643.x, _e1660.unnamed_1.first_primitive));
                                                                phi_1865_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1666.unnamed, lt_bvh_traverse_Tree(_e1666.unnamed_1.root, _e1643.y));
                                                            } else {
                                                                let _e1682 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1643.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1688 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1682.unnamed.root, _e1643.y), _e1682.unnamed_1);
                                                                let _e1694 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1688.unnamed, lt_bvh_traverse_Tree(_e1643.z, _e1688.unnamed_1.first_primitive));
                                                                phi_1865_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1694.unnamed, lt_bvh_traverse_Tree(_e1694.unnamed_1.root, _e1643.w));
                                                            }
                                                            let _e1702 = phi_1865_;
                                                            let _e1712 = nodes.member[(0u + _e1513)].z;
                                                            if (_e1291 < 0f) {
                                                                let _e1723 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1712.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1729 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1723.unnamed.root, _e1712.w), _e1723.unnamed_1);
                                                                let _e1735 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1729.unnamed, lt_bvh_traverse_Tree(_e1712.x, _e1729.unnamed_1.first_primitive));
                                                                phi_1892_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1735.unnamed, lt_bvh_traverse_Tree(_e1735.unnamed_1.root, _e1712.y));
                                                            } else {
                                                                let _e1751 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1712.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1757 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1751.unnamed.root, _e1712.y), _e1751.unnamed_1);
                                                                let _e1763 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1757.unnamed, lt_bvh_traverse_Tree(_e1712.z, _e1757.unnamed_1.first_primitive));
                                                                phi_1892_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1763.unnamed, lt_bvh_traverse_Tree(_e1763.unnamed_1.root, _e1712.w));
                                                            }
                                                            let _e1771 = phi_1892_;
                                                            phi_1898_ = 0u;
                                                            phi_1901_ = 0u;
                                                            loop {
                                                                let _e1781 = phi_1898_;
                                                                let _e1783 = phi_1901_;
                                                                local_5 = _e1783;
                                                                local_6 = _e1783;
                                                                local_7 = _e1783;
                                                                let _e1784 = (_e1781 < 8u);
                                                                if _e1784 {
                                                                    let _e1786 = (_e1781 >> bitcast<u32>(2i));
                                                                    let _e1787 = (_e1781 & 3u);
                                                                    if (_e1786 == 0u) {
                                                                        phi_1915_ = _e1633.unnamed.root;
                                                                    } else {
                                                                        phi_1915_ = _e1633.unnamed.first_primitive;
                                                                    }
                                                                    let _e1790 = phi_1915_;
                                                                    if (_e1786 == 0u) {
                                                                        phi_1925_ = _e1702.unnamed.root;
                                                                    } else {
                                                                        phi_1925_ = _e1702.unnamed.first_primitive;
                                                                    }
                                                                    let _e1799 = phi_1925_;
                                                                    if (_e1786 == 0u) {
                                                                        phi_1935_ = _e1771.unnamed.root;
                                                                    } else {
                                                                        phi_1935_ = _e1771.unnamed.first_primitive;
                                                                    }
                                                                    let _e1808 = phi_1935_;
                                                                    let _e1821 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1790 >> bitcast<u32>(((_e1787 * 8u) & 31u))) & 255u)) * _e1546) + (_e1564 - _e1323)), ((f32(((_e1799 >> bitcast<u32>(((_e1787 * 8u) & 31u))) & 255u)) * _e1547) + (_e1565 - _e1324)));
                                                                    let _e1822 = core_intrinsics_maximum_number_nsz_f32_(_e1821, ((f32(((_e1808 >> bitcast<u32>(((_e1787 * 8u) & 31u))) & 255u)) * _e1548) + (_e1566 - _e1325)));
                                                                    if (_e1786 == 0u) {
                                                                        phi_1953_ = _e1633.unnamed_1.root;
                                                                    } else {
                                                                        phi_1953_ = _e1633.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1825 = phi_1953_;
                                                                    if (_e1786 == 0u) {
                                                                        phi_1963_ = _e1702.unnamed_1.root;
                                                                    } else {
                                                                        phi_1963_ = _e1702.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1834 = phi_1963_;
                                                                    if (_e1786 == 0u) {
                                                                        phi_1973_ = _e1771.unnamed_1.root;
                                                                    } else {
                                                                        phi_1973_ = _e1771.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1843 = phi_1973_;
                                                                    let _e1856 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1825 >> bitcast<u32>(((_e1787 * 8u) & 31u))) & 255u)) * _e1546) + (_e1564 + _e1323)), ((f32(((_e1834 >> bitcast<u32>(((_e1787 * 8u) & 31u))) & 255u)) * _e1547) + (_e1565 + _e1324)));
                                                                    let _e1857 = core_intrinsics_minimum_number_nsz_f32_(_e1856, ((f32(((_e1843 >> bitcast<u32>(((_e1787 * 8u) & 31u))) & 255u)) * _e1548) + (_e1566 + _e1325)));
                                                                    if (_e1822 <= _e1857) {
                                                                        if (_e1822 <= _e1511.t) {
                                                                            if (_e1857 >= _e163.tmin) {
                                                                                if (_e1786 == 0u) {
                                                                                    let _e1864 = nodes.member[(0u + _e1513)].links[2u];
                                                                                    phi_2009_ = _e1864;
                                                                                } else {
                                                                                    let _e1867 = nodes.member[(0u + _e1513)].links[3u];
                                                                                    phi_2009_ = _e1867;
                                                                                }
                                                                                let _e1869 = phi_2009_;
                                                                                let _e1874 = ((_e1869 >> bitcast<u32>(((_e1787 * 8u) & 31u))) & 255u);
                                                                                let _e1875 = (_e1874 & 31u);
                                                                                if (_e1875 >= 24u) {
                                                                                    phi_2022_ = (24u + ((_e1875 - 24u) ^ _e1373));
                                                                                } else {
                                                                                    phi_2022_ = _e1875;
                                                                                }
                                                                                let _e1881 = phi_2022_;
                                                                                phi_2027_ = (_e1783 | ((_e1874 >> bitcast<u32>(5i)) << bitcast<u32>((_e1881 & 31u))));
                                                                            } else {
                                                                                phi_2027_ = _e1783;
                                                                            }
                                                                            let _e1889 = phi_2027_;
                                                                            phi_2028_ = _e1889;
                                                                        } else {
                                                                            phi_2028_ = _e1783;
                                                                        }
                                                                        let _e1891 = phi_2028_;
                                                                        phi_2029_ = _e1891;
                                                                    } else {
                                                                        phi_2029_ = _e1783;
                                                                    }
                                                                    let _e1893 = phi_2029_;
                                                                    phi_1899_ = (_e1781 + 1u);
                                                                    phi_1902_ = _e1893;
                                                                } else {
                                                                    phi_1899_ = u32();
                                                                    phi_1902_ = u32();
                                                                }
                                                                let _e1896 = phi_1899_;
                                                                let _e1898 = phi_1902_;
                                                                continue;
                                                                continuing {
                                                                    phi_1898_ = _e1896;
                                                                    phi_1901_ = _e1898;
                                                                    break if !(_e1784);
                                                                }
                                                            }
                                                            let _e1902 = nodes.member[(0u + _e1513)].links[0u];
                                                            let _e1906 = nodes.member[(0u + _e1513)].frame[3u];
                                                            let _e1910 = local_5;
                                                            if ((_e1910 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1914 = local.group_mask;
                                                                if ((_e1914 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1918 = local.len;
                                                                    if (_e1918 < 32u) {
                                                                        let _e1921 = local.group;
                                                                        let _e1923 = local.len;
                                                                        if (_e1923 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.first[(0u + _e1923)] = _e1921;
                                                                        let _e1929 = local.group_mask;
                                                                        let _e1931 = local.len;
                                                                        if (_e1931 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.mask[(0u + _e1931)] = _e1929;
                                                                        let _e1938 = local.len;
                                                                        local.len = (_e1938 + 1u);
                                                                    }
                                                                }
                                                                local.group = (_e1139 + _e1902);
                                                                let _e1942 = local_6;
                                                                local.group_mask = ((_e1942 & 4278190080u) | (_e1906 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1947 = local_7;
                                                            phi_2087_ = _e1511;
                                                            phi_2090_ = (_e1947 & 16777215u);
                                                            loop {
                                                                let _e1950 = phi_2087_;
                                                                let _e1952 = phi_2090_;
                                                                local_8 = _e1950;
                                                                if (_e1952 == 0u) {
                                                                    phi_2088_ = lt_bvh_Hit();
                                                                    phi_2091_ = u32();
                                                                    phi_2732_ = false;
                                                                } else {
                                                                    let _e1956 = nodes.member[(0u + _e1513)].links[1u];
                                                                    let _e1961 = ((_e1141 + _e1956) + select(firstTrailingBit(_e1952), 32u, (_e1952 == 0u)));
                                                                    if (_e1961 < _e71) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1968 = triangles.member[(0u + _e1961)].v0_;
                                                                    let _e1970 = (_e1968.x - _e1064);
                                                                    let _e1972 = (_e1968.y - _e1077);
                                                                    let _e1974 = (_e1968.z - _e1090);
                                                                    if (_e1346 == 0u) {
                                                                        phi_2135_ = vec3<f32>(_e1972, _e1974, _e1970);
                                                                    } else {
                                                                        if (_e1346 == 1u) {
                                                                            phi_2134_ = vec3<f32>(_e1974, _e1970, _e1972);
                                                                        } else {
                                                                            phi_2134_ = (_e1968 - vec3<f32>(_e1064, _e1077, _e1090));
                                                                        }
                                                                        let _e1982 = phi_2134_;
                                                                        phi_2135_ = _e1982;
                                                                    }
                                                                    let _e1984 = phi_2135_;
                                                                    let _e1988 = (_e1984.x - (_e1357 * _e1984.z));
                                                                    let _e1992 = (_e1984.y - (_e1360 * _e1984.z));
                                                                    let _e1994 = triangles.member[(0u + _e1961)].v1_;
                                                                    let _e1996 = (_e1994.x - _e1064);
                                                                    let _e1998 = (_e1994.y - _e1077);
                                                                    let _e2000 = (_e1994.z - _e1090);
                                                                    if (_e1346 == 0u) {
                                                                        phi_2165_ = vec3<f32>(_e1998, _e2000, _e1996);
                                                                    } else {
                                                                        if (_e1346 == 1u) {
                                                                            phi_2164_ = vec3<f32>(_e2000, _e1996, _e1998);
                                                                        } else {
                                                                            phi_2164_ = (_e1994 - vec3<f32>(_e1064, _e1077, _e1090));
                                                                        }
                                                                        let _e2008 = phi_2164_;
                                                                        phi_2165_ = _e2008;
                                                                    }
                                                                    let _e2010 = phi_2165_;
                                                                    let _e2014 = (_e2010.x - (_e1357 * _e2010.z));
                                                                    let _e2018 = (_e2010.y - (_e1360 * _e2010.z));
                                                                    let _e2020 = triangles.member[(0u + _e1961)].v2_;
                                                                    let _e2022 = (_e2020.x - _e1064);
                                                                    let _e2024 = (_e2020.y - _e1077);
                                                                    let _e2026 = (_e2020.z - _e1090);
                                                                    if (_e1346 == 0u) {
                                                                        phi_2195_ = vec3<f32>(_e2024, _e2026, _e2022);
                                                                    } else {
                                                                        if (_e1346 == 1u) {
                                                                            phi_2194_ = vec3<f32>(_e2026, _e2022, _e2024);
                                                                        } else {
                                                                            phi_2194_ = (_e2020 - vec3<f32>(_e1064, _e1077, _e1090));
                                                                        }
                                                                        let _e2034 = phi_2194_;
                                                                        phi_2195_ = _e2034;
                                                                    }
                                                                    let _e2036 = phi_2195_;
                                                                    let _e2040 = (_e2036.x - (_e1357 * _e2036.z));
                                                                    let _e2044 = (_e2036.y - (_e1360 * _e2036.z));
                                                                    if (_e2014 < _e2040) {
                                                                        phi_2214_ = true;
                                                                    } else {
                                                                        if (_e2014 == _e2040) {
                                                                            phi_2213_ = (_e2018 < _e2044);
                                                                        } else {
                                                                            phi_2213_ = false;
                                                                        }
                                                                        let _e2049 = phi_2213_;
                                                                        phi_2214_ = _e2049;
                                                                    }
                                                                    let _e2051 = phi_2214_;
                                                                    if _e2051 {
                                                                        phi_2218_ = _e2044;
                                                                        phi_2219_ = _e2040;
                                                                        phi_2220_ = _e2018;
                                                                        phi_2221_ = _e2014;
                                                                    } else {
                                                                        phi_2218_ = _e2018;
                                                                        phi_2219_ = _e2014;
                                                                        phi_2220_ = _e2044;
                                                                        phi_2221_ = _e2040;
                                                                    }
                                                                    let _e2053 = phi_2218_;
                                                                    let _e2055 = phi_2219_;
                                                                    let _e2057 = phi_2220_;
                                                                    let _e2059 = phi_2221_;
                                                                    let _e2062 = ((_e2059 * _e2053) - (_e2057 * _e2055));
                                                                    if _e2051 {
                                                                        phi_2229_ = -(_e2062);
                                                                    } else {
                                                                        phi_2229_ = _e2062;
                                                                    }
                                                                    let _e2065 = phi_2229_;
                                                                    if (_e2040 < _e1988) {
                                                                        phi_2240_ = true;
                                                                    } else {
                                                                        if (_e2040 == _e1988) {
                                                                            phi_2239_ = (_e2044 < _e1992);
                                                                        } else {
                                                                            phi_2239_ = false;
                                                                        }
                                                                        let _e2070 = phi_2239_;
                                                                        phi_2240_ = _e2070;
                                                                    }
                                                                    let _e2072 = phi_2240_;
                                                                    if _e2072 {
                                                                        phi_2244_ = _e1992;
                                                                        phi_2245_ = _e1988;
                                                                        phi_2246_ = _e2044;
                                                                        phi_2247_ = _e2040;
                                                                    } else {
                                                                        phi_2244_ = _e2044;
                                                                        phi_2245_ = _e2040;
                                                                        phi_2246_ = _e1992;
                                                                        phi_2247_ = _e1988;
                                                                    }
                                                                    let _e2074 = phi_2244_;
                                                                    let _e2076 = phi_2245_;
                                                                    let _e2078 = phi_2246_;
                                                                    let _e2080 = phi_2247_;
                                                                    let _e2083 = ((_e2080 * _e2074) - (_e2078 * _e2076));
                                                                    if _e2072 {
                                                                        phi_2255_ = -(_e2083);
                                                                    } else {
                                                                        phi_2255_ = _e2083;
                                                                    }
                                                                    let _e2086 = phi_2255_;
                                                                    if (_e1988 < _e2014) {
                                                                        phi_2266_ = true;
                                                                    } else {
                                                                        if (_e1988 == _e2014) {
                                                                            phi_2265_ = (_e1992 < _e2018);
                                                                        } else {
                                                                            phi_2265_ = false;
                                                                        }
                                                                        let _e2091 = phi_2265_;
                                                                        phi_2266_ = _e2091;
                                                                    }
                                                                    let _e2093 = phi_2266_;
                                                                    if _e2093 {
                                                                        phi_2270_ = _e2018;
                                                                        phi_2271_ = _e2014;
                                                                        phi_2272_ = _e1992;
                                                                        phi_2273_ = _e1988;
                                                                    } else {
                                                                        phi_2270_ = _e1992;
                                                                        phi_2271_ = _e1988;
                                                                        phi_2272_ = _e2018;
                                                                        phi_2273_ = _e2014;
                                                                    }
                                                                    let _e2095 = phi_2270_;
                                                                    let _e2097 = phi_2271_;
                                                                    let _e2099 = phi_2272_;
                                                                    let _e2101 = phi_2273_;
                                                                    let _e2104 = ((_e2101 * _e2095) - (_e2099 * _e2097));
                                                                    if _e2093 {
                                                                        phi_2281_ = -(_e2104);
                                                                    } else {
                                                                        phi_2281_ = _e2104;
                                                                    }
                                                                    let _e2107 = phi_2281_;
                                                                    if (_e2065 >= 0f) {
                                                                        if (_e2086 >= 0f) {
                                                                            if (_e2107 >= 0f) {
                                                                                phi_2296_ = ((_e2065 + _e2086) + _e2107);
                                                                                phi_2297_ = false;
                                                                            } else {
                                                                                phi_2296_ = f32();
                                                                                phi_2297_ = true;
                                                                            }
                                                                            let _e2114 = phi_2296_;
                                                                            let _e2116 = phi_2297_;
                                                                            phi_2298_ = _e2114;
                                                                            phi_2299_ = _e2116;
                                                                        } else {
                                                                            phi_2298_ = f32();
                                                                            phi_2299_ = true;
                                                                        }
                                                                        let _e2118 = phi_2298_;
                                                                        let _e2120 = phi_2299_;
                                                                        phi_2300_ = _e2118;
                                                                        phi_2301_ = _e2120;
                                                                    } else {
                                                                        phi_2300_ = f32();
                                                                        phi_2301_ = true;
                                                                    }
                                                                    let _e2122 = phi_2300_;
                                                                    let _e2124 = phi_2301_;
                                                                    if _e2124 {
                                                                        if (_e2065 <= 0f) {
                                                                            if (_e2086 <= 0f) {
                                                                                let _e2127 = (_e2107 <= 0f);
                                                                                if _e2127 {
                                                                                }
                                                                                phi_2319_ = ((_e2065 + _e2086) + _e2107);
                                                                                phi_2320_ = false;
                                                                                phi_2321_ = _e2127;
                                                                            } else {
                                                                                phi_2319_ = f32();
                                                                                phi_2320_ = true;
                                                                                phi_2321_ = false;
                                                                            }
                                                                            let _e2131 = phi_2319_;
                                                                            let _e2133 = phi_2320_;
                                                                            let _e2135 = phi_2321_;
                                                                            phi_2322_ = _e2131;
                                                                            phi_2323_ = _e2133;
                                                                            phi_2324_ = _e2135;
                                                                        } else {
                                                                            phi_2322_ = f32();
                                                                            phi_2323_ = true;
                                                                            phi_2324_ = false;
                                                                        }
                                                                        let _e2137 = phi_2322_;
                                                                        let _e2139 = phi_2323_;
                                                                        let _e2141 = phi_2324_;
                                                                        if _e2139 {
                                                                            phi_2328_ = false;
                                                                        } else {
                                                                            phi_2328_ = _e2141;
                                                                        }
                                                                        let _e2143 = phi_2328_;
                                                                        phi_2329_ = _e2137;
                                                                        phi_2330_ = _e2143;
                                                                    } else {
                                                                        phi_2329_ = _e2122;
                                                                        phi_2330_ = true;
                                                                    }
                                                                    let _e2145 = phi_2329_;
                                                                    let _e2147 = phi_2330_;
                                                                    if _e2147 {
                                                                        let _e2148 = (_e2145 == 0f);
                                                                        if _e2148 {
                                                                            phi_2646_ = lt_bvh_triangle_Intersection();
                                                                            phi_2647_ = false;
                                                                        } else {
                                                                            let _e2150 = triangles.member[(0u + _e1961)].v0_;
                                                                            let _e2152 = (_e2150.x - _e1064);
                                                                            let _e2154 = (_e2150.y - _e1077);
                                                                            let _e2156 = (_e2150.z - _e1090);
                                                                            if (_e1346 == 0u) {
                                                                                phi_2359_ = vec3<f32>(_e2154, _e2156, _e2152);
                                                                            } else {
                                                                                if (_e1346 == 1u) {
                                                                                    phi_2358_ = vec3<f32>(_e2156, _e2152, _e2154);
                                                                                } else {
                                                                                    phi_2358_ = (_e2150 - vec3<f32>(_e1064, _e1077, _e1090));
                                                                                }
                                                                                let _e2164 = phi_2358_;
                                                                                phi_2359_ = _e2164;
                                                                            }
                                                                            let _e2166 = phi_2359_;
                                                                            let _e2168 = triangles.member[(0u + _e1961)].v1_;
                                                                            let _e2170 = triangles.member[(0u + _e1961)].v0_;
                                                                            let _e2173 = (_e2168.x - _e2170.x);
                                                                            let _e2176 = (_e2168.y - _e2170.y);
                                                                            let _e2179 = (_e2168.z - _e2170.z);
                                                                            if (_e1346 == 0u) {
                                                                                phi_2385_ = vec3<f32>(_e2176, _e2179, _e2173);
                                                                            } else {
                                                                                if (_e1346 == 1u) {
                                                                                    phi_2384_ = vec3<f32>(_e2179, _e2173, _e2176);
                                                                                } else {
                                                                                    phi_2384_ = (_e2168 - _e2170);
                                                                                }
                                                                                let _e2186 = phi_2384_;
                                                                                phi_2385_ = _e2186;
                                                                            }
                                                                            let _e2188 = phi_2385_;
                                                                            let _e2190 = triangles.member[(0u + _e1961)].v2_;
                                                                            let _e2192 = triangles.member[(0u + _e1961)].v0_;
                                                                            let _e2195 = (_e2190.x - _e2192.x);
                                                                            let _e2198 = (_e2190.y - _e2192.y);
                                                                            let _e2201 = (_e2190.z - _e2192.z);
                                                                            if (_e1346 == 0u) {
                                                                                phi_2411_ = vec3<f32>(_e2198, _e2201, _e2195);
                                                                            } else {
                                                                                if (_e1346 == 1u) {
                                                                                    phi_2410_ = vec3<f32>(_e2201, _e2195, _e2198);
                                                                                } else {
                                                                                    phi_2410_ = (_e2190 - _e2192);
                                                                                }
                                                                                let _e2208 = phi_2410_;
                                                                                phi_2411_ = _e2208;
                                                                            }
                                                                            let _e2210 = phi_2411_;
                                                                            let _e2217 = ((_e2188.y * _e2210.z) - (_e2188.z * _e2210.y));
                                                                            let _e2224 = ((_e2188.z * _e2210.x) - (_e2188.x * _e2210.z));
                                                                            let _e2231 = ((_e2188.x * _e2210.y) - (_e2188.y * _e2210.x));
                                                                            let _e2245 = (((1f / _e1354.z) * (((_e2217 * _e2166.x) + (_e2224 * _e2166.y)) + (_e2231 * _e2166.z))) / (((_e2217 * _e1357) + (_e2224 * _e1360)) + _e2231));
                                                                            if (_e2245 > _e163.tmin) {
                                                                                if (_e2245 < _e163.tmax) {
                                                                                    let _e2249 = triangles.member[(0u + _e1961)].v0_;
                                                                                    let _e2251 = triangles.member[(0u + _e1961)].v1_;
                                                                                    if (_e2249.x < _e2251.x) {
                                                                                        phi_2467_ = _e2249.x;
                                                                                    } else {
                                                                                        phi_2467_ = _e2251.x;
                                                                                    }
                                                                                    let _e2258 = phi_2467_;
                                                                                    if (_e2249.y < _e2251.y) {
                                                                                        phi_2476_ = _e2249.y;
                                                                                    } else {
                                                                                        phi_2476_ = _e2251.y;
                                                                                    }
                                                                                    let _e2265 = phi_2476_;
                                                                                    if (_e2249.z < _e2251.z) {
                                                                                        phi_2485_ = _e2249.z;
                                                                                    } else {
                                                                                        phi_2485_ = _e2251.z;
                                                                                    }
                                                                                    let _e2272 = phi_2485_;
                                                                                    let _e2274 = triangles.member[(0u + _e1961)].v2_;
                                                                                    if (_e2258 < _e2274.x) {
                                                                                        phi_2494_ = _e2258;
                                                                                    } else {
                                                                                        phi_2494_ = _e2274.x;
                                                                                    }
                                                                                    let _e2279 = phi_2494_;
                                                                                    if (_e2265 < _e2274.y) {
                                                                                        phi_2501_ = _e2265;
                                                                                    } else {
                                                                                        phi_2501_ = _e2274.y;
                                                                                    }
                                                                                    let _e2284 = phi_2501_;
                                                                                    if (_e2272 < _e2274.z) {
                                                                                        phi_2508_ = _e2272;
                                                                                    } else {
                                                                                        phi_2508_ = _e2274.z;
                                                                                    }
                                                                                    let _e2289 = phi_2508_;
                                                                                    let _e2291 = triangles.member[(0u + _e1961)].v0_;
                                                                                    let _e2293 = triangles.member[(0u + _e1961)].v1_;
                                                                                    if (_e2291.x > _e2293.x) {
                                                                                        phi_2521_ = _e2291.x;
                                                                                    } else {
                                                                                        phi_2521_ = _e2293.x;
                                                                                    }
                                                                                    let _e2300 = phi_2521_;
                                                                                    if (_e2291.y > _e2293.y) {
                                                                                        phi_2530_ = _e2291.y;
                                                                                    } else {
                                                                                        phi_2530_ = _e2293.y;
                                                                                    }
                                                                                    let _e2307 = phi_2530_;
                                                                                    if (_e2291.z > _e2293.z) {
                                                                                        phi_2539_ = _e2291.z;
                                                                                    } else {
                                                                                        phi_2539_ = _e2293.z;
                                                                                    }
                                                                                    let _e2314 = phi_2539_;
                                                                                    let _e2316 = triangles.member[(0u + _e1961)].v2_;
                                                                                    if (_e2300 > _e2316.x) {
                                                                                        phi_2548_ = _e2300;
                                                                                    } else {
                                                                                        phi_2548_ = _e2316.x;
                                                                                    }
                                                                                    let _e2321 = phi_2548_;
                                                                                    if (_e2307 > _e2316.y) {
                                                                                        phi_2555_ = _e2307;
                                                                                    } else {
                                                                                        phi_2555_ = _e2316.y;
                                                                                    }
                                                                                    let _e2326 = phi_2555_;
                                                                                    if (_e2314 > _e2316.z) {
                                                                                        phi_2562_ = _e2314;
                                                                                    } else {
                                                                                        phi_2562_ = _e2316.z;
                                                                                    }
                                                                                    let _e2331 = phi_2562_;
                                                                                    let _e2335 = ((_e2279 - _e1064) * _e1271);
                                                                                    let _e2336 = ((_e2284 - _e1077) * _e1281);
                                                                                    let _e2337 = ((_e2289 - _e1090) * _e1291);
                                                                                    let _e2341 = ((_e2321 - _e1064) * _e1271);
                                                                                    let _e2342 = ((_e2326 - _e1077) * _e1281);
                                                                                    let _e2343 = ((_e2331 - _e1090) * _e1291);
                                                                                    if (_e2335 < _e2341) {
                                                                                        phi_2579_ = _e2335;
                                                                                    } else {
                                                                                        phi_2579_ = _e2341;
                                                                                    }
                                                                                    let _e2346 = phi_2579_;
                                                                                    if (_e2336 < _e2342) {
                                                                                        phi_2584_ = _e2336;
                                                                                    } else {
                                                                                        phi_2584_ = _e2342;
                                                                                    }
                                                                                    let _e2349 = phi_2584_;
                                                                                    if (_e2337 < _e2343) {
                                                                                        phi_2589_ = _e2337;
                                                                                    } else {
                                                                                        phi_2589_ = _e2343;
                                                                                    }
                                                                                    let _e2352 = phi_2589_;
                                                                                    if (_e2335 > _e2341) {
                                                                                        phi_2597_ = _e2335;
                                                                                    } else {
                                                                                        phi_2597_ = _e2341;
                                                                                    }
                                                                                    let _e2358 = phi_2597_;
                                                                                    if (_e2336 > _e2342) {
                                                                                        phi_2602_ = _e2336;
                                                                                    } else {
                                                                                        phi_2602_ = _e2342;
                                                                                    }
                                                                                    let _e2361 = phi_2602_;
                                                                                    if (_e2337 > _e2343) {
                                                                                        phi_2607_ = _e2337;
                                                                                    } else {
                                                                                        phi_2607_ = _e2343;
                                                                                    }
                                                                                    let _e2364 = phi_2607_;
                                                                                    let _e2368 = core_intrinsics_maximum_number_nsz_f32_((_e2346 - _e1330), (_e2349 - _e1331));
                                                                                    let _e2369 = core_intrinsics_maximum_number_nsz_f32_(_e2368, (_e2352 - _e1332));
                                                                                    let _e2370 = core_intrinsics_minimum_number_nsz_f32_((_e2358 + _e1330), (_e2361 + _e1331));
                                                                                    let _e2371 = core_intrinsics_minimum_number_nsz_f32_(_e2370, (_e2364 + _e1332));
                                                                                    if (_e2369 > _e1039) {
                                                                                        phi_2619_ = _e2369;
                                                                                    } else {
                                                                                        phi_2619_ = _e1039;
                                                                                    }
                                                                                    let _e2374 = phi_2619_;
                                                                                    if (_e2371 < _e1041) {
                                                                                        phi_2624_ = _e2371;
                                                                                    } else {
                                                                                        phi_2624_ = _e1041;
                                                                                    }
                                                                                    let _e2377 = phi_2624_;
                                                                                    if (_e2245 < _e2374) {
                                                                                        phi_2629_ = _e2374;
                                                                                    } else {
                                                                                        phi_2629_ = _e2245;
                                                                                    }
                                                                                    let _e2380 = phi_2629_;
                                                                                    if (_e2380 > _e2377) {
                                                                                        phi_2634_ = _e2377;
                                                                                    } else {
                                                                                        phi_2634_ = _e2380;
                                                                                    }
                                                                                    let _e2383 = phi_2634_;
                                                                                    phi_2639_ = lt_bvh_triangle_Intersection(_e2383, (_e2086 / _e2145), (_e2107 / _e2145), (_e2374 <= _e2377));
                                                                                    phi_2640_ = false;
                                                                                } else {
                                                                                    phi_2639_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2640_ = true;
                                                                                }
                                                                                let _e2389 = phi_2639_;
                                                                                let _e2391 = phi_2640_;
                                                                                phi_2641_ = _e2389;
                                                                                phi_2642_ = _e2391;
                                                                            } else {
                                                                                phi_2641_ = lt_bvh_triangle_Intersection();
                                                                                phi_2642_ = true;
                                                                            }
                                                                            let _e2393 = phi_2641_;
                                                                            let _e2395 = phi_2642_;
                                                                            if _e2395 {
                                                                            }
                                                                            phi_2646_ = _e2393;
                                                                            phi_2647_ = _e2395;
                                                                        }
                                                                        let _e2397 = phi_2646_;
                                                                        let _e2399 = phi_2647_;
                                                                        phi_2648_ = _e2397;
                                                                        phi_2649_ = _e2148;
                                                                        phi_2650_ = _e2399;
                                                                    } else {
                                                                        phi_2648_ = lt_bvh_triangle_Intersection();
                                                                        phi_2649_ = true;
                                                                        phi_2650_ = false;
                                                                    }
                                                                    let _e2401 = phi_2648_;
                                                                    let _e2403 = phi_2649_;
                                                                    let _e2405 = phi_2650_;
                                                                    if _e2403 {
                                                                        phi_2654_ = true;
                                                                    } else {
                                                                        phi_2654_ = _e2405;
                                                                    }
                                                                    let _e2407 = phi_2654_;
                                                                    if _e2407 {
                                                                        phi_2658_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2658_ = _e2401;
                                                                    }
                                                                    let _e2409 = phi_2658_;
                                                                    if _e2409.is_hit {
                                                                        if (_e2409.t > _e163.tmin) {
                                                                            if (_e2409.t < _e1950.t) {
                                                                                phi_2706_ = true;
                                                                            } else {
                                                                                if (_e2409.t == _e1950.t) {
                                                                                    if (_e1950.triangle != 4294967295u) {
                                                                                        if (_e1961 < _e1950.triangle) {
                                                                                            phi_2697_ = true;
                                                                                        } else {
                                                                                            if (_e1961 == _e1950.triangle) {
                                                                                                phi_2696_ = (_e980 < _e1950.instance);
                                                                                            } else {
                                                                                                phi_2696_ = false;
                                                                                            }
                                                                                            let _e2427 = phi_2696_;
                                                                                            phi_2697_ = _e2427;
                                                                                        }
                                                                                        let _e2429 = phi_2697_;
                                                                                        phi_2698_ = _e2429;
                                                                                        phi_2699_ = false;
                                                                                    } else {
                                                                                        phi_2698_ = bool();
                                                                                        phi_2699_ = true;
                                                                                    }
                                                                                    let _e2431 = phi_2698_;
                                                                                    let _e2433 = phi_2699_;
                                                                                    phi_2700_ = _e2431;
                                                                                    phi_2701_ = _e2433;
                                                                                } else {
                                                                                    phi_2700_ = bool();
                                                                                    phi_2701_ = true;
                                                                                }
                                                                                let _e2435 = phi_2700_;
                                                                                let _e2437 = phi_2701_;
                                                                                if _e2437 {
                                                                                    phi_2705_ = false;
                                                                                } else {
                                                                                    phi_2705_ = _e2435;
                                                                                }
                                                                                let _e2439 = phi_2705_;
                                                                                phi_2706_ = _e2439;
                                                                            }
                                                                            let _e2441 = phi_2706_;
                                                                            if _e2441 {
                                                                                let _e2443 = triangles.member[(0u + _e1961)].i0_;
                                                                                if ((_e2443 & 2147483648u) == 0u) {
                                                                                    phi_2720_ = true;
                                                                                } else {
                                                                                    if true {
                                                                                    }
                                                                                    phi_2720_ = true;
                                                                                }
                                                                                let _e2447 = phi_2720_;
                                                                                if _e2447 {
                                                                                    phi_2728_ = lt_bvh_Hit(_e2409.t, _e2409.u, _e2409.v, _e1961, _e980);
                                                                                } else {
                                                                                    phi_2728_ = _e1950;
                                                                                }
                                                                                let _e2453 = phi_2728_;
                                                                                phi_2729_ = _e2453;
                                                                            } else {
                                                                                phi_2729_ = _e1950;
                                                                            }
                                                                            let _e2455 = phi_2729_;
                                                                            phi_2730_ = _e2455;
                                                                        } else {
                                                                            phi_2730_ = _e1950;
                                                                        }
                                                                        let _e2457 = phi_2730_;
                                                                        phi_2731_ = _e2457;
                                                                    } else {
                                                                        phi_2731_ = _e1950;
                                                                    }
                                                                    let _e2459 = phi_2731_;
                                                                    phi_2088_ = _e2459;
                                                                    phi_2091_ = (_e1952 & (_e1952 - 1u));
                                                                    phi_2732_ = true;
                                                                }
                                                                let _e2461 = phi_2088_;
                                                                let _e2463 = phi_2091_;
                                                                let _e2465 = phi_2732_;
                                                                continue;
                                                                continuing {
                                                                    phi_2087_ = _e2461;
                                                                    phi_2090_ = _e2463;
                                                                    break if !(_e2465);
                                                                }
                                                            }
                                                            let _e2468 = local.group_mask;
                                                            if ((_e2468 & 4278190080u) == 0u) {
                                                                let _e2472 = local.len;
                                                                if (_e2472 == 0u) {
                                                                    phi_2771_ = false;
                                                                } else {
                                                                    let _e2476 = local.len;
                                                                    local.len = (_e2476 - 1u);
                                                                    let _e2479 = local.len;
                                                                    if (_e2479 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2484 = local.first[(0u + _e2479)];
                                                                    local.group = _e2484;
                                                                    let _e2487 = local.len;
                                                                    if (_e2487 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2492 = local.mask[(0u + _e2487)];
                                                                    local.group_mask = _e2492;
                                                                    phi_2771_ = true;
                                                                }
                                                                let _e2495 = phi_2771_;
                                                                phi_2772_ = _e2495;
                                                            } else {
                                                                phi_2772_ = true;
                                                            }
                                                            let _e2497 = phi_2772_;
                                                            if _e2497 {
                                                                let _e2499 = local.group_mask;
                                                                let _e2505 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2499)), 32u, (_e2499 == 0u)));
                                                                let _e2509 = local.group_mask;
                                                                let _e2523 = local.group_mask;
                                                                local.group_mask = (_e2523 & ~((1u << bitcast<u32>((_e2505 & 31u)))));
                                                                let _e2526 = local.group;
                                                                phi_2803_ = (_e2526 + countOneBits(((_e2509 & ~((4294967295u << bitcast<u32>((((_e2505 - 24u) ^ _e1373) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_2803_ = 4294967295u;
                                                            }
                                                            let _e2529 = phi_2803_;
                                                            let _e3511 = local_8;
                                                            phi_1755_ = _e3511;
                                                            phi_1758_ = _e2529;
                                                        } else {
                                                            phi_1755_ = lt_bvh_Hit();
                                                            phi_1758_ = u32();
                                                        }
                                                        let _e2531 = phi_1755_;
                                                        let _e2533 = phi_1758_;
                                                        continue;
                                                        continuing {
                                                            phi_1754_ = _e2531;
                                                            phi_1757_ = _e2533;
                                                            break if !(_e1514);
                                                        }
                                                    }
                                                    let _e3515 = local_9;
                                                    phi_2804_ = _e3515;
                                                }
                                                let _e2536 = phi_2804_;
                                                phi_2805_ = _e2536;
                                                phi_2806_ = _e1195;
                                            } else {
                                                phi_2805_ = lt_bvh_Hit();
                                                phi_2806_ = true;
                                            }
                                            let _e2538 = phi_2805_;
                                            let _e2540 = phi_2806_;
                                            if _e2540 {
                                                phi_2810_ = _e972;
                                            } else {
                                                phi_2810_ = _e2538;
                                            }
                                            let _e2542 = phi_2810_;
                                            phi_2811_ = _e2542;
                                        } else {
                                            phi_2811_ = _e972;
                                        }
                                        let _e2544 = phi_2811_;
                                        phi_2812_ = _e2544;
                                    } else {
                                        phi_2812_ = _e972;
                                    }
                                    let _e2546 = phi_2812_;
                                    phi_2813_ = _e2546;
                                } else {
                                    phi_2813_ = _e972;
                                }
                                let _e2548 = phi_2813_;
                                phi_1122_ = (_e970 & (_e970 - 1u));
                                phi_1125_ = _e2548;
                                phi_2814_ = true;
                            }
                            let _e2550 = phi_1122_;
                            let _e2552 = phi_1125_;
                            let _e2554 = phi_2814_;
                            continue;
                            continuing {
                                phi_1121_ = _e2550;
                                phi_1124_ = _e2552;
                                break if !(_e2554);
                            }
                        }
                        let _e2557 = local_1.group_mask;
                        if ((_e2557 & 4278190080u) == 0u) {
                            let _e2561 = local_1.len;
                            if (_e2561 == 0u) {
                                phi_2853_ = false;
                            } else {
                                let _e2565 = local_1.len;
                                local_1.len = (_e2565 - 1u);
                                let _e2568 = local_1.len;
                                if (_e2568 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2573 = local_1.first[(0u + _e2568)];
                                local_1.group = _e2573;
                                let _e2576 = local_1.len;
                                if (_e2576 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2581 = local_1.mask[(0u + _e2576)];
                                local_1.group_mask = _e2581;
                                phi_2853_ = true;
                            }
                            let _e2584 = phi_2853_;
                            phi_2854_ = _e2584;
                        } else {
                            phi_2854_ = true;
                        }
                        let _e2586 = phi_2854_;
                        if _e2586 {
                            let _e2588 = local_1.group_mask;
                            let _e2594 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2588)), 32u, (_e2588 == 0u)));
                            let _e2598 = local_1.group_mask;
                            let _e2612 = local_1.group_mask;
                            local_1.group_mask = (_e2612 & ~((1u << bitcast<u32>((_e2594 & 31u)))));
                            let _e2615 = local_1.group;
                            phi_2885_ = (_e2615 + countOneBits(((_e2598 & ~((4294967295u << bitcast<u32>((((_e2594 - 24u) ^ _e389) & 31u))))) & 255u)));
                        } else {
                            phi_2885_ = 4294967295u;
                        }
                        let _e2618 = phi_2885_;
                        phi_785_ = _e2618;
                        let _e3531 = local_10;
                        phi_788_ = _e3531;
                    } else {
                        phi_785_ = u32();
                        phi_788_ = lt_bvh_Hit();
                    }
                    let _e2620 = phi_785_;
                    let _e2622 = phi_788_;
                    continue;
                    continuing {
                        phi_784_ = _e2620;
                        phi_787_ = _e2622;
                        break if !(_e530);
                    }
                }
                let _e3534 = local_11;
                phi_2886_ = _e3534;
            }
            let _e2625 = phi_2886_;
            phi_2887_ = _e2625;
            phi_2888_ = _e227;
        } else {
            phi_2887_ = lt_bvh_Hit();
            phi_2888_ = true;
        }
        let _e2627 = phi_2887_;
        let _e2629 = phi_2888_;
        if _e2629 {
            phi_2892_ = _e165;
        } else {
            phi_2892_ = _e2627;
        }
        let _e2631 = phi_2892_;
        if (_e2631.triangle != 4294967295u) {
            let _e2637 = ((1f - _e2631.u) - _e2631.v);
            if (_e2631.triangle < _e71) {
            } else {
                return;
            }
            let _e2643 = triangles.member[(0u + _e2631.triangle)];
            if (_e2631.instance < _e83) {
            } else {
                return;
            }
            let _e2654 = instances.member[(0u + _e2631.instance)].object_to_world[0u];
            let _e2665 = ((((_e2654.x * _e2643.v0_.x) + (_e2654.y * _e2643.v0_.y)) + (_e2654.z * _e2643.v0_.z)) + (_e2654.w * 1f));
            let _e2667 = instances.member[(0u + _e2631.instance)].object_to_world[1u];
            let _e2678 = ((((_e2667.x * _e2643.v0_.x) + (_e2667.y * _e2643.v0_.y)) + (_e2667.z * _e2643.v0_.z)) + (_e2667.w * 1f));
            let _e2680 = instances.member[(0u + _e2631.instance)].object_to_world[2u];
            let _e2691 = ((((_e2680.x * _e2643.v0_.x) + (_e2680.y * _e2643.v0_.y)) + (_e2680.z * _e2643.v0_.z)) + (_e2680.w * 1f));
            let _e2698 = instances.member[(0u + _e2631.instance)].object_to_world[0u];
            let _e2709 = ((((_e2698.x * _e2643.v1_.x) + (_e2698.y * _e2643.v1_.y)) + (_e2698.z * _e2643.v1_.z)) + (_e2698.w * 1f));
            let _e2711 = instances.member[(0u + _e2631.instance)].object_to_world[1u];
            let _e2722 = ((((_e2711.x * _e2643.v1_.x) + (_e2711.y * _e2643.v1_.y)) + (_e2711.z * _e2643.v1_.z)) + (_e2711.w * 1f));
            let _e2724 = instances.member[(0u + _e2631.instance)].object_to_world[2u];
            let _e2735 = ((((_e2724.x * _e2643.v1_.x) + (_e2724.y * _e2643.v1_.y)) + (_e2724.z * _e2643.v1_.z)) + (_e2724.w * 1f));
            let _e2742 = instances.member[(0u + _e2631.instance)].object_to_world[0u];
            let _e2753 = ((((_e2742.x * _e2643.v2_.x) + (_e2742.y * _e2643.v2_.y)) + (_e2742.z * _e2643.v2_.z)) + (_e2742.w * 1f));
            let _e2755 = instances.member[(0u + _e2631.instance)].object_to_world[1u];
            let _e2766 = ((((_e2755.x * _e2643.v2_.x) + (_e2755.y * _e2643.v2_.y)) + (_e2755.z * _e2643.v2_.z)) + (_e2755.w * 1f));
            let _e2768 = instances.member[(0u + _e2631.instance)].object_to_world[2u];
            let _e2779 = ((((_e2768.x * _e2643.v2_.x) + (_e2768.y * _e2643.v2_.y)) + (_e2768.z * _e2643.v2_.z)) + (_e2768.w * 1f));
            let _e2792 = (((_e2665 * _e2637) + (_e2709 * _e2631.u)) + (_e2753 * _e2631.v));
            let _e2793 = (((_e2678 * _e2637) + (_e2722 * _e2631.u)) + (_e2766 * _e2631.v));
            let _e2794 = (((_e2691 * _e2637) + (_e2735 * _e2631.u)) + (_e2779 * _e2631.v));
            let _e2796 = abs(_e2665);
            let _e2797 = abs(_e2678);
            let _e2798 = abs(_e2691);
            let _e2799 = abs(_e2709);
            let _e2800 = abs(_e2722);
            let _e2801 = abs(_e2735);
            if (_e2796 > _e2799) {
                phi_3080_ = _e2796;
            } else {
                phi_3080_ = _e2799;
            }
            let _e2804 = phi_3080_;
            if (_e2797 > _e2800) {
                phi_3085_ = _e2797;
            } else {
                phi_3085_ = _e2800;
            }
            let _e2807 = phi_3085_;
            if (_e2798 > _e2801) {
                phi_3090_ = _e2798;
            } else {
                phi_3090_ = _e2801;
            }
            let _e2810 = phi_3090_;
            let _e2811 = abs(_e2753);
            let _e2812 = abs(_e2766);
            let _e2813 = abs(_e2779);
            if (_e2804 > _e2811) {
                phi_3098_ = _e2804;
            } else {
                phi_3098_ = _e2811;
            }
            let _e2816 = phi_3098_;
            if (_e2807 > _e2812) {
                phi_3103_ = _e2807;
            } else {
                phi_3103_ = _e2812;
            }
            let _e2819 = phi_3103_;
            if (_e2810 > _e2813) {
                phi_3108_ = _e2810;
            } else {
                phi_3108_ = _e2813;
            }
            let _e2822 = phi_3108_;
            let _e2823 = (_e2709 - _e2665);
            let _e2824 = (_e2722 - _e2678);
            let _e2825 = (_e2735 - _e2691);
            let _e2826 = (_e2753 - _e2665);
            let _e2827 = (_e2766 - _e2678);
            let _e2828 = (_e2779 - _e2691);
            let _e2832 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2824), abs(_e2825));
            let _e2833 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2823), _e2832);
            let _e2834 = (_e2823 / _e2833);
            let _e2835 = (_e2824 / _e2833);
            let _e2836 = (_e2825 / _e2833);
            let _e2840 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2827), abs(_e2828));
            let _e2841 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2826), _e2840);
            let _e2842 = (_e2826 / _e2841);
            let _e2843 = (_e2827 / _e2841);
            let _e2844 = (_e2828 / _e2841);
            let _e2847 = ((_e2835 * _e2844) - (_e2843 * _e2836));
            let _e2850 = ((_e2836 * _e2842) - (_e2844 * _e2834));
            let _e2853 = ((_e2834 * _e2843) - (_e2842 * _e2835));
            let _e2855 = p.member.eye;
            let _e2868 = (1f / sqrt((((_e2847 * _e2847) + (_e2850 * _e2850)) + (_e2853 * _e2853))));
            let _e2869 = (_e2847 * _e2868);
            let _e2870 = (_e2850 * _e2868);
            let _e2871 = (_e2853 * _e2868);
            if ((((_e2869 * (_e2855.x - _e2792)) + (_e2870 * (_e2855.y - _e2793))) + (_e2871 * (_e2855.z - _e2794))) < 0f) {
                phi_3172_ = vec3<f32>(-(_e2869), -(_e2870), -(_e2871));
            } else {
                phi_3172_ = vec3<f32>(_e2869, _e2870, _e2871);
            }
            let _e2884 = phi_3172_;
            if (_e2631.triangle < _e71) {
            } else {
                return;
            }
            let _e2889 = triangles.member[(0u + _e2631.triangle)];
            let _e2891 = (_e2889.i0_ & 2147483647u);
            if (_e2891 < _e74) {
            } else {
                return;
            }
            let _e2897 = vertices.member[(0u + _e2891)];
            if (_e2889.i1_ < _e74) {
            } else {
                return;
            }
            let _e2901 = vertices.member[(0u + _e2889.i1_)];
            if (_e2889.i2_ < _e74) {
            } else {
                return;
            }
            let _e2905 = vertices.member[(0u + _e2889.i2_)];
            let _e2906 = array<abi_Vertex, 3>(_e2897, _e2901, _e2905);
            if (_e2906[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e2912 = materials.member[(0u + _e2906[0].material)];
            let _e2929 = (1f / 255f);
            let _e2948 = (1f / 255f);
            let _e2970 = (1f / 255f);
            let _e2983 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e2637, _e2631.u, _e2631.v));
            let _e2985 = ((_e2912.base_color.x * ((((f32((_e2906[0].color & 255u)) * _e2929) * _e2637) + ((f32((_e2906[1].color & 255u)) * _e2948) * _e2631.u)) + ((f32((_e2906[2].color & 255u)) * _e2970) * _e2631.v))) * _e2983.x);
            let _e2987 = ((_e2912.base_color.y * ((((f32(((_e2906[0].color >> bitcast<u32>(8i)) & 255u)) * _e2929) * _e2637) + ((f32(((_e2906[1].color >> bitcast<u32>(8i)) & 255u)) * _e2948) * _e2631.u)) + ((f32(((_e2906[2].color >> bitcast<u32>(8i)) & 255u)) * _e2970) * _e2631.v))) * _e2983.y);
            let _e2989 = ((_e2912.base_color.z * ((((f32(((_e2906[0].color >> bitcast<u32>(16i)) & 255u)) * _e2929) * _e2637) + ((f32(((_e2906[1].color >> bitcast<u32>(16i)) & 255u)) * _e2948) * _e2631.u)) + ((f32(((_e2906[2].color >> bitcast<u32>(16i)) & 255u)) * _e2970) * _e2631.v))) * _e2983.z);
            let _e2990 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2819, _e2822);
            let _e2991 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2816, _e2990);
            if ((_e2912.flags & 2u) == 0u) {
                phi_3293_ = 0u;
            } else {
                phi_3293_ = 1u;
            }
            let _e2996 = phi_3293_;
            if (_e2906[0].normal == 2147516416u) {
                phi_3523_ = _e2884;
            } else {
                let _e3009 = (f32((bitcast<i32>((_e2906[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3015 = (f32((bitcast<i32>(_e2906[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3019 = ((1f - abs(_e3009)) - abs(_e3015));
                if (_e3019 < 0f) {
                    phi_3320_ = -(_e3019);
                } else {
                    phi_3320_ = 0f;
                }
                let _e3023 = phi_3320_;
                if (_e3009 < 0f) {
                    phi_3327_ = (_e3009 + _e3023);
                } else {
                    phi_3327_ = (_e3009 - _e3023);
                }
                let _e3028 = phi_3327_;
                if (_e3015 < 0f) {
                    phi_3334_ = (_e3015 + _e3023);
                } else {
                    phi_3334_ = (_e3015 - _e3023);
                }
                let _e3033 = phi_3334_;
                let _e3040 = (1f / sqrt((((_e3028 * _e3028) + (_e3033 * _e3033)) + (_e3019 * _e3019))));
                let _e3056 = (f32((bitcast<i32>((_e2906[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3062 = (f32((bitcast<i32>(_e2906[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3066 = ((1f - abs(_e3056)) - abs(_e3062));
                if (_e3066 < 0f) {
                    phi_3369_ = -(_e3066);
                } else {
                    phi_3369_ = 0f;
                }
                let _e3070 = phi_3369_;
                if (_e3056 < 0f) {
                    phi_3376_ = (_e3056 + _e3070);
                } else {
                    phi_3376_ = (_e3056 - _e3070);
                }
                let _e3075 = phi_3376_;
                if (_e3062 < 0f) {
                    phi_3383_ = (_e3062 + _e3070);
                } else {
                    phi_3383_ = (_e3062 - _e3070);
                }
                let _e3080 = phi_3383_;
                let _e3087 = (1f / sqrt((((_e3075 * _e3075) + (_e3080 * _e3080)) + (_e3066 * _e3066))));
                let _e3106 = (f32((bitcast<i32>((_e2906[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3112 = (f32((bitcast<i32>(_e2906[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3116 = ((1f - abs(_e3106)) - abs(_e3112));
                if (_e3116 < 0f) {
                    phi_3421_ = -(_e3116);
                } else {
                    phi_3421_ = 0f;
                }
                let _e3120 = phi_3421_;
                if (_e3106 < 0f) {
                    phi_3428_ = (_e3106 + _e3120);
                } else {
                    phi_3428_ = (_e3106 - _e3120);
                }
                let _e3125 = phi_3428_;
                if (_e3112 < 0f) {
                    phi_3435_ = (_e3112 + _e3120);
                } else {
                    phi_3435_ = (_e3112 - _e3120);
                }
                let _e3130 = phi_3435_;
                let _e3137 = (1f / sqrt((((_e3125 * _e3125) + (_e3130 * _e3130)) + (_e3116 * _e3116))));
                let _e3144 = ((((_e3028 * _e3040) * _e2637) + ((_e3075 * _e3087) * _e2631.u)) + ((_e3125 * _e3137) * _e2631.v));
                let _e3145 = ((((_e3033 * _e3040) * _e2637) + ((_e3080 * _e3087) * _e2631.u)) + ((_e3130 * _e3137) * _e2631.v));
                let _e3146 = ((((_e3019 * _e3040) * _e2637) + ((_e3066 * _e3087) * _e2631.u)) + ((_e3116 * _e3137) * _e2631.v));
                if (_e2631.instance < _e83) {
                } else {
                    return;
                }
                let _e3153 = instances.member[(0u + _e2631.instance)].world_to_object[0u];
                let _e3162 = instances.member[(0u + _e2631.instance)].world_to_object[1u];
                let _e3174 = instances.member[(0u + _e2631.instance)].world_to_object[2u];
                let _e3181 = (((_e3153.x * _e3144) + (_e3162.x * _e3145)) + (_e3174.x * _e3146));
                let _e3182 = (((_e3153.y * _e3144) + (_e3162.y * _e3145)) + (_e3174.y * _e3146));
                let _e3183 = (((_e3153.z * _e3144) + (_e3162.z * _e3145)) + (_e3174.z * _e3146));
                let _e3189 = sqrt((((_e3181 * _e3181) + (_e3182 * _e3182)) + (_e3183 * _e3183)));
                if (_e3189 > 0f) {
                    let _e3191 = (_e3181 / _e3189);
                    let _e3192 = (_e3182 / _e3189);
                    let _e3193 = (_e3183 / _e3189);
                    if ((((_e3191 * _e2884.x) + (_e3192 * _e2884.y)) + (_e3193 * _e2884.z)) < 0f) {
                        phi_3521_ = vec3<f32>(-(_e3191), -(_e3192), -(_e3193));
                    } else {
                        phi_3521_ = vec3<f32>(_e3191, _e3192, _e3193);
                    }
                    let _e3209 = phi_3521_;
                    phi_3522_ = _e3209;
                } else {
                    phi_3522_ = _e2884;
                }
                let _e3211 = phi_3522_;
                phi_3523_ = _e3211;
            }
            let _e3213 = phi_3523_;
            if (_e2985 > 0f) {
                if (_e2985 < 1f) {
                    phi_3532_ = _e2985;
                } else {
                    phi_3532_ = 1f;
                }
                let _e3217 = phi_3532_;
                phi_3533_ = _e3217;
            } else {
                phi_3533_ = 0f;
            }
            let _e3219 = phi_3533_;
            if (_e2987 > 0f) {
                if (_e2987 < 1f) {
                    phi_3543_ = _e2987;
                } else {
                    phi_3543_ = 1f;
                }
                let _e3224 = phi_3543_;
                phi_3544_ = _e3224;
            } else {
                phi_3544_ = 0f;
            }
            let _e3226 = phi_3544_;
            if (_e2989 > 0f) {
                if (_e2989 < 1f) {
                    phi_3554_ = _e2989;
                } else {
                    phi_3554_ = 1f;
                }
                let _e3231 = phi_3554_;
                phi_3555_ = _e3231;
            } else {
                phi_3555_ = 0f;
            }
            let _e3233 = phi_3555_;
            let _e3236 = ((sqrt(_e3219) * 255f) + 0.5f);
            let _e3245 = ((sqrt(_e3226) * 255f) + 0.5f);
            let _e3257 = ((sqrt(_e3233) * 255f) + 0.5f);
            phi_3590_ = abi_Sample(vec3<f32>(_e2792, _e2793, _e2794), _e2991, _e2884, _e2996, _e3213, ((select(select(u32(_e3236), 0u, (_e3236 < bitcast<f32>(0u))), 4294967295u, (_e3236 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3245), 0u, (_e3245 < bitcast<f32>(0u))), 4294967295u, (_e3245 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3257), 0u, (_e3257 < bitcast<f32>(0u))), 4294967295u, (_e3257 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_3590_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3271 = phi_3590_;
        if (_e89.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e89.first_primitive)] = _e3271;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
