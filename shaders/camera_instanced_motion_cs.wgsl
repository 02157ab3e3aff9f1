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
        let _e77 = phi_205_;
        let _e79 = phi_206_;
        phi_207_ = _e77;
        phi_208_ = _e79;
    } else {
        phi_207_ = lt_mask_LightPlace();
        phi_208_ = true;
    }
    let _e81 = phi_207_;
    let _e83 = phi_208_;
    if _e83 {
        phi_213_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_213_ = _e81;
    }
    let _e88 = phi_213_;
    return lt_mask_LightPlace(_e88.word, _e88.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_228_: bool;
    var phi_232_: f32;

    if (param_3 != param_3) {
        phi_228_ = true;
    } else {
        let _e67 = (param_4 >= param_3);
        if _e67 {
        }
        phi_228_ = _e67;
    }
    let _e69 = phi_228_;
    if _e69 {
        phi_232_ = param_4;
    } else {
        phi_232_ = param_3;
    }
    let _e71 = phi_232_;
    return _e71;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_244_: bool;
    var phi_248_: f32;

    if (param_5 != param_5) {
        phi_244_ = true;
    } else {
        let _e67 = (param_6 <= param_5);
        if _e67 {
        }
        phi_244_ = _e67;
    }
    let _e69 = phi_244_;
    if _e69 {
        phi_248_ = param_6;
    } else {
        phi_248_ = param_5;
    }
    let _e71 = phi_248_;
    return _e71;
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
    let _e68 = phi_260_;
    return _e68;
}

fn _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(param_11: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(1f, 1f, 1f);
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: lt_bvh_traverse_Stack;
    var phi_405_: bool;
    var phi_406_: bool;
    var phi_407_: bool;
    var phi_408_: bool;
    var phi_412_: bool;
    var phi_425_: bool;
    var phi_426_: bool;
    var phi_427_: bool;
    var phi_428_: bool;
    var phi_432_: bool;
    var phi_445_: bool;
    var phi_446_: bool;
    var phi_447_: bool;
    var phi_451_: bool;
    var phi_452_: bool;
    var phi_453_: bool;
    var phi_454_: bool;
    var phi_455_: bool;
    var phi_459_: bool;
    var phi_535_: f32;
    var phi_542_: f32;
    var phi_550_: f32;
    var phi_557_: f32;
    var phi_565_: f32;
    var phi_572_: f32;
    var phi_595_: f32;
    var phi_600_: f32;
    var phi_605_: f32;
    var phi_610_: f32;
    var phi_615_: f32;
    var phi_634_: u32;
    var phi_639_: u32;
    var phi_644_: u32;
    var phi_758_: bool;
    var phi_759_: bool;
    var phi_790_: u32;
    var phi_792_: u32;
    var phi_795_: lt_bvh_Hit;
    var phi_880_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_907_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_934_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_940_: u32;
    var phi_943_: u32;
    var phi_957_: u32;
    var phi_967_: u32;
    var phi_977_: u32;
    var phi_995_: u32;
    var phi_1005_: u32;
    var phi_1015_: u32;
    var phi_1051_: u32;
    var phi_1064_: u32;
    var phi_1069_: u32;
    var phi_1070_: u32;
    var phi_1071_: u32;
    var phi_941_: u32;
    var phi_944_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1129_: u32;
    var phi_1132_: lt_bvh_Hit;
    var phi_1187_: f32;
    var phi_1192_: f32;
    var phi_1197_: f32;
    var phi_1205_: f32;
    var phi_1210_: f32;
    var phi_1215_: f32;
    var phi_1347_: bool;
    var phi_1348_: bool;
    var phi_1349_: bool;
    var phi_1350_: bool;
    var phi_1354_: bool;
    var phi_1367_: bool;
    var phi_1368_: bool;
    var phi_1369_: bool;
    var phi_1370_: bool;
    var phi_1374_: bool;
    var phi_1387_: bool;
    var phi_1388_: bool;
    var phi_1389_: bool;
    var phi_1393_: bool;
    var phi_1394_: bool;
    var phi_1395_: bool;
    var phi_1396_: bool;
    var phi_1397_: bool;
    var phi_1401_: bool;
    var phi_1471_: f32;
    var phi_1478_: f32;
    var phi_1485_: f32;
    var phi_1492_: f32;
    var phi_1499_: f32;
    var phi_1506_: f32;
    var phi_1523_: f32;
    var phi_1528_: f32;
    var phi_1533_: f32;
    var phi_1538_: f32;
    var phi_1543_: f32;
    var phi_1569_: bool;
    var phi_1570_: bool;
    var phi_1578_: u32;
    var phi_1579_: u32;
    var phi_1590_: vec3<f32>;
    var phi_1591_: vec3<f32>;
    var phi_1604_: u32;
    var phi_1609_: u32;
    var phi_1614_: u32;
    var phi_1728_: bool;
    var phi_1729_: bool;
    var phi_1760_: u32;
    var phi_1762_: lt_bvh_Hit;
    var phi_1765_: u32;
    var phi_1846_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1873_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1900_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1906_: u32;
    var phi_1909_: u32;
    var phi_1923_: u32;
    var phi_1933_: u32;
    var phi_1943_: u32;
    var phi_1961_: u32;
    var phi_1971_: u32;
    var phi_1981_: u32;
    var phi_2017_: u32;
    var phi_2030_: u32;
    var phi_2035_: u32;
    var phi_2036_: u32;
    var phi_2037_: u32;
    var phi_1907_: u32;
    var phi_1910_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_2095_: lt_bvh_Hit;
    var phi_2098_: u32;
    var phi_2142_: vec3<f32>;
    var phi_2143_: vec3<f32>;
    var phi_2172_: vec3<f32>;
    var phi_2173_: vec3<f32>;
    var phi_2202_: vec3<f32>;
    var phi_2203_: vec3<f32>;
    var phi_2221_: bool;
    var phi_2222_: bool;
    var phi_2226_: f32;
    var phi_2227_: f32;
    var phi_2228_: f32;
    var phi_2229_: f32;
    var phi_2237_: f32;
    var phi_2247_: bool;
    var phi_2248_: bool;
    var phi_2252_: f32;
    var phi_2253_: f32;
    var phi_2254_: f32;
    var phi_2255_: f32;
    var phi_2263_: f32;
    var phi_2273_: bool;
    var phi_2274_: bool;
    var phi_2278_: f32;
    var phi_2279_: f32;
    var phi_2280_: f32;
    var phi_2281_: f32;
    var phi_2289_: f32;
    var phi_2304_: f32;
    var phi_2305_: bool;
    var phi_2306_: f32;
    var phi_2307_: bool;
    var phi_2308_: f32;
    var phi_2309_: bool;
    var phi_2327_: f32;
    var phi_2328_: bool;
    var phi_2329_: bool;
    var phi_2330_: f32;
    var phi_2331_: bool;
    var phi_2332_: bool;
    var phi_2336_: bool;
    var phi_2337_: f32;
    var phi_2338_: bool;
    var phi_2366_: vec3<f32>;
    var phi_2367_: vec3<f32>;
    var phi_2392_: vec3<f32>;
    var phi_2393_: vec3<f32>;
    var phi_2418_: vec3<f32>;
    var phi_2419_: vec3<f32>;
    var phi_2475_: f32;
    var phi_2484_: f32;
    var phi_2493_: f32;
    var phi_2502_: f32;
    var phi_2509_: f32;
    var phi_2516_: f32;
    var phi_2529_: f32;
    var phi_2538_: f32;
    var phi_2547_: f32;
    var phi_2556_: f32;
    var phi_2563_: f32;
    var phi_2570_: f32;
    var phi_2587_: f32;
    var phi_2592_: f32;
    var phi_2597_: f32;
    var phi_2605_: f32;
    var phi_2610_: f32;
    var phi_2615_: f32;
    var phi_2627_: f32;
    var phi_2632_: f32;
    var phi_2637_: f32;
    var phi_2642_: f32;
    var phi_2647_: lt_bvh_triangle_Intersection;
    var phi_2648_: bool;
    var phi_2649_: lt_bvh_triangle_Intersection;
    var phi_2650_: bool;
    var phi_2654_: lt_bvh_triangle_Intersection;
    var phi_2655_: bool;
    var phi_2656_: lt_bvh_triangle_Intersection;
    var phi_2657_: bool;
    var phi_2658_: bool;
    var phi_2662_: bool;
    var phi_2666_: lt_bvh_triangle_Intersection;
    var phi_2704_: bool;
    var phi_2705_: bool;
    var phi_2706_: bool;
    var phi_2707_: bool;
    var phi_2708_: bool;
    var phi_2709_: bool;
    var phi_2713_: bool;
    var phi_2714_: bool;
    var phi_2728_: bool;
    var phi_2736_: lt_bvh_Hit;
    var phi_2737_: lt_bvh_Hit;
    var phi_2738_: lt_bvh_Hit;
    var phi_2739_: lt_bvh_Hit;
    var phi_2096_: lt_bvh_Hit;
    var phi_2099_: u32;
    var phi_2740_: bool;
    var phi_2779_: bool;
    var phi_2780_: bool;
    var phi_2811_: u32;
    var phi_1763_: lt_bvh_Hit;
    var phi_1766_: u32;
    var phi_2812_: lt_bvh_Hit;
    var phi_2813_: lt_bvh_Hit;
    var phi_2814_: bool;
    var phi_2818_: lt_bvh_Hit;
    var phi_2819_: lt_bvh_Hit;
    var phi_2820_: lt_bvh_Hit;
    var phi_2821_: lt_bvh_Hit;
    var phi_1130_: u32;
    var phi_1133_: lt_bvh_Hit;
    var phi_2822_: bool;
    var phi_2861_: bool;
    var phi_2862_: bool;
    var phi_2893_: u32;
    var phi_793_: u32;
    var phi_796_: lt_bvh_Hit;
    var phi_2894_: lt_bvh_Hit;
    var phi_2895_: lt_bvh_Hit;
    var phi_2896_: bool;
    var phi_2900_: lt_bvh_Hit;
    var phi_3088_: f32;
    var phi_3093_: f32;
    var phi_3098_: f32;
    var phi_3106_: f32;
    var phi_3111_: f32;
    var phi_3116_: f32;
    var phi_3180_: vec3<f32>;
    var phi_3301_: u32;
    var phi_3328_: f32;
    var phi_3335_: f32;
    var phi_3342_: f32;
    var phi_3377_: f32;
    var phi_3384_: f32;
    var phi_3391_: f32;
    var phi_3429_: f32;
    var phi_3436_: f32;
    var phi_3443_: f32;
    var phi_3529_: vec3<f32>;
    var phi_3530_: vec3<f32>;
    var phi_3531_: vec3<f32>;
    var phi_3540_: f32;
    var phi_3541_: f32;
    var phi_3551_: f32;
    var phi_3552_: f32;
    var phi_3562_: f32;
    var phi_3563_: f32;
    var phi_3598_: abi_Sample;
    var phi_3821_: vec3<f32>;
    var local_8: lt_bvh_Hit;
    var local_9: lt_bvh_Hit;
    var local_10: lt_bvh_Hit;
    var local_11: lt_bvh_Hit;

    let _e66 = id_1;
    let _e70 = arrayLength((&nodes.member));
    let _e73 = arrayLength((&triangles.member));
    let _e76 = arrayLength((&vertices.member));
    let _e85 = arrayLength((&instances.member));
    let _e88 = arrayLength((&before.member));
    let _e94 = p.member.size[0u];
    let _e96 = p.member.size[1u];
    let _e97 = lt_shaders_entry_pixel_index(_e66, _e94, _e96);
    if (bitcast<i32>(_e97.word) != 0i) {
        let _e103 = p.member.root;
        let _e107 = p.member.eye;
        let _e110 = p.member.grid[0u];
        let _e112 = p.member.grid[1u];
        let _e131 = p.member.size[0u];
        let _e135 = ((((f32(_e66.x) + ((f32((_e66.y & (_e112 - 1u))) + 0.5f) / f32(_e112))) / f32(_e131)) * 2f) - 1f);
        let _e138 = p.member.size[1u];
        let _e142 = (1f - (((f32(_e66.y) + ((f32((_e66.x & (_e110 - 1u))) + 0.5f) / f32(_e110))) / f32(_e138)) * 2f));
        let _e144 = p.member.forward;
        let _e146 = p.member.right;
        let _e160 = p.member.up;
        let _e171 = _lt_bvh_ray_Ray_new(_e107, vec3<f32>(((_e144.x + (_e146.x * _e135)) + (_e160.x * _e142)), ((_e144.y + (_e146.y * _e135)) + (_e160.y * _e142)), ((_e144.z + (_e146.z * _e135)) + (_e160.z * _e142))));
        let _e173 = lt_bvh_Hit(_e171.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e176 = abs(_e171.direction.x);
        let _e178 = abs(_e171.direction.y);
        let _e180 = abs(_e171.direction.z);
        if (abs(_e171.origin.x) < 1000000000000000f) {
            if (abs(_e171.origin.y) < 1000000000000000f) {
                phi_405_ = (abs(_e171.origin.z) < 1000000000000000f);
                phi_406_ = false;
            } else {
                phi_405_ = bool();
                phi_406_ = true;
            }
            let _e192 = phi_405_;
            let _e194 = phi_406_;
            phi_407_ = _e192;
            phi_408_ = _e194;
        } else {
            phi_407_ = bool();
            phi_408_ = true;
        }
        let _e196 = phi_407_;
        let _e198 = phi_408_;
        if _e198 {
            phi_412_ = false;
        } else {
            phi_412_ = _e196;
        }
        let _e200 = phi_412_;
        if _e200 {
            if (_e176 < 1000000000000000f) {
                if (_e178 < 1000000000000000f) {
                    phi_425_ = (_e180 < 1000000000000000f);
                    phi_426_ = false;
                } else {
                    phi_425_ = bool();
                    phi_426_ = true;
                }
                let _e205 = phi_425_;
                let _e207 = phi_426_;
                phi_427_ = _e205;
                phi_428_ = _e207;
            } else {
                phi_427_ = bool();
                phi_428_ = true;
            }
            let _e209 = phi_427_;
            let _e211 = phi_428_;
            if _e211 {
                phi_432_ = false;
            } else {
                phi_432_ = _e209;
            }
            let _e213 = phi_432_;
            if _e213 {
                if (_e176 > 0f) {
                    phi_446_ = bool();
                    phi_447_ = true;
                } else {
                    let _e215 = (_e178 > 0f);
                    if _e215 {
                        phi_445_ = bool();
                    } else {
                        phi_445_ = (_e180 > 0f);
                    }
                    let _e218 = phi_445_;
                    phi_446_ = _e218;
                    phi_447_ = _e215;
                }
                let _e220 = phi_446_;
                let _e222 = phi_447_;
                if _e222 {
                    phi_451_ = true;
                } else {
                    phi_451_ = _e220;
                }
                let _e224 = phi_451_;
                phi_452_ = _e224;
                phi_453_ = false;
            } else {
                phi_452_ = bool();
                phi_453_ = true;
            }
            let _e226 = phi_452_;
            let _e228 = phi_453_;
            phi_454_ = _e226;
            phi_455_ = _e228;
        } else {
            phi_454_ = bool();
            phi_455_ = true;
        }
        let _e230 = phi_454_;
        let _e232 = phi_455_;
        if _e232 {
            phi_459_ = false;
        } else {
            phi_459_ = _e230;
        }
        let _e234 = phi_459_;
        if _e234 {
            let _e235 = (_e103 >= _e70);
            if _e235 {
                phi_2894_ = lt_bvh_Hit();
            } else {
                if (_e103 < _e70) {
                } else {
                    return;
                }
                let _e241 = nodes.member[(0u + _e103)].frame[0u];
                let _e245 = nodes.member[(0u + _e103)].frame[1u];
                let _e249 = nodes.member[(0u + _e103)].frame[2u];
                let _e253 = nodes.member[(0u + _e103)].frame[0u];
                let _e257 = nodes.member[(0u + _e103)].frame[1u];
                let _e261 = nodes.member[(0u + _e103)].frame[2u];
                let _e265 = nodes.member[(0u + _e103)].frame[3u];
                let _e304 = core_intrinsics_maximum_number_nsz_f32_(abs(_e171.direction.x), abs(_e171.direction.y));
                let _e305 = core_intrinsics_maximum_number_nsz_f32_(_e304, abs(_e171.direction.z));
                let _e306 = (_e305 * 0.0000000000009094947f);
                if (abs(_e171.direction.x) < _e306) {
                    phi_535_ = _e306;
                } else {
                    phi_535_ = abs(_e171.direction.x);
                }
                let _e312 = phi_535_;
                if (_e171.direction.x < 0f) {
                    phi_542_ = (-1f / _e312);
                } else {
                    phi_542_ = (1f / _e312);
                }
                let _e317 = phi_542_;
                if (abs(_e171.direction.y) < _e306) {
                    phi_550_ = _e306;
                } else {
                    phi_550_ = abs(_e171.direction.y);
                }
                let _e323 = phi_550_;
                if (_e171.direction.y < 0f) {
                    phi_557_ = (-1f / _e323);
                } else {
                    phi_557_ = (1f / _e323);
                }
                let _e328 = phi_557_;
                if (abs(_e171.direction.z) < _e306) {
                    phi_565_ = _e306;
                } else {
                    phi_565_ = abs(_e171.direction.z);
                }
                let _e334 = phi_565_;
                if (_e171.direction.z < 0f) {
                    phi_572_ = (-1f / _e334);
                } else {
                    phi_572_ = (1f / _e334);
                }
                let _e339 = phi_572_;
                let _e346 = abs((bitcast<f32>(_e241) - _e171.origin.x));
                let _e347 = abs((bitcast<f32>(_e245) - _e171.origin.y));
                let _e348 = abs((bitcast<f32>(_e249) - _e171.origin.z));
                let _e355 = abs(((bitcast<f32>(_e253) + (bitcast<f32>((((_e265 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e171.origin.x));
                let _e356 = abs(((bitcast<f32>(_e257) + (bitcast<f32>((((_e265 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e171.origin.y));
                let _e357 = abs(((bitcast<f32>(_e261) + (bitcast<f32>((((_e265 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e171.origin.z));
                if (_e346 > _e355) {
                    phi_595_ = _e346;
                } else {
                    phi_595_ = _e355;
                }
                let _e360 = phi_595_;
                if (_e347 > _e356) {
                    phi_600_ = _e347;
                } else {
                    phi_600_ = _e356;
                }
                let _e363 = phi_600_;
                if (_e348 > _e357) {
                    phi_605_ = _e348;
                } else {
                    phi_605_ = _e357;
                }
                let _e366 = phi_605_;
                if (_e360 > _e363) {
                    phi_610_ = _e360;
                } else {
                    phi_610_ = _e363;
                }
                let _e369 = phi_610_;
                if (_e369 > _e366) {
                    phi_615_ = _e369;
                } else {
                    phi_615_ = _e366;
                }
                let _e372 = phi_615_;
                let _e376 = (_e372 * 0.0000019073486f);
                let _e377 = (abs(_e317) * _e376);
                let _e378 = (abs(_e328) * _e376);
                let _e379 = (abs(_e339) * _e376);
                let _e383 = (_e372 * 0.0000009536743f);
                let _e384 = (abs(_e317) * _e383);
                let _e385 = (abs(_e328) * _e383);
                let _e386 = (abs(_e339) * _e383);
                if (_e317 < 0f) {
                    phi_634_ = 0u;
                } else {
                    phi_634_ = 1u;
                }
                let _e389 = phi_634_;
                if (_e328 < 0f) {
                    phi_639_ = 0u;
                } else {
                    phi_639_ = 2u;
                }
                let _e392 = phi_639_;
                if (_e339 < 0f) {
                    phi_644_ = 0u;
                } else {
                    phi_644_ = 4u;
                }
                let _e395 = phi_644_;
                let _e397 = ((_e389 | _e392) | _e395);
                let _e398 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e103, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e398.first[0], _e398.first[1], _e398.first[2], _e398.first[3], _e398.first[4], _e398.first[5], _e398.first[6], _e398.first[7], _e398.first[8], _e398.first[9], _e398.first[10], _e398.first[11], _e398.first[12], _e398.first[13], _e398.first[14], _e398.first[15], _e398.first[16], _e398.first[17], _e398.first[18], _e398.first[19], _e398.first[20], _e398.first[21], _e398.first[22], _e398.first[23], _e398.first[24], _e398.first[25], _e398.first[26], _e398.first[27], _e398.first[28], _e398.first[29], _e398.first[30], _e398.first[31]), array<u32, 32>(_e398.mask[0], _e398.mask[1], _e398.mask[2], _e398.mask[3], _e398.mask[4], _e398.mask[5], _e398.mask[6], _e398.mask[7], _e398.mask[8], _e398.mask[9], _e398.mask[10], _e398.mask[11], _e398.mask[12], _e398.mask[13], _e398.mask[14], _e398.mask[15], _e398.mask[16], _e398.mask[17], _e398.mask[18], _e398.mask[19], _e398.mask[20], _e398.mask[21], _e398.mask[22], _e398.mask[23], _e398.mask[24], _e398.mask[25], _e398.mask[26], _e398.mask[27], _e398.mask[28], _e398.mask[29], _e398.mask[30], _e398.mask[31]), _e398.len, _e398.group, _e398.group_mask);
                let _e472 = local_1.group_mask;
                if ((_e472 & 4278190080u) == 0u) {
                    let _e476 = local_1.len;
                    if (_e476 == 0u) {
                        phi_758_ = false;
                    } else {
                        let _e480 = local_1.len;
                        local_1.len = (_e480 - 1u);
                        let _e483 = local_1.len;
                        if (_e483 < 32u) {
                        } else {
                            return;
                        }
                        let _e488 = local_1.first[(0u + _e483)];
                        local_1.group = _e488;
                        let _e491 = local_1.len;
                        if (_e491 < 32u) {
                        } else {
                            return;
                        }
                        let _e496 = local_1.mask[(0u + _e491)];
                        local_1.group_mask = _e496;
                        phi_758_ = true;
                    }
                    let _e499 = phi_758_;
                    phi_759_ = _e499;
                } else {
                    phi_759_ = true;
                }
                let _e501 = phi_759_;
                if _e501 {
                    let _e503 = local_1.group_mask;
                    let _e509 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e503)), 32u, (_e503 == 0u)));
                    let _e513 = local_1.group_mask;
                    let _e527 = local_1.group_mask;
                    local_1.group_mask = (_e527 & ~((1u << bitcast<u32>((_e509 & 31u)))));
                    let _e530 = local_1.group;
                    phi_790_ = (_e530 + countOneBits(((_e513 & ~((4294967295u << bitcast<u32>((((_e509 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_790_ = 4294967295u;
                }
                let _e533 = phi_790_;
                phi_792_ = _e533;
                phi_795_ = _e173;
                loop {
                    let _e535 = phi_792_;
                    let _e537 = phi_795_;
                    local_11 = _e537;
                    let _e538 = (_e535 != 4294967295u);
                    if _e538 {
                        if (_e535 < _e70) {
                        } else {
                            return;
                        }
                        let _e546 = nodes.member[(0u + _e535)].frame[3u];
                        let _e571 = (bitcast<f32>((((_e546 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e317);
                        let _e572 = (bitcast<f32>((((_e546 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e328);
                        let _e573 = (bitcast<f32>((((_e546 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e339);
                        let _e576 = nodes.member[(0u + _e535)].frame[0u];
                        let _e580 = nodes.member[(0u + _e535)].frame[1u];
                        let _e584 = nodes.member[(0u + _e535)].frame[2u];
                        let _e592 = ((bitcast<f32>(_e576) - _e171.origin.x) * _e317);
                        let _e593 = ((bitcast<f32>(_e580) - _e171.origin.y) * _e328);
                        let _e594 = ((bitcast<f32>(_e584) - _e171.origin.z) * _e339);
                        let _e602 = nodes.member[(0u + _e535)].x;
                        if (_e317 < 0f) {
                            let _e613 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e602.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e619 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e613.unnamed.word, _e602.w), _e613.unnamed_1);
                            let _e625 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e619.unnamed, lt_mask_LightPlace(_e602.x, _e619.unnamed_1.shift));
                            phi_880_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e625.unnamed, lt_mask_LightPlace(_e625.unnamed_1.word, _e602.y));
                        } else {
                            let _e641 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e602.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e647 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e641.unnamed.word, _e602.y), _e641.unnamed_1);
                            let _e653 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e647.unnamed, lt_mask_LightPlace(_e602.z, _e647.unnamed_1.shift));
                            phi_880_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e653.unnamed, lt_mask_LightPlace(_e653.unnamed_1.word, _e602.w));
                        }
                        let _e661 = phi_880_;
                        let _e671 = nodes.member[(0u + _e535)].y;
                        if (_e328 < 0f) {
                            let _e682 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e671.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e688 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e682.unnamed.word, _e671.w), _e682.unnamed_1);
                            let _e694 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e688.unnamed, lt_mask_LightPlace(_e671.x, _e688.unnamed_1.shift));
                            phi_907_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e694.unnamed, lt_mask_LightPlace(_e694.unnamed_1.word, _e671.y));
                        } else {
                            let _e710 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e671.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e716 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e710.unnamed.word, _e671.y), _e710.unnamed_1);
                            let _e722 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e716.unnamed, lt_mask_LightPlace(_e671.z, _e716.unnamed_1.shift));
                            phi_907_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e722.unnamed, lt_mask_LightPlace(_e722.unnamed_1.word, _e671.w));
                        }
                        let _e730 = phi_907_;
                        let _e740 = nodes.member[(0u + _e535)].z;
                        if (_e339 < 0f) {
                            let _e751 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e740.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e757 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e751.unnamed.word, _e740.w), _e751.unnamed_1);
                            let _e763 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e757.unnamed, lt_mask_LightPlace(_e740.x, _e757.unnamed_1.shift));
                            phi_934_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e763.unnamed, lt_mask_LightPlace(_e763.unnamed_1.word, _e740.y));
                        } else {
                            let _e779 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e740.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e785 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e779.unnamed.word, _e740.y), _e779.unnamed_1);
                            let _e791 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e785.unnamed, lt_mask_LightPlace(_e740.z, _e785.unnamed_1.shift));
                            phi_934_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e791.unnamed, lt_mask_LightPlace(_e791.unnamed_1.word, _e740.w));
                        }
                        let _e799 = phi_934_;
                        phi_940_ = 0u;
                        phi_943_ = 0u;
                        loop {
                            let _e809 = phi_940_;
                            let _e811 = phi_943_;
                            local_2 = _e811;
                            local_3 = _e811;
                            local_4 = _e811;
                            let _e812 = (_e809 < 8u);
                            if _e812 {
                                let _e814 = (_e809 >> bitcast<u32>(2i));
                                let _e815 = (_e809 & 3u);
                                if (_e814 == 0u) {
                                    phi_957_ = _e661.unnamed.word;
                                } else {
                                    phi_957_ = _e661.unnamed.shift;
                                }
                                let _e818 = phi_957_;
                                if (_e814 == 0u) {
                                    phi_967_ = _e730.unnamed.word;
                                } else {
                                    phi_967_ = _e730.unnamed.shift;
                                }
                                let _e827 = phi_967_;
                                if (_e814 == 0u) {
                                    phi_977_ = _e799.unnamed.word;
                                } else {
                                    phi_977_ = _e799.unnamed.shift;
                                }
                                let _e836 = phi_977_;
                                let _e849 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e818 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e571) + (_e592 - _e377)), ((f32(((_e827 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e572) + (_e593 - _e378)));
                                let _e850 = core_intrinsics_maximum_number_nsz_f32_(_e849, ((f32(((_e836 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e573) + (_e594 - _e379)));
                                if (_e814 == 0u) {
                                    phi_995_ = _e661.unnamed_1.word;
                                } else {
                                    phi_995_ = _e661.unnamed_1.shift;
                                }
                                let _e853 = phi_995_;
                                if (_e814 == 0u) {
                                    phi_1005_ = _e730.unnamed_1.word;
                                } else {
                                    phi_1005_ = _e730.unnamed_1.shift;
                                }
                                let _e862 = phi_1005_;
                                if (_e814 == 0u) {
                                    phi_1015_ = _e799.unnamed_1.word;
                                } else {
                                    phi_1015_ = _e799.unnamed_1.shift;
                                }
                                let _e871 = phi_1015_;
                                let _e884 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e853 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e571) + (_e592 + _e377)), ((f32(((_e862 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e572) + (_e593 + _e378)));
                                let _e885 = core_intrinsics_minimum_number_nsz_f32_(_e884, ((f32(((_e871 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e573) + (_e594 + _e379)));
                                if (_e850 <= _e885) {
                                    if (_e850 <= _e537.t) {
                                        if (_e885 >= _e171.tmin) {
                                            if (_e814 == 0u) {
                                                let _e892 = nodes.member[(0u + _e535)].links[2u];
                                                phi_1051_ = _e892;
                                            } else {
                                                let _e895 = nodes.member[(0u + _e535)].links[3u];
                                                phi_1051_ = _e895;
                                            }
                                            let _e897 = phi_1051_;
                                            let _e902 = ((_e897 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u);
                                            let _e903 = (_e902 & 31u);
                                            if (_e903 >= 24u) {
                                                phi_1064_ = (24u + ((_e903 - 24u) ^ _e397));
                                            } else {
                                                phi_1064_ = _e903;
                                            }
                                            let _e909 = phi_1064_;
                                            phi_1069_ = (_e811 | ((_e902 >> bitcast<u32>(5i)) << bitcast<u32>((_e909 & 31u))));
                                        } else {
                                            phi_1069_ = _e811;
                                        }
                                        let _e917 = phi_1069_;
                                        phi_1070_ = _e917;
                                    } else {
                                        phi_1070_ = _e811;
                                    }
                                    let _e919 = phi_1070_;
                                    phi_1071_ = _e919;
                                } else {
                                    phi_1071_ = _e811;
                                }
                                let _e921 = phi_1071_;
                                phi_941_ = (_e809 + 1u);
                                phi_944_ = _e921;
                            } else {
                                phi_941_ = u32();
                                phi_944_ = u32();
                            }
                            let _e924 = phi_941_;
                            let _e926 = phi_944_;
                            continue;
                            continuing {
                                phi_940_ = _e924;
                                phi_943_ = _e926;
                                break if !(_e812);
                            }
                        }
                        let _e930 = nodes.member[(0u + _e535)].links[0u];
                        let _e934 = nodes.member[(0u + _e535)].frame[3u];
                        let _e938 = local_2;
                        if ((_e938 & 4278190080u) == 0u) {
                        } else {
                            let _e942 = local_1.group_mask;
                            if ((_e942 & 4278190080u) == 0u) {
                            } else {
                                let _e946 = local_1.len;
                                if (_e946 < 32u) {
                                    let _e949 = local_1.group;
                                    let _e951 = local_1.len;
                                    if (_e951 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e951)] = _e949;
                                    let _e957 = local_1.group_mask;
                                    let _e959 = local_1.len;
                                    if (_e959 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e959)] = _e957;
                                    let _e966 = local_1.len;
                                    local_1.len = (_e966 + 1u);
                                }
                            }
                            local_1.group = (_e103 + _e930);
                            let _e970 = local_3;
                            local_1.group_mask = ((_e970 & 4278190080u) | (_e934 >> bitcast<u32>(24i)));
                        }
                        let _e975 = local_4;
                        phi_1129_ = (_e975 & 16777215u);
                        phi_1132_ = _e537;
                        loop {
                            let _e978 = phi_1129_;
                            let _e980 = phi_1132_;
                            local_10 = _e980;
                            if (_e978 == 0u) {
                                phi_1130_ = u32();
                                phi_1133_ = lt_bvh_Hit();
                                phi_2822_ = false;
                            } else {
                                let _e984 = nodes.member[(0u + _e535)].links[1u];
                                let _e988 = (_e984 + select(firstTrailingBit(_e978), 32u, (_e978 == 0u)));
                                if (_e988 < _e85) {
                                } else {
                                    return;
                                }
                                let _e995 = instances.member[(0u + _e988)].low_world;
                                let _e997 = instances.member[(0u + _e988)].high_world;
                                let _e1007 = ((_e995.x - _e171.origin.x) * _e317);
                                let _e1008 = ((_e995.y - _e171.origin.y) * _e328);
                                let _e1009 = ((_e995.z - _e171.origin.z) * _e339);
                                let _e1019 = ((_e997.x - _e171.origin.x) * _e317);
                                let _e1020 = ((_e997.y - _e171.origin.y) * _e328);
                                let _e1021 = ((_e997.z - _e171.origin.z) * _e339);
                                if (_e1007 < _e1019) {
                                    phi_1187_ = _e1007;
                                } else {
                                    phi_1187_ = _e1019;
                                }
                                let _e1024 = phi_1187_;
                                if (_e1008 < _e1020) {
                                    phi_1192_ = _e1008;
                                } else {
                                    phi_1192_ = _e1020;
                                }
                                let _e1027 = phi_1192_;
                                if (_e1009 < _e1021) {
                                    phi_1197_ = _e1009;
                                } else {
                                    phi_1197_ = _e1021;
                                }
                                let _e1030 = phi_1197_;
                                if (_e1007 > _e1019) {
                                    phi_1205_ = _e1007;
                                } else {
                                    phi_1205_ = _e1019;
                                }
                                let _e1036 = phi_1205_;
                                if (_e1008 > _e1020) {
                                    phi_1210_ = _e1008;
                                } else {
                                    phi_1210_ = _e1020;
                                }
                                let _e1039 = phi_1210_;
                                if (_e1009 > _e1021) {
                                    phi_1215_ = _e1009;
                                } else {
                                    phi_1215_ = _e1021;
                                }
                                let _e1042 = phi_1215_;
                                let _e1046 = core_intrinsics_maximum_number_nsz_f32_((_e1024 - _e384), (_e1027 - _e385));
                                let _e1047 = core_intrinsics_maximum_number_nsz_f32_(_e1046, (_e1030 - _e386));
                                let _e1048 = core_intrinsics_minimum_number_nsz_f32_((_e1036 + _e384), (_e1039 + _e385));
                                let _e1049 = core_intrinsics_minimum_number_nsz_f32_(_e1048, (_e1042 + _e386));
                                if (_e1047 <= _e1049) {
                                    if (_e1047 <= _e980.t) {
                                        if (_e1049 >= _e171.tmin) {
                                            let _e1061 = instances.member[(0u + _e988)].world_to_object[0u];
                                            let _e1072 = ((((_e1061.x * _e171.origin.x) + (_e1061.y * _e171.origin.y)) + (_e1061.z * _e171.origin.z)) + (_e1061.w * 1f));
                                            let _e1074 = instances.member[(0u + _e988)].world_to_object[1u];
                                            let _e1085 = ((((_e1074.x * _e171.origin.x) + (_e1074.y * _e171.origin.y)) + (_e1074.z * _e171.origin.z)) + (_e1074.w * 1f));
                                            let _e1087 = instances.member[(0u + _e988)].world_to_object[2u];
                                            let _e1098 = ((((_e1087.x * _e171.origin.x) + (_e1087.y * _e171.origin.y)) + (_e1087.z * _e171.origin.z)) + (_e1087.w * 1f));
                                            let _e1105 = instances.member[(0u + _e988)].world_to_object[0u];
                                            let _e1116 = ((((_e1105.x * _e171.direction.x) + (_e1105.y * _e171.direction.y)) + (_e1105.z * _e171.direction.z)) + (_e1105.w * 0f));
                                            let _e1118 = instances.member[(0u + _e988)].world_to_object[1u];
                                            let _e1129 = ((((_e1118.x * _e171.direction.x) + (_e1118.y * _e171.direction.y)) + (_e1118.z * _e171.direction.z)) + (_e1118.w * 0f));
                                            let _e1131 = instances.member[(0u + _e988)].world_to_object[2u];
                                            let _e1142 = ((((_e1131.x * _e171.direction.x) + (_e1131.y * _e171.direction.y)) + (_e1131.z * _e171.direction.z)) + (_e1131.w * 0f));
                                            let _e1147 = instances.member[(0u + _e988)].root;
                                            let _e1149 = instances.member[(0u + _e988)].first_triangle;
                                            let _e1150 = abs(_e1116);
                                            let _e1151 = abs(_e1129);
                                            let _e1152 = abs(_e1142);
                                            if (abs(_e1072) < 1000000000000000f) {
                                                if (abs(_e1085) < 1000000000000000f) {
                                                    phi_1347_ = (abs(_e1098) < 1000000000000000f);
                                                    phi_1348_ = false;
                                                } else {
                                                    phi_1347_ = bool();
                                                    phi_1348_ = true;
                                                }
                                                let _e1160 = phi_1347_;
                                                let _e1162 = phi_1348_;
                                                phi_1349_ = _e1160;
                                                phi_1350_ = _e1162;
                                            } else {
                                                phi_1349_ = bool();
                                                phi_1350_ = true;
                                            }
                                            let _e1164 = phi_1349_;
                                            let _e1166 = phi_1350_;
                                            if _e1166 {
                                                phi_1354_ = false;
                                            } else {
                                                phi_1354_ = _e1164;
                                            }
                                            let _e1168 = phi_1354_;
                                            if _e1168 {
                                                if (_e1150 < 1000000000000000f) {
                                                    if (_e1151 < 1000000000000000f) {
                                                        phi_1367_ = (_e1152 < 1000000000000000f);
                                                        phi_1368_ = false;
                                                    } else {
                                                        phi_1367_ = bool();
                                                        phi_1368_ = true;
                                                    }
                                                    let _e1173 = phi_1367_;
                                                    let _e1175 = phi_1368_;
                                                    phi_1369_ = _e1173;
                                                    phi_1370_ = _e1175;
                                                } else {
                                                    phi_1369_ = bool();
                                                    phi_1370_ = true;
                                                }
                                                let _e1177 = phi_1369_;
                                                let _e1179 = phi_1370_;
                                                if _e1179 {
                                                    phi_1374_ = false;
                                                } else {
                                                    phi_1374_ = _e1177;
                                                }
                                                let _e1181 = phi_1374_;
                                                if _e1181 {
                                                    if (_e1150 > 0f) {
                                                        phi_1388_ = bool();
                                                        phi_1389_ = true;
                                                    } else {
                                                        let _e1183 = (_e1151 > 0f);
                                                        if _e1183 {
                                                            phi_1387_ = bool();
                                                        } else {
                                                            phi_1387_ = (_e1152 > 0f);
                                                        }
                                                        let _e1186 = phi_1387_;
                                                        phi_1388_ = _e1186;
                                                        phi_1389_ = _e1183;
                                                    }
                                                    let _e1188 = phi_1388_;
                                                    let _e1190 = phi_1389_;
                                                    if _e1190 {
                                                        phi_1393_ = true;
                                                    } else {
                                                        phi_1393_ = _e1188;
                                                    }
                                                    let _e1192 = phi_1393_;
                                                    phi_1394_ = _e1192;
                                                    phi_1395_ = false;
                                                } else {
                                                    phi_1394_ = bool();
                                                    phi_1395_ = true;
                                                }
                                                let _e1194 = phi_1394_;
                                                let _e1196 = phi_1395_;
                                                phi_1396_ = _e1194;
                                                phi_1397_ = _e1196;
                                            } else {
                                                phi_1396_ = bool();
                                                phi_1397_ = true;
                                            }
                                            let _e1198 = phi_1396_;
                                            let _e1200 = phi_1397_;
                                            if _e1200 {
                                                phi_1401_ = false;
                                            } else {
                                                phi_1401_ = _e1198;
                                            }
                                            let _e1202 = phi_1401_;
                                            if _e1202 {
                                                let _e1203 = (_e1147 >= _e70);
                                                if _e1203 {
                                                    phi_2812_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1147 < _e70) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1209 = nodes.member[(0u + _e1147)].frame[0u];
                                                    let _e1213 = nodes.member[(0u + _e1147)].frame[1u];
                                                    let _e1217 = nodes.member[(0u + _e1147)].frame[2u];
                                                    let _e1221 = nodes.member[(0u + _e1147)].frame[0u];
                                                    let _e1225 = nodes.member[(0u + _e1147)].frame[1u];
                                                    let _e1229 = nodes.member[(0u + _e1147)].frame[2u];
                                                    let _e1233 = nodes.member[(0u + _e1147)].frame[3u];
                                                    let _e1267 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1116), abs(_e1129));
                                                    let _e1268 = core_intrinsics_maximum_number_nsz_f32_(_e1267, abs(_e1142));
                                                    let _e1269 = (_e1268 * 0.0000000000009094947f);
                                                    if (abs(_e1116) < _e1269) {
                                                        phi_1471_ = _e1269;
                                                    } else {
                                                        phi_1471_ = abs(_e1116);
                                                    }
                                                    let _e1274 = phi_1471_;
                                                    if (_e1116 < 0f) {
                                                        phi_1478_ = (-1f / _e1274);
                                                    } else {
                                                        phi_1478_ = (1f / _e1274);
                                                    }
                                                    let _e1279 = phi_1478_;
                                                    if (abs(_e1129) < _e1269) {
                                                        phi_1485_ = _e1269;
                                                    } else {
                                                        phi_1485_ = abs(_e1129);
                                                    }
                                                    let _e1284 = phi_1485_;
                                                    if (_e1129 < 0f) {
                                                        phi_1492_ = (-1f / _e1284);
                                                    } else {
                                                        phi_1492_ = (1f / _e1284);
                                                    }
                                                    let _e1289 = phi_1492_;
                                                    if (abs(_e1142) < _e1269) {
                                                        phi_1499_ = _e1269;
                                                    } else {
                                                        phi_1499_ = abs(_e1142);
                                                    }
                                                    let _e1294 = phi_1499_;
                                                    if (_e1142 < 0f) {
                                                        phi_1506_ = (-1f / _e1294);
                                                    } else {
                                                        phi_1506_ = (1f / _e1294);
                                                    }
                                                    let _e1299 = phi_1506_;
                                                    let _e1303 = abs((bitcast<f32>(_e1209) - _e1072));
                                                    let _e1304 = abs((bitcast<f32>(_e1213) - _e1085));
                                                    let _e1305 = abs((bitcast<f32>(_e1217) - _e1098));
                                                    let _e1309 = abs(((bitcast<f32>(_e1221) + (bitcast<f32>((((_e1233 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1072));
                                                    let _e1310 = abs(((bitcast<f32>(_e1225) + (bitcast<f32>((((_e1233 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1085));
                                                    let _e1311 = abs(((bitcast<f32>(_e1229) + (bitcast<f32>((((_e1233 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1098));
                                                    if (_e1303 > _e1309) {
                                                        phi_1523_ = _e1303;
                                                    } else {
                                                        phi_1523_ = _e1309;
                                                    }
                                                    let _e1314 = phi_1523_;
                                                    if (_e1304 > _e1310) {
                                                        phi_1528_ = _e1304;
                                                    } else {
                                                        phi_1528_ = _e1310;
                                                    }
                                                    let _e1317 = phi_1528_;
                                                    if (_e1305 > _e1311) {
                                                        phi_1533_ = _e1305;
                                                    } else {
                                                        phi_1533_ = _e1311;
                                                    }
                                                    let _e1320 = phi_1533_;
                                                    if (_e1314 > _e1317) {
                                                        phi_1538_ = _e1314;
                                                    } else {
                                                        phi_1538_ = _e1317;
                                                    }
                                                    let _e1323 = phi_1538_;
                                                    if (_e1323 > _e1320) {
                                                        phi_1543_ = _e1323;
                                                    } else {
                                                        phi_1543_ = _e1320;
                                                    }
                                                    let _e1326 = phi_1543_;
                                                    let _e1330 = (_e1326 * 0.0000019073486f);
                                                    let _e1331 = (abs(_e1279) * _e1330);
                                                    let _e1332 = (abs(_e1289) * _e1330);
                                                    let _e1333 = (abs(_e1299) * _e1330);
                                                    let _e1337 = (_e1326 * 0.0000009536743f);
                                                    let _e1338 = (abs(_e1279) * _e1337);
                                                    let _e1339 = (abs(_e1289) * _e1337);
                                                    let _e1340 = (abs(_e1299) * _e1337);
                                                    let _e1341 = abs(_e1116);
                                                    let _e1342 = abs(_e1129);
                                                    let _e1343 = abs(_e1142);
                                                    if (_e1341 >= _e1342) {
                                                        if (_e1341 >= _e1343) {
                                                            phi_1569_ = false;
                                                        } else {
                                                            phi_1569_ = true;
                                                        }
                                                        let _e1347 = phi_1569_;
                                                        phi_1570_ = _e1347;
                                                    } else {
                                                        phi_1570_ = true;
                                                    }
                                                    let _e1349 = phi_1570_;
                                                    if _e1349 {
                                                        if (_e1342 >= _e1343) {
                                                            phi_1578_ = 1u;
                                                        } else {
                                                            phi_1578_ = 2u;
                                                        }
                                                        let _e1352 = phi_1578_;
                                                        phi_1579_ = _e1352;
                                                    } else {
                                                        phi_1579_ = 0u;
                                                    }
                                                    let _e1354 = phi_1579_;
                                                    if (_e1354 == 0u) {
                                                        phi_1591_ = vec3<f32>(_e1129, _e1142, _e1116);
                                                    } else {
                                                        if (_e1354 == 1u) {
                                                            phi_1590_ = vec3<f32>(_e1142, _e1116, _e1129);
                                                        } else {
                                                            phi_1590_ = vec3<f32>(_e1116, _e1129, _e1142);
                                                        }
                                                        let _e1360 = phi_1590_;
                                                        phi_1591_ = _e1360;
                                                    }
                                                    let _e1362 = phi_1591_;
                                                    let _e1365 = (_e1362.x / _e1362.z);
                                                    let _e1368 = (_e1362.y / _e1362.z);
                                                    if (_e1279 < 0f) {
                                                        phi_1604_ = 0u;
                                                    } else {
                                                        phi_1604_ = 1u;
                                                    }
                                                    let _e1373 = phi_1604_;
                                                    if (_e1289 < 0f) {
                                                        phi_1609_ = 0u;
                                                    } else {
                                                        phi_1609_ = 2u;
                                                    }
                                                    let _e1376 = phi_1609_;
                                                    if (_e1299 < 0f) {
                                                        phi_1614_ = 0u;
                                                    } else {
                                                        phi_1614_ = 4u;
                                                    }
                                                    let _e1379 = phi_1614_;
                                                    let _e1381 = ((_e1373 | _e1376) | _e1379);
                                                    let _e1382 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1147, 2147483648u);
                                                    local = lt_bvh_traverse_Stack(array<u32, 32>(_e1382.first[0], _e1382.first[1], _e1382.first[2], _e1382.first[3], _e1382.first[4], _e1382.first[5], _e1382.first[6], _e1382.first[7], _e1382.first[8], _e1382.first[9], _e1382.first[10], _e1382.first[11], _e1382.first[12], _e1382.first[13], _e1382.first[14], _e1382.first[15], _e1382.first[16], _e1382.first[17], _e1382.first[18], _e1382.first[19], _e1382.first[20], _e1382.first[21], _e1382.first[22], _e1382.first[23], _e1382.first[24], _e1382.first[25], _e1382.first[26], _e1382.first[27], _e1382.first[28], _e1382.first[29], _e1382.first[30], _e1382.first[31]), array<u32, 32>(_e1382.mask[0], _e1382.mask[1], _e1382.mask[2], _e1382.mask[3], _e1382.mask[4], _e1382.mask[5], _e1382.mask[6], _e1382.mask[7], _e1382.mask[8], _e1382.mask[9], _e1382.mask[10], _e1382.mask[11], _e1382.mask[12], _e1382.mask[13], _e1382.mask[14], _e1382.mask[15], _e1382.mask[16], _e1382.mask[17], _e1382.mask[18], _e1382.mask[19], _e1382.mask[20], _e1382.mask[21], _e1382.mask[22], _e1382.mask[23], _e1382.mask[24], _e1382.mask[25], _e1382.mask[26], _e1382.mask[27], _e1382.mask[28], _e1382.mask[29], _e1382.mask[30], _e1382.mask[31]), _e1382.len, _e1382.group, _e1382.group_mask);
                                                    let _e1456 = local.group_mask;
                                                    if ((_e1456 & 4278190080u) == 0u) {
                                                        let _e1460 = local.len;
                                                        if (_e1460 == 0u) {
                                                            phi_1728_ = false;
                                                        } else {
                                                            let _e1464 = local.len;
                                                            local.len = (_e1464 - 1u);
                                                            let _e1467 = local.len;
                                                            if (_e1467 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1472 = local.first[(0u + _e1467)];
                                                            local.group = _e1472;
                                                            let _e1475 = local.len;
                                                            if (_e1475 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1480 = local.mask[(0u + _e1475)];
                                                            local.group_mask = _e1480;
                                                            phi_1728_ = true;
                                                        }
                                                        let _e1483 = phi_1728_;
                                                        phi_1729_ = _e1483;
                                                    } else {
                                                        phi_1729_ = true;
                                                    }
                                                    let _e1485 = phi_1729_;
                                                    if _e1485 {
                                                        let _e1487 = local.group_mask;
                                                        let _e1493 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1487)), 32u, (_e1487 == 0u)));
                                                        let _e1497 = local.group_mask;
                                                        let _e1511 = local.group_mask;
                                                        local.group_mask = (_e1511 & ~((1u << bitcast<u32>((_e1493 & 31u)))));
                                                        let _e1514 = local.group;
                                                        phi_1760_ = (_e1514 + countOneBits(((_e1497 & ~((4294967295u << bitcast<u32>((((_e1493 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_1760_ = 4294967295u;
                                                    }
                                                    let _e1517 = phi_1760_;
                                                    phi_1762_ = _e980;
                                                    phi_1765_ = _e1517;
                                                    loop {
                                                        let _e1519 = phi_1762_;
                                                        let _e1521 = phi_1765_;
                                                        local_9 = _e1519;
                                                        let _e1522 = (_e1521 != 4294967295u);
                                                        if _e1522 {
                                                            if (_e1521 < _e70) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1529 = nodes.member[(0u + _e1521)].frame[3u];
                                                            let _e1554 = (bitcast<f32>((((_e1529 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1279);
                                                            let _e1555 = (bitcast<f32>((((_e1529 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1289);
                                                            let _e1556 = (bitcast<f32>((((_e1529 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1299);
                                                            let _e1559 = nodes.member[(0u + _e1521)].frame[0u];
                                                            let _e1563 = nodes.member[(0u + _e1521)].frame[1u];
                                                            let _e1567 = nodes.member[(0u + _e1521)].frame[2u];
                                                            let _e1572 = ((bitcast<f32>(_e1559) - _e1072) * _e1279);
                                                            let _e1573 = ((bitcast<f32>(_e1563) - _e1085) * _e1289);
                                                            let _e1574 = ((bitcast<f32>(_e1567) - _e1098) * _e1299);
                                                            let _e1582 = nodes.member[(0u + _e1521)].x;
                                                            if (_e1279 < 0f) {
                                                                let _e1593 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1582.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1599 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1593.unnamed.word, _e1582.w), _e1593.unnamed_1);
                                                                let _e1605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1599.unnamed, lt_mask_LightPlace(_e1582.x, _e1599.unnamed_1.shift));
                                                                phi_1846_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1605.unnamed, lt_mask_LightPlace(_e1605.unnamed_1.word, _e1582.y));
                                                            } else {
                                                                let _e1621 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1582.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1627 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1621.unnamed.word, _e1582.y), _e1621.unnamed_1);
                                                                let _e1633 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1627.unnamed, lt_mask_LightPlace(_e1582.z, _e1627.unnamed_1.shift));
                                                                phi_1846_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1633.unnamed, lt_mask_LightPlace(_e1633.unnamed_1.word, _e1582.w));
                                                            }
                                                            let _e1641 = phi_1846_;
                                                            let _e1651 = nodes.member[(0u + _e1521)].y;
                                                            if (_e1289 < 0f) {
                                                                let _e1662 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1651.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1662.unnamed.word, _e1651.w), _e1662.unnamed_1);
                                                                let _e1674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1668.unnamed, lt_mask_LightPlace(_e1651.x, _e1668.unnamed_1.shift));
                                                                phi_1873_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1674.unnamed, lt_mask_LightPlace(_e1674.unnamed_1.word, _e1651.y));
                                                            } else {
                                                                let _e1690 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1651.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1696 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1690.unnamed.word, _e1651.y), _e1690.unnamed_1);
                                                                let _e1702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1696.unnamed, lt_mask_LightPlace(_e1651.z, _e1696.unnamed_1.shift));
                                                                phi_1873_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1702.unnamed, lt_mask_LightPlace(_e1702.unnamed_1.word, _e1651.w));
                                                            }
                                                            let _e1710 = phi_1873_;
                                                            let _e1720 = nodes.member[(0u + _e1521)].z;
                                                            if (_e1299 < 0f) {
                                                                let _e1731 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1720.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1731.unnamed.word, _e1720.w), _e1731.unnamed_1);
                                                                let _e1743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1737.unnamed, lt_mask_LightPlace(_e1720.x, _e1737.unnamed_1.shift));
                                                                phi_1900_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1743.unnamed, lt_mask_LightPlace(_e1743.unnamed_1.word, _e1720.y));
                                                            } else {
                                                                let _e1759 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1720.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1765 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1759.unnamed.word, _e1720.y), _e1759.unnamed_1);
                                                                let _e1771 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1765.unnamed, lt_mask_LightPlace(_e1720.z, _e1765.unnamed_1.shift));
                                                                phi_1900_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1771.unnamed, lt_mask_LightPlace(_e1771.unnamed_1.word, _e1720.w));
                                                            }
                                                            let _e1779 = phi_1900_;
                                                            phi_1906_ = 0u;
                                                            phi_1909_ = 0u;
                                                            loop {
                                                                let _e1789 = phi_1906_;
                                                                let _e1791 = phi_1909_;
                                                                local_5 = _e1791;
                                                                local_6 = _e1791;
                                                                local_7 = _e1791;
                                                                let _e1792 = (_e1789 < 8u);
                                                                if _e1792 {
                                                                    let _e1794 = (_e1789 >> bitcast<u32>(2i));
                                                                    let _e1795 = (_e1789 & 3u);
                                                                    if (_e1794 == 0u) {
                                                                        phi_1923_ = _e1641.unnamed.word;
                                                                    } else {
                                                                        phi_1923_ = _e1641.unnamed.shift;
                                                                    }
                                                                    let _e1798 = phi_1923_;
                                                                    if (_e1794 == 0u) {
                                                                        phi_1933_ = _e1710.unnamed.word;
                                                                    } else {
                                                                        phi_1933_ = _e1710.unnamed.shift;
                                                                    }
                                                                    let _e1807 = phi_1933_;
                                                                    if (_e1794 == 0u) {
                                                                        phi_1943_ = _e1779.unnamed.word;
                                                                    } else {
                                                                        phi_1943_ = _e1779.unnamed.shift;
                                                                    }
                                                                    let _e1816 = phi_1943_;
                                                                    let _e1829 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1798 >> bitcast<u32>(((_e1795 * 8u) & 31u))) & 255u)) * _e1554) + (_e1572 - _e1331)), ((f32(((_e1807 >> bitcast<u32>(((_e1795 * 8u) & 31u))) & 255u)) * _e1555) + (_e1573 - _e1332)));
                                                                    let _e1830 = core_intrinsics_maximum_number_nsz_f32_(_e1829, ((f32(((_e1816 >> bitcast<u32>(((_e1795 * 8u) & 31u))) & 255u)) * _e1556) + (_e1574 - _e1333)));
                                                                    if (_e1794 == 0u) {
                                                                        phi_1961_ = _e1641.unnamed_1.word;
                                                                    } else {
                                                                        phi_1961_ = _e1641.unnamed_1.shift;
                                                                    }
                                                                    let _e1833 = phi_1961_;
                                                                    if (_e1794 == 0u) {
                                                                        phi_1971_ = _e1710.unnamed_1.word;
                                                                    } else {
                                                                        phi_1971_ = _e1710.unnamed_1.shift;
                                                                    }
                                                                    let _e1842 = phi_1971_;
                                                                    if (_e1794 == 0u) {
                                                                        phi_1981_ = _e1779.unnamed_1.word;
                                                                    } else {
                                                                        phi_1981_ = _e1779.unnamed_1.shift;
                                                                    }
                                                                    let _e1851 = phi_1981_;
                                                                    let _e1864 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1833 >> bitcast<u32>(((_e1795 * 8u) & 31u))) & 255u)) * _e1554) + (_e1572 + _e1331)), ((f32(((_e1842 >> bitcast<u32>(((_e1795 * 8u) & 31u))) & 255u)) * _e1555) + (_e1573 + _e1332)));
                                                                    let _e1865 = core_intrinsics_minimum_number_nsz_f32_(_e1864, ((f32(((_e1851 >> bitcast<u32>(((_e1795 * 8u) & 31u))) & 255u)) * _e1556) + (_e1574 + _e1333)));
                                                                    if (_e1830 <= _e1865) {
                                                                        if (_e1830 <= _e1519.t) {
                                                                            if (_e1865 >= _e171.tmin) {
                                                                                if (_e1794 == 0u) {
                                                                                    let _e1872 = nodes.member[(0u + _e1521)].links[2u];
                                                                                    phi_2017_ = _e1872;
                                                                                } else {
                                                                                    let _e1875 = nodes.member[(0u + _e1521)].links[3u];
                                                                                    phi_2017_ = _e1875;
                                                                                }
                                                                                let _e1877 = phi_2017_;
                                                                                let _e1882 = ((_e1877 >> bitcast<u32>(((_e1795 * 8u) & 31u))) & 255u);
                                                                                let _e1883 = (_e1882 & 31u);
                                                                                if (_e1883 >= 24u) {
                                                                                    phi_2030_ = (24u + ((_e1883 - 24u) ^ _e1381));
                                                                                } else {
                                                                                    phi_2030_ = _e1883;
                                                                                }
                                                                                let _e1889 = phi_2030_;
                                                                                phi_2035_ = (_e1791 | ((_e1882 >> bitcast<u32>(5i)) << bitcast<u32>((_e1889 & 31u))));
                                                                            } else {
                                                                                phi_2035_ = _e1791;
                                                                            }
                                                                            let _e1897 = phi_2035_;
                                                                            phi_2036_ = _e1897;
                                                                        } else {
                                                                            phi_2036_ = _e1791;
                                                                        }
                                                                        let _e1899 = phi_2036_;
                                                                        phi_2037_ = _e1899;
                                                                    } else {
                                                                        phi_2037_ = _e1791;
                                                                    }
                                                                    let _e1901 = phi_2037_;
                                                                    phi_1907_ = (_e1789 + 1u);
                                                                    phi_1910_ = _e1901;
                                                                } else {
                                                                    phi_1907_ = u32();
                                                                    phi_1910_ = u32();
                                                                }
                                                                let _e1904 = phi_1907_;
                                                                let _e1906 = phi_1910_;
                                                                continue;
                                                                continuing {
                                                                    phi_1906_ = _e1904;
                                                                    phi_1909_ = _e1906;
                                                                    break if !(_e1792);
                                                                }
                                                            }
                                                            let _e1910 = nodes.member[(0u + _e1521)].links[0u];
                                                            let _e1914 = nodes.member[(0u + _e1521)].frame[3u];
                                                            let _e1918 = local_5;
                                                            if ((_e1918 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1922 = local.group_mask;
                                                                if ((_e1922 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1926 = local.len;
                                                                    if (_e1926 < 32u) {
                                                                        let _e1929 = local.group;
                                                                        let _e1931 = local.len;
                                                                        if (_e1931 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.first[(0u + _e1931)] = _e1929;
                                                                        let _e1937 = local.group_mask;
                                                                        let _e1939 = local.len;
                                                                        if (_e1939 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.mask[(0u + _e1939)] = _e1937;
                                                                        let _e1946 = local.len;
                                                                        local.len = (_e1946 + 1u);
                                                                    }
                                                                }
                                                                local.group = (_e1147 + _e1910);
                                                                let _e1950 = local_6;
                                                                local.group_mask = ((_e1950 & 4278190080u) | (_e1914 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1955 = local_7;
                                                            phi_2095_ = _e1519;
                                                            phi_2098_ = (_e1955 & 16777215u);
                                                            loop {
                                                                let _e1958 = phi_2095_;
                                                                let _e1960 = phi_2098_;
                                                                local_8 = _e1958;
                                                                if (_e1960 == 0u) {
                                                                    phi_2096_ = lt_bvh_Hit();
                                                                    phi_2099_ = u32();
                                                                    phi_2740_ = false;
                                                                } else {
                                                                    let _e1964 = nodes.member[(0u + _e1521)].links[1u];
                                                                    let _e1969 = ((_e1149 + _e1964) + select(firstTrailingBit(_e1960), 32u, (_e1960 == 0u)));
                                                                    if (_e1969 < _e73) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1976 = triangles.member[(0u + _e1969)].v0_;
                                                                    let _e1978 = (_e1976.x - _e1072);
                                                                    let _e1980 = (_e1976.y - _e1085);
                                                                    let _e1982 = (_e1976.z - _e1098);
                                                                    if (_e1354 == 0u) {
                                                                        phi_2143_ = vec3<f32>(_e1980, _e1982, _e1978);
                                                                    } else {
                                                                        if (_e1354 == 1u) {
                                                                            phi_2142_ = vec3<f32>(_e1982, _e1978, _e1980);
                                                                        } else {
                                                                            phi_2142_ = (_e1976 - vec3<f32>(_e1072, _e1085, _e1098));
                                                                        }
                                                                        let _e1990 = phi_2142_;
                                                                        phi_2143_ = _e1990;
                                                                    }
                                                                    let _e1992 = phi_2143_;
                                                                    let _e1996 = (_e1992.x - (_e1365 * _e1992.z));
                                                                    let _e2000 = (_e1992.y - (_e1368 * _e1992.z));
                                                                    let _e2002 = triangles.member[(0u + _e1969)].v1_;
                                                                    let _e2004 = (_e2002.x - _e1072);
                                                                    let _e2006 = (_e2002.y - _e1085);
                                                                    let _e2008 = (_e2002.z - _e1098);
                                                                    if (_e1354 == 0u) {
                                                                        phi_2173_ = vec3<f32>(_e2006, _e2008, _e2004);
                                                                    } else {
                                                                        if (_e1354 == 1u) {
                                                                            phi_2172_ = vec3<f32>(_e2008, _e2004, _e2006);
                                                                        } else {
                                                                            phi_2172_ = (_e2002 - vec3<f32>(_e1072, _e1085, _e1098));
                                                                        }
                                                                        let _e2016 = phi_2172_;
                                                                        phi_2173_ = _e2016;
                                                                    }
                                                                    let _e2018 = phi_2173_;
                                                                    let _e2022 = (_e2018.x - (_e1365 * _e2018.z));
                                                                    let _e2026 = (_e2018.y - (_e1368 * _e2018.z));
                                                                    let _e2028 = triangles.member[(0u + _e1969)].v2_;
                                                                    let _e2030 = (_e2028.x - _e1072);
                                                                    let _e2032 = (_e2028.y - _e1085);
                                                                    let _e2034 = (_e2028.z - _e1098);
                                                                    if (_e1354 == 0u) {
                                                                        phi_2203_ = vec3<f32>(_e2032, _e2034, _e2030);
                                                                    } else {
                                                                        if (_e1354 == 1u) {
                                                                            phi_2202_ = vec3<f32>(_e2034, _e2030, _e2032);
                                                                        } else {
                                                                            phi_2202_ = (_e2028 - vec3<f32>(_e1072, _e1085, _e1098));
                                                                        }
                                                                        let _e2042 = phi_2202_;
                                                                        phi_2203_ = _e2042;
                                                                    }
                                                                    let _e2044 = phi_2203_;
                                                                    let _e2048 = (_e2044.x - (_e1365 * _e2044.z));
                                                                    let _e2052 = (_e2044.y - (_e1368 * _e2044.z));
                                                                    if (_e2022 < _e2048) {
                                                                        phi_2222_ = true;
                                                                    } else {
                                                                        if (_e2022 == _e2048) {
                                                                            phi_2221_ = (_e2026 < _e2052);
                                                                        } else {
                                                                            phi_2221_ = false;
                                                                        }
                                                                        let _e2057 = phi_2221_;
                                                                        phi_2222_ = _e2057;
                                                                    }
                                                                    let _e2059 = phi_2222_;
                                                                    if _e2059 {
                                                                        phi_2226_ = _e2052;
                                                                        phi_2227_ = _e2048;
                                                                        phi_2228_ = _e2026;
                                                                        phi_2229_ = _e2022;
                                                                    } else {
                                                                        phi_2226_ = _e2026;
                                                                        phi_2227_ = _e2022;
                                                                        phi_2228_ = _e2052;
                                                                        phi_2229_ = _e2048;
                                                                    }
                                                                    let _e2061 = phi_2226_;
                                                                    let _e2063 = phi_2227_;
                                                                    let _e2065 = phi_2228_;
                                                                    let _e2067 = phi_2229_;
                                                                    let _e2070 = ((_e2067 * _e2061) - (_e2065 * _e2063));
                                                                    if _e2059 {
                                                                        phi_2237_ = -(_e2070);
                                                                    } else {
                                                                        phi_2237_ = _e2070;
                                                                    }
                                                                    let _e2073 = phi_2237_;
                                                                    if (_e2048 < _e1996) {
                                                                        phi_2248_ = true;
                                                                    } else {
                                                                        if (_e2048 == _e1996) {
                                                                            phi_2247_ = (_e2052 < _e2000);
                                                                        } else {
                                                                            phi_2247_ = false;
                                                                        }
                                                                        let _e2078 = phi_2247_;
                                                                        phi_2248_ = _e2078;
                                                                    }
                                                                    let _e2080 = phi_2248_;
                                                                    if _e2080 {
                                                                        phi_2252_ = _e2000;
                                                                        phi_2253_ = _e1996;
                                                                        phi_2254_ = _e2052;
                                                                        phi_2255_ = _e2048;
                                                                    } else {
                                                                        phi_2252_ = _e2052;
                                                                        phi_2253_ = _e2048;
                                                                        phi_2254_ = _e2000;
                                                                        phi_2255_ = _e1996;
                                                                    }
                                                                    let _e2082 = phi_2252_;
                                                                    let _e2084 = phi_2253_;
                                                                    let _e2086 = phi_2254_;
                                                                    let _e2088 = phi_2255_;
                                                                    let _e2091 = ((_e2088 * _e2082) - (_e2086 * _e2084));
                                                                    if _e2080 {
                                                                        phi_2263_ = -(_e2091);
                                                                    } else {
                                                                        phi_2263_ = _e2091;
                                                                    }
                                                                    let _e2094 = phi_2263_;
                                                                    if (_e1996 < _e2022) {
                                                                        phi_2274_ = true;
                                                                    } else {
                                                                        if (_e1996 == _e2022) {
                                                                            phi_2273_ = (_e2000 < _e2026);
                                                                        } else {
                                                                            phi_2273_ = false;
                                                                        }
                                                                        let _e2099 = phi_2273_;
                                                                        phi_2274_ = _e2099;
                                                                    }
                                                                    let _e2101 = phi_2274_;
                                                                    if _e2101 {
                                                                        phi_2278_ = _e2026;
                                                                        phi_2279_ = _e2022;
                                                                        phi_2280_ = _e2000;
                                                                        phi_2281_ = _e1996;
                                                                    } else {
                                                                        phi_2278_ = _e2000;
                                                                        phi_2279_ = _e1996;
                                                                        phi_2280_ = _e2026;
                                                                        phi_2281_ = _e2022;
                                                                    }
                                                                    let _e2103 = phi_2278_;
                                                                    let _e2105 = phi_2279_;
                                                                    let _e2107 = phi_2280_;
                                                                    let _e2109 = phi_2281_;
                                                                    let _e2112 = ((_e2109 * _e2103) - (_e2107 * _e2105));
                                                                    if _e2101 {
                                                                        phi_2289_ = -(_e2112);
                                                                    } else {
                                                                        phi_2289_ = _e2112;
                                                                    }
                                                                    let _e2115 = phi_2289_;
                                                                    if (_e2073 >= 0f) {
                                                                        if (_e2094 >= 0f) {
                                                                            if (_e2115 >= 0f) {
                                                                                phi_2304_ = ((_e2073 + _e2094) + _e2115);
                                                                                phi_2305_ = false;
                                                                            } else {
                                                                                phi_2304_ = f32();
                                                                                phi_2305_ = true;
                                                                            }
                                                                            let _e2122 = phi_2304_;
                                                                            let _e2124 = phi_2305_;
                                                                            phi_2306_ = _e2122;
                                                                            phi_2307_ = _e2124;
                                                                        } else {
                                                                            phi_2306_ = f32();
                                                                            phi_2307_ = true;
                                                                        }
                                                                        let _e2126 = phi_2306_;
                                                                        let _e2128 = phi_2307_;
                                                                        phi_2308_ = _e2126;
                                                                        phi_2309_ = _e2128;
                                                                    } else {
                                                                        phi_2308_ = f32();
                                                                        phi_2309_ = true;
                                                                    }
                                                                    let _e2130 = phi_2308_;
                                                                    let _e2132 = phi_2309_;
                                                                    if _e2132 {
                                                                        if (_e2073 <= 0f) {
                                                                            if (_e2094 <= 0f) {
                                                                                let _e2135 = (_e2115 <= 0f);
                                                                                if _e2135 {
                                                                                }
                                                                                phi_2327_ = ((_e2073 + _e2094) + _e2115);
                                                                                phi_2328_ = false;
                                                                                phi_2329_ = _e2135;
                                                                            } else {
                                                                                phi_2327_ = f32();
                                                                                phi_2328_ = true;
                                                                                phi_2329_ = false;
                                                                            }
                                                                            let _e2139 = phi_2327_;
                                                                            let _e2141 = phi_2328_;
                                                                            let _e2143 = phi_2329_;
                                                                            phi_2330_ = _e2139;
                                                                            phi_2331_ = _e2141;
                                                                            phi_2332_ = _e2143;
                                                                        } else {
                                                                            phi_2330_ = f32();
                                                                            phi_2331_ = true;
                                                                            phi_2332_ = false;
                                                                        }
                                                                        let _e2145 = phi_2330_;
                                                                        let _e2147 = phi_2331_;
                                                                        let _e2149 = phi_2332_;
                                                                        if _e2147 {
                                                                            phi_2336_ = false;
                                                                        } else {
                                                                            phi_2336_ = _e2149;
                                                                        }
                                                                        let _e2151 = phi_2336_;
                                                                        phi_2337_ = _e2145;
                                                                        phi_2338_ = _e2151;
                                                                    } else {
                                                                        phi_2337_ = _e2130;
                                                                        phi_2338_ = true;
                                                                    }
                                                                    let _e2153 = phi_2337_;
                                                                    let _e2155 = phi_2338_;
                                                                    if _e2155 {
                                                                        let _e2156 = (_e2153 == 0f);
                                                                        if _e2156 {
                                                                            phi_2654_ = lt_bvh_triangle_Intersection();
                                                                            phi_2655_ = false;
                                                                        } else {
                                                                            let _e2158 = triangles.member[(0u + _e1969)].v0_;
                                                                            let _e2160 = (_e2158.x - _e1072);
                                                                            let _e2162 = (_e2158.y - _e1085);
                                                                            let _e2164 = (_e2158.z - _e1098);
                                                                            if (_e1354 == 0u) {
                                                                                phi_2367_ = vec3<f32>(_e2162, _e2164, _e2160);
                                                                            } else {
                                                                                if (_e1354 == 1u) {
                                                                                    phi_2366_ = vec3<f32>(_e2164, _e2160, _e2162);
                                                                                } else {
                                                                                    phi_2366_ = (_e2158 - vec3<f32>(_e1072, _e1085, _e1098));
                                                                                }
                                                                                let _e2172 = phi_2366_;
                                                                                phi_2367_ = _e2172;
                                                                            }
                                                                            let _e2174 = phi_2367_;
                                                                            let _e2176 = triangles.member[(0u + _e1969)].v1_;
                                                                            let _e2178 = triangles.member[(0u + _e1969)].v0_;
                                                                            let _e2181 = (_e2176.x - _e2178.x);
                                                                            let _e2184 = (_e2176.y - _e2178.y);
                                                                            let _e2187 = (_e2176.z - _e2178.z);
                                                                            if (_e1354 == 0u) {
                                                                                phi_2393_ = vec3<f32>(_e2184, _e2187, _e2181);
                                                                            } else {
                                                                                if (_e1354 == 1u) {
                                                                                    phi_2392_ = vec3<f32>(_e2187, _e2181, _e2184);
                                                                                } else {
                                                                                    phi_2392_ = (_e2176 - _e2178);
                                                                                }
                                                                                let _e2194 = phi_2392_;
                                                                                phi_2393_ = _e2194;
                                                                            }
                                                                            let _e2196 = phi_2393_;
                                                                            let _e2198 = triangles.member[(0u + _e1969)].v2_;
                                                                            let _e2200 = triangles.member[(0u + _e1969)].v0_;
                                                                            let _e2203 = (_e2198.x - _e2200.x);
                                                                            let _e2206 = (_e2198.y - _e2200.y);
                                                                            let _e2209 = (_e2198.z - _e2200.z);
                                                                            if (_e1354 == 0u) {
                                                                                phi_2419_ = vec3<f32>(_e2206, _e2209, _e2203);
                                                                            } else {
                                                                                if (_e1354 == 1u) {
                                                                                    phi_2418_ = vec3<f32>(_e2209, _e2203, _e2206);
                                                                                } else {
                                                                                    phi_2418_ = (_e2198 - _e2200);
                                                                                }
                                                                                let _e2216 = phi_2418_;
                                                                                phi_2419_ = _e2216;
                                                                            }
                                                                            let _e2218 = phi_2419_;
                                                                            let _e2225 = ((_e2196.y * _e2218.z) - (_e2196.z * _e2218.y));
                                                                            let _e2232 = ((_e2196.z * _e2218.x) - (_e2196.x * _e2218.z));
                                                                            let _e2239 = ((_e2196.x * _e2218.y) - (_e2196.y * _e2218.x));
                                                                            let _e2253 = (((1f / _e1362.z) * (((_e2225 * _e2174.x) + (_e2232 * _e2174.y)) + (_e2239 * _e2174.z))) / (((_e2225 * _e1365) + (_e2232 * _e1368)) + _e2239));
                                                                            if (_e2253 > _e171.tmin) {
                                                                                if (_e2253 < _e171.tmax) {
                                                                                    let _e2257 = triangles.member[(0u + _e1969)].v0_;
                                                                                    let _e2259 = triangles.member[(0u + _e1969)].v1_;
                                                                                    if (_e2257.x < _e2259.x) {
                                                                                        phi_2475_ = _e2257.x;
                                                                                    } else {
                                                                                        phi_2475_ = _e2259.x;
                                                                                    }
                                                                                    let _e2266 = phi_2475_;
                                                                                    if (_e2257.y < _e2259.y) {
                                                                                        phi_2484_ = _e2257.y;
                                                                                    } else {
                                                                                        phi_2484_ = _e2259.y;
                                                                                    }
                                                                                    let _e2273 = phi_2484_;
                                                                                    if (_e2257.z < _e2259.z) {
                                                                                        phi_2493_ = _e2257.z;
                                                                                    } else {
                                                                                        phi_2493_ = _e2259.z;
                                                                                    }
                                                                                    let _e2280 = phi_2493_;
                                                                                    let _e2282 = triangles.member[(0u + _e1969)].v2_;
                                                                                    if (_e2266 < _e2282.x) {
                                                                                        phi_2502_ = _e2266;
                                                                                    } else {
                                                                                        phi_2502_ = _e2282.x;
                                                                                    }
                                                                                    let _e2287 = phi_2502_;
                                                                                    if (_e2273 < _e2282.y) {
                                                                                        phi_2509_ = _e2273;
                                                                                    } else {
                                                                                        phi_2509_ = _e2282.y;
                                                                                    }
                                                                                    let _e2292 = phi_2509_;
                                                                                    if (_e2280 < _e2282.z) {
                                                                                        phi_2516_ = _e2280;
                                                                                    } else {
                                                                                        phi_2516_ = _e2282.z;
                                                                                    }
                                                                                    let _e2297 = phi_2516_;
                                                                                    let _e2299 = triangles.member[(0u + _e1969)].v0_;
                                                                                    let _e2301 = triangles.member[(0u + _e1969)].v1_;
                                                                                    if (_e2299.x > _e2301.x) {
                                                                                        phi_2529_ = _e2299.x;
                                                                                    } else {
                                                                                        phi_2529_ = _e2301.x;
                                                                                    }
                                                                                    let _e2308 = phi_2529_;
                                                                                    if (_e2299.y > _e2301.y) {
                                                                                        phi_2538_ = _e2299.y;
                                                                                    } else {
                                                                                        phi_2538_ = _e2301.y;
                                                                                    }
                                                                                    let _e2315 = phi_2538_;
                                                                                    if (_e2299.z > _e2301.z) {
                                                                                        phi_2547_ = _e2299.z;
                                                                                    } else {
                                                                                        phi_2547_ = _e2301.z;
                                                                                    }
                                                                                    let _e2322 = phi_2547_;
                                                                                    let _e2324 = triangles.member[(0u + _e1969)].v2_;
                                                                                    if (_e2308 > _e2324.x) {
                                                                                        phi_2556_ = _e2308;
                                                                                    } else {
                                                                                        phi_2556_ = _e2324.x;
                                                                                    }
                                                                                    let _e2329 = phi_2556_;
                                                                                    if (_e2315 > _e2324.y) {
                                                                                        phi_2563_ = _e2315;
                                                                                    } else {
                                                                                        phi_2563_ = _e2324.y;
                                                                                    }
                                                                                    let _e2334 = phi_2563_;
                                                                                    if (_e2322 > _e2324.z) {
                                                                                        phi_2570_ = _e2322;
                                                                                    } else {
                                                                                        phi_2570_ = _e2324.z;
                                                                                    }
                                                                                    let _e2339 = phi_2570_;
                                                                                    let _e2343 = ((_e2287 - _e1072) * _e1279);
                                                                                    let _e2344 = ((_e2292 - _e1085) * _e1289);
                                                                                    let _e2345 = ((_e2297 - _e1098) * _e1299);
                                                                                    let _e2349 = ((_e2329 - _e1072) * _e1279);
                                                                                    let _e2350 = ((_e2334 - _e1085) * _e1289);
                                                                                    let _e2351 = ((_e2339 - _e1098) * _e1299);
                                                                                    if (_e2343 < _e2349) {
                                                                                        phi_2587_ = _e2343;
                                                                                    } else {
                                                                                        phi_2587_ = _e2349;
                                                                                    }
                                                                                    let _e2354 = phi_2587_;
                                                                                    if (_e2344 < _e2350) {
                                                                                        phi_2592_ = _e2344;
                                                                                    } else {
                                                                                        phi_2592_ = _e2350;
                                                                                    }
                                                                                    let _e2357 = phi_2592_;
                                                                                    if (_e2345 < _e2351) {
                                                                                        phi_2597_ = _e2345;
                                                                                    } else {
                                                                                        phi_2597_ = _e2351;
                                                                                    }
                                                                                    let _e2360 = phi_2597_;
                                                                                    if (_e2343 > _e2349) {
                                                                                        phi_2605_ = _e2343;
                                                                                    } else {
                                                                                        phi_2605_ = _e2349;
                                                                                    }
                                                                                    let _e2366 = phi_2605_;
                                                                                    if (_e2344 > _e2350) {
                                                                                        phi_2610_ = _e2344;
                                                                                    } else {
                                                                                        phi_2610_ = _e2350;
                                                                                    }
                                                                                    let _e2369 = phi_2610_;
                                                                                    if (_e2345 > _e2351) {
                                                                                        phi_2615_ = _e2345;
                                                                                    } else {
                                                                                        phi_2615_ = _e2351;
                                                                                    }
                                                                                    let _e2372 = phi_2615_;
                                                                                    let _e2376 = core_intrinsics_maximum_number_nsz_f32_((_e2354 - _e1338), (_e2357 - _e1339));
                                                                                    let _e2377 = core_intrinsics_maximum_number_nsz_f32_(_e2376, (_e2360 - _e1340));
                                                                                    let _e2378 = core_intrinsics_minimum_number_nsz_f32_((_e2366 + _e1338), (_e2369 + _e1339));
                                                                                    let _e2379 = core_intrinsics_minimum_number_nsz_f32_(_e2378, (_e2372 + _e1340));
                                                                                    if (_e2377 > _e1047) {
                                                                                        phi_2627_ = _e2377;
                                                                                    } else {
                                                                                        phi_2627_ = _e1047;
                                                                                    }
                                                                                    let _e2382 = phi_2627_;
                                                                                    if (_e2379 < _e1049) {
                                                                                        phi_2632_ = _e2379;
                                                                                    } else {
                                                                                        phi_2632_ = _e1049;
                                                                                    }
                                                                                    let _e2385 = phi_2632_;
                                                                                    if (_e2253 < _e2382) {
                                                                                        phi_2637_ = _e2382;
                                                                                    } else {
                                                                                        phi_2637_ = _e2253;
                                                                                    }
                                                                                    let _e2388 = phi_2637_;
                                                                                    if (_e2388 > _e2385) {
                                                                                        phi_2642_ = _e2385;
                                                                                    } else {
                                                                                        phi_2642_ = _e2388;
                                                                                    }
                                                                                    let _e2391 = phi_2642_;
                                                                                    phi_2647_ = lt_bvh_triangle_Intersection(_e2391, (_e2094 / _e2153), (_e2115 / _e2153), (_e2382 <= _e2385));
                                                                                    phi_2648_ = false;
                                                                                } else {
                                                                                    phi_2647_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2648_ = true;
                                                                                }
                                                                                let _e2397 = phi_2647_;
                                                                                let _e2399 = phi_2648_;
                                                                                phi_2649_ = _e2397;
                                                                                phi_2650_ = _e2399;
                                                                            } else {
                                                                                phi_2649_ = lt_bvh_triangle_Intersection();
                                                                                phi_2650_ = true;
                                                                            }
                                                                            let _e2401 = phi_2649_;
                                                                            let _e2403 = phi_2650_;
                                                                            if _e2403 {
                                                                            }
                                                                            phi_2654_ = _e2401;
                                                                            phi_2655_ = _e2403;
                                                                        }
                                                                        let _e2405 = phi_2654_;
                                                                        let _e2407 = phi_2655_;
                                                                        phi_2656_ = _e2405;
                                                                        phi_2657_ = _e2156;
                                                                        phi_2658_ = _e2407;
                                                                    } else {
                                                                        phi_2656_ = lt_bvh_triangle_Intersection();
                                                                        phi_2657_ = true;
                                                                        phi_2658_ = false;
                                                                    }
                                                                    let _e2409 = phi_2656_;
                                                                    let _e2411 = phi_2657_;
                                                                    let _e2413 = phi_2658_;
                                                                    if _e2411 {
                                                                        phi_2662_ = true;
                                                                    } else {
                                                                        phi_2662_ = _e2413;
                                                                    }
                                                                    let _e2415 = phi_2662_;
                                                                    if _e2415 {
                                                                        phi_2666_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2666_ = _e2409;
                                                                    }
                                                                    let _e2417 = phi_2666_;
                                                                    if _e2417.is_hit {
                                                                        if (_e2417.t > _e171.tmin) {
                                                                            if (_e2417.t < _e1958.t) {
                                                                                phi_2714_ = true;
                                                                            } else {
                                                                                if (_e2417.t == _e1958.t) {
                                                                                    if (_e1958.triangle != 4294967295u) {
                                                                                        if (_e1969 < _e1958.triangle) {
                                                                                            phi_2705_ = true;
                                                                                        } else {
                                                                                            if (_e1969 == _e1958.triangle) {
                                                                                                phi_2704_ = (_e988 < _e1958.instance);
                                                                                            } else {
                                                                                                phi_2704_ = false;
                                                                                            }
                                                                                            let _e2435 = phi_2704_;
                                                                                            phi_2705_ = _e2435;
                                                                                        }
                                                                                        let _e2437 = phi_2705_;
                                                                                        phi_2706_ = _e2437;
                                                                                        phi_2707_ = false;
                                                                                    } else {
                                                                                        phi_2706_ = bool();
                                                                                        phi_2707_ = true;
                                                                                    }
                                                                                    let _e2439 = phi_2706_;
                                                                                    let _e2441 = phi_2707_;
                                                                                    phi_2708_ = _e2439;
                                                                                    phi_2709_ = _e2441;
                                                                                } else {
                                                                                    phi_2708_ = bool();
                                                                                    phi_2709_ = true;
                                                                                }
                                                                                let _e2443 = phi_2708_;
                                                                                let _e2445 = phi_2709_;
                                                                                if _e2445 {
                                                                                    phi_2713_ = false;
                                                                                } else {
                                                                                    phi_2713_ = _e2443;
                                                                                }
                                                                                let _e2447 = phi_2713_;
                                                                                phi_2714_ = _e2447;
                                                                            }
                                                                            let _e2449 = phi_2714_;
                                                                            if _e2449 {
                                                                                let _e2451 = triangles.member[(0u + _e1969)].i0_;
                                                                                if ((_e2451 & 2147483648u) == 0u) {
                                                                                    phi_2728_ = true;
                                                                                } else {
                                                                                    if true {
                                                                                    }
                                                                                    phi_2728_ = true;
                                                                                }
                                                                                let _e2455 = phi_2728_;
                                                                                if _e2455 {
                                                                                    phi_2736_ = lt_bvh_Hit(_e2417.t, _e2417.u, _e2417.v, _e1969, _e988);
                                                                                } else {
                                                                                    phi_2736_ = _e1958;
                                                                                }
                                                                                let _e2461 = phi_2736_;
                                                                                phi_2737_ = _e2461;
                                                                            } else {
                                                                                phi_2737_ = _e1958;
                                                                            }
                                                                            let _e2463 = phi_2737_;
                                                                            phi_2738_ = _e2463;
                                                                        } else {
                                                                            phi_2738_ = _e1958;
                                                                        }
                                                                        let _e2465 = phi_2738_;
                                                                        phi_2739_ = _e2465;
                                                                    } else {
                                                                        phi_2739_ = _e1958;
                                                                    }
                                                                    let _e2467 = phi_2739_;
                                                                    phi_2096_ = _e2467;
                                                                    phi_2099_ = (_e1960 & (_e1960 - 1u));
                                                                    phi_2740_ = true;
                                                                }
                                                                let _e2469 = phi_2096_;
                                                                let _e2471 = phi_2099_;
                                                                let _e2473 = phi_2740_;
                                                                continue;
                                                                continuing {
                                                                    phi_2095_ = _e2469;
                                                                    phi_2098_ = _e2471;
                                                                    break if !(_e2473);
                                                                }
                                                            }
                                                            let _e2476 = local.group_mask;
                                                            if ((_e2476 & 4278190080u) == 0u) {
                                                                let _e2480 = local.len;
                                                                if (_e2480 == 0u) {
                                                                    phi_2779_ = false;
                                                                } else {
                                                                    let _e2484 = local.len;
                                                                    local.len = (_e2484 - 1u);
                                                                    let _e2487 = local.len;
                                                                    if (_e2487 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2492 = local.first[(0u + _e2487)];
                                                                    local.group = _e2492;
                                                                    let _e2495 = local.len;
                                                                    if (_e2495 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2500 = local.mask[(0u + _e2495)];
                                                                    local.group_mask = _e2500;
                                                                    phi_2779_ = true;
                                                                }
                                                                let _e2503 = phi_2779_;
                                                                phi_2780_ = _e2503;
                                                            } else {
                                                                phi_2780_ = true;
                                                            }
                                                            let _e2505 = phi_2780_;
                                                            if _e2505 {
                                                                let _e2507 = local.group_mask;
                                                                let _e2513 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2507)), 32u, (_e2507 == 0u)));
                                                                let _e2517 = local.group_mask;
                                                                let _e2531 = local.group_mask;
                                                                local.group_mask = (_e2531 & ~((1u << bitcast<u32>((_e2513 & 31u)))));
                                                                let _e2534 = local.group;
                                                                phi_2811_ = (_e2534 + countOneBits(((_e2517 & ~((4294967295u << bitcast<u32>((((_e2513 - 24u) ^ _e1381) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_2811_ = 4294967295u;
                                                            }
                                                            let _e2537 = phi_2811_;
                                                            let _e3712 = local_8;
                                                            phi_1763_ = _e3712;
                                                            phi_1766_ = _e2537;
                                                        } else {
                                                            phi_1763_ = lt_bvh_Hit();
                                                            phi_1766_ = u32();
                                                        }
                                                        let _e2539 = phi_1763_;
                                                        let _e2541 = phi_1766_;
                                                        continue;
                                                        continuing {
                                                            phi_1762_ = _e2539;
                                                            phi_1765_ = _e2541;
                                                            break if !(_e1522);
                                                        }
                                                    }
                                                    let _e3716 = local_9;
                                                    phi_2812_ = _e3716;
                                                }
                                                let _e2544 = phi_2812_;
                                                phi_2813_ = _e2544;
                                                phi_2814_ = _e1203;
                                            } else {
                                                phi_2813_ = lt_bvh_Hit();
                                                phi_2814_ = true;
                                            }
                                            let _e2546 = phi_2813_;
                                            let _e2548 = phi_2814_;
                                            if _e2548 {
                                                phi_2818_ = _e980;
                                            } else {
                                                phi_2818_ = _e2546;
                                            }
                                            let _e2550 = phi_2818_;
                                            phi_2819_ = _e2550;
                                        } else {
                                            phi_2819_ = _e980;
                                        }
                                        let _e2552 = phi_2819_;
                                        phi_2820_ = _e2552;
                                    } else {
                                        phi_2820_ = _e980;
                                    }
                                    let _e2554 = phi_2820_;
                                    phi_2821_ = _e2554;
                                } else {
                                    phi_2821_ = _e980;
                                }
                                let _e2556 = phi_2821_;
                                phi_1130_ = (_e978 & (_e978 - 1u));
                                phi_1133_ = _e2556;
                                phi_2822_ = true;
                            }
                            let _e2558 = phi_1130_;
                            let _e2560 = phi_1133_;
                            let _e2562 = phi_2822_;
                            continue;
                            continuing {
                                phi_1129_ = _e2558;
                                phi_1132_ = _e2560;
                                break if !(_e2562);
                            }
                        }
                        let _e2565 = local_1.group_mask;
                        if ((_e2565 & 4278190080u) == 0u) {
                            let _e2569 = local_1.len;
                            if (_e2569 == 0u) {
                                phi_2861_ = false;
                            } else {
                                let _e2573 = local_1.len;
                                local_1.len = (_e2573 - 1u);
                                let _e2576 = local_1.len;
                                if (_e2576 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2581 = local_1.first[(0u + _e2576)];
                                local_1.group = _e2581;
                                let _e2584 = local_1.len;
                                if (_e2584 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2589 = local_1.mask[(0u + _e2584)];
                                local_1.group_mask = _e2589;
                                phi_2861_ = true;
                            }
                            let _e2592 = phi_2861_;
                            phi_2862_ = _e2592;
                        } else {
                            phi_2862_ = true;
                        }
                        let _e2594 = phi_2862_;
                        if _e2594 {
                            let _e2596 = local_1.group_mask;
                            let _e2602 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2596)), 32u, (_e2596 == 0u)));
                            let _e2606 = local_1.group_mask;
                            let _e2620 = local_1.group_mask;
                            local_1.group_mask = (_e2620 & ~((1u << bitcast<u32>((_e2602 & 31u)))));
                            let _e2623 = local_1.group;
                            phi_2893_ = (_e2623 + countOneBits(((_e2606 & ~((4294967295u << bitcast<u32>((((_e2602 - 24u) ^ _e397) & 31u))))) & 255u)));
                        } else {
                            phi_2893_ = 4294967295u;
                        }
                        let _e2626 = phi_2893_;
                        phi_793_ = _e2626;
                        let _e3732 = local_10;
                        phi_796_ = _e3732;
                    } else {
                        phi_793_ = u32();
                        phi_796_ = lt_bvh_Hit();
                    }
                    let _e2628 = phi_793_;
                    let _e2630 = phi_796_;
                    continue;
                    continuing {
                        phi_792_ = _e2628;
                        phi_795_ = _e2630;
                        break if !(_e538);
                    }
                }
                let _e3735 = local_11;
                phi_2894_ = _e3735;
            }
            let _e2633 = phi_2894_;
            phi_2895_ = _e2633;
            phi_2896_ = _e235;
        } else {
            phi_2895_ = lt_bvh_Hit();
            phi_2896_ = true;
        }
        let _e2635 = phi_2895_;
        let _e2637 = phi_2896_;
        if _e2637 {
            phi_2900_ = _e173;
        } else {
            phi_2900_ = _e2635;
        }
        let _e2639 = phi_2900_;
        if (_e2639.triangle != 4294967295u) {
            let _e2645 = ((1f - _e2639.u) - _e2639.v);
            if (_e2639.triangle < _e73) {
            } else {
                return;
            }
            let _e2651 = triangles.member[(0u + _e2639.triangle)];
            if (_e2639.instance < _e85) {
            } else {
                return;
            }
            let _e2662 = instances.member[(0u + _e2639.instance)].object_to_world[0u];
            let _e2673 = ((((_e2662.x * _e2651.v0_.x) + (_e2662.y * _e2651.v0_.y)) + (_e2662.z * _e2651.v0_.z)) + (_e2662.w * 1f));
            let _e2675 = instances.member[(0u + _e2639.instance)].object_to_world[1u];
            let _e2686 = ((((_e2675.x * _e2651.v0_.x) + (_e2675.y * _e2651.v0_.y)) + (_e2675.z * _e2651.v0_.z)) + (_e2675.w * 1f));
            let _e2688 = instances.member[(0u + _e2639.instance)].object_to_world[2u];
            let _e2699 = ((((_e2688.x * _e2651.v0_.x) + (_e2688.y * _e2651.v0_.y)) + (_e2688.z * _e2651.v0_.z)) + (_e2688.w * 1f));
            let _e2706 = instances.member[(0u + _e2639.instance)].object_to_world[0u];
            let _e2717 = ((((_e2706.x * _e2651.v1_.x) + (_e2706.y * _e2651.v1_.y)) + (_e2706.z * _e2651.v1_.z)) + (_e2706.w * 1f));
            let _e2719 = instances.member[(0u + _e2639.instance)].object_to_world[1u];
            let _e2730 = ((((_e2719.x * _e2651.v1_.x) + (_e2719.y * _e2651.v1_.y)) + (_e2719.z * _e2651.v1_.z)) + (_e2719.w * 1f));
            let _e2732 = instances.member[(0u + _e2639.instance)].object_to_world[2u];
            let _e2743 = ((((_e2732.x * _e2651.v1_.x) + (_e2732.y * _e2651.v1_.y)) + (_e2732.z * _e2651.v1_.z)) + (_e2732.w * 1f));
            let _e2750 = instances.member[(0u + _e2639.instance)].object_to_world[0u];
            let _e2761 = ((((_e2750.x * _e2651.v2_.x) + (_e2750.y * _e2651.v2_.y)) + (_e2750.z * _e2651.v2_.z)) + (_e2750.w * 1f));
            let _e2763 = instances.member[(0u + _e2639.instance)].object_to_world[1u];
            let _e2774 = ((((_e2763.x * _e2651.v2_.x) + (_e2763.y * _e2651.v2_.y)) + (_e2763.z * _e2651.v2_.z)) + (_e2763.w * 1f));
            let _e2776 = instances.member[(0u + _e2639.instance)].object_to_world[2u];
            let _e2787 = ((((_e2776.x * _e2651.v2_.x) + (_e2776.y * _e2651.v2_.y)) + (_e2776.z * _e2651.v2_.z)) + (_e2776.w * 1f));
            let _e2800 = (((_e2673 * _e2645) + (_e2717 * _e2639.u)) + (_e2761 * _e2639.v));
            let _e2801 = (((_e2686 * _e2645) + (_e2730 * _e2639.u)) + (_e2774 * _e2639.v));
            let _e2802 = (((_e2699 * _e2645) + (_e2743 * _e2639.u)) + (_e2787 * _e2639.v));
            let _e2804 = abs(_e2673);
            let _e2805 = abs(_e2686);
            let _e2806 = abs(_e2699);
            let _e2807 = abs(_e2717);
            let _e2808 = abs(_e2730);
            let _e2809 = abs(_e2743);
            if (_e2804 > _e2807) {
                phi_3088_ = _e2804;
            } else {
                phi_3088_ = _e2807;
            }
            let _e2812 = phi_3088_;
            if (_e2805 > _e2808) {
                phi_3093_ = _e2805;
            } else {
                phi_3093_ = _e2808;
            }
            let _e2815 = phi_3093_;
            if (_e2806 > _e2809) {
                phi_3098_ = _e2806;
            } else {
                phi_3098_ = _e2809;
            }
            let _e2818 = phi_3098_;
            let _e2819 = abs(_e2761);
            let _e2820 = abs(_e2774);
            let _e2821 = abs(_e2787);
            if (_e2812 > _e2819) {
                phi_3106_ = _e2812;
            } else {
                phi_3106_ = _e2819;
            }
            let _e2824 = phi_3106_;
            if (_e2815 > _e2820) {
                phi_3111_ = _e2815;
            } else {
                phi_3111_ = _e2820;
            }
            let _e2827 = phi_3111_;
            if (_e2818 > _e2821) {
                phi_3116_ = _e2818;
            } else {
                phi_3116_ = _e2821;
            }
            let _e2830 = phi_3116_;
            let _e2831 = (_e2717 - _e2673);
            let _e2832 = (_e2730 - _e2686);
            let _e2833 = (_e2743 - _e2699);
            let _e2834 = (_e2761 - _e2673);
            let _e2835 = (_e2774 - _e2686);
            let _e2836 = (_e2787 - _e2699);
            let _e2840 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2832), abs(_e2833));
            let _e2841 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2831), _e2840);
            let _e2842 = (_e2831 / _e2841);
            let _e2843 = (_e2832 / _e2841);
            let _e2844 = (_e2833 / _e2841);
            let _e2848 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2835), abs(_e2836));
            let _e2849 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2834), _e2848);
            let _e2850 = (_e2834 / _e2849);
            let _e2851 = (_e2835 / _e2849);
            let _e2852 = (_e2836 / _e2849);
            let _e2855 = ((_e2843 * _e2852) - (_e2851 * _e2844));
            let _e2858 = ((_e2844 * _e2850) - (_e2852 * _e2842));
            let _e2861 = ((_e2842 * _e2851) - (_e2850 * _e2843));
            let _e2863 = p.member.eye;
            let _e2876 = (1f / sqrt((((_e2855 * _e2855) + (_e2858 * _e2858)) + (_e2861 * _e2861))));
            let _e2877 = (_e2855 * _e2876);
            let _e2878 = (_e2858 * _e2876);
            let _e2879 = (_e2861 * _e2876);
            if ((((_e2877 * (_e2863.x - _e2800)) + (_e2878 * (_e2863.y - _e2801))) + (_e2879 * (_e2863.z - _e2802))) < 0f) {
                phi_3180_ = vec3<f32>(-(_e2877), -(_e2878), -(_e2879));
            } else {
                phi_3180_ = vec3<f32>(_e2877, _e2878, _e2879);
            }
            let _e2892 = phi_3180_;
            if (_e2639.triangle < _e73) {
            } else {
                return;
            }
            let _e2897 = triangles.member[(0u + _e2639.triangle)];
            let _e2899 = (_e2897.i0_ & 2147483647u);
            if (_e2899 < _e76) {
            } else {
                return;
            }
            let _e2905 = vertices.member[(0u + _e2899)];
            if (_e2897.i1_ < _e76) {
            } else {
                return;
            }
            let _e2909 = vertices.member[(0u + _e2897.i1_)];
            if (_e2897.i2_ < _e76) {
            } else {
                return;
            }
            let _e2913 = vertices.member[(0u + _e2897.i2_)];
            let _e2914 = array<abi_Vertex, 3>(_e2905, _e2909, _e2913);
            if (_e2914[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e2920 = materials.member[(0u + _e2914[0].material)];
            let _e2937 = (1f / 255f);
            let _e2956 = (1f / 255f);
            let _e2978 = (1f / 255f);
            let _e2991 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e2645, _e2639.u, _e2639.v));
            let _e2993 = ((_e2920.base_color.x * ((((f32((_e2914[0].color & 255u)) * _e2937) * _e2645) + ((f32((_e2914[1].color & 255u)) * _e2956) * _e2639.u)) + ((f32((_e2914[2].color & 255u)) * _e2978) * _e2639.v))) * _e2991.x);
            let _e2995 = ((_e2920.base_color.y * ((((f32(((_e2914[0].color >> bitcast<u32>(8i)) & 255u)) * _e2937) * _e2645) + ((f32(((_e2914[1].color >> bitcast<u32>(8i)) & 255u)) * _e2956) * _e2639.u)) + ((f32(((_e2914[2].color >> bitcast<u32>(8i)) & 255u)) * _e2978) * _e2639.v))) * _e2991.y);
            let _e2997 = ((_e2920.base_color.z * ((((f32(((_e2914[0].color >> bitcast<u32>(16i)) & 255u)) * _e2937) * _e2645) + ((f32(((_e2914[1].color >> bitcast<u32>(16i)) & 255u)) * _e2956) * _e2639.u)) + ((f32(((_e2914[2].color >> bitcast<u32>(16i)) & 255u)) * _e2978) * _e2639.v))) * _e2991.z);
            let _e2998 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2827, _e2830);
            let _e2999 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2824, _e2998);
            if ((_e2920.flags & 2u) == 0u) {
                phi_3301_ = 0u;
            } else {
                phi_3301_ = 1u;
            }
            let _e3004 = phi_3301_;
            if (_e2914[0].normal == 2147516416u) {
                phi_3531_ = _e2892;
            } else {
                let _e3017 = (f32((bitcast<i32>((_e2914[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3023 = (f32((bitcast<i32>(_e2914[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3027 = ((1f - abs(_e3017)) - abs(_e3023));
                if (_e3027 < 0f) {
                    phi_3328_ = -(_e3027);
                } else {
                    phi_3328_ = 0f;
                }
                let _e3031 = phi_3328_;
                if (_e3017 < 0f) {
                    phi_3335_ = (_e3017 + _e3031);
                } else {
                    phi_3335_ = (_e3017 - _e3031);
                }
                let _e3036 = phi_3335_;
                if (_e3023 < 0f) {
                    phi_3342_ = (_e3023 + _e3031);
                } else {
                    phi_3342_ = (_e3023 - _e3031);
                }
                let _e3041 = phi_3342_;
                let _e3048 = (1f / sqrt((((_e3036 * _e3036) + (_e3041 * _e3041)) + (_e3027 * _e3027))));
                let _e3064 = (f32((bitcast<i32>((_e2914[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3070 = (f32((bitcast<i32>(_e2914[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3074 = ((1f - abs(_e3064)) - abs(_e3070));
                if (_e3074 < 0f) {
                    phi_3377_ = -(_e3074);
                } else {
                    phi_3377_ = 0f;
                }
                let _e3078 = phi_3377_;
                if (_e3064 < 0f) {
                    phi_3384_ = (_e3064 + _e3078);
                } else {
                    phi_3384_ = (_e3064 - _e3078);
                }
                let _e3083 = phi_3384_;
                if (_e3070 < 0f) {
                    phi_3391_ = (_e3070 + _e3078);
                } else {
                    phi_3391_ = (_e3070 - _e3078);
                }
                let _e3088 = phi_3391_;
                let _e3095 = (1f / sqrt((((_e3083 * _e3083) + (_e3088 * _e3088)) + (_e3074 * _e3074))));
                let _e3114 = (f32((bitcast<i32>((_e2914[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3120 = (f32((bitcast<i32>(_e2914[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3124 = ((1f - abs(_e3114)) - abs(_e3120));
                if (_e3124 < 0f) {
                    phi_3429_ = -(_e3124);
                } else {
                    phi_3429_ = 0f;
                }
                let _e3128 = phi_3429_;
                if (_e3114 < 0f) {
                    phi_3436_ = (_e3114 + _e3128);
                } else {
                    phi_3436_ = (_e3114 - _e3128);
                }
                let _e3133 = phi_3436_;
                if (_e3120 < 0f) {
                    phi_3443_ = (_e3120 + _e3128);
                } else {
                    phi_3443_ = (_e3120 - _e3128);
                }
                let _e3138 = phi_3443_;
                let _e3145 = (1f / sqrt((((_e3133 * _e3133) + (_e3138 * _e3138)) + (_e3124 * _e3124))));
                let _e3152 = ((((_e3036 * _e3048) * _e2645) + ((_e3083 * _e3095) * _e2639.u)) + ((_e3133 * _e3145) * _e2639.v));
                let _e3153 = ((((_e3041 * _e3048) * _e2645) + ((_e3088 * _e3095) * _e2639.u)) + ((_e3138 * _e3145) * _e2639.v));
                let _e3154 = ((((_e3027 * _e3048) * _e2645) + ((_e3074 * _e3095) * _e2639.u)) + ((_e3124 * _e3145) * _e2639.v));
                if (_e2639.instance < _e85) {
                } else {
                    return;
                }
                let _e3161 = instances.member[(0u + _e2639.instance)].world_to_object[0u];
                let _e3170 = instances.member[(0u + _e2639.instance)].world_to_object[1u];
                let _e3182 = instances.member[(0u + _e2639.instance)].world_to_object[2u];
                let _e3189 = (((_e3161.x * _e3152) + (_e3170.x * _e3153)) + (_e3182.x * _e3154));
                let _e3190 = (((_e3161.y * _e3152) + (_e3170.y * _e3153)) + (_e3182.y * _e3154));
                let _e3191 = (((_e3161.z * _e3152) + (_e3170.z * _e3153)) + (_e3182.z * _e3154));
                let _e3197 = sqrt((((_e3189 * _e3189) + (_e3190 * _e3190)) + (_e3191 * _e3191)));
                if (_e3197 > 0f) {
                    let _e3199 = (_e3189 / _e3197);
                    let _e3200 = (_e3190 / _e3197);
                    let _e3201 = (_e3191 / _e3197);
                    if ((((_e3199 * _e2892.x) + (_e3200 * _e2892.y)) + (_e3201 * _e2892.z)) < 0f) {
                        phi_3529_ = vec3<f32>(-(_e3199), -(_e3200), -(_e3201));
                    } else {
                        phi_3529_ = vec3<f32>(_e3199, _e3200, _e3201);
                    }
                    let _e3217 = phi_3529_;
                    phi_3530_ = _e3217;
                } else {
                    phi_3530_ = _e2892;
                }
                let _e3219 = phi_3530_;
                phi_3531_ = _e3219;
            }
            let _e3221 = phi_3531_;
            if (_e2993 > 0f) {
                if (_e2993 < 1f) {
                    phi_3540_ = _e2993;
                } else {
                    phi_3540_ = 1f;
                }
                let _e3225 = phi_3540_;
                phi_3541_ = _e3225;
            } else {
                phi_3541_ = 0f;
            }
            let _e3227 = phi_3541_;
            if (_e2995 > 0f) {
                if (_e2995 < 1f) {
                    phi_3551_ = _e2995;
                } else {
                    phi_3551_ = 1f;
                }
                let _e3232 = phi_3551_;
                phi_3552_ = _e3232;
            } else {
                phi_3552_ = 0f;
            }
            let _e3234 = phi_3552_;
            if (_e2997 > 0f) {
                if (_e2997 < 1f) {
                    phi_3562_ = _e2997;
                } else {
                    phi_3562_ = 1f;
                }
                let _e3239 = phi_3562_;
                phi_3563_ = _e3239;
            } else {
                phi_3563_ = 0f;
            }
            let _e3241 = phi_3563_;
            let _e3244 = ((sqrt(_e3227) * 255f) + 0.5f);
            let _e3253 = ((sqrt(_e3234) * 255f) + 0.5f);
            let _e3265 = ((sqrt(_e3241) * 255f) + 0.5f);
            phi_3598_ = abi_Sample(vec3<f32>(_e2800, _e2801, _e2802), _e2999, _e2892, _e3004, _e3221, ((select(select(u32(_e3244), 0u, (_e3244 < bitcast<f32>(0u))), 4294967295u, (_e3244 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3253), 0u, (_e3253 < bitcast<f32>(0u))), 4294967295u, (_e3253 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3265), 0u, (_e3265 < bitcast<f32>(0u))), 4294967295u, (_e3265 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_3598_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3279 = phi_3598_;
        if (_e97.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e97.shift)] = _e3279;
        if (_e2639.triangle != 4294967295u) {
            let _e3288 = ((1f - _e2639.u) - _e2639.v);
            if (_e2639.triangle < _e73) {
            } else {
                return;
            }
            let _e3293 = triangles.member[(0u + _e2639.triangle)];
            let _e3295 = (_e3293.i0_ & 2147483647u);
            if (_e3295 < _e88) {
            } else {
                return;
            }
            let _e3301 = before.member[(0u + _e3295)];
            if (_e3293.i1_ < _e88) {
            } else {
                return;
            }
            let _e3305 = before.member[(0u + _e3293.i1_)];
            if (_e3293.i2_ < _e88) {
            } else {
                return;
            }
            let _e3309 = before.member[(0u + _e3293.i2_)];
            if (_e2639.instance < _e85) {
            } else {
                return;
            }
            let _e3319 = instances.member[(0u + _e2639.instance)].object_to_world[0u];
            let _e3332 = instances.member[(0u + _e2639.instance)].object_to_world[1u];
            let _e3345 = instances.member[(0u + _e2639.instance)].object_to_world[2u];
            if (_e2639.instance < _e85) {
            } else {
                return;
            }
            let _e3369 = instances.member[(0u + _e2639.instance)].object_to_world[0u];
            let _e3382 = instances.member[(0u + _e2639.instance)].object_to_world[1u];
            let _e3395 = instances.member[(0u + _e2639.instance)].object_to_world[2u];
            if (_e2639.instance < _e85) {
            } else {
                return;
            }
            let _e3422 = instances.member[(0u + _e2639.instance)].object_to_world[0u];
            let _e3435 = instances.member[(0u + _e2639.instance)].object_to_world[1u];
            let _e3448 = instances.member[(0u + _e2639.instance)].object_to_world[2u];
            phi_3821_ = vec3<f32>((((((((_e3319.x * _e3301.x) + (_e3319.y * _e3301.y)) + (_e3319.z * _e3301.z)) + (_e3319.w * 1f)) * _e3288) + (((((_e3369.x * _e3305.x) + (_e3369.y * _e3305.y)) + (_e3369.z * _e3305.z)) + (_e3369.w * 1f)) * _e2639.u)) + (((((_e3422.x * _e3309.x) + (_e3422.y * _e3309.y)) + (_e3422.z * _e3309.z)) + (_e3422.w * 1f)) * _e2639.v)), (((((((_e3332.x * _e3301.x) + (_e3332.y * _e3301.y)) + (_e3332.z * _e3301.z)) + (_e3332.w * 1f)) * _e3288) + (((((_e3382.x * _e3305.x) + (_e3382.y * _e3305.y)) + (_e3382.z * _e3305.z)) + (_e3382.w * 1f)) * _e2639.u)) + (((((_e3435.x * _e3309.x) + (_e3435.y * _e3309.y)) + (_e3435.z * _e3309.z)) + (_e3435.w * 1f)) * _e2639.v)), (((((((_e3345.x * _e3301.x) + (_e3345.y * _e3301.y)) + (_e3345.z * _e3301.z)) + (_e3345.w * 1f)) * _e3288) + (((((_e3395.x * _e3305.x) + (_e3395.y * _e3305.y)) + (_e3395.z * _e3305.z)) + (_e3395.w * 1f)) * _e2639.u)) + (((((_e3448.x * _e3309.x) + (_e3448.y * _e3309.y)) + (_e3448.z * _e3309.z)) + (_e3448.w * 1f)) * _e2639.v)));
        } else {
            phi_3821_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e3468 = phi_3821_;
        if (_e97.shift < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e97.shift)] = vec4<f32>(_e3468.x, _e3468.y, _e3468.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
