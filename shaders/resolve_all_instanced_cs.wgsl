struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct lt_bvh_Triangle {
    v0_: vec3<f32>,
    i0_: u32,
    v1_: vec3<f32>,
    i1_: u32,
    v2_: vec3<f32>,
    i2_: u32,
}

struct type_6 {
    member: array<lt_bvh_Triangle>,
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

struct type_23 {
    member: array<lt_bvh_Instance>,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_32 {
    member: array<abi_Sample>,
}

struct type_36 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
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

struct type_47 {
    member: array<lt_bvh_Node>,
}

struct lt_bvh_Ray {
    origin: vec3<f32>,
    tmin: f32,
    direction: vec3<f32>,
    tmax: f32,
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

struct abi_ShadowParams {
    projection: lt_math_LightProjection,
    light: vec4<f32>,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_54 {
    member: abi_ShadowParams,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_32;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_54;
@group(0) @binding(2) 
var<storage> nodes: type_47;
@group(0) @binding(3) 
var<storage> triangles: type_6;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_36;
@group(0) @binding(5) 
var<storage> instances: type_23;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_190_: lt_bvh_traverse_Tree;
    var phi_191_: bool;
    var phi_192_: lt_bvh_traverse_Tree;
    var phi_193_: bool;
    var phi_198_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_190_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_191_ = false;
        } else {
            phi_190_ = lt_bvh_traverse_Tree();
            phi_191_ = true;
        }
        let _e67 = phi_190_;
        let _e69 = phi_191_;
        phi_192_ = _e67;
        phi_193_ = _e69;
    } else {
        phi_192_ = lt_bvh_traverse_Tree();
        phi_193_ = true;
    }
    let _e71 = phi_192_;
    let _e73 = phi_193_;
    if _e73 {
        phi_198_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_198_ = _e71;
    }
    let _e78 = phi_198_;
    return lt_bvh_traverse_Tree(_e78.root, _e78.first_primitive);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_213_: bool;
    var phi_217_: f32;

    if (param_3 != param_3) {
        phi_213_ = true;
    } else {
        let _e57 = (param_4 >= param_3);
        if _e57 {
        }
        phi_213_ = _e57;
    }
    let _e59 = phi_213_;
    if _e59 {
        phi_217_ = param_4;
    } else {
        phi_217_ = param_3;
    }
    let _e61 = phi_217_;
    return _e61;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_229_: bool;
    var phi_233_: f32;

    if (param_5 != param_5) {
        phi_229_ = true;
    } else {
        let _e57 = (param_6 <= param_5);
        if _e57 {
        }
        phi_229_ = _e57;
    }
    let _e59 = phi_229_;
    if _e59 {
        phi_233_ = param_6;
    } else {
        phi_233_ = param_5;
    }
    let _e61 = phi_233_;
    return _e61;
}

fn lt_shaders_evaluate_to_light(param_7: vec3<f32>, param_8: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_8.x - (param_7.x * param_8.w)), (param_8.y - (param_7.y * param_8.w)), (param_8.z - (param_7.z * param_8.w)));
}

fn _lt_shaders_abi_Sample_is_valid(param_9: ptr<function, abi_Sample>) -> bool {
    var phi_300_: bool;
    var phi_301_: bool;
    var phi_302_: bool;
    var phi_303_: bool;
    var phi_307_: bool;

    let _e57 = (*param_9).normal[0u];
    let _e59 = global[0u];
    if (_e57 == _e59) {
        let _e62 = (*param_9).normal[1u];
        let _e64 = global[1u];
        if (_e62 == _e64) {
            let _e67 = (*param_9).normal[2u];
            let _e69 = global[2u];
            phi_300_ = (_e67 == _e69);
            phi_301_ = false;
        } else {
            phi_300_ = bool();
            phi_301_ = true;
        }
        let _e72 = phi_300_;
        let _e74 = phi_301_;
        phi_302_ = _e72;
        phi_303_ = _e74;
    } else {
        phi_302_ = bool();
        phi_303_ = true;
    }
    let _e76 = phi_302_;
    let _e78 = phi_303_;
    if _e78 {
        phi_307_ = false;
    } else {
        phi_307_ = _e76;
    }
    let _e80 = phi_307_;
    return !(_e80);
}

fn lt_shaders_evaluate_settle(param_10: ptr<function, abi_Sample>, param_11: vec4<f32>) -> u0028_evaluate_Verdict_u0020_bool_u0029_ {
    var phi_271_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_275_: u0028_evaluate_Verdict_u0020_bool_u0029_;

    let _e56 = _lt_shaders_abi_Sample_is_valid(param_10);
    if _e56 {
        let _e58 = (*param_10).normal;
        let _e60 = (*param_10).position;
        let _e61 = lt_shaders_evaluate_to_light(_e60, param_11);
        if ((((_e58.x * _e61.x) + (_e58.y * _e61.y)) + (_e58.z * _e61.z)) > 0f) {
            let _e75 = (*param_10).flags;
            let _e83 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e89 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e83.unnamed.visibility, false), _e83.unnamed_1);
            phi_271_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e89.unnamed, ((_e75 & 1u) == 0u));
        } else {
            let _e98 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e104 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e98.unnamed.visibility, false), _e98.unnamed_1);
            phi_271_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e104.unnamed, true);
        }
        let _e109 = phi_271_;
        phi_275_ = _e109;
    } else {
        let _e115 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
        let _e121 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e115.unnamed.visibility, false), _e115.unnamed_1);
        phi_275_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e121.unnamed, true);
    }
    let _e126 = phi_275_;
    return _e126;
}

fn lt_shaders_resolve_shadow_ray(param_12: ptr<function, abi_Sample>, param_13: vec4<f32>) -> lt_bvh_Ray {
    var phi_350_: f32;

    let _e57 = (*param_12).position;
    let _e59 = (*param_12).normal;
    let _e61 = (*param_12).magnitude;
    let _e63 = ((8f / 8388608f) * _e61);
    let _e71 = (_e57 + vec3<f32>((_e59.x * _e63), (_e59.y * _e63), (_e59.z * _e63)));
    if (param_13.w == 0f) {
        phi_350_ = 300000000000000000000000000000000000000f;
    } else {
        phi_350_ = 1f;
    }
    let _e75 = phi_350_;
    let _e76 = lt_shaders_evaluate_to_light(_e71, param_13);
    return lt_bvh_Ray(_e71, 0f, _e76, _e75);
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: abi_Sample;
    var phi_469_: bool;
    var phi_470_: bool;
    var phi_471_: bool;
    var phi_475_: bool;
    var phi_476_: bool;
    var phi_477_: bool;
    var phi_478_: bool;
    var phi_479_: bool;
    var phi_480_: bool;
    var phi_481_: bool;
    var phi_482_: bool;
    var phi_483_: bool;
    var phi_484_: bool;
    var phi_485_: bool;
    var phi_486_: bool;
    var phi_487_: bool;
    var phi_488_: bool;
    var phi_489_: bool;
    var phi_490_: bool;
    var phi_491_: bool;
    var phi_492_: bool;
    var phi_496_: bool;
    var phi_500_: bool;
    var phi_575_: f32;
    var phi_582_: f32;
    var phi_590_: f32;
    var phi_597_: f32;
    var phi_605_: f32;
    var phi_612_: f32;
    var phi_637_: f32;
    var phi_642_: f32;
    var phi_647_: f32;
    var phi_669_: u32;
    var phi_674_: u32;
    var phi_679_: u32;
    var phi_793_: bool;
    var phi_794_: bool;
    var phi_825_: u32;
    var phi_827_: u32;
    var phi_913_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_940_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_967_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_973_: u32;
    var phi_976_: u32;
    var phi_990_: u32;
    var phi_1000_: u32;
    var phi_1010_: u32;
    var phi_1028_: u32;
    var phi_1038_: u32;
    var phi_1048_: u32;
    var phi_1084_: u32;
    var phi_1097_: u32;
    var phi_1102_: u32;
    var phi_1103_: u32;
    var phi_1104_: u32;
    var phi_974_: u32;
    var phi_977_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1162_: u32;
    var phi_1218_: f32;
    var phi_1223_: f32;
    var phi_1228_: f32;
    var phi_1236_: f32;
    var phi_1241_: f32;
    var phi_1246_: f32;
    var phi_1402_: bool;
    var phi_1403_: bool;
    var phi_1404_: bool;
    var phi_1408_: bool;
    var phi_1409_: bool;
    var phi_1410_: bool;
    var phi_1411_: bool;
    var phi_1412_: bool;
    var phi_1413_: bool;
    var phi_1414_: bool;
    var phi_1415_: bool;
    var phi_1416_: bool;
    var phi_1417_: bool;
    var phi_1418_: bool;
    var phi_1419_: bool;
    var phi_1420_: bool;
    var phi_1421_: bool;
    var phi_1422_: bool;
    var phi_1423_: bool;
    var phi_1424_: bool;
    var phi_1425_: bool;
    var phi_1429_: bool;
    var phi_1433_: bool;
    var phi_1503_: f32;
    var phi_1510_: f32;
    var phi_1517_: f32;
    var phi_1524_: f32;
    var phi_1531_: f32;
    var phi_1538_: f32;
    var phi_1555_: f32;
    var phi_1560_: f32;
    var phi_1565_: f32;
    var phi_1593_: bool;
    var phi_1594_: bool;
    var phi_1602_: u32;
    var phi_1603_: u32;
    var phi_1614_: vec3<f32>;
    var phi_1615_: vec3<f32>;
    var phi_1628_: u32;
    var phi_1633_: u32;
    var phi_1638_: u32;
    var phi_1752_: bool;
    var phi_1753_: bool;
    var phi_1784_: u32;
    var phi_1786_: u32;
    var phi_1867_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1894_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1921_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1927_: u32;
    var phi_1930_: u32;
    var phi_1944_: u32;
    var phi_1954_: u32;
    var phi_1964_: u32;
    var phi_1982_: u32;
    var phi_1992_: u32;
    var phi_2002_: u32;
    var phi_2038_: u32;
    var phi_2051_: u32;
    var phi_2056_: u32;
    var phi_2057_: u32;
    var phi_2058_: u32;
    var phi_1928_: u32;
    var phi_1931_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2116_: u32;
    var phi_2161_: vec3<f32>;
    var phi_2162_: vec3<f32>;
    var phi_2193_: vec3<f32>;
    var phi_2194_: vec3<f32>;
    var phi_2225_: vec3<f32>;
    var phi_2226_: vec3<f32>;
    var phi_2246_: bool;
    var phi_2247_: bool;
    var phi_2251_: f32;
    var phi_2252_: f32;
    var phi_2253_: f32;
    var phi_2254_: f32;
    var phi_2262_: f32;
    var phi_2272_: bool;
    var phi_2273_: bool;
    var phi_2277_: f32;
    var phi_2278_: f32;
    var phi_2279_: f32;
    var phi_2280_: f32;
    var phi_2288_: f32;
    var phi_2298_: bool;
    var phi_2299_: bool;
    var phi_2303_: f32;
    var phi_2304_: f32;
    var phi_2305_: f32;
    var phi_2306_: f32;
    var phi_2314_: f32;
    var phi_2329_: f32;
    var phi_2330_: bool;
    var phi_2331_: f32;
    var phi_2332_: bool;
    var phi_2333_: f32;
    var phi_2334_: bool;
    var phi_2352_: f32;
    var phi_2353_: bool;
    var phi_2354_: bool;
    var phi_2355_: f32;
    var phi_2356_: bool;
    var phi_2357_: bool;
    var phi_2361_: bool;
    var phi_2362_: f32;
    var phi_2363_: bool;
    var phi_2389_: f32;
    var phi_2398_: f32;
    var phi_2407_: f32;
    var phi_2416_: f32;
    var phi_2423_: f32;
    var phi_2430_: f32;
    var phi_2443_: f32;
    var phi_2452_: f32;
    var phi_2461_: f32;
    var phi_2470_: f32;
    var phi_2477_: f32;
    var phi_2484_: f32;
    var phi_2501_: f32;
    var phi_2506_: f32;
    var phi_2511_: f32;
    var phi_2519_: f32;
    var phi_2524_: f32;
    var phi_2529_: f32;
    var phi_2541_: f32;
    var phi_2546_: f32;
    var phi_2551_: f32;
    var phi_2556_: f32;
    var phi_2561_: lt_bvh_triangle_Intersection;
    var phi_2562_: lt_bvh_triangle_Intersection;
    var phi_2563_: bool;
    var phi_2567_: lt_bvh_triangle_Intersection;
    var phi_2592_: bool;
    var phi_2593_: bool;
    var phi_2594_: bool;
    var phi_2595_: bool;
    var phi_2596_: bool;
    var phi_2597_: bool;
    var phi_2598_: bool;
    var phi_2599_: bool;
    var phi_2600_: bool;
    var phi_2601_: bool;
    var phi_2602_: bool;
    var phi_2603_: bool;
    var phi_2607_: bool;
    var phi_2608_: bool;
    var phi_2117_: u32;
    var phi_2609_: bool;
    var phi_2610_: bool;
    var phi_2611_: bool;
    var local_9: bool;
    var phi_2653_: bool;
    var phi_2654_: bool;
    var phi_2685_: u32;
    var phi_2686_: u32;
    var phi_2687_: bool;
    var phi_2688_: bool;
    var phi_1787_: u32;
    var phi_2689_: bool;
    var phi_2690_: bool;
    var phi_2691_: bool;
    var phi_2692_: bool;
    var local_10: bool;
    var phi_2696_: bool;
    var phi_2697_: bool;
    var phi_2701_: bool;
    var phi_2705_: bool;
    var phi_2706_: bool;
    var phi_2707_: bool;
    var phi_2708_: bool;
    var phi_2712_: bool;
    var phi_2716_: bool;
    var phi_2717_: bool;
    var phi_2718_: bool;
    var phi_2719_: bool;
    var phi_1163_: u32;
    var phi_2723_: bool;
    var local_11: bool;
    var phi_2765_: bool;
    var phi_2766_: bool;
    var phi_2797_: u32;
    var phi_2798_: u32;
    var phi_828_: u32;
    var phi_2799_: bool;
    var phi_2800_: bool;
    var local_12: bool;
    var phi_2804_: bool;
    var phi_2808_: bool;
    var phi_2809_: bool;
    var phi_2810_: bool;
    var phi_2811_: bool;
    var phi_2815_: bool;
    var phi_2819_: f32;
    var phi_2820_: f32;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;
    var local_18: bool;

    let _e57 = id_1;
    let _e64 = arrayLength((&nodes.member));
    let _e76 = p.member.size[0u];
    let _e78 = p.member.size[1u];
    let _e79 = lt_shaders_entry_pixel_index(_e57, _e76, _e78);
    if (bitcast<i32>(_e79.root) != 0i) {
        if (_e79.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e87 = samples.member[(0u + _e79.first_primitive)];
        local_2 = abi_Sample(_e87.position, _e87.magnitude, _e87.normal, _e87.flags, _e87.shading_normal, _e87.albedo);
        let _e96 = p.member.light;
        let _e97 = lt_shaders_evaluate_settle((&local_2), _e96);
        let _e102 = p.member.root;
        if _e97.unnamed_1 {
            phi_2820_ = _e97.unnamed.visibility;
        } else {
            let _e104 = p.member.light;
            let _e105 = lt_shaders_resolve_shadow_ray((&local_2), _e104);
            let _e115 = abs(_e105.direction.x);
            let _e117 = abs(_e105.direction.y);
            let _e119 = abs(_e105.direction.z);
            if (abs(_e105.origin.x) < 1000000000000000f) {
                if (abs(_e105.origin.y) < 1000000000000000f) {
                    if (abs(_e105.origin.z) < 1000000000000000f) {
                        if (_e115 < 1000000000000000f) {
                            if (_e117 < 1000000000000000f) {
                                if (_e119 < 1000000000000000f) {
                                    if (_e115 > 0f) {
                                        phi_470_ = bool();
                                        phi_471_ = true;
                                    } else {
                                        let _e127 = (_e117 > 0f);
                                        if _e127 {
                                            phi_469_ = bool();
                                        } else {
                                            phi_469_ = (_e119 > 0f);
                                        }
                                        let _e130 = phi_469_;
                                        phi_470_ = _e130;
                                        phi_471_ = _e127;
                                    }
                                    let _e132 = phi_470_;
                                    let _e134 = phi_471_;
                                    if _e134 {
                                        phi_475_ = true;
                                    } else {
                                        phi_475_ = _e132;
                                    }
                                    let _e136 = phi_475_;
                                    phi_476_ = _e136;
                                    phi_477_ = false;
                                } else {
                                    phi_476_ = bool();
                                    phi_477_ = true;
                                }
                                let _e138 = phi_476_;
                                let _e140 = phi_477_;
                                phi_478_ = _e138;
                                phi_479_ = false;
                                phi_480_ = _e140;
                            } else {
                                phi_478_ = bool();
                                phi_479_ = true;
                                phi_480_ = false;
                            }
                            let _e142 = phi_478_;
                            let _e144 = phi_479_;
                            let _e146 = phi_480_;
                            phi_481_ = _e142;
                            phi_482_ = _e144;
                            phi_483_ = _e146;
                        } else {
                            phi_481_ = bool();
                            phi_482_ = true;
                            phi_483_ = false;
                        }
                        let _e148 = phi_481_;
                        let _e150 = phi_482_;
                        let _e152 = phi_483_;
                        phi_484_ = _e148;
                        phi_485_ = _e150;
                        phi_486_ = _e152;
                    } else {
                        phi_484_ = bool();
                        phi_485_ = true;
                        phi_486_ = false;
                    }
                    let _e154 = phi_484_;
                    let _e156 = phi_485_;
                    let _e158 = phi_486_;
                    phi_487_ = _e154;
                    phi_488_ = _e156;
                    phi_489_ = _e158;
                } else {
                    phi_487_ = bool();
                    phi_488_ = true;
                    phi_489_ = false;
                }
                let _e160 = phi_487_;
                let _e162 = phi_488_;
                let _e164 = phi_489_;
                phi_490_ = _e160;
                phi_491_ = _e162;
                phi_492_ = _e164;
            } else {
                phi_490_ = bool();
                phi_491_ = true;
                phi_492_ = false;
            }
            let _e166 = phi_490_;
            let _e168 = phi_491_;
            let _e170 = phi_492_;
            if _e168 {
                phi_496_ = true;
            } else {
                phi_496_ = _e170;
            }
            let _e172 = phi_496_;
            if _e172 {
                phi_500_ = false;
            } else {
                phi_500_ = _e166;
            }
            let _e174 = phi_500_;
            if _e174 {
                let _e175 = (_e102 >= _e64);
                if _e175 {
                    phi_2809_ = bool();
                } else {
                    if (_e102 < _e64) {
                    } else {
                        return;
                    }
                    let _e181 = nodes.member[(0u + _e102)].frame[0u];
                    let _e185 = nodes.member[(0u + _e102)].frame[1u];
                    let _e189 = nodes.member[(0u + _e102)].frame[2u];
                    let _e193 = nodes.member[(0u + _e102)].frame[0u];
                    let _e197 = nodes.member[(0u + _e102)].frame[1u];
                    let _e201 = nodes.member[(0u + _e102)].frame[2u];
                    let _e205 = nodes.member[(0u + _e102)].frame[3u];
                    let _e243 = core_intrinsics_maximum_number_nsz_f32_(abs(_e105.direction.x), abs(_e105.direction.y));
                    let _e244 = core_intrinsics_maximum_number_nsz_f32_(_e243, abs(_e105.direction.z));
                    let _e245 = (_e244 * 0.0000000000009094947f);
                    if (abs(_e105.direction.x) < _e245) {
                        phi_575_ = _e245;
                    } else {
                        phi_575_ = abs(_e105.direction.x);
                    }
                    let _e252 = phi_575_;
                    if (_e105.direction.x < 0f) {
                        phi_582_ = (-1f / _e252);
                    } else {
                        phi_582_ = (1f / _e252);
                    }
                    let _e257 = phi_582_;
                    if (abs(_e105.direction.y) < _e245) {
                        phi_590_ = _e245;
                    } else {
                        phi_590_ = abs(_e105.direction.y);
                    }
                    let _e264 = phi_590_;
                    if (_e105.direction.y < 0f) {
                        phi_597_ = (-1f / _e264);
                    } else {
                        phi_597_ = (1f / _e264);
                    }
                    let _e269 = phi_597_;
                    if (abs(_e105.direction.z) < _e245) {
                        phi_605_ = _e245;
                    } else {
                        phi_605_ = abs(_e105.direction.z);
                    }
                    let _e276 = phi_605_;
                    if (_e105.direction.z < 0f) {
                        phi_612_ = (-1f / _e276);
                    } else {
                        phi_612_ = (1f / _e276);
                    }
                    let _e281 = phi_612_;
                    let _e289 = abs((bitcast<f32>(_e181) - _e105.origin.x));
                    let _e290 = abs((bitcast<f32>(_e185) - _e105.origin.y));
                    let _e291 = abs((bitcast<f32>(_e189) - _e105.origin.z));
                    let _e299 = abs(((bitcast<f32>(_e193) + (bitcast<f32>((((_e205 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e105.origin.x));
                    let _e300 = abs(((bitcast<f32>(_e197) + (bitcast<f32>((((_e205 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e105.origin.y));
                    let _e301 = abs(((bitcast<f32>(_e201) + (bitcast<f32>((((_e205 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e105.origin.z));
                    if (_e289 > _e299) {
                        phi_637_ = _e289;
                    } else {
                        phi_637_ = _e299;
                    }
                    let _e304 = phi_637_;
                    if (_e290 > _e300) {
                        phi_642_ = _e290;
                    } else {
                        phi_642_ = _e300;
                    }
                    let _e307 = phi_642_;
                    if (_e291 > _e301) {
                        phi_647_ = _e291;
                    } else {
                        phi_647_ = _e301;
                    }
                    let _e310 = phi_647_;
                    let _e311 = core_intrinsics_maximum_number_nsz_f32_(_e304, _e307);
                    let _e312 = core_intrinsics_maximum_number_nsz_f32_(_e311, _e310);
                    let _e317 = (_e312 * 0.0000019073486f);
                    let _e318 = (abs(_e257) * _e317);
                    let _e319 = (abs(_e269) * _e317);
                    let _e320 = (abs(_e281) * _e317);
                    let _e324 = (_e312 * 0.0000009536743f);
                    let _e325 = (abs(_e257) * _e324);
                    let _e326 = (abs(_e269) * _e324);
                    let _e327 = (abs(_e281) * _e324);
                    if (_e257 < 0f) {
                        phi_669_ = 0u;
                    } else {
                        phi_669_ = 1u;
                    }
                    let _e330 = phi_669_;
                    if (_e269 < 0f) {
                        phi_674_ = 0u;
                    } else {
                        phi_674_ = 2u;
                    }
                    let _e333 = phi_674_;
                    if (_e281 < 0f) {
                        phi_679_ = 0u;
                    } else {
                        phi_679_ = 4u;
                    }
                    let _e336 = phi_679_;
                    let _e338 = ((_e330 | _e333) | _e336);
                    let _e339 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e102, 2147483648u);
                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e339.first[0], _e339.first[1], _e339.first[2], _e339.first[3], _e339.first[4], _e339.first[5], _e339.first[6], _e339.first[7], _e339.first[8], _e339.first[9], _e339.first[10], _e339.first[11], _e339.first[12], _e339.first[13], _e339.first[14], _e339.first[15], _e339.first[16], _e339.first[17], _e339.first[18], _e339.first[19], _e339.first[20], _e339.first[21], _e339.first[22], _e339.first[23], _e339.first[24], _e339.first[25], _e339.first[26], _e339.first[27], _e339.first[28], _e339.first[29], _e339.first[30], _e339.first[31]), array<u32, 32>(_e339.mask[0], _e339.mask[1], _e339.mask[2], _e339.mask[3], _e339.mask[4], _e339.mask[5], _e339.mask[6], _e339.mask[7], _e339.mask[8], _e339.mask[9], _e339.mask[10], _e339.mask[11], _e339.mask[12], _e339.mask[13], _e339.mask[14], _e339.mask[15], _e339.mask[16], _e339.mask[17], _e339.mask[18], _e339.mask[19], _e339.mask[20], _e339.mask[21], _e339.mask[22], _e339.mask[23], _e339.mask[24], _e339.mask[25], _e339.mask[26], _e339.mask[27], _e339.mask[28], _e339.mask[29], _e339.mask[30], _e339.mask[31]), _e339.len, _e339.group, _e339.group_mask);
                    let _e413 = local_1.group_mask;
                    if ((_e413 & 4278190080u) == 0u) {
                        let _e417 = local_1.len;
                        if (_e417 == 0u) {
                            phi_793_ = false;
                        } else {
                            let _e421 = local_1.len;
                            local_1.len = (_e421 - 1u);
                            let _e424 = local_1.len;
                            if (_e424 < 32u) {
                            } else {
                                return;
                            }
                            let _e429 = local_1.first[(0u + _e424)];
                            local_1.group = _e429;
                            let _e432 = local_1.len;
                            if (_e432 < 32u) {
                            } else {
                                return;
                            }
                            let _e437 = local_1.mask[(0u + _e432)];
                            local_1.group_mask = _e437;
                            phi_793_ = true;
                        }
                        let _e440 = phi_793_;
                        phi_794_ = _e440;
                    } else {
                        phi_794_ = true;
                    }
                    let _e442 = phi_794_;
                    if _e442 {
                        let _e444 = local_1.group_mask;
                        let _e450 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e444)), 32u, (_e444 == 0u)));
                        let _e454 = local_1.group_mask;
                        let _e468 = local_1.group_mask;
                        local_1.group_mask = (_e468 & ~((1u << bitcast<u32>((_e450 & 31u)))));
                        let _e471 = local_1.group;
                        phi_825_ = (_e471 + countOneBits(((_e454 & ~((4294967295u << bitcast<u32>((((_e450 - 24u) ^ 7u) & 31u))))) & 255u)));
                    } else {
                        phi_825_ = 4294967295u;
                    }
                    let _e474 = phi_825_;
                    phi_827_ = _e474;
                    loop {
                        let _e476 = phi_827_;
                        if (_e476 != 4294967295u) {
                            if (_e476 < _e64) {
                            } else {
                                return;
                            }
                            let _e485 = nodes.member[(0u + _e476)].frame[3u];
                            let _e510 = (bitcast<f32>((((_e485 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e257);
                            let _e511 = (bitcast<f32>((((_e485 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e269);
                            let _e512 = (bitcast<f32>((((_e485 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e281);
                            let _e515 = nodes.member[(0u + _e476)].frame[0u];
                            let _e519 = nodes.member[(0u + _e476)].frame[1u];
                            let _e523 = nodes.member[(0u + _e476)].frame[2u];
                            let _e531 = ((bitcast<f32>(_e515) - _e105.origin.x) * _e257);
                            let _e532 = ((bitcast<f32>(_e519) - _e105.origin.y) * _e269);
                            let _e533 = ((bitcast<f32>(_e523) - _e105.origin.z) * _e281);
                            let _e541 = nodes.member[(0u + _e476)].x;
                            if (_e257 < 0f) {
                                let _e552 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e541.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e558 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e552.unnamed.root, _e541.w), _e552.unnamed_1);
                                let _e564 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e558.unnamed, lt_bvh_traverse_Tree(_e541.x, _e558.unnamed_1.first_primitive));
                                phi_913_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e564.unnamed, lt_bvh_traverse_Tree(_e564.unnamed_1.root, _e541.y));
                            } else {
                                let _e580 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e541.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e586 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e580.unnamed.root, _e541.y), _e580.unnamed_1);
                                let _e592 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e586.unnamed, lt_bvh_traverse_Tree(_e541.z, _e586.unnamed_1.first_primitive));
                                phi_913_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e592.unnamed, lt_bvh_traverse_Tree(_e592.unnamed_1.root, _e541.w));
                            }
                            let _e600 = phi_913_;
                            let _e610 = nodes.member[(0u + _e476)].y;
                            if (_e269 < 0f) {
                                let _e621 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e610.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e627 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e621.unnamed.root, _e610.w), _e621.unnamed_1);
                                let _e633 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e627.unnamed, lt_bvh_traverse_Tree(_e610.x, _e627.unnamed_1.first_primitive));
                                phi_940_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e633.unnamed, lt_bvh_traverse_Tree(_e633.unnamed_1.root, _e610.y));
                            } else {
                                let _e649 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e610.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e655 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e649.unnamed.root, _e610.y), _e649.unnamed_1);
                                let _e661 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e655.unnamed, lt_bvh_traverse_Tree(_e610.z, _e655.unnamed_1.first_primitive));
                                phi_940_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e661.unnamed, lt_bvh_traverse_Tree(_e661.unnamed_1.root, _e610.w));
                            }
                            let _e669 = phi_940_;
                            let _e679 = nodes.member[(0u + _e476)].z;
                            if (_e281 < 0f) {
                                let _e690 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e679.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e696 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e690.unnamed.root, _e679.w), _e690.unnamed_1);
                                let _e702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e696.unnamed, lt_bvh_traverse_Tree(_e679.x, _e696.unnamed_1.first_primitive));
                                phi_967_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e702.unnamed, lt_bvh_traverse_Tree(_e702.unnamed_1.root, _e679.y));
                            } else {
                                let _e718 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e679.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e724 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e718.unnamed.root, _e679.y), _e718.unnamed_1);
                                let _e730 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e724.unnamed, lt_bvh_traverse_Tree(_e679.z, _e724.unnamed_1.first_primitive));
                                phi_967_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e730.unnamed, lt_bvh_traverse_Tree(_e730.unnamed_1.root, _e679.w));
                            }
                            let _e738 = phi_967_;
                            phi_973_ = 0u;
                            phi_976_ = 0u;
                            loop {
                                let _e748 = phi_973_;
                                let _e750 = phi_976_;
                                local_3 = _e750;
                                local_4 = _e750;
                                local_5 = _e750;
                                let _e751 = (_e748 < 8u);
                                if _e751 {
                                    let _e753 = (_e748 >> bitcast<u32>(2i));
                                    let _e754 = (_e748 & 3u);
                                    if (_e753 == 0u) {
                                        phi_990_ = _e600.unnamed.root;
                                    } else {
                                        phi_990_ = _e600.unnamed.first_primitive;
                                    }
                                    let _e757 = phi_990_;
                                    if (_e753 == 0u) {
                                        phi_1000_ = _e669.unnamed.root;
                                    } else {
                                        phi_1000_ = _e669.unnamed.first_primitive;
                                    }
                                    let _e766 = phi_1000_;
                                    if (_e753 == 0u) {
                                        phi_1010_ = _e738.unnamed.root;
                                    } else {
                                        phi_1010_ = _e738.unnamed.first_primitive;
                                    }
                                    let _e775 = phi_1010_;
                                    let _e788 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e757 >> bitcast<u32>(((_e754 * 8u) & 31u))) & 255u)) * _e510) + (_e531 - _e318)), ((f32(((_e766 >> bitcast<u32>(((_e754 * 8u) & 31u))) & 255u)) * _e511) + (_e532 - _e319)));
                                    let _e789 = core_intrinsics_maximum_number_nsz_f32_(_e788, ((f32(((_e775 >> bitcast<u32>(((_e754 * 8u) & 31u))) & 255u)) * _e512) + (_e533 - _e320)));
                                    if (_e753 == 0u) {
                                        phi_1028_ = _e600.unnamed_1.root;
                                    } else {
                                        phi_1028_ = _e600.unnamed_1.first_primitive;
                                    }
                                    let _e792 = phi_1028_;
                                    if (_e753 == 0u) {
                                        phi_1038_ = _e669.unnamed_1.root;
                                    } else {
                                        phi_1038_ = _e669.unnamed_1.first_primitive;
                                    }
                                    let _e801 = phi_1038_;
                                    if (_e753 == 0u) {
                                        phi_1048_ = _e738.unnamed_1.root;
                                    } else {
                                        phi_1048_ = _e738.unnamed_1.first_primitive;
                                    }
                                    let _e810 = phi_1048_;
                                    let _e823 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e792 >> bitcast<u32>(((_e754 * 8u) & 31u))) & 255u)) * _e510) + (_e531 + _e318)), ((f32(((_e801 >> bitcast<u32>(((_e754 * 8u) & 31u))) & 255u)) * _e511) + (_e532 + _e319)));
                                    let _e824 = core_intrinsics_minimum_number_nsz_f32_(_e823, ((f32(((_e810 >> bitcast<u32>(((_e754 * 8u) & 31u))) & 255u)) * _e512) + (_e533 + _e320)));
                                    if (_e789 <= _e824) {
                                        if (_e789 <= _e105.tmax) {
                                            if (_e824 >= _e105.tmin) {
                                                if (_e753 == 0u) {
                                                    let _e831 = nodes.member[(0u + _e476)].links[2u];
                                                    phi_1084_ = _e831;
                                                } else {
                                                    let _e834 = nodes.member[(0u + _e476)].links[3u];
                                                    phi_1084_ = _e834;
                                                }
                                                let _e836 = phi_1084_;
                                                let _e841 = ((_e836 >> bitcast<u32>(((_e754 * 8u) & 31u))) & 255u);
                                                let _e842 = (_e841 & 31u);
                                                if (_e842 >= 24u) {
                                                    phi_1097_ = (24u + ((_e842 - 24u) ^ _e338));
                                                } else {
                                                    phi_1097_ = _e842;
                                                }
                                                let _e848 = phi_1097_;
                                                phi_1102_ = (_e750 | ((_e841 >> bitcast<u32>(5i)) << bitcast<u32>((_e848 & 31u))));
                                            } else {
                                                phi_1102_ = _e750;
                                            }
                                            let _e856 = phi_1102_;
                                            phi_1103_ = _e856;
                                        } else {
                                            phi_1103_ = _e750;
                                        }
                                        let _e858 = phi_1103_;
                                        phi_1104_ = _e858;
                                    } else {
                                        phi_1104_ = _e750;
                                    }
                                    let _e860 = phi_1104_;
                                    phi_974_ = (_e748 + 1u);
                                    phi_977_ = _e860;
                                } else {
                                    phi_974_ = u32();
                                    phi_977_ = u32();
                                }
                                let _e863 = phi_974_;
                                let _e865 = phi_977_;
                                continue;
                                continuing {
                                    phi_973_ = _e863;
                                    phi_976_ = _e865;
                                    break if !(_e751);
                                }
                            }
                            let _e869 = nodes.member[(0u + _e476)].links[0u];
                            let _e873 = nodes.member[(0u + _e476)].frame[3u];
                            let _e877 = local_3;
                            if ((_e877 & 4278190080u) == 0u) {
                            } else {
                                let _e881 = local_1.group_mask;
                                if ((_e881 & 4278190080u) == 0u) {
                                } else {
                                    let _e885 = local_1.len;
                                    if (_e885 < 32u) {
                                        let _e888 = local_1.group;
                                        let _e890 = local_1.len;
                                        if (_e890 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_1.first[(0u + _e890)] = _e888;
                                        let _e896 = local_1.group_mask;
                                        let _e898 = local_1.len;
                                        if (_e898 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local_1.mask[(0u + _e898)] = _e896;
                                        let _e905 = local_1.len;
                                        local_1.len = (_e905 + 1u);
                                    }
                                }
                                local_1.group = (_e102 + _e869);
                                let _e909 = local_4;
                                local_1.group_mask = ((_e909 & 4278190080u) | (_e873 >> bitcast<u32>(24i)));
                            }
                            let _e914 = local_5;
                            phi_1162_ = (_e914 & 16777215u);
                            loop {
                                let _e917 = phi_1162_;
                                let _e918 = (_e917 == 0u);
                                local_11 = _e918;
                                local_18 = _e918;
                                if _e918 {
                                    phi_1163_ = u32();
                                    phi_2723_ = false;
                                } else {
                                    let _e921 = nodes.member[(0u + _e476)].links[1u];
                                    let _e925 = (_e921 + select(firstTrailingBit(_e917), 32u, (_e917 == 0u)));
                                    if (_e925 < arrayLength((&instances.member))) {
                                    } else {
                                        return;
                                    }
                                    let _e932 = instances.member[(0u + _e925)].low_world;
                                    let _e934 = instances.member[(0u + _e925)].high_world;
                                    let _e944 = ((_e932.x - _e105.origin.x) * _e257);
                                    let _e945 = ((_e932.y - _e105.origin.y) * _e269);
                                    let _e946 = ((_e932.z - _e105.origin.z) * _e281);
                                    let _e956 = ((_e934.x - _e105.origin.x) * _e257);
                                    let _e957 = ((_e934.y - _e105.origin.y) * _e269);
                                    let _e958 = ((_e934.z - _e105.origin.z) * _e281);
                                    if (_e944 < _e956) {
                                        phi_1218_ = _e944;
                                    } else {
                                        phi_1218_ = _e956;
                                    }
                                    let _e961 = phi_1218_;
                                    if (_e945 < _e957) {
                                        phi_1223_ = _e945;
                                    } else {
                                        phi_1223_ = _e957;
                                    }
                                    let _e964 = phi_1223_;
                                    if (_e946 < _e958) {
                                        phi_1228_ = _e946;
                                    } else {
                                        phi_1228_ = _e958;
                                    }
                                    let _e967 = phi_1228_;
                                    if (_e944 > _e956) {
                                        phi_1236_ = _e944;
                                    } else {
                                        phi_1236_ = _e956;
                                    }
                                    let _e973 = phi_1236_;
                                    if (_e945 > _e957) {
                                        phi_1241_ = _e945;
                                    } else {
                                        phi_1241_ = _e957;
                                    }
                                    let _e976 = phi_1241_;
                                    if (_e946 > _e958) {
                                        phi_1246_ = _e946;
                                    } else {
                                        phi_1246_ = _e958;
                                    }
                                    let _e979 = phi_1246_;
                                    let _e983 = core_intrinsics_maximum_number_nsz_f32_((_e961 - _e325), (_e964 - _e326));
                                    let _e984 = core_intrinsics_maximum_number_nsz_f32_(_e983, (_e967 - _e327));
                                    let _e985 = core_intrinsics_minimum_number_nsz_f32_((_e973 + _e325), (_e976 + _e326));
                                    let _e986 = core_intrinsics_minimum_number_nsz_f32_(_e985, (_e979 + _e327));
                                    if (_e984 <= _e986) {
                                        if (_e984 <= _e105.tmax) {
                                            if (_e986 >= _e105.tmin) {
                                                let _e998 = instances.member[(0u + _e925)].world_to_object[0u];
                                                let _e1009 = ((((_e998.x * _e105.origin.x) + (_e998.y * _e105.origin.y)) + (_e998.z * _e105.origin.z)) + (_e998.w * 1f));
                                                let _e1011 = instances.member[(0u + _e925)].world_to_object[1u];
                                                let _e1022 = ((((_e1011.x * _e105.origin.x) + (_e1011.y * _e105.origin.y)) + (_e1011.z * _e105.origin.z)) + (_e1011.w * 1f));
                                                let _e1024 = instances.member[(0u + _e925)].world_to_object[2u];
                                                let _e1035 = ((((_e1024.x * _e105.origin.x) + (_e1024.y * _e105.origin.y)) + (_e1024.z * _e105.origin.z)) + (_e1024.w * 1f));
                                                let _e1042 = instances.member[(0u + _e925)].world_to_object[0u];
                                                let _e1053 = ((((_e1042.x * _e105.direction.x) + (_e1042.y * _e105.direction.y)) + (_e1042.z * _e105.direction.z)) + (_e1042.w * 0f));
                                                let _e1055 = instances.member[(0u + _e925)].world_to_object[1u];
                                                let _e1066 = ((((_e1055.x * _e105.direction.x) + (_e1055.y * _e105.direction.y)) + (_e1055.z * _e105.direction.z)) + (_e1055.w * 0f));
                                                let _e1068 = instances.member[(0u + _e925)].world_to_object[2u];
                                                let _e1079 = ((((_e1068.x * _e105.direction.x) + (_e1068.y * _e105.direction.y)) + (_e1068.z * _e105.direction.z)) + (_e1068.w * 0f));
                                                let _e1084 = instances.member[(0u + _e925)].root;
                                                let _e1086 = instances.member[(0u + _e925)].first_triangle;
                                                let _e1090 = abs(_e1053);
                                                let _e1091 = abs(_e1066);
                                                let _e1092 = abs(_e1079);
                                                if (abs(_e1009) < 1000000000000000f) {
                                                    if (abs(_e1022) < 1000000000000000f) {
                                                        if (abs(_e1035) < 1000000000000000f) {
                                                            if (_e1090 < 1000000000000000f) {
                                                                if (_e1091 < 1000000000000000f) {
                                                                    if (_e1092 < 1000000000000000f) {
                                                                        if (_e1090 > 0f) {
                                                                            phi_1403_ = bool();
                                                                            phi_1404_ = true;
                                                                        } else {
                                                                            let _e1100 = (_e1091 > 0f);
                                                                            if _e1100 {
                                                                                phi_1402_ = bool();
                                                                            } else {
                                                                                phi_1402_ = (_e1092 > 0f);
                                                                            }
                                                                            let _e1103 = phi_1402_;
                                                                            phi_1403_ = _e1103;
                                                                            phi_1404_ = _e1100;
                                                                        }
                                                                        let _e1105 = phi_1403_;
                                                                        let _e1107 = phi_1404_;
                                                                        if _e1107 {
                                                                            phi_1408_ = true;
                                                                        } else {
                                                                            phi_1408_ = _e1105;
                                                                        }
                                                                        let _e1109 = phi_1408_;
                                                                        phi_1409_ = _e1109;
                                                                        phi_1410_ = false;
                                                                    } else {
                                                                        phi_1409_ = bool();
                                                                        phi_1410_ = true;
                                                                    }
                                                                    let _e1111 = phi_1409_;
                                                                    let _e1113 = phi_1410_;
                                                                    phi_1411_ = _e1111;
                                                                    phi_1412_ = false;
                                                                    phi_1413_ = _e1113;
                                                                } else {
                                                                    phi_1411_ = bool();
                                                                    phi_1412_ = true;
                                                                    phi_1413_ = false;
                                                                }
                                                                let _e1115 = phi_1411_;
                                                                let _e1117 = phi_1412_;
                                                                let _e1119 = phi_1413_;
                                                                phi_1414_ = _e1115;
                                                                phi_1415_ = _e1117;
                                                                phi_1416_ = _e1119;
                                                            } else {
                                                                phi_1414_ = bool();
                                                                phi_1415_ = true;
                                                                phi_1416_ = false;
                                                            }
                                                            let _e1121 = phi_1414_;
                                                            let _e1123 = phi_1415_;
                                                            let _e1125 = phi_1416_;
                                                            phi_1417_ = _e1121;
                                                            phi_1418_ = _e1123;
                                                            phi_1419_ = _e1125;
                                                        } else {
                                                            phi_1417_ = bool();
                                                            phi_1418_ = true;
                                                            phi_1419_ = false;
                                                        }
                                                        let _e1127 = phi_1417_;
                                                        let _e1129 = phi_1418_;
                                                        let _e1131 = phi_1419_;
                                                        phi_1420_ = _e1127;
                                                        phi_1421_ = _e1129;
                                                        phi_1422_ = _e1131;
                                                    } else {
                                                        phi_1420_ = bool();
                                                        phi_1421_ = true;
                                                        phi_1422_ = false;
                                                    }
                                                    let _e1133 = phi_1420_;
                                                    let _e1135 = phi_1421_;
                                                    let _e1137 = phi_1422_;
                                                    phi_1423_ = _e1133;
                                                    phi_1424_ = _e1135;
                                                    phi_1425_ = _e1137;
                                                } else {
                                                    phi_1423_ = bool();
                                                    phi_1424_ = true;
                                                    phi_1425_ = false;
                                                }
                                                let _e1139 = phi_1423_;
                                                let _e1141 = phi_1424_;
                                                let _e1143 = phi_1425_;
                                                if _e1141 {
                                                    phi_1429_ = true;
                                                } else {
                                                    phi_1429_ = _e1143;
                                                }
                                                let _e1145 = phi_1429_;
                                                if _e1145 {
                                                    phi_1433_ = false;
                                                } else {
                                                    phi_1433_ = _e1139;
                                                }
                                                let _e1147 = phi_1433_;
                                                if _e1147 {
                                                    let _e1148 = (_e1084 >= _e64);
                                                    if _e1148 {
                                                        phi_2706_ = bool();
                                                    } else {
                                                        if (_e1084 < _e64) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1154 = nodes.member[(0u + _e1084)].frame[0u];
                                                        let _e1158 = nodes.member[(0u + _e1084)].frame[1u];
                                                        let _e1162 = nodes.member[(0u + _e1084)].frame[2u];
                                                        let _e1166 = nodes.member[(0u + _e1084)].frame[0u];
                                                        let _e1170 = nodes.member[(0u + _e1084)].frame[1u];
                                                        let _e1174 = nodes.member[(0u + _e1084)].frame[2u];
                                                        let _e1178 = nodes.member[(0u + _e1084)].frame[3u];
                                                        let _e1212 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1053), abs(_e1066));
                                                        let _e1213 = core_intrinsics_maximum_number_nsz_f32_(_e1212, abs(_e1079));
                                                        let _e1214 = (_e1213 * 0.0000000000009094947f);
                                                        if (abs(_e1053) < _e1214) {
                                                            phi_1503_ = _e1214;
                                                        } else {
                                                            phi_1503_ = abs(_e1053);
                                                        }
                                                        let _e1219 = phi_1503_;
                                                        if (_e1053 < 0f) {
                                                            phi_1510_ = (-1f / _e1219);
                                                        } else {
                                                            phi_1510_ = (1f / _e1219);
                                                        }
                                                        let _e1224 = phi_1510_;
                                                        if (abs(_e1066) < _e1214) {
                                                            phi_1517_ = _e1214;
                                                        } else {
                                                            phi_1517_ = abs(_e1066);
                                                        }
                                                        let _e1229 = phi_1517_;
                                                        if (_e1066 < 0f) {
                                                            phi_1524_ = (-1f / _e1229);
                                                        } else {
                                                            phi_1524_ = (1f / _e1229);
                                                        }
                                                        let _e1234 = phi_1524_;
                                                        if (abs(_e1079) < _e1214) {
                                                            phi_1531_ = _e1214;
                                                        } else {
                                                            phi_1531_ = abs(_e1079);
                                                        }
                                                        let _e1239 = phi_1531_;
                                                        if (_e1079 < 0f) {
                                                            phi_1538_ = (-1f / _e1239);
                                                        } else {
                                                            phi_1538_ = (1f / _e1239);
                                                        }
                                                        let _e1244 = phi_1538_;
                                                        let _e1248 = abs((bitcast<f32>(_e1154) - _e1009));
                                                        let _e1249 = abs((bitcast<f32>(_e1158) - _e1022));
                                                        let _e1250 = abs((bitcast<f32>(_e1162) - _e1035));
                                                        let _e1254 = abs(((bitcast<f32>(_e1166) + (bitcast<f32>((((_e1178 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1009));
                                                        let _e1255 = abs(((bitcast<f32>(_e1170) + (bitcast<f32>((((_e1178 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1022));
                                                        let _e1256 = abs(((bitcast<f32>(_e1174) + (bitcast<f32>((((_e1178 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1035));
                                                        if (_e1248 > _e1254) {
                                                            phi_1555_ = _e1248;
                                                        } else {
                                                            phi_1555_ = _e1254;
                                                        }
                                                        let _e1259 = phi_1555_;
                                                        if (_e1249 > _e1255) {
                                                            phi_1560_ = _e1249;
                                                        } else {
                                                            phi_1560_ = _e1255;
                                                        }
                                                        let _e1262 = phi_1560_;
                                                        if (_e1250 > _e1256) {
                                                            phi_1565_ = _e1250;
                                                        } else {
                                                            phi_1565_ = _e1256;
                                                        }
                                                        let _e1265 = phi_1565_;
                                                        let _e1266 = core_intrinsics_maximum_number_nsz_f32_(_e1259, _e1262);
                                                        let _e1267 = core_intrinsics_maximum_number_nsz_f32_(_e1266, _e1265);
                                                        let _e1271 = (_e1267 * 0.0000019073486f);
                                                        let _e1272 = (abs(_e1224) * _e1271);
                                                        let _e1273 = (abs(_e1234) * _e1271);
                                                        let _e1274 = (abs(_e1244) * _e1271);
                                                        let _e1278 = (_e1267 * 0.0000009536743f);
                                                        let _e1279 = (abs(_e1224) * _e1278);
                                                        let _e1280 = (abs(_e1234) * _e1278);
                                                        let _e1281 = (abs(_e1244) * _e1278);
                                                        let _e1282 = abs(_e1053);
                                                        let _e1283 = abs(_e1066);
                                                        let _e1284 = abs(_e1079);
                                                        if (_e1282 >= _e1283) {
                                                            if (_e1282 >= _e1284) {
                                                                phi_1593_ = false;
                                                            } else {
                                                                phi_1593_ = true;
                                                            }
                                                            let _e1288 = phi_1593_;
                                                            phi_1594_ = _e1288;
                                                        } else {
                                                            phi_1594_ = true;
                                                        }
                                                        let _e1290 = phi_1594_;
                                                        if _e1290 {
                                                            if (_e1283 >= _e1284) {
                                                                phi_1602_ = 1u;
                                                            } else {
                                                                phi_1602_ = 2u;
                                                            }
                                                            let _e1293 = phi_1602_;
                                                            phi_1603_ = _e1293;
                                                        } else {
                                                            phi_1603_ = 0u;
                                                        }
                                                        let _e1295 = phi_1603_;
                                                        if (_e1295 == 0u) {
                                                            phi_1615_ = vec3<f32>(_e1066, _e1079, _e1053);
                                                        } else {
                                                            if (_e1295 == 1u) {
                                                                phi_1614_ = vec3<f32>(_e1079, _e1053, _e1066);
                                                            } else {
                                                                phi_1614_ = vec3<f32>(_e1053, _e1066, _e1079);
                                                            }
                                                            let _e1301 = phi_1614_;
                                                            phi_1615_ = _e1301;
                                                        }
                                                        let _e1303 = phi_1615_;
                                                        let _e1306 = (_e1303.x / _e1303.z);
                                                        let _e1309 = (_e1303.y / _e1303.z);
                                                        let _e1311 = (1f / _e1303.z);
                                                        if (_e1224 < 0f) {
                                                            phi_1628_ = 0u;
                                                        } else {
                                                            phi_1628_ = 1u;
                                                        }
                                                        let _e1314 = phi_1628_;
                                                        if (_e1234 < 0f) {
                                                            phi_1633_ = 0u;
                                                        } else {
                                                            phi_1633_ = 2u;
                                                        }
                                                        let _e1317 = phi_1633_;
                                                        if (_e1244 < 0f) {
                                                            phi_1638_ = 0u;
                                                        } else {
                                                            phi_1638_ = 4u;
                                                        }
                                                        let _e1320 = phi_1638_;
                                                        let _e1322 = ((_e1314 | _e1317) | _e1320);
                                                        let _e1323 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1084, 2147483648u);
                                                        local = lt_bvh_traverse_Stack(array<u32, 32>(_e1323.first[0], _e1323.first[1], _e1323.first[2], _e1323.first[3], _e1323.first[4], _e1323.first[5], _e1323.first[6], _e1323.first[7], _e1323.first[8], _e1323.first[9], _e1323.first[10], _e1323.first[11], _e1323.first[12], _e1323.first[13], _e1323.first[14], _e1323.first[15], _e1323.first[16], _e1323.first[17], _e1323.first[18], _e1323.first[19], _e1323.first[20], _e1323.first[21], _e1323.first[22], _e1323.first[23], _e1323.first[24], _e1323.first[25], _e1323.first[26], _e1323.first[27], _e1323.first[28], _e1323.first[29], _e1323.first[30], _e1323.first[31]), array<u32, 32>(_e1323.mask[0], _e1323.mask[1], _e1323.mask[2], _e1323.mask[3], _e1323.mask[4], _e1323.mask[5], _e1323.mask[6], _e1323.mask[7], _e1323.mask[8], _e1323.mask[9], _e1323.mask[10], _e1323.mask[11], _e1323.mask[12], _e1323.mask[13], _e1323.mask[14], _e1323.mask[15], _e1323.mask[16], _e1323.mask[17], _e1323.mask[18], _e1323.mask[19], _e1323.mask[20], _e1323.mask[21], _e1323.mask[22], _e1323.mask[23], _e1323.mask[24], _e1323.mask[25], _e1323.mask[26], _e1323.mask[27], _e1323.mask[28], _e1323.mask[29], _e1323.mask[30], _e1323.mask[31]), _e1323.len, _e1323.group, _e1323.group_mask);
                                                        let _e1397 = local.group_mask;
                                                        if ((_e1397 & 4278190080u) == 0u) {
                                                            let _e1401 = local.len;
                                                            if (_e1401 == 0u) {
                                                                phi_1752_ = false;
                                                            } else {
                                                                let _e1405 = local.len;
                                                                local.len = (_e1405 - 1u);
                                                                let _e1408 = local.len;
                                                                if (_e1408 < 32u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1413 = local.first[(0u + _e1408)];
                                                                local.group = _e1413;
                                                                let _e1416 = local.len;
                                                                if (_e1416 < 32u) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1421 = local.mask[(0u + _e1416)];
                                                                local.group_mask = _e1421;
                                                                phi_1752_ = true;
                                                            }
                                                            let _e1424 = phi_1752_;
                                                            phi_1753_ = _e1424;
                                                        } else {
                                                            phi_1753_ = true;
                                                        }
                                                        let _e1426 = phi_1753_;
                                                        if _e1426 {
                                                            let _e1428 = local.group_mask;
                                                            let _e1434 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1428)), 32u, (_e1428 == 0u)));
                                                            let _e1438 = local.group_mask;
                                                            let _e1452 = local.group_mask;
                                                            local.group_mask = (_e1452 & ~((1u << bitcast<u32>((_e1434 & 31u)))));
                                                            let _e1455 = local.group;
                                                            phi_1784_ = (_e1455 + countOneBits(((_e1438 & ~((4294967295u << bitcast<u32>((((_e1434 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                        } else {
                                                            phi_1784_ = 4294967295u;
                                                        }
                                                        let _e1458 = phi_1784_;
                                                        phi_1786_ = _e1458;
                                                        loop {
                                                            let _e1460 = phi_1786_;
                                                            if (_e1460 != 4294967295u) {
                                                                if (_e1460 < _e64) {
                                                                } else {
                                                                    return;
                                                                }
                                                                let _e1467 = nodes.member[(0u + _e1460)].frame[3u];
                                                                let _e1492 = (bitcast<f32>((((_e1467 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1224);
                                                                let _e1493 = (bitcast<f32>((((_e1467 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1234);
                                                                let _e1494 = (bitcast<f32>((((_e1467 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1244);
                                                                let _e1497 = nodes.member[(0u + _e1460)].frame[0u];
                                                                let _e1501 = nodes.member[(0u + _e1460)].frame[1u];
                                                                let _e1505 = nodes.member[(0u + _e1460)].frame[2u];
                                                                let _e1510 = ((bitcast<f32>(_e1497) - _e1009) * _e1224);
                                                                let _e1511 = ((bitcast<f32>(_e1501) - _e1022) * _e1234);
                                                                let _e1512 = ((bitcast<f32>(_e1505) - _e1035) * _e1244);
                                                                let _e1520 = nodes.member[(0u + _e1460)].x;
                                                                if (_e1224 < 0f) {
                                                                    let _e1531 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1520.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1537 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1531.unnamed.root, _e1520.w), _e1531.unnamed_1);
                                                                    let _e1543 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1537.unnamed, lt_bvh_traverse_Tree(_e1520.x, _e1537.unnamed_1.first_primitive));
                                                                    phi_1867_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1543.unnamed, lt_bvh_traverse_Tree(_e1543.unnamed_1.root, _e1520.y));
                                                                } else {
                                                                    let _e1559 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1520.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1565 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1559.unnamed.root, _e1520.y), _e1559.unnamed_1);
                                                                    let _e1571 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1565.unnamed, lt_bvh_traverse_Tree(_e1520.z, _e1565.unnamed_1.first_primitive));
                                                                    phi_1867_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1571.unnamed, lt_bvh_traverse_Tree(_e1571.unnamed_1.root, _e1520.w));
                                                                }
                                                                let _e1579 = phi_1867_;
                                                                let _e1589 = nodes.member[(0u + _e1460)].y;
                                                                if (_e1234 < 0f) {
                                                                    let _e1600 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1589.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1606 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1600.unnamed.root, _e1589.w), _e1600.unnamed_1);
                                                                    let _e1612 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1606.unnamed, lt_bvh_traverse_Tree(_e1589.x, _e1606.unnamed_1.first_primitive));
                                                                    phi_1894_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1612.unnamed, lt_bvh_traverse_Tree(_e1612.unnamed_1.root, _e1589.y));
                                                                } else {
                                                                    let _e1628 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1589.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1634 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1628.unnamed.root, _e1589.y), _e1628.unnamed_1);
                                                                    let _e1640 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1634.unnamed, lt_bvh_traverse_Tree(_e1589.z, _e1634.unnamed_1.first_primitive));
                                                                    phi_1894_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1640.unnamed, lt_bvh_traverse_Tree(_e1640.unnamed_1.root, _e1589.w));
                                                                }
                                                                let _e1648 = phi_1894_;
                                                                let _e1658 = nodes.member[(0u + _e1460)].z;
                                                                if (_e1244 < 0f) {
                                                                    let _e1669 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1658.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1675 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1669.unnamed.root, _e1658.w), _e1669.unnamed_1);
                                                                    let _e1681 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1675.unnamed, lt_bvh_traverse_Tree(_e1658.x, _e1675.unnamed_1.first_primitive));
                                                                    phi_1921_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1681.unnamed, lt_bvh_traverse_Tree(_e1681.unnamed_1.root, _e1658.y));
                                                                } else {
                                                                    let _e1697 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1658.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                    let _e1703 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1697.unnamed.root, _e1658.y), _e1697.unnamed_1);
                                                                    let _e1709 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1703.unnamed, lt_bvh_traverse_Tree(_e1658.z, _e1703.unnamed_1.first_primitive));
                                                                    phi_1921_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1709.unnamed, lt_bvh_traverse_Tree(_e1709.unnamed_1.root, _e1658.w));
                                                                }
                                                                let _e1717 = phi_1921_;
                                                                phi_1927_ = 0u;
                                                                phi_1930_ = 0u;
                                                                loop {
                                                                    let _e1727 = phi_1927_;
                                                                    let _e1729 = phi_1930_;
                                                                    local_6 = _e1729;
                                                                    local_7 = _e1729;
                                                                    local_8 = _e1729;
                                                                    let _e1730 = (_e1727 < 8u);
                                                                    if _e1730 {
                                                                        let _e1732 = (_e1727 >> bitcast<u32>(2i));
                                                                        let _e1733 = (_e1727 & 3u);
                                                                        if (_e1732 == 0u) {
                                                                            phi_1944_ = _e1579.unnamed.root;
                                                                        } else {
                                                                            phi_1944_ = _e1579.unnamed.first_primitive;
                                                                        }
                                                                        let _e1736 = phi_1944_;
                                                                        if (_e1732 == 0u) {
                                                                            phi_1954_ = _e1648.unnamed.root;
                                                                        } else {
                                                                            phi_1954_ = _e1648.unnamed.first_primitive;
                                                                        }
                                                                        let _e1745 = phi_1954_;
                                                                        if (_e1732 == 0u) {
                                                                            phi_1964_ = _e1717.unnamed.root;
                                                                        } else {
                                                                            phi_1964_ = _e1717.unnamed.first_primitive;
                                                                        }
                                                                        let _e1754 = phi_1964_;
                                                                        let _e1767 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1736 >> bitcast<u32>(((_e1733 * 8u) & 31u))) & 255u)) * _e1492) + (_e1510 - _e1272)), ((f32(((_e1745 >> bitcast<u32>(((_e1733 * 8u) & 31u))) & 255u)) * _e1493) + (_e1511 - _e1273)));
                                                                        let _e1768 = core_intrinsics_maximum_number_nsz_f32_(_e1767, ((f32(((_e1754 >> bitcast<u32>(((_e1733 * 8u) & 31u))) & 255u)) * _e1494) + (_e1512 - _e1274)));
                                                                        if (_e1732 == 0u) {
                                                                            phi_1982_ = _e1579.unnamed_1.root;
                                                                        } else {
                                                                            phi_1982_ = _e1579.unnamed_1.first_primitive;
                                                                        }
                                                                        let _e1771 = phi_1982_;
                                                                        if (_e1732 == 0u) {
                                                                            phi_1992_ = _e1648.unnamed_1.root;
                                                                        } else {
                                                                            phi_1992_ = _e1648.unnamed_1.first_primitive;
                                                                        }
                                                                        let _e1780 = phi_1992_;
                                                                        if (_e1732 == 0u) {
                                                                            phi_2002_ = _e1717.unnamed_1.root;
                                                                        } else {
                                                                            phi_2002_ = _e1717.unnamed_1.first_primitive;
                                                                        }
                                                                        let _e1789 = phi_2002_;
                                                                        let _e1802 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1771 >> bitcast<u32>(((_e1733 * 8u) & 31u))) & 255u)) * _e1492) + (_e1510 + _e1272)), ((f32(((_e1780 >> bitcast<u32>(((_e1733 * 8u) & 31u))) & 255u)) * _e1493) + (_e1511 + _e1273)));
                                                                        let _e1803 = core_intrinsics_minimum_number_nsz_f32_(_e1802, ((f32(((_e1789 >> bitcast<u32>(((_e1733 * 8u) & 31u))) & 255u)) * _e1494) + (_e1512 + _e1274)));
                                                                        if (_e1768 <= _e1803) {
                                                                            if (_e1768 <= _e105.tmax) {
                                                                                if (_e1803 >= _e105.tmin) {
                                                                                    if (_e1732 == 0u) {
                                                                                        let _e1810 = nodes.member[(0u + _e1460)].links[2u];
                                                                                        phi_2038_ = _e1810;
                                                                                    } else {
                                                                                        let _e1813 = nodes.member[(0u + _e1460)].links[3u];
                                                                                        phi_2038_ = _e1813;
                                                                                    }
                                                                                    let _e1815 = phi_2038_;
                                                                                    let _e1820 = ((_e1815 >> bitcast<u32>(((_e1733 * 8u) & 31u))) & 255u);
                                                                                    let _e1821 = (_e1820 & 31u);
                                                                                    if (_e1821 >= 24u) {
                                                                                        phi_2051_ = (24u + ((_e1821 - 24u) ^ _e1322));
                                                                                    } else {
                                                                                        phi_2051_ = _e1821;
                                                                                    }
                                                                                    let _e1827 = phi_2051_;
                                                                                    phi_2056_ = (_e1729 | ((_e1820 >> bitcast<u32>(5i)) << bitcast<u32>((_e1827 & 31u))));
                                                                                } else {
                                                                                    phi_2056_ = _e1729;
                                                                                }
                                                                                let _e1835 = phi_2056_;
                                                                                phi_2057_ = _e1835;
                                                                            } else {
                                                                                phi_2057_ = _e1729;
                                                                            }
                                                                            let _e1837 = phi_2057_;
                                                                            phi_2058_ = _e1837;
                                                                        } else {
                                                                            phi_2058_ = _e1729;
                                                                        }
                                                                        let _e1839 = phi_2058_;
                                                                        phi_1928_ = (_e1727 + 1u);
                                                                        phi_1931_ = _e1839;
                                                                    } else {
                                                                        phi_1928_ = u32();
                                                                        phi_1931_ = u32();
                                                                    }
                                                                    let _e1842 = phi_1928_;
                                                                    let _e1844 = phi_1931_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_1927_ = _e1842;
                                                                        phi_1930_ = _e1844;
                                                                        break if !(_e1730);
                                                                    }
                                                                }
                                                                let _e1848 = nodes.member[(0u + _e1460)].links[0u];
                                                                let _e1852 = nodes.member[(0u + _e1460)].frame[3u];
                                                                let _e1856 = local_6;
                                                                if ((_e1856 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1860 = local.group_mask;
                                                                    if ((_e1860 & 4278190080u) == 0u) {
                                                                    } else {
                                                                        let _e1864 = local.len;
                                                                        if (_e1864 < 32u) {
                                                                            let _e1867 = local.group;
                                                                            let _e1869 = local.len;
                                                                            if (_e1869 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            local.first[(0u + _e1869)] = _e1867;
                                                                            let _e1875 = local.group_mask;
                                                                            let _e1877 = local.len;
                                                                            if (_e1877 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            local.mask[(0u + _e1877)] = _e1875;
                                                                            let _e1884 = local.len;
                                                                            local.len = (_e1884 + 1u);
                                                                        }
                                                                    }
                                                                    local.group = (_e1084 + _e1848);
                                                                    let _e1888 = local_7;
                                                                    local.group_mask = ((_e1888 & 4278190080u) | (_e1852 >> bitcast<u32>(24i)));
                                                                }
                                                                let _e1893 = local_8;
                                                                phi_2116_ = (_e1893 & 16777215u);
                                                                loop {
                                                                    let _e1896 = phi_2116_;
                                                                    let _e1897 = (_e1896 == 0u);
                                                                    local_9 = _e1897;
                                                                    local_15 = _e1897;
                                                                    if _e1897 {
                                                                        phi_2117_ = u32();
                                                                        phi_2609_ = false;
                                                                        phi_2610_ = false;
                                                                        phi_2611_ = false;
                                                                    } else {
                                                                        let _e1900 = nodes.member[(0u + _e1460)].links[1u];
                                                                        let _e1905 = ((_e1086 + _e1900) + select(firstTrailingBit(_e1896), 32u, (_e1896 == 0u)));
                                                                        if (_e1905 < arrayLength((&triangles.member))) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e1912 = triangles.member[(0u + _e1905)].v0_;
                                                                        let _e1914 = (_e1912.x - _e1009);
                                                                        let _e1916 = (_e1912.y - _e1022);
                                                                        let _e1918 = (_e1912.z - _e1035);
                                                                        if (_e1295 == 0u) {
                                                                            phi_2162_ = vec3<f32>(_e1916, _e1918, _e1914);
                                                                        } else {
                                                                            if (_e1295 == 1u) {
                                                                                phi_2161_ = vec3<f32>(_e1918, _e1914, _e1916);
                                                                            } else {
                                                                                phi_2161_ = (_e1912 - vec3<f32>(_e1009, _e1022, _e1035));
                                                                            }
                                                                            let _e1926 = phi_2161_;
                                                                            phi_2162_ = _e1926;
                                                                        }
                                                                        let _e1928 = phi_2162_;
                                                                        let _e1932 = (_e1928.x - (_e1306 * _e1928.z));
                                                                        let _e1936 = (_e1928.y - (_e1309 * _e1928.z));
                                                                        let _e1940 = triangles.member[(0u + _e1905)].v1_;
                                                                        let _e1942 = (_e1940.x - _e1009);
                                                                        let _e1944 = (_e1940.y - _e1022);
                                                                        let _e1946 = (_e1940.z - _e1035);
                                                                        if (_e1295 == 0u) {
                                                                            phi_2194_ = vec3<f32>(_e1944, _e1946, _e1942);
                                                                        } else {
                                                                            if (_e1295 == 1u) {
                                                                                phi_2193_ = vec3<f32>(_e1946, _e1942, _e1944);
                                                                            } else {
                                                                                phi_2193_ = (_e1940 - vec3<f32>(_e1009, _e1022, _e1035));
                                                                            }
                                                                            let _e1954 = phi_2193_;
                                                                            phi_2194_ = _e1954;
                                                                        }
                                                                        let _e1956 = phi_2194_;
                                                                        let _e1960 = (_e1956.x - (_e1306 * _e1956.z));
                                                                        let _e1964 = (_e1956.y - (_e1309 * _e1956.z));
                                                                        let _e1968 = triangles.member[(0u + _e1905)].v2_;
                                                                        let _e1970 = (_e1968.x - _e1009);
                                                                        let _e1972 = (_e1968.y - _e1022);
                                                                        let _e1974 = (_e1968.z - _e1035);
                                                                        if (_e1295 == 0u) {
                                                                            phi_2226_ = vec3<f32>(_e1972, _e1974, _e1970);
                                                                        } else {
                                                                            if (_e1295 == 1u) {
                                                                                phi_2225_ = vec3<f32>(_e1974, _e1970, _e1972);
                                                                            } else {
                                                                                phi_2225_ = (_e1968 - vec3<f32>(_e1009, _e1022, _e1035));
                                                                            }
                                                                            let _e1982 = phi_2225_;
                                                                            phi_2226_ = _e1982;
                                                                        }
                                                                        let _e1984 = phi_2226_;
                                                                        let _e1988 = (_e1984.x - (_e1306 * _e1984.z));
                                                                        let _e1992 = (_e1984.y - (_e1309 * _e1984.z));
                                                                        if (_e1960 < _e1988) {
                                                                            phi_2247_ = true;
                                                                        } else {
                                                                            if (_e1960 == _e1988) {
                                                                                phi_2246_ = (_e1964 < _e1992);
                                                                            } else {
                                                                                phi_2246_ = false;
                                                                            }
                                                                            let _e1999 = phi_2246_;
                                                                            phi_2247_ = _e1999;
                                                                        }
                                                                        let _e2001 = phi_2247_;
                                                                        if _e2001 {
                                                                            phi_2251_ = _e1992;
                                                                            phi_2252_ = _e1988;
                                                                            phi_2253_ = _e1964;
                                                                            phi_2254_ = _e1960;
                                                                        } else {
                                                                            phi_2251_ = _e1964;
                                                                            phi_2252_ = _e1960;
                                                                            phi_2253_ = _e1992;
                                                                            phi_2254_ = _e1988;
                                                                        }
                                                                        let _e2003 = phi_2251_;
                                                                        let _e2005 = phi_2252_;
                                                                        let _e2007 = phi_2253_;
                                                                        let _e2009 = phi_2254_;
                                                                        let _e2012 = ((_e2009 * _e2003) - (_e2007 * _e2005));
                                                                        if _e2001 {
                                                                            phi_2262_ = -(_e2012);
                                                                        } else {
                                                                            phi_2262_ = _e2012;
                                                                        }
                                                                        let _e2015 = phi_2262_;
                                                                        if (_e1988 < _e1932) {
                                                                            phi_2273_ = true;
                                                                        } else {
                                                                            if (_e1988 == _e1932) {
                                                                                phi_2272_ = (_e1992 < _e1936);
                                                                            } else {
                                                                                phi_2272_ = false;
                                                                            }
                                                                            let _e2020 = phi_2272_;
                                                                            phi_2273_ = _e2020;
                                                                        }
                                                                        let _e2022 = phi_2273_;
                                                                        if _e2022 {
                                                                            phi_2277_ = _e1936;
                                                                            phi_2278_ = _e1932;
                                                                            phi_2279_ = _e1992;
                                                                            phi_2280_ = _e1988;
                                                                        } else {
                                                                            phi_2277_ = _e1992;
                                                                            phi_2278_ = _e1988;
                                                                            phi_2279_ = _e1936;
                                                                            phi_2280_ = _e1932;
                                                                        }
                                                                        let _e2024 = phi_2277_;
                                                                        let _e2026 = phi_2278_;
                                                                        let _e2028 = phi_2279_;
                                                                        let _e2030 = phi_2280_;
                                                                        let _e2033 = ((_e2030 * _e2024) - (_e2028 * _e2026));
                                                                        if _e2022 {
                                                                            phi_2288_ = -(_e2033);
                                                                        } else {
                                                                            phi_2288_ = _e2033;
                                                                        }
                                                                        let _e2036 = phi_2288_;
                                                                        if (_e1932 < _e1960) {
                                                                            phi_2299_ = true;
                                                                        } else {
                                                                            if (_e1932 == _e1960) {
                                                                                phi_2298_ = (_e1936 < _e1964);
                                                                            } else {
                                                                                phi_2298_ = false;
                                                                            }
                                                                            let _e2041 = phi_2298_;
                                                                            phi_2299_ = _e2041;
                                                                        }
                                                                        let _e2043 = phi_2299_;
                                                                        if _e2043 {
                                                                            phi_2303_ = _e1964;
                                                                            phi_2304_ = _e1960;
                                                                            phi_2305_ = _e1936;
                                                                            phi_2306_ = _e1932;
                                                                        } else {
                                                                            phi_2303_ = _e1936;
                                                                            phi_2304_ = _e1932;
                                                                            phi_2305_ = _e1964;
                                                                            phi_2306_ = _e1960;
                                                                        }
                                                                        let _e2045 = phi_2303_;
                                                                        let _e2047 = phi_2304_;
                                                                        let _e2049 = phi_2305_;
                                                                        let _e2051 = phi_2306_;
                                                                        let _e2054 = ((_e2051 * _e2045) - (_e2049 * _e2047));
                                                                        if _e2043 {
                                                                            phi_2314_ = -(_e2054);
                                                                        } else {
                                                                            phi_2314_ = _e2054;
                                                                        }
                                                                        let _e2057 = phi_2314_;
                                                                        if (_e2015 >= 0f) {
                                                                            if (_e2036 >= 0f) {
                                                                                if (_e2057 >= 0f) {
                                                                                    phi_2329_ = ((_e2015 + _e2036) + _e2057);
                                                                                    phi_2330_ = false;
                                                                                } else {
                                                                                    phi_2329_ = f32();
                                                                                    phi_2330_ = true;
                                                                                }
                                                                                let _e2064 = phi_2329_;
                                                                                let _e2066 = phi_2330_;
                                                                                phi_2331_ = _e2064;
                                                                                phi_2332_ = _e2066;
                                                                            } else {
                                                                                phi_2331_ = f32();
                                                                                phi_2332_ = true;
                                                                            }
                                                                            let _e2068 = phi_2331_;
                                                                            let _e2070 = phi_2332_;
                                                                            phi_2333_ = _e2068;
                                                                            phi_2334_ = _e2070;
                                                                        } else {
                                                                            phi_2333_ = f32();
                                                                            phi_2334_ = true;
                                                                        }
                                                                        let _e2072 = phi_2333_;
                                                                        let _e2074 = phi_2334_;
                                                                        if _e2074 {
                                                                            if (_e2015 <= 0f) {
                                                                                if (_e2036 <= 0f) {
                                                                                    let _e2077 = (_e2057 <= 0f);
                                                                                    if _e2077 {
                                                                                    }
                                                                                    phi_2352_ = ((_e2015 + _e2036) + _e2057);
                                                                                    phi_2353_ = false;
                                                                                    phi_2354_ = _e2077;
                                                                                } else {
                                                                                    phi_2352_ = f32();
                                                                                    phi_2353_ = true;
                                                                                    phi_2354_ = false;
                                                                                }
                                                                                let _e2081 = phi_2352_;
                                                                                let _e2083 = phi_2353_;
                                                                                let _e2085 = phi_2354_;
                                                                                phi_2355_ = _e2081;
                                                                                phi_2356_ = _e2083;
                                                                                phi_2357_ = _e2085;
                                                                            } else {
                                                                                phi_2355_ = f32();
                                                                                phi_2356_ = true;
                                                                                phi_2357_ = false;
                                                                            }
                                                                            let _e2087 = phi_2355_;
                                                                            let _e2089 = phi_2356_;
                                                                            let _e2091 = phi_2357_;
                                                                            if _e2089 {
                                                                                phi_2361_ = false;
                                                                            } else {
                                                                                phi_2361_ = _e2091;
                                                                            }
                                                                            let _e2093 = phi_2361_;
                                                                            phi_2362_ = _e2087;
                                                                            phi_2363_ = _e2093;
                                                                        } else {
                                                                            phi_2362_ = _e2072;
                                                                            phi_2363_ = true;
                                                                        }
                                                                        let _e2095 = phi_2362_;
                                                                        let _e2097 = phi_2363_;
                                                                        if _e2097 {
                                                                            let _e2098 = (_e2095 == 0f);
                                                                            if _e2098 {
                                                                                phi_2561_ = lt_bvh_triangle_Intersection();
                                                                            } else {
                                                                                let _e2104 = ((((_e2015 * (_e1311 * _e1928.z)) + (_e2036 * (_e1311 * _e1956.z))) + (_e2057 * (_e1311 * _e1984.z))) / _e2095);
                                                                                let _e2106 = triangles.member[(0u + _e1905)].v0_;
                                                                                let _e2108 = triangles.member[(0u + _e1905)].v1_;
                                                                                if (_e2106.x < _e2108.x) {
                                                                                    phi_2389_ = _e2106.x;
                                                                                } else {
                                                                                    phi_2389_ = _e2108.x;
                                                                                }
                                                                                let _e2115 = phi_2389_;
                                                                                if (_e2106.y < _e2108.y) {
                                                                                    phi_2398_ = _e2106.y;
                                                                                } else {
                                                                                    phi_2398_ = _e2108.y;
                                                                                }
                                                                                let _e2122 = phi_2398_;
                                                                                if (_e2106.z < _e2108.z) {
                                                                                    phi_2407_ = _e2106.z;
                                                                                } else {
                                                                                    phi_2407_ = _e2108.z;
                                                                                }
                                                                                let _e2129 = phi_2407_;
                                                                                let _e2131 = triangles.member[(0u + _e1905)].v2_;
                                                                                if (_e2115 < _e2131.x) {
                                                                                    phi_2416_ = _e2115;
                                                                                } else {
                                                                                    phi_2416_ = _e2131.x;
                                                                                }
                                                                                let _e2136 = phi_2416_;
                                                                                if (_e2122 < _e2131.y) {
                                                                                    phi_2423_ = _e2122;
                                                                                } else {
                                                                                    phi_2423_ = _e2131.y;
                                                                                }
                                                                                let _e2141 = phi_2423_;
                                                                                if (_e2129 < _e2131.z) {
                                                                                    phi_2430_ = _e2129;
                                                                                } else {
                                                                                    phi_2430_ = _e2131.z;
                                                                                }
                                                                                let _e2146 = phi_2430_;
                                                                                let _e2148 = triangles.member[(0u + _e1905)].v0_;
                                                                                let _e2150 = triangles.member[(0u + _e1905)].v1_;
                                                                                if (_e2148.x > _e2150.x) {
                                                                                    phi_2443_ = _e2148.x;
                                                                                } else {
                                                                                    phi_2443_ = _e2150.x;
                                                                                }
                                                                                let _e2157 = phi_2443_;
                                                                                if (_e2148.y > _e2150.y) {
                                                                                    phi_2452_ = _e2148.y;
                                                                                } else {
                                                                                    phi_2452_ = _e2150.y;
                                                                                }
                                                                                let _e2164 = phi_2452_;
                                                                                if (_e2148.z > _e2150.z) {
                                                                                    phi_2461_ = _e2148.z;
                                                                                } else {
                                                                                    phi_2461_ = _e2150.z;
                                                                                }
                                                                                let _e2171 = phi_2461_;
                                                                                let _e2173 = triangles.member[(0u + _e1905)].v2_;
                                                                                if (_e2157 > _e2173.x) {
                                                                                    phi_2470_ = _e2157;
                                                                                } else {
                                                                                    phi_2470_ = _e2173.x;
                                                                                }
                                                                                let _e2178 = phi_2470_;
                                                                                if (_e2164 > _e2173.y) {
                                                                                    phi_2477_ = _e2164;
                                                                                } else {
                                                                                    phi_2477_ = _e2173.y;
                                                                                }
                                                                                let _e2183 = phi_2477_;
                                                                                if (_e2171 > _e2173.z) {
                                                                                    phi_2484_ = _e2171;
                                                                                } else {
                                                                                    phi_2484_ = _e2173.z;
                                                                                }
                                                                                let _e2188 = phi_2484_;
                                                                                let _e2192 = ((_e2136 - _e1009) * _e1224);
                                                                                let _e2193 = ((_e2141 - _e1022) * _e1234);
                                                                                let _e2194 = ((_e2146 - _e1035) * _e1244);
                                                                                let _e2198 = ((_e2178 - _e1009) * _e1224);
                                                                                let _e2199 = ((_e2183 - _e1022) * _e1234);
                                                                                let _e2200 = ((_e2188 - _e1035) * _e1244);
                                                                                if (_e2192 < _e2198) {
                                                                                    phi_2501_ = _e2192;
                                                                                } else {
                                                                                    phi_2501_ = _e2198;
                                                                                }
                                                                                let _e2203 = phi_2501_;
                                                                                if (_e2193 < _e2199) {
                                                                                    phi_2506_ = _e2193;
                                                                                } else {
                                                                                    phi_2506_ = _e2199;
                                                                                }
                                                                                let _e2206 = phi_2506_;
                                                                                if (_e2194 < _e2200) {
                                                                                    phi_2511_ = _e2194;
                                                                                } else {
                                                                                    phi_2511_ = _e2200;
                                                                                }
                                                                                let _e2209 = phi_2511_;
                                                                                if (_e2192 > _e2198) {
                                                                                    phi_2519_ = _e2192;
                                                                                } else {
                                                                                    phi_2519_ = _e2198;
                                                                                }
                                                                                let _e2215 = phi_2519_;
                                                                                if (_e2193 > _e2199) {
                                                                                    phi_2524_ = _e2193;
                                                                                } else {
                                                                                    phi_2524_ = _e2199;
                                                                                }
                                                                                let _e2218 = phi_2524_;
                                                                                if (_e2194 > _e2200) {
                                                                                    phi_2529_ = _e2194;
                                                                                } else {
                                                                                    phi_2529_ = _e2200;
                                                                                }
                                                                                let _e2221 = phi_2529_;
                                                                                let _e2225 = core_intrinsics_maximum_number_nsz_f32_((_e2203 - _e1279), (_e2206 - _e1280));
                                                                                let _e2226 = core_intrinsics_maximum_number_nsz_f32_(_e2225, (_e2209 - _e1281));
                                                                                let _e2227 = core_intrinsics_minimum_number_nsz_f32_((_e2215 + _e1279), (_e2218 + _e1280));
                                                                                let _e2228 = core_intrinsics_minimum_number_nsz_f32_(_e2227, (_e2221 + _e1281));
                                                                                if (_e2226 > _e984) {
                                                                                    phi_2541_ = _e2226;
                                                                                } else {
                                                                                    phi_2541_ = _e984;
                                                                                }
                                                                                let _e2231 = phi_2541_;
                                                                                if (_e2228 < _e986) {
                                                                                    phi_2546_ = _e2228;
                                                                                } else {
                                                                                    phi_2546_ = _e986;
                                                                                }
                                                                                let _e2234 = phi_2546_;
                                                                                if (_e2104 < _e2231) {
                                                                                    phi_2551_ = _e2231;
                                                                                } else {
                                                                                    phi_2551_ = _e2104;
                                                                                }
                                                                                let _e2237 = phi_2551_;
                                                                                if (_e2237 > _e2234) {
                                                                                    phi_2556_ = _e2234;
                                                                                } else {
                                                                                    phi_2556_ = _e2237;
                                                                                }
                                                                                let _e2240 = phi_2556_;
                                                                                phi_2561_ = lt_bvh_triangle_Intersection(_e2240, (_e2036 / _e2095), (_e2057 / _e2095), (_e2231 <= _e2234));
                                                                            }
                                                                            let _e2246 = phi_2561_;
                                                                            phi_2562_ = _e2246;
                                                                            phi_2563_ = _e2098;
                                                                        } else {
                                                                            phi_2562_ = lt_bvh_triangle_Intersection();
                                                                            phi_2563_ = true;
                                                                        }
                                                                        let _e2248 = phi_2562_;
                                                                        let _e2250 = phi_2563_;
                                                                        if _e2250 {
                                                                            phi_2567_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                        } else {
                                                                            phi_2567_ = _e2248;
                                                                        }
                                                                        let _e2252 = phi_2567_;
                                                                        if _e2252.is_hit {
                                                                            if (_e2252.t > _e105.tmin) {
                                                                                if (_e2252.t < _e105.tmax) {
                                                                                    let _e2259 = triangles.member[(0u + _e1905)].i0_;
                                                                                    let _e2261 = ((_e2259 & 2147483648u) == 0u);
                                                                                    if _e2261 {
                                                                                        phi_2593_ = false;
                                                                                        phi_2594_ = false;
                                                                                    } else {
                                                                                        if true {
                                                                                            phi_2592_ = false;
                                                                                        } else {
                                                                                            phi_2592_ = true;
                                                                                        }
                                                                                        let _e2263 = phi_2592_;
                                                                                        phi_2593_ = _e2263;
                                                                                        phi_2594_ = true;
                                                                                    }
                                                                                    let _e2265 = phi_2593_;
                                                                                    let _e2267 = phi_2594_;
                                                                                    phi_2595_ = _e2265;
                                                                                    phi_2596_ = _e2261;
                                                                                    phi_2597_ = _e2267;
                                                                                } else {
                                                                                    phi_2595_ = true;
                                                                                    phi_2596_ = false;
                                                                                    phi_2597_ = false;
                                                                                }
                                                                                let _e2269 = phi_2595_;
                                                                                let _e2271 = phi_2596_;
                                                                                let _e2273 = phi_2597_;
                                                                                phi_2598_ = _e2269;
                                                                                phi_2599_ = _e2271;
                                                                                phi_2600_ = _e2273;
                                                                            } else {
                                                                                phi_2598_ = true;
                                                                                phi_2599_ = false;
                                                                                phi_2600_ = false;
                                                                            }
                                                                            let _e2275 = phi_2598_;
                                                                            let _e2277 = phi_2599_;
                                                                            let _e2279 = phi_2600_;
                                                                            phi_2601_ = _e2275;
                                                                            phi_2602_ = _e2277;
                                                                            phi_2603_ = _e2279;
                                                                        } else {
                                                                            phi_2601_ = true;
                                                                            phi_2602_ = false;
                                                                            phi_2603_ = false;
                                                                        }
                                                                        let _e2281 = phi_2601_;
                                                                        let _e2283 = phi_2602_;
                                                                        let _e2285 = phi_2603_;
                                                                        if _e2281 {
                                                                            phi_2607_ = false;
                                                                            phi_2608_ = false;
                                                                        } else {
                                                                            phi_2607_ = _e2283;
                                                                            phi_2608_ = _e2285;
                                                                        }
                                                                        let _e2287 = phi_2607_;
                                                                        let _e2289 = phi_2608_;
                                                                        phi_2117_ = (_e1896 & (_e1896 - 1u));
                                                                        phi_2609_ = _e2281;
                                                                        phi_2610_ = _e2287;
                                                                        phi_2611_ = _e2289;
                                                                    }
                                                                    let _e2291 = phi_2117_;
                                                                    let _e2293 = phi_2609_;
                                                                    let _e2295 = phi_2610_;
                                                                    let _e2297 = phi_2611_;
                                                                    local_13 = _e2295;
                                                                    local_14 = _e2297;
                                                                    continue;
                                                                    continuing {
                                                                        phi_2116_ = _e2291;
                                                                        break if !(_e2293);
                                                                    }
                                                                }
                                                                let _e2300 = local_9;
                                                                if _e2300 {
                                                                    let _e2302 = local.group_mask;
                                                                    if ((_e2302 & 4278190080u) == 0u) {
                                                                        let _e2306 = local.len;
                                                                        if (_e2306 == 0u) {
                                                                            phi_2653_ = false;
                                                                        } else {
                                                                            let _e2310 = local.len;
                                                                            local.len = (_e2310 - 1u);
                                                                            let _e2313 = local.len;
                                                                            if (_e2313 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            let _e2318 = local.first[(0u + _e2313)];
                                                                            local.group = _e2318;
                                                                            let _e2321 = local.len;
                                                                            if (_e2321 < 32u) {
                                                                            } else {
                                                                                return;
                                                                            }
                                                                            let _e2326 = local.mask[(0u + _e2321)];
                                                                            local.group_mask = _e2326;
                                                                            phi_2653_ = true;
                                                                        }
                                                                        let _e2329 = phi_2653_;
                                                                        phi_2654_ = _e2329;
                                                                    } else {
                                                                        phi_2654_ = true;
                                                                    }
                                                                    let _e2331 = phi_2654_;
                                                                    if _e2331 {
                                                                        let _e2333 = local.group_mask;
                                                                        let _e2339 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2333)), 32u, (_e2333 == 0u)));
                                                                        let _e2343 = local.group_mask;
                                                                        let _e2357 = local.group_mask;
                                                                        local.group_mask = (_e2357 & ~((1u << bitcast<u32>((_e2339 & 31u)))));
                                                                        let _e2360 = local.group;
                                                                        phi_2685_ = (_e2360 + countOneBits(((_e2343 & ~((4294967295u << bitcast<u32>((((_e2339 - 24u) ^ _e1322) & 31u))))) & 255u)));
                                                                    } else {
                                                                        phi_2685_ = 4294967295u;
                                                                    }
                                                                    let _e2363 = phi_2685_;
                                                                    phi_2686_ = _e2363;
                                                                    phi_2687_ = false;
                                                                    phi_2688_ = false;
                                                                } else {
                                                                    phi_2686_ = u32();
                                                                    let _e2734 = local_13;
                                                                    phi_2687_ = _e2734;
                                                                    let _e2737 = local_14;
                                                                    phi_2688_ = _e2737;
                                                                }
                                                                let _e2365 = phi_2686_;
                                                                let _e2367 = phi_2687_;
                                                                let _e2369 = phi_2688_;
                                                                phi_1787_ = _e2365;
                                                                let _e2741 = local_15;
                                                                phi_2689_ = _e2741;
                                                                phi_2690_ = false;
                                                                phi_2691_ = _e2367;
                                                                phi_2692_ = _e2369;
                                                            } else {
                                                                phi_1787_ = u32();
                                                                phi_2689_ = false;
                                                                phi_2690_ = true;
                                                                phi_2691_ = false;
                                                                phi_2692_ = false;
                                                            }
                                                            let _e2371 = phi_1787_;
                                                            let _e2373 = phi_2689_;
                                                            let _e2375 = phi_2690_;
                                                            let _e2377 = phi_2691_;
                                                            let _e2379 = phi_2692_;
                                                            local_10 = _e2375;
                                                            local_16 = _e2377;
                                                            local_17 = _e2379;
                                                            continue;
                                                            continuing {
                                                                phi_1786_ = _e2371;
                                                                break if !(_e2373);
                                                            }
                                                        }
                                                        let _e2382 = local_10;
                                                        if _e2382 {
                                                            phi_2696_ = false;
                                                            phi_2697_ = false;
                                                        } else {
                                                            let _e2748 = local_16;
                                                            phi_2696_ = _e2748;
                                                            let _e2751 = local_17;
                                                            phi_2697_ = _e2751;
                                                        }
                                                        let _e2384 = phi_2696_;
                                                        let _e2386 = phi_2697_;
                                                        if _e2384 {
                                                            phi_2701_ = true;
                                                        } else {
                                                            phi_2701_ = _e2386;
                                                        }
                                                        let _e2388 = phi_2701_;
                                                        if _e2388 {
                                                            phi_2705_ = true;
                                                        } else {
                                                            phi_2705_ = false;
                                                        }
                                                        let _e2390 = phi_2705_;
                                                        phi_2706_ = _e2390;
                                                    }
                                                    let _e2392 = phi_2706_;
                                                    phi_2707_ = _e2392;
                                                    phi_2708_ = _e1148;
                                                } else {
                                                    phi_2707_ = bool();
                                                    phi_2708_ = true;
                                                }
                                                let _e2394 = phi_2707_;
                                                let _e2396 = phi_2708_;
                                                if _e2396 {
                                                    phi_2712_ = false;
                                                } else {
                                                    phi_2712_ = _e2394;
                                                }
                                                let _e2398 = phi_2712_;
                                                if _e2398 {
                                                    phi_2716_ = false;
                                                } else {
                                                    phi_2716_ = true;
                                                }
                                                let _e2400 = phi_2716_;
                                                phi_2717_ = _e2400;
                                            } else {
                                                phi_2717_ = true;
                                            }
                                            let _e2402 = phi_2717_;
                                            phi_2718_ = _e2402;
                                        } else {
                                            phi_2718_ = true;
                                        }
                                        let _e2404 = phi_2718_;
                                        phi_2719_ = _e2404;
                                    } else {
                                        phi_2719_ = true;
                                    }
                                    let _e2406 = phi_2719_;
                                    if _e2406 {
                                    }
                                    phi_1163_ = (_e917 & (_e917 - 1u));
                                    phi_2723_ = _e2406;
                                }
                                let _e2408 = phi_1163_;
                                let _e2410 = phi_2723_;
                                continue;
                                continuing {
                                    phi_1162_ = _e2408;
                                    break if !(_e2410);
                                }
                            }
                            let _e2413 = local_11;
                            if _e2413 {
                                let _e2415 = local_1.group_mask;
                                if ((_e2415 & 4278190080u) == 0u) {
                                    let _e2419 = local_1.len;
                                    if (_e2419 == 0u) {
                                        phi_2765_ = false;
                                    } else {
                                        let _e2423 = local_1.len;
                                        local_1.len = (_e2423 - 1u);
                                        let _e2426 = local_1.len;
                                        if (_e2426 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2431 = local_1.first[(0u + _e2426)];
                                        local_1.group = _e2431;
                                        let _e2434 = local_1.len;
                                        if (_e2434 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e2439 = local_1.mask[(0u + _e2434)];
                                        local_1.group_mask = _e2439;
                                        phi_2765_ = true;
                                    }
                                    let _e2442 = phi_2765_;
                                    phi_2766_ = _e2442;
                                } else {
                                    phi_2766_ = true;
                                }
                                let _e2444 = phi_2766_;
                                if _e2444 {
                                    let _e2446 = local_1.group_mask;
                                    let _e2452 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2446)), 32u, (_e2446 == 0u)));
                                    let _e2456 = local_1.group_mask;
                                    let _e2470 = local_1.group_mask;
                                    local_1.group_mask = (_e2470 & ~((1u << bitcast<u32>((_e2452 & 31u)))));
                                    let _e2473 = local_1.group;
                                    phi_2797_ = (_e2473 + countOneBits(((_e2456 & ~((4294967295u << bitcast<u32>((((_e2452 - 24u) ^ _e338) & 31u))))) & 255u)));
                                } else {
                                    phi_2797_ = 4294967295u;
                                }
                                let _e2476 = phi_2797_;
                                phi_2798_ = _e2476;
                            } else {
                                phi_2798_ = u32();
                            }
                            let _e2478 = phi_2798_;
                            phi_828_ = _e2478;
                            let _e2772 = local_18;
                            phi_2799_ = _e2772;
                            phi_2800_ = false;
                        } else {
                            phi_828_ = u32();
                            phi_2799_ = false;
                            phi_2800_ = true;
                        }
                        let _e2480 = phi_828_;
                        let _e2482 = phi_2799_;
                        let _e2484 = phi_2800_;
                        local_12 = _e2484;
                        continue;
                        continuing {
                            phi_827_ = _e2480;
                            break if !(_e2482);
                        }
                    }
                    let _e2487 = local_12;
                    if _e2487 {
                        phi_2804_ = false;
                    } else {
                        phi_2804_ = true;
                    }
                    let _e2489 = phi_2804_;
                    if _e2489 {
                        phi_2808_ = true;
                    } else {
                        phi_2808_ = false;
                    }
                    let _e2491 = phi_2808_;
                    phi_2809_ = _e2491;
                }
                let _e2493 = phi_2809_;
                phi_2810_ = _e2493;
                phi_2811_ = _e175;
            } else {
                phi_2810_ = bool();
                phi_2811_ = true;
            }
            let _e2495 = phi_2810_;
            let _e2497 = phi_2811_;
            if _e2497 {
                phi_2815_ = false;
            } else {
                phi_2815_ = _e2495;
            }
            let _e2499 = phi_2815_;
            if _e2499 {
                phi_2819_ = 0f;
            } else {
                phi_2819_ = 1f;
            }
            let _e2501 = phi_2819_;
            phi_2820_ = _e2501;
        }
        let _e2503 = phi_2820_;
        if (_e79.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e79.first_primitive)] = _e2503;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_instanced_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
