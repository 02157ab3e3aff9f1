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
    var phi_203_: lt_mask_LightPlace;
    var phi_204_: bool;
    var phi_205_: lt_mask_LightPlace;
    var phi_206_: bool;
    var phi_211_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_203_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_204_ = false;
        } else {
            phi_203_ = lt_mask_LightPlace();
            phi_204_ = true;
        }
        let _e76 = phi_203_;
        let _e78 = phi_204_;
        phi_205_ = _e76;
        phi_206_ = _e78;
    } else {
        phi_205_ = lt_mask_LightPlace();
        phi_206_ = true;
    }
    let _e80 = phi_205_;
    let _e82 = phi_206_;
    if _e82 {
        phi_211_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_211_ = _e80;
    }
    let _e87 = phi_211_;
    return lt_mask_LightPlace(_e87.word, _e87.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_226_: bool;
    var phi_230_: f32;

    if (param_3 != param_3) {
        phi_226_ = true;
    } else {
        let _e66 = (param_4 >= param_3);
        if _e66 {
        }
        phi_226_ = _e66;
    }
    let _e68 = phi_226_;
    if _e68 {
        phi_230_ = param_4;
    } else {
        phi_230_ = param_3;
    }
    let _e70 = phi_230_;
    return _e70;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_242_: bool;
    var phi_246_: f32;

    if (param_5 != param_5) {
        phi_242_ = true;
    } else {
        let _e66 = (param_6 <= param_5);
        if _e66 {
        }
        phi_242_ = _e66;
    }
    let _e68 = phi_242_;
    if _e68 {
        phi_246_ = param_6;
    } else {
        phi_246_ = param_5;
    }
    let _e70 = phi_246_;
    return _e70;
}

fn _lt_bvh_ray_Ray_new(param_7: vec3<f32>, param_8: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_7, 0f, param_8, 300000000000000000000000000000000000000f);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_9: f32, param_10: f32) -> f32 {
    var phi_258_: f32;

    if (param_9 > param_10) {
        phi_258_ = param_9;
    } else {
        phi_258_ = param_10;
    }
    let _e67 = phi_258_;
    return _e67;
}

fn _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(param_11: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(1f, 1f, 1f);
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: lt_bvh_traverse_Stack;
    var phi_410_: bool;
    var phi_411_: bool;
    var phi_412_: bool;
    var phi_416_: bool;
    var phi_417_: bool;
    var phi_418_: bool;
    var phi_419_: bool;
    var phi_420_: bool;
    var phi_421_: bool;
    var phi_422_: bool;
    var phi_423_: bool;
    var phi_424_: bool;
    var phi_425_: bool;
    var phi_426_: bool;
    var phi_427_: bool;
    var phi_428_: bool;
    var phi_429_: bool;
    var phi_430_: bool;
    var phi_431_: bool;
    var phi_432_: bool;
    var phi_433_: bool;
    var phi_437_: bool;
    var phi_441_: bool;
    var phi_516_: f32;
    var phi_523_: f32;
    var phi_531_: f32;
    var phi_538_: f32;
    var phi_546_: f32;
    var phi_553_: f32;
    var phi_578_: f32;
    var phi_583_: f32;
    var phi_588_: f32;
    var phi_610_: u32;
    var phi_615_: u32;
    var phi_620_: u32;
    var phi_734_: bool;
    var phi_735_: bool;
    var phi_766_: u32;
    var phi_768_: u32;
    var phi_771_: lt_bvh_Hit;
    var phi_856_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_883_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_910_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_916_: u32;
    var phi_919_: u32;
    var phi_933_: u32;
    var phi_943_: u32;
    var phi_953_: u32;
    var phi_971_: u32;
    var phi_981_: u32;
    var phi_991_: u32;
    var phi_1027_: u32;
    var phi_1040_: u32;
    var phi_1045_: u32;
    var phi_1046_: u32;
    var phi_1047_: u32;
    var phi_917_: u32;
    var phi_920_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1105_: u32;
    var phi_1108_: lt_bvh_Hit;
    var phi_1163_: f32;
    var phi_1168_: f32;
    var phi_1173_: f32;
    var phi_1181_: f32;
    var phi_1186_: f32;
    var phi_1191_: f32;
    var phi_1347_: bool;
    var phi_1348_: bool;
    var phi_1349_: bool;
    var phi_1353_: bool;
    var phi_1354_: bool;
    var phi_1355_: bool;
    var phi_1356_: bool;
    var phi_1357_: bool;
    var phi_1358_: bool;
    var phi_1359_: bool;
    var phi_1360_: bool;
    var phi_1361_: bool;
    var phi_1362_: bool;
    var phi_1363_: bool;
    var phi_1364_: bool;
    var phi_1365_: bool;
    var phi_1366_: bool;
    var phi_1367_: bool;
    var phi_1368_: bool;
    var phi_1369_: bool;
    var phi_1370_: bool;
    var phi_1374_: bool;
    var phi_1378_: bool;
    var phi_1448_: f32;
    var phi_1455_: f32;
    var phi_1462_: f32;
    var phi_1469_: f32;
    var phi_1476_: f32;
    var phi_1483_: f32;
    var phi_1500_: f32;
    var phi_1505_: f32;
    var phi_1510_: f32;
    var phi_1538_: bool;
    var phi_1539_: bool;
    var phi_1547_: u32;
    var phi_1548_: u32;
    var phi_1559_: vec3<f32>;
    var phi_1560_: vec3<f32>;
    var phi_1573_: u32;
    var phi_1578_: u32;
    var phi_1583_: u32;
    var phi_1697_: bool;
    var phi_1698_: bool;
    var phi_1729_: u32;
    var phi_1731_: lt_bvh_Hit;
    var phi_1734_: u32;
    var phi_1815_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1842_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1869_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1875_: u32;
    var phi_1878_: u32;
    var phi_1892_: u32;
    var phi_1902_: u32;
    var phi_1912_: u32;
    var phi_1930_: u32;
    var phi_1940_: u32;
    var phi_1950_: u32;
    var phi_1986_: u32;
    var phi_1999_: u32;
    var phi_2004_: u32;
    var phi_2005_: u32;
    var phi_2006_: u32;
    var phi_1876_: u32;
    var phi_1879_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_2064_: lt_bvh_Hit;
    var phi_2067_: u32;
    var phi_2111_: vec3<f32>;
    var phi_2112_: vec3<f32>;
    var phi_2141_: vec3<f32>;
    var phi_2142_: vec3<f32>;
    var phi_2171_: vec3<f32>;
    var phi_2172_: vec3<f32>;
    var phi_2190_: bool;
    var phi_2191_: bool;
    var phi_2195_: f32;
    var phi_2196_: f32;
    var phi_2197_: f32;
    var phi_2198_: f32;
    var phi_2206_: f32;
    var phi_2216_: bool;
    var phi_2217_: bool;
    var phi_2221_: f32;
    var phi_2222_: f32;
    var phi_2223_: f32;
    var phi_2224_: f32;
    var phi_2232_: f32;
    var phi_2242_: bool;
    var phi_2243_: bool;
    var phi_2247_: f32;
    var phi_2248_: f32;
    var phi_2249_: f32;
    var phi_2250_: f32;
    var phi_2258_: f32;
    var phi_2273_: f32;
    var phi_2274_: bool;
    var phi_2275_: f32;
    var phi_2276_: bool;
    var phi_2277_: f32;
    var phi_2278_: bool;
    var phi_2296_: f32;
    var phi_2297_: bool;
    var phi_2298_: bool;
    var phi_2299_: f32;
    var phi_2300_: bool;
    var phi_2301_: bool;
    var phi_2305_: bool;
    var phi_2306_: f32;
    var phi_2307_: bool;
    var phi_2335_: vec3<f32>;
    var phi_2336_: vec3<f32>;
    var phi_2361_: vec3<f32>;
    var phi_2362_: vec3<f32>;
    var phi_2387_: vec3<f32>;
    var phi_2388_: vec3<f32>;
    var phi_2444_: f32;
    var phi_2453_: f32;
    var phi_2462_: f32;
    var phi_2471_: f32;
    var phi_2478_: f32;
    var phi_2485_: f32;
    var phi_2498_: f32;
    var phi_2507_: f32;
    var phi_2516_: f32;
    var phi_2525_: f32;
    var phi_2532_: f32;
    var phi_2539_: f32;
    var phi_2556_: f32;
    var phi_2561_: f32;
    var phi_2566_: f32;
    var phi_2574_: f32;
    var phi_2579_: f32;
    var phi_2584_: f32;
    var phi_2596_: f32;
    var phi_2601_: f32;
    var phi_2606_: f32;
    var phi_2611_: f32;
    var phi_2616_: lt_bvh_triangle_Intersection;
    var phi_2617_: bool;
    var phi_2618_: lt_bvh_triangle_Intersection;
    var phi_2619_: bool;
    var phi_2623_: lt_bvh_triangle_Intersection;
    var phi_2624_: bool;
    var phi_2625_: lt_bvh_triangle_Intersection;
    var phi_2626_: bool;
    var phi_2627_: bool;
    var phi_2631_: bool;
    var phi_2635_: lt_bvh_triangle_Intersection;
    var phi_2673_: bool;
    var phi_2674_: bool;
    var phi_2675_: bool;
    var phi_2676_: bool;
    var phi_2677_: bool;
    var phi_2678_: bool;
    var phi_2682_: bool;
    var phi_2683_: bool;
    var phi_2697_: bool;
    var phi_2705_: lt_bvh_Hit;
    var phi_2706_: lt_bvh_Hit;
    var phi_2707_: lt_bvh_Hit;
    var phi_2708_: lt_bvh_Hit;
    var phi_2065_: lt_bvh_Hit;
    var phi_2068_: u32;
    var phi_2709_: bool;
    var phi_2748_: bool;
    var phi_2749_: bool;
    var phi_2780_: u32;
    var phi_1732_: lt_bvh_Hit;
    var phi_1735_: u32;
    var phi_2781_: lt_bvh_Hit;
    var phi_2782_: lt_bvh_Hit;
    var phi_2783_: bool;
    var phi_2787_: lt_bvh_Hit;
    var phi_2788_: lt_bvh_Hit;
    var phi_2789_: lt_bvh_Hit;
    var phi_2790_: lt_bvh_Hit;
    var phi_1106_: u32;
    var phi_1109_: lt_bvh_Hit;
    var phi_2791_: bool;
    var phi_2830_: bool;
    var phi_2831_: bool;
    var phi_2862_: u32;
    var phi_769_: u32;
    var phi_772_: lt_bvh_Hit;
    var phi_2863_: lt_bvh_Hit;
    var phi_2864_: lt_bvh_Hit;
    var phi_2865_: bool;
    var phi_2869_: lt_bvh_Hit;
    var phi_3057_: f32;
    var phi_3062_: f32;
    var phi_3067_: f32;
    var phi_3075_: f32;
    var phi_3080_: f32;
    var phi_3085_: f32;
    var phi_3149_: vec3<f32>;
    var phi_3270_: u32;
    var phi_3297_: f32;
    var phi_3304_: f32;
    var phi_3311_: f32;
    var phi_3346_: f32;
    var phi_3353_: f32;
    var phi_3360_: f32;
    var phi_3398_: f32;
    var phi_3405_: f32;
    var phi_3412_: f32;
    var phi_3498_: vec3<f32>;
    var phi_3499_: vec3<f32>;
    var phi_3500_: vec3<f32>;
    var phi_3509_: f32;
    var phi_3510_: f32;
    var phi_3520_: f32;
    var phi_3521_: f32;
    var phi_3531_: f32;
    var phi_3532_: f32;
    var phi_3567_: abi_Sample;
    var phi_3790_: vec3<f32>;
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
        let _e165 = abs(_e153.direction.x);
        let _e167 = abs(_e153.direction.y);
        let _e169 = abs(_e153.direction.z);
        if (abs(_e153.origin.x) < 1000000000000000f) {
            if (abs(_e153.origin.y) < 1000000000000000f) {
                if (abs(_e153.origin.z) < 1000000000000000f) {
                    if (_e165 < 1000000000000000f) {
                        if (_e167 < 1000000000000000f) {
                            if (_e169 < 1000000000000000f) {
                                if (_e165 > 0f) {
                                    phi_411_ = bool();
                                    phi_412_ = true;
                                } else {
                                    let _e177 = (_e167 > 0f);
                                    if _e177 {
                                        phi_410_ = bool();
                                    } else {
                                        phi_410_ = (_e169 > 0f);
                                    }
                                    let _e180 = phi_410_;
                                    phi_411_ = _e180;
                                    phi_412_ = _e177;
                                }
                                let _e182 = phi_411_;
                                let _e184 = phi_412_;
                                if _e184 {
                                    phi_416_ = true;
                                } else {
                                    phi_416_ = _e182;
                                }
                                let _e186 = phi_416_;
                                phi_417_ = _e186;
                                phi_418_ = false;
                            } else {
                                phi_417_ = bool();
                                phi_418_ = true;
                            }
                            let _e188 = phi_417_;
                            let _e190 = phi_418_;
                            phi_419_ = _e188;
                            phi_420_ = false;
                            phi_421_ = _e190;
                        } else {
                            phi_419_ = bool();
                            phi_420_ = true;
                            phi_421_ = false;
                        }
                        let _e192 = phi_419_;
                        let _e194 = phi_420_;
                        let _e196 = phi_421_;
                        phi_422_ = _e192;
                        phi_423_ = _e194;
                        phi_424_ = _e196;
                    } else {
                        phi_422_ = bool();
                        phi_423_ = true;
                        phi_424_ = false;
                    }
                    let _e198 = phi_422_;
                    let _e200 = phi_423_;
                    let _e202 = phi_424_;
                    phi_425_ = _e198;
                    phi_426_ = _e200;
                    phi_427_ = _e202;
                } else {
                    phi_425_ = bool();
                    phi_426_ = true;
                    phi_427_ = false;
                }
                let _e204 = phi_425_;
                let _e206 = phi_426_;
                let _e208 = phi_427_;
                phi_428_ = _e204;
                phi_429_ = _e206;
                phi_430_ = _e208;
            } else {
                phi_428_ = bool();
                phi_429_ = true;
                phi_430_ = false;
            }
            let _e210 = phi_428_;
            let _e212 = phi_429_;
            let _e214 = phi_430_;
            phi_431_ = _e210;
            phi_432_ = _e212;
            phi_433_ = _e214;
        } else {
            phi_431_ = bool();
            phi_432_ = true;
            phi_433_ = false;
        }
        let _e216 = phi_431_;
        let _e218 = phi_432_;
        let _e220 = phi_433_;
        if _e218 {
            phi_437_ = true;
        } else {
            phi_437_ = _e220;
        }
        let _e222 = phi_437_;
        if _e222 {
            phi_441_ = false;
        } else {
            phi_441_ = _e216;
        }
        let _e224 = phi_441_;
        if _e224 {
            let _e225 = (_e102 >= _e69);
            if _e225 {
                phi_2863_ = lt_bvh_Hit();
            } else {
                if (_e102 < _e69) {
                } else {
                    return;
                }
                let _e231 = nodes.member[(0u + _e102)].frame[0u];
                let _e235 = nodes.member[(0u + _e102)].frame[1u];
                let _e239 = nodes.member[(0u + _e102)].frame[2u];
                let _e243 = nodes.member[(0u + _e102)].frame[0u];
                let _e247 = nodes.member[(0u + _e102)].frame[1u];
                let _e251 = nodes.member[(0u + _e102)].frame[2u];
                let _e255 = nodes.member[(0u + _e102)].frame[3u];
                let _e293 = core_intrinsics_maximum_number_nsz_f32_(abs(_e153.direction.x), abs(_e153.direction.y));
                let _e294 = core_intrinsics_maximum_number_nsz_f32_(_e293, abs(_e153.direction.z));
                let _e295 = (_e294 * 0.0000000000009094947f);
                if (abs(_e153.direction.x) < _e295) {
                    phi_516_ = _e295;
                } else {
                    phi_516_ = abs(_e153.direction.x);
                }
                let _e302 = phi_516_;
                if (_e153.direction.x < 0f) {
                    phi_523_ = (-1f / _e302);
                } else {
                    phi_523_ = (1f / _e302);
                }
                let _e307 = phi_523_;
                if (abs(_e153.direction.y) < _e295) {
                    phi_531_ = _e295;
                } else {
                    phi_531_ = abs(_e153.direction.y);
                }
                let _e314 = phi_531_;
                if (_e153.direction.y < 0f) {
                    phi_538_ = (-1f / _e314);
                } else {
                    phi_538_ = (1f / _e314);
                }
                let _e319 = phi_538_;
                if (abs(_e153.direction.z) < _e295) {
                    phi_546_ = _e295;
                } else {
                    phi_546_ = abs(_e153.direction.z);
                }
                let _e326 = phi_546_;
                if (_e153.direction.z < 0f) {
                    phi_553_ = (-1f / _e326);
                } else {
                    phi_553_ = (1f / _e326);
                }
                let _e331 = phi_553_;
                let _e339 = abs((bitcast<f32>(_e231) - _e153.origin.x));
                let _e340 = abs((bitcast<f32>(_e235) - _e153.origin.y));
                let _e341 = abs((bitcast<f32>(_e239) - _e153.origin.z));
                let _e349 = abs(((bitcast<f32>(_e243) + (bitcast<f32>((((_e255 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e153.origin.x));
                let _e350 = abs(((bitcast<f32>(_e247) + (bitcast<f32>((((_e255 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e153.origin.y));
                let _e351 = abs(((bitcast<f32>(_e251) + (bitcast<f32>((((_e255 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e153.origin.z));
                if (_e339 > _e349) {
                    phi_578_ = _e339;
                } else {
                    phi_578_ = _e349;
                }
                let _e354 = phi_578_;
                if (_e340 > _e350) {
                    phi_583_ = _e340;
                } else {
                    phi_583_ = _e350;
                }
                let _e357 = phi_583_;
                if (_e341 > _e351) {
                    phi_588_ = _e341;
                } else {
                    phi_588_ = _e351;
                }
                let _e360 = phi_588_;
                let _e361 = core_intrinsics_maximum_number_nsz_f32_(_e354, _e357);
                let _e362 = core_intrinsics_maximum_number_nsz_f32_(_e361, _e360);
                let _e367 = (_e362 * 0.0000019073486f);
                let _e368 = (abs(_e307) * _e367);
                let _e369 = (abs(_e319) * _e367);
                let _e370 = (abs(_e331) * _e367);
                let _e374 = (_e362 * 0.0000009536743f);
                let _e375 = (abs(_e307) * _e374);
                let _e376 = (abs(_e319) * _e374);
                let _e377 = (abs(_e331) * _e374);
                if (_e307 < 0f) {
                    phi_610_ = 0u;
                } else {
                    phi_610_ = 1u;
                }
                let _e380 = phi_610_;
                if (_e319 < 0f) {
                    phi_615_ = 0u;
                } else {
                    phi_615_ = 2u;
                }
                let _e383 = phi_615_;
                if (_e331 < 0f) {
                    phi_620_ = 0u;
                } else {
                    phi_620_ = 4u;
                }
                let _e386 = phi_620_;
                let _e388 = ((_e380 | _e383) | _e386);
                let _e389 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e102, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e389.first[0], _e389.first[1], _e389.first[2], _e389.first[3], _e389.first[4], _e389.first[5], _e389.first[6], _e389.first[7], _e389.first[8], _e389.first[9], _e389.first[10], _e389.first[11], _e389.first[12], _e389.first[13], _e389.first[14], _e389.first[15], _e389.first[16], _e389.first[17], _e389.first[18], _e389.first[19], _e389.first[20], _e389.first[21], _e389.first[22], _e389.first[23], _e389.first[24], _e389.first[25], _e389.first[26], _e389.first[27], _e389.first[28], _e389.first[29], _e389.first[30], _e389.first[31]), array<u32, 32>(_e389.mask[0], _e389.mask[1], _e389.mask[2], _e389.mask[3], _e389.mask[4], _e389.mask[5], _e389.mask[6], _e389.mask[7], _e389.mask[8], _e389.mask[9], _e389.mask[10], _e389.mask[11], _e389.mask[12], _e389.mask[13], _e389.mask[14], _e389.mask[15], _e389.mask[16], _e389.mask[17], _e389.mask[18], _e389.mask[19], _e389.mask[20], _e389.mask[21], _e389.mask[22], _e389.mask[23], _e389.mask[24], _e389.mask[25], _e389.mask[26], _e389.mask[27], _e389.mask[28], _e389.mask[29], _e389.mask[30], _e389.mask[31]), _e389.len, _e389.group, _e389.group_mask);
                let _e463 = local_1.group_mask;
                if ((_e463 & 4278190080u) == 0u) {
                    let _e467 = local_1.len;
                    if (_e467 == 0u) {
                        phi_734_ = false;
                    } else {
                        let _e471 = local_1.len;
                        local_1.len = (_e471 - 1u);
                        let _e474 = local_1.len;
                        if (_e474 < 32u) {
                        } else {
                            return;
                        }
                        let _e479 = local_1.first[(0u + _e474)];
                        local_1.group = _e479;
                        let _e482 = local_1.len;
                        if (_e482 < 32u) {
                        } else {
                            return;
                        }
                        let _e487 = local_1.mask[(0u + _e482)];
                        local_1.group_mask = _e487;
                        phi_734_ = true;
                    }
                    let _e490 = phi_734_;
                    phi_735_ = _e490;
                } else {
                    phi_735_ = true;
                }
                let _e492 = phi_735_;
                if _e492 {
                    let _e494 = local_1.group_mask;
                    let _e500 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e494)), 32u, (_e494 == 0u)));
                    let _e504 = local_1.group_mask;
                    let _e518 = local_1.group_mask;
                    local_1.group_mask = (_e518 & ~((1u << bitcast<u32>((_e500 & 31u)))));
                    let _e521 = local_1.group;
                    phi_766_ = (_e521 + countOneBits(((_e504 & ~((4294967295u << bitcast<u32>((((_e500 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_766_ = 4294967295u;
                }
                let _e524 = phi_766_;
                phi_768_ = _e524;
                phi_771_ = _e155;
                loop {
                    let _e526 = phi_768_;
                    let _e528 = phi_771_;
                    local_11 = _e528;
                    let _e529 = (_e526 != 4294967295u);
                    if _e529 {
                        if (_e526 < _e69) {
                        } else {
                            return;
                        }
                        let _e537 = nodes.member[(0u + _e526)].frame[3u];
                        let _e562 = (bitcast<f32>((((_e537 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e307);
                        let _e563 = (bitcast<f32>((((_e537 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e319);
                        let _e564 = (bitcast<f32>((((_e537 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e331);
                        let _e567 = nodes.member[(0u + _e526)].frame[0u];
                        let _e571 = nodes.member[(0u + _e526)].frame[1u];
                        let _e575 = nodes.member[(0u + _e526)].frame[2u];
                        let _e583 = ((bitcast<f32>(_e567) - _e153.origin.x) * _e307);
                        let _e584 = ((bitcast<f32>(_e571) - _e153.origin.y) * _e319);
                        let _e585 = ((bitcast<f32>(_e575) - _e153.origin.z) * _e331);
                        let _e593 = nodes.member[(0u + _e526)].x;
                        if (_e307 < 0f) {
                            let _e604 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e593.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e610 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e604.unnamed.word, _e593.w), _e604.unnamed_1);
                            let _e616 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e610.unnamed, lt_mask_LightPlace(_e593.x, _e610.unnamed_1.shift));
                            phi_856_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e616.unnamed, lt_mask_LightPlace(_e616.unnamed_1.word, _e593.y));
                        } else {
                            let _e632 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e593.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e638 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e632.unnamed.word, _e593.y), _e632.unnamed_1);
                            let _e644 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e638.unnamed, lt_mask_LightPlace(_e593.z, _e638.unnamed_1.shift));
                            phi_856_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e644.unnamed, lt_mask_LightPlace(_e644.unnamed_1.word, _e593.w));
                        }
                        let _e652 = phi_856_;
                        let _e662 = nodes.member[(0u + _e526)].y;
                        if (_e319 < 0f) {
                            let _e673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e662.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e673.unnamed.word, _e662.w), _e673.unnamed_1);
                            let _e685 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e679.unnamed, lt_mask_LightPlace(_e662.x, _e679.unnamed_1.shift));
                            phi_883_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e685.unnamed, lt_mask_LightPlace(_e685.unnamed_1.word, _e662.y));
                        } else {
                            let _e701 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e662.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e707 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e701.unnamed.word, _e662.y), _e701.unnamed_1);
                            let _e713 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e707.unnamed, lt_mask_LightPlace(_e662.z, _e707.unnamed_1.shift));
                            phi_883_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e713.unnamed, lt_mask_LightPlace(_e713.unnamed_1.word, _e662.w));
                        }
                        let _e721 = phi_883_;
                        let _e731 = nodes.member[(0u + _e526)].z;
                        if (_e331 < 0f) {
                            let _e742 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e731.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e748 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e742.unnamed.word, _e731.w), _e742.unnamed_1);
                            let _e754 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e748.unnamed, lt_mask_LightPlace(_e731.x, _e748.unnamed_1.shift));
                            phi_910_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e754.unnamed, lt_mask_LightPlace(_e754.unnamed_1.word, _e731.y));
                        } else {
                            let _e770 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e731.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e776 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e770.unnamed.word, _e731.y), _e770.unnamed_1);
                            let _e782 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e776.unnamed, lt_mask_LightPlace(_e731.z, _e776.unnamed_1.shift));
                            phi_910_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e782.unnamed, lt_mask_LightPlace(_e782.unnamed_1.word, _e731.w));
                        }
                        let _e790 = phi_910_;
                        phi_916_ = 0u;
                        phi_919_ = 0u;
                        loop {
                            let _e800 = phi_916_;
                            let _e802 = phi_919_;
                            local_2 = _e802;
                            local_3 = _e802;
                            local_4 = _e802;
                            let _e803 = (_e800 < 8u);
                            if _e803 {
                                let _e805 = (_e800 >> bitcast<u32>(2i));
                                let _e806 = (_e800 & 3u);
                                if (_e805 == 0u) {
                                    phi_933_ = _e652.unnamed.word;
                                } else {
                                    phi_933_ = _e652.unnamed.shift;
                                }
                                let _e809 = phi_933_;
                                if (_e805 == 0u) {
                                    phi_943_ = _e721.unnamed.word;
                                } else {
                                    phi_943_ = _e721.unnamed.shift;
                                }
                                let _e818 = phi_943_;
                                if (_e805 == 0u) {
                                    phi_953_ = _e790.unnamed.word;
                                } else {
                                    phi_953_ = _e790.unnamed.shift;
                                }
                                let _e827 = phi_953_;
                                let _e840 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e809 >> bitcast<u32>(((_e806 * 8u) & 31u))) & 255u)) * _e562) + (_e583 - _e368)), ((f32(((_e818 >> bitcast<u32>(((_e806 * 8u) & 31u))) & 255u)) * _e563) + (_e584 - _e369)));
                                let _e841 = core_intrinsics_maximum_number_nsz_f32_(_e840, ((f32(((_e827 >> bitcast<u32>(((_e806 * 8u) & 31u))) & 255u)) * _e564) + (_e585 - _e370)));
                                if (_e805 == 0u) {
                                    phi_971_ = _e652.unnamed_1.word;
                                } else {
                                    phi_971_ = _e652.unnamed_1.shift;
                                }
                                let _e844 = phi_971_;
                                if (_e805 == 0u) {
                                    phi_981_ = _e721.unnamed_1.word;
                                } else {
                                    phi_981_ = _e721.unnamed_1.shift;
                                }
                                let _e853 = phi_981_;
                                if (_e805 == 0u) {
                                    phi_991_ = _e790.unnamed_1.word;
                                } else {
                                    phi_991_ = _e790.unnamed_1.shift;
                                }
                                let _e862 = phi_991_;
                                let _e875 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e844 >> bitcast<u32>(((_e806 * 8u) & 31u))) & 255u)) * _e562) + (_e583 + _e368)), ((f32(((_e853 >> bitcast<u32>(((_e806 * 8u) & 31u))) & 255u)) * _e563) + (_e584 + _e369)));
                                let _e876 = core_intrinsics_minimum_number_nsz_f32_(_e875, ((f32(((_e862 >> bitcast<u32>(((_e806 * 8u) & 31u))) & 255u)) * _e564) + (_e585 + _e370)));
                                if (_e841 <= _e876) {
                                    if (_e841 <= _e528.t) {
                                        if (_e876 >= _e153.tmin) {
                                            if (_e805 == 0u) {
                                                let _e883 = nodes.member[(0u + _e526)].links[2u];
                                                phi_1027_ = _e883;
                                            } else {
                                                let _e886 = nodes.member[(0u + _e526)].links[3u];
                                                phi_1027_ = _e886;
                                            }
                                            let _e888 = phi_1027_;
                                            let _e893 = ((_e888 >> bitcast<u32>(((_e806 * 8u) & 31u))) & 255u);
                                            let _e894 = (_e893 & 31u);
                                            if (_e894 >= 24u) {
                                                phi_1040_ = (24u + ((_e894 - 24u) ^ _e388));
                                            } else {
                                                phi_1040_ = _e894;
                                            }
                                            let _e900 = phi_1040_;
                                            phi_1045_ = (_e802 | ((_e893 >> bitcast<u32>(5i)) << bitcast<u32>((_e900 & 31u))));
                                        } else {
                                            phi_1045_ = _e802;
                                        }
                                        let _e908 = phi_1045_;
                                        phi_1046_ = _e908;
                                    } else {
                                        phi_1046_ = _e802;
                                    }
                                    let _e910 = phi_1046_;
                                    phi_1047_ = _e910;
                                } else {
                                    phi_1047_ = _e802;
                                }
                                let _e912 = phi_1047_;
                                phi_917_ = (_e800 + 1u);
                                phi_920_ = _e912;
                            } else {
                                phi_917_ = u32();
                                phi_920_ = u32();
                            }
                            let _e915 = phi_917_;
                            let _e917 = phi_920_;
                            continue;
                            continuing {
                                phi_916_ = _e915;
                                phi_919_ = _e917;
                                break if !(_e803);
                            }
                        }
                        let _e921 = nodes.member[(0u + _e526)].links[0u];
                        let _e925 = nodes.member[(0u + _e526)].frame[3u];
                        let _e929 = local_2;
                        if ((_e929 & 4278190080u) == 0u) {
                        } else {
                            let _e933 = local_1.group_mask;
                            if ((_e933 & 4278190080u) == 0u) {
                            } else {
                                let _e937 = local_1.len;
                                if (_e937 < 32u) {
                                    let _e940 = local_1.group;
                                    let _e942 = local_1.len;
                                    if (_e942 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e942)] = _e940;
                                    let _e948 = local_1.group_mask;
                                    let _e950 = local_1.len;
                                    if (_e950 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e950)] = _e948;
                                    let _e957 = local_1.len;
                                    local_1.len = (_e957 + 1u);
                                }
                            }
                            local_1.group = (_e102 + _e921);
                            let _e961 = local_3;
                            local_1.group_mask = ((_e961 & 4278190080u) | (_e925 >> bitcast<u32>(24i)));
                        }
                        let _e966 = local_4;
                        phi_1105_ = (_e966 & 16777215u);
                        phi_1108_ = _e528;
                        loop {
                            let _e969 = phi_1105_;
                            let _e971 = phi_1108_;
                            local_10 = _e971;
                            if (_e969 == 0u) {
                                phi_1106_ = u32();
                                phi_1109_ = lt_bvh_Hit();
                                phi_2791_ = false;
                            } else {
                                let _e975 = nodes.member[(0u + _e526)].links[1u];
                                let _e979 = (_e975 + select(firstTrailingBit(_e969), 32u, (_e969 == 0u)));
                                if (_e979 < _e84) {
                                } else {
                                    return;
                                }
                                let _e986 = instances.member[(0u + _e979)].low_world;
                                let _e988 = instances.member[(0u + _e979)].high_world;
                                let _e998 = ((_e986.x - _e153.origin.x) * _e307);
                                let _e999 = ((_e986.y - _e153.origin.y) * _e319);
                                let _e1000 = ((_e986.z - _e153.origin.z) * _e331);
                                let _e1010 = ((_e988.x - _e153.origin.x) * _e307);
                                let _e1011 = ((_e988.y - _e153.origin.y) * _e319);
                                let _e1012 = ((_e988.z - _e153.origin.z) * _e331);
                                if (_e998 < _e1010) {
                                    phi_1163_ = _e998;
                                } else {
                                    phi_1163_ = _e1010;
                                }
                                let _e1015 = phi_1163_;
                                if (_e999 < _e1011) {
                                    phi_1168_ = _e999;
                                } else {
                                    phi_1168_ = _e1011;
                                }
                                let _e1018 = phi_1168_;
                                if (_e1000 < _e1012) {
                                    phi_1173_ = _e1000;
                                } else {
                                    phi_1173_ = _e1012;
                                }
                                let _e1021 = phi_1173_;
                                if (_e998 > _e1010) {
                                    phi_1181_ = _e998;
                                } else {
                                    phi_1181_ = _e1010;
                                }
                                let _e1027 = phi_1181_;
                                if (_e999 > _e1011) {
                                    phi_1186_ = _e999;
                                } else {
                                    phi_1186_ = _e1011;
                                }
                                let _e1030 = phi_1186_;
                                if (_e1000 > _e1012) {
                                    phi_1191_ = _e1000;
                                } else {
                                    phi_1191_ = _e1012;
                                }
                                let _e1033 = phi_1191_;
                                let _e1037 = core_intrinsics_maximum_number_nsz_f32_((_e1015 - _e375), (_e1018 - _e376));
                                let _e1038 = core_intrinsics_maximum_number_nsz_f32_(_e1037, (_e1021 - _e377));
                                let _e1039 = core_intrinsics_minimum_number_nsz_f32_((_e1027 + _e375), (_e1030 + _e376));
                                let _e1040 = core_intrinsics_minimum_number_nsz_f32_(_e1039, (_e1033 + _e377));
                                if (_e1038 <= _e1040) {
                                    if (_e1038 <= _e971.t) {
                                        if (_e1040 >= _e153.tmin) {
                                            let _e1052 = instances.member[(0u + _e979)].world_to_object[0u];
                                            let _e1063 = ((((_e1052.x * _e153.origin.x) + (_e1052.y * _e153.origin.y)) + (_e1052.z * _e153.origin.z)) + (_e1052.w * 1f));
                                            let _e1065 = instances.member[(0u + _e979)].world_to_object[1u];
                                            let _e1076 = ((((_e1065.x * _e153.origin.x) + (_e1065.y * _e153.origin.y)) + (_e1065.z * _e153.origin.z)) + (_e1065.w * 1f));
                                            let _e1078 = instances.member[(0u + _e979)].world_to_object[2u];
                                            let _e1089 = ((((_e1078.x * _e153.origin.x) + (_e1078.y * _e153.origin.y)) + (_e1078.z * _e153.origin.z)) + (_e1078.w * 1f));
                                            let _e1096 = instances.member[(0u + _e979)].world_to_object[0u];
                                            let _e1107 = ((((_e1096.x * _e153.direction.x) + (_e1096.y * _e153.direction.y)) + (_e1096.z * _e153.direction.z)) + (_e1096.w * 0f));
                                            let _e1109 = instances.member[(0u + _e979)].world_to_object[1u];
                                            let _e1120 = ((((_e1109.x * _e153.direction.x) + (_e1109.y * _e153.direction.y)) + (_e1109.z * _e153.direction.z)) + (_e1109.w * 0f));
                                            let _e1122 = instances.member[(0u + _e979)].world_to_object[2u];
                                            let _e1133 = ((((_e1122.x * _e153.direction.x) + (_e1122.y * _e153.direction.y)) + (_e1122.z * _e153.direction.z)) + (_e1122.w * 0f));
                                            let _e1138 = instances.member[(0u + _e979)].root;
                                            let _e1140 = instances.member[(0u + _e979)].first_triangle;
                                            let _e1144 = abs(_e1107);
                                            let _e1145 = abs(_e1120);
                                            let _e1146 = abs(_e1133);
                                            if (abs(_e1063) < 1000000000000000f) {
                                                if (abs(_e1076) < 1000000000000000f) {
                                                    if (abs(_e1089) < 1000000000000000f) {
                                                        if (_e1144 < 1000000000000000f) {
                                                            if (_e1145 < 1000000000000000f) {
                                                                if (_e1146 < 1000000000000000f) {
                                                                    if (_e1144 > 0f) {
                                                                        phi_1348_ = bool();
                                                                        phi_1349_ = true;
                                                                    } else {
                                                                        let _e1154 = (_e1145 > 0f);
                                                                        if _e1154 {
                                                                            phi_1347_ = bool();
                                                                        } else {
                                                                            phi_1347_ = (_e1146 > 0f);
                                                                        }
                                                                        let _e1157 = phi_1347_;
                                                                        phi_1348_ = _e1157;
                                                                        phi_1349_ = _e1154;
                                                                    }
                                                                    let _e1159 = phi_1348_;
                                                                    let _e1161 = phi_1349_;
                                                                    if _e1161 {
                                                                        phi_1353_ = true;
                                                                    } else {
                                                                        phi_1353_ = _e1159;
                                                                    }
                                                                    let _e1163 = phi_1353_;
                                                                    phi_1354_ = _e1163;
                                                                    phi_1355_ = false;
                                                                } else {
                                                                    phi_1354_ = bool();
                                                                    phi_1355_ = true;
                                                                }
                                                                let _e1165 = phi_1354_;
                                                                let _e1167 = phi_1355_;
                                                                phi_1356_ = _e1165;
                                                                phi_1357_ = false;
                                                                phi_1358_ = _e1167;
                                                            } else {
                                                                phi_1356_ = bool();
                                                                phi_1357_ = true;
                                                                phi_1358_ = false;
                                                            }
                                                            let _e1169 = phi_1356_;
                                                            let _e1171 = phi_1357_;
                                                            let _e1173 = phi_1358_;
                                                            phi_1359_ = _e1169;
                                                            phi_1360_ = _e1171;
                                                            phi_1361_ = _e1173;
                                                        } else {
                                                            phi_1359_ = bool();
                                                            phi_1360_ = true;
                                                            phi_1361_ = false;
                                                        }
                                                        let _e1175 = phi_1359_;
                                                        let _e1177 = phi_1360_;
                                                        let _e1179 = phi_1361_;
                                                        phi_1362_ = _e1175;
                                                        phi_1363_ = _e1177;
                                                        phi_1364_ = _e1179;
                                                    } else {
                                                        phi_1362_ = bool();
                                                        phi_1363_ = true;
                                                        phi_1364_ = false;
                                                    }
                                                    let _e1181 = phi_1362_;
                                                    let _e1183 = phi_1363_;
                                                    let _e1185 = phi_1364_;
                                                    phi_1365_ = _e1181;
                                                    phi_1366_ = _e1183;
                                                    phi_1367_ = _e1185;
                                                } else {
                                                    phi_1365_ = bool();
                                                    phi_1366_ = true;
                                                    phi_1367_ = false;
                                                }
                                                let _e1187 = phi_1365_;
                                                let _e1189 = phi_1366_;
                                                let _e1191 = phi_1367_;
                                                phi_1368_ = _e1187;
                                                phi_1369_ = _e1189;
                                                phi_1370_ = _e1191;
                                            } else {
                                                phi_1368_ = bool();
                                                phi_1369_ = true;
                                                phi_1370_ = false;
                                            }
                                            let _e1193 = phi_1368_;
                                            let _e1195 = phi_1369_;
                                            let _e1197 = phi_1370_;
                                            if _e1195 {
                                                phi_1374_ = true;
                                            } else {
                                                phi_1374_ = _e1197;
                                            }
                                            let _e1199 = phi_1374_;
                                            if _e1199 {
                                                phi_1378_ = false;
                                            } else {
                                                phi_1378_ = _e1193;
                                            }
                                            let _e1201 = phi_1378_;
                                            if _e1201 {
                                                let _e1202 = (_e1138 >= _e69);
                                                if _e1202 {
                                                    phi_2781_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1138 < _e69) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1208 = nodes.member[(0u + _e1138)].frame[0u];
                                                    let _e1212 = nodes.member[(0u + _e1138)].frame[1u];
                                                    let _e1216 = nodes.member[(0u + _e1138)].frame[2u];
                                                    let _e1220 = nodes.member[(0u + _e1138)].frame[0u];
                                                    let _e1224 = nodes.member[(0u + _e1138)].frame[1u];
                                                    let _e1228 = nodes.member[(0u + _e1138)].frame[2u];
                                                    let _e1232 = nodes.member[(0u + _e1138)].frame[3u];
                                                    let _e1266 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1107), abs(_e1120));
                                                    let _e1267 = core_intrinsics_maximum_number_nsz_f32_(_e1266, abs(_e1133));
                                                    let _e1268 = (_e1267 * 0.0000000000009094947f);
                                                    if (abs(_e1107) < _e1268) {
                                                        phi_1448_ = _e1268;
                                                    } else {
                                                        phi_1448_ = abs(_e1107);
                                                    }
                                                    let _e1273 = phi_1448_;
                                                    if (_e1107 < 0f) {
                                                        phi_1455_ = (-1f / _e1273);
                                                    } else {
                                                        phi_1455_ = (1f / _e1273);
                                                    }
                                                    let _e1278 = phi_1455_;
                                                    if (abs(_e1120) < _e1268) {
                                                        phi_1462_ = _e1268;
                                                    } else {
                                                        phi_1462_ = abs(_e1120);
                                                    }
                                                    let _e1283 = phi_1462_;
                                                    if (_e1120 < 0f) {
                                                        phi_1469_ = (-1f / _e1283);
                                                    } else {
                                                        phi_1469_ = (1f / _e1283);
                                                    }
                                                    let _e1288 = phi_1469_;
                                                    if (abs(_e1133) < _e1268) {
                                                        phi_1476_ = _e1268;
                                                    } else {
                                                        phi_1476_ = abs(_e1133);
                                                    }
                                                    let _e1293 = phi_1476_;
                                                    if (_e1133 < 0f) {
                                                        phi_1483_ = (-1f / _e1293);
                                                    } else {
                                                        phi_1483_ = (1f / _e1293);
                                                    }
                                                    let _e1298 = phi_1483_;
                                                    let _e1302 = abs((bitcast<f32>(_e1208) - _e1063));
                                                    let _e1303 = abs((bitcast<f32>(_e1212) - _e1076));
                                                    let _e1304 = abs((bitcast<f32>(_e1216) - _e1089));
                                                    let _e1308 = abs(((bitcast<f32>(_e1220) + (bitcast<f32>((((_e1232 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1063));
                                                    let _e1309 = abs(((bitcast<f32>(_e1224) + (bitcast<f32>((((_e1232 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1076));
                                                    let _e1310 = abs(((bitcast<f32>(_e1228) + (bitcast<f32>((((_e1232 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1089));
                                                    if (_e1302 > _e1308) {
                                                        phi_1500_ = _e1302;
                                                    } else {
                                                        phi_1500_ = _e1308;
                                                    }
                                                    let _e1313 = phi_1500_;
                                                    if (_e1303 > _e1309) {
                                                        phi_1505_ = _e1303;
                                                    } else {
                                                        phi_1505_ = _e1309;
                                                    }
                                                    let _e1316 = phi_1505_;
                                                    if (_e1304 > _e1310) {
                                                        phi_1510_ = _e1304;
                                                    } else {
                                                        phi_1510_ = _e1310;
                                                    }
                                                    let _e1319 = phi_1510_;
                                                    let _e1320 = core_intrinsics_maximum_number_nsz_f32_(_e1313, _e1316);
                                                    let _e1321 = core_intrinsics_maximum_number_nsz_f32_(_e1320, _e1319);
                                                    let _e1325 = (_e1321 * 0.0000019073486f);
                                                    let _e1326 = (abs(_e1278) * _e1325);
                                                    let _e1327 = (abs(_e1288) * _e1325);
                                                    let _e1328 = (abs(_e1298) * _e1325);
                                                    let _e1332 = (_e1321 * 0.0000009536743f);
                                                    let _e1333 = (abs(_e1278) * _e1332);
                                                    let _e1334 = (abs(_e1288) * _e1332);
                                                    let _e1335 = (abs(_e1298) * _e1332);
                                                    let _e1336 = abs(_e1107);
                                                    let _e1337 = abs(_e1120);
                                                    let _e1338 = abs(_e1133);
                                                    if (_e1336 >= _e1337) {
                                                        if (_e1336 >= _e1338) {
                                                            phi_1538_ = false;
                                                        } else {
                                                            phi_1538_ = true;
                                                        }
                                                        let _e1342 = phi_1538_;
                                                        phi_1539_ = _e1342;
                                                    } else {
                                                        phi_1539_ = true;
                                                    }
                                                    let _e1344 = phi_1539_;
                                                    if _e1344 {
                                                        if (_e1337 >= _e1338) {
                                                            phi_1547_ = 1u;
                                                        } else {
                                                            phi_1547_ = 2u;
                                                        }
                                                        let _e1347 = phi_1547_;
                                                        phi_1548_ = _e1347;
                                                    } else {
                                                        phi_1548_ = 0u;
                                                    }
                                                    let _e1349 = phi_1548_;
                                                    if (_e1349 == 0u) {
                                                        phi_1560_ = vec3<f32>(_e1120, _e1133, _e1107);
                                                    } else {
                                                        if (_e1349 == 1u) {
                                                            phi_1559_ = vec3<f32>(_e1133, _e1107, _e1120);
                                                        } else {
                                                            phi_1559_ = vec3<f32>(_e1107, _e1120, _e1133);
                                                        }
                                                        let _e1355 = phi_1559_;
                                                        phi_1560_ = _e1355;
                                                    }
                                                    let _e1357 = phi_1560_;
                                                    let _e1360 = (_e1357.x / _e1357.z);
                                                    let _e1363 = (_e1357.y / _e1357.z);
                                                    if (_e1278 < 0f) {
                                                        phi_1573_ = 0u;
                                                    } else {
                                                        phi_1573_ = 1u;
                                                    }
                                                    let _e1368 = phi_1573_;
                                                    if (_e1288 < 0f) {
                                                        phi_1578_ = 0u;
                                                    } else {
                                                        phi_1578_ = 2u;
                                                    }
                                                    let _e1371 = phi_1578_;
                                                    if (_e1298 < 0f) {
                                                        phi_1583_ = 0u;
                                                    } else {
                                                        phi_1583_ = 4u;
                                                    }
                                                    let _e1374 = phi_1583_;
                                                    let _e1376 = ((_e1368 | _e1371) | _e1374);
                                                    let _e1377 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1138, 2147483648u);
                                                    local = lt_bvh_traverse_Stack(array<u32, 32>(_e1377.first[0], _e1377.first[1], _e1377.first[2], _e1377.first[3], _e1377.first[4], _e1377.first[5], _e1377.first[6], _e1377.first[7], _e1377.first[8], _e1377.first[9], _e1377.first[10], _e1377.first[11], _e1377.first[12], _e1377.first[13], _e1377.first[14], _e1377.first[15], _e1377.first[16], _e1377.first[17], _e1377.first[18], _e1377.first[19], _e1377.first[20], _e1377.first[21], _e1377.first[22], _e1377.first[23], _e1377.first[24], _e1377.first[25], _e1377.first[26], _e1377.first[27], _e1377.first[28], _e1377.first[29], _e1377.first[30], _e1377.first[31]), array<u32, 32>(_e1377.mask[0], _e1377.mask[1], _e1377.mask[2], _e1377.mask[3], _e1377.mask[4], _e1377.mask[5], _e1377.mask[6], _e1377.mask[7], _e1377.mask[8], _e1377.mask[9], _e1377.mask[10], _e1377.mask[11], _e1377.mask[12], _e1377.mask[13], _e1377.mask[14], _e1377.mask[15], _e1377.mask[16], _e1377.mask[17], _e1377.mask[18], _e1377.mask[19], _e1377.mask[20], _e1377.mask[21], _e1377.mask[22], _e1377.mask[23], _e1377.mask[24], _e1377.mask[25], _e1377.mask[26], _e1377.mask[27], _e1377.mask[28], _e1377.mask[29], _e1377.mask[30], _e1377.mask[31]), _e1377.len, _e1377.group, _e1377.group_mask);
                                                    let _e1451 = local.group_mask;
                                                    if ((_e1451 & 4278190080u) == 0u) {
                                                        let _e1455 = local.len;
                                                        if (_e1455 == 0u) {
                                                            phi_1697_ = false;
                                                        } else {
                                                            let _e1459 = local.len;
                                                            local.len = (_e1459 - 1u);
                                                            let _e1462 = local.len;
                                                            if (_e1462 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1467 = local.first[(0u + _e1462)];
                                                            local.group = _e1467;
                                                            let _e1470 = local.len;
                                                            if (_e1470 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1475 = local.mask[(0u + _e1470)];
                                                            local.group_mask = _e1475;
                                                            phi_1697_ = true;
                                                        }
                                                        let _e1478 = phi_1697_;
                                                        phi_1698_ = _e1478;
                                                    } else {
                                                        phi_1698_ = true;
                                                    }
                                                    let _e1480 = phi_1698_;
                                                    if _e1480 {
                                                        let _e1482 = local.group_mask;
                                                        let _e1488 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1482)), 32u, (_e1482 == 0u)));
                                                        let _e1492 = local.group_mask;
                                                        let _e1506 = local.group_mask;
                                                        local.group_mask = (_e1506 & ~((1u << bitcast<u32>((_e1488 & 31u)))));
                                                        let _e1509 = local.group;
                                                        phi_1729_ = (_e1509 + countOneBits(((_e1492 & ~((4294967295u << bitcast<u32>((((_e1488 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_1729_ = 4294967295u;
                                                    }
                                                    let _e1512 = phi_1729_;
                                                    phi_1731_ = _e971;
                                                    phi_1734_ = _e1512;
                                                    loop {
                                                        let _e1514 = phi_1731_;
                                                        let _e1516 = phi_1734_;
                                                        local_9 = _e1514;
                                                        let _e1517 = (_e1516 != 4294967295u);
                                                        if _e1517 {
                                                            if (_e1516 < _e69) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1524 = nodes.member[(0u + _e1516)].frame[3u];
                                                            let _e1549 = (bitcast<f32>((((_e1524 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1278);
                                                            let _e1550 = (bitcast<f32>((((_e1524 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1288);
                                                            let _e1551 = (bitcast<f32>((((_e1524 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1298);
                                                            let _e1554 = nodes.member[(0u + _e1516)].frame[0u];
                                                            let _e1558 = nodes.member[(0u + _e1516)].frame[1u];
                                                            let _e1562 = nodes.member[(0u + _e1516)].frame[2u];
                                                            let _e1567 = ((bitcast<f32>(_e1554) - _e1063) * _e1278);
                                                            let _e1568 = ((bitcast<f32>(_e1558) - _e1076) * _e1288);
                                                            let _e1569 = ((bitcast<f32>(_e1562) - _e1089) * _e1298);
                                                            let _e1577 = nodes.member[(0u + _e1516)].x;
                                                            if (_e1278 < 0f) {
                                                                let _e1588 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1577.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1594 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1588.unnamed.word, _e1577.w), _e1588.unnamed_1);
                                                                let _e1600 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1594.unnamed, lt_mask_LightPlace(_e1577.x, _e1594.unnamed_1.shift));
                                                                phi_1815_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1600.unnamed, lt_mask_LightPlace(_e1600.unnamed_1.word, _e1577.y));
                                                            } else {
                                                                let _e1616 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1577.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1622 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1616.unnamed.word, _e1577.y), _e1616.unnamed_1);
                                                                let _e1628 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1622.unnamed, lt_mask_LightPlace(_e1577.z, _e1622.unnamed_1.shift));
                                                                phi_1815_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1628.unnamed, lt_mask_LightPlace(_e1628.unnamed_1.word, _e1577.w));
                                                            }
                                                            let _e1636 = phi_1815_;
                                                            let _e1646 = nodes.member[(0u + _e1516)].y;
                                                            if (_e1288 < 0f) {
                                                                let _e1657 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1646.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1663 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1657.unnamed.word, _e1646.w), _e1657.unnamed_1);
                                                                let _e1669 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1663.unnamed, lt_mask_LightPlace(_e1646.x, _e1663.unnamed_1.shift));
                                                                phi_1842_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1669.unnamed, lt_mask_LightPlace(_e1669.unnamed_1.word, _e1646.y));
                                                            } else {
                                                                let _e1685 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1646.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1691 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1685.unnamed.word, _e1646.y), _e1685.unnamed_1);
                                                                let _e1697 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1691.unnamed, lt_mask_LightPlace(_e1646.z, _e1691.unnamed_1.shift));
                                                                phi_1842_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1697.unnamed, lt_mask_LightPlace(_e1697.unnamed_1.word, _e1646.w));
                                                            }
                                                            let _e1705 = phi_1842_;
                                                            let _e1715 = nodes.member[(0u + _e1516)].z;
                                                            if (_e1298 < 0f) {
                                                                let _e1726 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1715.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1732 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1726.unnamed.word, _e1715.w), _e1726.unnamed_1);
                                                                let _e1738 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1732.unnamed, lt_mask_LightPlace(_e1715.x, _e1732.unnamed_1.shift));
                                                                phi_1869_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1738.unnamed, lt_mask_LightPlace(_e1738.unnamed_1.word, _e1715.y));
                                                            } else {
                                                                let _e1754 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1715.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1760 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1754.unnamed.word, _e1715.y), _e1754.unnamed_1);
                                                                let _e1766 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1760.unnamed, lt_mask_LightPlace(_e1715.z, _e1760.unnamed_1.shift));
                                                                phi_1869_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1766.unnamed, lt_mask_LightPlace(_e1766.unnamed_1.word, _e1715.w));
                                                            }
                                                            let _e1774 = phi_1869_;
                                                            phi_1875_ = 0u;
                                                            phi_1878_ = 0u;
                                                            loop {
                                                                let _e1784 = phi_1875_;
                                                                let _e1786 = phi_1878_;
                                                                local_5 = _e1786;
                                                                local_6 = _e1786;
                                                                local_7 = _e1786;
                                                                let _e1787 = (_e1784 < 8u);
                                                                if _e1787 {
                                                                    let _e1789 = (_e1784 >> bitcast<u32>(2i));
                                                                    let _e1790 = (_e1784 & 3u);
                                                                    if (_e1789 == 0u) {
                                                                        phi_1892_ = _e1636.unnamed.word;
                                                                    } else {
                                                                        phi_1892_ = _e1636.unnamed.shift;
                                                                    }
                                                                    let _e1793 = phi_1892_;
                                                                    if (_e1789 == 0u) {
                                                                        phi_1902_ = _e1705.unnamed.word;
                                                                    } else {
                                                                        phi_1902_ = _e1705.unnamed.shift;
                                                                    }
                                                                    let _e1802 = phi_1902_;
                                                                    if (_e1789 == 0u) {
                                                                        phi_1912_ = _e1774.unnamed.word;
                                                                    } else {
                                                                        phi_1912_ = _e1774.unnamed.shift;
                                                                    }
                                                                    let _e1811 = phi_1912_;
                                                                    let _e1824 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1793 >> bitcast<u32>(((_e1790 * 8u) & 31u))) & 255u)) * _e1549) + (_e1567 - _e1326)), ((f32(((_e1802 >> bitcast<u32>(((_e1790 * 8u) & 31u))) & 255u)) * _e1550) + (_e1568 - _e1327)));
                                                                    let _e1825 = core_intrinsics_maximum_number_nsz_f32_(_e1824, ((f32(((_e1811 >> bitcast<u32>(((_e1790 * 8u) & 31u))) & 255u)) * _e1551) + (_e1569 - _e1328)));
                                                                    if (_e1789 == 0u) {
                                                                        phi_1930_ = _e1636.unnamed_1.word;
                                                                    } else {
                                                                        phi_1930_ = _e1636.unnamed_1.shift;
                                                                    }
                                                                    let _e1828 = phi_1930_;
                                                                    if (_e1789 == 0u) {
                                                                        phi_1940_ = _e1705.unnamed_1.word;
                                                                    } else {
                                                                        phi_1940_ = _e1705.unnamed_1.shift;
                                                                    }
                                                                    let _e1837 = phi_1940_;
                                                                    if (_e1789 == 0u) {
                                                                        phi_1950_ = _e1774.unnamed_1.word;
                                                                    } else {
                                                                        phi_1950_ = _e1774.unnamed_1.shift;
                                                                    }
                                                                    let _e1846 = phi_1950_;
                                                                    let _e1859 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1828 >> bitcast<u32>(((_e1790 * 8u) & 31u))) & 255u)) * _e1549) + (_e1567 + _e1326)), ((f32(((_e1837 >> bitcast<u32>(((_e1790 * 8u) & 31u))) & 255u)) * _e1550) + (_e1568 + _e1327)));
                                                                    let _e1860 = core_intrinsics_minimum_number_nsz_f32_(_e1859, ((f32(((_e1846 >> bitcast<u32>(((_e1790 * 8u) & 31u))) & 255u)) * _e1551) + (_e1569 + _e1328)));
                                                                    if (_e1825 <= _e1860) {
                                                                        if (_e1825 <= _e1514.t) {
                                                                            if (_e1860 >= _e153.tmin) {
                                                                                if (_e1789 == 0u) {
                                                                                    let _e1867 = nodes.member[(0u + _e1516)].links[2u];
                                                                                    phi_1986_ = _e1867;
                                                                                } else {
                                                                                    let _e1870 = nodes.member[(0u + _e1516)].links[3u];
                                                                                    phi_1986_ = _e1870;
                                                                                }
                                                                                let _e1872 = phi_1986_;
                                                                                let _e1877 = ((_e1872 >> bitcast<u32>(((_e1790 * 8u) & 31u))) & 255u);
                                                                                let _e1878 = (_e1877 & 31u);
                                                                                if (_e1878 >= 24u) {
                                                                                    phi_1999_ = (24u + ((_e1878 - 24u) ^ _e1376));
                                                                                } else {
                                                                                    phi_1999_ = _e1878;
                                                                                }
                                                                                let _e1884 = phi_1999_;
                                                                                phi_2004_ = (_e1786 | ((_e1877 >> bitcast<u32>(5i)) << bitcast<u32>((_e1884 & 31u))));
                                                                            } else {
                                                                                phi_2004_ = _e1786;
                                                                            }
                                                                            let _e1892 = phi_2004_;
                                                                            phi_2005_ = _e1892;
                                                                        } else {
                                                                            phi_2005_ = _e1786;
                                                                        }
                                                                        let _e1894 = phi_2005_;
                                                                        phi_2006_ = _e1894;
                                                                    } else {
                                                                        phi_2006_ = _e1786;
                                                                    }
                                                                    let _e1896 = phi_2006_;
                                                                    phi_1876_ = (_e1784 + 1u);
                                                                    phi_1879_ = _e1896;
                                                                } else {
                                                                    phi_1876_ = u32();
                                                                    phi_1879_ = u32();
                                                                }
                                                                let _e1899 = phi_1876_;
                                                                let _e1901 = phi_1879_;
                                                                continue;
                                                                continuing {
                                                                    phi_1875_ = _e1899;
                                                                    phi_1878_ = _e1901;
                                                                    break if !(_e1787);
                                                                }
                                                            }
                                                            let _e1905 = nodes.member[(0u + _e1516)].links[0u];
                                                            let _e1909 = nodes.member[(0u + _e1516)].frame[3u];
                                                            let _e1913 = local_5;
                                                            if ((_e1913 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1917 = local.group_mask;
                                                                if ((_e1917 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1921 = local.len;
                                                                    if (_e1921 < 32u) {
                                                                        let _e1924 = local.group;
                                                                        let _e1926 = local.len;
                                                                        if (_e1926 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.first[(0u + _e1926)] = _e1924;
                                                                        let _e1932 = local.group_mask;
                                                                        let _e1934 = local.len;
                                                                        if (_e1934 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.mask[(0u + _e1934)] = _e1932;
                                                                        let _e1941 = local.len;
                                                                        local.len = (_e1941 + 1u);
                                                                    }
                                                                }
                                                                local.group = (_e1138 + _e1905);
                                                                let _e1945 = local_6;
                                                                local.group_mask = ((_e1945 & 4278190080u) | (_e1909 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1950 = local_7;
                                                            phi_2064_ = _e1514;
                                                            phi_2067_ = (_e1950 & 16777215u);
                                                            loop {
                                                                let _e1953 = phi_2064_;
                                                                let _e1955 = phi_2067_;
                                                                local_8 = _e1953;
                                                                if (_e1955 == 0u) {
                                                                    phi_2065_ = lt_bvh_Hit();
                                                                    phi_2068_ = u32();
                                                                    phi_2709_ = false;
                                                                } else {
                                                                    let _e1959 = nodes.member[(0u + _e1516)].links[1u];
                                                                    let _e1964 = ((_e1140 + _e1959) + select(firstTrailingBit(_e1955), 32u, (_e1955 == 0u)));
                                                                    if (_e1964 < _e72) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1971 = triangles.member[(0u + _e1964)].v0_;
                                                                    let _e1973 = (_e1971.x - _e1063);
                                                                    let _e1975 = (_e1971.y - _e1076);
                                                                    let _e1977 = (_e1971.z - _e1089);
                                                                    if (_e1349 == 0u) {
                                                                        phi_2112_ = vec3<f32>(_e1975, _e1977, _e1973);
                                                                    } else {
                                                                        if (_e1349 == 1u) {
                                                                            phi_2111_ = vec3<f32>(_e1977, _e1973, _e1975);
                                                                        } else {
                                                                            phi_2111_ = (_e1971 - vec3<f32>(_e1063, _e1076, _e1089));
                                                                        }
                                                                        let _e1985 = phi_2111_;
                                                                        phi_2112_ = _e1985;
                                                                    }
                                                                    let _e1987 = phi_2112_;
                                                                    let _e1991 = (_e1987.x - (_e1360 * _e1987.z));
                                                                    let _e1995 = (_e1987.y - (_e1363 * _e1987.z));
                                                                    let _e1997 = triangles.member[(0u + _e1964)].v1_;
                                                                    let _e1999 = (_e1997.x - _e1063);
                                                                    let _e2001 = (_e1997.y - _e1076);
                                                                    let _e2003 = (_e1997.z - _e1089);
                                                                    if (_e1349 == 0u) {
                                                                        phi_2142_ = vec3<f32>(_e2001, _e2003, _e1999);
                                                                    } else {
                                                                        if (_e1349 == 1u) {
                                                                            phi_2141_ = vec3<f32>(_e2003, _e1999, _e2001);
                                                                        } else {
                                                                            phi_2141_ = (_e1997 - vec3<f32>(_e1063, _e1076, _e1089));
                                                                        }
                                                                        let _e2011 = phi_2141_;
                                                                        phi_2142_ = _e2011;
                                                                    }
                                                                    let _e2013 = phi_2142_;
                                                                    let _e2017 = (_e2013.x - (_e1360 * _e2013.z));
                                                                    let _e2021 = (_e2013.y - (_e1363 * _e2013.z));
                                                                    let _e2023 = triangles.member[(0u + _e1964)].v2_;
                                                                    let _e2025 = (_e2023.x - _e1063);
                                                                    let _e2027 = (_e2023.y - _e1076);
                                                                    let _e2029 = (_e2023.z - _e1089);
                                                                    if (_e1349 == 0u) {
                                                                        phi_2172_ = vec3<f32>(_e2027, _e2029, _e2025);
                                                                    } else {
                                                                        if (_e1349 == 1u) {
                                                                            phi_2171_ = vec3<f32>(_e2029, _e2025, _e2027);
                                                                        } else {
                                                                            phi_2171_ = (_e2023 - vec3<f32>(_e1063, _e1076, _e1089));
                                                                        }
                                                                        let _e2037 = phi_2171_;
                                                                        phi_2172_ = _e2037;
                                                                    }
                                                                    let _e2039 = phi_2172_;
                                                                    let _e2043 = (_e2039.x - (_e1360 * _e2039.z));
                                                                    let _e2047 = (_e2039.y - (_e1363 * _e2039.z));
                                                                    if (_e2017 < _e2043) {
                                                                        phi_2191_ = true;
                                                                    } else {
                                                                        if (_e2017 == _e2043) {
                                                                            phi_2190_ = (_e2021 < _e2047);
                                                                        } else {
                                                                            phi_2190_ = false;
                                                                        }
                                                                        let _e2052 = phi_2190_;
                                                                        phi_2191_ = _e2052;
                                                                    }
                                                                    let _e2054 = phi_2191_;
                                                                    if _e2054 {
                                                                        phi_2195_ = _e2047;
                                                                        phi_2196_ = _e2043;
                                                                        phi_2197_ = _e2021;
                                                                        phi_2198_ = _e2017;
                                                                    } else {
                                                                        phi_2195_ = _e2021;
                                                                        phi_2196_ = _e2017;
                                                                        phi_2197_ = _e2047;
                                                                        phi_2198_ = _e2043;
                                                                    }
                                                                    let _e2056 = phi_2195_;
                                                                    let _e2058 = phi_2196_;
                                                                    let _e2060 = phi_2197_;
                                                                    let _e2062 = phi_2198_;
                                                                    let _e2065 = ((_e2062 * _e2056) - (_e2060 * _e2058));
                                                                    if _e2054 {
                                                                        phi_2206_ = -(_e2065);
                                                                    } else {
                                                                        phi_2206_ = _e2065;
                                                                    }
                                                                    let _e2068 = phi_2206_;
                                                                    if (_e2043 < _e1991) {
                                                                        phi_2217_ = true;
                                                                    } else {
                                                                        if (_e2043 == _e1991) {
                                                                            phi_2216_ = (_e2047 < _e1995);
                                                                        } else {
                                                                            phi_2216_ = false;
                                                                        }
                                                                        let _e2073 = phi_2216_;
                                                                        phi_2217_ = _e2073;
                                                                    }
                                                                    let _e2075 = phi_2217_;
                                                                    if _e2075 {
                                                                        phi_2221_ = _e1995;
                                                                        phi_2222_ = _e1991;
                                                                        phi_2223_ = _e2047;
                                                                        phi_2224_ = _e2043;
                                                                    } else {
                                                                        phi_2221_ = _e2047;
                                                                        phi_2222_ = _e2043;
                                                                        phi_2223_ = _e1995;
                                                                        phi_2224_ = _e1991;
                                                                    }
                                                                    let _e2077 = phi_2221_;
                                                                    let _e2079 = phi_2222_;
                                                                    let _e2081 = phi_2223_;
                                                                    let _e2083 = phi_2224_;
                                                                    let _e2086 = ((_e2083 * _e2077) - (_e2081 * _e2079));
                                                                    if _e2075 {
                                                                        phi_2232_ = -(_e2086);
                                                                    } else {
                                                                        phi_2232_ = _e2086;
                                                                    }
                                                                    let _e2089 = phi_2232_;
                                                                    if (_e1991 < _e2017) {
                                                                        phi_2243_ = true;
                                                                    } else {
                                                                        if (_e1991 == _e2017) {
                                                                            phi_2242_ = (_e1995 < _e2021);
                                                                        } else {
                                                                            phi_2242_ = false;
                                                                        }
                                                                        let _e2094 = phi_2242_;
                                                                        phi_2243_ = _e2094;
                                                                    }
                                                                    let _e2096 = phi_2243_;
                                                                    if _e2096 {
                                                                        phi_2247_ = _e2021;
                                                                        phi_2248_ = _e2017;
                                                                        phi_2249_ = _e1995;
                                                                        phi_2250_ = _e1991;
                                                                    } else {
                                                                        phi_2247_ = _e1995;
                                                                        phi_2248_ = _e1991;
                                                                        phi_2249_ = _e2021;
                                                                        phi_2250_ = _e2017;
                                                                    }
                                                                    let _e2098 = phi_2247_;
                                                                    let _e2100 = phi_2248_;
                                                                    let _e2102 = phi_2249_;
                                                                    let _e2104 = phi_2250_;
                                                                    let _e2107 = ((_e2104 * _e2098) - (_e2102 * _e2100));
                                                                    if _e2096 {
                                                                        phi_2258_ = -(_e2107);
                                                                    } else {
                                                                        phi_2258_ = _e2107;
                                                                    }
                                                                    let _e2110 = phi_2258_;
                                                                    if (_e2068 >= 0f) {
                                                                        if (_e2089 >= 0f) {
                                                                            if (_e2110 >= 0f) {
                                                                                phi_2273_ = ((_e2068 + _e2089) + _e2110);
                                                                                phi_2274_ = false;
                                                                            } else {
                                                                                phi_2273_ = f32();
                                                                                phi_2274_ = true;
                                                                            }
                                                                            let _e2117 = phi_2273_;
                                                                            let _e2119 = phi_2274_;
                                                                            phi_2275_ = _e2117;
                                                                            phi_2276_ = _e2119;
                                                                        } else {
                                                                            phi_2275_ = f32();
                                                                            phi_2276_ = true;
                                                                        }
                                                                        let _e2121 = phi_2275_;
                                                                        let _e2123 = phi_2276_;
                                                                        phi_2277_ = _e2121;
                                                                        phi_2278_ = _e2123;
                                                                    } else {
                                                                        phi_2277_ = f32();
                                                                        phi_2278_ = true;
                                                                    }
                                                                    let _e2125 = phi_2277_;
                                                                    let _e2127 = phi_2278_;
                                                                    if _e2127 {
                                                                        if (_e2068 <= 0f) {
                                                                            if (_e2089 <= 0f) {
                                                                                let _e2130 = (_e2110 <= 0f);
                                                                                if _e2130 {
                                                                                }
                                                                                phi_2296_ = ((_e2068 + _e2089) + _e2110);
                                                                                phi_2297_ = false;
                                                                                phi_2298_ = _e2130;
                                                                            } else {
                                                                                phi_2296_ = f32();
                                                                                phi_2297_ = true;
                                                                                phi_2298_ = false;
                                                                            }
                                                                            let _e2134 = phi_2296_;
                                                                            let _e2136 = phi_2297_;
                                                                            let _e2138 = phi_2298_;
                                                                            phi_2299_ = _e2134;
                                                                            phi_2300_ = _e2136;
                                                                            phi_2301_ = _e2138;
                                                                        } else {
                                                                            phi_2299_ = f32();
                                                                            phi_2300_ = true;
                                                                            phi_2301_ = false;
                                                                        }
                                                                        let _e2140 = phi_2299_;
                                                                        let _e2142 = phi_2300_;
                                                                        let _e2144 = phi_2301_;
                                                                        if _e2142 {
                                                                            phi_2305_ = false;
                                                                        } else {
                                                                            phi_2305_ = _e2144;
                                                                        }
                                                                        let _e2146 = phi_2305_;
                                                                        phi_2306_ = _e2140;
                                                                        phi_2307_ = _e2146;
                                                                    } else {
                                                                        phi_2306_ = _e2125;
                                                                        phi_2307_ = true;
                                                                    }
                                                                    let _e2148 = phi_2306_;
                                                                    let _e2150 = phi_2307_;
                                                                    if _e2150 {
                                                                        let _e2151 = (_e2148 == 0f);
                                                                        if _e2151 {
                                                                            phi_2623_ = lt_bvh_triangle_Intersection();
                                                                            phi_2624_ = false;
                                                                        } else {
                                                                            let _e2153 = triangles.member[(0u + _e1964)].v0_;
                                                                            let _e2155 = (_e2153.x - _e1063);
                                                                            let _e2157 = (_e2153.y - _e1076);
                                                                            let _e2159 = (_e2153.z - _e1089);
                                                                            if (_e1349 == 0u) {
                                                                                phi_2336_ = vec3<f32>(_e2157, _e2159, _e2155);
                                                                            } else {
                                                                                if (_e1349 == 1u) {
                                                                                    phi_2335_ = vec3<f32>(_e2159, _e2155, _e2157);
                                                                                } else {
                                                                                    phi_2335_ = (_e2153 - vec3<f32>(_e1063, _e1076, _e1089));
                                                                                }
                                                                                let _e2167 = phi_2335_;
                                                                                phi_2336_ = _e2167;
                                                                            }
                                                                            let _e2169 = phi_2336_;
                                                                            let _e2171 = triangles.member[(0u + _e1964)].v1_;
                                                                            let _e2173 = triangles.member[(0u + _e1964)].v0_;
                                                                            let _e2176 = (_e2171.x - _e2173.x);
                                                                            let _e2179 = (_e2171.y - _e2173.y);
                                                                            let _e2182 = (_e2171.z - _e2173.z);
                                                                            if (_e1349 == 0u) {
                                                                                phi_2362_ = vec3<f32>(_e2179, _e2182, _e2176);
                                                                            } else {
                                                                                if (_e1349 == 1u) {
                                                                                    phi_2361_ = vec3<f32>(_e2182, _e2176, _e2179);
                                                                                } else {
                                                                                    phi_2361_ = (_e2171 - _e2173);
                                                                                }
                                                                                let _e2189 = phi_2361_;
                                                                                phi_2362_ = _e2189;
                                                                            }
                                                                            let _e2191 = phi_2362_;
                                                                            let _e2193 = triangles.member[(0u + _e1964)].v2_;
                                                                            let _e2195 = triangles.member[(0u + _e1964)].v0_;
                                                                            let _e2198 = (_e2193.x - _e2195.x);
                                                                            let _e2201 = (_e2193.y - _e2195.y);
                                                                            let _e2204 = (_e2193.z - _e2195.z);
                                                                            if (_e1349 == 0u) {
                                                                                phi_2388_ = vec3<f32>(_e2201, _e2204, _e2198);
                                                                            } else {
                                                                                if (_e1349 == 1u) {
                                                                                    phi_2387_ = vec3<f32>(_e2204, _e2198, _e2201);
                                                                                } else {
                                                                                    phi_2387_ = (_e2193 - _e2195);
                                                                                }
                                                                                let _e2211 = phi_2387_;
                                                                                phi_2388_ = _e2211;
                                                                            }
                                                                            let _e2213 = phi_2388_;
                                                                            let _e2220 = ((_e2191.y * _e2213.z) - (_e2191.z * _e2213.y));
                                                                            let _e2227 = ((_e2191.z * _e2213.x) - (_e2191.x * _e2213.z));
                                                                            let _e2234 = ((_e2191.x * _e2213.y) - (_e2191.y * _e2213.x));
                                                                            let _e2248 = (((1f / _e1357.z) * (((_e2220 * _e2169.x) + (_e2227 * _e2169.y)) + (_e2234 * _e2169.z))) / (((_e2220 * _e1360) + (_e2227 * _e1363)) + _e2234));
                                                                            if (_e2248 > _e153.tmin) {
                                                                                if (_e2248 < _e153.tmax) {
                                                                                    let _e2252 = triangles.member[(0u + _e1964)].v0_;
                                                                                    let _e2254 = triangles.member[(0u + _e1964)].v1_;
                                                                                    if (_e2252.x < _e2254.x) {
                                                                                        phi_2444_ = _e2252.x;
                                                                                    } else {
                                                                                        phi_2444_ = _e2254.x;
                                                                                    }
                                                                                    let _e2261 = phi_2444_;
                                                                                    if (_e2252.y < _e2254.y) {
                                                                                        phi_2453_ = _e2252.y;
                                                                                    } else {
                                                                                        phi_2453_ = _e2254.y;
                                                                                    }
                                                                                    let _e2268 = phi_2453_;
                                                                                    if (_e2252.z < _e2254.z) {
                                                                                        phi_2462_ = _e2252.z;
                                                                                    } else {
                                                                                        phi_2462_ = _e2254.z;
                                                                                    }
                                                                                    let _e2275 = phi_2462_;
                                                                                    let _e2277 = triangles.member[(0u + _e1964)].v2_;
                                                                                    if (_e2261 < _e2277.x) {
                                                                                        phi_2471_ = _e2261;
                                                                                    } else {
                                                                                        phi_2471_ = _e2277.x;
                                                                                    }
                                                                                    let _e2282 = phi_2471_;
                                                                                    if (_e2268 < _e2277.y) {
                                                                                        phi_2478_ = _e2268;
                                                                                    } else {
                                                                                        phi_2478_ = _e2277.y;
                                                                                    }
                                                                                    let _e2287 = phi_2478_;
                                                                                    if (_e2275 < _e2277.z) {
                                                                                        phi_2485_ = _e2275;
                                                                                    } else {
                                                                                        phi_2485_ = _e2277.z;
                                                                                    }
                                                                                    let _e2292 = phi_2485_;
                                                                                    let _e2294 = triangles.member[(0u + _e1964)].v0_;
                                                                                    let _e2296 = triangles.member[(0u + _e1964)].v1_;
                                                                                    if (_e2294.x > _e2296.x) {
                                                                                        phi_2498_ = _e2294.x;
                                                                                    } else {
                                                                                        phi_2498_ = _e2296.x;
                                                                                    }
                                                                                    let _e2303 = phi_2498_;
                                                                                    if (_e2294.y > _e2296.y) {
                                                                                        phi_2507_ = _e2294.y;
                                                                                    } else {
                                                                                        phi_2507_ = _e2296.y;
                                                                                    }
                                                                                    let _e2310 = phi_2507_;
                                                                                    if (_e2294.z > _e2296.z) {
                                                                                        phi_2516_ = _e2294.z;
                                                                                    } else {
                                                                                        phi_2516_ = _e2296.z;
                                                                                    }
                                                                                    let _e2317 = phi_2516_;
                                                                                    let _e2319 = triangles.member[(0u + _e1964)].v2_;
                                                                                    if (_e2303 > _e2319.x) {
                                                                                        phi_2525_ = _e2303;
                                                                                    } else {
                                                                                        phi_2525_ = _e2319.x;
                                                                                    }
                                                                                    let _e2324 = phi_2525_;
                                                                                    if (_e2310 > _e2319.y) {
                                                                                        phi_2532_ = _e2310;
                                                                                    } else {
                                                                                        phi_2532_ = _e2319.y;
                                                                                    }
                                                                                    let _e2329 = phi_2532_;
                                                                                    if (_e2317 > _e2319.z) {
                                                                                        phi_2539_ = _e2317;
                                                                                    } else {
                                                                                        phi_2539_ = _e2319.z;
                                                                                    }
                                                                                    let _e2334 = phi_2539_;
                                                                                    let _e2338 = ((_e2282 - _e1063) * _e1278);
                                                                                    let _e2339 = ((_e2287 - _e1076) * _e1288);
                                                                                    let _e2340 = ((_e2292 - _e1089) * _e1298);
                                                                                    let _e2344 = ((_e2324 - _e1063) * _e1278);
                                                                                    let _e2345 = ((_e2329 - _e1076) * _e1288);
                                                                                    let _e2346 = ((_e2334 - _e1089) * _e1298);
                                                                                    if (_e2338 < _e2344) {
                                                                                        phi_2556_ = _e2338;
                                                                                    } else {
                                                                                        phi_2556_ = _e2344;
                                                                                    }
                                                                                    let _e2349 = phi_2556_;
                                                                                    if (_e2339 < _e2345) {
                                                                                        phi_2561_ = _e2339;
                                                                                    } else {
                                                                                        phi_2561_ = _e2345;
                                                                                    }
                                                                                    let _e2352 = phi_2561_;
                                                                                    if (_e2340 < _e2346) {
                                                                                        phi_2566_ = _e2340;
                                                                                    } else {
                                                                                        phi_2566_ = _e2346;
                                                                                    }
                                                                                    let _e2355 = phi_2566_;
                                                                                    if (_e2338 > _e2344) {
                                                                                        phi_2574_ = _e2338;
                                                                                    } else {
                                                                                        phi_2574_ = _e2344;
                                                                                    }
                                                                                    let _e2361 = phi_2574_;
                                                                                    if (_e2339 > _e2345) {
                                                                                        phi_2579_ = _e2339;
                                                                                    } else {
                                                                                        phi_2579_ = _e2345;
                                                                                    }
                                                                                    let _e2364 = phi_2579_;
                                                                                    if (_e2340 > _e2346) {
                                                                                        phi_2584_ = _e2340;
                                                                                    } else {
                                                                                        phi_2584_ = _e2346;
                                                                                    }
                                                                                    let _e2367 = phi_2584_;
                                                                                    let _e2371 = core_intrinsics_maximum_number_nsz_f32_((_e2349 - _e1333), (_e2352 - _e1334));
                                                                                    let _e2372 = core_intrinsics_maximum_number_nsz_f32_(_e2371, (_e2355 - _e1335));
                                                                                    let _e2373 = core_intrinsics_minimum_number_nsz_f32_((_e2361 + _e1333), (_e2364 + _e1334));
                                                                                    let _e2374 = core_intrinsics_minimum_number_nsz_f32_(_e2373, (_e2367 + _e1335));
                                                                                    if (_e2372 > _e1038) {
                                                                                        phi_2596_ = _e2372;
                                                                                    } else {
                                                                                        phi_2596_ = _e1038;
                                                                                    }
                                                                                    let _e2377 = phi_2596_;
                                                                                    if (_e2374 < _e1040) {
                                                                                        phi_2601_ = _e2374;
                                                                                    } else {
                                                                                        phi_2601_ = _e1040;
                                                                                    }
                                                                                    let _e2380 = phi_2601_;
                                                                                    if (_e2248 < _e2377) {
                                                                                        phi_2606_ = _e2377;
                                                                                    } else {
                                                                                        phi_2606_ = _e2248;
                                                                                    }
                                                                                    let _e2383 = phi_2606_;
                                                                                    if (_e2383 > _e2380) {
                                                                                        phi_2611_ = _e2380;
                                                                                    } else {
                                                                                        phi_2611_ = _e2383;
                                                                                    }
                                                                                    let _e2386 = phi_2611_;
                                                                                    phi_2616_ = lt_bvh_triangle_Intersection(_e2386, (_e2089 / _e2148), (_e2110 / _e2148), (_e2377 <= _e2380));
                                                                                    phi_2617_ = false;
                                                                                } else {
                                                                                    phi_2616_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2617_ = true;
                                                                                }
                                                                                let _e2392 = phi_2616_;
                                                                                let _e2394 = phi_2617_;
                                                                                phi_2618_ = _e2392;
                                                                                phi_2619_ = _e2394;
                                                                            } else {
                                                                                phi_2618_ = lt_bvh_triangle_Intersection();
                                                                                phi_2619_ = true;
                                                                            }
                                                                            let _e2396 = phi_2618_;
                                                                            let _e2398 = phi_2619_;
                                                                            if _e2398 {
                                                                            }
                                                                            phi_2623_ = _e2396;
                                                                            phi_2624_ = _e2398;
                                                                        }
                                                                        let _e2400 = phi_2623_;
                                                                        let _e2402 = phi_2624_;
                                                                        phi_2625_ = _e2400;
                                                                        phi_2626_ = _e2151;
                                                                        phi_2627_ = _e2402;
                                                                    } else {
                                                                        phi_2625_ = lt_bvh_triangle_Intersection();
                                                                        phi_2626_ = true;
                                                                        phi_2627_ = false;
                                                                    }
                                                                    let _e2404 = phi_2625_;
                                                                    let _e2406 = phi_2626_;
                                                                    let _e2408 = phi_2627_;
                                                                    if _e2406 {
                                                                        phi_2631_ = true;
                                                                    } else {
                                                                        phi_2631_ = _e2408;
                                                                    }
                                                                    let _e2410 = phi_2631_;
                                                                    if _e2410 {
                                                                        phi_2635_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2635_ = _e2404;
                                                                    }
                                                                    let _e2412 = phi_2635_;
                                                                    if _e2412.is_hit {
                                                                        if (_e2412.t > _e153.tmin) {
                                                                            if (_e2412.t < _e1953.t) {
                                                                                phi_2683_ = true;
                                                                            } else {
                                                                                if (_e2412.t == _e1953.t) {
                                                                                    if (_e1953.triangle != 4294967295u) {
                                                                                        if (_e1964 < _e1953.triangle) {
                                                                                            phi_2674_ = true;
                                                                                        } else {
                                                                                            if (_e1964 == _e1953.triangle) {
                                                                                                phi_2673_ = (_e979 < _e1953.instance);
                                                                                            } else {
                                                                                                phi_2673_ = false;
                                                                                            }
                                                                                            let _e2430 = phi_2673_;
                                                                                            phi_2674_ = _e2430;
                                                                                        }
                                                                                        let _e2432 = phi_2674_;
                                                                                        phi_2675_ = _e2432;
                                                                                        phi_2676_ = false;
                                                                                    } else {
                                                                                        phi_2675_ = bool();
                                                                                        phi_2676_ = true;
                                                                                    }
                                                                                    let _e2434 = phi_2675_;
                                                                                    let _e2436 = phi_2676_;
                                                                                    phi_2677_ = _e2434;
                                                                                    phi_2678_ = _e2436;
                                                                                } else {
                                                                                    phi_2677_ = bool();
                                                                                    phi_2678_ = true;
                                                                                }
                                                                                let _e2438 = phi_2677_;
                                                                                let _e2440 = phi_2678_;
                                                                                if _e2440 {
                                                                                    phi_2682_ = false;
                                                                                } else {
                                                                                    phi_2682_ = _e2438;
                                                                                }
                                                                                let _e2442 = phi_2682_;
                                                                                phi_2683_ = _e2442;
                                                                            }
                                                                            let _e2444 = phi_2683_;
                                                                            if _e2444 {
                                                                                let _e2446 = triangles.member[(0u + _e1964)].i0_;
                                                                                if ((_e2446 & 2147483648u) == 0u) {
                                                                                    phi_2697_ = true;
                                                                                } else {
                                                                                    if true {
                                                                                    }
                                                                                    phi_2697_ = true;
                                                                                }
                                                                                let _e2450 = phi_2697_;
                                                                                if _e2450 {
                                                                                    phi_2705_ = lt_bvh_Hit(_e2412.t, _e2412.u, _e2412.v, _e1964, _e979);
                                                                                } else {
                                                                                    phi_2705_ = _e1953;
                                                                                }
                                                                                let _e2456 = phi_2705_;
                                                                                phi_2706_ = _e2456;
                                                                            } else {
                                                                                phi_2706_ = _e1953;
                                                                            }
                                                                            let _e2458 = phi_2706_;
                                                                            phi_2707_ = _e2458;
                                                                        } else {
                                                                            phi_2707_ = _e1953;
                                                                        }
                                                                        let _e2460 = phi_2707_;
                                                                        phi_2708_ = _e2460;
                                                                    } else {
                                                                        phi_2708_ = _e1953;
                                                                    }
                                                                    let _e2462 = phi_2708_;
                                                                    phi_2065_ = _e2462;
                                                                    phi_2068_ = (_e1955 & (_e1955 - 1u));
                                                                    phi_2709_ = true;
                                                                }
                                                                let _e2464 = phi_2065_;
                                                                let _e2466 = phi_2068_;
                                                                let _e2468 = phi_2709_;
                                                                continue;
                                                                continuing {
                                                                    phi_2064_ = _e2464;
                                                                    phi_2067_ = _e2466;
                                                                    break if !(_e2468);
                                                                }
                                                            }
                                                            let _e2471 = local.group_mask;
                                                            if ((_e2471 & 4278190080u) == 0u) {
                                                                let _e2475 = local.len;
                                                                if (_e2475 == 0u) {
                                                                    phi_2748_ = false;
                                                                } else {
                                                                    let _e2479 = local.len;
                                                                    local.len = (_e2479 - 1u);
                                                                    let _e2482 = local.len;
                                                                    if (_e2482 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2487 = local.first[(0u + _e2482)];
                                                                    local.group = _e2487;
                                                                    let _e2490 = local.len;
                                                                    if (_e2490 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2495 = local.mask[(0u + _e2490)];
                                                                    local.group_mask = _e2495;
                                                                    phi_2748_ = true;
                                                                }
                                                                let _e2498 = phi_2748_;
                                                                phi_2749_ = _e2498;
                                                            } else {
                                                                phi_2749_ = true;
                                                            }
                                                            let _e2500 = phi_2749_;
                                                            if _e2500 {
                                                                let _e2502 = local.group_mask;
                                                                let _e2508 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2502)), 32u, (_e2502 == 0u)));
                                                                let _e2512 = local.group_mask;
                                                                let _e2526 = local.group_mask;
                                                                local.group_mask = (_e2526 & ~((1u << bitcast<u32>((_e2508 & 31u)))));
                                                                let _e2529 = local.group;
                                                                phi_2780_ = (_e2529 + countOneBits(((_e2512 & ~((4294967295u << bitcast<u32>((((_e2508 - 24u) ^ _e1376) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_2780_ = 4294967295u;
                                                            }
                                                            let _e2532 = phi_2780_;
                                                            let _e3711 = local_8;
                                                            phi_1732_ = _e3711;
                                                            phi_1735_ = _e2532;
                                                        } else {
                                                            phi_1732_ = lt_bvh_Hit();
                                                            phi_1735_ = u32();
                                                        }
                                                        let _e2534 = phi_1732_;
                                                        let _e2536 = phi_1735_;
                                                        continue;
                                                        continuing {
                                                            phi_1731_ = _e2534;
                                                            phi_1734_ = _e2536;
                                                            break if !(_e1517);
                                                        }
                                                    }
                                                    let _e3715 = local_9;
                                                    phi_2781_ = _e3715;
                                                }
                                                let _e2539 = phi_2781_;
                                                phi_2782_ = _e2539;
                                                phi_2783_ = _e1202;
                                            } else {
                                                phi_2782_ = lt_bvh_Hit();
                                                phi_2783_ = true;
                                            }
                                            let _e2541 = phi_2782_;
                                            let _e2543 = phi_2783_;
                                            if _e2543 {
                                                phi_2787_ = _e971;
                                            } else {
                                                phi_2787_ = _e2541;
                                            }
                                            let _e2545 = phi_2787_;
                                            phi_2788_ = _e2545;
                                        } else {
                                            phi_2788_ = _e971;
                                        }
                                        let _e2547 = phi_2788_;
                                        phi_2789_ = _e2547;
                                    } else {
                                        phi_2789_ = _e971;
                                    }
                                    let _e2549 = phi_2789_;
                                    phi_2790_ = _e2549;
                                } else {
                                    phi_2790_ = _e971;
                                }
                                let _e2551 = phi_2790_;
                                phi_1106_ = (_e969 & (_e969 - 1u));
                                phi_1109_ = _e2551;
                                phi_2791_ = true;
                            }
                            let _e2553 = phi_1106_;
                            let _e2555 = phi_1109_;
                            let _e2557 = phi_2791_;
                            continue;
                            continuing {
                                phi_1105_ = _e2553;
                                phi_1108_ = _e2555;
                                break if !(_e2557);
                            }
                        }
                        let _e2560 = local_1.group_mask;
                        if ((_e2560 & 4278190080u) == 0u) {
                            let _e2564 = local_1.len;
                            if (_e2564 == 0u) {
                                phi_2830_ = false;
                            } else {
                                let _e2568 = local_1.len;
                                local_1.len = (_e2568 - 1u);
                                let _e2571 = local_1.len;
                                if (_e2571 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2576 = local_1.first[(0u + _e2571)];
                                local_1.group = _e2576;
                                let _e2579 = local_1.len;
                                if (_e2579 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2584 = local_1.mask[(0u + _e2579)];
                                local_1.group_mask = _e2584;
                                phi_2830_ = true;
                            }
                            let _e2587 = phi_2830_;
                            phi_2831_ = _e2587;
                        } else {
                            phi_2831_ = true;
                        }
                        let _e2589 = phi_2831_;
                        if _e2589 {
                            let _e2591 = local_1.group_mask;
                            let _e2597 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2591)), 32u, (_e2591 == 0u)));
                            let _e2601 = local_1.group_mask;
                            let _e2615 = local_1.group_mask;
                            local_1.group_mask = (_e2615 & ~((1u << bitcast<u32>((_e2597 & 31u)))));
                            let _e2618 = local_1.group;
                            phi_2862_ = (_e2618 + countOneBits(((_e2601 & ~((4294967295u << bitcast<u32>((((_e2597 - 24u) ^ _e388) & 31u))))) & 255u)));
                        } else {
                            phi_2862_ = 4294967295u;
                        }
                        let _e2621 = phi_2862_;
                        phi_769_ = _e2621;
                        let _e3731 = local_10;
                        phi_772_ = _e3731;
                    } else {
                        phi_769_ = u32();
                        phi_772_ = lt_bvh_Hit();
                    }
                    let _e2623 = phi_769_;
                    let _e2625 = phi_772_;
                    continue;
                    continuing {
                        phi_768_ = _e2623;
                        phi_771_ = _e2625;
                        break if !(_e529);
                    }
                }
                let _e3734 = local_11;
                phi_2863_ = _e3734;
            }
            let _e2628 = phi_2863_;
            phi_2864_ = _e2628;
            phi_2865_ = _e225;
        } else {
            phi_2864_ = lt_bvh_Hit();
            phi_2865_ = true;
        }
        let _e2630 = phi_2864_;
        let _e2632 = phi_2865_;
        if _e2632 {
            phi_2869_ = _e155;
        } else {
            phi_2869_ = _e2630;
        }
        let _e2634 = phi_2869_;
        if (_e2634.triangle != 4294967295u) {
            let _e2640 = ((1f - _e2634.u) - _e2634.v);
            if (_e2634.triangle < _e72) {
            } else {
                return;
            }
            let _e2646 = triangles.member[(0u + _e2634.triangle)];
            if (_e2634.instance < _e84) {
            } else {
                return;
            }
            let _e2657 = instances.member[(0u + _e2634.instance)].object_to_world[0u];
            let _e2668 = ((((_e2657.x * _e2646.v0_.x) + (_e2657.y * _e2646.v0_.y)) + (_e2657.z * _e2646.v0_.z)) + (_e2657.w * 1f));
            let _e2670 = instances.member[(0u + _e2634.instance)].object_to_world[1u];
            let _e2681 = ((((_e2670.x * _e2646.v0_.x) + (_e2670.y * _e2646.v0_.y)) + (_e2670.z * _e2646.v0_.z)) + (_e2670.w * 1f));
            let _e2683 = instances.member[(0u + _e2634.instance)].object_to_world[2u];
            let _e2694 = ((((_e2683.x * _e2646.v0_.x) + (_e2683.y * _e2646.v0_.y)) + (_e2683.z * _e2646.v0_.z)) + (_e2683.w * 1f));
            let _e2701 = instances.member[(0u + _e2634.instance)].object_to_world[0u];
            let _e2712 = ((((_e2701.x * _e2646.v1_.x) + (_e2701.y * _e2646.v1_.y)) + (_e2701.z * _e2646.v1_.z)) + (_e2701.w * 1f));
            let _e2714 = instances.member[(0u + _e2634.instance)].object_to_world[1u];
            let _e2725 = ((((_e2714.x * _e2646.v1_.x) + (_e2714.y * _e2646.v1_.y)) + (_e2714.z * _e2646.v1_.z)) + (_e2714.w * 1f));
            let _e2727 = instances.member[(0u + _e2634.instance)].object_to_world[2u];
            let _e2738 = ((((_e2727.x * _e2646.v1_.x) + (_e2727.y * _e2646.v1_.y)) + (_e2727.z * _e2646.v1_.z)) + (_e2727.w * 1f));
            let _e2745 = instances.member[(0u + _e2634.instance)].object_to_world[0u];
            let _e2756 = ((((_e2745.x * _e2646.v2_.x) + (_e2745.y * _e2646.v2_.y)) + (_e2745.z * _e2646.v2_.z)) + (_e2745.w * 1f));
            let _e2758 = instances.member[(0u + _e2634.instance)].object_to_world[1u];
            let _e2769 = ((((_e2758.x * _e2646.v2_.x) + (_e2758.y * _e2646.v2_.y)) + (_e2758.z * _e2646.v2_.z)) + (_e2758.w * 1f));
            let _e2771 = instances.member[(0u + _e2634.instance)].object_to_world[2u];
            let _e2782 = ((((_e2771.x * _e2646.v2_.x) + (_e2771.y * _e2646.v2_.y)) + (_e2771.z * _e2646.v2_.z)) + (_e2771.w * 1f));
            let _e2795 = (((_e2668 * _e2640) + (_e2712 * _e2634.u)) + (_e2756 * _e2634.v));
            let _e2796 = (((_e2681 * _e2640) + (_e2725 * _e2634.u)) + (_e2769 * _e2634.v));
            let _e2797 = (((_e2694 * _e2640) + (_e2738 * _e2634.u)) + (_e2782 * _e2634.v));
            let _e2799 = abs(_e2668);
            let _e2800 = abs(_e2681);
            let _e2801 = abs(_e2694);
            let _e2802 = abs(_e2712);
            let _e2803 = abs(_e2725);
            let _e2804 = abs(_e2738);
            if (_e2799 > _e2802) {
                phi_3057_ = _e2799;
            } else {
                phi_3057_ = _e2802;
            }
            let _e2807 = phi_3057_;
            if (_e2800 > _e2803) {
                phi_3062_ = _e2800;
            } else {
                phi_3062_ = _e2803;
            }
            let _e2810 = phi_3062_;
            if (_e2801 > _e2804) {
                phi_3067_ = _e2801;
            } else {
                phi_3067_ = _e2804;
            }
            let _e2813 = phi_3067_;
            let _e2814 = abs(_e2756);
            let _e2815 = abs(_e2769);
            let _e2816 = abs(_e2782);
            if (_e2807 > _e2814) {
                phi_3075_ = _e2807;
            } else {
                phi_3075_ = _e2814;
            }
            let _e2819 = phi_3075_;
            if (_e2810 > _e2815) {
                phi_3080_ = _e2810;
            } else {
                phi_3080_ = _e2815;
            }
            let _e2822 = phi_3080_;
            if (_e2813 > _e2816) {
                phi_3085_ = _e2813;
            } else {
                phi_3085_ = _e2816;
            }
            let _e2825 = phi_3085_;
            let _e2826 = (_e2712 - _e2668);
            let _e2827 = (_e2725 - _e2681);
            let _e2828 = (_e2738 - _e2694);
            let _e2829 = (_e2756 - _e2668);
            let _e2830 = (_e2769 - _e2681);
            let _e2831 = (_e2782 - _e2694);
            let _e2835 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2827), abs(_e2828));
            let _e2836 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2826), _e2835);
            let _e2837 = (_e2826 / _e2836);
            let _e2838 = (_e2827 / _e2836);
            let _e2839 = (_e2828 / _e2836);
            let _e2843 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2830), abs(_e2831));
            let _e2844 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2829), _e2843);
            let _e2845 = (_e2829 / _e2844);
            let _e2846 = (_e2830 / _e2844);
            let _e2847 = (_e2831 / _e2844);
            let _e2850 = ((_e2838 * _e2847) - (_e2846 * _e2839));
            let _e2853 = ((_e2839 * _e2845) - (_e2847 * _e2837));
            let _e2856 = ((_e2837 * _e2846) - (_e2845 * _e2838));
            let _e2858 = p.member.eye;
            let _e2871 = (1f / sqrt((((_e2850 * _e2850) + (_e2853 * _e2853)) + (_e2856 * _e2856))));
            let _e2872 = (_e2850 * _e2871);
            let _e2873 = (_e2853 * _e2871);
            let _e2874 = (_e2856 * _e2871);
            if ((((_e2872 * (_e2858.x - _e2795)) + (_e2873 * (_e2858.y - _e2796))) + (_e2874 * (_e2858.z - _e2797))) < 0f) {
                phi_3149_ = vec3<f32>(-(_e2872), -(_e2873), -(_e2874));
            } else {
                phi_3149_ = vec3<f32>(_e2872, _e2873, _e2874);
            }
            let _e2887 = phi_3149_;
            if (_e2634.triangle < _e72) {
            } else {
                return;
            }
            let _e2892 = triangles.member[(0u + _e2634.triangle)];
            let _e2894 = (_e2892.i0_ & 2147483647u);
            if (_e2894 < _e75) {
            } else {
                return;
            }
            let _e2900 = vertices.member[(0u + _e2894)];
            if (_e2892.i1_ < _e75) {
            } else {
                return;
            }
            let _e2904 = vertices.member[(0u + _e2892.i1_)];
            if (_e2892.i2_ < _e75) {
            } else {
                return;
            }
            let _e2908 = vertices.member[(0u + _e2892.i2_)];
            let _e2909 = array<abi_Vertex, 3>(_e2900, _e2904, _e2908);
            if (_e2909[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e2915 = materials.member[(0u + _e2909[0].material)];
            let _e2932 = (1f / 255f);
            let _e2951 = (1f / 255f);
            let _e2973 = (1f / 255f);
            let _e2986 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e2640, _e2634.u, _e2634.v));
            let _e2988 = ((_e2915.base_color.x * ((((f32((_e2909[0].color & 255u)) * _e2932) * _e2640) + ((f32((_e2909[1].color & 255u)) * _e2951) * _e2634.u)) + ((f32((_e2909[2].color & 255u)) * _e2973) * _e2634.v))) * _e2986.x);
            let _e2990 = ((_e2915.base_color.y * ((((f32(((_e2909[0].color >> bitcast<u32>(8i)) & 255u)) * _e2932) * _e2640) + ((f32(((_e2909[1].color >> bitcast<u32>(8i)) & 255u)) * _e2951) * _e2634.u)) + ((f32(((_e2909[2].color >> bitcast<u32>(8i)) & 255u)) * _e2973) * _e2634.v))) * _e2986.y);
            let _e2992 = ((_e2915.base_color.z * ((((f32(((_e2909[0].color >> bitcast<u32>(16i)) & 255u)) * _e2932) * _e2640) + ((f32(((_e2909[1].color >> bitcast<u32>(16i)) & 255u)) * _e2951) * _e2634.u)) + ((f32(((_e2909[2].color >> bitcast<u32>(16i)) & 255u)) * _e2973) * _e2634.v))) * _e2986.z);
            let _e2993 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2822, _e2825);
            let _e2994 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2819, _e2993);
            if ((_e2915.flags & 2u) == 0u) {
                phi_3270_ = 0u;
            } else {
                phi_3270_ = 1u;
            }
            let _e2999 = phi_3270_;
            if (_e2909[0].normal == 2147516416u) {
                phi_3500_ = _e2887;
            } else {
                let _e3012 = (f32((bitcast<i32>((_e2909[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3018 = (f32((bitcast<i32>(_e2909[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3022 = ((1f - abs(_e3012)) - abs(_e3018));
                if (_e3022 < 0f) {
                    phi_3297_ = -(_e3022);
                } else {
                    phi_3297_ = 0f;
                }
                let _e3026 = phi_3297_;
                if (_e3012 < 0f) {
                    phi_3304_ = (_e3012 + _e3026);
                } else {
                    phi_3304_ = (_e3012 - _e3026);
                }
                let _e3031 = phi_3304_;
                if (_e3018 < 0f) {
                    phi_3311_ = (_e3018 + _e3026);
                } else {
                    phi_3311_ = (_e3018 - _e3026);
                }
                let _e3036 = phi_3311_;
                let _e3043 = (1f / sqrt((((_e3031 * _e3031) + (_e3036 * _e3036)) + (_e3022 * _e3022))));
                let _e3059 = (f32((bitcast<i32>((_e2909[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3065 = (f32((bitcast<i32>(_e2909[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3069 = ((1f - abs(_e3059)) - abs(_e3065));
                if (_e3069 < 0f) {
                    phi_3346_ = -(_e3069);
                } else {
                    phi_3346_ = 0f;
                }
                let _e3073 = phi_3346_;
                if (_e3059 < 0f) {
                    phi_3353_ = (_e3059 + _e3073);
                } else {
                    phi_3353_ = (_e3059 - _e3073);
                }
                let _e3078 = phi_3353_;
                if (_e3065 < 0f) {
                    phi_3360_ = (_e3065 + _e3073);
                } else {
                    phi_3360_ = (_e3065 - _e3073);
                }
                let _e3083 = phi_3360_;
                let _e3090 = (1f / sqrt((((_e3078 * _e3078) + (_e3083 * _e3083)) + (_e3069 * _e3069))));
                let _e3109 = (f32((bitcast<i32>((_e2909[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3115 = (f32((bitcast<i32>(_e2909[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3119 = ((1f - abs(_e3109)) - abs(_e3115));
                if (_e3119 < 0f) {
                    phi_3398_ = -(_e3119);
                } else {
                    phi_3398_ = 0f;
                }
                let _e3123 = phi_3398_;
                if (_e3109 < 0f) {
                    phi_3405_ = (_e3109 + _e3123);
                } else {
                    phi_3405_ = (_e3109 - _e3123);
                }
                let _e3128 = phi_3405_;
                if (_e3115 < 0f) {
                    phi_3412_ = (_e3115 + _e3123);
                } else {
                    phi_3412_ = (_e3115 - _e3123);
                }
                let _e3133 = phi_3412_;
                let _e3140 = (1f / sqrt((((_e3128 * _e3128) + (_e3133 * _e3133)) + (_e3119 * _e3119))));
                let _e3147 = ((((_e3031 * _e3043) * _e2640) + ((_e3078 * _e3090) * _e2634.u)) + ((_e3128 * _e3140) * _e2634.v));
                let _e3148 = ((((_e3036 * _e3043) * _e2640) + ((_e3083 * _e3090) * _e2634.u)) + ((_e3133 * _e3140) * _e2634.v));
                let _e3149 = ((((_e3022 * _e3043) * _e2640) + ((_e3069 * _e3090) * _e2634.u)) + ((_e3119 * _e3140) * _e2634.v));
                if (_e2634.instance < _e84) {
                } else {
                    return;
                }
                let _e3156 = instances.member[(0u + _e2634.instance)].world_to_object[0u];
                let _e3165 = instances.member[(0u + _e2634.instance)].world_to_object[1u];
                let _e3177 = instances.member[(0u + _e2634.instance)].world_to_object[2u];
                let _e3184 = (((_e3156.x * _e3147) + (_e3165.x * _e3148)) + (_e3177.x * _e3149));
                let _e3185 = (((_e3156.y * _e3147) + (_e3165.y * _e3148)) + (_e3177.y * _e3149));
                let _e3186 = (((_e3156.z * _e3147) + (_e3165.z * _e3148)) + (_e3177.z * _e3149));
                let _e3192 = sqrt((((_e3184 * _e3184) + (_e3185 * _e3185)) + (_e3186 * _e3186)));
                if (_e3192 > 0f) {
                    let _e3194 = (_e3184 / _e3192);
                    let _e3195 = (_e3185 / _e3192);
                    let _e3196 = (_e3186 / _e3192);
                    if ((((_e3194 * _e2887.x) + (_e3195 * _e2887.y)) + (_e3196 * _e2887.z)) < 0f) {
                        phi_3498_ = vec3<f32>(-(_e3194), -(_e3195), -(_e3196));
                    } else {
                        phi_3498_ = vec3<f32>(_e3194, _e3195, _e3196);
                    }
                    let _e3212 = phi_3498_;
                    phi_3499_ = _e3212;
                } else {
                    phi_3499_ = _e2887;
                }
                let _e3214 = phi_3499_;
                phi_3500_ = _e3214;
            }
            let _e3216 = phi_3500_;
            if (_e2988 > 0f) {
                if (_e2988 < 1f) {
                    phi_3509_ = _e2988;
                } else {
                    phi_3509_ = 1f;
                }
                let _e3220 = phi_3509_;
                phi_3510_ = _e3220;
            } else {
                phi_3510_ = 0f;
            }
            let _e3222 = phi_3510_;
            if (_e2990 > 0f) {
                if (_e2990 < 1f) {
                    phi_3520_ = _e2990;
                } else {
                    phi_3520_ = 1f;
                }
                let _e3227 = phi_3520_;
                phi_3521_ = _e3227;
            } else {
                phi_3521_ = 0f;
            }
            let _e3229 = phi_3521_;
            if (_e2992 > 0f) {
                if (_e2992 < 1f) {
                    phi_3531_ = _e2992;
                } else {
                    phi_3531_ = 1f;
                }
                let _e3234 = phi_3531_;
                phi_3532_ = _e3234;
            } else {
                phi_3532_ = 0f;
            }
            let _e3236 = phi_3532_;
            let _e3239 = ((sqrt(_e3222) * 255f) + 0.5f);
            let _e3248 = ((sqrt(_e3229) * 255f) + 0.5f);
            let _e3260 = ((sqrt(_e3236) * 255f) + 0.5f);
            phi_3567_ = abi_Sample(vec3<f32>(_e2795, _e2796, _e2797), _e2994, _e2887, _e2999, _e3216, ((select(select(u32(_e3239), 0u, (_e3239 < bitcast<f32>(0u))), 4294967295u, (_e3239 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3248), 0u, (_e3248 < bitcast<f32>(0u))), 4294967295u, (_e3248 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3260), 0u, (_e3260 < bitcast<f32>(0u))), 4294967295u, (_e3260 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_3567_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3274 = phi_3567_;
        if (_e96.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e96.shift)] = _e3274;
        if (_e2634.triangle != 4294967295u) {
            let _e3283 = ((1f - _e2634.u) - _e2634.v);
            if (_e2634.triangle < _e72) {
            } else {
                return;
            }
            let _e3288 = triangles.member[(0u + _e2634.triangle)];
            let _e3290 = (_e3288.i0_ & 2147483647u);
            if (_e3290 < _e87) {
            } else {
                return;
            }
            let _e3296 = before.member[(0u + _e3290)];
            if (_e3288.i1_ < _e87) {
            } else {
                return;
            }
            let _e3300 = before.member[(0u + _e3288.i1_)];
            if (_e3288.i2_ < _e87) {
            } else {
                return;
            }
            let _e3304 = before.member[(0u + _e3288.i2_)];
            if (_e2634.instance < _e84) {
            } else {
                return;
            }
            let _e3314 = instances.member[(0u + _e2634.instance)].object_to_world[0u];
            let _e3327 = instances.member[(0u + _e2634.instance)].object_to_world[1u];
            let _e3340 = instances.member[(0u + _e2634.instance)].object_to_world[2u];
            if (_e2634.instance < _e84) {
            } else {
                return;
            }
            let _e3364 = instances.member[(0u + _e2634.instance)].object_to_world[0u];
            let _e3377 = instances.member[(0u + _e2634.instance)].object_to_world[1u];
            let _e3390 = instances.member[(0u + _e2634.instance)].object_to_world[2u];
            if (_e2634.instance < _e84) {
            } else {
                return;
            }
            let _e3417 = instances.member[(0u + _e2634.instance)].object_to_world[0u];
            let _e3430 = instances.member[(0u + _e2634.instance)].object_to_world[1u];
            let _e3443 = instances.member[(0u + _e2634.instance)].object_to_world[2u];
            phi_3790_ = vec3<f32>((((((((_e3314.x * _e3296.x) + (_e3314.y * _e3296.y)) + (_e3314.z * _e3296.z)) + (_e3314.w * 1f)) * _e3283) + (((((_e3364.x * _e3300.x) + (_e3364.y * _e3300.y)) + (_e3364.z * _e3300.z)) + (_e3364.w * 1f)) * _e2634.u)) + (((((_e3417.x * _e3304.x) + (_e3417.y * _e3304.y)) + (_e3417.z * _e3304.z)) + (_e3417.w * 1f)) * _e2634.v)), (((((((_e3327.x * _e3296.x) + (_e3327.y * _e3296.y)) + (_e3327.z * _e3296.z)) + (_e3327.w * 1f)) * _e3283) + (((((_e3377.x * _e3300.x) + (_e3377.y * _e3300.y)) + (_e3377.z * _e3300.z)) + (_e3377.w * 1f)) * _e2634.u)) + (((((_e3430.x * _e3304.x) + (_e3430.y * _e3304.y)) + (_e3430.z * _e3304.z)) + (_e3430.w * 1f)) * _e2634.v)), (((((((_e3340.x * _e3296.x) + (_e3340.y * _e3296.y)) + (_e3340.z * _e3296.z)) + (_e3340.w * 1f)) * _e3283) + (((((_e3390.x * _e3300.x) + (_e3390.y * _e3300.y)) + (_e3390.z * _e3300.z)) + (_e3390.w * 1f)) * _e2634.u)) + (((((_e3443.x * _e3304.x) + (_e3443.y * _e3304.y)) + (_e3443.z * _e3304.z)) + (_e3443.w * 1f)) * _e2634.v)));
        } else {
            phi_3790_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e3463 = phi_3790_;
        if (_e96.shift < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e96.shift)] = vec4<f32>(_e3463.x, _e3463.y, _e3463.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
