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
                let _e301 = phi_516_;
                if (_e153.direction.x < 0f) {
                    phi_523_ = (-1f / _e301);
                } else {
                    phi_523_ = (1f / _e301);
                }
                let _e306 = phi_523_;
                if (abs(_e153.direction.y) < _e295) {
                    phi_531_ = _e295;
                } else {
                    phi_531_ = abs(_e153.direction.y);
                }
                let _e312 = phi_531_;
                if (_e153.direction.y < 0f) {
                    phi_538_ = (-1f / _e312);
                } else {
                    phi_538_ = (1f / _e312);
                }
                let _e317 = phi_538_;
                if (abs(_e153.direction.z) < _e295) {
                    phi_546_ = _e295;
                } else {
                    phi_546_ = abs(_e153.direction.z);
                }
                let _e323 = phi_546_;
                if (_e153.direction.z < 0f) {
                    phi_553_ = (-1f / _e323);
                } else {
                    phi_553_ = (1f / _e323);
                }
                let _e328 = phi_553_;
                let _e336 = abs((bitcast<f32>(_e231) - _e153.origin.x));
                let _e337 = abs((bitcast<f32>(_e235) - _e153.origin.y));
                let _e338 = abs((bitcast<f32>(_e239) - _e153.origin.z));
                let _e346 = abs(((bitcast<f32>(_e243) + (bitcast<f32>((((_e255 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e153.origin.x));
                let _e347 = abs(((bitcast<f32>(_e247) + (bitcast<f32>((((_e255 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e153.origin.y));
                let _e348 = abs(((bitcast<f32>(_e251) + (bitcast<f32>((((_e255 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e153.origin.z));
                if (_e336 > _e346) {
                    phi_578_ = _e336;
                } else {
                    phi_578_ = _e346;
                }
                let _e351 = phi_578_;
                if (_e337 > _e347) {
                    phi_583_ = _e337;
                } else {
                    phi_583_ = _e347;
                }
                let _e354 = phi_583_;
                if (_e338 > _e348) {
                    phi_588_ = _e338;
                } else {
                    phi_588_ = _e348;
                }
                let _e357 = phi_588_;
                let _e358 = core_intrinsics_maximum_number_nsz_f32_(_e351, _e354);
                let _e359 = core_intrinsics_maximum_number_nsz_f32_(_e358, _e357);
                let _e364 = (_e359 * 0.0000019073486f);
                let _e365 = (abs(_e306) * _e364);
                let _e366 = (abs(_e317) * _e364);
                let _e367 = (abs(_e328) * _e364);
                let _e371 = (_e359 * 0.0000009536743f);
                let _e372 = (abs(_e306) * _e371);
                let _e373 = (abs(_e317) * _e371);
                let _e374 = (abs(_e328) * _e371);
                if (_e306 < 0f) {
                    phi_610_ = 0u;
                } else {
                    phi_610_ = 1u;
                }
                let _e377 = phi_610_;
                if (_e317 < 0f) {
                    phi_615_ = 0u;
                } else {
                    phi_615_ = 2u;
                }
                let _e380 = phi_615_;
                if (_e328 < 0f) {
                    phi_620_ = 0u;
                } else {
                    phi_620_ = 4u;
                }
                let _e383 = phi_620_;
                let _e385 = ((_e377 | _e380) | _e383);
                let _e386 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e102, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e386.first[0], _e386.first[1], _e386.first[2], _e386.first[3], _e386.first[4], _e386.first[5], _e386.first[6], _e386.first[7], _e386.first[8], _e386.first[9], _e386.first[10], _e386.first[11], _e386.first[12], _e386.first[13], _e386.first[14], _e386.first[15], _e386.first[16], _e386.first[17], _e386.first[18], _e386.first[19], _e386.first[20], _e386.first[21], _e386.first[22], _e386.first[23], _e386.first[24], _e386.first[25], _e386.first[26], _e386.first[27], _e386.first[28], _e386.first[29], _e386.first[30], _e386.first[31]), array<u32, 32>(_e386.mask[0], _e386.mask[1], _e386.mask[2], _e386.mask[3], _e386.mask[4], _e386.mask[5], _e386.mask[6], _e386.mask[7], _e386.mask[8], _e386.mask[9], _e386.mask[10], _e386.mask[11], _e386.mask[12], _e386.mask[13], _e386.mask[14], _e386.mask[15], _e386.mask[16], _e386.mask[17], _e386.mask[18], _e386.mask[19], _e386.mask[20], _e386.mask[21], _e386.mask[22], _e386.mask[23], _e386.mask[24], _e386.mask[25], _e386.mask[26], _e386.mask[27], _e386.mask[28], _e386.mask[29], _e386.mask[30], _e386.mask[31]), _e386.len, _e386.group, _e386.group_mask);
                let _e460 = local_1.group_mask;
                if ((_e460 & 4278190080u) == 0u) {
                    let _e464 = local_1.len;
                    if (_e464 == 0u) {
                        phi_734_ = false;
                    } else {
                        let _e468 = local_1.len;
                        local_1.len = (_e468 - 1u);
                        let _e471 = local_1.len;
                        if (_e471 < 32u) {
                        } else {
                            return;
                        }
                        let _e476 = local_1.first[(0u + _e471)];
                        local_1.group = _e476;
                        let _e479 = local_1.len;
                        if (_e479 < 32u) {
                        } else {
                            return;
                        }
                        let _e484 = local_1.mask[(0u + _e479)];
                        local_1.group_mask = _e484;
                        phi_734_ = true;
                    }
                    let _e487 = phi_734_;
                    phi_735_ = _e487;
                } else {
                    phi_735_ = true;
                }
                let _e489 = phi_735_;
                if _e489 {
                    let _e491 = local_1.group_mask;
                    let _e497 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e491)), 32u, (_e491 == 0u)));
                    let _e501 = local_1.group_mask;
                    let _e515 = local_1.group_mask;
                    local_1.group_mask = (_e515 & ~((1u << bitcast<u32>((_e497 & 31u)))));
                    let _e518 = local_1.group;
                    phi_766_ = (_e518 + countOneBits(((_e501 & ~((4294967295u << bitcast<u32>((((_e497 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_766_ = 4294967295u;
                }
                let _e521 = phi_766_;
                phi_768_ = _e521;
                phi_771_ = _e155;
                loop {
                    let _e523 = phi_768_;
                    let _e525 = phi_771_;
                    local_11 = _e525;
                    let _e526 = (_e523 != 4294967295u);
                    if _e526 {
                        if (_e523 < _e69) {
                        } else {
                            return;
                        }
                        let _e534 = nodes.member[(0u + _e523)].frame[3u];
                        let _e559 = (bitcast<f32>((((_e534 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e306);
                        let _e560 = (bitcast<f32>((((_e534 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e317);
                        let _e561 = (bitcast<f32>((((_e534 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e328);
                        let _e564 = nodes.member[(0u + _e523)].frame[0u];
                        let _e568 = nodes.member[(0u + _e523)].frame[1u];
                        let _e572 = nodes.member[(0u + _e523)].frame[2u];
                        let _e580 = ((bitcast<f32>(_e564) - _e153.origin.x) * _e306);
                        let _e581 = ((bitcast<f32>(_e568) - _e153.origin.y) * _e317);
                        let _e582 = ((bitcast<f32>(_e572) - _e153.origin.z) * _e328);
                        let _e590 = nodes.member[(0u + _e523)].x;
                        if (_e306 < 0f) {
                            let _e601 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e590.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e607 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e601.unnamed.word, _e590.w), _e601.unnamed_1);
                            let _e613 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e607.unnamed, lt_mask_LightPlace(_e590.x, _e607.unnamed_1.shift));
                            phi_856_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e613.unnamed, lt_mask_LightPlace(_e613.unnamed_1.word, _e590.y));
                        } else {
                            let _e629 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e590.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e635 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e629.unnamed.word, _e590.y), _e629.unnamed_1);
                            let _e641 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e635.unnamed, lt_mask_LightPlace(_e590.z, _e635.unnamed_1.shift));
                            phi_856_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e641.unnamed, lt_mask_LightPlace(_e641.unnamed_1.word, _e590.w));
                        }
                        let _e649 = phi_856_;
                        let _e659 = nodes.member[(0u + _e523)].y;
                        if (_e317 < 0f) {
                            let _e670 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e659.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e676 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e670.unnamed.word, _e659.w), _e670.unnamed_1);
                            let _e682 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e676.unnamed, lt_mask_LightPlace(_e659.x, _e676.unnamed_1.shift));
                            phi_883_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e682.unnamed, lt_mask_LightPlace(_e682.unnamed_1.word, _e659.y));
                        } else {
                            let _e698 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e659.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e704 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e698.unnamed.word, _e659.y), _e698.unnamed_1);
                            let _e710 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e704.unnamed, lt_mask_LightPlace(_e659.z, _e704.unnamed_1.shift));
                            phi_883_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e710.unnamed, lt_mask_LightPlace(_e710.unnamed_1.word, _e659.w));
                        }
                        let _e718 = phi_883_;
                        let _e728 = nodes.member[(0u + _e523)].z;
                        if (_e328 < 0f) {
                            let _e739 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e728.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e745 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e739.unnamed.word, _e728.w), _e739.unnamed_1);
                            let _e751 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e745.unnamed, lt_mask_LightPlace(_e728.x, _e745.unnamed_1.shift));
                            phi_910_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e751.unnamed, lt_mask_LightPlace(_e751.unnamed_1.word, _e728.y));
                        } else {
                            let _e767 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e728.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e773 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e767.unnamed.word, _e728.y), _e767.unnamed_1);
                            let _e779 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e773.unnamed, lt_mask_LightPlace(_e728.z, _e773.unnamed_1.shift));
                            phi_910_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e779.unnamed, lt_mask_LightPlace(_e779.unnamed_1.word, _e728.w));
                        }
                        let _e787 = phi_910_;
                        phi_916_ = 0u;
                        phi_919_ = 0u;
                        loop {
                            let _e797 = phi_916_;
                            let _e799 = phi_919_;
                            local_2 = _e799;
                            local_3 = _e799;
                            local_4 = _e799;
                            let _e800 = (_e797 < 8u);
                            if _e800 {
                                let _e802 = (_e797 >> bitcast<u32>(2i));
                                let _e803 = (_e797 & 3u);
                                if (_e802 == 0u) {
                                    phi_933_ = _e649.unnamed.word;
                                } else {
                                    phi_933_ = _e649.unnamed.shift;
                                }
                                let _e806 = phi_933_;
                                if (_e802 == 0u) {
                                    phi_943_ = _e718.unnamed.word;
                                } else {
                                    phi_943_ = _e718.unnamed.shift;
                                }
                                let _e815 = phi_943_;
                                if (_e802 == 0u) {
                                    phi_953_ = _e787.unnamed.word;
                                } else {
                                    phi_953_ = _e787.unnamed.shift;
                                }
                                let _e824 = phi_953_;
                                let _e837 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e806 >> bitcast<u32>(((_e803 * 8u) & 31u))) & 255u)) * _e559) + (_e580 - _e365)), ((f32(((_e815 >> bitcast<u32>(((_e803 * 8u) & 31u))) & 255u)) * _e560) + (_e581 - _e366)));
                                let _e838 = core_intrinsics_maximum_number_nsz_f32_(_e837, ((f32(((_e824 >> bitcast<u32>(((_e803 * 8u) & 31u))) & 255u)) * _e561) + (_e582 - _e367)));
                                if (_e802 == 0u) {
                                    phi_971_ = _e649.unnamed_1.word;
                                } else {
                                    phi_971_ = _e649.unnamed_1.shift;
                                }
                                let _e841 = phi_971_;
                                if (_e802 == 0u) {
                                    phi_981_ = _e718.unnamed_1.word;
                                } else {
                                    phi_981_ = _e718.unnamed_1.shift;
                                }
                                let _e850 = phi_981_;
                                if (_e802 == 0u) {
                                    phi_991_ = _e787.unnamed_1.word;
                                } else {
                                    phi_991_ = _e787.unnamed_1.shift;
                                }
                                let _e859 = phi_991_;
                                let _e872 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e841 >> bitcast<u32>(((_e803 * 8u) & 31u))) & 255u)) * _e559) + (_e580 + _e365)), ((f32(((_e850 >> bitcast<u32>(((_e803 * 8u) & 31u))) & 255u)) * _e560) + (_e581 + _e366)));
                                let _e873 = core_intrinsics_minimum_number_nsz_f32_(_e872, ((f32(((_e859 >> bitcast<u32>(((_e803 * 8u) & 31u))) & 255u)) * _e561) + (_e582 + _e367)));
                                if (_e838 <= _e873) {
                                    if (_e838 <= _e525.t) {
                                        if (_e873 >= _e153.tmin) {
                                            if (_e802 == 0u) {
                                                let _e880 = nodes.member[(0u + _e523)].links[2u];
                                                phi_1027_ = _e880;
                                            } else {
                                                let _e883 = nodes.member[(0u + _e523)].links[3u];
                                                phi_1027_ = _e883;
                                            }
                                            let _e885 = phi_1027_;
                                            let _e890 = ((_e885 >> bitcast<u32>(((_e803 * 8u) & 31u))) & 255u);
                                            let _e891 = (_e890 & 31u);
                                            if (_e891 >= 24u) {
                                                phi_1040_ = (24u + ((_e891 - 24u) ^ _e385));
                                            } else {
                                                phi_1040_ = _e891;
                                            }
                                            let _e897 = phi_1040_;
                                            phi_1045_ = (_e799 | ((_e890 >> bitcast<u32>(5i)) << bitcast<u32>((_e897 & 31u))));
                                        } else {
                                            phi_1045_ = _e799;
                                        }
                                        let _e905 = phi_1045_;
                                        phi_1046_ = _e905;
                                    } else {
                                        phi_1046_ = _e799;
                                    }
                                    let _e907 = phi_1046_;
                                    phi_1047_ = _e907;
                                } else {
                                    phi_1047_ = _e799;
                                }
                                let _e909 = phi_1047_;
                                phi_917_ = (_e797 + 1u);
                                phi_920_ = _e909;
                            } else {
                                phi_917_ = u32();
                                phi_920_ = u32();
                            }
                            let _e912 = phi_917_;
                            let _e914 = phi_920_;
                            continue;
                            continuing {
                                phi_916_ = _e912;
                                phi_919_ = _e914;
                                break if !(_e800);
                            }
                        }
                        let _e918 = nodes.member[(0u + _e523)].links[0u];
                        let _e922 = nodes.member[(0u + _e523)].frame[3u];
                        let _e926 = local_2;
                        if ((_e926 & 4278190080u) == 0u) {
                        } else {
                            let _e930 = local_1.group_mask;
                            if ((_e930 & 4278190080u) == 0u) {
                            } else {
                                let _e934 = local_1.len;
                                if (_e934 < 32u) {
                                    let _e937 = local_1.group;
                                    let _e939 = local_1.len;
                                    if (_e939 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e939)] = _e937;
                                    let _e945 = local_1.group_mask;
                                    let _e947 = local_1.len;
                                    if (_e947 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e947)] = _e945;
                                    let _e954 = local_1.len;
                                    local_1.len = (_e954 + 1u);
                                }
                            }
                            local_1.group = (_e102 + _e918);
                            let _e958 = local_3;
                            local_1.group_mask = ((_e958 & 4278190080u) | (_e922 >> bitcast<u32>(24i)));
                        }
                        let _e963 = local_4;
                        phi_1105_ = (_e963 & 16777215u);
                        phi_1108_ = _e525;
                        loop {
                            let _e966 = phi_1105_;
                            let _e968 = phi_1108_;
                            local_10 = _e968;
                            if (_e966 == 0u) {
                                phi_1106_ = u32();
                                phi_1109_ = lt_bvh_Hit();
                                phi_2791_ = false;
                            } else {
                                let _e972 = nodes.member[(0u + _e523)].links[1u];
                                let _e976 = (_e972 + select(firstTrailingBit(_e966), 32u, (_e966 == 0u)));
                                if (_e976 < _e84) {
                                } else {
                                    return;
                                }
                                let _e983 = instances.member[(0u + _e976)].low_world;
                                let _e985 = instances.member[(0u + _e976)].high_world;
                                let _e995 = ((_e983.x - _e153.origin.x) * _e306);
                                let _e996 = ((_e983.y - _e153.origin.y) * _e317);
                                let _e997 = ((_e983.z - _e153.origin.z) * _e328);
                                let _e1007 = ((_e985.x - _e153.origin.x) * _e306);
                                let _e1008 = ((_e985.y - _e153.origin.y) * _e317);
                                let _e1009 = ((_e985.z - _e153.origin.z) * _e328);
                                if (_e995 < _e1007) {
                                    phi_1163_ = _e995;
                                } else {
                                    phi_1163_ = _e1007;
                                }
                                let _e1012 = phi_1163_;
                                if (_e996 < _e1008) {
                                    phi_1168_ = _e996;
                                } else {
                                    phi_1168_ = _e1008;
                                }
                                let _e1015 = phi_1168_;
                                if (_e997 < _e1009) {
                                    phi_1173_ = _e997;
                                } else {
                                    phi_1173_ = _e1009;
                                }
                                let _e1018 = phi_1173_;
                                if (_e995 > _e1007) {
                                    phi_1181_ = _e995;
                                } else {
                                    phi_1181_ = _e1007;
                                }
                                let _e1024 = phi_1181_;
                                if (_e996 > _e1008) {
                                    phi_1186_ = _e996;
                                } else {
                                    phi_1186_ = _e1008;
                                }
                                let _e1027 = phi_1186_;
                                if (_e997 > _e1009) {
                                    phi_1191_ = _e997;
                                } else {
                                    phi_1191_ = _e1009;
                                }
                                let _e1030 = phi_1191_;
                                let _e1034 = core_intrinsics_maximum_number_nsz_f32_((_e1012 - _e372), (_e1015 - _e373));
                                let _e1035 = core_intrinsics_maximum_number_nsz_f32_(_e1034, (_e1018 - _e374));
                                let _e1036 = core_intrinsics_minimum_number_nsz_f32_((_e1024 + _e372), (_e1027 + _e373));
                                let _e1037 = core_intrinsics_minimum_number_nsz_f32_(_e1036, (_e1030 + _e374));
                                if (_e1035 <= _e1037) {
                                    if (_e1035 <= _e968.t) {
                                        if (_e1037 >= _e153.tmin) {
                                            let _e1049 = instances.member[(0u + _e976)].world_to_object[0u];
                                            let _e1060 = ((((_e1049.x * _e153.origin.x) + (_e1049.y * _e153.origin.y)) + (_e1049.z * _e153.origin.z)) + (_e1049.w * 1f));
                                            let _e1062 = instances.member[(0u + _e976)].world_to_object[1u];
                                            let _e1073 = ((((_e1062.x * _e153.origin.x) + (_e1062.y * _e153.origin.y)) + (_e1062.z * _e153.origin.z)) + (_e1062.w * 1f));
                                            let _e1075 = instances.member[(0u + _e976)].world_to_object[2u];
                                            let _e1086 = ((((_e1075.x * _e153.origin.x) + (_e1075.y * _e153.origin.y)) + (_e1075.z * _e153.origin.z)) + (_e1075.w * 1f));
                                            let _e1093 = instances.member[(0u + _e976)].world_to_object[0u];
                                            let _e1104 = ((((_e1093.x * _e153.direction.x) + (_e1093.y * _e153.direction.y)) + (_e1093.z * _e153.direction.z)) + (_e1093.w * 0f));
                                            let _e1106 = instances.member[(0u + _e976)].world_to_object[1u];
                                            let _e1117 = ((((_e1106.x * _e153.direction.x) + (_e1106.y * _e153.direction.y)) + (_e1106.z * _e153.direction.z)) + (_e1106.w * 0f));
                                            let _e1119 = instances.member[(0u + _e976)].world_to_object[2u];
                                            let _e1130 = ((((_e1119.x * _e153.direction.x) + (_e1119.y * _e153.direction.y)) + (_e1119.z * _e153.direction.z)) + (_e1119.w * 0f));
                                            let _e1135 = instances.member[(0u + _e976)].root;
                                            let _e1137 = instances.member[(0u + _e976)].first_triangle;
                                            let _e1141 = abs(_e1104);
                                            let _e1142 = abs(_e1117);
                                            let _e1143 = abs(_e1130);
                                            if (abs(_e1060) < 1000000000000000f) {
                                                if (abs(_e1073) < 1000000000000000f) {
                                                    if (abs(_e1086) < 1000000000000000f) {
                                                        if (_e1141 < 1000000000000000f) {
                                                            if (_e1142 < 1000000000000000f) {
                                                                if (_e1143 < 1000000000000000f) {
                                                                    if (_e1141 > 0f) {
                                                                        phi_1348_ = bool();
                                                                        phi_1349_ = true;
                                                                    } else {
                                                                        let _e1151 = (_e1142 > 0f);
                                                                        if _e1151 {
                                                                            phi_1347_ = bool();
                                                                        } else {
                                                                            phi_1347_ = (_e1143 > 0f);
                                                                        }
                                                                        let _e1154 = phi_1347_;
                                                                        phi_1348_ = _e1154;
                                                                        phi_1349_ = _e1151;
                                                                    }
                                                                    let _e1156 = phi_1348_;
                                                                    let _e1158 = phi_1349_;
                                                                    if _e1158 {
                                                                        phi_1353_ = true;
                                                                    } else {
                                                                        phi_1353_ = _e1156;
                                                                    }
                                                                    let _e1160 = phi_1353_;
                                                                    phi_1354_ = _e1160;
                                                                    phi_1355_ = false;
                                                                } else {
                                                                    phi_1354_ = bool();
                                                                    phi_1355_ = true;
                                                                }
                                                                let _e1162 = phi_1354_;
                                                                let _e1164 = phi_1355_;
                                                                phi_1356_ = _e1162;
                                                                phi_1357_ = false;
                                                                phi_1358_ = _e1164;
                                                            } else {
                                                                phi_1356_ = bool();
                                                                phi_1357_ = true;
                                                                phi_1358_ = false;
                                                            }
                                                            let _e1166 = phi_1356_;
                                                            let _e1168 = phi_1357_;
                                                            let _e1170 = phi_1358_;
                                                            phi_1359_ = _e1166;
                                                            phi_1360_ = _e1168;
                                                            phi_1361_ = _e1170;
                                                        } else {
                                                            phi_1359_ = bool();
                                                            phi_1360_ = true;
                                                            phi_1361_ = false;
                                                        }
                                                        let _e1172 = phi_1359_;
                                                        let _e1174 = phi_1360_;
                                                        let _e1176 = phi_1361_;
                                                        phi_1362_ = _e1172;
                                                        phi_1363_ = _e1174;
                                                        phi_1364_ = _e1176;
                                                    } else {
                                                        phi_1362_ = bool();
                                                        phi_1363_ = true;
                                                        phi_1364_ = false;
                                                    }
                                                    let _e1178 = phi_1362_;
                                                    let _e1180 = phi_1363_;
                                                    let _e1182 = phi_1364_;
                                                    phi_1365_ = _e1178;
                                                    phi_1366_ = _e1180;
                                                    phi_1367_ = _e1182;
                                                } else {
                                                    phi_1365_ = bool();
                                                    phi_1366_ = true;
                                                    phi_1367_ = false;
                                                }
                                                let _e1184 = phi_1365_;
                                                let _e1186 = phi_1366_;
                                                let _e1188 = phi_1367_;
                                                phi_1368_ = _e1184;
                                                phi_1369_ = _e1186;
                                                phi_1370_ = _e1188;
                                            } else {
                                                phi_1368_ = bool();
                                                phi_1369_ = true;
                                                phi_1370_ = false;
                                            }
                                            let _e1190 = phi_1368_;
                                            let _e1192 = phi_1369_;
                                            let _e1194 = phi_1370_;
                                            if _e1192 {
                                                phi_1374_ = true;
                                            } else {
                                                phi_1374_ = _e1194;
                                            }
                                            let _e1196 = phi_1374_;
                                            if _e1196 {
                                                phi_1378_ = false;
                                            } else {
                                                phi_1378_ = _e1190;
                                            }
                                            let _e1198 = phi_1378_;
                                            if _e1198 {
                                                let _e1199 = (_e1135 >= _e69);
                                                if _e1199 {
                                                    phi_2781_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1135 < _e69) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1205 = nodes.member[(0u + _e1135)].frame[0u];
                                                    let _e1209 = nodes.member[(0u + _e1135)].frame[1u];
                                                    let _e1213 = nodes.member[(0u + _e1135)].frame[2u];
                                                    let _e1217 = nodes.member[(0u + _e1135)].frame[0u];
                                                    let _e1221 = nodes.member[(0u + _e1135)].frame[1u];
                                                    let _e1225 = nodes.member[(0u + _e1135)].frame[2u];
                                                    let _e1229 = nodes.member[(0u + _e1135)].frame[3u];
                                                    let _e1263 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1104), abs(_e1117));
                                                    let _e1264 = core_intrinsics_maximum_number_nsz_f32_(_e1263, abs(_e1130));
                                                    let _e1265 = (_e1264 * 0.0000000000009094947f);
                                                    if (abs(_e1104) < _e1265) {
                                                        phi_1448_ = _e1265;
                                                    } else {
                                                        phi_1448_ = abs(_e1104);
                                                    }
                                                    let _e1270 = phi_1448_;
                                                    if (_e1104 < 0f) {
                                                        phi_1455_ = (-1f / _e1270);
                                                    } else {
                                                        phi_1455_ = (1f / _e1270);
                                                    }
                                                    let _e1275 = phi_1455_;
                                                    if (abs(_e1117) < _e1265) {
                                                        phi_1462_ = _e1265;
                                                    } else {
                                                        phi_1462_ = abs(_e1117);
                                                    }
                                                    let _e1280 = phi_1462_;
                                                    if (_e1117 < 0f) {
                                                        phi_1469_ = (-1f / _e1280);
                                                    } else {
                                                        phi_1469_ = (1f / _e1280);
                                                    }
                                                    let _e1285 = phi_1469_;
                                                    if (abs(_e1130) < _e1265) {
                                                        phi_1476_ = _e1265;
                                                    } else {
                                                        phi_1476_ = abs(_e1130);
                                                    }
                                                    let _e1290 = phi_1476_;
                                                    if (_e1130 < 0f) {
                                                        phi_1483_ = (-1f / _e1290);
                                                    } else {
                                                        phi_1483_ = (1f / _e1290);
                                                    }
                                                    let _e1295 = phi_1483_;
                                                    let _e1299 = abs((bitcast<f32>(_e1205) - _e1060));
                                                    let _e1300 = abs((bitcast<f32>(_e1209) - _e1073));
                                                    let _e1301 = abs((bitcast<f32>(_e1213) - _e1086));
                                                    let _e1305 = abs(((bitcast<f32>(_e1217) + (bitcast<f32>((((_e1229 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1060));
                                                    let _e1306 = abs(((bitcast<f32>(_e1221) + (bitcast<f32>((((_e1229 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1073));
                                                    let _e1307 = abs(((bitcast<f32>(_e1225) + (bitcast<f32>((((_e1229 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1086));
                                                    if (_e1299 > _e1305) {
                                                        phi_1500_ = _e1299;
                                                    } else {
                                                        phi_1500_ = _e1305;
                                                    }
                                                    let _e1310 = phi_1500_;
                                                    if (_e1300 > _e1306) {
                                                        phi_1505_ = _e1300;
                                                    } else {
                                                        phi_1505_ = _e1306;
                                                    }
                                                    let _e1313 = phi_1505_;
                                                    if (_e1301 > _e1307) {
                                                        phi_1510_ = _e1301;
                                                    } else {
                                                        phi_1510_ = _e1307;
                                                    }
                                                    let _e1316 = phi_1510_;
                                                    let _e1317 = core_intrinsics_maximum_number_nsz_f32_(_e1310, _e1313);
                                                    let _e1318 = core_intrinsics_maximum_number_nsz_f32_(_e1317, _e1316);
                                                    let _e1322 = (_e1318 * 0.0000019073486f);
                                                    let _e1323 = (abs(_e1275) * _e1322);
                                                    let _e1324 = (abs(_e1285) * _e1322);
                                                    let _e1325 = (abs(_e1295) * _e1322);
                                                    let _e1329 = (_e1318 * 0.0000009536743f);
                                                    let _e1330 = (abs(_e1275) * _e1329);
                                                    let _e1331 = (abs(_e1285) * _e1329);
                                                    let _e1332 = (abs(_e1295) * _e1329);
                                                    let _e1333 = abs(_e1104);
                                                    let _e1334 = abs(_e1117);
                                                    let _e1335 = abs(_e1130);
                                                    if (_e1333 >= _e1334) {
                                                        if (_e1333 >= _e1335) {
                                                            phi_1538_ = false;
                                                        } else {
                                                            phi_1538_ = true;
                                                        }
                                                        let _e1339 = phi_1538_;
                                                        phi_1539_ = _e1339;
                                                    } else {
                                                        phi_1539_ = true;
                                                    }
                                                    let _e1341 = phi_1539_;
                                                    if _e1341 {
                                                        if (_e1334 >= _e1335) {
                                                            phi_1547_ = 1u;
                                                        } else {
                                                            phi_1547_ = 2u;
                                                        }
                                                        let _e1344 = phi_1547_;
                                                        phi_1548_ = _e1344;
                                                    } else {
                                                        phi_1548_ = 0u;
                                                    }
                                                    let _e1346 = phi_1548_;
                                                    if (_e1346 == 0u) {
                                                        phi_1560_ = vec3<f32>(_e1117, _e1130, _e1104);
                                                    } else {
                                                        if (_e1346 == 1u) {
                                                            phi_1559_ = vec3<f32>(_e1130, _e1104, _e1117);
                                                        } else {
                                                            phi_1559_ = vec3<f32>(_e1104, _e1117, _e1130);
                                                        }
                                                        let _e1352 = phi_1559_;
                                                        phi_1560_ = _e1352;
                                                    }
                                                    let _e1354 = phi_1560_;
                                                    let _e1357 = (_e1354.x / _e1354.z);
                                                    let _e1360 = (_e1354.y / _e1354.z);
                                                    if (_e1275 < 0f) {
                                                        phi_1573_ = 0u;
                                                    } else {
                                                        phi_1573_ = 1u;
                                                    }
                                                    let _e1365 = phi_1573_;
                                                    if (_e1285 < 0f) {
                                                        phi_1578_ = 0u;
                                                    } else {
                                                        phi_1578_ = 2u;
                                                    }
                                                    let _e1368 = phi_1578_;
                                                    if (_e1295 < 0f) {
                                                        phi_1583_ = 0u;
                                                    } else {
                                                        phi_1583_ = 4u;
                                                    }
                                                    let _e1371 = phi_1583_;
                                                    let _e1373 = ((_e1365 | _e1368) | _e1371);
                                                    let _e1374 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1135, 2147483648u);
                                                    local = lt_bvh_traverse_Stack(array<u32, 32>(_e1374.first[0], _e1374.first[1], _e1374.first[2], _e1374.first[3], _e1374.first[4], _e1374.first[5], _e1374.first[6], _e1374.first[7], _e1374.first[8], _e1374.first[9], _e1374.first[10], _e1374.first[11], _e1374.first[12], _e1374.first[13], _e1374.first[14], _e1374.first[15], _e1374.first[16], _e1374.first[17], _e1374.first[18], _e1374.first[19], _e1374.first[20], _e1374.first[21], _e1374.first[22], _e1374.first[23], _e1374.first[24], _e1374.first[25], _e1374.first[26], _e1374.first[27], _e1374.first[28], _e1374.first[29], _e1374.first[30], _e1374.first[31]), array<u32, 32>(_e1374.mask[0], _e1374.mask[1], _e1374.mask[2], _e1374.mask[3], _e1374.mask[4], _e1374.mask[5], _e1374.mask[6], _e1374.mask[7], _e1374.mask[8], _e1374.mask[9], _e1374.mask[10], _e1374.mask[11], _e1374.mask[12], _e1374.mask[13], _e1374.mask[14], _e1374.mask[15], _e1374.mask[16], _e1374.mask[17], _e1374.mask[18], _e1374.mask[19], _e1374.mask[20], _e1374.mask[21], _e1374.mask[22], _e1374.mask[23], _e1374.mask[24], _e1374.mask[25], _e1374.mask[26], _e1374.mask[27], _e1374.mask[28], _e1374.mask[29], _e1374.mask[30], _e1374.mask[31]), _e1374.len, _e1374.group, _e1374.group_mask);
                                                    let _e1448 = local.group_mask;
                                                    if ((_e1448 & 4278190080u) == 0u) {
                                                        let _e1452 = local.len;
                                                        if (_e1452 == 0u) {
                                                            phi_1697_ = false;
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
                                                            phi_1697_ = true;
                                                        }
                                                        let _e1475 = phi_1697_;
                                                        phi_1698_ = _e1475;
                                                    } else {
                                                        phi_1698_ = true;
                                                    }
                                                    let _e1477 = phi_1698_;
                                                    if _e1477 {
                                                        let _e1479 = local.group_mask;
                                                        let _e1485 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1479)), 32u, (_e1479 == 0u)));
                                                        let _e1489 = local.group_mask;
                                                        let _e1503 = local.group_mask;
                                                        local.group_mask = (_e1503 & ~((1u << bitcast<u32>((_e1485 & 31u)))));
                                                        let _e1506 = local.group;
                                                        phi_1729_ = (_e1506 + countOneBits(((_e1489 & ~((4294967295u << bitcast<u32>((((_e1485 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_1729_ = 4294967295u;
                                                    }
                                                    let _e1509 = phi_1729_;
                                                    phi_1731_ = _e968;
                                                    phi_1734_ = _e1509;
                                                    loop {
                                                        let _e1511 = phi_1731_;
                                                        let _e1513 = phi_1734_;
                                                        local_9 = _e1511;
                                                        let _e1514 = (_e1513 != 4294967295u);
                                                        if _e1514 {
                                                            if (_e1513 < _e69) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1521 = nodes.member[(0u + _e1513)].frame[3u];
                                                            let _e1546 = (bitcast<f32>((((_e1521 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1275);
                                                            let _e1547 = (bitcast<f32>((((_e1521 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1285);
                                                            let _e1548 = (bitcast<f32>((((_e1521 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1295);
                                                            let _e1551 = nodes.member[(0u + _e1513)].frame[0u];
                                                            let _e1555 = nodes.member[(0u + _e1513)].frame[1u];
                                                            let _e1559 = nodes.member[(0u + _e1513)].frame[2u];
                                                            let _e1564 = ((bitcast<f32>(_e1551) - _e1060) * _e1275);
                                                            let _e1565 = ((bitcast<f32>(_e1555) - _e1073) * _e1285);
                                                            let _e1566 = ((bitcast<f32>(_e1559) - _e1086) * _e1295);
                                                            let _e1574 = nodes.member[(0u + _e1513)].x;
                                                            if (_e1275 < 0f) {
                                                                let _e1585 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1574.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1591 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1585.unnamed.word, _e1574.w), _e1585.unnamed_1);
                                                                let _e1597 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1591.unnamed, lt_mask_LightPlace(_e1574.x, _e1591.unnamed_1.shift));
                                                                phi_1815_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1597.unnamed, lt_mask_LightPlace(_e1597.unnamed_1.word, _e1574.y));
                                                            } else {
                                                                let _e1613 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1574.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1619 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1613.unnamed.word, _e1574.y), _e1613.unnamed_1);
                                                                let _e1625 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1619.unnamed, lt_mask_LightPlace(_e1574.z, _e1619.unnamed_1.shift));
                                                                phi_1815_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1625.unnamed, lt_mask_LightPlace(_e1625.unnamed_1.word, _e1574.w));
                                                            }
                                                            let _e1633 = phi_1815_;
                                                            let _e1643 = nodes.member[(0u + _e1513)].y;
                                                            if (_e1285 < 0f) {
                                                                let _e1654 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1643.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1660 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1654.unnamed.word, _e1643.w), _e1654.unnamed_1);
                                                                let _e1666 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1660.unnamed, lt_mask_LightPlace(_e1643.x, _e1660.unnamed_1.shift));
                                                                phi_1842_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1666.unnamed, lt_mask_LightPlace(_e1666.unnamed_1.word, _e1643.y));
                                                            } else {
                                                                let _e1682 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1643.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1688 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1682.unnamed.word, _e1643.y), _e1682.unnamed_1);
                                                                let _e1694 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1688.unnamed, lt_mask_LightPlace(_e1643.z, _e1688.unnamed_1.shift));
                                                                phi_1842_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1694.unnamed, lt_mask_LightPlace(_e1694.unnamed_1.word, _e1643.w));
                                                            }
                                                            let _e1702 = phi_1842_;
                                                            let _e1712 = nodes.member[(0u + _e1513)].z;
                                                            if (_e1295 < 0f) {
                                                                let _e1723 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1712.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1729 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1723.unnamed.word, _e1712.w), _e1723.unnamed_1);
                                                                let _e1735 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1729.unnamed, lt_mask_LightPlace(_e1712.x, _e1729.unnamed_1.shift));
                                                                phi_1869_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1735.unnamed, lt_mask_LightPlace(_e1735.unnamed_1.word, _e1712.y));
                                                            } else {
                                                                let _e1751 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1712.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1757 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1751.unnamed.word, _e1712.y), _e1751.unnamed_1);
                                                                let _e1763 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1757.unnamed, lt_mask_LightPlace(_e1712.z, _e1757.unnamed_1.shift));
                                                                phi_1869_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1763.unnamed, lt_mask_LightPlace(_e1763.unnamed_1.word, _e1712.w));
                                                            }
                                                            let _e1771 = phi_1869_;
                                                            phi_1875_ = 0u;
                                                            phi_1878_ = 0u;
                                                            loop {
                                                                let _e1781 = phi_1875_;
                                                                let _e1783 = phi_1878_;
                                                                local_5 = _e1783;
                                                                local_6 = _e1783;
                                                                local_7 = _e1783;
                                                                let _e1784 = (_e1781 < 8u);
                                                                if _e1784 {
                                                                    let _e1786 = (_e1781 >> bitcast<u32>(2i));
                                                                    let _e1787 = (_e1781 & 3u);
                                                                    if (_e1786 == 0u) {
                                                                        phi_1892_ = _e1633.unnamed.word;
                                                                    } else {
                                                                        phi_1892_ = _e1633.unnamed.shift;
                                                                    }
                                                                    let _e1790 = phi_1892_;
                                                                    if (_e1786 == 0u) {
                                                                        phi_1902_ = _e1702.unnamed.word;
                                                                    } else {
                                                                        phi_1902_ = _e1702.unnamed.shift;
                                                                    }
                                                                    let _e1799 = phi_1902_;
                                                                    if (_e1786 == 0u) {
                                                                        phi_1912_ = _e1771.unnamed.word;
                                                                    } else {
                                                                        phi_1912_ = _e1771.unnamed.shift;
                                                                    }
                                                                    let _e1808 = phi_1912_;
                                                                    let _e1821 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1790 >> bitcast<u32>(((_e1787 * 8u) & 31u))) & 255u)) * _e1546) + (_e1564 - _e1323)), ((f32(((_e1799 >> bitcast<u32>(((_e1787 * 8u) & 31u))) & 255u)) * _e1547) + (_e1565 - _e1324)));
                                                                    let _e1822 = core_intrinsics_maximum_number_nsz_f32_(_e1821, ((f32(((_e1808 >> bitcast<u32>(((_e1787 * 8u) & 31u))) & 255u)) * _e1548) + (_e1566 - _e1325)));
                                                                    if (_e1786 == 0u) {
                                                                        phi_1930_ = _e1633.unnamed_1.word;
                                                                    } else {
                                                                        phi_1930_ = _e1633.unnamed_1.shift;
                                                                    }
                                                                    let _e1825 = phi_1930_;
                                                                    if (_e1786 == 0u) {
                                                                        phi_1940_ = _e1702.unnamed_1.word;
                                                                    } else {
                                                                        phi_1940_ = _e1702.unnamed_1.shift;
                                                                    }
                                                                    let _e1834 = phi_1940_;
                                                                    if (_e1786 == 0u) {
                                                                        phi_1950_ = _e1771.unnamed_1.word;
                                                                    } else {
                                                                        phi_1950_ = _e1771.unnamed_1.shift;
                                                                    }
                                                                    let _e1843 = phi_1950_;
                                                                    let _e1856 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1825 >> bitcast<u32>(((_e1787 * 8u) & 31u))) & 255u)) * _e1546) + (_e1564 + _e1323)), ((f32(((_e1834 >> bitcast<u32>(((_e1787 * 8u) & 31u))) & 255u)) * _e1547) + (_e1565 + _e1324)));
                                                                    let _e1857 = core_intrinsics_minimum_number_nsz_f32_(_e1856, ((f32(((_e1843 >> bitcast<u32>(((_e1787 * 8u) & 31u))) & 255u)) * _e1548) + (_e1566 + _e1325)));
                                                                    if (_e1822 <= _e1857) {
                                                                        if (_e1822 <= _e1511.t) {
                                                                            if (_e1857 >= _e153.tmin) {
                                                                                if (_e1786 == 0u) {
                                                                                    let _e1864 = nodes.member[(0u + _e1513)].links[2u];
                                                                                    phi_1986_ = _e1864;
                                                                                } else {
                                                                                    let _e1867 = nodes.member[(0u + _e1513)].links[3u];
                                                                                    phi_1986_ = _e1867;
                                                                                }
                                                                                let _e1869 = phi_1986_;
                                                                                let _e1874 = ((_e1869 >> bitcast<u32>(((_e1787 * 8u) & 31u))) & 255u);
                                                                                let _e1875 = (_e1874 & 31u);
                                                                                if (_e1875 >= 24u) {
                                                                                    phi_1999_ = (24u + ((_e1875 - 24u) ^ _e1373));
                                                                                } else {
                                                                                    phi_1999_ = _e1875;
                                                                                }
                                                                                let _e1881 = phi_1999_;
                                                                                phi_2004_ = (_e1783 | ((_e1874 >> bitcast<u32>(5i)) << bitcast<u32>((_e1881 & 31u))));
                                                                            } else {
                                                                                phi_2004_ = _e1783;
                                                                            }
                                                                            let _e1889 = phi_2004_;
                                                                            phi_2005_ = _e1889;
                                                                        } else {
                                                                            phi_2005_ = _e1783;
                                                                        }
                                                                        let _e1891 = phi_2005_;
                                                                        phi_2006_ = _e1891;
                                                                    } else {
                                                                        phi_2006_ = _e1783;
                                                                    }
                                                                    let _e1893 = phi_2006_;
                                                                    phi_1876_ = (_e1781 + 1u);
                                                                    phi_1879_ = _e1893;
                                                                } else {
                                                                    phi_1876_ = u32();
                                                                    phi_1879_ = u32();
                                                                }
                                                                let _e1896 = phi_1876_;
                                                                let _e1898 = phi_1879_;
                                                                continue;
                                                                continuing {
                                                                    phi_1875_ = _e1896;
                                                                    phi_1878_ = _e1898;
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
                                                                local.group = (_e1135 + _e1902);
                                                                let _e1942 = local_6;
                                                                local.group_mask = ((_e1942 & 4278190080u) | (_e1906 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1947 = local_7;
                                                            phi_2064_ = _e1511;
                                                            phi_2067_ = (_e1947 & 16777215u);
                                                            loop {
                                                                let _e1950 = phi_2064_;
                                                                let _e1952 = phi_2067_;
                                                                local_8 = _e1950;
                                                                if (_e1952 == 0u) {
                                                                    phi_2065_ = lt_bvh_Hit();
                                                                    phi_2068_ = u32();
                                                                    phi_2709_ = false;
                                                                } else {
                                                                    let _e1956 = nodes.member[(0u + _e1513)].links[1u];
                                                                    let _e1961 = ((_e1137 + _e1956) + select(firstTrailingBit(_e1952), 32u, (_e1952 == 0u)));
                                                                    if (_e1961 < _e72) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1968 = triangles.member[(0u + _e1961)].v0_;
                                                                    let _e1970 = (_e1968.x - _e1060);
                                                                    let _e1972 = (_e1968.y - _e1073);
                                                                    let _e1974 = (_e1968.z - _e1086);
                                                                    if (_e1346 == 0u) {
                                                                        phi_2112_ = vec3<f32>(_e1972, _e1974, _e1970);
                                                                    } else {
                                                                        if (_e1346 == 1u) {
                                                                            phi_2111_ = vec3<f32>(_e1974, _e1970, _e1972);
                                                                        } else {
                                                                            phi_2111_ = (_e1968 - vec3<f32>(_e1060, _e1073, _e1086));
                                                                        }
                                                                        let _e1982 = phi_2111_;
                                                                        phi_2112_ = _e1982;
                                                                    }
                                                                    let _e1984 = phi_2112_;
                                                                    let _e1988 = (_e1984.x - (_e1357 * _e1984.z));
                                                                    let _e1992 = (_e1984.y - (_e1360 * _e1984.z));
                                                                    let _e1994 = triangles.member[(0u + _e1961)].v1_;
                                                                    let _e1996 = (_e1994.x - _e1060);
                                                                    let _e1998 = (_e1994.y - _e1073);
                                                                    let _e2000 = (_e1994.z - _e1086);
                                                                    if (_e1346 == 0u) {
                                                                        phi_2142_ = vec3<f32>(_e1998, _e2000, _e1996);
                                                                    } else {
                                                                        if (_e1346 == 1u) {
                                                                            phi_2141_ = vec3<f32>(_e2000, _e1996, _e1998);
                                                                        } else {
                                                                            phi_2141_ = (_e1994 - vec3<f32>(_e1060, _e1073, _e1086));
                                                                        }
                                                                        let _e2008 = phi_2141_;
                                                                        phi_2142_ = _e2008;
                                                                    }
                                                                    let _e2010 = phi_2142_;
                                                                    let _e2014 = (_e2010.x - (_e1357 * _e2010.z));
                                                                    let _e2018 = (_e2010.y - (_e1360 * _e2010.z));
                                                                    let _e2020 = triangles.member[(0u + _e1961)].v2_;
                                                                    let _e2022 = (_e2020.x - _e1060);
                                                                    let _e2024 = (_e2020.y - _e1073);
                                                                    let _e2026 = (_e2020.z - _e1086);
                                                                    if (_e1346 == 0u) {
                                                                        phi_2172_ = vec3<f32>(_e2024, _e2026, _e2022);
                                                                    } else {
                                                                        if (_e1346 == 1u) {
                                                                            phi_2171_ = vec3<f32>(_e2026, _e2022, _e2024);
                                                                        } else {
                                                                            phi_2171_ = (_e2020 - vec3<f32>(_e1060, _e1073, _e1086));
                                                                        }
                                                                        let _e2034 = phi_2171_;
                                                                        phi_2172_ = _e2034;
                                                                    }
                                                                    let _e2036 = phi_2172_;
                                                                    let _e2040 = (_e2036.x - (_e1357 * _e2036.z));
                                                                    let _e2044 = (_e2036.y - (_e1360 * _e2036.z));
                                                                    if (_e2014 < _e2040) {
                                                                        phi_2191_ = true;
                                                                    } else {
                                                                        if (_e2014 == _e2040) {
                                                                            phi_2190_ = (_e2018 < _e2044);
                                                                        } else {
                                                                            phi_2190_ = false;
                                                                        }
                                                                        let _e2049 = phi_2190_;
                                                                        phi_2191_ = _e2049;
                                                                    }
                                                                    let _e2051 = phi_2191_;
                                                                    if _e2051 {
                                                                        phi_2195_ = _e2044;
                                                                        phi_2196_ = _e2040;
                                                                        phi_2197_ = _e2018;
                                                                        phi_2198_ = _e2014;
                                                                    } else {
                                                                        phi_2195_ = _e2018;
                                                                        phi_2196_ = _e2014;
                                                                        phi_2197_ = _e2044;
                                                                        phi_2198_ = _e2040;
                                                                    }
                                                                    let _e2053 = phi_2195_;
                                                                    let _e2055 = phi_2196_;
                                                                    let _e2057 = phi_2197_;
                                                                    let _e2059 = phi_2198_;
                                                                    let _e2062 = ((_e2059 * _e2053) - (_e2057 * _e2055));
                                                                    if _e2051 {
                                                                        phi_2206_ = -(_e2062);
                                                                    } else {
                                                                        phi_2206_ = _e2062;
                                                                    }
                                                                    let _e2065 = phi_2206_;
                                                                    if (_e2040 < _e1988) {
                                                                        phi_2217_ = true;
                                                                    } else {
                                                                        if (_e2040 == _e1988) {
                                                                            phi_2216_ = (_e2044 < _e1992);
                                                                        } else {
                                                                            phi_2216_ = false;
                                                                        }
                                                                        let _e2070 = phi_2216_;
                                                                        phi_2217_ = _e2070;
                                                                    }
                                                                    let _e2072 = phi_2217_;
                                                                    if _e2072 {
                                                                        phi_2221_ = _e1992;
                                                                        phi_2222_ = _e1988;
                                                                        phi_2223_ = _e2044;
                                                                        phi_2224_ = _e2040;
                                                                    } else {
                                                                        phi_2221_ = _e2044;
                                                                        phi_2222_ = _e2040;
                                                                        phi_2223_ = _e1992;
                                                                        phi_2224_ = _e1988;
                                                                    }
                                                                    let _e2074 = phi_2221_;
                                                                    let _e2076 = phi_2222_;
                                                                    let _e2078 = phi_2223_;
                                                                    let _e2080 = phi_2224_;
                                                                    let _e2083 = ((_e2080 * _e2074) - (_e2078 * _e2076));
                                                                    if _e2072 {
                                                                        phi_2232_ = -(_e2083);
                                                                    } else {
                                                                        phi_2232_ = _e2083;
                                                                    }
                                                                    let _e2086 = phi_2232_;
                                                                    if (_e1988 < _e2014) {
                                                                        phi_2243_ = true;
                                                                    } else {
                                                                        if (_e1988 == _e2014) {
                                                                            phi_2242_ = (_e1992 < _e2018);
                                                                        } else {
                                                                            phi_2242_ = false;
                                                                        }
                                                                        let _e2091 = phi_2242_;
                                                                        phi_2243_ = _e2091;
                                                                    }
                                                                    let _e2093 = phi_2243_;
                                                                    if _e2093 {
                                                                        phi_2247_ = _e2018;
                                                                        phi_2248_ = _e2014;
                                                                        phi_2249_ = _e1992;
                                                                        phi_2250_ = _e1988;
                                                                    } else {
                                                                        phi_2247_ = _e1992;
                                                                        phi_2248_ = _e1988;
                                                                        phi_2249_ = _e2018;
                                                                        phi_2250_ = _e2014;
                                                                    }
                                                                    let _e2095 = phi_2247_;
                                                                    let _e2097 = phi_2248_;
                                                                    let _e2099 = phi_2249_;
                                                                    let _e2101 = phi_2250_;
                                                                    let _e2104 = ((_e2101 * _e2095) - (_e2099 * _e2097));
                                                                    if _e2093 {
                                                                        phi_2258_ = -(_e2104);
                                                                    } else {
                                                                        phi_2258_ = _e2104;
                                                                    }
                                                                    let _e2107 = phi_2258_;
                                                                    if (_e2065 >= 0f) {
                                                                        if (_e2086 >= 0f) {
                                                                            if (_e2107 >= 0f) {
                                                                                phi_2273_ = ((_e2065 + _e2086) + _e2107);
                                                                                phi_2274_ = false;
                                                                            } else {
                                                                                phi_2273_ = f32();
                                                                                phi_2274_ = true;
                                                                            }
                                                                            let _e2114 = phi_2273_;
                                                                            let _e2116 = phi_2274_;
                                                                            phi_2275_ = _e2114;
                                                                            phi_2276_ = _e2116;
                                                                        } else {
                                                                            phi_2275_ = f32();
                                                                            phi_2276_ = true;
                                                                        }
                                                                        let _e2118 = phi_2275_;
                                                                        let _e2120 = phi_2276_;
                                                                        phi_2277_ = _e2118;
                                                                        phi_2278_ = _e2120;
                                                                    } else {
                                                                        phi_2277_ = f32();
                                                                        phi_2278_ = true;
                                                                    }
                                                                    let _e2122 = phi_2277_;
                                                                    let _e2124 = phi_2278_;
                                                                    if _e2124 {
                                                                        if (_e2065 <= 0f) {
                                                                            if (_e2086 <= 0f) {
                                                                                let _e2127 = (_e2107 <= 0f);
                                                                                if _e2127 {
                                                                                }
                                                                                phi_2296_ = ((_e2065 + _e2086) + _e2107);
                                                                                phi_2297_ = false;
                                                                                phi_2298_ = _e2127;
                                                                            } else {
                                                                                phi_2296_ = f32();
                                                                                phi_2297_ = true;
                                                                                phi_2298_ = false;
                                                                            }
                                                                            let _e2131 = phi_2296_;
                                                                            let _e2133 = phi_2297_;
                                                                            let _e2135 = phi_2298_;
                                                                            phi_2299_ = _e2131;
                                                                            phi_2300_ = _e2133;
                                                                            phi_2301_ = _e2135;
                                                                        } else {
                                                                            phi_2299_ = f32();
                                                                            phi_2300_ = true;
                                                                            phi_2301_ = false;
                                                                        }
                                                                        let _e2137 = phi_2299_;
                                                                        let _e2139 = phi_2300_;
                                                                        let _e2141 = phi_2301_;
                                                                        if _e2139 {
                                                                            phi_2305_ = false;
                                                                        } else {
                                                                            phi_2305_ = _e2141;
                                                                        }
                                                                        let _e2143 = phi_2305_;
                                                                        phi_2306_ = _e2137;
                                                                        phi_2307_ = _e2143;
                                                                    } else {
                                                                        phi_2306_ = _e2122;
                                                                        phi_2307_ = true;
                                                                    }
                                                                    let _e2145 = phi_2306_;
                                                                    let _e2147 = phi_2307_;
                                                                    if _e2147 {
                                                                        let _e2148 = (_e2145 == 0f);
                                                                        if _e2148 {
                                                                            phi_2623_ = lt_bvh_triangle_Intersection();
                                                                            phi_2624_ = false;
                                                                        } else {
                                                                            let _e2150 = triangles.member[(0u + _e1961)].v0_;
                                                                            let _e2152 = (_e2150.x - _e1060);
                                                                            let _e2154 = (_e2150.y - _e1073);
                                                                            let _e2156 = (_e2150.z - _e1086);
                                                                            if (_e1346 == 0u) {
                                                                                phi_2336_ = vec3<f32>(_e2154, _e2156, _e2152);
                                                                            } else {
                                                                                if (_e1346 == 1u) {
                                                                                    phi_2335_ = vec3<f32>(_e2156, _e2152, _e2154);
                                                                                } else {
                                                                                    phi_2335_ = (_e2150 - vec3<f32>(_e1060, _e1073, _e1086));
                                                                                }
                                                                                let _e2164 = phi_2335_;
                                                                                phi_2336_ = _e2164;
                                                                            }
                                                                            let _e2166 = phi_2336_;
                                                                            let _e2168 = triangles.member[(0u + _e1961)].v1_;
                                                                            let _e2170 = triangles.member[(0u + _e1961)].v0_;
                                                                            let _e2173 = (_e2168.x - _e2170.x);
                                                                            let _e2176 = (_e2168.y - _e2170.y);
                                                                            let _e2179 = (_e2168.z - _e2170.z);
                                                                            if (_e1346 == 0u) {
                                                                                phi_2362_ = vec3<f32>(_e2176, _e2179, _e2173);
                                                                            } else {
                                                                                if (_e1346 == 1u) {
                                                                                    phi_2361_ = vec3<f32>(_e2179, _e2173, _e2176);
                                                                                } else {
                                                                                    phi_2361_ = (_e2168 - _e2170);
                                                                                }
                                                                                let _e2186 = phi_2361_;
                                                                                phi_2362_ = _e2186;
                                                                            }
                                                                            let _e2188 = phi_2362_;
                                                                            let _e2190 = triangles.member[(0u + _e1961)].v2_;
                                                                            let _e2192 = triangles.member[(0u + _e1961)].v0_;
                                                                            let _e2195 = (_e2190.x - _e2192.x);
                                                                            let _e2198 = (_e2190.y - _e2192.y);
                                                                            let _e2201 = (_e2190.z - _e2192.z);
                                                                            if (_e1346 == 0u) {
                                                                                phi_2388_ = vec3<f32>(_e2198, _e2201, _e2195);
                                                                            } else {
                                                                                if (_e1346 == 1u) {
                                                                                    phi_2387_ = vec3<f32>(_e2201, _e2195, _e2198);
                                                                                } else {
                                                                                    phi_2387_ = (_e2190 - _e2192);
                                                                                }
                                                                                let _e2208 = phi_2387_;
                                                                                phi_2388_ = _e2208;
                                                                            }
                                                                            let _e2210 = phi_2388_;
                                                                            let _e2217 = ((_e2188.y * _e2210.z) - (_e2188.z * _e2210.y));
                                                                            let _e2224 = ((_e2188.z * _e2210.x) - (_e2188.x * _e2210.z));
                                                                            let _e2231 = ((_e2188.x * _e2210.y) - (_e2188.y * _e2210.x));
                                                                            let _e2245 = (((1f / _e1354.z) * (((_e2217 * _e2166.x) + (_e2224 * _e2166.y)) + (_e2231 * _e2166.z))) / (((_e2217 * _e1357) + (_e2224 * _e1360)) + _e2231));
                                                                            if (_e2245 > _e153.tmin) {
                                                                                if (_e2245 < _e153.tmax) {
                                                                                    let _e2249 = triangles.member[(0u + _e1961)].v0_;
                                                                                    let _e2251 = triangles.member[(0u + _e1961)].v1_;
                                                                                    if (_e2249.x < _e2251.x) {
                                                                                        phi_2444_ = _e2249.x;
                                                                                    } else {
                                                                                        phi_2444_ = _e2251.x;
                                                                                    }
                                                                                    let _e2258 = phi_2444_;
                                                                                    if (_e2249.y < _e2251.y) {
                                                                                        phi_2453_ = _e2249.y;
                                                                                    } else {
                                                                                        phi_2453_ = _e2251.y;
                                                                                    }
                                                                                    let _e2265 = phi_2453_;
                                                                                    if (_e2249.z < _e2251.z) {
                                                                                        phi_2462_ = _e2249.z;
                                                                                    } else {
                                                                                        phi_2462_ = _e2251.z;
                                                                                    }
                                                                                    let _e2272 = phi_2462_;
                                                                                    let _e2274 = triangles.member[(0u + _e1961)].v2_;
                                                                                    if (_e2258 < _e2274.x) {
                                                                                        phi_2471_ = _e2258;
                                                                                    } else {
                                                                                        phi_2471_ = _e2274.x;
                                                                                    }
                                                                                    let _e2279 = phi_2471_;
                                                                                    if (_e2265 < _e2274.y) {
                                                                                        phi_2478_ = _e2265;
                                                                                    } else {
                                                                                        phi_2478_ = _e2274.y;
                                                                                    }
                                                                                    let _e2284 = phi_2478_;
                                                                                    if (_e2272 < _e2274.z) {
                                                                                        phi_2485_ = _e2272;
                                                                                    } else {
                                                                                        phi_2485_ = _e2274.z;
                                                                                    }
                                                                                    let _e2289 = phi_2485_;
                                                                                    let _e2291 = triangles.member[(0u + _e1961)].v0_;
                                                                                    let _e2293 = triangles.member[(0u + _e1961)].v1_;
                                                                                    if (_e2291.x > _e2293.x) {
                                                                                        phi_2498_ = _e2291.x;
                                                                                    } else {
                                                                                        phi_2498_ = _e2293.x;
                                                                                    }
                                                                                    let _e2300 = phi_2498_;
                                                                                    if (_e2291.y > _e2293.y) {
                                                                                        phi_2507_ = _e2291.y;
                                                                                    } else {
                                                                                        phi_2507_ = _e2293.y;
                                                                                    }
                                                                                    let _e2307 = phi_2507_;
                                                                                    if (_e2291.z > _e2293.z) {
                                                                                        phi_2516_ = _e2291.z;
                                                                                    } else {
                                                                                        phi_2516_ = _e2293.z;
                                                                                    }
                                                                                    let _e2314 = phi_2516_;
                                                                                    let _e2316 = triangles.member[(0u + _e1961)].v2_;
                                                                                    if (_e2300 > _e2316.x) {
                                                                                        phi_2525_ = _e2300;
                                                                                    } else {
                                                                                        phi_2525_ = _e2316.x;
                                                                                    }
                                                                                    let _e2321 = phi_2525_;
                                                                                    if (_e2307 > _e2316.y) {
                                                                                        phi_2532_ = _e2307;
                                                                                    } else {
                                                                                        phi_2532_ = _e2316.y;
                                                                                    }
                                                                                    let _e2326 = phi_2532_;
                                                                                    if (_e2314 > _e2316.z) {
                                                                                        phi_2539_ = _e2314;
                                                                                    } else {
                                                                                        phi_2539_ = _e2316.z;
                                                                                    }
                                                                                    let _e2331 = phi_2539_;
                                                                                    let _e2335 = ((_e2279 - _e1060) * _e1275);
                                                                                    let _e2336 = ((_e2284 - _e1073) * _e1285);
                                                                                    let _e2337 = ((_e2289 - _e1086) * _e1295);
                                                                                    let _e2341 = ((_e2321 - _e1060) * _e1275);
                                                                                    let _e2342 = ((_e2326 - _e1073) * _e1285);
                                                                                    let _e2343 = ((_e2331 - _e1086) * _e1295);
                                                                                    if (_e2335 < _e2341) {
                                                                                        phi_2556_ = _e2335;
                                                                                    } else {
                                                                                        phi_2556_ = _e2341;
                                                                                    }
                                                                                    let _e2346 = phi_2556_;
                                                                                    if (_e2336 < _e2342) {
                                                                                        phi_2561_ = _e2336;
                                                                                    } else {
                                                                                        phi_2561_ = _e2342;
                                                                                    }
                                                                                    let _e2349 = phi_2561_;
                                                                                    if (_e2337 < _e2343) {
                                                                                        phi_2566_ = _e2337;
                                                                                    } else {
                                                                                        phi_2566_ = _e2343;
                                                                                    }
                                                                                    let _e2352 = phi_2566_;
                                                                                    if (_e2335 > _e2341) {
                                                                                        phi_2574_ = _e2335;
                                                                                    } else {
                                                                                        phi_2574_ = _e2341;
                                                                                    }
                                                                                    let _e2358 = phi_2574_;
                                                                                    if (_e2336 > _e2342) {
                                                                                        phi_2579_ = _e2336;
                                                                                    } else {
                                                                                        phi_2579_ = _e2342;
                                                                                    }
                                                                                    let _e2361 = phi_2579_;
                                                                                    if (_e2337 > _e2343) {
                                                                                        phi_2584_ = _e2337;
                                                                                    } else {
                                                                                        phi_2584_ = _e2343;
                                                                                    }
                                                                                    let _e2364 = phi_2584_;
                                                                                    let _e2368 = core_intrinsics_maximum_number_nsz_f32_((_e2346 - _e1330), (_e2349 - _e1331));
                                                                                    let _e2369 = core_intrinsics_maximum_number_nsz_f32_(_e2368, (_e2352 - _e1332));
                                                                                    let _e2370 = core_intrinsics_minimum_number_nsz_f32_((_e2358 + _e1330), (_e2361 + _e1331));
                                                                                    let _e2371 = core_intrinsics_minimum_number_nsz_f32_(_e2370, (_e2364 + _e1332));
                                                                                    if (_e2369 > _e1035) {
                                                                                        phi_2596_ = _e2369;
                                                                                    } else {
                                                                                        phi_2596_ = _e1035;
                                                                                    }
                                                                                    let _e2374 = phi_2596_;
                                                                                    if (_e2371 < _e1037) {
                                                                                        phi_2601_ = _e2371;
                                                                                    } else {
                                                                                        phi_2601_ = _e1037;
                                                                                    }
                                                                                    let _e2377 = phi_2601_;
                                                                                    if (_e2245 < _e2374) {
                                                                                        phi_2606_ = _e2374;
                                                                                    } else {
                                                                                        phi_2606_ = _e2245;
                                                                                    }
                                                                                    let _e2380 = phi_2606_;
                                                                                    if (_e2380 > _e2377) {
                                                                                        phi_2611_ = _e2377;
                                                                                    } else {
                                                                                        phi_2611_ = _e2380;
                                                                                    }
                                                                                    let _e2383 = phi_2611_;
                                                                                    phi_2616_ = lt_bvh_triangle_Intersection(_e2383, (_e2086 / _e2145), (_e2107 / _e2145), (_e2374 <= _e2377));
                                                                                    phi_2617_ = false;
                                                                                } else {
                                                                                    phi_2616_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2617_ = true;
                                                                                }
                                                                                let _e2389 = phi_2616_;
                                                                                let _e2391 = phi_2617_;
                                                                                phi_2618_ = _e2389;
                                                                                phi_2619_ = _e2391;
                                                                            } else {
                                                                                phi_2618_ = lt_bvh_triangle_Intersection();
                                                                                phi_2619_ = true;
                                                                            }
                                                                            let _e2393 = phi_2618_;
                                                                            let _e2395 = phi_2619_;
                                                                            if _e2395 {
                                                                            }
                                                                            phi_2623_ = _e2393;
                                                                            phi_2624_ = _e2395;
                                                                        }
                                                                        let _e2397 = phi_2623_;
                                                                        let _e2399 = phi_2624_;
                                                                        phi_2625_ = _e2397;
                                                                        phi_2626_ = _e2148;
                                                                        phi_2627_ = _e2399;
                                                                    } else {
                                                                        phi_2625_ = lt_bvh_triangle_Intersection();
                                                                        phi_2626_ = true;
                                                                        phi_2627_ = false;
                                                                    }
                                                                    let _e2401 = phi_2625_;
                                                                    let _e2403 = phi_2626_;
                                                                    let _e2405 = phi_2627_;
                                                                    if _e2403 {
                                                                        phi_2631_ = true;
                                                                    } else {
                                                                        phi_2631_ = _e2405;
                                                                    }
                                                                    let _e2407 = phi_2631_;
                                                                    if _e2407 {
                                                                        phi_2635_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2635_ = _e2401;
                                                                    }
                                                                    let _e2409 = phi_2635_;
                                                                    if _e2409.is_hit {
                                                                        if (_e2409.t > _e153.tmin) {
                                                                            if (_e2409.t < _e1950.t) {
                                                                                phi_2683_ = true;
                                                                            } else {
                                                                                if (_e2409.t == _e1950.t) {
                                                                                    if (_e1950.triangle != 4294967295u) {
                                                                                        if (_e1961 < _e1950.triangle) {
                                                                                            phi_2674_ = true;
                                                                                        } else {
                                                                                            if (_e1961 == _e1950.triangle) {
                                                                                                phi_2673_ = (_e976 < _e1950.instance);
                                                                                            } else {
                                                                                                phi_2673_ = false;
                                                                                            }
                                                                                            let _e2427 = phi_2673_;
                                                                                            phi_2674_ = _e2427;
                                                                                        }
                                                                                        let _e2429 = phi_2674_;
                                                                                        phi_2675_ = _e2429;
                                                                                        phi_2676_ = false;
                                                                                    } else {
                                                                                        phi_2675_ = bool();
                                                                                        phi_2676_ = true;
                                                                                    }
                                                                                    let _e2431 = phi_2675_;
                                                                                    let _e2433 = phi_2676_;
                                                                                    phi_2677_ = _e2431;
                                                                                    phi_2678_ = _e2433;
                                                                                } else {
                                                                                    phi_2677_ = bool();
                                                                                    phi_2678_ = true;
                                                                                }
                                                                                let _e2435 = phi_2677_;
                                                                                let _e2437 = phi_2678_;
                                                                                if _e2437 {
                                                                                    phi_2682_ = false;
                                                                                } else {
                                                                                    phi_2682_ = _e2435;
                                                                                }
                                                                                let _e2439 = phi_2682_;
                                                                                phi_2683_ = _e2439;
                                                                            }
                                                                            let _e2441 = phi_2683_;
                                                                            if _e2441 {
                                                                                let _e2443 = triangles.member[(0u + _e1961)].i0_;
                                                                                if ((_e2443 & 2147483648u) == 0u) {
                                                                                    phi_2697_ = true;
                                                                                } else {
                                                                                    if true {
                                                                                    }
                                                                                    phi_2697_ = true;
                                                                                }
                                                                                let _e2447 = phi_2697_;
                                                                                if _e2447 {
                                                                                    phi_2705_ = lt_bvh_Hit(_e2409.t, _e2409.u, _e2409.v, _e1961, _e976);
                                                                                } else {
                                                                                    phi_2705_ = _e1950;
                                                                                }
                                                                                let _e2453 = phi_2705_;
                                                                                phi_2706_ = _e2453;
                                                                            } else {
                                                                                phi_2706_ = _e1950;
                                                                            }
                                                                            let _e2455 = phi_2706_;
                                                                            phi_2707_ = _e2455;
                                                                        } else {
                                                                            phi_2707_ = _e1950;
                                                                        }
                                                                        let _e2457 = phi_2707_;
                                                                        phi_2708_ = _e2457;
                                                                    } else {
                                                                        phi_2708_ = _e1950;
                                                                    }
                                                                    let _e2459 = phi_2708_;
                                                                    phi_2065_ = _e2459;
                                                                    phi_2068_ = (_e1952 & (_e1952 - 1u));
                                                                    phi_2709_ = true;
                                                                }
                                                                let _e2461 = phi_2065_;
                                                                let _e2463 = phi_2068_;
                                                                let _e2465 = phi_2709_;
                                                                continue;
                                                                continuing {
                                                                    phi_2064_ = _e2461;
                                                                    phi_2067_ = _e2463;
                                                                    break if !(_e2465);
                                                                }
                                                            }
                                                            let _e2468 = local.group_mask;
                                                            if ((_e2468 & 4278190080u) == 0u) {
                                                                let _e2472 = local.len;
                                                                if (_e2472 == 0u) {
                                                                    phi_2748_ = false;
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
                                                                    phi_2748_ = true;
                                                                }
                                                                let _e2495 = phi_2748_;
                                                                phi_2749_ = _e2495;
                                                            } else {
                                                                phi_2749_ = true;
                                                            }
                                                            let _e2497 = phi_2749_;
                                                            if _e2497 {
                                                                let _e2499 = local.group_mask;
                                                                let _e2505 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2499)), 32u, (_e2499 == 0u)));
                                                                let _e2509 = local.group_mask;
                                                                let _e2523 = local.group_mask;
                                                                local.group_mask = (_e2523 & ~((1u << bitcast<u32>((_e2505 & 31u)))));
                                                                let _e2526 = local.group;
                                                                phi_2780_ = (_e2526 + countOneBits(((_e2509 & ~((4294967295u << bitcast<u32>((((_e2505 - 24u) ^ _e1373) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_2780_ = 4294967295u;
                                                            }
                                                            let _e2529 = phi_2780_;
                                                            let _e3708 = local_8;
                                                            phi_1732_ = _e3708;
                                                            phi_1735_ = _e2529;
                                                        } else {
                                                            phi_1732_ = lt_bvh_Hit();
                                                            phi_1735_ = u32();
                                                        }
                                                        let _e2531 = phi_1732_;
                                                        let _e2533 = phi_1735_;
                                                        continue;
                                                        continuing {
                                                            phi_1731_ = _e2531;
                                                            phi_1734_ = _e2533;
                                                            break if !(_e1514);
                                                        }
                                                    }
                                                    let _e3712 = local_9;
                                                    phi_2781_ = _e3712;
                                                }
                                                let _e2536 = phi_2781_;
                                                phi_2782_ = _e2536;
                                                phi_2783_ = _e1199;
                                            } else {
                                                phi_2782_ = lt_bvh_Hit();
                                                phi_2783_ = true;
                                            }
                                            let _e2538 = phi_2782_;
                                            let _e2540 = phi_2783_;
                                            if _e2540 {
                                                phi_2787_ = _e968;
                                            } else {
                                                phi_2787_ = _e2538;
                                            }
                                            let _e2542 = phi_2787_;
                                            phi_2788_ = _e2542;
                                        } else {
                                            phi_2788_ = _e968;
                                        }
                                        let _e2544 = phi_2788_;
                                        phi_2789_ = _e2544;
                                    } else {
                                        phi_2789_ = _e968;
                                    }
                                    let _e2546 = phi_2789_;
                                    phi_2790_ = _e2546;
                                } else {
                                    phi_2790_ = _e968;
                                }
                                let _e2548 = phi_2790_;
                                phi_1106_ = (_e966 & (_e966 - 1u));
                                phi_1109_ = _e2548;
                                phi_2791_ = true;
                            }
                            let _e2550 = phi_1106_;
                            let _e2552 = phi_1109_;
                            let _e2554 = phi_2791_;
                            continue;
                            continuing {
                                phi_1105_ = _e2550;
                                phi_1108_ = _e2552;
                                break if !(_e2554);
                            }
                        }
                        let _e2557 = local_1.group_mask;
                        if ((_e2557 & 4278190080u) == 0u) {
                            let _e2561 = local_1.len;
                            if (_e2561 == 0u) {
                                phi_2830_ = false;
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
                                phi_2830_ = true;
                            }
                            let _e2584 = phi_2830_;
                            phi_2831_ = _e2584;
                        } else {
                            phi_2831_ = true;
                        }
                        let _e2586 = phi_2831_;
                        if _e2586 {
                            let _e2588 = local_1.group_mask;
                            let _e2594 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2588)), 32u, (_e2588 == 0u)));
                            let _e2598 = local_1.group_mask;
                            let _e2612 = local_1.group_mask;
                            local_1.group_mask = (_e2612 & ~((1u << bitcast<u32>((_e2594 & 31u)))));
                            let _e2615 = local_1.group;
                            phi_2862_ = (_e2615 + countOneBits(((_e2598 & ~((4294967295u << bitcast<u32>((((_e2594 - 24u) ^ _e385) & 31u))))) & 255u)));
                        } else {
                            phi_2862_ = 4294967295u;
                        }
                        let _e2618 = phi_2862_;
                        phi_769_ = _e2618;
                        let _e3728 = local_10;
                        phi_772_ = _e3728;
                    } else {
                        phi_769_ = u32();
                        phi_772_ = lt_bvh_Hit();
                    }
                    let _e2620 = phi_769_;
                    let _e2622 = phi_772_;
                    continue;
                    continuing {
                        phi_768_ = _e2620;
                        phi_771_ = _e2622;
                        break if !(_e526);
                    }
                }
                let _e3731 = local_11;
                phi_2863_ = _e3731;
            }
            let _e2625 = phi_2863_;
            phi_2864_ = _e2625;
            phi_2865_ = _e225;
        } else {
            phi_2864_ = lt_bvh_Hit();
            phi_2865_ = true;
        }
        let _e2627 = phi_2864_;
        let _e2629 = phi_2865_;
        if _e2629 {
            phi_2869_ = _e155;
        } else {
            phi_2869_ = _e2627;
        }
        let _e2631 = phi_2869_;
        if (_e2631.triangle != 4294967295u) {
            let _e2637 = ((1f - _e2631.u) - _e2631.v);
            if (_e2631.triangle < _e72) {
            } else {
                return;
            }
            let _e2643 = triangles.member[(0u + _e2631.triangle)];
            if (_e2631.instance < _e84) {
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
                phi_3057_ = _e2796;
            } else {
                phi_3057_ = _e2799;
            }
            let _e2804 = phi_3057_;
            if (_e2797 > _e2800) {
                phi_3062_ = _e2797;
            } else {
                phi_3062_ = _e2800;
            }
            let _e2807 = phi_3062_;
            if (_e2798 > _e2801) {
                phi_3067_ = _e2798;
            } else {
                phi_3067_ = _e2801;
            }
            let _e2810 = phi_3067_;
            let _e2811 = abs(_e2753);
            let _e2812 = abs(_e2766);
            let _e2813 = abs(_e2779);
            if (_e2804 > _e2811) {
                phi_3075_ = _e2804;
            } else {
                phi_3075_ = _e2811;
            }
            let _e2816 = phi_3075_;
            if (_e2807 > _e2812) {
                phi_3080_ = _e2807;
            } else {
                phi_3080_ = _e2812;
            }
            let _e2819 = phi_3080_;
            if (_e2810 > _e2813) {
                phi_3085_ = _e2810;
            } else {
                phi_3085_ = _e2813;
            }
            let _e2822 = phi_3085_;
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
                phi_3149_ = vec3<f32>(-(_e2869), -(_e2870), -(_e2871));
            } else {
                phi_3149_ = vec3<f32>(_e2869, _e2870, _e2871);
            }
            let _e2884 = phi_3149_;
            if (_e2631.triangle < _e72) {
            } else {
                return;
            }
            let _e2889 = triangles.member[(0u + _e2631.triangle)];
            let _e2891 = (_e2889.i0_ & 2147483647u);
            if (_e2891 < _e75) {
            } else {
                return;
            }
            let _e2897 = vertices.member[(0u + _e2891)];
            if (_e2889.i1_ < _e75) {
            } else {
                return;
            }
            let _e2901 = vertices.member[(0u + _e2889.i1_)];
            if (_e2889.i2_ < _e75) {
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
                phi_3270_ = 0u;
            } else {
                phi_3270_ = 1u;
            }
            let _e2996 = phi_3270_;
            if (_e2906[0].normal == 2147516416u) {
                phi_3500_ = _e2884;
            } else {
                let _e3009 = (f32((bitcast<i32>((_e2906[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3015 = (f32((bitcast<i32>(_e2906[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3019 = ((1f - abs(_e3009)) - abs(_e3015));
                if (_e3019 < 0f) {
                    phi_3297_ = -(_e3019);
                } else {
                    phi_3297_ = 0f;
                }
                let _e3023 = phi_3297_;
                if (_e3009 < 0f) {
                    phi_3304_ = (_e3009 + _e3023);
                } else {
                    phi_3304_ = (_e3009 - _e3023);
                }
                let _e3028 = phi_3304_;
                if (_e3015 < 0f) {
                    phi_3311_ = (_e3015 + _e3023);
                } else {
                    phi_3311_ = (_e3015 - _e3023);
                }
                let _e3033 = phi_3311_;
                let _e3040 = (1f / sqrt((((_e3028 * _e3028) + (_e3033 * _e3033)) + (_e3019 * _e3019))));
                let _e3056 = (f32((bitcast<i32>((_e2906[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3062 = (f32((bitcast<i32>(_e2906[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3066 = ((1f - abs(_e3056)) - abs(_e3062));
                if (_e3066 < 0f) {
                    phi_3346_ = -(_e3066);
                } else {
                    phi_3346_ = 0f;
                }
                let _e3070 = phi_3346_;
                if (_e3056 < 0f) {
                    phi_3353_ = (_e3056 + _e3070);
                } else {
                    phi_3353_ = (_e3056 - _e3070);
                }
                let _e3075 = phi_3353_;
                if (_e3062 < 0f) {
                    phi_3360_ = (_e3062 + _e3070);
                } else {
                    phi_3360_ = (_e3062 - _e3070);
                }
                let _e3080 = phi_3360_;
                let _e3087 = (1f / sqrt((((_e3075 * _e3075) + (_e3080 * _e3080)) + (_e3066 * _e3066))));
                let _e3106 = (f32((bitcast<i32>((_e2906[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3112 = (f32((bitcast<i32>(_e2906[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3116 = ((1f - abs(_e3106)) - abs(_e3112));
                if (_e3116 < 0f) {
                    phi_3398_ = -(_e3116);
                } else {
                    phi_3398_ = 0f;
                }
                let _e3120 = phi_3398_;
                if (_e3106 < 0f) {
                    phi_3405_ = (_e3106 + _e3120);
                } else {
                    phi_3405_ = (_e3106 - _e3120);
                }
                let _e3125 = phi_3405_;
                if (_e3112 < 0f) {
                    phi_3412_ = (_e3112 + _e3120);
                } else {
                    phi_3412_ = (_e3112 - _e3120);
                }
                let _e3130 = phi_3412_;
                let _e3137 = (1f / sqrt((((_e3125 * _e3125) + (_e3130 * _e3130)) + (_e3116 * _e3116))));
                let _e3144 = ((((_e3028 * _e3040) * _e2637) + ((_e3075 * _e3087) * _e2631.u)) + ((_e3125 * _e3137) * _e2631.v));
                let _e3145 = ((((_e3033 * _e3040) * _e2637) + ((_e3080 * _e3087) * _e2631.u)) + ((_e3130 * _e3137) * _e2631.v));
                let _e3146 = ((((_e3019 * _e3040) * _e2637) + ((_e3066 * _e3087) * _e2631.u)) + ((_e3116 * _e3137) * _e2631.v));
                if (_e2631.instance < _e84) {
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
                        phi_3498_ = vec3<f32>(-(_e3191), -(_e3192), -(_e3193));
                    } else {
                        phi_3498_ = vec3<f32>(_e3191, _e3192, _e3193);
                    }
                    let _e3209 = phi_3498_;
                    phi_3499_ = _e3209;
                } else {
                    phi_3499_ = _e2884;
                }
                let _e3211 = phi_3499_;
                phi_3500_ = _e3211;
            }
            let _e3213 = phi_3500_;
            if (_e2985 > 0f) {
                if (_e2985 < 1f) {
                    phi_3509_ = _e2985;
                } else {
                    phi_3509_ = 1f;
                }
                let _e3217 = phi_3509_;
                phi_3510_ = _e3217;
            } else {
                phi_3510_ = 0f;
            }
            let _e3219 = phi_3510_;
            if (_e2987 > 0f) {
                if (_e2987 < 1f) {
                    phi_3520_ = _e2987;
                } else {
                    phi_3520_ = 1f;
                }
                let _e3224 = phi_3520_;
                phi_3521_ = _e3224;
            } else {
                phi_3521_ = 0f;
            }
            let _e3226 = phi_3521_;
            if (_e2989 > 0f) {
                if (_e2989 < 1f) {
                    phi_3531_ = _e2989;
                } else {
                    phi_3531_ = 1f;
                }
                let _e3231 = phi_3531_;
                phi_3532_ = _e3231;
            } else {
                phi_3532_ = 0f;
            }
            let _e3233 = phi_3532_;
            let _e3236 = ((sqrt(_e3219) * 255f) + 0.5f);
            let _e3245 = ((sqrt(_e3226) * 255f) + 0.5f);
            let _e3257 = ((sqrt(_e3233) * 255f) + 0.5f);
            phi_3567_ = abi_Sample(vec3<f32>(_e2792, _e2793, _e2794), _e2991, _e2884, _e2996, _e3213, ((select(select(u32(_e3236), 0u, (_e3236 < bitcast<f32>(0u))), 4294967295u, (_e3236 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3245), 0u, (_e3245 < bitcast<f32>(0u))), 4294967295u, (_e3245 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3257), 0u, (_e3257 < bitcast<f32>(0u))), 4294967295u, (_e3257 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_3567_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3271 = phi_3567_;
        if (_e96.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e96.shift)] = _e3271;
        if (_e2631.triangle != 4294967295u) {
            let _e3280 = ((1f - _e2631.u) - _e2631.v);
            if (_e2631.triangle < _e72) {
            } else {
                return;
            }
            let _e3285 = triangles.member[(0u + _e2631.triangle)];
            let _e3287 = (_e3285.i0_ & 2147483647u);
            if (_e3287 < _e87) {
            } else {
                return;
            }
            let _e3293 = before.member[(0u + _e3287)];
            if (_e3285.i1_ < _e87) {
            } else {
                return;
            }
            let _e3297 = before.member[(0u + _e3285.i1_)];
            if (_e3285.i2_ < _e87) {
            } else {
                return;
            }
            let _e3301 = before.member[(0u + _e3285.i2_)];
            if (_e2631.instance < _e84) {
            } else {
                return;
            }
            let _e3311 = instances.member[(0u + _e2631.instance)].object_to_world[0u];
            let _e3324 = instances.member[(0u + _e2631.instance)].object_to_world[1u];
            let _e3337 = instances.member[(0u + _e2631.instance)].object_to_world[2u];
            if (_e2631.instance < _e84) {
            } else {
                return;
            }
            let _e3361 = instances.member[(0u + _e2631.instance)].object_to_world[0u];
            let _e3374 = instances.member[(0u + _e2631.instance)].object_to_world[1u];
            let _e3387 = instances.member[(0u + _e2631.instance)].object_to_world[2u];
            if (_e2631.instance < _e84) {
            } else {
                return;
            }
            let _e3414 = instances.member[(0u + _e2631.instance)].object_to_world[0u];
            let _e3427 = instances.member[(0u + _e2631.instance)].object_to_world[1u];
            let _e3440 = instances.member[(0u + _e2631.instance)].object_to_world[2u];
            phi_3790_ = vec3<f32>((((((((_e3311.x * _e3293.x) + (_e3311.y * _e3293.y)) + (_e3311.z * _e3293.z)) + (_e3311.w * 1f)) * _e3280) + (((((_e3361.x * _e3297.x) + (_e3361.y * _e3297.y)) + (_e3361.z * _e3297.z)) + (_e3361.w * 1f)) * _e2631.u)) + (((((_e3414.x * _e3301.x) + (_e3414.y * _e3301.y)) + (_e3414.z * _e3301.z)) + (_e3414.w * 1f)) * _e2631.v)), (((((((_e3324.x * _e3293.x) + (_e3324.y * _e3293.y)) + (_e3324.z * _e3293.z)) + (_e3324.w * 1f)) * _e3280) + (((((_e3374.x * _e3297.x) + (_e3374.y * _e3297.y)) + (_e3374.z * _e3297.z)) + (_e3374.w * 1f)) * _e2631.u)) + (((((_e3427.x * _e3301.x) + (_e3427.y * _e3301.y)) + (_e3427.z * _e3301.z)) + (_e3427.w * 1f)) * _e2631.v)), (((((((_e3337.x * _e3293.x) + (_e3337.y * _e3293.y)) + (_e3337.z * _e3293.z)) + (_e3337.w * 1f)) * _e3280) + (((((_e3387.x * _e3297.x) + (_e3387.y * _e3297.y)) + (_e3387.z * _e3297.z)) + (_e3387.w * 1f)) * _e2631.u)) + (((((_e3440.x * _e3301.x) + (_e3440.y * _e3301.y)) + (_e3440.z * _e3301.z)) + (_e3440.w * 1f)) * _e2631.v)));
        } else {
            phi_3790_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e3460 = phi_3790_;
        if (_e96.shift < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e96.shift)] = vec4<f32>(_e3460.x, _e3460.y, _e3460.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
